//! What a reviewer asks beside the verdict: the governing check of every member with its numbers, axial forces, deflections against
//! their limits, reactions along the foundation, storey stiffness, the deformed shape and the first buckling loads.
//!
//! A house is solved once more for it, with all cases, outside the hot path. The checks are those of the assessment: the same
//! resistances at the same places under the same combinations, so that both name the same ratios.

mod critical;
mod deformed;
mod drawn;
mod foundation;
mod members;
mod racking;
mod storeys;

pub use critical::{BucklingMode, Critical, ModeKind, critical_loads};
pub use deformed::{Deformed, MAX_PIECE_M, Place};
pub use drawn::DrawnLoads;
pub use foundation::{FoundationLine, LineKind, Peak};
pub use members::{GoverningCheck, MemberReview, SpanDeflection};
pub use racking::RackingReview;
pub use storeys::StoreyReview;

use super::cases::{Case, CaseLoads, UNITS};
use super::catalogue::{Catalogue, SectionOption};
use super::combine::{Combination, ultimate, winds};
use super::loads::LoadSettings;
use super::model::analysis_model;
use crate::analysis::{LoadCase, Model, Solution, Solver, Status};
use crate::frame::HouseFrame;

/// Everything that pages and pictures of one house show beside its assessment.
#[derive(Clone, Debug, PartialEq)]
pub struct Review {
    /// By member.
    pub members: Vec<MemberReview>,
    /// Lines of the foundation, along x, then along y, then single posts.
    pub foundation: Vec<FoundationLine>,
    /// Boarded walls, and the worst deck and roof panel.
    pub racking: Vec<RackingReview>,
    /// Storeys, lowest first.
    pub storeys: Vec<StoreyReview>,
    /// The shape under the characteristic combination with the largest displacement.
    pub deformed: Deformed,
    /// Loads to draw, by case.
    pub drawn: Vec<DrawnLoads>,
    /// Largest unbalanced force over the largest end force.
    pub residual: f64,
    /// Free displacements and rotations.
    pub unknowns: usize,
}

/// Reviews a frame; `None` where no verdict on members can be given: a mechanism, the thesis preset alone, or a class 4 section.
pub fn review(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
) -> Option<Review> {
    let solved = Solved::new(frame, catalogue, sections, loads)?;
    Some(Review {
        members: members::members(&solved),
        foundation: foundation::lines(&solved),
        racking: racking::racking(&solved),
        storeys: storeys::storeys(&solved),
        deformed: deformed::deformed(&solved),
        drawn: drawn::drawn(&solved),
        residual: solved.residual,
        unknowns: solved.unknowns,
    })
}

/// A frame solved under all unit cases of the site model.
struct Solved<'a> {
    frame: &'a HouseFrame,
    catalogue: &'a Catalogue,
    sections: &'a [SectionOption; 4],
    loads: &'a LoadSettings,
    model: Model,
    cases: CaseLoads,
    /// The cases that load anything, in the order of their slots.
    lent: Vec<LoadCase>,
    solution: Solution,
    /// Ultimate combinations in the order of the load report.
    combinations: Vec<Combination>,
    residual: f64,
    unknowns: usize,
}

impl<'a> Solved<'a> {
    fn new(
        frame: &'a HouseFrame,
        catalogue: &'a Catalogue,
        sections: &'a [SectionOption; 4],
        loads: &'a LoadSettings,
    ) -> Option<Self> {
        if loads.preset_only || sections.iter().any(|&s| catalogue.is_class_4(s)) {
            return None;
        }
        let model = analysis_model(frame, catalogue, sections);
        let (mut cases, mut lent) = (CaseLoads::default(), Vec::new());
        cases.fill(frame, loads);
        cases.lend(false, &mut lent);
        let mut solver = Solver::new();
        let solution = solver.solve(&model, &lent).ok()?;
        let Status::Solved { residual, .. } = solution.status else { return None };
        let combinations = ultimate(loads, &cases);
        let unknowns = solver.size().unknowns;
        Some(Solved {
            frame,
            catalogue,
            sections,
            loads,
            model,
            cases,
            lent,
            solution,
            combinations,
            residual,
            unknowns,
        })
    }

    /// Factors on the solved cases of a sum of actions: permanent, imposed, snow in an arrangement, a wind by its number.
    fn factors(&self, permanent: f64, imposed: f64, snow: (usize, f64), wind: Option<(usize, f64)>) -> Vec<f64> {
        let mut unit = [0.0; UNITS];
        unit[Case::Permanent as usize] = permanent;
        unit[Case::Imposed as usize] = imposed;
        unit[Case::Snow as usize] = snow.1;
        if snow.0 > 0 {
            unit[Case::HalfPlus as usize + snow.0 - 1] = snow.1;
        }
        if let Some((n, f)) = wind {
            unit.iter_mut().zip(winds(self.loads)[n]).for_each(|(u, w)| *u += f * w);
        }
        self.slots(&unit)
    }

    fn of(&self, c: &Combination) -> Vec<f64> {
        self.factors(c.permanent, c.imposed, c.snow, c.wind)
    }

    /// Factors by unit case as factors by slot.
    fn slots(&self, unit: &[f64; UNITS]) -> Vec<f64> {
        let mut out = vec![0.0; self.lent.len()];
        for (case, f) in unit.iter().enumerate() {
            if let Some(slot) = self.cases.slot(case) {
                out[slot] = *f;
            }
        }
        out
    }

    /// Displacement of a node under factored cases, m.
    fn displacement(&self, factors: &[f64], node: usize) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (slot, f) in factors.iter().enumerate().filter(|(_, f)| **f != 0.0) {
            let u = &self.solution.displacements(slot)[node];
            (0..3).for_each(|a| sum[a] += f * u[a]);
        }
        sum
    }

    /// Reaction of a support under factored cases: on the structure, N.
    fn reaction(&self, factors: &[f64], support: usize) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (slot, f) in factors.iter().enumerate().filter(|(_, f)| **f != 0.0) {
            let r = &self.solution.reactions(slot)[support];
            (0..3).for_each(|a| sum[a] += f * r[a]);
        }
        sum
    }
}
