//! All closing contacts at once, as generalised reflections.
//!
//! A pass finds the impulses λ ≥ 0 that just stop the closing of every closing contact (a complementarity problem), and
//! applies each `(1 + e)`-fold with its contact's own restitution e. Passes follow until nothing closes. So an ideal
//! cradle passes one ball on, and one ball into a touching pair comes out symmetric (−1/5 and 2√3/5 of its speed).
//!
//! Where contacts of different e are coupled, `(1 + e)`-fold impulses could raise the energy; the part beyond the first
//! is then scaled so that they do not. After a number of passes one last pass without restitution, over all contacts,
//! ends the matter.
//!
//! Source: the generalised reflections of Smith et al. (2012), from the abstract of Vouga et al. (2017). *Departs from
//! source*: restitution per contact, energy guard, last pass.

use super::complementarity::solve_complementarity;
use super::{Body, PASSES_PER_BALL, Passes, Touch, TouchLaw, closing_touches, vouga_2017};
use crate::geometry::Vector;
use crate::law::Reference;
use crate::scalar::Scalar;

/// The sources of the law.
pub const REFERENCES: &[Reference] = &[
    Reference {
        law: "cluster.reflections",
        text: "B. Smith, D. M. Kaufman, E. Vouga, R. Tamstorf, E. Grinspun, Reflections on simultaneous impact, ACM Transactions on Graphics 31 (2012) 106",
        doi: Some("10.1145/2185520.2185602"),
    },
    vouga_2017("cluster.reflections"),
];

/// Resolves all contacts until none closes.
pub fn resolve_reflections<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &mut [Body<S, V>],
    touches: &mut [Touch<S, V, L>],
) -> Passes {
    let limit = PASSES_PER_BALL * bodies.len();
    for count in 0..limit {
        let closing: Vec<usize> = closing_touches(touches, bodies).collect();
        if closing.is_empty() {
            return Passes { count: count as u32, forced: false };
        }
        reflect(bodies, touches, &closing);
    }
    if closing_touches(touches, bodies).next().is_none() {
        return Passes { count: limit as u32, forced: false };
    }
    force_open(bodies, touches);
    Passes { count: limit as u32 + 1, forced: true }
}

/// Stops the closing of every contact, without restitution.
pub(super) fn force_open<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &mut [Body<S, V>],
    touches: &mut [Touch<S, V, L>],
) {
    let all: Vec<usize> = (0..touches.len()).collect();
    let impulses = stopping_impulses(bodies, touches, &all);
    for (&k, &impulse) in all.iter().zip(&impulses) {
        touches[k].apply(impulse, bodies);
    }
}

fn reflect<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &mut [Body<S, V>],
    touches: &mut [Touch<S, V, L>],
    closing: &[usize],
) {
    for &k in closing {
        let speed = -touches[k].gap_rate(bodies);
        touches[k].note_closing(speed);
    }
    let stopping = stopping_impulses(bodies, touches, closing);
    let bouncing: Vec<S> =
        closing.iter().zip(&stopping).map(|(&k, &s)| s * touches[k].restitution_now(bodies)).collect();
    let share = bounce_share(bodies, touches, closing, &stopping, &bouncing);
    for ((&k, &stop), &bounce) in closing.iter().zip(&stopping).zip(&bouncing) {
        touches[k].apply(stop + bounce * share, bodies);
    }
}

/// The share of the bouncing impulses that keeps the energy from rising: with the energy after the stop at its least,
/// `|Bλ e|² ≤ |Bλ|²` in the metric of the masses.
fn bounce_share<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &[Body<S, V>],
    touches: &[Touch<S, V, L>],
    closing: &[usize],
    stopping: &[S],
    bouncing: &[S],
) -> S {
    let taken = quadratic_form(bodies, touches, closing, stopping);
    let given = quadratic_form(bodies, touches, closing, bouncing);
    if given > taken { (taken / given).sqrt() } else { S::ONE }
}

fn quadratic_form<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &[Body<S, V>],
    touches: &[Touch<S, V, L>],
    closing: &[usize],
    impulses: &[S],
) -> S {
    let mut sum = S::ZERO;
    for (&k, &p) in closing.iter().zip(impulses) {
        for (&l, &q) in closing.iter().zip(impulses) {
            sum += p * q * coupling(bodies, &touches[k], &touches[l]);
        }
    }
    sum
}

/// The least impulses that leave none of the contacts `chosen` closing.
fn stopping_impulses<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &[Body<S, V>],
    touches: &[Touch<S, V, L>],
    chosen: &[usize],
) -> Vec<S> {
    let matrix: Vec<Vec<S>> = chosen
        .iter()
        .map(|&k| chosen.iter().map(|&l| coupling(bodies, &touches[k], &touches[l])).collect())
        .collect();
    let rates: Vec<S> = chosen.iter().map(|&k| touches[k].gap_rate(bodies)).collect();
    solve_complementarity(&matrix, &rates)
}

/// How much a unit impulse in contact `l` changes the gap rate of contact `k`.
fn coupling<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    bodies: &[Body<S, V>],
    k: &Touch<S, V, L>,
    l: &Touch<S, V, L>,
) -> S {
    let mut sum = S::ZERO;
    for (body, sign_k) in ends(k) {
        for (other, sign_l) in ends(l) {
            if body == other {
                let term = k.normal.dot(l.normal) * bodies[body].inverse_mass;
                sum += if sign_k == sign_l { term } else { -term };
            }
        }
    }
    sum
}

fn ends<S: Scalar, V: Vector<S>, L: TouchLaw<S>>(
    touch: &Touch<S, V, L>,
) -> impl Iterator<Item = (usize, bool)> {
    core::iter::once((touch.a, false)).chain(touch.b.map(|b| (b, true)))
}
