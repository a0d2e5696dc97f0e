//! Balls that lean on hollow cushions, on the cloth and in the air: they slide along in hops, and stay on the table.

use crate::kit::cloth::{ClothRun, RADIUS, ball, on_table, run, spun};
use crate::kit::random::Random;
use carom::flight::Motion;
use carom::run::Status;
use serde_json::{Value, json};

const RIM: f64 = 0.5;

fn table() -> Value {
    json!({ "shape": "circle", "radius": RIM })
}

/// How far the balls still in play reach past the rim in the end, over their radius.
fn reach_past_rim(run: &ClothRun) -> f64 {
    let states = run.final_state();
    let in_play = states.iter().filter(|state| !state.motion.is_out());
    in_play.map(|state| (state.position.plan().norm() + RADIUS - RIM) / RADIUS).fold(-1.0, f64::max)
}

#[test]
fn a_ball_that_a_dead_rim_turns_goes_on_along_it_in_hops() {
    let physics = json!({ "ball_cushion": { "law": "restitution", "normal": 0.0 } });
    for speed in [0.1, 1.0, 4.0] {
        let mut slider = spun("a", [0.3, 0.0], [0.0, speed], [0.0; 3]);
        slider["sliding_friction"] = json!(0);
        let mut value = on_table(&table(), &physics, &[slider]);
        value["duration"] = json!(10);
        let run = run(&value);
        assert_eq!(run.status, Status::TimeLimit, "{speed}");
        // Each hop lasts t_c but for a few at first.
        let hops = run.end_time / run.system.hop_times[0] + 20.0;
        assert!((run.diagnostics.total_events() as f64) < hops, "{speed}: {:?}", run.diagnostics);
        assert!(reach_past_rim(&run) < 1e-9, "{speed}");
    }
}

#[test]
fn without_gravity_a_ball_along_a_rim_hops_no_more_often_than_it_gets_on() {
    let physics = json!({
        "flight": { "law": "cloth", "gravity": 0.0 },
        "ball_cushion": { "law": "restitution", "normal": 0.5 },
    });
    let speed = 0.8;
    let mut value = on_table(&table(), &physics, &[spun("a", [0.3, 0.0], [0.0, speed], [0.0; 3])]);
    value["duration"] = json!(20);
    let run = run(&value);
    assert_eq!(run.status, Status::TimeLimit);
    // A hop lasts the time for a twentieth of the radius, but for the first.
    let hops = 20.0 * speed / (0.05 * RADIUS);
    assert!((run.diagnostics.total_events() as f64) < hops + 60.0, "{:?}", run.diagnostics);
    assert!(reach_past_rim(&run) < 1e-9);
}

#[test]
fn a_ball_that_rises_along_a_rim_does_not_go_through_it() {
    let mut random = Random::new(8);
    let mut fallen = 0;
    for shot in 0..300 {
        let normal = *random.choose(&[0.0, 0.3]);
        let cushion = json!({ "law": "frictional", "normal": normal, "friction": 1.0 });
        let rolled = [0; 3].map(|_| random.between(-4.0, 4.0));
        let [x, y] = random.direction().map(|part| 3.0 * part);
        let from = [random.between(-0.3, 0.3), random.between(-0.3, 0.3)];
        let run =
            run(&on_table(&table(), &json!({ "ball_cushion": cushion }), &[spun("a", from, [x, y], rolled)]));
        let past = reach_past_rim(&run);
        assert!(past < 1e-9, "shot {shot} ends {past} radii past the rim: {:?}", run.final_state());
        fallen += usize::from(run.final_state()[0].motion == Motion::OffTable);
    }
    assert!(fallen < 200, "{fallen}");
}

#[test]
fn where_noses_are_touched_in_plan_no_ball_lands_nearer_than_one_can_roll() {
    let mut random = Random::new(9);
    for shot in 0..300 {
        let nose = random.between(0.4, 1.6) * RADIUS;
        let mut table = json!({ "shape": "rectangle", "width": 1, "length": 1 });
        (table["nose_height"], table["nose_contact"]) = (json!(nose), json!("plan"));
        let velocity = [random.between(0.5, 3.0), 0.0, random.between(0.3, 1.5)];
        let jumper = ball("a", [random.between(0.3, 0.9), 0.5], &json!({ "velocity": velocity }));
        let run = run(&on_table(&table, &json!({}), &[jumper]));
        let state = run.final_state()[0];
        let gap = 1.0 - RADIUS - state.position.x;
        assert!(state.motion == Motion::OffTable || gap > -1e-9, "shot {shot}: {state:?}");
    }
}

/// Nose and cloth both rub so hard that the ball all but stops between them, which the law must see through to its end.
#[test]
fn a_ball_all_but_wedged_between_nose_and_cloth_leaves_with_finite_numbers() {
    let wedge = json!({
        "duration": 20.0,
        "table": { "shape": "circle", "radius": RIM, "nose_height": 0.02185273197980108 },
        "physics": {
            "flight": { "law": "cloth", "gravity": 0.0 },
            "ball_cushion": { "law": "mathavan_2010", "normal": 1.0, "friction": 1.0 },
        },
        "balls": [{
            "id": "a", "radius": 0.019154426561711457, "mass": 0.19482404778279985, "sliding_friction": 1.0,
            "rolling_friction": 0.01, "spin_decay": 0.0,
            "position": [-0.00929583643956966, -0.2613714035679541],
            "velocity": [-0.6600336734903297, -0.2375604220226737],
            "spin": [50.91706501951229, 6.006366878015442, 6.46005789235673],
        }],
    });
    let run = run(&wedge);
    assert!(run.digest().is_some());
    assert!(run.diagnostics.energy_gain <= 1e-14 * run.diagnostics.initial_energy, "{:?}", run.diagnostics);
}
