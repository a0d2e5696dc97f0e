//! A gas: whether it can be made, and that nothing is given beside it that it has itself.

use super::{Draft, Findings};
use crate::scenario::schema::{Gas, Sizes, Table};

/// Notes what is wrong with a gas, and a scenario without a table or a gas.
pub(super) fn check_gas(draft: &Draft<'_>, findings: &mut Findings) {
    let Some(gas) = draft.gas else {
        let is_absent = draft.written.is_some_and(|table| *table == Table::Absent);
        if is_absent
            && !draft.reads_balls
            && ["table", "gas", "scenario"].iter().all(|part| findings.is_sound(part))
        {
            let message = "missing: expected a set of keys with shape or preset";
            findings.add("table", message);
        }
        return;
    };
    check_beside(draft, findings);
    check_species(gas, findings);
    if !findings.is_sound("gas") {
        return;
    }
    if let Some(error) = gas.problem() {
        // An error begins with the key that it is about.
        let text = error.to_string();
        let (key, message) = text.split_once(": ").unwrap_or(("n", &text));
        findings.add(format_args!("gas.{key}"), message);
    }
}

fn check_beside(draft: &Draft<'_>, findings: &mut Findings) {
    let has_table = draft.written.is_some_and(|table| *table != Table::Absent);
    let defaults = draft.ball_defaults;
    let beside = [
        ("table", has_table, "a gas has a box of its own, of gas.aspect and gas.periodic"),
        ("balls", draft.written_balls > 0, "the discs of a gas are all its balls"),
        ("rack", draft.rack.is_some(), "the discs of a gas are all its balls"),
        ("shot", draft.shot.is_some(), "a gas has no cue ball"),
        ("ball_defaults.radius", defaults.radius.is_some(), "gas.sizes says how large the discs are"),
        ("ball_defaults.mass", defaults.mass.is_some(), "gas.sizes says how heavy the discs are"),
    ];
    for (place, is_given, why) in beside {
        if is_given && findings.is_sound(place) {
            findings.add(place, format!("is given beside gas: {why}; give one of them"));
        }
    }
}

fn check_species(gas: &Gas, findings: &mut Findings) {
    let Some(Sizes::Species(mixture)) = &gas.sizes else { return };
    for (index, species) in mixture.species.iter().enumerate() {
        let place = format!("gas.sizes.species[{index}]");
        if species.fraction.is_some() == species.number.is_some() && findings.is_sound(&place) {
            findings.add(place, "give either fraction or number, which say how many discs are of this kind");
        }
    }
}
