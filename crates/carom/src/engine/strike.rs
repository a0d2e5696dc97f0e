//! A contact of two: a ball with a cushion, or with another ball.
//!
//! Most contacts happen in the clear: the new flights touch nothing else, which their prediction finds out before anything
//! is changed. Otherwise the contact is made first, with all that fields and thin walls ask for; if the new predictions
//! then find a third thing in touch, it is undone and the whole cluster resolved instead.

use super::cluster::Struck;
use super::discs::Discs;
use super::queue::Target;
use crate::detect::cushion_gap;
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::law::ball_ball::{Impact, Pair};
use crate::law::ball_cushion::Rebound;
use crate::law::collapse::restitution_keeping;
use crate::model::{Disc, closing_threshold};
use crate::run::{Event, Kind, Observer};
use crate::scalar::Scalar;

/// A ball at a cushion, and what the cushion's law makes of it.
struct Bounce<S> {
    ball: usize,
    cushion: u32,
    time: S,
    mass: S,
    before: State<S>,
    point: Vec2<S>,
    normal: Vec2<S>,
    normal_scale: S,
    rebound: Rebound<S>,
}

/// Two balls in touch, and what their law makes of them.
struct Collision<S> {
    balls: [usize; 2],
    time: S,
    /// The later start of their flights.
    start: S,
    discs: [Disc<S>; 2],
    before: [State<S>; 2],
    pair: Pair<S>,
    impact: Impact<S>,
}

impl<S: Scalar> Discs<S> {
    /// A ball meets a cushion.
    #[inline(always)]
    pub(super) fn strike_cushion<const MANY: bool>(
        &mut self,
        ball: usize,
        cushion: u32,
        time: S,
        offset: S,
        observer: &mut impl Observer<S>,
    ) {
        let bounce = self.bounce::<MANY>(ball, cushion, time, offset);
        let flight = self.free_flight(time, bounce.after());
        if let Some(next) = self.next_on::<MANY>(ball, &flight, Target::Cushion(cushion)) {
            self.begin_flight_of::<MANY>(ball, flight);
            self.schedule_with::<MANY>(ball, next);
            self.note_bounce(&bounce);
            self.emit(&bounce.event(), observer);
            observer.flight(ball, &if MANY { self.seen_flight(ball) } else { flight });
        } else {
            self.strike_cushion_near(ball, cushion, time, offset, observer);
        }
    }

    #[inline(always)]
    pub(super) fn state_after(&self, flight: &Flight<S>, elapsed: S) -> State<S> {
        if self.is_plain { flight.straight_state_after(elapsed) } else { flight.state_after(elapsed) }
    }

    #[inline(always)]
    fn bounce<const MANY: bool>(&self, ball: usize, cushion: u32, time: S, offset: S) -> Bounce<S> {
        let mut before = self.state_after(&self.flight(ball), offset);
        if MANY {
            before.position = self.system.wrapped(before.position, self.balls[ball].rounds);
        }
        let face = &self.system.faces.all[cushion as usize];
        let (normal, normal_scale) = face.normal_at(before.position);
        let law = self.cushion_law(ball, cushion, time);
        let closing_speed = -before.velocity.dot(normal);
        let (own, kept_speed) = (law.restitution(closing_speed), self.kept_speed(ball, None));
        let restitution = restitution_keeping(own, kept_speed, closing_speed);
        let rebound = law.rebound(before.velocity, (normal, normal_scale), restitution);
        let (mass, point) = (self.disc(ball).mass, face.foot(before.position));
        Bounce { ball, cushion, time, mass, before, point, normal, normal_scale, rebound }
    }

    /// The same in a field, between thin walls, or with something else in touch.
    #[inline(never)]
    fn strike_cushion_near(
        &mut self,
        ball: usize,
        cushion: u32,
        time: S,
        offset: S,
        observer: &mut impl Observer<S>,
    ) {
        let mut bounce = self.bounce::<true>(ball, cushion, time, offset);
        let before = bounce.before;
        // A ball pulled onto a cushion may meet it without closing; such a contact does nothing.
        let closing_speed = -bounce.rebound.normal_velocity;
        let closes = !self.has_field || closing_speed > closing_threshold(before.velocity, Vec2::ZERO);
        if !closes {
            bounce.rebound = Rebound { velocity: before.velocity, energy_loss: S::ZERO, ..bounce.rebound };
        }
        let struck = self.struck(ball, offset);
        self.begin_flight(ball, self.free_flight(time, bounce.after()));
        self.rest[ball].track.last_cushion = Some(cushion);
        self.note_arrival(ball, offset, before.velocity);
        if self.predict_near(ball, Target::Cushion(cushion)) || struck.held_by[0].is_some() {
            self.strike_cluster(&[struck], time, observer);
            return;
        }
        self.note_bounce(&bounce);
        if closes {
            self.emit(&bounce.event(), observer);
        }
        if self.settle(ball, &[cushion], struck.held_by, observer) {
            self.predict_near(ball, Target::Cushion(cushion));
        }
        observer.flight(ball, &self.seen_flight(ball));
    }

