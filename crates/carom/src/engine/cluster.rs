//! Several contacts at one instant: gathers the cluster, lets its law act, and starts the new flights.

use super::discs::{Discs, Target};
use crate::detect::cushion_gap;
use crate::geometry::Vec2;
use crate::law::cluster::{Body, Passes, Touch, resolve_pairwise, resolve_reflections};
use crate::model::closing_threshold;
use crate::run::{Event, Kind, Observer};
use crate::scalar::Scalar;
use crate::scenario::schema::Cluster;

/// Between balls of one cluster, a gap up to this many contact tolerances counts as a contact: so a ball aimed at the
/// middle of a touching pair, and off by a hair, still strikes both at once.
const HAIR: f64 = 1e4;

/// Cushion contacts allowed at a corner before the ball is stopped against all of them.
const CORNER_LIMIT: usize = 16;

/// A ball of the cluster at the instant.
struct Member<S> {
    ball: usize,
    position: Vec2<S>,
    before: Vec2<S>,
    velocity: Vec2<S>,
}

/// A contact of the cluster with what the event log says of it.
struct Contact<S> {
    /// Members, by place in the member list; the second is `None` for a cushion.
    members: (usize, Option<usize>),
    cushion: Option<u32>,
    point: Vec2<S>,
    /// From the first member to the second, or into the cushion.
    normal: Vec2<S>,
}

impl<S: Scalar> Discs<S> {
    /// Resolves everything in touch with the balls `struck` (ball, position, velocity) at the given time.
    #[cold]
    pub(super) fn strike_cluster(
        &mut self,
        struck: &[(usize, Vec2<S>, Vec2<S>)],
        time: S,
        observer: &mut impl Observer<S>,
    ) {
        let mut members = self.gather(struck, time);
        let contacts = self.contacts(&members);
        self.diagnostics.clusters += 1;
        let events = if members.len() == 1 {
            self.resolve_corner(&mut members[0], &contacts, time)
        } else {
            self.resolve_contacts(&mut members, &contacts, time)
        };
        self.account_cluster(&members);
        for event in &events {
            self.emit(event, observer);
        }
        self.start_flights(struck, &members, &contacts, time, observer);
    }

    /// The balls that touch each other or the struck ones, in order of place.
    fn gather(&self, struck: &[(usize, Vec2<S>, Vec2<S>)], time: S) -> Vec<Member<S>> {
        let member = |&(ball, position, velocity): &(usize, Vec2<S>, Vec2<S>)| Member {
            ball,
            position,
            before: velocity,
            velocity,
        };
        let mut members: Vec<Member<S>> = struck.iter().map(member).collect();
        let mut next = 0;
        while next < members.len() {
            for ball in 0..self.flights.len() {
                if members.iter().any(|m| m.ball == ball) {
                    continue;
                }
                let flight = &self.flights[ball];
                let elapsed = time - flight.start;
                let position = flight.position_after(elapsed);
                if self.ball_gap(members[next].ball, members[next].position, ball, position) <= S::ONE {
                    members.push(member(&(ball, position, flight.velocity_after(elapsed))));
                }
            }
            next += 1;
        }
        members.sort_by(|a, b| by_place(a.position, b.position));
        members
    }

    /// The gap between two balls in contact tolerances; infinite for two points.
    fn ball_gap(&self, a: usize, position_a: Vec2<S>, b: usize, position_b: Vec2<S>) -> S {
        let radii = self.system.discs[a].radius + self.system.discs[b].radius;
        if radii == S::ZERO {
            return S::INFINITY;
        }
        ((position_b - position_a).norm() - radii) / self.system.tolerance.of(radii)
    }

