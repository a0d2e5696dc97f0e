//! `[physics]`: the laws of motion and of collision.

use super::is_default;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The laws of motion and of collision.
///
/// What is absent is that of the table's preset, where it has one; and a law that is written replaces the preset's whole.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Physics {
    /// How balls move between events; absent: free flight.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flight: Option<Flight>,
    /// What happens when two balls meet; absent: elastic.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball_ball: Option<BallBall>,
    /// What happens when a ball meets a cushion; absent: elastic.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ball_cushion: Option<BallCushion>,
    /// Laws of single cushions and corners, by their ids, in place of `ball_cushion`. A corner without one has the law of
    /// the first of its two cushions.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub cushions: BTreeMap<String, BallCushion>,
    /// How contacts at one instant are resolved; absent: hertz for balls on a cloth, reflections for others.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cluster: Option<Cluster>,
    /// What is done when a ball's contacts follow each other without end in a finite time; absent: stop.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub collapse: Option<Collapse>,
}

impl Physics {
    /// How balls move between events.
    pub fn flight(&self) -> &Flight {
        self.flight.as_ref().unwrap_or(&Flight::Free)
    }

    /// Whether balls roll and spin on a cloth, so that the run is one of cue balls.
    pub fn has_cloth(&self) -> bool {
        matches!(self.flight(), Flight::Cloth { .. })
    }

    /// What happens when two balls meet.
    pub fn ball_ball(&self) -> &BallBall {
        self.ball_ball.as_ref().unwrap_or(&BallBall::Elastic)
    }

    /// What happens when a ball meets a cushion that has no law of its own.
    pub fn ball_cushion(&self) -> &BallCushion {
        self.ball_cushion.as_ref().unwrap_or(&BallCushion::Elastic)
    }

    /// The law of a cushion: its own where it has one.
    pub fn law_of_cushion(&self, id: &str) -> &BallCushion {
        self.cushions.get(id).unwrap_or_else(|| self.ball_cushion())
    }

    /// How contacts at one instant are resolved.
    pub fn cluster(&self) -> Cluster {
        let default = if self.has_cloth() { Cluster::Hertz } else { Cluster::Reflections };
        self.cluster.unwrap_or(default)
    }

    /// What is done when a ball's contacts follow each other without end in a finite time.
    pub fn collapse(&self) -> Collapse {
        self.collapse.unwrap_or_default()
    }
}

/// How balls move between events.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "law", rename_all = "snake_case", deny_unknown_fields)]
pub enum Flight {
    /// Straight ahead at constant velocity.
    #[default]
    Free,
    /// With the same constant acceleration for all balls.
    Field {
        /// Acceleration [x, y], in length per time squared.
        acceleration: [f64; 2],
    },
    /// Rolling, sliding and spinning on a cloth, and through the air above it: the balls are spheres. How a ball rubs on
    /// the cloth stands among its own keys.
    Cloth {
        /// Acceleration of free fall, in length per time squared; zero or positive; absent: 9.81.
        #[serde(default = "earth")]
        #[schemars(range(min = 0.0))]
        gravity: f64,
        /// Speed up from the cloth over speed down to it, of a ball that lands, from 0 to 1; absent: 0.5.
        #[serde(default = "half")]
        #[schemars(range(min = 0.0, max = 1.0))]
        restitution: f64,
        /// Coefficient of friction of a landing; absent: the ball's own `sliding_friction`.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(range(min = 0.0))]
        friction: Option<f64>,
        /// Hops that would rise less than this, in length, are left out; absent: 0.005.
        #[serde(default = "five_millimetres")]
        #[schemars(range(min = 0.0))]
        min_hop: f64,
        /// Whether balls can leave the cloth; absent: true.
        #[serde(default = "yes")]
        air: bool,
    },
}

