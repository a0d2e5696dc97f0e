//! Balls on a cloth, their laws, the cue and the shot: what may be written, and what it means in numbers.

use crate::common::{broken, problems};
use carom::geometry::Vec3;
use carom::scalar::{Dual, Scalar};
use carom::scenario::schema::{Cluster, Flight, SlipFriction};
use carom::scenario::{Scenario, ShotStart};

const TABLE: &str = "[table]\nshape = 'rectangle'\nwidth = 1\nlength = 2\n";
const BALL: &str = "[[balls]]\nid = 'cue'\nradius = 0.03\nposition = [0.5, 0.5]\n";

/// All problems of a scenario on a cloth with these lines before its tables, and these after its ball.
fn on_cloth(head: &str, tail: &str) -> Vec<String> {
    problems(&format!("physics.flight.law = 'cloth'\n{head}\n{TABLE}{BALL}{tail}"))
}

fn shot(keys: &str) -> Vec<String> {
    on_cloth("", &format!("[shot]\n{keys}\n"))
}

fn started(keys: &str) -> ShotStart<f64> {
    let text = format!("physics.flight.law = 'cloth'\n{TABLE}{BALL}[shot]\n{keys}\n");
    let scenario = Scenario::from_toml(&text).unwrap_or_else(|error| panic!("{error}"));
    scenario.expanded().shot_start(&mut |_, value| value).unwrap()
}

#[test]
fn a_cloth_has_defaults_and_ranges() {
    let text = format!("physics.flight.law = 'cloth'\n{TABLE}{BALL}");
    let scenario = Scenario::from_toml(&text).unwrap();
    let Flight::Cloth { gravity, restitution, friction, min_hop, air } = scenario.physics.flight() else {
        panic!()
    };
    assert_eq!((*gravity, *restitution, *friction, *min_hop, *air), (9.81, 0.5, None, 0.005, true));
    assert_eq!(scenario.physics.cluster(), Cluster::Hertz);
    let start = scenario.balls[0].start(0, &scenario.ball_defaults, &mut |_, value: f64| value);
    let sphere = start.sphere();
    assert_eq!((sphere.sliding, sphere.rolling, sphere.spin_decay), (0.2, 0.01, 10.9));
    assert_eq!((start.position, start.twist().spin), (Vec3::new(0.5, 0.5, 0.03), Vec3::ZERO));
    assert_eq!(
        on_cloth(
            "physics.flight.gravity = -1\nphysics.flight.restitution = 2\nphysics.flight.min_hop = -1",
            ""
        ),
        [
            "physics.flight.gravity: must be zero or positive and finite, got -1",
            "physics.flight.restitution: must be between 0 and 1, got 2",
            "physics.flight.min_hop: must be zero or positive and finite, got -1"
        ]
    );
    assert_eq!(
        on_cloth("ball_defaults = { sliding_friction = -1, rolling_friction = -1, spin_decay = -1 }", ""),
        [
            "ball_defaults.sliding_friction: must be zero or positive and finite, got -1",
            "ball_defaults.rolling_friction: must be zero or positive and finite, got -1",
            "ball_defaults.spin_decay: must be zero or positive and finite, got -1"
        ]
    );
}

#[test]
fn everything_comes_to_rest_on_a_cloth_but_not_on_one_that_is_a_trampoline() {
    assert_eq!(on_cloth("", ""), [""; 0]);
    assert_eq!(
        on_cloth("physics.flight.restitution = 1", ""),
        [
            "duration: missing, and not everything comes to rest: the cloth gives all the speed of a fall back; give \
             duration or collisions"
        ]
    );
    assert_eq!(on_cloth("physics.flight.restitution = 1\nphysics.flight.air = false", ""), [""; 0]);
}

