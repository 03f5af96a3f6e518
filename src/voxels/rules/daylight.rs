//! Rules about glass.

use super::report::{Finding, Report};
use super::site::{Site, Work};
use crate::voxels::{FacadeOpening, Storey, VoxelArray};

/// Glass of an opening that counts as daylight, m2: the share of its columns in front of which `view_m` are free over the
/// opening's height. Rules and objectives share this notion of glass.
pub fn glass_in_view_m2(voxels: &VoxelArray, opening: &FacadeOpening, view_m: f64) -> f64 {
    let glass = opening.glass_area_m2(&voxels.module);
    if glass <= 0.0 {
        return 0.0;
    }
    let depth = (view_m / voxels.module.size_m[1 - opening.along()] - 1e-9).ceil().max(0.0) as isize;
    let free = |column: isize| {
        (1..=depth).all(|out| {
            let [x, y] = opening.column(column, out);
            (opening.k..opening.k + opening.height).all(|k| !voxels.at([x, y, k as isize]).is_filled())
        })
    };
    let count = (0..opening.width as isize).filter(|&column| free(column)).count();
    glass * count as f64 / opening.width as f64
}

/// Glass per orientation of a storey, m2.
fn glass_by_facing(site: &Site, storey: &Storey) -> [f64; 4] {
    let mut glass = [0.0; 4];
    for opening in site.reading.openings.iter().filter(|o| o.storey == storey.index) {
        glass[opening.facing as usize] += glass_in_view_m2(&site.house.voxels, opening, site.settings.view_m);
    }
    glass
}

fn windows(site: &Site, storey: &Storey) -> Vec<[usize; 3]> {
    let of_storey = site.reading.openings.iter().filter(|o| o.storey == storey.index);
    of_storey.filter(|o| o.glass_area_m2(&site.house.voxels.module) > 0.0).flat_map(|o| o.voxels()).collect()
}

/// Reports `measure(glass, area)` square metres where positive.
fn ratio(site: &Site, report: &mut Report, measure: impl Fn(f64, f64) -> f64, says: [&str; 2]) {
    for storey in &site.reading.storeys {
        let (glass, area) = (glass_by_facing(site, storey).iter().sum::<f64>(), storey.floor_area_m2);
        let breach = measure(glass, area);
        report.add(if breach > 1e-9 { breach } else { 0.0 }, || {
            let message = format!(
                "storey {} has {glass:.2} m2 of glass on {area:.2} m2 of floor: {breach:.2} m2 {}",
                storey.index, says[0]
            );
            Finding::new(windows(site, storey), message, says[1])
        });
    }
}

pub(super) fn least(site: &Site, _: &mut Work, report: &mut Report) {
    let least = site.settings.glazing_ratio_min;
    let says = ["too little", "add or widen windows where 2.7 m of view outside are free"];
    ratio(site, report, |glass, area| least * area - glass, says);
}

pub(super) fn most(site: &Site, _: &mut Work, report: &mut Report) {
    let most = site.settings.glazing_ratio_max;
    ratio(site, report, |glass, area| glass - most * area, ["too much", "make windows smaller or fewer"]);
}

pub(super) fn orientations(site: &Site, _: &mut Work, report: &mut Report) {
    let least = site.settings.glazing_orientations_min;
    for storey in &site.reading.storeys {
        let found = glass_by_facing(site, storey).iter().filter(|g| **g > 0.0).count();
        report.add(least.saturating_sub(found) as f64, || {
            let message = format!("storey {} has glass in {found} orientations, {least} are needed", storey.index);
            Finding::new(windows(site, storey), message, "put a window into another facade")
        });
    }
}
