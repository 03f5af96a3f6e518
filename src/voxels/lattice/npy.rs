//! numpy's `.npy`: lattices as three-dimensional arrays, written as `numpy.save` does, byte for byte.
//!
//! Own code instead of the crate `npyz`: an array of numbers needs this file, the crate a hundred others. Format: numpy/lib/format.py,
//! versions 1.0 to 3.0. Of the formats that hold lattices this one knows neither unit nor origin.

use super::number::spell;
use super::{Lattice, Style, Values, cell_of_row};
use crate::voxels::lattice::RowOrder;

/// What is wrong with a `.npy` file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NpyError {
    /// Not the format.
    #[error("{file}: {found}; expected a file that numpy.save wrote")]
    Format {
        /// Name of the source.
        file: String,
        /// What is there.
        found: String,
    },
    /// An array of another kind.
    #[error("{file}: {key} is {found}; expected {expected}")]
    Array {
        /// Name of the source.
        file: String,
        /// Which key of the header.
        key: &'static str,
        /// Its value.
        found: String,
        /// What can be read.
        expected: &'static str,
    },
    /// Fewer or more bytes than the shape has cells.
    #[error(
        "{file}: {found} bytes of values for a shape of {shape:?}, expected {expected}; the file is cut or continued"
    )]
    Length {
        /// Name of the source.
        file: String,
        /// Bytes found.
        found: usize,
        /// Bytes expected.
        expected: usize,
        /// Shape of the array.
        shape: [usize; 3],
    },
    /// A value that no lattice holds.
    #[error("{file}: cell {cell:?} is {found}; expected finite numbers below 2^53, or booleans of 0 and 1")]
    Value {
        /// Name of the source.
        file: String,
        /// The cell.
        cell: [usize; 3],
        /// Its value.
        found: String,
    },
}

const MAGIC: &[u8] = b"\x93NUMPY";

/// Whole numbers of f64 are exact below this.
const MOST: f64 = 9_007_199_254_740_992.0;

/// Largest array that is read, cells.
const MOST_CELLS: usize = 1 << 28;

/// The bytes of a lattice as `numpy.save` writes the array `value[i, j, k]`: booleans as `|b1`, whole numbers as `<i8`, others as `<f8`,
/// in C order.
pub fn write_npy(lattice: &Lattice) -> Vec<u8> {
    let whole = |v: &f64| v.fract() == 0.0 && v.abs() < MOST;
    let descr = match &lattice.values {
        Values::Bool(_) => "|b1",
        Values::Number(v) if v.iter().all(whole) => "<i8",
        Values::Number(_) => "<f8",
    };
    let [nx, ny, nz] = lattice.shape;
    let mut head = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({nx}, {ny}, {nz}), }}");
    // Room for the first axis to grow to 21 digits, then the next multiple of 64 bytes.
    head += &" ".repeat(21usize.saturating_sub(nx.to_string().len()));
    head += &" ".repeat(64 - (MAGIC.len() + 4 + head.len() + 1) % 64);
    head.push('\n');
    let mut bytes = [MAGIC, &[1, 0], &(head.len() as u16).to_le_bytes(), head.as_bytes()].concat();
    for n in 0..nx * ny * nz {
        let [x, y, z] = cell_of_row(n, lattice.shape, RowOrder::C);
        let at = x + nx * (y + ny * z);
        match &lattice.values {
            Values::Bool(v) => bytes.push(u8::from(v[at])),
            Values::Number(v) if descr == "<i8" => bytes.extend((v[at] as i64).to_le_bytes()),
            Values::Number(v) => bytes.extend(v[at].to_le_bytes()),
        }
    }
    bytes
}