#[test]
fn a_run_on_a_cloth_that_does_not_slow_what_moves_needs_a_duration() {
    let missing = |reason: &str| {
        [format!(
            "duration: missing, and not everything comes to rest: {reason}; give duration or collisions"
        )]
    };
    let moving = "velocity = [1, 0]\n";
    let cases = [
        ("physics.flight.gravity = 0", "without gravity no ball rubs on the cloth"),
        (
            "ball_defaults.sliding_friction = 0",
            "nothing slows ball \"cue\" while it slides, since its sliding_friction is 0",
        ),
        (
            "ball_defaults.rolling_friction = 0",
            "nothing slows ball \"cue\" while it rolls, since its rolling_friction is 0",
        ),
        (
            "ball_defaults.spin_decay = 0",
            "nothing slows ball \"cue\" while it spins, since its spin_decay is 0",
        ),
    ];
    for (keys, reason) in cases {
        assert_eq!(on_cloth(keys, moving), missing(reason));
        assert_eq!(on_cloth(keys, "spin = [0, 0, 1]\n"), missing(reason), "a ball that spins moves");
        assert_eq!(on_cloth(keys, "[shot]\nV0 = 1\nphi_deg = 0\n"), missing(reason));
        assert_eq!(on_cloth(keys, ""), [""; 0], "nothing moves");
        assert_eq!(on_cloth(&format!("duration = 1\n{keys}"), moving), [""; 0]);
        assert_eq!(on_cloth(&format!("collisions = 3\n{keys}"), moving), [""; 0]);
    }
    let floating = "position = [0.5, 0.5, 0.5]";
    let text = format!("physics.flight = {{ law = 'cloth', gravity = 0 }}\n{TABLE}{BALL}");
    let text = text.replace("position = [0.5, 0.5]", floating);
    assert_eq!(problems(&text), missing("without gravity no ball rubs on the cloth"));
}

#[test]
fn what_rolls_needs_a_cloth() {
    let needs = "needs physics.flight.law = \"cloth\"";
    let discs = |head: &str, tail: &str| problems(&format!("duration = 1\n{head}\n{TABLE}{BALL}{tail}"));
    let only = |place: &str| [format!("{place}: {needs}")];
    assert_eq!(discs("", "spin = [0, 0, 1]"), only("balls[0].spin"));
    assert_eq!(discs("", "velocity = [0, 0, 1]"), only("balls[0].velocity[2]"));
    assert_eq!(discs("", "rolling_friction = 0.1"), only("balls[0].rolling_friction"));
    assert_eq!(discs("ball_defaults.spin_decay = 1", ""), only("ball_defaults.spin_decay"));
    assert_eq!(discs("cue.mass = 1", ""), only("cue"));
    assert_eq!(discs("", "[shot]\nV0 = 1\nphi_deg = 0"), only("shot"));
    assert_eq!(
        discs("physics.ball_ball = { law = 'frictional', normal = 1 }", ""),
        only("physics.ball_ball.law")
    );
    let law = "{ law = 'han_2005', normal = 0.9, friction = 0.1 }";
    assert_eq!(discs(&format!("physics.ball_cushion = {law}"), ""), only("physics.ball_cushion.law"));
    assert_eq!(discs(&format!("physics.cushions.left = {law}"), ""), only("physics.cushions.left.law"));
    let table = |keys: &str| problems(&format!("duration = 1\n{TABLE}{keys}\n{BALL}"));
    assert_eq!(table("nose_height = 0.03"), only("table.nose_height"));
    assert_eq!(table("nose_contact = 'nose'"), only("table.nose_contact"));
    assert_eq!(table("pockets = [{ id = 'p', center = [0, 0], radius = 0.1 }]"), only("table.pockets"));
    assert_eq!(broken("[0.5, 1.0]", "[0.5, 1.0, 0.075]"), only("balls[1].position[2]"));
    assert_eq!(
        discs("ball_defaults.spin_decay = 1", "spin = [0, 0, 1]\nsliding_friction = 0.1"),
        ["ball_defaults.spin_decay", "balls[0].sliding_friction", "balls[0].spin"]
            .map(|place| format!("{place}: {needs}")),
        "all of them at once"
    );
}

#[test]
fn what_is_for_discs_is_refused_on_a_cloth() {
    assert_eq!(
        on_cloth("physics.collapse = 'tc'", ""),
        ["physics.collapse: is for discs: on a cloth balls part with hops too small to see"]
    );
    assert_eq!(
        on_cloth("method = { kind = 'stepped', dt = 0.1 }\nduration = 1", ""),
        ["method.kind: the stepped method knows no cloth; use the exact one"]
    );
    assert_eq!(
        on_cloth("", "[[balls]]\nid = 'a'\nradius = 0\nposition = [0.1, 0.1]"),
        ["balls[1].radius: ball \"a\" is a point, and cannot roll on a cloth"]
    );
}

