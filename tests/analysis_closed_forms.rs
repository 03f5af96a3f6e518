//! Frames with closed-form answers, identities of the stiffness, and mechanisms.

#![allow(clippy::unwrap_used)]

use houscaper::analysis::*;

const E: f64 = 210e9;
const G: f64 = 81e9;
const SECTION: Section = Section { a: 2e-3, iy: 3e-6, iz: 5e-6, j: 4e-6, asy: None, asz: None };
const NONE: [[bool; 6]; 2] = [[false; 6]; 2];
const PIN: [bool; 6] = [false, false, false, false, true, true];
const FIXED: [bool; 6] = [true; 6];

fn member(i: usize, j: usize) -> Member {
    Member { nodes: [i, j], material: 0, section: 0, reference: None, roll: 0.0, releases: NONE }
}

fn frame(nodes: Vec<[f64; 3]>, members: Vec<Member>, supports: Vec<(usize, [bool; 6])>) -> Model {
    Model {
        nodes,
        materials: vec![Material { e: E, g: G, rho: 7850.0 }],
        sections: vec![SECTION],
        members,
        supports: supports.into_iter().map(|(node, fix)| Support { node, fix }).collect(),
        shear: false,
    }
}

fn nodal(node: usize, force: [f64; 6]) -> LoadCase {
    LoadCase { nodal: vec![NodalLoad { node, force }], ..Default::default() }
}

fn span(member: usize, axes: Axes, distribution: Distribution) -> LoadCase {
    LoadCase { members: vec![MemberLoad { member, axes, distribution }], ..Default::default() }
}

fn close(found: f64, expected: f64, scale: f64) {
    assert!((found - expected).abs() <= 1e-9 * scale.abs(), "found {found:e}, expected {expected:e}");
}

fn solved(model: &Model, cases: &[LoadCase]) -> Solution {
    let s = solve(model, cases).unwrap();
    assert!(s.status.is_solved(), "{:?}", s.status);
    s
}

#[test]
fn cantilever_in_every_direction() {
    // Tip load: P L^3/(3EI), slope P L^2/(2EI); torque T L/(GJ); axial N L/(EA).
    let l = 2.5;
    let model = frame(vec![[0.0; 3], [l, 0.0, 0.0]], vec![member(0, 1)], vec![(0, FIXED)]);
    let s = solved(&model, &[nodal(1, [1e3, 2e3, -3e3, 50.0, 0.0, 0.0])]);
    let u = s.displacements(0)[1];
    close(u[0], 1e3 * l / (E * 2e-3), u[0]);
    close(u[1], 2e3 * l.powi(3) / (3.0 * E * 5e-6), u[1]);
    close(u[2], -3e3 * l.powi(3) / (3.0 * E * 3e-6), u[2]);
    close(u[3], 50.0 * l / (G * 4e-6), u[3]);
    close(u[4], 3e3 * l * l / (2.0 * E * 3e-6), u[4]);
    close(u[5], 2e3 * l * l / (2.0 * E * 5e-6), u[5]);
    let r = s.reactions(0)[0];
    let expected = [-1e3, -2e3, 3e3, -50.0, -3e3 * l, -2e3 * l];
    (0..6).for_each(|d| close(r[d], expected[d], 8e3));
}

#[test]
fn timoshenko_cantilever_adds_shear() {
    let mut model = frame(vec![[0.0; 3], [1.0, 0.0, 0.0]], vec![member(0, 1)], vec![(0, FIXED)]);
    model.shear = true;
    model.sections[0].asy = Some(1e-3);
    model.sections[0].asz = Some(0.8e-3);
    let s = solved(&model, &[nodal(1, [0.0, 1e3, 1e3, 0.0, 0.0, 0.0])]);
    let u = s.displacements(0)[1];
    close(u[1], 1e3 / (3.0 * E * 5e-6) + 1e3 / (G * 1e-3), u[1]);
    close(u[2], 1e3 / (3.0 * E * 3e-6) + 1e3 / (G * 0.8e-3), u[2]);
}

