//! A ball that leaves the game: into a pocket, or off the table.

use super::{Ball, Spheres};
use crate::flight::{Motion, SphereFlight, SphereState};
use crate::run::{Event, Kind, Observer, OnCloth};
use crate::scalar::Scalar;

impl<S: Scalar> Spheres<S> {
    /// A ball's centre comes over a pocket, or a ball that flew low over one comes to its back.
    pub(super) fn drop_into(
        &mut self,
        ball: usize,
        pocket: u32,
        time: S,
        offset: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        let state = self.balls[ball].flight.state_after(offset);
        self.capture(ball, pocket, time, &state, observer);
    }

    /// A ball is in a pocket.
    pub(super) fn capture(
        &mut self,
        ball: usize,
        pocket: u32,
        time: S,
        state: &SphereState<S>,
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        let event = Event {
            cushion: Some(self.system.place_of(pocket)),
            ..self.event_at(ball, time, Kind::BallPocket, state.position)
        };
        self.retire(ball, Motion::Pocketed, time, state, observer);
        self.emit(&event, observer);
    }

    /// A ball flies over a cushion.
    pub(super) fn leave_table(
        &mut self,
        ball: usize,
        cushion: u32,
        time: S,
        offset: S,
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        let state = self.balls[ball].flight.state_after(offset);
        let event =
            Event { cushion: Some(cushion), ..self.event_at(ball, time, Kind::OffTable, state.position) };
        self.retire(ball, Motion::OffTable, time, &state, observer);
        self.emit(&event, observer);
    }

    fn retire(
        &mut self,
        ball: usize,
        motion: Motion,
        time: S,
        state: &SphereState<S>,
        observer: &mut impl Observer<S, OnCloth>,
    ) {
        let flight = SphereFlight::still(motion, time, state.position);
        let Ball { sphere, .. } = self.balls[ball];
        let energy = sphere.kinetic_energy(&state.twist) + self.system.height_energy(&sphere, state.position);
        self.diagnostics.account(-energy.to_f64(), energy.to_f64());
        self.begin_flights(&[(ball, flight)], observer);
    }
}
