//! Periodic tables: the same as a plane tiled with copies of the table, which a second, plain computation follows here.

use crate::kit::bits;
use carom::engine::{Limits, Simulation};
use carom::flight::Flight;
use carom::gas::{Amount, Arrangement, Recipe, Sizes, Species, make};
use carom::geometry::Vec2;
use carom::model::Disc;
use carom::run::{Event, Kind, Log, Nothing, Run};
use carom::scenario::{Scenario, System};
use std::collections::VecDeque;
use std::sync::Arc;

/// A gas, perhaps in a field.
struct Scene {
    recipe: Recipe,
    field: Vec2<f64>,
}

impl From<Recipe> for Scene {
    fn from(recipe: Recipe) -> Self {
        Self { recipe, field: Vec2::ZERO }
    }
}

fn system(Scene { recipe, field }: &Scene) -> Arc<System<f64>> {
    let start = make(recipe).unwrap();
    let [width, length] = start.size;
    let axes: Vec<&str> =
        ["x", "y"].into_iter().zip(recipe.periodic).filter(|(_, is)| *is).map(|(axis, _)| axis).collect();
    let text = format!(
        "duration = 1\n[table]\nshape = 'rectangle'\nwidth = {width:?}\nlength = {length:?}\nperiodic = {axes:?}\n\
         [[balls]]\nid = '0'\nradius = 0.5\nposition = [1, 1]"
    );
    let system = System::new(&Scenario::from_toml(&text).unwrap());
    let flight = |(&position, &velocity)| Flight { start: 0.0, position, velocity, acceleration: *field };
    Arc::new(System {
        field: *field,
        discs: start
            .radii
            .iter()
            .zip(&start.masses)
            .map(|(&radius, &mass)| Disc::new(radius, mass))
            .collect(),
        flights: start.positions.iter().zip(&start.velocities).map(flight).collect(),
        collapse_times: vec![1e-9; start.radii.len()],
        ball_ids: (0..start.radii.len()).map(|k| k.to_string()).collect(),
        ..system
    })
}

fn scenes() -> Vec<Scene> {
    let species = |diameter, mass| Species { amount: Amount::Fraction(0.5), diameter, mass };
    let mixed = Sizes::Species(vec![species(0.5, 0.3), species(1.0, 2.0)]);
    let random = |count, packing| Recipe { start: Arrangement::Random, ..Recipe::new(count, packing) };
    let channel = Recipe { periodic: [true, false], ..random(25, 0.3) };
    let pull = |x, y, recipe| Scene { recipe, field: Vec2::new(x, y) };
    vec![
        random(5, 0.05).into(),
        random(9, 0.3).into(),
        random(30, 0.4).into(),
        Recipe { sizes: mixed.clone(), ..random(40, 0.4) }.into(),
        channel.clone().into(),
        Recipe { periodic: [false, true], aspect: Some(2.0), sizes: mixed.clone(), ..random(25, 0.2) }.into(),
        Recipe { aspect: Some(0.25), ..random(40, 0.2) }.into(),
        pull(0.0, -0.3, channel.clone()),
        pull(0.2, -0.1, Recipe { sizes: mixed, ..channel }),
        pull(-0.3, 0.2, random(30, 0.4)),
    ]
}

fn unlimited() -> Limits<f64> {
    Limits { duration: None, collisions: None, max_events: u64::MAX, until: None }
}

/// The time of the first meeting of two discs in the plane, from now on.
fn meeting(away: Vec2<f64>, velocity: Vec2<f64>, radii: f64) -> f64 {
    let (slope, speed) = (away.dot(velocity), velocity.norm_squared());
    let root = slope * slope - speed * (away.norm_squared() - radii * radii);
    if slope < 0.0 && root > 0.0 { ((-slope - root.sqrt()) / speed).max(0.0) } else { f64::INFINITY }
}

/// When something at a distance from a wall comes there, moving and pulled towards it or away.
fn arrival(gap: f64, speed: f64, pull: f64) -> f64 {
    let (gap, square) = (gap.max(0.0), speed * speed + 2.0 * pull * gap.max(0.0));
    if pull > 0.0 {
        (square.sqrt() - speed) / pull
    } else if speed > 0.0 && square >= 0.0 {
        2.0 * gap / (speed + square.sqrt())
    } else {
        f64::INFINITY
    }
}

