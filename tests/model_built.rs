//! Published buildings entered as voxels: what our sizing picks is within one step of the catalogue of what their engineers chose, and
//! the same where their own rule for deflection or vibration stands in for ours.
//!
//! 1. A house on Lake Kegonsa, Wisconsin, enlarged after 2014: calculations of its beams in the public repository
//!    OpeningDesign/Lake_Kegonsa_Home (CC BY-SA 4.0), folder `Structural`, files `Beams-central.md` 3.1.1 (commit 9b7ad08),
//!    `Beam-Floor2-Grid(2).md`, `Beam-Floor2-Grid(C).md` (3111b65), `Beam-Floor2-Grid(E).md` (d4a32c9) and
//!    `Beam-Basement-Along Grid (E).md` (9a296bc), read on 2026-11-22. Loads there: floors 18 psf dead (walls of light frame
//!    included) and 40 psf live (Wisconsin SPS 321), roof 10 psf dead and 24.3 psf snow; allowable stress design.
//!    Not compared: the beam (H) and the basement's beam (3), which carry other beams; the lintel (4), an angle; the ridge beam, which
//!    projects by 3.2 m; and the columns HSS 3.5 x 0.188 in, since our posts take the section of the beam above.
//! 2. Worked examples of a house's joists (5.1) and rafters (5.7) in Coulbourne Consulting, Residential Structural Design Guide, 2nd
//!    edition, US Department of Housing and Urban Development, October 2017; read in the verification tests of xcfem/xc, which
//!    repeat 5.1 and are based on 5.7 (the guide itself was not at hand).
//!
//! Sizes in inches become the section of our list that is nearest in bending stiffness E I. Spans and loads per metre of member are the
//! source's: modules are as long as the spans ask for, and where joists cannot stand at the source's centres the loads per m2 are
//! changed in that proportion.

#[path = "common/boxes.rs"]
mod boxes;

use boxes::{AMPLE, AMPLE_MATERIAL, bays, boxed, configs, framed, gable, pick, ratio};
use houscaper::frame::{FrameOptions, HouseFrame, Role};
use houscaper::structure::{Annex, Catalogue, LoadSettings, LoadTable, Site, SurfaceWeights};
use houscaper::voxels::Choice;

/// m per foot.
const FOOT: f64 = 0.3048;
/// m per inch.
const INCH: f64 = 0.0254;
/// Pa per pound on a square inch.
const PSI: f64 = 6894.757;
/// kN/m2 per pound on a square foot.
const PSF: f64 = 0.047_880_26;

/// Both kinds of roof among the surfaces.
const ROOFS: [usize; 2] = [5, 6];

/// Dead load of roof and floor, live load of floors and snow on a roof of `pitch` degrees, psf; no partitions, no roof live load.
fn loads([roof, floor, live, snow]: [f64; 4], pitch: f64) -> LoadSettings {
    let mut weights = SurfaceWeights { floor_kn_m2: floor * PSF, ..SurfaceWeights::default() };
    ROOFS.iter().for_each(|&s| weights.surface_kn_m2[s] = roof * PSF);
    let site = Site { vb0_m_s: 24.0, terrain: "II".into(), sk_kn_m2: 1.0, annex: Annex::En };
    let mut loads = LoadTable::load(configs()).and_then(|t| t.site(&site, weights)).expect("our loads");
    loads.sk = snow * PSF * 1e3 / loads.mu1(pitch);
    loads.partitions = 0.0;
    loads.floor = live * PSF * 1e3;
    loads.roof.iter_mut().for_each(|row| row[1] = 0.0);
    loads
}

/// The section of a ladder that is nearest to a bending stiffness in N m2.
fn nearest(catalogue: &Catalogue, material: &str, ladder: &[&str], ei: f64) -> usize {
    let off = |id: &str| {
        let option = catalogue.find(material, id).expect("in the catalogue");
        (catalogue.material(option).e * catalogue.section(option).iy - ei).abs()
    };
    (0..ladder.len()).min_by(|&a, &b| off(ladder[a]).total_cmp(&off(ladder[b]))).expect("sections")
}

