//! Stresses of members and shear of sheathing in the ultimate combinations.

use super::actions::{ACTIONS, BaseActions, Sum};
use super::assess::govern;
use super::catalogue::{Catalogue, SectionOption};
use super::check::{Resistance, Restraint, design_forces, stations};
use super::checks::{Clause, Peaks};
use super::combine::{Combination, Duration, GRAVITY};
use super::screen::{Reach, Screen, bound, shares};
use super::verdict::{Assessment, Check, Governing};
use crate::analysis::Solution;
use crate::frame::{HouseFrame, Panel, PanelKind, Role, Span};

const UNLOADED_CLAUSE: Clause = Clause::TimberBendingY;

/// The check named for a member that nothing loads.
pub(super) const UNLOADED: Check = Check::Member(UNLOADED_CLAUSE);

/// What every check of a frame needs.
#[derive(Clone, Copy)]
pub(super) struct Loaded<'a> {
    pub frame: &'a HouseFrame,
    pub solution: &'a Solution,
    pub actions: &'a BaseActions,
    /// Ultimate combinations.
    pub sums: &'a [Sum],
}

/// Checks every span of every member under full wind pressures.
///
/// Where no results by member are kept, a span that cannot be the worst is passed over: the worst one is the same without it.
pub(super) fn members(
    loaded: &Loaded,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    screen: &mut Screen,
    result: &mut Assessment,
) {
    let Loaded { frame, solution, actions, sums } = *loaded;
    screen.clear();
    for span in &frame.spans {
        let member = &frame.members[span.member as usize];
        let clear: f64 = elements(span).map(|e| solution.length(e)).sum();
        let (option, held) = (sections[member.group as usize], restraint(member.role));
        screen.push((member.group, member.plies, held), clear, || {
            Resistance::new(catalogue.material(option), catalogue.section(option), member.plies, clear, held)
        });
    }
    let only_worst = result.members.is_empty();
    let first = if only_worst { screen.bound_all(&frame.spans, sums, solution, actions) } else { None };
    let floor = first.map_or(0.0, |at| worst(loaded, screen.resistance(at), &frame.spans[at], 0.0).0);
    for (at, span) in frame.spans.iter().enumerate() {
        if only_worst && screen.bound(at) < floor {
            continue;
        }
        let (utilisation, clause) = worst(loaded, screen.resistance(at), span, floor);
        let check = Check::Member(clause);
        let index = span.member as usize;
        if let Some(kept) = result.members.get_mut(index).filter(|kept| utilisation > kept.utilisation) {
            (kept.utilisation, kept.check) = (utilisation, check);
        }
        result.utilisation = result.utilisation.max(utilisation);
        let role = Some(frame.members[index].role);
        govern(result, Governing { index, role, check, utilisation });
    }
}

/// Resistance of a span with an option.
pub(super) fn resistance(loaded: &Loaded, catalogue: &Catalogue, option: SectionOption, span: &Span) -> Resistance {
    let member = &loaded.frame.members[span.member as usize];
    let clear: f64 = elements(span).map(|e| loaded.solution.length(e)).sum();
    Resistance::new(catalogue.material(option), catalogue.section(option), member.plies, clear, restraint(member.role))
}

fn elements(span: &Span) -> std::ops::RangeInclusive<usize> {
    span.elements[0] as usize..=span.elements[1] as usize
}

/// Where boards hold a member. Wall boards and lining hold both edges of what stands or lies in a wall; decks and roof boards hold the
/// upper edge of what carries them, joists and rafters that of the beams and ridges under them. The lower edge is free.
pub(super) fn restraint(role: Role) -> Restraint {
    let edges = match role {
        Role::Stud | Role::CornerPost | Role::Jamb | Role::Plate | Role::Lintel | Role::Sill => [true, true],
        Role::Joist | Role::Trimmer | Role::Beam | Role::Rafter | Role::Hip | Role::Valley | Role::Ridge => {
            [true, false]
        }
        Role::BeamPost => [false, false],
    };
    Restraint { sideways: role.is_sheathed(), edges }
}

