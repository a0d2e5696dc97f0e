//! Prediction: a ball's next event, from the flights as they are.

use super::discs::{Discs, Neighbourhood};
use super::grid::Side;
use super::queue::{Pending, Target};
use crate::detect::{
    Surroundings, cushion_gap, detect_ball_ball, detect_ball_cushion, detect_ball_in_the_clear,
    detect_cushion_in_the_clear, detect_from_behind, detect_release,
};
use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::model::Face;
use crate::scalar::Scalar;

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
        let flight = self.balls[ball].flight;
        let next = if self.grid.is_some() {
            self.next_in_the_clear::<true>(ball, &flight, Target::Nothing)
        } else {
            self.next_in_the_clear::<false>(ball, &flight, Target::Nothing)
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
        if self.grid.is_some() {
            self.schedule_with::<true>(ball, next);
        } else {
            self.schedule_with::<false>(ball, next);
        }
    }

    /// The same where it is known whether there is a grid.
    #[inline(always)]
    pub(super) fn schedule_with<const GRID: bool>(&mut self, ball: usize, next: Pending<S>) {
        self.diagnostics.predictions += 1;
        if GRID {
            self.schedule_in_cell(ball, next);
        } else {
            self.queue.set(ball, next);
        }
    }

    /// Schedules a ball's event, or that it leaves its cell before.
    #[inline(always)]
    fn schedule_in_cell(&mut self, ball: usize, next: Pending<S>) {
        let Some(Neighbourhood { grid, meetings }) = &mut self.grid else { return };
        meetings[ball] = next;
        let flight = &self.balls[ball].flight;
        let (offset, side) = grid.way_out(ball, flight);
        self.queue.set(ball, next.earlier(flight.start, Some(offset), Target::Cell(side)));
    }

    /// A ball comes into the next cell: only what is in those that have come near can be new to it.
    #[inline(never)]
    pub(super) fn cross(&mut self, ball: usize, side: Side) {
        let Some(Neighbourhood { grid, meetings }) = &mut self.grid else { return };
        grid.cross(ball, side);
        let mut next = Some(meetings[ball]);
        if let Some(Neighbourhood { grid, .. }) = &self.grid {
            grid.ahead(ball, side, |other| {
                next = next.and_then(|next| self.sooner(ball, &self.balls[ball].flight, other, next))
            });
        }
        match next {
            Some(next) => self.schedule(ball, next),
            None => {
                self.predict_near(ball, Target::Nothing);
            }
        }
    }

    /// The earlier of a ball's event `next` and its meeting with another, in flights that are straight; of two at one time
    /// that with the lower number. `None` where the two are so near each other that more has to be asked.
    #[inline(always)]
    fn sooner(&self, ball: usize, flight: &Flight<S>, other: usize, next: Pending<S>) -> Option<Pending<S>> {
        let their = &self.balls[other];
        let radii = self.balls[ball].disc.radius + their.disc.radius;
        if radii == S::ZERO {
            return Some(next);
        }
        let offset = detect_ball_in_the_clear(flight, &their.flight, radii, &self.system.tolerance)?;
        Some(next.earlier_meeting(flight.later_start(&their.flight), offset, other, their.track.changes))
    }

    /// A ball's next event on a flight where every flight is straight, no cushion hides it, and nothing but `struck` is in
    /// touch; `None` otherwise. The answer is that of [`Self::predict_near`], but quicker.
    #[inline(always)]
    pub(super) fn next_in_the_clear<const GRID: bool>(
        &self,
        ball: usize,
        flight: &Flight<S>,
        struck: Target,
    ) -> Option<Pending<S>> {
        if !self.is_plain {
            return None;
        }
        let (system, disc) = (&*self.system, &self.balls[ball].disc);
        let (struck_ball, struck_cushion) = match struck {
            Target::Ball(other, _) => (other as usize, usize::MAX),
            Target::Cushion(cushion) => (usize::MAX, cushion as usize),
            _ => (usize::MAX, usize::MAX),
        };
        let tolerance = system.tolerance.of(disc.radius);
        let (cushion, offset) =
            detect_cushion_in_the_clear(flight, disc.radius, &system.faces, tolerance, struck_cushion)?;
        let target = if offset < S::INFINITY { Target::Cushion(cushion as u32) } else { Target::Nothing };
        let mut next = Pending { time: flight.start + offset, offset, target };
        if GRID {
            return self.next_of_near(ball, flight, struck_ball, next);
        }
        for other in 0..self.balls.len() {
            if other == ball || other == struck_ball {
                continue;
            }
            let their = &self.balls[other];
            let radii = disc.radius + their.disc.radius;
            if radii == S::ZERO {
                continue;
            }
            let offset = detect_ball_in_the_clear(flight, &their.flight, radii, &system.tolerance)?;
            let target = Target::Ball(other as u32, their.track.changes);
            next = next.earlier(flight.later_start(&their.flight), Some(offset), target);
        }
        Some(next)
    }

    /// The same of the balls that the grid has near.
    #[inline(always)]
    fn next_of_near(
        &self,
        ball: usize,
        flight: &Flight<S>,
        struck: usize,
        next: Pending<S>,
    ) -> Option<Pending<S>> {
        let Neighbourhood { grid, .. } = self.grid.as_ref()?;
        let mut next = Some(next);
        grid.near(ball, |other| {
            if other != ball && other != struck {
                next = next.and_then(|next| self.sooner(ball, flight, other, next));
            }
        });
        next
    }

    /// Finds a ball's next event, in a field, between thin walls, or with something in touch; says whether anything is but
    /// `struck`, which it has just been in contact with.
    #[inline(never)]
    pub(super) fn predict_near(&mut self, ball: usize, struck: Target) -> bool {
        let mut seen = Surroundings::CLEAR;
        let next = self.next_cushion(ball, struck, &mut seen);
        let next = self.next_ball(ball, struck, next, &mut seen);
        let next = if self.balls[ball].track.is_held() { self.earlier_release(ball, next) } else { next };
        self.schedule(ball, next);
        if seen.overlap > S::ZERO {
            self.note_overlap(ball, seen.overlap, seen.broken);
        }
        seen.touching
    }

    /// The first cushion that a ball meets: one that holds it, or is the other face of its thin wall, is passed over.
    fn next_cushion(&self, ball: usize, struck: Target, seen: &mut Surroundings<S>) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.balls[ball].flight;
        let radius = self.balls[ball].disc.radius;
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
        let system = &*self.system;
        let flight = &self.balls[ball].flight;
        let radius = self.balls[ball].disc.radius;
        let struck = if let Target::Ball(other, _) = struck { other as usize } else { usize::MAX };
        let mut next = next;
        let mut meet = |other: usize| {
            let their = &self.balls[other];
            let radii = radius + their.disc.radius;
            if other == ball || radii == S::ZERO {
                return;
            }
            let is_struck = other == struck;
            if let Some(offset) =
                detect_ball_ball(flight, &their.flight, radii, &system.tolerance, is_struck, seen)
            {
                let start = flight.later_start(&their.flight);
                next = next.earlier_meeting(start, offset, other, their.track.changes);
            }
        };
        match &self.grid {
            Some(Neighbourhood { grid, .. }) => grid.near(ball, meet),
            None => (0..self.balls.len()).for_each(&mut meet),
        }
        next
    }

    fn past(&self, ball: usize, cushion: u32) -> Past {
        if self.balls[ball].track.held_by.contains(&Some(cushion)) {
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
        if back.is_none() || self.balls[ball].disc.radius > S::ZERO {
            return false;
        }
        let (track, position) = (&self.balls[ball].track, self.balls[ball].flight.position);
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
                detect_from_behind(&self.balls[ball].flight, line, self.system.tolerance.of(S::ZERO))
            }
            Face::Round(_) => None,
        }
    }

    fn earlier_release(&self, ball: usize, next: Pending<S>) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.balls[ball].flight;
        let tolerance = system.tolerance.of(self.balls[ball].disc.radius);
        let mut next = next;
        for cushion in self.balls[ball].track.held_by.into_iter().flatten() {
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
            let (ball, Pending { time, target, .. }) = self.queue.first();
            match target {
                Target::Ball(other, changes) if self.balls[other as usize].track.changes != changes => {
                    self.diagnostics.stale += 1;
                    self.predict(ball);
                }
                Target::Cell(side) => self.cross(ball, side),
                _ => return time,
            }
        }
    }
}
