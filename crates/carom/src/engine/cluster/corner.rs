//! One ball that touches several cushions.

use super::{Contact, Member, is_same_direction};
use crate::engine::Discs;
use crate::geometry::Vec2;
use crate::law::cluster::Body;
use crate::law::collapse::restitution_keeping;
use crate::run::Event;
use crate::scalar::Scalar;

/// Cushion contacts allowed at a corner before the ball is stopped against all of them. A ball that loses nothing leaves
/// a corner of angle α after π/α + 1 contacts at most.
const CORNER_LIMIT: usize = 1000;

impl<S: Scalar> Discs<S> {
    /// One ball against several cushions: each cushion's law acts in turn, the most strongly closing first.
    ///
    /// A ball that loses speed may never leave a narrow corner: once it parts from a cushion in the same direction as the
    /// last time, only slower, this goes on for ever, and it rests. Between two cushions that face each other it has no
    /// room to bounce.
    pub(super) fn resolve_corner(
        &mut self,
        member: &mut Member<S>,
        contacts: &[Contact<S>],
        time: S,
    ) -> Vec<Event<S>> {
        let mut events = Vec::new();
        let mut body = Body::new(member.velocity, S::ONE);
        let mut parting = vec![Vec2::ZERO; contacts.len()];
        for _ in 0..CORNER_LIMIT {
            let Some(place) = strongest(&body, contacts) else { return events };
            let contact = &contacts[place];
            let Some(cushion) = contact.cushion else { return events };
            let law = self.cushion_law(member.ball, cushion, time);
            let speed = body.velocity.dot(contact.normal);
            let has_room = !contacts.iter().any(|c| is_same_direction(c.normal, -contact.normal));
            let restitution = if has_room {
                restitution_keeping(law.restitution(speed), self.kept_speed(member.ball, None), speed)
            } else {
                S::ZERO
            };
            let (normal, scale) = self.system.faces.all[cushion as usize].normal_at(member.position);
            let rebound = law.rebound(body.velocity, (normal, scale), restitution);
            let mass = self.disc(member.ball).mass;
            let impulse = (rebound.velocity - body.velocity).dot(normal) * scale * mass;
            let closing_speed = -rebound.normal_velocity;
            body.turn(rebound.velocity);
            body.drop_round_off();
            member.velocity = body.velocity;
            events.push(self.row(contact, std::slice::from_ref(member), time, closing_speed, impulse));
            let before = core::mem::replace(&mut parting[place], member.velocity);
            if is_slower_same(before, member.velocity) {
                member.velocity = Vec2::ZERO;
                return events;
            }
        }
        self.diagnostics.forced_clusters += 1;
        member.velocity = Vec2::ZERO;
        events
    }
}

/// The contact at which a ball moves fastest into the cushion, if at any.
fn strongest<S: Scalar>(body: &Body<S>, contacts: &[Contact<S>]) -> Option<usize> {
    let speed = |k: usize| body.velocity.dot(contacts[k].normal);
    (0..contacts.len())
        .filter(|&k| speed(k) > body.threshold())
        .reduce(|best, k| if speed(k) > speed(best) { k } else { best })
}

/// Whether the second velocity has the direction of the first and is smaller.
fn is_slower_same<S: Scalar>(before: Vec2<S>, after: Vec2<S>) -> bool {
    after.norm_squared() < before.norm_squared() && is_same_direction(before, after)
}
