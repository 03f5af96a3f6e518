//! Members checked by EN 1993-1-1 and EN 1995-1-1: pure functions of section, strength and design forces.
//!
//! One truth for two users: the assessment of a house, which asks for the worst ratio many thousand times, and the calculator
//! `houscaper member`, which prints every clause. Both walk the same clauses through the same visitors ([`SteelMember::section`],
//! [`SteelMember::stability`], [`TimberMember::check`], [`TimberMember::stability`]). No strings, maps or allocation.
//!
//! SI units. x along the member, y the strong and z the weak axis of the section; tension positive; a positive `my` compresses
//! the top (+z) edge. Not in here: connections, holes, compression across the grain, fire, fatigue, warping torsion.

mod clause;
mod diagram;
mod section;
pub mod steel;
mod terms;
pub mod timber;

pub use clause::{Checked, Clause, Unit};
pub use diagram::Diagram;
pub use section::{Forming, Section, Shape};
pub use steel::{Steel, SteelMember};
pub use terms::{Term, Terms};
pub use timber::{Grade, TimberMember};

/// Design forces at a point of a member, N and N m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Forces {
    /// Axial force, tension positive.
    pub n: f64,
    /// Shear along y.
    pub vy: f64,
    /// Shear along z.
    pub vz: f64,
    /// Bending about y; positive compresses the top edge.
    pub my: f64,
    /// Bending about z.
    pub mz: f64,
}

/// Share of the largest moment that the opposite one must reach for the diagram to count as changing sign.
const REVERSAL: f64 = 0.1;

/// Largest forces along a member under one combination, which the clauses on stability set against its resistance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peaks {
    /// Largest compression, positive, N.
    pub compression: f64,
    /// Largest moment about y that compresses the top and the bottom edge, both positive, N m.
    pub my: [f64; 2],
    /// Largest moment about z, positive, N m.
    pub mz: f64,
}

impl Peaks {
    /// Which free length goes with the bottom edge compressed: 1, or 2 where the moment changes sign, so that only the ends of the member
    /// compress it.
    #[inline]
    pub fn bottom_case(&self) -> usize {
        if self.my[0] > 0.0 && self.my[0] >= REVERSAL * self.my[1] { 2 } else { 1 }
    }

    /// Takes a point of the member in.
    #[inline]
    pub fn add(&mut self, f: &Forces) {
        self.compression = self.compression.max(-f.n);
        self.my = [self.my[0].max(f.my), self.my[1].max(-f.my)];
        self.mz = self.mz.max(f.mz.abs());
    }
}
