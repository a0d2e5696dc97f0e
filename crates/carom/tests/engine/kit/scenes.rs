//! Tables, and random balls on them.

use super::random::Random;
use super::room::Room;
use carom::scenario::Scenario;
use serde_json::{Value, json};

/// A ball to put on a table.
#[derive(Clone, Debug)]
pub struct Ball {
    pub radius: f64,
    pub mass: f64,
    pub position: [f64; 2],
    pub velocity: [f64; 2],
}

/// A ball of unit mass.
pub fn ball(radius: f64, position: [f64; 2], velocity: [f64; 2]) -> Ball {
    Ball { radius, mass: 1.0, position, velocity }
}

/// A checked scenario; ball k is named `k`.
pub fn scenario(table: &Value, physics: &Value, balls: &[Ball]) -> Scenario {
    try_scenario(table, physics, balls).unwrap_or_else(|error| panic!("{error}"))
}

/// The same, or what is wrong with it.
pub fn try_scenario(table: &Value, physics: &Value, balls: &[Ball]) -> Result<Scenario, String> {
    let entry = |(k, ball): (usize, &Ball)| {
        json!({ "id": k.to_string(), "radius": ball.radius, "mass": ball.mass, "position": ball.position,
            "velocity": ball.velocity })
    };
    let balls: Vec<Value> = balls.iter().enumerate().map(entry).collect();
    let text = json!({ "duration": 1e9, "table": table, "physics": physics, "balls": balls }).to_string();
    Scenario::from_json(&text).map_err(|error| error.to_string())
}

pub fn rectangle(width: f64, length: f64) -> Value {
    json!({ "shape": "rectangle", "width": width, "length": length })
}

/// A closed polygon, its corners counter-clockwise.
pub fn polygon(corners: &[[f64; 2]]) -> Value {
    json!({ "shape": "path", "pieces": sides(corners) })
}

/// The sides of a polygon as pieces.
pub fn sides(corners: &[[f64; 2]]) -> Vec<Value> {
    (0..corners.len()).map(|k| json!({ "line": [corners[k], corners[(k + 1) % corners.len()]] })).collect()
}

/// Two half circles of radius `r` joined by lines of length `l`, around the origin.
pub fn stadium(l: f64, r: f64) -> Value {
    let h = l / 2.0;
    json!({ "shape": "path", "pieces": [
        { "line": [[-h, -r], [h, -r]] },
        { "arc": { "center": [h, 0.0], "radius": r, "from_deg": -90.0, "to_deg": 90.0 } },
        { "line": [[h, r], [-h, r]] },
        { "arc": { "center": [-h, 0.0], "radius": r, "from_deg": 90.0, "to_deg": 270.0 } },
    ] })
}

/// A half disc of radius 1 on a stem.
pub fn mushroom() -> Value {
    json!({ "shape": "path", "pieces": [
        { "line": [[-0.4, -1.0], [0.4, -1.0]] },
        { "line": [[0.4, -1.0], [0.4, 0.0]] },
        { "line": [[0.4, 0.0], [1.0, 0.0]] },
        { "arc": { "center": [0.0, 0.0], "radius": 1.0, "from_deg": 0.0, "to_deg": 180.0 } },
        { "line": [[-1.0, 0.0], [-0.4, 0.0]] },
        { "line": [[-0.4, 0.0], [-0.4, -1.0]] },
    ] })
}

pub fn l_shape() -> Value {
    polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]])
}

