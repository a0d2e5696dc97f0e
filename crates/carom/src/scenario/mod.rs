//! The text format of scenarios, and its checking.

mod balls_from;
mod check;
mod cloth_system;
mod equipment;
mod expand;
mod gas;
mod json;
mod json_schema;
mod layout;
mod nearest;
mod parse;
mod path;
mod periodic;
mod problem;
mod rack;
pub mod schema;
mod shot;
mod start;
mod structure;
mod system;
mod template;
mod values;

pub use balls_from::{BallsRead, BallsReader};
pub use check::LARGEST;
pub use cloth_system::{ClothSystem, NoseReach, Stroke};
pub use equipment::Equipment;
pub use json_schema::json_schema;
pub use layout::Number;
pub(crate) use nearest::suggestion;
pub use path::Key;
pub use problem::{Problem, ScenarioError};
pub use schema::Scenario;
pub use shot::{CueStart, ShotStart};
pub use start::BallStart;
pub use system::System;
pub use template::{Template, Velocities};
