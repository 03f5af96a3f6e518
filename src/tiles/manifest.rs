//! The manifest of a tileset, `tileset.json`: conventions, layers, and which file covers which configurations.

use super::TilesetError;
use super::axes::{Axes, AxisMap, Pivot, UNITS};
use super::entry::{Numbered, TileEntry, numbered_tiles};
use super::layer::{Layer, LayerKind};
use super::pattern::{Digits, Pattern};
use crate::cubes::CornerOrder;
use crate::voxels::Label;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Value of `schema`.
pub const SCHEMA: &str = "houscaper.tileset/1";

/// What a tileset holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TilesetKind {
    /// Polygons: the boundary between filled and empty.
    Surface,
    /// Lines: the skeleton.
    Linear,
    /// Closed bodies of building components, looked up by labels.
    Solids,
    /// No meshes but the choices of a construction; single configurations may be meshes.
    Style,
}

fn is_corner(pivot: &Pivot) -> bool {
    *pivot == Pivot::default()
}

/// `tileset.json` of a set of meshes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// `houscaper.tileset/1`.
    #[schemars(extend("const" = SCHEMA))]
    pub schema: String,
    /// Name of the set.
    pub name: String,
    /// One sentence.
    #[serde(default)]
    pub description: String,
    /// What the OBJ files hold: `surface`, `linear` or `solids`.
    #[schemars(extend("enum" = ["surface", "linear", "solids"]))]
    pub kind: TilesetKind,
    /// `mm`, `cm`, `m`, `inch`, or `cube` (a unit cube; then `module_size` and overhangs are in mm): unit of module, overhangs and files.
    #[schemars(extend("enum" = ["mm", "cm", "m", "inch", "cube"]))]
    pub unit: String,
    /// `z`, `y`, or where the three file axes go in the cube, for example `x,z,-y`.
    pub up_axis: String,
    /// Where in the cube the files' origin is.
    #[serde(default, skip_serializing_if = "is_corner")]
    pub pivot: Pivot,
    /// Edges of a cube along its x, y, z.
    pub module_size: [f64; 3],
    /// `f_order` or `box_corners`: how patterns are read.
    #[schemars(extend("enum" = ["f_order", "box_corners"]))]
    pub corner_order: String,
    /// Meaning of the label codes 0 to 5: each of empty, base, floor, foundation, opening, window once, in any order.
    pub labels: BTreeMap<String, String>,
    /// Folder of the OBJ files, relative to the manifest, when it is not the manifest's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<PathBuf>,
    /// Layers; none declared means one surface layer named `envelope` without overhang.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// The tiles.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tiles: Vec<TileEntry>,
    /// Further tiles, one for each filled configuration, in files named by number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub numbered: Option<Numbered>,
    /// Faces on which tiles of a set of solids are known to show different things and are not compared: the axis and the four labels
    /// of the face in corner order, such as `z 1100`. Slabs end on level faces, for example, and nothing stands on them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub open_seams: Vec<String>,
}

/// The label table that every file of ours states.
pub(super) fn label_table() -> BTreeMap<String, String> {
    Label::ALL.into_iter().map(|l| (l.code().to_string(), l.name().to_string())).collect()
}

/// What is wrong with the conventions that all kinds of manifest share; `wrong` takes key, found and expected.
pub(super) fn check_conventions(
    [schema, unit, corner_order]: [&str; 3],
    labels: &BTreeMap<String, String>,
    mut wrong: impl FnMut(&str, String, String),
) {
    if schema != SCHEMA {
        wrong("schema", format!("\"{schema}\""), format!("\"{SCHEMA}\""));
    }
    if !UNITS.iter().any(|(name, _)| *name == unit) {
        wrong("unit", format!("\"{unit}\""), "\"mm\", \"cm\", \"m\", \"inch\" or \"cube\" (one is one module)".into());
    }
    if CornerOrder::from_name(corner_order).is_none() {
        wrong("corner_order", format!("\"{corner_order}\""), "\"f_order\" or \"box_corners\"".into());
    }
    let mut names: Vec<&str> = labels.values().map(String::as_str).collect();
    names.sort_unstable();
    let mut known = Label::ALL.map(Label::name);
    known.sort_unstable();
    if labels.keys().ne(label_table().keys()) || names != known || labels["0"] != Label::Empty.name() {
        let table = serde_json::to_string(&label_table()).unwrap_or_default();
        wrong("labels", format!("{labels:?}"), format!("{table}, with 1 to 5 in any order, each name once"));
    }
}

impl Manifest {
    /// Parses and checks everything that can be known without the OBJ files; the first mistake is the error.
    pub fn parse(text: &str, path: &Path, kind: TilesetKind) -> Result<Manifest, TilesetError> {
        let (manifest, mistakes) = Manifest::examine(text, path)?;
        if manifest.kind != kind {
            return Err(TilesetError::Value {
                path: path.into(),
                key: "kind".into(),
                found: format!("{:?}", manifest.kind),
                expected: format!("{kind:?}; load the other kind of set here"),
            });
        }
        mistakes.into_iter().next().map_or(Ok(manifest), Err)
    }

    /// Parses a manifest and lists all mistakes of its values; an error when it cannot be understood at all.
    pub fn examine(text: &str, path: &Path) -> Result<(Manifest, Vec<TilesetError>), TilesetError> {
        let mut manifest: Manifest =
            serde_json::from_str(text).map_err(|source| TilesetError::Manifest { path: path.into(), source })?;
        let mistakes = manifest.mistakes(path);
        if let Some(numbered) = manifest.numbered.clone() {
            manifest.tiles.extend(numbered_tiles(&numbered));
        }
        Ok((manifest, mistakes))
    }

