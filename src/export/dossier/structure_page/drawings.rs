//! The drawings of the page.

use super::super::frame_drawing::{bent, coloured};
use super::super::frame_scene::{deformation_scale, views};
use super::super::structure::StructureReport;
use super::page::{Page, fixed};
use crate::frame::{HouseFrame, Role};
use crate::score::{Details, Evaluator};
use crate::structure::{Review, SectionOption};

/// Members whose numbers stand in the drawing of the utilisation.
const NUMBERED: usize = 12;

/// The frame drawn by utilisation, by axial force, by role, and deformed, as SVG.
pub struct Drawings {
    utilisation: String,
    roles: String,
    axial: Option<String>,
    deformed: Option<String>,
    shown: Vec<Role>,
}

impl Drawings {
    /// Draws a frame.
    pub fn new(
        frame: &HouseFrame,
        details: &Details,
        evaluator: &Evaluator,
        sections: &[SectionOption; 4],
        review: Option<&Review>,
    ) -> Drawings {
        let results = details.evaluation.assessment.as_ref().map_or(&[][..], |a| &a.members);
        let ratio = |m: usize| results.get(m).map_or(0.0, |r| r.utilisation);
        let width = |m: usize| {
            let member = &frame.members[m];
            let section = evaluator.catalogue.section(sections[member.group as usize]);
            0.5 * (section.b * f64::from(member.plies) + section.h)
        };
        let mut worst: Vec<usize> = (0..frame.members.len()).filter(|&m| ratio(m) > 0.0).collect();
        worst.sort_by(|&a, &b| ratio(b).total_cmp(&ratio(a)).then(a.cmp(&b)));
        worst.truncate(NUMBERED);
        let by_role = |m: usize| views::of_role(frame.members[m].role);
        let by_ratio = |m: usize| views::UTILISATION[views::of_utilisation(ratio(m))].colour;
        Drawings {
            utilisation: coloured(frame, "The frame by utilisation", width, by_ratio, &worst),
            roles: coloured(frame, "The frame by role", width, by_role, &[]),
            axial: review.map(|r| {
                let by_force = |m: usize| views::AXIAL[views::of_axial(r.members[m].axial_extreme_n())].colour;
                coloured(frame, "The frame by axial force", width, by_force, &[])
            }),
            deformed: review
                .map(|r| bent(frame, "The deformed frame", &r.deformed, deformation_scale(frame, &r.deformed))),
            shown: Role::ALL.into_iter().filter(|role| frame.members.iter().any(|m| m.role == *role)).collect(),
        }
    }

    /// Puts them on the page.
    pub(super) fn put(&self, page: &mut Page, report: &StructureReport) {
        page.heading("The frame");
        let keys = |classes: &'static [views::Class], cut: &str| -> Vec<(u32, &'static str)> {
            classes.iter().map(|c| (c.colour, c.name.strip_prefix(cut).unwrap_or(c.name))).collect()
        };
        page.raw("<div class=\"pair\">");
        page.figure(
            &self.utilisation,
            "Utilisation: largest ratio of each member's checks over all ultimate combinations. Numbers: the worst members.",
            &keys(&views::UTILISATION, "utilisation "),
        );
        if let Some(svg) = &self.axial {
            page.figure(
                svg,
                "Axial force of largest magnitude over all ultimate combinations: blue compression, red tension.",
                &keys(&views::AXIAL, "axial force "),
            );
        }
        let roles: Vec<(u32, &str)> = self.shown.iter().map(|r| (views::of_role(*r), r.name())).collect();
        page.figure(&self.roles, "Roles. Boards on walls, decks and roofs brace the frame and are not drawn.", &roles);
        if let (Some(svg), Some(d)) = (&self.deformed, &report.deformed) {
            let words = format!(
                "Deformed {} times under {}, the characteristic combination with the largest displacement: {} mm at the ring (member {}).",
                d.scale,
                d.combination,
                fixed(d.largest_mm, 1),
                d.member
            );
            page.figure(svg, &words, &[]);
        }
        page.raw("</div>\n");
    }
}
