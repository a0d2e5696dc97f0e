//! A run computed again and compared with the one that was saved.

use super::{SLICE, Simulated, is_same_physics, simulate_until, start};
use crate::run::{Diagnostics, Digest, Event, PHYSICS_VERSION, Run, SimulationError, Status, Steps};
use crate::scenario::Scenario;
use crate::scenario::schema::Method;
use core::fmt::Debug;
use serde::Serialize;

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
pub fn verify<D: Simulated>(
    scenario: &Scenario,
    saved: &Run<f64, D>,
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
            let part = with_steps(scenario, D::as_steps(steps).count);
            let mut now = simulate_until(&part, None, &mut note)?;
            now.status = saved.status;
            now
        }
        _ => simulate_until(scenario, None, &mut note)?,
    };
    Ok(if broken_off { None } else { first_difference(saved, &now).map(|found| explained(found, saved)) })
}

fn rerun_part<D: Simulated>(
    scenario: &Scenario,
    saved: &Run<f64, D>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Run<f64, D>, SimulationError> {
    let (mut simulation, mut log) = start::<D>(scenario, None);
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
fn explained<D: Simulated>(found: Difference, saved: &Run<f64, D>) -> Difference {
    if is_same_physics(saved.physics_version) {
        return found;
    }
    let versions = [saved.physics_version, PHYSICS_VERSION].map(|version| version.to_string());
    let [saved, now] = versions;
    Difference { place: "physics_version".to_owned(), saved, now }
}

fn first_difference<D: Simulated>(saved: &Run<f64, D>, now: &Run<f64, D>) -> Option<Difference> {
    difference_of_logs(saved, now)
        .or_else(|| difference_of_ends(saved, now))
        .or_else(|| difference_of_fields("diagnostics.", measures(saved), measures(now)))
}

/// The first difference in what was kept of the course: a row, or else the number of rows.
fn difference_of_logs<D: Simulated>(saved: &Run<f64, D>, now: &Run<f64, D>) -> Option<Difference> {
    let steps = |run| steps_of(run).map_or(&[][..], |steps| &steps.steps);
    difference_of_rows("events", &saved.log.events, &now.log.events, difference_of_events)
        .or_else(|| difference_of_rows("flights", &saved.log.flights, &now.log.flights, difference_in_row))
        .or_else(|| difference_of_rows("steps", steps(saved), steps(now), difference_in_row))
}

fn steps_of<D: Simulated>(run: &Run<f64, D>) -> Option<&Steps<f64>> {
    run.steps.as_ref().map(D::as_steps)
}

/// The first difference in how the runs ended, with the digest that was saved.
fn difference_of_ends<D: Simulated>(saved: &Run<f64, D>, now: &Run<f64, D>) -> Option<Difference> {
    let ends = |run: &Run<f64, D>| {
        let steps = steps_of(run).map(|steps| (steps.count, steps.lost_time));
        vec![
            ("status", run.status.name().to_owned()),
            ("end_time", format!("{:?}", run.end_time)),
            ("steps", format!("{steps:?}")),
            ("diagnostics.events", format!("{:?}", run.diagnostics.events)),
        ]
    };
    let digests = [saved, now].map(|run| run.digest().unwrap_or_else(Digest::none));
    let stored = saved.saved_digest.as_ref().unwrap_or(&digests[0]);
    difference_of_fields("", ends(saved), ends(now))
        .or_else(|| difference_of_rows("balls", &saved.balls, &now.balls, difference_in_row))
        .or_else(|| difference_of_fields("digest.", parts(&digests[0]), parts(&digests[1])))
        .or_else(|| difference_of_fields("digest.", parts(stored), parts(&digests[1])))
}

fn parts(digest: &Digest) -> Vec<(&'static str, String)> {
    let Digest { events, end_time, state } = digest.clone();
    vec![("events", events.to_string()), ("end_time", end_time), ("state", state)]
}

/// What a run measured of itself, but for what depends on how it was taken: in pieces it predicts more often, and sums its
/// energy at the end of each.
fn measures<D: Simulated>(run: &Run<f64, D>) -> Vec<(&'static str, String)> {
    let Diagnostics {
        events,
        predictions: _,
        stale: _,
        deepest_overlap,
        clusters,
        cluster_passes,
        forced_clusters,
        initial_energy,
        final_energy,
        energy_loss,
        energy_error,
        energy_gain,
        momentum_error,
        energy_drift: _,
        lost_time,
        corrections,
    } = &run.diagnostics;
    vec![
        ("events", format!("{events:?}")),
        ("deepest_overlap", format!("{deepest_overlap:?}")),
        ("clusters", clusters.to_string()),
        ("cluster_passes", cluster_passes.to_string()),
        ("forced_clusters", forced_clusters.to_string()),
        ("initial_energy", format!("{initial_energy:?}")),
        ("final_energy", format!("{final_energy:?}")),
        ("energy_loss", format!("{energy_loss:?}")),
        ("energy_error", format!("{energy_error:?}")),
        ("energy_gain", format!("{energy_gain:?}")),
        ("momentum_error", format!("{momentum_error:?}")),
        ("lost_time", format!("{lost_time:?}")),
        ("corrections", corrections.to_string()),
    ]
}

fn difference_of_fields(
    prefix: &str,
    saved: Vec<(&'static str, String)>,
    now: Vec<(&'static str, String)>,
) -> Option<Difference> {
    let ((field, saved), (_, now)) = saved.into_iter().zip(now).find(|((_, a), (_, b))| a != b)?;
    Some(Difference { place: format!("{prefix}{field}"), saved, now })
}

fn difference_of_rows<T: PartialEq>(
    place: &str,
    saved: &[T],
    now: &[T],
    describe: impl Fn(String, &T, &T) -> Difference,
) -> Option<Difference> {
    if let Some(k) = saved.iter().zip(now).position(|(a, b)| a != b) {
        return Some(describe(format!("{place}[{k}]"), &saved[k], &now[k]));
    }
    let [saved, now] = [saved, now].map(|rows| format!("{} rows", rows.len()));
    (saved != now).then(|| Difference { place: place.to_owned(), saved, now })
}

fn difference_in_row(place: String, saved: &impl Debug, now: &impl Debug) -> Difference {
    Difference { place, saved: format!("{saved:?}"), now: format!("{now:?}") }
}

fn difference_of_events(place: String, saved: &Event<f64>, now: &Event<f64>) -> Difference {
    let words = |event: &Event<f64>| {
        let numbers = |x: f64, y: f64| format!("[{x:?}, {y:?}]");
        vec![
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
    let whole = difference_in_row(place.clone(), saved, now);
    difference_of_fields(&format!("{place}."), words(saved), words(now)).unwrap_or(whole)
}
