//! What is drawn against what is priced: where both are the same number, and where they differ by a known sign and no more than stated.

#[path = "common/drawn.rs"]
mod drawn;
#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;

use drawn::{random, shipped};
use houscaper::quantities::Item;
use houscaper::score::{Details, Evaluator, LayerRow, Weighed};
use houscaper::tiles::Component as C;
use houscaper::tiles::{Shells, depth_um};
use houscaper::voxels::{Choices, House, Label, samples};

fn evaluator() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

fn houses() -> Vec<(String, House, Choices)> {
    shipped().into_iter().chain(random(150)).collect()
}

struct Measured {
    details: Details,
    rows: Vec<LayerRow>,
}

impl Measured {
    fn new(evaluator: &Evaluator, house: &House, choices: &Choices) -> Measured {
        let details = evaluator.details(house, choices);
        let rows = evaluator.layers(house, &details).expect("a style").expect("shipped books");
        Measured { details, rows }
    }

    fn row(&self, component: C) -> Option<&LayerRow> {
        self.rows.iter().find(|r| r.component == component)
    }

    /// Drawn and priced volume, m3.
    fn volumes(&self, component: C) -> [f64; 2] {
        self.row(component).map_or([0.0; 2], |r| [r.volume_m3, r.takeoff_m3])
    }

    fn quantity(&self, item: Item) -> f64 {
        self.details.evaluation.takeoff.as_ref().expect("taken off").measured()[item as usize]
    }
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()).max(1.0)
}

/// Over all rows the priced mass is the mass of the bill without its frame; what is drawn weighs nearly the same.
#[test]
fn masses_of_layers_sum_to_the_bill() {
    let evaluator = evaluator();
    for (name, house, choices) in houses() {
        let measured = Measured::new(&evaluator, &house, &choices);
        let evaluation = &measured.details.evaluation;
        let frame: f64 = evaluation.takeoff.as_ref().expect("taken off").frame().iter().map(|f| f.mass_kg).sum();
        let bill = evaluation.cost.as_ref().expect("priced").mass_kg - frame;
        let priced: f64 = measured.rows.iter().map(|r| r.takeoff_kg).sum();
        assert!((priced - bill).abs() <= 1e-9 * bill, "{name}: layers {priced} kg, bill {bill} kg");
        let drawn: f64 = measured.rows.iter().map(|r| r.mass_kg).sum();
        assert!((0.93..=1.02).contains(&(drawn / priced)), "{name}: drawn {drawn} kg, priced {priced} kg");
        for row in &measured.rows {
            let shares: f64 = row.materials.iter().map(|(_, share)| share).sum();
            assert!(row.materials.is_empty() || (shares - 1.0).abs() < 1e-9, "{name} {row:?}");
            assert!(row.mass_kg >= 0.0 && row.takeoff_kg >= 0.0 && row.volume_m3 >= 0.0, "{name} {row:?}");
            assert_eq!(row.weighed == Weighed::ByVolume, row.density_kg_m3.is_some(), "{name} {row:?}");
            assert_ne!(row.weighed, Weighed::Not, "{name}: drawn, but no item is priced for it: {row:?}");
        }
    }
}

/// The strata of each build-up weigh what the build-up weighs, and a square metre of a stack as drawn does too.
#[test]
fn strata_weigh_what_their_build_up_weighs() {
    let evaluator = evaluator();
    let books = &evaluator.books;
    for buildup in books.buildups.buildups() {
        let strata = books.buildups.stratum_masses(buildup).expect("shipped strata");
        let whole = books.buildups.resolve(buildup, &books.prices, &books.carbon).expect("shipped books").mass_kg();
        let sum: f64 = strata.iter().map(|s| s.mass_kg).sum();
        assert!(close(sum, whole), "{}: strata {sum}, build-up {whole}", buildup.id);
        assert!(strata.iter().all(|s| !s.name.is_empty()), "{}: every layer belongs to a component", buildup.id);
    }
    // The box house has walls, one kind of roof, and no other use of these components.
    let measured = Measured::new(&evaluator, &samples::hip_house(), &Choices::default());
    let wall = books.buildup(Item::Wall).expect("a wall").rates.mass_kg;
    let by_rows: f64 = [C::Cladding, C::WallInsulation, C::WallLining]
        .iter()
        .map(|c| {
            let row = measured.row(*c).expect("drawn");
            row.density_kg_m3.expect("by volume") * row.thickness_mm.expect("a stratum") / 1e3
        })
        .sum();
    assert!(close(by_rows, wall), "a square metre of wall: {by_rows} kg drawn, {wall} kg in the build-up");
}

trait Mass {
    fn mass_kg(&self) -> f64;
}

