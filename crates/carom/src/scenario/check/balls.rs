//! The balls, each for itself: id, radius, motion and colour.

use super::ids::check_id;
use super::{Draft, Findings};
use crate::scenario::schema::{Ball, Color};
use core::fmt::Display;
use std::collections::BTreeMap;

/// Notes what is wrong with single balls.
pub(super) fn check_balls(draft: &Draft<'_>, findings: &mut Findings) {
    check_color(&"ball_defaults.color", draft.ball_defaults.color.as_ref(), findings);
    let mut places = BTreeMap::new();
    for (index, ball) in draft.balls() {
        check_id(&draft.place(index, "id"), &ball.id, findings);
        if let Some(first) = places.get(ball.id.as_str()) {
            findings
                .add(draft.place(index, "id"), format!("{:?} is the id of balls[{first}] already", ball.id));
        } else {
            places.insert(ball.id.as_str(), index);
        }
        check_radius(draft, index, ball, findings);
        check_position(draft, index, ball, findings);
        check_motion(index, ball, findings);
        check_color(&draft.place(index, "color"), ball.color.as_ref(), findings);
    }
}

fn check_radius(draft: &Draft<'_>, index: usize, ball: &Ball, findings: &mut Findings) {
    let given = ball.radius.or(draft.ball_defaults.radius).is_some();
    let place = draft.place(index, "radius");
    let is_sound = findings.is_sound(&place) && findings.is_sound("ball_defaults");
    if !given && is_sound && findings.is_sound("table.preset") {
        findings.add(
            place,
            format!("missing: give ball {:?} a radius here, or all balls in ball_defaults.radius", ball.id),
        );
    }
}

fn check_position(draft: &Draft<'_>, index: usize, ball: &Ball, findings: &mut Findings) {
    let place = draft.place(index, "position");
    if ball.position.is_none() && findings.is_sound(&place) && findings.is_sound("rack") {
        let rack = if draft.rack.is_some() { "; the rack has no such ball" } else { "" };
        findings.add(place, format!("missing: give ball {:?} a position, [x, y]{rack}", ball.id));
    }
}

fn check_motion(index: usize, ball: &Ball, findings: &mut Findings) {
    let place = format!("balls[{index}]");
    let is_sound = |key: &str| findings.is_sound(format_args!("{place}.{key}"));
    let problem = match (ball.velocity, ball.speed, ball.direction_deg) {
        (Some(_), Some(_), _) => {
            Some(("velocity", "is given beside speed: give velocity, or speed and direction_deg"))
        }
        (Some(_), None, Some(_)) => {
            Some(("velocity", "is given beside direction_deg: give velocity, or speed and direction_deg"))
        }
        (None, Some(_), None) if is_sound("direction_deg") => Some((
            "direction_deg",
            "missing: speed needs a direction, in degrees from the x axis towards the y axis",
        )),
        (None, None, Some(_)) if is_sound("speed") => Some(("speed", "missing: direction_deg needs a speed")),
        _ => None,
    };
    if let Some((key, message)) = problem {
        findings.add(format_args!("{place}.{key}"), message);
    }
}

fn check_color(place: &dyn Display, color: Option<&Color>, findings: &mut Findings) {
    if let Some(Err(message)) = color.map(Color::check) {
        findings.add(place, message);
    }
}
