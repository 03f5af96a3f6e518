//! The sample houses cut into parts, against counts by hand; every voxel of the shell in one part; masses against the take-off.

#[path = "common/runs.rs"]
mod runs;

use houscaper::parts::{Part, PartKind, Parts, STOCK_LENGTH_M, Settings, cut, marks, masses, overloads, stock};
use houscaper::quantities::Item;
use houscaper::score::Evaluator;
use houscaper::tiles::Component;
use houscaper::voxels::{Choices, Direction, House, Label, read_storeys, samples};

fn parts(house: &House) -> Parts {
    cut(house, &read_storeys(house), &Choices::default(), Settings::default()).expect("a low house")
}

fn of(parts: &Parts, kind: PartKind) -> Vec<&Part> {
    parts.parts.iter().filter(|p| p.kind == kind).collect()
}

fn evaluator() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

fn rounded(values: [f64; 2]) -> [i64; 2] {
    values.map(|v| v.round() as i64)
}

/// 7 x 6 modules, one storey with a flat roof of slab; joists along x. By hand:
///
/// walls, storey-high (12 half modules = 3,240 mm), one a side; the longer ones run through, the others are 300 mm short at both ends:
///   south and north 7 x 900 = 6,300 mm, east and west 6 x 900 - 2 x 300 = 4,800 mm;
///   south: a door at module 1 on the slab and a window of three at module 3; east: a window of two at module 2;
/// deck cassettes: 6 rows of 7 cells, strips of two rows: three of 6,300 x 1,800 mm;
/// a window 2,700 x 1,620, a window 1,800 x 1,620, a door 900 x 2,430 (four modules
/// of voxels and the half module down to the slab).
#[test]
fn box_house_by_hand() {
    let parts = parts(&samples::box_house());
    let walls: Vec<_> = of(&parts, PartKind::Wall)
        .iter()
        .map(|w| {
            (w.facing.expect("walls face somewhere"), rounded([w.length_mm, w.height_mm]), parts.openings_of(w).len())
        })
        .collect();
    let expected = [
        (Direction::East, [4800, 3240], 1),
        (Direction::North, [6300, 3240], 0),
        (Direction::West, [4800, 3240], 0),
        (Direction::South, [6300, 3240], 2),
    ];
    assert_eq!(walls, expected);
    let south = of(&parts, PartKind::Wall)[3];
    let openings: Vec<_> =
        parts.openings_of(south).iter().map(|o| (o.label, o.from, o.width, o.sill, o.height)).collect();
    assert_eq!(openings, [(Label::Opening, 1, 1, 0, 4), (Label::Window, 3, 3, 3, 3)]);
    assert!((south.area_m2 - (6.3 * 3.24 - 0.9 * 2.43 - 2.7 * 1.62)).abs() < 1e-9);

    let decks: Vec<_> = of(&parts, PartKind::Deck).iter().map(|d| rounded([d.length_mm, d.width_mm])).collect();
    assert_eq!(decks, [[6300, 1800]; 3]);
    assert!(of(&parts, PartKind::Floor).is_empty() && of(&parts, PartKind::Slope).is_empty());
    let windows: Vec<_> = of(&parts, PartKind::Window).iter().map(|w| rounded([w.length_mm, w.height_mm])).collect();
    assert_eq!(windows.len(), 2);
    assert!(windows.contains(&[2700, 1620]) && windows.contains(&[1800, 1620]));
    assert_eq!(
        rounded([of(&parts, PartKind::Door)[0].length_mm, of(&parts, PartKind::Door)[0].height_mm]),
        [900, 2430]
    );
    // Four different walls, one kind of deck cassette, two windows, a door.
    assert_eq!((parts.parts.len(), parts.distinct()), (4 + 3 + 3, 4 + 1 + 3));
    let marks = marks(&parts);
    assert_eq!(marks.piece[..4], ["W0-E01", "W0-N01", "W0-W01", "W0-S01"]);
    assert_eq!(marks.of_type[4..7], ["DC-01"; 3]);
    assert_eq!(marks.count[4], 3);
}

