//! Everything an evaluator needs from disk, read once and checked.

use std::path::PathBuf;

use super::{Evaluator, ShellsError, Tiling};
use crate::brief::{Brief, Site};
use crate::envelope::Surface;
use crate::price::{Books, BuildUps, CarbonBook, PriceBook, PriceError};
use crate::quantities::{FrameMaterial, Item};
use crate::structure::{
    Annex, Catalogue, CatalogueError, FREE_FALL_M_S2, LoadError, LoadSettings, LoadTable, SectionOption, SurfaceWeights,
};
use crate::tiles::{LinearTileset, TilesetError};
use crate::voxels::{Choice, rules};

/// Where things are.
#[derive(Clone, Debug, PartialEq)]
pub struct Paths {
    /// Folder of the brief: its book paths are relative to it.
    pub brief: PathBuf,
    /// Folder with `materials.json`, `sections.json` and `loads.json`.
    pub configs: PathBuf,
    /// Folder of the tileset: surfaces or a style.
    pub tileset: PathBuf,
    /// Folder of the linear tileset.
    pub linear: PathBuf,
}

impl Paths {
    /// A book that a brief names: beside the brief, else among the shipped configs.
    pub fn book(&self, name: &str) -> PathBuf {
        let (own, shipped) = (self.brief.join(name), self.configs.join(name));
        if !own.is_file() && shipped.is_file() { shipped } else { own }
    }
}

/// Why an evaluator could not be made: the input is to blame.
#[derive(Debug, thiserror::Error)]
pub enum LoadFailure {
    /// A tileset.
    #[error(transparent)]
    Tileset(#[from] TilesetError),
    /// A book.
    #[error(transparent)]
    Price(#[from] PriceError),
    /// Strata of the build-ups.
    #[error(transparent)]
    Shells(#[from] ShellsError),
    /// Materials or sections.
    #[error(transparent)]
    Catalogue(#[from] CatalogueError),
    /// Loads.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// The brief's rule settings.
    #[error("`rules` of the brief: {0}; `houscaper check --rules` lists the settings")]
    Rules(String),
    /// No section is left for a group.
    #[error(
        "`sections` of the brief leaves no {group} for {materials}: expected at least one id that fits the group's layer; use \"auto\" or add one of: {candidates}"
    )]
    NoSection {
        /// The choice.
        group: &'static str,
        /// Materials of the brief.
        materials: String,
        /// Ids that would fit.
        candidates: String,
    },
    /// A section id that the catalogue lacks.
    #[error("`sections` of the brief names `{id}`, which is not in sections.json; expected one of its ids")]
    UnknownSection {
        /// The id.
        id: String,
    },
    /// A section for single members only.
    #[error(
        "`sections` of the brief names `{id}`, which is not offered to houses (no price, stock length or layer is known for it; `houscaper member` checks it alone); take one with `offered` true in sections.json"
    )]
    NotOffered {
        /// The id.
        id: String,
    },
    /// A material without a rate.
    #[error(
        "`materials` of the brief names `{id}`, for which the price book has no rate; expected one of C24, GL24h, GL28h, S235, S355"
    )]
    UnpricedMaterial {
        /// The id.
        id: String,
    },
}

impl Evaluator {
    /// Reads tilesets, books, catalogue and loads for a brief.
    ///
    /// # Errors
    /// [`LoadFailure`], naming file and key.
    pub fn load(brief: Brief, paths: &Paths) -> Result<Evaluator, LoadFailure> {
        let catalogue = Catalogue::load(&paths.configs)?;
        for id in &brief.materials {
            if FrameMaterial::from_id(id).is_none() {
                return Err(LoadFailure::UnpricedMaterial { id: id.clone() });
            }
        }
        let options = section_options(&catalogue, &brief)?;
        let books = Books {
            prices: PriceBook::load_from(&paths.book(&brief.prices), Some(&paths.configs))?,
            carbon: CarbonBook::load(&paths.book(&brief.carbon))?,
            buildups: BuildUps::load(&paths.book(&brief.buildups))?,
        };
        let loads = load_settings(&LoadTable::load(&paths.configs)?, &brief.site, surface_weights(&books)?)?;
        let rates = books.rates()?;
        let tiling = Tiling::load(&paths.tileset, &books)?;
        let linear = LinearTileset::load(&paths.linear)?;
        let rules = rule_settings(&brief)?;
        // Limits of 1 and above on structural ratios are the verdict's own: only stricter ones count beside it.
        let mut limits = brief.limits();
        limits.retain(|l| !l.is_max || l.limit < 1.0 || !l.objective.is_structural());
        let (idle, carcasses) = Default::default();
        Ok(Evaluator { brief, limits, catalogue, options, tiling, linear, books, rates, loads, rules, idle, carcasses })
    }
}

