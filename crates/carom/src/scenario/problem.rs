//! What is wrong with a scenario, and where.

use core::fmt;
use std::collections::BTreeSet;

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Where: a path such as `balls[1].radius`, a line and column of a text, or `scenario` for the whole.
    pub place: String,
    /// What.
    pub message: String,
}

/// Everything that is wrong with a scenario: at least one problem.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct ScenarioError {
    /// The problems: first those of single keys and numbers, then those of the whole.
    pub problems: Vec<Problem>,
}

impl Problem {
    /// A problem at a place.
    pub fn new(place: impl fmt::Display, message: impl fmt::Display) -> Self {
        Self { place: place.to_string(), message: message.to_string() }
    }
}

impl From<Problem> for ScenarioError {
    fn from(problem: Problem) -> Self {
        Self { problems: vec![problem] }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.place, self.message)
    }
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, problem) in self.problems.iter().enumerate() {
            let separator = if index == 0 { "" } else { "\n" };
            write!(out, "{separator}{problem}")?;
        }
        Ok(())
    }
}

/// The problems found so far, and the places that a later check cannot build on.
#[derive(Debug, Default)]
pub(crate) struct Findings {
    problems: Vec<Problem>,
    unsound: BTreeSet<String>,
}

impl Findings {
    /// Notes a problem; checks that need what stands at its place, or inside it, will be left out.
    pub fn add(&mut self, place: impl fmt::Display, message: impl fmt::Display) {
        self.unsound.insert(place.to_string());
        self.note(place, message);
    }

    /// Notes a problem that no other check depends on, such as an unknown key.
    pub fn note(&mut self, place: impl fmt::Display, message: impl fmt::Display) {
        self.problems.push(Problem::new(place, message));
    }

    /// Whether no problem was found at a place or inside it.
    pub fn is_sound(&self, place: impl fmt::Display) -> bool {
        if self.unsound.is_empty() {
            return true;
        }
        let place = place.to_string();
        let mut inside = self.unsound.range(place.clone()..);
        !inside.next().is_some_and(|found| found.starts_with(&place))
    }

    /// The problems, if there are any, as an error.
    pub fn into_result(self) -> Result<(), ScenarioError> {
        if self.problems.is_empty() { Ok(()) } else { Err(ScenarioError { problems: self.problems }) }
    }
}
