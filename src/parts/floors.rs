//! Cassettes of floors, decks and flat roofs with a slab: strips along the joists.

use super::cassettes::{Cutting, Frame, Sheet, Spot, View, bounds};
use super::columns::Columns;
use super::congruence::Picture;
use super::cut::Shop;
use super::types::{Part, PartCell, PartKind};
use crate::voxels::{Choices, Direction, House, Plan, Reading, STOREY_MODULES, walked_deck};

/// Codes of cells, see [`PartCell::code`].
const INNER: u16 = 1;
const OUTSIDE: u16 = 2;
const FLAT: u16 = 3;
const WALKED: u16 = 4;

pub(super) fn cut_floors(shop: &mut Shop, house: &House, reading: &Reading, choices: &Choices, columns: &Columns) {
    let [nx, ny] = columns.size;
    for plate in &reading.plates {
        let above = |x: usize, y: usize| columns.has(columns.at([x, y]), plate.k + 1);
        if plate.k == 0 {
            let site = plate.slab.iter().filter(|&[x, y]| !above(x, y)).count();
            shop.parts.site_deck_m2 = site as f64 * shop.parts.module_m[0] * shop.parts.module_m[1];
            continue;
        }
        let level = plate.k / STOREY_MODULES;
        let fall = if choices.joists_along_y(level - 1) { Direction::South } else { Direction::West };
        let frame = Frame { fall, size: [nx, ny] };
        let mut sheets = [Sheet::new(frame), Sheet::new(frame)];
        let mut walked: Option<Plan> = None;
        for [x, y] in plate.slab.iter() {
            let below = columns.has(columns.at([x, y]), plate.k - 1);
            if above(x, y) {
                sheets[0].set([x, y], Spot { code: if below { INNER } else { OUTSIDE }, plane: 0 });
            } else {
                let walked = walked.get_or_insert_with(|| walked_deck(house, reading, plate));
                let code = if walked.has([x as isize, y as isize]) { WALKED } else { FLAT };
                sheets[1].set([x, y], Spot { code, plane: i32::from(code) });
            }
        }
        let axis = frame.axis();
        let most = [shop.widest_modules(1 - axis), shop.most_modules(axis)];
        let cutting = Cutting { most, rectangles: true, quarters: false, ends_alike: true };
        for (sheet, kind) in sheets.iter().zip([PartKind::Floor, PartKind::Deck]) {
            if let Some(view) = View::canonical(sheet, cutting) {
                view.cut(cutting, |places| cassette(shop, sheet, places, kind, plate.k, columns));
            }
        }
    }
}

/// Adds a rectangle of a floor or deck. Floors end at the lining of outer walls: a side with no room beyond it is a wall's thickness
/// short.
fn cassette(shop: &mut Shop, sheet: &Sheet, places: &[[usize; 2]], kind: PartKind, k: usize, columns: &Columns) {
    let frame = sheet.frame;
    let axis = frame.axis();
    let [low, high] = bounds(places);
    let [rows, length] = [high[0] - low[0], high[1] - low[1]];
    let cell0 = shop.parts.cells.len() as u32;
    let mut codes = shop.blank(rows * length);
    let mut first = [u16::MAX; 2];
    let mut walls = [[true; 2]; 2];
    for &[row, column] in places {
        let cell = frame.cell([row, column]);
        let code = sheet.at([row, column]).code;
        codes[(row - low[0]) * length + column - low[1]] = code;
        let cell16 = cell.map(|c| c as u16);
        first = [first[0].min(cell16[0]), first[1].min(cell16[1])];
        shop.parts.cells.push(PartCell { cell: cell16, k: k as u16, code });
        for (a, side) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let at = [row, column][a];
            if at == [low[a], high[a] - 1][side] {
                let next = columns.at(cell).wrapping_add_signed(columns.step(beyond(frame, a, side)));
                walls[a][side] &= !columns.has(next, k + 1);
            }
        }
    }
    let t = if kind == PartKind::Floor { shop.parts.wall_mm } else { 0.0 };
    let mm = |modules: usize, a: usize, axis: usize| {
        let ends = walls[a].iter().filter(|w| **w).count() as f64;
        modules as f64 * shop.parts.module_m[axis] * 1000.0 - ends * t
    };
    let (length_mm, width_mm) = (mm(length, 1, axis), mm(rows, 0, 1 - axis));
    let head = [kind as u64, (length_mm * 10.0).round() as u64, (width_mm * 10.0).round() as u64];
    let picture = Picture { rows, columns: length, codes, quarters: false };
    let (mirrored, key) = shop.sheet_key(&head, picture);
    let openings = [shop.parts.openings.len() as u32; 2];
    shop.parts.parts.push(Part {
        kind,
        level: (k / STOREY_MODULES) as u16,
        facing: None,
        axis: axis as u8,
        first,
        modules: [length as u16, rows as u16],
        length_mm,
        width_mm,
        height_mm: 0.0,
        area_m2: length_mm * width_mm / 1e6,
        cells: [cell0, shop.parts.cells.len() as u32],
        openings,
        key,
        mirrored,
    });
}

/// Direction of the next row (a = 0) or column (1) on the lower or upper side.
fn beyond(frame: Frame, a: usize, side: usize) -> Direction {
    // Columns run against the fall, rows to the left of it.
    let up = if a == 1 { frame.fall.back() } else { frame.fall.left() };
    if side == 1 { up } else { up.back() }
}
