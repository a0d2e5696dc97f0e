//! Runs taken event by event.

use crate::errors::{discs_have_no_spin, problem, simulation_error};
use crate::interrupt::interruptible;
use crate::run::Run;
use crate::states::{Moving, array};
use carom::engine::Coming;
use carom::run::{Event, Kind, Log, SimulationError, Status};
use carom::scenario::Scenario;
use carom::scenario::schema::Method;
use carom::simulate::{AnySimulation, Simulated, SimulationOf};
use carom::with_any;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::VecDeque;

/// Steps between two looks for Ctrl-C.
const SLICE: u64 = 50_000;

type Outcome = Result<(), SimulationError>;
type Spins<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<i8>>);

/// A run under way.
#[pyclass(module = "carom._engine")]
pub struct Simulation {
    scenario: Scenario,
    simulation: AnySimulation,
    /// Events that have happened, such as those of a cluster or the strike of a cue, and were not handed out yet.
    fresh: VecDeque<Event<f64>>,
}

impl Simulation {
    pub fn new(scenario: Scenario, until: Option<Kind>) -> PyResult<Self> {
        if scenario.method != Method::Exact {
            return Err(problem("method", "only the exact method goes event by event"));
        }
        let mut fresh = VecDeque::new();
        let simulation = AnySimulation::start(&scenario, until, &mut fresh);
        Ok(Self { scenario, simulation, fresh })
    }

    fn row<'py>(&self, py: Python<'py>, index: u64, event: &Event<f64>) -> PyResult<Bound<'py, PyDict>> {
        let is_pocket = event.kind == Kind::BallPocket;
        let place = event.cushion.map(|cushion| self.cushion(cushion));
        let row = PyDict::new(py);
        row.set_item("index", index)?;
        row.set_item("time", event.time)?;
        row.set_item("kind", event.kind.name())?;
        row.set_item("ball_a", self.ball(event.ball_a))?;
        row.set_item("ball_b", event.ball_b.map(|ball| self.ball(ball)))?;
        row.set_item("cushion", place.filter(|_| !is_pocket))?;
        row.set_item("x", event.point.x)?;
        row.set_item("y", event.point.y)?;
        row.set_item("normal_x", event.normal.x)?;
        row.set_item("normal_y", event.normal.y)?;
        row.set_item("closing_speed", event.closing_speed)?;
        row.set_item("impulse", event.impulse)?;
        row.set_item("cluster", event.cluster)?;
        row.set_item("pocket", place.filter(|_| is_pocket))?;
        Ok(row)
    }

    fn candidate<'py>(&self, py: Python<'py>, coming: &Coming<f64>) -> PyResult<Bound<'py, PyDict>> {
        let is_pocket = coming.kind == Some(Kind::BallPocket);
        let place = coming.cushion.map(|cushion| self.cushion(cushion));
        let row = PyDict::new(py);
        row.set_item("ball", self.ball(coming.ball as u32))?;
        row.set_item("kind", coming.kind.map(Kind::name))?;
        row.set_item("ball_b", coming.other.map(|ball| self.ball(ball)))?;
        row.set_item("cushion", place.filter(|_| !is_pocket))?;
        row.set_item("pocket", place.filter(|_| is_pocket))?;
        row.set_item("time", coming.kind.map(|_| coming.time))?;
        row.set_item("gap", coming.gap)?;
        Ok(row)
    }

    fn ball(&self, index: u32) -> &str {
        let ids = with_any!(&self.simulation, inner => &inner.0.system().ball_ids);
        &ids[index as usize]
    }

    fn cushion(&self, index: u32) -> &str {
        let ids = with_any!(&self.simulation, inner => &inner.0.system().cushion_ids);
        &ids[index as usize]
    }
}

/// The next event, if another one happens before the run ends.
fn step<D: Simulated>(
    (simulation, log): &mut (SimulationOf<D>, Log<f64, D>),
    fresh: &mut VecDeque<Event<f64>>,
) -> Result<u64, SimulationError> {
    while fresh.is_empty() && simulation.step(&mut (&mut *log, &mut *fresh))? {}
    Ok(simulation.diagnostics().total_events() - fresh.len() as u64)
}