/// Reads a three-dimensional array of booleans, integers or floats of 1 to 8 bytes, either byte order and either storage order; its unit
/// is 1 and its first cell stands at the origin, as the format says neither. Values with more than six digits keep them when written as
/// text.
///
/// # Errors
/// [`NpyError`]: not the format, another number of dimensions or type, a file that is cut, values that no lattice holds.
pub fn read_npy(bytes: &[u8], source: &str) -> Result<Lattice, NpyError> {
    let (head, values) = split(bytes, source)?;
    let array =
        |key, found: &str, expected| NpyError::Array { file: source.into(), key, found: found.into(), expected };
    let descr = value_of(head, "descr").ok_or_else(|| format_error(source, "no 'descr' in its head"))?;
    let (little, kind, size) = kind(descr)
        .ok_or_else(|| array("descr", descr, "'|b1', or integers or floats such as '<i8', '|u1', '<f4', '<f8'"))?;
    let order = match value_of(head, "fortran_order") {
        Some("False") => RowOrder::C,
        Some("True") => RowOrder::F,
        other => return Err(array("fortran_order", other.unwrap_or("missing"), "True or False")),
    };
    let text = value_of(head, "shape").unwrap_or("missing");
    let shape = shape(text).ok_or_else(|| array("shape", text, "three sizes from 1, at most 2^28 cells"))?;
    let count: usize = shape.iter().product();
    if values.len() != count * size {
        return Err(NpyError::Length { file: source.into(), found: values.len(), expected: count * size, shape });
    }
    let [nx, ny, _] = shape;
    let mut cells = vec![0.0; count];
    let mut style = Style::default();
    // Numbers are spelled in the order of the rows of a text, which is C order.
    let mut spelled: Vec<(usize, String)> = Vec::new();
    for (n, raw) in values.chunks_exact(size).enumerate() {
        let cell @ [x, y, z] = cell_of_row(n, shape, order);
        let value = number(raw, little, kind);
        let is_fine = value.is_finite() && value.abs() <= MOST && (kind != 'b' || value == 0.0 || value == 1.0);
        if !is_fine {
            return Err(NpyError::Value { file: source.into(), cell, found: value.to_string() });
        }
        if kind == 'f' && spell(value).parse() != Ok(value) {
            spelled.push((z + shape[2] * (y + ny * x), format!("{value:?}")));
        }
        cells[x + nx * (y + ny * z)] = value;
    }
    spelled.sort_unstable();
    style.spelled = spelled;
    let values = match kind {
        'b' => Values::Bool(cells.iter().map(|v| *v == 1.0).collect()),
        _ => Values::Number(cells),
    };
    Ok(Lattice { shape, minbound: [0.0; 3], unit: [1.0; 3], values, style })
}

fn format_error(source: &str, found: &str) -> NpyError {
    NpyError::Format { file: source.into(), found: found.into() }
}

/// The text of the head and the bytes of the values.
fn split<'b>(bytes: &'b [u8], source: &str) -> Result<(&'b str, &'b [u8]), NpyError> {
    let fault = |found: &str| format_error(source, found);
    let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| fault("does not begin with \\x93NUMPY"))?;
    let (length, rest) = match rest {
        [1, _, a, b, rest @ ..] => (usize::from(u16::from_le_bytes([*a, *b])), rest),
        [2 | 3, _, a, b, c, d, rest @ ..] => (u32::from_le_bytes([*a, *b, *c, *d]) as usize, rest),
        [version, _, ..] => return Err(fault(&format!("version {version} of the format"))),
        _ => return Err(fault("ends within its head")),
    };
    let head = rest.get(..length).ok_or_else(|| fault("ends within its head"))?;
    let head = std::str::from_utf8(head).map_err(|_| fault("a head that is no text"))?;
    Ok((head, &rest[length..]))
}

/// The value of a key of the head, which is a Python dictionary: a quoted text without its quotes, a word, or a tuple with its brackets.
fn value_of<'h>(head: &'h str, key: &str) -> Option<&'h str> {
    let quoted = ['\'', '"'].iter().find_map(|q| head.split_once(&format!("{q}{key}{q}")));
    let value = quoted?.1.trim_start().strip_prefix(':')?.trim_start();
    match value.chars().next()? {
        quote @ ('\'' | '"') => value[1..].split(quote).next(),
        '(' => value.find(')').map(|end| &value[..=end]),
        _ => value.split([',', '}']).next().map(str::trim),
    }
}

/// Byte order, kind (b, i, u, f) and size of a type.
fn kind(descr: &str) -> Option<(bool, char, usize)> {
    let mut letters = descr.chars();
    let (order, kind) = (letters.next()?, letters.next()?);
    let size = letters.as_str().parse().ok()?;
    let known = match kind {
        'b' => size == 1,
        'i' | 'u' => matches!(size, 1 | 2 | 4 | 8),
        'f' => matches!(size, 4 | 8),
        _ => false,
    };
    (known && matches!(order, '<' | '>' | '|' | '=')).then_some((order != '>', kind, size))
}

