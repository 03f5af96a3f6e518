//! The take-off by component: what is drawn beside what is priced, both weighed by the layers of the build-ups.

use crate::envelope::HouseVolumes;
use crate::price::{Books, BuildUp, PriceError};
use crate::quantities::{Item, Takeoff, Unit};
use crate::tiles::{Component, Shells, Stratum};

/// What the mass of a drawn component follows from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weighed {
    /// Its volume: a square metre of the stratum as drawn weighs what the build-up says.
    ByVolume,
    /// The quantity of its item: solids show where it is, its build-up says what it weighs (sheets, products).
    ByItem,
    /// Nothing of its own: it is part of a product that is weighed as another component.
    Within(Component),
    /// Nothing: no item is priced for it.
    Not,
}

/// A component of a house: drawn and priced. Masses are without members of the frame.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerRow {
    /// What it is.
    pub component: Component,
    /// Items of the take-off that hold it.
    pub items: Vec<Item>,
    /// Sum of the items' quantities, where all have one unit: m2 without openings, m, or pieces.
    pub quantity: Option<(f64, Unit)>,
    /// Mean thickness in mm over the items' areas; `None` for what is no stratum.
    pub thickness_mm: Option<f64>,
    /// Volume of its solids in m3, stairs included.
    pub volume_m3: f64,
    /// Quantity times thickness over its items, m3; 0 for what is no stratum.
    pub takeoff_m3: f64,
    /// kg of its materials in a cubic metre as drawn; `None` where volume does not decide.
    pub density_kg_m3: Option<f64>,
    /// Materials of the build-ups with their shares of the mass, largest first.
    pub materials: Vec<(String, f64)>,
    /// How it is weighed.
    pub weighed: Weighed,
    /// Mass of what is drawn, kg.
    pub mass_kg: f64,
    /// Mass of what is priced, kg: over all rows the mass of the take-off without its frame.
    pub takeoff_kg: f64,
    /// What its materials cost, without waste and work, in the books' currency: over all rows the material lines of the bill without
    /// the frame.
    pub price: f64,
    /// Fossil kgCO2e of its materials, A1-A3: over all rows that of the bill without the frame.
    pub gwp_kgco2e: f64,
    /// Build-ups it follows from.
    pub buildups: Vec<String>,
}

/// What one unit of an item holds of a component.
struct Share {
    item: Item,
    m3: f64,
    kg: f64,
    price: f64,
    gwp: f64,
    materials: Vec<(String, f64)>,
    buildup: String,
}

/// The take-off of a house by component, in the order of components; those that are neither drawn nor priced are left out.
///
/// `stretch` is the product of the house's module over that of the blocks. Layers of a build-up belong to the component that their
/// stratum names.
///
/// # Errors
/// A build-up is missing, a stratum is no component, or a material has no density.
pub fn layers(
    volumes: &HouseVolumes,
    stretch: f64,
    takeoff: &Takeoff,
    books: &Books,
    shells: &Shells,
) -> Result<Vec<LayerRow>, PriceError> {
    let mut shares: Vec<Vec<Share>> = Component::ALL.iter().map(|_| Vec::new()).collect();
    for item in Item::ALL.into_iter().filter(|item| !item.is_frame()) {
        add_shares(item, books, shells, &mut shares)?;
    }
    let (measured, drawn) = (takeoff.measured(), volumes.total());
    let billed = takeoff.billed(books.prices.window_min_m2);
    let rows = Component::ALL.iter().zip(&shares).map(|(&component, shares)| {
        let volume_m3 = drawn.m3(component, stretch);
        let price = shares.iter().map(|s| billed[s.item as usize] * s.price).sum();
        LayerRow { price, ..row(component, volume_m3, shares, &|item| measured[item as usize]) }
    });
    Ok(rows.filter(|row| row.volume_m3 > 0.0 || row.takeoff_kg > 0.0).collect())
}

