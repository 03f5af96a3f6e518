//! What can be wrong with a book.

use std::path::Path;

use serde::de::DeserializeOwned;
use thiserror::Error;

use crate::quantities::Unit;

/// A book that cannot be used.
#[derive(Debug, Error)]
pub enum PriceError {
    /// The file cannot be read.
    #[error("{file}: {source}; check the path of the book")]
    Read {
        /// Path of the book.
        file: String,
        /// Cause.
        source: std::io::Error,
    },
    /// The file is not JSON of the expected shape: unknown or missing key, unknown unit, wrong type.
    #[error("{file}: {source}; correct that line")]
    Shape {
        /// Path of the book.
        file: String,
        /// Cause with key, line and column.
        source: serde_json::Error,
    },
    /// A head field has another value than this program can use.
    #[error("{file}: \"{key}\" is \"{found}\", expected \"{expected}\"; convert the book")]
    Head {
        /// Path of the book.
        file: String,
        /// Field.
        key: &'static str,
        /// Value found.
        found: String,
        /// Value expected.
        expected: String,
    },
    /// A number is negative, not finite, out of order (low <= default <= high) or otherwise impossible.
    #[error("{file}: {key}: {found}; {expected}")]
    Value {
        /// Path of the book.
        file: String,
        /// Item and field.
        key: String,
        /// Value found.
        found: String,
        /// What is expected.
        expected: &'static str,
    },
    /// The same id stands twice.
    #[error("{file}: {key} stands twice; remove or rename one")]
    Duplicate {
        /// Path of the book.
        file: String,
        /// The id.
        key: String,
    },
    /// An item that is needed is not in a book.
    #[error("{file}: no \"{item}\", which {needed_by} needs; add it to the book")]
    Missing {
        /// Path of the book that lacks it.
        file: String,
        /// Id of the missing item.
        item: String,
        /// What refers to it.
        needed_by: String,
    },
    /// A quantity is given in another unit than the rate.
    #[error("{file}: {key}: unit \"{found}\", but the rate of \"{item}\" is per \"{expected}\"; convert the quantity")]
    UnitMismatch {
        /// Path of the file with the quantity.
        file: String,
        /// Where the quantity stands.
        key: String,
        /// The item of the book.
        item: String,
        /// Unit of the quantity.
        found: Unit,
        /// Unit of the rate.
        expected: Unit,
    },
}

/// Reads a book of type `T` from a file.
pub(super) fn read<T: DeserializeOwned>(path: &Path) -> Result<T, PriceError> {
    let file = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|source| PriceError::Read { file: file.clone(), source })?;
    serde_json::from_slice(&bytes).map_err(|source| PriceError::Shape { file, source })
}

/// Fails unless a head field has the expected value.
pub(super) fn expect_head(file: &str, key: &'static str, found: &str, expected: &str) -> Result<(), PriceError> {
    if found == expected {
        return Ok(());
    }
    Err(PriceError::Head { file: file.into(), key, found: found.into(), expected: expected.into() })
}

/// Fails on an empty text, such as a source left out.
pub(super) fn expect_text(file: &str, key: &str, text: &str) -> Result<(), PriceError> {
    if !text.trim().is_empty() {
        return Ok(());
    }
    let expected = "expected a text that names the source";
    Err(PriceError::Value { file: file.into(), key: key.into(), found: "empty".into(), expected })
}

/// Fails when an id occurs twice.
pub(super) fn expect_unique<'a>(file: &str, ids: impl Iterator<Item = &'a str>) -> Result<(), PriceError> {
    let mut ids: Vec<&str> = ids.collect();
    ids.sort_unstable();
    match ids.windows(2).find(|pair| pair[0] == pair[1]) {
        None => Ok(()),
        Some(pair) => Err(PriceError::Duplicate { file: file.into(), key: pair[0].into() }),
    }
}
