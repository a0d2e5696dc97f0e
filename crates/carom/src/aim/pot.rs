//! Which balls can be potted straight, and how well one has to aim.
//!
//! A pot is open where the cue ball comes to the ball, and the ball from there into the pocket, and neither touches anything
//! on its way: no other ball, no cushion, no other hole. A ball is in the pocket when its centre is between the horn tips and
//! its straight line goes on past both jaws without touching them, or when it is over the hole; of a ball that lies behind
//! the tips already, over the hole. (It may still touch a facing, which leads it inwards. Whether that throws it out depends
//! on its speed, its spin and the rubber, and is left to a run.) Another ball that hangs behind the tips closes the pocket.
//!
//! The directions of the cue ball for which that is so are a window, and the pot is aimed at its middle; of several the
//! widest counts. A window ends where a path just touches something: at a tangent from one of the two balls to a ball, a
//! jaw or the hole, or where a path ends in a point that something else touches as well. All such directions are known in
//! closed form; between two neighbours either every direction pots the ball or none.

use super::ghost::{angle_of, contact_distance, wrapped};
use super::goal::Goal;
use super::obstacle::{Circle, Obstacle};
use super::scene::Scene;
use crate::geometry::{Segment, Vec2};
use crate::model::Pocket;
use crate::scalar::{Scalar, angle_deg, direction};
use crate::scenario::Problem;

/// Directions that lie nearer than this, in degrees, are one.
const SAME_DIRECTION_DEG: f64 = 1e-11;

/// A straight pot that is open.
#[derive(Clone, Debug, PartialEq)]
pub struct Pot {
    /// The ball that is potted.
    pub ball: String,
    /// The pocket.
    pub pocket: String,
    /// The direction of the cue ball: the middle of its window.
    pub direction_deg: f64,
    /// The angle from there to the direction of the object ball, positive to the left.
    pub cut_deg: f64,
    /// The centre of the cue ball at contact.
    pub ghost: [f64; 2],
    /// How far the cue ball goes to there.
    pub cue_distance: f64,
    /// How far the object ball goes until it is in the pocket.
    pub object_distance: f64,
    /// The directions of the cue ball between which it pots the ball, the one to the right first.
    pub window_deg: [f64; 2],
    /// The directions of the object ball at these.
    pub object_window_deg: [f64; 2],
}

impl Pot {
    /// The width of the window of the cue ball's direction: how well one has to aim.
    pub fn precision_deg(&self) -> f64 {
        self.window_deg[1] - self.window_deg[0]
    }
}

/// All open pots, that with the widest window first.
pub fn open_pots(scene: &Scene) -> Vec<Pot> {
    let balls = (0..scene.balls.len()).filter(|ball| *ball != scene.cue_ball);
    let found =
        balls.flat_map(|ball| scene.table.pockets.iter().filter_map(move |hole| open_pot(scene, ball, hole)));
    let mut pots: Vec<_> = found.collect();
    pots.sort_by(|a, b| b.precision_deg().total_cmp(&a.precision_deg()));
    pots
}

/// One pot.
///
/// # Errors
///
/// When there is no such ball or pocket, or the pot is not open.
pub fn pot(scene: &Scene, ball: &str, pocket: &str) -> Result<Pot, Problem> {
    let closed = || {
        let message = format!(
            "ball \"{ball}\" has no free way into \"{pocket}\": something is in the way of one of the two balls, or the cut \
             is too thin"
        );
        Problem::new("pocket", message)
    };
    open_pot(scene, scene.object_ball(ball)?, scene.pocket(pocket)?).ok_or_else(closed)
}

fn open_pot(scene: &Scene, ball: usize, pocket: &Pocket<f64>) -> Option<Pot> {
    let shot = Shot::new(scene, ball, pocket)?;
    let window_deg = shot.window()?;
    let direction_deg = (window_deg[0] + window_deg[1]) / 2.0;
    let path = shot.path(direction_deg)?;
    Some(Pot {
        ball: scene.balls[ball].id.clone(),
        pocket: pocket.id.clone(),
        direction_deg,
        cut_deg: shot.object_direction(direction_deg) - direction_deg,
        ghost: path.of_cue.end.to_f64(),
        cue_distance: path.of_cue.along().norm(),
        object_distance: path.of_ball.along().norm(),
        window_deg,
        object_window_deg: window_deg.map(|cue_deg| shot.object_direction(cue_deg)),
    })
}

/// The ways of the two balls of a pot.
struct Path {
    of_cue: Segment<f64>,
    of_ball: Segment<f64>,
    /// The same until it has passed the jaws.
    past_jaws: Segment<f64>,
}

/// The cue ball, the ball that it hits, and the pocket, each with what is in the way.
struct Shot {
    cue_ball: Vec2<f64>,
    /// Where the cue ball is when it touches the ball.
    ball: Circle,
    goal: Goal,
    in_way_of_cue: Vec<Obstacle>,
    in_way_of_ball: Vec<Obstacle>,
    jaws: Vec<Obstacle>,
    tolerance: f64,
}

