//! Several contacts at one instant: gathers the cluster, lets its law act, and starts the new flights.

use super::discs::Discs;
use crate::detect::{Surroundings, cushion_gap, detect_ball_ball, detect_ball_cushion};
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::law::cluster::{Body, Passes, Touch, resolve_pairwise, resolve_reflections};
use crate::model::Face;
use crate::run::{Event, Kind, Observer};
use crate::scalar::Scalar;
use crate::scenario::schema::Cluster;

/// Between balls of one cluster, a gap up to this many contact tolerances counts as a contact: so a ball aimed at the
/// middle of a touching pair, and off by a hair, still strikes both at once.
const HAIR: f64 = 1e4;

/// Cushion contacts allowed at a corner before the ball is stopped against all of them. A ball that loses nothing leaves
/// a corner of angle α after π/α + 1 contacts at most.
const CORNER_LIMIT: usize = 1000;

/// A ball whose contact turned out to be one of several.
pub(super) struct Struck<S> {
    pub(super) ball: usize,
    /// The flight that ends with the contact.
    pub(super) flight: Flight<S>,
    /// The cushions that held the ball on it.
    pub(super) held_by: [Option<u32>; 2],
    /// The time from the start of the flight to the contact.
    pub(super) elapsed: S,
}

/// A ball of the cluster at the instant.
struct Member<S> {
    ball: usize,
    flight: Flight<S>,
    held_by: [Option<u32>; 2],
    elapsed: S,
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
    /// Resolves everything in touch with the balls `struck` at the given time.
    #[cold]
    pub(super) fn strike_cluster(&mut self, struck: &[Struck<S>], time: S, observer: &mut impl Observer<S>) {
        let mut members = self.gather(struck, time);
        self.place(&mut members, time);
        let contacts = self.contacts(&members);
        self.diagnostics.clusters += 1;
        let events = if members.len() == 1 {
            self.resolve_corner(&mut members[0], &contacts, time)
        } else {
            self.resolve_contacts(&mut members, &contacts, time)
        };
        self.account_cluster(&members);
        let moved = self.start_flights(struck, &members, &contacts, time);
        for event in &events {
            self.emit(event, observer);
        }
        self.settle_members(&moved, &members, &contacts, observer);
        for &k in &moved {
            self.predict_anew(members[k].ball);
        }
    }

    /// The balls that touch each other or the struck ones.
    fn gather(&self, struck: &[Struck<S>], time: S) -> Vec<Member<S>> {
        let mut members: Vec<Member<S>> =
            struck.iter().map(|s| Member::new(s.ball, s.flight, s.held_by, s.elapsed)).collect();
        let mut next = 0;
        while next < members.len() {
            for ball in 0..self.balls.len() {
                if members.iter().any(|m| m.ball == ball) {
                    continue;
                }
                let (flight, held_by) = (self.balls[ball].flight, self.balls[ball].track.held_by);
                let member = Member::new(ball, flight, held_by, time - flight.start);
                if self.ball_gap(members[next].ball, members[next].position, ball, member.position) <= S::ONE
                {
                    members.push(member);
                }
            }
            next += 1;
        }
        members
    }

    /// Puts the members where their contacts are, and in order of place.
    ///
    /// A contact's own offset is not rounded as the time is. Where several contacts come at this very time, a ball takes
    /// the least of their offsets, so that it does not matter which of them was struck.
    fn place(&self, members: &mut [Member<S>], time: S) {
        let elapsed: Vec<S> = members
            .iter()
            .map(|member| {
                let others = members.iter().filter_map(|other| self.meeting(member, other, time));
                let cushions = self.system.faces.all.iter().enumerate();
                let cushions = cushions.filter_map(|(k, face)| self.cushion_meeting(member, k, face, time));
                others.chain(cushions).reduce(|a, b| if b < a { b } else { a }).unwrap_or(member.elapsed)
            })
            .collect();
        for (member, elapsed) in members.iter_mut().zip(elapsed) {
            *member = Member::new(member.ball, member.flight, member.held_by, elapsed);
        }
        members.sort_by(|a, b| by_place(a.position, b.position));
    }

    /// The time from the start of a member's flight to its contact with another, if that comes at `time`.
    fn meeting(&self, member: &Member<S>, other: &Member<S>, time: S) -> Option<S> {
        let radii = self.balls[member.ball].disc.radius + self.balls[other.ball].disc.radius;
        if member.ball == other.ball || radii == S::ZERO {
            return None;
        }
        let (a, b) = (&member.flight, &other.flight);
        let start = if a.start > b.start { a.start } else { b.start };
        let (tolerance, mut seen) = (&self.system.tolerance, Surroundings::CLEAR);
        let offset = detect_ball_ball(a, b, radii, tolerance, false, &mut seen)?;
        (start + offset == time).then_some(start - a.start + offset)
    }