fn add_shares(item: Item, books: &Books, shells: &Shells, shares: &mut [Vec<Share>]) -> Result<(), PriceError> {
    let buildup = books.buildups.of_item(item.id())?;
    let rates = books.buildups.stratum_rates(buildup, &books.prices, &books.carbon)?;
    for (stratum, (_, rates)) in books.buildups.stratum_masses(buildup)?.into_iter().zip(rates) {
        let component = component_of(item, buildup, stratum.name, books)?;
        let thickness_m = match drawn_um(item, stratum.name, shells) {
            Some(um) => f64::from(um) * 1e-6,
            None => stratum.thickness_mm / 1e3,
        };
        let m3 = match item {
            Item::PerimeterBeam => shells.beam_um.iter().map(|&um| f64::from(um) * 1e-6).product(),
            _ => thickness_m,
        };
        let materials = stratum.materials.iter().map(|(name, kg)| ((*name).to_owned(), *kg)).collect();
        let (price, gwp, buildup) = (rates.stays()[1], rates.gwp[1], buildup.id.clone());
        let share = Share { item, m3, kg: stratum.mass_kg, price, gwp, materials, buildup };
        shares[component as usize].push(share);
    }
    Ok(())
}

/// The component of a stratum: the cladding at a floor's edge is a band, and a build-up that names no stratum is one component.
fn component_of(item: Item, buildup: &BuildUp, name: &str, books: &Books) -> Result<Component, PriceError> {
    if name.is_empty() {
        return Ok(whole(item));
    }
    match Component::ALL.iter().copied().find(|c| c.name() == name) {
        Some(Component::Cladding) if item == Item::Band => Ok(Component::Band),
        Some(component) => Ok(component),
        None => Err(PriceError::Value {
            file: books.buildups.file.clone(),
            key: format!("buildup {}", buildup.id),
            found: name.to_owned(),
            expected: "expected strata that are names of components",
        }),
    }
}

/// The component that stands for all of an item.
fn whole(item: Item) -> Component {
    match item {
        Item::Wall | Item::WallBothSides => Component::WallInsulation,
        Item::Band => Component::Band,
        Item::Plinth => Component::PlinthInsulation,
        Item::Window => Component::WindowFrame,
        Item::Door => Component::DoorLeaf,
        Item::PitchedRoof => Component::RoofInsulation,
        Item::FlatRoof => Component::FlatInsulation,
        Item::Deck => Component::DeckBoards,
        Item::Soffit => Component::SoffitInsulation,
        Item::Ground => Component::GroundSlab,
        Item::Stair => Component::StairString,
        Item::Railing => Component::RailingRail,
        Item::PerimeterBeam => Component::PerimeterBeam,
        Item::Overhang => Component::Fascia,
        Item::Gutter => Component::Gutter,
        Item::Parapet => Component::Cladding,
        Item::Coping => Component::Coping,
        // Members of the frame are filtered out before.
        Item::InnerFloor | Item::FrameS235 | Item::FrameS355 | Item::FrameC24 | Item::FrameGl24h | Item::FrameGl28h => {
            Component::FloorStructure
        }
    }
}

/// Thickness in µm with which a stratum of an item is drawn; `None` for what is not drawn from the shells.
fn drawn_um(item: Item, name: &str, shells: &Shells) -> Option<i32> {
    let stacks: &[&[Stratum]] = match item {
        Item::Wall | Item::WallBothSides | Item::Band => &[&shells.wall],
        Item::Plinth => &[&shells.plinth],
        Item::PitchedRoof | Item::Overhang => &[&shells.roof_cover, &shells.roof],
        Item::FlatRoof => &[&shells.flat, &shells.floor],
        Item::Deck => &[&shells.deck, &shells.floor],
        Item::Soffit => &[&shells.soffit],
        Item::Ground => &[&shells.ground],
        Item::InnerFloor => &[&shells.floor],
        Item::Window | Item::Door | Item::Stair | Item::Railing | Item::PerimeterBeam => &[],
        Item::Gutter | Item::Parapet | Item::Coping => &[],
        Item::FrameS235 | Item::FrameS355 | Item::FrameC24 | Item::FrameGl24h | Item::FrameGl28h => &[],
    };
    let found = stacks.iter().copied().flatten().find(|s| s.component.name() == name);
    found.map(|s| s.thickness_um)
}

