//! The text format of scenarios, and its checking.

mod json_schema;
mod layout;
mod nearest;
mod parse;
mod path;
mod problem;
pub mod schema;
mod system;
mod structure;

pub use json_schema::json_schema;
pub use layout::Number;
pub use path::Key;
pub use problem::{Problem, ScenarioError};
pub use schema::Scenario;
pub use system::System;
