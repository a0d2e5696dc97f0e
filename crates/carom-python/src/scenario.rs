//! Scenarios.

use crate::errors::scenario_error;
use carom::scenario;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// A checked scenario.
#[pyclass(frozen, module = "carom._engine")]
pub struct Scenario(scenario::Scenario);

#[pymethods]
impl Scenario {
    /// Reads a scenario; the format is "toml" or "json".
    #[staticmethod]
    fn parse(text: &str, format: &str) -> PyResult<Self> {
        match format {
            "toml" => scenario::Scenario::from_toml(text),
            "json" => scenario::Scenario::from_json(text),
            _ => return Err(PyValueError::new_err(format!("unknown format {format:?}"))),
        }
        .map(Self)
        .map_err(scenario_error)
    }

    /// The scenario as JSON text.
    fn to_json(&self) -> PyResult<String> {
        self.0.to_json().map_err(scenario_error)
    }

    /// The scenario as TOML text.
    fn to_toml(&self) -> PyResult<String> {
        self.0.to_toml().map_err(scenario_error)
    }
}
