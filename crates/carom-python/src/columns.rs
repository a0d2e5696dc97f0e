//! Events and steps as columns.

use carom::flight::State;
use carom::run::{Event, Kind, Step, Steps};
use numpy::{Element, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The event columns; balls, cushions, pockets and kinds as codes, with −1 for none. The events are numbered from
/// `first` on, pockets after so many cushions.
pub fn event_columns<'py>(
    py: Python<'py>,
    events: &[Event<f64>],
    first: u64,
    cushions: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let (columns, first) = (PyDict::new(py), first as i64);
    columns.set_item("index", PyArray1::from_iter(py, first..first + events.len() as i64))?;
    columns.set_item("time", column(py, events, |event| event.time))?;
    columns.set_item("kind", column(py, events, |event| event.kind as i8))?;
    columns.set_item("ball_a", column(py, events, |event| event.ball_a as i32))?;
    columns.set_item("ball_b", column(py, events, |event| code(event.ball_b)))?;
    columns.set_item(
        "cushion",
        column(py, events, |event| place(event, false).map_or(-1, |place| place as i32)),
    )?;
    columns.set_item("x", column(py, events, |event| event.point.x))?;
    columns.set_item("y", column(py, events, |event| event.point.y))?;
    columns.set_item("normal_x", column(py, events, |event| event.normal.x))?;
    columns.set_item("normal_y", column(py, events, |event| event.normal.y))?;
    columns.set_item("closing_speed", column(py, events, |event| event.closing_speed))?;
    columns.set_item("impulse", column(py, events, |event| event.impulse))?;
    columns.set_item("cluster", column(py, events, |event| event.cluster.map_or(-1, i64::from)))?;
    columns.set_item(
        "pocket",
        column(py, events, |event| place(event, true).map_or(-1, |place| place as i32 - cushions as i32)),
    )?;
    Ok(columns)
}

/// The place of an event if it is a pocket, or else if it is a cushion.
fn place(event: &Event<f64>, is_pocket: bool) -> Option<u32> {
    event.cushion.filter(|_| (event.kind == Kind::BallPocket) == is_pocket)
}

/// The columns of a stepped run, (n_steps + 1, n_balls) where they depend on the ball.
pub fn step_columns<'py>(py: Python<'py>, steps: &Steps<f64>) -> PyResult<Bound<'py, PyDict>> {
    let steps = &steps.steps;
    let columns = PyDict::new(py);
    columns.set_item("step", PyArray1::from_iter(py, 0..steps.len() as i64))?;
    columns.set_item("time", PyArray1::from_iter(py, steps.iter().map(|step| step.time)))?;
    columns.set_item("x", of_balls(py, steps, |state| state.position.x)?)?;
    columns.set_item("y", of_balls(py, steps, |state| state.position.y)?)?;
    columns.set_item("vx", of_balls(py, steps, |state| state.velocity.x)?)?;
    columns.set_item("vy", of_balls(py, steps, |state| state.velocity.y)?)?;
    let hits = steps.iter().flat_map(|step| &step.hits);
    let hits = hits.map(|hit| hit.map_or(-1, |hit| hit.kind as i8)).collect();
    columns.set_item("hit", table(py, hits, steps)?)?;
    Ok(columns)
}

fn column<'py, T: Element>(
    py: Python<'py>,
    events: &[Event<f64>],
    value: impl Fn(&Event<f64>) -> T,
) -> Bound<'py, PyArray1<T>> {
    PyArray1::from_vec(py, events.iter().map(value).collect())
}

fn code(index: Option<u32>) -> i32 {
    index.map_or(-1, |index| index as i32)
}

fn of_balls<'py>(
    py: Python<'py>,
    steps: &[Step<f64>],
    value: impl Fn(&State<f64>) -> f64,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    table(py, steps.iter().flat_map(|step| &step.balls).map(value).collect(), steps)
}

fn table<'py, T: Element>(
    py: Python<'py>,
    values: Vec<T>,
    steps: &[Step<f64>],
) -> PyResult<Bound<'py, PyArray2<T>>> {
    let balls = steps.first().map_or(0, |step| step.balls.len());
    PyArray1::from_vec(py, values).reshape([steps.len(), balls])
}