#[test]
fn heights_are_those_of_centres() {
    let ball = |keys: &str| on_cloth("", &format!("[[balls]]\nid = 'a'\nradius = 0.03\n{keys}\n"));
    assert_eq!(ball("position = [0.2, 0.2, 0.03]"), [""; 0]);
    assert_eq!(ball("position = [0.2, 0.2, 0.5]\nvelocity = [1, 0, -2]\nspin = [1, 2, 3]"), [""; 0]);
    assert_eq!(
        ball("position = [0.2, 0.2, 0.02]"),
        [
            "balls[1].position[2]: is the height of the centre, at least the radius 0.03 of ball \"a\"; got 0.02"
        ]
    );
    assert_eq!(ball("position = [0.5, 0.5, 0.09]"), [""; 0], "one ball rests on top of the other");
    assert_eq!(
        ball("position = [0.5, 0.5, 0.08]"),
        ["balls[1].position: ball \"a\" overlaps ball \"cue\" by 0.01"]
    );
    let flat = |keys: &str| {
        on_cloth("physics.flight.air = false", &format!("[[balls]]\nid = 'a'\nradius = 0.03\n{keys}\n"))
    };
    let off = "takes ball \"a\" off the cloth, and physics.flight.air is false";
    assert_eq!(flat("position = [0.2, 0.2, 0.04]"), [format!("balls[1].position[2]: {off}")]);
    assert_eq!(flat("position = [0.2, 0.2]\nvelocity = [1, 0, 1]"), [format!("balls[1].velocity[2]: {off}")]);
}

#[test]
fn unequal_balls_on_a_cloth_touch_over_less_than_their_radii() {
    // Centres 0.01 apart in height and 0.07 in all: sqrt(0.0049 − 0.0001) = 0.0692820 in plan.
    let at = |x: f64| on_cloth("", &format!("[[balls]]\nid = 'a'\nradius = 0.04\nposition = [{x}, 0.5]\n"));
    assert_eq!(at(0.569283), [""; 0]);
    assert!(at(0.56928)[0].starts_with("balls[1].position: ball \"a\" overlaps ball \"cue\" by 2.0"));
}

#[test]
fn laws_may_depend_on_speed_slip_and_incidence() {
    let cushion =
        |keys: &str| on_cloth(&format!("physics.ball_cushion = {{ law = 'han_2005', {keys} }}"), "");
    assert_eq!(cushion("normal = 0.8, friction = 0.2"), [""; 0]);
    let fit = "normal = { by_speed = [0.39, 0.257, -0.044], up_to = 3 }, friction = { by_incidence = [0.471, -0.241] }";
    assert_eq!(cushion(fit), [""; 0]);
    assert_eq!(
        cushion("normal = { by_speed = [0.5, 0.5, -0.1], up_to = 4 }, friction = 0.2"),
        [
            "physics.ball_cushion.normal.by_speed: must give numbers between 0 and 1, but at speed 2.5 gives 1.125"
        ]
    );
    assert_eq!(
        cushion(
            "normal = { by_speed = [0.5, -0.2, 0], up_to = 4 }, friction = { by_incidence = [0.3, -0.3] }"
        ),
        [
            "physics.ball_cushion.normal.by_speed: must give numbers between 0 and 1, but at speed 4 gives -0.3",
            "physics.ball_cushion.friction.by_incidence: must not be negative between 0 and a quarter turn: it is 0.3 and \
             -0.1712 there"
        ]
    );
    assert_eq!(
        cushion("normal = 1.5, friction = -1"),
        [
            "physics.ball_cushion.normal: must be between 0 and 1, got 1.5",
            "physics.ball_cushion.friction: must be zero or positive and finite, got -1"
        ]
    );
    assert_eq!(
        cushion("normal = 'a', friction = [1]"),
        [
            "physics.ball_cushion.normal: expected a number or a set of keys, got \"a\"",
            "physics.ball_cushion.friction: expected a number or a set of keys, got [1]"
        ]
    );
    assert_eq!(
        cushion("normal = { by_sped = [1, 0, 0], up_to = 1 }"),
        [
            "physics.ball_cushion.normal.by_sped: unknown key; did you mean by_speed? known: by_speed, up_to",
            "physics.ball_cushion.normal.by_speed: missing: expected a list of 3 numbers",
            "physics.ball_cushion.friction: missing: expected a number or a set of keys"
        ]
    );
    let balls = |keys: &str| {
        on_cloth(&format!("physics.ball_ball = {{ law = 'frictional', normal = 0.9{keys} }}"), "")
    };
    for good in ["", ", friction = 0.06", ", friction = { a = 0.01, b = 0.1, c = 1 }, cling = 2"] {
        assert_eq!(balls(good), [""; 0], "{good}");
    }
    assert_eq!(
        balls(", friction = { a = 0.01, b = -0.1 }, cling = -1"),
        [
            "physics.ball_ball.friction.b: must be zero or positive and finite, got -0.1",
            "physics.ball_ball.friction.c: missing: expected a number",
            "physics.ball_ball.cling: must be zero or positive and finite, got -1"
        ]
    );
    assert!(on_cloth("physics.ball_ball.law = 'mathavan'", "")[0].contains("did you mean mathavan_2014?"));
    assert!(
        on_cloth("physics.ball_cushion = { law = 'stronge_compliant', normal = 1, friction = 0, frequency_ratio = 3 }", "")[0]
            .ends_with("frequency_ratio: must be between 1 and 2, got 3")
    );
    assert_eq!(SlipFriction::default(), SlipFriction::ALCIATORE);
}

