//! Which element carries which part of floors, facades and roofs. Every module face goes to sticks whole, so that the loads
//! add up to area x load however the house is framed.

use super::grid::{Grid, NONE, STEPS, STOREY, X, Y, label, sub};
use super::roof::RoofCube;
use super::roof_areas::{facade, facade_area, roof_cube, wall_label};
use super::types::{Area, ElementArea, HouseFrame, Role};
use crate::voxels::{Direction, House, Label};

/// A step that may carry something: start point and step.
pub(super) type Carrier = Option<([i32; 3], usize)>;

/// Fills [`HouseFrame::areas`], sorted by element and area.
pub(super) fn fill(grid: &Grid, house: &House, roofs: &[RoofCube], top: i32, frame: &mut HouseFrame) {
    let v = &house.voxels;
    let [nx, ny, nz] = v.shape().map(|n| n as i32);
    let mut sink = Sink { grid, out: &mut frame.areas };
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let l = label(v, i, j, k);
                if l == Label::Floor && k > 0 {
                    floor_cell(&mut sink, house, [i, j, k], top);
                }
                if l.is_filled() && label(v, i, j, k + 1).is_filled() {
                    facade_faces(&mut sink, house, [i, j, k]);
                }
                if l.is_slab() && k > 0 && !label(v, i, j, k - 1).is_filled() {
                    slab_edge(&mut sink, house, [i, j, k]);
                }
            }
        }
    }
    roofs.iter().for_each(|cube| roof_cube(&mut sink, v, cube));
    stairs(&mut sink, house);
    merge(&mut frame.areas);
}

/// Where areas go.
pub(super) struct Sink<'a> {
    grid: &'a Grid,
    out: &'a mut Vec<ElementArea>,
}

impl Sink<'_> {
    /// The role of a step.
    pub fn role(&self, p: [i32; 3], step: usize) -> Option<Role> {
        self.grid.role(p, step)
    }

    /// Whether a step belongs to an element.
    pub fn owned(&self, p: [i32; 3], step: usize) -> bool {
        self.grid.role(p, step).is_some() && self.grid.owner[self.grid.slot(p, step)] != NONE
    }

    /// Puts an area on a step; false when no element lies there.
    pub fn put(&mut self, p: [i32; 3], step: usize, area: Area, area_m2: f64) -> bool {
        let owned = self.owned(p, step);
        if owned {
            let element = self.grid.owner[self.grid.slot(p, step)];
            self.out.push(ElementArea { element, area, area_m2 });
        }
        owned
    }

    /// Shares an area equally among those steps that belong to an element; false when none does.
    pub fn share(&mut self, steps: &[Carrier], area: Area, area_m2: f64) -> bool {
        let owned = |s: &Carrier| s.filter(|&(p, step)| self.owned(p, step));
        let count = steps.iter().filter(|s| owned(s).is_some()).count();
        for &(p, step) in steps.iter().flatten() {
            self.put(p, step, area, area_m2 / count.max(1) as f64);
        }
        count > 0
    }
}

/// Adds up entries of the same element and area.
fn merge(areas: &mut Vec<ElementArea>) {
    areas.sort_by_key(|a| (a.element, a.area));
    areas.dedup_by(|next, kept| {
        let same = next.element == kept.element && next.area == kept.area;
        if same {
            kept.area_m2 += next.area_m2;
        }
        same
    });
}

fn plan_area(house: &House) -> f64 {
    house.voxels.module.size_m[0] * house.voxels.module.size_m[1]
}

/// The four half steps from a cell's centre, in the order of [`Direction::ALL`].
fn halves(c: [i32; 3]) -> [Carrier; 4] {
    [(c, X), (c, Y), (sub(c, STEPS[X]), X), (sub(c, STEPS[Y]), Y)].map(Some)
}

fn floor_cell(sink: &mut Sink, house: &House, [i, j, k]: [i32; 3], top: i32) {
    let v = &house.voxels;
    let roofed = label(v, i, j, k + 1).is_filled();
    let area = match (roofed, 2 * k >= top) {
        (true, false) => Area::Floor,
        (true, true) => Area::Attic,
        (false, false) => Area::Deck,
        (false, true) => Area::FlatRoof,
    };
    let around = halves([2 * i + 1, 2 * j + 1, 2 * k]);
    let joists = around.map(|s| s.filter(|&(p, step)| sink.role(p, step) == Some(Role::Joist)));
    let steps = if joists.iter().any(Option::is_some) { joists } else { around };
    sink.share(&steps, area, plan_area(house));
    if !label(v, i, j, k - 1).is_filled() {
        sink.share(&steps, Area::Soffit, plan_area(house));
    }
}

/// The two half steps of wall above the centre of voxel k on each side of a full column. In front of an underside the upper half lies
/// inside; what stands beside roofs is left to their cubes.
fn facade_faces(sink: &mut Sink, house: &House, [i, j, k]: [i32; 3]) {
    let v = &house.voxels;
    for d in Direction::ALL {
        let [dx, dy] = d.step().map(|s| s as i32);
        let (low, high) = (label(v, i + dx, j + dy, k), label(v, i + dx, j + dy, k + 1));
        let open = !low.is_filled() || (!high.is_filled() && low.is_slab());
        if !open {
            continue;
        }
        let size = v.module.size_m;
        let along = usize::from(dx != 0);
        for half in 0..if high.is_filled() { 1 } else { 2 } {
            let p = [2 * i + 1 + dx, 2 * j + 1 + dy, 2 * k + half];
            let area = facade_area(wall_label(v, [i, j, k], half), d);
            facade(sink, p, along, area, size[along] * size[2] * 0.5);
        }
    }
}

/// The edge of a slab with nothing below it: half a module high, on its rim.
fn slab_edge(sink: &mut Sink, house: &House, [i, j, k]: [i32; 3]) {
    let v = &house.voxels;
    for d in Direction::ALL {
        let [dx, dy] = d.step().map(|s| s as i32);
        if (0..2).any(|below| label(v, i + dx, j + dy, k - below).is_filled()) {
            continue;
        }
        let along = usize::from(dx != 0);
        let p = [2 * i + 1 + dx, 2 * j + 1 + dy, 2 * k];
        let rim = [Some((p, along)), Some((sub(p, STEPS[along]), along))];
        sink.share(&rim, Area::Band(d), v.module.size_m[along] * v.module.size_m[2] * 0.5);
    }
}

/// Half of each stair's flights rests on the header at its head.
fn stairs(sink: &mut Sink, house: &House) {
    for s in &house.stairs {
        let (head, last) = (s.head().map(|c| c as i32), s.flight_cells()[5].map(|c| c as i32));
        let axis = usize::from(head[0] == last[0]);
        let along = 1 - axis;
        let mut p = [0, 0, STOREY * (s.storey as i32 + 1)];
        p[axis] = 2 * head[axis].max(last[axis]);
        p[along] = 2 * last[along];
        let mut q = p;
        q[along] += 1;
        sink.share(&[Some((p, along)), Some((q, along))], Area::Stair, 3.0 * plan_area(house));
    }
}
