//! Two balls meet.

use super::ending::{Cause, size};
use super::hop::{hop_apart, stop};
use super::{Ahead, Ball, Spheres};
use crate::engine::interface::Fault;
use crate::engine::queue::Pending;
use crate::flight::{Motion, SphereFlight};
use crate::geometry::Vec3;
use crate::law::ball_ball::{SphereImpact, SpherePair};
use crate::law::collapse::restitution_keeping;
use crate::model::{Sphere, Twist};
use crate::run::{Event, Kind, Observer, OnCloth};
use crate::scalar::Scalar;
use core::cmp::Ordering;

/// Events of one ball within the collapse time after which a run is given up.
const BURST_LIMIT: u32 = 1000;

/// Contacts of one ball within the collapse time after which it counts as jammed if it is slow.
const JAM_LIMIT: u32 = 100;

/// A ball at the instant of a contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Present<S> {
    pub(super) ball: usize,
    pub(super) sphere: Sphere<S>,
    pub(super) position: Vec3<S>,
    pub(super) twist: Twist<S>,
}

/// Two balls in touch, in order of their places: so it does not matter how they are numbered.
struct Meeting<S> {
    balls: [Present<S>; 2],
    normal: Vec3<S>,
    closing_speed: S,
    impact: SphereImpact<S>,
}

impl<S: Scalar> Spheres<S> {
    /// A ball where its flight has taken it, a time after its start.
    pub(super) fn present(&self, ball: usize, elapsed: S) -> Present<S> {
        let Ball { flight, sphere, .. } = self.balls[ball];
        let state = flight.state_after(elapsed);
        Present { ball, sphere, position: state.position, twist: state.twist }
    }

    /// Of all meetings of balls at a time makes that happen which comes first in order of place, so that it does not matter
    /// how the balls are numbered. Says whether it did: if one is stale it is predicted anew instead.
    pub(super) fn strike_first(&mut self, time: S, observer: &mut impl Observer<S, OnCloth>) -> bool {
        let mut first: Option<([usize; 2], S, [Vec3<S>; 2])> = None;
        for ball in 0..self.balls.len() {
            let Pending { time: own, offset, target } = *self.queue.pending(ball);
            let Ahead::Ball(other, changes) = target else { continue };
            if own != time {
                continue;
            }
            let pair = [ball, other as usize];
            if self.balls[pair[1]].track.changes != changes {
                self.diagnostics.stale += 1;
                self.predict(ball);
                return false;
            }
            let places = self.meeting_places(pair, offset);
            if first.is_none_or(|(.., before)| by_places(&places, &before).is_lt()) {
                first = Some((pair, offset, places));
            }
        }
        if let Some((pair, offset, _)) = first {
            self.strike_ball(pair, time, offset, observer);
        }
        first.is_some()
    }

    /// Where two balls are as they meet, in order of place.
    fn meeting_places(&self, pair: [usize; 2], offset: S) -> [Vec3<S>; 2] {
        let [a, b] = pair.map(|ball| &self.balls[ball].flight);
        let start = a.plan.later_start(&b.plan);
        let [a, b] = [a, b].map(|flight| flight.position_after(start - flight.start() + offset));
        if by_place(a, b).is_gt() { [b, a] } else { [a, b] }
    }

    /// Two balls meet, and perhaps more that touch them.
    fn strike_ball(
        &mut self,
        balls: [usize; 2],
        time: S,
        offset: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        let start = self.balls[balls[0]].flight.plan.later_start(&self.balls[balls[1]].flight.plan);
        let mut pair = balls.map(|ball| {
            let since = start - self.balls[ball].flight.start();
            self.present(ball, since + offset)
        });
        if by_place(pair[0].position, pair[1].position).is_gt() {
            pair.swap(0, 1);
        }
        if !self.strike_cluster(&pair, time, observer) {
            let meeting = self.meeting(pair, time);
            self.resolve_meeting(&meeting, time, observer);
        }
    }

