//! `[balls_from]`: the engine opens no file, and takes what a reader gives.

use crate::common::problems;
use carom::scenario::schema::{BallsFrom, BallsSource};
use carom::scenario::{BallsRead, Problem, Scenario, ScenarioError};
use serde_json::json;

const TEXT: &str = "duration = 1.0\n[balls_from]\npath = 'start.gsd'\nframe = 3\n";

fn read(_: &BallsFrom) -> Result<BallsRead, ScenarioError> {
    Ok(BallsRead {
        ids: None,
        positions: vec![[1.0, 1.0], [3.0, 2.0]],
        velocities: Some(vec![[1.0, 0.0], [0.0, -1.0]]),
        radii: vec![0.5, 0.25],
        masses: vec![1.0, 2.0],
        size: [4.0, 5.0],
        periodic: [true, false],
        frame: 3,
        sha256: "00".into(),
    })
}

#[test]
fn without_a_reader_a_file_is_refused() {
    let found = problems(TEXT);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("balls_from.path: the file is read where"), "{found:?}");
}

#[test]
fn balls_and_box_are_those_that_the_reader_gives() {
    let scenario = Scenario::from_toml_with(TEXT, &[], &mut read).unwrap();
    assert_eq!((scenario.balls_from.is_none(), scenario.balls.len()), (true, 2));
    assert_eq!(scenario.balls[1].radius, Some(0.25));
    assert_eq!(scenario.table.periodic(), [true, false]);
    let source = BallsSource { path: "start.gsd".into(), frame: 3, sha256: "00".into(), table: true };
    assert_eq!(scenario.balls_source, Some(source));
    scenario.check().unwrap();
    assert_eq!(Scenario::from_toml(&scenario.to_toml().unwrap()).unwrap(), scenario);
}

#[test]
fn values_are_changed_before_the_file_is_read() {
    let mut asked = None;
    let mut reader = |from: &BallsFrom| {
        asked = Some((from.frame, from.radius));
        read(from)
    };
    let values = [("balls_from.frame".to_owned(), json!(1)), ("balls_from.radius".to_owned(), json!(0.1))];
    Scenario::from_toml_with(TEXT, &values, &mut reader).unwrap();
    assert_eq!(asked, Some((1, Some(0.1))));
    let wrong = Scenario::from_toml_with(TEXT, &[("balls_from.frmae".into(), json!(1))], &mut read);
    assert!(wrong.unwrap_err().to_string().contains("frame"));
}

#[test]
fn problems_of_the_reader_come_with_all_others() {
    let mut reader = |_: &BallsFrom| Err(Problem::new("balls_from.path", "no such file").into());
    let text = TEXT.replace("1.0", "-1.0");
    let error = Scenario::from_toml_with(&text, &[], &mut reader).unwrap_err();
    let places: Vec<&str> = error.problems.iter().map(|problem| problem.place.as_str()).collect();
    assert_eq!(places, ["duration", "balls_from.path"]);
}

#[test]
fn a_file_is_not_read_where_the_keys_are_wrong() {
    let mut reader = |_: &BallsFrom| -> Result<BallsRead, ScenarioError> { panic!("nothing is to be read") };
    let text = format!("{TEXT}mass = 0\n");
    assert!(Scenario::from_toml_with(&text, &[], &mut reader).is_err());
}
