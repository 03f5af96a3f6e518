//! Rules about each stair.

use super::report::{Finding, Report};
use super::site::{Site, Work};
use crate::voxels::{LINING_M, Plan, SLAB_ZONE_M, STOREY_MODULES, Stair, Storey};

/// The storeys a stair joins; `None` when one of them is missing.
fn storeys<'s>(site: &'s Site, stair: &Stair) -> Option<(&'s Storey, &'s Storey)> {
    let lower = site.reading.storeys.get(stair.storey)?;
    let upper = site.reading.storeys.get(stair.storey + 1)?;
    (upper.plate_k == lower.plate_k + STOREY_MODULES).then_some((lower, upper))
}

/// Cells on the lower storey that a stair takes: foot, flights and the landing between them.
fn lanes(stair: &Stair) -> impl Iterator<Item = [isize; 2]> {
    [stair.foot()].into_iter().chain(stair.flight_cells()).chain(stair.middle_landing())
}

/// The cell's voxel in layer k, for messages; cells left of or below the array are moved to its edge.
fn voxel([x, y]: [isize; 2], k: usize) -> [usize; 3] {
    [x.max(0) as usize, y.max(0) as usize, k]
}

fn slab(site: &Site, [x, y]: [isize; 2], k: usize) -> bool {
    site.label([x, y], k).is_slab()
}

pub(super) fn inside(site: &Site, _: &mut Work, report: &mut Report) {
    for (n, stair) in site.house.stairs.iter().enumerate() {
        let Some((lower, upper)) = storeys(site, stair) else {
            report.add(6.0, || {
                let message =
                    format!("stair {n} climbs from storey {}, but it or the one above is missing", stair.storey);
                Finding::new(Vec::new(), message, "remove the stair or build the storey")
            });
            continue;
        };
        let outside = |plan: &Plan, cell| !plan.interior(cell);
        let below = lanes(stair).filter(|&c| outside(&lower.plan, c)).map(|c| voxel(c, lower.plate_k + 1));
        let above = (stair.void_cells().into_iter().chain([stair.head()]))
            .filter(|&c| outside(&upper.plan, c))
            .map(|c| voxel(c, upper.plate_k + 1));
        let fix = "move the stair so that wall cells stay free of it";
        report.voxels(below.chain(above), "of a stair lie outside the lining of the storey they belong to", fix);
        let hanging = [(stair.foot(), lower.plate_k), (stair.head(), upper.plate_k)]
            .into_iter()
            .filter(|&(c, k)| !slab(site, c, k))
            .map(|(c, k)| voxel(c, k));
        report.voxels(hanging, "under a stair's foot or head carry no slab", "close the plate under the landing");
        let shared = site.house.stairs[..n]
            .iter()
            .filter(|other| other.storey == stair.storey)
            .flat_map(|other| lanes(stair).filter(move |&c| lanes(other).any(|o| o == c)))
            .map(|c| voxel(c, lower.plate_k + 1));
        report.voxels(shared, "belong to two stairs", "move or remove one of the stairs");
    }
}

pub(super) fn void(site: &Site, _: &mut Work, report: &mut Report) {
    for stair in &site.house.stairs {
        let Some((lower, _)) = storeys(site, stair) else { continue };
        let k = lower.plate_k + STOREY_MODULES;
        let covered = stair.void_cells().into_iter().filter(|&c| slab(site, c, k)).map(|c| voxel(c, k));
        report.voxels(covered, "over a stair still carry floor", "leave the plate out over the stair: label base (1)");
    }
}

pub(super) fn width(site: &Site, _: &mut Work, report: &mut Report) {
    let module = site.house.voxels.module.size_m;
    let free = module[0].min(module[1]);
    let least = site.settings.stair_width_min_m - 1e-9;
    for stair in &site.house.stairs {
        let Some((lower, upper)) = storeys(site, stair) else { continue };
        // A re-entrant corner of the facade pushes 300 mm of lining into the cell diagonally inside it.
        let narrow = |plan: &Plan, [x, y]: [isize; 2]| {
            let corner = [[-1, -1], [1, -1], [-1, 1], [1, 1]].iter().any(|d| !plan.has([x + d[0], y + d[1]]));
            plan.interior([x, y]) && free - if corner { LINING_M } else { 0.0 } < least
        };
        let cells = lanes(stair)
            .filter(|&c| narrow(&lower.plan, c))
            .map(|c| voxel(c, lower.plate_k + 1))
            .chain(Some(stair.head()).filter(|&c| narrow(&upper.plan, c)).map(|c| voxel(c, upper.plate_k + 1)));
        report.voxels(cells, "leave a stair too narrow beside a corner of the wall", "move the stair one cell inwards");
    }
}

pub(super) fn headroom(site: &Site, _: &mut Work, report: &mut Report) {
    let dz = site.house.voxels.module.size_m[2];
    let least = site.settings.stair_headroom_min_m - 1e-9;
    for stair in &site.house.stairs {
        let Some((lower, _)) = storeys(site, stair) else { continue };
        let k = lower.plate_k + STOREY_MODULES;
        let soffit = STOREY_MODULES as f64 * dz - SLAB_ZONE_M;
        let flights = stair.flight_cells().into_iter().enumerate().map(|(n, c)| (n + 1, c));
        let landing = stair.middle_landing().into_iter().map(|c| (3, c));
        let low = flights
            .chain(landing)
            .filter(|&(climbed, c)| slab(site, c, k) && soffit - (climbed as f64 * dz) < least)
            .map(|(_, c)| voxel(c, k));
        report.voxels(low, "of floor leave less than the least headroom over a stair", "leave the plate out there");
    }
}
