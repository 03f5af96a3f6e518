//! House frames as mechanical systems: rigid-body modes, balance of loads and reactions, removed supports.

use std::path::Path;

use houscaper::analysis::{Distribution, LoadCase, Member, Model, Solution, Status, member_stiffness, solve};
use houscaper::frame::{FrameWorkspace, HouseFrame, build};
use houscaper::structure::{
    Annex, Catalogue, LoadSettings, LoadTable, SectionOption, Site, SurfaceWeights, Verdict, Workspace, analysis_model,
    assess, load_cases,
};
use houscaper::tiles::skeleton;
use houscaper::voxels::{Choices, House, read_storeys, samples};
use nalgebra::{DMatrix, SymmetricEigen};

struct Setting {
    catalogue: Catalogue,
    sections: [SectionOption; 4],
    loads: LoadSettings,
}

fn setting() -> Setting {
    let configs = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"));
    let catalogue = Catalogue::load(configs).expect("our catalogue");
    let sections = [("C24", "T_60x200"), ("GL24h", "GL_90x270"), ("GL24h", "GL_90x315"), ("C24", "T_60x200")]
        .map(|(m, s)| catalogue.find(m, s).expect("in the catalogue"));
    let site = Site { vb0_m_s: 27.0, terrain: "II".into(), sk_kn_m2: 0.7, annex: Annex::Nl };
    let loads = LoadTable::load(configs).and_then(|t| t.site(&site, SurfaceWeights::default())).expect("our loads");
    Setting { catalogue, sections, loads }
}

fn frame_of(house: &House) -> HouseFrame {
    let lines: Vec<_> = (0..=255u8).map(|m| skeleton(houscaper::cubes::Mask(m))).collect();
    let choices = Choices([0, 0, 0, 0, 0b11, 0]);
    build(house, &read_storeys(house), &choices, |m| &lines[m as usize], &mut FrameWorkspace::default())
        .expect("a house")
}

fn verdict(frame: &HouseFrame, s: &Setting) -> Verdict {
    assess(frame, &s.catalogue, &s.sections, &s.loads, &mut Workspace::default()).verdict
}

/// Motions without strain energy of a frame, supports as given: null vectors of the stiffness matrix scaled to unit diagonal, over
/// the dofs that have any stiffness of their own (ends of hinged studs have none about two axes).
fn free_motions(model: &Model) -> usize {
    let n = 6 * model.nodes.len();
    let mut k = DMatrix::<f64>::zeros(n, n);
    for m in &model.members {
        let ends = m.nodes.map(|n| model.nodes[n]);
        let own = member_stiffness(m, ends, &model.materials[m.material], &model.sections[m.section], false)
            .expect("a member with a length");
        for r in 0..12 {
            for c in 0..12 {
                k[(6 * m.nodes[r / 6] + r % 6, 6 * m.nodes[c / 6] + c % 6)] += own[r][c];
            }
        }
    }
    let held = |dof: usize| model.supports.iter().any(|s| s.node == dof / 6 && s.fix[dof % 6]);
    let largest = (0..n).map(|d| k[(d, d)]).fold(0.0, f64::max);
    let kept: Vec<usize> = (0..n).filter(|&d| k[(d, d)] > 1e-15 * largest && !held(d)).collect();
    let scaled = DMatrix::from_fn(kept.len(), kept.len(), |r, c| {
        let (r, c) = (kept[r], kept[c]);
        k[(r, c)] / (k[(r, r)] * k[(c, c)]).sqrt()
    });
    SymmetricEigen::new(scaled).eigenvalues.iter().filter(|e| e.abs() < 1e-12).count()
}

/// The model lifted off the ground together with its foundation: beams from one foundation node to all others, no supports.
fn floating(mut model: Model) -> Model {
    let feet: Vec<usize> = model.supports.drain(..).map(|s| s.node).collect();
    for &foot in &feet[1..] {
        let releases = [[false; 6]; 2];
        let beam = Member { nodes: [feet[0], foot], material: 0, section: 0, reference: None, roll: 0.0, releases };
        model.members.push(beam);
    }
    model
}

/// Off the ground a house on its foundation floats with six rigid-body modes and nothing else gives way; on the ground none is
/// left; a beam that flies beside it adds six of its own, on the ground too.
#[test]
fn a_house_off_the_ground_has_six_rigid_body_modes() {
    let s = setting();
    let frame = frame_of(&samples::box_house());
    let model = analysis_model(&frame, &s.catalogue, &s.sections);
    assert_eq!(free_motions(&model), 0);
    assert_eq!(free_motions(&floating(model.clone())), 6);
    let mut with_beam = model;
    let first = with_beam.nodes.len();
    with_beam.nodes.extend([[20.0, 0.0, 0.0], [22.0, 1.0, 0.5]]);
    let releases = [[false; 6]; 2];
    let nodes = [first, first + 1];
    with_beam.members.push(Member { nodes, material: 0, section: 0, reference: None, roll: 0.0, releases });
    assert_eq!(free_motions(&with_beam), 6);
    assert_eq!(free_motions(&floating(with_beam)), 12);
}

