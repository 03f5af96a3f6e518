//! From voxels of any size to modules.

use super::MOST_VOXELS;
use crate::voxels::{Label, Module, VoxelArray};

/// Why voxels cannot be made modules.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RescaleError {
    /// A size that is none.
    #[error("a voxel of {0} m is no size; give metres above 0, e.g. 0.3")]
    Size(f64),
    /// More modules than can be held.
    #[error("voxels of {0} m make more than {MOST_VOXELS} modules; give a smaller size")]
    TooMany(f64),
}

/// Voxels that are cubes of `voxel_m` metres as modules: a module is filled when at least half of its volume is, with the
/// label that fills most of it. The lower corner of the array stays in place.
///
/// # Errors
/// A size that is not above 0, or makes more modules than can be held.
pub fn rescale(voxels: &VoxelArray, voxel_m: f64, module: Module) -> Result<VoxelArray, RescaleError> {
    if !(voxel_m.is_finite() && voxel_m > 0.0) {
        return Err(RescaleError::Size(voxel_m));
    }
    let ratio = module.size_m.map(|m| voxel_m / m);
    let lengths = [0, 1, 2].map(|a| (voxels.shape()[a] as f64 * ratio[a] - 1e-9).ceil());
    if lengths.iter().product::<f64>() > MOST_VOXELS as f64 {
        return Err(RescaleError::TooMany(voxel_m));
    }
    let shape = lengths.map(|n| (n as usize).max(1));
    let shares = [0, 1, 2].map(|a| (0..voxels.shape()[a]).map(|v| overlaps(v, ratio[a], shape[a])).collect::<Vec<_>>());
    let mut volumes = vec![[0.0f64; Label::ALL.len()]; shape.iter().product()];
    for ([x, y, z], label) in voxels.iter().filter(|(_, l)| l.is_filled()) {
        for &(k, along_z) in &shares[2][z] {
            for &(j, along_y) in &shares[1][y] {
                for &(i, along_x) in &shares[0][x] {
                    volumes[i + shape[0] * (j + shape[1] * k)][label as usize] += along_x * along_y * along_z;
                }
            }
        }
    }
    let labels = volumes.iter().map(|by_label| {
        let filled: f64 = by_label.iter().sum();
        // Rounding, so that a share that falls on both sides of a boundary decides nothing.
        let most = |a: &&Label, b: &&Label| {
            let share = |l: Label| (by_label[l as usize] * 1e9).round();
            share(**a).total_cmp(&share(**b)).then(b.code().cmp(&a.code()))
        };
        match Label::ALL[1..].iter().max_by(most) {
            Some(&label) if filled >= 0.5 - 1e-9 => label,
            _ => Label::Empty,
        }
    });
    let mut out = VoxelArray::from_labels(shape, labels.collect()).unwrap_or_else(|| VoxelArray::new(shape));
    out.module = module;
    Ok(out)
}

/// The modules that voxel `v` reaches along an axis, with the share of each that it covers; `ratio` is voxel over module.
fn overlaps(v: usize, ratio: f64, modules: usize) -> Vec<(usize, f64)> {
    let (low, high) = (v as f64 * ratio, (v + 1) as f64 * ratio);
    let first = (low.floor() as usize).min(modules - 1);
    (first..modules)
        .take_while(|m| (*m as f64) < high - 1e-12)
        .map(|m| (m, high.min((m + 1) as f64) - low.max(m as f64)))
        .filter(|(_, share)| *share > 0.0)
        .collect()
}
