//! The fabric of a house: every piece of every cube where it stands, blocks of a construction and bodies of meshes.

use std::hash::Hash;
use std::sync::Arc;

use rayon::prelude::*;
use rustc_hash::FxHashMap;

use super::merge_solid::without_opposites;
use super::{CubeTile, FabricLayer, Merge, MergeError, Solid};
use crate::cubes::{Corner, CubeKey, corner_voxel};
use crate::tiles::{Block, Component};
use crate::voxels::{Label, VoxelArray};

/// Edge lengths of a constructed cube in µm; pieces are made for their own cube and stretched to other modules only when they are
/// shown.
pub const CUBE_UM: [i64; 3] = [900_000, 900_000, 540_000];

/// A block, or a body of a mesh, where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PlacedBlock {
    /// Which tile of [`Fabric::tiles`].
    pub tile: u32,
    /// Which of its pieces.
    pub block: u32,
    /// The cube of the padded array.
    pub cube: [u32; 3],
    /// What it is.
    pub component: Component,
    /// What it is gathered by: place in [`Fabric::layers`].
    pub layer: u32,
    /// The voxel that it belongs to: that of its octant; inside the array for any octant that is filled.
    pub voxel: [i32; 3],
}

/// All pieces of a house. Positions are µm from the centre of voxel (0, 0, 0).
#[derive(Clone, Debug, PartialEq)]
pub struct Fabric {
    /// Voxels of the house.
    pub shape: [usize; 3],
    /// Edges of the cube that pieces are made for, µm.
    pub cube_um: [i64; 3],
    /// Stretch of each axis from that cube to the house's module: 1 where they agree.
    pub scale: [f64; 3],
    /// Centre of voxel (0, 0, 0) in m.
    pub origin_m: [f64; 3],
    /// What pieces are gathered by.
    pub layers: Vec<FabricLayer>,
    /// The distinct tiles, in the order in which they were met, with the key they were made for: the empty one for meshes, which are
    /// told apart by their place in the set.
    pub tiles: Vec<(CubeKey, CubeTile)>,
    /// Which of them belong to no cube, as stairs do.
    pub standing: Vec<u32>,
    /// Every piece, cube by cube.
    pub placed: Vec<PlacedBlock>,
}

/// The pieces of a group as one surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Gathered {
    /// The surface.
    pub solid: Solid,
    /// Why it is that of each piece on its own, as meshes that overlap are shown; `None` for the boundary of all together.
    pub apart: Option<MergeError>,
}

impl Fabric {
    /// Places the blocks of every cube. `keys` are the cubes of the padded array with their keys; `tile` makes the blocks of a key and
    /// is asked once for each. Layers are the components.
    pub fn new(
        voxels: &VoxelArray,
        keys: impl IntoIterator<Item = ([usize; 3], CubeKey)>,
        mut tile: impl FnMut(CubeKey) -> Arc<[Block]>,
    ) -> Fabric {
        let cubes = keys.into_iter().map(|(cube, key)| (cube, key, ()));
        let layers = FabricLayer::of_components();
        Fabric::of_tiles(voxels, CUBE_UM, layers, cubes, |key, ()| CubeTile::Blocks(tile(key)))
    }

    /// Places the pieces of every cube. `cubes` are those of the padded array with their keys and whatever else tells tiles of one key
    /// apart; `tile` makes the tile of such a pair, drawn in a cube of `cube_um`, and is asked once for each.
    pub fn of_tiles<I: Copy + Eq + Hash>(
        voxels: &VoxelArray,
        cube_um: [i64; 3],
        layers: Vec<FabricLayer>,
        cubes: impl IntoIterator<Item = ([usize; 3], CubeKey, I)>,
        mut tile: impl FnMut(CubeKey, I) -> CubeTile,
    ) -> Fabric {
        let mut fabric = Fabric {
            shape: voxels.shape(),
            cube_um,
            scale: [0, 1, 2].map(|a| match voxels.module.size_m[a] / (cube_um[a] as f64 * 1e-6) {
                s if (s - 1.0).abs() < 1e-9 => 1.0,
                s => s,
            }),
            origin_m: voxels.origin_m,
            layers,
            tiles: Vec::new(),
            standing: Vec::new(),
            placed: Vec::new(),
        };
        let mut known: FxHashMap<(CubeKey, I), u32> = FxHashMap::default();
        for (cube, key, id) in cubes {
            let tiles = &mut fabric.tiles;
            let number = *known.entry((key, id)).or_insert_with(|| {
                tiles.push((key, tile(key, id)));
                tiles.len() as u32 - 1
            });
            let tile = &fabric.tiles[number as usize].1;
            for n in 0..tile.len() {
                let (component, layer, octant) = tile.kind(n);
                let voxel = corner_voxel(cube, Corner::at([octant & 1, octant >> 1 & 1, octant >> 2 & 1]));
                fabric.placed.push(PlacedBlock {
                    tile: number,
                    block: n as u32,
                    cube: cube.map(|c| c as u32),
                    component,
                    layer: layer as u32,
                    voxel: voxel.map(|c| c as i32),
                });
            }
        }
        fabric
    }

