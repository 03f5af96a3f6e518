//! Rules about plates and the height between them.

use super::report::Report;
use super::site::{Site, Work};
use crate::voxels::read::room_over;
use crate::voxels::{Label, STOREY_MODULES, Storey};

pub(super) fn complete(site: &Site, _: &mut Work, report: &mut Report) {
    let voxels = &site.house.voxels;
    let wrong = site.filled_voxels().map(|(v, _)| v).filter(|&v| match (v[2], v[2] % STOREY_MODULES) {
        (0, _) => false,
        (_, 0) => !voxels.get(v).is_slab() && !site.stair_void(v),
        _ => voxels.get(v) == Label::Floor,
    });
    report.voxels(
        wrong,
        "break a plate: not floor at a storey level, or floor between the levels",
        "make the whole layer k = 6, 12, ... floor (2), leaving out only the cells of a stair's void; use base (1) elsewhere",
    );
}

/// Cells of a storey's plan outside the stair voids above, with their clear height in metres.
fn heights<'s>(site: &'s Site, storey: &'s Storey) -> impl Iterator<Item = ([usize; 2], f64)> + 's {
    let above = storey.plate_k + STOREY_MODULES;
    storey.plan.iter().filter(move |&[x, y]| above >= site.shape[2] || !site.stair_void([x, y, above])).map(|cell| {
        (cell, room_over(&site.house.voxels, cell, storey.plate_k).clear_height_m(&site.house.voxels.module))
    })
}

pub(super) fn clear_height_min(site: &Site, _: &mut Work, report: &mut Report) {
    let least = site.settings.clear_height_min_m - 1e-9;
    for storey in &site.reading.storeys {
        let k = storey.plate_k;
        let low = heights(site, storey).filter(|(_, h)| *h < least).map(|([x, y], _)| [x, y, k + 1]);
        report.voxels(low, "stand in rooms lower than the least clear height", "raise the room by a layer");
    }
    // Rooms on the foundation that are too low to be part of any storey.
    if let Some(base) = site.reading.plates.first().filter(|p| p.k == 0) {
        let storey = site.reading.storeys.first().filter(|s| s.plate_k == 0);
        let sz = site.stride[2];
        let low = base
            .cells
            .iter()
            .filter(|&[x, y]| site.shape[2] > 1 && site.filled(site.index([x, y, 0]) + sz))
            .filter(|c| !storey.is_some_and(|s| s.plan.has(c.map(|c| c as isize))))
            .map(|[x, y]| [x, y, 1]);
        report.voxels(low, "stand on the foundation in rooms lower than 2.4 m", "raise the room to a full storey");
    }
}

pub(super) fn clear_height_max(site: &Site, _: &mut Work, report: &mut Report) {
    let most = site.settings.clear_height_min_m * site.settings.clear_height_max_factor + 1e-9;
    for storey in &site.reading.storeys {
        let k = storey.plate_k;
        let roof_space = |[x, y]: [usize; 2]| k > 0 && !room_over(&site.house.voxels, [x, y], k).under_slab;
        let high =
            heights(site, storey).filter(|&(cell, h)| h > most && !roof_space(cell)).map(|([x, y], _)| [x, y, k + 1]);
        report.voxels(
            high,
            "stand in rooms higher than 1.5 times the least clear height",
            "close the plate above with floor (2), or put a stair into the void",
        );
    }
}