    /// The same for a cushion.
    fn cushion_meeting(&self, member: &Member<S>, number: usize, face: &Face<S>, time: S) -> Option<S> {
        if member.held_by.contains(&Some(number as u32)) {
            return None;
        }
        let radius = self.balls[member.ball].disc.radius;
        let (tolerance, mut seen) = (self.system.tolerance.of(radius), Surroundings::CLEAR);
        let offset = detect_ball_cushion(&member.flight, radius, face, tolerance, false, &mut seen)?;
        (member.flight.start + offset == time).then_some(offset)
    }

    /// The gap between two balls in contact tolerances; infinite for two points.
    fn ball_gap(&self, a: usize, position_a: Vec2<S>, b: usize, position_b: Vec2<S>) -> S {
        let radii = self.balls[a].disc.radius + self.balls[b].disc.radius;
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
                    let point = a.position + normal * self.balls[a.ball].disc.radius;
                    contacts.push(Contact { members: (first, Some(second)), cushion: None, point, normal });
                }
            }
            self.add_cushions(first, a, &mut contacts);
        }
        contacts.sort_by(|a, b| by_place(a.point, b.point).then(by_place(a.normal, b.normal)));
        contacts
    }

    fn add_cushions(&self, place: usize, member: &Member<S>, contacts: &mut Vec<Contact<S>>) {
        let radius = self.balls[member.ball].disc.radius;
        let tolerance = self.system.tolerance.of(radius);
        let first = contacts.len();
        for (number, cushion) in self.system.faces.all.iter().enumerate() {
            let Some(gap) = cushion_gap(member.position, radius, cushion, &self.system.tolerance) else {
                continue;
            };
            if gap.abs() > tolerance || self.is_other_side(member, number as u32) {
                continue;
            }
            let normal = -cushion.normal_at(member.position).0;
            let point = cushion.foot(member.position);
            let contact = Contact { members: (place, None), cushion: Some(number as u32), point, normal };
            // Where two pieces of one smooth boundary meet, the ball touches once: the one that begins further left.
            match contacts[first..].iter_mut().find(|c| is_same_direction(c.normal, normal)) {
                Some(same) if self.begins_before(contact.cushion, same.cushion) => *same = contact,
                Some(_) => {}
                None => contacts.push(contact),
            }
        }
    }

    fn begins_before(&self, a: Option<u32>, b: Option<u32>) -> bool {
        let begin = |cushion: u32| match &self.system.faces.all[cushion as usize] {
            Face::Line(line) => line.start,
            Face::Round(round) => round.arc.center + round.arc.from * round.arc.radius,
        };
        matches!((a, b), (Some(a), Some(b)) if by_place(begin(a), begin(b)).is_lt())
    }

    /// Whether a cushion is the other face of a thin wall that a point is at, since the point came from across it.
    fn is_other_side(&self, member: &Member<S>, cushion: u32) -> bool {
        let back = self.system.backs[cushion as usize];
        if back.is_none() || self.balls[member.ball].disc.radius > S::ZERO {
            return false;
        }
        let track = &self.balls[member.ball].track;
        let has_stayed = member.elapsed == S::ZERO && track.arrival != Vec2::ZERO;
        let arrival = if has_stayed { track.arrival } else { member.before };
        (has_stayed && track.last_cushion == back) || self.is_across(cushion, arrival, member.position)
    }

    /// One ball against several cushions: each cushion's law acts in turn, the most strongly closing first.
    ///
    /// A ball that loses speed may never leave a narrow corner: once it parts from a cushion in the same direction as the
    /// last time, only slower, this goes on for ever, and it rests. Between two cushions that face each other it has no
    /// room to bounce.
    fn resolve_corner(&mut self, member: &mut Member<S>, contacts: &[Contact<S>], time: S) -> Vec<Event<S>> {
        let mut events = Vec::new();
        let mut body = Body::new(member.velocity, S::ONE);
        let mut parting = vec![Vec2::ZERO; contacts.len()];
        for _ in 0..CORNER_LIMIT {
            let speed = |c: &Contact<S>| body.velocity.dot(c.normal);
            let strongest = (0..contacts.len())
                .filter(|&k| speed(&contacts[k]) > body.threshold())
                .reduce(|best, k| if speed(&contacts[k]) > speed(&contacts[best]) { k } else { best });
            let Some(place) = strongest else { return events };
            let contact = &contacts[place];
            let Some(cushion) = contact.cushion else { return events };
            let mut law = self.cushion_law(member.ball, cushion, time);
            if contacts.iter().any(|c| is_same_direction(c.normal, -contact.normal)) {
                law.normal = S::ZERO;
            }
            let (normal, scale) = self.system.faces.all[cushion as usize].normal_at(member.position);
            let rebound = law.rebound(body.velocity, normal, scale);
            let mass = self.balls[member.ball].disc.mass;
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

    /// Several balls: the cluster law gives the normal impulses, each cushion then adds its tangential part.
    fn resolve_contacts(
        &mut self,
        members: &mut [Member<S>],
        contacts: &[Contact<S>],
        time: S,
    ) -> Vec<Event<S>> {
        let mut bodies: Vec<Body<S>> =
            members.iter().map(|m| Body::new(m.velocity, self.balls[m.ball].disc.inverse_mass)).collect();
        let mut touches: Vec<Touch<S>> = contacts.iter().map(|c| self.touch(c, members, time)).collect();
        self.resolve_normal(&mut bodies, &mut touches);
        if self.scale_tangential(&mut bodies, &touches, contacts, members, time) {
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

    fn resolve_normal(&mut self, bodies: &mut [Body<S>], touches: &mut [Touch<S>]) {
        let Passes { count, forced } = match self.system.cluster {
            Cluster::Reflections => resolve_reflections(bodies, touches),
            Cluster::Pairwise => resolve_pairwise(bodies, touches),
        };
        self.diagnostics.cluster_passes += u64::from(count);
        self.diagnostics.forced_clusters += u64::from(forced);
    }

    /// What the law has to know of a contact.
    fn touch(&self, contact: &Contact<S>, members: &[Member<S>], time: S) -> Touch<S> {
        let (first, second) = contact.members;
        let member = &members[first];
        let mut touch = Touch::new(first, second, contact.normal, S::ONE);
        if let Some(second) = second {
            let other = members[second].ball;
            touch.restitution = self.ball_law(member.ball, other, S::ZERO, time).normal;
            touch.kept_speed = self.kept_speed(member.ball, other);
        } else if let Some(cushion) = contact.cushion {
            touch.restitution = self.cushion_law(member.ball, cushion, time).normal;
            touch.is_held = self.system.collapse_is_elastic && member.held_by.contains(&Some(cushion));
        }
        touch
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
                body.turn(law.scale_tangential(body.velocity, normal, scale));
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
            let mass = self.balls[member.ball].disc.mass;
            change += mass * (member.velocity.norm_squared() - member.before.norm_squared());
        }
        let change = (change * S::from_f64(0.5)).to_f64();
        if change > 0.0 {
            self.diagnostics.energy_gain = self.diagnostics.energy_gain.max(change);
        }
        self.diagnostics.energy_loss -= change;
    }

    /// Starts the flights of the struck balls and of those whose velocity changed; gives their places among the members.
    fn start_flights(
        &mut self,
        struck: &[Struck<S>],
        members: &[Member<S>],
        contacts: &[Contact<S>],
        time: S,
    ) -> Vec<usize> {
        let is_struck = |ball| struck.iter().any(|s| s.ball == ball);
        let moved = |k: &usize| members[*k].velocity != members[*k].before || is_struck(members[*k].ball);
        let moved: Vec<usize> = (0..members.len()).filter(moved).collect();
        for &k in &moved {
            let member = &members[k];
            self.begin_flight::<false>(member.ball, time, member.after());
            self.note_contact(member.ball, time);
            self.forget_left_cushion(member.ball);
            if let Some(cushion) = cushions_of(k, contacts).next() {
                self.balls[member.ball].track.last_cushion = Some(cushion);
                self.note_arrival(member.ball, member.elapsed, member.before);
            }
        }
        moved
    }

    /// Holds those balls that come to lie on cushions, and tells the observer of all new flights.
    fn settle_members(
        &mut self,
        moved: &[usize],
        members: &[Member<S>],
        contacts: &[Contact<S>],
        observer: &mut impl Observer<S>,
    ) {
        for &k in moved {
            let cushions: Vec<u32> = cushions_of(k, contacts).collect();
            let ball = members[k].ball;
            self.settle(ball, &cushions, members[k].held_by, observer);
            observer.flight(ball, &self.balls[ball].flight);
        }
    }
}

impl<S: Scalar> Member<S> {
    fn new(ball: usize, flight: Flight<S>, held_by: [Option<u32>; 2], elapsed: S) -> Self {
        let State { position, velocity } = flight.state_after(elapsed);
        Self { ball, flight, held_by, elapsed, position, before: velocity, velocity }
    }

    fn after(&self) -> State<S> {
        State { position: self.position, velocity: self.velocity }
    }
}

/// The cushions among the contacts of a member.
fn cushions_of<S>(member: usize, contacts: &[Contact<S>]) -> impl Iterator<Item = u32> {
    contacts.iter().filter(move |c| c.members.0 == member).filter_map(|c| c.cushion)
}

fn by_place<S: Scalar>(a: Vec2<S>, b: Vec2<S>) -> core::cmp::Ordering {
    let key = |v: Vec2<S>| (v.x, v.y);
    key(a).partial_cmp(&key(b)).unwrap_or(core::cmp::Ordering::Equal)
}

fn is_same_direction<S: Scalar>(a: Vec2<S>, b: Vec2<S>) -> bool {
    let dot = a.dot(b);
    dot > S::ZERO && a.cross(b).abs() < dot * S::from_f64(1e-9)
}

/// Whether the second velocity has the direction of the first and is smaller.
fn is_slower_same<S: Scalar>(before: Vec2<S>, after: Vec2<S>) -> bool {
    after.norm_squared() < before.norm_squared() && is_same_direction(before, after)
}
