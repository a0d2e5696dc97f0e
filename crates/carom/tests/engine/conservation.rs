//! Over a million events on tables of every kind: nothing overlaps, nobody leaves, energy and momentum are kept, and what
//! a run says about itself is what the tests find by their own means.

use crate::kit::random::Random;
use crate::kit::room::Room;
use crate::kit::scenes::{Ball, ball, random_balls, rectangle, scenario, tables};
use crate::kit::start_endless as start;
use carom::engine::Simulation;
use carom::flight::State;
use carom::run::{Event, Log, Nothing};
use serde_json::{Value, json};

/// What is measured at the event times of a run, from the states alone.
struct Watch {
    room: Room,
    balls: Vec<Ball>,
    field: [f64; 2],
    /// Deepest overlap of two balls, in units of 1e-9 of the smaller radius + 1e-13 of the table.
    overlap: f64,
    /// Deepest reach past a cushion, in the same unit.
    outside: f64,
    /// Greatest rise of the energy from one event to the next.
    rise: f64,
    /// The size of the energy's parts, which its rounding is proportional to.
    scale: f64,
}

impl Watch {
    fn new(room: Room, balls: &[Ball], field: [f64; 2]) -> Self {
        let reach = room.max.iter().chain(&room.min).fold(0.0_f64, |most, c| most.max(c.abs()));
        let parts = |ball: &Ball| {
            let kinetic = 0.5 * (ball.velocity[0] * ball.velocity[0] + ball.velocity[1] * ball.velocity[1]);
            ball.mass * (kinetic + reach * (field[0].abs() + field[1].abs()))
        };
        let scale = balls.iter().map(parts).sum();
        let balls = balls.to_vec();
        Self { room, balls, field, overlap: 0.0, outside: f64::NEG_INFINITY, rise: 0.0, scale }
    }

    fn unit(&self, radius: f64) -> f64 {
        1e-9 * radius + 1e-13 * self.room.size()
    }

    /// All pairs of balls.
    fn look_at_balls(&mut self, states: &[State<f64>]) {
        for (a, here) in states.iter().enumerate() {
            for (b, there) in states.iter().enumerate().skip(a + 1) {
                let [one, other] = [self.balls[a].radius, self.balls[b].radius];
                let (x, y) = (there.position.x - here.position.x, there.position.y - here.position.y);
                let radii = one + other;
                if x * x + y * y < radii * radii {
                    let depth = radii - (x * x + y * y).sqrt();
                    self.overlap = self.overlap.max(depth / self.unit(one.min(other)));
                }
            }
        }
    }

    /// All balls and the whole boundary.
    fn look_at_cushions(&mut self, states: &[State<f64>]) {
        for (k, State { position: place, .. }) in states.iter().enumerate() {
            let radius = self.balls[k].radius;
            let depth = self.room.depth([place.x, place.y], radius);
            self.outside = self.outside.max(depth / self.unit(radius));
        }
    }

    fn energy(&self, states: &[State<f64>]) -> f64 {
        let energy = |(State { position: place, velocity }, ball): (&State<f64>, &Ball)| {
            let kinetic = 0.5 * (velocity.x * velocity.x + velocity.y * velocity.y);
            ball.mass * (kinetic - self.field[0] * place.x - self.field[1] * place.y)
        };
        states.iter().zip(&self.balls).map(energy).sum()
    }
}

/// A run of `steps` steps, watched all the way. Panics where something overlaps or leaves.
fn watched(
    what: &str,
    (table, physics, balls): (&Value, &Value, &[Ball]),
    steps: u64,
) -> (Watch, Simulation<f64>) {
    let scenario = scenario(table, physics, balls);
    let acceleration = &physics["flight"]["acceleration"];
    let field = [0, 1].map(|axis| acceleration[axis].as_f64().unwrap_or(0.0));
    let mut watch = Watch::new(Room::of(&scenario), balls, field);
    let mut simulation = start(&scenario);
    let mut energy = watch.energy(&simulation.state());
    for step in 0..steps {
        if !simulation.step(&mut Nothing).unwrap_or_else(|error| panic!("{what}: {error}")) {
            break;
        }
        let states = simulation.state();
        watch.look_at_balls(&states);
        if step % 4 == 0 {
            watch.look_at_cushions(&states);
        }
        let now = watch.energy(&states);
        watch.rise = watch.rise.max(now - energy);
        energy = now;
    }
    assert!(watch.overlap <= 1.0, "{what}: overlap of {} times what is allowed", watch.overlap);
    assert!(watch.outside <= 1.0, "{what}: a ball reaches out {} times what is allowed", watch.outside);
    assert_diagnostics(what, &watch, &simulation);
    (watch, simulation)
}

