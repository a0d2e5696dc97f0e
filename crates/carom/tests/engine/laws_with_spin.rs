//! What every law of spheres keeps: one table of laws, and the invariants that all of them are held to.
//!
//! A new law joins by one line in the table.

use crate::kit::spheres::{AtNose, Ball, Meeting, Motion, POOL};
use carom::geometry::Vec3;
use carom::law::coefficient::{IncidenceFriction, NormalRestitution, SlipFriction};
use carom::law::{ball_ball, ball_cushion, cloth};
use carom::model::Twist;
use carom::scalar::{DoubleDouble, Dual, Scalar};

/// Laws between balls.
fn ball_ball_laws<S: Scalar>() -> Vec<ball_ball::SphereLaw<S>> {
    use ball_ball::{Frictional, Mathavan2014, Restitution, SphereLaw};
    let n = S::from_f64;
    let constant = |value| SlipFriction::Constant(n(value));
    let frictional =
        |normal, friction| SphereLaw::Frictional(Frictional { normal: n(normal), friction, cling: S::ONE });
    let mathavan = |normal, friction| SphereLaw::Mathavan2014(Mathavan2014 { normal: n(normal), friction });
    vec![
        SphereLaw::ELASTIC,
        SphereLaw::Restitution(Restitution { normal: n(0.9) }),
        frictional(0.95, SlipFriction::alciatore()),
        frictional(1.0, constant(0.05)),
        frictional(0.0, constant(0.6)),
        frictional(0.5, constant(0.0)),
        mathavan(0.89, constant(0.05)),
        mathavan(1.0, SlipFriction::alciatore()),
        mathavan(1.0, constant(0.6)),
        mathavan(0.0, constant(0.2)),
        mathavan(0.5, constant(0.0)),
    ]
}

/// Laws of cushions.
fn cushion_laws<S: Scalar>() -> Vec<ball_cushion::SphereLaw<S>> {
    use ball_cushion::{Frictional, Han2005, Mathavan2010, Restitution, SphereLaw, StrongeCompliant};
    let n = S::from_f64;
    let constant = |e, mu| (NormalRestitution::Constant(n(e)), IncidenceFriction::Constant(n(mu)));
    let own = || {
        let normal = NormalRestitution::BySpeed { coefficients: [0.39, 0.257, -0.044].map(n), up_to: n(2.9) };
        (normal, IncidenceFriction::ByIncidence { coefficients: [0.471, -0.241].map(n) })
    };
    let frictional = |(normal, friction)| SphereLaw::Frictional(Frictional { normal, friction });
    let han = |(normal, friction)| SphereLaw::Han2005(Han2005 { normal, friction });
    let mathavan = |(normal, friction)| SphereLaw::Mathavan2010(Mathavan2010 { normal, friction });
    let stronge = |(normal, friction), ratio| {
        SphereLaw::StrongeCompliant(StrongeCompliant { normal, friction, frequency_ratio: n(ratio) })
    };
    vec![
        SphereLaw::ELASTIC,
        SphereLaw::Restitution(Restitution { normal: n(0.85), tangential: n(0.9) }),
        frictional(constant(0.85, 0.2)),
        frictional(constant(1.0, 0.0)),
        frictional(own()),
        han(own()),
        han(constant(1.0, 0.3)),
        han(constant(0.0, 0.3)),
        mathavan(constant(0.98, 0.14)),
        mathavan(constant(1.0, 0.3)),
        mathavan(constant(1.0, 0.001)),
        mathavan(constant(1.0, 0.0)),
        mathavan(constant(0.0, 0.2)),
        mathavan(constant(0.8, 0.9)),
        mathavan(own()),
        stronge(constant(0.85, 0.2), 1.8),
        stronge(constant(1.0, 0.6), 1.0),
        stronge(constant(0.4, 0.2), 2.0),
        stronge(constant(0.0, 0.3), 1.5),
        stronge(constant(0.9, 0.0), 1.8),
        stronge(own(), 1.76),
    ]
}

/// Contacts tried of each law.
const CONTACTS: u64 = 400;

/// Relative round-off of an outcome. A contact followed in some dozen steps adds up a few hundred roundings.
const ROUND_OFF: f64 = 1e-12;

