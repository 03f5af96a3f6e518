//! The run record: a folder that is readable at every moment and never overwrites what is not ours.

mod folder;
mod journal;
pub mod queue;
mod table;

pub use folder::{FolderError, RunFolder};
pub use journal::{Frames, Journal};
pub use table::Table;
