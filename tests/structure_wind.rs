//! Pressure zones of whole houses against areas and coefficients worked by hand, and their symmetry.

use std::path::Path;

use houscaper::frame::{FrameWorkspace, HouseFrame, build};
use houscaper::structure::{
    Annex, Assessment, Catalogue, LoadReport, LoadSettings, LoadTable, Site, SurfaceWeights, WindReport, Workspace,
    assess,
};
use houscaper::tiles::skeleton;
use houscaper::voxels::{Choices, House, Label, VoxelArray, read_storeys, samples};

fn settings() -> LoadSettings {
    let configs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"));
    let site = Site { vb0_m_s: 27.0, terrain: "II".into(), sk_kn_m2: 0.7, annex: Annex::En };
    LoadTable::load(configs).and_then(|t| t.site(&site, SurfaceWeights::default())).expect("our loads")
}

fn framed(house: &House, joists: u16) -> HouseFrame {
    let lines: Vec<_> = (0..=255u8).map(|m| skeleton(houscaper::cubes::Mask(m))).collect();
    let choices = Choices([0, 0, 0, 0, joists, 0]);
    build(house, &read_storeys(house), &choices, |m| &lines[m as usize], &mut FrameWorkspace::default())
        .expect("a house")
}

fn assessed(house: &House, joists: u16, loads: &LoadSettings) -> (HouseFrame, Assessment) {
    let configs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"));
    let catalogue = Catalogue::load(configs).expect("our catalogue");
    let sections = [("C24", "T_60x200"), ("C24", "T_60x240"), ("GL24h", "GL_90x315"), ("C24", "T_60x200")]
        .map(|(m, s)| catalogue.find(m, s).expect("in the catalogue"));
    let frame = framed(house, joists);
    let a = assess(&frame, &catalogue, &sections, loads, &mut Workspace::detailed());
    assert!(a.loads.is_some(), "{:?}", a.verdict);
    (frame, a)
}

fn report(house: &House, joists: u16, loads: &LoadSettings) -> LoadReport {
    *assessed(house, joists, loads).1.loads.expect("solved")
}

/// One storey of w x d modules with a flat roof.
fn flat(w: usize, d: usize) -> House {
    samples::massing([w + 2, d + 2, 13], &[&[[1, 1, w, d]]], 0)
}

fn block(house: &mut House, [x0, y0, w, d]: [usize; 4], k: usize) {
    (y0..y0 + d).for_each(|y| (x0..x0 + w).for_each(|x| house.voxels.set([x, y, k], Label::Base)));
}

/// One storey of 11 x 7 modules, 9.9 x 6.3 m, under a saddle roof along x: eaves at 3.78 m, ridge at 5.67 m.
fn gable() -> House {
    let mut house = flat(11, 7);
    (0..4).for_each(|i| block(&mut house, [1, 1 + i, 11, 7 - 2 * i], 7 + i));
    house
}

/// One storey of 4 x 6 modules, 3.6 x 5.4 m, under a roof that falls to +x.
fn monopitch() -> House {
    let mut house = flat(4, 6);
    (0..4).for_each(|i| block(&mut house, [1, 1, 4 - i, 6], 7 + i));
    house
}

fn from<'r>(r: &'r LoadReport, side: &str) -> &'r WindReport {
    r.wind.iter().find(|w| w.from == side).expect("a side")
}

/// Area and coefficients of a zone of a table.
fn zone(w: &WindReport, table: &str, letter: &str) -> (f64, [f64; 2]) {
    let found = w.zones.iter().find(|z| z.clause.ends_with(table) && z.zone == letter);
    found.map_or((0.0, [f64::NAN; 2]), |z| (z.area_m2, z.cpe))
}

fn near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-6 + 1e-5 * expected.abs(), "{what}: {found}, by hand {expected}");
}

fn check(w: &WindReport, table: &str, rows: &[(&str, f64, f64, f64)]) {
    for &(letter, area, least, most) in rows {
        let (found, cpe) = zone(w, table, letter);
        let what = format!("wind from {}, {table}, {letter}", w.from);
        near(found, area, &what);
        near(cpe[0], least, &what);
        near(cpe[1], most, &what);
    }
}

/// The slope's surface over its plan: 1 / cos(atan 0.6) = sqrt 1.36.
const SLOPE: f64 = 1.166_190_378_969_06;

