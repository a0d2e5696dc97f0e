//! Periodic tables: what they refuse, and what lies where across their sides.

use crate::common::problems;
use carom::scenario::Scenario;

/// All problems of two balls of radius 0.1, one at the origin, on a table 2 long that is periodic along both axes.
fn with(place: [f64; 2], table: &str, rest: &str) -> Vec<String> {
    let [x, y] = place;
    problems(&format!(
        "duration = 1\n{rest}\n[table]\nshape = 'rectangle'\nlength = 2\n{table}\n[ball_defaults]\nradius = 0.1\n\
         [[balls]]\nid = 'a'\nposition = [0, 0]\nvelocity = [1, 0]\n[[balls]]\nid = 'b'\nposition = [{x}, {y}]\n"
    ))
}

const BOTH: &str = "width = 1\nperiodic = ['x', 'y']";

#[test]
fn balls_reach_over_open_sides_but_their_centres_do_not() {
    assert_eq!(with([0.5, 2.0], BOTH, ""), [""; 0]);
    assert_eq!(with([0.5, 2.01], BOTH, ""), ["balls[1].position: ball \"b\" lies outside the table"]);
    let across = with([0.5, 1.0], "width = 1\nperiodic = ['x']", "");
    assert_eq!(across, ["balls[0].position: ball \"a\" reaches past cushion \"bottom\" by 0.1"]);
}

#[test]
fn overlaps_are_found_across_each_side_and_across_the_corner() {
    for place in [[0.95, 0.0], [0.0, 1.95], [0.95, 1.95], [0.05, 1.95], [0.95, 0.05]] {
        let found = with(place, BOTH, "");
        assert_eq!(found.len(), 1, "{place:?}: {found:?}");
        assert!(
            found[0].starts_with("balls[1].position: ball \"b\" overlaps ball \"a\" by 0.1"),
            "{found:?}"
        );
    }
    assert_eq!(with([0.79, 0.0], BOTH, ""), [""; 0]);
    // Two balls that touch across a side do not overlap.
    assert_eq!(with([0.8, 0.0], BOTH, ""), [""; 0]);
}

#[test]
fn a_periodic_side_is_wider_than_three_balls() {
    let narrow = with([0.25, 1.0], "width = 0.6\nperiodic = ['x', 'y']", "");
    assert_eq!(
        narrow,
        ["table.width: must be more than 3 diameters of the largest ball, 0.6, where x is periodic; got 0.6"]
    );
    assert_eq!(with([0.25, 1.0], "width = 0.6001\nperiodic = ['x', 'y']", ""), [""; 0]);
}

#[test]
fn a_cushion_of_an_open_side_has_no_law() {
    let law = |side: &str| format!("physics.cushions.{side} = {{ law = 'damping', factor = 0.5 }}");
    assert_eq!(
        with([0.5, 1.0], BOTH, &law("left")),
        [
            "physics.cushions.left: the table has no such cushion: this side is periodic, and balls pass through it"
        ]
    );
    let wrong = with([0.5, 1.0], BOTH, &law("lefft"));
    assert_eq!(wrong, ["physics.cushions.lefft: the table has no such cushion or corner"]);
}

#[test]
fn periodic_sides_refuse_what_the_engine_does_not_have_for_them() {
    let refused = |table: &str, rest: &str| with([0.5, 1.0], table, rest);
    assert_eq!(
        refused("width = 1\nperiodic = ['x', 'x']", "").first().unwrap(),
        "table.periodic: names x twice"
    );
    let law = |law: &str| format!("physics.flight = {{ {law} }}");
    assert_eq!(
        refused(BOTH, &law("law = 'cloth'")),
        ["table.periodic: a table with periodic sides goes with no cloth (physics.flight.law)"]
    );
    let obstacle = "obstacles = [{ wall = [[0.2, 0.5], [0.2, 0.8]] }]";
    assert_eq!(
        refused(&format!("{BOTH}\n{obstacle}"), ""),
        ["table.periodic: a table with periodic sides goes with no obstacles (table.obstacles)"]
    );
    assert_eq!(
        refused(BOTH, "method = { kind = 'stepped', dt = 0.1 }"),
        ["method.kind: the stepped method knows no periodic sides; use the exact one"]
    );
    assert_eq!(
        refused("width = 1\nperiodic = ['z']", ""),
        ["table.periodic[0]: unknown value \"z\"; known: x, y"]
    );
}

#[test]
fn dead_cushions_do_not_end_what_goes_round() {
    let text = "[table]\nshape = 'rectangle'\nwidth = 1\nlength = 2\nperiodic = ['x']\n\
                [physics]\nball_cushion = { law = 'damping', factor = 0 }\n\
                [[balls]]\nid = 'a'\nradius = 0.1\nposition = [0.5, 0.5]\nvelocity = [1, 0]";
    let found = problems(text);
    assert!(found[0].starts_with("duration: missing, and not everything comes to rest"), "{found:?}");
    assert!(Scenario::from_toml(&text.replace("periodic = ['x']\n", "")).is_ok());
}
