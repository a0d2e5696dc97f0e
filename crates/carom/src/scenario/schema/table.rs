//! `[table]`: the boundary and what stands inside it.

use super::{Preset, is_default};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The region the balls move in.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "shape", rename_all = "snake_case", deny_unknown_fields)]
pub enum Table {
    /// What stands here while none is written: the box of the gas, where there is one.
    #[default]
    #[serde(skip)]
    Absent,
    /// A rectangle with its lower left corner at the origin; cushions `left`, `right`, `bottom` and `top`.
    Rectangle {
        /// Size along x, between the noses of the cushions; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        width: f64,
        /// Size along y; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        length: f64,
        /// Axes that have no cushions: a ball that leaves on one side comes in on the other, and sees the table repeated
        /// for ever; absent: none. Not on a cloth, with obstacles or in a field.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        #[schemars(extend("uniqueItems" = true))]
        periodic: Vec<Axis>,
        /// What stands on the table; absent: nothing.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        obstacles: Vec<Obstacle>,
        /// Height of the cushions' noses above the cloth, in length; absent: that of the ball's centre. On a cloth only.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        nose_height: Option<f64>,
        /// Where a ball touches a nose; absent: nose. On a cloth only.
        #[serde(skip_serializing_if = "Option::is_none")]
        nose_contact: Option<NoseContact>,
        /// Circles that balls fall into; absent: none. On a cloth only.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        pockets: Vec<PocketShape>,
    },
    /// A circle around the origin; its one cushion is `rim`.
    Circle {
        /// Radius of the table; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        radius: f64,
        /// What stands on the table; absent: nothing.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        obstacles: Vec<Obstacle>,
        /// Height of the cushions' noses above the cloth, in length; absent: that of the ball's centre. On a cloth only.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        nose_height: Option<f64>,
        /// Where a ball touches a nose; absent: nose. On a cloth only.
        #[serde(skip_serializing_if = "Option::is_none")]
        nose_contact: Option<NoseContact>,
        /// Circles that balls fall into; absent: none. On a cloth only.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        pockets: Vec<PocketShape>,
    },
    /// A closed path, drawn counter-clockwise: each piece begins where the one before it ends, the table to its left.
    Path {
        /// The pieces in order; a piece without an `id` has its place in this list, "0", "1", ..., for one.
        #[schemars(length(min = 1))]
        pieces: Vec<Piece>,
        /// What stands on the table; absent: nothing.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        obstacles: Vec<Obstacle>,
        /// Height of the cushions' noses above the cloth, in length; absent: that of the ball's centre. On a cloth only.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        nose_height: Option<f64>,
        /// Where a ball touches a nose; absent: nose. On a cloth only.
        #[serde(skip_serializing_if = "Option::is_none")]
        nose_contact: Option<NoseContact>,
        /// Circles that balls fall into; absent: none. On a cloth only.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        pockets: Vec<PocketShape>,
    },
    /// A table with six pockets, its lower left nose corner at the origin: six straight cushions between rounded jaws,
    /// and behind each mouth two facings and a back.
    PocketTable {
        /// Size along x, between the noses of the cushions; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        width: f64,
        /// Size along y; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        length: f64,
        /// How far behind the nose a facing ends, in length; positive.
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        cushion_width: f64,
        /// The four pockets at the corners.
        corner: MouthShape,
        /// The two pockets in the middle of the long sides.
        side: MouthShape,
        /// What stands on the table; absent: nothing.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        obstacles: Vec<Obstacle>,
        /// Height of the cushions' noses above the cloth, in length; absent: that of the ball's centre. On a cloth only.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0.0))]
        nose_height: Option<f64>,
        /// Where a ball touches a nose; absent: nose. On a cloth only.
        #[serde(skip_serializing_if = "Option::is_none")]
        nose_contact: Option<NoseContact>,
    },
    /// A table that comes with carom, its balls, cue and laws with it. Each further key replaces the preset's.
    #[serde(untagged)]
    Preset(PresetTable),
}

/// An axis of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Across the width.
    X,
    /// Along the length.
    Y,
}

impl Axis {
    /// The word used in files, on the shell and in Python.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
        }
    }
}

impl Table {
    /// Which axes are periodic.
    pub fn periodic(&self) -> [bool; 2] {
        let Table::Rectangle { periodic, .. } = self else { return [false; 2] };
        [Axis::X, Axis::Y].map(|axis| periodic.contains(&axis))
    }

