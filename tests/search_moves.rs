//! Properties of the genome and its moves: over thousands of random moves every encoded house keeps what it promises.

use houscaper::search::cells::Cells;
use houscaper::search::crossover::crossover;
use houscaper::search::identity::identity;
use houscaper::search::massing::{Design, encode};
use houscaper::search::moves::Move;
use houscaper::search::plot::{ChoiceSpace, Plot, PlotError, Programme, Space};
use houscaper::search::settle::{floor_area_m2, settle};
use houscaper::search::start::start;
use houscaper::voxels::{Direction, House, Label, Plan, VoxelArray, rules};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn choices() -> ChoiceSpace {
    ChoiceSpace { options: [6, 6, 4, 5, 4, 2] }
}

fn starter() -> Space {
    let programme = Programme { floor_area_m2: [40.0, 90.0], ..Programme::default() };
    Space::new(Plot::new([10, 8, 16], None).expect("plot"), programme, choices()).expect("space")
}

fn larger() -> Space {
    let programme =
        Programme { floor_area_m2: [90.0, 220.0], storeys: [2, 3], entrances_min: 2, ..Programme::default() };
    Space::new(Plot::new([16, 14, 23], None).expect("plot"), programme, choices()).expect("space")
}

/// Three zones as blocks of 4 x 4 x 6 modules: two apart on the ground, one above them that hangs over nothing.
fn given() -> Space {
    let size = [16, 14];
    let block = |x: isize, y: isize| Cells::rect(size, [x, y], [4, 4]);
    let ground = block(1, 1).or(&block(9, 5)).to_plan();
    let upper = block(5, 5).to_plan();
    let court = Cells::rect(size, [0, 10], [3, 4]).to_plan();
    let mut zones = vec![-1; 16 * 14 * 23];
    (0..16 * 14 * 6).for_each(|i| zones[i] = 1);
    let plot = Plot::new([16, 14, 23], None).expect("plot");
    let plot = plot.with_given(&[ground, upper], &[court.clone(), court], zones).expect("given");
    let programme = Programme { floor_area_m2: [60.0, 260.0], storeys: [2, 3], ..Programme::default() };
    Space::new(plot, programme, choices()).expect("space")
}

fn rng(stream: u64) -> ChaCha8Rng {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    rng.set_stream(stream);
    rng
}

/// Whether the set corners and the clear corners of an occupancy mask are each connected through cube edges.
fn is_admissible(mask: u8) -> bool {
    let connected = |set: u8| {
        let mut part = set & set.wrapping_neg();
        loop {
            let grow =
                (0..8).filter(|c| part >> c & 1 == 1).flat_map(|c| [c ^ 1, c ^ 2, c ^ 4]).fold(part, |p, n| p | 1 << n)
                    & set;
            if grow == part {
                return part == set;
            }
            part = grow;
        }
    };
    connected(mask) && connected(!mask)
}

fn masks(v: &VoxelArray) -> impl Iterator<Item = u8> + '_ {
    let [nx, ny, nz] = v.shape().map(|n| n as isize);
    (0..=nz).flat_map(move |k| {
        (0..=ny).flat_map(move |j| {
            (0..=nx).map(move |i| {
                (0..8).fold(0, |m, o| {
                    let at = [i - 1 + (o & 1), j - 1 + (o >> 1 & 1), k - 1 + (o >> 2)];
                    m | u8::from(v.at(at).is_filled()) << o
                })
            })
        })
    })
}

fn assert_sound(design: &Design, space: &Space) {
    let house = encode(&design.massing, &space.plot);
    assert_eq!(house, encode(&design.massing, &space.plot), "encode is deterministic");
    let v = &house.voxels;
    assert!(masks(v).all(is_admissible), "an inadmissible cube in {design:?}");
    assert_ground(v);
    assert_openings(v);
    assert_stairs(&house, design);
    assert_given(&house, design, space);
    let mut again = design.clone();
    assert_eq!(settle(&mut again, space), Ok(()));
    assert_eq!(again, *design, "settling is idempotent");
}

fn assert_ground(v: &VoxelArray) {
    for ([x, y, z], label) in v.iter() {
        assert_eq!(
            label == Label::Foundation,
            z == 0 && label.is_filled(),
            "foundation is the ground layer at {x} {y} {z}"
        );
    }
}

