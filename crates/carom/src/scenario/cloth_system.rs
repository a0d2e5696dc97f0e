//! A checked scenario of balls on a cloth made ready to compute.

use super::schema::Cluster;
use crate::flight::Cloth;
use crate::geometry::Vec3;
use crate::law::{ball_ball, ball_cushion, cue_ball};
use crate::model::{ContactTolerance, Face, Hole, Sphere, Twist};
use crate::scalar::Scalar;

/// Everything the engine needs, with every number in `S` and every name turned into an index.
///
/// Cushions are numbered as the table has them, corners after them, pockets after those.
#[derive(Clone, Debug)]
pub struct ClothSystem<S> {
    /// The balls.
    pub spheres: Vec<Sphere<S>>,
    /// How they start.
    pub starts: Vec<(Vec3<S>, Twist<S>)>,
    /// The cue's strike at the start.
    pub stroke: Option<Stroke<S>>,
    /// The faces of cushions and corners.
    pub faces: Vec<Face<S>>,
    /// How each ball touches the noses of cushions.
    pub noses: Vec<NoseReach<S>>,
    /// The law of each face.
    pub cushion_laws: Vec<ball_cushion::SphereLaw<S>>,
    /// The pockets.
    pub holes: Vec<Hole<S>>,
    /// The cloth.
    pub cloth: Cloth<S>,
    /// The law between balls.
    pub ball_ball: ball_ball::SphereLaw<S>,
    /// The law of several contacts at one instant.
    pub cluster: Cluster,
    /// For each ball the speed up to which contacts lose nothing: v_c = 0.005 √(2 g R).
    pub kept_speeds: Vec<S>,
    /// For each ball the time within which contacts count as following each other too fast: 1e-3 √(2R/g).
    pub collapse_times: Vec<S>,
    /// The contact tolerance δ.
    pub tolerance: ContactTolerance<S>,
    /// When to end, if by time.
    pub duration: Option<S>,
    /// The balls' names.
    pub ball_ids: Vec<String>,
    /// The names of cushions, corners and pockets.
    pub cushion_ids: Vec<String>,
}

/// How a ball touches the noses of cushions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoseReach<S> {
    /// Height of the noses.
    pub height: S,
    /// Distance in plan from a nose to the centre of a ball on the cloth that touches it.
    pub reach: S,
    /// Sine of the contact angle of a ball on the cloth.
    pub sin: S,
    /// Its cosine.
    pub cos: S,
}

/// The cue, the ball that it strikes, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke<S> {
    /// The ball.
    pub ball: usize,
    /// The law of the contact, with what it knows of the cue.
    pub cue: cue_ball::PointContact<S>,
    /// The strike.
    pub strike: cue_ball::Strike<S>,
}

impl<S: Scalar> ClothSystem<S> {
    /// The number of a pocket among all cushions, corners and pockets.
    pub fn place_of(&self, pocket: u32) -> u32 {
        self.faces.len() as u32 + pocket
    }

    /// The energy of a ball's height above the cloth.
    pub fn height_energy(&self, sphere: &Sphere<S>, position: Vec3<S>) -> S {
        sphere.mass * self.cloth.gravity * (position.z - sphere.radius)
    }
}
