//! Rules about the body as a whole.

use super::report::{Finding, Report};
use super::site::{Site, Work, reset};
use crate::voxels::{Label, is_admissible};

pub(super) fn cubes(site: &Site, _: &mut Work, report: &mut Report) {
    let [nx, ny, nz] = site.shape;
    let [_, sy, sz] = site.stride;
    let p = site.padded();
    for k in 0..=nz {
        for j in 0..=ny {
            let row = sy * j + sz * k;
            let column = |x: usize| {
                let bit = |at: usize, b: u8| ((p[at] != 0) as u8) << b;
                bit(x, 0) | bit(x + sy, 2) | bit(x + sz, 4) | bit(x + sy + sz, 6)
            };
            let mut near = column(row);
            for i in 0..=nx {
                let far = column(row + i + 1);
                let mask = near | far << 1;
                near = far;
                if !is_admissible(mask) {
                    report.add(1.0, || inadmissible(site, [i, j, k], mask));
                }
            }
        }
    }
}

fn inadmissible(site: &Site, cube: [usize; 3], mask: u8) -> Finding {
    let corner = |o: usize| [0, 1, 2].map(|a| (cube[a] + (o >> a & 1)).wrapping_sub(1));
    let inside = |v: &[usize; 3]| (0..3).all(|a| v[a] < site.shape[a]);
    let voxels: Vec<_> = (0..8).filter(|o| mask >> o & 1 == 1).map(corner).filter(inside).collect();
    Finding {
        voxels,
        cube: Some(cube),
        message: format!("cube {cube:?} has corners filled ({mask:08b}) that meet only across a face or its middle"),
        fix: "fill or empty one of its voxels so that filled and empty corners each hang together".to_string(),
    }
}

pub(super) fn one_body(site: &Site, work: &mut Work, report: &mut Report) {
    reset(work.mark, site.padded().len(), 0);
    let steps = six(site);
    let (mut id, mut largest, mut largest_id, mut total) = (0u8, 0, 0, 0);
    for (_, start) in site.filled_voxels() {
        if work.mark[start] != 0 {
            continue;
        }
        id = id.saturating_add(1);
        work.queue.clear();
        work.queue.push(start as u32);
        work.mark[start] = id;
        let mut size = 0;
        while let Some(at) = work.queue.pop() {
            size += 1;
            for step in steps {
                let next = at.wrapping_add_signed(step as i32) as usize;
                if site.filled(next) && work.mark[next] == 0 {
                    work.mark[next] = id;
                    work.queue.push(next as u32);
                }
            }
        }
        total += size;
        if size > largest {
            (largest, largest_id) = (size, id);
        }
    }
    report.add((total - largest) as f64, || {
        let loose = site.filled_voxels().filter(|(_, at)| work.mark[*at] != largest_id).map(|(v, _)| v).collect();
        let message = format!("{} of {total} voxels are not joined to the largest body face to face", total - largest);
        Finding::new(loose, message, "remove the loose voxels or fill what lies between")
    });
}

fn six(site: &Site) -> [isize; 6] {
    let [sx, sy, sz] = site.stride.map(|s| s as isize);
    [sx, -sx, sy, -sy, sz, -sz]
}

pub(super) fn foundation(site: &Site, _: &mut Work, report: &mut Report) {
    let voxels = &site.house.voxels;
    let wrong = site.filled_voxels().map(|(v, _)| v).filter(|&v| (v[2] == 0) != (voxels.get(v) == Label::Foundation));
    report.voxels(wrong, "break the ground layer", "make every voxel of layer 0 foundation (3), and no other");
    let plane = site.shape[0] * site.shape[1];
    let grounded = voxels.labels().iter().take(plane).any(|l| l.is_filled());
    report.add(if grounded { 0.0 } else { 1.0 }, || {
        Finding::new(Vec::new(), "layer 0 is empty: the house has no foundation".into(), "set the house on layer 0")
    });
}

