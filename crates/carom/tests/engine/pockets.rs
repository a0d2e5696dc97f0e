//! Balls fall into pockets: which, where and when.

use crate::kit::cloth::{at, events, first, kinds_of, on_table, rolling, run, stun};
use crate::kit::scenes::rectangle;
use carom::flight::Motion;
use carom::run::{Kind, Status};
use serde_json::{Value, json};

/// Lengths of the side pocket of D. Alciatore, TP 3.5, in inches.
const BALL: f64 = 1.125;
const MOUTH: f64 = 5.0625;
const HOLE: f64 = 3.0;
const SHELF: f64 = 0.1875;
const FACING_DEG: f64 = 14.0;

/// Half a table around the pocket: its nose line is the y axis, the pocket lies to the left.
fn side_pocket() -> Value {
    let half = 0.5 * MOUTH;
    let depth = SHELF + 2.0 * HOLE;
    let narrow = depth * libm::tan(FACING_DEG.to_radians());
    let corners = [
        [-depth, half - narrow],
        [-depth, -(half - narrow)],
        [0.0, -half],
        [0.0, -40.0],
        [40.0, -40.0],
        [40.0, 40.0],
        [0.0, 40.0],
        [0.0, half],
    ];
    let sides: Vec<Value> = (0..corners.len())
        .map(|k| json!({ "line": [corners[k], corners[(k + 1) % corners.len()]] }))
        .collect();
    json!({ "shape": "path", "pieces": sides,
        "pockets": [{ "id": "side", "center": [-SHELF - HOLE, 0.0], "radius": HOLE }] })
}

/// Whether a slow ball falls that comes at an angle from the pocket's axis, on a line that passes the middle of the mouth
/// so far to the side.
fn falls(angle_deg: f64, aside: f64) -> bool {
    let (sin, cos) = (libm::sin(angle_deg.to_radians()), libm::cos(angle_deg.to_radians()));
    let start = [20.0 * cos - aside * sin, -20.0 * sin - aside * cos];
    let physics = json!({ "flight": { "law": "cloth", "gravity": 0.0 } });
    let mut value = on_table(&side_pocket(), &physics, &[stun("a", start, [-cos, sin])]);
    value["ball_defaults"] = json!({ "radius": BALL, "mass": 1.0, "sliding_friction": 0.0 });
    value["duration"] = json!(35.0);
    !events(&run(&value), Kind::BallPocket).is_empty()
}

#[test]
fn a_slow_ball_falls_into_the_side_pocket_up_to_68_degrees() {
    // Lines that do not touch the near point pass the middle of the mouth on the far side.
    let some_line = |angle: f64| (-300..=300).any(|k| falls(angle, 0.01 * f64::from(k)));
    assert!(falls(0.0, 0.0), "straight in");
    for angle in [30.0, 60.0, 67.29, -67.29] {
        assert!(some_line(angle), "{angle} degrees");
    }
    for angle in [69.29, -69.29, 75.0] {
        assert!(!some_line(angle), "{angle} degrees");
    }
}

#[test]
fn a_ball_falls_when_its_centre_is_over_the_hole() {
    let mut table = rectangle(2.0, 2.0);
    table["pockets"] = json!([{ "id": "hole", "center": [1.0, 1.0], "radius": 0.06 }]);
    let run = run(&on_table(&table, &json!({}), &[rolling("a", [1.0, 0.5], [0.0, 1.0])]));
    let event = first(&run, Kind::BallPocket, 0);
    assert_eq!(run.system.cushion_ids[event.cushion.unwrap() as usize], "hole");
    let state = at(&run, event.time)[0];
    assert_eq!(state.motion, Motion::Pocketed);
    assert!((event.point.y - 0.94).abs() < 1e-14 && event.point.x == 1.0);
    let braking: f64 = 0.01 * 9.81;
    let expected = (1.0 - (1.0 - 2.0 * braking * 0.44).sqrt()) / braking;
    assert!((event.time - expected).abs() < 1e-14, "{}", event.time);
    assert_eq!((run.status, run.end_time), (Status::AtRest, event.time));
    assert_eq!(run.energy(run.end_time).unwrap(), 0.0);
}

#[test]
fn a_ball_in_a_pocket_is_out_of_the_others_way() {
    let mut table = rectangle(2.0, 2.0);
    table["pockets"] = json!([{ "id": "hole", "center": [1.0, 1.0], "radius": 0.06 }]);
    let balls = [rolling("a", [1.0, 0.5], [0.0, 1.0]), rolling("b", [0.5, 1.0], [0.9, 0.0])];
    let run = run(&on_table(&table, &json!({}), &balls));
    assert_eq!(kinds_of(&run, 0), [Kind::BallPocket]);
    assert_eq!(kinds_of(&run, 1), [Kind::BallPocket]);
    assert!((first(&run, Kind::BallPocket, 1).point.x - 0.94).abs() < 1e-14);
}

#[test]
fn a_ball_that_passes_a_pocket_by_does_not_fall() {
    let mut table = rectangle(2.0, 2.0);
    table["pockets"] = json!([{ "id": "hole", "center": [1.0, 1.0], "radius": 0.06 }]);
    for (aside, falls) in [(0.06 - 1e-9, true), (0.06 + 1e-9, false)] {
        let run = run(&on_table(&table, &json!({}), &[rolling("a", [1.0 + aside, 0.5], [0.0, 1.0])]));
        assert_eq!(!events(&run, Kind::BallPocket).is_empty(), falls, "{aside}");
    }
}

#[test]
fn a_ball_drops_at_once_that_lies_on_the_rim_and_moves_in() {
    let mut table = rectangle(2.0, 2.0);
    table["pockets"] = json!([{ "id": "hole", "center": [1.0, 1.0], "radius": 0.0625 }]);
    let inwards = run(&on_table(&table, &json!({}), &[rolling("a", [1.0625, 1.0], [-1.0, 0.0])]));
    assert_eq!(first(&inwards, Kind::BallPocket, 0).time, 0.0);
    let outwards = run(&on_table(&table, &json!({}), &[rolling("a", [1.0625, 1.0], [0.2, 0.0])]));
    assert!(events(&outwards, Kind::BallPocket).is_empty());
}
