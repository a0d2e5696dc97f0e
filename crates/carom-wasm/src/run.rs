//! Runs.

use crate::errors::{file_error, problem, query_error, scenario_error};
use crate::scenario::Scenario;
use carom::run::{Digest, Event, Film, Kind, to_json};
use carom::scenario::Scenario as Checked;
use carom::simulate::{self, AnyRun};
use carom::with_any;
use js_sys::{Array, Float64Array, Int32Array, Object, Reflect, Uint32Array};
use serde_json::json;
use std::rc::Rc;
use wasm_bindgen::prelude::*;

/// A computed run, with the scenario as it was run.
#[wasm_bindgen]
pub struct Run {
    scenario: Rc<Checked>,
    run: AnyRun,
}

impl Run {
    pub fn new(scenario: Rc<Checked>, run: AnyRun) -> Self {
        Self { scenario, run }
    }
}

#[wasm_bindgen]
impl Run {
    /// How it ended and what it found out about itself, as JSON text.
    pub fn summary(&self) -> Result<String, JsValue> {
        let (digest, findings) = with_any!(&self.run, run => (run.digest(), run.findings()));
        let findings = findings.map_err(|error| problem("run", &error.to_string()))?;
        let summary = with_any!(&self.run, run => json!({
            "status": run.status.name(),
            "endTime": run.end_time,
            "digest": digest.map(|digest: Digest| digest.state),
            "ballIds": run.system.ball_ids,
            "diagnostics": findings,
            "references": run.references(),
        }));
        Ok(summary.to_string())
    }

    /// The course of each ball: `width`, `firstRows` and `numbers` of a [`Film`].
    pub fn film(&self) -> Result<Object, JsValue> {
        let Film { width, first_rows, numbers } =
            with_any!(&self.run, run => run.film()).map_err(|error| query_error(&error))?;
        object(&[
            ("width", JsValue::from(width as u32)),
            ("firstRows", Uint32Array::from(&first_rows[..]).into()),
            ("numbers", Float64Array::from(&numbers[..]).into()),
        ])
    }

    /// The events as columns; balls, cushions, pockets and kinds as codes, with −1 for none, and the words of the codes.
    pub fn events(&self) -> Result<Object, JsValue> {
        let (cushions, pockets) = self.places();
        let events = with_any!(&self.run, run => &run.log.events);
        let quantity = |value: fn(&Event<f64>) -> f64| {
            Float64Array::from(&events.iter().map(value).collect::<Vec<_>>()[..]).into()
        };
        let code = |value: &dyn Fn(&Event<f64>) -> Option<u32>| {
            let codes: Vec<i32> =
                events.iter().map(|event| value(event).map_or(-1, |code| code as i32)).collect();
            Int32Array::from(&codes[..]).into()
        };
        let is_pocket = |event: &Event<f64>| event.kind == Kind::BallPocket;
        let first_pocket = cushions.len() as u32;
        object(&[
            ("time", quantity(|event| event.time)),
            ("kind", code(&|event| Some(event.kind as u32))),
            ("ballA", code(&|event| Some(event.ball_a))),
            ("ballB", code(&|event| event.ball_b)),
            ("cushion", code(&|event| event.cushion.filter(|_| !is_pocket(event)))),
            (
                "pocket",
                code(&|event| event.cushion.filter(|_| is_pocket(event)).map(|place| place - first_pocket)),
            ),
            ("x", quantity(|event| event.point.x)),
            ("y", quantity(|event| event.point.y)),
            ("normalX", quantity(|event| event.normal.x)),
            ("normalY", quantity(|event| event.normal.y)),
            ("closingSpeed", quantity(|event| event.closing_speed)),
            ("impulse", quantity(|event| event.impulse)),
            ("cluster", code(&|event| event.cluster)),
            ("cushionIds", words(cushions)),
            ("pocketIds", words(pockets)),
        ])
    }

    /// Kinetic energy, potential energy and the components of the momentum at each of some times, one row after the other.
    pub fn totals(&self, times: &[f64]) -> Result<Vec<f64>, JsValue> {
        let mut rows = Vec::new();
        for &time in times {
            with_any!(&self.run, run => {
                rows.push(run.energy(time).map_err(|error| query_error(&error))?);
                rows.push(run.potential_energy(time).map_err(|error| query_error(&error))?);
                rows.extend(run.momentum(time).map_err(|error| query_error(&error))?.to_f64());
            });
        }
        Ok(rows)
    }

    /// The scenario that goes on from the end of the run, without a shot.
    pub fn final_scenario(&self) -> Result<Scenario, JsValue> {
        let found = simulate::final_scenario(&self.scenario, &self.run);
        found.map(Scenario::new).map_err(|error| scenario_error(&error))
    }

    /// The run as JSON text, as `carom.load_run` reads it.
    pub fn to_json(&self) -> Result<String, JsValue> {
        with_any!(&self.run, run => to_json(&self.scenario, run)).map_err(|error| file_error(&error))
    }
}

impl Run {
    /// The ids of cushions and corners, and those of pockets, which are numbered after them.
    fn places(&self) -> (&[String], &[String]) {
        match &self.run {
            AnyRun::Plane(run) => (&run.system.cushion_ids, &[]),
            AnyRun::OnCloth(run) => run.system.cushion_ids.split_at(run.system.place_of(0) as usize),
        }
    }
}

fn object(entries: &[(&str, JsValue)]) -> Result<Object, JsValue> {
    let object = Object::new();
    for (key, value) in entries {
        Reflect::set(&object, &JsValue::from_str(key), value)?;
    }
    Ok(object)
}

fn words(words: &[String]) -> JsValue {
    words.iter().map(|word| JsValue::from_str(word)).collect::<Array>().into()
}
