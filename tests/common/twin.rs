//! A slow twin of the solver: its own formulas, dense, in numbers of 32 digits. Shares no code with `houscaper::analysis`.
#![allow(dead_code, clippy::needless_range_loop)]

use super::dd::Dd;
use houscaper::analysis::{Axes, Distribution, Idle, LoadCase, Member, Model};

type V3 = [Dd; 3];

/// Displacements by node, reactions by node, end forces by member, of one case.
pub struct Answer {
    /// ux uy uz rx ry rz.
    pub disp: Vec<[f64; 6]>,
    /// By node; zero where nothing is held.
    pub reac: Vec<[f64; 6]>,
    /// At i, then j, local axes.
    pub endf: Vec<[f64; 12]>,
}

fn dd(v: f64) -> Dd {
    Dd::from(v)
}

fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn norm(a: V3) -> Dd {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}

fn over(a: V3, s: Dd) -> V3 {
    a.map(|v| v / s)
}

struct Bar {
    axes: [V3; 3],
    k: Vec<[Dd; 12]>,
    /// What a column of fixed-end forces becomes when the released ends let go.
    carry: Vec<[Dd; 12]>,
    length: Dd,
    phi: [Dd; 2],
}

fn axes(m: &Member, from: [f64; 3], to: [f64; 3]) -> ([V3; 3], Dd) {
    let along: V3 = std::array::from_fn(|d| dd(to[d]) - dd(from[d]));
    let length = norm(along);
    let x = over(along, length);
    let level = (x[0].value()).hypot(x[1].value()) > 1e-9;
    let v = match m.reference {
        Some(r) => r,
        None if level => [0.0, 0.0, 1.0],
        None => [if x[2].value() > 0.0 { -1.0 } else { 1.0 }, 0.0, 0.0],
    };
    let y = cross(v.map(dd), x);
    let y = over(y, norm(y));
    let z = cross(x, y);
    let (s, c) = (dd(m.roll.sin()), dd(m.roll.cos()));
    ([x, std::array::from_fn(|d| c * y[d] + s * z[d]), std::array::from_fn(|d| c * z[d] - s * y[d])], length)
}

/// Adds the springs of bending in one plane: places of v_i, r_i, v_j, r_j; `sign` -1 where a positive rotation is a falling slope.
fn bend(k: &mut [[Dd; 12]], at: [usize; 4], ei: Dd, l: Dd, phi: Dd, sign: f64) {
    let c = ei / (l * l * l * (dd(1.0) + phi));
    let rows = [
        [dd(12.0), dd(6.0) * l, dd(-12.0), dd(6.0) * l],
        [dd(6.0) * l, (dd(4.0) + phi) * l * l, dd(-6.0) * l, (dd(2.0) - phi) * l * l],
        [dd(-12.0), dd(-6.0) * l, dd(12.0), dd(-6.0) * l],
        [dd(6.0) * l, (dd(2.0) - phi) * l * l, dd(-6.0) * l, (dd(4.0) + phi) * l * l],
    ];
    for r in 0..4 {
        for s in 0..4 {
            let turn = if (r + s) % 2 == 1 { sign } else { 1.0 };
            k[at[r]][at[s]] += dd(turn) * c * rows[r][s];
        }
    }
}

fn bar(model: &Model, m: &Member) -> Bar {
    let (axes, l) = axes(m, model.nodes[m.nodes[0]], model.nodes[m.nodes[1]]);
    let (mat, sec) = (&model.materials[m.material], &model.sections[m.section]);
    let (e, g) = (dd(mat.e), dd(mat.g));
    let phi = |i: f64, area: Option<f64>| match area {
        Some(a) if model.shear => dd(12.0) * e * dd(i) / (g * dd(a) * l * l),
        _ => Dd::ZERO,
    };
    let phi = [phi(sec.iz, sec.asy), phi(sec.iy, sec.asz)];
    let mut k = vec![[Dd::ZERO; 12]; 12];
    for (at, spring) in [(0, e * dd(sec.a) / l), (3, g * dd(sec.j) / l)] {
        k[at][at] += spring;
        k[at + 6][at + 6] += spring;
        k[at][at + 6] -= spring;
        k[at + 6][at] -= spring;
    }
    bend(&mut k, [1, 5, 7, 11], e * dd(sec.iz), l, phi[0], 1.0);
    bend(&mut k, [2, 4, 8, 10], e * dd(sec.iy), l, phi[1], -1.0);
    let mut carry = vec![[Dd::ZERO; 12]; 12];
    (0..12).for_each(|d| carry[d][d] = dd(1.0));
    let whole: Vec<f64> = (0..12).map(|d| k[d][d].value()).collect();
    for d in (0..12).filter(|&d| m.releases[d / 6][d % 6]) {
        let (row, carried, pivot) = (k[d], carry[d], k[d][d]);
        if pivot.value() > 1e-24 * whole[d] {
            for r in (0..12).filter(|&r| r != d) {
                let f = row[r] / pivot;
                (0..12).for_each(|c| {
                    k[r][c] -= f * row[c];
                    carry[r][c] -= f * carried[c];
                });
            }
        }
        (0..12).for_each(|c| {
            k[d][c] = Dd::ZERO;
            k[c][d] = Dd::ZERO;
            carry[d][c] = Dd::ZERO;
        });
    }
    Bar { axes, k, carry, length: l, phi }
}