/// What happens when two balls meet.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "law", rename_all = "snake_case", deny_unknown_fields)]
pub enum BallBall {
    /// The closing speed is reversed; no energy is lost.
    #[default]
    Elastic,
    /// The balls part at a fraction of their closing speed.
    Restitution {
        /// That fraction, from 0 (they stay together) to 1 (elastic).
        #[schemars(range(min = 0.0, max = 1.0))]
        normal: f64,
    },
    /// With restitution, and friction where the balls' surfaces slip on each other: throw, and spin passed on.
    Frictional {
        /// Speed of parting over closing speed, from 0 to 1.
        #[schemars(range(min = 0.0, max = 1.0))]
        normal: f64,
        /// The coefficient of friction between balls; absent: Alciatore's fit, which falls with the slip speed.
        #[serde(default, skip_serializing_if = "is_default")]
        friction: SlipFriction,
        /// What friction is multiplied with: more than 1 for balls that cling; absent: 1.
        #[serde(default = "one")]
        #[schemars(range(min = 0.0))]
        cling: f64,
    },
    /// Mathavan, Jackson and Parkin's law of 2014: friction between the balls and of the ball that is pressed onto the
    /// cloth, summed over the course of the blow.
    #[serde(rename = "mathavan_2014")]
    Mathavan2014 {
        /// Speed of parting over closing speed, from 0 to 1; its square is the part of the work that comes back.
        #[schemars(range(min = 0.0, max = 1.0))]
        normal: f64,
        /// The coefficient of friction between balls; absent: Alciatore's fit, which falls with the slip speed.
        #[serde(default, skip_serializing_if = "is_default")]
        friction: SlipFriction,
    },
}

impl BallBall {
    /// The law's numbers, by their keys.
    pub(crate) fn numbers(&self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Elastic => Vec::new(),
            Self::Restitution { normal } => vec![("normal", *normal)],
            Self::Frictional { normal, friction, cling } => {
                let mut numbers = vec![("normal", *normal), ("cling", *cling)];
                numbers.extend(friction.numbers());
                numbers
            }
            Self::Mathavan2014 { normal, friction } => {
                let mut numbers = vec![("normal", *normal)];
                numbers.extend(friction.numbers());
                numbers
            }
        }
    }

    /// The law's own number under a key; those of a friction that depends on the slip are left out.
    pub(crate) fn coefficient(&mut self, key: &str) -> Option<&mut f64> {
        match (key, self) {
            (
                "normal",
                Self::Restitution { normal }
                | Self::Frictional { normal, .. }
                | Self::Mathavan2014 { normal, .. },
            ) => Some(normal),
            (
                "friction",
                Self::Frictional { friction: SlipFriction::Constant(value), .. }
                | Self::Mathavan2014 { friction: SlipFriction::Constant(value), .. },
            ) => Some(value),
            ("cling", Self::Frictional { cling, .. }) => Some(cling),
            _ => None,
        }
    }

    /// The word of a law whose balls have spin, and so need a cloth.
    pub(crate) fn needs_cloth(&self) -> Option<&'static str> {
        match self {
            Self::Elastic | Self::Restitution { .. } => None,
            Self::Frictional { .. } => Some("frictional"),
            Self::Mathavan2014 { .. } => Some("mathavan_2014"),
        }
    }
}

/// A coefficient of friction between balls: one number, or one that depends on the speed at which they slip.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum SlipFriction {
    /// The same at any speed.
    Constant(#[schemars(range(min = 0.0))] f64),
    /// a + b exp(−c s) at the slip speed s.
    Falling {
        /// What is left at high speeds.
        #[schemars(range(min = 0.0))]
        a: f64,
        /// How much more it is where the slip begins.
        #[schemars(range(min = 0.0))]
        b: f64,
        /// How fast it falls, in time per length.
        #[schemars(range(min = 0.0))]
        c: f64,
    },
}

impl SlipFriction {
    /// Alciatore's fit to Marlow's measurements, speeds in m/s (D. Alciatore, TP A.14).
    pub const ALCIATORE: Self = Self::Falling { a: 0.009951, b: 0.108, c: 1.088 };

    fn numbers(&self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Constant(value) => vec![("friction", *value)],
            Self::Falling { a, b, c } => vec![("friction.a", *a), ("friction.b", *b), ("friction.c", *c)],
        }
    }
}

impl Default for SlipFriction {
    fn default() -> Self {
        Self::ALCIATORE
    }
}

