//! The outline of a table with six pockets.
//!
//! Counter-clockwise from the lower left pocket:
//!
//! | pocket | cushions, in order | then the rail |
//! |---|---|---|
//! | `lb` | `lb.jaw_left`, `lb.facing_left`, `lb.back`, `lb.facing_bottom`, `lb.jaw_bottom` | `bottom` |
//! | `rb` | `rb.jaw_bottom`, `rb.facing_bottom`, `rb.back`, `rb.facing_right`, `rb.jaw_right` | `right_lower` |
//! | `rc` | `rc.jaw_lower`, `rc.facing_lower`, `rc.back`, `rc.facing_upper`, `rc.jaw_upper` | `right_upper` |
//! | `rt` | `rt.jaw_right`, `rt.facing_right`, `rt.back`, `rt.facing_top`, `rt.jaw_top` | `top` |
//! | `lt` | `lt.jaw_top`, `lt.facing_top`, `lt.back`, `lt.facing_left`, `lt.jaw_left` | `left_upper` |
//! | `lc` | `lc.jaw_upper`, `lc.facing_upper`, `lc.back`, `lc.facing_lower`, `lc.jaw_lower` | `left_lower` |
//!
//! Pockets are named as in pooltool: left or right, then bottom, centre or top. pooltool numbers the cushions clockwise
//! from the lower left: a facing is a number, its jaw the same with a t.
//!
//! | pooltool | here | pooltool | here | pooltool | here |
//! |---|---|---|---|---|---|
//! | 1, 1t | `lb.facing_bottom`, `lb.jaw_bottom` | 7, 7t | `lt.facing_left`, `lt.jaw_left` | 13, 13t | `rc.facing_upper`, `rc.jaw_upper` |
//! | 2, 2t | `lb.facing_left`, `lb.jaw_left` | 8, 8t | `lt.facing_top`, `lt.jaw_top` | 14, 14t | `rc.facing_lower`, `rc.jaw_lower` |
//! | 3 | `left_lower` | 9 | `top` | 15 | `right_lower` |
//! | 4, 4t | `lc.facing_lower`, `lc.jaw_lower` | 10, 10t | `rt.facing_top`, `rt.jaw_top` | 16, 16t | `rb.facing_right`, `rb.jaw_right` |
//! | 5, 5t | `lc.facing_upper`, `lc.jaw_upper` | 11, 11t | `rt.facing_right`, `rt.jaw_right` | 17, 17t | `rb.facing_bottom`, `rb.jaw_bottom` |
//! | 6 | `left_upper` | 12 | `right_upper` | 18 | `bottom` |
//!
//! A mouth of width p, its facings turned by α towards the axis: the line of a nose and that of its facing meet in the
//! horn tip, p/√2 from the nose corner or p/2 from the middle of a side. There the facing turns away from the line of the
//! nose by 90° − c, where c = 45° + α at a corner and α at a side. A jaw of radius ρ is the arc that touches both lines,
//! ρ cos c / (1 + sin c) from the tip; so the noses end that much further apart than the mouth is wide. A facing ends
//! `cushion_width` behind the nose; where a jaw's rounding would be longer than its facing, as at the sides of a snooker
//! table, there is no facing, and the jaw itself ends there. The back is the arc around the centre of the hole from the end of one facing to that
//! of the other: as long as it is less than a ball's radius larger than the hole, no ball touches it before it falls.
//!
//! pooltool lets the facings of a side end in a slightly other place (it has a sine where a tangent is meant), 0.05 mm
//! away on its 7-foot table.

use super::pocket::Pocket;
use super::table::Cushion;
use crate::geometry::{Arc, Piece, Segment, Vec2};
use crate::scalar::{Scalar, angle_deg, direction};

/// What the shape of a pocket table follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PocketTable<S> {
    /// Size along x, between the noses.
    pub width: S,
    /// Size along y.
    pub length: S,
    /// How far behind the nose a facing ends.
    pub cushion_width: S,
    /// The pockets at the corners.
    pub corner: Mouth<S>,
    /// The pockets in the middle of the long sides.
    pub side: Mouth<S>,
}

/// The mouth of a pocket, and the hole behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mouth<S> {
    /// Distance between the horn tips.
    pub width: S,
    /// By how much each facing narrows the pocket, in degrees.
    pub angle_deg: S,
    /// How far the centre of the hole lies outside the nose corner or the nose line.
    pub depth: S,
    /// Radius of the hole.
    pub radius: S,
    /// Radius of the jaws' rounding.
    pub jaw_radius: S,
}

