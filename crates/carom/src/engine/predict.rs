//! Prediction: a ball's next event, from the flights as they are.

use super::ball::Ball;
use super::discs::Discs;
use super::queue::{Pending, Target};
use crate::detect::{
    Surroundings, cushion_gap, detect_ball_ball, detect_ball_cushion, detect_ball_in_the_clear,
    detect_cushion_in_the_clear, detect_from_behind, detect_release,
};
use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::model::Face;
use crate::scalar::Scalar;

/// Images of a periodic table to each side in which a ball's next event is looked for when it is asked without a grid.
const IMAGES: i32 = 3;

/// What binds a ball to a cushion from before.
enum Past {
    None,
    /// The cushion holds it.
    Held,
    /// It is a point on the other face of the thin wall.
    Behind,
}

impl<S: Scalar> Discs<S> {
    /// Predicts every ball's next event from the flights as they are.
    pub(super) fn predict_all(&mut self) {
        for ball in 0..self.balls.len() {
            self.predict(ball);
        }
    }

    /// Finds a ball's next event when nothing has just happened to it.
    pub(super) fn predict(&mut self, ball: usize) {
        let flight = self.flight(ball);
        let next = if self.many.is_some() {
            self.next_on_line(&self.balls[ball], &flight, Target::Nothing)
        } else {
            self.next_in_the_clear(ball, &flight, Target::Nothing)
        };
        match next {
            Some(next) => self.schedule(ball, next),
            None => {
                self.predict_near(ball, Target::Nothing);
            }
        }
    }

    /// Makes a ball's next event pending.
    pub(super) fn schedule(&mut self, ball: usize, next: Pending<S>) {
        if self.many.is_some() {
            self.schedule_with::<true>(ball, next);
        } else {
            self.schedule_with::<false>(ball, next);
        }
    }

    /// The same where it is known whether there are many balls.
    #[inline(always)]
    pub(super) fn schedule_with<const MANY: bool>(&mut self, ball: usize, next: Pending<S>) {
        if MANY {
            self.schedule_among_many(ball, next);
        } else {
            self.diagnostics.predictions += 1;
            self.queue.set(ball, next);
        }
    }

    /// A ball's next event on a new flight; `None` where something but `struck` is in touch, or no short way can tell.
    #[inline(always)]
    pub(super) fn next_on<const MANY: bool>(
        &self,
        ball: usize,
        flight: &Flight<S>,
        struck: Target,
    ) -> Option<Pending<S>> {
        if MANY {
            self.next_on_line(&self.line_of(ball, flight), flight, struck)
        } else {
            self.next_in_the_clear(ball, flight, struck)
        }
    }

    /// The same of one of many balls.
    #[inline(always)]
    fn next_on_line(&self, line: &Ball<S>, flight: &Flight<S>, struck: Target) -> Option<Pending<S>> {
        let next = self.next_cushion_of_many(line, flight, struck)?;
        self.meeting_near(line, struck, next)
    }

    #[inline(always)]
    fn next_cushion_of_many(&self, line: &Ball<S>, flight: &Flight<S>, struck: Target) -> Option<Pending<S>> {
        if self.is_open {
            return Some(Pending::NEVER);
        }
        self.next_cushion_in_the_clear(line.radius, flight, struck)
    }

    /// The next events of two balls on new flights after their contact.
    #[inline(always)]
    pub(super) fn next_of_two<const MANY: bool>(
        &self,
        [a, b]: [usize; 2],
        flights: [&Flight<S>; 2],
    ) -> Option<[Pending<S>; 2]> {
        let struck = [Target::Ball(b as u32, 0), Target::Ball(a as u32, 0)];
        if MANY {
            let (line_a, line_b) = (self.line_of(a, flights[0]), self.line_of(b, flights[1]));
            let next_a = self.next_cushion_of_many(&line_a, flights[0], struck[0])?;
            let next_b = self.next_cushion_of_many(&line_b, flights[1], struck[1])?;
            self.meetings_near([&line_a, &line_b], struck, [next_a, next_b])
        } else {
            let next = self.next_in_the_clear(a, flights[0], struck[0])?;
            Some([next, self.next_in_the_clear(b, flights[1], struck[1])?])
        }
    }

