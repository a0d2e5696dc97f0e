//! g(r) and ψ₆ of lattices and of points without any order.

use crate::kit::{Gas, assert_within_errors, column, observe, only, quantity, value};
use carom::geometry::Vec2;
use carom::observe::{Observables, ObserveError, Request};
use carom::random::Random;
use core::f64::consts::PI;

fn radial(range: f64, bin_width: f64) -> Observables {
    let request = Request::new("radial_distribution").with("range", range).with("bin_width", bin_width);
    Observables::new(&[request]).unwrap()
}

/// Holds g of random points against a constant: no bin is five errors off, and one in twenty is two off.
fn assert_flat(periods: [bool; 2], truth: f64) {
    let mut random = Random::new(11, "ideal gas");
    let mut observables = radial(4.0, 0.1);
    for sample in 0..200 {
        let gas = Gas::random(400, [24.0, 20.0], periods, &mut random);
        observables.sample(&gas.at(f64::from(sample))).unwrap();
    }
    let [g, error] = ["g", "g_error"].map(|name| column(&observables, "radial_distribution", name));
    assert_eq!(g.len(), 40);
    let off: Vec<f64> = g.iter().zip(&error).map(|(g, error)| (g - truth).abs() / error).collect();
    assert!(off.iter().all(|off| *off < 5.0), "{off:?}");
    assert!(off.iter().filter(|off| **off > 2.0).count() <= 6, "{off:?}");
    assert!(error[39] < 0.01, "{error:?}");
    assert_within_errors(&quantity(&observables, "contact_value"), truth, 0.05);
}

#[test]
fn points_without_order_have_g_of_one_in_a_periodic_box() {
    assert_flat([true, true], 1.0 - 1.0 / 400.0);
}

#[test]
fn points_without_order_have_g_of_one_between_walls() {
    assert_flat([false, false], 1.0 - 1.0 / 400.0);
    assert_flat([true, false], 1.0 - 1.0 / 400.0);
}

#[test]
fn a_triangular_lattice_has_its_shells_of_neighbours_and_nothing_between() {
    let spacing = 1.135;
    let gas = Gas::triangular(spacing, 12, 7);
    let mut observables = radial(4.0, 0.02);
    observables.sample(&gas.at(0.0)).unwrap();
    let [r, g] = ["r", "g"].map(|name| column(&observables, "radial_distribution", name));
    let density = value(&observables, "density");
    assert!((density * 0.5 * 3.0_f64.sqrt() * spacing * spacing - 1.0).abs() < 1e-12);
    // Squared distances over that of neighbours, and how many are there.
    let shells = [(1.0, 6.0), (3.0, 6.0), (4.0, 6.0), (7.0, 12.0), (9.0, 6.0), (12.0, 6.0)];
    for (r, g) in r.iter().zip(&g) {
        let ring = PI * 0.02 * 2.0 * r;
        let is_here = |shell: &&(f64, f64)| (shell.0.sqrt() * spacing - r).abs() < 0.01;
        let expected = shells.iter().find(is_here).map_or(0.0, |shell| shell.1);
        assert!((g * density * ring - expected).abs() < 1e-9, "at {r}");
    }
}

#[test]
fn the_diameter_is_an_edge_of_a_bin_whatever_its_width() {
    for width in [0.01, 0.03, 0.1, 0.3] {
        let mut observables = radial(3.0, width);
        observables.sample(&Gas::triangular(1.0, 8, 5).at(0.0)).unwrap();
        let r = column(&observables, "radial_distribution", "r");
        let offset = ((r[0] - 0.5 * width - 1.0) / width).abs();
        assert!((offset - offset.round()).abs() < 1e-9, "{width}: {offset}");
        assert!((r.last().unwrap() + 0.5 * width - 3.0).abs() < width, "{width}");
    }
}

#[test]
fn a_range_that_the_box_has_no_room_for_is_refused() {
    let gas = Gas::triangular(1.2, 8, 5);
    let error = radial(5.0, 0.05).sample(&gas.at(0.0)).unwrap_err();
    assert!(matches!(&error, ObserveError::Unfit { observable: "radial_distribution", .. }), "{error}");
    assert!(radial(4.3, 0.05).sample(&gas.at(0.0)).is_ok());
    let walled = Gas { periods: [false; 2], ..gas };
    assert!(radial(4.3, 0.05).sample(&walled.at(0.0)).is_err());
    assert!(radial(3.5, 0.05).sample(&walled.at(0.0)).is_ok());
}