fn meet<S: Scalar>(law: &ball_ball::SphereLaw<S>, meeting: &Meeting) -> [Twist<S>; 2] {
    let pair = meeting.pair();
    law.impact(&pair, law.restitution(pair.closing_speed())).twists
}

fn rebound<S: Scalar>(law: &ball_cushion::SphereLaw<S>, at: &AtNose) -> Twist<S> {
    let hit = at.hit();
    law.rebound(&hit, law.restitution(hit.closing_speed()))
}

/// Velocity and spin, the spin times the radius.
fn numbers<S: Scalar>(ball: Ball, twist: &Twist<S>) -> [S; 6] {
    let radius = S::from_f64(ball.radius);
    let Twist { velocity: v, spin: w } = twist;
    [v.x, v.y, v.z, w.x * radius, w.y * radius, w.z * radius]
}

fn numbers_of_both<S: Scalar>(meeting: &Meeting, twists: &[Twist<S>; 2]) -> Vec<S> {
    (0..2).flat_map(|k| numbers(meeting.balls[k], &twists[k])).collect()
}

fn values<S: Scalar>(numbers: &[S]) -> Vec<f64> {
    numbers.iter().map(|number| number.to_f64()).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

fn size(motions: &[Motion]) -> f64 {
    motions.iter().flat_map(|motion| motion.velocity.into_iter().chain(motion.rolled)).map(f64::abs).sum()
}

fn is_followed(law: &ball_ball::SphereLaw<f64>) -> bool {
    matches!(law, ball_ball::SphereLaw::Mathavan2014(_))
}

/// The image of a vector in a vertical plane or under a turn about the vertical; of a spin, the same turned over.
#[derive(Clone, Copy, Debug)]
struct Image {
    x: [f64; 2],
    y: [f64; 2],
}

impl Image {
    const ALL: [Self; 3] = [
        Self { x: [-1.0, 0.0], y: [0.0, 1.0] },
        Self { x: [0.6, 0.8], y: [-0.8, 0.6] },
        Self { x: [0.28, -0.96], y: [-0.96, -0.28] },
    ];

    fn plan(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| x * self.x[k] + y * self.y[k])
    }

    fn vector(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [x, y] = self.plan([x, y]);
        [x, y, z]
    }

    fn spin(&self, spin: [f64; 3]) -> [f64; 3] {
        let turn = self.x[0] * self.y[1] - self.x[1] * self.y[0];
        self.vector(spin).map(|c| c * turn)
    }

    fn motion(&self, motion: Motion) -> Motion {
        Motion { velocity: self.vector(motion.velocity), rolled: self.spin(motion.rolled) }
    }

    fn numbers(&self, numbers: &[f64]) -> Vec<f64> {
        let image = |six: &[f64]| {
            let velocity = self.vector([six[0], six[1], six[2]]);
            velocity.into_iter().chain(self.spin([six[3], six[4], six[5]])).collect::<Vec<_>>()
        };
        numbers.chunks(6).flat_map(image).collect()
    }
}

#[test]
fn balls_gain_no_energy_and_part() {
    for law in ball_ball_laws::<f64>() {
        for meeting in (0..CONTACTS).map(Meeting::random) {
            let pair = meeting.pair::<f64>();
            let energy = |twists: &[Twist<f64>; 2]| -> f64 {
                (0..2).map(|k| pair.spheres[k].kinetic_energy(&twists[k])).sum()
            };
            let found = law.impact(&pair, law.restitution(pair.closing_speed()));
            assert!(found.impulse > 0.0, "{law:?}: pulls");
            let (before, after) = (energy(&pair.twists), energy(&found.twists));
            assert!(after <= before * (1.0 + ROUND_OFF), "{law:?}: {before} to {after}, {meeting:?}");
            assert!(after >= before * (1.0 - ROUND_OFF) || !law.is_lossless(), "{law:?} loses energy");
            let opening = (found.twists[1].velocity - found.twists[0].velocity).dot(pair.normal);
            assert!(opening >= -ROUND_OFF * size(&meeting.motions), "{law:?}: closes on, {opening}");
            if !is_followed(&law) {
                let expected = law.restitution(pair.closing_speed()) * pair.closing_speed();
                assert!(
                    (opening - expected).abs() <= ROUND_OFF * size(&meeting.motions),
                    "{law:?}: {opening}"
                );
            }
        }
    }
}

