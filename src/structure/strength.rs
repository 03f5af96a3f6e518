//! Stresses of members and shear of sheathing in the ultimate combinations.

use super::actions::{ACTIONS, BaseActions, combined, terms};
use super::assess::govern;
use super::catalogue::{Catalogue, SectionOption};
use super::check::{Resistance, Restraint, design_forces, stations};
use super::checks::{Clause, Peaks};
use super::combine::{Combination, Duration, GRAVITY};
use super::verdict::{Assessment, Check, Governing};
use crate::analysis::Solution;
use crate::frame::{HouseFrame, Panel, PanelKind, Role, Span};

const UNLOADED_CLAUSE: Clause = Clause::TimberBendingY;

/// The check named for a member that nothing loads.
pub(super) const UNLOADED: Check = Check::Member(UNLOADED_CLAUSE);

/// Checks every span of every member under full wind pressures.
pub(super) fn members(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    combinations: &[Combination],
    solution: &Solution,
    actions: &BaseActions,
    result: &mut Assessment,
) {
    for span in &frame.spans {
        let member = &frame.members[span.member as usize];
        let option = sections[member.group as usize];
        let clear: f64 = elements(span).map(|e| solution.length(e)).sum();
        let r = Resistance::new(
            catalogue.material(option),
            catalogue.section(option),
            member.plies,
            clear,
            restraint(member.role),
        );
        let (utilisation, clause) = worst(&r, span, catalogue, combinations, solution, actions);
        let check = Check::Member(clause);
        let index = span.member as usize;
        if let Some(kept) = result.members.get_mut(index).filter(|kept| utilisation > kept.utilisation) {
            (kept.utilisation, kept.check) = (utilisation, check);
        }
        result.utilisation = result.utilisation.max(utilisation);
        govern(result, Governing { index, role: Some(member.role), check, utilisation });
    }
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

/// Largest ratio of a span over the combinations, its elements and the places where stresses turn, and its clause.
fn worst(
    r: &Resistance,
    span: &Span,
    catalogue: &Catalogue,
    combinations: &[Combination],
    solution: &Solution,
    actions: &BaseActions,
) -> (f64, Clause) {
    let (mut worst, has_peaks) = ((0.0, UNLOADED_CLAUSE), r.has_peaks());
    for c in combinations {
        let k_mod = catalogue.k_mod.timber[c.duration as usize];
        let mut peaks = Peaks::default();
        for e in elements(span) {
            let p = combined(actions.pieces(e), c);
            let (xs, n) = stations(&p, solution.length(e));
            for &x in &xs[..n] {
                let forces = design_forces(&p, x);
                // The bound is cheap and never too low: what it rules out cannot govern.
                if r.bound(&forces) > worst.0 * k_mod {
                    keep(&mut worst, r.ratio(&forces, k_mod));
                }
                if has_peaks {
                    peaks.add(&forces);
                }
            }
        }
        if has_peaks && r.bound_of_peaks(&peaks) > worst.0 * k_mod {
            keep(&mut worst, r.stability(&peaks, k_mod));
        }
    }
    worst
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
pub(super) fn racking(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    combinations: &[Combination],
    actions: &BaseActions,
    result: &mut Assessment,
) {
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
        let force = |c: &Combination| terms(c).map(|(n, f)| f * base[n]).sum::<f64>();
        let worst = combinations.iter().map(|c| force(c).abs() * weaker[c.duration as usize]).fold(0.0, f64::max);
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
