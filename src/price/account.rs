//! The carbon account of a house: every stage by line, by section, by material, for the whole and for a square metre of floor.

use std::collections::BTreeMap;

use serde::Serialize;

use super::carbon::{CarbonBook, Stage};
use super::{Books, CarbonMatrix, PriceError, Range};
use crate::quantities::{Group, Takeoff, Unit};

/// kgCO2e of a stage: what is known, and what is not.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct StageFigure {
    /// Of the materials that have a factor: low, default, high.
    pub known: Range,
    /// Materials that have none.
    pub unknown: Vec<String>,
}

/// Carbon and energy of anything. Fossil, biogenic and D are numbers beside each other; none of them is a sum of two.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct CarbonFigures {
    /// Fossil kgCO2e of A1-A3: low, default, high.
    pub a1_a3: Range,
    /// Transport to the site.
    pub a4: StageFigure,
    /// Material wasted on site.
    pub a5: StageFigure,
    /// Processing and disposal of waste, fossil.
    pub c3_c4: StageFigure,
    /// Loads and credits beyond the boundary.
    pub d: StageFigure,
    /// Stored biogenic kgCO2, at most 0.
    pub biogenic_storage: f64,
    /// Biogenic kgCO2 released in C3: what was stored (EN 16485).
    pub biogenic_release_c3: f64,
    /// Non-renewable energy of A1-A3 in MJ of the materials that have data.
    pub energy_known_mj: f64,
    /// Materials without data on energy.
    pub energy_unknown: Vec<String>,
}

impl CarbonFigures {
    /// Of amounts of the items of a factor list, in their order and units.
    pub fn of(quantities: &[f64], book: &CarbonBook) -> CarbonFigures {
        let mut figures = CarbonFigures::default();
        for (material, &quantity) in book.items().iter().zip(quantities).filter(|(_, q)| **q > 0.0) {
            add(&mut figures.a1_a3, material.range(), quantity);
            for stage in Stage::ALL {
                let figure = figures.stage_mut(stage);
                match material.stage(stage) {
                    Some(factor) => add(&mut figure.known, factor.range(), quantity),
                    None => figure.unknown.push(material.id.clone()),
                }
            }
            figures.biogenic_storage += material.biogenic * quantity;
            figures.biogenic_release_c3 -= material.biogenic * quantity;
            match material.energy_mj {
                Some(energy) => figures.energy_known_mj += energy * quantity,
                None => figures.energy_unknown.push(material.id.clone()),
            }
        }
        figures
    }

    /// A stage.
    pub fn stage(&self, stage: Stage) -> &StageFigure {
        match stage {
            Stage::A4 => &self.a4,
            Stage::A5 => &self.a5,
            Stage::C3C4 => &self.c3_c4,
            Stage::D => &self.d,
        }
    }

    fn stage_mut(&mut self, stage: Stage) -> &mut StageFigure {
        match stage {
            Stage::A4 => &mut self.a4,
            Stage::A5 => &mut self.a5,
            Stage::C3C4 => &mut self.c3_c4,
            Stage::D => &mut self.d,
        }
    }

    /// The same of one m2 where this is of `m2`.
    fn per(&self, m2: f64) -> CarbonFigures {
        let mut part = self.clone();
        let ranges =
            [&mut part.a1_a3, &mut part.a4.known, &mut part.a5.known, &mut part.c3_c4.known, &mut part.d.known];
        ranges.into_iter().flatten().for_each(|v| *v /= m2);
        let single = [&mut part.biogenic_storage, &mut part.biogenic_release_c3, &mut part.energy_known_mj];
        single.into_iter().for_each(|v| *v /= m2);
        part
    }
}

/// A row of the account.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CarbonRow {
    /// Line of the bill from 1; none for sections and materials.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Section of the bill, item of the take-off, or material of the factor list.
    pub name: String,
    /// What it is.
    pub description: String,
    /// Quantity and its unit: measured for items (members of the frame in kg), used for materials; none for sections.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quantity: Option<(f64, Unit)>,
    /// Its carbon and energy.
    #[serde(flatten)]
    pub figures: CarbonFigures,
}

