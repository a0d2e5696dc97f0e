//! `preset`: tables that come with carom.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A table that comes with carom, with its balls, its cue and its laws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Preset {
    /// A pool table of 9 feet, as the World Pool Association has it.
    #[serde(rename = "pool_9ft")]
    Pool9ft,
    /// A pool table of 8 feet for players, as the World Pool Association has it.
    #[serde(rename = "pool_8ft")]
    Pool8ft,
    /// A pool table of 8 feet for the home.
    #[serde(rename = "pool_8ft_home")]
    Pool8ftHome,
    /// A pool table of 7 feet, as it stands in bars.
    #[serde(rename = "pool_7ft")]
    Pool7ft,
    /// A full-size snooker table.
    #[serde(rename = "snooker_12ft")]
    Snooker12ft,
    /// A carom table without pockets, as the Union Mondiale de Billard has it.
    #[serde(rename = "carom_10ft")]
    Carom10ft,
    /// A table of English eight-ball pool, whose cue ball is smaller than the others.
    #[serde(rename = "english_pool")]
    EnglishPool,
    /// pooltool's default: its 7-foot pool table, parameters and laws.
    #[serde(rename = "pooltool_7ft")]
    Pooltool7ft,
    /// pooltool's snooker table, parameters and laws.
    #[serde(rename = "pooltool_snooker")]
    PooltoolSnooker,
    /// pooltool's carom table, parameters and laws.
    #[serde(rename = "pooltool_carom")]
    PooltoolCarom,
}
