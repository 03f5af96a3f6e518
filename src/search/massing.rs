//! The genome: a house storey by storey, and how it is written as voxels.

use super::cells::Cells;
use super::plot::Plot;
use crate::voxels::{Choices, Direction, House, Label, STOREY_MODULES, Stair, VoxelArray};

/// A genome: the shape of a house and its choices.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// The shape.
    pub massing: Massing,
    /// Sections and joist directions.
    pub choices: Choices,
}

/// The shape of a house, storey by storey.
#[derive(Clone, Debug, PartialEq)]
pub struct Massing {
    /// Storeys from the ground up, at least one.
    pub storeys: Vec<StoreyMass>,
    /// Roof over the top storey; storeys underneath that stick out are roofed by decks.
    pub roof: Roof,
}

/// One storey.
#[derive(Clone, Debug, PartialEq)]
pub struct StoreyMass {
    /// Cells with room.
    pub footprint: Cells,
    /// Windows and doors, in the order of [`Opening`].
    pub openings: Vec<Opening>,
    /// The stair to the storey above; `None` in the top storey.
    pub stair: Option<Stair>,
}

/// Roof of a house.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Roof {
    /// The top plate alone.
    Flat,
    /// A stepped pyramid of so many layers (1 to [`Roof::STEEPEST`]), sloped by the tileset.
    Hip(u8),
}

impl Roof {
    /// Most layers of a hipped roof, so that the space under it is no storey.
    pub const STEEPEST: u8 = 4;

    /// The roof that rises by so many modules, at most [`Roof::STEEPEST`]; 0 = flat.
    pub fn of_rise(rise: usize) -> Roof {
        if rise == 0 { Roof::Flat } else { Roof::Hip(rise.min(Roof::STEEPEST as usize) as u8) }
    }

    /// Layers above the top plate.
    pub fn rise(self) -> usize {
        match self {
            Roof::Flat => 0,
            Roof::Hip(rise) => rise as usize,
        }
    }
}

/// What fills an opening.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Infill {
    /// A door, one module wide, from the slab.
    Door,
    /// A window.
    Window,
}

/// A door or window: a rectangle of voxels in one facade, one deep.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Opening {
    /// Door or window. Doors sort first, so that they take their seats first.
    pub infill: Infill,
    /// Outward normal of the facade.
    pub facing: Direction,
    /// Plan cell with the smallest coordinate along the facade.
    pub cell: [isize; 2],
    /// Modules along the facade, 1 to [`Opening::WIDEST`].
    pub width: usize,
    /// Layers between the plate and the lowest voxel: 1 = on the slab (French window, door), 2 = on a parapet of 0.81 m.
    pub sill: usize,
}

impl Opening {
    /// Widest window in modules.
    pub const WIDEST: usize = 4;

    /// A door in a cell.
    pub fn door(facing: Direction, cell: [isize; 2]) -> Opening {
        Opening { infill: Infill::Door, facing, cell, width: 1, sill: 1 }
    }

    /// A window from a cell on.
    pub fn window(facing: Direction, cell: [isize; 2], width: usize, sill: usize) -> Opening {
        Opening { infill: Infill::Window, facing, cell, width, sill }
    }

    /// Modules high: every opening ends under the top room layer.
    pub fn height(&self) -> usize {
        STOREY_MODULES - 1 - self.sill
    }

    /// Step from cell to cell along the facade.
    pub fn along(&self) -> [isize; 2] {
        along(self.facing)
    }

    /// The plan cells.
    pub fn cells(&self) -> impl Iterator<Item = [isize; 2]> + use<> {
        let ([x, y], [ax, ay]) = (self.cell, self.along());
        (0..self.width as isize).map(move |i| [x + i * ax, y + i * ay])
    }
}

/// Positive step along a facade that faces `facing`.
pub fn along(facing: Direction) -> [isize; 2] {
    match facing {
        Direction::East | Direction::West => [0, 1],
        Direction::North | Direction::South => [1, 0],
    }
}

