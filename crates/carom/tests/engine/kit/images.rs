//! A scenario's images: with other numbers for its balls and cushions, and in the mirror.

use super::bits;
use super::random::Random;
use carom::flight::State;
use carom::geometry::{Piece, Segment};
use carom::model::{self, Cushion};
use carom::run::{Event, Run, Status};
use carom::scenario::Scenario;
use carom::scenario::schema::Table;
use carom::simulate::simulate;
use serde_json::{Value, json};

/// A scenario as JSON in which every piece and obstacle has a name of its own, so that it may be moved.
fn named(scenario: &Scenario) -> Value {
    let mut value: Value = serde_json::from_str(&scenario.to_json().unwrap()).unwrap();
    let name = |list: &mut Value, prefix: &str| {
        for (k, item) in list.as_array_mut().into_iter().flatten().enumerate() {
            let id = item.get("id").cloned().unwrap_or_else(|| format!("{prefix}{k}").into());
            item["id"] = id;
            name_path(item);
        }
    };
    let table = value["table"].as_object_mut().unwrap();
    if !matches!(scenario.table, Table::Circle { .. } | Table::Path { .. }) {
        // As a path, so that its cushions can be numbered otherwise and mirrored too.
        let obstacles = table.get("obstacles").cloned().unwrap_or_else(|| json!([]));
        let path = json!({ "shape": "path", "pieces": lines_of(&scenario.table), "obstacles": obstacles });
        *table = path.as_object().unwrap().clone();
    }
    if let Some(pieces) = table.get_mut("pieces") {
        name(pieces, "");
    }
    if let Some(obstacles) = table.get_mut("obstacles") {
        name(obstacles, "obstacle");
    }
    value
}

/// The boundary of a table of straight cushions as the pieces of a path.
fn lines_of(table: &Table) -> Vec<Value> {
    let layout: model::Table<f64> = table.layout(&mut |_, value| value);
    let line = |cushion: &Cushion<f64>| match &cushion.piece {
        Piece::Line(Segment { start, end }) => {
            json!({ "id": cushion.id, "line": [start.to_f64(), end.to_f64()] })
        }
        Piece::Arc(_) => panic!("say how this shape is written as a path"),
    };
    layout.outlines[0].cushions.iter().map(line).collect()
}

fn name_path(obstacle: &mut Value) {
    for (k, piece) in obstacle.get_mut("path").and_then(Value::as_array_mut).into_iter().flatten().enumerate()
    {
        if piece.get("id").is_none() {
            piece["id"] = k.to_string().into();
        }
    }
}

/// The same scenario with balls, obstacles and the pieces of paths in another order.
fn renumbered(named: &Value, random: &mut Random) -> Value {
    let mut value = named.clone();
    shuffle(&mut value["balls"], random);
    if let Some(obstacles) = value["table"].get_mut("obstacles") {
        shuffle(obstacles, random);
        for obstacle in obstacles.as_array_mut().unwrap() {
            if let Some(path) = obstacle.get_mut("path") {
                rotate(path, random);
            }
        }
    }
    if let Some(pieces) = value["table"].get_mut("pieces") {
        rotate(pieces, random);
    }
    value
}

fn shuffle(list: &mut Value, random: &mut Random) {
    let items = list.as_array().unwrap();
    *list = random.permutation(items.len()).into_iter().map(|k| items[k].clone()).collect();
}

fn rotate(pieces: &mut Value, random: &mut Random) {
    let pieces = pieces.as_array_mut().unwrap();
    let by = random.below(pieces.len());
    pieces.rotate_left(by);
}

/// Time, kind, names, numbers, and whether it was in a cluster.
type Row = (u64, String, Vec<String>, Vec<u64>, bool);

/// An event without the numbers of its participants: bits and names, the first ball being the one whose name comes first.
fn row(run: &Run<f64>, event: &Event<f64>) -> Row {
    let name = |ball: u32| run.system.ball_ids[ball as usize].clone();
    let mut names = vec![name(event.ball_a)];
    let mut normal = event.normal;
    if let Some(other) = event.ball_b.map(name) {
        if other < names[0] {
            (normal.x, normal.y) = (-normal.x, -normal.y);
            names.insert(0, other);
        } else {
            names.push(other);
        }
    }
    names.extend(event.cushion.map(|cushion| run.system.cushion_ids[cushion as usize].clone()));
    let numbers = [normal.x, normal.y, event.closing_speed, event.impulse];
    let numbers = numbers.map(|number| (number + 0.0).to_bits()).to_vec();
    (event.time.to_bits(), event.kind.name().to_owned(), names, numbers, event.cluster.is_some())
}

