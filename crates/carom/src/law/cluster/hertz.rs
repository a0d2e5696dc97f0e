//! Contacts that press on each other for a while: the limit of balls that are stiff, not rigid.
//!
//! A contact whose bodies have come together by δ beyond touching pushes them apart with Hertz's force, `k δ^(3/2)`,
//! where k goes as the root of the effective radius. The stiffer the balls, the shorter it takes; in the limit nothing
//! moves meanwhile: places and normals stay as they are, only the δ and the velocities change. What comes out depends
//! neither on the stiffness, which all balls share, nor on the unit of speed. A ball is pushed by all its neighbours at
//! once, so that three in a row part with −0.0710, 0.0764 and 0.9945 of the speed of the first.
//!
//! When a contact stops closing it loses `1 − e²` of the work done on it since it began to close, δ falls to what the
//! rest is worth, and it opens. So energy is lost, never gained, and a contact by itself parts with e times its closing
//! speed. The speed at which e is asked for is that at which the two bodies by themselves would do the same work; one
//! that is pushed shut from rest has no other. Contacts that have opened and close again collide again.
//!
//! Leapfrog steps, a fixed number to a contact's duration, leave an error of some 1e-5; in the end all impulses are
//! scaled by the factor, near one, that gives the energy its exact value. Where balls lose nearly everything, contacts
//! close anew at each step and the error is of the first order, 1e-3 or so.
//!
//! Sources: Hertz (1882) for the force; Patrício (2004) for its limit in rows of balls; Stronge (1990), from the
//! abstract, for restitution as a ratio of the work done in opening and in closing. *Departs from source*: many
//! contacts, the loss all at once at the end of closing, and where the steps have run out a last pass without
//! restitution.
//!
//! | symbol | meaning |
//! |---|---|
//! | δ | how far two bodies have come together since they touched; after they have parted, minus the gap |
//! | e | coefficient of restitution |
//! | k | stiffness; the unit of time is chosen so that the hardest contact takes [`DURATION`] at the greatest speed |

use super::reflections::force_open;
use super::spring::{Spring, fifth_root, larger};
use super::{Body, PASSES_PER_BALL, Passes, Touch, TouchLaw, closing_touches};
use crate::geometry::Vector;
use crate::law::Reference;
use crate::scalar::Scalar;

/// The sources of the law.
pub const REFERENCES: &[Reference] = &[
    Reference {
        law: "cluster.hertz",
        text: "H. Hertz, Ueber die Berührung fester elastischer Körper, Journal für die reine und angewandte Mathematik 92 (1882) 156–171",
        doi: Some("10.1515/crll.1882.92.156"),
    },
    Reference {
        law: "cluster.hertz",
        text: "W. J. Stronge, Rigid body collisions with friction, Proceedings of the Royal Society of London A 431 (1990) 169–181",
        doi: Some("10.1098/rspa.1990.0125"),
    },
    Reference {
        law: "cluster.hertz",
        text: "P. Patrício, The Hertz contact in chain elastic collisions, arXiv:physics/0402036 (2004)",
        doi: None,
    },
];

/// Steps to a contact's duration.
const STEPS: u32 = 100;
/// Duration of the contact `d²δ/dt² = −δ^(3/2)` that closes at speed 1: `2 (5/4)^(2/5) ∫₀¹ dx / √(1 − x^(5/2))`.
const DURATION: f64 = 3.218;
/// Durations of contacts allowed for each ball of a pass.
const DURATIONS_PER_BALL: u32 = 16;
/// The largest correction of the impulses, relative to them: far more than the steps' error. Where nothing bounces the
/// energy hardly depends on the factor, and is no guide to it.
const LARGEST_CORRECTION: f64 = 1.0 / 256.0;
/// Below this share of what the energy could change by, what is left of it is no guide to the factor at all.
const LEAST_BOUNCE: f64 = 1e-10;

/// Resolves all contacts until none closes.
pub fn resolve_hertz<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &mut [Body<S, V>],
    touches: &mut [Touch<S, V, L>],
) -> Passes {
    Collision::default().resolve(bodies, touches)
}

