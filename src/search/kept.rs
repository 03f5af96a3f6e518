//! Labels of given voxels that every house keeps as they are.

use super::cells::Cells;
use super::decode;
use super::massing::{Infill, Massing, Opening, along, encode};
use super::plot::Plot;
use crate::voxels::{Direction, Given, Label, STOREY_MODULES, Stair, VoxelArray, infer_stairs};

/// Why labels cannot be kept: no house of the search has them where they stand.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum KeptError {
    /// A value that is no label.
    #[error(
        "given.keep `labels`: voxel {voxel:?} has the value {found}, expected a label: 1 base, 2 floor, 3 foundation, 4 opening, 5 window; let \
         given.occupied choose the labelled cells only, e.g. `> 0`"
    )]
    Value {
        /// The voxel.
        voxel: [usize; 3],
        /// Its value.
        found: i32,
    },
    /// A label in a layer where no house has it.
    #[error(
        "given.keep `labels`: voxel {voxel:?} is {}, but layer {} of a storey holds {expected}; shift the lattice by given.offset, or correct the label",
        .found.name(), .voxel[2] % STOREY_MODULES
    )]
    Layer {
        /// The voxel.
        voxel: [usize; 3],
        /// Its label.
        found: Label,
        /// What may stand there.
        expected: &'static str,
    },
    /// Doors or windows in a column that no opening fills.
    #[error(
        "given.keep `labels`: column ({}, {}) of storey {storey} is no door or window that a house may have: openings reach from layer 1 or 2 (doors \
         from 1) to layer 4 and are of one kind; correct the labels",
        cell[0], cell[1]
    )]
    Infill {
        /// The plan cell.
        cell: [usize; 2],
        /// The storey, from 0.
        storey: usize,
    },
    /// A hole in a plate that is no stair's.
    #[error(
        "given.keep `labels`: voxel {0:?} is base inside a floor plate, but no stair that the labels show passes there; give the voids of whole stairs \
         (1 x 5 or 2 x 4 modules) with their storeys, or leave the voids out"
    )]
    Void([usize; 3]),
}

/// Given labels, and what they fix of a house.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// In an array of the plot's shape, empty where nothing is given.
    labels: VoxelArray,
    storeys: Vec<KeptStorey>,
    /// Layers of a roof over the highest given storey, plate not counted; 0 where none is given.
    roof: usize,
}

#[derive(Clone, Debug, PartialEq)]
struct KeptStorey {
    /// Cells with a given room voxel (in the ground storey also those with a given foundation).
    fill: Cells,
    /// Cells in whose facade there is no opening.
    walls: Cells,
    /// Cells of given doors and windows.
    infill: Cells,
    /// Cells outside given doors and windows.
    outside: Cells,
    /// Cells that are slab in the plate over the storey.
    slab: Cells,
    /// The stair whose void is given.
    stair: Option<Stair>,
}

impl Kept {
    /// Reads the values of given voxels as labels. What is given above the highest storey that reaches its last layer is a roof.
    ///
    /// # Errors
    /// [`KeptError`]: a voxel and what was expected there.
    pub fn new(given: &Given, plot: &Plot) -> Result<Kept, KeptError> {
        let [gx, gy, _] = given.shape;
        let mut labels = VoxelArray::new(plot.modules);
        for (at, &value) in given.mask.iter().enumerate().filter(|(_, value)| **value >= 0) {
            let voxel = [at % gx, at / gx % gy, at / (gx * gy)];
            let label = u8::try_from(value).ok().and_then(Label::from_code).filter(|label| label.is_filled());
            labels.set(voxel, label.ok_or(KeptError::Value { voxel, found: value })?);
        }
        let count = storey_count(&labels);
        labels.iter().filter(|(_, label)| label.is_filled()).try_for_each(|(v, label)| check_layer(v, label, count))?;
        let roof = (1..STOREY_MODULES).take_while(|i| has_layer(&labels, count * STOREY_MODULES + i)).count();
        let stairs = infer_stairs(&labels);
        let mut storeys: Vec<_> = (0..count).map(|s| KeptStorey::new(&labels, s, &stairs)).collect::<Result<_, _>>()?;
        if let Some(top) = storeys.last_mut() {
            (2..=roof).for_each(|i| top.fill = top.fill.or(&below_roof(&labels, count * STOREY_MODULES + i, i - 1)));
        }
        storeys.iter_mut().for_each(KeptStorey::look_out);
        Ok(Kept { labels, storeys, roof })
    }

