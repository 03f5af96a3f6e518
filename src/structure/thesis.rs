//! The thesis preset: factored weight of the frame and wind from each side, stress with bending against a share of the strength.

use super::actions::{add, unit_piece};
use super::cases::{Case, CaseLoads};
use super::catalogue::{Catalogue, SectionOption};
use super::check::{Fibres, section_forces, stations};
use super::loads::LoadSettings;
use super::verdict::ThesisResult;
use crate::analysis::Solution;
use crate::frame::HouseFrame;

pub(super) fn thesis(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    cases: &CaseLoads,
    solution: &Solution,
) -> ThesisResult {
    let mut out = ThesisResult::default();
    for (e, element) in frame.elements.iter().enumerate() {
        let member = &frame.members[element.member as usize];
        let option = sections[member.group as usize];
        let m = catalogue.material(option);
        let length = solution.length(e);
        let fibres = Fibres::new(catalogue.section(option), member.plies);
        let own = unit_piece(solution, cases, e, Case::Frame as usize);
        for side in 0..4 {
            let mut p = unit_piece(solution, cases, e, Case::Thesis as usize + side);
            add(&mut p, loads.thesis_gravity, &own);
            let (xs, n) = stations(&p, length);
            for &x in &xs[..n] {
                let [t, c, axial] = fibres.extremes(section_forces(&p, x));
                out.stress = [out.stress[0].max(t), out.stress[1].max(c)];
                out.axial_stress = out.axial_stress.max(axial.abs());
                let ratio = (t / m.thesis_limit[0]).max(c / m.thesis_limit[1]);
                if ratio > out.ratio {
                    (out.ratio, out.limit) = (ratio, m.thesis_limit);
                }
            }
        }
    }
    out.passes = out.ratio <= 1.0;
    out
}
