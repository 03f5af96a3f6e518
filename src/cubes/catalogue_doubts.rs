//! Where the thesis's counts contradict each other, with both counts recomputed and the reason.

use super::catalogue::{Family, Grouping, catalogue, in_walls, parts_of_wall, patterns, with_opening};
use super::{CubeKey, reachable_labels};
use crate::voxels::Label;

/// A count that the thesis gives in two ways, or that depends on the reading.
#[derive(Clone, Debug, PartialEq)]
pub struct Doubt {
    /// What is counted.
    pub subject: &'static str,
    /// The reading that the catalogue uses.
    pub used: String,
    /// The other reading.
    pub other: String,
    /// Why they differ.
    pub reason: String,
}

/// The contradictions. Every number is counted here, none is quoted.
pub fn doubts() -> Vec<Doubt> {
    let families = catalogue();
    vec![
        windows(&families),
        seventy_two(),
        tiles(&families),
        thirty_nine(&families),
        doors(&families),
        rules(&families),
    ]
}

fn of<'f>(families: &'f [Family], name: &str) -> impl Iterator<Item = &'f Family> {
    families.iter().filter(move |f| f.name == name)
}

fn tiles_of(families: &[Family], names: &[&str]) -> usize {
    names.iter().flat_map(|name| of(families, name)).map(|f| f.tiles).sum()
}

/// Windows with the sixth category, the wall that is all glass.
fn with_full() -> Family {
    Family::new("", "", Grouping::TurnsAndMirror, in_walls(Label::Window, &parts_of_wall(true)))
}

fn windows(families: &[Family]) -> Doubt {
    let full = with_full();
    let (tiles, configurations) = of(families, "windows").fold((0, 0), |(t, c), f| (t + f.tiles, c + f.configurations));
    Doubt {
        subject: "window tiles (and openings likewise)",
        used: format!("{tiles} tiles, {configurations} configurations: five categories in two depths"),
        other: format!("{} tiles, {} configurations: six categories, the wall all glass too", full.tiles, full.configurations),
        reason: "the text says ten tiles and names five categories, the table says twelve; only the text's count adds up to 493"
            .into(),
    }
}

fn seventy_two() -> Doubt {
    let all = in_walls(Label::Window, &parts_of_wall(true));
    let family = with_full();
    let repeated = all.len() - family.configurations;
    Doubt {
        subject: "window configurations",
        used: format!(
            "{} different ones ({} without the wall all glass)",
            family.configurations,
            family.configurations - 8
        ),
        other: format!("{}: 9 parts of a wall x 4 walls x 2 depths", all.len()),
        reason: format!(
            "{repeated} are counted twice: with a room behind, a corner octant (8 parts) or a corner column (4) belongs to two walls"
        ),
    }
}

fn tiles(families: &[Family]) -> Doubt {
    let used: usize = families.iter().map(|f| f.tiles).sum();
    let other = used + 2 * (with_full().tiles - tiles_of(families, &["windows"]));
    Doubt {
        subject: "tiles in all",
        used: format!("{used}, with ten tiles each for windows and openings"),
        other: format!("{other}, with twelve each"),
        reason: "the table's total follows its own twelve; the 493 configurations of the text need ten".into(),
    }
}

fn thirty_nine(families: &[Family]) -> Doubt {
    let groups = [&["floor frame up", "floor frame down"][..], &["foundation frame up"], &["foundation only"]];
    let parts = groups.map(|names| tiles_of(families, names));
    Doubt {
        subject: "slab tiles",
        used: format!("{} in three groups", parts.map(|p| p.to_string()).join(" + ")),
        other: format!("{}", parts.iter().sum::<usize>()),
        reason: "the same tiles before they are grouped into floor (up and down), foundation up and foundation only"
            .into(),
    }
}

/// Another reading of the families of doors that gives the same counts: the slab lies under the whole cube.
fn on_full_slab(slab: Label) -> impl Iterator<Item = [Label; 8]> {
    let pairs = patterns().flat_map(|p| patterns().map(move |open| (p, open)));
    let fits = |&(p, open): &(u8, u8)| open & !p == 0 && open != p;
    pairs.filter(fits).map(move |(p, open)| with_opening(15, slab, p, open))
}

fn doors(families: &[Family]) -> Doubt {
    let other = Family::new("", "", Grouping::Turns, on_full_slab(Label::Floor));
    let (used, mirrored) = of(families, "floor to opening")
        .fold((0, 0), |(n, m), f| (n + f.configurations, m + Grouping::TurnsAndMirror.classes(&f.members)));
    Doubt {
        subject: "floor to opening",
        used: format!("{used}: slab and storey of the same plan"),
        other: format!("{}: slab under the whole cube", other.configurations),
        reason: format!(
            "both readings give 10 tiles and a union of 493; the ten are turned only, with mirror images there are {mirrored}"
        ),
    }
}

fn rules(families: &[Family]) -> Doubt {
    let reachable: Vec<CubeKey> = reachable_labels().into_iter().map(CubeKey::of_labels).collect();
    let allowed = |m: &&[Label; 8]| reachable.binary_search(&CubeKey::of_labels(**m)).is_ok();
    let all: usize = families.iter().map(|f| f.configurations).sum();
    let met: usize = families.iter().map(|f| f.members.iter().filter(allowed).count()).sum();
    Doubt {
        subject: "the catalogue under our rules",
        used: format!("{all} configurations, all of admissible cubes"),
        other: format!("{met} that a rule-respecting house can show"),
        reason: "a door stands on a slab, no opening at a corner or against a roof; and houses need many that the catalogue lacks"
            .into(),
    }
}
