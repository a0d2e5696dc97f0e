//! The ready-made scenarios and tables.

use carom::scenario::schema::Preset;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

include!(concat!(env!("OUT_DIR"), "/scenarios.rs"));

/// The texts of the ready-made scenarios, TOML, by name.
#[pyfunction]
pub fn bundled_scenarios(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    SCENARIOS.into_py_dict(py)
}

/// The titles of the ready-made tables, by name.
#[pyfunction]
pub fn presets(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    Preset::ALL.map(|preset| (preset.name(), preset.title())).into_py_dict(py)
}
