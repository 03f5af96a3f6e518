//! Stairs between storeys as solids: flights, landings, and the railing around the opening in the floor above.

use crate::tiles::solids::{Railing, SolidStyle};
use crate::tiles::{Block, Component};
use crate::voxels::{Direction, House, Reading, STOREY_MODULES, Stair, StairKind};

/// Edges of a cell, and a module of height: three steps of 300 x 180 mm.
const CELL_UM: i32 = 900_000;
const MODULE_UM: i32 = 540_000;
const GOING_UM: i32 = 300_000;
const RISE_UM: i32 = 180_000;
/// Thickness of treads.
const TREAD_UM: i32 = 40_000;
/// Thickness of strings; what they leave of the cell is the width of the flight, 820 mm.
const STRING_UM: i32 = 40_000;
/// Depth of a string measured vertically below the line of the nosings.
const STRING_DEPTH_UM: i32 = 300_000;
/// Thickness of a landing with its treads, and side of the posts under it.
const LANDING_UM: i32 = 200_000;
const POST_UM: i32 = 80_000;
/// Hand rail of a flight: width, height of its section, height of its upper side above the nosings; posts along it.
const HAND_RAIL_UM: [i32; 3] = [40_000, 50_000, 900_000];
/// Railing on the floor, distances outwards of the opening: hand rail, posts and base rail, infill.
const RAIL_UM: [i32; 2] = [35_000, 85_000];
const RAIL_POST_UM: [i32; 2] = [40_000, 80_000];
const PANE_UM: [i32; 2] = [54_000, 66_000];
const RAIL_HEIGHT_UM: i32 = 40_000;
const BASE_UM: [i32; 2] = [60_000, 90_000];
const HALF_BAR_UM: i32 = 6_000;
const BAR_STEP_UM: i32 = 112_500;

/// Coordinates along a direction: [along, left, up] from a point of the house.
#[derive(Clone, Copy)]
struct Lane {
    origin: [i32; 3],
    run: [i32; 2],
    left: [i32; 2],
}

impl Lane {
    /// `from` is the plan cell whose centre is the origin, `z` the height of the origin.
    fn new(from: [isize; 2], z: i32, run: Direction) -> Lane {
        let step = |d: Direction| d.step().map(|s| s as i32);
        Lane { origin: [from[0] as i32 * CELL_UM, from[1] as i32 * CELL_UM, z], run: step(run), left: step(run.left()) }
    }

    /// A prism over a convex polygon of [along, left], counter-clockwise in these coordinates.
    fn prism(&self, component: Component, polygon: &[[i32; 2]], z: impl Fn([i32; 2]) -> [i32; 2]) -> Block {
        let plan = |[a, l]: [i32; 2]| [0, 1].map(|i| self.origin[i] + a * self.run[i] + l * self.left[i]);
        let heights: Vec<[i32; 2]> = polygon.iter().map(|&p| z(p).map(|z| z + self.origin[2])).collect();
        Block {
            component,
            octant: 0,
            plan: polygon.iter().map(|&p| plan(p)).collect(),
            bottom: heights.iter().map(|h| h[0]).collect(),
            top: heights.iter().map(|h| h[1]).collect(),
        }
    }

    /// The same over a rectangle, with heights that are linear along the run: z(along).
    fn beam(&self, component: Component, along: [i32; 2], left: [i32; 2], z: impl Fn(i32) -> [i32; 2]) -> Block {
        let [a, b] = along;
        self.prism(component, &[[a, left[0]], [b, left[0]], [b, left[1]], [a, left[1]]], |p| z(p[0]))
    }
}

/// The solids of all stairs of a house that join two storeys `reading` knows, in the order of the house's stairs.
///
/// Blocks are in house coordinates: µm from the centre of voxel (0, 0, 0); `octant` says nothing (0). The module is the default one.
pub fn house_stairs(house: &House, reading: &Reading, style: &SolidStyle) -> Vec<Vec<Block>> {
    house.stairs.iter().map(|stair| stair_blocks(house, stair, reading, style)).collect()
}

