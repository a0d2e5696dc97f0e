//! What could be hit within a step, and when.

use crate::flight::State;
use crate::geometry::Vec2;
use crate::law::ball_cushion;
use crate::model::Disc;
use crate::run::Kind;
use crate::scalar::Scalar;

/// The walls of a rectangle, numbered as its cushions: bottom, right, top, left.
pub struct Walls<S> {
    /// Width and length.
    pub size: [S; 2],
    /// The law of each wall.
    pub laws: [ball_cushion::Law<S>; 4],
}

/// What a candidate is about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// Two balls.
    Balls(usize, usize),
    /// A ball and a wall.
    Wall {
        /// The ball.
        ball: usize,
        /// The number of the wall.
        wall: usize,
    },
}

/// Something that could be hit in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate<S> {
    /// Time from the start of the step to the contact, Δt of the course.
    pub after: S,
    /// With what.
    pub contact: Contact,
}

impl Contact {
    /// The kind of event this becomes.
    pub fn kind(&self) -> Kind {
        match self {
            Self::Balls(..) => Kind::BallBall,
            Self::Wall { .. } => Kind::BallCushion,
        }
    }
}

impl<S: Scalar> Candidate<S> {
    /// Whether a ball takes part.
    pub fn involves(&self, ball: usize) -> bool {
        match self.contact {
            Contact::Balls(a, b) => ball == a || ball == b,
            Contact::Wall { ball: hitter, .. } => ball == hitter,
        }
    }

    /// Whether a ball takes part in both.
    pub fn shares_ball_with(&self, other: &Self) -> bool {
        match self.contact {
            Contact::Balls(a, b) => other.involves(a) || other.involves(b),
            Contact::Wall { ball, .. } => other.involves(ball),
        }
    }
}

impl<S: Scalar> Walls<S> {
    /// The point of a wall nearest to `position`.
    pub fn foot(&self, wall: usize, position: Vec2<S>) -> Vec2<S> {
        match wall {
            0 => Vec2::new(position.x, S::ZERO),
            1 => Vec2::new(self.size[0], position.y),
            2 => Vec2::new(position.x, self.size[1]),
            _ => Vec2::new(S::ZERO, position.y),
        }
    }

    /// Unit vector of a wall into the table.
    pub fn normal(&self, wall: usize) -> Vec2<S> {
        match wall {
            0 => Vec2::new(S::ZERO, S::ONE),
            1 => Vec2::new(-S::ONE, S::ZERO),
            2 => Vec2::new(S::ZERO, -S::ONE),
            _ => Vec2::new(S::ONE, S::ZERO),
        }
    }
}

/// All candidates of a step of length `length`, in the order in which they are considered: by time; at equal times
/// balls before walls, then by ball, then by axis.
pub fn candidates<S: Scalar>(
    balls: &[State<S>],
    discs: &[Disc<S>],
    walls: &Walls<S>,
    length: S,
) -> Vec<Candidate<S>> {
    let mut found = Vec::new();
    for a in 0..balls.len() {
        for b in a + 1..balls.len() {
            let radii = discs[a].radius + discs[b].radius;
            found.extend(
                ball_candidate([balls[a], balls[b]], radii, length)
                    .map(|after| Candidate { after, contact: Contact::Balls(a, b) }),
            );
        }
    }
    for (ball, &state) in balls.iter().enumerate() {
        let hits = wall_candidates(state, discs[ball].radius, walls, length);
        found.extend(
            hits.into_iter()
                .flatten()
                .map(|(wall, after)| Candidate { after, contact: Contact::Wall { ball, wall } }),
        );
    }
    found.sort_by(|a, b| a.after.partial_cmp(&b.after).unwrap_or(core::cmp::Ordering::Equal));
    found
}

/// The course's `getdtBall`: two balls that approach and would overlap at the end of the step. Two points never meet.
fn ball_candidate<S: Scalar>([a, b]: [State<S>; 2], radii: S, length: S) -> Option<S> {
    let (separation, relative) = (a.position - b.position, a.velocity - b.velocity);
    let tentative = (a.position + a.velocity * length) - (b.position + b.velocity * length);
    if radii == S::ZERO || tentative.norm() > radii || separation.dot(relative) >= S::ZERO {
        return None;
    }
    let after = (separation.norm() - radii) / relative.norm();
    Some(if after < S::ZERO {
        S::ZERO
    } else if after > length {
        length
    } else {
        after
    })
}

/// The course's `getdt`, for each axis on which the ball would leave the box while moving outwards.
fn wall_candidates<S: Scalar>(
    State { position, velocity }: State<S>,
    radius: S,
    walls: &Walls<S>,
    length: S,
) -> [Option<(usize, S)>; 2] {
    let along = |x: S, v: S, size: S, [lower, upper]: [usize; 2]| {
        let tentative = x + v * length;
        let (wall, limit) = if v > S::ZERO && tentative > size - radius {
            (upper, size - radius)
        } else if v < S::ZERO && tentative < radius {
            (lower, radius)
        } else {
            return None;
        };
        let after = (limit - x) / v;
        Some((wall, if after < S::ZERO { S::ZERO } else { after }))
    };
    [
        along(position.x, velocity.x, walls.size[0], [3, 1]),
        along(position.y, velocity.y, walls.size[1], [0, 2]),
    ]
}
