//! A cushion that gives way along itself too: springs across and along, and friction in series with the second.
//!
//! The spring across the contact stiffens as it unloads, so that e is the part of the speed, and e² of the work, that it
//! gives back. The spring along it may push the ball back where it came from, which no law of one blow does. Times are in
//! units of 1/ω_n, w = μ |v_n0|; the contact is compressed until τ = π/2 and over at τ = (1 + e) π/2:
//!
//! ```text
//! F_n ∝ sin τ  while compressed, then  cos x  with τ = π/2 + e x                              (1)
//! stuck:  u = u1 cos r(τ − τ1) + (v1/r) sin r(τ − τ1) ,   v = du/dτ                           (2)
//! slips:  u = ± η² w (sin τ or cos x) ,   dv = ∓ β w (sin τ dτ or e cos x dx)                 (3)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | v_n0 | normal velocity before, negative | m/s |
//! | v | velocity of the ball's surface along the contact | m/s |
//! | u | deflection of the spring along the contact, times ω_n | m/s |
//! | ω_n, r | frequency across the contact; that along it over it, from 1 to 2 | 1/s, – |
//! | β, η² | 7/2, the response of a sphere along the contact; β/r² | – |
//! | τ1, u1, v1 | where it sticks | –, m/s, m/s |
//!
//! It sticks at once if `v0 < η² w`. Else it slips first, and sticks where `v = du/dτ` of (3):
//! `cos τ1 = (β w − v0)/(β w − η² w)`, or once unloading `sin x1 = e (v0 − β w)/(e² β w − η² w)`, if that ever is. From
//! there it sticks until the spring pulls harder than friction holds, `|u| = η² w cos x`, and slips to the end.
//!
//! Source: Stronge (2000), chapter 5. *Departs from source*: below e = 1/r what slips while unloading never sticks, and
//! what slips slower than β w before has stuck by then. The formula in use, slip throughout above
//! `w (β (1 + e) − η²/e)`, calls that slip throughout. The vertical part of the blow is left to the cloth.

use super::CushionHit;
use crate::geometry::Vec3;
use crate::law::Reference;
use crate::law::coefficient::{IncidenceFriction, NormalRestitution};
use crate::law::sphere_plane::tangential;
use crate::model::Twist;
use crate::scalar::{Scalar, arccos, other_leg};
use core::f64::consts::FRAC_PI_2;

/// The sources of the law.
pub(super) const REFERENCES: &[Reference] = &[Reference {
    law: "ball_cushion.stronge_compliant",
    text: "W. J. Stronge, Impact Mechanics (Cambridge University Press, 2000), chapter 5",
    doi: Some("10.1017/CBO9780511626432"),
}];

/// β of a uniform sphere.
const BETA: f64 = 3.5;

/// Most steps to the end of sticking: as many as bisection needs for the last bit.
const SEARCH_STEPS: usize = 60;

/// Parameters of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrongeCompliant<S> {
    /// Coefficient of restitution e.
    pub normal: NormalRestitution<S>,
    /// Coefficient of friction μ with the nose.
    pub friction: IncidenceFriction<S>,
    /// Frequency r of the contact along itself over that across, from 1 to 2.
    pub frequency_ratio: S,
}

/// The springs of a contact at its own scales.
struct Springs<S> {
    restitution: S,
    ratio: S,
    /// η².
    compliance: S,
    /// w.
    friction_speed: S,
}

/// A contact that sticks from τ1 on; deflection and velocity over the first velocity.
struct Stuck<S> {
    since: S,
    deflection: S,
    velocity: S,
}

impl<S: Scalar> StrongeCompliant<S> {
    pub(super) fn rebound(&self, hit: &CushionHit<S>, restitution: S) -> Twist<S> {
        let (sphere, normal) = (&hit.sphere, hit.contact_normal());
        let closing_speed = -hit.twist.velocity.dot(normal);
        let friction_speed = hit.friction(&self.friction) * closing_speed;
        let springs = Springs::new(restitution, self.frequency_ratio, friction_speed);
        let slip = tangential(hit.twist.surface_velocity(sphere.radius, -normal), normal);
        // A slip of zero stays zero. Its size has no derivative there, and needs none.
        let slip_speed = if slip == Vec3::ZERO { S::ZERO } else { slip.norm() };
        let slip_lost = slip * (S::ONE - springs.slip_kept(slip_speed));
        let pushed = normal * ((S::ONE + restitution) * closing_speed) - slip_lost * S::from_f64(1.0 / BETA);
        let after = hit.twist.after_impulse(sphere, -normal, pushed * sphere.mass);
        Twist { velocity: Vec3::above(after.velocity.plan(), S::ZERO), ..after }
    }
}

