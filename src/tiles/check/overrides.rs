//! Overrides of a style: what their meshes show on the faces of a cube against what the style itself would show there.

use super::super::outline::Outline;
use super::super::{Component, Manifest};
use super::Construction;
use super::finding::{Coverage, Finding, FindingKind, Report};
use super::labels::{Show, assembled, differences, shown};
use super::meshes::Sheets;
use crate::cubes::{Axis, needs_tile, reachable_keys, reachable_labels};
use std::collections::BTreeSet;

/// What bodies show on the six faces of a cube of `size` µm: x low, x high, y low, ... by component on vertical faces, of all
/// together on level ones.
pub fn sections<'a>(
    bodies: impl Iterator<Item = (Component, &'a Vec<Vec<[i32; 3]>>)> + Clone,
    size: [i32; 3],
) -> [Vec<(Option<Component>, Outline)>; 6] {
    std::array::from_fn(|face| shown(bodies.clone(), size, Axis::ALL[face / 2], face % 2 == 1).into_iter().collect())
}

/// A finding for each face on which two tiles for one configuration differ, with the edges that only one of them has.
pub fn compare_sections(
    name: &str,
    configuration: &str,
    own: &[Vec<(Option<Component>, Outline)>; 6],
    style: &[Vec<(Option<Component>, Outline)>; 6],
) -> Vec<Finding> {
    let mut findings = Vec::new();
    for face in 0..6 {
        let axis = Axis::ALL[face / 2];
        let [a, b] = [own, style].map(|s| s[face].iter().cloned().collect::<Show>());
        if a == b {
            continue;
        }
        let [only_first, only_second] = differences(axis, &a, &b);
        let side = if face % 2 == 1 { "high" } else { "low" };
        let message = format!(
            "override '{name}' does not meet the style's own tiles on its {side} {} face (configuration {configuration}): only the \
             override has [{}], only the style [{}]",
            axis.name(),
            only_first.join("; "),
            only_second.join("; ")
        );
        let finding = Finding::new(FindingKind::Seam, message).of_tiles([name]);
        findings.push(Finding {
            face: Some(axis.name().into()),
            neighbour: Some("the style's own tile".into()),
            configurations: vec![configuration.into()],
            only_first,
            only_second,
            ..finding
        });
    }
    findings
}

pub(super) fn check(manifest: &Manifest, sheets: &Sheets, construction: Option<Construction>, report: &mut Report) {
    let set = assembled(manifest, sheets, report);
    let keys = reachable_keys();
    let needed: Vec<_> = reachable_labels().into_iter().filter(needs_tile).collect();
    let Some(construction) = construction else {
        let count = manifest.tiles.len();
        report.compared =
            format!("the style builds nothing before this is mended; its {count} overrides were not compared");
        return;
    };
    let before = report.findings.len();
    let mut compared = 0;
    let mut bare = BTreeSet::new();
    for &key in &keys {
        if set.variants(key).is_none() && needs_tile(&key.labels()) && construction(key).is_empty() {
            bare.insert(key.labels().map(|l| l.code()));
            let message =
                format!("the style builds nothing for {key}, where something must stand; override it by a mesh");
            let finding = Finding::new(FindingKind::Missing, message);
            report.findings.push(Finding { configurations: vec![key.to_string()], ..finding });
        }
    }
    report.coverage = Some(Coverage { reachable: needed.len(), covered: needed.len() - bare.len() });
    for &key in &keys {
        let Some([first, count]) = set.variants(key) else { continue };
        let blocks: Vec<_> = construction(key).iter().map(|b| (b.component, b.faces())).collect();
        let style = sections(blocks.iter().map(|(c, faces)| (*c, faces)), set.module_um());
        for tile in &set.placed_tiles()[first..first + count] {
            let own = sections(tile.bodies.iter().map(|b| (b.component, &b.polygons)), set.module_um());
            report.findings.extend(compare_sections(&tile.name, &key.to_string(), &own, &style));
            compared += 1;
        }
    }
    let found = report.findings.len() - before;
    report.compared =
        format!("{compared} overridden labellings compared with the style's own tiles: {found} faces differ");
}
