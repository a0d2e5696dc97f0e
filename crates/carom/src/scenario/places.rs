//! Places for numbers with which a run can start again as it stands: no scenario is made, read and checked anew.

use super::cloth_system::{Stroke, stroke};
use super::path::{Step, parse};
use super::schema::{BallBall, BallCushion, Method, Physics, Scenario, Shot};
use super::start::BallStart;
use super::structure::bounds;
use super::system::CushionLaws;
use crate::scalar::Scalar;

/// A scenario with places for numbers, of velocities of discs, of a shot or of laws of collision.
///
/// They are those numbers that a system can be given without being made anew, and that a check looks at one by one.
#[derive(Clone, Debug)]
pub struct Places {
    /// The scenario with the numbers in it, its preset and its rack turned into plain keys.
    scenario: Scenario,
    places: Vec<Place>,
    /// The balls that start otherwise.
    balls: Vec<usize>,
    /// Radii of the tip and of the ball that is struck, where there are numbers of a shot.
    struck: Option<[f64; 2]>,
    /// For each face which of the laws of cushions it has, where there are numbers of laws.
    laws: Option<Vec<usize>>,
}

/// A place for a number, and what numbers may stand there.
#[derive(Clone, Debug)]
struct Place {
    of: Of,
    bounds: [f64; 2],
}

/// What a number is one of.
#[derive(Clone, Debug)]
enum Of {
    /// The velocity of a disc.
    Velocity(usize, Part),
    /// The shot.
    Shot(fn(&mut Shot) -> &mut Option<f64>),
    /// The law between balls, by its key.
    BallBall(String),
    /// The law of all cushions, by its key.
    BallCushion(String),
    /// The law of one cushion.
    Cushion(String, String),
}

/// A number of a ball's velocity at the start.
#[derive(Clone, Copy, Debug)]
enum Part {
    Component(usize),
    Speed,
    Direction,
}

/// The laws of collision with the numbers in them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Laws<'a> {
    physics: &'a Physics,
    of_faces: &'a [usize],
}

/// Numbers as large and as small as these, and zero, are what every check of magnitudes lets pass.
const ORDINARY: core::ops::Range<f64> = 1e-70..1e70;

impl Places {
    /// The places at these paths of a checked scenario that has numbers at all of them; `None` where any is a number of
    /// something else, or where it may depend on velocities or laws how a run ends.
    pub fn new(scenario: &Scenario, paths: &[String]) -> Option<Self> {
        let mut scenario = scenario.expanded().into_owned();
        let has_end = scenario.duration.is_some() || scenario.collisions.is_some();
        if scenario.method != Method::Exact || !(has_end || scenario.has_cloth()) {
            return None;
        }
        let whole = scenario.to_value().ok()?;
        let (mut places, mut balls) = (Vec::new(), Vec::new());
        for path in paths {
            let steps = parse(&scenario.place(path).ok()?).ok()?;
            let of = Of::new(&steps, scenario.has_cloth())?;
            of.number(&mut scenario)?;
            if let Of::Velocity(ball, _) = of
                && !balls.contains(&ball)
            {
                balls.push(ball);
            }
            places.push(Place { of, bounds: bounds(&whole, &steps)? });
        }
        let any = |is: fn(&Of) -> bool| places.iter().any(|place| is(&place.of));
        let struck = if any(|of| matches!(of, Of::Shot(_))) { Some(radii(&scenario)?) } else { None };
        let has_laws = any(|of| matches!(of, Of::BallBall(_) | Of::BallCushion(_) | Of::Cushion(..)));
        let laws = has_laws.then(|| laws_of_faces(&scenario));
        Some(Self { scenario, places, balls, struck, laws })
    }

    /// Puts numbers in the places; `false`, and they are not all there, where a check has to look at one and say what is wrong
    /// with it, or whether anything is.
    pub fn set(&mut self, numbers: &[f64]) -> bool {
        for (&number, place) in numbers.iter().zip(&self.places) {
            let is_ordinary = number == 0.0 || ORDINARY.contains(&number.abs());
            let [least, most] = place.bounds;
            let is_sound = is_ordinary && least <= number && number <= most;
            match place.of.number(&mut self.scenario) {
                Some(old) if is_sound => *old = number,
                _ => return false,
            }
        }
        self.meets_the_ball()
    }

    /// Whether a shot meets the ball that it is meant for.
    fn meets_the_ball(&self) -> bool {
        let (Some([tip_radius, radius]), Some(shot)) = (self.struck, &self.scenario.shot) else {
            return true;
        };
        let (left, top) = shot.offsets(tip_radius, radius, &mut |_, value: f64| value);
        left * left + top * top < 1.0
    }

    /// Whether there are any of velocities.
    pub(super) fn has_velocities(&self) -> bool {
        !self.balls.is_empty()
    }

    /// How the balls start that start otherwise, with their places in the scenario.
    pub(super) fn starts<S: Scalar>(&self) -> impl Iterator<Item = (usize, BallStart<S>)> {
        let Scenario { balls, ball_defaults, .. } = &self.scenario;
        let start = |&ball: &usize| {
            let start = balls[ball].start(ball, ball_defaults, &mut |_, value| S::from_f64(value));
            (ball, start)
        };
        self.balls.iter().map(start)
    }

