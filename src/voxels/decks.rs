//! Decks: slabs with nothing above, and which of them people step out on.

use super::{Direction, FacadeOpening, House, Label, Plan, Plate, Reading, STOREY_MODULES};

/// The deck cells of a plate: slab with nothing above.
fn deck(house: &House, plate: &Plate) -> Plan {
    let mut deck = Plan::new(plate.cells.size());
    for [x, y] in plate.slab.iter() {
        let above = house.voxels.at([x as isize, y as isize, plate.k as isize + 1]);
        deck.set([x, y], !above.is_filled());
    }
    deck
}

fn steps_onto(opening: &FacadeOpening, deck: &Plan) -> bool {
    opening.label == Label::Opening && deck.has(opening.column(0, 1))
}

/// The deck cells of a plate that people step out on: those a door leads to, with everything they connect to.
pub fn walked_deck(house: &House, reading: &Reading, plate: &Plate) -> Plan {
    let deck = deck(house, plate);
    let mut reached = Plan::new(deck.size());
    let storey = plate.k / STOREY_MODULES;
    let mut open: Vec<[isize; 2]> = reading
        .openings
        .iter()
        .filter(|o| o.storey == storey && steps_onto(o, &deck))
        .map(|o| o.column(0, 1))
        .collect();
    while let Some(cell) = open.pop() {
        if !deck.has(cell) || reached.has(cell) {
            continue;
        }
        reached.set([cell[0] as usize, cell[1] as usize], true);
        open.extend(Direction::ALL.map(|d| [cell[0] + d.step()[0], cell[1] + d.step()[1]]));
    }
    reached
}
