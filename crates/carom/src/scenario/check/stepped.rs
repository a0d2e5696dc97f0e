//! What the stepped method asks of a scenario.

use super::{Draft, Findings, Rounded};
use crate::scenario::schema::{BallBall, Flight, Record, Table};

/// Beyond this many steps the time no longer grows by a whole step.
const MOST_STEPS: f64 = 9e15;

/// As many steps, counted for each ball, may be kept: about a gigabyte of them.
const MOST_KEPT: f64 = 1e7;

/// Notes what the stepped method cannot do.
pub(super) fn check_stepped(draft: &Draft<'_>, dt: f64, steps: Option<u64>, findings: &mut Findings) {
    for reason in reasons(draft) {
        findings.add("method.kind", format!("the stepped method {reason}; use the exact one"));
    }
    let is_sound =
        ["duration", "method.steps", "method.dt", "record", "balls"].iter().all(|key| findings.is_sound(key));
    match (draft.duration, steps) {
        _ if !is_sound => {}
        (None, None) => {
            findings.add("duration", "missing: the stepped method needs duration or method.steps")
        }
        (Some(duration), None) if duration / dt > MOST_STEPS => {
            findings
                .add("method.dt", format!("is too short: {} steps to the duration", Rounded(duration / dt)));
        }
        (duration, _) => check_memory(draft, (duration.unwrap_or_default() / dt).ceil(), steps, findings),
    }
}

/// Notes more steps than a run can keep. Hits that restart the step add some; the event budget bounds them.
fn check_memory(draft: &Draft<'_>, to_duration: f64, steps: Option<u64>, findings: &mut Findings) {
    let most = (MOST_KEPT / draft.balls.len().max(1) as f64).floor();
    let count = steps.map_or(to_duration, |steps| steps as f64);
    if draft.record != Record::All || count <= most {
        return;
    }
    let place = if steps.is_some() { "method.steps" } else { "method.dt" };
    let message = format!(
        "makes {} steps, and a run of {} balls keeps {most} at most; with record = \"events\" or \"none\" it keeps none",
        Rounded(count),
        draft.balls.len()
    );
    findings.add(place, message);
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
    match draft.physics.flight() {
        Flight::Free => {}
        Flight::Field { .. } => reasons.push("knows no field"),
        Flight::Cloth { .. } => reasons.push("knows no cloth"),
    }
    if draft.physics.ball_ball() != &BallBall::Elastic {
        reasons.push("knows only elastic collisions of balls");
    }
    reasons
}
