//! Units of quantities and rates.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Unit of a quantity or of a rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Unit {
    /// Square metre.
    #[serde(rename = "m2")]
    SquareMetre,
    /// Square metre and centimetre of thickness.
    #[serde(rename = "m2.cm")]
    SquareMetreCentimetre,
    /// Cubic metre.
    #[serde(rename = "m3")]
    CubicMetre,
    /// Metre.
    #[serde(rename = "m")]
    Metre,
    /// Kilogram.
    #[serde(rename = "kg")]
    Kilogram,
    /// Piece.
    #[serde(rename = "piece")]
    Piece,
    /// Hour of work.
    #[serde(rename = "h")]
    Hour,
    /// Working day.
    #[serde(rename = "day")]
    Day,
    /// Kilometre of road.
    #[serde(rename = "km")]
    Kilometre,
    /// Share of a sum: its rate is the sum.
    #[serde(rename = "share")]
    Share,
}

impl Unit {
    /// The unit as it is written in files.
    pub fn name(self) -> &'static str {
        match self {
            Unit::SquareMetre => "m2",
            Unit::SquareMetreCentimetre => "m2.cm",
            Unit::CubicMetre => "m3",
            Unit::Metre => "m",
            Unit::Kilogram => "kg",
            Unit::Piece => "piece",
            Unit::Hour => "h",
            Unit::Day => "day",
            Unit::Kilometre => "km",
            Unit::Share => "share",
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
