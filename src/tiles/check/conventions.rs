//! Mistakes of unit, axes, pivot and corner order: each makes a thousand other findings, so the likely cause is named.

use super::super::{AxisMap, Manifest, UNITS};
use super::finding::{Finding, FindingKind, Report};
use super::meshes::{Sample, Sheets};
use crate::cubes::{Corner, CornerOrder, Mask};

/// Extents up to this many modules, and down to its inverse, are taken as drawn in the right unit: no two units are closer.
const UNIT_RANGE: f64 = 2.2;

/// How near extents and places must be to a whole module to say something, in modules.
const NEAR: f64 = 0.12;

/// Edges of a module, mm: below a brick's length and above a storey it is no module of a house.
const MODULE_MM: [f64; 2] = [100.0, 3500.0];

/// Another reading is named when it leaves less than half of the boundary at empty corners that the stated one does, and when
/// that is at least this share of it.
const BETTER: f64 = 0.02;

pub(super) fn check(manifest: &Manifest, sheets: &Sheets, report: &mut Report) {
    odd_module(manifest, report);
    let bounds: Vec<[[f64; 3]; 2]> = sheets.bounds_mm.iter().flatten().copied().collect();
    let Some(all) = bounds.iter().copied().reduce(|[al, ah], [bl, bh]| {
        [[0, 1, 2].map(|i| f64::min(al[i], bl[i])), [0, 1, 2].map(|i| f64::max(ah[i], bh[i]))]
    }) else {
        return;
    };
    let module = manifest.module_mm().map(f64::from);
    let unit_is_wrong = wrong_unit(manifest, &bounds, module, report);
    if !unit_is_wrong {
        for (entry, bounds) in manifest.tiles.iter().zip(&sheets.bounds_mm) {
            let Some(bounds) = bounds else { continue };
            // One tile in another unit: far too large, or too small to be a part of a building.
            let size = modules(*bounds, module).into_iter().fold(0.0, f64::max);
            if !(0.02..=10.0).contains(&size) {
                let message = format!(
                    "tile {} is {size:.4} modules large while the others fit: it looks drawn in {}, not in {}; scale it",
                    entry.name,
                    likely_unit(manifest, size).map_or("another unit", |u| u),
                    manifest.unit
                );
                let finding = Finding::new(FindingKind::Unit, message).of_key("unit");
                report.findings.push(finding.of_tiles([entry.name.as_str()]));
            }
        }
    }
    let turned = orientation(manifest, sheets, report);
    if !unit_is_wrong && !turned {
        lying(manifest, all, module, report);
        displaced(manifest, all, module, report);
    }
}

/// A module that no house has, as when the unit of module and files alike is wrong.
fn odd_module(manifest: &Manifest, report: &mut Report) {
    let edges = manifest.module_mm().map(f64::from);
    let fits = |scale: f64| edges.iter().all(|e| (MODULE_MM[0]..=MODULE_MM[1]).contains(&(e * scale)));
    if fits(1.0) {
        return;
    }
    let others = UNITS.iter().filter(|(name, _)| *name != "cube" && *name != manifest.unit);
    let advice = match others.into_iter().find(|(_, mm)| fits(mm / manifest.to_mm())) {
        Some((unit, _)) => format!("state \"unit\": \"{unit}\" if the numbers are meant so"),
        None => "correct module_size".into(),
    };
    let [x, y, z] = edges.map(|mm| mm / 1000.0);
    let message = format!(
        "the module is {x} x {y} x {z} m in the stated unit {}, which no house is built of; {advice}",
        manifest.unit
    );
    report.findings.push(Finding::new(FindingKind::Unit, message).of_key("unit"));
}

/// Extents in modules.
fn modules([low, high]: [[f64; 3]; 2], module: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|a| (high[a] - low[a]) / module[a])
}

/// The unit in which something of this many modules would be about one module large.
fn likely_unit(manifest: &Manifest, size: f64) -> Option<&'static str> {
    let rescaled = |mm: f64| size * mm / manifest.to_mm();
    let fits = |mm: f64| (1.0 / UNIT_RANGE..=UNIT_RANGE).contains(&rescaled(mm));
    let distance = |mm: f64| rescaled(mm).ln().abs();
    // A cube of edge one is as many modules large as its shortest edge says.
    let one = manifest.module_mm().map(f64::from).into_iter().fold(f64::INFINITY, f64::min) / manifest.to_mm();
    if manifest.unit != "cube" && (size * one - 1.0).abs() < 0.05 {
        return Some("cube");
    }
    let units = UNITS.iter().filter(|(name, mm)| *name != manifest.unit && *name != "cube" && fits(*mm));
    units.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1))).map(|(name, _)| *name)
}