/// All discs in one list, moved together from event to event; every disc sees every other in each of the images around.
fn tiled_plane(system: &System<f64>, events: usize) -> Vec<(f64, u32, Option<u32>)> {
    let size = [system.bounds.max.x, system.bounds.max.y];
    let (mut now, mut log, pull) = (0.0, Vec::new(), system.field);
    let mut discs: Vec<(Vec2<f64>, Vec2<f64>)> =
        system.flights.iter().map(|flight| (flight.position, flight.velocity)).collect();
    let images = |is_periodic: bool| if is_periodic { -1..=1 } else { 0..=0 };
    while log.len() < events {
        // Who leaves the table comes in again; and nobody goes so far at once that more images would be needed.
        let mut first = (0.2 * size[0].min(size[1]), None, Vec2::ZERO);
        for (a, (place_a, velocity_a)) in discs.iter().enumerate() {
            let radius = system.discs[a].radius;
            for (axis, [place, velocity, pull]) in
                [[place_a.x, velocity_a.x, pull.x], [place_a.y, velocity_a.y, pull.y]].into_iter().enumerate()
            {
                let above = arrival(size[axis] - radius - place, velocity, pull);
                let time = above.min(arrival(place - radius, -velocity, -pull));
                if !system.periodic[axis] && time < first.0 {
                    let normal = if axis == 0 { Vec2::new(1.0, 0.0) } else { Vec2::new(0.0, 1.0) };
                    first = (time, Some((a, None)), normal);
                }
            }
            for (b, (place_b, velocity_b)) in discs.iter().enumerate().skip(a + 1) {
                for x in images(system.periodic[0]) {
                    for y in images(system.periodic[1]) {
                        let shift = Vec2::new(size[0] * f64::from(x), size[1] * f64::from(y));
                        let (away, velocity) = (*place_b + shift - *place_a, *velocity_b - *velocity_a);
                        let time = meeting(away, velocity, radius + system.discs[b].radius);
                        if time < first.0 {
                            first = (time, Some((a, Some(b))), (away + velocity * time).unit());
                        }
                    }
                }
            }
        }
        let (time, who, normal) = first;
        now += time;
        for (position, velocity) in &mut discs {
            *position = *position + *velocity * time + pull * (0.5 * time * time);
            *velocity = *velocity + pull * time;
            for (axis, along) in [&mut position.x, &mut position.y].into_iter().enumerate() {
                if system.periodic[axis] {
                    *along = along.rem_euclid(size[axis]);
                }
            }
        }
        let Some((a, other)) = who else { continue };
        log.push((now, a as u32, other.map(|b| b as u32)));
        match other {
            None => discs[a].1 = discs[a].1 - normal * (2.0 * discs[a].1.dot(normal)),
            Some(b) => {
                let [mass_a, mass_b] = [a, b].map(|k| system.discs[k].mass);
                let speed = (discs[b].1 - discs[a].1).dot(normal);
                let impulse = 2.0 * speed * mass_a * mass_b / (mass_a + mass_b);
                discs[a].1 = discs[a].1 + normal * (impulse / mass_a);
                discs[b].1 = discs[b].1 - normal * (impulse / mass_b);
            }
        }
    }
    log
}

#[test]
fn a_periodic_gas_is_a_plane_tiled_with_its_table() {
    for (k, scene) in scenes().iter().enumerate() {
        let system = system(scene);
        // A collision multiplies what rounding has done by the free path in radii; so few of the dilute gases can be followed.
        let count = if scene.recipe.packing_fraction < 0.25 { 10 } else { 25 };
        let expected = tiled_plane(&system, count);
        let mut simulation: Simulation<f64> = Simulation::new(system, unlimited(), &mut Nothing);
        let mut events: VecDeque<Event<f64>> = VecDeque::new();
        simulation.advance(count as u64, &mut events).unwrap();
        for (number, (event, (time, a, b))) in events.iter().zip(&expected).enumerate() {
            assert_eq!((event.ball_a, event.ball_b), (*a, *b), "recipe {k}, event {number}");
            assert!((event.time - time).abs() < 1e-8 * (1.0 + time), "recipe {k}, event {number}: {time}");
        }
    }
}

