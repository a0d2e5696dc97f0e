//! Prediction: a ball's next event, from the flights as they are.

use super::contact::by_place;
use super::{Ahead, Ball, Spheres};
use crate::detect::{
    Crossing, Surroundings, cushion_gap, detect_nose, detect_nose_in_the_air, detect_pocket,
    detect_pocket_from_above, detect_spheres,
};
use crate::engine::interface::Fault;
use crate::engine::queue::{Aim, Pending};
use crate::engine::simulation::Coming;
use crate::flight::{Flight, Motion, SphereFlight};
use crate::geometry::Bounds;
use crate::run::Kind;
use crate::scalar::Scalar;

/// The box around a flight up to a time, so that what lies apart from it need not be looked at.
struct Path<S> {
    until: S,
    bounds: Option<Bounds<S>>,
}

impl<S: Scalar> Path<S> {
    fn new(flight: &SphereFlight<S>, until: S) -> Self {
        let time = until - flight.start();
        let Flight { position, velocity, acceleration, .. } = flight.plan;
        let is_finite = time < S::INFINITY;
        let bounds = is_finite.then(|| Bounds::of_path(position, velocity, acceleration, time));
        Self { until, bounds }
    }

    fn shorten(&mut self, flight: &SphereFlight<S>, until: S) {
        if until < self.until {
            *self = Self::new(flight, until);
        }
    }

    #[inline(always)]
    fn is_apart(&self, bounds: &Bounds<S>, distance: S) -> bool {
        self.bounds.as_ref().is_some_and(|path| path.is_apart(bounds, distance))
    }
}

/// A ball that flies over a pocket drops into it if its centre is lower than this many radii where it comes to the far
/// side: the back of the pocket stops it.
const CAPTURE_HEIGHT: f64 = 1.4;

impl<S: Scalar> Spheres<S> {
    /// Predicts every ball's next event from the flights as they are.
    pub(super) fn predict_all(&mut self) {
        for ball in 0..self.balls.len() {
            self.predict(ball);
        }
    }

    /// Finds a ball's next event.
    pub(super) fn predict(&mut self, ball: usize) {
        self.diagnostics.predictions += 1;
        let motion = self.balls[ball].flight.motion;
        if motion.is_out() {
            self.queue.set(ball, Pending::NEVER);
            return;
        }
        let mut next = self.end_of_flight(ball);
        if motion == Motion::Airborne {
            next = self.next_in_the_air(ball, next);
        } else if !motion.is_still() {
            next = self.next_on_the_cloth(ball, next);
        }
        let next = self.next_ball(ball, next);
        self.queue.set(ball, next);
    }

    fn end_of_flight(&self, ball: usize) -> Pending<S, Ahead> {
        let Ball { flight, .. } = &self.balls[ball];
        if flight.length < S::INFINITY {
            Pending { time: flight.start() + flight.length, offset: flight.length, target: Ahead::End }
        } else {
            Pending::NEVER
        }
    }

    fn next_on_the_cloth(&self, ball: usize, next: Pending<S, Ahead>) -> Pending<S, Ahead> {
        let system = &*self.system;
        let Ball { flight, sphere, .. } = &self.balls[ball];
        let tolerance = system.tolerance.of(sphere.radius);
        let reach = system.noses[ball].reach;
        let (start, mut next) = (flight.start(), next);
        let clearance = reach + tolerance * S::from_f64(2.0);
        let mut path = Path::new(flight, next.time);
        for &number in &system.by_length {
            if path.is_apart(&system.boxes[number as usize], clearance) {
                continue;
            }
            let (face, mut seen) = (&system.faces[number as usize], Surroundings::CLEAR);
            let offset = detect_nose(flight, reach, face, tolerance, &mut seen);
            next = self.sooner(ball, next, start, offset, Ahead::Cushion(number));
            path.shorten(flight, next.time);
        }
        for (number, hole) in system.holes.iter().enumerate() {
            if path.is_apart(&hole.bounds(), clearance) {
                continue;
            }
            let offset = detect_pocket(flight, hole, tolerance);
            next = self.sooner(ball, next, start, offset, Ahead::Pocket(number as u32));
        }
        next
    }

    fn next_in_the_air(&self, ball: usize, next: Pending<S, Ahead>) -> Pending<S, Ahead> {
        let system = &*self.system;
        let Ball { flight, sphere, .. } = &self.balls[ball];
        let tolerance = system.tolerance.of(sphere.radius);
        let (start, mut next) = (flight.start(), next);
        for (number, face) in system.faces.iter().enumerate() {
            let height = system.noses[ball].height;
            let met = detect_nose_in_the_air(flight, sphere.radius, height, face, tolerance);
            let ahead = match met {
                Some((_, Crossing::Over)) => Ahead::Over(number as u32),
                _ => Ahead::Cushion(number as u32),
            };
            next = self.sooner(ball, next, start, met.map(|(offset, _)| offset), ahead);
        }
        let highest = sphere.radius * S::from_f64(CAPTURE_HEIGHT);
        for (number, hole) in system.holes.iter().enumerate() {
            let left = detect_pocket_from_above(flight, hole).filter(|(_, height)| *height <= highest);
            let offset = left.map(|(offset, _)| offset);
            next = self.sooner(ball, next, start, offset, Ahead::Pocket(number as u32));
        }
        next
    }

