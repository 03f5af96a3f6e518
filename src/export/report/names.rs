//! The named houses: as the run told them in `summary.json`, else found again from the front's table.

use serde::Serialize;
use serde_json::Value;

use super::Rows;
use super::columns::Dimension;
use crate::search::select::{Reason, named_houses};
use crate::voxels::VoxelArray;

/// A house with a name and the reason for it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedHouse {
    /// Its evaluation.
    pub id: u64,
    /// "cheapest", "knee", ...
    pub name: String,
    /// The reason as a sentence.
    pub reason: String,
    /// What the search said of it besides: price in tenths of the draws, chances against the others.
    #[serde(skip_serializing_if = "Value::is_null")]
    pub more: Value,
}

/// The named houses of `summary.json`.
pub fn told(summary: &Value) -> Vec<NamedHouse> {
    let text = |v: &Value| v.as_str().unwrap_or_default().to_owned();
    let one = |n: &Value| {
        let mut more = n.clone();
        if let Some(map) = more.as_object_mut() {
            ["id", "name", "reason", "values", "sensitivity"].iter().for_each(|key| drop(map.remove(*key)));
        }
        Some(NamedHouse { id: n["id"].as_u64()?, name: text(&n["name"]), reason: text(&n["reason"]), more })
    };
    summary["named"].as_array().into_iter().flatten().filter_map(one).collect()
}

/// The houses that the objectives alone name; those named by their shape need every house's voxels.
pub fn found(front: &Rows, ids: &[u64], objectives: &[Dimension]) -> Vec<NamedHouse> {
    let sign = |d: &Dimension| if d.maximise == Some(true) { -1.0 } else { 1.0 };
    let value = |row: usize, d: &Dimension| front.number(row, &d.key).map_or(f64::NAN, |v| v * sign(d));
    let points: Vec<Vec<f64>> =
        (0..front.count()).map(|row| objectives.iter().map(|d| value(row, d)).collect()).collect();
    if points.iter().flatten().any(|v| v.is_nan()) {
        return Vec::new();
    }
    // All the same, so that no shape stands out; what is named for its shape is left out below.
    let one = VoxelArray::new([1, 1, 1]);
    let shapes: Vec<&VoxelArray> = points.iter().map(|_| &one).collect();
    let points: Vec<&[f64]> = points.iter().map(Vec::as_slice).collect();
    let keys: Vec<&str> = objectives.iter().map(|d| d.key.as_str()).collect();
    let named = named_houses(&points, &shapes, &keys, None).into_iter();
    named
        .filter(|n| !matches!(n.reason, Reason::MostDifferent | Reason::NearestReference))
        .map(|n| NamedHouse { id: ids[n.index], name: n.name, reason: n.sentence, more: Value::Null })
        .collect()
}
