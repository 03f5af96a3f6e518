//! Sets of kind `style`: the choices of a construction as data, and meshes for single configurations.

use super::entry::TileEntry;
use super::label_set::LabelSet;
use super::layer::{Layer, LayerKind};
use super::look::{Look, component, palette_schema};
use super::manifest::{Manifest, TilesetKind, check_conventions, label_table};
use super::solids::{Railing, SolidStyle};
use super::surface::MANIFEST_FILE;
use super::{Component, Pivot, TilesetError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What a tile is looked up by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum TileRule {
    /// The eight labels alone, as in the thesis.
    A,
    /// Eight labels and a number on each vertical face: straight gables and eaves.
    #[default]
    B,
}

/// The lengths and choices of a style, in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StyleSpec {
    /// How far a roof reaches over free eaves and verges, in plan; 0 to 400.
    pub overhang_mm: f64,
    /// Depth of the boards that close an overhang.
    pub fascia_mm: f64,
    /// Whether free eaves carry a gutter.
    pub gutter: bool,
    /// Height of a parapet above a level roof that is not walked on.
    pub parapet_mm: f64,
    /// Height of a railing above its deck.
    pub railing_height_mm: f64,
    /// `glass` or `bars`.
    #[schemars(schema_with = "railing_schema")]
    pub railing: Railing,
    /// Width of the frame bars of windows and doors.
    pub bar_mm: f64,
    /// Depth of the outer face of frames behind the facade.
    pub reveal_mm: f64,
}

fn railing_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    schemars::json_schema!({"type": "string", "enum": ["glass", "bars"]})
}

/// `tileset.json` of kind `style`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StyleManifest {
    /// `houscaper.tileset/1`.
    #[schemars(extend("const" = super::manifest::SCHEMA))]
    pub schema: String,
    /// Name of the set.
    pub name: String,
    /// One sentence.
    #[serde(default)]
    pub description: String,
    /// `style`.
    #[schemars(extend("enum" = ["style"]))]
    pub kind: TilesetKind,
    /// Unit of module and overrides, as in a set of meshes.
    #[schemars(extend("enum" = ["mm", "cm", "m", "inch", "cube"]))]
    pub unit: String,
    /// Up axis of the overrides, as in a set of meshes.
    pub up_axis: String,
    /// Pivot of the overrides.
    #[serde(default)]
    pub pivot: Pivot,
    /// Edges of a cube; construction needs 900 x 900 x 540 mm.
    pub module_size: [f64; 3],
    /// How patterns of overrides are read.
    #[schemars(extend("enum" = ["f_order", "box_corners"]))]
    pub corner_order: String,
    /// Meaning of the label codes.
    pub labels: BTreeMap<String, String>,
    /// What a tile is looked up by.
    #[serde(default)]
    pub rule: TileRule,
    /// The choices.
    pub style: StyleSpec,
    /// The look of components; those left out look as in the default palette.
    #[serde(default)]
    #[schemars(schema_with = "palette_schema")]
    pub palette: BTreeMap<String, Look>,
    /// Folder of the overrides' files, relative to the manifest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<PathBuf>,
    /// Layers of the overrides; left out, each component is a layer of its own name.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// Meshes instead of the construction, for single configurations.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub overrides: Vec<TileEntry>,
}

impl StyleSpec {
    /// Lengths with their key and range, mm.
    fn lengths(&self) -> [(&'static str, f64, f64); 6] {
        [
            ("overhang_mm", self.overhang_mm, 400.0),
            ("fascia_mm", self.fascia_mm, 500.0),
            ("parapet_mm", self.parapet_mm, 1200.0),
            ("railing_height_mm", self.railing_height_mm, 1500.0),
            ("bar_mm", self.bar_mm, 200.0),
            ("reveal_mm", self.reveal_mm, 300.0),
        ]
    }

    /// Puts the choices into a style; whatever the file does not state stays as it is.
    pub fn apply(&self, mut style: SolidStyle) -> SolidStyle {
        // Multiples of 5 µm, so that heights on a 3 : 5 slope are whole.
        let um = |mm: f64| (mm * 200.0).round() as i32 * 5;
        style.overhang_um = um(self.overhang_mm);
        style.fascia_um = um(self.fascia_mm);
        style.gutter = self.gutter;
        style.parapet_um = um(self.parapet_mm);
        style.railing_um = um(self.railing_height_mm);
        style.railing = self.railing;
        style.bar_um = um(self.bar_mm);
        style.reveal_um = um(self.reveal_mm);
        style
    }
}

impl StyleManifest {
    /// Parses a manifest and lists all mistakes of its values; an error when it cannot be understood at all.
    pub fn examine(text: &str, path: &Path) -> Result<(StyleManifest, Vec<TilesetError>), TilesetError> {
        let manifest: StyleManifest =
            serde_json::from_str(text).map_err(|source| TilesetError::Manifest { path: path.into(), source })?;
        let mistakes = manifest.mistakes(path);
        Ok((manifest, mistakes))
    }

