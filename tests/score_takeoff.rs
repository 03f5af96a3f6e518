//! The take-off of the sample houses against counts by hand, with the tileset whose surface is the voxels' own boundary.

#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeSet;

use houscaper::analysis::Distribution;
use houscaper::envelope::Surface;
use houscaper::quantities::{Item, OriginKind, Takeoff};
use houscaper::score::{Evaluator, Walked, carried_kg};
use houscaper::search::massing::encode;
use houscaper::search::{from_brief, start::start};
use houscaper::structure::{FREE_FALL_M_S2, analysis_model, load_cases};
use houscaper::voxels::{Choice, Choices, House, Label, VoxelArray, samples};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn evaluator() -> Evaluator {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["tileset"] = "surface-1".into());
    runs::evaluator(&brief)
}

fn takeoff(house: &House) -> Takeoff {
    evaluator().details(house, &Choices::default()).evaluation.takeoff.expect("admissible houses are taken off")
}

fn check(takeoff: &Takeoff, expected: &[(Item, f64)]) {
    let measured = takeoff.measured();
    for (item, value) in expected {
        assert!(
            (measured[*item as usize] - value).abs() < 1e-9,
            "{item:?}: {} is not {value}",
            measured[*item as usize]
        );
    }
}

/// Area of a facade voxel, m2.
const FACE: f64 = 0.9 * 0.54;
/// Plan area of a module, m2.
const CELL: f64 = 0.81;

/// 7 x 6 modules: 26 facade voxels a layer, five layers of wall less 15 of window and 4 of door.
#[test]
fn box_house() {
    check(
        &takeoff(&samples::box_house()),
        &[
            (Item::Plinth, 26.0 * FACE),
            (Item::Band, 26.0 * FACE),
            (Item::Wall, (5.0 * 26.0 - 15.0 - 4.0) * FACE),
            (Item::Window, 15.0 * FACE),
            (Item::Door, 1.0),
            (Item::FlatRoof, 42.0 * CELL),
            (Item::Deck, 0.0),
            (Item::Ground, 42.0 * CELL),
            (Item::PerimeterBeam, 26.0 * 0.9),
            (Item::InnerFloor, 0.0),
            (Item::Stair, 0.0),
            (Item::Railing, 0.0),
        ],
    );
}

/// 8 x 7 modules on two storeys, a u-turn stair with a void of 4 x 2 cells whose last step opens onto one lane. Two plates have
/// the house above and below: the floor of the upper storey, and its ceiling under the roof space.
#[test]
fn hip_house_inside() {
    check(
        &takeoff(&samples::hip_house()),
        &[
            (Item::Plinth, 30.0 * FACE),
            // Windows: 2 x 4 + 3 x 3 + 3 x 3 + 2 x 3 voxels; a door of four.
            (Item::Window, 32.0 * FACE),
            (Item::Door, 1.0),
            (Item::Ground, 56.0 * CELL),
            (Item::PerimeterBeam, 30.0 * 0.9),
            (Item::InnerFloor, 2.0 * (7.2 - 0.6) * (6.3 - 0.6) - 8.0 * CELL),
            (Item::Stair, 1.0),
            (Item::Railing, 12.0 * 0.9 - 0.9),
        ],
    );
}

/// A deck of 3 x 7 cells with railing on its three free sides, and a straight stair.
#[test]
fn deck_house_outside() {
    let house = samples::deck_house();
    let void = house.stairs[0].void_cells().len() as f64;
    assert!(void >= 5.0, "a void over at least five runs");
    check(
        &takeoff(&house),
        &[
            (Item::Deck, 21.0 * CELL),
            (Item::FlatRoof, 63.0 * CELL),
            (Item::Ground, 84.0 * CELL),
            (Item::PerimeterBeam, 38.0 * 0.9),
            (Item::InnerFloor, (8.1 - 0.6) * (6.3 - 0.6) - void * CELL),
            (Item::Door, 2.0),
            (Item::Stair, 1.0),
            (Item::Railing, 13.0 * 0.9 + (2.0 * (void + 1.0) - 1.0) * 0.9),
        ],
    );
}

/// The deck without its door is a roof: no decking, no railing around it.
#[test]
fn a_deck_without_a_door_is_a_roof() {
    let mut house = samples::deck_house();
    for k in 7..11 {
        house.voxels.set([9, 5, k], houscaper::voxels::Label::Base);
    }
    let void = house.stairs[0].void_cells().len() as f64;
    check(
        &takeoff(&house),
        &[
            (Item::Deck, 0.0),
            (Item::FlatRoof, 84.0 * CELL),
            (Item::Door, 1.0),
            (Item::Railing, (2.0 * (void + 1.0) - 1.0) * 0.9),
        ],
    );
}

