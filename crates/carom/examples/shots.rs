//! Plays many random shots and holds each to what no run may break.
//!
//! `cargo run --release --example shots -- [COUNT] [SEED]`; `make campaign` runs a million. Shot k of a seed is the same
//! whatever the count, and a shot that breaks something is printed as a scenario to replay it.

// A program that prints what it found; its own random numbers need not have the same bits everywhere.
#![allow(clippy::print_stdout, clippy::expect_used, clippy::disallowed_methods)]

use carom::flight::{Motion, SphereState};
use carom::model::Table;
use carom::run::{OnCloth, Run, SimulationError};
use carom::scenario::{ClothSystem, Scenario, ScenarioError};
use carom::simulate::simulate_until;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

const PRESETS: [&str; 9] = [
    "pool_9ft",
    "pool_8ft",
    "pool_8ft_home",
    "pool_7ft",
    "snooker_12ft",
    "carom_10ft",
    "english_pool",
    "pooltool_7ft",
    "pooltool_snooker",
];
const GAMES: [&str; 5] = ["eight_ball", "nine_ball", "ten_ball", "straight_pool", "english_pool"];

/// A shot is rolled anew if its balls overlap; more often than this it is given up.
const TRIES: u64 = 200;

struct Random(u64);

impl Random {
    fn new(seed: u64, shot: u64, attempt: u64) -> Self {
        let mut random = Self(seed ^ shot.wrapping_mul(0xD134_2543_DE82_EF95) ^ attempt.rotate_left(48));
        random.next();
        random
    }

    /// Steele, Lea and Flood's SplitMix64.
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 * 2.0_f64.powi(-53)
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    fn one_of<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[(self.next() % items.len() as u64) as usize]
    }
}

/// What was found in all shots.
#[derive(Default)]
struct Tally {
    statuses: BTreeMap<&'static str, u64>,
    events: u64,
    most_events: u64,
    clusters: u64,
    forced: u64,
    deepest_overlap: f64,
    energy_gain: f64,
    energy_drift: f64,
    off_table: u64,
    pocketed: u64,
    rerolled: u64,
    broken: u64,
}

fn main() {
    let mut arguments = std::env::args().skip(1).map(|text| text.parse::<u64>());
    let mut argument = |default| arguments.next().map_or(default, |value| value.expect("a whole number"));
    let (count, seed) = (argument(10_000), argument(1));
    let (next, tally, started) = (AtomicU64::new(0), Mutex::new(Tally::default()), Instant::now());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let shot = next.fetch_add(1, Ordering::Relaxed);
                    if shot >= count {
                        break;
                    }
                    play(seed, shot, &tally);
                }
            });
        }
    });
    let tally = tally.into_inner().expect("no thread panicked");
    report(&tally, count, seed, started.elapsed().as_secs_f64(), threads);
    std::process::exit(i32::from(tally.broken > 0));
}

fn report(tally: &Tally, count: u64, seed: u64, seconds: f64, threads: usize) {
    println!("shots               {count} (seed {seed})");
    for (status, number) in &tally.statuses {
        println!("  {status:<18}{number}");
    }
    println!("broken              {}", tally.broken);
    println!("rolled anew         {} (their balls overlapped)", tally.rerolled);
    println!(
        "events              {} ({:.1} a shot, {} at most)",
        tally.events,
        tally.events as f64 / count as f64,
        tally.most_events
    );
    println!(
        "clusters            {} ({} ended by a last pass without restitution)",
        tally.clusters, tally.forced
    );
    println!("pocketed            {}", tally.pocketed);
    println!("off the table       {}", tally.off_table);
    println!("deepest overlap     {:.2e} of a radius", tally.deepest_overlap);
    println!("largest energy gain {:.2e} of the shot's energy", tally.energy_gain);
    println!("largest drift       {:.2e} of the shot's energy", tally.energy_drift);
    println!("time                {seconds:.1} s on {threads} threads");
}

fn play(seed: u64, shot: u64, tally: &Mutex<Tally>) {
    for attempt in 0..TRIES {
        let mut random = Random::new(seed, shot, attempt);
        let value = random_shot(&mut random);
        let Ok(scenario) = checked(&value) else {
            tally.lock().expect("no thread panicked").rerolled += 1;
            continue;
        };
        let outcome = simulate_until::<OnCloth>(&scenario, None, &mut || false);
        let broken = note(&outcome, &mut tally.lock().expect("no thread panicked"));
        if let Some(what) = broken {
            println!("shot {shot}: {what}\n{value}");
        }
        return;
    }
    println!("shot {shot}: no placement found in {TRIES} tries");
    tally.lock().expect("no thread panicked").broken += 1;
}

