//! Runs under way, computed a slice at a time so that the page can ask for something else in between.

use crate::errors::{problem, simulation_error};
use crate::run::Run;
use crate::scenario::Scenario;
use carom::run::{Kind, Log, SimulationError};
use carom::scenario::{Scenario as Checked, schema::Record};
use carom::simulate::{AnyRun, AnySimulation, Simulated, SimulationOf};
use carom::with_any;
use std::collections::VecDeque;
use std::rc::Rc;
use wasm_bindgen::prelude::*;

/// A run under way, all of whose course is kept.
#[wasm_bindgen]
pub struct Computation {
    scenario: Rc<Checked>,
    simulation: AnySimulation,
}

#[wasm_bindgen]
impl Computation {
    /// A run of the exact method at time zero; it ends with the first event of a kind, if one is named.
    #[wasm_bindgen(constructor)]
    pub fn new(scenario: &Scenario, until: Option<String>) -> Result<Self, JsValue> {
        let scenario = all_kept(scenario);
        let until = until.as_deref().map(kind).transpose()?;
        let simulation = AnySimulation::start(&scenario, until, &mut VecDeque::new());
        Ok(Self { scenario, simulation })
    }

    /// Goes on for up to so many steps; says whether the run goes on.
    pub fn advance(&mut self, steps: u32) -> Result<bool, JsValue> {
        with_any!(&mut self.simulation, inner => advance(inner, steps))
            .map_err(|error| simulation_error(&error))
    }

    /// The time that it has come to.
    pub fn time(&self) -> f64 {
        with_any!(&self.simulation, inner => inner.0.time())
    }

    /// The events that have happened.
    pub fn events(&self) -> f64 {
        with_any!(&self.simulation, inner => inner.0.diagnostics().total_events()) as f64
    }

    /// The run so far; one that has not ended counts as stopped. The computation can go on.
    pub fn run(&self) -> Run {
        let run = with_any!(&self.simulation, inner => {
            let (simulation, log) = (**inner).clone();
            simulation.finish(log).into()
        });
        Run::new(Rc::clone(&self.scenario), run)
    }

    /// The same where the computation need not go on, without another copy of it.
    pub fn finish(self) -> Run {
        let run = match self.simulation {
            AnySimulation::Plane(inner) => inner.0.finish(inner.1).into(),
            AnySimulation::OnCloth(inner) => inner.0.finish(inner.1).into(),
        };
        Run::new(self.scenario, run)
    }
}

/// The run of a scenario by the method that it names, at once, or until `interrupted` returns true.
#[wasm_bindgen]
pub fn run_at_once(scenario: &Scenario, interrupted: &js_sys::Function) -> Result<Run, JsValue> {
    let scenario = all_kept(scenario);
    let mut ask = || interrupted.call0(&JsValue::NULL).map_or(true, |answer| answer.is_truthy());
    let run = AnyRun::simulate(&scenario, None, &mut ask).map_err(|error| simulation_error(&error))?;
    Ok(Run::new(scenario, run))
}

/// The scenario whose runs keep everything, as what is drawn needs it.
fn all_kept(scenario: &Scenario) -> Rc<Checked> {
    match scenario.record() {
        Record::All => scenario.share(),
        _ => Rc::new(Checked { record: Some(Record::All), ..Checked::clone(scenario) }),
    }
}

fn kind(name: &str) -> Result<Kind, JsValue> {
    let known = || format!("must be one of {}", Kind::ALL.map(Kind::name).join(", "));
    Kind::from_name(name).ok_or_else(|| problem("until", &known()))
}

fn advance<D: Simulated>(
    (simulation, log): &mut (SimulationOf<D>, Log<f64, D>),
    steps: u32,
) -> Result<bool, SimulationError> {
    simulation.advance(u64::from(steps), log)
}
