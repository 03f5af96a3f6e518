//! Houses that cannot be cut.

use thiserror::Error;

/// Why a house was not cut into parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum PartsError {
    /// More layers than a column of bits holds.
    #[error(
        "parts: the array is {found} layers high, at most {limit} can be cut into parts; leave out empty layers above the house"
    )]
    TooHigh {
        /// Layers of the array.
        found: usize,
        /// Layers that can be cut.
        limit: usize,
    },
    /// A limit that holds not even one module.
    #[error("parts: a module of {module_mm} mm does not fit into the limit of {limit_mm} mm; raise the limit")]
    LimitTooSmall {
        /// Edge of a module, mm.
        module_mm: u32,
        /// The limit, mm.
        limit_mm: u32,
    },
}
