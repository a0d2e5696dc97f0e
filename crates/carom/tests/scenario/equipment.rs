//! Tables that come with carom: each can be read, is what its rules say, and lies under what a scenario writes.

use crate::common::{choices, problems};
use carom::model;
use carom::scenario::schema::{BallBall, BallCushion, Flight, Preset, SlipFriction, Table};
use carom::scenario::{Scenario, System};
use serde_json::json;

fn on(preset: Preset, rest: &str) -> Scenario {
    let text = format!("table.preset = '{}'\n{rest}", preset.name());
    Scenario::from_toml(&text).unwrap_or_else(|error| panic!("{}: {error}", preset.name()))
}

const ONE_BALL: &str = "[[balls]]\nid = 'cue'\nposition = [0.4, 0.4]\n";

#[test]
fn every_preset_can_be_read_and_played_on() {
    let words = choices_of_presets();
    for (preset, word) in Preset::ALL.into_iter().zip(&words) {
        assert_eq!(preset.name(), word, "ALL has the order of the schema");
        assert!(!preset.title().is_empty() && preset.title().len() < 40);
        assert_eq!(
            Scenario::from_toml(&format!("table.preset = '{word}'\n{ONE_BALL}")).unwrap(),
            on(preset, ONE_BALL)
        );
        let expanded = on(preset, ONE_BALL).expanded().into_owned();
        expanded.check().unwrap_or_else(|error| panic!("{word} expanded:\n{error}"));
        assert_eq!(expanded.expanded().as_ref(), &expanded, "{word}: nothing is left to expand");
        assert_eq!(expanded.units.length.as_deref(), Some("m"));
        assert!(matches!(expanded.physics.flight(), Flight::Cloth { .. }));
        let cue = expanded.cue;
        assert!(cue.mass.is_some() && cue.butt_radius.is_some() && cue.miscue_offset.is_some(), "{word}");
    }
    assert_eq!(words.len(), Preset::ALL.len());
}