impl Massing {
    /// The top storey's footprint.
    pub fn top(&self) -> Option<&Cells> {
        self.storeys.last().map(|s| &s.footprint)
    }
}

/// Writes a massing as voxels: plates at every sixth layer, five layers of room between, roof layers on top, openings in
/// the facades, voids over the stairs. Total: what does not fit the plot is cut off.
pub fn encode(massing: &Massing, plot: &Plot) -> House {
    let mut canvas = Canvas::new(plot);
    let mut below: Option<&Cells> = None;
    for (s, storey) in massing.storeys.iter().enumerate() {
        let k = s * STOREY_MODULES;
        match below {
            None => canvas.fill(k, &storey.footprint, Label::Foundation),
            Some(lower) => canvas.fill(k, &lower.or(&storey.footprint), Label::Floor),
        }
        (1..STOREY_MODULES).for_each(|i| canvas.fill(k + i, &storey.footprint, Label::Base));
        below = Some(&storey.footprint);
    }
    if let Some(top) = massing.top() {
        canvas.roof(massing.storeys.len() * STOREY_MODULES, top, massing.roof);
    }
    for (s, storey) in massing.storeys.iter().enumerate() {
        canvas.openings(s * STOREY_MODULES, &storey.openings);
        if let Some(stair) = &storey.stair {
            stair.void_cells().into_iter().for_each(|c| canvas.set(c, (s + 1) * STOREY_MODULES, Label::Base));
        }
    }
    canvas.into_house(massing.storeys.iter().filter_map(|s| s.stair).collect())
}

struct Canvas<'a> {
    plot: &'a Plot,
    labels: Vec<Label>,
}

impl<'a> Canvas<'a> {
    fn new(plot: &'a Plot) -> Self {
        Canvas { plot, labels: vec![Label::Empty; plot.modules.iter().product()] }
    }

    fn fill(&mut self, k: usize, cells: &Cells, label: Label) {
        let [nx, ny, nz] = self.plot.modules;
        if k < nz {
            let layer = &mut self.labels[k * nx * ny..(k + 1) * nx * ny];
            cells.iter().for_each(|[x, y]| layer[x + nx * y] = label);
        }
    }

    fn set(&mut self, [x, y]: [isize; 2], k: usize, label: Label) {
        let [nx, ny, nz] = self.plot.modules;
        if x >= 0 && y >= 0 && (x as usize) < nx && (y as usize) < ny && k < nz {
            self.labels[x as usize + nx * (y as usize + ny * k)] = label;
        }
    }

    /// The top plate, then layer i of a hip over the cells at chessboard distance i or more from the outside.
    fn roof(&mut self, k: usize, top: &Cells, roof: Roof) {
        self.fill(k, top, Label::Floor);
        let mut layer = top.clone();
        for i in 1..=roof.rise() {
            self.fill(k + i, &layer, Label::Base);
            layer = layer.inner();
        }
    }

    fn openings(&mut self, k: usize, openings: &[Opening]) {
        for opening in openings {
            let label = match opening.infill {
                Infill::Door => Label::Opening,
                Infill::Window => Label::Window,
            };
            for cell in opening.cells() {
                (opening.sill..STOREY_MODULES - 1).for_each(|i| self.set(cell, k + i, label));
            }
        }
    }

    fn into_house(self, stairs: Vec<Stair>) -> House {
        let zones = match &self.plot.given {
            Some(given) => {
                self.labels.iter().zip(&given.zones).map(|(l, &z)| if l.is_filled() { z } else { -1 }).collect()
            }
            None => Vec::new(),
        };
        let empty = VoxelArray::new(self.plot.modules);
        let mut voxels = VoxelArray::from_labels(self.plot.modules, self.labels).unwrap_or(empty);
        voxels.module = self.plot.module;
        voxels.origin_m = self.plot.origin_m;
        House { voxels, stairs, zones }
    }
}
