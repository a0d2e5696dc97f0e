//! What is saved and read goes on with the same bits.

use crate::kit::{Gas, bounce, collide, gaussian};
use carom::observe::{NAMES, Observables, Request};
use carom::random::Random;

fn saved(observables: &Observables) -> String {
    serde_json::to_string(observables).unwrap()
}

/// A gas that is pushed about at random, with events as many; `between` may do what it likes with the observables.
fn watch(radii: &[f64], mut between: impl FnMut(Observables) -> Observables) -> Observables {
    let mut random = Random::new(41, "resumption");
    let mut gas = Gas::random(radii.len(), [8.0, 9.0], [true, false], &mut random);
    gas.radii = radii.to_vec();
    let mut requests = NAMES.map(Request::new).to_vec();
    requests.push(Request::new("diffusion").with("longest", 4).with("lags", "linear"));
    requests.retain(|request| request.name != "radial_distribution");
    requests.push(Request::new("radial_distribution").with("range", 3.0).with("bin_width", 0.25));
    requests.push(Request::new("h_function").with("points", 4));
    let mut observables = Observables::new(&requests).unwrap();
    for sample in 0..23 {
        let time = 0.3 * f64::from(sample);
        gas.heat(1.0, &mut random);
        observables.sample(&gas.at(time)).unwrap();
        observables = between(observables);
        for k in 0..40 {
            let now = time + 0.3 * random.unit();
            let pair = (random.below(30) as u32, 30 + random.below(30) as u32);
            collide(
                &mut observables,
                now.max(time + 0.007 * f64::from(k)),
                pair,
                gaussian(&mut random).x.abs(),
            );
            bounce(&mut observables, now, pair.0, random.unit());
            if k == 20 {
                observables = between(observables);
            }
        }
        gas.fly(0.3);
        gas.positions.iter_mut().for_each(|place| place.y = place.y.clamp(0.5, 8.5));
    }
    observables
}

#[test]
fn saving_and_reading_at_any_time_changes_no_bit() {
    for radii in [vec![0.3; 60], (0..60).map(|k| 0.2 + 0.003 * f64::from(k)).collect()] {
        let whole = watch(&radii, |observables| observables);
        let pieces = watch(&radii, |observables| serde_json::from_str(&saved(&observables)).unwrap());
        assert_eq!(whole, pieces);
        assert_eq!(saved(&whole), saved(&pieces));
    }
}

#[test]
fn what_is_kept_does_not_grow_with_the_run() {
    let mut sizes = Vec::new();
    watch(&[0.3; 60], |observables| {
        sizes.push(saved(&observables).len());
        observables
    });
    // Levels of blocks and curves over time grow with the logarithm, up to their bounds; the diffusion's origins are
    // first.
    assert!(sizes[45] < 3 * sizes[10], "{sizes:?}");
}
