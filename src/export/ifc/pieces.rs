//! The products of a house from its solids: the pieces of every cube, gathered by part and role.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::IfcError;
use super::role::Role;
use crate::envelope::{Fabric, PlacedBlock, Solid};
use crate::export::{MaterialLook, Palette, layer_material};
use crate::parts::{Marks, Parts};
use crate::tiles::Component;
use crate::voxels::STOREY_MODULES;

/// What tells products apart: part, role, and the level of what belongs to no part.
pub(super) type Key = (Option<u32>, Role, u16);

/// A body of a product: one component in one look.
pub(super) struct Body {
    pub look: MaterialLook,
    /// m, in the coordinates of the house.
    pub vertices: Vec<[f64; 3]>,
    pub triangles: Vec<[u32; 3]>,
    /// Whether its triangles enclose it.
    pub closed: bool,
}

/// A product before it is written.
#[derive(Default)]
pub(super) struct Shape {
    pub bodies: Vec<Body>,
    /// Volume of its solids, m3; `None` for what is drawn as a surface.
    pub volume_m3: Option<f64>,
    /// Whether some of it is drawn as a surface.
    pub surface: bool,
    /// How much of each component it holds, m3 or m2: what take-off rows are shared out by.
    pub holds: BTreeMap<Component, f64>,
}

/// A piece in its cube, for rows of the take-off that were measured there.
pub(super) struct Piece {
    pub key: Key,
    pub component: Component,
    pub weight: f64,
}

/// All products made of solids, and the pieces of each cube.
#[derive(Default)]
pub(super) struct Shapes {
    pub products: BTreeMap<Key, Shape>,
    pub by_cube: BTreeMap<[usize; 3], Vec<Piece>>,
}

/// Storey level of a voxel layer.
pub(super) fn level_of(k: i32) -> u16 {
    (k.max(0) as usize / STOREY_MODULES) as u16
}

/// The key of a component of a part, or of site work at a voxel layer.
pub(super) fn key_of(cut: &Parts, part: Option<u32>, component: Component, k: i32) -> Key {
    let owner = part.and_then(|n| cut.parts.get(n as usize));
    let role = Role::of(component, owner, owner.map_or(&[], |p| cut.cells_of(p)));
    match owner {
        Some(p) => (part, role, p.level),
        None => (None, role, level_of(k)),
    }
}

/// The window or door that a reveal or sill lines: there they are weighed and bought, and without them the opening in the wall is empty.
fn lined_by(fabric: &Fabric, cut: &Parts, block: &PlacedBlock) -> Option<u32> {
    if !matches!(block.component, Component::Reveal | Component::Sill) {
        return None;
    }
    let [Ok(x), Ok(y), Ok(z)] = block.voxel.map(usize::try_from) else { return None };
    cut.of([x, y, z], Component::WindowFrame, fabric.centre_m(block)).map(|part| part.0)
}

impl Shapes {
    /// Adds the solids of a fabric.
    ///
    /// # Errors
    /// Blocks that overlap.
    pub fn add_fabric(&mut self, fabric: &Fabric, cut: &Parts, palette: &Palette) -> Result<(), IfcError> {
        let stretch: f64 = fabric.scale.iter().product();
        let mut groups: BTreeMap<(Key, u32), Vec<&PlacedBlock>> = BTreeMap::new();
        for (block, part) in fabric.placed.iter().zip(cut.of_fabric(fabric)) {
            let lining = lined_by(fabric, cut, block);
            let key = key_of(cut, lining.or(part.map(|p| p.0)), block.component, block.voxel[2]);
            groups.entry((key, block.layer)).or_default().push(block);
            // Blocks that belong to no cube, as those of stairs, stand for themselves.
            let near = [0, 1, 2].map(|a| block.voxel[a] - block.cube[a] as i32);
            if near.iter().all(|d| (-1..=0).contains(d)) {
                let tile = &fabric.tiles[block.tile as usize].1;
                let weight = tile.six_volumes(block.block as usize).unsigned_abs() as f64 / 6e18 * stretch;
                let cube = block.cube.map(|c| c as usize);
                let pieces = self.by_cube.entry(cube).or_default();
                match pieces.iter_mut().find(|p| (p.key, p.component) == (key, block.component)) {
                    Some(piece) => piece.weight += weight,
                    None => pieces.push(Piece { key, component: block.component, weight }),
                }
            }
        }
        let groups: Vec<((Key, u32), Vec<&PlacedBlock>)> = groups.into_iter().collect();
        let solids: Result<Vec<Solid>, _> =
            groups.par_iter().map(|(_, blocks)| fabric.merge(blocks.iter().copied())).collect();
        for (((key, layer), _), solid) in groups.iter().zip(solids?) {
            if solid.faces.is_empty() {
                continue;
            }
            let layer = &fabric.layers[*layer as usize];
            let product = self.products.entry(*key).or_default();
            let volume = solid.volume_m3() * stretch;
            *product.volume_m3.get_or_insert(0.0) += volume;
            *product.holds.entry(layer.component).or_default() += volume.abs();
            product.bodies.push(Body {
                look: layer_material(layer, palette),
                vertices: solid.vertices.iter().map(|&v| fabric.metres(v)).collect(),
                triangles: solid.triangles().collect(),
                closed: solid.report().open_edges == 0,
            });
        }
        Ok(())
    }
}

/// Name of a product: the mark of its part, the mark and what it is on it, or `site` for what is built in place.
pub(super) fn name_of(cut: &Parts, marks: &Marks, (part, role, level): Key) -> String {
    let owner = part.and_then(|n| Some((cut.parts.get(n as usize)?, marks.piece.get(n as usize)?)));
    match owner {
        Some((part, mark)) if role.is_part(part.kind) => mark.clone(),
        Some((_, mark)) => format!("{mark}.{}", role.name()),
        None if level == 0 => format!("site.{}", role.name()),
        None => format!("site.{}.{level}", role.name()),
    }
}