/// All contacts from the first closing until none closes any more.
///
/// It may be used again, and then asks for no memory.
#[derive(Clone, Debug)]
pub struct Collision<S, V> {
    springs: Vec<Spring<S, V>>,
    /// Velocity of each body, and one over its mass.
    bodies: Vec<(V, S)>,
    /// The greatest closing speed at first; nothing closes that does so with its round-off only.
    speed: S,
    /// The energy that the contacts have lost.
    lost: S,
}

impl<S: Scalar, V> Default for Collision<S, V> {
    fn default() -> Self {
        Self { springs: Vec::new(), bodies: Vec::new(), speed: S::ZERO, lost: S::ZERO }
    }
}

impl<S: Scalar, V: Vector<S>> Collision<S, V> {
    /// Does what [`resolve_hertz`] does.
    pub fn resolve<L: TouchLaw<S>>(
        &mut self,
        bodies: &mut [Body<S, V>],
        touches: &mut [Touch<S, V, L>],
    ) -> Passes {
        let limit = PASSES_PER_BALL * bodies.len();
        for count in 0..limit {
            if !self.begin(bodies, touches) {
                return Passes { count: count as u32, forced: false };
            }
            let has_ended = self.run(touches);
            let factor = self.correction();
            for (spring, touch) in self.springs.iter().zip(&mut *touches) {
                if spring.impulse > S::ZERO {
                    touch.apply(spring.impulse * factor, bodies);
                }
            }
            if !has_ended {
                force_open(bodies, touches);
                return Passes { count: count as u32 + 1, forced: true };
            }
        }
        let forced = closing_touches(touches, bodies).next().is_some();
        if forced {
            force_open(bodies, touches);
        }
        Passes { count: (limit + usize::from(forced)) as u32, forced }
    }

    /// Begins with the bodies' velocities; says whether any contact closes.
    fn begin<L: TouchLaw<S>>(&mut self, bodies: &[Body<S, V>], touches: &mut [Touch<S, V, L>]) -> bool {
        let mut speed = S::ZERO;
        for touch in touches.iter_mut().filter(|touch| touch.is_closing(bodies)) {
            let closing = -touch.gap_rate(bodies);
            touch.note_closing(closing);
            speed = larger(speed, closing);
        }
        if speed == S::ZERO {
            return false;
        }
        let springs = &mut self.springs;
        springs.clear();
        springs.extend(touches.iter().map(|touch| Spring::new(touch, bodies)));
        // A point would have no stiffness at all.
        let largest = springs.iter().fold(S::ZERO, |most, spring| larger(most, spring.stiffness));
        for spring in springs.iter_mut().filter(|spring| spring.stiffness == S::ZERO) {
            spring.stiffness = if largest == S::ZERO { S::ONE } else { largest };
        }
        let hardest = springs.iter().fold(S::ZERO, |most, spring| larger(most, spring.hardness()));
        let unit = hardest * speed.sqrt();
        springs.iter_mut().for_each(|spring| spring.stiffness = spring.stiffness / unit);
        self.bodies.clear();
        self.bodies.extend(bodies.iter().map(|body| (body.velocity, body.inverse_mass)));
        (self.speed, self.lost) = (speed, S::ZERO);
        true
    }

    /// Takes steps until all contacts are open and stay so; says whether they came to that.
    fn run<L: TouchLaw<S>>(&mut self, touches: &mut [Touch<S, V, L>]) -> bool {
        let (mut half, mut next_half, mut has_met) = (S::ZERO, S::ZERO, false);
        for count in 0..STEPS * DURATIONS_PER_BALL * self.bodies.len() as u32 {
            let is_open = !self.is_pressed();
            if is_open {
                let Some(wait) = self.time_to_closing() else { return true };
                self.drift(wait);
                half = S::ZERO;
            }
            if is_open || has_met || count % (STEPS / 2) == 0 {
                next_half = self.step() * S::from_f64(0.5);
            }
            has_met = self.drift(half + next_half);
            self.kick(next_half + next_half, touches);
            half = next_half;
        }
        false
    }

