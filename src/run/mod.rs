//! The run record: a folder that is readable at every moment and never overwrites what is not ours.

mod folder;

pub use folder::{FolderError, RunFolder};
