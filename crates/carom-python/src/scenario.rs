//! Scenarios.

use crate::balls_from;
use crate::errors::{problem, scenario_error, simulation_error};
use crate::interrupt::interruptible;
use crate::run::Run;
use crate::simulation::Simulation;
use carom::run::Kind;
use carom::scenario::schema::Record;
use carom::scenario::{self, json_schema, value_of_toml};
use carom::simulate::AnyRun;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde_json::{Map, Value, json};

/// Values of a scenario, by their paths.
type Values = Vec<(String, Value)>;

/// A checked scenario.
#[pyclass(frozen, module = "carom._engine")]
pub struct Scenario(scenario::Scenario);

impl Scenario {
    pub fn new(scenario: scenario::Scenario) -> Self {
        Self(scenario)
    }

    pub fn inner(&self) -> &scenario::Scenario {
        &self.0
    }
}

/// The JSON Schema of scenarios, as JSON text.
#[pyfunction]
pub fn schema() -> String {
    json_schema().to_string()
}

/// A text in TOML as JSON text.
#[pyfunction]
pub fn toml_as_json(text: &str) -> PyResult<String> {
    value_of_toml(text).map(|value| value.to_string()).map_err(scenario_error)
}

#[pymethods]
impl Scenario {
    /// Reads a scenario; the format is "toml" or "json". What reads a file of balls is called with the keys of `balls_from`,
    /// after the values of a JSON object are put in.
    #[staticmethod]
    #[pyo3(signature = (text, format, read_balls=None, values_json="{}"))]
    fn parse(
        py: Python<'_>,
        text: &str,
        format: &str,
        read_balls: Option<Py<PyAny>>,
        values_json: &str,
    ) -> PyResult<Self> {
        balls_from::parse(py, text, format, read_balls.as_ref(), values_json).map(Self)
    }

    /// The scenario as JSON text.
    fn to_json(&self) -> PyResult<String> {
        self.0.to_json().map_err(scenario_error)
    }

    /// The scenario as TOML text.
    fn to_toml(&self) -> PyResult<String> {
        self.0.to_toml().map_err(scenario_error)
    }

    /// The scenario with the values of a JSON object put in at the paths that are its keys.
    fn with_values(&self, values_json: &str) -> PyResult<Self> {
        self.0.with_values(&entries(values_json)?).map(Self).map_err(scenario_error)
    }

    /// The JSON text of the value at a path.
    fn value(&self, path: &str) -> PyResult<String> {
        self.0.value(path).map(|value| value.to_string()).map_err(scenario_error)
    }

    /// What there is to draw of the table, as JSON text.
    fn outline(&self) -> String {
        self.0.outline().to_string()
    }

    /// The scenario with its preset, its rack and its gas turned into plain keys.
    fn expanded(&self) -> Self {
        Self(self.0.expanded().into_owned())
    }

    /// The names of the units, as JSON text.
    fn units(&self) -> String {
        json!(self.0.unit_names()).to_string()
    }

    /// Whether the balls roll and spin on a cloth.
    #[getter]
    fn is_on_cloth(&self) -> bool {
        self.0.has_cloth()
    }

    /// What a run keeps: "all", "events" or "none".
    #[getter]
    fn record(&self) -> &'static str {
        match self.0.record() {
            Record::All => "all",
            Record::Events => "events",
            Record::None => "none",
        }
    }

    /// The balls as JSON text, with radius, mass, velocity and, on a cloth, spin filled in; before the cue strikes.
    fn balls(&self) -> String {
        self.0.balls_at_start().to_string()
    }

    /// Runs the scenario to its end, without the interpreter's lock.
    fn run(&self, py: Python<'_>, options_json: &str) -> PyResult<Run> {
        let (scenario, until) = with_options(&self.0, options_json)?;
        let compute = |interrupted: &mut dyn FnMut() -> bool| AnyRun::simulate(&scenario, until, interrupted);
        let run = interruptible(py, compute)?.map_err(|error| simulation_error(&error, &scenario))?;
        Ok(Run::new(scenario, run))
    }

    /// Starts a run that is taken event by event.
    fn start(&self, options_json: &str) -> PyResult<Simulation> {
        let (scenario, until) = with_options(&self.0, options_json)?;
        Simulation::new(scenario, until)
    }
}

/// A scenario with the options of a run put in, and the kind of event to stop at.
pub fn with_options(
    scenario: &scenario::Scenario,
    options_json: &str,
) -> PyResult<(scenario::Scenario, Option<Kind>)> {
    let (values, until) = options(options_json)?;
    Ok((scenario.with_values(&values).map_err(scenario_error)?, until))
}

/// The options of a run as values of its scenario, and the kind of event to stop at.
pub fn options(options_json: &str) -> PyResult<(Values, Option<Kind>)> {
    let (until, values): (Vec<_>, Vec<_>) =
        entries(options_json)?.into_iter().partition(|(name, _)| name == "until");
    Ok((values, until.first().map(|(_, word)| kind(word)).transpose()?))
}

fn kind(word: &Value) -> PyResult<Kind> {
    let known = || format!("must be one of {}", Kind::ALL.map(Kind::name).join(", "));
    word.as_str().and_then(Kind::from_name).ok_or_else(|| problem("until", &known()))
}

/// The keys and values of a JSON object, in order.
pub fn entries(text: &str) -> PyResult<Values> {
    let object: Map<String, Value> =
        serde_json::from_str(text).map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok(object.into_iter().collect())
}