/// Every window and door voxel faces the open on exactly one side, with base or its own kind beside it and base above.
fn assert_openings(v: &VoxelArray) {
    for ([x, y, z], label) in v.iter().filter(|(_, l)| l.is_infill()) {
        let at = |dx: isize, dy: isize, dz: isize| v.at([x as isize + dx, y as isize + dy, z as isize + dz]);
        let open: Vec<Direction> =
            Direction::ALL.into_iter().filter(|d| !at(d.step()[0], d.step()[1], 0).is_filled()).collect();
        assert_eq!(open.len(), 1, "one exposed side");
        let [ax, ay] = open[0].left().step();
        for side in [at(ax, ay, 0), at(-ax, -ay, 0)] {
            assert!(side == Label::Base || side == label);
        }
        for [dx, dy] in [[ax, ay], [-ax, -ay]] {
            let [ox, oy] = open[0].step();
            assert!(!at(dx + ox, dy + oy, 0).is_filled(), "no opening beside a re-entrant corner");
        }
        assert!(at(0, 0, 1) == Label::Base || at(0, 0, 1) == label);
        assert!(at(0, 0, -1) == Label::Base || at(0, 0, -1) == label || at(0, 0, -1).is_slab());
        let inside = open[0].back().step();
        assert_eq!(at(inside[0], inside[1], 0), Label::Base, "one deep");
        assert!((1..=3).all(|n| !at(n * open[0].step()[0], n * open[0].step()[1], 0).is_filled()), "free view");
        if label == Label::Opening {
            let foot = z / 6 * 6;
            let outside = v.at([x as isize + open[0].step()[0], y as isize + open[0].step()[1], foot as isize]);
            assert_eq!(outside.is_slab(), foot > 0, "a door leads onto the ground or onto a deck");
        }
    }
}

fn assert_stairs(house: &House, design: &Design) {
    assert_eq!(house.stairs.len() + 1, design.massing.storeys.len(), "each storey is reached");
    let inner: Vec<Cells> = design.massing.storeys.iter().map(|s| s.footprint.inner()).collect();
    for (s, stair) in house.stairs.iter().enumerate() {
        assert_eq!(stair.storey, s);
        let lower = stair.flight_cells().into_iter().chain(stair.middle_landing()).chain([stair.foot()]);
        assert!(lower.into_iter().all(|c| inner[s].has(c)));
        assert!(stair.void_cells().into_iter().chain([stair.head()]).all(|c| inner[s + 1].has(c)));
        for [x, y] in stair.void_cells() {
            assert_eq!(house.voxels.at([x, y, 6 * (s as isize + 1)]), Label::Base, "a void is base");
        }
    }
}

fn assert_given(house: &House, design: &Design, space: &Space) {
    let Some(given) = &space.plot.given else { return };
    for (s, fill) in given.fill.iter().enumerate() {
        for [x, y] in fill.iter() {
            assert!((6 * s..6 * s + 6).all(|k| house.voxels.get([x, y, k]).is_filled()), "given cells are filled");
        }
    }
    for (storey, empty) in design.massing.storeys.iter().zip(&given.empty) {
        assert!(!storey.footprint.meets(empty));
    }
    assert_eq!(house.zones.len(), given.zones.len());
    assert!(house.zones.iter().zip(house.voxels.labels()).all(|(z, l)| l.is_filled() || *z == -1));
}

#[test]
fn starts_are_sound_and_differ() {
    for (space, least) in [(starter(), 35), (larger(), 38), (given(), 30)] {
        let starts: Vec<Design> = (0..40).map(|i| start(&space, &mut rng(i)).expect("a start")).collect();
        starts.iter().for_each(|d| assert_sound(d, &space));
        let mut plans: Vec<_> = starts.iter().map(|d| d.massing.clone()).collect();
        plans.dedup();
        assert!(plans.len() >= least);
        let [low, high] = space.programme.floor_area_m2;
        if space.plot.given.is_none() {
            assert!(starts.iter().all(|d| (low..=high).contains(&floor_area_m2(&d.massing))));
        }
    }
}

#[test]
fn every_move_keeps_the_rules_and_happens() {
    let mut applied = [0usize; Move::ALL.len()];
    for (n, space) in [starter(), larger(), given()].iter().enumerate() {
        for walk in 0..12 {
            let mut rng = rng(1000 * n as u64 + walk);
            let mut design = start(space, &mut rng).expect("a start");
            for step in 0..120 {
                let choice = Move::draw(&mut rng);
                let Some(child) = choice.apply(&design, space, &mut rng) else { continue };
                assert_ne!(child, design, "{choice:?} changes something");
                applied[choice as usize] += 1;
                if step % 3 == 0 {
                    assert_sound(&child, space);
                }
                design = child;
            }
        }
    }
    for (choice, count) in Move::ALL.iter().zip(applied) {
        assert!(count > 0, "{} never applied", choice.name());
    }
}

