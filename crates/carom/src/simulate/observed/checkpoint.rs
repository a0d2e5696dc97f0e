//! An observed run written down on its way, to go on from there with the same bits.
//!
//! A checkpoint is a header of fixed length and a body in postcard's format. The header, its numbers little-endian, stays
//! as it is in all formats, so that any version can tell what is wrong with a file:
//!
//! | bytes | what |
//! |---|---|
//! | 0 to 8 | the letters `CAROMRUN` |
//! | 8 to 12 | the format of the body |
//! | 12 to 16 | the version of the physics |
//! | 16 to 40 | the version of Carom that wrote it, filled up with zeros |
//! | 40 to 48 | the length of the body |
//! | 48 to 80 | SHA-256 of the bytes before, and of the body |

use super::plan::Plan;
use super::stream::Stream;
use super::{Camera, ObservedRun, Phase, SLICE};
use crate::engine::Simulation;
use crate::flight::Flight;
use crate::observe::Observables;
use crate::run::{Diagnostics, Event, Kind, PHYSICS_VERSION, Plane, Run, Status, Track, VERSION};
use crate::scenario::{Problem, Scenario, ScenarioError, System};
use crate::simulate::{limits_of, log_of, prolonged};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use sha2::{Digest as _, Sha256};
use std::borrow::Cow;
use std::sync::Arc;
use thiserror::Error;

/// The format of the body: raised by any change of what is written, in the observables too.
const FORMAT: u32 = 1;

const MARK: &[u8; 8] = b"CAROMRUN";
const HEADER: usize = 80;
const SUM: usize = 48;

/// Why a run cannot go on from some bytes.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// It begins otherwise.
    #[error("not a checkpoint of Carom")]
    Foreign,
    /// It ends too early.
    #[error("the checkpoint is cut short: it has {found} of {expected} bytes")]
    CutShort {
        /// Its bytes.
        found: usize,
        /// The bytes that it says it has.
        expected: u64,
    },
    /// It goes on behind its end.
    #[error("the checkpoint is damaged: it has {found} bytes, {expected} of which are its own")]
    TooLong {
        /// Its bytes.
        found: usize,
        /// The bytes that it says it has.
        expected: u64,
    },
    /// A byte is another than was written.
    #[error("the checkpoint is damaged: its checksum is not that of what it holds")]
    Damaged,
    /// Another version of Carom wrote it in another way.
    #[error(
        "the checkpoint is in format {format}, written by carom {version}; this is carom {VERSION}, which reads format \
         {FORMAT}: go on with carom {version}"
    )]
    OtherFormat {
        /// Its format.
        format: u32,
        /// Who wrote it.
        version: String,
    },
    /// It was made with other physics, with which alone the bits would be those of one run.
    #[error(
        "the run was made with physics version {physics} of carom {version}, and this is version {PHYSICS_VERSION}: go on \
         with carom {version}, or run its scenario anew"
    )]
    OtherPhysics {
        /// Its version of the physics.
        physics: u32,
        /// Who wrote it.
        version: String,
    },
    /// The bytes are whole, and make no run.
    #[error("the checkpoint cannot be read: {0}")]
    Malformed(String),
    /// The scenario does not hold together, with new limits for instance.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
}

/// A run on its way, with a note of the caller's.
pub struct Checkpoint(Body<'static>);

#[derive(Serialize, Deserialize)]
struct Body<'a> {
    note: Cow<'a, str>,
    /// As JSON text, which is checked anew.
    scenario: String,
    until: Option<Kind>,
    status: Option<Status>,
    time: f64,
    /// As JSON text, which may know fewer kinds of events.
    diagnostics: String,
    balls: Vec<(Flight<f64>, Track<f64>)>,
    events: Cow<'a, [Event<f64>]>,
    flights: Cow<'a, [(u32, Flight<f64>)]>,
    observables: Cow<'a, Observables>,
    plan: Cow<'a, Plan>,
    phase: Phase,
    stream: Cow<'a, Stream>,
    snapshots: u64,
}

impl Checkpoint {
    /// Reads what [`ObservedRun::checkpoint`] wrote.
    ///
    /// # Errors
    ///
    /// What is no checkpoint, one that is damaged, and one of another version.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, CheckpointError> {
        postcard::from_bytes(body_of(bytes)?).map(Self).map_err(malformed)
    }

    /// The caller's note.
    pub fn note(&self) -> &str {
        &self.0.note
    }

    /// How the run had ended; `None` where it was under way.
    pub fn status(&self) -> Option<Status> {
        self.0.status
    }

    /// The time that the run had come to.
    pub fn time(&self) -> f64 {
        self.0.time
    }

    /// How many snapshots and how many events had been handed out.
    pub fn handed_out(&self) -> (u64, u64) {
        (self.0.snapshots, self.0.stream.handed_out())
    }
}

