//! Racking: what every boarded wall, and the worst deck and roof panel, takes of its capacity.

use super::super::combine::{Duration, overall};
use super::Solved;
use crate::frame::{Panel, PanelKind};

/// A wall between two levels, or one panel of a deck or roof.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RackingReview {
    /// What it is.
    pub kind: PanelKind,
    /// Number of its first panel.
    pub panel: usize,
    /// Least and largest coordinates, m.
    pub extent_m: [[f64; 3]; 2],
    /// Force along the wall (along the brace of a deck or roof panel) in the combination that governs, N.
    pub force_n: f64,
    /// Design capacity for the duration of that combination, N.
    pub capacity_n: f64,
    /// The combination, from 0.
    pub combination: usize,
}

impl RackingReview {
    /// Force over capacity.
    pub fn ratio(&self) -> f64 {
        self.force_n / self.capacity_n
    }
}

/// All walls by panel number, then the worst deck panel and the worst roof panel.
pub(super) fn racking(s: &Solved) -> Vec<RackingReview> {
    let k = s.catalogue.k_mod.joint();
    let lowered = overall(s.frame, s.loads, &s.cases);
    // Wind acts on the house as a whole here, lowered for lack of correlation.
    let factors: Vec<Vec<f64>> = s
        .combinations
        .iter()
        .map(|c| s.factors(c.permanent, c.imposed, c.snow, c.wind.map(|(n, f)| (n, f * lowered[n]))))
        .collect();
    let axial = |panel: usize, factors: &[f64]| -> f64 {
        let member = s.frame.elements.len() + panel;
        factors.iter().enumerate().map(|(slot, f)| f * s.solution.end_forces(slot)[member][0]).sum()
    };
    let mut walls = Vec::new();
    let mut flat: [Option<RackingReview>; 2] = [None; 2];
    let mut first = 0;
    for group in s.frame.panels.chunk_by(|a, b| a.line == b.line && a.kind == PanelKind::Wall) {
        let level = |p: &Panel| if p.kind == PanelKind::Wall { run(s, p) } else { 1.0 };
        let capacity: f64 = group.iter().map(|p| p.capacity_n * level(p).abs()).sum();
        let mut row = RackingReview {
            kind: group[0].kind,
            panel: first,
            extent_m: extent(s, group),
            force_n: 0.0,
            capacity_n: capacity,
            combination: 0,
        };
        for (combination, c) in s.combinations.iter().enumerate() {
            let force: f64 = (0..group.len()).map(|n| level(&group[n]) * axial(first + n, &factors[combination])).sum();
            let capacity_n = capacity * k[c.duration as usize] / k[Duration::Short as usize];
            if force.abs() / capacity_n > row.ratio() {
                (row.force_n, row.capacity_n, row.combination) = (force.abs(), capacity_n, combination);
            }
        }
        first += group.len();
        match row.kind {
            PanelKind::Wall => walls.push(row),
            PanelKind::Deck | PanelKind::Roof => {
                let kept = &mut flat[usize::from(row.kind == PanelKind::Roof)];
                if kept.is_none_or(|k| row.ratio() > k.ratio()) {
                    *kept = Some(row);
                }
            }
        }
    }
    walls.extend(flat.into_iter().flatten());
    walls
}

fn ends(s: &Solved, p: &Panel) -> [[f64; 3]; 2] {
    p.nodes.map(|n| s.frame.nodes[n as usize])
}

fn length(s: &Solved, p: &Panel) -> f64 {
    let [a, b] = ends(s, p);
    (0..3).map(|x| (b[x] - a[x]).powi(2)).sum::<f64>().sqrt()
}

/// Level part of a wall brace over its length, signed along the wall.
fn run(s: &Solved, p: &Panel) -> f64 {
    let [a, b] = ends(s, p);
    (b[0] - a[0] + b[1] - a[1]) / length(s, p)
}

fn extent(s: &Solved, group: &[Panel]) -> [[f64; 3]; 2] {
    let points = group.iter().flat_map(|p| ends(s, p));
    points.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
        [[0, 1, 2].map(|a| low[a].min(p[a])), [0, 1, 2].map(|a| high[a].max(p[a]))]
    })
}
