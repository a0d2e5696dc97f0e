//! Tables become cushions and corners with the right names, places and directions.

use carom::geometry::{Piece, Vec2};
use carom::model::{OutlineKind, Table};
use carom::scalar::{Dual, Scalar};
use carom::scenario::Scenario;
use core::fmt::Display;

fn layout(table: &str) -> Table<f64> {
    let ball = "[[balls]]\nid = 'a'\nradius = 0\nposition = [0.25, 0.2]\n";
    let scenario = Scenario::from_toml(&format!("duration = 1\n[table]\n{table}\n{ball}")).unwrap();
    scenario.table.layout(&mut |_: &dyn Display, value| value)
}

fn ids(table: &Table<f64>) -> Vec<&str> {
    table.cushions().map(|cushion| cushion.id.as_str()).collect()
}

fn corners(table: &Table<f64>) -> Vec<(&str, [f64; 2])> {
    table.corners.iter().map(|corner| (corner.id.as_str(), corner.point.to_f64())).collect()
}

#[test]
fn a_rectangle_has_four_cushions_that_face_inwards_and_no_corners() {
    let table = layout("shape = 'rectangle'\nwidth = 1\nlength = 2");
    assert_eq!(ids(&table), ["bottom", "right", "top", "left"]);
    assert!(table.corners.is_empty());
    assert_eq!((table.bounds.min, table.bounds.max), (Vec2::ZERO, Vec2::new(1.0, 2.0)));
    assert_eq!(table.size(), 2.0);
    for cushion in table.cushions() {
        let inwards = Vec2::new(0.5, 1.0) - cushion.piece.middle();
        assert!(cushion.piece.start_direction().left().dot(inwards) > 0.0, "{}", cushion.id);
    }
}

#[test]
fn a_circle_is_one_hollow_cushion_around_the_origin() {
    let table = layout("shape = 'circle'\nradius = 1.5");
    assert_eq!(ids(&table), ["rim"]);
    assert!(table.corners.is_empty() && table.size() == 3.0);
    assert!(matches!(table.cushions().next().unwrap().piece, Piece::Arc(arc) if arc.counter_clockwise));
}

#[test]
fn an_l_shape_has_one_corner_where_it_turns_right() {
    let text = "shape = 'path'\npieces = [{ line = [[0, 0], [2, 0]] }, { line = [[2, 0], [2, 1]] }, \
                { id = 'inner', line = [[2, 1], [1, 1]] }, { line = [[1, 1], [1, 2]] }, { line = [[1, 2], [0, 2]] }, \
                { line = [[0, 2], [0, 0]] }]";
    let table = layout(text);
    assert_eq!(ids(&table), ["0", "1", "inner", "3", "4", "5"]);
    assert_eq!(corners(&table), [("inner/3", [1.0, 1.0])]);
    assert_eq!(table.corners[0].cushions, [2, 3]);
}

#[test]
fn obstacles_have_their_names_corners_and_directions() {
    let text = "shape = 'rectangle'\nwidth = 2\nlength = 2\nobstacles = [\
                { circle = { center = [1, 1.5], radius = 0.1 } }, { id = 'w', wall = [[0.5, 1], [0.5, 1.5]] }, \
                { path = [{ line = [[1, 0.5], [1.5, 1]] }, { id = 'back', line = [[1.5, 1], [1.5, 0.5]] }, \
                { line = [[1.5, 0.5], [1, 0.5]] }] }]";
    let table = layout(text);
    assert_eq!(ids(&table)[4..], ["obstacle0", "w.a", "w.b", "obstacle2.0", "obstacle2.back", "obstacle2.2"]);
    assert_eq!(
        corners(&table),
        [
            ("w.a/w.b", [0.5, 1.5]),
            ("w.b/w.a", [0.5, 1.0]),
            ("obstacle2.0/obstacle2.back", [1.5, 1.0]),
            ("obstacle2.back/obstacle2.2", [1.5, 0.5]),
            ("obstacle2.2/obstacle2.0", [1.0, 0.5]),
        ]
    );
    let kinds: Vec<OutlineKind> = table.outlines.iter().map(|outline| outline.kind).collect();
    assert_eq!(
        kinds,
        [OutlineKind::Boundary, OutlineKind::Obstacle, OutlineKind::Wall, OutlineKind::Obstacle]
    );
    let left_of_wall = table.cushions().nth(5).unwrap().piece.start_direction().left();
    assert_eq!(left_of_wall, Vec2::new(-1.0, 0.0), "side a faces the left of the wall");
}

#[test]
fn walls_that_meet_share_one_corner() {
    let table = layout(
        "shape = 'rectangle'\nwidth = 2\nlength = 2\n\
         obstacles = [{ id = 'u', wall = [[0.5, 1], [1, 1]] }, { id = 'v', wall = [[1, 1], [1, 1.5]] }]",
    );
    let points: Vec<[f64; 2]> = corners(&table).into_iter().map(|(_, point)| point).collect();
    assert_eq!(points, [[1.0, 1.0], [0.5, 1.0], [1.0, 1.5]]);
}

