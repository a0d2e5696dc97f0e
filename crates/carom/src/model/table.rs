//! A table as pieces: its boundary, what stands on it, and the corners that stick out.
//!
//! | table | cushions, in order |
//! |---|---|
//! | rectangle | `bottom`, `right`, `top`, `left` (counter-clockwise from the origin) |
//! | circle | `rim` |
//! | path | its pieces |
//! | pocket table | six rails, and jaws, facings and backs: see `pocket_table.rs` |
//! | obstacle `id` that is a circle | `id` |
//! | obstacle `id` that is a path | `id.<piece>` |
//! | obstacle `id` that is a wall | `id.a` (left of its direction), `id.b` (right of it) |
//!
//! Obstacle number k is `obstacle<k>` if it has no id of its own. A corner is named after the two cushions that meet
//! there, in the order of the boundary: `id.a/id.b` is the last point of a wall.

use super::pocket::{Nose, Pocket};
use crate::geometry::{Arc, Bounds, Piece, Segment, Vec2, turn};
use crate::scalar::Scalar;

/// Ends that lie closer than this, times the size of the table, are one joint.
pub const JOINT_TOLERANCE: f64 = 1e-9;

/// A joint that turns right by less than this (the sine of the angle) has no corner: a ball of radius r enters it by
/// at most r/8 times the square of this, far below the contact tolerance.
const FLAT_TURN: f64 = 1e-7;

/// One piece of boundary and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Cushion<S> {
    /// The name that laws and events use.
    pub id: String,
    /// Where it is; the table lies to the left.
    pub piece: Piece<S>,
}

/// A point that sticks out into the table, where two cushions meet or a thin wall ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Corner<S> {
    /// The ids of its two cushions, as in `left/top`.
    pub id: String,
    /// Where it is.
    pub point: Vec2<S>,
    /// The places of its two cushions among all cushions of the table, in the order of the boundary.
    pub cushions: [usize; 2],
}

/// What a closed chain of cushions is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutlineKind {
    /// The boundary of the table, counter-clockwise.
    Boundary,
    /// Something solid, clockwise.
    Obstacle,
    /// A thin wall: the same line there and back.
    Wall,
}

/// A closed chain of cushions: each ends where the next begins, and the last where the first begins.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline<S> {
    /// What it is.
    pub kind: OutlineKind,
    /// The name of the obstacle; `boundary` for the boundary.
    pub id: String,
    /// The cushions in order.
    pub cushions: Vec<Cushion<S>>,
}

/// A table made ready to compute with.
#[derive(Clone, Debug, PartialEq)]
pub struct Table<S> {
    /// The boundary, and after it the obstacles in order.
    pub outlines: Vec<Outline<S>>,
    /// The corners that stick out.
    pub corners: Vec<Corner<S>>,
    /// The box around the boundary.
    pub bounds: Bounds<S>,
    /// The holes that balls fall into.
    pub pockets: Vec<Pocket<S>>,
    /// The noses of the cushions.
    pub nose: Nose<S>,
}

impl<S: Scalar> Table<S> {
    /// The table inside a boundary, with obstacles and without pockets; ends within [`JOINT_TOLERANCE`] become one point.
    pub fn new(boundary: Vec<Cushion<S>>, obstacles: Vec<Outline<S>>) -> Self {
        let mut outlines =
            vec![Outline { kind: OutlineKind::Boundary, id: "boundary".into(), cushions: boundary }];
        outlines.extend(obstacles);
        let bounds = Bounds::around(outlines[0].cushions.iter().map(|cushion| &cushion.piece));
        let tolerance = bounds.size() * S::from_f64(JOINT_TOLERANCE);
        for outline in &mut outlines {
            join_ends(&mut outline.cushions, tolerance);
        }
        let corners = corners(&outlines, tolerance);
        Self { outlines, corners, bounds, pockets: Vec::new(), nose: Nose::LEVEL }
    }

    /// The larger side of the box around the table.
    pub fn size(&self) -> S {
        self.bounds.size()
    }

