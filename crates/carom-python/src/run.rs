//! Runs.

use crate::columns::{event_columns, step_columns};
use crate::errors::{file_error, problem, query_error, run_error, scenario_error, simulation_error};
use crate::interrupt::interruptible;
use crate::scenario::{Scenario, options};
use crate::states::vectors;
use carom::run::{self, Digest, Kind, PHYSICS_VERSION, QueryError};
use carom::scenario::Scenario as Checked;
use carom::simulate;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Value, json};

type States<'py> = (Bound<'py, PyArray3<f64>>, Bound<'py, PyArray3<f64>>);

/// A computed run, with the scenario as it was run.
#[pyclass(frozen, module = "carom._engine")]
pub struct Run {
    scenario: Checked,
    run: run::Run<f64>,
}

impl Run {
    pub fn new(scenario: Checked, run: run::Run<f64>) -> Self {
        Self { scenario, run }
    }

    /// A quantity at each of some times, computed without the interpreter's lock.
    fn at<T: Send>(
        &self,
        py: Python<'_>,
        times: &PyReadonlyArray1<'_, f64>,
        quantity: impl Fn(f64) -> Result<T, QueryError> + Send,
    ) -> PyResult<Vec<T>> {
        let times = times.as_array().to_vec();
        py.detach(|| times.into_iter().map(quantity).collect::<Result<_, _>>())
            .map_err(|error| query_error(&error))
    }
}

#[pymethods]
impl Run {
    /// How the run ended.
    #[getter]
    fn status(&self) -> &'static str {
        self.run.status.name()
    }

    /// When the run ended.
    #[getter]
    fn end_time(&self) -> f64 {
        self.run.end_time
    }

    /// The hash over the final state; None where a number in it is NaN.
    #[getter]
    fn digest(&self) -> Option<String> {
        self.run.digest().map(|digest: Digest| digest.state)
    }

    /// The version of the physics that it was made with.
    #[getter]
    fn physics_version(&self) -> u32 {
        self.run.physics_version
    }

    /// The ids of the balls.
    #[getter]
    fn ball_ids(&self) -> Vec<String> {
        self.run.system.ball_ids.clone()
    }

    /// The ids of the cushions, and of the corners after them.
    #[getter]
    fn cushion_ids(&self) -> Vec<String> {
        self.run.system.cushion_ids.clone()
    }

    /// The scenario as it was run.
    fn scenario(&self) -> Scenario {
        Scenario::new(self.scenario.clone())
    }

    /// The event columns; balls, cushions and kinds as codes, with −1 for none.
    fn events<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        if !self.run.log.keeps_events {
            return Err(run_error("the run kept no events; run with record = \"events\" or \"all\""));
        }
        event_columns(py, &self.run.log.events)
    }

    /// Positions and velocities at some times, (n_times, n_balls, 2) each.
    fn states<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<States<'py>> {
        let states = self.at(py, &times, |time| self.run.state(time))?;
        let shape = [states.len(), self.run.system.ball_ids.len(), 2];
        let positions = PyArray1::from_vec(py, vectors(&states, |state| state.position));
        let velocities = PyArray1::from_vec(py, vectors(&states, |state| state.velocity));
        Ok((positions.reshape(shape)?, velocities.reshape(shape)?))
    }

    /// The kinetic energy at some times.
    fn energy<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_vec(py, self.at(py, &times, |time| self.run.energy(time))?))
    }

    /// The potential energy in the field at some times.
    fn potential_energy<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_vec(py, self.at(py, &times, |time| self.run.potential_energy(time))?))
    }

    /// The momentum at some times, (n_times, 2).
    fn momentum<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let momenta = self.at(py, &times, |time| self.run.momentum(time))?;
        let count = momenta.len();
        let values = momenta.into_iter().flat_map(|momentum| [momentum.x, momentum.y]).collect();
        PyArray1::from_vec(py, values).reshape([count, 2])
    }

    /// The steps of a stepped run; None for an exact one.
    fn steps<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(steps) = &self.run.steps else { return Ok(None) };
        if !self.run.log.keeps_flights {
            return Err(run_error("the run kept no steps; run with record = \"all\""));
        }
        step_columns(py, steps).map(Some)
    }

    /// What the run found out about itself, as JSON text.
    fn diagnostics(&self) -> PyResult<String> {
        let mut found =
            serde_json::to_value(&self.run.diagnostics).map_err(|error| run_error(&error.to_string()))?;
        let counts = Kind::ALL.iter().zip(self.run.diagnostics.events);
        found["events"] =
            counts.map(|(kind, count)| (kind.name().to_owned(), json!(count))).collect::<Value>();
        if let Some(steps) = &self.run.steps {
            found["lost_time"] = json!(steps.lost_time);
        }
        Ok(found.to_string())
    }

    /// The sources of the laws that acted, as JSON text.
    fn references(&self) -> PyResult<String> {
        serde_json::to_string(&self.run.references()).map_err(|error| run_error(&error.to_string()))
    }

    /// The one longer run, up to new limits.
    fn resume(&self, py: Python<'_>, options_json: &str) -> PyResult<Self> {
        let version = self.run.physics_version;
        if !simulate::is_same_physics(version) {
            return Err(run_error(&format!(
                "the run was made with physics version {version}, and this is version {PHYSICS_VERSION}: run its scenario anew"
            )));
        }
        let (values, until) = options(options_json)?;
        let scenario = simulate::prolonged(&self.scenario, &values).map_err(scenario_error)?;
        if scenario.duration.is_some_and(|end| end < self.run.end_time) {
            return Err(problem("duration", &format!("the run has come to {:?} already", self.run.end_time)));
        }
        let compute = |interrupted: &mut dyn FnMut() -> bool| {
            simulate::resume(&scenario, &self.run, until, interrupted)
        };
        let run = interruptible(py, compute)?.map_err(|error| simulation_error(&error, &scenario))?;
        Ok(Self::new(scenario, run))
    }

    /// The run as JSON text.
    fn to_json(&self) -> PyResult<String> {
        run::to_json(&self.scenario, &self.run).map_err(file_error)
    }

    /// Reads what `to_json` wrote.
    #[staticmethod]
    fn from_json(text: &str) -> PyResult<Self> {
        let (scenario, run) = run::from_json(text).map_err(file_error)?;
        Ok(Self { scenario, run })
    }

    /// Computes the run again and gives the first difference, as JSON text.
    fn verify(&self, py: Python<'_>) -> PyResult<String> {
        let compute =
            |interrupted: &mut dyn FnMut() -> bool| simulate::verify(&self.scenario, &self.run, interrupted);
        let difference =
            interruptible(py, compute)?.map_err(|error| simulation_error(&error, &self.scenario))?;
        let outcome = json!({
            "same": difference.is_none(),
            "physics_version": self.run.physics_version,
            "difference": difference,
        });
        Ok(outcome.to_string())
    }
}
