//! The skin of a house: tiles placed in their cubes, welded into one closed mesh; areas by surface without meshing.

mod by_cube;
mod cube_tile;
mod fabric;
mod keyed;
mod manifold;
mod measure;
mod measure_keys;
mod merge;
mod merge_lines;
mod merge_outline;
mod merge_solid;
mod mesh;
mod skin;
mod stairs;
mod triangulate;
mod volumes;
mod weld;

pub use by_cube::CubePiece;
pub use cube_tile::{CubeTile, FabricLayer};
pub use fabric::{CUBE_UM, Fabric, Gathered, PlacedBlock};
pub use keyed::{KeyCache, KeyedSurface};
pub use manifold::{ManifoldReport, manifold_report};
pub use measure::{EnvelopeSurvey, areas, survey};
pub use measure_keys::survey_keys;
pub use merge::{Merge, MergeError};
pub use merge_solid::{Face, Solid, SolidReport};
pub use mesh::{EnvelopeAreas, Mesh, Surface, volume};
pub use skin::Skin;
pub use stairs::{house_stairs, stair_blocks};
pub use volumes::{HouseVolumes, VolumeTable, Volumes, stretch};
pub use weld::{mesh, mesh_keys};

use crate::cubes::{CornerOrder, Mask, ThesisId, cube_labels};
use crate::tiles::PatchClass;
use crate::voxels::{Label, VoxelArray};

/// A voxel array that has no envelope.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EnvelopeError {
    /// A cube for which no tile exists.
    #[error(
        "cube ({}, {}, {}) of the padded array has the inadmissible configuration {mask} (thesis id {id}, f_order): its filled or \
         its empty corners are not connected along edges; fill or empty one of the voxels around it",
        cube[0], cube[1], cube[2]
    )]
    Inadmissible {
        /// Position in the padded array.
        cube: [usize; 3],
        /// Its filled corners.
        mask: Mask,
        /// Its thesis id in `f_order`.
        id: u32,
    },
}

impl EnvelopeError {
    fn inadmissible(voxels: &VoxelArray, cube: [usize; 3], mask: Mask) -> EnvelopeError {
        let id = ThesisId::new(&cube_labels(voxels, cube), CornerOrder::FOrder).0;
        EnvelopeError::Inadmissible { cube, mask, id }
    }
}

impl Surface {
    /// What a patch is, from its class and the label of its octant.
    ///
    /// Upper sides of windows and doors and of anything that is no slab count as roof.
    pub const fn of(class: PatchClass, label: Label) -> Surface {
        match class {
            PatchClass::WallEast | PatchClass::WallNorth | PatchClass::WallWest | PatchClass::WallSouth => {
                match label {
                    Label::Empty | Label::Base => Surface::Wall,
                    Label::Floor => Surface::Band,
                    Label::Foundation => Surface::Plinth,
                    Label::Opening => Surface::Door,
                    Label::Window => Surface::Window,
                }
            }
            PatchClass::RoofLevel | PatchClass::RoofInclined | PatchClass::Deck => match (class, label) {
                (PatchClass::Deck, _) | (_, Label::Floor | Label::Foundation) => Surface::Deck,
                (PatchClass::RoofLevel, _) => Surface::FlatRoof,
                _ => Surface::PitchedRoof,
            },
            PatchClass::Soffit => match label {
                Label::Foundation => Surface::Ground,
                _ => Surface::Soffit,
            },
        }
    }
}
