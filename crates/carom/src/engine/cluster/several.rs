//! Several balls that touch each other, and cushions.

use super::{Contact, Member};
use crate::engine::Discs;
use crate::law::ball_ball;
use crate::law::cluster::{
    Body, DiscLaw, Passes, Touch, effective_radius, resolve_hertz, resolve_pairwise, resolve_reflections,
};
use crate::run::Event;
use crate::scalar::Scalar;
use crate::scenario::schema::Cluster;

impl<S: Scalar> Discs<S> {
    /// Several balls: the cluster law gives the normal impulses, each cushion then adds its tangential part.
    pub(super) fn resolve_contacts(
        &mut self,
        members: &mut [Member<S>],
        contacts: &[Contact<S>],
        time: S,
    ) -> Vec<Event<S>> {
        let mut bodies: Vec<Body<S>> =
            members.iter().map(|m| Body::new(m.velocity, self.disc(m.ball).inverse_mass)).collect();
        let mut touches: Vec<Touch<S>> = contacts.iter().map(|c| self.touch(c, members, time)).collect();
        self.resolve_normal(&mut bodies, &mut touches);
        if self.slide(&mut bodies, &touches, contacts, members, time) {
            self.resolve_normal(&mut bodies, &mut touches);
        }
        for (member, body) in members.iter_mut().zip(&mut bodies) {
            body.drop_round_off();
            member.velocity = body.velocity;
        }
        let mut events: Vec<Event<S>> = contacts
            .iter()
            .zip(&touches)
            .filter(|(_, touch)| touch.impulse > S::ZERO)
            .map(|(contact, touch)| self.row(contact, members, time, touch.closing_speed, touch.impulse))
            .collect();
        events.sort_by_key(|e| (e.ball_a, e.ball_b, e.cushion));
        events
    }

    /// Lets the cluster law act.
    fn resolve_normal(&mut self, bodies: &mut [Body<S>], touches: &mut [Touch<S>]) {
        let Passes { count, forced } = match self.system.cluster {
            Cluster::Reflections => resolve_reflections(bodies, touches),
            Cluster::Hertz => resolve_hertz(bodies, touches),
            Cluster::Pairwise => resolve_pairwise(bodies, touches),
        };
        self.diagnostics.cluster_passes += u64::from(count);
        self.diagnostics.forced_clusters += u64::from(forced);
    }

    /// What the law has to know of a contact.
    fn touch(&self, contact: &Contact<S>, members: &[Member<S>], time: S) -> Touch<S> {
        let (first, second) = contact.members;
        let (ball, other) = (members[first].ball, second.map(|second| members[second].ball));
        let law = match (other, contact.cushion) {
            (Some(other), _) => DiscLaw::Balls(self.ball_law(ball, other, time)),
            (None, Some(cushion)) => DiscLaw::Cushion(self.cushion_law(ball, cushion, time)),
            (None, None) => DiscLaw::Balls(ball_ball::Law::ELASTIC),
        };
        let kept_speed = self.kept_speed(ball, other);
        let radius = |ball: usize| self.balls[ball].radius;
        let effective_radius = effective_radius(radius(ball), other.map(radius));
        Touch { kept_speed, effective_radius, ..Touch::new(first, second, contact.normal, law) }
    }

    /// Lets the laws of the cushions that were hit act along them; says whether any velocity changed.
    fn slide(
        &self,
        bodies: &mut [Body<S>],
        touches: &[Touch<S>],
        contacts: &[Contact<S>],
        members: &[Member<S>],
        time: S,
    ) -> bool {
        let mut changed = false;
        for (contact, touch) in contacts.iter().zip(touches) {
            let Some(cushion) = contact.cushion.filter(|_| touch.impulse > S::ZERO) else { continue };
            let member = &members[contact.members.0];
            let law = self.cushion_law(member.ball, cushion, time);
            let normal = self.system.faces.all[cushion as usize].normal_at(member.position);
            let body = &mut bodies[contact.members.0];
            if let Some(velocity) = law.slide(body.velocity, normal) {
                body.turn(velocity);
                changed = true;
            }
        }
        changed
    }
}
