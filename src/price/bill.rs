//! The bill of materials: the detailed take-off with rates, line by line; its sums are the cost.

use serde::Serialize;

use super::{Books, PriceError, Resolved};
use crate::quantities::{FrameMaterial, Item, Takeoff, TakeoffLine, Unit};

/// One line of the bill, net of overhead and VAT; the columns of `bom.csv` in their order.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BillLine {
    /// Number from 1.
    pub line: usize,
    /// Section of the bill.
    pub group: String,
    /// Item of the take-off.
    pub item: String,
    /// What it is.
    pub description: String,
    /// Billed quantity.
    pub quantity: f64,
    /// Unit of quantity and rate.
    pub unit: Unit,
    /// Default rate per unit.
    pub rate: f64,
    /// Quantity times rate.
    pub amount: f64,
    /// The same at the low rate.
    pub amount_low: f64,
    /// The same at the high rate.
    pub amount_high: f64,
    /// Mass in kg.
    pub mass_kg: f64,
    /// Fossil kgCO2e, A1-A3, default.
    pub gwp_kgco2e: f64,
    /// Stored biogenic kgCO2, at most 0.
    pub biogenic_kgco2e: f64,
    /// Energy in MJ; `None` where a part has no data.
    pub energy_mj: Option<f64>,
    /// Book versions, build-up and the items of the books it rests on.
    pub source: String,
}

/// The bill of a take-off, in the order frame, envelope, openings, floors, stairs, foundation.
///
/// # Errors
/// An item without build-up, price or factor, as in [`Books::rates`].
pub fn bill(
    takeoff: &Takeoff,
    books: &Books,
    section_name: &dyn Fn(u16) -> String,
) -> Result<Vec<BillLine>, PriceError> {
    let lines = takeoff.lines(section_name);
    lines.iter().enumerate().map(|(index, line)| bill_line(index + 1, line, books)).collect()
}

fn bill_line(number: usize, line: &TakeoffLine, books: &Books) -> Result<BillLine, PriceError> {
    let material = FrameMaterial::ALL.into_iter().find(|m| m.item() == line.item);
    let (rates, name, text): (Resolved, String, Option<String>) = match material {
        Some(material) => (books.frame(material)?, format!("frame {}", material.id()), None),
        None => {
            let buildup = books.buildup(line.item)?;
            (buildup.rates, format!("build-up {}", buildup.id), Some(buildup.description))
        }
    };
    let billed = billed(line, books.prices.window_min_m2);
    let measured = line.mass_kg.unwrap_or(line.quantity);
    let description = match text {
        Some(text) if line.pieces > 0 => format!("{} no. {}: {text}", line.pieces, line.description),
        Some(text) => format!("{}: {text}", line.description),
        None => line.description.clone(),
    };
    let versions = format!("prices {}, carbon {}, {name}", books.prices.version, books.carbon.version);
    Ok(BillLine {
        line: number,
        group: line.item.group().name().into(),
        item: line.item.id().into(),
        description,
        quantity: billed,
        unit: line.unit,
        rate: rates.price[1],
        amount: billed * rates.price[1],
        amount_low: billed * rates.price[0],
        amount_high: billed * rates.price[2],
        mass_kg: measured * rates.mass_kg,
        gwp_kgco2e: measured * rates.gwp[1],
        biogenic_kgco2e: measured * rates.biogenic,
        energy_mj: rates.energy_mj.map(|energy| measured * energy),
        source: format!("{versions}: {}", rates.sources.join(" ")),
    })
}

/// Quantity that is paid for: windows have a least area each.
fn billed(line: &TakeoffLine, window_min_m2: f64) -> f64 {
    if line.item != Item::Window {
        return line.quantity;
    }
    let pieces = f64::from(line.pieces);
    pieces * (line.quantity / pieces).max(window_min_m2)
}