/// Whatever the shape: windows by count equal windows by surface, and sheltered facade equals what the voxels show.
#[test]
fn facades_equal_the_voxels_own_boundary() {
    for (name, house) in samples::all() {
        let takeoff = takeoff(&house);
        assert!(takeoff.window_mismatch_m2().abs() < 1e-9, "{name}");
        let voxels = &house.voxels;
        let [nx, ny, nz] = voxels.shape();
        let mut sides = 0;
        for cell in (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z]))) {
            let at = |dx: isize, dy: isize| voxels.at([cell[0] as isize + dx, cell[1] as isize + dy, cell[2] as isize]);
            if voxels.get(cell).is_filled() {
                sides += [(1, 0), (-1, 0), (0, 1), (0, -1)].iter().filter(|(x, y)| !at(*x, *y).is_filled()).count();
            }
        }
        use houscaper::envelope::Surface;
        let upright = [Surface::Wall, Surface::Band, Surface::Plinth, Surface::Window, Surface::Door];
        let found: f64 = upright.iter().map(|s| takeoff.area_m2()[*s as usize]).sum();
        let pitched = takeoff.area_m2()[Surface::PitchedRoof as usize];
        // Steps of a stepped roof are roof, not wall, also where they stand upright.
        let expected = sides as f64 * FACE;
        assert!(found <= expected + 1e-9 && found + pitched >= expected - 1e-9, "{name}: {found} of {expected}");
    }
}

/// Starts of the search under the starter brief, as random houses.
fn random(evaluator: &Evaluator, count: u64) -> Vec<(String, House, Choices)> {
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("a space");
    let draw = |seed| {
        let design = start(&space, &mut ChaCha8Rng::seed_from_u64(seed)).expect("a house");
        (format!("start {seed}"), encode(&design.massing, &space.plot), design.choices)
    };
    (0..count).map(draw).collect()
}

/// The samples with the first options and boards on both sides, and random houses.
fn houses(evaluator: &Evaluator, count: u64) -> Vec<(String, House, Choices)> {
    let mut both = Choices::default();
    both.0[Choice::Boards as usize] = 1;
    let sample = |(name, house): (&str, House)| {
        let boarded = (format!("{name}, boards on both sides"), house.clone(), both);
        [(name.to_owned(), house, Choices::default()), boarded]
    };
    let mut all: Vec<_> = samples::all().into_iter().flat_map(sample).collect();
    all.extend(random(evaluator, count));
    all
}

fn starter() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

/// Origins sum to their row, none is there twice, and every tile with area, every opening, stair and member is there once.
fn check_origins(name: &str, evaluator: &Evaluator, house: &House, choices: &Choices) {
    let details = evaluator.details(house, choices);
    let takeoff = details.evaluation.takeoff.expect("a take-off");
    let rows = evaluator.origins(house, choices, &details).expect("origins");
    assert_eq!(rows.len(), takeoff.lines(&|_| String::new()).len());
    let mut seen = BTreeSet::new();
    for row in &rows {
        let size = row.origins.iter().map(|o| o.quantity.abs()).sum::<f64>().max(1.0);
        assert!(row.difference().abs() <= 1e-9 * size, "{name}: {} differs by {}", row.description, row.difference());
        for origin in &row.origins {
            // A member has one row; a tile one for each surface.
            let item = (origin.kind != OriginKind::Member).then_some(row.item);
            assert!(seen.insert((item, origin.kind, origin.id.clone())), "{name}: {origin:?} twice");
        }
    }
    let of = |kind: OriginKind| rows.iter().flat_map(|r| &r.origins).filter(move |o| o.kind == kind);
    let frame = details.frame.as_ref().expect("a frame");
    assert_eq!(of(OriginKind::Member).count(), frame.members.len(), "{name}");
    let stairs = rows.iter().filter(|r| r.item == Item::Stair).flat_map(|r| &r.origins).count();
    assert_eq!(stairs, house.stairs.len());
    assert_eq!(of(OriginKind::Opening).count(), details.reading.openings.len(), "{name}");
    // Tiles, by another way: the cubes whose own surface has area, openings aside.
    let walked = Walked::new(house, &details.reading);
    let (mut tiles, mut area) = (BTreeSet::new(), 0.0);
    evaluator.tiling.skin.by_cube(
        &house.voxels,
        |v| walked.has(v),
        |cube, pieces, _| {
            let own = pieces.iter().filter(|p| !matches!(p.surface, Surface::Window | Surface::Door));
            let sum: f64 = own.map(|p| p.area_m2).sum();
            area += pieces.iter().map(|p| p.area_m2).sum::<f64>();
            if sum > 0.0 {
                tiles.insert(cube.map(|n| n.to_string()).join(","));
            }
        },
    );
    let found: BTreeSet<String> = of(OriginKind::Tile).map(|o| o.id.clone()).collect();
    assert_eq!(found, tiles, "{name}");
    let whole: f64 = details.areas.expect("a skin").area_m2.iter().sum();
    assert!((area / whole - 1.0).abs() < 1e-9, "{name}: tiles {area} of {whole} m2");
}

