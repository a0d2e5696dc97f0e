//! Which balls can be potted straight, and how well one has to aim.
//!
//! A pot is open where the cue ball comes to the ghost without touching anything, and the ball from there along the line
//! through the pocket's aiming point into the hole, its rim met by the centre. Its window holds all directions of the cue
//! ball around that one for which both are so. It ends where some path just touches something: at a tangent from one of the
//! two balls to a ball, a jaw or the hole, or where a path would end in a point that something else touches as well. All
//! such directions are known in closed form; between two neighbours either every direction pots the ball or none.

use super::ghost::{Ghost, angle_of, contact_distance, wrapped};
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
    /// The direction of the cue ball.
    pub direction_deg: f64,
    /// The angle from there to the direction of the object ball, positive to the left.
    pub cut_deg: f64,
    /// The centre of the cue ball at contact.
    pub ghost: [f64; 2],
    /// How far the cue ball goes to there.
    pub cue_distance: f64,
    /// How far the object ball is from the aiming point.
    pub object_distance: f64,
    /// The directions of the cue ball between which it pots the ball, to the right and to the left of `direction_deg`.
    pub window_deg: [f64; 2],
    /// The directions of the object ball at these.
    pub object_window_deg: [f64; 2],
}

impl Pot {
    /// The width of the window of the cue ball's direction.
    pub fn precision_deg(&self) -> f64 {
        self.window_deg[1] - self.window_deg[0]
    }
}

/// All open pots, that with the widest window first.
pub fn open_pots(scene: &Scene) -> Vec<Pot> {
    let balls = (0..scene.balls.len()).filter(|ball| *ball != scene.cue_ball);
    let found = balls.flat_map(|ball| scene.table.pockets.iter().filter_map(move |hole| open_pot(scene, ball, hole)));
    let mut pots: Vec<_> = found.collect();
    pots.sort_by(|a, b| b.precision_deg().total_cmp(&a.precision_deg()));
    pots
}

/// One pot, if it is open.
///
/// # Errors
///
/// When there is no such ball or pocket.
pub fn pot(scene: &Scene, ball: &str, pocket: &str) -> Result<Option<Pot>, Problem> {
    Ok(open_pot(scene, scene.object_ball(ball)?, scene.pocket(pocket)?))
}

fn open_pot(scene: &Scene, ball: usize, pocket: &Pocket<f64>) -> Option<Pot> {
    let target = pocket.aiming_point();
    let ghost = Ghost::of(scene, ball, target).ok().filter(Ghost::is_possible)?;
    let shot = Shot::new(scene, ball, pocket)?;
    let aimed = ghost.direction_deg;
    if !shot.pots(aimed) {
        return None;
    }
    let window_deg = shot.window(aimed);
    Some(Pot {
        ball: scene.balls[ball].id.clone(),
        pocket: pocket.id.clone(),
        direction_deg: aimed,
        cut_deg: ghost.cut_deg,
        ghost: ghost.center,
        cue_distance: (Vec2::from_f64(ghost.center) - shot.cue_ball).norm(),
        object_distance: (target - shot.ball.center).norm(),
        window_deg,
        object_window_deg: window_deg.map(|cue_deg| shot.object_direction(cue_deg)),
    })
}

/// The cue ball, the ball that it hits, and the pocket, each with what is in the way.
struct Shot {
    cue_ball: Vec2<f64>,
    /// Where the cue ball is when it touches the ball.
    ball: Circle,
    hole: Circle,
    in_way_of_cue: Vec<Obstacle>,
    in_way_of_ball: Vec<Obstacle>,
    tolerance: f64,
}

