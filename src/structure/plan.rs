//! The house seen from above: which roof lies over each plan cell, which roofs are one body, and how far its edges are.

use crate::frame::{Area, ElementArea, HouseFrame};
use crate::voxels::{Direction, Module};

/// Bits of [`Cell::faces`] after those of the four slopes.
pub(super) const PLATEAU: u8 = 1 << 4;
/// Flat roof or deck.
pub(super) const LEVEL: u8 = 1 << 5;

/// Roofs this much apart in height are not one, m. A slope rises half a module from cell to cell, a storey is 3.24 m.
const APART: f64 = 1.3;

/// No body.
const NONE: u16 = u16::MAX;

/// What lies over a plan cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// Slopes by bit `Direction as u8`, [`PLATEAU`], [`LEVEL`]. Verges are left out: where a saddle or lean-to ends, its last half
    /// module slopes outwards; that is a trim of the roof, no hip.
    pub faces: u8,
    /// Height of the roof, m; minus infinity outside the house.
    pub top: f64,
    /// Height of an underside open to the air, m; NaN where there is none.
    pub soffit: f64,
    body: u16,
    /// First and last cell of the body along x and y.
    runs: [[u16; 2]; 2],
}

const EMPTY: Cell = Cell { faces: 0, top: f64::NEG_INFINITY, soffit: f64::NAN, body: NONE, runs: [[0; 2]; 2] };

/// A connected roof: pitched with its plateaus, or level.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Body {
    /// Faces of all its cells.
    pub faces: u8,
    /// Cells that carry a slope facing each direction; none for verges.
    pub slopes: [u32; 4],
}

/// Plan cells with their roofs. Cell (i, j) reaches from i to i + 1 modules from the origin.
#[derive(Clone, Debug, Default)]
pub(super) struct Plan {
    /// Lower corner, m.
    pub origin: [f64; 2],
    /// Module along x, y, z, m.
    pub module: [f64; 3],
    size: [usize; 2],
    cells: Vec<Cell>,
    bodies: Vec<Body>,
    deep: Vec<u8>,
    /// Area and number of the half modules that lie between two cells.
    between: Vec<(u32, u32)>,
    stack: Vec<u32>,
}

/// A half module of a roof element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// Its cell.
    pub cell: [i32; 2],
    /// Ends of its tributary area along x and y, m from the origin.
    pub rect: [[f64; 2]; 2],
    /// Height, m.
    pub z: f64,
    /// Whether it lies between two cells.
    between: bool,
}

/// Faces of a roof area; `None` for what is no roof.
pub(super) fn face(area: Area) -> Option<u8> {
    match area {
        Area::Slope(d) => Some(1 << d as u8),
        Area::Plateau => Some(PLATEAU),
        Area::FlatRoof | Area::Deck => Some(LEVEL),
        _ => None,
    }
}

/// Whether an area is looked at half module by half module.
fn has_steps(area: Area) -> bool {
    face(area).is_some() || area == Area::Soffit
}

impl Plan {
    /// Reads the plan of a frame, into the buffers of `self`.
    pub fn fill(&mut self, frame: &HouseFrame) {
        let standard = Module::default().size_m;
        self.module = [0, 1, 2].map(|a| if frame.module_m[a] > 0.0 { frame.module_m[a] } else { standard[a] });
        let bound = |axis: usize, pick: fn(f64, f64) -> f64, start: f64| {
            frame.nodes.iter().fold(start, |m, n| pick(m, n[axis]))
        };
        self.origin = [0, 1].map(|a| bound(a, f64::min, f64::INFINITY));
        self.size = [0, 1].map(|a| {
            let length = bound(a, f64::max, f64::NEG_INFINITY) - self.origin[a];
            // A frame of no nodes has no length; one of a kilometre is no house.
            if length.is_finite() { (length / self.module[a]).round().clamp(1.0, 1000.0) as usize } else { 0 }
        });
        self.cells.clear();
        self.cells.resize(self.size[0] * self.size[1], EMPTY);
        // Sticks between two cells, such as verge rafters, belong to the side that has a roof: those in cells come first.
        self.between.clear();
        for (number, a) in frame.areas.iter().enumerate().filter(|(_, a)| has_steps(a.area)) {
            for n in 0..self.steps(frame, a.element as usize) {
                let step = self.step(frame, a.element as usize, a.area_m2, n);
                match step.between {
                    true => self.between.push((number as u32, n as u32)),
                    false => self.mark(a.area, &step),
                }
            }
        }
        for at in 0..self.between.len() {
            let (number, n) = self.between[at];
            let a = &frame.areas[number as usize];
            self.mark(a.area, &self.step(frame, a.element as usize, a.area_m2, n as usize));
        }
        self.find_bodies();
        self.leave_out_verges();
        self.find_runs();
    }

