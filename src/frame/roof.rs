//! Roof members, from the heights that the drawing uses: every line of the roof in a cube becomes a step of the grid or none.
//!
//! * Lines over voxel centres: sloped ones are rafters; level ones are ridges where the roof falls to both sides, edges of a plateau,
//!   level valleys, rafters across a plateau the short way, and purlins on a slope, which are left out.
//! * Creases: hips and valleys, on which jack rafters end.
//! * Edges, in the planes of the walls: a level edge is the plate on its wall (eaves, the head of a single-sided roof) or the plate
//!   on the wall it leans on; a sloped edge is the verge rafter on its gable studs, or the rafter beside a wall.

use super::grid::{Grid, STEPS, STOREY, X, Y, Z, add, label, sub};
use super::plateaus::{Plateaus, across_plateau};
use super::types::Role;
use crate::tiles::solids::Post;
use crate::tiles::{Fold, RoofShape};
use crate::voxels::VoxelArray;

/// A cube with a roof column.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoofCube {
    /// Grid point of its first corner.
    pub corner: [i32; 3],
    /// Its roofs.
    pub shape: RoofShape,
    /// Bit 2 q + axis: the roof of column q ends at the border towards its neighbour along the axis.
    ends: u8,
}

impl RoofCube {
    /// The cube at a grid point with its roofs.
    pub fn new(v: &VoxelArray, corner: [i32; 3], shape: RoofShape) -> RoofCube {
        let mut cube = RoofCube { corner, shape, ends: 0 };
        for q in (0..4).filter(|&q| shape.post(q) == Post::Roof) {
            for axis in [X, Y] {
                let beside = q ^ (1 << axis);
                let [i, j, k] = cube.cell(beside);
                // A roof stands on a filled voxel without slab and has nothing above it.
                let roof = |k: i32| {
                    let l = label(v, i, j, k);
                    l.is_filled() && !l.is_slab() && !label(v, i, j, k + 1).is_filled()
                };
                let goes_on = match shape.post(beside) {
                    Post::Roof => true,
                    Post::Full => roof(k + 1),
                    Post::Empty => roof(k - 1),
                    Post::Deck | Post::Floor => false,
                };
                cube.ends |= u8::from(!goes_on) << (2 * q + axis);
            }
        }
        cube
    }

    /// Whether the roof of column q ends at the border towards its neighbour along `axis`: at a wall or in the open, and does not go on
    /// in the same cube or the one above or below.
    pub fn ends(&self, q: usize, axis: usize) -> bool {
        self.ends >> (2 * q + axis) & 1 == 1
    }

    /// The cell of column q and the layer of the cube's bottom plane.
    pub fn cell(&self, q: usize) -> [i32; 3] {
        let [x, y, z] = self.corner;
        [(x + 1) / 2 - 1 + (q as i32 & 1), (y + 1) / 2 - 1 + (q as i32 >> 1), z / 2]
    }

    /// Grid point over the corner of column q, `height` half modules above the cube's bottom plane.
    pub fn over(&self, q: usize, height: i32) -> [i32; 3] {
        add(self.corner, [2 * (q as i32 & 1), 2 * (q as i32 >> 1), height])
    }

    /// Grid point half-way from the corner of column q to its neighbour along `axis`.
    pub fn middle(&self, q: usize, axis: usize, height: i32) -> [i32; 3] {
        let mut p = self.over(q, height);
        p[axis] += inward(q, axis);
        p
    }

    /// Grid point over the centre.
    pub fn centre(&self, height: i32) -> [i32; 3] {
        add(self.corner, [1, 1, height])
    }

    /// Roof columns.
    pub fn roofs(&self) -> impl Iterator<Item = usize> + '_ {
        (0..4).filter(|&q| self.shape.post(q) == Post::Roof)
    }
}

/// Direction from the corner of column q into the cube.
pub(super) fn inward(q: usize, axis: usize) -> i32 {
    if q >> axis & 1 == 0 { 1 } else { -1 }
}