/// Every kind of table, with its name.
pub fn tables() -> Vec<(&'static str, Value)> {
    let pillar = json!({ "circle": { "center": [0.5, 1.1], "radius": 0.2 } });
    let wedge = json!({ "path": sides(&[[0.5, 0.6], [0.7, 1.2], [1.1, 0.7]]) });
    let divider = json!({ "wall": [[1.0, 0.0], [1.0, 1.5]] });
    let slanted = json!({ "wall": [[0.4, 0.5], [1.3, 1.4]] });
    let with = |mut table: Value, obstacles: Vec<Value>| {
        table["obstacles"] = Value::Array(obstacles);
        table
    };
    let bulging = json!({ "shape": "path", "pieces": [
        { "line": [[0.0, 0.0], [2.0, 0.0]] },
        { "arc": { "center": [2.0, 0.75], "radius": 0.75, "from_deg": 270.0, "to_deg": 90.0 } },
        { "line": [[2.0, 1.5], [0.0, 1.5]] },
        { "arc": { "center": [-0.5, 0.75], "radius": 0.901_387_818_865_997_3,
            "from_deg": 56.309_932_474_020_215, "to_deg": -56.309_932_474_020_215 } },
    ] });
    vec![
        ("rectangle", rectangle(1.3, 2.1)),
        ("circle", json!({ "shape": "circle", "radius": 1.0 })),
        ("l_shape", l_shape()),
        ("stadium", stadium(1.5, 0.7)),
        ("mushroom", mushroom()),
        ("acute", polygon(&[[0.0, 0.0], [2.5, 0.0], [2.0, 1.7]])),
        ("bulging", bulging),
        ("pillar", with(rectangle(2.0, 2.0), vec![pillar])),
        ("wedge", with(rectangle(2.0, 2.0), vec![wedge])),
        ("divider", with(rectangle(2.0, 2.0), vec![divider])),
        ("walls", with(rectangle(2.0, 2.0), vec![slanted])),
        (
            "ring",
            with(
                json!({ "shape": "circle", "radius": 1.0 }),
                vec![json!({ "circle": { "center": [0.3, 0.1], "radius": 0.35 } })],
            ),
        ),
    ]
}

/// Balls at random places with random velocities, at most `count` (as many as fit). `radii` and `masses` are ranges.
pub fn random_balls(
    random: &mut Random,
    table: &Value,
    count: usize,
    radii: [f64; 2],
    masses: [f64; 2],
) -> Vec<Ball> {
    let room = room_of(table);
    let mut balls: Vec<Ball> = Vec::new();
    for _ in 0..200 * count {
        if balls.len() == count {
            break;
        }
        let radius = random.magnitude(radii[0], radii[1]);
        let position = [0, 1].map(|axis| random.between(room.min[axis], room.max[axis]));
        let is_free = |other: &Ball| {
            let [x, y] = [0, 1].map(|axis| other.position[axis] - position[axis]);
            (x * x + y * y).sqrt() > radius + other.radius
        };
        if room.depth(position, radius) < 0.0 && balls.iter().all(is_free) {
            let mass = random.magnitude(masses[0], masses[1]);
            let speed = random.magnitude(0.2, 2.0);
            let velocity = random.direction().map(|c| c * speed);
            balls.push(Ball { radius, mass, position, velocity });
        }
    }
    balls
}

/// Balls on a coarse grid of a 2 x 2 table, with few velocities: exact ties, touching balls, shots into corners.
pub fn grid_balls(random: &mut Random) -> Vec<Ball> {
    let mut balls: Vec<Ball> = Vec::new();
    for _ in 0..60 {
        let position = [0, 1].map(|_| 0.125 * (1 + random.below(15)) as f64);
        let velocity = [0, 1].map(|_| 0.5 * random.below(5) as f64 - 1.0);
        let is_free = |b: &Ball| {
            let [x, y] = [0, 1].map(|axis| b.position[axis] - position[axis]);
            x * x + y * y >= 0.0625
        };
        if balls.len() < 7 && balls.iter().all(is_free) {
            balls.push(ball(0.125, position, velocity));
        }
    }
    balls
}

/// The room that a table is.
pub fn room_of(table: &Value) -> Room {
    let text = json!({ "duration": 1.0, "table": table,
        "balls": [{ "id": "x", "radius": 0.0, "position": [0.0, 0.0] }] });
    let scenario: Scenario = serde_json::from_value(text).unwrap();
    Room::of(&scenario)
}

/// Touching balls of one size at rest in a triangle whose first ball is at `apex`, the others above.
pub fn rack(radius: f64, apex: [f64; 2], rows: usize) -> Vec<Ball> {
    let place = |row: usize, k: usize| {
        let (row, k) = (row as f64, k as f64);
        [apex[0] + radius * (2.0 * k - row), apex[1] + radius * 3.0_f64.sqrt() * row]
    };
    let balls = (0..rows).flat_map(|row| (0..=row).map(move |k| (row, k)));
    balls.map(|(row, k)| ball(radius, place(row, k), [0.0, 0.0])).collect()
}
