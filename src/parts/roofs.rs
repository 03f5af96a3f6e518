//! Roof cassettes: strips of each slope from its lower to its upper end, and strips of level roofs.

use super::cassettes::{Cutting, Frame, Sheet, Spot, View, bounds};
use super::columns::{Columns, Heights};
use super::congruence::Picture;
use super::cut::Shop;
use super::types::{Part, PartCell, PartKind};
use crate::voxels::{Direction, STOREY_MODULES};

/// The top of one column, cut up: for each direction it falls to, and level, two bits a quarter.
struct RoofCell {
    cell: [usize; 2],
    k: usize,
    falls: [u16; 4],
    level: u16,
}

/// Cuts all roofs: first the uppermost of every column, then what lies below an overhang.
pub(super) fn cut_roofs(shop: &mut Shop, columns: &Columns) {
    let [nx, ny] = columns.size;
    let mut roofs: Vec<u128> = Vec::with_capacity(nx * ny);
    for y in 0..ny {
        roofs.extend((0..nx).map(|x| columns.roof(columns.at([x, y]))));
    }
    let mut cells: Vec<RoofCell> = Vec::new();
    let mut heights = Heights::new(columns);
    loop {
        cells.clear();
        for (n, mask) in roofs.iter_mut().enumerate().filter(|(_, m)| **m != 0) {
            let k = 127 - mask.leading_zeros() as usize;
            *mask &= !(1u128 << k);
            cells.push(read(columns, &mut heights, [n % nx, n / nx], k));
        }
        if cells.is_empty() {
            return;
        }
        for fall in Direction::ALL {
            slope(shop, &cells, Frame { fall, size: [nx, ny] });
        }
        level(shop, &cells, [nx, ny]);
    }
}

/// What one of the two triangles of a quarter does.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Lies {
    Level,
    Falls(Direction),
}

impl Lies {
    /// From the rises outwards along the axis of the border that the triangle lies beside, and along the other; the first decides.
    fn new(rises: [(i8, Direction); 2]) -> Lies {
        let sloping = rises.into_iter().find(|(rise, _)| *rise != 0);
        sloping.map_or(Lies::Level, |(rise, d)| Lies::Falls(if rise < 0 { d } else { d.back() }))
    }
}

/// Bits of a quarter that is covered whole, or by the triangle beside the border that the part's axis meets, or by the other one.
const WHOLE: u16 = 1;
const BESIDE: u16 = 2;
const ACROSS: u16 = 3;

fn read(columns: &Columns, known: &mut Heights, cell: [usize; 2], k: usize) -> RoofCell {
    let at = columns.at(cell);
    let heights = known.of(at, k).map(|h| h as i8);
    let mut roof = RoofCell { cell, k, falls: [0; 4], level: 0 };
    for q in 0..4 {
        let dx = if q & 1 == 1 { Direction::East } else { Direction::West };
        let dy = if q & 2 == 2 { Direction::North } else { Direction::South };
        let [x, y] = [heights[dx as usize], heights[dy as usize]];
        let centre = known.centre(at, k, [dx, dy]) as i8;
        // The triangle beside the x-neighbour's border, then the one beside the y-neighbour's: see the tiles' roof heights.
        let lies = [Lies::new([(x - 1, dx), (centre - x, dy)]), Lies::new([(y - 1, dy), (centre - y, dx)])];
        let mut add = |lies: Lies, bits: [u16; 2]| match lies {
            // A level quarter is told as for a part along x.
            Lies::Level => roof.level |= bits[0] << (2 * q),
            Lies::Falls(d) => roof.falls[d as usize] |= bits[usize::from(d.step()[0] == 0)] << (2 * q),
        };
        if lies[0] == lies[1] {
            add(lies[0], [WHOLE; 2]);
        } else {
            add(lies[0], [BESIDE, ACROSS]);
            add(lies[1], [ACROSS, BESIDE]);
        }
    }
    roof
}

/// A code told for a part along x, told for one along the axis of a frame: the triangles change their names.
fn along(code: u16, frame: Frame) -> u16 {
    if frame.axis() == 0 { code } else { code ^ (code >> 1 & 0x55) }
}

/// A code with its quarters renumbered for a frame.
fn turned(code: u16, frame: Frame) -> u16 {
    (0..4).fold(0, |out, q| out | (code >> (2 * q) & 3) << (2 * frame.quarter(q)))
}

fn slope(shop: &mut Shop, cells: &[RoofCell], frame: Frame) {
    let mut sheet = Sheet::new(frame);
    for roof in cells.iter().filter(|c| c.falls[frame.fall as usize] != 0) {
        let column = frame.place(roof.cell)[1];
        let code = turned(roof.falls[frame.fall as usize], frame);
        sheet.set(roof.cell, Spot { code, plane: roof.k as i32 - column as i32 });
    }
    let axis = frame.axis();
    let [run, dz] = [shop.parts.module_m[axis], shop.parts.module_m[2]];
    let secant = (1.0 + (dz / run).powi(2)).sqrt();
    let along = (((shop.settings.longest_m + 1e-9) / (run * secant)) as usize).max(1);
    let most = [shop.widest_modules(1 - axis), along];
    let cutting = Cutting { most, rectangles: false, quarters: true, ends_alike: false };
    if let Some(view) = View::canonical(&sheet, cutting) {
        view.cut(cutting, |places| cassette(shop, &sheet, places, PartKind::Slope, secant));
    }
}

