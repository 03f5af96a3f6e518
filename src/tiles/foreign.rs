//! Reading manifests of schema `houscaper.architectural-tiles/1`, as the thesis author's tools write them, into ours.
//!
//! Keys are looked up whatever their spelling (`moduleSize`, `module_size`) and nesting (`source.unit`, `sourceUnit`), because files
//! of that schema differ in it. What is missing or makes no sense is listed, never guessed silently.

use super::axes::{AxisMap, Pivot, UNITS};
use super::entry::{TileEntry, TileSymmetry};
use super::layer::{Layer, LayerKind};
use super::manifest::{Manifest, SCHEMA, TilesetKind, label_table};
use super::{Component, TilesetError};
use crate::cubes::CornerOrder;
use serde_json::Value;
use std::path::Path;

/// The schema read here.
pub const FOREIGN_SCHEMA: &str = "houscaper.architectural-tiles/1";

/// Prefixes of OBJ groups and the component they become; the longest that fits wins, so `floor_band_1` is no floor. Groups with
/// none of them are reported.
pub const GROUP_PREFIXES: &[(&str, Component)] = &[
    ("arc_frame", Component::WindowFrame),
    ("arc_glass", Component::Glass),
    ("arc_door_frame", Component::DoorFrame),
    ("arc_door", Component::DoorLeaf),
    ("arc_sill", Component::Sill),
    ("arc_reveal", Component::Reveal),
    ("arc_railing", Component::RailingRail),
    ("frame", Component::WindowFrame),
    ("glass", Component::Glass),
    ("door", Component::DoorLeaf),
    ("wall", Component::WallInsulation),
    ("wall_lining", Component::WallLining),
    ("cladding", Component::Cladding),
    ("floor", Component::FloorStructure),
    ("floor_band", Component::Band),
    ("ceiling", Component::Ceiling),
    ("foundation", Component::GroundSlab),
    ("roof", Component::RoofInsulation),
    ("roof_covering", Component::RoofCovering),
    ("railing", Component::RailingRail),
    ("stair", Component::StairTread),
    ("deck", Component::DeckBoards),
];

/// The manifest of a text of that schema as one of ours, and what is wrong with it; `None` for any other text.
pub fn convert(text: &str, path: &Path) -> Option<(Manifest, Vec<TilesetError>)> {
    let json: Value = serde_json::from_str(text).ok()?;
    (json.get("schema")?.as_str()? == FOREIGN_SCHEMA).then(|| {
        let mut reader = Reader { path, mistakes: Vec::new() };
        let manifest = reader.manifest(&json);
        (manifest, reader.mistakes)
    })
}

struct Reader<'a> {
    path: &'a Path,
    mistakes: Vec<TilesetError>,
}

/// A key without its spelling.
fn plain(key: &str) -> String {
    key.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// The value of the first of the names (lower case, dots between nested keys) that an object has.
fn lookup<'v>(json: &'v Value, names: &[&str]) -> Option<&'v Value> {
    fn nested<'v>(json: &'v Value, path: &[&str]) -> Option<&'v Value> {
        let Some((first, rest)) = path.split_first() else { return Some(json) };
        let (_, value) = json.as_object()?.iter().find(|(key, _)| plain(key) == *first)?;
        nested(value, rest)
    }
    names.iter().find_map(|name| {
        let path: Vec<&str> = name.split('.').collect();
        nested(json, &path).or_else(|| nested(json, &[&path.concat()])).filter(|v| !v.is_null())
    })
}

fn numbers(value: &Value) -> Option<[f64; 3]> {
    if let Some(list) = value.as_array() {
        let list: Vec<f64> = list.iter().filter_map(Value::as_f64).collect();
        return list.try_into().ok();
    }
    let part = |name: &str| lookup(value, &[name])?.as_f64();
    Some([part("x")?, part("y")?, part("z")?])
}

