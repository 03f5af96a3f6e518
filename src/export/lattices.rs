//! What is known of a house cell by cell as topoGenesis lattices: labels, cube and tile ids, and results by voxel.
//!
//! Every file is a lattice CSV of the newer kind, so that topoGenesis's own `lattice_from_csv` reads it; `lattices.json` says what each
//! holds, and `tiles.csv` what the tile numbers mean. Numbers have six significant digits, as topoGenesis writes them.

use serde_json::{Value, json};

use super::ledger::{Ledger, Place};
use super::tables::{Cell, csv};
use super::{DistinctTiles, TurnedTile};
use crate::cubes::{Category, CornerOrder, IdScheme, cube_ids};
use crate::score::Details;
use crate::voxels::House;
use crate::voxels::lattice::{Lattice, Values, write_lattice};
use crate::voxels::rules::glass_in_view_m2;

/// Folder of the files.
pub const FOLDER: &str = "lattices";

/// A lattice with what it holds.
struct Sheet {
    file: &'static str,
    cells: &'static str,
    unit: &'static str,
    nothing: f64,
    holds: &'static str,
    values: Vec<f64>,
}

/// Files of a house by name inside [`FOLDER`], `lattices.json` last. What is not known is left out: tiles of a set of surfaces, zones of a
/// house without, amounts where nothing was taken off. `view_m` is how far the view from a window must be free.
pub fn lattice_files(
    house: &House,
    details: &Details,
    ledger: &Ledger,
    tiles: Option<&DistinctTiles>,
    view_m: f64,
) -> Vec<(String, Vec<u8>)> {
    let mut sheets = ids(house);
    let mut files = Vec::new();
    if let Some(tiles) = tiles {
        sheets.extend(tile_sheets(house, tiles));
        files.push(("tiles.csv".to_owned(), tile_table(tiles).into_bytes()));
    }
    sheets.extend(results(house, details, ledger, view_m));
    let lattices: Vec<Value> = sheets.iter().map(Sheet::about).collect();
    let size = house.voxels.module.size_m;
    let mut written: Vec<(String, Vec<u8>)> = sheets.iter().map(|s| (s.file.to_owned(), s.write(house))).collect();
    written.append(&mut files);
    let about = json!({
        "schema": "houscaper.lattices/1",
        "reader": "topogenesis.lattice_from_csv(path); value[i, j, k] with i along x",
        "unit": "m",
        "up_axis": "z",
        "module_size": size,
        "labels": { "empty": 0, "base": 1, "floor": 2, "foundation": 3, "opening": 4, "window": 5 },
        "corner_order": "f_order",
        "cells": {
            "voxel": "minbound is the centre of voxel (0, 0, 0)",
            "cube": "cubes of the array padded by one empty layer: shape + 1; cube (i, j, k) reaches from voxel (i - 1, j - 1, k - 1) to \
                     (i, j, k), and minbound is the first corner of cube (0, 0, 0), as boolean_marching_cubes() has it",
        },
        "digits": 6,
        "lattices": lattices,
    });
    written.push(("lattices.json".to_owned(), format!("{about:#}\n").into_bytes()));
    written
}

impl Sheet {
    fn about(&self) -> Value {
        json!({ "file": self.file, "cells": self.cells, "unit": self.unit, "nothing": self.nothing, "holds": self.holds })
    }

    fn write(&self, house: &House) -> Vec<u8> {
        let (unit, origin) = (house.voxels.module.size_m, house.voxels.origin_m);
        let is_cube = self.cells == CUBE;
        let shape = if is_cube { house.voxels.shape().map(|n| n + 1) } else { house.voxels.shape() };
        let minbound = if is_cube { [0, 1, 2].map(|a| origin[a] - unit[a]) } else { origin };
        // Sheets are made with as many values as their shape has cells.
        Lattice::new(shape, minbound, unit, Values::Number(self.values.clone()))
            .map_or(Vec::new(), |l| write_lattice(&l))
    }
}

const VOXEL: &str = "voxel";
const CUBE: &str = "cube";

fn ids(house: &House) -> Vec<Sheet> {
    let labels = house.voxels.labels().iter().map(|l| f64::from(l.code())).collect();
    let ids = |scheme| cube_ids(&house.voxels, scheme, CornerOrder::FOrder).ids.into_iter().map(f64::from).collect();
    let sheet = |file, cells, holds, values| Sheet { file, cells, unit: "", nothing: 0.0, holds, values };
    let mut sheets = vec![
        sheet("voxels.csv", VOXEL, "labels", labels),
        sheet(
            "cube_ids.csv",
            CUBE,
            "thesis ids: eight labels in base 6, first corner most significant",
            ids(IdScheme::Thesis),
        ),
        sheet(
            "topogenesis_ids.csv",
            CUBE,
            "as boolean_marching_cubes() of the padded occupancy: sum of 2^j over filled corners",
            ids(IdScheme::TopoGenesis),
        ),
    ];
    if house.zones.len() == house.voxels.labels().len() {
        let values = house.zones.iter().map(|z| f64::from(*z)).collect();
        let holds = "zones that the voxels came from";
        sheets.push(Sheet { file: "zones.csv", cells: VOXEL, unit: "", nothing: -1.0, holds, values });
    }
    sheets
}

