//! Runs that are observed, and what was found.

use crate::errors::{problem, simulation_error};
use crate::interrupt::watched;
use crate::run::Run;
use crate::scenario::{Scenario, with_options};
use carom::observe::{Column, Curve, Observables, Quantity, Request, Results};
use carom::scenario::Scenario as Checked;
use carom::simulate::{ObservedError, Progress, Sampling, simulate_observed};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// Runs a scenario with observables, without the interpreter's lock; gives the run and what each observable found.
///
/// `progress` is called now and then with time, collisions and samples, and ends the run where it says so.
#[pyfunction]
pub fn run_observed<'py>(
    py: Python<'py>,
    scenario: &Scenario,
    options_json: &str,
    requests_json: &str,
    sampling: (f64, Option<f64>),
    progress: Option<Py<PyAny>>,
) -> PyResult<(Run, Bound<'py, PyList>)> {
    let (scenario, until) = with_options(scenario.inner(), options_json)?;
    let requests: Vec<Request> =
        serde_json::from_str(requests_json).map_err(|error| problem("observe", &error.to_string()))?;
    let mut observables =
        Observables::new(&requests).map_err(|error| problem("observe", &error.to_string()))?;
    let sampling = Sampling { equilibrate: sampling.0, interval: sampling.1 };
    let ask = |py: Python<'_>, now: &Progress| match &progress {
        Some(progress) => progress.call1(py, (now.time, now.collisions, now.samples))?.is_truthy(py),
        None => Ok(false),
    };
    let compute = |interrupted: &mut dyn FnMut(&Progress) -> bool| {
        simulate_observed(&scenario, until, &mut observables, &sampling, interrupted)
    };
    let run = watched(py, ask, compute)?.map_err(|error| observed_error(error, &scenario))?;
    let results = observables.results();
    let results = PyList::new(py, results.iter().map(|found| row(py, found)).collect::<PyResult<Vec<_>>>()?)?;
    Ok((Run::new(scenario, run.into()), results))
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
