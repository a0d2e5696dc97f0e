//! Pockets and noses: what a table for cue sports has beside its cushions.

use crate::geometry::Vec2;
use crate::scalar::{Scalar, other_leg};

/// A hole in the table: a ball whose centre comes inside the circle falls.
#[derive(Clone, Debug, PartialEq)]
pub struct Pocket<S> {
    /// The name that events use.
    pub id: String,
    /// Centre of the circle.
    pub center: Vec2<S>,
    /// Radius of the circle.
    pub radius: S,
    /// The horn tips of its mouth, before and after it in the direction of the outline; none for a bare hole.
    pub tips: Option<[Vec2<S>; 2]>,
}

/// The noses of all cushions: the edges that stick out furthest, which balls touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nose<S> {
    /// Height above the cloth; none: that of each ball's centre.
    pub height: Option<S>,
    /// Where a ball touches it.
    pub contact: NoseContact,
}

/// Where a ball touches a nose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoseContact {
    /// Where the nose is, so that the centre comes nearer to it than the radius.
    Nose,
    /// When the centre is one radius away in plan; the direction of the blow is that of the nose.
    Plan,
}

impl<S: Scalar> Pocket<S> {
    /// Where one aims to pot a ball: half-way between the horn tips; without those the centre of the hole.
    pub fn aiming_point(&self) -> Vec2<S> {
        self.tips.map_or(self.center, |[before, after]| (before + after) * S::from_f64(0.5))
    }

    /// Whether a point lies inside the circle.
    pub fn has_inside(&self, point: Vec2<S>) -> bool {
        (point - self.center).norm_squared() < self.radius.squared()
    }
}

impl<S: Scalar> Nose<S> {
    /// Noses at the height of each ball's centre.
    pub const LEVEL: Self = Self { height: None, contact: NoseContact::Nose };

    /// How near the centre of a ball comes to the nose, seen from above, where it touches it; zero for a ball that flies
    /// over it.
    pub fn reach(&self, radius: S, height: S) -> S {
        match (self.height, self.contact) {
            (None, _) | (_, NoseContact::Plan) => radius,
            (Some(_), NoseContact::Nose) if radius == S::ZERO => S::ZERO,
            (Some(nose), NoseContact::Nose) => radius * other_leg((nose - height) / radius),
        }
    }
}
