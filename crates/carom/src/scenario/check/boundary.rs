//! The boundary and the obstacles: closed, rightly turned, not crossing, and one inside the other as they should.

use super::{Findings, Rounded};
use crate::geometry::{Bounds, Meeting, MeetingKind, Piece, Vec2, meetings, signed_area, signed_distance};
use crate::model::{self, Cushion, JOINT_TOLERANCE, Outline, OutlineKind};
use crate::scenario::schema::Table;

/// Two arcs cannot be fitted to each other as a line is; their ends must meet within this, times the table's size.
const ARC_JOINT_TOLERANCE: f64 = 1e-13;

/// Neighbours that touch each other nearer to their joint than this, times the table's size, touch at the joint: the
/// tangent point of a line and an arc is known only to the root of the tolerance of joints.
const JOINT_ENVIRONMENT: f64 = 1e-4;

/// Notes what is wrong with the outlines of a table; later steps are left out where an earlier one fails.
pub(super) fn check_boundary(written: &Table, table: &model::Table<f64>, findings: &mut Findings) {
    let steps = [check_outlines, check_crossings, check_insides];
    for step in steps {
        if findings.is_sound("table") {
            step(written, table, findings);
        }
    }
}

/// A point in a message.
fn at(point: Vec2<f64>) -> String {
    format!("[{}, {}]", point.x, point.y)
}

fn pieces(outline: &Outline<f64>) -> Vec<Piece<f64>> {
    outline.cushions.iter().map(|cushion| cushion.piece).collect()
}

fn check_outlines(written: &Table, table: &model::Table<f64>, findings: &mut Findings) {
    for (number, outline) in table.outlines.iter().enumerate() {
        let place = |cushion| written.place_of(number, cushion);
        check_pieces(outline, table.size(), &place, findings);
        if findings.is_sound(place(None)) {
            check_joints(outline, table.size(), &place, findings);
        }
        if findings.is_sound(place(None)) {
            check_direction(outline, &place(None), findings);
        }
    }
}

fn check_pieces(
    outline: &Outline<f64>,
    size: f64,
    place: &dyn Fn(Option<usize>) -> String,
    findings: &mut Findings,
) {
    for (index, Cushion { piece, .. }) in outline.cushions[..faces(outline)].iter().enumerate() {
        let sweep = if let Piece::Arc(arc) = piece { arc.sweep_deg } else { 0.0 };
        if sweep > 360.0 * (1.0 + 1e-12) {
            findings
                .add(place(Some(index)), format!("runs through {sweep} degrees: at most 360, a full circle"));
        } else if piece.length() <= size * JOINT_TOLERANCE {
            findings.add(
                place(Some(index)),
                format!("has no length: it starts and ends at {}", at(piece.start())),
            );
        }
    }
}

fn check_joints(
    outline: &Outline<f64>,
    size: f64,
    place: &dyn Fn(Option<usize>) -> String,
    findings: &mut Findings,
) {
    let count = outline.cushions.len();
    for (index, cushion) in outline.cushions.iter().enumerate() {
        let before = &outline.cushions[(index + count - 1) % count];
        let (end, start) = (before.piece.end(), cushion.piece.start());
        let gap = (end - start).norm();
        if gap <= size * ARC_JOINT_TOLERANCE {
            continue;
        }
        let which = if index == 0 { "the last piece" } else { "the piece before" };
        let arcs =
            if gap > size * JOINT_TOLERANCE { "" } else { " (arcs must meet more exactly than lines)" };
        let message = format!(
            "begins at {}, but {which} ends at {}: a gap of {}{arcs}",
            at(start),
            at(end),
            Rounded(gap)
        );
        findings.add(place(Some(index)), message);
    }
}

fn check_direction(outline: &Outline<f64>, place: &str, findings: &mut Findings) {
    let area = signed_area(&pieces(outline));
    let reverse = "reverse the order of the pieces and the direction of each";
    match outline.kind {
        OutlineKind::Wall => {}
        _ if area == 0.0 => findings.add(place, "encloses no area"),
        OutlineKind::Boundary if area < 0.0 => {
            findings.add(place, format!("runs clockwise, but a boundary runs counter-clockwise: {reverse}"));
        }
        OutlineKind::Obstacle if area > 0.0 => {
            findings.add(place, format!("runs counter-clockwise, but an obstacle runs clockwise: {reverse}"));
        }
        _ => {}
    }
}

/// One cushion and where it stands: the number of its outline, and its own in that outline.
struct Standing<'a> {
    outline: usize,
    index: usize,
    cushion: &'a Cushion<f64>,
    bounds: Bounds<f64>,
}

