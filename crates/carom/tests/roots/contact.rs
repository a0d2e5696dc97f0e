//! The contact rule from every kind of start, and the validation cases E1 to E3.

use carom::roots::{Polynomial, Quadratic, closing_crossings, first_contact, first_turn};
use proptest::prelude::*;

const DELTA: f64 = 1e-10;

fn polynomial(coefficients: &[f64]) -> Polynomial<f64> {
    let mut all = [0.0; 5];
    all[..coefficients.len()].copy_from_slice(coefficients);
    Polynomial::new(all)
}

fn contact(coefficients: &[f64]) -> Option<f64> {
    first_contact(&polynomial(coefficients), DELTA, |_| true)
}

/// The contact, refused before `s`.
fn contact_after(coefficients: &[f64], s: f64) -> Option<f64> {
    first_contact(&polynomial(coefficients), DELTA, |t| t >= s)
}

#[track_caller]
fn assert_close(found: Option<f64>, expected: f64, tolerance: f64) {
    assert!(found.is_some_and(|s| (s - expected).abs() <= tolerance), "{found:?}, expected {expected}");
}

/// The squared gap of two balls of radius `r`: offset, relative velocity, half the relative acceleration.
fn ball_ball(offset: [f64; 2], w: [f64; 2], k: [f64; 2], r: f64) -> Polynomial<f64> {
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    // Δ·Δ − (2r)² without cancellation in the component across
    let start = offset[0] * offset[0] + (offset[1] - 2.0 * r) * (offset[1] + 2.0 * r);
    let quadratic = dot(w, w) + 2.0 * dot(k, offset);
    Polynomial::new([start, 2.0 * dot(w, offset), quadratic, 2.0 * dot(k, w), dot(k, k)])
}

#[test]
fn e1_rolling_ball_meets_a_ball_at_rest() {
    let gap = [0.247550408125, -1.0, 1.04905, -0.0981, 0.0024059025];
    assert_close(contact(&gap), 0.460927525905665, 1e-15);
    let (r, a) = (0.028575, 0.0981);
    let same = ball_ball([0.5, r], [-1.0, 0.0], [0.5 * a, 0.0], r);
    assert_close(first_contact(&same, DELTA, |_| true), 0.460927525905665, 1e-14);
}

#[test]
fn e2_graze_of_two_discs_is_hit_inside_and_missed_outside() {
    let r = 0.5;
    for k in 3..=15 {
        for (side, is_hit) in [(-1.0, true), (1.0, false)] {
            let p = 2.0 * r * (1.0 + side * 10f64.powi(-k));
            let gap = ball_ball([1.5, p], [-1.0, 0.0], [0.0, 0.0], r);
            let found = first_contact(&gap, DELTA, |_| true);
            assert_eq!(found.is_some(), is_hit, "k = {k}, side {side}");
            let half_chord = (2.0 * 10f64.powi(-k)).sqrt();
            // Δs = Δg / |g′| = (rounding of g, some 1e-15 × 2) / (2 half_chord)
            found.inspect(|s| {
                assert!((s - (1.5 - half_chord)).abs() < 1e-3 * half_chord + 1e-14 / half_chord)
            });
        }
    }
}

#[test]
fn e2_graze_of_a_rolling_ball_is_hit_as_far_as_rounding_tells() {
    let r = 0.5;
    for k in 3..=15 {
        let relative = 10f64.powi(-k);
        let gap =
            |side: f64| ball_ball([3.0, 2.0 * r * (1.0 + side * relative)], [-1.0, 0.0], [0.02, 0.0], r);
        assert_eq!(first_contact(&gap(1.0), DELTA, |_| true), None, "k = {k}");
        let inside = gap(-1.0);
        let closest = first_turn(&Polynomial::new(inside.coefficients.map(|a| -a))).unwrap();
        let is_visible = 2.0 * relative > inside.rounding_bound(closest);
        assert!(is_visible || k > 13);
        assert_eq!(first_contact(&inside, DELTA, |_| true).is_some(), is_visible, "k = {k}");
    }
}

