//! Colours of the components: those of a style's manifest, and usual ones where it names none.

use std::collections::BTreeMap;

use super::colour::hex;
use super::scene::{Grain, MaterialLook};
use crate::tiles::{Component, Grain as StyleGrain, Look};

/// How a component looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComponentLook {
    /// Colour in sRGB, 0 to 255.
    pub srgb: [u8; 3],
    /// 0 mirror to 1 chalk.
    pub roughness: f64,
    /// 0 dielectric to 1 metal.
    pub metallic: f64,
    /// Pattern drawn in pictures.
    pub grain: Grain,
    /// 0 clear to 1 opaque.
    pub opacity: f64,
}

/// A look for each component; those that a style does not name look as in [`Palette::default`].
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    looks: BTreeMap<Component, ComponentLook>,
}

impl Default for Palette {
    /// Light render, clay tiles, an oak door, dark frames.
    fn default() -> Self {
        Palette { looks: Component::ALL.iter().map(|&c| (c, usual(c))).collect() }
    }
}

impl Palette {
    /// The look of a component.
    pub fn look(&self, component: Component) -> ComponentLook {
        self.looks.get(&component).copied().unwrap_or_else(|| usual(component))
    }

    /// Gives a component a look.
    pub fn set(&mut self, component: Component, look: ComponentLook) {
        self.looks.insert(component, look);
    }

    /// The looks that a style's manifest gives; a colour that is no `#rrggbb` keeps the usual one.
    pub fn of_looks(looks: &[(Component, Look)]) -> Palette {
        let mut palette = Palette::default();
        for (component, look) in looks {
            let srgb = look.srgb.strip_prefix('#').and_then(|hex| u32::from_str_radix(hex, 16).ok());
            let Some(srgb) = srgb else { continue };
            let grain = match (look.grain, component) {
                _ if look.opacity < 1.0 => Grain::Glass,
                (StyleGrain::None, _) => Grain::Plain,
                (_, Component::DeckBoards | Component::FloorBoards) => Grain::Boards,
                (StyleGrain::Horizontal, _) => Grain::Courses,
                (StyleGrain::Vertical, _) => Grain::Cladding,
            };
            let look = ComponentLook {
                roughness: look.roughness,
                metallic: look.metallic,
                opacity: look.opacity,
                grain,
                ..paint(srgb, 1.0)
            };
            palette.set(*component, look);
        }
        palette
    }

    /// The material of a component, named like it.
    pub fn material(&self, component: Component) -> MaterialLook {
        let look = self.look(component);
        let mut material = MaterialLook::matt(component.name(), hex(look.srgb), look.roughness).with_grain(look.grain);
        material.metallic = look.metallic;
        material.rgba[3] = look.opacity.clamp(0.0, 1.0);
        material
    }
}

fn paint(rgb: u32, roughness: f64) -> ComponentLook {
    let srgb = [16, 8, 0].map(|shift| (rgb >> shift & 255) as u8);
    ComponentLook { srgb, roughness, metallic: 0.0, grain: Grain::Plain, opacity: 1.0 }
}

impl ComponentLook {
    fn grain(self, grain: Grain) -> Self {
        ComponentLook { grain, ..self }
    }

    fn metal(self, metallic: f64) -> Self {
        ComponentLook { metallic, ..self }
    }

    fn clear(self, opacity: f64) -> Self {
        ComponentLook { grain: Grain::Glass, opacity, ..self }
    }
}

fn usual(component: Component) -> ComponentLook {
    match component {
        Component::Cladding => paint(0xE9E3D6, 0.9),
        Component::Band => paint(0xD8D0BF, 0.9),
        Component::WallInsulation | Component::RoofInsulation => paint(0xD9C08A, 1.0),
        Component::FlatInsulation | Component::SoffitInsulation => paint(0xE3D3A3, 1.0),
        Component::WallLining | Component::RoofLining | Component::Ceiling => paint(0xF1EEE8, 0.95),
        Component::RoofCovering => paint(0xA4553C, 0.85).grain(Grain::Courses),
        Component::FlatMembrane => paint(0x9C9D9B, 0.95),
        Component::DeckBoards => paint(0xA98360, 0.85).grain(Grain::Boards),
        Component::Paving => paint(0xA9A59C, 0.95),
        Component::FloorBoards => paint(0xB88F62, 0.6).grain(Grain::Boards),
        Component::FloorStructure => paint(0xC9A876, 0.9),
        Component::SoffitBoards => paint(0xC7AE8C, 0.85),
        Component::GroundSlab | Component::PerimeterBeam => paint(0x9A9995, 0.95),
        Component::GroundInsulation | Component::PlinthInsulation => paint(0x8FA9B8, 1.0),
        Component::PlinthRender => paint(0x8C8A85, 0.95),
        Component::Fascia => paint(0xEDEAE2, 0.8),
        Component::Gutter => paint(0x8F979C, 0.4).metal(0.8),
        Component::Coping => paint(0x6E7376, 0.5).metal(0.6),
        Component::WindowFrame | Component::DoorFrame => paint(0x33383C, 0.5),
        Component::Glass => paint(0x5E7A86, 0.06).clear(0.45),
        Component::DoorLeaf => paint(0x8C6239, 0.6),
        Component::Handle => paint(0xB8B8B4, 0.3).metal(1.0),
        Component::Reveal => paint(0xDDD6C8, 0.85),
        Component::Sill => paint(0x8E9296, 0.5).metal(0.4),
        Component::RailingRail => paint(0x3C4044, 0.5).metal(0.5),
        Component::RailingGlass => paint(0x9DB5BC, 0.05).clear(0.25),
        Component::StairTread => paint(0xB08454, 0.6),
        Component::StairString => paint(0xE8E4DB, 0.8),
    }
}