/// One beam of the Kegonsa house.
struct Beam {
    name: &'static str,
    span_ft: f64,
    /// Width of floor or roof that it carries, half on each side.
    carries_ft: f64,
    /// 2 for a floor between storeys, 1 for a roof.
    storeys: usize,
    size: Size,
}

enum Size {
    /// A wide flange of A992 (fy 345 N/mm2): second moment in in4 (AISC Manual Table 1-1, as remembered: no copy was at hand).
    Steel(f64),
    /// Laminated veneer lumber 3.5 in wide: depth in inches.
    Veneer(f64),
}

const BEAMS: [Beam; 5] = [
    Beam { name: "floor 2, centre, W6x16", span_ft: 12.5, carries_ft: 12.0, storeys: 2, size: Size::Steel(32.1) },
    Beam { name: "floor 2, (2), W8x24", span_ft: 16.7, carries_ft: 13.0, storeys: 2, size: Size::Steel(82.7) },
    Beam { name: "roof, (C), W8x18", span_ft: 17.0, carries_ft: 12.5, storeys: 1, size: Size::Steel(61.9) },
    // "Load span" 10.67 and 17.0 ft are spans of joists here: twice as much would break the beam they give.
    Beam { name: "floor 2, (E), LVL 9.5", span_ft: 8.67, carries_ft: 13.835, storeys: 2, size: Size::Veneer(9.5) },
    Beam { name: "basement, (E), LVL 11.25", span_ft: 14.18, carries_ft: 8.28, storeys: 2, size: Size::Veneer(11.25) },
];

const IPE: [&str; 8] = ["IPE100", "IPE120", "IPE140", "IPE160", "IPE180", "IPE200", "IPE220", "IPE240"];
const GLUED: [&str; 5] = ["GL_90x180", "GL_90x225", "GL_90x270", "GL_90x315", "GL_90x360"];

/// Our catalogue with the source's veneer lumber in the place of GL28h: E 2.0e6 psi; from `Beam-Basement-Along Grid (3).md`, where
/// 1.75 x 9.5 in may carry 5.885 kip ft and 3.16 kip, allowable stresses of 2,683 and 285 psi. Characteristic values are 2.1
/// times the allowable ones (ASTM D5456, as remembered); that in bending is given for this depth, so glulam's kh is taken out of it. No
/// cracks in shear: kcr = 1 (EN 1995-1-1 6.1.7 has 0.67 for glulam).
fn with_veneer() -> Catalogue {
    let mut c = Catalogue::load(configs()).expect("our catalogue");
    let glued = c.materials.iter_mut().find(|m| m.id == "GL28h").expect("GL28h");
    let section = [1.75, 9.5];
    let bending = 5_885.0 * 12.0 * 6.0 / (section[0] * section[1] * section[1]);
    let shear = 1.5 * 3_160.0 / (section[0] * section[1]);
    glued.e = 2.0e6 * PSI;
    let grade = glued.timber.as_mut().expect("timber");
    let k_h = (0.6 / (section[1] * INCH)).powf(0.1);
    (grade.fm, grade.fv, grade.k_cr) = (2.1 * bending * PSI / k_h, 2.1 * shear * PSI, 1.0);
    c
}

/// The part of the house around a beam: walls on all sides, joists of two lengths that meet on the beam, as its sheets reckon.
fn around(beam: &Beam) -> HouseFrame {
    let [span, joist] = [beam.span_ft, beam.carries_ft].map(|l| l * FOOT);
    let house = boxed([span / 4.0, 2.0 * joist / 7.0, 0.54], [4, 7], beam.storeys);
    let options = FrameOptions {
        stock_m: joist + 0.01,
        bay_m: joist + 0.1,
        post_distance_m: span + 0.1,
        ..FrameOptions::default()
    };
    let frame = framed(&house, options);
    let [beams, joists] = [bays(&frame, Role::Beam), bays(&frame, Role::Joist)];
    assert!(beams.iter().all(|b| (b - span).abs() < 1e-9), "{}: {beams:?}", beam.name);
    assert!(joists.iter().all(|b| (b - joist).abs() < 1e-9), "{}: {joists:?}", beam.name);
    frame
}