#[test]
fn balls_keep_momentum_angular_momentum_and_the_spin_about_the_normal() {
    for law in ball_ball_laws::<f64>() {
        for meeting in (0..CONTACTS).map(Meeting::random) {
            // With the law that knows the cloth only balls in the air are free.
            let meeting = Meeting { on_cloth: [false; 2], ..meeting };
            let (pair, after) = (meeting.pair::<f64>(), meet(&law, &meeting));
            let change = |k: usize| {
                let sphere = &pair.spheres[k];
                let velocity = after[k].velocity - pair.twists[k].velocity;
                let spin = after[k].spin - pair.twists[k].spin;
                (velocity * sphere.mass, spin * (sphere.inertia() / sphere.radius))
            };
            let [(push, turn), (other_push, other_turn)] = [change(0), change(1)];
            let tolerance = ROUND_OFF * size(&meeting.motions);
            assert!((push + other_push).norm() <= tolerance, "{law:?}: momentum");
            // The same force at the same place, with its arm towards either centre.
            assert!((turn - other_turn).norm() <= tolerance, "{law:?}: angular momentum");
            assert!((turn - pair.normal.cross(push)).norm() <= tolerance, "{law:?}: torque");
            assert!(turn.dot(pair.normal).abs() <= tolerance, "{law:?}: spin about the normal");
        }
    }
}

#[test]
fn a_ball_on_the_cloth_stays_on_it_with_mathavan() {
    for law in ball_ball_laws::<f64>().into_iter().filter(is_followed) {
        for meeting in (0..CONTACTS).map(Meeting::random) {
            for (k, twist) in meet(&law, &meeting).iter().enumerate().filter(|(k, _)| meeting.on_cloth[*k]) {
                assert_eq!(twist.velocity.z, 0.0, "{law:?}: ball {k}");
            }
        }
    }
}

#[test]
fn in_the_air_followed_contacts_are_single_blows() {
    use ball_ball::{Frictional, SphereLaw};
    for law in ball_ball_laws::<f64>() {
        let SphereLaw::Mathavan2014(followed) = law else { continue };
        let blow = SphereLaw::Frictional(Frictional {
            normal: followed.normal,
            friction: followed.friction,
            cling: 1.0,
        });
        for meeting in (0..CONTACTS).map(Meeting::random) {
            let meeting = Meeting { on_cloth: [false; 2], ..meeting };
            let [a, b] = [meet(&law, &meeting), meet(&blow, &meeting)].map(|t| numbers_of_both(&meeting, &t));
            // A slip that is about to stop is stopped a ten-millionth early.
            assert!(distance(&a, &b) <= 1e-7 * size(&meeting.motions), "{law:?}: {a:?}, {b:?}");
        }
    }
}

#[test]
fn balls_may_change_places() {
    for law in ball_ball_laws::<f64>() {
        for meeting in (0..CONTACTS).map(Meeting::random) {
            let Meeting { balls: [a, b], normal, motions: [v, w], on_cloth: [c, d] } = meeting;
            let swapped =
                Meeting { balls: [b, a], normal: normal.map(|c| -c), motions: [w, v], on_cloth: [d, c] };
            let [first, second] = meet(&law, &swapped);
            let found = numbers_of_both(&meeting, &[second, first]);
            let expected = numbers_of_both(&meeting, &meet(&law, &meeting));
            let error = distance(&found, &expected);
            assert!(error <= ROUND_OFF * size(&meeting.motions), "{law:?}: {error:e}");
        }
    }
}

