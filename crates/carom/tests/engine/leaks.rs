//! Nothing passes a wall: thin dividers, joints between pieces, and tables of any size.

use crate::kit::random::Random;
use crate::kit::room::Room;
use crate::kit::scenes::{ball, mushroom, polygon, random_balls, rectangle, scenario, stadium};
use crate::kit::{bundled, start_endless};
use carom::engine::Simulation;
use carom::flight::Flight;
use carom::flight::State;
use carom::geometry::Vec2;
use carom::run::{Event, Log, Nothing, Observer};
use carom::scenario::Scenario;
use serde_json::{Value, json};

/// Watches that no ball's straight path from flight to flight crosses a thin wall.
struct Guard {
    start: Vec2<f64>,
    along: Vec2<f64>,
    length: f64,
    /// Distance from the wall's line within which a ball is on neither side.
    tolerance: f64,
    /// The cushions of the wall's left and right side.
    faces: [u32; 2],
    places: Vec<Option<Vec2<f64>>>,
    /// +1 left of the wall's direction, −1 right of it, 0 beyond its ends.
    sides: Vec<f64>,
    hits: [u64; 2],
    passages: u64,
}

impl Guard {
    fn new(scenario: &Scenario, simulation: &Simulation<f64>, id: &str, wall: [[f64; 2]; 2]) -> Self {
        let [start, end] = wall.map(Vec2::from_f64);
        let ids = &simulation.system().cushion_ids;
        let face = |end: &str| ids.iter().position(|name| *name == format!("{id}.{end}")).unwrap() as u32;
        let mut guard = Self {
            start,
            along: (end - start).unit(),
            length: (end - start).norm(),
            // Places on the table carry round-off of some 1e-16 of its size.
            tolerance: 1e-14 * Room::of(scenario).size(),
            faces: [face("a"), face("b")],
            places: vec![None; simulation.state().len()],
            sides: vec![0.0; simulation.state().len()],
            hits: [0; 2],
            passages: 0,
        };
        for (ball, State { position: place, .. }) in simulation.state().iter().enumerate() {
            guard.visit(ball, *place);
        }
        guard
    }

    /// The ball flew straight to `place`.
    fn visit(&mut self, ball: usize, place: Vec2<f64>) {
        let offset = place - self.start;
        let height = self.along.cross(offset);
        let before = self.places[ball].replace(place);
        if height.abs() <= self.tolerance {
            let reach = self.along.dot(offset);
            if reach < 0.0 || reach > self.length {
                self.sides[ball] = 0.0;
            }
            return;
        }
        let side = if height > 0.0 { 1.0 } else { -1.0 };
        if let Some(before) = before
            && self.sides[ball] * side < 0.0
        {
            let first = self.along.cross(before - self.start);
            let part = first / (first - height);
            let reach = self.along.dot(before + (place - before) * part - self.start);
            let is_beyond = reach < 0.0 || reach > self.length;
            assert!(is_beyond, "ball {ball} crosses the wall at {reach} of {}", self.length);
            self.passages += 1;
        }
        self.sides[ball] = side;
    }
}

impl Observer<f64> for Guard {
    fn event(&mut self, event: &Event<f64>) {
        for (face, side) in [(0, 1.0), (1, -1.0)] {
            if event.cushion == Some(self.faces[face]) {
                assert_eq!(self.sides[event.ball_a as usize], side, "the near face is hit: {event:?}");
                assert_eq!(self.along.cross(event.normal) > 0.0, side > 0.0, "{event:?}");
                self.hits[face] += 1;
            }
        }
    }

    fn flight(&mut self, ball: usize, flight: &Flight<f64>) {
        self.visit(ball, flight.position);
    }
}

/// Guards the wall for that many events; both faces must be hit and the end be passed for the test to mean anything.
fn guard(scenario: &Scenario, id: &str, wall: [[f64; 2]; 2], events: u64) {
    let mut simulation = start_endless(scenario);
    let mut guard = Guard::new(scenario, &simulation, id, wall);
    while simulation.diagnostics().total_events() < events {
        simulation.step(&mut guard).unwrap();
    }
    assert!(guard.hits.iter().all(|hits| *hits > 1000), "faces hit {:?} times", guard.hits);
    assert!(guard.passages > 100, "{} passages around the end", guard.passages);
}

#[test]
fn discs_never_cross_the_divider_of_the_u_shaped_table() {
    guard(&bundled("u_divider"), "divider", [[1.0, 0.0], [1.0, 1.5]], 200_000);
}

#[test]
fn points_never_cross_a_thin_wall() {
    for wall in [[[1.0, 0.0], [1.0, 1.5]], [[0.4, 0.5], [1.3, 1.4]], [[0.3, 1.1], [1.9, 0.7]]] {
        let mut table = rectangle(2.0, 2.0);
        table["obstacles"] = json!([{ "id": "divider", "wall": wall }]);
        let mut random = Random::new(5);
        let mut balls = random_balls(&mut random, &table, 6, [0.01, 0.01], [1.0, 1.0]);
        balls.iter_mut().for_each(|ball| ball.radius = 0.0);
        guard(&scenario(&table, &json!({}), &balls), "divider", wall, 200_000);
    }
}