#[test]
fn crossover_keeps_the_rules() {
    for space in [starter(), larger(), given()] {
        let parents: Vec<Design> = (0..30).map(|i| start(&space, &mut rng(i)).expect("a start")).collect();
        let mut made = 0;
        for i in 0..200u64 {
            let (a, b) = (&parents[i as usize % 30], &parents[(i as usize * 7 + 3) % 30]);
            if let Some(child) = crossover(a, b, &space, &mut rng(5000 + i)) {
                assert_sound(&child, &space);
                made += 1;
            }
        }
        assert!(made > 60, "only {made} of 200 pairs combined");
    }
}

#[test]
fn identity_is_the_same_wherever_the_house_stands() {
    let space = starter();
    let [nx, ny, nz] = [12, 10, 16];
    let wide = Plot::new([nx, ny, nz], None).expect("plot");
    for i in 0..50 {
        let design = start(&space, &mut rng(i)).expect("a start");
        let house = encode(&design.massing, &space.plot);
        let mut moved = House::new(VoxelArray::new([nx, ny, nz]));
        house.voxels.iter().for_each(|([x, y, z], l)| moved.voxels.set([x + 2, y + 1, z], l));
        moved.stairs = house.stairs.clone();
        moved.stairs.iter_mut().for_each(|s| s.start = [s.start[0] + 2, s.start[1] + 1]);
        assert_eq!(identity(&house, &design.choices), identity(&moved, &design.choices));
        let mut other = design.choices;
        other.0[0] += 1;
        assert_ne!(identity(&house, &design.choices), identity(&house, &other));
        let (voxel, _) = house.voxels.iter().find(|(_, l)| *l == Label::Window).expect("a window");
        moved.voxels.set([voxel[0] + 2, voxel[1] + 1, voxel[2]], Label::Base);
        assert_ne!(identity(&house, &design.choices), identity(&moved, &design.choices));
    }
    assert_eq!(wide.most_storeys(), 2);
}

#[test]
fn bad_plots_are_told() {
    assert!(matches!(Plot::new([80, 8, 16], None), Err(PlotError::TooWide(80))));
    assert!(matches!(Plot::new([3, 8, 16], None), Err(PlotError::TooSmall(3, 8, 16))));
    assert!(matches!(Plot::new([8, 8, 16], Some(&Plan::new([8, 7]))), Err(PlotError::PlanSize { .. })));
    let mut mask = Cells::full([8, 8]).to_plan();
    mask.set([2, 2], false);
    let fill = Cells::rect([8, 8], [2, 2], [3, 3]).to_plan();
    let plot = Plot::new([8, 8, 16], Some(&mask)).expect("plot");
    let wrong = plot.clone().with_given(std::slice::from_ref(&fill), &[], Vec::new());
    assert_eq!(wrong, Err(PlotError::Contradiction { storey: 0, cell: [2, 2] }));
    let high = vec![fill; 3];
    assert!(matches!(
        Plot::new([8, 8, 16], None).expect("plot").with_given(&high, &[], Vec::new()),
        Err(PlotError::GivenTooHigh { .. })
    ));
    let area = Programme { floor_area_m2: [500.0, 900.0], ..Programme::default() };
    let space = Space::new(Plot::new([8, 8, 16], None).expect("plot"), area, choices()).expect("space");
    let error = start(&space, &mut rng(0)).expect_err("no house of 500 m2");
    assert!(error.to_string().contains("500 to 900 m2") && error.to_string().contains("area"), "{error}");
}

/// Zoning lattices of 6 x 4 x 2 cells read as 4 x 4 x 6 modules, top-heavy and scattered: a start is found around each,
/// with something standing under every cell that hangs.
#[test]
fn random_zonings_are_honoured() {
    let size = [24, 16];
    for pattern in 0..30u64 {
        let mut state = pattern.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let mut zoning = |share: u64| {
            let mut plan = Cells::new(size);
            for cell in 0..24isize {
                state ^= state << 13;
                state ^= state >> 7;
                state ^= state << 17;
                if state % 100 < share {
                    plan = plan.or(&Cells::rect(size, [4 * (cell % 6), 4 * (cell / 6)], [4, 4]));
                }
            }
            plan.to_plan()
        };
        let fill = [zoning(15), zoning(40)];
        let plot = Plot::new([24, 16, 17], None).expect("plot").with_given(&fill, &[], Vec::new()).expect("given");
        let space = Space::new(plot, Programme::default(), choices()).expect("space");
        let mut rng = rng(pattern);
        let mut design = start(&space, &mut rng).unwrap_or_else(|e| panic!("pattern {pattern}: {e}"));
        assert_sound(&design, &space);
        for _ in 0..20 {
            design = Move::draw(&mut rng).apply(&design, &space, &mut rng).unwrap_or(design);
        }
        assert_sound(&design, &space);
        let broken = rules::check(&encode(&design.massing, &space.plot), &Default::default());
        assert!(broken.is_empty(), "pattern {pattern}: {broken:?}");
    }
}
