//! The cut: a house in, its parts out.

use super::columns::Columns;
use super::facades::Facades;
use super::floors::cut_floors;
use super::roofs::cut_roofs;
use super::types::{Part, PartKind, Parts, Settings, height_modules};
use super::walls::{Site, cut_walls};
use super::{PartsError, congruence};
use crate::voxels::{Choices, FacadeOpening, House, Label, Reading, STOREY_MODULES, StairKind, VoxelArray};

/// What is being cut: the parts so far, the limits, and a buffer.
pub(super) struct Shop {
    pub parts: Parts,
    pub settings: Settings,
    forward: Vec<u64>,
    other: Vec<u64>,
    /// The picture of the last cassette, taken for the next.
    codes: Vec<u16>,
}

impl Shop {
    fn new(house: &House, settings: Settings) -> Result<Shop, PartsError> {
        let module_m = house.voxels.module.size_m;
        for size in [module_m[0], module_m[1]] {
            let limit = settings.longest_m.min(settings.widest_m);
            if size > limit + 1e-9 {
                let [module_mm, limit_mm] = [size, limit].map(|m| (m * 1000.0) as u32);
                return Err(PartsError::LimitTooSmall { module_mm, limit_mm });
            }
        }
        let [nx, ny, _] = house.voxels.shape();
        let parts = Parts {
            module_m,
            origin_m: house.voxels.origin_m,
            wall_mm: settings.wall_mm,
            // Room for what a family house is cut into, so that the lists seldom move.
            parts: Vec::with_capacity(64),
            cells: Vec::with_capacity(2 * nx * ny),
            keys: Vec::with_capacity(2 * nx * ny),
            ..Parts::default()
        };
        Ok(Shop { parts, settings, forward: Vec::new(), other: Vec::new(), codes: Vec::new() })
    }

    /// Longest panel along an axis, modules.
    pub fn most_modules(&self, axis: usize) -> usize {
        ((self.settings.longest_m + 1e-9) / self.parts.module_m[axis]) as usize
    }

    /// Widest cassette across, modules.
    pub fn widest_modules(&self, axis: usize) -> usize {
        ((self.settings.widest_m + 1e-9) / self.parts.module_m[axis]) as usize
    }

    /// Key of a wall panel: its columns and borders from the side whose picture comes first, then the ends.
    pub fn panel_key(&mut self, tokens: &[u64], [left, right]: [u64; 2]) -> (bool, [u32; 2]) {
        self.forward.clear();
        self.forward.extend([PartKind::Wall as u64, tokens.len() as u64, left]);
        self.forward.extend(tokens);
        self.forward.push(right);
        self.other.clear();
        self.other.extend([PartKind::Wall as u64, tokens.len() as u64, right]);
        self.other.extend(tokens.iter().rev());
        self.other.push(left);
        let mirrored = self.other < self.forward;
        (mirrored, self.store(mirrored))
    }

    /// An empty picture of so many cells.
    pub fn blank(&mut self, cells: usize) -> Vec<u16> {
        let mut codes = std::mem::take(&mut self.codes);
        codes.clear();
        codes.resize(cells, 0);
        codes
    }

    /// Key of a cassette from its sizes and the picture of its cells.
    pub fn sheet_key(&mut self, head: &[u64], picture: congruence::Picture) -> (bool, [u32; 2]) {
        let mut mirrored = false;
        picture.tokens([false, false], head, &mut self.forward);
        if !picture.is_even() {
            for flips in [[true, true], [true, false], [false, true]] {
                picture.tokens(flips, head, &mut self.other);
                if self.other < self.forward {
                    mirrored = flips[0] != flips[1];
                    std::mem::swap(&mut self.other, &mut self.forward);
                }
            }
        }
        self.codes = picture.codes;
        (mirrored, self.store(false))
    }

    fn store(&mut self, other: bool) -> [u32; 2] {
        let start = self.parts.keys.len() as u32;
        self.parts.keys.extend(if other { &self.other } else { &self.forward });
        [start, self.parts.keys.len() as u32]
    }

    fn piece(&mut self, part: Part, key: &[u64]) {
        let start = self.parts.keys.len() as u32;
        self.parts.keys.extend(key);
        let none = [self.parts.cells.len() as u32; 2];
        let openings = [self.parts.openings.len() as u32; 2];
        self.parts.parts.push(Part { cells: none, openings, key: [start, self.parts.keys.len() as u32], ..part });
    }
}

