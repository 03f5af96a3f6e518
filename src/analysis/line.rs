//! Internal forces and deflection along a member, also of linear combinations of cases.
//!
//! Internal forces are the stress resultants on the cut whose outward normal is +x: N > 0 is tension, and at end j they equal
//! the end forces. `dVy/dx = -qy`, `dMz/dx = -Vy`, `dMy/dx = Vz`; `Mz = E Iz v''`, `My = -E Iy w''`.

use super::fixed_end::SpanLoad;
use super::solution::{Placed, Solution, Span};

/// A member under a linear combination of load cases. Borrowed, no allocation.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    span: &'a Span,
    /// End forces on the member at i.
    start: [f64; 6],
    /// Uniform load, local.
    q: [f64; 3],
    placed: &'a [Placed],
    factors: &'a [f64],
}

/// Least and largest value of each internal force N Vy Vz T My Mz along a member, and where they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Least.
    pub least: [f64; 6],
    /// Distances of the least values from end i; the first place when several share the value.
    pub least_at: [f64; 6],
    /// Largest.
    pub most: [f64; 6],
    /// Distances of the largest values from end i.
    pub most_at: [f64; 6],
}

/// Internal forces N Vy Vz T My Mz of `member` in `case` at `x` from end i.
pub fn member_forces(solution: &Solution, case: usize, member: usize, x: f64) -> [f64; 6] {
    let mut factors = [0.0; 32];
    if case < factors.len() {
        factors[case] = 1.0;
        Line::new(solution, &factors[..=case], member).forces(x)
    } else {
        let factors: Vec<f64> = (0..=case).map(|c| if c == case { 1.0 } else { 0.0 }).collect();
        Line::new(solution, &factors, member).forces(x)
    }
}

/// `n`-fold running integral (n = 0: the load itself) of a load over [0, x], component `c`: Macaulay brackets.
fn integral(load: &SpanLoad, c: usize, x: f64, n: i32) -> f64 {
    const FACTORIAL: [f64; 6] = [1.0, 1.0, 2.0, 6.0, 24.0, 120.0];
    let term = |a: f64, k: i32| if x > a { (x - a).powi(k) / FACTORIAL[k as usize] } else { 0.0 };
    match *load {
        SpanLoad::Point { .. } if n == 0 => 0.0,
        SpanLoad::Point { p, x } => p[c] * term(x, n - 1),
        SpanLoad::Linear { q1, q2, x1, x2 } if x2 > x1 => {
            let slope = (q2[c] - q1[c]) / (x2 - x1);
            q1[c] * term(x1, n) + slope * term(x1, n + 1) - q2[c] * term(x2, n) - slope * term(x2, n + 1)
        }
        SpanLoad::Linear { .. } => 0.0,
    }
}

impl<'a> Line<'a> {
    /// `member` under the sum of `factors[case]` times each case; missing factors are zero.
    pub fn new(solution: &'a Solution, factors: &'a [f64], member: usize) -> Self {
        let (mut start, mut q) = ([0.0; 6], [0.0; 3]);
        for (case, &f) in factors.iter().take(solution.cases).enumerate().filter(|(_, f)| **f != 0.0) {
            let at = case * solution.members + member;
            (0..6).for_each(|k| start[k] += f * solution.end_forces[at][k]);
            (0..3).for_each(|k| q[k] += f * solution.uniform[at][k]);
        }
        Line { span: &solution.spans[member], start, q, placed: solution.placed_on(member), factors }
    }

    /// Length of the member.
    pub fn length(&self) -> f64 {
        self.span.length
    }

    fn factored(&self) -> impl Iterator<Item = (f64, &'a SpanLoad)> + '_ {
        self.placed.iter().filter_map(|p| self.factors.get(p.case as usize).map(|f| (*f, &p.load)))
    }

    /// `n`-fold running integral of the load, component `c`.
    fn load(&self, c: usize, x: f64, n: i32) -> f64 {
        const FACTORIAL: [f64; 5] = [1.0, 1.0, 2.0, 6.0, 24.0];
        let placed: f64 = self.factored().map(|(f, l)| f * integral(l, c, x, n)).sum();
        self.q[c] * x.powi(n) / FACTORIAL[n as usize] + placed
    }

    /// N Vy Vz T My Mz at `x` from end i; just left of a point load at `x`.
    pub fn forces(&self, x: f64) -> [f64; 6] {
        let s = &self.start;
        [
            // Taken from zero rather than negated: no -0 in the answers.
            0.0 - s[0] - self.load(0, x, 1),
            0.0 - s[1] - self.load(1, x, 1),
            0.0 - s[2] - self.load(2, x, 1),
            0.0 - s[3],
            0.0 - s[4] - x * s[2] - self.load(2, x, 2),
            0.0 - s[5] + x * s[1] + self.load(1, x, 2),
        ]
    }

    /// Extremes of all six forces in closed form: at the ends, where loads begin or act, and where their slope is zero.
    pub fn extremes(&self) -> Extremes {
        let mut e =
            Extremes { least: [f64::INFINITY; 6], least_at: [0.0; 6], most: [f64::NEG_INFINITY; 6], most_at: [0.0; 6] };
        self.each_piece(|from, to| {
            e.take(from, self.forces_after(from));
            e.take(to, self.forces(to));
            // Moments turn where a shear is zero, forces where their load is.
            let turns = [
                zeros(from, to, |x| self.forces(x)[1]),
                zeros(from, to, |x| self.forces(x)[2]),
                zeros(from, to, |x| self.load(0, x, 0)),
                zeros(from, to, |x| self.load(1, x, 0)),
                zeros(from, to, |x| self.load(2, x, 0)),
            ];
            turns.into_iter().flatten().flatten().for_each(|x| e.take(x, self.forces(x)));
        });
        e
    }

    /// Least and largest normal stress `N/A +- My/Wy +- Mz/Wz` along the member; `area`, `wy`, `wz`: area and elastic section
    /// moduli about local y and z. Closed form as for [`Line::extremes`].
    pub fn stress(&self, area: f64, wy: f64, wz: f64) -> [f64; 2] {
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        let mut take = |f: [f64; 6]| {
            let (n, m) = (f[0] / area, f[4].abs() / wy + f[5].abs() / wz);
            range = [range[0].min(n - m), range[1].max(n + m)];
        };
        self.each_piece(|from, to| {
            take(self.forces_after(from));
            take(self.forces(to));
            for (a, b) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
                // d/dx of N/A + a My/Wy + b Mz/Wz: a parabola on the piece.
                let slope = |x: f64| {
                    let f = self.forces(x);
                    -self.load(0, x, 0) / area + a * f[2] / wy - b * f[1] / wz
                };
                zeros(from, to, slope).into_iter().flatten().for_each(|x| take(self.forces(x)));
            }
        });
        range
    }

