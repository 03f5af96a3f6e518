//! What a house misses of a brief's programme, in words.

use houscaper::brief::Programme;
use houscaper::score::{Shortfall, entrances, floor_area_m2, out_of, zone_area_m2};
use houscaper::voxels::rules::Violation;
use houscaper::voxels::{House, read_storeys};

/// One violation named `programme.*` for each shortfall.
pub fn violations(programme: &Programme, house: &House, shortfall: &Shortfall) -> Vec<Violation> {
    let reading = read_storeys(house);
    let texts = [
        (
            format!(
                "the net floor area is {:.1} m2, asked for are {} to {} m2",
                floor_area_m2(&reading),
                programme.floor_area_m2[0],
                programme.floor_area_m2[1]
            ),
            "grow or shrink a bay, or change programme.floor_area_m2",
        ),
        (
            format!(
                "the house has {} storeys, asked for are {} to {}",
                reading.storeys.len(),
                programme.storeys[0],
                programme.storeys[1]
            ),
            "add or remove a storey, or change programme.storeys",
        ),
        (
            format!(
                "the lowest storey misses {:.1} % of the clear height of {} m, joists included",
                100.0 * shortfall.clear_height,
                programme.clear_height_m
            ),
            "raise the storey or lower programme.clear_height_m",
        ),
        (
            format!(
                "the darkest storey misses {:.1} % of the glazing ratio of {}",
                100.0 * shortfall.glazing,
                programme.glazing_ratio_min
            ),
            "add or widen windows, or lower programme.glazing_ratio_min",
        ),
        (
            format!(
                "the ground storey has {} doors, asked for are at least {}",
                entrances(&reading),
                programme.entrances_min
            ),
            "add a door onto the ground, or lower programme.entrances_min",
        ),
        (
            format!(
                "the roof misses the rise of {} to {} modules by {:.0}",
                programme.roof_rise[0], programme.roof_rise[1], shortfall.roof
            ),
            "raise or lower the roof, or change programme.roof_rise",
        ),
        (zone_words(programme, house), "fill or empty cells of these zones, or change programme.zones"),
    ];
    let parts = Shortfall::NAMES.into_iter().zip(shortfall.values()).zip(texts);
    parts
        .filter(|((_, amount), _)| *amount > 0.0)
        .map(|((rule, amount), (message, fix))| Violation {
            rule,
            voxels: Vec::new(),
            cube: None,
            message,
            fix: fix.to_owned(),
            amount,
        })
        .collect()
}

/// The zones whose area is not as asked.
fn zone_words(programme: &Programme, house: &House) -> String {
    let area = |zone: i32| zone_area_m2(house, zone);
    let off = programme.zones.iter().filter(|z| out_of(z.area_m2, area(z.zone)) > 0.0);
    let words = off.map(|z| {
        let [least, most] = z.area_m2;
        format!("zone {} has {:.1} m2, asked for are {least} to {most}", z.zone, area(z.zone))
    });
    words.collect::<Vec<_>>().join("; ")
}
