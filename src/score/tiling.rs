//! What a house is built of: the tileset a brief names, whatever its kind, ready to measure and to draw.
//!
//! A style is drawn by its own construction, single configurations by the meshes that override it, and measured by the surface of that
//! construction. A set of solids is drawn by its meshes; meshes have no surfaces that could be billed, so areas, edges and with them
//! take-off, price and loads come from the surface of the architectural construction under rule A, which like the meshes looks at the
//! eight labels of a cube alone.

use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use rustc_hash::FxHashMap;

use super::LoadFailure;
use super::shells::shells;
use crate::cubes::{CubeKey, Mask, Rule, cube_labels, cube_shape, needs_tile, scan_keys};
use crate::envelope::{
    CUBE_UM, CubeTile, EnvelopeError, EnvelopeSurvey, Fabric, FabricLayer, HouseVolumes, KeyCache, KeyedSurface, Skin,
    VolumeTable, Volumes, house_stairs,
};
use crate::price::Books;
use crate::tiles::solids::{SolidStyle, solids};
use crate::tiles::{
    Block, Body, Component, LabelSet, Look, MissingCube, PlacedTile, Shells, Style, StyleSet, TileRule, Tileset,
    TilesetKind, kind_of,
};
use crate::voxels::{House, Plan, Reading, VoxelArray, walked_deck};

/// A tileset of any kind with what it takes from the build-ups.
pub struct Tiling {
    /// Areas and volume.
    pub skin: Skin,
    /// The style whose solids are drawn.
    pub style: Option<StyleSet>,
    /// The meshes that are drawn instead; without either only the surface is.
    pub meshes: Option<LabelSet>,
    /// The strata of the build-ups.
    pub shells: Shells,
    /// Solids by key, made when first asked for.
    known: Mutex<FxHashMap<CubeKey, Arc<[Block]>>>,
    /// Volumes by key, filled when first asked for.
    volumes: Mutex<VolumeTable>,
}

/// The decks of a house that are walked on, by layer.
#[derive(Clone, Debug, Default)]
pub struct Walked(Vec<(usize, Plan)>);

impl Walked {
    /// Reads the decks that doors lead to.
    pub fn new(house: &House, reading: &Reading) -> Walked {
        let plates = reading.plates.iter().skip(1).map(|plate| (plate.k, walked_deck(house, reading, plate)));
        Walked(plates.filter(|(_, deck)| !deck.is_empty()).collect())
    }

    /// Whether people walk on the slab of this voxel.
    pub fn has(&self, [x, y, z]: [usize; 3]) -> bool {
        self.0.iter().any(|(k, deck)| *k == z && deck.has([x as isize, y as isize]))
    }
}

impl Tiling {
    /// Loads the folder `dir`: a set of surfaces, a set of solids or a style.
    ///
    /// # Errors
    /// What is wrong with the set, or with the strata of the build-ups.
    pub fn load(dir: &Path, books: &Books) -> Result<Tiling, LoadFailure> {
        Tiling::load_from(dir, None, books)
    }

    /// The same with the OBJ files of a set of solids in `root` instead of where its manifest says.
    ///
    /// # Errors
    /// What is wrong with the set, or with the strata of the build-ups.
    pub fn load_from(dir: &Path, root: Option<&Path>, books: &Books) -> Result<Tiling, LoadFailure> {
        let shells = shells(books)?;
        let (skin, style, meshes) = match kind_of(dir)? {
            TilesetKind::Style => {
                let set = StyleSet::load(dir)?;
                let rule = match set.rule {
                    TileRule::A => Rule::A,
                    TileRule::B => Rule::B,
                };
                let style = Style::architectural(&shells);
                (Skin::Keys(KeyedSurface { style, rule, edges: Some(set.style) }), Some(set), None)
            }
            TilesetKind::Solids => {
                let surface = KeyedSurface {
                    style: Style::architectural(&shells),
                    rule: Rule::A,
                    edges: Some(SolidStyle::default()),
                };
                (Skin::Keys(surface), None, Some(LabelSet::load_from(dir, root)?))
            }
            TilesetKind::Surface | TilesetKind::Linear => (Skin::Tiles(Tileset::load(dir)?), None, None),
        };
        Ok(Tiling { skin, style, meshes, shells, known: Mutex::default(), volumes: Mutex::default() })
    }

    /// The looks that a style gives to components.
    pub fn looks(&self) -> &[(Component, Look)] {
        self.style.as_ref().map_or(&[], |style| &style.palette)
    }