    /// Deflection (v, w) along local y and z at `x` relative to the chord between the member's own ends: the beam on two
    /// supports under its end moments and loads, shear flexibility included when the model has it.
    pub fn deflection(&self, x: f64) -> [f64; 2] {
        let (s, l, t) = (&self.start, self.span.length, x / self.span.length);
        let twice = |x: f64| {
            let (a, b) = (0.5 * x * x, x * x * x / 6.0);
            [-s[5] * a + s[1] * b + self.load(1, x, 4), -s[4] * a - s[2] * b - self.load(2, x, 4)]
        };
        let (here, end) = (twice(x), twice(l));
        let [eiy, eiz] = self.span.bending;
        let bent = |k: usize, ei: f64| if ei > 0.0 { (here[k] - t * end[k]) / ei } else { 0.0 };
        let mut d = [bent(0, eiz), -bent(1, eiy)];
        if self.span.shear != [0.0; 2] {
            let (m0, m, m1) = (self.forces(0.0), self.forces(x), self.forces(l));
            let off = |k: usize| m[k] - (1.0 - t) * m0[k] - t * m1[k];
            d[0] -= self.span.shear[0] * off(5);
            d[1] += self.span.shear[1] * off(4);
        }
        d
    }

    /// Forces just right of `x`: point loads at `x` counted.
    fn forces_after(&self, x: f64) -> [f64; 6] {
        let mut f = self.forces(x);
        for (factor, load) in self.factored() {
            if let SpanLoad::Point { p, x: at } = *load
                && at == x
            {
                (0..3).for_each(|c| f[c] -= factor * p[c]);
            }
        }
        f
    }

    /// Visits the pieces (from, to) between places where a load begins, ends or acts; all forces are polynomials there.
    fn each_piece(&self, mut visit: impl FnMut(f64, f64)) {
        let (mut from, l) = (0.0, self.span.length);
        while from < l {
            let mut to = l;
            for (_, load) in self.factored() {
                let (a, b) = match *load {
                    SpanLoad::Point { x, .. } => (x, x),
                    SpanLoad::Linear { x1, x2, .. } => (x1, x2),
                };
                for x in [a, b].into_iter().filter(|&x| x > from) {
                    to = x.min(to);
                }
            }
            visit(from, to);
            from = to;
        }
    }
}

/// Zeros inside (from, to) of a parabola, known through three inner samples, so that jumps at the ends do not matter.
fn zeros(from: f64, to: f64, g: impl Fn(f64) -> f64) -> [Option<f64>; 2] {
    let at = |t: f64| g(from + t * (to - from));
    let (p, q, r) = (at(0.25), at(0.5), at(0.75));
    // g(t) = a (t - 1/2)^2 + b (t - 1/2) + q
    let (a, b) = (8.0 * (p + r - 2.0 * q), 2.0 * (r - p));
    let size = p.abs().max(q.abs()).max(r.abs());
    let inside = |s: f64| (s.abs() < 0.5).then_some(from + (s + 0.5) * (to - from));
    if a.abs() <= 1e-12 * size {
        return [if b == 0.0 { None } else { inside(-q / b) }, None];
    }
    let disc = b * b - 4.0 * a * q;
    if disc < 0.0 {
        return [None, None];
    }
    // The root without cancellation, and the other from their product.
    let h = -0.5 * (b + b.signum() * disc.sqrt());
    [inside(h / a), if h == 0.0 { None } else { inside(q / h) }]
}

impl Extremes {
    fn take(&mut self, x: f64, f: [f64; 6]) {
        for (k, v) in f.into_iter().enumerate() {
            if v < self.least[k] {
                (self.least[k], self.least_at[k]) = (v, x);
            }
            if v > self.most[k] {
                (self.most[k], self.most_at[k]) = (v, x);
            }
        }
    }
}