    fn mark(&mut self, area: Area, step: &Step) {
        if let Some(at) = self.index(step.cell) {
            self.cells[at].mark(face(area), step.z);
        }
    }

    /// The half modules of an area of roof or soffit, into `out`; none of others.
    pub fn half_modules(&self, frame: &HouseFrame, a: &ElementArea, out: &mut Vec<Step>) {
        out.clear();
        if has_steps(a.area) {
            let count = self.steps(frame, a.element as usize);
            out.extend((0..count).map(|n| self.step(frame, a.element as usize, a.area_m2, n)));
        }
    }

    /// Half modules along an element, at least one.
    fn steps(&self, frame: &HouseFrame, element: usize) -> usize {
        let [a, b] = frame.elements[element].nodes.map(|n| frame.nodes[n as usize]);
        let run = [0, 1].map(|x| (b[x] - a[x]).abs() / (0.5 * self.module[x]));
        (run[0].max(run[1]).round() as usize).max(1)
    }

    /// Step `n` of an element that carries `area_m2` of plan evenly along its length.
    fn step(&self, frame: &HouseFrame, element: usize, area_m2: f64, n: usize) -> Step {
        let [a, b] = frame.elements[element].nodes.map(|n| frame.nodes[n as usize]);
        let count = self.steps(frame, element) as f64;
        let at = |t: f64| [0, 1, 2].map(|x| a[x] + t / count * (b[x] - a[x]));
        let (from, mid, to) = (at(n as f64), at(n as f64 + 0.5), at(n as f64 + 1.0));
        let p = [0, 1].map(|x| mid[x] - self.origin[x]);
        let run = [0, 1].map(|x| (to[x] - from[x]).abs());
        // A stick along an axis stands for a module's width, a diagonal one for a square round its middle.
        let widths = match (run[0] > 1e-6, run[1] > 1e-6) {
            (true, false) => [run[0], self.module[1]],
            (false, true) => [self.module[0], run[1]],
            _ => [(area_m2 / count).sqrt(); 2],
        };
        let mut rect = [0, 1].map(|x| [p[x] - 0.5 * widths[x], p[x] + 0.5 * widths[x]]);
        let mut cell = self.cell_at(p);
        let mut between = false;
        for x in (0..2).filter(|&x| run[x] <= 1e-6) {
            let line = (p[x] / self.module[x]).round();
            if (p[x] / self.module[x] - line).abs() > 1e-6 {
                continue;
            }
            between = true;
            let sides = [line as i32 - 1, line as i32].map(|n| {
                let mut side = cell;
                side[x] = n;
                side
            });
            let [low, high] = sides.map(|c| self.cell(c).faces != 0 && (self.cell(c).top - mid[2]).abs() < APART);
            if low != high {
                // At the edge of a roof: the cell inside, over which its area is spread with that of the stick in the middle.
                cell = sides[usize::from(high)];
                let from = f64::from(cell[x]) * self.module[x];
                rect[x] = [from, from + self.module[x]];
            }
        }
        Step { cell, rect, z: mid[2], between }
    }

    /// The cell of a point, m from the origin.
    pub fn cell_at(&self, p: [f64; 2]) -> [i32; 2] {
        [0, 1].map(|x| (p[x] / self.module[x]).floor() as i32)
    }

    fn index(&self, c: [i32; 2]) -> Option<usize> {
        let inside = (0..2).all(|x| c[x] >= 0 && (c[x] as usize) < self.size[x]);
        inside.then(|| c[0] as usize + self.size[0] * c[1] as usize)
    }

    /// A cell; the empty one outside the plan.
    pub fn cell(&self, c: [i32; 2]) -> &Cell {
        self.index(c).map_or(&EMPTY, |at| &self.cells[at])
    }

    /// The body of a cell.
    pub fn body(&self, cell: &Cell) -> Body {
        self.bodies.get(cell.body as usize).copied().unwrap_or_default()
    }

    /// Whether two cells belong to one body.
    pub fn joined(&self, a: &Cell, b: &Cell) -> bool {
        a.body != NONE && a.body == b.body
    }

    /// The slopes that an area at a cell belongs to, as bits: its own, or those beside a verge.
    pub fn slopes_of(&self, cell: &Cell, d: Direction) -> u8 {
        let own = 1u8 << d as u8;
        if self.body(cell).faces & own != 0 { own } else { cell.faces & 0xf }
    }

