//! The frame for the solver, and its file.

use super::catalogue::{Catalogue, SectionOption};
use crate::analysis::{Distribution, LoadCase, Material, Member, MemberLoad, Model, Section, Support};
use crate::frame::{HouseFrame, PanelKind};

/// E of the material of the braces; their area is E A over this.
const BRACE_E: f64 = 1e10;

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

/// The frame as a `houscaper.frame/1` document: N, m, kg; braces last. Elements say of which stick they are a piece, its role, and how far
/// the timber's centre line lies from the axis that is analysed, with the `depths_m` of the sections of wall, floor, beam and roof.
pub fn frame_json(model: &Model, cases: &[LoadCase], frame: &HouseFrame, depths_m: [f64; 4]) -> serde_json::Value {
    use serde_json::json;
    let offsets = crate::frame::member_offsets(frame, depths_m);
    let bits = |b: &[bool; 6]| b.map(u8::from);
    let load = |l: &MemberLoad| match l.distribution {
        Distribution::Uniform { q } => json!({"m": l.member, "type": "uniform", "axes": "global", "q": q}),
        Distribution::Linear { q1, q2, x1, x2 } => {
            json!({"m": l.member, "type": "linear", "axes": "global", "q1": q1, "q2": q2, "x1": x1, "x2": x2})
        }
        Distribution::Point { p, x } => json!({"m": l.member, "type": "point", "axes": "global", "P": p, "x": x}),
    };
    let member = |(n, m): (usize, &Member)| {
        let mut o = json!({"n": m.nodes, "mat": m.material, "sec": m.section, "releases": {"i": bits(&m.releases[0]), "j": bits(&m.releases[1])}});
        if let Some(r) = m.reference {
            o["ref"] = json!(r);
        }
        if let Some(element) = frame.elements.get(n) {
            let stick = element.member as usize;
            o["stick"] = json!(stick);
            o["role"] = json!(frame.members[stick].role.name());
            o["offset"] = json!(offsets[stick].map(|c| (c * 1e4).round() / 1e4 + 0.0));
        }
        o
    };
    let panels = [PanelKind::Wall, PanelKind::Deck, PanelKind::Roof]
        .map(|k| frame.panels.iter().filter(|p| p.kind == k).count());
    json!({
        "schema": "houscaper.frame/1",
        "units": "N, m, kg",
        "source": format!("elements 0..{}, then braces for sheathing: {} wall, {} deck, {} roof; offset: from the axis to the centre line of the timber, m, global axes, stated and not analysed", frame.elements.len(), panels[0], panels[1], panels[2]),
        "nodes": model.nodes,
        "materials": model.materials.iter().map(|m| json!({"E": m.e, "G": m.g, "rho": m.rho})).collect::<Vec<_>>(),
        "sections": model.sections.iter().map(|s| json!({"A": s.a, "Iy": s.iy, "Iz": s.iz, "J": s.j})).collect::<Vec<_>>(),
        "members": model.members.iter().enumerate().map(member).collect::<Vec<_>>(),
        "supports": model.supports.iter().map(|s| json!({"node": s.node, "fix": bits(&s.fix)})).collect::<Vec<_>>(),
        "cases": cases.iter().map(|c| json!({"name": c.name, "gravity": c.gravity, "member": c.members.iter().map(load).collect::<Vec<_>>()})).collect::<Vec<_>>(),
    })
}
