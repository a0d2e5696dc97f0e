//! The outline of tables with pockets: closed, symmetric, wide enough for a ball, and with a back that no ball touches.

use crate::common::problems;
use carom::geometry::{Piece, Vec2, signed_area, signed_distance};
use carom::model::{Pocket, Table};
use carom::scenario::schema::{self, Preset};

/// Presets that have pockets, laid out, with the radius of their balls.
fn tables() -> Vec<(&'static str, Table<f64>, f64)> {
    let with_pockets = Preset::ALL.into_iter().filter_map(|preset| {
        let equipment = preset.equipment();
        let table = equipment.table.layout(&mut |_, value| value);
        (!table.pockets.is_empty()).then(|| (preset.name(), table, equipment.ball_defaults.radius.unwrap()))
    });
    with_pockets.collect()
}

fn pieces(table: &Table<f64>) -> Vec<Piece<f64>> {
    table.cushions().map(|cushion| cushion.piece).collect()
}

fn piece(table: &Table<f64>, id: &str) -> Piece<f64> {
    table.cushions().find(|cushion| cushion.id == id).unwrap_or_else(|| panic!("no cushion {id}")).piece
}

fn size_of(preset: &str) -> [f64; 2] {
    let preset = Preset::ALL.into_iter().find(|known| known.name() == preset).unwrap();
    match &preset.equipment().table {
        schema::Table::PocketTable { width, length, .. } => [*width, *length],
        other => panic!("{other:?} is no pocket table"),
    }
}

#[test]
fn the_outline_is_closed_and_runs_counter_clockwise() {
    for (name, table, _) in tables() {
        let pieces = pieces(&table);
        for (index, piece) in pieces.iter().enumerate() {
            let gap = (piece.end() - pieces[(index + 1) % pieces.len()].start()).norm();
            assert!(gap < 1e-13 * table.size(), "{name}: a gap of {gap} after piece {index}");
        }
        let [width, length] = size_of(name);
        let area = signed_area(&pieces);
        assert!(area > width * length && area < 1.15 * width * length, "{name}: {area}");
    }
}

#[test]
fn jaws_meet_noses_and_facings_without_a_bend() {
    for (name, table, _) in tables() {
        let cushions: Vec<_> = table.cushions().collect();
        for pair in cushions.windows(2) {
            let (before, after) = (&pair[0], &pair[1]);
            let is_smooth = !before.id.ends_with("back") && !after.id.ends_with("back");
            let bend = before.piece.end_direction().cross(after.piece.start_direction());
            assert!(!is_smooth || bend.abs() < 1e-9, "{name}: {} to {} bends by {bend}", before.id, after.id);
        }
        // So the only corners are where a pocket's back begins and ends.
        assert!(table.corners.iter().all(|corner| corner.id.contains(".back")), "{name}");
    }
}

#[test]
fn left_and_right_and_top_and_bottom_are_images_of_each_other() {
    let swap = |id: &str, words: [&str; 2], letters: [char; 2]| {
        let (pocket, rest) = id.split_once('.').map_or(("", id), |(pocket, rest)| (pocket, rest));
        let letter = |c: char| match c {
            _ if c == letters[0] => letters[1],
            _ if c == letters[1] => letters[0],
            _ => c,
        };
        let rest = rest.replace(words[0], "#").replace(words[1], words[0]).replace('#', words[1]);
        let pocket: String = pocket.chars().map(letter).collect();
        if pocket.is_empty() { rest } else { format!("{pocket}.{rest}") }
    };
    for (name, table, _) in tables() {
        let [width, length] = size_of(name);
        let across = |p: Vec2<f64>| Vec2::new(width - p.x, p.y);
        let along = |p: Vec2<f64>| Vec2::new(p.x, length - p.y);
        for cushion in table.cushions() {
            let check = |other: &str, image: &dyn Fn(Vec2<f64>) -> Vec2<f64>| {
                let other = piece(&table, other);
                let apart =
                    [image(cushion.piece.start()) - other.end(), image(cushion.piece.end()) - other.start()];
                assert!(apart.iter().all(|gap| gap.norm() < 1e-14), "{name}: {}", cushion.id);
                assert!(
                    (image(cushion.piece.middle()) - other.middle()).norm() < 1e-14,
                    "{name}: {}",
                    cushion.id
                );
            };
            check(&swap(&cushion.id, ["left", "right"], ['l', 'r']), &across);
            let upside_down = swap(&cushion.id, ["top", "bottom"], ['t', 'b']);
            check(&swap(&upside_down, ["lower", "upper"], ['-', '-']), &along);
        }
    }
}

