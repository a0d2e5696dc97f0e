//! Problems of boundaries and obstacles.

use crate::common::{on_table, with_obstacles};

fn path(pieces: &str) -> Vec<String> {
    on_table(&format!("shape = 'path'\npieces = [{pieces}]"))
}

#[test]
fn a_gap_is_reported_with_its_size() {
    assert_eq!(
        path("{ line = [[0, 0], [1, 0]] }, { line = [[1, 0.25], [1, 1]] }, { line = [[1, 1], [0, 0.1]] }"),
        [
            "table.pieces[0]: begins at [0, 0], but the last piece ends at [0, 0.1]: a gap of 0.1",
            "table.pieces[1]: begins at [1, 0.25], but the piece before ends at [1, 0]: a gap of 0.25",
        ]
    );
}

#[test]
fn ends_within_a_billionth_become_one_joint() {
    let triangle = |x: &str| {
        path(&format!(
            "{{ line = [[0, 0], [1, 0]] }}, {{ line = [[{x}, 0], [1, 1]] }}, {{ line = [[1, 1], [0, 0]] }}"
        ))
    };
    assert_eq!(triangle("1.0000000005"), [""; 0]);
    assert_eq!(
        triangle("1.000000002"),
        ["table.pieces[1]: begins at [1.000000002, 0], but the piece before ends at [1, 0]: a gap of 2e-9"]
    );
    let half_disc = |x: &str| {
        let arc = "{ arc = { center = [0.5, 0], radius = 0.5, from_deg = 0, to_deg = 180 } }";
        path(&format!("{{ line = [[0, 0], [{x}, 0]] }}, {arc}"))
    };
    assert_eq!(half_disc("1.0000000001"), [""; 0], "a line is fitted to an arc");
}

#[test]
fn two_arcs_must_meet_more_exactly_than_lines() {
    let lens = |y: &str| {
        path(&format!(
            "{{ arc = {{ center = [0.5, {y}], radius = 1, from_deg = -150, to_deg = -30 }} }}, \
             {{ arc = {{ center = [0.5, -0.5], radius = 1, from_deg = 30, to_deg = 150 }} }}"
        ))
    };
    assert_eq!(lens("0.5"), [""; 0]);
    let found = lens("0.5000000003");
    assert!(found[0].ends_with("a gap of 3e-10 (arcs must meet more exactly than lines)"), "{found:?}");
}

#[test]
fn pieces_without_length_and_arcs_of_more_than_a_circle_are_refused() {
    assert_eq!(
        path(
            "{ line = [[0, 0], [1, 0]] }, { line = [[1, 0], [1, 0]] }, { line = [[1, 0], [1, 1]] }, \
             { line = [[1, 1], [0, 0]] }"
        ),
        ["table.pieces[1]: has no length: it starts and ends at [1, 0]"]
    );
    let arc = |to: &str| {
        path(&format!("{{ arc = {{ center = [0.5, 0.2], radius = 1, from_deg = 0, to_deg = {to} }} }}"))
    };
    assert_eq!(arc("360"), [""; 0], "a full circle is a boundary of one piece");
    assert_eq!(arc("720"), ["table.pieces[0]: runs through 720 degrees: at most 360, a full circle"]);
    assert_eq!(arc("0"), ["table.pieces[0]: has no length: it starts and ends at [1.5, 0.2]"]);
    assert_eq!(
        with_obstacles("{ wall = [[0.3, 0.3], [0.3, 0.3]] }"),
        ["table.obstacles[0]: has no length: it starts and ends at [0.3, 0.3]"]
    );
}

#[test]
fn boundaries_run_counter_clockwise_and_obstacles_clockwise() {
    let how = "reverse the order of the pieces and the direction of each";
    assert_eq!(
        path("{ line = [[0, 0], [0, 1]] }, { line = [[0, 1], [1, 1]] }, { line = [[1, 1], [0, 0]] }"),
        [format!("table.pieces: runs clockwise, but a boundary runs counter-clockwise: {how}")]
    );
    let triangle = "{ line = [[0.4, 0.4], [0.6, 0.4]] }, { line = [[0.6, 0.4], [0.5, 0.6]] }, \
                    { line = [[0.5, 0.6], [0.4, 0.4]] }";
    assert_eq!(
        with_obstacles(&format!("{{ path = [{triangle}] }}")),
        [format!("table.obstacles[0]: runs counter-clockwise, but an obstacle runs clockwise: {how}")]
    );
    assert_eq!(
        path("{ line = [[0, 0], [1, 0]] }, { line = [[1, 0], [0, 0]] }"),
        ["table.pieces: encloses no area"]
    );
}

