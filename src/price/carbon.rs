//! The factor list: fossil greenhouse gas A1-A3 and of the later stages, biogenic storage and energy per unit of material.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::book::check_range;
use super::error::{expect_head, expect_text, expect_unique, read};
use super::{PriceError, Range};
use crate::quantities::Unit;

/// A stage of the life cycle beside A1-A3 (EN 15978), as far as the factor list knows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[repr(usize)]
pub enum Stage {
    /// Transport to the site.
    A4 = 0,
    /// Material wasted on site.
    A5 = 1,
    /// Processing and disposal of waste, fossil.
    #[serde(rename = "c3_c4")]
    C3C4 = 2,
    /// Loads and credits beyond the boundary: beside the others and in no sum.
    D = 3,
}

impl Stage {
    /// Number of stages.
    pub const COUNT: usize = 4;

    /// All stages in their order.
    pub const ALL: [Stage; Stage::COUNT] = [Stage::A4, Stage::A5, Stage::C3C4, Stage::D];

    /// The stages inside the boundary: those that may be added to A1-A3.
    pub const INSIDE: [Stage; 3] = [Stage::A4, Stage::A5, Stage::C3C4];

    /// Key in files.
    pub fn key(self) -> &'static str {
        match self {
            Stage::A4 => "a4",
            Stage::A5 => "a5",
            Stage::C3C4 => "c3_c4",
            Stage::D => "d",
        }
    }

    /// As printed.
    pub fn title(self) -> &'static str {
        match self {
            Stage::A4 => "A4",
            Stage::A5 => "A5",
            Stage::C3C4 => "C3-C4",
            Stage::D => "D",
        }
    }
}

/// A factor of a stage, kgCO2e per unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StageFactor {
    low: f64,
    default: f64,
    high: f64,
    /// Source of the three values.
    pub source: String,
}

impl StageFactor {
    /// kgCO2e per unit: low, default, high.
    pub fn range(&self) -> Range {
        [self.low, self.default, self.high]
    }
}

/// Factors of the stages; none is unknown.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct StageFactors {
    a4: Option<StageFactor>,
    a5: Option<StageFactor>,
    c3_c4: Option<StageFactor>,
    d: Option<StageFactor>,
}

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
    #[serde(default)]
    stages: StageFactors,
}

impl CarbonItem {
    /// Fossil kgCO2e of A1-A3 per unit: low, default, high.
    pub fn range(&self) -> Range {
        [self.low, self.default, self.high]
    }

    /// The factor of a stage; `None` where no data exist.
    pub fn stage(&self, stage: Stage) -> Option<&StageFactor> {
        let StageFactors { a4, a5, c3_c4, d } = &self.stages;
        match stage {
            Stage::A4 => a4.as_ref(),
            Stage::A5 => a5.as_ref(),
            Stage::C3C4 => c3_c4.as_ref(),
            Stage::D => d.as_ref(),
        }
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
    #[serde(default)]
    stages: BTreeMap<Stage, String>,
    sources: BTreeMap<String, String>,
    items: Vec<CarbonItem>,
}

/// A factor list: `houscaper.carbon/2`, or `houscaper.carbon/1`, which knew no stages beside A1-A3.
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
    /// What the numbers of a stage hold, in words.
    pub scope: BTreeMap<Stage, String>,
    items: Vec<CarbonItem>,
}

impl CarbonBook {
    /// Reads a factor list and checks every value.
    ///
    /// # Errors
    /// As [`super::PriceBook::load`]; besides a stage other than A1-A3, positive biogenic storage, energy without a source, and factors of
    /// the later stages that are out of order, without a source, or, but for D, below 0.
    pub fn load(path: &Path) -> Result<CarbonBook, PriceError> {
        let raw: CarbonFile = read(path)?;
        let file = path.display().to_string();
        if raw.schema != "houscaper.carbon/1" {
            expect_head(&file, "schema", &raw.schema, "houscaper.carbon/2")?;
        }
        expect_head(&file, "stage", &raw.stage, "A1-A3")?;
        expect_head(&file, "gwp_unit", &raw.gwp_unit, "kgCO2e")?;
        expect_head(&file, "energy_unit", &raw.energy_unit, "MJ")?;
        expect_unique(&file, raw.items.iter().map(|i| i.id.as_str()))?;
        for item in &raw.items {
            check_item(&file, item)?;
        }
        let CarbonFile { version, date, region, sources, stages: scope, items, .. } = raw;
        Ok(CarbonBook { file, version, date, region, sources, scope, items })
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
    Stage::ALL.into_iter().try_for_each(|stage| check_stage(file, item, stage))?;
    match (item.energy_mj, &item.energy_source) {
        (Some(energy), source) => {
            check_range(file, &format!("{}.energy_mj", item.id), [energy; 3])?;
            expect_text(file, &format!("{}.energy_source", item.id), source.as_deref().unwrap_or(""))
        }
        (None, _) => Ok(()),
    }
}

fn check_stage(file: &str, item: &CarbonItem, stage: Stage) -> Result<(), PriceError> {
    let Some(factor) = item.stage(stage) else { return Ok(()) };
    let key = format!("{}.stages.{}", item.id, stage.key());
    expect_text(file, &format!("{key}.source"), &factor.source)?;
    if stage != Stage::D {
        return check_range(file, &key, factor.range());
    }
    let [low, default, high] = factor.range();
    if factor.range().iter().all(|v| v.is_finite()) && low <= default && default <= high {
        return Ok(());
    }
    let (found, expected) = (format!("low {low}, default {default}, high {high}"), "expected low <= default <= high");
    Err(PriceError::Value { file: file.into(), key, found, expected })
}