/// Cuts a house into parts.
///
/// Walls: each straight run of facade of a level, split at voxel borders into equal pieces no longer than [`Settings::longest_m`]; a
/// joint that would cut an opening moves to the nearest border that does not. Floors and decks: strips along the joists
/// ([`Choices::joists_along_y`]), no wider than [`Settings::widest_m`], around stair voids. Slopes: strips from the lower to the upper end
/// of each plane, ending in triangles and trapezia at hips and valleys. Level roofs: strips along the shorter side. Windows, doors and
/// stairs: one part each. The same house gives the same parts in the same order.
///
/// # Errors
/// More layers than fit a column, or limits below one module.
///
/// ```
/// use houscaper::parts::{PartKind, Settings, cut};
/// use houscaper::voxels::{Choices, read_storeys, samples};
/// let house = samples::box_house();
/// let parts = cut(&house, &read_storeys(&house), &Choices::default(), Settings::default()).expect("a low house");
/// assert_eq!((parts.count(PartKind::Wall), parts.count(PartKind::Window), parts.count(PartKind::Door)), (4, 2, 1));
/// ```
pub fn cut(house: &House, reading: &Reading, choices: &Choices, settings: Settings) -> Result<Parts, PartsError> {
    let columns = Columns::new(&house.voxels)?;
    let facades = Facades::new(&columns, house.voxels.shape()[2]);
    let mut shop = Shop::new(house, settings)?;
    let site = Site { voxels: &house.voxels, columns: &columns, facades: &facades, openings: &reading.openings };
    cut_walls(&mut shop, &site);
    cut_floors(&mut shop, house, reading, choices, &columns);
    cut_roofs(&mut shop, &columns);
    reading.openings.iter().for_each(|o| opening(&mut shop, &house.voxels, o));
    stairs(&mut shop, house);
    Ok(shop.parts)
}

fn opening(shop: &mut Shop, voxels: &VoxelArray, o: &FacadeOpening) {
    let module = shop.parts.module_m;
    let to_slab = if shop.settings.from_slab { slab_columns(voxels, o) } else { 0 };
    let (wide, high) = (o.width as u16, o.height as u16);
    let length = o.width as f64 * module[o.along()];
    let height = height_modules(wide, high, to_slab) * module[2];
    let kind = if o.label == Label::Opening { PartKind::Door } else { PartKind::Window };
    let part = Part {
        kind,
        level: (o.k.saturating_sub(1) / STOREY_MODULES) as u16,
        facing: Some(o.facing),
        axis: o.along() as u8,
        first: o.cell.map(|c| c as u16),
        modules: [wide, high],
        length_mm: 1000.0 * length,
        width_mm: 0.0,
        height_mm: 1000.0 * height,
        area_m2: length * height,
        cells: [0; 2],
        openings: [0; 2],
        key: [0; 2],
        mirrored: false,
    };
    shop.piece(part, &[kind as u64, o.width as u64, o.height as u64, u64::from(to_slab)]);
}

/// Columns of an opening that begin at the slab's top.
pub(super) fn slab_columns(voxels: &VoxelArray, opening: &FacadeOpening) -> u16 {
    (0..opening.width).filter(|&n| opening.reaches_slab(voxels, n)).count() as u16
}

fn stairs(shop: &mut Shop, house: &House) {
    for stair in &house.stairs {
        let axis = usize::from(stair.run.step()[0] == 0);
        let [along, across] = [shop.parts.module_m[axis], shop.parts.module_m[1 - axis]];
        let [length, width] = match stair.kind {
            StairKind::Straight => [6, 1],
            StairKind::UTurn => [4, 2],
        };
        let part = Part {
            kind: PartKind::Stair,
            level: stair.storey as u16,
            facing: Some(stair.run),
            axis: axis as u8,
            first: stair.start.map(|c| c as u16),
            modules: [length, width],
            length_mm: f64::from(length) * along * 1000.0,
            width_mm: f64::from(width) * across * 1000.0,
            height_mm: STOREY_MODULES as f64 * shop.parts.module_m[2] * 1000.0,
            area_m2: 0.0,
            cells: [0; 2],
            openings: [0; 2],
            key: [0; 2],
            mirrored: false,
        };
        shop.piece(part, &[PartKind::Stair as u64, stair.kind as u64]);
    }
}
