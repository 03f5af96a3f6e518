//! The same house in several material systems: each sized and checked on its own, the difference line by line, the chance that one is
//! cheaper than another, and what would turn their order round.
//!
//! A comparison changes the frame only: cladding, insulation, openings, floors and loads stay, and so do the rules of sizing. What the
//! frame brings along is stated: boards on the second side of the walls, and the clear height that deep joists leave.

use std::collections::BTreeMap;

use serde::Serialize;

use super::{Evaluation, Evaluator, SizingGoal};
use crate::brief::Objective;
use crate::price::{
    BillLine, CarbonMatrix, CarbonSums, Draws, PriceError, PriceMatrix, Range, StageTable, bill, chance_below, tenths,
};
use crate::quantities::{FrameMaterial, Item};
use crate::structure::Verdict;
use crate::voxels::{Choices, House};

/// A house in one system.
#[derive(Clone, Debug)]
pub struct Variant {
    /// Name of the system: its materials.
    pub system: String,
    /// Sections, joists and boards, sized for this system.
    pub choices: Choices,
    /// Its evaluation.
    pub evaluation: Evaluation,
    /// Its bill.
    pub lines: Vec<BillLine>,
    /// How much of each item of the price book it takes.
    pub quantities: Vec<f64>,
    /// Its price in each of the shared draws.
    pub prices: Vec<f64>,
    /// How much of each item of the factor list it takes.
    pub materials: Vec<f64>,
    /// Its carbon beside A1-A3.
    pub stages: CarbonSums,
    /// Least clear height, m.
    pub clear_height_m: f64,
}

impl Variant {
    /// Whether every check holds.
    pub fn is_ok(&self) -> bool {
        self.evaluation.assessment.as_ref().is_some_and(|a| a.verdict == Verdict::Ok)
    }

    /// Price in place, net of VAT: low, default, high.
    pub fn price(&self) -> Range {
        self.evaluation.cost.map_or([f64::NAN; 3], |c| c.price_eur)
    }

    /// Fossil carbon A1-A3, kgCO2e: low, default, high.
    pub fn carbon(&self) -> Range {
        self.evaluation.cost.map_or([f64::NAN; 3], |c| c.gwp_fossil)
    }

    /// An objective; NaN where it is not known.
    pub fn value(&self, objective: Objective) -> f64 {
        self.evaluation.values.get(objective)
    }

    /// Price that 10 %, 50 % and 90 % of the draws stay below.
    pub fn price_tenths(&self) -> Range {
        tenths(&self.prices)
    }
}

/// A rate at which two systems would cost, or emit, the same.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Tie {
    /// The system that is less now.
    pub less: String,
    /// The system that is more now.
    pub more: String,
    /// `price` or `carbon`.
    pub of: &'static str,
    /// The item of the price book, or the frame material.
    pub item: String,
    /// Unit of the rate.
    pub unit: String,
    /// The rate now.
    pub rate: f64,
    /// The rate at which both are the same, everything else as it is.
    pub tie: f64,
    /// Low and high of the rate.
    pub range: [f64; 2],
}

impl Tie {
    /// Whether the range of the rate reaches the tie.
    pub fn is_within_range(&self) -> bool {
        self.range[0] <= self.tie && self.tie <= self.range[1]
    }
}

/// A row of the difference: an item, or a group of the frame, with its amount in each variant.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LineRow {
    /// Section of the bill.
    pub group: String,
    /// Item, or the members of a group.
    pub item: String,
    /// Amount in each variant, net of overhead and VAT.
    pub amount: Vec<f64>,
    /// Fossil kgCO2e in each variant.
    pub gwp_kgco2e: Vec<f64>,
    /// kg in each variant.
    pub mass_kg: Vec<f64>,
}

/// A house in several systems.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The variants, in the order asked for.
    pub variants: Vec<Variant>,
}

