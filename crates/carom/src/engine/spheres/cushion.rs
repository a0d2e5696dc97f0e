//! A ball meets a cushion.

use super::contact::{Present, pay, threshold};
use super::ending::Cause;
use super::{Ball, Spheres};
use crate::flight::{Motion, SphereFlight};
use crate::geometry::Vec3;
use crate::law::ball_cushion::CushionHit;
use crate::law::collapse::restitution_keeping;
use crate::model::Twist;
use crate::run::{Event, Kind, Observer, OnCloth};
use crate::scalar::Scalar;

impl<S: Scalar> Spheres<S> {
    /// A ball meets the nose of a cushion.
    pub(super) fn strike_cushion(
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
        let after = if closing_speed > threshold(&[present]) {
            let law = &self.system.cushion_laws[cushion as usize];
            let restitution = restitution_keeping(law.restitution(closing_speed), kept_speed, closing_speed);
            law.rebound(&hit, restitution)
        } else {
            hit.twist
        };
        let new_flight =
            |after| self.flight_after(ball, time, present.position, &hit.twist, after, Cause::Cushion);
        let is_pressed = closing_speed <= threshold(&[present]) || self.is_pressed(ball, time);
        let after = match self.lacking_speed(&present, &new_flight(after), hit.closing_normal(), is_pressed) {
            Some(lacking) => hop(&hit, after, lacking),
            None => after,
        };
        let flight = new_flight(after);
        let impulse = (after.velocity - hit.twist.velocity).dot(normal) * hit.sphere.mass;
        self.note_contact(ball, time);
        self.account_for_contact(ball, &hit.twist, &flight);
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

    /// What a ball that is pressed onto a cushion lacks of the speed of a hop that lasts t_c, and any of more than
    /// round-off.
    fn lacking_speed(
        &self,
        ball: &Present<S>,
        flight: &SphereFlight<S>,
        normal: Vec3<S>,
        is_pressed: bool,
    ) -> Option<S> {
        let pull = -flight.acceleration().dot(normal);
        let hop_time = if is_pressed { self.system.hop_times[ball.ball] } else { S::ZERO };
        let hop_speed = pull * hop_time * S::from_f64(0.5);
        let round_off = threshold(&[*ball]) * S::from_f64(4.0);
        let least = if hop_speed > round_off { hop_speed } else { round_off };
        let lacking = least - flight.velocity_after(S::ZERO).dot(normal);
        (lacking > S::ZERO).then_some(lacking)
    }

    /// A ball at the nose of a cushion.
    fn hit(&self, ball: usize, cushion: u32, position: Vec3<S>, twist: Twist<S>) -> CushionHit<S> {
        let Ball { flight, sphere, .. } = self.balls[ball];
        let (normal, _) = self.system.faces[cushion as usize].normal_at(position.plan());
        let is_airborne = flight.motion == Motion::Airborne;
        let nose = &self.system.noses[ball];
        let sin = if is_airborne { (nose.height - position.z) / sphere.radius } else { nose.sin };
        let sin = if sin > S::ONE {
            S::ONE
        } else if sin < -S::ONE {
            -S::ONE
        } else {
            sin
        };
        let cos = if is_airborne { (S::ONE - sin.squared()).sqrt() } else { nose.cos };
        CushionHit { sphere, normal, sin, cos, twist, is_airborne }
    }
}

/// What becomes of a ball that parts from a cushion by so much faster, with a hop too low to see, which is paid for by all
/// its motion.
fn hop<S: Scalar>(hit: &CushionHit<S>, twist: Twist<S>, speed: S) -> Twist<S> {
    let velocity = twist.velocity + hit.closing_normal() * speed;
    let mut twists = [Twist { velocity, ..twist }];
    let (before, after) = (hit.sphere.kinetic_energy(&twist), hit.sphere.kinetic_energy(&twists[0]));
    pay(&mut twists, before, after);
    twists[0]
}
