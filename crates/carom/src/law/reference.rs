//! Where a law comes from.

use serde::Serialize;

/// A source of a law: what to cite where it was used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Reference {
    /// The law, as `kind.name`: `ball_cushion.restitution`, `cluster.reflections`.
    pub law: &'static str,
    /// Authors, title, where and when.
    pub text: &'static str,
    /// Its DOI, where it has one.
    pub doi: Option<&'static str>,
}

/// The source of every law with a coefficient of restitution.
pub(super) const fn newton(law: &'static str) -> Reference {
    let text =
        "I. Newton, Philosophiæ Naturalis Principia Mathematica (1687), scholium after the laws of motion";
    Reference { law, text, doi: None }
}

/// The source of every law with a coefficient of friction.
pub(super) const fn coulomb(law: &'static str) -> Reference {
    let text = "C. A. Coulomb, Théorie des machines simples, Mémoires de mathématique et de physique 10 (1785) 161–332";
    Reference { law, text, doi: None }
}
