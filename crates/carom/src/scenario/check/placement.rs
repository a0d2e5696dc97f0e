//! Where the balls are: inside the table, outside the obstacles, and not in each other.

use super::{Draft, Findings, Rounded};
use crate::geometry::{Piece, Vec2, Vec3, signed_distance};
use crate::model::{ContactTolerance, Outline, OutlineKind, Table};
use crate::scenario::start::BallStart;
use std::collections::{BTreeMap, BTreeSet};

/// So many overlapping pairs are named, and no more sought.
const MOST_OVERLAPS: usize = 1000;

/// A ball as far as its place is concerned.
struct Disc<'a> {
    place: String,
    id: &'a str,
    radius: f64,
    center: Vec2<f64>,
    /// The height of its centre; of discs, which lie in one plane, zero.
    height: f64,
    /// How near its centre may come to the noses of cushions, seen from above.
    reach: f64,
}

/// The sides of the table as balls see them: those without cushions, and how far it is once round.
struct Sides {
    open: Vec<&'static str>,
    /// Along each axis; infinite where it is not periodic.
    rounds: [f64; 2],
}

impl Sides {
    fn of(draft: &Draft<'_>, table: &Table<f64>) -> Self {
        let (open, periodic) =
            draft.table.map_or_else(Default::default, |written| (written.open_sides(), written.periodic()));
        let Vec2 { x, y } = table.bounds.max;
        let round = |size: f64, is_periodic: bool| if is_periodic { size } else { f64::INFINITY };
        Self { open, rounds: [round(x, periodic[0]), round(y, periodic[1])] }
    }

    /// The centre of a ball, and those of its images that lie within a width of the table.
    fn images(&self, center: Vec2<f64>, width: f64) -> Vec<Vec2<f64>> {
        let along = |place: f64, round: f64| {
            let seen = [
                Some(place),
                (place < width).then_some(place + round),
                (place > round - width).then_some(place - round),
            ];
            seen.into_iter().flatten().filter(|place| place.is_finite())
        };
        let [round_x, round_y] = self.rounds;
        along(center.x, round_x)
            .flat_map(|x| along(center.y, round_y).map(move |y| Vec2::new(x, y)))
            .collect()
    }
}

/// Notes balls outside the table or in an obstacle, and balls that overlap.
pub(super) fn check_placement(draft: &Draft<'_>, table: &Table<f64>, findings: &mut Findings) {
    let discs = discs(draft, table, findings);
    let tolerance = ContactTolerance::new(table);
    let outlines: Vec<(&Outline<f64>, Vec<Piece<f64>>)> = table
        .outlines
        .iter()
        .map(|outline| (outline, outline.cushions.iter().map(|c| c.piece).collect()))
        .collect();
    let sides = Sides::of(draft, table);
    for disc in &discs {
        for (outline, pieces) in &outlines {
            if let Some(message) = intrusion(disc, outline, pieces, &sides, tolerance) {
                findings.add(&disc.place, message);
            }
        }
        if let Some(pocket) = table.pockets.iter().find(|pocket| pocket.has_inside(disc.center)) {
            findings.add(&disc.place, format!("ball {:?} lies over pocket {:?}", disc.id, pocket.id));
        }
    }
    check_overlaps(&discs, &sides, tolerance, findings);
}

/// The balls whose place and radius are sound.
fn discs<'a>(draft: &Draft<'a>, table: &Table<f64>, findings: &Findings) -> Vec<Disc<'a>> {
    let is_sound = |index: usize, own_radius: bool| {
        let key = |key: &str| findings.is_sound(draft.place(index, key));
        key("position") && key("radius") && (own_radius || findings.is_sound("ball_defaults.radius"))
    };
    let sound = draft.balls().filter(|(index, ball)| is_sound(*index, ball.radius.is_some()));
    sound
        .map(|(index, ball)| {
            let BallStart { radius, position, .. } =
                ball.start(index, draft.ball_defaults, &mut |_, value| value);
            let place = draft.place(index, "position");
            let reach = table.nose.reach(radius, position.z);
            let height = if draft.physics.has_cloth() { position.z } else { 0.0 };
            Disc { place, id: &ball.id, radius, center: position.plan(), height, reach }
        })
        .collect()
}