/// How a component is weighed, and the items of those that no build-up names.
fn weighed(component: Component) -> (Weighed, &'static [Item]) {
    use Component as C;
    match component {
        C::Cladding | C::Band | C::WallInsulation | C::WallLining => (Weighed::ByVolume, &[]),
        C::RoofCovering | C::RoofInsulation | C::RoofLining => (Weighed::ByVolume, &[]),
        C::FlatMembrane | C::FlatInsulation | C::DeckBoards => (Weighed::ByVolume, &[]),
        C::FloorBoards | C::FloorStructure | C::Ceiling => (Weighed::ByVolume, &[]),
        C::SoffitInsulation | C::SoffitBoards => (Weighed::ByVolume, &[]),
        C::GroundSlab | C::GroundInsulation | C::PerimeterBeam => (Weighed::ByVolume, &[]),
        C::PlinthInsulation | C::PlinthRender | C::Fascia => (Weighed::ByVolume, &[]),
        C::WindowFrame | C::Glass | C::DoorLeaf => (Weighed::ByItem, &[]),
        C::Gutter | C::Coping | C::RailingRail | C::StairString => (Weighed::ByItem, &[]),
        C::DoorFrame | C::Handle => (Weighed::Within(C::DoorLeaf), &[Item::Door]),
        C::Reveal => (Weighed::Within(C::WindowFrame), &[Item::Window, Item::Door]),
        C::Sill => (Weighed::Within(C::WindowFrame), &[Item::Window]),
        C::RailingGlass => (Weighed::Within(C::RailingRail), &[Item::Railing]),
        C::StairTread => (Weighed::Within(C::StairString), &[Item::Stair]),
        C::Paving => (Weighed::Not, &[]),
    }
}

fn row(component: Component, volume_m3: f64, shares: &[Share], quantity: &dyn Fn(Item) -> f64) -> LayerRow {
    let (weighed, others) = weighed(component);
    // Shares of items that the house has; of the others only where it has none of them, for what is drawn all the same.
    let mut present: Vec<&Share> = shares.iter().filter(|s| quantity(s.item) > 0.0).collect();
    let sum = |value: &dyn Fn(&Share) -> f64| shares.iter().map(|s| quantity(s.item) * value(s)).sum::<f64>();
    let (takeoff_m3, takeoff_kg) = (sum(&|s| s.m3), sum(&|s| s.kg));
    let per_m3 = if takeoff_m3 > 0.0 {
        Some(takeoff_kg / takeoff_m3)
    } else {
        shares.first().filter(|s| s.m3 > 0.0).map(|s| s.kg / s.m3)
    };
    let density_kg_m3 = per_m3.filter(|_| weighed == Weighed::ByVolume);
    let mass_kg = match weighed {
        Weighed::ByVolume => volume_m3 * density_kg_m3.unwrap_or(0.0),
        Weighed::ByItem => takeoff_kg,
        Weighed::Within(_) | Weighed::Not => 0.0,
    };
    let of_present = |share: &Share| if quantity(share.item) > 0.0 { quantity(share.item) } else { 1.0 };
    if present.is_empty() {
        present.extend(shares.first());
    }
    let mut materials: Vec<(String, f64)> = Vec::new();
    for share in &present {
        for (name, kg) in &share.materials {
            match materials.iter_mut().find(|(known, _)| known == name) {
                Some((_, sum)) => *sum += kg * of_present(share),
                None => materials.push((name.clone(), kg * of_present(share))),
            }
        }
    }
    let whole: f64 = materials.iter().map(|(_, kg)| kg).sum();
    materials.iter_mut().for_each(|(_, kg)| *kg /= whole);
    materials.sort_by(|a, b| b.1.total_cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    let mut items: Vec<Item> = present.iter().map(|s| s.item).collect();
    items.extend(others.iter().filter(|item| quantity(**item) > 0.0));
    items.dedup();
    let unit = items.first().map(|item| item.unit()).filter(|unit| items.iter().all(|item| item.unit() == *unit));
    let quantity = unit.map(|unit| (items.iter().map(|&item| quantity(item)).sum::<f64>(), unit));
    let stratum = weighed == Weighed::ByVolume && component != Component::PerimeterBeam;
    let thickness =
        quantity.filter(|(q, _)| stratum && *q > 0.0 && takeoff_m3 > 0.0).map(|(q, _)| takeoff_m3 / q * 1e3);
    let mut buildups: Vec<String> = present.iter().map(|s| s.buildup.clone()).collect();
    buildups.dedup();
    LayerRow {
        component,
        items,
        quantity,
        thickness_mm: thickness,
        volume_m3,
        takeoff_m3: if weighed == Weighed::ByVolume { takeoff_m3 } else { 0.0 },
        density_kg_m3,
        materials,
        weighed,
        mass_kg,
        takeoff_kg,
        price: 0.0,
        gwp_kgco2e: sum(&|s| s.gwp),
        buildups,
    }
}
