//! The check of a scenario as a whole: what no single key or number can show.
//!
//! Everything is looked at, so that all problems are reported at once; a check leaves out what an earlier one found
//! unsound.

mod balls;
mod boundary;
mod ending;
mod ids;
mod laws;
mod magnitude;
mod placement;
mod stepped;

pub use magnitude::LARGEST;

use super::problem::Findings;
use super::schema::{Ball, BallDefaults, Method, Physics, Record, Scenario, Table};
use core::fmt;

/// What could be read of a scenario.
pub(crate) struct Draft<'a> {
    pub table: Option<&'a Table>,
    pub physics: &'a Physics,
    pub method: &'a Method,
    pub ball_defaults: &'a BallDefaults,
    pub balls: Vec<Option<&'a Ball>>,
    pub duration: Option<f64>,
    pub collisions: Option<u64>,
    pub record: Record,
}

impl<'a> Draft<'a> {
    /// All of a scenario.
    pub fn of(scenario: &'a Scenario) -> Self {
        Self {
            table: Some(&scenario.table),
            physics: &scenario.physics,
            method: &scenario.method,
            ball_defaults: &scenario.ball_defaults,
            balls: scenario.balls.iter().map(Some).collect(),
            duration: scenario.duration,
            collisions: scenario.collisions,
            record: scenario.record,
        }
    }

    /// The balls that could be read, with their places in the list.
    fn balls(&self) -> impl Iterator<Item = (usize, &'a Ball)> {
        self.balls.iter().enumerate().filter_map(|(index, ball)| Some((index, (*ball)?)))
    }
}

/// Notes everything that is wrong with a scenario whose structure has been checked.
pub(crate) fn check(draft: &Draft<'_>, findings: &mut Findings) {
    magnitude::check_magnitudes(draft, findings);
    balls::check_balls(draft, findings);
    let table = draft.table.map(|table| (table, table.layout(&mut |_, value| value)));
    if let Some((written, table)) = &table {
        ids::check_cushion_ids(written, table, findings);
        laws::check_laws(draft.physics, table, findings);
        boundary::check_boundary(written, table, findings);
        if findings.is_sound("table") {
            magnitude::check_proportions(draft, table, findings);
        }
        if findings.is_sound("table") {
            placement::check_placement(draft, table, findings);
        }
    }
    match draft.method {
        Method::Exact => ending::check_ending(draft, table.as_ref().map(|(_, table)| table), findings),
        Method::Stepped { dt, steps, .. } => stepped::check_stepped(draft, *dt, *steps, findings),
    }
}

/// A number in a message: four digits are enough to find what is meant.
struct Rounded(f64);

impl fmt::Display for Rounded {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded = format!("{:.3e}", self.0).parse().unwrap_or(self.0);
        if (1e-4..1e9).contains(&rounded) { write!(out, "{rounded}") } else { write!(out, "{rounded:e}") }
    }
}