/// All events, in order of time and then of names.
fn rows(run: &Run<f64>) -> Vec<Row> {
    let mut rows: Vec<_> = run.log.events.iter().map(|event| row(run, event)).collect();
    rows.sort();
    rows
}

fn run_of(value: &Value) -> Run<f64> {
    let scenario = Scenario::from_json(&value.to_string()).unwrap_or_else(|error| panic!("{error}"));
    simulate(&scenario).unwrap_or_else(|error| panic!("{error}"))
}

/// Asserts that renumbering changes nothing; gives the number of clusters, so that a test can ask for some.
pub fn assert_renumbering_changes_nothing(scenario: &Scenario, random: &mut Random, what: &str) -> u64 {
    let value = named(scenario);
    let run = run_of(&value);
    let other = run_of(&renumbered(&value, random));
    // Cut off by the budget of events, two runs may have made different ones of those that come at one time.
    if run.status != Status::EventLimit {
        assert_eq!((run.status, run.end_time.to_bits()), (other.status, other.end_time.to_bits()), "{what}");
        assert_eq!(rows(&run), rows(&other), "{what}");
        for (name, state) in run.system.ball_ids.iter().zip(run.final_state()) {
            let place = other.system.ball_ids.iter().position(|id| id == name).unwrap();
            assert_eq!(bits(&[state]), bits(&[other.final_state()[place]]), "{what}: ball {name}");
        }
    }
    run.diagnostics.clusters
}

/// The largest distance of two states, the second in units of `length`.
pub fn distance(one: &[State<f64>], two: &[State<f64>], length: f64) -> f64 {
    let apart = |(State { position: a, .. }, State { position: b, .. }): (&State<f64>, &State<f64>)| {
        libm::hypot(a.x - b.x / length, a.y - b.y / length)
    };
    one.iter().zip(two).map(apart).fold(0.0, f64::max)
}

/// A state in the mirror.
pub fn reflect_state(mut state: State<f64>, axis: usize) -> State<f64> {
    for vector in [&mut state.position, &mut state.velocity] {
        let number = if axis == 0 { &mut vector.x } else { &mut vector.y };
        *number = -*number;
    }
    state
}

/// The mirror image in an axis; pieces turn round, and come in the opposite order.
pub fn mirrored(scenario: &Scenario, axis: usize) -> Scenario {
    let mut value = named(scenario);
    let flip = |point: &mut Value| point[axis] = json!(-point[axis].as_f64().unwrap());
    for ball in value["balls"].as_array_mut().unwrap() {
        flip(&mut ball["position"]);
        flip(&mut ball["velocity"]);
    }
    let flip_path = |pieces: &mut Value| {
        let pieces = pieces.as_array_mut().unwrap();
        pieces.reverse();
        for piece in pieces {
            if let Some(line) = piece.get_mut("line") {
                line.as_array_mut().unwrap().reverse();
                line.as_array_mut().unwrap().iter_mut().for_each(flip);
            }
            if let Some(arc) = piece.get_mut("arc") {
                flip(&mut arc["center"]);
                let turn =
                    |degrees: &Value| (if axis == 0 { 180.0 } else { 0.0 }) - degrees.as_f64().unwrap();
                (arc["from_deg"], arc["to_deg"]) =
                    (turn(&arc["to_deg"]).into(), turn(&arc["from_deg"]).into());
            }
        }
    };
    let table = &mut value["table"];
    if let Some(pieces) = table.get_mut("pieces") {
        flip_path(pieces);
    }
    for obstacle in table.get_mut("obstacles").and_then(Value::as_array_mut).into_iter().flatten() {
        if let Some(circle) = obstacle.get_mut("circle") {
            flip(&mut circle["center"]);
        }
        if let Some(wall) = obstacle.get_mut("wall") {
            wall.as_array_mut().unwrap().iter_mut().for_each(flip);
        }
        if let Some(path) = obstacle.get_mut("path") {
            flip_path(path);
        }
    }
    Scenario::from_json(&value.to_string()).unwrap_or_else(|error| panic!("{error}"))
}
