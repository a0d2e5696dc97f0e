//! Sums over all balls: energy and momentum, and the audit of a run's energy.

use super::discs::Discs;
use super::interface::Fault;
use crate::flight::State;
use crate::geometry::Vec2;
use crate::scalar::Scalar;

impl<S: Scalar> Discs<S> {
    /// Position and velocity of a ball at a time not before its last event; on a periodic table in its first image.
    pub fn state_at(&self, ball: usize, time: S) -> State<S> {
        let flight = self.flight(ball);
        let State { position, velocity } = flight.state_after(time - flight.start);
        State { position: self.system.wrapped(position, self.balls[ball].rounds), velocity }
    }

    /// Energy of all balls: kinetic, and potential in the field, also of what they have gone round a periodic table.
    pub fn energy_at(&self, time: S) -> f64 {
        let mut sum = S::ZERO;
        for ball in 0..self.balls.len() {
            let State { position, velocity } = self.state_at(ball, time);
            let kinetic = S::from_f64(0.5) * velocity.norm_squared();
            let gone = if self.has_field { position + self.round(ball) } else { position };
            sum += self.disc(ball).mass * (kinetic - self.system.field.dot(gone));
        }
        sum.to_f64()
    }

    /// The way that a ball has gone round a periodic table since the run began.
    fn round(&self, ball: usize) -> Vec2<S> {
        let (before, now) = (self.rest[ball].track.image, self.balls[ball].rounds);
        self.system.shift([0, 1].map(|axis| before[axis].wrapping_add(i32::from(now[axis]))))
    }

    /// Sums the energy and notes how far it is from what the laws account for.
    pub(super) fn sum_energy(&mut self, time: S) {
        let energy = self.energy_at(time);
        let drift = (energy - self.diagnostics.initial_energy + self.diagnostics.energy_loss).abs();
        if !energy.is_finite() {
            self.fault = Some(Fault::NotFinite);
        }
        self.diagnostics.final_energy = energy;
        self.diagnostics.energy_drift = self.diagnostics.energy_drift.max(drift);
    }

    /// Notes how deep two balls that collide overlap; more than the contact tolerance is a fault.
    #[inline(always)]
    pub(super) fn audit_distance(&mut self, ball: usize, distance: S, radii: S) {
        let overlap = radii - distance;
        if overlap.to_f64() > self.diagnostics.deepest_overlap {
            self.note_overlap(ball, overlap, overlap > self.system.tolerance.of(radii));
        }
    }

    /// Notes an overlap.
    #[cold]
    pub(super) fn note_overlap(&mut self, ball: usize, overlap: S, is_broken: bool) {
        let deepest = &mut self.diagnostics.deepest_overlap;
        *deepest = deepest.max(overlap.to_f64());
        if is_broken {
            self.fault = Some(Fault::Overlap(ball as u32));
        }
    }
}