impl Reader<'_> {
    fn wrong(&mut self, key: &str, problem: impl Into<String>) {
        self.mistakes.push(TilesetError::Foreign { path: self.path.into(), key: key.into(), problem: problem.into() });
    }

    fn text(&mut self, json: &Value, key: &str, names: &[&str], otherwise: &str) -> String {
        match lookup(json, names).and_then(Value::as_str) {
            Some(text) => text.to_owned(),
            None => {
                self.wrong(key, format!("is missing; \"{otherwise}\" is assumed"));
                otherwise.to_owned()
            }
        }
    }

    fn unit(&mut self, json: &Value, key: &str, names: &[&str], otherwise: &str) -> String {
        let text = self.text(json, key, names, otherwise).to_lowercase();
        let unit = match text.as_str() {
            "millimetre" | "millimeter" | "millimetres" | "millimeters" => "mm",
            "centimetre" | "centimeter" | "centimetres" | "centimeters" => "cm",
            "metre" | "meter" | "metres" | "meters" => "m",
            "in" | "inches" => "inch",
            other => other,
        };
        if UNITS.iter().any(|(name, _)| *name == unit) {
            return unit.to_owned();
        }
        self.wrong(key, format!("is \"{text}\", expected mm, cm, m or inch; \"{otherwise}\" is assumed"));
        otherwise.to_owned()
    }

    fn manifest(&mut self, json: &Value) -> Manifest {
        let source_unit = self.unit(json, "source.unit", &["source.unit", "unit"], "mm");
        let source_up = self.text(json, "source.upAxis", &["source.upaxis", "upaxis"], "z").to_lowercase();
        let web_unit = self.unit(json, "web.unit", &["web.unit"], "m");
        let transform =
            self.text(json, "web.axisTransform", &["web.axistransform", "axistransform", "web.axes"], "x,z,-y");
        let to_mm = |unit: &str| UNITS.iter().find(|(name, _)| *name == unit).map_or(1.0, |(_, mm)| *mm);
        if AxisMap::parse(&source_up).is_none() {
            self.wrong("source.upAxis", format!("is \"{source_up}\", expected z or y"));
        }
        if AxisMap::parse(&transform).is_none() {
            self.wrong("web.axisTransform", format!("is \"{transform}\", expected three axes such as x,z,-y"));
        }
        // The files are the designer's unless the manifest says that they were written for the web.
        let web = lookup(json, &["coordinates", "files"]).and_then(Value::as_str) == Some("web");
        let [unit, up_axis] = if web { [web_unit, transform] } else { [source_unit.clone(), source_up] };
        let ratio = to_mm(&source_unit) / to_mm(&unit);
        let module_size = match lookup(json, &["modulesize", "module"]).and_then(numbers) {
            Some(size) => size.map(|v| v * ratio),
            None => {
                self.wrong("moduleSize", "is missing or not three lengths; 900 x 900 x 540 mm is assumed");
                [900.0, 900.0, 540.0].map(|mm| mm / to_mm(&unit))
            }
        };
        let order = self.corner_order(json);
        let mut overhang: f64 = 0.0;
        let mut tiles: Vec<(String, i64, TileEntry)> = Vec::new();
        let entries = lookup(json, &["tiles"]).and_then(Value::as_array);
        if entries.is_none_or(Vec::is_empty) {
            self.wrong("tiles", "is missing or empty; nothing can be looked up");
        }
        for (n, tile) in entries.into_iter().flatten().enumerate() {
            let Some((variant, entry)) = self.tile(tile, n, order, ratio) else { continue };
            if let Some(size) = lookup(tile, &["size"]).and_then(numbers) {
                let beyond = (0..3).map(|a| size[a] * ratio - module_size[a]).fold(0.0, f64::max);
                overhang = overhang.max(beyond);
            } else {
                self.wrong(&format!("size of tile {}", entry.name), "is missing; the module's is assumed");
            }
            tiles.push((entry.pattern.clone(), variant, entry));
        }
        Manifest {
            schema: SCHEMA.into(),
            name: lookup(json, &["name"]).and_then(Value::as_str).unwrap_or("architectural-tiles").into(),
            description: format!("Converted from {FOREIGN_SCHEMA}."),
            kind: TilesetKind::Solids,
            unit,
            up_axis,
            pivot: Pivot::default(),
            module_size,
            corner_order: CornerOrder::FOrder.name().into(),
            labels: label_table(),
            root: None,
            layers: layers(overhang),
            tiles: merged(tiles),
            numbered: None,
            open_seams: Vec::new(),
        }
    }

    /// The corner that each digit of a signature belongs to.
    fn corner_order(&mut self, json: &Value) -> [usize; 8] {
        let value = lookup(json, &["cornerorder"]);
        if let Some(name) = value.and_then(Value::as_str) {
            match plain(name).as_str() {
                "forder" | "xyz" => return CornerOrder::FOrder.corners(),
                "boxcorners" | "rhino" => return CornerOrder::BoxCorners.corners(),
                _ => {}
            }
        }
        let corner = |v: &Value| -> Option<usize> {
            let bits: Vec<u64> = match v {
                Value::String(s) => s.chars().map(|c| c.to_digit(2).map(u64::from)).collect::<Option<_>>()?,
                _ => v.as_array()?.iter().map(Value::as_u64).collect::<Option<_>>()?,
            };
            match bits[..] {
                [x @ 0..=1, y @ 0..=1, z @ 0..=1] => Some((x + 2 * y + 4 * z) as usize),
                _ => None,
            }
        };
        let listed = value.and_then(Value::as_array).and_then(|l| l.iter().map(corner).collect::<Option<Vec<_>>>());
        if let Some(order) = listed.and_then(|l| <[usize; 8]>::try_from(l).ok())
            && (0..8).all(|c| order.contains(&c))
        {
            return order;
        }
        let found = value.map_or("missing".into(), ToString::to_string);
        let expected = "expected f_order, box_corners or eight corners such as [0,0,0]; box_corners is assumed";
        self.wrong("cornerOrder", format!("is {found}, {expected}"));
        CornerOrder::BoxCorners.corners()
    }

    /// Variant number and entry of a tile; `None` when it cannot be used at all.
    fn tile(&mut self, tile: &Value, n: usize, order: [usize; 8], ratio: f64) -> Option<(i64, TileEntry)> {
        let id = lookup(tile, &["id", "name"]).map(|v| v.as_str().map_or_else(|| v.to_string(), str::to_owned));
        let name = id.unwrap_or_else(|| {
            self.wrong(&format!("tiles[{n}].id"), "is missing; the tile's place in the list is its name");
            format!("tile-{n}")
        });
        let file = lookup(tile, &["file"]).and_then(Value::as_str);
        if file.is_none() {
            self.wrong(&format!("file of tile {name}"), "is missing; its configuration has no tile");
        }
        let signature = lookup(tile, &["signature"]).map(|v| v.as_str().map_or_else(|| v.to_string(), str::to_owned));
        let digits: Option<[char; 8]> = signature.as_ref().and_then(|s| s.chars().collect::<Vec<_>>().try_into().ok());
        let Some(digits) = digits.filter(|d| d.iter().all(|c| ('0'..='5').contains(c))) else {
            let found = signature.map_or("is missing".into(), |s| format!("is \"{s}\""));
            self.wrong(&format!("signature of tile {name}"), format!("{found}, expected eight digits 0 to 5"));
            return None;
        };
        let mut pattern = ['0'; 8];
        for (digit, corner) in digits.into_iter().zip(order) {
            pattern[corner] = digit;
        }
        let pivot = match lookup(tile, &["pivot"]) {
            None => {
                self.wrong(&format!("pivot of tile {name}"), "is missing; the cube's first corner is assumed");
                None
            }
            Some(Value::String(s)) => Some(Pivot::Named(match plain(s).as_str() {
                "center" | "centre" => "centre".into(),
                "basecenter" | "basecentre" => "base_centre".into(),
                "corner" | "origin" | "min" => "corner".into(),
                _ => {
                    self.wrong(&format!("pivot of tile {name}"), format!("is \"{s}\"; the first corner is assumed"));
                    "corner".into()
                }
            })),
            Some(at) => match numbers(at) {
                Some(at) => Some(Pivot::At(at.map(|v| v * ratio))),
                None => {
                    self.wrong(&format!("pivot of tile {name}"), "is no point; the cube's first corner is assumed");
                    None
                }
            },
        };
        let variant = lookup(tile, &["variant"]).and_then(Value::as_i64).unwrap_or(0);
        let entry = TileEntry {
            name,
            pattern: pattern.iter().collect(),
            symmetry: TileSymmetry::default(),
            file: file?.to_owned(),
            variants: Vec::new(),
            priority: 0,
            pivot,
        };
        Some((variant, entry))
    }
}

