//! Meetings in the air.

use crate::detect::ball_ball::squared_gap;
use crate::flight::SphereFlight;
use crate::geometry::{Vec2, Vec3, Vector};
use crate::model::{ContactTolerance, Face, Hole, Line, Round};
use crate::roots::{Enclosure, Gap, Interval, Polynomial, first_closing_crossing, first_contact};
use crate::scalar::Scalar;

/// What a ball in the air does at a cushion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// It touches the nose.
    Contact,
    /// Its centre passes over the nose: it leaves the table.
    Over,
}

/// Two balls of which one at least is in the air: the gap `|Δ|² − (R₁ + R₂)²` in space.
pub(super) fn detect_ball<S: Scalar>(
    a: &SphereFlight<S>,
    b: &SphereFlight<S>,
    radii: S,
    tolerance: &ContactTolerance<S>,
    horizon: S,
) -> Option<S> {
    let start = a.plan.later_start(&b.plan);
    let (after_a, after_b) = (start - a.start(), start - b.start());
    let position = b.position_after(after_b) - a.position_after(after_a);
    let velocities = [a.velocity_after(after_a), b.velocity_after(after_b)];
    let acceleration = b.acceleration() - a.acceleration();
    let gap = position.norm_squared() - radii.squared();
    let slope = position.dot(velocities[1] - velocities[0]);
    let tolerance = S::from_f64(2.0) * radii * tolerance.of(radii);
    let mut gap = squared_gap(position, velocities[1] - velocities[0], acceleration, gap);
    let threshold = (velocities[0].size() + velocities[1].size()) * S::from_f64(32.0 * S::EPSILON) * radii;
    if gap.coefficients[0].abs() <= tolerance && slope.abs() <= threshold {
        gap.coefficients[1] = gap.coefficients[1] - gap.coefficients[1].detached();
    }
    first_contact(&gap, tolerance, |offset| offset <= horizon)
}

/// The offset at which a ball in the air touches the nose of a cushion, at the height `nose`, or passes over it.
pub fn detect_nose_in_the_air<S: Scalar>(
    flight: &SphereFlight<S>,
    radius: S,
    nose: S,
    face: &Face<S>,
    tolerance: S,
) -> Option<(S, Crossing)> {
    let (contact, over) = match face {
        Face::Line(line) => {
            (touch_line(flight, radius, nose, line, tolerance), pass_line(flight, line, tolerance))
        }
        Face::Round(round) => {
            (touch_round(flight, radius, nose, round, tolerance), pass_round(flight, round, tolerance))
        }
    };
    let is_in_time = |offset: &S| *offset <= flight.length;
    match (contact.filter(is_in_time), over.filter(is_in_time)) {
        (Some(contact), Some(over)) if over < contact => Some((over, Crossing::Over)),
        (Some(contact), _) => Some((contact, Crossing::Contact)),
        (None, Some(over)) => Some((over, Crossing::Over)),
        (None, None) => None,
    }
}

/// The distance from the nose line in space: `d² + (z − h)² − R²`, d the distance in plan.
fn touch_line<S: Scalar>(
    flight: &SphereFlight<S>,
    radius: S,
    nose: S,
    line: &Line<S>,
    tolerance: S,
) -> Option<S> {
    let across = line.height(flight.plan.position);
    let position = Vec3::new(across, S::ZERO, flight.height - nose);
    let velocity = Vec3::new(line.normal.dot(flight.plan.velocity), S::ZERO, flight.rise);
    let acceleration = Vec3::new(S::ZERO, S::ZERO, flight.lift);
    let gap = position.norm_squared() - radius.squared();
    let gap = squared_gap(position, velocity, acceleration, gap);
    let is_on = |offset: S| {
        let place = flight.plan.position_after(offset);
        line.height(place) > S::ZERO && line.spans(place, tolerance)
    };
    first_contact(&gap, S::from_f64(2.0) * radius * tolerance, is_on)
}

