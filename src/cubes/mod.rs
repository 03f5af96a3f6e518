//! Cubes between voxel centres: occupancy masks, the 126 admissible configurations and their classes, cube ids, and the
//! two-dimensional case that draws plans.

mod catalogue;
mod catalogue_doubts;
mod configuration;
mod corner;
mod face_words;
mod faces;
mod ids;
mod key;
mod layers;
mod reachable;
mod reachable_infill;
mod scan;
mod scan_keys;
mod squares;
mod symmetry;

pub use catalogue::{Family, Grouping, catalogue};
pub use catalogue_doubts::{Doubt, doubts};
pub use configuration::{Category, admissible_masks, canonical, canonical_masks, categories, turn_class};
pub use corner::{Axis, Corner, Mask};
pub use faces::{Rule, cube_key, face_number};
pub use ids::{CornerOrder, CubeIds, IdScheme, ThesisId, cube_ids, topogenesis_id};
pub use key::{CubeKey, FaceNumber};
pub use reachable::{Level, face_numbers, keys_of, needs_tile, reachable_keys, reachable_labels, walked_decks};
pub use scan::{corner_voxel, cube_labels, cube_mask, cube_shape, scan_masks};
pub use scan_keys::scan_keys;
pub use squares::{SquareCase, contours};
pub use symmetry::Symmetry;
