//! The ready-made scenarios.

use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

include!(concat!(env!("OUT_DIR"), "/scenarios.rs"));

/// The texts of the ready-made scenarios, TOML, by name.
#[pyfunction]
pub fn bundled_scenarios(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    SCENARIOS.into_py_dict(py)
}
