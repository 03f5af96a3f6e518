//! The frame of a house: walls and floors on the lines of the linear tileset, roofs on the heights that the drawing uses, merged over
//! modules, with sheathing as braces.
//!
//! ```text
//! keys of the cubes -> tile lines of walls and floors --+
//!                   -> roof heights -> rafters, hips,   +-> half-module grid -> openings, floors -> sticks -> splices
//!                      valleys, ridges, verges, plates -+     -> nodes and elements -> panels, areas, spans
//! ```
//! Everything lies on a grid of half modules (450 x 450 x 270 mm): a stick is a run of grid steps with one role, a node is a
//! grid point where sticks meet or end. Axes lie in the facade planes, in the slab tops and in the roof surface (the drawing's
//! undisplaced points); how far the timber's own centre line lies from its axis is stated by [`axis_offsets`] and neglected.
//!
//! What a designer edits: `tilesets/linear` says which lines of walls and floors a cube has, by its filled corners. The lines of roofs
//! are no tile: eight corners do not know whether a roof goes on over a face of its cube, the numbers on the faces do
//! ([`crate::cubes::FaceNumber`]), and a rafter has to lie in the roof that is drawn. So they follow from
//! [`crate::tiles::RoofShape`], the heights that surfaces, solids and edges are made of, by rule B: a frame belongs to the architectural
//! set. Sets that draw by labels alone (rule A) are skins over the same frame, whose crumpled verges nobody would build; roof lines in
//! the OBJ files show rule A and are not read. A roof whose span is an even number of modules
//! has a level strip of one module at its top, in the drawing as in the frame: heights are whole voxels.
//!
//! Joints: studs run from the foundation to the roof (up to the verge rafter in a gable), plates are hinged where a stud passes them
//! and run through elsewhere, beams run over their posts, joists over beams; every stick end is a hinge (bending released, torsion
//! held). Where all sticks at a node end, one of them keeps its rotation: the others hinge on it, so no moment is carried. Walls that
//! rise from a roof go on inside the house down to the floor below and stand there on a beam.

mod areas;
mod build;
mod deck_strips;
mod floors;
mod grid;
mod joints;
mod offsets;
mod openings;
mod panels;
mod place;
mod plateaus;
mod roof;
mod roof_areas;
mod sheathing;
mod spans;
mod splice;
mod sticks;
mod supports;
mod types;

pub use build::{FrameError, FrameOptions, FrameWorkspace, build, build_members, complete};
pub use joints::{JointScratch, distinct_joints};
pub use offsets::{AxisLine, AxisOffset, axis_offsets, member_offsets};
pub use sheathing::{Panel, PanelKind, SHEATHING, Sheathing};
pub use types::{Area, Element, ElementArea, FrameMember, HouseFrame, Level, Role, STOCK_LENGTH_M, Span};