    /// Storeys that are given.
    pub fn storeys(&self) -> usize {
        self.storeys.len()
    }

    /// Storeys that a house may have at most: no more where a roof is given.
    pub fn most_storeys(&self) -> usize {
        if self.roof > 0 { self.storeys.len() } else { usize::MAX }
    }

    /// Least rise of the roof.
    pub fn roof_rise(&self) -> usize {
        self.roof
    }

    /// Cells that a storey must fill.
    pub fn fill(&self, storey: usize) -> Option<&Cells> {
        self.storeys.get(storey).map(|s| &s.fill)
    }

    /// Cells that must stay free of a storey, so that given doors and windows look out.
    pub fn outside(&self, storey: usize) -> Option<&Cells> {
        self.storeys.get(storey).map(|s| &s.outside)
    }

    /// Cells of a storey whose facades hold no further door or window.
    pub fn walls(&self, storey: usize) -> Option<&Cells> {
        self.storeys.get(storey).map(|s| &s.walls)
    }

    /// Cells of the plate over a storey through which no stair may break.
    pub fn slab(&self, storey: usize) -> Option<&Cells> {
        self.storeys.get(storey).map(|s| &s.slab)
    }

    /// The stair that starts in a storey.
    pub fn stair(&self, storey: usize) -> Option<Stair> {
        self.storeys.get(storey).and_then(|s| s.stair)
    }

    /// The doors and windows that are given in the facades of a storey with this footprint.
    pub fn openings(&self, footprint: &Cells, storey: usize) -> Vec<Opening> {
        if storey < self.storeys.len() { decode::openings(&self.labels, footprint, storey) } else { Vec::new() }
    }

    /// Whether a massing has every given label where it was given.
    pub fn is_kept(&self, massing: &Massing, plot: &Plot) -> bool {
        let house = encode(massing, plot);
        let mut pairs = self.labels.labels().iter().zip(house.voxels.labels());
        pairs.all(|(given, found)| !given.is_filled() || given == found)
    }
}

fn has_layer(labels: &VoxelArray, k: usize) -> bool {
    let [nx, ny, nz] = labels.shape();
    k < nz && labels.labels()[k * nx * ny..(k + 1) * nx * ny].iter().any(|label| label.is_filled())
}

/// Storeys that reach their last layer, from the ground up; one where something lower is given.
fn storey_count(labels: &VoxelArray) -> usize {
    let [_, _, nz] = labels.shape();
    let last = |s: &usize| has_layer(labels, s * STOREY_MODULES + STOREY_MODULES - 1);
    let highest = (0..nz.div_ceil(STOREY_MODULES)).filter(last).max();
    highest.map_or(usize::from((0..nz).any(|k| has_layer(labels, k))), |s| s + 1)
}

fn check_layer(voxel: [usize; 3], found: Label, storeys: usize) -> Result<(), KeptError> {
    let (storey, layer) = (voxel[2] / STOREY_MODULES, voxel[2] % STOREY_MODULES);
    let (fits, expected) = match layer {
        0 if storey == 0 => (found == Label::Foundation, "the foundation"),
        0 => (matches!(found, Label::Floor | Label::Base), "floor, or base where a stair passes"),
        _ if storey >= storeys => (found == Label::Base, "base: it lies in the roof"),
        layer if layer == STOREY_MODULES - 1 => (found == Label::Base, "base: openings end below it"),
        _ => (!found.is_slab(), "base, opening or window"),
    };
    if fits { Ok(()) } else { Err(KeptError::Layer { voxel, found, expected }) }
}

