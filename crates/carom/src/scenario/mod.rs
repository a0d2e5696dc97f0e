//! The text format of scenarios, and its checking.

mod layout;
mod parse;
mod problem;
pub mod schema;

pub use problem::{Problem, ScenarioError};
pub use schema::Scenario;
