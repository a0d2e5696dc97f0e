//! Prediction: a ball's next event, from the flights as they are.

use super::discs::{Discs, Fault, Pending, Target};
use crate::detect::{
    Surroundings, cushion_gap, detect_ball_ball, detect_ball_cushion, detect_first_cushion,
    detect_from_behind, detect_release,
};
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
        for ball in 0..self.flights.len() {
            self.predict(ball, Target::Nothing);
        }
    }

    /// Finds a ball's next event, and says whether it touches anything but `struck`, which it has just been in contact with.
    #[inline(always)]
    pub(super) fn predict(&mut self, ball: usize, struck: Target) -> bool {
        if self.is_plain { self.predict_plain(ball, struck) } else { self.predict_any(ball, struck) }
    }

    /// Without field and thin walls: every flight is straight, and no cushion holds or hides a ball.
    fn predict_plain(&mut self, ball: usize, struck: Target) -> bool {
        let mut seen = Surroundings::CLEAR;
        let next = self.next_cushion_straight(ball, struck, &mut seen);
        let next = self.next_ball::<true>(ball, struck, next, &mut seen);
        self.schedule(ball, next, &seen)
    }

    #[inline(never)]
    fn predict_any(&mut self, ball: usize, struck: Target) -> bool {
        let mut seen = Surroundings::CLEAR;
        let next = self.next_cushion(ball, struck, &mut seen);
        let next = self.next_ball::<false>(ball, struck, next, &mut seen);
        let next = if self.tracks[ball].is_held() { self.earlier_release(ball, next) } else { next };
        self.schedule(ball, next, &seen)
    }

    #[inline(always)]
    fn schedule(&mut self, ball: usize, next: Pending<S>, seen: &Surroundings<S>) -> bool {
        self.pending[ball] = next;
        self.queue.set(ball, next.time, rank(ball, next.target));
        self.diagnostics.predictions += 1;
        if seen.overlap > S::ZERO {
            self.note_overlap(ball, seen);
        }
        seen.touching
    }

    /// The first cushion that a ball meets on a straight flight. `seen` is what it sees on the way.
    #[inline(always)]
    fn next_cushion_straight(&self, ball: usize, struck: Target, seen: &mut Surroundings<S>) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flights[ball];
        let radius = system.discs[ball].radius;
        let struck = if let Target::Cushion(cushion) = struck { cushion as usize } else { usize::MAX };
        let tolerance = system.tolerance.of(radius);
        match detect_first_cushion(flight, radius, &system.faces, tolerance, struck, seen) {
            Some((cushion, offset)) => {
                Pending { time: flight.start + offset, offset, target: Target::Cushion(cushion as u32) }
            }
            None => Pending::NEVER,
        }
    }

    /// The first cushion that a ball meets: one that holds it, or is the other face of its thin wall, is passed over.
    fn next_cushion(&self, ball: usize, struck: Target, seen: &mut Surroundings<S>) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flights[ball];
        let radius = system.discs[ball].radius;
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
    #[inline(always)]
    fn next_ball<const STRAIGHT: bool>(
        &self,
        ball: usize,
        struck: Target,
        next: Pending<S>,
        seen: &mut Surroundings<S>,
    ) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flights[ball];
        let radius = system.discs[ball].radius;
        let struck = if let Target::Ball(other, _) = struck { other as usize } else { usize::MAX };
        let mut next = next;
        for (other, (their, disc)) in self.flights.iter().zip(&system.discs).enumerate() {
            let radii = radius + disc.radius;
            if other == ball || radii == S::ZERO {
                continue;
            }
            if let Some(offset) = detect_ball_ball::<STRAIGHT, S>(
                flight,
                their,
                radii,
                &system.tolerance,
                other == struck,
                seen,
            ) {
                let start = if flight.start > their.start { flight.start } else { their.start };
                if start + offset < next.time {
                    let target = Target::Ball(other as u32, self.tracks[other].changes);
                    next = Pending { time: start + offset, offset, target };
                }
            }
        }
        next
    }

    #[cold]
    fn note_overlap(&mut self, ball: usize, seen: &Surroundings<S>) {
        let deepest = &mut self.diagnostics.deepest_overlap;
        *deepest = deepest.max(seen.overlap.to_f64());
        if seen.broken {
            self.fault = Some(Fault::Overlap(ball as u32));
        }
    }

    fn past(&self, ball: usize, cushion: u32) -> Past {
        if self.tracks[ball].held_by.contains(&Some(cushion)) {
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
        if back.is_none() || self.system.discs[ball].radius > S::ZERO {
            return false;
        }
        let (track, position) = (&self.tracks[ball], self.flights[ball].position);
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
                detect_from_behind(&self.flights[ball], line, self.system.tolerance.of(S::ZERO))
            }
            Face::Round(_) => None,
        }
    }

    fn earlier_release(&self, ball: usize, next: Pending<S>) -> Pending<S> {
        let system = &*self.system;
        let flight = &self.flights[ball];
        let tolerance = system.tolerance.of(system.discs[ball].radius);
        let mut next = next;
        for cushion in self.tracks[ball].held_by.into_iter().flatten() {
            if let Face::Line(line) = &system.faces.all[cushion as usize] {
                // Twice the tolerance: where it is let go, the ball's foot must no longer count as on the cushion.
                let offset = detect_release(flight, line, tolerance * S::from_f64(2.0));
                next = next.earlier(flight.start, offset, Target::Release(cushion));
            }
        }
        next
    }

    /// The time of the next event. Predicts anew where the first pending one is stale.
    pub(super) fn next_time(&mut self) -> S {
        loop {
            let (ball, time) = self.queue.first();
            match self.pending.get(ball).map(|pending| pending.target) {
                Some(Target::Ball(other, changes)) if self.tracks[other as usize].changes != changes => {
                    self.diagnostics.stale += 1;
                    self.predict(ball, Target::Nothing);
                }
                _ => return time,
            }
        }
    }

    /// Predicts anew where a pending event is stale.
    pub(super) fn refresh(&mut self) {
        for ball in 0..self.pending.len() {
            while let Target::Ball(other, changes) = self.pending[ball].target {
                if self.tracks[other as usize].changes == changes {
                    break;
                }
                self.predict(ball, Target::Nothing);
            }
        }
    }
}

/// The rank of an event among those at the same time: the lower number of its balls.
#[inline(always)]
fn rank(ball: usize, target: Target) -> u32 {
    match target {
        Target::Ball(other, _) if other < ball as u32 => other,
        _ => ball as u32,
    }
}