#[test]
fn a_boundary_does_not_cross_touch_or_double_itself() {
    assert_eq!(
        path(
            "{ line = [[0, 0], [1, 0]] }, { line = [[1, 0], [0, 1]] }, { line = [[0, 1], [0.8, 1]] }, \
             { line = [[0.8, 1], [0, 0]] }"
        ),
        ["table.pieces[3]: cushion \"3\" crosses cushion \"1\" at [0.4444444444444444, 0.5555555555555556]"]
    );
    let pinched = "{ line = [[0, 0], [1, 0]] }, { line = [[1, 0], [1, 1]] }, { line = [[1, 1], [0.5, 0]] }, \
                   { line = [[0.5, 0], [0, 1]] }, { line = [[0, 1], [0, 0]] }";
    let found = path(pinched);
    assert!(found[0].contains("cushion \"2\" touches cushion \"0\" at [0.5, 0]"), "{found:?}");
    let spike = "{ line = [[0, 0], [1, 0]] }, { line = [[1, 0], [1, 1]] }, { line = [[1, 1], [2, 1]] }, \
                 { line = [[2, 1], [0, 1]] }, { line = [[0, 1], [0, 0]] }";
    let found = path(spike);
    assert!(
        found.iter().any(|problem| problem.contains("cushion \"3\" lies upon cushion \"2\"")),
        "{found:?}"
    );
}

#[test]
fn obstacles_stand_inside_the_table_and_beside_each_other() {
    let circle =
        |x: f64, y: f64, radius: f64| format!("{{ circle = {{ center = [{x}, {y}], radius = {radius} }} }}");
    assert_eq!(
        with_obstacles(&circle(1.0, 0.5, 0.1)),
        ["table.obstacles[0]: cushion \"obstacle0\" crosses cushion \"right\" at [1, 0.6]"]
    );
    assert_eq!(with_obstacles(&circle(2.0, 0.5, 0.1)), ["table.obstacles[0]: lies outside the table"]);
    assert_eq!(with_obstacles(&circle(0.8, 0.5, 0.2)), [""; 0], "an obstacle may touch the boundary");
    let nested = format!("{}, {}", circle(0.5, 0.6, 0.2), circle(0.5, 0.6, 0.1));
    assert_eq!(with_obstacles(&nested), ["table.obstacles[1]: lies inside obstacle \"obstacle0\""]);
    let twice = format!("{}, {}", circle(0.5, 0.6, 0.2), circle(0.5, 0.6, 0.2));
    let found = with_obstacles(&twice);
    assert!(found[0].contains("cushion \"obstacle1\" lies upon cushion \"obstacle0\""), "{found:?}");
    let crossing = format!("{}, {}", circle(0.5, 0.6, 0.2), circle(0.7, 0.6, 0.1));
    assert!(with_obstacles(&crossing)[0].starts_with("table.obstacles[1]: cushion \"obstacle1\" crosses"));
}

#[test]
fn walls_may_touch_but_not_cross() {
    assert_eq!(with_obstacles("{ wall = [[0.7, 0], [0.7, 1]] }, { wall = [[0.7, 0.5], [1, 0.5]] }"), [""; 0]);
    assert_eq!(
        with_obstacles("{ id = 'p', wall = [[0.6, 0], [0.6, 0.5]] }, { wall = [[0.4, 0.25], [0.8, 0.25]] }"),
        ["table.obstacles[1]: cushion \"obstacle1.a\" crosses cushion \"p.a\" at [0.6, 0.25]"]
    );
    for wall in ["[[0, 0], [0.6, 0]]", "[[0.6, 0], [0, 0]]"] {
        let found = with_obstacles(&format!("{{ id = 'p', wall = {wall} }}"));
        assert!(found[0].contains("cushion \"p.a\" lies upon cushion \"bottom\""), "{found:?}");
    }
    assert!(with_obstacles("{ wall = [[0.6, 0.5], [1.2, 0.5]] }")[0].contains("crosses cushion \"right\""));
    assert_eq!(
        with_obstacles(
            "{ wall = [[0.5, 0.5], [0.9, 0.5]] }, { circle = { center = [0.7, 0.5], radius = 0.1 } }"
        )
        .len(),
        1
    );
}

#[test]
fn a_block_may_stand_flush_at_the_wall() {
    let block = "{ path = [{ line = [[0.7, 0], [0.7, 0.5]] }, { line = [[0.7, 0.5], [0.9, 0.5]] }, \
                 { line = [[0.9, 0.5], [0.9, 0]] }, { line = [[0.9, 0], [0.7, 0]] }] }";
    assert_eq!(with_obstacles(block), [""; 0]);
}

#[test]
fn ids_of_cushions_and_obstacles_are_given_once() {
    let circle =
        |id: &str, x: f64| format!("{{ id = '{id}', circle = {{ center = [{x}, 0.8], radius = 0.05 }} }}");
    assert_eq!(
        with_obstacles(&format!("{}, {}", circle("p", 0.2), circle("p", 0.4))),
        ["table.obstacles[1].id: \"p\" is the id of table.obstacles[0] already"]
    );
    assert_eq!(
        with_obstacles(&circle("left", 0.2)),
        ["table.obstacles[0]: its id \"left\" is the id of a cushion of table already"]
    );
    assert_eq!(
        with_obstacles(&circle("a/b", 0.2)),
        [
            "table.obstacles[0].id: \"a/b\" must not contain /, which joins the names of two cushions at a corner"
        ]
    );
    assert_eq!(
        path(
            "{ id = '2', line = [[0, 0], [1, 0]] }, { line = [[1, 0], [1, 1]] }, { line = [[1, 1], [0, 0]] }"
        ),
        ["table.pieces[2]: its id \"2\" is the id of a cushion of table.pieces[0] already"]
    );
}
