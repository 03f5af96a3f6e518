//! Identities that the frames of whole houses keep: turning and mirroring the world, cutting members in two, superposition,
//! Maxwell's reciprocity, balance of forces and moments, and a condition number that a dense inverse confirms.
//!
//! The frames are those that `houscaper build sample:NAME` writes.

#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use houscaper::analysis::file::{self, FrameFile};
use houscaper::analysis::*;
use std::process::Command;
use std::sync::OnceLock;

const HOUSES: [&str; 3] = ["box", "hip", "stepped"];

/// The sample houses, each built once.
fn houses() -> &'static [FrameFile] {
    static FRAMES: OnceLock<Vec<FrameFile>> = OnceLock::new();
    FRAMES.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let build = |name: &&str| {
            let out = folder.path().join(name);
            let run = Command::new(env!("CARGO_BIN_EXE_houscaper"))
                .args(["build", &format!("sample:{name}"), "--out"])
                .arg(&out)
                .output()
                .unwrap();
            assert!(run.status.success(), "{name}: {}", String::from_utf8_lossy(&run.stderr));
            file::read(&std::fs::read(out.join("frame.json")).unwrap(), name).unwrap()
        };
        HOUSES.iter().map(build).collect()
    })
}

fn solved(model: &Model, cases: &[LoadCase]) -> Solution {
    let s = solve(model, cases).unwrap();
    assert!(s.status.is_solved(), "{:?}", s.status);
    s
}

/// Members with their reference vectors written out, so that they can be turned with the rest.
fn referenced(model: &Model) -> Model {
    let mut model = model.clone();
    for m in &mut model.members {
        let roll = std::mem::take(&mut m.roll);
        let before = Member { roll, ..m.clone() };
        let (axes, _) = local_axes(&before, model.nodes[m.nodes[0]], model.nodes[m.nodes[1]]).unwrap();
        m.reference = Some(axes[2]);
    }
    model
}

/// All forces of the world through `vector`; local components stay.
fn moved(model: &Model, cases: &[LoadCase], vector: impl Fn([f64; 3]) -> [f64; 3]) -> (Model, Vec<LoadCase>) {
    let (mut model, mut cases) = (referenced(model), cases.to_vec());
    model.nodes.iter_mut().for_each(|p| *p = vector(*p));
    model.members.iter_mut().for_each(|m| m.reference = m.reference.map(&vector));
    for c in &mut cases {
        assert!(c.nodal.is_empty() && c.settlements.is_empty());
        c.gravity = vector(c.gravity);
        for l in c.members.iter_mut().filter(|l| l.axes == Axes::Global) {
            l.distribution = match l.distribution {
                Distribution::Uniform { q } => Distribution::Uniform { q: vector(q) },
                Distribution::Point { p, x } => Distribution::Point { p: vector(p), x },
                Distribution::Linear { q1, q2, x1, x2 } => {
                    Distribution::Linear { q1: vector(q1), q2: vector(q2), x1, x2 }
                }
            };
        }
    }
    (model, cases)
}

/// Supports that hold all translations, and all rotations or none: the same from every side.
fn isotropic(model: &Model) -> bool {
    let same = |f: &[bool]| f.iter().all(|v| *v == f[0]);
    model.supports.iter().all(|s| same(&s.fix[..3]) && same(&s.fix[3..]))
}

/// Largest difference between two tables of one case, relative to the largest value of the same kind (forces, then moments;
/// translations, then rotations).
fn gap<const N: usize>(a: &[[f64; N]], b: &[[f64; N]], seen: impl Fn([f64; N]) -> [f64; N]) -> f64 {
    let (mut off, mut size) = ([0.0f64; 2], [f64::MIN_POSITIVE; 2]);
    for (x, y) in a.iter().zip(b) {
        let x = seen(*x);
        for k in 0..N {
            off[k / 3 % 2] = off[k / 3 % 2].max((x[k] - y[k]).abs());
            size[k / 3 % 2] = size[k / 3 % 2].max(y[k].abs());
        }
    }
    (off[0] / size[0]).max(off[1] / size[1])
}