fn pass_line<S: Scalar>(flight: &SphereFlight<S>, line: &Line<S>, tolerance: S) -> Option<S> {
    let slope = line.normal.dot(flight.plan.velocity);
    let across = line.height(flight.plan.position);
    if across < S::ZERO || slope >= S::ZERO {
        return None;
    }
    let offset = across / -slope;
    line.spans(flight.plan.position_after(offset), tolerance).then_some(offset)
}

/// The gap to a round nose in the air: `(|r − c| − ρ)² + (z − h)² − R²`, which is no polynomial.
struct RoundNose<'a, S> {
    flight: &'a SphereFlight<S>,
    round: &'a Round<S>,
    radius: S,
    nose: S,
}

fn touch_round<S: Scalar>(
    flight: &SphereFlight<S>,
    radius: S,
    nose: S,
    round: &Round<S>,
    tolerance: S,
) -> Option<S> {
    let gap = RoundNose { flight, round, radius, nose };
    let spans = |offset: S| round.arc.spans(flight.plan.position_after(offset) - round.arc.center, tolerance);
    let tolerance = S::from_f64(2.0) * radius * tolerance;
    let end = gap.end();
    if gap.value(S::ZERO).abs() <= tolerance {
        let turn = turn_in_contact(&gap, tolerance, end);
        if let Some(turn) = turn.filter(|turn| spans(*turn)) {
            return Some(turn);
        }
    }
    let mut from = S::ZERO;
    // A ball meets a circle's nose from its two sides and from above: no more often than this.
    for _ in 0..4 {
        let offset = first_closing_crossing(&gap, from, end)?;
        if spans(offset) {
            return Some(offset);
        }
        from = offset;
    }
    None
}

/// The time from which on a gap that starts in contact closes, if it does so without having been told from zero; a
/// crossing, which begins in front, is none of those.
fn turn_in_contact<S: Scalar, G: Gap<S>>(gap: &G, tolerance: S, end: S) -> Option<S> {
    if gap.slope(S::ZERO) < S::ZERO {
        return Some(S::ZERO);
    }
    let raised = Raised { gap, by: tolerance + tolerance };
    let closed = first_closing_crossing(&raised, S::ZERO, end)?;
    if first_closing_crossing(gap, S::ZERO, closed).is_some() {
        return None;
    }
    let (mut opening, mut closing) = (S::ZERO, closed.detached());
    loop {
        let middle = opening + (closing - opening) * S::from_f64(0.5);
        if middle <= opening || middle >= closing {
            return Some(closing);
        }
        *(if gap.slope(middle) < S::ZERO { &mut closing } else { &mut opening }) = middle;
    }
}

/// A gap with something added.
struct Raised<'a, S, G> {
    gap: &'a G,
    by: S,
}

impl<S: Scalar, G: Gap<S>> Gap<S> for Raised<'_, S, G> {
    fn value(&self, t: S) -> S {
        self.gap.value(t) + self.by
    }

    fn slope(&self, t: S) -> S {
        self.gap.slope(t)
    }

    fn enclosure(&self, from: S, to: S) -> Enclosure<S> {
        let Enclosure { value, slope } = self.gap.enclosure(from, to);
        Enclosure { value: Interval { lower: value.lower + self.by, upper: value.upper + self.by }, slope }
    }
}

fn pass_round<S: Scalar>(flight: &SphereFlight<S>, round: &Round<S>, tolerance: S) -> Option<S> {
    let spans = |offset: S| round.arc.spans(flight.plan.position_after(offset) - round.arc.center, tolerance);
    if round.arc.radius == S::ZERO {
        return None;
    }
    let side = if round.is_hollow() { -S::ONE } else { S::ONE };
    let gap = circle_gap(flight, round.arc.center, round.arc.radius, side);
    first_contact(&gap, S::ZERO, spans)
}

