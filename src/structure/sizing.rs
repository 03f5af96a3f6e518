//! Sizing: for a given frame the section of each role group that costs least and passes every check.
//!
//! A frame of pinned sticks hands almost the same forces to whatever section it is given. So one analysis serves to try the whole
//! catalogue: all options of all groups are checked with the forces at hand, each group takes the cheapest that holds, and the frame
//! is analysed again with the choice, until it repeats itself. A section that fails in its own analysis is struck off, so the walk
//! ends. What the analysis says last is what counts.

use super::assess::{Workspace, assess};
use super::catalogue::{Catalogue, SectionOption};
use super::combine::ultimate;
use super::loads::LoadSettings;
use super::trial::Trial;
use super::verdict::{Assessment, Verdict};
use crate::frame::HouseFrame;
use crate::voxels::Choice;

/// Most analyses of one walk. Sample houses take four to twelve.
const MOST_STEPS: usize = 24;

/// A section on offer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bid {
    /// The section and material.
    pub option: SectionOption,
    /// What a metre of one ply costs, in whatever is to be least: money, mass, carbon.
    pub per_m: f64,
}

/// One analysis of the walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizingStep {
    /// Index of each group's bid.
    pub bids: [usize; 4],
    /// Sum over groups of length x cost a metre.
    pub cost: f64,
    /// Worst ratio of the members of each group: stress, deflection, vibration.
    pub group_ratio: [f64; 4],
    /// Worst of drift and racking, which sections hardly change.
    pub sheathing_ratio: f64,
    /// Whether the verdict is ok.
    pub is_ok: bool,
}

/// What sizing arrived at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sizing {
    /// Index of each group's bid; the cheapest whose verdict is ok, else the cheapest whose members hold, else the nearest to that.
    pub bids: [usize; 4],
    /// The analyses, in order.
    pub steps: Vec<SizingStep>,
    /// The step that [`Sizing::bids`] come from.
    pub best: usize,
}

impl Sizing {
    /// The step it arrived at; `None` for a frame that could not be assessed.
    pub fn result(&self) -> Option<&SizingStep> {
        self.steps.get(self.best)
    }
}

impl SizingStep {
    /// Worst ratio of all members.
    pub fn worst(&self) -> f64 {
        self.group_ratio.into_iter().fold(0.0, f64::max)
    }

    /// Ok first, then members that hold, then the nearest to it; among equals the cheapest.
    pub fn is_better_than(&self, other: &SizingStep) -> bool {
        let rank = |s: &SizingStep| {
            let fails = s.worst() > 1.0;
            ((!s.is_ok, fails), if fails { s.worst() } else { s.cost })
        };
        let (a, b) = (rank(self), rank(other));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).is_lt()
    }
}

/// Chooses a bid for each group (wall, floor, beam, roof), no list empty. The frame stays as it is. Without `start` the walk begins
/// with the cheapest bids and ends with a second look at what was struck off early, and is then gone again with nodes that move as they
/// did, which leads by stiffer sections; with it, it begins there and is quick: two to four analyses for a house like one
/// that was sized.
pub fn size(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    bids: &[Vec<Bid>; 4],
    start: Option<[usize; 4]>,
    loads: &LoadSettings,
    workspace: &mut Workspace,
) -> Sizing {
    // Positions in each list from cheap to dear; of equal bids the first.
    let order: [Vec<usize>; 4] = std::array::from_fn(|g| {
        let mut order: Vec<usize> = (0..bids[g].len()).collect();
        order.sort_by(|&a, &b| bids[g][a].per_m.total_cmp(&bids[g][b].per_m));
        order
    });
    let asked = (workspace.detail, workspace.report);
    (workspace.detail, workspace.report) = (true, false);
    let at = start.unwrap_or(std::array::from_fn(|g| order[g][0]));
    let out = Sizing { bids: at, ..Sizing::default() };
    let mut walker = Walker { frame, catalogue, bids, order, loads, workspace, out, analysed: None };
    walker.walk(at, Nodes::Bend);
    if start.is_none() {
        walker.look_again(Nodes::Bend);
        walker.walk(at, Nodes::Stay);
        walker.look_again(Nodes::Stay);
    }
    let Walker { workspace, out, .. } = walker;
    (workspace.detail, workspace.report) = asked;
    out
}

/// Where the nodes inside a span are taken to be when a section is tried.
#[derive(Clone, Copy, PartialEq)]
enum Nodes {
    /// Off its chord in proportion to its flexibility: exact where its forces stay.
    Bend,
    /// Where the last analysis had them, whatever the section: right where stiffer neighbours hold them.
    Stay,
}

/// A walk through the bids and what it is made of.
struct Walker<'a> {
    frame: &'a HouseFrame,
    catalogue: &'a Catalogue,
    bids: &'a [Vec<Bid>; 4],
    /// Bids of each group from cheap to dear.
    order: [Vec<usize>; 4],
    loads: &'a LoadSettings,
    workspace: &'a mut Workspace,
    out: Sizing,
    /// The step whose forces the workspace holds.
    analysed: Option<usize>,
}