    fn mistakes(&self, path: &Path) -> Vec<TilesetError> {
        let mut list = Vec::new();
        let mut wrong = |key: &str, found: String, expected: String| {
            list.push(TilesetError::Value { path: path.into(), key: key.into(), found, expected });
        };
        check_conventions([&self.schema, &self.unit, &self.corner_order], &self.labels, &mut wrong);
        if AxisMap::parse(&self.up_axis).is_none() {
            let expected = "\"z\", \"y\" or where the three file axes go, for example \"x,z,-y\"";
            wrong("up_axis", format!("\"{}\"", self.up_axis), expected.into());
        }
        let pivots = self.tiles.iter().filter_map(|t| Some((format!("pivot of tile {}", t.name), t.pivot.as_ref()?)));
        for (key, pivot) in std::iter::once(("pivot".to_owned(), &self.pivot)).chain(pivots) {
            if pivot.point_mm([1.0; 3], [1.0; 3]).is_none() {
                wrong(&key, format!("{pivot:?}"), "\"corner\", \"centre\", \"base_centre\" or [x, y, z]".into());
            }
        }
        let whole = |mm: f64| (mm - mm.round()).abs() < 1e-3 && (1.0..=1e5).contains(&mm.round());
        if !self.module_size.iter().all(|&v| whole(v * self.to_mm())) {
            let expected = "three positive whole numbers of millimetres up to 100 m";
            wrong("module_size", format!("{:?}", self.module_size), expected.into());
        }
        for (n, layer) in self.layers.iter().enumerate() {
            if !(0.0..=1e5).contains(&(layer.overhang * self.to_mm())) {
                let key = format!("layers[{n}].overhang");
                wrong(&key, layer.overhang.to_string(), "a length from 0 to 100 m".into());
            }
            if self.kind == TilesetKind::Solids && (layer.component.is_none() || layer.kind != LayerKind::Solid) {
                let expected = "kind \"solid\" and a component, because sets of solids are made of components";
                wrong(&format!("layers[{n}]"), format!("layer {} without one", layer.name), expected.into());
            }
        }
        if self.kind == TilesetKind::Solids && self.layers.is_empty() {
            wrong("layers", "none".into(), "at least one layer with a component".into());
        }
        if self.tiles.is_empty() && self.numbered.is_none() {
            wrong("tiles", "none".into(), "at least one tile, or `numbered`".into());
        }
        for tile in self.tiles.iter().filter(|t| t.files().next().is_none()) {
            wrong(&format!("file of tile {}", tile.name), "missing".into(), "an OBJ file".into());
        }
        if let Some(n) = &self.numbered
            && (n.scheme != "topogenesis" || !n.files.contains('#'))
        {
            let expected = "scheme \"topogenesis\" and a file name with # for each digit of the number";
            wrong("numbered", format!("{} {}", n.scheme, n.files), expected.into());
        }
        list
    }

    /// Millimetres in the manifest's unit (1 for `cube`, whose lengths are in mm, and for an unknown unit).
    pub fn to_mm(&self) -> f64 {
        UNITS.iter().find(|(name, _)| *name == self.unit).map_or(1.0, |(_, mm)| *mm)
    }

    /// Edges of a cube in mm.
    pub fn module_mm(&self) -> [i32; 3] {
        self.module_size.map(|v| (v * self.to_mm()).round() as i32)
    }

    /// How the files of a tile are read. Values that [`Manifest::examine`] finds wrong are taken as z up and corner.
    pub fn axes(&self, tile: &TileEntry) -> Axes {
        let module = self.module_mm().map(f64::from);
        let scale = if self.unit == "cube" { module } else { [self.to_mm(); 3] };
        let pivot = tile.pivot.as_ref().unwrap_or(&self.pivot);
        Axes {
            map: AxisMap::parse(&self.up_axis).unwrap_or(AxisMap::Z_UP),
            scale,
            origin_mm: pivot.point_mm(module, scale).unwrap_or_default(),
        }
    }

    /// The folder of the OBJ files of a manifest in `dir`.
    pub fn folder(&self, dir: &Path) -> PathBuf {
        self.root.as_ref().map_or_else(|| dir.to_path_buf(), |root| dir.join(root))
    }

    /// The pattern of a tile.
    pub(super) fn pattern(&self, tile: &TileEntry, path: &Path) -> Result<Pattern, TilesetError> {
        let order = CornerOrder::from_name(&self.corner_order).unwrap_or_default();
        let (digits, expected) = match self.kind {
            TilesetKind::Surface | TilesetKind::Linear => {
                (Digits::Occupancy, "eight digits 0 or 1 (or * filled, . any), one per corner")
            }
            TilesetKind::Solids | TilesetKind::Style => (
                Digits::Labels(&self.labels),
                "eight entries, one per corner: a digit 0 to 5, a set such as [15], * for any filled label or . for any",
            ),
        };
        Pattern::parse(&tile.pattern, order, digits).ok_or_else(|| TilesetError::Value {
            path: path.into(),
            key: format!("pattern of tile {}", tile.name),
            found: format!("\"{}\"", tile.pattern),
            expected: expected.into(),
        })
    }
}