/// What is wrong with the place of a ball with respect to one outline.
fn intrusion(
    disc: &Disc<'_>,
    outline: &Outline<f64>,
    pieces: &[Piece<f64>],
    sides: &Sides,
    tolerance: ContactTolerance<f64>,
) -> Option<String> {
    let tolerance = tolerance.of(disc.radius);
    if outline.kind != OutlineKind::Wall && signed_distance(pieces, disc.center) < -tolerance {
        return Some(match outline.kind {
            OutlineKind::Boundary => format!("ball {:?} lies outside the table", disc.id),
            _ => format!("ball {:?} lies inside obstacle {:?}", disc.id, outline.id),
        });
    }
    let mut cut = Vec::new();
    for cushion in outline.cushions.iter().filter(|cushion| !sides.open.contains(&cushion.id.as_str())) {
        let depth = disc.reach - cushion.piece.foot(disc.center).distance;
        if depth > tolerance {
            cut.push(format!("cushion {:?} by {}", cushion.id, Rounded(depth)));
        }
    }
    if !cut.is_empty() {
        return Some(format!("ball {:?} reaches past {}", disc.id, cut.join(" and ")));
    }
    let fills = outline.cushions.iter().find(|cushion| is_filled(&cushion.piece, disc.reach, tolerance))?;
    Some(format!(
        "ball {:?} is as wide as round cushion {:?}, and would have no room in it",
        disc.id, fills.id
    ))
}

/// Whether a ball fits a hollow arc exactly, so that its centre could be at one point only. An arc of less than half a
/// circle it never gets into: it meets what is next to the arc first.
fn is_filled(piece: &Piece<f64>, radius: f64, tolerance: f64) -> bool {
    match piece {
        Piece::Line(_) => false,
        Piece::Arc(arc) => {
            let is_pocket = arc.counter_clockwise && arc.sweep_deg > 180.0 - 1e-6;
            is_pocket && (arc.radius - radius).abs() <= tolerance
        }
    }
}

/// Notes pairs of balls that overlap, sought among neighbours in a grid of cells as wide as the largest ball.
fn check_overlaps(
    discs: &[Disc<'_>],
    sides: &Sides,
    tolerance: ContactTolerance<f64>,
    findings: &mut Findings,
) {
    let largest = discs.iter().fold(0.0, |most, disc| if disc.radius > most { disc.radius } else { most });
    let width = 2.0 * largest;
    if width <= 0.0 {
        return;
    }
    let cell = |center: Vec2<f64>| [(center.x / width).floor(), (center.y / width).floor()];
    let mut cells: BTreeMap<[i64; 2], Vec<&Disc<'_>>> = BTreeMap::new();
    let mut found = 0;
    for disc in discs {
        let own = cell(disc.center);
        let images = sides.images(disc.center, width);
        let near = |image: &Vec2<f64>| neighbours(cell(*image)).into_iter().filter_map(|key| cells.get(&key));
        let pairs = images.iter().flat_map(|image| near(image).flatten().map(move |other| (*image, other)));
        for (center, other) in pairs {
            let Some(depth) = overlap(other, disc, center, tolerance) else { continue };
            let message = format!("ball {:?} overlaps ball {:?} by {}", disc.id, other.id, Rounded(depth));
            findings.add(&disc.place, message);
            found += 1;
            if found == MOST_OVERLAPS {
                return findings.note("balls", format!("{found} pairs overlap, and perhaps more"));
            }
        }
        cells.entry(own.map(|number| number as i64)).or_default().push(disc);
    }
}

/// A cell and those around it; as a set, since far from the origin cells are no longer told apart.
fn neighbours([column, row]: [f64; 2]) -> BTreeSet<[i64; 2]> {
    let steps = [-1.0, 0.0, 1.0];
    let around = steps.iter().flat_map(|right| steps.iter().map(move |up| [column + right, row + up]));
    around.map(|cell| cell.map(|number| number as i64)).collect()
}

/// How deep two balls overlap, the second seen at a centre, where it is more than contact; two points never do.
fn overlap(a: &Disc<'_>, b: &Disc<'_>, center: Vec2<f64>, tolerance: ContactTolerance<f64>) -> Option<f64> {
    let radii = a.radius + b.radius;
    let apart = Vec3::above(a.center - center, a.height - b.height).norm();
    let depth = radii - apart;
    (radii > 0.0 && depth > tolerance.of(radii)).then_some(depth)
}
