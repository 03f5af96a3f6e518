//! Tilesets: what stands in a cube for each of the 126 admissible configurations, as data on disk and as tables in memory.
//!
//! A [`Tileset`] or [`LinearTileset`] is loaded from a folder (manifest and OBJ files) whoever made it; [`construct`] and
//! [`skeleton`] are the generator of our own sets, [`bake_surface`] and [`bake_linear`] write its results as such folders.

mod axes;
mod bake;
mod block;
mod bodies;
pub mod check;
mod claims;
mod component;
mod construct;
mod entry;
mod error;
mod foreign;
mod heights;
mod kind;
mod label_set;
mod layer;
mod linear;
mod linear_set;
mod look;
mod manifest;
mod materials;
mod mesh;
mod obj;
mod offset;
mod outline;
mod patch;
mod pattern;
mod polygon;
mod roof_shape;
mod seams;
mod shells;
mod skeleton;
pub mod solids;
mod style;
mod style_manifest;
mod surface;
mod validate;

pub use axes::{Axes, AxisMap, Pivot, UNITS};
pub use bake::{BakedFile, bake_linear, bake_surface, write_files};
pub use block::Block;
pub use bodies::Body;
pub use component::Component;
pub use construct::{KeyFacet, construct, construct_key};
pub use entry::{Numbered, TileEntry, TileSymmetry};
pub use error::TilesetError;
pub use foreign::{FOREIGN_SCHEMA, GROUP_PREFIXES, convert};
pub use kind::kind_of;
pub use label_set::{LabelSet, MissingCube, PlacedTile};
pub use layer::{Layer, LayerKind};
pub use linear::{Line, LineRole};
pub use linear_set::LinearTileset;
pub use look::{Grain, Look};
pub use manifest::{Manifest, SCHEMA, TilesetKind};
pub use outline::{Outline, difference, outline};
pub use patch::{Facet, Patch, PatchClass, PatchKind};
pub use pattern::{Choice, Pattern};
pub use polygon::{doubled_area, out_of_plane, triangulate};
pub use roof_shape::{Fold, RoofShape};
pub use seams::{Finding, Meeting, check_linear_tileset, check_tileset, face_curve, meetings};
pub use shells::{Shells, Stack, Stratum, depth_um};
pub use skeleton::skeleton;
pub use style::{CUBE_MM, HALF_PLAN_MM, HALF_RISE_MM, Style};
pub use style_manifest::{StyleManifest, StyleSet, StyleSpec, TileRule, tileset_schema};
pub use surface::{AreaTerm, MANIFEST_FILE, Solid, Tileset, VolumeTerm};
