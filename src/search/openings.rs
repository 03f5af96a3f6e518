//! Seats of windows and doors: which cells of a facade may hold them, and how one finds a new seat.

use super::cells::Cells;
use super::massing::{Infill, Opening, along};
use crate::voxels::{Direction, FRAME_M, MULLION_M, Stair};

/// The facades of one storey and what is taken of them.
#[derive(Clone, Debug)]
pub struct Facades {
    /// Per facing: cells that are exposed, with exposed neighbours in the same plane on both sides.
    seats: [Cells; 4],
    /// Per facing: seats whose outside is ground or deck and whose inside is walkable.
    doors: [Cells; 4],
    /// Per facing: cells of seated openings.
    taken: [Cells; 4],
}

impl Facades {
    /// The facades of `plan`. `ground` says where a person can stand outside (a deck; everywhere for the ground storey),
    /// `stair` is the stair that starts here, `voids` are holes in this storey's floor.
    pub fn new(plan: &Cells, deck: Option<&Cells>, stair: Option<&Stair>, voids: &[[isize; 2]]) -> Self {
        let mut walk = plan.inner();
        let blocked = stair.into_iter().flat_map(|s| s.flight_cells().into_iter().chain(s.middle_landing()));
        for [x, y] in blocked.chain(voids.iter().copied()) {
            if x >= 0 && y >= 0 {
                walk.set([x as usize, y as usize], false);
            }
        }
        let seats = Direction::ALL.map(|d| seats(plan, d));
        let doors = Direction::ALL.map(|d| {
            let [dx, dy] = d.step();
            let inside = seats[d as usize].and(&walk.shifted([dx, dy]));
            match deck {
                None => inside,
                Some(deck) => inside.and(&deck.shifted([-dx, -dy])),
            }
        });
        Facades { seats, doors, taken: std::array::from_fn(|_| Cells::new(plan.size())) }
    }

    /// Whether an opening may sit where it is: on free seats, with a free module beside it.
    pub fn is_free(&self, opening: &Opening) -> bool {
        let d = opening.facing as usize;
        let allowed = match opening.infill {
            Infill::Door => &self.doors[d],
            Infill::Window => &self.seats[d],
        };
        let ([ax, ay], [x, y]) = (opening.along(), opening.cell);
        let n = opening.width as isize;
        (0..n).all(|i| allowed.has([x + i * ax, y + i * ay]))
            && (-1..=n).all(|i| !self.taken[d].has([x + i * ax, y + i * ay]))
    }

    /// Seats an opening where it is.
    pub fn take(&mut self, opening: &Opening) {
        for [x, y] in opening.cells() {
            self.taken[opening.facing as usize].set([x as usize, y as usize], true);
        }
    }

    /// Gives an opening's seat back.
    pub fn release(&mut self, opening: &Opening) {
        for [x, y] in opening.cells() {
            self.taken[opening.facing as usize].set([x as usize, y as usize], false);
        }
    }

    /// The free seat nearest to an opening's old one: the same width first, then narrower; along the facade before through it.
    pub fn reseat(&self, old: &Opening) -> Option<Opening> {
        let ([ax, ay], [nx, ny], [x, y]) = (old.along(), old.facing.step(), old.cell);
        for width in (1..=old.width).rev() {
            for through in NEAR {
                for slide in NEAR {
                    let cell = [x + through * nx + slide * ax, y + through * ny + slide * ay];
                    let seat = Opening { cell, width, ..*old };
                    if self.is_free(&seat) {
                        return Some(seat);
                    }
                }
            }
        }
        None
    }

    /// Takes the seats of cells away from openings that are still to come.
    pub fn close(&mut self, walls: &Cells) {
        self.seats.iter_mut().chain(&mut self.doors).for_each(|seats| *seats = seats.minus(walls));
    }

    /// Every free place for an opening like `like` on one facade, in the order of its cells.
    pub fn places(&self, like: Opening) -> impl Iterator<Item = Opening> + '_ {
        self.seats[like.facing as usize]
            .iter()
            .map(move |[x, y]| Opening { cell: [x as isize, y as isize], ..like })
            .filter(|o| self.is_free(o))
    }
}