#[test]
fn the_mouth_lies_between_the_horn_tips() {
    for preset in [Preset::Pool9ft, Preset::Pooltool7ft, Preset::Snooker12ft] {
        let schema::Table::PocketTable { corner, side, .. } = &preset.equipment().table else { panic!() };
        let sharp = |mouth: schema::MouthShape| schema::MouthShape { jaw_radius: 0.0, ..mouth };
        let mut written = preset.equipment().table.clone();
        if let schema::Table::PocketTable { corner, side, .. } = &mut written {
            (*corner, *side) = (sharp(*corner), sharp(*side));
        }
        let table = written.layout(&mut |_, value| value);
        assert!(table.cushions().all(|cushion| !cushion.id.contains("jaw")), "a sharp horn has no jaw");
        let corner_mouth = (piece(&table, "left_lower").end() - piece(&table, "bottom").start()).norm();
        let side_mouth = (piece(&table, "right_lower").end() - piece(&table, "right_upper").start()).norm();
        assert!((corner_mouth - corner.width).abs() < 1e-15 && (side_mouth - side.width).abs() < 1e-15);
        let ends = [piece(&table, "lc.facing_lower"), piece(&table, "lc.facing_upper")].map(|facing| facing);
        // A facing turns by the angle from the axis of a side, which is the x axis.
        let turned = ends[0].start_direction();
        let expected = side.angle_deg.to_radians().tan();
        assert!(((turned.y / turned.x).abs() - expected).abs() < 1e-12, "{turned:?} for {expected}");
    }
}

/// How far a point is from the nearest cushion, negative outside the table.
fn room(table: &Table<f64>, point: Vec2<f64>) -> f64 {
    signed_distance(&pieces(table), point)
}

/// The direction in which a ball rolls into a pocket straight.
fn axis(table: &Table<f64>, pocket: &Pocket<f64>) -> Vec2<f64> {
    let back = piece(table, &format!("{}.back", pocket.id));
    (back.middle() - pocket.center).unit()
}

#[test]
fn a_ball_on_the_axis_of_a_mouth_falls_without_touching_anything() {
    for (name, table, radius) in tables() {
        for pocket in &table.pockets {
            let axis = axis(&table, pocket);
            let mut fell = false;
            for step in 0..300 {
                let point = pocket.center - axis * (0.3 - 0.001 * f64::from(step));
                fell |= pocket.has_inside(point);
                assert!(fell || room(&table, point) > radius, "{name}: touched before pocket {}", pocket.id);
            }
            assert!(fell);
        }
    }
}

#[test]
fn no_ball_touches_the_back_of_a_pocket_before_it_falls() {
    for (name, table, radius) in tables() {
        for pocket in &table.pockets {
            let back = piece(&table, &format!("{}.back", pocket.id));
            // Everywhere on the table's side of the back, at the distance at which a ball touches it.
            let Piece::Arc(arc) = back else { panic!("a back is an arc") };
            assert!((arc.center - pocket.center).norm() < 1e-15 && arc.counter_clockwise, "{name}");
            assert!(arc.radius - radius <= pocket.radius, "{name}: pocket {}", pocket.id);
            assert!(arc.sweep_deg > 90.0 && arc.sweep_deg < 300.0, "{name}: {}", arc.sweep_deg);
        }
    }
}

#[test]
fn pockets_have_pooltools_names_and_lie_where_it_puts_them() {
    let table = Preset::Pooltool7ft.equipment().table.layout(&mut |_, value: f64| value);
    let ids: Vec<&str> = table.pockets.iter().map(|pocket| pocket.id.as_str()).collect();
    assert_eq!(ids, ["lb", "rb", "rc", "rt", "lt", "lc"]);
    let corner = 0.0417 / 2f64.sqrt();
    let expected = [
        (-corner, -corner),
        (0.9906 + corner, -corner),
        (0.9906 + 0.0685, 0.9906),
        (0.9906 + corner, 1.9812 + corner),
        (-corner, 1.9812 + corner),
        (-0.0685, 0.9906),
    ];
    for (pocket, (x, y)) in table.pockets.iter().zip(expected) {
        assert!((pocket.center - Vec2::new(x, y)).norm() < 1e-15, "{}", pocket.id);
        assert_eq!(pocket.radius, if pocket.id.ends_with('c') { 0.0645 } else { 0.062 });
    }
    // The centres of pooltool's jaws 8t and 4t.
    let center = |id: &str| match piece(&table, id) {
        Piece::Arc(arc) => arc.center,
        Piece::Line(_) => panic!("{id} is round"),
    };
    assert!((center("lt.jaw_top") - Vec2::new(0.091002, 1.9812 + 0.02095)).norm() < 1e-6);
    assert!((center("lc.jaw_lower") - Vec2::new(-0.00795, 0.915084)).norm() < 1e-6);
}

#[test]
fn a_jaw_longer_than_its_facing_ends_as_deep_as_the_cushion() {
    let table = Preset::Snooker12ft.equipment().table.layout(&mut |_, value: f64| value);
    assert!(table.cushions().all(|cushion| !cushion.id.starts_with("lc.facing")));
    assert!((piece(&table, "lc.jaw_lower").start().x + 0.04763).abs() < 1e-15);
    assert!(table.cushions().any(|cushion| cushion.id == "lb.facing_left"), "the corners have facings");
}