    fn meeting(&self, balls: [Present<S>; 2], time: S) -> Meeting<S> {
        let [a, b] = &balls;
        let normal = (b.position - a.position).unit();
        let closing_speed = (a.twist.velocity - b.twist.velocity).dot(normal);
        let kept_speed = self.kept_speed(a.ball, Some(b.ball), time);
        let impact = if closing_speed > threshold(&balls) {
            let law = &self.system.ball_ball;
            let restitution = restitution_keeping(law.restitution(closing_speed), kept_speed, closing_speed);
            let on_cloth = [a, b].map(|present| self.balls[present.ball].flight.motion != Motion::Airborne);
            let pair =
                SpherePair { spheres: [a.sphere, b.sphere], normal, twists: [a.twist, b.twist], on_cloth };
            law.impact(&pair, restitution)
        } else {
            SphereImpact { twists: [a.twist, b.twist], impulse: S::ZERO }
        };
        let mut meeting = Meeting { balls, normal, closing_speed, impact };
        if balls.iter().any(|ball| self.is_jammed(ball, time)) {
            meeting.impact.twists.iter_mut().for_each(stop);
        } else {
            self.let_hop(&mut meeting, time);
        }
        meeting
    }

    /// Two balls that are pressed together, because one brakes harder, part with a hop that lasts t_c at least, and with
    /// more than round-off in any case; else they would meet without end. Pressed are those that do not close, or that
    /// had a contact just now: what meets at first is left to the law, or grazes would be blows.
    fn let_hop(&self, meeting: &mut Meeting<S>, time: S) {
        let [a, b] = self.flights_of(meeting, time).map(|(_, flight)| flight);
        let normal = meeting.normal;
        let pull = (a.acceleration() - b.acceleration()).dot(normal);
        let parting = (b.velocity_after(S::ZERO) - a.velocity_after(S::ZERO)).dot(normal);
        let is_pressed = self.is_pressed(&meeting.balls, meeting.closing_speed, time);
        if let Some(lacking) = self.lacking_speed(&meeting.balls, is_pressed, pull, parting) {
            let spheres = meeting.balls.map(|ball| ball.sphere);
            let SphereImpact { twists, impulse } = meeting.impact;
            let hop = hop_apart([(spheres[0], twists[0]), (spheres[1], twists[1])], meeting.normal, lacking);
            meeting.impact = SphereImpact { twists: hop.twists, impulse: impulse + hop.impulse };
        }
    }

    /// Whether balls in a contact are pressed rather than struck: they do not close, or one had a contact less than 2 t_c
    /// ago, in which a hop ends. What meets at first is left to the law, or grazes would be blows.
    pub(super) fn is_pressed(&self, balls: &[Present<S>], closing_speed: S, time: S) -> bool {
        let is_hopping = |ball: usize| {
            time - self.balls[ball].track.last_contact < self.system.hop_times[ball] * S::from_f64(2.0)
        };
        closing_speed <= threshold(balls) || balls.iter().any(|present| is_hopping(present.ball))
    }

    /// What balls that are pulled together, or one that is pulled onto a cushion, lack of the speed of a hop that lasts t_c
    /// if they are pressed; in any case of more than round-off.
    pub(super) fn lacking_speed(
        &self,
        balls: &[Present<S>],
        is_pressed: bool,
        pull: S,
        parting_speed: S,
    ) -> Option<S> {
        let times = balls.iter().map(|ball| self.system.hop_times[ball.ball]);
        let hop_time = times.fold(S::INFINITY, |least, time| if time < least { time } else { least });
        let hop_speed = if is_pressed { pull * (hop_time * S::from_f64(0.5)) } else { S::ZERO };
        let round_off = threshold(balls) * S::from_f64(4.0);
        let lacking = (if hop_speed > round_off { hop_speed } else { round_off }) - parting_speed;
        (lacking > S::ZERO).then_some(lacking)
    }

    fn flights_of(&self, meeting: &Meeting<S>, time: S) -> [(usize, SphereFlight<S>); 2] {
        let flight = |k: usize| {
            let Present { ball, position, twist, .. } = &meeting.balls[k];
            let after = meeting.impact.twists[k];
            (*ball, self.flight_after(*ball, time, *position, twist, after, Cause::Blow))
        };
        [flight(0), flight(1)]
    }

    fn resolve_meeting(&mut self, meeting: &Meeting<S>, time: S, observer: &mut impl Observer<S, OnCloth>) {
        let Meeting { balls: [a, b], impact, .. } = meeting;
        let flights = self.flights_of(meeting, time);
        self.note_distance(meeting);
        self.note_contact(a.ball, time);
        self.note_contact(b.ball, time);
        self.account_for_contact(&[a.twist, b.twist], &flights);
        self.begin_flights(&flights, observer);
        let event = contact_event([a, b], meeting.normal, time, meeting.closing_speed, impact.impulse);
        self.emit(&event, observer);
    }

