//! What a house is built of: the tileset a brief names, whatever its kind, ready to measure and to draw.

use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use rustc_hash::FxHashMap;

use super::LoadFailure;
use super::shells::shells;
use crate::cubes::{CubeKey, Rule, scan_keys};
use crate::envelope::{
    EnvelopeError, EnvelopeSurvey, Fabric, HouseVolumes, KeyCache, KeyedSurface, Skin, VolumeTable, Volumes,
    house_stairs,
};
use crate::price::Books;
use crate::tiles::solids::{SolidStyle, solids};
use crate::tiles::{Block, Shells, Style, StyleSet, TileRule, Tileset, TilesetKind, kind_of};
use crate::voxels::{House, Plan, Reading, walked_deck};

/// A tileset of any kind with what it takes from the build-ups.
pub struct Tiling {
    /// Areas and volume.
    pub skin: Skin,
    /// The style whose solids are drawn; `None` for a set of surfaces alone.
    pub style: Option<StyleSet>,
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
    /// Loads the folder `dir`: a set of surfaces or a style.
    ///
    /// # Errors
    /// What is wrong with the set, or with the strata of the build-ups.
    pub fn load(dir: &Path, books: &Books) -> Result<Tiling, LoadFailure> {
        let shells = shells(books)?;
        let (skin, style) = match kind_of(dir)? {
            TilesetKind::Style => {
                let set = StyleSet::load(dir)?;
                let rule = match set.rule {
                    TileRule::A => Rule::A,
                    TileRule::B => Rule::B,
                };
                let style = Style::architectural(&shells);
                (Skin::Keys(KeyedSurface { style, rule, edges: Some(set.style) }), Some(set))
            }
            TilesetKind::Surface | TilesetKind::Linear | TilesetKind::Solids => {
                (Skin::Tiles(Tileset::load(dir)?), None)
            }
        };
        Ok(Tiling { skin, style, shells, known: Mutex::default(), volumes: Mutex::default() })
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
    /// `None` for a set of surfaces alone. Equal to the sums over the blocks of [`Tiling::fabric`], to the last integer.
    pub fn volumes(&self, house: &House, reading: &Reading, survey: &KeyCache) -> Option<HouseVolumes> {
        let set = self.style.as_ref()?;
        let mut table = self.volumes.lock().unwrap_or_else(PoisonError::into_inner);
        let cubes = table.sum(survey, |key| Volumes::of_blocks(self.solids(key, &set.style).iter()));
        let stairs = Volumes::of_blocks(house_stairs(house, reading, &set.style).iter().flatten());
        Some(HouseVolumes { cubes, stairs })
    }

    /// Everything that stands in a house, stairs included; `None` for a set of surfaces alone.
    pub fn fabric(&self, house: &House, reading: &Reading) -> Option<Fabric> {
        let set = self.style.as_ref()?;
        let Skin::Keys(surface) = &self.skin else { return None };
        let walked = Walked::new(house, reading);
        let mut keys = Vec::new();
        scan_keys(&house.voxels, surface.rule, |v| walked.has(v), |cube, key| keys.push((cube, key)));
        let mut fabric = Fabric::new(&house.voxels, keys, |key| self.solids(key, &set.style));
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