impl Shot {
    fn new(scene: &Scene, ball: usize, pocket: &Pocket<f64>) -> Option<Self> {
        let pair = [scene.cue_ball, ball];
        Some(Self {
            cue_ball: scene.place(scene.cue_ball),
            ball: Circle { center: scene.place(ball), radius: contact_distance(scene, ball).ok()? },
            hole: Circle { center: pocket.center, radius: pocket.radius },
            in_way_of_cue: scene.obstacles(scene.cue_ball, pair, None),
            in_way_of_ball: scene.obstacles(ball, pair, Some(&pocket.id)),
            tolerance: scene.tolerance(ball) + scene.tolerance(scene.cue_ball),
        })
    }

    /// Whether the ball falls without anything else being touched.
    fn pots(&self, cue_deg: f64) -> bool {
        let Some(ghost) = self.ghost(cue_deg) else { return false };
        let to_ghost = Segment { start: self.cue_ball, end: ghost };
        let along = (self.ball.center - ghost).unit();
        let Some(way) = self.hole.entry(self.ball.center, along) else { return false };
        let to_hole = Segment { start: self.ball.center, end: self.ball.center + along * way };
        let is_free = |obstacles: &[Obstacle], path: &Segment<f64>| {
            obstacles.iter().all(|obstacle| obstacle.lets_pass(path, self.tolerance))
        };
        is_free(&self.in_way_of_cue, &to_ghost) && is_free(&self.in_way_of_ball, &to_hole)
    }

    /// Where the cue ball touches the ball, if it does.
    fn ghost(&self, cue_deg: f64) -> Option<Vec2<f64>> {
        let (x, y) = direction(cue_deg);
        let unit = Vec2::new(x, y);
        self.ball.entry(self.cue_ball, unit).map(|way| self.cue_ball + unit * way)
    }

    /// The direction that the ball takes; at the ends of the window, where it may be just missed, that at a right angle.
    fn object_direction(&self, cue_deg: f64) -> f64 {
        let (x, y) = direction(cue_deg);
        let sin = (Vec2::new(x, y).cross(self.ball.center - self.cue_ball) / self.ball.radius).clamp(-1.0, 1.0);
        cue_deg + angle_deg((1.0 - sin.squared()).sqrt(), sin)
    }

    /// The directions around the one that is aimed at in which the ball is potted.
    fn window(&self, aimed: f64) -> [f64; 2] {
        let mut off: Vec<_> = self.critical_directions().into_iter().map(|deg| wrapped(deg - aimed)).collect();
        off.sort_by(f64::total_cmp);
        let first_left = off.partition_point(|deg| *deg <= 0.0);
        let (right, left) = off.split_at(first_left);
        [self.last(aimed, right.iter().rev()), self.last(aimed, left.iter())]
    }

    /// How far the ball is potted, going from one critical direction to the next.
    fn last<'a>(&self, aimed: f64, outwards: impl Iterator<Item = &'a f64>) -> f64 {
        let mut edge = 0.0;
        for next in outwards {
            if (next - edge).abs() > SAME_DIRECTION_DEG && !self.pots(aimed + (edge + next) / 2.0) {
                break;
            }
            edge = *next;
        }
        aimed + edge
    }

    /// Every direction of the cue ball at which something may change.
    fn critical_directions(&self) -> Vec<f64> {
        let mut by_cue = self.ball.tangents(self.cue_ball);
        for obstacle in &self.in_way_of_cue {
            by_cue.extend(obstacle.tangents(self.cue_ball));
            by_cue.extend(obstacle.meetings(&self.ball));
        }
        let mut by_ball = self.hole.tangents(self.ball.center);
        for obstacle in &self.in_way_of_ball {
            by_ball.extend(obstacle.tangents(self.ball.center));
            by_ball.extend(obstacle.meetings(&self.hole));
        }
        let ghosts = by_ball.into_iter().map(|target| {
            let along = (target - self.ball.center).unit();
            self.ball.center - along * self.ball.radius
        });
        let to = |point: Vec2<f64>| angle_of(point - self.cue_ball);
        by_cue.into_iter().chain(ghosts).map(to).filter(|deg| deg.is_finite()).collect()
    }
}
