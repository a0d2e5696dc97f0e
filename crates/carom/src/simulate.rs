//! From a scenario to a run, by the method that the scenario names.

use crate::engine::{Limits, Simulation};
use crate::run::{Digest, Event, Kind, Log, PHYSICS_VERSION, Run, SimulationError, Status};
use crate::scenario::schema::{Method, Record, Table};
use crate::scenario::{Scenario, System};
use crate::stepped::{self, Ends, Readings};
use serde::Serialize;
use std::sync::Arc;

/// The event budget of a scenario that names neither one nor a number of collisions.
pub const DEFAULT_MAX_EVENTS: u64 = 10_000_000;

/// Steps between two looks at whether a run should be broken off.
const SLICE: u64 = 50_000;

/// Runs a checked scenario to its end.
pub fn simulate(scenario: &Scenario) -> Result<Run<f64>, SimulationError> {
    simulate_until(scenario, None, &mut || false)
}

/// Runs a checked scenario to its end, to the first event of a kind, or until `interrupted` says so; it is asked now and
/// then.
pub fn simulate_until(
    scenario: &Scenario,
    until: Option<Kind>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Run<f64>, SimulationError> {
    if let Method::Stepped { .. } = scenario.method {
        return Ok(simulate_stepped(scenario, until, interrupted));
    }
    let mut log = log_of(scenario);
    let simulation = Simulation::new(Arc::new(System::new(scenario)), limits_of(scenario, until), &mut log);
    go_on(simulation, log, interrupted)
}

/// Goes on from the end of a run of the same balls on the same table, up to the scenario's limits.
///
/// The result is the one longer run, with the bits it would have had at once; so the run must be of this version of the
/// physics, see [`is_same_physics`].
pub fn resume(
    scenario: &Scenario,
    run: &Run<f64>,
    until: Option<Kind>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Run<f64>, SimulationError> {
    if run.steps.is_some() {
        // A short last step is not one of the longer run's, so the steps are made anew.
        return Ok(simulate_stepped(scenario, until, interrupted));
    }
    go_on(Simulation::resume(run, limits_of(scenario, until)), run.log.clone(), interrupted)
}

fn go_on(
    mut simulation: Simulation<f64>,
    mut log: Log<f64>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Run<f64>, SimulationError> {
    while simulation.advance(SLICE, &mut log)? {
        if interrupted() {
            simulation.stop(Status::Interrupted);
        }
    }
    Ok(simulation.finish(log))
}

/// An empty log that keeps what the scenario wants kept.
pub fn log_of(scenario: &Scenario) -> Log<f64> {
    Log::new(scenario.record != Record::None, scenario.record == Record::All)
}

/// When a run of a scenario ends.
pub fn limits_of(scenario: &Scenario, until: Option<Kind>) -> Limits<f64> {
    Limits {
        duration: scenario.duration,
        collisions: scenario.collisions,
        max_events: max_events(scenario),
        until,
    }
}

fn max_events(scenario: &Scenario) -> u64 {
    let budget = if scenario.collisions.is_some() { u64::MAX } else { DEFAULT_MAX_EVENTS };
    scenario.max_events.unwrap_or(budget)
}

fn simulate_stepped(
    scenario: &Scenario,
    until: Option<Kind>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Run<f64> {
    let (readings, steps) = match &scenario.method {
        Method::Stepped { dt, after_hit, normal, last_step, steps } => {
            let readings =
                Readings { dt: *dt, after_hit: *after_hit, normal: *normal, last_step: *last_step };
            (readings, *steps)
        }
        Method::Exact => unreachable!("only called for the stepped method"),
    };
    let size = match scenario.table {
        Table::Rectangle { width, length, .. } => [width, length],
        _ => unreachable!("a checked stepped scenario has a rectangle"),
    };
    let mut ends = Ends {
        duration: scenario.duration.filter(|_| steps.is_none()).unwrap_or(f64::INFINITY),
        steps: steps.unwrap_or(u64::MAX),
        collisions: scenario.collisions.unwrap_or(u64::MAX),
        events: max_events(scenario),
        until,
        interrupted,
    };
    stepped::run(Arc::new(System::new(scenario)), size, &readings, &mut ends, log_of(scenario))
}

/// The first thing in which a run computed again differs from the one that was saved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// What differs, such as `events[3].time`.
    pub place: String,
    /// What was saved.
    pub saved: String,
    /// What came out now.
    pub now: String,
}

/// Runs a scenario again and compares; `None` when every bit is the same, or when `interrupted` broke it off.
///
/// A run that was stopped from outside is compared up to where it was. Where one made with another version of the physics
/// differs, that version is the difference: `physics_version`.
pub fn verify(
    scenario: &Scenario,
    saved: &Run<f64>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Option<Difference>, SimulationError> {
    let mut broken_off = false;
    let mut note = || {
        broken_off |= interrupted();
        broken_off
    };
    let now = match (saved.status, &saved.steps) {
        (Status::Stopped | Status::Interrupted, None) => rerun_part(scenario, saved, &mut note)?,
        (Status::Stopped | Status::Interrupted, Some(steps)) => {
            let part = with_steps(scenario, steps.count);
            let mut now = simulate_until(&part, None, &mut note)?;
            now.status = saved.status;
            now
        }
        _ => simulate_until(scenario, None, &mut note)?,
    };
    Ok(if broken_off { None } else { first_difference(saved, &now).map(|found| explained(found, saved)) })
}

fn rerun_part(
    scenario: &Scenario,
    saved: &Run<f64>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Run<f64>, SimulationError> {
    let mut log = log_of(scenario);
    let limits = limits_of(scenario, None);
    let mut simulation = Simulation::new(Arc::new(System::new(scenario)), limits, &mut log);
    let events = saved.diagnostics.total_events();
    while simulation.diagnostics().total_events() < events && simulation.step(&mut log)? {
        if simulation.diagnostics().total_events().is_multiple_of(SLICE) && interrupted() {
            simulation.stop(Status::Interrupted);
        }
    }
    simulation.stop_at(saved.status, saved.end_time, &mut log)?;
    Ok(simulation.finish(log))
}

/// A scenario of the fixed-step method that ends after a number of steps.
fn with_steps(scenario: &Scenario, count: u64) -> Scenario {
    let mut part = scenario.clone();
    if let Method::Stepped { steps, .. } = &mut part.method {
        *steps = Some(count);
    }
    part
}

/// What a difference comes from: the bits of another version of the physics need not be the same.
fn explained(found: Difference, saved: &Run<f64>) -> Difference {
    if is_same_physics(saved.physics_version) {
        return found;
    }
    let versions = [saved.physics_version, PHYSICS_VERSION].map(|version| version.to_string());
    let [saved, now] = versions;
    Difference { place: "physics_version".to_owned(), saved, now }
}

fn first_difference(saved: &Run<f64>, now: &Run<f64>) -> Option<Difference> {
    let difference =
        |place: &str, saved: String, now: String| Difference { place: place.to_owned(), saved, now };
    if let Some((k, a, b)) = first_unequal(&saved.log.events, &now.log.events) {
        return Some(difference_of_events(k, a, b));
    }
    if let Some((k, a, b)) = first_unequal(&saved.log.flights, &now.log.flights) {
        return Some(difference(&format!("flights[{k}]"), format!("{a:?}"), format!("{b:?}")));
    }
    let steps = [saved, now].map(|run| run.steps.as_ref().map_or(&[][..], |steps| &steps.steps));
    if let Some((k, a, b)) = first_unequal(steps[0], steps[1]) {
        return Some(difference(&format!("steps[{k}]"), format!("{a:?}"), format!("{b:?}")));
    }
    let counts = [saved, now].map(|run| run.diagnostics.total_events());
    let digests = [saved, now].map(|run| run.digest().unwrap_or_else(Digest::none));
    let fields = [
        ("events", counts.map(|n| n.to_string())),
        ("status", [saved, now].map(|run| run.status.name().to_owned())),
        ("end_time", [saved, now].map(|run| format!("{:?}", run.end_time))),
        ("digest", digests.map(|digest| digest.state)),
    ];
    fields.into_iter().find(|(_, [a, b])| a != b).map(|(place, [a, b])| difference(place, a, b))
}

fn first_unequal<'a, T: PartialEq>(saved: &'a [T], now: &'a [T]) -> Option<(usize, &'a T, &'a T)> {
    let pairs = saved.iter().zip(now).enumerate();
    pairs.map(|(k, (a, b))| (k, a, b)).find(|(_, a, b)| a != b)
}

fn difference_of_events(k: usize, saved: &Event<f64>, now: &Event<f64>) -> Difference {
    let words = |event: &Event<f64>| {
        let numbers = |x: f64, y: f64| format!("[{x:?}, {y:?}]");
        [
            ("time", format!("{:?}", event.time)),
            ("kind", event.kind.name().to_owned()),
            ("ball_a", event.ball_a.to_string()),
            ("ball_b", format!("{:?}", event.ball_b)),
            ("cushion", format!("{:?}", event.cushion)),
            ("point", numbers(event.point.x, event.point.y)),
            ("normal", numbers(event.normal.x, event.normal.y)),
            ("closing_speed", format!("{:?}", event.closing_speed)),
            ("impulse", format!("{:?}", event.impulse)),
            ("cluster", format!("{:?}", event.cluster)),
        ]
    };
    let pairs = words(saved).into_iter().zip(words(now)).find(|((_, a), (_, b))| a != b);
    let ((field, saved), (_, now)) = pairs.unwrap_or_default();
    Difference { place: format!("events[{k}].{field}"), saved, now }
}

/// Whether a run of that version of the physics was made by this one.
pub fn is_same_physics(version: u32) -> bool {
    version == PHYSICS_VERSION
}
