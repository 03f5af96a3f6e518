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
#[derive(Clone, Debug, PartialEq)]
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

    /// Analyses bids, notes the step, and keeps it when it is the best so far; false for a frame that cannot be assessed.
    fn analyse(
        &mut self,
        frame: &HouseFrame,
        catalogue: &Catalogue,
        bids: &[Vec<Bid>; 4],
        at: [usize; 4],
        loads: &LoadSettings,
        workspace: &mut Workspace,
    ) -> bool {
        let found = assess(frame, catalogue, &sections_of(bids, at), loads, workspace);
        if matches!(found.verdict, Verdict::Unstable { .. } | Verdict::NotAssessed { .. }) {
            return false;
        }
        let step = SizingStep {
            bids: at,
            cost: (0..4).map(|g| bids[g][at[g]].per_m * found.group_length_m[g]).sum(),
            group_ratio: worst_by_group(frame, &found),
            sheathing_ratio: found.racking_ratio.max(found.sway_ratio),
            is_ok: found.verdict == Verdict::Ok,
        };
        if self.result().is_none_or(|best| step.is_better_than(best)) {
            (self.best, self.bids) = (self.steps.len(), at);
        }
        self.steps.push(step);
        true
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
/// with the cheapest bids and ends with a second look at what was struck off early; with it, it begins there and is quick: two to four
/// analyses for a house like one that was sized.
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
    let mut struck: [Vec<bool>; 4] = std::array::from_fn(|g| vec![false; bids[g].len()]);
    let mut at: [usize; 4] = start.unwrap_or(std::array::from_fn(|g| order[g][0]));
    let mut out = Sizing { bids: at, ..Sizing::default() };
    let none = struck.clone();
    while out.steps.len() < MOST_STEPS && out.analyse(frame, catalogue, bids, at, loads, workspace) {
        let ratio = out.steps[out.steps.len() - 1].group_ratio;
        (0..4).filter(|&g| ratio[g] > 1.0).for_each(|g| struck[g][at[g]] = true);
        let next = walk(frame, catalogue, bids, &order, &struck, loads, workspace);
        if out.steps.iter().any(|s| s.bids == next) {
            break;
        }
        at = next;
    }
    // What was struck off early, beside weak neighbours, may hold beside the final ones: one group at a time, as long as that saves.
    while start.is_none() && out.steps.len() < MOST_STEPS && out.best < out.steps.len() {
        let settled = out.bids;
        let last = &out.steps[out.steps.len() - 1];
        if last.bids != settled {
            assess(frame, catalogue, &sections_of(bids, settled), loads, workspace);
        }
        let cheaper = walk(frame, catalogue, bids, &order, &none, loads, workspace);
        let single = (0..4).map(|g| {
            let mut one = settled;
            one[g] = cheaper[g];
            one
        });
        let mut untried = std::iter::once(cheaper).chain(single).filter(|c| out.steps.iter().all(|s| s.bids != *c));
        let Some(next) = untried.next() else { break };
        if !out.analyse(frame, catalogue, bids, next, loads, workspace) {
            break;
        }
    }
    (workspace.detail, workspace.report) = asked;
    out
}

fn sections_of(bids: &[Vec<Bid>; 4], at: [usize; 4]) -> [SectionOption; 4] {
    std::array::from_fn(|g| bids[g][at[g]].option)
}

/// The cheapest bid of each group that holds under the forces of the last analysis and was not struck off; where none does, the one
/// that comes nearest, of equals the cheaper.
fn walk(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    bids: &[Vec<Bid>; 4],
    order: &[Vec<usize>; 4],
    struck: &[Vec<bool>; 4],
    loads: &LoadSettings,
    workspace: &Workspace,
) -> [usize; 4] {
    let combinations = ultimate(loads, &workspace.loads);
    let mut trial = Trial::new(frame, catalogue, loads, &combinations, workspace);
    std::array::from_fn(|g| {
        let open = || order[g].iter().copied().filter(|&n| !struck[g][n]);
        let holds = open().find(|&n| trial.holds(g, bids[g][n].option));
        let nearest = || {
            let ratios = open().map(|n| (n, trial.worst(g, bids[g][n].option)));
            ratios.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(n, _)| n)
        };
        holds.or_else(nearest).unwrap_or(order[g][order[g].len() - 1])
    })
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
