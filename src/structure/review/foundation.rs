//! Reactions line by line: what the foundation takes under each wall.

use super::super::combine::WINDS;
use super::Solved;

/// What a line of the foundation is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineKind {
    /// A wall along x at this y, m.
    AlongX(f64),
    /// A wall along y at this x, m.
    AlongY(f64),
    /// A post at x, y, m.
    Post([f64; 2]),
}

/// A force at one support.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// Size, N; 0 where it does not occur.
    pub force_n: f64,
    /// Plan position of the support, m.
    pub at_m: [f64; 2],
}

/// Reactions of a line. A support where lines meet counts in equal shares to each, so that the sums of all lines are those of the house.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundationLine {
    /// Which.
    pub kind: LineKind,
    /// From where to where along it, m; the same twice for a post.
    pub extent_m: [f64; 2],
    /// Length of its soles, m; 0 for a post.
    pub length_m: f64,
    /// Number of supports.
    pub supports: usize,
    /// Sums of permanent load, imposed load and even snow, characteristic, upward on the house, N.
    pub vertical_n: [f64; 3],
    /// Largest sum over the ultimate combinations, upward on the house, N, and the combination from 0.
    pub design_n: (f64, usize),
    /// Largest push of the house on one support in the ultimate combinations.
    pub push: Peak,
    /// Largest pull of the house on one support under 0.9 G + 1.5 W.
    pub pull: Peak,
    /// Largest horizontal force along the line (of a post: in any direction) over the ultimate combinations, N.
    pub along_n: f64,
}

/// The lines of the soles, then what stands on none.
pub(super) fn lines(s: &Solved) -> Vec<FoundationLine> {
    let at: Vec<[f64; 3]> = s.frame.supports.iter().map(|&n| s.frame.nodes[n as usize]).collect();
    let mut kinds = soles(s);
    let on = |kind: LineKind, [from, to]: [f64; 2], p: &[f64; 3]| match kind {
        LineKind::AlongX(y) => (p[1] - y).abs() < 1e-6 && p[0] > from - 1e-6 && p[0] < to + 1e-6,
        LineKind::AlongY(x) => (p[0] - x).abs() < 1e-6 && p[1] > from - 1e-6 && p[1] < to + 1e-6,
        LineKind::Post([x, y]) => (p[0] - x).abs() < 1e-6 && (p[1] - y).abs() < 1e-6,
    };
    for p in &at {
        if !kinds.iter().any(|(kind, extent, _)| on(*kind, *extent, p)) {
            kinds.push((LineKind::Post([p[0], p[1]]), [0.0; 2], 0.0));
        }
    }
    let crossing = |p: &[f64; 3]| kinds.iter().filter(|(kind, extent, _)| on(*kind, *extent, p)).count() as f64;
    let shares: Vec<f64> = at.iter().map(|p| 1.0 / crossing(p)).collect();
    let found = Forces::new(s);
    let mut out = Vec::new();
    for (kind, extent, length) in &kinds {
        let own: Vec<usize> = (0..at.len()).filter(|&n| on(*kind, *extent, &at[n])).collect();
        if !own.is_empty() {
            out.push(found.line(*kind, *extent, *length, &own, &shares, &at));
        }
    }
    out
}

/// Lines on which soles lie, with their extent and the length of the soles: first those along x, by place.
fn soles(s: &Solved) -> Vec<(LineKind, [f64; 2], f64)> {
    let mut lines: Vec<(usize, f64, [f64; 2], f64)> = Vec::new();
    for m in s.frame.members.iter().filter(|m| m.element_count() == 0) {
        let [a, b] = m.ends;
        let axis = usize::from((b[1] - a[1]).abs() > (b[0] - a[0]).abs());
        let across = a[1 - axis];
        let (from, to) = (a[axis].min(b[axis]), a[axis].max(b[axis]));
        match lines.iter_mut().find(|l| l.0 == axis && (l.1 - across).abs() < 1e-6) {
            Some(line) => {
                line.2 = [line.2[0].min(from), line.2[1].max(to)];
                line.3 += to - from;
            }
            None => lines.push((axis, across, [from, to], to - from)),
        }
    }
    lines.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let kind = |axis: usize, across: f64| if axis == 0 { LineKind::AlongX(across) } else { LineKind::AlongY(across) };
    lines.into_iter().map(|(axis, across, extent, length)| (kind(axis, across), extent, length)).collect()
}

/// Reactions by support: characteristic actions, ultimate combinations, and static equilibrium.
struct Forces {
    vertical: [Vec<f64>; 3],
    ultimate: Vec<Vec<[f64; 3]>>,
    lifted: Vec<Vec<f64>>,
}

impl Forces {
    fn new(s: &Solved) -> Forces {
        let count = s.frame.supports.len();
        let all = |factors: &[f64]| -> Vec<[f64; 3]> { (0..count).map(|n| s.reaction(factors, n)).collect() };
        let up = |factors: &[f64]| -> Vec<f64> { all(factors).iter().map(|r| r[2]).collect() };
        let [holds, lifts] = s.loads.equ;
        Forces {
            vertical: [
                up(&s.factors(1.0, 0.0, (0, 0.0), None)),
                up(&s.factors(0.0, 1.0, (0, 0.0), None)),
                up(&s.factors(0.0, 0.0, (0, 1.0), None)),
            ],
            ultimate: s.combinations.iter().map(|c| all(&s.of(c))).collect(),
            // All winds, as in the assessment: what sucks lifts most, what presses may overturn more.
            lifted: (0..WINDS).map(|n| up(&s.factors(holds, 0.0, (0, 0.0), Some((n, lifts))))).collect(),
        }
    }

    fn line(
        &self,
        kind: LineKind,
        extent_m: [f64; 2],
        length_m: f64,
        own: &[usize],
        shares: &[f64],
        at: &[[f64; 3]],
    ) -> FoundationLine {
        let sum = |all: &dyn Fn(usize) -> f64| own.iter().map(|&n| shares[n] * all(n)).sum::<f64>();
        let mut design_n = (f64::NEG_INFINITY, 0);
        let mut along_n = 0.0f64;
        let (mut push, mut pull) = (Peak::default(), Peak::default());
        let keep = |peak: &mut Peak, force: f64, n: usize| {
            if force > peak.force_n {
                *peak = Peak { force_n: force, at_m: [at[n][0], at[n][1]] };
            }
        };
        for (c, r) in self.ultimate.iter().enumerate() {
            let total = sum(&|n| r[n][2]);
            if total > design_n.0 {
                design_n = (total, c);
            }
            let level = [0, 1].map(|a| sum(&|n| r[n][a]));
            along_n = along_n.max(match kind {
                LineKind::AlongX(_) => level[0].abs(),
                LineKind::AlongY(_) => level[1].abs(),
                LineKind::Post(_) => level[0].hypot(level[1]),
            });
            own.iter().for_each(|&n| keep(&mut push, r[n][2], n));
        }
        for up in &self.lifted {
            own.iter().for_each(|&n| keep(&mut pull, -up[n], n));
        }
        let vertical_n = [0, 1, 2].map(|k| sum(&|n| self.vertical[k][n]));
        FoundationLine { kind, extent_m, length_m, supports: own.len(), vertical_n, design_n, push, pull, along_n }
    }
}
