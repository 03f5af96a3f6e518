//! Pictures of single tiles in their cage and of neighbourhoods of tiles, for contact sheets of tilesets.

use super::picture::{Image, Picture, PictureError, View, render};
use super::scene::{Grain, MaterialLook, Part, Scene};
use crate::cubes::{Corner, Mask};
use crate::tiles::{Block, Component, PatchKind, Tileset};

/// Size of a tile's picture in pixels.
const TILE: [usize; 2] = [300, 240];
/// Size of a neighbourhood's picture in pixels.
const NEIGHBOURHOOD: [usize; 2] = TILE;
/// Thickness of the cage's bars and edge of its corner marks, m.
const BAR_M: f64 = 0.008;
const MARK_M: f64 = 0.075;

/// Colour of a kind of surface, sRGB.
fn patch_look(kind: PatchKind) -> MaterialLook {
    let srgb = match kind {
        PatchKind::Roof => 0xB0604A,
        PatchKind::Wall => 0xDCC7A4,
        PatchKind::Soffit => 0x7F9BAA,
        PatchKind::Deck => 0x9A7B52,
    };
    MaterialLook { double_sided: true, ..MaterialLook::matt(kind.name(), srgb, 0.85) }
}

/// The look of a building component on a sheet: strata told apart, families of like colour.
pub fn component_look(component: Component) -> MaterialLook {
    use Component as C;
    let name = component.name();
    let matt = |srgb| MaterialLook::matt(name, srgb, 0.85);
    match component {
        C::Cladding => matt(0xD9C3A0),
        C::Band => matt(0xB2946A),
        C::WallInsulation | C::RoofInsulation | C::FlatInsulation | C::SoffitInsulation => matt(0xE8CF6A),
        C::GroundInsulation | C::PlinthInsulation => matt(0xD6A8C0),
        C::WallLining | C::RoofLining | C::Ceiling => matt(0xF1EEE8),
        C::RoofCovering => matt(0xA35B44),
        C::FlatMembrane => matt(0x55595C),
        C::DeckBoards => matt(0xA98258).with_grain(Grain::Boards),
        C::Paving => matt(0xB9B4AA),
        C::FloorBoards => matt(0xC39B6B),
        C::FloorStructure => matt(0xCFA876),
        C::SoffitBoards => matt(0xC3A680),
        C::GroundSlab | C::PerimeterBeam => matt(0x9D9C98),
        C::PlinthRender => matt(0x7C7A76),
        C::Fascia => matt(0xE3DED3),
        C::Gutter | C::Coping => matt(0x8D979E),
        C::WindowFrame | C::DoorFrame => matt(0x3E4347),
        C::Glass | C::RailingGlass => MaterialLook::matt(name, 0x7FA3B5, 0.12).with_grain(Grain::Glass),
        C::DoorLeaf => matt(0x8A4B32),
        C::Handle => matt(0xC8CCD0),
        C::Reveal => matt(0xEDE6D8),
        C::Sill => matt(0x9AA0A4),
        C::RailingRail => matt(0x4A4F54),
        C::StairTread | C::StairString => matt(0xB98B57),
    }
}

/// A scene that starts with the material of the cage.
fn stage() -> Scene {
    Scene { materials: vec![MaterialLook::matt("cage", 0x4D6A8F, 0.9)], ..Scene::default() }
}

/// The surface of one configuration in its cage; patches coloured by kind, filled corners marked.
pub fn surface_tile(set: &Tileset, mask: Mask) -> Scene {
    let mut scene = stage();
    let size = set.module_mm().map(|mm| f64::from(mm) / 1e3);
    scene.parts.push(cage(size, mask));
    for kind in PatchKind::ALL {
        let mut part = Part::new(kind.name(), scene.materials.len());
        for patch in set.patches(mask).iter().filter(|p| p.kind == kind) {
            let first = part.vertices.len() as u32;
            part.vertices.extend(patch.polygon.iter().map(|p| p.map(|mm| f64::from(mm) / 1e3)));
            part.triangles.extend(patch.triangles.iter().map(|t| t.map(|i| first + u32::from(i))));
        }
        scene.materials.push(patch_look(kind));
        scene.parts.push(part);
    }
    scene
}