    /// Adds blocks that belong to no cube, as stairs do: coordinates in µm from the centre of voxel (0, 0, 0).
    pub fn add_standing(&mut self, blocks: &[Block]) {
        let tile = self.tiles.len() as u32;
        self.standing.push(tile);
        for (n, block) in blocks.iter().enumerate() {
            let lowest = block.bottom.iter().min().copied().unwrap_or(0);
            let at = [block.plan[0][0], block.plan[0][1], lowest].map(i64::from);
            // Voxels reach half a module to either side of their centres.
            let voxel = [0, 1, 2].map(|a| (2 * at[a] + self.cube_um[a]).div_euclid(2 * self.cube_um[a]) as i32);
            // Cube (1, 1, 1) has its corner at the centre of voxel (0, 0, 0).
            let (block, component) = (n as u32, block.component);
            let layer = component as u32;
            self.placed.push(PlacedBlock { tile, block, cube: [1; 3], component, layer, voxel });
        }
        self.tiles.push((CubeKey::of_labels([Label::Empty; 8]), CubeTile::Blocks(blocks.into())));
    }

    /// Six times the volume of a piece in µm3 before any stretch, exact.
    pub fn six_volumes_of(&self, placed: &PlacedBlock) -> i128 {
        let (tile, n) = self.piece(placed);
        tile.six_volumes(n)
    }

    /// The tile of a piece, and which of its pieces it is.
    fn piece(&self, placed: &PlacedBlock) -> (&CubeTile, usize) {
        (&self.tiles[placed.tile as usize].1, placed.block as usize)
    }

    /// Where the cube's own axes begin, µm.
    pub fn offset_um(&self, placed: &PlacedBlock) -> [i64; 3] {
        [0, 1, 2].map(|a| (i64::from(placed.cube[a]) - 1) * self.cube_um[a])
    }

    /// A position in m, stretched to the house's module.
    pub fn metres(&self, at_um: [i64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|a| self.origin_m[a] + at_um[a] as f64 * 1e-6 * self.scale[a])
    }

    /// A point inside a piece in m: of a block the mean of its corners in plan, half-way up; of a mesh the middle of its bounding box.
    pub fn centre_m(&self, placed: &PlacedBlock) -> [f64; 3] {
        let ((tile, n), offset) = (self.piece(placed), self.offset_um(placed));
        let at = tile.middle_um(n);
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

    /// Six times the volume of each of [`Fabric::layers`] in µm3 before any stretch, exact.
    pub fn six_volumes_by_layer(&self) -> Vec<i128> {
        let mut sums = vec![0; self.layers.len()];
        let of_tile = self.volumes_of_tiles();
        for p in &self.placed {
            sums[p.layer as usize] += of_tile[p.tile as usize][p.block as usize];
        }
        sums
    }

    fn volumes_of_tiles(&self) -> Vec<Vec<i128>> {
        self.tiles.iter().map(|(_, tile)| (0..tile.len()).map(|n| tile.six_volumes(n)).collect()).collect()
    }

    /// The boundary of some of the pieces.
    ///
    /// # Errors
    /// When blocks overlap; meshes may, and are then taken one by one.
    pub fn merge<'a>(&self, blocks: impl IntoIterator<Item = &'a PlacedBlock>) -> Result<Solid, MergeError> {
        Ok(self.gather(&blocks.into_iter().collect::<Vec<_>>())?.solid)
    }

    /// The boundary of each group of pieces; groups come in ascending order of what `group` answers. Groups are merged in parallel.
    ///
    /// # Errors
    /// The first group in which blocks overlap.
    pub fn merge_groups<G: Ord + Copy + Send>(
        &self,
        group: impl Fn(&PlacedBlock) -> G,
    ) -> Result<Vec<(G, Solid)>, MergeError> {
        Ok(self.gather_groups(group)?.into_iter().map(|(g, gathered)| (g, gathered.solid)).collect())
    }