/// Carbon and energy of a house.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CarbonAccount {
    /// Net floor area in m2.
    pub floor_area_m2: f64,
    /// The whole.
    pub total: CarbonFigures,
    /// Of a m2 of net floor area; none without floor.
    pub per_m2: Option<CarbonFigures>,
    /// By section of the bill.
    pub groups: Vec<CarbonRow>,
    /// By line of the bill.
    pub lines: Vec<CarbonRow>,
    /// By material, in the order of the factor list.
    pub materials: Vec<CarbonRow>,
    /// What the numbers of a stage hold.
    pub scope: BTreeMap<Stage, String>,
    /// Sources by material and stage, of the materials in the house.
    pub sources: BTreeMap<String, BTreeMap<String, String>>,
    /// Version of the factor list.
    pub version: String,
}

impl CarbonAccount {
    /// The account of a take-off with `floor_area_m2` of net floor; `section_name` names a section index.
    ///
    /// # Errors
    /// As [`Books::rates`].
    pub fn new(
        takeoff: &Takeoff,
        books: &Books,
        section_name: &dyn Fn(u16) -> String,
        floor_area_m2: f64,
    ) -> Result<CarbonAccount, PriceError> {
        let (matrix, book) = (CarbonMatrix::new(books)?, &books.carbon);
        let mut groups = Group::ALL.map(|group| (group, vec![0.0; book.items().len()]));
        let mut lines = Vec::new();
        for (index, line) in takeoff.lines(section_name).into_iter().enumerate() {
            let measured = line.mass_kg.unwrap_or(line.quantity);
            let unit = if line.mass_kg.is_some() { Unit::Kilogram } else { line.unit };
            let mut used = vec![0.0; book.items().len()];
            let of_group = groups.iter_mut().find(|(group, _)| *group == line.item.group()).map(|(_, sums)| sums);
            let sums = of_group.into_iter().flatten();
            matrix.of_item(line.item).iter().for_each(|&(at, per_unit)| used[at] += per_unit * measured);
            sums.zip(&used).for_each(|(sum, own)| *sum += own);
            lines.push(CarbonRow {
                line: Some(index + 1),
                name: line.item.id().to_owned(),
                description: line.description,
                quantity: Some((measured, unit)),
                figures: CarbonFigures::of(&used, book),
            });
        }
        let mut all = vec![0.0; book.items().len()];
        groups.iter().for_each(|(_, used)| all.iter_mut().zip(used).for_each(|(sum, own)| *sum += own));
        let filled = groups.iter().filter(|(_, used)| used.iter().any(|q| *q > 0.0));
        let groups = filled.map(|(group, used)| CarbonRow {
            line: None,
            name: group.name().to_owned(),
            description: group.name().to_owned(),
            quantity: None,
            figures: CarbonFigures::of(used, book),
        });
        let total = CarbonFigures::of(&all, book);
        Ok(CarbonAccount {
            floor_area_m2,
            per_m2: (floor_area_m2 > 0.0).then(|| total.per(floor_area_m2)),
            total,
            groups: groups.collect(),
            lines,
            materials: materials(&all, book),
            scope: book.scope.clone(),
            sources: sources(&all, book),
            version: book.version.clone(),
        })
    }
}

fn materials(used: &[f64], book: &CarbonBook) -> Vec<CarbonRow> {
    let row = |at: usize| {
        let mut own = vec![0.0; used.len()];
        own[at] = used[at];
        let material = &book.items()[at];
        CarbonRow {
            line: None,
            name: material.id.clone(),
            description: material.description.clone(),
            quantity: Some((used[at], material.unit)),
            figures: CarbonFigures::of(&own, book),
        }
    };
    (0..used.len()).filter(|&at| used[at] > 0.0).map(row).collect()
}

fn sources(used: &[f64], book: &CarbonBook) -> BTreeMap<String, BTreeMap<String, String>> {
    let present = book.items().iter().zip(used).filter(|(_, q)| **q > 0.0);
    let of = |stage: Stage, factor: Option<&super::StageFactor>| {
        (stage.title().to_owned(), factor.map_or_else(|| "unknown".to_owned(), |f| f.source.clone()))
    };
    present
        .map(|(material, _)| {
            let mut own: BTreeMap<String, String> = Stage::ALL.map(|stage| of(stage, material.stage(stage))).into();
            own.insert("A1-A3".to_owned(), material.source.clone());
            own.insert("energy".to_owned(), material.energy_source.clone().unwrap_or_else(|| "unknown".to_owned()));
            (material.id.clone(), own)
        })
        .collect()
}

fn add(sum: &mut Range, factor: Range, quantity: f64) {
    sum.iter_mut().zip(factor).for_each(|(sum, factor)| *sum += factor * quantity);
}