impl Walker<'_> {
    /// From `at` to what holds under the forces of each analysis, until it repeats itself. What fails in its own analysis is struck off.
    fn walk(&mut self, mut at: [usize; 4], nodes: Nodes) {
        let mut struck: [Vec<bool>; 4] = std::array::from_fn(|g| vec![false; self.bids[g].len()]);
        let mut seen = Vec::new();
        while seen.len() < MOST_STEPS {
            let Some(ratio) = self.analyse(at) else { break };
            seen.push(at);
            (0..4).filter(|&g| ratio[g] > 1.0).for_each(|g| struck[g][at[g]] = true);
            at = self.next(at, &struck, nodes);
            if seen.contains(&at) {
                break;
            }
        }
    }

    /// What was struck off early, beside weak neighbours, may hold beside the final ones: one group at a time, as long as that saves.
    fn look_again(&mut self, nodes: Nodes) {
        let none: [Vec<bool>; 4] = std::array::from_fn(|g| vec![false; self.bids[g].len()]);
        for _ in 0..MOST_STEPS {
            let settled = self.out.bids;
            if self.analyse(settled).is_none() {
                break;
            }
            let cheaper = self.next(settled, &none, nodes);
            let single = (0..4).map(|g| {
                let mut one = settled;
                one[g] = cheaper[g];
                one
            });
            let untried = |c: &[usize; 4]| self.out.steps.iter().all(|s| s.bids != *c);
            let Some(next) = std::iter::once(cheaper).chain(single).find(untried) else { break };
            if self.analyse(next).is_none() {
                break;
            }
        }
    }

    /// Analyses bids and tells the worst ratio of each group; a first time it is a step, kept when it is the best so far. `None` for a
    /// frame that cannot be assessed.
    fn analyse(&mut self, at: [usize; 4]) -> Option<[f64; 4]> {
        let known = self.out.steps.iter().position(|s| s.bids == at);
        if let Some(n) = known.filter(|&n| self.analysed == Some(n)) {
            return Some(self.out.steps[n].group_ratio);
        }
        let sections = sections_of(self.bids, at);
        let found = assess(self.frame, self.catalogue, &sections, self.loads, self.workspace);
        if matches!(found.verdict, Verdict::Unstable { .. } | Verdict::NotAssessed { .. }) {
            return None;
        }
        self.analysed = Some(known.unwrap_or(self.out.steps.len()));
        if let Some(n) = known {
            return Some(self.out.steps[n].group_ratio);
        }
        let step = SizingStep {
            bids: at,
            cost: (0..4).map(|g| self.bids[g][at[g]].per_m * found.group_length_m[g]).sum(),
            group_ratio: worst_by_group(self.frame, &found),
            sheathing_ratio: found.racking_ratio.max(found.sway_ratio),
            is_ok: found.verdict == Verdict::Ok,
        };
        if self.out.result().is_none_or(|best| step.is_better_than(best)) {
            (self.out.best, self.out.bids) = (self.out.steps.len(), at);
        }
        self.out.steps.push(step);
        Some(step.group_ratio)
    }

    /// The cheapest bid of each group that holds under the forces of the last analysis, which was of the bids `at`, and was not struck
    /// off; where none does, the one that comes nearest, of equals the cheaper.
    fn next(&self, at: [usize; 4], struck: &[Vec<bool>; 4], nodes: Nodes) -> [usize; 4] {
        let combinations = ultimate(self.loads, &self.workspace.loads);
        let analysed = (nodes == Nodes::Bend).then(|| sections_of(self.bids, at));
        let mut trial = Trial::new(self.frame, self.catalogue, self.loads, &combinations, analysed, self.workspace);
        std::array::from_fn(|g| {
            let open = || self.order[g].iter().copied().filter(|&n| !struck[g][n]);
            let holds = open().find(|&n| trial.holds(g, self.bids[g][n].option));
            let nearest = || {
                let ratios = open().map(|n| (n, trial.worst(g, self.bids[g][n].option)));
                ratios.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(n, _)| n)
            };
            holds.or_else(nearest).unwrap_or(self.order[g][self.order[g].len() - 1])
        })
    }
}

fn sections_of(bids: &[Vec<Bid>; 4], at: [usize; 4]) -> [SectionOption; 4] {
    std::array::from_fn(|g| bids[g][at[g]].option)
}

/// Worst ratio of the members of each group: stress and deflection, and vibration for that of the joists.
fn worst_by_group(frame: &HouseFrame, found: &Assessment) -> [f64; 4] {
    let mut worst = [0.0; 4];
    for (member, result) in frame.members.iter().zip(&found.members) {
        let ratio = &mut worst[member.group as usize];
        *ratio = f64::max(*ratio, result.utilisation.max(result.deflection_ratio));
    }
    worst[Choice::Floor as usize] = worst[Choice::Floor as usize].max(found.vibration_ratio());
    worst
}
