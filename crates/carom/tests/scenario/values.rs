//! Single values are got and set by their paths, and nothing that is set escapes the check.

use crate::common::{MIDTERM, choices};
use carom::scenario::Scenario;
use proptest::prelude::*;
use serde_json::{Value, json};

fn midterm() -> Scenario {
    Scenario::from_toml(MIDTERM).unwrap()
}

/// What is said to setting one value.
fn set(path: &str, value: Value) -> String {
    midterm().with_values(&[(path, value)]).map_or_else(|error| error.to_string(), |_| "fine".into())
}

/// What is said to asking for a value.
fn get(path: &str) -> String {
    midterm().value(path).map_or_else(|error| error.to_string(), |value| value.to_string())
}

#[test]
fn values_are_found_by_id_and_by_place() {
    assert_eq!(get("balls.red.velocity[0]"), "3.0");
    assert_eq!(get("balls[0].velocity[0]"), "3.0");
    assert_eq!(get("balls.\"red\".velocity"), "[3.0,4.0]");
    assert_eq!(get("physics.ball_cushion.factor"), "0.8");
    assert_eq!(get("ball_defaults.radius"), "0.075");
    assert_eq!(get("duration"), "5.0");
    assert_eq!(midterm().place("balls.blue.position[1]"), Ok("balls[1].position[1]".into()));
}

#[test]
fn several_values_are_set_at_once_and_the_original_stays() {
    let original = midterm();
    let changes = [
        ("balls.red.velocity[0]", json!(3.1)),
        ("duration", json!(10)),
        ("balls.blue.mass", json!(2.5)),
        ("physics.cushions.left", json!({ "law": "elastic" })),
        ("physics.flight", json!({ "law": "field", "acceleration": [0, -1] })),
        ("units.length", json!("m")),
        ("balls[1].color", Value::Null),
    ];
    let changed = original.with_values(&changes).unwrap();
    assert_eq!(original, midterm());
    assert_eq!(changed.balls[0].velocity, Some([3.1, 4.0].into()));
    assert_eq!((changed.duration, changed.balls[1].mass), (Some(10.0), Some(2.5)));
    assert_eq!(changed.units.length.as_deref(), Some("m"));
    assert!(changed.balls[1].color.is_none() && changed.physics.cushions.contains_key("left"));
}

#[test]
fn ends_are_set_as_quickly_and_as_strictly_as_anything() {
    let ends = [
        ("record", json!("none")),
        ("duration", json!(2)),
        ("collisions", json!(7)),
        ("max_events", json!(9)),
    ];
    let mut slowly = midterm().to_value().unwrap();
    for (key, value) in &ends {
        slowly[key] = value.clone();
    }
    assert_eq!(midterm().with_values(&ends).unwrap(), Scenario::from_value(&slowly).unwrap());
    for (key, value) in [
        ("record", json!("all of it")),
        ("duration", json!(-1)),
        ("duration", json!("nan")),
        ("collisions", json!(-1)),
        ("max_events", json!(0)),
        ("max_events", json!(1.5)),
    ] {
        slowly = midterm().to_value().unwrap();
        slowly[key] = value.clone();
        assert_eq!(set(key, value), Scenario::from_value(&slowly).unwrap_err().to_string(), "{key}");
    }
}

#[test]
fn a_path_that_leads_nowhere_says_why() {
    assert_eq!(
        set("balls.rd.radius", json!(1)),
        "balls.rd.radius: no member of the list has the id \"rd\"; did you mean red? known: red, blue"
    );
    assert_eq!(
        set("balls[7].radius", json!(1)),
        "balls[7].radius: there is no [7]: the list has 2 members, counted from 0"
    );
    assert_eq!(
        set("balls.blue.velocity[0]", json!(1)),
        "balls.blue.velocity[0]: velocity is not set: give the whole list"
    );
    assert_eq!(set("duration.x", json!(1)), "duration.x: 5.0 has no parts");
    assert_eq!(set("balls.red[0]", json!(1)), "balls.red[0]: [0] is for lists, and here are keys");
    assert_eq!(
        set("balls.8.radius", json!(1)),
        "balls.8.radius: 8 is not a word: write [8] for a place in a list or \"8\" for an id or key"
    );
    assert!(set("table.widht", json!(1)).starts_with("table.widht: unknown key; did you mean width?"));
    assert!(set("bals.red.radius", json!(1)).starts_with("bals: unknown key; did you mean balls?"));
    assert_eq!(get("balls.red.mass"), "balls.red.mass: mass is not set");
    assert!(get("balls.red.mas").starts_with("balls.red.mas: unknown key mas; did you mean mass?"));
    assert!(get("physics.ball_cushion.normal").ends_with("known: law, factor"));
    let all = midterm().with_values(&[("a[", json!(1)), ("balls.rd.mass", json!(1))]).unwrap_err();
    assert_eq!(all.problems.len(), 2, "all wrong paths are reported: {all}");
}

