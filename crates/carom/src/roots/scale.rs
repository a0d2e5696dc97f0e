//! Binary exponents, so that extreme numbers can be scaled by powers of two, which is exact.

use crate::scalar::Scalar;

/// The binary exponent of a value: of a finite one that is not zero, `⌊log₂ |value|⌋`.
pub(super) fn exponent<S: Scalar>(value: S) -> i32 {
    let biased = |value: f64| ((value.to_bits() >> 52) & 0x7ff) as i32;
    match biased(value.to_f64()) {
        0 => biased(value.to_f64() * power_of_two::<f64>(64)) - 64 - 1023,
        normal => normal - 1023,
    }
}

/// `2^exponent`, clamped to the normal numbers.
pub(super) fn power_of_two<S: Scalar>(exponent: i32) -> S {
    let biased = (exponent.clamp(-1022, 1023) + 1023) as u64;
    S::from_f64(f64::from_bits(biased << 52))
}

#[cfg(test)]
mod tests {
    use super::{exponent, power_of_two};

    #[test]
    fn exponents_of_normal_and_subnormal_numbers() {
        for (value, expected) in
            [(1.0, 0), (-3.9, 1), (0.5, -1), (f64::MAX, 1023), (5e-324, -1074), (4e-310, -1028)]
        {
            assert_eq!(exponent(value), expected, "{value}");
        }
        assert_eq!(power_of_two::<f64>(-3), 0.125);
        assert_eq!(power_of_two::<f64>(5000), f64::MAX / (2.0 - f64::EPSILON));
    }
}