fn wrong_unit(manifest: &Manifest, bounds: &[[[f64; 3]; 2]], module: [f64; 3], report: &mut Report) -> bool {
    // The middle tile stands for the set, so that one wrong tile is not taken for all.
    let mut sizes: Vec<f64> = bounds.iter().map(|b| modules(*b, module).into_iter().fold(0.0, f64::max)).collect();
    sizes.sort_by(f64::total_cmp);
    let size = sizes[sizes.len() / 2];
    let low = if bounds.len() > 3 { 1.0 / UNIT_RANGE } else { 0.1 };
    if size == 0.0 || (low..=UNIT_RANGE).contains(&size) {
        return false;
    }
    let likely = match likely_unit(manifest, size) {
        Some(unit) => format!("the files look drawn in {unit}: state \"unit\": \"{unit}\" (and module_size in it)"),
        None => "state the unit of the files, or correct module_size".into(),
    };
    let message = format!("the tiles are {size:.4} modules large in the stated unit {}; {likely}", manifest.unit);
    report.findings.push(Finding::new(FindingKind::Unit, message).of_key("unit"));
    true
}

/// Whether another order of corners or another up axis explains the shapes much better than the stated one.
fn orientation(manifest: &Manifest, sheets: &Sheets, report: &mut Report) -> bool {
    let order = CornerOrder::from_name(&manifest.corner_order).unwrap_or_default();
    let other = match order {
        CornerOrder::FOrder => CornerOrder::BoxCorners,
        CornerOrder::BoxCorners => CornerOrder::FOrder,
    };
    let reordered = |mask: Mask| {
        // The digits that gave the mask, read in the other order.
        let bits = (0..8).filter(|&n| mask.0 >> order.corners()[n] & 1 == 1);
        Mask(bits.fold(0, |m, n| m | 1 << other.corners()[n]))
    };
    // Tiles whose pattern is no configuration, or leaves an octant empty that the drawing names.
    let wrong = |mask: &dyn Fn(Mask) -> Mask| {
        let is_wrong = |(samples, drawn): &(&Vec<Sample>, &Mask)| {
            let filled = mask(**drawn);
            let is_filled = |octant: u8| Corner::new(octant).is_none_or(|corner| filled.has(corner));
            !filled.is_allowed() || !samples.iter().filter_map(|s| s.octant).all(is_filled)
        };
        sheets.samples.iter().zip(&sheets.drawn).filter(is_wrong).count()
    };
    let (mistaken, cured) = (wrong(&|m| m), wrong(&reordered));
    if mistaken > 0 && cured == 0 {
        let message = format!(
            "{mistaken} of {} patterns are no configuration, or leave empty what their drawing names; with \"corner_order\": \"{}\" \
             none would: state that order",
            manifest.tiles.len(),
            other.name()
        );
        report.findings.push(Finding::new(FindingKind::CornerOrder, message).of_key("corner_order"));
        return true;
    }
    let total: f64 = sheets.samples.iter().flatten().map(|s| s.weight).sum();
    if total <= 0.0 {
        return false;
    }
    let score = |map: AxisMap, by_name: bool, mask: &dyn Fn(Mask) -> Mask| -> f64 {
        let tiles = sheets.samples.iter().zip(&sheets.drawn);
        let inside = |(samples, drawn): (&Vec<Sample>, &Mask)| -> f64 {
            let filled = mask(*drawn);
            let hit = |sample: &&Sample| {
                let at = map.turn(sample.point.map(|c| c - 0.5));
                let nearest = Corner::at(at.map(|c| u8::from(c > 0.0)));
                // Octants that the drawing names say more about the order of corners than shapes; of axes they say nothing.
                let named = sample.octant.and_then(Corner::new).filter(|_| by_name);
                filled.has(named.unwrap_or(nearest))
            };
            samples.iter().filter(hit).map(|s| s.weight).sum()
        };
        tiles.map(inside).sum::<f64>() / total
    };
    let same = |m: Mask| m;
    // The turn that makes z-up files of y-up ones, and the one the other way.
    let back = AxisMap::parse("x,-z,y").unwrap_or(AxisMap::Z_UP);
    let [upright, to_y, to_z] = [AxisMap::Z_UP, AxisMap::Y_UP, back].map(|map| score(map, false, &same));
    let [counted, corners] = [score(AxisMap::Z_UP, true, &same), score(AxisMap::Z_UP, true, &reordered)];
    let clearly = |stated: f64, other: f64| (1.0 - other) < 0.5 * (1.0 - stated) && other - stated > BETTER;
    let turned = to_y.max(to_z);
    let is_order = clearly(counted, corners) && (corners >= turned || !clearly(upright, turned));
    if !is_order && !clearly(upright, turned) {
        return false;
    }
    let share = |s: f64| format!("{:.0} %", s * 100.0);
    let (kind, key, message) = if is_order {
        let message = format!(
            "only {} of the tiles' boundary lies at corners that their patterns fill, but {} would with \"corner_order\": \"{}\"; \
             state that order",
            share(counted),
            share(corners),
            other.name()
        );
        (FindingKind::CornerOrder, "corner_order", message)
    } else {
        let stated = stated_axes(manifest);
        let likely = stated.then(if to_y >= turned { AxisMap::Y_UP } else { back });
        let message = format!(
            "only {} of the tiles' boundary lies at corners that their patterns fill, but {} would after turning: the tiles lie on \
             their side; the manifest states \"up_axis\": \"{}\", state \"{}\"",
            share(upright),
            share(turned),
            stated.up_axis(),
            likely.up_axis()
        );
        (FindingKind::UpAxis, "up_axis", message)
    };
    report.findings.push(Finding::new(kind, message).of_key(key));
    true
}

