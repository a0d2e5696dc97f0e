//! The text format of scenarios, and its checking.

mod check;
mod cloth_system;
mod json;
mod json_schema;
mod layout;
mod nearest;
mod parse;
mod path;
mod problem;
pub mod schema;
mod start;
mod structure;
mod system;
mod values;

pub use check::LARGEST;
pub use cloth_system::{ClothSystem, NoseReach, Stroke};
pub use json_schema::json_schema;
pub use layout::Number;
pub use path::Key;
pub use problem::{Problem, ScenarioError};
pub use schema::Scenario;
pub use start::BallStart;
pub use system::System;
