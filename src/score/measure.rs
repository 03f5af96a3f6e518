//! Lengths and areas that the take-off reads from plates and openings.

use crate::quantities::{FoundationEdge, Takeoff, TakeoffError};
use crate::tiles::{Shells, depth_um};
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
pub(super) fn void_railing_m(stair: &Stair, plate: &Plate, size_m: [f64; 3]) -> f64 {
    let mut void = Plan::new(plate.cells.size());
    for [x, y] in stair.void_cells() {
        if x >= 0 && y >= 0 && (x as usize) < void.size()[0] && (y as usize) < void.size()[1] {
            void.set([x as usize, y as usize], true);
        }
    }
    let lane = size_m[0].min(size_m[1]);
    (border_m(&void, size_m, |n| plate.slab.has(n)) - lane).max(0.0)
}

/// Decks that are walked on, with railing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Decks {
    /// Area of decks that are walked on, m2.
    pub walked_m2: f64,
    /// Railing along their free edges, m.
    pub railing_m: f64,
    /// Railing around the voids of stairs, m.
    pub void_railing_m: f64,
}

/// The decks that are walked on, and the railing of decks and stair voids.
pub fn decks_and_railing(house: &House, reading: &Reading) -> Decks {
    let size = house.voxels.module.size_m;
    let mut decks = Decks::default();
    for plate in reading.plates.iter().skip(1) {
        let reached = walked_deck(house, reading, plate);
        decks.walked_m2 += reached.count() as f64 * size[0] * size[1];
        decks.railing_m += border_m(&reached, size, |n| !plate.cells.has(n));
        let below = house.stairs.iter().filter(|s| (s.storey + 1) * crate::voxels::STOREY_MODULES == plate.k);
        decks.void_railing_m += below.map(|stair| void_railing_m(stair, plate, size)).sum::<f64>();
    }
    decks
}

/// Outer corners of a plan less its inner ones: 4 for a plan without courts, 4 less for each court.
pub fn corners(cells: &Plan) -> i32 {
    let [nx, ny] = cells.size().map(|n| n as isize);
    let turn = |x: isize, y: isize| match [[x, y], [x - 1, y], [x, y - 1], [x - 1, y - 1]].map(|c| cells.has(c)) {
        [true, false, false, false] | [false, true, false, false] => 1,
        [false, false, true, false] | [false, false, false, true] => 1,
        [true, false, false, true] | [false, true, true, false] => 2,
        [false, true, true, true] | [true, false, true, true] => -1,
        [true, true, false, true] | [true, true, true, false] => -1,
        [true, true, _, _] | [false, false, _, _] | [true, false, true, false] | [false, true, false, true] => 0,
    };
    (0..=ny).flat_map(|y| (0..=nx).map(move |x| [x, y])).map(|[x, y]| turn(x, y)).sum()
}

pub(super) fn ground_is_foundation(house: &House, plate: &Plate) -> bool {
    plate.cells.iter().all(|[x, y]| house.voxels.get([x, y, plate.k]) == Label::Foundation)
}

/// The foundation of a plate as solids are built: length of the beam's axis in m, and what its edge adds to the plinth and takes from
/// the slab. The beam stands behind the plinth's strata; the slab ends at the beam.
pub fn foundation(ground: &Plan, size: [f64; 3], shells: &Shells) -> (f64, FoundationEdge) {
    let perimeter_m = border_m(ground, size, |n| !ground.has(n));
    let metres = |um: i32| f64::from(um) * 1e-6;
    let (plinth, slab) = (metres(depth_um(&shells.plinth)), metres(depth_um(&shells.ground)));
    let [beam, depth] = shells.beam_um.map(metres);
    let turns = f64::from(corners(ground));
    let edge = FoundationEdge {
        plinth_below_m2: perimeter_m * (depth - slab).max(0.0),
        without_slab_m2: perimeter_m * (plinth + beam) - turns * (plinth + beam).powi(2),
    };
    (perimeter_m - turns * (2.0 * plinth + beam), edge)
}

/// Where an opening that stands on a slab begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sill {
    /// At the lower side of its voxel, half a module above the slab's top, as tiles of surfaces draw it.
    Voxel,
    /// At the slab's top, or on the upstand before a deck, as solids are built.
    Slab,
}

/// Where openings begin: on the slab where solids are drawn.
pub(super) fn opening_sill(solids: bool) -> Sill {
    if solids { Sill::Slab } else { Sill::Voxel }
}

/// Height of an opening in m; the mean over its columns where its lower edge steps, as before the end of a deck.
pub(super) fn opening_height_m(house: &House, opening: &FacadeOpening, sill: Sill) -> f64 {
    let down = match sill {
        Sill::Slab => {
            let columns = (0..opening.width).filter(|&n| opening.reaches_slab(&house.voxels, n)).count();
            columns as f64 / opening.width.max(1) as f64
        }
        Sill::Voxel => 0.0,
    };
    (opening.height as f64 + 0.5 * down) * house.voxels.module.size_m[2]
}

/// Adds floors, openings, stairs, railing and foundation to a take-off. With `shells` openings and foundation are measured as solids are
/// built, else as surfaces are drawn.
///
/// # Errors
/// More plates or window sizes than a take-off holds.
pub fn add_building(
    takeoff: &mut Takeoff,
    house: &House,
    reading: &Reading,
    railing_m: f64,
    shells: Option<&Shells>,
) -> Result<(), TakeoffError> {
    let size = house.voxels.module.size_m;
    let sill = opening_sill(shells.is_some());
    for plate in reading.plates.iter().skip(1) {
        let inner = match shells {
            Some(_) => built_floor_m2(house, plate),
            None => inner_area_m2(house, plate, size),
        };
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
        match shells {
            Some(shells) if ground_is_foundation(house, ground) => {
                let (beam_m, edge) = foundation(&ground.cells, size, shells);
                takeoff.add_perimeter(beam_m)?;
                takeoff.set_foundation_edge(edge)?;
            }
            Some(_) | None => takeoff.add_perimeter(border_m(&ground.cells, size, |n| !ground.cells.has(n)))?,
        }
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

/// Area of a plate's cassettes as they are built, m2: below rooms and roof spaces, over rooms and over the outside alike, inside the lining
/// of the plate's outer walls and running through below inner ones, stair voids left out. The rest of the plate is roof or deck.
fn built_floor_m2(house: &House, plate: &Plate) -> f64 {
    let mut open = plate.void.clone();
    for [x, y] in plate.cells.iter() {
        if !house.voxels.at([x as isize, y as isize, plate.k as isize + 1]).is_filled() {
            open.set([x, y], true);
        }
    }
    net_floor_area_m2(&plate.cells, &open, &[], 0, &house.voxels.module)
}
