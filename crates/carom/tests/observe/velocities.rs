//! Speeds, H, temperatures and energies of velocities that are drawn.

use crate::kit::{Gas, assert_within_errors, column, gaussian, observe, only, quantity, value};
use carom::geometry::Vec2;
use carom::observe::{Observables, Request};
use carom::random::Random;
use core::f64::consts::PI;

fn gas(count: usize, periods: [bool; 2], random: &mut Random) -> Gas {
    Gas::random(count, [10.0, 12.0], periods, random)
}

#[test]
fn moments_of_maxwells_distribution_are_within_their_errors() {
    let (temperature, mass) = (1.7, 2.3);
    let mut random = Random::new(21, "maxwell");
    let mut gas = gas(500, [false; 2], &mut random);
    gas.masses = vec![mass; 500];
    let mut observables = observe("speeds");
    for sample in 0..400 {
        gas.heat(temperature, &mut random);
        observables.sample(&gas.at(f64::from(sample))).unwrap();
    }
    // The error of the temperature: kT over the root of the number of speeds.
    let found = quantity(&observables, "temperature");
    assert_within_errors(&found, temperature, 0.003);
    assert!((found.error.unwrap() * 200_000_f64.sqrt() / temperature - 1.0).abs() < 0.2, "{found:?}");
    assert_within_errors(
        &quantity(&observables, "mean_speed"),
        (PI * temperature / (2.0 * mass)).sqrt(),
        0.003,
    );
    assert_within_errors(&quantity(&observables, "mean_square_speed"), 2.0 * temperature / mass, 0.003);
    // Each sample has a ratio of its own, which a fluctuating energy leaves at 2N/(N + 1).
    assert_within_errors(&quantity(&observables, "fourth_moment_ratio"), 2.0, 0.01);
}

#[test]
fn the_histogram_of_speeds_is_maxwells() {
    let mut random = Random::new(22, "maxwell");
    let mut gas = gas(2000, [false; 2], &mut random);
    // Unequal masses at one temperature: the scaled speeds are those of the mean mass.
    gas.masses = (0..2000).map(|disc| 1.0 + f64::from(disc % 3)).collect();
    let request = Request::new("speeds").with("bins", 40).with("largest", 4.0);
    let mut observables = Observables::new(&[request]).unwrap();
    for sample in 0..100 {
        gas.heat(1.0, &mut random);
        observables.sample(&gas.at(f64::from(sample))).unwrap();
    }
    let [speed, density, error, maxwell] =
        ["speed", "density", "density_error", "maxwell"].map(|name| column(&observables, "speeds", name));
    let mass = gas.masses.iter().sum::<f64>() / 2000.0;
    for bin in 0..30 {
        let exact = mass * speed[bin] * (-0.5 * mass * speed[bin] * speed[bin]).exp();
        assert!((maxwell[bin] - exact).abs() < 0.005, "{bin}: {} {exact}", maxwell[bin]);
        assert!((density[bin] - maxwell[bin]).abs() < 5.0 * error[bin].max(1e-4), "{bin}");
    }
    let total = density.iter().sum::<f64>() * 0.1 + value(&observables, "beyond");
    assert!((total - 1.0).abs() < 1e-12, "{total}");
}

/// Velocities with a given energy and, along periodic axes, no momentum, each equally likely.
fn microcanonical(gas: &mut Gas, random: &mut Random) {
    gas.heat(1.0, random);
    let count = gas.velocities.len() as f64;
    let sum = gas.velocities.iter().fold(Vec2::ZERO, |sum, velocity| sum + *velocity);
    let along = |axis: usize, sum: f64| if gas.periods[axis] { sum / count } else { 0.0 };
    let drift = Vec2::new(along(0, sum.x), along(1, sum.y));
    gas.velocities.iter_mut().for_each(|velocity| *velocity = *velocity - drift);
    let energy: f64 = gas.velocities.iter().map(|velocity| velocity.norm_squared()).sum();
    gas.velocities.iter_mut().for_each(|velocity| *velocity = *velocity * (count / energy).sqrt());
}

#[test]
fn few_discs_at_fixed_energy_have_the_fourth_moment_of_few_discs() {
    for (periods, freedom, truth) in [([false; 2], 8.0, 8.0 / 5.0), ([true; 2], 6.0, 6.0 / 4.0)] {
        let mut random = Random::new(23, "microcanonical");
        let mut gas = gas(4, periods, &mut random);
        let mut observables = observe("speeds");
        for sample in 0..20_000 {
            microcanonical(&mut gas, &mut random);
            observables.sample(&gas.at(f64::from(sample))).unwrap();
        }
        let found = quantity(&observables, "fourth_moment_ratio");
        assert!((found.expected.unwrap() - truth).abs() < 1e-12);
        assert_within_errors(&found, truth, 0.01);
        // Four discs of mean ⟨v²⟩ = 1: kT is their energy over the degrees of freedom.
        assert!((value(&observables, "temperature") - 4.0 / freedom).abs() < 1e-9);
    }
}

#[test]
fn a_drift_along_a_periodic_axis_is_no_heat() {
    let mut random = Random::new(24, "drift");
    let mut gas = gas(50, [true, false], &mut random);
    gas.heat(1.0, &mut random);
    let temperature = |gas: &Gas| {
        let mut observables = observe("speeds");
        observables.sample(&gas.at(0.0)).unwrap();
        value(&observables, "temperature")
    };
    let still = temperature(&gas);
    gas.velocities.iter_mut().for_each(|velocity| velocity.x += 3.0);
    assert!((temperature(&gas) / still - 1.0).abs() < 1e-12);
    gas.velocities.iter_mut().for_each(|velocity| velocity.y += 3.0);
    assert!(temperature(&gas) > 5.0);
}

