//! The frame of a house: sticks on the lines of the linear tileset, merged over modules, with sheathing as braces.
//!
//! ```text
//! tile lines -> half-module grid -> openings, floors, roof -> sticks -> nodes and elements -> panels, areas, spans
//! ```
//! Everything lies on a grid of half modules (450 x 450 x 270 mm): a stick is a run of grid steps with one role, a node is a
//! grid point where sticks meet or end. Axes lie in the facade planes and in the slab tops (the drawing's undisplaced points).
//!
//! Joints: studs run from the foundation to the eave, plates are hinged where a stud passes them and run through elsewhere,
//! beams run over their posts, joists over beams; every stick end is a hinge (bending released, torsion held). Where all
//! sticks at a node end, one of them keeps its rotation: the others hinge on it, so no moment is carried.

mod areas;
mod build;
mod floors;
mod grid;
mod openings;
mod panels;
mod place;
mod roof;
mod spans;
mod sticks;
mod supports;
mod types;

pub use build::{FrameError, FrameWorkspace, build};
pub use types::{
    Area, Element, ElementArea, FrameMember, HouseFrame, Level, Panel, PanelKind, Role, SHEATHING, Sheathing, Span,
};
