//! Tilesets: what stands in a cube for each of the 126 admissible configurations, as data on disk and as tables in memory.
//!
//! A [`Tileset`] or [`LinearTileset`] is loaded from a folder (manifest and OBJ files) whoever made it; [`construct`] and
//! [`skeleton`] are the generator of our own sets, [`bake_surface`] and [`bake_linear`] write its results as such folders.

mod bake;
mod block;
mod component;
mod construct;
mod error;
mod linear;
mod linear_set;
mod manifest;
mod obj;
mod patch;
mod polygon;
mod seams;
mod shells;
mod skeleton;
pub mod solids;
mod style;
mod surface;
mod validate;

pub use bake::{BakedFile, bake_linear, bake_surface, write_files};
pub use block::Block;
pub use component::Component;
pub use construct::{KeyFacet, construct, construct_key};
pub use error::TilesetError;
pub use linear::{Line, LineRole};
pub use linear_set::LinearTileset;
pub use manifest::{Layer, LayerKind, Manifest, SCHEMA, TileEntry, TileSymmetry, TilesetKind};
pub use patch::{Facet, Patch, PatchClass, PatchKind};
pub use polygon::{doubled_area, out_of_plane, triangulate};
pub use seams::{Finding, Meeting, check_linear_tileset, check_tileset, face_curve, meetings};
pub use shells::{Shells, Stack, Stratum, depth_um};
pub use skeleton::skeleton;
pub use style::{CUBE_MM, HALF_PLAN_MM, HALF_RISE_MM, Style};
pub use surface::{AreaTerm, MANIFEST_FILE, Solid, Tileset, VolumeTerm};