/// A rectangular house with a duopitch roof, b = 9.9 m, d = 6.3 m, h = 5.67 m, pitch atan 0.6 = 30.9638 degrees: 0.064250 of the way
/// from the rows of 30 to those of 45 degrees.
///
/// vb = 27 m/s, terrain II: ln(5.67 / 0.05) = 4.7309, vm = 0.19 x 4.7309 x 27 = 24.270 m/s, qp = (1 + 7 / 4.7309) x 0.625 x 589.02 =
/// 912.84 N/m2.
///
/// Wind from -y: e = min(9.9, 11.34) = 9.9 m; h/d = 0.9: D = 0.7 + 0.1 x 0.65 / 0.75 = 0.78667, E = -0.3 - 0.2 x 0.86667 = -0.47333.
/// Roof, plan: F 2 x 2.475 x 0.99 = 4.9005, G (9.9 - 4.95) x 0.99 = 4.9005, H 9.9 x (3.15 - 0.99) = 21.384, J 9.9 x 0.99 = 9.801,
/// I 21.384 m2, each x 1.16619. Coefficients: F, G -0.5 + 0.5 x 0.06425 = -0.467875 or 0.7; H -0.2 + 0.2 x 0.06425 = -0.187150 or
/// 0.4 + 0.2 x 0.06425 = 0.412850; I -0.387150 or 0; J -0.487150 or 0.
/// Walls: D = E = 9.9 x 3.78 = 37.422 m2. Gables, e >= d: A to e/5 = 1.98 m, B the rest of
/// 6.3 x 3.78 + 6.3 x 1.89 / 2 = 29.7675 m2. Above the eaves A holds 0.9 x 0.54 / 2 = 0.243, 0.729 and 0.2 x 1.215 m2 of the first three
/// modules (each spread evenly; by integration 1.176 m2 instead of 1.215): A = 1.98 x 3.78 + 1.215 = 8.6994, B = 21.0681 m2, two of each.
///
/// Wind from +x: e = min(6.3, 11.34) = 6.3 m. Each slope, plan: F 1.575 x 0.63 = 0.99225, G 0.99225, H 3.15 x 2.52 = 7.938, I 3.15 x 6.75
/// = 21.2625 m2. Eave walls: A 1.26 x 3.78 = 4.7628, B 5.04 x 3.78 = 19.0512, C 3.6 x 3.78 = 13.608 m2. Table 7.4b: F -1.1, G -1.4,
/// H -0.8 - 0.1 x 0.06425 = -0.806425, I -0.5.
#[test]
fn a_duopitch_house_by_hand() {
    let r = report(&gable(), 0b11, &settings());
    let south = from(&r, "-y");
    assert!((south.qp_n_m2 - 912.84).abs() < 0.01 && (south.e_m - 9.9).abs() < 1e-9, "{} {}", south.qp_n_m2, south.e_m);
    let (d, e) = (0.7 + 0.1 * 0.65 / 0.75, -0.3 - 0.2 * 0.65 / 0.75);
    check(
        south,
        "Table 7.1",
        &[("A", 17.3988, -1.2, -1.2), ("B", 42.1362, -0.8, -0.8), ("D", 37.422, d, d), ("E", 37.422, e, e)],
    );
    check(
        south,
        "Table 7.4a",
        &[
            ("F", 4.9005 * SLOPE, -0.467875, 0.7),
            ("G", 4.9005 * SLOPE, -0.467875, 0.7),
            ("H", 21.384 * SLOPE, -0.18715, 0.41285),
            ("I", 21.384 * SLOPE, -0.38715, 0.0),
            ("J", 9.801 * SLOPE, -0.48715, 0.0),
        ],
    );
    // Up: windward 0.467875 x 9.801 + 0.18715 x 21.384 = 8.58764, leeward 0.38715 x 21.384 + 0.48715 x 9.801 = 13.05337 m2.
    near(south.least_n[2], south.qp_n_m2 * (13.053_374 + 8.587_644), "up");
    let sum = (0..3).map(|a| south.zones.iter().map(|z| z.force_n[a]).sum::<f64>() - south.least_n[a]);
    assert!(sum.into_iter().all(|off| off.abs() < 1e-6), "zones add up to the wind");
    let east = from(&r, "+x");
    assert!((east.e_m - 6.3).abs() < 1e-9);
    check(east, "Table 7.1", &[("A", 9.5256, -1.2, -1.2), ("B", 38.1024, -0.8, -0.8), ("C", 27.216, -0.5, -0.5)]);
    check(
        east,
        "Table 7.4b",
        &[
            ("F", 1.9845 * SLOPE, -1.1, -1.1),
            ("G", 1.9845 * SLOPE, -1.4, -1.4),
            ("H", 15.876 * SLOPE, -0.806425, -0.806425),
            ("I", 42.525 * SLOPE, -0.5, -0.5),
        ],
    );
}

