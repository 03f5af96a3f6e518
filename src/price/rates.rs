//! The rate table: books compiled to one row per item of the take-off; the cost of a house is a dot product with it.

use std::path::Path;

use serde::Serialize;

use super::resolved::{Resolved, ResolvedBuildUp};
use super::works::{WorksQuantities, WorksRates};
use super::{BuildUps, CarbonBook, PriceBook, PriceError, Range};
use crate::quantities::{FrameMaterial, Group, Item, Takeoff, Unit};

/// The three books a quote rests on.
#[derive(Debug)]
pub struct Books {
    /// Rates.
    pub prices: PriceBook,
    /// Carbon and energy factors.
    pub carbon: CarbonBook,
    /// Build-ups and their uses.
    pub buildups: BuildUps,
}

/// Rates of one item of the take-off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate {
    /// Price per billed unit in place, net of overhead and VAT, before practice, transport and assembly: low, default, high.
    pub price: Range,
    /// Of which materials and what is bought, waste included.
    pub material: Range,
    /// Hours of work in the factory per billed unit.
    pub factory_h: f64,
    /// Hours of work on the plot per billed unit.
    pub site_h: f64,
    /// Whether it is carried to the plot: everything but the foundation.
    pub carried: bool,
    /// Thickness of what is measured in m2 and carried, m; else 0.
    pub thickness_m: f64,
    /// Mass per measured unit in kg (1 for members of the frame, which are measured in kg).
    pub mass_kg: f64,
    /// Fossil kgCO2e A1-A3 per measured unit: low, default, high.
    pub gwp: Range,
    /// Stored biogenic kgCO2 per measured unit, at most 0.
    pub biogenic: f64,
    /// Energy in MJ per measured unit, as far as known.
    pub energy_known_mj: f64,
    /// Whether the energy of all its parts is known.
    pub energy_known: bool,
    /// U in W/m2K; 0 inside the envelope.
    pub u_w_m2k: f64,
}

/// Rates of all items, indexed by `Item as usize`, and what comes on top.
#[derive(Clone, Debug, PartialEq)]
pub struct RateTable {
    /// One row per item.
    pub rows: [Rate; Item::COUNT],
    /// Rates of what comes on top of materials.
    pub works: WorksRates,
    /// A window is billed with at least this area in m2.
    pub window_min_m2: f64,
    /// Factor from net rates to prices in place: (1 + overhead and profit) (1 + contingency); low, default, high.
    pub in_place: Range,
    /// Completion allowance per m2 of net floor area: low, default, high.
    pub completion_per_m2: Range,
}

/// What a house costs, weighs, emits and loses. Ranges are low, default, high.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cost {
    /// Sum of the bill, net of overhead and VAT, in the currency of the price book.
    pub net_eur: Range,
    /// Envelope and frame in place: with overhead, profit and contingency, net of VAT.
    pub price_eur: Range,
    /// Fossil kgCO2e, A1-A3.
    pub gwp_fossil: Range,
    /// Stored biogenic kgCO2, at most 0; never netted with the fossil number.
    pub biogenic: f64,
    /// Energy in MJ; `None` when an item in the house has no data, see [`Cost::unknown_energy_items`].
    pub energy_mj: Option<f64>,
    /// Energy in MJ of the items that have data.
    pub energy_known_mj: f64,
    /// Mass in kg, frame and foundation included.
    pub mass_kg: f64,
    /// Transmission heat loss of the envelope in W/K: sum of U A, soil resistance neglected, no thermal bridges of junctions.
    pub heat_loss_w_per_k: f64,
    unknown_energy: u32,
}

impl Cost {
    /// Items in the house whose energy is unknown.
    pub fn unknown_energy_items(&self) -> impl Iterator<Item = Item> + '_ {
        Item::ALL.into_iter().filter(|&item| self.unknown_energy >> item as usize & 1 == 1)
    }
}

