//! Pressure, collision rate and free path of motions that can be followed by hand.

use crate::kit::{Gas, bounce, collide, column, is_close, observe, quantity, value};
use carom::geometry::Vec2;
use carom::observe::{Observables, Request, compressibility};

const SPEED: f64 = 1.5;
const MASS: f64 = 2.0;

/// Two discs that bounce against each other along x in a periodic box of length L, for some bounces in each of several
/// intervals: relative speed 2v, and L − 2σ to go from bounce to bounce.
fn two_discs(name: &str, length: f64) -> (Observables, f64) {
    let mut gas = Gas::new([length, 3.0], [true; 2], vec![Vec2::new(1.0, 1.0), Vec2::new(3.0, 1.0)]);
    gas.velocities = vec![Vec2::new(SPEED, 0.0), Vec2::new(-SPEED, 0.0)];
    gas.masses = vec![MASS; 2];
    let period = (length - 2.0) / (2.0 * SPEED);
    let mut observables = Observables::new(&[Request::new(name)]).unwrap();
    // Before the first sample nothing counts.
    collide(&mut observables, 0.0, (0, 1), 1e9);
    for interval in 0..5 {
        let start = f64::from(interval) * 4.0 * period;
        observables.sample(&gas.at(start)).unwrap();
        for k in 0..4 {
            let time = start + (f64::from(k) + 0.5) * period;
            collide(&mut observables, time, (1, 0), MASS * 2.0 * SPEED);
        }
    }
    observables.sample(&gas.at(20.0 * period)).unwrap();
    (observables, period)
}

#[test]
fn two_discs_in_a_periodic_box_have_the_pressure_found_by_hand() {
    let length = 6.0;
    let (observables, _) = two_discs("pressure", length);
    // Without total momentum kT = E/(N − 1) = m v², so that Z = 1 + σ/(L − 2σ).
    let temperature = MASS * SPEED * SPEED;
    assert!(is_close(value(&observables, "temperature"), temperature));
    let z = 1.0 + 1.0 / (length - 2.0);
    assert!(is_close(value(&observables, "compressibility_factor"), z));
    assert!(is_close(value(&observables, "virial_pressure"), z * 2.0 * temperature / (3.0 * length)));
    assert!(quantity(&observables, "compressibility_factor").error.unwrap() < 1e-12);
    assert_eq!(value(&observables, "degrees_of_freedom"), 2.0);
}

#[test]
fn two_discs_in_a_periodic_box_have_the_rate_found_by_hand() {
    let (observables, period) = two_discs("collision_rate", 6.0);
    assert!(is_close(value(&observables, "collisions_per_time"), 1.0 / period));
    assert!(is_close(value(&observables, "collision_rate"), 1.0 / period));
    assert!(is_close(value(&observables, "reduced_collision_rate"), 1.0 / (period * SPEED)));
    let z = 1.0 + 0.25 * core::f64::consts::PI.sqrt() / (period * SPEED);
    assert!(is_close(value(&observables, "compressibility_factor"), z));
    let by_pressure = 4.0 / core::f64::consts::PI.sqrt() / 4.0;
    assert!(is_close(value(&observables, "reduced_rate_from_pressure"), by_pressure));
}

#[test]
fn two_discs_in_a_periodic_box_have_the_free_path_found_by_hand() {
    let (observables, period) = two_discs("free_path", 6.0);
    assert!(is_close(value(&observables, "mean_free_time"), period));
    assert!(is_close(value(&observables, "mean_free_path"), SPEED * period));
    let [start, end, density] =
        ["start", "end", "density"].map(|name| column(&observables, "free_times", name));
    // All free times are one period, so that there is one bin, which round-off may make two.
    let total: f64 = (0..start.len()).map(|bin| density[bin] * (end[bin] - start[bin])).sum();
    assert!(start.len() <= 2 && start[0] <= period && *end.last().unwrap() >= period);
    assert!(is_close(total, 1.0));
}

