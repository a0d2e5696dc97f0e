//! Open pots: closed forms, and shots that are played out.

use crate::layouts::{POOL, ball, on_pool_table, random_balls, scenario};
use carom::aim::{Pot, Scene, at_ball, open_pots, pot};
use carom::geometry::{Segment, clearance};
use carom::run::{Event, Kind, OnCloth, Run};
use carom::scenario::ClothSystem;
use carom::simulate::simulate_until;

fn scene(balls: &str) -> Scene {
    Scene::new(&scenario(&on_pool_table(balls, "")), None).unwrap()
}

#[test]
fn a_straight_pot_has_a_window_in_closed_form() {
    // A bare hole in the middle of a far cushion, and the three in a line. The ball goes in where the centre's path meets
    // the hole: within asin(r/L) of the middle.
    let text = |y: f64| {
        format!(
            "physics.flight.law = 'cloth'\n\
             table = {{ shape = 'rectangle', width = 4, length = 4, pockets = [{{ id = 'p', center = [2, 3.8], radius = 0.1 }}] }}\n\
             ball_defaults.radius = 0.03\n{}",
            [ball("cue", [2.0, 1.0], ""), ball("1", [2.0, y], "")].concat()
        )
    };
    let scene = Scene::new(&scenario(&text(2.0)), None).unwrap();
    let pots = open_pots(&scene);
    assert_eq!(pots.len(), 1);
    let Pot {
        direction_deg,
        cut_deg,
        ghost,
        cue_distance,
        object_distance,
        window_deg,
        object_window_deg,
        ..
    } = &pots[0];
    assert_eq!((*direction_deg, *cut_deg), (90.0, 0.0));
    let is_near = |a: f64, b: f64| (a - b).abs() < 1e-11;
    assert!(is_near(ghost[1], 1.94) && is_near(*cue_distance, 0.94) && is_near(*object_distance, 1.7));
    let off = (0.1_f64 / 1.8).asin();
    let aside = (0.06 * off.sin()).atan2(1.0 - 0.06 * off.cos()).to_degrees();
    assert!(is_near(window_deg[0], 90.0 - aside) && is_near(window_deg[1], 90.0 + aside), "{window_deg:?}");
    let off = off.to_degrees();
    assert!(is_near(object_window_deg[0], 90.0 + off) && is_near(object_window_deg[1], 90.0 - off));
    let further = Scene::new(&scenario(&text(3.0)), None).unwrap();
    assert!(open_pots(&further)[0].precision_deg() > 0.0);
}

#[test]
fn a_ball_in_the_way_narrows_the_window_and_closes_it() {
    let open = |extra: &str| {
        let balls = [ball("cue", [0.635, 0.6], ""), ball("1", [0.9, 1.2], ""), extra.to_owned()].concat();
        pot(&scene(&balls), "1", "rc").ok()
    };
    let free = open("").unwrap();
    let beside = open(&ball("2", [1.1, 1.175], "")).unwrap();
    assert!(beside.precision_deg() < free.precision_deg(), "one side is narrower");
    assert!(
        beside.window_deg[0] == free.window_deg[0] || beside.window_deg[1] == free.window_deg[1],
        "the other is not"
    );
    assert_eq!(open(&ball("2", [1.1, 1.24], "")), None, "before the pocket");
    let [x, y] = free.ghost;
    assert_eq!(open(&ball("2", [(x + 0.635) / 2.0, (y + 0.6) / 2.0], "")), None, "before the ball");
    assert_eq!(open(&ball("2", [x - 0.03, y + 0.03], "")), None, "where the ghost would be");
    assert_eq!(open(&ball("2", [0.635, 0.5], "")), Some(free), "behind the cue ball");
}

#[test]
fn mirrored_scenes_have_mirrored_pots() {
    let at = |mirror: &dyn Fn(f64) -> f64| {
        let place = |x: f64, y: f64| [mirror(x), y];
        let balls = [
            ball("cue", place(0.3, 0.6), ""),
            ball("1", place(0.9, 1.4), ""),
            ball("2", place(0.7, 1.0), ""),
        ];
        open_pots(&scene(&balls.concat()))
    };
    let (right, left) = (at(&|x| x), at(&|x| 1.27 - x));
    assert!(right.len() > 2 && right.len() == left.len());
    for (a, b) in right.iter().zip(&left) {
        let mirrored = |deg: f64| 180.0 - deg;
        assert_eq!(a.pocket.replace('r', "l"), b.pocket.replace('r', "l"));
        let pairs = [
            (mirrored(a.direction_deg), b.direction_deg),
            (mirrored(a.window_deg[0]), b.window_deg[1]),
            (mirrored(a.window_deg[1]), b.window_deg[0]),
        ];
        for (a, b) in pairs {
            assert!((a - b).rem_euclid(360.0).min((b - a).rem_euclid(360.0)) < 1e-10, "{a} {b}");
        }
        assert!((a.cut_deg + b.cut_deg).abs() < 1e-10);
    }
}

