//! Wall panels: facade runs of a storey, split at voxel borders.

use super::columns::Columns;
use super::cut::Shop;
use super::facades::Facades;
use super::types::{PanelOpening, Part, PartCell, PartKind};
use crate::voxels::{Direction, FacadeOpening, Label, STOREY_MODULES};

/// A run of facade, seen from outside from left to right.
#[derive(Default)]
pub(super) struct Run {
    /// Per column its mask with windows (from bit 16) and doors (from bit 32), and between two columns the rows of an opening that
    /// goes across.
    tokens: Vec<u64>,
    openings: Vec<PanelOpening>,
    joints: Vec<usize>,
}

/// Where a run or a panel lies.
#[derive(Clone, Copy)]
struct Place {
    level: usize,
    facing: Direction,
    /// Plan cell of the leftmost column.
    start: [isize; 2],
}

impl Place {
    fn cell(&self, n: usize) -> [usize; 2] {
        let [dx, dy] = self.facing.left().step();
        [(self.start[0] + dx * n as isize) as usize, (self.start[1] + dy * n as isize) as usize]
    }
}

/// Cuts all walls of a house.
pub(super) fn cut_walls(shop: &mut Shop, columns: &Columns, facades: &Facades, openings: &[FacadeOpening]) {
    let mut run = Run::default();
    for level in 0..facades.levels {
        for facing in Direction::ALL {
            let right = facing.left();
            let axis = usize::from(right.step()[0] == 0);
            let (length, lines) = (columns.size[axis], columns.size[1 - axis]);
            let forwards = right.step()[axis] > 0;
            for line in (0..lines).filter(|&line| facades.stands(level, facing, line)) {
                let mut start = [line as isize; 2];
                start[axis] = if forwards { 0 } else { length as isize - 1 };
                let row = Place { level, facing, start };
                cut_line(shop, columns, facades, openings, row, length, &mut run);
            }
        }
    }
}

fn cut_line(
    shop: &mut Shop,
    columns: &Columns,
    facades: &Facades,
    openings: &[FacadeOpening],
    row: Place,
    length: usize,
    run: &mut Run,
) {
    let first = columns.at(row.cell(0));
    let step = columns.step(row.facing.left());
    let mask = |n: usize| facades.mask(row.level, row.facing, first.wrapping_add_signed(step * n as isize));
    let mut n = 0;
    while n < length {
        if mask(n) == 0 {
            n += 1;
            continue;
        }
        let begin = n;
        run.tokens.clear();
        run.tokens.push(u64::from(mask(n)));
        n += 1;
        while n < length && mask(n) & mask(n - 1) != 0 {
            run.tokens.extend([0, u64::from(mask(n))]);
            n += 1;
        }
        let start = row.cell(begin).map(|c| c as isize);
        let place = Place { start, ..row };
        note_openings(run, openings, place);
        split(run, shop.most_modules(usize::from(row.facing.left().step()[0] == 0)));
        for piece in 0..run.joints.len() - 1 {
            let span = [run.joints[piece], run.joints[piece + 1]];
            panel(shop, columns, facades, run, place, span);
        }
    }
}

/// Rows of an opening as half modules above the slab: what stands on the slab begins there.
fn rows(o: &PanelOpening) -> u64 {
    let top = (2 * u32::from(o.height) + u32::from(o.sill) - u32::from(o.sill == 0)).min(12);
    (1u64 << top) - (1u64 << u32::from(o.sill).min(top))
}

fn note_openings(run: &mut Run, openings: &[FacadeOpening], place: Place) {
    run.openings.clear();
    let columns = run.tokens.len() / 2 + 1;
    let left = place.cell(0);
    let along = usize::from(place.facing.left().step()[0] == 0);
    let forwards = place.facing.left().step()[along] > 0;
    for (index, o) in openings.iter().enumerate() {
        let level = o.k.saturating_sub(1) / STOREY_MODULES;
        if o.facing != place.facing || level != place.level || o.cell[1 - along] != left[1 - along] {
            continue;
        }
        let (low, high) = (o.cell[along], o.cell[along] + o.width - 1);
        let from = if forwards { low.checked_sub(left[along]) } else { left[along].checked_sub(high) };
        let Some(from) = from.filter(|f| f + o.width <= columns) else { continue };
        let above = o.k - STOREY_MODULES * level;
        let sill = if above <= 1 { 0 } else { 2 * above - 1 };
        let opening = PanelOpening {
            label: o.label,
            from: from as u16,
            width: o.width as u16,
            sill: sill as u16,
            height: o.height as u16,
            index: index as u16,
        };
        let shift = if o.label == Label::Opening { 32 } else { 16 };
        for n in from..from + o.width {
            run.tokens[2 * n] |= rows(&opening) << shift;
            if n > from {
                run.tokens[2 * n - 1] |= rows(&opening);
            }
        }
        run.openings.push(opening);
    }
    run.openings.sort_unstable_by_key(|o| (o.from, o.sill));
}

