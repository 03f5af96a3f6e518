//! Patches: the pieces of a tile's surface, each hanging on one octant.

use super::polygon::{doubled_area, triangulate};
use crate::cubes::{Corner, Symmetry};
use crate::voxels::Direction;

/// What a piece of surface is, before the label of its octant says what it is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PatchKind {
    /// Upper side of a column filled below only.
    Roof,
    /// Vertical.
    Wall,
    /// Lower side of a column filled above only.
    Soffit,
    /// Level upper side of a slab.
    Deck,
}

impl PatchKind {
    /// All kinds in the order of their declaration.
    pub const ALL: [PatchKind; 4] = [PatchKind::Roof, PatchKind::Wall, PatchKind::Soffit, PatchKind::Deck];

    /// Group name in the tile's OBJ file.
    pub fn name(self) -> &'static str {
        match self {
            PatchKind::Roof => "roof",
            PatchKind::Wall => "wall",
            PatchKind::Soffit => "soffit",
            PatchKind::Deck => "deck",
        }
    }
}

/// A polygon of a tile as constructed or read: cube-local integer mm, counter-clockwise seen from outside.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Facet {
    /// What it is.
    pub kind: PatchKind,
    /// The octant (0..8) whose label it takes.
    pub octant: u8,
    /// At least three points; points inside a straight edge are kept, so that neighbours weld.
    pub polygon: Vec<[i32; 3]>,
}

impl Facet {
    /// The facet of the tile placed with `symmetry` in a cube of `size` mm. Mirrored polygons are turned over.
    pub fn placed(&self, symmetry: Symmetry, size: [i32; 3]) -> Facet {
        let mut polygon: Vec<[i32; 3]> = self.polygon.iter().map(|&p| symmetry.point(p, size)).collect();
        if symmetry.mirror {
            polygon.reverse();
        }
        let octant = Corner::new(self.octant).map_or(self.octant, |c| symmetry.corner(c).number());
        Facet { kind: self.kind, octant, polygon }
    }

    /// The same facet beginning with its smallest point, so that equal facets compare equal.
    pub fn normalised(mut self) -> Facet {
        let first = (0..self.polygon.len()).min_by_key(|&i| self.polygon[i]).unwrap_or(0);
        self.polygon.rotate_left(first);
        self
    }
}

/// Kind and direction of a patch together: all that its octant's label must be combined with to know the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum PatchClass {
    /// Wall facing +x.
    WallEast = 0,
    /// Wall facing +y.
    WallNorth = 1,
    /// Wall facing -x.
    WallWest = 2,
    /// Wall facing -y.
    WallSouth = 3,
    /// Roof with a level surface.
    RoofLevel = 4,
    /// Roof with an inclined surface.
    RoofInclined = 5,
    /// Deck.
    Deck = 6,
    /// Underside.
    Soffit = 7,
}

impl PatchClass {
    /// Number of classes.
    pub const COUNT: usize = 8;

    /// The direction a wall faces; `None` for anything else.
    pub fn facing(self) -> Option<Direction> {
        Direction::ALL.get(self as usize).copied()
    }

    /// The class of a kind with a normal (any length).
    fn of(kind: PatchKind, [x, y, z]: [i64; 3]) -> PatchClass {
        match kind {
            PatchKind::Roof if x == 0 && y == 0 && z > 0 => PatchClass::RoofLevel,
            PatchKind::Roof => PatchClass::RoofInclined,
            PatchKind::Deck => PatchClass::Deck,
            PatchKind::Soffit => PatchClass::Soffit,
            PatchKind::Wall if x.abs() >= y.abs() && x > 0 => PatchClass::WallEast,
            PatchKind::Wall if x.abs() >= y.abs() => PatchClass::WallWest,
            PatchKind::Wall if y > 0 => PatchClass::WallNorth,
            PatchKind::Wall => PatchClass::WallSouth,
        }
    }
}

/// A facet with everything the envelope asks of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// What it is.
    pub kind: PatchKind,
    /// The octant (0..8) whose label it takes.
    pub octant: u8,
    /// Kind and direction.
    pub class: PatchClass,
    /// Cube-local integer mm, counter-clockwise seen from outside.
    pub polygon: Vec<[i32; 3]>,
    /// Indices into `polygon`, no triangle degenerate, same orientation.
    pub triangles: Vec<[u8; 3]>,
    /// Twice the vector area, mm2, pointing outwards.
    pub doubled_area_mm2: [i64; 3],
    /// Six times the integral of z n_z over the patch, mm3 (z from the cube's bottom plane).
    pub moment_mm3: i64,
}

impl Patch {
    /// Measures a facet; `None` when it cannot be cut into triangles (it crosses itself or has no area).
    pub fn new(facet: Facet) -> Option<Patch> {
        let triangles = triangulate(&facet.polygon)?;
        let area = doubled_area(&facet.polygon);
        let moment_mm3 = triangles
            .iter()
            .map(|t| {
                let corners = t.map(|i| facet.polygon[i as usize]);
                corners.iter().map(|p| i64::from(p[2])).sum::<i64>() * doubled_area(&corners)[2]
            })
            .sum();
        Some(Patch {
            kind: facet.kind,
            octant: facet.octant,
            class: PatchClass::of(facet.kind, area),
            polygon: facet.polygon,
            triangles,
            doubled_area_mm2: area,
            moment_mm3,
        })
    }

    /// Area in m2 when every mm along axis a of the cube is drawn `scale[a]` mm long ([1, 1, 1] for the tile as made).
    pub fn area_m2(&self, scale: [f64; 3]) -> f64 {
        let [x, y, z] = self.doubled_area_mm2.map(|c| c as f64);
        let [sx, sy, sz] = scale;
        0.5e-6 * (x * sy * sz).hypot(y * sx * sz).hypot(z * sx * sy)
    }

    /// Unit normal, outwards.
    pub fn normal(&self) -> [f64; 3] {
        let n = self.doubled_area_mm2.map(|c| c as f64);
        let length = n[0].hypot(n[1]).hypot(n[2]);
        n.map(|c| c / length)
    }

    /// The facet it was made from.
    pub fn facet(&self) -> Facet {
        Facet { kind: self.kind, octant: self.octant, polygon: self.polygon.clone() }
    }
}
