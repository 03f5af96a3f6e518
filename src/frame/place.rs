//! Tile lines on the grid: each line becomes a stick or not, by the labels around it.

use super::grid::{Grid, STEPS, STOREY, X, Y, Z, add, label};
use super::roof::RoofCube;
use super::types::Role;
use crate::cubes::{Rule, scan_keys};
use crate::tiles::{Line, LineRole, RoofShape};
use crate::voxels::{Label, VoxelArray};

/// Puts the lines of every cube in which something stands on the grid, but those of its roofs: cubes with roofs are collected in
/// `roofs`. `along_y(p)` tells which way the joists of plate p (0 = first above ground) run.
pub(super) fn place<'t>(
    grid: &mut Grid,
    v: &VoxelArray,
    lines: &impl Fn(u8) -> &'t [Line],
    along_y: impl Fn(usize) -> bool,
    roofs: &mut Vec<RoofCube>,
) {
    roofs.clear();
    scan_keys(
        v,
        Rule::B,
        |_| false,
        |[i, j, k], key| {
            if k == 0 {
                return;
            }
            let corner = [2 * i as i32 - 1, 2 * j as i32 - 1, 2 * (k as i32 - 1)];
            let shape = RoofShape::new(key);
            roofs.extend(shape.map(|shape| RoofCube::new(v, corner, shape)));
            // Most lines of a cube are joists and edges that only a slab in its bottom layer can make.
            let slabs = (0..4).any(|q| key.label(q).is_slab());
            for line in lines(key.mask().0) {
                let asked = match line.role {
                    LineRole::JoistX | LineRole::JoistY | LineRole::Edge | LineRole::Rail => slabs,
                    LineRole::Post => shape.is_none(),
                    LineRole::Stud => true,
                    LineRole::Rafter | LineRole::Purlin | LineRole::Hip | LineRole::Valley | LineRole::Ridge => false,
                };
                if asked {
                    place_line(grid, v, corner, line, &along_y);
                }
            }
        },
    );
}

/// Walks a line in grid steps and decides each.
fn place_line(grid: &mut Grid, v: &VoxelArray, corner: [i32; 3], line: &Line, along_y: &impl Fn(usize) -> bool) {
    let a = add(corner, grid_point(line.from));
    let b = add(corner, grid_point(line.to));
    let (low, high) = if (a[2], a[0], a[1]) <= (b[2], b[0], b[1]) { (a, b) } else { (b, a) };
    let run = (0..3).map(|n| (high[n] - low[n]).abs()).max().unwrap_or(0);
    let unit = [0, 1, 2].map(|n| (high[n] - low[n]) / run.max(1));
    let Some((step, from)) = STEPS
        .iter()
        .position(|&s| s == unit)
        .map(|s| (s, low))
        .or_else(|| STEPS.iter().position(|&s| s == unit.map(|n| -n)).map(|s| (s, high)))
    else {
        return;
    };
    for n in 0..run {
        let p = [0, 1, 2].map(|d| from[d] + n * STEPS[step][d]);
        if let Some(role) = decide(v, p, step, line.role, along_y) {
            grid.set(p, step, Some(role));
        }
    }
}

fn grid_point(mm: [i32; 3]) -> [i32; 3] {
    [mm[0] / 450, mm[1] / 450, mm[2] / 270]
}

/// The role of one step of a line of `role`, `None` when the labels leave it out.
fn decide(v: &VoxelArray, p: [i32; 3], step: usize, role: LineRole, along_y: &impl Fn(usize) -> bool) -> Option<Role> {
    match role {
        LineRole::Stud | LineRole::Post => vertical(v, p, role),
        LineRole::Rail => rail(v, p, step),
        LineRole::JoistX => joist(v, p, false, along_y),
        LineRole::JoistY => joist(v, p, true, along_y),
        LineRole::Edge => edge(v, p, step),
        LineRole::Rafter | LineRole::Purlin | LineRole::Hip | LineRole::Valley | LineRole::Ridge => None,
    }
}

/// The voxel layer of a vertical step from half level z: bodies reach half a module to both sides of their centre.
pub(super) fn layer(z: i32) -> i32 {
    (z + 1) / 2
}

fn vertical(v: &VoxelArray, p: [i32; 3], role: LineRole) -> Option<Role> {
    let k = layer(p[2]);
    let cells = |c: i32| if c % 2 == 0 { [c / 2 - 1, c / 2] } else { [(c - 1) / 2, (c - 1) / 2] };
    let mut infill = false;
    let mut wall = false;
    for i in cells(p[0]) {
        for j in cells(p[1]) {
            let l = label(v, i, j, k);
            infill |= l.is_infill();
            wall |= l.is_filled() && !l.is_infill();
        }
    }
    match role {
        LineRole::Post => (wall && is_corner(v, p)).then_some(Role::CornerPost),
        _ => (wall && !infill).then_some(Role::Stud),
    }
}

