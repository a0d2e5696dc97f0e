//! Errors of the engine as exceptions of the package.

use carom::run::{QueryError, RunFileError};
use carom::scenario::{Scenario, ScenarioError};
use pyo3::prelude::*;

mod exceptions {
    pyo3::import_exception!(carom.errors, ScenarioError);
    pyo3::import_exception!(carom.errors, SimulationError);
    pyo3::import_exception!(carom.errors, RunError);
}

/// The exception that lists the problems of a scenario.
pub fn scenario_error(error: ScenarioError) -> PyErr {
    let problems: Vec<_> =
        error.problems.into_iter().map(|problem| (problem.place, problem.message)).collect();
    exceptions::ScenarioError::new_err((problems,))
}

/// The exception for a problem at one place.
pub fn problem(place: &str, message: &str) -> PyErr {
    exceptions::ScenarioError::new_err((vec![(place.to_owned(), message.to_owned())],))
}

/// The exception for a broken invariant, with the scenario to replay the run.
pub fn simulation_error(error: &carom::run::SimulationError, scenario: &Scenario) -> PyErr {
    let text = scenario.to_json().unwrap_or_default();
    exceptions::SimulationError::new_err((error.to_string(), text))
}

/// The exception for a state that a run cannot tell.
pub fn query_error(error: &QueryError) -> PyErr {
    run_error(&error.to_string())
}

/// The exception for something that a run does not hold.
pub fn run_error(message: &str) -> PyErr {
    exceptions::RunError::new_err(message.to_owned())
}

/// The exception for a text that is not a saved run.
pub fn file_error(error: RunFileError) -> PyErr {
    match error {
        RunFileError::Scenario(error) => scenario_error(error),
        other => run_error(&other.to_string()),
    }
}

/// What discs were asked for that only balls on a cloth have.
pub fn discs_have_no_spin() -> PyErr {
    run_error("discs have no spin and no motion; balls have them where physics.flight.law = \"cloth\"")
}
