//! Positions and velocities as arrays.

use carom::flight::{SphereState, State};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;

/// What a state has to show: vectors of two components for discs, of three for balls on a cloth. Those of a ball that is
/// out of play are NaN.
pub trait Moving {
    /// The components of its vectors.
    type Components: IntoIterator<Item = f64>;

    fn position(&self) -> Self::Components;
    fn velocity(&self) -> Self::Components;

    /// The spin; none of a disc.
    fn spin(&self) -> [f64; 3];
}

impl Moving for State<f64> {
    type Components = [f64; 2];

    fn position(&self) -> [f64; 2] {
        self.position.to_f64()
    }

    fn velocity(&self) -> [f64; 2] {
        self.velocity.to_f64()
    }

    fn spin(&self) -> [f64; 3] {
        [0.0; 3]
    }
}

impl Moving for SphereState<f64> {
    type Components = [f64; 3];

    fn position(&self) -> [f64; 3] {
        in_play(self, self.position.to_f64())
    }

    fn velocity(&self) -> [f64; 3] {
        in_play(self, self.twist.velocity.to_f64())
    }

    fn spin(&self) -> [f64; 3] {
        in_play(self, self.twist.spin.to_f64())
    }
}

fn in_play(state: &SphereState<f64>, vector: [f64; 3]) -> [f64; 3] {
    if state.motion.is_out() { [f64::NAN; 3] } else { vector }
}

/// The vectors of one kind of some states, one after the other.
pub fn vectors<T, C: IntoIterator<Item = f64>>(states: &[Vec<T>], of: impl Fn(&T) -> C) -> Vec<f64> {
    states.iter().flatten().flat_map(of).collect()
}

/// The vectors of one kind of one state, (n_balls, 2), or (n_balls, 3) on a cloth.
pub fn array<'py, T, C: IntoIterator<Item = f64>>(
    py: Python<'py>,
    state: Vec<T>,
    of: impl Fn(&T) -> C,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let balls = state.len();
    let values = vectors(&[state], of);
    let components = values.len().checked_div(balls).unwrap_or(2);
    PyArray1::from_vec(py, values).reshape([balls, components])
}