#[test]
fn balls_that_gear_rub_nothing() {
    for law in ball_ball_laws::<f64>() {
        for mut meeting in (0..CONTACTS).map(Meeting::random) {
            // The second ball takes on the spin that stops the slip; a slope would let the cloth push.
            meeting = Meeting { on_cloth: [false; 2], ..meeting };
            let pair = meeting.pair::<f64>();
            let missing = pair.normal.cross(pair.slip());
            for (k, axis) in missing.to_f64().into_iter().enumerate() {
                meeting.motions[1].rolled[k] -= axis;
            }
            let (pair, after) = (meeting.pair::<f64>(), meet(&law, &meeting));
            let tolerance = ROUND_OFF * size(&meeting.motions);
            assert!(pair.slip().norm() <= tolerance, "the slip is left");
            for ((after, before), ball) in after.iter().zip(pair.twists).zip(meeting.balls) {
                let spin = (after.spin - before.spin).norm() * ball.radius;
                assert!(spin <= tolerance, "{law:?}: {spin}");
            }
        }
    }
}

#[test]
fn mirrored_and_turned_contacts_have_mirrored_and_turned_outcomes() {
    for (image, seed) in Image::ALL.into_iter().flat_map(|image| (0..CONTACTS).map(move |seed| (image, seed)))
    {
        let meeting = Meeting::random(seed);
        let seen = Meeting {
            normal: image.vector(meeting.normal),
            motions: meeting.motions.map(|motion| image.motion(motion)),
            ..meeting
        };
        for law in ball_ball_laws::<f64>() {
            let expected = image.numbers(&numbers_of_both(&meeting, &meet(&law, &meeting)));
            let error = distance(&numbers_of_both(&seen, &meet(&law, &seen)), &expected);
            assert!(error <= ROUND_OFF * size(&meeting.motions), "{law:?}: {error:e}");
        }
        let at = AtNose::random(seed);
        let seen = AtNose { normal: image.plan(at.normal), motion: image.motion(at.motion), ..at };
        for law in cushion_laws::<f64>() {
            let expected = image.numbers(&numbers(at.ball, &rebound(&law, &at)));
            let error = distance(&numbers(at.ball, &rebound(&law, &seen)), &expected);
            assert!(error <= ROUND_OFF * size(&[at.motion]), "{law:?}: {error:e}, {at:?}");
        }
    }
}

#[test]
fn only_differences_of_velocities_count_between_balls_in_the_air() {
    let wind = [3.0, -2.0, 1.0];
    for law in ball_ball_laws::<f64>() {
        for meeting in (0..CONTACTS).map(Meeting::random) {
            let meeting = Meeting { on_cloth: [false; 2], ..meeting };
            let blown = |motion: Motion| {
                let velocity = [0, 1, 2].map(|k| motion.velocity[k] + wind[k]);
                Motion { velocity, ..motion }
            };
            let seen = Meeting { motions: meeting.motions.map(blown), ..meeting };
            let (found, expected) = (meet(&law, &seen), meet(&law, &meeting));
            for k in 0..2 {
                let error = (found[k].velocity - expected[k].velocity - Vec3::from_f64(wind)).norm();
                assert!(error <= ROUND_OFF * (size(&meeting.motions) + 6.0), "{law:?}: {error:e}");
            }
        }
    }
}

#[test]
fn a_ball_gains_no_energy_at_a_cushion_or_on_the_cloth() {
    for law in cushion_laws::<f64>() {
        for at in (0..4 * CONTACTS).map(AtNose::random) {
            let hit = at.hit::<f64>();
            let restitution = law.restitution(hit.closing_speed());
            assert!((0.0..=1.0).contains(&restitution), "{law:?}: e = {restitution}");
            let after = law.rebound(&hit, restitution);
            let (before, after_energy) =
                (hit.sphere.kinetic_energy(&hit.twist), hit.sphere.kinetic_energy(&after));
            assert!(
                after_energy <= before * (1.0 + ROUND_OFF),
                "{law:?}: {before} to {after_energy}, {at:?}"
            );
            assert!(
                after_energy >= before * (1.0 - ROUND_OFF) || !law.is_lossless(),
                "{law:?} loses energy, {at:?}"
            );
            let landed = cloth::bounce(&hit.sphere, hit.twist, 0.5, 0.3);
            let closes = hit.twist.velocity.z < 0.0;
            assert!(!closes || hit.sphere.kinetic_energy(&landed) <= before * (1.0 + ROUND_OFF), "{at:?}");
        }
    }
}