    fn mistakes(&self, path: &Path) -> Vec<TilesetError> {
        let mut list = Vec::new();
        let mut wrong = |key: &str, found: String, expected: String| {
            list.push(TilesetError::Value { path: path.into(), key: key.into(), found, expected });
        };
        check_conventions([&self.schema, &self.unit, &self.corner_order], &self.labels, &mut wrong);
        if self.kind != TilesetKind::Style {
            wrong("kind", format!("{:?}", self.kind), "Style; load the other kind of set elsewhere".into());
        }
        for (key, mm, most) in self.style.lengths() {
            if !(0.0..=most).contains(&mm) {
                wrong(&format!("style.{key}"), mm.to_string(), format!("a length from 0 to {most} mm"));
            }
        }
        for (name, look) in &self.palette {
            if component(name).is_none() {
                let names: Vec<&str> = Component::ALL.iter().map(|c| c.name()).collect();
                wrong(&format!("palette.{name}"), "no component".into(), format!("one of {}", names.join(", ")));
            }
            let hex = look.srgb.strip_prefix('#').filter(|h| h.len() == 6 && h.chars().all(|c| c.is_ascii_hexdigit()));
            if hex.is_none() {
                wrong(&format!("palette.{name}.srgb"), look.srgb.clone(), "a colour such as #8a5a3b".into());
            }
            for (key, value) in [("roughness", look.roughness), ("metallic", look.metallic), ("opacity", look.opacity)]
            {
                if !(0.0..=1.0).contains(&value) {
                    wrong(&format!("palette.{name}.{key}"), value.to_string(), "a number from 0 to 1".into());
                }
            }
        }
        let meshes = self.meshes();
        if meshes.module_mm() != super::CUBE_MM {
            let expected = format!("{:?} mm, for which tiles are constructed", super::CUBE_MM);
            wrong("module_size", format!("{:?}", self.module_size), expected);
        }
        list
    }

    /// The overrides as a manifest of their own.
    pub(super) fn meshes(&self) -> Manifest {
        let own = |c: &Component| Layer {
            name: c.name().into(),
            kind: LayerKind::Solid,
            overhang: 0.0,
            component: Some(*c),
            groups: Vec::new(),
        };
        Manifest {
            schema: self.schema.clone(),
            name: self.name.clone(),
            description: self.description.clone(),
            kind: TilesetKind::Solids,
            unit: self.unit.clone(),
            up_axis: self.up_axis.clone(),
            pivot: self.pivot.clone(),
            module_size: self.module_size,
            corner_order: self.corner_order.clone(),
            labels: if self.labels.is_empty() { label_table() } else { self.labels.clone() },
            root: self.root.clone(),
            layers: if self.layers.is_empty() { Component::ALL.iter().map(own).collect() } else { self.layers.clone() },
            tiles: self.overrides.clone(),
            numbered: None,
            open_seams: Vec::new(),
        }
    }
}

/// A style in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct StyleSet {
    /// Name in the manifest.
    pub name: String,
    /// The choices that shape solids.
    pub style: SolidStyle,
    /// What a tile is looked up by.
    pub rule: TileRule,
    /// The look of components, in their order.
    pub palette: Vec<(Component, Look)>,
    /// Meshes for single configurations.
    pub overrides: LabelSet,
}

impl StyleSet {
    /// Loads the folder `dir`: its `tileset.json` and the files of its overrides.
    pub fn load(dir: &Path) -> Result<StyleSet, TilesetError> {
        StyleSet::read(dir, |path| std::fs::read_to_string(path))
    }

    /// The same with the files' texts given by `read`, so that tests need no disk.
    pub fn read(dir: &Path, read: impl Fn(&Path) -> std::io::Result<String>) -> Result<StyleSet, TilesetError> {
        let read = |path: &Path| read(path).map_err(|source| TilesetError::Read { path: path.into(), source });
        let path = dir.join(MANIFEST_FILE);
        let (manifest, mistakes) = StyleManifest::examine(&read(&path)?, &path)?;
        mistakes.into_iter().next().map_or(Ok(()), Err)?;
        let meshes = manifest.meshes();
        let folder = meshes.folder(dir);
        let overrides = LabelSet::of_manifest(&meshes, &path, |file| {
            let path = folder.join(file);
            read(&path).map(|text| (text, path))
        })?;
        let mut palette: Vec<(Component, Look)> =
            manifest.palette.into_iter().filter_map(|(name, look)| Some((component(&name)?, look))).collect();
        palette.sort_by_key(|(c, _)| *c);
        Ok(StyleSet {
            name: manifest.name,
            style: manifest.style.apply(SolidStyle::default()),
            rule: manifest.rule,
            palette,
            overrides,
        })
    }
}

/// A tileset manifest of either shape, for the published JSON Schema.
#[derive(JsonSchema)]
#[serde(untagged)]
#[schemars(title = "houscaper.tileset/1")]
#[expect(dead_code, reason = "only its schema is used")]
enum AnyManifest {
    Meshes(Manifest),
    Style(StyleManifest),
}

/// The JSON Schema of tileset manifests, as `configs/tileset.schema.json` has it.
pub fn tileset_schema() -> serde_json::Value {
    serde_json::to_value(schemars::schema_for!(AnyManifest)).unwrap_or_default()
}