impl Mass for houscaper::price::ResolvedBuildUp {
    fn mass_kg(&self) -> f64 {
        self.rates.mass_kg
    }
}

/// Outer less inner corners of the foundation's plan.
fn corners(house: &House) -> f64 {
    let at = |x: isize, y: isize| house.voxels.at([x, y, 0]) == Label::Foundation;
    let [nx, ny, _] = house.voxels.shape().map(|n| n as isize);
    let mut sum = 0.0;
    for (x, y) in (0..=nx).flat_map(|x| (0..=ny).map(move |y| (x, y))) {
        let filled = [at(x, y), at(x - 1, y), at(x, y - 1), at(x - 1, y - 1)].iter().filter(|f| **f).count();
        sum += [0.0, 1.0, 0.0, -1.0, 0.0][filled];
    }
    sum
}

/// Slab, insulation and beam: what is priced is what is drawn. The plinth is priced by its outer face and drawn round the corners.
#[test]
fn the_foundation_is_priced_as_it_is_drawn() {
    let evaluator = evaluator();
    let depth = f64::from(evaluator.tiling.shells.beam_um[1]) * 1e-6;
    for (name, house, choices) in houses() {
        let measured = Measured::new(&evaluator, &house, &choices);
        for component in [C::GroundSlab, C::GroundInsulation, C::PerimeterBeam] {
            let [drawn, priced] = measured.volumes(component);
            assert!(drawn > 0.0 && close(drawn, priced), "{name} {}: {drawn} m3, {priced} m3", component.name());
        }
        let mut from = 0.0;
        for stratum in &evaluator.tiling.shells.plinth {
            let to = from + f64::from(stratum.thickness_um) * 1e-6;
            let [drawn, priced] = measured.volumes(stratum.component);
            let at_corners = corners(&house) * depth * (to * to - from * from);
            assert!(close(drawn, priced - at_corners), "{name} {}: {drawn}, {priced}", stratum.component.name());
            from = to;
        }
    }
}

/// Walls from slab to slab under a level roof: area times thickness counts each outer corner's square twice and each inner corner's
/// never; nothing else differs.
#[test]
fn walls_differ_from_area_times_thickness_by_their_corners() {
    let evaluator = evaluator();
    let el: &[samples::Rect] = &[[1, 1, 9, 4], [1, 1, 4, 9]];
    let court: &[samples::Rect] = &[[1, 1, 13, 4], [1, 9, 13, 4], [1, 1, 4, 12], [10, 1, 4, 12]];
    let plain: &[samples::Rect] = &[[1, 1, 7, 6]];
    for (plan, storeys, turns) in [(plain, 1, 4.0), (plain, 2, 4.0), (el, 1, 4.0), (el, 2, 4.0), (court, 1, 0.0)] {
        let house = samples::massing([15, 14, 16], &vec![plan; storeys], 0);
        let measured = Measured::new(&evaluator, &house, &Choices::default());
        let height = 3.24 * storeys as f64;
        let mut from = f64::from(evaluator.tiling.shells.wall[0].thickness_um) * 1e-6;
        let [_, insulation, lining] = &evaluator.tiling.shells.wall[..] else { panic!("three strata") };
        let parapet = measured.quantity(Item::Parapet);
        for stratum in [insulation, lining] {
            let thickness = f64::from(stratum.thickness_um) * 1e-6;
            let to = from + thickness;
            let area = measured.quantity(Item::Wall) + measured.quantity(Item::Band);
            let [drawn, _] = measured.volumes(stratum.component);
            let mut expected = area * thickness - turns * height * (to * to - from * from);
            if stratum.component == C::WallInsulation {
                // Between the two skins of the parapet, mitred like the walls.
                let [near, far] = [from, 0.2 - from];
                let length = parapet / 0.3;
                expected += 0.3 * (length * (far - near) - turns * (far * far - near * near));
            }
            assert!(close(drawn, expected), "{plan:?} x {storeys} {}: {drawn}, {expected}", stratum.component.name());
            from = to;
        }
    }
}

