//! A checked scenario made ready to compute.

use crate::flight::Flight;
use crate::geometry::Vec2;
use crate::law::{ball_ball, ball_cushion};
use crate::model::{ContactTolerance, Disc, Face};
use crate::scalar::Scalar;

/// How several contacts at one instant are resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClusterLaw {
    /// All closing contacts at once.
    Reflections,
    /// One after the other, the most strongly closing first.
    Pairwise,
}

/// Everything the engine needs, with every number in `S` and every name turned into an index.
#[derive(Clone, Debug)]
pub struct System<S> {
    /// The balls.
    pub discs: Vec<Disc<S>>,
    /// Their flights at time zero.
    pub flights: Vec<Flight<S>>,
    /// The boundary, obstacles and corners.
    pub faces: Vec<Face<S>>,
    /// The law of each cushion.
    pub cushion_laws: Vec<ball_cushion::Restitution<S>>,
    /// For each cushion, the one on the other side of a thin wall.
    pub backs: Vec<Option<u32>>,
    /// Whether any cushion has a back.
    pub has_backs: bool,
    /// The constant acceleration of every ball that is not held.
    pub field: Vec2<S>,
    /// The law between balls.
    pub ball_ball: ball_ball::Restitution<S>,
    /// The law of clusters.
    pub cluster: ClusterLaw,
    /// For each ball the time t_c within which contacts count as following each other too fast.
    pub collapse_times: Vec<S>,
    /// Whether such contacts are without loss (the TC model of Luding and McNamara); else the run ends.
    pub collapse_is_elastic: bool,
    /// The contact tolerance δ.
    pub tolerance: ContactTolerance<S>,
    /// When to end.
    pub duration: Option<S>,
    /// The balls' names.
    pub ball_ids: Vec<String>,
    /// The cushions' names.
    pub cushion_ids: Vec<String>,
}