fn choices_of_presets() -> Vec<String> {
    let schema = carom::scenario::json_schema();
    let words = schema["$defs"]["Preset"]["oneOf"].as_array().unwrap();
    words.iter().map(|word| word["const"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn sizes_are_those_of_the_rules() {
    // Inches and millimetres of the rules; half a millimetre is how exactly they are given here.
    let sizes = [
        (Preset::Pool9ft, 50.0 * 0.0254, 100.0 * 0.0254, 2.25 * 0.0254),
        (Preset::Pool8ft, 46.0 * 0.0254, 92.0 * 0.0254, 2.25 * 0.0254),
        (Preset::Pool8ftHome, 44.0 * 0.0254, 88.0 * 0.0254, 2.25 * 0.0254),
        (Preset::Pool7ft, 39.0 * 0.0254, 78.0 * 0.0254, 2.25 * 0.0254),
        (Preset::Snooker12ft, 1.778, 3.569, 0.0525),
        (Preset::Carom10ft, 1.42, 2.84, 0.0615),
        (Preset::EnglishPool, 36.0 * 0.0254, 72.0 * 0.0254, 0.0508),
    ];
    for (preset, expected_width, expected_length, diameter) in sizes {
        let equipment = preset.equipment();
        let (Table::Rectangle { width, length, .. } | Table::PocketTable { width, length, .. }) =
            &equipment.table
        else {
            panic!("{preset:?} is a rectangle")
        };
        assert!(
            (width - expected_width).abs() < 5e-4 && (length - expected_length).abs() < 5e-4,
            "{preset:?}"
        );
        assert!((2.0 * equipment.ball_defaults.radius.unwrap() - diameter).abs() < 5e-5, "{preset:?}");
    }
    for preset in [Preset::Pool9ft, Preset::Pool8ft] {
        let Table::PocketTable { corner, side, nose_height, .. } = &preset.equipment().table else {
            panic!()
        };
        assert!((0.1143..=0.1175).contains(&corner.width) && (0.127..=0.1302).contains(&side.width));
        assert_eq!((135.0 + corner.angle_deg, 90.0 + side.angle_deg), (142.0, 104.0), "cuts of the rule");
        assert!((0.0357..=0.0369).contains(&nose_height.unwrap()));
        // The shelf runs from the line between the horn tips to the hole.
        let shelf = corner.width / 2.0 + corner.depth - corner.radius;
        assert!((0.0254..=0.0572).contains(&shelf) && (0.0..=0.0096).contains(&(side.depth - side.radius)));
    }
}

#[test]
fn what_is_written_lies_over_the_preset() {
    let plain = on(Preset::Pool9ft, ONE_BALL);
    let text = "table.length = 2.6\ntable.corner.width = 0.13\nball_defaults.mass = 0.2\ncue.mass = 0.6\nunits.time = 'min'\n\
                physics.ball_ball = { law = 'restitution', normal = 0.9 }\nphysics.cluster = 'pairwise'\n";
    let changed = on(Preset::Pool9ft, &format!("{text}{ONE_BALL}"));
    let (before, after) = (plain.expanded(), changed.expanded());
    let Table::PocketTable { width: old_width, corner: old_corner, .. } = &before.table else { panic!() };
    let Table::PocketTable { width, length, corner, .. } = &after.table else { panic!() };
    assert_eq!((width, *length), (old_width, 2.6));
    assert_eq!((corner.width, corner.depth), (0.13, old_corner.depth));
    assert_eq!((after.ball_defaults.mass, after.ball_defaults.radius), (Some(0.2), Some(0.028575)));
    assert_eq!((after.cue.mass, after.cue.tip_radius), (Some(0.6), before.cue.tip_radius));
    assert_eq!((after.units.time.as_deref(), after.units.mass.as_deref()), (Some("min"), Some("kg")));
    assert_eq!(after.physics.ball_ball(), &BallBall::Restitution { normal: 0.9 });
    assert_eq!(after.physics.ball_cushion(), before.physics.ball_cushion());
    // What equals the default of a scenario without a preset counts as written, too.
    let elastic = on(Preset::Pool9ft, &format!("physics.ball_ball.law = 'elastic'\n{ONE_BALL}"));
    assert_eq!(elastic.expanded().physics.ball_ball(), &BallBall::Elastic);
    assert_eq!(Scenario::from_json(&elastic.to_json().unwrap()).unwrap(), elastic);
}

#[test]
fn a_preset_is_kept_as_it_is_written() {
    let scenario = on(Preset::Pool9ft, &format!("rack.game = 'nine_ball'\n{ONE_BALL}"));
    let value = scenario.to_value().unwrap();
    assert_eq!(value["table"], json!({ "preset": "pool_9ft" }));
    assert_eq!(value["rack"], json!({ "game": "nine_ball" }));
    assert_eq!(value["balls"].as_array().unwrap().len(), 1);
    assert!(value.get("physics").is_none() && value.get("ball_defaults").is_none());
    let smaller = scenario.with_values(&[("table.preset", json!("pool_7ft"))]).unwrap();
    assert!(smaller.expanded().table.layout(&mut |_, v: f64| v).size() < 2.2);
}

#[test]
fn pooltools_default_is_its_seven_foot_table() {
    let scenario = on(Preset::Pooltool7ft, ONE_BALL);
    let expanded = scenario.expanded();
    let table = expanded.table.layout(&mut |_, value: f64| value);
    assert_eq!(table.nose, model::Nose { height: Some(0.036576), contact: model::NoseContact::Plan });
    let cushion = |id: &str| table.cushions().find(|cushion| cushion.id == id).unwrap().piece;
    let close =
        |found: f64, expected: f64| assert!((found - expected).abs() < 1e-6, "{found} for {expected}");
    // The ends of pooltool's cushion "3", as its documentation and code give them.
    close(cushion("left_lower").end().y, 0.091002);
    close(cushion("left_lower").start().y, 0.915084);
    assert!(matches!(expanded.physics.flight(), Flight::Cloth { air: false, .. }));
    assert!(matches!(
        expanded.physics.ball_cushion(),
        BallCushion::StrongeCompliant { frequency_ratio: 1.8, .. }
    ));
    let BallBall::Frictional { normal: 0.95, friction, cling: 1.0 } = expanded.physics.ball_ball() else {
        panic!()
    };
    assert_eq!(*friction, SlipFriction::Falling { a: 0.009951, b: 0.108, c: 1.088 });
    let ball = expanded.balls[0].start(0, &expanded.ball_defaults, &mut |_, value: f64| value);
    // 5 μ_sp g / (2 R) with pooltool's μ_sp = 10 · 2/5/9 · R.
    assert!((ball.spin_decay - 2.5 * (10.0 * 0.4 / 9.0) * 9.81).abs() < 1e-12);
}

#[test]
fn an_unknown_preset_and_a_shape_beside_one_are_errors() {
    let found = problems(&format!("table.preset = 'pool_9t'\n{ONE_BALL}"));
    assert!(
        found[0]
            .starts_with("table.preset: unknown value \"pool_9t\"; did you mean pool_9ft? known: pool_9ft, ")
    );
    assert_eq!(
        problems(&format!(
            "table = {{ preset = 'pool_9ft', shape = 'rectangle', width = 1, length = 2 }}\n{ONE_BALL}"
        )),
        ["table.preset: is given beside shape: give only one of them"]
    );
    assert_eq!(
        problems("table.width = 1\nrack.game = 'nine_ball'"),
        [format!("table.shape: missing: expected one of {}; or give preset", choices("Table", "shape"))]
    );
    assert_eq!(
        problems(&format!(
            "table = {{ preset = 'carom_10ft', corner = {{ width = 0.1 }}, cushion_width = 0.05 }}\n{ONE_BALL}"
        )),
        [
            "table.cushion_width: the table \"carom_10ft\" has no pockets",
            "table.corner: the table \"carom_10ft\" has no pockets"
        ]
    );
    assert_eq!(
        problems(&format!("table = {{ preset = 'pool_9ft', radius = 0.1 }}\n{ONE_BALL}")),
        [
            "table.radius: unknown key; known: preset, width, length, cushion_width, corner, side, obstacles, nose_height, \
             nose_contact"
        ]
    );
}

#[test]
fn a_preset_without_its_cloth_is_an_error_that_says_so_once() {
    assert_eq!(
        problems(&format!(
            "duration = 1\nphysics.flight.law = 'free'\ntable.preset = 'pool_9ft'\n{ONE_BALL}"
        )),
        ["table.preset: \"pool_9ft\" needs physics.flight.law = \"cloth\""]
    );
}

#[test]
fn values_of_a_preset_are_found_and_set() {
    let scenario = on(Preset::Pool9ft, ONE_BALL);
    assert_eq!(scenario.value("physics.flight.gravity").unwrap(), json!(9.81));
    assert_eq!(scenario.value("table.width").unwrap(), json!(1.27));
    assert_eq!(scenario.value("table.preset").unwrap(), json!("pool_9ft"));
    assert_eq!(scenario.place("physics.ball_cushion.normal").unwrap(), "physics.ball_cushion.normal");
    assert!(scenario.value("table.wdth").is_err());
    // Setting one number of a law leaves the rest of it as the preset has it.
    let lossy = scenario
        .with_values(&[("physics.ball_cushion.normal", json!(0.5)), ("table.side.width", json!(0.14))])
        .unwrap();
    assert_eq!(lossy.value("physics.ball_cushion.friction").unwrap(), json!(0.2));
    assert_eq!(lossy.value("physics.ball_cushion.normal").unwrap(), json!(0.5));
    assert_eq!(lossy.value("table.side.width").unwrap(), json!(0.14));
    assert_eq!(lossy.value("physics.ball_ball.normal").unwrap(), json!(0.95), "which is still the preset's");
    assert!(lossy.physics.ball_ball.is_none());
}

#[test]
fn numbers_of_a_preset_enter_at_their_places() {
    let scenario = on(Preset::Carom10ft, ONE_BALL);
    let mut places = Vec::new();
    System::<f64>::with(&scenario, &mut |place, value| {
        places.push(place.to_string());
        value
    });
    for place in ["table.width", "table.nose_height", "ball_defaults.radius", "balls[0].position[1]"] {
        assert!(places.iter().any(|found| found == place), "{place} is not among {places:?}");
    }
}
