//! What there is to draw of a scenario: its table, and its balls at the start.

use super::schema::{self, Ball, Scenario};
use crate::geometry::{Arc, Piece, Vec2};
use crate::model::{Outline, OutlineKind, Pocket};
use crate::scalar::angle_deg;
use serde_json::{Value, json};

impl Scenario {
    /// The cushions and open sides of the table as a JSON value, lines and arcs in order, those of the boundary first; and
    /// its pockets.
    pub fn outline(&self) -> Value {
        table(&self.expanded().table)
    }

    /// The balls as a JSON value, with radius, mass, velocity and, on a cloth, spin filled in; before the cue strikes.
    pub fn balls_at_start(&self) -> Value {
        let scenario = self.expanded();
        let has_cloth = scenario.physics.has_cloth();
        let ball = |(k, ball): (usize, &Ball)| {
            let start = ball.start::<f64>(k, &scenario.ball_defaults, &mut |_, value| value);
            let components = if has_cloth { 3 } else { 2 };
            let mut row = json!({
                "id": ball.id,
                "radius": start.radius,
                "mass": start.mass,
                "position": start.position.to_f64()[..components],
                "velocity": start.velocity.to_f64()[..components],
                "color": ball.color.as_ref().or(scenario.ball_defaults.color.as_ref()),
            });
            if has_cloth {
                row["spin"] = json!(start.spin.to_f64());
            }
            row
        };
        scenario.balls.iter().enumerate().map(ball).collect()
    }

    /// The cue as a JSON value: its measures and the offset of the contact, over the ball's radius, up to which the tip holds;
    /// and the shot, if there is one, with the place of its ball in the list. Null where there is no cloth.
    pub fn cue_to_draw(&self) -> Value {
        let scenario = self.expanded();
        if !scenario.physics.has_cloth() {
            return Value::Null;
        }
        let cue = scenario.cue.start::<f64>(&mut |_, value| value);
        json!({
            "tip_radius": cue.tip_radius,
            "miscue_offset": cue.miscue_offset,
            "length": cue.length,
            "shaft_radius": cue.shaft_radius,
            "butt_radius": cue.butt_radius,
            "shot": scenario.shot_to_draw(cue.tip_radius),
        })
    }

    fn shot_to_draw(&self, tip_radius: f64) -> Option<Value> {
        let (shot, start) = (self.shot.as_ref()?, self.shot_start::<f64>(&mut |_, value| value)?);
        let ball = &self.balls[start.ball];
        let radius = ball.start::<f64>(start.ball, &self.ball_defaults, &mut |_, value| value).radius;
        Some(json!({
            "ball": start.ball,
            "speed": start.speed,
            "direction": point(start.direction),
            "elevation": start.elevation,
            "left": start.left,
            "top": start.top,
            "offset_scale": shot.offset_scale(tip_radius, radius),
        }))
    }
}

fn table(written: &schema::Table) -> Value {
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

/// The angles of an arc's ends in degrees.
fn angles_deg(arc: &Arc<f64>) -> [f64; 2] {
    let from = angle_deg(arc.from.x, arc.from.y);
    [from, if arc.counter_clockwise { from + arc.sweep_deg } else { from - arc.sweep_deg }]
}

fn point(vector: Vec2<f64>) -> [f64; 2] {
    [vector.x, vector.y]
}