fn level(shop: &mut Shop, cells: &[RoofCell], size: [usize; 2]) {
    // Cells by place, until they have joined a group.
    let mut left: Vec<Option<usize>> =
        vec![None; if cells.iter().any(|c| c.level != 0) { size[0] * size[1] } else { 0 }];
    let place = |[x, y]: [usize; 2]| x + size[0] * y;
    for (n, roof) in cells.iter().enumerate().filter(|(_, c)| c.level != 0) {
        left[place(roof.cell)] = Some(n);
    }
    let mut group = Vec::new();
    for start in (0..left.len()).rev() {
        let Some(first) = left[start].take() else { continue };
        group.clear();
        group.push(first);
        let mut next = 0;
        while next < group.len() {
            let RoofCell { cell: [x, y], k, .. } = cells[group[next]];
            next += 1;
            for beside in [[x.wrapping_sub(1), y], [x + 1, y], [x, y.wrapping_sub(1)], [x, y + 1]] {
                if beside[0] < size[0] && beside[1] < size[1] {
                    let other = &mut left[place(beside)];
                    group.extend(other.take_if(|n| cells[*n].k == k));
                }
            }
        }
        plateau(shop, cells, &group, size);
    }
}

/// One connected level roof: strips along its shorter side, or along it where it is a ridge no wider than a cassette.
fn plateau(shop: &mut Shop, cells: &[RoofCell], group: &[usize], size: [usize; 2]) {
    let sheet = |fall| {
        let frame = Frame { fall, size };
        let mut sheet = Sheet::new(frame);
        for &n in group {
            let spot = Spot { code: turned(along(cells[n].level, frame), frame), plane: cells[n].k as i32 };
            sheet.set(cells[n].cell, spot);
        }
        sheet
    };
    let cutting = |axis: usize| Cutting {
        most: [shop.widest_modules(1 - axis), shop.most_modules(axis)],
        rectangles: true,
        quarters: true,
        ends_alike: true,
    };
    let sheets = [sheet(Direction::West), sheet(Direction::South)];
    let [Some(along_x), Some(along_y)] = [0, 1].map(|a| View::canonical(&sheets[a], cutting(a))) else { return };
    let extent = |a: usize| {
        group.iter().map(|&n| cells[n].cell[a]).max().unwrap_or(0)
            - group.iter().map(|&n| cells[n].cell[a]).min().unwrap_or(0)
            + 1
    };
    let [nx, ny] = [extent(0), extent(1)];
    let thin = nx.min(ny) <= shop.widest_modules(if nx < ny { 0 } else { 1 });
    let axis = match nx.cmp(&ny) {
        std::cmp::Ordering::Equal => usize::from(along_y.comes_before(&along_x)),
        std::cmp::Ordering::Less => usize::from(thin),
        std::cmp::Ordering::Greater => usize::from(!thin),
    };
    let view = if axis == 0 { along_x } else { along_y };
    view.cut(cutting(axis), |places| cassette(shop, &sheets[axis], places, PartKind::Level, 1.0));
}

/// Adds a cassette of a roof. Sizes are those of the box around its quarters, along the slope; overhangs are not counted.
fn cassette(shop: &mut Shop, sheet: &Sheet, places: &[[usize; 2]], kind: PartKind, secant: f64) {
    let frame = sheet.frame;
    let axis = frame.axis();
    let [low, high] = bounds(places);
    let [rows, length] = [high[0] - low[0], high[1] - low[1]];
    let cell0 = shop.parts.cells.len() as u32;
    let mut codes = shop.blank(rows * length);
    let (mut first, mut level) = ([u16::MAX; 2], u16::MAX);
    // Half modules of the box, across and along, and its eighths of a cell.
    let (mut from, mut to, mut eighths) = ([usize::MAX; 2], [0; 2], 0u32);
    for &[row, column] in places {
        let cell = frame.cell([row, column]);
        let Spot { code, plane } = sheet.at([row, column]);
        codes[(row - low[0]) * length + column - low[1]] = code;
        let k = if kind == PartKind::Slope { plane + column as i32 } else { plane } as u16;
        let cell = cell.map(|c| c as u16);
        first = [first[0].min(cell[0]), first[1].min(cell[1])];
        level = level.min(k.saturating_sub(1) / STOREY_MODULES as u16);
        shop.parts.cells.push(PartCell { cell, k, code });
        for q in (0..4).filter(|q| code >> (2 * q) & 3 != 0) {
            eighths += if code >> (2 * q) & 3 == WHOLE { 2 } else { 1 };
            let half = [2 * row + (q >> 1), 2 * column + (q & 1)];
            from = [from[0].min(half[0]), from[1].min(half[1])];
            to = [to[0].max(half[0] + 1), to[1].max(half[1] + 1)];
        }
    }
    let [along, across] = [shop.parts.module_m[axis], shop.parts.module_m[1 - axis]];
    let length_mm = (to[1] - from[1]) as f64 * 500.0 * along * secant;
    let width_mm = (to[0] - from[0]) as f64 * 500.0 * across;
    let head = [kind as u64, (length_mm * 10.0).round() as u64, (width_mm * 10.0).round() as u64];
    let picture = Picture { rows, columns: length, codes, quarters: true };
    let (mirrored, key) = shop.sheet_key(&head, picture);
    let openings = [shop.parts.openings.len() as u32; 2];
    shop.parts.parts.push(Part {
        kind,
        level,
        facing: (kind == PartKind::Slope).then_some(frame.fall),
        axis: axis as u8,
        first,
        modules: [length as u16, rows as u16],
        length_mm,
        width_mm,
        height_mm: 0.0,
        area_m2: f64::from(eighths) / 8.0 * along * across * secant,
        cells: [cell0, shop.parts.cells.len() as u32],
        openings,
        key,
        mirrored,
    });
}
