//! Whether numbers are so large or small that products of them leave the range of double precision.
//!
//! Gaps and their roots multiply up to four lengths, velocities or accelerations, so their fourth powers must neither
//! overflow nor vanish; an energy multiplies a mass with two velocities. 1e77 and 1e-77 are the powers of ten inside
//! the fourth roots of the largest (1.8e308) and smallest (2.2e-308) normal number.

use super::{Draft, Findings};
use crate::model::Table;
use crate::scenario::path::Key;
use crate::scenario::schema::{Ball, Flight, Physics, Shot, Vector};
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
    check_physics(draft.physics, findings);
    let defaults = draft.ball_defaults;
    for (key, value) in [("radius", defaults.radius), ("mass", defaults.mass)] {
        check_size(&format_args!("ball_defaults.{key}"), value, findings);
    }
    let frictions = [defaults.sliding_friction, defaults.rolling_friction, defaults.spin_decay];
    for (key, value) in FRICTIONS.into_iter().zip(frictions) {
        check_size(&format_args!("ball_defaults.{key}"), value, findings);
    }
    for (index, ball) in draft.balls() {
        check_ball(draft, index, ball, findings);
    }
    for (key, value) in draft.cue.numbers() {
        check_size(&format_args!("cue.{key}"), Some(value), findings);
    }
    if let Some((key, speed)) = draft.shot.and_then(Shot::speed) {
        check_size(&format_args!("shot.{key}"), Some(speed), findings);
    }
}

/// The keys by which a ball rubs on the cloth.
const FRICTIONS: [&str; 3] = ["sliding_friction", "rolling_friction", "spin_decay"];

fn check_physics(physics: &Physics, findings: &mut Findings) {
    match physics.flight() {
        Flight::Free => {}
        Flight::Field { acceleration } => {
            check_vector(&"physics.flight.acceleration", acceleration.iter().copied(), findings);
        }
        Flight::Cloth { gravity, friction, min_hop, .. } => {
            for (key, value) in
                [("gravity", Some(*gravity)), ("friction", *friction), ("min_hop", Some(*min_hop))]
            {
                check_size(&format_args!("physics.flight.{key}"), value, findings);
            }
        }
    }
    for (key, value) in physics.ball_ball().numbers() {
        check_size(&format_args!("physics.ball_ball.{key}"), Some(value), findings);
    }
    for (key, value) in physics.ball_cushion().numbers() {
        check_size(&format_args!("physics.ball_cushion.{key}"), Some(value), findings);
    }
    for (id, law) in &physics.cushions {
        for (key, value) in law.numbers() {
            check_size(&format_args!("physics.cushions.{}.{key}", Key(id)), Some(value), findings);
        }
    }
}

fn check_ball(draft: &Draft<'_>, index: usize, ball: &Ball, findings: &mut Findings) {
    let sizes = [("radius", ball.radius), ("mass", ball.mass), ("speed", ball.speed)];
    let frictions = [ball.sliding_friction, ball.rolling_friction, ball.spin_decay];
    for (key, value) in sizes.into_iter().chain(FRICTIONS.into_iter().zip(frictions)) {
        check_size(&draft.place(index, key), value, findings);
    }
    let position = ball.position.iter().flat_map(Vector::components);
    for (axis, value) in position.enumerate() {
        check_large(&draft.place(index, &format!("position[{axis}]")), value, findings);
    }
    if let Some(velocity) = ball.velocity {
        check_vector(&draft.place(index, "velocity"), velocity.components(), findings);
    }
    if let Some(spin) = ball.spin {
        check_vector(&draft.place(index, "spin"), spin.into_iter(), findings);
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
        check_radius(&draft.place(index, "radius"), ball.radius);
    }
}

/// A number of the table: sizes must not vanish either, coordinates may.
fn check_number(place: &dyn Display, value: f64, findings: &mut Findings) {
    let text = place.to_string();
    if text.ends_with("_deg") {
        return;
    }
    if ["radius", "width", "length", "height"].iter().any(|size| text.ends_with(size)) {
        check_size(place, Some(value), findings);
    } else {
        check_large(place, value, findings);
    }
}

fn check_vector(place: &dyn Display, value: impl Iterator<Item = f64>, findings: &mut Findings) {
    let largest = value.map(f64::abs).fold(0.0, |most, part| if part > most { part } else { most });
    check_size(place, Some(largest), findings);
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
