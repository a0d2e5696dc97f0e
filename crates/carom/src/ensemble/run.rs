//! An ensemble, and the table that comes out of it.

use super::inputs::Inputs;
use super::outcome::{Column, Layout, Outcome};
use super::runner::{RowError, Runner};
use crate::run::{Dynamics, OnCloth, Status};
use crate::scenario::schema::{Method, Record};
use crate::scenario::{Places, Scenario, ScenarioError, Template};
use crate::simulate::Sampling;
use core::ops::Range;
use core::time::Duration;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError, mpsc};
use thiserror::Error;

/// Rows that a thread takes at once, at most.
const ROWS_AT_ONCE: usize = 128;

/// Where there are few rows, each thread takes so many times.
const TURNS: usize = 8;

/// Time between two looks at whether to break off.
const PAUSE: Duration = Duration::from_millis(20);

/// Many runs of one scenario, with some of its numbers varied.
#[derive(Clone, Debug)]
pub struct Ensemble {
    inputs: Inputs,
    template: Template,
    /// The scenario that is varied; the columns are those of its balls, whatever the rows are.
    base: Scenario,
    /// The places of the numbers, where runs can start again as they stand.
    places: Option<Places>,
    layout: Layout,
    sampling: Sampling,
}

/// What became of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The run ended.
    Ended(Status),
    /// Its numbers make no scenario.
    Rejected,
    /// The run broke an invariant: the engine's fault.
    Failed,
    /// It was not run, or not to its end.
    NotRun,
}

/// Rows of outcomes.
#[derive(Clone, Debug)]
pub struct Table {
    /// The columns of outcomes; not a number in rows without any.
    pub columns: Vec<Vec<f64>>,
    /// What became of each row.
    pub endings: Vec<Ending>,
    /// Of each row that was rejected or failed its number and why, in the order of the rows.
    pub problems: Vec<(u64, String)>,
}

/// Why an ensemble could not be computed at all.
#[derive(Debug, Error)]
pub enum EnsembleError {
    /// There are no threads to be had.
    #[error("threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

impl Ending {
    /// The word used in files, on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ended(status) => status.name(),
            Self::Rejected => "rejected",
            Self::Failed => "failed",
            Self::NotRun => "not_run",
        }
    }
}

impl Ensemble {
    /// An ensemble of a checked scenario.
    ///
    /// # Errors
    ///
    /// Where a path leads nowhere, or to what is no number; and where an outcome is not one of these balls.
    pub fn new(scenario: &Scenario, inputs: Inputs, outcomes: &[Outcome]) -> Result<Self, ScenarioError> {
        let record = if scenario.method == Method::Exact { Record::None } else { Record::Events };
        let template = Template::new(scenario, inputs.paths(), record)?;
        check_paths(&template, &inputs)?;
        let cushions =
            if scenario.has_cloth() { <OnCloth as Dynamics<f64>>::system(scenario).place_of(0) } else { 0 };
        let layout = Layout::new(scenario, outcomes, cushions)?;
        let places = if layout.observed.is_empty() { template.places() } else { None };
        let (base, sampling) = (scenario.clone(), Sampling::default());
        Ok(Self { inputs, template, base, places, layout, sampling })
    }

    /// The same, with gases observed at other times.
    #[must_use]
    pub fn sampled(self, sampling: Sampling) -> Self {
        Self { sampling, ..self }
    }

    /// The columns of its tables.
    pub fn columns(&self) -> &[Column] {
        &self.layout.columns
    }

    /// The numbers of each row.
    pub fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// The scenario of a row, which runs as that row does, and keeps what the scenario of the ensemble does.
    ///
    /// # Errors
    ///
    /// Where its numbers make no scenario.
    pub fn scenario(&self, row: u64) -> Result<Scenario, ScenarioError> {
        let mut numbers = vec![0.0; self.inputs.paths().len()];
        self.inputs.fill(row, &mut numbers);
        Ok(Scenario { record: self.base.record, ..self.template.with(&numbers)? })
    }

