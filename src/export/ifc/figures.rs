//! Take-off, price and carbon of a product: its shares of the rows, with what the books say of them.

use super::Facts;
use super::model::{Model, Property, Quantity};
use super::record::{Id, Value};
use crate::price::{BillLine, CarbonAccount, Range, Stage};
use crate::quantities::Unit;

/// Set of the quantities of the take-off itself, by item.
pub(super) const TAKEOFF: &str = "Houscaper_TakeOff";

/// Class of a quantity by its unit.
fn class(unit: Unit) -> &'static str {
    match unit {
        Unit::SquareMetre => "AREA",
        Unit::Metre => "LENGTH",
        Unit::CubicMetre => "VOLUME",
        Unit::Kilogram => "WEIGHT",
        _ => "COUNT",
    }
}

/// Sum of a product's shares in the rows whose item fits.
pub(super) fn sum(facts: &Facts, shares: &[(usize, f64)], fits: impl Fn(crate::quantities::Item) -> bool) -> f64 {
    shares.iter().filter(|(row, _)| fits(facts.rows[*row].item)).map(|(_, q)| q).sum()
}

/// The shares themselves, as quantities named like the items; two rows of one item are told apart by their lines.
pub(super) fn takeoff(model: &mut Model, facts: &Facts, which: &str, on: Id, shares: &[(usize, f64)]) {
    let quantity = |(at, (row, value)): (usize, &(usize, f64))| {
        let row = &facts.rows[*row];
        let again = shares[..at].iter().any(|(other, _)| facts.rows[*other].item == row.item);
        let name = if again { format!("{} line {}", row.item.id(), row.line) } else { row.item.id().to_owned() };
        let note = Some(format!("line {}: {}", row.line, row.description));
        Quantity { class: class(row.unit), name, note, value: *value }
    };
    let list: Vec<Quantity> = shares.iter().enumerate().map(quantity).collect();
    model.quantities(TAKEOFF, which, on, &list);
}

/// Price and carbon of a product, and its mass in kg: of each row the share of its line in the bill.
pub(super) fn priced(model: &mut Model, facts: &Facts, on: Id, shares: &[(usize, f64)]) -> Option<f64> {
    let of = |value: &dyn Fn(&BillLine) -> f64| {
        let part = |(row, quantity): &(usize, f64)| {
            let whole = facts.rows[*row].quantity;
            facts.bill.get(*row).map_or(0.0, |line| value(line) * quantity / whole)
        };
        shares.iter().map(part).sum::<f64>()
    };
    if shares.is_empty() || facts.bill.is_empty() {
        return None;
    }
    let books = &facts.evaluator.books;
    let money =
        |name: &str, value: f64| Property::new(name, Value::Real("IFCMONETARYMEASURE", value)).unit(model.money);
    let price = vec![
        money("Materials", of(&|l| l.amount)).note("materials as they stay in the house, default rates, net of waste, labour, overhead and VAT; the rest of the price is the building's"),
        money("MaterialsLow", of(&|l| l.amount_low)),
        money("MaterialsHigh", of(&|l| l.amount_high)),
        Property::label("PriceBook", &books.prices.version),
        Property::new("PriceBookDate", Value::Text("IFCDATE", books.prices.date.clone())),
    ];
    let mut carbon = vec![
        kg_co2e(model, "FossilA1A3", of(&|l| l.gwp_kgco2e))
            .note("fossil greenhouse gas of A1-A3 (EN 15804), kgCO2e, default factors"),
        kg_co2e(model, "BiogenicStorage", of(&|l| l.biogenic_kgco2e))
            .note("stored biogenic carbon, kgCO2, at most 0: never netted with the fossil number"),
    ];
    // A product of which one part has no data on energy has none: the sum would be of something else.
    if shares.iter().all(|(row, _)| facts.bill.get(*row).is_some_and(|l| l.energy_mj.is_some())) {
        let joule = 1e6 * of(&|l| l.energy_mj.unwrap_or(0.0));
        let energy = Property::new("NonRenewableEnergyA1A3", Value::Real("IFCENERGYMEASURE", joule));
        carbon.push(energy.note("non-renewable primary energy of A1-A3, J"));
    }
    carbon.push(Property::label("FactorList", &books.carbon.version));
    carbon.push(Property::new("FactorListDate", Value::Text("IFCDATE", books.carbon.date.clone())));
    model.properties("Houscaper_Price", on, price);
    model.properties("Houscaper_Carbon", on, carbon);
    Some(of(&|l| l.mass_kg))
}