pub(super) fn undercut(site: &Site, _: &mut Work, report: &mut Report) {
    let least = site.settings.undercut_min_modules;
    let sz = site.stride[2];
    // Modules missing under a voxel: only small gaps are walked, so that the scan stays short.
    let missing = |v: [usize; 3], at: usize| {
        let free = (1..=v[2].min(least)).take_while(|n| !site.filled(at - n * sz)).count();
        let grounded = v[2] == 0;
        if grounded || free == 0 { 0 } else { least - free }
    };
    let sum: usize = site.filled_voxels().map(|(v, at)| missing(v, at)).sum();
    report.add(sum as f64, || {
        let low: Vec<_> = site.filled_voxels().filter(|&(v, at)| missing(v, at) > 0).map(|(v, _)| v).collect();
        let message =
            format!("the space under {} voxels is lower than {least} modules ({sum} missing in all)", low.len());
        Finding::new(low, message, "fill the space down to the body or the ground below, or raise the part above")
    });
}

pub(super) fn sky(site: &Site, work: &mut Work, report: &mut Report) {
    let sz = site.stride[2];
    work.mark.clear();
    work.mark.extend(site.padded().iter().map(|&p| (p != 0) as u8));
    work.mark[..sz].fill(1); // below the ground layer lies soil
    // All padding beside and above the house is outside, so that indices may wrap from one side to the other.
    let steps = six(site);
    work.queue.clear();
    if sz < work.mark.len() {
        work.mark[sz] = 1;
        work.queue.push(sz as u32);
    }
    while let Some(at) = work.queue.pop() {
        for step in steps {
            let next = at.wrapping_add_signed(step as i32) as usize;
            match work.mark.get_mut(next) {
                Some(mark) if *mark == 0 => *mark = 1,
                _ => continue,
            }
            work.queue.push(next as u32);
        }
    }
    let sealed = work.mark.iter().enumerate().filter(|(_, m)| **m == 0).map(|(at, _)| site.voxel(at));
    report.voxels(sealed, "are shut in without a way to the sky", "fill the void or open it to the outside");
}

pub(super) fn slenderness(site: &Site, _: &mut Work, report: &mut Report) {
    let module = site.house.voxels.module.size_m;
    let (mut low, mut high, mut top) = ([usize::MAX; 2], [0; 2], 0);
    for (v, _) in site.filled_voxels() {
        top = top.max(v[2]);
        if v[2] == 0 {
            low = [low[0].min(v[0]), low[1].min(v[1])];
            high = [high[0].max(v[0] + 1), high[1].max(v[1] + 1)];
        }
    }
    if high[0] == 0 {
        return; // no base at all: the foundation rule speaks
    }
    let width = [0, 1].map(|a| (high[a] - low[a]) as f64 * module[a]).into_iter().fold(f64::INFINITY, f64::min);
    let height = (top as f64 + 0.5) * module[2];
    let most = site.settings.slenderness_max * width;
    let over = height - most;
    report.add(if over > 1e-9 { over } else { 0.0 }, || {
        let message = format!(
            "the house is {height:.2} m high on a base {width:.2} m wide: {over:.2} m above the limit {most:.2} m"
        );
        Finding::new(Vec::new(), message, "widen the base or take off a storey")
    });
}

pub(super) fn zones(site: &Site, _: &mut Work, report: &mut Report) {
    let (zones, labels) = (&site.house.zones, site.house.voxels.labels());
    if zones.is_empty() {
        return;
    }
    if zones.len() != labels.len() {
        report.add(1.0, || {
            let message = format!("{} zones for {} voxels", zones.len(), labels.len());
            Finding::new(Vec::new(), message, "give one zone id per voxel, -1 for none")
        });
        return;
    }
    let [nx, ny, _] = site.shape;
    let wrong = (0..zones.len())
        .filter(|&i| zones[i] >= 0 && !labels[i].is_filled())
        .map(|i| [i % nx, i / nx % ny, i / (nx * ny)]);
    report.voxels(wrong, "have a zone but are empty", "fill them or set their zone to -1");
}