/// Forces on the held ends under a force at `t = x / l`.
fn point(f: &mut [Dd; 12], p: V3, t: Dd, b: &Bar) {
    let (one, l) = (dd(1.0), b.length);
    f[0] -= p[0] * (one - t);
    f[6] -= p[0] * t;
    for (plane, at, sign, q) in [(0, [1, 5, 7, 11], 1.0, p[1]), (1, [2, 4, 8, 10], -1.0, p[2])] {
        let (phi, t2, t3) = (b.phi[plane], t * t, t * t * t);
        let c = one / (one + phi);
        let half = phi * dd(0.5) * (t - t2);
        let shapes = [
            c * (one - dd(3.0) * t2 + dd(2.0) * t3 + phi * (one - t)),
            c * l * (t - dd(2.0) * t2 + t3 + half),
            c * (dd(3.0) * t2 - dd(2.0) * t3 + phi * t),
            c * l * (t3 - t2 - half),
        ];
        for k in 0..4 {
            f[at[k]] -= dd(if k % 2 == 1 { sign } else { 1.0 }) * q * shapes[k];
        }
    }
}

fn spread(f: &mut [Dd; 12], q1: V3, q2: V3, x1: Dd, x2: Dd, b: &Bar) {
    let g = (dd(3.0) / dd(20.0)).sqrt();
    for (t, w) in [(dd(0.5) - g, 5.0), (dd(0.5), 8.0), (dd(0.5) + g, 5.0)] {
        let x = x1 + t * (x2 - x1);
        let weight = dd(w) / dd(18.0) * (x2 - x1);
        point(f, std::array::from_fn(|d| (q1[d] + t * (q2[d] - q1[d])) * weight), x / b.length, b);
    }
}

fn local(b: &Bar, v: V3) -> V3 {
    std::array::from_fn(|r| b.axes[r][0] * v[0] + b.axes[r][1] * v[1] + b.axes[r][2] * v[2])
}

fn fixed_ends(model: &Model, bars: &[Bar], case: &LoadCase) -> Vec<[Dd; 12]> {
    let mut all = vec![[Dd::ZERO; 12]; bars.len()];
    for (m, b) in bars.iter().enumerate() {
        let member = &model.members[m];
        let mass = dd(model.materials[member.material].rho) * dd(model.sections[member.section].a);
        let q = local(b, case.gravity.map(|g| mass * dd(g)));
        spread(&mut all[m], q, q, Dd::ZERO, b.length, b);
    }
    for load in &case.members {
        let b = &bars[load.member];
        let turn = |v: [f64; 3]| match load.axes {
            Axes::Local => v.map(dd),
            Axes::Global => local(b, v.map(dd)),
        };
        let f = &mut all[load.member];
        match load.distribution {
            Distribution::Uniform { q } => spread(f, turn(q), turn(q), Dd::ZERO, b.length, b),
            Distribution::Linear { q1, q2, x1, x2 } => spread(f, turn(q1), turn(q2), dd(x1), dd(x2), b),
            Distribution::Point { p, x } => point(f, turn(p), dd(x) / b.length, b),
        }
    }
    for (f, b) in all.iter_mut().zip(bars) {
        *f = std::array::from_fn(|r| (0..12).fold(Dd::ZERO, |s, c| s + b.carry[r][c] * f[c]));
    }
    all
}

/// `T v` (local components of global ones) or its transpose, by threes.
fn turned(b: &Bar, v: &[Dd; 12], out: bool) -> [Dd; 12] {
    std::array::from_fn(|d| {
        let (base, r) = (d / 3 * 3, d % 3);
        (0..3).fold(Dd::ZERO, |s, c| s + v[base + c] * if out { b.axes[c][r] } else { b.axes[r][c] })
    })
}

fn product(b: &Bar, u: &[Dd; 12]) -> [Dd; 12] {
    std::array::from_fn(|r| (0..12).fold(Dd::ZERO, |s, c| s + b.k[r][c] * u[c]))
}

/// Dense LDLt; `None` when a pivot is lost.
struct Ldl {
    n: usize,
    l: Vec<Dd>,
}

impl Ldl {
    fn of(n: usize, mut a: Vec<Dd>) -> Option<Ldl> {
        let whole: Vec<f64> = (0..n).map(|d| a[d * n + d].value()).collect();
        for c in 0..n {
            let pivot = a[c * n + c];
            if !(pivot.value() > 1e-26 * whole[c] && pivot.value().is_finite()) {
                return None;
            }
            for r in c + 1..n {
                let f = a[r * n + c] / pivot;
                if f.0 == 0.0 {
                    continue;
                }
                for k in r..n {
                    if a[k * n + c].0 != 0.0 {
                        let v = f * a[k * n + c];
                        a[k * n + r] -= v;
                    }
                }
            }
            for r in c + 1..n {
                a[r * n + c] = a[r * n + c] / pivot;
            }
        }
        Some(Ldl { n, l: a })
    }

