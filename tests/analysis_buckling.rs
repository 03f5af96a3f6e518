//! First buckling loads against Euler's columns and the sway of portals.

#![allow(clippy::unwrap_used)]

use houscaper::analysis::*;
use std::f64::consts::PI;

const E: f64 = 210e9;
const I: f64 = 3e-6;
const FREE: [bool; 6] = [false; 6];

fn member(i: usize, j: usize) -> Member {
    Member { nodes: [i, j], material: 0, section: 0, reference: None, roll: 0.0, releases: [FREE; 2] }
}

/// Members of E I about both axes but for the weaker `iz`; stiff along their axis.
fn frame(nodes: Vec<[f64; 3]>, members: Vec<Member>, supports: &[(usize, [bool; 6])]) -> Model {
    Model {
        nodes,
        materials: vec![Material { e: E, g: 81e9, rho: 0.0 }],
        sections: vec![Section { a: 10.0, iy: I, iz: 4.0 * I, j: 4.0 * I, asy: None, asz: None }],
        members,
        supports: supports.iter().map(|&(node, fix)| Support { node, fix }).collect(),
        shear: false,
    }
}

fn push(nodes: &[usize], force: [f64; 3]) -> LoadCase {
    let load = |&node: &usize| NodalLoad { node, force: [force[0], force[1], force[2], 0.0, 0.0, 0.0] };
    LoadCase { nodal: nodes.iter().map(load).collect(), ..Default::default() }
}

fn buckles(model: &Model, cases: &[LoadCase], factors: &[f64], pieces: usize) -> Buckling {
    match buckling_factor(model, cases, factors, pieces).unwrap() {
        BucklingAnswer::Buckles(found) => found,
        other => panic!("{other:?}"),
    }
}

#[test]
fn eulers_columns_by_their_ends() {
    let l = 3.5;
    let euler = PI * PI * E * I / (l * l);
    // Pins are releases of the member, so its own ends must follow them when it is cut; the flagpole stands askew.
    let pin = [false, false, false, false, true, true];
    let (askew, upright) = ([2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0], [0.0, 0.0, 1.0]);
    let guide = Some([true, true, false, true, true, true]);
    // Fixed and pinned: the least root of tan(k l) = k l, 4.493409.
    let fixed_pinned = (4.493409457909064f64 / PI).powi(2);
    for (foot, head, support, along, times) in [
        (FREE, FREE, None, askew, 0.25),
        (pin, pin, guide, upright, 1.0),
        (FREE, pin, guide, upright, fixed_pinned),
        (pin, FREE, guide, upright, fixed_pinned),
        (FREE, FREE, guide, upright, 4.0),
    ] {
        let mut m = member(0, 1);
        m.releases = [foot, head];
        let supports: Vec<_> = [(0, [true; 6])].into_iter().chain(support.map(|s| (1, s))).collect();
        let model = frame(vec![[0.0; 3], along.map(|a| a * l)], vec![m], &supports);
        let load = push(&[1], along.map(|a| -1e3 * a));
        for (pieces, share) in [(4, 1e-2), (8, 1e-3)] {
            let found = buckles(&model, std::slice::from_ref(&load), &[1.0], pieces);
            let off = found.factor * 1e3 / (times * euler) - 1.0;
            // Elements of cubic shape are too stiff, never too soft.
            assert!((-1e-6..share).contains(&off), "{times}: {off:.2e} with {pieces} pieces");
            assert_eq!(found.member, 0);
        }
    }
}

#[test]
fn a_column_fixed_at_both_ends_takes_four_times_euler() {
    let (l, mut slide) = (3.5, [true; 6]);
    slide[2] = false;
    let model = frame(vec![[0.0; 3], [0.0, 0.0, l]], vec![member(0, 1)], &[(0, [true; 6]), (1, slide)]);
    let load = push(&[1], [0.0, 0.0, -1e3]);
    for (pieces, share) in [(4, 1e-2), (8, 1e-3)] {
        let found = buckles(&model, std::slice::from_ref(&load), &[1.0], pieces);
        let off = found.factor * 1e3 / (4.0 * PI * PI * E * I / (l * l)) - 1.0;
        assert!((-1e-6..share).contains(&off), "{off:.2e} with {pieces} pieces");
        assert!((found.x - 0.5 * l).abs() < 1e-9 && found.nodes.iter().flatten().all(|v| v.abs() < 1e-9));
        // Bending of least stiffness is in the local x-z plane; z of an upward member is -X.
        assert!((found.direction[0].abs() - 1.0).abs() < 1e-6, "{:?}", found.direction);
    }
}

