//! One rate of the price book: as published in place, and what of it is bought, worked and wasted.

use serde::{Deserialize, Serialize};

use super::{PriceError, Range};
use crate::quantities::Unit;

/// How far a number can be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Evidence {
    /// Read in a published price list.
    Database,
    /// Assumed by us, stated as such.
    Assumption,
    /// Read in a market report.
    Market,
}

/// One rate.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PriceItem {
    /// Id, unique in the book.
    pub id: String,
    /// What it buys.
    pub description: String,
    /// Unit of the rate.
    pub unit: Unit,
    low: f64,
    default: f64,
    high: f64,
    /// Hours of work in the rate, per unit; 0 for a rate whose work is not told apart.
    #[serde(default)]
    pub labour_h: f64,
    /// Waste in the rate, as a share of the material that stays in the house; 0 for a rate whose waste is not told apart.
    #[serde(default)]
    pub waste: f64,
    /// Where the work is done.
    #[serde(default)]
    pub work: Workplace,
    /// What an hour costs in this rate.
    #[serde(skip)]
    basis_eur_h: f64,
    /// How far it can be trusted.
    pub kind: Evidence,
    /// Price level.
    pub year: u16,
    /// Region of the price level.
    pub region: String,
    /// Source with item number and conversion.
    pub source: String,
}

impl PriceItem {
    /// Low, default and high as published: in place, with labour at the hourly cost that the book was made with.
    pub fn in_place(&self) -> Range {
        [self.low, self.default, self.high]
    }

    /// Low, default and high of what is bought, waste included: the rate in place less its hours of work.
    pub fn range(&self) -> Range {
        self.in_place().map(|rate| rate - self.labour_h * self.basis_eur_h)
    }
}

impl PriceItem {
    /// The item in a book whose rates were made with this hourly cost.
    pub(super) fn on_basis(mut self, basis_eur_h: f64, file: &str) -> Result<PriceItem, PriceError> {
        self.basis_eur_h = basis_eur_h;
        if self.range()[0] >= 0.0 {
            return Ok(self);
        }
        let key = format!("{}.low", self.id);
        let found = format!("{}, of which {} h at {basis_eur_h} are labour", self.low, self.labour_h);
        let expected = "expected a rate in place of at least its own labour; lower `labour_h` or raise `low`";
        Err(PriceError::Value { file: file.into(), key, found, expected })
    }
}

/// Where work is done: what repeats in the factory goes faster with practice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Workplace {
    /// In the factory, part by part.
    #[default]
    Factory,
    /// On the plot.
    Site,
}
