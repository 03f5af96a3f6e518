//! The stages from voxels to verdict for the sample houses.

use std::path::Path;

use houscaper::analysis::{LoadCase, Model, Solution, Solver};
use houscaper::frame::{FrameWorkspace, HouseFrame, build};
use houscaper::structure::{
    Annex, Catalogue, LoadSettings, LoadTable, SectionOption, Site, SurfaceWeights, Workspace, analysis_model, assess,
    load_cases,
};
use houscaper::tiles::{Line, skeleton};
use houscaper::voxels::{Choices, House, read_storeys, samples};

const HOUSES: [&str; 4] = ["box", "hip", "l", "deck"];

fn main() {
    divan::main();
}

struct Setting {
    house: House,
    frame: HouseFrame,
    catalogue: Catalogue,
    sections: [SectionOption; 4],
    loads: LoadSettings,
}

fn lines() -> &'static [Vec<Line>] {
    static LINES: std::sync::OnceLock<Vec<Vec<Line>>> = std::sync::OnceLock::new();
    LINES.get_or_init(|| (0..=255u8).map(|m| skeleton(houscaper::cubes::Mask(m))).collect())
}

fn framed(house: &House, workspace: &mut FrameWorkspace) -> HouseFrame {
    build(house, &read_storeys(house), &Choices::default(), |m| &lines()[m as usize], workspace).expect("a house")
}

fn setting(name: &str) -> Setting {
    let (_, house) = samples::all().into_iter().find(|(n, _)| *n == name).expect("a sample");
    let configs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"));
    let catalogue = Catalogue::load(configs).expect("our catalogue");
    let sections = [("C24", "T_60x200"), ("C24", "T_60x240"), ("GL24h", "GL_90x315"), ("C24", "T_60x200")]
        .map(|(m, s)| catalogue.find(m, s).expect("in the catalogue"));
    let site = Site { vb0_m_s: 27.0, terrain: "II".into(), sk_kn_m2: 0.7, annex: Annex::Nl };
    let loads = LoadTable::load(configs).and_then(|t| t.site(&site, SurfaceWeights::default())).expect("our loads");
    Setting { frame: framed(&house, &mut FrameWorkspace::default()), house, catalogue, sections, loads }
}

fn model_of(s: &Setting) -> (Model, Vec<LoadCase>) {
    let mut cases = Vec::new();
    load_cases(&s.frame, &s.loads, &mut cases);
    (analysis_model(&s.frame, &s.catalogue, &s.sections), cases)
}

#[divan::bench(args = HOUSES)]
fn frame(bencher: divan::Bencher, name: &str) {
    let (s, mut workspace) = (setting(name), FrameWorkspace::default());
    bencher.bench_local(|| framed(&s.house, &mut workspace));
}

#[divan::bench(args = HOUSES)]
fn model_and_cases(bencher: divan::Bencher, name: &str) {
    let s = setting(name);
    bencher.bench_local(|| model_of(&s));
}

/// The cases of the site model that load anything: order, factor, solve, end forces.
#[divan::bench(args = HOUSES)]
fn solve(bencher: divan::Bencher, name: &str) {
    let (model, mut cases) = model_of(&setting(name));
    cases.retain(|c| !c.name.contains("thesis") && c.name != "frame");
    let (mut solver, mut solution) = (Solver::new(), Solution::default());
    bencher.bench_local(|| solver.solve_into(&model, &cases, &mut solution));
}

/// Model, solve and all checks.
#[divan::bench(args = HOUSES)]
fn assessment(bencher: divan::Bencher, name: &str) {
    let (s, mut workspace) = (setting(name), Workspace::default());
    bencher.bench_local(|| assess(&s.frame, &s.catalogue, &s.sections, &s.loads, &mut workspace));
}

/// As asked for a dossier: with the thesis rule and per-member results.
#[divan::bench(args = HOUSES)]
fn assessment_in_full(bencher: divan::Bencher, name: &str) {
    let (s, mut workspace) = (setting(name), Workspace::detailed());
    bencher.bench_local(|| assess(&s.frame, &s.catalogue, &s.sections, &s.loads, &mut workspace));
}
