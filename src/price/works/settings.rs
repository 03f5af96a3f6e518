//! How houses are made, carried and put up, and what that costs: settings and rates of the price book.

use serde::Deserialize;

use crate::price::book::{check_range, check_unit};
use crate::price::error::expect_text;
use crate::price::{Books, PriceError, Range};
use crate::quantities::Unit;

/// How houses are made, carried and put up; part of a price book.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WorksSettings {
    /// From factory to plot, km; trucks come back empty.
    pub distance_km: f64,
    /// What a truck carries, kg.
    pub payload_kg: f64,
    /// Its load space, m3.
    pub load_m3: f64,
    /// Share of the load space that parts fill.
    pub load_fill: f64,
    /// Parts that a crane lifts in a day.
    pub lifts_per_day: f64,
    /// People at the crane.
    pub crew: f64,
    /// Hours of a working day.
    pub hours_per_day: f64,
    /// Learning rates: what a doubling of the pieces makes of the time of the last one.
    learning_low: f64,
    learning_default: f64,
    learning_high: f64,
    /// Source of these values.
    pub source: String,
}

impl WorksSettings {
    /// Learning rate that makes houses cheap, the default, and the one that makes them dear.
    pub fn learning(&self) -> Range {
        [self.learning_low, self.learning_default, self.learning_high]
    }

    pub(in crate::price) fn check(&self, file: &str) -> Result<(), PriceError> {
        let positive = [
            ("payload_kg", self.payload_kg),
            ("load_m3", self.load_m3),
            ("load_fill", self.load_fill),
            ("lifts_per_day", self.lifts_per_day),
            ("learning_low", self.learning_low),
        ];
        let at_least_zero =
            [("distance_km", self.distance_km), ("crew", self.crew), ("hours_per_day", self.hours_per_day)];
        let bad = |key: &str, found: f64, expected: &'static str| {
            let (file, key, found) = (file.to_owned(), format!("works.{key}"), found.to_string());
            Err(PriceError::Value { file, key, found, expected })
        };
        for (key, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                return bad(key, value, "expected a number above 0");
            }
        }
        for (key, value) in at_least_zero {
            if !(value.is_finite() && value >= 0.0) {
                return bad(key, value, "expected a number of at least 0");
            }
        }
        check_range(file, "works.learning", self.learning())?;
        if self.learning_high > 1.0 {
            return bad("learning_high", self.learning_high, "expected at most 1 (no learning)");
        }
        if self.load_fill > 1.0 {
            return bad("load_fill", self.load_fill, "expected a share of at most 1");
        }
        expect_text(file, "works.source", &self.source)
    }
}

/// Pieces for which averages are kept; more of one kind are taken as so many.
const MOST_PIECES: usize = 1024;

/// Rates of what comes on top of materials: low, default, high.
#[derive(Clone, Debug, PartialEq)]
pub struct WorksRates {
    /// An hour of labour.
    pub labour: Range,
    /// Set-up of a distinct part.
    pub setup_part: Range,
    /// Set-up of a distinct connection.
    pub setup_node: Range,
    /// A kilometre by truck.
    pub truck_km: Range,
    /// A trip besides its kilometres.
    pub truck_trip: Range,
    /// A day of the crane.
    pub crane_day: Range,
    /// How houses are made, carried and put up.
    pub settings: WorksSettings,
    /// Mean time of n pieces as a share of the first one's, n from 1.
    averages: Vec<Range>,
}

impl WorksRates {
    pub(in crate::price) fn new(books: &Books) -> Result<WorksRates, PriceError> {
        let rate = |id: &str, unit: Unit| {
            let item = books.prices.item(id, "works: every house")?;
            check_unit(&books.prices.file, "works", id, item.unit, unit)?;
            Ok(item.range())
        };
        let settings = books.prices.works.clone();
        let mut sums = [0.0; 3];
        let averages = (1..=MOST_PIECES).map(|n| {
            for (sum, learning) in sums.iter_mut().zip(settings.learning()) {
                *sum += (n as f64).powf(learning.log2());
            }
            sums.map(|sum| sum / n as f64)
        });
        let averages = averages.collect();
        Ok(WorksRates {
            labour: rate("labour_hour", Unit::Hour)?,
            setup_part: rate("setup_part", Unit::Piece)?,
            setup_node: rate("setup_node", Unit::Piece)?,
            truck_km: rate("truck_km", Unit::Kilometre)?,
            truck_trip: rate("truck_trip", Unit::Piece)?,
            crane_day: rate("crane_day", Unit::Day)?,
            averages,
            settings,
        })
    }

    /// Mean time of `pieces` pieces as a share of the first one's, at the three learning rates; 1 for none.
    pub fn average(&self, pieces: usize) -> Range {
        match pieces {
            0 => [1.0; 3],
            n => self.averages[n.min(MOST_PIECES) - 1],
        }
    }
}
