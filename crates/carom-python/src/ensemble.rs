//! Ensembles.

use crate::errors::{problem, scenario_error};
use crate::scenario::Scenario;
use carom::ensemble::{self, Design, Distribution, Ending, Inputs, Meaning, Outcome, Source};
use carom::observe::NAMES;
use carom::simulate::Sampling;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

/// A path, the kind of what stands there, and its numbers: those themselves, or the parameters of a distribution.
type Varied<'py> = (String, String, PyReadonlyArray1<'py, f64>);

/// A row that has no outcomes, and why.
type Problems = Vec<(u64, String)>;

/// The columns of outcomes, for each row the place of its ending's word, the words, the problems, whether a signal came.
type Found<'py> =
    (Vec<Bound<'py, PyArray1<f64>>>, Bound<'py, PyArray1<u8>>, Vec<&'static str>, Problems, bool);

/// Many runs of one scenario with some of its numbers varied.
#[pyclass(frozen, module = "carom._engine")]
pub struct Ensemble(ensemble::Ensemble);

#[pymethods]
impl Ensemble {
    /// The paths with what is varied there, the number of runs, the outcomes that are wanted, and when gases are observed:
    /// after how many collisions of each disc, and the time between samples.
    #[new]
    #[allow(clippy::too_many_arguments)]
    fn new(
        py: Python<'_>,
        scenario: &Scenario,
        varied: Vec<Varied<'_>>,
        runs: Option<u64>,
        design: &str,
        seed: u64,
        outcomes: Vec<String>,
        equilibrate: f64,
        sample_interval: Option<f64>,
    ) -> PyResult<Self> {
        let design = named("design", design, Design::from_name, &Design::ALL.map(Design::name))?;
        let known =
            [&Outcome::ALL.map(|outcome| outcome.name())[..], &["closest_approach.A.B"], &NAMES].concat();
        let of_name = |name: &String| named("outcomes", name, Outcome::from_name, &known);
        let outcomes: Vec<Outcome> = outcomes.iter().map(of_name).collect::<PyResult<_>>()?;
        let sources: Vec<(String, Source)> = varied
            .into_iter()
            .map(|(path, kind, numbers)| Ok((path, source(&kind, numbers.as_array().to_vec())?)))
            .collect::<PyResult<_>>()?;
        let scenario = scenario.inner();
        py.detach(|| {
            let inputs = Inputs::new(sources, runs, design, seed)?;
            let sampling = Sampling { equilibrate, interval: sample_interval };
            Ok(ensemble::Ensemble::new(scenario, inputs, &outcomes)?.sampled(sampling))
        })
        .map(Self)
        .map_err(scenario_error)
    }

    /// The number of runs.
    #[getter]
    fn runs(&self) -> u64 {
        self.0.inputs().rows()
    }

    /// The columns of outcomes: the name of each, and what its numbers are.
    fn columns(&self) -> Vec<(String, &'static str)> {
        let meaning = |meaning| match meaning {
            Meaning::Quantity => "quantity",
            Meaning::Count => "count",
            Meaning::Pocket => "pocket",
        };
        self.0.columns().iter().map(|column| (column.name.clone(), meaning(column.meaning))).collect()
    }

    /// The varied numbers of some rows, (n_rows,) for each path.
    fn inputs<'py>(&self, py: Python<'py>, first: u64, end: u64) -> PyResult<Vec<Bound<'py, PyArray1<f64>>>> {
        let rows = self.rows(first, end)?;
        let columns = py.detach(|| self.0.inputs().columns(rows));
        Ok(columns.into_iter().map(|column| PyArray1::from_vec(py, column)).collect())
    }

    /// The scenario of a row.
    fn scenario(&self, row: u64) -> PyResult<Scenario> {
        let row = self.rows(row, row.saturating_add(1))?.start;
        self.0.scenario(row).map(Scenario::new).map_err(scenario_error)
    }

    /// Runs some rows without the interpreter's lock: the columns of outcomes, for each row the place of the word
    /// for what became of it, the words, the problems of rows with their numbers, and whether a signal ended it early.
    ///
    /// Now and then `watch` is told how many rows are done; what is true ends it too.
    fn run<'py>(
        &self,
        py: Python<'py>,
        first: u64,
        end: u64,
        threads: Option<usize>,
        watch: Option<Py<PyAny>>,
    ) -> PyResult<Found<'py>> {
        let rows = self.rows(first, end)?;
        let mut raised = None;
        let mut look = |done: u64| {
            let wanted = Python::attach(|py| {
                py.check_signals()?;
                watch.as_ref().map_or(Ok(false), |watch| watch.bind(py).call1((done,))?.is_truthy())
            });
            wanted.unwrap_or_else(|error| {
                raised = raised.take().or(Some(error));
                true
            })
        };
        let table = py
            .detach(|| self.0.run(rows, threads, &mut look))
            .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        let is_interrupted =
            raised.as_ref().is_some_and(|error| error.is_instance_of::<PyKeyboardInterrupt>(py));
        if let Some(error) = raised.filter(|_| !is_interrupted) {
            return Err(error);
        }
        let mut words = Vec::new();
        let codes = table.endings.iter().map(|ending| code(*ending, &mut words)).collect();
        let columns = table.columns.into_iter().map(|column| PyArray1::from_vec(py, column)).collect();
        Ok((columns, PyArray1::from_vec(py, codes), words, table.problems, is_interrupted))
    }
}

impl Ensemble {
    fn rows(&self, first: u64, end: u64) -> PyResult<core::ops::Range<u64>> {
        let runs = self.0.inputs().rows();
        if first > end || end > runs {
            return Err(PyValueError::new_err(format!("rows {first} to {end}: there are {runs} of them")));
        }
        Ok(first..end)
    }
}

/// The place of an ending's word among those that have come up.
fn code(ending: Ending, words: &mut Vec<&'static str>) -> u8 {
    let word = ending.name();
    let place = words.iter().position(|known| *known == word).unwrap_or_else(|| {
        words.push(word);
        words.len() - 1
    });
    place as u8
}

fn named<T>(
    place: &str,
    name: &str,
    of_name: impl Fn(&str) -> Option<T>,
    known: &[&'static str],
) -> PyResult<T> {
    of_name(name).ok_or_else(|| problem(place, &format!("unknown {name:?}; known: {}", known.join(", "))))
}

fn source(kind: &str, numbers: Vec<f64>) -> PyResult<Source> {
    Ok(match (kind, &numbers[..]) {
        ("given", _) => Source::Given(numbers),
        ("axis", _) => Source::Axis(numbers),
        ("uniform", &[low, high]) => Source::Drawn(Distribution::Uniform { low, high }),
        ("normal", &[mean, standard_deviation]) => {
            Source::Drawn(Distribution::Normal { mean, standard_deviation })
        }
        ("normal", &[mean, standard_deviation, low, high]) => {
            Source::Drawn(Distribution::TruncatedNormal { mean, standard_deviation, low, high })
        }
        _ => return Err(PyValueError::new_err(format!("unknown kind {kind:?}"))),
    })
}
