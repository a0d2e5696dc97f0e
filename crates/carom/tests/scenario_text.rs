//! Scenario texts are read and written without loss.

use carom::scenario::Scenario;

const MIDTERM: &str = include_str!("../../../scenarios/midterm.toml");

#[test]
fn json_and_toml_round_trips_give_the_same_scenario() {
    let scenario = Scenario::from_toml(MIDTERM).expect("midterm is right");
    let json = scenario.to_json().expect("a scenario can be written");
    let toml = scenario.to_toml().expect("a scenario can be written");
    assert_eq!(Scenario::from_json(&json), Ok(scenario.clone()));
    assert_eq!(Scenario::from_toml(&toml), Ok(scenario));
}
