//! The audit of the campaign of gases, at a small size; and that it sees what it looks for.

#[path = "../../examples/gas_campaign/audit.rs"]
mod audit;

use audit::{Audit, Clock, Places};
use carom::engine::{Limits, Simulation};
use carom::geometry::Vec2;
use carom::run::Nothing;
use carom::scenario::{Scenario, System};
use std::sync::Arc;

const MIXED: &str =
    "sizes.species = [{ fraction = 0.6, diameter = 1 }, { fraction = 0.4, diameter = 1.4, mass = 3 }]";

fn gas(more: &str) -> Simulation<f64> {
    let text = format!("collisions = 1\n[gas]\nn = 500\npacking_fraction = 0.5\nseed = 4\n{more}");
    let system = System::new(&Scenario::from_toml(&text).unwrap());
    let limits = Limits { duration: None, collisions: None, max_events: u64::MAX, until: None };
    Simulation::new(Arc::new(system), limits, &mut Nothing)
}

#[test]
fn gases_keep_all_that_an_audit_from_outside_asks_for() {
    let walls = format!("periodic = ['x']\n{MIXED}");
    let closed = format!("periodic = []\n{MIXED}");
    for more in ["", MIXED, &walls, &closed] {
        let mut simulation = gas(more);
        let (audit, mut clock) = (Audit::new(&simulation), Clock::default());
        for look in 1..=10 {
            simulation.advance(50_000, &mut clock).unwrap();
            let found = audit.check(&simulation);
            let what = format!("{more}, look {look}: {found:?}");
            assert_eq!((found.lost, clock.backwards), (0, 0), "{what}");
            assert!(found.overlap < 1e-9 && found.overlap > -1.0, "{what}");
            // Two thousand events of each disc, each with a rounding of its own.
            assert!(found.energy.abs() < 1e-12 && found.momentum < 1e-13, "{what}");
        }
    }
}

/// A box of 8 × 6 with two discs.
fn overlap(periods: [bool; 2], places: [[f64; 2]; 2], radii: [f64; 2]) -> f64 {
    let places = places.map(|[x, y]| Vec2::new(x, y));
    Places { size: [8.0, 6.0], periods, places: &places, radii: &radii }.deepest_overlap()
}

#[test]
fn an_audit_sees_overlaps_across_cells_sides_and_walls() {
    let both = [true; 2];
    let is = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    is(overlap(both, [[2.9, 3.0], [3.8, 3.0]], [0.5, 0.5]), 0.2);
    is(overlap(both, [[0.2, 3.0], [7.3, 3.0]], [0.5, 0.5]), 0.2);
    is(overlap(both, [[0.2, 5.9], [7.8, 0.2]], [0.25, 0.5]), 1.0);
    is(overlap([false; 2], [[0.6, 3.0], [3.0, 5.6]], [0.5, 0.5]), 0.2);
    is(overlap([true, false], [[0.2, 3.0], [3.0, 0.45]], [0.5, 0.5]), 0.1);
    assert!(overlap(both, [[2.0, 3.0], [4.0, 3.0]], [0.5, 0.5]) <= 0.0);
}
