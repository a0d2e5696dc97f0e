//! What the numbers of a saved run must be for it to be one: columns of one length, names that exist, an end that fits.
//!
//! Every check gives the place of what it found. Whether the numbers are right only a run made again can tell.

use super::RunFile;
use super::columns::{EventColumns, FlightColumns, StepColumns};
use super::saved::Saved;
use crate::run::{Digest, Status};

pub(super) type Found = Result<(), String>;

/// Refuses a file that no run can be made of.
pub(super) fn check<D: Saved>(file: &RunFile<D>, system: &D::System) -> Found {
    let names = (D::ball_ids(system).len(), D::cushion_ids(system).len());
    if file.balls.len() != names.0 {
        return Err("balls: not as many as the scenario has".to_owned());
    }
    for (k, ball) in file.balls.iter().enumerate() {
        D::check_entry(ball, &format!("balls[{k}]"), system)?;
    }
    file.events.iter().try_for_each(|events| check_events(events, names))?;
    file.flights.iter().try_for_each(|flights| check_flights(flights, names.0))?;
    file.steps.iter().try_for_each(|steps| check_steps(steps, names.0))?;
    check_end(file)?;
    if file.status == Status::AtRest { check_rest::<D>(&file.balls, system) } else { Ok(()) }
}

fn check_events(events: &EventColumns, (balls, cushions): (usize, usize)) -> Found {
    let lengths = [
        events.kind.len(),
        events.ball_a.len(),
        events.ball_b.len(),
        events.cushion.len(),
        events.x.len(),
        events.y.len(),
        events.normal_x.len(),
        events.normal_y.len(),
        events.closing_speed.len(),
        events.impulse.len(),
        events.cluster.len(),
    ];
    if lengths.iter().any(|length| *length != events.time.len()) {
        return Err("events: the columns have unequal lengths".to_owned());
    }
    let is_ball = |ball: &u32| (*ball as usize) < balls;
    let is_cushion = |cushion: &u32| (*cushion as usize) < cushions;
    let mut numbers = events.ball_a.iter().chain(events.ball_b.iter().flatten());
    if !numbers.all(is_ball) || !events.cushion.iter().flatten().all(is_cushion) {
        return Err("events: a ball or cushion that the scenario does not have".to_owned());
    }
    Ok(())
}

fn check_flights<N>(flights: &FlightColumns<N>, balls: usize) -> Found {
    let rows = flights.ball.len();
    if flights.start.len() != rows || flights.state.len() != rows {
        return Err("flights: the columns have unequal lengths".to_owned());
    }
    let mut seen = vec![false; balls];
    for ball in &flights.ball {
        match seen.get_mut(*ball as usize) {
            Some(seen) => *seen = true,
            None => return Err("flights: a ball that the scenario does not have".to_owned()),
        }
    }
    if seen.contains(&false) { Err("flights: a ball without any".to_owned()) } else { Ok(()) }
}

fn check_steps(steps: &StepColumns, balls: usize) -> Found {
    let rows = steps.time.len();
    if rows != 1 && !steps.is_whole() {
        return Err("steps: neither as many as were made nor the last only".to_owned());
    }
    if rows == 0
        || steps.state.len() != rows
        || steps.hits.len() != rows
        || !steps.state.iter().all(|row| row.len() == balls)
        || !steps.hits.iter().all(|row| row.len() == balls)
    {
        return Err("steps: the columns have unequal lengths".to_owned());
    }
    Ok(())
}

/// Refuses an end before the start, or before anything that happened.
fn check_end<D: Saved>(file: &RunFile<D>) -> Found {
    if file.end_time < 0.0 {
        return Err("end_time: before the start".to_owned());
    }
    // The hits of a step are within it but for round-off, so the step itself is looked at.
    let events = file.events.iter().filter(|_| file.steps.is_none()).flat_map(|events| &events.time);
    let flights = file.flights.iter().flat_map(|flights| &flights.start);
    let steps = file.steps.iter().flat_map(|steps| &steps.time);
    ends_after(file.end_time, "events.time", events)?;
    ends_after(file.end_time, "flights.start", flights)?;
    ends_after(file.end_time, "steps.time", steps)?;
    let starts: Vec<f64> = file.balls.iter().map(|ball| D::start(&D::ball_of(ball).0)).collect();
    ends_after(file.end_time, "balls.start", starts.iter())
}

