//! The fabric of a house: every block of every cube where it stands.

use std::sync::Arc;

use rayon::prelude::*;
use rustc_hash::FxHashMap;

use super::{Merge, MergeError, Solid};
use crate::cubes::{Corner, CubeKey, corner_voxel};
use crate::tiles::{Block, Component};
use crate::voxels::{Label, VoxelArray};

/// Edge lengths of a cube in µm; blocks are made for these and stretched to other modules only when they are shown.
pub const CUBE_UM: [i64; 3] = [900_000, 900_000, 540_000];

/// A block where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PlacedBlock {
    /// Which tile of [`Fabric::tiles`].
    pub tile: u32,
    /// Which of its blocks.
    pub block: u32,
    /// The cube of the padded array.
    pub cube: [u32; 3],
    /// What it is.
    pub component: Component,
    /// The voxel that it belongs to: that of its octant; inside the array for any octant that is filled.
    pub voxel: [i32; 3],
}

/// All blocks of a house. Positions are µm from the centre of voxel (0, 0, 0).
#[derive(Clone, Debug, PartialEq)]
pub struct Fabric {
    /// Voxels of the house.
    pub shape: [usize; 3],
    /// Stretch of each axis from blocks to the house's module: 1 for the default module.
    pub scale: [f64; 3],
    /// Centre of voxel (0, 0, 0) in m.
    pub origin_m: [f64; 3],
    /// The distinct tiles, in the order in which they were met.
    pub tiles: Vec<(CubeKey, Arc<[Block]>)>,
    /// Every block, cube by cube.
    pub placed: Vec<PlacedBlock>,
}

impl Fabric {
    /// Places the blocks of every cube. `keys` are the cubes of the padded array with their keys; `tile` makes the blocks of a key and
    /// is asked once for each.
    pub fn new(
        voxels: &VoxelArray,
        keys: impl IntoIterator<Item = ([usize; 3], CubeKey)>,
        mut tile: impl FnMut(CubeKey) -> Arc<[Block]>,
    ) -> Fabric {
        let mut fabric = Fabric {
            shape: voxels.shape(),
            scale: [0, 1, 2].map(|a| match voxels.module.size_m[a] / (CUBE_UM[a] as f64 * 1e-6) {
                s if (s - 1.0).abs() < 1e-9 => 1.0,
                s => s,
            }),
            origin_m: voxels.origin_m,
            tiles: Vec::new(),
            placed: Vec::new(),
        };
        let mut known: FxHashMap<CubeKey, u32> = FxHashMap::default();
        for (cube, key) in keys {
            let tiles = &mut fabric.tiles;
            let number = *known.entry(key).or_insert_with(|| {
                tiles.push((key, tile(key)));
                tiles.len() as u32 - 1
            });
            for (n, block) in fabric.tiles[number as usize].1.iter().enumerate() {
                let octant = block.octant;
                let voxel = corner_voxel(cube, Corner::at([octant & 1, octant >> 1 & 1, octant >> 2 & 1]));
                fabric.placed.push(PlacedBlock {
                    tile: number,
                    block: n as u32,
                    cube: cube.map(|c| c as u32),
                    component: block.component,
                    voxel: voxel.map(|c| c as i32),
                });
            }
        }
        fabric
    }

    /// Adds blocks that belong to no cube, as stairs do: coordinates in µm from the centre of voxel (0, 0, 0).
    pub fn add_standing(&mut self, blocks: &[Block]) {
        let tile = self.tiles.len() as u32;
        for (n, block) in blocks.iter().enumerate() {
            let lowest = block.bottom.iter().min().copied().unwrap_or(0);
            let at = [block.plan[0][0], block.plan[0][1], lowest].map(i64::from);
            // Voxels reach half a module to either side of their centres.
            let voxel = [0, 1, 2].map(|a| (2 * at[a] + CUBE_UM[a]).div_euclid(2 * CUBE_UM[a]) as i32);
            // Cube (1, 1, 1) has its corner at the centre of voxel (0, 0, 0).
            let (block, component) = (n as u32, block.component);
            self.placed.push(PlacedBlock { tile, block, cube: [1; 3], component, voxel });
        }
        self.tiles.push((CubeKey::of_labels([Label::Empty; 8]), blocks.into()));
    }

