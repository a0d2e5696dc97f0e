//! What the descriptions of the scenario files claim is what happens.

use carom::flight::State;
use carom::run::{Kind, OnCloth, Run, Status};
use carom::scenario::Scenario;
use carom::simulate::{AnyRun, simulate, simulate_until};
use carom::with_any;
use serde_json::json;

fn scenario(name: &str) -> Scenario {
    let path = format!("{}/../../scenarios/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    Scenario::from_toml(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn run(name: &str) -> Run<f64> {
    simulate(&scenario(name)).unwrap()
}

/// Velocities of all balls at a time.
fn velocities(run: &Run<f64>, time: f64) -> Vec<[f64; 2]> {
    run.state(time).unwrap().into_iter().map(|ball| ball.velocity.to_f64()).collect()
}

#[test]
fn the_cradle_passes_one_ball_on() {
    let mut expected = vec![[0.0, 0.0]; 6];
    expected[5] = [1.0, 0.0];
    assert_eq!(velocities(&run("newtons_cradle"), 1.0), expected);
}

#[test]
fn the_heavy_ball_stops_dead_and_the_second_meeting_restores_the_speeds() {
    let run = run("head_on_unequal");
    let close = |time, expected: [f64; 2]| {
        let found = velocities(&run, time);
        assert!(
            (found[0][0] - expected[0]).abs() < 1e-14 && (found[1][0] - expected[1]).abs() < 1e-14,
            "{found:?}"
        );
    };
    close(0.6, [-2.0, 0.0]);
    close(1.7, [-1.0, 1.0]);
}

#[test]
fn collisions_count_the_digits_of_pi() {
    let scenario = scenario("counting_pi");
    for (mass, digits) in [(1.0, 3), (1e2, 31), (1e4, 314), (1e6, 3141), (1e8, 31415)] {
        let heavier = scenario.with_values(&[("balls.heavy.mass", json!(mass))]).unwrap();
        assert_eq!(simulate(&heavier).unwrap().diagnostics.collisions(), digits, "mass {mass}");
    }
}

#[test]
fn one_ball_into_two_gives_the_symmetric_answer() {
    let [cue, upper, lower] = velocities(&run("one_into_two"), 2.0)[..] else { panic!("three balls") };
    assert!((cue[0] + 0.2).abs() < 1e-14 && cue[1].abs() < 1e-14);
    // 0.6928 at 30 degrees is 2 √3/5 (cos 30°, sin 30°) = (0.6, 0.2 √3).
    assert!((upper[0] - 0.6).abs() < 1e-14 && (upper[1] - 0.12f64.sqrt()).abs() < 1e-14);
    assert!((lower[0] - 0.6).abs() < 1e-14 && (lower[1] + 0.12f64.sqrt()).abs() < 1e-14);
}

#[test]
fn bounces_of_the_dropped_ball_are_a_geometric_series() {
    let run = run("damped_drop");
    let times: Vec<f64> = run.log.events.iter().map(|event| event.time).collect();
    let mut expected = 1.0;
    for (bounce, time) in times.iter().take(20).enumerate() {
        assert!((time - expected).abs() < 1e-13, "bounce {bounce} at {time}, expected at {expected}");
        expected += 2.0 * 0.8f64.powi(bounce as i32 + 1);
    }
    assert_eq!(run.status, Status::AtRest);
    assert!((8.99..9.0).contains(&run.end_time));
}

#[test]
fn the_ball_on_the_tilted_table_comes_to_rest_in_the_corner() {
    let run = run("tilted");
    assert_eq!(run.status, Status::AtRest);
    let position = run.final_state()[0].position;
    assert!((position.x - 0.08).abs() < 1e-9 && (position.y - 0.08).abs() < 1e-9);
}

#[test]
fn chords_in_a_circle_keep_their_distance_from_the_centre() {
    let run = run("circle");
    let distance = |time: f64| {
        let State { position, velocity } = run.state(time).unwrap()[0];
        position.cross(velocity) / velocity.norm()
    };
    for step in 1..80 {
        assert!((distance(f64::from(step)) - distance(0.0)).abs() < 1e-13);
    }
}

#[test]
fn two_points_in_the_stadium_part_within_some_twenty_hits() {
    let run = run("stadium");
    let hits: Vec<f64> =
        run.log.events.iter().filter(|event| event.ball_a == 0).map(|event| event.time).collect();
    let distance = |hit: usize| {
        let state = run.state(hits[hit]).unwrap();
        (state[0].position - state[1].position).norm()
    };
    // A factor of three at each hit makes 7e-5 of 2e-8 in eight hits, and 1 in seventeen.
    assert!(distance(7) < 1e-3, "{}", distance(7));
    let apart = (17..25).map(distance).fold(0.0, f64::max);
    assert!(apart > 1.0, "{apart}");
}

#[test]
fn the_regular_point_of_the_mushroom_never_enters_the_stem() {
    let run = run("mushroom");
    let lowest = |ball: u32| {
        let hits = run.log.events.iter().filter(|event| event.ball_a == ball);
        hits.map(|event| event.point.y).fold(1.0, f64::min)
    };
    assert_eq!(lowest(0), -1.0);
    assert!(lowest(1) > -1e-12);
}

#[test]
fn a_step_loses_about_half_its_length_at_a_hit() {
    let run = run("midterm_stepped");
    let hits = run.diagnostics.collisions() as f64 + run.diagnostics.events[0] as f64;
    let lost = run.diagnostics.lost_time / hits / 0.03;
    assert!((0.3..0.7).contains(&lost), "{lost} of a step per ball and hit");
}

#[test]
fn corners_are_hit_where_the_descriptions_say_so() {
    for (name, corner) in [("l_shape", "2/3"), ("u_divider", "divider.a/divider.b")] {
        let run = run(name);
        let ids = &run.system.cushion_ids;
        let hit = |event: &&carom::run::Event<f64>| {
            event.cushion.is_some_and(|cushion| ids[cushion as usize] == corner)
        };
        assert!(run.log.events.iter().filter(hit).count() > 0, "{name} hits {corner}");
    }
}

#[test]
fn the_break_starts_symmetric() {
    let run = run("triangle_break");
    let state = run.state(0.35).unwrap();
    let mut xs: Vec<f64> = state.iter().map(|ball| ball.position.x - 0.635).collect();
    xs.sort_by(f64::total_cmp);
    for (left, right) in xs.iter().zip(xs.iter().rev()) {
        assert!((left + right).abs() < 1e-9, "{xs:?}");
    }
}

fn on_cloth(name: &str) -> Run<f64, OnCloth> {
    simulate_until(&scenario(name), None, &mut || false).unwrap()
}

/// Kinds of the events of the first ball, each with the other ball or the cushion.
fn contacts(run: &Run<f64, OnCloth>) -> Vec<(Kind, f64)> {
    let contact =
        |kind| matches!(kind, Kind::BallBall | Kind::BallCushion | Kind::BallPocket | Kind::OffTable);
    let events = run.log.events.iter().filter(|event| event.ball_a == 0 && contact(event.kind));
    events.map(|event| (event.kind, event.time)).collect()
}

#[test]
fn the_jump_shot_clears_the_eight_and_meets_the_one() {
    let run = on_cloth("jump_shot");
    let (first, meets) = contacts(&run)[0];
    assert_eq!(first, Kind::BallBall);
    let event = run.log.events.iter().find(|event| event.time == meets).unwrap();
    assert_eq!(event.ball_b, Some(2), "the one, not the eight");
    // Where it is over the eight's middle it is more than a ball higher.
    let over = (0..=1000).map(|k| run.state(meets * f64::from(k) / 1000.0).unwrap()[0].position);
    let over = over.min_by(|a, b| (a.y - 1.05).abs().total_cmp(&(b.y - 1.05).abs())).unwrap();
    assert!(over.z > 3.0 * 0.028_575, "{over:?}");
}

#[test]
fn the_masse_curves_around_the_eight_and_ends_along_coriolis_line() {
    let run = on_cloth("masse");
    let (first, hits) = contacts(&run)[0];
    assert_eq!(first, Kind::BallCushion, "not the eight");
    let path: Vec<_> =
        (0..=1000).map(|k| run.state(hits * f64::from(k) / 1000.0).unwrap()[0].position).collect();
    let beside = path.iter().find(|place| place.y >= 1.1).unwrap();
    assert!(beside.x > 0.5 + 2.0 * 0.028_575, "to the right of the eight: {beside:?}");
    assert!(path.iter().any(|place| place.y < 1.6 && place.x < 0.5), "back on the left behind it");
    let stroke = run.system.stroke.unwrap();
    let (cos, sin) = stroke.strike.elevation;
    let point = stroke.cue.strike(&run.system.spheres[0], &stroke.strike).point;
    let line = point.plan() + stroke.strike.direction * ((1.0 + point.z) * cos / sin);
    let rolls = run.log.events.iter().find(|event| event.kind == Kind::SlideToRoll).unwrap();
    let last = run.state(rolls.time).unwrap()[0].twist.velocity.plan();
    // The end of the cue has mass, so the impulse is some two degrees off its axis.
    let off = (line.cross(last) / (line.norm() * last.norm())).asin().to_degrees();
    assert!(line.dot(last) > 0.0 && off.abs() < 4.0, "{off} degrees");
}

#[test]
fn the_two_ball_shot_agrees_with_pooltool_and_sinks_both() {
    let run = on_cloth("two_ball_shot");
    let (kind, meets) = contacts(&run)[0];
    assert!(kind == Kind::BallBall && (meets - 0.3306).abs() < 1e-5, "{meets}");
    let pockets: Vec<_> = run.log.events.iter().filter(|event| event.kind == Kind::BallPocket).collect();
    assert_eq!(pockets.len(), 2);
    assert!(pockets[1].ball_a == 1 && (pockets[1].time - 2.296_384).abs() < 1e-3, "{pockets:?}");
}

#[test]
fn the_cue_ball_of_the_billiards_meets_the_red_then_three_cushions_and_then_the_yellow() {
    let run = on_cloth("three_cushion");
    let of_cue_ball = run.log.events.iter().filter(|event| event.ball_a == 0);
    let met: Vec<Option<u32>> = of_cue_ball
        .filter(|event| matches!(event.kind, Kind::BallBall | Kind::BallCushion))
        .map(|event| event.ball_b)
        .collect();
    let (yellow, red) = (Some(1), Some(2));
    assert_eq!(met[..5], [red, None, None, None, yellow]);
}

#[test]
fn the_nine_falls_on_the_break() {
    let run = on_cloth("nine_ball_break");
    let nine = run.system.ball_ids.iter().position(|id| id == "9");
    let fallen: Vec<usize> = (run.log.events.iter())
        .filter(|event| event.kind == Kind::BallPocket)
        .map(|event| event.ball_a as usize)
        .collect();
    assert_eq!(Some(fallen[0]), nine);
}

#[test]
fn every_scenario_runs_to_an_end_of_its_own() {
    for entry in std::fs::read_dir(format!("{}/../../scenarios", env!("CARGO_MANIFEST_DIR"))).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let run = AnyRun::simulate(&scenario(&name), None, &mut || false).unwrap();
        let (status, diagnostics) = with_any!(&run, run => (run.status, &run.diagnostics));
        let ended = matches!(status, Status::TimeLimit | Status::CollisionLimit | Status::AtRest);
        assert!(ended, "{name} ended {status:?}");
        assert!(diagnostics.collisions() > 0, "{name} has something to look at");
    }
}
