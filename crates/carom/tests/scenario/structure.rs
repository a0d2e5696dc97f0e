//! Keys, types and ranges: every departure from the schema is reported at its place.

use crate::common::{MIDTERM, broken, choices, on_table, problems, with_obstacles};
use carom::scenario::{Scenario, json_schema};

#[test]
fn an_empty_text_is_said_to_be_empty() {
    let empty = "scenario: is empty: it needs at least a table and a ball";
    assert_eq!(problems(""), [empty]);
    assert_eq!(problems("# nothing\n"), [empty]);
    for text in ["", " \n", "{}"] {
        assert_eq!(Scenario::from_json(text).unwrap_err().to_string(), empty);
    }
}

#[test]
fn a_text_that_cannot_be_read_gives_line_and_column() {
    assert!(problems("format = 1\ntitle = \n")[0].starts_with("line 2, column 9: "));
    assert_eq!(problems("format = 1\nformat = 1\n"), ["line 2, column 1: duplicate key"]);
    let json = |text| Scenario::from_json(text).unwrap_err().to_string();
    assert_eq!(json("{\n\"format\": 1,\n}"), "line 3, column 1: trailing comma");
    assert_eq!(json("{\"a\": 1, \"a\": 2}"), "line 1, column 16: the key \"a\" is given twice");
    assert_eq!(json("{\"format\": NaN}"), "line 1, column 12: expected value");
    assert_eq!(json("[1]"), "scenario: expected a set of keys, got [1]");
}

#[test]
fn a_newer_format_is_refused_by_name_and_nothing_else_is_said() {
    let message = "format: format 2 is newer than format 1, the newest known here";
    assert_eq!(problems("format = 2\nquantum = true\n"), [message]);
    assert_eq!(broken("format = 1", "format = 0"), ["format: must be at least 1, got 0"]);
    assert_eq!(broken("format = 1", ""), [""; 0], "an absent format means 1");
}

#[test]
fn an_unknown_key_is_reported_with_the_nearest_and_all_known_ones() {
    let known = "known: id, radius, mass, sliding_friction, rolling_friction, spin_decay, position, velocity, spin, speed, \
                 direction_deg, color";
    assert_eq!(
        broken("velocity = [3.0", "velocty = [3.0"),
        [format!("balls[0].velocty: unknown key; did you mean velocity? {known}")]
    );
    assert_eq!(
        broken("law = \"elastic\"", "law = \"elastic\"\nnormal = 1"),
        ["physics.ball_ball.normal: unknown key; known: law"]
    );
}

#[test]
fn a_bare_angle_is_an_error_that_names_direction_deg() {
    for key in ["phi", "direction", "angle"] {
        let found = broken("velocity = [3.0, 4.0]", &format!("{key} = 1\nspeed = 5"));
        assert!(
            found[0].starts_with(&format!("balls[0].{key}: unknown key; did you mean direction_deg?")),
            "{found:?}"
        );
    }
}

#[test]
fn wrong_types_are_reported_with_what_was_wanted() {
    assert_eq!(broken("width = 1.0", "width = \"1.0\""), ["table.width: expected a number, got \"1.0\""]);
    assert_eq!(broken("width = 1.0", "width = true"), ["table.width: expected a number, got true"]);
    assert_eq!(
        broken("width = 1.0", "width = 2026-01-01"),
        ["table.width: expected a number, got \"2026-01-01\""]
    );
    assert_eq!(
        broken("[3.0, 4.0]", "[3.0, 4.0, 5.0, 6.0]"),
        ["balls[0].velocity: expected a list of 2 or 3 numbers, got 4 of them"]
    );
    assert_eq!(broken("[3.0, 4.0]", "[3.0, 'a']"), ["balls[0].velocity[1]: expected a number, got \"a\""]);
    assert_eq!(broken("[3.0, 4.0]", "7"), ["balls[0].velocity: expected a list of 2 or 3 numbers, got 7"]);
    assert_eq!(broken("id = \"red\"", "id = 5"), ["balls[0].id: expected text, got 5"]);
    assert_eq!(broken("id = \"red\"", "id = ''"), ["balls[0].id: must not be empty"]);
    assert_eq!(
        broken("duration = 5.0", "collisions = 5.5"),
        ["collisions: expected a whole number, got 5.5"]
    );
    assert_eq!(broken("duration = 5.0", "collisions = 1e5"), [""; 0], "a whole number may be written 1e5");
    assert_eq!(broken("\"crimson\"", "5"), ["balls[0].color: expected text or a list of 3 numbers, got 5"]);
}

#[test]
fn missing_keys_are_reported_with_what_is_wanted() {
    assert_eq!(
        problems("duration = 1"),
        [
            "table: missing: expected a set of keys with shape or preset",
            "balls: missing: give at least one ball, or a rack"
        ]
    );
    assert_eq!(broken("width = 1.0", ""), ["table.width: missing: expected a number"]);
    assert_eq!(
        broken("position = [0.1, 0.1]", ""),
        ["balls[0].position: missing: give ball \"red\" a position, [x, y]"]
    );
    assert_eq!(
        broken("shape = \"rectangle\"", ""),
        [format!("table.shape: missing: expected one of {}; or give preset", choices("Table", "shape"))]
    );
    assert_eq!(
        problems("duration = 1\nballs = []\n[table]\nshape = 'circle'\nradius = 1"),
        ["balls: must not be empty"]
    );
}