#[test]
fn balls_that_touch_go_along_their_line_whatever_the_stroke() {
    let balls = [ball("cue", [0.9 - 2.0 * POOL, 1.27], ""), ball("1", [0.9, 1.27], "")].concat();
    let open = pot(&scene(&balls), "1", "rc").unwrap();
    assert!(open.direction_deg.abs() < 1e-4 && open.cue_distance < 1e-9, "{open:?}");
    assert!((open.precision_deg() - 180.0).abs() < 1e-4, "{open:?}");
}

#[test]
fn along_a_rail_there_is_room_for_as_much_as_the_ball_lies_off_it() {
    // A nose at 36.3 mm touches the ball √(R² − (36.3 − R)²) away. Of a ball that is frozen to the rail the ghost is too,
    // and there is no window.
    let reach = (POOL * POOL - (0.0363_f64 - POOL).powi(2)).sqrt();
    let open = |off: f64| {
        let balls = [ball("cue", [reach + off + 0.05, 1.5], ""), ball("1", [reach + off, 1.9], "")].concat();
        pot(&scene(&balls), "1", "lt").ok()
    };
    assert!(open(0.0).is_none_or(|pot| pot.precision_deg() < 1e-6), "no more than round-off");
    for off in [1e-4, 1e-3] {
        let [left, right] = open(off).unwrap().object_window_deg;
        // To the right the ghost touches the rail; to the left the ball does, where it ends and the jaw begins.
        let ghost = (off / (2.0 * POOL)).asin().to_degrees();
        assert!((right - (90.0 - ghost)).abs() < 1e-6, "{right}");
        let turn = 52.0_f64.to_radians();
        let end = 2.54 - 0.1159 / 2.0_f64.sqrt() - 0.020_95 * turn.cos() / (1.0 + turn.sin());
        let tangent = off.atan2(end - 1.9).to_degrees();
        assert!(left > 89.99999 + tangent && left < 90.0 + 1.1 * tangent, "{left}, {tangent}");
    }
}

/// What came of a shot.
#[derive(Debug, PartialEq)]
enum Outcome {
    /// The ball came into a pocket as the first thing that happened to it after the cue ball hit it, before which nothing
    /// was touched; and whether it dropped there in the end.
    Entered { pocket: String, drops: bool },
    /// The ball or the cue ball touched something else before.
    Touched,
    /// Another ball came, or the ball rested on its way.
    Disturbed,
}

fn outcome(balls: &str, ball: &str, direction_deg: f64) -> Outcome {
    let shot = format!("[shot]\nV0 = 4\nphi_deg = {direction_deg:?}\n");
    let scenario = scenario(&on_pool_table(balls, &shot));
    let system = ClothSystem::<f64>::new(&scenario);
    let ball = system.ball_ids.iter().position(|id| id == ball).unwrap() as u32;
    let run: Run<f64, OnCloth> = simulate_until(&scenario, None, &mut || false).unwrap();
    let collisions = [Kind::BallBall, Kind::BallCushion, Kind::BallPocket];
    let mut events = run.log.events.iter().filter(|event| collisions.contains(&event.kind));
    let is_of_ball = |event: &Event<f64>| event.ball_a == ball || event.ball_b == Some(ball);
    let Some(hit) = events.next().filter(|hit| is_of_ball(hit) && hit.kind == Kind::BallBall) else {
        return Outcome::Touched;
    };
    // Of unequal balls it is the shadow of one that is not level.
    let normal = if hit.ball_a == ball { -hit.normal } else { hit.normal }.unit();
    let mut of_ball = events.filter(|event| is_of_ball(event));
    let Some(next) = of_ball.next() else { return Outcome::Disturbed };
    let Some(cushion) = next.cushion else { return Outcome::Disturbed };
    let name = &system.cushion_ids[cushion as usize];
    let pocket = name.split('.').next().unwrap().to_owned();
    let table = scenario.expanded().table.layout::<f64>(&mut |_, value| value);
    let Some(place) = table.pockets.iter().find(|place| place.id == pocket) else { return Outcome::Touched };
    let [from, to] = place.tips.unwrap();
    let center = next.point + next.normal * system.noses[ball as usize].reach;
    let is_before = |point| (to - from).cross(point - from) > 0.0;
    let start = system.starts[ball as usize].0.plan();
    if next.kind == Kind::BallCushion && (name.contains(".jaw_") || is_before(center) || !is_before(start)) {
        return Outcome::Touched;
    }
    // Its line, as if there were no facings, touches no jaw before the hole.
    let to_hole = place.center - start;
    let (ahead, off) = (to_hole.dot(normal), to_hole.cross(normal));
    let past_mouth = ((from + to) * 0.5 - start).norm() + (to - from).norm();
    let before_hole = ahead - (place.radius.powi(2) - off.powi(2)).sqrt();
    let length = if before_hole < past_mouth { before_hole } else { past_mouth };
    let line = Segment { start, end: start + normal * length };
    let jaws = table.cushions().filter(|cushion| cushion.id.starts_with(&format!("{pocket}.jaw_")));
    if jaws.map(|jaw| clearance(&line, &jaw.piece)).any(|free| free < system.noses[ball as usize].reach) {
        return Outcome::Touched;
    }
    let is_drop = |event: &Event<f64>| event.kind == Kind::BallPocket;
    let drops = is_drop(next)
        || of_ball
            .find(|event| is_drop(event))
            .is_some_and(|drop| system.cushion_ids[drop.cushion.unwrap() as usize] == pocket);
    Outcome::Entered { pocket, drops }
}

