//! The origins of a take-off: each of its rows as the tiles, openings, plates, stairs and members that it was measured on.
//!
//! Not part of an evaluation: what an evaluation sums by key and by group is taken here cube by cube and stick by stick.

use std::collections::BTreeMap;

use super::heat::compass;
use super::measure::{foundation, opening_height_m, opening_sill, void_railing_m};
use super::{Details, Evaluator, Walked};
use crate::envelope::{Skin, Surface};
use crate::frame::HouseFrame;
use crate::quantities::{FrameMaterial, Item, Origin, OriginKind, OriginRow, Takeoff, TakeoffLine};
use crate::structure::SectionOption;
use crate::tiles::solids::edges::EdgeTerms;
use crate::voxels::{Boards, Choices, House, Label, STOREY_MODULES};

/// Quantities by item and origin, in the order in which they were met.
#[derive(Default)]
struct Found(BTreeMap<Item, Vec<Origin>>);

impl Found {
    fn add(&mut self, item: Item, kind: OriginKind, id: impl ToString, quantity: f64) {
        if quantity != 0.0 {
            self.0.entry(item).or_default().push(Origin { kind, id: id.to_string(), quantity });
        }
    }
}

impl Evaluator {
    /// The rows of a house's take-off with their origins; `None` where nothing was taken off.
    pub fn origins(&self, house: &House, choices: &Choices, details: &Details) -> Option<Vec<OriginRow>> {
        let takeoff = details.evaluation.takeoff.as_ref()?;
        let mut found = Found::default();
        self.surfaces(house, choices, details, takeoff, &mut found);
        self.building(house, details, &mut found);
        let sections = self.sections(choices);
        let members = |line: &TakeoffLine, frame: &HouseFrame| self.members(line, frame, takeoff, &sections);
        let name = |number: u16| number.to_string();
        let mut rows = Vec::new();
        for (index, line) in takeoff.lines(&name).into_iter().enumerate() {
            let origins = match (line.item, &details.frame) {
                (item, Some(frame)) if item.is_frame() => members(&line, frame),
                (Item::Window, _) => self.windows(house, details, &line),
                (Item::InnerFloor, _) => inner_floor(details, takeoff, &line, rows.iter()),
                (item, _) => found.0.remove(&item).unwrap_or_default(),
            };
            let TakeoffLine { item, description, quantity, unit, .. } = line;
            rows.push(OriginRow { line: index + 1, item, description, quantity, unit, origins });
        }
        let named = takeoff.lines(&|number| self.catalogue.section_id(number));
        rows.iter_mut().zip(named).for_each(|(row, line)| row.description = line.description);
        Some(rows)
    }

    /// Everything that the tiles say: surfaces, and the edges of roofs and decks.
    fn surfaces(&self, house: &House, choices: &Choices, details: &Details, takeoff: &Takeoff, found: &mut Found) {
        let walked = Walked::new(house, &details.reading);
        let keyed = matches!(self.tiling.skin, Skin::Keys(_));
        let built_as = |surface: Surface| match surface {
            Surface::Wall if self.boards(choices) == Boards::BothSides => Item::WallBothSides,
            surface => Item::of_surface(surface),
        };
        let on = |voxel: [isize; 3]| voxel.iter().all(|&v| v >= 0) && walked.has(voxel.map(|v| v as usize));
        self.tiling.skin.by_cube(
            &house.voxels,
            |v| walked.has(v),
            |cube, pieces, edges| {
                let id = cube.map(|n| n.to_string()).join(",");
                let mut sums = [0.0; Surface::ALL.len()];
                for piece in pieces {
                    // Decks that nobody walks on are roofs.
                    let is_roof = piece.surface == Surface::Deck && !on(piece.voxel);
                    let surface = if is_roof { Surface::FlatRoof } else { piece.surface };
                    sums[surface as usize] += piece.area_m2;
                }
                for surface in Surface::ALL {
                    // Openings are counted by themselves.
                    if !matches!(surface, Surface::Window | Surface::Door) {
                        found.add(built_as(surface), OriginKind::Tile, &id, sums[surface as usize]);
                    }
                }
                let EdgeTerms { overhang_m2, gutter_m, parapet_m2, coping_m, railing_m } = *edges;
                found.add(Item::Overhang, OriginKind::TileEdge, &id, overhang_m2);
                found.add(Item::Gutter, OriginKind::TileEdge, &id, gutter_m);
                found.add(Item::Parapet, OriginKind::TileEdge, &id, parapet_m2);
                found.add(Item::Coping, OriginKind::TileEdge, &id, coping_m);
                if keyed {
                    found.add(Item::Railing, OriginKind::TileEdge, &id, railing_m);
                }
            },
        );
        self.even_decks(takeoff, found);
    }

    /// A deck is measured by its cells and drawn by its tiles: where the two differ, as at walls that tiles set back, the plate makes up.
    fn even_decks(&self, takeoff: &Takeoff, found: &mut Found) {
        let area = takeoff.area_m2();
        for (item, surface) in [(Item::Deck, Surface::Deck), (Item::FlatRoof, Surface::FlatRoof)] {
            let tiles: f64 = found.0.get(&item).into_iter().flatten().map(|o| o.quantity).sum();
            let rest = area[surface as usize] - tiles;
            if rest.abs() > 1e-9 * tiles.abs().max(1.0) {
                found.add(item, OriginKind::Plate, "cells less tiles", rest);
            }
        }
    }

