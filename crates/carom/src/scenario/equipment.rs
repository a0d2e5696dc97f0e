//! Tables that come with carom: the files of `crates/carom/equipment`, each with its balls, its cue and its laws.

use super::schema::{BallDefaults, Cue, Physics, Preset, Table, Units};
use serde::Deserialize;
use std::sync::LazyLock;

/// What a preset stands for.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Equipment {
    /// A short title.
    pub title: String,
    /// The units that its numbers have.
    pub units: Units,
    /// The table.
    pub table: Table,
    /// What its balls have in common.
    pub ball_defaults: BallDefaults,
    /// What is different about the cue ball of a rack.
    #[serde(default)]
    pub cue_ball: BallDefaults,
    /// The cue that goes with it.
    pub cue: Cue,
    /// The laws.
    pub physics: Physics,
}

/// Every preset with the text of its file.
const FILES: [(Preset, &str); 10] = [
    (Preset::Pool9ft, include_str!("../../equipment/pool_9ft.toml")),
    (Preset::Pool8ft, include_str!("../../equipment/pool_8ft.toml")),
    (Preset::Pool8ftHome, include_str!("../../equipment/pool_8ft_home.toml")),
    (Preset::Pool7ft, include_str!("../../equipment/pool_7ft.toml")),
    (Preset::Snooker12ft, include_str!("../../equipment/snooker_12ft.toml")),
    (Preset::Carom10ft, include_str!("../../equipment/carom_10ft.toml")),
    (Preset::EnglishPool, include_str!("../../equipment/english_pool.toml")),
    (Preset::Pooltool7ft, include_str!("../../equipment/pooltool_7ft.toml")),
    (Preset::PooltoolSnooker, include_str!("../../equipment/pooltool_snooker.toml")),
    (Preset::PooltoolCarom, include_str!("../../equipment/pooltool_carom.toml")),
];

static EQUIPMENT: LazyLock<Vec<Equipment>> = LazyLock::new(|| {
    #[expect(
        clippy::expect_used,
        reason = "the files are part of the program, and a test reads each of them"
    )]
    let read =
        |(_, text): &(Preset, &str)| toml::from_str(text).expect("a file of equipment that can be read");
    FILES.iter().map(read).collect()
});

impl Preset {
    /// All presets, in the order of the schema.
    pub const ALL: [Self; FILES.len()] = {
        let mut all = [Self::Pool9ft; FILES.len()];
        let mut place = 0;
        while place < FILES.len() {
            all[place] = FILES[place].0;
            place += 1;
        }
        all
    };

    /// The name that a scenario uses.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pool9ft => "pool_9ft",
            Self::Pool8ft => "pool_8ft",
            Self::Pool8ftHome => "pool_8ft_home",
            Self::Pool7ft => "pool_7ft",
            Self::Snooker12ft => "snooker_12ft",
            Self::Carom10ft => "carom_10ft",
            Self::EnglishPool => "english_pool",
            Self::Pooltool7ft => "pooltool_7ft",
            Self::PooltoolSnooker => "pooltool_snooker",
            Self::PooltoolCarom => "pooltool_carom",
        }
    }

    /// A short title.
    pub fn title(self) -> &'static str {
        &self.equipment().title
    }

    /// Table, balls, cue and laws.
    pub fn equipment(self) -> &'static Equipment {
        &EQUIPMENT[self as usize]
    }
}
