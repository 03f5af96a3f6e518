//! Files and pictures that people look at and other programs open: glTF, OBJ, pictures, plots, plans, tables.
//!
//! Everything here turns plain values into bytes or text; nothing touches the disk.

pub mod carbon;
mod colour;
pub mod compare;
mod compare_carbon;
pub mod compare_front;
pub mod dossier;
mod fabric_scene;
mod figures;
mod flat;
pub mod given;
mod glb;
mod house;
mod obj;
mod openings;
mod palette;
pub mod parts;
pub mod picture;
pub mod plan;
pub mod plots;
pub mod report;
mod scene;
mod solid;
pub mod tables;
pub mod takeoff;
pub mod tile_sheet;

pub use colour::viridis;
pub use fabric_scene::{Exploded, Storeys, from_fabric, from_parts, layer_material};
pub use flat::{FlatPart, flatten};
pub use glb::{GlbError, to_glb};
pub use house::{Showing, from_envelope, look};
pub use obj::{to_mtl, to_obj};
pub use palette::{ComponentLook, Palette};
pub use scene::{Grain, MaterialLook, Part, Scene, SceneError};
pub use solid::{bar_solid, beam_solid};