/// What happens when a ball meets a cushion.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "law", rename_all = "snake_case", deny_unknown_fields)]
pub enum BallCushion {
    /// Reflected as light by a mirror; no energy is lost.
    #[default]
    Elastic,
    /// The normal and the tangential part of the velocity are each multiplied by a factor.
    Restitution {
        /// Speed away from the cushion over speed towards it, from 0 to 1.
        #[schemars(range(min = 0.0, max = 1.0))]
        normal: f64,
        /// Speed along the cushion after over before, from 0 to 1; absent: 1.
        #[serde(default = "one")]
        #[schemars(range(min = 0.0, max = 1.0))]
        tangential: f64,
    },
    /// The reflected velocity is multiplied by a factor: `restitution` with `normal` and `tangential` both this.
    Damping {
        /// That factor, from 0 to 1.
        #[schemars(range(min = 0.0, max = 1.0))]
        factor: f64,
    },
    /// With restitution, and friction at the point where the nose touches the ball: one impulse at that point.
    Frictional {
        /// Speed away over speed towards, along the normal, from 0 to 1.
        normal: Rebound,
        /// The coefficient of friction with the cushion.
        friction: CushionFriction,
    },
    /// Han's law of 2005: sticking or slipping at the point of contact.
    #[serde(rename = "han_2005")]
    Han2005 {
        /// Speed away over speed towards, along the normal, from 0 to 1. Han's own: `by_speed = [0.39, 0.257, -0.044]`.
        normal: Rebound,
        /// The coefficient of friction with the cushion. Han's own: `by_incidence = [0.471, -0.241]`.
        friction: CushionFriction,
    },
    /// Mathavan, Jackson and Parkin's law of 2010: friction with the cushion and the cloth, summed over the course of the
    /// blow.
    #[serde(rename = "mathavan_2010")]
    Mathavan2010 {
        /// The square root of the part of the work that comes back, from 0 to 1.
        normal: Rebound,
        /// The coefficient of friction with the cushion.
        friction: CushionFriction,
    },
    /// Stronge's law: a cushion that gives way along the nose too, as a spring.
    StrongeCompliant {
        /// The energetic coefficient of restitution, from 0 to 1.
        normal: Rebound,
        /// The coefficient of friction with the cushion.
        friction: CushionFriction,
        /// Frequency of the swing along the nose over that of the swing into it, from 1 to 2; absent: 1.8.
        #[serde(default = "pooltool_ratio")]
        #[schemars(range(min = 1.0, max = 2.0))]
        frequency_ratio: f64,
    },
}

impl BallCushion {
    /// The law's numbers, by their keys.
    pub(crate) fn numbers(&self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Elastic => Vec::new(),
            Self::Restitution { normal, tangential } => {
                vec![("normal", *normal), ("tangential", *tangential)]
            }
            Self::Damping { factor } => vec![("factor", *factor)],
            Self::Frictional { normal, friction }
            | Self::Han2005 { normal, friction }
            | Self::Mathavan2010 { normal, friction } => {
                normal.numbers().into_iter().chain(friction.numbers()).collect()
            }
            Self::StrongeCompliant { normal, friction, frequency_ratio } => {
                let ratio = ("frequency_ratio", *frequency_ratio);
                normal.numbers().into_iter().chain(friction.numbers()).chain([ratio]).collect()
            }
        }
    }

    /// The law's own number under a key; those of a restitution or a friction that depends on something are left out.
    pub(crate) fn coefficient(&mut self, key: &str) -> Option<&mut f64> {
        match (key, self) {
            ("normal", Self::Restitution { normal, .. }) => Some(normal),
            ("tangential", Self::Restitution { tangential, .. }) => Some(tangential),
            ("factor", Self::Damping { factor }) => Some(factor),
            (
                "normal",
                Self::Frictional { normal: Rebound::Constant(value), .. }
                | Self::Han2005 { normal: Rebound::Constant(value), .. }
                | Self::Mathavan2010 { normal: Rebound::Constant(value), .. }
                | Self::StrongeCompliant { normal: Rebound::Constant(value), .. },
            ) => Some(value),
            (
                "friction",
                Self::Frictional { friction: CushionFriction::Constant(value), .. }
                | Self::Han2005 { friction: CushionFriction::Constant(value), .. }
                | Self::Mathavan2010 { friction: CushionFriction::Constant(value), .. }
                | Self::StrongeCompliant { friction: CushionFriction::Constant(value), .. },
            ) => Some(value),
            ("frequency_ratio", Self::StrongeCompliant { frequency_ratio, .. }) => Some(frequency_ratio),
            _ => None,
        }
    }

    /// Restitution and friction of a law whose balls have spin, and so need a cloth, with its word.
    pub(crate) fn with_spin(&self) -> Option<(&'static str, Rebound, CushionFriction)> {
        match self {
            Self::Elastic | Self::Restitution { .. } | Self::Damping { .. } => None,
            Self::Frictional { normal, friction } => Some(("frictional", *normal, *friction)),
            Self::Han2005 { normal, friction } => Some(("han_2005", *normal, *friction)),
            Self::Mathavan2010 { normal, friction } => Some(("mathavan_2010", *normal, *friction)),
            Self::StrongeCompliant { normal, friction, .. } => {
                Some(("stronge_compliant", *normal, *friction))
            }
        }
    }
}