/// 8 x 7 modules, two storeys, a hip of three layers; joists along x, a stair void of 4 x 2 cells at x 3..6, y 3..4.
///
/// Walls: four a storey, and four knee walls of one module under the eaves: half modules [0, 2) of level 2.
/// Floor of plate 1, rows y 1..7: rows 1+2 whole (8 cells), rows 3+4 left and right of the void (2 and 2 cells), rows 5+6 whole,
/// row 7 whole: five cassettes, the same without the void on plate 2: four.
/// Hip: the ring at k = 13 falls outwards, k = 14 and 15 above; south and north planes are trapezia, east and west ones too.
#[test]
fn hip_house_by_hand() {
    let parts = parts(&samples::hip_house());
    let by_level = |kind: PartKind, level: u16| of(&parts, kind).into_iter().filter(|p| p.level == level).count();
    assert_eq!([0, 1, 2].map(|l| by_level(PartKind::Wall, l)), [4, 4, 4]);
    for knee in of(&parts, PartKind::Wall).into_iter().filter(|p| p.level == 2) {
        assert_eq!(knee.modules[1], 2, "knee walls are one module high");
    }
    assert_eq!([1, 2].map(|l| by_level(PartKind::Floor, l)), [5, 4]);
    let slopes = of(&parts, PartKind::Slope);
    for d in Direction::ALL {
        assert!(slopes.iter().any(|s| s.facing == Some(d)), "the hip falls to {d:?}");
    }
    assert_eq!(of(&parts, PartKind::Stair).len(), 1);
    // Slopes and plateau cover the plan: plan area = 56 cells.
    let secant = (1.0f64 + 0.36).sqrt();
    let plan: f64 = slopes.iter().map(|s| s.area_m2 / secant).sum::<f64>()
        + of(&parts, PartKind::Level).iter().map(|l| l.area_m2).sum::<f64>();
    assert!((plan - 56.0 * 0.81).abs() < 1e-9, "{plan}");
}

#[test]
fn every_voxel_of_the_shell_is_in_one_part() {
    for (name, house) in samples::all() {
        let parts = parts(&house);
        let [nx, ny, nz] = house.voxels.shape();
        let at = |x: usize, y: usize, k: usize, d: [isize; 2], up: isize| {
            house.voxels.at([x as isize + d[0], y as isize + d[1], k as isize + up])
        };
        let centre = |v: [usize; 3], off: [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|a| parts.origin_m[a] + (v[a] as f64 + off[a]) * parts.module_m[a])
        };
        let mut facades = 0;
        for (k, (y, x)) in (1..nz).flat_map(|k| (0..ny).flat_map(move |y| (0..nx).map(move |x| (k, (y, x))))) {
            if !house.voxels.get([x, y, k]).is_filled() {
                continue;
            }
            let voxel = [x, y, k];
            let below_roof = at(x, y, k, [0, 0], 1).is_filled();
            for d in Direction::ALL {
                let step = d.step();
                // A roof that goes on one voxel lower shows no wall.
                let near = at(x, y, k, step, -1);
                let goes_on = !below_roof && near.is_filled() && !near.is_slab() && !house.voxels.get(voxel).is_slab();
                if at(x, y, k, step, 0).is_filled() || goes_on {
                    continue;
                }
                facades += 1;
                // The lower half of the voxel, in the middle of its facade, 100 mm deep; and the upper half below a room.
                let out = [step[0] as f64 * 0.39, step[1] as f64 * 0.39];
                for up in [-0.25, 0.25].into_iter().filter(|u| *u < 0.0 || below_roof) {
                    let id = parts.of(voxel, Component::Cladding, centre(voxel, [out[0], out[1], up]));
                    let part = id.and_then(|id| parts.get(id)).unwrap_or_else(|| panic!("{name} {voxel:?} {d:?} {up}"));
                    assert_eq!((part.kind, part.facing), (PartKind::Wall, Some(d)), "{name} {voxel:?}");
                }
            }
            if house.voxels.get(voxel).is_slab() {
                let id = parts.of(voxel, Component::FloorStructure, centre(voxel, [0.0; 3]));
                assert!(id.is_some(), "{name} slab {voxel:?}");
                let holding = parts.parts.iter().filter(|p| matches!(p.kind, PartKind::Floor | PartKind::Deck));
                let count = holding
                    .flat_map(|p| parts.cells_of(p))
                    .filter(|c| c.cell.map(usize::from) == [x, y] && usize::from(c.k) == k)
                    .count();
                assert_eq!(count, 1, "{name} slab {voxel:?}");
            } else if !below_roof {
                for quarter in [[-0.2, -0.1], [0.2, -0.1], [-0.1, 0.2], [0.2, 0.1]] {
                    let id = parts.of(voxel, Component::RoofInsulation, centre(voxel, [quarter[0], quarter[1], 0.2]));
                    let kind = id.and_then(|id| parts.get(id)).map(|p| p.kind);
                    assert!(matches!(kind, Some(PartKind::Slope | PartKind::Level)), "{name} roof {voxel:?} {kind:?}");
                }
            }
        }
        assert!(facades > 100, "{name}");
        assert_eq!(parts.of([1, 1, 0], Component::GroundSlab, centre([1, 1, 0], [0.0; 3])), None, "site work");
    }
}

