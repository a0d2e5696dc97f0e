//! Whether the cue stick has room: what it meets when it strikes as the shot says, and how high its butt must be.
//!
//! The stick is a straight cone with round ends: all balls around the points of its axis whose radii grow evenly from the
//! shaft's to the butt's. The rounding of its tip touches the cue ball where the shot says, so that tip and ball have a
//! common normal there. Cushions and rails are as high as the nose (without a height, as the cue ball's centre) and go
//! outwards from there as far as the stick does. The stick is where it is at the strike; what it does before and after is
//! not looked at.

use super::scene::Scene;
use crate::geometry::{Piece, Vec2, Vec3, signed_distance};
use crate::law::cue_ball::Strike;
use crate::model::Outline;
use crate::scalar::{Scalar, angle_deg, direction};
use crate::scenario::{CueStart, Problem, Scenario, ShotStart};
use serde::Serialize;

/// How finely the stick is gone along, over its length.
const RESOLUTION: f64 = 1e-6;

/// Halvings of a range of angles, after which its ends are neighbours.
const HALVINGS: u32 = 60;

/// Something that the stick meets.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Obstruction {
    /// What it is: `ball`, `cushion` or `cloth`.
    pub kind: &'static str,
    /// The ball, or the cushion that is met nearest to the tip; none for the cloth.
    pub id: Option<String>,
    /// The least elevation, from that of the shot upwards, at which the stick clears it; none where not even an upright
    /// stick does.
    pub clear_from_deg: Option<f64>,
}

/// What the stick meets, struck as the shot of a checked scenario says.
///
/// # Errors
///
/// When the scenario has no shot.
pub fn obstructions(scenario: &Scenario) -> Result<Vec<Obstruction>, Problem> {
    let room = Room::new(scenario)?;
    let (cos, sin) = room.shot.elevation;
    let elevation_deg = angle_deg(cos, sin);
    let found = room.things.iter().filter_map(|thing| room.obstruction(thing, elevation_deg));
    Ok(found.collect())
}

/// The least elevation of the butt at which the stick clears everything, all else being as the shot says; none where not
/// even an upright stick does.
///
/// # Errors
///
/// When the scenario has no shot.
pub fn least_elevation_deg(scenario: &Scenario) -> Result<Option<f64>, Problem> {
    let room = Room::new(scenario)?;
    let mut least = 0.0;
    // What is cleared from below may be met again only by a ball above, so each thing has its say at most once.
    for _ in 0..=room.things.len() {
        let met = room.things.iter().filter(|thing| room.is_met(thing, least));
        let needed: Option<Vec<_>> = met.map(|thing| room.clear_from(thing, least)).collect();
        match needed {
            None => return Ok(None),
            Some(needed) if needed.is_empty() => return Ok(Some(least)),
            Some(needed) => least = needed.into_iter().fold(least, |a, b| if b > a { b } else { a }),
        }
    }
    Ok(None)
}

/// What there is around the stick.
struct Room {
    cue: CueStart<f64>,
    shot: ShotStart<f64>,
    center: Vec3<f64>,
    radius: f64,
    nose_height: f64,
    things: Vec<Thing>,
}

enum Thing {
    Ball { id: String, center: Vec3<f64>, radius: f64 },
    Rail { pieces: Vec<Piece<f64>>, ids: Vec<String> },
    Cloth,
}

/// A cone with round ends.
struct Stick {
    /// Where its first ball is, at the tip.
    start: Vec3<f64>,
    /// Unit vector from the tip to the butt.
    back: Vec3<f64>,
    /// The distance between the centres of its first and its last ball.
    length: f64,
    /// The radius of the first.
    radius: f64,
    /// How much the radius grows over the length.
    slope: f64,
}

impl Room {
    fn new(scenario: &Scenario) -> Result<Self, Problem> {
        let expanded = scenario.expanded();
        let shot = expanded.shot_start::<f64>(&mut |_, value| value);
        let shot = shot.ok_or_else(|| Problem::new("shot", "missing: without it the stick is nowhere"))?;
        let Scene { table, balls, .. } = Scene::new(scenario, None)?;
        let cue_ball = &balls[shot.ball];
        let rails = table.outlines.iter().map(Thing::rail);
        let others = balls
            .iter()
            .enumerate()
            .filter(|(place, _)| *place != shot.ball)
            .map(|(_, ball)| Thing::Ball { id: ball.id.clone(), center: ball.center, radius: ball.radius });
        Ok(Self {
            cue: expanded.cue.start(&mut |_, value| value),
            shot,
            center: cue_ball.center,
            radius: cue_ball.radius,
            nose_height: table.nose.height.unwrap_or(cue_ball.radius),
            things: others.chain(rails).chain([Thing::Cloth]).collect(),
        })
    }

