//! Rules about windows and doors.

use super::report::{Finding, Report};
use super::site::{Site, Work};
use crate::voxels::{FacadeOpening, Label, STOREY_MODULES};

/// Layers an opening spans.
fn rows(opening: &FacadeOpening) -> std::ops::Range<usize> {
    opening.k..opening.k + opening.height
}

/// Whether `depth` cells in front of column n are empty over the opening's height.
fn free_in_front(site: &Site, opening: &FacadeOpening, n: usize, depth: usize) -> bool {
    (1..=depth).all(|out| rows(opening).all(|k| !site.label(opening.column(n as isize, out as isize), k).is_filled()))
}

fn is_door(opening: &&FacadeOpening) -> bool {
    opening.label == Label::Opening
}

/// The plate under the opening's storey.
fn plate_k(site: &Site, opening: &FacadeOpening) -> Option<usize> {
    site.reading.storeys.get(opening.storey).map(|s| s.plate_k)
}

/// A door wide and high enough, from free ground into the house and not onto a stair.
pub(super) fn is_entrance(site: &Site, opening: &FacadeOpening) -> bool {
    let (set, module) = (site.settings, site.house.voxels.module.size_m);
    let clear = |size: f64, n: usize| size * n as f64 - 2.0 * set.door_frame_m + 1e-9;
    let inside = opening.column(0, -1);
    let on_stair = site
        .house
        .stairs
        .iter()
        .filter(|s| s.storey == opening.storey)
        .any(|s| s.flight_cells().contains(&inside) || s.middle_landing().contains(&inside));
    is_door(&opening)
        && plate_k(site, opening) == Some(0)
        && opening.k == 1
        && clear(module[opening.along()], opening.width) >= set.door_width_min_m
        && clear(module[2], opening.height) >= set.door_height_min_m
        && (0..opening.width).all(|n| free_in_front(site, opening, n, 1))
        && site.reading.storeys[opening.storey].plan.has(inside)
        && !on_stair
}

pub(super) fn entrance(site: &Site, _: &mut Work, report: &mut Report) {
    let found = site.reading.openings.iter().filter(|o| is_entrance(site, o)).count();
    let missing = site.settings.entrances_min.saturating_sub(found);
    report.add(missing as f64, || {
        let doors = site.reading.openings.iter().filter(is_door).flat_map(|o| o.voxels()).collect();
        let message = format!("{found} doors serve as entrance, {missing} more needed");
        Finding::new(
            doors,
            message,
            "put a door (4) of four layers from k = 1 into the ground storey's facade, with a free cell in front and no stair behind it",
        )
    });
}

pub(super) fn door_count(site: &Site, _: &mut Work, report: &mut Report) {
    let most = site.settings.doors_per_storey_max;
    for storey in &site.reading.storeys {
        let doors = || site.reading.openings.iter().filter(is_door).filter(|o| o.storey == storey.index);
        let count = doors().count();
        report.add(count.saturating_sub(most) as f64, || {
            let voxels = doors().flat_map(|o| o.voxels()).collect();
            let message = format!("storey {} has {count} exterior doors, at most {most} are allowed", storey.index);
            Finding::new(voxels, message, "turn doors into windows or wall")
        });
    }
}

/// Doors of the ground storey, or of the others, that `good` refuses; one violation each.
fn doors(
    site: &Site,
    report: &mut Report,
    ground: bool,
    good: impl Fn(&FacadeOpening, usize) -> bool,
    says: [&str; 2],
) {
    for door in site.reading.openings.iter().filter(is_door) {
        let Some(k) = plate_k(site, door) else { continue };
        if (k == 0) == ground && !good(door, k) {
            report.add(door.width as f64, || {
                let message = format!("the door at {:?} of storey {} {}", door.cell, door.storey, says[0]);
                Finding::new(door.voxels().collect(), message, says[1])
            });
        }
    }
}

pub(super) fn doors_ground(site: &Site, _: &mut Work, report: &mut Report) {
    let good = |door: &FacadeOpening, _| door.k == 1 && (0..door.width).all(|n| free_in_front(site, door, n, 1));
    let says =
        ["does not stand on the slab or has no free ground in front", "start it at k = 1 and free the cell outside"];
    doors(site, report, true, good, says);
}

pub(super) fn decks(site: &Site, _: &mut Work, report: &mut Report) {
    let good = |door: &FacadeOpening, k: usize| {
        door.k == k + 1
            && (0..door.width)
                .all(|n| free_in_front(site, door, n, 1) && site.label(door.column(n as isize, 1), k).is_slab())
    };
    let says = ["opens onto no deck at its own level", "turn it into a window, or build a deck in front of it"];
    doors(site, report, false, good, says);
}

/// Infill voxels in storage order.
fn infill<'s>(site: &'s Site) -> impl Iterator<Item = [usize; 3]> + 's {
    let voxels = &site.house.voxels;
    site.filled_voxels().map(|(v, _)| v).filter(|&v| voxels.get(v).is_infill())
}

fn open_sides(site: &Site, v: [usize; 3]) -> usize {
    let at = site.index(v) as isize;
    site.sides().into_iter().filter(|step| !site.filled((at + step) as usize)).count()
}

pub(super) fn in_facade(site: &Site, _: &mut Work, report: &mut Report) {
    let buried = infill(site).filter(|&v| open_sides(site, v) == 0);
    report.voxels(buried, "of windows or doors face no outside", "make them base (1): openings are one voxel deep");
    let homeless = |o: &FacadeOpening, n: usize| {
        let storey = site.reading.storeys.get(o.storey);
        !storey.is_some_and(|s| {
            o.k > s.plate_k && o.k + o.height <= s.plate_k + STOREY_MODULES && s.plan.has(o.column(n as isize, 0))
        })
    };
    for opening in &site.reading.openings {
        let behind = |n: usize, k: usize| site.label(opening.column(n as isize, -1), k) == Label::Base;
        let wrong = (0..opening.width)
            .filter(|&n| homeless(opening, n) || !rows(opening).all(|k| behind(n, k)))
            .map(|n| opening.column(n as isize, 0))
            .map(|[x, y]| [x as usize, y as usize, opening.k]);
        report.voxels(
            wrong,
            "begin a column of a window or door with no room of a storey behind it",
            "put base (1) behind it, or make it base",
        );
    }
}

pub(super) fn corners(site: &Site, _: &mut Work, report: &mut Report) {
    let wrong = infill(site).filter(|&v| open_sides(site, v) >= 2);
    report.voxels(wrong, "of windows or doors stand at a corner", "move the opening one module along the facade");
}

pub(super) fn surround(site: &Site, _: &mut Work, report: &mut Report) {
    for o in &site.reading.openings {
        let is = |n: isize, k: usize| site.label(o.column(n, 0), k);
        let sides =
            rows(o).flat_map(|k| [(-1, k), (o.width as isize, k)]).filter(|&(n, k)| is(n, k) != Label::Base).count();
        let above = (0..o.width as isize).filter(|&n| is(n, o.k + o.height) != Label::Base).count();
        let carries = |label: Label| label.is_slab() || (label == Label::Base && o.label == Label::Window);
        let below = (0..o.width as isize).filter(|&n| o.k == 0 || !carries(is(n, o.k - 1))).count();
        report.add((sides + above + below) as f64, || {
            let message = format!(
                "the {} at {:?}, layer {}, lacks base in {sides} places beside and {above} above it, and base or slab in {below} below",
                o.label.name(),
                o.cell,
                o.k
            );
            Finding::new(o.voxels().collect(), message, "make the opening smaller or move it, so that wall (1) frames it")
        });
    }
}
