//! A thousand houses as the search draws them, cut into parts: nothing missing, nothing twice, limits kept, the same count in the mirror.

#[path = "common/drawn.rs"]
mod drawn;
#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;

use drawn::{draw, space};
use houscaper::envelope::{KeyCache, Surface};
use houscaper::parts::{PartKind, Parts, Settings, cut, marks};
use houscaper::voxels::{Choice, Choices, Direction, House, Label, STOREY_MODULES, Stair, VoxelArray, read_storeys};
use rayon::prelude::*;

const HOUSES: u64 = 1_000;

fn parts(house: &House, choices: &Choices) -> Parts {
    cut(house, &read_storeys(house), choices, Settings::default()).expect("a low house")
}

/// Facade half modules above the ground's slab where a full column meets an empty one: every one must be in one wall panel.
fn facade_halves(house: &House) -> BTreeMap<([usize; 2], Direction, usize), usize> {
    let mut halves = BTreeMap::new();
    let v = &house.voxels;
    for (at, label) in v.iter() {
        let [x, y, k] = at.map(|c| c as isize);
        if !label.is_filled() || !v.at([x, y, k + 1]).is_filled() {
            continue;
        }
        for d in Direction::ALL {
            let [dx, dy] = d.step();
            let gone = |k: isize| !v.at([x + dx, y + dy, k]).is_filled();
            if gone(k) && gone(k + 1) {
                let cube = 2 * at[2];
                for half in [cube, cube + 1] {
                    *halves.entry(([at[0], at[1]], d, half)).or_default() += 0;
                }
            }
        }
    }
    halves
}

fn check(house: &House, parts: &Parts) -> Result<(), String> {
    let mut halves = facade_halves(house);
    let mut slabs: BTreeMap<[usize; 3], usize> = BTreeMap::new();
    let mut roofs: BTreeMap<[usize; 3], u32> = BTreeMap::new();
    for p in &parts.parts {
        let cells = parts.cells_of(p);
        let key = |c: &houscaper::parts::PartCell| [c.cell[0] as usize, c.cell[1] as usize, c.k as usize];
        match p.kind {
            PartKind::Wall => {
                let facing = p.facing.ok_or("a wall without direction")?;
                for c in cells {
                    for h in (0..12).filter(|h| c.code >> h & 1 == 1) {
                        let half = 2 * STOREY_MODULES * usize::from(p.level) + h;
                        *halves.entry((c.cell.map(usize::from), facing, half)).or_default() += 1;
                    }
                }
                if p.modules[0] > 13 && parts.openings_of(p).iter().all(|o| o.width < 13) {
                    return Err(format!("a panel of {} modules", p.modules[0]));
                }
                for o in parts.openings_of(p) {
                    if o.from + o.width > p.modules[0] {
                        return Err("an opening reaches over its panel".into());
                    }
                }
            }
            PartKind::Floor | PartKind::Deck => {
                cells.iter().for_each(|c| *slabs.entry(key(c)).or_default() += 1);
                if p.width_mm > 2500.0 || p.length_mm > 12_000.0 {
                    return Err(format!("a cassette of {} x {} mm", p.length_mm, p.width_mm));
                }
                if cells.len() != usize::from(p.modules[0]) * usize::from(p.modules[1]) {
                    return Err("a floor cassette that is no rectangle".into());
                }
            }
            PartKind::Slope | PartKind::Level => {
                for c in cells {
                    let eighths = |q: u32| [0, 2, 1, 1][usize::from(c.code >> (2 * q) & 3)];
                    *roofs.entry(key(c)).or_default() += (0..4).map(eighths).sum::<u32>();
                }
                if p.width_mm > 2500.0 || p.length_mm > 12_000.0 {
                    return Err(format!("a roof cassette of {} x {} mm", p.length_mm, p.width_mm));
                }
            }
            PartKind::Window | PartKind::Door | PartKind::Stair => {}
        }
    }
    if let Some((at, n)) = halves.iter().find(|(_, n)| **n != 1) {
        return Err(format!("facade {at:?} is in {n} panels"));
    }
    for (at, label) in house.voxels.iter() {
        let [x, y, k] = at.map(|c| c as isize);
        let top = label.is_filled() && !house.voxels.at([x, y, k + 1]).is_filled();
        let slab = if label == Label::Floor { 1 } else { 0 };
        if slabs.get(&at).copied().unwrap_or(0) != slab {
            return Err(format!("slab {at:?} is in {:?} cassettes", slabs.get(&at)));
        }
        let roof = if top && !label.is_slab() { 8 } else { 0 };
        if roofs.get(&at).copied().unwrap_or(0) != roof {
            return Err(format!("roof {at:?}: {:?} eighths of {roof}", roofs.get(&at)));
        }
    }
    let openings: usize = parts.parts.iter().map(|p| parts.openings_of(p).len()).sum();
    let pieces = parts.count(PartKind::Window) + parts.count(PartKind::Door);
    if openings != pieces {
        return Err(format!("{openings} openings in panels, {pieces} windows and doors"));
    }
    Ok(())
}