/// The house's loads. Its dead loads include the joists, ours stand beside the frame's own weight: that of our ample joists goes off.
fn kegonsa_loads(frame: &HouseFrame, catalogue: &Catalogue) -> LoadSettings {
    let mut settings = loads([10.0, 18.0, 40.0, 24.3], 0.0);
    let joist = catalogue.find(AMPLE_MATERIAL, AMPLE[Choice::Floor as usize]).expect("in the catalogue");
    let own = catalogue.section(joist).a * catalogue.material(joist).rho * 9.81e-3 / frame.module_m[0];
    ROOFS.iter().for_each(|&s| settings.weights.surface_kn_m2[s] -= own);
    settings.weights.floor_kn_m2 -= own;
    settings
}

/// The source's limits of deflection, none with creep. Steel: L/360 (`Beams.md`) under dead and live load, which is what the sizes amount
/// to. Veneer lumber comes from its maker's span tables: L/240, and L/360 of the live load (as remembered: no copy was at hand).
fn their_limits(size: &Size) -> [f64; 2] {
    match size {
        Size::Steel(_) => [360.0, 1.0],
        Size::Veneer(_) => [240.0, 360.0],
    }
}

/// By our rules (deflection L/250 with creep, L/300 of variable load) each of the five is within a step: two the same, two of steel a
/// step smaller, one of timber, for creep, a step larger. By theirs all are the same but one: an IPE220 has 15 % less stiffness
/// than the W8x24 that it is nearest to, and that has 2 % more than L/360 asks for.
#[test]
fn beams_of_a_house_on_lake_kegonsa() {
    let mut alike = [0, 0];
    for beam in &BEAMS {
        let frame = around(beam);
        let mut c = with_veneer();
        let (material, ladder, ei) = match beam.size {
            Size::Steel(in4) => ("S355", &IPE[..], 29.0e6 * PSI * in4 * INCH.powi(4)),
            Size::Veneer(depth) => ("GL28h", &GLUED[..], 2.0e6 * PSI * 3.5 * depth.powi(3) / 12.0 * INCH.powi(4)),
        };
        let published = nearest(&c, material, ladder, ei);
        // The beams above and below are one group; the floor's loads are the larger.
        let mut settings = kegonsa_loads(&frame, &c);
        let (ours, step) = pick(&frame, &c, &settings, Choice::Beam, material, ladder);
        // Sizing stops at the first that holds: the one below does not.
        if ours > 0 {
            assert!(ratio(&frame, &c, &settings, Choice::Beam, material, ladder[ours - 1]) > 1.0, "{}", beam.name);
        }
        settings.limits[..2].copy_from_slice(&their_limits(&beam.size));
        c.materials.iter_mut().for_each(|m| m.k_def = 0.0);
        let (theirs, _) = pick(&frame, &c, &settings, Choice::Beam, material, ladder);
        let names = [ours, theirs, published].map(|n| ladder[n]);
        println!(
            "{}: {} ({:.2}), by their rule {}, published nearest {}",
            beam.name, names[0], step.group_ratio[2], names[1], names[2]
        );
        for (n, pick) in [ours, theirs].into_iter().enumerate() {
            assert!(pick.abs_diff(published) <= 1, "{}: {names:?}", beam.name);
            alike[n] += usize::from(pick == published);
        }
        if theirs != published {
            let short = ratio(&frame, &c, &settings, Choice::Beam, material, ladder[published]);
            assert!((1.0..1.2).contains(&short), "{}: {short}", beam.name);
        }
        // Closed form: a simple beam of their size keeps their limits, and has not half as much again where the span is long.
        let [dead, live] = if beam.storeys == 2 { [18.0, 40.0] } else { [10.0, 24.3] };
        let l = beam.span_ft * FOOT;
        let needs = |psf: f64, limit: f64| 5.0 * psf * PSF * 1e3 * beam.carries_ft * FOOT * l.powi(3) * limit / 384.0;
        let [total, variable] = their_limits(&beam.size);
        let needed = needs(dead + live, total).max(needs(live, variable));
        assert!(ei >= needed && (l < 3.0 || ei < 1.5 * needed), "{}: {}", beam.name, ei / needed);
    }
    assert!(alike[0] >= 2 && alike[1] >= 4, "{alike:?} of 5 alike");
}

