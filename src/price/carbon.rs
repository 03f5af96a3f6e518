//! The factor list: fossil greenhouse gas A1-A3, biogenic storage and energy per unit of material.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;

use super::book::check_range;
use super::error::{expect_head, expect_text, expect_unique, read};
use super::{PriceError, Range};
use crate::quantities::Unit;

/// Factors of one material.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CarbonItem {
    /// Id, unique in the list.
    pub id: String,
    /// Material.
    pub description: String,
    /// Unit the factors refer to: kg, m2 or m3.
    pub unit: Unit,
    low: f64,
    default: f64,
    high: f64,
    /// Stored biogenic carbon in kgCO2 per unit, at most 0: shown beside the fossil number and never netted.
    pub biogenic: f64,
    /// Energy in MJ per unit; `None` where no data exist.
    pub energy_mj: Option<f64>,
    /// Source of the greenhouse gas factors.
    pub source: String,
    /// Source of the energy; `None` where no data exist.
    pub energy_source: Option<String>,
}

impl CarbonItem {
    /// Fossil kgCO2e of A1-A3 per unit: low, default, high.
    pub fn range(&self) -> Range {
        [self.low, self.default, self.high]
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct CarbonFile {
    schema: String,
    version: String,
    date: String,
    region: String,
    stage: String,
    gwp_unit: String,
    energy_unit: String,
    sources: BTreeMap<String, String>,
    items: Vec<CarbonItem>,
}

/// A factor list (`houscaper.carbon/1`).
#[derive(Debug)]
pub struct CarbonBook {
    /// Path it was read from, for messages.
    pub file: String,
    /// Version of the list.
    pub version: String,
    /// Date of the list.
    pub date: String,
    /// Region of the factors.
    pub region: String,
    /// Key of a source to its full reference.
    pub sources: BTreeMap<String, String>,
    items: Vec<CarbonItem>,
}

impl CarbonBook {
    /// Reads a factor list and checks every value.
    ///
    /// # Errors
    /// As [`super::PriceBook::load`]; besides a stage other than A1-A3, positive biogenic storage, and energy without a source.
    pub fn load(path: &Path) -> Result<CarbonBook, PriceError> {
        let raw: CarbonFile = read(path)?;
        let file = path.display().to_string();
        expect_head(&file, "schema", &raw.schema, "houscaper.carbon/1")?;
        expect_head(&file, "stage", &raw.stage, "A1-A3")?;
        expect_head(&file, "gwp_unit", &raw.gwp_unit, "kgCO2e")?;
        expect_head(&file, "energy_unit", &raw.energy_unit, "MJ")?;
        expect_unique(&file, raw.items.iter().map(|i| i.id.as_str()))?;
        for item in &raw.items {
            check_item(&file, item)?;
        }
        let CarbonFile { version, date, region, sources, items, .. } = raw;
        Ok(CarbonBook { file, version, date, region, sources, items })
    }

    /// The factors in file order.
    pub fn items(&self) -> &[CarbonItem] {
        &self.items
    }

    /// The factors with this id; `needed_by` says who asks.
    ///
    /// # Errors
    /// No such item: the message names item and list.
    pub fn item(&self, id: &str, needed_by: &str) -> Result<&CarbonItem, PriceError> {
        let missing = || PriceError::Missing { file: self.file.clone(), item: id.into(), needed_by: needed_by.into() };
        self.items.iter().find(|item| item.id == id).ok_or_else(missing)
    }
}

fn check_item(file: &str, item: &CarbonItem) -> Result<(), PriceError> {
    check_range(file, &item.id, item.range())?;
    expect_text(file, &format!("{}.source", item.id), &item.source)?;
    let key = format!("{}.biogenic", item.id);
    let expected = "expected at most 0 (storage is negative)";
    if !(item.biogenic.is_finite() && item.biogenic <= 0.0) {
        return Err(PriceError::Value { file: file.into(), key, found: item.biogenic.to_string(), expected });
    }
    match (item.energy_mj, &item.energy_source) {
        (Some(energy), source) => {
            check_range(file, &format!("{}.energy_mj", item.id), [energy; 3])?;
            expect_text(file, &format!("{}.energy_source", item.id), source.as_deref().unwrap_or(""))
        }
        (None, _) => Ok(()),
    }
}