fn kg_co2e(model: &Model, name: &str, value: f64) -> Property {
    Property::new(name, Value::Real("IFCMASSMEASURE", value)).unit(Some(model.carbon))
}

/// The whole house: what it costs in place and emits, with what products do not hold.
pub(super) fn of_building(model: &mut Model, facts: &Facts, building: Id) {
    let (Some(cost), Some(takeoff)) = (&facts.details.evaluation.cost, &facts.details.evaluation.takeoff) else {
        return;
    };
    let books = &facts.evaluator.books;
    let money = model.money;
    let range = |name: &str, note: &str, values: Range| {
        let named = [format!("{name}Low"), name.to_owned(), format!("{name}High")];
        let property = |(name, value): (String, f64)| {
            Property::new(&name, Value::Real("IFCMONETARYMEASURE", value)).note(note).unit(money)
        };
        named.into_iter().zip(values).map(property).collect::<Vec<_>>()
    };
    let in_products: f64 = facts.bill[..facts.rows.len()].iter().map(|l| l.amount).sum();
    let rest: f64 = facts.bill[facts.rows.len()..].iter().map(|l| l.amount).sum();
    let single = |name: &str, note: &str, value: f64| {
        Property::new(name, Value::Real("IFCMONETARYMEASURE", value)).note(note).unit(money)
    };
    let mut price = range("NetTotal", "sum of the bill, net of overhead and VAT", cost.net_eur);
    price.extend(range(
        "PriceInPlace",
        "envelope and frame in place: with overhead, profit and contingency, net of VAT; indicative, not an offer",
        cost.price_eur,
    ));
    price.push(single(
        "MaterialsOfProducts",
        "sum of Houscaper_Price.Materials over all products and what the building itself holds",
        in_products,
    ));
    price.push(single("WasteLabourTransportAssembly", "lines of the bill that belong to no product", rest));
    price.push(Property::label("PriceBook", &books.prices.version));
    price.push(Property::new("PriceBookDate", Value::Text("IFCDATE", books.prices.date.clone())));
    model.properties("Houscaper_Price", building, price);
    let floor = crate::score::floor_area_m2(&facts.details.reading);
    let section = |number: u16| facts.evaluator.catalogue.section_id(number);
    let mut carbon: Vec<Property> = ["FossilA1A3Low", "FossilA1A3", "FossilA1A3High"]
        .iter()
        .zip(cost.gwp_fossil)
        .map(|(name, value)| kg_co2e(model, name, value).note("fossil greenhouse gas of A1-A3 (EN 15804), kgCO2e"))
        .collect();
    carbon.push(kg_co2e(model, "BiogenicStorage", cost.biogenic).note("stored biogenic carbon, kgCO2, at most 0"));
    if let Ok(account) = CarbonAccount::new(takeoff, books, &section, floor) {
        for (stage, name) in Stage::ALL.into_iter().zip(["A4", "A5", "C3C4", "D"]) {
            let figure = account.total.stage(stage);
            let unknown = match figure.unknown.len() {
                0 => "all materials known".to_owned(),
                n => format!("without {n} materials that have no factor"),
            };
            carbon.push(kg_co2e(model, name, figure.known[1]).note(&format!("stage {}: {unknown}", stage.title())));
        }
    }
    carbon.push(Property::label("FactorList", &books.carbon.version));
    carbon.push(Property::new("FactorListDate", Value::Text("IFCDATE", books.carbon.date.clone())));
    model.properties("Houscaper_Carbon", building, carbon);
}
