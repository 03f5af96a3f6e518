//! Internal forces along members, and the extremes of a case.

use super::numbers::Numbers;
use houscaper::analysis::{Extremes, Line, Solution};

/// The six internal forces in their order.
pub const FORCES: [&str; 6] = ["N", "Vy", "Vz", "T", "My", "Mz"];

/// A value and where it stands.
#[derive(Clone, Copy)]
pub struct Place {
    /// The value.
    pub value: f64,
    /// Node or member.
    pub index: usize,
    /// Distance from end i, or the component 0 to 2.
    pub at: f64,
}

/// Extremes of every member in a case or combination.
pub fn extremes(solution: &Solution, numbers: &Numbers) -> Vec<Extremes> {
    (0..solution.member_count()).map(|m| Line::new(solution, &numbers.factors, m).extremes()).collect()
}

/// Least and largest of internal force `k` over all members; `None` without members.
pub fn range(members: &[Extremes], k: usize) -> Option<[Place; 2]> {
    let mut all = members.iter().enumerate();
    let place = |m: usize, value: f64, at: f64| Place { value, index: m, at };
    let both = |(m, e): (usize, &Extremes)| [place(m, e.least[k], e.least_at[k]), place(m, e.most[k], e.most_at[k])];
    let first = both(all.next()?);
    Some(all.map(both).fold(first, |[low, high], [l, h]| {
        [if l.value < low.value { l } else { low }, if h.value > high.value { h } else { high }]
    }))
}

/// The entry of largest magnitude in columns `from..from + 3`: row, value, column. `None` when all are zero.
pub fn largest(rows: &[[f64; 6]], from: usize) -> Option<Place> {
    let mut best: Option<Place> = None;
    for (index, row) in rows.iter().enumerate() {
        for (d, &value) in row[from..from + 3].iter().enumerate() {
            if value != 0.0 && best.is_none_or(|b| value.abs() > b.value.abs()) {
                best = Some(Place { value, index, at: d as f64 });
            }
        }
    }
    best
}