    /// The first ball that a ball meets, if it does so before its event `next`.
    fn next_ball(&mut self, ball: usize, next: Pending<S, Ahead>) -> Pending<S, Ahead> {
        let Ball { flight, sphere, .. } = self.balls[ball];
        let mut next = next;
        let mut seen = Surroundings::CLEAR;
        for other in 0..self.balls.len() {
            let their = &self.balls[other];
            if other == ball || their.flight.motion.is_out() {
                continue;
            }
            let radii = [sphere.radius, their.sphere.radius];
            if let Some(offset) =
                detect_spheres(&flight, &their.flight, radii, &self.system.tolerance, next.time, &mut seen)
            {
                let start = flight.plan.later_start(&their.flight.plan);
                next = self.sooner(
                    ball,
                    next,
                    start,
                    Some(offset),
                    Ahead::Ball(other as u32, their.track.changes),
                );
            }
        }
        self.note_overlap(ball, seen.overlap, seen.broken);
        next
    }

    /// The earlier of two events of a ball. At one time balls come before cushions, of several balls the first in order of
    /// place, and of several cushions the one that the ball moves into fastest: so their numbers do not matter.
    fn sooner(
        &self,
        ball: usize,
        next: Pending<S, Ahead>,
        start: S,
        offset: Option<S>,
        target: Ahead,
    ) -> Pending<S, Ahead> {
        let Some(offset) = offset else { return next };
        let time = start + offset;
        let comes_first = || match (target, next.target) {
            (Ahead::Cushion(new), Ahead::Cushion(old)) => {
                let position = self.balls[ball].flight.plan.position_after(offset);
                let velocity = self.balls[ball].flight.plan.velocity_after(offset);
                let speed = |face: u32| -self.system.faces[face as usize].normal_at(position).0.dot(velocity);
                speed(new) > speed(old)
            }
            (Ahead::Ball(new, _), Ahead::Ball(old, _)) => {
                let place = |ball: u32| {
                    let flight = &self.balls[ball as usize].flight;
                    flight.position_after(time - flight.start())
                };
                by_place(place(new), place(old)).is_lt()
            }
            (new, old) => new.rank(ball).0 < old.rank(ball).0,
        };
        if time < next.time || (time == next.time && comes_first()) {
            Pending { time, offset, target }
        } else {
            next
        }
    }

    /// What a ball's pending event is.
    pub(super) fn coming(&self, ball: usize, now: S) -> Coming<S> {
        let Pending { time, target, .. } = *self.queue.pending(ball);
        let Ball { flight, sphere, .. } = &self.balls[ball];
        let position = flight.position_after(now - flight.start());
        let none = Coming { ball, kind: None, other: None, cushion: None, time, gap: None };
        match target {
            Ahead::Nothing => none,
            Ahead::Ball(other, _) => {
                let their = &self.balls[other as usize];
                let separation = their.flight.position_after(now - their.flight.start()) - position;
                let gap = separation.norm() - sphere.radius - their.sphere.radius;
                Coming { kind: Some(Kind::BallBall), other: Some(other), gap: Some(gap), ..none }
            }
            Ahead::Cushion(cushion) => {
                let (face, reach) = (&self.system.faces[cushion as usize], self.system.noses[ball].reach);
                let gap = cushion_gap(position.plan(), reach, face, &self.system.tolerance);
                Coming { kind: Some(Kind::BallCushion), cushion: Some(cushion), gap, ..none }
            }
            Ahead::Over(cushion) => Coming { kind: Some(Kind::OffTable), cushion: Some(cushion), ..none },
            Ahead::Pocket(pocket) => {
                Coming { kind: Some(Kind::BallPocket), cushion: Some(self.system.place_of(pocket)), ..none }
            }
            Ahead::End => Coming { kind: Some(self.kind_of_end(ball)), ..none },
        }
    }

    /// Notes an overlap.
    pub(super) fn note_overlap(&mut self, ball: usize, overlap: S, is_broken: bool) {
        let deepest = &mut self.diagnostics.deepest_overlap;
        *deepest = deepest.max(overlap.to_f64());
        if is_broken {
            self.fault = Some(Fault::Overlap(ball as u32));
        }
    }
}
