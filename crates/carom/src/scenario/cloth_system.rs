//! A checked scenario of balls on a cloth made ready to compute.

use super::layout::Number;
use super::places::Places;
use super::schema::{self, Cluster, Scenario};
use super::shot::{CueStart, ShotStart};
use super::start::BallStart;
use super::system::{CushionLaws, cushion_ids, faces};
use crate::flight::Cloth;
use crate::geometry::{Bounds, Vec3};
use crate::law::coefficient::{IncidenceFriction, NormalRestitution, SlipFriction};
use crate::law::{ball_ball, ball_cushion, cue_ball};
use crate::model::{ContactTolerance, Face, Hole, Nose, NoseContact, Sphere, Table, Twist};
use crate::scalar::{Scalar, other_leg};

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
    /// The boxes around them.
    pub boxes: Vec<Bounds<S>>,
    /// Their numbers from the longest to the shortest: the first are likeliest to be met.
    pub by_length: Vec<u32>,
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
    /// For each ball the time t_c = 0.05 √(2R/g), without gravity 0.05 R/v for the greatest speed v at the start: balls that
    /// are pressed together hop for so long, and contacts that follow each other faster lose nothing up to v_c.
    pub hop_times: Vec<S>,
    /// For each ball that speed, v_c = 0.005 √(2 g R).
    pub kept_speeds: Vec<S>,
    /// For each ball the time within which contacts count as following each other too fast: t_c/50.
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
    /// Height at which the noses are met from the air; for balls that touch them in plan that of a centre on the cloth, so
    /// that a ball which lands is where one that rolls could be.
    pub height: S,
    /// Distance in plan from a nose to the centre of a ball on the cloth that touches it.
    pub reach: S,
    /// Sine and cosine of the contact angle θ of a ball on the cloth, sin θ = (h − R)/R.
    pub tilt: (S, S),
    /// The same of the direction from its centre to the nose, which is another where a ball touches the nose in plan.
    pub direction: (S, S),
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

    /// The system of a checked scenario of balls on a cloth.
    pub fn new(scenario: &Scenario) -> Self {
        Self::with(scenario, &mut |_, value| S::from_f64(value))
    }

    /// The system of a checked scenario, each of whose numbers enters through `number` with its place: so the derivative
    /// of a run with respect to one number is had by making that one a variable.
    pub fn with(scenario: &Scenario, number: Number<'_, S>) -> Self {
        let scenario = &*scenario.expanded();
        let table = scenario.table.layout(number);
        let cloth = cloth(scenario.physics.flight(), number);
        let starts: Vec<_> = (scenario.balls.iter().enumerate())
            .map(|(k, ball)| ball.start(k, &scenario.ball_defaults, number))
            .collect();
        let spheres: Vec<_> = starts.iter().map(BallStart::sphere).collect();
        let holes = table.pockets.iter().map(|pocket| Hole::new(pocket.center, pocket.radius)).collect();
        let faces = faces(&table);
        let stroke = stroke(scenario, number);
        let starts: Vec<_> = starts.iter().map(|start| (start.position, start.twist())).collect();
        let fastest = fastest(&spheres, &starts, stroke.as_ref());
        let times: Vec<_> = spheres.iter().map(|sphere| own_time(sphere, &cloth, fastest)).collect();
        Self {
            stroke,
            noses: spheres.iter().map(|sphere| nose_reach(sphere, &table.nose)).collect(),
            cushion_laws: CushionLaws::new(&scenario.physics, &mut |place, law| {
                cushion_law(place, law, number)
            })
            .of_table(&table),
            ball_ball: ball_ball_law(scenario.physics.ball_ball(), number),
            cluster: scenario.physics.cluster(),
            hop_times: times.iter().map(|time| *time * S::from_f64(HOP_TIME)).collect(),
            kept_speeds: spheres.iter().map(|sphere| kept_speed(sphere, &cloth)).collect(),
            collapse_times: times.iter().map(|time| *time * S::from_f64(COLLAPSE_TIME)).collect(),
            tolerance: ContactTolerance::new(&table),
            duration: scenario.duration.map(|value| number(&"duration", value)),
            ball_ids: scenario.balls.iter().map(|ball| ball.id.clone()).collect(),
            cushion_ids: place_ids(&table),
            boxes: faces.iter().map(Face::bounds).collect(),
            by_length: by_length(&faces),
            faces,
            starts,
            spheres,
            holes,
            cloth,
        }
    }
}

impl<S: Scalar> ClothSystem<S> {
    /// Puts in the numbers that stand in some places: the system is then that of the scenario which says so.
    pub fn put(&mut self, places: &Places) {
        if let Some(stroke) = places.stroke() {
            self.stroke = Some(stroke);
            self.set_times();
        }
        if let Some(laws) = places.laws() {
            self.ball_ball = ball_ball_law(laws.ball_ball(), &mut |_, value| S::from_f64(value));
            let law = |law| cushion_law("", law, &mut |_, value| S::from_f64(value));
            self.cushion_laws.iter_mut().zip(laws.of_faces()).for_each(|(old, new)| *old = law(new));
        }
    }