/// Values by cube, `nothing` elsewhere.
fn by_cube(house: &House, nothing: f64, values: impl Iterator<Item = ([u32; 3], f64)>) -> Vec<f64> {
    let [nx, ny, nz] = house.voxels.shape().map(|n| n + 1);
    let mut cells = vec![nothing; nx * ny * nz];
    for (cube, value) in values {
        let [i, j, k] = cube.map(|c| c as usize);
        if i < nx && j < ny && k < nz {
            cells[i + nx * (j + ny * k)] = value;
        }
    }
    cells
}

fn tile_sheets(house: &House, tiles: &DistinctTiles) -> [Sheet; 2] {
    let all = |value: fn(&TurnedTile) -> f64| tiles.of_cube.iter().map(move |(cube, t)| (*cube, value(t)));
    [
        Sheet {
            file: "tile_ids.csv",
            cells: CUBE,
            unit: "",
            nothing: 0.0,
            holds: "numbers of tiles.csv, equal for equal tiles whatever their orientation; as in tiles.glb",
            values: by_cube(house, 0.0, all(|t| t.tile as f64 + 1.0)),
        },
        Sheet {
            file: "tile_turns.csv",
            cells: CUBE,
            unit: "quarter turn",
            nothing: -1.0,
            holds: "by how much the tile stands turned counter-clockwise seen from above",
            values: by_cube(house, -1.0, all(|t| f64::from(t.turns))),
        },
    ]
}

/// The columns of `tiles.csv`: number, key (labels, face numbers, walked decks), category, pieces, cubes that it stands in.
pub const TILE_COLUMNS: [&str; 5] = ["tile", "key", "category", "pieces", "cubes"];

fn tile_table(tiles: &DistinctTiles) -> String {
    let mut cubes = vec![0i64; tiles.tiles.len()];
    tiles.of_cube.values().for_each(|t| cubes[t.tile] += 1);
    let rows = tiles.tiles.iter().zip(cubes).enumerate().map(|(n, (tile, cubes))| {
        let category = Category::of(tile.key.mask()).name();
        let counts = [tile.pieces.len() as i64, cubes].map(Cell::Count);
        [vec![Cell::Count(n as i64 + 1), Cell::Text(tile.key.to_string()), category.into()], counts.to_vec()].concat()
    });
    csv(&TILE_COLUMNS, rows)
}

/// Results by voxel.
fn results(house: &House, details: &Details, ledger: &Ledger, view_m: f64) -> Vec<Sheet> {
    let shape = house.voxels.shape();
    // What reaches beyond the array, as eaves do, counts in its outermost voxel, so that sums are whole.
    let cell = |v: &[i32; 3]| house.voxels.index([0, 1, 2].map(|a| (v[a].max(0) as usize).min(shape[a] - 1)));
    let sums = |value: &dyn Fn(&Place) -> f64| {
        let mut cells = vec![0.0; house.voxels.labels().len()];
        ledger.voxels.iter().for_each(|(voxel, place)| cells[cell(voxel)] += value(place));
        cells
    };
    let largest = || {
        let mut cells = vec![-1.0; house.voxels.labels().len()];
        for (voxel, utilisation) in ledger.voxels.iter().filter_map(|(v, place)| Some((v, place.utilisation?))) {
            cells[cell(voxel)] = utilisation.max(cells[cell(voxel)]);
        }
        cells
    };
    let sheet = |file, unit, nothing, holds, values| Sheet { file, cells: VOXEL, unit, nothing, holds, values };
    let mut sheets = Vec::new();
    if details.frame.is_some() && details.evaluation.assessment.is_some() {
        let holds = "largest utilisation of the frame's members in the voxel, limit 1";
        sheets.push(sheet("utilisation.csv", "1", -1.0, holds, largest()));
    }
    if !ledger.rows.is_empty() {
        let holds = "layers and members in the voxel; materials as in bom.csv, default rates, without waste and work";
        sheets.push(sheet("mass_kg.csv", "kg", 0.0, holds, sums(&|p| p.sum().mass_kg)));
        sheets.push(sheet("price_eur.csv", "EUR", 0.0, holds, sums(&|p| p.sum().price)));
        let holds = "fossil carbon A1-A3 of layers and members in the voxel";
        sheets.push(sheet("gwp_kgco2e.csv", "kgCO2e", 0.0, holds, sums(&|p| p.sum().gwp_kgco2e)));
    }
    let holds = "glass with a free view in front, as the rule on daylight counts it, shared evenly over the voxels of its window";
    sheets.push(sheet("daylight_glass_m2.csv", "m2", 0.0, holds, glass(house, details, view_m)));
    sheets
}

fn glass(house: &House, details: &Details, view_m: f64) -> Vec<f64> {
    let mut cells = vec![0.0; house.voxels.labels().len()];
    for opening in &details.reading.openings {
        let voxels: Vec<[usize; 3]> = opening.voxels().collect();
        let each = glass_in_view_m2(&house.voxels, opening, view_m) / voxels.len().max(1) as f64;
        voxels.iter().for_each(|v| cells[house.voxels.index(*v)] += each);
    }
    cells
}
