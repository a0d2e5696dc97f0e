//! Balls on a cloth: scenes of them, and their runs.

use super::random::Random;
use super::scenes::rectangle;
use carom::flight::{Motion, SphereState};
use carom::geometry::{Vec2, Vec3};
use carom::model::Face;
use carom::run::{Event, Kind, OnCloth, Run};
use carom::scenario::Scenario;
use carom::simulate::simulate_until;
use serde_json::{Value, json};

/// Radius and mass of a pool ball, where a scene says nothing else.
pub const RADIUS: f64 = 0.028_575;
pub const MASS: f64 = 0.170_097;
pub const GRAVITY: f64 = 9.81;

pub type ClothRun = Run<f64, OnCloth>;

/// Balls on a table so large that none meets a cushion.
pub fn wide(physics: &Value, balls: &[Value]) -> Value {
    on_table(&rectangle(40.0, 40.0), physics, balls)
}

/// Balls on a table. The cloth is the default one where `physics` does not say.
pub fn on_table(table: &Value, physics: &Value, balls: &[Value]) -> Value {
    let mut physics = physics.clone();
    if physics["flight"].is_null() {
        physics["flight"] = json!({ "law": "cloth" });
    }
    json!({ "table": table, "physics": physics, "balls": balls,
        "ball_defaults": { "radius": RADIUS, "mass": MASS } })
}

/// A ball at rest.
pub fn still(id: &str, position: [f64; 2]) -> Value {
    json!({ "id": id, "position": position })
}

/// A ball that slides without spin.
pub fn stun(id: &str, position: [f64; 2], velocity: [f64; 2]) -> Value {
    json!({ "id": id, "position": position, "velocity": velocity })
}

/// A ball whose spin times the radius is `rolled`.
pub fn spun(id: &str, position: [f64; 2], velocity: [f64; 2], rolled: [f64; 3]) -> Value {
    json!({ "id": id, "position": position, "velocity": velocity, "spin": rolled.map(|speed| speed / RADIUS) })
}

/// A ball that rolls.
pub fn rolling(id: &str, position: [f64; 2], velocity: [f64; 2]) -> Value {
    let [x, y] = velocity;
    spun(id, position, velocity, [-y, x, 0.0])
}

/// The scenario of a value.
pub fn checked(value: &Value) -> Scenario {
    Scenario::from_json(&value.to_string()).unwrap_or_else(|error| panic!("{error}\n{value}"))
}

/// A whole run.
pub fn run(value: &Value) -> ClothRun {
    run_until(value, None)
}

/// A run up to the first event of a kind.
pub fn run_until(value: &Value, until: Option<Kind>) -> ClothRun {
    simulate_until(&checked(value), until, &mut || false).unwrap_or_else(|error| panic!("{error}\n{value}"))
}

/// The events of a kind.
pub fn events(run: &ClothRun, kind: Kind) -> Vec<Event<f64>> {
    run.log.events.iter().filter(|event| event.kind == kind).copied().collect()
}

/// The kinds of the events of a ball, in order.
pub fn kinds_of(run: &ClothRun, ball: u32) -> Vec<Kind> {
    let of_ball = |event: &&Event<f64>| event.ball_a == ball || event.ball_b == Some(ball);
    run.log.events.iter().filter(of_ball).map(|event| event.kind).collect()
}

/// The first event of a kind of a ball.
pub fn first(run: &ClothRun, kind: Kind, ball: u32) -> Event<f64> {
    let found = events(run, kind).into_iter().find(|e| e.ball_a == ball || e.ball_b == Some(ball));
    found.unwrap_or_else(|| panic!("no {} of ball {ball}: {:?}", kind.name(), run.log.events))
}

/// All balls at a time.
pub fn at(run: &ClothRun, time: f64) -> Vec<SphereState<f64>> {
    run.state(time).unwrap()
}

/// The bits of states, with −0 as +0.
pub fn bits_of(states: &[SphereState<f64>]) -> Vec<(u8, [u64; 9])> {
    let numbers = |state: &SphereState<f64>| {
        let Vec3 { x, y, z } = state.position;
        let (v, w) = (state.twist.velocity, state.twist.spin);
        let bits = [x, y, z, v.x, v.y, v.z, w.x, w.y, w.z].map(|number| (number + 0.0).to_bits());
        (state.motion as u8, bits)
    };
    states.iter().map(numbers).collect()
}

/// Kinetic energy and that of height.
pub fn energy(run: &ClothRun, time: f64) -> f64 {
    run.energy(time).unwrap() + run.potential_energy(time).unwrap()
}

