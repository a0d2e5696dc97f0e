//! The oracle: real roots of polynomials in exact integer arithmetic, isolated by Sturm's theorem.

use carom::scalar::DoubleDouble;
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};

/// The number `mantissa · 2^exponent`.
#[derive(Clone, Debug)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

/// A polynomial with integer coefficients in order of ascending power, times a power of two.
#[derive(Clone, Debug)]
pub struct Exact {
    coefficients: Vec<BigInt>,
    exponent: i64,
}

/// A root at which the sign changes.
#[derive(Clone, Debug)]
pub struct Crossing {
    pub at: Dyadic,
    pub is_falling: bool,
}

fn power_of_two(exponent: i64) -> f64 {
    2f64.powi(exponent.clamp(-5000, 5000) as i32)
}

impl Dyadic {
    pub fn from_f64(value: f64) -> Self {
        assert!(value.is_finite());
        let bits = value.to_bits();
        let (biased, fraction) = ((bits >> 52) as i64 & 0x7ff, bits & ((1 << 52) - 1));
        let magnitude = if biased == 0 { fraction } else { fraction | (1 << 52) } as i64;
        let mantissa = BigInt::from(if value < 0.0 { -magnitude } else { magnitude });
        Self { mantissa, exponent: biased.max(1) - 1075 }
    }

    /// Cut (not rounded) to 64 bits, then rounded.
    pub fn to_f64(&self) -> f64 {
        let excess = (self.mantissa.bits() as i64 - 64).max(0);
        let leading: BigInt = &self.mantissa >> excess;
        let exponent = self.exponent + excess;
        let half = exponent / 2;
        leading.to_f64().unwrap() * power_of_two(half) * power_of_two(exponent - half)
    }

    pub fn to_double_double(&self) -> DoubleDouble {
        let high = self.to_f64();
        DoubleDouble::from_sum(high, (self - &Self::from_f64(high)).to_f64())
    }

    /// The binary exponent of the quotient, to ±1.
    fn bits_above(&self, other: &Self) -> i64 {
        let exponent = |x: &Self| x.mantissa.bits() as i64 + x.exponent;
        exponent(self) - exponent(other)
    }

    fn halfway(&self, other: &Self) -> Self {
        let (a, b, exponent) = aligned(self, other);
        Self { mantissa: a + b, exponent: exponent - 1 }
    }
}

fn aligned(a: &Dyadic, b: &Dyadic) -> (BigInt, BigInt, i64) {
    let exponent = a.exponent.min(b.exponent);
    (&a.mantissa << (a.exponent - exponent), &b.mantissa << (b.exponent - exponent), exponent)
}

impl core::ops::Sub for &Dyadic {
    type Output = Dyadic;

    fn sub(self, other: Self) -> Dyadic {
        let (a, b, exponent) = aligned(self, other);
        Dyadic { mantissa: a - b, exponent }
    }
}

impl Exact {
    /// The polynomial with exactly these `f64` coefficients.
    pub fn new(coefficients: &[f64]) -> Self {
        let terms: Vec<_> = coefficients.iter().map(|a| Dyadic::from_f64(*a)).collect();
        let nonzero = terms.iter().filter(|a| !a.mantissa.is_zero());
        let exponent = nonzero.map(|a| a.exponent).min().unwrap_or(0);
        let shifted =
            |a: Dyadic| if a.mantissa.is_zero() { a.mantissa } else { a.mantissa << (a.exponent - exponent) };
        Self { coefficients: trimmed(terms.into_iter().map(shifted).collect()), exponent }
    }

    pub fn value(&self, s: &Dyadic) -> Dyadic {
        // With s = m / 2^k: Σ aᵢ mⁱ 2^(k (n − i)), all integers.
        let (m, k) =
            if s.exponent > 0 { (&s.mantissa << s.exponent, 0) } else { (s.mantissa.clone(), -s.exponent) };
        let (mut sum, mut places) = (BigInt::zero(), 0);
        for a in self.coefficients.iter().rev() {
            sum = sum * &m + (a << places);
            places += k;
        }
        Dyadic { mantissa: sum, exponent: self.exponent - (places - k).max(0) }
    }

    pub fn value_at(&self, s: f64) -> f64 {
        self.value(&Dyadic::from_f64(s)).to_f64()
    }

    fn is_positive_at(&self, s: &Dyadic) -> bool {
        self.value(s).mantissa.is_positive()
    }

    fn with(coefficients: Vec<BigInt>) -> Self {
        Self { coefficients: trimmed(coefficients), exponent: 0 }
    }

