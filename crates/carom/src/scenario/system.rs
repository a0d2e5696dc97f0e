//! A checked scenario made ready to compute.

use super::layout::Number;
use super::path::Key;
use super::places::Places;
use super::schema::{self, Cluster, Collapse, Scenario};
use super::start::BallStart;
use crate::flight::Flight;
use crate::geometry::{Bounds, Vec2};
use crate::law::{ball_ball, ball_cushion};
use crate::memory::room_for;
use crate::model::{ContactTolerance, Disc, Face, Faces, Line, Table};
use crate::scalar::Scalar;

/// Fewer balls than these are asked one by one sooner than looked for in a grid.
const GRID_FROM: usize = 14;

/// Everything the engine needs of a run of discs, with every number in `S` and every name turned into an index.
///
/// Cushions are numbered as the table has them, corners after them.
#[derive(Clone, Debug)]
pub struct System<S> {
    /// The balls.
    pub discs: Vec<Disc<S>>,
    /// Their flights at time zero.
    pub flights: Vec<Flight<S>>,
    /// The faces of cushions and corners.
    pub faces: Faces<S>,
    /// The law of each.
    pub cushion_laws: Vec<ball_cushion::Law<S>>,
    /// For each, the face on the other side of a thin wall.
    pub backs: Vec<Option<u32>>,
    /// Whether any has one.
    pub has_backs: bool,
    /// The constant acceleration of every ball that is not held.
    pub field: Vec2<S>,
    /// The law between balls.
    pub ball_ball: ball_ball::Law<S>,
    /// Whether no law takes any energy.
    pub is_lossless: bool,
    /// The law of several contacts at one instant.
    pub cluster: Cluster,
    /// For each ball the time t_c within which contacts count as following each other too fast.
    pub collapse_times: Vec<S>,
    /// Whether such contacts are without loss (the TC model of Luding and McNamara); else the run ends.
    pub collapse_is_elastic: bool,
    /// The box around the table.
    pub bounds: Bounds<S>,
    /// Which axes are periodic: who leaves the table on one side comes in on the other.
    pub periodic: [bool; 2],
    /// The contact tolerance δ.
    pub tolerance: ContactTolerance<S>,
    /// From so many balls on a grid tells who is near; it changes no bit of a run.
    pub grid_from: usize,
    /// When to end, if by time.
    pub duration: Option<S>,
    /// The balls' names.
    pub ball_ids: Vec<String>,
    /// The names of cushions and corners.
    pub cushion_ids: Vec<String>,
}

impl<S: Scalar> System<S> {
    /// The system of a checked scenario.
    pub fn new(scenario: &Scenario) -> Self {
        Self::with(scenario, &mut |_, value| S::from_f64(value))
    }

    /// The system of a checked scenario, each of whose numbers enters through `number` with its place.
    ///
    /// So the derivative of a run with respect to one number is had by making that one a variable:
    ///
    /// ```
    /// # use carom::scalar::{Dual, Scalar};
    /// # use carom::scenario::{Scenario, System};
    /// # let text = "duration = 1\n[table]\nshape = 'circle'\nradius = 1\n[[balls]]\nid = 'a'\nradius = 0.1\nposition = [0, 0]\nvelocity = [0.5, 0]";
    /// # let scenario = Scenario::from_toml(text).map_err(|e| e.to_string())?;
    /// let system = System::<Dual<1>>::with(&scenario, &mut |place, value| {
    ///     if place.to_string() == "balls[0].velocity[0]" { Dual::variable(value, 0) } else { Dual::from_f64(value) }
    /// });
    /// # assert_eq!(system.flights[0].velocity.x.derivatives, [1.0]);
    /// # Ok::<(), String>(())
    /// ```
    pub fn with(scenario: &Scenario, number: Number<'_, S>) -> Self {
        let scenario = &*scenario.expanded();
        let table = scenario.table.layout(number);
        let cushion_laws =
            CushionLaws::new(&scenario.physics, &mut |place, law| cushion_law(place, law, number))
                .of_table(&table);
        let ball_ball = ball_ball_law(scenario.physics.ball_ball(), number);
        let faces = faces(&table);
        let tolerance = ContactTolerance::new(&table);
        let backs = backs(&faces, tolerance.of(S::ZERO));
        let periodic = scenario.table.periodic();
        let mut faces = Faces::new(faces);
        faces.open(periodic);
        let field = field(scenario.physics.flight(), number);
        let starts: Vec<_> = (scenario.balls.iter().enumerate())
            .map(|(k, ball)| ball.start(k, &scenario.ball_defaults, number))
            .collect();
        let mut discs = room_for(starts.len());
        discs.extend(starts.iter().map(|start| Disc::new(start.radius, start.mass)));
        let flights: Vec<_> = starts.iter().map(|start| flight(start, field)).collect();
        Self {
            collapse_times: collapse_times(&discs, &flights, field, table.size()).collect(),
            collapse_is_elastic: scenario.physics.collapse() == Collapse::Tc,
            has_backs: backs.iter().any(Option::is_some),
            is_lossless: is_lossless(&ball_ball, &cushion_laws),
            ball_ball,
            cluster: scenario.physics.cluster(),
            grid_from: GRID_FROM,
            duration: scenario.duration.map(|value| number(&"duration", value)),
            ball_ids: scenario.balls.iter().map(|ball| ball.id.clone()).collect(),
            cushion_ids: cushion_ids(&table),
            bounds: table.bounds,
            periodic,
            discs,
            flights,
            faces,
            cushion_laws,
            backs,
            field,
            tolerance,
        }
    }

