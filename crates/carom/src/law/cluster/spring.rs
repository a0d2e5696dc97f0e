//! A contact of the law `hertz`: a spring whose force goes as δ^(3/2) and its energy as δ^(5/2).

use super::{Body, Touch, TouchLaw};
use crate::geometry::Vector;
use crate::scalar::Scalar;

/// A contact as a spring.
///
/// The law makes it, and says in which units.
#[derive(Clone, Debug)]
pub(super) struct Spring<S, V> {
    a: usize,
    b: Option<usize>,
    normal: V,
    /// The closing speed that a unit impulse takes away.
    inverse_mass: S,
    /// The force at δ = 1.
    pub(super) stiffness: S,
    /// How far the bodies have come together, δ; negative after they have parted.
    pub(super) overlap: S,
    /// The closing speed at first, before the present step and after it.
    pub(super) closing_first: S,
    pub(super) closing: S,
    pub(super) closing_after: S,
    /// The impulse of the present step, and what of it is to be taken back.
    pub(super) push: S,
    pub(super) excess: S,
    /// The impulse of all steps.
    pub(super) impulse: S,
    /// The work done on it.
    pub(super) stored: S,
    /// That when it last began to close; `None` while it opens.
    pub(super) loaded_from: Option<S>,
}

impl<S: Scalar, V: Vector<S>> Spring<S, V> {
    pub(super) fn new<L: TouchLaw<S>>(touch: &Touch<S, V, L>, bodies: &[Body<S, V>]) -> Self {
        let other = touch.b.map_or(S::ZERO, |b| bodies[b].inverse_mass);
        let closing = -touch.gap_rate(bodies);
        let is_point = touch.effective_radius == S::ZERO;
        Self {
            a: touch.a,
            b: touch.b,
            normal: touch.normal,
            inverse_mass: bodies[touch.a].inverse_mass + other,
            stiffness: if is_point { S::ZERO } else { touch.effective_radius.sqrt() },
            overlap: S::ZERO,
            closing_first: closing,
            closing,
            closing_after: closing,
            push: S::ZERO,
            excess: S::ZERO,
            impulse: S::ZERO,
            stored: S::ZERO,
            loaded_from: None,
        }
    }

    /// How fast the force grows on bodies as heavy as these.
    pub(super) fn hardness(&self) -> S {
        self.stiffness * self.inverse_mass
    }

    /// The square of the speed at which it would close or open if alone with its energy.
    pub(super) fn squared_speed(&self) -> S {
        let closing = larger(self.closing, S::ZERO).squared();
        closing + larger(self.stored, S::ZERO) * (self.inverse_mass + self.inverse_mass)
    }

    pub(super) fn force(&self) -> S {
        if self.overlap > S::ZERO { self.stiffness * self.overlap * self.overlap.sqrt() } else { S::ZERO }
    }

    /// The closing speed.
    pub(super) fn rate(&self, bodies: &[(V, S)]) -> S {
        (bodies[self.a].0 - self.b.map_or(V::ZERO, |b| bodies[b].0)).dot(self.normal)
    }

    /// Gives both bodies an impulse that pushes them apart.
    pub(super) fn act(&self, impulse: S, bodies: &mut [(V, S)]) {
        if impulse == S::ZERO {
            return;
        }
        let push = self.normal * impulse;
        let (velocity, inverse_mass) = &mut bodies[self.a];
        *velocity = *velocity - push * *inverse_mass;
        if let Some(b) = self.b {
            let (velocity, inverse_mass) = &mut bodies[b];
            *velocity = *velocity + push * *inverse_mass;
        }
    }

    /// Ends the closing within the present step, of which the rest becomes a step of its own.
    pub(super) fn turn<L: TouchLaw<S>>(&mut self, touch: &mut Touch<S, V, L>, lost: &mut S) {
        let closing = larger(self.closing, S::ZERO);
        let share = if closing > S::ZERO { closing / (closing - self.closing_after) } else { S::ZERO };
        let before = self.push * share;
        let stored = self.stored + before * closing * S::from_f64(0.5);
        let work = stored - self.loaded_from.take().unwrap_or(stored);
        let loss = self.loss(touch, work);
        let kept = larger((stored - loss) / stored, S::ZERO);
        let mut after = self.push - before;
        if loss > S::ZERO {
            // The energy of a spring goes as δ^(5/2).
            let shrink = fifth_root(kept.squared());
            let weaker = if shrink > S::ZERO { after * shrink * shrink.sqrt() } else { S::ZERO };
            self.overlap = self.overlap * shrink;
            self.excess = after - weaker;
            after = weaker;
            *lost += loss;
        }
        (self.closing, self.push) = (S::ZERO, after);
        self.impulse += before;
        self.stored = stored - loss;
    }

    /// What is lost of the work done while the contact closed.
    fn loss<L: TouchLaw<S>>(&self, touch: &mut Touch<S, V, L>, work: S) -> S {
        if work <= S::ZERO {
            return S::ZERO;
        }
        let speed = (work * (self.inverse_mass + self.inverse_mass)).sqrt();
        touch.note_closing(speed);
        work * (S::ONE - touch.restitution_at(speed).squared())
    }

    pub(super) fn end_step(&mut self) {
        self.impulse += self.push;
        self.stored += self.push * (self.closing + self.closing_after) * S::from_f64(0.5);
        self.closing = self.closing_after;
        if self.overlap > S::ZERO && self.closing > S::ZERO && self.loaded_from.is_none() {
            self.loaded_from = Some(self.stored);
        }
    }
}

/// The larger of two numbers.
pub(super) fn larger<S: Scalar>(a: S, b: S) -> S {
    if b > a { b } else { a }
}

/// The fifth root, by Newton's iteration from above.
pub(super) fn fifth_root<S: Scalar>(value: S) -> S {
    if value <= S::ZERO {
        return S::ZERO;
    }
    let improved = |root: S| (root * S::from_f64(4.0) + value / root.squared().squared()) / S::from_f64(5.0);
    let mut root = larger(value, S::ONE);
    let mut next = improved(root);
    while next < root {
        root = next;
        next = improved(root);
    }
    next
}

#[cfg(test)]
mod tests {
    use super::fifth_root;
    use crate::scalar::{DoubleDouble, Dual, Scalar};

    #[test]
    fn fifth_roots_are_right_to_a_rounding_or_two() {
        for root in [1e-30, 1e-3, 0.3, 1.0, 7.0, 1e40] {
            let found: f64 = fifth_root(root * root * root * root * root);
            assert!((found - root).abs() <= 4.0 * f64::EPSILON * root, "{root}: {found}");
        }
        assert_eq!(fifth_root(0.0), 0.0);
        let three = fifth_root(DoubleDouble::from_f64(243.0)) - DoubleDouble::from_f64(3.0);
        assert!(three.to_f64().abs() < 1e-30);
        // The derivative of x^(1/5) at 32 is 1/80.
        let found: Dual<1> = fifth_root(Dual::variable(32.0, 0));
        assert!((found.derivatives[0] - 0.0125).abs() < 1e-16);
    }
}
