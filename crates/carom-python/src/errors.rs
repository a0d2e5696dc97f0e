//! Errors of the engine as exceptions of the package.

use pyo3::prelude::*;

pyo3::import_exception!(carom.errors, ScenarioError);

/// The exception that lists the problems of a scenario.
pub fn scenario_error(error: carom::scenario::ScenarioError) -> PyErr {
    let problems: Vec<_> =
        error.problems.into_iter().map(|problem| (problem.place, problem.message)).collect();
    ScenarioError::new_err((problems,))
}
