//! The deformed shape of the frame.

use super::super::combine::{PRESSED, WINDS_A_SIDE, snows};
use super::Solved;
use crate::analysis::displacement_along;

/// Longest piece of an element that is drawn straight, m: a joist of 4 m bends in five pieces.
pub const MAX_PIECE_M: f64 = 0.9;

/// A place on a member.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place {
    /// Undeformed, m.
    pub at_m: [f64; 3],
    /// Where it goes, m: elastic, without creep.
    pub moves_m: [f64; 3],
}

/// The shape under one combination.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Deformed {
    /// The combination in words.
    pub combination: String,
    /// Places along each member, from its start, its nodes and at most [`MAX_PIECE_M`] between; none for soles.
    pub members: Vec<Vec<Place>>,
    /// Largest displacement, m.
    pub largest_m: f64,
    /// The member it is on.
    pub member: usize,
    /// Where, m.
    pub at_m: [f64; 3],
}

const SIDES: [&str; 4] = ["+x", "+y", "-x", "-y"];

/// The shape under the characteristic combination (EN 1990 6.14b) with the largest displacement.
pub(super) fn deformed(s: &Solved) -> Deformed {
    let [p_q, p_s, _] = s.loads.psi0;
    let some = |f: f64, what: &str| if f > 0.0 { format!(" + {f} {what}") } else { String::new() };
    let mut list = vec![(format!("G + Q{}", some(p_s, "S")), s.factors(1.0, 1.0, (0, p_s), None))];
    let arrangements = ["even", "half towards +x or +y", "half towards -x or -y", "drifted"];
    for n in (0..4).filter(|&n| snows(&s.cases)[n]) {
        list.push((format!("G + S ({}){}", arrangements[n], some(p_q, "Q")), s.factors(1.0, p_q, (n, 1.0), None)));
    }
    for (side, from) in SIDES.iter().enumerate() {
        let words = format!("G + W (from {from}, internal suction){}{}", some(p_q, "Q"), some(p_s, "S"));
        list.push((words, s.factors(1.0, p_q, (0, p_s), Some((WINDS_A_SIDE * side + PRESSED, 1.0)))));
    }
    let shapes = list.into_iter().map(|(combination, factors)| shape(s, combination, &factors));
    shapes.fold(Deformed::default(), |kept, next| if next.largest_m > kept.largest_m { next } else { kept })
}

fn shape(s: &Solved, combination: String, factors: &[f64]) -> Deformed {
    let mut out = Deformed { combination, ..Deformed::default() };
    for (m, member) in s.frame.members.iter().enumerate() {
        let mut places = Vec::new();
        for e in member.elements() {
            let nodes = s.frame.elements[e].nodes.map(|n| n as usize);
            let [a, b] = nodes.map(|n| s.frame.nodes[n]);
            let ends = nodes.map(|n| s.displacement(factors, n));
            let pieces = (s.solution.length(e) / MAX_PIECE_M).ceil().max(1.0) as usize;
            // The end of one element is the start of the next.
            for k in usize::from(!places.is_empty())..=pieces {
                let t = k as f64 / pieces as f64;
                places.push(Place {
                    at_m: std::array::from_fn(|x| a[x] + t * (b[x] - a[x])),
                    moves_m: displacement_along(&s.solution, factors, e, ends, t),
                });
            }
        }
        for p in &places {
            let size = p.moves_m.iter().map(|c| c * c).sum::<f64>().sqrt();
            // The first of equals, whatever rounding makes of them.
            if size > out.largest_m * (1.0 + 1e-9) {
                (out.largest_m, out.member, out.at_m) = (size, m, p.at_m);
            }
        }
        out.members.push(places);
    }
    out
}
