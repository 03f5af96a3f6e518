//! Uncertainty of prices: what the low and high of every rate mean for a house, and for the choice between two.
//!
//! A rate is drawn from the triangle between its low and high with its peak at the default; where low or high is the default, half a
//! triangle is left. Every item of the book has one draw, shared by all houses that are compared: a dear year for glulam is dear for each
//! of them. Overhead, profit and contingency are drawn the same way. What houses have in common so cancels, as it should.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::works::{WorksLine, WorksQuantities};
use super::{Books, PriceError, Range, RateTable};
use crate::quantities::{FrameMaterial, Item, Takeoff};

/// Draws of a comparison: the chance between two houses is then known to 0.016 (two standard errors at a chance of one half).
pub const DRAWS: usize = 4096;

/// For each item of the take-off, the items of the price book in one billed unit; and the items that works are paid by.
#[derive(Clone, Debug, PartialEq)]
pub struct PriceMatrix {
    rows: Vec<Vec<(usize, f64)>>,
    works: [usize; WorksLine::ALL.len()],
    /// Items of the price book.
    items: usize,
    rates: RateTable,
}

impl PriceMatrix {
    /// Reads the books once.
    ///
    /// # Errors
    /// An item without build-up or price, as in [`Books::rates`].
    pub fn new(books: &Books) -> Result<PriceMatrix, PriceError> {
        let book = books.prices.items();
        let place = |id: &str, key: &str| -> Result<usize, PriceError> {
            books.prices.item(id, key)?;
            Ok(book.iter().position(|item| item.id == id).unwrap_or(0))
        };
        let mut rows = vec![Vec::new(); Item::COUNT];
        for item in Item::ALL {
            let row: &mut Vec<(usize, f64)> = &mut rows[item as usize];
            if let Some(material) = FrameMaterial::ALL.into_iter().find(|m| m.item() == item) {
                let using = books.buildups.of_frame(material)?;
                row.push((place(&using.price, &format!("frame.{}", material.id()))?, 1.0));
                continue;
            }
            let buildup = books.buildups.of_item(item.id())?;
            let parts = buildup.layers.iter().flat_map(|l| &l.parts).filter(|p| p.elsewhere.is_none());
            for price in parts.flat_map(|p| &p.price) {
                let at = place(&price.item, &format!("buildup {}", buildup.id))?;
                match row.iter_mut().find(|(known, _)| *known == at) {
                    Some((_, sum)) => *sum += price.per_unit,
                    None => row.push((at, price.per_unit)),
                }
            }
        }
        let mut works = [0; WorksLine::ALL.len()];
        for line in WorksLine::ALL {
            works[line as usize] = place(line.price_item(), "works: every house")?;
        }
        Ok(PriceMatrix { rows, works, items: book.len(), rates: books.rates()? })
    }

    /// How much of each item of the price book a house takes, in the order of the book and in its units, so that quantities times
    /// [`PriceItem::range`](super::PriceItem::range) are the net price at default rates. Hours and set-ups are what the default learning
    /// rate leaves of them: that rate is not drawn, for it is one for all houses and moves them together.
    pub fn quantities(&self, takeoff: &Takeoff) -> Vec<f64> {
        let (measured, billed) = (takeoff.measured(), takeoff.billed(self.rates.window_min_m2));
        let mut sums = vec![0.0; self.items];
        for (row, billed) in self.rows.iter().zip(billed) {
            row.iter().for_each(|&(at, per_unit)| sums[at] += billed * per_unit);
        }
        let works = WorksQuantities::new(takeoff, &measured, &billed, &self.rates);
        for (at, quantity) in self.works.into_iter().zip(works.units()) {
            sums[at] += quantity;
        }
        sums
    }
}

/// Rates drawn once for all houses of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Draws {
    /// Rates, a row a draw.
    rates: Vec<f64>,
    /// Factor from net rates to prices in place, a draw each.
    in_place: Vec<f64>,
    items: usize,
}