    /// The Sturm sequence, each member up to a positive factor.
    fn sturm(&self) -> Vec<Self> {
        let slope = self.coefficients.iter().enumerate().skip(1).map(|(i, a)| a * i);
        let mut chain = vec![Self::with(self.coefficients.clone()), Self::with(slope.collect())];
        while let [.., a, b] = chain.as_slice()
            && !b.coefficients.is_empty()
        {
            let rest = a.remainder(b);
            chain.push(Self::with(rest.into_iter().map(|a| -a).collect()));
        }
        chain
    }

    /// The remainder of a division, times a positive factor.
    fn remainder(&self, divisor: &Self) -> Vec<BigInt> {
        let mut rest = self.coefficients.clone();
        let (degree, leading) = (divisor.coefficients.len() - 1, divisor.coefficients.last().unwrap());
        while rest.len() > degree {
            let factor = rest.pop().unwrap() * leading.signum();
            let shift = rest.len() - degree;
            for a in &mut rest {
                *a *= leading.abs();
            }
            for (i, a) in divisor.coefficients[..degree].iter().enumerate() {
                rest[shift + i] -= &factor * a;
            }
        }
        rest
    }

    /// All points `s > 0` at which the sign changes, in order, bracketed to 140 bits or more.
    ///
    /// Cuts fall on multiples of a large prime times a power of two, so never on the short multiple roots that tests
    /// contain (a simple root may be hit).
    pub fn crossings(&self) -> Vec<Crossing> {
        let mut crossings = Vec::new();
        if self.coefficients.len() > 1 {
            let largest = self.coefficients.iter().map(BigInt::bits).max().unwrap();
            let leading = self.coefficients.last().unwrap().bits();
            let prime = BigInt::from((1u64 << 61) - 1);
            let bound = Dyadic { mantissa: prime, exponent: (largest - leading) as i64 + 3 - 60 };
            // Below every root of `f64` coefficients but 0 itself, where the sequence may vanish.
            let start = Dyadic { mantissa: bound.mantissa.clone(), exponent: -2300 };
            self.isolate(&self.sturm(), [start, bound], &mut crossings);
        }
        crossings
    }

    fn isolate(&self, chain: &[Self], [from, to]: [Dyadic; 2], crossings: &mut Vec<Crossing>) {
        let count = variations(chain, &from) - variations(chain, &to);
        if count == 0 {
            return;
        }
        if count == 1 {
            let is_falling = self.is_positive_at(&from);
            if is_falling != self.is_positive_at(&to) {
                crossings.push(Crossing { at: self.refined(from, to), is_falling });
            }
            return;
        }
        let quarter = Dyadic { mantissa: to.mantissa.clone(), exponent: to.exponent - 2 };
        let middle = if to.bits_above(&from) > 3 { quarter } else { from.halfway(&to) };
        self.isolate(chain, [from, middle.clone()], crossings);
        self.isolate(chain, [middle, to], crossings);
    }

    fn refined(&self, mut from: Dyadic, mut to: Dyadic) -> Dyadic {
        let is_falling = self.is_positive_at(&from);
        while (&to - &from).bits_above(&from) > -140 {
            let middle = from.halfway(&to);
            if self.is_positive_at(&middle) == is_falling { from = middle } else { to = middle }
        }
        to
    }
}

fn trimmed(mut coefficients: Vec<BigInt>) -> Vec<BigInt> {
    while coefficients.last().is_some_and(Zero::is_zero) {
        coefficients.pop();
    }
    coefficients
}

fn variations(chain: &[Exact], s: &Dyadic) -> usize {
    let values: Vec<_> = chain.iter().map(|p| p.value(s).mantissa).filter(|value| !value.is_zero()).collect();
    values.windows(2).filter(|pair| pair[0].is_positive() != pair[1].is_positive()).count()
}

#[test]
fn oracle_finds_known_roots() {
    let found = |coefficients: &[f64]| -> Vec<(f64, bool)> {
        Exact::new(coefficients).crossings().iter().map(|c| (c.at.to_f64(), c.is_falling)).collect()
    };
    // (s − 1)² (s − 2) (s − 3): a double root is no crossing.
    assert_eq!(found(&[6.0, -17.0, 17.0, -7.0, 1.0]), [(2.0, true), (3.0, false)]);
    // (1 − s)³
    assert_eq!(found(&[1.0, -3.0, 3.0, -1.0]), [(1.0, true)]);
    assert_eq!(found(&[-2.0, 0.0, 1.0]), [(core::f64::consts::SQRT_2, false)]);
    assert_eq!(found(&[5.0, 1.0, 1.0]), []);
    assert_eq!(Exact::new(&[0.1, -3.0, 2.5]).value_at(1e-3), 0.1 - 3e-3 + 2.5e-6);
}