#[test]
fn every_row_names_its_origins() {
    let (solids, surfaces) = (starter(), evaluator());
    for (name, house, choices) in houses(&solids, 50) {
        check_origins(&name, &solids, &house, &choices);
    }
    for (name, house) in samples::all() {
        check_origins(name, &surfaces, &house, &Choices::default());
    }
}

/// Mass by the analysis: every element's own, as the solver applies it, and the soles, which lie on the foundation and are no elements.
#[test]
fn the_mass_taken_off_is_the_mass_applied() {
    let evaluator = starter();
    for (name, house, choices) in houses(&evaluator, 50) {
        let details = evaluator.details(&house, &choices);
        let frame = details.frame.as_ref().expect("a frame");
        let sections = evaluator.sections(&choices);
        let model = analysis_model(frame, &evaluator.catalogue, &sections);
        let length = |m: &houscaper::analysis::Member| {
            let [a, b] = m.nodes.map(|n| model.nodes[n]);
            (0..3).map(|x| (a[x] - b[x]).powi(2)).sum::<f64>().sqrt()
        };
        let of = |m: &houscaper::analysis::Member| model.materials[m.material].rho * model.sections[m.section].a;
        let applied: f64 = model.members.iter().map(|m| of(m) * length(m)).sum();
        let per_m =
            |g: usize| evaluator.catalogue.material(sections[g]).rho * evaluator.catalogue.section(sections[g]).a;
        let soles = frame.members.iter().filter(|m| m.element_count() == 0);
        let lying: f64 = soles.map(|m| m.length_m * f64::from(m.plies) * per_m(m.group as usize)).sum();
        let takeoff = details.evaluation.takeoff.as_ref().expect("a take-off");
        let taken: f64 = takeoff.frame().iter().map(|row| row.mass_kg).sum();
        assert!(
            ((applied + lying) / taken - 1.0).abs() < 1e-9,
            "{name}: {applied} + {lying} kg applied, {taken} kg taken off"
        );
        let billed: f64 = Item::ALL.iter().filter(|i| i.is_frame()).map(|i| takeoff.measured()[*i as usize]).sum();
        assert!((billed / taken - 1.0).abs() < 1e-12, "{name}");
        // The solver's own gravity case: the weight of the elements over g.
        let mut cases = Vec::new();
        load_cases(frame, &evaluator.loads, &mut cases);
        let permanent = cases.iter().find(|c| c.name == "permanent").expect("a case");
        assert_eq!(permanent.gravity, [0.0, 0.0, -FREE_FALL_M_S2]);
        let layers: f64 = permanent
            .members
            .iter()
            .map(|l| {
                let Distribution::Uniform { q } = l.distribution else { panic!("uniform") };
                -q[2] * length(&model.members[l.member]) / FREE_FALL_M_S2
            })
            .sum();
        // Everything above the foundation: the take-off's mass less frame, foundation, decks on it and the feet of stairs on it.
        let measured = takeoff.measured();
        let kg = |item: Item| measured[item as usize] * evaluator.rates.rows[item as usize].mass_kg;
        let whole = details.evaluation.cost.as_ref().expect("priced").mass_kg;
        let foundation: f64 = [Item::Plinth, Item::Ground, Item::PerimeterBeam].into_iter().map(kg).sum();
        let [nx, ny, _] = house.voxels.shape();
        let open = |x: usize, y: usize| {
            house.voxels.get([x, y, 0]) == Label::Foundation && house.voxels.get([x, y, 1]) == Label::Empty
        };
        let decks = (0..nx).flat_map(|x| (0..ny).map(move |y| (x, y))).filter(|&(x, y)| open(x, y)).count();
        let decks = (decks as f64 * 0.81).min(measured[Item::FlatRoof as usize]);
        let on_ground = decks * evaluator.rates.rows[Item::FlatRoof as usize].mass_kg;
        let feet = house.stairs.iter().filter(|s| s.storey == 0).count() as f64;
        let feet = if house.stairs.is_empty() { 0.0 } else { 0.5 * kg(Item::Stair) * feet / house.stairs.len() as f64 };
        let by_hand = whole - taken - foundation - on_ground - feet;
        assert!((layers / by_hand - 1.0).abs() < 1e-9, "{name}: {layers} kg of layers applied, {by_hand} kg by hand");
        let carried: f64 = carried_kg(&house, takeoff, &evaluator.rates).iter().sum();
        assert!((carried / by_hand - 1.0).abs() < 1e-9, "{name}");
        let vertical = details.evaluation.assessment.as_ref().expect("assessed").vertical_n[0];
        assert!(vertical.is_finite() && vertical > (applied + layers) * FREE_FALL_M_S2 * (1.0 - 1e-9), "{name}");
    }
}