/// Offsets tried when an opening looks for a new seat, nearest first.
const NEAR: [isize; 7] = [0, 1, -1, 2, -2, 3, -3];

/// Cells of the facades that face `facing`, corners left out: exposed, and exposed on both sides along the facade.
fn seats(plan: &Cells, facing: Direction) -> Cells {
    let exposed = exposed(plan, facing);
    let [ax, ay] = along(facing);
    exposed.and(&exposed.shifted([ax, ay])).and(&exposed.shifted([-ax, -ay]))
}

/// Cells whose neighbour towards `facing` is not in the plan.
pub fn exposed(plan: &Cells, facing: Direction) -> Cells {
    let [dx, dy] = facing.step();
    plan.minus(&plan.shifted([-dx, -dy]))
}

/// A straight piece of facade: its first cell and its length in cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bay {
    /// Outward normal.
    pub facing: Direction,
    /// Cell with the smallest coordinate along the facade.
    pub cell: [isize; 2],
    /// Cells along the facade.
    pub length: usize,
}

/// All straight pieces of the facades of a plan, by facing, then first cell.
pub fn bays(plan: &Cells) -> Vec<Bay> {
    let mut out = Vec::new();
    for facing in Direction::ALL {
        let exposed = exposed(plan, facing);
        let [ax, ay] = along(facing);
        for [x, y] in exposed.minus(&exposed.shifted([ax, ay])).iter() {
            let cell = [x as isize, y as isize];
            let length = (0..).take_while(|&i| exposed.has([cell[0] + i * ax, cell[1] + i * ay])).count();
            out.push(Bay { facing, cell, length });
        }
    }
    out
}

/// Glass of a window in m2, frame and mullions left out.
pub fn glass_m2(opening: &Opening) -> f64 {
    match opening.infill {
        Infill::Door => 0.0,
        Infill::Window => {
            let width = opening.width as f64 * 0.9 - 2.0 * FRAME_M - MULLION_M * (opening.width as f64 - 1.0);
            width * (opening.height() as f64 * 0.54 - 2.0 * FRAME_M)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_hold_no_opening_and_neighbours_keep_a_module() {
        let plan = Cells::rect([8, 8], [1, 1], [6, 5]);
        let mut facades = Facades::new(&plan, None, None, &[]);
        let like = Opening::window(Direction::South, [0, 0], 1, 2);
        let places: Vec<_> = facades.places(like).map(|o| o.cell).collect();
        assert_eq!(places, [[2, 1], [3, 1], [4, 1], [5, 1]]);
        facades.take(&Opening::window(Direction::South, [3, 1], 1, 2));
        let places: Vec<_> = facades.places(like).map(|o| o.cell).collect();
        assert_eq!(places, [[5, 1]]);
    }

    #[test]
    fn an_opening_follows_its_facade() {
        let plan = Cells::rect([12, 8], [1, 1], [8, 5]);
        let facades = Facades::new(&plan, None, None, &[]);
        let old = Opening::window(Direction::East, [6, 2], 2, 2);
        assert_eq!(facades.reseat(&old).map(|o| (o.cell, o.width)), Some(([8, 2], 2)));
        let lost = Opening::window(Direction::East, [2, 2], 2, 2);
        assert_eq!(facades.reseat(&lost), None);
    }

    #[test]
    fn upper_doors_open_onto_decks_only() {
        let plan = Cells::rect([12, 8], [0, 0], [6, 6]);
        let deck = Cells::rect([12, 8], [6, 0], [4, 6]);
        let facades = Facades::new(&plan, Some(&deck), None, &[]);
        let count = |d| facades.places(Opening::door(d, [0, 0])).count();
        assert_eq!(Direction::ALL.map(count), [4, 0, 0, 0]);
    }

    #[test]
    fn an_l_has_six_bays_whose_lengths_are_its_perimeter() {
        let plan = Cells::rect([12, 12], [0, 0], [8, 4]).or(&Cells::rect([12, 12], [0, 0], [4, 9]));
        let bays = bays(&plan);
        assert_eq!(bays.len(), 6);
        assert_eq!(bays.iter().map(|b| b.length).sum::<usize>(), plan.perimeter());
    }
}
