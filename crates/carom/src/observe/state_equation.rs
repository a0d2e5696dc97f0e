//! The equation of state of hard discs, to compare with.
//!
//! # References
//!
//! J. Kolafa, M. Rottner, *Simulation-based equation of state of the hard disk fluid*, Mol. Phys. 104, 3435 (2006): a
//! fit in powers of x = η/(1 − η), for packing fractions η up to 0.699.

/// The largest packing fraction of the fit: at more the fluid begins to freeze.
const LARGEST: f64 = 0.699;

/// The coefficients of x⁰, x¹, ...
const COEFFICIENTS: [f64; 13] = [
    1.0,
    2.0,
    1.12801775,
    0.00181895291,
    -0.0526134737,
    0.0504960168,
    -0.0325537792,
    0.0134578632,
    0.00140888182,
    -0.00834273601,
    0.00694127367,
    -0.00262254723,
    0.000355746352,
];

/// The last terms, far from the others: powers and coefficients.
const LAST: [(u32, f64); 2] = [(22, -5.24672938e-9), (57, 5.88054639e-23)];

/// The compressibility factor Z = P A/(N kT) at a packing fraction; `None` outside the range of the fit.
pub fn compressibility(packing_fraction: f64) -> Option<f64> {
    if !(0.0..=LARGEST).contains(&packing_fraction) {
        return None;
    }
    let x = packing_fraction / (1.0 - packing_fraction);
    let fluid = COEFFICIENTS.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient);
    let power = |exponent: u32| (0..exponent).fold(1.0, |product, _| product * x);
    Some(LAST.iter().fold(fluid, |sum, (exponent, coefficient)| sum + coefficient * power(*exponent)))
}

/// 4/√π, which times Z − 1 is a disc's collisions per time in units of √(kT/m)/σ: exact for smooth elastic equal discs.
pub(super) fn rate_per_excess() -> f64 {
    4.0 / core::f64::consts::PI.sqrt()
}