/// How far outside a point may be found, relative to the table's size: feet are accepted up to 1e-13 past both ends.
const OUTSIDE: f64 = 2e-13;

/// Follows a point for some events and looks where it is at every one of them; the number of events it had.
fn assert_stays(what: &str, table: &Value, place: [f64; 2], velocity: [f64; 2], events: u64) -> u64 {
    let scenario = scenario(table, &json!({}), &[ball(0.0, place, velocity)]);
    let room = Room::of(&scenario);
    let mut simulation = start_endless(&scenario);
    let far = OUTSIDE * room.size();
    while simulation.diagnostics().total_events() < events {
        let before = simulation.diagnostics().total_events();
        simulation.step(&mut Nothing).unwrap();
        let count = simulation.diagnostics().total_events();
        let now = simulation.state()[0].position;
        assert!(count > before, "{what}: at {now:?} after {count} events, and meets nothing any more");
        let depth = room.depth([now.x, now.y], 0.0);
        assert!(depth <= far, "{what}: outside by {depth} at event {count}, {now:?}");
    }
    simulation.diagnostics().total_events()
}

/// A polygon of corners on a circle of radius 1.
fn regular(corners: u32) -> Vec<[f64; 2]> {
    let angle = |k: u32| core::f64::consts::TAU * f64::from(k) / f64::from(corners);
    (0..corners).map(|k| [libm::cos(angle(k)), libm::sin(angle(k))]).collect()
}

/// A square of side 2 whose sides are bent outwards by `bend` in their middles (inwards where that is negative).
fn bent_square(bend: f64) -> Vec<[f64; 2]> {
    let out = 1.0 + bend;
    vec![[-1.0, -1.0], [0.0, -out], [1.0, -1.0], [out, 0.0], [1.0, 1.0], [0.0, out], [-1.0, 1.0], [-out, 0.0]]
}

/// Tables with joints of many kinds, and where their joints are.
fn jointed() -> Vec<(String, Value, Vec<[f64; 2]>)> {
    let ends = |table: &Value| -> Vec<[f64; 2]> {
        let lines = table["pieces"].as_array().unwrap().iter().filter_map(|piece| piece.get("line"));
        lines.flat_map(|line| serde_json::from_value::<[[f64; 2]; 2]>(line.clone()).unwrap()).collect()
    };
    let mut tables = vec![
        ("stadium".to_owned(), stadium(1.5, 0.7), Vec::new()),
        ("mushroom".to_owned(), mushroom(), Vec::new()),
        ("100-gon".to_owned(), polygon(&regular(100)), Vec::new()),
    ];
    for bend in [1e-3, 1e-6, 1e-9, -1e-3, -1e-6, -1e-9] {
        tables.push((format!("bent by {bend}"), polygon(&bent_square(bend)), Vec::new()));
    }
    for (_, table, joints) in &mut tables {
        *joints = ends(table);
    }
    tables
}

#[test]
fn a_point_never_leaks_through_a_joint() {
    for (name, table, _) in jointed() {
        let events = if name.starts_with("bent") { 200_000 } else { 1_000_000 };
        assert_stays(&name, &table, [0.123, 0.045], [0.86, 0.51], events);
    }
}

#[test]
fn a_point_aimed_exactly_at_a_joint_stays_inside() {
    let mut random = Random::new(11);
    for (name, table, joints) in jointed() {
        for joint in joints {
            for shot in 0..60 {
                // Places with few bits, so that the aim has no round-off, and others.
                let grain = if shot % 2 == 0 { 64.0 } else { 1e9 };
                let place = [0, 1].map(|_| (random.between(-0.3, 0.3) * grain).round() / grain);
                let velocity = [joint[0] - place[0], joint[1] - place[1]];
                let what = format!("{name}: from {place:?} to {joint:?}");
                assert_stays(&what, &table, place, velocity, 30);
            }
        }
    }
}

#[test]
fn a_whispering_gallery_keeps_its_angle() {
    for (grazing, radius) in [(0.01, 0.0), (0.1, 0.0), (0.1, 0.2), (1.0, 0.0)] {
        let table = json!({ "shape": "circle", "radius": 1.0 });
        // From the rim, at an angle to it.
        let velocity = [-libm::sin(grazing), libm::cos(grazing)];
        let scenario = scenario(&table, &json!({}), &[ball(radius, [1.0 - radius, 0.0], velocity)]);
        let mut simulation = start_endless(&scenario);
        let mut log = Log::new(true, false);
        while simulation.diagnostics().total_events() < 100_000 {
            assert!(simulation.step(&mut log).unwrap());
        }
        for (k, event) in log.events.iter().enumerate() {
            let angle = libm::asin(event.closing_speed);
            // Round-off of 1e-16 in each of 1e5 chords' distances from the centre adds up to at most 1e-11, and is
            // 1 / sin(0.01) = 100 times that in the angle.
            assert!((angle - grazing).abs() < 1e-9, "bounce {k} at {angle}, not {grazing}");
        }
    }
}
