//! EN 1995-1-1:2004 with A1 for solid rectangles of sawn timber and glulam.

mod factors;
mod member;

pub use factors::{column, critical_stress, lateral, size, torsion_shape};
pub use member::{Held, TimberMember};

/// Characteristic strengths and stiffness along the grain, Pa, and factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grade {
    /// Bending.
    pub fm: f64,
    /// Tension.
    pub ft: f64,
    /// Compression.
    pub fc: f64,
    /// Shear.
    pub fv: f64,
    /// Fifth percentile of E.
    pub e05: f64,
    /// Partial factor gamma M.
    pub gamma: f64,
    /// Straightness factor of 6.3.2 (6.29).
    pub beta_c: f64,
    /// Redistribution factor of 6.1.6(2).
    pub k_m: f64,
    /// Crack factor of 6.1.7(2).
    pub k_cr: f64,
    /// Glued laminated.
    pub glued: bool,
}
