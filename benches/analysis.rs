//! Build, factor, seven cases and end forces of house-like frames: platform framing, pinned studs and braces.

#![allow(clippy::unwrap_used)]

use houscaper::analysis::*;

fn main() {
    divan::main();
}

/// Two storeys of walls around `nx` by `ny` modules of 0.9 m: studs pinned between continuous plates, a brace in every third
/// panel, joists pinned across each floor.
fn house(nx: usize, ny: usize, storeys: usize) -> (Model, Vec<LoadCase>) {
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
    let mut model = Model { shear: false, ..Default::default() };
    model.materials.push(Material { e: 11e9, g: 0.69e9, rho: 420.0 });
    for (b, h) in [(0.038, 0.12), (0.045, 0.22)] {
        let (iy, iz): (f64, f64) = (b * h * h * h / 12.0, h * b * b * b / 12.0);
        model.sections.push(Section { a: b * h, iy, iz, j: iz * 3.0, asy: None, asz: None });
    }
    for s in 0..=storeys {
        let z = 3.24 * s as f64;
        model.nodes.extend(ring.iter().chain(&inner).map(|&(x, y)| [0.9 * x as f64, 0.9 * y as f64, z]));
    }
    let pin = [false, false, false, false, true, true];
    let mut add = |i: usize, j: usize, section: usize, pinned: bool| {
        let releases = if pinned { [pin; 2] } else { [[false; 6]; 2] };
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
    let mut cases = vec![LoadCase { gravity: [0.0, 0.0, -9.81], ..Default::default() }];
    for k in 0..6 {
        let q: [f64; 3] = std::array::from_fn(|d| {
            if k == 0 && d == 2 {
                -1800.0
            } else if k % 2 == d {
                400.0
            } else {
                0.0
            }
        });
        let members = (0..model.members.len()).filter(|m| m % 2 == 0);
        let load = |member| MemberLoad { member, axes: Axes::Global, distribution: Distribution::Uniform { q } };
        cases.push(LoadCase { members: members.map(load).collect(), ..Default::default() });
    }
    (model, cases)
}

#[divan::bench(args = [(8, 8, 3), (12, 10, 5), (16, 12, 5)], sample_count = 60)]
fn solve_house(bencher: divan::Bencher, size: (usize, usize, usize)) {
    let (model, cases) = house(size.0, size.1, size.2);
    let mut solver = Solver::new();
    let mut solution = Solution::default();
    solver.solve_into(&model, &cases, &mut solution).unwrap();
    assert!(solution.status.is_solved(), "{:?}", solution.status);
    eprintln!("{} nodes, {} members, {:?}", model.nodes.len(), model.members.len(), solution.status);
    bencher.bench_local(|| solver.solve_into(&model, &cases, &mut solution).unwrap());
}
