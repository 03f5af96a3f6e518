//! Whether the order of materials by fossil carbon survives another account: other factors, further stages, stored carbon counted.

use serde::Serialize;

use super::compare::{Comparison, Variant};
use crate::price::{CarbonBook, Range, Stage};
use crate::quantities::Unit;

/// A way to account for carbon. None is a figure of its own: they only order systems.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Account {
    /// Fossil A1-A3 at default factors: the order that is put to the test.
    Fossil,
    /// At low factors.
    FossilLow,
    /// At high factors.
    FossilHigh,
    /// With A4, A5 and C3-C4 as far as known.
    Stages,
    /// The same at low factors.
    StagesLow,
    /// The same at high factors.
    StagesHigh,
    /// Fossil A1-A3 with biogenic storage counted as if it stayed.
    Storage,
}

impl Account {
    /// All, the tested order first.
    pub const ALL: [Account; 7] = [
        Account::Fossil,
        Account::FossilLow,
        Account::FossilHigh,
        Account::Stages,
        Account::StagesLow,
        Account::StagesHigh,
        Account::Storage,
    ];

    /// In words, after "the order stays" or "turns".
    pub fn words(self) -> &'static str {
        match self {
            Account::Fossil => "by fossil carbon A1-A3",
            Account::FossilLow => "at low factors",
            Account::FossilHigh => "at high factors",
            Account::Stages => "with A4, A5 and C3-C4 as far as known",
            Account::StagesLow => "with those at low factors",
            Account::StagesHigh => "with those at high factors",
            Account::Storage => "with biogenic storage counted",
        }
    }
}

/// A material without a factor, of which one system takes more.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UnknownAmount {
    /// The stage.
    pub stage: Stage,
    /// The material.
    pub material: String,
    /// How much more of it the system takes that emits more; below 0 where it is less.
    pub more: f64,
    /// Unit of the amount.
    pub unit: Unit,
}

/// The order of two systems, and what becomes of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Survival {
    /// The system with less fossil carbon A1-A3.
    pub less: String,
    /// The system with more.
    pub more: String,
    /// Fossil kgCO2e A1-A3 of the two, at default factors.
    pub a1_a3: [f64; 2],
    /// Accounts in which the order is the same.
    pub kept: Vec<Account>,
    /// Accounts in which it is not.
    pub turned: Vec<Account>,
    /// Least and most of the difference A1-A3 with A4, A5 and C3-C4 as known, with every factor anywhere in its range and the same for both.
    pub difference: [f64; 2],
    /// What has no factor and differs between the two; what both hold alike cancels.
    pub unknown: Vec<UnknownAmount>,
}

impl Survival {
    /// Whether the order is the same in every account.
    pub fn is_kept(&self) -> bool {
        self.turned.is_empty()
    }

    /// Everything in a few sentences.
    pub fn sentence(&self) -> String {
        let t = |kg: f64| kg / 1e3;
        let list = |accounts: &[Account]| accounts.iter().map(|a| a.words()).collect::<Vec<_>>().join(", ");
        let stays = match (self.kept.is_empty(), self.turned.is_empty()) {
            (_, true) => format!("The order stays {}", list(&self.kept)),
            (true, false) => format!("The order turns {}", list(&self.turned)),
            (false, false) => format!("The order stays {}; it turns {}", list(&self.kept), list(&self.turned)),
        };
        let more_wood = match self.turned.contains(&Account::Storage) {
            true => format!(" (storage favours {}, which takes more wood)", self.more),
            false => String::new(),
        };
        let [least, most] = self.difference.map(t);
        let sure = if least > 0.0 { "so that it cannot turn" } else { "so that it can turn" };
        let unknown = match self.unknown.as_slice() {
            [] => "nothing in which the two differ is unknown".to_owned(),
            some => {
                let one = |u: &UnknownAmount| {
                    let material = u.material.replace('_', " ");
                    format!("{} of {material} ({:+.1} {} in {})", u.stage.title(), u.more, u.unit, self.more)
                };
                format!("unknown where the two differ: {}", some.iter().map(one).collect::<Vec<_>>().join(", "))
            }
        };
        format!(
            "By fossil carbon A1-A3, {} ({:.1} t) is below {} ({:.1} t). {stays}{more_wood}. With every factor anywhere in its range, the same for both, the difference up to C3-C4 is {least:.1} to {most:.1} t, {sure}; {unknown}. D is in none of this",
            self.less,
            t(self.a1_a3[0]),
            self.more,
            t(self.a1_a3[1]),
        )
    }
}

