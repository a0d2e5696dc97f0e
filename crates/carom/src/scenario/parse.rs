//! Scenario texts: TOML and JSON, read and written.

use super::balls_from::{BallsReader, no_files};
use super::check::{Draft, check};
use super::expand::with_rack;
use super::json;
use super::problem::{Findings, Problem, ScenarioError};
use super::schema::{Ball, BallDefaults, Cue, FORMAT, Gas, Physics, Rack, Scenario, Shot, Table};
use super::structure::check_structure;
use super::values::with_changes;
use serde::Deserialize;
use serde_json::{Map, Value};

impl Scenario {
    /// Reads and checks a scenario written in TOML.
    pub fn from_toml(text: &str) -> Result<Self, ScenarioError> {
        Self::from_toml_with(text, &[], &mut no_files)
    }

    /// Reads and checks a scenario written in JSON.
    pub fn from_json(text: &str) -> Result<Self, ScenarioError> {
        Self::from_json_with(text, &[], &mut no_files)
    }

    /// Reads and checks a scenario given as a JSON value; the texts "nan", "inf" and "-inf" stand for such numbers.
    pub fn from_value(value: &Value) -> Result<Self, ScenarioError> {
        Self::from_value_with(value, &mut no_files)
    }

    /// The same as [`Scenario::from_toml`], with a reader for balls that stand in a file, and values changed before it reads.
    pub fn from_toml_with(
        text: &str,
        values: &[(String, Value)],
        reader: &mut BallsReader<'_>,
    ) -> Result<Self, ScenarioError> {
        Self::from_value_with(&with_changes(value_of_toml(text)?, values)?, reader)
    }

    /// The same as [`Scenario::from_json`], with a reader for balls that stand in a file, and values changed before it reads.
    pub fn from_json_with(
        text: &str,
        values: &[(String, Value)],
        reader: &mut BallsReader<'_>,
    ) -> Result<Self, ScenarioError> {
        if text.trim().is_empty() {
            return Err(empty().into());
        }
        let value = json::read(text).map_err(|error| json_problem(&error))?;
        Self::from_value_with(&with_changes(value, values)?, reader)
    }

    fn from_value_with(value: &Value, reader: &mut BallsReader<'_>) -> Result<Self, ScenarioError> {
        refuse_outright(value)?;
        let mut findings = Findings::default();
        let usable = check_structure(value, &mut findings);
        match serde_path_to_error::deserialize(&usable) {
            Ok(mut scenario) => {
                Self::read_balls(&mut scenario, reader, &mut findings);
                check(&Draft::of(&scenario, &scenario.expanded()), &mut findings);
                findings.into_result()?;
                Ok(Self::with_plain_record(scenario))
            }
            Err(error) => {
                check_parts(&usable, &mut findings);
                findings.into_result()?;
                // The structure check has let something pass that the structs do not take.
                Err(Problem::new(error.path(), error.inner()).into())
            }
        }
    }

    /// Checks a scenario that was put together in a program.
    pub fn check(&self) -> Result<(), ScenarioError> {
        Self::from_value(&self.to_value()?).map(|_| ())
    }

    /// The scenario as a JSON value; what is absent or has its default is left out.
    pub fn to_value(&self) -> Result<Value, ScenarioError> {
        // By way of TOML, which knows nan and inf, so that none of them is lost before a check.
        let table = toml::Table::try_from(self).map_err(|error| Problem::new("scenario", error))?;
        Ok(json_of_table(table))
    }

    /// The scenario as JSON text; reading it gives the same scenario, bit for bit.
    pub fn to_json(&self) -> Result<String, ScenarioError> {
        serde_json::to_string_pretty(&self.to_value()?)
            .map_err(|error| Problem::new("scenario", error).into())
    }

    /// The scenario as TOML text; reading it gives the same scenario, bit for bit.
    pub fn to_toml(&self) -> Result<String, ScenarioError> {
        toml::to_string(self).map_err(|error| Problem::new("scenario", error).into())
    }
}

/// A text in TOML as a JSON value; the texts "nan", "inf" and "-inf" stand for such numbers.
pub fn value_of_toml(text: &str) -> Result<Value, ScenarioError> {
    let document: toml::Table = text.parse().map_err(|error| toml_problem(text, &error))?;
    Ok(json_of_table(document))
}

/// Refuses what it makes no sense to look at more closely: nothing at all, and a format of the future.
fn refuse_outright(value: &Value) -> Result<(), Problem> {
    if value.as_object().is_some_and(Map::is_empty) {
        return Err(empty());
    }
    match value.get("format").and_then(Value::as_f64) {
        Some(format) if format > f64::from(FORMAT) => Err(Problem::new(
            "format",
            format!("format {format} is newer than format {FORMAT}, the newest known here"),
        )),
        _ => Ok(()),
    }
}

fn empty() -> Problem {
    Problem::new("scenario", "is empty: it needs at least a table and a ball")
}

/// Checks what can be read of a scenario that cannot be read as a whole.
fn check_parts(usable: &Value, findings: &mut Findings) {
    let gas: Option<Gas> = part(usable.get("gas"));
    let written: Option<Table> = part(usable.get("table"));
    let preset = written.as_ref().and_then(Table::preset).map(|table| table.preset);
    let table = written.as_ref().map(Table::expanded);
    let physics = part(usable.get("physics")).unwrap_or_else(Physics::default).over(preset);
    let method = part(usable.get("method")).unwrap_or_default();
    let ball_defaults = part(usable.get("ball_defaults")).unwrap_or_else(BallDefaults::default).over(preset);
    let rack: Option<Rack> = part(usable.get("rack"));
    let shot: Option<Shot> = part(usable.get("shot"));
    let cue = part(usable.get("cue")).unwrap_or_else(Cue::default).over(preset, shot.is_some());
    let balls = usable.get("balls").and_then(Value::as_array);
    let written_balls: Vec<Option<Ball>> = balls.into_iter().flatten().map(|ball| part(Some(ball))).collect();
    let balls = with_rack(&written_balls, rack.as_ref(), table.as_deref(), &ball_defaults, preset);
    let draft = Draft {
        written: written.as_ref(),
        table: table.as_deref(),
        physics: &physics,
        method: &method,
        ball_defaults: &ball_defaults,
        balls: balls.iter().map(Option::as_ref).collect(),
        written_balls: written_balls.len(),
        rack: rack.as_ref(),
        gas: gas.as_ref(),
        reads_balls: usable.get("balls_from").is_some(),
        cue: &cue,
        shot: shot.as_ref(),
        duration: part(usable.get("duration")),
        collisions: part(usable.get("collisions")),
        record: part(usable.get("record")).unwrap_or_default(),
    };
    check(&draft, findings);
}

fn part<'a, T: Deserialize<'a>>(value: Option<&'a Value>) -> Option<T> {
    value.and_then(|value| T::deserialize(value).ok())
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
