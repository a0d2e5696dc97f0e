//! Balls that Python reads from a file.

use carom::scenario::schema::BallsFrom;
use carom::scenario::{BallsRead, Problem, Scenario, ScenarioError};
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::errors::scenario_error;
use crate::scenario::entries;

/// One frame, as `carom.balls_from` gives it.
#[derive(FromPyObject)]
struct Frame<'py> {
    ids: Option<Vec<String>>,
    positions: PyReadonlyArray2<'py, f64>,
    velocities: Option<PyReadonlyArray2<'py, f64>>,
    radii: PyReadonlyArray1<'py, f64>,
    masses: PyReadonlyArray1<'py, f64>,
    size: [f64; 2],
    periodic: [bool; 2],
    frame: u64,
    sha256: String,
}

/// Reads a scenario, with the values of a JSON object changed before a file is read.
///
/// Of `[balls_from]` the reader is called with its keys as JSON text; it gives a frame, or the problems as pairs of place and
/// message. Meanwhile others may have the interpreter's lock, as a large gas takes long to place.
pub fn parse(
    py: Python<'_>,
    text: &str,
    format: &str,
    reader: Option<&Py<PyAny>>,
    values_json: &str,
) -> PyResult<Scenario> {
    let values = entries(values_json)?;
    let mut raised = None;
    let mut read = |from: &BallsFrom| {
        Python::attach(|py| called(py, reader, from)).unwrap_or_else(|error| {
            raised = Some(error);
            Err(Problem::new("balls_from", "could not be read").into())
        })
    };
    let parsed = py.detach(|| match (format, reader) {
        ("toml", None) => Some(Scenario::from_toml(text)),
        ("json", None) => Some(Scenario::from_json(text)),
        ("toml", Some(_)) => Some(Scenario::from_toml_with(text, &values, &mut read)),
        ("json", Some(_)) => Some(Scenario::from_json_with(text, &values, &mut read)),
        _ => None,
    });
    let parsed = parsed.ok_or_else(|| PyValueError::new_err(format!("unknown format {format:?}")))?;
    raised.map_or_else(|| parsed.map_err(scenario_error), Err)
}

fn called(
    py: Python<'_>,
    reader: Option<&Py<PyAny>>,
    from: &BallsFrom,
) -> PyResult<Result<BallsRead, ScenarioError>> {
    let reader = reader.ok_or_else(|| PyValueError::new_err("there is nothing to read with"))?;
    let keys = serde_json::to_string(from).map_err(|error| PyValueError::new_err(error.to_string()))?;
    let given = reader.bind(py).call1((keys,))?;
    if let Ok(problems) = given.extract::<Vec<(String, String)>>() {
        let problems = problems.into_iter().map(|(place, message)| Problem::new(place, message)).collect();
        return Ok(Err(ScenarioError { problems }));
    }
    let frame: Frame<'_> = given.extract()?;
    Ok(Ok(BallsRead {
        ids: frame.ids,
        positions: rows(&frame.positions),
        velocities: frame.velocities.as_ref().map(rows),
        radii: frame.radii.as_array().to_vec(),
        masses: frame.masses.as_array().to_vec(),
        size: frame.size,
        periodic: frame.periodic,
        frame: frame.frame,
        sha256: frame.sha256,
    }))
}

fn rows(array: &PyReadonlyArray2<'_, f64>) -> Vec<[f64; 2]> {
    array.as_array().rows().into_iter().map(|row| [row[0], row[1]]).collect()
}
