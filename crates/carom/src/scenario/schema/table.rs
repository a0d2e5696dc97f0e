//! `[table]`: the boundary and what stands inside it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The region the balls move in.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "shape", rename_all = "snake_case", deny_unknown_fields)]
pub enum Table {
    /// A rectangle with its lower left corner at the origin; cushions `left`, `right`, `bottom` and `top`.
    Rectangle {
        /// Size along x, between the noses of the cushions; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        width: f64,
        /// Size along y; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        length: f64,
        /// What stands on the table; absent: nothing.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        obstacles: Vec<Obstacle>,
    },
    /// A circle around the origin; its one cushion is `rim`.
    Circle {
        /// Radius of the table; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        radius: f64,
        /// What stands on the table; absent: nothing.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        obstacles: Vec<Obstacle>,
    },
    /// A closed path, drawn counter-clockwise: each piece begins where the one before it ends, the table to its left.
    Path {
        /// The pieces in order; a piece without an `id` has its place in this list, "0", "1", ..., for one.
        #[schemars(length(min = 1))]
        pieces: Vec<Piece>,
        /// What stands on the table; absent: nothing.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        obstacles: Vec<Obstacle>,
    },
}

impl Table {
    /// What stands on the table.
    pub fn obstacles(&self) -> &[Obstacle] {
        match self {
            Table::Rectangle { obstacles, .. }
            | Table::Circle { obstacles, .. }
            | Table::Path { obstacles, .. } => obstacles,
        }
    }
}

/// A piece of a path; the table lies to the left of its direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum Piece {
    /// A straight piece.
    Line {
        /// First and last point, [[x, y], [x, y]], in length.
        line: [[f64; 2]; 2],
        /// The name of this cushion; absent: its place in the list.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
    },
    /// A round piece.
    Arc {
        /// The circle and the angles between which the piece runs.
        arc: ArcShape,
        /// The name of this cushion; absent: its place in the list.
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
    },
}

impl Piece {
    /// The name given to this piece.
    pub fn id(&self) -> Option<&str> {
        match self {
            Piece::Line { id, .. } | Piece::Arc { id, .. } => id.as_deref(),
        }
    }
}

/// A circular arc: counter-clockwise (hollow) where `to_deg` is larger than `from_deg`, else clockwise (bulging).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArcShape {
    /// Centre [x, y] of the circle, in length.
    pub center: [f64; 2],
    /// Radius of the circle, in length; positive.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius: f64,
    /// Direction from the centre to the first point, in degrees from the x axis towards the y axis.
    pub from_deg: f64,
    /// Direction from the centre to the last point, in degrees; at most 360 away from `from_deg`.
    pub to_deg: f64,
}

/// Something that stands on the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, deny_unknown_fields)]
pub enum Obstacle {
    /// A round pillar: one cushion, with the obstacle's id.
    Circle {
        /// The circle.
        circle: CircleShape,
        /// The name of this obstacle; absent: "obstacle" and its place in the list, such as "obstacle0".
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
    },
    /// A closed path, drawn clockwise, so that the table lies to its left: cushions such as `obstacle0.2`.
    Path {
        /// The pieces in order.
        #[schemars(length(min = 1))]
        path: Vec<Piece>,
        /// The name of this obstacle; absent: "obstacle" and its place in the list, such as "obstacle0".
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
    },
    /// A thin wall, hit from both sides: cushion `obstacle0.a` to the left of its direction, `obstacle0.b` to the
    /// right.
    Wall {
        /// First and last point, [[x, y], [x, y]], in length.
        wall: [[f64; 2]; 2],
        /// The name of this obstacle; absent: "obstacle" and its place in the list, such as "obstacle0".
        #[serde(skip_serializing_if = "Option::is_none")]
        id: Option<String>,
    },
}

impl Obstacle {
    /// The name given to this obstacle.
    pub fn id(&self) -> Option<&str> {
        match self {
            Obstacle::Circle { id, .. } | Obstacle::Path { id, .. } | Obstacle::Wall { id, .. } => {
                id.as_deref()
            }
        }
    }
}

/// A circle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CircleShape {
    /// Centre [x, y], in length.
    pub center: [f64; 2],
    /// Radius, in length; positive.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius: f64,
}
