//! The distinct tiles of a house: equal ones, turned or not, are one.

use std::collections::{BTreeMap, BTreeSet};

use rayon::prelude::*;
use rustc_hash::FxHashMap;

use crate::cubes::{CubeKey, Symmetry, cube_labels};
use crate::envelope::{Fabric, MergeError, PlacedBlock, Solid};
use crate::voxels::{House, Label};

/// A piece of a tile: what is of one layer and in voxels of one label.
#[derive(Clone, Debug, PartialEq)]
pub struct TilePiece {
    /// Place in [`Fabric::layers`].
    pub layer: u32,
    /// Label of the voxels that it belongs to.
    pub label: Label,
    /// Its surface in the cube's own axes, µm.
    pub solid: Solid,
}

/// A tile as it is drawn once.
#[derive(Clone, Debug, PartialEq)]
pub struct DistinctTile {
    /// Its key, of meshes the labels alone.
    pub key: CubeKey,
    /// Its pieces by layer and label.
    pub pieces: Vec<TilePiece>,
}

/// A tile in a cube.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TurnedTile {
    /// Place in [`DistinctTiles::tiles`].
    pub tile: usize,
    /// Quarter turns by which that one stands here, counter-clockwise seen from above.
    pub turns: u8,
}

/// Every tile of a house.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DistinctTiles {
    /// Each once, in the order in which their first cubes come.
    pub tiles: Vec<DistinctTile>,
    /// Which stands in each cube of the padded array; cubes with nothing in them are left out.
    pub of_cube: BTreeMap<[u32; 3], TurnedTile>,
}

/// What makes two tiles the same as drawn: the number in the fabric, and the labels, which views show.
type Drawn = (u32, CubeKey);

impl DistinctTiles {
    /// Finds the tiles of a fabric. A tile is another one turned only if its pieces are the same to the last micrometre.
    ///
    /// # Errors
    /// When blocks of a tile overlap.
    pub fn new(fabric: &Fabric, house: &House) -> Result<DistinctTiles, MergeError> {
        let mut drawn: BTreeMap<[u32; 3], Drawn> = BTreeMap::new();
        let mut first: FxHashMap<Drawn, Vec<&PlacedBlock>> = FxHashMap::default();
        let mut order: Vec<Drawn> = Vec::new();
        for placed in fabric.placed.iter().filter(|p| !fabric.standing.contains(&p.tile)) {
            let here = *drawn.entry(placed.cube).or_insert_with(|| {
                let labels = cube_labels(&house.voxels, placed.cube.map(|c| c as usize));
                (placed.tile, CubeKey::of_labels(labels))
            });
            match first.get_mut(&here) {
                None => {
                    order.push(here);
                    first.insert(here, vec![placed]);
                }
                Some(blocks) if blocks[0].cube == placed.cube => blocks.push(placed),
                Some(_) => {}
            }
        }
        let solids: Vec<Vec<TilePiece>> =
            order.par_iter().map(|d| pieces(fabric, house, &first[d])).collect::<Result<_, _>>()?;
        let mut found = DistinctTiles::default();
        let mut known: FxHashMap<Drawn, TurnedTile> = FxHashMap::default();
        let mut by_class: FxHashMap<CubeKey, Vec<usize>> = FxHashMap::default();
        for (own, pieces) in order.iter().zip(solids) {
            let key = tile_key(fabric, own);
            let class = turned_least(key);
            let mates = by_class.entry(class).or_default();
            let same = mates.iter().find_map(|&tile| {
                turns_to(&found.tiles[tile], &pieces, fabric.cube_um).map(|turns| TurnedTile { tile, turns })
            });
            let turned = same.unwrap_or_else(|| {
                mates.push(found.tiles.len());
                found.tiles.push(DistinctTile { key, pieces });
                TurnedTile { tile: found.tiles.len() - 1, turns: 0 }
            });
            known.insert(*own, turned);
        }
        found.of_cube = drawn.into_iter().map(|(cube, d)| (cube, known[&d])).collect();
        Ok(found)
    }
}

/// The key of a tile; that of meshes is their labels, as all have the same empty key.
fn tile_key(fabric: &Fabric, (tile, labels): &Drawn) -> CubeKey {
    let key = fabric.tiles[*tile as usize].0;
    if key == CubeKey::default() { *labels } else { key }
}

fn turn(turns: u8) -> Symmetry {
    Symmetry { mirror: false, turns }
}

/// The least of the four turned keys.
fn turned_least(key: CubeKey) -> CubeKey {
    (0..4).map(|turns| key.placed(turn(turns))).min_by_key(|k| k.bits()).unwrap_or(key)
}

fn pieces(fabric: &Fabric, house: &House, blocks: &[&PlacedBlock]) -> Result<Vec<TilePiece>, MergeError> {
    let mut groups: BTreeMap<(u32, Label), Vec<PlacedBlock>> = BTreeMap::new();
    for placed in blocks {
        let label = house.voxels.at(placed.voxel.map(|v| v as isize));
        // Cube (1, 1, 1) has its own axes at the origin.
        groups.entry((placed.layer, label)).or_default().push(PlacedBlock { cube: [1; 3], ..**placed });
    }
    let piece = |((layer, label), blocks): ((u32, Label), Vec<PlacedBlock>)| {
        let solid = fabric.gather(&blocks.iter().collect::<Vec<_>>())?.solid;
        Ok(TilePiece { layer, label, solid })
    };
    groups.into_iter().map(piece).collect()
}

/// The quarter turns that make a tile these pieces; `None` where none does.
fn turns_to(tile: &DistinctTile, pieces: &[TilePiece], cube_um: [i64; 3]) -> Option<u8> {
    let square = cube_um[0] == cube_um[1];
    (0..if square { 4 } else { 1 }).find(|&turns| {
        tile.pieces.len() == pieces.len()
            && tile
                .pieces
                .iter()
                .zip(pieces)
                .all(|(a, b)| (a.layer, a.label) == (b.layer, b.label) && is_turned(&a.solid, &b.solid, turns, cube_um))
    })
}

/// Whether a surface turned about the middle of the cube is another: the same faces with the same corners.
fn is_turned(a: &Solid, b: &Solid, turns: u8, cube_um: [i64; 3]) -> bool {
    let count = |s: &Solid| (s.vertices.len(), s.faces.len(), s.triangle_count());
    if count(a) != count(b) {
        return false;
    }
    let symmetry = turn(turns);
    let size = cube_um.map(|c| c as i32);
    let moved =
        |p: [i64; 3], turns: bool| if turns { symmetry.point(p.map(|c| c as i32), size).map(i64::from) } else { p };
    faces(a, |p| moved(p, true)) == faces(b, |p| moved(p, false))
}

/// The corners of each face.
fn faces(solid: &Solid, moved: impl Fn([i64; 3]) -> [i64; 3]) -> BTreeSet<Vec<[i64; 3]>> {
    let corners = |l: &Vec<u32>| l.iter().map(|&v| moved(solid.vertices[v as usize])).collect::<Vec<_>>();
    let sorted = |face: &crate::envelope::Face| {
        let mut points = corners(&face.outer);
        face.holes.iter().for_each(|h| points.extend(corners(h)));
        points.sort_unstable();
        points
    };
    solid.faces.iter().map(sorted).collect()
}
