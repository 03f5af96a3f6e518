//! Wind and snow against published numbers, worked by hand here and read from the reference folder where it is at hand.

use std::path::{Path, PathBuf};

use houscaper::structure::{Annex, LoadSettings, LoadTable, Site, SurfaceWeights};
use serde_json::Value;

fn table() -> LoadTable {
    LoadTable::load(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"))).expect("our loads")
}

fn settings(vb0_m_s: f64, terrain: &str, sk_kn_m2: f64) -> LoadSettings {
    let site = Site { vb0_m_s, terrain: terrain.into(), sk_kn_m2, annex: Annex::En };
    table().site(&site, SurfaceWeights::default()).expect("a site")
}

/// A reference file, or `None` with a message.
fn reference(name: &str) -> Option<Value> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let folder = std::env::var_os("HOUSCAPER_SHARED").map_or_else(beside, PathBuf::from);
    let path = folder.join("reference/eurocode").join(name);
    match std::fs::read(&path) {
        Ok(bytes) => Some(serde_json::from_slice(&bytes).expect("a reference file is JSON")),
        Err(e) => {
            println!("skipped: {} ({e}); set HOUSCAPER_SHARED to the folder that holds `reference`", path.display());
            None
        }
    }
}

fn near(found: f64, expected: &Value, what: &str) {
    let number = |key: &str| expected[key].as_f64().expect("a number");
    let (value, tolerance) = (number("value"), number("rel_tol"));
    assert!((found / value - 1.0).abs() <= tolerance, "{what}: {found}, published {value} +- {tolerance}");
}

/// Steel Buildings in Europe, part 3, appendix B: vb = 26 m/s, terrain III, z = 8 m. By hand: kr = 0.19 (0.3 / 0.05)^0.07 = 0.2154;
/// cr = 0.2154 ln(8 / 0.3) = 0.7072; vm = 18.39 m/s; Iv = 1 / ln(26.67) = 0.3046; qp = (1 + 7 x 0.3046) 0.625 x 18.39^2 = 661.8 N/m2
/// (the book rounds ce to 1.56 and prints 659).
#[test]
fn peak_pressure_of_the_steel_handbook() {
    let qp = settings(26.0, "III", 0.0).peak_pressure(8.0);
    assert!((qp - 661.8).abs() < 0.2, "{qp}");
    if let Some(file) = reference("ec1_wind_ssb03.json") {
        near(qp, &file["expected"]["qp_N_m2"], "qp");
    }
}

/// Below zmin the pressure stays (4.3.2(1)): terrain III, 5 m.
#[test]
fn pressure_does_not_fall_below_the_least_height() {
    let s = settings(26.0, "III", 0.0);
    assert_eq!(s.peak_pressure(2.0), s.peak_pressure(5.0));
    assert!(s.peak_pressure(5.1) > s.peak_pressure(5.0));
}

/// The Dutch table of peak pressures (NB.5), region 2 (27 m/s), open country (z0 = 0.2 m) at 10 m: 0.85 kN/m2. By hand:
/// kr = 0.19 x 4^0.07 = 0.2094, ln 50 = 3.912, vm = 22.12 m/s, (1 + 7 / 3.912) x 0.625 x 489.2 = 852.6 N/m2.
#[test]
fn peak_pressures_of_the_dutch_table() {
    let qp = |vb: f64, terrain: [f64; 2], z: f64| LoadSettings { terrain, ..settings(vb, "II", 0.0) }.peak_pressure(z);
    assert!((qp(27.0, [0.2, 4.0], 10.0) - 852.5).abs() < 0.5);
    let Some(file) = reference("ec1_wind_nl_table.json") else { return };
    let published = file["expected"].as_object().expect("a table");
    for (key, expected) in published {
        let parts: Vec<&str> = key.split('_').collect();
        let [region, terrain, height] = parts[..] else { panic!("{key}") };
        let number = |v: &Value| v.as_f64().expect("a number");
        let vb = number(&file["input"]["vb0_m_s"][&region[1..]]);
        let ground = &file["input"]["terrain"][terrain];
        let z: f64 = height[1..].parse().expect("a height");
        near(qp(vb, [number(&ground["z0"]), number(&ground["zmin"])], z) / 1e3, expected, key);
    }
    assert!(published.len() >= 18);
}

/// EN 1991-1-3 Table 5.2: mu1 = 0.8 up to 30 degrees, 0.8 (60 - pitch) / 30 to 60. Steel handbook, appendix A: sk = 0.65 kN/m2,
/// 8.5 degrees: 0.52 kN/m2. Our roofs (31 degrees): 0.8 x 29 / 30 x 0.7 = 0.5413 kN/m2.
#[test]
fn snow_on_roofs() {
    let near_to = |found: f64, expected: f64| assert!((found - expected).abs() < 0.1, "{found} {expected}");
    near_to(settings(27.0, "II", 0.65).snow(8.5), 520.0);
    near_to(settings(27.0, "II", 0.7).snow(31.0), 541.3);
    near_to(settings(27.0, "II", 0.7).snow(60.0), 0.0);
    if let Some(file) = reference("ec1_snow_ssb03.json") {
        near(settings(27.0, "II", 0.65).snow(8.5) / 1e3, &file["expected"]["s"], "snow");
    }
}

/// EN 1991-1-4 Table 7.1 between its rows and 7.2.2(3), by hand: h/d = 0.625 gives D = 0.75 and E = -0.4; the lack of correlation is
/// 0.85 up to h/d = 1, 0.925 at 3, 1 from 5.
#[test]
fn wall_coefficients_and_correlation() {
    let s = settings(27.0, "II", 0.7);
    let [d, e] = s.wall_cpe(0.625);
    assert!((d - 0.75).abs() < 1e-12 && (e + 0.4).abs() < 1e-12, "{d} {e}");
    assert_eq!(s.wall_cpe(0.1), [0.7, -0.3]);
    assert_eq!(s.wall_cpe(9.0), [0.8, -0.7]);
    for (slender, factor) in [(0.5, 0.85), (1.0, 0.85), (3.0, 0.925), (5.0, 1.0), (8.0, 1.0)] {
        assert!((s.correlation(slender) - factor).abs() < 1e-12, "{slender}");
    }
}
