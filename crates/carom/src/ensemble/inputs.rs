//! The numbers of each row: given, on a grid, or drawn.

use super::{Design, Distribution, Draws};
use crate::scenario::{Problem, ScenarioError};
use core::ops::Range;

/// Where the numbers at a varied path come from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// A number for each row.
    Given(Vec<f64>),
    /// An axis of a grid: each of its numbers with each of those of the other axes. The last axis varies fastest.
    Axis(Vec<f64>),
    /// A random number for each row.
    Drawn(Distribution),
}

/// All numbers of an ensemble: a row of them for each run.
#[derive(Clone, Debug)]
pub struct Inputs {
    paths: Vec<String>,
    numbers: Vec<Numbers>,
    draws: Draws,
    rows: u64,
}

#[derive(Clone, Debug)]
enum Numbers {
    Given(Vec<f64>),
    /// Each number stands in so many rows before the next one comes.
    Axis(Vec<f64>, u64),
    /// With its place among those that are drawn.
    Drawn(Distribution, usize),
}

impl Inputs {
    /// The numbers at these paths, in so many rows. How many they are need be said only where all are drawn.
    ///
    /// # Errors
    ///
    /// Where lists differ in length, stand beside a grid, or give another number of rows than was asked for; where a path
    /// stands twice; where nobody says how many rows there are, or a distribution or a design makes no sense.
    pub fn new(
        sources: Vec<(String, Source)>,
        rows: Option<u64>,
        design: Design,
        seed: u64,
    ) -> Result<Self, ScenarioError> {
        let rows = rows_of(&sources, rows)?;
        let is_drawn = |source: &Source| matches!(source, Source::Drawn(_));
        let drawn: Vec<&str> =
            sources.iter().filter(|(_, source)| is_drawn(source)).map(|(path, _)| path.as_str()).collect();
        let draws = Draws::new(design, seed, rows, &drawn).map_err(|error| Problem::new("design", error))?;
        let (mut repeats, mut place) = (rows, 0);
        let mut paths: Vec<String> = Vec::new();
        let mut numbers = Vec::new();
        for (path, source) in sources {
            if paths.contains(&path) {
                return Err(Problem::new(path, "is varied twice").into());
            }
            numbers.push(match source {
                Source::Given(given) => Numbers::Given(given),
                Source::Axis(axis) => {
                    repeats /= axis.len() as u64;
                    Numbers::Axis(axis, repeats)
                }
                Source::Drawn(distribution) => {
                    distribution.check().map_err(|message| Problem::new(&path, message))?;
                    place += 1;
                    Numbers::Drawn(distribution, place - 1)
                }
            });
            paths.push(path);
        }
        Ok(Self { paths, numbers, draws, rows })
    }

    /// The varied paths, in order.
    pub fn paths(&self) -> &[String] {
        &self.paths
    }

    /// The number of runs.
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// The numbers of some rows, a column for each path.
    pub fn columns(&self, rows: Range<u64>) -> Vec<Vec<f64>> {
        let column = |numbers: &Numbers| rows.clone().map(|row| self.number(numbers, row)).collect();
        self.numbers.iter().map(column).collect()
    }

    /// Puts down the numbers of a row, in the order of the paths.
    #[inline(always)]
    pub fn fill(&self, row: u64, out: &mut [f64]) {
        for (out, numbers) in out.iter_mut().zip(&self.numbers) {
            *out = self.number(numbers, row);
        }
    }

    #[inline(always)]
    fn number(&self, numbers: &Numbers, row: u64) -> f64 {
        match numbers {
            Numbers::Given(given) => given[row as usize],
            Numbers::Axis(axis, repeats) => axis[(row / repeats % axis.len() as u64) as usize],
            Numbers::Drawn(distribution, place) => distribution.at(self.draws.unit(row, *place)),
        }
    }
}

fn rows_of(sources: &[(String, Source)], asked: Option<u64>) -> Result<u64, ScenarioError> {
    let mut lists = sources.iter().filter_map(|(path, source)| match source {
        Source::Given(given) => Some((path, given.len() as u64)),
        _ => None,
    });
    let axes = sources.iter().filter_map(|(path, source)| match source {
        Source::Axis(axis) => Some((path, axis.len() as u64)),
        _ => None,
    });
    let mut of_grid: Option<u64> = None;
    for (path, count) in axes {
        let product = of_grid.unwrap_or(1).checked_mul(count).filter(|product| *product > 0);
        let problem = || Problem::new(path, format!("an axis of {count} numbers gives no grid"));
        of_grid = Some(product.ok_or_else(problem)?);
    }
    let of_lists = lists.next();
    if let Some((first, count)) = of_lists {
        if let Some((path, other)) = lists.find(|(_, other)| *other != count) {
            let message =
                format!("has {other} numbers, and {first} has {count}: each needs one for each run");
            return Err(Problem::new(path, message).into());
        }
        if of_grid.is_some() {
            let message = "is a list beside a grid: give all of them as axes of the grid, or as lists";
            return Err(Problem::new(first, message).into());
        }
    }
    let found = of_grid.or(of_lists.map(|(_, count)| count));
    match (found, asked) {
        (Some(found), Some(asked)) if found != asked => {
            Err(Problem::new("runs", format!("asks for {asked}, and what is varied gives {found}")).into())
        }
        (None, None) => {
            Err(Problem::new("runs", "missing: say how many, as all that is varied is drawn").into())
        }
        (found, asked) => {
            let rows = found.or(asked).unwrap_or(0);
            let problem = || Problem::new("runs", "an ensemble of no runs: give one at least");
            (rows > 0).then_some(rows).ok_or_else(|| problem().into())
        }
    }
}
