//! What a part is.

use crate::voxels::{Direction, LINING_M, Label};

/// Number of a part in [`Parts::parts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PartId(pub u32);

/// Kinds of parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum PartKind {
    /// Storey-high wall panel with its band; gables and knee walls under a roof too.
    Wall = 0,
    /// Cassette of an inner floor, with the soffit where it projects.
    Floor = 1,
    /// Cassette of a deck or flat roof: slab with nothing above.
    Deck = 2,
    /// Cassette of a roof slope.
    Slope = 3,
    /// Cassette of a level roof over base voxels: plateau, flat ridge.
    Level = 4,
    /// Window.
    Window = 5,
    /// Outer door.
    Door = 6,
    /// Stair of one storey.
    Stair = 7,
}

impl PartKind {
    /// All kinds in storage order.
    pub const ALL: [PartKind; 8] = [
        PartKind::Wall,
        PartKind::Floor,
        PartKind::Deck,
        PartKind::Slope,
        PartKind::Level,
        PartKind::Window,
        PartKind::Door,
        PartKind::Stair,
    ];

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            PartKind::Wall => "wall_panel",
            PartKind::Floor => "floor_cassette",
            PartKind::Deck => "deck_cassette",
            PartKind::Slope => "roof_cassette",
            PartKind::Level => "level_roof_cassette",
            PartKind::Window => "window",
            PartKind::Door => "door",
            PartKind::Stair => "stair",
        }
    }

    /// Whether it is a panel or cassette: made of cells, with a mass from a build-up.
    pub fn is_flat(self) -> bool {
        (self as usize) < PartKind::Window as usize
    }
}

/// What limits a part, and the thickness that corners need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Longest panel or cassette, m.
    pub longest_m: f64,
    /// Widest cassette, m.
    pub widest_m: f64,
    /// Thickness of outer walls, mm: what panels lose or gain at corners and floors lose at walls.
    pub wall_mm: f64,
    /// Whether openings that stand on a slab begin at its top, as solids are built; else at their voxel's lower side, as surfaces are
    /// drawn.
    pub from_slab: bool,
}

impl Default for Settings {
    /// 12 x 2.5 m (HOUSE definitions: what a truck carries), walls of 300 mm, openings as solids are built.
    fn default() -> Self {
        Settings { longest_m: 12.0, widest_m: 2.5, wall_mm: LINING_M * 1000.0, from_slab: true }
    }
}

/// A cell of a panel or cassette.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PartCell {
    /// Plan cell.
    pub cell: [u16; 2],
    /// Voxel layer: the plate of walls, floors and decks, the top voxel of roofs.
    pub k: u16,
    /// What of the cell belongs to the part. Walls: bit h is half module h above the slab. Floors: 1 inner, 2 over the outside. Decks:
    /// 3 roof, 4 walked on. Roofs: two bits a quarter x + 2y, seen along the part: 1 whole, 2 the triangle at the middle of the side
    /// it falls to or from, 3 the other triangle. Level roofs: as for a part along its axis.
    pub code: u16,
}

/// An opening in a wall panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PanelOpening {
    /// Window or opening.
    pub label: Label,
    /// Modules from the panel's first module line, seen from outside from left to right.
    pub from: u16,
    /// Modules wide.
    pub width: u16,
    /// Half modules from the slab top to the lower edge, in the lowest column; 0 for what stands on the slab.
    pub sill: u16,
    /// Modules high by its voxels.
    pub height: u16,
    /// How many of its columns reach half a module further down, to the slab's top.
    pub to_slab: u16,
    /// Which opening of the reading it is.
    pub index: u16,
}

impl PanelOpening {
    /// Height as built, modules; the mean over its columns where the lower edge steps.
    pub fn height_modules(&self) -> f64 {
        height_modules(self.width, self.height, self.to_slab)
    }
}

/// Mean height of an opening `width` columns wide, `height` modules high, of whose columns `to_slab` are half a module higher.
pub(super) fn height_modules(width: u16, height: u16, to_slab: u16) -> f64 {
    f64::from(height) + 0.5 * f64::from(to_slab) / f64::from(width.max(1))
}

/// A part. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// What it is.
    pub kind: PartKind,
    /// Plate it stands on or lies in: 0 = foundation.
    pub level: u16,
    /// Outward normal of walls, windows and doors; the direction that slopes fall to; the run of stairs.
    pub facing: Option<Direction>,
    /// Axis of its length: 0 = x, 1 = y.
    pub axis: u8,
    /// Smallest plan cell.
    pub first: [u16; 2],
    /// Modules along its length; across it for cassettes, half modules high for walls.
    pub modules: [u16; 2],
    /// Length: along the facade, the joists or the slope.
    pub length_mm: f64,
    /// Width of cassettes, thickness of walls and openings (0 where the product decides).
    pub width_mm: f64,
    /// Height of walls and openings, rise of stairs; 0 for cassettes, whose build-up decides.
    pub height_mm: f64,
    /// Surface without openings, m2, by the part's own outline.
    pub area_m2: f64,
    /// Range of [`Parts::cells`].
    pub cells: [u32; 2],
    /// Range of [`Parts::openings`].
    pub openings: [u32; 2],
    /// Range of the congruence keys.
    pub(super) key: [u32; 2],
    /// Whether the canonical form is the mirror image of this part.
    pub(super) mirrored: bool,
}

/// A house cut into parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parts {
    /// All parts: walls level by level, floors and decks, roofs, windows, doors, stairs.
    pub parts: Vec<Part>,
    /// Cells of all panels and cassettes.
    pub cells: Vec<PartCell>,
    /// Openings of all panels.
    pub openings: Vec<PanelOpening>,
    pub(super) keys: Vec<u64>,
    /// Edges of the module, m.
    pub module_m: [f64; 3],
    /// Centre of voxel (0, 0, 0), m.
    pub origin_m: [f64; 3],
    /// Wall thickness used, mm.
    pub wall_mm: f64,
    /// Axis along which walls run through at corners: 0 = x, 1 = y.
    pub through_axis: u8,
    /// Deck on the foundation, m2: site work.
    pub site_deck_m2: f64,
}

impl Parts {
    /// The cells of a part.
    pub fn cells_of(&self, part: &Part) -> &[PartCell] {
        &self.cells[part.cells[0] as usize..part.cells[1] as usize]
    }

    /// The openings of a part.
    pub fn openings_of(&self, part: &Part) -> &[PanelOpening] {
        &self.openings[part.openings[0] as usize..part.openings[1] as usize]
    }

    /// The congruence key of a part.
    pub(super) fn key_of(&self, part: &Part) -> &[u64] {
        &self.keys[part.key[0] as usize..part.key[1] as usize]
    }

    /// Number of parts of a kind.
    pub fn count(&self, kind: PartKind) -> usize {
        self.parts.iter().filter(|p| p.kind == kind).count()
    }

    /// A part by its number.
    pub fn get(&self, id: PartId) -> Option<&Part> {
        self.parts.get(id.0 as usize)
    }
}