    /// The cushions that a rectangle does not have, since its sides are open.
    pub fn open_sides(&self) -> Vec<&'static str> {
        let [x, y] = self.periodic();
        let sides = [("left", x), ("right", x), ("bottom", y), ("top", y)];
        sides.into_iter().filter(|(_, is_open)| *is_open).map(|(side, _)| side).collect()
    }

    /// What stands on the table.
    pub fn obstacles(&self) -> &[Obstacle] {
        match self {
            Table::Rectangle { obstacles, .. }
            | Table::Circle { obstacles, .. }
            | Table::Path { obstacles, .. }
            | Table::PocketTable { obstacles, .. }
            | Table::Preset(PresetTable { obstacles, .. }) => obstacles,
            Table::Absent => &[],
        }
    }

    /// The pockets that are written one by one; those of a pocket table follow from its shape.
    pub fn pockets(&self) -> &[PocketShape] {
        match self {
            Table::Rectangle { pockets, .. }
            | Table::Circle { pockets, .. }
            | Table::Path { pockets, .. } => pockets,
            Table::PocketTable { .. } | Table::Preset(_) | Table::Absent => &[],
        }
    }

    /// The height of the noses, where it is given.
    pub fn nose_height(&self) -> Option<f64> {
        match self {
            Table::Rectangle { nose_height, .. }
            | Table::Circle { nose_height, .. }
            | Table::Path { nose_height, .. }
            | Table::PocketTable { nose_height, .. }
            | Table::Preset(PresetTable { nose_height, .. }) => *nose_height,
            Table::Absent => None,
        }
    }

    /// Where balls touch the noses, where it is given.
    pub fn nose_contact(&self) -> Option<NoseContact> {
        match self {
            Table::Rectangle { nose_contact, .. }
            | Table::Circle { nose_contact, .. }
            | Table::Path { nose_contact, .. }
            | Table::PocketTable { nose_contact, .. }
            | Table::Preset(PresetTable { nose_contact, .. }) => *nose_contact,
            Table::Absent => None,
        }
    }

    /// The table that comes with carom, where it is one.
    pub fn preset(&self) -> Option<&PresetTable> {
        if let Table::Preset(preset) = self { Some(preset) } else { None }
    }
}

/// A table that comes with carom, and what is different about this one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PresetTable {
    /// Its name.
    pub preset: Preset,
    /// Size along x, between the noses of the cushions; absent: the preset's.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub width: Option<f64>,
    /// Size along y; absent: the preset's.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub length: Option<f64>,
    /// How far behind the nose a facing ends, in length; absent: the preset's.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub cushion_width: Option<f64>,
    /// What is different about the four pockets at the corners.
    #[serde(default, skip_serializing_if = "is_default")]
    pub corner: MouthChange,
    /// What is different about the two pockets in the middle of the long sides.
    #[serde(default, skip_serializing_if = "is_default")]
    pub side: MouthChange,
    /// What stands on the table; absent: nothing.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<Obstacle>,
    /// Height of the cushions' noses above the cloth, in length; absent: the preset's.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub nose_height: Option<f64>,
    /// Where a ball touches a nose; absent: the preset's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nose_contact: Option<NoseContact>,
}

/// Where a ball touches the nose of a cushion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NoseContact {
    /// Where the nose is: above or below the ball's centre, so that the centre comes nearer to it than the radius.
    #[default]
    Nose,
    /// When the centre is one radius away from the nose, seen from above, as in pooltool; the blow has the direction of
    /// the nose all the same.
    Plan,
}

/// A circle that balls fall into.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PocketShape {
    /// The name of this pocket, unlike that of any other; not empty.
    #[schemars(length(min = 1))]
    pub id: String,
    /// Centre [x, y], in length.
    pub center: [f64; 2],
    /// Radius, in length; a ball falls when its centre is inside; positive.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius: f64,
}

/// The pockets at the corners, or those in the middle of the long sides.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MouthShape {
    /// Width of the mouth, in length: between the points in which the lines of the noses and of the facings meet. Rounded
    /// jaws leave the noses before these points, so that the noses end a little further apart. Positive.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub width: f64,
    /// By how much each facing narrows the pocket, in degrees from its axis: 7 at a corner that is cut at 142 degrees, 14
    /// at a side that is cut at 104.
    #[schemars(range(min = -30.0, max = 40.0))]
    pub angle_deg: f64,
    /// How far the centre of the hole lies outside the nose corner, or the nose line of a side, in length.
    #[schemars(range(min = 0.0))]
    pub depth: f64,
    /// Radius of the hole, in length; a ball falls when its centre is inside; positive.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius: f64,
    /// Radius of the jaws' rounding, in length; zero: the noses end in points.
    #[schemars(range(min = 0.0))]
    pub jaw_radius: f64,
}

/// What is different about the pockets of a preset; what is absent stays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MouthChange {
    /// Width of the mouth, in length.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub width: Option<f64>,
    /// By how much each facing narrows the pocket, in degrees from its axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = -30.0, max = 40.0))]
    pub angle_deg: Option<f64>,
    /// How far the centre of the hole lies outside the nose corner, or the nose line of a side, in length.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub depth: Option<f64>,
    /// Radius of the hole, in length.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub radius: Option<f64>,
    /// Radius of the jaws' rounding, in length.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub jaw_radius: Option<f64>,
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
