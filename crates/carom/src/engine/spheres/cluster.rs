//! Several balls in touch when one of them is struck.

use super::Spheres;
use super::contact::{Present, by_place, contact_event, threshold};
use super::ending::Cause;
use crate::flight::SphereFlight;
use crate::geometry::Vec3;
use crate::law::ball_ball::SphereLaw;
use crate::law::cluster::{
    Body, Collision, Passes, Touch, effective_radius, resolve_pairwise, resolve_reflections,
};
use crate::model::Twist;
use crate::run::{Event, Observer, OnCloth};
use crate::scalar::Scalar;
use crate::scenario::schema::Cluster;

/// A gap up to this many contact tolerances counts as a contact when a ball of it is struck.
const HAIR: f64 = 1e4;

/// The part of v_c up to which balls that touch are pressed together rather than struck.
const CREEP: f64 = 0.01;

type Contact<S> = Touch<S, Vec3<S>, SphereLaw<S>>;

/// A cluster while it is resolved; what it needs is kept for the next, which then asks for no memory.
#[derive(Clone, Debug)]
pub(super) struct Gathering<S> {
    /// The balls, in order of place.
    members: Vec<Present<S>>,
    /// Their contacts, in order of place.
    touches: Vec<Contact<S>>,
    bodies: Vec<Body<S, Vec3<S>>>,
    collision: Collision<S, Vec3<S>>,
    /// How the balls move: after all, before any friction, and how much friction changes that.
    twists: Vec<Twist<S>>,
    pushed: Vec<Twist<S>>,
    changes: Vec<Twist<S>>,
    /// Of the balls whose motion changed how they moved before, and the flights that they begin.
    before: Vec<Twist<S>>,
    flights: Vec<(usize, SphereFlight<S>)>,
    events: Vec<Event<S>>,
}

impl<S: Scalar> Default for Gathering<S> {
    fn default() -> Self {
        Self {
            members: Vec::new(),
            touches: Vec::new(),
            bodies: Vec::new(),
            collision: Collision::default(),
            twists: Vec::new(),
            pushed: Vec::new(),
            changes: Vec::new(),
            before: Vec::new(),
            flights: Vec::new(),
            events: Vec::new(),
        }
    }
}

impl<S: Scalar> Spheres<S> {
    /// Resolves everything in touch with a struck pair, if that is more than the pair itself and closes; says whether.
    pub(super) fn strike_cluster(
        &mut self,
        pair: &[Present<S>; 2],
        time: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) -> bool {
        let mut gathering = core::mem::take(&mut self.gathering);
        self.gather(pair, time, &mut gathering.members);
        let is_struck = gathering.members.len() > 2 && self.strike_gathered(&mut gathering, time, observer);
        self.gathering = gathering;
        is_struck
    }

    /// Resolves the contacts of the balls that are gathered, if any closes; says whether.
    fn strike_gathered(
        &mut self,
        gathering: &mut Gathering<S>,
        time: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) -> bool {
        self.find_touches(gathering, time);
        let Gathering { members, touches, bodies, twists, .. } = &mut *gathering;
        if !touches.iter().any(|touch| self.is_closing(members, touch)) {
            return false;
        }
        replace(bodies, members.iter().map(|m| Body::new(m.twist.velocity, m.sphere.inverse_mass)));
        replace(twists, members.iter().map(|m| m.twist));
        self.resolve_normal(gathering);
        if self.rub(gathering) {
            self.resolve_normal(gathering);
        }
        for (twist, body) in gathering.twists.iter_mut().zip(&mut gathering.bodies) {
            body.drop_round_off();
            twist.velocity = body.velocity;
        }
        self.end_cluster(gathering, time, observer);
        true
    }

    /// The balls that touch each other or the struck ones, in order of place.
    fn gather(&self, pair: &[Present<S>; 2], time: S, members: &mut Vec<Present<S>>) {
        replace(members, pair.iter().copied());
        let mut next = 0;
        while next < members.len() {
            for ball in 0..self.balls.len() {
                let flight = &self.balls[ball].flight;
                if flight.motion.is_out() || members.iter().any(|m| m.ball == ball) {
                    continue;
                }
                let candidate = self.present(ball, time - flight.start());
                if self.is_in_touch(&members[next], &candidate) {
                    members.push(candidate);
                }
            }
            next += 1;
        }
        // No two are at one place.
        members.sort_unstable_by(|a, b| by_place(a.position, b.position));
    }

    fn is_in_touch(&self, a: &Present<S>, b: &Present<S>) -> bool {
        let radii = a.sphere.radius + b.sphere.radius;
        let reach = radii + self.system.tolerance.of(radii) * S::from_f64(HAIR);
        (b.position - a.position).norm_squared() <= reach.squared()
    }

    /// The contacts of the members, in order of place.
    fn find_touches(&self, Gathering { members, touches, .. }: &mut Gathering<S>, time: S) {
        touches.clear();
        for (first, a) in members.iter().enumerate() {
            for (second, b) in members.iter().enumerate().skip(first + 1) {
                if self.is_in_touch(a, b) {
                    let normal = (b.position - a.position).unit();
                    let touch = Touch {
                        effective_radius: effective_radius(a.sphere.radius, Some(b.sphere.radius)),
                        kept_speed: self.kept_speed(a.ball, Some(b.ball), time),
                        ..Touch::new(first, Some(second), normal, self.system.ball_ball)
                    };
                    touches.push(touch);
                }
            }
        }
    }