/// What the run says about itself agrees with the states.
fn assert_diagnostics(what: &str, watch: &Watch, simulation: &Simulation<f64>) {
    let said = simulation.diagnostics();
    let energy = watch.energy(&simulation.state());
    let events = said.total_events() as f64;
    // Sums of up to 50 terms in two orders, and one rounding an event: 3e-16 of the parts each.
    let tolerance = 3e-16 * watch.scale * (50.0 + events);
    assert!((said.initial_energy - said.energy_loss - energy).abs() < tolerance, "{what}: {said:?}");
    assert!(said.energy_drift < tolerance, "{what}: drift {:e}", said.energy_drift);
    assert!(said.energy_error < 1e-14 * watch.scale, "{what}: {said:?}");
    assert!(said.deepest_overlap < watch.unit(0.1), "{what}: {said:?}");
    assert_eq!((said.corrections, said.forced_clusters), (0, 0), "{what}");
}

/// A random scene: its description, table and balls.
fn scene(seed: u64, masses: [f64; 2]) -> (String, Value, Vec<Ball>, Random) {
    let mut random = Random::new(seed);
    let tables = tables();
    let (name, table) = &tables[seed as usize % tables.len()];
    let count = 2 + random.below(49);
    let balls = random_balls(&mut random, table, count, [0.004, 0.08], masses);
    (format!("seed {seed}: {} balls, {name}", balls.len()), table.clone(), balls, random)
}

const STEPS: u64 = 10_000;
/// Two rounds of all tables.
const SEEDS: u64 = 24;

#[test]
fn equal_elastic_balls_keep_their_energy_over_240_000_events() {
    let mut worst = 0.0_f64;
    for seed in 0..SEEDS {
        let (what, table, balls, _) = scene(seed, [1.0, 1.0]);
        let (_, simulation) = watched(&what, (&table, &json!({}), &balls), STEPS);
        let said = simulation.diagnostics();
        assert_eq!(said.total_events(), STEPS, "{what}");
        worst = worst.max(said.energy_drift / said.initial_energy);
    }
    println!("relative energy drift {worst:e}");
    assert!(worst < 1e-12);
}

#[test]
fn unequal_elastic_balls_keep_their_energy_over_240_000_events() {
    let mut worst = 0.0_f64;
    for seed in 100..100 + SEEDS {
        let (what, table, balls, _) = scene(seed, [0.05, 20.0]);
        let (_, simulation) = watched(&what, (&table, &json!({}), &balls), STEPS);
        let said = simulation.diagnostics();
        worst = worst.max(said.energy_drift / said.initial_energy / said.total_events() as f64);
    }
    println!("relative energy drift per event {worst:e}");
    assert!(worst < 2e-16);
}

#[test]
fn balls_in_a_field_keep_their_whole_energy_over_240_000_events() {
    let mut worst = 0.0_f64;
    for seed in 200..200 + SEEDS {
        let (what, table, balls, mut random) = scene(seed, [0.1, 10.0]);
        let physics = json!({ "flight": { "law": "field", "acceleration": random.direction() } });
        let (watch, simulation) = watched(&what, (&table, &physics, &balls), STEPS);
        let said = simulation.diagnostics();
        worst = worst.max(said.energy_drift / watch.scale / said.total_events() as f64);
    }
    println!("energy drift per event, of the sum of its parts: {worst:e}");
    assert!(worst < 2e-16);
}

#[test]
fn energy_never_rises_where_contacts_take_some_over_240_000_events() {
    for seed in 300..300 + SEEDS {
        let (what, table, balls, mut random) = scene(seed, [0.1, 10.0]);
        let (e, normal, tangential) =
            (random.between(0.9, 1.0), random.between(0.9, 1.0), random.between(0.9, 1.0));
        let physics = json!({
            "ball_ball": { "law": "restitution", "normal": e },
            "ball_cushion": { "law": "restitution", "normal": normal, "tangential": tangential },
        });
        let (watch, simulation) = watched(&what, (&table, &physics, &balls), STEPS);
        let said = simulation.diagnostics();
        // The sum of up to 50 energies has a rounding of a few 1e-16 of itself.
        assert!(watch.rise < 1e-15 * said.initial_energy, "{what}: rise {:e}", watch.rise);
        assert!(said.energy_gain < 1e-15 * said.initial_energy, "{what}: {said:?}");
        assert!(said.energy_loss > 0.0, "{what}");
    }
}

