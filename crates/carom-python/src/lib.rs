//! The Python binding: conversions, and nothing else.

mod bundled;
mod errors;
mod scenario;

use pyo3::prelude::*;

/// The native module of the package.
#[pymodule]
mod _engine {
    #[pymodule_export]
    use crate::bundled::bundled_scenarios;
    #[pymodule_export]
    use crate::scenario::Scenario;
    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
