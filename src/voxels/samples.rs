//! Small houses that keep every rule, for tests, benches and first steps; and the functions that draw them.

use super::{Direction, House, Label, Plan, STOREY_MODULES, Stair, StairKind, VoxelArray};

pub use super::samples_gallery::gallery;

/// A rectangle of plan cells: smallest x and y, cells along x and along y.
pub type Rect = [usize; 4];

/// A house of storeys without openings: `storeys[s]` is the footprint of storey s as a union of rectangles.
///
/// Layer 0 is foundation under the ground storey; each plate above covers the footprints below and above it; five layers of
/// base make the rooms. `rise` layers of hipped roof follow on the top plate (0 = flat): layer i holds the cells whose
/// chessboard distance to the outside is at least i. Rectangles must lie inside `shape`.
pub fn massing(shape: [usize; 3], storeys: &[&[Rect]], rise: usize) -> House {
    let mut voxels = VoxelArray::new(shape);
    let plans: Vec<Plan> = storeys.iter().map(|rects| plan_of([shape[0], shape[1]], rects)).collect();
    for (s, plan) in plans.iter().enumerate() {
        let k = s * STOREY_MODULES;
        let plate = if s == 0 { Label::Foundation } else { Label::Floor };
        fill(&mut voxels, plan, k, plate);
        (1..STOREY_MODULES).for_each(|d| fill(&mut voxels, plan, k + d, Label::Base));
        fill(&mut voxels, plan, k + STOREY_MODULES, Label::Floor);
    }
    let top = plans.len() * STOREY_MODULES;
    if let Some(mut plan) = plans.last().cloned() {
        for i in 1..=rise {
            fill(&mut voxels, &plan, top + i, Label::Base);
            plan = erode(&plan);
        }
    }
    House::new(voxels)
}

fn plan_of(size: [usize; 2], rects: &[Rect]) -> Plan {
    let mut plan = Plan::new(size);
    for &[x0, y0, w, d] in rects {
        (y0..y0 + d).for_each(|y| (x0..x0 + w).for_each(|x| plan.set([x, y], true)));
    }
    plan
}

fn fill(voxels: &mut VoxelArray, plan: &Plan, k: usize, label: Label) {
    plan.iter().for_each(|[x, y]| voxels.set([x, y, k], label));
}

/// The cells whose eight neighbours are in the set too.
fn erode(plan: &Plan) -> Plan {
    let mut inner = Plan::new(plan.size());
    for [x, y] in plan.iter() {
        let all = (-1..=1).all(|dy| (-1..=1).all(|dx| plan.has([x as isize + dx, y as isize + dy])));
        inner.set([x, y], all);
    }
    inner
}

/// Puts a window of `width` modules in storey `storey`, sill at 0.81 m, three modules high; `cell` is its first voxel
/// column (smallest coordinate along the facade).
pub fn window(house: &mut House, storey: usize, facing: Direction, cell: [usize; 2], width: usize) {
    infill(house, storey, facing, cell, width, 2, Label::Window);
}

/// Puts a French window on the slab, four modules high.
pub fn french_window(house: &mut House, storey: usize, facing: Direction, cell: [usize; 2], width: usize) {
    infill(house, storey, facing, cell, width, 1, Label::Window);
}

/// Puts a door of one module on the slab, four modules high.
pub fn door(house: &mut House, storey: usize, cell: [usize; 2]) {
    infill(house, storey, Direction::South, cell, 1, 1, Label::Opening);
}

fn infill(
    house: &mut House,
    storey: usize,
    facing: Direction,
    [x, y]: [usize; 2],
    width: usize,
    first: usize,
    label: Label,
) {
    let [dx, dy] = match facing {
        Direction::North | Direction::South => [1, 0],
        Direction::East | Direction::West => [0, 1],
    };
    for n in 0..width {
        for row in first..STOREY_MODULES - 1 {
            house.voxels.set([x + n * dx, y + n * dy, storey * STOREY_MODULES + row], label);
        }
    }
}

/// Adds a stair and leaves out the plate above it. The stair must lie inside the array.
pub fn add_stair(house: &mut House, stair: Stair) {
    for cell in stair.void_cells() {
        let [x, y] = cell.map(|c| c.max(0) as usize);
        house.voxels.set([x, y, (stair.storey + 1) * STOREY_MODULES], Label::Base);
    }
    house.stairs.push(stair);
}

/// One storey of 7 x 6 modules with a flat roof, a door to the south and two windows, in 9 x 8 x 8 voxels.
pub fn box_house() -> House {
    let mut house = massing([9, 8, 8], &[&[[1, 1, 7, 6]]], 0);
    door(&mut house, 0, [2, 1]);
    window(&mut house, 0, Direction::South, [4, 1], 3);
    window(&mut house, 0, Direction::East, [7, 3], 2);
    house
}

/// Two storeys of 8 x 7 modules with a u-turn stair under a hipped roof, in 10 x 9 x 16 voxels.
///
/// ```text
/// upper plan, y up; # wall, v stair void, h head of the stair
/// # # # # # # # #
/// # . . . . . . #
/// # . . . . . . #
/// # h v v v v . #
/// # . v v v v . #
/// # . . . . . . #
/// # # # # # # # #
/// ```
pub fn hip_house() -> House {
    let mut house = massing([10, 9, 16], &[&[[1, 1, 8, 7]], &[[1, 1, 8, 7]]], 3);
    add_stair(&mut house, Stair { storey: 0, start: [3, 3], run: Direction::East, kind: StairKind::UTurn });
    door(&mut house, 0, [3, 1]);
    french_window(&mut house, 0, Direction::South, [5, 1], 2);
    window(&mut house, 0, Direction::East, [8, 3], 3);
    window(&mut house, 1, Direction::South, [3, 1], 3);
    window(&mut house, 1, Direction::North, [4, 7], 2);
    house
}

/// One storey on an L of 9 x 9 modules with wings four wide, under a hipped roof, in 11 x 11 x 10 voxels.
pub fn l_house() -> House {
    let mut house = massing([11, 11, 10], &[&[[1, 1, 9, 4], [1, 1, 4, 9]]], 2);
    door(&mut house, 0, [2, 1]);
    window(&mut house, 0, Direction::South, [4, 1], 4);
    window(&mut house, 0, Direction::West, [1, 5], 3);
    house
}

/// A ground storey of 12 x 7 modules, an upper storey of 9 x 7 beside a deck with a door onto it, joined by a straight
/// stair along x, in 14 x 9 x 14 voxels.
///
/// ```text
/// section along x:      222222      roof plate
///                       111111
///                       2222222222  plate: deck to the right
///                       1111111111
///                       3333333333
/// ```
pub fn deck_house() -> House {
    let mut house = massing([14, 9, 14], &[&[[1, 1, 12, 7]], &[[1, 1, 9, 7]]], 0);
    add_stair(&mut house, Stair { storey: 0, start: [8, 4], run: Direction::West, kind: StairKind::Straight });
    door(&mut house, 0, [10, 1]);
    french_window(&mut house, 0, Direction::South, [3, 1], 3);
    window(&mut house, 0, Direction::West, [1, 3], 3);
    window(&mut house, 1, Direction::South, [4, 1], 4);
    window(&mut house, 1, Direction::West, [1, 3], 2);
    door(&mut house, 1, [9, 5]);
    house
}

/// All sample houses with their names.
pub fn all() -> [(&'static str, House); 4] {
    [("box", box_house()), ("hip", hip_house()), ("l", l_house()), ("deck", deck_house())]
}