/// The scenario, if its balls do not overlap; any other problem is the campaign's own.
fn checked(value: &Value) -> Result<Scenario, ScenarioError> {
    let scenario = Scenario::from_json(&value.to_string());
    if let Err(error) = &scenario {
        let is_placement = error.problems.iter().all(|problem| {
            ["overlaps", "outside", "reaches past", "lies over"]
                .iter()
                .any(|word| problem.message.contains(word))
        });
        assert!(is_placement, "{error}\n{value}");
    }
    scenario
}

/// Notes what came of a shot, and what it broke.
fn note(outcome: &Result<Run<f64, OnCloth>, SimulationError>, tally: &mut Tally) -> Option<String> {
    let run = match outcome {
        Ok(run) => run,
        Err(error) => {
            tally.broken += 1;
            return Some(error.to_string());
        }
    };
    let found = &run.diagnostics;
    let events = found.total_events();
    let energy = found.initial_energy.max(1e-6);
    let radius = run.system.spheres.iter().map(|sphere| sphere.radius).fold(f64::INFINITY, f64::min);
    *tally.statuses.entry(run.status.name()).or_default() += 1;
    tally.events += events;
    tally.most_events = tally.most_events.max(events);
    tally.clusters += found.clusters;
    tally.forced += found.forced_clusters;
    tally.deepest_overlap = tally.deepest_overlap.max(found.deepest_overlap / radius);
    tally.energy_gain = tally.energy_gain.max(found.energy_gain / energy);
    tally.energy_drift = tally.energy_drift.max(found.energy_drift / energy);
    let states = run.final_state();
    tally.pocketed += states.iter().filter(|state| state.motion == Motion::Pocketed).count() as u64;
    tally.off_table += states.iter().filter(|state| state.motion == Motion::OffTable).count() as u64;
    let broken = broken(run, &states, radius, energy);
    tally.broken += u64::from(broken.is_some());
    broken
}

fn broken(run: &Run<f64, OnCloth>, states: &[SphereState<f64>], radius: f64, energy: f64) -> Option<String> {
    let found = &run.diagnostics;
    if !["at_rest", "miscue"].contains(&run.status.name()) {
        return Some(format!("status {}", run.status.name()));
    }
    if found.deepest_overlap > 1e-9 * radius {
        return Some(format!("overlap of {:e} radii", found.deepest_overlap / radius));
    }
    if found.energy_gain > 1e-12 * energy {
        return Some(format!("energy rose by {:e} of all", found.energy_gain / energy));
    }
    if run.digest().is_none() {
        return Some("a number is none".to_owned());
    }
    let system = &run.system;
    let gone = (0..states.len()).find(|&ball| {
        let state = &states[ball];
        let size = system.tolerance.of(radius).max(1e-9 * radius);
        !state.motion.is_out() && is_outside(system, state, size)
    });
    gone.map(|ball| format!("ball {} lies outside the table", system.ball_ids[ball]))
}

/// Whether a ball's centre lies behind a straight cushion whose span it is in, deeper than a tolerance.
fn is_outside(system: &ClothSystem<f64>, state: &SphereState<f64>, tolerance: f64) -> bool {
    let place = state.position.plan();
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for face in &system.faces {
        if let carom::model::Face::Line(line) = face {
            for end in [line.start, line.start + line.along * line.length] {
                low = [low[0].min(end.x), low[1].min(end.y)];
                high = [high[0].max(end.x), high[1].max(end.y)];
            }
        }
    }
    place.x < low[0] - tolerance
        || place.x > high[0] + tolerance
        || place.y < low[1] - tolerance
        || place.y > high[1] + tolerance
}

/// A shot on a table of one of the presets: a rack, or balls strewn about, some of them frozen.
fn random_shot(random: &mut Random) -> Value {
    let preset = *random.one_of(&PRESETS);
    let mut value = json!({ "table": { "preset": preset } });
    if random.chance(0.4) && preset != "carom_10ft" {
        let game = if preset.contains("snooker") { "snooker" } else { random.one_of(&GAMES) };
        let spacing = if random.chance(0.5) { 0.0 } else { random.within(0.0, 2e-3) };
        value["rack"] = json!({ "game": game, "seed": random.next() >> 12, "spacing": spacing });
        if spacing > 0.0 && random.chance(0.5) {
            value["rack"]["jitter"] = json!(spacing * 0.5);
        }
    } else {
        value["balls"] = strewn(random, preset);
    }
    random_laws(random, &mut value);
    value["shot"] = strike(random, if value["rack"]["game"] == "snooker" { "white" } else { "cue" });
    value
}