    /// The same, telling which groups are not merged.
    ///
    /// # Errors
    /// The first group in which blocks overlap.
    pub fn gather_groups<G: Ord + Copy + Send>(
        &self,
        group: impl Fn(&PlacedBlock) -> G,
    ) -> Result<Vec<(G, Gathered)>, MergeError> {
        let mut groups: std::collections::BTreeMap<G, Vec<&PlacedBlock>> = std::collections::BTreeMap::new();
        for placed in &self.placed {
            groups.entry(group(placed)).or_default().push(placed);
        }
        let groups: Vec<(G, Vec<&PlacedBlock>)> = groups.into_iter().collect();
        groups.into_par_iter().map(|(g, blocks)| Ok((g, self.gather(&blocks)?))).collect()
    }

    /// The boundary of each layer, ascending, in one piece whose faces have the tags of the pieces that they belong to: `tags` for each of
    /// [`Fabric::placed`] in their order. Pieces of different tags that touch with equal faces leave none between them.
    ///
    /// # Errors
    /// The first layer in which blocks overlap.
    pub fn gather_tagged(&self, tags: &[u32]) -> Result<Vec<(u32, Gathered)>, MergeError> {
        let mut layers: std::collections::BTreeMap<u32, Vec<(u32, &PlacedBlock)>> = std::collections::BTreeMap::new();
        for (tag, placed) in tags.iter().zip(&self.placed) {
            layers.entry(placed.layer).or_default().push((*tag, placed));
        }
        let layers: Vec<(u32, Vec<(u32, &PlacedBlock)>)> = layers.into_iter().collect();
        let gather = |(layer, blocks): (u32, Vec<(u32, &PlacedBlock)>)| {
            let faces = || blocks.iter().flat_map(|(tag, placed)| self.faces(*tag, placed)).collect();
            let mut merge = Merge::new();
            for (tag, polygon) in without_opposites(faces()) {
                merge.set_tag(tag);
                merge.add_face(&polygon);
            }
            let is_mesh = || blocks.iter().any(|(_, p)| matches!(self.piece(p).0, CubeTile::Bodies(_)));
            match merge.finish() {
                Ok(solid) => Ok((layer, Gathered { solid, apart: None })),
                // As [`Fabric::gather`].
                Err(error) if is_mesh() => {
                    Ok((layer, Gathered { solid: Solid::of_faces(faces()), apart: Some(error) }))
                }
                Err(error) => Err(error),
            }
        };
        layers.into_par_iter().map(gather).collect()
    }

    /// The surface of some pieces; of meshes that overlap that of each on its own.
    ///
    /// # Errors
    /// When blocks overlap.
    pub fn gather(&self, blocks: &[&PlacedBlock]) -> Result<Gathered, MergeError> {
        let mut merge = Merge::new();
        for placed in blocks {
            let (tile, n) = self.piece(placed);
            tile.add_to(&mut merge, n, self.offset_um(placed));
        }
        match merge.finish() {
            Ok(solid) => Ok(Gathered { solid, apart: None }),
            // Whoever draws meshes may let them overlap; blocks are disjoint by construction.
            Err(error) if blocks.iter().any(|p| matches!(self.piece(p).0, CubeTile::Bodies(_))) => {
                Ok(Gathered { solid: self.apart(blocks), apart: Some(error) })
            }
            Err(error) => Err(error),
        }
    }

    /// All faces of some pieces, without those that two of them turn to each other.
    fn apart(&self, blocks: &[&PlacedBlock]) -> Solid {
        Solid::of_faces(blocks.iter().flat_map(|placed| self.faces(0, placed)).collect())
    }

    /// The faces of a piece where it stands, with a tag.
    fn faces(&self, tag: u32, placed: &PlacedBlock) -> impl Iterator<Item = (u32, Vec<[i64; 3]>)> + use<> {
        let ((tile, n), offset) = (self.piece(placed), self.offset_um(placed));
        let moved = move |p: [i32; 3]| [0, 1, 2].map(|a| i64::from(p[a]) + offset[a]);
        tile.faces(n).into_iter().map(move |face| (tag, face.into_iter().map(moved).collect()))
    }
}
