//! Stresses of members and shear of sheathing in the ultimate combinations.

use super::actions::{ACTIONS, BaseActions, combined, terms};
use super::assess::govern;
use super::catalogue::{Catalogue, SectionOption};
use super::check::{Resistance, section_forces, stations};
use super::combine::{Combination, Duration, GRAVITY};
use super::verdict::{Assessment, Check, Governing};
use crate::analysis::Solution;
use crate::frame::{HouseFrame, Panel, PanelKind, Span};

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
            member.role.is_sheathed(),
        );
        let (utilisation, check) = worst(&r, span, catalogue, combinations, solution, actions);
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

/// Largest ratio of a span over its elements, the combinations and the places where stresses turn, and its check.
fn worst(
    r: &Resistance,
    span: &Span,
    catalogue: &Catalogue,
    combinations: &[Combination],
    solution: &Solution,
    actions: &BaseActions,
) -> (f64, Check) {
    let mut worst = (0.0, Check::Bending);
    for e in elements(span) {
        let (length, actions) = (solution.length(e), actions.pieces(e));
        for c in combinations {
            let p = combined(actions, c);
            let k_mod = catalogue.k_mod.timber[c.duration as usize];
            let (xs, n) = stations(&p, length);
            for &x in &xs[..n] {
                let forces = section_forces(&p, x);
                // The bound is cheap and never too low: what it rules out cannot govern.
                if r.bound(&forces) > worst.0 * k_mod {
                    let ratio = r.ratio(forces, k_mod);
                    if ratio.0 > worst.0 {
                        worst = ratio;
                    }
                }
            }
        }
    }
    worst
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