    /// Edges of the body through a cell along an axis, m from the origin.
    pub fn edges(&self, cell: &Cell, axis: usize) -> [f64; 2] {
        let [low, high] = cell.runs[axis];
        [f64::from(low) * self.module[axis], (f64::from(high) + 1.0) * self.module[axis]]
    }

    /// The last cell of the row from `from` towards `to` that carries `bit` and belongs to its body.
    pub fn end_of(&self, from: [i32; 2], to: Direction, bit: u8) -> [i32; 2] {
        let (start, step) = (self.cell(from), to.step().map(|s| s as i32));
        let mut at = from;
        loop {
            let next = [at[0] + step[0], at[1] + step[1]];
            let cell = self.cell(next);
            if cell.faces & bit == 0 || !self.joined(start, cell) {
                return at;
            }
            at = next;
        }
    }

    fn find_bodies(&mut self) {
        self.bodies.clear();
        for first in 0..self.cells.len() {
            if self.cells[first].faces == 0 || self.cells[first].body != NONE || self.bodies.len() >= NONE as usize {
                continue;
            }
            let mut body = Body::default();
            let number = self.bodies.len() as u16;
            self.cells[first].body = number;
            self.stack.push(first as u32);
            while let Some(at) = self.stack.pop() {
                let cell = self.cells[at as usize];
                body.faces |= cell.faces;
                let c = [at as usize % self.size[0], at as usize / self.size[0]].map(|n| n as i32);
                for d in Direction::ALL {
                    let s = d.step().map(|s| s as i32);
                    let Some(next) = self.index([c[0] + s[0], c[1] + s[1]]) else { continue };
                    let other = &mut self.cells[next];
                    let alike = (other.faces & LEVEL == 0) == (cell.faces & LEVEL == 0);
                    if other.faces != 0 && other.body == NONE && alike && (other.top - cell.top).abs() < APART {
                        other.body = number;
                        self.stack.push(next as u32);
                    }
                }
            }
            self.bodies.push(body);
        }
    }

    /// Slopes that are nowhere two cells deep are verges, unless a body has no others.
    fn leave_out_verges(&mut self) {
        let nx = self.size[0];
        let place = |at: usize| [at % nx, at / nx].map(|n| n as i32);
        self.deep.clear();
        self.deep.resize(self.bodies.len(), 0);
        for (at, cell) in self.cells.iter().enumerate().filter(|(_, c)| c.body != NONE) {
            for d in Direction::ALL {
                let (c, s) = (place(at), d.step().map(|s| s as i32));
                let next = self.cell([c[0] + s[0], c[1] + s[1]]);
                if cell.faces & next.faces & (1 << d as u8) != 0 && next.body == cell.body {
                    self.deep[cell.body as usize] |= 1 << d as u8;
                }
            }
        }
        for (body, deep) in self.bodies.iter_mut().zip(&mut self.deep) {
            *deep = if *deep == 0 { 0xff } else { *deep | PLATEAU | LEVEL };
            body.faces &= *deep;
        }
        for cell in self.cells.iter_mut().filter(|c| c.body != NONE) {
            let body = cell.body as usize;
            cell.faces &= self.deep[body];
            (0..4).for_each(|d| self.bodies[body].slopes[d] += u32::from(cell.faces >> d & 1));
        }
    }

    fn find_runs(&mut self) {
        for axis in 0..2 {
            let (length, stride) = (self.size[axis], if axis == 0 { 1 } else { self.size[0] });
            for line in 0..self.size[1 - axis] {
                let start = line * if axis == 0 { self.size[0] } else { 1 };
                let mut low = 0;
                for n in 0..length {
                    let last = n + 1 == length
                        || self.cells[start + (n + 1) * stride].body != self.cells[start + n * stride].body;
                    if last {
                        for m in low..=n {
                            self.cells[start + m * stride].runs[axis] = [low as u16, n as u16];
                        }
                        low = n + 1;
                    }
                }
            }
        }
    }
}

impl Cell {
    fn mark(&mut self, roof: Option<u8>, z: f64) {
        match roof {
            None => self.soffit = z,
            Some(face) if z > self.top + APART => (self.faces, self.top) = (face, z),
            Some(face) if z > self.top - APART => (self.faces, self.top) = (self.faces | face, self.top.max(z)),
            // A deck under a roof: what the wind meets is the roof.
            Some(_) => {}
        }
    }
}