/// Force and moment about the origin of a case's loads and reactions, over the sum of their sizes.
fn imbalance(model: &Model, case: &LoadCase, number: usize, solution: &Solution) -> f64 {
    let (mut sum, mut size) = ([0.0; 6], [0.0; 6]);
    let mut act = |p: [f64; 3], f: [f64; 3], m: [f64; 3]| {
        let moment =
            [m[0] + p[1] * f[2] - p[2] * f[1], m[1] + p[2] * f[0] - p[0] * f[2], m[2] + p[0] * f[1] - p[1] * f[0]];
        for a in 0..3 {
            sum[a] += f[a];
            size[a] += f[a].abs();
            sum[3 + a] += moment[a];
            size[3 + a] += moment[a].abs();
        }
    };
    let middle = |m: usize| {
        let [a, b] = model.members[m].nodes.map(|n| model.nodes[n]);
        let d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        ([0, 1, 2].map(|x| 0.5 * (a[x] + b[x])), (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt())
    };
    for (m, member) in model.members.iter().enumerate() {
        let (p, length) = middle(m);
        let mass = model.materials[member.material].rho * model.sections[member.section].a * length;
        act(p, case.gravity.map(|g| mass * g), [0.0; 3]);
    }
    for l in &case.members {
        let Distribution::Uniform { q } = l.distribution else { panic!("house loads are uniform") };
        let (p, length) = middle(l.member);
        act(p, q.map(|q| q * length), [0.0; 3]);
    }
    for (support, r) in model.supports.iter().zip(solution.reactions(number)) {
        act(model.nodes[support.node], [r[0], r[1], r[2]], [r[3], r[4], r[5]]);
    }
    let largest = |v: &[f64]| v.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let share = |range: std::ops::Range<usize>| largest(&sum[range.clone()]) / largest(&size[range]).max(1e-30);
    share(0..3).max(share(3..6))
}

/// Every case of every sample: forces and moments of loads and reactions cancel to 1e-9. One load a millionth off does not.
#[test]
fn reactions_balance_loads() {
    let s = setting();
    for (name, house) in samples::all() {
        let frame = frame_of(&house);
        let (model, mut cases) = (analysis_model(&frame, &s.catalogue, &s.sections), Vec::new());
        load_cases(&frame, &s.loads, &mut cases);
        let solution = solve(&model, &cases).expect("a model");
        assert!(matches!(solution.status, Status::Solved { .. }), "{name}: {:?}", solution.status);
        for (n, case) in cases.iter().enumerate() {
            let off = imbalance(&model, case, n, &solution);
            assert!(off <= 1e-9, "{name}, {}: {off:e}", case.name);
            if !case.members.is_empty() {
                let mut wrong = case.clone();
                wrong.members.iter_mut().for_each(|l| {
                    let Distribution::Uniform { q } = &mut l.distribution else { return };
                    q.iter_mut().for_each(|q| *q *= 1.0 + 1e-6);
                });
                assert!(imbalance(&model, &wrong, n, &solution) > 1e-8, "{name}, {}: the check is blind", case.name);
            }
        }
    }
}

/// A house stands; with the supports of its south wall removed it is unstable, and the nodes named are those over the gap.
#[test]
fn a_removed_support_chain_is_reported_by_node() {
    let s = setting();
    let mut frame = frame_of(&samples::box_house());
    assert_eq!(verdict(&frame, &s), Verdict::Ok);
    let all = frame.supports.clone();
    let south = frame.nodes.iter().map(|n| n[1]).fold(f64::INFINITY, f64::min);
    let on_south = |n: u32| frame.nodes[n as usize][1] < south + 0.1;
    let removed: Vec<u32> = all.iter().copied().filter(|&n| on_south(n)).collect();
    let kept: Vec<u32> = all.iter().copied().filter(|&n| !on_south(n)).collect();
    assert!(removed.len() >= 6 && !kept.is_empty());
    frame.supports = kept;
    let Verdict::Unstable { nodes } = verdict(&frame, &s) else { panic!("a house without a wall's ground stands") };
    assert!(nodes.iter().any(|(n, _)| removed.contains(&(*n as u32))), "none of the removed nodes is named: {nodes:?}");
    for (n, direction) in &nodes {
        let finite = direction.iter().all(|d| d.is_finite()) && direction.iter().any(|d| *d != 0.0);
        assert!(*n < frame.nodes.len() && finite, "node {n}: {direction:?}");
    }
    frame.supports = all;
    assert_eq!(verdict(&frame, &s), Verdict::Ok);
}

/// What is asked of the workspace changes nothing but what is asked; a workspace used before gives the same numbers.
#[test]
fn asking_for_the_thesis_rule_changes_nothing_else() {
    let s = setting();
    let mut used = Workspace::default();
    for (name, house) in samples::all() {
        let frame = frame_of(&house);
        let run = |w: &mut Workspace| assess(&frame, &s.catalogue, &s.sections, &s.loads, w);
        let plain = run(&mut used);
        let mut asking = Workspace::default();
        asking.thesis = true;
        let mut asked = run(&mut asking);
        assert!(plain.thesis.is_none(), "{name}: not asked, so neither yes nor no");
        let thesis = asked.thesis.take().expect("asked");
        assert!(thesis.passes == (thesis.ratio <= 1.0) && thesis.ratio > 0.0);
        assert_eq!(plain.verdict, run(&mut Workspace::default()).verdict, "{name}");
        for (a, b) in [
            (plain.utilisation, asked.utilisation),
            (plain.sway_ratio, asked.sway_ratio),
            (plain.deflection_ratio, asked.deflection_ratio),
            (plain.racking_ratio, asked.racking_ratio),
            (plain.stability.uplift_n, asked.stability.uplift_n),
            (plain.stability.anchor_n, asked.stability.anchor_n),
            (plain.vibration_ratio(), asked.vibration_ratio()),
        ] {
            assert!((a - b).abs() <= 1e-9 * b.abs(), "{name}: {a} {b}");
        }
    }
}
