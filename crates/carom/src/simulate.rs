//! From a scenario to a run, by the method that the scenario names.

mod any;
mod final_scenario;
mod observed;
mod verify;

use crate::engine::{Discs, Engine, Limits, Simulation, Spheres};
use crate::run::{
    Dynamics, Kind, Log, Nothing, Observer, OnCloth, PHYSICS_VERSION, Plane, Run, SimulationError, Status,
};
use crate::scenario::schema::{Method, Record};
use crate::scenario::{Scenario, ScenarioError, System};
use crate::stepped::{self, Ends, Readings};
pub use any::{Any, AnyRun, AnySimulation};
pub use final_scenario::final_scenario;
pub use observed::{
    COLLISIONS_PER_SAMPLE, Checkpoint, CheckpointError, ObservedError, ObservedRun, Pause, Plan, Progress,
    Sampling, Snapshots, Window, simulate_observed,
};
use serde_json::Value;
use std::sync::Arc;
pub use verify::{Difference, verify};

/// The event budget of a scenario that names neither one nor a number of collisions.
pub const DEFAULT_MAX_EVENTS: u64 = 10_000_000;

/// Steps between two looks at whether a run should be broken off.
pub(crate) const SLICE: u64 = 50_000;

/// A dynamics that a scenario can be run with.
pub trait Simulated: Dynamics<f64> {
    /// What computes it.
    type Engine: Engine<f64, Dynamics = Self>;

    /// The run by the fixed-step method, if the scenario names it.
    fn stepped(
        scenario: &Scenario,
        until: Option<Kind>,
        interrupted: &mut dyn FnMut() -> bool,
    ) -> Option<Run<f64, Self>>;
}

impl Simulated for Plane {
    type Engine = Discs<f64>;

    fn stepped(
        scenario: &Scenario,
        until: Option<Kind>,
        interrupted: &mut dyn FnMut() -> bool,
    ) -> Option<Run<f64>> {
        scheme_of(scenario).map(|scheme| scheme.simulate(scenario, until, interrupted))
    }
}

impl Simulated for OnCloth {
    type Engine = Spheres<f64>;

    /// There is no fixed-step method for balls on a cloth.
    fn stepped(_: &Scenario, _: Option<Kind>, _: &mut dyn FnMut() -> bool) -> Option<Run<f64, Self>> {
        None
    }
}

/// A run in progress of a dynamics.
pub type SimulationOf<D> = Simulation<f64, <D as Simulated>::Engine>;

/// Runs a checked scenario of discs to its end.
pub fn simulate(scenario: &Scenario) -> Result<Run<f64>, SimulationError> {
    simulate_until(scenario, None, &mut || false)
}

/// Runs a checked scenario to its end, to the first event of a kind, or until `interrupted` says so; it is asked now and
/// then.
pub fn simulate_until<D: Simulated>(
    scenario: &Scenario,
    until: Option<Kind>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Run<f64, D>, SimulationError> {
    if let Some(run) = D::stepped(scenario, until, interrupted) {
        return Ok(run);
    }
    let (simulation, log) = start(scenario, until);
    go_on::<D>(simulation, log, interrupted)
}

/// A run at time zero, and the log that goes with it.
pub fn start<D: Simulated>(scenario: &Scenario, until: Option<Kind>) -> (SimulationOf<D>, Log<f64, D>) {
    start_watched(scenario, until, &mut Nothing)
}

/// As [`start`]; what happens at time zero, such as the strike of a cue, the watcher is told too, whether the log keeps it
/// or not.
pub fn start_watched<D: Simulated>(
    scenario: &Scenario,
    until: Option<Kind>,
    watcher: &mut impl Observer<f64, D>,
) -> (SimulationOf<D>, Log<f64, D>) {
    let mut log = log_of(scenario);
    let (system, limits) = (Arc::new(D::system(scenario)), limits_of(scenario, until));
    let simulation = Simulation::new(system, limits, &mut (&mut log, watcher));
    (simulation, log)
}

/// The scenario of a longer run: without the ends of the one that was run, and with these values put in.
pub fn prolonged(scenario: &Scenario, values: &[(String, Value)]) -> Result<Scenario, ScenarioError> {
    let ends = ["duration", "collisions", "max_events"].map(|key| (key.to_owned(), Value::Null));
    scenario.with_values(&[&ends, values].concat())
}

/// Goes on from the end of a run of the same balls on the same table, up to the scenario's limits.
///
/// The result is the one longer run, with the bits it would have had at once; so the run must be of this version of the
/// physics, see [`is_same_physics`].
pub fn resume<D: Simulated>(
    scenario: &Scenario,
    run: &Run<f64, D>,
    until: Option<Kind>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Run<f64, D>, SimulationError> {
    // A short last step is not one of the longer run's, so steps are made anew.
    if let Some(run) = D::stepped(scenario, until, interrupted) {
        return Ok(run);
    }
    go_on(Simulation::resume(run, limits_of(scenario, until)), run.log.clone(), interrupted)
}

fn go_on<D: Simulated>(
    mut simulation: SimulationOf<D>,
    mut log: Log<f64, D>,
    interrupted: &mut dyn FnMut() -> bool,
) -> Result<Run<f64, D>, SimulationError> {
    while simulation.advance(SLICE, &mut log)? {
        if interrupted() {
            simulation.stop(Status::Interrupted);
        }
    }
    Ok(simulation.finish(log))
}

/// An empty log that keeps what the scenario wants kept.
pub fn log_of<D: Dynamics<f64>>(scenario: &Scenario) -> Log<f64, D> {
    let record = scenario.record();
    Log::new(record != Record::None, record == Record::All)
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

/// The fixed-step method of a scenario, with all that it asks for.
struct Scheme {
    readings: Readings<f64>,
    /// The number of steps, where that is given.
    steps: Option<u64>,
    /// Width and length of the rectangle.
    size: [f64; 2],
}

/// The fixed-step method, if the scenario names it.
fn scheme_of(scenario: &Scenario) -> Option<Scheme> {
    let Method::Stepped { dt, after_hit, normal, last_step, steps } = scenario.method else { return None };
    // A checked scenario of this method has a rectangle, which is its own bounding box.
    let size = scenario.expanded().table.layout(&mut |_, value| value).bounds.max;
    let readings = Readings { dt, after_hit, normal, last_step };
    Some(Scheme { readings, steps, size: [size.x, size.y] })
}

impl Scheme {
    fn simulate(
        &self,
        scenario: &Scenario,
        until: Option<Kind>,
        interrupted: &mut dyn FnMut() -> bool,
    ) -> Run<f64> {
        let mut ends = Ends {
            duration: scenario.duration.filter(|_| self.steps.is_none()).unwrap_or(f64::INFINITY),
            steps: self.steps.unwrap_or(u64::MAX),
            collisions: scenario.collisions.unwrap_or(u64::MAX),
            events: max_events(scenario),
            until,
            interrupted,
        };
        let system = Arc::new(System::new(scenario));
        stepped::run(system, self.size, &self.readings, &mut ends, log_of(scenario))
    }
}

/// Whether a run of that version of the physics was made by this one.
pub fn is_same_physics(version: u32) -> bool {
    version == PHYSICS_VERSION
}
