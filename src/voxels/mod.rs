//! Coloured voxel arrays: labels, files, storeys, openings, stairs, and the rules that make them houses.

mod array;
mod choices;
mod house;
mod label;
mod plan;
mod stair;
mod storeys;

pub use array::{Module, STOREY_MODULES, VoxelArray};
pub use choices::{Choice, Choices};
pub use house::House;
pub use label::Label;
pub use plan::Plan;
pub use stair::{Direction, Stair, StairKind};
pub use storeys::{FacadeOpening, Plate, Reading, Storey};
