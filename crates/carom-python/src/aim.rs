//! Aiming: what the package asks of a scenario, and the answers.

use crate::errors::aim_problem;
use crate::scenario::Scenario;
use carom::aim::{self, Pot, Scene};
use pyo3::prelude::*;
use serde_json::{Value, json};

fn scene(scenario: &Scenario, cue_ball: Option<&str>) -> PyResult<Scene> {
    Scene::new(scenario.inner(), cue_ball).map_err(aim_problem)
}

/// The direction from the cue ball to a point.
#[pyfunction]
pub fn aim_at_point(scenario: &Scenario, point: [f64; 2], cue_ball: Option<&str>) -> PyResult<f64> {
    aim::at_point(&scene(scenario, cue_ball)?, point).map_err(aim_problem)
}

/// The direction in which the cue ball hits a ball with a cut angle.
#[pyfunction]
pub fn aim_at_ball(scenario: &Scenario, ball: &str, cut_deg: f64, cue_ball: Option<&str>) -> PyResult<f64> {
    aim::at_ball(&scene(scenario, cue_ball)?, ball, cut_deg).map_err(aim_problem)
}

/// Where one aims to pot a ball into a pocket.
#[pyfunction]
pub fn aiming_point(scenario: &Scenario, pocket: &str) -> PyResult<[f64; 2]> {
    aim::aiming_point(scenario.inner(), pocket).map_err(aim_problem)
}

/// Where the cue ball has to be at contact so that a ball goes to the aiming point of a pocket, as JSON text.
#[pyfunction]
pub fn ghost_ball(scenario: &Scenario, ball: &str, pocket: &str, cue_ball: Option<&str>) -> PyResult<String> {
    let ghost = aim::ghost_ball(&scene(scenario, cue_ball)?, ball, pocket).map_err(aim_problem)?;
    Ok(json!({ "center": ghost.center, "direction_deg": ghost.direction_deg, "cut_deg": ghost.cut_deg })
        .to_string())
}

/// All open pots, as JSON text.
#[pyfunction]
pub fn open_pots(scenario: &Scenario, cue_ball: Option<&str>) -> PyResult<String> {
    let pots = aim::open_pots(&scene(scenario, cue_ball)?);
    Ok(pots.iter().map(said).collect::<Value>().to_string())
}

/// One pot, as JSON text.
#[pyfunction]
pub fn open_pot(scenario: &Scenario, ball: &str, pocket: &str, cue_ball: Option<&str>) -> PyResult<String> {
    let pot = aim::pot(&scene(scenario, cue_ball)?, ball, pocket).map_err(aim_problem)?;
    Ok(said(&pot).to_string())
}

/// What the stick of the shot meets, as JSON text.
#[pyfunction]
pub fn obstructions(scenario: &Scenario) -> PyResult<String> {
    let found = aim::obstructions(scenario.inner()).map_err(aim_problem)?;
    Ok(json!(found).to_string())
}

/// The least elevation at which the stick of the shot clears everything.
#[pyfunction]
pub fn least_elevation_deg(scenario: &Scenario) -> PyResult<Option<f64>> {
    aim::least_elevation_deg(scenario.inner()).map_err(aim_problem)
}

fn said(pot: &Pot) -> Value {
    json!({
        "ball": pot.ball,
        "pocket": pot.pocket,
        "direction_deg": pot.direction_deg,
        "cut_deg": pot.cut_deg,
        "ghost": pot.ghost,
        "cue_distance": pot.cue_distance,
        "object_distance": pot.object_distance,
        "window_deg": pot.window_deg,
        "object_window_deg": pot.object_window_deg,
    })
}
