//! The envelope as a scene: a part for each surface in sober colours, openings set back and framed.

use serde_json::{Value, json};

use super::openings::{Setting, set_back};
use super::scene::{Grain, MaterialLook, Part, Scene};
use crate::envelope::{Mesh, Surface};

/// Material of window frames and mullions, after those of the surfaces.
const FRAME: usize = Surface::ALL.len();

/// How the openings of a house are drawn. The welded envelope stays what it is: this is only how it is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Showing {
    /// Distance of glass and door leaf behind the facade in m; 0 leaves them flush and unframed.
    pub reveal_m: f64,
    /// Grid of mullions in plan: a module line's x and y, and the module's x and y, in m.
    pub mullions: [[f64; 2]; 2],
}

impl Default for Showing {
    /// 120 mm reveals; mullions every 0.9 m, the first voxel centred at the origin.
    fn default() -> Self {
        Showing { reveal_m: 0.12, mullions: [[-0.45, -0.45], [0.9, 0.9]] }
    }
}

/// The look of a surface.
pub fn look(surface: Surface) -> MaterialLook {
    let name = surface.name();
    match surface {
        Surface::Wall => MaterialLook::matt(name, 0xD9C3A0, 0.85).with_grain(Grain::Cladding),
        Surface::Band => MaterialLook::matt(name, 0xB2946A, 0.85),
        Surface::Plinth => MaterialLook::matt(name, 0x7C7A76, 0.95),
        Surface::Window => MaterialLook::matt(name, 0x54707F, 0.12).with_grain(Grain::Glass),
        Surface::Door => MaterialLook::matt(name, 0x8A4B32, 0.6),
        Surface::PitchedRoof => MaterialLook::matt(name, 0xA35B44, 0.85).with_grain(Grain::Courses),
        Surface::FlatRoof => MaterialLook::matt(name, 0xA4A5A3, 0.95),
        Surface::Deck => MaterialLook::matt(name, 0xB08D65, 0.8).with_grain(Grain::Boards),
        Surface::Soffit => MaterialLook::matt(name, 0xC3A680, 0.85),
        Surface::Ground => MaterialLook::matt(name, 0x6B655C, 1.0),
    }
}

/// The envelope split by [`Surface`] into parts named like it, empty ones left out.
///
/// `extras` goes onto the scene; `surface_extras` is asked for each part (area, price line; `Value::Null` for nothing).
/// Windows and doors are set back by `showing.reveal_m` with reveals of the wall's colour, and framed.
pub fn from_envelope(mesh: &Mesh, showing: Showing, extras: Value, surface_extras: impl Fn(Surface) -> Value) -> Scene {
    let mut materials: Vec<MaterialLook> = Surface::ALL.iter().map(|&s| look(s)).collect();
    materials.push(MaterialLook::matt("frame", 0x3E4347, 0.5));
    let mut parts: Vec<Part> = Surface::ALL.iter().map(|&s| split(mesh, s)).collect();
    for (part, surface) in parts.iter_mut().zip(Surface::ALL) {
        part.extras = surface_extras(surface);
    }
    if showing.reveal_m > 0.0 {
        frame_openings(&mut parts, showing);
    }
    parts.retain(|p| !p.triangles.is_empty());
    Scene { materials, parts, extras, ..Scene::default() }
}

fn frame_openings(parts: &mut Vec<Part>, showing: Showing) {
    let mut frame = Part::new("frame", FRAME);
    frame.extras = json!({ "shown": "window and door frames, not part of the envelope's volume" });
    let mut reveals = Part::default();
    for (surface, mullions) in [(Surface::Window, true), (Surface::Door, false)] {
        let part = &mut parts[surface as usize];
        let setting = Setting { depth_m: showing.reveal_m, bar_m: 0.06, grid: mullions.then_some(showing.mullions) };
        set_back(part, setting, &mut reveals, &mut frame);
    }
    parts[Surface::Wall as usize].append(&reveals);
    parts.push(frame);
}

/// The triangles of one surface with the vertices they use, in order of first use.
fn split(mesh: &Mesh, surface: Surface) -> Part {
    let mut part = Part::new(surface.name(), surface as usize);
    let mut place = vec![u32::MAX; mesh.vertices.len()];
    for (triangle, _) in mesh.triangles.iter().zip(&mesh.surfaces).filter(|(_, s)| **s == surface) {
        let corners = triangle.map(|v| {
            if place[v as usize] == u32::MAX {
                place[v as usize] = part.vertices.len() as u32;
                part.vertices.push(mesh.vertices[v as usize]);
            }
            place[v as usize]
        });
        part.triangles.push(corners);
    }
    part
}
