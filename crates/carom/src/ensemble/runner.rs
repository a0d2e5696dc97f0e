//! One thread's share of an ensemble: a run after the other, in memory that is used again.

use super::outcome::{Kept, Layout};
use crate::engine::{Engine, Simulation};
use crate::observe::Observables;
use crate::run::{OnCloth, Plane, SimulationError, Status};
use crate::scenario::{Places, Scenario, ScenarioError, Template};
use crate::simulate::{
    Any, ObservedError, SLICE, Sampling, Simulated, SimulationOf, limits_of, simulate_observed,
};
use crate::with_any;
use std::sync::Arc;
use thiserror::Error;

/// Why a row has no outcomes.
#[derive(Debug, Error)]
pub(super) enum RowError {
    /// Its numbers make no scenario.
    #[error("{0}")]
    Rejected(#[from] ScenarioError),
    /// The gas that they give cannot be observed.
    #[error("{0}")]
    Unobserved(ObservedError),
    /// The run broke an invariant.
    #[error("{0}")]
    Failed(#[from] SimulationError),
}

/// What makes runs out of rows of numbers.
pub(super) struct Runner<'a> {
    sampling: Sampling,
    template: &'a Template,
    layout: &'a Layout,
    kept: Kept,
    /// The balls in the order of the columns. A rack has its own for each seed.
    ball_ids: Vec<String>,
    /// A run that starts again and again, where it can.
    again: Option<(Places, Again)>,
}

type Again = Any<Box<SimulationOf<Plane>>, Box<SimulationOf<OnCloth>>>;

impl<'a> Runner<'a> {
    pub(super) fn new(
        template: &'a Template,
        layout: &'a Layout,
        base: &Scenario,
        places: Option<&Places>,
        sampling: Sampling,
    ) -> Self {
        let ball_ids: Vec<String> = base.expanded().balls.iter().map(|ball| ball.id.clone()).collect();
        let mut kept = layout.kept();
        kept.clear(ball_ids.len(), &layout.pairs);
        let again = places.map(|places| {
            let simulation = if base.has_cloth() {
                Any::OnCloth(Box::new(begin::<OnCloth>(base, &mut kept)))
            } else {
                Any::Plane(Box::new(begin::<Plane>(base, &mut kept)))
            };
            (places.clone(), simulation)
        });
        Self { sampling, template, layout, kept, ball_ids, again }
    }

    /// Runs a row of numbers and fills in the outcomes; `None` where it was broken off.
    pub(super) fn run(
        &mut self,
        numbers: &[f64],
        out: &mut [f64],
        interrupted: &dyn Fn() -> bool,
    ) -> Result<Option<Status>, RowError> {
        self.kept.clear(self.ball_ids.len(), &self.layout.pairs);
        if let Some((places, simulation)) = &mut self.again
            && places.set(numbers)
        {
            return with_any!(simulation, simulation => {
                simulation.restart(|system| system.put(places), &mut self.kept);
                let status = go_on(simulation, &mut self.kept, interrupted)?;
                if status.is_some() {
                    self.layout.fill(out, simulation.time(), simulation.diagnostics(), &self.kept);
                }
                Ok(status)
            });
        }
        self.run_made(numbers, out, interrupted)
    }

    /// Makes a scenario and runs that.
    #[inline(never)]
    fn run_made(
        &mut self,
        numbers: &[f64],
        out: &mut [f64],
        interrupted: &dyn Fn() -> bool,
    ) -> Result<Option<Status>, RowError> {
        let scenario = self.template.with(numbers)?;
        if !self.layout.observed.is_empty() {
            return self.observe(&scenario, out, interrupted);
        }
        if scenario.has_cloth() {
            self.run_anew::<OnCloth>(&scenario, out, interrupted)
        } else {
            self.run_anew::<Plane>(&scenario, out, interrupted)
        }
    }

    /// Runs a gas and observes it.
    fn observe(
        &mut self,
        scenario: &Scenario,
        out: &mut [f64],
        interrupted: &dyn Fn() -> bool,
    ) -> Result<Option<Status>, RowError> {
        let observables = Observables::new(&self.layout.observed).map_err(ObservedError::from);
        let observed = observables.and_then(|observables| {
            simulate_observed(scenario, None, observables, &self.sampling, &mut |_| interrupted())
        });
        let (run, observables) = observed.map_err(|error| match error {
            ObservedError::Simulation(error) => RowError::Failed(error),
            other => RowError::Unobserved(other),
        })?;
        if run.status == Status::Interrupted {
            return Ok(None);
        }
        self.kept.clear(run.system.ball_ids.len(), &[]);
        self.kept.results = observables.results();
        self.kept.keep_end::<Plane>(run.end_time, run.final_state().into_iter());
        self.kept.reorder(&run.system.ball_ids, &self.ball_ids);
        self.layout.fill(out, run.end_time, &run.diagnostics, &self.kept);
        Ok(Some(run.status))
    }

    fn run_anew<D: Simulated>(
        &mut self,
        scenario: &Scenario,
        out: &mut [f64],
        interrupted: &dyn Fn() -> bool,
    ) -> Result<Option<Status>, RowError> {
        if let Some(run) = D::stepped(scenario, None, &mut || interrupted()) {
            if run.status == Status::Interrupted {
                return Ok(None);
            }
            let own = D::ball_ids(&run.system);
            self.kept.clear(own.len(), &[]);
            run.log.events.iter().for_each(|event| self.kept.note(event));
            self.kept.keep_end::<D>(run.end_time, run.final_state().into_iter());
            self.kept.reorder(own, &self.ball_ids);
            self.layout.fill(out, run.end_time, &run.diagnostics, &self.kept);
            return Ok(Some(run.status));
        }
        let system = Arc::new(D::system(scenario));
        let own = D::ball_ids(&system);
        self.kept.clear(own.len(), &self.pairs_among(own));
        let mut simulation: SimulationOf<D> =
            Simulation::new(system, limits_of(scenario, None), &mut self.kept);
        let status = go_on(&mut simulation, &mut self.kept, interrupted)?;
        if status.is_some() {
            self.kept.reorder(D::ball_ids(simulation.system()), &self.ball_ids);
            self.layout.fill(out, simulation.time(), simulation.diagnostics(), &self.kept);
        }
        Ok(status)
    }
}

impl Runner<'_> {
    /// The watched pairs in another order of the balls.
    fn pairs_among(&self, own: &[String]) -> Vec<[usize; 2]> {
        if own == self.ball_ids {
            return self.layout.pairs.clone();
        }
        let place = |ball: usize| own.iter().position(|id| *id == self.ball_ids[ball]).unwrap_or(usize::MAX);
        self.layout.pairs.iter().map(|pair| pair.map(place)).collect()
    }
}

/// A run at time zero.
fn begin<D: Simulated>(scenario: &Scenario, kept: &mut Kept) -> SimulationOf<D> {
    Simulation::new(Arc::new(D::system(scenario)), limits_of(scenario, None), kept)
}

/// Goes on to the end and keeps the states there; `None` where the run was broken off.
fn go_on<E: Engine<f64>>(
    simulation: &mut Simulation<f64, E>,
    kept: &mut Kept,
    interrupted: &dyn Fn() -> bool,
) -> Result<Option<Status>, SimulationError> {
    while simulation.advance(SLICE, kept)? {
        if interrupted() {
            return Ok(None);
        }
    }
    kept.keep_end::<E::Dynamics>(simulation.time(), simulation.states());
    Ok(simulation.status())
}
