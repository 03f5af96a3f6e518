//! Pictures of single tiles in their cage and of neighbourhoods of tiles, for contact sheets of tilesets.

use super::fabric_scene::layer_material;
use super::palette::Palette;
use super::picture::{Image, Picture, PictureError, View, render};
use super::scene::{MaterialLook, Part, Scene};
use crate::cubes::{Corner, Mask};
use crate::envelope::{CubeTile, FabricLayer};
use crate::tiles::{Body, Component, PatchKind, Tileset};

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

/// The pieces of one cube in its cage.
pub fn solid_tile(tile: &CubeTile, mask: Mask, palette: &Palette) -> Scene {
    let mut scene = stage();
    scene.parts.push(cage([0.9, 0.9, 0.54], mask));
    let first = scene.materials.len();
    add_pieces(&mut scene, first, [0.0; 3], tile, palette);
    scene.parts.retain(|p| !p.triangles.is_empty());
    scene
}

/// The bodies of a mesh tile in their cage of `size` m, scaled so that the cage is as wide as a module of 0.9 m; each of the set's layers
/// in its own material.
pub fn body_tile(bodies: &[Body], size: [f64; 3], mask: Mask, layers: &[FabricLayer]) -> Scene {
    let scale = 0.9 / size[0].max(1e-9);
    let mut scene = stage();
    scene.parts.push(cage(size.map(|m| m * scale), mask));
    for layer in layers {
        scene.parts.push(Part::new(&layer.name, scene.materials.len()));
        scene.materials.push(layer_material(layer, &Palette::default()));
    }
    for body in bodies {
        let material = 1 + body.layer;
        let Some(part) = scene.parts.iter_mut().find(|p| p.material == material) else { continue };
        body.triangles().for_each(|t| part.polygon(&t.map(|p| p.map(|um| f64::from(um) * 1e-6 * scale))));
    }
    scene.parts.retain(|p| !p.triangles.is_empty());
    scene
}

/// Adds a part and a material for each component.
fn add_materials(scene: &mut Scene, palette: &Palette) {
    for &component in Component::ALL {
        scene.parts.push(Part::new(component.name(), scene.materials.len()));
        scene.materials.push(palette.material(component));
    }
}

/// The pieces of many cubes; `cubes` gives the first corner of each in m with its tile.
pub fn neighbourhood(cubes: impl IntoIterator<Item = ([f64; 3], CubeTile)>, palette: &Palette) -> Scene {
    let mut scene = stage();
    let first = scene.materials.len();
    for (at, tile) in cubes {
        add_pieces(&mut scene, first, at, &tile, palette);
    }
    scene.parts.retain(|p| !p.triangles.is_empty());
    scene
}

/// Adds pieces to a scene whose materials from `first` on are those of the components, one part for each.
fn add_pieces(scene: &mut Scene, first: usize, at: [f64; 3], tile: &CubeTile, palette: &Palette) {
    if scene.materials.len() == first {
        add_materials(scene, palette);
    }
    let place = |p: [i32; 3]| [0, 1, 2].map(|a| at[a] + f64::from(p[a]) / 1e6);
    for n in 0..tile.len() {
        let material = first + tile.kind(n).0 as usize;
        let Some(part) = scene.parts.iter_mut().find(|p| p.material == material) else { continue };
        match tile {
            CubeTile::Blocks(blocks) => {
                blocks[n].faces().into_iter().for_each(|f| part.polygon(&f.into_iter().map(place).collect::<Vec<_>>()));
            }
            // Faces of meshes need not be convex.
            CubeTile::Bodies(bodies) => bodies[n].triangles().for_each(|t| part.polygon(&t.map(place))),
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
    let elevation_deg = if from_below { -28.0 } else { 34.0 };
    let picture = Picture {
        size: TILE,
        // Canonical tiles fill the corners towards the west and south: from the north-east one sees their outside.
        view: View { azimuth_deg: 52.0, elevation_deg, field_deg: None },
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
