//! What there is to draw of a table.

use carom::geometry::{Arc, Piece, Vec2};
use carom::model::{Outline, OutlineKind, Pocket};
use carom::scenario::schema;
use serde_json::{Value, json};

/// The cushions and open sides of a table as a JSON value, lines and arcs in order, those of the boundary first; and its
/// pockets.
pub fn outline(written: &schema::Table) -> Value {
    let (table, open) = (&written.layout(&mut |_, value| value), written.open_sides());
    let pieces = |outline| pieces(outline, &open);
    let (min, max) = (table.bounds.min, table.bounds.max);
    json!({
        "size": table.size(),
        "bounds": [min.x, min.y, max.x, max.y],
        "pieces": table.outlines.iter().flat_map(pieces).collect::<Vec<_>>(),
        "pockets": table.pockets.iter().map(pocket).collect::<Vec<_>>(),
    })
}

fn pocket(pocket: &Pocket<f64>) -> Value {
    json!({ "id": pocket.id, "center": point(pocket.center), "radius": pocket.radius })
}

fn pieces(outline: &Outline<f64>, open: &[&str]) -> Vec<Value> {
    let part = |id: &str| match outline.kind {
        OutlineKind::Boundary if open.contains(&id) => "periodic",
        OutlineKind::Boundary => "boundary",
        OutlineKind::Obstacle | OutlineKind::Wall => "obstacle",
    };
    outline.cushions.iter().map(|cushion| piece(&cushion.id, part(&cushion.id), &cushion.piece)).collect()
}

fn piece(id: &str, part: &str, piece: &Piece<f64>) -> Value {
    match piece {
        Piece::Line(line) => json!({
            "id": id, "part": part, "kind": "line", "start": point(line.start), "end": point(line.end),
        }),
        Piece::Arc(arc) => {
            let [from_deg, to_deg] = angles_deg(arc);
            json!({
                "id": id, "part": part, "kind": "arc", "center": point(arc.center), "radius": arc.radius,
                "from_deg": from_deg, "to_deg": to_deg,
            })
        }
    }
}

/// The angles of an arc's ends in degrees; good for drawing, not for computing.
#[allow(clippy::disallowed_methods)]
fn angles_deg(arc: &Arc<f64>) -> [f64; 2] {
    let from = arc.from.y.atan2(arc.from.x).to_degrees();
    [from, if arc.counter_clockwise { from + arc.sweep_deg } else { from - arc.sweep_deg }]
}

fn point(vector: Vec2<f64>) -> [f64; 2] {
    [vector.x, vector.y]
}
