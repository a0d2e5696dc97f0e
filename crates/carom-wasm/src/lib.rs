//! The browser binding: conversions, and nothing else.

mod computation;
mod errors;
mod run;
mod scenario;

use carom::run::{Kind, PHYSICS_VERSION, VERSION};
use serde_json::json;
use wasm_bindgen::prelude::*;

/// The words and numbers that the page and the engine have in common, as JSON text.
#[wasm_bindgen]
pub fn vocabulary() -> String {
    json!({
        "version": VERSION,
        "physics_version": PHYSICS_VERSION,
        "kinds": Kind::ALL.map(Kind::name),
        "motions": carom::flight::Motion::ALL.map(carom::flight::Motion::name),
        "presets": carom::scenario::schema::Preset::ALL.map(|preset| [preset.name(), preset.title()]),
    })
    .to_string()
}

/// The JSON Schema of scenarios, as JSON text.
#[wasm_bindgen]
pub fn schema() -> String {
    carom::scenario::json_schema().to_string()
}
