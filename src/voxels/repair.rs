//! Fills or empties the fewest voxels that make every cube admissible.

use super::given::plain_label;
use super::{Label, VoxelArray, is_admissible};

/// Most voxels changed together to mend one cube before the cube is simply filled.
const DEEPEST: usize = 5;

/// Changes the fewest voxels that make every cube of the padded array admissible, and lists them in storage order.
///
/// Cubes are mended one after another in storage order. For each the smallest set of changes is searched that leaves every
/// cube it touches admissible: first one voxel, then two, up to five (iterative deepening; filling is tried before
/// emptying, corners in order, so the result is the same every time). Separate faults are mended with the fewest changes
/// each. Should five changes not do, the cube is filled and from then on voxels are only filled, so that the search ends.
/// Filled voxels become foundation, floor or base after their layer.
pub fn repair(voxels: &VoxelArray) -> (VoxelArray, Vec<[usize; 3]>) {
    let mut work = Mending { voxels: voxels.clone(), fill_only: false, path: Vec::new() };
    while let Some(cube) = work.first_bad() {
        let mended = (1..=DEEPEST).any(|depth| work.mend(cube, depth));
        work.path.clear();
        if !mended {
            work.fill_only = true;
            for voxel in work.corners(cube) {
                if !work.voxels.get(voxel).is_filled() {
                    work.flip(voxel, Label::Empty);
                }
            }
        }
    }
    let changed = voxels.iter().filter(|(v, label)| work.voxels.get(*v) != *label).map(|(v, _)| v).collect();
    (work.voxels, changed)
}

struct Mending {
    voxels: VoxelArray,
    fill_only: bool,
    /// Voxels flipped in the branch being searched, with their labels before.
    path: Vec<([usize; 3], Label)>,
}

impl Mending {
    fn first_bad(&self) -> Option<[usize; 3]> {
        let [nx, ny, nz] = self.voxels.shape();
        (0..=nz).flat_map(|k| (0..=ny).flat_map(move |j| (0..=nx).map(move |i| [i, j, k]))).find(|c| !self.is_good(*c))
    }

    /// Whether a cube of the padded array is admissible.
    fn is_good(&self, cube: [usize; 3]) -> bool {
        let mask = (0..8).fold(0u8, |mask, o| {
            let at = [0, 1, 2].map(|a| (cube[a] + (o >> a & 1)) as isize - 1);
            mask | (self.voxels.at(at).is_filled() as u8) << o
        });
        is_admissible(mask)
    }

    /// Voxels of the array at the corners of a cube, in corner order.
    fn corners(&self, cube: [usize; 3]) -> Vec<[usize; 3]> {
        let shape = self.voxels.shape();
        (0..8)
            .map(|o| [0, 1, 2].map(|a| (cube[a] + (o >> a & 1)).wrapping_sub(1)))
            .filter(|v| (0..3).all(|a| v[a] < shape[a]))
            .collect()
    }

    /// Fills an empty voxel or empties a filled one; `old` is the label to go back to when it was filled before.
    fn flip(&mut self, voxel: [usize; 3], old: Label) {
        let filled = self.voxels.get(voxel).is_filled();
        let label = match (filled, old) {
            (true, _) => Label::Empty,
            (false, Label::Empty) => plain_label(voxel[2]),
            (false, label) => label,
        };
        self.voxels.set(voxel, label);
    }

    /// Mends `cube` with at most `depth` changes; on failure the voxels are as before.
    fn mend(&mut self, cube: [usize; 3], depth: usize) -> bool {
        let mut corners = self.corners(cube);
        corners.sort_by_key(|v| self.voxels.get(*v).is_filled()); // stable: filling first
        for voxel in corners {
            let old = self.voxels.get(voxel);
            if self.path.iter().any(|(v, _)| *v == voxel) || (self.fill_only && old.is_filled()) {
                continue;
            }
            self.path.push((voxel, old));
            self.flip(voxel, Label::Empty);
            let next = self.bad_beside_path(cube);
            if next.is_none_or(|bad| depth > 1 && self.mend(bad, depth - 1)) {
                return true;
            }
            self.flip(voxel, old);
            self.path.pop();
        }
        false
    }

    /// The first cube that is bad among `cube` and those touched by the changes so far.
    fn bad_beside_path(&self, cube: [usize; 3]) -> Option<[usize; 3]> {
        let touched = self.path.iter().flat_map(|(v, _)| (0..8).map(move |o| [0, 1, 2].map(|a| v[a] + (o >> a & 1))));
        std::iter::once(cube).chain(touched).find(|c| !self.is_good(*c))
    }
}
