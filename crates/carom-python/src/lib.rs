//! The Python binding: conversions, and nothing else.

mod aim;
mod balls_from;
mod bundled;
mod columns;
mod ensemble;
mod errors;
mod interrupt;
mod observe;
mod run;
mod scenario;
mod simulation;
mod states;

use pyo3::prelude::*;

/// The native module of the package.
#[pymodule]
mod _engine {
    use carom::ensemble::Outcome;
    use carom::flight::Motion;
    use carom::run::Kind;
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::aim::{
        aim_at_ball, aim_at_point, aiming_point, ghost_ball, least_elevation_deg, obstructions, open_pot,
        open_pots,
    };
    #[pymodule_export]
    use crate::bundled::{bundled_scenarios, presets};
    #[pymodule_export]
    use crate::ensemble::Ensemble;
    #[pymodule_export]
    use crate::observe::ObservedRun;
    #[pymodule_export]
    use crate::run::Run;
    #[pymodule_export]
    use crate::scenario::{Scenario, schema, toml_as_json};
    #[pymodule_export]
    use crate::simulation::Simulation;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", carom::run::VERSION)?;
        module.add("PHYSICS_VERSION", carom::run::PHYSICS_VERSION)?;
        module.add("EVENT_KINDS", Kind::ALL.map(Kind::name))?;
        module.add("OBSERVABLES", carom::observe::NAMES)?;
        module.add("OUTCOMES", Outcome::ALL.map(|outcome| outcome.name()))?;
        module.add("MOTIONS", Motion::ALL.map(Motion::name))
    }
}
