//! How the flights and balls of a dynamics are written.

use super::check::Found;
use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::model::Face;
use crate::run::{Dynamics, Plane, Steps, Track};
use crate::scenario::System;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

/// A dynamics whose runs can be saved.
pub trait Saved: Dynamics<f64> {
    /// A flight but for its start.
    type Numbers: Serialize + DeserializeOwned;
    /// A ball's last flight, and what goes with it.
    type Entry: Serialize + DeserializeOwned;

    /// What is written of a flight.
    fn numbers_of(flight: &Self::Flight) -> Self::Numbers;

    /// The flight of which that was written.
    fn flight_of(start: f64, numbers: &Self::Numbers) -> Self::Flight;

    /// A number of a flight that is not finite, or else one that is.
    fn worst_of(numbers: &Self::Numbers) -> f64;

    /// What is written of a ball.
    fn entry_of(ball: &(Self::Flight, Self::Track)) -> Self::Entry;

    /// The ball of which that was written.
    fn ball_of(entry: &Self::Entry) -> (Self::Flight, Self::Track);

    /// The numbers of a ball that must be finite, each with its key.
    fn finite_keys(entry: &Self::Entry) -> Vec<(&'static str, f64)>;

    /// Refuses a ball that does not fit the system.
    fn check_entry(entry: &Self::Entry, place: &str, system: &Self::System) -> Found;

    /// Whether a ball is at rest for ever.
    fn is_rest(flight: &Self::Flight, system: &Self::System) -> bool;

    /// The steps of a run that has some, put together from the file.
    fn steps_of(steps: Steps<f64>) -> Option<Self::Steps>;
}

/// A disc as it is written.
#[derive(Serialize, Deserialize)]
pub struct DiscEntry {
    start: f64,
    /// Position, velocity, acceleration.
    state: [f64; 6],
    changes: u32,
    #[serde(default, skip_serializing_if = "is_at_home")]
    image: [i32; 2],
    held_by: [Option<u32>; 2],
    last_cushion: Option<u32>,
    arrival: [f64; 2],
    last_contact: Option<f64>,
    burst_start: Option<f64>,
}

fn is_at_home(image: &[i32; 2]) -> bool {
    *image == [0; 2]
}

impl Saved for Plane {
    /// Position, velocity, acceleration.
    type Numbers = [f64; 6];
    type Entry = DiscEntry;

    fn numbers_of(flight: &Flight<f64>) -> [f64; 6] {
        let Flight { position, velocity, acceleration, .. } = flight;
        [position.x, position.y, velocity.x, velocity.y, acceleration.x, acceleration.y]
    }

    fn flight_of(start: f64, &[x, y, vx, vy, ax, ay]: &[f64; 6]) -> Flight<f64> {
        let (position, velocity, acceleration) = (Vec2::new(x, y), Vec2::new(vx, vy), Vec2::new(ax, ay));
        Flight { start, position, velocity, acceleration }
    }

    fn worst_of(numbers: &[f64; 6]) -> f64 {
        super::check::worst(numbers)
    }

    fn entry_of((flight, track): &(Flight<f64>, Track<f64>)) -> DiscEntry {
        let unless_never = |time: f64| (time != f64::NEG_INFINITY).then_some(time);
        DiscEntry {
            start: flight.start,
            state: Self::numbers_of(flight),
            changes: track.changes,
            image: track.image,
            held_by: track.held_by,
            last_cushion: track.last_cushion,
            arrival: [track.arrival.x, track.arrival.y],
            last_contact: unless_never(track.last_contact),
            burst_start: unless_never(track.burst_start),
        }
    }

    fn ball_of(entry: &DiscEntry) -> (Flight<f64>, Track<f64>) {
        let track = Track {
            changes: entry.changes,
            image: entry.image,
            held_by: entry.held_by,
            last_cushion: entry.last_cushion,
            arrival: Vec2::new(entry.arrival[0], entry.arrival[1]),
            last_contact: entry.last_contact.unwrap_or(f64::NEG_INFINITY),
            burst_start: entry.burst_start.unwrap_or(f64::NEG_INFINITY),
        };
        (Self::flight_of(entry.start, &entry.state), track)
    }

    fn finite_keys(entry: &DiscEntry) -> Vec<(&'static str, f64)> {
        vec![
            ("start", entry.start),
            ("state", super::check::worst(&entry.state)),
            ("arrival", super::check::worst(&entry.arrival)),
            ("last_contact", entry.last_contact.unwrap_or(0.0)),
            ("burst_start", entry.burst_start.unwrap_or(0.0)),
        ]
    }

    fn check_entry(entry: &DiscEntry, place: &str, system: &System<f64>) -> Found {
        let faces = &system.faces.all;
        if let [None, Some(_)] = entry.held_by {
            return Err(format!("{place}.held_by: the second cushion without a first"));
        }
        for cushion in entry.held_by.iter().flatten() {
            match faces.get(*cushion as usize) {
                Some(Face::Line(_)) => {}
                Some(Face::Round(_)) => {
                    return Err(format!("{place}.held_by: a cushion that is not straight"));
                }
                None => return Err(format!("{place}.held_by: a cushion that the scenario does not have")),
            }
        }
        if entry.last_cushion.is_some_and(|cushion| cushion as usize >= faces.len()) {
            return Err(format!("{place}.last_cushion: a cushion that the scenario does not have"));
        }
        Ok(())
    }

    fn is_rest(flight: &Flight<f64>, system: &System<f64>) -> bool {
        flight.is_rest_within(system.tolerance.table_size(), crate::scenario::LARGEST)
    }

    fn steps_of(steps: Steps<f64>) -> Option<Steps<f64>> {
        Some(steps)
    }
}
