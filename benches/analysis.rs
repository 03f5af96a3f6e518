//! Build to end forces of frames under six load cases: platform framing of starter houses, and three box houses whose every
//! panel has rails and a diagonal, of 512, 1,725 and 7,489 nodes.
//!
//! `HOUSCAPER_WRITE_FRAMES=folder cargo bench --bench analysis` also writes the frames, for tests/tools/opensees_speed.py, which
//! times OpenSees and PyNite on them.

#![allow(clippy::unwrap_used)]

use houscaper::analysis::file::{self, FrameFile};
use houscaper::analysis::*;
use std::collections::BTreeMap;

fn main() {
    if let Some(folder) = std::env::var_os("HOUSCAPER_WRITE_FRAMES") {
        for size in PLATFORMS {
            write(folder.as_ref(), "platform", platform(size));
        }
        for size in SHELLS {
            write(folder.as_ref(), "shell", shell(size));
        }
    }
    divan::main();
}

fn write(folder: &std::path::Path, kind: &str, (model, cases): (Model, Vec<LoadCase>)) {
    let name = format!("{kind}-{}", model.nodes.len());
    let path = folder.join(format!("{name}.json"));
    std::fs::write(path, file::write(&FrameFile { name, model, cases, ..Default::default() })).unwrap();
}

