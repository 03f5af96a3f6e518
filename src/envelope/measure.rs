//! Areas and volume straight from the tiles: one pass over the cubes, no mesh, no allocation.

use super::{EnvelopeAreas, EnvelopeError, Surface};
use crate::cubes::{Mask, corner_voxel, scan_masks};
use crate::tiles::solids::edges::EdgeTerms;
use crate::tiles::{AreaTerm, PatchClass, Tileset, VolumeTerm};
use crate::voxels::{Label, VoxelArray};

/// Areas, volume, and openings by the direction they face.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EnvelopeSurvey {
    /// Areas by surface and the enclosed volume.
    pub areas: EnvelopeAreas,
    /// Window area in m2 facing east, north, west, south (the order of `Direction::ALL`).
    pub windows_m2: [f64; 4],
    /// Door area in m2, the same order.
    pub doors_m2: [f64; 4],
    /// What stands along the edges of roofs and decks; nothing for tilesets without edges.
    pub edges: EdgeTerms,
}

/// Areas by surface and the enclosed volume of a house.
///
/// Errs with the first cube that has no tile.
pub fn areas(voxels: &VoxelArray, tileset: &Tileset) -> Result<EnvelopeAreas, EnvelopeError> {
    survey(voxels, tileset).map(|s| s.areas)
}

/// Sums over (class, label), the finest division that any surface needs.
type Sums = [[f64; Label::ALL.len()]; PatchClass::COUNT];

/// Everything that the tiles say about areas in one pass.
///
/// Areas add up per class and label of the octant; the volume is the integral of z n_z over the surface, summed in integers, so
/// that it does not depend on order. Modules of another size than the tileset's stretch the tiles.
pub fn survey(voxels: &VoxelArray, tileset: &Tileset) -> Result<EnvelopeSurvey, EnvelopeError> {
    let scale = module_scale(voxels, tileset.module_mm());
    let mut pass = Pass { voxels, tileset, scale, sums: Sums::default(), moment: 0, inadmissible: None };
    if scale == [1.0; 3] {
        scan_masks(voxels, |cube, mask| pass.add_terms(cube, mask));
    } else {
        scan_masks(voxels, |cube, mask| pass.add_stretched(cube, mask));
    }
    match pass.inadmissible {
        Some((cube, mask)) => Err(EnvelopeError::inadmissible(voxels, cube, mask)),
        None => Ok(pass.finish()),
    }
}

/// Size of the array's module over the tileset's, exactly 1 where they agree to a millionth.
pub(super) fn module_scale(voxels: &VoxelArray, module_mm: [i32; 3]) -> [f64; 3] {
    [0, 1, 2].map(|a| {
        let scale = voxels.module.size_m[a] * 1000.0 / f64::from(module_mm[a]);
        if (scale - 1.0).abs() < 1e-6 { 1.0 } else { scale }
    })
}

struct Pass<'a> {
    voxels: &'a VoxelArray,
    tileset: &'a Tileset,
    scale: [f64; 3],
    sums: Sums,
    moment: i64,
    inadmissible: Option<([usize; 3], Mask)>,
}

impl Pass<'_> {
    #[inline]
    fn add_terms(&mut self, cube: [usize; 3], mask: Mask) {
        // A filled octant lies inside the array, so its voxel is found without looking at the borders.
        let [nx, ny, _] = self.voxels.shape();
        let first = (cube[0] + nx * (cube[1] + ny * cube[2])).wrapping_sub(1 + nx + nx * ny);
        for &AreaTerm { octant, class, area_m2 } in self.tileset.area_terms(mask) {
            let o = usize::from(octant);
            let voxel = first.wrapping_add((o & 1) + nx * ((o >> 1 & 1) + ny * (o >> 2)));
            let label = self.voxels.labels().get(voxel).copied().unwrap_or_default();
            self.sums[class as usize][label.code() as usize] += area_m2;
        }
        self.add_volume(cube, mask);
    }

    fn add_stretched(&mut self, cube: [usize; 3], mask: Mask) {
        for patch in self.tileset.patches(mask) {
            self.sums[patch.class as usize][self.label(cube, patch.octant)] += patch.area_m2(self.scale);
        }
        self.add_volume(cube, mask);
    }

    /// Code of the label at an octant.
    fn label(&self, cube: [usize; 3], octant: u8) -> usize {
        let corner = crate::cubes::Corner::at([octant, octant >> 1, octant >> 2]);
        self.voxels.at(corner_voxel(cube, corner)).code() as usize
    }

    #[inline]
    fn add_volume(&mut self, cube: [usize; 3], mask: Mask) {
        let VolumeTerm { doubled_plan_mm2, moment_mm3 } = self.tileset.volume_term(mask);
        let bottom = i64::from(self.tileset.module_mm()[2]) * cube[2] as i64;
        self.moment += 3 * doubled_plan_mm2 * bottom + moment_mm3;
        if self.inadmissible.is_none() && !mask.is_admissible() {
            self.inadmissible = Some((cube, mask));
        }
    }

    fn finish(self) -> EnvelopeSurvey {
        let mut survey = EnvelopeSurvey::default();
        for (class, sums) in CLASSES.into_iter().zip(&self.sums) {
            for (label, &area) in Label::ALL.into_iter().zip(sums) {
                survey.areas.area_m2[Surface::of(class, label) as usize] += area;
                if let Some(facing) = class.facing() {
                    match label {
                        Label::Window => survey.windows_m2[facing as usize] += area,
                        Label::Opening => survey.doors_m2[facing as usize] += area,
                        Label::Empty | Label::Base | Label::Floor | Label::Foundation => {}
                    }
                }
            }
        }
        let [sx, sy, sz] = self.scale;
        survey.areas.volume_m3 = self.moment as f64 / 6e9 * (sx * sy * sz);
        survey
    }
}

/// The classes in storage order.
const CLASSES: [PatchClass; PatchClass::COUNT] = [
    PatchClass::WallEast,
    PatchClass::WallNorth,
    PatchClass::WallWest,
    PatchClass::WallSouth,
    PatchClass::RoofLevel,
    PatchClass::RoofInclined,
    PatchClass::Deck,
    PatchClass::Soffit,
];
