//! Errors of the engine as values that are thrown: JSON texts with the problems and their places.

use carom::run::{QueryError, RunFileError, SimulationError};
use carom::scenario::{Problem, ScenarioError};
use serde_json::json;
use wasm_bindgen::JsValue;

/// What is wrong with a scenario.
pub fn scenario_error(error: &ScenarioError) -> JsValue {
    let problem = |Problem { place, message }: &Problem| json!({ "place": place, "message": message });
    thrown(&error.problems.iter().map(problem).collect::<Vec<_>>())
}

/// A problem at one place.
pub fn problem(place: &str, message: &str) -> JsValue {
    thrown(&[json!({ "place": place, "message": message })])
}

/// A broken invariant.
pub fn simulation_error(error: &SimulationError) -> JsValue {
    problem("run", &error.to_string())
}

/// A state that a run cannot tell.
pub fn query_error(error: &QueryError) -> JsValue {
    problem("run", &error.to_string())
}

/// A text that holds no run.
pub fn file_error(error: &RunFileError) -> JsValue {
    match error {
        RunFileError::Scenario(error) => scenario_error(error),
        other => problem("run", &other.to_string()),
    }
}

fn thrown(problems: &[serde_json::Value]) -> JsValue {
    JsValue::from_str(&json!({ "problems": problems }).to_string())
}
