//! The early out against its slow twin on whole houses.

use super::*;
use crate::frame::{FrameWorkspace, build};
use crate::structure::actions::BaseActions;
use crate::structure::cases::CaseLoads;
use crate::structure::combine::ultimate;
use crate::structure::model::fill_model;
use crate::structure::{Annex, LoadTable, Site, SurfaceWeights};
use crate::voxels::{Choices, read_storeys, samples};

/// As [`worst`], without bounds: every clause at every station of every combination.
fn slow(
    r: &Resistance,
    span: &Span,
    catalogue: &Catalogue,
    combinations: &[Combination],
    solution: &Solution,
    actions: &BaseActions,
) -> (f64, Clause) {
    let mut worst = (0.0, UNLOADED_CLAUSE);
    for c in combinations {
        let k_mod = catalogue.k_mod.timber[c.duration as usize];
        let mut peaks = Peaks::default();
        for e in elements(span) {
            let p = Sum::new(c, k_mod).piece(actions.pieces(e));
            let (xs, n) = stations(&p, solution.length(e));
            for &x in &xs[..n] {
                let forces = design_forces(&p, x);
                keep(&mut worst, r.ratio(&forces, k_mod));
                peaks.add(&forces);
            }
        }
        keep(&mut worst, r.stability(&peaks, k_mod));
    }
    worst
}

/// The bound saves time and never changes a ratio or its clause, on all samples in timber, hollow and open steel.
#[test]
fn the_early_out_changes_nothing() {
    let configs = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"));
    let catalogue = Catalogue::load(configs).expect("our catalogue");
    let site = Site { vb0_m_s: 27.0, terrain: "II".into(), sk_kn_m2: 0.7, annex: Annex::Nl };
    let loads = LoadTable::load(configs).and_then(|t| t.site(&site, SurfaceWeights::default())).expect("our loads");
    let kits = [
        [("C24", "T_60x200"), ("C24", "T_60x240"), ("GL24h", "GL_90x315"), ("C24", "T_60x200")],
        [("S355", "SHS80x80x4"), ("S235", "IPE160"), ("S355", "IPE200"), ("S235", "SHS100x100x4")],
    ];
    let (mut spans, mut closed) = (0, 0);
    for (name, house) in samples::all() {
        let lines: Vec<_> = (0..=255u8).map(|m| crate::tiles::skeleton(crate::cubes::Mask(m))).collect();
        let frame = build(
            &house,
            &read_storeys(&house),
            &Choices::default(),
            |m| &lines[m as usize],
            &mut FrameWorkspace::default(),
        )
        .expect("a house");
        for kit in kits {
            let sections = kit.map(|(m, s)| catalogue.find(m, s).expect("in the catalogue"));
            let (mut model, mut cases) = (Default::default(), Vec::new());
            fill_model(&frame, &catalogue, &sections, &mut model);
            let mut case_loads = CaseLoads::default();
            case_loads.fill(&frame, &loads);
            case_loads.lend(false, &mut cases);
            let combinations = ultimate(&loads, &case_loads);
            let solution = crate::analysis::solve(&model, &cases).expect("a model");
            let mut actions = BaseActions::default();
            actions.fill(&frame, &loads, &case_loads, &solution);
            let of = |c: &Combination| Sum::new(c, catalogue.k_mod.timber[c.duration as usize]);
            let sums: Vec<Sum> = combinations.iter().map(of).collect();
            let loaded = Loaded { frame: &frame, solution: &solution, actions: &actions, sums: &sums };
            let mut largest = 0.0f64;
            for span in &frame.spans {
                let member = &frame.members[span.member as usize];
                let option = sections[member.group as usize];
                let clear = elements(span).map(|e| solution.length(e)).sum();
                let (m, s) = (catalogue.material(option), catalogue.section(option));
                let r = Resistance::new(m, s, member.plies, clear, restraint(member.role));
                let fast = worst(&loaded, &r, span, 0.0);
                let all = slow(&r, span, &catalogue, &combinations, &solution, &actions);
                assert_eq!(fast, all, "{name}: {:?}", member.role);
                // A floor hides nothing that reaches it.
                assert_eq!(worst(&loaded, &r, span, 0.9 * fast.0), all, "{name}: {:?}", member.role);
                largest = largest.max(fast.0);
                spans += 1;
                closed += usize::from(fast.0 < 0.5);
            }
            // Asked for the worst alone, and for all.
            let mut screen = Screen::default();
            let mut results = [false, true].map(|each| {
                let none =
                    super::super::verdict::MemberResult { utilisation: 0.0, check: UNLOADED, deflection_ratio: 0.0 };
                let members = if each { vec![none; frame.members.len()] } else { Vec::new() };
                let mut result = Assessment { members, ..Assessment::default() };
                super::members(&loaded, &catalogue, &sections, &mut screen, &mut result);
                result
            });
            assert_eq!(results[0].utilisation, largest, "{name}");
            results[1].members.clear();
            assert_eq!(results[0], results[1], "{name}");
        }
    }
    assert!(spans > 1000 && closed > spans / 10, "{spans} spans, {closed} under a half");
}