#[test]
fn free_times_are_counted_in_eighths_of_octaves() {
    let mut observables = observe("free_path");
    let gas =
        Gas::new([9.0, 9.0], [true; 2], vec![Vec2::new(1.0, 1.0), Vec2::new(4.0, 4.0), Vec2::new(7.0, 7.0)]);
    observables.sample(&gas.at(0.0)).unwrap();
    // Free times of disc 0: 1, 1.1, 3.15; the others collide once or twice.
    collide(&mut observables, 1.0, (0, 1), 1.0);
    collide(&mut observables, 2.0, (0, 2), 1.0);
    collide(&mut observables, 3.1, (2, 0), 1.0);
    collide(&mut observables, 6.25, (0, 1), 1.0);
    observables.sample(&gas.at(8.0)).unwrap();
    let [start, end, density] =
        ["start", "end", "density"].map(|name| column(&observables, "free_times", name));
    // 1; 1.1 twice (discs 0 and 2); 3.15; and 5.25 of disc 1.
    assert_eq!((start[0], end[0], density[0]), (1.0, 1.125, 3.0 / 5.0 / 0.125));
    let shares: Vec<f64> = (0..start.len()).map(|bin| density[bin] * (end[bin] - start[bin])).collect();
    let bin = |time: f64| start.iter().rposition(|start| *start <= time).unwrap();
    assert!(is_close(shares[bin(3.15)], 0.2) && is_close(shares[bin(5.25)], 0.2));
    assert!(is_close(shares.iter().sum(), 1.0));
}

#[test]
fn walls_feel_a_disc_as_its_bounces_say() {
    // One disc along y between walls: an impulse of 2 m v each (L − 2r)/v, on walls of 2 (4 + 5).
    let mut observables = observe("pressure");
    let mut gas = Gas::new([4.0, 5.0], [false; 2], vec![Vec2::new(2.0, 2.0)]);
    gas.velocities = vec![Vec2::new(0.0, SPEED)];
    gas.masses = vec![MASS];
    let period = 4.0 / SPEED;
    for k in 0..3 {
        observables.sample(&gas.at(2.0 * period * f64::from(k))).unwrap();
        bounce(&mut observables, 2.0 * period * f64::from(k) + 1.0, 0, 2.0 * MASS * SPEED);
        bounce(&mut observables, 2.0 * period * f64::from(k) + 2.0, 0, 2.0 * MASS * SPEED);
    }
    assert!(is_close(value(&observables, "wall_pressure"), 2.0 * MASS * SPEED / period / 18.0));
    assert!(is_close(value(&observables, "temperature"), 0.5 * MASS * SPEED * SPEED));
    assert_eq!(value(&observables, "compressibility_factor"), 1.0);
}

#[test]
fn where_one_axis_is_periodic_only_the_other_has_walls() {
    let mut observables = observe("pressure");
    let gas = Gas::new([4.0, 5.0], [true, false], vec![Vec2::new(2.0, 2.0), Vec2::new(1.0, 1.0)]);
    observables.sample(&gas.at(0.0)).unwrap();
    bounce(&mut observables, 0.5, 0, 3.0);
    observables.sample(&gas.at(1.0)).unwrap();
    assert!(is_close(value(&observables, "wall_pressure"), 3.0 / 8.0));
    assert_eq!(value(&observables, "degrees_of_freedom"), 3.0);
}

#[test]
fn the_virial_takes_the_radii_of_those_who_collide() {
    let mut observables = observe("pressure");
    let mut gas =
        Gas::new([4.0, 5.0], [false; 2], vec![Vec2::new(2.0, 2.0), Vec2::new(1.0, 1.0), Vec2::ZERO]);
    gas.radii = vec![0.1, 0.2, 0.4];
    observables.sample(&gas.at(0.0)).unwrap();
    collide(&mut observables, 0.5, (0, 2), 3.0);
    collide(&mut observables, 0.6, (2, 1), 5.0);
    observables.sample(&gas.at(1.0)).unwrap();
    // Three discs with v = 1: kT = 1/2.
    let z = 1.0 + (3.0 * 0.5 + 5.0 * 0.6) / (2.0 * 3.0 * 0.5);
    assert!(is_close(value(&observables, "compressibility_factor"), z));
    assert_eq!(quantity(&observables, "compressibility_factor").expected, None);
}

#[test]
fn the_equation_of_state_is_the_table_of_its_authors() {
    let table = [
        (0.05, 1.108388),
        (0.1, 1.236144),
        (0.2, 1.570366),
        (0.3, 2.063261),
        (0.4, 2.829331),
        (0.5, 4.106364),
        (0.6, 6.455337),
    ];
    for (packing_fraction, z) in table {
        let found = compressibility(packing_fraction).unwrap();
        assert!((found - z).abs() < 1e-6, "{packing_fraction}: {found}");
    }
    assert_eq!(
        (compressibility(0.0), compressibility(0.7), compressibility(f64::NAN)),
        (Some(1.0), None, None)
    );
}
