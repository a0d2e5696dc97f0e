//! What came out of a computation: status, events, flights, diagnostics; so, the state at any time.

mod diagnostics;
mod digest;
mod dynamics;
mod event;
mod file;
mod film;
mod observer;
mod references;
mod state;
mod status;
mod steps;

pub use diagnostics::Diagnostics;
pub use digest::{Digest, digest};
pub use dynamics::{Dynamics, NoSteps, OnCloth, Plane, SphereTrack};
pub use event::{Event, Kind};
pub use file::{RunFileError, Saved, VERSION, from_json, to_json};
pub use film::Film;
pub use observer::{Log, Nothing, Observer};
pub use state::{QueryError, Run, Track};
pub use status::{SimulationError, Status};
pub use steps::{Hit, Step, Steps};

/// Raised by any change that moves a trajectory; stored with every saved run and every golden digest.
pub const PHYSICS_VERSION: u32 = 2;
