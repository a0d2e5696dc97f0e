//! The box around pieces of boundary.

use super::{Arc, Piece, Vec2};
use crate::scalar::Scalar;

/// A box with sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds<S> {
    /// The lower left corner.
    pub min: Vec2<S>,
    /// The upper right corner.
    pub max: Vec2<S>,
}

impl<S: Scalar> Bounds<S> {
    /// The smallest box around some pieces; turned inside out where there are none.
    pub fn around<'a>(pieces: impl Iterator<Item = &'a Piece<S>>) -> Self {
        let mut bounds =
            Self { min: Vec2::new(S::INFINITY, S::INFINITY), max: Vec2::new(-S::INFINITY, -S::INFINITY) };
        for piece in pieces {
            bounds.include(piece.start());
            bounds.include(piece.end());
            if let Piece::Arc(arc) = piece {
                arc.extremes().for_each(|point| bounds.include(point));
            }
        }
        bounds
    }

    /// The box around a path `x + v t + ½ a t²` for `0 ≤ t ≤ time`, which is finite.
    #[inline(always)]
    pub fn of_path(position: Vec2<S>, velocity: Vec2<S>, acceleration: Vec2<S>, time: S) -> Self {
        let across = range_of_path(position.x, velocity.x, acceleration.x, time);
        let along = range_of_path(position.y, velocity.y, acceleration.y, time);
        Self { min: Vec2::new(across.0, along.0), max: Vec2::new(across.1, along.1) }
    }

    /// Whether two boxes are nowhere nearer to each other than `distance` along an axis.
    #[inline(always)]
    pub fn is_apart(&self, other: &Self, distance: S) -> bool {
        self.min.x > other.max.x + distance
            || other.min.x > self.max.x + distance
            || self.min.y > other.max.y + distance
            || other.min.y > self.max.y + distance
    }

    /// The larger side.
    pub fn size(&self) -> S {
        let sides = self.max - self.min;
        if sides.x > sides.y { sides.x } else { sides.y }
    }

    /// The box around both.
    pub fn with(mut self, other: &Self) -> Self {
        self.include(other.min);
        self.include(other.max);
        self
    }

    fn include(&mut self, point: Vec2<S>) {
        if point.x < self.min.x {
            self.min.x = point.x;
        }
        if point.y < self.min.y {
            self.min.y = point.y;
        }
        if point.x > self.max.x {
            self.max.x = point.x;
        }
        if point.y > self.max.y {
            self.max.y = point.y;
        }
    }
}

/// The least and the greatest of `x + v t + ½ a t²` for `0 ≤ t ≤ time`.
#[inline(always)]
fn range_of_path<S: Scalar>(x: S, v: S, a: S, time: S) -> (S, S) {
    let half = S::from_f64(0.5);
    let end = x + (v + a * (time * half)) * time;
    let (mut least, mut greatest) = if end < x { (end, x) } else { (x, end) };
    if v * (v + a * time) < S::ZERO {
        let turn = x - v * v * half / a;
        least = if turn < least { turn } else { least };
        greatest = if turn > greatest { turn } else { greatest };
    }
    (least, greatest)
}

impl<S: Scalar> Arc<S> {
    /// The points of the arc that lie furthest right, up, left and down on its circle, those of them that it has.
    fn extremes(&self) -> impl Iterator<Item = Vec2<S>> {
        let right = Vec2::new(S::ONE, S::ZERO);
        let up = right.left();
        [right, up, -right, -up]
            .into_iter()
            .filter(|ray| self.spans(*ray, S::ZERO))
            .map(|ray| self.center + ray * self.radius)
    }
}