/// The angle between two directions in degrees.
pub fn between(a: Vec2<f64>, b: Vec2<f64>) -> f64 {
    libm::atan2(a.cross(b), a.dot(b)).to_degrees()
}

/// The times at which flights begin and end, and some between them.
pub fn sampled_times(run: &ClothRun, per_gap: usize) -> Vec<f64> {
    let mut ends: Vec<f64> = run.log.events.iter().map(|event| event.time).collect();
    ends.push(0.0);
    ends.push(run.end_time);
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    let mut times = Vec::new();
    for gap in ends.windows(2) {
        times.extend((0..per_gap).map(|k| gap[0] + (gap[1] - gap[0]) * k as f64 / per_gap as f64));
    }
    times.push(run.end_time);
    times
}

/// A shot of random laws at balls strewn over a table without pockets, or over one with them.
pub fn strewn_shot(seed: u64) -> Value {
    for attempt in 0.. {
        let mut random = Random::new(seed.wrapping_mul(1000) + attempt);
        let value = any_shot(&mut random);
        if Scenario::from_json(&value.to_string()).is_ok() {
            return value;
        }
    }
    panic!("some placement has no overlap")
}

fn any_shot(random: &mut Random) -> Value {
    let tables = [json!({ "preset": "pool_7ft" }), json!({ "preset": "carom_10ft" }), rectangle(0.9, 1.2)];
    let table = random.choose(&tables).clone();
    let size = if table["preset"].is_null() { [0.9, 1.2] } else { [0.9, 1.8] };
    let place = |random: &mut Random| [0, 1].map(|axis| random.between(0.05, size[axis] - 0.05));
    let mut places = vec![place(random)];
    for _ in 0..random.below(6) {
        let near = places[random.below(places.len())];
        let [x, y] = random.direction();
        let at = if random.below(3) == 0 {
            [near[0] + 2.0 * RADIUS * x, near[1] + 2.0 * RADIUS * y]
        } else {
            place(random)
        };
        places.push(at);
    }
    let id = |k: usize| if k == 0 { "cue".to_owned() } else { k.to_string() };
    let balls: Vec<Value> = places.iter().enumerate().map(|(k, &place)| still(&id(k), place)).collect();
    let normal = random.between(0.3, 1.0);
    let ball_ball = [
        json!({ "law": "elastic" }),
        json!({ "law": "frictional", "normal": normal }),
        json!({ "law": "mathavan_2014", "normal": 0.9, "friction": 0.05 }),
    ];
    let (normal, friction) = (random.between(0.5, 0.98), random.between(0.0, 0.4));
    let ball_cushion = [
        json!({ "law": "restitution", "normal": normal, "tangential": 0.9 }),
        json!({ "law": "han_2005", "normal": normal, "friction": friction }),
        json!({ "law": "mathavan_2010", "normal": normal, "friction": friction }),
        json!({ "law": "stronge_compliant", "normal": normal, "friction": friction }),
    ];
    let physics =
        json!({ "ball_ball": random.choose(&ball_ball), "ball_cushion": random.choose(&ball_cushion) });
    let mut value = on_table(&table, &physics, &balls);
    let [a, b] = random.direction().map(|c| 0.35 * c);
    let theta = if random.below(3) == 0 { random.between(10.0, 70.0) } else { 0.0 };
    value["shot"] = json!({ "V0": random.between(0.2, 5.0), "phi_deg": random.between(0.0, 360.0),
        "theta_deg": theta, "a": a, "b": b });
    value
}

/// The deepest overlap of any two balls, and of any ball on the cloth with a cushion, at many times of a run.
///
/// Places are computed from the flights as they are logged, and distances as the tests see them.
pub fn deepest_overlap(run: &ClothRun, per_gap: usize) -> f64 {
    let mut deepest = f64::NEG_INFINITY;
    for time in sampled_times(run, per_gap) {
        let states = at(run, time);
        let in_play = |ball: &usize| !states[*ball].motion.is_out();
        for a in (0..states.len()).filter(in_play) {
            for b in (0..a).filter(in_play) {
                let [one, two] = [a, b].map(|ball| states[ball].position);
                let radii = run.system.spheres[a].radius + run.system.spheres[b].radius;
                deepest = deepest.max(radii - (one - two).norm());
            }
            if states[a].motion != Motion::Airborne {
                let place = states[a].position.plan();
                let faces = run.system.faces.iter();
                deepest = faces
                    .map(|face| run.system.noses[a].reach - distance(face, place))
                    .fold(deepest, f64::max);
            }
        }
    }
    deepest
}

