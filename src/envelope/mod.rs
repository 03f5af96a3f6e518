//! The skin of a house: tiles placed in their cubes, welded into one closed mesh; areas by surface without meshing.

mod mesh;

pub use mesh::{EnvelopeAreas, Mesh, Surface};