impl Comparison {
    /// Sizes, checks and prices a house with each evaluator; all of them share their books. `None` stands for a system in which nothing
    /// stands on the foundation, or none of whose sections can be assessed.
    ///
    /// # Errors
    /// An item without price, as in [`bill`].
    pub fn new(
        house: &House,
        systems: &[(String, Evaluator)],
        goal: SizingGoal,
        draws: &Draws,
    ) -> Result<(Comparison, Vec<String>), PriceError> {
        let (mut variants, mut left_out) = (Vec::new(), Vec::new());
        for (name, evaluator) in systems {
            let Some(sized) = evaluator.size(house, goal) else {
                left_out.push(name.clone());
                continue;
            };
            let choices = sized.choices();
            let details = evaluator.details(house, &choices);
            let Some(takeoff) = details.evaluation.takeoff else {
                left_out.push(name.clone());
                continue;
            };
            let section = |number: u16| evaluator.catalogue.section_id(number);
            let quantities = PriceMatrix::new(&evaluator.books)?.quantities(&takeoff);
            let (carbon, stages) = (CarbonMatrix::new(&evaluator.books)?, StageTable::new(&evaluator.books)?);
            variants.push(Variant {
                system: name.clone(),
                choices,
                lines: bill(&takeoff, &evaluator.books, &section)?,
                prices: draws.prices(&quantities),
                quantities,
                materials: carbon.quantities(&takeoff),
                stages: stages.of(&takeoff),
                clear_height_m: evaluator.clear_height_m(&details.reading, &evaluator.sections(&choices)),
                evaluation: details.evaluation,
            });
        }
        Ok((Comparison { variants }, left_out))
    }

    /// The chance that variant `a` costs less than variant `b`.
    pub fn chance(&self, a: usize, b: usize) -> f64 {
        chance_below(&self.variants[a].prices, &self.variants[b].prices)
    }

    /// Variants that are ok, each with the next dearer one at default rates.
    pub fn neighbours(&self) -> Vec<(usize, usize)> {
        let mut ok: Vec<usize> = (0..self.variants.len()).filter(|&n| self.variants[n].is_ok()).collect();
        ok.sort_by(|&a, &b| self.variants[a].price()[1].total_cmp(&self.variants[b].price()[1]).then(a.cmp(&b)));
        ok.windows(2).map(|pair| (pair[0], pair[1])).collect()
    }

    /// The share of draws in which each variant is the cheapest of those that are ok; 0 for those that are not.
    pub fn chance_cheapest(&self) -> Vec<f64> {
        let ok: Vec<usize> = (0..self.variants.len()).filter(|&n| self.variants[n].is_ok()).collect();
        let mut wins = vec![0.0; self.variants.len()];
        let draws = self.variants.first().map_or(0, |v| v.prices.len());
        for d in 0..draws {
            let cheapest = ok
                .iter()
                .copied()
                .min_by(|&a, &b| self.variants[a].prices[d].total_cmp(&self.variants[b].prices[d]).then(a.cmp(&b)));
            cheapest.into_iter().for_each(|n| wins[n] += 1.0 / draws as f64);
        }
        wins
    }

    /// Items and groups of the frame with their amounts; rows that are equal in all variants included.
    pub fn rows(&self) -> Vec<LineRow> {
        let count = self.variants.len();
        let mut rows: Vec<LineRow> = Vec::new();
        for (n, variant) in self.variants.iter().enumerate() {
            for line in &variant.lines {
                let of_frame = Item::from_id(&line.item).is_some_and(Item::is_frame);
                // Members are told apart by what they are for; openings by their size; the rest by item, walls of any boards as one.
                let item = match line.item.as_str() {
                    _ if of_frame => line.description.split(',').next().unwrap_or_default().to_owned(),
                    "wall_both_sides" => "wall".to_owned(),
                    "window" => line.description.split(':').next().unwrap_or_default().to_owned(),
                    item => item.to_owned(),
                };
                let known = rows.iter().position(|r| r.group == line.group && r.item == item);
                let at = known.unwrap_or_else(|| {
                    let none = vec![0.0; count];
                    let (amount, gwp_kgco2e, mass_kg) = (none.clone(), none.clone(), none);
                    rows.push(LineRow { group: line.group.clone(), item, amount, gwp_kgco2e, mass_kg });
                    rows.len() - 1
                });
                rows[at].amount[n] += line.amount;
                rows[at].gwp_kgco2e[n] += line.gwp_kgco2e;
                rows[at].mass_kg[n] += line.mass_kg;
            }
        }
        rows
    }

    /// What would turn the order of two variants round: for each rate that counts more in one than in the other, the value at which both
    /// are the same. Nearest to its present value first.
    pub fn ties(&self, a: usize, b: usize, evaluator: &Evaluator) -> Vec<Tie> {
        let mut ties = self.price_ties(a, b, evaluator);
        ties.extend(self.carbon_ties(a, b, evaluator));
        ties
    }

