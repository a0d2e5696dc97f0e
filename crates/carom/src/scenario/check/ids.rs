//! Names of balls, cushions and obstacles.

use super::Findings;
use crate::model::{self, Cushion};
use crate::scenario::schema::{Obstacle, Piece, Table};
use core::fmt::Display;
use std::collections::BTreeMap;

/// Notes an id that could not be written in a path or a table.
pub(super) fn check_id(place: &dyn Display, id: &str, findings: &mut Findings) {
    let unusable =
        id.contains(|character: char| character == '"' || character.is_control()) || id.trim() != id;
    if unusable {
        findings.add(
            place,
            format!("{id:?} is no usable id: no quotes, no control characters, no space around it"),
        );
    }
}

/// Notes ids of cushions and obstacles that are unusable or given twice.
pub(super) fn check_cushion_ids(written: &Table, table: &model::Table<f64>, findings: &mut Findings) {
    for (place, id) in given_ids(written) {
        check_id(&place, id, findings);
        if id.contains('/') {
            let why = "which joins the names of two cushions at a corner";
            findings.add(place, format!("{id:?} must not contain /, {why}"));
        }
    }
    check_obstacles_differ(written, findings);
    check_cushions_differ(written, table, findings);
}

fn check_obstacles_differ(written: &Table, findings: &mut Findings) {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    for (index, obstacle) in written.obstacles().iter().enumerate() {
        let id = obstacle.id_or_default(index);
        if let Some(first) = seen.get(&id) {
            let place = format!("table.obstacles[{index}].id");
            findings.add(place, format!("{id:?} is the id of table.obstacles[{first}] already"));
        } else {
            seen.insert(id, index);
        }
    }
}

fn check_cushions_differ(written: &Table, table: &model::Table<f64>, findings: &mut Findings) {
    let mut seen: BTreeMap<&str, String> = BTreeMap::new();
    for (number, outline) in table.outlines.iter().enumerate() {
        if !findings.is_sound(written.place_of(number, None)) {
            continue;
        }
        for (index, Cushion { id, .. }) in outline.cushions.iter().enumerate() {
            let place = written.place_of(number, Some(index));
            if let Some(first) = seen.get(id.as_str()) {
                findings.add(place, format!("its id {id:?} is the id of a cushion of {first} already"));
            } else {
                seen.insert(id, place);
            }
        }
    }
}

/// The ids that stand in the table, with their places.
fn given_ids(table: &Table) -> Vec<(String, &str)> {
    let mut ids = Vec::new();
    if let Table::Path { pieces, .. } = table {
        ids.extend(ids_of_pieces("table.pieces", pieces));
    }
    for (index, obstacle) in table.obstacles().iter().enumerate() {
        let place = format!("table.obstacles[{index}]");
        ids.extend(obstacle.id().map(|id| (format!("{place}.id"), id)));
        if let Obstacle::Path { path, .. } = obstacle {
            ids.extend(ids_of_pieces(&format!("{place}.path"), path));
        }
    }
    ids
}

fn ids_of_pieces<'a>(list: &str, pieces: &'a [Piece]) -> Vec<(String, &'a str)> {
    let given = pieces.iter().enumerate().filter_map(|(index, piece)| Some((index, piece.id()?)));
    given.map(|(index, id)| (format!("{list}[{index}].id"), id)).collect()
}