/// The solids of one stair: treads and strings of its flights, landing, hand rails, and the railing around the opening above.
/// Empty when one of its storeys is missing. Blocks are disjoint, in house coordinates (see [`house_stairs`]).
pub fn stair_blocks(house: &House, stair: &Stair, reading: &Reading, style: &SolidStyle) -> Vec<Block> {
    let (Some(lower), Some(upper)) = (reading.storeys.get(stair.storey), reading.storeys.get(stair.storey + 1)) else {
        return Vec::new();
    };
    if upper.plate_k != lower.plate_k + STOREY_MODULES {
        return Vec::new();
    }
    let mut blocks = Vec::new();
    let floor = lower.plate_k as i32 * MODULE_UM;
    let cells = stair.flight_cells();
    match stair.kind {
        StairKind::Straight => flight(Lane::new(cells[0], floor, stair.run), 6, true, &mut blocks),
        StairKind::UTurn => {
            let half = floor + 3 * MODULE_UM;
            flight(Lane::new(cells[0], floor, stair.run), 3, true, &mut blocks);
            flight(Lane::new(cells[3], half, stair.run.back()), 3, false, &mut blocks);
            landing(Lane::new(cells[2], half, stair.run), floor - half, &mut blocks);
            // Railings along its three outer sides, inside its edge; the side at the end runs through.
            let inside = RAIL_UM[0] + RAIL_UM[1];
            let (near, end) = (CELL_UM / 2, 3 * CELL_UM / 2);
            let corner = end - RAIL_UM[1];
            for (out, edge, span) in [
                (stair.run, end, [-near, end]),
                (stair.run.left(), end, [-corner, -near]),
                (stair.run.left().back(), near, [near, corner]),
            ] {
                run(Lane::new(cells[2], half, out), edge - inside, span, [false; 2], style, &mut blocks);
            }
        }
    }
    void_railing(house, stair, upper.plate_k, style, &mut blocks);
    blocks
}

/// A flight of `modules` modules; the lane's origin is the centre of its first cell at the level it starts from. A flight that
/// starts on a floor has its strings cut level there; one that starts at a landing runs against the landing's edge.
fn flight(lane: Lane, modules: i32, on_floor: bool, blocks: &mut Vec<Block>) {
    let start = -CELL_UM / 2;
    let steps = modules * CELL_UM / GOING_UM;
    let clear = CELL_UM / 2 - STRING_UM;
    for n in 0..steps {
        let along = [start + n * GOING_UM, start + (n + 1) * GOING_UM];
        let top = (n + 1) * RISE_UM;
        blocks.push(lane.beam(Component::StairTread, along, [-clear, clear], |_| [top - TREAD_UM, top]));
    }
    // The line of the nosings rises 180 mm over the first edge; strings end level with the last tread.
    let nosing = |a: i32| (a - start) / 5 * 3 + RISE_UM;
    let end = start + steps * GOING_UM;
    let level = steps * RISE_UM;
    let sole = start + (STRING_DEPTH_UM - RISE_UM) / 3 * 5;
    for left in [[-CELL_UM / 2, -clear], [clear, CELL_UM / 2]] {
        let mut string = |along: [i32; 2], z: &dyn Fn(i32) -> [i32; 2]| {
            blocks.push(lane.beam(Component::StairString, along, left, z));
        };
        let under = |a: i32| nosing(a) - STRING_DEPTH_UM;
        if on_floor {
            string([start, sole], &|a| [0, nosing(a)]);
            string([sole, end - GOING_UM], &|a| [under(a), nosing(a)]);
        } else {
            string([start, end - GOING_UM], &|a| [under(a), nosing(a)]);
        }
        string([end - GOING_UM, end], &|a| [under(a), level]);
        hand_rail(lane, [start, end - GOING_UM], left, &nosing, blocks);
    }
}

/// A rail along the nosings on posts that stand on the string, one at each end and one a module between.
fn hand_rail(lane: Lane, along: [i32; 2], string: [i32; 2], nosing: &dyn Fn(i32) -> i32, blocks: &mut Vec<Block>) {
    let [width, height, above] = HAND_RAIL_UM;
    let middle = (string[0] + string[1]) / 2;
    let left = [middle - width / 2, middle + width / 2];
    blocks.push(lane.beam(Component::RailingRail, along, left, |a| [nosing(a) + above - height, nosing(a) + above]));
    let count = (along[1] - along[0]) / CELL_UM;
    let last = along[1] - width;
    for at in (0..=count).map(|n| along[0] + n * CELL_UM).filter(|at| at + 2 * width < last).chain([last]) {
        let post = |a: i32| [nosing(a), nosing(a) + above - height];
        blocks.push(lane.beam(Component::RailingRail, [at, at + width], left, post));
    }
}

/// The landing of a U-stair: two cells beyond the first flight's last cell, which is the lane's origin; posts down to `floor`.
fn landing(lane: Lane, floor: i32, blocks: &mut Vec<Block>) {
    let (along, left) = ([CELL_UM / 2, 3 * CELL_UM / 2], [-CELL_UM / 2, 3 * CELL_UM / 2]);
    blocks.push(lane.beam(Component::StairTread, along, left, |_| [-TREAD_UM, 0]));
    blocks.push(lane.beam(Component::StairString, along, left, |_| [-LANDING_UM, -TREAD_UM]));
    for l in [[left[0], left[0] + POST_UM], [left[1] - POST_UM, left[1]]] {
        blocks.push(lane.beam(Component::StairString, [along[1] - POST_UM, along[1]], l, |_| [floor, -LANDING_UM]));
    }
}