/// A turn of 0.8 about a skew axis.
fn turned(p: [f64; 3]) -> [f64; 3] {
    let (c, s, k) = (0.8f64.cos(), 0.8f64.sin(), [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0]);
    let dot: f64 = (0..3).map(|d| k[d] * p[d]).sum();
    let cross = [k[1] * p[2] - k[2] * p[1], k[2] * p[0] - k[0] * p[2], k[0] * p[1] - k[1] * p[0]];
    std::array::from_fn(|d| p[d] * c + cross[d] * s + k[d] * dot * (1.0 - c))
}

#[test]
fn turning_a_house_turns_its_answer() {
    for (name, f) in HOUSES.iter().zip(houses()) {
        assert!(isotropic(&f.model), "{name}");
        let (model, cases) = moved(&f.model, &f.cases, turned);
        let (s, t) = (solved(&f.model, &f.cases), solved(&model, &cases));
        let both = |v: [f64; 6]| {
            let (a, b) = (turned([v[0], v[1], v[2]]), turned([v[3], v[4], v[5]]));
            [a[0], a[1], a[2], b[0], b[1], b[2]]
        };
        for c in 0..cases.len() {
            // The worst of 17 cases is 1e-11 away: rounding times the condition of a house, 1e6.
            assert!(gap(s.end_forces(c), t.end_forces(c), |v| v) < 1e-8, "{name} case {c}");
            assert!(gap(s.displacements(c), t.displacements(c), both) < 1e-8, "{name} case {c}");
            assert!(gap(s.reactions(c), t.reactions(c), both) < 1e-8, "{name} case {c}");
        }
    }
}

#[test]
fn mirroring_a_house_mirrors_its_answer() {
    // Local z is mirrored with the reference vector, local y = z x x turns over: forces along y, moments about x and z change
    // their sign; globally, translations mirror and rotations are what a mirror does to a turn.
    for (name, f) in HOUSES.iter().zip(houses()) {
        let (model, cases) = moved(&f.model, &f.cases, |p| [-p[0], p[1], p[2]]);
        let (s, t) = (solved(&f.model, &f.cases), solved(&model, &cases));
        let global = |v: [f64; 6]| [-v[0], v[1], v[2], v[3], -v[4], -v[5]];
        let local = |v: [f64; 12]| std::array::from_fn(|k| v[k] * [1.0, -1.0, 1.0, -1.0, 1.0, -1.0][k % 6]);
        for c in 0..cases.len() {
            assert!(gap(s.end_forces(c), t.end_forces(c), local) < 1e-8, "{name} case {c}");
            assert!(gap(s.displacements(c), t.displacements(c), global) < 1e-8, "{name} case {c}");
            assert!(gap(s.reactions(c), t.reactions(c), global) < 1e-8, "{name} case {c}");
        }
    }
}

#[test]
fn members_cut_in_two_change_nothing() {
    for (name, f) in HOUSES.iter().zip(houses()) {
        let (mut model, mut cases) = (f.model.clone(), f.cases.clone());
        let whole = model.members.len();
        // Every third member of the framing at a third of its length; braces stand for panels and have no bending to speak of.
        for m in (0..whole).step_by(3).filter(|&m| f.model.materials[f.model.members[m].material].rho > 0.0) {
            let [i, j] = model.members[m].nodes;
            let (a, b) = (model.nodes[i], model.nodes[j]);
            let node = model.nodes.len();
            model.nodes.push(std::array::from_fn(|d| a[d] + (b[d] - a[d]) / 3.0));
            let mut second = model.members[m].clone();
            second.nodes = [node, j];
            second.releases[0] = [false; 6];
            model.members[m].nodes = [i, node];
            model.members[m].releases[1] = [false; 6];
            for c in &mut cases {
                let on_it: Vec<MemberLoad> = c.members.iter().filter(|l| l.member == m).copied().collect();
                assert!(on_it.iter().all(|l| matches!(l.distribution, Distribution::Uniform { .. })));
                c.members.extend(on_it.iter().map(|l| MemberLoad { member: model.members.len(), ..*l }));
            }
            model.members.push(second);
        }
        assert!(model.members.len() > whole + 20);
        let (s, t) = (solved(&f.model, &f.cases), solved(&model, &cases));
        let nodes = f.model.nodes.len();
        for c in 0..cases.len() {
            assert!(gap(s.displacements(c), &t.displacements(c)[..nodes], |v| v) < 1e-8, "{name} case {c}");
            assert!(gap(s.reactions(c), t.reactions(c), |v| v) < 1e-8, "{name} case {c}");
            // At the end that stayed.
            let first = |s: &Solution| -> Vec<[f64; 6]> {
                s.end_forces(c)[..whole].iter().map(|e| std::array::from_fn(|k| e[k])).collect()
            };
            assert!(gap(&first(&s), &first(&t), |v| v) < 1e-8, "{name} case {c}");
        }
    }
}

