//! Parts: what a factory makes and a truck carries. Cube tiles are drawing units; parts are storey-high wall panels, floor and roof
//! cassettes, windows, doors and stairs, and members cut from stock lengths.
//!
//! ```text
//! voxels -> columns (what stands in each cell, as bits) -> walls   runs of facade, split at voxel borders
//!                                                       -> floors, decks, level roofs   strips along the joists
//!                                                       -> roof planes   strips from the eaves to the ridge
//! ```
//! Nothing but integers decides where a joint lies, so the same house is cut in the same way wherever it stands; every choice is made in a
//! frame that turns and mirrors with the house, so that [`Parts::distinct`] does too.
//!
//! Conventions. A wall panel of level p stands on the slab top of plate p (the voxels' centre plane) and ends at the slab top of
//! plate p + 1, 3.24 m higher, or under the roof; heights count in half modules of 270 mm. The facades along
//! one axis, the longer ones, run through at corners; those along the other butt against them. At an outer corner the butting panel is a
//! wall thickness shorter than its modules, at an inner corner the one that runs through a wall thickness longer: mirrored corners make
//! mirrored panels. A panel's area is that of its outline less its openings as built.
//! Foundation (slab, perimeter beam, plinth) is site work and no part.

mod assign;
mod cassettes;
mod columns;
mod congruence;
mod cut;
mod error;
mod facades;
mod floors;
mod frame_mass;
mod marks;
mod mass;
mod repetition;
mod roofs;
mod stock;
mod types;
mod walls;

pub use cut::cut;
pub use error::PartsError;
pub use marks::{Marks, marks};
pub use mass::{HEAVIEST_KG, HIGHEST_M, Masses, Overload, masses, overloads};
pub use stock::{STOCK_LENGTH_M, Stock, StockPiece, stock};
pub use types::{PanelOpening, Part, PartCell, PartId, PartKind, Parts, Settings};
