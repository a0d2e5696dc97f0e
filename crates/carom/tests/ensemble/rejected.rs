//! Rows that make no scenario are kept, however many they are; a path that leads to no number is told at once.

use carom::ensemble::{Design, Ending, Ensemble, Inputs, Outcome, Source, Table};
use carom::scenario::{Scenario, ScenarioError, json_schema};
use serde_json::{Value, json};

fn scenario(name: &str) -> Scenario {
    Scenario::from_toml(match name {
        "gas" => include_str!("../../../../scenarios/gas.toml"),
        _ => include_str!("../../../../scenarios/midterm.toml"),
    })
    .unwrap()
}

fn ensemble(
    scenario: &Scenario,
    path: &str,
    numbers: Vec<f64>,
    outcome: Outcome,
) -> Result<Ensemble, ScenarioError> {
    let inputs = Inputs::new(vec![(path.into(), Source::Given(numbers))], None, Design::Independent, 0)?;
    Ensemble::new(scenario, inputs, &[outcome])
}

fn run(ensemble: &Ensemble) -> Table {
    ensemble.run(0..ensemble.inputs().rows(), None, &mut |_| false).unwrap()
}

#[test]
fn a_row_after_thousands_that_make_no_scenario_is_run() {
    let numbers: Vec<f64> = [vec![-1.0; 5000], vec![4.0]].concat();
    for path in ["balls.red.speed", "balls.red.mass", "table.width", "duration"] {
        let table = run(&ensemble(&scenario("midterm"), path, numbers.clone(), Outcome::EndTime).unwrap());
        assert_eq!(table.endings[..5000], [Ending::Rejected; 5000], "{path}");
        assert_eq!((table.problems.len(), table.columns[0][5000].is_nan()), (5000, false), "{path}");
    }
}

#[test]
fn all_rows_may_be_rejected() {
    let numbers = vec![-1.0; 3];
    let table = run(&ensemble(&scenario("midterm"), "balls.red.speed", numbers, Outcome::Events).unwrap());
    assert_eq!(table.endings, [Ending::Rejected; 3]);
    assert_eq!(
        table.problems[2],
        (2, "balls[0].speed: must be zero or positive and finite, got -1.0".to_owned())
    );
    assert!(table.columns.iter().flatten().all(|number| number.is_nan()));
}

#[test]
fn the_columns_are_those_of_the_scenario_and_not_of_rows() {
    let gas = scenario("gas");
    for numbers in [vec![-1.0], vec![40.0], vec![60.0, 40.0]] {
        let ensemble = ensemble(&gas, "gas.n", numbers, Outcome::FinalPosition).unwrap();
        let names: Vec<&str> = ensemble.columns().iter().map(|column| column.name.as_str()).collect();
        assert_eq!((names.len(), names[0], names[99]), (100, "0.x", "49.y"));
    }
}

#[test]
fn a_path_to_no_number_is_told_at_once_with_the_number_of_the_first_row() {
    let said = |path: &str| {
        let numbers = vec![7.5; 3];
        ensemble(&scenario("midterm"), path, numbers, Outcome::EndTime).map(|_| ()).unwrap_err().to_string()
    };
    assert!(said("balls.red.spede").starts_with("balls[0].spede: unknown key; did you mean speed?"));
    assert!(said("balls.rde.speed").contains("no member of the list has the id \"rde\""));
    assert_eq!(said("balls.red.id"), "balls[0].id: expected text, got 7.5");
    assert_eq!(
        said("physics.flight.gravity"),
        "physics.flight.law: missing: expected one of free, field, cloth"
    );
}

/// What the paths are tried with: where it fits nowhere, no number does.
#[test]
fn one_is_in_the_range_of_every_number_of_a_scenario() {
    let mut found = 0;
    let mut open = vec![json_schema()];
    while let Some(value) = open.pop() {
        let bound = |key| value.get(key).and_then(Value::as_f64);
        let (least, above, most) = (bound("minimum"), bound("exclusiveMinimum"), bound("maximum"));
        found += usize::from(least.or(above).or(most).is_some());
        assert!(least.is_none_or(|least| least <= 1.0), "{value}");
        assert!(above.is_none_or(|above| above < 1.0), "{value}");
        assert!(most.is_none_or(|most| most >= 1.0), "{value}");
        match value {
            Value::Object(keys) => open.extend(keys.values()),
            Value::Array(items) => open.extend(items),
            _ => {}
        }
    }
    assert!(found > 20, "{found}");
}

#[test]
fn stepped_gases_of_unlike_sizes_have_their_numbers_in_the_right_columns() {
    let changes = [
        ("gas.periodic", json!([])),
        ("collisions", json!(null)),
        ("duration", json!(1.0)),
        ("method", json!({ "kind": "stepped", "dt": 0.01 })),
    ];
    let gas = scenario("gas").with_values(&changes).unwrap();
    let ensemble = |outcome| ensemble(&gas, "gas.n", vec![60.0, 40.0], outcome).unwrap();
    let (places, counts) = (ensemble(Outcome::FinalPosition), ensemble(Outcome::Events));
    let (table, counted) = (run(&places), run(&counts));
    for row in 0..2 {
        let run = carom::simulate::simulate(&places.scenario(row as u64).unwrap()).unwrap();
        let ends = run.final_state();
        for ball in 0..50 {
            let expected = ends.get(ball).map_or([f64::NAN; 2], |end| [end.position.x, end.position.y]);
            let found = [table.columns[2 * ball][row], table.columns[2 * ball + 1][row]];
            assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "row {row}, ball {ball}");
        }
        assert_eq!(counted.columns[0][row], run.diagnostics.events[0] as f64);
    }
}
