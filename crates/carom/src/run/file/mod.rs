//! A run as a JSON text: columns of events and flights, with every number exact.

mod check;
mod columns;
mod saved;
mod saved_on_cloth;

use super::{Diagnostics, Digest, Log, Run, Status};
use crate::scenario::{Scenario, ScenarioError};
use columns::{EventColumns, FlightColumns, StepColumns, event_columns, flight_columns, step_columns};
pub use saved::Saved;
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
    /// A number of the run is infinite or none, so that its text could not be read again.
    #[error("the run cannot be saved: {0} is not a finite number")]
    NotFinite(String),
}

#[derive(Serialize, Deserialize)]
#[serde(bound = "")]
struct RunFile<D: Saved> {
    format: u32,
    carom: String,
    physics_version: u32,
    scenario: serde_json::Value,
    status: Status,
    end_time: f64,
    digest: Digest,
    diagnostics: Diagnostics,
    events: Option<EventColumns>,
    flights: Option<FlightColumns<D::Numbers>>,
    balls: Vec<D::Entry>,
    steps: Option<StepColumns>,
}

/// The text of a run of a scenario.
pub fn to_json<D: Saved>(scenario: &Scenario, run: &Run<f64, D>) -> Result<String, RunFileError> {
    let malformed = |error: serde_json::Error| RunFileError::Malformed(error.to_string());
    let file = RunFile::<D> {
        format: FORMAT,
        carom: VERSION.to_owned(),
        physics_version: run.physics_version,
        scenario: serde_json::to_value(scenario).map_err(malformed)?,
        status: run.status,
        end_time: run.end_time,
        digest: run.digest().unwrap_or_else(Digest::none),
        diagnostics: run.diagnostics.clone(),
        events: run.log.keeps_events.then(|| event_columns(&run.log.events)),
        flights: (run.log.keeps_flights && run.steps.is_none())
            .then(|| flight_columns::<D>(&run.log.flights)),
        balls: run.balls.iter().map(D::entry_of).collect(),
        steps: run.steps.as_ref().map(D::as_steps).map(step_columns),
    };
    check::check_finite(&file).map_err(RunFileError::NotFinite)?;
    serde_json::to_string(&file).map_err(malformed)
}

/// The run that a text holds, with its scenario.
pub fn from_json<D: Saved>(text: &str) -> Result<(Scenario, Run<f64, D>), RunFileError> {
    let file: RunFile<D> = serde_json::from_str(text).map_err(|error| fault::<D>(text, &error))?;
    if file.format > FORMAT {
        return Err(RunFileError::Newer(file.format.into()));
    }
    let scenario = Scenario::from_json(&file.scenario.to_string())?;
    let system = Arc::new(D::system(&scenario));
    check::check(&file, &system).map_err(RunFileError::Malformed)?;
    let log = Log {
        keeps_events: file.events.is_some(),
        keeps_flights: file.flights.is_some() || file.steps.as_ref().is_some_and(StepColumns::is_whole),
        events: file.events.unwrap_or_default().rows(),
        flights: file.flights.map(FlightColumns::rows::<D>).unwrap_or_default(),
    };
    let balls = file.balls.iter().map(D::ball_of).collect();
    let mut run = Run::new(system, (file.status, file.end_time), file.diagnostics, log, balls);
    run.steps = file.steps.map(StepColumns::steps).and_then(D::steps_of);
    (run.physics_version, run.saved_digest) = (file.physics_version, Some(file.digest));
    Ok((scenario, run))
}

/// Why a text cannot be read. A second look at it tells the format and the place, which would slow down the first.
fn fault<D: Saved>(text: &str, error: &serde_json::Error) -> RunFileError {
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
    match serde_path_to_error::deserialize::<_, RunFile<D>>(&mut source) {
        Err(error) => RunFileError::Malformed(error.to_string()),
        Ok(_) => RunFileError::Malformed(error.to_string()),
    }
}
