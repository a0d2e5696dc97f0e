//! Problems that no single number shows: balls, laws, endings, the stepped method.

use crate::common::{MIDTERM, broken, problems, with_obstacles};

#[test]
fn all_problems_are_reported_at_once() {
    let balls = r#"
[[balls]]
id = "green"
radius = nan
position = [0.2, 1.7]
velocty = [1, 0]
[[balls]]
id = "red"
position = [3, 3]
color = "rde"
[[balls]]
id = "white"
position = [0.53, 1.0]
speed = 1
"#;
    let text = MIDTERM.replace("factor = 0.8", "factor = 8") + balls;
    assert_eq!(
        problems(&text),
        [
            "physics.ball_cushion.factor: must be between 0 and 1, got 8",
            "balls[2].radius: must be finite, got nan",
            "balls[2].velocty: unknown key; did you mean velocity? \
         known: id, radius, mass, sliding_friction, rolling_friction, spin_decay, position, velocity, spin, speed, \
         direction_deg, color",
            "balls[3].id: \"red\" is the id of balls[0] already",
            "balls[3].color: \"rde\" is no CSS colour name, #rgb or #rrggbb; did you mean red?",
            "balls[4].direction_deg: missing: speed needs a direction, in degrees from the x axis towards the y axis",
            "balls[3].position: ball \"red\" lies outside the table",
            "balls[4].position: ball \"white\" overlaps ball \"blue\" by 0.12",
        ]
    );
}

#[test]
fn what_one_broken_part_leaves_is_still_checked() {
    let text =
        MIDTERM.replace("position = [0.1, 0.1]", "position = [0.1]").replace("id = \"blue\"", "id = \"\\n\"");
    assert_eq!(
        problems(&text),
        [
            "balls[0].position: expected a list of 2 or 3 numbers, got 1 of them",
            "balls[1].id: \"\\n\" is no usable id: no quotes, no control characters, no space around it",
        ]
    );
    let text =
        MIDTERM.replace("width = 1.0", "").replace("[0.5, 1.0]", "[0.5, 1.0]\nspeed = 1\nvelocity = [1, 0]");
    assert_eq!(
        problems(&text),
        [
            "table.width: missing: expected a number",
            "balls[1].velocity: is given beside speed: give velocity, or speed and direction_deg",
        ]
    );
}

#[test]
fn ids_of_balls_must_be_usable_and_given_once() {
    assert_eq!(
        broken("id = \"blue\"", "id = \"red\""),
        ["balls[1].id: \"red\" is the id of balls[0] already"]
    );
    for id in ["' a'", "'a\"b'", "'a '", "\"a\\u0007\""] {
        assert!(broken("id = \"blue\"", &format!("id = {id}"))[0].contains("is no usable id"), "{id}");
    }
    for id in ["8", "ö", "a.b", "a b", "[0]"] {
        assert_eq!(broken("id = \"blue\"", &format!("id = '{id}'")), [""; 0], "{id} is an id");
    }
}

#[test]
fn a_radius_must_stand_somewhere() {
    assert_eq!(
        broken("[ball_defaults]\nradius = 0.075", ""),
        [
            "balls[0].radius: missing: give ball \"red\" a radius here, or all balls in ball_defaults.radius",
            "balls[1].radius: missing: give ball \"blue\" a radius here, or all balls in ball_defaults.radius",
        ]
    );
}

#[test]
fn velocity_is_given_in_one_way() {
    let with = |text: &str| broken("velocity = [3.0, 4.0]", text);
    let either = "give velocity, or speed and direction_deg";
    assert_eq!(
        with("velocity = [3, 4]\nspeed = 5\ndirection_deg = 1"),
        [format!("balls[0].velocity: is given beside speed: {either}")]
    );
    assert_eq!(
        with("velocity = [3, 4]\ndirection_deg = 1"),
        [format!("balls[0].velocity: is given beside direction_deg: {either}")]
    );
    assert_eq!(with("direction_deg = 1"), ["balls[0].speed: missing: direction_deg needs a speed"]);
    assert_eq!(with("speed = 5\ndirection_deg = 53.13"), [""; 0]);
}

