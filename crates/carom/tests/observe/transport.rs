//! How discs forget their velocities and wander, against Boltzmann and Enskog.

use crate::gases::{gas, number, run};
use carom::observe::Request;
use carom::simulate::Sampling;
use core::f64::consts::PI;

#[test]
fn a_velocity_is_forgotten_at_first_at_the_rate_of_collisions_whatever_the_density() {
    // A collision takes the component of the velocity along its normal, of which ⟨v·Δv⟩ = −½⟨u²⟩ = −2kT/m, with u the
    // closing speed: in the mean of all collisions as much as ⟨v²⟩. So d ln C/dt = −w at the beginning.
    for (packing_fraction, rate) in [(0.1, 0.53292), (0.3, 2.39952), (0.5, 7.01031)] {
        let keys = format!("n = 1000\npacking_fraction = {packing_fraction}\nseed = 12");
        let lag = 0.05 / rate;
        let diffusion =
            Request::new("diffusion").with("longest", 2).with("lags", "linear").with("origins", 2);
        let sampling = Sampling { equilibrate: 30.0, interval: Some(lag) };
        let (_, results) =
            run(&gas(60_000, &keys, ""), &[diffusion, Request::new("collision_rate")], &sampling);
        let column = |name: &str| results[0].column("diffusion", name).unwrap();
        let (time, correlation) = (column("lag"), column("velocity_autocorrelation"));
        let (seen, _) = number(&results[1], "collision_rate");
        let forgotten = (correlation[0] / correlation[1]).ln() / time[1];
        // Twice the number of collisions counts, some 90 000, each of which may take up to a few times the mean: 2 %.
        assert!((forgotten / seen - 1.0).abs() < 0.02, "{packing_fraction}: {forgotten} {seen}");
        assert!((seen / rate - 1.0).abs() < 0.02, "{packing_fraction}: {seen} {rate}");
    }
}

#[test]
fn a_thin_gas_diffuses_as_enskog_says() {
    // D = (1/2ρσg) √(kT/πm), the first term of his expansion; g(σ) = 1.08388 at a packing fraction of 0.05. The terms that
    // follow add some 2 %, and velocities that come back a few per cent more.
    let (packing_fraction, contact) = (0.05, 1.08388);
    let enskog = 1.0 / (2.0 * (4.0 * packing_fraction / PI) * contact * PI.sqrt());
    let keys = format!("n = 1000\npacking_fraction = {packing_fraction}\nseed = 6");
    let diffusion = Request::new("diffusion").with("longest", 40).with("lags", "linear").with("origins", 8);
    let sampling = Sampling { equilibrate: 20.0, interval: Some(1.0) };
    let (_, results) = run(&gas(150_000, &keys, ""), &[diffusion], &sampling);
    for name in ["diffusion_from_displacement", "diffusion_from_velocities"] {
        let (value, error) = number(&results[0], name);
        assert!(error < 0.03 * enskog, "{name}: {value} ± {error} says little");
        let ratio = value / enskog;
        let noise = 4.0 * error / enskog;
        assert!(ratio > 1.0 - noise && ratio < 1.08 + noise, "{name}: {value} ± {error}, {enskog}");
    }
}