#[test]
fn a_ball_on_the_cloth_leaves_the_cushion_level() {
    for law in cushion_laws::<f64>() {
        for at in (0..CONTACTS).map(AtNose::random).filter(|at| !at.is_airborne) {
            let after = rebound(&law, &at);
            let rises = matches!(law, ball_cushion::SphereLaw::Frictional(_));
            assert!(rises || after.velocity.z == 0.0, "{law:?}: {after:?}");
            let away = after.velocity.dot(at.hit::<f64>().closing_normal());
            // A blow at a nose above the centre goes down too: with much friction or little restitution, the laws that
            // then leave the rest to the cloth let the ball go on into the cushion.
            let goes_level = matches!(
                law,
                ball_cushion::SphereLaw::Restitution(_) | ball_cushion::SphereLaw::Mathavan2010(_)
            );
            let tolerance = 1e-6 * size(&[at.motion]);
            assert!(away >= -tolerance || (at.sin > 0.0 && !goes_level), "{law:?}: {away}, {at:?}");
        }
    }
}

#[test]
fn twice_the_speed_is_twice_the_outcome() {
    let is_constant = |law: &ball_cushion::SphereLaw<f64>| !format!("{law:?}").contains("By");
    for at in (0..CONTACTS).map(AtNose::random) {
        for law in cushion_laws::<f64>().into_iter().filter(is_constant) {
            let twice = rebound(&law, &AtNose { motion: at.motion.times(2.0), ..at });
            let once = rebound(&law, &at);
            // Doubling is exact, and so is every step of a law without a scale.
            assert_eq!(numbers(at.ball, &twice), numbers(at.ball, &once).map(|c| 2.0 * c), "{law:?}");
        }
    }
}

/// Contacts at the edges of what a law may be asked: grazing, without slip, head on, and slow.
fn edges() -> Vec<Motion> {
    let mut found = Vec::new();
    for closing in [1e-300, 1e-18, 1e-9, 1e-3, 1.0, 1e3] {
        for along in [0.0, 1e-18, 1e-9, 1.0, -1.0] {
            found.extend([
                Motion::stun([along, closing]),
                Motion::rolling([along, closing], 0.0),
                Motion::rolling([along, closing], along),
                Motion { velocity: [along, closing, 0.0], rolled: [0.28 * closing, 0.0, along] },
            ]);
        }
    }
    found
}

#[test]
fn grazes_gears_and_dead_contacts_have_numbers_for_outcomes() {
    for motion in edges() {
        for law in ball_ball_laws::<f64>() {
            for normal in [[0.0, 1.0, 0.0], [0.0, 0.6, -0.8], [0.0, 0.6, 0.8]] {
                for on_cloth in [[true; 2], [false; 2]] {
                    let motions = [motion, Motion::REST];
                    let meeting = Meeting { balls: [POOL; 2], normal, motions, on_cloth };
                    let after = meet(&law, &meeting);
                    let is_finite = after.iter().all(|t| t.velocity.is_finite() && t.spin.is_finite());
                    assert!(is_finite, "{law:?}: {meeting:?}, {after:?}");
                }
            }
        }
        for law in cushion_laws::<f64>() {
            for (sin, is_airborne) in [(0.0, false), (0.28, false), (0.28, true), (-0.1, false)] {
                let at = AtNose { ball: POOL, normal: [0.0, -1.0], sin, motion, is_airborne };
                let after = rebound(&law, &at);
                assert!(after.velocity.is_finite() && after.spin.is_finite(), "{law:?}: {at:?}, {after:?}");
                let frictionless = Ball { sliding: 0.0, ..POOL };
                assert!(rebound(&law, &AtNose { ball: frictionless, ..at }).spin.is_finite(), "{law:?}");
            }
        }
    }
}

#[test]
fn balls_that_meet_one_above_the_other_have_numbers_for_outcomes() {
    let motion = Motion { velocity: [0.3, 0.1, -1.0], rolled: [1.0, 2.0, 3.0] };
    for law in ball_ball_laws::<f64>() {
        let normal = [0.0, 0.0, -1.0];
        let motions = [motion, Motion::REST];
        let [_, lower] = meet(&law, &Meeting { balls: [POOL; 2], normal, motions, on_cloth: [false, true] });
        assert!(lower.velocity.is_finite() && lower.spin.is_finite(), "{law:?}");
    }
}

