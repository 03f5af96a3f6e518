//! The products of a house of a surface tileset: its welded surface by part and role, and what a surface lacks: inner floors and stairs.

use std::collections::BTreeMap;

use super::pieces::{Body, Key, Piece, Shapes, key_of};
use crate::envelope::{CUBE_UM, Fabric, Mesh, Surface, house_stairs};
use crate::export::look;
use crate::parts::{PartKind, Parts};
use crate::tiles::solids::SolidStyle;
use crate::tiles::{Block, Component, Shells, depth_um};
use crate::voxels::{Direction, House, Reading};

/// What of a house a surface belongs to.
fn component(surface: Surface) -> Component {
    match surface {
        Surface::Wall => Component::Cladding,
        Surface::Band => Component::Band,
        Surface::Plinth => Component::PlinthRender,
        Surface::Window => Component::Glass,
        Surface::Door => Component::DoorLeaf,
        Surface::PitchedRoof => Component::RoofCovering,
        Surface::FlatRoof => Component::FlatMembrane,
        Surface::Deck => Component::DeckBoards,
        Surface::Soffit => Component::SoffitBoards,
        Surface::Ground => Component::GroundSlab,
    }
}

impl Shapes {
    /// Adds the triangles of a welded surface. Each belongs to the filled voxel behind it.
    pub fn add_surface(&mut self, mesh: &Mesh, house: &House, cut: &Parts) {
        let (origin, size) = (house.voxels.origin_m, house.voxels.module.size_m);
        let mut sheets: BTreeMap<(Key, Surface), (Body, BTreeMap<u32, u32>)> = BTreeMap::new();
        for (triangle, &surface) in mesh.triangles.iter().zip(&mesh.surfaces) {
            let corners = triangle.map(|v| mesh.vertices[v as usize]);
            let [a, b, c] = corners;
            let centre = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
            let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
            let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let double = normal[0].hypot(normal[1]).hypot(normal[2]);
            if double <= 0.0 {
                continue;
            }
            let voxel = behind(house, centre, normal.map(|n| n / double));
            let component = component(surface);
            let part = cut.of(voxel, component, centre).map(|p| p.0);
            let key = key_of(cut, part, component, voxel[2] as i32);
            let new =
                || (Body { look: look(surface), vertices: vec![], triangles: vec![], closed: false }, BTreeMap::new());
            let (body, places) = sheets.entry((key, surface)).or_insert_with(new);
            let corners = triangle.map(|v| {
                *places.entry(v).or_insert_with(|| {
                    body.vertices.push(mesh.vertices[v as usize]);
                    body.vertices.len() as u32 - 1
                })
            });
            body.triangles.push(corners);
            let area = 0.5 * double;
            let product = self.products.entry(key).or_default();
            product.surface = true;
            *product.holds.entry(component).or_default() += area;
            // Cube (i, j, k) of the padded array begins at the centre of voxel (i - 1, j - 1, k - 1).
            let cube = [0, 1, 2].map(|i| (((centre[i] - origin[i]) / size[i]).floor() + 1.0).max(0.0) as usize);
            self.by_cube.entry(cube).or_default().push(Piece { key, component, weight: area });
        }
        for ((key, _), (body, _)) in sheets {
            self.products.entry(key).or_default().bodies.push(body);
        }
    }
}

/// The filled voxel behind a point of the surface: the nearest on the way inwards, else the one that holds the point.
fn behind(house: &House, at: [f64; 3], normal: [f64; 3]) -> [usize; 3] {
    let (origin, size) = (house.voxels.origin_m, house.voxels.module.size_m);
    let voxel = |depth: f64| [0, 1, 2].map(|i| ((at[i] - depth * normal[i] - origin[i]) / size[i]).round());
    let filled = |v: &[f64; 3]| house.voxels.at(v.map(|c| c as isize)).is_filled();
    let depths = [0.02, 0.1, 0.2, 0.3, 0.45];
    let found = depths.iter().map(|&d| voxel(d)).find(filled);
    found.unwrap_or_else(|| voxel(0.02)).map(|c| c.max(0.0) as usize)
}

/// Stairs, for houses whose tileset draws none, in a fabric of their own: as a style draws them.
pub(super) fn stairs(house: &House, reading: &Reading) -> Fabric {
    standing(house, house_stairs(house, reading, &SolidStyle::default()).concat())
}

/// Floor cassettes for a surface, which has none inside: their cells in the depth of the floor's build-up, ending a wall's thickness inside
/// the edge of their plate.
pub(super) fn floors(house: &House, cut: &Parts, shells: &Shells) -> Fabric {
    let half = CUBE_UM.map(|um| um as i32 / 2);
    // A cassette hangs in the lower half of its voxel, where its part is looked for.
    let depth = depth_um(&shells.floor).clamp(1, half[2]);
    let wall = ((cut.wall_mm * 1e3) as i32).clamp(0, half[0] / 2);
    let floors = cut.parts.iter().filter(|p| p.kind == PartKind::Floor);
    let blocks = floors.flat_map(|part| cut.cells_of(part)).map(|cell| {
        let at = [cell.cell[0], cell.cell[1], cell.k].map(i32::from);
        let centre = [0, 1, 2].map(|a| 2 * half[a] * at[a]);
        let reach = |d: Direction| {
            let [dx, dy] = d.step();
            let beyond = [at[0] as isize + dx, at[1] as isize + dy, at[2] as isize];
            half[0] - if house.voxels.at(beyond).is_filled() { 0 } else { wall }
        };
        let [east, north, west, south] = Direction::ALL.map(reach);
        let low = [centre[0] - west, centre[1] - south, centre[2] - depth];
        Block::cuboid(Component::FloorStructure, 0, low, [centre[0] + east, centre[1] + north, centre[2]])
    });
    standing(house, blocks.collect())
}

fn standing(house: &House, blocks: Vec<Block>) -> Fabric {
    let mut fabric = Fabric::new(&house.voxels, [], |_| [].into());
    fabric.add_standing(&blocks);
    fabric
}
