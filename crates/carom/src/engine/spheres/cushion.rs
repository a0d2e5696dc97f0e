//! A ball meets a cushion.

use super::contact::{by_place, threshold};
use super::ending::Cause;
use super::hop::{hop_away, stop};
use super::{Ahead, Ball, Spheres};
use crate::engine::queue::Pending;
use crate::flight::Motion;
use crate::geometry::Vec3;
use crate::law::ball_cushion::CushionHit;
use crate::law::collapse::restitution_keeping;
use crate::model::Twist;
use crate::run::{Event, Kind, Observer, OnCloth};
use crate::scalar::{Scalar, other_leg};

impl<S: Scalar> Spheres<S> {
    /// Of all meetings of balls with cushions at a time makes that happen which comes first in order of place: two of these
    /// balls may touch each other.
    pub(super) fn strike_first_cushion(&mut self, time: S, observer: &mut impl Observer<S, OnCloth>) {
        let meetings = (0..self.balls.len()).filter_map(|ball| match *self.queue.pending(ball) {
            Pending { time: own, offset, target: Ahead::Cushion(cushion) } if own == time => {
                Some((ball, cushion, offset, self.balls[ball].flight.position_after(offset)))
            }
            _ => None,
        });
        let first = meetings.reduce(|a, b| if by_place(b.3, a.3).is_lt() { b } else { a });
        if let Some((ball, cushion, offset, _)) = first {
            self.strike_cushion(ball, cushion, time, offset, observer);
        }
    }

    /// A ball meets the nose of a cushion.
    fn strike_cushion(
        &mut self,
        ball: usize,
        cushion: u32,
        time: S,
        offset: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        let present = self.present(ball, offset);
        let hit = self.hit(ball, cushion, present.position, present.twist);
        let normal = hit.contact_normal();
        let closing_speed = hit.closing_speed();
        let kept_speed = self.kept_speed(ball, None, time);
        let mut after = if closing_speed > threshold(&[present]) {
            let law = &self.system.cushion_laws[cushion as usize];
            let restitution = restitution_keeping(law.restitution(closing_speed), kept_speed, closing_speed);
            law.rebound(&hit, restitution)
        } else {
            hit.twist
        };
        let new_flight =
            |after| self.flight_after(ball, time, present.position, &hit.twist, after, Cause::Cushion);
        let (away, level) = (new_flight(after), hit.closing_normal());
        let velocity = away.velocity_after(S::ZERO);
        let bend = self.system.faces[cushion as usize].bend(present.position.plan(), velocity.plan());
        let pull = (Vec3::above(hit.normal * bend, S::ZERO) - away.acceleration()).dot(level);
        let parting_speed = velocity.dot(level);
        let is_pressed = self.is_pressed(&[present], closing_speed, time);
        if let Some(lacking) = self.lacking_speed(&[present], is_pressed, pull, parting_speed) {
            after = hop_away(&hit.sphere, after, level, lacking);
        }
        if self.is_jammed(&present, time) {
            stop(&mut after);
        }
        let flight = new_flight(after);
        let impulse = (after.velocity - hit.twist.velocity).dot(normal) * hit.sphere.mass;
        self.note_contact(ball, time);
        self.account_for_contact(&[hit.twist], &[(ball, flight)]);
        self.begin_flights(&[(ball, flight)], observer);
        let event = Event {
            time,
            kind: Kind::BallCushion,
            ball_a: ball as u32,
            ball_b: None,
            cushion: Some(cushion),
            point: self.system.faces[cushion as usize].foot(present.position.plan()),
            normal: hit.normal,
            closing_speed,
            impulse,
            cluster: None,
        };
        self.emit(&event, observer);
    }

    /// A ball at the nose of a cushion.
    fn hit(&self, ball: usize, cushion: u32, position: Vec3<S>, twist: Twist<S>) -> CushionHit<S> {
        let Ball { flight, sphere, .. } = self.balls[ball];
        let (normal, _) = self.system.faces[cushion as usize].normal_at(position.plan());
        let is_airborne = flight.motion == Motion::Airborne;
        let nose = &self.system.noses[ball];
        let (sin, cos) = if is_airborne {
            let sin = (nose.height - position.z) / sphere.radius;
            (sin, other_leg(sin))
        } else if self.system.cushion_laws[cushion as usize].acts_towards_nose() {
            nose.direction
        } else {
            nose.tilt
        };
        CushionHit { sphere, normal, sin, cos, twist, is_airborne }
    }
}
