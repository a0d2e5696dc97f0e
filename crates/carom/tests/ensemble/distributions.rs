//! Quantiles.

use carom::ensemble::Distribution;

const STANDARD: Distribution = Distribution::Normal { mean: 0.0, standard_deviation: 1.0 };

#[test]
fn normal_quantiles_have_sixteen_digits() {
    // Those of 0.25, 0.001 and 1e-20 are what the paper of AS 241 lists; all were found with 60 digits, by mpmath 1.4,
    // as roots of the distribution's integral.
    let expected = [
        (1e-300, -37.047_096_299_361_2),
        (1e-100, -21.273_453_560_965_324),
        (1e-20, -9.262_340_089_798_408),
        (1e-15, -7.941_345_326_170_997),
        (1e-10, -6.361_340_902_404_056),
        (1e-5, -4.264_890_793_922_825),
        (0.001, -3.090_232_306_167_813_5),
        (0.01, -2.326_347_874_040_841),
        (0.025, -1.959_963_984_540_054_2),
        (0.07, -1.475_791_028_179_170_7),
        (0.1, -1.281_551_565_544_600_4),
        (0.25, -0.674_489_750_196_081_7),
        (0.4, -0.253_347_103_135_799_7),
        (0.49, -0.025_068_908_258_711_058),
        (0.5, 0.0),
        (0.975, 1.959_963_984_540_054),
    ];
    for (unit, expected) in expected {
        let found = STANDARD.at(unit);
        // Wichura claims one part in 1e16, to which some roundings are added.
        assert!((found - expected).abs() <= 1e-15 * f64::abs(expected), "{unit}: {found}, not {expected}");
    }
}

#[test]
fn normal_quantiles_are_symmetric_and_rise() {
    let mut last = f64::NEG_INFINITY;
    for step in 1..4096 {
        let unit = f64::from(step) / 4096.0;
        let value = STANDARD.at(unit);
        assert_eq!(value, -STANDARD.at(1.0 - unit), "{unit}");
        assert!(value > last, "{unit}");
        last = value;
    }
}

#[test]
fn normal_quantiles_go_on_where_their_formulas_change() {
    // At 0.075, and at exp(−25). There the slope times the edge is the ratio of Mills, below 0.6.
    for edge in [0.075, 1.388_794_386_496_402e-11] {
        let [below, above] = [1.0 - 1e-12, 1.0 + 1e-12].map(|factor| STANDARD.at(edge * factor));
        let step = 0.6 * 2e-12;
        // Values below 8 are rounded by 4e-16 or so, in each of some operations.
        assert!(-5e-15 < above - below && above - below < step + 5e-15, "{edge}: {below}, {above}");
    }
}

#[test]
fn mean_and_standard_deviation_place_a_normal_value() {
    let normal = Distribution::Normal { mean: -3.0, standard_deviation: 0.5 };
    assert_eq!(normal.at(0.5), -3.0);
    assert_eq!(normal.at(0.2), -3.0 + 0.5 * STANDARD.at(0.2));
}

#[test]
fn uniform_values_are_within_their_range() {
    let [least, largest] = [f64::EPSILON / 2.0, 1.0 - f64::EPSILON / 2.0];
    for (low, high) in [(0.0, 1.0), (-0.3, 0.1), (-1e300, 1e300), (1.0, 1.0 + f64::EPSILON), (-7.0, -6.9)] {
        let uniform = Distribution::Uniform { low, high };
        for unit in [least, 0.1, 0.5, 0.9, largest] {
            assert!((low..=high).contains(&uniform.at(unit)), "{low} to {high} at {unit}");
        }
    }
    assert_eq!(Distribution::Uniform { low: -2.0, high: 6.0 }.at(0.25), 0.0);
}

/// The share of values below one, found by halving, is the whole distribution's share between the bounds; and nothing is outside.
#[test]
fn a_truncated_normal_is_the_normal_between_its_bounds() {
    let (mean, standard_deviation) = (2.0, 0.5);
    let whole = Distribution::Normal { mean, standard_deviation };
    let share = |value: f64| {
        let (mut below, mut above) = (1e-12, 1.0 - 1e-12);
        for _ in 0..60 {
            let middle = 0.5 * (below + above);
            if whole.at(middle) < value { below = middle } else { above = middle }
        }
        below
    };
    let infinity = f64::INFINITY;
    for [low, high] in
        [[1.5, 2.2], [2.0, infinity], [-infinity, 1.0], [3.0, 9.0], [0.0, 0.2], [-infinity, infinity]]
    {
        let cut = Distribution::TruncatedNormal { mean, standard_deviation, low, high };
        cut.check().unwrap();
        let (from, to) = (share(low), share(high));
        for unit in [1e-9, 0.1, 0.5, 0.77, 1.0 - 1e-9] {
            let value = cut.at(unit);
            assert!((low..=high).contains(&value), "{low} {high} {unit}: {value}");
            let expected = from + (to - from) * unit;
            assert!(
                (share(value) - expected).abs() < 1e-9 * expected + 1e-11,
                "{low} {high} {unit}: {value}"
            );
        }
    }
    // A level cue: the half of the bell that is left has its median at 0.6745.
    let level =
        Distribution::TruncatedNormal { mean: 0.0, standard_deviation: 1.0, low: 0.0, high: infinity };
    assert!((level.at(0.5) - 0.674_489_750_196_081_7).abs() < 1e-15);
    for [low, high] in [[3.0, 2.0], [2.0, 2.0], [40.0, 50.0], [f64::NAN, 3.0]] {
        let nothing = Distribution::TruncatedNormal { mean, standard_deviation, low, high };
        assert!(nothing.check().unwrap_err().to_string().starts_with("high: must be above low, "));
    }
}