/// Drawn over priced volume, least and most, for any house, with the reason.
const BOUNDS: [(C, f64, f64, &str); 17] = [
    (
        C::Cladding,
        0.95,
        1.15,
        "parapets are clad from the slab up, their item counts from the roof up; less at corners",
    ),
    (C::Band, 0.98, 1.0, "corners"),
    (C::WallInsulation, 0.85, 1.01, "corners; more in inner corners and behind roofs that end at a wall"),
    (C::WallLining, 0.8, 1.0, "corners; more in inner corners"),
    (C::RoofCovering, 0.995, 1.0, "thicknesses on slopes are rounded to 60 um"),
    (C::RoofInsulation, 0.75, 0.95, "roofs rest on the walls' heads, which hold the walls' strata"),
    (C::RoofLining, 0.65, 0.95, "the same"),
    (C::FlatMembrane, 0.75, 1.0, "parapets and edges stand on the membrane's margin"),
    (C::FlatInsulation, 0.9, 1.0, "edges and parapets have claddings of their own"),
    (C::DeckBoards, 0.8, 1.0, "edge boards"),
    (C::FloorBoards, 0.7, 1.0, "floors end at the lining, roofs are measured to their edge"),
    (C::FloorStructure, 0.7, 1.0, "the same"),
    (C::Ceiling, 0.7, 1.0, "the same"),
    (C::SoffitInsulation, 0.45, 1.0, "between the strata of the walls above"),
    (C::SoffitBoards, 0.85, 1.0, "behind the cladding of the walls above"),
    (C::PlinthInsulation, 0.9, 1.0, "corners"),
    (C::PlinthRender, 0.98, 1.0, "corners"),
];

#[test]
fn every_layer_is_drawn_within_its_bounds() {
    let evaluator = evaluator();
    let mut met: BTreeMap<C, [f64; 2]> = BTreeMap::new();
    let mut wrong = Vec::new();
    for (name, house, choices) in houses() {
        let measured = Measured::new(&evaluator, &house, &choices);
        for (component, least, most, why) in BOUNDS {
            let [drawn, priced] = measured.volumes(component);
            if priced == 0.0 {
                continue;
            }
            let ratio = drawn / priced;
            let range = met.entry(component).or_insert([f64::INFINITY, 0.0]);
            *range = [range[0].min(ratio), range[1].max(ratio)];
            if ratio < least - 1e-9 || ratio > most + 1e-9 {
                wrong.push(format!("{name} {}: {ratio} not in {least}..{most} ({why})", component.name()));
            }
        }
    }
    for (component, [least, most]) in &met {
        println!("{:18} {least:.4} to {most:.4}", component.name());
    }
    assert!(wrong.is_empty(), "{} of them: {:#?}", wrong.len(), &wrong[..wrong.len().min(12)]);
    assert_eq!(met.len(), BOUNDS.len(), "every layer has been met");
}

/// Floors are priced inside the lining of the outer walls, over rooms and over the outside, as they are drawn. Level roofs and decks
/// have the same cassette below them and are measured to their edges: drawn, it ends at the lining too.
#[test]
fn floors_are_priced_as_they_are_drawn() {
    let evaluator = evaluator();
    let (mut pitched, mut level, mut jutting) = (0, 0, 0);
    for (name, house, choices) in houses() {
        let measured = Measured::new(&evaluator, &house, &choices);
        let voxels = &house.voxels;
        let empty =
            |[x, y, z]: [usize; 3], up: isize| !voxels.at([x as isize, y as isize, z as isize + up]).is_filled();
        let plateau = voxels.iter().any(|(v, l)| l.is_filled() && !l.is_slab() && empty(v, 1));
        let none = houscaper::voxels::Plan::new([voxels.shape()[0], voxels.shape()[1]]);
        // Roofs and decks over slabs, inside the lining.
        let roofs: f64 = (measured.details.reading.plates.iter().skip(1))
            .map(|plate| {
                let mut rooms = none.clone();
                plate.cells.iter().filter(|[x, y]| !empty([*x, *y, plate.k], 1)).for_each(|c| rooms.set(c, true));
                let net = |open| houscaper::voxels::net_floor_area_m2(&plate.cells, open, &[], 0, &voxels.module);
                net(&rooms)
            })
            .sum();
        for stratum in &evaluator.tiling.shells.floor {
            let thickness = f64::from(stratum.thickness_um) * 1e-6;
            let [drawn, priced] = measured.volumes(stratum.component);
            let floors = (measured.quantity(Item::InnerFloor) + roofs) * thickness;
            let under_pitched = drawn - floors;
            // Level roofs over rooms without a slab are cut off by slopes and walls around them.
            let most = measured.quantity(Item::FlatRoof) * thickness;
            if plateau {
                assert!((-1e-9..=most + 1e-9).contains(&under_pitched), "{name}: {under_pitched} m3");
            } else {
                assert!(close(drawn, floors), "{name} {}: {drawn}, {floors}", stratum.component.name());
            }
            assert!(drawn <= priced * (1.0 + 1e-9), "{name}: {drawn} drawn, {priced} priced");
        }
        pitched += usize::from(plateau);
        level += usize::from(!plateau && roofs > 0.0);
        jutting += usize::from(measured.quantity(Item::Soffit) > 0.0);
    }
    println!("{pitched} houses with roofs on rooms, {level} with level roofs alone, {jutting} with jutting storeys");
    assert!(pitched > 10 && level > 10 && jutting > 5);
}