#[test]
fn energy_and_momentum_are_kept_and_no_image_is_entered() {
    for (k, scene) in scenes().iter().enumerate() {
        let system = system(scene);
        let momentum = |run: &Run<f64>| run.momentum(run.end_time).unwrap();
        let mut simulation: Simulation<f64> = Simulation::new(system.clone(), unlimited(), &mut Nothing);
        let before = momentum(&simulation.clone().finish(Log::new(false, false)));
        simulation.advance(20_000, &mut Nothing).unwrap();
        let run = simulation.finish(Log::new(false, false));
        let change = momentum(&run) - before;
        let scale = (2.0 * run.diagnostics.initial_energy * run.balls.len() as f64).sqrt();
        for (along, is_periodic) in [change.x, change.y].into_iter().zip(scene.recipe.periodic) {
            assert!(
                !is_periodic || scene.field != Vec2::ZERO || along.abs() < 1e-12 * scale,
                "recipe {k}: {change:?}"
            );
        }
        let found = &run.diagnostics;
        assert!(found.energy_drift < 1e-11 * found.initial_energy, "recipe {k}: {found:?}");
        assert!(found.deepest_overlap < 1e-12, "recipe {k}: {found:?}");
        let states = run.final_state();
        for a in 0..states.len() {
            for b in 0..a {
                let away = states[b].position - states[a].position;
                let size = system.bounds.max;
                let nearest = |along: f64, size: f64, is: bool| {
                    if is { along - size * (along / size).round() } else { along }
                };
                let x = nearest(away.x, size.x, scene.recipe.periodic[0]);
                let y = nearest(away.y, size.y, scene.recipe.periodic[1]);
                let gap = x.hypot(y) - system.discs[a].radius - system.discs[b].radius;
                assert!(gap > -1e-9, "recipe {k}: {a} and {b} by {gap}");
            }
        }
    }
}

#[test]
fn a_run_in_pieces_has_the_bits_of_the_whole() {
    for scene in &scenes() {
        let system = system(scene);
        let whole = {
            let mut log = Log::new(true, true);
            let limits = Limits::duration(30.0);
            let mut simulation: Simulation<f64> = Simulation::new(system.clone(), limits, &mut log);
            simulation.run(&mut log).unwrap();
            simulation.finish(log)
        };
        let part = {
            let limits = Limits::duration(11.3);
            let mut simulation: Simulation<f64> = Simulation::new(system.clone(), limits, &mut Nothing);
            simulation.run(&mut Nothing).unwrap();
            simulation.reset(&mut Nothing);
            simulation.run(&mut Nothing).unwrap();
            simulation.finish(Log::new(false, false))
        };
        let mut simulation: Simulation<f64> = Simulation::resume(&part, Limits::duration(30.0));
        while simulation.step(&mut Nothing).unwrap() {
            simulation.candidates();
        }
        let pieces = simulation.finish(Log::new(false, false));
        assert_eq!(bits(&pieces.final_state()), bits(&whole.final_state()));
        // What the log says of the end is what the end says of itself.
        assert_eq!(bits(&whole.state(30.0).unwrap()), bits(&whole.final_state()));
    }
}

#[test]
fn candidates_are_what_happens_next() {
    for scene in &scenes() {
        let mut simulation: Simulation<f64> = Simulation::new(system(scene), unlimited(), &mut Nothing);
        for _ in 0..50 {
            let first = simulation
                .candidates()
                .into_iter()
                .filter(|next| next.kind.is_some())
                .min_by(|a, b| a.time.total_cmp(&b.time))
                .unwrap();
            let mut events: VecDeque<Event<f64>> = VecDeque::new();
            simulation.step(&mut events).unwrap();
            assert_eq!(events[0].time, first.time);
        }
    }
}

