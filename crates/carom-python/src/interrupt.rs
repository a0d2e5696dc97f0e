//! Long computations without the interpreter's lock, which Ctrl-C still ends.

use pyo3::prelude::*;

/// Runs `compute` without the lock; it is handed a function that says whether a signal wants it to break off.
///
/// The exception that the signal raised, `KeyboardInterrupt` as a rule, goes before the outcome.
pub fn interruptible<T: Send>(
    py: Python<'_>,
    compute: impl FnOnce(&mut dyn FnMut() -> bool) -> T + Send,
) -> PyResult<T> {
    let never = |_: Python<'_>, (): &()| Ok(false);
    watched(py, never, |interrupted: &mut dyn FnMut(&()) -> bool| compute(&mut || interrupted(&())))
}

/// The same with a caller who is told how far it has come, and may want it to break off too; `ask` has the lock.
pub fn watched<P, T: Send>(
    py: Python<'_>,
    mut ask: impl FnMut(Python<'_>, &P) -> PyResult<bool> + Send,
    compute: impl FnOnce(&mut dyn FnMut(&P) -> bool) -> T + Send,
) -> PyResult<T> {
    let mut raised = None;
    let outcome = py.detach(|| {
        compute(&mut |progress| {
            let answer = Python::attach(|py| {
                py.check_signals()?;
                ask(py, progress)
            });
            answer.unwrap_or_else(|error| {
                raised = Some(error);
                true
            })
        })
    });
    raised.map_or(Ok(outcome), Err)
}
