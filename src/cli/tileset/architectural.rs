//! Sets that construct their tiles, as the tools see them: the manifest's choices over the shells of the build-ups.

use std::path::Path;

use anyhow::anyhow;
use houscaper::cubes::{CubeKey, needs_tile, reachable_keys, reachable_labels};
use houscaper::envelope::CubeTile;
use houscaper::export::Palette;
use houscaper::price::Books;
use houscaper::score::shells;
use houscaper::tiles::solids::solids;
use houscaper::tiles::{Block, PlacedTile, Shells, StyleSet};
use houscaper::voxels::Label;

use crate::cli::failure::{Blame, Failure};
use crate::cli::home;

/// A construction that gives every cube its solids.
pub struct Architectural {
    set: StyleSet,
    shells: Shells,
}

impl Architectural {
    /// The style of a folder over the build-ups found.
    pub fn load(dir: &Path) -> Result<Architectural, Failure> {
        let home = home::find(None).ok_or_else(|| anyhow!("no configs/ found; set HOUSCAPER_HOME")).input()?;
        let books = Books::load(&home.join("configs")).input()?;
        Ok(Architectural { set: StyleSet::load(dir).input()?, shells: shells(&books).input()? })
    }

    /// The shipped style of that name.
    pub fn shipped() -> Result<Architectural, Failure> {
        Architectural::load(&super::named("architectural"))
    }

    /// Name of the style.
    pub fn name(&self) -> &str {
        &self.set.name
    }

    /// The meshes that stand in a cube instead of what is constructed, one for each variant.
    pub fn overrides(&self, key: CubeKey) -> &[PlacedTile] {
        self.set.overrides.tiles(key)
    }

    /// What stands in a cube of a house: its variant is chosen by the place.
    pub fn tile_at(&self, key: CubeKey, cube: [usize; 3]) -> CubeTile {
        match self.set.overrides.tile_at(key, cube) {
            Some(tile) => CubeTile::Bodies(tile.bodies.as_slice().into()),
            None => CubeTile::Blocks(self.blocks(key).into()),
        }
    }

    /// What the construction puts in a cube.
    pub fn blocks(&self, key: CubeKey) -> Vec<Block> {
        solids(key, &self.set.style, &self.shells)
    }

    /// The look of its components.
    pub fn palette(&self) -> Palette {
        Palette::of_looks(&self.set.palette)
    }

    /// Labellings that need a tile, and how many of them have one under every face number and walked deck.
    pub fn coverage(&self) -> [usize; 2] {
        let needed: Vec<[Label; 8]> = reachable_labels().into_iter().filter(needs_tile).collect();
        let by_numbers = reachable_keys().into_iter().filter(|k| needs_tile(&k.labels()));
        let bare =
            by_numbers.chain(needed.iter().map(|l| CubeKey::of_labels(*l))).filter(|k| self.blocks(*k).is_empty());
        let mut bare: Vec<CubeKey> = bare.map(|k| CubeKey::of_labels(k.labels())).collect();
        bare.sort_unstable();
        bare.dedup();
        [needed.len(), needed.len() - bare.len()]
    }
}

/// Whether a folder holds a style.
pub fn is_style(dir: &Path) -> bool {
    super::manifest(dir).is_some_and(|manifest| manifest["kind"] == "style")
}
