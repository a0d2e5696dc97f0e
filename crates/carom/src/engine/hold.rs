//! A ball in a field that comes to lie on straight cushions, slides along them, and leaves them.

use super::discs::Discs;
use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::model::{Face, Line, closing_threshold};
use crate::run::{Event, Kind, Observer};
use crate::scalar::Scalar;

impl<S: Scalar> Discs<S> {
    /// Holds a ball on those of the cushions it touches from which its next bounce would be too short: its normal
    /// velocity becomes zero and its acceleration the projection on the cushion. Says whether any holds it; the log has a
    /// row for each that did not before.
    pub(super) fn settle(
        &mut self,
        ball: usize,
        touched: &[u32],
        held_by: [Option<u32>; 2],
        observer: &mut impl Observer<S>,
    ) -> bool {
        if !self.has_field {
            return false;
        }
        let mut flight = self.flight(ball);
        for place in 0..2 {
            let Some((cushion, line)) = self.pressing(ball, &flight, touched) else { break };
            self.rest[ball].track.held_by[place] = Some(cushion);
            let mut lost = lay(&mut flight, &line);
            self.drop_round_off(&mut flight);
            if place == 1 {
                lost += S::from_f64(0.5) * flight.velocity.norm_squared();
                (flight.velocity, flight.acceleration) = (Vec2::ZERO, Vec2::ZERO);
            }
            let disc = *self.disc(ball);
            self.diagnostics.energy_loss += (disc.mass * lost).to_f64();
            let event = Event {
                time: flight.start,
                kind: Kind::Hold,
                ball_a: ball as u32,
                ball_b: None,
                cushion: Some(cushion),
                point: Face::Line(line).foot(flight.position),
                normal: line.normal,
                closing_speed: S::ZERO,
                impulse: S::ZERO,
                cluster: None,
            };
            self.lay_flight(ball, &flight);
            if !held_by.contains(&Some(cushion)) {
                self.emit(&event, observer);
            }
        }
        self.rest[ball].track.is_held()
    }

    /// Drops what is left of the acceleration and velocity of a ball that lies on a cushion across the field, where it is
    /// nothing but round-off: of the field, and of the speed of a fall across the table.
    fn drop_round_off(&self, flight: &mut Flight<S>) {
        let round_off = S::from_f64(16.0 * S::EPSILON);
        let field = self.system.field.norm();
        let drop = |v: Vec2<S>, scale: S| {
            let real = Vec2::new(v.x.detached(), v.y.detached());
            if real.x.abs() + real.y.abs() <= scale * round_off { v - real } else { v }
        };
        flight.acceleration = drop(flight.acceleration, field);
        if flight.is_straight() {
            let fall = (field * self.system.tolerance.table_size()).sqrt();
            flight.velocity = drop(flight.velocity, fall);
        }
    }

    /// The cushion that a ball is pressed against hardest, among those whose next bounce would be too short.
    ///
    /// Laid on it, the ball must not run into another that it touches: unless gently enough to be held by both, it is
    /// rather the other along which it goes on.
    fn pressing(&self, ball: usize, flight: &Flight<S>, touched: &[u32]) -> Option<(u32, Line<S>)> {
        let held = self.rest[ball].track.held_by;
        let mut hardest: Option<(u32, Line<S>, [S; 2])> = None;
        for &cushion in touched {
            let Face::Line(line) = self.system.faces.all[cushion as usize] else { continue };
            let pull = -line.normal.dot(flight.acceleration);
            if pull <= S::ZERO || held.contains(&Some(cushion)) || !self.is_short(ball, flight, &line) {
                continue;
            }
            let mut laid = *flight;
            lay(&mut laid, &line);
            let Some(blow) = self.hardest_blow(ball, &laid, touched) else { continue };
            let is_better = |[least, most]: [S; 2]| blow < least || (blow == least && pull > most);
            if hardest.is_none_or(|(.., best)| is_better(best)) {
                hardest = Some((cushion, line, [blow, pull]));
            }
        }
        hardest.map(|(cushion, line, _)| (cushion, line))
    }

    /// Whether a ball's next bounce on a cushion, at which it moves or from which it parts, would be too short.
    fn is_short(&self, ball: usize, flight: &Flight<S>, line: &Line<S>) -> bool {
        let pull = -line.normal.dot(flight.acceleration);
        let speed = line.normal.dot(flight.velocity).abs();
        let threshold = closing_threshold(flight.velocity, Vec2::ZERO);
        speed * S::from_f64(2.0) <= self.longest_held(ball) * pull + threshold
    }

    /// Bounces up to this duration are not followed: t_c. Where balls hop on through a collapse it is a hundredth of t_c, as
    /// they would lose the energy of each hop that ends in a hold, and a heap hops for as long as it has any.
    fn longest_held(&self, ball: usize) -> S {
        let time = self.system.collapse_times[ball];
        if self.system.collapse_is_elastic { time * S::from_f64(0.01) } else { time }
    }

    /// The greatest speed at which a ball moves at a cushion that it touches and that does not hold it, zero if at none; none
    /// if that is too fast for it to be held there.
    fn hardest_blow(&self, ball: usize, flight: &Flight<S>, touched: &[u32]) -> Option<S> {
        let mut hardest = S::ZERO;
        for &cushion in
            touched.iter().filter(|cushion| !self.rest[ball].track.held_by.contains(&Some(**cushion)))
        {
            let face = &self.system.faces.all[cushion as usize];
            let blow = -face.normal_at(flight.position).0.dot(flight.velocity);
            if blow > closing_threshold(flight.velocity, Vec2::ZERO) {
                let Face::Line(line) = face else { return None };
                if !self.is_short(ball, flight, line) {
                    return None;
                }
                hardest = if blow > hardest { blow } else { hardest };
            }
        }
        Some(hardest)
    }

    /// A ball passes the end of the cushion that held it, and flies free.
    pub(super) fn release(
        &mut self,
        ball: usize,
        cushion: u32,
        time: S,
        offset: S,
        observer: &mut impl Observer<S>,
    ) {
        let flight = self.flight(ball);
        let state = flight.state_after(offset);
        let (normal, _) = self.system.faces.all[cushion as usize].normal_at(state.position);
        self.begin_flight(ball, self.free_flight(time, state));
        self.note_contact(ball, time);
        self.predict(ball);
        let event = Event {
            time,
            kind: Kind::Release,
            ball_a: ball as u32,
            ball_b: None,
            cushion: Some(cushion),
            point: self.system.faces.all[cushion as usize].foot(state.position),
            normal,
            closing_speed: S::ZERO,
            impulse: S::ZERO,
            cluster: None,
        };
        self.emit(&event, observer);
        observer.flight(ball, &self.seen_flight(ball));
    }
}

/// Takes the normal velocity and acceleration away; gives the kinetic energy lost per mass.
fn lay<S: Scalar>(flight: &mut Flight<S>, line: &Line<S>) -> S {
    let across = |v: Vec2<S>| line.normal * (line.normal.dot(v) * line.normal_scale);
    let normal_velocity = across(flight.velocity);
    flight.velocity = flight.velocity - normal_velocity;
    flight.acceleration = flight.acceleration - across(flight.acceleration);
    S::from_f64(0.5) * normal_velocity.norm_squared()
}
