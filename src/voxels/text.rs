//! The text form of small arrays: layers of characters, for tests and messages.

use super::{Label, VoxelArray};

/// What is wrong with a text array.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TextError {
    /// A character that is no label.
    #[error("line {line}, column {column}: `{found}` is no label; use `.` for empty or 1 to 5")]
    Label {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// The character.
        found: char,
    },
    /// A row of another length.
    #[error("line {line}: {found} characters where the first row has {expected}; make all rows equally long")]
    Row {
        /// Line, from 1.
        line: usize,
        /// Characters found.
        found: usize,
        /// Characters expected.
        expected: usize,
    },
    /// A layer with another number of rows.
    #[error("layer {layer}: {found} rows where the first layer has {expected}; give every layer the same rows")]
    Layer {
        /// Layer, from 0 at the ground.
        layer: usize,
        /// Rows found.
        found: usize,
        /// Rows expected.
        expected: usize,
    },
    /// Nothing in the text.
    #[error("no rows: expected layers of `.` and 1 to 5, separated by blank lines")]
    Empty,
}

/// Reads layers from the ground up, separated by blank lines; in each, the first row is the northernmost (largest y).
///
/// ```
/// use houscaper::voxels::{Label, text};
/// let array = text::parse("33\n3.\n\n11\n..")?;
/// assert_eq!(array.shape(), [2, 2, 2]);
/// assert_eq!(array.get([1, 0, 0]), Label::Empty); // second row: y = 0
/// assert_eq!(text::write(&array), "33\n3.\n\n11\n..\n");
/// # Ok::<(), text::TextError>(())
/// ```
///
/// # Errors
/// Characters other than `.` and 1 to 5, ragged rows and layers, and text without rows.
pub fn parse(text: &str) -> Result<VoxelArray, TextError> {
    let mut layers: Vec<Vec<Vec<Label>>> = Vec::new();
    let mut open = false;
    let mut width = None;
    for (n, row) in text.lines().enumerate() {
        let row = row.trim();
        if row.is_empty() {
            open = false;
            continue;
        }
        let labels = parse_row(row, n + 1)?;
        let expected = *width.get_or_insert(labels.len());
        if labels.len() != expected {
            return Err(TextError::Row { line: n + 1, found: labels.len(), expected });
        }
        if !open {
            layers.push(Vec::new());
            open = true;
        }
        if let Some(layer) = layers.last_mut() {
            layer.push(labels);
        }
    }
    let (Some(nx), Some(ny)) = (width, layers.first().map(Vec::len)) else { return Err(TextError::Empty) };
    if let Some((layer, rows)) = layers.iter().enumerate().find(|(_, rows)| rows.len() != ny) {
        return Err(TextError::Layer { layer, found: rows.len(), expected: ny });
    }
    let mut array = VoxelArray::new([nx, ny, layers.len()]);
    for (z, layer) in layers.iter().enumerate() {
        for (row, labels) in layer.iter().enumerate() {
            for (x, &label) in labels.iter().enumerate() {
                array.set([x, ny - 1 - row, z], label);
            }
        }
    }
    Ok(array)
}

fn parse_row(row: &str, line: usize) -> Result<Vec<Label>, TextError> {
    row.chars()
        .enumerate()
        .map(|(c, found)| match found {
            '.' => Ok(Label::Empty),
            '1'..='5' => Label::from_code(found as u8 - b'0').ok_or(TextError::Label { line, column: c + 1, found }),
            _ => Err(TextError::Label { line, column: c + 1, found }),
        })
        .collect()
}

/// The text form of an array, as [`parse`] reads it. Module size and origin are not part of it.
pub fn write(array: &VoxelArray) -> String {
    let [nx, ny, nz] = array.shape();
    let mut text = String::with_capacity((nx + 1) * ny * nz + nz);
    for z in 0..nz {
        if z > 0 {
            text.push('\n');
        }
        for y in (0..ny).rev() {
            text.extend((0..nx).map(|x| match array.get([x, y, z]) {
                Label::Empty => '.',
                label => (b'0' + label.code()) as char,
            }));
            text.push('\n');
        }
    }
    text
}
