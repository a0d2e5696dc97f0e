//! Whole runs that are observed: periodic gases, and gases between walls.

use carom::gas::{Arrangement, Recipe, Start, make};
use carom::observe::{Observables, Quantity, Request, Results, compressibility};
use carom::run::{Run, Status};
use carom::scenario::Scenario;
use carom::simulate::{ObservedError, ObservedRun, Plan, Progress, Sampling, simulate, simulate_observed};
use serde_json::{Value, json};

/// The scenario of a gas, with some of its keys.
fn scenario(recipe: &Recipe, more: &Value) -> Scenario {
    let Start { size, positions, velocities, radii, masses, .. } = make(recipe).unwrap();
    let ball = |k: usize| {
        json!({ "id": format!("d{k}"), "radius": radii[k], "mass": masses[k],
            "position": positions[k].to_f64(), "velocity": velocities[k].to_f64() })
    };
    let periodic: Vec<_> = ["x", "y"].into_iter().zip(recipe.periodic).filter(|axis| axis.1).collect();
    let periodic: Vec<_> = periodic.iter().map(|axis| axis.0).collect();
    let mut values = json!({
        "format": 1,
        "record": "none",
        "table": { "shape": "rectangle", "width": size[0], "length": size[1], "periodic": periodic },
        "balls": (0..positions.len()).map(ball).collect::<Vec<_>>(),
    });
    for (key, value) in more.as_object().unwrap() {
        values[key] = value.clone();
    }
    Scenario::from_json(&values.to_string()).unwrap()
}

pub fn gas(count: usize, packing_fraction: f64, more: &Value) -> Scenario {
    let start = Arrangement::Square;
    scenario(&Recipe { seed: 3, start, ..Recipe::new(count, packing_fraction) }, more)
}

fn observe(
    scenario: &Scenario,
    names: &[&str],
    sampling: &Sampling,
) -> Result<(Run<f64>, Vec<Results>), ObservedError> {
    observe_until(scenario, names, sampling, &mut |_| false)
}

fn observe_until(
    scenario: &Scenario,
    names: &[&str],
    sampling: &Sampling,
    interrupted: &mut dyn FnMut(&Progress) -> bool,
) -> Result<(Run<f64>, Vec<Results>), ObservedError> {
    let requests: Vec<Request> = names.iter().map(|name| Request::new(name)).collect();
    let observables = Observables::new(&requests).unwrap();
    let (run, observables) = simulate_observed(scenario, None, observables, sampling, interrupted)?;
    Ok((run, observables.results()))
}

fn quantity(results: &Results, name: &str) -> Quantity {
    results.quantity(name).unwrap_or_else(|| panic!("no {name}")).clone()
}

#[test]
fn observing_changes_no_bit_of_a_run() {
    let start = Arrangement::Square;
    let walls = Recipe { periodic: [false, true], start, seed: 5, ..Recipe::new(144, 0.5) };
    let names = ["pressure", "free_path", "radial_distribution", "diffusion", "psi6"];
    for scenario in [
        gas(400, 0.3, &json!({ "collisions": 40_000 })),
        gas(121, 0.6, &json!({ "collisions": 5000, "record": "all" })),
        scenario(&walls, &json!({ "duration": 50.0, "record": "events" })),
    ] {
        let alone = simulate(&scenario).unwrap();
        for sampling in [
            Sampling::default(),
            Sampling { equilibrate: 20.0, interval: None },
            Sampling { equilibrate: 3.0, interval: Some(0.37) },
        ] {
            let (run, results) = observe(&scenario, &names, &sampling).unwrap();
            assert_eq!(results.len(), names.len());
            assert_eq!(run.digest(), alone.digest(), "{sampling:?}");
            assert_eq!((run.status, run.end_time), (alone.status, alone.end_time));
            assert_eq!(run.log.events, alone.log.events);
            assert_eq!(run.log.flights, alone.log.flights);
        }
    }
}