/// Largest ratio of a span over the combinations, its elements and the places where stresses turn, and its clause. Ratios under
/// `floor` need not be found: where none reaches it, any of them is returned.
pub(super) fn worst(loaded: &Loaded, r: &Resistance, span: &Span, floor: f64) -> (f64, Clause) {
    let shares = shares(r, span, loaded.solution, loaded.actions);
    let bounds = || loaded.sums.iter().map(|sum| bound(r, &shares, sum));
    // The combination that promises most comes first, so that few others are left to look at.
    let promising = |most: (usize, f64), (n, bound): (usize, f64)| if bound > most.1 { (n, bound) } else { most };
    let (leading, _) = bounds().enumerate().fold((0, f64::NEG_INFINITY), promising);
    let Some(sum) = loaded.sums.get(leading) else { return (0.0, UNLOADED_CLAUSE) };
    let mut first = (0.0, UNLOADED_CLAUSE);
    in_combination(loaded, r, span, sum, floor, &mut first);
    let floor = floor.max(first.0);
    let mut worst = (0.0, UNLOADED_CLAUSE);
    for (n, (sum, bound)) in loaded.sums.iter().zip(bounds()).enumerate() {
        if n == leading {
            keep(&mut worst, first);
        } else if !(bound < floor || bound <= worst.0) {
            in_combination(loaded, r, span, sum, floor, &mut worst);
        }
    }
    worst
}

/// Keeps the first of the largest ratios of a span in a combination, if it is larger than `worst` and not under `floor`.
fn in_combination(loaded: &Loaded, r: &Resistance, span: &Span, sum: &Sum, floor: f64, worst: &mut (f64, Clause)) {
    // A bound is cheap and never too low: what it rules out cannot govern.
    let idle = |bound: f64, worst: &(f64, Clause)| bound < floor || bound <= worst.0;
    let mut reach = Reach::default();
    for e in elements(span) {
        reach.join(&Reach::of(&sum.piece(loaded.actions.pieces(e)), loaded.solution.length(e)));
    }
    let [normal, shear] = r.shares(&reach);
    if idle(r.at_most(normal.max(shear), sum.k_mod), worst) {
        return;
    }
    let (k_mod, has_peaks) = (sum.k_mod, r.has_peaks());
    let mut peaks = Peaks::default();
    for e in elements(span) {
        let p = sum.piece(loaded.actions.pieces(e));
        let (xs, n) = stations(&p, loaded.solution.length(e));
        for &x in &xs[..n] {
            let forces = design_forces(&p, x);
            if !idle(r.bound(&forces, k_mod), worst) {
                keep(worst, r.ratio(&forces, k_mod));
            }
            if has_peaks {
                peaks.add(&forces);
            }
        }
    }
    if has_peaks && !idle(r.bound_of_peaks(&peaks, k_mod), worst) {
        keep(worst, r.stability(&peaks, k_mod));
    }
}

fn keep(worst: &mut (f64, Clause), other: (f64, Clause)) {
    if other.0 > worst.0 {
        *worst = other;
    }
}

/// Shear of sheathing, its capacity scaled by the duration of load; wind as an action on the house as a whole.
///
/// Decks and roofs panel by panel. The panels of a wall share its load: nailed boards yield before they fail, so that method A of
/// EN 1995-1-1 9.2.4.2 adds up the capacities of a wall's panels (9.20).
pub(super) fn racking(loaded: &Loaded, catalogue: &Catalogue, combinations: &[Combination], result: &mut Assessment) {
    let Loaded { frame, actions, sums, .. } = *loaded;
    let k = catalogue.k_mod.joint();
    let weaker = k.map(|k_mod| k[Duration::Short as usize] / k_mod);
    let mut first = 0;
    for wall in frame.panels.chunk_by(|a, b| a.line == b.line && a.kind == PanelKind::Wall) {
        let (mut base, mut capacity) = ([0.0; ACTIONS], 0.0);
        for (n, panel) in wall.iter().enumerate() {
            let level = if panel.kind == PanelKind::Wall { run(frame, panel) } else { 1.0 };
            capacity += panel.capacity_n * level.abs();
            base.iter_mut().zip(actions.panel(first + n)).for_each(|(b, f)| *b += level * f);
        }
        base[GRAVITY..].iter_mut().zip(&actions.overall).for_each(|(b, f)| *b *= f);
        let force = |sum: &Sum| sum.terms().iter().map(|&(n, f)| f * base[n]).sum::<f64>();
        let forces = sums.iter().zip(combinations).map(|(s, c)| force(s).abs() * weaker[c.duration as usize]);
        let worst = forces.fold(0.0, f64::max);
        let utilisation = worst / capacity;
        result.racking_ratio = result.racking_ratio.max(utilisation);
        result.utilisation = result.utilisation.max(utilisation);
        govern(result, Governing { index: first, role: None, check: Check::Racking(wall[0].kind), utilisation });
        first += wall.len();
    }
}

/// Level part of a wall brace over its length, signed along the wall; braces run from their lower node up.
fn run(frame: &HouseFrame, panel: &Panel) -> f64 {
    let [a, b] = panel.nodes.map(|n| frame.nodes[n as usize]);
    let d = [0, 1, 2].map(|x| b[x] - a[x]);
    (d[0] + d[1]) / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt()
}

#[cfg(test)]
#[path = "strength_tests.rs"]
mod tests;
