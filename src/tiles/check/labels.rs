//! Checks of sets that look at labels: coverage, claims, and what tiles show each other on the faces between them.

use super::super::claims::{claims, duplicates};
use super::super::label_set::LabelSet;
use super::super::outline::{Outline, difference, outline, reversed};
use super::super::{Component, Manifest};
use super::finding::{Coverage, Finding, FindingKind, Report};
use super::meshes::Sheets;
use crate::cubes::{Axis, CubeKey, Mask, needs_tile, reachable_labels};
use crate::voxels::Label;
use std::collections::{BTreeMap, BTreeSet};

/// What a tile shows on one face: outline by component on vertical faces, of all together on level ones (a wall may stand on a slab).
/// Seen from the positive end of the axis with the body on the low side.
pub(super) type Show = BTreeMap<Option<Component>, Outline>;

/// Builds the set of a manifest from its sheets; everything wrong with its claims is reported.
pub(super) fn assembled(manifest: &Manifest, sheets: &Sheets, report: &mut Report) -> LabelSet {
    let (claims, mistakes) = claims(manifest, &sheets.path, |m| m.is_allowed() && m != Mask::EMPTY);
    mistakes.into_iter().chain(duplicates(manifest, &sheets.path, &claims)).for_each(|m| report.add(m, None));
    LabelSet::assemble(manifest, &claims, &sheets.bodies)
}

pub(super) fn check(manifest: &Manifest, sheets: &Sheets, report: &mut Report) {
    let set = assembled(manifest, sheets, report);
    coverage(&set, report);
    seams(&set, &manifest.open_seams, report);
}

/// Counts labellings with a tile; those without are gathered by the corners they fill.
fn coverage(set: &LabelSet, report: &mut Report) {
    let mut missing: BTreeMap<Mask, (usize, CubeKey)> = BTreeMap::new();
    let mut counts: BTreeMap<Mask, usize> = BTreeMap::new();
    let mut covered = 0;
    for key in reachable_labels().into_iter().filter(needs_tile).map(CubeKey::of_labels) {
        let mask = key.mask();
        if !set.needs(mask) {
            continue;
        }
        *counts.entry(mask).or_default() += 1;
        if set.variants(key).is_some() {
            covered += 1;
        } else {
            missing.entry(mask).or_insert((0, key)).0 += 1;
        }
    }
    report.coverage = Some(Coverage { reachable: counts.values().sum(), covered });
    for (mask, (count, key)) in missing {
        let id = crate::cubes::ThesisId::new(&key.labels(), crate::cubes::CornerOrder::FOrder).0;
        let message = format!(
            "{count} of {} labellings of configuration {mask} have no tile, for example {key} (thesis id {id}); add tiles, widen the \
             patterns of others, or allow mirror and quarter turns",
            counts[&mask]
        );
        let finding = Finding::new(FindingKind::Missing, message);
        report.findings.push(Finding { configurations: vec![key.to_string()], ..finding });
    }
}

/// For each label the first one that no pattern of the set tells apart from it.
fn label_classes(set: &LabelSet) -> [Label; 6] {
    let choices: BTreeSet<_> = set.patterns().flat_map(|p| p.0).collect();
    Label::ALL.map(|label| {
        let alike = |other: &Label| {
            other.is_filled() == label.is_filled() && choices.iter().all(|c| c.allows(*other) == c.allows(label))
        };
        Label::ALL.into_iter().find(alike).unwrap_or(label)
    })
}

/// What the bodies show on a face of a cube.
pub(super) fn shown<'a>(
    bodies: impl Iterator<Item = (Component, &'a Vec<Vec<[i32; 3]>>)> + Clone,
    size: [i32; 3],
    axis: Axis,
    high: bool,
) -> Show {
    let at = if high { size[axis as usize] } else { 0 };
    let components: BTreeSet<Option<Component>> = match axis {
        Axis::X | Axis::Y => bodies.clone().map(|(c, _)| Some(c)).collect(),
        Axis::Z => [None].into(),
    };
    let mut show = Show::new();
    for component in components {
        let own = bodies.clone().filter(|(c, _)| component.is_none_or(|wanted| wanted == *c));
        let drawn = outline(own.flat_map(|(_, polygons)| polygons), axis, at);
        if !drawn.is_empty() {
            show.insert(component, if high { drawn } else { reversed(&drawn) });
        }
    }
    show
}

/// Who shows something on a face: a placed tile (none for an empty cube), and a cube where it does.
type Shower = (Option<usize>, CubeKey);