/// The step of the grid between two neighbouring points and the point it starts from; `None` when none joins them.
pub(super) fn step_between(a: [i32; 3], b: [i32; 3]) -> Option<([i32; 3], usize)> {
    let d = sub(b, a);
    let found = |d: [i32; 3]| STEPS.iter().position(|&s| s == d);
    found(d).map(|s| (a, s)).or_else(|| found(sub(a, b)).map(|s| (b, s)))
}

/// A level line over voxel centres, seen from one of the two cubes it separates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct LevelLine {
    slot: usize,
    /// Whether the cube lies on the positive side.
    positive: bool,
    /// Rise away from the line into the cube.
    rise: i32,
    /// Start of the step.
    from: [i32; 3],
    step: usize,
}

/// Puts rafters, hips, valleys and the edges' members on the grid, then the level lines, then the walls at the edges.
pub(super) fn place(
    grid: &mut Grid,
    v: &VoxelArray,
    cubes: &[RoofCube],
    levels: &mut Vec<LevelLine>,
    plateaus: &mut Plateaus,
) {
    levels.clear();
    plateaus.clear();
    for cube in cubes {
        for q in cube.roofs() {
            curves(grid, cube, q, levels);
            if let Some(fold) = cube.shape.fold(q) {
                let role = if fold == Fold::Convex { Role::Hip } else { Role::Valley };
                put(grid, [cube.over(q, 1), cube.centre(cube.shape.centre())], role);
            }
        }
    }
    level_lines(grid, v, levels, plateaus);
    for cube in cubes {
        cube.roofs().for_each(|q| edges(grid, v, cube, q));
        corners(grid, v, cube);
    }
    for cube in cubes {
        carry_walls(grid, v, cube);
    }
}

fn put(grid: &mut Grid, [a, b]: [[i32; 3]; 2], role: Role) {
    if let Some((from, step)) = step_between(a, b) {
        grid.set(from, step, Some(role));
    }
}

/// The lines from the corner of a roof column half-way to its neighbours.
fn curves(grid: &mut Grid, cube: &RoofCube, q: usize, levels: &mut Vec<LevelLine>) {
    for axis in [X, Y] {
        let height = cube.shape.mid(q, axis);
        let ends = [cube.over(q, 1), cube.middle(q, axis, height)];
        if height != 1 {
            put(grid, ends, Role::Rafter);
        } else if let Some((from, step)) = step_between(ends[0], ends[1]).filter(|(p, _)| grid.inside(*p)) {
            let (positive, rise) = (inward(q, 1 - axis) > 0, cube.shape.centre() - 1);
            levels.push(LevelLine { slot: grid.slot(from, step), positive, rise, from, step });
        }
    }
}

/// Decides level lines by how the roof goes on to both sides.
fn level_lines(grid: &mut Grid, v: &VoxelArray, levels: &mut Vec<LevelLine>, plateaus: &mut Plateaus) {
    levels.sort_unstable();
    levels.dedup();
    for pair in levels.chunk_by(|a, b| a.slot == b.slot) {
        let &[low, .., high] = pair else { continue };
        let role = match (low.rise, high.rise) {
            (0, 0) => across_plateau(v, low.from, low.step, plateaus).then_some(Role::Rafter),
            (1, 1) => Some(Role::Valley),
            (-1, 1) | (1, -1) => None,
            _ => Some(Role::Ridge),
        };
        grid.set(low.from, low.step, role);
    }
}

/// Whether voxel `[i, j, k]` is wall, not window or door.
fn is_wall(v: &VoxelArray, [i, j, k]: [i32; 3]) -> bool {
    let l = label(v, i, j, k);
    l.is_filled() && !l.is_infill()
}

