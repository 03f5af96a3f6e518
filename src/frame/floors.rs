//! What a floor needs besides its joists: headers at stair voids, joists across for projecting edges, bearing lines, posts.

use super::build::FrameOptions;
use super::grid::{Grid, STEPS, STOREY, X, Y, Z, label, sub};
use super::types::Role;
use crate::voxels::{House, VoxelArray};

/// Completes the plate at half level z, whose joists run along `step`.
pub(super) fn complete(grid: &mut Grid, house: &House, z: i32, step: usize, options: &FrameOptions) {
    let size_m = house.voxels.module.size_m;
    extend_headers(grid, z, step);
    joists_across(grid, &house.voxels, z, step);
    let longest = half_modules(options.bay_m, size_m[step]).max(SHORTEST);
    for _ in 0..12 {
        if !bearing_line(grid, house, z, step, longest) {
            break;
        }
    }
    for axis in [X, Y] {
        let apart = half_modules(options.post_distance_m, size_m[axis]).max(2);
        posts_under_beams(grid, house, z, axis, apart);
    }
}

/// Half modules of the shortest bay that is cut in two: a beam lies one module and a half off the walls.
const SHORTEST: i32 = 6;

/// How many half modules fit into a length in m; rounding does not lose one.
fn half_modules(length_m: f64, module_m: f64) -> i32 {
    (2.0 * length_m / module_m + 1e-6).floor() as i32
}

/// Number of lines along `axis`, and of points on each.
fn lines(grid: &Grid, axis: usize) -> (i32, i32) {
    (grid.size()[1 - axis], grid.size()[axis])
}

fn on(axis: usize, along: i32, across: i32, z: i32) -> [i32; 3] {
    let mut p = [0, 0, z];
    p[axis] = along;
    p[1 - axis] = across;
    p
}

/// A header (trimmer across the joists) reaches to the next joist at both ends.
fn extend_headers(grid: &mut Grid, z: i32, joists: usize) {
    let axis = 1 - joists;
    let (rows, length) = lines(grid, axis);
    for across in 0..rows {
        for along in 0..length {
            let p = on(axis, along, across, z);
            let here = grid.role(p, axis) == Some(Role::Trimmer);
            let before = grid.role(on(axis, along - 1, across, z), axis);
            let joist_at = |g: &Grid, along: i32| {
                let q = on(axis, along, across, z);
                g.role(q, joists) == Some(Role::Joist) || g.role(sub(q, STEPS[joists]), joists) == Some(Role::Joist)
            };
            if here && before.is_none() && along % 2 == 0 && joist_at(grid, along - 1) {
                grid.set(on(axis, along - 1, across, z), axis, Some(Role::Trimmer));
            }
            let ends = !here && before == Some(Role::Trimmer) && grid.role(p, axis).is_none();
            if ends && along % 2 == 0 && joist_at(grid, along + 1) {
                grid.set(p, axis, Some(Role::Trimmer));
            }
        }
    }
}

/// Where the floor projects across the joists, joists the other way carry it, with twice the projection behind.
fn joists_across(grid: &mut Grid, v: &VoxelArray, z: i32, joists: usize) {
    let (axis, k) = (1 - joists, z / 2);
    let (rows, length) = (v.shape()[joists] as i32, v.shape()[axis] as i32);
    for row in 0..rows {
        let cell = |n: i32| if axis == X { [n, row] } else { [row, n] };
        let slab = |n: i32| label(v, cell(n)[0], cell(n)[1], k).is_slab();
        let hangs = |n: i32| slab(n) && !label(v, cell(n)[0], cell(n)[1], k - 1).is_filled();
        let mut n = 0;
        while n < length {
            let start = n;
            while n < length && hangs(n) {
                n += 1;
            }
            let width = n - start;
            if width > 0 && width <= 2 {
                let behind = if slab(n) && !hangs(n) { start..n + 2 * width } else { start - 2 * width..n };
                for cell in behind.filter(|&m| slab(m)) {
                    for half in [2 * cell, 2 * cell + 1] {
                        let p = on(axis, half, 2 * row + 1, z);
                        if grid.role(p, axis).is_none() {
                            grid.set(p, axis, Some(Role::Joist));
                        }
                    }
                }
            }
            n += 1;
        }
    }
}

