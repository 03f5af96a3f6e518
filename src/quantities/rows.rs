//! Rows of a take-off: openings, members, edges.

use super::{FrameGroup, FrameMaterial};

/// Windows of one size.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OpeningSize {
    /// How many.
    pub count: u32,
    /// Width in m.
    pub width_m: f64,
    /// Height in m.
    pub height_m: f64,
}

impl OpeningSize {
    /// Area of one in m2.
    pub fn each_m2(&self) -> f64 {
        self.width_m * self.height_m
    }
}

/// Members of one role group, material and section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameQuantity {
    /// Role group.
    pub group: FrameGroup,
    /// Material.
    pub material: FrameMaterial,
    /// Index of the section in the caller's list; named only in [`super::Takeoff::lines`].
    pub section: u16,
    /// Sum of lengths in m.
    pub length_m: f64,
    /// Sum of volumes in m3.
    pub volume_m3: f64,
    /// Sum of masses in kg: the masses that the analysis applies as self weight.
    pub mass_kg: f64,
}

pub(super) const NO_FRAME: FrameQuantity = FrameQuantity {
    group: FrameGroup::Wall,
    material: FrameMaterial::S235,
    section: 0,
    length_m: 0.0,
    volume_m3: 0.0,
    mass_kg: 0.0,
};

/// What stands along the edges of a roof.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RoofEdges {
    /// Roof beyond eaves and verges, m2 of its plane.
    pub overhang_m2: f64,
    /// Gutters, m.
    pub gutter_m: f64,
    /// Parapets, m2 of their outer face above the roof.
    pub parapet_m2: f64,
    /// Copings of parapets and flush edges, m.
    pub coping_m: f64,
}

/// How the edge of a foundation as built differs from the surface of the house.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoundationEdge {
    /// Plinth below the underside of the slab, as deep as the perimeter beam, m2 of its outer face.
    pub plinth_below_m2: f64,
    /// Ground that the plinth and the perimeter beam stand on, where there is no slab, m2.
    pub without_slab_m2: f64,
}

impl FrameQuantity {
    /// Quantity in the billing unit of its material: kg of steel, m3 of timber.
    pub fn billed(&self) -> f64 {
        match self.material {
            FrameMaterial::S235 | FrameMaterial::S355 => self.mass_kg,
            FrameMaterial::C24 | FrameMaterial::GL24h | FrameMaterial::GL28h => self.volume_m3,
        }
    }
}
