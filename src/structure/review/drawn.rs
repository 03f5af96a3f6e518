//! Loads as arrows: one resultant an element and case.

use super::super::cases::Case;
use super::super::combine::{LIFTING, PRESSED, WINDS_A_SIDE};
use super::Solved;
use crate::analysis::Distribution;

/// The loads of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnLoads {
    /// The case, characteristic values.
    pub case: String,
    /// Sum over all, N.
    pub sum_n: [f64; 3],
    /// Member, middle of the loaded element in m, and the resultant on the element in N; what is under 1 N is left out.
    pub arrows: Vec<(usize, [f64; 3], [f64; 3])>,
}

/// Permanent, imposed and even snow, and the wind from each side with internal suction and with internal pressure.
pub(super) fn drawn(s: &Solved) -> Vec<DrawnLoads> {
    let [bursts, sucks] = s.loads.cpi;
    let mut list = vec![
        ("permanent".to_owned(), s.factors(1.0, 0.0, (0, 0.0), None)),
        ("imposed".to_owned(), s.factors(0.0, 1.0, (0, 0.0), None)),
        ("snow".to_owned(), s.factors(0.0, 0.0, (0, 1.0), None)),
    ];
    for (side, from) in ["+x", "+y", "-x", "-y"].iter().enumerate() {
        for (kind, words) in
            [(PRESSED, format!("cpi {sucks:+.1}, roofs pressed")), (LIFTING, format!("cpi {bursts:+.1}, roofs sucked"))]
        {
            let wind = Some((WINDS_A_SIDE * side + kind, 1.0));
            list.push((format!("wind from {from}, {words}"), s.factors(0.0, 0.0, (0, 0.0), wind)));
        }
    }
    let own = s.cases.slot(Case::Permanent as usize);
    list.into_iter()
        .map(|(case, factors)| {
            let mut forces = vec![[0.0; 3]; s.frame.elements.len()];
            for (slot, f) in factors.iter().enumerate().filter(|(_, f)| **f != 0.0) {
                for l in &s.lent[slot].members {
                    if let Distribution::Uniform { q } = l.distribution {
                        let length = s.frame.element_length_m(l.member);
                        (0..3).for_each(|a| forces[l.member][a] += f * q[a] * length);
                    }
                }
                if Some(slot) == own {
                    for (e, m) in s.model.members.iter().take(forces.len()).enumerate() {
                        let mass = s.model.materials[m.material].rho * s.model.sections[m.section].a;
                        let weight = mass * s.frame.element_length_m(e);
                        (0..3).for_each(|a| forces[e][a] += f * s.lent[slot].gravity[a] * weight);
                    }
                }
            }
            let sum_n = forces.iter().fold([0.0; 3], |sum, f| [0, 1, 2].map(|a| sum[a] + f[a]));
            let middle = |e: usize| {
                let [a, b] = s.frame.elements[e].nodes.map(|n| s.frame.nodes[n as usize]);
                [0, 1, 2].map(|x| 0.5 * (a[x] + b[x]))
            };
            let arrow = |(e, f): (usize, [f64; 3])| (s.frame.elements[e].member as usize, middle(e), f);
            let seen = |f: &[f64; 3]| f.iter().map(|c| c * c).sum::<f64>() > 1.0;
            let arrows = forces.into_iter().enumerate().filter(|(_, f)| seen(f)).map(arrow).collect();
            DrawnLoads { case, sum_n, arrows }
        })
        .filter(|d| !d.arrows.is_empty())
        .collect()
}
