//! Colours of the frame: by utilisation, axial force, role and material.

use crate::export::MaterialLook;
use crate::export::plots::Legend;
use crate::frame::Role;
use crate::structure::{MaterialKind, StructuralMaterial};

/// A colour with what it stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Class {
    /// sRGB, 0xRRGGBB.
    pub colour: u32,
    /// What it stands for.
    pub name: &'static str,
}

const fn class(colour: u32, name: &'static str) -> Class {
    Class { colour, name }
}

/// Names of the views, in the order of [`Classes::views`].
pub const VIEWS: [&str; 4] = ["utilisation", "axial force", "role", "material"];

/// Upper ends of the classes of utilisation.
const UTILISATION_ENDS: [f64; 5] = [0.2, 0.4, 0.6, 0.8, 1.0];

/// Blue to red through grey: safe for colour-blind eyes.
pub const UTILISATION: [Class; 6] = [
    class(0x2C5F9E, "utilisation 0.0-0.2"),
    class(0x6C9BC9, "utilisation 0.2-0.4"),
    class(0xB9C2C7, "utilisation 0.4-0.6"),
    class(0xE3B583, "utilisation 0.6-0.8"),
    class(0xCF7A45, "utilisation 0.8-1.0"),
    class(0x9E2A1F, "utilisation over 1.0"),
];

/// Ends of the classes of axial force, kN: the same for every house, so that pictures compare; each about three times the last.
const AXIAL_ENDS_KN: [f64; 4] = [1.0, 3.0, 10.0, 30.0];

/// Compression from much to little, little force, tension from little to much.
pub const AXIAL: [Class; 9] = [
    class(0x1F4E8C, "compression over 30 kN"),
    class(0x4F88BF, "compression 10-30 kN"),
    class(0x94BBDD, "compression 3-10 kN"),
    class(0xCFE0EE, "compression 1-3 kN"),
    class(0xF4F2EC, "axial force under 1 kN"),
    class(0xF5D6C6, "tension 1-3 kN"),
    class(0xE5A082, "tension 3-10 kN"),
    class(0xC85C47, "tension 10-30 kN"),
    class(0x8F1D22, "tension over 30 kN"),
];

/// A colour a role, in the order of [`Role::ALL`]: what stands is sand, plates and rails green, floors blue, beams red, roofs ochre
/// and violet.
const ROLE_COLOURS: [u32; 14] = [
    0xD9BE92, 0x9C6F3A, 0xC1955A, 0x8FA06C, 0x4F7A45, 0xBBC896, 0x8DB3D1, 0x3F74A3, 0x9B3D3D, 0xC9705F, 0xE0AE52,
    0xB0622B, 0x6B4A8B, 0x9A7BBA,
];

/// What the colours of the first two of [`VIEWS`] stand for, in words for a picture; `None` for the others, whose colours are names.
pub fn legend(view: usize) -> Option<Legend> {
    let (title, classes): (&str, &[Class]) = match view {
        0 => ("Utilisation: largest ratio of load to resistance, 1.0 is the limit", &UTILISATION),
        1 => ("Largest axial force in kN: compression blue, tension red", &AXIAL),
        _ => return None,
    };
    // The title says what the classes have in common.
    let common = ["utilisation ", "compression ", "axial force ", "tension "];
    let short = |name: &str| {
        let word = common.iter().find_map(|c| name.strip_prefix(c)).unwrap_or(name);
        word.trim_end_matches(" kN").to_owned()
    };
    let classes = classes.iter().map(|c| (c.colour, short(c.name))).collect();
    Some(Legend { title: title.to_owned(), classes })
}

/// The class of a utilisation.
pub fn of_utilisation(utilisation: f64) -> usize {
    UTILISATION_ENDS.iter().position(|end| utilisation <= *end).unwrap_or(UTILISATION_ENDS.len())
}

/// The class of an axial force, N, tension positive.
pub fn of_axial(force_n: f64) -> usize {
    let steps = AXIAL_ENDS_KN.iter().filter(|end| force_n.abs() / 1e3 > **end).count();
    if force_n < 0.0 { AXIAL_ENDS_KN.len() - steps } else { AXIAL_ENDS_KN.len() + steps }
}

/// The colour of a role.
pub fn of_role(role: Role) -> u32 {
    ROLE_COLOURS[role as usize]
}

/// The colour of a material: pale for sawn timber, darker for glulam, grey for steel, a shade by place in the catalogue.
pub fn of_material(material: &StructuralMaterial, index: usize) -> u32 {
    let shades: [u32; 3] = match material.kind {
        MaterialKind::Sawn => [0xE0C08C, 0xD4AE72, 0xC79C5B],
        MaterialKind::Glulam => [0xB07B3E, 0x9A6630, 0x855425],
        MaterialKind::Steel => [0x8A949C, 0x67737C, 0x4A545C],
    };
    shades[index % shades.len()]
}

/// The look of arrows.
pub fn load_look() -> MaterialLook {
    MaterialLook::matt("load", 0x2E7D6B, 0.8)
}

/// All looks of a frame in one list, so that parts can refer to them by number.
pub struct Looks {
    /// The materials of the scene.
    pub looks: Vec<MaterialLook>,
    axial: usize,
    roles: usize,
    materials: usize,
    /// Supports.
    pub support: usize,
}

impl Looks {
    /// The looks of every class, role and material of the catalogue.
    pub fn new(materials: &[StructuralMaterial]) -> Looks {
        let matt = |name: &str, colour: u32| MaterialLook::matt(name, colour, 0.8);
        let mut looks: Vec<MaterialLook> = UTILISATION.iter().map(|c| matt(c.name, c.colour)).collect();
        let axial = looks.len();
        looks.extend(AXIAL.iter().map(|c| matt(c.name, c.colour)));
        let roles = looks.len();
        looks.extend(Role::ALL.iter().map(|r| matt(r.name(), of_role(*r))));
        let first = looks.len();
        for (index, m) in materials.iter().enumerate() {
            let metallic = if m.kind == MaterialKind::Steel { 0.6 } else { 0.0 };
            looks.push(MaterialLook { metallic, ..matt(&m.id, of_material(m, index)) });
        }
        let support = looks.len();
        looks.push(matt("support", 0x3C4247));
        Looks { looks, axial, roles, materials: first, support }
    }

    /// The looks of a member in each of [`VIEWS`].
    pub fn of(&self, utilisation: f64, axial_n: f64, role: Role, material: usize) -> Vec<usize> {
        vec![
            of_utilisation(utilisation),
            self.axial + of_axial(axial_n),
            self.roles + role as usize,
            self.materials + material,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forces_fall_into_the_class_that_names_them() {
        for (kn, name) in [
            (-45.0, "compression over 30 kN"),
            (-30.0, "compression 10-30 kN"),
            (-1.0, "axial force under 1 kN"),
            (0.0, "axial force under 1 kN"),
            (1.1, "tension 1-3 kN"),
            (9.9, "tension 3-10 kN"),
            (31.0, "tension over 30 kN"),
        ] {
            assert_eq!(AXIAL[of_axial(1e3 * kn)].name, name, "{kn}");
        }
        assert_eq!([0.0, 0.2, 0.21, 1.0, 1.01].map(of_utilisation), [0, 0, 1, 4, 5]);
    }
}
