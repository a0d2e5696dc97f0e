//! The check of a scenario as a whole: what no single key or number can show.
//!
//! Everything is looked at, so that all problems are reported at once; a check leaves out what an earlier one found
//! unsound.

mod balls;
mod boundary;
mod cloth;
mod ending;
mod gas;
mod ids;
mod laws;
mod magnitude;
mod periodic;
mod placement;
mod pockets;
mod rack;
mod shot;
mod stepped;

pub use magnitude::LARGEST;

use super::problem::Findings;
use super::schema::{Ball, BallDefaults, Cue, Gas, Method, Physics, Rack, Record, Scenario, Shot, Table};
use core::fmt;

/// What could be read of a scenario, with its preset, its rack and its gas turned into plain keys.
pub(crate) struct Draft<'a> {
    /// The table as it is written.
    pub written: Option<&'a Table>,
    pub table: Option<&'a Table>,
    pub physics: &'a Physics,
    pub method: &'a Method,
    pub ball_defaults: &'a BallDefaults,
    /// The balls: first those that are written, so many of them, then those of the rack, or all those of the gas.
    pub balls: Vec<Option<&'a Ball>>,
    pub written_balls: usize,
    pub rack: Option<&'a Rack>,
    pub gas: Option<&'a Gas>,
    /// Whether balls, and perhaps the table, are still to be read from a file.
    pub reads_balls: bool,
    pub cue: &'a Cue,
    pub shot: Option<&'a Shot>,
    pub duration: Option<f64>,
    pub collisions: Option<u64>,
    pub record: Record,
}

impl<'a> Draft<'a> {
    /// All of a scenario, and the same one expanded.
    pub fn of(written: &'a Scenario, expanded: &'a Scenario) -> Self {
        Self {
            written: Some(&written.table),
            table: Some(&expanded.table).filter(|table| **table != Table::Absent),
            physics: &expanded.physics,
            method: &expanded.method,
            ball_defaults: &expanded.ball_defaults,
            balls: expanded.balls.iter().map(Some).collect(),
            written_balls: written.balls.len(),
            rack: written.rack.as_ref(),
            gas: written.gas.as_ref(),
            reads_balls: written.balls_from.is_some(),
            cue: &expanded.cue,
            shot: expanded.shot.as_ref(),
            duration: expanded.duration,
            collisions: expanded.collisions,
            record: written.record(),
        }
    }

    /// The balls that could be read, with their places in the list.
    fn balls(&self) -> impl Iterator<Item = (usize, &'a Ball)> {
        self.balls.iter().enumerate().filter_map(|(index, ball)| Some((index, (*ball)?)))
    }

    /// Where a key of a ball is written, or else the rack or the gas that the ball is from.
    fn place(&self, index: usize, key: &str) -> String {
        match self.gas {
            Some(_) => "gas".into(),
            None if index < self.written_balls => format!("balls[{index}].{key}"),
            None => "rack".into(),
        }
    }
}

/// Notes everything that is wrong with a scenario whose structure has been checked.
pub(crate) fn check(draft: &Draft<'_>, findings: &mut Findings) {
    gas::check_gas(draft, findings);
    magnitude::check_magnitudes(draft, findings);
    rack::check_rack(draft, findings);
    balls::check_balls(draft, findings);
    cloth::check_cloth(draft, findings);
    laws::check_parameters(draft.physics, findings);
    shot::check_shot(draft, findings);
    periodic::check_periodic(draft, findings);
    let table = draft.table.map(|table| (table, table.layout(&mut |_, value| value)));
    if let Some((written, table)) = &table {
        ids::check_cushion_ids(written, table, findings);
        laws::check_laws(draft.physics, written, table, findings);
        pockets::check_pockets(draft, table, findings);
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
        if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
            write!(out, "{rounded}")
        } else {
            write!(out, "{rounded:e}")
        }
    }
}
