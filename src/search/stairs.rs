//! Where stairs fit: inside the lining of both storeys, without cutting a room in two.

use super::cells::Cells;
use crate::voxels::{Direction, Stair, StairKind};

/// Both kinds of stair.
pub const KINDS: [StairKind; 2] = [StairKind::Straight, StairKind::UTurn];

/// What a stair may use: cells of the lower and of the upper storey inside the lining, and the stair that ends on the
/// lower storey.
#[derive(Clone, Debug)]
pub struct StairWell {
    lower: Cells,
    upper: Cells,
    below: Option<Stair>,
    /// Cells of the plate between them that no void may take; `None`: all may be.
    slab: Option<Cells>,
}

impl StairWell {
    /// The well between two storeys; `below` is the stair from the storey under the lower one.
    pub fn new(lower: &Cells, upper: &Cells, below: Option<Stair>) -> Self {
        let mut free = lower.inner();
        for cell in below.iter().flat_map(Stair::void_cells) {
            unset(&mut free, cell);
        }
        StairWell { lower: free, upper: upper.inner(), below, slab: None }
    }

    /// The same well under a plate of which some cells stay slab.
    pub fn below_slab(mut self, slab: Option<&Cells>) -> Self {
        self.slab = slab.cloned();
        self
    }

    /// Whether a stair keeps inside the lining and leaves both storeys in one walkable part each.
    pub fn fits(&self, stair: &Stair) -> bool {
        let inside = lower_cells(stair).all(|c| self.lower.has(c)) && upper_cells(stair).all(|c| self.upper.has(c));
        let breaks = self.slab.as_ref().is_some_and(|slab| stair.void_cells().into_iter().any(|c| slab.has(c)));
        inside && !breaks && self.keeps_passage(stair)
    }

    /// The lower storey without flights, and the upper without the void, stay connected and hold foot and head.
    fn keeps_passage(&self, stair: &Stair) -> bool {
        let mut lower = self.lower.clone();
        stair.flight_cells().into_iter().chain(stair.middle_landing()).for_each(|c| unset(&mut lower, c));
        let mut upper = self.upper.clone();
        stair.void_cells().into_iter().for_each(|c| unset(&mut upper, c));
        let arrives = self.below.is_none_or(|b| lower.has(b.head()));
        arrives && lower.has(stair.foot()) && upper.has(stair.head()) && lower.is_connected() && upper.is_connected()
    }

    /// Every stair of a kind and direction that keeps inside the lining (passages are not yet judged).
    fn starts(&self, kind: StairKind, run: Direction) -> Cells {
        let at = Stair { storey: 0, start: [32, 32], run, kind };
        let back = |[x, y]: [isize; 2]| [32 - x, 32 - y];
        let mut starts = lower_cells(&at).fold(self.lower.clone(), |s, c| s.and(&self.lower.shifted(back(c))));
        for cell in upper_cells(&at) {
            starts = starts.and(&self.upper.shifted(back(cell)));
        }
        starts
    }

    /// Every stair from storey `storey` that keeps inside the lining, in the order kind, run, cell.
    pub fn candidates(&self, storey: usize) -> Vec<Stair> {
        let mut out = Vec::new();
        for kind in KINDS {
            for run in Direction::ALL {
                out.extend(self.starts(kind, run).iter().map(|start| Stair { storey, start, run, kind }));
            }
        }
        out
    }

    /// The stair nearest to `old` in place, then of its kind and direction; the same one where it still fits.
    pub fn nearest(&self, old: &Stair) -> Option<Stair> {
        if self.fits(old) {
            return Some(*old);
        }
        let mut candidates = self.candidates(old.storey);
        candidates.sort_by_key(|c| {
            let apart = c.start[0].abs_diff(old.start[0]) + c.start[1].abs_diff(old.start[1]);
            (apart + 2 * usize::from(c.kind != old.kind) + usize::from(c.run != old.run), *c)
        });
        candidates.into_iter().find(|c| self.fits(c))
    }
}

/// Cells a stair needs inside the lining of its lower storey.
fn lower_cells(stair: &Stair) -> impl Iterator<Item = [isize; 2]> {
    stair.flight_cells().into_iter().chain(stair.middle_landing()).chain([stair.foot()])
}

/// Cells a stair needs inside the lining of its upper storey.
fn upper_cells(stair: &Stair) -> impl Iterator<Item = [isize; 2]> {
    stair.void_cells().into_iter().chain([stair.head()])
}

fn unset(cells: &mut Cells, [x, y]: [isize; 2]) {
    if x >= 0 && y >= 0 {
        cells.set([x as usize, y as usize], false);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On every rectangle up to 11 x 8 the bitset search finds exactly the stairs that a cell-by-cell test admits.
    #[test]
    fn candidates_equal_the_definition() {
        for (w, h) in [(6, 4), (7, 4), (8, 7), (10, 4), (11, 8)] {
            let plan = Cells::rect([12, 9], [1, 1], [w, h]);
            let well = StairWell::new(&plan, &plan, None);
            let found = well.candidates(0);
            let mut expected = Vec::new();
            for kind in KINDS {
                for run in Direction::ALL {
                    for start in Cells::full([12, 9]).iter() {
                        let stair = Stair { storey: 0, start, run, kind };
                        let inner = plan.inner();
                        if lower_cells(&stair).chain(upper_cells(&stair)).all(|c| inner.has(c)) {
                            expected.push(stair);
                        }
                    }
                }
            }
            assert_eq!(found, expected);
            assert_eq!(found.is_empty(), (w, h) == (6, 4));
        }
    }

    #[test]
    fn the_nearest_stair_is_the_old_one_where_it_fits() {
        let plan = Cells::rect([12, 9], [0, 0], [11, 8]);
        let well = StairWell::new(&plan, &plan, None);
        let stair = well.candidates(0).into_iter().find(|s| well.fits(s)).expect("a wide house has a stair");
        assert_eq!(well.nearest(&stair), Some(stair));
        let moved = Stair { start: [0, 0], ..stair };
        assert!(!well.fits(&moved) && well.nearest(&moved).is_some());
    }

    #[test]
    fn a_second_stair_keeps_off_the_void_of_the_first() {
        let plan = Cells::rect([12, 9], [0, 0], [11, 8]);
        let first = StairWell::new(&plan, &plan, None).nearest(&Stair {
            storey: 0,
            start: [3, 2],
            run: Direction::East,
            kind: StairKind::UTurn,
        });
        let first = first.expect("fits");
        let well = StairWell::new(&plan, &plan, Some(first));
        let voids = first.void_cells();
        let free: Vec<Stair> = well.candidates(1).into_iter().filter(|s| well.fits(s)).collect();
        assert!(!free.is_empty());
        assert!(free.iter().all(|s| s.flight_cells().iter().all(|c| !voids.contains(c))));
    }
}
