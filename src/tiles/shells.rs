//! Shells: the strata from which solids are made, taken from the build-ups that are priced and weighed.

use super::Component;

/// One stratum: a component and its thickness in micrometres.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Stratum {
    /// What it is.
    pub component: Component,
    /// Thickness across the stratum, µm; a multiple of 5, so that heights on a 3 : 5 slope are whole.
    pub thickness_um: i32,
}

/// Strata from the outside to the inside, or from top to bottom.
pub type Stack = Vec<Stratum>;

/// Sum of the thicknesses of a stack, µm.
pub fn depth_um(stack: &[Stratum]) -> i32 {
    stack.iter().map(|s| s.thickness_um).sum()
}

/// The strata of every kind of surface. Built from the build-ups of a project (`price`), so that drawing, take-off and self weight
/// read the same thicknesses; films thinner than half a millimetre are counted with their neighbour.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Shells {
    /// Outer wall from its face inwards (cladding, insulation, lining). At most 350 mm in all.
    pub wall: Stack,
    /// Pitched roof outside the roof plane, from top to bottom (covering).
    pub roof_cover: Stack,
    /// Pitched roof from the roof plane inwards (insulation, lining), measured across the slope.
    pub roof: Stack,
    /// Level roof that is not walked on, from its surface down to the top of the floor structure (membrane, insulation).
    pub flat: Stack,
    /// Deck that is walked on, from its surface down to the top of the floor structure (boards, insulation).
    pub deck: Stack,
    /// Floor from the slab top down (boards, structure, ceiling): the slab zone.
    pub floor: Stack,
    /// Below a floor that stands over the outside, from the floor's underside down (insulation, boards).
    pub soffit: Stack,
    /// Foundation from the slab top down (slab, insulation).
    pub ground: Stack,
    /// Edge of the foundation from its face inwards (render, insulation); the perimeter beam follows.
    pub plinth: Stack,
    /// Perimeter beam: width inwards from the plinth strata's inner face, and depth below the slab top, µm.
    pub beam_um: [i32; 2],
}