    /// With gravity no ball's time depends on how fast any is.
    fn set_times(&mut self) {
        if self.cloth.gravity > S::ZERO {
            return;
        }
        let fastest = fastest(&self.spheres, &self.starts, self.stroke.as_ref());
        for (ball, sphere) in self.spheres.iter().enumerate() {
            let time = own_time(sphere, &self.cloth, fastest);
            self.hop_times[ball] = time * S::from_f64(HOP_TIME);
            self.collapse_times[ball] = time * S::from_f64(COLLAPSE_TIME);
        }
    }
}

/// t_c as a part of a ball's own time.
const HOP_TIME: f64 = 0.05;

/// The same of the time within which contacts count as following each other too fast.
const COLLAPSE_TIME: f64 = 1e-3;

/// v_c as a part of the speed √(2gR) of a fall by a ball's radius.
const KEPT_SPEED: f64 = 0.005;

/// The time √(2R/g) in which a ball falls by its radius; without gravity, where all that presses a ball onto something is
/// a hollow cushion, the time in which the fastest goes as far.
fn own_time<S: Scalar>(sphere: &Sphere<S>, cloth: &Cloth<S>, fastest: S) -> S {
    if cloth.gravity > S::ZERO {
        (S::from_f64(2.0) * sphere.radius / cloth.gravity).sqrt()
    } else if fastest > S::ZERO {
        sphere.radius / fastest
    } else {
        S::ZERO
    }
}

/// The speed v_c; zero without gravity, where no friction presses balls together.
fn kept_speed<S: Scalar>(sphere: &Sphere<S>, cloth: &Cloth<S>) -> S {
    (S::from_f64(2.0) * cloth.gravity * sphere.radius).sqrt() * S::from_f64(KEPT_SPEED)
}

/// A speed that none of the balls much exceeds, their spins counted in.
fn fastest<S: Scalar>(
    spheres: &[Sphere<S>],
    starts: &[(Vec3<S>, Twist<S>)],
    stroke: Option<&Stroke<S>>,
) -> S {
    let speed = |(sphere, (_, twist)): (&Sphere<S>, &(Vec3<S>, Twist<S>))| {
        (twist.velocity.norm() + twist.spin.norm() * sphere.radius).detached()
    };
    let struck = stroke.map(|stroke| stroke.strike.speed.detached());
    spheres
        .iter()
        .zip(starts)
        .map(speed)
        .chain(struck)
        .fold(S::ZERO, |most, speed| if speed > most { speed } else { most })
}

fn cloth<S: Scalar>(flight: &schema::Flight, number: Number<'_, S>) -> Cloth<S> {
    let mut parameter = |key: &str, value: f64| number(&format_args!("physics.flight.{key}"), value);
    match flight {
        schema::Flight::Cloth { gravity, restitution, friction, min_hop, air } => Cloth {
            gravity: parameter("gravity", *gravity),
            restitution: parameter("restitution", *restitution),
            friction: friction.map(|friction| parameter("friction", friction)),
            min_hop: parameter("min_hop", *min_hop),
            has_air: *air,
        },
        // A checked scenario of this dynamics has a cloth; on nothing balls slide for ever.
        schema::Flight::Free | schema::Flight::Field { .. } => {
            Cloth { gravity: S::ZERO, restitution: S::ZERO, friction: None, min_hop: S::ZERO, has_air: false }
        }
    }
}

pub(super) fn stroke<S: Scalar>(scenario: &Scenario, number: Number<'_, S>) -> Option<Stroke<S>> {
    let ShotStart { ball, speed, direction, elevation, left, top } = scenario.shot_start(number)?;
    let CueStart { mass, end_mass, restitution, miscue_offset, .. } = scenario.cue.start(number);
    Some(Stroke {
        ball,
        cue: cue_ball::PointContact { mass, end_mass, restitution, miscue_offset },
        strike: cue_ball::Strike { speed, direction, elevation, left, top },
    })
}

/// How a ball on the cloth touches noses: where they are, or, in plan, at one radius.
fn nose_reach<S: Scalar>(sphere: &Sphere<S>, nose: &Nose<S>) -> NoseReach<S> {
    let height = nose.height.unwrap_or(sphere.radius);
    let sin = (height - sphere.radius) / sphere.radius;
    let cos = other_leg(sin);
    let (height, direction) = match nose.contact {
        NoseContact::Nose => (height, (sin, cos)),
        NoseContact::Plan => {
            let slant = (S::ONE + sin.squared()).sqrt();
            (sphere.radius, (sin / slant, S::ONE / slant))
        }
    };
    NoseReach { height, reach: nose.reach(sphere.radius, sphere.radius), tilt: (sin, cos), direction }
}

