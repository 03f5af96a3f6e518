//! Our own voxel file, `houscaper.voxels/1`: JSON with the labels as rows of digits, one line per row.
//!
//! `layers[z][y]` is a string whose character x is the code of voxel (x, y, z); the codes are those of `labels`, which the
//! file states because other programs number them differently. `zones`, when there, has the same layers with zone ids
//! between blanks (-1 = none).

use std::collections::BTreeMap;
use std::fmt::Write;

use serde::Deserialize;

use super::{House, Label, Module, Stair, VoxelArray};

/// The schema this module writes and reads.
pub const SCHEMA: &str = "houscaper.voxels/1";

/// What is wrong with a voxel file.
#[derive(Debug, thiserror::Error)]
pub enum JsonError {
    /// No JSON, an unknown or missing key, or a value of the wrong type.
    #[error("{file}:{line}:{column}: {message}; see the keys of a file we write")]
    Syntax {
        /// Name of the source.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What the parser says.
        message: String,
    },
    /// A key whose value cannot be.
    #[error("{file}: {key} is {found}, expected {expected}")]
    Value {
        /// Name of the source.
        file: String,
        /// Path of the key.
        key: String,
        /// Value found.
        found: String,
        /// What should stand there.
        expected: String,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    schema: String,
    unit: String,
    up_axis: String,
    module_size: [f64; 3],
    labels: BTreeMap<String, u8>,
    corner_order: String,
    origin: [f64; 3],
    shape: [usize; 3],
    layers: Vec<Vec<String>>,
    #[serde(default)]
    stairs: Vec<Stair>,
    #[serde(default)]
    zones: Option<Vec<Vec<String>>>,
}

/// Reads a house from `houscaper.voxels/1`; `source` names it in errors.
///
/// ```
/// use houscaper::voxels::{json, samples};
/// let house = samples::hip_house();
/// let text = json::write(&house);
/// assert_eq!(json::read(text.as_bytes(), "hip.json")?, house);
/// # Ok::<(), json::JsonError>(())
/// ```
///
/// # Errors
/// Bad JSON, unknown keys, another schema, unit or axis, ragged layers, characters that are no label, zones that do not fit.
pub fn read(bytes: &[u8], source: &str) -> Result<House, JsonError> {
    let file: File = serde_json::from_slice(bytes).map_err(|e| JsonError::Syntax {
        file: source.into(),
        line: e.line(),
        column: e.column(),
        message: e.to_string(),
    })?;
    let context = Context { source };
    context.fixed("schema", &file.schema, &[SCHEMA])?;
    context.fixed("unit", &file.unit, &["m"])?;
    context.fixed("up_axis", &file.up_axis, &["z"])?;
    context.fixed("corner_order", &file.corner_order, &["f_order", "box_corners"])?;
    if !file.module_size.iter().all(|s| s.is_finite() && *s > 0.0) {
        return Err(context.value(
            "module_size",
            &format!("{:?}", file.module_size),
            "three lengths above 0, in metres",
        ));
    }
    let [nx, ny, nz] = file.shape;
    if let Some((n, stair)) =
        file.stairs.iter().enumerate().find(|(_, s)| s.start[0] >= nx || s.start[1] >= ny || s.storey >= nz)
    {
        let found = format!("in storey {} at {:?}", stair.storey, stair.start);
        return Err(context.value(&format!("stairs[{n}]"), &found, "a storey and a start cell inside `shape`"));
    }
    let codes = context.codes(&file.labels)?;
    let count = context.count(file.shape)?;
    context.layers("layers", &file.layers, file.shape)?;
    let mut labels = Vec::with_capacity(count);
    for (z, y, row) in rows(&file.layers) {
        let before = labels.len();
        for digit in row.chars() {
            let label = digit.to_digit(10).and_then(|d| *codes.get(d as usize)?);
            labels.push(label.ok_or_else(|| {
                context.value(
                    &format!("layers[{z}][{y}]"),
                    &format!("`{row}`"),
                    "one digit per voxel, each a code of `labels`",
                )
            })?);
        }
        context.length(&format!("layers[{z}][{y}]"), labels.len() - before, file.shape[0], "digits")?;
    }
    let zones = match &file.zones {
        Some(layers) => context.zones(layers, file.shape, count)?,
        None => Vec::new(),
    };
    let Some(mut voxels) = VoxelArray::from_labels(file.shape, labels) else {
        return Err(context.value("layers", "of another size", "nx ny nz labels"));
    };
    voxels.module = Module { size_m: file.module_size };
    voxels.origin_m = file.origin;
    Ok(House { voxels, stairs: file.stairs, zones })
}

/// Rows with their layer and place, in storage order.
fn rows(layers: &[Vec<String>]) -> impl Iterator<Item = (usize, usize, &str)> {
    layers.iter().enumerate().flat_map(|(z, l)| l.iter().enumerate().map(move |(y, row)| (z, y, row.as_str())))
}

struct Context<'s> {
    source: &'s str,
}

