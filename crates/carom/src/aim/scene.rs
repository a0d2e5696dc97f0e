//! A scenario as one sees it before a shot: who lies where, and what is in the way of whom.

use super::obstacle::Obstacle;
use crate::geometry::{Vec2, Vec3};
use crate::model::{ContactTolerance, Pocket, Table};
use crate::scalar::Scalar;
use crate::scenario::{Problem, Scenario};

/// A ball at time 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Lying {
    /// Its name.
    pub id: String,
    /// Its radius.
    pub radius: f64,
    /// Its centre; of a disc at height 0.
    pub center: Vec3<f64>,
}

/// The table and the balls of a scenario, and the ball one shoots with.
#[derive(Clone, Debug)]
pub struct Scene {
    pub(super) table: Table<f64>,
    pub(super) balls: Vec<Lying>,
    pub(super) cue_ball: usize,
    tolerance: ContactTolerance<f64>,
}

impl Scene {
    /// The scene of a checked scenario. Without a name the cue ball is that of the shot, or else the ball "cue".
    ///
    /// # Errors
    ///
    /// When there is no ball of that name.
    pub fn new(scenario: &Scenario, cue_ball: Option<&str>) -> Result<Self, Problem> {
        let scenario = &*scenario.expanded();
        let has_cloth = scenario.physics.has_cloth();
        let lying = |(k, ball): (usize, &crate::scenario::schema::Ball)| {
            let start = ball.start::<f64>(k, &scenario.ball_defaults, &mut |_, value| value);
            let height = if has_cloth { start.position.z } else { 0.0 };
            let center = Vec3::above(start.position.plan(), height);
            Lying { id: ball.id.clone(), radius: start.radius, center }
        };
        let balls: Vec<_> = scenario.balls.iter().enumerate().map(lying).collect();
        let of_shot = scenario.shot.as_ref().map(|shot| shot.cue_ball.as_str());
        let name = cue_ball.or(of_shot).unwrap_or("cue");
        let cue_ball = place_of(&balls, "cue_ball", name)?;
        let table = scenario.table.layout::<f64>(&mut |_, value| value);
        let tolerance = ContactTolerance::new(&table);
        Ok(Self { table, balls, cue_ball, tolerance })
    }

    /// The place of the ball that is to be hit.
    pub(super) fn object_ball(&self, id: &str) -> Result<usize, Problem> {
        let ball = place_of(&self.balls, "ball", id)?;
        if ball == self.cue_ball {
            return Err(Problem::new("ball", format!("\"{id}\" is the cue ball, which cannot hit itself")));
        }
        Ok(ball)
    }

    pub(super) fn pocket(&self, id: &str) -> Result<&Pocket<f64>, Problem> {
        pocket_of(&self.table, id)
    }

    /// Where the centre of a ball is, as seen from above.
    pub(super) fn place(&self, ball: usize) -> Vec2<f64> {
        self.balls[ball].center.plan()
    }

    /// How far apart the centres of two balls are as seen from above when they touch; none where one is above the other's
    /// reach.
    pub(super) fn contact_distance(&self, a: usize, b: usize) -> Option<f64> {
        let (a, b) = (&self.balls[a], &self.balls[b]);
        let squared = (a.radius + b.radius).squared() - (a.center.z - b.center.z).squared();
        (squared > 0.0).then(|| squared.sqrt())
    }

    /// By how much nearer than a contact two things may lie: what a checked scenario may have, and its round-off.
    pub(super) fn tolerance(&self, ball: usize) -> f64 {
        2.0 * self.tolerance.of(2.0 * self.balls[ball].radius)
    }

    /// The jaws of a pocket, as a ball meets them.
    pub(super) fn jaws(&self, ball: usize, pocket: &str) -> Vec<Obstacle> {
        let prefix = format!("{pocket}.jaw_");
        let jaws = self.table.cushions().filter(|cushion| cushion.id.starts_with(&prefix));
        jaws.map(|cushion| Obstacle::cushion(cushion.piece, self.reach(ball))).collect()
    }

    /// How near the centre of a ball comes to a nose, as seen from above, when it touches it.
    fn reach(&self, ball: usize) -> f64 {
        let Lying { radius, center, .. } = self.balls[ball];
        self.table.nose.reach(radius, if center.z > 0.0 { center.z } else { radius })
    }

    /// All that keeps a ball from going where it likes, without these balls and this pocket.
    pub(super) fn obstacles(&self, ball: usize, without: [usize; 2], pocket: Option<&str>) -> Vec<Obstacle> {
        let reach = self.reach(ball);
        let cushions = self.table.cushions().map(|cushion| Obstacle::cushion(cushion.piece, reach));
        let others = (0..self.balls.len()).filter(|other| !without.contains(other));
        let balls = others.filter_map(|other| {
            let reach = self.contact_distance(ball, other)?;
            Some(Obstacle::round(self.place(other), reach))
        });
        let pockets = self.table.pockets.iter().filter(|other| Some(other.id.as_str()) != pocket);
        let holes = pockets.map(|other| Obstacle::round(other.center, other.radius));
        cushions.chain(balls).chain(holes).collect()
    }
}

/// Where one aims to pot a ball into a pocket of a checked scenario: half-way between its horn tips, or at the middle of a
/// bare hole.
///
/// # Errors
///
/// When there is no such pocket.
pub fn aiming_point(scenario: &Scenario, pocket: &str) -> Result<[f64; 2], Problem> {
    let table = scenario.expanded().table.layout::<f64>(&mut |_, value| value);
    Ok(pocket_of(&table, pocket)?.aiming_point().to_f64())
}

fn pocket_of<'a>(table: &'a Table<f64>, id: &str) -> Result<&'a Pocket<f64>, Problem> {
    let known = || names(table.pockets.iter().map(|pocket| pocket.id.as_str()));
    let found = table.pockets.iter().find(|pocket| pocket.id == id);
    found.ok_or_else(|| Problem::new("pocket", format!("there is no pocket \"{id}\"; known: {}", known())))
}

fn place_of(balls: &[Lying], place: &str, id: &str) -> Result<usize, Problem> {
    let known = || names(balls.iter().map(|ball| ball.id.as_str()));
    let found = balls.iter().position(|ball| ball.id == id);
    found.ok_or_else(|| Problem::new(place, format!("there is no ball \"{id}\"; known: {}", known())))
}

fn names<'a>(ids: impl Iterator<Item = &'a str>) -> String {
    let ids: Vec<_> = ids.collect();
    if ids.is_empty() { "none".into() } else { ids.join(", ") }
}
