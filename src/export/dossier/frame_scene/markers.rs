//! Supports as pyramids, loads as arrows.

use glam::DVec3;

use crate::export::Part;
use crate::structure::DrawnLoads;

/// Side of a pyramid's base and its height, m.
const PYRAMID_M: [f64; 2] = [0.20, 0.17];

/// Length of the longest arrow of a case, m.
const LONGEST_M: f64 = 1.4;

/// Pyramids whose tips touch the supports, in one part.
pub fn pyramids(material: usize, tips: impl Iterator<Item = [f64; 3]>) -> Part {
    let mut part = Part::new("supports", material);
    let [side, height] = PYRAMID_M;
    for tip in tips {
        let corner = |x: f64, y: f64| [tip[0] + 0.5 * side * x, tip[1] + 0.5 * side * y, tip[2] - height];
        cone(&mut part, tip, &[corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)]);
    }
    part
}

/// A cone over a base that is counter-clockwise as seen from its tip.
fn cone(part: &mut Part, tip: [f64; 3], base: &[[f64; 3]]) {
    for (n, a) in base.iter().enumerate() {
        part.polygon(&[*a, base[(n + 1) % base.len()], tip]);
    }
    let under: Vec<[f64; 3]> = base.iter().rev().copied().collect();
    part.polygon(&under);
}

/// The arrows of a case in one part, one a member, as long as its share of the largest, and how many metres stand for a kilonewton.
/// What pushes the house touches the member with its head, what pulls outwards with its tail.
pub fn arrows(loads: &DrawnLoads, material: usize, centre: [f64; 3]) -> (Part, f64) {
    let mut part = Part::new(&format!("loads: {}", loads.case), material);
    let mut sums: Vec<(usize, DVec3, DVec3)> = Vec::new();
    for &(member, at, force) in &loads.arrows {
        let (at, force) = (DVec3::from(at), DVec3::from(force));
        match sums.last_mut().filter(|s| s.0 == member) {
            // Weighted by force: the arrow stands where the resultant acts.
            Some(s) => *s = (member, s.1 + at * force.length(), s.2 + force),
            None => sums.push((member, at * force.length(), force)),
        }
    }
    let weight = |member: usize| -> f64 {
        let own = loads.arrows.iter().filter(|a| a.0 == member);
        own.map(|a| DVec3::from(a.2).length()).sum()
    };
    let longest = sums.iter().map(|s| s.2.length()).fold(0.0, f64::max);
    let scale = if longest > 0.0 { LONGEST_M / longest } else { 0.0 };
    for (member, moment, force) in sums {
        let length = force.length() * scale;
        if length < 0.03 {
            continue;
        }
        let (at, along) = (moment / weight(member), force.normalize());
        let outward = along.dot(DVec3::from_array([at.x - centre[0], at.y - centre[1], 0.0])) > 1e-6 || along.z > 0.3;
        let tip = if outward { at + along * length } else { at };
        arrow(&mut part, tip, along, length);
    }
    (part, scale * 1e3)
}

/// Three-sided shaft and head that end at `tip`.
fn arrow(part: &mut Part, tip: DVec3, along: DVec3, length: f64) {
    let side = along.any_orthonormal_vector();
    let other = along.cross(side);
    let ring = |at: DVec3, radius: f64| -> Vec<[f64; 3]> {
        let turn = |n: i32| std::f64::consts::TAU / 3.0 * f64::from(n);
        (0..3).map(|n| (at + radius * (side * turn(n).cos() + other * turn(n).sin())).to_array()).collect()
    };
    let head = (0.4 * length).min(0.24);
    let neck = tip - along * head;
    cone(part, tip.to_array(), &ring(neck, 0.35 * head));
    let (from, to) = (ring(tip - along * length, 0.12 * head), ring(neck, 0.12 * head));
    for n in 0..3 {
        let m = (n + 1) % 3;
        part.polygon(&[from[n], from[m], to[m], to[n]]);
    }
}