#[test]
fn compressibility_of_a_periodic_gas_is_that_of_kolafa_and_rottner() {
    let scenario = gas(400, 0.3, &json!({ "collisions": 400_000 }));
    let names = ["pressure", "collision_rate", "diffusion"];
    let (_, results) = observe(&scenario, &names, &Sampling { equilibrate: 50.0, interval: None }).unwrap();
    let by_virial = quantity(&results[0], "compressibility_factor");
    let counted = quantity(&results[1], "compressibility_factor");
    let theory = compressibility(0.3).unwrap();
    // 400 discs have N (N − 1)/2 pairs, where a large gas has N²/2.
    let of_400 = 1.0 + (theory - 1.0) * (1.0 - 1.0 / 400.0);
    for z in [&by_virial, &counted] {
        let (value, error) = (z.value.unwrap(), z.error.unwrap());
        assert!((z.expected.unwrap() - theory).abs() < 1e-12 * theory);
        assert!((value - of_400).abs() <= 4.0 * error, "{value} ± {error}, {of_400}");
        assert!(error < 0.002 * theory, "{error} says little");
    }
    // Both come from the same collisions: what remains between them is how hard these were.
    let between = by_virial.value.unwrap() - counted.value.unwrap();
    let error = by_virial.error.unwrap().max(counted.error.unwrap());
    assert!(between.abs() <= 4.0 * error, "{between} {error}");

    // Only unwrapped places go further than half the box, whose square of the side is 1047.
    let displacements = results[2].column("diffusion", "mean_square_displacement").unwrap();
    let measured: Vec<f64> = displacements.iter().copied().filter(|value| !value.is_nan()).collect();
    assert!(measured.windows(2).all(|pair| pair[1] > pair[0]), "{measured:?}");
    assert!(measured.last().is_some_and(|last| *last > 1047.0), "{measured:?}");
}

#[test]
fn samples_come_at_the_interval_that_was_given_after_the_collisions_left_out() {
    let scenario = gas(100, 0.4, &json!({ "collisions": 10_000 }));
    let observables = Observables::new(&[Request::new("h_function").with("points", 10_000)]).unwrap();
    let sampling = Sampling { equilibrate: 40.0, interval: Some(0.25) };
    let (run, observables) =
        simulate_observed(&scenario, None, observables, &sampling, &mut |_| false).unwrap();
    let results = observables.results();
    let times = results[0].column("over_time", "time").unwrap();
    // 40 collisions of each of 100 discs are 2000.
    let shorter = Scenario { collisions: Some(2000), ..scenario };
    assert_eq!(times[0], simulate(&shorter).unwrap().end_time);
    assert!((times[1] - times[0] - 0.25).abs() < 1e-12);
    let expected = ((run.end_time - times[0]) / 0.25) as u64 + 1;
    assert_eq!(observables.samples(), expected);
}

#[test]
fn an_interval_that_is_not_given_takes_ten_collisions_of_each_disc() {
    let scenario = gas(100, 0.4, &json!({ "collisions": 20_500 }));
    for equilibrate in [0.0, 100.0] {
        let observables = Observables::new(&[Request::new("pressure")]).unwrap();
        let sampling = Sampling { equilibrate, interval: None };
        let (_, observables) =
            simulate_observed(&scenario, None, observables, &sampling, &mut |_| false).unwrap();
        let intervals = (observables.samples() - 1) as f64;
        // 500 collisions to an interval: the rate of the first differs by some per cent from that of all.
        let expected = (20_500.0 - 50.0 * equilibrate) / 500.0;
        assert!((intervals / expected - 1.0).abs() < 0.1, "{intervals} {expected}");
    }
}

#[test]
fn a_sample_at_the_very_end_counts() {
    let scenario = gas(30, 0.2, &json!({ "duration": 5.0 }));
    let observables = Observables::new(&[Request::new("pressure")]).unwrap();
    let sampling = Sampling { equilibrate: 0.0, interval: Some(0.5) };
    let (_, observables) =
        simulate_observed(&scenario, None, observables, &sampling, &mut |_| false).unwrap();
    assert_eq!(observables.samples(), 11);
}

