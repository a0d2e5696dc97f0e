//! Far, small, slow and late: where numbers run out, a run still says what is so, or the scenario is refused.
use crate::kit::scenes::{Ball, ball, rectangle, scenario, try_scenario};
use crate::kit::{bundled, start};
use carom::run::{Kind, Status};
use carom::scenario::Scenario;
use carom::simulate::simulate;
use serde_json::{Value, json};

/// A unit square whose lower left corner is at (x, x).
fn square_at(x: f64) -> Value {
    let corners = [[x, x], [x + 1.0, x], [x + 1.0, x + 1.0], [x, x + 1.0]];
    let pieces: Vec<Value> = (0..4).map(|k| json!({ "line": [corners[k], corners[(k + 1) % 4]] })).collect();
    json!({ "shape": "path", "pieces": pieces })
}

/// Two balls that meet off centre on a square far from the origin, for 20 hits of a cushion or so.
fn far_scenario(x: f64) -> Result<Scenario, String> {
    let text = json!({ "table": square_at(x), "duration": 5, "balls": [
        { "id": "a", "radius": 0.1, "position": [x + 0.25, x + 0.5], "velocity": [1, 0.25] },
        { "id": "b", "radius": 0.1, "position": [x + 0.75, x + 0.5625], "velocity": [-0.8125, 0.5] } ] });
    Scenario::from_json(&text.to_string()).map_err(|error| error.to_string())
}

#[test]
fn a_table_far_from_the_origin_gives_the_same_run_to_the_round_off_of_its_coordinates() {
    let near = simulate(&far_scenario(0.0).unwrap()).unwrap();
    for x in [1e3, 3e5, 9e5] {
        let far = simulate(&far_scenario(x).unwrap()).unwrap_or_else(|error| panic!("{x}: {error}"));
        assert_eq!(far.log.events.len(), near.log.events.len(), "{x}");
        for (a, b) in near.log.events.iter().zip(&far.log.events) {
            // A position is off by x ε; some ten reflections off balls multiply that by ten or so each.
            let off = (a.time - b.time).abs();
            assert!(
                (a.kind, a.ball_b, a.cushion) == (b.kind, b.ball_b, b.cushion) && off < 1e-10 * x,
                "{x}: {off}"
            );
        }
    }
    let error = far_scenario(1e7).unwrap_err();
    assert!(error.contains("table: lies 1e7 times its size from the origin"), "{error}");
}

#[test]
fn a_ball_too_small_for_the_table_is_refused() {
    let two = |radius| [ball(radius, [0.3, 0.5], [0.0, 0.0]), ball(radius, [0.7, 0.5], [-1.0, 0.0])];
    let with = |radius| try_scenario(&rectangle(1.0, 2.0), &json!({}), &two(radius));
    let run = simulate(&with(1e-11).unwrap().with_values(&[("duration", json!(2.0))]).unwrap()).unwrap();
    assert_eq!(run.log.events[0].kind, Kind::BallBall);
    assert!(run.digest().is_some());
    let error = with(1e-17).unwrap_err();
    assert!(error.contains("balls[0].radius: is too small beside the table"), "{error}");
}

#[test]
fn balls_that_slow_down_for_ever_come_to_rest_before_their_speeds_run_out_of_numbers() {
    let endless =
        bundled("midterm").with_values(&[("duration", Value::Null), ("collisions", json!(100_000))]);
    let run = simulate(&endless.unwrap()).unwrap();
    assert_eq!(run.status, Status::AtRest);
    assert!(run.end_time > 1e76 && run.end_time <= 1e77, "{}", run.end_time);
    assert!(run.digest().is_some());
    let error = bundled("midterm").with_values(&[("duration", json!(1e160))]).unwrap_err().to_string();
    assert!(error.contains("duration: is too large to compute with"), "{error}");
}

#[test]
fn both_balls_of_a_coming_collision_know_of_it() {
    let mut simulation = start(&bundled("midterm"));
    for _ in 0..3 {
        simulation.step(&mut carom::run::Nothing).unwrap();
    }
    let [red, blue] = simulation.candidates()[..] else { panic!("two balls") };
    assert_eq!((red.ball, red.other, blue.ball, blue.other), (0, Some(1), 1, Some(0)));
    assert_eq!((red.kind, red.time, red.gap), (blue.kind, blue.time, blue.gap));
    assert_eq!(blue.kind, Some(Kind::BallBall));
}

#[test]
fn a_ball_that_nothing_will_meet_has_no_coming_event() {
    let balls: [Ball; 2] = [ball(0.05, [0.2, 0.5], [0.0, 1.0]), ball(0.05, [0.7, 0.5], [0.0, 0.0])];
    let coming = start(&scenario(&rectangle(1.0, 2.0), &json!({}), &balls)).candidates();
    assert_eq!(coming[0].kind, Some(Kind::BallCushion));
    assert_eq!((coming[1].kind, coming[1].cushion, coming[1].time), (None, None, f64::INFINITY));
}

#[test]
fn time_that_is_no_number_is_never_reached() {
    let mut simulation = start(&bundled("midterm"));
    simulation.run_until(f64::NAN, &mut carom::run::Nothing).unwrap();
    assert_eq!((simulation.time(), simulation.status()), (0.0, None));
}

#[test]
fn points_never_meet_with_the_stepped_method_either() {
    for normal in ["before", "contact"] {
        let balls = [ball(0.0, [0.25, 0.5], [1.0, 0.0]), ball(0.0, [0.75, 0.5], [-1.0, 0.0])];
        let method = json!({ "kind": "stepped", "dt": 0.25, "normal": normal });
        let scenario = scenario(&rectangle(1.0, 2.0), &json!({}), &balls);
        let run = simulate(&scenario.with_values(&[("method", method), ("duration", json!(0.5))]).unwrap())
            .unwrap();
        assert!(run.log.events.is_empty() && run.digest().is_some(), "{normal}");
    }
}
