//! Balls that lie on cushions and go on to lie there while others hop on them.
//!
//! A held ball stands for one that bounces too fast to be followed. A blow on it that pushes it off its cushion by a hair
//! and has it held again would take the energy of that hair away; each blow a share of what is left, so that the hops of
//! a heap would die down in a finite time. So its cushion takes part in the blow instead: the ball moves along it only,
//! and nothing is lost. A cushion cannot pull, though; only under gentle blows, whose hops would last about t_c, does it.

use super::complementarity::solve_complementarity;
use super::reflections::coupling;
use super::{Body, Touch};
use crate::scalar::Scalar;

/// Contacts that pull where the held ones push, if all that closes does so gently.
pub(super) fn pulls<S: Scalar>(bodies: &[Body<S>], touches: &[Touch<S>]) -> Vec<Touch<S>> {
    let is_held = |touch: &&Touch<S>| touch.is_held;
    let is_gentle = |touch: &Touch<S>| touch.is_held || -touch.gap_rate(bodies) <= touch.kept_speed;
    if !touches.iter().any(|touch| touch.is_held) || !touches.iter().all(is_gentle) {
        return Vec::new();
    }
    touches.iter().filter(is_held).map(|touch| Touch { normal: -touch.normal, ..*touch }).collect()
}

/// The impulses of the held contacts among `pushing` that keep them closed while the others bounce.
pub(super) fn hold_bouncing<S: Scalar>(
    bodies: &[Body<S>],
    touches: &[Touch<S>],
    pushing: &[usize],
    bouncing: &mut [S],
) {
    let held: Vec<usize> = (0..pushing.len()).filter(|&k| touches[pushing[k]].is_held).collect();
    if held.is_empty() {
        return;
    }
    for &k in &held {
        bouncing[k] = S::ZERO;
    }
    let between = |k: usize, l: usize| coupling(bodies, &touches[pushing[k]], &touches[pushing[l]]);
    let rate = |k: usize| {
        let mut sum = S::ZERO;
        for (l, &impulse) in bouncing.iter().enumerate() {
            sum += between(k, l) * impulse;
        }
        sum
    };
    let rates: Vec<S> = held.iter().map(|&k| rate(k)).collect();
    let matrix: Vec<Vec<S>> = held.iter().map(|&k| held.iter().map(|&l| between(k, l)).collect()).collect();
    for (&k, impulse) in held.iter().zip(solve_complementarity(&matrix, &rates)) {
        bouncing[k] = impulse;
    }
}