/// The distance of a place from a cushion; behind one it is none of it.
fn distance(face: &Face<f64>, place: Vec2<f64>) -> f64 {
    match face {
        Face::Line(line) => {
            let from = place - line.start;
            let foot = from.dot(line.along).clamp(0.0, line.length);
            let away = (from - line.along * foot).norm();
            if from.dot(line.along.left()) < -RADIUS { f64::INFINITY } else { away }
        }
        Face::Round(round) => {
            let from = place - round.arc.center;
            if round.arc.spans(from, 0.0) { (from.norm() - round.arc.radius).abs() } else { f64::INFINITY }
        }
    }
}

/// A whole run of a checked scenario.
pub fn played(scenario: &Scenario) -> ClothRun {
    simulate_until(scenario, None, &mut || false).unwrap_or_else(|error| panic!("{error}"))
}

/// A table of 20 × 20 around the origin with a cloth, and these balls of pool.
pub fn scene(balls: &Value) -> Value {
    let corners = [[-10, -10], [10, -10], [10, 10], [-10, 10]];
    let pieces: Vec<_> = (0..4).map(|k| json!({ "line": [corners[k], corners[(k + 1) % 4]] })).collect();
    json!({
        "table": { "shape": "path", "pieces": pieces },
        "physics": { "flight": { "law": "cloth" } },
        "ball_defaults": { "radius": RADIUS, "mass": 0.170_097 },
        "balls": balls,
    })
}

/// A ball of that name and place, with more keys or other ones.
pub fn ball(id: &str, position: [f64; 2], keys: &Value) -> Value {
    let mut ball = json!({ "id": id, "position": position });
    for (key, value) in keys.as_object().unwrap() {
        ball[key] = value.clone();
    }
    ball
}

/// The kinds of all events.
pub fn only(run: &ClothRun) -> Vec<Kind> {
    run.log.events.iter().map(|event| event.kind).collect()
}

/// The bits of where all balls end, and how.
pub fn bits(run: &ClothRun) -> Vec<[u64; 9]> {
    let numbers = |state: &SphereState<f64>| {
        let (x, v, w) = (state.position, state.twist.velocity, state.twist.spin);
        [x.x, x.y, x.z, v.x, v.y, v.z, w.x, w.y, w.z].map(|number| (number + 0.0).to_bits())
    };
    run.final_state().iter().map(numbers).collect()
}

/// Asserts that two balls of these radii are never higher than they lie.
pub fn no_higher(run: &ClothRun, a: f64, b: f64) {
    for (ball, flight) in &run.log.flights {
        assert_eq!(flight.height, [a, b][*ball as usize]);
    }
}

/// A shot on a table with pockets: a rack or balls anywhere, with the strike, the laws and the elevation drawn by lot.
pub fn random_shot(seed: u64) -> Value {
    for attempt in 0.. {
        let mut random = Random::new(seed * 1000 + attempt);
        let mut value = json!({ "table": { "preset": "pool_9ft" } });
        if seed.is_multiple_of(3) {
            let spacing = if random.flips() { 0.0 } else { 1e-3 };
            let game = *random.choose(&["eight_ball", "nine_ball"]);
            value["rack"] = json!({ "game": game, "seed": seed, "spacing": spacing });
        } else {
            let place = |random: &mut Random| [random.between(0.05, 1.2), random.between(0.05, 2.4)];
            let mut balls = vec![ball("cue", place(&mut random), &json!({}))];
            for k in 0..1 + random.below(8) {
                balls.push(ball(&k.to_string(), place(&mut random), &json!({})));
            }
            value["balls"] = json!(balls);
        }
        let cluster = *random.choose(&["hertz", "hertz", "reflections", "pairwise"]);
        value["physics"] = json!({ "cluster": cluster });
        let (offset, turn) = (0.5 * random.unit(), random.direction());
        let elevation = if random.flips() { random.between(0.0, 5.0) } else { random.between(5.0, 70.0) };
        value["shot"] = json!({
            "cue_ball": "cue", "V0": random.between(0.5, 8.0), "phi_deg": random.between(0.0, 360.0),
            "theta_deg": elevation, "a": offset * turn[0], "b": offset * turn[1],
        });
        if seed.is_multiple_of(3) {
            value["shot"]["phi_deg"] = json!(90);
        }
        if Scenario::from_json(&value.to_string()).is_ok() {
            return value;
        }
    }
    panic!("some placement has no overlap")
}
