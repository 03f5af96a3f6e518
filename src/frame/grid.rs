//! The half-module grid: which steps of it carry a stick, and which.
//!
//! Point (x, y, z): voxel (i, j, k) has its centre at (2i + 1, 2j + 1, 2k). So centre lines are odd in plan, faces even.

use super::types::Role;
use crate::voxels::{Label, VoxelArray};

/// Steps along which sticks run: three axes, four slopes, four hips, two level creases.
pub(super) const STEPS: [[i32; 3]; 13] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
    [1, 0, 1],
    [-1, 0, 1],
    [0, 1, 1],
    [0, -1, 1],
    [1, 1, 1],
    [-1, 1, 1],
    [1, -1, 1],
    [-1, -1, 1],
    [1, 1, 0],
    [-1, 1, 0],
];
/// Step along x, y and z in [`STEPS`].
pub(super) const X: usize = 0;
pub(super) const Y: usize = 1;
pub(super) const Z: usize = 2;

/// No element or node.
pub(super) const NONE: u32 = u32::MAX;

#[derive(Clone, Debug, Default)]
pub(super) struct Grid {
    size: [i32; 3],
    /// Role code + 1 per point and step, 0 for nothing.
    steps: Vec<u8>,
    /// Slots that were ever set, so that emptying and reading the grid need not walk all of it.
    touched: Vec<u32>,
    /// Element per point and step, valid where `steps` is not 0 and the stick has elements.
    pub owner: Vec<u32>,
    /// Sticks through each point; ends count twice.
    pub meets: Vec<u8>,
    /// Node per point.
    pub node: Vec<u32>,
}

impl Grid {
    /// Empties the grid for an array of `shape` voxels.
    pub fn reset(&mut self, shape: [usize; 3]) {
        let size = [2 * shape[0] as i32 + 1, 2 * shape[1] as i32 + 1, 2 * shape[2] as i32 + 3];
        let points = size.iter().map(|&n| n as usize).product::<usize>();
        for &slot in &self.touched {
            self.steps[slot as usize] = 0;
            self.owner[slot as usize] = NONE;
        }
        self.touched.clear();
        self.size = size;
        self.steps.resize(points * STEPS.len(), 0);
        self.owner.resize(points * STEPS.len(), NONE);
        self.meets.clear();
        self.meets.resize(points, 0);
        self.node.clear();
        self.node.resize(points, NONE);
    }

    pub fn size(&self) -> [i32; 3] {
        self.size
    }

    #[inline]
    pub fn inside(&self, p: [i32; 3]) -> bool {
        (0..3).all(|a| p[a] >= 0 && p[a] < self.size[a])
    }

    #[inline]
    pub fn point(&self, p: [i32; 3]) -> usize {
        (p[0] + self.size[0] * (p[1] + self.size[1] * p[2])) as usize
    }

    /// Role of the step from `p`, `None` outside the grid.
    #[inline]
    pub fn role(&self, p: [i32; 3], step: usize) -> Option<Role> {
        if !self.inside(p) {
            return None;
        }
        let code = self.steps[self.point(p) * STEPS.len() + step];
        (code > 0).then(|| Role::ALL[code as usize - 1])
    }

    /// Position of a step in `owner`.
    #[inline]
    pub fn slot(&self, p: [i32; 3], step: usize) -> usize {
        self.point(p) * STEPS.len() + step
    }

    /// Puts a role on the step from `p`; steps that leave the grid are ignored.
    #[inline]
    pub fn set(&mut self, p: [i32; 3], step: usize, role: Option<Role>) {
        if self.inside(p) && self.inside(add(p, STEPS[step])) {
            let slot = self.slot(p, step);
            self.steps[slot] = role.map_or(0, |r| r as u8 + 1);
            self.touched.push(slot as u32);
        }
    }

    /// Every point and step with a role, in scan order (z, then y, then x, then step).
    pub fn each_step(&mut self, mut visit: impl FnMut(&Grid, [i32; 3], usize)) {
        let mut touched = std::mem::take(&mut self.touched);
        touched.sort_unstable();
        touched.dedup();
        let [sx, sy, _] = self.size;
        for &slot in touched.iter().filter(|&&slot| self.steps[slot as usize] > 0) {
            let (point, step) = (slot as i32 / STEPS.len() as i32, slot as usize % STEPS.len());
            visit(self, [point % sx, point / sx % sy, point / (sx * sy)], step);
        }
        self.touched = touched;
    }

    /// Whether a stick of one of `roles` runs along x or y through `p`.
    pub fn level_at(&self, p: [i32; 3], roles: &[Role]) -> bool {
        [X, Y]
            .iter()
            .any(|&s| [p, sub(p, STEPS[s])].iter().any(|&q| self.role(q, s).is_some_and(|r| roles.contains(&r))))
    }

    /// Whether a vertical arrives at `p` from below.
    pub fn carried(&self, p: [i32; 3]) -> bool {
        p[2] == 0 || self.role([p[0], p[1], p[2] - 1], Z).is_some()
    }
}

#[inline]
pub(super) fn add(a: [i32; 3], b: [i32; 3]) -> [i32; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline]
pub(super) fn sub(a: [i32; 3], b: [i32; 3]) -> [i32; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Label of the voxel at plan cell (i, j), layer k, empty outside.
#[inline]
pub(super) fn label(v: &VoxelArray, i: i32, j: i32, k: i32) -> Label {
    v.at([i as isize, j as isize, k as isize])
}

/// Half modules from a centre plane to the next storey's.
pub(super) const STOREY: i32 = 2 * crate::voxels::STOREY_MODULES as i32;