#[test]
fn what_is_set_is_checked() {
    assert_eq!(set("table.width", json!(0.2)), "balls[1].position: ball \"blue\" lies outside the table");
    assert_eq!(set("balls.red.radius", json!("nan")), "balls[0].radius: must be finite, got nan");
    assert_eq!(
        set("balls.red.velocity[1]", json!("x")),
        "balls[0].velocity[1]: expected a number, got \"x\""
    );
    assert_eq!(
        set("physics.ball_ball.normal", json!(1)),
        "physics.ball_ball.normal: unknown key; known: law"
    );
    assert_eq!(
        set("physics.flight.acceleration", json!([0, 1])),
        format!("physics.flight.law: missing: expected one of {}", choices("Flight", "law"))
    );
    assert_eq!(set("table", Value::Null), "table: missing: expected a set of keys with shape or preset");
}

#[test]
fn ids_that_are_not_words_are_quoted() {
    let scenario =
        Scenario::from_toml(&MIDTERM.replace("\"red\"", "\"8\"").replace("\"blue\"", "\"a.b\"")).unwrap();
    assert_eq!(scenario.value("balls.\"8\".id"), Ok(json!("8")));
    assert_eq!(scenario.place("balls.\"a.b\".position"), Ok("balls[1].position".into()));
}

/// The paths of all numbers inside a value.
fn numbers(value: &Value, path: String) -> Vec<String> {
    match value {
        Value::Object(keys) => {
            let inner = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
            keys.iter().flat_map(|(key, value)| numbers(value, inner(key))).collect()
        }
        Value::Array(items) => items
            .iter()
            .enumerate()
            .flat_map(|(index, item)| numbers(item, format!("{path}[{index}]")))
            .collect(),
        Value::Number(_) => vec![path],
        _ => Vec::new(),
    }
}

fn junk() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<f64>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        (-3..3).prop_map(Value::from),
        Just(json!("nan")),
        Just(json!("inf")),
        "[a-z\"]{0,3}".prop_map(Value::from),
        Just(json!([])),
        Just(json!([1, 2])),
        Just(json!({})),
        Just(json!({ "law": "damping", "shape": "circle", "kind": "stepped", "id": "x" })),
    ]
}

const FILES: [&str; 4] = [
    MIDTERM,
    include_str!("../../../../scenarios/pinball.toml"),
    include_str!("../../../../scenarios/mushroom.toml"),
    include_str!("../../../../scenarios/midterm_stepped.toml"),
];

proptest! {
    #[test]
    fn a_number_that_is_set_is_got_back(file in 0..FILES.len(), which: prop::sample::Index, factor in 0.5..1.5) {
        let scenario = Scenario::from_toml(FILES[file]).unwrap();
        let paths = numbers(&scenario.to_value().unwrap(), String::new());
        let path = which.get(&paths);
        let old = scenario.value(path).unwrap().as_f64().unwrap();
        prop_assert_eq!(&scenario.place(path).unwrap(), path);
        prop_assert_eq!(&scenario.with_values(&[(path, json!(old))]).unwrap(), &scenario);
        match scenario.with_values(&[(path, json!(old * factor))]) {
            Ok(changed) => {
                prop_assert_eq!(changed.value(path).unwrap().as_f64(), Some(old * factor));
                prop_assert_eq!(changed.with_values(&[(path, json!(old))]).unwrap(), scenario);
                let text = changed.to_json().unwrap();
                prop_assert_eq!(Scenario::from_json(&text).unwrap(), changed.clone());
                prop_assert_eq!(Scenario::from_toml(&changed.to_toml().unwrap()).unwrap(), changed);
            }
            Err(error) => prop_assert!(error.problems.iter().all(|problem| !problem.message.is_empty())),
        }
    }

    #[test]
    fn junk_anywhere_is_an_error_or_a_scenario_and_never_a_panic(
        file in 0..FILES.len(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), 0..3usize, junk()), 1..4),
    ) {
        let scenario = Scenario::from_toml(FILES[file]).unwrap();
        let mut value = scenario.to_value().unwrap();
        for (which, up, junk) in changes {
            let paths = numbers(&scenario.to_value().unwrap(), String::new());
            let pointer = format!("/{}", which.get(&paths).replace(['.', '['], "/").replace(']', ""));
            let parts: Vec<&str> = pointer.split('/').collect();
            let pointer = parts[..(parts.len() - up).max(2)].join("/");
            if let Some(place) = value.pointer_mut(&pointer) {
                *place = junk;
            }
        }
        match Scenario::from_value(&value) {
            Ok(scenario) => prop_assert_eq!(scenario.check(), Ok(())),
            Err(error) => prop_assert!(error.problems.iter().all(|problem| !problem.message.is_empty())),
        }
    }
}

#[test]
fn speed_and_direction_are_set_where_a_velocity_stands_in_components() {
    let slower = midterm().with_values(&[("balls.red.speed", json!(2.5))]).unwrap();
    assert_eq!((slower.balls[0].velocity, slower.balls[0].speed), (None, Some(2.5)));
    assert!((slower.balls[0].direction_deg.unwrap() - 53.130_102_354_155_98).abs() < 1e-13);
    let turned = midterm().with_values(&[("balls[0].direction_deg", json!(90))]).unwrap();
    assert_eq!((turned.balls[0].speed, turned.balls[0].direction_deg), (Some(5.0), Some(90.0)));
    // A velocity that is given beside them is a mistake as ever, and one that is not there says nothing.
    assert!(
        set("balls.red", json!({ "id": "red", "velocity": [1, 1], "speed": 1 })).contains("beside speed")
    );
    assert!(set("balls.blue.speed", json!(1)).contains("speed needs a direction"));
}