    #[inline(always)]
    fn note_bounce(&mut self, bounce: &Bounce<S>) {
        self.note_contact(bounce.ball, bounce.time);
        let (after, before) = (bounce.rebound.velocity, bounce.before.velocity);
        let change = S::from_f64(0.5) * bounce.mass * (after.norm_squared() - before.norm_squared());
        self.diagnostics.account(change.to_f64(), (bounce.mass * bounce.rebound.energy_loss).to_f64());
    }

    /// Two balls meet.
    #[inline(never)]
    pub(super) fn strike_ball<const MANY: bool>(
        &mut self,
        ball: usize,
        other: usize,
        time: S,
        offset: S,
        observer: &mut impl Observer<S>,
    ) {
        let [a, b] = if ball < other { [ball, other] } else { [other, ball] };
        let collision = self.collision::<MANY>([a, b], time, offset);
        let [flight_a, flight_b] = collision.after().map(|state| self.free_flight(time, state));
        if let Some([next_a, next_b]) = self.next_of_two::<MANY>([a, b], [&flight_a, &flight_b]) {
            self.begin_flight_of::<MANY>(a, flight_a);
            self.schedule_with::<MANY>(a, next_a);
            self.begin_flight_of::<MANY>(b, flight_b);
            self.schedule_with::<MANY>(b, next_b);
            self.note_collision(&collision);
            self.emit(&collision.event(), observer);
            observer.flight(a, &if MANY { self.seen_flight(a) } else { flight_a });
            observer.flight(b, &if MANY { self.seen_flight(b) } else { flight_b });
        } else {
            self.strike_ball_near([a, b], time, offset, observer);
        }
    }

    /// A ball before its contact, should that turn out to be one of several.
    pub(super) fn struck(&self, ball: usize, elapsed: S) -> Struck<S> {
        let (flight, rounds) = (self.flight(ball), self.balls[ball].rounds);
        Struck { ball, flight, rounds, held_by: self.rest[ball].track.held_by, elapsed }
    }

    /// The state some time after the later start of two flights.
    #[inline(always)]
    fn state_at_contact(&self, flight: &Flight<S>, start: S, offset: S) -> State<S> {
        let State { position, velocity } = self.state_after(flight, start - flight.start);
        self.state_after(&Flight { position, velocity, ..*flight }, offset)
    }

    #[inline(always)]
    fn collision<const MANY: bool>(&self, balls: [usize; 2], time: S, offset: S) -> Collision<S> {
        let [a, b] = balls;
        let discs = [*self.disc(a), *self.disc(b)];
        let (flight_a, flight_b) = (self.flight(a), self.flight(b));
        let start = flight_a.later_start(&flight_b);
        let mut before = [
            self.state_at_contact(&flight_a, start, offset),
            self.state_at_contact(&flight_b, start, offset),
        ];
        let mut separation = before[1].position - before[0].position;
        if MANY {
            before[0].position = self.system.wrapped(before[0].position, self.balls[a].rounds);
            before[1].position = self.system.wrapped(before[1].position, self.balls[b].rounds);
            separation = self.system.shortest(before[1].position - before[0].position);
        }
        let pair = Pair::new([&discs[0], &discs[1]], separation, [before[0].velocity, before[1].velocity]);
        let law = self.ball_law(balls[0], balls[1], time);
        let kept_speed = self.kept_speed(balls[0], Some(balls[1]));
        let own = law.restitution(pair.closing_speed);
        let restitution = restitution_keeping(own, kept_speed, pair.closing_speed);
        let impact = law.impact(&pair, restitution);
        Collision { balls, time, start, discs, before, pair, impact }
    }

