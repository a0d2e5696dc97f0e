//! When a ball meets a cushion, and when a ball held by one leaves it.

use super::Surroundings;
use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::model::{ContactTolerance, Face, Faces, Line, Room, Round, closing_threshold};
use crate::roots::{Polynomial, first_contact};
use crate::scalar::Scalar;

/// The offset from the start of its flight at which a ball of the given radius meets a cushion; `None` when it never
/// does.
///
/// A cushion counts only with the ball's foot on it, up to the contact tolerance past its ends, and only from its front:
/// one that the ball is behind is ignored until the ball has come before it. Notes contact at the start in `seen`, unless
/// the cushion has just been `struck`.
#[inline]
pub fn detect_ball_cushion<S: Scalar>(
    flight: &Flight<S>,
    radius: S,
    face: &Face<S>,
    tolerance: S,
    struck: bool,
    seen: &mut Surroundings<S>,
) -> Option<S> {
    match face {
        Face::Line(line) => {
            let gap = line.height(flight.position) - radius;
            let slope = line.normal.dot(flight.velocity);
            if gap > tolerance && flight.is_straight() {
                let offset = gap / -slope;
                let meets = slope < S::ZERO && line.spans(flight.position_after(offset), tolerance);
                return meets.then_some(offset);
            }
            detect_line_near(flight, line, [gap, slope], tolerance, struck, seen)
        }
        Face::Round(round) => detect_round(flight, radius, round, tolerance, struck, seen),
    }
}

/// The first cushion that a ball in straight flight meets, and the offset, which is infinite if it meets none; `None` when
/// it is so near to one other than `struck`, the number of the one that it is just leaving, that
/// [`detect_ball_cushion`] has to be asked of each. Else the answer is the same, but quicker.
#[inline(always)]
pub fn detect_cushion_in_the_clear<S: Scalar>(
    flight: &Flight<S>,
    radius: S,
    faces: &Faces<S>,
    tolerance: S,
    struck: usize,
) -> Option<(usize, S)> {
    let wall = match &faces.room {
        Some(room) => detect_wall(flight, radius, room, tolerance, struck)?,
        None => (usize::MAX, S::INFINITY),
    };
    if faces.is_room {
        return Some(wall);
    }
    // A copy, so that the flight itself can stay in registers where there is nothing but a room.
    let flight = *flight;
    detect_other(&flight, radius, faces, tolerance, struck, wall)
}

/// The first cushion that is not a wall of the room, unless the wall `first` comes before it; `None` as above.
fn detect_other<S: Scalar>(
    flight: &Flight<S>,
    radius: S,
    faces: &Faces<S>,
    tolerance: S,
    struck: usize,
    first: (usize, S),
) -> Option<(usize, S)> {
    let mut seen = Surroundings::CLEAR;
    let mut first = first;
    let others = faces.others();
    let walls = faces.all.len() - others.len();
    for (place, face) in others.iter().enumerate() {
        let number = walls + place;
        if let Some(offset) =
            detect_ball_cushion(flight, radius, face, tolerance, number == struck, &mut seen)
            && offset < first.1
        {
            first = (number, offset);
        }
    }
    (!seen.touching).then_some(first)
}

/// The first wall of a room, with an infinite offset if it never comes; `None` when the ball is so near to one other than
/// the struck that they have to be looked at one by one.
#[inline(always)]
fn detect_wall<S: Scalar>(
    flight: &Flight<S>,
    radius: S,
    room: &Room<S>,
    tolerance: S,
    struck: usize,
) -> Option<(usize, S)> {
    let (position, velocity) = (flight.position, flight.velocity);
    let below = position - room.lower;
    let above = room.upper - position;
    let across = along_axis([below.x - radius, above.x - radius], velocity.x, tolerance, [3, 1], struck)?;
    let along = along_axis([below.y - radius, above.y - radius], velocity.y, tolerance, [0, 2], struck)?;
    Some(if across.1 < along.1 { across } else { along })
}

/// The wall that a ball meets on one axis, and when; `None` if it touches one other than the struck, or moves into that.
#[inline(always)]
fn along_axis<S: Scalar>(
    [below, above]: [S; 2],
    velocity: S,
    tolerance: S,
    [lower, upper]: [usize; 2],
    struck: usize,
) -> Option<(usize, S)> {
    let is_clear = |gap, wall| gap > tolerance || wall == struck;
    if velocity > S::ZERO {
        (above > tolerance && is_clear(below, lower)).then(|| (upper, above / velocity))
    } else if velocity < S::ZERO {
        (below > tolerance && is_clear(above, upper)).then(|| (lower, below / -velocity))
    } else {
        (is_clear(below, lower) && is_clear(above, upper)).then_some((lower, S::INFINITY))
    }
}