impl Draws {
    /// `count` draws from a seed: the same for the same book, whatever is compared.
    ///
    /// # Errors
    /// A price book without overhead or contingency.
    pub fn new(books: &Books, count: usize, seed: u64) -> Result<Draws, PriceError> {
        let items = books.prices.items();
        let surcharges =
            [books.prices.surcharge("overhead_profit")?.range(), books.prices.surcharge("contingency")?.range()];
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut out =
            Draws { rates: Vec::with_capacity(count * items.len()), in_place: Vec::new(), items: items.len() };
        for _ in 0..count {
            out.rates.extend(items.iter().map(|item| triangular(item.range(), rng.random())));
            out.in_place.push(surcharges.iter().map(|&range| 1.0 + triangular(range, rng.random())).product());
        }
        Ok(out)
    }

    /// The price in place of a house in each draw, net of VAT.
    pub fn prices(&self, quantities: &[f64]) -> Vec<f64> {
        let rows = self.rates.chunks_exact(self.items.max(1)).zip(&self.in_place);
        rows.map(|(rates, factor)| factor * rates.iter().zip(quantities).map(|(r, q)| r * q).sum::<f64>()).collect()
    }
}

/// The value below which a share `u` of the triangle [low, peak, high] lies.
fn triangular([low, peak, high]: Range, u: f64) -> f64 {
    let width = high - low;
    if width <= 0.0 {
        return peak;
    }
    if u < (peak - low) / width {
        low + (u * width * (peak - low)).sqrt()
    } else {
        high - ((1.0 - u) * width * (high - peak)).sqrt()
    }
}

/// The share of draws in which the first house costs less than the second; ties count half.
pub fn chance_below(first: &[f64], second: &[f64]) -> f64 {
    let wins = first.iter().zip(second).map(|(a, b)| match a.total_cmp(b) {
        std::cmp::Ordering::Less => 1.0,
        std::cmp::Ordering::Equal => 0.5,
        std::cmp::Ordering::Greater => 0.0,
    });
    wins.sum::<f64>() / first.len().max(1) as f64
}

/// The values that 10 %, 50 % and 90 % of the draws stay below.
pub fn tenths(prices: &[f64]) -> Range {
    let mut sorted = prices.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let at = |share: f64| sorted.get((share * sorted.len() as f64) as usize).copied().unwrap_or(f64::NAN);
    [at(0.1), at(0.5), at(0.9)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The inverse of the triangle's distribution function: (x - a)^2 / (w (c - a)) up to the peak, 1 - (b - x)^2 / (w (b - c)) beyond.
    #[test]
    fn draws_follow_the_triangle() {
        let cdf = |[a, c, b]: Range, x: f64| match x < c {
            true => (x - a).powi(2) / ((b - a) * (c - a)),
            false => 1.0 - (b - x).powi(2) / ((b - a) * (b - c)),
        };
        for range in [[12.0, 18.0, 25.0], [0.0, 1.0, 10.0]] {
            for n in 1..20 {
                let u = f64::from(n) / 20.0;
                assert!((cdf(range, triangular(range, u)) - u).abs() < 1e-12);
            }
        }
        // Half triangles, and no width at all.
        assert!((triangular([2.0, 2.0, 6.0], 0.75) - 4.0).abs() < 1e-12);
        assert!((triangular([2.0, 6.0, 6.0], 0.25) - 4.0).abs() < 1e-12);
        assert_eq!(triangular([5.0; 3], 0.3), 5.0);
    }

    #[test]
    fn chances_of_two_houses_add_up_to_one() {
        let (a, b) = ([1.0, 2.0, 3.0, 4.0], [2.0, 2.0, 2.0, 2.0]);
        assert_eq!(chance_below(&a, &b), 0.375);
        assert_eq!(chance_below(&a, &b) + chance_below(&b, &a), 1.0);
        assert_eq!(tenths(&[5.0, 1.0, 2.0, 3.0, 4.0, 6.0, 7.0, 8.0, 9.0, 10.0]), [2.0, 6.0, 10.0]);
    }
}
