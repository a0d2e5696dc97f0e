//! Periodic tables: what they do not go with, and whether they are wide enough.

use super::{Draft, Findings, Rounded};
use crate::gas::PERIODIC_DIAMETERS;
use crate::scenario::schema::{Axis, Ball, Method, Table};

/// Notes what is wrong with a periodic table.
pub(super) fn check_periodic(draft: &Draft<'_>, findings: &mut Findings) {
    let Some(Table::Rectangle { width, length, periodic, .. }) = draft.table else { return };
    if periodic.is_empty() {
        return;
    }
    let place = if draft.gas.is_some() { "gas.periodic" } else { "table.periodic" };
    if let Some(axis) = [Axis::X, Axis::Y].into_iter().find(|axis| count(periodic, *axis) > 1)
        && findings.is_sound(place)
    {
        findings.add(place, format!("names {} twice", axis.name()));
    }
    for beside in not_beside(draft) {
        findings.add(place, format!("a table with periodic sides goes with no {beside}"));
    }
    if draft.method != &Method::Exact {
        findings.add("method.kind", "the stepped method knows no periodic sides; use the exact one");
    }
    check_room(draft, [("width", *width, Axis::X), ("length", *length, Axis::Y)], findings);
}

fn count(axes: &[Axis], wanted: Axis) -> usize {
    axes.iter().filter(|axis| **axis == wanted).count()
}

fn not_beside(draft: &Draft<'_>) -> Vec<&'static str> {
    let beside = [
        (draft.physics.has_cloth(), "cloth (physics.flight.law)"),
        (draft.table.is_some_and(|table| !table.obstacles().is_empty()), "obstacles (table.obstacles)"),
    ];
    beside.into_iter().filter(|(is_given, _)| *is_given).map(|(_, what)| what).collect()
}

/// Notes sides on which a ball would be seen on the left and on the right of another one.
fn check_room(draft: &Draft<'_>, sides: [(&str, f64, Axis); 2], findings: &mut Findings) {
    if draft.gas.is_some() || !["balls", "ball_defaults", "table"].iter().all(|part| findings.is_sound(part))
    {
        return;
    }
    let radius = |ball: &Ball| ball.radius.or(draft.ball_defaults.radius);
    let largest = draft.balls().filter_map(|(_, ball)| radius(ball)).fold(0.0, f64::max);
    let least = PERIODIC_DIAMETERS * 2.0 * largest;
    for (key, size, axis) in sides {
        if draft.table.is_some_and(|table| table.periodic()[axis as usize]) && size < least {
            let message = format!(
                "must be more than 3 diameters of the largest ball, {}, where {} is periodic; got {size}",
                Rounded(6.0 * largest),
                axis.name()
            );
            findings.add(format_args!("table.{key}"), message);
        }
    }
}
