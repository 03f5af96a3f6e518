//! Trying sections with the forces of the last assessment, one group at a time.

use super::actions::Sum;
use super::assess::Workspace;
use super::catalogue::{Catalogue, SectionOption};
use super::combine::Combination;
use super::loads::LoadSettings;
use super::serviceability::span_ratio;
use super::strength::{Loaded, resistance, worst};
use super::vibration::{floor_areas, of_span};
use crate::frame::{HouseFrame, Span};

/// A frame as it was assessed last, to try other sections in: pinned frames hardly change their forces with them.
pub(super) struct Trial<'a> {
    frame: &'a HouseFrame,
    catalogue: &'a Catalogue,
    loads: &'a LoadSettings,
    workspace: &'a Workspace,
    /// The sections of the last assessment, where the nodes of a span are to bend with the section that is tried.
    analysed: Option<[SectionOption; 4]>,
    sums: Vec<Sum>,
    floor_m2: Vec<f64>,
    /// Spans by group.
    spans: [Vec<u32>; 4],
    /// The place in each list of the span that ruled out the last option: most often it rules out the next one too.
    hardest: [usize; 4],
}

impl<'a> Trial<'a> {
    /// Needs a workspace whose last assessment of this frame was solved. With its sections `analysed` the nodes of a span leave its chord
    /// in proportion to the flexibility of what is tried; without, they stay.
    pub fn new(
        frame: &'a HouseFrame,
        catalogue: &'a Catalogue,
        loads: &'a LoadSettings,
        combinations: &[Combination],
        analysed: Option<[SectionOption; 4]>,
        workspace: &'a Workspace,
    ) -> Self {
        let k_mod = &catalogue.k_mod.timber;
        let sums = combinations.iter().map(|c| Sum::new(c, k_mod[c.duration as usize])).collect();
        let mut floor_m2 = Vec::new();
        floor_areas(frame, &mut floor_m2);
        let mut spans: [Vec<u32>; 4] = Default::default();
        for (n, span) in frame.spans.iter().enumerate() {
            spans[frame.members[span.member as usize].group as usize].push(n as u32);
        }
        Trial { frame, catalogue, loads, workspace, analysed, sums, floor_m2, spans, hardest: [0; 4] }
    }

    /// Whether all spans of a group hold with an option: stress, deflection, and vibration of its joists.
    pub fn holds(&mut self, group: usize, option: SectionOption) -> bool {
        let spans = &self.spans[group];
        let hard = self.hardest[group];
        let order = spans.get(hard).into_iter().chain(&spans[..hard]).chain(spans.get(hard + 1..).unwrap_or(&[]));
        match order.copied().find(|&n| self.ratio(&self.frame.spans[n as usize], option) > 1.0) {
            None => true,
            Some(n) => {
                self.hardest[group] = spans.iter().position(|&s| s == n).unwrap_or(0);
                false
            }
        }
    }

    /// Worst ratio of a group with an option.
    pub fn worst(&self, group: usize, option: SectionOption) -> f64 {
        self.spans[group].iter().map(|&n| self.ratio(&self.frame.spans[n as usize], option)).fold(0.0, f64::max)
    }

    fn ratio(&self, span: &Span, option: SectionOption) -> f64 {
        let Trial { frame, catalogue, loads, workspace, .. } = *self;
        let (solution, actions) = (&workspace.solution, &workspace.actions);
        let loaded = Loaded { frame, solution, actions, sums: &self.sums };
        let stress = worst(&loaded, &resistance(&loaded, catalogue, option, span), span, 0.0).0;
        let sections = [option; 4];
        let deflection = span_ratio(
            frame,
            catalogue,
            [&sections, self.analysed.as_ref().unwrap_or(&sections)],
            loads,
            solution,
            actions,
            span,
        )
        .0;
        let floor = of_span(frame, catalogue, &sections, loads, solution, &self.floor_m2, span);
        stress.max(deflection).max(floor.map_or(0.0, |f| f.ratio))
    }
}
