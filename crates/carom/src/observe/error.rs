//! What can be wrong with a wish to observe, or with what is shown to be observed.

use thiserror::Error;

/// Why something cannot be observed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ObserveError {
    /// No observable has that name.
    #[error("there is no observable {name:?}{hint}")]
    UnknownName {
        /// The name asked for.
        name: String,
        /// The nearest name, and all of them.
        hint: String,
    },
    /// The observable has no such option.
    #[error("{observable} has no option {option:?}{hint}")]
    UnknownOption {
        /// The observable.
        observable: &'static str,
        /// The option asked for.
        option: String,
        /// The nearest option, and all of them.
        hint: String,
    },
    /// An option has a value that it cannot have.
    #[error("{observable}: {problem}")]
    BadOption {
        /// The observable.
        observable: &'static str,
        /// What is wrong.
        problem: String,
    },
    /// The gas is not one that this can be observed of.
    #[error("{observable} cannot be observed here: {problem}")]
    Unfit {
        /// The observable.
        observable: &'static str,
        /// What is wrong.
        problem: String,
    },
    /// The snapshot contradicts itself, or is of another gas than those before it.
    #[error("a snapshot at time {time} cannot be used: {problem}")]
    BadSnapshot {
        /// Its time.
        time: f64,
        /// What is wrong.
        problem: String,
    },
    /// Samples are to come at equal intervals, on which the error bars and the lags rest.
    #[error("a sample at time {time}: samples come at equal intervals, so the next is due at {due}")]
    UnequalInterval {
        /// Its time.
        time: f64,
        /// The time at which it was due.
        due: f64,
    },
}

/// A gas of which this cannot be observed.
pub(super) fn unfit(observable: &'static str, problem: impl Into<String>) -> ObserveError {
    ObserveError::Unfit { observable, problem: problem.into() }
}
