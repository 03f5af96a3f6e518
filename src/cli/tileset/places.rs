//! Typical neighbourhoods: corners of small houses where several tiles meet.

use houscaper::voxels::{Direction, House, Label, samples};

/// A house and the part of it to look at.
pub struct Place {
    /// First line of the caption.
    pub name: &'static str,
    /// Second line.
    pub caption: &'static str,
    /// The house.
    pub house: House,
    /// Box to show, m.
    pub fit: [[f64; 3]; 2],
    /// From where, degrees counter-clockwise from east.
    pub azimuth_deg: f32,
    /// Height of the ground, m.
    pub ground_m: f64,
}

/// The terrain lies a step below the slab's top.
const GROUND_M: f64 = -0.15;

/// All of them.
pub fn places() -> Vec<Place> {
    let place =
        |name, caption, house, fit, azimuth_deg| Place { name, caption, house, fit, azimuth_deg, ground_m: GROUND_M };
    vec![
        place("eaves corner", "hip over two walls", samples::hip_house(), [[5.2, -0.2, 5.6], [8.1, 2.6, 8.2]], -57.0),
        place("gable", "verge, ridge, eaves", gable_house(), [[4.6, 0.2, 2.6], [7.4, 6.0, 5.8]], -30.0),
        place("valley", "two wings under one roof", samples::l_house(), [[2.6, 2.8, 2.6], [7.4, 7.4, 5.4]], 32.0),
        place(
            "window group",
            "three modules, one frame",
            samples::box_house(),
            [[3.0, 0.2, 0.0], [7.0, 1.2, 3.6]],
            -70.0,
        ),
        place("door on slab", "four modules high", samples::box_house(), [[0.3, 0.2, -0.2], [3.6, 1.2, 3.4]], -70.0),
        place(
            "terrace edge",
            "deck with a door, railing",
            samples::deck_house(),
            [[7.6, 0.2, 2.0], [11.4, 4.4, 5.8]],
            -42.0,
        ),
        place(
            "flat roof",
            "edge of a roof not walked on",
            samples::box_house(),
            [[4.4, 0.2, 2.2], [7.2, 3.0, 4.2]],
            -57.0,
        ),
        place(
            "two storeys",
            "the whole of a house with a terrace",
            samples::deck_house(),
            [[-0.2, -0.2, 0.0], [11.6, 7.0, 7.0]],
            -57.0,
        ),
    ]
}

/// One storey of 7 x 6 modules under a gabled roof.
fn gable_house() -> House {
    let mut house = samples::massing([9, 8, 12], &[&[[1, 1, 7, 6]]], 0);
    for (layer, rows) in [(7, 1..7), (8, 2..6), (9, 3..5)] {
        for y in rows {
            (1..8).for_each(|x| house.voxels.set([x, y, layer], Label::Base));
        }
    }
    samples::window(&mut house, 0, Direction::East, [7, 3], 2);
    house
}
