//! Lengths and areas that the take-off reads from plates and openings.

use crate::quantities::{Takeoff, TakeoffError};
use crate::voxels::{
    Direction, FacadeOpening, House, Label, Plan, Plate, Reading, Stair, net_floor_area_m2, walked_deck,
};

/// Length in m of the border of a set of cells against cells for which `beyond` holds.
pub fn border_m(cells: &Plan, size_m: [f64; 3], beyond: impl Fn([isize; 2]) -> bool) -> f64 {
    let mut length = 0.0;
    for [x, y] in cells.iter() {
        for direction in Direction::ALL {
            let [dx, dy] = direction.step();
            let neighbour = [x as isize + dx, y as isize + dy];
            if !cells.has(neighbour) && beyond(neighbour) {
                length += if dx != 0 { size_m[1] } else { size_m[0] };
            }
        }
    }
    length
}

/// Railing around the void of a stair: its border but for the last step's width, m.
fn void_railing_m(stair: &Stair, plate: &Plate, size_m: [f64; 3]) -> f64 {
    let mut void = Plan::new(plate.cells.size());
    for [x, y] in stair.void_cells() {
        if x >= 0 && y >= 0 && (x as usize) < void.size()[0] && (y as usize) < void.size()[1] {
            void.set([x as usize, y as usize], true);
        }
    }
    let lane = size_m[0].min(size_m[1]);
    (border_m(&void, size_m, |n| plate.slab.has(n)) - lane).max(0.0)
}

/// Decks that are walked on, m2, and the railing of decks and stair voids, m.
pub fn decks_and_railing(house: &House, reading: &Reading) -> (f64, f64) {
    let size = house.voxels.module.size_m;
    let (mut area, mut railing) = (0.0, 0.0);
    for plate in reading.plates.iter().skip(1) {
        let reached = walked_deck(house, reading, plate);
        area += reached.count() as f64 * size[0] * size[1];
        railing += border_m(&reached, size, |n| !plate.cells.has(n));
        let below = house.stairs.iter().filter(|s| (s.storey + 1) * crate::voxels::STOREY_MODULES == plate.k);
        railing += below.map(|stair| void_railing_m(stair, plate, size)).sum::<f64>();
    }
    (area, railing)
}

/// Where an opening that stands on a slab begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sill {
    /// At the lower side of its voxel, half a module above the slab's top, as tiles of surfaces draw it.
    Voxel,
    /// At the slab's top, or on the upstand before a deck, as solids are built.
    Slab,
}

/// Height of an opening in m.
fn opening_height_m(house: &House, opening: &FacadeOpening, sill: Sill) -> f64 {
    let label = |out: isize, k: usize| {
        let [x, y] = opening.column(0, out);
        house.voxels.at([x, y, k as isize])
    };
    let on_slab = opening.k > 0 && label(0, opening.k - 1).is_slab();
    let before_deck = opening.k > 0 && label(1, opening.k - 1).is_filled();
    let down = if sill == Sill::Slab && on_slab && !before_deck { 0.5 } else { 0.0 };
    (opening.height as f64 + down) * house.voxels.module.size_m[2]
}

/// Adds floors, openings, stairs, railing and perimeter to a take-off.
///
/// # Errors
/// More plates or window sizes than a take-off holds.
pub fn add_building(
    takeoff: &mut Takeoff,
    house: &House,
    reading: &Reading,
    railing_m: f64,
    sill: Sill,
) -> Result<(), TakeoffError> {
    let size = house.voxels.module.size_m;
    for plate in reading.plates.iter().skip(1) {
        let inner = inner_area_m2(house, plate, size);
        takeoff.add_floor(inner)?;
    }
    let mut doors = 0;
    for o in &reading.openings {
        let (width, height) = (o.width as f64 * size[o.along()], opening_height_m(house, o, sill));
        match o.label {
            Label::Opening => doors += 1,
            _ => takeoff.add_window(width, height)?,
        }
    }
    takeoff.add_doors(doors);
    takeoff.add_stairs(house.stairs.len() as u32);
    takeoff.add_railing(railing_m)?;
    if let Some(ground) = reading.plates.first() {
        takeoff.add_perimeter(border_m(&ground.cells, size, |n| !ground.cells.has(n)))?;
    }
    Ok(())
}

/// Net area of a plate inside the house, m2: slab cells with rooms below and rooms or roof space above, inside the lining, stair
/// voids left out.
fn inner_area_m2(house: &House, plate: &Plate, size: [f64; 3]) -> f64 {
    let mut between = Plan::new(plate.cells.size());
    let mut voids = 0;
    for [x, y] in plate.cells.iter() {
        let filled = |k: usize| house.voxels.at([x as isize, y as isize, k as isize]).is_filled();
        if filled(plate.k + 1) && filled(plate.k - 1) {
            between.set([x, y], true);
            voids += usize::from(plate.void.has([x as isize, y as isize]));
        }
    }
    let none = Plan::new(plate.cells.size());
    let net = net_floor_area_m2(&between, &none, &[], 0, &house.voxels.module);
    (net - voids as f64 * size[0] * size[1]).max(0.0)
}
