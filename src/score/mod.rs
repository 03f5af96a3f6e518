//! One house, one brief, one evaluation: a pure function without disk, clock or chance.

mod carcass;
mod compare;
mod evaluation;
mod evaluator;
mod heat;
mod layer_weights;
mod layers;
mod load;
mod measure;
mod member_costs;
mod origins;
mod prepared;
mod programme;
mod shells;
mod sizing;
mod survival;
mod tiling;
mod why;

pub use crate::voxels::walked_deck;
pub use compare::{Comparison, LineRow, Tie, Variant};
pub use evaluation::{Evaluation, Values};
pub use evaluator::{Details, Evaluator};
pub use heat::{FacingOpenings, HeatElement, HeatLoss};
pub use layer_weights::carried_kg;
pub use layers::{LayerRow, Weighed, layers};
pub use load::{LoadFailure, Paths};
pub use member_costs::MemberCost;
pub use programme::{Shortfall, entrances, floor_area_m2, out_of, window_area_by_direction, zone_area_m2};
pub use shells::{ShellsError, shells};
pub use sizing::{Sized, SizingGoal, SizingWalk};
pub use survival::{Account, Survival, UnknownAmount};
pub use tiling::{Tiling, Walked};
pub use why::{Bound, Demand};
