//! Plain buildings on modules of any size, and what sizing picks for one group of their members while the others are ample.

#![allow(dead_code)]

use std::path::Path;

use houscaper::frame::{FrameOptions, FrameWorkspace, HouseFrame, Role, build};
use houscaper::structure::{Bid, Catalogue, LoadSettings, SizingStep, Workspace, size};
use houscaper::tiles::skeleton;
use houscaper::voxels::{Choice, Choices, House, Label, Module, read_storeys, samples};

/// Sections of wall, floor, beam and roof where they are not the question.
pub const AMPLE: [&str; 4] = ["GL_140x180", "GL_140x315", "GL_200x200", "GL_90x360"];
/// Their material.
pub const AMPLE_MATERIAL: &str = "GL28h";

/// The crate's configuration folder.
pub fn configs() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"))
}

/// A box of storeys under a flat roof: `cells` modules of `module_m` along x and y, one free around.
pub fn boxed(module_m: [f64; 3], cells: [usize; 2], storeys: usize) -> House {
    let footprint = [[1, 1, cells[0], cells[1]]];
    let mut house = samples::massing([cells[0] + 2, cells[1] + 2, 6 * storeys + 2], &vec![&footprint[..]; storeys], 0);
    house.voxels.module = Module { size_m: module_m };
    house
}

/// One storey under a gable roof whose ridge runs along x.
pub fn gable(module_m: [f64; 3], cells: [usize; 2]) -> House {
    let rise = cells[1].div_ceil(2);
    let mut house = samples::massing([cells[0] + 2, cells[1] + 2, rise + 8], &[&[[1, 1, cells[0], cells[1]]]], 0);
    for layer in 1..=rise {
        for y in layer..=cells[1] + 1 - layer {
            (1..=cells[0]).for_each(|x| house.voxels.set([x, y, 6 + layer], Label::Base));
        }
    }
    house.voxels.module = Module { size_m: module_m };
    house
}

/// A house's frame, joists along y.
pub fn framed(house: &House, options: FrameOptions) -> HouseFrame {
    let lines: Vec<_> = (0..=255u8).map(|m| skeleton(houscaper::cubes::Mask(m))).collect();
    let choices = Choices([0, 0, 0, 0, u16::MAX, 0]);
    let lines = |mask: u8| &lines[mask as usize][..];
    let mut workspace = FrameWorkspace::default();
    workspace.options = options;
    build(house, &read_storeys(house), &choices, lines, &mut workspace).expect("a house")
}

/// Clear lengths of the sticks of a role, m, shortest and longest.
pub fn bays(frame: &HouseFrame, role: Role) -> [f64; 2] {
    let spans = frame.spans.iter().filter(|s| frame.members[s.member as usize].role == role);
    let length = |e: [u32; 2]| (e[0]..=e[1]).map(|e| frame.element_length_m(e as usize)).sum::<f64>();
    spans.map(|s| length(s.elements)).fold([f64::INFINITY, 0.0], |[a, b], l| [a.min(l), b.max(l)])
}

/// Worst ratio of a group with one section, the other members being ample.
pub fn ratio(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    loads: &LoadSettings,
    group: Choice,
    material: &str,
    id: &str,
) -> f64 {
    walk(frame, catalogue, loads, group, material, &[id]).1.group_ratio[group as usize]
}

/// What sizing picks for one group from `ladder`, cheapest first, the other members being ample; and its last analysis.
pub fn pick(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    loads: &LoadSettings,
    group: Choice,
    material: &str,
    ladder: &[&str],
) -> (usize, SizingStep) {
    let (bid, found) = walk(frame, catalogue, loads, group, material, ladder);
    assert!(found.group_ratio[group as usize] <= 1.0, "{ladder:?} holds nothing: {found:?}");
    (bid, found)
}

fn walk(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    loads: &LoadSettings,
    group: Choice,
    material: &str,
    ladder: &[&str],
) -> (usize, SizingStep) {
    let bids = |material: &str, ids: &[&str]| -> Vec<Bid> {
        let option = |id: &&str| {
            catalogue.find(material, id).unwrap_or_else(|| panic!("{material} {id} is not in the catalogue"))
        };
        ids.iter().enumerate().map(|(n, id)| Bid { option: option(id), per_m: 1.0 + n as f64 }).collect()
    };
    let mut lists = AMPLE.map(|id| bids(AMPLE_MATERIAL, &[id]));
    lists[group as usize] = bids(material, ladder);
    let sizing = size(frame, catalogue, &lists, None, loads, &mut Workspace::default());
    let found = sizing.result().expect("it is analysed");
    (sizing.bids[group as usize], *found)
}