fn random_laws(random: &mut Random, value: &mut Value) {
    let normal = random.within(0.0, 1.0);
    let ball_ball = [
        json!({ "law": "elastic" }),
        json!({ "law": "restitution", "normal": normal }),
        json!({ "law": "frictional", "normal": random.within(0.8, 1.0) }),
        json!({ "law": "frictional", "normal": normal, "friction": random.within(0.0, 0.3) }),
        json!({ "law": "mathavan_2014", "normal": random.within(0.8, 1.0), "friction": 0.05 }),
    ];
    let (normal, friction) = (random.within(0.5, 0.98), random.within(0.0, 0.4));
    let ball_cushion = [
        json!({ "law": "elastic" }),
        json!({ "law": "restitution", "normal": normal, "tangential": random.within(0.5, 1.0) }),
        json!({ "law": "frictional", "normal": normal, "friction": friction }),
        json!({ "law": "han_2005", "normal": normal, "friction": friction }),
        json!({ "law": "mathavan_2010", "normal": normal, "friction": friction }),
        json!({ "law": "stronge_compliant", "normal": normal, "friction": friction }),
    ];
    if random.chance(0.7) {
        value["physics"] = json!({
            "ball_ball": random.one_of(&ball_ball),
            "ball_cushion": random.one_of(&ball_cushion),
            "cluster": random.one_of(&["hertz", "hertz", "hertz", "reflections", "pairwise"]),
        });
    }
}

fn strike(random: &mut Random, cue_ball: &str) -> Value {
    let (offset, angle) = (0.54 * random.unit().sqrt(), random.within(0.0, 360.0).to_radians());
    let elevation = if random.chance(0.3) { random.within(0.0, 80.0) } else { random.within(0.0, 6.0) };
    json!({
        "cue_ball": cue_ball,
        "V0": if random.chance(0.1) { random.within(0.0, 0.3) } else { random.within(0.3, 8.0) },
        "phi_deg": if random.chance(0.2) { 90.0 } else { random.within(0.0, 360.0) },
        "theta_deg": elevation,
        "a": offset * angle.cos(),
        "b": offset * angle.sin(),
    })
}

/// Up to ten balls: anywhere, frozen to an earlier one, or frozen to a cushion.
fn strewn(random: &mut Random, preset: &str) -> Value {
    let (table, radius, reach) = measures(preset);
    let (width, length) = (table.bounds.max.x, table.bounds.max.y);
    let mut places: Vec<[f64; 2]> = Vec::new();
    for _ in 0..=random.next() % 10 {
        let anywhere = [random.within(radius, width - radius), random.within(radius, length - radius)];
        let place = match places.last() {
            Some(&[x, y]) if random.chance(0.35) => {
                let angle = if random.chance(0.5) {
                    60.0 * (random.next() % 6) as f64
                } else {
                    random.within(0.0, 360.0)
                };
                [x + 2.0 * radius * angle.to_radians().cos(), y + 2.0 * radius * angle.to_radians().sin()]
            }
            _ if random.chance(0.15) => [reach, anywhere[1]],
            _ if random.chance(0.1) => [anywhere[0], length - reach],
            _ => anywhere,
        };
        places.push(place);
    }
    let id = |k: usize| if k == 0 { "cue".to_owned() } else { k.to_string() };
    places.iter().enumerate().map(|(k, place)| json!({ "id": id(k), "position": place })).collect()
}

/// The table of a preset, its balls' radius, and the distance at which they touch a cushion.
fn measures(preset: &str) -> (Table<f64>, f64, f64) {
    let value = json!({
        "table": { "preset": preset },
        "balls": [{ "id": "cue", "position": [0.5, 0.5] }],
    });
    let scenario = Scenario::from_json(&value.to_string()).expect("a ball on a table");
    let system = ClothSystem::<f64>::new(&scenario);
    let table = scenario.expanded().table.layout(&mut |_, value| value);
    (table, system.spheres[0].radius, system.noses[0].reach)
}