    /// Where areas, edges and with them take-off, price and loads come from when it is not the tileset that is drawn.
    pub fn measured_by(&self) -> Option<&'static str> {
        self.meshes.as_ref().map(|_| {
            "meshes give the drawing and the volumes of their layers; areas, take-off, price and loads come from the surface of the \
             architectural construction under rule A"
        })
    }

    /// The cubes of a house for which the tileset has no tile, x fastest; styles and sets of surfaces have one for every admissible cube.
    pub fn missing(&self, voxels: &VoxelArray) -> Vec<MissingCube> {
        self.meshes.as_ref().map_or_else(Vec::new, |set| set.missing_in(voxels))
    }

    /// Areas, volume, openings and edges of a house; `cache` is kept from house to house by the caller.
    ///
    /// # Errors
    /// The first cube that has no tile.
    pub fn survey(
        &self,
        house: &House,
        reading: &Reading,
        cache: &mut KeyCache,
    ) -> Result<EnvelopeSurvey, EnvelopeError> {
        match self.skin {
            Skin::Tiles(_) => self.skin.survey(&house.voxels, |_| false, cache),
            Skin::Keys(_) => {
                let walked = Walked::new(house, reading);
                self.skin.survey(&house.voxels, |v| walked.has(v), cache)
            }
        }
    }

    /// Volume of every component in the house that `survey` has surveyed last, summed from the table of keys without placing a block;
    /// `None` for sets of surfaces or meshes. Equal to the sums over the blocks of [`Tiling::fabric`], to the last integer.
    pub fn volumes(&self, house: &House, reading: &Reading, survey: &KeyCache) -> Option<HouseVolumes> {
        let set = self.style.as_ref()?;
        if !set.overrides.placed_tiles().is_empty() {
            // Which mesh stands in a cube may depend on its place: the blocks themselves are summed.
            let cubes = Volumes::of_fabric(&self.fabric(house, reading)?);
            return Some(HouseVolumes { cubes, stairs: Volumes::default() });
        }
        let mut table = self.volumes.lock().unwrap_or_else(PoisonError::into_inner);
        let cubes = table.sum(survey, |key| Volumes::of_blocks(self.solids(key, &set.style).iter()));
        let stairs = Volumes::of_blocks(house_stairs(house, reading, &set.style).iter().flatten());
        Some(HouseVolumes { cubes, stairs })
    }

    /// Everything that stands in a house: of a style with its stairs, of meshes what they hold; `None` for a set of surfaces alone.
    pub fn fabric(&self, house: &House, reading: &Reading) -> Option<Fabric> {
        if let Some(set) = &self.meshes {
            return Some(mesh_fabric(set, &house.voxels));
        }
        let set = self.style.as_ref()?;
        let Skin::Keys(surface) = &self.skin else { return None };
        let walked = Walked::new(house, reading);
        let mut cubes = Vec::new();
        let own = |cube, key| (cube, key, set.overrides.number_at(key, cube));
        scan_keys(&house.voxels, surface.rule, |v| walked.has(v), |cube, key| cubes.push(own(cube, key)));
        if set.overrides.needs(Mask::FULL) {
            // Inside a room a style has nothing, but may be overridden there too.
            let inside =
                all_cubes(&house.voxels).filter(|(_, key)| key.mask() == Mask::FULL && !needs_tile(&key.labels()));
            cubes.extend(inside.map(|(cube, key)| own(cube, key)).filter(|(.., tile)| tile.is_some()));
        }
        let layers = FabricLayer::of_components();
        let mut fabric = Fabric::of_tiles(&house.voxels, CUBE_UM, layers, cubes, |key, own| match own {
            Some(n) => CubeTile::Bodies(by_component(&set.overrides.placed_tiles()[n])),
            None => CubeTile::Blocks(self.solids(key, &set.style)),
        });
        for blocks in house_stairs(house, reading, &set.style) {
            fabric.add_standing(&blocks);
        }
        Some(fabric)
    }

    fn solids(&self, key: CubeKey, style: &SolidStyle) -> Arc<[Block]> {
        let known = |tiles: &Mutex<FxHashMap<CubeKey, Arc<[Block]>>>| {
            tiles.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned()
        };
        if let Some(blocks) = known(&self.known) {
            return blocks;
        }
        let blocks: Arc<[Block]> = solids(key, style, &self.shells).into();
        self.known.lock().unwrap_or_else(PoisonError::into_inner).insert(key, blocks.clone());
        blocks
    }
}

/// Every cube of the padded array with its labels, x fastest.
fn all_cubes(voxels: &VoxelArray) -> impl Iterator<Item = ([usize; 3], CubeKey)> + '_ {
    let [nx, ny, nz] = cube_shape(voxels);
    let cubes = (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])));
    cubes.map(|cube| (cube, CubeKey::of_labels(cube_labels(voxels, cube))))
}

/// The bodies of an override in the layers of a style, which are the components.
fn by_component(tile: &PlacedTile) -> Arc<[Body]> {
    tile.bodies.iter().map(|body| Body { layer: body.component as usize, ..body.clone() }).collect()
}

/// The tiles of a set of solids where a house has their labels; cubes without a tile stay empty, [`Tiling::missing`] lists them.
fn mesh_fabric(set: &LabelSet, voxels: &VoxelArray) -> Fabric {
    let cubes = all_cubes(voxels).filter_map(|(cube, key)| Some((cube, CubeKey::default(), set.number_at(key, cube)?)));
    let cube_um = set.module_um().map(i64::from);
    Fabric::of_tiles(voxels, cube_um, FabricLayer::of_set(set), cubes, |_, n| {
        CubeTile::Bodies(set.placed_tiles()[n].bodies.as_slice().into())
    })
}
