//! The house as a whole on its foundation: anchors, overturning, sliding. Supports only push: what pulls needs an anchor.

use super::cases::{Case, CaseLoads, UNITS};
use super::combine::{WINDS, winds};
use super::loads::LoadSettings;
use crate::analysis::Solution;
use crate::frame::HouseFrame;

/// Static equilibrium (EN 1990 EQU, 0.9 G + 1.5 W), worst of all winds under full pressures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stability {
    /// Sum of the anchors' pull, N.
    pub uplift_n: f64,
    /// Largest pull of one anchor, N.
    pub anchor_n: f64,
    /// Overturning moment of 1.5 W over the righting moment of 0.9 G about the leeward edge; above 1 the anchors hold the house.
    pub overturning: f64,
    /// Horizontal force of 1.5 W, N.
    pub sliding_n: f64,
    /// That force over what presses on the foundation then (0.9 G + 1.5 W): friction that would do without anchors; infinite where
    /// nothing presses.
    pub friction: f64,
}

/// Reactions of all supports to 0.9 G + 1.5 W.
pub(super) fn stability(frame: &HouseFrame, loads: &LoadSettings, cases: &CaseLoads, solution: &Solution) -> Stability {
    let mut out = Stability::default();
    let [holds, lifts] = loads.equ;
    let Some(own) = cases.slot(Case::Permanent as usize).map(|slot| solution.reactions(slot)) else { return out };
    let winds = winds(loads);
    let edges = [0, 1].map(|a| {
        let at = |s: &u32| frame.nodes[*s as usize][a];
        frame.supports.iter().map(at).fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)])
    });
    for (n, f) in winds.iter().enumerate().take(WINDS) {
        let side = n / super::combine::WINDS_A_SIDE;
        let axis = side % 2;
        // Wind from +x pushes towards the lower edge.
        let leeward = edges[axis][usize::from(side >= 2)];
        let (mut pull, mut force, mut moment) = (0.0, [0.0; 3], [0.0; 2]);
        for (s, g) in own.iter().enumerate() {
            let mut w = [0.0; 3];
            for c in (Case::Internal as usize..UNITS).filter(|&c| f[c] != 0.0) {
                let Some(slot) = cases.slot(c) else { continue };
                let r = solution.reactions(slot)[s];
                (0..3).for_each(|a| w[a] += f[c] * r[a]);
            }
            let up = -(holds * g[2] + lifts * w[2]);
            pull += f64::max(up, 0.0);
            out.anchor_n = out.anchor_n.max(up);
            let arm = (frame.nodes[frame.supports[s] as usize][axis] - leeward).abs();
            moment[0] += holds * g[2] * arm;
            moment[1] -= lifts * w[2] * arm;
            (0..3).for_each(|a| force[a] += lifts * w[a]);
            force[2] += holds * g[2];
        }
        out.uplift_n = out.uplift_n.max(pull);
        if moment[0] > 0.0 {
            out.overturning = out.overturning.max(moment[1] / moment[0]);
        }
        let level = (force[0] * force[0] + force[1] * force[1]).sqrt();
        out.sliding_n = out.sliding_n.max(level);
        out.friction = out.friction.max(if force[2] > 0.0 { level / force[2] } else { f64::INFINITY });
    }
    out
}