#[test]
fn colours_are_names_hexadecimal_or_fractions() {
    let with = |color: &str| broken("\"crimson\"", color).join("\n");
    for color in ["'rebeccapurple'", "'#fa0'", "'#FFaa00'", "[1, 0.5, 0]"] {
        assert_eq!(with(color), "");
    }
    let wrong = "is no CSS colour name, #rgb or #rrggbb";
    assert_eq!(with("'crimsom'"), format!("balls[0].color: \"crimsom\" {wrong}; did you mean crimson?"));
    assert_eq!(with("'#ff00f'"), format!("balls[0].color: \"#ff00f\" {wrong}"));
    assert_eq!(with("[255, 0, 0]"), "balls[0].color[0]: must be between 0 and 1, got 255");
}

#[test]
fn balls_lie_inside_the_table() {
    assert_eq!(
        broken("[0.5, 1.0]", "[1.5, 1.0]"),
        ["balls[1].position: ball \"blue\" lies outside the table"]
    );
    assert_eq!(
        broken("[0.5, 1.0]", "[0.95, 1.95]"),
        [
            "balls[1].position: ball \"blue\" reaches past cushion \"right\" by 0.025 and cushion \"top\" by 0.025"
        ]
    );
    assert_eq!(broken("[0.5, 1.0]", "[0.925, 1.925]"), [""; 0], "touching two cushions is legal");
    // The tolerance is 1e-10 radii and 1e-13 table sizes: here 7.7e-12.
    assert_eq!(broken("[0.5, 1.0]", "[0.925000000005, 1.0]"), [""; 0]);
    assert_eq!(
        broken("[0.5, 1.0]", "[0.92500000001, 1.0]"),
        ["balls[1].position: ball \"blue\" reaches past cushion \"right\" by 1e-11"]
    );
}

#[test]
fn balls_do_not_overlap_but_may_touch() {
    assert_eq!(
        broken("[0.5, 1.0]", "[0.2, 0.1]"),
        ["balls[1].position: ball \"blue\" overlaps ball \"red\" by 0.05"]
    );
    assert_eq!(broken("[0.5, 1.0]", "[0.25, 0.1]"), [""; 0], "an exactly frozen pair is legal");
    // The tolerance is 1e-10 (r_a + r_b) and 1e-13 table sizes: here 1.52e-11.
    assert_eq!(broken("[0.5, 1.0]", "[0.249999999986, 0.1]"), [""; 0]);
    assert_eq!(
        broken("[0.5, 1.0]", "[0.249999999984, 0.1]"),
        ["balls[1].position: ball \"blue\" overlaps ball \"red\" by 1.6e-11"]
    );
    let points = MIDTERM.replace("0.075", "0").replace("[0.5, 1.0]", "[0.1, 0.1]");
    assert_eq!(problems(&points), [""; 0], "two points never meet");
}

#[test]
fn overlaps_are_found_among_unequal_balls_wherever_they_lie() {
    let ball = |id: usize, radius: f64, x: f64, y: f64| {
        format!("[[balls]]\nid = '{id}'\nradius = {radius}\nposition = [{x}, {y}]\n")
    };
    let mut text = String::from("duration = 1\n[table]\nshape = 'rectangle'\nwidth = 10\nlength = 10\n");
    text += &ball(0, 2.0, 5.0, 5.0);
    text += &ball(1, 0.01, 7.005, 5.0);
    text += &ball(2, 0.01, 3.5, 3.5);
    text += &ball(3, 0.01, 5.5, 5.0);
    assert_eq!(
        problems(&text),
        [
            "balls[1].position: ball \"1\" overlaps ball \"0\" by 0.005",
            "balls[3].position: ball \"3\" overlaps ball \"0\" by 1.51",
        ]
    );
}

#[test]
fn very_many_overlaps_are_not_all_listed() {
    let mut text = String::from(
        "duration = 1\nball_defaults = { radius = 0.1 }\n[table]\nshape = 'circle'\nradius = 1\n",
    );
    for id in 0..100 {
        text += &format!("[[balls]]\nid = '{id}'\nposition = [0, 0]\n");
    }
    let found = problems(&text);
    assert_eq!(found.len(), 1001);
    assert_eq!(found[1000], "balls: 1000 pairs overlap, and perhaps more");
}

