//! The columns of a saved run, from what was kept of it and back.

use super::saved::Saved;
use crate::flight::State;
use crate::geometry::Vec2;
use crate::run::{Event, Hit, Kind, Step, Steps};
use serde::{Deserialize, Serialize};

#[derive(Default, Serialize, Deserialize)]
pub(super) struct EventColumns {
    pub(super) time: Vec<f64>,
    pub(super) kind: Vec<Kind>,
    pub(super) ball_a: Vec<u32>,
    pub(super) ball_b: Vec<Option<u32>>,
    pub(super) cushion: Vec<Option<u32>>,
    pub(super) x: Vec<f64>,
    pub(super) y: Vec<f64>,
    pub(super) normal_x: Vec<f64>,
    pub(super) normal_y: Vec<f64>,
    pub(super) closing_speed: Vec<f64>,
    pub(super) impulse: Vec<f64>,
    pub(super) cluster: Vec<Option<u32>>,
}

#[derive(Serialize, Deserialize)]
pub(super) struct FlightColumns<N> {
    pub(super) ball: Vec<u32>,
    pub(super) start: Vec<f64>,
    pub(super) state: Vec<N>,
}

#[derive(Default, Serialize, Deserialize)]
pub struct StepColumns {
    pub(super) time: Vec<f64>,
    /// Position and velocity of each ball.
    pub(super) state: Vec<Vec<[f64; 4]>>,
    pub(super) hits: Vec<Vec<Option<(f64, Kind)>>>,
    pub(super) count: u64,
    pub(super) lost_time: f64,
}

pub(super) fn event_columns(events: &[Event<f64>]) -> EventColumns {
    let mut columns = EventColumns::default();
    for event in events {
        columns.time.push(event.time);
        columns.kind.push(event.kind);
        columns.ball_a.push(event.ball_a);
        columns.ball_b.push(event.ball_b);
        columns.cushion.push(event.cushion);
        columns.x.push(event.point.x);
        columns.y.push(event.point.y);
        columns.normal_x.push(event.normal.x);
        columns.normal_y.push(event.normal.y);
        columns.closing_speed.push(event.closing_speed);
        columns.impulse.push(event.impulse);
        columns.cluster.push(event.cluster);
    }
    columns
}

impl EventColumns {
    pub(super) fn rows(self) -> Vec<Event<f64>> {
        let row = |k: usize| Event {
            time: self.time[k],
            kind: self.kind[k],
            ball_a: self.ball_a[k],
            ball_b: self.ball_b[k],
            cushion: self.cushion[k],
            point: Vec2::new(self.x[k], self.y[k]),
            normal: Vec2::new(self.normal_x[k], self.normal_y[k]),
            closing_speed: self.closing_speed[k],
            impulse: self.impulse[k],
            cluster: self.cluster[k],
        };
        (0..self.time.len()).map(row).collect()
    }
}

pub(super) fn flight_columns<D: Saved>(flights: &[(u32, D::Flight)]) -> FlightColumns<D::Numbers> {
    FlightColumns {
        ball: flights.iter().map(|(ball, _)| *ball).collect(),
        start: flights.iter().map(|(_, flight)| D::start(flight)).collect(),
        state: flights.iter().map(|(_, flight)| D::numbers_of(flight)).collect(),
    }
}

impl<N> FlightColumns<N> {
    pub(super) fn rows<D: Saved<Numbers = N>>(self) -> Vec<(u32, D::Flight)> {
        let states = self.start.into_iter().zip(self.state);
        let flight = |(ball, (start, state))| (ball, D::flight_of(start, &state));
        self.ball.into_iter().zip(states).map(flight).collect()
    }
}

pub(super) fn step_columns(steps: &Steps<f64>) -> StepColumns {
    let state = |State { position, velocity }: &State<f64>| [position.x, position.y, velocity.x, velocity.y];
    let hit = |hit: &Option<Hit<f64>>| hit.map(|hit| (hit.after, hit.kind));
    StepColumns {
        time: steps.steps.iter().map(|step| step.time).collect(),
        state: steps.steps.iter().map(|step| step.balls.iter().map(state).collect()).collect(),
        hits: steps.steps.iter().map(|step| step.hits.iter().map(hit).collect()).collect(),
        count: steps.count,
        lost_time: steps.lost_time,
    }
}

impl StepColumns {
    /// Whether all steps were kept, and not the end only.
    pub(super) fn is_whole(&self) -> bool {
        self.time.len() as u64 == self.count.saturating_add(1)
    }

    pub(super) fn steps(self) -> Steps<f64> {
        let ball =
            |[x, y, vx, vy]: [f64; 4]| State { position: Vec2::new(x, y), velocity: Vec2::new(vx, vy) };
        let hit = |hit: &Option<(f64, Kind)>| hit.map(|(after, kind)| Hit { after, kind });
        let step = |k: usize| Step {
            time: self.time[k],
            balls: self.state[k].iter().copied().map(ball).collect(),
            hits: self.hits[k].iter().map(hit).collect(),
        };
        Steps {
            steps: (0..self.time.len()).map(step).collect(),
            count: self.count,
            lost_time: self.lost_time,
        }
    }
}