#[test]
fn h_of_maxwells_distribution_is_the_closed_form() {
    let (temperature, mass) = (2.0, 3.0);
    let truth = (mass / (2.0 * PI * temperature)).ln() - 1.0;
    for (count, samples) in [(200_000, 1), (1000, 200)] {
        let mut random = Random::new(25, "h");
        let mut gas = gas(count, [false; 2], &mut random);
        gas.masses = vec![mass; count];
        let request = Request::new("h_function").with("points", 10_000);
        let mut observables = Observables::new(&[request]).unwrap();
        for sample in 0..samples {
            gas.heat(temperature, &mut random);
            observables.sample(&gas.at(f64::from(sample))).unwrap();
        }
        let [h, error, maxwell] =
            ["h", "h_error", "maxwell"].map(|name| column(&observables, "over_time", name));
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        // Rings of a finite area miss 0.12²/24, and some of a thousand discs are each alone in theirs.
        let bias = if samples > 1 { 0.01 } else { 0.001 };
        let allowed = 5.0 * error[0] / f64::from(samples).sqrt() + bias;
        assert!((mean(&h) - truth).abs() < allowed, "{} {truth} {allowed}", mean(&h));
        assert!((mean(&maxwell) - truth).abs() < 0.01);
    }
}

#[test]
fn h_of_equal_speeds_is_that_of_a_single_ring() {
    let mut random = Random::new(26, "h");
    let mut gas = gas(1000, [false; 2], &mut random);
    for velocity in &mut gas.velocities {
        *velocity = gaussian(&mut random).unit() * 2.0;
    }
    let mut observables = observe("h_function");
    observables.sample(&gas.at(0.0)).unwrap();
    // kT = v²/2 = 2, so that a ring of 0.12 kT has the area 2π × 0.12 kT.
    let truth = -(2.0 * PI * 2.0 * 0.12).ln();
    assert!((column(&observables, "over_time", "h")[0] - truth).abs() < 1e-9);
}

#[test]
fn a_profile_has_the_temperature_and_the_density_of_each_strip() {
    let request = Request::new("temperature_profile").with("axis", "y").with("bins", 4);
    let mut observables = Observables::new(&[request]).unwrap();
    let mut random = Random::new(27, "profile");
    let mut gas = gas(600, [true, false], &mut random);
    for sample in 0..300 {
        for disc in 0..600 {
            // A third of the discs in the lower half, at kT = 1; the others above, at kT = 3.
            let is_low = disc % 3 == 0;
            let y = if is_low { 6.0 * random.unit() } else { 6.0 + 6.0 * random.unit() };
            gas.positions[disc] = Vec2::new(37.0 * random.unit() - 11.0, y);
            gas.velocities[disc] = gaussian(&mut random) * if is_low { 1.0 } else { 3.0_f64.sqrt() };
        }
        observables.sample(&gas.at(f64::from(sample))).unwrap();
    }
    let [y, temperature, error, density, density_error] =
        ["y", "temperature", "temperature_error", "density", "density_error"]
            .map(|name| column(&observables, "profile", name));
    assert_eq!(y, [1.5, 4.5, 7.5, 10.5]);
    for strip in 0..4 {
        let (truth, discs) = if strip < 2 { (1.0, 200.0) } else { (3.0, 400.0) };
        // The drift takes a 600th of the heat along x, which the degrees of freedom give back; across strips it is
        // another.
        assert!((temperature[strip] - truth).abs() < 5.0 * error[strip] + 0.003, "{temperature:?} {error:?}");
        assert!(error[strip] < 0.01 * truth);
        assert!((density[strip] - discs / 60.0).abs() < 5.0 * density_error[strip], "{density:?}");
    }
}

#[test]
fn kinetic_energy_is_beside_haffs_law() {
    let request = Request::new("kinetic_energy").with("restitution", 0.9).with("points", 4);
    let mut observables = Observables::new(&[request]).unwrap();
    let mut random = Random::new(28, "haff");
    // Ten discs of area π/4 on 25 π: η = 0.1.
    let size = [10.0, 2.5 * PI];
    let mut gas = Gas::random(10, size, [true; 2], &mut random);
    microcanonical(&mut gas, &mut random);
    for sample in 0..7 {
        observables.sample(&gas.at(5.0 + f64::from(sample))).unwrap();
    }
    let [time, energy, haff] =
        ["time", "kinetic_energy", "haff"].map(|name| column(&observables, "over_time", name));
    // Seven samples on four points: two by two, and a last one alone.
    assert_eq!(time, [5.5, 7.5, 9.5, 11.0]);
    assert!(energy.iter().all(|energy| (energy - 0.5).abs() < 1e-12));
    // kT = E/(N − 1) = 5/9 at first, and the rate of a disc 0.53292 √kT at η = 0.1.
    let law = |t: f64| 0.5 / (1.0 + 0.25 * 0.19 * 0.53292 * (5.0_f64 / 9.0).sqrt() * t).powi(2);
    assert!((haff[3] - law(6.0)).abs() < 1e-5, "{haff:?}");
    assert!((haff[0] - 0.5 * (law(0.0) + law(1.0))).abs() < 1e-5, "{haff:?}");
}

#[test]
fn without_a_restitution_there_is_no_law() {
    let mut observables = observe("kinetic_energy");
    observables.sample(&gas(10, [true; 2], &mut Random::new(1, "law")).at(0.0)).unwrap();
    assert!(only(&observables).column("over_time", "haff").is_none());
}
