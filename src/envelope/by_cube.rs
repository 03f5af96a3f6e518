//! The surface of a house cube by cube: what a survey sums up, where it comes from.

use super::measure::module_scale;
use super::{Skin, Surface};
use crate::cubes::{Corner, corner_voxel, scan_keys, scan_masks};
use crate::tiles::solids::Columns;
use crate::tiles::solids::edges::{EdgeTerms, edge_terms};
use crate::tiles::{CUBE_MM, Shells};
use crate::voxels::VoxelArray;

/// A piece of surface in a cube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubePiece {
    /// What it is.
    pub surface: Surface,
    /// The voxel it hangs on.
    pub voxel: [isize; 3],
    /// m2.
    pub area_m2: f64,
}

impl Skin {
    /// Calls `visit(cube, pieces, edges)` for every cube of the padded array that has any surface or edge, x fastest; the sums over all are
    /// those of [`Skin::survey`]. Slower: for reports. `walked` as there.
    pub fn by_cube(
        &self,
        voxels: &VoxelArray,
        walked: impl Fn([usize; 3]) -> bool,
        mut visit: impl FnMut([usize; 3], &[CubePiece], &EdgeTerms),
    ) {
        let mut pieces = Vec::new();
        let piece = |cube, octant: u8, surface, area_m2| {
            let voxel = corner_voxel(cube, Corner::at([octant, octant >> 1, octant >> 2]));
            CubePiece { surface, voxel, area_m2 }
        };
        match self {
            Skin::Tiles(tileset) => {
                let scale = module_scale(voxels, tileset.module_mm());
                scan_masks(voxels, |cube, mask| {
                    pieces.clear();
                    pieces.extend(tileset.patches(mask).iter().map(|patch| {
                        let voxel =
                            corner_voxel(cube, Corner::at([patch.octant, patch.octant >> 1, patch.octant >> 2]));
                        piece(cube, patch.octant, Surface::of(patch.class, voxels.at(voxel)), patch.area_m2(scale))
                    }));
                    if !pieces.is_empty() {
                        visit(cube, &pieces, &EdgeTerms::default());
                    }
                });
            }
            Skin::Keys(surface) => {
                let scale = module_scale(voxels, CUBE_MM);
                let bare = Shells::default();
                scan_keys(voxels, surface.rule, walked, |cube, key| {
                    pieces.clear();
                    let patches = surface.patches(key);
                    pieces.extend(patches.iter().map(|(p, what)| piece(cube, p.octant, *what, p.area_m2(scale))));
                    let edges = surface.edges.as_ref().map(|style| edge_terms(&Columns::new(key, &bare), style, scale));
                    let edges = edges.unwrap_or_default();
                    if !pieces.is_empty() || edges != EdgeTerms::default() {
                        visit(cube, &pieces, &edges);
                    }
                });
            }
        }
    }
}
