//! Where a house stands, what its build-ups weigh, and what may be wrong with either.

use serde::Deserialize;
use thiserror::Error;

use super::super::catalogue::CatalogueError;

/// National annex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
pub enum Annex {
    /// Recommended values.
    #[default]
    #[serde(rename = "EN")]
    En,
    /// The Netherlands.
    #[serde(rename = "NL")]
    Nl,
}

impl Annex {
    /// Its key in `loads.json`.
    pub fn key(self) -> &'static str {
        match self {
            Annex::En => "EN",
            Annex::Nl => "NL",
        }
    }
}

/// Where the house stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// Basic wind velocity, m/s.
    pub vb0_m_s: f64,
    /// Terrain category of EN 1991-1-4 Table 4.1: 0, I, II, III or IV.
    pub terrain: String,
    /// Snow on the ground, kN/m2.
    pub sk_kn_m2: f64,
    /// National annex.
    pub annex: Annex,
}

/// Acceleration that turns every mass into a weight, m/s2.
pub const FREE_FALL_M_S2: f64 = 9.81;

/// Self weight of the build-ups without the frame, kN/m2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceWeights {
    /// By `Surface as usize` of the envelope: wall, band, plinth, window, door, pitched roof, flat roof, deck, soffit, ground.
    pub surface_kn_m2: [f64; 10],
    /// Inside floors, without partitions.
    pub floor_kn_m2: f64,
    /// Wall with boards on both sides, kN/m2.
    pub wall_both_kn_m2: f64,
}

impl Default for SurfaceWeights {
    /// Timber-framed house: boards, insulation, wood cladding; tiles on the roof (EN 1991-1-1 and build-ups of our layers).
    fn default() -> Self {
        SurfaceWeights {
            surface_kn_m2: [0.40, 0.40, 0.40, 0.35, 0.35, 0.60, 0.45, 0.60, 0.30, 0.0],
            floor_kn_m2: 0.70,
            wall_both_kn_m2: 0.49,
        }
    }
}

/// Why loads cannot be made.
#[derive(Debug, Error)]
pub enum LoadError {
    /// A terrain that is not in the table.
    #[error("site.terrain is `{0}`; it must be 0, I, II, III or IV")]
    Terrain(String),
    /// A number out of range.
    #[error("site.{key} is {value}; it must lie between {least} and {most}")]
    Range {
        /// The key.
        key: &'static str,
        /// As given.
        value: f64,
        /// Smallest allowed.
        least: f64,
        /// Largest allowed.
        most: f64,
    },
    /// A table of `loads.json` that is not of its form.
    #[error("loads.json: `{key}` must be {expected}")]
    Table {
        /// The key.
        key: &'static str,
        /// What it must be.
        expected: &'static str,
    },
    /// The data file.
    #[error(transparent)]
    File(#[from] CatalogueError),
}
