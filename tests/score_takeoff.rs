//! The take-off of the sample houses against counts by hand, with the tileset whose surface is the voxels' own boundary.

#[path = "common/runs.rs"]
mod runs;

use houscaper::quantities::{Item, Takeoff};
use houscaper::score::Evaluator;
use houscaper::voxels::{Choices, House, samples};

fn evaluator() -> Evaluator {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["tileset"] = "surface-1".into());
    runs::evaluator(&brief)
}

fn takeoff(house: &House) -> Takeoff {
    evaluator().details(house, &Choices::default()).evaluation.takeoff.expect("admissible houses are taken off")
}

fn check(takeoff: &Takeoff, expected: &[(Item, f64)]) {
    let measured = takeoff.measured();
    for (item, value) in expected {
        assert!(
            (measured[*item as usize] - value).abs() < 1e-9,
            "{item:?}: {} is not {value}",
            measured[*item as usize]
        );
    }
}

/// Area of a facade voxel, m2.
const FACE: f64 = 0.9 * 0.54;
/// Plan area of a module, m2.
const CELL: f64 = 0.81;

/// 7 x 6 modules: 26 facade voxels a layer, five layers of wall less 15 of window and 4 of door.
#[test]
fn box_house() {
    check(
        &takeoff(&samples::box_house()),
        &[
            (Item::Plinth, 26.0 * FACE),
            (Item::Band, 26.0 * FACE),
            (Item::Wall, (5.0 * 26.0 - 15.0 - 4.0) * FACE),
            (Item::Window, 15.0 * FACE),
            (Item::Door, 1.0),
            (Item::FlatRoof, 42.0 * CELL),
            (Item::Deck, 0.0),
            (Item::Ground, 42.0 * CELL),
            (Item::PerimeterBeam, 26.0 * 0.9),
            (Item::InnerFloor, 0.0),
            (Item::Stair, 0.0),
            (Item::Railing, 0.0),
        ],
    );
}

/// 8 x 7 modules on two storeys, a u-turn stair with a void of 4 x 2 cells whose last step opens onto one lane. Two plates have
/// the house above and below: the floor of the upper storey, and its ceiling under the roof space.
#[test]
fn hip_house_inside() {
    check(
        &takeoff(&samples::hip_house()),
        &[
            (Item::Plinth, 30.0 * FACE),
            // Windows: 2 x 4 + 3 x 3 + 3 x 3 + 2 x 3 voxels; a door of four.
            (Item::Window, 32.0 * FACE),
            (Item::Door, 1.0),
            (Item::Ground, 56.0 * CELL),
            (Item::PerimeterBeam, 30.0 * 0.9),
            (Item::InnerFloor, 2.0 * (7.2 - 0.6) * (6.3 - 0.6) - 8.0 * CELL),
            (Item::Stair, 1.0),
            (Item::Railing, 12.0 * 0.9 - 0.9),
        ],
    );
}

/// A deck of 3 x 7 cells with railing on its three free sides, and a straight stair.
#[test]
fn deck_house_outside() {
    let house = samples::deck_house();
    let void = house.stairs[0].void_cells().len() as f64;
    assert!(void >= 5.0, "a void over at least five runs");
    check(
        &takeoff(&house),
        &[
            (Item::Deck, 21.0 * CELL),
            (Item::FlatRoof, 63.0 * CELL),
            (Item::Ground, 84.0 * CELL),
            (Item::PerimeterBeam, 38.0 * 0.9),
            (Item::InnerFloor, (8.1 - 0.6) * (6.3 - 0.6) - void * CELL),
            (Item::Door, 2.0),
            (Item::Stair, 1.0),
            (Item::Railing, 13.0 * 0.9 + (2.0 * (void + 1.0) - 1.0) * 0.9),
        ],
    );
}

/// The deck without its door is a roof: no decking, no railing around it.
#[test]
fn a_deck_without_a_door_is_a_roof() {
    let mut house = samples::deck_house();
    for k in 7..11 {
        house.voxels.set([9, 5, k], houscaper::voxels::Label::Base);
    }
    let void = house.stairs[0].void_cells().len() as f64;
    check(
        &takeoff(&house),
        &[
            (Item::Deck, 0.0),
            (Item::FlatRoof, 84.0 * CELL),
            (Item::Door, 1.0),
            (Item::Railing, (2.0 * (void + 1.0) - 1.0) * 0.9),
        ],
    );
}

/// Whatever the shape: windows by count equal windows by surface, and sheltered facade equals what the voxels show.
#[test]
fn facades_equal_the_voxels_own_boundary() {
    for (name, house) in samples::all() {
        let takeoff = takeoff(&house);
        assert!(takeoff.window_mismatch_m2().abs() < 1e-9, "{name}");
        let voxels = &house.voxels;
        let [nx, ny, nz] = voxels.shape();
        let mut sides = 0;
        for cell in (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z]))) {
            let at = |dx: isize, dy: isize| voxels.at([cell[0] as isize + dx, cell[1] as isize + dy, cell[2] as isize]);
            if voxels.get(cell).is_filled() {
                sides += [(1, 0), (-1, 0), (0, 1), (0, -1)].iter().filter(|(x, y)| !at(*x, *y).is_filled()).count();
            }
        }
        use houscaper::envelope::Surface;
        let upright = [Surface::Wall, Surface::Band, Surface::Plinth, Surface::Window, Surface::Door];
        let found: f64 = upright.iter().map(|s| takeoff.area_m2()[*s as usize]).sum();
        let pitched = takeoff.area_m2()[Surface::PitchedRoof as usize];
        // Steps of a stepped roof are roof, not wall, also where they stand upright.
        let expected = sides as f64 * FACE;
        assert!(found <= expected + 1e-9 && found + pitched >= expected - 1e-9, "{name}: {found} of {expected}");
    }
}
