//! The two kinds of surface a house may wear, behind one name.

use super::{EnvelopeError, EnvelopeSurvey, KeyCache, KeyedSurface, Mesh, mesh, mesh_keys, survey, survey_keys};
use crate::tiles::Tileset;
use crate::voxels::VoxelArray;

/// What covers a house: tiles loaded by configuration, or a surface constructed by key.
#[derive(Clone, Debug, PartialEq)]
pub enum Skin {
    /// One tile per configuration of filled corners.
    Tiles(Tileset),
    /// One tile per key: labels and face numbers.
    Keys(KeyedSurface),
}

impl Skin {
    /// Areas, volume, openings and edges of a house. `walked` tells of a slab voxel with nothing above it whether people walk on it,
    /// which decides between railing and parapet. `cache` is kept from house to house by the caller; tiles by configuration ignore it.
    /// Errs with the first cube that has no tile.
    pub fn survey(
        &self,
        voxels: &VoxelArray,
        walked: impl Fn([usize; 3]) -> bool,
        cache: &mut KeyCache,
    ) -> Result<EnvelopeSurvey, EnvelopeError> {
        match self {
            Skin::Tiles(tileset) => survey(voxels, tileset),
            Skin::Keys(surface) => survey_keys(voxels, surface, walked, cache),
        }
    }

    /// The welded envelope of a house. Errs with the first cube that has no tile.
    pub fn mesh(&self, voxels: &VoxelArray) -> Result<Mesh, EnvelopeError> {
        match self {
            Skin::Tiles(tileset) => mesh(voxels, tileset),
            Skin::Keys(surface) => mesh_keys(voxels, surface),
        }
    }
}