    /// The stroke of the cue, where there are numbers of it.
    pub(super) fn stroke<S: Scalar>(&self) -> Option<Stroke<S>> {
        self.struck.and_then(|_| stroke(&self.scenario, &mut |_, value| S::from_f64(value)))
    }

    /// The laws of collision, where there are numbers of them.
    pub(super) fn laws(&self) -> Option<Laws<'_>> {
        let of_faces = self.laws.as_deref()?;
        Some(Laws { physics: &self.scenario.physics, of_faces })
    }
}

impl<'a> Laws<'a> {
    /// The law between balls.
    pub(super) fn ball_ball(self) -> &'a BallBall {
        self.physics.ball_ball()
    }

    /// The law of each face.
    pub(super) fn of_faces(self) -> impl Iterator<Item = &'a BallCushion> {
        let Self { physics, of_faces } = self;
        of_faces.iter().map(|law| physics.cushions.values().nth(*law).unwrap_or(physics.ball_cushion()))
    }
}

impl Of {
    fn new(steps: &[Step], is_on_cloth: bool) -> Option<Self> {
        match steps {
            [Step::Key(balls), Step::Index(ball), rest @ ..] if balls == "balls" && !is_on_cloth => {
                Some(Self::Velocity(*ball, Part::new(rest)?))
            }
            [Step::Key(shot), Step::Key(key)] if shot == "shot" => shot_number(key).map(Self::Shot),
            [Step::Key(physics), Step::Key(law), rest @ ..] if physics == "physics" => {
                match (law.as_str(), rest) {
                    ("ball_ball", [Step::Key(key)]) => Some(Self::BallBall(key.clone())),
                    ("ball_cushion", [Step::Key(key)]) => Some(Self::BallCushion(key.clone())),
                    ("cushions", [Step::Key(id), Step::Key(key)]) => {
                        Some(Self::Cushion(id.clone(), key.clone()))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The number in a scenario; `None` where it is not given.
    #[inline(always)]
    fn number<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut f64> {
        let physics = &mut scenario.physics;
        match self {
            Self::Velocity(ball, part) => {
                let ball = scenario.balls.get_mut(*ball)?;
                match part {
                    Part::Component(axis) => ball.velocity.as_mut().map(|velocity| &mut velocity.plan[*axis]),
                    Part::Speed => ball.speed.as_mut(),
                    Part::Direction => ball.direction_deg.as_mut(),
                }
            }
            Self::Shot(number) => number(scenario.shot.as_mut()?).as_mut(),
            Self::BallBall(key) => physics.ball_ball.as_mut()?.coefficient(key),
            Self::BallCushion(key) => physics.ball_cushion.as_mut()?.coefficient(key),
            Self::Cushion(id, key) => physics.cushions.get_mut(id)?.coefficient(key),
        }
    }
}

impl Part {
    fn new(steps: &[Step]) -> Option<Self> {
        match steps {
            [Step::Key(key), Step::Index(axis @ (0 | 1))] if key == "velocity" => {
                Some(Self::Component(*axis))
            }
            [Step::Key(key)] if key == "speed" => Some(Self::Speed),
            [Step::Key(key)] if key == "direction_deg" => Some(Self::Direction),
            _ => None,
        }
    }
}

fn shot_number(key: &str) -> Option<fn(&mut Shot) -> &mut Option<f64>> {
    Some(match key {
        "V0" => |shot| &mut shot.v0,
        "cue_speed" => |shot| &mut shot.cue_speed,
        "phi_deg" => |shot| &mut shot.phi_deg,
        "direction_deg" => |shot| &mut shot.direction_deg,
        "theta_deg" => |shot| &mut shot.theta_deg,
        "elevation_deg" => |shot| &mut shot.elevation_deg,
        "a" => |shot| &mut shot.a,
        "left" => |shot| &mut shot.left,
        "b" => |shot| &mut shot.b,
        "top" => |shot| &mut shot.top,
        _ => return None,
    })
}

/// The radii of the tip and of the ball that is struck.
fn radii(scenario: &Scenario) -> Option<[f64; 2]> {
    let shot = scenario.shot.as_ref()?;
    let (index, ball) = scenario.balls.iter().enumerate().find(|(_, ball)| ball.id == shot.cue_ball)?;
    let tip_radius = scenario.cue.start(&mut |_, value: f64| value).tip_radius;
    Some([tip_radius, ball.start(index, &scenario.ball_defaults, &mut |_, value: f64| value).radius])
}

/// For each face the number of its law: those of single cushions come first, in order, the one for all is last.
fn laws_of_faces(scenario: &Scenario) -> Vec<usize> {
    let mut numbers = 0..;
    let number = &mut |_: &str, _: &BallCushion| numbers.next().unwrap_or_default();
    CushionLaws::new(&scenario.physics, number).of_table(&scenario.table.layout(&mut |_, value: f64| value))
}