    /// Whether the balls of a contact move into each other, and are not only pressed together: such pairs are let hop one
    /// by one.
    fn is_closing(&self, members: &[Present<S>], touch: &Contact<S>) -> bool {
        let pair = [members[touch.a], members[touch.b.unwrap_or(touch.a)]];
        let speed = (pair[0].twist.velocity - pair[1].twist.velocity).dot(touch.normal);
        let [a, b] = pair.map(|present| self.system.kept_speeds[present.ball]);
        let creep = if b < a { b } else { a };
        speed > threshold(&pair) + creep * S::from_f64(CREEP)
    }

    fn resolve_normal(&mut self, Gathering { bodies, touches, collision, .. }: &mut Gathering<S>) {
        let Passes { count, forced } = match self.system.cluster {
            Cluster::Hertz => collision.resolve(bodies, touches),
            Cluster::Reflections => resolve_reflections(bodies, touches),
            Cluster::Pairwise => resolve_pairwise(bodies, touches),
        };
        self.diagnostics.cluster_passes += u64::from(count);
        self.diagnostics.forced_clusters += u64::from(forced);
    }

    /// Adds the friction of each contact, from its own normal impulse and against the slip in the middle of the blow; all
    /// of it at once, so that no order matters, and no more than takes energy. Says whether there was any.
    fn rub(&self, gathering: &mut Gathering<S>) -> bool {
        let Gathering { members, touches, bodies, twists, pushed, changes, .. } = gathering;
        let pushes = twists.iter().zip(bodies.iter()).map(|(t, b)| Twist { velocity: b.velocity, ..*t });
        replace(pushed, pushes);
        replace(changes, pushed.iter().copied());
        let mut work = S::ZERO;
        for touch in touches.iter() {
            let (a, b) = (touch.a, touch.b.unwrap_or(touch.a));
            let slip = |twists: &[Twist<S>]| {
                slip([&members[a], &members[b]], touch.normal, [&twists[a], &twists[b]])
            };
            let after = slip(pushed);
            let middle = (slip(twists) + after) * S::from_f64(0.5);
            let push = self.friction(members, touch, middle);
            work += push.dot(after);
            changes[a] = changes[a].after_impulse(&members[a].sphere, touch.normal, push);
            changes[b] = changes[b].after_impulse(&members[b].sphere, -touch.normal, -push);
        }
        if work >= S::ZERO {
            return false;
        }
        // The energy is E + w s + c s² in the part s of the friction: more than the least of it would be too much.
        changes.iter_mut().zip(pushed.iter()).for_each(|(change, pushed)| *change = change.minus(pushed));
        let square = members
            .iter()
            .zip(changes.iter())
            .fold(S::ZERO, |sum, (m, change)| sum + m.sphere.kinetic_energy(change));
        let least = -work / (S::from_f64(2.0) * square);
        let part = if least < S::ONE { least } else { S::ONE };
        for (k, twist) in twists.iter_mut().enumerate() {
            bodies[k].turn(pushed[k].velocity + changes[k].velocity * part);
            twist.spin = pushed[k].spin + changes[k].spin * part;
        }
        true
    }

    /// The friction on the first ball of a contact.
    fn friction(&self, members: &[Present<S>], touch: &Contact<S>, slip: Vec3<S>) -> Vec3<S> {
        let speed = slip.norm();
        if speed <= S::ZERO || touch.impulse <= S::ZERO {
            return Vec3::ZERO;
        }
        let (a, b) = (touch.a, touch.b.unwrap_or(touch.a));
        let inverse = members[a].sphere.inverse_mass + members[b].sphere.inverse_mass;
        let stop = speed / (S::from_f64(3.5) * inverse);
        let rub = self.system.ball_ball.friction(speed) * touch.impulse;
        slip * (-(if rub < stop { rub } else { stop }) / speed)
    }

    fn end_cluster(
        &mut self,
        gathering: &mut Gathering<S>,
        time: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        self.diagnostics.clusters += 1;
        let Gathering { members, touches, twists, before, flights, events, .. } = gathering;
        let moved = || members.iter().zip(twists.iter()).filter(|(member, twist)| **twist != member.twist);
        let flight = |(Present { ball, position, twist, .. }, after): (&Present<S>, &Twist<S>)| {
            (*ball, self.flight_after(*ball, time, *position, twist, *after, Cause::Blow))
        };
        replace(flights, moved().map(flight));
        replace(before, moved().map(|(member, _)| member.twist));
        self.account_for_contact(before, flights);
        flights.iter().for_each(|(ball, _)| self.note_contact(*ball, time));
        self.begin_flights(flights, observer);
        let cluster = Some(self.diagnostics.clusters as u32);
        let row = |touch: &Contact<S>| {
            let pair = [&members[touch.a], &members[touch.b.unwrap_or(touch.a)]];
            Event { cluster, ..contact_event(pair, touch.normal, time, touch.closing_speed, touch.impulse) }
        };
        replace(events, touches.iter().filter(|touch| touch.impulse > S::ZERO).map(row));
        events.sort_unstable_by_key(|event| (event.ball_a, event.ball_b));
        for event in events.iter() {
            self.emit(event, observer);
        }
    }
}

/// Puts other things in a list.
fn replace<T>(list: &mut Vec<T>, things: impl Iterator<Item = T>) {
    list.clear();
    list.extend(things);
}

/// The slip of the first ball's surface on the second's.
fn slip<S: Scalar>(balls: [&Present<S>; 2], normal: Vec3<S>, twists: [&Twist<S>; 2]) -> Vec3<S> {
    let surface = twists[0].surface_velocity(balls[0].sphere.radius, normal)
        - twists[1].surface_velocity(balls[1].sphere.radius, -normal);
    surface - normal * surface.dot(normal)
}