/// Everything shown on one kind of face: by what is shown, the showers on its low and high side.
type Shows = BTreeMap<usize, [BTreeMap<String, Shower>; 2]>;

fn seams(set: &LabelSet, open: &[String], report: &mut Report) {
    let classes = label_classes(set);
    let size = set.module_um();
    let mut interned: BTreeMap<Show, usize> = BTreeMap::from([(Show::new(), 0)]);
    let mut of_tile: BTreeMap<usize, [usize; 6]> = BTreeMap::new();
    let mut seen: BTreeSet<[Label; 8]> = BTreeSet::new();
    let mut faces: BTreeMap<(Axis, [Label; 4]), Shows> = BTreeMap::new();
    // Tiles may be drawn for labels that rules keep out of houses; they are compared all the same.
    let drawn = set.patterns().filter_map(|p| p.common(&p)).filter(|key| key.mask().is_allowed()).map(CubeKey::labels);
    for labels in std::iter::once([Label::Empty; 8]).chain(reachable_labels()).chain(drawn) {
        let key = CubeKey::of_labels(labels);
        let classed = labels.map(|l| classes[l.code() as usize]);
        if !seen.insert(classed) {
            continue;
        }
        let placed: Vec<Option<usize>> = match set.variants(key) {
            Some([first, count]) => (first..first + count).map(Some).collect(),
            None if !needs_tile(&labels) || !set.needs(key.mask()) => vec![None],
            // Reported as missing.
            None => continue,
        };
        for tile in placed {
            let ids = tile.map_or([0; 6], |tile| {
                *of_tile.entry(tile).or_insert_with(|| {
                    let bodies = set.placed_tiles()[tile].bodies.iter().map(|b| (b.component, &b.polygons));
                    std::array::from_fn(|face| {
                        let show = shown(bodies.clone(), size, Axis::ALL[face / 2], face % 2 == 1);
                        let next = interned.len();
                        *interned.entry(show).or_insert(next)
                    })
                })
            });
            let name = tile.map_or(String::new(), |tile| set.placed_tiles()[tile].name.clone());
            for (face, id) in ids.into_iter().enumerate() {
                let (axis, high) = (Axis::ALL[face / 2], face % 2 == 1);
                let shows = faces.entry((axis, face_labels(&classed, axis, high))).or_default();
                // A cube shows its high face as the one on the low side of the seam.
                let side = &mut shows.entry(id).or_default()[usize::from(!high)];
                side.entry(name.clone()).or_insert((tile, key));
            }
        }
    }
    let shows: BTreeMap<usize, &Show> = interned.iter().map(|(show, id)| (*id, show)).collect();
    let before = report.findings.len();
    let compared = faces.len();
    let mut said = BTreeSet::new();
    let mut accepted = 0;
    for ((axis, labels), on_face) in &faces {
        let entry = open_seam(*axis, labels);
        if open.contains(&entry) {
            accepted += 1;
            blank(*axis, on_face, &shows, report);
            continue;
        }
        let known = report.findings.len();
        differing(*axis, on_face, &shows, &mut said, report);
        report.findings[known..].iter_mut().for_each(|f| f.open_seam = Some(entry.clone()));
    }
    let found = report.findings.len() - before;
    let plural = if found == 1 { "" } else { "s" };
    report.compared = format!(
        "{compared} kinds of face compared along x, y and z between {} tiles in place: {found} seam{plural} open{}",
        of_tile.len(),
        if accepted > 0 { format!(", {accepted} accepted by the manifest") } else { String::new() }
    );
}

/// Reports tiles that show nothing on an upright kind of face on which others do: what tiles show there may be accepted as different,
/// but a tile that does not reach its face at all is too small or lies elsewhere.
fn blank(axis: Axis, on_face: &Shows, shows: &BTreeMap<usize, &Show>, report: &mut Report) {
    let drawn = on_face.iter().filter(|(id, _)| !shows[*id].is_empty());
    let Some((&usual, others)) =
        drawn.max_by_key(|(id, sides)| (sides[0].len() + sides[1].len(), std::cmp::Reverse(**id)))
    else {
        return;
    };
    if axis == Axis::Z {
        return;
    }
    for (&id, sides) in on_face.iter().filter(|(id, _)| shows[*id].is_empty()) {
        for (side, names) in sides.iter().enumerate() {
            let Some((neighbour, (_, other))) = others[1 - side].iter().chain(&others[side]).next() else { continue };
            for (name, (tile, key)) in names {
                if tile.is_some() {
                    let (finding, keys) = seam(axis, [name, neighbour], [shows[&id], shows[&usual]], [*key, *other]);
                    report.findings.push(Finding { configurations: keys.map(|k| k.to_string()).into(), ..finding });
                }
            }
        }
    }
}