impl KeptStorey {
    fn new(labels: &VoxelArray, s: usize, stairs: &[Stair]) -> Result<KeptStorey, KeptError> {
        let [nx, ny, nz] = labels.shape();
        let (k, above) = (s * STOREY_MODULES, (s + 1) * STOREY_MODULES);
        let mut fill = Cells::new([nx, ny]);
        let mut walls = fill.clone();
        let mut slab = fill.clone();
        let mut infill = fill.clone();
        let stair = stairs.iter().copied().find(|stair| stair.storey == s);
        let voids = stair.map(|stair| stair.void_cells()).unwrap_or_default();
        for [x, y] in Cells::full([nx, ny]).iter() {
            let at = |i: usize| if k + i < nz { labels.get([x, y, k + i]) } else { Label::Empty };
            let column: [Label; STOREY_MODULES] = std::array::from_fn(at);
            fill.set([x, y], column[1..].iter().any(|l| l.is_filled()) || s == 0 && column[0].is_filled());
            let has_infill = column.iter().any(|l| l.is_infill());
            if has_infill && !is_opening(&column) {
                return Err(KeptError::Infill { cell: [x, y], storey: s });
            }
            infill.set([x, y], has_infill);
            walls.set([x, y], !has_infill && column[1..STOREY_MODULES - 1].contains(&Label::Base));
            let plate = if above < nz { labels.get([x, y, above]) } else { Label::Empty };
            slab.set([x, y], plate == Label::Floor);
            if plate == Label::Base && !voids.contains(&[x as isize, y as isize]) {
                return Err(KeptError::Void([x, y, above]));
            }
        }
        Ok(KeptStorey { outside: Cells::new([nx, ny]), infill, fill, walls, slab, stair })
    }

    /// Where it is plain which way given doors and windows look: the facade goes on beside them, and the cells before them stay free.
    fn look_out(&mut self) {
        let mut beside = Cells::new(self.fill.size());
        let step = |[x, y]: [isize; 2], [dx, dy]: [isize; 2]| [x + dx, y + dy];
        for [x, y] in self.infill.iter() {
            let cell = [x as isize, y as isize];
            let mut free = Direction::ALL.into_iter().filter(|d| !self.fill.has(step(cell, d.step())));
            let (Some(facing), None) = (free.next(), free.next()) else { continue };
            let [ax, ay] = along(facing);
            for at in [cell, step(cell, [ax, ay]), step(cell, [-ax, -ay])] {
                set(&mut beside, at);
                set(&mut self.outside, step(at, facing.step()));
            }
        }
        self.fill = self.fill.or(&beside);
    }
}

fn set(cells: &mut Cells, [x, y]: [isize; 2]) {
    if x >= 0 && y >= 0 {
        cells.set([x as usize, y as usize], true);
    }
}

/// Cells of the top storey without which a roof does not reach its layer `k`: those up to `reach` modules around the layer's.
fn below_roof(labels: &VoxelArray, k: usize, reach: usize) -> Cells {
    let [nx, ny, nz] = labels.shape();
    let mut out = Cells::new([nx, ny]);
    let filled = |x, y| k < nz && labels.get([x, y, k]).is_filled();
    for [x, y] in Cells::full([nx, ny]).iter().filter(|[x, y]| filled(*x, *y)) {
        let corner = [x as isize - reach as isize, y as isize - reach as isize];
        out = out.or(&Cells::rect([nx, ny], corner, [2 * reach + 1; 2]));
    }
    out
}

/// Whether the filled labels of a column are part of one door or window.
fn is_opening(column: &[Label; STOREY_MODULES]) -> bool {
    let infill = if column.contains(&Label::Window) { Infill::Window } else { Infill::Door };
    let label = if infill == Infill::Window { Label::Window } else { Label::Opening };
    let sills = if infill == Infill::Window { 1..=2 } else { 1..=1 };
    sills.into_iter().any(|sill| {
        (1..STOREY_MODULES).all(|i| match column[i] {
            Label::Empty => true,
            found => found == if (sill..STOREY_MODULES - 1).contains(&i) { label } else { Label::Base },
        })
    })
}
