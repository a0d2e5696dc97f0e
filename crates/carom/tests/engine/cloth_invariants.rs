//! A table turned, in the mirror or scaled gives the turned, mirrored and scaled run, to round-off and its growth.

use crate::kit::cloth::{ClothRun, RADIUS, bits_of, on_table, run};
use crate::kit::random::Random;
use crate::kit::scenes::polygon;
use carom::geometry::Vec3;
use carom::run::Kind;
use serde_json::{Value, json};

/// Where the pocket is.
const HOLE: [f64; 2] = [0.2, 0.3];

/// A motion of the plane: a turn, after a mirror on the y axis or none.
#[derive(Clone, Copy)]
struct Image {
    angle: f64,
    mirrored: bool,
}

impl Image {
    fn of(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let x = if self.mirrored { -x } else { x };
        let (c, s) = (libm::cos(self.angle), libm::sin(self.angle));
        [c * x - s * y, s * x + c * y]
    }

    /// Of a spin: a mirror turns the part along its line, and that about the vertical.
    fn of_spin(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [x, y] = if self.mirrored { self.of([-x, -y]) } else { self.of([x, y]) };
        [x, y, if self.mirrored { -z } else { z }]
    }
}

#[derive(Clone)]
struct Mover {
    position: [f64; 2],
    velocity: [f64; 3],
    spin: [f64; 3],
}

/// Balls with all kinds of spin, some thrown up.
fn movers(seed: u64) -> Vec<Mover> {
    let mut random = Random::new(seed);
    let mut balls: Vec<Mover> = Vec::new();
    while balls.len() < 5 {
        let position = [random.between(-0.4, 0.4), random.between(-0.8, 0.8)];
        let is_free = |other: &Mover| {
            libm::hypot(other.position[0] - position[0], other.position[1] - position[1]) > 2.0 * RADIUS
        };
        let is_on_the_cloth = libm::hypot(position[0] - HOLE[0], position[1] - HOLE[1]) > 0.1;
        if !is_on_the_cloth || !balls.iter().all(is_free) {
            continue;
        }
        let rise = if random.below(4) == 0 { random.between(0.0, 0.6) } else { 0.0 };
        let [x, y] = random.direction().map(|c| c * random.between(0.2, 2.0));
        let spin = [0, 1, 2].map(|_| random.between(-60.0, 60.0));
        balls.push(Mover { position, velocity: [x, y, rise], spin });
    }
    balls
}

fn scene(seed: u64, image: Image) -> Value {
    let law = [
        json!({ "ball_ball": { "law": "frictional", "normal": 0.95 },
            "ball_cushion": { "law": "han_2005", "normal": 0.85, "friction": 0.2 } }),
        json!({ "ball_ball": { "law": "mathavan_2014", "normal": 0.9, "friction": 0.05 },
            "ball_cushion": { "law": "mathavan_2010", "normal": 0.9, "friction": 0.14 } }),
        json!({ "ball_cushion": { "law": "stronge_compliant", "normal": 0.8, "friction": 0.2 } }),
        json!({ "ball_cushion": { "law": "frictional", "normal": 0.8, "friction": 0.2 } }),
    ];
    let entry = |(k, ball): (usize, &Mover)| {
        let [x, y, z] = ball.velocity;
        let [vx, vy] = image.of([x, y]);
        json!({ "id": k.to_string(), "position": image.of(ball.position), "velocity": [vx, vy, z],
            "spin": image.of_spin(ball.spin) })
    };
    let balls: Vec<Value> = movers(seed).iter().enumerate().map(entry).collect();
    let mut corners: Vec<[f64; 2]> =
        [[-0.5, -0.9], [0.5, -0.9], [0.5, 0.9], [-0.5, 0.9]].iter().map(|c| image.of(*c)).collect();
    if image.mirrored {
        corners.reverse();
    }
    let mut table = polygon(&corners);
    table["nose_height"] = json!(0.036);
    let pocket = json!({ "id": "hole", "center": image.of(HOLE), "radius": 0.06 });
    table["pockets"] = json!([pocket]);
    on_table(&table, &law[seed as usize % 4], &balls)
}

/// Compares the first events of a run and of its image, while round-off has not grown; says how many.
fn compare(plain: &ClothRun, other: &ClothRun, image: Image, what: &str) -> usize {
    let mut error = 1e-13;
    let mut compared = 0;
    for (a, b) in plain.log.events.iter().zip(&other.log.events) {
        // A meeting of balls makes errors grow by (free path)/(radius) at most; nothing else does much.
        error *= match a.kind {
            Kind::BallBall => 100.0,
            Kind::BallCushion => 4.0,
            _ => 1.5,
        };
        if error > 1e-6 {
            break;
        }
        assert_eq!((a.kind, a.ball_a, a.ball_b), (b.kind, b.ball_a, b.ball_b), "{what}: {a:?} {b:?}");
        let [x, y] = image.of(a.point.to_f64());
        let apart = libm::hypot(x - b.point.x, y - b.point.y);
        assert!((a.time - b.time).abs() < error && apart < error, "{what}: {a:?} {b:?}");
        let [sa, sb] = [plain, other].map(|run| run.state(a.time.min(b.time)).unwrap()[a.ball_a as usize]);
        let spin = image.of_spin(sa.twist.spin.to_f64());
        // The times differ by round-off, so that one of the two may be just before the event: only its image is compared.
        if a.time == b.time {
            let difference = (Vec3::from_f64(spin) - sb.twist.spin).norm() * RADIUS;
            assert!(difference < 100.0 * error, "{what}: {difference:e} {a:?}");
        }
        compared += 1;
    }
    compared
}

#[test]
fn a_table_in_the_mirror_or_turned_gives_the_mirrored_or_turned_run() {
    let images = [
        ("mirrored", Image { angle: 0.0, mirrored: true }),
        ("half a turn", Image { angle: core::f64::consts::PI, mirrored: false }),
        ("turned", Image { angle: 0.7, mirrored: false }),
        ("turned and mirrored", Image { angle: -2.0, mirrored: true }),
    ];
    let same = Image { angle: 0.0, mirrored: false };
    let mut compared = 0;
    for seed in 0..60 {
        let plain = run(&scene(seed, same));
        assert_eq!(bits_of(&plain.final_state()), bits_of(&run(&scene(seed, same)).final_state()));
        for (name, image) in images {
            let other = run(&scene(seed, image));
            compared += compare(&plain, &other, image, &format!("seed {seed}, {name}"));
        }
    }
    assert!(compared > 240 * 6, "{compared}");
}
