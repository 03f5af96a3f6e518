//! The frame and its loads for the solver.

use super::catalogue::{Catalogue, SectionOption};
use super::loads::LoadSettings;
use crate::analysis::{Axes, Distribution, LoadCase, Material, Member, MemberLoad, Model, Section, Support};
use crate::frame::{Area, HouseFrame, PanelKind};
use crate::voxels::Direction;

/// E of the material of the braces; their area is E A over this.
const BRACE_E: f64 = 1e10;
const GRAVITY: f64 = 9.81;

/// The unit cases every combination is made of, then those of the thesis preset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// Weight of the members and the build-ups.
    Permanent = 0,
    /// Imposed load.
    Imposed = 1,
    /// Snow.
    Snow = 2,
    /// Outward pressure of 1 N/m2 on the walls facing a direction: 3 + `Direction as usize`.
    Walls = 3,
    /// Outward pressure of 1 N/m2 on the slopes facing a direction: 7 + `Direction as usize`.
    Slopes = 7,
    /// Outward pressure of 1 N/m2 on level roofs and decks.
    Flats = 11,
    /// Weight of the members alone, for the thesis preset.
    Frame = 12,
    /// Thesis wind on the posts of a facade, blowing at it: 13 + `Direction as usize`.
    Thesis = 13,
}

/// Number of unit cases of the site model.
pub(super) const UNITS: usize = 12;
/// Number of unit cases with those of the thesis preset.
pub(super) const CASES: usize = 17;

/// The frame as the solver takes it: elements first, then the panels as braces. Sections by group and plies.
pub fn analysis_model(frame: &HouseFrame, catalogue: &Catalogue, sections: &[SectionOption; 4]) -> Model {
    let mut model = Model::default();
    fill_model(frame, catalogue, sections, &mut model);
    model
}

/// As [`analysis_model`], into the buffers of `model`.
pub(super) fn fill_model(frame: &HouseFrame, catalogue: &Catalogue, sections: &[SectionOption; 4], model: &mut Model) {
    model.nodes.clone_from(&frame.nodes);
    model.materials.clear();
    model.sections.clear();
    model.members.clear();
    model.supports.clear();
    for &option in sections {
        let (m, s) = (catalogue.material(option), catalogue.section(option));
        model.materials.push(Material { e: m.e, g: m.g, rho: m.rho });
        for plies in [1.0, 2.0] {
            model.sections.push(Section {
                a: plies * s.a,
                iy: plies * s.iy,
                iz: plies * s.iz,
                j: plies * s.j,
                asy: None,
                asz: None,
            });
        }
    }
    model.materials.push(Material { e: BRACE_E, g: 0.4 * BRACE_E, rho: 0.0 });
    for e in &frame.elements {
        let m = &frame.members[e.member as usize];
        model.members.push(Member {
            nodes: e.nodes.map(|n| n as usize),
            material: m.group as usize,
            section: 2 * m.group as usize + usize::from(m.plies) - 1,
            reference: m.reference,
            roll: 0.0,
            releases: e.hinged.map(bending),
        });
    }
    for p in &frame.panels {
        let a = p.ea_n / BRACE_E;
        let i = 1e-6 * a;
        model.members.push(Member {
            nodes: p.nodes.map(|n| n as usize),
            material: 4,
            section: model.sections.len(),
            reference: None,
            roll: 0.0,
            releases: [bending(true); 2],
        });
        model.sections.push(Section { a, iy: i, iz: i, j: i, asy: None, asz: None });
    }
    model.supports.extend(frame.supports.iter().map(|&n| Support { node: n as usize, fix: [true; 6] }));
}

fn bending(released: bool) -> [bool; 6] {
    [false, false, false, false, released, released]
}

/// All unit cases, as member loads. `cases` is reused.
pub fn load_cases(frame: &HouseFrame, loads: &LoadSettings, cases: &mut Vec<LoadCase>) {
    if cases.len() != CASES {
        *cases = (0..CASES).map(|c| LoadCase { name: case_name(c), ..LoadCase::default() }).collect();
        for own in [Case::Permanent, Case::Frame] {
            cases[own as usize].gravity = [0.0, 0.0, -GRAVITY];
        }
    }
    cases.iter_mut().for_each(|c| c.members.clear());
    for a in &frame.areas {
        let width = a.area_m2 / frame.element_length_m(a.element as usize);
        let mut put = |case: usize, q: [f64; 3]| {
            if q != [0.0; 3] {
                cases[case].members.push(uniform(a.element as usize, q.map(|f| f * width)));
            }
        };
        let [layers, imposed, snow] = loads.vertical(a.area, frame.pitch_deg);
        put(Case::Permanent as usize, [0.0, 0.0, -layers]);
        put(Case::Imposed as usize, [0.0, 0.0, -imposed]);
        put(Case::Snow as usize, [0.0, 0.0, -snow]);
        if let Some((case, q)) = pressure(a.area, frame.pitch_deg) {
            put(case, q);
        }
    }
    thesis_wind(frame, loads, cases);
}

