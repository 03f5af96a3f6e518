//! Sticks longer than the stock are spliced where they are supported.

use super::grid::{Grid, STEPS, STOREY, Z, sub};
use super::sticks::Stick;
use super::types::Role;

/// Splits every stick longer than `stock_m` into the fewest pieces that fit, near equal ones, each splice at a point where it may lie:
/// level sticks over an upright, joists over a beam too, roof members where others meet them, uprights at a floor. A stick without such a point stays whole.
pub(super) fn splice(grid: &Grid, sticks: &mut Vec<Stick>, module_m: [f64; 3], stock_m: f64) {
    let mut n = 0;
    while n < sticks.len() {
        let stick = sticks[n];
        let unit = length_m(&stick, module_m);
        let longest = (stock_m / unit + 1e-9).floor() as i32;
        let cut = if stick.length > longest { best_cut(grid, &stick, longest) } else { None };
        if let Some(cut) = cut {
            sticks[n].length = cut;
            sticks.insert(n + 1, Stick { from: stick.at(cut), length: stick.length - cut, ..stick });
        }
        n += 1;
    }
}

/// Length of one step of a stick, m.
fn length_m(stick: &Stick, module_m: [f64; 3]) -> f64 {
    (0..3).map(|a| (0.5 * module_m[a] * f64::from(STEPS[stick.step][a])).powi(2)).sum::<f64>().sqrt()
}

/// The point for the first splice: within reach, nearest to an equal share.
fn best_cut(grid: &Grid, stick: &Stick, longest: i32) -> Option<i32> {
    let pieces = (stick.length + longest - 1) / longest.max(1);
    let ideal = stick.length / pieces.max(1);
    (1..=longest.min(stick.length - 1)).filter(|&n| may_splice(grid, stick, n)).min_by_key(|&n| ((n - ideal).abs(), n))
}

fn may_splice(grid: &Grid, stick: &Stick, n: i32) -> bool {
    let p = stick.at(n);
    match stick.role {
        Role::Stud | Role::CornerPost | Role::Jamb | Role::BeamPost => p[2] % STOREY == 0,
        Role::Rafter | Role::Hip | Role::Valley | Role::Ridge => {
            let meets = |s: usize| grid.role(p, s).is_some() || grid.role(sub(p, STEPS[s]), s).is_some();
            (0..STEPS.len()).any(|s| s != Z && s != stick.step && meets(s)) || grid.carried(p)
        }
        Role::Joist => grid.carried(p) || grid.level_at(p, &[Role::Beam]),
        Role::Plate | Role::Lintel | Role::Sill | Role::Trimmer | Role::Beam => grid.carried(p),
    }
}
