//! Carbon of the stages beside A1-A3, and of every material: what a take-off consists of in the units of the factor list.
//!
//! A stage sums the factors that are known and keeps the items some part of which has none. Fossil and biogenic numbers never meet in a
//! sum, nor does D in any: storage and its release are numbers of their own, equal and opposite (EN 16485), and D lies beyond the boundary.

use serde::Serialize;

use super::carbon::Stage;
use super::{Books, PriceError, Range};
use crate::quantities::{FrameMaterial, Item, Takeoff};

/// For each item of the take-off, the items of the factor list in one measured unit.
#[derive(Clone, Debug, PartialEq)]
pub struct CarbonMatrix {
    rows: Vec<Vec<(usize, f64)>>,
    materials: usize,
}

impl CarbonMatrix {
    /// Reads the books once.
    ///
    /// # Errors
    /// An item without build-up or factor, as in [`Books::rates`].
    pub fn new(books: &Books) -> Result<CarbonMatrix, PriceError> {
        let place = |id: &str| books.carbon.items().iter().position(|item| item.id == id).unwrap_or(0);
        let mut rows: Vec<Vec<(usize, f64)>> = vec![Vec::new(); Item::COUNT];
        for item in Item::ALL {
            let row = &mut rows[item as usize];
            if let Some(material) = FrameMaterial::ALL.into_iter().find(|m| m.item() == item) {
                let using = books.buildups.of_frame(material)?;
                row.push((place(&books.carbon.item(&using.carbon, &format!("frame.{}", material.id()))?.id), 1.0));
                continue;
            }
            let buildup = books.buildups.of_item(item.id())?;
            for layer in &buildup.layers {
                let key = format!("buildup {}, layer \"{}\"", buildup.id, layer.label);
                for part in layer.parts.iter().filter(|part| part.elsewhere.is_none()) {
                    let found = books.buildups.carbon_quantity(&key, layer, part, &books.carbon)?;
                    let Some((at, per_unit)) = found.map(|(item, q)| (place(&item.id), q)).filter(|(_, q)| *q > 0.0)
                    else {
                        continue;
                    };
                    match row.iter_mut().find(|(known, _)| *known == at) {
                        Some((_, sum)) => *sum += per_unit,
                        None => row.push((at, per_unit)),
                    }
                }
            }
        }
        Ok(CarbonMatrix { rows, materials: books.carbon.items().len() })
    }

    /// What one measured unit of an item holds: place in the factor list, and units of it.
    pub fn of_item(&self, item: Item) -> &[(usize, f64)] {
        &self.rows[item as usize]
    }

    /// How much of each item of the factor list a house takes, in the order of the list and in its units.
    pub fn quantities(&self, takeoff: &Takeoff) -> Vec<f64> {
        let mut sums = vec![0.0; self.materials];
        for (row, measured) in self.rows.iter().zip(takeoff.measured()) {
            row.iter().for_each(|&(at, per_unit)| sums[at] += measured * per_unit);
        }
        sums
    }
}

/// kgCO2e of a stage in one measured unit of an item.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct StageRate {
    /// Of the parts that have a factor: low, default, high.
    known: Range,
    /// Whether all parts have one.
    is_complete: bool,
}

/// Factors of the stages for all items of the take-off, dense.
#[derive(Clone, Debug, PartialEq)]
pub struct StageTable {
    rows: [[StageRate; Stage::COUNT]; Item::COUNT],
    biogenic: [f64; Item::COUNT],
}

/// A stage of a house.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct StageSum {
    /// kgCO2e of what has a factor: low, default, high.
    pub known: Range,
    #[serde(skip)]
    unknown: u32,
}

impl StageSum {
    /// Items in the house some part of which has no factor.
    pub fn unknown_items(&self) -> impl Iterator<Item = Item> + '_ {
        Item::ALL.into_iter().filter(|&item| self.unknown >> item as usize & 1 == 1)
    }

    /// Whether every part has a factor.
    pub fn is_complete(&self) -> bool {
        self.unknown == 0
    }
}

/// Carbon of a house beside A1-A3.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CarbonSums {
    /// By stage, indexed by `Stage as usize`.
    pub stages: [StageSum; Stage::COUNT],
    /// Stored biogenic kgCO2, at most 0.
    pub storage: f64,
    /// Biogenic kgCO2 released in C3: all that was stored.
    pub release: f64,
}

impl CarbonSums {
    /// The sum of a stage.
    pub fn stage(&self, stage: Stage) -> &StageSum {
        &self.stages[stage as usize]
    }
}

impl StageTable {
    /// Compiles the books into one row per item.
    ///
    /// # Errors
    /// As [`CarbonMatrix::new`].
    pub fn new(books: &Books) -> Result<StageTable, PriceError> {
        let matrix = CarbonMatrix::new(books)?;
        let none = [StageRate { known: [0.0; 3], is_complete: true }; Stage::COUNT];
        let mut table = StageTable { rows: [none; Item::COUNT], biogenic: [0.0; Item::COUNT] };
        for item in Item::ALL {
            for &(at, per_unit) in matrix.of_item(item) {
                let material = &books.carbon.items()[at];
                table.biogenic[item as usize] += material.biogenic * per_unit;
                for stage in Stage::ALL {
                    let rate = &mut table.rows[item as usize][stage as usize];
                    match material.stage(stage) {
                        Some(factor) => add(&mut rate.known, factor.range(), per_unit),
                        None => rate.is_complete = false,
                    }
                }
            }
        }
        Ok(table)
    }

    /// The stages of a take-off: dot products over its items.
    pub fn of(&self, takeoff: &Takeoff) -> CarbonSums {
        let mut sums = CarbonSums::default();
        for (item, measured) in Item::ALL.into_iter().zip(takeoff.measured()) {
            self.add(item, measured, &mut sums);
        }
        sums
    }

    /// The stages of a measured quantity of one item; members of the frame in kg.
    pub fn of_item(&self, item: Item, measured: f64) -> CarbonSums {
        let mut sums = CarbonSums::default();
        self.add(item, measured, &mut sums);
        sums
    }

    fn add(&self, item: Item, measured: f64, sums: &mut CarbonSums) {
        for (sum, rate) in sums.stages.iter_mut().zip(&self.rows[item as usize]) {
            add(&mut sum.known, rate.known, measured);
            sum.unknown |= u32::from(measured > 0.0 && !rate.is_complete) << item as usize;
        }
        sums.storage += self.biogenic[item as usize] * measured;
        sums.release -= self.biogenic[item as usize] * measured;
    }
}

fn add(sum: &mut Range, factor: Range, quantity: f64) {
    sum.iter_mut().zip(factor).for_each(|(sum, factor)| *sum += factor * quantity);
}

#[cfg(test)]
#[path = "stages_tests.rs"]
mod tests;
