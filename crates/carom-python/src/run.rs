//! Runs.

use crate::columns::{event_columns, step_columns};
use crate::errors::{
    discs_have_no_spin, file_error, problem, query_error, run_error, scenario_error, simulation_error,
};
use crate::interrupt::interruptible;
use crate::scenario::{Scenario, options};
use crate::states::{Moving, vectors};
use carom::run::{self, Digest, OnCloth, PHYSICS_VERSION, QueryError};
use carom::scenario::Scenario as Checked;
use carom::simulate::{self, AnyRun, Simulated};
use carom::with_any;
use numpy::{Element, PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::json;

type States<'py> = (Bound<'py, PyArray3<f64>>, Bound<'py, PyArray3<f64>>);
type Course<'py> = (Bound<'py, PyArray1<u32>>, Bound<'py, PyArray2<f64>>);
type Spins<'py> = (Bound<'py, PyArray3<f64>>, Bound<'py, PyArray2<i8>>);

/// A computed run, with the scenario as it was run.
#[pyclass(frozen, module = "carom._engine")]
pub struct Run {
    scenario: Checked,
    run: AnyRun,
}

impl Run {
    pub fn new(scenario: Checked, run: AnyRun) -> Self {
        Self { scenario, run }
    }

    /// The run of balls on a cloth.
    fn on_cloth(&self) -> PyResult<&run::Run<f64, OnCloth>> {
        match &self.run {
            AnyRun::OnCloth(run) => Ok(run),
            AnyRun::Plane(_) => Err(discs_have_no_spin()),
        }
    }
}

#[pymethods]
impl Run {
    /// How the run ended.
    #[getter]
    fn status(&self) -> &'static str {
        with_any!(&self.run, run => run.status.name())
    }

    /// When the run ended.
    #[getter]
    fn end_time(&self) -> f64 {
        with_any!(&self.run, run => run.end_time)
    }

    /// The hash over the final state; None where a number in it is NaN.
    #[getter]
    fn digest(&self) -> Option<String> {
        with_any!(&self.run, run => run.digest()).map(|digest: Digest| digest.state)
    }

    /// The version of the physics that it was made with.
    #[getter]
    fn physics_version(&self) -> u32 {
        with_any!(&self.run, run => run.physics_version)
    }

    /// Whether the balls roll and spin on a cloth.
    #[getter]
    fn is_on_cloth(&self) -> bool {
        matches!(self.run, AnyRun::OnCloth(_))
    }

    /// The ids of the balls.
    #[getter]
    fn ball_ids(&self) -> Vec<String> {
        with_any!(&self.run, run => run.system.ball_ids.clone())
    }

    /// The ids of the cushions, and of the corners after them.
    #[getter]
    fn cushion_ids(&self) -> Vec<String> {
        self.places().0.to_vec()
    }

    /// The ids of the pockets.
    #[getter]
    fn pocket_ids(&self) -> Vec<String> {
        self.places().1.to_vec()
    }

    /// The scenario as it was run.
    fn scenario(&self) -> Scenario {
        Scenario::new(self.scenario.clone())
    }

    /// The scenario that goes on from the end of the run, without a shot.
    fn final_scenario(&self) -> PyResult<Scenario> {
        simulate::final_scenario(&self.scenario, &self.run).map(Scenario::new).map_err(scenario_error)
    }

    /// The event columns; balls, cushions, pockets and kinds as codes, with −1 for none.
    fn events<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        with_any!(&self.run, run => {
            if !run.log.keeps_events {
                return Err(run_error("the run kept no events; run with record = \"events\" or \"all\""));
            }
            event_columns(py, &run.log.events, 0, self.places().0.len())
        })
    }

    /// Positions and velocities at some times, (n_times, n_balls, 2) each; (..., 3) on a cloth, NaN for balls out of play.
    fn states<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<States<'py>> {
        with_any!(&self.run, run => {
            let states = at(py, &times, |time| run.state(time))?;
            let positions = vectors(&states, Moving::position);
            let velocities = vectors(&states, Moving::velocity);
            let shape = shape(&states, run.balls.len(), &positions);
            let array = |values| PyArray1::from_vec(py, values).reshape(shape);
            Ok((array(positions)?, array(velocities)?))
        })
    }

    /// Spins, (n_times, n_balls, 3), and codes of motions, (n_times, n_balls), at some times of a run on a cloth.
    fn spins<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Spins<'py>> {
        let run = self.on_cloth()?;
        let states = at(py, &times, |time| run.state(time))?;
        let [count, balls] = [states.len(), run.balls.len()];
        let spins = vectors(&states, Moving::spin);
        let motions = states.iter().flatten().map(|state| state.motion as i8).collect();
        let motions: Bound<'py, PyArray1<i8>> = PyArray1::from_vec(py, motions);
        Ok((PyArray1::from_vec(py, spins).reshape([count, balls, 3])?, motions.reshape([count, balls])?))
    }

    /// The flights of each ball: the first row of each ball and after the last the number of rows, and the rows.
    fn film<'py>(&self, py: Python<'py>) -> PyResult<Course<'py>> {
        let film = with_any!(&self.run, run => run.film()).map_err(|error| query_error(&error))?;
        let shape = [film.numbers.len() / film.width, film.width];
        let rows = PyArray1::from_vec(py, film.numbers).reshape(shape)?;
        Ok((PyArray1::from_vec(py, film.first_rows), rows))
    }

    /// The kinetic energy at some times.
    fn energy<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        with_any!(&self.run, run => series(py, &times, |time| run.energy(time)))
    }

    /// The potential energy, in the field or of height, at some times.
    fn potential_energy<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        with_any!(&self.run, run => series(py, &times, |time| run.potential_energy(time)))
    }

    /// The momentum at some times, (n_times, 2); (n_times, 3) on a cloth.
    fn momentum<'py>(
        &self,
        py: Python<'py>,
        times: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        match &self.run {
            AnyRun::Plane(run) => {
                table(py, at(py, &times, |time| run.momentum(time))?.into_iter().map(|p| p.to_f64()))
            }
            AnyRun::OnCloth(run) => {
                table(py, at(py, &times, |time| run.momentum(time))?.into_iter().map(|p| p.to_f64()))
            }
        }
    }

    /// The steps of a stepped run; None for an exact one.
    fn steps<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let AnyRun::Plane(run) = &self.run else { return Ok(None) };
        let Some(steps) = &run.steps else { return Ok(None) };
        if !run.log.keeps_flights {
            return Err(run_error("the run kept no steps; run with record = \"all\""));
        }
        step_columns(py, steps).map(Some)
    }

    /// What the run found out about itself, as JSON text.
    fn diagnostics(&self) -> PyResult<String> {
        let diagnostics = with_any!(&self.run, run => run.findings());
        diagnostics.map(|found| found.to_string()).map_err(|error| run_error(&error.to_string()))
    }

    /// The sources of the laws that acted, as JSON text.
    fn references(&self) -> PyResult<String> {
        let references = with_any!(&self.run, run => run.references());
        serde_json::to_string(&references).map_err(|error| run_error(&error.to_string()))
    }

    /// The one longer run, up to new limits.
    fn resume(&self, py: Python<'_>, options_json: &str) -> PyResult<Self> {
        with_any!(&self.run, run => self.resumed(py, run, options_json))
    }

    /// The run as JSON text.
    fn to_json(&self) -> PyResult<String> {
        with_any!(&self.run, run => run::to_json(&self.scenario, run)).map_err(file_error)
    }

    /// Reads what `to_json` wrote.
    #[staticmethod]
    fn from_json(text: &str) -> PyResult<Self> {
        let (scenario, run) = AnyRun::from_json(text).map_err(file_error)?;
        Ok(Self { scenario, run })
    }

    /// Computes the run again and gives the first difference, as JSON text.
    fn verify(&self, py: Python<'_>) -> PyResult<String> {
        with_any!(&self.run, run => self.verified(py, run))
    }
}