/// One end of a rail: the horn tip, and which way the lines run there.
#[derive(Clone, Copy, Debug)]
struct Horn<S> {
    tip: Vec2<S>,
    /// Unit vector along the nose, towards the pocket.
    along: Vec2<S>,
    /// Unit vector from the nose outwards.
    outward: Vec2<S>,
    /// Cosine and sine of the angle c between the facing and `outward`.
    turn: (S, S),
    jaw_radius: S,
    cushion_width: S,
}

/// A pocket with the horns before and after it, in the direction of the outline.
struct Place<S> {
    pocket: Pocket<S>,
    horns: [Horn<S>; 2],
    /// What stands in the names of its jaws, before and after.
    sides: [&'static str; 2],
    /// The rail that follows.
    rail: &'static str,
}

impl<S: Scalar> PocketTable<S> {
    /// The cushions in order, and the pockets.
    pub fn outline(&self) -> (Vec<Cushion<S>>, Vec<Pocket<S>>) {
        let places = self.places();
        let mut cushions = Vec::new();
        for (index, place) in places.iter().enumerate() {
            place.add_cushions(&mut cushions);
            let [_, start] = place.horns;
            let [end, _] = places[(index + 1) % places.len()].horns;
            let piece = Piece::Line(Segment { start: start.rail_end(), end: end.rail_end() });
            cushions.push(Cushion { id: place.rail.into(), piece });
        }
        (cushions, places.into_iter().map(|place| place.pocket).collect())
    }

    /// The pockets, counter-clockwise from the lower left.
    fn places(&self) -> [Place<S>; 6] {
        let (left, bottom) = (S::ZERO, S::ZERO);
        let (right, top) = (self.width, self.length);
        let middle = self.length * S::from_f64(0.5);
        let x = Vec2::new(S::ONE, S::ZERO);
        let y = x.left();
        let corner = |id, x, y, along, sides, rail| self.corner(id, Vec2::new(x, y), along, sides, rail);
        [
            corner("lb", left, bottom, -y, ["left", "bottom"], "bottom"),
            corner("rb", right, bottom, x, ["bottom", "right"], "right_lower"),
            self.side("rc", Vec2::new(right, middle), y, ["lower", "upper"], "right_upper"),
            corner("rt", right, top, y, ["right", "top"], "top"),
            corner("lt", left, top, -x, ["top", "left"], "left_upper"),
            self.side("lc", Vec2::new(left, middle), -y, ["upper", "lower"], "left_lower"),
        ]
    }

