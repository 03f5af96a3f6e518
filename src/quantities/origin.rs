//! Where the rows of a take-off come from: the cubes, openings, cells and members that sum to each.

use serde::Serialize;

use super::{Item, Unit};

/// What a quantity was measured on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum OriginKind {
    /// The tile in a cube of the padded array; id `i,j,k`.
    Tile,
    /// An edge of roof or deck in a cube; id `i,j,k`.
    TileEdge,
    /// A window or door; id its number in the house's list of openings.
    Opening,
    /// A floor plate, for what is measured on its outline; id its voxel layer.
    Plate,
    /// A stair; id its number in the house's list.
    Stair,
    /// A member of the frame; id the number of the stick, as in structure.json.
    Member,
}

impl OriginKind {
    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            OriginKind::Tile => "tile",
            OriginKind::TileEdge => "tile edge",
            OriginKind::Opening => "opening",
            OriginKind::Plate => "plate",
            OriginKind::Stair => "stair",
            OriginKind::Member => "member",
        }
    }
}

/// A part of a row.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Origin {
    /// What it was measured on.
    pub kind: OriginKind,
    /// Which one.
    pub id: String,
    /// Its part of the row's quantity; below 0 for what is taken off, as the slab under the perimeter beam.
    pub quantity: f64,
}

impl Origin {
    /// The number of a member or a stair; `None` for what is told apart otherwise.
    pub fn number(&self) -> Option<usize> {
        matches!(self.kind, OriginKind::Member | OriginKind::Stair).then(|| self.id.parse().ok()).flatten()
    }
}

/// A row of the take-off with its origins.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OriginRow {
    /// Line of the bill, from 1.
    pub line: usize,
    /// Item.
    #[serde(serialize_with = "item_id")]
    pub item: Item,
    /// Which part of it.
    pub description: String,
    /// Measured quantity.
    pub quantity: f64,
    /// Unit of the quantities.
    pub unit: Unit,
    /// What sums to it, no origin twice.
    pub origins: Vec<Origin>,
}

impl OriginRow {
    /// Sum of the origins less the row's quantity.
    pub fn difference(&self) -> f64 {
        self.origins.iter().map(|o| o.quantity).sum::<f64>() - self.quantity
    }
}

fn item_id<S: serde::Serializer>(item: &Item, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(item.id())
}
