//! Order: discs beyond freezing stay the crystal that they begin as, and those of a fluid have none.

use crate::gases::{gas, number, run};
use carom::observe::Request;
use carom::simulate::Sampling;
use core::f64::consts::PI;

const SAMPLING: Sampling = Sampling { equilibrate: 100.0, interval: None };

#[test]
fn a_crystal_stays_a_crystal_with_its_shells_of_neighbours() {
    let packing_fraction = 0.75;
    // 24 columns by 28 rows of a hexagonal lattice, so that both sides are whole numbers of its rows.
    let scenario = gas(200_000, "n = 672\npacking_fraction = 0.75\nstart = 'hexagonal'\nseed = 3", "");
    let radial = Request::new("radial_distribution").with("range", 4).with("bin_width", 0.02);
    let (_, results) = run(&scenario, &[Request::new("psi6"), radial], &SAMPLING);
    let (global, error) = number(&results[0], "global");
    // Each disc is off its site by some tenth of the spacing, which takes a quarter of the order, but none of the direction.
    assert!(global > 0.65 && error < 0.02, "{global} ± {error}");
    let (local, _) = number(&results[0], "local");
    assert!((global / local - 1.0).abs() < 0.1, "one direction everywhere: {global} {local}");

    let density = 4.0 * packing_fraction / PI;
    let spacing = (2.0 / (3.0_f64.sqrt() * density)).sqrt();
    let [r, g] = ["r", "g"].map(|name| results[1].column("radial_distribution", name).unwrap());
    let width = r[1] - r[0];
    // A shell: its discs, and their mean distance, between two distances in spacings.
    let shell = |from: f64, to: f64| {
        let within = || r.iter().zip(g).filter(|(r, _)| (from * spacing..to * spacing).contains(*r));
        let discs: f64 = within().map(|(r, g)| density * 2.0 * PI * r * width * g).sum();
        let distances: f64 = within().map(|(r, g)| density * 2.0 * PI * r * r * width * g).sum();
        (discs, distances / discs / spacing)
    };
    // Six at one spacing, then six at √3 and six at 2, which overlap. Discs that swing are a little further apart than
    // their sites are: half of the square of what they swing across, 1 %. Those at a border take part in both.
    let (nearest, distance) = shell(0.0, 1.4);
    assert!((nearest - 6.0).abs() < 0.15, "{nearest}");
    assert!((distance - 1.0).abs() < 0.02, "{distance}");
    let (next, distance) = shell(1.4, 2.32);
    assert!((next - 12.0).abs() < 0.4, "{next}");
    assert!((distance - 0.5 * (3.0_f64.sqrt() + 2.0)).abs() < 0.03, "{distance}");
}

#[test]
fn a_fluid_has_no_direction() {
    let scenario = gas(400_000, "n = 672\npacking_fraction = 0.6\nstart = 'hexagonal'\nseed = 3", "");
    let (_, results) = run(&scenario, &[Request::new("psi6")], &SAMPLING);
    // Discs that know of some ten others have a sum of 67 independent directions: about 0.6/√67.
    let (global, _) = number(&results[0], "global");
    assert!(global < 0.15, "{global}");
    let (local, _) = number(&results[0], "local");
    assert!(local > 0.3, "each has six neighbours or so: {local}");
}