/// For each bin the discs in it about middles, from all pairs with all their images; and how many middles there are.
fn counts_of_all_pairs(gas: &Gas, range: f64, bin_width: f64) -> (f64, Vec<f64>) {
    let diameter = gas.radii.iter().sum::<f64>() / gas.radii.len() as f64 * 2.0;
    let contact = (1.0 / bin_width * (1.0 + 1e-12)) as usize;
    let count = contact + ((range - 1.0) / bin_width * (1.0 + 1e-12)) as usize;
    let width = bin_width * diameter;
    let start = diameter - contact as f64 * width;
    let margin = start + count as f64 * width + 0.5 * diameter;
    let is_middle = |place: &Vec2<f64>| {
        (0..2).all(|axis| {
            let along = place.to_f64()[axis];
            gas.periods[axis] || (along >= margin && along <= gas.size[axis] - margin)
        })
    };
    let least = |way: f64, axis: usize| {
        if gas.periods[axis] { way - (way / gas.size[axis]).round() * gas.size[axis] } else { way }
    };
    let middles: Vec<&Vec2<f64>> = gas.positions.iter().filter(|place| is_middle(place)).collect();
    let mut counts = vec![0.0; count];
    for (middle, other) in
        middles.iter().flat_map(|middle| gas.positions.iter().map(move |other| (middle, other)))
    {
        let way = *other - **middle;
        let distance = Vec2::new(least(way.x, 0), least(way.y, 1)).norm();
        let bin = ((distance - start) / width).floor();
        if !core::ptr::eq(*middle, other) && bin >= 0.0 && bin < count as f64 {
            counts[bin as usize] += 1.0;
        }
    }
    (middles.len() as f64, counts)
}

#[test]
fn pairs_in_bins_are_those_that_all_pairs_give() {
    let mut random = Random::new(17, "pairs");
    for (case, periods) in [[true; 2], [true, false], [false, true], [false; 2]].into_iter().enumerate() {
        for (count, size, range, bin_width) in [
            (1500, [40.0, 33.0], 5.0, 0.01),
            (1500, [40.0, 33.0], 5.0, 0.03),
            // Boxes of as few cells as there can be, a range that is half of the box, and one of many distances in a piece.
            (300, [10.0, 31.0], 3.99, 0.01),
            (200, [9.01, 9.2], 4.5, 0.013),
            (700, [61.0, 61.0], 15.0, 0.001),
            // So fine that single precision never says enough.
            (150, [20.0, 24.0], 7.0, 1e-5),
        ] {
            for spread in [0.0, 0.8] {
                let mut gas = Gas::random(count, size, periods, &mut random);
                // Some rounds further on, and radii of one mean.
                let rounds = |random: &mut Random, axis: usize| {
                    if periods[axis] { (10.0 * random.unit() - 5.0).floor() * size[axis] } else { 0.0 }
                };
                for place in &mut gas.positions {
                    *place = *place + Vec2::new(rounds(&mut random, 0), rounds(&mut random, 1));
                }
                gas.radii.iter_mut().enumerate().for_each(|(k, radius)| {
                    *radius += if k % 2 == 0 { 0.5 * spread } else { -0.5 * spread };
                });
                let mut observables = radial(range, bin_width);
                if observables.sample(&gas.at(0.0)).is_err() {
                    continue; // a walled box with no room for the range
                }
                let [r, g] = ["r", "g"].map(|name| column(&observables, "radial_distribution", name));
                let density = value(&observables, "density");
                let (middles, counts) = counts_of_all_pairs(&gas, range, bin_width);
                assert_eq!(g.len(), counts.len());
                assert!(counts.iter().sum::<f64>() > 0.0);
                for ((r, g), expected) in r.iter().zip(&g).zip(&counts) {
                    let found = g * density * middles * PI * 2.0 * r * bin_width;
                    let off = (found - expected).abs();
                    assert!(off < 1e-6, "{case} {size:?} {range} {bin_width} at {r}: {found} {expected}");
                }
            }
        }
    }
}

fn psi6(gas: &Gas) -> [f64; 2] {
    let mut observables = observe("psi6");
    observables.sample(&gas.at(0.0)).unwrap();
    ["global", "local"].map(|name| value(&observables, name))
}

#[test]
fn a_triangular_lattice_has_psi6_of_one_across_the_periodic_sides_too() {
    for (columns, rows) in [(12, 7), (3, 2), (2, 1), (1, 1)] {
        let found = psi6(&Gas::triangular(1.1, columns, rows));
        assert!(found.iter().all(|psi6| (psi6 - 1.0).abs() < 1e-9), "{columns} x {rows}: {found:?}");
    }
}

#[test]
fn a_square_lattice_has_psi6_of_zero() {
    let site = |k: usize| Vec2::new(0.1 + (k % 9) as f64, -2.0 + (k / 9) as f64);
    let found = psi6(&Gas::new([9.0, 9.0], [true; 2], (0..81).map(site).collect()));
    assert!(found.iter().all(|psi6| psi6.abs() < 1e-9), "{found:?}");
}

