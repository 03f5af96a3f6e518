//! The frame as solids: four views in colour, the deformed shape, supports, and loads by case.

mod markers;
pub mod views;

use serde_json::json;

pub use views::legend;

use crate::export::{Part, Scene, bar_solid};
use crate::frame::{FrameMember, HouseFrame};
use crate::score::{Details, Evaluator, MemberCost};
use crate::structure::checks::Shape;
use crate::structure::{CrossSection, Deformed, Place, Review, SectionOption};

/// The largest displacement is drawn as about this share of the house's largest dimension.
const SHOWN_SHARE: f64 = 0.05;

/// What bends by less than this share of the largest displacement is drawn straight: 2 to 3 mm of what is seen.
const STRAIGHT_SHARE: f64 = 0.005;

/// How many times the deformed shape is drawn larger than it is: 1, 2 or 5 times a power of ten, so that a reader can divide.
pub fn deformation_scale(frame: &HouseFrame, deformed: &Deformed) -> f64 {
    let size = frame.size_m.into_iter().fold(0.0, f64::max);
    if deformed.largest_m <= 0.0 || size <= 0.0 {
        return 1.0;
    }
    let wanted = SHOWN_SHARE * size / deformed.largest_m;
    let power = 10f64.powf(wanted.log10().floor());
    // The nearest by ratio.
    let off = |scale: f64| (scale / wanted).max(wanted / scale);
    [1.0, 2.0, 5.0, 10.0]
        .map(|step| step * power)
        .into_iter()
        .min_by(|a, b| off(*a).total_cmp(&off(*b)))
        .unwrap_or(power)
}

/// A part for each member with its id, role, section, length, mass, utilisation and forces in `extras`, coloured by utilisation; further
/// views by axial force, role and material; the deformed shape where there is a review; supports.
pub fn frame_scene(
    frame: &HouseFrame,
    details: &Details,
    evaluator: &Evaluator,
    sections: &[SectionOption; 4],
    review: Option<&Review>,
) -> Scene {
    let looks = views::Looks::new(&evaluator.catalogue.materials);
    let mut scene = Scene { materials: looks.looks.clone(), extras: about(frame, review), ..Scene::default() };
    scene.views = views::VIEWS.map(str::to_owned).to_vec();
    let scale = review.map(|r| deformation_scale(frame, &r.deformed));
    scene.shape = review.zip(scale).map(|(r, scale)| {
        format!("deformed x {scale}: {}, largest {:.1} mm", r.deformed.combination, 1e3 * r.deformed.largest_m)
    });
    let results = details.evaluation.assessment.as_ref().map_or(&[][..], |a| &a.members);
    for (id, member) in frame.members.iter().enumerate() {
        let option = sections[member.group as usize];
        let (section, material) = (evaluator.catalogue.section(option), evaluator.catalogue.material(option));
        let utilisation = results.get(id).map_or(0.0, |r| r.utilisation);
        let own = review.and_then(|r| r.members.get(id));
        let places = review.map_or(Vec::new(), |r| bends(&r.deformed, id));
        let solid = shaped(member, section, &places, scale.unwrap_or(0.0));
        if solid.triangles.is_empty() {
            continue;
        }
        let seen = looks.of(utilisation, own.map_or(0.0, |m| m.axial_extreme_n()), member.role, option.material);
        let mut extras = json!({
            "member": id,
            "role": member.role.name(),
            "section": section.id,
            "material": material.id,
            "plies": member.plies,
            "length_m": member.length_m,
            "mass_kg": member.length_m * section.a * material.rho * f64::from(member.plies),
            "utilisation": utilisation,
        });
        if let Some(own) = own {
            extras["axial_kn"] = json!(own.axial_n.map(|n| n / 1e3));
            if let Some(g) = own.governing {
                extras["check"] = json!(format!("{} ({})", g.checked.clause.name(), g.checked.clause.number()));
            }
        }
        let name = format!("{} {id}", member.role.name());
        scene.parts.push(Part { name, material: seen[0], views: seen, extras, ..solid });
    }
    let tips = frame.supports.iter().map(|&n| frame.nodes[n as usize]);
    let supports = markers::pyramids(looks.support, tips);
    let extras = json!({"count": frame.supports.len(), "held": "ux uy uz; sticks end there with hinges"});
    scene.parts.push(Part { extras, ..supports });
    scene
}