    /// Puts in the numbers that stand in some places: the system is then that of the scenario which says so.
    pub fn put(&mut self, places: &Places) {
        if places.has_velocities() {
            self.set_velocities(places.starts());
        }
        if let Some(laws) = places.laws() {
            self.ball_ball = ball_ball_law(laws.ball_ball(), &mut |_, value| S::from_f64(value));
            let law = |law| cushion_law("", law, &mut |_, value| S::from_f64(value));
            self.cushion_laws.iter_mut().zip(laws.of_faces()).for_each(|(old, new)| *old = law(new));
            self.is_lossless = is_lossless(&self.ball_ball, &self.cushion_laws);
        }
    }

    fn set_velocities(&mut self, starts: impl Iterator<Item = (usize, BallStart<S>)>) {
        for (ball, start) in starts {
            self.flights[ball] = flight(&start, self.field);
        }
        let times = collapse_times(&self.discs, &self.flights, self.field, self.tolerance.table_size());
        self.collapse_times.iter_mut().zip(times).for_each(|(old, new)| *old = new);
    }
}

fn is_lossless<S: Scalar>(ball_ball: &ball_ball::Law<S>, cushion_laws: &[ball_cushion::Law<S>]) -> bool {
    ball_ball.is_lossless() && cushion_laws.iter().all(ball_cushion::Law::is_lossless)
}

fn flight<S: Scalar>(start: &BallStart<S>, field: Vec2<S>) -> Flight<S> {
    let (position, velocity) = (start.position.plan(), start.velocity.plan());
    Flight { start: S::ZERO, position, velocity, acceleration: field }
}

/// The laws of cushions: each cushion's own, or the one for all.
pub(super) struct CushionLaws<L> {
    for_all: L,
    own: Vec<(String, L)>,
}

impl<L: Copy> CushionLaws<L> {
    /// The laws that `make` makes of what is written at a place.
    pub(super) fn new(
        physics: &schema::Physics,
        make: &mut dyn FnMut(&str, &schema::BallCushion) -> L,
    ) -> Self {
        let own = physics
            .cushions
            .iter()
            .map(|(id, law)| (id.clone(), make(&format!("physics.cushions.{}", Key(id)), law)));
        Self { own: own.collect(), for_all: make("physics.ball_cushion", physics.ball_cushion()) }
    }

    /// The laws of a table's cushions, and after them those of its corners, which have that of the first of their two
    /// cushions unless they have their own.
    pub(super) fn of_table<S: Scalar>(&self, table: &Table<S>) -> Vec<L> {
        let mut laws: Vec<L> =
            table.cushions().map(|cushion| self.own(&cushion.id).unwrap_or(self.for_all)).collect();
        for corner in &table.corners {
            laws.push(self.own(&corner.id).unwrap_or(laws[corner.cushions[0]]));
        }
        laws
    }

    fn own(&self, id: &str) -> Option<L> {
        self.own.iter().find(|(own, _)| own == id).map(|(_, law)| *law)
    }
}

