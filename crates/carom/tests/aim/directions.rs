//! Directions in closed form.

use crate::layouts::{POOL, ball, discs, on_pool_table, scenario};
use carom::aim::{Scene, aiming_point, at_ball, at_point, ghost_ball};

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-12
}

#[test]
fn a_point_has_its_direction() {
    let scene = discs(&ball("cue", [5.0, 5.0], "radius = 0.5"));
    let to = |x, y| at_point(&scene, [x, y]).unwrap();
    assert_eq!((to(6.0, 5.0), to(5.0, 9.0), to(4.0, 5.0), to(5.0, 1.0)), (0.0, 90.0, 180.0, -90.0));
    assert!(is_near(to(8.0, 9.0), 53.13010235415598));
}

#[test]
fn half_a_ball_is_cut_by_thirty_degrees() {
    // Aimed at the edge of an equal ball far away, sin χ = R / 2R.
    let balls = [ball("cue", [1.0, 5.0], "radius = 0.5"), ball("1", [9.0, 5.0], "radius = 0.5")].concat();
    let scene = discs(&balls);
    assert_eq!(at_ball(&scene, "1", 0.0), Ok(0.0));
    let edge = (0.5_f64 / 8.0).asin().to_degrees();
    assert!(is_near(at_ball(&scene, "1", 30.0).unwrap(), -edge), "to the left: hit on its right");
    assert!(is_near(at_ball(&scene, "1", -30.0).unwrap(), edge));
}

#[test]
fn centres_at_contact_are_as_far_apart_as_the_balls_say() {
    let balls = |more: [&str; 2]| [ball("cue", [1.0, 5.0], more[0]), ball("1", [5.0, 5.0], more[1])].concat();
    let sin_60 = 60.0_f64.to_radians().sin();
    let discs = discs(&balls(["radius = 0.5", "radius = 0.125"]));
    let expected = -(0.625 / 4.0 * sin_60).asin().to_degrees();
    assert!(is_near(at_ball(&discs, "1", 60.0).unwrap(), expected));
    let on_cloth = format!(
        "physics.flight.law = 'cloth'\ntable = {{ shape = 'rectangle', width = 10, length = 10 }}\n{}",
        balls(["radius = 0.5", "radius = 0.125"])
    );
    let spheres = Scene::new(&scenario(&on_cloth), None).unwrap();
    let expected = -(0.5 / 4.0 * sin_60).asin().to_degrees(); // 2 √(R₁ R₂) = 0.5
    assert!(is_near(at_ball(&spheres, "1", 60.0).unwrap(), expected));
}

#[test]
fn the_ghost_lies_behind_the_ball_on_the_line_to_the_mouth() {
    let balls = [ball("cue", [0.635, 0.6], ""), ball("1", [0.9, 1.27], "")].concat();
    let scenario = scenario(&on_pool_table(&balls, ""));
    let scene = Scene::new(&scenario, None).unwrap();
    assert_eq!(aiming_point(&scenario, "rc"), Ok([1.27, 1.27]));
    let to_corner = 0.1159 / 8.0_f64.sqrt();
    let [x, y] = aiming_point(&scenario, "rt").unwrap();
    assert!(is_near(x, 1.27 - to_corner) && is_near(y, 2.54 - to_corner));
    let ghost = ghost_ball(&scene, "1", "rc").unwrap();
    assert!(is_near(ghost.center[0], 0.9 - 2.0 * POOL) && is_near(ghost.center[1], 1.27));
    let direction = (1.27_f64 - 0.6).atan2(ghost.center[0] - 0.635).to_degrees();
    assert!(is_near(ghost.direction_deg, direction) && is_near(ghost.cut_deg, -direction), "to the right");
    assert!(is_near(at_ball(&scene, "1", ghost.cut_deg).unwrap(), ghost.direction_deg), "both agree");
}

#[test]
fn a_bare_hole_is_aimed_at_in_its_middle() {
    let text = format!(
        "physics.flight.law = 'cloth'\ntable = {{ shape = 'rectangle', width = 1, length = 2, pockets = [{{ id = 'p', center = [0.5, 2], radius = 0.1 }}] }}\n{}",
        ball("white", [0.5, 0.5], "radius = 0.03")
    );
    assert_eq!(aiming_point(&scenario(&text), "p"), Ok([0.5, 2.0]));
}

#[test]
fn what_cannot_be_aimed_at_is_said() {
    let balls = [ball("cue", [0.5, 0.5], ""), ball("1", [0.9, 1.27], "")].concat();
    let scenario = scenario(&on_pool_table(&balls, ""));
    let scene = Scene::new(&scenario, None).unwrap();
    let message = |problem: carom::scenario::Problem| problem.to_string();
    assert_eq!(
        message(Scene::new(&scenario, Some("2")).unwrap_err()),
        "cue_ball: there is no ball \"2\"; known: cue, 1"
    );
    assert_eq!(
        message(at_ball(&scene, "2", 0.0).unwrap_err()),
        "ball: there is no ball \"2\"; known: cue, 1"
    );
    assert_eq!(
        message(at_ball(&scene, "cue", 0.0).unwrap_err()),
        "ball: \"cue\" is the cue ball, which cannot hit itself"
    );
    for cut in [90.0, -90.0, f64::NAN] {
        let expected = format!("cut_deg: must lie between -90 and 90, got {cut}");
        assert_eq!(message(at_ball(&scene, "1", cut).unwrap_err()), expected);
    }
    assert_eq!(
        message(at_point(&scene, [0.5, 0.5]).unwrap_err()),
        "point: is the centre of the cue ball: there is no direction to it"
    );
    assert!(at_point(&scene, [f64::NAN, 0.5]).is_err());
    assert_eq!(
        message(aiming_point(&scenario, "top").unwrap_err()),
        "pocket: there is no pocket \"top\"; known: lb, rb, rc, rt, lt, lc"
    );
    let behind = message(ghost_ball(&scene, "1", "lb").unwrap_err());
    assert!(behind.starts_with("pocket: ball \"1\" would have to be cut by 1"), "{behind}");
}

#[test]
fn a_ball_flies_over_another() {
    let text = on_pool_table(&[ball("cue", [0.5, 0.5], ""), ball("1", [0.9, 1.27], "")].concat(), "");
    let text = text.replace("air = false", "air = true").replace("1.27]", "1.27, 0.2]");
    let scene = Scene::new(&scenario(&text), None).unwrap();
    let problem = at_ball(&scene, "1", 0.0).unwrap_err();
    assert_eq!(problem.to_string(), "ball: the cue ball passes below or above ball \"1\"");
}
