//! `[gas]`: five lines that make a gas, what they refuse, and that they are worked out once.

use crate::common::problems;
use carom::scenario::Scenario;
use carom::scenario::schema::{Record, Table};
use serde_json::json;

const FIVE_LINES: &str = "collisions = 1000\n[gas]\nn = 200\npacking_fraction = 0.3\n";

fn gas(more: &str) -> Scenario {
    Scenario::from_toml(&format!("{FIVE_LINES}{more}")).unwrap_or_else(|error| panic!("{more}: {error}"))
}

fn refused(more: &str) -> Vec<String> {
    problems(&format!("{FIVE_LINES}{more}"))
}

#[test]
fn five_lines_make_a_periodic_box_of_discs() {
    let scenario = gas("");
    assert_eq!(scenario.record(), Record::None);
    let expanded = scenario.expanded();
    let Table::Rectangle { width, length, .. } = expanded.table else { panic!() };
    assert_eq!(expanded.table.periodic(), [true, true]);
    let covered = 200.0 * core::f64::consts::PI / 4.0 / (width * length);
    assert!((covered - 0.3).abs() < 1e-12, "{covered}");
    let ids: Vec<&str> = expanded.balls.iter().map(|ball| ball.id.as_str()).collect();
    assert_eq!((ids.len(), ids[0], ids[199]), (200, "0", "199"));
    assert!(expanded.balls.iter().all(|ball| ball.radius == Some(0.5) && ball.mass == Some(1.0)));
    assert_eq!((expanded.record(), expanded.gas.is_none()), (Record::None, true));
    expanded.check().unwrap();
    assert_eq!(expanded.expanded().as_ref(), expanded.as_ref(), "nothing is left to expand");
}

#[test]
fn each_key_of_a_gas_does_what_it_says() {
    let sides = |more: &str| match gas(more).expanded().table {
        Table::Rectangle { width, length, .. } => length / width,
        _ => panic!(),
    };
    assert!((sides("aspect = 2") - 2.0).abs() < 1e-12);
    assert_eq!(gas("periodic = ['y']").expanded().table.periodic(), [false, true]);
    assert_eq!(gas("periodic = []").expanded().table.periodic(), [false, false]);
    let first = |more: &str| gas(more).expanded().balls[0].clone();
    assert_ne!(first("seed = 1"), first(""));
    assert_ne!(first("start = 'square'").position, first("").position);
    assert_eq!(first("temperature = 0").velocity.unwrap().plan, [0.0, 0.0]);
    let mixed = gas(
        "sizes.species = [{ fraction = 0.5, diameter = 1 }, { fraction = 0.5, diameter = 1.4, mass = 2 }]",
    );
    let large = mixed
        .expanded()
        .balls
        .iter()
        .filter(|ball| ball.radius == Some(0.7) && ball.mass == Some(2.0))
        .count();
    assert_eq!(large, 100);
    for sizes in [
        "{ distribution = 'uniform', half_width = 0.2, masses = 'area' }",
        "{ distribution = 'normal', polydispersity = 0.1 }",
        "{ distribution = 'log_normal', polydispersity = 0.1, truncation = 2 }",
    ] {
        let drawn = gas(&format!("sizes = {sizes}"));
        let radii: Vec<f64> = drawn.expanded().balls.iter().filter_map(|ball| ball.radius).collect();
        assert!(radii.iter().any(|radius| *radius != radii[0]), "{sizes}");
        assert_eq!(Scenario::from_toml(&drawn.to_toml().unwrap()).unwrap(), drawn, "{sizes}");
    }
}

#[test]
fn what_a_gas_cannot_be_stands_at_its_key() {
    let at = |text: &str| problems(&format!("duration = 1\n[gas]\n{text}"));
    assert_eq!(
        at("n = 100\npacking_fraction = 1.5"),
        ["gas.packing_fraction: must be above 0 and below 1, got 1.5"]
    );
    assert_eq!(at("n = 0\npacking_fraction = 0.5"), ["gas.n: must be at least 1, got 0"]);
    assert_eq!(at("packing_fraction = 0.5"), ["gas.n: missing: expected a whole number"]);
    let dense = at("n = 100\npacking_fraction = 0.95");
    assert!(dense[0].starts_with("gas.packing_fraction: equal discs fill at most"), "{dense:?}");
    let narrow = at("n = 4\npacking_fraction = 0.5\nstart = 'random'");
    assert!(narrow[0].starts_with("gas.periodic: the width of the box is 2.5066 diameters"), "{narrow:?}");
    let start = at("n = 100\npacking_fraction = 0.6\nstart = 'random'");
    assert!(start[0].starts_with("gas.packing_fraction: start = \"random\" reaches 0.5"), "{start:?}");
    let foreign = at("count = 100\npacking_fraction = 0.6");
    assert!(foreign[0].starts_with("gas.count: unknown key; did you mean n?"), "{foreign:?}");
    let unknown = at("n = 100\npacking_fraction = 0.6\nstart = 'hexagon'");
    assert!(
        unknown[0].starts_with("gas.start: unknown value \"hexagon\"; did you mean hexagonal?"),
        "{unknown:?}"
    );
}