#[test]
fn fixed_and_propped_beams() {
    // Fixed-fixed, uniform: q L^2/12 at the ends, q L^2/24 inside, q L^4/(384 EI).
    let (l, q) = (4.0, 1500.0);
    let ends = |i, j| frame(vec![[0.0; 3], [l, 0.0, 0.0]], vec![member(0, 1)], vec![(0, i), (1, j)]);
    let load = span(0, Axes::Global, Distribution::Uniform { q: [0.0, 0.0, -q] });
    let s = solved(&ends(FIXED, FIXED), std::slice::from_ref(&load));
    let f = s.end_forces(0)[0];
    close(f[2], q * l / 2.0, q * l);
    close(f[4], -q * l * l / 12.0, q * l * l);
    // Sagging is negative about y: the lower side is in tension.
    close(member_forces(&s, 0, 0, l / 2.0)[4], -q * l * l / 24.0, q * l * l);
    let line = Line::new(&s, &[1.0], 0);
    close(line.deflection(l / 2.0)[1], -q * l.powi(4) / (384.0 * E * 3e-6), 1e-3);
    let e = line.extremes();
    close(e.least[4], -q * l * l / 24.0, q * l * l);
    close(e.most[4], q * l * l / 12.0, q * l * l);

    // Propped: 3/8 q L at the prop, q L^2/8 at the wall, 9/128 q L^2 at 3/8 L from the prop.
    let mut propped = [true; 6];
    propped[4] = false;
    let s = solved(&ends(FIXED, propped), std::slice::from_ref(&load));
    close(s.reactions(0)[1][2], 0.375 * q * l, q * l);
    close(s.end_forces(0)[0][4].abs(), q * l * l / 8.0, q * l * l);
    close(Line::new(&s, &[2.0], 0).extremes().least[4], -2.0 * 9.0 / 128.0 * q * l * l, q * l * l);

    // The same with a release in the member instead of the support.
    let mut released = ends(FIXED, FIXED);
    released.members[0].releases[1][4] = true;
    let t = solved(&released, &[load]);
    (0..12).for_each(|k| close(t.end_forces(0)[0][k], s.end_forces(0)[0][k], q * l));
}

#[test]
fn partial_triangular_and_point_loads_on_a_fixed_beam() {
    // Roark, Formulas for Stress and Strain, table 8.1: triangle 0..q over L gives q L^2/30 and q L^2/20, 3/20 and 7/20 q L.
    let (l, q) = (3.0, 1000.0);
    let model = frame(vec![[0.0; 3], [l, 0.0, 0.0]], vec![member(0, 1)], vec![(0, FIXED), (1, FIXED)]);
    let triangle = Distribution::Linear { q1: [0.0; 3], q2: [0.0, -q, 0.0], x1: 0.0, x2: l };
    let point = Distribution::Point { p: [0.0, -q, 0.0], x: 1.0 };
    let whole = Distribution::Uniform { q: [0.0, -q, 0.0] };
    let half = |x1, x2| Distribution::Linear { q1: [0.0, -q, 0.0], q2: [0.0, -q, 0.0], x1, x2 };
    let mut halves = span(0, Axes::Local, half(0.0, 1.1));
    halves.members.extend(span(0, Axes::Local, half(1.1, l)).members);
    let cases = [triangle, point, whole].map(|d| span(0, Axes::Local, d));
    let s = solved(&model, &[cases[0].clone(), cases[1].clone(), cases[2].clone(), halves]);
    let f = s.end_forces(0)[0];
    close(f[1], 0.15 * q * l, q * l);
    close(f[7], 0.35 * q * l, q * l);
    close(f[5], q * l * l / 30.0, q * l * l);
    close(f[11], -q * l * l / 20.0, q * l * l);
    let f = s.end_forces(1)[0]; // P a b^2 / L^2, P a^2 b / L^2
    close(f[5], q * 1.0 * 4.0 / 9.0, q);
    close(f[11], -q * 1.0 * 2.0 / 9.0, q);
    (0..12).for_each(|k| close(s.end_forces(2)[0][k], s.end_forces(3)[0][k], q * l));
    close(member_forces(&s, 1, 0, 1.0)[5], -(q * 4.0 / 9.0) + f[1], q);
    for case in 0..4 {
        let end = member_forces(&s, case, 0, l);
        let f = s.end_forces(case)[0];
        (0..6).for_each(|k| close(end[k], f[6 + k], q * l));
    }
}

