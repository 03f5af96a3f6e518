//! The quote: the bill rounded to cents, what comes on top, and what is not in it. One record feeds JSON and HTML.

use std::collections::BTreeMap;

use jiff::civil::Date;
use serde::Serialize;
use sha2::{Digest, Sha256};

mod html;
mod practice;

pub use html::{escape, quote_html};
pub use practice::QuotePractice;

use practice::works;

use super::{BillLine, Books, PriceError, Range, bill};
use crate::quantities::Takeoff;

/// What a quote says about the house besides its lines.
#[derive(Clone, Debug, PartialEq)]
pub struct QuoteHead {
    /// Name of the house.
    pub name: String,
    /// Net floor area in m2: inside the wall lining, headroom at least 1.5 m, without voids, stairs and decks.
    pub floor_area_m2: f64,
    /// Day of issue; `None` for the date of the price book, so that a house always gives the same file.
    pub issued: Option<Date>,
}

/// How long a quote is valid, days. Assumption: what builders commonly offer.
pub const VALID_DAYS: i64 = 30;

/// A percentage on top.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct QuoteSurcharge {
    /// Id in the price book.
    pub id: String,
    /// What it is.
    pub description: String,
    /// What the percentage is taken of.
    pub base: f64,
    /// Default percentage.
    pub percentage: f64,
    /// Base times percentage, rounded to cents.
    pub amount: f64,
    /// The same with low base and percentage.
    pub amount_low: f64,
    /// The same with high base and percentage.
    pub amount_high: f64,
    /// Source of the percentage.
    pub source: String,
}

/// A line of the completion allowance: with overhead, without VAT, and in no other sum than `complete_house`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct QuoteAllowance {
    /// Id in the price book.
    pub id: String,
    /// What it stands for.
    pub description: String,
    /// Net floor area in m2.
    pub quantity: f64,
    /// Default per m2.
    pub rate: f64,
    /// Default amount.
    pub amount: f64,
    /// Low amount.
    pub amount_low: f64,
    /// High amount.
    pub amount_high: f64,
    /// Source.
    pub source: String,
}

/// A quote; money is rounded to cents line by line, and every total is the sum of the printed lines.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quote {
    /// `houscaper.quote/2`.
    pub schema: String,
    /// Number of this quote, from its content without the dates: equal content, equal number.
    pub reference: String,
    /// Day of issue, YYYY-MM-DD.
    pub issued: String,
    /// Last day on which it is valid, YYYY-MM-DD.
    pub valid_until: String,
    /// Name of the house.
    pub name: String,
    /// What a reader must know first.
    pub notice: String,
    /// Currency of all amounts.
    pub currency: String,
    /// Basis of the lines.
    pub basis: String,
    /// Rounding rule.
    pub rounding: String,
    /// Date and versions of the books.
    pub books: BTreeMap<String, String>,
    /// Net floor area in m2.
    pub floor_area_m2: f64,
    /// How that area is measured.
    pub floor_area_definition: String,
    /// The bill, amounts rounded to cents.
    pub lines: Vec<BillLine>,
    /// Sum of the lines: low, default, high.
    pub subtotal: Range,
    /// Overhead and profit, contingency: they lead from `subtotal` to `price_eur`.
    pub surcharges: Vec<QuoteSurcharge>,
    /// Envelope and frame in place, net of VAT: the objective `price_eur`. Low, default, high.
    pub price_eur: Range,
    /// Design fees and VAT: they lead from `price_eur` to `total`.
    pub further: Vec<QuoteSurcharge>,
    /// Envelope and frame with design and VAT: low, default, high.
    pub total: Range,
    /// The completion allowance.
    pub completion: Vec<QuoteAllowance>,
    /// `price_eur` and completion, net of VAT and without design: low, default, high.
    pub complete_house: Range,
    /// The same per m2 of net floor area; `None` without floor area.
    pub complete_house_per_m2: Option<Range>,
    /// How repetition was counted.
    pub practice: QuotePractice,
    /// What was assumed of making, carrying and putting up.
    pub assumptions: Vec<String>,
    /// What the rates already contain.
    pub included: Vec<String>,
    /// What is not in the quote.
    pub exclusions: Vec<String>,
    /// Rates used by the lines, with their sources.
    pub sources: BTreeMap<String, String>,
}

