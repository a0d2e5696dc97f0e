//! Laws of single cushions and corners, whether there are such; and coefficients that depend on something, whether they
//! stay in range.

use super::{Findings, Rounded};
use crate::model;
use crate::scenario::nearest::suggestion;
use crate::scenario::path::Key;
use crate::scenario::schema::{BallCushion, CushionFriction, Physics, Rebound, Table};
use core::f64::consts::FRAC_PI_2;

/// Notes laws of cushions and corners that do not exist.
pub(super) fn check_laws(
    physics: &Physics,
    written: &Table,
    table: &model::Table<f64>,
    findings: &mut Findings,
) {
    let corners = table.corners.iter().map(|corner| corner.id.as_str());
    let open = written.open_sides();
    let cushions = table.cushions().map(|cushion| cushion.id.as_str()).filter(|id| !open.contains(id));
    let known: Vec<&str> = cushions.chain(corners).collect();
    for id in physics.cushions.keys().filter(|id| !known.contains(&id.as_str())) {
        let message = if open.contains(&id.as_str()) {
            "the table has no such cushion: this side is periodic, and balls pass through it".into()
        } else {
            format!("the table has no such cushion or corner{}", suggestion(id, &known))
        };
        findings.add(format_args!("physics.cushions.{}", Key(id)), message);
    }
}

/// Notes coefficients of restitution and friction that leave their range somewhere.
pub(super) fn check_parameters(physics: &Physics, findings: &mut Findings) {
    check_coefficients("physics.ball_cushion", physics.ball_cushion(), findings);
    for (id, law) in &physics.cushions {
        check_coefficients(&format!("physics.cushions.{}", Key(id)), law, findings);
    }
}

fn check_coefficients(place: &str, law: &BallCushion, findings: &mut Findings) {
    let Some((_, normal, friction)) = law.with_spin() else { return };
    let sound = |findings: &Findings, key: &str| findings.is_sound(format_args!("{place}.{key}"));
    if let Rebound::BySpeed { by_speed: [c0, c1, c2], up_to } = normal
        && sound(findings, "normal")
    {
        let turning = -c1 / (2.0 * c2);
        let speeds = [0.0, up_to, turning].into_iter().filter(|speed| (0.0..=up_to).contains(speed));
        let at = |speed: f64| c0 + (c1 + c2 * speed) * speed;
        if let Some(speed) = speeds.into_iter().find(|speed| !(0.0..=1.0).contains(&at(*speed))) {
            let message = format!(
                "must give numbers between 0 and 1, but at speed {} gives {}",
                Rounded(speed),
                Rounded(at(speed))
            );
            findings.add(format_args!("{place}.normal.by_speed"), message);
        }
    }
    if let CushionFriction::ByIncidence { by_incidence: [c0, c1] } = friction
        && sound(findings, "friction")
        && (c0 < 0.0 || c0 + c1 * FRAC_PI_2 < 0.0)
    {
        let message = format!(
            "must not be negative between 0 and a quarter turn: it is {c0} and {} there",
            Rounded(c0 + c1 * FRAC_PI_2)
        );
        findings.add(format_args!("{place}.friction.by_incidence"), message);
    }
}
