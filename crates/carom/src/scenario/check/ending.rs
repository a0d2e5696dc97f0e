//! Whether a run without a duration can end.

use super::{Draft, Findings};
use crate::geometry::{Piece, Vec2};
use crate::law::ball_cushion::Law;
use crate::model::{Table, Twist};
use crate::scenario::schema::{Ball, Flight, Physics};
use crate::scenario::start::BallStart;
use crate::scenario::system::cushion_law;

/// Notes a missing duration where not everything comes to rest.
pub(super) fn check_ending(draft: &Draft<'_>, table: Option<&Table<f64>>, findings: &mut Findings) {
    let is_sound = ["duration", "collisions", "physics", "method", "table", "balls"]
        .iter()
        .all(|key| findings.is_sound(key));
    if draft.duration.is_some() || draft.collisions.is_some() || !is_sound {
        return;
    }
    let Some(reason) = table.and_then(|table| never_rests(draft, table)) else { return };
    findings.add(
        "duration",
        format!("missing, and not everything comes to rest: {reason}; give duration or collisions"),
    );
}

/// Why not everything comes to rest, if it does not.
fn never_rests(draft: &Draft<'_>, table: &Table<f64>) -> Option<String> {
    let field = match draft.physics.flight() {
        Flight::Free => Vec2::ZERO,
        Flight::Field { acceleration } => Vec2::from_f64(*acceleration),
        Flight::Cloth { gravity, restitution, air, .. } => {
            let bounces = *air && *restitution == 1.0;
            let reason = bounces.then(|| "the cloth gives all the speed of a fall back".into());
            return reason.or_else(|| keeps_moving(draft, *gravity));
        }
    };
    if field != Vec2::ZERO {
        return elastic_floor(draft.physics, table, field).map(|id| {
            format!("cushion {id:?}, onto which the field pulls, gives all the normal speed back")
        });
    }
    if table.cushions().all(|cushion| law_of(draft.physics, &cushion.id).is_dead()) {
        return None;
    }
    let is_moving = |(index, ball): &(usize, &Ball)| {
        ball.start(*index, draft.ball_defaults, &mut |_, value| value).velocity.plan() != Vec2::ZERO
    };
    let (_, ball) = draft.balls().find(is_moving)?;
    Some(format!("no field pulls ball {:?} onto a cushion that would hold it", ball.id))
}

/// Why balls on a cloth may move for ever: nothing slows one of them, and there is motion.
fn keeps_moving(draft: &Draft<'_>, gravity: f64) -> Option<String> {
    let starts: Vec<_> = draft
        .balls()
        .map(|(index, ball)| (ball, ball.start(index, draft.ball_defaults, &mut |_, value| value)))
        .collect();
    let is_moving = |start: &BallStart<f64>| start.twist() != Twist::REST || start.position.z > start.radius;
    if draft.shot.is_none() && !starts.iter().any(|(_, start)| is_moving(start)) {
        return None;
    }
    if gravity == 0.0 {
        return Some("without gravity nothing presses the balls onto the cloth".into());
    }
    starts.iter().find_map(|(ball, start)| {
        let rates = [
            ("sliding_friction", start.sliding_friction),
            ("rolling_friction", start.rolling_friction),
            ("spin_decay", start.spin_decay),
        ];
        let (key, _) = rates.into_iter().find(|(_, rate)| *rate == 0.0)?;
        Some(format!("ball {:?} has no {key}", ball.id))
    })
}

fn law_of(physics: &Physics, id: &str) -> Law<f64> {
    cushion_law("", physics.law_of_cushion(id), &mut |_, value| value)
}

/// A cushion onto which a field pulls and that gives slow balls all their normal speed back.
fn elastic_floor<'a>(physics: &Physics, table: &'a Table<f64>, field: Vec2<f64>) -> Option<&'a str> {
    let pulled_onto = |piece: &Piece<f64>| {
        let facing = |point| piece.direction_at(point).left();
        [piece.start(), piece.middle(), piece.end()].into_iter().any(|point| facing(point).dot(field) < 0.0)
    };
    let is_elastic = |id: &str| law_of(physics, id).restitution(0.0) == 1.0;
    table
        .cushions()
        .find(|cushion| pulled_onto(&cushion.piece) && is_elastic(&cushion.id))
        .map(|c| c.id.as_str())
}