#[test]
fn a_thousand_houses_are_cut_without_gap_or_overlap() {
    let space = space();
    let wrong: Vec<(u64, String)> = (0..HOUSES)
        .into_par_iter()
        .filter_map(|seed| {
            let (house, choices) = draw(&space, seed);
            check(&house, &parts(&house, &choices)).err().map(|e| (seed, e))
        })
        .collect();
    assert!(wrong.is_empty(), "{} of {HOUSES}: {:?}", wrong.len(), &wrong[..wrong.len().min(8)]);
}

#[test]
fn roof_cassettes_are_as_large_as_the_roofs_that_are_drawn() {
    let space = space();
    let tiling = runs::evaluator(&runs::repository().join("configs/starter.json")).tiling;
    let wrong: Vec<String> = (0..HOUSES)
        .into_par_iter()
        .filter_map(|seed| {
            let (house, choices) = draw(&space, seed);
            let cut = parts(&house, &choices);
            let own: f64 = cut.parts.iter().filter(|p| p.kind == PartKind::Slope).map(|p| p.area_m2).sum();
            let survey = tiling.survey(&house, &read_storeys(&house), &mut KeyCache::default()).expect("tiles");
            let drawn = survey.areas.area_m2[Surface::PitchedRoof as usize];
            (own - drawn).abs().gt(&(1e-6 * drawn.max(1.0))).then(|| format!("{seed}: {own} m2 cut, {drawn} m2 drawn"))
        })
        .collect();
    assert!(wrong.is_empty(), "{} of {HOUSES}: {:?}", wrong.len(), &wrong[..wrong.len().min(8)]);
}

#[test]
fn a_missing_cell_is_found() {
    let (house, choices) = draw(&space(), 7);
    let whole = parts(&house, &choices);
    for kind in [PartKind::Wall, PartKind::Floor] {
        let Some(n) = whole.parts.iter().position(|p| p.kind == kind) else { continue };
        let mut broken = whole.clone();
        broken.parts[n].cells[1] -= 1;
        assert!(check(&house, &broken).is_err(), "{kind:?}");
    }
    assert_eq!(check(&house, &whole), Ok(()));
}

/// The house turned by a quarter (x to y) or mirrored in x; joists turn with it.
fn turned(house: &House, choices: &Choices, mirror: bool) -> (House, Choices) {
    let v = &house.voxels;
    let [nx, ny, nz] = v.shape();
    let place = |[x, y]: [isize; 2]| if mirror { [nx as isize - 1 - x, y] } else { [ny as isize - 1 - y, x] };
    let mut out = VoxelArray::new(if mirror { [nx, ny, nz] } else { [ny, nx, nz] });
    for ([x, y, k], label) in v.iter() {
        let [a, b] = place([x as isize, y as isize]).map(|c| c as usize);
        out.set([a, b, k], label);
    }
    let mut next = House::new(out);
    let run = |d: Direction| match (mirror, d) {
        (true, Direction::East) | (true, Direction::West) => d.back(),
        (true, _) => d,
        (false, _) => d.left(),
    };
    for s in &house.stairs {
        let start = place(s.start.map(|c| c as isize)).map(|c| c as usize);
        next.stairs.push(Stair { start, run: run(s.run), ..*s });
    }
    let mut choices = *choices;
    if !mirror {
        choices.0[Choice::Joists as usize] ^= 0x3f;
    }
    (next, choices)
}

#[test]
fn mirror_and_quarter_turn_leave_the_distinct_parts() {
    let space = space();
    let wrong: Vec<String> = (0..HOUSES / 4)
        .into_par_iter()
        .flat_map_iter(|seed| {
            let (house, choices) = draw(&space, seed);
            let count = |(house, choices): &(House, Choices)| {
                let parts = parts(house, choices);
                (parts.distinct(), PartKind::ALL.map(|k| parts.count(k)))
            };
            let own = count(&(house.clone(), choices));
            let others = [("mirror", true), ("turn", false)];
            others
                .into_iter()
                .filter_map(move |(name, mirror)| {
                    let other = count(&turned(&house, &choices, mirror));
                    (own != other).then(|| format!("{seed} {name}: {own:?} {other:?}"))
                })
                .collect::<Vec<_>>()
        })
        .collect();
    assert!(wrong.is_empty(), "{}: {:#?}", wrong.len(), &wrong[..wrong.len().min(8)]);
}

#[test]
fn the_same_house_is_cut_the_same_way_with_marks_of_its_own() {
    let space = space();
    for seed in 0..40 {
        let (house, choices) = draw(&space, seed);
        let (one, two) = (parts(&house, &choices), parts(&house, &choices));
        assert_eq!(one, two);
        let marks = marks(&one);
        let mut pieces = marks.piece.clone();
        pieces.sort();
        pieces.dedup();
        assert_eq!(pieces.len(), one.parts.len(), "every piece has a mark of its own");
        let mut types: Vec<&str> = marks.of_type.iter().map(|t| t.trim_end_matches('m')).collect();
        types.sort_unstable();
        types.dedup();
        assert_eq!(types.len(), one.distinct(), "as many type marks as distinct parts");
    }
}
