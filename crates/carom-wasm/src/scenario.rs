//! Scenarios.

use crate::errors::{problem, scenario_error};
use carom::aim;
use carom::scenario::{Scenario as Checked, ScenarioError, value_of_toml};
use serde_json::{Map, Value, json};
use std::ops::Deref;
use std::rc::Rc;
use wasm_bindgen::prelude::*;

/// A checked scenario, shared with its runs.
#[wasm_bindgen]
pub struct Scenario(Rc<Checked>);

impl Scenario {
    pub fn new(scenario: Checked) -> Self {
        Self(Rc::new(scenario))
    }

    pub fn share(&self) -> Rc<Checked> {
        Rc::clone(&self.0)
    }
}

impl Deref for Scenario {
    type Target = Checked;

    fn deref(&self) -> &Checked {
        &self.0
    }
}

#[wasm_bindgen]
impl Scenario {
    /// Reads a scenario; the format is "toml" or "json". Balls of another file cannot be read here.
    pub fn parse(text: &str, format: &str) -> Result<Self, JsValue> {
        let value = match format {
            "toml" => value_of_toml(text).map_err(|error| scenario_error(&error))?,
            _ => serde_json::from_str(text).map_err(|error| problem("scenario", &error.to_string()))?,
        };
        checked(Checked::from_value(&value))
    }

    /// The scenario with the values of a JSON object put in at the paths that are its keys.
    pub fn with_values(&self, values_json: &str) -> Result<Self, JsValue> {
        let values: Map<String, Value> =
            serde_json::from_str(values_json).map_err(|error| problem("values", &error.to_string()))?;
        checked(self.0.with_values(&values.into_iter().collect::<Vec<_>>()))
    }

    /// The scenario as JSON text.
    pub fn to_json(&self) -> Result<String, JsValue> {
        self.0.to_json().map_err(|error| scenario_error(&error))
    }

    /// The scenario as TOML text.
    pub fn to_toml(&self) -> Result<String, JsValue> {
        self.0.to_toml().map_err(|error| scenario_error(&error))
    }

    /// The scenario with its preset, its rack and its gas turned into plain keys.
    pub fn expanded(&self) -> Self {
        Self::new(self.0.expanded().into_owned())
    }

    /// What the stick of the shot meets where it strikes, as JSON text.
    pub fn obstructions(&self) -> Result<String, JsValue> {
        let found = aim::obstructions(&self.0);
        found.map(|found| json!(found).to_string()).map_err(|error| scenario_error(&error.into()))
    }

    /// What there is to draw, as JSON text: table, balls at the start, cue, units, and whether the balls roll on a cloth.
    pub fn drawing(&self) -> String {
        json!({
            "table": self.0.outline(),
            "balls": self.0.balls_at_start(),
            "cue": self.0.cue_to_draw(),
            "units": self.0.unit_names(),
            "isOnCloth": self.0.has_cloth(),
        })
        .to_string()
    }
}

fn checked(scenario: Result<Checked, ScenarioError>) -> Result<Scenario, JsValue> {
    scenario.map(Scenario::new).map_err(|error| scenario_error(&error))
}