#[test]
fn two_crystals_that_are_turned_cancel_in_the_global_order_only() {
    // A triangular lattice, and one turned by 30 degrees (its sides exchanged), far apart in a box with walls.
    let one = Gas::triangular(1.0, 20, 10);
    let mut positions: Vec<Vec2<f64>> = one
        .positions
        .iter()
        .map(|place| Vec2::new(place.x + 1.0, place.y + 3.0 * one.size[1] + 1.0))
        .collect();
    let turned: Vec<Vec2<f64>> = positions.iter().map(|place| Vec2::new(place.y + 30.0, place.x)).collect();
    positions.extend(turned);
    let [global, local] = psi6(&Gas::new([60.0, 25.0], [false; 2], positions));
    assert!(global < 0.05 && local > 0.7, "{global} {local}");
}

/// The length of what the line half way to one neighbour shares with the half planes of all others, and with the box.
fn edge(way: Vec2<f64>, others: &[Vec2<f64>], sides: &[(Vec2<f64>, f64)]) -> f64 {
    let (middle, along) = (way * 0.5, way.left().unit());
    let planes = others.iter().map(|other| (*other, 0.5 * other.norm_squared())).chain(sides.iter().copied());
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for (normal, bound) in planes {
        // normal · (middle + t along) <= bound
        let (slope, room) = (normal.dot(along), bound - normal.dot(middle));
        if slope > 0.0 {
            to = to.min(room / slope);
        } else if slope < 0.0 {
            from = from.max(room / slope);
        } else if room < 0.0 {
            return 0.0;
        }
    }
    (to - from).max(0.0)
}

/// ψ₆ by another way: each edge by itself, with all images of all discs.
fn psi6_edge_by_edge(gas: &Gas) -> [f64; 2] {
    let shifts = |axis: usize| if gas.periods[axis] { -2..=2 } else { 0..=0 };
    let mut images = Vec::new();
    for (x, y) in shifts(0).flat_map(|x| shifts(1).map(move |y| (x, y))) {
        let shift = Vec2::new(f64::from(x) * gas.size[0], f64::from(y) * gas.size[1]);
        images.extend(gas.positions.iter().map(|place| *place + shift));
    }
    let (mut sum, mut local) = (Vec2::ZERO, 0.0);
    for centre in &gas.positions {
        let mut sides = Vec::new();
        for (axis, normal) in [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)].into_iter().enumerate() {
            if !gas.periods[axis] {
                let place = centre.to_f64()[axis];
                sides.extend([(normal, gas.size[axis] - place), (-normal, place)]);
            }
        }
        let ways: Vec<Vec2<f64>> =
            images.iter().map(|image| *image - *centre).filter(|way| way.norm() > 0.0).collect();
        let (mut own, mut total) = (Vec2::ZERO, 0.0);
        for (k, way) in ways.iter().enumerate() {
            let others: Vec<Vec2<f64>> = [&ways[..k], &ways[k + 1..]].concat();
            let length = edge(*way, &others, &sides);
            let angle = 6.0 * way.y.atan2(way.x);
            own = own + Vec2::new(angle.cos(), angle.sin()) * length;
            total += length;
        }
        sum = sum + own * (1.0 / total);
        local += own.norm() / total;
    }
    let count = gas.positions.len() as f64;
    [sum.norm() / count, local / count]
}

#[test]
fn psi6_agrees_with_edges_found_one_by_one() {
    let mut random = Random::new(6, "edges");
    for periods in [[true; 2], [true, false], [false; 2]] {
        for (count, size) in
            [(2, [3.0, 3.0]), (3, [3.0, 9.0]), (12, [4.0, 3.0]), (25, [20.0, 2.0]), (40, [7.0, 7.0])]
        {
            let gas = Gas::random(count, size, periods, &mut random);
            let (found, expected) = (psi6(&gas), psi6_edge_by_edge(&gas));
            for k in 0..2 {
                assert!((found[k] - expected[k]).abs() < 1e-9, "{periods:?} {count}: {found:?} {expected:?}");
            }
        }
    }
}

#[test]
fn points_without_order_have_no_global_psi6() {
    let mut random = Random::new(5, "psi6");
    let mut observables = observe("psi6");
    for sample in 0..20 {
        let gas = Gas::random(900, [30.0, 30.0], [true; 2], &mut random);
        observables.sample(&gas.at(f64::from(sample))).unwrap();
    }
    // Independent phases would give 1/900 × mean |ψ₆|²; neighbours have edges in common, so a little else.
    let found = only(&observables);
    let global = found.quantity("global_square").unwrap().value.unwrap();
    let local = found.quantity("local").unwrap().value.unwrap();
    assert!(global < 0.003 && (0.3..0.6).contains(&local), "{global} {local}");
}