#[test]
fn e3_equal_accelerations_leave_a_quadratic_without_false_contact() {
    let r = 0.03;
    // Parallel rollers, one chasing the other with the same deceleration: apart for ever, or meeting.
    let apart = ball_ball([0.2, 0.0], [0.0, 0.0], [0.0, 0.0], r);
    assert_eq!(first_contact(&apart, DELTA, |_| true), None);
    let chase = ball_ball([0.2, 0.0], [-0.5, 0.0], [0.0, 0.0], r);
    assert_close(first_contact(&chase, DELTA, |_| true), 0.28, 1e-15);
    let touching = ball_ball([0.06, 0.0], [0.0, 0.0], [0.0, 0.0], r);
    assert_eq!(first_contact(&touching, DELTA, |_| true), None);
}

#[test]
fn in_front_the_first_crossing_counts() {
    assert_eq!(contact(&[2.0, -3.0, 1.0]), Some(1.0));
    assert_eq!(contact(&[1.0, -2.0]), Some(0.5));
    assert_eq!(contact(&[1.0, 0.0, -4.0]), Some(0.5));
    assert_eq!(contact(&[1.0, 1.0, 1.0, 1.0, 1.0]), None);
    assert_eq!(contact(&[1.0, -2.0, 1.0]), None, "a graze is no contact");
    assert_eq!(contact(&[1.0, -1.0, 1.0]), None);
    assert_eq!(contact(&[1.0]), None);
}

#[test]
fn in_contact_and_closing_is_now() {
    for start in [0.0, 0.9 * DELTA, -0.9 * DELTA] {
        assert_eq!(contact(&[start, -1.0]), Some(0.0));
        assert_eq!(contact(&[start, -1.0, 5.0]), Some(0.0));
        assert_eq!(contact(&[start, 0.0, -1.0]), Some(0.0));
        assert_eq!(contact(&[start, 0.0, 0.0, -1.0, 9.0]), Some(0.0));
        assert_eq!(contact(&[start, 0.0, 0.0, 0.0, -1.0]), Some(0.0));
    }
}

#[test]
fn in_contact_and_at_relative_rest_is_nothing() {
    for start in [0.0, 0.9 * DELTA, -0.9 * DELTA] {
        assert_eq!(contact(&[start]), None);
    }
}

#[test]
fn in_contact_and_opening_waits_for_the_turn() {
    for start in [0.0, 0.9 * DELTA, -0.9 * DELTA] {
        assert_eq!(contact(&[start, 1.0]), None);
        assert_eq!(contact(&[start, 1.0, 1.0, 0.0, 3.0]), None);
        // Thrown up: comes back at 2 u / a.
        assert_close(contact(&[start, 2.0, -1.0]), 2.0, 2.0 * DELTA);
        assert_close(contact(&[start, 2.0, -1.0, 0.0, 1e-9]), 2.0, 1e-8);
        // s (s − 1) (s − 2): opens, closes at 1.
        assert_close(contact(&[start, 2.0, -3.0, 1.0]), 1.0, 2.0 * DELTA);
        // Rises from rest, 3 s² − s³.
        assert_close(contact(&[start, 0.0, 3.0, -1.0]), 3.0, DELTA);
    }
}

#[test]
fn in_contact_opening_but_never_out_of_contact_meets_at_the_turn() {
    // −5e-11 + 2e-11 s − 1e-11 s² stays negative; its turn is at s = 1.
    let quadratic = [-5e-11, 2e-11, -1e-11];
    assert_eq!(contact(&quadratic), Some(1.0));
    assert_close(contact(&[-5e-11, 2e-11, -1e-11, 0.0, -1e-20]), 1.0, 1e-8);
    assert_eq!(contact_after(&quadratic, 1.5), None);
}

#[test]
fn behind_waits_until_it_has_been_in_front() {
    assert_eq!(contact(&[-1.0, -1.0]), None);
    assert_eq!(contact(&[-1.0, 2.0]), None);
    assert_eq!(contact(&[-3.0, 4.0, -1.0]), Some(3.0));
    assert_eq!(contact(&[-1.0, 2.0, -1.0]), None, "touches from behind");
    // (s − 1) (s − 2) (s − 3): out at 1, in at 2 and out at 3; negated, in at 3 after out at 2.
    assert_close(contact(&[-6.0, 11.0, -6.0, 1.0]), 2.0, 1e-14);
    assert_close(contact(&[-24.0, 50.0, -35.0, 10.0, -1.0]), 2.0, 1e-13);
    assert_close(contact_after(&[-24.0, 50.0, -35.0, 10.0, -1.0], 2.5), 4.0, 1e-13);
}

