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
            let endless = bounces.then(|| "the cloth gives all the speed of a fall back".into());
            return endless.or_else(|| never_slows(draft, *gravity));
        }
    };
    if field != Vec2::ZERO {
        return elastic_floor(draft.physics, table, field).map(|id| {
            format!("cushion {id:?}, onto which the field pulls, gives all the normal speed back")
        });
    }
    let has_open_sides = draft.table.is_some_and(|table| table.periodic() != [false; 2]);
    if !has_open_sides && table.cushions().all(|cushion| law_of(draft.physics, &cushion.id).is_dead()) {
        return None;
    }
    let is_moving = |(index, ball): &(usize, &Ball)| {
        ball.start(*index, draft.ball_defaults, &mut |_, value| value).velocity.plan() != Vec2::ZERO
    };
    let (_, ball) = draft.balls().find(is_moving)?;
    Some(format!("no field pulls ball {:?} onto a cushion that would hold it", ball.id))
}

/// What goes on for ever on a cloth on which something moves, if anything may. Which balls will slide, roll or spin there
/// only the run can tell: so each of them must slow down at all of these.
fn never_slows(draft: &Draft<'_>, gravity: f64) -> Option<String> {
    let start =
        |(index, ball): (usize, &Ball)| ball.start(index, draft.ball_defaults, &mut |_, value: f64| value);
    let moves = |start: BallStart<f64>| start.twist() != Twist::REST || start.position.z > start.radius;
    if draft.shot.is_none() && !draft.balls().map(start).any(moves) {
        return None;
    }
    if gravity == 0.0 {
        return Some("without gravity no ball rubs on the cloth".into());
    }
    draft.balls().find_map(|(index, ball)| {
        let start = start((index, ball));
        let frictions = [
            ("sliding_friction", start.sliding_friction, "slides"),
            ("rolling_friction", start.rolling_friction, "rolls"),
            ("spin_decay", start.spin_decay, "spins"),
        ];
        let (key, _, motion) = frictions.into_iter().find(|(_, friction, _)| *friction == 0.0)?;
        Some(format!("nothing slows ball {:?} while it {motion}, since its {key} is 0", ball.id))
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