impl ObservedRun {
    /// The run as it is now, as bytes; with a note for who will read it.
    ///
    /// # Errors
    ///
    /// A number that has no JSON text.
    pub fn checkpoint(&self, note: &str) -> Result<Vec<u8>, CheckpointError> {
        let mut balls = Vec::with_capacity(self.camera.count());
        self.simulation.each_ball(|flight, track| balls.push((flight, track)));
        let diagnostics = serde_json::to_string(self.simulation.diagnostics());
        let body = Body {
            note: Cow::Borrowed(note),
            scenario: self.scenario.to_json()?,
            until: self.until,
            status: self.simulation.status(),
            time: self.simulation.time(),
            diagnostics: diagnostics.map_err(|error| CheckpointError::Malformed(error.to_string()))?,
            balls,
            events: Cow::Borrowed(&self.log.events),
            flights: Cow::Borrowed(&self.log.flights),
            observables: Cow::Borrowed(&self.observables),
            plan: Cow::Borrowed(&self.plan),
            phase: self.phase,
            stream: Cow::Borrowed(&self.stream),
            snapshots: self.snapshots,
        };
        let bytes = postcard::to_extend(&body, vec![0; HEADER]).map_err(malformed)?;
        Ok(sealed(bytes))
    }

    /// Goes on from a checkpoint, to the ends that its scenario has, or to those that these values give in their place:
    /// counted from the start of the run. A run that had ended has ended still, if no values are given.
    ///
    /// # Errors
    ///
    /// Values that do not fit the scenario, and an end before the time that the run has come to.
    pub fn resume(checkpoint: Checkpoint, values: &[(String, Value)]) -> Result<Self, CheckpointError> {
        let body = checkpoint.0;
        let mut scenario = Scenario::from_json(&body.scenario)?;
        if !values.is_empty() {
            scenario = prolonged(&scenario, values)?;
        }
        let time = body.time;
        if scenario.duration.is_some_and(|end| end < time) {
            let message = format!("the run has come to {time:?} already");
            return Err(ScenarioError::from(Problem { place: "duration".to_owned(), message }).into());
        }
        let end = body.status.filter(|status| values.is_empty() && *status != Status::Interrupted);
        let run = body.run(&scenario)?;
        let mut simulation = Simulation::resume(&run, limits_of(&scenario, body.until));
        end.into_iter().for_each(|status| simulation.stop(status));
        let next_pause = run.diagnostics.total_events() + SLICE;
        Ok(Self {
            scenario,
            until: body.until,
            camera: Camera::new(simulation.system()),
            simulation,
            log: run.log,
            observables: body.observables.into_owned(),
            plan: body.plan.into_owned(),
            phase: body.phase,
            stream: body.stream.into_owned(),
            snapshots: body.snapshots,
            pause: None,
            reached: f64::NEG_INFINITY,
            next_pause,
        })
    }
}

impl Body<'_> {
    /// The run so far.
    fn run(&self, scenario: &Scenario) -> Result<Run<f64>, CheckpointError> {
        let diagnostics: Diagnostics = serde_json::from_str(&self.diagnostics)
            .map_err(|error| CheckpointError::Malformed(error.to_string()))?;
        let system = Arc::new(System::new(scenario));
        if self.balls.len() != system.discs.len() {
            return Err(CheckpointError::Malformed("not as many balls as the scenario has".to_owned()));
        }
        let mut log = log_of::<Plane>(scenario);
        log.events = self.events.to_vec();
        log.flights = self.flights.to_vec();
        let status = self.status.unwrap_or(Status::Interrupted);
        Ok(Run::new(system, (status, self.time), diagnostics, log, self.balls.clone()))
    }
}

/// Fills in the header of a body that stands behind room for it.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let length = (bytes.len() - HEADER) as u64;
    let mut version = [0; 24];
    version.iter_mut().zip(VERSION.bytes()).for_each(|(place, byte)| *place = byte);
    let head =
        [&MARK[..], &FORMAT.to_le_bytes(), &PHYSICS_VERSION.to_le_bytes(), &version, &length.to_le_bytes()]
            .concat();
    bytes[..SUM].copy_from_slice(&head);
    let sum = sum_of(&bytes);
    bytes[SUM..HEADER].copy_from_slice(&sum);
    bytes
}

/// The body of a checkpoint that is whole and of this version.
fn body_of(bytes: &[u8]) -> Result<&[u8], CheckpointError> {
    if bytes.len() < MARK.len() || !bytes.starts_with(MARK) {
        return Err(CheckpointError::Foreign);
    }
    let found = bytes.len();
    if found < HEADER {
        return Err(CheckpointError::CutShort { found, expected: HEADER as u64 });
    }
    let number =
        |from: usize| bytes[from..from + 4].iter().rev().fold(0, |all, byte| all << 8 | u32::from(*byte));
    let length = u64::from(number(40)) | u64::from(number(44)) << 32;
    let expected = length.saturating_add(HEADER as u64);
    if (found as u64) < expected {
        return Err(CheckpointError::CutShort { found, expected });
    }
    if found as u64 > expected {
        return Err(CheckpointError::TooLong { found, expected });
    }
    if sum_of(bytes) != bytes[SUM..HEADER] {
        return Err(CheckpointError::Damaged);
    }
    let (format, physics) = (number(8), number(12));
    let version = String::from_utf8_lossy(&bytes[16..40]).trim_end_matches('\0').to_owned();
    if format != FORMAT {
        return Err(CheckpointError::OtherFormat { format, version });
    }
    if physics != PHYSICS_VERSION {
        return Err(CheckpointError::OtherPhysics { physics, version });
    }
    Ok(&bytes[HEADER..])
}

/// The checksum of all but the checksum.
fn sum_of(bytes: &[u8]) -> [u8; 32] {
    Sha256::new().chain_update(&bytes[..SUM]).chain_update(&bytes[HEADER..]).finalize().into()
}

fn malformed(error: postcard::Error) -> CheckpointError {
    CheckpointError::Malformed(error.to_string())
}