/// Prices, weighs and rates one take-off: dot products over the items, and what making and putting it up takes.
///
/// ```
/// use houscaper::envelope::EnvelopeAreas;
/// use houscaper::price::{Books, cost};
/// use houscaper::quantities::Takeoff;
/// # use std::path::Path;
/// # let configs = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs");
/// let rates = Books::load(&configs)?.rates()?;
/// let mut areas = EnvelopeAreas::default();
/// areas.area_m2[0] = 10.0; // ten square metres of wall
/// let ten = cost(&Takeoff::new(&areas, 0.0)?, &rates);
/// // No parts are stated: materials and labour in place, and nothing is carried or lifted.
/// assert!((ten.net_eur[1] - 10.0 * rates.rows[0].price[1]).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn cost(takeoff: &Takeoff, rates: &RateTable) -> Cost {
    let (measured, billed) = (takeoff.measured(), takeoff.billed(rates.window_min_m2));
    let works = WorksQuantities::new(takeoff, &measured, &billed, rates);
    let mut sum = Cost {
        net_eur: [0.0; 3],
        price_eur: [0.0; 3],
        gwp_fossil: [0.0; 3],
        biogenic: 0.0,
        energy_mj: None,
        energy_known_mj: 0.0,
        mass_kg: 0.0,
        heat_loss_w_per_k: 0.0,
        unknown_energy: 0,
    };
    for (index, row) in rates.rows.iter().enumerate() {
        let (measured, billed) = (measured[index], billed[index]);
        for k in 0..3 {
            sum.net_eur[k] += billed * row.material[k];
            sum.gwp_fossil[k] += measured * row.gwp[k];
        }
        sum.biogenic += measured * row.biogenic;
        sum.energy_known_mj += measured * row.energy_known_mj;
        sum.mass_kg += measured * row.mass_kg;
        sum.unknown_energy |= u32::from(measured > 0.0 && !row.energy_known) << index;
    }
    for amount in works.amounts(&rates.works) {
        (0..3).for_each(|k| sum.net_eur[k] += amount[k]);
    }
    for (item, area) in takeoff.surfaces() {
        sum.heat_loss_w_per_k += area * rates.rows[item as usize].u_w_m2k;
    }
    for k in 0..3 {
        sum.price_eur[k] = sum.net_eur[k] * rates.in_place[k];
    }
    sum.energy_mj = (sum.unknown_energy == 0).then_some(sum.energy_known_mj);
    sum
}

impl Books {
    /// Loads `prices.json`, `carbon.json` and `buildups.json` from one folder.
    ///
    /// # Errors
    /// Any book that cannot be read or holds a bad value.
    pub fn load(folder: &Path) -> Result<Books, PriceError> {
        Ok(Books {
            prices: PriceBook::load(&folder.join("prices.json"))?,
            carbon: CarbonBook::load(&folder.join("carbon.json"))?,
            buildups: BuildUps::load(&folder.join("buildups.json"))?,
        })
    }

    /// Compiles the books into one row per item.
    ///
    /// # Errors
    /// An item without build-up, price or factor, a unit that does not match, a use of something that is no item; each names item and book.
    pub fn rates(&self) -> Result<RateTable, PriceError> {
        for name in self.buildups.uses() {
            if Item::from_id(name).is_none_or(Item::is_frame) {
                let (file, key) = (self.buildups.file.clone(), format!("uses.{name}"));
                let expected = "expected the name of an item of the take-off that is not a frame material";
                return Err(PriceError::Value { file, key, found: name.into(), expected });
            }
        }
        let works = WorksRates::new(self)?;
        let mut rows = [NO_RATE; Item::COUNT];
        for item in Item::ALL {
            rows[item as usize] = self.row(item, works.labour)?;
        }
        let overhead = self.prices.surcharge("overhead_profit")?.range();
        let contingency = self.prices.surcharge("contingency")?.range();
        let completion = |k: usize| self.prices.completion.iter().map(|part| part.range()[k]).sum();
        Ok(RateTable {
            rows,
            works,
            window_min_m2: self.prices.window_min_m2,
            in_place: [0, 1, 2].map(|k| (1.0 + overhead[k]) * (1.0 + contingency[k])),
            completion_per_m2: [0, 1, 2].map(completion),
        })
    }

