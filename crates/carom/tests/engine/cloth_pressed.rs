//! Balls that are pressed together, or onto cushions, come to rest after few events, without overlap and without gain.

use crate::kit::cloth::{
    ClothRun, RADIUS, at, bits_of, deepest_overlap, events, kinds_of, on_table, rolling, run, spun, still,
    stun, wide,
};
use crate::kit::random::Random;
use crate::kit::scenes::{rack, rectangle};
use carom::flight::Motion;
use carom::run::{Kind, Status};
use serde_json::{Value, json};

/// Laws that lose nothing, something, all, and that rub.
fn laws() -> Vec<Value> {
    let rubbing = json!({ "law": "han_2005", "normal": 0.85, "friction": 0.2 });
    vec![
        json!({}),
        json!({ "ball_ball": { "law": "restitution", "normal": 0.95 },
            "ball_cushion": { "law": "restitution", "normal": 0.8 } }),
        json!({ "ball_ball": { "law": "restitution", "normal": 0.0 },
            "ball_cushion": { "law": "restitution", "normal": 0.0 } }),
        json!({ "ball_ball": { "law": "frictional", "normal": 0.95 }, "ball_cushion": rubbing }),
        json!({ "ball_ball": { "law": "mathavan_2014", "normal": 0.9, "friction": 0.05 },
            "ball_cushion": { "law": "mathavan_2010", "normal": 0.9, "friction": 0.14 } }),
        json!({ "cluster": "reflections", "ball_cushion": { "law": "stronge_compliant", "normal": 0.8, "friction": 0.2 } }),
        json!({ "cluster": "pairwise" }),
    ]
}

/// Asserts that a run ends at rest with few contacts, no overlap and no gain of energy.
///
/// A contact under pressure hops for t_c at least. After a first meeting it takes one more to tell pressure from a graze, so
/// twice the number of hops in the time of the run bounds the contacts, and each may end a slide and begin one.
fn assert_sound(run: &ClothRun, pressed: u64, what: &str) {
    assert_eq!(run.status, Status::AtRest, "{what}");
    let hop_time = run.system.hop_times[0];
    let most = pressed * (2.0 * run.end_time / hop_time + 20.0) as u64;
    let found = &run.diagnostics;
    assert!(found.collisions() <= most, "{what}: {} contacts, at most {most} expected", found.collisions());
    assert!(found.total_events() <= 4 * most + 40, "{what}: {} events", found.total_events());
    let tolerance = run.system.tolerance.of(2.0 * RADIUS);
    assert!(found.deepest_overlap <= tolerance, "{what}: {:e} deep", found.deepest_overlap);
    let deepest = deepest_overlap(run, 4);
    assert!(deepest <= tolerance, "{what}: {deepest:e} deep between the events");
    let scale = found.initial_energy;
    assert!(found.energy_gain <= 1e-14 * scale, "{what}: {found:?}");
    assert!(found.energy_drift <= 1e-12 * scale, "{what}: {found:?}");
}

fn for_all_laws(table: &Value, balls: &[Value], pressed: u64) -> Vec<ClothRun> {
    let one = |law: Value| {
        let run = run(&on_table(table, &law, balls));
        assert_sound(&run, pressed, &law.to_string());
        run
    };
    laws().into_iter().map(one).collect()
}

#[test]
fn balls_in_touch_of_which_the_first_brakes_harder() {
    let mut first = rolling("first", [10.0 + 2.0 * RADIUS, 10.0], [1.0, 0.0]);
    first["rolling_friction"] = json!(0.03);
    let balls = [rolling("second", [10.0, 10.0], [1.0, 0.0]), first];
    for run in for_all_laws(&rectangle(40.0, 40.0), &balls, 1) {
        let [second, first] = [0, 1].map(|k| run.final_state()[k].position.x);
        assert!(first - second < 3.0 * RADIUS, "they stay together: {first} and {second}");
        assert!(first > 10.0 + 1.0 / (2.0 * 0.03 * 9.81), "the second pushes the first on");
    }
}

#[test]
fn five_in_a_row_each_of_which_brakes_harder_than_the_one_behind() {
    let ball = |k: usize| {
        let mut ball = rolling(&k.to_string(), [10.0 + 2.0 * RADIUS * k as f64, 10.0], [0.5, 0.0]);
        ball["rolling_friction"] = json!(0.01 * (k + 1) as f64);
        ball
    };
    let balls: Vec<Value> = (0..5).map(ball).collect();
    for_all_laws(&rectangle(40.0, 40.0), &balls, 4);
}

#[test]
fn a_ball_frozen_to_a_cushion_that_its_spin_drives_into_it() {
    // The slip is along +x, so friction pulls to the left, where the cushion is.
    let balls = [spun("a", [RADIUS, 1.0], [0.0, 0.5], [0.0, -1.0, 0.0])];
    for run in for_all_laws(&rectangle(20.0, 20.0), &balls, 1) {
        let away = run.final_state()[0].position.x - RADIUS;
        assert!((0.0..0.02).contains(&away), "it runs along the cushion: {away}");
    }
}

#[test]
fn a_ball_with_follow_on_one_that_is_frozen_to_a_cushion() {
    let balls = [
        still("object", [10.0, 20.0 - RADIUS]),
        spun("cue", [10.0, 20.0 - 3.0 * RADIUS], [0.0, 0.0], [-2.0, 0.0, 0.0]),
    ];
    for run in for_all_laws(&rectangle(20.0, 20.0), &balls, 2) {
        assert!(run.final_state()[1].position.y < 20.0 - 3.0 * RADIUS + 1e-9);
        assert!(kinds_of(&run, 1).contains(&Kind::BallBall));
    }
}

