//! Balls that stand in a file of their own: what a reader of files gives is put in their place.
//!
//! The engine opens no file: whoever loads a scenario brings the reader along.

use super::problem::{Findings, Problem, ScenarioError};
use super::schema::{Ball, BallsFrom, BallsSource, Scenario, Table};
use crate::gas;
use crate::geometry::Vec2;

/// One frame of a file, as a reader gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct BallsRead {
    /// The names of the balls; `None`: "0", "1", ...
    pub ids: Option<Vec<String>>,
    /// Where they are in the box, whose lower left corner is the origin.
    pub positions: Vec<[f64; 2]>,
    /// `None`: the file has none.
    pub velocities: Option<Vec<[f64; 2]>>,
    /// Of every ball.
    pub radii: Vec<f64>,
    /// Of every ball.
    pub masses: Vec<f64>,
    /// Width and length of the box.
    pub size: [f64; 2],
    /// Whether the box repeats itself along x and y.
    pub periodic: [bool; 2],
    /// Which frame it is, from 0.
    pub frame: u64,
    /// The SHA-256 of the file.
    pub sha256: String,
}

/// Reads the file that `[balls_from]` names.
pub type BallsReader<'a> = dyn FnMut(&BallsFrom) -> Result<BallsRead, ScenarioError> + 'a;

/// The reader where there are no files: a scenario that needs one is refused.
pub(super) fn no_files(_: &BallsFrom) -> Result<BallsRead, ScenarioError> {
    let message =
        "the file is read where a scenario is loaded: by carom.load in Python, and by carom on the shell";
    Err(Problem::new("balls_from.path", message).into())
}

impl Scenario {
    /// Puts the balls of the file in the place of `balls_from`, and its box where no table is given.
    pub(super) fn read_balls(&mut self, reader: &mut BallsReader<'_>, findings: &mut Findings) {
        let Some(from) = &self.balls_from else { return };
        self.check_beside(findings);
        if !findings.is_sound("balls_from") {
            return;
        }
        let read = reader(from).and_then(|read| Ok((velocities(from, &read, self.periodic(&read))?, read)));
        match read {
            Ok((velocities, read)) => self.take(read, &velocities),
            Err(error) => {
                error.problems.into_iter().for_each(|problem| findings.add(problem.place, problem.message));
            }
        }
    }

    /// Notes what cannot be given beside balls from a file.
    fn check_beside(&self, findings: &mut Findings) {
        let defaults = &self.ball_defaults;
        let beside = [
            ("balls", !self.balls.is_empty()),
            ("rack", self.rack.is_some()),
            ("gas", self.gas.is_some()),
            ("balls_source", self.balls_source.is_some()),
            ("ball_defaults.radius", defaults.radius.is_some()),
            ("ball_defaults.mass", defaults.mass.is_some()),
        ];
        for (key, _) in beside.into_iter().filter(|(_, is_given)| *is_given) {
            let instead = key.strip_prefix("ball_defaults.").map_or_else(
                || "give one of them".into(),
                |key| format!("give balls_from.{key}, which holds where the file has none"),
            );
            findings.add("balls_from", format!("is given beside {key}: {instead}"));
        }
    }

    /// Whether the table that the balls will be on repeats itself, along x and y.
    fn periodic(&self, read: &BallsRead) -> [bool; 2] {
        if self.table == Table::Absent { read.periodic } else { self.table.periodic() }
    }

    fn take(&mut self, read: BallsRead, velocities: &[[f64; 2]]) {
        let has_no_table = self.table == Table::Absent;
        if has_no_table {
            self.table = Table::plain_box(read.size, read.periodic);
        }
        let factor = self.balls_from.take().and_then(|from| {
            let BallsRead { frame, sha256, .. } = &read;
            let sha256 = sha256.clone();
            self.balls_source =
                Some(BallsSource { path: from.path, frame: *frame, sha256, table: has_no_table });
            from.radius_factor
        });
        let ids =
            read.ids.unwrap_or_else(|| (0..read.positions.len()).map(|ball| ball.to_string()).collect());
        let radius = |radius: f64| factor.map_or(radius, |factor| radius * factor);
        let ball = |(ball, id)| {
            let (position, velocity) = (read.positions[ball], velocities[ball]);
            Ball::disc(id, radius(read.radii[ball]), read.masses[ball], position, velocity)
        };
        self.balls = ids.into_iter().enumerate().map(ball).collect();
    }
}

/// The velocities of the file, or else Maxwell's.
fn velocities(
    from: &BallsFrom,
    read: &BallsRead,
    periodic: [bool; 2],
) -> Result<Vec<[f64; 2]>, ScenarioError> {
    match (&read.velocities, from.temperature) {
        (Some(velocities), None) => Ok(velocities.clone()),
        (Some(_), Some(_)) => {
            let message = "is for a file without velocities, and this one has some: leave it out";
            Err(Problem::new("balls_from.temperature", message).into())
        }
        (None, Some(temperature)) => {
            let drawn = gas::maxwell(&read.masses, temperature, periodic, from.seed);
            Ok(drawn.into_iter().map(|Vec2 { x, y }| [x, y]).collect())
        }
        (None, None) => {
            let message = "missing: the file has no velocities; 1.0 draws Maxwell's for kT = 1, and 0 leaves all at rest";
            Err(Problem::new("balls_from.temperature", message).into())
        }
    }
}