/// South: a window of 3 x 3 modules and a door of 1 x 4; east: one of 2 x 3. U A by hand from the same areas.
#[test]
fn openings_keep_their_direction() {
    let evaluator = evaluator();
    let house = samples::box_house();
    let details = evaluator.details(&house, &Choices::default());
    let heat = evaluator.heat_loss(&house, &details).expect("a heat loss");
    let u = |item: Item| evaluator.rates.rows[item as usize].u_w_m2k;
    let expected = [("north", 0.0, 0.0), ("east", 6.0, 0.0), ("south", 9.0, 4.0), ("west", 0.0, 0.0)];
    for (found, (facing, windows, doors)) in heat.openings.iter().zip(expected) {
        assert_eq!(found.facing, facing);
        assert!((found.windows_m2 - windows * FACE).abs() < 1e-9 && (found.doors_m2 - doors * FACE).abs() < 1e-9);
        let loss = (windows * u(Item::Window) + doors * u(Item::Door)) * FACE;
        assert!((found.w_per_k - loss).abs() < 1e-9, "{facing}");
    }
    let wall = heat.elements.iter().find(|e| e.item == "wall").expect("walls");
    assert!((wall.w_per_k - (5.0 * 26.0 - 15.0 - 4.0) * FACE * u(Item::Wall)).abs() < 1e-9);
    let all: f64 = heat.elements.iter().map(|e| e.w_per_k).sum();
    let cost = details.evaluation.cost.expect("a cost");
    assert!((all - cost.heat_loss_w_per_k).abs() < 1e-9 && (heat.w_per_k - all).abs() < 1e-9);
}

/// A quarter turn to the left takes north to west, east to north, south to east, west to south; elements stay as they are.
#[test]
fn a_quarter_turn_permutes_the_directions() {
    for evaluator in [evaluator(), starter()] {
        for (name, house) in samples::all() {
            let [nx, ny, nz] = house.voxels.shape();
            let mut turned = House::new(VoxelArray::new([ny, nx, nz]));
            for cell in (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z]))) {
                turned.voxels.set([ny - 1 - cell[1], cell[0], cell[2]], house.voxels.get(cell));
            }
            // Stairs are inside and no part of the skin.
            let heat = |house: &House| {
                let details = evaluator.details(house, &Choices::default());
                evaluator.heat_loss(house, &details).expect("a heat loss")
            };
            let (before, after) = (heat(&House { stairs: Vec::new(), ..house.clone() }), heat(&turned));
            for (from, to) in [(0, 3), (1, 0), (2, 1), (3, 2)] {
                let [a, b] = [&before.openings[from], &after.openings[to]];
                assert!((a.windows_m2 - b.windows_m2).abs() < 1e-9 && (a.doors_m2 - b.doors_m2).abs() < 1e-9, "{name}");
                assert!((a.w_per_k - b.w_per_k).abs() < 1e-9, "{name}: {} to {}", a.facing, b.facing);
            }
            assert!(before.openings.iter().map(|o| o.windows_m2).sum::<f64>() > 5.0, "{name} has windows");
            for (a, b) in before.elements.iter().zip(&after.elements) {
                assert!(a.item == b.item && (a.w_per_k - b.w_per_k).abs() < 1e-6, "{name}: {}", a.item);
            }
        }
    }
}