#[test]
fn discs_packed_to_sixty_percent_never_overlap() {
    let mut random = Random::new(7);
    let (across, radius) = (10, 0.5);
    let side = f64::from(across) * 1.144 + 1e-3; // π/4 / 1.144² = 0.60
    let balls: Vec<Ball> = (0..across * across)
        .map(|k| {
            let place = |n: i32| (f64::from(n) + 0.5) * 1.144;
            ball(radius, [place(k % across), place(k / across)], random.direction())
        })
        .collect();
    let (_, simulation) = watched("packed", (&rectangle(side, side), &json!({}), &balls), 60_000);
    let said = simulation.diagnostics();
    assert!(said.energy_drift < 1e-12 * said.initial_energy);
}

#[test]
fn points_and_discs_mix() {
    for seed in 400..412 {
        let (what, table, mut balls, mut random) = scene(seed, [0.1, 10.0]);
        for ball in &mut balls {
            if random.flips() {
                ball.radius = 0.0;
            }
        }
        watched(&what, (&table, &json!({}), &balls), 5_000);
    }
}

#[test]
fn angular_momentum_is_kept_on_a_round_table() {
    for seed in 0..8 {
        let mut random = Random::new(seed);
        let table = json!({ "shape": "circle", "radius": 1.0 });
        let balls = random_balls(&mut random, &table, 12, [0.01, 0.1], [0.1, 10.0]);
        let momentum = |states: &[State<f64>]| -> f64 {
            states.iter().zip(&balls).map(|(s, ball)| ball.mass * s.position.cross(s.velocity)).sum()
        };
        let mut simulation = start(&scenario(&table, &json!({}), &balls));
        let before = momentum(&simulation.state());
        for _ in 0..10_000 {
            simulation.step(&mut Nothing).unwrap();
        }
        let (after, scale) = (momentum(&simulation.state()), simulation.diagnostics().initial_energy);
        // 10 000 contacts, each with a rounding of some 1e-16 of momentum and place.
        assert!((after - before).abs() < 1e-12 * scale, "seed {seed}: {before} → {after}");
    }
}

#[test]
fn events_say_what_happened() {
    let (what, table, balls, _) = scene(3, [0.1, 10.0]);
    let mut simulation = start(&scenario(&table, &json!({}), &balls));
    let mut log = Log::new(true, false);
    let mut before = simulation.state();
    let mut then = 0.0;
    while log.events.len() < 5_000 {
        let seen = log.events.len();
        simulation.step(&mut log).unwrap();
        let (after, now) = (simulation.state(), simulation.time());
        for event in &log.events[seen..] {
            assert_eq!(event.time, now, "{what}");
            assert_event(event, (&before, now - then), &after, &balls);
        }
        (before, then) = (after, now);
    }
    assert_eq!(simulation.diagnostics().total_events(), log.events.len() as u64);
}

/// The row's normal, closing speed, impulse and point are those of the states before and after.
fn assert_event(
    event: &Event<f64>,
    (before, elapsed): (&[State<f64>], f64),
    after: &[State<f64>],
    balls: &[Ball],
) {
    let a = event.ball_a as usize;
    let (normal, place) = (event.normal, after[a].position);
    assert!((normal.x * normal.x + normal.y * normal.y - 1.0).abs() < 1e-15);
    let relative = |states: &[State<f64>]| {
        let other = event
            .ball_b
            .map_or((0.0, 0.0), |b| (states[b as usize].velocity.x, states[b as usize].velocity.y));
        (states[a].velocity.x - other.0) * normal.x + (states[a].velocity.y - other.1) * normal.y
    };
    let sign = if event.ball_b.is_some() { 1.0 } else { -1.0 };
    assert!((relative(before) * sign - event.closing_speed).abs() < 1e-13, "{event:?}");
    assert!(event.closing_speed > 0.0 && event.impulse > 0.0 && elapsed >= 0.0);
    assert!((relative(after) + relative(before)).abs() < 1e-13, "elastic: {event:?}");
    let change = (after[a].velocity.x - before[a].velocity.x) * normal.x
        + (after[a].velocity.y - before[a].velocity.y) * normal.y;
    assert!(
        (change * balls[a].mass * -sign - event.impulse).abs() < 1e-13 * event.impulse.max(1.0),
        "{event:?}"
    );
    let reach = ((event.point.x - place.x).powi(2) + (event.point.y - place.y).powi(2)).sqrt();
    // A difference of squares of lengths up to 3, a few roundings each, over 2 r.
    assert!((reach - balls[a].radius).abs() < 5e-15 / balls[a].radius, "{event:?}");
}
