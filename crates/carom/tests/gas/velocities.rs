//! The velocities of a gas.

use super::kit::{bidisperse, made, recipe};
use carom::gas::{Amount, Arrangement, Error, Recipe, Sizes, Species, Start, Velocities, make};

fn gas(count: usize, periodic: [bool; 2], temperature: f64) -> Recipe {
    Recipe { periodic, temperature, ..recipe(count, 0.05, Arrangement::Random) }
}

fn momentum(start: &Start) -> [f64; 2] {
    let [mut x, mut y] = [0.0; 2];
    for (velocity, mass) in start.velocities.iter().zip(&start.masses) {
        (x, y) = (x + velocity.x * mass, y + velocity.y * mass);
    }
    [x, y]
}

fn energy(start: &Start) -> f64 {
    start.velocities.iter().zip(&start.masses).map(|(v, mass)| 0.5 * mass * v.norm_squared()).sum()
}

#[test]
fn momentum_is_zero_along_periodic_axes_and_energy_that_of_the_temperature() {
    for count in [1, 2, 3, 10, 1000, 20_000] {
        for periodic in [[true, true], [false, false], [true, false], [false, true]] {
            for temperature in [0.0, 1.0, 2.5] {
                let mut recipe = gas(count, periodic, temperature);
                if count > 2 {
                    recipe.sizes = bidisperse();
                }
                let start = made(&recipe);
                let held = periodic.iter().filter(|is_periodic| **is_periodic).count() as f64;
                let expected = (count as f64 - 0.5 * held) * temperature;
                // The sums here are plain ones, with the rounding of so many terms.
                let rounding = 1e-15 * (10.0 + count as f64);
                assert!((energy(&start) - expected).abs() <= rounding * expected, "{recipe:?}");
                for (axis, momentum) in momentum(&start).into_iter().enumerate() {
                    let is_zero = momentum.abs() < 4.0 * rounding;
                    assert!(is_zero || !periodic[axis], "{recipe:?}: {momentum}");
                }
            }
        }
    }
}

#[test]
fn a_single_disc_moves_only_between_walls() {
    let speed = |periodic| made(&gas(1, periodic, 1.0)).velocities[0].to_f64().map(f64::abs);
    assert_eq!(speed([true, true]), [0.0, 0.0]);
    assert_eq!(speed([true, false]), [0.0, 1.0]);
    let [x, y] = speed([false, false]);
    assert!((x * x + y * y - 2.0).abs() < 1e-14);
}

#[test]
fn velocities_have_maxwells_moments() {
    let count = 20_000;
    let start = made(&gas(count, [true, true], 1.0));
    let mean =
        |of: fn(f64, f64) -> f64| start.velocities.iter().map(|v| of(v.x, v.y)).sum::<f64>() / count as f64;
    type Moment = (fn(f64, f64) -> f64, f64, f64);
    // Each with its expectation and the variance of one term, four standard errors of the mean.
    let moments: [Moment; 8] = [
        (|x, _| x * x, 1.0, 2.0),
        (|_, y| y * y, 1.0, 2.0),
        (|x, y| x * y, 0.0, 1.0),
        (|x, _| x * x * x, 0.0, 15.0),
        (|x, _| x * x * x * x, 3.0, 96.0),
        (|_, y| y * y * y * y, 3.0, 96.0),
        (|x, y| x * x * y * y, 1.0, 8.0),
        (|x, y| (x * x + y * y).sqrt(), 1.253_314_137_315_500_3, 0.429_203_673_205_103_4),
    ];
    for (number, (of, expected, variance)) in moments.into_iter().enumerate() {
        let error = (variance / count as f64).sqrt();
        let found = mean(of);
        assert!((found - expected).abs() < 4.0 * error, "moment {number}: {found}, not {expected}");
    }
}

#[test]
fn species_share_the_energy() {
    let count = 20_000;
    let start = made(&Recipe { sizes: bidisperse(), ..gas(count, [true, true], 1.0) });
    for mass in [1.0, 2.0] {
        let of = start.velocities.iter().zip(&start.masses).filter(|(_, of)| **of == mass);
        let energies: Vec<f64> = of.map(|(v, _)| 0.5 * mass * v.norm_squared()).collect();
        let mean = energies.iter().sum::<f64>() / energies.len() as f64;
        // Energies have an exponential distribution, with a standard deviation as large as their mean.
        assert!((mean - 1.0).abs() < 4.0 / (energies.len() as f64).sqrt(), "mass {mass}: {mean}");
    }
}

#[test]
fn equal_speeds_have_no_momentum_and_the_energy_of_the_temperature() {
    for count in [2, 3, 5, 50, 1000] {
        for (periodic, sizes) in [([true, true], Sizes::Equal), ([false, false], bidisperse())] {
            let mut recipe =
                Recipe { sizes, velocities: Velocities::EqualSpeed, ..gas(count, periodic, 2.5) };
            if count < 10 {
                recipe.sizes = Sizes::Equal;
            }
            let start = made(&recipe);
            let speeds: Vec<f64> = start.velocities.iter().map(|v| v.norm_squared().sqrt()).collect();
            // A direction, its length and the scaling: a few roundings each.
            assert!(speeds.iter().all(|speed| (speed / speeds[0] - 1.0).abs() < 1e-15 * 8.0), "{count}");
            let most = 1e-14 * speeds[0] * count as f64;
            assert!(momentum(&start).into_iter().all(|along| along.abs() < most), "{count}");
            let freedom = count as f64 - if periodic[0] { 1.0 } else { 0.0 };
            assert!((energy(&start) / (2.5 * freedom) - 1.0).abs() < 1e-13, "{count}");
        }
    }
}

#[test]
fn equal_speeds_go_everywhere() {
    let count = 20_000;
    let start = made(&Recipe { velocities: Velocities::EqualSpeed, ..gas(count, [true, true], 1.0) });
    let speed = start.velocities[0].norm_squared().sqrt();
    // Of directions that are equally likely cos 2φ, sin 2φ and cos 4φ have mean 0 and variance ½: four standard errors.
    let angles: [fn(f64, f64) -> f64; 3] =
        [|x, y| x * x - y * y, |x, y| 2.0 * x * y, |x, y| 8.0 * x * x * y * y - 1.0];
    for of in angles {
        let mean = start.velocities.iter().map(|v| of(v.x / speed, v.y / speed)).sum::<f64>() / count as f64;
        assert!(mean.abs() < 4.0 * (0.5 / count as f64).sqrt(), "{mean}");
    }
}

#[test]
fn equal_speeds_that_cannot_balance_are_refused() {
    let heavy = |mass| {
        let one = |number, mass| Species { amount: Amount::Number(number), diameter: 1.0, mass };
        let sizes = Sizes::Species(vec![one(1, mass), one(3, 1.0)]);
        make(&Recipe { sizes, velocities: Velocities::EqualSpeed, ..gas(4, [false, false], 1.0) })
    };
    assert_eq!(heavy(3.5), Err(Error::NoBalance));
    assert!(heavy(2.5).is_ok());
    let single = Recipe { velocities: Velocities::EqualSpeed, ..gas(1, [false, false], 1.0) };
    assert_eq!(make(&single), Err(Error::NoBalance));
}
