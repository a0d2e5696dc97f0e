//! The quantile of the normal distribution, to some sixteen digits.
//!
//! # References
//!
//! M. J. Wichura, *Algorithm AS 241: the percentage points of the normal distribution*, Applied Statistics 37 (1988)
//! 477–484: its routine PPND16, ratios of polynomials of degree seven in three ranges.

use crate::scalar::{complementary_error_function, ln};

/// A polynomial's coefficients, the constant one first.
type Polynomial = [f64; 8];

/// Up to this distance from 1/2 the quantile is a ratio in 0.425² − (p − 1/2)².
const CENTRE: f64 = 0.425;

/// Up to this √(−ln p) the quantile is the ratio of the near tail, then of the far one.
const NEAR_TAIL: f64 = 5.0;

/// The number that a normal one with mean 0 and variance 1 stays below with this probability, strictly between 0 and 1.
pub(super) fn normal_quantile(probability: f64) -> f64 {
    let from_middle = probability - 0.5;
    if from_middle.abs() <= CENTRE {
        return from_middle * ratio(&CENTRAL, CENTRE * CENTRE - from_middle * from_middle);
    }
    let tail = if from_middle < 0.0 { probability } else { 1.0 - probability };
    let depth = (-ln(tail)).sqrt();
    let distance =
        if depth <= NEAR_TAIL { ratio(&NEAR, depth - 1.6) } else { ratio(&FAR, depth - NEAR_TAIL) };
    if from_middle < 0.0 { -distance } else { distance }
}

/// The share of the values of such a number that are less than this one.
pub(super) fn normal_share(quantile: f64) -> f64 {
    0.5 * complementary_error_function(-quantile * core::f64::consts::FRAC_1_SQRT_2)
}

fn ratio([numerator, denominator]: &[Polynomial; 2], x: f64) -> f64 {
    let at =
        |polynomial: &Polynomial| polynomial.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient);
    at(numerator) / at(denominator)
}

/// The paper's a and b.
#[allow(clippy::excessive_precision)] // the digits are the paper's
const CENTRAL: [Polynomial; 2] = [
    [
        3.3871328727963666080e0,
        1.3314166789178437745e2,
        1.9715909503065514427e3,
        1.3731693765509461125e4,
        4.5921953931549871457e4,
        6.7265770927008700853e4,
        3.3430575583588128105e4,
        2.5090809287301226727e3,
    ],
    [
        1.0,
        4.2313330701600911252e1,
        6.8718700749205790830e2,
        5.3941960214247511077e3,
        2.1213794301586595867e4,
        3.9307895800092710610e4,
        2.8729085735721942674e4,
        5.2264952788528545610e3,
    ],
];

/// The paper's c and d.
#[allow(clippy::excessive_precision)]
const NEAR: [Polynomial; 2] = [
    [
        1.42343711074968357734e0,
        4.63033784615654529590e0,
        5.76949722146069140550e0,
        3.64784832476320460504e0,
        1.27045825245236838258e0,
        2.41780725177450611770e-1,
        2.27238449892691845833e-2,
        7.74545014278341407640e-4,
    ],
    [
        1.0,
        2.05319162663775882187e0,
        1.67638483018380384940e0,
        6.89767334985100004550e-1,
        1.48103976427480074590e-1,
        1.51986665636164571966e-2,
        5.47593808499534494600e-4,
        1.05075007164441684324e-9,
    ],
];

/// The paper's e and f.
#[allow(clippy::excessive_precision)]
const FAR: [Polynomial; 2] = [
    [
        6.65790464350110377720e0,
        5.46378491116411436990e0,
        1.78482653991729133580e0,
        2.96560571828504891230e-1,
        2.65321895265761230930e-2,
        1.24266094738807843860e-3,
        2.71155556874348757815e-5,
        2.01033439929228813265e-7,
    ],
    [
        1.0,
        5.99832206555887937690e-1,
        1.36929880922735805310e-1,
        1.48753612908506148525e-2,
        7.86869131145613259100e-4,
        1.84631831751005468180e-5,
        1.42151175831644588870e-7,
        2.04426310338993978564e-15,
    ],
];