#[test]
fn laws_belong_to_cushions_and_corners_that_exist() {
    let with = |id: &str| {
        broken("[ball_defaults]", &format!("[physics.cushions.{id}]\nlaw = 'elastic'\n[ball_defaults]"))
    };
    assert_eq!(with("left"), [""; 0]);
    assert_eq!(
        with("lef"),
        [
            "physics.cushions.lef: the table has no such cushion or corner; did you mean left? known: bottom, right, top, left"
        ]
    );
    let wall = MIDTERM
        .replace("length = 2.0", "length = 2.0\nobstacles = [{ id = 'w', wall = [[0.2, 1.5], [0.8, 1.5]] }]");
    let law = "[physics.cushions.\"w.a/w.b\"]\nlaw = 'elastic'\n[ball_defaults]";
    assert_eq!(
        problems(&wall.replace("[ball_defaults]", law)),
        [""; 0],
        "a corner may have a law of its own"
    );
}

#[test]
fn a_run_without_duration_must_come_to_rest() {
    assert_eq!(
        broken("duration = 5.0", ""),
        [
            "duration: missing, and not everything comes to rest: no field pulls ball \"red\" onto a cushion that would \
         hold it; give duration or collisions"
        ]
    );
    assert_eq!(broken("duration = 5.0", "collisions = 3"), [""; 0]);
    let no_duration = MIDTERM.replace("duration = 5.0", "");
    assert_eq!(problems(&no_duration.replace("velocity = [3.0, 4.0]", "")), [""; 0], "nothing moves");
    assert_eq!(
        problems(&no_duration.replace("factor = 0.8", "factor = 0")),
        [""; 0],
        "cushions that stop what hits them"
    );
    let field = "[physics.flight]\nlaw = 'field'\nacceleration = [0, -1]\n[physics.ball_ball]";
    let in_field = no_duration.replace("[physics.ball_ball]", field);
    assert_eq!(problems(&in_field), [""; 0], "a field pulls onto damping cushions");
    assert_eq!(
        problems(&in_field.replace("factor = 0.8", "factor = 1")),
        [
            "duration: missing, and not everything comes to rest: cushion \"bottom\", onto which the field pulls, gives \
         all the normal speed back; give duration or collisions"
        ]
    );
    let elastic_walls =
        in_field.replace("[ball_defaults]", "[physics.cushions.left]\nlaw = 'elastic'\n[ball_defaults]");
    assert_eq!(problems(&elastic_walls), [""; 0], "side walls hold nothing");
}

#[test]
fn the_stepped_method_says_what_it_cannot_do() {
    let method = "[method]\nkind = 'stepped'\ndt = 0.03\n[ball_defaults]";
    assert_eq!(broken("[ball_defaults]", method), [""; 0]);
    let stepped = MIDTERM.replace("[ball_defaults]", method);
    assert_eq!(
        problems(&stepped.replace("duration = 5.0", "collisions = 5")),
        ["duration: missing: the stepped method needs duration or method.steps"]
    );
    assert_eq!(
        problems(&stepped.replace("duration = 5.0", "").replace("dt = 0.03", "dt = 0.03\nsteps = 9")),
        [""; 0]
    );
    assert_eq!(
        problems(&stepped.replace("dt = 0.03", "dt = 1e-300")),
        ["method.dt: is too short: 5e300 steps to the duration"]
    );
    let kept =
        "and a run of 2 balls keeps 5000000 at most; with record = \"events\" or \"none\" it keeps none";
    let short = stepped.replace("dt = 0.03", "dt = 1e-7");
    assert_eq!(problems(&short), [format!("method.dt: makes 50000000 steps, {kept}")]);
    assert_eq!(
        problems(&stepped.replace("dt = 0.03", "dt = 0.03\nsteps = 5001000")),
        [format!("method.steps: makes 5001000 steps, {kept}")]
    );
    for record in ["events", "none"] {
        assert_eq!(problems(&format!("record = '{record}'\n{short}")), [""; 0]);
    }
    assert_eq!(problems(&stepped.replace("dt = 0.03", "dt = 1e-6")), [""; 0]);
    let text = "method = { kind = 'stepped', dt = 0.1 }\nduration = 1\n\
                physics.flight = { law = 'field', acceleration = [0, -1] }\n\
                physics.ball_ball = { law = 'restitution', normal = 0.9 }\n\
                table = { shape = 'circle', radius = 1, obstacles = [{ wall = [[0.5, 0], [0.6, 0]] }] }\n\
                balls = [{ id = 'a', radius = 0.1, position = [0, 0] }]";
    let only = |what| format!("method.kind: the stepped method {what}; use the exact one");
    assert_eq!(
        problems(text),
        [
            only("knows only the rectangle"),
            only("knows no obstacles"),
            only("knows no field"),
            only("knows only elastic collisions of balls"),
        ]
    );
}

