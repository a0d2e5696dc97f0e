//! From the table as written to the table as computed with.

use super::schema::{ArcShape, MouthShape, NoseContact, Obstacle, Piece, PocketShape, Table};
use crate::geometry::{self, Arc, Segment, Vec2};
use crate::model::{self, Cushion, Mouth, Nose, Outline, OutlineKind, Pocket, PocketTable};
use crate::scalar::Scalar;
use core::fmt::Display;

/// Turns a number of the scenario, at a place such as `table.width`, into the scalar of a computation.
///
/// The place lets one number enter as the variable of a derivative.
pub type Number<'a, S> = &'a mut dyn FnMut(&dyn Display, f64) -> S;

impl Table {
    /// The cushions, corners, outlines and pockets of this table.
    ///
    /// Nothing is checked here; a path that does not close gives a table that does not either.
    pub fn layout<S: Scalar>(&self, number: Number<'_, S>) -> model::Table<S> {
        let written = self.pockets().iter().enumerate().map(|(k, item)| pocket(k, item, number)).collect();
        let (boundary, pockets) = match self {
            Table::Rectangle { width, length, .. } => {
                let width = number(&"table.width", *width);
                (model::rectangle(width, number(&"table.length", *length)), written)
            }
            Table::Circle { radius, .. } => (model::circle(number(&"table.radius", *radius)), written),
            Table::Path { pieces, .. } => (cushions(pieces, "", &"table.pieces", number), written),
            Table::PocketTable { width, length, cushion_width, corner, side, .. } => PocketTable {
                width: number(&"table.width", *width),
                length: number(&"table.length", *length),
                cushion_width: number(&"table.cushion_width", *cushion_width),
                corner: mouth("corner", corner, number),
                side: mouth("side", side, number),
            }
            .outline(),
            Table::Preset(_) => return self.expanded().layout(number),
            Table::Absent => (Vec::new(), Vec::new()),
        };
        let obstacles =
            self.obstacles().iter().enumerate().map(|(k, item)| obstacle(k, item, number)).collect();
        let nose = self.nose(number);
        model::Table { pockets, nose, ..model::Table::new(boundary, obstacles) }
    }

    fn nose<S: Scalar>(&self, number: Number<'_, S>) -> Nose<S> {
        let height = self.nose_height().map(|height| number(&"table.nose_height", height));
        let contact = match self.nose_contact().unwrap_or_default() {
            NoseContact::Nose => model::NoseContact::Nose,
            NoseContact::Plan => model::NoseContact::Plan,
        };
        Nose { height, contact }
    }
}

fn pocket<S: Scalar>(index: usize, item: &PocketShape, number: Number<'_, S>) -> Pocket<S> {
    let center = vector(&format_args!("table.pockets[{index}].center"), item.center, number);
    let radius = number(&format_args!("table.pockets[{index}].radius"), item.radius);
    Pocket { id: item.id.clone(), center, radius, tips: None }
}

fn mouth<S: Scalar>(name: &str, item: &MouthShape, number: Number<'_, S>) -> Mouth<S> {
    let mut part = |key: &str, value| number(&format_args!("table.{name}.{key}"), value);
    Mouth {
        width: part("width", item.width),
        angle_deg: part("angle_deg", item.angle_deg),
        depth: part("depth", item.depth),
        radius: part("radius", item.radius),
        jaw_radius: part("jaw_radius", item.jaw_radius),
    }
}

impl Table {
    /// Where an outline of the layout, or one of its cushions, is written: `table.obstacles[1].path[0]`.
    pub(super) fn place_of(&self, outline: usize, cushion: Option<usize>) -> String {
        let Some(obstacle) = outline.checked_sub(1) else {
            return match (self, cushion) {
                (Table::Path { .. }, Some(cushion)) => format!("table.pieces[{cushion}]"),
                (Table::Path { .. }, None) => "table.pieces".into(),
                _ => "table".into(),
            };
        };
        match (self.obstacles().get(obstacle), cushion) {
            (Some(Obstacle::Path { .. }), Some(cushion)) => {
                format!("table.obstacles[{obstacle}].path[{cushion}]")
            }
            _ => format!("table.obstacles[{obstacle}]"),
        }
    }
}

impl Obstacle {
    /// The id of the obstacle at a place of the list.
    pub fn id_or_default(&self, index: usize) -> String {
        self.id().map_or_else(|| format!("obstacle{index}"), str::to_owned)
    }
}

fn obstacle<S: Scalar>(index: usize, item: &Obstacle, number: Number<'_, S>) -> Outline<S> {
    let id = item.id_or_default(index);
    let place = format!("table.obstacles[{index}]");
    match item {
        Obstacle::Circle { circle, .. } => {
            let center = vector(&format_args!("{place}.circle.center"), circle.center, number);
            let radius = number(&format_args!("{place}.circle.radius"), circle.radius);
            Outline::pillar(&id, center, radius)
        }
        Obstacle::Path { path, .. } => {
            let cushions = cushions(path, &format!("{id}."), &format_args!("{place}.path"), number);
            Outline { kind: OutlineKind::Obstacle, id, cushions }
        }
        Obstacle::Wall { wall, .. } => {
            let [start, end] = points(&format_args!("{place}.wall"), *wall, number);
            Outline::wall(&id, start, end)
        }
    }
}

fn cushions<S: Scalar>(
    pieces: &[Piece],
    prefix: &str,
    place: &dyn Display,
    number: Number<'_, S>,
) -> Vec<Cushion<S>> {
    let cushion = |(index, item): (usize, &Piece)| {
        let id = item.id().map_or_else(|| format!("{prefix}{index}"), |id| format!("{prefix}{id}"));
        Cushion { id, piece: piece(&format_args!("{place}[{index}]"), item, number) }
    };
    pieces.iter().enumerate().map(cushion).collect()
}

fn piece<S: Scalar>(place: &dyn Display, item: &Piece, number: Number<'_, S>) -> geometry::Piece<S> {
    match item {
        Piece::Line { line, .. } => {
            let [start, end] = points(&format_args!("{place}.line"), *line, number);
            geometry::Piece::Line(Segment { start, end })
        }
        Piece::Arc { arc: ArcShape { center, radius, from_deg, to_deg }, .. } => {
            let center = vector(&format_args!("{place}.arc.center"), *center, number);
            let radius = number(&format_args!("{place}.arc.radius"), *radius);
            let from = number(&format_args!("{place}.arc.from_deg"), *from_deg);
            let to = number(&format_args!("{place}.arc.to_deg"), *to_deg);
            geometry::Piece::Arc(Arc::from_degrees(center, radius, from, to))
        }
    }
}

fn points<S: Scalar>(place: &dyn Display, ends: [[f64; 2]; 2], number: Number<'_, S>) -> [Vec2<S>; 2] {
    let start = vector(&format_args!("{place}[0]"), ends[0], number);
    [start, vector(&format_args!("{place}[1]"), ends[1], number)]
}

pub(super) fn vector<S: Scalar>(place: &dyn Display, value: [f64; 2], number: Number<'_, S>) -> Vec2<S> {
    let x = number(&format_args!("{place}[0]"), value[0]);
    Vec2::new(x, number(&format_args!("{place}[1]"), value[1]))
}