#[test]
fn smooth_joints_have_no_corners_and_cusps_stick_out() {
    let stadium = "shape = 'path'\npieces = [{ line = [[0, 0], [1, 0]] }, \
                   { arc = { center = [1, 0.5], radius = 0.5, from_deg = -90, to_deg = 90 } }, { line = [[1, 1], [0, 1]] }, \
                   { arc = { center = [0, 0.5], radius = 0.5, from_deg = 90, to_deg = 270 } }]";
    assert_eq!(corners(&layout(stadium)), []);
    assert_eq!(layout(stadium).size(), 2.0);
    // A half disc stands on the long side: sharp right turns where it begins and ends.
    let bump = "shape = 'path'\npieces = [{ line = [[0, 0], [0.5, 0]] }, \
                { arc = { center = [1, 0], radius = 0.5, from_deg = 180, to_deg = 0 } }, { line = [[1.5, 0], [2, 0]] }, \
                { line = [[2, 0], [2, 2]] }, { line = [[2, 2], [0, 2]] }, { line = [[0, 2], [0, 0]] }]";
    assert_eq!(corners(&layout(bump)), [], "the foot of a bump is a hollow corner");
    let dent = "shape = 'path'\npieces = [{ line = [[0, 0], [0.5, 0]] }, \
                { arc = { center = [1, 0], radius = 0.5, from_deg = 180, to_deg = 360 } }, { line = [[1.5, 0], [2, 0]] }, \
                { line = [[2, 0], [2, 2]] }, { line = [[2, 2], [0, 2]] }, { line = [[0, 2], [0, 0]] }]";
    assert_eq!(corners(&layout(dent)), [("0/1", [0.5, 0.0]), ("1/2", [1.5, 0.0])]);
    assert_eq!(layout(dent).bounds.min, Vec2::new(0.0, -0.5), "the dent counts for the box");
}

#[test]
fn line_ends_are_moved_onto_their_neighbours() {
    let table = layout(
        "shape = 'path'\npieces = [{ line = [[0, 0], [1.0000000001, 0]] }, \
         { arc = { center = [0.5, 0], radius = 0.5, from_deg = 0, to_deg = 180 } }]",
    );
    let pieces: Vec<Piece<f64>> = table.cushions().map(|cushion| cushion.piece).collect();
    assert_eq!((pieces[0].end(), pieces[1].end()), (pieces[1].start(), pieces[0].start()));
}

#[test]
fn every_number_of_a_scenario_enters_with_its_place() {
    let scenario = Scenario::from_toml(include_str!("../../../../scenarios/pinball.toml")).unwrap();
    let mut places = Vec::new();
    let mut note = |place: &dyn Display, value: f64| {
        places.push((place.to_string(), value));
        value
    };
    scenario.table.layout(&mut note);
    for (index, ball) in scenario.balls.iter().enumerate() {
        ball.start(index, &scenario.ball_defaults, &mut note);
    }
    assert!(places.len() > 50);
    for (place, value) in places {
        assert_eq!(scenario.value(&place).unwrap().as_f64(), Some(value), "{place}");
        assert_eq!(scenario.place(&place), Ok(place));
    }
}

#[test]
fn speed_and_direction_make_a_velocity() {
    let text = "duration = 1\nball_defaults.mass = 3\n[table]\nshape = 'circle'\nradius = 1\n[[balls]]\nid = 'a'\n\
                radius = 0.1\nposition = [0.5, 0]\nspeed = 2\ndirection_deg = 90";
    let scenario = Scenario::from_toml(text).unwrap();
    let start = scenario.balls[0].start(0, &scenario.ball_defaults, &mut |_: &dyn Display, value: f64| value);
    assert_eq!((start.mass, start.radius), (3.0, 0.1));
    assert!(start.velocity.x.abs() == 0.0 && start.velocity.y == 2.0);
}

#[test]
fn one_number_can_enter_as_the_variable_of_a_derivative() {
    let scenario = Scenario::from_toml(include_str!("../../../../scenarios/midterm.toml")).unwrap();
    let variable = scenario.place("ball_defaults.radius").unwrap();
    let mut number = |place: &dyn Display, value: f64| {
        if place.to_string() == variable { Dual::<1>::variable(value, 0) } else { Dual::from_f64(value) }
    };
    for (index, ball) in scenario.balls.iter().enumerate() {
        let start = ball.start(index, &scenario.ball_defaults, &mut number);
        assert_eq!(
            (start.radius.value, start.radius.derivatives),
            (0.075, [1.0]),
            "both balls share the default"
        );
        assert_eq!(start.position.x.derivatives, [0.0]);
    }
    let width = |place: &dyn Display, value: f64| {
        if place.to_string() == "table.width" { Dual::<1>::variable(value, 0) } else { Dual::from_f64(value) }
    };
    let table = scenario.table.layout(&mut { width });
    let right = table.cushions().find(|cushion| cushion.id == "right").unwrap();
    assert_eq!(right.piece.start().x.derivatives, [1.0]);
    assert_eq!((table.size().value, table.bounds.max.x.derivatives), (2.0, [1.0]));
}