/// `±(|r − c|² − ρ²)` along a flight through the air, which is straight in plan.
fn circle_gap<S: Scalar>(flight: &SphereFlight<S>, center: Vec2<S>, radius: S, side: S) -> Polynomial<S> {
    let (from, velocity) = (flight.plan.position - center, flight.plan.velocity);
    let gap = side * (from.norm_squared() - radius.squared());
    let slope = side * S::from_f64(2.0) * from.dot(velocity);
    Polynomial::new([gap, slope, side * velocity.norm_squared(), S::ZERO, S::ZERO])
}

/// The offset at which a ball that has flown over a pocket leaves the space above it, and its height then.
pub fn detect_pocket_from_above<S: Scalar>(flight: &SphereFlight<S>, hole: &Hole<S>) -> Option<(S, S)> {
    let gap = circle_gap(flight, hole.center, hole.radius, -S::ONE);
    let offset = first_contact(&gap, S::ZERO, |_| true).filter(|offset| *offset <= flight.length)?;
    Some((offset, flight.position_after(offset).z))
}

impl<S: Scalar> RoundNose<'_, S> {
    /// A time after which the ball is past the nose: the end of the flight, or sooner where it goes on for long.
    fn end(&self) -> S {
        let velocity = self.flight.plan.velocity;
        let speed = velocity.norm();
        let ray = self.flight.plan.position - self.round.arc.center;
        let past = (ray.norm() + self.round.arc.radius + self.radius) * S::from_f64(2.0) / speed;
        if past < self.flight.length { past } else { self.flight.length }
    }

    fn parts(&self, t: S) -> (S, S, S, S) {
        let ray = self.flight.plan.position_after(t) - self.round.arc.center;
        let distance = ray.norm();
        let rate = if distance > S::ZERO { ray.dot(self.flight.plan.velocity) / distance } else { S::ZERO };
        let height = self.flight.position_after(t).z - self.nose;
        (distance - self.round.arc.radius, rate, height, self.flight.velocity_after(t).z)
    }
}

impl<S: Scalar> Gap<S> for RoundNose<'_, S> {
    fn value(&self, t: S) -> S {
        let (across, _, height, _) = self.parts(t);
        across.squared() + height.squared() - self.radius.squared()
    }

    fn slope(&self, t: S) -> S {
        let (across, rate, height, rise) = self.parts(t);
        S::from_f64(2.0) * (across * rate + height * rise)
    }

    /// The distance in plan changes no faster than the speed, and the height no faster than its fastest rate.
    fn enclosure(&self, from: S, to: S) -> Enclosure<S> {
        let half = (to - from) * S::from_f64(0.5);
        let middle = from + half;
        let (across, rate, height, rise) = self.parts(middle);
        let speed = self.flight.plan.velocity.norm();
        let fall = self.flight.lift.abs();
        let rounding = S::from_f64(64.0 * S::EPSILON);
        let far = across.abs() + self.round.arc.radius + height.abs() + self.radius;
        let across = Interval::around(across, speed * half + far * rounding);
        let climb = (rise.abs() + fall * half) * half;
        let height = Interval::around(height, climb + far * rounding);
        let distance = across.lower + self.round.arc.radius;
        // The rate of the distance changes by v²/distance at most, and lies within the speed anyway.
        let turn = if distance > S::ZERO { speed.squared() / distance * half } else { speed };
        let rate = Interval::around(rate, (if turn < speed { turn } else { speed }) + speed * rounding);
        let rise = Interval::around(rise, fall * half + (rise.abs() + speed) * rounding);
        let value = across.times(across).plus(height.times(height));
        let slope = across.times(rate).plus(height.times(rise));
        let two = S::from_f64(2.0);
        let squared = self.radius.squared();
        Enclosure {
            value: Interval { lower: value.lower - squared, upper: value.upper - squared },
            slope: Interval { lower: slope.lower * two, upper: slope.upper * two },
        }
    }
}