/// Tiles of one signature become one entry with variants, if they have one pivot; others stay and are reported as duplicates.
fn merged(mut tiles: Vec<(String, i64, TileEntry)>) -> Vec<TileEntry> {
    tiles.sort_by(|a, b| (&a.0, a.1).cmp(&(&b.0, b.1)));
    let mut entries: Vec<TileEntry> = Vec::new();
    let mut last = i64::MIN;
    for (pattern, variant, entry) in tiles {
        match entries.last_mut() {
            Some(first) if first.pattern == pattern && first.pivot == entry.pivot && variant != last => {
                first.variants.push(entry.file);
            }
            _ => entries.push(entry),
        }
        last = variant;
    }
    entries
}

/// A layer for each component of [`GROUP_PREFIXES`].
fn layers(overhang: f64) -> Vec<Layer> {
    let mut layers: Vec<Layer> = Vec::new();
    for &(prefix, component) in GROUP_PREFIXES {
        let group = format!("{prefix}*");
        match layers.iter_mut().find(|l| l.component == Some(component)) {
            Some(layer) => layer.groups.push(group),
            None => layers.push(Layer {
                name: component.name().into(),
                kind: LayerKind::Solid,
                overhang,
                component: Some(component),
                groups: vec![group],
            }),
        }
    }
    layers
}
