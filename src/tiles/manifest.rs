//! The manifest of a tileset, `tileset.json`: conventions, layers, and which file covers which configurations.

use super::TilesetError;
use crate::cubes::{Axis, CornerOrder, Mask, Symmetry};
use crate::voxels::Label;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;

/// Value of `schema`.
pub const SCHEMA: &str = "houscaper.tileset/1";

/// What the OBJ files hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TilesetKind {
    /// Polygons: the boundary between filled and empty.
    Surface,
    /// Lines: the skeleton.
    Linear,
}

/// Whether a layer is part of the boundary or a body of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LayerKind {
    /// Groups named `<kind>_o<octant>`; free edges on the cube's faces.
    Surface,
    /// Groups named `<layer>_o<octant>`; each group closed in itself.
    Solid,
}

/// A layer of the tiles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Layer {
    /// Name; also the group prefix of solids.
    pub name: String,
    /// Surface or solid.
    pub kind: LayerKind,
    /// How far its vertices may lie outside the cube, in the manifest's unit.
    #[serde(default)]
    pub overhang: f64,
}

/// Which symmetries may carry a tile to other configurations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TileSymmetry {
    /// Mirrored in x.
    pub mirror: bool,
    /// Turned about z.
    pub quarter_turns: bool,
}

/// One tile: a file and the configuration it is drawn for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TileEntry {
    /// Name, unique in the set.
    pub name: String,
    /// Eight digits 0 or 1 in the manifest's corner order, first corner first.
    pub pattern: String,
    /// What may be made of it.
    pub symmetry: TileSymmetry,
    /// OBJ file beside the manifest.
    pub file: String,
}

/// `tileset.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Manifest {
    /// [`SCHEMA`].
    pub schema: String,
    /// Name of the set.
    pub name: String,
    /// One sentence.
    #[serde(default)]
    pub description: String,
    /// Surface or linear.
    pub kind: TilesetKind,
    /// `mm` or `m`, of module, overhangs and OBJ files.
    pub unit: String,
    /// `z`.
    pub up_axis: String,
    /// Edges of a cube along x, y, z.
    pub module_size: [f64; 3],
    /// `f_order` or `box_corners`: how patterns are read.
    pub corner_order: String,
    /// Meaning of the label codes.
    pub labels: BTreeMap<String, String>,
    /// Layers; none declared means one surface layer named `envelope` without overhang.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// The tiles.
    pub tiles: Vec<TileEntry>,
}

/// Where the content of a configuration comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Placement {
    /// Index of the tile.
    pub tile: usize,
    /// How it is placed.
    pub symmetry: Symmetry,
}

/// The label table that every file states.
pub(super) fn label_table() -> BTreeMap<String, String> {
    Label::ALL.into_iter().map(|l| (l.code().to_string(), l.name().to_string())).collect()
}

impl Manifest {
    /// Parses and checks everything that can be known without the OBJ files.
    pub fn parse(text: &str, path: &Path, kind: TilesetKind) -> Result<Manifest, TilesetError> {
        let manifest: Manifest =
            serde_json::from_str(text).map_err(|source| TilesetError::Manifest { path: path.into(), source })?;
        manifest.check(path, kind)?;
        Ok(manifest)
    }

    fn check(&self, path: &Path, kind: TilesetKind) -> Result<(), TilesetError> {
        let wrong = |key: &str, found: String, expected: &str| {
            Err(TilesetError::Value { path: path.into(), key: key.into(), found, expected: expected.into() })
        };
        if self.schema != SCHEMA {
            return wrong("schema", format!("\"{}\"", self.schema), &format!("\"{SCHEMA}\""));
        }
        if self.kind != kind {
            return wrong("kind", format!("{:?}", self.kind), &format!("{kind:?}; load the other kind of set here"));
        }
        if !["mm", "m"].contains(&self.unit.as_str()) {
            return wrong("unit", format!("\"{}\"", self.unit), "\"mm\" or \"m\"; scale the OBJ files when exporting");
        }
        if self.up_axis != "z" {
            return wrong("up_axis", format!("\"{}\"", self.up_axis), "\"z\"; turn the tiles when exporting");
        }
        if CornerOrder::from_name(&self.corner_order).is_none() {
            return wrong("corner_order", format!("\"{}\"", self.corner_order), "\"f_order\" or \"box_corners\"");
        }
        if self.labels != label_table() {
            return wrong("labels", format!("{:?}", self.labels), &format!("{:?}", label_table()));
        }
        let whole = |v: f64| (v * self.to_mm()).fract().abs() < 1e-6 && v > 0.0 && v * self.to_mm() <= 1e5;
        if !self.module_size.iter().all(|&v| whole(v)) {
            let expected = "three positive whole numbers of millimetres up to 100 m";
            return wrong("module_size", format!("{:?}", self.module_size), expected);
        }
        for (n, layer) in self.layers.iter().enumerate() {
            if !(0.0..=1e5).contains(&(layer.overhang * self.to_mm())) {
                let key = format!("layers[{n}].overhang");
                return wrong(&key, layer.overhang.to_string(), "a length from 0 to 100 m");
            }
        }
        Ok(())
    }

