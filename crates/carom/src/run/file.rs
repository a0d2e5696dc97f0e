//! A run as a JSON text: columns of events and flights, with every number exact.

use super::{Diagnostics, Digest, Event, Hit, Kind, Log, Run, Status, Step, Steps, Track};
use crate::flight::{Flight, State};
use crate::geometry::Vec2;
use crate::scenario::{Scenario, ScenarioError, System};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use thiserror::Error;

/// Version of the engine.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

const FORMAT: u32 = 1;

/// Why a text is not a saved run.
#[derive(Debug, Error)]
pub enum RunFileError {
    /// Not JSON, or not of this form.
    #[error("not a saved run: {0}")]
    Malformed(String),
    /// Written by a newer version.
    #[error("the run was saved in format {0}, newer than the newest one this version reads, {FORMAT}")]
    Newer(u64),
    /// The scenario in it does not pass the check.
    #[error("the scenario of the saved run: {0}")]
    Scenario(#[from] ScenarioError),
}

#[derive(Serialize, Deserialize)]
struct RunFile {
    format: u32,
    carom: String,
    physics_version: u32,
    scenario: serde_json::Value,
    status: Status,
    end_time: f64,
    digest: Option<Digest>,
    diagnostics: Diagnostics,
    events: Option<EventColumns>,
    flights: Option<FlightColumns>,
    balls: Vec<BallEntry>,
    steps: Option<StepColumns>,
}

#[derive(Default, Serialize, Deserialize)]
struct EventColumns {
    time: Vec<f64>,
    kind: Vec<Kind>,
    ball_a: Vec<u32>,
    ball_b: Vec<Option<u32>>,
    cushion: Vec<Option<u32>>,
    x: Vec<f64>,
    y: Vec<f64>,
    normal_x: Vec<f64>,
    normal_y: Vec<f64>,
    closing_speed: Vec<f64>,
    impulse: Vec<f64>,
    cluster: Vec<Option<u32>>,
}

#[derive(Default, Serialize, Deserialize)]
struct FlightColumns {
    ball: Vec<u32>,
    start: Vec<f64>,
    state: Vec<[f64; 6]>,
}

#[derive(Serialize, Deserialize)]
struct BallEntry {
    start: f64,
    /// Position, velocity, acceleration.
    state: [f64; 6],
    changes: u64,
    held_by: [Option<u32>; 2],
    last_cushion: Option<u32>,
    arrival: [f64; 2],
    last_contact: Option<f64>,
    burst_start: Option<f64>,
    burst: u32,
}

#[derive(Default, Serialize, Deserialize)]
struct StepColumns {
    time: Vec<f64>,
    /// Position and velocity of each ball.
    state: Vec<Vec<[f64; 4]>>,
    hits: Vec<Vec<Option<(f64, Kind)>>>,
    count: u64,
    lost_time: f64,
}

/// The text of a run of a scenario.
pub fn to_json(scenario: &Scenario, run: &Run<f64>) -> Result<String, RunFileError> {
    let malformed = |error: serde_json::Error| RunFileError::Malformed(error.to_string());
    let file = RunFile {
        format: FORMAT,
        carom: VERSION.to_owned(),
        physics_version: run.physics_version,
        scenario: serde_json::to_value(scenario).map_err(malformed)?,
        status: run.status,
        end_time: run.end_time,
        digest: run.digest(),
        diagnostics: run.diagnostics.clone(),
        events: run.log.keeps_events.then(|| event_columns(&run.log.events)),
        flights: (run.log.keeps_flights && run.steps.is_none()).then(|| flight_columns(&run.log.flights)),
        balls: run.balls.iter().map(ball_entry).collect(),
        steps: run.steps.as_ref().map(step_columns),
    };
    serde_json::to_string(&file).map_err(malformed)
}

/// The run that a text holds, with its scenario.
pub fn from_json(text: &str) -> Result<(Scenario, Run<f64>), RunFileError> {
    let file: RunFile = serde_json::from_str(text).map_err(|error| fault(text, &error))?;
    if file.format > FORMAT {
        return Err(RunFileError::Newer(file.format.into()));
    }
    let scenario = Scenario::from_json(&file.scenario.to_string())?;
    let system = Arc::new(System::new(&scenario));
    check(&file, &system)?;
    let log = Log {
        keeps_events: file.events.is_some(),
        keeps_flights: file.flights.is_some() || file.steps.as_ref().is_some_and(StepColumns::is_whole),
        events: file.events.unwrap_or_default().rows(),
        flights: file.flights.unwrap_or_default().rows(),
    };
    let balls = file.balls.iter().map(BallEntry::ball).collect();
    let mut run = Run::new(system, (file.status, file.end_time), file.diagnostics, log, balls);
    run.steps = file.steps.map(StepColumns::steps);
    run.physics_version = file.physics_version;
    Ok((scenario, run))
}

/// Why a text cannot be read. A second look at it tells the format and the place, which would slow down the first.
fn fault(text: &str, error: &serde_json::Error) -> RunFileError {
    #[derive(Deserialize)]
    struct Header {
        format: u64,
    }
    if let Ok(Header { format }) = serde_json::from_str(text)
        && format > u64::from(FORMAT)
    {
        return RunFileError::Newer(format);
    }
    let mut source = serde_json::Deserializer::from_str(text);
    match serde_path_to_error::deserialize::<_, RunFile>(&mut source) {
        Err(error) => RunFileError::Malformed(error.to_string()),
        Ok(_) => RunFileError::Malformed(error.to_string()),
    }
}

/// Refuses columns of unequal length and indices that name nothing.
fn check(file: &RunFile, system: &System<f64>) -> Result<(), RunFileError> {
    let fault = |what: &str| Err(RunFileError::Malformed(what.to_owned()));
    let balls = system.discs.len();
    if file.balls.len() != balls {
        return fault("balls: not as many as the scenario has");
    }
    if let Some(events) = &file.events {
        let rows = events.time.len();
        let lengths = [
            events.kind.len(),
            events.ball_a.len(),
            events.ball_b.len(),
            events.cushion.len(),
            events.x.len(),
            events.y.len(),
            events.normal_x.len(),
            events.normal_y.len(),
            events.closing_speed.len(),
            events.impulse.len(),
            events.cluster.len(),
        ];
        let is_ball = |ball: &u32| (*ball as usize) < balls;
        let is_cushion = |cushion: &u32| (*cushion as usize) < system.faces.all.len();
        if lengths.iter().any(|length| *length != rows) {
            return fault("events: the columns have unequal lengths");
        }
        if !events.ball_a.iter().chain(events.ball_b.iter().flatten()).all(is_ball)
            || !events.cushion.iter().flatten().all(is_cushion)
        {
            return fault("events: a ball or cushion that the scenario does not have");
        }
    }
    if let Some(flights) = &file.flights {
        let rows = flights.ball.len();
        if flights.start.len() != rows || flights.state.len() != rows {
            return fault("flights: the columns have unequal lengths");
        }
        let mut seen = vec![false; balls];
        for ball in &flights.ball {
            match seen.get_mut(*ball as usize) {
                Some(seen) => *seen = true,
                None => return fault("flights: a ball that the scenario does not have"),
            }
        }
        if !seen.into_iter().all(|seen| seen) {
            return fault("flights: a ball without any");
        }
    }
    if let Some(steps) = &file.steps {
        let rows = steps.time.len();
        let is_full = |length: usize| length == balls;
        if rows != 1 && !steps.is_whole() {
            return fault("steps: neither as many as were made nor the last only");
        }
        if rows == 0
            || steps.state.len() != rows
            || steps.hits.len() != rows
            || !steps.state.iter().all(|row| is_full(row.len()))
            || !steps.hits.iter().all(|row| is_full(row.len()))
        {
            return fault("steps: the columns have unequal lengths");
        }
    }
    Ok(())
}

fn event_columns(events: &[Event<f64>]) -> EventColumns {
    let mut columns = EventColumns::default();
    for event in events {
        columns.time.push(event.time);
        columns.kind.push(event.kind);
        columns.ball_a.push(event.ball_a);
        columns.ball_b.push(event.ball_b);
        columns.cushion.push(event.cushion);
        columns.x.push(event.point.x);
        columns.y.push(event.point.y);
        columns.normal_x.push(event.normal.x);
        columns.normal_y.push(event.normal.y);
        columns.closing_speed.push(event.closing_speed);
        columns.impulse.push(event.impulse);
        columns.cluster.push(event.cluster);
    }
    columns
}

impl EventColumns {
    fn rows(self) -> Vec<Event<f64>> {
        let row = |k: usize| Event {
            time: self.time[k],
            kind: self.kind[k],
            ball_a: self.ball_a[k],
            ball_b: self.ball_b[k],
            cushion: self.cushion[k],
            point: Vec2::new(self.x[k], self.y[k]),
            normal: Vec2::new(self.normal_x[k], self.normal_y[k]),
            closing_speed: self.closing_speed[k],
            impulse: self.impulse[k],
            cluster: self.cluster[k],
        };
        (0..self.time.len()).map(row).collect()
    }
}

fn flight_columns(flights: &[(u32, Flight<f64>)]) -> FlightColumns {
    FlightColumns {
        ball: flights.iter().map(|(ball, _)| *ball).collect(),
        start: flights.iter().map(|(_, flight)| flight.start).collect(),
        state: flights.iter().map(|(_, flight)| numbers(flight)).collect(),
    }
}

impl FlightColumns {
    fn rows(self) -> Vec<(u32, Flight<f64>)> {
        let states = self.start.into_iter().zip(self.state);
        self.ball.into_iter().zip(states).map(|(ball, (start, state))| (ball, flight(start, state))).collect()
    }
}

fn numbers(flight: &Flight<f64>) -> [f64; 6] {
    let Flight { position, velocity, acceleration, .. } = flight;
    [position.x, position.y, velocity.x, velocity.y, acceleration.x, acceleration.y]
}

fn flight(start: f64, [x, y, vx, vy, ax, ay]: [f64; 6]) -> Flight<f64> {
    Flight { start, position: Vec2::new(x, y), velocity: Vec2::new(vx, vy), acceleration: Vec2::new(ax, ay) }
}

fn ball_entry((flight, track): &(Flight<f64>, Track<f64>)) -> BallEntry {
    let finite = |time: f64| time.is_finite().then_some(time);
    BallEntry {
        start: flight.start,
        state: numbers(flight),
        changes: track.changes,
        held_by: track.held_by,
        last_cushion: track.last_cushion,
        arrival: [track.arrival.x, track.arrival.y],
        last_contact: finite(track.last_contact),
        burst_start: finite(track.burst_start),
        burst: track.burst,
    }
}

impl BallEntry {
    fn ball(&self) -> (Flight<f64>, Track<f64>) {
        let track = Track {
            changes: self.changes,
            held_by: self.held_by,
            last_cushion: self.last_cushion,
            arrival: Vec2::new(self.arrival[0], self.arrival[1]),
            last_contact: self.last_contact.unwrap_or(f64::NEG_INFINITY),
            burst_start: self.burst_start.unwrap_or(f64::NEG_INFINITY),
            burst: self.burst,
        };
        (flight(self.start, self.state), track)
    }
}

fn step_columns(steps: &Steps<f64>) -> StepColumns {
    let state = |State { position, velocity }: &State<f64>| [position.x, position.y, velocity.x, velocity.y];
    let hit = |hit: &Option<Hit<f64>>| hit.map(|hit| (hit.after, hit.kind));
    StepColumns {
        time: steps.steps.iter().map(|step| step.time).collect(),
        state: steps.steps.iter().map(|step| step.balls.iter().map(state).collect()).collect(),
        hits: steps.steps.iter().map(|step| step.hits.iter().map(hit).collect()).collect(),
        count: steps.count,
        lost_time: steps.lost_time,
    }
}

impl StepColumns {
    /// Whether all steps were kept, and not the end only.
    fn is_whole(&self) -> bool {
        self.time.len() as u64 == self.count.saturating_add(1)
    }

    fn steps(self) -> Steps<f64> {
        let ball =
            |[x, y, vx, vy]: [f64; 4]| State { position: Vec2::new(x, y), velocity: Vec2::new(vx, vy) };
        let hit = |hit: &Option<(f64, Kind)>| hit.map(|(after, kind)| Hit { after, kind });
        let step = |k: usize| Step {
            time: self.time[k],
            balls: self.state[k].iter().copied().map(ball).collect(),
            hits: self.hits[k].iter().map(hit).collect(),
        };
        Steps {
            steps: (0..self.time.len()).map(step).collect(),
            count: self.count,
            lost_time: self.lost_time,
        }
    }
}
