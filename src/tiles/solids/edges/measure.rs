//! How much of each edge a cube holds: what a take-off counts, without building a solid.

use super::super::border::{Border, HALF_UM};
use super::super::{Columns, SolidStyle};
use super::deck::{Rim, has_parapet, rim};
use super::eaves;

/// Edges of roofs and decks, in m and m2.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EdgeTerms {
    /// Roof beyond eaves and verges, m2 of its own plane.
    pub overhang_m2: f64,
    /// Gutters, m along their inner edge.
    pub gutter_m: f64,
    /// Parapets, m2 of their outer face above the roof.
    pub parapet_m2: f64,
    /// Copings and trims of parapets, flush decks and level roofs, m along the facade.
    pub coping_m: f64,
    /// Railings along walked decks, m along the facade.
    pub railing_m: f64,
}

/// The edges in a cube whose axes are stretched by `scale` (1 for the default module).
pub fn edge_terms(columns: &Columns, style: &SolidStyle, scale: [f64; 3]) -> EdgeTerms {
    let mut terms = EdgeTerms::default();
    // A border across `axis` runs along the other one.
    let half_m = |axis: usize| f64::from(HALF_UM) * 1e-6 * scale[1 - axis];
    for q in 0..4 {
        for axis in (0..2).filter(|&axis| eaves::roof_ends(columns, q, axis)) {
            let strip = eaves::strip_terms(columns, Border { q, axis }, style);
            terms.overhang_m2 += strip.overhang_m2 * scale[0] * scale[1];
            terms.gutter_m += strip.gutter_m * scale[1 - axis];
            terms.coping_m += if strip.is_trim { half_m(axis) } else { 0.0 };
        }
        let length_m = match rim(columns, q) {
            Rim::None | Rim::Concave => continue,
            Rim::Straight(axis) => half_m(axis),
            Rim::Convex => half_m(0) + half_m(1),
        };
        if has_parapet(columns, q, style) {
            terms.parapet_m2 += length_m * f64::from(style.parapet_um) * 1e-6 * scale[2];
        }
        if columns.key.walked(q) {
            terms.railing_m += length_m;
        } else {
            terms.coping_m += length_m;
        }
    }
    terms
}