/// Case of 1 N/m2 outward on an area and its force per m2 (plan m2 on slopes).
fn pressure(area: Area, pitch_deg: f64) -> Option<(usize, [f64; 3])> {
    let out = |d: Direction| d.step().map(|s| s as f64);
    match area {
        Area::Wall(d) | Area::Band(d) | Area::Window(d) | Area::Door(d) => {
            Some((Case::Walls as usize + d as usize, [out(d)[0], out(d)[1], 0.0]))
        }
        Area::Slope(d) => {
            let t = pitch_deg.to_radians().tan();
            Some((Case::Slopes as usize + d as usize, [out(d)[0] * t, out(d)[1] * t, 1.0]))
        }
        Area::Plateau | Area::FlatRoof | Area::Deck => Some((Case::Flats as usize, [0.0, 0.0, 1.0])),
        Area::Floor | Area::Attic | Area::Soffit | Area::Stair => None,
    }
}

fn thesis_wind(frame: &HouseFrame, loads: &LoadSettings, cases: &mut [LoadCase]) {
    for m in &frame.members {
        for d in Direction::ALL {
            if m.facades >> (d as u8) & 1 == 1 {
                let [x, y] = d.step().map(|s| -loads.thesis_wind * s as f64);
                let case = &mut cases[Case::Thesis as usize + d as usize];
                case.members.extend(m.elements().map(|e| uniform(e, [x, y, 0.0])));
            }
        }
    }
}

fn uniform(member: usize, q: [f64; 3]) -> MemberLoad {
    MemberLoad { member, axes: Axes::Global, distribution: Distribution::Uniform { q } }
}

fn case_name(case: usize) -> String {
    let direction = |first: usize| ["+x", "+y", "-x", "-y"][case - first];
    match case {
        0 => "permanent".into(),
        1 => "imposed".into(),
        2 => "snow".into(),
        3..=6 => format!("1 Pa on walls {}", direction(3)),
        7..=10 => format!("1 Pa on slopes {}", direction(7)),
        11 => "1 Pa on flat roofs".into(),
        12 => "frame".into(),
        _ => format!("thesis wind on {}", direction(13)),
    }
}

/// The frame as a `houscaper.frame/1` document: N, m, kg; braces last.
pub fn frame_json(model: &Model, cases: &[LoadCase], frame: &HouseFrame) -> serde_json::Value {
    use serde_json::json;
    let bits = |b: &[bool; 6]| b.map(u8::from);
    let load = |l: &MemberLoad| match l.distribution {
        Distribution::Uniform { q } => json!({"m": l.member, "type": "uniform", "axes": "global", "q": q}),
        Distribution::Linear { q1, q2, x1, x2 } => {
            json!({"m": l.member, "type": "linear", "axes": "global", "q1": q1, "q2": q2, "x1": x1, "x2": x2})
        }
        Distribution::Point { p, x } => json!({"m": l.member, "type": "point", "axes": "global", "P": p, "x": x}),
    };
    let member = |m: &Member| {
        let mut o = json!({"n": m.nodes, "mat": m.material, "sec": m.section, "releases": {"i": bits(&m.releases[0]), "j": bits(&m.releases[1])}});
        if let Some(r) = m.reference {
            o["ref"] = json!(r);
        }
        o
    };
    let panels = [PanelKind::Wall, PanelKind::Deck, PanelKind::Roof]
        .map(|k| frame.panels.iter().filter(|p| p.kind == k).count());
    json!({
        "schema": "houscaper.frame/1",
        "units": "N, m, kg",
        "source": format!("elements 0..{}, then braces for sheathing: {} wall, {} deck, {} roof", frame.elements.len(), panels[0], panels[1], panels[2]),
        "nodes": model.nodes,
        "materials": model.materials.iter().map(|m| json!({"E": m.e, "G": m.g, "rho": m.rho})).collect::<Vec<_>>(),
        "sections": model.sections.iter().map(|s| json!({"A": s.a, "Iy": s.iy, "Iz": s.iz, "J": s.j})).collect::<Vec<_>>(),
        "members": model.members.iter().map(member).collect::<Vec<_>>(),
        "supports": model.supports.iter().map(|s| json!({"node": s.node, "fix": bits(&s.fix)})).collect::<Vec<_>>(),
        "cases": cases.iter().map(|c| json!({"name": c.name, "gravity": c.gravity, "member": c.members.iter().map(load).collect::<Vec<_>>()})).collect::<Vec<_>>(),
    })
}
