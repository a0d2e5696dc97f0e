//! Several contacts at one instant: gathers the cluster, lets its law act, and starts the new flights.

mod contacts;
mod corner;
mod members;
mod several;

use super::discs::Discs;
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::run::{Event, Kind, Observer};
use crate::scalar::Scalar;
use crate::scenario::System;

/// A ball whose contact turned out to be one of several.
#[derive(Clone, Copy)]
pub(super) struct Struck<S> {
    pub(super) ball: usize,
    /// The flight that ends with the contact.
    pub(super) flight: Flight<S>,
    /// How often the ball went round each periodic axis on it.
    pub(super) rounds: [i16; 2],
    /// The cushions that held the ball on it.
    pub(super) held_by: [Option<u32>; 2],
    /// The time from the start of the flight to the contact.
    pub(super) elapsed: S,
}

/// A ball of the cluster at the instant.
struct Member<S> {
    ball: usize,
    /// The flight that brought it here.
    flight: Flight<S>,
    /// How often it went round each periodic axis on that flight.
    rounds: [i16; 2],
    /// The cushions that held it on that flight.
    held_by: [Option<u32>; 2],
    /// The time since the flight's start.
    elapsed: S,
    position: Vec2<S>,
    /// Its velocity when the cluster is struck.
    before: Vec2<S>,
    /// Its velocity now.
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
        let forced = self.diagnostics.forced_clusters;
        let events = if members.len() == 1 {
            self.resolve_corner(&mut members[0], &contacts, time)
        } else {
            self.resolve_contacts(&mut members, &contacts, time)
        };
        // Where nothing closes, nothing happened.
        self.diagnostics.clusters += u64::from(!events.is_empty());
        self.account_cluster(&members, &contacts, self.diagnostics.forced_clusters > forced);
        let moved = self.start_flights(struck, &members, &contacts, time);
        for event in &events {
            self.emit(event, observer);
        }
        self.settle_members(&moved, &members, &contacts, observer);
        for &k in &moved {
            self.predict(members[k].ball);
        }
    }

    /// Accounts for what the cluster did to energy and momentum. Between several balls laws that lose nothing are held to
    /// it; what lossy ones take no formula says, nor what a ball loses that has no room to bounce.
    fn account_cluster(&mut self, members: &[Member<S>], contacts: &[Contact<S>], is_forced: bool) {
        let mut change = S::ZERO;
        let mut momentum = Vec2::ZERO;
        for member in members {
            let mass = self.disc(member.ball).mass;
            change += mass * (member.velocity.norm_squared() - member.before.norm_squared());
            momentum = momentum + (member.velocity - member.before) * mass;
        }
        let change = (change * S::from_f64(0.5)).to_f64();
        if change > 0.0 {
            self.diagnostics.energy_gain = self.diagnostics.energy_gain.max(change);
        }
        let is_lossless = members.len() > 1 && self.system.is_lossless && !is_forced;
        let loss = if is_lossless { 0.0 } else { -change };
        self.diagnostics.account(change, loss);
        if contacts.iter().all(|contact| contact.cushion.is_none()) {
            let error = momentum.x.abs() + momentum.y.abs();
            self.diagnostics.momentum_error = self.diagnostics.momentum_error.max(error.to_f64());
        }
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
            self.begin_flight(member.ball, self.free_flight(time, member.after()));
            self.note_contact(member.ball, time);
            self.forget_left_cushion(member.ball);
            if let Some(cushion) = cushions_of(k, contacts).next() {
                self.rest[member.ball].track.last_cushion = Some(cushion);
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
            observer.flight(ball, &self.seen_flight(ball));
        }
    }

    /// The row of the event log for a contact.
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
            cluster: Some(self.diagnostics.clusters as u32 + 1),
        }
    }
}

impl<S: Scalar> Member<S> {
    /// A ball where its flight has brought it; on a periodic table in its first image.
    fn new(system: &System<S>, Struck { ball, flight, rounds, held_by, elapsed }: Struck<S>) -> Self {
        let State { position, velocity } = flight.state_after(elapsed);
        let position = system.wrapped(position, rounds);
        Self { ball, flight, rounds, held_by, elapsed, position, before: velocity, velocity }
    }

    fn as_struck(&self, elapsed: S) -> Struck<S> {
        let Self { ball, flight, rounds, held_by, .. } = *self;
        Struck { ball, flight, rounds, held_by, elapsed }
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
