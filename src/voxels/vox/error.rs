//! What can be wrong with a MagicaVoxel file.

/// Why a `.vox` file cannot be read or written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VoxError {
    /// Not a MagicaVoxel file, cut short, or with chunks that do not add up.
    #[error("{file}: byte {at}: {found}, expected {expected}; save it again from MagicaVoxel")]
    Chunk {
        /// Name of the source.
        file: String,
        /// Byte at which the fault lies, from 0.
        at: usize,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// A model larger than the format allows, without voxels along an axis, or with a voxel outside its size.
    #[error("{file}: model {model}: {message}")]
    Model {
        /// Name of the source.
        file: String,
        /// Number of the model, from 0.
        model: usize,
        /// What is wrong, and what is expected.
        message: String,
    },
    /// Models that are not placed, or placed in a way that cannot be followed.
    #[error("{file}: scene: {message}")]
    Scene {
        /// Name of the source.
        file: String,
        /// What is wrong, and what to do.
        message: String,
    },
    /// An array that the format cannot hold.
    #[error("an array of {found:?} voxels does not fit a .vox file: 1 to 256 along each axis; write .json or .csv")]
    TooLarge {
        /// Voxels along x, y, z.
        found: [usize; 3],
    },
}

/// A colour map that does not parse.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{found}` maps no colour: expected a palette index from 1 to 255 or #rrggbb, `=`, and empty, base, floor, foundation, opening or window, e.g. `157=window,#663300=opening`"
)]
pub struct ColourError {
    /// The part that does not parse.
    pub found: String,
}