#[test]
fn a_grazing_ball_is_left_alone_in_the_limit() {
    for law in ball_ball_laws::<f64>() {
        let motion = Motion::rolling([1.0, 1e-9], 0.5);
        let meeting = Meeting {
            balls: [POOL; 2],
            normal: [0.0, 1.0, 0.0],
            motions: [motion, Motion::REST],
            on_cloth: [true; 2],
        };
        let before = numbers_of_both(&meeting, &meeting.pair::<f64>().twists);
        assert!(distance(&before, &numbers_of_both(&meeting, &meet(&law, &meeting))) < 1e-8, "{law:?}");
    }
    for law in cushion_laws::<f64>() {
        let motion = Motion::rolling([1.0, 1e-9], 0.5);
        let at = AtNose { ball: POOL, normal: [0.0, -1.0], sin: 0.28, motion, is_airborne: false };
        let before = numbers(POOL, &at.hit::<f64>().twist);
        let after = numbers(POOL, &rebound(&law, &at));
        // The tangential factor of plain restitution is no friction: it acts however slow the hit.
        let is_friction = !matches!(law, ball_cushion::SphereLaw::Restitution(_));
        assert!(!is_friction || distance(&before, &after) < 1e-8, "{law:?}: {before:?}, {after:?}");
    }
}

#[test]
fn all_number_types_agree() {
    let laws = ball_ball_laws::<f64>()
        .into_iter()
        .zip(ball_ball_laws::<Dual<1>>())
        .zip(ball_ball_laws::<DoubleDouble>());
    for ((law, dual_law), fine_law) in laws {
        for meeting in (0..CONTACTS).map(Meeting::random) {
            let plain = numbers_of_both(&meeting, &meet(&law, &meeting));
            assert_eq!(plain, values(&numbers_of_both(&meeting, &meet(&dual_law, &meeting))), "{law:?}");
            let fine = values(&numbers_of_both(&meeting, &meet(&fine_law, &meeting)));
            let error = distance(&plain, &fine);
            assert!(error <= ROUND_OFF * size(&meeting.motions), "{law:?}: {error:e}");
        }
    }
    let laws =
        cushion_laws::<f64>().into_iter().zip(cushion_laws::<Dual<1>>()).zip(cushion_laws::<DoubleDouble>());
    for ((law, dual_law), fine_law) in laws {
        for at in (0..CONTACTS).map(AtNose::random) {
            let plain = numbers(at.ball, &rebound(&law, &at));
            assert_eq!(plain.to_vec(), values(&numbers(at.ball, &rebound(&dual_law, &at))), "{law:?}");
            let error = distance(&plain, &values(&numbers(at.ball, &rebound(&fine_law, &at))));
            assert!(error <= ROUND_OFF * size(&[at.motion]), "{law:?}: {error:e}, {at:?}");
        }
    }
}

/// A motion with a part of another added.
fn nudged(motion: Motion, by: Motion, part: f64) -> Motion {
    let add = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| a[k] + part * b[k]);
    Motion { velocity: add(motion.velocity, by.velocity), rolled: add(motion.rolled, by.rolled) }
}

/// A twist whose derivative is another motion.
fn dual_twist(ball: Ball, motion: Motion, by: Motion) -> Twist<Dual<1>> {
    let dual = |a: [f64; 3], b: [f64; 3]| {
        let [x, y, z] = [0, 1, 2].map(|k| Dual { value: a[k], derivatives: [b[k]] });
        Vec3::new(x, y, z)
    };
    let spin = |m: Motion| m.rolled.map(|c| c / ball.radius);
    Twist { velocity: dual(motion.velocity, by.velocity), spin: dual(spin(motion), spin(by)) }
}

/// The motion moved off what balls often do, to roll or not to spin: there friction with the cloth has no derivative.
fn shaken(motion: Motion) -> Motion {
    let by = Motion { velocity: [0.3, 0.2, 0.0], rolled: [-0.4, 0.3, 0.5] };
    nudged(motion, by, 0.2 * size(&[motion]))
}

