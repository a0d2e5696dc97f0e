//! How balls on a cloth are written.

use super::check::{Found, worst};
use super::saved::Saved;
use crate::flight::{Flight, Motion, SphereFlight};
use crate::geometry::{Vec2, Vec3};
use crate::run::{NoSteps, OnCloth, SphereTrack, Steps};
use crate::scenario::ClothSystem;
use serde::{Deserialize, Serialize};

/// A flight but for its start.
#[derive(Serialize, Deserialize)]
pub struct SphereNumbers {
    motion: Motion,
    position: [f64; 3],
    velocity: [f64; 3],
    acceleration: [f64; 3],
    spin: [f64; 3],
    spin_rate: [f64; 3],
    /// How long it lasts; none for ever.
    length: Option<f64>,
}

/// A ball as it is written.
#[derive(Serialize, Deserialize)]
pub struct SphereEntry {
    start: f64,
    #[serde(flatten)]
    flight: SphereNumbers,
    changes: u64,
    /// None if there was none.
    last_contact: Option<f64>,
    burst_start: f64,
    burst: u32,
}

impl SphereNumbers {
    fn worst(&self) -> f64 {
        let rows = [self.position, self.velocity, self.acceleration, self.spin, self.spin_rate];
        worst(&[worst(rows.as_flattened()), self.length.unwrap_or(0.0)])
    }
}

impl Saved for OnCloth {
    type Numbers = SphereNumbers;
    type Entry = SphereEntry;

    fn numbers_of(flight: &SphereFlight<f64>) -> SphereNumbers {
        let SphereFlight { motion, plan, height, rise, lift, spin, spin_rate, length } = flight;
        SphereNumbers {
            motion: *motion,
            position: Vec3::above(plan.position, *height).to_f64(),
            velocity: Vec3::above(plan.velocity, *rise).to_f64(),
            acceleration: Vec3::above(plan.acceleration, *lift).to_f64(),
            spin: spin.to_f64(),
            spin_rate: spin_rate.to_f64(),
            length: (*length < f64::INFINITY).then_some(*length),
        }
    }

    fn flight_of(start: f64, numbers: &SphereNumbers) -> SphereFlight<f64> {
        let [[x, y, height], [vx, vy, rise], [ax, ay, lift]] =
            [numbers.position, numbers.velocity, numbers.acceleration];
        SphereFlight {
            motion: numbers.motion,
            plan: Flight {
                start,
                position: Vec2::new(x, y),
                velocity: Vec2::new(vx, vy),
                acceleration: Vec2::new(ax, ay),
            },
            height,
            rise,
            lift,
            spin: Vec3::from_f64(numbers.spin),
            spin_rate: Vec3::from_f64(numbers.spin_rate),
            length: numbers.length.unwrap_or(f64::INFINITY),
        }
    }

    fn worst_of(numbers: &SphereNumbers) -> f64 {
        numbers.worst()
    }

    fn entry_of((flight, track): &(SphereFlight<f64>, SphereTrack<f64>)) -> SphereEntry {
        let SphereTrack { changes, last_contact, burst_start, burst } = *track;
        let last_contact = (last_contact != f64::NEG_INFINITY).then_some(last_contact);
        let (start, flight) = (flight.start(), Self::numbers_of(flight));
        SphereEntry { start, flight, changes, last_contact, burst_start, burst }
    }

    fn ball_of(entry: &SphereEntry) -> (SphereFlight<f64>, SphereTrack<f64>) {
        let SphereEntry { changes, last_contact, burst_start, burst, .. } = *entry;
        let last_contact = last_contact.unwrap_or(f64::NEG_INFINITY);
        let track = SphereTrack { changes, last_contact, burst_start, burst };
        (Self::flight_of(entry.start, &entry.flight), track)
    }

    fn finite_keys(entry: &SphereEntry) -> Vec<(&'static str, f64)> {
        vec![
            ("start", entry.start),
            ("state", entry.flight.worst()),
            ("last_contact", entry.last_contact.unwrap_or(0.0)),
            ("burst_start", entry.burst_start),
        ]
    }

    fn check_entry(entry: &SphereEntry, place: &str, _: &ClothSystem<f64>) -> Found {
        match entry.flight.length {
            Some(length) if length < 0.0 => {
                Err(format!("{place}.length: must be zero or positive, got {length}"))
            }
            _ => Ok(()),
        }
    }

    fn is_rest(flight: &SphereFlight<f64>, _: &ClothSystem<f64>) -> bool {
        flight.motion == Motion::Resting || flight.motion.is_out()
    }

    fn steps_of(_: Steps<f64>) -> Option<NoSteps> {
        None
    }
}
