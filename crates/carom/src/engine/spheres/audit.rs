//! The energy of the balls, and what contacts and the cloth take of it.

use super::{Ball, Spheres};
use crate::engine::interface::Fault;
use crate::flight::SphereFlight;
use crate::model::Twist;
use crate::scalar::Scalar;

impl<S: Scalar> Spheres<S> {
    /// Kinetic energy, spin included, and that of height, of the balls in play.
    pub(super) fn energy_at(&self, time: S) -> f64 {
        let mut sum = S::ZERO;
        for ball in 0..self.balls.len() {
            sum += self.ball_energy(ball, time);
        }
        sum.to_f64()
    }

    fn ball_energy(&self, ball: usize, time: S) -> S {
        let Ball { flight, sphere, .. } = &self.balls[ball];
        if flight.motion.is_out() {
            return S::ZERO;
        }
        let state = flight.state_after(time - flight.start());
        sphere.kinetic_energy(&state.twist) + self.system.height_energy(sphere, state.position)
    }

    /// What the cloth did to the energy of a ball on the flight that it is on, up to a time.
    fn change_under_way(&self, ball: usize, time: S) -> f64 {
        let start = self.balls[ball].flight.start();
        (self.ball_energy(ball, time) - self.ball_energy(ball, start)).to_f64()
    }

    /// Accounts for what the cloth took from a ball on the flight that it is on, up to a time.
    pub(super) fn account_for_friction(&mut self, ball: usize, time: S) {
        self.note_change(self.change_under_way(ball, time));
    }

    /// Accounts for what a contact did to the energy of balls that moved so before it and then begin these flights.
    pub(super) fn account_for_contact(&mut self, before: &[Twist<S>], flights: &[(usize, SphereFlight<S>)]) {
        let mut change = S::ZERO;
        for (before, (ball, flight)) in before.iter().zip(flights) {
            let sphere = &self.balls[*ball].sphere;
            let after = sphere.kinetic_energy(&flight.state_after(S::ZERO).twist);
            change += after - sphere.kinetic_energy(before);
        }
        self.note_change(change.to_f64());
    }

    /// What is lost counts as the law's; a gain is none of any law's.
    pub(super) fn note_change(&mut self, change: f64) {
        self.diagnostics.energy_loss -= change;
        if change > 0.0 {
            self.diagnostics.energy_gain = self.diagnostics.energy_gain.max(change);
        }
    }

    /// Sums the energy and notes how far it is from what is accounted for.
    pub(super) fn sum_energy(&mut self, time: S) {
        let energy = self.energy_at(time);
        let under_way: f64 = (0..self.balls.len()).map(|ball| self.change_under_way(ball, time)).sum();
        let diagnostics = &mut self.diagnostics;
        let drift = (energy - diagnostics.initial_energy + diagnostics.energy_loss - under_way).abs();
        if !energy.is_finite() {
            self.fault = Some(Fault::NotFinite);
        }
        diagnostics.final_energy = energy;
        diagnostics.energy_drift = diagnostics.energy_drift.max(drift);
    }
}