#[test]
fn portal_frame_with_pinned_feet() {
    // Kleinlogel, Rigid Frame Formulas, frame 1: k = (I2/I1)(h/l), N = 2k + 3; uniform q on the beam: M_B = -q l^2/(4N).
    // Axial stiffness is raised until it does not matter.
    let (h, l, q) = (3.0, 5.0, 2000.0);
    let mut foot = [true; 6];
    foot[4] = false;
    let nodes = vec![[0.0; 3], [0.0, 0.0, h], [l, 0.0, h], [l, 0.0, 0.0]];
    let mut model = frame(nodes, vec![member(0, 1), member(1, 2), member(2, 3)], vec![(0, foot), (3, foot)]);
    model.sections = vec![Section { a: 1e4, iy: 5e-6, iz: 5e-6, ..SECTION }];
    let s = solved(&model, &[span(1, Axes::Global, Distribution::Uniform { q: [0.0, 0.0, -q] })]);
    let expected = q * l * l / (4.0 * (2.0 * h / l + 3.0));
    close(s.end_forces(0)[1][4].abs(), expected, expected * 10.0);
    close(s.reactions(0)[0][0], expected / h, expected * 10.0);
    close(s.reactions(0)[0][2] + s.reactions(0)[1][2], q * l, q * l);
}

#[test]
fn bent_cantilever_in_space_bends_and_twists() {
    // L in plan, load P at the tip: P b^3/(3EI) + P a^3/(3EI) + (P b) a/(GJ) b.
    let (a, b, p) = (2.0, 1.5, 700.0);
    let nodes = vec![[0.0; 3], [a, 0.0, 0.0], [a, b, 0.0]];
    let model = frame(nodes, vec![member(0, 1), member(1, 2)], vec![(0, FIXED)]);
    let s = solved(&model, &[nodal(2, [0.0, 0.0, -p, 0.0, 0.0, 0.0])]);
    let (ei, gj) = (E * 3e-6, G * 4e-6);
    let expected = -(p * b.powi(3) / (3.0 * ei) + p * a.powi(3) / (3.0 * ei) + p * b * b * a / gj);
    close(s.displacements(0)[2][2], expected, expected);
    close(s.end_forces(0)[0][3].abs(), p * b, p * b);
}

/// A rotation about a skew axis.
fn turned(p: [f64; 3]) -> [f64; 3] {
    let (c, s, k) = (0.8f64.cos(), 0.8f64.sin(), [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0]);
    let dot: f64 = (0..3).map(|d| k[d] * p[d]).sum();
    let cross = [k[1] * p[2] - k[2] * p[1], k[2] * p[0] - k[0] * p[2], k[0] * p[1] - k[1] * p[0]];
    std::array::from_fn(|d| p[d] * c + cross[d] * s + k[d] * dot * (1.0 - c))
}

fn both_turned(v: [f64; 6]) -> [f64; 6] {
    let (a, b) = (turned([v[0], v[1], v[2]]), turned([v[3], v[4], v[5]]));
    [a[0], a[1], a[2], b[0], b[1], b[2]]
}

