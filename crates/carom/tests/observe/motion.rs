//! Diffusion of discs whose motion is known.

use crate::kit::{Gas, assert_within_errors, column, gaussian, is_close, quantity, value};
use carom::geometry::Vec2;
use carom::observe::{Observables, Request};
use carom::random::Random;

fn diffusion(longest: u64, lags: &str, origins: u64) -> Observables {
    let request =
        Request::new("diffusion").with("longest", longest).with("lags", lags).with("origins", origins);
    Observables::new(&[request]).unwrap()
}

#[test]
fn free_flight_goes_as_the_square_of_the_time() {
    let mut random = Random::new(31, "flight");
    let mut gas = Gas::random(40, [5.0, 5.0], [true; 2], &mut random);
    gas.heat(1.3, &mut random);
    let square = gas.velocities.iter().map(|velocity| velocity.norm_squared()).sum::<f64>() / 40.0;
    for lags in ["linear", "logarithmic"] {
        let mut observables = diffusion(20, lags, 3);
        let mut moving = gas.clone();
        for sample in 0..60 {
            observables.sample(&moving.at(0.25 * f64::from(sample))).unwrap();
            moving.fly(0.25);
        }
        let [lag, displacement, correlation] =
            ["lag", "mean_square_displacement", "velocity_autocorrelation"]
                .map(|name| column(&observables, "diffusion", name));
        let expected: &[f64] = if lags == "linear" {
            &[0.0, 0.25, 0.5, 0.75]
        } else {
            &[0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0]
        };
        assert_eq!(&lag[..expected.len()], expected);
        assert_eq!(lag.last(), Some(&5.0));
        for k in 0..lag.len() {
            // Positions of some 20 have a round-off of 1e-14 of a step.
            assert!((displacement[k] - square * lag[k] * lag[k]).abs() < 1e-12 * square * 25.0, "{lags} {k}");
            assert!(is_close(correlation[k], square), "{lags} {k}");
        }
        assert!(is_close(value(&observables, "diffusion_from_velocities"), 0.5 * square * 5.0));
    }
}

#[test]
fn a_random_walk_has_its_diffusion_coefficient() {
    let mut random = Random::new(32, "walk");
    let mut gas = Gas::random(100, [10.0, 10.0], [true; 2], &mut random);
    let (coefficient, step) = (0.7, 0.5);
    let mut observables = diffusion(16, "linear", 4);
    for sample in 0..3000 {
        observables.sample(&gas.at(step * f64::from(sample))).unwrap();
        for position in &mut gas.positions {
            *position = *position + gaussian(&mut random) * (2.0 * coefficient * step).sqrt();
        }
    }
    assert_within_errors(&quantity(&observables, "diffusion_from_displacement"), coefficient, 0.02);
    let [lag, displacement, error] = ["lag", "mean_square_displacement", "mean_square_displacement_error"]
        .map(|name| column(&observables, "diffusion", name));
    for k in 1..lag.len() {
        let off = displacement[k] - 4.0 * coefficient * lag[k];
        assert!(off.abs() < 5.0 * error[k] && error[k] < 0.02 * displacement[k], "{k}: {off} {}", error[k]);
    }
}

#[test]
fn velocities_that_forget_give_the_diffusion_coefficient_of_their_integral() {
    let mut random = Random::new(33, "forgetting");
    let mut gas = Gas::random(100, [10.0, 10.0], [true; 2], &mut random);
    gas.heat(1.0, &mut random);
    let keeps = 0.9_f64;
    let mut observables = diffusion(20, "linear", 2);
    for sample in 0..6000 {
        observables.sample(&gas.at(f64::from(sample))).unwrap();
        for velocity in &mut gas.velocities {
            *velocity = *velocity * keeps + gaussian(&mut random) * (1.0 - keeps * keeps).sqrt();
        }
    }
    // Half of ⟨v²⟩ = 2 times the trapezia of 0.9^k, k = 0 … 20.
    let trapezia = (1.0 - keeps.powi(20)) / (1.0 - keeps) - 0.5 * (1.0 - keeps.powi(20));
    assert_within_errors(&quantity(&observables, "diffusion_from_velocities"), trapezia, 0.02);
    let correlation = column(&observables, "diffusion", "velocity_autocorrelation");
    let error = column(&observables, "diffusion", "velocity_autocorrelation_error");
    assert!((0..21).all(|k| (correlation[k] - 2.0 * keeps.powi(k as i32)).abs() < 5.0 * error[k]));
}

#[test]
fn only_so_many_origins_are_kept() {
    let mut gas = Gas::new([5.0, 5.0], [true; 2], vec![Vec2::new(1.0, 1.0); 3]);
    for (longest, origins) in [(8, 1), (8, 3), (9, 4), (7, 7)] {
        let mut observables = diffusion(longest, "linear", origins);
        for sample in 0..50 {
            observables.sample(&gas.at(f64::from(sample))).unwrap();
            gas.fly(1.0);
            let kept = serde_json::to_value(&observables).unwrap();
            let kept = kept["all"][0]["diffusion"]["origins"].as_array().unwrap().len();
            assert!(kept as u64 <= origins, "{longest} {origins}: {kept}");
        }
        assert!(quantity(&observables, "diffusion_from_velocities").error.is_some());
    }
}