    fn is_pressed(&self) -> bool {
        self.springs.iter().any(|spring| spring.overlap > S::ZERO)
    }

    /// The time until the first of the open contacts closes.
    fn time_to_closing(&self) -> Option<S> {
        let least = self.speed * S::from_f64(64.0 * S::EPSILON);
        let closing = self.springs.iter().filter(|spring| spring.closing > least);
        closing.map(|spring| -spring.overlap / spring.closing).reduce(|a, b| if b < a { b } else { a })
    }

    /// The length of a step: so many to the duration of the hardest contact at the greatest speed that the energy in any
    /// contact allows, of those that touch or come together.
    fn step(&self) -> S {
        let (mut hardness, mut squared_speed) = (S::ZERO, S::ZERO);
        for spring in self.springs.iter().filter(|s| s.overlap >= S::ZERO || s.closing > S::ZERO) {
            hardness = larger(hardness, spring.hardness());
            squared_speed = larger(squared_speed, spring.squared_speed());
        }
        let speed = if squared_speed > S::ZERO { squared_speed.sqrt() } else { self.speed };
        S::from_f64(DURATION / f64::from(STEPS)) / fifth_root(hardness.squared() * speed)
    }

    /// Moves the bodies on at constant velocities; says whether any have met.
    fn drift(&mut self, time: S) -> bool {
        let mut has_met = false;
        for spring in &mut self.springs {
            let was_pressed = spring.overlap > S::ZERO;
            spring.overlap += spring.closing * time;
            if spring.overlap > S::ZERO && !was_pressed {
                (spring.stored, spring.loaded_from) = (S::ZERO, Some(S::ZERO));
                has_met = true;
            } else if spring.overlap <= S::ZERO && was_pressed {
                (spring.stored, spring.loaded_from) = (S::ZERO, None);
            }
        }
        has_met
    }

    /// Lets the forces act for a step.
    fn kick<L: TouchLaw<S>>(&mut self, step: S, touches: &mut [Touch<S, V, L>]) {
        for spring in &mut self.springs {
            spring.push = spring.force() * step;
            spring.act(spring.push, &mut self.bodies);
        }
        let mut excess = S::ZERO;
        for (spring, touch) in self.springs.iter_mut().zip(touches) {
            spring.closing_after = spring.rate(&self.bodies);
            if spring.loaded_from.is_some() && spring.closing_after <= S::ZERO {
                spring.turn(touch, &mut self.lost);
                excess = larger(excess, spring.excess);
            }
        }
        if excess > S::ZERO {
            for spring in &mut self.springs {
                spring.act(-spring.excess, &mut self.bodies);
                spring.excess = S::ZERO;
            }
            for spring in &mut self.springs {
                spring.closing_after = spring.rate(&self.bodies);
            }
        }
        self.springs.iter_mut().for_each(Spring::end_step);
    }

    /// The factor of all impulses that gives the energy its value.
    ///
    /// A factor s changes the energy by `b s² − a s`, which is to be what was lost or, at the end of the steps only, is
    /// still in the contacts.
    fn correction(&self) -> S {
        let (mut a, mut b, mut gone) = (S::ZERO, S::ZERO, self.lost);
        for spring in &self.springs {
            a += spring.impulse * spring.closing_first;
            b += spring.impulse * (spring.closing_first - spring.closing) * S::from_f64(0.5);
            gone += spring.stored;
        }
        let discriminant = a.squared() - S::from_f64(4.0) * b * gone;
        if discriminant <= a.squared() * S::from_f64(LEAST_BOUNCE) {
            return S::ONE;
        }
        let factor = (a + discriminant.sqrt()) / (b + b);
        let (least, most) = (1.0 - LARGEST_CORRECTION, 1.0 + LARGEST_CORRECTION);
        if factor < S::from_f64(least) {
            S::from_f64(least)
        } else if factor > S::from_f64(most) {
            S::from_f64(most)
        } else {
            factor
        }
    }
}
