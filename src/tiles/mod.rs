//! Tilesets: what stands in a cube for each of the 126 admissible configurations, as data on disk and as tables in memory.

mod linear;

pub use linear::{Line, LineRole};