#[test]
fn sizes_that_make_no_sense_are_told() {
    let species = |list: &str| refused(&format!("sizes.species = [{list}]"));
    assert_eq!(
        species("{ fraction = 0.5, diameter = 1 }"),
        ["gas.sizes.species: the fractions must sum to 1, these sum to 0.5"]
    );
    assert_eq!(
        species("{ number = 100, diameter = 1 }"),
        ["gas.sizes.species: the numbers must sum to n = 200, these sum to 100"]
    );
    let how_many = "give either fraction or number, which say how many discs are of this kind";
    assert_eq!(species("{ diameter = 1 }"), [format!("gas.sizes.species[0]: {how_many}")]);
    let both = "{ fraction = 1, number = 200, diameter = 1 }";
    assert_eq!(species(both), [format!("gas.sizes.species[0]: {how_many}")]);
    let wide = refused("sizes = { distribution = 'normal', polydispersity = 0.5 }");
    assert!(wide[0].starts_with("gas.sizes.polydispersity: must be zero or more"), "{wide:?}");
    let neither = refused("sizes = { masses = 'area' }");
    assert!(
        neither[0].contains("uniform, normal, log_normal") && neither[0].contains("species"),
        "{neither:?}"
    );
}

#[test]
fn what_a_gas_has_itself_is_not_given_beside_it() {
    let table = "table = { shape = 'rectangle', width = 30, length = 30 }\n";
    let beside = |text: &str| problems(&format!("{text}{FIVE_LINES}"));
    assert_eq!(
        beside(table),
        [
            "table: is given beside gas: a gas has a box of its own, of gas.aspect and gas.periodic; give one of them"
        ]
    );
    assert_eq!(
        beside("balls = [{ id = 'a', position = [1, 1] }]\n"),
        ["balls: is given beside gas: the discs of a gas are all its balls; give one of them"]
    );
    assert_eq!(
        beside("rack = { game = 'nine_ball' }\n"),
        ["rack: is given beside gas: the discs of a gas are all its balls; give one of them"]
    );
    let shot = beside("shot = { V0 = 1, phi_deg = 0 }\n");
    assert!(shot[0].starts_with("shot: is given beside gas"), "{shot:?}");
    let radius = beside("ball_defaults = { radius = 1 }\n");
    assert_eq!(
        radius,
        [
            "ball_defaults.radius: is given beside gas: gas.sizes says how large the discs are; give one of them"
        ]
    );
    assert_eq!(beside("ball_defaults = { color = 'red' }\n"), [""; 0]);
}

#[test]
fn without_a_gas_a_table_is_needed() {
    let found = problems("duration = 1\n[[balls]]\nid = 'a'\nradius = 1\nposition = [0, 0]");
    assert_eq!(found, ["table: missing: expected a set of keys with shape or preset"]);
}

#[test]
fn values_of_a_gas_are_got_and_set_by_their_paths() {
    let scenario = gas("");
    let fewer = scenario.with_values(&[("gas.n", json!(50)), ("gas.start", json!("hexagonal"))]).unwrap();
    assert_eq!(fewer.expanded().balls.len(), 50);
    assert_eq!(fewer.value("gas.n").unwrap(), json!(50));
    assert_eq!(fewer.value("table.shape").unwrap(), json!("rectangle"));
    assert!(fewer.value("balls.7.position").is_err(), "a number is no word");
    assert_eq!(fewer.value("balls[7].id").unwrap(), json!("7"));
    assert_eq!(fewer.place("balls.\"7\".radius").unwrap(), "balls[7].radius");
    let error = scenario.with_values(&[("gas.packing_fraction", json!(0.99))]).unwrap_err();
    assert!(error.to_string().starts_with("gas.packing_fraction: "), "{error}");
    assert_eq!(gas("seed = 0\ntemperature = 1").with_values::<&str>(&[]).unwrap().record(), Record::None);
}

#[test]
fn a_gas_keeps_events_only_where_that_is_asked_for() {
    let kept = |record: &str| Scenario::from_toml(&format!("record = '{record}'\n{FIVE_LINES}")).unwrap();
    assert_eq!(kept("all").record(), Record::All);
    assert_eq!(kept("all").expanded().record(), Record::All);
    assert_eq!(kept("none"), gas(""), "what is so anyway need not be said");
    let asked = gas("").with_values(&[("record", json!("events"))]).unwrap();
    assert_eq!((asked.record(), asked.expanded().record()), (Record::Events, Record::Events));
}

#[test]
fn equal_gases_have_equal_texts_and_equal_bits() {
    let (one, other) = (gas(""), gas(""));
    assert_eq!(one.expanded(), other.expanded());
    assert_eq!(one.to_json().unwrap(), other.to_json().unwrap());
    assert_eq!(one.to_toml().unwrap(), format!("format = 1\n{}", FIVE_LINES.replace("[gas]", "\n[gas]")));
    let mut changed = one.clone();
    changed.gas.as_mut().unwrap().n = 100;
    assert_eq!(changed.expanded().balls.len(), 100, "a key that was changed in a program");
}