#[test]
fn every_open_pot_of_random_layouts_drops_and_just_outside_its_window_it_touches_something() {
    let (mut shots, mut disturbed) = (0, 0);
    for seed in 0..200 {
        let balls = random_balls(seed, 5);
        for pot in open_pots(&scene(&balls)) {
            // The aim, the ends of the window, and what lies beyond them by a thousandth of it.
            let [right, left] = pot.window_deg;
            let bit = 1e-3 * pot.precision_deg();
            // A ball that is hardly touched may take longer to drop than the run lasts.
            let is_in_pocket = |found: &Outcome| match found {
                Outcome::Entered { pocket, drops } => {
                    pocket == &pot.pocket && (*drops || pot.cut_deg.abs() > 85.0)
                }
                _ => false,
            };
            let aims = [
                (pot.direction_deg, true),
                (right + bit, true),
                (left - bit, true),
                (right - bit, false),
                (left + bit, false),
            ];
            for (aim, is_in) in aims {
                shots += 1;
                let found = outcome(&balls, &pot.ball, aim);
                disturbed += usize::from(found == Outcome::Disturbed);
                let is_as_said = if is_in { is_in_pocket(&found) } else { found == Outcome::Touched };
                assert!(
                    is_as_said || found == Outcome::Disturbed,
                    "seed {seed}, at {aim}: {found:?}\n{pot:?}"
                );
            }
        }
    }
    assert!(shots > 4000, "{shots} shots");
    assert!(disturbed * 20 < shots, "{disturbed} of {shots} were disturbed by another ball");
}

#[test]
fn what_is_not_listed_goes_into_no_pocket() {
    let (mut closed, mut shots) = (0, 0);
    for seed in 200..230 {
        let balls = random_balls(seed, 4);
        let scene = scene(&balls);
        let open = open_pots(&scene);
        for ball in ["1", "2", "3"] {
            // Cuts on all sides, and what the ball falls into.
            let cuts = (0..60).map(|k| -88.0 + 176.0 * f64::from(k) / 59.0);
            for aim in cuts.map(|cut| at_ball(&scene, ball, cut).unwrap()) {
                shots += 1;
                let Outcome::Entered { pocket, .. } = outcome(&balls, ball, aim) else { continue };
                closed += 1;
                let listed = open.iter().find(|pot| pot.ball == ball && pot.pocket == pocket);
                let pot = listed.unwrap_or_else(|| panic!("seed {seed}: {ball} came into {pocket} at {aim}"));
                let off = (aim - pot.window_deg[0]).rem_euclid(360.0);
                assert!(off <= pot.precision_deg(), "seed {seed}, at {aim}: {pot:?}");
            }
        }
    }
    assert!(closed > 50, "{closed} of {shots}");
}

#[test]
fn the_widest_window_comes_first() {
    let open = open_pots(&scene(&random_balls(3, 8)));
    assert!(open.len() > 2, "{}", open.len());
    assert!(open.is_sorted_by(|a, b| a.precision_deg() >= b.precision_deg()));
    for pot in &open {
        assert!(pot.window_deg[0] <= pot.direction_deg && pot.direction_deg <= pot.window_deg[1], "{pot:?}");
    }
}