/// All cushions, of walls only one side, in order of their leftmost points.
fn standing(table: &model::Table<f64>) -> Vec<Standing<'_>> {
    let mut all = Vec::new();
    for (outline, chain) in table.outlines.iter().enumerate() {
        for (index, cushion) in chain.cushions[..faces(chain)].iter().enumerate() {
            let bounds = Bounds::around(core::iter::once(&cushion.piece));
            all.push(Standing { outline, index, cushion, bounds });
        }
    }
    all.sort_by(|a, b| a.bounds.min.x.total_cmp(&b.bounds.min.x));
    all
}

/// How many cushions of an outline are drawn: those of a wall lie upon each other.
fn faces(outline: &Outline<f64>) -> usize {
    if outline.kind == OutlineKind::Wall { 1 } else { outline.cushions.len() }
}

fn check_crossings(written: &Table, table: &model::Table<f64>, findings: &mut Findings) {
    let all = standing(table);
    let tolerance = table.size() * JOINT_TOLERANCE;
    let mut problems = Vec::new();
    for (number, left) in all.iter().enumerate() {
        let reach = left.bounds.max.x + tolerance;
        for right in all[number + 1..].iter().take_while(|right| right.bounds.min.x <= reach) {
            let in_order = (left.outline, left.index) < (right.outline, right.index);
            let (first, second) = if in_order { (left, right) } else { (right, left) };
            if let Some(message) = crossing(first, second, table) {
                problems.push((second.outline, second.index, message));
            }
        }
    }
    problems.sort();
    for (outline, index, message) in problems {
        findings.add(written.place_of(outline, Some(index)), message);
    }
}

/// What is wrong with the way two cushions meet, the first before the second in the order of the table.
fn crossing(first: &Standing<'_>, second: &Standing<'_>, table: &model::Table<f64>) -> Option<String> {
    let (outline, other) = (&table.outlines[first.outline], &table.outlines[second.outline]);
    let same_outline = first.outline == second.outline;
    let has_wall = outline.kind == OutlineKind::Wall || other.kind == OutlineKind::Wall;
    let joints = if same_outline { common_joints(outline, first.index, second.index) } else { Vec::new() };
    let is_joint = |point: Vec2<f64>| {
        joints.iter().any(|joint| (*joint - point).norm() <= table.size() * JOINT_ENVIRONMENT)
    };
    let is_wrong = |meeting: &Meeting| match meeting.kind {
        MeetingKind::Cross => !is_joint(meeting.point),
        MeetingKind::Along => true,
        MeetingKind::Against => same_outline || has_wall,
        MeetingKind::Touch => same_outline && !is_joint(meeting.point),
    };
    let tolerance = table.size() * JOINT_TOLERANCE;
    let wrong =
        meetings(&first.cushion.piece, &second.cushion.piece, tolerance).into_iter().find(is_wrong)?;
    let verb = match wrong.kind {
        MeetingKind::Cross => "crosses",
        MeetingKind::Touch => "touches",
        MeetingKind::Along | MeetingKind::Against => "lies upon",
    };
    Some(format!(
        "cushion {:?} {verb} cushion {:?} at {}",
        second.cushion.id,
        first.cushion.id,
        at(wrong.point)
    ))
}

/// The joints that two cushions of an outline, `first` before `second`, have in common.
fn common_joints(outline: &Outline<f64>, first: usize, second: usize) -> Vec<Vec2<f64>> {
    let mut joints = Vec::new();
    if second == first + 1 {
        joints.push(outline.cushions[second].piece.start());
    }
    if first == 0 && second + 1 == outline.cushions.len() {
        joints.push(outline.cushions[first].piece.start());
    }
    joints
}

fn check_insides(written: &Table, table: &model::Table<f64>, findings: &mut Findings) {
    let tolerance = table.size() * JOINT_TOLERANCE;
    let is_beyond = |outer: &Outline<f64>, inner: &Outline<f64>| {
        let (outer, inner) = (pieces(outer), pieces(inner));
        let samples = inner.iter().flat_map(|piece| [piece.start(), piece.middle()]);
        samples.into_iter().any(|point| signed_distance(&outer, point) < -tolerance)
    };
    for (number, inner) in table.outlines.iter().enumerate().skip(1) {
        for (other, outer) in table.outlines.iter().enumerate() {
            if other == number || outer.kind == OutlineKind::Wall || !is_beyond(outer, inner) {
                continue;
            }
            let message = match outer.kind {
                OutlineKind::Boundary => "lies outside the table".to_owned(),
                _ => format!("lies inside obstacle {:?}", outer.id),
            };
            findings.add(written.place_of(number, None), message);
        }
    }
}
