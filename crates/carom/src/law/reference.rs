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
