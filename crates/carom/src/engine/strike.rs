//! A contact of two: a ball with a cushion, or with another ball.
//!
//! The two get their new velocities and predictions first. Only if these find a third thing in touch is the contact
//! undone and the whole cluster resolved instead.

use super::cluster::Struck;
use super::discs::Discs;
use super::queue::Target;
use crate::detect::cushion_gap;
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::law::ball_ball::Pair;
use crate::law::ball_cushion::Rebound;
use crate::model::closing_threshold;
use crate::run::{Event, Kind, Observer};
use crate::scalar::Scalar;

impl<S: Scalar> Discs<S> {
    /// A ball meets a cushion.
    #[inline]
    pub(super) fn strike_cushion<const PLAIN: bool>(
        &mut self,
        ball: usize,
        cushion: u32,
        time: S,
        offset: S,
        observer: &mut impl Observer<S>,
    ) {
        let flight = self.balls[ball].flight;
        let State { position, velocity } = flight.state_after(offset);
        let disc = self.balls[ball].disc;
        let (normal, scale) = self.system.faces.all[cushion as usize].normal_at(position);
        let mut rebound = self.cushion_law(ball, cushion, time).rebound(velocity, normal, scale);
        // A ball pulled onto a cushion may meet it without closing; such a contact does nothing.
        let closes =
            PLAIN || !self.has_field || -rebound.normal_velocity > closing_threshold(velocity, Vec2::ZERO);
        if !closes {
            rebound = Rebound { velocity, energy_loss: S::ZERO, ..rebound };
        }
        let held_by = if PLAIN { [None; 2] } else { self.balls[ball].track.held_by };
        self.begin_flight::<PLAIN>(ball, time, State { position, velocity: rebound.velocity });
        if !PLAIN {
            self.balls[ball].track.last_cushion = Some(cushion);
            self.note_arrival(ball, offset, velocity);
        }
        if self.predict::<PLAIN>(ball, Target::Cushion(cushion)) || held_by[0].is_some() {
            self.strike_cluster(&[Struck { ball, flight, held_by, elapsed: offset }], time, observer);
            return;
        }
        self.note_contact(ball, time);
        let half_mass = S::from_f64(0.5) * disc.mass;
        let change = half_mass * (rebound.velocity.norm_squared() - velocity.norm_squared());
        self.diagnostics.account(change.to_f64(), (disc.mass * rebound.energy_loss).to_f64());
        let event = Event {
            time,
            kind: Kind::BallCushion,
            ball_a: ball as u32,
            ball_b: None,
            cushion: Some(cushion),
            point: self.system.faces.all[cushion as usize].foot(position),
            normal,
            closing_speed: -rebound.normal_velocity,
            impulse: (rebound.velocity - velocity).dot(normal) * scale * disc.mass,
            cluster: None,
        };
        if closes {
            self.emit(&event, observer);
        }
        if !PLAIN && self.settle(ball, &[cushion], held_by, observer) {
            self.predict::<PLAIN>(ball, Target::Cushion(cushion));
        }
        observer.flight(ball, &self.balls[ball].flight);
    }

