//! A scenario of which many are made that differ in some numbers.

use super::path::{Step, parse};
use super::problem::{Findings, ScenarioError};
use super::schema::{Ball, BallDefaults, Method, Record, Scenario};
use super::start::BallStart;
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

/// The velocities with which some balls start, as places for numbers.
#[derive(Clone, Debug)]
pub struct Velocities {
    /// The balls that start otherwise, with their places in the scenario.
    balls: Vec<(usize, Ball)>,
    defaults: BallDefaults,
    /// For each number the ball, by its place in the list above, and what of it the number is.
    parts: Vec<(usize, Part)>,
}

/// A number of a ball's motion at the start.
#[derive(Clone, Copy, Debug)]
enum Part {
    Component(usize),
    Speed,
    Direction,
}

/// A number that is in the range of each of a scenario's by itself.
const ANYWHERE: f64 = 1.0;

/// Numbers as large and as small as these, and zero, are what every check lets pass.
const ORDINARY: core::ops::Range<f64> = 1e-70..1e70;

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

    /// The places as those of velocities, where they are nothing else; see [`Velocities::new`].
    pub fn velocities(&self) -> Option<Velocities> {
        // A scenario that has numbers at all paths, so that speeds are there where components are written.
        let scenario = self.with(&vec![ANYWHERE; self.paths.len()]).ok()?;
        Velocities::new(&scenario, &self.paths)
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

impl Velocities {
    /// The places at these paths of a scenario that has numbers at all of them; `None` where any is another thing than a
    /// number of the velocity of a disc, or where it may depend on velocities how a run ends.
    pub fn new(scenario: &Scenario, paths: &[String]) -> Option<Self> {
        let scenario = &*scenario.expanded();
        let has_end = scenario.duration.is_some() || scenario.collisions.is_some();
        if scenario.has_cloth() || scenario.method != Method::Exact || !has_end {
            return None;
        }
        let mut places =
            Self { balls: Vec::new(), defaults: scenario.ball_defaults.clone(), parts: Vec::new() };
        for path in paths {
            let (index, part) = part_of(&parse(&scenario.place(path).ok()?).ok()?)?;
            let ball = scenario.balls.get(index)?;
            let listed = places.balls.iter().position(|(known, _)| *known == index);
            let listed = listed.unwrap_or_else(|| {
                places.balls.push((index, ball.clone()));
                places.balls.len() - 1
            });
            places.parts.push((listed, part));
        }
        Some(places)
    }

    /// Puts numbers in the places; `false`, and they are not all there, where one is so unusual that a check has to look at it.
    pub fn set(&mut self, numbers: &[f64]) -> bool {
        let mut is_ordinary = true;
        for (&number, &(ball, part)) in numbers.iter().zip(&self.parts) {
            is_ordinary &= number == 0.0 || ORDINARY.contains(&number.abs());
            let ball = &mut self.balls[ball].1;
            match (part, &mut ball.velocity) {
                (Part::Component(axis), Some(velocity)) => velocity.plan[axis] = number,
                (Part::Speed, _) => {
                    is_ordinary &= number >= 0.0;
                    ball.speed = Some(number);
                }
                (Part::Direction, _) => ball.direction_deg = Some(number),
                (Part::Component(_), None) => is_ordinary = false,
            }
        }
        is_ordinary
    }

    /// How the balls start then, with their places in the scenario.
    pub fn starts(&self) -> impl Iterator<Item = (usize, BallStart<f64>)> {
        let start = |ball: &Ball, index| ball.start(index, &self.defaults, &mut |_, value| value);
        self.balls.iter().map(move |(index, ball)| (*index, start(ball, *index)))
    }
}

/// The ball whose start a path is a number of, and which.
fn part_of(steps: &[Step]) -> Option<(usize, Part)> {
    let [Step::Key(balls), Step::Index(index), Step::Key(key), rest @ ..] = steps else { return None };
    let part = match (key.as_str(), rest) {
        ("velocity", [Step::Index(axis @ (0 | 1))]) => Part::Component(*axis),
        ("speed", []) => Part::Speed,
        ("direction_deg", []) => Part::Direction,
        _ => return None,
    };
    (balls == "balls").then_some((*index, part))
}