/// Lengths and areas of edges and openings: the take-off reads what the keys say.
#[test]
fn edges_and_openings_of_the_keys_are_the_items() {
    let evaluator = evaluator();
    let size = [0.9, 0.9, 0.54];
    let mut railings = 0;
    for (name, house, choices) in houses() {
        let measured = Measured::new(&evaluator, &house, &choices);
        let takeoff = measured.details.evaluation.takeoff.as_ref().expect("taken off");
        let reading = &measured.details.reading;
        let survey = evaluator.tiling.survey(&house, reading, &mut Default::default()).expect("tiles");
        assert!(takeoff.window_mismatch_m2().abs() < 1e-9, "{name}: windows by size and by surface");
        assert!(close(survey.windows_m2.iter().sum(), measured.quantity(Item::Window)), "{name}");
        let doors = reading.openings.iter().filter(|o| o.label == Label::Opening);
        let least: f64 = doors.clone().map(|o| o.width as f64 * size[0] * o.height as f64 * size[2]).sum();
        let most: f64 = doors.map(|o| o.width as f64 * size[0] * (o.height as f64 + 0.5) * size[2]).sum();
        let doors_m2: f64 = survey.doors_m2.iter().sum();
        assert!((least - 1e-9..=most + 1e-9).contains(&doors_m2), "{name}: {doors_m2} m2 of doors");
        for (item, edge) in [
            (Item::Overhang, survey.edges.overhang_m2),
            (Item::Gutter, survey.edges.gutter_m),
            (Item::Parapet, survey.edges.parapet_m2),
            (Item::Coping, survey.edges.coping_m),
        ] {
            assert_eq!(measured.quantity(item), edge, "{name}: {}", item.id());
        }
        let around_voids = measured.quantity(Item::Railing) - survey.edges.railing_m;
        assert!(around_voids >= -1e-9, "{name}");
        // A void is railed on all sides but for the width of the arrival: whole cells.
        let cells = around_voids / 0.9;
        assert!((cells - cells.round()).abs() < 1e-6, "{name}: {cells} cells around voids");
        assert_eq!(around_voids > 0.5, !house.stairs.is_empty(), "{name}");
        let decks = walked_border_m(&house, reading);
        assert!(
            close(decks, survey.edges.railing_m),
            "{name}: {decks} m by plan, {} m by keys",
            survey.edges.railing_m
        );
        railings += usize::from(decks > 0.0);
    }
    assert!(railings >= 2, "{railings} houses with a deck that is walked on");
}

/// Border of the walked decks towards the outside, counted on the plan.
fn walked_border_m(house: &House, reading: &houscaper::voxels::Reading) -> f64 {
    let mut length = 0.0;
    for plate in reading.plates.iter().skip(1) {
        let deck = houscaper::score::walked_deck(house, reading, plate);
        for [x, y] in deck.iter() {
            for d in houscaper::voxels::Direction::ALL {
                let [dx, dy] = d.step();
                let at = [x as isize + dx, y as isize + dy];
                let k = plate.k as isize;
                let free = !house.voxels.at([at[0], at[1], k]).is_filled()
                    && !house.voxels.at([at[0], at[1], k + 1]).is_filled();
                length += if free { 0.9 } else { 0.0 };
            }
        }
    }
    length
}

/// The thicknesses that are drawn are those of the build-ups to half a millimetre a stack.
#[test]
fn drawn_thicknesses_are_those_of_the_build_ups() {
    let evaluator = evaluator();
    let Shells { wall, roof, roof_cover, flat, deck, floor, soffit, ground, plinth, .. } = &evaluator.tiling.shells;
    for (item, stacks) in [
        (Item::Wall, vec![wall]),
        (Item::PitchedRoof, vec![roof, roof_cover]),
        (Item::FlatRoof, vec![flat, floor]),
        (Item::Deck, vec![deck, floor]),
        (Item::InnerFloor, vec![floor]),
        (Item::Soffit, vec![soffit]),
        (Item::Ground, vec![ground]),
        (Item::Plinth, vec![plinth]),
    ] {
        let drawn: i32 = stacks.iter().map(|stack| depth_um(stack)).sum();
        let buildup = evaluator.books.buildups.of_item(item.id()).expect("a use");
        let masses = evaluator.books.buildups.stratum_masses(buildup).expect("strata");
        let listed: f64 = masses.iter().map(|s| s.thickness_mm).sum();
        assert!(
            (f64::from(drawn) / 1e3 - listed).abs() <= 0.5 * stacks.len() as f64,
            "{}: {drawn} um, {listed} mm",
            item.id()
        );
    }
}
