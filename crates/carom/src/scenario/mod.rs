//! The text format of scenarios, and its checking.

mod layout;
mod parse;
mod problem;
pub mod schema;
mod system;

pub use problem::{Problem, ScenarioError};
pub use schema::Scenario;
pub use system::System;
