//! One contact after the other, the most strongly closing first.
//!
//! The result depends on which contact comes first, as in a sequence of separate collisions: one ball into a touching
//! pair comes out lopsided. Kept because it is what most programs do, and right for balls that only seem to touch.
//!
//! Source: the pairwise schemes of Vouga et al. (2017), from the abstract. *Departs from source*: a last pass without
//! restitution, over all contacts, after a number of them.

use super::reflections::force_open;
use super::{Body, PASSES_PER_BALL, Passes, Touch, TouchLaw, closing_touches, vouga_2017};
use crate::geometry::Vector;
use crate::law::Reference;
use crate::scalar::Scalar;

/// The sources of the law.
pub const REFERENCES: &[Reference] = &[vouga_2017("cluster.pairwise")];

/// Resolves the contacts one at a time until none closes.
pub fn resolve_pairwise<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &mut [Body<S, V>],
    touches: &mut [Touch<S, V, L>],
) -> Passes {
    let limit = PASSES_PER_BALL * bodies.len() * touches.len();
    for count in 0..limit {
        let Some(k) = strongest(touches, bodies) else {
            return Passes { count: count as u32, forced: false };
        };
        let speed = -touches[k].gap_rate(bodies);
        let inverse_mass =
            bodies[touches[k].a].inverse_mass + touches[k].b.map_or(S::ZERO, |b| bodies[b].inverse_mass);
        let impulse = (S::ONE + touches[k].restitution_now(bodies)) * speed / inverse_mass;
        touches[k].note_closing(speed);
        touches[k].apply(impulse, bodies);
    }
    force_open(bodies, touches);
    Passes { count: limit as u32 + 1, forced: true }
}

fn strongest<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    touches: &[Touch<S, V, L>],
    bodies: &[Body<S, V>],
) -> Option<usize> {
    closing_touches(touches, bodies)
        .reduce(|best, k| if touches[k].gap_rate(bodies) < touches[best].gap_rate(bodies) { k } else { best })
}
