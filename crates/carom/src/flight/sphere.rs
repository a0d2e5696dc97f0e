//! How a ball moves on the cloth and through the air between events.
//!
//! On the cloth the friction is constant while the ball slides, and while it rolls; its spin about the vertical decays
//! by itself. So seen from above every flight is a polynomial of degree two, like a disc's in a field. With the slip
//! `u = (v_x − R ω_y, v_y + R ω_x)` of the lowest point, û its direction and g the gravity:
//!
//! | motion | v̇ | ω̇ in the plane | lasts |
//! |---|---|---|---|
//! | sliding | −μ_s g û | (5 μ_s g / 2R) ẑ × û | 2 \|u\| / (7 μ_s g) |
//! | rolling | −μ_r g v̂ | ẑ × v̇ / R | \|v\| / (μ_r g) |
//! | spinning | 0 | 0 | \|ω_z\| / α_z |
//! | airborne | −g ẑ | 0 | until z = R |
//!
//! On the cloth ω̇_z = −α_z sgn ω_z until ω_z is zero, which is no event; in the air the spin stays.
//!
//! Source: W. Leckie, M. Greenspan, An event-based pool physics simulator, LNCS 4250 (2006); the sliding ball is Coriolis'
//! (1835).

use super::Flight;
use crate::geometry::{Vec2, Vec3};
use crate::model::{Sphere, Twist};
use crate::scalar::Scalar;
use serde::{Deserialize, Serialize};

/// How a ball moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Motion {
    /// It lies still.
    Resting,
    /// It spins in place.
    Spinning,
    /// Its lowest point slips on the cloth.
    Sliding,
    /// Its lowest point does not.
    Rolling,
    /// It flies over the cloth.
    Airborne,
    /// It lies in a pocket: out of play.
    Pocketed,
    /// It has left the table: out of play.
    OffTable,
}

/// A ball at some moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereState<S> {
    /// How it moves.
    pub motion: Motion,
    /// Its centre; on the cloth the height is its radius.
    pub position: Vec3<S>,
    /// Its velocity and spin.
    pub twist: Twist<S>,
}

/// A ball's closed-form motion since its own last event. Nothing but an event of that ball replaces it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereFlight<S> {
    /// How the ball moves.
    pub motion: Motion,
    /// The flight as seen from above.
    pub plan: Flight<S>,
    /// Height of the centre at the start.
    pub height: S,
    /// Velocity upwards at the start.
    pub rise: S,
    /// Acceleration upwards.
    pub lift: S,
    /// Spin at the start.
    pub spin: Vec3<S>,
    /// Rate of change of the spin; that about the vertical ends when it is zero.
    pub spin_rate: Vec3<S>,
    /// How long this motion lasts; infinite for ever.
    pub length: S,
}

impl Motion {
    /// Every motion, in the order of its code.
    pub const ALL: [Self; 7] = [
        Self::Resting,
        Self::Spinning,
        Self::Sliding,
        Self::Rolling,
        Self::Airborne,
        Self::Pocketed,
        Self::OffTable,
    ];

    /// The word used in files, on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::Resting => "resting",
            Self::Spinning => "spinning",
            Self::Sliding => "sliding",
            Self::Rolling => "rolling",
            Self::Airborne => "airborne",
            Self::Pocketed => "pocketed",
            Self::OffTable => "off_table",
        }
    }

    /// Whether the ball is no longer in play.
    #[inline(always)]
    pub fn is_out(self) -> bool {
        matches!(self, Self::Pocketed | Self::OffTable)
    }

    /// Whether the ball stays where it is.
    #[inline(always)]
    pub fn is_still(self) -> bool {
        matches!(self, Self::Resting | Self::Spinning | Self::Pocketed | Self::OffTable)
    }
}

impl<S: Scalar> SphereFlight<S> {
    /// A flight of a ball that stays where it is, without spin.
    pub fn still(motion: Motion, start: S, position: Vec3<S>) -> Self {
        let plan =
            Flight { start, position: position.plan(), velocity: Vec2::ZERO, acceleration: Vec2::ZERO };
        Self {
            motion,
            plan,
            height: position.z,
            rise: S::ZERO,
            lift: S::ZERO,
            spin: Vec3::ZERO,
            spin_rate: Vec3::ZERO,
            length: S::INFINITY,
        }
    }

    /// When it begins.
    #[inline(always)]
    pub fn start(&self) -> S {
        self.plan.start
    }

    /// Its acceleration.
    #[inline(always)]
    pub fn acceleration(&self) -> Vec3<S> {
        Vec3::above(self.plan.acceleration, self.lift)
    }

    /// Position a time `elapsed` after the start.
    #[inline(always)]
    pub fn position_after(&self, elapsed: S) -> Vec3<S> {
        let z = self.height + (self.rise + self.lift * (elapsed * S::from_f64(0.5))) * elapsed;
        Vec3::above(self.plan.position_after(elapsed), z)
    }

    /// Velocity a time `elapsed` after the start.
    #[inline(always)]
    pub fn velocity_after(&self, elapsed: S) -> Vec3<S> {
        Vec3::above(self.plan.velocity_after(elapsed), self.rise + self.lift * elapsed)
    }

    /// Spin a time `elapsed` after the start.
    pub fn spin_after(&self, elapsed: S) -> Vec3<S> {
        let mut spin = self.spin + self.spin_rate * elapsed;
        if spin.z * self.spin.z <= S::ZERO {
            spin.z = S::ZERO;
        }
        spin
    }

    /// The state a time `elapsed` after the start.
    pub fn state_after(&self, elapsed: S) -> SphereState<S> {
        SphereState {
            motion: self.motion,
            position: self.position_after(elapsed),
            twist: Twist { velocity: self.velocity_after(elapsed), spin: self.spin_after(elapsed) },
        }
    }

    /// The state at the end of this motion: what it ends with is exact, a ball that has stopped does not creep.
    pub fn end(&self, sphere: &Sphere<S>) -> SphereState<S> {
        let mut state = self.state_after(self.length);
        let twist = &mut state.twist;
        match self.motion {
            Motion::Sliding => {
                let slip =
                    Twist { velocity: self.velocity_after(S::ZERO), spin: self.spin }.slip(sphere.radius);
                let velocity = self.plan.velocity - slip * (S::from_f64(2.0) / S::from_f64(7.0));
                twist.velocity = Vec3::above(velocity, S::ZERO);
                (twist.spin.x, twist.spin.y) = rolling_spin(velocity, sphere.radius);
            }
            Motion::Rolling => {
                twist.velocity = Vec3::ZERO;
                (twist.spin.x, twist.spin.y) = (S::ZERO, S::ZERO);
            }
            Motion::Spinning => twist.spin = Vec3::ZERO,
            Motion::Airborne => state.position.z = sphere.radius,
            Motion::Resting | Motion::Pocketed | Motion::OffTable => {}
        }
        state
    }
}

/// The spin in the plane of a ball that rolls: ẑ × v / R.
#[inline(always)]
pub(super) fn rolling_spin<S: Scalar>(velocity: Vec2<S>, radius: S) -> (S, S) {
    (-velocity.y / radius, velocity.x / radius)
}
