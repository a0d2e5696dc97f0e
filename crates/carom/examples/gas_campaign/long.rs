//! Runs so long that what creeps would show: overlaps, energy, momentum, discs that leave, time that goes back.

use crate::audit::{Audit, Clock, Found};
use crate::verdict::{Bounded, Verdict, progress};
use carom::engine::{Limits, Simulation};
use carom::run::Nothing;
use carom::scenario::{Scenario, System};
use std::sync::Arc;

/// Discs of two sizes, and masses from one to three.
const MIXED: &str =
    "sizes.species = [{ fraction = 0.6, diameter = 1 }, { fraction = 0.4, diameter = 1.4, mass = 3 }]";
/// Events from one look at the gas to the next.
const LOOK: f64 = 1e7;
/// A run is looked at so often at least.
const FEWEST_LOOKS: f64 = 10.0;
/// Events between two words on the progress.
const SLICE: u64 = 1_000_000;

struct Case<'a> {
    name: &'a str,
    count: usize,
    /// More keys of the gas.
    more: &'a str,
    events: f64,
    /// By how much energy and momentum may change, as a part of themselves.
    drift: f64,
}

/// 1e9 events among 1e4 discs: equal ones, and mixed ones between two walls.
pub fn billion(scale: f64, verdict: &mut Verdict) {
    let events = 1e9 * scale;
    let channel = format!("periodic = ['x']\n{MIXED}");
    Case { name: "equal", count: 10_000, more: "", events, drift: 1e-12 }.run(verdict);
    Case { name: "mixed", count: 10_000, more: MIXED, events, drift: 1e-10 }.run(verdict);
    Case { name: "mixed, walls", count: 10_000, more: &channel, events, drift: 1e-10 }.run(verdict);
}

/// 1e8 events among 1e6 discs.
pub fn million(scale: f64, verdict: &mut Verdict) {
    let events = 1e8 * scale;
    Case { name: "equal", count: 1_000_000, more: "", events, drift: 1e-12 }.run(verdict);
    Case { name: "mixed", count: 1_000_000, more: MIXED, events, drift: 1e-10 }.run(verdict);
}

/// The worst of two findings.
fn worst(a: Found, b: Found) -> Found {
    // A number that is none stays: it is within no bound.
    let larger = |a: f64, b: f64| if a.abs() >= b.abs() || a.is_nan() { a } else { b };
    Found {
        overlap: if a.overlap >= b.overlap || a.overlap.is_nan() { a.overlap } else { b.overlap },
        energy: larger(a.energy, b.energy),
        momentum: larger(a.momentum, b.momentum),
        lost: a.lost.max(b.lost),
    }
}

impl Case<'_> {
    fn simulation(&self) -> Simulation<f64> {
        let text =
            format!("collisions = 1\n[gas]\nn = {}\npacking_fraction = 0.5\n{}", self.count, self.more);
        let scenario = Scenario::from_toml(&text).expect("a gas of the campaign's own");
        let limits = Limits { duration: None, collisions: None, max_events: u64::MAX, until: None };
        Simulation::new(Arc::new(System::new(&scenario)), limits, &mut Nothing)
    }

    fn run(&self, verdict: &mut Verdict) {
        let name = format!("{} discs, {}", self.count, self.name);
        progress(&name, 0.0);
        let mut simulation = self.simulation();
        let audit = Audit::new(&simulation);
        let mut found = audit.check(&simulation);
        let mut clock = Clock::default();
        let look = LOOK.min(self.events / FEWEST_LOOKS);
        let (mut done, mut looks) = (0.0, 0.0);
        while done < self.events {
            while done < look * (looks + 1.0) {
                let steps = SLICE.min((look * (looks + 1.0) - done).ceil() as u64);
                if let Err(error) = simulation.advance(steps, &mut clock) {
                    return verdict.failure(&name, &error.to_string());
                }
                done = simulation.diagnostics().total_events() as f64;
                progress(&name, done / self.events);
            }
            looks += 1.0;
            found = worst(found, audit.check(&simulation));
        }
        let own = simulation.diagnostics();
        let smallest = simulation.system().discs.iter().map(|disc| disc.radius).fold(f64::INFINITY, f64::min);
        verdict.line(
            &format!("{name}  {done:.1e} events, {looks} looks"),
            &[
                Bounded { name: "overlap", value: found.overlap.max(0.0), bound: 1e-9 },
                Bounded { name: "at events", value: own.deepest_overlap / smallest, bound: 1e-9 },
                Bounded { name: "energy", value: found.energy, bound: self.drift },
                Bounded { name: "momentum", value: found.momentum, bound: self.drift },
                Bounded { name: "lost", value: found.lost as f64, bound: 0.0 },
                Bounded { name: "time back", value: clock.backwards as f64, bound: 0.0 },
            ],
        );
    }
}