    fn obstruction(&self, thing: &Thing, elevation_deg: f64) -> Option<Obstruction> {
        let at = self.met_at(thing, elevation_deg)?;
        let (kind, id) = match thing {
            Thing::Ball { id, .. } => ("ball", Some(id.clone())),
            Thing::Rail { pieces, ids } => {
                ("cushion", nearest(pieces, at.plan()).map(|place| ids[place].clone()))
            }
            Thing::Cloth => ("cloth", None),
        };
        Some(Obstruction { kind, id, clear_from_deg: self.clear_from(thing, elevation_deg) })
    }

    fn is_met(&self, thing: &Thing, elevation_deg: f64) -> bool {
        self.met_at(thing, elevation_deg).is_some()
    }

    /// The least elevation at which a thing is cleared that is met at the given one.
    fn clear_from(&self, thing: &Thing, met_deg: f64) -> Option<f64> {
        let (mut met, mut clear) = (met_deg, 90.0);
        if self.is_met(thing, clear) {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = (met + clear) / 2.0;
            let end = if self.is_met(thing, middle) { &mut met } else { &mut clear };
            *end = middle;
        }
        Some(clear)
    }

    /// The point of the stick's axis, near to the tip, where it meets a thing.
    fn met_at(&self, thing: &Thing, elevation_deg: f64) -> Option<Vec3<f64>> {
        let stick = self.stick(elevation_deg);
        match thing {
            Thing::Ball { center, radius, .. } => stick.meets_ball(*center, *radius),
            Thing::Rail { pieces, .. } => stick.meets_rail(pieces, self.nose_height),
            Thing::Cloth => stick.meets_cloth(),
        }
    }

    fn stick(&self, elevation_deg: f64) -> Stick {
        let ShotStart { speed, direction: plan, left, top, .. } = self.shot;
        let strike = Strike { speed, direction: plan, elevation: direction(elevation_deg), left, top };
        let CueStart { tip_radius, shaft_radius, butt_radius, length, .. } = self.cue;
        let ahead = strike.ahead();
        let middle_of_tip = self.center + strike.point() * (self.radius + tip_radius);
        let start = middle_of_tip + ahead * (tip_radius - shaft_radius);
        let length = length - shaft_radius - butt_radius;
        let slope = (butt_radius - shaft_radius) / length;
        Stick { start, back: -ahead, length, radius: shaft_radius, slope }
    }
}

impl Thing {
    fn rail(outline: &Outline<f64>) -> Self {
        let pieces = outline.cushions.iter().map(|cushion| cushion.piece).collect();
        Thing::Rail { pieces, ids: outline.cushions.iter().map(|cushion| cushion.id.clone()).collect() }
    }
}

impl Stick {
    fn at(&self, part: f64) -> Vec3<f64> {
        self.start + self.back * part
    }

    fn radius_at(&self, part: f64) -> f64 {
        self.radius + self.slope * part
    }

    fn meets_ball(&self, center: Vec3<f64>, radius: f64) -> Option<Vec3<f64>> {
        let foot = self.back.dot(center - self.start);
        let off = (center - self.at(foot)).norm();
        // The nearest ball of the cone lies behind the foot by the cone's slope.
        let part = (foot + self.slope * off / (1.0 - self.slope.squared()).sqrt()).clamp(0.0, self.length);
        let at = self.at(part);
        ((center - at).norm() < radius + self.radius_at(part)).then_some(at)
    }

    /// Goes along the stick by what is free around it, which passes nothing over.
    fn meets_rail(&self, pieces: &[Piece<f64>], height: f64) -> Option<Vec3<f64>> {
        let least_step = RESOLUTION * self.length;
        let mut part = 0.0;
        while part <= self.length {
            let at = self.at(part);
            let free = distance_to_rail(pieces, height, at) - self.radius_at(part);
            if free < 0.0 {
                return Some(at);
            }
            part += (if free > least_step { free } else { least_step }) / (1.0 + self.slope.abs());
        }
        None
    }

    fn meets_cloth(&self) -> Option<Vec3<f64>> {
        [0.0, self.length]
            .into_iter()
            .find(|part| self.at(*part).z < self.radius_at(*part))
            .map(|part| self.at(part))
    }
}

/// The distance of a point to a rail: what lies beyond a chain of pieces, up to a height; zero inside.
fn distance_to_rail(pieces: &[Piece<f64>], height: f64, point: Vec3<f64>) -> f64 {
    let above = if point.z > height { point.z - height } else { 0.0 };
    let aside = signed_distance(pieces, point.plan());
    if aside > 0.0 { (aside.squared() + above.squared()).sqrt() } else { above }
}

fn nearest(pieces: &[Piece<f64>], point: Vec2<f64>) -> Option<usize> {
    let distance = |place: &usize| pieces[*place].foot(point).distance;
    (0..pieces.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))
}
