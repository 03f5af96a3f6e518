//! Style of an architectural tileset: what a designer chooses; thicknesses come from the build-ups.

use serde::{Deserialize, Serialize};

/// What fills a railing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Railing {
    /// Panes between a base rail and a hand rail.
    Glass,
    /// Upright bars.
    Bars,
}

/// The choices of a style that shape solids. Lengths in µm, multiples of 5.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SolidStyle {
    /// How far a roof reaches over free eaves and verges, measured in plan; 0 to 400 000.
    pub overhang_um: i32,
    /// Depth of the boards that close an overhang, below the covering.
    pub fascia_um: i32,
    /// Whether free eaves carry a gutter.
    pub gutter: bool,
    /// Height of a parapet above a level roof that is not walked on; 0 for a flush edge with a metal trim.
    pub parapet_um: i32,
    /// Height of a railing above its deck.
    pub railing_um: i32,
    /// What fills it.
    pub railing: Railing,
    /// Width of the frame bars of windows and doors.
    pub bar_um: i32,
    /// Depth of the outer face of frames behind the facade.
    pub reveal_um: i32,
}

impl Default for SolidStyle {
    fn default() -> Self {
        SolidStyle {
            overhang_um: 300_000,
            fascia_um: 120_000,
            gutter: true,
            parapet_um: 300_000,
            railing_um: 1_000_000,
            railing: Railing::Glass,
            bar_um: 60_000,
            reveal_um: 100_000,
        }
    }
}
