//! Runs that are observed, and what was found.

use crate::columns::event_columns;
use crate::errors::{problem, run_error, scenario_error, simulation_error};
use crate::run::Run;
use crate::scenario::{Scenario, options, with_options};
use carom::geometry::Vec2;
use carom::observe::{Column, Curve, Observables, Quantity, Request, Results, Snapshot};
use carom::scenario::Scenario as Checked;
use carom::simulate::{self as observed, Checkpoint, CheckpointError, ObservedError, Pause, Plan};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};

/// A snapshot: time, collisions, size, which axes are periodic, positions, velocities, radii and masses.
type Frame<'py> = (
    f64,
    u64,
    [f64; 2],
    [bool; 2],
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
);

/// A run under way that is observed, and hands out snapshots and events.
#[pyclass(module = "carom._engine")]
pub struct ObservedRun {
    /// None when the run was finished or broke.
    run: Option<observed::ObservedRun>,
    note: String,
}

#[pymethods]
impl ObservedRun {
    /// A run of a scenario from time zero; options, what is to be observed and the plan are JSON texts.
    #[staticmethod]
    fn start(
        py: Python<'_>,
        scenario: &Scenario,
        options_json: &str,
        requests_json: &str,
        plan_json: &str,
    ) -> PyResult<Self> {
        let (scenario, until) = with_options(scenario.inner(), options_json)?;
        let bad = |error: serde_json::Error| problem("observe", &error.to_string());
        let requests: Vec<Request> = serde_json::from_str(requests_json).map_err(bad)?;
        let plan: Plan = serde_json::from_str(plan_json).map_err(bad)?;
        let observables =
            Observables::new(&requests).map_err(|error| problem("observe", &error.to_string()))?;
        let run = py
            .detach(|| observed::ObservedRun::new(&scenario, until, observables, plan))
            .map_err(|error| observed_error(error, &scenario))?;
        Ok(Self { run: Some(run), note: String::new() })
    }

    /// Goes on from a checkpoint; the options are new ends of the run, as JSON text.
    #[staticmethod]
    fn resume(py: Python<'_>, checkpoint: &[u8], options_json: &str) -> PyResult<Self> {
        let (values, _) = options(options_json)?;
        let resumed = py.detach(|| {
            let checkpoint = Checkpoint::from_bytes(checkpoint)?;
            let note = checkpoint.note().to_owned();
            Ok((observed::ObservedRun::resume(checkpoint, &values)?, note))
        });
        let (run, note) = resumed.map_err(checkpoint_error)?;
        Ok(Self { run: Some(run), note })
    }

    /// The note that the checkpoint had with it; empty in a run from time zero.
    #[getter]
    fn note(&self) -> &str {
        &self.note
    }

    /// The scenario as it is run.
    fn scenario(&self) -> PyResult<Scenario> {
        Ok(Scenario::new(self.run()?.scenario().clone()))
    }

    /// The collisions and the time at which it ends, where they are given.
    fn ends(&self) -> PyResult<(Option<u64>, Option<f64>)> {
        let scenario = self.run()?.scenario();
        Ok((scenario.collisions, scenario.duration))
    }

