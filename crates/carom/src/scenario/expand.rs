//! Presets, racks and gases turned into plain keys.
//!
//! What a preset gives lies under what is written, key by key; a law that is written replaces the preset's whole.

use super::rack::racked;
use super::schema::{
    Ball, BallDefaults, Cue, MouthChange, MouthShape, Physics, Preset, PresetTable, Rack, Scenario, Table,
    Units,
};
use std::borrow::Cow;

impl Scenario {
    /// This scenario with its preset, its rack and its gas turned into plain keys, and its cue filled in where there is a shot.
    ///
    /// A gas that cannot be made, which a check refuses, has no table and no balls. Balls keep their places: first come those that are written, then those of the rack that are not. So a place such as
    /// `balls[2].radius` is the same in both.
    ///
    /// ```
    /// # use carom::scenario::Scenario;
    /// let scenario = Scenario::from_toml(
    ///     "table.preset = 'pool_9ft'\nrack.game = 'nine_ball'\n[shot]\nV0 = 8\nphi_deg = 90",
    /// )?;
    /// assert_eq!(scenario.balls.len(), 0);
    /// assert_eq!(scenario.expanded().balls.len(), 10);
    /// # Ok::<(), carom::scenario::ScenarioError>(())
    /// ```
    pub fn expanded(&self) -> Cow<'_, Self> {
        if let Some(gas) = &self.gas {
            let (table, balls) = gas.table_and_balls().unwrap_or_default();
            let plain = Self { table, balls, gas: None, record: Some(self.record()), ..self.clone() };
            return Cow::Owned(plain.with_plain_record());
        }
        if self.table.preset().is_none() && self.rack.is_none() && self.shot.is_none() {
            return Cow::Borrowed(self);
        }
        let preset = self.table.preset().map(|table| table.preset);
        let table = self.table.expanded().into_owned();
        let ball_defaults = self.ball_defaults.over(preset);
        let written: Vec<_> = self.balls.iter().cloned().map(Some).collect();
        let balls = with_rack(&written, self.rack.as_ref(), Some(&table), &ball_defaults, preset);
        Cow::Owned(Self {
            physics: self.physics.over(preset),
            cue: self.cue.over(preset, self.shot.is_some()),
            units: self.units.over(preset),
            rack: None,
            table,
            ball_defaults,
            balls: balls.into_iter().flatten().collect(),
            ..self.clone()
        })
    }
}

impl Scenario {
    /// The names of the units, those of the preset where none are written.
    pub fn unit_names(&self) -> Units {
        self.units.over(self.table.preset().map(|table| table.preset))
    }

    /// Whether the balls roll and spin on a cloth.
    pub fn has_cloth(&self) -> bool {
        self.physics.over(self.table.preset().map(|table| table.preset)).has_cloth()
    }
}

impl Table {
    /// This table as a shape.
    pub fn expanded(&self) -> Cow<'_, Self> {
        match self {
            Table::Preset(preset) => Cow::Owned(preset.expanded()),
            _ => Cow::Borrowed(self),
        }
    }
}

impl PresetTable {
    /// The shape of the preset, with what is different here.
    ///
    /// Keys that the shape does not have, which a check refuses, are left out.
    fn expanded(&self) -> Table {
        let mut table = self.preset.equipment().table.clone();
        match &mut table {
            Table::Rectangle { width, length, obstacles, nose_height, nose_contact, .. } => {
                (*width, *length) = (self.width.unwrap_or(*width), self.length.unwrap_or(*length));
                obstacles.clone_from(&self.obstacles);
                *nose_height = self.nose_height.or(*nose_height);
                *nose_contact = self.nose_contact.or(*nose_contact);
            }
            Table::PocketTable {
                width,
                length,
                cushion_width,
                corner,
                side,
                obstacles,
                nose_height,
                nose_contact,
            } => {
                (*width, *length) = (self.width.unwrap_or(*width), self.length.unwrap_or(*length));
                *cushion_width = self.cushion_width.unwrap_or(*cushion_width);
                (*corner, *side) = (self.corner.over(*corner), self.side.over(*side));
                obstacles.clone_from(&self.obstacles);
                *nose_height = self.nose_height.or(*nose_height);
                *nose_contact = self.nose_contact.or(*nose_contact);
            }
            // No file of equipment has another shape.
            Table::Circle { .. } | Table::Path { .. } | Table::Preset(_) | Table::Absent => {}
        }
        table
    }
}