    /// The same in a field, between thin walls, or with something else in touch.
    #[inline(never)]
    fn strike_ball_near(&mut self, [a, b]: [usize; 2], time: S, offset: S, observer: &mut impl Observer<S>) {
        let collision = self.collision::<true>([a, b], time, offset);
        let struck = [a, b].map(|ball| self.struck(ball, collision.start - self.balls[ball].start + offset));
        for (ball, state) in [a, b].into_iter().zip(collision.after()) {
            self.begin_flight(ball, self.free_flight(time, state));
            self.forget_left_cushion(ball);
        }
        let touching_a = self.predict_near(a, Target::Ball(b as u32, 0));
        let touching_b = self.predict_near(b, Target::Ball(a as u32, 0));
        let is_held = struck.iter().any(|struck| struck.held_by[0].is_some());
        if touching_a || touching_b || is_held {
            self.strike_cluster(&struck, time, observer);
            return;
        }
        self.note_collision(&collision);
        self.emit(&collision.event(), observer);
        observer.flight(a, &self.seen_flight(a));
        observer.flight(b, &self.seen_flight(b));
    }

    #[inline(always)]
    fn note_collision(&mut self, collision: &Collision<S>) {
        let [a, b] = collision.balls;
        self.note_contact(a, collision.time);
        self.note_contact(b, collision.time);
        let [disc_a, disc_b] = &collision.discs;
        self.audit_distance(a, collision.pair.distance, disc_a.radius + disc_b.radius);
        let mut change = S::ZERO;
        let mut momentum = Vec2::ZERO;
        for (k, after) in collision.after().into_iter().enumerate() {
            let (before, after, mass) =
                (collision.before[k].velocity, after.velocity, collision.discs[k].mass);
            change += mass * (after.norm_squared() - before.norm_squared());
            momentum = momentum + (after - before) * mass;
        }
        let error = momentum.x.abs() + momentum.y.abs();
        self.diagnostics.account((change * S::from_f64(0.5)).to_f64(), collision.impact.energy_loss.to_f64());
        self.diagnostics.momentum_error = self.diagnostics.momentum_error.max(error.to_f64());
    }

    /// Notes the velocity with which a ball came to a place, unless it has been there since its last contact.
    pub(super) fn note_arrival(&mut self, ball: usize, elapsed: S, velocity: Vec2<S>) {
        if !self.system.has_backs {
            return;
        }
        let arrival = &mut self.rest[ball].track.arrival;
        if elapsed > S::ZERO || *arrival == Vec2::ZERO {
            *arrival = velocity;
        }
    }

    /// Forgets the cushion that a point touched last, once it has left it.
    pub(super) fn forget_left_cushion(&mut self, ball: usize) {
        let radius = self.balls[ball].radius;
        if radius > S::ZERO || !self.system.has_backs {
            return;
        }
        if let Some(cushion) = self.rest[ball].track.last_cushion {
            let tolerance = &self.system.tolerance;
            let cushion = &self.system.faces.all[cushion as usize];
            let gap = cushion_gap(self.flight(ball).position, radius, cushion, tolerance);
            if !gap.is_some_and(|gap| gap.abs() <= tolerance.of(radius)) {
                self.rest[ball].track.last_cushion = None;
                self.rest[ball].track.arrival = Vec2::ZERO;
            }
        }
    }
}

impl<S: Scalar> Bounce<S> {
    #[inline(always)]
    fn after(&self) -> State<S> {
        State { position: self.before.position, velocity: self.rebound.velocity }
    }

    #[inline(always)]
    fn event(&self) -> Event<S> {
        let change = self.rebound.velocity - self.before.velocity;
        Event {
            time: self.time,
            kind: Kind::BallCushion,
            ball_a: self.ball as u32,
            ball_b: None,
            cushion: Some(self.cushion),
            point: self.point,
            normal: self.normal,
            closing_speed: -self.rebound.normal_velocity,
            impulse: change.dot(self.normal) * self.normal_scale * self.mass,
            cluster: None,
        }
    }
}

impl<S: Scalar> Collision<S> {
    #[inline(always)]
    fn after(&self) -> [State<S>; 2] {
        let [a, b] = self.discs.map(|disc| self.pair.normal * (self.impact.impulse * disc.inverse_mass));
        let state =
            |State { position, velocity }: State<S>, change| State { position, velocity: velocity + change };
        [state(self.before[0], -a), state(self.before[1], b)]
    }

    #[inline(always)]
    fn event(&self) -> Event<S> {
        let [a, b] = self.balls;
        Event {
            time: self.time,
            kind: Kind::BallBall,
            ball_a: a as u32,
            ball_b: Some(b as u32),
            cushion: None,
            point: self.before[0].position + self.pair.normal * self.discs[0].radius,
            normal: self.pair.normal,
            closing_speed: self.pair.closing_speed,
            impulse: self.impact.impulse,
            cluster: None,
        }
    }
}