fn shape(text: &str) -> Option<[usize; 3]> {
    let inner = text.strip_prefix('(')?.strip_suffix(')')?;
    let sizes: Option<Vec<usize>> = inner.trim_end_matches(',').split(',').map(|n| n.trim().parse().ok()).collect();
    let shape = <[usize; 3]>::try_from(sizes?).ok()?;
    let count = shape.iter().try_fold(1usize, |n, s| n.checked_mul(*s))?;
    (count > 0 && count <= MOST_CELLS).then_some(shape)
}

/// A value of 1 to 8 bytes.
fn number(raw: &[u8], little: bool, kind: char) -> f64 {
    let mut bytes = [0; 8];
    let size = raw.len();
    bytes[..size].copy_from_slice(raw);
    if !little {
        bytes[..size].reverse();
    }
    let bits = u64::from_le_bytes(bytes);
    // Shifting up and down again carries the sign of a shorter integer.
    let free = 64 - 8 * size as u32;
    match (kind, size) {
        ('f', 4) => f64::from(f32::from_bits(bits as u32)),
        ('f', _) => f64::from_bits(bits),
        ('i', _) => ((bits << free) as i64 >> free) as f64,
        _ => bits as f64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(values: Values) -> Lattice {
        Lattice::new([2, 1, 3], [0.0; 3], [1.0; 3], values).expect("six values")
    }

    /// The head as numpy 2 writes it, and values in C order.
    #[test]
    fn heads_are_those_of_numpy() {
        let bytes = write_npy(&lattice(Values::Number(vec![0.0, 1.0, 2.0, 3.0, 4.0, -5.0])));
        assert_eq!(bytes.len(), 128 + 48);
        let head = "{'descr': '<i8', 'fortran_order': False, 'shape': (2, 1, 3), }";
        assert!(bytes[10..].starts_with(head.as_bytes()) && bytes[127] == b'\n');
        assert_eq!(&bytes[..10], b"\x93NUMPY\x01\x00\x76\x00");
        // x fastest in memory, z fastest in the file.
        let values: Vec<i64> = bytes[128..].chunks(8).map(|c| i64::from_le_bytes(c.try_into().expect("8"))).collect();
        assert_eq!(values, [0, 2, 4, 1, 3, -5]);
    }

    #[test]
    fn both_orders_and_all_types_are_read() {
        let head = |descr: &str, fortran: &str| {
            let text = format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': (2, 1, 3), }}\n");
            [MAGIC, &[2, 0], &(text.len() as u32).to_le_bytes(), text.as_bytes()].concat()
        };
        let read = |mut bytes: Vec<u8>, values: &[u8]| {
            bytes.extend(values);
            read_npy(&bytes, "a.npy").map(|l| l.values)
        };
        let expected = Values::Number(vec![0.0, 1.0, 2.0, 3.0, 4.0, 250.0]);
        assert_eq!(read(head("|u1", "True"), &[0, 1, 2, 3, 4, 250]), Ok(expected.clone()));
        assert_eq!(read(head("|u1", "False"), &[0, 2, 4, 1, 3, 250]), Ok(expected));
        let big: Vec<u8> = [-1i16, 0, 300, 4, 5, 6].iter().flat_map(|v| v.to_be_bytes()).collect();
        assert_eq!(read(head(">i2", "True"), &big), Ok(Values::Number(vec![-1.0, 0.0, 300.0, 4.0, 5.0, 6.0])));
        assert_eq!(
            read(head("|b1", "True"), &[1, 0, 0, 1, 0, 1]),
            Ok(Values::Bool([1, 0, 0, 1, 0, 1].map(|b| b == 1).to_vec()))
        );
        assert!(matches!(read(head("|b1", "True"), &[2, 0, 0, 1, 0, 1]), Err(NpyError::Value { cell: [0, 0, 0], .. })));
        assert!(matches!(read(head("|u1", "True"), &[0, 1, 2]), Err(NpyError::Length { found: 3, expected: 6, .. })));
        assert!(matches!(read(head("<c16", "True"), &[]), Err(NpyError::Array { key: "descr", .. })));
        let nan: Vec<u8> = [f32::NAN; 6].iter().flat_map(|v| v.to_le_bytes()).collect();
        assert!(matches!(read(head("<f4", "True"), &nan), Err(NpyError::Value { .. })));
        assert!(matches!(read_npy(b"PK\x03\x04", "a.npz"), Err(NpyError::Format { .. })));
    }
}