/// Adds the loads of every case as arrows, apart: a GLB shows each case in a scene of its own.
pub fn add_loads(scene: &mut Scene, frame: &HouseFrame, review: &Review) {
    let material = scene.materials.len();
    scene.materials.push(views::load_look());
    let centre = scene.bounds().map_or([0.0; 3], |[low, high]| [0, 1, 2].map(|a| 0.5 * (low[a] + high[a])));
    for case in &review.drawn {
        let (part, m_per_kn) = markers::arrows(case, material, centre);
        let extras = json!({
            "case": case.case,
            "values": "characteristic; one arrow a member, the resultant on it",
            "m_per_kn": m_per_kn,
            "sum_kn": case.sum_n.map(|n| n / 1e3),
            "members": frame.members.len(),
        });
        scene.parts.push(Part { extras, is_apart: true, ..part });
    }
}

/// Adds to each member the line of the bill that it belongs to and its part of that line; `costs` in the order of the frame.
pub fn add_costs(scene: &mut Scene, costs: &[MemberCost]) {
    for part in &mut scene.parts {
        let own = part.extras["member"].as_u64().and_then(|id| costs.get(id as usize)).filter(|cost| cost.line > 0);
        if let Some(MemberCost { line, price, gwp_kgco2e, .. }) = own {
            part.extras["price_line"] = json!(line);
            part.extras["price_eur"] = json!(price);
            part.extras["gwp_kgco2e"] = json!(gwp_kgco2e);
        }
    }
}

/// What the scene says of itself.
fn about(frame: &HouseFrame, review: Option<&Review>) -> serde_json::Value {
    let mut about = json!({
        "schema": "houscaper.frame-view/1",
        "colour": "largest utilisation of the member over all combinations",
        "views": {
            "utilisation": "largest ratio of the member's checks over all ultimate combinations",
            "axial force": "axial force of largest magnitude over all ultimate combinations, blue compression, red tension",
            "role": "what the member is",
            "material": "what it is made of",
        },
        "not_drawn": "boards on walls, decks and roofs, which brace the frame; connections",
    });
    if let Some(r) = review {
        about["deformed"] = json!({
            "combination": format!("{}, characteristic, elastic, without creep", r.deformed.combination),
            "scale": deformation_scale(frame, &r.deformed),
            "largest_mm": 1e3 * r.deformed.largest_m,
            "member": r.deformed.member,
            "at_m": r.deformed.at_m,
        });
    }
    about
}

/// The places of a member between which it is drawn straight: what lies off by less than [`STRAIGHT_SHARE`] of the largest
/// displacement is left out, so that a plate that only moves along needs its ends alone.
fn bends(deformed: &Deformed, member: usize) -> Vec<Place> {
    let Some(places) = deformed.members.get(member).filter(|p| !p.is_empty()) else { return Vec::new() };
    let mut kept = vec![false; places.len()];
    (kept[0], kept[places.len() - 1]) = (true, true);
    let mut open = vec![(0, places.len() - 1)];
    while let Some((from, to)) = open.pop() {
        let (a, b) = (&places[from], &places[to]);
        let reach = |p: &Place| (0..3).map(|x| (p.at_m[x] - a.at_m[x]).powi(2)).sum::<f64>().sqrt();
        let whole = reach(b).max(1e-9);
        let off = |p: &Place| {
            let t = reach(p) / whole;
            let d = |x: usize| p.moves_m[x] - a.moves_m[x] - t * (b.moves_m[x] - a.moves_m[x]);
            (0..3).map(|x| d(x).powi(2)).sum::<f64>().sqrt()
        };
        // The first of equals.
        let worst = (from + 1..to).map(|n| (off(&places[n]), n)).fold((0.0, 0), |w, o| if o.0 > w.0 { o } else { w });
        if worst.0 > STRAIGHT_SHARE * deformed.largest_m {
            kept[worst.1] = true;
            open.extend([(from, worst.1), (worst.1, to)]);
        }
    }
    places.iter().zip(kept).filter(|(_, keep)| *keep).map(|(p, _)| *p).collect()
}

/// A member in the shape of its section, with the moves of the deformed shape, `scale` times, where places along it are known.
fn shaped(member: &FrameMember, section: &CrossSection, places: &[Place], scale: f64) -> Part {
    let up = member.reference.unwrap_or([0.0, 0.0, 1.0]);
    let stations: Vec<[f64; 3]> =
        if places.is_empty() { member.ends.to_vec() } else { places.iter().map(|p| p.at_m).collect() };
    let mut part = Part::default();
    for [across, along, width, depth] in outline(section, f64::from(member.plies)) {
        let mut bar = bar_solid(&stations, up, width, depth);
        if bar.triangles.is_empty() {
            return part;
        }
        shift(&mut bar, [across, along]);
        part.append(&bar);
        part.moves.extend(places.iter().flat_map(|p| [p.moves_m.map(|c| scale * c); 4]));
    }
    part
}