fn cushion_law<S: Scalar>(
    place: &str,
    law: &schema::BallCushion,
    number: Number<'_, S>,
) -> ball_cushion::SphereLaw<S> {
    use ball_cushion::{Frictional, Han2005, Mathavan2010, Restitution, SphereLaw, StrongeCompliant};
    let mut at = |key: &str, value: f64| number(&format_args!("{place}.{key}"), value);
    match law {
        schema::BallCushion::Elastic => SphereLaw::ELASTIC,
        schema::BallCushion::Restitution { normal, tangential } => SphereLaw::Restitution(Restitution {
            normal: at("normal", *normal),
            tangential: at("tangential", *tangential),
        }),
        schema::BallCushion::Damping { factor } => {
            let factor = at("factor", *factor);
            SphereLaw::Restitution(Restitution { normal: factor, tangential: factor })
        }
        schema::BallCushion::Frictional { normal, friction } => SphereLaw::Frictional(Frictional {
            normal: restitution(normal, &mut at),
            friction: incidence(friction, &mut at),
        }),
        schema::BallCushion::Han2005 { normal, friction } => SphereLaw::Han2005(Han2005 {
            normal: restitution(normal, &mut at),
            friction: incidence(friction, &mut at),
        }),
        schema::BallCushion::Mathavan2010 { normal, friction } => SphereLaw::Mathavan2010(Mathavan2010 {
            normal: restitution(normal, &mut at),
            friction: incidence(friction, &mut at),
        }),
        schema::BallCushion::StrongeCompliant { normal, friction, frequency_ratio } => {
            SphereLaw::StrongeCompliant(StrongeCompliant {
                normal: restitution(normal, &mut at),
                friction: incidence(friction, &mut at),
                frequency_ratio: at("frequency_ratio", *frequency_ratio),
            })
        }
    }
}

type At<'a, S> = &'a mut dyn FnMut(&str, f64) -> S;

fn restitution<S: Scalar>(normal: &schema::Rebound, at: At<'_, S>) -> NormalRestitution<S> {
    match normal {
        schema::Rebound::Constant(value) => NormalRestitution::Constant(at("normal", *value)),
        schema::Rebound::BySpeed { by_speed: [c0, c1, c2], up_to } => NormalRestitution::BySpeed {
            coefficients: [
                at("normal.by_speed[0]", *c0),
                at("normal.by_speed[1]", *c1),
                at("normal.by_speed[2]", *c2),
            ],
            up_to: at("normal.up_to", *up_to),
        },
    }
}

fn incidence<S: Scalar>(friction: &schema::CushionFriction, at: At<'_, S>) -> IncidenceFriction<S> {
    match friction {
        schema::CushionFriction::Constant(value) => IncidenceFriction::Constant(at("friction", *value)),
        schema::CushionFriction::ByIncidence { by_incidence: [c0, c1] } => IncidenceFriction::ByIncidence {
            coefficients: [at("friction.by_incidence[0]", *c0), at("friction.by_incidence[1]", *c1)],
        },
    }
}

fn ball_ball_law<S: Scalar>(law: &schema::BallBall, number: Number<'_, S>) -> ball_ball::SphereLaw<S> {
    use ball_ball::{Frictional, Mathavan2014, Restitution, SphereLaw};
    let mut at = |key: &str, value: f64| number(&format_args!("physics.ball_ball.{key}"), value);
    match law {
        schema::BallBall::Elastic => SphereLaw::ELASTIC,
        schema::BallBall::Restitution { normal } => {
            SphereLaw::Restitution(Restitution { normal: at("normal", *normal) })
        }
        schema::BallBall::Frictional { normal, friction, cling } => SphereLaw::Frictional(Frictional {
            normal: at("normal", *normal),
            friction: slip(friction, &mut at),
            cling: at("cling", *cling),
        }),
        schema::BallBall::Mathavan2014 { normal, friction } => SphereLaw::Mathavan2014(Mathavan2014 {
            normal: at("normal", *normal),
            friction: slip(friction, &mut at),
        }),
    }
}

fn slip<S: Scalar>(friction: &schema::SlipFriction, at: At<'_, S>) -> SlipFriction<S> {
    match friction {
        schema::SlipFriction::Constant(value) => SlipFriction::Constant(at("friction", *value)),
        schema::SlipFriction::Falling { a, b, c } => {
            SlipFriction::BySlip { a: at("friction.a", *a), b: at("friction.b", *b), c: at("friction.c", *c) }
        }
    }
}

/// The numbers of the faces, straight ones first and longer ones before shorter ones.
fn by_length<S: Scalar>(faces: &[Face<S>]) -> Vec<u32> {
    let length = |number: &u32| match &faces[*number as usize] {
        Face::Line(line) => line.length.to_f64(),
        Face::Round(_) => 0.0,
    };
    let mut numbers: Vec<u32> = (0..faces.len() as u32).collect();
    numbers.sort_by(|a, b| length(b).total_cmp(&length(a)));
    numbers
}

fn place_ids<S: Scalar>(table: &Table<S>) -> Vec<String> {
    let mut ids = cushion_ids(table);
    ids.extend(table.pockets.iter().map(|pocket| pocket.id.clone()));
    ids
}
