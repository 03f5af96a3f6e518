//! One house of the page: its figures, and its files deflated.

use std::collections::BTreeMap;
use std::io::Write as _;

use base64::prelude::{BASE64_STANDARD, Engine};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use serde::Serialize;
use serde_json::{Value, json};

use super::texts::{HouseTexts, of_house};
use super::{Folder, ReportError, Rows};

/// Files of a house that the page opens, beside its drawings.
const FILES: [&str; 6] = ["house.glb", "frame.glb", "quote.html", "structure.html", "carbon.html", "bom.csv"];

/// What `structure.json` says that the page compares; the rest is on the structure's own page.
const STRUCTURE: [&str; 13] = [
    "verdict",
    "reason",
    "governing",
    "utilisation",
    "sway_ratio",
    "deflection_ratio",
    "racking_ratio",
    "vibration",
    "thesis",
    "uplift_kn",
    "stability",
    "load_path",
    "sections",
];

/// What `quote.json` says that the page compares.
const QUOTE: [&str; 8] = [
    "reference",
    "issued",
    "currency",
    "price_eur",
    "total",
    "complete_house",
    "complete_house_per_m2",
    "floor_area_m2",
];

/// A house as the page shows it before it is chosen.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct HouseReport {
    /// Its evaluation; 0 for a built house.
    pub id: u64,
    /// Objectives and design variables by column, exactly as the table has them.
    pub cells: BTreeMap<String, Value>,
    /// Every figure of the evaluation, by the name of its objective.
    pub figures: Value,
    /// Glass by direction (east, north, west, south), zones, storeys, as the model carries them.
    pub model: Value,
    /// A part of `structure.json`; null without it.
    pub structure: Value,
    /// A part of `quote.json`; null without it.
    pub quote: Value,
    /// The bill by group, in its order.
    pub bill: Vec<BillGroup>,
    /// The factory parts; `None` without `parts.csv`.
    pub parts: Option<PartsCount>,
    /// The choices of material and section, by name.
    pub choices: Value,
    /// Names of the files in the page.
    pub files: Vec<String>,
    /// Whether the page has its picture.
    pub has_picture: bool,
}

/// The sums of a group of the bill: money in the currency of the price book, masses in kg, carbon in kgCO2e.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct BillGroup {
    /// Its name in `bom.csv`.
    pub group: String,
    /// Low, default, high.
    pub amount: [f64; 3],
    /// Mass.
    pub mass_kg: f64,
    /// Fossil carbon A1-A3.
    pub gwp_kgco2e: f64,
    /// Carbon kept in wood, negative.
    pub biogenic_kgco2e: f64,
}

/// How many parts a factory makes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PartsCount {
    /// All of them.
    pub count: usize,
    /// Up to congruence and mirror.
    pub types: usize,
    /// The heaviest, kg.
    pub heaviest_kg: f64,
}

/// A file of a house inside the page.
#[derive(Clone, Debug, PartialEq)]
pub struct Packed {
    /// Name of the element: `id/file`.
    pub key: String,
    /// Base64 of the file, behind zlib unless it is a picture.
    pub data: String,
}

/// What was read of a house.
pub struct Read {
    /// Its figures.
    pub house: HouseReport,
    /// Its files.
    pub packed: Vec<Packed>,
    /// What it assumes.
    pub texts: HouseTexts,
}

