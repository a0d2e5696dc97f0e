//! Runs taken event by event.

use crate::errors::{problem, simulation_error};
use crate::interrupt::interruptible;
use crate::run::Run;
use crate::states::array;
use carom::engine::{self, Coming};
use carom::flight::Flight;
use carom::run::{Event, Kind, Log, Observer, SimulationError, Status};
use carom::scenario::schema::Method;
use carom::scenario::{Scenario, System};
use carom::simulate::{limits_of, log_of};
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::VecDeque;
use std::sync::Arc;

/// Steps between two looks for Ctrl-C.
const SLICE: u64 = 50_000;

type Outcome = Result<(), SimulationError>;

/// A run under way.
#[pyclass(module = "carom._engine")]
pub struct Simulation {
    scenario: Scenario,
    simulation: engine::Simulation<f64>,
    log: Log<f64>,
    /// Events that have happened, in a cluster, and were not handed out yet.
    fresh: VecDeque<Event<f64>>,
}

impl Simulation {
    pub fn new(scenario: Scenario, until: Option<Kind>) -> PyResult<Self> {
        if scenario.method != Method::Exact {
            return Err(problem("method", "only the exact method goes event by event"));
        }
        let mut log = log_of(&scenario);
        let system = Arc::new(System::new(&scenario));
        let simulation = engine::Simulation::new(system, limits_of(&scenario, until), &mut log);
        Ok(Self { scenario, simulation, log, fresh: VecDeque::new() })
    }

    /// Goes on without the interpreter's lock; events not handed out before are passed over.
    fn go_on(
        &mut self,
        py: Python<'_>,
        go_on: impl FnOnce(&mut engine::Simulation<f64>, &mut Log<f64>, &mut dyn FnMut() -> bool) -> Outcome
        + Send,
    ) -> PyResult<()> {
        self.fresh.clear();
        let (simulation, log) = (&mut self.simulation, &mut self.log);
        interruptible(py, |interrupted| go_on(simulation, log, interrupted))?
            .map_err(|error| simulation_error(&error, &self.scenario))
    }

    fn row<'py>(&self, py: Python<'py>, index: u64, event: &Event<f64>) -> PyResult<Bound<'py, PyDict>> {
        let row = PyDict::new(py);
        row.set_item("index", index)?;
        row.set_item("time", event.time)?;
        row.set_item("kind", event.kind.name())?;
        row.set_item("ball_a", self.ball(event.ball_a))?;
        row.set_item("ball_b", event.ball_b.map(|ball| self.ball(ball)))?;
        row.set_item("cushion", event.cushion.map(|cushion| self.cushion(cushion)))?;
        row.set_item("x", event.point.x)?;
        row.set_item("y", event.point.y)?;
        row.set_item("normal_x", event.normal.x)?;
        row.set_item("normal_y", event.normal.y)?;
        row.set_item("closing_speed", event.closing_speed)?;
        row.set_item("impulse", event.impulse)?;
        row.set_item("cluster", event.cluster)?;
        Ok(row)
    }

    fn candidate<'py>(&self, py: Python<'py>, coming: &Coming<f64>) -> PyResult<Bound<'py, PyDict>> {
        let row = PyDict::new(py);
        row.set_item("ball", self.ball(coming.ball as u32))?;
        row.set_item("kind", coming.kind.map(Kind::name))?;
        row.set_item("ball_b", coming.other.map(|ball| self.ball(ball)))?;
        row.set_item("cushion", coming.cushion.map(|cushion| self.cushion(cushion)))?;
        row.set_item("time", coming.kind.map(|_| coming.time))?;
        row.set_item("gap", coming.gap)?;
        Ok(row)
    }

    fn ball(&self, index: u32) -> &str {
        &self.simulation.system().ball_ids[index as usize]
    }

    fn cushion(&self, index: u32) -> &str {
        &self.simulation.system().cushion_ids[index as usize]
    }
}

#[pymethods]
impl Simulation {
    /// The time that the simulation has come to.
    #[getter]
    fn time(&self) -> f64 {
        self.simulation.time()
    }

    /// How the run ended; None while it goes on.
    #[getter]
    fn status(&self) -> Option<&'static str> {
        self.simulation.status().map(Status::name)
    }

    /// The next event as a row; None when the run has ended before another one.
    fn step<'py>(&mut self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let mut both = Both { log: &mut self.log, fresh: &mut self.fresh };
        while both.fresh.is_empty() {
            let goes_on = self.simulation.step(&mut both);
            if !goes_on.map_err(|error| simulation_error(&error, &self.scenario))? {
                break;
            }
        }
        let index = self.simulation.diagnostics().total_events() - self.fresh.len() as u64;
        let event = self.fresh.pop_front();
        event.map(|event| self.row(py, index, &event)).transpose()
    }

    /// Goes on to a time, or to the end of the run if that is earlier.
    fn run_until(&mut self, py: Python<'_>, time: f64) -> PyResult<()> {
        self.go_on(py, |simulation, log, interrupted| {
            while simulation.advance_until(time, SLICE, log)? {
                if interrupted() {
                    return Ok(());
                }
            }
            simulation.run_until(time, log)
        })
    }

    /// What each ball is about to do, a row each.
    fn candidates<'py>(&mut self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let coming = self.simulation.candidates();
        coming.iter().map(|coming| self.candidate(py, coming)).collect()
    }

    /// The centres now, (n_balls, 2).
    fn positions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        array(py, self.simulation.state(), |state| state.position)
    }

    /// The velocities now, (n_balls, 2).
    fn velocities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        array(py, self.simulation.state(), |state| state.velocity)
    }

    /// Ends the run here.
    fn stop(&mut self) {
        self.simulation.stop(Status::Stopped);
    }

    /// Goes on to the end, unless the run has ended, and gives the run.
    fn finish(&mut self, py: Python<'_>) -> PyResult<Run> {
        self.go_on(py, |simulation, log, interrupted| {
            while simulation.advance(SLICE, log)? && !interrupted() {}
            Ok(())
        })?;
        Ok(Run::new(self.scenario.clone(), self.simulation.clone().finish(self.log.clone())))
    }
}

/// Keeps events twice: in the log, and to hand them out.
struct Both<'a> {
    log: &'a mut Log<f64>,
    fresh: &'a mut VecDeque<Event<f64>>,
}

impl Observer<f64> for Both<'_> {
    fn event(&mut self, event: &Event<f64>) {
        self.log.event(event);
        self.fresh.push_back(*event);
    }

    fn flight(&mut self, ball: usize, flight: &Flight<f64>) {
        self.log.flight(ball, flight);
    }
}
