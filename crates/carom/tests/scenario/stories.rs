//! What the descriptions of the scenario files claim is what happens.

use carom::flight::State;
use carom::run::{Run, Status};
use carom::scenario::Scenario;
use carom::simulate::{AnyRun, simulate};
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

#[test]
fn every_scenario_runs_to_an_end_of_its_own() {
    for entry in std::fs::read_dir(format!("{}/../../scenarios", env!("CARGO_MANIFEST_DIR"))).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let run = AnyRun::simulate(&scenario(&name), None, &mut || false).unwrap();
        let (status, found) = with_any!(run, run => (run.status, run.diagnostics));
        let ended = matches!(status, Status::TimeLimit | Status::CollisionLimit | Status::AtRest);
        assert!(ended, "{name} ended {status:?}");
        assert!(found.total_events() > 1, "{name} has something to look at");
    }
}
