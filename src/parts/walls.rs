//! Wall panels: facade runs of a storey, split at voxel borders.

use super::columns::Columns;
use super::cut::Shop;
use super::facades::Facades;
use super::types::{PanelOpening, Part, PartCell, PartKind, Parts};
use crate::voxels::{Direction, FacadeOpening, Label, STOREY_MODULES, VoxelArray};

/// What walls are read from.
pub(super) struct Site<'h> {
    pub voxels: &'h VoxelArray,
    pub columns: &'h Columns,
    pub facades: &'h Facades,
    pub openings: &'h [FacadeOpening],
}

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

/// Cuts all walls of a house. The longer facades run through at corners; when those along x and along y are equally long, those whose
/// running through makes fewer distinct panels.
pub(super) fn cut_walls(shop: &mut Shop, site: &Site) {
    let [along_x, along_y] = site.facades.lengths();
    if along_x != along_y {
        return cut_all(shop, site, usize::from(along_y > along_x));
    }
    cut_all(shop, site, 0);
    let of_x = std::mem::take(&mut shop.parts);
    shop.parts = Parts { parts: Vec::new(), cells: Vec::new(), openings: Vec::new(), keys: Vec::new(), ..of_x };
    shop.parts.parts.reserve(of_x.parts.capacity());
    cut_all(shop, site, 1);
    if of_x.distinct() <= shop.parts.distinct() {
        shop.parts = of_x;
    }
}

fn cut_all(shop: &mut Shop, site: &Site, through: usize) {
    shop.parts.through_axis = through as u8;
    let mut run = Run::default();
    for level in 0..site.facades.levels {
        for facing in Direction::ALL {
            let right = facing.left();
            let axis = usize::from(right.step()[0] == 0);
            let (length, lines) = (site.columns.size[axis], site.columns.size[1 - axis]);
            let forwards = right.step()[axis] > 0;
            for line in (0..lines).filter(|&line| site.facades.stands(level, facing, line)) {
                let mut start = [line as isize; 2];
                start[axis] = if forwards { 0 } else { length as isize - 1 };
                let row = Place { level, facing, start };
                cut_line(shop, site, row, length, &mut run);
            }
        }
    }
}

fn cut_line(shop: &mut Shop, site: &Site, row: Place, length: usize, run: &mut Run) {
    let first = site.columns.at(row.cell(0));
    let step = site.columns.step(row.facing.left());
    let mask = |n: usize| site.facades.mask(row.level, row.facing, first.wrapping_add_signed(step * n as isize));
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
        note_openings(run, site, place, shop.settings.from_slab);
        split(run, shop.most_modules(usize::from(row.facing.left().step()[0] == 0)));
        for piece in 0..run.joints.len() - 1 {
            let span = [run.joints[piece], run.joints[piece + 1]];
            panel(shop, site, run, place, span);
        }
    }
}

/// Half modules from `from` up to `to` above the slab, as bits.
fn rows(from: usize, to: usize) -> u64 {
    let [from, to] = [from, to].map(|h| h.min(12));
    (1u64 << to) - (1u64 << from)
}