#[test]
fn refused_contacts_give_way_to_later_ones() {
    // (s − 1)(s − 2)(s − 3)(s − 4)
    let gap = [24.0, -50.0, 35.0, -10.0, 1.0];
    assert_close(contact(&gap), 1.0, 1e-13);
    assert_close(contact_after(&gap, 2.0), 3.0, 1e-13);
    assert_eq!(contact_after(&gap, 3.5), None);
    // Closing in contact, refused: out again at 1, back at 2.
    assert_close(contact_after(&[0.0, -2.0, 3.0, -1.0], 0.1), 2.0, 1e-14);
    // A hair in front, closing, refused at 0: the zero itself still counts.
    assert_close(contact_after(&[5e-11, -1e-11], 1.0), 5.0, 1e-14);
    assert_close(contact_after(&[5e-11, -1e-11, 0.0, -1e-25], 1.0), 5.0, 1e-9);
}

#[test]
fn first_turn_is_the_first_maximum() {
    let turn = |coefficients: &[f64]| first_turn(&polynomial(coefficients));
    assert_eq!(turn(&[1.0, -1.0, 4.0]), Some(0.0));
    assert_eq!(turn(&[1.0, 2.0, -1.0]), Some(1.0));
    assert_eq!(turn(&[1.0, 2.0, 1.0]), None);
    assert_eq!(turn(&[1.0]), None);
    assert_close(turn(&[0.0, 2.0, -3.0, 1.0]), 1.0 - 1.0 / 3f64.sqrt(), 1e-15);
    // slope (s − 1)(s − 2)(s − 3) · 4, negated
    assert_close(turn(&[0.0, 24.0, -22.0, 8.0, -1.0]), 1.0, 1e-14);
    // the slope touches zero at 1 and stays positive: (s − 1)²
    assert_eq!(turn(&[0.0, 1.0, -1.0, 1.0 / 3.0]), None);
}

#[test]
fn nonsense_is_no_contact_and_does_not_hang() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..5 {
            for others in [0.0, 1.0, -1.0] {
                let mut coefficients = [others; 5];
                coefficients[place] = bad;
                let gap = Polynomial::new(coefficients);
                let found = first_contact(&gap, DELTA, |_| true);
                assert!(found.is_none_or(|s| s >= 0.0), "{coefficients:?}: {found:?}");
                let _ = closing_crossings(&gap, 0.0).count();
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn quadratic_and_polynomial_entry_give_the_same_bits(
        a in prop::array::uniform3(-10.0..10.0f64), is_touching in any::<bool>(), after in 0.0..2.0f64
    ) {
        let a = [if is_touching { a[0] * 2.0 * DELTA } else { a[0] }, a[1], a[2]];
        let short = Quadratic::new(a).first_contact(DELTA, |s| s >= after);
        let long = first_contact(&polynomial(&a), DELTA, |s| s >= after);
        prop_assert_eq!(short, long);
    }

    #[test]
    fn bernstein_proof_excludes_every_contact(
        a in prop::array::uniform5(-10.0..10.0f64), start in 0.0..40.0f64, horizon in 0.01..3.0f64
    ) {
        let gap = Polynomial::new([start, a[1], a[2], a[3], a[4]]);
        if gap.is_positive_until(horizon) {
            prop_assert!(first_contact(&gap, DELTA, |_| true).is_none_or(|s| s > horizon));
        }
        let b = gap.bernstein(horizon);
        let (least, greatest) = (b.iter().copied().fold(f64::MAX, f64::min), b.iter().copied().fold(f64::MIN, f64::max));
        let slack = gap.rounding_bound(horizon);
        for i in 0..=16 {
            let value = gap.value(horizon * f64::from(i) / 16.0);
            prop_assert!(value >= least - slack && value <= greatest + slack);
        }
    }
}