    fn note_distance(&mut self, Meeting { balls: [a, b], .. }: &Meeting<S>) {
        let radii = a.sphere.radius + b.sphere.radius;
        let overlap = radii - (b.position - a.position).norm();
        if overlap > S::ZERO {
            self.note_overlap(a.ball, overlap, overlap > self.system.tolerance.of(radii));
        }
    }

    /// The speed up to which a contact loses nothing: v_c within t_c of another of its balls, else none. So no ball meets
    /// others without end in a finite time.
    pub(super) fn kept_speed(&self, ball: usize, other: Option<usize>, time: S) -> S {
        let speeds = &self.system.kept_speeds;
        let is_in_burst =
            |ball: usize| time - self.balls[ball].track.last_contact < self.system.hop_times[ball];
        let (own, other_ball) = (speeds[ball], other.unwrap_or(ball));
        if is_in_burst(ball) || is_in_burst(other_ball) {
            if speeds[other_ball] < own { speeds[other_ball] } else { own }
        } else {
            S::ZERO
        }
    }

    /// Notes that a ball had a contact; if such follow each other too fast, that is a fault.
    pub(super) fn note_contact(&mut self, ball: usize, time: S) {
        let track = &mut self.balls[ball].track;
        track.last_contact = time;
        track.burst += 1;
        if track.burst > BURST_LIMIT {
            if time - track.burst_start <= self.system.collapse_times[ball] {
                self.fault = Some(Fault::Collapse(ball as u32));
            }
            (track.burst_start, track.burst) = (time, 0);
        }
    }

    /// Whether a ball is jammed: slower than v_c, it has met others and cushions again and again within the collapse time.
    pub(super) fn is_jammed(&self, ball: &Present<S>, time: S) -> bool {
        let (track, slow) = (&self.balls[ball.ball].track, self.system.kept_speeds[ball.ball]);
        track.burst > JAM_LIMIT
            && time - track.burst_start <= self.system.collapse_times[ball.ball]
            && ball.twist.velocity.norm_squared() < slow.squared()
    }

    /// Starts the new flights of several balls, and then predicts where they lead.
    pub(super) fn begin_flights(
        &mut self,
        flights: &[(usize, SphereFlight<S>)],
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        for (ball, flight) in flights {
            self.account_for_friction(*ball, flight.start());
            self.balls[*ball].flight = *flight;
            self.balls[*ball].track.changes += 1;
            observer.flight(*ball, flight);
        }
        for (ball, _) in flights {
            self.predict(*ball);
        }
    }
}

/// The closing speed that is not told from none: sixteen round-offs of the speeds that it is the difference of.
pub(super) fn threshold<S: Scalar>(balls: &[Present<S>]) -> S {
    let speeds = balls.iter().fold(S::ZERO, |sum, ball| sum + size(&ball.sphere, &ball.twist));
    speeds * S::from_f64(16.0 * S::EPSILON)
}

/// The row of a contact of two balls given in order of place; in it the one with the lower number comes first.
pub(super) fn contact_event<S: Scalar>(
    [a, b]: [&Present<S>; 2],
    normal: Vec3<S>,
    time: S,
    closing_speed: S,
    impulse: S,
) -> Event<S> {
    let (first, second, normal) = if a.ball < b.ball { (a, b, normal) } else { (b, a, -normal) };
    Event {
        time,
        kind: Kind::BallBall,
        ball_a: first.ball as u32,
        ball_b: Some(second.ball as u32),
        cushion: None,
        point: (first.position + normal * first.sphere.radius).plan(),
        normal: normal.plan(),
        closing_speed,
        impulse,
        cluster: None,
    }
}

fn by_places<S: Scalar>(a: &[Vec3<S>; 2], b: &[Vec3<S>; 2]) -> Ordering {
    by_place(a[0], b[0]).then_with(|| by_place(a[1], b[1]))
}

/// The order of places: from left to right, then from bottom to top.
pub(super) fn by_place<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Ordering {
    let key = |v: Vec3<S>| (v.x, v.y, v.z);
    key(a).partial_cmp(&key(b)).unwrap_or(Ordering::Equal)
}