fn note_openings(run: &mut Run, site: &Site, place: Place, from_slab: bool) {
    run.openings.clear();
    let columns = run.tokens.len() / 2 + 1;
    let left = place.cell(0);
    let along = usize::from(place.facing.left().step()[0] == 0);
    let forwards = place.facing.left().step()[along] > 0;
    for (index, o) in site.openings.iter().enumerate() {
        let level = o.k.saturating_sub(1) / STOREY_MODULES;
        if o.facing != place.facing || level != place.level || o.cell[1 - along] != left[1 - along] {
            continue;
        }
        let (low, high) = (o.cell[along], o.cell[along] + o.width - 1);
        let from = if forwards { low.checked_sub(left[along]) } else { left[along].checked_sub(high) };
        let Some(from) = from.filter(|f| f + o.width <= columns) else { continue };
        let sill = (2 * (o.k - STOREY_MODULES * level)).saturating_sub(1);
        let shift = if o.label == Label::Opening { 32 } else { 16 };
        let mut to_slab = 0;
        for n in 0..o.width {
            let down = from_slab && o.reaches_slab(site.voxels, if forwards { n } else { o.width - 1 - n });
            to_slab += u16::from(down);
            let rows = rows(if down { sill - 1 } else { sill }, sill + 2 * o.height);
            run.tokens[2 * (from + n)] |= rows << shift;
            if n > 0 {
                run.tokens[2 * (from + n) - 1] |= rows;
            }
        }
        run.openings.push(PanelOpening {
            label: o.label,
            from: from as u16,
            width: o.width as u16,
            sill: (sill - usize::from(to_slab > 0)) as u16,
            height: o.height as u16,
            to_slab,
            index: index as u16,
        });
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
    /// An outer corner, which a panel that runs through fills; the other butts against it, a wall thickness shorter.
    OuterThrough = 1,
    /// See [`End::OuterThrough`].
    OuterButt = 2,
    /// An inner corner, into which the panel that runs through reaches by a wall thickness.
    InnerThrough = 3,
    /// An inner corner, in which the panel ends at its last module line.
    InnerButt = 4,
}

impl End {
    /// What the end adds to the length in modules, in wall thicknesses.
    fn walls(self) -> f64 {
        match self {
            End::Joint | End::OuterThrough | End::InnerButt => 0.0,
            End::OuterButt => -1.0,
            End::InnerThrough => 1.0,
        }
    }
}

/// The end of the facade at column `n` towards `side`.
fn end(site: &Site, through: bool, place: Place, n: usize, side: Direction) -> End {
    let (level, facing) = (place.level, place.facing);
    let at = site.columns.at(place.cell(n));
    let mask = site.facades.mask(level, facing, at);
    let diagonal = at.wrapping_add_signed(site.columns.step(side) + site.columns.step(facing));
    let outer = site.facades.mask(level, side, at) & mask != 0;
    let inner = site.facades.mask(level, side.back(), diagonal) & mask != 0;
    match (outer, inner, through) {
        (true, _, true) => End::OuterThrough,
        (true, _, false) => End::OuterButt,
        (false, true, true) => End::InnerThrough,
        (false, true, false) => End::InnerButt,
        (false, false, _) => End::Joint,
    }
}

fn panel(shop: &mut Shop, site: &Site, run: &Run, place: Place, [from, to]: [usize; 2]) {
    let facing = place.facing;
    let axis = usize::from(facing.left().step()[0] == 0);
    let through = axis == usize::from(shop.parts.through_axis);
    let [module, dz] = [shop.parts.module_m[axis], shop.parts.module_m[2]];
    let last = run.tokens.len() / 2;
    let left = if from == 0 { end(site, through, place, 0, facing.left().back()) } else { End::Joint };
    let right = if to == last + 1 { end(site, through, place, last, facing.left()) } else { End::Joint };
    let ends = [left, right].map(|e| e.walls() * shop.parts.wall_mm);
    let length_mm = (to - from) as f64 * module * 1000.0 + ends[0] + ends[1];

    let (cell0, opening0) = (shop.parts.cells.len() as u32, shop.parts.openings.len() as u32);
    let (mut union, mut area_m2) = (0u16, 0.0);
    for n in from..to {
        let code = run.tokens[2 * n] as u16;
        let k = (place.level * STOREY_MODULES) as u16;
        shop.parts.cells.push(PartCell { cell: place.cell(n).map(|c| c as u16), k, code });
        union |= code;
        // The corner belongs to the first and the last column.
        let mut wide = module;
        wide += if n == from { 1e-3 * ends[0] } else { 0.0 };
        wide += if n + 1 == to { 1e-3 * ends[1] } else { 0.0 };
        area_m2 += f64::from(code.count_ones()) * 0.5 * dz * wide;
    }
    for o in &run.openings {
        if usize::from(o.from) >= from && usize::from(o.from) < to {
            area_m2 -= f64::from(o.width) * module * o.height_modules() * dz;
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