#[test]
fn a_shot_with_follow_onto_a_ball_that_is_frozen_to_a_cushion() {
    let balls = [
        still("object", [10.0, 20.0 - RADIUS]),
        spun("cue", [10.0, 19.0], [0.0, 3.0], [-5.0, 0.0, 0.0]),
        still("beside", [10.0 + 2.0 * RADIUS, 20.0 - RADIUS]),
    ];
    for_all_laws(&rectangle(20.0, 20.0), &balls, 3);
}

#[test]
fn a_ball_frozen_in_a_corner_with_spin_that_drives_it_there() {
    // Friction pulls to the lower left.
    let balls = [spun("a", [RADIUS, RADIUS], [0.0, 0.0], [1.0, -1.0, 0.0])];
    for run in for_all_laws(&rectangle(20.0, 20.0), &balls, 2) {
        let place = run.final_state()[0].position;
        // Laws that rub turn the spin up the cushion and back; it goes nowhere far.
        assert!(place.x < 0.3 && place.y < 0.3, "{place:?}");
    }
}

#[test]
fn a_ball_shot_into_a_corner_in_which_another_lies() {
    let balls = [still("object", [RADIUS, RADIUS]), spun("cue", [0.5, 0.5], [-2.0, -2.0], [3.0, -3.0, 0.0])];
    for_all_laws(&rectangle(20.0, 20.0), &balls, 3);
}

#[test]
fn balls_at_rest_against_each_other_and_the_cushions_stay() {
    let mut balls: Vec<Value> = rack(RADIUS, [RADIUS * 5.0, RADIUS], 5)
        .iter()
        .enumerate()
        .map(|(k, ball)| still(&k.to_string(), ball.position))
        .collect();
    balls.push(still("corner", [RADIUS, 3.0 - RADIUS]));
    for law in laws() {
        let run = run(&on_table(&rectangle(2.0, 3.0), &law, &balls));
        assert_eq!((run.status, run.end_time, run.log.events.len()), (Status::AtRest, 0.0, 0), "{law}");
    }
}

#[test]
fn a_ball_with_follow_that_presses_on_a_frozen_rack() {
    let mut balls: Vec<Value> = rack(RADIUS, [10.0, 10.0], 5)
        .iter()
        .enumerate()
        .map(|(k, ball)| still(&k.to_string(), ball.position))
        .collect();
    balls.push(spun("cue", [10.0, 10.0 - 2.0 * RADIUS], [0.0, 0.0], [-3.0, 0.0, 0.0]));
    for_all_laws(&rectangle(20.0, 20.0), &balls, 15);
}

#[test]
fn a_row_frozen_to_a_cushion_that_is_struck_along_it_and_onto_it() {
    let row = |k: usize| still(&k.to_string(), [RADIUS, 5.0 + 2.0 * RADIUS * k as f64]);
    let mut balls: Vec<Value> = (0..4).map(row).collect();
    balls.push(stun("along", [RADIUS, 4.0], [0.0, 1.5]));
    balls.push(rolling("onto", [1.0, 5.0 + 3.0 * RADIUS], [-1.5, 0.0]));
    for_all_laws(&rectangle(20.0, 20.0), &balls, 10);
}

#[test]
fn two_balls_that_spin_in_place_against_each_other_do_not_meet() {
    let balls = [
        spun("a", [10.0, 10.0], [0.0, 0.0], [0.0, 0.0, 1.0]),
        spun("b", [10.0 + 2.0 * RADIUS, 10.0], [0.0, 0.0], [0.0, 0.0, -2.0]),
    ];
    let run = run(&wide(&json!({}), &balls));
    assert!(events(&run, Kind::BallBall).is_empty());
    assert_eq!(run.log.events.len(), 2);
    assert!(at(&run, run.end_time).iter().all(|state| state.motion == Motion::Resting));
}

/// Up to five balls in a chain of contacts, the first frozen to a cushion, with any spins and some motion.
fn chain(random: &mut Random) -> Vec<Value> {
    let mut places = vec![[RADIUS, 0.4]];
    for _ in 0..2 + random.below(3) {
        let [x, y] = places[places.len() - 1];
        let angle = (60.0 * random.below(4) as f64 - 90.0).to_radians();
        places.push([x + 2.0 * RADIUS * angle.cos(), y + 2.0 * RADIUS * angle.sin()]);
    }
    let mut ball = |(k, place): (usize, &[f64; 2])| {
        let speed = if random.flips() { 0.02 } else { 0.0 };
        let velocity = random.direction().map(|part| part * speed);
        let rolled = [0; 3].map(|_| random.between(-0.5, 0.5));
        spun(&k.to_string(), *place, velocity, rolled)
    };
    places.iter().enumerate().map(|(k, place)| ball((k, place))).collect()
}

#[test]
fn the_numbers_of_balls_that_touch_and_are_pressed_change_no_bit() {
    let mut random = Random::new(11);
    let mut compared = 0;
    while compared < 200 {
        let balls = chain(&mut random);
        let law = random.choose(&laws()).clone();
        let value = on_table(&rectangle(0.8, 0.8), &law, &balls);
        if carom::scenario::Scenario::from_json(&value.to_string()).is_err() {
            continue;
        }
        let backwards: Vec<Value> = balls.iter().rev().cloned().collect();
        let [mut one, other] = [value, on_table(&rectangle(0.8, 0.8), &law, &backwards)]
            .map(|value| bits_of(&run(&value).final_state()));
        one.reverse();
        assert_eq!(one, other, "{}", json!({ "law": law, "balls": balls }));
        compared += 1;
    }
}
