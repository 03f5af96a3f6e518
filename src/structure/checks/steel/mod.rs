//! EN 1993-1-1:2005 for rolled I sections and hollow sections of class 1 to 3.

mod buckling;
mod class;
mod member;
mod resistance;

pub use buckling::{Curve, Lateral, LateralMethod, critical_moment, reduction};
pub use class::{Class, class_in_compression, class_of};
pub use member::SteelMember;

use super::{Forming, Shape};

/// Strength and stiffness of a steel, Pa, with its partial factors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steel {
    /// Modulus of elasticity.
    pub e: f64,
    /// Shear modulus.
    pub g: f64,
    /// Yield strength, characteristic.
    pub fy: f64,
    /// gamma M0, resistance of cross-sections.
    pub gamma_m0: f64,
    /// gamma M1, resistance of members to instability.
    pub gamma_m1: f64,
}

impl Steel {
    /// sqrt(235 MPa / fy) of Table 5.2.
    pub fn epsilon(&self) -> f64 {
        (235e6 / self.fy).sqrt()
    }
}

/// Buckling curves about y and z of Table 6.2, for S235 to S420.
pub fn curves(shape: &Shape) -> [Curve; 2] {
    match *shape {
        Shape::Box { forming: Forming::Hot, .. } | Shape::Tube { forming: Forming::Hot, .. } => [Curve::A; 2],
        Shape::Box { forming: Forming::Cold, .. } | Shape::Tube { forming: Forming::Cold, .. } => [Curve::C; 2],
        Shape::I { b, h, tf, .. } if h > 1.2 * b && tf <= 0.04 => [Curve::A, Curve::B],
        Shape::I { b, h, tf, .. } if h > 1.2 * b || tf <= 0.1 => [Curve::B, Curve::C],
        Shape::I { .. } => [Curve::D; 2],
        // Table 6.2, solid sections.
        Shape::Rectangle { .. } => [Curve::C; 2],
    }
}