    /// Foundation, stairs, doors and railings.
    fn building(&self, house: &House, details: &Details, found: &mut Found) {
        let (reading, size) = (&details.reading, house.voxels.module.size_m);
        let keyed = matches!(self.tiling.skin, Skin::Keys(_));
        for (n, o) in reading.openings.iter().enumerate().filter(|(_, o)| o.label == Label::Opening) {
            let at = format!("{n} storey {} facing {}", o.storey, compass(o.facing));
            found.add(Item::Door, OriginKind::Opening, at, 1.0);
        }
        (0..house.stairs.len()).for_each(|n| found.add(Item::Stair, OriginKind::Stair, n, 1.0));
        for plate in reading.plates.iter().skip(1) {
            if !keyed {
                let deck = crate::voxels::walked_deck(house, reading, plate);
                let railing = super::measure::border_m(&deck, size, |n| !plate.cells.has(n));
                found.add(Item::Railing, OriginKind::Plate, plate.k, railing);
            }
            for (n, stair) in
                house.stairs.iter().enumerate().filter(|(_, s)| (s.storey + 1) * STOREY_MODULES == plate.k)
            {
                found.add(Item::Railing, OriginKind::Stair, n, void_railing_m(stair, plate, size));
            }
        }
        let Some(ground) = reading.plates.first() else { return };
        if keyed && super::measure::ground_is_foundation(house, ground) {
            let (beam_m, edge) = foundation(&ground.cells, size, &self.tiling.shells);
            let slab_m2 = details.areas.map_or(0.0, |a| a.area_m2[Surface::Ground as usize]);
            found.add(Item::PerimeterBeam, OriginKind::Plate, ground.k, beam_m);
            found.add(Item::Plinth, OriginKind::Plate, ground.k, edge.plinth_below_m2);
            found.add(Item::Ground, OriginKind::Plate, ground.k, -edge.without_slab_m2.min(slab_m2));
        } else {
            let outline = super::measure::border_m(&ground.cells, size, |n| !ground.cells.has(n));
            found.add(Item::PerimeterBeam, OriginKind::Plate, ground.k, outline);
        }
    }

    /// The windows of one size.
    fn windows(&self, house: &House, details: &Details, line: &TakeoffLine) -> Vec<Origin> {
        let sill = opening_sill(matches!(self.tiling.skin, Skin::Keys(_)));
        let size = house.voxels.module.size_m;
        let each = line.quantity / f64::from(line.pieces.max(1));
        let mut all = Vec::new();
        for (n, o) in details.reading.openings.iter().enumerate().filter(|(_, o)| o.label != Label::Opening) {
            let (width, height) = (o.width as f64 * size[o.along()], opening_height_m(house, o, sill));
            if line.description == format!("window {width:.2} x {height:.2} m") && (width * height - each).abs() < 1e-3
            {
                let id = format!("{n} storey {} facing {}", o.storey, compass(o.facing));
                all.push(Origin { kind: OriginKind::Opening, id, quantity: width * height });
            }
        }
        all
    }

    /// The members of one row: group, material and section.
    pub(super) fn members(
        &self,
        line: &TakeoffLine,
        frame: &HouseFrame,
        takeoff: &Takeoff,
        sections: &[SectionOption; 4],
    ) -> Vec<Origin> {
        let name = |number: u16| number.to_string();
        let of_frame: Vec<TakeoffLine> = takeoff.lines(&name).into_iter().filter(|l| l.item.is_frame()).collect();
        // Lines of the frame stand in the order of items, within one in that of the take-off's rows.
        let Some(place) = of_frame.iter().position(|l| l == line) else { return Vec::new() };
        let mut ordered: Vec<usize> =
            (0..takeoff.frame().len()).filter(|&r| takeoff.frame()[r].billed() > 0.0).collect();
        ordered.sort_by_key(|&r| takeoff.frame()[r].material.item());
        let Some(row) = ordered.get(place).map(|&r| &takeoff.frame()[r]) else { return Vec::new() };
        let option = sections[row.group as usize];
        let (area_m2, density) = (self.catalogue.section(option).a, self.catalogue.material(option).rho);
        let per_m = match row.material {
            FrameMaterial::S235 | FrameMaterial::S355 => density * area_m2,
            FrameMaterial::C24 | FrameMaterial::GL24h | FrameMaterial::GL28h => area_m2,
        };
        let own = frame.members.iter().enumerate().filter(|(_, m)| m.group as usize == row.group as usize);
        let origin = |(n, m): (usize, &crate::frame::FrameMember)| Origin {
            kind: OriginKind::Member,
            id: n.to_string(),
            quantity: m.length_m * f64::from(m.plies) * per_m,
        };
        own.map(origin).collect()
    }
}

/// A plate's floor; the rows of floors with area stand in the order of the plates.
fn inner_floor<'a>(
    details: &Details,
    takeoff: &Takeoff,
    line: &TakeoffLine,
    before: impl Iterator<Item = &'a OriginRow>,
) -> Vec<Origin> {
    let place = before.filter(|r| r.item == Item::InnerFloor).count();
    let with_area = takeoff.floors_m2().iter().enumerate().filter(|(_, m2)| **m2 > 0.0);
    let plate = with_area.map(|(n, _)| n).nth(place).and_then(|n| details.reading.plates.get(n + 1));
    plate
        .map(|p| Origin { kind: OriginKind::Plate, id: p.k.to_string(), quantity: line.quantity })
        .into_iter()
        .collect()
}