/// Reads the figures of a house, and packs its picture and, where `whole`, its files. `place` is its folder with a `/`, or nothing.
///
/// # Errors
/// [`ReportError`]: a file that cannot be read, or is not what its name says.
pub fn read(folder: &Folder, place: &str, id: u64, whole: bool) -> Result<Read, ReportError> {
    let file = |name: &str| (folder.read)(&format!("{place}{name}"));
    let json = |name: &str| -> Result<Value, ReportError> {
        let source = |source| ReportError::Json { file: format!("{place}{name}"), source };
        file(name)?.map_or(Ok(Value::Null), |bytes| serde_json::from_slice(&bytes).map_err(source))
    };
    let table = |name: &str| -> Result<Option<Rows>, ReportError> {
        file(name)?.map(|bytes| Rows::read(&format!("{place}{name}"), &bytes)).transpose()
    };
    let mut house = HouseReport { id, choices: json("choices.json")?, ..HouseReport::default() };
    let mut packed = Vec::new();
    if let Some(picture) = file("thumb.png")? {
        house.has_picture = true;
        packed.push(Packed { key: format!("{id}/thumb.png"), data: BASE64_STANDARD.encode(picture) });
    }
    let (structure, quote) = (json("structure.json")?, json("quote.json")?);
    let texts = of_house(&structure, &quote, &json("carbon.json")?);
    house.structure = part(&structure, &STRUCTURE);
    house.quote = part(&quote, &QUOTE);
    house.bill = table("bom.csv")?.map_or_else(Vec::new, |rows| bill(&rows));
    house.parts = table("parts.csv")?.map(|rows| parts(&rows));
    let mut names: Vec<String> = FILES.map(str::to_owned).to_vec();
    let mut drawings: Vec<String> =
        (folder.files)(place.trim_end_matches('/'))?.into_iter().filter(|name| name.ends_with(".svg")).collect();
    drawings.sort_by_key(|name| (!name.starts_with("plan"), name.clone()));
    names.extend(drawings);
    for name in names {
        let Some(bytes) = file(&name)? else { continue };
        if name == "house.glb" {
            (house.figures, house.model) = extras(&bytes);
        }
        if whole {
            packed.push(Packed { key: format!("{id}/{name}"), data: BASE64_STANDARD.encode(deflated(&bytes)) });
            house.files.push(name);
        }
    }
    Ok(Read { house, packed, texts })
}

/// Some keys of an object; null of anything else.
fn part(value: &Value, keys: &[&str]) -> Value {
    let Some(map) = value.as_object() else { return Value::Null };
    keys.iter().filter_map(|key| Some(((*key).to_owned(), map.get(*key)?.clone()))).collect()
}

/// Bytes behind zlib, as a browser's `DecompressionStream("deflate")` reads them.
fn deflated(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::with_capacity(bytes.len() / 4), Compression::default());
    // A vector takes every byte: neither can fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}

/// The figures in the extras of a GLB's scene, and what else they say; null where there are none.
fn extras(glb: &[u8]) -> (Value, Value) {
    let chunk = || {
        let length = u32::from_le_bytes(glb.get(12..16)?.try_into().ok()?) as usize;
        let gltf: Value = serde_json::from_slice(glb.get(20..20usize.checked_add(length)?)?).ok()?;
        let extras = gltf.get("scenes")?.get(0)?.get("extras")?;
        let more = ["storeys", "zones_m2", "windows_m2_east_north_west_south", "tileset"];
        Some((extras.get("figures")?.clone(), part(extras, &more)))
    };
    chunk().unwrap_or_default()
}

/// The bill summed by group.
fn bill(rows: &Rows) -> Vec<BillGroup> {
    let mut groups: Vec<BillGroup> = Vec::new();
    for row in 0..rows.count() {
        let name = rows.text(row, "group");
        let at = groups.iter().position(|g| g.group == name).unwrap_or_else(|| {
            groups.push(BillGroup { group: name.to_owned(), ..BillGroup::default() });
            groups.len() - 1
        });
        let number = |column: &str| rows.number(row, column).unwrap_or(0.0);
        let group = &mut groups[at];
        for (sum, column) in group.amount.iter_mut().zip(["amount_low", "amount", "amount_high"]) {
            *sum += number(column);
        }
        group.mass_kg += number("mass_kg");
        group.gwp_kgco2e += number("gwp_kgco2e");
        group.biogenic_kgco2e += number("biogenic_kgco2e");
    }
    groups
}

fn parts(rows: &Rows) -> PartsCount {
    let types: std::collections::BTreeSet<&str> = (0..rows.count()).map(|row| rows.text(row, "type")).collect();
    let heaviest_kg = (0..rows.count()).filter_map(|row| rows.number(row, "mass_kg")).fold(0.0, f64::max);
    PartsCount { count: rows.count(), types: types.len(), heaviest_kg }
}

/// A cell of a table as JSON: a number, a flag, or text.
pub fn cell(text: &str) -> Value {
    match text {
        "" => Value::Null,
        "true" => json!(true),
        "false" => json!(false),
        _ => text.parse::<f64>().ok().filter(|v| v.is_finite()).map_or_else(|| json!(text), |v| json!(v)),
    }
}