/// The railing on the upper floor around the opening, on every side where there is floor to fall from but the flight's arrival.
fn void_railing(house: &House, stair: &Stair, plate_k: usize, style: &SolidStyle, blocks: &mut Vec<Block>) {
    let void = stair.void_cells();
    let slab = |[x, y]: [isize; 2]| house.voxels.at([x, y, plate_k as isize]).is_slab();
    let arrival = (stair.flight_cells()[5], stair.head());
    let surface = plate_k as i32 * MODULE_UM;
    for out in Direction::ALL {
        let step = |[x, y]: [isize; 2], d: Direction| [x + d.step()[0], y + d.step()[1]];
        let railed = |cell: [isize; 2], out: Direction| {
            let beyond = step(cell, out);
            void.contains(&cell) && !void.contains(&beyond) && slab(beyond) && (cell, beyond) != arrival
        };
        // With the outside ahead, the side runs to the left: a run begins at its right end.
        let (left, right) = (out.left(), out.left().back());
        for &first in void.iter().filter(|&&c| railed(c, out) && !railed(step(c, right), out)) {
            let mut last = first;
            let mut cells = 1;
            while railed(step(last, left), out) {
                last = step(last, left);
                cells += 1;
            }
            // Round an outer corner of the opening the railing goes on along the next side, mitred on the diagonal.
            let turns = [railed(first, right), railed(last, left)];
            let span = [-CELL_UM / 2, cells * CELL_UM - CELL_UM / 2];
            run(Lane::new(first, surface, out), CELL_UM / 2, span, turns, style, blocks);
        }
    }
}

/// One straight run of railing on the level of the lane's origin: outwards is along, the run goes to the left over `span`.
/// Distances outwards count from `edge`; `turns` says at which ends the run meets another one round an outer corner.
fn run(lane: Lane, edge: i32, span: [i32; 2], turns: [bool; 2], style: &SolidStyle, blocks: &mut Vec<Block>) {
    let [from, to] = span;
    let below = style.railing_um - RAIL_HEIGHT_UM;
    let mut put = |component: Component, out: [i32; 2], left: [[i32; 2]; 2], z: [i32; 2]| {
        let [a, b] = out.map(|o| edge + o);
        // `left`: at the near and at the far edge of the strip, where it begins and ends.
        let polygon = [[a, left[0][0]], [b, left[1][0]], [b, left[1][1]], [a, left[0][1]]];
        blocks.push(lane.prism(component, &polygon, |_| z));
    };
    let mitre = |out: i32| [if turns[0] { from - out } else { from }, if turns[1] { to + out } else { to }];
    put(Component::RailingRail, RAIL_UM, RAIL_UM.map(mitre), [below, style.railing_um]);
    let [near, far] = RAIL_POST_UM;
    let width = far - near;
    let mut posts: Vec<[i32; 2]> = Vec::new();
    posts.push(if turns[0] { [from - far, from - near] } else { [from, from + width] });
    let between = (to - from - 2 * width) / CELL_UM;
    posts.extend((1..=between).map(|n| from + n * CELL_UM).map(|at| [at - width / 2, at + width / 2]));
    posts.push(if turns[1] { [to + near, to + far] } else { [to - width, to] });
    for (n, &post) in posts.iter().enumerate() {
        // The post of a corner belongs to the run that ends there.
        if n > 0 || !turns[0] {
            put(Component::RailingRail, RAIL_POST_UM, [post; 2], [0, below]);
        }
    }
    for pair in posts.windows(2) {
        let span = [pair[0][1], pair[1][0]];
        put(Component::RailingRail, RAIL_POST_UM, [span; 2], BASE_UM);
        match style.railing {
            Railing::Glass => put(Component::RailingGlass, PANE_UM, [span; 2], [BASE_UM[1], below]),
            Railing::Bars => {
                let count = (span[1] - span[0]) / BAR_STEP_UM;
                for n in 1..=count {
                    // Whole steps of 5 µm; gaps differ by less than that.
                    let at = span[0] + (span[1] - span[0]) / (count + 1) / 5 * 5 * n;
                    put(
                        Component::RailingRail,
                        PANE_UM,
                        [[at - HALF_BAR_UM, at + HALF_BAR_UM]; 2],
                        [BASE_UM[1], below],
                    );
                }
            }
        }
    }
}