/// A monopitch roof of 3.6 x 5.4 m that falls to +x.
///
/// Wind from +x (on the low eave): b = 5.4, e = 5.4, e/10 = 0.54, e/4 = 1.35 m: F 2 x 1.35 x 0.54 = 1.458, G 2.7 x 0.54 = 1.458 m2.
/// From -x (on the high edge), the same F and G: -1.1 + 0.5 x 0.06425 = -1.067875, -0.8 + 0.3 x 0.06425 = -0.780725,
/// H -0.8 + 0.1 x 0.06425 = -0.793575.
/// From +y: b = 3.6, e = 3.6: strips of 0.36 m to 0.9 m from the edges and 1.8 m: Fup 0.9 x 0.36 = 0.324, Flow 0.324, G (3.6 - 1.8) x 0.36 =
/// 0.648, H 3.6 x (1.8 - 0.36) = 5.184, I 3.6 x 3.6 = 12.96 m2. Table 7.3b: Fup -2.1 + 0.6 x 0.06425 = -2.061450, Flow -1.3,
/// G -1.5 + 0.1 x 0.06425 = -1.493575, H -1.0, I -0.8 - 0.1 x 0.06425 = -0.806425.
/// H of both is the rest of 3.6 x 5.4 = 19.44 m2: 16.524 m2. The outer half of the uppermost row and of the verges slopes outwards in the
/// frame and counts as part of the roof.
#[test]
fn a_monopitch_house_by_hand() {
    let r = report(&monopitch(), 0b11, &settings());
    let low = from(&r, "+x");
    check(
        low,
        "Table 7.3a, 0 degrees",
        &[
            ("F", 1.458 * SLOPE, -0.467875, 0.7),
            ("G", 1.458 * SLOPE, -0.467875, 0.7),
            ("H", 16.524 * SLOPE, -0.18715, 0.41285),
        ],
    );
    let high = from(&r, "-x");
    check(
        high,
        "Table 7.3a, 180 degrees",
        &[
            ("F", 1.458 * SLOPE, -1.067875, -1.067875),
            ("G", 1.458 * SLOPE, -0.780725, -0.780725),
            ("H", 16.524 * SLOPE, -0.793575, -0.793575),
        ],
    );
    let side = from(&r, "+y");
    check(
        side,
        "Table 7.3b",
        &[
            ("Fup", 0.324 * SLOPE, -2.06145, -2.06145),
            ("Flow", 0.324 * SLOPE, -1.3, -1.3),
            ("G", 0.648 * SLOPE, -1.493575, -1.493575),
            ("H", 5.184 * SLOPE, -1.0, -1.0),
            ("I", 12.96 * SLOPE, -0.806425, -0.806425),
        ],
    );
}

/// A flat roof of 6.3 x 5.4 m, 3.24 m high, with a parapet of 0.243 m: hp/h = 0.075, half way between the rows of 0.05 and 0.10:
/// F -1.3, G -0.85, H -0.7, I +-0.2; sharp eaves: F -1.8, G -1.2.
/// Wind from -y: b = 6.3, 2h = 6.48, e = 6.3: F 2 x 1.575 x 0.63 = 1.9845, G 3.15 x 0.63 = 1.9845, H 6.3 x 2.52 = 15.876, I 6.3 x 2.25 =
/// 14.175 m2. Wind from +x: e = 5.4: F 2 x 1.35 x 0.54 = 1.458, G 2.7 x 0.54 = 1.458, H 5.4 x 2.16 = 11.664, I 5.4 x 3.6 = 19.44 m2.
#[test]
fn a_flat_roof_with_a_parapet_by_hand() {
    let house = flat(7, 6);
    let with = LoadSettings { parapet: 0.243, ..settings() };
    for (loads, f, g) in [(settings(), -1.8, -1.2), (with, -1.3, -0.85)] {
        let r = report(&house, 0b1, &loads);
        let rows = |areas: [f64; 4]| {
            [("F", areas[0], f, f), ("G", areas[1], g, g), ("H", areas[2], -0.7, -0.7), ("I", areas[3], -0.2, 0.2)]
        };
        check(from(&r, "-y"), "Table 7.2", &rows([1.9845, 1.9845, 15.876, 14.175]));
        check(from(&r, "+x"), "Table 7.2", &rows([1.458, 1.458, 11.664, 19.44]));
    }
}

