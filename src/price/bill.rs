//! The bill of materials: the detailed take-off with rates, line by line; its sums are the cost.

use serde::Serialize;

use super::works::{WorksLine, WorksQuantities, WorksRates};
use super::{Books, PriceError, Resolved, Wasted};
use crate::quantities::{FrameMaterial, Group, Item, Takeoff, TakeoffLine, Unit, Works};

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

/// The bill of a take-off: materials in the order frame, envelope, openings, floors, stairs, foundation; then waste, labour, set-up and what
/// practice saves; then work on the plot, trucks, crane and crew. Lines of nothing are left out.
///
/// # Errors
/// An item without build-up, price or factor, as in [`Books::rates`].
pub fn bill(
    takeoff: &Takeoff,
    books: &Books,
    section_name: &dyn Fn(u16) -> String,
) -> Result<Vec<BillLine>, PriceError> {
    let mut wasted = Vec::new();
    let mut lines = Vec::new();
    for line in takeoff.lines(section_name) {
        lines.push(material_line(&line, books, &mut wasted)?);
    }
    lines.extend(wasted.iter().map(|waste| waste_line(waste, books)));
    let rates = books.rates()?;
    let (measured, billed) = (takeoff.measured(), takeoff.billed(rates.window_min_m2));
    let works = WorksQuantities::new(takeoff, &measured, &billed, &rates);
    lines.extend(works_lines(takeoff.works(), &works, &rates.works, books));
    lines.iter_mut().enumerate().for_each(|(index, line)| line.line = index + 1);
    Ok(lines)
}

/// Materials of one line of the take-off, without their waste, which joins `wasted`.
fn material_line(line: &TakeoffLine, books: &Books, wasted: &mut Vec<Wasted>) -> Result<BillLine, PriceError> {
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
    let stays = rates.stays();
    for waste in &rates.wasted {
        super::resolved::waste(wasted, waste.share, waste.base.map(|base| base * billed));
    }
    let versions = versions(books);
    Ok(BillLine {
        line: 0,
        group: line.item.group().name().into(),
        item: line.item.id().into(),
        description,
        quantity: billed,
        unit: line.unit,
        rate: stays[1],
        amount: billed * stays[1],
        amount_low: billed * stays[0],
        amount_high: billed * stays[2],
        mass_kg: measured * rates.mass_kg,
        gwp_kgco2e: measured * rates.gwp[1],
        biogenic_kgco2e: measured * rates.biogenic,
        energy_mj: rates.energy_mj.map(|energy| measured * energy),
        source: format!("{versions}, {name}: {}", rates.sources.join(" ")),
    })
}

/// A line that has a price and neither mass nor carbon of A1-A3.
fn service_line(group: Group, item: &str, description: String, [quantity, rate]: [f64; 2], unit: Unit) -> BillLine {
    BillLine {
        line: 0,
        group: group.name().into(),
        item: item.into(),
        description,
        quantity,
        unit,
        rate,
        amount: quantity * rate,
        amount_low: 0.0,
        amount_high: 0.0,
        mass_kg: 0.0,
        gwp_kgco2e: 0.0,
        biogenic_kgco2e: 0.0,
        energy_mj: Some(0.0),
        source: String::new(),
    }
}

fn waste_line(waste: &Wasted, books: &Books) -> BillLine {
    let text = format!("waste of materials that lose {:.0} %", 100.0 * waste.share);
    BillLine {
        amount_low: waste.share * waste.base[0],
        amount_high: waste.share * waste.base[2],
        source: format!("{}: materials above", versions(books)),
        ..service_line(Group::Manufacture, "waste", text, [waste.share, waste.base[1]], Unit::Share)
    }
}

fn works_lines(counts: &Works, works: &WorksQuantities, rates: &WorksRates, books: &Books) -> Vec<BillLine> {
    let amounts = works.amounts(rates);
    let line = |line: WorksLine| {
        let [low, amount, high] = amounts[line as usize];
        let base = |of: WorksLine| amounts[of as usize][1];
        let learning = format!("{:.0} % a doubling", 100.0 * rates.settings.learning()[1]);
        let (text, quantity, rate, unit) = match line {
            WorksLine::FactoryLabour => {
                ("labour in the factory".to_owned(), works.factory_h, rates.labour[1], Unit::Hour)
            }
            WorksLine::LearningLabour => (
                format!("practice: repeated panels and cassettes go faster, {learning}"),
                works.learned_labour[1] - 1.0,
                base(WorksLine::FactoryLabour),
                Unit::Share,
            ),
            WorksLine::SetupParts => (
                format!("set-up of distinct parts, of {} parts in all", counts.parts),
                works.part_types,
                rates.setup_part[1],
                Unit::Piece,
            ),
            WorksLine::LearningParts => (
                format!("practice in setting up parts, {learning}"),
                works.learned_parts[1] - 1.0,
                base(WorksLine::SetupParts),
                Unit::Share,
            ),
            WorksLine::SetupNodes => {
                ("set-up of distinct connections".to_owned(), works.node_types, rates.setup_node[1], Unit::Piece)
            }
            WorksLine::LearningNodes => (
                format!("practice in setting up connections, {learning}"),
                works.learned_nodes[1] - 1.0,
                base(WorksLine::SetupNodes),
                Unit::Share,
            ),
            WorksLine::SiteLabour => ("labour on the plot".to_owned(), works.site_h, rates.labour[1], Unit::Hour),
            WorksLine::TruckKm => (
                format!("transport, {:.0} km out and back", rates.settings.distance_km),
                works.km,
                rates.truck_km[1],
                Unit::Kilometre,
            ),
            WorksLine::TruckTrips => (
                format!("loading of trucks with {:.1} t and {:.0} m3 in all", works.carried_kg / 1e3, works.carried_m3),
                works.trips,
                rates.truck_trip[1],
                Unit::Piece,
            ),
            WorksLine::Crane => {
                (format!("mobile crane, {} lifts", counts.lifts), works.crane_days, rates.crane_day[1], Unit::Day)
            }
            WorksLine::Assembly => (
                format!("assembly, a crew of {:.0} while the crane is there", rates.settings.crew),
                works.assembly_h,
                rates.labour[1],
                Unit::Hour,
            ),
        };
        BillLine {
            amount,
            amount_low: low,
            amount_high: high,
            source: format!("{}: {}", versions(books), line.price_item()),
            ..service_line(line.group(), line.id(), text, [quantity, rate], unit)
        }
    };
    WorksLine::ALL.into_iter().map(line).filter(|line| line.quantity != 0.0).collect()
}

fn versions(books: &Books) -> String {
    format!("prices {}, carbon {}", books.prices.version, books.carbon.version)
}

/// Quantity that is paid for: windows have a least area each.
fn billed(line: &TakeoffLine, window_min_m2: f64) -> f64 {
    if line.item != Item::Window {
        return line.quantity;
    }
    let pieces = f64::from(line.pieces);
    pieces * (line.quantity / pieces).max(window_min_m2)
}
