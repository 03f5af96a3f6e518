//! Build-ups worked out from the books: what one unit costs, weighs and emits.

use serde::Serialize;

use super::{BuildUpKind, PriceItem, Range, Workplace};
use crate::quantities::Unit;

/// Materials of which a share more is bought than stays in the house.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Wasted {
    /// Waste as a share of what stays.
    pub share: f64,
    /// What stays, at low, default and high rates.
    pub base: Range,
}

impl Resolved {
    /// Adds `quantity` units of an item of the price book.
    pub(super) fn buy(&mut self, item: &PriceItem, quantity: f64) {
        for (sum, rate) in self.price.iter_mut().zip(item.in_place()) {
            *sum += rate * quantity;
        }
        for (sum, rate) in self.material.iter_mut().zip(item.range()) {
            *sum += rate * quantity;
        }
        match item.work {
            Workplace::Factory => self.factory_h += item.labour_h * quantity,
            Workplace::Site => self.site_h += item.labour_h * quantity,
        }
        if item.waste > 0.0 {
            waste(&mut self.wasted, item.waste, item.range().map(|rate| rate * quantity / (1.0 + item.waste)));
        }
        note_source(self, &item.id);
    }

    /// What the materials that stay in the house cost: without waste, as the lines of a bill have them. Low, default, high.
    pub fn stays(&self) -> Range {
        let mut stays = self.material;
        for waste in &self.wasted {
            (0..3).for_each(|k| stays[k] -= waste.share * waste.base[k]);
        }
        stays
    }
}

/// Adds to the materials with a share of waste, largest share first.
pub(super) fn waste(list: &mut Vec<Wasted>, share: f64, base: Range) {
    let at = list.partition_point(|known| known.share > share);
    match list.get_mut(at) {
        Some(known) if known.share == share => (0..3).for_each(|k| known.base[k] += base[k]),
        _ => list.insert(at, Wasted { share, base }),
    }
}

/// Rates of one unit of something: price net of overhead, mass, carbon, energy.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Resolved {
    /// Price per unit in place, net of overhead and VAT, with labour at the cost that the book was made with: low, default, high.
    pub price: Range,
    /// Of which materials and what is bought, waste included.
    pub material: Range,
    /// Waste in it: shares, each with the materials that it is a share of (net of waste); largest share first.
    pub wasted: Vec<Wasted>,
    /// Hours of work in the factory.
    pub factory_h: f64,
    /// Hours of work on the plot.
    pub site_h: f64,
    /// Mass per unit in kg.
    pub mass_kg: f64,
    /// Fossil kgCO2e A1-A3 per unit: low, default, high.
    pub gwp: Range,
    /// Stored biogenic kgCO2 per unit, at most 0.
    pub biogenic: f64,
    /// Energy in MJ per unit; `None` when a part has no data.
    pub energy_mj: Option<f64>,
    /// Energy in MJ per unit of the parts that have data.
    pub energy_known_mj: f64,
    /// Items of the price book and the factor list it uses.
    pub sources: Vec<String>,
}

/// A build-up with what follows from its layers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ResolvedBuildUp {
    /// Id.
    pub id: String,
    /// What it is.
    pub description: String,
    /// Unit.
    pub unit: Unit,
    /// What it is for.
    pub kind: BuildUpKind,
    /// Sum of the layers in mm, with zones that hold members of the frame.
    pub thickness_mm: f64,
    /// W/m2K; `None` inside the envelope.
    pub u_w_m2k: Option<f64>,
    /// Price, mass, carbon and energy per unit.
    pub rates: Resolved,
}

pub(super) fn note_source(rates: &mut Resolved, id: &str) {
    if !rates.sources.iter().any(|known| known == id) {
        rates.sources.push(id.into());
    }
}