/// A line that the ball touches, or is behind, or approaches in a field.
#[cold]
fn detect_line_near<S: Scalar>(
    flight: &Flight<S>,
    line: &Line<S>,
    [gap, slope]: [S; 2],
    tolerance: S,
    struck: bool,
    seen: &mut Surroundings<S>,
) -> Option<S> {
    let spans = |offset| line.spans(flight.position_after(offset), tolerance);
    let touches = gap <= tolerance && gap >= -tolerance && spans(S::ZERO);
    seen.touching |= touches && !struck;
    let threshold = closing_threshold(flight.velocity, Vec2::ZERO) * S::from_f64(2.0);
    if flight.is_straight() {
        return (touches && -slope > threshold).then_some(S::ZERO);
    }
    let slope = if touches { without_round_off(slope, threshold) } else { slope };
    let bend = line.normal.dot(flight.acceleration) * S::from_f64(0.5);
    first_contact(&Polynomial::new([gap, slope, bend, S::ZERO, S::ZERO]), tolerance, spans)
}

/// The slope of a gap in contact, or zero where it is not told from that: the bend then says whether the gap closes.
fn without_round_off<S: Scalar>(slope: S, threshold: S) -> S {
    if slope.abs() <= threshold { slope - slope.detached() } else { slope }
}

fn detect_round<S: Scalar>(
    flight: &Flight<S>,
    radius: S,
    round: &Round<S>,
    tolerance: S,
    struck: bool,
    seen: &mut Surroundings<S>,
) -> Option<S> {
    let distance = round.contact_distance(radius);
    if distance <= S::ZERO {
        // A ball too large for a hollow arc, or a point against a point.
        return None;
    }
    let spans = |offset| round.arc.spans(flight.position_after(offset) - round.arc.center, tolerance);
    let side = if round.is_hollow() { -S::ONE } else { S::ONE };
    let position = flight.position - round.arc.center;
    let two = S::from_f64(2.0);
    let gap = side * (position.norm_squared() - distance.squared());
    let tolerance = two * distance * tolerance;
    let velocity = flight.velocity;
    let mut slope = side * two * velocity.dot(position);
    if gap <= tolerance && gap >= -tolerance && spans(S::ZERO) {
        seen.touching |= !struck;
        slope =
            without_round_off(slope, closing_threshold(velocity, Vec2::ZERO) * S::from_f64(4.0) * distance);
    }
    let half = flight.acceleration * S::from_f64(0.5);
    let gap = Polynomial::new([
        gap,
        slope,
        side * (velocity.norm_squared() + two * half.dot(position)),
        side * two * half.dot(velocity),
        side * half.norm_squared(),
    ]);
    first_contact(&gap, tolerance, spans)
}

/// The distance between a ball and a cushion, negative for an overlap, when the ball's foot lies on the cushion.
pub fn cushion_gap<S: Scalar>(
    position: Vec2<S>,
    radius: S,
    cushion: &Face<S>,
    tolerance: &ContactTolerance<S>,
) -> Option<S> {
    let tolerance = tolerance.of(radius);
    match cushion {
        Face::Line(line) => line.spans(position, tolerance).then(|| line.height(position) - radius),
        Face::Round(round) => {
            let ray = position - round.arc.center;
            let distance = round.contact_distance(radius);
            let gap = if round.is_hollow() { distance - ray.norm() } else { ray.norm() - distance };
            (distance > S::ZERO && round.arc.spans(ray, tolerance)).then_some(gap)
        }
    }
}

/// The offset at which the foot of a ball that slides along a straight cushion passes an end of it.
pub fn detect_release<S: Scalar>(flight: &Flight<S>, line: &Line<S>, tolerance: S) -> Option<S> {
    let foot = line.along.dot(flight.position - line.start);
    let speed = line.along.dot(flight.velocity);
    let bend = line.along.dot(flight.acceleration) * S::from_f64(0.5);
    let ahead = Polynomial::new([line.length + tolerance - foot, -speed, -bend, S::ZERO, S::ZERO]);
    let behind = Polynomial::new([foot + tolerance, speed, bend, S::ZERO, S::ZERO]);
    let never = |_: S| true;
    match (first_contact(&ahead, S::ZERO, never), first_contact(&behind, S::ZERO, never)) {
        (Some(a), Some(b)) => Some(if b < a { b } else { a }),
        (a, b) => a.or(b),
    }
}

/// The offset at which a point that lies on the other face of a thin wall meets this face: after it has come round.
pub fn detect_from_behind<S: Scalar>(flight: &Flight<S>, line: &Line<S>, tolerance: S) -> Option<S> {
    let slope = line.normal.dot(flight.velocity);
    let bend = line.normal.dot(flight.acceleration) * S::from_f64(0.5);
    let gap = Polynomial::new([tolerance * S::from_f64(-2.0), slope, bend, S::ZERO, S::ZERO]);
    first_contact(&gap, tolerance, |offset| line.spans(flight.position_after(offset), tolerance))
}