/// The law that a scenario has at a place.
pub(super) fn cushion_law<S: Scalar>(
    place: &str,
    law: &schema::BallCushion,
    number: Number<'_, S>,
) -> ball_cushion::Law<S> {
    let mut parameter = |key: &str, value: f64| number(&format_args!("{place}.{key}"), value);
    match law {
        schema::BallCushion::Elastic => ball_cushion::Law::ELASTIC,
        schema::BallCushion::Restitution { normal, tangential } => {
            ball_cushion::Law::Restitution(ball_cushion::Restitution {
                normal: parameter("normal", *normal),
                tangential: parameter("tangential", *tangential),
            })
        }
        schema::BallCushion::Damping { factor } => {
            let factor = parameter("factor", *factor);
            ball_cushion::Law::Restitution(ball_cushion::Restitution { normal: factor, tangential: factor })
        }
        // Laws of balls with spin, which a check refuses for discs.
        schema::BallCushion::Frictional { .. }
        | schema::BallCushion::Han2005 { .. }
        | schema::BallCushion::Mathavan2010 { .. }
        | schema::BallCushion::StrongeCompliant { .. } => ball_cushion::Law::ELASTIC,
    }
}

/// The law between balls of a scenario.
pub(super) fn ball_ball_law<S: Scalar>(law: &schema::BallBall, number: Number<'_, S>) -> ball_ball::Law<S> {
    match law {
        schema::BallBall::Elastic => ball_ball::Law::ELASTIC,
        schema::BallBall::Restitution { normal } => ball_ball::Law::Restitution(ball_ball::Restitution {
            normal: number(&"physics.ball_ball.normal", *normal),
        }),
        // Laws of balls with spin, which a check refuses for discs.
        schema::BallBall::Frictional { .. } | schema::BallBall::Mathavan2014 { .. } => {
            ball_ball::Law::ELASTIC
        }
    }
}

fn field<S: Scalar>(flight: &schema::Flight, number: Number<'_, S>) -> Vec2<S> {
    match flight {
        schema::Flight::Free | schema::Flight::Cloth { .. } => Vec2::ZERO,
        schema::Flight::Field { acceleration: [x, y] } => {
            let x = number(&"physics.flight.acceleration[0]", *x);
            Vec2::new(x, number(&"physics.flight.acceleration[1]", *y))
        }
    }
}

pub(super) fn faces<S: Scalar>(table: &Table<S>) -> Vec<Face<S>> {
    let corners = table.corners.iter().map(|corner| Face::corner(corner.point));
    table.cushions().map(|cushion| Face::of_piece(&cushion.piece)).chain(corners).collect()
}

pub(super) fn cushion_ids<S: Scalar>(table: &Table<S>) -> Vec<String> {
    let corners = table.corners.iter().map(|corner| corner.id.clone());
    table.cushions().map(|cushion| cushion.id.clone()).chain(corners).collect()
}

/// For each straight face the one that lies on the same line, overlaps it, and faces the other way.
fn backs<S: Scalar>(faces: &[Face<S>], tolerance: S) -> Vec<Option<u32>> {
    let back = |face: &Face<S>| {
        let Face::Line(line) = face else { return None };
        let is_back =
            |other: &Face<S>| matches!(other, Face::Line(other) if is_back_of(line, other, tolerance));
        faces.iter().position(is_back).map(|k| k as u32)
    };
    faces.iter().map(back).collect()
}

fn is_back_of<S: Scalar>(line: &Line<S>, other: &Line<S>, tolerance: S) -> bool {
    let other_end = other.start + other.along * other.length;
    let (near, far) = (line.along.dot(other_end - line.start), line.along.dot(other.start - line.start));
    line.height(other.start).abs() <= tolerance
        && line.height(other_end).abs() <= tolerance
        && far > near
        && far > tolerance
        && near < line.length - tolerance
}

/// `1e-3 √(2r/|a|)` in a field, `1e-6 r/v_max` without; for a point, r is a thousandth of the table.
fn collapse_times<S: Scalar>(
    discs: &[Disc<S>],
    flights: &[Flight<S>],
    field: Vec2<S>,
    size: S,
) -> impl Iterator<Item = S> {
    let fastest =
        flights.iter().map(|f| f.velocity.norm_squared()).fold(S::ZERO, |a, b| if b > a { b } else { a });
    discs.iter().map(move |disc| {
        let length = if disc.radius > S::ZERO { disc.radius } else { size * S::from_f64(1e-3) };
        if field != Vec2::ZERO {
            (S::from_f64(2.0) * length / field.norm()).sqrt() * S::from_f64(1e-3)
        } else if fastest > S::ZERO {
            length / fastest.sqrt() * S::from_f64(1e-6)
        } else {
            S::ZERO
        }
    })
}
