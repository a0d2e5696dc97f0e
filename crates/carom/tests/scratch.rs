use carom::engine::{Limits, Simulation, Spheres};
use carom::flight::Cloth;
use carom::geometry::{Vec2, Vec3};
use carom::law::coefficient::*;
use carom::law::{ball_ball, ball_cushion};
use carom::model::*;
use carom::run::{Log, OnCloth};
use carom::scenario::schema::Cluster;
use carom::scenario::{ClothSystem, NoseReach};
use std::sync::Arc;

fn system(balls: &[([f64; 2], [f64; 3], [f64; 3])]) -> ClothSystem<f64> {
    let r = 0.028575;
    let sphere = Sphere {
        radius: r,
        mass: 0.17,
        inverse_mass: 1.0 / 0.17,
        sliding: 0.2,
        rolling: 0.01,
        spin_decay: 10.9,
    };
    let table = Table::new(rectangle(1.0, 2.0), vec![]);
    let faces: Vec<_> = table.cushions().map(|c| Face::of_piece(&c.piece)).collect();
    let g = 9.81;
    let (sin, cos) = (0.27, (1.0f64 - 0.27 * 0.27).sqrt());
    let n = balls.len();
    ClothSystem {
        spheres: vec![sphere; n],
        starts: balls
            .iter()
            .map(|(p, v, w)| {
                (Vec3::new(p[0], p[1], r), Twist { velocity: Vec3::from_f64(*v), spin: Vec3::from_f64(*w) })
            })
            .collect(),
        stroke: None,
        cushion_laws: vec![
            ball_cushion::SphereLaw::Han2005(ball_cushion::Han2005 {
                normal: NormalRestitution::Constant(0.85),
                friction: IncidenceFriction::Constant(0.2)
            });
            faces.len()
        ],
        faces,
        noses: vec![NoseReach { height: r * 1.27, reach: r * cos, sin, cos }; n],
        holes: vec![Hole::new(Vec2::new(0.0, 1.0), 0.05)],
        cloth: Cloth { gravity: g, restitution: 0.5, friction: None, min_hop: 0.005, has_air: true },
        ball_ball: ball_ball::SphereLaw::Frictional(ball_ball::Frictional {
            normal: 0.95,
            friction: SlipFriction::alciatore(),
            cling: 1.0,
        }),
        cluster: Cluster::Reflections,
        kept_speeds: vec![0.005 * (2.0f64 * g * r).sqrt(); n],
        collapse_times: vec![1e-3 * (2.0f64 * r / g).sqrt(); n],
        tolerance: ContactTolerance::new(&table),
        duration: None,
        ball_ids: (0..n).map(|k| k.to_string()).collect(),
        cushion_ids: vec![],
    }
}

#[test]
fn shot() {
    let r = 0.028575;
    let system = Arc::new(system(&[
        ([0.5, 0.5], [0.3, 8.0, 0.0], [0.0, 0.0, 30.0]),
        ([0.5, 1.5], [0.0; 3], [0.0; 3]),
        ([0.5 + 2.0 * r, 1.5], [0.0; 3], [0.0; 3]),
        ([0.3, 1.7], [0.0, 0.0, 2.0], [100.0, 0.0, 0.0]),
    ]));
    let mut log: Log<f64, OnCloth> = Log::new(true, true);
    let limits = Limits { duration: None, collisions: None, max_events: 10000, until: None };
    let mut simulation: Simulation<f64, Spheres<f64>> = Simulation::new(system.clone(), limits, &mut log);
    let status = simulation.run(&mut log);
    for e in &log.events {
        println!(
            "{:.6} {} {} {:?} {:?} {:.4} {:.4} v={:.4}",
            e.time,
            e.kind.name(),
            e.ball_a,
            e.ball_b,
            e.cushion,
            e.point.x,
            e.point.y,
            e.closing_speed
        );
    }
    println!("{status:?} {:?}", simulation.diagnostics());
    for s in simulation.state() {
        println!("{s:?}");
    }
    let t = std::time::Instant::now();
    for _ in 0..1000 {
        simulation.reset(&mut carom::run::Nothing);
        simulation.run(&mut carom::run::Nothing).ok();
    }
    println!("{:?} per run", t.elapsed() / 1000);
}
