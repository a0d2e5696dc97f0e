//! The rack: whether there is room for one, and its balls.

use super::{Draft, Findings};
use crate::scenario::rack::ground_of;

/// Notes a rack that cannot be set up, and a scenario without any balls.
pub(super) fn check_rack(draft: &Draft<'_>, findings: &mut Findings) {
    if !findings.is_sound("rack") {
        return;
    }
    if draft.rack.is_none() {
        let is_sound = ["balls", "gas", "scenario"].iter().all(|part| findings.is_sound(part));
        if draft.balls.is_empty() && draft.gas.is_none() && !draft.reads_balls && is_sound {
            findings.add("balls", "missing: give at least one ball, or a rack");
        }
        return;
    }
    if draft.table.is_some_and(|table| ground_of(table).is_none()) {
        let shapes = "rectangle or pocket_table, or a preset";
        findings
            .add("rack.game", format!("has its places on a rectangular table: give table.shape = {shapes}"));
    }
    let is_known = findings.is_sound("ball_defaults") && draft.table.is_some();
    if draft.ball_defaults.radius.is_none() && is_known {
        let message = "missing: a rack needs the radius of its balls, here or from a preset";
        findings.add("ball_defaults.radius", message);
    }
}