    /// Millimetres in the manifest's unit.
    pub fn to_mm(&self) -> f64 {
        if self.unit == "m" { 1000.0 } else { 1.0 }
    }

    /// Edges of a cube in mm.
    pub fn module_mm(&self) -> [i32; 3] {
        self.module_size.map(|v| (v * self.to_mm()).round() as i32)
    }

    /// The configuration a tile is drawn for.
    fn mask(&self, tile: &TileEntry, path: &Path) -> Result<Mask, TilesetError> {
        let order = CornerOrder::from_name(&self.corner_order).unwrap_or_default().corners();
        let digits = tile.pattern.as_bytes();
        if digits.len() != 8 || digits.iter().any(|d| !b"01".contains(d)) {
            return Err(TilesetError::Value {
                path: path.into(),
                key: format!("pattern of tile {}", tile.name),
                found: format!("\"{}\"", tile.pattern),
                expected: "eight digits 0 or 1, one per corner".into(),
            });
        }
        Ok(Mask((0..8).filter(|&n| digits[n] == b'1').fold(0, |bits, n| bits | 1 << order[n])))
    }

    /// Which tile covers which configuration; every configuration for which `needed` holds must be covered, once.
    pub(super) fn placements(
        &self,
        path: &Path,
        needed: impl Fn(Mask) -> bool,
    ) -> Result<[Option<Placement>; 256], TilesetError> {
        let mut table: [Option<Placement>; 256] = [None; 256];
        for (tile, entry) in self.tiles.iter().enumerate() {
            let drawn = self.mask(entry, path)?;
            self.check_entry(tile, drawn, path, &needed)?;
            let allowed =
                |s: &Symmetry| (entry.symmetry.mirror || !s.mirror) && (entry.symmetry.quarter_turns || s.turns == 0);
            for symmetry in Symmetry::all().filter(allowed) {
                let mask = symmetry.mask(drawn);
                match table[mask.0 as usize] {
                    Some(other) if other.tile != tile => {
                        return Err(TilesetError::Duplicate {
                            path: path.into(),
                            mask: mask.0,
                            first: self.tiles[other.tile].name.clone(),
                            second: entry.name.clone(),
                        });
                    }
                    Some(_) => {}
                    None => table[mask.0 as usize] = Some(Placement { tile, symmetry }),
                }
            }
        }
        match Mask::all().find(|&m| needed(m) && table[m.0 as usize].is_none()) {
            Some(m) => Err(TilesetError::MissingTile { path: path.into(), mask: m.0, pattern: m.pattern() }),
            None => Ok(table),
        }
    }

    fn check_entry(
        &self,
        tile: usize,
        mask: Mask,
        path: &Path,
        needed: impl Fn(Mask) -> bool,
    ) -> Result<(), TilesetError> {
        let entry = &self.tiles[tile];
        let wrong = |key: &str, found: String, expected: &str| {
            let key = format!("{key} of tile {}", entry.name);
            Err(TilesetError::Value { path: path.into(), key, found, expected: expected.into() })
        };
        if !needed(mask) {
            let expected = "an admissible configuration (filled and empty corners each connected along edges)";
            return wrong("pattern", format!("\"{}\"", entry.pattern), expected);
        }
        if self.tiles[..tile].iter().any(|t| t.name == entry.name) {
            return wrong("name", format!("\"{}\"", entry.name), "a name that no other tile has");
        }
        let size = self.module_size;
        if entry.symmetry.quarter_turns && size[Axis::X as usize] != size[Axis::Y as usize] {
            let expected = "false, because a module that is not square in plan cannot be turned";
            return wrong("symmetry.quarter_turns", "true".into(), expected);
        }
        Ok(())
    }
}
