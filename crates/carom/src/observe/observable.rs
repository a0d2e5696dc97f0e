//! The closed set of observables.

use super::collision_rate::CollisionRate;
use super::diffusion::Diffusion;
use super::error::ObserveError;
use super::events::EventSums;
use super::free_path::FreePath;
use super::h_function::HFunction;
use super::kinetic_energy::KineticEnergy;
use super::pressure::Pressure;
use super::psi6::Psi6;
use super::radial_distribution::RadialDistribution;
use super::request::{NoOptions, Options, Request, hint};
use super::results::Results;
use super::snapshot::{Gas, Moment, Snapshot};
use super::speeds::Speeds;
use super::temperature_profile::TemperatureProfile;
use serde::{Deserialize, Serialize};

/// How something is measured.
pub(super) trait Measure {
    /// The first snapshot is there, before its sample: refuses a gas of which this cannot be observed.
    fn begin(&mut self, _snapshot: &Snapshot, _gas: &Gas) -> Result<(), ObserveError> {
        Ok(())
    }

    /// Takes in a sample.
    fn sample(&mut self, moment: &Moment);

    /// What was found so far.
    fn results(&self, gas: &Gas, events: &EventSums) -> Results;
}

/// What can be observed, with the sums that it has made so far.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Observable {
    Pressure(Pressure),
    CollisionRate(CollisionRate),
    FreePath(FreePath),
    Speeds(Speeds),
    HFunction(HFunction),
    TemperatureProfile(TemperatureProfile),
    RadialDistribution(RadialDistribution),
    Diffusion(Diffusion),
    Psi6(Psi6),
    KineticEnergy(KineticEnergy),
}

/// The names of all observables.
pub const NAMES: [&str; 10] = [
    "pressure",
    "collision_rate",
    "free_path",
    "speeds",
    "h_function",
    "temperature_profile",
    "radial_distribution",
    "diffusion",
    "psi6",
    "kinetic_energy",
];

impl Observable {
    /// The observable that is asked for.
    pub fn new(request: &Request) -> Result<Self, ObserveError> {
        let Request { name: asked, options } = request;
        let name = NAMES.into_iter().find(|known| known == asked).unwrap_or_default();
        let has_none = || Options::read(name, options).map(|NoOptions {}| ());
        Ok(match name {
            "pressure" => has_none().map(|()| Self::Pressure(Pressure::default()))?,
            "collision_rate" => has_none().map(|()| Self::CollisionRate(CollisionRate::default()))?,
            "free_path" => has_none().map(|()| Self::FreePath(FreePath::default()))?,
            "speeds" => Self::Speeds(Speeds::new(Options::read(name, options)?)),
            "h_function" => Self::HFunction(HFunction::new(Options::read(name, options)?)),
            "temperature_profile" => {
                Self::TemperatureProfile(TemperatureProfile::new(Options::read(name, options)?))
            }
            "radial_distribution" => {
                Self::RadialDistribution(RadialDistribution::new(Options::read(name, options)?))
            }
            "diffusion" => Self::Diffusion(Diffusion::new(Options::read(name, options)?)),
            "psi6" => has_none().map(|()| Self::Psi6(Psi6::default()))?,
            "kinetic_energy" => Self::KineticEnergy(KineticEnergy::new(Options::read(name, options)?)),
            _ => return Err(ObserveError::UnknownName { name: asked.clone(), hint: hint(asked, &NAMES) }),
        })
    }

    /// Whether it lives on events, and not on samples alone.
    pub fn needs_events(&self) -> bool {
        matches!(self, Self::Pressure(_) | Self::CollisionRate(_) | Self::FreePath(_))
    }

    /// How it is measured.
    pub fn measure(&self) -> &dyn Measure {
        match self {
            Self::Pressure(this) => this,
            Self::CollisionRate(this) => this,
            Self::FreePath(this) => this,
            Self::Speeds(this) => this,
            Self::HFunction(this) => this,
            Self::TemperatureProfile(this) => this,
            Self::RadialDistribution(this) => this,
            Self::Diffusion(this) => this,
            Self::Psi6(this) => this,
            Self::KineticEnergy(this) => this,
        }
    }

    /// How it is measured, to measure it.
    pub fn measure_mut(&mut self) -> &mut dyn Measure {
        match self {
            Self::Pressure(this) => this,
            Self::CollisionRate(this) => this,
            Self::FreePath(this) => this,
            Self::Speeds(this) => this,
            Self::HFunction(this) => this,
            Self::TemperatureProfile(this) => this,
            Self::RadialDistribution(this) => this,
            Self::Diffusion(this) => this,
            Self::Psi6(this) => this,
            Self::KineticEnergy(this) => this,
        }
    }
}