/// A hip roof over 9.9 x 6.3 m, plan areas by geometry, wind from -y: e = 9.9, e/10 = 0.99 m, e/4 = 2.475 m, e/2 = 4.95 m. Windward
/// trapezoid (9.9 x 3.15 - 3.15^2 = 21.2625 m2): F 2 (2.475 x 0.99 - 0.99^2 / 2) = 3.9204, G 4.95 x 0.99 = 4.9005, H the rest 12.4416.
/// Leeward the same trapezoid: K 3.6 x 0.99 = 3.564 under the ridge of 3.6 m and J along two hips. Hips (3.15^2 = 9.9225 m2 each): L a strip
/// of 0.99 m behind the upwind hip, M up to 4.95 m from the eaves, N the rest. Half modules make steps of the hips, so that areas of corners
/// are within a fifth, faces within a fiftieth. Coefficients at 30.9638 degrees, 0.06425 from 30 to 45: F -0.467875 / 0.512850, G -0.467875 / 0.7,
/// H -0.187150 / 0.412850, I -0.393575, J -0.693575, K -0.487150, L -1.393575, M -0.8, N -0.2.
#[test]
fn a_hip_house_by_hand() {
    let house = samples::massing([13, 9, 13], &[&[[1, 1, 11, 7]]], 4);
    let r = report(&house, 0b11, &settings());
    let south = from(&r, "-y");
    let area = |letters: &[&str]| letters.iter().map(|l| zone(south, "Table 7.5", l).0).sum::<f64>() / SLOPE;
    near(area(&["F", "G", "H", "I", "J", "K", "L", "M", "N"]), 62.37, "all");
    let close = |letters: &[&str], by_hand: f64, tolerance: f64| {
        let found = area(letters);
        assert!((found / by_hand - 1.0).abs() < tolerance, "{letters:?}: {found} {by_hand}");
    };
    close(&["F", "G", "H"], 21.2625, 0.01);
    close(&["I", "J", "K"], 21.2625, 0.01);
    close(&["L", "M", "N"], 2.0 * 9.9225, 0.02);
    for (letter, by_hand) in [("F", 3.9204), ("G", 4.9005), ("H", 12.4416), ("K", 3.564)] {
        close(&[letter], by_hand, 0.2);
    }
    let by_hand = [
        ("F", [-0.467875, 0.51285]),
        ("G", [-0.467875, 0.7]),
        ("H", [-0.18715, 0.41285]),
        ("I", [-0.393575; 2]),
        ("J", [-0.693575; 2]),
        ("K", [-0.48715; 2]),
        ("L", [-1.393575; 2]),
        ("M", [-0.8; 2]),
        ("N", [-0.2; 2]),
    ];
    for (letter, cpe) in by_hand {
        let (area, found) = zone(south, "Table 7.5", letter);
        assert!(area > 0.5, "{letter}: {area}");
        (0..2).for_each(|n| near(found[n], cpe[n], letter));
    }
}

/// The house seen through a map of its plan.
fn moved(house: &House, size: [usize; 2], to: impl Fn([usize; 2]) -> [usize; 2]) -> House {
    let mut voxels = VoxelArray::new([size[0], size[1], house.voxels.shape()[2]]);
    house.voxels.iter().filter(|(_, l)| l.is_filled()).for_each(|([x, y, z], l)| {
        let [x, y] = to([x, y]);
        voxels.set([x, y, z], l);
    });
    House::new(voxels)
}

/// Zones of a wind: clause, letter, area, least force along the wind, across it (size only) and up.
fn seen(r: &LoadReport, side: usize) -> Vec<(String, [f64; 4])> {
    let axis = side % 2;
    let sign = if side < 2 { -1.0 } else { 1.0 };
    let row = |z: &houscaper::structure::ZoneReport| {
        let f = z.force_n;
        (format!("{} {}", z.clause, z.zone), [z.area_m2, sign * f[axis], f[1 - axis].abs(), f[2]])
    };
    r.wind[side].zones.iter().map(row).collect()
}

