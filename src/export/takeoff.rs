//! `takeoff.json` and `takeoff.csv`: every row of the take-off with the tiles, openings, plates, stairs and members that sum to it.

use serde_json::{Value, json};

use super::tables::{Cell, csv};
use crate::quantities::OriginRow;

/// The columns of `takeoff.csv`: a row for each origin of each line of the bill.
///
/// | column | holds |
/// |---|---|
/// | `line`, `item` | as in `bom.csv` |
/// | `origin_kind` | `tile`, `tile edge`, `opening`, `plate`, `stair` or `member` |
/// | `origin_id` | cube `i,j,k` of the padded array; number of the opening, stair or member; voxel layer of the plate |
/// | `quantity`, `unit` | its part: over a line they sum to the measured quantity; below 0 for what is taken off |
pub const TAKEOFF_COLUMNS: [&str; 6] = ["line", "item", "origin_kind", "origin_id", "quantity", "unit"];

/// Text of `takeoff.csv`.
pub fn takeoff_csv(rows: &[OriginRow]) -> String {
    let cells = rows.iter().flat_map(|row| {
        row.origins.iter().map(|origin| {
            vec![
                Cell::Count(row.line as i64),
                row.item.id().into(),
                origin.kind.name().into(),
                Cell::Text(origin.id.clone()),
                origin.quantity.into(),
                row.unit.name().into(),
            ]
        })
    });
    csv(&TAKEOFF_COLUMNS, cells)
}

/// Text of `takeoff.json`.
pub fn takeoff_json(name: &str, rows: &[OriginRow]) -> Value {
    let lines: Vec<Value> = rows
        .iter()
        .map(|row| {
            json!({
                "line": row.line,
                "group": row.item.group(),
                "item": row.item.id(),
                "description": row.description,
                "quantity": row.quantity,
                "unit": row.unit,
                "count": row.origins.len(),
                "origins": row.origins,
            })
        })
        .collect();
    json!({
        "schema": "houscaper.takeoff/1",
        "name": name,
        "ids": {
            "tile": "cube i,j,k of the padded array",
            "tile_edge": "cube i,j,k of the padded array",
            "opening": "number in the list of openings, its storey and direction",
            "plate": "voxel layer",
            "stair": "number in the list of stairs",
            "member": "number of the stick, as in structure.json",
        },
        "lines": lines,
    })
}
