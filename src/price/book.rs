//! The price book: rates of finished work, net of overhead and VAT, with low, default and high, unit, source, year and region.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;

use super::PriceError;
use super::error::{expect_head, expect_text, expect_unique, read};
use super::price_item::PriceItem;
use super::works::WorksSettings;
use crate::quantities::Unit;

/// Low, default and high of one number, on one basis.
pub type Range = [f64; 3];

/// A percentage on top of the rates.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Surcharge {
    /// Id: `overhead_profit`, `contingency`, `design` or `vat`.
    pub id: String,
    low: f64,
    default: f64,
    high: f64,
    /// Source.
    pub source: String,
}

impl Surcharge {
    /// Low, default and high as fractions of the base.
    pub fn range(&self) -> Range {
        [self.low, self.default, self.high]
    }
}

/// Part of the completion allowance, per m2 of net floor area, with overhead, without VAT.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Allowance {
    /// Id.
    pub id: String,
    /// What it stands for.
    pub description: String,
    /// Always m2 (net floor area).
    pub unit: Unit,
    low: f64,
    default: f64,
    high: f64,
    /// Source.
    pub source: String,
}

impl Allowance {
    /// Low, default and high per m2 of net floor area.
    pub fn range(&self) -> Range {
        [self.low, self.default, self.high]
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PriceFile {
    schema: String,
    version: String,
    date: String,
    currency: String,
    vat: String,
    overhead: String,
    /// The book whose rates hold where this one has none: a path beside this file, or the name of a shipped book.
    extends: Option<String>,
    window_min_m2: Option<f64>,
    labour_basis_eur_h: Option<f64>,
    works: Option<WorksSettings>,
    #[serde(default)]
    sources: BTreeMap<String, String>,
    #[serde(default)]
    items: Vec<PriceItem>,
    #[serde(default)]
    rates: Vec<Surcharge>,
    #[serde(default)]
    completion: Vec<Allowance>,
}

/// Books that extend one another at most: more is a circle.
const LONGEST_CHAIN: usize = 8;

/// A price book (`houscaper.prices/1`): every rate net of overhead and VAT.
#[derive(Debug)]
pub struct PriceBook {
    /// Path it was read from, for messages.
    pub file: String,
    /// Paths of the books that it extends, the nearest first.
    pub extended: Vec<String>,
    /// Version of the book.
    pub version: String,
    /// Date of the book.
    pub date: String,
    /// Currency of all rates.
    pub currency: String,
    /// A window is billed with at least this area in m2.
    pub window_min_m2: f64,
    /// Hourly cost of labour inside the rates of this book.
    pub labour_basis_eur_h: f64,
    /// How houses are made, carried and put up.
    pub works: WorksSettings,
    /// Key of a source to its full reference.
    pub sources: BTreeMap<String, String>,
    /// The completion allowance.
    pub completion: Vec<Allowance>,
    items: Vec<PriceItem>,
    rates: Vec<Surcharge>,
}

impl PriceBook {
    /// Reads a price book and checks every value. A book that extends another is looked for beside the file that names it.
    ///
    /// # Errors
    /// Unknown or missing keys, units this program does not know, a basis other than net of overhead and VAT, empty sources, repeated ids,
    /// negative numbers or low > default > high, a circle of books; each names file and key.
    pub fn load(path: &Path) -> Result<PriceBook, PriceError> {
        Self::load_from(path, None)
    }

    /// As [`PriceBook::load`]; a book that is extended may also be one of those in the folder `shipped`.
    ///
    /// # Errors
    /// As [`PriceBook::load`].
    pub fn load_from(path: &Path, shipped: Option<&Path>) -> Result<PriceBook, PriceError> {
        Self::chain(path, shipped, LONGEST_CHAIN)
    }

    fn chain(path: &Path, shipped: Option<&Path>, left: usize) -> Result<PriceBook, PriceError> {
        let raw: PriceFile = read(path)?;
        let file = path.display().to_string();
        check(&raw, &file)?;
        let Some(name) = &raw.extends else {
            return Self::alone(raw, file);
        };
        if left == 0 {
            let expected = "expected a chain of books that ends";
            return Err(PriceError::Value { file, key: "extends".into(), found: name.clone(), expected });
        }
        let beside = path.parent().map_or_else(|| name.into(), |folder| folder.join(name));
        // A book may have the name of the shipped one that it extends.
        let itself = matches!((beside.canonicalize(), path.canonicalize()), (Ok(a), Ok(b)) if a == b);
        let base = match shipped.map(|folder| folder.join(name)) {
            Some(shipped) if (itself || !beside.is_file()) && shipped.is_file() => shipped,
            _ => beside,
        };
        Self::chain(&base, shipped, left - 1)?.with(raw, file)
    }

    /// A book that extends no other.
    fn alone(raw: PriceFile, file: String) -> Result<PriceBook, PriceError> {
        let missing = |key: &str, expected: &'static str| {
            let (file, key, found) = (file.clone(), key.to_owned(), "missing".to_owned());
            PriceError::Value { file, key, found, expected }
        };
        let window_min_m2 =
            raw.window_min_m2.ok_or_else(|| missing("window_min_m2", "expected an area in m2, 0 for none"))?;
        let basis = raw.labour_basis_eur_h;
        let basis = basis.ok_or_else(|| missing("labour_basis_eur_h", "expected the cost of an hour in the rates"))?;
        let works = raw.works.ok_or_else(|| missing("works", "expected how houses are made, carried and put up"))?;
        let items = raw.items.into_iter().map(|item| item.on_basis(basis, &file)).collect::<Result<_, _>>()?;
        Ok(PriceBook {
            extended: Vec::new(),
            version: raw.version,
            date: raw.date,
            currency: raw.currency,
            window_min_m2,
            labour_basis_eur_h: basis,
            works,
            sources: raw.sources,
            completion: raw.completion,
            items,
            rates: raw.rates,
            file,
        })
    }

    /// This book with what another one has in its place or besides.
    fn with(mut self, other: PriceFile, file: String) -> Result<PriceBook, PriceError> {
        expect_head(&file, "currency", &other.currency, &self.currency)?;
        let basis = other.labour_basis_eur_h.unwrap_or(self.labour_basis_eur_h);
        for item in other.items {
            let item = item.on_basis(basis, &file)?;
            match self.items.iter_mut().find(|known| known.id == item.id) {
                Some(known) if known.unit != item.unit => {
                    check_unit(&file, &format!("item {}", item.id), &item.id, item.unit, known.unit)?;
                }
                Some(known) => *known = item,
                None => self.items.push(item),
            }
        }
        for rate in other.rates {
            match self.rates.iter_mut().find(|known| known.id == rate.id) {
                Some(known) => *known = rate,
                None => self.rates.push(rate),
            }
        }
        for part in other.completion {
            match self.completion.iter_mut().find(|known| known.id == part.id) {
                Some(known) => *known = part,
                None => self.completion.push(part),
            }
        }
        self.sources.extend(other.sources);
        self.window_min_m2 = other.window_min_m2.unwrap_or(self.window_min_m2);
        self.works = other.works.unwrap_or(self.works);
        self.version = format!("{} over {}", other.version, self.version);
        self.date = other.date;
        self.extended.insert(0, std::mem::replace(&mut self.file, file));
        Ok(self)
    }

    /// The rates in file order.
    pub fn items(&self) -> &[PriceItem] {
        &self.items
    }

    /// The rate with this id; `needed_by` says who asks.
    ///
    /// # Errors
    /// No such item: the message names item and book.
    pub fn item(&self, id: &str, needed_by: &str) -> Result<&PriceItem, PriceError> {
        self.items.iter().find(|item| item.id == id).ok_or_else(|| self.missing(id, needed_by))
    }

    /// The surcharge with this id.
    ///
    /// # Errors
    /// No such surcharge.
    pub fn surcharge(&self, id: &str) -> Result<&Surcharge, PriceError> {
        self.rates.iter().find(|rate| rate.id == id).ok_or_else(|| self.missing(id, "every quote"))
    }

    fn missing(&self, id: &str, needed_by: &str) -> PriceError {
        PriceError::Missing { file: self.file.clone(), item: id.into(), needed_by: needed_by.into() }
    }
}

/// Every value of one file.
fn check(raw: &PriceFile, file: &str) -> Result<(), PriceError> {
    expect_head(file, "schema", &raw.schema, "houscaper.prices/1")?;
    if raw.date.parse::<jiff::civil::Date>().is_err() {
        let (file, key, found) = (file.to_owned(), "date".to_owned(), raw.date.clone());
        return Err(PriceError::Value { file, key, found, expected: "expected a date as 2026-11-22" });
    }
    expect_head(file, "overhead", &raw.overhead, "net")?;
    expect_head(file, "vat", &raw.vat, "excluded")?;
    expect_unique(file, raw.items.iter().map(|i| i.id.as_str()))?;
    expect_unique(file, raw.rates.iter().map(|i| i.id.as_str()))?;
    expect_unique(file, raw.completion.iter().map(|i| i.id.as_str()))?;
    for item in &raw.items {
        check_range(file, &item.id, item.in_place())?;
        check_range(file, &format!("{}.labour_h", item.id), [item.labour_h; 3])?;
        check_range(file, &format!("{}.waste", item.id), [item.waste; 3])?;
        expect_text(file, &format!("{}.source", item.id), &item.source)?;
        expect_text(file, &format!("{}.region", item.id), &item.region)?;
    }
    for rate in &raw.rates {
        check_range(file, &rate.id, rate.range())?;
        expect_text(file, &format!("{}.source", rate.id), &rate.source)?;
    }
    for part in &raw.completion {
        check_range(file, &part.id, part.range())?;
        expect_text(file, &format!("{}.source", part.id), &part.source)?;
        check_unit(file, &format!("completion {}", part.id), "net floor area", part.unit, Unit::SquareMetre)?;
    }
    check_range(file, "labour_basis_eur_h", [raw.labour_basis_eur_h.unwrap_or(0.0); 3])?;
    raw.works.as_ref().map_or(Ok(()), |works| works.check(file))?;
    check_range(file, "window_min_m2", [raw.window_min_m2.unwrap_or(0.0); 3])
}

/// Fails unless 0 <= low <= default <= high, all finite.
pub(super) fn check_range(file: &str, key: &str, range: Range) -> Result<(), PriceError> {
    let [low, default, high] = range;
    if range.iter().all(|v| v.is_finite()) && 0.0 <= low && low <= default && default <= high {
        return Ok(());
    }
    let found = format!("low {low}, default {default}, high {high}");
    let expected = "expected 0 <= low <= default <= high";
    Err(PriceError::Value { file: file.into(), key: key.into(), found, expected })
}

/// Fails unless a quantity has the unit of its rate.
pub(super) fn check_unit(file: &str, key: &str, item: &str, found: Unit, expected: Unit) -> Result<(), PriceError> {
    if found == expected {
        return Ok(());
    }
    Err(PriceError::UnitMismatch { file: file.into(), key: key.into(), item: item.into(), found, expected })
}
