//! The rules that make a voxel array a house: each has an id, a sentence, and a check that measures how far it is broken.
//!
//! Rules that depend on a programme (areas, number of storeys) are not here: they belong to the brief.

mod body;
mod daylight;
mod facade;
mod plans;
mod plates;
mod reach;
mod report;
mod roofs;
mod settings;
mod site;
mod stairs;

pub use daylight::glass_in_view_m2;
pub use report::Violation;
pub use settings::{RuleSettings, SettingsError};
pub use site::Scratch;

use super::{House, Reading, read_storeys};
use report::Report;
use site::{Site, Work};

/// One rule.
pub struct Rule {
    /// Name in files and messages, kebab-case.
    pub id: &'static str,
    /// What it demands and why, with the default numbers.
    pub sentence: &'static str,
    check: fn(&Site, &mut Work, &mut Report),
}

/// Every rule, in the order in which violations are listed.
pub const RULES: &[Rule] = &[
    Rule {
        id: "cubes-admissible",
        sentence: "In every cube of eight voxels the filled corners and the empty corners are each connected through cube edges, so that a tile exists for it.",
        check: body::cubes,
    },
    Rule {
        id: "one-body",
        sentence: "All filled voxels hang together face to face: a house is one body.",
        check: body::one_body,
    },
    Rule {
        id: "foundation-layer",
        sentence: "The ground layer k = 0 is foundation and nothing else, and foundation lies nowhere else.",
        check: body::foundation,
    },
    Rule {
        id: "plates-complete",
        sentence: "At storey levels (k = 6, 12, ...) every filled voxel is floor, except the void of a stair; floor lies at no other level.",
        check: plates::complete,
    },
    Rule {
        id: "undercut",
        sentence: "The space under a body is filled or at least 4 modules high.",
        check: body::undercut,
    },
    Rule {
        id: "sky",
        sentence: "Every empty voxel connects to the sky around the house: there are no sealed voids.",
        check: body::sky,
    },
    Rule { id: "courts", sentence: "A court is at least 4 x 4 modules everywhere.", check: plans::courts },
    Rule {
        id: "plan-blocks",
        sentence: "Every storey's plan is a union of 3 x 3-module blocks, because 300 mm walls eat anything narrower.",
        check: plans::blocks,
    },
    Rule {
        id: "plan-rooms",
        sentence: "At least 60 % of every storey's plan lies in 4 x 4-module blocks.",
        check: plans::rooms,
    },
    Rule {
        id: "slenderness",
        sentence: "A house is at most 3 times as high as its base is wide.",
        check: body::slenderness,
    },
    Rule {
        id: "cantilever",
        sentence: "A cantilever reaches out at most 2 modules, with twice that standing behind it in line.",
        check: plans::cantilever,
    },
    Rule {
        id: "clear-height-min",
        sentence: "Rooms have at least 2.4 m between inner surfaces (2.6 m with the Dutch annex).",
        check: plates::clear_height_min,
    },
    Rule {
        id: "clear-height-max",
        sentence: "Outside stair voids and roof spaces, rooms are at most 1.5 times the least clear height.",
        check: plates::clear_height_max,
    },
    Rule {
        id: "stair-inside",
        sentence: "Flights, landings, foot and head of a stair lie inside the wall lining of the storeys they join, the landings on slab, and no two stairs share a cell.",
        check: stairs::inside,
    },
    Rule {
        id: "stair-void",
        sentence: "The plate above a stair is left out over every run but the first.",
        check: stairs::void,
    },
    Rule { id: "stair-width", sentence: "A stair is at least 800 mm wide all along.", check: stairs::width },
    Rule {
        id: "stair-headroom",
        sentence: "A stair has at least 2.0 m of headroom under the plate above.",
        check: stairs::headroom,
    },
    Rule {
        id: "storeys-reached",
        sentence: "Every storey is reached on foot from the entrance; a loft under 10 m2 may have a ladder.",
        check: reach::storeys,
    },
    Rule {
        id: "entrance",
        sentence: "At least one door of 850 x 2100 mm clear leads from the ground into the house, not onto a stair.",
        check: facade::entrance,
    },
    Rule { id: "doors-per-storey", sentence: "A storey has at most three exterior doors.", check: facade::door_count },
    Rule {
        id: "doors-ground",
        sentence: "A door of the ground storey stands on the slab and opens onto free ground.",
        check: facade::doors_ground,
    },
    Rule {
        id: "decks",
        sentence: "A door of an upper storey opens onto a deck at its own level; a deck without a door is a roof and not walked on.",
        check: facade::decks,
    },
    Rule {
        id: "opening-facade",
        sentence: "Windows and doors stand in a storey's facade, one voxel deep, with room behind them.",
        check: facade::in_facade,
    },
    Rule {
        id: "opening-corner",
        sentence: "No window or door stands at a corner of the house.",
        check: facade::corners,
    },
    Rule {
        id: "opening-surround",
        sentence: "A window has base to its left, right and above, and base or a slab below; a door the same above its slab.",
        check: facade::surround,
    },
    Rule {
        id: "glazing-min",
        sentence: "Glass with 2.7 m of free view is at least 10 % of the floor area of each storey.",
        check: daylight::least,
    },
    Rule {
        id: "glazing-max",
        sentence: "Glass is at most 35 % of the floor area of each storey.",
        check: daylight::most,
    },
    Rule {
        id: "glazing-orientations",
        sentence: "Each storey has glass with a free view in at least two orientations.",
        check: daylight::orientations,
    },
    Rule {
        id: "roof-drain",
        sentence: "From every roof and deck cell water finds a non-rising way to a free edge.",
        check: roofs::drain,
    },
    Rule {
        id: "roof-bump",
        sentence: "No part of a roof stands up on less than 3 modules of plan, unless it is the next step of a slope.",
        check: roofs::bump,
    },
    Rule {
        id: "zones",
        sentence: "Zones, where given, name one id per voxel, and only filled voxels belong to a zone.",
        check: body::zones,
    },
];

/// Checks a house against every rule that `settings` leaves on; violations come in the order of [`RULES`].
///
/// ```
/// use houscaper::voxels::{rules, samples, Label};
/// let mut house = samples::box_house();
/// assert!(rules::check(&house, &Default::default()).is_empty());
/// house.voxels.set([1, 1, 3], Label::Window); // a window at a corner
/// assert!(rules::check(&house, &Default::default()).iter().any(|v| v.rule == "opening-corner"));
/// ```
pub fn check(house: &House, settings: &RuleSettings) -> Vec<Violation> {
    let reading = read_storeys(house);
    let mut list = Vec::new();
    run(house, &reading, settings, &mut Scratch::default(), Some(&mut list));
    list
}

/// The sum of the amounts that [`check`] would list, without its texts: the hot path of a search. 0 means that every rule
/// holds. `reading` must be that of `house`; `scratch` is reused from house to house.
pub fn violation(house: &House, reading: &Reading, settings: &RuleSettings, scratch: &mut Scratch) -> f64 {
    run(house, reading, settings, scratch, None)
}

fn run(
    house: &House,
    reading: &Reading,
    settings: &RuleSettings,
    scratch: &mut Scratch,
    list: Option<&mut Vec<Violation>>,
) -> f64 {
    let (site, mut work) = scratch.prepare(house, reading, settings);
    let mut report = Report::new(list);
    for rule in RULES.iter().filter(|r| settings.off.iter().all(|off| off != r.id)) {
        report.rule = rule.id;
        (rule.check)(&site, &mut work, &mut report);
    }
    report.total
}