    /// A pocket at a nose corner, at which the outline arrives in the direction `along` and leaves to the left of it.
    fn corner(
        &self,
        id: &str,
        nose: Vec2<S>,
        along: Vec2<S>,
        sides: [&'static str; 2],
        rail: &'static str,
    ) -> Place<S> {
        let half = S::from_f64(0.5).sqrt();
        let (to_tip, to_center) = (self.corner.width * half, self.corner.depth * half);
        let (arriving, leaving) = (along, along.left());
        let turn = direction(S::from_f64(45.0) + self.corner.angle_deg);
        let before = self.horn(nose - arriving * to_tip, arriving, -leaving, turn, &self.corner);
        let after = self.horn(nose + leaving * to_tip, -leaving, arriving, turn, &self.corner);
        let center = nose + (arriving - leaving) * to_center;
        let tips = Some([before.tip, after.tip]);
        let pocket = Pocket { id: id.into(), center, radius: self.corner.radius, tips };
        Place { pocket, horns: [before, after], sides, rail }
    }

    /// A pocket in the middle of a side, along which the outline runs.
    fn side(
        &self,
        id: &str,
        nose: Vec2<S>,
        along: Vec2<S>,
        sides: [&'static str; 2],
        rail: &'static str,
    ) -> Place<S> {
        let outward = -along.left();
        let to_tip = self.side.width * S::from_f64(0.5);
        let turn = direction(self.side.angle_deg);
        let before = self.horn(nose - along * to_tip, along, outward, turn, &self.side);
        let after = self.horn(nose + along * to_tip, -along, outward, turn, &self.side);
        let center = nose + outward * self.side.depth;
        let tips = Some([before.tip, after.tip]);
        let pocket = Pocket { id: id.into(), center, radius: self.side.radius, tips };
        Place { pocket, horns: [before, after], sides, rail }
    }

    fn horn(
        &self,
        tip: Vec2<S>,
        along: Vec2<S>,
        outward: Vec2<S>,
        turn: (S, S),
        mouth: &Mouth<S>,
    ) -> Horn<S> {
        let (jaw_radius, cushion_width) = (mouth.jaw_radius, self.cushion_width);
        Horn { tip, along, outward, turn, jaw_radius, cushion_width }
    }
}

impl<S: Scalar> Place<S> {
    fn add_cushions(&self, cushions: &mut Vec<Cushion<S>>) {
        let [before, after] = &self.horns;
        let mut add = |name: &str, side: &str, piece: Option<Piece<S>>| {
            let id = format!("{}.{name}{side}", self.pocket.id);
            cushions.extend(piece.map(|piece| Cushion { id, piece }));
        };
        add("jaw_", self.sides[0], before.jaw().map(Piece::Arc));
        add("facing_", self.sides[0], before.facing().map(Piece::Line));
        add("back", "", Some(Piece::Arc(self.back())));
        let reversed = |line: Segment<S>| Segment { start: line.end, end: line.start };
        add("facing_", self.sides[1], after.facing().map(reversed).map(Piece::Line));
        add("jaw_", self.sides[1], after.jaw().map(|jaw| Piece::Arc(jaw.reversed())));
    }

    /// The arc around the centre of the hole that joins the ends of the facings.
    fn back(&self) -> Arc<S> {
        let center = self.pocket.center;
        let rays = [self.horns[0].end() - center, self.horns[1].end() - center];
        let [from, to] = rays.map(Vec2::unit);
        let swept = angle_deg(from.dot(to).to_f64(), from.cross(to).to_f64());
        let sweep_deg = if swept > 0.0 { swept } else { swept + 360.0 };
        Arc { center, radius: rays[0].norm(), from, to, counter_clockwise: true, sweep_deg }
    }
}

impl<S: Scalar> Horn<S> {
    /// The distance from the tip to where the lines of nose and facing are left for the jaw.
    fn cut(&self) -> S {
        let (cos, sin) = self.turn;
        self.jaw_radius * cos / (S::ONE + sin)
    }

    /// Where the straight nose ends.
    fn rail_end(&self) -> Vec2<S> {
        self.jaw().map_or(self.tip, |jaw| Piece::Arc(jaw).start())
    }

    /// Where this side of the pocket ends and the back begins.
    fn end(&self) -> Vec2<S> {
        match (self.facing(), self.jaw()) {
            (None, Some(jaw)) => Piece::Arc(jaw).end(),
            (Some(facing), _) => facing.end,
            (None, None) => self.tip,
        }
    }

    /// The straight facing, from the jaw outwards; none where the jaw is longer.
    fn facing(&self) -> Option<Segment<S>> {
        let (cos, sin) = self.turn;
        let (from, to) = (self.cut(), self.cushion_width / cos);
        let facing = self.along * sin + self.outward * cos;
        let start = self.jaw().map_or(self.tip, |jaw| Piece::Arc(jaw).end());
        (from < to).then(|| Segment { start, end: self.tip + facing * to })
    }

    /// The rounding, from the nose to the facing, or as far as it reaches; none where its radius is zero.
    fn jaw(&self) -> Option<Arc<S>> {
        if self.jaw_radius <= S::ZERO {
            return None;
        }
        let center = self.tip - self.along * self.cut() + self.outward * self.jaw_radius;
        let from = -self.outward;
        let (cos, sin) = self.jaw_end();
        let to = self.along * cos - self.outward * sin;
        let (along, across) = (from.dot(to), from.cross(to));
        let sweep_deg = angle_deg(along.to_f64(), across.to_f64()).abs();
        let counter_clockwise = across > S::ZERO;
        Some(Arc { center, radius: self.jaw_radius, from, to, counter_clockwise, sweep_deg })
    }

    /// Along and against the outward direction, the ray from the jaw's centre to its last point: square to the facing, or
    /// to the point that lies `cushion_width` behind the nose.
    fn jaw_end(&self) -> (S, S) {
        let (cos, _) = self.turn;
        if self.cut() < self.cushion_width / cos {
            return self.turn;
        }
        let sin = S::ONE - self.cushion_width / self.jaw_radius;
        ((S::ONE - sin.squared()).sqrt(), sin)
    }
}
