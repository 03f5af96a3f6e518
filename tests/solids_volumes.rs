//! Volumes of strata: area times thickness.

#[path = "common/shells.rs"]
mod shells;

use houscaper::cubes::{CubeKey, FaceNumber};
use houscaper::tiles::solids::{SolidStyle, body};
use houscaper::tiles::{Block, Component, Stack, Stratum};
use houscaper::voxels::Label;

fn key(digits: &str, faces: [FaceNumber; 4], walked: u8) -> CubeKey {
    let labels = digits.bytes().map(|d| Label::from_code(d - b'0').expect("a label"));
    CubeKey::new(labels.collect::<Vec<_>>().try_into().expect("eight"), faces, walked)
}

fn volume(blocks: &[Block], component: Component) -> f64 {
    blocks.iter().filter(|b| b.component == component).map(Block::volume_m3).sum()
}

/// Strata of a stack that is met at right angles: exact; `area` in m2.
fn assert_strata(blocks: &[Block], stack: &Stack, area: f64) {
    for Stratum { component, thickness_um } in stack {
        let expected = area * f64::from(*thickness_um) * 1e-6;
        let found = volume(blocks, *component);
        assert!((found - expected).abs() < 1e-12, "{component:?}: {found} instead of {expected}");
    }
}

#[test]
fn a_straight_wall_is_area_times_thickness_in_three_blocks_a_half() {
    let shells = shells::shells();
    let blocks = body(key("01010101", [FaceNumber::None; 4], 0), &SolidStyle::default(), &shells);
    assert_strata(&blocks, &shells.wall, 0.9 * 0.54);
    assert_eq!(blocks.len(), 12, "three strata, two halves, two columns");
}

#[test]
fn floors_decks_and_soffits_are_area_times_thickness() {
    let (shells, style) = (shells::shells(), SolidStyle::default());
    let none = [FaceNumber::None; 4];
    assert_strata(&body(key("11112222", none, 0), &style, &shells), &shells.floor, 0.81);
    assert_strata(&body(key("22220000", none, 0), &style, &shells), &shells.flat, 0.81);
    assert_strata(&body(key("22220000", none, 15), &style, &shells), &shells.deck, 0.81);
    let soffit = body(key("00002222", none, 0), &style, &shells);
    assert_strata(&soffit, &shells.floor, 0.81);
    assert_strata(&soffit, &shells.soffit, 0.81);
    assert_strata(&body(key("00003333", none, 0), &style, &shells), &shells.ground, 0.81);
    let level = body(key("11110000", none, 0), &style, &shells);
    assert_strata(&level, &shells.flat, 0.81);
    assert_strata(&level, &shells.floor, 0.81);
}

#[test]
fn a_sloped_roof_is_plane_area_times_thickness() {
    let shells = shells::shells();
    let down = FaceNumber::StepDown;
    let blocks =
        body(key("00110000", [down, FaceNumber::None, down, FaceNumber::None], 0), &SolidStyle::default(), &shells);
    let plane = 0.9 * 0.45 * 1.36_f64.sqrt();
    // Depths below a sloped plane are whole multiples of 60 µm: half of that at each side of a stratum.
    let most = 0.9 * 0.45 * 60e-6;
    for Stratum { component, thickness_um } in shells.roof.iter().chain(&shells.roof_cover) {
        let (found, expected) = (volume(&blocks, *component), plane * f64::from(*thickness_um) * 1e-6);
        assert!((found - expected).abs() < most, "{component:?}: {found} instead of {expected}");
    }
    assert_eq!(blocks.len(), 6, "two strata and the covering over two columns");
}

#[test]
fn the_plinth_stands_outside_the_perimeter_beam() {
    let shells = shells::shells();
    let blocks = body(key("00000303", [FaceNumber::None; 4], 0), &SolidStyle::default(), &shells);
    let [width, depth] = shells.beam_um.map(|um| f64::from(um) * 1e-6);
    assert!((volume(&blocks, Component::PerimeterBeam) - 0.9 * width * depth).abs() < 1e-12);
    assert_strata(&blocks, &shells.plinth, 0.9 * depth);
    let inside = 0.45 - width - 0.128;
    assert_strata(&blocks, &shells.ground, 0.9 * inside);
}