/// A kind of face as `open_seams` names it.
fn open_seam(axis: Axis, labels: &[Label; 4]) -> String {
    let codes: String = labels.iter().map(|l| l.code().to_string()).collect();
    format!("{} {codes}", axis.name())
}

/// The labels of a face in corner order.
fn face_labels(labels: &[Label; 8], axis: Axis, high: bool) -> [Label; 4] {
    let bit = 1usize << axis as usize;
    let mut corners = (0..8usize).filter(|c| (c & bit != 0) == high);
    std::array::from_fn(|_| corners.next().map_or(Label::Empty, |c| labels[c]))
}

/// Reports every tile that shows something else on a kind of face than most tiles do.
fn differing(
    axis: Axis,
    on_face: &Shows,
    shows: &BTreeMap<usize, &Show>,
    said: &mut BTreeSet<(String, Axis, usize, usize, usize)>,
    report: &mut Report,
) {
    let showers = |sides: &[BTreeMap<String, Shower>; 2]| sides[0].len() + sides[1].len();
    let most = on_face.iter().max_by_key(|(id, sides)| (showers(sides), std::cmp::Reverse(**id)));
    let Some((&usual, others)) = most else { return };
    for (&id, sides) in on_face.iter().filter(|(id, _)| **id != usual) {
        for (side, names) in sides.iter().enumerate() {
            // A cube meets those on the other side; when nothing usual stands there, the difference is among its own side.
            let Some((neighbour, (_, other_key))) =
                others[1 - side].iter().next().or_else(|| others[side].iter().next())
            else {
                continue;
            };
            for (name, (_, key)) in names {
                if !said.insert((name.clone(), axis, side, id, usual)) {
                    continue;
                }
                let (finding, keys) = seam(axis, [name, neighbour], [shows[&id], shows[&usual]], [*key, *other_key]);
                report.findings.push(Finding { configurations: keys.map(|k| k.to_string()).into(), ..finding });
            }
        }
    }
}

/// A difference between what two tiles show on a face.
pub(super) fn seam<K: std::fmt::Display + Copy>(
    axis: Axis,
    [name, neighbour]: [&str; 2],
    [own, usual]: [&Show; 2],
    keys: [K; 2],
) -> (Finding, [K; 2]) {
    let [only_first, only_second] = differences(axis, own, usual);
    let called = |name: &str| if name.is_empty() { "an empty cube".into() } else { format!("tile '{name}'") };
    let message = format!(
        "the {} face between {} (in {}) and {} (in {}) differs: only the first has [{}], only the second [{}]",
        axis.name(),
        called(name),
        keys[0],
        called(neighbour),
        keys[1],
        only_first.join("; "),
        only_second.join("; ")
    );
    let finding = Finding::new(FindingKind::Seam, message).of_tiles([name, neighbour]);
    let (face, neighbour) = (Some(axis.name().into()), Some(neighbour.into()));
    (Finding { face, neighbour, only_first, only_second, ..finding }, keys)
}

/// The edges that only one of two faces has, as text in mm.
pub(super) fn differences(axis: Axis, own: &Show, other: &Show) -> [Vec<String>; 2] {
    let none = Outline::new();
    let mut texts = [Vec::new(), Vec::new()];
    let components: BTreeSet<_> = own.keys().chain(other.keys()).collect();
    for component in components {
        let [a, b] = [own, other].map(|s| s.get(component).unwrap_or(&none));
        for (n, only) in difference(a, b).iter().enumerate() {
            let name = component.map_or("outline", Component::name);
            texts[n]
                .extend(only.iter().map(|[from, to]| format!("{name} {} - {}", place(axis, *from), place(axis, *to))));
        }
    }
    texts
}

/// A point of a face with the names of its two axes, mm.
fn place(axis: Axis, point: [i32; 2]) -> String {
    let names = [0, 1].map(|n| Axis::ALL[(axis as usize + 1 + n) % 3].name());
    let mm = point.map(|um| f64::from(um) / 1000.0);
    format!("{} {} {} {}", names[0], mm[0], names[1], mm[1])
}