    /// Goes on to the next pause, without the interpreter's lock: "progress", "snapshot", "events" or "ended".
    fn advance(&mut self, py: Python<'_>) -> PyResult<&'static str> {
        // A run that breaks, or panics, is not put back: it must not be written down.
        let mut run = self.run.take().ok_or_else(gone)?;
        let pause = py.detach(|| run.advance()).map_err(|error| observed_error(error, run.scenario()))?;
        self.run = Some(run);
        Ok(match pause {
            Pause::Progress => "progress",
            Pause::Snapshot => "snapshot",
            Pause::Events => "events",
            Pause::Ended => "ended",
        })
    }

    /// Time, collisions and samples so far.
    fn progress(&self) -> PyResult<(f64, u64, u64)> {
        let now = self.run()?.progress();
        Ok((now.time, now.collisions, now.samples))
    }

    /// The discs now.
    fn snapshot<'py>(&mut self, py: Python<'py>) -> PyResult<Frame<'py>> {
        let run = self.run_mut()?;
        let collisions = run.progress().collisions;
        let Snapshot { time, size, periods, positions, velocities, radii, masses } = run.snapshot();
        let [radii, masses] = [radii, masses].map(|values| PyArray1::from_slice(py, values));
        let vectors = |values: &[Vec2<f64>]| {
            let numbers: Vec<f64> = values.iter().flat_map(|vector| vector.to_f64()).collect();
            PyArray1::from_vec(py, numbers).reshape([values.len(), 2])
        };
        Ok((time, collisions, size, periods, vectors(positions)?, vectors(velocities)?, radii, masses))
    }

    /// The event columns of the piece that is handed out.
    fn events<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let run = self.run()?;
        let (events, first) = run.events();
        event_columns(py, events, first, run.simulation().system().cushion_ids.len())
    }

    /// The ids of the balls, and those of the cushions.
    fn ids(&self) -> PyResult<(Vec<String>, Vec<String>)> {
        let system = self.run()?.simulation().system();
        Ok((system.ball_ids.clone(), system.cushion_ids.clone()))
    }

    /// How many snapshots and how many events were handed out.
    fn handed_out(&self) -> PyResult<(u64, u64)> {
        Ok(self.run()?.handed_out())
    }

    /// The run as it is now, as bytes.
    fn checkpoint<'py>(&self, py: Python<'py>, note: &str) -> PyResult<Bound<'py, PyBytes>> {
        let run = self.run()?;
        let bytes = py.detach(|| run.checkpoint(note)).map_err(checkpoint_error)?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Breaks the run off.
    fn stop(&mut self) -> PyResult<()> {
        self.run_mut()?.stop();
        Ok(())
    }

    /// The run, and what each observable found. Nothing is left here.
    fn finish<'py>(&mut self, py: Python<'py>) -> PyResult<(Run, Bound<'py, PyList>)> {
        let run = self.run.take().ok_or_else(gone)?;
        let scenario = run.scenario().clone();
        let (run, observables) = run.finish().map_err(|error| observed_error(error, &scenario))?;
        let rows = observables.results().iter().map(|found| row(py, found)).collect::<PyResult<Vec<_>>>()?;
        Ok((Run::new(scenario, run.into()), PyList::new(py, rows)?))
    }
}

impl ObservedRun {
    fn run(&self) -> PyResult<&observed::ObservedRun> {
        self.run.as_ref().ok_or_else(gone)
    }

    fn run_mut(&mut self) -> PyResult<&mut observed::ObservedRun> {
        self.run.as_mut().ok_or_else(gone)
    }
}

fn gone() -> PyErr {
    run_error("the run was finished already, or it broke")
}

fn checkpoint_error(error: CheckpointError) -> PyErr {
    match error {
        CheckpointError::Scenario(error) => scenario_error(error),
        other => run_error(&other.to_string()),
    }
}

fn observed_error(error: ObservedError, scenario: &Checked) -> PyErr {
    match error {
        ObservedError::Unfit(unfit) => problem(&unfit.place, &unfit.message),
        ObservedError::Simulation(error) => simulation_error(&error, scenario),
        error @ (ObservedError::Observe(_) | ObservedError::TooShort { .. }) => {
            problem("observe", &error.to_string())
        }
    }
}

fn row<'py>(py: Python<'py>, results: &Results) -> PyResult<Bound<'py, PyDict>> {
    let row = PyDict::new(py);
    row.set_item("name", results.name)?;
    row.set_item("quantities", all(&results.quantities, |this| quantity(py, this))?)?;
    row.set_item("curves", all(&results.curves, |this| curve(py, this))?)?;
    Ok(row)
}

fn all<'py, T>(
    values: &[T],
    each: impl Fn(&T) -> PyResult<Bound<'py, PyDict>>,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    values.iter().map(each).collect()
}

fn quantity<'py>(py: Python<'py>, quantity: &Quantity) -> PyResult<Bound<'py, PyDict>> {
    let row = PyDict::new(py);
    row.set_item("name", quantity.name)?;
    row.set_item("value", quantity.value)?;
    row.set_item("error", quantity.error)?;
    row.set_item("unit", quantity.unit)?;
    row.set_item("description", quantity.description)?;
    row.set_item("expected", quantity.expected)?;
    Ok(row)
}

fn curve<'py>(py: Python<'py>, curve: &Curve) -> PyResult<Bound<'py, PyDict>> {
    let row = PyDict::new(py);
    row.set_item("name", curve.name)?;
    row.set_item("columns", all(&curve.columns, |this| column(py, this))?)?;
    Ok(row)
}

fn column<'py>(py: Python<'py>, column: &Column) -> PyResult<Bound<'py, PyDict>> {
    let row = PyDict::new(py);
    row.set_item("name", column.name)?;
    row.set_item("unit", column.unit)?;
    row.set_item("description", column.description)?;
    row.set_item("values", PyArray1::from_slice(py, &column.values))?;
    Ok(row)
}
