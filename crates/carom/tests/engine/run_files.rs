//! What is wrong with a text that is no saved run is said with its place.

use crate::kit::bundled;
use carom::run::{Plane, from_json, to_json};
use carom::simulate::simulate;

/// What is said about the saved run of the exercise with `old` replaced by `new` where it stands first.
fn complaint(old: &str, new: &str) -> String {
    let scenario = bundled("midterm");
    let text = to_json(&scenario, &simulate(&scenario).unwrap()).unwrap();
    assert!(text.contains(old), "{old}");
    complaint_about(&text.replacen(old, new, 1))
}

fn complaint_about(text: &str) -> String {
    from_json::<Plane>(text).map(|_| ()).unwrap_err().to_string()
}

#[test]
fn what_is_malformed_is_named_with_its_place() {
    for (old, new, expected) in [
        (r#""ball_ball","ball_cushion""#, r#""ball_ball","ball""#, "events.kind[4]: unknown variant `ball`"),
        (r#""start":[0.0,"#, r#""start":[null,"#, "flights.start[0]: invalid type: null"),
        (r#""end_time":5.0"#, r#""end_time":1e999"#, "end_time: number out of range"),
        (r#""status":"time_limit","#, "", "missing field `status`"),
        (r#""kind":["ball_cushion","#, r#""kind":["#, "events: the columns have unequal lengths"),
        (r#""ball":[0,1,"#, r#""ball":[0,2,"#, "flights: a ball that the scenario does not have"),
    ] {
        let said = complaint(old, new);
        assert!(said.starts_with(&format!("not a saved run: {expected}")), "{said}");
    }
    let said = complaint(r#""factor":0.8"#, r#""factor":-0.8"#);
    assert!(said.starts_with("the scenario of the saved run: physics.ball_cushion.factor"), "{said}");
}

#[test]
fn what_is_no_run_at_all_is_refused() {
    for (text, expected) in [
        ("", "EOF while parsing a value"),
        ("[]", "invalid length 0"),
        ("{}", "missing field `format`"),
        (r#"{"format":1}"#, "missing field `carom`"),
    ] {
        let said = complaint_about(text);
        assert!(said.starts_with(&format!("not a saved run: {expected}")), "{said}");
    }
    assert!(complaint("}", "").starts_with("not a saved run: "));
}

#[test]
fn a_newer_format_is_refused_by_its_number_whatever_is_in_it() {
    for text in [r#"{"format":99}"#, r#"{"format":4294967297,"events":"none"}"#] {
        assert!(complaint_about(text).contains("newer than the newest one this version reads, 1"), "{text}");
    }
    assert!(complaint(r#""format":1"#, r#""format":2"#).starts_with("the run was saved in format 2"));
}
