//! Styles: the few numbers from which the whole of a surface tileset follows.

use super::{Shells, Stratum, depth_um};

/// Edge of a half module in plan, mm.
pub const HALF_PLAN_MM: i32 = 450;
/// Half of a module's height, mm.
pub const HALF_RISE_MM: i32 = 270;
/// The cube in which tiles are made, mm: the default module.
pub const CUBE_MM: [i32; 3] = [2 * HALF_PLAN_MM, 2 * HALF_PLAN_MM, 2 * HALF_RISE_MM];

/// Where surfaces cross the edges of a cube.
///
/// ```text
///  eaves 0, wall foot 2 (sloped)        eaves 1, wall foot 1 (plain offset)
///        F|                                   F|
///         |\                                   |
///         | \__ centre of a roof voxel         |____
///         |    \                               |    |
///         |     \__ eaves                      |    |
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// Name of the tileset.
    pub name: &'static str,
    /// One sentence for the manifest.
    pub description: &'static str,
    /// Height of a roof half-way to an empty column, in half modules (0 to 2).
    pub eaves: i32,
    /// Height of a roof half-way to a full column, in half modules (0 to 2).
    pub wall_foot: i32,
    /// Height of an underside above the empty voxel's centre, mm (1 to 540).
    pub underside_mm: i32,
    /// The same under a foundation, mm (1 to 540): a thicker slab with its insulation.
    pub ground_underside_mm: i32,
    /// Whether a slab with nothing above is a deck, level in the cube's bottom plane, and no roof. Read from labels only.
    pub decks: bool,
    /// How far walls stand outside the voxels, mm: 0 to 449, less than half a module. With an offset of either kind roofs, decks and
    /// undersides are level, all at one height: the heights above and face numbers are not read.
    pub wall_offset_mm: i32,
    /// How far level roofs and undersides lie above half a cube, mm: -269 to 269.
    pub roof_offset_mm: i32,
}

impl Style {
    /// The exact boundary of the voxels.
    pub const SURFACE_1: Style = Style {
        name: "surface-1",
        description: "Plain offset: the exact boundary of the voxels.",
        eaves: 1,
        wall_foot: 1,
        underside_mm: HALF_RISE_MM,
        ground_underside_mm: HALF_RISE_MM,
        decks: false,
        wall_offset_mm: 0,
        roof_offset_mm: 0,
    };
    /// As the thesis's author modelled it: walls one stair tread from the empty voxel's centre, level roofs two risers up in the cube.
    pub const SURFACE_1_OFFSET: Style = Style {
        name: "surface-1-offset",
        description: "Walls 150 mm outside the voxels, level roofs and undersides 90 mm above half a cube.",
        wall_offset_mm: 150,
        roof_offset_mm: 90,
        ..Style::SURFACE_1
    };
    /// Roofs sloped by one module of height per module of plan; floors raised to 180 mm below the voxel centre above.
    pub const SURFACE_2: Style = Style {
        name: "surface-2",
        description: "Sloped roofs (540 : 900), undersides raised to 180 mm below the slab top.",
        eaves: 0,
        wall_foot: 2,
        underside_mm: 360,
        ground_underside_mm: 360,
        decks: false,
        wall_offset_mm: 0,
        roof_offset_mm: 0,
    };
    /// Surface 2 with undersides in the plane of the slab tops: what the linear tiles are derived from.
    pub const LINEAR: Style = Style {
        name: "linear",
        description: "Skeleton lines: studs, posts, rails, joists and roof members of every configuration.",
        eaves: 0,
        wall_foot: 2,
        underside_mm: 2 * HALF_RISE_MM,
        ground_underside_mm: 2 * HALF_RISE_MM,
        decks: false,
        wall_offset_mm: 0,
        roof_offset_mm: 0,
    };

    /// Whether surfaces stand off the voxels.
    pub fn is_offset(&self) -> bool {
        (self.wall_offset_mm, self.roof_offset_mm) != (0, 0)
    }

    /// The surface of architectural tiles: the outer face of the walls, the roof planes, the slab tops of decks, and undersides at the
    /// depth of what the shells hang below the slab top (floor and soffit, or the foundation), to whole millimetres.
    pub fn architectural(shells: &Shells) -> Style {
        let underside = |stacks: &[&[Stratum]]| {
            let depth_um: i32 = stacks.iter().map(|stack| depth_um(stack)).sum();
            (CUBE_MM[2] - (depth_um + 500) / 1000).clamp(1, CUBE_MM[2])
        };
        Style {
            name: "architectural",
            description: "Outer faces of the architectural tiles: sloped roofs, level decks, undersides by what hangs below the slab.",
            eaves: 0,
            wall_foot: 2,
            underside_mm: underside(&[&shells.floor, &shells.soffit]),
            ground_underside_mm: underside(&[&shells.ground]),
            decks: true,
            wall_offset_mm: 0,
            roof_offset_mm: 0,
        }
    }
}