#[test]
fn numbers_whose_products_leave_double_precision_are_refused() {
    assert_eq!(
        broken("[3.0, 4.0]", "[3e200, 4.0]"),
        ["balls[0].velocity: is too large to compute with: at most 1e77; got 3e200"]
    );
    assert_eq!(
        broken("[3.0, 4.0]", "[3e-200, 0]"),
        ["balls[0].velocity: is too small to compute with: write 0, or at least 1e-77; got 3e-200"]
    );
    assert_eq!(broken("[3.0, 4.0]", "[3e-200, 4]"), [""; 0], "a small component does no harm");
    let large = |part: &str, by: &str| broken(part, by)[0].clone();
    assert!(large("width = 1.0", "width = 1e300").starts_with("table.width: is too large"));
    assert!(large("id = \"red\"", "id = \"red\"\nmass = 1e300").starts_with("balls[0].mass: is too large"));
    assert!(large("radius = 0.075", "radius = 1e-200").starts_with("ball_defaults.radius: is too small"));
    assert!(large("[0.5, 1.0]", "[0.5, -1e100]").starts_with("balls[1].position[1]: is too large"));
    assert!(
        large("factor = 0.8", "factor = 1e-200").starts_with("physics.ball_cushion.factor: is too small")
    );
    let text = "duration = 1\nphysics.flight = { law = 'field', acceleration = [0, 1e90] }\n\
                table = { shape = 'circle', radius = 1 }\nballs = [{ id = 'a', radius = 0.1, position = [0, 0] }]";
    assert!(problems(text)[0].starts_with("physics.flight.acceleration: is too large"));
}

#[test]
fn balls_keep_clear_of_obstacles() {
    assert_eq!(
        with_obstacles("{ id = 'p', circle = { center = [0.5, 0.25], radius = 0.1 } }"),
        ["balls[0].position: ball \"a\" lies inside obstacle \"p\""]
    );
    assert_eq!(
        with_obstacles("{ id = 'p', circle = { center = [0.5, 0.305], radius = 0.1 } }"),
        ["balls[0].position: ball \"a\" reaches past cushion \"p\" by 0.005"]
    );
    assert_eq!(
        with_obstacles("{ id = 'w', wall = [[0.505, 0], [0.505, 0.5]] }"),
        ["balls[0].position: ball \"a\" reaches past cushion \"w.a\" by 0.005 and cushion \"w.b\" by 0.005"]
    );
    assert_eq!(with_obstacles("{ wall = [[0.51, 0], [0.51, 0.5]] }"), [""; 0], "touching is legal");
}

#[test]
fn a_ball_that_fills_a_round_end_is_refused() {
    let full = "radius = 0.5\nposition = [0, 0]";
    let text =
        format!("duration = 1\n[table]\nshape = 'circle'\nradius = 0.5\n[[balls]]\nid = 'a'\n{full}\n");
    assert_eq!(
        problems(&text),
        ["balls[0].position: ball \"a\" is as wide as round cushion \"rim\", and would have no room in it"]
    );
    // In rounded corners, which are quarters of a circle, it meets the sides.
    let arc = |x: f64, y: f64, from: i32| {
        format!(
            "{{ arc = {{ center = [{x}, {y}], radius = 0.1, from_deg = {from}, to_deg = {} }} }}",
            from + 90
        )
    };
    let table = format!(
        "[table]\nshape = 'path'\npieces = [{{ line = [[0.1, 0], [0.9, 0]] }}, {}, {{ line = [[1, 0.1], [1, 0.9]] }}, {}, \
         {{ line = [[0.9, 1], [0.1, 1]] }}, {}, {{ line = [[0, 0.9], [0, 0.1]] }}, {}]",
        arc(0.9, 0.1, -90),
        arc(0.9, 0.9, 0),
        arc(0.1, 0.9, 90),
        arc(0.1, 0.1, 180)
    );
    let text = format!("duration = 1\n{table}\n[[balls]]\nid = 'a'\nradius = 0.1\nposition = [0.5, 0.5]\n");
    assert_eq!(problems(&text), [""; 0]);
}
