//! What the frame carries besides itself: the mass of the take-off, above the foundation, spread over the frame's own areas.
//!
//! Areas of a take-off are those of the drawn solids, areas of a frame lie between its axes: they differ by a few per cent. Each item's
//! mass is spread evenly over the areas of its kind, so that what is taken off is what is carried, to the last kilogram. What has no
//! area of its own lies where it is built in: overhangs and gutters on the roof, parapets and copings on level roofs, railings on decks
//! and floors, half of a stair on the trimmer at its head and half at its foot. The foundation, decks on it, and the feet of stairs on it rest
//! on the ground.

use crate::frame::{Area, HouseFrame};
use crate::price::RateTable;
use crate::quantities::{Group, Item, Takeoff};
use crate::structure::FREE_FALL_M_S2;
use crate::voxels::{House, Label};

/// Kinds of areas that carry alike; the first with an area takes the mass.
const FLOORS: [usize; 2] = [0, 1];
const DECK: [usize; 1] = [2];
const FLAT: [usize; 1] = [3];
const SOFFIT: [usize; 1] = [4];
const STAIR: [usize; 1] = [5];
const WALL: [usize; 1] = [6];
const BAND: [usize; 1] = [7];
const WINDOW: [usize; 1] = [8];
const DOOR: [usize; 1] = [9];
const SLOPES: [usize; 2] = [10, 11];

/// Where the mass of an item lies: kinds of areas, in the order in which they are asked.
fn places(item: Item) -> &'static [&'static [usize]] {
    match item {
        Item::Wall | Item::WallBothSides => &[&WALL],
        Item::Band => &[&BAND, &WALL],
        Item::Window => &[&WINDOW, &WALL],
        Item::Door => &[&DOOR, &WALL],
        Item::PitchedRoof | Item::Overhang | Item::Gutter => &[&SLOPES, &FLAT, &DECK, &WALL],
        Item::FlatRoof => &[&FLAT, &DECK, &SLOPES, &WALL],
        Item::Parapet | Item::Coping => &[&FLAT, &DECK, &SLOPES, &WALL],
        Item::Deck => &[&DECK, &FLAT, &SLOPES, &WALL],
        Item::Soffit => &[&SOFFIT, &FLOORS, &WALL],
        Item::InnerFloor => &[&FLOORS, &DECK, &FLAT, &WALL],
        Item::Stair => &[&STAIR, &FLOORS, &WALL],
        Item::Railing => &[&DECK, &FLOORS, &FLAT, &WALL],
        _ => &[],
    }
}

/// Mass of the layers that a house's frame carries, kg by item: the take-off less its frame, the foundation, and what rests on that.
pub fn carried_kg(house: &House, takeoff: &Takeoff, rates: &RateTable) -> [f64; Item::COUNT] {
    let measured = takeoff.measured();
    let mut kg = [0.0; Item::COUNT];
    for item in Item::ALL.into_iter().filter(|item| !item.is_frame() && item.group() != Group::Foundation) {
        kg[item as usize] = measured[item as usize] * rates.rows[item as usize].mass_kg;
    }
    let flat = Item::FlatRoof as usize;
    let on_ground = deck_on_foundation_m2(house).min(measured[flat]);
    kg[flat] -= on_ground * rates.rows[flat].mass_kg;
    let feet = house.stairs.iter().filter(|stair| stair.storey == 0).count() as f64;
    let stairs = house.stairs.len().max(1) as f64;
    kg[Item::Stair as usize] *= 1.0 - 0.5 * feet / stairs;
    kg
}

/// Weight that a m2 of each kind of area carries, N/m2.
pub(super) fn layer_weights(
    house: &House,
    takeoff: &Takeoff,
    rates: &RateTable,
    frame: &HouseFrame,
) -> [f64; Area::KINDS] {
    let mut area_m2 = [0.0; Area::KINDS];
    frame.areas.iter().for_each(|a| area_m2[a.area.kind()] += a.area_m2);
    let slope = frame.pitch_deg.to_radians().cos();
    let mut out = [0.0; Area::KINDS];
    for (item, kg) in Item::ALL.into_iter().zip(carried_kg(house, takeoff, rates)) {
        // A slope has more roof over its plan than a level strip.
        let weight = |kind: usize| if kind == SLOPES[0] { 1.0 / slope } else { 1.0 };
        let sum = |kinds: &[usize]| kinds.iter().map(|&k| area_m2[k] * weight(k)).sum::<f64>();
        let Some(kinds) = places(item).iter().find(|kinds| sum(kinds) > 0.0) else { continue };
        let each = kg * FREE_FALL_M_S2 / sum(kinds);
        kinds.iter().for_each(|&k| out[k] += each * weight(k));
    }
    out
}

/// Foundation with nothing above it, m2: decks there are on the ground.
fn deck_on_foundation_m2(house: &House) -> f64 {
    let [nx, ny, _] = house.voxels.shape();
    let cells = (0..nx).flat_map(|x| (0..ny).map(move |y| [x, y]));
    let open = cells.filter(|&[x, y]| {
        house.voxels.get([x, y, 0]) == Label::Foundation && !house.voxels.at([x as isize, y as isize, 1]).is_filled()
    });
    open.count() as f64 * house.voxels.module.size_m[0] * house.voxels.module.size_m[1]
}
