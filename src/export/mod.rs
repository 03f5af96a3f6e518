//! Files and pictures that people look at and other programs open: glTF, OBJ, pictures, plots, plans, tables.
//!
//! Everything here turns plain values into bytes or text; nothing touches the disk.

pub mod carbon;
mod colour;
pub mod compare;
mod compare_carbon;
pub mod compare_front;
mod distinct_tiles;
pub mod dossier;
pub mod drawing;
mod fabric_scene;
mod figures;
mod flat;
pub mod given;
mod glb;
mod house;
pub mod ifc;
pub mod lattices;
mod layered_scene;
mod ledger;
mod ledger_members;
mod obj;
mod openings;
mod palette;
pub mod parts;
pub mod picture;
pub mod plots;
pub mod report;
mod scene;
mod solid;
pub mod tables;
pub mod takeoff;
mod tile_scene;
pub mod tile_sheet;
mod views;

pub use colour::viridis;
pub use distinct_tiles::{DistinctTile, DistinctTiles, TilePiece, TurnedTile};
pub use fabric_scene::{Exploded, Storeys, from_fabric, from_parts, layer_material};
pub use flat::{FlatPart, flatten};
pub use glb::{Assembly, GlbError, Instance, SharedMesh, assembly_to_glb, to_glb};
pub use house::{Showing, from_envelope, look};
pub use layered_scene::layered_scene;
pub use ledger::{Amounts, Ledger, Place};
pub use obj::{to_mtl, to_obj};
pub use palette::{ComponentLook, Palette};
pub use scene::{Grain, MaterialLook, Part, Scene, SceneError};
pub use solid::{bar_solid, beam_solid};
pub use tile_scene::tile_scene;
pub use views::{HOUSE_VIEWS, HouseLooks, Steps, Traits};