    /// The first cushion that a ball in straight flight meets, where none can hide; `None` where one but `struck` is in touch.
    #[inline(always)]
    fn next_cushion_in_the_clear(&self, radius: S, flight: &Flight<S>, struck: Target) -> Option<Pending<S>> {
        if !self.is_plain {
            return None;
        }
        let struck = if let Target::Cushion(cushion) = struck { cushion as usize } else { usize::MAX };
        let tolerance = self.system.tolerance.of(radius);
        let (cushion, offset) =
            detect_cushion_in_the_clear(flight, radius, &self.system.faces, tolerance, struck)?;
        let target = if offset < S::INFINITY { Target::Cushion(cushion as u32) } else { Target::Nothing };
        Some(Pending { time: flight.start + offset, offset, target })
    }

    /// A ball's next event on a flight where every flight is straight, no cushion hides it, and nothing but `struck` is in
    /// touch; `None` otherwise. The answer is that of [`Self::predict_near`], but quicker.
    #[inline(always)]
    pub(super) fn next_in_the_clear(
        &self,
        ball: usize,
        flight: &Flight<S>,
        struck: Target,
    ) -> Option<Pending<S>> {
        let radius = self.balls[ball].radius;
        let mut next = self.next_cushion_in_the_clear(radius, flight, struck)?;
        let struck = if let Target::Ball(other, _) = struck { other as usize } else { usize::MAX };
        for (other, their) in self.balls.iter().enumerate() {
            let radii = radius + their.radius;
            if other == ball || other == struck || radii == S::ZERO {
                continue;
            }
            let their_flight = their.straight_flight();
            let offset = detect_ball_in_the_clear(flight, &their_flight, radii, &self.system.tolerance)?;
            let target = Target::Ball(other as u32, their.changes);
            next = next.earlier(flight.later_start(&their_flight), Some(offset), target);
        }
        Some(next)
    }

    /// Finds a ball's next event, in a field, between thin walls, or with something in touch; says whether anything is but
    /// `struck`, which it has just been in contact with.
    #[inline(never)]
    pub(super) fn predict_near(&mut self, ball: usize, struck: Target) -> bool {
        let mut seen = Surroundings::CLEAR;
        let next = self.next_near(ball, struck, &mut seen);
        self.schedule(ball, next);
        if seen.overlap > S::ZERO {
            self.note_overlap(ball, seen.overlap, seen.broken);
        }
        seen.touching
    }

    /// A ball's next event, asked in the long way.
    fn next_near(&self, ball: usize, struck: Target, seen: &mut Surroundings<S>) -> Pending<S> {
        let next = self.next_cushion(ball, struck, seen);
        let next = self.next_ball(ball, struck, next, seen);
        if self.rest[ball].track.is_held() { self.earlier_release(ball, next) } else { next }
    }

    /// A ball's next event, whatever cell it is in by then; on a periodic table with what is up to three images away.
    pub(super) fn next_of_all(&self, ball: usize) -> Pending<S> {
        let mut seen = Surroundings::CLEAR;
        let mut next = self.next_cushion(ball, Target::Nothing, &mut seen);
        for other in 0..self.balls.len() {
            let rounds = self.rounds_between(&self.balls[ball], other as u32, [0; 2]);
            self.system.each_image(rounds, IMAGES, |shift| {
                next = self.sooner(ball, other, shift, false, next, &mut seen);
            });
        }
        if self.rest[ball].track.is_held() { self.earlier_release(ball, next) } else { next }
    }