    /// Two balls meet.
    pub(super) fn strike_ball<const PLAIN: bool>(
        &mut self,
        ball: usize,
        other: usize,
        time: S,
        offset: S,
        observer: &mut impl Observer<S>,
    ) {
        let (a, b) = if ball < other { (ball, other) } else { (other, ball) };
        let flights = [self.balls[a].flight, self.balls[b].flight];
        let start = if flights[0].start > flights[1].start { flights[0].start } else { flights[1].start };
        let [before_a, before_b] = flights.map(|f| state_after(&f, start, offset));
        let (position_a, velocity_a) = (before_a.position, before_a.velocity);
        let (position_b, velocity_b) = (before_b.position, before_b.velocity);
        let discs = [self.balls[a].disc, self.balls[b].disc];
        let separation = position_b - position_a;
        self.audit_distance(a, separation.norm(), discs[0].radius + discs[1].radius);
        let pair = Pair::new([&discs[0], &discs[1]], separation, [velocity_a, velocity_b]);
        let law = self.ball_law(a, b, pair.closing_speed, time);
        let impulse = law.impulse(&pair);
        let after_a = velocity_a - pair.normal * (impulse * discs[0].inverse_mass);
        let after_b = velocity_b + pair.normal * (impulse * discs[1].inverse_mass);
        let held_by = if PLAIN { [[None; 2]; 2] } else { [a, b].map(|ball| self.balls[ball].track.held_by) };
        self.begin_flight::<PLAIN>(a, time, State { position: position_a, velocity: after_a });
        self.begin_flight::<PLAIN>(b, time, State { position: position_b, velocity: after_b });
        if !PLAIN {
            self.forget_left_cushion(a);
            self.forget_left_cushion(b);
        }
        let touching_a = self.predict::<PLAIN>(a, Target::Ball(b as u32, 0));
        let touching_b = self.predict::<PLAIN>(b, Target::Ball(a as u32, 0));
        if touching_a || touching_b || held_by[0][0].is_some() || held_by[1][0].is_some() {
            let struck = |k: usize, ball| {
                let (flight, held_by) = (flights[k], held_by[k]);
                Struck { ball, flight, held_by, elapsed: start - flight.start + offset }
            };
            self.strike_cluster(&[struck(0, a), struck(1, b)], time, observer);
            return;
        }
        self.note_contact(a, time);
        self.note_contact(b, time);
        self.account_pair(
            &discs.map(|d| d.mass),
            [velocity_a, velocity_b],
            [after_a, after_b],
            law.energy_loss(&pair),
        );
        let event = Event {
            time,
            kind: Kind::BallBall,
            ball_a: a as u32,
            ball_b: Some(b as u32),
            cushion: None,
            point: position_a + pair.normal * discs[0].radius,
            normal: pair.normal,
            closing_speed: pair.closing_speed,
            impulse,
            cluster: None,
        };
        self.emit(&event, observer);
        observer.flight(a, &self.balls[a].flight);
        observer.flight(b, &self.balls[b].flight);
    }

    /// Notes the velocity with which a ball came to a place, unless it has been there since its last contact.
    pub(super) fn note_arrival(&mut self, ball: usize, elapsed: S, velocity: Vec2<S>) {
        if !self.system.has_backs {
            return;
        }
        let arrival = &mut self.balls[ball].track.arrival;
        if elapsed > S::ZERO || *arrival == Vec2::ZERO {
            *arrival = velocity;
        }
    }

    /// Forgets the cushion that a point touched last, once it has left it.
    pub(super) fn forget_left_cushion(&mut self, ball: usize) {
        let radius = self.balls[ball].disc.radius;
        if radius > S::ZERO || !self.system.has_backs {
            return;
        }
        if let Some(cushion) = self.balls[ball].track.last_cushion {
            let tolerance = &self.system.tolerance;
            let cushion = &self.system.faces.all[cushion as usize];
            let gap = cushion_gap(self.balls[ball].flight.position, radius, cushion, tolerance);
            if !gap.is_some_and(|gap| gap.abs() <= tolerance.of(radius)) {
                self.balls[ball].track.last_cushion = None;
                self.balls[ball].track.arrival = Vec2::ZERO;
            }
        }
    }

    fn account_pair(&mut self, masses: &[S; 2], before: [Vec2<S>; 2], after: [Vec2<S>; 2], loss: S) {
        let mut change = S::ZERO;
        let mut momentum = Vec2::ZERO;
        for k in 0..2 {
            change += masses[k] * (after[k].norm_squared() - before[k].norm_squared());
            momentum = momentum + (after[k] - before[k]) * masses[k];
        }
        self.diagnostics.account((change * S::from_f64(0.5)).to_f64(), loss.to_f64());
        let error = momentum.x.abs() + momentum.y.abs();
        self.diagnostics.momentum_error = self.diagnostics.momentum_error.max(error.to_f64());
    }
}

/// Position and velocity an `offset` after `start`, which is not before the flight's own start.
#[inline(always)]
fn state_after<S: Scalar>(flight: &Flight<S>, start: S, offset: S) -> State<S> {
    let State { position, velocity } = flight.state_after(start - flight.start);
    Flight { start, position, velocity, acceleration: flight.acceleration }.state_after(offset)
}
