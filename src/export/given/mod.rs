//! A page about the given lattice: what it was, how its cells became modules, and which of them each house keeps, adds and removes, in the
//! lattice's own cells and coordinates.

mod page;

pub use page::{Page, given_html};

use std::collections::BTreeMap;

use crate::score::zone_area_m2;
use crate::voxels::lattice::Lattice;
use crate::voxels::{Given, House, STOREY_MODULES, read_storeys};

/// What became of a lattice cell in a house.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// Given and filled, all of its modules.
    Kept,
    /// Given, but some of its modules are not filled.
    Removed,
    /// Not given, and some of its modules are filled.
    Added,
}

/// A lattice cell that is given, or filled in a house.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Its indices in the lattice.
    pub cell: [usize; 3],
    /// Its zone, or its label's code; `None` where it is not given.
    pub zone: Option<i32>,
    /// What became of it.
    pub fate: Fate,
    /// Share of its modules that are filled rooms.
    pub filled: f64,
}

/// A zone in a house.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Zone {
    /// Cells given.
    pub given: usize,
    /// Of those kept.
    pub kept: usize,
    /// Of those removed, in part or wholly.
    pub removed: usize,
    /// Gross plan area in the house over all storeys, m2.
    pub area_m2: f64,
}

/// Given cells and a house.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Cells that are given or filled, by layer, row and column of the lattice.
    pub cells: Vec<Cell>,
    /// Filled room modules beyond the lattice.
    pub beyond: usize,
    /// Zones by id, or labels by code.
    pub zones: BTreeMap<i32, Zone>,
}

impl Reading {
    /// Compares a house with the cells that were given. Rooms count, with their plates; roofs do not. Where `labels` are given in place of
    /// zones a given module counts as filled where it has its label, in roofs too.
    pub fn new(given: &Given, labels: bool, house: &House) -> Reading {
        let [nx, ny, nz] = house.voxels.shape();
        let rooms = read_storeys(house).storeys.len() * STOREY_MODULES;
        let filled = |[x, y, k]: [usize; 3]| k < rooms && house.voxels.at([x, y, k].map(|v| v as isize)).is_filled();
        let map = &given.map;
        let mut cells = Vec::new();
        let mut zones: BTreeMap<i32, Zone> = BTreeMap::new();
        let span = |a: usize| map.first[a]..map.past[a];
        for cell in span(2).flat_map(|z| span(1).flat_map(move |y| span(0).map(move |x| [x, y, z]))) {
            let Some(low) = map.module(cell) else { continue };
            let zone = given.mask[low[0] + given.shape[0] * (low[1] + given.shape[1] * low[2])];
            let modules = map.size.iter().product::<usize>();
            let own = (0..modules).filter(|n| {
                let [sx, sy, _] = map.size;
                let module = [low[0] + n % sx, low[1] + n / sx % sy, low[2] + n / (sx * sy)];
                match labels && zone >= 0 {
                    true => i32::from(house.voxels.at(module.map(|v| v as isize)).code()) == zone,
                    false => filled(module),
                }
            });
            let own = own.count();
            let fate = match (zone >= 0, own) {
                (true, own) if own == modules => Fate::Kept,
                (true, _) => Fate::Removed,
                (false, 0) => continue,
                (false, _) => Fate::Added,
            };
            if zone >= 0 {
                let counts = zones.entry(zone).or_default();
                counts.given += 1;
                counts.kept += usize::from(fate == Fate::Kept);
                counts.removed += usize::from(fate == Fate::Removed);
            }
            let zone = (zone >= 0).then_some(zone);
            cells.push(Cell { cell, zone, fate, filled: own as f64 / modules as f64 });
        }
        for (zone, counts) in &mut zones {
            counts.area_m2 = zone_area_m2(house, *zone);
        }
        let all = (0..nz.min(rooms)).flat_map(|k| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, k])));
        let beyond = all.filter(|module| map.cell(*module).is_none() && filled(*module)).count();
        Reading { cells, beyond, zones }
    }

    /// Cells of a fate.
    pub fn count(&self, fate: Fate) -> usize {
        self.cells.iter().filter(|c| c.fate == fate).count()
    }
}

/// Centre of a lattice cell in the lattice's own coordinates.
pub fn centre(lattice: &Lattice, cell: [usize; 3]) -> [f64; 3] {
    [0, 1, 2].map(|a| lattice.minbound[a] + cell[a] as f64 * lattice.unit[a])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxels::lattice::{Lattice, Values};
    use crate::voxels::{Module, Resample, resample, samples};

    /// Every filled room module is in one cell or beyond the lattice, whatever is given.
    #[test]
    fn cells_hold_every_room_module_once() {
        for (name, house) in samples::all() {
            let [nx, ny, _] = house.voxels.shape();
            let rooms = read_storeys(&house).storeys.len() * STOREY_MODULES;
            let filled = house.voxels.iter().filter(|(v, label)| label.is_filled() && v[2] < rooms).count();
            // Cells of 2 x 3 x 6 modules over a part of the house; every third one is given, as zone 0 or 1.
            let shape = [nx / 2, ny / 3, 1];
            let zone = |n: usize| if n.is_multiple_of(3) { (n % 2) as f64 } else { -1.0 };
            let count = shape.iter().product::<usize>();
            let lattice =
                Lattice::new(shape, [5.0; 3], [1.8, 2.7, 3.24], Values::Number((0..count).map(zone).collect()));
            let lattice = lattice.expect("a value for each cell");
            let rule = ">= 0".parse().expect("a rule");
            let given = resample(&lattice, &rule, &Module::default(), &Resample::default()).expect("given cells");
            let reading = Reading::new(&given, false, &house);
            let held: f64 = reading.cells.iter().map(|c| c.filled * 36.0).sum();
            assert_eq!((held.round() as usize) + reading.beyond, filled, "{name}");
            let of = |fate| reading.count(fate);
            assert_eq!(of(Fate::Kept) + of(Fate::Removed), count.div_ceil(3), "{name}");
            assert!(reading.cells.iter().all(|c| c.zone.is_some() == (c.fate != Fate::Added)), "{name}");
            assert!(reading.cells.iter().all(|c| (c.fate == Fate::Kept) == (c.zone.is_some() && c.filled == 1.0)));
            let zones: usize = reading.zones.values().map(|z| z.kept + z.removed).sum();
            assert_eq!(zones, of(Fate::Kept) + of(Fate::Removed), "{name}");
            assert_eq!(centre(&lattice, [1, 0, 0]), [6.8, 5.0, 5.0]);
        }
    }
}
