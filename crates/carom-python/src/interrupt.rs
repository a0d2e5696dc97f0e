//! Long computations without the interpreter's lock, which Ctrl-C still ends.

use pyo3::prelude::*;

/// Runs `compute` without the lock; it is handed a function that says whether a signal wants it to break off.
///
/// The exception that the signal raised, `KeyboardInterrupt` as a rule, goes before the outcome.
pub fn interruptible<T: Send>(
    py: Python<'_>,
    compute: impl FnOnce(&mut dyn FnMut() -> bool) -> T + Send,
) -> PyResult<T> {
    let mut raised = None;
    let outcome = py.detach(|| {
        compute(&mut || {
            let signals = Python::attach(|py| py.check_signals());
            signals.map_or_else(
                |error| {
                    raised = Some(error);
                    true
                },
                |()| false,
            )
        })
    });
    raised.map_or(Ok(outcome), Err)
}