impl Context<'_> {
    fn value(&self, key: &str, found: &str, expected: &str) -> JsonError {
        let (file, key) = (self.source.to_string(), key.to_string());
        JsonError::Value { file, key, found: found.to_string(), expected: expected.to_string() }
    }

    fn fixed(&self, key: &str, found: &str, allowed: &[&str]) -> Result<(), JsonError> {
        if allowed.contains(&found) {
            return Ok(());
        }
        Err(self.value(key, &format!("\"{found}\""), &format!("\"{}\"", allowed.join("\" or \""))))
    }

    fn length(&self, key: &str, found: usize, expected: usize, what: &str) -> Result<(), JsonError> {
        if found == expected {
            return Ok(());
        }
        Err(self.value(key, &format!("{found} {what} long"), &format!("{expected} {what}, as `shape` says")))
    }

    /// The label of each code the file uses.
    fn codes(&self, labels: &BTreeMap<String, u8>) -> Result<[Option<Label>; 10], JsonError> {
        let mut codes = [None; 10];
        for label in Label::ALL {
            let code = labels.get(label.name()).copied().filter(|c| *c < 10 && codes[*c as usize].is_none());
            let Some(code) = code else {
                let key = format!("labels.{}", label.name());
                let found = labels.get(label.name()).map_or("missing".into(), u8::to_string);
                return Err(self.value(&key, &found, "a code of its own from 0 to 9"));
            };
            codes[code as usize] = Some(label);
        }
        match labels.keys().find(|k| Label::ALL.iter().all(|l| l.name() != k.as_str())) {
            Some(key) => Err(self.value(
                &format!("labels.{key}"),
                "unknown",
                "empty, base, floor, foundation, opening or window",
            )),
            None => Ok(codes),
        }
    }

    fn count(&self, shape: [usize; 3]) -> Result<usize, JsonError> {
        let count = shape.iter().try_fold(1usize, |n, s| n.checked_mul(*s)).filter(|n| *n > 0 && *n <= 1 << 28);
        count.ok_or_else(|| self.value("shape", &format!("{shape:?}"), "three whole numbers from 1"))
    }

    fn layers(&self, key: &str, layers: &[Vec<String>], shape: [usize; 3]) -> Result<(), JsonError> {
        self.length(key, layers.len(), shape[2], "layers")?;
        layers.iter().enumerate().try_for_each(|(z, l)| self.length(&format!("{key}[{z}]"), l.len(), shape[1], "rows"))
    }

    fn zones(&self, layers: &[Vec<String>], shape: [usize; 3], count: usize) -> Result<Vec<i32>, JsonError> {
        self.layers("zones", layers, shape)?;
        let mut zones = Vec::with_capacity(count);
        for (z, y, row) in rows(layers) {
            let key = || format!("zones[{z}][{y}]");
            let before = zones.len();
            for id in row.split_whitespace() {
                let id = id.parse().ok().filter(|id: &i32| *id >= -1);
                zones.push(
                    id.ok_or_else(|| self.value(&key(), &format!("`{row}`"), "zone ids from -1 between blanks"))?,
                );
            }
            self.length(&key(), zones.len() - before, shape[0], "ids")?;
        }
        Ok(zones)
    }
}

/// A house as `houscaper.voxels/1`, ending with a newline. `corner_order` is the order of cube ids in files beside it.
pub fn write(house: &House) -> String {
    let voxels = &house.voxels;
    let labels: Vec<String> = Label::ALL.iter().map(|l| format!("\"{}\": {}", l.name(), l.code())).collect();
    let mut text = format!("{{\n  \"schema\": \"{SCHEMA}\",\n  \"unit\": \"m\",\n  \"up_axis\": \"z\",\n");
    // Writing to a String cannot fail.
    let _ = writeln!(text, "  \"module_size\": {:?},", voxels.module.size_m);
    let _ = writeln!(text, "  \"labels\": {{{}}},", labels.join(", "));
    let _ = writeln!(text, "  \"corner_order\": \"f_order\",");
    let _ = writeln!(text, "  \"origin\": {:?},", voxels.origin_m);
    let _ = writeln!(text, "  \"shape\": {:?},", voxels.shape());
    write_layers(&mut text, "layers", voxels.shape(), |at| (b'0' + voxels.labels()[at].code()) as char, "");
    if !house.stairs.is_empty() {
        let stairs: Vec<String> = house.stairs.iter().map(stair_line).collect();
        let _ = write!(text, ",\n  \"stairs\": [\n    {}\n  ]", stairs.join(",\n    "));
    }
    if house.zones.len() == voxels.labels().len() && !house.zones.is_empty() {
        text.push_str(",\n");
        write_layers(&mut text, "zones", voxels.shape(), |at| house.zones[at], " ");
    }
    text.push_str("\n}\n");
    text
}

fn write_layers<T: ToString>(
    text: &mut String,
    key: &str,
    [nx, ny, nz]: [usize; 3],
    cell: impl Fn(usize) -> T,
    between: &str,
) {
    let _ = writeln!(text, "  \"{key}\": [");
    for z in 0..nz {
        text.push_str("    [");
        for y in 0..ny {
            let row: Vec<String> = (0..nx).map(|x| cell(x + nx * (y + ny * z)).to_string()).collect();
            let _ = write!(text, "\"{}\"{}", row.join(between), if y + 1 < ny { ",\n     " } else { "" });
        }
        text.push_str(if z + 1 < nz { "],\n" } else { "]\n" });
    }
    text.push_str("  ]");
}

fn stair_line(stair: &Stair) -> String {
    // A struct of numbers and names always serialises.
    serde_json::to_string(stair).unwrap_or_default().replace("\":", "\": ").replace(",\"", ", \"")
}
