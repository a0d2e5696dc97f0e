//! A ball meets a cushion.

use super::contact::{pay, threshold};
use super::ending::Cause;
use super::{Ball, Spheres};
use crate::flight::Motion;
use crate::geometry::{Vec2, Vec3};
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
        let kept_speed = self.kept_speed(ball, None);
        let after = if closing_speed > threshold(&[present], kept_speed) {
            let law = &self.system.cushion_laws[cushion as usize];
            let restitution = restitution_keeping(law.restitution(closing_speed), kept_speed, closing_speed);
            law.rebound(&hit, restitution)
        } else {
            hop(&hit, kept_speed + closing_speed)
        };
        let flight = self.flight_after(ball, time, present.position, &hit.twist, after, Cause::Cushion);
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

/// What becomes of a ball that is pressed against a cushion without closing: it parts with a hop too low to see, paid for
/// by all its motion.
fn hop<S: Scalar>(hit: &CushionHit<S>, speed: S) -> Twist<S> {
    let push = hit.normal * speed;
    let velocity = hit.twist.velocity + Vec3::above(Vec2::new(push.x, push.y), S::ZERO);
    let mut twists = [Twist { velocity, ..hit.twist }];
    let (before, after) = (hit.sphere.kinetic_energy(&hit.twist), hit.sphere.kinetic_energy(&twists[0]));
    pay(&mut twists, before, after);
    twists[0]
}