    fn price_ties(&self, a: usize, b: usize, evaluator: &Evaluator) -> Vec<Tie> {
        let (less, more) = order([&self.variants[a], &self.variants[b]], |v| v.price()[1]);
        let gap = (more.price()[1] - less.price()[1]) / evaluator.rates.in_place[1];
        let rates = evaluator.books.prices.items().iter().zip(less.quantities.iter().zip(&more.quantities));
        let mut ties: Vec<Tie> = rates
            .filter_map(|(item, (q, r))| {
                // Hours stay as they are: a rate in place cannot fall below its own labour.
                let [low, rate, high] = item.in_place();
                let labour = rate - item.range()[1];
                let tie = tie(item.range()[1], gap, r - q)? + labour;
                let (item, unit) = (item.id.clone(), format!("{}/{}", evaluator.books.prices.currency, item.unit));
                Some(Tie {
                    less: less.system.clone(),
                    more: more.system.clone(),
                    of: "price",
                    item,
                    unit,
                    rate,
                    tie,
                    range: [low, high],
                })
            })
            .collect();
        nearest_first(&mut ties);
        ties
    }

    fn carbon_ties(&self, a: usize, b: usize, evaluator: &Evaluator) -> Vec<Tie> {
        let (less, more) = order([&self.variants[a], &self.variants[b]], |v| v.carbon()[1]);
        let gap = more.carbon()[1] - less.carbon()[1];
        let kg = |v: &Variant, item: Item| v.evaluation.takeoff.map_or(0.0, |t| t.measured()[item as usize]);
        let mut ties: Vec<Tie> = FrameMaterial::ALL
            .into_iter()
            .filter_map(|material| {
                let item = material.item();
                let [low, rate, high] = evaluator.rates.rows[item as usize].gwp;
                let tie = tie(rate, gap, kg(more, item) - kg(less, item))?;
                let (less, more) = (less.system.clone(), more.system.clone());
                let (item, unit) = (material.id().to_owned(), "kgCO2e/kg".to_owned());
                Some(Tie { less, more, of: "carbon", item, unit, rate, tie, range: [low, high] })
            })
            .collect();
        nearest_first(&mut ties);
        ties
    }

    /// What decides the price between two variants, in a sentence with its numbers.
    pub fn sentence(&self, a: usize, b: usize) -> String {
        let (less, more) = order([&self.variants[a], &self.variants[b]], |v| v.price()[1]);
        let (mine, theirs) = (by_group(less), by_group(more));
        let difference = |group: &str| theirs.get(group).unwrap_or(&0.0) - mine.get(group).unwrap_or(&0.0);
        let mut parts: Vec<(&str, f64)> = theirs.keys().chain(mine.keys()).map(|g| (*g, difference(g))).collect();
        parts.sort_by(|x, y| y.1.abs().total_cmp(&x.1.abs()).then(x.0.cmp(y.0)));
        parts.dedup_by(|x, y| x.0 == y.0);
        let told: Vec<String> =
            parts.iter().filter(|p| p.1.abs() >= 0.5).map(|(group, sum)| format!("{group} {sum:+.0}")).collect();
        let (less_n, more_n) = if std::ptr::eq(less, &self.variants[a]) { (a, b) } else { (b, a) };
        format!(
            "{} costs {:.0} less than {} at default rates (lines, net: {}); {} is cheaper in {:.0} % of the draws",
            less.system,
            more.price()[1] - less.price()[1],
            more.system,
            if told.is_empty() { "no line differs".to_owned() } else { told.join(", ") },
            less.system,
            100.0 * self.chance(less_n, more_n)
        )
    }
}

/// Net amounts by section of the bill.
fn by_group(variant: &Variant) -> BTreeMap<&str, f64> {
    let mut sums = BTreeMap::new();
    variant.lines.iter().for_each(|l| *sums.entry(l.group.as_str()).or_default() += l.amount);
    sums
}

/// The smaller and the larger of two by a value.
fn order([a, b]: [&Variant; 2], value: impl Fn(&Variant) -> f64) -> (&Variant, &Variant) {
    if value(b) < value(a) { (b, a) } else { (a, b) }
}

/// The rate at which a gap closes whose larger side takes `more` units more of it; `None` where no rate at or above zero does.
fn tie(rate: f64, gap: f64, more: f64) -> Option<f64> {
    if more.abs() < 1e-9 || gap.is_nan() {
        return None;
    }
    let tie = rate - gap / more;
    (tie >= 0.0).then_some(tie)
}

fn nearest_first(ties: &mut [Tie]) {
    let far = |t: &Tie| (t.tie / t.rate - 1.0).abs();
    ties.sort_by(|a, b| far(a).total_cmp(&far(b)).then(a.item.cmp(&b.item)));
}