#[test]
fn unknown_words_are_reported_with_the_nearest_and_all_known_ones() {
    assert_eq!(
        broken("\"rectangle\"", "\"rectangel\""),
        [format!(
            "table.shape: unknown shape \"rectangel\"; did you mean rectangle? known: {}",
            choices("Table", "shape")
        )]
    );
    assert_eq!(
        broken("\"damping\"", "\"dampin\""),
        [format!(
            "physics.ball_cushion.law: unknown law \"dampin\"; did you mean damping? known: {}",
            choices("BallCushion", "law")
        )]
    );
    assert_eq!(
        broken("format = 1", "record = 'al'"),
        ["record: unknown value \"al\"; did you mean all? known: all, events, none"]
    );
    assert_eq!(broken("format = 1", "record = 3"), ["record: expected one of all, events, none, got 3"]);
}

#[test]
fn pieces_and_obstacles_are_told_apart_by_their_keys() {
    let pieces = "shape = 'path'\npieces = [{ lin = [[0, 0], [1, 0]] }, \
                  { line = [[1, 0], [1, 1]], arc = { center = [0, 0], radius = 1, from_deg = 0, to_deg = 3 } }]";
    assert_eq!(
        on_table(pieces),
        [
            "table.pieces[0]: needs one of the keys line, arc; did you mean line instead of lin?",
            "table.pieces[1]: has line and arc: give only one of them",
        ]
    );
    assert_eq!(
        with_obstacles("{ circl = { center = [0.8, 0.8], radius = 0.1 } }"),
        [
            "table.obstacles[0]: needs one of the keys circle, path, wall; did you mean circle instead of circl?"
        ]
    );
}

#[test]
fn numbers_out_of_their_range_are_reported() {
    let at = |part: &str, by: &str| broken(part, by).join("\n");
    let radius = "ball_defaults.radius: must be zero or positive and finite, got -0.075";
    assert_eq!(at("radius = 0.075", "radius = -0.075"), radius);
    assert_eq!(at("width = 1.0", "width = 0.0"), "table.width: must be positive and finite, got 0.0");
    assert_eq!(at("length = 2.0", "length = -2"), "table.length: must be positive and finite, got -2");
    assert_eq!(
        at("id = \"red\"", "id = \"red\"\nmass = 0"),
        "balls[0].mass: must be positive and finite, got 0"
    );
    assert_eq!(
        at("factor = 0.8", "factor = 1.8"),
        "physics.ball_cushion.factor: must be between 0 and 1, got 1.8"
    );
    assert_eq!(
        at("duration = 5.0", "duration = -5"),
        "duration: must be zero or positive and finite, got -5"
    );
    assert_eq!(at("duration = 5.0", "collisions = -5"), "collisions: must be zero or positive, got -5");
    assert_eq!(at("duration = 5.0", "duration = 5\nmax_events = 0"), "max_events: must be at least 1, got 0");
    let cushion = "law = \"restitution\"\nnormal = -0.1\ntangential = 1.5";
    assert_eq!(
        broken("law = \"damping\"\nfactor = 0.8", cushion),
        [
            "physics.ball_cushion.normal: must be between 0 and 1, got -0.1",
            "physics.ball_cushion.tangential: must be between 0 and 1, got 1.5",
        ]
    );
    let method = "[method]\nkind = 'stepped'\ndt = 0\n[ball_defaults]";
    assert_eq!(at("[ball_defaults]", method), "method.dt: must be positive and finite, got 0");
}

#[test]
fn numbers_that_are_not_finite_are_problems_at_their_places() {
    assert_eq!(
        broken("position = [0.1, 0.1]", "position = [nan, -inf]"),
        ["balls[0].position[0]: must be finite, got nan", "balls[0].position[1]: must be finite, got -inf",]
    );
    assert_eq!(broken("duration = 5.0", "duration = inf"), ["duration: must be finite, got inf"]);
    let json = Scenario::from_toml(MIDTERM).unwrap().to_json().unwrap().replace("0.075", "\"nan\"");
    let error = Scenario::from_json(&json).unwrap_err().to_string();
    assert_eq!(error, "ball_defaults.radius: must be finite, got nan");
}

#[test]
fn a_scenario_built_in_a_program_is_checked_the_same_way() {
    let mut scenario = Scenario::from_toml(MIDTERM).unwrap();
    assert_eq!(scenario.check(), Ok(()));
    scenario.balls[1].radius = Some(f64::NAN);
    scenario.balls[0].mass = Some(-1.0);
    assert_eq!(
        scenario.check().unwrap_err().to_string(),
        "balls[0].mass: must be positive and finite, got -1.0\nballs[1].radius: must be finite, got nan"
    );
}

#[test]
fn null_means_absent() {
    let json = Scenario::from_toml(MIDTERM).unwrap().to_json().unwrap();
    let with_null = json.replacen("\"duration\"", "\"collisions\": null, \"duration\"", 1);
    assert_eq!(Scenario::from_json(&with_null), Scenario::from_json(&json));
}

#[test]
fn the_schema_is_ready_for_an_editor() {
    let schema = json_schema();
    assert_eq!(schema["title"], "Carom scenario");
    assert_eq!(schema["$id"], "urn:carom:scenario:1");
    assert_eq!(schema["properties"]["duration"]["type"], "number");
    assert_eq!(schema["$defs"]["Ball"]["properties"]["color"]["$ref"], "#/$defs/Color");
    assert!(!schema.to_string().contains("null"), "a file has no nulls");
    let described = |keys: &serde_json::Value| {
        keys["properties"].as_object().unwrap().values().all(|key| key["description"].is_string())
    };
    assert!(
        described(schema) && described(&schema["$defs"]["Ball"]) && described(&schema["$defs"]["Physics"])
    );
}
