//! The room that the cue stick has.

use crate::layouts::{POOL, ball, on_pool_table, scenario};
use carom::aim::{Obstruction, least_elevation_deg, obstructions};
use carom::scenario::Scenario;

const NOSE: f64 = 0.0363;
const TIP: f64 = 0.010_604_5;
const SHAFT: f64 = 0.0065;
/// By how much the stick widens over the distance of the centres of its round ends.
const SLOPE: f64 = (0.02 - SHAFT) / (1.4732 - 0.02 - SHAFT);

fn shot(others: &str, cue: [f64; 2], keys: &str) -> Scenario {
    let balls = [ball("cue", cue, ""), others.to_owned()].concat();
    scenario(&on_pool_table(&balls, &format!("[shot]\nV0 = 2\n{keys}\n")))
}

fn found(scenario: &Scenario) -> Vec<(&'static str, Option<String>)> {
    obstructions(scenario).unwrap().into_iter().map(|found| (found.kind, found.id)).collect()
}

/// By how much a thing lies outside a cone whose axis starts at one point with an angle to the level, both in the plane
/// through it: of the balls on the axis the one that is nearest counts.
fn gap(start: [f64; 2], elevation: f64, point: [f64; 2], radius: f64) -> f64 {
    let along = |s: f64| [start[0] + s * elevation.cos(), start[1] + s * elevation.sin()];
    let at = |s: f64| {
        let [x, z] = along(s);
        (x - point[0]).hypot(z - point[1]) - radius - SHAFT - SLOPE * s
    };
    (0..200_000).map(|k| at(f64::from(k) * 1e-5 / 2.0)).fold(f64::INFINITY, f64::min)
}

/// Where the axis of the stick starts for a centre-ball shot, in the vertical plane through it: how far behind the ball's
/// centre, and how high.
fn start(elevation: f64) -> [f64; 2] {
    let back = POOL + SHAFT;
    [back * elevation.cos(), POOL + back * elevation.sin()]
}

#[test]
fn the_middle_of_the_table_is_free_and_a_level_stick_meets_the_rail_behind_it() {
    let middle = shot("", [0.635, 1.7], "phi_deg = 90\ntheta_deg = 0");
    assert_eq!(found(&middle), []);
    assert_eq!(least_elevation_deg(&middle), Ok(Some(0.0)));
    let near = shot("", [0.635, 0.3], "phi_deg = 90\ntheta_deg = 0");
    assert_eq!(found(&near), [("cushion", Some("bottom".into()))]);
    assert_eq!(found(&shot("", [0.635, 0.3], "phi_deg = 90\ntheta_deg = 10")), []);
}

#[test]
fn over_a_rail_the_stick_just_touches_the_nose_at_its_least_elevation() {
    for y in [0.05, 0.3] {
        let scenario = shot("", [0.635, y], "phi_deg = 90\ntheta_deg = 0");
        let least = least_elevation_deg(&scenario).unwrap().unwrap().to_radians();
        // The nose is the point that is touched: what lies behind it is further from a stick that rises.
        let gap = gap(start(least), least, [y, NOSE], 0.0);
        assert!(gap.abs() < 3e-6, "{y}: {gap} at {}", least.to_degrees());
        assert!(obstructions(&scenario).unwrap()[0].clear_from_deg.unwrap().to_radians() == least);
    }
}

#[test]
fn behind_a_frozen_ball_the_tip_is_over_the_rail() {
    let scenario = shot("", [0.635, 0.02752], "phi_deg = 90\ntheta_deg = 0");
    // The round end of the shaft is R + s sin θ high, and lies on the rail.
    let sin = (NOSE + SHAFT - POOL) / (POOL + SHAFT);
    let least = least_elevation_deg(&scenario).unwrap().unwrap();
    assert!((least - sin.asin().to_degrees()).abs() < 1e-3, "{least}");
}

#[test]
fn over_a_ball_the_stick_just_touches_it_at_its_least_elevation() {
    for behind in [2.0 * POOL, 0.1, 0.5] {
        let scenario =
            shot(&ball("1", [0.635, 1.27 - behind], ""), [0.635, 1.27], "phi_deg = 90\ntheta_deg = 0");
        assert_eq!(found(&scenario)[0], ("ball", Some("1".into())));
        let least = obstructions(&scenario).unwrap()[0].clear_from_deg.unwrap().to_radians();
        let gap = gap(start(least), least, [behind, POOL], POOL);
        assert!(gap.abs() < 1e-9, "{behind}: {gap}");
    }
}

#[test]
fn a_ball_beside_the_stick_is_met_where_it_is_wide_enough() {
    // 28.575 mm and half a metre behind: the stick's radius there is 6.5 mm and what it has widened by.
    let radius = SHAFT + SLOPE * (0.5 - POOL - SHAFT);
    let beside = |aside: f64| {
        let other = ball("1", [0.635 + aside, 1.4], "");
        found(&shot(&other, [0.635, 1.9], "phi_deg = 90\ntheta_deg = 0"))
    };
    assert_eq!(beside(POOL + radius - 1e-4), [("ball", Some("1".into()))]);
    assert_eq!(beside(POOL + radius + 1e-4), []);
    assert_eq!(beside(-(POOL + radius + 1e-4)), []);
}

#[test]
fn english_moves_the_stick_aside_and_draw_lowers_it_to_the_cloth() {
    let along_rail = |side: f64| {
        let keys = format!("phi_deg = 90\ntheta_deg = 0\na = {side}");
        found(&shot("", [0.02752, 2.1], &keys))
    };
    assert_eq!(along_rail(0.0), []);
    assert_eq!(along_rail(-0.5), [], "away from the rail");
    assert_eq!(along_rail(0.5).len(), 1, "to the left, where the rail is");
    let low =
        |height: f64| found(&shot("", [0.635, 1.9], &format!("phi_deg = 90\ntheta_deg = 0\nb = {height}")));
    // With the tip's centre at −b (R + r) the axis lies at R − b (R + r), and the butt needs 20 mm below it.
    let limit = (POOL - 0.02) / (POOL + TIP);
    assert_eq!(low(-limit + 1e-6), []);
    assert_eq!(low(-limit - 1e-6), [("cloth", None)]);
}

#[test]
fn it_takes_a_shot() {
    let none = scenario(&on_pool_table(&ball("cue", [0.5, 0.5], ""), ""));
    let message = "shot: missing: without it the stick is nowhere";
    assert_eq!(obstructions(&none).unwrap_err().to_string(), message);
    assert_eq!(least_elevation_deg(&none).unwrap_err().to_string(), message);
}

#[test]
fn a_ball_in_the_air_over_the_cue_ball_leaves_no_room() {
    let other = ball("1", [0.635, 1.2], "").replace("1.2]", "1.2, 0.4]");
    let text = on_pool_table(
        &[ball("cue", [0.635, 1.2], ""), other].concat(),
        "[shot]\nV0 = 1\nphi_deg = 90\ntheta_deg = 89",
    );
    let scenario = scenario(&text.replace("air = false", "air = true"));
    let expected = Obstruction { kind: "ball", id: Some("1".into()), clear_from_deg: None };
    assert_eq!(obstructions(&scenario).unwrap(), [expected]);
    assert!(least_elevation_deg(&scenario).unwrap().unwrap() < 60.0, "from the side there is room");
}
