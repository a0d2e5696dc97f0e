//! From the end of a run to the scenario that goes on from there.

use super::AnyRun;
use crate::flight::{Motion, SphereState, State};
use crate::geometry::{Vec2, Vec3};
use crate::scenario::schema::{Ball, Vector};
use crate::scenario::{Scenario, ScenarioError, System};
use serde_json::json;

/// The scenario that goes on from the end of a run of a checked scenario, without a shot.
///
/// The balls are where they lie, and move as they do then, if they still do; those out of play are left out, and so is the
/// rack. A gas becomes a table with balls, and on a periodic table each ball lies inside. All else is kept.
///
/// # Errors
///
/// When no ball is left.
pub fn final_scenario(scenario: &Scenario, run: &AnyRun) -> Result<Scenario, ScenarioError> {
    let expanded = scenario.expanded();
    let ends: Vec<Option<End>> = match run {
        AnyRun::Plane(run) => run.final_state().iter().map(|state| in_plane(&run.system, state)).collect(),
        AnyRun::OnCloth(run) => run.final_state().iter().map(on_cloth).collect(),
    };
    let balls = expanded.balls.iter().zip(ends).filter_map(|(ball, end)| Some(end?.of(ball))).collect();
    let base = if scenario.gas.is_some() { &*expanded } else { scenario };
    let rest = Scenario { rack: None, shot: None, balls, ..base.clone() };
    let mut value = rest.to_value()?;
    if rest.balls.is_empty() {
        // Absent, they would be said to be missing.
        value["balls"] = json!([]);
    }
    Scenario::from_value(&value)
}

/// Where a ball is at the end, and how it moves, if it does.
struct End {
    position: Vector,
    velocity: Option<Vector>,
    spin: Option<[f64; 3]>,
}

impl End {
    fn of(self, ball: &Ball) -> Ball {
        let Self { position, velocity, spin } = self;
        Ball { position: Some(position), velocity, spin, speed: None, direction_deg: None, ..ball.clone() }
    }
}

/// The end of a disc; without the rounds of a periodic table.
fn in_plane(system: &System<f64>, &State { position, velocity }: &State<f64>) -> Option<End> {
    let [x, y] = position.to_f64();
    let (extent, [around_x, around_y]) = (system.extent(), system.periodic);
    let inside = |place: f64, size: f64, is_open: bool| if is_open { place.rem_euclid(size) } else { place };
    let position = [inside(x, extent.x, around_x), inside(y, extent.y, around_y)];
    let velocity = (velocity != Vec2::ZERO).then(|| velocity.to_f64().into());
    (x.is_finite() && y.is_finite()).then(|| End { position: position.into(), velocity, spin: None })
}

/// The end of a ball on a cloth; none of one that is out of play.
fn on_cloth(state: &SphereState<f64>) -> Option<End> {
    if state.motion.is_out() {
        return None;
    }
    let [x, y, z] = state.position.to_f64();
    let is_up = state.motion == Motion::Airborne;
    let position = if is_up { Vector::in_space([x, y, z]) } else { [x, y].into() };
    let (velocity, spin) = (state.twist.velocity, state.twist.spin);
    let velocity = (velocity != Vec3::ZERO).then(|| Vector::in_space(velocity.to_f64()));
    Some(End { position, velocity, spin: (spin != Vec3::ZERO).then(|| spin.to_f64()) })
}