/// Pseudo-random numbers in 0..1.
struct Lcg(u64);
impl Lcg {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Two braced bays, two storeys, hinged diagonals, random loads.
fn random_frame(seed: u64) -> (Model, Vec<LoadCase>) {
    let mut r = Lcg(seed);
    let mut nodes = Vec::new();
    for z in 0..3 {
        for y in 0..2 {
            for x in 0..3 {
                let p = [x as f64 * 2.7, y as f64 * 3.6, z as f64 * 2.9];
                nodes.push(p.map(|v| v + 0.3 * r.next()));
            }
        }
    }
    let mut members = Vec::new();
    for n in 0..18 {
        let (x, y, z) = (n % 3, n / 3 % 2, n / 6);
        if x < 2 && z > 0 {
            members.push(member(n, n + 1));
        }
        if y == 0 && z > 0 {
            members.push(member(n, n + 3));
        }
        if z < 2 {
            members.push(member(n, n + 6));
            if x < 2 {
                let mut brace = member(n, n + 7);
                brace.releases = [PIN, PIN];
                brace.roll = 0.4;
                members.push(brace);
            }
        }
    }
    let supports = (0..6).map(|n| (n, [true, true, true, n == 0, n == 0, n == 0])).collect();
    let mut model = frame(nodes, members, supports);
    for (k, m) in model.members.iter_mut().enumerate() {
        m.reference = Some([r.next(), r.next() + 0.2, 3.0]);
        m.section = k % 2;
    }
    model.sections.push(Section { a: 1e-3, iy: 1e-6, iz: 2e-6, j: 5e-7, ..SECTION });
    let mut v = |s: f64| -> [f64; 3] { std::array::from_fn(|_| s * (r.next() - 0.5)) };
    let cases = (0..3)
        .map(|c| LoadCase {
            gravity: v(20.0),
            nodal: (6..18)
                .map(|node| NodalLoad { node, force: [v(1e4), v(1e3)].concat().try_into().unwrap() })
                .collect(),
            members: (0..model.members.len())
                .map(|member| MemberLoad {
                    member,
                    axes: if c == 0 { Axes::Local } else { Axes::Global },
                    distribution: match member % 3 {
                        0 => Distribution::Uniform { q: v(2e3) },
                        1 => Distribution::Point { p: v(2e3), x: 0.7 },
                        _ => Distribution::Linear { q1: v(2e3), q2: v(2e3), x1: 0.3, x2: 1.9 },
                    },
                })
                .collect(),
            ..Default::default()
        })
        .collect();
    (model, cases)
}

#[test]
fn stiffness_is_symmetric_with_six_rigid_motions() {
    for seed in 0..20 {
        let (model, _) = random_frame(seed);
        for m in &model.members {
            let ends = m.nodes.map(|n| model.nodes[n]);
            let k = member_stiffness(m, ends, &model.materials[0], &model.sections[m.section], false).unwrap();
            let top = k.iter().flatten().fold(0.0f64, |a, v| a.max(v.abs()));
            (0..144).for_each(|i| assert!((k[i / 12][i % 12] - k[i % 12][i / 12]).abs() <= 1e-14 * top));
            for d in 0..6 {
                let mut u = [0.0; 12];
                for (e, p) in ends.iter().enumerate() {
                    let mut w = [0.0; 3];
                    if d < 3 {
                        u[6 * e + d] = 1.0;
                    } else {
                        w[d - 3] = 1.0;
                        u[6 * e + d] = 1.0;
                        let c = [w[1] * p[2] - w[2] * p[1], w[2] * p[0] - w[0] * p[2], w[0] * p[1] - w[1] * p[0]];
                        u[6 * e..6 * e + 3].copy_from_slice(&c);
                    }
                }
                for row in &k {
                    let f: f64 = row.iter().zip(&u).map(|(a, b)| a * b).sum();
                    assert!(f.abs() <= 1e-13 * top * 10.0);
                }
            }
        }
    }
}

#[test]
fn reactions_balance_all_loads() {
    let (model, cases) = random_frame(7);
    let s = solved(&model, &cases);
    for (c, case) in cases.iter().enumerate() {
        let (mut sum, mut size) = ([0.0; 3], 0.0f64);
        let mut add = |f: [f64; 3]| {
            (0..3).for_each(|d| {
                sum[d] += f[d];
                size += f[d].abs()
            })
        };
        s.reactions(c).iter().for_each(|r| add([r[0], r[1], r[2]]));
        case.nodal.iter().for_each(|l| add([l.force[0], l.force[1], l.force[2]]));
        for (m, member) in model.members.iter().enumerate() {
            let mass = 7850.0 * model.sections[member.section].a * s.length(m);
            add(case.gravity.map(|g| g * mass));
        }
        for l in &case.members {
            let total: [f64; 3] = match l.distribution {
                Distribution::Uniform { q } => q.map(|q| q * s.length(l.member)),
                Distribution::Point { p, .. } => p,
                Distribution::Linear { q1, q2, x1, x2 } => std::array::from_fn(|d| 0.5 * (q1[d] + q2[d]) * (x2 - x1)),
            };
            let a = s.axes(l.member);
            add(match l.axes {
                Axes::Global => total,
                Axes::Local => std::array::from_fn(|d| (0..3).map(|k| a[k][d] * total[k]).sum()),
            });
        }
        assert!(sum.iter().all(|v| v.abs() < 1e-9 * size), "{sum:?} of {size}");
    }
}

#[test]
fn superposition_and_betti() {
    let (model, cases) = random_frame(3);
    let nodal: Vec<LoadCase> =
        cases.iter().take(2).map(|c| LoadCase { nodal: c.nodal.clone(), ..Default::default() }).collect();
    let s = solved(&model, &nodal);
    let work = |a: usize, b: usize| -> f64 {
        let u = s.displacements(b);
        nodal[a].nodal.iter().map(|l| (0..6).map(|d| l.force[d] * u[l.node][d]).sum::<f64>()).sum()
    };
    close(work(0, 1), work(1, 0), work(0, 0));

    let mut sum = cases[1].clone();
    sum.gravity = std::array::from_fn(|d| cases[1].gravity[d] + cases[2].gravity[d]);
    sum.nodal.extend(cases[2].nodal.iter().copied());
    sum.members.extend(cases[2].members.iter().copied());
    let s = solved(&model, &[cases[1].clone(), cases[2].clone(), sum]);
    for m in 0..model.members.len() {
        let (a, b) = (Line::new(&s, &[1.0, 1.0], m), Line::new(&s, &[0.0, 0.0, 1.0], m));
        for x in [0.0, 0.4, 1.3, 2.0] {
            (0..6).for_each(|k| close(a.forces(x)[k], b.forces(x)[k], 1e5));
        }
    }
}

#[test]
fn turning_the_world_turns_the_answer() {
    let (mut model, mut cases) = random_frame(11);
    model
        .supports
        .iter_mut()
        .for_each(|s| s.fix = if s.node == 0 { FIXED } else { [true, true, true, false, false, false] });
    let before = solved(&model, &cases);
    model.nodes.iter_mut().for_each(|p| *p = turned(*p));
    model.members.iter_mut().for_each(|m| m.reference = m.reference.map(turned));
    for c in &mut cases {
        c.gravity = turned(c.gravity);
        c.nodal.iter_mut().for_each(|l| l.force = both_turned(l.force));
        for l in c.members.iter_mut().filter(|l| l.axes == Axes::Global) {
            l.distribution = match l.distribution {
                Distribution::Uniform { q } => Distribution::Uniform { q: turned(q) },
                Distribution::Point { p, x } => Distribution::Point { p: turned(p), x },
                Distribution::Linear { q1, q2, x1, x2 } => {
                    Distribution::Linear { q1: turned(q1), q2: turned(q2), x1, x2 }
                }
            };
        }
    }
    let after = solved(&model, &cases);
    for c in 0..cases.len() {
        for (a, b) in before.end_forces(c).iter().zip(after.end_forces(c)) {
            (0..12).for_each(|k| close(b[k], a[k], 1e5));
        }
        for (a, b) in before.displacements(c).iter().zip(after.displacements(c)) {
            let a = both_turned(*a);
            (0..6).for_each(|k| close(b[k], a[k], 1.0));
        }
    }
}

#[test]
fn a_member_cut_in_two_changes_nothing() {
    let one = frame(
        vec![[0.0; 3], [3.0, 1.0, 2.0]],
        vec![member(0, 1)],
        vec![(0, FIXED), (1, [true, true, true, false, false, false])],
    );
    let mut two = one.clone();
    two.nodes.push([1.2, 0.4, 0.8]);
    two.members = vec![member(0, 2), member(2, 1)];
    let load = Distribution::Uniform { q: [100.0, -300.0, -800.0] };
    let mut both = span(0, Axes::Global, load);
    let s = solved(&one, std::slice::from_ref(&both));
    both.members.extend(span(1, Axes::Global, load).members);
    let t = solved(&two, &[both]);
    (0..6).for_each(|d| close(t.reactions(0)[0][d], s.reactions(0)[0][d], 5e3));
    let x = s.length(0) * 0.7;
    let (a, b) = (member_forces(&s, 0, 0, x), member_forces(&t, 0, 1, x - t.length(0)));
    (0..6).for_each(|k| close(a[k], b[k], 5e3));
}

/// Displacements of a dense solve of the same stiffness.
fn dense(model: &Model, case: &LoadCase) -> Vec<f64> {
    let n = 6 * model.nodes.len();
    let mut k = nalgebra::DMatrix::<f64>::zeros(n, n);
    for m in &model.members {
        let ends = m.nodes.map(|n| model.nodes[n]);
        let ke = member_stiffness(m, ends, &model.materials[0], &model.sections[m.section], false).unwrap();
        let at = |d: usize| 6 * m.nodes[d / 6] + d % 6;
        (0..144).for_each(|e| k[(at(e / 12), at(e % 12))] += ke[e / 12][e % 12]);
    }
    let mut f = nalgebra::DVector::<f64>::zeros(n);
    case.nodal.iter().for_each(|l| (0..6).for_each(|d| f[6 * l.node + d] += l.force[d]));
    for s in &model.supports {
        for d in (0..6).filter(|&d| s.fix[d]) {
            let at = 6 * s.node + d;
            k.row_mut(at).fill(0.0);
            k.column_mut(at).fill(0.0);
            k[(at, at)] = 1.0;
            f[at] = 0.0;
        }
    }
    k.lu().solve(&f).unwrap().as_slice().to_vec()
}

#[test]
fn sparse_agrees_with_dense() {
    let mut solver = Solver::new();
    for seed in 20..30 {
        let (model, cases) = random_frame(seed);
        let case = LoadCase { nodal: cases[0].nodal.clone(), ..Default::default() };
        let expected = dense(&model, &case);
        let s = solver.solve(&model, &[case]).unwrap();
        let top = expected.iter().fold(0.0f64, |a, v| a.max(v.abs()));
        for (n, u) in s.displacements(0).iter().enumerate() {
            (0..6).for_each(|d| close(u[d], expected[6 * n + d], top));
        }
    }
}

#[test]
fn a_used_solver_answers_like_a_new_one() {
    let mut solver = Solver::new();
    let mut kept = Solution::default();
    for seed in 0..5 {
        let (model, cases) = random_frame(seed);
        solver.solve_into(&model, &cases, &mut kept).unwrap();
        assert_eq!(kept, solve(&model, &cases).unwrap());
    }
}

#[test]
fn settlement_of_a_propped_beam() {
    // 3 EI d / L^3 at the prop.
    let mut prop = [true; 6];
    prop[4] = false;
    let model = frame(vec![[0.0; 3], [2.0, 0.0, 0.0]], vec![member(0, 1)], vec![(0, FIXED), (1, prop)]);
    let case = LoadCase { settlements: vec![Settlement { node: 1, dof: 2, value: -0.01 }], ..Default::default() };
    let s = solved(&model, &[case]);
    let expected = -3.0 * E * 3e-6 * 0.01 / 8.0;
    close(s.reactions(0)[1][2], expected, expected);
    close(s.displacements(0)[1][2], -0.01, 0.01);
}

/// A square of pinned members between two pinned feet, out of plane held, with or without a diagonal.
fn square(brace: bool) -> Model {
    let nodes = vec![[0.0; 3], [0.0, 0.0, 2.0], [2.0, 0.0, 2.0], [2.0, 0.0, 0.0]];
    let mut members = vec![member(0, 1), member(1, 2), member(2, 3)];
    if brace {
        members.push(member(0, 2));
    }
    members.iter_mut().for_each(|m| m.releases = [PIN, PIN]);
    let plane = [false, true, false, false, false, false];
    frame(nodes, members, vec![(0, FIXED), (1, plane), (2, plane), (3, FIXED)])
}

fn unstable(model: &Model, cases: &[LoadCase]) -> Mechanism {
    let s = solve(model, cases).unwrap();
    assert!((0..cases.len()).all(|c| s.displacements(c).iter().flatten().all(|v| *v == 0.0)));
    match s.status {
        Status::Unstable(m) => m,
        other => panic!("{other:?}"),
    }
}

#[test]
fn pinned_square_sways_and_a_brace_mends_it() {
    let push = [nodal(1, [1e3, 0.0, 0.0, 0.0, 0.0, 0.0])];
    let m = unstable(&square(false), &push);
    assert_eq!(m.cause, Cause::Sway);
    let mut nodes: Vec<usize> = m.motions.iter().map(|m| m.node).collect();
    nodes.sort_unstable();
    assert_eq!(nodes, [1, 2]);
    assert!(m.motions.iter().all(|m| m.direction[0].abs() > 0.99 && m.direction[2].abs() < 1e-6), "{m}");
    let s = solved(&square(true), &push);
    close(s.end_forces(0)[3][0], -1e3 * 2f64.sqrt(), 1e3);
}

#[test]
fn missing_support_loose_part_and_hinge_chain_are_named() {
    let beam = |fix| frame(vec![[0.0; 3], [2.0, 0.0, 0.0]], vec![member(0, 1)], vec![(0, fix)]);
    let load = [nodal(1, [0.0, 0.0, -1.0, 0.0, 0.0, 0.0])];
    let mut hinge = [true; 6];
    hinge[4] = false;
    let m = unstable(&beam(hinge), &load);
    assert_eq!((m.cause, m.motions[0].node), (Cause::Sway, 1));
    assert!((m.motions[0].direction[2].abs() - 1.0).abs() < 1e-9);
    solved(&beam(FIXED), &load);

    let mut loose = beam(FIXED);
    loose.nodes.extend([[0.0, 5.0, 0.0], [1.0, 5.0, 0.0]]);
    loose.members.push(member(2, 3));
    let m = unstable(&loose, &load);
    assert_eq!(m.cause, Cause::Loose);
    assert!(m.motions.iter().all(|m| m.node >= 2));
    loose.supports.push(Support { node: 2, fix: FIXED });
    solved(&loose, &load);

    let mut chain = frame(
        vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]],
        vec![member(0, 1), member(1, 2), member(2, 3)],
        vec![(0, FIXED), (3, FIXED)],
    );
    chain.members[1].releases = [PIN, PIN];
    solved(&chain, &load);
    chain.members[0].releases[0] = PIN;
    let m = unstable(&chain, &load);
    assert_eq!((m.cause, m.motions[0].node), (Cause::Sway, 1));
}