/// In the squares of corners the facades along x, which are longer here, run through.
#[test]
fn corners_belong_to_the_panel_that_runs_through() {
    let parts = parts(&samples::l_house());
    assert_eq!(parts.through_axis, 0);
    let facing = |v: [usize; 3], mm: [f64; 2]| {
        let c = [0, 1, 2].map(|a| {
            let off = if a < 2 { mm[a] / 1000.0 } else { 0.1 };
            parts.origin_m[a] + v[a] as f64 * parts.module_m[a] + off
        });
        parts.of(v, Component::Cladding, c).and_then(|id| parts.get(id)).and_then(|p| p.facing)
    };
    // South-west corner at cell (1, 1), south-east corner at cell (9, 1).
    assert_eq!(facing([1, 1, 3], [-435.0, -300.0]), Some(Direction::South));
    assert_eq!(facing([1, 1, 3], [-435.0, 200.0]), Some(Direction::West));
    assert_eq!(facing([9, 1, 3], [300.0, -435.0]), Some(Direction::South));
    // Inner corner at cell (4, 4): open diagonally to the north-east. The east wall of the north wing stands on (4, 5..), the north
    // wall of the east wing on (5.., 4), which reaches into the corner.
    assert_eq!(facing([4, 4, 3], [400.0, 400.0]), Some(Direction::North));
    let wall = |first: [u16; 2], d: Direction| {
        let found = of(&parts, PartKind::Wall).into_iter().find(|p| p.first == first && p.facing == Some(d));
        found.expect("a wall of each wing").length_mm.round() as i64
    };
    // Five modules either way: longer by the inner corner; shorter by the outer one.
    assert_eq!(wall([5, 4], Direction::North), 4500 + 300);
    assert_eq!(wall([4, 5], Direction::East), 4500 - 300);
}

/// Whatever is marked as one type is one size; a panel and its mirror image too.
#[test]
fn parts_of_one_type_are_of_one_size() {
    for (name, house) in samples::all().into_iter().chain(samples::gallery()) {
        let parts = parts(&house);
        let marks = marks(&parts);
        let mut sizes = std::collections::BTreeMap::new();
        for (part, mark) in parts.parts.iter().zip(&marks.of_type) {
            let size = [part.length_mm, part.width_mm, part.height_mm, part.area_m2 * 1e6].map(|v| (v * 10.0).round());
            let known = *sizes.entry(mark.trim_end_matches('m').to_owned()).or_insert(size);
            assert_eq!(known, size, "{name}: {mark}");
        }
        assert_eq!(sizes.len(), parts.distinct(), "{name}");
    }
}

/// Windows as large as the bill says, French ones down to their slab.
#[test]
fn windows_are_as_large_as_those_billed() {
    let evaluator = evaluator();
    for (name, house) in samples::all().into_iter().chain(samples::gallery()) {
        let parts = parts(&house);
        let takeoff = evaluator.details(&house, &Choices::default()).evaluation.takeoff.expect("taken off");
        let measured = takeoff.measured();
        let windows: f64 = of(&parts, PartKind::Window).iter().map(|w| w.area_m2).sum();
        assert!((windows - measured[Item::Window as usize]).abs() < 1e-9, "{name}: {windows} m2 of windows");
    }
}

#[test]
fn masses_sum_to_the_takeoff() {
    let evaluator = evaluator();
    for (name, house) in samples::all() {
        let details = evaluator.details(&house, &Choices::default());
        let takeoff = details.evaluation.takeoff.as_ref().expect("samples are taken off");
        let parts = parts(&house);
        let assessment = details.evaluation.assessment.as_ref().expect("samples are assessed");
        let per_m = std::array::from_fn(|g| match assessment.group_length_m[g] {
            length if length > 0.0 => assessment.group_mass_kg[g] / length,
            _ => 0.0,
        });
        let frame = details.frame.as_ref().expect("samples stand");
        let shared = masses(&parts, takeoff, &evaluator.rates, Some((frame, per_m)));
        let measured = takeoff.measured();
        let whole: f64 =
            Item::ALL.iter().map(|&i| measured[i as usize] * evaluator.rates.rows[i as usize].mass_kg).sum();
        assert!((shared.total_kg() - whole).abs() <= 1e-9 * whole, "{name}: {} is not {whole}", shared.total_kg());
        let members: f64 = shared.frame_kg.iter().sum::<f64>() + shared.loose_frame_kg;
        assert!((members - assessment.frame_mass_kg).abs() <= 1e-9 * members, "{name}: {members} kg of members");
        assert!(shared.loose_frame_kg <= 0.1 * members, "{name}: {} kg in no part", shared.loose_frame_kg);
        let light = masses(&parts, takeoff, &evaluator.rates, None);
        assert_eq!(light.site_kg, shared.site_kg, "{name}");
        assert!(shared.site_kg > 0.0, "{name}: a foundation weighs something");
        // Every panel has studs.
        let bare = parts.parts.iter().zip(&shared.frame_kg).find(|(p, kg)| p.kind == PartKind::Wall && **kg <= 0.0);
        assert!(bare.is_none(), "{name}: {bare:?}");
        assert!(shared.part_kg.iter().all(|kg| *kg > 0.0), "{name}");
        // The parts' own areas are near the envelope's: shares, not inventions.
        let own: f64 = of(&parts, PartKind::Wall).iter().map(|p| p.area_m2).sum();
        let walls = measured[Item::Wall as usize] + measured[Item::Band as usize];
        assert!((own / walls - 1.0).abs() < 0.2, "{name}: {own} and {walls}");
    }
}