/// Writes the quote of a take-off.
///
/// # Errors
/// An item without build-up, price or factor, as in [`Books::rates`].
pub fn quote(
    head: &QuoteHead,
    takeoff: &Takeoff,
    books: &Books,
    section_name: &dyn Fn(u16) -> String,
) -> Result<Quote, PriceError> {
    let mut lines = bill(takeoff, books, section_name)?;
    for line in &mut lines {
        for amount in [&mut line.amount, &mut line.amount_low, &mut line.amount_high] {
            *amount = cents(*amount);
        }
    }
    let column = |of: fn(&BillLine) -> f64| cents(lines.iter().map(of).sum());
    let subtotal = [column(|l| l.amount_low), column(|l| l.amount), column(|l| l.amount_high)];

    let (overhead, sum) = surcharge(books, "overhead_profit", "Overhead and profit", subtotal)?;
    let (contingency, price_eur) = surcharge(books, "contingency", "Contingency", sum)?;
    let (design, sum) = surcharge(books, "design", "Design and engineering", price_eur)?;
    let (vat, total) = surcharge(books, "vat", "Value added tax", sum)?;

    let completion: Vec<QuoteAllowance> = completion(books, head.floor_area_m2);
    let add = |k: usize, of: fn(&QuoteAllowance) -> f64| cents(price_eur[k] + completion.iter().map(of).sum::<f64>());
    let complete_house = [add(0, |a| a.amount_low), add(1, |a| a.amount), add(2, |a| a.amount_high)];
    let per_m2 = |sums: Range| sums.map(|sum| cents(sum / head.floor_area_m2));
    let rates = books.rates()?;
    let (practice, assumptions) = works(takeoff, &rates);
    let mut quote = Quote {
        schema: "houscaper.quote/2".into(),
        reference: String::new(),
        issued: String::new(),
        valid_until: String::new(),
        name: head.name.clone(),
        notice: "Indicative, not an offer.".into(),
        currency: books.prices.currency.clone(),
        basis: "Materials, labour, transport and assembly are lines of their own, net of overhead and of VAT.".into(),
        rounding: "Every amount is rounded to cents; every total is the sum of the printed amounts.".into(),
        books: versions(books),
        floor_area_m2: head.floor_area_m2,
        floor_area_definition: FLOOR_AREA.into(),
        practice,
        assumptions,
        sources: sources(&lines, books),
        lines,
        subtotal,
        surcharges: vec![overhead, contingency],
        price_eur,
        further: vec![design, vat],
        total,
        complete_house,
        complete_house_per_m2: (head.floor_area_m2 > 0.0).then(|| per_m2(complete_house)),
        completion,
        included: INCLUDED.map(String::from).to_vec(),
        exclusions: EXCLUSIONS.map(String::from).to_vec(),
    };
    quote.reference = reference(&quote);
    (quote.issued, quote.valid_until) = dates(head, books);
    Ok(quote)
}

const FLOOR_AREA: &str =
    "net: inside the wall lining, headroom at least 1.5 m, without voids, stair openings, decks and terraces";

/// A number from the content of a quote: eight digits of its hash, in two groups.
fn reference(quote: &Quote) -> String {
    // A quote holds numbers and text only, which always serialise.
    let content = serde_json::to_vec(quote).unwrap_or_default();
    let digits: String = Sha256::digest(content).iter().take(4).map(|byte| format!("{byte:02X}")).collect();
    format!("HC-{}-{}", &digits[..4], &digits[4..])
}

/// Day of issue and last day of validity.
fn dates(head: &QuoteHead, books: &Books) -> (String, String) {
    // The book's date is checked when it is read.
    let issued = head.issued.or_else(|| books.prices.date.parse().ok()).unwrap_or_default();
    let until = issued.checked_add(jiff::Span::new().days(VALID_DAYS)).unwrap_or(issued);
    (issued.to_string(), until.to_string())
}

const INCLUDED: [&str; 3] = [
    "Bringing materials to where they are worked, small plant and scaffolding are inside the rates.",
    "Fasteners and ordinary connections are inside the rates of the frame.",
    "Windows are billed with at least the least area of the price book each.",
];

const EXCLUSIONS: [&str; 5] = [
    "Land, permits, fees, surveys and financing.",
    "Services, fit-out and groundworks: see the completion allowance, which is no part of the price of envelope and frame.",
    "Chimneys, sun shading, gates and everything outside the building.",
    "Special connections, moment joints and fire protection of steel.",
    "Changes of prices after the date of the price book.",
];

/// One surcharge on `base`, and the sum with it.
fn surcharge(books: &Books, id: &str, text: &str, base: Range) -> Result<(QuoteSurcharge, Range), PriceError> {
    let rate = books.prices.surcharge(id)?;
    let part = rate.range();
    let amount = [0, 1, 2].map(|k| cents(base[k] * part[k]));
    let line = QuoteSurcharge {
        id: id.into(),
        description: text.into(),
        base: base[1],
        percentage: cents(100.0 * part[1]),
        amount: amount[1],
        amount_low: amount[0],
        amount_high: amount[2],
        source: rate.source.clone(),
    };
    Ok((line, [0, 1, 2].map(|k| cents(base[k] + amount[k]))))
}

fn completion(books: &Books, floor_area_m2: f64) -> Vec<QuoteAllowance> {
    let line = |part: &super::Allowance| {
        let amounts = part.range().map(|rate| cents(rate * floor_area_m2));
        QuoteAllowance {
            id: part.id.clone(),
            description: part.description.clone(),
            quantity: floor_area_m2,
            rate: part.range()[1],
            amount: amounts[1],
            amount_low: amounts[0],
            amount_high: amounts[2],
            source: part.source.clone(),
        }
    };
    books.prices.completion.iter().map(line).collect()
}

fn versions(books: &Books) -> BTreeMap<String, String> {
    let text = |version: &str, date: &str| format!("version {version} of {date}");
    BTreeMap::from([
        ("prices".into(), text(&books.prices.version, &books.prices.date)),
        ("carbon".into(), text(&books.carbon.version, &books.carbon.date)),
        ("buildups".into(), text(&books.buildups.version, &books.buildups.date)),
    ])
}

/// Sources of the rates that the lines name.
fn sources(lines: &[BillLine], books: &Books) -> BTreeMap<String, String> {
    let used = |id: &str| {
        let named =
            |line: &BillLine| line.source.rsplit(": ").next().is_some_and(|ids| ids.split(' ').any(|i| i == id));
        lines.iter().any(named)
    };
    let prices = books.prices.items().iter().filter(|item| used(&item.id));
    let prices = prices.map(|item| (format!("price {}", item.id), item.source.clone()));
    let carbon = books.carbon.items().iter().filter(|item| used(&item.id));
    prices.chain(carbon.map(|item| (format!("carbon {}", item.id), item.source.clone()))).collect()
}

/// Rounds to cents, half away from zero.
pub(super) fn cents(amount: f64) -> f64 {
    (amount * 100.0).round() / 100.0
}
