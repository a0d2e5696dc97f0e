//! Several balls in touch when one of them is struck.

use super::Spheres;
use super::contact::{Present, by_place, contact_event, threshold};
use super::ending::Cause;
use crate::geometry::Vec3;
use crate::law::ball_ball::SphereLaw;
use crate::law::cluster::{
    Body, Passes, Touch, effective_radius, resolve_hertz, resolve_pairwise, resolve_reflections,
};
use crate::model::Twist;
use crate::run::{Event, Observer, OnCloth};
use crate::scalar::Scalar;
use crate::scenario::schema::Cluster;

/// A gap up to this many contact tolerances counts as a contact when a ball of it is struck.
const HAIR: f64 = 1e4;

/// The part of v_c up to which balls that touch are pressed together rather than struck.
const CREEP: f64 = 0.01;

type Bodies<S> = Vec<Body<S, Vec3<S>>>;
type Touches<S> = Vec<Touch<S, Vec3<S>, SphereLaw<S>>>;

impl<S: Scalar> Spheres<S> {
    /// Resolves everything in touch with a struck pair, if that is more than the pair itself and closes; says whether.
    pub(super) fn strike_cluster(
        &mut self,
        pair: &[Present<S>; 2],
        time: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) -> bool {
        let members = self.gather(pair, time);
        if members.len() == 2 {
            return false;
        }
        let mut bodies: Bodies<S> =
            members.iter().map(|m| Body::new(m.twist.velocity, m.sphere.inverse_mass)).collect();
        let mut touches = self.touches(&members, time);
        if !touches.iter().any(|touch| self.is_closing(&members, touch)) {
            return false;
        }
        self.resolve_normal(&mut bodies, &mut touches);
        let mut twists: Vec<Twist<S>> = members.iter().map(|m| m.twist).collect();
        if self.rub(&members, &touches, &mut bodies, &mut twists) {
            self.resolve_normal(&mut bodies, &mut touches);
        }
        for (twist, body) in twists.iter_mut().zip(&mut bodies) {
            body.drop_round_off();
            twist.velocity = body.velocity;
        }
        self.end_cluster(&members, &touches, &twists, time, observer);
        true
    }

    /// The balls that touch each other or the struck ones, in order of place.
    fn gather(&self, pair: &[Present<S>; 2], time: S) -> Vec<Present<S>> {
        let mut members = pair.to_vec();
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
        members.sort_by(|a, b| by_place(a.position, b.position));
        members
    }

    fn is_in_touch(&self, a: &Present<S>, b: &Present<S>) -> bool {
        let radii = a.sphere.radius + b.sphere.radius;
        let reach = radii + self.system.tolerance.of(radii) * S::from_f64(HAIR);
        (b.position - a.position).norm_squared() <= reach.squared()
    }

    /// The contacts of the members, in order of place.
    fn touches(&self, members: &[Present<S>], time: S) -> Touches<S> {
        let mut touches = Vec::new();
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
        touches
    }

    /// Whether the balls of a contact move into each other, and are not only pressed together: such pairs are let hop one
    /// by one.
    fn is_closing(&self, members: &[Present<S>], touch: &Touch<S, Vec3<S>, SphereLaw<S>>) -> bool {
        let pair = [members[touch.a], members[touch.b.unwrap_or(touch.a)]];
        let speed = (pair[0].twist.velocity - pair[1].twist.velocity).dot(touch.normal);
        let [a, b] = pair.map(|present| self.system.kept_speeds[present.ball]);
        let creep = if b < a { b } else { a };
        speed > threshold(&pair) + creep * S::from_f64(CREEP)
    }

    fn resolve_normal(
        &mut self,
        bodies: &mut [Body<S, Vec3<S>>],
        touches: &mut [Touch<S, Vec3<S>, SphereLaw<S>>],
    ) {
        let Passes { count, forced } = match self.system.cluster {
            Cluster::Hertz => resolve_hertz(bodies, touches),
            Cluster::Reflections => resolve_reflections(bodies, touches),
            Cluster::Pairwise => resolve_pairwise(bodies, touches),
        };
        self.diagnostics.cluster_passes += u64::from(count);
        self.diagnostics.forced_clusters += u64::from(forced);
    }

