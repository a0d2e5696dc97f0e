//! A run of whichever dynamics its scenario has, for callers who learn that from the scenario.

use super::{SimulationOf, simulate_until, start_watched};
use crate::run::{Kind, Log, Observer, OnCloth, Plane, Run, RunFileError, SimulationError, from_json};
use crate::scenario::Scenario;

/// Something of discs or of balls on a cloth.
#[derive(Clone, Debug)]
pub enum Any<P, C> {
    /// Of discs in the plane.
    Plane(P),
    /// Of balls on a cloth.
    OnCloth(C),
}

/// A run.
pub type AnyRun = Any<Box<Run<f64, Plane>>, Box<Run<f64, OnCloth>>>;

/// A run in progress, with its log.
pub type AnySimulation = Any<Box<InProgress<Plane>>, Box<InProgress<OnCloth>>>;

type InProgress<D> = (SimulationOf<D>, Log<f64, D>);

/// Evaluates an expression with what is inside an [`Any`], whichever it is.
#[macro_export]
macro_rules! with_any {
    ($value:expr, $inner:ident => $body:expr) => {
        match $value {
            $crate::simulate::Any::Plane($inner) => $body,
            $crate::simulate::Any::OnCloth($inner) => $body,
        }
    };
}

impl AnyRun {
    /// Runs a checked scenario, as [`simulate_until`] does.
    pub fn simulate(
        scenario: &Scenario,
        until: Option<Kind>,
        interrupted: &mut dyn FnMut() -> bool,
    ) -> Result<Self, SimulationError> {
        Ok(if scenario.has_cloth() {
            Self::OnCloth(Box::new(simulate_until(scenario, until, interrupted)?))
        } else {
            Self::Plane(Box::new(simulate_until(scenario, until, interrupted)?))
        })
    }

    /// The run that a text holds, with its scenario.
    pub fn from_json(text: &str) -> Result<(Scenario, Self), RunFileError> {
        Ok(if is_on_cloth(text) {
            let (scenario, run) = from_json(text)?;
            (scenario, Self::OnCloth(Box::new(run)))
        } else {
            let (scenario, run) = from_json(text)?;
            (scenario, Self::Plane(Box::new(run)))
        })
    }
}

impl From<Run<f64, Plane>> for AnyRun {
    fn from(run: Run<f64, Plane>) -> Self {
        Self::Plane(Box::new(run))
    }
}

impl From<Run<f64, OnCloth>> for AnyRun {
    fn from(run: Run<f64, OnCloth>) -> Self {
        Self::OnCloth(Box::new(run))
    }
}

impl AnySimulation {
    /// A run at time zero; the watcher is told what happens there, see [`start_watched`].
    pub fn start<W>(scenario: &Scenario, until: Option<Kind>, watcher: &mut W) -> Self
    where
        W: Observer<f64, Plane> + Observer<f64, OnCloth>,
    {
        if scenario.has_cloth() {
            Self::OnCloth(Box::new(start_watched(scenario, until, watcher)))
        } else {
            Self::Plane(Box::new(start_watched(scenario, until, watcher)))
        }
    }
}

/// Whether a saved run is one of balls on a cloth. What cannot be told here is found out when the run is read.
fn is_on_cloth(text: &str) -> bool {
    #[derive(serde::Deserialize)]
    struct Header {
        scenario: Scenario,
    }
    serde_json::from_str::<Header>(text).is_ok_and(|header| header.scenario.has_cloth())
}