#[test]
fn roof_cassettes_cover_exactly_the_roofs_that_are_drawn() {
    let evaluator = evaluator();
    let houses: Vec<(&str, House)> = samples::all().into_iter().chain(samples::gallery()).collect();
    for (name, house) in &houses {
        let parts = parts(house);
        let takeoff = evaluator.details(house, &Choices::default()).evaluation.takeoff.expect("taken off");
        let measured = takeoff.measured();
        let own: f64 = of(&parts, PartKind::Slope).iter().map(|p| p.area_m2).sum();
        let drawn = measured[Item::PitchedRoof as usize];
        // Where a valley runs out under a verge an eighth of a cell may fall along both axes: steeper than the plane that it is cut with.
        let eighth = 0.125 * 0.81 * ((1.0f64 + 2.0 * 0.36).sqrt() - (1.0f64 + 0.36).sqrt());
        let steep = (drawn - own) / eighth;
        assert!((steep - steep.round()).abs() < 1e-4, "{name}: slopes of {own} m2, {drawn} m2 drawn");
        let most = if *name == "l_gable" { 2.0 } else { 0.0 };
        assert!((0.0..=most).contains(&steep.round()), "{name}: slopes of {own} m2, {drawn} m2 drawn");
    }
    assert!(houses.len() > 6);
}

#[test]
fn what_is_too_large_is_named() {
    let evaluator = evaluator();
    let house = samples::box_house();
    let takeoff = evaluator.details(&house, &Choices::default()).evaluation.takeoff.expect("taken off");
    let parts = parts(&house);
    let shared = masses(&parts, &takeoff, &evaluator.rates, None);
    assert!(overloads(&parts, &shared, Settings::default()).is_empty());
    let strict = Settings { longest_m: 5.5, ..Settings::default() };
    let found = overloads(&parts, &shared, strict);
    // North and south wall and three decks are longer than 5.5 m.
    assert_eq!(found.iter().filter(|o| o.what == "length_m").count(), 5);
    // Cut by the stricter limit, nothing is too long any more.
    let shorter = cut(&house, &read_storeys(&house), &Choices::default(), strict).expect("a low house");
    let shared = masses(&shorter, &takeoff, &evaluator.rates, None);
    assert!(overloads(&shorter, &shared, strict).is_empty());
}

#[test]
fn stock_is_the_frame_cut_to_length() {
    let evaluator = evaluator();
    for (name, house) in samples::all() {
        let frame = evaluator.details(&house, &Choices::default()).frame.expect("samples stand");
        let stock = stock(&frame, STOCK_LENGTH_M);
        let whole: f64 = frame.length_by_group_m().iter().sum();
        assert!((stock.length_m - whole).abs() < 1e-6, "{name}: {} of {whole} m", stock.length_m);
        assert!(stock.pieces.iter().all(|p| p.length_mm > 0 && f64::from(p.length_mm) <= STOCK_LENGTH_M * 1000.0));
        let bars: u32 = stock.bars.iter().sum();
        assert!(f64::from(bars) * STOCK_LENGTH_M >= whole && f64::from(bars) * STOCK_LENGTH_M < 1.5 * whole, "{name}");
    }
}

#[test]
fn every_block_that_is_no_site_work_is_in_a_part() {
    let evaluator = evaluator();
    let site = [
        Component::Paving,
        Component::GroundSlab,
        Component::GroundInsulation,
        Component::PerimeterBeam,
        Component::PlinthInsulation,
        Component::PlinthRender,
    ];
    let mut lost: std::collections::BTreeMap<String, usize> = Default::default();
    for (name, house) in samples::all().into_iter().chain(samples::gallery()) {
        let parts = parts(&house);
        let fabric = evaluator.tiling.fabric(&house, &read_storeys(&house)).expect("a style");
        for placed in &fabric.placed {
            let voxel = placed.voxel.map(|c| usize::try_from(c).expect("inside the array"));
            let part = parts.of(voxel, placed.component, fabric.centre_m(placed));
            assert!(part.is_none() || !site.contains(&placed.component), "{name}: {:?} in a part", placed.component);
            if part.is_none() && !site.contains(&placed.component) {
                *lost.entry(format!("{name} {} {voxel:?}", placed.component.name())).or_default() += 1;
            }
        }
    }
    assert!(lost.is_empty(), "{lost:?}");
}