/// Rectangles that make up a section of some plies side by side: centre across and along the depth, width, depth, m. A hollow section
/// is drawn by its outline.
fn outline(section: &CrossSection, plies: f64) -> Vec<[f64; 4]> {
    let Shape::I { b, h, tw, tf, .. } = section.properties.shape else {
        return vec![[0.0, 0.0, plies * section.b, section.h]];
    };
    let one = |x: f64| {
        let flange = 0.5 * (h - tf);
        [[x, flange, b, tf], [x, -flange, b, tf], [x, 0.0, tw, h - 2.0 * tf]]
    };
    if plies > 1.5 { [one(-0.5 * b), one(0.5 * b)].concat() } else { one(0.0).to_vec() }
}

/// Moves a bar across its axis: along its width and depth, which its first four vertices span.
fn shift(bar: &mut Part, [across, along]: [f64; 2]) {
    if across == 0.0 && along == 0.0 {
        return;
    }
    let [a, b, c] = [0, 1, 2].map(|n| bar.vertices[n]);
    let unit = |from: [f64; 3], to: [f64; 3]| {
        let d: [f64; 3] = std::array::from_fn(|x| to[x] - from[x]);
        let length = d.iter().map(|c| c * c).sum::<f64>().sqrt();
        d.map(|c| c / length)
    };
    let (y, z) = (unit(a, b), unit(b, c));
    for v in &mut bar.vertices {
        (0..3).for_each(|x| v[x] += across * y[x] + along * z[x]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(size: f64) -> HouseFrame {
        HouseFrame { size_m: [size, 1.0, 1.0], ..HouseFrame::default() }
    }

    /// The scale is round and shows a twentieth of the house within a factor of the square root of 2.5.
    #[test]
    fn scales_are_round_and_show_enough() {
        for mm in [0.07, 0.5, 1.0, 3.3, 12.0, 47.0] {
            let deformed = Deformed { largest_m: 1e-3 * mm, ..Deformed::default() };
            let scale = deformation_scale(&frame(9.0), &deformed);
            let shown = scale * 1e-3 * mm / 9.0;
            assert!((0.0316..0.0791).contains(&shown), "{mm} mm x {scale}: {shown}");
            let lead = scale / 10f64.powf(scale.log10().floor());
            assert!([1.0, 2.0, 5.0].iter().any(|s| (lead / s - 1.0).abs() < 1e-9), "{scale}");
        }
        assert_eq!(deformation_scale(&frame(9.0), &Deformed::default()), 1.0);
    }

    /// A member that only moves along keeps its ends, one that sags enough places, and the farthest is always among them.
    #[test]
    fn straight_members_keep_their_ends() {
        let place = |x: f64, z: f64| Place { at_m: [x, 0.0, 0.0], moves_m: [0.0, 0.0, z] };
        let line = |sag: f64| {
            (0..=8).map(|n| place(f64::from(n), 0.01 * f64::from(n) - sag * f64::from(n * (8 - n)))).collect()
        };
        let deformed = Deformed {
            members: vec![line(0.0), line(1e-3), line(1e-6), Vec::new()],
            largest_m: 0.08,
            ..Deformed::default()
        };
        assert_eq!([0, 1, 2, 3].map(|m| bends(&deformed, m).len()), [2, 9, 2, 0]);
        let coarse = Deformed { largest_m: 0.8, ..deformed };
        let kept: Vec<f64> = bends(&coarse, 1).iter().map(|p| p.at_m[0]).collect();
        assert_eq!(kept, [0.0, 4.0, 8.0]);
    }

    /// An I section is drawn with the area of its plates.
    #[test]
    fn an_i_section_is_drawn_as_one() {
        let plates = |list: Vec<[f64; 4]>| list.iter().map(|r| r[2] * r[3]).sum::<f64>();
        let configs = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"));
        let catalogue = crate::structure::Catalogue::load(configs).expect("our catalogue");
        let section = catalogue.sections.iter().find(|s| s.family == "i").expect("an I section");
        let drawn = plates(outline(section, 1.0));
        // Without the fillets.
        assert!(drawn < section.a && drawn > 0.9 * section.a, "{drawn} of {}", section.a);
        assert!((plates(outline(section, 2.0)) - 2.0 * drawn).abs() < 1e-12);
    }
}