#[test]
fn both_spellings_of_a_shot_give_the_same() {
    let words = "cue_speed = 3\ndirection_deg = 60\nelevation_deg = 20\nleft = 0.1\ntop = -0.2";
    let letters = "V0 = 3\nphi_deg = 60\ntheta_deg = 20\na = 0.1\nb = -0.2";
    let start = started(words);
    assert_eq!(start, started(letters));
    assert_eq!((start.ball, start.speed, start.left, start.top), (0, 3.0, 0.1, -0.2));
    assert!(
        (start.direction.x - 0.5).abs() < 1e-15 && (start.elevation.1 - 0.3420201433256687).abs() < 1e-15
    );
    let level = started("V0 = 1\nphi_deg = 90");
    assert_eq!((level.direction.x.abs(), level.direction.y, level.elevation), (0.0, 1.0, (1.0, 0.0)));
    assert_eq!((level.left, level.top), (0.0, 0.0), "in the middle, unless it is said");
    // Offsets of the tip's centre are those of the contact times 1 + r/R, with a tip of 10.6045 mm and a ball of 30 mm.
    let of_tip = started("V0 = 1\nphi_deg = 0\na = 0.5\nb = 0.25\noffset_of = 'tip_center'");
    let scale = 1.0 / (1.0 + 0.0106045 / 0.03);
    assert!((of_tip.left - 0.5 * scale).abs() < 1e-15 && (of_tip.top - 0.25 * scale).abs() < 1e-15);
}

#[test]
fn a_number_of_the_shot_can_be_the_variable_of_a_derivative() {
    let text = format!("physics.flight.law = 'cloth'\n{TABLE}{BALL}[shot]\nV0 = 2\nphi_deg = 90\na = 0.2\n");
    let scenario = Scenario::from_toml(&text).unwrap().expanded().into_owned();
    let by = |variable: &str| {
        let number: &mut dyn FnMut(&dyn core::fmt::Display, f64) -> Dual<1> = &mut |place, value| {
            if place.to_string() == variable { Dual::variable(value, 0) } else { Dual::from_f64(value) }
        };
        let start = scenario.shot_start(number).unwrap();
        [start.speed, start.left, start.direction.x].map(|part| part.derivatives[0])
    };
    assert_eq!(by("shot.V0"), [1.0, 0.0, 0.0]);
    assert_eq!(by("shot.a"), [0.0, 1.0, 0.0]);
    assert!((by("shot.phi_deg")[2] + core::f64::consts::PI / 180.0).abs() < 1e-15);
    let cue = scenario.cue.start(&mut |_, value: f64| value);
    assert_eq!(
        (cue.mass, cue.end_mass, cue.restitution, cue.miscue_offset),
        (0.567, 0.170097 / 30.0, 1.0, 0.55)
    );
}