    /// All contacts of the members, in order of place.
    fn contacts(&self, members: &[Member<S>]) -> Vec<Contact<S>> {
        let mut contacts = Vec::new();
        for (first, a) in members.iter().enumerate() {
            for (second, b) in members.iter().enumerate().skip(first + 1) {
                if self.ball_gap(a.ball, a.position, b.ball, b.position) <= S::from_f64(HAIR) {
                    let normal = (b.position - a.position).unit();
                    let point = a.position + normal * self.system.discs[a.ball].radius;
                    contacts.push(Contact { members: (first, Some(second)), cushion: None, point, normal });
                }
            }
            self.add_cushions(first, a, &mut contacts);
        }
        contacts.sort_by(|a, b| by_place(a.point, b.point).then(by_place(a.normal, b.normal)));
        contacts
    }

    fn add_cushions(&self, place: usize, member: &Member<S>, contacts: &mut Vec<Contact<S>>) {
        let radius = self.system.discs[member.ball].radius;
        let tolerance = self.system.tolerance.of(radius);
        let first = contacts.len();
        for (number, cushion) in self.system.faces.all.iter().enumerate() {
            let Some(gap) = cushion_gap(member.position, radius, cushion, &self.system.tolerance) else {
                continue;
            };
            if gap.abs() > tolerance || self.is_behind(member.ball, number as u32) {
                continue;
            }
            let normal = -cushion.normal_at(member.position).0;
            // Where two pieces of one smooth boundary meet, the ball touches once.
            if contacts[first..].iter().any(|c| is_same_direction(c.normal, normal)) {
                continue;
            }
            let point = cushion.foot(member.position);
            contacts.push(Contact { members: (place, None), cushion: Some(number as u32), point, normal });
        }
    }

    /// One ball against several cushions: each cushion's law acts in turn, the most strongly closing first.
    fn resolve_corner(&mut self, member: &mut Member<S>, contacts: &[Contact<S>], time: S) -> Vec<Event<S>> {
        let mut events = Vec::new();
        for _ in 0..CORNER_LIMIT {
            let threshold = closing_threshold(member.velocity, Vec2::ZERO);
            let speed = |c: &Contact<S>| member.velocity.dot(c.normal);
            let strongest = contacts
                .iter()
                .filter(|c| speed(c) > threshold)
                .reduce(|best, c| if speed(c) > speed(best) { c } else { best });
            let Some(contact) = strongest else { return events };
            let Some(cushion) = contact.cushion else { return events };
            let (normal, scale) = self.system.faces.all[cushion as usize].normal_at(member.position);
            let rebound =
                self.cushion_law(member.ball, cushion, time).rebound(member.velocity, normal, scale);
            let mass = self.system.discs[member.ball].mass;
            let impulse = (rebound.velocity - member.velocity).dot(normal) * scale * mass;
            let closing_speed = -rebound.normal_velocity;
            member.velocity = rebound.velocity;
            events.push(self.row(contact, std::slice::from_ref(member), time, closing_speed, impulse));
        }
        self.diagnostics.forced_clusters += 1;
        member.velocity = Vec2::ZERO;
        events
    }