/// Edges of one roof column: members on them and studs in the wall below, or in the wall above that the roof ends at.
fn edges(grid: &mut Grid, v: &VoxelArray, cube: &RoofCube, q: usize) {
    for axis in [X, Y] {
        let beside = q ^ (1 << axis);
        let post = cube.shape.post(beside);
        if !cube.ends(q, axis) {
            continue;
        }
        let (mid, centre) = (cube.shape.mid(q, axis), cube.shape.centre());
        let role = if mid == centre { Role::Plate } else { Role::Rafter };
        put(grid, [cube.middle(q, axis, mid), cube.centre(centre)], role);
        let [i, j, k] = cube.cell(if post == Post::Full { beside } else { q });
        let (studs, wall) = match post {
            Post::Full => (mid..2, [is_wall(v, [i, j, k]), is_wall(v, [i, j, k + 1])]),
            _ => (0..mid, [is_wall(v, [i, j, k]); 2]),
        };
        for z in studs.filter(|&z| wall[z as usize]) {
            grid.set(cube.middle(q, axis, z), Z, Some(Role::Stud));
        }
    }
}

/// Corner posts over the centre of a cube with roofs: where the solid columns of a half make a corner.
fn corners(grid: &mut Grid, v: &VoxelArray, cube: &RoofCube) {
    for half in 0..2 {
        let solid = |q: usize| match cube.shape.post(q) {
            Post::Full => true,
            Post::Roof => cube.shape.centre() > half,
            Post::Deck | Post::Floor | Post::Empty => false,
        };
        let full = [0, 1, 2, 3].map(solid);
        let count = full.iter().filter(|&&f| f).count();
        let wall = (0..4).filter(|&q| full[q]).any(|q| {
            let [i, j, k] = cube.cell(q);
            is_wall(v, [i, j, if cube.shape.post(q) == Post::Full { k + half } else { k }])
        });
        if wall && (count == 1 || count == 3) {
            grid.set(cube.centre(half), Z, Some(Role::CornerPost));
        }
    }
}

/// A wall that rises from a roof goes on below it, inside the house, down to the next floor, and stands there on a beam.
fn carry_walls(grid: &mut Grid, v: &VoxelArray, cube: &RoofCube) {
    for q in cube.roofs() {
        let at_wall = |&axis: &usize| cube.ends(q, axis) && cube.shape.post(q ^ (1 << axis)) == Post::Full;
        for axis in [X, Y].into_iter().filter(at_wall) {
            let heights = [cube.shape.mid(q, axis), cube.shape.centre()];
            let feet = [cube.middle(q, axis, heights[0]), cube.centre(heights[1])];
            // Inside: both columns are filled all the way down to the floor.
            let floor = feet[0][2] / STOREY * STOREY;
            let inside = [q, q ^ (1 << axis)].into_iter().all(|c| {
                let [i, j, k] = cube.cell(c);
                (floor / 2..=k).all(|k| label(v, i, j, k).is_filled())
            });
            if floor == 0 || !inside {
                continue;
            }
            lower(grid, feet[0], floor, Role::Stud);
            if grid.role(feet[1], Z) == Some(Role::CornerPost) {
                lower(grid, feet[1], floor, Role::CornerPost);
            }
            let [a, b] = feet.map(|[x, y, _]| [x, y, floor]);
            let free = |g: &Grid, p, s| matches!(g.role(p, s), None | Some(Role::Joist | Role::Trimmer));
            if let Some((from, step)) = step_between(a, b).filter(|&(p, s)| free(grid, p, s)) {
                grid.set(from, step, Some(Role::Beam));
            }
        }
    }
}

/// Lengthens an upright from `foot` down to the half level `floor`, as far as nothing stands there.
fn lower(grid: &mut Grid, foot: [i32; 3], floor: i32, role: Role) {
    let mut p = foot;
    while p[2] > floor {
        p = sub(p, STEPS[Z]);
        if grid.role(p, Z).is_some() {
            return;
        }
        grid.set(p, Z, Some(role));
    }
}
