//! Scenario texts: TOML and JSON, read and written.

use super::{Problem, Scenario, ScenarioError};
use serde_json::{Map, Value};

impl Scenario {
    /// Reads and checks a scenario written in TOML.
    pub fn from_toml(text: &str) -> Result<Self, ScenarioError> {
        let document: toml::Table = text.parse().map_err(|error| toml_problem(text, &error))?;
        Self::from_value(json_of_table(document))
    }

    /// Reads and checks a scenario written in JSON.
    pub fn from_json(text: &str) -> Result<Self, ScenarioError> {
        Self::from_value(serde_json::from_str(text).map_err(|error| json_problem(&error))?)
    }

    /// Checks a scenario given as a JSON value.
    pub fn from_value(value: Value) -> Result<Self, ScenarioError> {
        let mut findings = super::problem::Findings::default();
        let value = super::structure::check_structure(&value, &mut findings);
        findings.into_result()?;
        serde_path_to_error::deserialize(value)
            .map_err(|error| Problem::new(error.path(), error.inner()).into())
    }

    /// The scenario as a JSON value; what is absent or has its default is left out.
    pub fn to_value(&self) -> Result<Value, ScenarioError> {
        serde_json::to_value(self).map_err(|error| Problem::new("scenario", error).into())
    }

    /// The scenario as JSON text; reading it gives the same scenario, bit for bit.
    pub fn to_json(&self) -> Result<String, ScenarioError> {
        serde_json::to_string_pretty(self).map_err(|error| Problem::new("scenario", error).into())
    }

    /// The scenario as TOML text; reading it gives the same scenario, bit for bit.
    pub fn to_toml(&self) -> Result<String, ScenarioError> {
        toml::to_string(self).map_err(|error| Problem::new("scenario", error).into())
    }
}

fn toml_problem(text: &str, error: &toml::de::Error) -> Problem {
    let start = error.span().map_or(0, |span| span.start);
    let before = text.get(..start).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
    Problem::new(format_args!("line {line}, column {column}"), error.message())
}

fn json_problem(error: &serde_json::Error) -> Problem {
    let text = error.to_string();
    let message = text.rsplit_once(" at line ").map_or(text.as_str(), |(message, _)| message);
    Problem::new(format_args!("line {}, column {}", error.line(), error.column()), message)
}

fn json_of_table(table: toml::Table) -> Value {
    Value::Object(table.into_iter().map(|(key, value)| (key, json_of(value))).collect::<Map<_, _>>())
}

/// A TOML value as JSON; numbers that JSON does not have become the texts "nan", "inf" and "-inf".
fn json_of(value: toml::Value) -> Value {
    match value {
        toml::Value::String(text) => Value::String(text),
        toml::Value::Integer(number) => Value::from(number),
        toml::Value::Float(number) if number.is_finite() => Value::from(number),
        toml::Value::Float(number) if number.is_nan() => Value::from("nan"),
        toml::Value::Float(number) => Value::from(number.to_string()),
        toml::Value::Boolean(truth) => Value::Bool(truth),
        toml::Value::Datetime(date) => Value::String(date.to_string()),
        toml::Value::Array(items) => items.into_iter().map(json_of).collect(),
        toml::Value::Table(table) => json_of_table(table),
    }
}