impl MouthChange {
    fn over(self, under: MouthShape) -> MouthShape {
        MouthShape {
            width: self.width.unwrap_or(under.width),
            angle_deg: self.angle_deg.unwrap_or(under.angle_deg),
            depth: self.depth.unwrap_or(under.depth),
            radius: self.radius.unwrap_or(under.radius),
            jaw_radius: self.jaw_radius.unwrap_or(under.jaw_radius),
        }
    }
}

impl Physics {
    /// These laws, and where they are absent those of the preset.
    pub(super) fn over(&self, preset: Option<Preset>) -> Self {
        let Some(preset) = preset else { return self.clone() };
        let under = &preset.equipment().physics;
        let mut cushions = under.cushions.clone();
        cushions.extend(self.cushions.clone());
        Self {
            flight: self.flight.clone().or_else(|| under.flight.clone()),
            ball_ball: self.ball_ball.clone().or_else(|| under.ball_ball.clone()),
            ball_cushion: self.ball_cushion.clone().or_else(|| under.ball_cushion.clone()),
            cushions,
            cluster: self.cluster.or(under.cluster),
            collapse: self.collapse.or(under.collapse),
        }
    }
}

impl BallDefaults {
    pub(super) fn over(&self, preset: Option<Preset>) -> Self {
        let Some(preset) = preset else { return self.clone() };
        let under = &preset.equipment().ball_defaults;
        Self {
            radius: self.radius.or(under.radius),
            mass: self.mass.or(under.mass),
            sliding_friction: self.sliding_friction.or(under.sliding_friction),
            rolling_friction: self.rolling_friction.or(under.rolling_friction),
            spin_decay: self.spin_decay.or(under.spin_decay),
            color: self.color.clone().or_else(|| under.color.clone()),
        }
    }
}

impl Cue {
    /// This cue, what is absent from the preset; of one that strikes all the rest from a pool cue.
    pub(super) fn over(&self, preset: Option<Preset>, strikes: bool) -> Self {
        let of_preset = preset.map(|preset| &preset.equipment().cue);
        match (of_preset, strikes) {
            (Some(under), false) => self.upon(under),
            (Some(under), true) => self.upon(under).upon(&Self::POOL),
            (None, false) => self.clone(),
            (None, true) => self.upon(&Self::POOL),
        }
    }

    fn upon(&self, under: &Self) -> Self {
        Self {
            mass: self.mass.or(under.mass),
            tip_radius: self.tip_radius.or(under.tip_radius),
            end_mass: self.end_mass.or(under.end_mass),
            restitution: self.restitution.or(under.restitution),
            miscue_offset: self.miscue_offset.or(under.miscue_offset),
            length: self.length.or(under.length),
            shaft_radius: self.shaft_radius.or(under.shaft_radius),
            butt_radius: self.butt_radius.or(under.butt_radius),
        }
    }
}

impl Units {
    fn over(&self, preset: Option<Preset>) -> Self {
        let Some(preset) = preset else { return self.clone() };
        let under = &preset.equipment().units;
        let either = |own: &Option<String>, under: &Option<String>| own.clone().or_else(|| under.clone());
        Self {
            length: either(&self.length, &under.length),
            time: either(&self.time, &under.time),
            mass: either(&self.mass, &under.mass),
        }
    }
}

/// The balls as written, as far as they could be read, filled in from those of the rack with the same ids; then the rest of
/// the rack.
pub(super) fn with_rack(
    written: &[Option<Ball>],
    rack: Option<&Rack>,
    table: Option<&Table>,
    defaults: &BallDefaults,
    preset: Option<Preset>,
) -> Vec<Option<Ball>> {
    let cue_ball = preset.map(|preset| &preset.equipment().cue_ball);
    let rack = match (rack, table) {
        (Some(rack), Some(table)) => racked(rack, table, defaults, cue_ball),
        _ => Vec::new(),
    };
    let filled = |ball: &Ball| match rack.iter().find(|racked| racked.id == ball.id) {
        Some(racked) => ball.upon(racked),
        None => ball.clone(),
    };
    let is_written = |racked: &Ball| written.iter().flatten().any(|ball| ball.id == racked.id);
    let mut balls: Vec<_> = written.iter().map(|ball| ball.as_ref().map(filled)).collect();
    balls.extend(rack.iter().filter(|racked| !is_written(racked)).cloned().map(Some));
    balls
}

impl Ball {
    fn upon(&self, under: &Self) -> Self {
        Self {
            radius: self.radius.or(under.radius),
            mass: self.mass.or(under.mass),
            position: self.position.or(under.position),
            color: self.color.clone().or_else(|| under.color.clone()),
            ..self.clone()
        }
    }
}