#[test]
fn an_interrupted_run_gives_what_there_is() {
    let scenario = gas(100, 0.4, &json!({ "collisions": 100_000_000 }));
    let mut times = Vec::new();
    let mut interrupted = |progress: &Progress| {
        times.push(progress.time);
        progress.samples >= 100
    };
    let sampling = Sampling { equilibrate: 10.0, interval: None };
    let (run, results) = observe_until(&scenario, &["pressure"], &sampling, &mut interrupted).unwrap();
    assert_eq!(run.status, Status::Interrupted);
    assert!(quantity(&results[0], "compressibility_factor").error.is_some());
    assert!(times.len() > 1 && times.windows(2).all(|pair| pair[1] > pair[0]));

    let at_once = Sampling { equilibrate: 1e6, interval: None };
    let (run, results) = observe_until(&scenario, &["pressure"], &at_once, &mut |_| true).unwrap();
    assert_eq!((run.status, results.len()), (Status::Interrupted, 0));
}

#[test]
fn a_run_too_short_to_measure_anything_says_so() {
    for (end, status, sampling) in [
        (
            json!({ "collisions": 1000 }),
            "collision_limit",
            Sampling { equilibrate: 10.0, interval: Some(1e3) },
        ),
        (json!({ "collisions": 1000 }), "collision_limit", Sampling { equilibrate: 15.0, interval: None }),
        (json!({ "duration": 1.0 }), "time_limit", Sampling { equilibrate: 100.0, interval: None }),
    ] {
        let error = observe(&gas(100, 0.4, &end), &["pressure"], &sampling).unwrap_err();
        assert!(matches!(error, ObservedError::TooShort { .. }), "{error}");
        assert!(error.to_string().contains(status), "{error}");
    }
}

#[test]
fn collisions_that_are_surely_too_few_are_refused_before_the_run() {
    for (equilibrate, interval, fewest) in
        [(100.0, None, 5000), (100.0, Some(1.0), 5000), (3.0, None, 650), (0.0, None, 500)]
    {
        let sampling = Sampling { equilibrate, interval };
        let refused = |collisions: u64| {
            let scenario = gas(100, 0.4, &json!({ "collisions": collisions }));
            let observables = Observables::new(&[Request::new("pressure")]).unwrap();
            ObservedRun::new(&scenario, None, observables, Plan { sampling, ..Plan::default() }).err()
        };
        assert!(refused(fewest).is_none());
        match refused(fewest - 1) {
            Some(ObservedError::Unfit(problem)) => {
                assert_eq!(problem.place, "collisions");
                assert!(
                    problem.message.starts_with(&format!("must be {fewest} or more")),
                    "{}",
                    problem.message
                );
            }
            _ => panic!("accepted"),
        }
    }
    assert!(
        observe(
            &gas(100, 0.4, &json!({ "collisions": 50 })),
            &["pressure"],
            &Sampling { equilibrate: 0.0, interval: Some(0.01) }
        )
        .is_ok()
    );
}

#[test]
fn what_is_no_gas_in_a_rectangle_is_refused() {
    let place = |more: Value, sampling: &Sampling| match observe(&gas(4, 0.1, &more), &["pressure"], sampling)
    {
        Err(ObservedError::Unfit(problem)) => problem.place,
        other => panic!("{other:?}"),
    };
    let plain = Sampling::default();
    let ball = json!({ "id": "a", "radius": 0.5, "position": [0.0, 0.0] });
    let table = json!({ "shape": "circle", "radius": 20.0 });
    let circle = json!({ "duration": 1.0, "table": table, "balls": [ball] });
    assert_eq!(place(circle, &plain), "table");
    let obstacle = json!({ "shape": "rectangle", "width": 40.0, "length": 40.0,
        "obstacles": [{ "circle": { "center": [30.0, 30.0], "radius": 1.0 } }] });
    assert_eq!(place(json!({ "duration": 1.0, "table": obstacle }), &plain), "table");
    for equilibrate in [-1.0, f64::NAN, f64::INFINITY] {
        let sampling = Sampling { equilibrate, interval: None };
        assert_eq!(place(json!({ "duration": 1.0 }), &sampling), "equilibrate");
    }
    for interval in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let sampling = Sampling { equilibrate: 0.0, interval: Some(interval) };
        assert_eq!(place(json!({ "duration": 1.0 }), &sampling), "sample_interval");
    }
}
