//! Houscaper: coloured voxel arrays in, a Pareto front of modular houses out.
//!
//! The modules are the way of a house through the program; imports go one way along this list (`tests/layers.rs` holds them to it):
//!
//! ```text
//! voxels -> brief -> cubes -> tiles -> envelope | frame -> analysis -> structure -> quantities -> price -> parts -> score -> search -> run -> export
//! ```
//!
//! The heart is one pure function, [`score::Evaluator::evaluate`]: voxels and choices in, evaluation out; no disk, no clock, no chance.
//!
//! Deliberately absent: [`analysis`] knows no voxels or tiles; [`price`] knows no geometry, only quantities; [`search`] knows genomes and
//! scores, never tiles, members or money; parsers take bytes. A bad design is a verdict, never an `Err`. SI units and `f64` everywhere.
//!
//! Guaranteed: the same brief, seed and version give byte-equal results on one platform for any number of threads. Not guaranteed: equal
//! bytes across processors with different vector units, or for runs cut by time.

pub mod analysis;
pub mod brief;
pub mod cubes;
pub mod envelope;
pub mod export;
pub mod frame;
pub mod parts;
pub mod price;
pub mod quantities;
pub mod run;
pub mod score;
pub mod search;
pub mod structure;
pub mod tiles;
pub mod voxels;
