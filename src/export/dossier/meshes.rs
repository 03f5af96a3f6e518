//! What a set of meshes draws of a house, what it has no tile for, and what was measured otherwise.

use serde::Serialize;
use serde_json::{Value, json};

use crate::envelope::{Fabric, house_stairs};
use crate::export::Scene;
use crate::export::tables::{Cell, csv};
use crate::score::Tiling;
use crate::tiles::MissingCube;
use crate::tiles::solids::SolidStyle;
use crate::voxels::{House, Label, Reading};

/// The full list of cubes without a tile, beside the house.
pub const MISSING_FILE: &str = "missing-tiles.csv";

/// Cubes named in the report itself.
const NAMED: usize = 20;

/// A house drawn by a set of meshes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshesReport {
    /// Name of the set.
    pub name: String,
    /// Edges of the cube that the meshes are drawn in, mm.
    pub module_mm: [f64; 3],
    /// By how much they are stretched along x, y, z to the house's module.
    pub stretch: [f64; 3],
    /// Where areas, take-off, price and loads come from.
    pub measured_by: &'static str,
    /// Flights of stairs of the house, which no tile draws.
    pub stairs_not_drawn: usize,
    /// Cubes of the house that stay empty because the set has no tile for their labels.
    pub cubes_without_tile: usize,
    /// The first of them.
    pub first_without_tile: Vec<CubeWithoutTile>,
    /// The file with all of them; `None` when there is none.
    pub all_without_tile: Option<&'static str>,
}

/// A cube for which a set has no tile.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CubeWithoutTile {
    /// Its place in the padded array: its first corner is voxel (i - 1, j - 1, k - 1).
    pub cube: [usize; 3],
    /// Codes of its labels, corner by corner (x fastest).
    pub labels: String,
    /// The same as a thesis id in `f_order`.
    pub thesis_id: u32,
}

impl From<&MissingCube> for CubeWithoutTile {
    fn from(missing: &MissingCube) -> Self {
        let digits = missing.labels.iter().map(|l: &Label| char::from(b'0' + l.code()));
        CubeWithoutTile { cube: missing.cube, labels: digits.collect(), thesis_id: missing.thesis_id.0 }
    }
}

impl MeshesReport {
    /// The report on a house; `None` for tilesets that are no meshes.
    pub fn new(house: &House, reading: &Reading, tiling: &Tiling) -> Option<MeshesReport> {
        let (set, measured_by) = (tiling.meshes.as_ref()?, tiling.measured_by()?);
        let missing = tiling.missing(&house.voxels);
        let module_m = set.module_um().map(|um| f64::from(um) * 1e-6);
        Some(MeshesReport {
            name: set.name().to_owned(),
            module_mm: set.module_um().map(|um| f64::from(um) / 1e3),
            stretch: [0, 1, 2].map(|a| house.voxels.module.size_m[a] / module_m[a]),
            measured_by,
            stairs_not_drawn: house_stairs(house, reading, &SolidStyle::default()).len(),
            cubes_without_tile: missing.len(),
            first_without_tile: missing.iter().take(NAMED).map(CubeWithoutTile::from).collect(),
            all_without_tile: (!missing.is_empty()).then_some(MISSING_FILE),
        })
    }

    /// What a user should be told, a sentence each.
    pub fn lines(&self) -> Vec<String> {
        let mut lines = vec![format!("tileset {}: {}", self.name, self.measured_by)];
        if self.stretch.iter().any(|s| (s - 1.0).abs() > 1e-9) {
            let [x, y, z] = self.stretch;
            lines.push(format!(
                "tileset {}: drawn for another module; stretched to the house's by {x:.4} x {y:.4} x {z:.4}",
                self.name
            ));
        }
        if self.stairs_not_drawn > 0 {
            lines.push(format!(
                "tileset {}: {} stairs are not drawn, no tile has them",
                self.name, self.stairs_not_drawn
            ));
        }
        if self.cubes_without_tile > 0 {
            let first: Vec<String> =
                self.first_without_tile.iter().take(5).map(|m| format!("{:?} {}", m.cube, m.labels)).collect();
            lines.push(format!(
                "tileset {}: {} cubes have no tile and stay empty, for example {}; all of them in {MISSING_FILE}, `houscaper tileset \
                 check` lists what else the set lacks",
                self.name,
                self.cubes_without_tile,
                first.join(", ")
            ));
        }
        lines
    }

    /// `meshes.json`: the report with the layers of the set as they are in the house.
    pub fn with_layers(&self, scene: &Scene, fabric: Option<&Fabric>) -> Value {
        let mut report = json!({ "schema": "houscaper.meshes/1" });
        if let (Some(report), Ok(Value::Object(own))) = (report.as_object_mut(), serde_json::to_value(self)) {
            report.extend(own);
        }
        let pieces = |layer: usize| fabric.map_or(0, |f| f.placed.iter().filter(|p| p.layer as usize == layer).count());
        let layers: Vec<Value> = scene
            .parts
            .iter()
            .map(|part| {
                let mut layer = json!({ "layer": part.name, "pieces": pieces(part.material) });
                if let (Some(layer), Some(extras)) = (layer.as_object_mut(), part.extras.as_object()) {
                    layer.extend(extras.clone());
                }
                layer
            })
            .collect();
        report["layers"] = json!(layers);
        report
    }
}

/// Text of [`MISSING_FILE`]: a row for each cube, labels as eight digits.
pub(super) fn missing_csv(missing: &[MissingCube]) -> String {
    let rows = missing.iter().map(CubeWithoutTile::from).map(|m| {
        let [i, j, k] = m.cube.map(|c| Cell::Count(c as i64));
        vec![i, j, k, Cell::Text(m.labels), Cell::Count(i64::from(m.thesis_id))]
    });
    csv(&["i", "j", "k", "labels", "thesis_id"], rows)
}
