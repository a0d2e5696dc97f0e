//! The end of a flight: a ball stops slipping, stops, or lands; and how it goes on after anything that happened to it.

use super::{Ball, Spheres};
use crate::flight::{Motion, SphereFlight, SphereState};
use crate::geometry::{Vec2, Vec3};
use crate::law::cloth::bounce;
use crate::model::{Sphere, Twist};
use crate::run::{Event, Kind, Observer, OnCloth, SphereTrack};
use crate::scalar::Scalar;
use crate::scenario::ClothSystem;

/// What gave a ball on the cloth its new motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cause {
    /// The cue or another ball: what pushes it down is thrown back by the cloth.
    Blow,
    /// A cushion, which holds it down.
    Cushion,
}

impl<S: Scalar> Spheres<S> {
    /// A ball as it starts.
    pub(super) fn placed(
        system: &ClothSystem<S>,
        sphere: &Sphere<S>,
        &(position, twist): &(Vec3<S>, Twist<S>),
    ) -> Ball<S> {
        let scale = size(sphere, &twist);
        let twist = Self::settled(system, sphere, position, twist, Cause::Blow);
        let flight = system.cloth.begin(sphere, S::ZERO, position, twist, scale);
        Ball { flight, sphere: *sphere, track: SphereTrack::new() }
    }

    /// The motion of a ball once the cloth has had its say: it lets no ball sink, and hops too low to see are left out.
    fn settled(
        system: &ClothSystem<S>,
        sphere: &Sphere<S>,
        position: Vec3<S>,
        mut twist: Twist<S>,
        cause: Cause,
    ) -> Twist<S> {
        if position.z > sphere.radius {
            return twist;
        }
        let rise = &mut twist.velocity.z;
        if *rise < S::ZERO {
            *rise = if cause == Cause::Blow { -*rise * system.cloth.restitution } else { S::ZERO };
        }
        if !system.cloth.lets_hop(*rise) {
            *rise = S::ZERO;
        }
        twist
    }

    /// The flight of a ball after a contact that changed its motion from `before` to `after`.
    pub(super) fn flight_after(
        &self,
        ball: usize,
        time: S,
        position: Vec3<S>,
        before: &Twist<S>,
        after: Twist<S>,
        cause: Cause,
    ) -> SphereFlight<S> {
        let sphere = &self.balls[ball].sphere;
        let scale = size(sphere, before) + size(sphere, &after);
        let position = self.grounded(ball, position);
        let twist = Self::settled(&self.system, sphere, position, after, cause);
        self.system.cloth.begin(sphere, time, position, twist, scale)
    }

    /// The place of a ball on the cloth, free of round-off of its height.
    fn grounded(&self, ball: usize, position: Vec3<S>) -> Vec3<S> {
        let Ball { flight, sphere, .. } = &self.balls[ball];
        if flight.motion == Motion::Airborne && position.z > sphere.radius {
            position
        } else {
            Vec3::new(position.x, position.y, sphere.radius)
        }
    }

    /// What the end of a ball's flight is called.
    pub(super) fn kind_of_end(&self, ball: usize) -> Kind {
        let Ball { flight, sphere, .. } = &self.balls[ball];
        if flight.motion == Motion::Airborne {
            return Kind::BallCloth;
        }
        kind_of(flight.motion, self.next_on_cloth(ball, &flight.end(sphere)).motion)
    }

    /// The flight that follows where a ball's motion on the cloth ends.
    fn next_on_cloth(&self, ball: usize, end: &SphereState<S>) -> SphereFlight<S> {
        let Ball { flight, sphere, .. } = &self.balls[ball];
        let scale = size(sphere, &flight.state_after(S::ZERO).twist);
        self.system.cloth.begin(sphere, flight.start() + flight.length, end.position, end.twist, scale)
    }

    /// A ball comes to the end of its flight.
    pub(super) fn end_flight(&mut self, ball: usize, time: S, observer: &mut impl Observer<S, OnCloth>) {
        let Ball { flight, sphere, .. } = self.balls[ball];
        let end = flight.end(&sphere);
        if flight.motion == Motion::Airborne {
            self.land(ball, time, &end, observer);
            return;
        }
        let next = self.next_on_cloth(ball, &end);
        self.begin_flight(ball, next, observer);
        let event = self.event_at(ball, time, kind_of(flight.motion, next.motion), end.position);
        self.emit(&event, observer);
    }

    /// A ball falls onto the cloth, or into the pocket that is there.
    fn land(&mut self, ball: usize, time: S, end: &SphereState<S>, observer: &mut impl Observer<S, OnCloth>) {
        if let Some(pocket) = self.system.holes.iter().position(|hole| hole.is_under(end.position.plan())) {
            self.capture(ball, pocket as u32, time, end, observer);
            return;
        }
        let Ball { sphere, .. } = self.balls[ball];
        let cloth = &self.system.cloth;
        let mut twist =
            bounce(&sphere, end.twist, cloth.restitution, cloth.friction.unwrap_or(sphere.sliding));
        let impulse = sphere.mass * (twist.velocity.z - end.twist.velocity.z);
        if !cloth.lets_hop(twist.velocity.z) {
            twist.velocity.z = S::ZERO;
        }
        let scale = size(&sphere, &end.twist);
        let flight = cloth.begin(&sphere, time, end.position, twist, scale);
        self.account_for_contact(ball, &end.twist, &flight);
        self.begin_flight(ball, flight, observer);
        let event = Event {
            closing_speed: -end.twist.velocity.z,
            impulse,
            ..self.event_at(ball, time, Kind::BallCloth, end.position)
        };
        self.emit(&event, observer);
    }

    /// An event of one ball by itself.
    pub(super) fn event_at(&self, ball: usize, time: S, kind: Kind, position: Vec3<S>) -> Event<S> {
        Event {
            time,
            kind,
            ball_a: ball as u32,
            ball_b: None,
            cushion: None,
            point: position.plan(),
            normal: Vec2::ZERO,
            closing_speed: S::ZERO,
            impulse: S::ZERO,
            cluster: None,
        }
    }
}

/// The size of the speeds of a ball, which round-off of its motion is proportional to.
pub(super) fn size<S: Scalar>(sphere: &Sphere<S>, twist: &Twist<S>) -> S {
    let sum = |v: Vec3<S>| v.x.abs() + v.y.abs() + v.z.abs();
    sum(twist.velocity) + sum(twist.spin) * sphere.radius
}

/// What the end of one motion is called that goes over into another.
fn kind_of(before: Motion, after: Motion) -> Kind {
    match (before, after) {
        (Motion::Sliding, Motion::Spinning) => Kind::SlideToSpin,
        (Motion::Sliding, Motion::Resting) => Kind::SlideToRest,
        (Motion::Sliding, _) => Kind::SlideToRoll,
        (Motion::Rolling, Motion::Spinning) => Kind::RollToSpin,
        (Motion::Rolling, _) => Kind::RollToRest,
        _ => Kind::SpinToRest,
    }
}