    fn solve(&self, b: &mut [Dd]) {
        let n = self.n;
        for c in 0..n {
            for r in c + 1..n {
                b[r] -= self.l[r * n + c] * b[c];
            }
        }
        (0..n).for_each(|d| b[d] = b[d] / self.l[d * n + d]);
        for c in (0..n).rev() {
            for r in c + 1..n {
                b[c] -= self.l[r * n + c] * b[r];
            }
        }
    }
}

/// Solves all cases; `idle`: directions without stiffness, held by a spring that no load reaches. `None` when the frame moves.
pub fn solve(model: &Model, cases: &[LoadCase], idle: &[Idle]) -> Option<Vec<Answer>> {
    let bars: Vec<Bar> = model.members.iter().map(|m| bar(model, m)).collect();
    let mut held = vec![[false; 6]; model.nodes.len()];
    model.supports.iter().for_each(|s| held[s.node] = s.fix);
    let mut number = vec![[usize::MAX; 6]; model.nodes.len()];
    let mut n = 0;
    for (node, fixed) in held.iter().enumerate() {
        for d in (0..6).filter(|&d| !fixed[d]) {
            number[node][d] = n;
            n += 1;
        }
    }
    let mut k = vec![Dd::ZERO; n * n];
    let at = |m: usize, d: usize| number[model.members[m].nodes[d / 6]][d % 6];
    for (m, b) in bars.iter().enumerate() {
        for c in 0..12 {
            let unit: [Dd; 12] = std::array::from_fn(|d| if d == c { dd(1.0) } else { Dd::ZERO });
            let column = turned(b, &product(b, &turned(b, &unit, false)), true);
            for r in 0..12 {
                if at(m, r) != usize::MAX && at(m, c) != usize::MAX {
                    k[at(m, r) * n + at(m, c)] += column[r];
                }
            }
        }
    }
    let rotation = number.iter().flat_map(|e| &e[3..]).filter(|e| **e != usize::MAX);
    let spring = rotation.map(|&e| k[e * n + e].value()).fold(0.0, f64::max);
    let spring = dd(if spring > 0.0 { spring } else { 1.0 });
    for i in idle {
        for (r, &row) in number[i.node].iter().enumerate() {
            for (c, &column) in number[i.node].iter().enumerate() {
                if row != usize::MAX && column != usize::MAX {
                    k[row * n + column] += spring * dd(i.direction[r]) * dd(i.direction[c]);
                }
            }
        }
    }
    let factor = Ldl::of(n, k)?;
    Some(cases.iter().map(|case| answer(model, &bars, case, &factor, &number, &held)).collect())
}

fn answer(
    model: &Model,
    bars: &[Bar],
    case: &LoadCase,
    factor: &Ldl,
    number: &[[usize; 6]],
    held: &[[bool; 6]],
) -> Answer {
    let fixed = fixed_ends(model, bars, case);
    let mut u = vec![[Dd::ZERO; 6]; model.nodes.len()];
    for s in &case.settlements {
        u[s.node][s.dof] += dd(s.value);
    }
    let both =
        |u: &[[Dd; 6]], m: usize| -> [Dd; 12] { std::array::from_fn(|d| u[model.members[m].nodes[d / 6]][d % 6]) };
    let ends = |u: &[[Dd; 6]], m: usize| -> [Dd; 12] {
        let f = product(&bars[m], &turned(&bars[m], &both(u, m), false));
        std::array::from_fn(|d| f[d] + fixed[m][d])
    };
    let mut open = vec![[Dd::ZERO; 6]; model.nodes.len()];
    for l in &case.nodal {
        (0..6).for_each(|d| open[l.node][d] += dd(l.force[d]));
    }
    let unbalanced = |u: &[[Dd; 6]]| {
        let mut rest = open.clone();
        for (m, member) in model.members.iter().enumerate() {
            let g = turned(&bars[m], &ends(u, m), true);
            (0..12).for_each(|d| rest[member.nodes[d / 6]][d % 6] -= g[d]);
        }
        rest
    };
    let rest = unbalanced(&u);
    let mut b = vec![Dd::ZERO; factor.n];
    for (row, equations) in rest.iter().zip(number) {
        (0..6).filter(|&d| equations[d] != usize::MAX).for_each(|d| b[equations[d]] = row[d]);
    }
    factor.solve(&mut b);
    for (row, equations) in u.iter_mut().zip(number) {
        (0..6).filter(|&d| equations[d] != usize::MAX).for_each(|d| row[d] = b[equations[d]]);
    }
    let rest = unbalanced(&u);
    let reac = rest.iter().zip(held).map(|(r, h)| std::array::from_fn(|d| if h[d] { -r[d].value() } else { 0.0 }));
    Answer {
        disp: u.iter().map(|row| row.map(Dd::value)).collect(),
        reac: reac.collect(),
        endf: (0..bars.len()).map(|m| ends(&u, m).map(Dd::value)).collect(),
    }
}
