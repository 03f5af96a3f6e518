//! The architectural set as the tools see it: shells of the shipped build-ups, and what stands in each cube.

use std::path::Path;

use anyhow::anyhow;
use houscaper::cubes::CubeKey;
use houscaper::price::Books;
use houscaper::score::shells;
use houscaper::tiles::solids::{SolidStyle, solids};
use houscaper::tiles::{Block, Shells};

use crate::cli::failure::{Blame, Failure};
use crate::cli::home;

/// Name under which the shipped style is asked for.
pub const NAME: &str = "architectural";

/// A construction that gives every cube its solids.
pub struct Architectural {
    shells: Shells,
    style: SolidStyle,
}

impl Architectural {
    /// The shipped style over the shipped build-ups.
    pub fn load() -> Result<Architectural, Failure> {
        let home = home::find(None).ok_or_else(|| anyhow!("no configs/ found; set HOUSCAPER_HOME")).input()?;
        let books = Books::load(&home.join("configs")).input()?;
        Ok(Architectural { shells: shells(&books).input()?, style: SolidStyle::default() })
    }

    /// What stands in a cube.
    pub fn blocks(&self, key: CubeKey) -> Vec<Block> {
        solids(key, &self.style, &self.shells)
    }
}

/// Whether a folder or name means a style of solids.
pub fn is_style(dir: &Path) -> bool {
    match super::manifest(dir) {
        Some(manifest) => manifest["kind"] == "style",
        None => dir.file_name().is_some_and(|n| n == NAME),
    }
}
