//! What became of the draws of each move.

use std::collections::{BTreeMap, BTreeSet};

use houscaper::export::plots::{Bar, Stack};
use houscaper::export::tables::{Cell, csv};
use houscaper::search::domain::Operator;
use houscaper::search::proposal::Tally;

use super::results::Search;

/// What may become of a draw, as the bars name it.
pub const FATES: [&str; 6] =
    ["feasible", "infeasible", "beaten without a solve", "breaks a rule", "evaluated before", "did not apply"];

/// Counts of one operator.
struct Counts {
    operator: Operator,
    inapplicable: u64,
    made: u64,
    known: u64,
    screened: u64,
    broken: u64,
    evaluated: u64,
    feasible: u64,
}

fn counts(search: &Search) -> Vec<Counts> {
    let (tally, children) = (search.tally, &search.record.children);
    let operators: BTreeSet<Operator> = tally.made.keys().chain(tally.inapplicable.keys()).copied().collect();
    let one = |operator: Operator| {
        let count = |map: &BTreeMap<Operator, u64>| map.get(&operator).copied().unwrap_or(0);
        let [evaluated, feasible] = children.get(&operator).copied().unwrap_or_default();
        Counts {
            operator,
            inapplicable: count(&tally.inapplicable),
            made: count(&tally.made),
            known: count(&tally.duplicate),
            screened: count(&tally.screened),
            broken: tally.rejected.iter().filter(|((o, _), _)| *o == operator).map(|(_, n)| n).sum(),
            evaluated,
            feasible,
        }
    };
    operators.into_iter().map(one).collect()
}

/// `moves.csv`: how many draws gave a house, how many of those kept the rules, were new, were not beaten by what needs no solve, and were feasible.
pub fn table(search: &Search) -> String {
    let header =
        ["operator", "did_not_apply", "made", "known_before", "screened", "broke_a_rule", "evaluated", "feasible"];
    let row = |c: Counts| {
        let numbers = [c.inapplicable, c.made, c.known, c.screened, c.broken, c.evaluated, c.feasible];
        std::iter::once(Cell::from(c.operator.name())).chain(numbers.map(|n| Cell::Count(n as i64))).collect()
    };
    csv(&header, counts(search).into_iter().map(row))
}

/// The fate of each operator's draws, all together first, then by the share that was feasible.
pub fn fates(search: &Search) -> Vec<Stack> {
    let fate = |c: &Counts| [c.feasible, c.evaluated - c.feasible, c.screened, c.broken, c.known, c.inapplicable];
    let mut all = [0; 6];
    let mut stacks: Vec<Stack> = Vec::new();
    for one in counts(search) {
        let counts = fate(&one);
        all.iter_mut().zip(counts).for_each(|(a, n)| *a += n);
        stacks.push(Stack { name: one.operator.name().replace('_', " "), counts: counts.to_vec() });
    }
    let share = |s: &Stack| s.counts[0] as f64 / s.counts.iter().sum::<u64>().max(1) as f64;
    stacks.sort_by(|a, b| share(b).total_cmp(&share(a)).then_with(|| a.name.cmp(&b.name)));
    stacks.insert(0, Stack { name: "all draws".into(), counts: all.to_vec() });
    stacks
}

/// Draws that gave no new house, by cause.
pub fn rejected(tally: &Tally) -> Vec<Bar> {
    let mut causes: BTreeMap<String, u64> = BTreeMap::new();
    for (operator, n) in &tally.inapplicable {
        *causes.entry(format!("{} did not apply", operator.name())).or_default() += n;
    }
    for ((_, rule), n) in &tally.rejected {
        *causes.entry(format!("rule {rule}")).or_default() += n;
    }
    let screened: u64 = tally.screened.values().sum();
    if screened > 0 {
        causes.insert("beaten without a solve".into(), screened);
    }
    let repeats: u64 = tally.duplicate.values().sum();
    if repeats > 0 {
        causes.insert("evaluated before".into(), repeats);
    }
    let mut bars: Vec<Bar> = causes.into_iter().map(|(name, n)| Bar { name, value: n as f64 }).collect();
    bars.sort_by(|a, b| b.value.total_cmp(&a.value).then(a.name.cmp(&b.name)));
    bars.truncate(24);
    bars
}
