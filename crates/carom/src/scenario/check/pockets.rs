//! Pockets and noses: such as balls can fall into, and reach.

use super::ids::check_id;
use super::{Draft, Findings, Rounded};
use crate::geometry::Piece;
use crate::model;
use crate::scenario::schema::{PresetTable, Table};
use std::collections::BTreeMap;

/// Notes what is wrong with the pockets and the noses of a table.
pub(super) fn check_pockets(draft: &Draft<'_>, table: &model::Table<f64>, findings: &mut Findings) {
    let (Some(written), Some(expanded)) = (draft.written, draft.table) else { return };
    if let Table::Preset(preset) = written {
        check_changes(preset, expanded, findings);
    }
    check_ids(expanded, findings);
    check_mouths(draft, expanded, findings);
    if findings.is_sound("table") && matches!(expanded, Table::PocketTable { .. }) {
        check_rails(table, findings);
    }
    if findings.is_sound("table") && matches!(expanded, Table::PocketTable { .. }) {
        check_backs(draft, table, findings);
    }
    check_nose(draft, table, findings);
}

/// Notes changes to what a preset does not have.
fn check_changes(preset: &PresetTable, expanded: &Table, findings: &mut Findings) {
    if matches!(expanded, Table::PocketTable { .. }) {
        return;
    }
    let given = [
        ("cushion_width", preset.cushion_width.is_some()),
        ("corner", preset.corner != Default::default()),
        ("side", preset.side != Default::default()),
    ];
    for (key, _) in given.into_iter().filter(|(_, is_given)| *is_given) {
        let message = format!("the table {:?} has no pockets", preset.preset.name());
        findings.add(format_args!("table.{key}"), message);
    }
}

fn check_ids(table: &Table, findings: &mut Findings) {
    let mut seen = BTreeMap::new();
    for (index, pocket) in table.pockets().iter().enumerate() {
        let place = format!("table.pockets[{index}].id");
        check_id(&place, &pocket.id, findings);
        if let Some(first) = seen.insert(pocket.id.as_str(), index) {
            findings.add(place, format!("{:?} is the id of table.pockets[{first}] already", pocket.id));
        }
    }
}

/// Notes mouths that not even the smallest ball passes.
fn check_mouths(draft: &Draft<'_>, table: &Table, findings: &mut Findings) {
    let (Table::PocketTable { corner, side, .. }, Some(least)) = (table, least_radius(draft)) else { return };
    for (key, mouth) in [("corner", corner), ("side", side)] {
        let place = format!("table.{key}.width");
        if mouth.width <= 2.0 * least && findings.is_sound(&place) {
            let diameter = 2.0 * least;
            findings.add(place, format!("must be more than a ball, {diameter}, got {}", mouth.width));
        }
    }
}

fn least_radius(draft: &Draft<'_>) -> Option<f64> {
    draft.balls().filter_map(|(_, ball)| ball.radius.or(draft.ball_defaults.radius)).reduce(f64::min)
}

/// Notes mouths so wide that nothing is left of a rail between them.
fn check_rails(table: &model::Table<f64>, findings: &mut Findings) {
    let size = table.size();
    let (mut corners_too_wide, mut sides_too_wide) = (Vec::new(), Vec::new());
    for cushion in table.cushions() {
        let Piece::Line(line) = cushion.piece else { continue };
        let (along, is_long) = match cushion.id.as_str() {
            "bottom" => (line.along().x, false),
            "top" => (-line.along().x, false),
            "right_lower" | "right_upper" => (line.along().y, true),
            "left_lower" | "left_upper" => (-line.along().y, true),
            _ => continue,
        };
        if along <= size * model::JOINT_TOLERANCE {
            let list = if is_long { &mut sides_too_wide } else { &mut corners_too_wide };
            list.push(cushion.id.as_str());
        }
    }
    for (key, ids) in [("corner", corners_too_wide), ("side", sides_too_wide)] {
        if !ids.is_empty() {
            let message =
                format!("leaves nothing of the cushions {}: make the mouths or jaws smaller", ids.join(", "));
            findings.add(format_args!("table.{key}"), message);
        }
    }
}

/// Notes holes so small that a ball touches the back of the pocket before it falls.
fn check_backs(draft: &Draft<'_>, table: &model::Table<f64>, findings: &mut Findings) {
    let Some(least) = least_radius(draft) else { return };
    for (key, id) in [("corner", "lb"), ("side", "lc")] {
        let back = table.cushions().find(|cushion| cushion.id == format!("{id}.back"));
        let pocket = table.pockets.iter().find(|pocket| pocket.id == id);
        let (Some(Piece::Arc(back)), Some(pocket)) = (back.map(|cushion| cushion.piece), pocket) else {
            continue;
        };
        if back.radius - least > pocket.radius {
            let message = format!(
                "is too small: a ball of radius {least} would touch the back of the pocket before it falls; at least {}",
                Rounded(back.radius - least)
            );
            findings.add(format_args!("table.{key}.radius"), message);
        }
    }
}

/// Notes noses that balls on the cloth would not touch.
fn check_nose(draft: &Draft<'_>, table: &model::Table<f64>, findings: &mut Findings) {
    let Some(height) = table.nose.height else { return };
    let is_sound =
        ["table.nose_height", "ball_defaults.radius", "balls"].iter().all(|key| findings.is_sound(key));
    for (_, ball) in draft.balls() {
        let radius = ball.radius.or(draft.ball_defaults.radius).unwrap_or_default();
        if is_sound && radius > 0.0 && height >= 2.0 * radius {
            let diameter = 2.0 * radius;
            let message =
                format!("must be less than the diameter {diameter} of ball {:?}, got {height}", ball.id);
            return findings.add("table.nose_height", message);
        }
    }
}
