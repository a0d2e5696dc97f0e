//! Where to aim, and whether one can: plain geometry of a scenario as it lies at time 0.
//!
//! A ball is shot straight, without squirt, swerve or throw; the ball it hits leaves along the line of centres. Balls count
//! where they lie, and only the two that take part move. Centres of balls on the cloth that touch are `2 √(R₁ R₂)` apart as
//! seen from above, those of discs `R₁ + R₂`. Directions are in degrees from the x axis towards the y axis.
//!
//! Source: the ghost ball, as D. G. Alciatore, The Illustrated Principles of Pool and Billiards (2004), describes it. The
//! signs of cut angles are pooltool's.

mod ghost;
mod goal;
mod obstacle;
mod pot;
mod scene;
mod stick;

pub use ghost::{Ghost, at_ball, at_point, ghost_ball};
pub use pot::{Pot, open_pots, pot};
pub use scene::{Scene, aiming_point};
pub use stick::{Obstruction, least_elevation_deg, obstructions};