/// Joints of a run, its ends included, so that no piece is longer than `most` modules and none cuts an opening: equal pieces as far as
/// openings allow, counted from the end whose picture comes first, so that a mirrored run is cut in mirror image.
fn split(run: &mut Run, most: usize) {
    let length = run.tokens.len() / 2 + 1;
    run.joints.clear();
    run.joints.push(0);
    if length > most {
        let backwards = run.tokens.iter().rev().lt(run.tokens.iter());
        let is_free = |joint: usize| {
            let border = if backwards { length - joint } else { joint };
            run.tokens[2 * border - 1] == 0
        };
        let mut start = 0;
        while length - start > most {
            let pieces = (length - start).div_ceil(most);
            let ideal = start + (length - start).div_ceil(pieces);
            let near = (0..most).flat_map(|d| [ideal.wrapping_sub(d), ideal + d]);
            let fits = |j: &usize| *j > start && *j < length && *j - start <= most && is_free(*j);
            let Some(joint) = near.into_iter().find(fits).or_else(|| (start + most + 1..length).find(|&j| is_free(j)))
            else {
                break;
            };
            run.joints.push(joint);
            start = joint;
        }
        if backwards {
            run.joints[1..].iter_mut().for_each(|j| *j = length - *j);
            run.joints[1..].reverse();
        }
    }
    run.joints.push(length);
}

/// What stands at the end of a panel.
#[derive(Clone, Copy, PartialEq, Eq)]
#[repr(u64)]
enum End {
    /// Another panel of the same facade, or a wall that goes on above or below.
    Joint = 0,
    /// An outer corner.
    Outer = 1,
    /// An inner corner.
    Inner = 2,
}

/// The end of the facade at column `n` towards `side`.
fn end(columns: &Columns, facades: &Facades, place: Place, n: usize, side: Direction) -> End {
    let (level, facing) = (place.level, place.facing);
    let at = columns.at(place.cell(n));
    let mask = facades.mask(level, facing, at);
    let diagonal = at.wrapping_add_signed(columns.step(side) + columns.step(facing));
    if facades.mask(level, side, at) & mask != 0 {
        End::Outer
    } else if facades.mask(level, side.back(), diagonal) & mask != 0 {
        End::Inner
    } else {
        End::Joint
    }
}

fn panel(shop: &mut Shop, columns: &Columns, facades: &Facades, run: &Run, place: Place, [from, to]: [usize; 2]) {
    let facing = place.facing;
    let axis = usize::from(facing.left().step()[0] == 0);
    let [module, dz] = [shop.parts.module_m[axis], shop.parts.module_m[2]];
    let last = run.tokens.len() / 2;
    let left = if from == 0 { end(columns, facades, place, 0, facing.left().back()) } else { End::Joint };
    let right = if to == last + 1 { end(columns, facades, place, last, facing.left()) } else { End::Joint };
    let mut length_mm = (to - from) as f64 * module * 1000.0;
    length_mm += if left == End::Inner { shop.parts.wall_mm } else { 0.0 };
    length_mm -= if right == End::Outer { shop.parts.wall_mm } else { 0.0 };

    let (cell0, opening0) = (shop.parts.cells.len() as u32, shop.parts.openings.len() as u32);
    let (mut union, mut halves) = (0u16, 0);
    for n in from..to {
        let code = run.tokens[2 * n] as u16;
        let k = (place.level * STOREY_MODULES) as u16;
        shop.parts.cells.push(PartCell { cell: place.cell(n).map(|c| c as u16), k, code });
        union |= code;
        halves += code.count_ones();
    }
    let mut area_m2 = f64::from(halves) * 0.5 * dz * module;
    for o in &run.openings {
        if usize::from(o.from) >= from && usize::from(o.from) < to {
            area_m2 -= f64::from(o.width) * module * f64::from(o.height) * dz;
            shop.parts.openings.push(PanelOpening { from: o.from - from as u16, ..*o });
        }
    }
    let high = 16 - union.leading_zeros() - union.trailing_zeros();
    let (a, b) = (place.cell(from), place.cell(to - 1));
    let key = shop.panel_key(&run.tokens[2 * from..2 * to - 1], [left as u64, right as u64]);
    let (mirrored, key) = key;
    shop.parts.parts.push(Part {
        kind: PartKind::Wall,
        level: place.level as u16,
        facing: Some(facing),
        axis: axis as u8,
        first: [a[0].min(b[0]) as u16, a[1].min(b[1]) as u16],
        modules: [(to - from) as u16, high as u16],
        length_mm,
        width_mm: shop.parts.wall_mm,
        height_mm: f64::from(high) * 500.0 * dz,
        area_m2,
        cells: [cell0, shop.parts.cells.len() as u32],
        openings: [opening0, shop.parts.openings.len() as u32],
        key,
        mirrored,
    });
}