#[test]
fn idle_rotations_are_left_out_unless_loaded() {
    // A pinned tripod: the top turns freely, torsion held or not.
    let nodes = vec![[0.0, 0.0, 2.0], [1.0, 0.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, -1.0, 0.0]];
    let mut model = frame(nodes, vec![member(0, 1), member(0, 2), member(0, 3)], (1..4).map(|n| (n, FIXED)).collect());
    let all = [false, false, false, true, true, true];
    model.members.iter_mut().for_each(|m| m.releases = [all, all]);
    let force = nodal(0, [10.0, 20.0, -900.0, 0.0, 0.0, 0.0]);
    let s = solved(&model, std::slice::from_ref(&force));
    assert_eq!(s.idle.iter().filter(|i| i.node == 0).count(), 3);
    let m = unstable(&model, &[nodal(0, [0.0, 0.0, 0.0, 5.0, 0.0, 0.0])]);
    assert_eq!(m.cause, Cause::LoadOnIdle { case: 0 });
    // Held torsion at the top, feet free to turn: the tripod's parts spin together, and that carries no load.
    model.members.iter_mut().for_each(|m| m.releases = [PIN, PIN]);
    model.supports.iter_mut().for_each(|s| s.fix = [true, true, true, false, false, false]);
    let t = solved(&model, &[force]);
    (0..3).for_each(|m| close(t.end_forces(0)[m][0], s.end_forces(0)[m][0], 900.0));
    // A beam whose two ends slide along it cannot carry its own weight along it.
    let mut slide = frame(vec![[0.0; 3], [0.0, 0.0, 2.0]], vec![member(0, 1)], vec![(0, FIXED), (1, FIXED)]);
    slide.members[0].releases = [[true, false, false, false, false, false]; 2];
    let weight = LoadCase { gravity: [0.0, 0.0, -9.81], ..Default::default() };
    assert_eq!(unstable(&slide, &[weight]).cause, Cause::LoadOnReleasedMember { case: 0, member: 0 });
}