impl Variant {
    /// What an account orders by, kgCO2e; fossil and biogenic meet here to be ordered, and are shown nowhere.
    fn account(&self, account: Account) -> f64 {
        let a1_a3 = self.carbon();
        let stages = |k: usize| a1_a3[k] + Stage::INSIDE.map(|s| self.stages.stage(s).known[k]).iter().sum::<f64>();
        match account {
            Account::Fossil => a1_a3[1],
            Account::FossilLow => a1_a3[0],
            Account::FossilHigh => a1_a3[2],
            Account::Stages => stages(1),
            Account::StagesLow => stages(0),
            Account::StagesHigh => stages(2),
            Account::Storage => a1_a3[1] + self.stages.storage,
        }
    }
}

impl Comparison {
    /// Variants that are ok by an account, least first.
    fn ordered(&self, account: Account) -> Vec<usize> {
        let mut ok: Vec<usize> = (0..self.variants.len()).filter(|&n| self.variants[n].is_ok()).collect();
        let value = |n: usize| self.variants[n].account(account);
        ok.sort_by(|&a, &b| value(a).total_cmp(&value(b)).then(a.cmp(&b)));
        ok
    }

    /// The place of each variant in an account, 1 for the least; none for those that are not ok.
    pub fn ranks(&self, account: Account) -> Vec<Option<usize>> {
        let ordered = self.ordered(account);
        (0..self.variants.len()).map(|n| ordered.iter().position(|&o| o == n).map(|place| place + 1)).collect()
    }

    /// Whether all that are ok stand in the same order in every account; none where fewer than two are ok.
    pub fn order_is_kept(&self) -> Option<bool> {
        let first = self.ordered(Account::Fossil);
        (first.len() > 1).then(|| Account::ALL.iter().all(|a| self.ordered(*a) == first))
    }

    /// Of each variant that is ok and the next one by fossil carbon A1-A3: what becomes of their order.
    pub fn survivals(&self, book: &CarbonBook) -> Vec<Survival> {
        let ordered = self.ordered(Account::Fossil);
        ordered.windows(2).map(|pair| self.survival(pair[0], pair[1], book)).collect()
    }

    fn survival(&self, less: usize, more: usize, book: &CarbonBook) -> Survival {
        let (a, b) = (&self.variants[less], &self.variants[more]);
        let (kept, turned) = Account::ALL[1..].iter().partition(|x| a.account(**x) < b.account(**x));
        let mut difference = [0.0; 2];
        let mut unknown = Vec::new();
        for (at, material) in book.items().iter().enumerate() {
            let more = b.materials[at] - a.materials[at];
            if more.abs() < 1e-6 {
                continue;
            }
            let mut factor: Range = material.range();
            for stage in Stage::INSIDE {
                match material.stage(stage) {
                    Some(known) => factor.iter_mut().zip(known.range()).for_each(|(sum, f)| *sum += f),
                    None => {
                        unknown.push(UnknownAmount { stage, material: material.id.clone(), more, unit: material.unit })
                    }
                }
            }
            let [low, _, high] = factor.map(|f| f * more);
            difference = [difference[0] + low.min(high), difference[1] + low.max(high)];
        }
        let (less, more) = (a.system.clone(), b.system.clone());
        Survival { less, more, a1_a3: [a.carbon()[1], b.carbon()[1]], kept, turned, difference, unknown }
    }
}