    /// The block in its cube's own axes.
    pub fn block(&self, placed: &PlacedBlock) -> &Block {
        &self.tiles[placed.tile as usize].1[placed.block as usize]
    }

    /// Where the cube's own axes begin, µm.
    pub fn offset_um(&self, placed: &PlacedBlock) -> [i64; 3] {
        [0, 1, 2].map(|a| (i64::from(placed.cube[a]) - 1) * CUBE_UM[a])
    }

    /// A position in m, stretched to the house's module.
    pub fn metres(&self, at_um: [i64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|a| self.origin_m[a] + at_um[a] as f64 * 1e-6 * self.scale[a])
    }

    /// The middle of a block's bounding box in m.
    pub fn centre_m(&self, placed: &PlacedBlock) -> [f64; 3] {
        let (block, offset) = (self.block(placed), self.offset_um(placed));
        let middle = |values: &mut dyn Iterator<Item = i32>| {
            let (low, high) = values.fold((i32::MAX, i32::MIN), |(l, h), v| (l.min(v), h.max(v)));
            (i64::from(low) + i64::from(high)) / 2
        };
        let at = [
            middle(&mut block.plan.iter().map(|p| p[0])),
            middle(&mut block.plan.iter().map(|p| p[1])),
            middle(&mut block.bottom.iter().chain(&block.top).copied()),
        ];
        self.metres([0, 1, 2].map(|a| at[a] + offset[a]))
    }

    /// Six times the volume of each component in µm3 before any stretch, exact; the index is `Component as usize`.
    pub fn six_volumes(&self) -> Vec<i128> {
        let mut sums = vec![0; Component::COUNT];
        let of_tile = self.volumes_of_tiles();
        for p in &self.placed {
            sums[p.component as usize] += of_tile[p.tile as usize][p.block as usize];
        }
        sums
    }

    /// Six times the volume in µm3 that each voxel holds of each component, exact and sparse.
    pub fn six_volumes_by_voxel(&self) -> FxHashMap<([i32; 3], Component), i128> {
        let mut sums = FxHashMap::default();
        let of_tile = self.volumes_of_tiles();
        for p in &self.placed {
            *sums.entry((p.voxel, p.component)).or_default() += of_tile[p.tile as usize][p.block as usize];
        }
        sums
    }

    /// Volume of each component in m3 in the house's module; the index is `Component as usize`.
    pub fn volumes_m3(&self) -> Vec<f64> {
        let stretch: f64 = self.scale.iter().product();
        self.six_volumes().into_iter().map(|v| v as f64 / 6e18 * stretch).collect()
    }

    fn volumes_of_tiles(&self) -> Vec<Vec<i128>> {
        self.tiles.iter().map(|(_, blocks)| blocks.iter().map(Block::six_volumes).collect()).collect()
    }

    /// The boundary of some of the blocks.
    ///
    /// # Errors
    /// When blocks overlap.
    pub fn merge<'a>(&self, blocks: impl IntoIterator<Item = &'a PlacedBlock>) -> Result<Solid, MergeError> {
        let mut merge = Merge::new();
        for placed in blocks {
            merge.add_block(self.block(placed), self.offset_um(placed));
        }
        merge.finish()
    }

    /// The boundary of each group of blocks; groups come in ascending order of what `group` answers. Groups are merged in parallel.
    ///
    /// # Errors
    /// The first group in which blocks overlap.
    pub fn merge_groups<G: Ord + Copy + Send>(
        &self,
        group: impl Fn(&PlacedBlock) -> G,
    ) -> Result<Vec<(G, Solid)>, MergeError> {
        let mut groups: std::collections::BTreeMap<G, Vec<&PlacedBlock>> = std::collections::BTreeMap::new();
        for placed in &self.placed {
            groups.entry(group(placed)).or_default().push(placed);
        }
        let groups: Vec<(G, Vec<&PlacedBlock>)> = groups.into_iter().collect();
        groups.into_par_iter().map(|(g, blocks)| Ok((g, self.merge(blocks)?))).collect()
    }
}
