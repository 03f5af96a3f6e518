//! Coloured voxel arrays: labels, files, storeys, openings, stairs, and the rules that make them houses.

mod admissible;
mod array;
mod choices;
mod decks;
pub mod given;
mod house;
mod hull;
mod infer;
pub mod json;
mod label;
pub mod lattice;
mod openings;
mod placement;
mod plan;
mod read;
mod repair;
pub mod rules;
pub mod samples;
mod samples_gallery;
mod stair;
mod storeys;
pub mod text;
pub mod vox;

pub use admissible::is_admissible;
pub use array::{Module, STOREY_MODULES, VoxelArray};
pub use choices::{Boards, Choice, Choices};
pub use decks::walked_deck;
pub use given::{CellMap, Given, GivenError, Resample, ScaleReport, field, resample};
pub use house::House;
pub use hull::{Hull, HullError};
pub use infer::infer_stairs;
pub use label::Label;
pub use openings::facing;
pub use placement::Placement;
pub use plan::Plan;
pub use read::{
    FLOOR_HEADROOM_M, LINING_M, ROOF_ZONE_M, SLAB_ZONE_M, STANDING_HEIGHT_M, net_floor_area_m2, read_storeys,
};
pub use repair::repair;
pub use stair::{Direction, Stair, StairKind};
pub use storeys::{FRAME_M, FacadeOpening, MULLION_M, Plate, Reading, Storey};