#[test]
fn a_sum_of_loads_gives_the_sum_of_answers() {
    for (name, f) in HOUSES.iter().zip(houses()) {
        let factors: Vec<f64> = (0..f.cases.len()).map(|c| [1.35, -0.7, 1.5, 0.3][c % 4]).collect();
        let mut sum = LoadCase::default();
        for (case, k) in f.cases.iter().zip(&factors) {
            (0..3).for_each(|d| sum.gravity[d] += k * case.gravity[d]);
            sum.members.extend(case.members.iter().map(|l| MemberLoad {
                distribution: match l.distribution {
                    Distribution::Uniform { q } => Distribution::Uniform { q: q.map(|v| k * v) },
                    other => panic!("{other:?}"),
                },
                ..*l
            }));
        }
        let (s, t) = (solved(&f.model, &f.cases), solved(&f.model, &[sum]));
        let mut added = vec![[0.0; 12]; f.model.members.len()];
        for (c, k) in factors.iter().enumerate() {
            let rows = added.iter_mut().zip(s.end_forces(c));
            rows.for_each(|(a, e)| (0..12).for_each(|d| a[d] += k * e[d]));
        }
        assert!(gap(&added, t.end_forces(0), |v| v) < 1e-9, "{name}");
        let size = t.end_forces(0).iter().flatten().fold(0.0f64, |m, v| m.max(v.abs()));
        for m in (0..f.model.members.len()).step_by(7) {
            let (a, b) = (Line::new(&s, &factors, m), Line::new(&t, &[1.0], m));
            let x = 0.37 * a.length();
            (0..6).for_each(|d| assert!((a.forces(x)[d] - b.forces(x)[d]).abs() < 1e-9 * size, "{name} member {m}"));
        }
    }
}

#[test]
fn what_a_load_here_moves_there_a_load_there_moves_here() {
    for (name, f) in HOUSES.iter().zip(houses()) {
        // A unit force at each of eight nodes; far nodes and all three directions.
        let held: Vec<usize> = f.model.supports.iter().map(|s| s.node).collect();
        let free: Vec<usize> = (0..f.model.nodes.len()).filter(|n| !held.contains(n)).collect();
        let at: Vec<(usize, usize)> = (0..8).map(|k| (free[k * (free.len() - 1) / 7], k % 3)).collect();
        let unit = |&(node, d): &(usize, usize)| {
            let force = std::array::from_fn(|k| if k == d { 1.0 } else { 0.0 });
            LoadCase { nodal: vec![NodalLoad { node, force }], ..Default::default() }
        };
        let s = solved(&f.model, &at.iter().map(unit).collect::<Vec<_>>());
        let flexibility = |a: usize, b: usize| s.displacements(a)[at[b].0][at[b].1];
        let top = (0..8).map(|k| flexibility(k, k)).fold(0.0, f64::max);
        for (a, b) in (0..8).flat_map(|a| (0..a).map(move |b| (a, b))) {
            assert!((flexibility(a, b) - flexibility(b, a)).abs() < 1e-9 * top, "{name} {a} {b}");
        }
    }
}