#[test]
fn a_thread_of_a_brace_is_nearly_singular() {
    let push = [nodal(1, [1e-6, 0.0, 0.0, 0.0, 0.0, 0.0])];
    let mut model = square(true);
    model.sections.push(Section { a: 2e-3 * 3e-13, iy: 0.0, iz: 0.0, j: 0.0, ..SECTION });
    model.members[3].section = 1;
    match solve(&model, &push).unwrap().status {
        Status::NearlySingular { condition, weakest, .. } => {
            assert!(condition > 1e11);
            assert!(weakest.motions.iter().any(|m| m.node == 1));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_slender_chain_of_a_hundred_members_is_sound() {
    let nodes = (0..=100).map(|k| [0.1 * k as f64, 0.0, 0.0]).collect();
    let model = frame(nodes, (0..100).map(|k| member(k, k + 1)).collect(), vec![(0, FIXED)]);
    let s = solved(&model, &[nodal(100, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0])]);
    let expected = 1000.0 / (3.0 * E * 3e-6);
    assert!((s.displacements(0)[100][2] / expected - 1.0).abs() < 1e-7);
}

#[test]
fn bad_input_is_refused_with_its_place() {
    let (good, cases) = random_frame(1);
    let says = |change: &dyn Fn(&mut Model, &mut Vec<LoadCase>), text: &str| {
        let (mut m, mut c) = (good.clone(), cases.clone());
        change(&mut m, &mut c);
        let e = solve(&m, &c).unwrap_err().to_string();
        assert!(e.contains(text), "{e}");
    };
    says(&|m, _| m.members[3].nodes[1] = 99, "member 3: node 99");
    says(&|m, _| m.nodes[2][0] = f64::NAN, "node 2");
    says(&|m, _| m.sections[0].a = 0.0, "section 0: A is 0");
    says(&|m, _| m.members[0].nodes = [4, 4], "member 0: nodes 4 and 4");
    says(&|m, _| m.shear = true, "Asy");
    says(&|m, _| m.supports.push(m.supports[0]), "already has a support");
    says(&|_, c| c[0].settlements.push(Settlement { node: 9, dof: 1, value: 0.1 }), "which no support holds");
    says(&|_, c| c[1].nodal[0].node = 70, "node 70");
}

#[test]
fn a_long_chain_on_one_hinge_is_a_mechanism() {
    let mut hinge = [true; 6];
    hinge[4] = false;
    for n in [10, 100, 1000] {
        let nodes = (0..=n).map(|k| [0.1 * k as f64, 0.02 * (k % 3) as f64, 0.0]).collect();
        let model = frame(nodes, (0..n).map(|k| member(k, k + 1)).collect(), vec![(0, hinge)]);
        let s = solve(&model, &[nodal(n, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0])]).unwrap();
        assert!(!s.status.is_solved(), "{n}: {:?}", s.status);
        if n <= 100 {
            assert!(matches!(s.status, Status::Unstable(_)), "{n}: {:?}", s.status);
        }
    }
}
