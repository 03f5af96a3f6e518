//! The frame as solids, coloured by utilisation.

use serde_json::json;

use crate::export::{MaterialLook, Part, Scene, beam_solid};
use crate::frame::HouseFrame;
use crate::score::{Details, Evaluator};
use crate::structure::SectionOption;

/// Upper ends of the colour classes, their colours (blue to red through grey: safe for colour-blind eyes) and names.
const CLASSES: [(f64, u32, &str); 6] = [
    (0.2, 0x2C5F9E, "utilisation 0.0-0.2"),
    (0.4, 0x6C9BC9, "utilisation 0.2-0.4"),
    (0.6, 0xB9C2C7, "utilisation 0.4-0.6"),
    (0.8, 0xE3B583, "utilisation 0.6-0.8"),
    (1.0, 0xCF7A45, "utilisation 0.8-1.0"),
    (f64::INFINITY, 0x9E2A1F, "utilisation over 1.0"),
];

/// A part for each member with its id, role, section, length, mass and utilisation in `extras`.
pub fn frame_scene(
    frame: &HouseFrame,
    details: &Details,
    evaluator: &Evaluator,
    sections: &[SectionOption; 4],
) -> Scene {
    let mut scene = Scene {
        materials: CLASSES.iter().map(|(_, colour, name)| MaterialLook::matt(name, *colour, 0.8)).collect(),
        parts: Vec::with_capacity(frame.members.len()),
        extras: json!({"schema": "houscaper.frame-view/1", "colour": "largest utilisation of the member over all combinations"}),
        ..Scene::default()
    };
    let results = details.evaluation.assessment.as_ref().map_or(&[][..], |a| &a.members);
    for (id, member) in frame.members.iter().enumerate() {
        let option = sections[member.group as usize];
        let (section, material) = (evaluator.catalogue.section(option), evaluator.catalogue.material(option));
        let utilisation = results.get(id).map_or(0.0, |r| r.utilisation);
        let up = member.reference.unwrap_or([0.0, 0.0, 1.0]);
        let width = section.b * f64::from(member.plies);
        let solid = beam_solid(member.ends[0], member.ends[1], up, width, section.h);
        if solid.triangles.is_empty() {
            continue;
        }
        scene.parts.push(Part {
            name: format!("{} {id}", member.role.name()),
            material: CLASSES.iter().position(|(end, _, _)| utilisation <= *end).unwrap_or(CLASSES.len() - 1),
            extras: json!({
                "member": id,
                "role": member.role.name(),
                "section": section.id,
                "material": material.id,
                "plies": member.plies,
                "length_m": member.length_m,
                "mass_kg": member.length_m * section.a * material.rho * f64::from(member.plies),
                "utilisation": utilisation,
            }),
            ..solid
        });
    }
    scene
}
