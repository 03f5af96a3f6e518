//! Styles: the few numbers from which the whole of a surface tileset follows.

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
    /// Height of an underside above the empty voxel's centre, mm (270 to 540).
    pub underside_mm: i32,
}

impl Style {
    /// The exact boundary of the voxels.
    pub const SURFACE_1: Style = Style {
        name: "surface-1",
        description: "Plain offset: the exact boundary of the voxels.",
        eaves: 1,
        wall_foot: 1,
        underside_mm: HALF_RISE_MM,
    };
    /// Roofs sloped by one module of height per module of plan; floors raised to 180 mm below the voxel centre above.
    pub const SURFACE_2: Style = Style {
        name: "surface-2",
        description: "Sloped roofs (540 : 900), undersides raised to 180 mm below the slab top.",
        eaves: 0,
        wall_foot: 2,
        underside_mm: 360,
    };
    /// Surface 2 with undersides in the plane of the slab tops: what the linear tiles are derived from.
    pub const LINEAR: Style = Style {
        name: "linear",
        description: "Skeleton lines: studs, posts, rails, joists and roof members of every configuration.",
        eaves: 0,
        wall_foot: 2,
        underside_mm: 2 * HALF_RISE_MM,
    };
}
