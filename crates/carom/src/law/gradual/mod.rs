//! A contact followed impulse by impulse: friction turns with the slip, at two or three places at once.
//!
//! Bodies meet at one place, where the normal impulse P grows from zero, and rub there and on the cloth. The slips and the
//! closing speed are linear in the impulses; what is not is the friction, whose direction is that of the slip:
//!
//! ```text
//! dJ_k/dP = μ_k N_k ŝ_k         while place k slips, with its load N_k per P                   (1)
//! dJ_k/dP = what holds it       while it does not, as far as μ_k N_k suffices                  (2)
//! u = u0 − a P + Σ c_k J_k ,    s_k = s_k0 + d_k P − Σ G_kl J_l                                (3)
//! W = ∫ |u| dP                  up to u = 0 the work W_c of compression, from there e² W_c     (4)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | P | normal impulse | kg m/s |
//! | J_k | friction impulse at place k, along the slip (it acts against it): sideways and forwards | kg m/s |
//! | s_k, ŝ_k | slip at place k and its direction | m/s, – |
//! | N_k | load on place k per P: one where the bodies meet, on the cloth what presses a ball down, none below zero | – |
//! | u | closing speed | m/s |
//! | W | work of the normal impulse | J |
//! | a, c, d, G | response of closing speed and slips to the impulses | 1/kg |
//! | e | restitution: its square is the part of the work given back | – |
//!
//! The steps are those of the classical fourth-order Runge–Kutta method, with (4) as one of its variables. Each gives its
//! mean friction as one impulse, so momentum is kept to round-off, and friction takes energy as long as that mean points
//! along the mean slip. So steps are short where a slip turns or is about to stop. One that is slow enough is stopped by
//! an impulse of its own, and then held. The last step of a phase is as long as it has to be, found by making it again
//! with a better length a fixed number of times: nothing depends on which side of a threshold round-off falls.
//!
//! A ball that friction holds at the nose and on the cloth is wedged: it stops, and its contact ends.
//!
//! Sideways and forwards do not mix in (3), since every contact is its own mirror image but for the motions.

mod march;
mod response;
mod rubbing;

pub(super) use march::follow;
pub(super) use response::{Impulse, Touching};
