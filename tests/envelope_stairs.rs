//! Stairs as solids: steps, disjointness, width, the railing around the opening.

mod blocks;

use blocks::{first_fault, overlap};
use houscaper::envelope::{house_stairs, stair_blocks};
use houscaper::tiles::solids::{Railing, SolidStyle};
use houscaper::tiles::{Block, Component};
use houscaper::voxels::{Direction, House, Reading, Stair, StairKind, read_storeys, samples};

/// A house of two storeys of 10 x 10 modules with one stair in its middle.
fn house(kind: StairKind, run: Direction) -> (House, Reading) {
    let storey: &[samples::Rect] = &[[1, 1, 10, 10]];
    let mut house = samples::massing([12, 12, 14], &[storey, storey], 0);
    // The stair stays inside whichever way it runs.
    let [dx, dy] = run.step();
    let start = [(5 - 2 * dx) as usize, (5 - 2 * dy) as usize];
    samples::add_stair(&mut house, Stair { storey: 0, start, run, kind });
    let reading = read_storeys(&house);
    (house, reading)
}

fn all() -> Vec<(House, Reading)> {
    [StairKind::Straight, StairKind::UTurn]
        .into_iter()
        .flat_map(|kind| Direction::ALL.map(|run| house(kind, run)))
        .collect()
}

fn styles() -> [SolidStyle; 2] {
    let base = SolidStyle::default();
    [base, SolidStyle { railing: Railing::Bars, ..base }]
}

fn bounds(blocks: &[Block], component: Component) -> Vec<[[i32; 2]; 3]> {
    let of = |b: &Block| {
        let span = |v: Vec<i32>| [v.iter().copied().min().unwrap_or(0), v.iter().copied().max().unwrap_or(0)];
        let heights = b.bottom.iter().chain(&b.top).copied().collect();
        [span(b.plan.iter().map(|p| p[0]).collect()), span(b.plan.iter().map(|p| p[1]).collect()), span(heights)]
    };
    blocks.iter().filter(|b| b.component == component).map(of).collect()
}

#[test]
fn stairs_are_valid_and_disjoint() {
    for (house, reading) in all() {
        for style in styles() {
            let stairs = house_stairs(&house, &reading, &style);
            assert_eq!(stairs.len(), 1);
            assert_eq!(first_fault(&stairs[0]), None, "{:?}", house.stairs);
            assert!(stairs[0].len() > 40);
            // A twin that must be seen.
            let mut twice = stairs[0].clone();
            twice.push(stairs[0][3].clone());
            assert!(first_fault(&twice).is_some());
        }
    }
}

#[test]
fn eighteen_risers_of_180_reach_the_floor() {
    for (house, reading) in all() {
        let blocks = stair_blocks(&house, &house.stairs[0], &reading, &SolidStyle::default());
        let landing = usize::from(house.stairs[0].kind == StairKind::UTurn);
        let mut treads = bounds(&blocks, Component::StairTread);
        assert_eq!(treads.len(), 18 + landing);
        treads.retain(|t| (t[0][1] - t[0][0]).min(t[1][1] - t[1][0]) == 300_000);
        let mut tops: Vec<i32> = treads.iter().map(|t| t[2][1]).collect();
        tops.sort_unstable();
        assert_eq!(tops, (1..=18).map(|n| n * 180_000).collect::<Vec<_>>());
        for t in &treads {
            assert!((t[0][1] - t[0][0]).max(t[1][1] - t[1][0]) >= 800_000, "800 mm wide");
        }
    }
}

/// Below the upper floor everything stays in the stair's own cells; above it the railing stands on floor around the opening.
#[test]
fn stairs_keep_to_their_cells() {
    for (house, reading) in all() {
        let stair = &house.stairs[0];
        let own: Vec<_> = stair.flight_cells().into_iter().chain(stair.middle_landing()).collect();
        let cell = |p: [i32; 2]| p.map(|v| (v + 450_000).div_euclid(900_000) as isize);
        for block in stair_blocks(&house, stair, &reading, &SolidStyle::default()) {
            let n = block.plan.len() as i32;
            let middle = cell([0, 1].map(|k| block.plan.iter().map(|p| p[k] / n).sum::<i32>()));
            if block.bottom.iter().all(|&z| z >= 6 * 540_000) && block.component != Component::StairTread {
                let edge = block.plan.iter().all(|p| {
                    own.iter().all(|c| [0, 1].iter().any(|&k| (p[k] - c[k] as i32 * 900_000).abs() > 450_000))
                });
                let hand_rail = own.contains(&middle);
                assert!(edge || hand_rail, "{block:?}");
            } else {
                assert!(own.contains(&middle) || block.component == Component::StairTread, "{block:?}");
            }
        }
    }
}

/// A person can fall from no side of the opening, and can step off the last tread.
#[test]
fn the_opening_is_railed_but_for_the_arrival() {
    for (house, reading) in all() {
        for style in styles() {
            let stair = &house.stairs[0];
            let blocks = stair_blocks(&house, stair, &reading, &style);
            let void = stair.void_cells();
            let (surface, head) = (6 * 540_000, stair.head());
            let mut sides = 0;
            for &cell in &void {
                for out in Direction::ALL {
                    let [dx, dy] = out.step();
                    let beyond = [cell[0] + dx, cell[1] + dy];
                    if void.contains(&beyond) {
                        continue;
                    }
                    // A thin board across the side at 950 mm: the hand rail is in its way unless one arrives there.
                    let at = |k: usize| {
                        let (c, d) = (cell[k] as i32 * 900_000, [dx, dy][k] as i32);
                        [
                            c + d * 450_000 - 300_000 * (1 - d.abs()),
                            c + d * 450_000 + d.abs() * d * 100_000 + 300_000 * (1 - d.abs()),
                        ]
                    };
                    let [x, y] = [at(0), at(1)].map(|s| [s[0].min(s[1]), s[0].max(s[1])]);
                    let probe = |z: i32| Block::cuboid(Component::Glass, 0, [x[0], y[0], z], [x[1], y[1], z + 5_000]);
                    let hit = |z: i32| blocks.iter().any(|b| overlap(b, &probe(surface + z)));
                    let arrives = cell == stair.flight_cells()[5] && beyond == head;
                    assert_eq!(hit(980_000), !arrives, "{:?} {cell:?} {out:?}", stair.kind);
                    assert_eq!(hit(500_000), !arrives);
                    sides += 1;
                }
            }
            assert!(sides >= 12);
        }
    }
}

/// A stair without its upper storey, and one without slab around its opening, are built without what is missing.
#[test]
fn missing_storeys_and_floors_are_left_out() {
    let (house, reading) = house(StairKind::Straight, Direction::East);
    let style = SolidStyle::default();
    let above = Stair { storey: 1, ..house.stairs[0] };
    assert!(stair_blocks(&house, &above, &reading, &style).is_empty());
    let rails = |house: &House| {
        let blocks = stair_blocks(house, &house.stairs[0], &reading, &style);
        blocks.iter().filter(|b| b.component == Component::RailingGlass).count()
    };
    let mut open = house.clone();
    for x in 0..12 {
        open.voxels.set([x, 6, 6], houscaper::voxels::Label::Base);
    }
    assert!(rails(&open) < rails(&house) && rails(&open) > 0);
}