impl Shot {
    fn new(scene: &Scene, ball: usize, pocket: &Pocket<f64>) -> Option<Self> {
        let pair = [scene.cue_ball, ball];
        let goal = Goal::new(pocket);
        let mut others = (0..scene.balls.len()).filter(|other| !pair.contains(other));
        if others.any(|other| {
            scene
                .contact_distance(ball, other)
                .is_some_and(|reach| goal.is_closed_by(scene.place(other), reach))
        }) {
            return None;
        }
        Some(Self {
            cue_ball: scene.place(scene.cue_ball),
            ball: Circle { center: scene.place(ball), radius: contact_distance(scene, ball).ok()? },
            goal,
            in_way_of_cue: scene.obstacles(scene.cue_ball, pair, None),
            in_way_of_ball: scene.obstacles(ball, pair, Some(&pocket.id)),
            jaws: scene.jaws(ball, &pocket.id),
            tolerance: scene.tolerance(ball) + scene.tolerance(scene.cue_ball),
        })
    }

    /// Whether the ball gets into the pocket without anything else being touched.
    fn pots(&self, cue_deg: f64) -> bool {
        let is_free = |obstacles: &[Obstacle], path: &Segment<f64>| {
            obstacles.iter().all(|obstacle| obstacle.lets_pass(path, self.tolerance))
        };
        self.path(cue_deg).is_some_and(|path| {
            is_free(&self.in_way_of_cue, &path.of_cue)
                && is_free(&self.in_way_of_ball, &path.of_ball)
                && is_free(&self.jaws, &path.past_jaws)
        })
    }

    /// The ways that the two go, if the cue ball hits the ball and this meets the pocket.
    fn path(&self, cue_deg: f64) -> Option<Path> {
        let (x, y) = direction(cue_deg);
        let unit = Vec2::new(x, y);
        let ghost = self.cue_ball + unit * self.ball.entry(self.cue_ball, unit)?;
        let start = self.ball.center;
        let along = (start - ghost).unit();
        let way = |length: f64| Segment { start, end: start + along * length };
        Some(Path {
            of_cue: Segment { start: self.cue_ball, end: ghost },
            of_ball: way(self.goal.entry(start, along)?),
            past_jaws: way(self.goal.passage(start, along)?),
        })
    }

    /// The direction that the ball takes; at the ends of the window, where it may be just missed, that at a right angle.
    fn object_direction(&self, cue_deg: f64) -> f64 {
        let (x, y) = direction(cue_deg);
        let sin =
            (Vec2::new(x, y).cross(self.ball.center - self.cue_ball) / self.ball.radius).clamp(-1.0, 1.0);
        cue_deg + angle_deg((1.0 - sin.squared()).sqrt(), sin)
    }

    /// The widest range of directions in which the ball is potted, if there is one.
    fn window(&self) -> Option<[f64; 2]> {
        let middle = angle_of(self.ball.center - self.cue_ball);
        let mut off: Vec<_> =
            self.critical_directions().into_iter().map(|deg| wrapped(deg - middle)).collect();
        off.sort_by(f64::total_cmp);
        off.dedup_by(|next, last| *next - *last <= SAME_DIRECTION_DEG);
        let mut widest: Option<[f64; 2]> = None;
        let mut start = None;
        for pair in off.windows(2) {
            if !self.pots(middle + (pair[0] + pair[1]) / 2.0) {
                start = None;
                continue;
            }
            let window = [*start.get_or_insert(pair[0]), pair[1]];
            if widest.is_none_or(|known| window[1] - window[0] > known[1] - known[0]) {
                widest = Some(window);
            }
        }
        widest.map(|window| window.map(|deg| middle + deg))
    }

    /// Every direction of the cue ball at which something may change.
    fn critical_directions(&self) -> Vec<f64> {
        let mut by_cue = self.ball.tangents(self.cue_ball);
        for obstacle in &self.in_way_of_cue {
            by_cue.extend(obstacle.tangents(self.cue_ball));
            by_cue.extend(obstacle.meetings(&self.ball));
        }
        let mut by_ball = self.goal.edges(self.ball.center);
        for obstacle in &self.in_way_of_ball {
            by_ball.extend(obstacle.tangents(self.ball.center));
            by_ball.extend(self.goal.meetings(obstacle));
        }
        let ghosts = by_ball.into_iter().map(|target| {
            let along = (target - self.ball.center).unit();
            self.ball.center - along * self.ball.radius
        });
        let to = |point: Vec2<f64>| angle_of(point - self.cue_ball);
        by_cue.into_iter().chain(ghosts).map(to).filter(|deg| deg.is_finite()).collect()
    }
}