    /// Adds the friction of each contact, from its own normal impulse and against the slip in the middle of the blow; all
    /// of it at once, so that no order matters, and no more than takes energy. Says whether there was any.
    fn rub(
        &self,
        members: &[Present<S>],
        touches: &Touches<S>,
        bodies: &mut Bodies<S>,
        twists: &mut [Twist<S>],
    ) -> bool {
        let pushed: Vec<Twist<S>> =
            twists.iter().zip(bodies.iter()).map(|(t, b)| Twist { velocity: b.velocity, ..*t }).collect();
        let mut rubbed = pushed.clone();
        let mut work = S::ZERO;
        for touch in touches {
            let (a, b) = (touch.a, touch.b.unwrap_or(touch.a));
            let slip = |twists: &[Twist<S>]| {
                slip([&members[a], &members[b]], touch.normal, [&twists[a], &twists[b]])
            };
            let after = slip(&pushed);
            let middle = (slip(twists) + after) * S::from_f64(0.5);
            let push = self.friction(members, touch, middle);
            work += push.dot(after);
            rubbed[a] = rubbed[a].after_impulse(&members[a].sphere, touch.normal, push);
            rubbed[b] = rubbed[b].after_impulse(&members[b].sphere, -touch.normal, -push);
        }
        if work >= S::ZERO {
            return false;
        }
        // The energy is E + w s + c s² in the part s of the friction: more than the least of it would be too much.
        let changes: Vec<Twist<S>> = rubbed.iter().zip(&pushed).map(|(a, b)| a.minus(b)).collect();
        let square = members
            .iter()
            .zip(&changes)
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
    fn friction(
        &self,
        members: &[Present<S>],
        touch: &Touch<S, Vec3<S>, SphereLaw<S>>,
        slip: Vec3<S>,
    ) -> Vec3<S> {
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
        members: &[Present<S>],
        touches: &Touches<S>,
        twists: &[Twist<S>],
        time: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        self.diagnostics.clusters += 1;
        let moved: Vec<usize> = (0..members.len()).filter(|&k| twists[k] != members[k].twist).collect();
        let flight = |&k: &usize| {
            let Present { ball, position, twist, .. } = &members[k];
            (*ball, self.flight_after(*ball, time, *position, twist, twists[k], Cause::Blow))
        };
        let flights: Vec<_> = moved.iter().map(flight).collect();
        let before: Vec<_> = moved.iter().map(|&k| members[k].twist).collect();
        self.account_for_contact(&before, &flights);
        flights.iter().for_each(|(ball, _)| self.note_contact(*ball, time));
        self.begin_flights(&flights, observer);
        let cluster = Some(self.diagnostics.clusters as u32);
        let row = |touch: &Touch<S, Vec3<S>, SphereLaw<S>>| {
            let pair = [&members[touch.a], &members[touch.b.unwrap_or(touch.a)]];
            Event { cluster, ..contact_event(pair, touch.normal, time, touch.closing_speed, touch.impulse) }
        };
        let mut events: Vec<Event<S>> =
            touches.iter().filter(|touch| touch.impulse > S::ZERO).map(row).collect();
        events.sort_by_key(|event| (event.ball_a, event.ball_b));
        for event in &events {
            self.emit(event, observer);
        }
    }
}

/// The slip of the first ball's surface on the second's.
fn slip<S: Scalar>(balls: [&Present<S>; 2], normal: Vec3<S>, twists: [&Twist<S>; 2]) -> Vec3<S> {
    let surface = twists[0].surface_velocity(balls[0].sphere.radius, normal)
        - twists[1].surface_velocity(balls[1].sphere.radius, -normal);
    surface - normal * surface.dot(normal)
}