#[test]
fn a_hanging_weight_never_buckles_and_a_standing_one_does() {
    // Column under its own weight, clamped at the foot: q L^3 / (E I) = 9/4 j^2 with j = 1.86635 the first zero of the Bessel
    // function of order -1/3 (Greenhill 1881; Timoshenko and Gere, Theory of Elastic Stability, on distributed axial loads).
    let l = 6.0;
    let model = frame(vec![[0.0; 3], [0.0, 0.0, l]], vec![member(0, 1)], &[(0, [true; 6])]);
    let line = |q: f64| LoadCase {
        members: vec![MemberLoad {
            member: 0,
            axes: Axes::Global,
            distribution: Distribution::Uniform { q: [0.0, 0.0, q] },
        }],
        ..Default::default()
    };
    let cases = [line(-100.0), line(100.0)];
    let found = buckles(&model, &cases, &[1.0], 8);
    let expected = 7.8373 * E * I / (l * l * l) / 100.0;
    // The force is taken as constant on each of eight pieces: 0.6 %.
    assert!((found.factor / expected - 1.0).abs() < 1e-2, "{} of {expected}", found.factor);
    assert_eq!(buckling_factor(&model, &cases, &[0.0, 1.0], 8).unwrap(), BucklingAnswer::Never);
    assert_eq!(buckling_factor(&model, &cases, &[1.0, 1.0], 8).unwrap(), BucklingAnswer::Never);
    // Three times the load, a third of the factor.
    let third = buckles(&model, &cases, &[4.0, 1.0], 8);
    assert!((third.factor * 3.0 / found.factor - 1.0).abs() < 1e-9);
}

/// A portal of equal columns and beam in the x-z plane; out of it the nodes are held.
fn portal(h: f64, l: f64, foot: [bool; 6]) -> Model {
    let nodes = vec![[0.0; 3], [0.0, 0.0, h], [l, 0.0, h], [l, 0.0, 0.0]];
    let plane = [false, true, false, true, false, true];
    let mut model =
        frame(nodes, vec![member(0, 1), member(1, 2), member(3, 2)], &[(0, foot), (1, plane), (2, plane), (3, foot)]);
    // In the plane bends Iy: the other is out of the way.
    model.sections[0].iz = 1e3 * I;
    model
}

#[test]
fn portals_sway_at_the_roots_of_their_equations() {
    // Slope deflection with stability functions: the beam bends in double curvature and holds a column head with 6 E I / l, so
    // pinned feet k h tan(k h) = 6 h / l, clamped feet k h / tan(k h) = -6 h / l, with k^2 = P / (E I).
    let (h, l) = (3.0, 4.0);
    let root = |g: &dyn Fn(f64) -> f64, mut a: f64, mut b: f64| {
        for _ in 0..200 {
            let m = 0.5 * (a + b);
            (a, b) = if (g(a) > 0.0) == (g(m) > 0.0) { (m, b) } else { (a, m) };
        }
        a
    };
    let pinned = root(&|x| x * x.sin() - 6.0 * h / l * x.cos(), 0.1, PI / 2.0);
    let clamped = root(&|x| x * x.cos() + 6.0 * h / l * x.sin(), PI / 2.0, PI - 0.01);
    let mut foot = [true; 6];
    foot[4] = false;
    for (foot, kh) in [(foot, pinned), ([true; 6], clamped)] {
        let found = buckles(&portal(h, l, foot), &[push(&[1, 2], [0.0, 0.0, -1e3])], &[1.0], 4);
        let expected = kh * kh * E * I / (h * h) / 1e3;
        assert!((found.factor / expected - 1.0).abs() < 1e-3, "{} of {expected}", found.factor);
        assert!(found.nodes[1][0].abs() > 0.5 && (found.nodes[1][0] - found.nodes[2][0]).abs() < 1e-3, "it sways");
    }
    // Trahair, Bradford, Nethercot and Gardner, The Behaviour and Design of Steel Structures to EC3, 4th ed., eq. 8.12a: pinned
    // feet, antisymmetric, N = 3 / (10 R + 12) pi^2 E I / h^2 with R = (Ic / h) / (Ir / Lr), Lr half the span; an approximation.
    let r = (I / h) / (I / (0.5 * l));
    let approximate = 3.0 / (10.0 * r + 12.0) * PI * PI;
    assert!((approximate / (pinned * pinned) - 1.0).abs() < 0.06, "{approximate} of {}", pinned * pinned);
}

#[test]
fn braces_stop_the_sway_and_mechanisms_have_no_factor() {
    let (h, l) = (3.0, 4.0);
    let mut foot = [true; 6];
    foot[4] = false;
    let mut model = portal(h, l, foot);
    let load = [push(&[1, 2], [0.0, 0.0, -1e3])];
    let free = buckles(&model, &load, &[1.0], 4).factor;
    let mut brace = member(0, 2);
    brace.releases = [[false, false, false, false, true, true]; 2];
    model.members.push(brace);
    let braced = buckles(&model, &load, &[1.0], 4).factor;
    // Between pinned feet and heads the beam holds: more than Euler's column, less than the one clamped at its head.
    let euler = PI * PI * E * I / (h * h) / 1e3;
    assert!(braced > euler && braced < 2.05 * euler && braced > 4.0 * free, "{free} {braced} {euler}");
    model.supports.clear();
    assert_eq!(buckling_factor(&model, &load, &[1.0], 4).unwrap(), BucklingAnswer::Unknown);
    model.members[0].nodes[1] = 9;
    assert!(buckling_factor(&model, &load, &[1.0], 4).is_err());
}
