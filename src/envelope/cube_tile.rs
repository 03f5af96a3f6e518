//! What stands in one cube: constructed blocks, or the bodies of a mesh.

use std::sync::Arc;

use super::Merge;
use crate::tiles::{Block, Body, Component, LabelSet, Look};

/// The pieces of a cube.
#[derive(Clone, Debug, PartialEq)]
pub enum CubeTile {
    /// Of a construction.
    Blocks(Arc<[Block]>),
    /// Of a mesh.
    Bodies(Arc<[Body]>),
}

/// What pieces are gathered by: a component of a style, or a layer of a set of meshes.
#[derive(Clone, Debug, PartialEq)]
pub struct FabricLayer {
    /// Name in files.
    pub name: String,
    /// What it is in the building.
    pub component: Component,
    /// How it looks where the set itself says so.
    pub look: Option<Look>,
}

impl FabricLayer {
    /// A layer for each component, in their order.
    pub fn of_components() -> Vec<FabricLayer> {
        let layer = |&component: &Component| FabricLayer { name: component.name().into(), component, look: None };
        Component::ALL.iter().map(layer).collect()
    }

    /// The layers of a set of meshes.
    pub fn of_set(set: &LabelSet) -> Vec<FabricLayer> {
        let layers = set.layers().iter().zip(set.looks()).map(|(layer, look)| FabricLayer {
            name: layer.name.clone(),
            component: layer.component.unwrap_or(Component::Cladding),
            look: look.clone(),
        });
        layers.collect()
    }
}

impl CubeTile {
    /// Number of pieces.
    pub fn len(&self) -> usize {
        match self {
            CubeTile::Blocks(blocks) => blocks.len(),
            CubeTile::Bodies(bodies) => bodies.len(),
        }
    }

    /// Whether nothing stands there.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Component, layer and octant of a piece; the layer of a block is its component.
    pub fn kind(&self, n: usize) -> (Component, usize, u8) {
        match self {
            CubeTile::Blocks(blocks) => (blocks[n].component, blocks[n].component as usize, blocks[n].octant),
            CubeTile::Bodies(bodies) => (bodies[n].component, bodies[n].layer, bodies[n].octant),
        }
    }

    /// Six times the volume of a piece in µm3, exact.
    pub fn six_volumes(&self, n: usize) -> i128 {
        match self {
            CubeTile::Blocks(blocks) => blocks[n].six_volumes(),
            CubeTile::Bodies(bodies) => bodies[n].six_volumes(),
        }
    }

    /// The faces of a piece, counter-clockwise from outside.
    pub fn faces(&self, n: usize) -> Vec<Vec<[i32; 3]>> {
        match self {
            CubeTile::Blocks(blocks) => blocks[n].faces(),
            CubeTile::Bodies(bodies) => bodies[n].polygons.clone(),
        }
    }

    /// A point of a piece, µm: of a block the mean of its corners in plan, half-way between its lowest and highest corner; of a mesh the
    /// middle of its bounding box.
    pub fn middle_um(&self, n: usize) -> [i64; 3] {
        match self {
            CubeTile::Blocks(blocks) => {
                let Block { plan, bottom, top, .. } = &blocks[n];
                let count = plan.len().max(1) as i64;
                let mean = |a: usize| plan.iter().map(|p| i64::from(p[a])).sum::<i64>() / count;
                let heights = || bottom.iter().chain(top).copied().map(i64::from);
                [mean(0), mean(1), (heights().min().unwrap_or(0) + heights().max().unwrap_or(0)) / 2]
            }
            CubeTile::Bodies(bodies) => {
                let [low, high] = bodies[n].bounds_um();
                [0, 1, 2].map(|a| (i64::from(low[a]) + i64::from(high[a])) / 2)
            }
        }
    }

    /// Adds a piece moved by `offset` µm to a merge.
    pub fn add_to(&self, merge: &mut Merge, n: usize, offset: [i64; 3]) {
        match self {
            CubeTile::Blocks(blocks) => merge.add_block(&blocks[n], offset),
            CubeTile::Bodies(bodies) => {
                let mut moved = Vec::new();
                for polygon in &bodies[n].polygons {
                    moved.clear();
                    moved.extend(polygon.iter().map(|p| [0, 1, 2].map(|a| i64::from(p[a]) + offset[a])));
                    merge.add_face(&moved);
                }
            }
        }
    }
}