/// Whether a joist that runs through `p` rests there: on a beam, or on a wall. Headers hang on it instead.
fn bears(grid: &Grid, p: [i32; 3]) -> bool {
    grid.level_at(p, &[Role::Beam]) || (grid.level_at(p, &[Role::Plate]) && grid.carried(p))
}

/// Clear lengths of the joists on the line `across`, as (from, to).
fn clear_lengths(grid: &Grid, z: i32, joists: usize, across: i32, out: &mut Vec<[i32; 3]>) {
    let length = grid.size()[joists];
    let mut start = None;
    for along in 0..length {
        let p = on(joists, along, across, z);
        let runs = grid.role(p, joists) == Some(Role::Joist);
        let ran = grid.role(on(joists, along - 1, across, z), joists) == Some(Role::Joist);
        match start {
            Some(from) if ran && (bears(grid, p) || !runs) => {
                out.push([across, from, along]);
                start = runs.then_some(along);
            }
            None if runs => start = Some(along),
            _ => {}
        }
    }
}

/// Puts one beam under the longest joists, near the middle of their clear length; false when none is too long.
fn bearing_line(grid: &mut Grid, house: &House, z: i32, joists: usize, longest: i32) -> bool {
    let mut gaps = Vec::new();
    for across in (1..grid.size()[1 - joists]).step_by(2) {
        clear_lengths(grid, z, joists, across, &mut gaps);
    }
    gaps.retain(|g| g[2] - g[1] > longest);
    let Some(&[across, from, to]) = gaps.iter().max_by_key(|g| (g[2] - g[1], -g[0])) else {
        return false;
    };
    let cut = best_cut(grid, house, joists, &gaps, [from, to, longest], z);
    let mut rows: Vec<i32> = gaps.iter().filter(|g| g[1] + 1 < cut && cut < g[2] - 1).map(|g| g[0]).collect();
    rows.dedup();
    let first = rows.iter().position(|&r| r == across).unwrap_or(0);
    let (mut low, mut high) = (first, first);
    while low > 0 && rows[low] - rows[low - 1] == 2 {
        low -= 1;
    }
    while high + 1 < rows.len() && rows[high + 1] - rows[high] == 2 {
        high += 1;
    }
    let axis = 1 - joists;
    let is_wall = |g: &Grid, r: i32| g.level_at(on(axis, r, cut, z), &[Role::Plate, Role::Beam]);
    let start = if is_wall(grid, rows[low] - 1) { rows[low] - 1 } else { rows[low] };
    let end = if is_wall(grid, rows[high] + 1) { rows[high] + 1 } else { rows[high] };
    for r in start..end.max(start + 1) {
        grid.set(on(axis, r, cut, z), axis, Some(Role::Beam));
    }
    end > start
}

/// A voxel centre line near the middle of the gap whose beam crosses the fewest stair cells and ends on a stud.
fn best_cut(
    grid: &Grid,
    house: &House,
    joists: usize,
    gaps: &[[i32; 3]],
    [from, to, longest]: [i32; 3],
    z: i32,
) -> i32 {
    // Cut off one of the fewest equal bays that are short enough.
    let bays = (to - from + longest - 1) / longest;
    let middle = from + (to - from) / bays;
    let candidates = (from + 3..to - 2).filter(|c| c % 2 == 1 && (c - middle).abs() <= 3);
    let rows = |c: i32| gaps.iter().filter(move |g| g[1] < c && c < g[2]).map(|g| g[0]);
    candidates
        .min_by_key(|&c| {
            let crossed = rows(c).filter(|&r| in_stair(house, on(1 - joists, r, c, z))).count() as i32;
            let ends = [rows(c).min().unwrap_or(0) - 1, rows(c).max().unwrap_or(0) + 1];
            let loose = ends.iter().filter(|&&r| !grid.carried(on(1 - joists, r, c, z))).count() as i32;
            // Where the beam ends on a joist a post must have room under it.
            let last = [ends[0] + 1, ends[1] - 1].map(|r| on(1 - joists, r, c, z));
            let held = |n: usize| grid.carried(on(1 - joists, ends[n], c, z)) || foot(grid, house, last[n]).is_some();
            let blocked = i32::from(!held(0)) + i32::from(!held(1));
            (crossed * 4 + blocked * 12 + loose * 2 + (c - middle).abs(), c)
        })
        .unwrap_or(middle | 1)
}