#[test]
fn reactions_balance_forces_and_moments_of_every_case() {
    for (name, f) in HOUSES.iter().zip(houses()) {
        let s = solved(&f.model, &f.cases);
        for (c, case) in f.cases.iter().enumerate() {
            let (mut sum, mut size) = ([0.0f64; 6], [0.0f64; 2]);
            let mut add = |p: [f64; 3], g: [f64; 3], m: [f64; 3]| {
                let arm = [p[1] * g[2] - p[2] * g[1], p[2] * g[0] - p[0] * g[2], p[0] * g[1] - p[1] * g[0]];
                for d in 0..3 {
                    sum[d] += g[d];
                    sum[3 + d] += arm[d] + m[d];
                    size[0] += g[d].abs();
                    size[1] += arm[d].abs() + m[d].abs();
                }
            };
            for (support, r) in f.model.supports.iter().zip(s.reactions(c)) {
                add(f.model.nodes[support.node], [r[0], r[1], r[2]], [r[3], r[4], r[5]]);
            }
            // All loads are uniform: gravity too, and all of it is in the table of uniform loads.
            for (m, q) in s.uniform_loads(c).iter().enumerate() {
                let [a, b] = f.model.members[m].nodes.map(|n| f.model.nodes[n]);
                let axes = s.axes(m);
                let g = std::array::from_fn(|d| s.length(m) * (0..3).map(|k| axes[k][d] * q[k]).sum::<f64>());
                add(std::array::from_fn(|d| 0.5 * (a[d] + b[d])), g, [0.0; 3]);
            }
            for d in 0..6 {
                assert!(sum[d].abs() <= 1e-11 * size[d / 3], "{name} {}: {sum:?} of {size:?}", case.name);
            }
        }
    }
}

#[test]
fn the_condition_estimate_is_that_of_the_dense_inverse() {
    let f = &houses()[0];
    let mut solver = Solver::new();
    assert!(solver.condition().is_none());
    assert!(solver.solve(&f.model, &f.cases[..1]).unwrap().status.is_solved());
    let estimate = solver.condition().unwrap();
    // The same matrix, dense: supports left out, as are rotations that no member resists.
    let n = 6 * f.model.nodes.len();
    let mut k = nalgebra::DMatrix::<f64>::zeros(n, n);
    for m in &f.model.members {
        let ends = m.nodes.map(|n| f.model.nodes[n]);
        let (material, section) = (&f.model.materials[m.material], &f.model.sections[m.section]);
        let own = member_stiffness(m, ends, material, section, f.model.shear).unwrap();
        let at = |d: usize| 6 * m.nodes[d / 6] + d % 6;
        (0..144).for_each(|e| k[(at(e / 12), at(e % 12))] += own[e / 12][e % 12]);
    }
    let held = |d: usize| f.model.supports.iter().any(|s| s.node == d / 6 && s.fix[d % 6]);
    let kept: Vec<usize> = (0..n).filter(|&d| !held(d)).collect();
    assert_eq!(kept.len(), solver.size().unknowns, "the house has idle rotations: take them out here too");
    let scaled = nalgebra::DMatrix::from_fn(kept.len(), kept.len(), |r, c| {
        let (r, c) = (kept[r], kept[c]);
        k[(r, c)] / (k[(r, r)] * k[(c, c)]).sqrt()
    });
    let norm = |m: &nalgebra::DMatrix<f64>| m.column_iter().map(|c| c.abs().sum()).fold(0.0, f64::max);
    let exact = norm(&scaled) * norm(&scaled.clone().try_inverse().unwrap());
    // A lower bound that is seldom off by more than three (Higham 1988, section 5).
    assert!(estimate <= exact * 1.000_001 && estimate >= exact / 3.0, "{estimate:e} of {exact:e}");
    println!("estimate {estimate:.3e}, exact {exact:.3e}");
}
