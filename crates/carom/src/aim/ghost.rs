//! Directions: to a point, to a ball with a cut, and to the ghost ball of a pot.

use super::scene::Scene;
use crate::geometry::Vec2;
use crate::scalar::{Scalar, angle_deg, direction};
use crate::scenario::Problem;

/// Where the cue ball is when it touches the ball that it is to pot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ghost {
    /// Its centre then.
    pub center: [f64; 2],
    /// The direction from where it lies to there.
    pub direction_deg: f64,
    /// The angle from its direction to that of the ball, positive to the left.
    pub cut_deg: f64,
}

/// The direction from one point to another, above −180 and up to 180 degrees.
///
/// # Errors
///
/// When both are the same point.
pub fn at_point(scene: &Scene, point: [f64; 2]) -> Result<f64, Problem> {
    let between = Vec2::from_f64(point) - scene.place(scene.cue_ball);
    if !between.is_finite() {
        return Err(Problem::new("point", format!("must be two finite numbers, got {point:?}")));
    }
    if between == Vec2::ZERO {
        return Err(Problem::new("point", "is the centre of the cue ball: there is no direction to it"));
    }
    Ok(angle_of(between))
}

/// The direction in which the cue ball hits a ball with a cut angle: `φ − asin((d/D) sin χ)` for the direction φ and the
/// distance D to the ball, the distance d of the centres at contact and the cut angle χ.
///
/// The cut angle is that from the cue ball's direction to the object ball's: positive where the ball goes to the left, for
/// which it is hit on its right.
///
/// # Errors
///
/// When there is no such ball, or the cut angle is not between −90 and 90 degrees.
pub fn at_ball(scene: &Scene, ball: &str, cut_deg: f64) -> Result<f64, Problem> {
    let ball = scene.object_ball(ball)?;
    if cut_deg.is_nan() || cut_deg.abs() >= 90.0 {
        return Err(Problem::new("cut_deg", format!("must lie between -90 and 90, got {cut_deg}")));
    }
    let between = scene.place(ball) - scene.place(scene.cue_ball);
    let sin = contact_distance(scene, ball)? / between.norm() * direction(cut_deg).1;
    Ok(wrapped(angle_of(between) - angle_deg((1.0 - sin.squared()).sqrt(), sin)))
}

/// Where the cue ball has to be at contact so that a ball goes to the aiming point of a pocket.
///
/// # Errors
///
/// When there is no such ball or pocket, or the ball would have to be cut by 90 degrees or more.
pub fn ghost_ball(scene: &Scene, ball: &str, pocket: &str) -> Result<Ghost, Problem> {
    let (index, hole) = (scene.object_ball(ball)?, scene.pocket(pocket)?);
    let ghost = Ghost::of(scene, index, hole.aiming_point())?;
    if ghost.is_possible() {
        return Ok(ghost);
    }
    let message = format!(
        "ball \"{ball}\" would have to be cut by {:.1} degrees into \"{pocket}\", and 90 is too much",
        ghost.cut_deg.abs()
    );
    Err(Problem::new("pocket", message))
}

impl Ghost {
    /// The ghost of a ball that is to go to a point.
    pub(super) fn of(scene: &Scene, ball: usize, target: Vec2<f64>) -> Result<Self, Problem> {
        let along = (target - scene.place(ball)).unit();
        let center = scene.place(ball) - along * contact_distance(scene, ball)?;
        let path = center - scene.place(scene.cue_ball);
        // Where the balls touch already and lie right, the cue ball has no way to go.
        let is_there = path.norm() <= scene.tolerance(ball);
        let direction_deg = angle_of(if is_there { along } else { path });
        let cut_deg = wrapped(angle_of(along) - direction_deg);
        Ok(Self { center: center.to_f64(), direction_deg, cut_deg })
    }

    /// Whether the cue ball can get there without going through the ball.
    pub(super) fn is_possible(&self) -> bool {
        self.cut_deg.abs() < 90.0
    }
}

/// The distance of the centres of the cue ball and a ball when they touch.
pub(super) fn contact_distance(scene: &Scene, ball: usize) -> Result<f64, Problem> {
    let out_of_reach = || {
        let message = format!("the cue ball passes below or above ball \"{}\"", scene.balls[ball].id);
        Problem::new("ball", message)
    };
    scene.contact_distance(scene.cue_ball, ball).ok_or_else(out_of_reach)
}

pub(super) fn angle_of(vector: Vec2<f64>) -> f64 {
    angle_deg(vector.x, vector.y)
}

/// An angle from −360 to 360 degrees as one above −180 and up to 180.
pub(super) fn wrapped(degrees: f64) -> f64 {
    if degrees > 180.0 {
        degrees - 360.0
    } else if degrees <= -180.0 {
        degrees + 360.0
    } else {
        degrees
    }
}
