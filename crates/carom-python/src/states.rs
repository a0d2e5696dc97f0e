//! Positions and velocities as arrays.

use carom::flight::State;
use carom::geometry::Vec2;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// The vectors of one kind of some states, one after the other.
pub fn vectors(states: &[Vec<State<f64>>], of: impl Fn(&State<f64>) -> Vec2<f64>) -> Vec<f64> {
    states.iter().flatten().flat_map(|ball| [of(ball).x, of(ball).y]).collect()
}

/// The positions or velocities of one state, (n_balls, 2).
pub fn array<'py>(
    py: Python<'py>,
    state: Vec<State<f64>>,
    of: impl Fn(&State<f64>) -> Vec2<f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let balls = state.len();
    PyArray1::from_vec(py, vectors(&[state], of)).reshape([balls, 2])
}