/// Without the source's material the two beams of veneer lumber are glulam GL28h here, each a step deeper than published: shear with kcr
/// governs the short one, bending the long one.
#[test]
fn veneer_lumber_as_glulam() {
    let c = Catalogue::load(configs()).expect("our catalogue");
    for (beam, expected) in BEAMS[3..].iter().zip(["GL_90x270", "GL_90x315"]) {
        let frame = around(beam);
        let (n, _) = pick(&frame, &c, &kegonsa_loads(&frame, &c), Choice::Beam, "GL28h", &GLUED);
        assert_eq!(GLUED[n], expected, "{}", beam.name);
    }
}

const SAWN: [&str; 7] = ["T_45x95", "T_45x120", "T_45x145", "T_45x170", "T_45x195", "T_45x220", "T_45x245"];

/// 2 x 8 in: second moment, m4.
fn two_by_eight() -> f64 {
    1.5 * 7.25f64.powi(3) / 12.0 * INCH.powi(4)
}

/// Joists 2 x 8 in of Hem-Fir No. 1 (E 1.5e6 psi) at 16 in over 12.5 ft, 10 psf dead and 30 psf live: the length that the example allows
/// for vibration (13.8 ft for deflection, 14.9 ft for bending). C24 stands in.
///
/// Ours is a step deeper: EN 1995-1-1 7.3.3 with 2 mm under 1 kN asks for more than the example's L/360 under 40 psf. Without it the
/// size is the same.
#[test]
fn joists_of_the_housing_department() {
    let c = Catalogue::load(configs()).expect("our catalogue");
    let module = 12.5 * FOOT / 9.0;
    let frame =
        framed(&boxed([module, module, 0.54], [12, 9], 2), FrameOptions { bay_m: 4.0, ..FrameOptions::default() });
    assert!(bays(&frame, Role::Joist).iter().all(|b| (b - 12.5 * FOOT).abs() < 1e-9));
    let centres = 16.0 * INCH / module;
    let mut settings = loads([10.0, 10.0 * centres, 30.0 * centres, 0.0], 0.0);
    let published = nearest(&c, "C24", &SAWN, 1.5e6 * PSI * two_by_eight());
    assert_eq!(SAWN[published], "T_45x170");
    let (ours, _) = pick(&frame, &c, &settings, Choice::Floor, "C24", &SAWN);
    assert_eq!(SAWN[ours], "T_45x195");
    (settings.vibration.frequency, settings.vibration.deflection) = (0.0, f64::INFINITY);
    let (ours, _) = pick(&frame, &c, &settings, Choice::Floor, "C24", &SAWN);
    assert_eq!(ours, published, "without vibration: {}", SAWN[ours]);
}

/// Rafters 2 x 8 in of Douglas Fir-Larch No. 2 (E 1.6e6 psi) at 16 in, 14.4 ft long over 12 ft of plan at 8 in 12, 10 psf dead and 20 psf
/// snow: the same size here, C24, in a house of 24 ft under a gable.
#[test]
fn rafters_of_the_housing_department() {
    let c = Catalogue::load(configs()).expect("our catalogue");
    let module = 24.0 * FOOT / 17.0;
    let house = gable([module, module, module * 8.0 / 12.0], [14, 17]);
    let frame = framed(&house, FrameOptions { bay_m: 8.0, ..FrameOptions::default() });
    let [_, longest] = bays(&frame, Role::Rafter);
    assert!(
        (longest - 14.42 * FOOT).abs() < 0.005 && (frame.pitch_deg - 33.69).abs() < 0.01,
        "{longest} {}",
        frame.pitch_deg
    );
    let centres = 16.0 * INCH / module;
    let settings = loads([10.0 * centres, 10.0, 30.0, 20.0 * centres], frame.pitch_deg);
    let published = nearest(&c, "C24", &SAWN, 1.6e6 * PSI * two_by_eight());
    let (ours, step) = pick(&frame, &c, &settings, Choice::Roof, "C24", &SAWN);
    println!("{} ({:.2}), published nearest {}", SAWN[ours], step.group_ratio[3], SAWN[published]);
    assert_eq!(SAWN[ours], SAWN[published]);
}