/// The axes that the manifest states for all tiles.
fn stated_axes(manifest: &Manifest) -> AxisMap {
    AxisMap::parse(&manifest.up_axis).unwrap_or(AxisMap::Z_UP)
}

/// Extents that fit the module only with y and z exchanged.
fn lying(manifest: &Manifest, all: [[f64; 3]; 2], module: [f64; 3], report: &mut Report) {
    let [x, y, z] = module;
    let fits = |module: [f64; 3]| modules(all, module).into_iter().all(|e| (e - 1.0).abs() < NEAR);
    if !fits(module) && fits([x, z, y]) {
        let stated = stated_axes(manifest);
        let likely = if stated == AxisMap::Y_UP { "z" } else { "y" };
        let message = format!(
            "the tiles fit the module only with y and z exchanged: they lie on their side; the manifest states \"up_axis\": \"{}\", \
             state \"{likely}\"",
            stated.up_axis()
        );
        report.findings.push(Finding::new(FindingKind::UpAxis, message).of_key("up_axis"));
    }
}

/// Extents that fit the module, beside the cube.
fn displaced(manifest: &Manifest, [low, high]: [[f64; 3]; 2], module: [f64; 3], report: &mut Report) {
    let fits = modules([low, high], module).into_iter().all(|e| (e - 1.0).abs() < NEAR);
    let off = [0, 1, 2].map(|a| low[a] / module[a]);
    if !fits || off.into_iter().all(|o| o.abs() < NEAR) {
        return;
    }
    let tile = manifest.tiles.first();
    let origin = tile.map_or([0.0; 3], |t| manifest.axes(t).origin_mm);
    let should = [0, 1, 2].map(|a| ((origin[a] - low[a]) / module[a] * 2.0).round() / 2.0);
    let likely = match should {
        [0.0, 0.0, 0.0] => "\"corner\"".to_owned(),
        [0.5, 0.5, 0.5] => "\"centre\"".into(),
        [0.5, 0.5, 0.0] => "\"base_centre\"".into(),
        at => format!("the point at {at:?} of the module"),
    };
    let place = off.map(|o| format!("{o:.2}")).join(", ");
    let message = format!(
        "the tiles are as large as the module but stand {place} modules beside the cube; the origin of the files seems to be {likely}: \
         state it as \"pivot\""
    );
    report.findings.push(Finding::new(FindingKind::Pivot, message).of_key("pivot"));
}
