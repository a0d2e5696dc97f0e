//! The scenario that goes on from the end of a run.

use crate::kit::bundled;
use carom::scenario::Scenario;
use carom::simulate::{AnyRun, final_scenario};
use serde_json::json;

fn rest_of(scenario: &Scenario) -> Scenario {
    let run = AnyRun::simulate(scenario, None, &mut || false).unwrap();
    final_scenario(scenario, &run).unwrap()
}

#[test]
fn balls_in_play_lie_where_they_came_to_rest_and_the_others_are_gone() {
    let text = include_str!("../../../../scenarios/nine_ball_break.toml");
    let scenario = Scenario::from_toml(text).unwrap();
    let rest = rest_of(&scenario);
    let ids: Vec<&str> = rest.balls.iter().map(|ball| ball.id.as_str()).collect();
    assert!(ids.contains(&"cue") && ids.contains(&"1") && !ids.contains(&"9"), "{ids:?}");
    assert_eq!((rest.shot.is_none(), rest.rack.is_none()), (true, true));
    assert_eq!((&rest.table, &rest.physics), (&scenario.table, &scenario.physics));
    let expanded = scenario.expanded();
    for ball in &rest.balls {
        assert_eq!((ball.velocity, ball.spin, ball.position.unwrap().up), (None, None, None));
        let before = expanded.balls.iter().find(|other| other.id == ball.id).unwrap();
        assert_ne!(ball.position, before.position);
        assert_eq!(ball.color, before.color);
    }
}

#[test]
fn balls_that_still_move_go_on() {
    let whole = bundled("midterm");
    let cut = whole.with_values(&[("duration", json!(1.3))]).unwrap();
    let rest = rest_of(&cut).with_values(&[("duration", json!(whole.duration.unwrap() - 1.3))]).unwrap();
    let ends = [&whole, &rest].map(|scenario| carom::simulate::simulate(scenario).unwrap().final_state());
    for (one, other) in ends[0].iter().zip(&ends[1]) {
        assert!((one.position - other.position).norm() < 1e-9, "{one:?} and {other:?}");
    }
}

#[test]
fn a_gas_becomes_balls_inside_its_box() {
    let rest = rest_of(&bundled("gas"));
    assert!(rest.gas.is_none());
    let [width, length] =
        ["table.width", "table.length"].map(|path| rest.value(path).unwrap().as_f64().unwrap());
    for ball in &rest.balls {
        let [x, y] = ball.position.unwrap().plan;
        assert!((0.0..=width).contains(&x) && (0.0..=length).contains(&y), "{ball:?}");
    }
}

#[test]
fn a_table_without_balls_is_no_scenario() {
    let alone = "table.preset = 'pool_9ft'\nballs = [{ id = 'cue', position = [0.2, 2.34] }]\n\
                 shot = { V0 = 1, phi_deg = 135 }";
    let scenario = Scenario::from_toml(alone).unwrap();
    let run = AnyRun::simulate(&scenario, None, &mut || false).unwrap();
    let said = final_scenario(&scenario, &run).unwrap_err().to_string();
    assert!(said.contains("balls: must not be empty"), "{said}");
}
