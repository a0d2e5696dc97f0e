//! What can be asked for, and what is refused.

use crate::kit::{Gas, observe};
use carom::geometry::Vec2;
use carom::observe::{NAMES, Observables, ObserveError, Request};
use serde_json::json;

fn refusal(request: Request) -> String {
    Observables::new(&[request]).unwrap_err().to_string()
}

fn two() -> Gas {
    Gas::new([4.0, 5.0], [true; 2], vec![Vec2::new(2.0, 2.0), Vec2::new(1.0, 1.0)])
}

#[test]
fn every_name_makes_an_observable_of_that_name() {
    let mut all = Observables::new(&NAMES.map(Request::new)).unwrap();
    assert!(all.results().is_empty());
    let positions = (0..400).map(|k| Vec2::new(f64::from(k % 20), f64::from(k / 20))).collect();
    let mut gas = Gas::new([20.0, 20.0], [true; 2], positions);
    gas.velocities[0] = Vec2::new(0.0, 2.0);
    all.sample(&gas.at(0.0)).unwrap();
    let names: Vec<&str> = all.results().iter().map(|results| results.name).collect();
    assert_eq!(names, NAMES);
}

#[test]
fn columns_of_a_curve_are_of_one_length() {
    let mut all = Observables::new(&NAMES.map(Request::new)).unwrap();
    let positions = (0..400).map(|k| Vec2::new(f64::from(k % 20), f64::from(k / 20))).collect();
    let mut gas = Gas::new([20.0, 20.0], [true; 2], positions);
    gas.velocities[0] = Vec2::new(0.0, 2.0);
    all.sample(&gas.at(0.0)).unwrap();
    all.sample(&gas.at(1.0)).unwrap();
    for curve in all.results().iter().flat_map(|results| &results.curves) {
        let lengths: Vec<usize> = curve.columns.iter().map(|column| column.values.len()).collect();
        assert!(lengths.iter().all(|length| *length == lengths[0]), "{}: {lengths:?}", curve.name);
    }
}

#[test]
fn unknown_names_and_options_are_told_with_what_is_known() {
    let text = refusal(Request::new("presure"));
    assert!(text.contains("\"presure\"; did you mean pressure? known: pressure, collision_rate,"), "{text}");
    let text = refusal(Request::new("zzz"));
    assert!(text.contains("\"zzz\"; known: pressure"), "{text}");
    let text = refusal(Request::new("radial_distribution").with("binwidth", 0.1));
    assert_eq!(
        text,
        "radial_distribution has no option \"binwidth\"; did you mean bin_width? known: range, bin_width"
    );
    let text = refusal(Request::new("psi6").with("cutoff", 1.5));
    assert_eq!(text, "psi6 has no option \"cutoff\"; it has none");
}

#[test]
fn values_that_an_option_cannot_have_are_refused_in_words() {
    for (name, option, value, part) in [
        ("speeds", "bins", json!(0), "bins must be 1 at least"),
        ("speeds", "bins", json!("many"), "bins: invalid type"),
        ("speeds", "largest", json!(-1.0), "largest must be a positive speed"),
        ("h_function", "ring", json!(0.0), "ring must be"),
        ("h_function", "points", json!(7), "points must be an even number"),
        ("temperature_profile", "axis", json!("z"), "axis: unknown variant `z`, expected `x` or `y`"),
        ("temperature_profile", "bins", json!(0), "bins must be"),
        ("radial_distribution", "range", json!(0.9), "range must be"),
        ("radial_distribution", "bin_width", json!(0.0), "bin_width must be"),
        ("diffusion", "longest", json!(1), "longest must be"),
        ("diffusion", "origins", json!(0), "origins must be"),
        ("diffusion", "lags", json!("squares"), "lags: unknown variant"),
        ("kinetic_energy", "restitution", json!(1.5), "restitution must be from 0 to 1"),
    ] {
        let text = refusal(Request::new(name).with(option, value));
        assert!(text.starts_with(name) && text.contains(part), "{text}");
    }
}

#[test]
fn a_request_reads_as_one_table() {
    let request: Request = serde_json::from_value(json!({ "name": "speeds", "bins": 10 })).unwrap();
    assert_eq!(request, Request::new("speeds").with("bins", 10));
}

#[test]
fn samples_come_at_equal_intervals() {
    let mut observables = observe("pressure");
    let gas = two();
    observables.sample(&gas.at(1.0)).unwrap();
    assert!(matches!(observables.sample(&gas.at(1.0)), Err(ObserveError::UnequalInterval { .. })));
    observables.sample(&gas.at(1.5)).unwrap();
    observables.sample(&gas.at(2.0)).unwrap();
    let due = ObserveError::UnequalInterval { time: 2.6, due: 2.5 };
    assert_eq!(observables.sample(&gas.at(2.6)), Err(due));
    observables.sample(&gas.at(2.5)).unwrap();
    assert_eq!(observables.samples(), 4);
}

#[test]
fn snapshots_that_cannot_be_are_refused_and_leave_no_trace() {
    let mut observables = observe("speeds");
    let mut gas = two();
    gas.velocities[0] = Vec2::new(0.0, 1.0);
    observables.sample(&gas.at(0.0)).unwrap();
    let before = observables.clone();
    let spoil: [fn(&mut Gas); 6] = [
        |gas| gas.positions[0].x = f64::NAN,
        |gas| gas.masses[1] = 0.0,
        |gas| gas.radii.truncate(1),
        |gas| gas.size[0] = 5.0,
        |gas| gas.periods = [false; 2],
        |gas| *gas = Gas::new(gas.size, gas.periods, vec![Vec2::ZERO; 3]),
    ];
    for spoil in spoil {
        let mut spoilt = gas.clone();
        spoil(&mut spoilt);
        assert!(matches!(observables.sample(&spoilt.at(1.0)), Err(ObserveError::BadSnapshot { .. })));
        assert_eq!(observables, before);
    }
}

#[test]
fn what_cannot_be_observed_is_told_at_the_first_sample() {
    let mut points = two();
    points.radii = vec![0.0; 2];
    let error = observe("radial_distribution").sample(&points.at(0.0)).unwrap_err();
    assert!(matches!(error, ObserveError::Unfit { observable: "radial_distribution", .. }));
    let mut still = two();
    still.velocities = vec![Vec2::ZERO; 2];
    assert!(observe("speeds").sample(&still.at(0.0)).is_err());
    let law = Request::new("kinetic_energy").with("restitution", 0.9);
    assert!(Observables::new(&[law]).unwrap().sample(&points.at(0.0)).is_err());
    let lonely = Gas::new([3.0, 3.0], [true; 2], vec![Vec2::ZERO]);
    assert!(observe("pressure").sample(&lonely.at(0.0)).is_err());
}

#[test]
fn only_what_lives_on_events_wants_them() {
    let wants: Vec<&str> = NAMES.into_iter().filter(|name| observe(name).needs_events()).collect();
    assert_eq!(wants, ["pressure", "collision_rate", "free_path"]);
}