    /// The larger of its size and its largest coordinate: what round-off of positions goes by.
    pub fn reach(&self) -> S {
        let Bounds { min, max } = self.bounds;
        let larger = |a: S, b: S| if b > a { b } else { a };
        [min.x, min.y, max.x, max.y].into_iter().map(S::abs).fold(self.size(), larger)
    }

    /// All cushions: those of the boundary, then those of each obstacle.
    pub fn cushions(&self) -> impl Iterator<Item = &Cushion<S>> {
        self.outlines.iter().flat_map(|outline| &outline.cushions)
    }
}

/// The cushions of a rectangle whose lower left corner is the origin.
pub fn rectangle<S: Scalar>(width: S, length: S) -> Vec<Cushion<S>> {
    let corner = [(S::ZERO, S::ZERO), (width, S::ZERO), (width, length), (S::ZERO, length)];
    let corner = corner.map(|(x, y)| Vec2::new(x, y));
    let cushion = |id: &str, start, end| Cushion { id: id.into(), piece: line(start, end) };
    vec![
        cushion("bottom", corner[0], corner[1]),
        cushion("right", corner[1], corner[2]),
        cushion("top", corner[2], corner[3]),
        cushion("left", corner[3], corner[0]),
    ]
}

/// The cushion of a round table around the origin.
pub fn circle<S: Scalar>(radius: S) -> Vec<Cushion<S>> {
    let piece = Piece::Arc(Arc::from_degrees(Vec2::ZERO, radius, S::ZERO, S::from_f64(360.0)));
    vec![Cushion { id: "rim".into(), piece }]
}

impl<S: Scalar> Outline<S> {
    /// A round obstacle.
    pub fn pillar(id: &str, center: Vec2<S>, radius: S) -> Self {
        let piece = Piece::Arc(Arc::from_degrees(center, radius, S::from_f64(360.0), S::ZERO));
        Self { kind: OutlineKind::Obstacle, id: id.into(), cushions: vec![Cushion { id: id.into(), piece }] }
    }

    /// A thin wall.
    pub fn wall(id: &str, start: Vec2<S>, end: Vec2<S>) -> Self {
        let face = |side: &str, start, end| Cushion { id: format!("{id}.{side}"), piece: line(start, end) };
        Self {
            kind: OutlineKind::Wall,
            id: id.into(),
            cushions: vec![face("a", start, end), face("b", end, start)],
        }
    }
}

fn line<S: Scalar>(start: Vec2<S>, end: Vec2<S>) -> Piece<S> {
    Piece::Line(Segment { start, end })
}

/// Moves the ends of lines onto the ends of their neighbours, where these are nearer than the tolerance.
fn join_ends<S: Scalar>(cushions: &mut [Cushion<S>], tolerance: S) {
    let count = cushions.len();
    for after in 0..count {
        let before = (after + count - 1) % count;
        let (end, start) = (cushions[before].piece.end(), cushions[after].piece.start());
        if (end - start).norm() > tolerance {
            continue;
        }
        if let Piece::Line(line) = &mut cushions[before].piece {
            line.end = start;
        } else if let Piece::Line(line) = &mut cushions[after].piece {
            line.start = end;
        }
    }
}

/// The corners of all outlines; where two coincide, as where walls meet, the first.
fn corners<S: Scalar>(outlines: &[Outline<S>], tolerance: S) -> Vec<Corner<S>> {
    let mut corners: Vec<Corner<S>> = Vec::new();
    let mut first = 0;
    for Outline { cushions, .. } in outlines {
        let count = cushions.len();
        for (before, cushion) in cushions.iter().enumerate() {
            let after = (before + 1) % count;
            let point = cushion.piece.end();
            let known = corners.iter().any(|corner| (corner.point - point).norm() <= tolerance);
            if !known && turn(&cushion.piece, &cushions[after].piece).to_f64() < -FLAT_TURN {
                let id = format!("{}/{}", cushion.id, cushions[after].id);
                corners.push(Corner { id, point, cushions: [first + before, first + after] });
            }
        }
        first += count;
    }
    corners
}