    /// The first cushion that a ball meets: one that holds it, or is the other face of its thin wall, is passed over.
    fn next_cushion(&self, ball: usize, struck: Target, seen: &mut Surroundings<S>) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flight(ball);
        let radius = self.balls[ball].radius;
        let tolerance = system.tolerance.of(radius);
        let mut next = Pending::NEVER;
        for (number, face) in system.faces.all.iter().enumerate() {
            let target = Target::Cushion(number as u32);
            let offset = match self.past(ball, number as u32) {
                Past::Held => None,
                Past::Behind => self.detect_round_the_wall(ball, face),
                Past::None => detect_ball_cushion(flight, radius, face, tolerance, target == struck, seen),
            };
            next = next.earlier(flight.start, offset, target);
        }
        next
    }

    /// The first ball that a ball meets, if it does so before its event `next`.
    fn next_ball(
        &self,
        ball: usize,
        struck: Target,
        next: Pending<S>,
        seen: &mut Surroundings<S>,
    ) -> Pending<S> {
        let struck = if let Target::Ball(other, _) = struck { other as usize } else { usize::MAX };
        let mut next = next;
        self.each_near(ball, |other, shift| {
            next = self.sooner(ball, other, shift, other == struck, next, seen);
        });
        next
    }

    /// The earlier of a ball's event `next` and its meeting with another; of two at one time that with the lower number.
    fn sooner(
        &self,
        ball: usize,
        other: usize,
        shift: Option<Vec2<S>>,
        is_struck: bool,
        next: Pending<S>,
        seen: &mut Surroundings<S>,
    ) -> Pending<S> {
        let radii = self.balls[ball].radius + self.balls[other].radius;
        if other == ball || radii == S::ZERO {
            return next;
        }
        let flights = [ball, other].map(|ball| self.flight(ball));
        let [flight, their] = &flights;
        match detect_ball_ball([flight, their], shift, radii, &self.system.tolerance, is_struck, seen) {
            Some(offset) => {
                next.earlier_meeting(flight.later_start(their), offset, other, self.balls[other].changes)
            }
            None => next,
        }
    }

    fn past(&self, ball: usize, cushion: u32) -> Past {
        if self.rest[ball].track.held_by.contains(&Some(cushion)) {
            Past::Held
        } else if self.is_behind(ball, cushion) {
            Past::Behind
        } else {
            Past::None
        }
    }

    /// Whether a ball is a point on the other face of the thin wall that a cushion is one face of: its last cushion says so,
    /// or the direction from which it came to the place where several walls meet.
    pub(super) fn is_behind(&self, ball: usize, cushion: u32) -> bool {
        let back = self.system.backs[cushion as usize];
        if back.is_none() || self.balls[ball].radius > S::ZERO {
            return false;
        }
        let (track, position) = (&self.rest[ball].track, self.flight(ball).position);
        track.last_cushion == back || self.is_across(cushion, track.arrival, position)
    }

    /// Whether a point at a cushion came through it from behind: then it is at the other face.
    pub(super) fn is_across(&self, cushion: u32, arrival: Vec2<S>, position: Vec2<S>) -> bool {
        let (face, tolerance) = (&self.system.faces.all[cushion as usize], &self.system.tolerance);
        let is_at = |gap: S| gap.abs() <= tolerance.of(S::ZERO);
        face.normal_at(position).0.dot(arrival) > S::ZERO
            && cushion_gap(position, S::ZERO, face, tolerance).is_some_and(is_at)
    }

    fn detect_round_the_wall(&self, ball: usize, cushion: &Face<S>) -> Option<S> {
        match cushion {
            Face::Line(line) => {
                detect_from_behind(&self.flight(ball), line, self.system.tolerance.of(S::ZERO))
            }
            Face::Round(_) => None,
        }
    }

    fn earlier_release(&self, ball: usize, next: Pending<S>) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flight(ball);
        let tolerance = system.tolerance.of(self.balls[ball].radius);
        let mut next = next;
        for cushion in self.rest[ball].track.held_by.into_iter().flatten() {
            if let Face::Line(line) = &system.faces.all[cushion as usize] {
                // Twice the tolerance: where it is let go, the ball's foot must no longer count as on the cushion.
                let offset = detect_release(flight, line, tolerance * S::from_f64(2.0));
                next = next.earlier(flight.start, offset, Target::Release(cushion));
            }
        }
        next
    }

    /// The time of the next event. Predicts anew where the first pending one is stale.
    pub(super) fn time_of_next(&mut self) -> S {
        loop {
            let (ball, Pending { time, target, .. }) = if self.many.is_some() {
                let Some(first) = self.first_of_many(S::INFINITY) else { return S::INFINITY };
                first
            } else {
                self.queue.first()
            };
            match target {
                Target::Ball(other, changes) if self.balls[other as usize].changes != changes => {
                    self.diagnostics.stale += 1;
                    self.predict(ball);
                }
                _ => return time,
            }
        }
    }
}
