//! Placing tiles and welding them: equal corners of neighbouring tiles become one vertex.

use super::measure::module_scale;
use super::{EnvelopeError, Mesh, Surface};
use crate::cubes::{Corner, corner_voxel, scan_masks};
use crate::tiles::Tileset;
use crate::voxels::VoxelArray;
use rustc_hash::FxHashMap;

/// The welded envelope of a house, in metres at the array's origin.
///
/// Corners are welded by their exact integer position, so the mesh of a rule-respecting array is closed and oriented whenever the
/// tileset's seams are (`check_tileset`). Vertices are numbered in the order of first use: same array, same bytes.
/// Errs with the first cube that has no tile.
pub fn mesh(voxels: &VoxelArray, tileset: &Tileset) -> Result<Mesh, EnvelopeError> {
    let size = tileset.module_mm();
    let scale = module_scale(voxels, tileset);
    let mut mesh = Mesh::default();
    let mut known: FxHashMap<[i32; 3], u32> = FxHashMap::default();
    let mut inadmissible = None;
    scan_masks(voxels, |cube, mask| {
        if !mask.is_admissible() {
            inadmissible = inadmissible.or(Some((cube, mask)));
            return;
        }
        for patch in tileset.patches(mask) {
            let corner = Corner::at([patch.octant, patch.octant >> 1, patch.octant >> 2]);
            let surface = Surface::of(patch.class, voxels.at(corner_voxel(cube, corner)));
            for triangle in &patch.triangles {
                mesh.triangles.push(triangle.map(|i| {
                    let local = patch.polygon[i as usize];
                    let at = [0, 1, 2].map(|a| (cube[a] as i32 - 1) * size[a] + local[a]);
                    *known.entry(at).or_insert_with(|| {
                        let metres = |a: usize| voxels.origin_m[a] + f64::from(at[a]) * scale[a] / 1000.0;
                        mesh.vertices.push([0, 1, 2].map(metres));
                        (mesh.vertices.len() - 1) as u32
                    })
                }));
                mesh.surfaces.push(surface);
            }
        }
    });
    match inadmissible {
        Some((cube, mask)) => Err(EnvelopeError::inadmissible(voxels, cube, mask)),
        None => Ok(mesh),
    }
}
