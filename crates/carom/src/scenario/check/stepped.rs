//! What the stepped method asks of a scenario.

use super::{Draft, Findings, Rounded};
use crate::scenario::schema::{BallBall, Flight, Table};

/// Beyond this many steps the time no longer grows by a whole step.
const MOST_STEPS: f64 = 9e15;

/// Notes what the stepped method cannot do.
pub(super) fn check_stepped(draft: &Draft<'_>, dt: f64, steps: Option<u64>, findings: &mut Findings) {
    for reason in reasons(draft) {
        findings.add("method.kind", format!("the stepped method {reason}; use the exact one"));
    }
    let is_sound = ["duration", "method.steps", "method.dt"].iter().all(|key| findings.is_sound(key));
    match (draft.duration, steps) {
        _ if !is_sound => {}
        (None, None) => {
            findings.add("duration", "missing: the stepped method needs duration or method.steps")
        }
        (Some(duration), None) if duration / dt > MOST_STEPS => {
            findings
                .add("method.dt", format!("is too short: {} steps to the duration", Rounded(duration / dt)));
        }
        _ => {}
    }
}

fn reasons(draft: &Draft<'_>) -> Vec<&'static str> {
    let mut reasons = Vec::new();
    if let Some(table) = draft.table {
        if !matches!(table, Table::Rectangle { .. }) {
            reasons.push("knows only the rectangle");
        }
        if !table.obstacles().is_empty() {
            reasons.push("knows no obstacles");
        }
    }
    if draft.physics.flight != Flight::Free {
        reasons.push("knows no field");
    }
    if draft.physics.ball_ball != BallBall::Elastic {
        reasons.push("knows only elastic collisions of balls");
    }
    reasons
}
