//! A scenario of which many are made that differ in some numbers.

use super::places::Places;
use super::problem::{Findings, ScenarioError};
use super::schema::{Record, Scenario};
use super::structure::check_structure;
use super::values::with_changes;
use serde_json::{Value, json};

/// A scenario with places for numbers, each at a path.
#[derive(Clone, Debug)]
pub struct Template {
    whole: Value,
    paths: Vec<String>,
    /// Whether what stands at a path is a whole number.
    is_whole: Vec<bool>,
}

/// A number that is in the range of each of a scenario's by itself.
const ANYWHERE: f64 = 1.0;

impl Template {
    /// A scenario with places at some paths; what its runs keep is `record`.
    pub fn new(scenario: &Scenario, paths: &[String], record: Record) -> Result<Self, ScenarioError> {
        let whole = Scenario { record: Some(record), ..scenario.clone() }.to_value()?;
        let is_whole =
            |path: &String| scenario.value(path).is_ok_and(|value| value.is_u64() || value.is_i64());
        let is_whole = paths.iter().map(is_whole).collect();
        Ok(Self { whole, paths: paths.to_vec(), is_whole })
    }

    /// The scenario with these numbers in the places, checked.
    pub fn with(&self, numbers: &[f64]) -> Result<Scenario, ScenarioError> {
        Scenario::from_value(&self.value_with(numbers)?)
    }

    /// Checks that a number may stand at each path, whichever it is.
    pub fn check_paths(&self) -> Result<(), ScenarioError> {
        let mut findings = Findings::default();
        check_structure(&self.value_with(&vec![ANYWHERE; self.paths.len()])?, &mut findings);
        findings.into_result()
    }

    /// The places as such that a run can start again with; see [`Places::new`].
    pub fn places(&self) -> Option<Places> {
        // A scenario that has numbers at all paths, so that speeds are there where components are written. No tip meets a ball
        // a radius to the left and a radius above its middle.
        let numbers = [ANYWHERE, 0.5 * ANYWHERE];
        let scenario =
            numbers.into_iter().find_map(|number| self.with(&vec![number; self.paths.len()]).ok())?;
        Places::new(&scenario, &self.paths)
    }

    fn value_with(&self, numbers: &[f64]) -> Result<Value, ScenarioError> {
        let value = |&number: &f64, is_whole: &bool| match number {
            _ if !number.is_finite() => json!(number.to_string().to_lowercase()),
            _ if *is_whole && number.fract() == 0.0 && number.abs() < 9e15 => json!(number as i64),
            _ => json!(number),
        };
        let values = numbers.iter().zip(&self.is_whole).map(|(number, is_whole)| value(number, is_whole));
        let changes: Vec<(&String, Value)> = self.paths.iter().zip(values).collect();
        with_changes(self.whole.clone(), &changes)
    }
}
