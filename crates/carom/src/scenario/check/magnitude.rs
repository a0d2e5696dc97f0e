//! Whether numbers are so large or small that products of them leave the range of double precision.
//!
//! Gaps and their roots multiply up to four lengths, velocities or accelerations, so their fourth powers must neither
//! overflow nor vanish; an energy multiplies a mass with two velocities. 1e77 and 1e-77 are the powers of ten inside
//! the fourth roots of the largest (1.8e308) and smallest (2.2e-308) normal number.

use super::{Draft, Findings};
use crate::model::Table;
use crate::scenario::schema::Flight;
use crate::scenario::system::{CushionLaws, ball_ball_law};
use core::fmt::Display;

/// The largest number that a run computes with; times end here too.
pub const LARGEST: f64 = 1e77;
const SMALLEST: f64 = 1e-77;

/// How many times its size a table may lie from the origin: farther, the round-off of positions would show.
const FARTHEST: f64 = 1e6;

/// The least radius beside the table's reach. A smaller ball is not told from a point by the round-off of positions.
const LEAST_RADIUS: f64 = 1e-12;

/// Notes numbers whose products overflow or vanish.
pub(super) fn check_magnitudes(draft: &Draft<'_>, findings: &mut Findings) {
    if let Some(table) = draft.table {
        table.layout(&mut |place, value| {
            check_number(place, value, findings);
            value
        });
    }
    if let Some(duration) = draft.duration {
        check_large(&"duration", duration, findings);
    }
    if let Flight::Field { acceleration } = draft.physics.flight {
        check_vector(&"physics.flight.acceleration", acceleration, findings);
    }
    let mut parameter = |place: &dyn Display, value: f64| {
        check_size(place, Some(value), findings);
        value
    };
    ball_ball_law(&draft.physics.ball_ball, &mut parameter);
    CushionLaws::new(draft.physics, &mut parameter);
    let defaults = draft.ball_defaults;
    for (key, value) in [("radius", defaults.radius), ("mass", defaults.mass)] {
        check_size(&format_args!("ball_defaults.{key}"), value, findings);
    }
    for (index, ball) in draft.balls() {
        for (key, value) in [("radius", ball.radius), ("mass", ball.mass), ("speed", ball.speed)] {
            check_size(&format_args!("balls[{index}].{key}"), value, findings);
        }
        for (axis, value) in ball.position.into_iter().enumerate() {
            check_large(&format_args!("balls[{index}].position[{axis}]"), value, findings);
        }
        if let Some(velocity) = ball.velocity {
            check_vector(&format_args!("balls[{index}].velocity"), velocity, findings);
        }
    }
}

/// Notes a table too far from the origin for its size, and balls too small for the table.
pub(super) fn check_proportions(draft: &Draft<'_>, table: &Table<f64>, findings: &mut Findings) {
    let (size, reach) = (table.size(), table.reach());
    if reach > FARTHEST * size {
        let times = reach / size;
        findings.add(
            "table",
            format!("lies {times:.0e} times its size from the origin, too far for exact positions: at most {FARTHEST:e} times"),
        );
    }
    let least = LEAST_RADIUS * reach;
    let mut check_radius = |place: &dyn Display, radius: Option<f64>| {
        if let Some(radius) = radius
            && radius > 0.0
            && radius < least
            && findings.is_sound(place)
        {
            findings.add(
                place,
                format!("is too small beside the table: write 0 for a point, or at least {least:e}; got {radius:e}"),
            );
        }
    };
    check_radius(&"ball_defaults.radius", draft.ball_defaults.radius);
    for (index, ball) in draft.balls() {
        check_radius(&format_args!("balls[{index}].radius"), ball.radius);
    }
}

/// A number of the table: sizes must not vanish either, coordinates may.
fn check_number(place: &dyn Display, value: f64, findings: &mut Findings) {
    let text = place.to_string();
    if text.ends_with("_deg") {
        return;
    }
    if ["radius", "width", "length"].iter().any(|size| text.ends_with(size)) {
        check_size(place, Some(value), findings);
    } else {
        check_large(place, value, findings);
    }
}

fn check_vector(place: &dyn Display, value: [f64; 2], findings: &mut Findings) {
    let [x, y] = value.map(f64::abs);
    check_size(place, Some(if x > y { x } else { y }), findings);
}

fn check_size(place: &dyn Display, value: Option<f64>, findings: &mut Findings) {
    let Some(value) = value else { return };
    check_large(place, value, findings);
    if value != 0.0 && value.abs() < SMALLEST && findings.is_sound(place) {
        findings.add(
            place,
            format!("is too small to compute with: write 0, or at least {SMALLEST:e}; got {value:e}"),
        );
    }
}

fn check_large(place: &dyn Display, value: f64, findings: &mut Findings) {
    if value.abs() > LARGEST && findings.is_sound(place) {
        findings.add(place, format!("is too large to compute with: at most {LARGEST:e}; got {value:e}"));
    }
}