    /// Runs some rows, on as many threads as there are cores unless it is said on how many.
    ///
    /// Now and then `watch` is handed the number of rows done; where it says so, the rows that are left are not run.
    pub fn run(
        &self,
        rows: Range<u64>,
        threads: Option<usize>,
        watch: &mut dyn FnMut(u64) -> bool,
    ) -> Result<Table, EnsembleError> {
        let count = (rows.end - rows.start) as usize;
        let mut table = Table {
            columns: vec![vec![f64::NAN; count]; self.layout.columns.len()],
            endings: vec![Ending::NotRun; count],
            problems: Vec::new(),
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0)).build()?;
        let shared = Shared::default();
        std::thread::scope(|scope| {
            let (tell, told) = mpsc::channel::<()>();
            let (shared, table, first) = (&shared, &mut table, rows.start);
            scope.spawn(move || {
                pool.install(|| self.run_all(first, table, shared));
                drop(tell);
            });
            while told.recv_timeout(PAUSE) == Err(mpsc::RecvTimeoutError::Timeout) {
                if watch(shared.done.load(Ordering::Relaxed)) {
                    shared.is_over.store(true, Ordering::Relaxed);
                }
            }
        });
        table.problems = shared.problems.into_inner().unwrap_or_else(PoisonError::into_inner);
        table.problems.sort_unstable_by_key(|(row, _)| *row);
        Ok(table)
    }

    fn run_all(&self, first: u64, table: &mut Table, shared: &Shared) {
        let begin = || Share {
            runner: Runner::new(
                &self.template,
                &self.layout,
                &self.base,
                self.places.as_ref(),
                self.sampling,
            ),
            inputs: vec![0.0; self.inputs.paths().len()],
            outcomes: vec![0.0; self.layout.columns.len()],
        };
        let at_once = (table.endings.len() / (TURNS * rayon::current_num_threads())).clamp(1, ROWS_AT_ONCE);
        let chunks = table.endings.len().div_ceil(at_once);
        let mut parts: Vec<Vec<&mut [f64]>> = (0..chunks).map(|_| Vec::new()).collect();
        for column in &mut table.columns {
            let part = column.chunks_mut(at_once);
            parts.iter_mut().zip(part).for_each(|(parts, part)| parts.push(part));
        }
        table.endings.par_chunks_mut(at_once).zip(&mut parts).enumerate().for_each_init(
            begin,
            |share, (chunk, (endings, columns))| {
                let first = first + (chunk * at_once) as u64;
                for (place, ending) in endings.iter_mut().enumerate() {
                    if shared.is_over() {
                        return;
                    }
                    *ending = self.run_row(first + place as u64, share, shared);
                    if matches!(ending, Ending::Ended(_)) {
                        let outcomes = columns.iter_mut().zip(&share.outcomes);
                        outcomes.for_each(|(column, outcome)| column[place] = *outcome);
                    }
                }
                shared.done.fetch_add(endings.len() as u64, Ordering::Relaxed);
            },
        );
    }

    fn run_row(&self, row: u64, share: &mut Share<'_>, shared: &Shared) -> Ending {
        let Share { runner, inputs, outcomes } = share;
        self.inputs.fill(row, inputs);
        shared.judge(row, runner.run(inputs, outcomes, &|| shared.is_over()))
    }
}

/// What a thread has for itself.
struct Share<'a> {
    runner: Runner<'a>,
    inputs: Vec<f64>,
    outcomes: Vec<f64>,
}

/// What the threads share.
#[derive(Default)]
struct Shared {
    done: AtomicU64,
    is_over: AtomicBool,
    problems: Mutex<Vec<(u64, String)>>,
}

impl Shared {
    fn is_over(&self) -> bool {
        self.is_over.load(Ordering::Relaxed)
    }

    fn judge(&self, row: u64, outcome: Result<Option<Status>, RowError>) -> Ending {
        let (ending, error) = match outcome {
            Ok(status) => return status.map_or(Ending::NotRun, Ending::Ended),
            Err(error @ (RowError::Rejected(_) | RowError::Unobserved(_))) => (Ending::Rejected, error),
            Err(error @ RowError::Failed(_)) => (Ending::Failed, error),
        };
        let mut problems = self.problems.lock().unwrap_or_else(PoisonError::into_inner);
        problems.push((row, error.to_string()));
        ending
    }
}

/// Tells wrong paths with the numbers of the first row.
fn check_paths(template: &Template, inputs: &Inputs) -> Result<(), ScenarioError> {
    let mut first = vec![0.0; inputs.paths().len()];
    inputs.fill(0, &mut first);
    template.check_paths().or_else(|_| template.with(&first).map(drop))
}
