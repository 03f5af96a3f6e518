//! The frame file `houscaper.frame/1`: JSON in and out, unknown keys are errors that name their place.

mod wire;

use super::model::{
    Axes, Distribution, LoadCase, Material, Member, MemberLoad, Model, NodalLoad, Section, Settlement, Support,
};
use thiserror::Error;

/// The schema this module reads and writes.
pub const SCHEMA: &str = "houscaper.frame/1";

/// A frame file as read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameFile {
    /// Free text.
    pub name: String,
    /// Free text: where the frame comes from.
    pub source: String,
    /// Free text: units of the numbers.
    pub units: String,
    /// The frame.
    pub model: Model,
    /// Its load cases.
    pub cases: Vec<LoadCase>,
    /// Linear combinations of cases.
    pub combinations: Vec<Combination>,
    /// Published values, in reference files.
    pub expected: Vec<Expected>,
}

/// A linear combination of load cases.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// Its name.
    pub name: String,
    /// One factor for each case of the file.
    pub factors: Vec<f64>,
}

/// What an expected value is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Displacement of a node.
    Displacement {
        /// The node.
        node: usize,
    },
    /// Reaction of a supported node.
    Reaction {
        /// The node.
        node: usize,
    },
    /// End force of a member.
    EndForce {
        /// The member.
        member: usize,
    },
}

/// A published value.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// The case.
    pub case: usize,
    /// Of what.
    pub quantity: Quantity,
    /// Component, 0 to 5 (end forces 0 to 11).
    pub component: usize,
    /// The value.
    pub value: f64,
    /// Absolute tolerance.
    pub tolerance: f64,
    /// As printed in the source.
    pub printed: String,
}

/// Why a frame file cannot be used.
#[derive(Debug, Error)]
pub enum FrameFileError {
    /// Broken JSON, a missing, unknown or mistyped key.
    #[error("{file}: at {path}: {message}")]
    Json {
        /// Name of the file.
        file: String,
        /// Key path, as in `members[3].mat`; `line L column C` for broken JSON.
        path: String,
        /// What is wrong.
        message: String,
    },
    /// A value that makes no sense where it stands.
    #[error("{file}: at {path}: found {found}, expected {expected}")]
    Value {
        /// Name of the file.
        file: String,
        /// Key path.
        path: String,
        /// What stands there.
        found: String,
        /// What may stand there.
        expected: String,
    },
}

/// Reads a frame file; `name` is used in messages. Indices and ranges are checked by the solver.
///
/// ```
/// let bytes = br#"{"nodes": [[0,0,0]], "materials": [], "sections": [], "members": [], "supports": [], "cases": [], "nods": 1}"#;
/// let error = houscaper::analysis::file::read(bytes, "a.json").unwrap_err();
/// assert!(error.to_string().starts_with("a.json: at nods: unknown key"));
/// ```
pub fn read(bytes: &[u8], name: &str) -> Result<FrameFile, FrameFileError> {
    wire::read(bytes, name)
}

/// Writes a frame file: schema first, then the keys in the order of the format, one line an item, numbers as short as they
/// read back exactly.
pub fn write(file: &FrameFile) -> Vec<u8> {
    wire::write(file)
}