fn run_until<D: Simulated>(
    (simulation, log): &mut (SimulationOf<D>, Log<f64, D>),
    time: f64,
    interrupted: &mut dyn FnMut() -> bool,
) -> Outcome {
    while simulation.advance_until(time, SLICE, log)? {
        if interrupted() {
            return Ok(());
        }
    }
    simulation.run_until(time, log)
}

fn run_on<D: Simulated>(
    (simulation, log): &mut (SimulationOf<D>, Log<f64, D>),
    interrupted: &mut dyn FnMut() -> bool,
) -> Outcome {
    while simulation.advance(SLICE, log)? && !interrupted() {}
    Ok(())
}

#[pymethods]
impl Simulation {
    /// The time that the simulation has come to.
    #[getter]
    fn time(&self) -> f64 {
        with_any!(&self.simulation, inner => inner.0.time())
    }

    /// How the run ended; None while it goes on.
    #[getter]
    fn status(&self) -> Option<&'static str> {
        with_any!(&self.simulation, inner => inner.0.status()).map(Status::name)
    }

    /// The next event as a row; None when the run has ended before another one.
    fn step<'py>(&mut self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let fresh = &mut self.fresh;
        let index = with_any!(&mut self.simulation, inner => step(inner, fresh))
            .map_err(|error| simulation_error(&error, &self.scenario))?;
        let event = self.fresh.pop_front();
        event.map(|event| self.row(py, index, &event)).transpose()
    }

    /// Goes on to a time, or to the end of the run if that is earlier; events not handed out before are passed over.
    fn run_until(&mut self, py: Python<'_>, time: f64) -> PyResult<()> {
        self.fresh.clear();
        let simulation = &mut self.simulation;
        interruptible(py, |interrupted| with_any!(simulation, inner => run_until(inner, time, interrupted)))?
            .map_err(|error| simulation_error(&error, &self.scenario))
    }

    /// What each ball is about to do, a row each.
    fn candidates<'py>(&mut self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let coming = with_any!(&mut self.simulation, inner => inner.0.candidates());
        coming.iter().map(|coming| self.candidate(py, coming)).collect()
    }

    /// The centres now, (n_balls, 2), or (n_balls, 3) on a cloth.
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        with_any!(&self.simulation, inner => array(py, inner.0.state(), Moving::position))
    }

    /// The velocities now, (n_balls, 2), or (n_balls, 3) on a cloth.
    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        with_any!(&self.simulation, inner => array(py, inner.0.state(), Moving::velocity))
    }

    /// The spins now, (n_balls, 3), and the codes of the motions, (n_balls,), on a cloth.
    fn spins<'py>(&self, py: Python<'py>) -> PyResult<Spins<'py>> {
        let AnySimulation::OnCloth(inner) = &self.simulation else { return Err(discs_have_no_spin()) };
        let state = inner.0.state();
        let motions = PyArray1::from_iter(py, state.iter().map(|ball| ball.motion as i8));
        Ok((array(py, state, Moving::spin)?, motions))
    }

    /// Ends the run here.
    fn stop(&mut self) {
        with_any!(&mut self.simulation, inner => inner.0.stop(Status::Stopped));
    }

    /// Goes on to the end, unless the run has ended, and gives the run.
    fn finish(&mut self, py: Python<'_>) -> PyResult<Run> {
        self.fresh.clear();
        let simulation = &mut self.simulation;
        interruptible(py, |interrupted| with_any!(simulation, inner => run_on(inner, interrupted)))?
            .map_err(|error| simulation_error(&error, &self.scenario))?;
        let run = with_any!(&self.simulation, inner => {
            let (simulation, log) = (**inner).clone();
            simulation.finish(log).into()
        });
        Ok(Run::new(self.scenario.clone(), run))
    }
}