const PIN: [bool; 6] = [false, false, false, false, true, true];
const PLATFORMS: [(usize, usize, usize); 2] = [(8, 8, 3), (12, 10, 5)];
/// Modules along x, y, z; parts that a module edge is cut into; partitions by axis and place.
type Shell = ([i32; 3], i32, &'static [(usize, i32)]);
const SHELLS: [Shell; 3] = [
    ([9, 7, 12], 1, &[]),
    ([14, 12, 14], 1, &[(0, 3), (0, 7), (0, 11), (1, 6)]),
    ([14, 14, 14], 2, &[(0, 5), (0, 9), (1, 7)]),
];

fn timber(sections: &[(f64, f64)]) -> Model {
    let mut model = Model { shear: false, ..Default::default() };
    model.materials.push(Material { e: 11e9, g: 0.69e9, rho: 420.0 });
    for &(b, h) in sections {
        let (iy, iz): (f64, f64) = (b * h * h * h / 12.0, h * b * b * b / 12.0);
        model.sections.push(Section { a: b * h, iy, iz, j: iz * 3.0, asy: None, asz: None });
    }
    model
}

/// Storeys of walls around `nx` by `ny` modules of 0.9 m: studs pinned between continuous plates, a brace in every third panel,
/// joists pinned across each floor.
fn platform((nx, ny, storeys): (usize, usize, usize)) -> (Model, Vec<LoadCase>) {
    let ring: Vec<(usize, usize)> = (0..nx)
        .map(|x| (x, 0))
        .chain((0..ny).map(|y| (nx, y)))
        .chain((0..nx).map(|x| (nx - x, ny)))
        .chain((0..ny).map(|y| (0, ny - y)))
        .collect();
    let mut inner = Vec::new();
    for x in 1..nx {
        for y in [ny / 3, 2 * ny / 3] {
            inner.push((x, y));
        }
    }
    let per = ring.len() + inner.len();
    let mut model = timber(&[(0.038, 0.12), (0.045, 0.22)]);
    for s in 0..=storeys {
        let z = 3.24 * s as f64;
        model.nodes.extend(ring.iter().chain(&inner).map(|&(x, y)| [0.9 * x as f64, 0.9 * y as f64, z]));
    }
    let mut add = |i: usize, j: usize, section: usize, pinned: bool| {
        let releases = if pinned { [PIN; 2] } else { [[false; 6]; 2] };
        model.members.push(Member { nodes: [i, j], material: 0, section, reference: None, roll: 0.0, releases });
    };
    for s in 0..=storeys {
        let at = |k: usize| s * per + k;
        let of = |p: (usize, usize)| at(ring.iter().chain(&inner).position(|q| *q == p).unwrap());
        for k in 0..per {
            if s > 0 {
                add(at(k) - per, at(k), 0, true);
            }
        }
        for k in 0..ring.len() {
            let next = (k + 1) % ring.len();
            if s > 0 {
                add(at(k), at(next), 0, false);
                if k % 3 == 0 {
                    add(at(k) - per, at(next), 0, true);
                }
            }
        }
        for x in (1..nx).filter(|_| s > 0) {
            let line = [(x, 0), (x, ny / 3), (x, 2 * ny / 3), (x, ny)];
            line.windows(2).for_each(|w| add(of(w[0]), of(w[1]), 1, false));
            if x % 2 == 1 {
                add(of((x, 0)), of((x + 1, ny / 3)), 0, true);
            }
        }
    }
    model.supports = (0..per).map(|node| Support { node, fix: [true, true, true, false, false, false] }).collect();
    let loads = |k: usize| {
        let q: [f64; 3] = std::array::from_fn(|d| match k {
            0 if d == 2 => -1800.0,
            _ if k % 2 == d => 400.0,
            _ => 0.0,
        });
        (0..model.members.len()).filter(|m| m % 2 == 0).map(move |m| uniform(m, q)).collect()
    };
    let mut cases = vec![LoadCase { gravity: [0.0, 0.0, -9.81], ..Default::default() }];
    cases.extend((0..5).map(|k| LoadCase { members: loads(k), ..Default::default() }));
    (model, cases)
}

fn uniform(member: usize, q: [f64; 3]) -> MemberLoad {
    MemberLoad { member, axes: Axes::Global, distribution: Distribution::Uniform { q } }
}

type Key = [i32; 3];

/// A solid box of modules of 900 x 900 x 540 mm under a gable: rails, studs and a diagonal on every panel of its shell, joists
/// both ways at every sixth level, partitions; pinned feet. Weight, imposed load and four winds.
fn shell((size, sub, partitions): Shell) -> (Model, Vec<LoadCase>) {
    const STUD: usize = 0;
    const RAIL: usize = 1;
    const JOIST: usize = 2;
    const RAFTER: usize = 3;
    const DIAGONAL: usize = 4;
    let n = size.map(|k| k * sub);
    let mut edges: Vec<(Key, Key, usize)> = Vec::new();
    let mut seen = std::collections::BTreeSet::new();
    let mut edge = |a: Key, b: Key, section: usize| {
        if seen.insert((a.min(b), a.max(b))) {
            edges.push((a, b, section));
        }
    };
    let mut face = |c: [Key; 4], across: usize, up: usize, diagonal: Option<bool>| {
        edge(c[0], c[1], across);
        edge(c[3], c[2], across);
        edge(c[0], c[3], up);
        edge(c[1], c[2], up);
        match diagonal {
            Some(true) => edge(c[1], c[3], DIAGONAL),
            Some(false) => edge(c[0], c[2], DIAGONAL),
            None => {}
        }
    };
    let panel = |p: Key, u: usize, v: usize| {
        let step = |p: Key, a: usize| std::array::from_fn(|d| p[d] + i32::from(d == a));
        [p, step(p, u), step(step(p, u), v), step(p, v)]
    };
    let odd = |p: Key| (p[0] + p[1] + p[2]) % 2 == 1;
    for (axis, u) in [(0, 1), (1, 0)] {
        for at in [0, n[axis]] {
            for k in 0..n[2] {
                for i in 0..n[u] {
                    let mut p = [0, 0, k];
                    (p[axis], p[u]) = (at, i);
                    face(panel(p, u, 2), RAIL, STUD, Some(odd(p)));
                }
            }
        }
    }
    let level = |k: i32| (0..n[0]).flat_map(move |i| (0..n[1]).map(move |j| [i, j, k]));
    level(n[2]).for_each(|p| face(panel(p, 0, 1), RAFTER, RAFTER, Some(odd(p))));
    for k in (6 * sub..n[2]).step_by(6 * sub as usize) {
        level(k).for_each(|p| face(panel(p, 0, 1), JOIST, JOIST, None));
    }
    for &(axis, at) in partitions {
        let u = 1 - axis;
        for i in 0..n[u] {
            for k in 0..n[2] {
                let mut p = [0, 0, k];
                (p[axis], p[u]) = (at * sub, i);
                face(panel(p, u, 2), RAIL, STUD, Some((i + k) % 2 == 1));
            }
        }
    }
    let mut index: BTreeMap<Key, usize> = edges.iter().flat_map(|e| [(e.0, 0), (e.1, 0)]).collect();
    index.values_mut().enumerate().for_each(|(k, v)| *v = k);
    let mut model = timber(&[(0.06, 0.12), (0.06, 0.12), (0.06, 0.2), (0.08, 0.18), (0.04, 0.08)]);
    let half = 0.45 * f64::from(size[0]);
    for key in index.keys() {
        let mut p: [f64; 3] = std::array::from_fn(|d| f64::from(key[d]) * [0.9, 0.9, 0.54][d] / f64::from(sub));
        if key[2] == n[2] {
            p[2] += 0.6 * (half - (p[0] - half).abs());
        }
        model.nodes.push(p);
    }
    for (a, b, section) in &edges {
        let nodes = [index[a], index[b]];
        let member =
            Member { nodes, material: 0, section: *section, reference: None, roll: 0.0, releases: [[false; 6]; 2] };
        model.members.push(member);
    }
    let feet = index.iter().filter(|(k, _)| k[2] == 0);
    model.supports = feet.map(|(_, &node)| Support { node, fix: [true, true, true, false, false, false] }).collect();
    let width = 0.9 / f64::from(sub);
    let of = |section: usize, q: [f64; 3]| -> Vec<MemberLoad> {
        (0..edges.len()).filter(|&m| edges[m].2 == section).map(|m| uniform(m, q)).collect()
    };
    let mut weight = LoadCase { gravity: [0.0, 0.0, -9.81], ..Default::default() };
    weight.members = of(JOIST, [0.0, 0.0, -250.0 * width]);
    let mut imposed = LoadCase { members: of(JOIST, [0.0, 0.0, -1000.0 * width]), ..Default::default() };
    imposed.members.extend(of(RAFTER, [0.0, 0.0, -500.0 * width]));
    let wind = |axis: usize, sign: f64| {
        let mut case = LoadCase::default();
        for (m, (a, _, _)) in edges.iter().enumerate().filter(|(_, e)| e.2 == STUD) {
            let windward = if sign > 0.0 { 0 } else { n[axis] };
            let factor = match a[axis] {
                k if k == windward => 0.8,
                k if k == n[axis] - windward => 0.5,
                _ => continue,
            };
            let mut q = [0.0; 3];
            q[axis] = sign * factor * 1000.0 * width;
            case.members.push(uniform(m, q));
        }
        case
    };
    (model, vec![weight, imposed, wind(0, 1.0), wind(1, 1.0), wind(0, -1.0), wind(1, -1.0)])
}

fn bench(bencher: divan::Bencher, (model, cases): (Model, Vec<LoadCase>)) {
    let mut solver = Solver::new();
    let mut solution = Solution::default();
    solver.solve_into(&model, &cases, &mut solution).unwrap();
    assert!(solution.status.is_solved(), "{:?}", solution.status);
    let (mut least, size) = (solver.phases(), solver.size());
    bencher.bench_local(|| {
        solver.solve_into(&model, &cases, &mut solution).unwrap();
        least = if solver.phases().total() < least.total() { solver.phases() } else { least };
    });
    let phases = least.each().map(|(name, time)| format!("{name} {:.3}", 1e3 * time.as_secs_f64()));
    eprintln!(
        "{} nodes, {} members, {} unknowns, {} bytes each; quickest, ms: {}",
        model.nodes.len(),
        model.members.len(),
        size.unknowns,
        size.bytes / size.unknowns,
        phases.join(", ")
    );
}

#[divan::bench(args = PLATFORMS, sample_count = 100)]
fn platform_framing(bencher: divan::Bencher, size: (usize, usize, usize)) {
    bench(bencher, platform(size));
}

#[divan::bench(args = SHELLS.map(|s| s.0), sample_count = 20)]
fn framed_shell(bencher: divan::Bencher, modules: &[i32; 3]) {
    let size = SHELLS.into_iter().find(|s| s.0 == *modules).unwrap();
    bench(bencher, shell(size));
}