impl<S: Scalar> Springs<S> {
    fn new(restitution: S, ratio: S, friction_speed: S) -> Self {
        let compliance = S::from_f64(BETA) / ratio.squared();
        Self { restitution, ratio, compliance, friction_speed }
    }

    /// The part of a slip that is left after the contact; negative if it is turned back.
    fn slip_kept(&self, slip: S) -> S {
        if self.friction_speed == S::ZERO {
            return S::ONE;
        }
        match self.stuck(slip) {
            Some(stuck) => self.kept_after(&stuck, slip),
            None => S::ONE - self.friction_speed * S::from_f64(BETA) * (S::ONE + self.restitution) / slip, // (3)
        }
    }

    /// Where a contact with this slip sticks, if it does.
    fn stuck(&self, slip: S) -> Option<Stuck<S>> {
        let (e, beta, w) = (self.restitution, S::from_f64(BETA), self.friction_speed);
        let quarter = S::from_f64(FRAC_PI_2);
        if slip < w * self.compliance {
            return Some(Stuck { since: S::ZERO, deflection: S::ZERO, velocity: S::ONE });
        }
        let unit = self.compliance * w / slip;
        if slip < w * beta {
            let cos = (beta * w - slip) / (beta * w - self.compliance * w);
            let sin = other_leg(cos);
            return Some(Stuck { since: arccos(cos), deflection: unit * sin, velocity: unit * cos });
        }
        let late = (e.squared() * beta - self.compliance) * w;
        let excess = e * (slip - beta * w);
        if late <= S::ZERO || excess >= late {
            return None;
        }
        let sin = excess / late;
        let cos = other_leg(sin);
        let since = quarter + e * (quarter - arccos(sin));
        Some(Stuck { since, deflection: unit * cos, velocity: -(unit * sin) / e })
    }

    /// What is left of a slip that sticks, and slips again at the end.
    fn kept_after(&self, stuck: &Stuck<S>, slip: S) -> S {
        let x = self.end_of_sticking(stuck, slip);
        let (deflection, velocity) = self.swing(stuck, x);
        let hold = self.compliance * self.friction_speed;
        let cos = deflection.abs() * slip / hold;
        // From (3), β w e (1 − sin x) over the slip, with no difference of like numbers and no division by the slip.
        let scale = S::from_f64(BETA) * self.restitution * slip / (hold * self.compliance);
        velocity - scale * deflection * deflection.abs() / (S::ONE + other_leg(cos))
    }

    /// Deflection and velocity (2) of a stuck contact, as it unloads.
    fn swing(&self, stuck: &Stuck<S>, x: S) -> (S, S) {
        let time = S::from_f64(FRAC_PI_2) + self.restitution * x - stuck.since;
        let (cos, sin) = (self.ratio * time).cos_sin();
        let deflection = stuck.deflection * cos + stuck.velocity / self.ratio * sin;
        (deflection, stuck.velocity * cos - stuck.deflection * self.ratio * sin)
    }

    /// The x at which the spring pulls as hard as friction holds, between where it sticks and the end.
    ///
    /// Newton's method, kept inside the bracket by bisection; a last step on the result gives it its derivatives.
    fn end_of_sticking(&self, stuck: &Stuck<S>, slip: S) -> S {
        let (mut low, mut high) = (self.start_of_search(stuck), FRAC_PI_2);
        let mut x = 0.5 * (low + high);
        for _ in 0..SEARCH_STEPS {
            let (spare, change) = self.spare_hold(stuck, slip, S::from_f64(x));
            let (spare, change) = (spare.to_f64(), change.to_f64());
            if spare > 0.0 {
                low = x;
            } else {
                high = x;
            }
            let next = x - spare / change;
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            if next == x {
                break;
            }
            x = next;
        }
        let x = S::from_f64(x);
        let (spare, change) = self.spare_hold(stuck, slip, x);
        x - spare / change
    }

    /// The x from which a contact is stuck, none below zero.
    fn start_of_search(&self, stuck: &Stuck<S>) -> f64 {
        let since = stuck.since.to_f64() - FRAC_PI_2;
        if since > 0.0 { since / self.restitution.to_f64() } else { 0.0 }
    }

    /// What friction can hold beyond what the spring pulls, and its change with x.
    fn spare_hold(&self, stuck: &Stuck<S>, slip: S, x: S) -> (S, S) {
        let (deflection, velocity) = self.swing(stuck, x);
        let (cos, sin) = x.cos_sin();
        let hold = self.compliance * self.friction_speed;
        let pull = if deflection < S::ZERO { -slip } else { slip };
        (hold * cos - pull * deflection, -(hold * sin) - pull * velocity * self.restitution)
    }
}