/// The solids of one cube in its cage.
pub fn solid_tile(blocks: &[Block], mask: Mask) -> Scene {
    let mut scene = stage();
    scene.parts.push(cage([0.9, 0.9, 0.54], mask));
    let first = scene.materials.len();
    add_blocks(&mut scene, first, [0.0; 3], blocks);
    scene.parts.retain(|p| !p.triangles.is_empty());
    scene
}

/// The solids of many cubes; `cubes` gives the first corner of each in m with its blocks.
pub fn neighbourhood(cubes: impl IntoIterator<Item = ([f64; 3], Vec<Block>)>) -> Scene {
    let mut scene = stage();
    let first = scene.materials.len();
    for (at, blocks) in cubes {
        add_blocks(&mut scene, first, at, &blocks);
    }
    scene.parts.retain(|p| !p.triangles.is_empty());
    scene
}

/// Adds blocks to a scene whose materials from `first` on are those of the components, one part for each.
fn add_blocks(scene: &mut Scene, first: usize, at: [f64; 3], blocks: &[Block]) {
    if scene.materials.len() == first {
        for &component in Component::ALL {
            scene.parts.push(Part::new(component.name(), scene.materials.len()));
            scene.materials.push(component_look(component));
        }
    }
    for block in blocks {
        let material = first + block.component as usize;
        let Some(part) = scene.parts.iter_mut().find(|p| p.material == material) else { continue };
        for face in block.faces() {
            let corners: Vec<[f64; 3]> =
                face.iter().map(|p| [0, 1, 2].map(|a| at[a] + f64::from(p[a]) / 1e6)).collect();
            part.polygon(&corners);
        }
    }
}

/// Twelve thin bars along the edges of a cube and a mark on each filled corner.
fn cage(size: [f64; 3], mask: Mask) -> Part {
    let mut part = Part::new("cage", 0);
    for axis in 0..3 {
        for corner in Corner::all().filter(|c| c.xyz()[axis] == 0) {
            let low = [0, 1, 2].map(|a| f64::from(corner.xyz()[a]) * size[a] - BAR_M / 2.0);
            let mut high = low.map(|v| v + BAR_M);
            high[axis] += size[axis];
            cuboid(&mut part, low, high);
        }
    }
    for corner in Corner::all().filter(|&c| mask.has(c)) {
        let low = [0, 1, 2].map(|a| f64::from(corner.xyz()[a]) * size[a] - MARK_M / 2.0);
        cuboid(&mut part, low, low.map(|v| v + MARK_M));
    }
    part
}

fn cuboid(part: &mut Part, low: [f64; 3], high: [f64; 3]) {
    let at = |n: usize| [0, 1, 2].map(|a| if n >> a & 1 == 0 { low[a] } else { high[a] });
    for face in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
        part.polygon(&face.map(at));
    }
}

/// The picture of a tile, all to one scale; undersides are seen from below the horizon of the cage.
///
/// # Errors
/// Those of [`render`].
pub fn tile_image(scene: &Scene, from_below: bool) -> Result<Image, PictureError> {
    let elevation_deg = if from_below { -28.0 } else { 40.0 };
    let picture = Picture {
        size: TILE,
        view: View { azimuth_deg: -60.0, elevation_deg, field_deg: None },
        ground_m: -50.0,
        person: false,
        fit: Some([[-0.15, -0.15, -0.12], [1.05, 1.05, 0.72]]),
        ..Picture::default()
    };
    render(scene, &picture)
}

/// The picture of a neighbourhood: the part of the scene in the box `fit` (m), seen from `azimuth_deg`.
///
/// # Errors
/// Those of [`render`].
pub fn neighbourhood_image(
    scene: &Scene,
    fit: Option<[[f64; 3]; 2]>,
    azimuth_deg: f32,
    ground_m: f64,
) -> Result<Image, PictureError> {
    let view = View { azimuth_deg, elevation_deg: 24.0, field_deg: None };
    render(scene, &Picture { size: NEIGHBOURHOOD, view, ground_m, person: false, fit, ..Picture::default() })
}