#[test]
fn a_lone_disc_goes_straight_on_for_ever() {
    let mut system = (*system(&Recipe::new(1, 0.05).into())).clone();
    system.flights[0].velocity = Vec2::new(3.0, -0.7);
    let (start, system) = (system.flights[0].position, Arc::new(system));
    let time = 5e5;
    let mut simulation: Simulation<f64> = Simulation::new(system, Limits::duration(time), &mut Nothing);
    simulation.run(&mut Nothing).unwrap();
    let run = simulation.finish(Log::new(false, false));
    // So often round that the flight has begun anew, many times.
    assert!(run.balls[0].1.image[0] > 100_000, "{:?}", run.balls);
    let end = run.final_state()[0].position;
    assert!((end.x - start.x - 3.0 * time).abs() < 1e-15 * 3.0 * time * 100.0, "{end:?}");
    assert!((end.y - start.y + 0.7 * time).abs() < 1e-15 * 3.0 * time * 100.0, "{end:?}");
}

#[test]
fn a_lone_disc_falls_round_the_table_for_ever() {
    let mut system = (*system(&Recipe::new(1, 0.05).into())).clone();
    let (velocity, field) = (Vec2::new(3.0, -0.7), Vec2::new(-1e-3, 1e-2));
    (system.flights[0].velocity, system.flights[0].acceleration, system.field) = (velocity, field, field);
    let (start, system) = (system.flights[0].position, Arc::new(system));
    let time = 2e4;
    let mut simulation: Simulation<f64> = Simulation::new(system, Limits::duration(time), &mut Nothing);
    simulation.run(&mut Nothing).unwrap();
    let run = simulation.finish(Log::new(false, false));
    assert!(run.balls[0].1.image[1] > 100_000 && run.balls[0].1.changes > 10, "{:?}", run.balls);
    let end = run.final_state()[0];
    let expected = start + velocity * time + field * (0.5 * time * time);
    assert!((end.position - expected).norm() < 1e-12 * expected.norm(), "{end:?} is not {expected:?}");
    assert!((end.velocity - velocity - field * time).norm() < 1e-12 * 200.0, "{end:?}");
    assert!(
        run.diagnostics.energy_drift < 1e-12 * 0.5 * end.velocity.norm_squared(),
        "{:?}",
        run.diagnostics
    );
}

#[test]
fn a_disc_that_lies_on_the_wall_of_a_channel_slides_on_for_ever() {
    let scene = Scene {
        field: Vec2::new(0.0, -1.0),
        ..Recipe { periodic: [true, false], ..Recipe::new(1, 0.05) }.into()
    };
    let mut system = (*system(&scene)).clone();
    let radius = system.discs[0].radius;
    (system.flights[0].position.y, system.flights[0].velocity) = (radius, Vec2::new(3.0, 0.0));
    let (start, system) = (system.flights[0].position, Arc::new(system));
    let mut simulation: Simulation<f64> = Simulation::new(system, Limits::duration(1e5), &mut Nothing);
    simulation.run(&mut Nothing).unwrap();
    let run = simulation.finish(Log::new(false, false));
    assert!(run.balls[0].1.changes > 5 && run.balls[0].1.is_held(), "{:?}", run.balls);
    let end = run.final_state()[0].position;
    assert_eq!(end.y, radius);
    assert!((end.x - start.x - 3e5).abs() < 1e-9, "{end:?}");
}

#[test]
fn walls_of_a_channel_are_met_wherever_a_disc_has_gone() {
    let system = system(&Recipe { periodic: [true, false], ..Recipe::new(4, 0.02) }.into());
    let mut simulation: Simulation<f64> = Simulation::new(system.clone(), unlimited(), &mut Nothing);
    let mut events: VecDeque<Event<f64>> = VecDeque::new();
    simulation.advance(3000, &mut events).unwrap();
    let walls: Vec<_> = events.iter().filter(|event| event.kind == Kind::BallCushion).collect();
    assert!(walls.len() > 500, "{}", walls.len());
    for event in walls {
        assert!([Some(0), Some(2)].contains(&event.cushion), "{event:?}");
        let wall = if event.cushion == Some(0) { 0.0 } else { system.bounds.max.y };
        assert!((event.point.y - wall).abs() < 1e-12, "{event:?}");
        assert!((-1e-9..=system.bounds.max.x + 1e-9).contains(&event.point.x), "{event:?}");
    }
}