    /// Every build-up of the file worked out, in file order.
    ///
    /// # Errors
    /// As [`Books::rates`].
    pub fn resolve_all(&self) -> Result<Vec<ResolvedBuildUp>, PriceError> {
        self.buildups.buildups().iter().map(|b| self.buildups.resolve(b, &self.prices, &self.carbon)).collect()
    }

    /// The build-up of an item that is not a frame material.
    ///
    /// # Errors
    /// As [`Books::rates`].
    pub fn buildup(&self, item: Item) -> Result<ResolvedBuildUp, PriceError> {
        let buildup = self.buildups.of_item(item.id())?;
        super::book::check_unit(
            &self.buildups.file,
            &format!("uses.{}", item.id()),
            &buildup.id,
            item.unit(),
            buildup.unit,
        )?;
        self.buildups.resolve(buildup, &self.prices, &self.carbon)
    }

    /// Rates of a frame material: price per billing unit, carbon per kg.
    ///
    /// # Errors
    /// As [`Books::rates`].
    pub fn frame(&self, material: FrameMaterial) -> Result<Resolved, PriceError> {
        let using = self.buildups.of_frame(material)?;
        let key = format!("frame.{}", material.id());
        let price = self.prices.item(&using.price, &key)?;
        let carbon = self.carbon.item(&using.carbon, &key)?;
        let file = &self.buildups.file;
        super::book::check_unit(file, &key, &price.id, material.item().unit(), price.unit)?;
        super::book::check_unit(file, &key, &carbon.id, Unit::Kilogram, carbon.unit)?;
        let mut rates = Resolved {
            mass_kg: 1.0,
            gwp: carbon.range(),
            biogenic: carbon.biogenic,
            energy_mj: carbon.energy_mj,
            energy_known_mj: carbon.energy_mj.unwrap_or(0.0),
            ..Resolved::default()
        };
        rates.buy(price, 1.0);
        rates.sources.push(carbon.id.clone());
        Ok(rates)
    }

    fn row(&self, item: Item, labour: Range) -> Result<Rate, PriceError> {
        let carried = item.group() != Group::Foundation;
        if let Some(material) = FrameMaterial::ALL.into_iter().find(|m| m.item() == item) {
            return Ok(Rate { carried, ..Rate::new(&self.frame(material)?, labour) });
        }
        let buildup = self.buildup(item)?;
        let flat = carried && item.unit() == Unit::SquareMetre;
        Ok(Rate {
            carried,
            thickness_m: if flat { buildup.thickness_mm / 1000.0 } else { 0.0 },
            u_w_m2k: buildup.u_w_m2k.unwrap_or(0.0),
            ..Rate::new(&buildup.rates, labour)
        })
    }
}

const NO_RATE: Rate = Rate {
    price: [0.0; 3],
    material: [0.0; 3],
    factory_h: 0.0,
    site_h: 0.0,
    carried: false,
    thickness_m: 0.0,
    mass_kg: 0.0,
    gwp: [0.0; 3],
    biogenic: 0.0,
    energy_known_mj: 0.0,
    energy_known: false,
    u_w_m2k: 0.0,
};

impl Rate {
    fn new(from: &Resolved, labour: Range) -> Rate {
        let hours = from.factory_h + from.site_h;
        Rate {
            price: [0, 1, 2].map(|k| from.material[k] + hours * labour[k]),
            material: from.material,
            factory_h: from.factory_h,
            site_h: from.site_h,
            mass_kg: from.mass_kg,
            gwp: from.gwp,
            biogenic: from.biogenic,
            energy_known_mj: from.energy_known_mj,
            energy_known: from.energy_mj.is_some(),
            ..NO_RATE
        }
    }
}