/// Houses with every kind of roof, mirrored and turned: the wind from the mirrored or turned side meets the same zones, areas and
/// forces, snow weighs the same, and reactions balance every case to 1e-9.
#[test]
fn mirrored_and_turned_houses_carry_mirrored_and_turned_loads() {
    let projecting = samples::massing([9, 8, 14], &[&[[1, 1, 6, 6]], &[[1, 1, 7, 6]]], 0);
    let stepped = {
        let mut h = samples::massing([14, 9, 18], &[&[[1, 1, 12, 7]], &[[1, 1, 7, 7]]], 0);
        (0..4).for_each(|i| block(&mut h, [1, 1 + i, 7, 7 - 2 * i], 13 + i));
        h
    };
    let houses = [
        ("gable", gable()),
        ("monopitch", monopitch()),
        ("l", samples::l_house()),
        ("projecting", projecting),
        ("stepped", stepped),
    ];
    let loads = settings();
    for (name, house) in houses {
        let [nx, ny, _] = house.voxels.shape();
        let plain = report(&house, 0b11, &loads);
        for s in &plain.sums {
            for a in 0..3 {
                let size = s.loads_n.iter().fold(1.0f64, |m, f| m.max(f.abs()));
                assert!((s.loads_n[a] + s.reactions_n[a]).abs() < 1e-9 * size, "{name}, {}: {s:?}", s.case);
            }
        }
        let mirrored = report(&moved(&house, [nx, ny], |[x, y]| [nx - 1 - x, y]), 0b11, &loads);
        let turned = report(&moved(&house, [ny, nx], |[x, y]| [ny - 1 - y, x]), 0, &loads);
        for side in 0..4 {
            let cases = [(&mirrored, [2, 1, 0, 3][side], "mirrored"), (&turned, (side + 1) % 4, "turned")];
            for (other, image, how) in cases {
                let (a, b) = (seen(&plain, side), seen(other, image));
                assert_eq!(a.len(), b.len(), "{name} {how}, side {side}: {a:?} {b:?}");
                for ((za, fa), (zb, fb)) in a.iter().zip(&b) {
                    assert_eq!(za, zb, "{name} {how}");
                    for (x, y) in fa.iter().zip(fb) {
                        // Which of several rafters takes a cell of a valley is not symmetric in the frame.
                        let allowed = if name == "l" { 0.05 * y.abs() + 100.0 } else { 1e-6 * y.abs() + 1e-6 };
                        assert!((x - y).abs() < allowed, "{name} {how}, side {side}, {za}: {fa:?} {fb:?}");
                    }
                }
            }
        }
        let weights = |r: &LoadReport| {
            let mut w: Vec<f64> = r.snow.iter().map(|s| s.weight_n).collect();
            w.sort_unstable_by(f64::total_cmp);
            w
        };
        for other in [&mirrored, &turned] {
            let (a, b) = (weights(&plain), weights(other));
            let allowed = if name == "l" { 0.01 } else { 1e-9 };
            let alike = a.len() == b.len() && a.iter().zip(&b).all(|(x, y)| (x - y).abs() <= allowed * y);
            assert!(alike, "{name}: {a:?} {b:?}");
        }
    }
}

/// A lower flat roof beside a taller part carries a drift, a saddle roof half of its snow on either side, a hip on its main pair.
#[test]
fn arrangements_of_snow() {
    let loads = settings();
    let names = |h: &House| report(h, 0b11, &loads).snow.iter().map(|s| s.arrangement.to_owned()).collect::<Vec<_>>();
    assert_eq!(names(&flat(7, 6)).len(), 1);
    assert_eq!(names(&monopitch()).len(), 1, "EN 1991-1-3 5.3.2: a monopitch roof has no one-sided snow");
    // 9.9 x 6.3 m at mu1 = 0.8 x (60 - 30.9638) / 30 = 0.774300: 62.37 x 0.7 x 0.7743 = 33.805 kN; half of one side off: 25.354 kN.
    let saddle = report(&gable(), 0b11, &loads).snow;
    let weights: Vec<f64> = saddle.iter().map(|s| s.weight_n / 1e3).collect();
    assert_eq!(weights.len(), 3);
    for (w, by_hand) in weights.iter().zip([33.805, 25.354, 25.354]) {
        assert!((w - by_hand).abs() < 0.01, "{weights:?}");
    }
    // A terrace of 4 x 7 modules in front of a storey of 7 x 7: h = 3.24 m, b1 = 6.3, b2 = 3.6: mu_w = 9.9 / 6.48 = 1.5278, drift
    // length 6.48 m. Load at x: 0.7 (1.5278 + (0.8 - 1.5278) x / 6.48); the mean over 3.6 m is at x = 1.8: beyond 0.8 it is
    // 0.7 x 0.7278 x (1 - 1.8 / 6.48) = 0.36794 kN/m2 on 3.6 x 6.3 m2 = 8.345 kN.
    let terrace = samples::massing([13, 9, 14], &[&[[1, 1, 11, 7]], &[[1, 1, 7, 7]]], 0);
    let snow = report(&terrace, 0b11, &loads).snow;
    let drift = (snow.last().expect("even at least").weight_n - snow[0].weight_n) / 1e3;
    assert!((drift - 8.345).abs() < 0.01, "{drift} {snow:?}");
}
