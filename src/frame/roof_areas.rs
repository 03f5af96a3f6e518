//! Areas of roofs and of the walls at their edges, cube by cube from the heights of the drawing.

use super::areas::{Carrier, Sink};
use super::grid::{X, Y, Z, label};
use super::roof::{RoofCube, inward, step_between};
use super::types::{Area, Role};
use crate::tiles::solids::Post;
use crate::voxels::{Direction, Label, VoxelArray};

/// The direction of a sign along an axis.
fn direction(axis: usize, sign: i32) -> Direction {
    match (axis, sign > 0) {
        (X, true) => Direction::East,
        (X, false) => Direction::West,
        (_, true) => Direction::North,
        (_, false) => Direction::South,
    }
}

/// Puts the plan areas of a cube's roofs and the walls at their edges on what carries them.
pub(super) fn roof_cube(sink: &mut Sink, v: &VoxelArray, cube: &RoofCube) {
    for q in cube.roofs() {
        for axis in [X, Y] {
            slope(sink, v, cube, q, axis);
            if cube.shape.post(q ^ (1 << axis)) != Post::Roof {
                wall(sink, v, cube, q, axis);
            }
        }
    }
}

/// The half of a column's quarter that lies beside the border towards `axis`, an eighth of a module.
fn slope(sink: &mut Sink, v: &VoxelArray, cube: &RoofCube, q: usize, axis: usize) {
    let [sx, sy, _] = v.module.size_m;
    let rise = cube.shape.rise(q, axis);
    let parts = [X, Y].map(|g| rise[g] != 0);
    let share = sx * sy / 8.0 / if parts[0] && parts[1] { 2.0 } else { 1.0 };
    for g in [X, Y].into_iter().filter(|&g| parts[g]) {
        let falls = direction(g, -rise[g] * inward(q, g));
        put(sink, cube, q, g, Area::Slope(falls), share);
    }
    if !parts[0] && !parts[1] {
        put(sink, cube, q, axis, Area::Plateau, share);
    }
}

/// Steps around a column's quarter: the lines over its corner, its crease, its edges.
fn around(cube: &RoofCube, q: usize) -> [Carrier; 5] {
    let shape = &cube.shape;
    let (corner, centre) = (cube.over(q, 1), cube.centre(shape.centre()));
    let middle = |axis: usize| cube.middle(q, axis, shape.mid(q, axis));
    let edge = |axis: usize| step_between(middle(axis), centre).filter(|_| cube.ends(q, axis));
    [step_between(corner, middle(X)), step_between(corner, middle(Y)), step_between(corner, centre), edge(X), edge(Y)]
}

/// Puts an area whose slope runs along `axis` on the rafter over the corner and the one along the edge; where there is none, on the
/// crease, else on whatever stick lies around the quarter.
fn put(sink: &mut Sink, cube: &RoofCube, q: usize, axis: usize, area: Area, area_m2: f64) {
    let steps = around(cube, q);
    let rafter = |n: usize| steps[n].filter(|&(p, s)| sink.role(p, s) == Some(Role::Rafter));
    let along = if area == Area::Plateau { [rafter(X), rafter(Y)] } else { [rafter(axis), rafter(4 - axis)] };
    if sink.share(&along, area, area_m2) || sink.share(&steps[2..3], area, area_m2) {
        return;
    }
    if sink.share(&steps[..2], area, area_m2) || sink.share(&steps[3..], area, area_m2) {
        return;
    }
    // Over a plateau whose rafters run beside this quarter: to the nearest level line.
    for reach in 1..8 {
        for (p, s) in steps[..2].iter().flatten().copied() {
            let beside = [reach, -reach].map(|d| {
                let mut q = p;
                q[usize::from(s == X)] += d;
                Some((q, s))
            });
            if sink.share(&beside, area, area_m2) {
                return;
            }
        }
    }
}

/// The wall below a roof's edge, or above it where the roof ends at a wall.
fn wall(sink: &mut Sink, v: &VoxelArray, cube: &RoofCube, q: usize, axis: usize) {
    let beside = q ^ (1 << axis);
    let above = cube.shape.post(beside) == Post::Full;
    let ends = [cube.shape.mid(q, axis), cube.shape.centre()];
    let facing = direction(axis, if above { -inward(q, axis) } else { inward(q, axis) });
    let [i, j, k] = cube.cell(if above { beside } else { q });
    let size = v.module.size_m;
    for half in 0..2 {
        let covered: i32 = ends.map(|h| (h - half).clamp(0, 1)).iter().sum();
        let parts = if above { 2 - covered } else { covered };
        let built = if above { wall_label(v, [i, j, k], half) } else { label(v, i, j, k) };
        let area_m2 = f64::from(parts) * 0.125 * size[1 - axis] * size[2];
        if parts > 0 {
            facade(sink, cube.middle(q, axis, half), 1 - axis, facade_area(built, facing), area_m2);
        }
    }
}

/// The label that half of a full column's wall is built as: on a slab the wall above begins at once.
pub(super) fn wall_label(v: &VoxelArray, [i, j, k]: [i32; 3], half: i32) -> Label {
    let (below, above) = (label(v, i, j, k), label(v, i, j, k + 1));
    if half == 1 || (below.is_slab() && !above.is_slab()) { above } else { below }
}

/// What a wall of a label is.
pub(super) fn facade_area(built: Label, facing: Direction) -> Area {
    match built {
        Label::Window => Area::Window(facing),
        Label::Opening => Area::Door(facing),
        Label::Floor | Label::Foundation => Area::Band(facing),
        Label::Base | Label::Empty => Area::Wall(facing),
    }
}

/// An area of facade over one half step at `p`, `along` the wall: to the upright in it or just below, else to the uprights on both
/// sides by the lever rule.
pub(super) fn facade(sink: &mut Sink, p: [i32; 3], along: usize, area: Area, area_m2: f64) {
    let below = [p[0], p[1], p[2] - 1];
    for q in [p, below] {
        if sink.put(q, Z, area, area_m2) {
            return;
        }
    }
    let at = |n: i32| {
        let mut q = p;
        q[along] += n;
        q
    };
    let reach = |sign: i32| (1..12).map(|n| sign * n).find(|&n| sink.owned(at(n), Z));
    match (reach(-1), reach(1)) {
        (Some(a), Some(b)) => {
            let total = f64::from(b - a);
            sink.put(at(a), Z, area, area_m2 * f64::from(b) / total);
            sink.put(at(b), Z, area, area_m2 * f64::from(-a) / total);
        }
        (Some(n), None) | (None, Some(n)) => {
            sink.put(at(n), Z, area, area_m2);
        }
        (None, None) => {}
    }
}