/// Whether the full columns around a plan vertex make a corner: one alone, or three.
fn is_corner(v: &VoxelArray, [x, y, z]: [i32; 3]) -> bool {
    let full = |i: i32, j: i32| label(v, i, j, z / 2).is_filled() && label(v, i, j, z / 2 + 1).is_filled();
    let count = [x / 2 - 1, x / 2].iter().flat_map(|&i| [y / 2 - 1, y / 2].map(|j| full(i, j))).filter(|&f| f).count();
    count == 1 || count == 3
}

/// Walls that stand on a floor: their lowest module has a deck beside it, which masks take for a roof.
pub(super) fn walls_on_floors(grid: &mut Grid, v: &VoxelArray) {
    let [nx, ny, nz] = v.shape().map(|n| n as i32);
    for k in (STOREY / 2..nz).step_by(STOREY as usize / 2) {
        let full = |i: i32, j: i32| label(v, i, j, k).is_slab() && label(v, i, j, k + 1).is_filled();
        let deck = |i: i32, j: i32| label(v, i, j, k).is_slab() && !label(v, i, j, k + 1).is_filled();
        for j in 0..=ny {
            for i in 0..=nx {
                for (a, step) in [([i - 1, j], [2 * i, 2 * j + 1]), ([i, j - 1], [2 * i + 1, 2 * j])] {
                    let b = [i, j];
                    if full(a[0], a[1]) && deck(b[0], b[1]) || deck(a[0], a[1]) && full(b[0], b[1]) {
                        for z in [2 * k, 2 * k + 1] {
                            let inner = if full(a[0], a[1]) { a } else { b };
                            let glazed = label(v, inner[0], inner[1], layer(z)).is_infill();
                            grid.set([step[0], step[1], z], Z, (!glazed).then_some(Role::Stud));
                        }
                    }
                }
                let around = [[i - 1, j - 1], [i, j - 1], [i - 1, j], [i, j]];
                if around.iter().any(|c| deck(c[0], c[1])) && is_corner(v, [2 * i, 2 * j, 2 * k]) {
                    (2 * k..2 * k + 2).for_each(|z| grid.set([2 * i, 2 * j, z], Z, Some(Role::CornerPost)));
                }
            }
        }
    }
}

/// The two cells beside a horizontal step on a cell face.
fn beside(p: [i32; 3], step: usize) -> [[i32; 2]; 2] {
    let along = (p[step].max(0)) / 2;
    let across = p[1 - step] / 2;
    if step == X { [[along, across - 1], [along, across]] } else { [[across - 1, along], [across, along]] }
}

fn rail(v: &VoxelArray, p: [i32; 3], step: usize) -> Option<Role> {
    let (k, cells) = (p[2] / 2, beside(p, step));
    let labels = cells.map(|[i, j]| label(v, i, j, k));
    let inner = usize::from(!labels[0].is_filled());
    labels[inner].is_slab().then_some(Role::Plate)
}

fn joist(v: &VoxelArray, p: [i32; 3], y: bool, along_y: &impl Fn(usize) -> bool) -> Option<Role> {
    let k = p[2] / 2;
    let step = if y { Y } else { X };
    let cell = [0, 1].map(|a| if a == step { p[a] / 2 } else { (p[a] - 1) / 2 });
    let plate = p[2] / STOREY;
    (k > 0 && plate > 0 && label(v, cell[0], cell[1], k) == Label::Floor && along_y(plate as usize - 1) == y)
        .then_some(Role::Joist)
}

/// A line between two filled cells: edge of a stair void, sill of a wall above, or top of a wall below.
fn edge(v: &VoxelArray, p: [i32; 3], step: usize) -> Option<Role> {
    let (k, cells) = (p[2] / 2, beside(p, step));
    let filled = |dk: i32| cells.map(|[i, j]| label(v, i, j, k + dk).is_filled());
    let slab = cells.map(|[i, j]| label(v, i, j, k).is_slab());
    if k == 0 || (!slab[0] && !slab[1]) {
        return None;
    }
    let (below, above) = (filled(-1), filled(1));
    if below[0] != below[1] {
        Some(Role::Plate)
    } else if above[0] != above[1] {
        Some(Role::Beam)
    } else if slab[0] != slab[1] {
        Some(Role::Trimmer)
    } else {
        None
    }
}