/// A coefficient of restitution: one number, or one that depends on the closing speed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum Rebound {
    /// The same at any speed.
    Constant(#[schemars(range(min = 0.0, max = 1.0))] f64),
    /// c0 + c1 v + c2 v² at the closing speed v.
    BySpeed {
        /// The coefficients [c0, c1, c2]; what they give must lie between 0 and 1 for all speeds up to `up_to`.
        by_speed: [f64; 3],
        /// Faster contacts have the restitution of this speed; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        up_to: f64,
    },
}

impl Rebound {
    fn numbers(&self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Constant(value) => vec![("normal", *value)],
            Self::BySpeed { by_speed: [c0, c1, c2], up_to } => vec![
                ("normal.by_speed[0]", *c0),
                ("normal.by_speed[1]", *c1),
                ("normal.by_speed[2]", *c2),
                ("normal.up_to", *up_to),
            ],
        }
    }
}

/// A coefficient of friction with a cushion: one number, or one that depends on the angle of incidence.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum CushionFriction {
    /// The same at any angle.
    Constant(#[schemars(range(min = 0.0))] f64),
    /// c0 + c1 θ at the angle θ between velocity and normal, in radians.
    ByIncidence {
        /// The coefficients [c0, c1]; what they give must not be negative for angles from 0 to π/2.
        by_incidence: [f64; 2],
    },
}

impl CushionFriction {
    fn numbers(&self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Constant(value) => vec![("friction", *value)],
            Self::ByIncidence { by_incidence: [c0, c1] } => {
                vec![("friction.by_incidence[0]", *c0), ("friction.by_incidence[1]", *c1)]
            }
        }
    }
}

/// How contacts at one instant are resolved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Cluster {
    /// All closing contacts at once, again and again until none closes.
    #[default]
    Reflections,
    /// As stiff elastic balls do, which press on all their neighbours for the short while that a contact takes.
    Hertz,
    /// One contact after the other.
    Pairwise,
}

/// What is done when a ball's contacts follow each other without end in a finite time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Collapse {
    /// The run ends with the status `collapsed`.
    #[default]
    Stop,
    /// Contacts less than t_c after a ball's last one lose nothing, and in a field balls part from each other and from
    /// cushions with a hop of about t_c at least: so they go on hopping, with hops too small to see, and do not come to
    /// rest. t_c is `1e-3 √(2r/|a|)` in a field a, `1e-6 r` over the greatest speed at the start without.
    Tc,
}

fn one() -> f64 {
    1.0
}

fn half() -> f64 {
    0.5
}

/// Standard gravity, to the two digits that matter on a cloth, in m/s².
fn earth() -> f64 {
    9.81
}

fn five_millimetres() -> f64 {
    0.005
}

fn yes() -> bool {
    true
}

fn pooltool_ratio() -> f64 {
    1.8
}