fn ends_after<'a>(end: f64, place: &str, mut times: impl Iterator<Item = &'a f64>) -> Found {
    match times.position(|time| *time > end) {
        Some(k) => Err(format!("end_time: before {}", indexed(place, k))),
        None => Ok(()),
    }
}

/// `balls.start` and 3 make `balls[3].start`: balls are a list of rows, all else has columns.
fn indexed(place: &str, k: usize) -> String {
    match place.strip_prefix("balls") {
        Some(key) => format!("balls[{k}]{key}"),
        None => format!("{place}[{k}]"),
    }
}

fn check_rest<D: Saved>(balls: &[D::Entry], system: &D::System) -> Found {
    let moves = |ball: &D::Entry| !D::is_rest(&D::ball_of(ball).0, system);
    match balls.iter().position(moves) {
        Some(k) => Err(format!("status: at_rest, but balls[{k}] moves")),
        None => Ok(()),
    }
}

/// Gives the place of a number that is infinite or none, of which JSON has neither.
pub(super) fn check_finite<D: Saved>(file: &RunFile<D>) -> Found {
    finite("end_time", [file.end_time]).map_err(|_| "end_time".to_owned())?;
    if let Some(e) = &file.events {
        let columns = [
            ("time", &e.time),
            ("x", &e.x),
            ("y", &e.y),
            ("normal_x", &e.normal_x),
            ("normal_y", &e.normal_y),
            ("closing_speed", &e.closing_speed),
            ("impulse", &e.impulse),
        ];
        columns
            .into_iter()
            .try_for_each(|(name, column)| finite(&format!("events.{name}"), column.iter().copied()))?;
    }
    if let Some(flights) = &file.flights {
        finite("flights.start", flights.start.iter().copied())?;
        finite("flights.state", flights.state.iter().map(D::worst_of))?;
    }
    for (k, ball) in file.balls.iter().enumerate() {
        let not_finite = D::finite_keys(ball).into_iter().find(|(_, value)| !value.is_finite());
        if let Some((key, _)) = not_finite {
            return Err(format!("balls[{k}].{key}"));
        }
    }
    file.steps.iter().try_for_each(finite_steps)?;
    finite_diagnostics(file)?;
    if file.digest == Digest::none() { Err("the state at the end".to_owned()) } else { Ok(()) }
}

fn finite_steps(steps: &StepColumns) -> Found {
    finite("steps.time", steps.time.iter().copied())?;
    finite("steps.state", steps.state.iter().map(|row| worst(row.as_flattened())))?;
    let after =
        |row: &Vec<Option<(f64, _)>>| row.iter().flatten().map(|(after, _)| *after).collect::<Vec<_>>();
    finite("steps.hits", steps.hits.iter().map(|row| worst(&after(row))))?;
    finite("steps.lost_time", [steps.lost_time]).map_err(|_| "steps.lost_time".to_owned())
}

fn finite_diagnostics<D: Saved>(file: &RunFile<D>) -> Found {
    let found = serde_json::to_value(&file.diagnostics).map_err(|error| error.to_string())?;
    let mut keys = found.as_object().into_iter().flatten();
    match keys.find(|(_, value)| value.is_null()) {
        Some((key, _)) => Err(format!("diagnostics.{key}")),
        None => Ok(()),
    }
}

fn finite(place: &str, values: impl IntoIterator<Item = f64>) -> Found {
    match values.into_iter().position(|value| !value.is_finite()) {
        Some(k) => Err(indexed(place, k)),
        None => Ok(()),
    }
}

/// A number of a row that is not finite, if it has one.
pub(super) fn worst(row: &[f64]) -> f64 {
    row.iter().copied().find(|value| !value.is_finite()).unwrap_or(0.0)
}
