//! Errors of a catalogue.

use std::path::PathBuf;

use thiserror::Error;

/// Why a catalogue cannot be used.
#[derive(Debug, Error)]
pub enum CatalogueError {
    /// The file cannot be read.
    #[error("{path}: cannot be read ({source}); the configs folder must hold it")]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The file is not what it should be.
    #[error("{path}: {source}")]
    Parse {
        /// The file.
        path: PathBuf,
        /// Line, column and key.
        source: serde_json::Error,
    },
    /// A property is missing or out of range.
    #[error("{path}: {id}: `{key}` must be given and positive")]
    Property {
        /// The file.
        path: PathBuf,
        /// Material or section.
        id: String,
        /// The property.
        key: &'static str,
    },
    /// A material that the brief names is not in the catalogue.
    #[error("material `{id}` is not in the catalogue; known: {known}")]
    Unknown {
        /// As asked.
        id: String,
        /// Ids in the catalogue.
        known: String,
    },
}
