//! Niches: what can be seen of a house, in classes. A map of elites has a cell for each.
//!
//! Four descriptors: number of storeys, shape of the ground storey's footprint, roof, and glass over net floor area of the whole house.

use super::cells::Cells;
use super::massing::{Design, Roof};
use super::openings::glass_m2;
use super::settle::floor_area_m2;

/// A cell of the map: the class of each descriptor, in the order of [`Descriptor::ALL`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Niche(pub [u8; 4]);

/// A descriptor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub enum Descriptor {
    /// Storeys.
    Storeys = 0,
    /// Shape of the ground storey's footprint.
    Footprint = 1,
    /// Roof.
    Roof = 2,
    /// Glass over net floor area.
    Glazing = 3,
}

impl Descriptor {
    /// All descriptors.
    pub const ALL: [Descriptor; 4] =
        [Descriptor::Storeys, Descriptor::Footprint, Descriptor::Roof, Descriptor::Glazing];

    /// Name of its column in tables.
    pub fn name(self) -> &'static str {
        match self {
            Descriptor::Storeys => "storeys",
            Descriptor::Footprint => "footprint_shape",
            Descriptor::Roof => "roof_type",
            Descriptor::Glazing => "glazing_class",
        }
    }

    /// Its classes, as tables and maps call them.
    pub fn classes(self) -> &'static [&'static str] {
        match self {
            Descriptor::Storeys => &["1 storey", "2 storeys", "3 storeys", "4 storeys and more"],
            Descriptor::Footprint => &["compact", "bar", "L", "T, U or Z", "articulated", "courtyard"],
            Descriptor::Roof => &["flat roof", "low hip", "high hip"],
            Descriptor::Glazing => &["below 15 %", "15 to 20 %", "20 to 25 %", "25 to 30 %", "30 % and more"],
        }
    }
}

impl Niche {
    /// What a class of this niche is called.
    pub fn class(&self, descriptor: Descriptor) -> &'static str {
        let classes = descriptor.classes();
        classes[usize::from(self.0[descriptor as usize]).min(classes.len() - 1)]
    }
}

/// The niche of a design.
pub fn niche(design: &Design) -> Niche {
    let massing = &design.massing;
    let storeys = massing.storeys.len().clamp(1, 4) as u8 - 1;
    let footprint = massing.storeys.first().map_or(0, |s| footprint_class(&s.footprint));
    let roof = match massing.roof {
        Roof::Flat => 0,
        Roof::Hip(0..=2) => 1,
        Roof::Hip(_) => 2,
    };
    let glass: f64 = massing.storeys.iter().flat_map(|s| &s.openings).map(glass_m2).sum();
    Niche([storeys, footprint, roof, glazing_class(glass / floor_area_m2(massing).max(1e-9))])
}

/// Longest side over shortest up to which a rectangle is compact.
const COMPACT: f64 = 1.5;

/// Class of a footprint: a court makes a courtyard house, else the inner corners of the outline count (1 for an L; 2 for T, U and Z; more
/// for articulated plans), and a rectangle is compact or a bar by its proportion.
fn footprint_class(plan: &Cells) -> u8 {
    let outside = plan.outside();
    if !outside.is_connected() {
        return 5;
    }
    let (_, [w, h]) = plan.bounds().unwrap_or_default();
    match inner_corners(plan) {
        0 if w.max(h) as f64 <= COMPACT * w.min(h) as f64 => 0,
        0 => 1,
        1 => 2,
        2 => 3,
        _ => 4,
    }
}

/// Corners of the outline at which three of the four cells around are in the plan.
fn inner_corners(plan: &Cells) -> usize {
    let [nx, ny] = plan.size().map(|n| n as isize);
    let filled =
        |x: isize, y: isize| [[x, y], [x - 1, y], [x, y - 1], [x - 1, y - 1]].iter().filter(|c| plan.has(**c)).count();
    (0..=ny).flat_map(|y| (0..=nx).map(move |x| (x, y))).filter(|&(x, y)| filled(x, y) == 3).count()
}

/// Classes of five hundredths from 15 to 30 % (rules keep the glazing of each storey between 10 and 35 %).
fn glazing_class(ratio: f64) -> u8 {
    [0.15, 0.20, 0.25, 0.30].iter().filter(|limit| ratio >= **limit).count() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rect(x: isize, y: isize, w: usize, h: usize) -> Cells {
        Cells::rect([16, 16], [x, y], [w, h])
    }

    #[test]
    fn footprints_are_named_as_architects_name_them() {
        let class = |plan: &Cells| Descriptor::Footprint.classes()[usize::from(footprint_class(plan))];
        assert_eq!(class(&rect(2, 2, 6, 4)), "compact");
        assert_eq!(class(&rect(2, 2, 7, 4)), "bar");
        assert_eq!(class(&rect(0, 0, 9, 4).or(&rect(0, 0, 4, 9))), "L");
        assert_eq!(class(&rect(0, 0, 12, 4).or(&rect(4, 0, 4, 9))), "T, U or Z");
        assert_eq!(class(&rect(0, 0, 12, 4).or(&rect(0, 0, 4, 9)).or(&rect(8, 0, 4, 9))), "T, U or Z");
        assert_eq!(class(&rect(0, 4, 12, 4).or(&rect(4, 0, 4, 12))), "articulated");
        assert_eq!(class(&rect(0, 0, 12, 12).minus(&rect(4, 4, 4, 4))), "courtyard");
    }

    #[test]
    fn glazing_classes_begin_at_their_limits() {
        assert_eq!([0.10, 0.1499, 0.15, 0.2, 0.2999, 0.3, 0.35].map(glazing_class), [0, 0, 1, 2, 3, 4, 4]);
        assert_eq!(Descriptor::Glazing.classes().len(), 5);
    }
}
