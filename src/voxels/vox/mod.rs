//! MagicaVoxel files: coloured voxels in, labels out, and back.
//!
//! MagicaVoxel has z up as we have; one voxel of the file is one module, unless [`rescale`] says how large it is. The
//! format stores colours, not labels, so that a map between the two is needed ([`ColourMap`]). Files we write use five
//! fixed colours ([`LABEL_COLOURS`]) and round-trip exactly; any other colour counts as base, and how many did is told.
//! Module size, origin, stairs and zones have no place in the format.
//!
//! Format: ephtracy, `MagicaVoxel-file-format-vox.txt` and its extension for scenes; parsed by the crate `dot_vox`. That
//! parser drops what it cannot read, so the chunks are walked first (`chunks.rs`), and what it would panic on is refused.

mod chunks;
mod colours;
mod error;
mod read;
mod rescale;
mod scene;
mod write;

pub use colours::{ColourMap, LABEL_COLOURS};
pub use error::{ColourError, VoxError};
pub use read::{VoxScene, read};
pub use rescale::{RescaleError, rescale};
pub use write::write;

/// Voxels along one axis of a model: the format stores their places in a byte.
pub const MOST_ALONG: usize = 256;

/// Largest array that is read, voxels.
const MOST_VOXELS: usize = 64 << 20;