    /// Several balls: the cluster law gives the normal impulses, each cushion then adds its tangential part.
    fn resolve_contacts(
        &mut self,
        members: &mut [Member<S>],
        contacts: &[Contact<S>],
        time: S,
    ) -> Vec<Event<S>> {
        let mut bodies: Vec<Body<S>> = members
            .iter()
            .map(|m| Body { velocity: m.velocity, inverse_mass: self.system.discs[m.ball].inverse_mass })
            .collect();
        let mut touches: Vec<Touch<S>> = contacts.iter().map(|c| self.touch(c, members, time)).collect();
        self.resolve_normal(&mut bodies, &mut touches);
        if self.scale_tangential(&mut bodies, &touches, contacts, members, time) {
            self.resolve_normal(&mut bodies, &mut touches);
        }
        for (member, body) in members.iter_mut().zip(&bodies) {
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

    fn resolve_normal(&mut self, bodies: &mut [Body<S>], touches: &mut [Touch<S>]) {
        let Passes { count, forced } = match self.system.cluster {
            Cluster::Reflections => resolve_reflections(bodies, touches),
            Cluster::Pairwise => resolve_pairwise(bodies, touches),
        };
        self.diagnostics.cluster_passes += u64::from(count);
        self.diagnostics.forced_clusters += u64::from(forced);
    }

    fn touch(&self, contact: &Contact<S>, members: &[Member<S>], time: S) -> Touch<S> {
        let ball = members[contact.members.0].ball;
        let restitution = match (contact.members.1, contact.cushion) {
            (Some(other), _) => self.ball_law(ball, members[other].ball, time).normal,
            (None, Some(cushion)) => self.cushion_law(ball, cushion, time).normal,
            (None, None) => S::ONE,
        };
        Touch::new(contact.members.0, contact.members.1, contact.normal, restitution)
    }

    /// Applies the tangential factors of the cushions that were hit; says whether any velocity changed.
    fn scale_tangential(
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
            if law.tangential != S::ONE {
                let (normal, scale) = self.system.faces.all[cushion as usize].normal_at(member.position);
                let body = &mut bodies[contact.members.0];
                body.velocity = law.scale_tangential(body.velocity, normal, scale);
                changed = true;
            }
        }
        changed
    }

    fn row(
        &self,
        contact: &Contact<S>,
        members: &[Member<S>],
        time: S,
        closing_speed: S,
        impulse: S,
    ) -> Event<S> {
        let ball = members[contact.members.0].ball as u32;
        let other = contact.members.1.map(|b| members[b].ball as u32);
        let swapped = other.is_some_and(|other| other < ball);
        Event {
            time,
            kind: if other.is_some() { Kind::BallBall } else { Kind::BallCushion },
            ball_a: if swapped { other.unwrap_or(ball) } else { ball },
            ball_b: if swapped { Some(ball) } else { other },
            cushion: contact.cushion,
            point: contact.point,
            normal: if swapped || other.is_none() { -contact.normal } else { contact.normal },
            closing_speed,
            impulse,
            cluster: Some(self.diagnostics.clusters as u32),
        }
    }

    fn account_cluster(&mut self, members: &[Member<S>]) {
        let mut change = S::ZERO;
        for member in members {
            let mass = self.system.discs[member.ball].mass;
            change += mass * (member.velocity.norm_squared() - member.before.norm_squared());
        }
        let change = (change * S::from_f64(0.5)).to_f64();
        if change > 0.0 {
            self.diagnostics.energy_gain = self.diagnostics.energy_gain.max(change);
        }
        self.diagnostics.energy_loss -= change;
    }

    /// Starts the flights of the struck balls and of those whose velocity changed, and tells the observer.
    fn start_flights(
        &mut self,
        struck: &[(usize, Vec2<S>, Vec2<S>)],
        members: &[Member<S>],
        contacts: &[Contact<S>],
        time: S,
        observer: &mut impl Observer<S>,
    ) {
        let is_struck = |ball| struck.iter().any(|s| s.0 == ball);
        let moved = |k: &usize| members[*k].velocity != members[*k].before || is_struck(members[*k].ball);
        let moved: Vec<usize> = (0..members.len()).filter(moved).collect();
        for &k in &moved {
            let member = &members[k];
            self.begin_flight(member.ball, time, member.position, member.velocity);
            self.note_contact(member.ball, time);
            let cushions: Vec<u32> =
                contacts.iter().filter(|c| c.members.0 == k).filter_map(|c| c.cushion).collect();
            if let Some(&cushion) = cushions.first() {
                self.tracks[member.ball].last_cushion = Some(cushion);
            }
            self.settle(member.ball, &cushions, observer);
            observer.flight(member.ball, &self.flights[member.ball]);
        }
        for &k in &moved {
            self.predict(members[k].ball, Target::Nothing);
        }
    }
}

fn by_place<S: Scalar>(a: Vec2<S>, b: Vec2<S>) -> core::cmp::Ordering {
    let key = |v: Vec2<S>| (v.x, v.y);
    key(a).partial_cmp(&key(b)).unwrap_or(core::cmp::Ordering::Equal)
}

fn is_same_direction<S: Scalar>(a: Vec2<S>, b: Vec2<S>) -> bool {
    a.dot(b) > S::ZERO && a.cross(b).abs() < S::from_f64(1e-9)
}
