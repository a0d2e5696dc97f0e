//! When an observed run is looked at, and what it hands out on the way.

use super::COLLISIONS_PER_SAMPLE;
use crate::scenario::schema::{Method, Table};
use crate::scenario::{Problem, Scenario};
use serde::{Deserialize, Serialize};

/// What is to come of a run beside its end.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// When the gas is shown to the observables.
    pub sampling: Sampling,
    /// When snapshots are handed out.
    pub snapshots: Snapshots,
    /// Of which time events are handed out; `None`: of none.
    pub window: Option<Window>,
}

/// When the gas is shown to the observables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Sampling {
    /// Collisions of each disc with others that come before the first sample.
    pub equilibrate: f64,
    /// The time between samples; `None`: that of [`COLLISIONS_PER_SAMPLE`](super::COLLISIONS_PER_SAMPLE) collisions of
    /// each disc, at the rate seen in equilibrating, or up to the second sample.
    pub interval: Option<f64>,
}

/// When snapshots are handed out. One that is due at a time comes after all events up to then.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Snapshots {
    /// Never.
    #[default]
    Never,
    /// At the start, and at equal intervals from then on.
    EveryTime(f64),
    /// At the start, and whenever so many more collisions have happened, as the limits of a run count them.
    EveryCollisions(u64),
    /// At these times.
    At(Vec<f64>),
}

/// A span of time, its ends included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Window {
    /// Its beginning.
    pub from: f64,
    /// Its end.
    pub to: f64,
}

/// When the next snapshot is due.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Due {
    Time(f64),
    Collisions(u64),
    Never,
}

impl Snapshots {
    /// When the next one is due after so many.
    pub(super) fn due(&self, taken: u64) -> Due {
        match self {
            Self::Never => Due::Never,
            Self::EveryTime(interval) => Due::Time(interval * taken as f64),
            Self::EveryCollisions(collisions) => Due::Collisions(collisions.saturating_mul(taken)),
            Self::At(times) => times.get(taken as usize).map_or(Due::Never, |time| Due::Time(*time)),
        }
    }

    fn check(&self) -> Result<(), Problem> {
        let is_ascending = |times: &[f64]| times.windows(2).all(|pair| pair[0] < pair[1]);
        match self {
            Self::EveryTime(interval) if !(*interval > 0.0 && interval.is_finite()) => {
                problem("snapshots.every_time", "must be a positive time")
            }
            Self::EveryCollisions(0) => problem("snapshots.every_collisions", "must be one or more"),
            Self::At(times) if times.is_empty() => problem("snapshots.at", "must have a time at least"),
            Self::At(times) if !times.iter().all(|time| *time >= 0.0 && time.is_finite()) => {
                problem("snapshots.at", "must be times from zero on")
            }
            Self::At(times) if !is_ascending(times) => {
                problem("snapshots.at", "must be times that ascend, each of them once")
            }
            Self::Never | Self::EveryTime(_) | Self::EveryCollisions(_) | Self::At(_) => Ok(()),
        }
    }
}

/// Refuses a scenario that is no gas in a rectangle, and a plan that is none.
pub(super) fn check(scenario: &Scenario, plan: &Plan) -> Result<(), Problem> {
    let Sampling { equilibrate, interval } = plan.sampling;
    check_gas(scenario)?;
    if !(equilibrate >= 0.0 && equilibrate.is_finite()) {
        problem("equilibrate", "must be a number of collisions of each disc, from zero on")
    } else if interval.is_some_and(|interval| !(interval > 0.0 && interval.is_finite())) {
        problem("sample_interval", "must be a positive time")
    } else if plan.window.is_some_and(|Window { from, to }| !(from >= 0.0 && to >= from)) {
        problem("events.window", "must be two times from zero on, the earlier one first")
    } else {
        plan.snapshots.check()
    }
}

/// Refuses a limit that surely comes before the second sample, so that nobody waits for a run that measures nothing.
pub(super) fn check_length(scenario: &Scenario, plan: &Plan, discs: usize) -> Result<(), Problem> {
    let Sampling { equilibrate, interval } = plan.sampling;
    // Where the rate is seen before the first sample, the second comes at a time that is not known yet.
    let chooses = interval.is_none() && equilibrate < COLLISIONS_PER_SAMPLE;
    let of_each = equilibrate + if chooses { COLLISIONS_PER_SAMPLE } else { 0.0 };
    let fewest = (0.5 * discs as f64 * of_each).ceil();
    if scenario.collisions.is_none_or(|collisions| collisions as f64 >= fewest) {
        return Ok(());
    }
    let message = format!(
        "must be {fewest} or more to measure {discs} discs, as {of_each} of each come before the second sample: let it go \
         on for longer, or shorten equilibrate or the interval between samples"
    );
    problem("collisions", &message)
}

fn check_gas(scenario: &Scenario) -> Result<(), Problem> {
    let expanded = scenario.expanded();
    let is_plain = matches!(&expanded.table, Table::Rectangle { obstacles, .. } if obstacles.is_empty());
    if expanded.physics.has_cloth() {
        problem("physics.flight", "a gas is one of discs: balls on a cloth cannot be observed")
    } else if !is_plain {
        problem("table", "a gas is observed in a rectangle without obstacles, whose area and walls are known")
    } else if scenario.method != Method::Exact {
        problem("method", "only runs with the exact method can be observed")
    } else {
        Ok(())
    }
}

fn problem(place: &str, message: &str) -> Result<(), Problem> {
    Err(Problem { place: place.to_owned(), message: message.to_owned() })
}