/// A step for which round-off and curvature leave like errors in a central difference.
const NUDGE: f64 = 1e-5;

/// Part of the contacts that may lie on a kink of their law, or so near that a difference steps over it.
const KINKS: usize = 20;

fn assert_slopes_mostly(errors: &mut [f64], what: &str) {
    errors.sort_by(f64::total_cmp);
    let kept = errors.len() - errors.len() / KINKS;
    let (most, median) = (errors[kept - 1], errors[errors.len() / 2]);
    assert!(most < 1e-4 && median < 1e-6, "{what}: {most:e}, median {median:e}");
}

#[test]
fn derivatives_are_those_of_finite_differences() {
    let by = Motion { velocity: [0.3, -0.5, 0.0], rolled: [0.7, 0.2, -0.4] };
    for (law, dual_law) in ball_ball_laws::<f64>().into_iter().zip(ball_ball_laws::<Dual<1>>()) {
        let mut errors = Vec::new();
        for meeting in (0..CONTACTS).map(Meeting::random) {
            let meeting = Meeting { motions: meeting.motions.map(shaken), ..meeting };
            if meeting.pair::<f64>().closing_speed() <= 0.0 {
                continue;
            }
            let scale = size(&meeting.motions);
            let by = by.times(scale);
            let at = |part: f64| {
                let motions = [nudged(meeting.motions[0], by, part), meeting.motions[1]];
                numbers_of_both(&meeting, &meet(&law, &Meeting { motions, ..meeting }))
            };
            let (high, low) = (at(NUDGE), at(-NUDGE));
            let mut pair = meeting.pair::<Dual<1>>();
            pair.twists[0] = dual_twist(meeting.balls[0], meeting.motions[0], by);
            let twists = dual_law.impact(&pair, dual_law.restitution(pair.closing_speed())).twists;
            let exact: Vec<f64> =
                numbers_of_both(&meeting, &twists).iter().map(|n| n.derivatives[0]).collect();
            let slope: Vec<f64> = high.iter().zip(&low).map(|(h, l)| (h - l) / (2.0 * NUDGE)).collect();
            errors.push(distance(&exact, &slope) / scale);
        }
        assert_slopes_mostly(&mut errors, &format!("{law:?}"));
    }
    for (law, dual_law) in cushion_laws::<f64>().into_iter().zip(cushion_laws::<Dual<1>>()) {
        let mut errors = Vec::new();
        for at in (0..CONTACTS).map(AtNose::random) {
            let at = AtNose { motion: shaken(at.motion), ..at };
            if at.hit::<f64>().closing_speed() <= 0.0 {
                continue;
            }
            let scale = size(&[at.motion]);
            let by = by.times(scale);
            let nudge = |part: f64| {
                numbers(at.ball, &rebound(&law, &AtNose { motion: nudged(at.motion, by, part), ..at }))
            };
            let (high, low) = (nudge(NUDGE), nudge(-NUDGE));
            let mut hit = at.hit::<Dual<1>>();
            hit.twist = dual_twist(at.ball, at.motion, by);
            let twist = dual_law.rebound(&hit, dual_law.restitution(hit.closing_speed()));
            let exact = numbers(at.ball, &twist).map(|n| n.derivatives[0]);
            let slope = [0, 1, 2, 3, 4, 5].map(|k| (high[k] - low[k]) / (2.0 * NUDGE));
            errors.push(distance(&exact, &slope) / scale);
        }
        assert_slopes_mostly(&mut errors, &format!("{law:?}"));
    }
}

#[test]
fn every_law_of_spheres_says_where_it_comes_from() {
    let sources =
        ball_ball_laws::<f64>().iter().map(|law| ("ball_ball.", law.references())).collect::<Vec<_>>();
    let cushions = cushion_laws::<f64>();
    let cushions = cushions.iter().map(|law| ("ball_cushion.", law.references()));
    for (room, references) in sources.into_iter().chain(cushions) {
        assert!(!references.is_empty());
        for reference in references {
            assert!(reference.law.starts_with(room) && reference.text.len() > 20, "{reference:?}");
            assert!(reference.doi.is_none_or(|doi| doi.starts_with("10.")), "{reference:?}");
        }
    }
}
