//! Prices of the front in shared draws of all rates, and the chance that one house is cheaper than another.

use houscaper::brief::Objective;
use houscaper::export::plots;
use houscaper::export::tables::uncertainty_csv;
use houscaper::price::{DRAWS, Draws, PriceMatrix, chance_below, tenths};
use houscaper::run::RunFolder;
use rayon::prelude::*;

use super::Job;
use super::results::{FrontHouse, Written};
use crate::cli::failure::{Blame, Failure};

/// Houses in the matrix of chances at most, but for those with names.
const COMPARED: usize = 10;

/// Houses of the front against each other, in the order asked for.
pub struct Chances {
    /// Price that 10 %, 50 % and 90 % of the draws stay below.
    pub tenths: Vec<[f64; 3]>,
    /// Share of the draws in which each is the cheapest of them.
    pub cheapest: Vec<f64>,
    /// Share in which each (row) costs less than each other (column).
    pub below: Vec<Vec<f64>>,
}

impl Chances {
    /// Of houses of the front.
    pub fn new(houses: &[usize], prices: &[Option<Vec<f64>>]) -> Option<Chances> {
        let own: Vec<&[f64]> = houses.iter().map(|&h| prices.get(h)?.as_deref()).collect::<Option<_>>()?;
        let draws = own.first()?.len();
        let mut cheapest = vec![0.0; own.len()];
        for d in 0..draws {
            let least = (0..own.len()).min_by(|&a, &b| own[a][d].total_cmp(&own[b][d]).then(a.cmp(&b)));
            least.into_iter().for_each(|n| cheapest[n] += 1.0 / draws as f64);
        }
        let row = |a: &&[f64]| own.iter().map(|b| chance_below(a, b)).collect();
        let below = own.iter().map(row).collect();
        Some(Chances { tenths: own.iter().map(|p| tenths(p)).collect(), cheapest, below })
    }
}

/// Prices of the front in shared draws of all rates; the same seed for every run, so that runs can be compared.
pub fn draw_prices(job: &Job, front: &[FrontHouse]) -> Result<Vec<Option<Vec<f64>>>, Failure> {
    let books = &job.evaluator.books;
    let (matrix, draws) = (PriceMatrix::new(books).input()?, Draws::new(books, DRAWS, 1).input()?);
    let price = |h: &FrontHouse| Some(draws.prices(&matrix.quantities(h.evaluation.takeoff.as_ref()?)));
    Ok(front.par_iter().map(price).collect())
}

/// Text of `uncertainty.csv`.
pub fn uncertainty(front: &[FrontHouse], prices: &[Option<Vec<f64>>]) -> String {
    let (ids, prices): (Vec<u64>, Vec<Vec<f64>>) =
        front.iter().zip(prices).filter_map(|(h, p)| Some((h.id, p.clone()?))).unzip();
    uncertainty_csv(&ids, &prices)
}

/// Two houses of the front next to each other by default price, and the share of the draws in which the first costs less.
pub struct Neighbours {
    /// The cheaper at default rates, by its place in the front.
    pub first: usize,
    /// The next one.
    pub second: usize,
    /// Chance that the first is the cheaper.
    pub chance: f64,
}

/// The front by default price, each with the next dearer one.
pub fn price_order(front: &[FrontHouse], prices: &[Option<Vec<f64>>]) -> Vec<Neighbours> {
    let price = |h: usize| front[h].evaluation.values.get(Objective::PriceEur);
    let mut order: Vec<usize> = (0..front.len()).filter(|&h| prices[h].is_some()).collect();
    order.sort_by(|&a, &b| price(a).total_cmp(&price(b)).then(a.cmp(&b)));
    let pair = |p: &[usize]| {
        let chance = chance_below(prices[p[0]].as_deref()?, prices[p[1]].as_deref()?);
        Some(Neighbours { first: p[0], second: p[1], chance })
    };
    order.windows(2).filter_map(pair).collect()
}

/// Which of some houses is the cheaper, as a matrix: the named ones and the neighbours by price whose order is least sure, cheapest first.
pub fn write_chances(
    job: &Job,
    written: &Written,
    prices: &[Option<Vec<f64>>],
    folder: &RunFolder,
) -> Result<(), Failure> {
    let Written { front, named, order, .. } = written;
    let mut shown: Vec<usize> = named.iter().map(|n| n.index).filter(|&h| prices[h].is_some()).collect();
    let mut least_sure: Vec<&Neighbours> = order.iter().collect();
    least_sure.sort_by(|a, b| a.chance.total_cmp(&b.chance));
    for house in least_sure.iter().flat_map(|pair| [pair.first, pair.second]) {
        if shown.len() < COMPARED && !shown.contains(&house) {
            shown.push(house);
        }
    }
    let price = |h: usize| front[h].evaluation.values.get(Objective::PriceEur);
    shown.sort_by(|&a, &b| price(a).total_cmp(&price(b)).then(a.cmp(&b)));
    let Some(chances) = Chances::new(&shown, prices).filter(|_| shown.len() > 1) else { return Ok(()) };
    let name = |h: &usize| match named.iter().find(|n| n.index == *h) {
        Some(n) => format!("{}, {}", front[*h].id, n.name),
        None => front[*h].id.to_string(),
    };
    let names: Vec<String> = shown.iter().map(name).collect();
    let title =
        format!("{}: {} of {} houses of the front, by price", job.evaluator.brief.name, names.len(), front.len());
    let svg = plots::chances(&title, &names, &chances.below, &chances.cheapest).run()?;
    folder.write("plots/cheaper.svg", svg.as_bytes()).run()?;
    folder.write("plots/cheaper.png", &plots::svg_to_png(&svg, 1.5).run()?).run()
}
