//! The one door to transcendental functions: `libm`, which gives the same bits on every platform.

use super::Scalar;

pub(super) fn cos_sin(radians: f64) -> (f64, f64) {
    (libm::cos(radians), libm::sin(radians))
}

pub(super) fn exp(x: f64) -> f64 {
    libm::exp(x)
}

pub(super) fn angle(x: f64, y: f64) -> f64 {
    libm::atan2(y, x)
}

/// The unit vector `(cos, sin)` of an angle in degrees.
///
/// Multiples of 90 degrees are exact, so that the quarter arcs of a table end where its lines begin.
pub fn direction<S: Scalar>(degrees: S) -> (S, S) {
    let value = degrees.to_f64();
    let turns = libm::round(value / 90.0);
    let (cos, sin) =
        ((degrees - S::from_f64(90.0 * turns)) * S::from_f64(core::f64::consts::PI / 180.0)).cos_sin();
    match libm::fmod(turns, 4.0) as i8 {
        0 => (cos, sin),
        1 | -3 => (-sin, cos),
        2 | -2 => (-cos, -sin),
        _ => (sin, -cos),
    }
}

/// The angle of the vector (x, y), in degrees from the x axis towards the y axis, above −180 and up to 180.
pub fn angle_deg(x: f64, y: f64) -> f64 {
    libm::atan2(y, x) * (180.0 / core::f64::consts::PI)
}

/// 2/√π ∫ₓ^∞ e^(−t²) dt.
pub fn complementary_error_function(x: f64) -> f64 {
    libm::erfc(x)
}

/// The other leg of a right triangle with a hypotenuse of one; none where round-off makes the first too long.
pub fn other_leg<S: Scalar>(leg: S) -> S {
    let squared = S::ONE - leg.squared();
    if squared > S::ZERO { squared.sqrt() } else { S::ZERO }
}

/// The natural logarithm: −∞ of zero, not a number of less.
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// The angle in radians, from 0 to π, whose cosine this is.
pub fn arccos<S: Scalar>(cos: S) -> S {
    S::angle(cos, other_leg(cos))
}

#[cfg(test)]
mod tests {
    use super::{arccos, direction};

    #[test]
    fn arccos_agrees_with_the_definition() {
        for cos in [-1.0, -0.3, 0.0, 0.7, 1.0] {
            assert!((arccos::<f64>(cos) - libm::acos(cos)).abs() < 4e-16, "{cos}");
        }
    }

    #[test]
    fn quarter_turns_are_exact() {
        assert_eq!(direction(90.0), (-0.0, 1.0));
        assert_eq!(direction(-90.0), (0.0, -1.0));
        assert_eq!(direction(540.0), (-1.0, 0.0));
        assert_eq!(direction(-360.0), (1.0, 0.0));
    }

    #[test]
    fn direction_agrees_with_the_definition() {
        for degrees in [-731.0, -46.0, -44.0, 12.5, 53.13, 134.9, 200.0, 359.0] {
            let (cos, sin) = direction::<f64>(degrees);
            let radians = degrees.to_radians();
            assert!((cos - libm::cos(radians)).abs() < 4e-15 && (sin - libm::sin(radians)).abs() < 4e-15);
        }
    }
}
