//! Placing tiles and welding them: equal corners of neighbouring tiles become one vertex.

use super::measure::module_scale;
use super::{EnvelopeError, KeyedSurface, Mesh, Surface};
use crate::cubes::{Corner, CubeKey, Mask, corner_voxel, scan_keys, scan_masks};
use crate::tiles::{CUBE_MM, Patch, Tileset};
use crate::voxels::VoxelArray;
use rustc_hash::FxHashMap;

/// The welded envelope of a house, in metres at the array's origin.
///
/// Corners are welded by their exact integer position, so the mesh of a rule-respecting array is closed and oriented whenever the
/// tileset's seams are (`check_tileset`). Vertices are numbered in the order of first use: same array, same bytes.
/// Errs with the first cube that has no tile.
pub fn mesh(voxels: &VoxelArray, tileset: &Tileset) -> Result<Mesh, EnvelopeError> {
    let mut weld = Weld::new(voxels, tileset.module_mm());
    let mut inadmissible = None;
    scan_masks(voxels, |cube, mask| {
        if !mask.is_admissible() {
            inadmissible = inadmissible.or(Some((cube, mask)));
            return;
        }
        for patch in tileset.patches(mask) {
            let corner = Corner::at([patch.octant, patch.octant >> 1, patch.octant >> 2]);
            weld.place(cube, patch, Surface::of(patch.class, voxels.at(corner_voxel(cube, corner))));
        }
    });
    weld.finish(inadmissible)
}

/// The welded envelope of a house whose surface is constructed from keys; as [`mesh`] otherwise. Closed and oriented for every array
/// of admissible cubes; where base and slab voxels touch in an edge, four triangles may meet there.
pub fn mesh_keys(voxels: &VoxelArray, surface: &KeyedSurface) -> Result<Mesh, EnvelopeError> {
    let mut weld = Weld::new(voxels, CUBE_MM);
    let mut inadmissible = None;
    let mut tiles: FxHashMap<CubeKey, Vec<(Patch, Surface)>> = FxHashMap::default();
    // Which decks are walked on changes no surface.
    scan_keys(
        voxels,
        surface.rule,
        |_| false,
        |cube, key| {
            let mask = key.mask();
            if !mask.is_allowed() {
                inadmissible = inadmissible.or(Some((cube, mask)));
                return;
            }
            for (patch, what) in tiles.entry(key).or_insert_with(|| surface.patches(key)) {
                weld.place(cube, patch, *what);
            }
        },
    );
    weld.finish(inadmissible)
}

/// A mesh under way with the vertices it has.
struct Weld<'a> {
    voxels: &'a VoxelArray,
    size: [i32; 3],
    scale: [f64; 3],
    mesh: Mesh,
    known: FxHashMap<[i32; 3], u32>,
}

impl Weld<'_> {
    fn new(voxels: &VoxelArray, size: [i32; 3]) -> Weld<'_> {
        Weld { voxels, size, scale: module_scale(voxels, size), mesh: Mesh::default(), known: FxHashMap::default() }
    }

    fn place(&mut self, cube: [usize; 3], patch: &Patch, surface: Surface) {
        let Weld { voxels, size, scale, mesh, known } = self;
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

    fn finish(self, inadmissible: Option<([usize; 3], Mask)>) -> Result<Mesh, EnvelopeError> {
        match inadmissible {
            Some((cube, mask)) => Err(EnvelopeError::inadmissible(self.voxels, cube, mask)),
            None => Ok(self.mesh),
        }
    }
}