#[test]
fn a_shot_says_each_thing_once_and_says_enough() {
    assert_eq!(shot("V0 = 1\nphi_deg = 90"), [""; 0]);
    assert_eq!(
        shot("V0 = 1\ncue_speed = 1\nphi_deg = 1\ndirection_deg = 1\na = 0\nleft = 0"),
        [("V0", "cue_speed"), ("phi_deg", "direction_deg"), ("a", "left")].map(|(name, other)| format!(
            "shot.{name}: is given beside {other}, which is the same: give one of them"
        ))
    );
    assert_eq!(
        shot(""),
        [
            "shot.V0: missing: give the speed of the cue, as V0 or cue_speed",
            "shot.phi_deg: missing: give the direction of the stroke, in degrees from the x axis towards the y axis, as \
             phi_deg or direction_deg"
        ]
    );
    let found = shot("V0 = 1\nphi = 90\ntheta = 10\nv0 = 1");
    assert!(found[0].starts_with("shot.phi: unknown key; did you mean phi_deg?"), "{found:?}");
    assert!(found[1].starts_with("shot.theta: unknown key; did you mean theta_deg?"), "{found:?}");
    assert!(found[2].starts_with("shot.v0: unknown key; did you mean V0?"), "{found:?}");
    assert_eq!(
        shot("V0 = -1\nphi_deg = 0\ntheta_deg = 100"),
        [
            "shot.V0: must be zero or positive and finite, got -1",
            "shot.theta_deg: must be between 0 and 90, got 100"
        ]
    );
}

#[test]
fn a_shot_hits_a_ball_that_is_there_and_at_rest() {
    let aimed = "V0 = 1\nphi_deg = 0";
    assert_eq!(
        shot(&format!("{aimed}\ncue_ball = 'queue'")),
        ["shot.cue_ball: there is no ball \"queue\"; known: cue"]
    );
    let with = |keys: &str| on_cloth("", &format!("{keys}\n[shot]\n{aimed}\n"));
    let moves = "shot.cue_ball: ball \"cue\" moves already: only a ball at rest can be struck";
    assert_eq!(with("velocity = [1, 0]"), [moves]);
    assert_eq!(with("spin = [0, 0, 1]"), [moves]);
    let flying = problems(&format!(
        "physics.flight.law = 'cloth'\n{TABLE}[[balls]]\nid = 'cue'\nradius = 0.03\nposition = [0.5, 0.5, 0.2]\n[shot]\n{aimed}\n"
    ));
    assert_eq!(
        flying,
        ["shot.cue_ball: ball \"cue\" is in the air: only a ball that lies on the cloth can be struck"]
    );
}

#[test]
fn a_shot_touches_the_ball() {
    let at = |a: f64, b: f64, of: &str| {
        shot(&format!("V0 = 1\nphi_deg = 0\na = {a}\nb = {b}\noffset_of = '{of}'"))
    };
    let misses = "and must lie less than 1 from it";
    assert_eq!(at(0.6, 0.79, "contact"), [""; 0]);
    assert_eq!(
        at(0.6, 0.8, "contact"),
        [format!("shot: misses the ball: the contact would lie 1 radii from the middle, {misses}")]
    );
    assert_eq!(
        at(0.8, 1.0, "tip_center"),
        [""; 0],
        "the tip's rounding touches the ball nearer to the middle"
    );
    assert!(
        at(1.2, 1.0, "tip_center")[0].starts_with("shot: misses the ball: the contact would lie 1.154 radii")
    );
}

#[test]
fn a_cue_has_ranges() {
    assert_eq!(
        on_cloth("cue = { mass = 0, end_mass = -1, restitution = 2, miscue_offset = 1.5 }", ""),
        [
            "cue.mass: must be positive and finite, got 0",
            "cue.end_mass: must be zero or positive and finite, got -1",
            "cue.restitution: must be between 0 and 1, got 2",
            "cue.miscue_offset: must be at most 1, got 1.5"
        ]
    );
}

#[test]
fn all_problems_of_a_broken_shot_are_reported_at_once() {
    let text = "table.preset = 'pool_9ft'\nrack.game = 'nine_ball'\nrack.seed = 1.5\n[shot]\ncue_ball = 'q'\nV0 = 'fast'\n\
                [[balls]]\nid = 'a'\nposition = [9, 9]\n";
    assert_eq!(
        problems(text),
        [
            "rack.seed: expected a whole number, got 1.5",
            "shot.V0: expected a number, got \"fast\"",
            "shot.phi_deg: missing: give the direction of the stroke, in degrees from the x axis towards the y axis, as \
             phi_deg or direction_deg",
            "balls[0].position: ball \"a\" lies outside the table"
        ]
    );
}