fn pocket_table(change: &str, by: &str) -> Vec<String> {
    let text = "physics.flight.law = 'cloth'\n[table]\nshape = 'pocket_table'\nwidth = 1\nlength = 2\ncushion_width = 0.05\n\
                corner = { width = 0.12, angle_deg = 5, depth = 0.04, radius = 0.06, jaw_radius = 0.02 }\n\
                side = { width = 0.13, angle_deg = 7, depth = 0.07, radius = 0.07, jaw_radius = 0.01 }\n\
                nose_height = 0.036\n[[balls]]\nid = 'a'\nradius = 0.03\nposition = [0.5, 0.5]\n";
    assert!(text.contains(change), "{change}");
    problems(&text.replacen(change, by, 1))
}

#[test]
fn pockets_that_make_no_sense_are_refused() {
    assert_eq!(pocket_table("width = 1\n", "width = 1\n"), [""; 0]);
    assert_eq!(
        pocket_table("width = 0.13", "width = 2.5"),
        [
            "table.side: leaves nothing of the cushions right_lower, right_upper, left_upper, left_lower: make the mouths or \
             jaws smaller"
        ]
    );
    assert_eq!(
        pocket_table("jaw_radius = 0.02", "jaw_radius = 1.5"),
        ["table.corner: leaves nothing of the cushions bottom, top: make the mouths or jaws smaller"]
    );
    assert_eq!(
        pocket_table("width = 0.12", "width = 0.05"),
        ["table.corner.width: must be more than a ball, 0.06, got 0.05"]
    );
    let small = pocket_table("radius = 0.06,", "radius = 0.02,");
    assert!(
        small[0].starts_with("table.corner.radius: is too small: a ball of radius 0.03 would touch the back of the pocket before it falls; at least 0.0"),
        "{small:?}"
    );
    assert_eq!(
        pocket_table("angle_deg = 5", "angle_deg = 60"),
        ["table.corner.angle_deg: must be between -30 and 40, got 60"]
    );
    assert_eq!(pocket_table("depth = 0.04, ", ""), ["table.corner.depth: missing: expected a number"]);
    let crossing = pocket_table("angle_deg = 7", "angle_deg = 40").join("\n");
    assert_eq!(crossing, "", "facings that still leave a throat are allowed");
    let crossing = pocket_table("width = 0.13, angle_deg = 7", "width = 0.08, angle_deg = 40").join("\n");
    assert!(crossing.contains("crosses cushion"), "{crossing}");
    assert_eq!(
        pocket_table("nose_height = 0.036", "nose_height = 0.06"),
        ["table.nose_height: must be less than the diameter 0.06 of ball \"a\", got 0.06"]
    );
    assert_eq!(
        pocket_table("[0.5, 0.5]", "[-0.01, 1.0]"),
        ["balls[0].position: ball \"a\" lies over pocket \"lc\""]
    );
}

#[test]
fn any_shape_may_have_pockets_and_noses() {
    let round = |pockets: &str| {
        problems(&format!(
            "physics.flight.law = 'cloth'\n[table]\nshape = 'circle'\nradius = 1\nnose_height = 0.03\nnose_contact = 'plan'\n\
             pockets = [{pockets}]\n[[balls]]\nid = 'a'\nradius = 0.03\nposition = [0.5, 0.5]\n"
        ))
    };
    assert_eq!(round("{ id = 'p', center = [0, 0], radius = 0.1 }"), [""; 0]);
    assert_eq!(
        round("{ id = 'p', center = [0, 0], radius = 0.1 }, { id = 'p', center = [0, 0.5], radius = 0.1 }"),
        ["table.pockets[1].id: \"p\" is the id of table.pockets[0] already"]
    );
    assert_eq!(
        round("{ id = 'p', center = [0.5, 0.55], radius = 0.1 }"),
        ["balls[0].position: ball \"a\" lies over pocket \"p\""]
    );
    assert_eq!(
        round("{ id = 'p', center = [0.5, 0.55], radius = -1 }"),
        ["table.pockets[0].radius: must be positive and finite, got -1"]
    );
}

#[test]
fn a_ball_may_lie_as_near_to_a_cushion_as_its_nose_lets_it() {
    // R = 0.03 and a nose 0.01 above the centre: R cos θ = sqrt(0.0009 − 0.0001) = 0.0282843.
    let at = |x: f64, contact: &str| {
        problems(&format!(
            "physics.flight.law = 'cloth'\n[table]\nshape = 'rectangle'\nwidth = 1\nlength = 1\nnose_height = 0.04\n\
             nose_contact = '{contact}'\n[[balls]]\nid = 'a'\nradius = 0.03\nposition = [{x}, 0.5]\n"
        ))
    };
    assert_eq!(at(0.028285, "nose"), [""; 0]);
    assert_eq!(
        at(0.0282, "nose"),
        ["balls[0].position: ball \"a\" reaches past cushion \"left\" by 8.427e-5"]
    );
    assert_eq!(
        at(0.028285, "plan"),
        ["balls[0].position: ball \"a\" reaches past cushion \"left\" by 0.001715"]
    );
}