/// Whether a point's cell belongs to a stair (flights, landings, foot, head) of any storey.
fn in_stair(house: &House, p: [i32; 3]) -> bool {
    let cell = [((p[0] - 1) / 2) as isize, ((p[1] - 1) / 2) as isize];
    house.stairs.iter().any(|s| {
        s.flight_cells().contains(&cell) || s.foot() == cell || s.head() == cell || s.middle_landing().contains(&cell)
    })
}

/// Posts under every beam of the plate along `axis`: at loose ends and so that no clear length exceeds `apart` half modules by more
/// than the one that brings a post to a voxel centre line.
fn posts_under_beams(grid: &mut Grid, house: &House, z: i32, axis: usize, apart: i32) {
    let (rows, length) = lines(grid, axis);
    for across in 0..rows {
        let is_beam = |g: &Grid, n: i32| g.role(on(axis, n, across, z), axis) == Some(Role::Beam);
        let mut n = 0;
        while n < length {
            if !is_beam(grid, n) {
                n += 1;
                continue;
            }
            let start = n;
            while is_beam(grid, n) {
                n += 1;
            }
            support_run(grid, house, axis, across, [start, n, apart], z);
        }
    }
}

fn support_run(grid: &mut Grid, house: &House, axis: usize, across: i32, [start, end, apart]: [i32; 3], z: i32) {
    let at = |n: i32| on(axis, n, across, z);
    let rests = |g: &Grid, n: i32| {
        let step = 1 - axis;
        let p = at(n);
        g.carried(p)
            || ((n == start || n == end)
                && [p, sub(p, STEPS[step])].iter().any(|&q| g.role(q, step) == Some(Role::Beam)))
    };
    for n in [start, end] {
        if !rests(grid, n) {
            post(grid, house, at(n));
        }
    }
    // An end over a window, or beside a stair, may rest on nothing that stands: then posts inside carry the beam alone.
    let loose = [start, end].map(|n| i32::from(!rests(grid, n)));
    let mut last = start;
    for n in start + 1..=end {
        if !rests(grid, n) && n != end {
            continue;
        }
        let needed = 1 + if last == start { loose[0] } else { 0 } + if n == end { loose[1] } else { 0 };
        let bays = ((n - last + apart - 1) / apart).max(needed);
        for b in 1..bays {
            let ideal = last + (n - last) * b / bays;
            let free = (0..6).flat_map(|d| [ideal - d, ideal + d]).filter(|m| m % 2 == 1 && *m > last && *m < n);
            let stands = |m: i32| !in_stair(house, at(m)) && foot(grid, house, at(m)).is_some();
            if let Some(m) = free.into_iter().find(|&m| stands(m)) {
                post(grid, house, at(m));
            }
        }
        last = n;
    }
}

/// Where a post under `top` stands: the foundation, or a beam or wall below; `None` where it would stand in the open or in a window.
fn foot(grid: &Grid, house: &House, top: [i32; 3]) -> Option<i32> {
    let v = &house.voxels;
    let mut foot = top[2] - STOREY;
    while foot > 0 && !grid.level_at([top[0], top[1], foot], &[Role::Beam, Role::Plate]) {
        foot -= STOREY;
    }
    let cells = |c: i32| [(c - 1).div_euclid(2), c / 2];
    let around = |k: i32| cells(top[0]).into_iter().flat_map(move |i| cells(top[1]).map(|j| label(v, i, j, k)));
    let indoors =
        (foot.max(0) / 2..top[2] / 2).all(|k| around(k).any(|l| l.is_filled()) && !around(k).any(|l| l.is_infill()));
    (indoors && foot >= 0).then_some(foot)
}

/// A post from `top` down to its [`foot`], if it has one.
fn post(grid: &mut Grid, house: &House, top: [i32; 3]) {
    for z in foot(grid, house, top).map_or(0..0, |foot| foot..top[2]) {
        if grid.role([top[0], top[1], z], Z).is_none() {
            grid.set([top[0], top[1], z], Z, Some(Role::BeamPost));
        }
    }
}
