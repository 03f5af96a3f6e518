//! Which element carries which part of floors, facades and roofs. Every module face goes to sticks whole, so that the loads
//! add up to area x load however the house is framed.

use super::grid::{Grid, NONE, STEPS, STOREY, X, Y, Z, label, sub};
use super::types::{Area, ElementArea, HouseFrame, Role};
use crate::voxels::{Direction, House, Label};

/// Fills [`HouseFrame::areas`], sorted by element and area.
pub(super) fn fill(grid: &Grid, house: &House, top: i32, frame: &mut HouseFrame) {
    let [nx, ny, nz] = house.voxels.shape().map(|n| n as i32);
    let mut sink = Sink { grid, out: &mut frame.areas };
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let l = label(&house.voxels, i, j, k);
                if l == Label::Floor && k > 0 {
                    floor_cell(&mut sink, house, [i, j, k], top);
                } else if l.is_filled() && !l.is_slab() && !label(&house.voxels, i, j, k + 1).is_filled() {
                    roof_cell(&mut sink, house, [i, j, k]);
                }
                if l.is_filled() && label(&house.voxels, i, j, k + 1).is_filled() {
                    facade_faces(&mut sink, house, [i, j, k]);
                }
            }
        }
    }
    stairs(&mut sink, house);
    merge(&mut frame.areas);
}

struct Sink<'a> {
    grid: &'a Grid,
    out: &'a mut Vec<ElementArea>,
}

impl Sink<'_> {
    fn put(&mut self, p: [i32; 3], step: usize, area: Area, area_m2: f64) {
        let element = self.grid.owner[self.grid.slot(p, step)];
        if element != NONE {
            self.out.push(ElementArea { element, area, area_m2 });
        }
    }

    fn share(&mut self, steps: &[([i32; 3], usize, Area)], area_m2: f64) {
        for &(p, step, area) in steps {
            self.put(p, step, area, area_m2 / steps.len() as f64);
        }
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

/// The four half steps from a cell's centre: start point and step, in the order of [`Direction::ALL`].
fn halves(c: [i32; 3]) -> [([i32; 3], usize); 4] {
    [(c, X), (c, Y), (sub(c, STEPS[X]), X), (sub(c, STEPS[Y]), Y)]
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
    let with = |roles: &[Role]| {
        around
            .iter()
            .filter(|&&(p, s)| sink.grid.role(p, s).is_some_and(|r| roles.contains(&r)))
            .map(|&(p, s)| (p, s, area))
            .collect::<Vec<_>>()
    };
    let mut steps = with(&[Role::Joist]);
    if steps.is_empty() {
        steps = with(&Role::ALL);
    }
    sink.share(&steps, plan_area(house));
    if !label(v, i, j, k - 1).is_filled() {
        steps.iter_mut().for_each(|s| s.2 = Area::Soffit);
        sink.share(&steps, plan_area(house));
    }
}

fn roof_cell(sink: &mut Sink, house: &House, [i, j, k]: [i32; 3]) {
    let c = [2 * i + 1, 2 * j + 1, 2 * k + 1];
    let mut steps: Vec<([i32; 3], usize, Area)> = Vec::with_capacity(4);
    let mut spare: Vec<([i32; 3], usize, Area)> = Vec::with_capacity(4);
    for (d, (level, axis)) in Direction::ALL.into_iter().zip(halves(c)) {
        let [dx, dy] = d.step().map(|s| s as i32);
        let slope = |s: [i32; 2]| STEPS.iter().position(|&t| t == [s[0], s[1], 1]).unwrap_or(Z);
        let below = ([c[0] + dx, c[1] + dy, c[2] - 1], slope([-dx, -dy]), Area::Slope(d));
        let above = (c, slope([dx, dy]), Area::Slope(d.back()));
        for half in [below, above] {
            if sink.grid.role(half.0, half.1) == Some(Role::Rafter) {
                steps.push(half);
            }
        }
        match sink.grid.role(level, axis) {
            Some(Role::Rafter) => steps.push((level, axis, Area::Plateau)),
            Some(_) => spare.push((level, axis, Area::Plateau)),
            None => {}
        }
    }
    if steps.len() < 2 {
        steps.extend(spare);
    }
    if steps.is_empty() {
        let hips = (7..STEPS.len()).flat_map(|s| [(c, s), (sub(c, STEPS[s]), s)]);
        steps.extend(hips.filter(|&(p, s)| sink.grid.role(p, s).is_some()).map(|(p, s)| (p, s, Area::Plateau)));
    }
    sink.share(&steps, plan_area(house));
}

/// The two half steps of wall above the centre of voxel k on each side of a full column.
fn facade_faces(sink: &mut Sink, house: &House, [i, j, k]: [i32; 3]) {
    let v = &house.voxels;
    for d in Direction::ALL {
        let [dx, dy] = d.step().map(|s| s as i32);
        let (low, high) = (label(v, i + dx, j + dy, k), label(v, i + dx, j + dy, k + 1));
        let open = !high.is_filled() && (!low.is_filled() || low.is_slab()) || !low.is_filled();
        if !open {
            continue;
        }
        for half in 0..2 {
            let inner = label(v, i, j, k + half);
            let area = match inner {
                Label::Window => Area::Window(d),
                Label::Opening => Area::Door(d),
                Label::Floor | Label::Foundation => Area::Band(d),
                Label::Base | Label::Empty => Area::Wall(d),
            };
            facade_step(sink, house, [2 * i + 1 + dx, 2 * j + 1 + dy, 2 * k + half], usize::from(dx != 0), area);
        }
    }
}

/// One half step of one module of facade: to the stud in it, else to the verticals on both sides by the lever rule.
fn facade_step(sink: &mut Sink, house: &House, p: [i32; 3], along: usize, area: Area) {
    let size = house.voxels.module.size_m;
    let area_m2 = size[along] * size[2] * 0.5;
    if sink.grid.role(p, Z).is_some() {
        return sink.put(p, Z, area, area_m2);
    }
    let reach = |sign: i32| {
        (1..12).find(|n| {
            let mut q = p;
            q[along] += sign * n;
            sink.grid.role(q, Z).is_some()
        })
    };
    let at = |n: i32| {
        let mut q = p;
        q[along] += n;
        q
    };
    match (reach(-1), reach(1)) {
        (Some(a), Some(b)) => {
            let total = f64::from(a + b);
            sink.put(at(-a), Z, area, area_m2 * f64::from(b) / total);
            sink.put(at(b), Z, area, area_m2 * f64::from(a) / total);
        }
        (Some(a), None) => sink.put(at(-a), Z, area, area_m2),
        (None, Some(b)) => sink.put(at(b), Z, area, area_m2),
        (None, None) => {}
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
        let steps: Vec<_> = [p, q]
            .into_iter()
            .filter(|&r| sink.grid.role(r, along).is_some())
            .map(|r| (r, along, Area::Stair))
            .collect();
        sink.share(&steps, 3.0 * plan_area(house));
    }
}