impl Run {
    /// The ids of cushions and corners, and those of pockets, which are numbered after them.
    fn places(&self) -> (&[String], &[String]) {
        match &self.run {
            AnyRun::Plane(run) => (&run.system.cushion_ids, &[]),
            AnyRun::OnCloth(run) => run.system.cushion_ids.split_at(run.system.place_of(0) as usize),
        }
    }

    fn resumed<D: Simulated>(
        &self,
        py: Python<'_>,
        run: &run::Run<f64, D>,
        options_json: &str,
    ) -> PyResult<Self>
    where
        AnyRun: From<run::Run<f64, D>>,
    {
        let version = run.physics_version;
        if !simulate::is_same_physics(version) {
            return Err(run_error(&format!(
                "the run was made with physics version {version}, and this is version {PHYSICS_VERSION}: run its scenario anew"
            )));
        }
        let (values, until) = options(options_json)?;
        let scenario = simulate::prolonged(&self.scenario, &values).map_err(scenario_error)?;
        if scenario.duration.is_some_and(|end| end < run.end_time) {
            return Err(problem("duration", &format!("the run has come to {:?} already", run.end_time)));
        }
        let compute =
            |interrupted: &mut dyn FnMut() -> bool| simulate::resume(&scenario, run, until, interrupted);
        let run = interruptible(py, compute)?.map_err(|error| simulation_error(&error, &scenario))?;
        Ok(Self::new(scenario, run.into()))
    }

    fn verified<D: Simulated>(&self, py: Python<'_>, run: &run::Run<f64, D>) -> PyResult<String> {
        let compute =
            |interrupted: &mut dyn FnMut() -> bool| simulate::verify(&self.scenario, run, interrupted);
        let difference =
            interruptible(py, compute)?.map_err(|error| simulation_error(&error, &self.scenario))?;
        let outcome = json!({
            "same": difference.is_none(),
            "physics_version": run.physics_version,
            "difference": difference,
        });
        Ok(outcome.to_string())
    }
}

/// A quantity at each of some times, computed without the interpreter's lock.
fn at<T: Send>(
    py: Python<'_>,
    times: &PyReadonlyArray1<'_, f64>,
    quantity: impl Fn(f64) -> Result<T, QueryError> + Send,
) -> PyResult<Vec<T>> {
    let times = times.as_array().to_vec();
    py.detach(|| times.into_iter().map(quantity).collect::<Result<_, _>>())
        .map_err(|error| query_error(&error))
}

fn series<'py>(
    py: Python<'py>,
    times: &PyReadonlyArray1<'_, f64>,
    quantity: impl Fn(f64) -> Result<f64, QueryError> + Send,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    Ok(PyArray1::from_vec(py, at(py, times, quantity)?))
}

fn table<'py, T: Element + Copy, const N: usize>(
    py: Python<'py>,
    rows: impl ExactSizeIterator<Item = [T; N]>,
) -> PyResult<Bound<'py, PyArray2<T>>> {
    let count = rows.len();
    PyArray1::from_vec(py, rows.flatten().collect()).reshape([count, N])
}

/// The shape of vectors of balls at times: the number of components is what is left.
fn shape<T>(states: &[Vec<T>], balls: usize, values: &[f64]) -> [usize; 3] {
    let rows = states.len() * balls;
    [states.len(), balls, values.len().checked_div(rows).unwrap_or(2)]
}
