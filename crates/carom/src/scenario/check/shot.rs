//! The shot: one number for each thing, at a ball that lies still, and at a point that the ball has.

use super::{Draft, Findings, Rounded};
use crate::geometry::Vec3;
use crate::scenario::nearest::suggestion;
use crate::scenario::schema::Shot;

/// Notes what is wrong with a shot.
pub(super) fn check_shot(draft: &Draft<'_>, findings: &mut Findings) {
    let Some(shot) = draft.shot else { return };
    check_spellings(shot, findings);
    check_given(shot, findings);
    check_ball(draft, shot, findings);
}

/// The two names of each number of a shot, with what it is.
fn spellings(shot: &Shot) -> [(&'static str, Option<f64>, &'static str, Option<f64>); 5] {
    [
        ("V0", shot.v0, "cue_speed", shot.cue_speed),
        ("phi_deg", shot.phi_deg, "direction_deg", shot.direction_deg),
        ("theta_deg", shot.theta_deg, "elevation_deg", shot.elevation_deg),
        ("a", shot.a, "left", shot.left),
        ("b", shot.b, "top", shot.top),
    ]
}

fn check_spellings(shot: &Shot, findings: &mut Findings) {
    for (name, value, other, other_value) in spellings(shot) {
        if value.is_some() && other_value.is_some() {
            let message = format!("is given beside {other}, which is the same: give one of them");
            findings.add(format_args!("shot.{name}"), message);
        }
    }
}

fn check_given(shot: &Shot, findings: &mut Findings) {
    let what = [
        "the speed of the cue",
        "the direction of the stroke, in degrees from the x axis towards the y axis",
    ];
    for ((name, value, other, other_value), what) in spellings(shot).into_iter().zip(what) {
        let is_sound = [name, other].iter().all(|key| findings.is_sound(format_args!("shot.{key}")));
        if value.or(other_value).is_none() && is_sound {
            findings.add(format_args!("shot.{name}"), format!("missing: give {what}, as {name} or {other}"));
        }
    }
}

fn check_ball(draft: &Draft<'_>, shot: &Shot, findings: &mut Findings) {
    let parts = ["balls", "rack", "table", "ball_defaults.radius"];
    let all_known =
        draft.balls.iter().all(Option::is_some) && parts.iter().all(|part| findings.is_sound(part));
    let Some((index, ball)) = draft.balls().find(|(_, ball)| ball.id == shot.cue_ball) else {
        if all_known {
            let ids: Vec<&str> = draft.balls().map(|(_, ball)| ball.id.as_str()).collect();
            let of_rack = draft.rack.map(|rack| rack.game.cue_ball()).filter(|id| ids.contains(id));
            let hint = of_rack.map_or_else(
                || suggestion(&shot.cue_ball, &ids),
                |id| format!("; the cue ball of the rack is {id:?}"),
            );
            let message = format!("there is no ball {:?}{hint}", shot.cue_ball);
            findings.add("shot.cue_ball", message);
        }
        return;
    };
    let start = ball.start(index, draft.ball_defaults, &mut |_, value: f64| value);
    let problem = if start.velocity != Vec3::ZERO || start.spin != Vec3::ZERO {
        Some("moves already: only a ball at rest can be struck")
    } else if start.position.z > start.radius {
        Some("is in the air: only a ball that lies on the cloth can be struck")
    } else {
        None
    };
    if let Some(problem) = problem {
        findings.add("shot.cue_ball", format!("ball {:?} {problem}", shot.cue_ball));
    }
    check_offsets(draft, shot, start.radius, findings);
}

fn check_offsets(draft: &Draft<'_>, shot: &Shot, radius: f64, findings: &mut Findings) {
    let tip_radius = draft.cue.start(&mut |_, value: f64| value).tip_radius;
    let is_sound = ["shot", "cue", "balls", "ball_defaults"].iter().all(|key| findings.is_sound(key));
    if !is_sound {
        return;
    }
    let (left, top) = shot.offsets(tip_radius, radius, &mut |_, value: f64| value);
    if left * left + top * top >= 1.0 {
        let message = format!(
            "misses the ball: the contact would lie {} radii from the middle, and must lie less than 1 from it",
            Rounded((left * left + top * top).sqrt())
        );
        findings.add("shot", message);
    }
}
