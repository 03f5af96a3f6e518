//! Houscaper: coloured voxel arrays in, modular houses out.
pub mod analysis;
pub mod brief;
pub mod cubes;
pub mod envelope;
pub mod export;
pub mod frame;
pub mod price;
pub mod quantities;
pub mod run;
pub mod score;
pub mod search;
pub mod structure;
pub mod tiles;
pub mod voxels;
