//! Level parts of roofs: which way their rafters run.

use super::grid::{X, Y, label};
use crate::voxels::VoxelArray;

/// Whether a level step over a plateau runs along its shorter extent. The plateau is one set of level cells and has one answer, so
/// that its rafters reach from edge to edge.
pub(super) fn across_plateau(v: &VoxelArray, p: [i32; 3], step: usize, plateaus: &mut Plateaus) -> bool {
    let k = (p[2] - 1) / 2;
    let mut cell = [(p[0] - 1).div_euclid(2), (p[1] - 1).div_euclid(2)];
    cell[step] = p[step] / 2;
    if !is_level(v, cell, k) {
        cell[step] -= 1;
    }
    plateaus.short_axis(v, cell, k) == step
}

fn is_level(v: &VoxelArray, [i, j]: [i32; 2], k: i32) -> bool {
    label(v, i, j, k).is_filled() && !label(v, i, j, k + 1).is_filled()
}

/// The short axis of each plateau met so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Plateaus {
    /// Cell, layer and axis.
    known: Vec<([i32; 3], usize)>,
    open: Vec<[i32; 2]>,
}

impl Plateaus {
    /// Forgets the plateaus of the last house.
    pub fn clear(&mut self) {
        self.known.clear();
    }

    /// The axis along which the plateau around a cell of layer k is shorter; x when it is square.
    fn short_axis(&mut self, v: &VoxelArray, cell: [i32; 2], k: i32) -> usize {
        let at = |[i, j]: [i32; 2]| [i, j, k];
        if let Some((_, axis)) = self.known.iter().find(|(c, _)| *c == at(cell)) {
            return *axis;
        }
        let first = self.known.len();
        self.open.clear();
        self.open.push(cell);
        self.known.push((at(cell), X));
        while let Some([i, j]) = self.open.pop() {
            for next in [[i + 1, j], [i - 1, j], [i, j + 1], [i, j - 1]] {
                if is_level(v, next, k) && !self.known[first..].iter().any(|(c, _)| *c == at(next)) {
                    self.known.push((at(next), X));
                    self.open.push(next);
                }
            }
        }
        let extent = |axis: usize| {
            let cells = || self.known[first..].iter().map(|(c, _)| c[axis]);
            cells().max().unwrap_or(0) - cells().min().unwrap_or(0)
        };
        let axis = if extent(Y) < extent(X) { Y } else { X };
        self.known[first..].iter_mut().for_each(|k| k.1 = axis);
        axis
    }
}
