//! Masses of parts, and what a truck or crane cannot take.

use super::frame_mass::frame_masses;
use super::types::{Part, PartId, PartKind, Parts, Settings};
use crate::frame::HouseFrame;
use crate::price::RateTable;
use crate::quantities::{FrameMaterial, Item, Takeoff};

/// Highest upright panel, m: one storey of six modules; with the bed of a low loader at 0.7 m it stays under the 4.0 m of road traffic
/// (Directive 96/53/EC, annex I 1.3).
pub const HIGHEST_M: f64 = 3.24;
/// Heaviest part, kg. Assumption: what a truck-mounted crane lifts at 12 m reach, 3 t.
pub const HEAVIEST_KG: f64 = 3000.0;

/// Items of walls (a house has the first or the second) and of what lies level or inclined, which are shared out over parts.
const WALL: [Item; 3] = [Item::Wall, Item::WallBothSides, Item::Band];
const LEVEL: [Item; 5] = [Item::PitchedRoof, Item::FlatRoof, Item::Deck, Item::Soffit, Item::InnerFloor];

/// Masses of a house's parts in kg.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Masses {
    /// By part: layers, finishes, openings and the members of the frame built into it.
    pub part_kg: Vec<f64>,
    /// Of which members of the frame, by part.
    pub frame_kg: Vec<f64>,
    /// What is no part: foundation, railings, decks on the ground, and what the house has no part for.
    pub site_kg: f64,
    /// Members of the frame in no part: posts inside.
    pub loose_frame_kg: f64,
}

impl Masses {
    /// Sum of the parts, of site work and of loose members: the mass of the take-off.
    pub fn total_kg(&self) -> f64 {
        self.part_kg.iter().sum::<f64>() + self.site_kg + self.loose_frame_kg
    }
}

/// Quantities of one part by its own outline.
fn own_quantities(parts: &Parts, part: &Part, add: &mut dyn FnMut(Item, f64)) {
    let cell_m2 = parts.module_m[0] * parts.module_m[1];
    match part.kind {
        // Bands are walls to the build-ups; a panel has its share of both.
        PartKind::Wall => WALL.into_iter().for_each(|item| add(item, part.area_m2)),
        PartKind::Floor => {
            let cells = parts.cells_of(part);
            let outside = cells.iter().filter(|c| c.code == 2).count() as f64;
            let inner = cells.len() as f64 - outside;
            add(Item::InnerFloor, part.area_m2 * inner / cells.len().max(1) as f64);
            add(Item::Soffit, outside * cell_m2);
        }
        PartKind::Deck => {
            let walked = parts.cells_of(part).iter().any(|c| c.code == 4);
            add(if walked { Item::Deck } else { Item::FlatRoof }, part.area_m2);
        }
        PartKind::Slope => add(Item::PitchedRoof, part.area_m2),
        PartKind::Level => add(Item::FlatRoof, part.area_m2),
        PartKind::Window => add(Item::Window, part.area_m2),
        PartKind::Door => add(Item::Door, 1.0),
        PartKind::Stair => add(Item::Stair, 1.0),
    }
}

/// Shares the masses of a take-off out over the parts, so that parts, site work and loose members sum to the take-off's mass.
///
/// Each item goes to its parts in proportion to their own areas: the areas of parts count modules and butt corners, those of the envelope
/// follow the tiles; the factor between them is the same for all parts of an item. Foundation, railings and decks on the foundation
/// are site work. An item without a part of its own (the tileset may call a slope level) is shared over all roofs and floors, else over
/// the walls, else it stays on site. Members of the frame go to the part they are built into; `frame` is the house's with the mass of a
/// metre of its members by wall, floor, beam, roof; without it parts are weighed without members.
pub fn masses(parts: &Parts, takeoff: &Takeoff, rates: &RateTable, frame: Option<(&HouseFrame, [f64; 4])>) -> Masses {
    let measured = takeoff.measured();
    let mut sums = [0.0; Item::COUNT];
    for part in &parts.parts {
        own_quantities(parts, part, &mut |item, q| sums[item as usize] += q);
    }
    let on_site = parts.site_deck_m2;
    sums[Item::FlatRoof as usize] += on_site;
    let mut loose = 0.0;
    let mut factor = [0.0; Item::COUNT];
    for item in Item::ALL {
        let n = item as usize;
        let kg = measured[n] * rates.rows[n].mass_kg;
        if sums[n] > 0.0 {
            factor[n] = kg / sums[n];
        } else if WALL.contains(&item) || LEVEL.contains(&item) {
            loose += kg;
        }
    }
    let none = vec![0.0; parts.parts.len()];
    let mut out = Masses { part_kg: none.clone(), frame_kg: none, ..Masses::default() };
    for (kg, part) in out.part_kg.iter_mut().zip(&parts.parts) {
        own_quantities(parts, part, &mut |item, q| *kg += q * factor[item as usize]);
    }
    let lying = |p: &Part| p.kind.is_flat() && p.kind != PartKind::Wall;
    let standing = |p: &Part| p.kind == PartKind::Wall;
    let area = |keep: &dyn Fn(&Part) -> bool| parts.parts.iter().filter(|p| keep(p)).map(|p| p.area_m2).sum::<f64>();
    let takers: &dyn Fn(&Part) -> bool = if area(&lying) > 0.0 { &lying } else { &standing };
    let whole = area(takers);
    if whole > 0.0 {
        for (kg, part) in out.part_kg.iter_mut().zip(&parts.parts).filter(|(_, p)| takers(p)) {
            *kg += loose * part.area_m2 / whole;
        }
    }
    let of_frame = FrameMaterial::ALL.map(FrameMaterial::item);
    let layers = Item::ALL.into_iter().filter(|item| !of_frame.contains(item));
    let whole: f64 = layers.map(|item| measured[item as usize] * rates.rows[item as usize].mass_kg).sum();
    // Never below zero by the rounding of a sum.
    out.site_kg = (whole - out.part_kg.iter().sum::<f64>()).max(0.0);
    if let Some((frame, kg_per_m)) = frame {
        let members = frame_masses(parts, frame, kg_per_m);
        out.part_kg.iter_mut().zip(&members.part_kg).for_each(|(sum, kg)| *sum += kg);
        (out.frame_kg, out.loose_frame_kg) = (members.part_kg, members.loose_kg);
    }
    out
}

/// A part that is too much for truck or crane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overload {
    /// The part.
    pub part: PartId,
    /// What is too large: `length_m`, `width_m`, `height_m` or `mass_kg`.
    pub what: &'static str,
    /// The value.
    pub found: f64,
    /// The limit.
    pub limit: f64,
}

/// Parts beyond the limits: length and width of the settings, [`HIGHEST_M`], [`HEAVIEST_KG`].
pub fn overloads(parts: &Parts, masses: &Masses, settings: Settings) -> Vec<Overload> {
    let mut found = Vec::new();
    for (n, part) in parts.parts.iter().enumerate().filter(|(_, p)| p.kind.is_flat()) {
        let lying = part.kind != PartKind::Wall;
        let checks = [
            ("length_m", part.length_mm / 1000.0, settings.longest_m, true),
            ("width_m", part.width_mm / 1000.0, settings.widest_m, lying),
            ("height_m", part.height_mm / 1000.0, HIGHEST_M, !lying),
            ("mass_kg", masses.part_kg.get(n).copied().unwrap_or(0.0), HEAVIEST_KG, true),
        ];
        for (what, value, limit, applies) in checks {
            if applies && value > limit + 1e-6 {
                found.push(Overload { part: PartId(n as u32), what, found: value, limit });
            }
        }
    }
    found
}