fn section_options(catalogue: &Catalogue, brief: &Brief) -> Result<[Vec<SectionOption>; 4], LoadFailure> {
    if let Some(ids) = brief.sections.list() {
        for id in ids {
            match catalogue.sections.iter().find(|s| &s.id == id) {
                None => return Err(LoadFailure::UnknownSection { id: id.clone() }),
                Some(s) if !s.offered => return Err(LoadFailure::NotOffered { id: id.clone() }),
                Some(_) => {}
            }
        }
    }
    let mut all: [Vec<SectionOption>; 4] = Default::default();
    for (slot, group) in all.iter_mut().zip([Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof]) {
        let fitting = catalogue.options(group, &brief.materials)?;
        let wanted = |option: &SectionOption| match brief.sections.list() {
            None => true,
            Some(ids) => ids.contains(&catalogue.section(*option).id),
        };
        *slot = fitting.iter().copied().filter(wanted).collect();
        if slot.is_empty() {
            let names: Vec<&str> = fitting.iter().map(|o| catalogue.section(*o).id.as_str()).collect();
            return Err(LoadFailure::NoSection {
                group: group.name(),
                materials: brief.materials.join(", "),
                candidates: names.join(", "),
            });
        }
    }
    Ok(all)
}

fn surface_weights(books: &Books) -> Result<SurfaceWeights, PriceError> {
    let mut weights = SurfaceWeights { surface_kn_m2: [0.0; 10], floor_kn_m2: 0.0, wall_both_kn_m2: 0.0 };
    let weight = |item: Item| -> Result<f64, PriceError> {
        // Without the members of the frame, whose weight the analysis knows.
        Ok(books.buildup(item)?.rates.mass_kg * FREE_FALL_M_S2 / 1e3)
    };
    for surface in Surface::ALL {
        let item = Item::of_surface(surface);
        // Doors are billed by the piece; spread over the 2.1 m2 of a leaf they weigh about as much as a window.
        let item = if item == Item::Door { Item::Window } else { item };
        weights.surface_kn_m2[surface as usize] = weight(item)?;
    }
    weights.floor_kn_m2 = weight(Item::InnerFloor)?;
    weights.wall_both_kn_m2 = weight(Item::WallBothSides)?;
    Ok(weights)
}

fn load_settings(table: &LoadTable, site: &Site, weights: SurfaceWeights) -> Result<LoadSettings, LoadError> {
    match (site.vb0_m_s, &site.terrain, site.sk_kn_m2) {
        (Some(vb0_m_s), Some(terrain), Some(sk_kn_m2)) if site.preset.is_none() => {
            let annex = if site.annex.as_deref() == Some("NL") { Annex::Nl } else { Annex::En };
            let site = crate::structure::Site { vb0_m_s, terrain: terrain.clone(), sk_kn_m2, annex };
            table.site(&site, weights)
        }
        _ => Ok(table.thesis(weights)),
    }
}

fn rule_settings(brief: &Brief) -> Result<rules::RuleSettings, LoadFailure> {
    let mut settings = match &brief.rules {
        None => rules::RuleSettings::default(),
        Some(map) => serde_json::from_value(serde_json::Value::Object(map.clone()))
            .map_err(|e| LoadFailure::Rules(e.to_string()))?,
    };
    let given = |key: &str| brief.rules.as_ref().is_some_and(|map| map.contains_key(key));
    let programme = &brief.programme;
    if !given("clear_height_min_m") {
        settings.clear_height_min_m = programme.clear_height_m;
    }
    if !given("glazing_ratio_min") {
        settings.glazing_ratio_min = settings.glazing_ratio_min.max(programme.glazing_ratio_min);
    }
    if !given("entrances_min") {
        settings.entrances_min = programme.entrances_min;
    }
    if !programme.reachable {
        settings.off.push("storeys-reached".into());
    }
    settings.validate().map_err(|e| LoadFailure::Rules(e.to_string()))?;
    Ok(settings)
}
