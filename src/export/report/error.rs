//! What a run folder can have wrong with it.

use crate::run::FolderError;

/// Why a report could not be made of a folder.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file could not be read.
    #[error(transparent)]
    Folder(#[from] FolderError),
    /// Neither a run nor a house.
    #[error(
        "run.json: schema is {found}, expected \"houscaper.run/1\" (from `optimize`) or \"houscaper.build/1\" (from `build`)"
    )]
    Schema {
        /// What it says.
        found: String,
    },
    /// A folder without results.
    #[error(
        "front.csv: is not there, so there is nothing to show: the run has not ended yet; `houscaper resume` carries it on"
    )]
    NoFront,
    /// A build folder without its model.
    #[error("house.glb: is not there: expected the --out of `houscaper build`")]
    NoHouse,
    /// A JSON file that cannot be read.
    #[error("{file}: {source}; write the folder again with the command that made it")]
    Json {
        /// The file.
        file: String,
        /// What is wrong, with its place.
        source: serde_json::Error,
    },
    /// A table that cannot be read.
    #[error("{file}, line {line}: {found}; expected {expected}")]
    Table {
        /// The file.
        file: String,
        /// Line, from 1.
        line: usize,
        /// What is there.
        found: String,
        /// What should be there.
        expected: String,
    },
}
