//! Materials and sections from `configs/materials.json` and `configs/sections.json`.

mod error;
mod files;

use std::path::Path;

use serde::Deserialize;

use super::checks::steel::{Class, class_in_compression};
use super::checks::{Grade, Section, Steel};
use crate::voxels::Choice;

pub use error::CatalogueError;
pub(super) use files::{Sourced, read};

/// Steel or timber.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MaterialKind {
    /// Structural steel.
    Steel,
    /// Sawn timber.
    Sawn,
    /// Glued laminated timber.
    Glulam,
}

/// A material with what the checks need, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct StructuralMaterial {
    /// Name in briefs.
    pub id: String,
    /// Steel, sawn or glulam.
    pub kind: MaterialKind,
    /// E, Pa.
    pub e: f64,
    /// G, Pa.
    pub g: f64,
    /// Mean density, kg/m3.
    pub rho: f64,
    /// Strength and partial factors of steel; `None` for timber.
    pub steel: Option<Steel>,
    /// Timber strengths; `None` for steel.
    pub timber: Option<Grade>,
    /// Creep factor kdef of EN 1995-1-1 Table 3.2; 0 for steel.
    pub k_def: f64,
    /// Thesis limits in tension and compression, Pa.
    pub thesis_limit: [f64; 2],
}

/// A section, SI; local y is the strong axis.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSection {
    /// Name in tables.
    pub id: String,
    /// `shs`, `rhs`, `chs`, `i`, `sawn` or `glulam`.
    pub family: String,
    /// Width, m.
    pub b: f64,
    /// Depth, m.
    pub h: f64,
    /// Area, m2.
    pub a: f64,
    /// Strong second moment, m4.
    pub iy: f64,
    /// Weak second moment, m4.
    pub iz: f64,
    /// Torsion constant, m4.
    pub j: f64,
    /// What the checks need: tabulated A, I and It, all else computed from the outline.
    pub properties: Section,
    /// Offered to the search and to house frames; the others, without price or stock length, are for single members.
    pub offered: bool,
}

/// A material and a section that go together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SectionOption {
    /// Index into [`Catalogue::materials`].
    pub material: usize,
    /// Index into [`Catalogue::sections`].
    pub section: usize,
}

/// kmod of EN 1995-1-1 Table 3.1 for permanent, medium and short-term action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DurationFactors {
    /// Solid timber and glulam.
    pub timber: [f64; 3],
    /// Sheathing boards.
    pub board: [f64; 3],
}

impl DurationFactors {
    /// Of a nailed joint of timber and board, sqrt(kmod timber x kmod board), 2.3.2.1(2).
    pub fn joint(&self) -> [f64; 3] {
        [0, 1, 2].map(|n| (self.timber[n] * self.board[n]).sqrt())
    }
}

/// Factors of timber by service class.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ServiceClasses {
    /// kmod of solid timber and glulam, EN 1995-1-1 Table 3.1: by class, then permanent, long, medium, short, instantaneous.
    pub k_mod: [[f64; 5]; 3],
    /// kdef, Table 3.2, by class.
    pub k_def: [f64; 3],
}

/// Materials and sections.
#[derive(Clone, Debug, PartialEq)]
pub struct Catalogue {
    /// Factors for the duration of load in service class 1.
    pub k_mod: DurationFactors,
    /// Factors in every service class.
    pub service: ServiceClasses,
    /// Materials in file order.
    pub materials: Vec<StructuralMaterial>,
    /// Sections in file order.
    pub sections: Vec<CrossSection>,
}

impl Catalogue {
    /// Loads `materials.json` and `sections.json` of a folder.
    ///
    /// # Errors
    /// A file that is missing, has unknown keys, or a property that is missing or not positive.
    pub fn load(configs: &Path) -> Result<Catalogue, CatalogueError> {
        let (k_mod, service, materials) = files::materials(&configs.join("materials.json"))?;
        Ok(Catalogue { k_mod, service, materials, sections: files::sections(&configs.join("sections.json"))? })
    }

    /// The options of a role group for the allowed materials, cheapest-first by mass per metre.
    ///
    /// Sections must be offered, fit their layer (walls and roofs up to 200 and 245 mm, floors and beams up to 360 mm deep; nothing under
    /// 45 mm wide) and, of steel, not be class 4 in compression: local buckling is not assessed (EN 1993-1-1 5.5).
    ///
    /// # Errors
    /// A material that is not in the catalogue.
    pub fn options(&self, group: Choice, allowed: &[String]) -> Result<Vec<SectionOption>, CatalogueError> {
        let deepest = match group {
            Choice::Wall => 0.2,
            Choice::Roof => 0.245,
            Choice::Floor | Choice::Beam | Choice::Joists | Choice::Boards => 0.36,
        };
        let mut found = Vec::new();
        for id in allowed {
            let known = || self.materials.iter().map(|m| m.id.as_str()).collect::<Vec<_>>().join(", ");
            let material = self
                .materials
                .iter()
                .position(|m| m.id == *id)
                .ok_or_else(|| CatalogueError::Unknown { id: id.clone(), known: known() })?;
            let kind = self.materials[material].kind;
            found.extend(self.sections.iter().enumerate().filter_map(|(section, s)| {
                let family = match (kind, s.family.as_str()) {
                    (MaterialKind::Steel, "shs") | (MaterialKind::Sawn, "sawn") | (MaterialKind::Glulam, "glulam") => {
                        true
                    }
                    (MaterialKind::Steel, "i") => matches!(group, Choice::Floor | Choice::Beam),
                    _ => false,
                };
                let option = SectionOption { material, section };
                (s.offered && family && s.h <= deepest + 1e-9 && !self.is_class_4(option)).then_some(option)
            }));
        }
        let mass = |o: &SectionOption| self.materials[o.material].rho * self.sections[o.section].a;
        found.sort_by(|a, b| mass(a).total_cmp(&mass(b)).then((a.material, a.section).cmp(&(b.material, b.section))));
        Ok(found)
    }

    /// The option of a material and a section by their ids.
    pub fn find(&self, material: &str, section: &str) -> Option<SectionOption> {
        let material = self.materials.iter().position(|m| m.id == material)?;
        let section = self.sections.iter().position(|s| s.id == section)?;
        Some(SectionOption { material, section })
    }

    /// Whether a part of a steel section buckles before it yields in uniform compression: class 4 of EN 1993-1-1 5.5, not assessed.
    pub fn is_class_4(&self, option: SectionOption) -> bool {
        let steel = self.material(option).steel;
        steel.is_some_and(|s| class_in_compression(&s, &self.section(option).properties) == Class::Four)
    }

    /// Depth of the floor zone under the slab top, m: 180 mm, or the joist with 35 mm of boards and ceiling.
    pub fn slab_zone_m(&self, floor: SectionOption) -> f64 {
        (self.sections[floor.section].h + 0.035).max(0.18)
    }

    /// Material of an option.
    pub fn material(&self, option: SectionOption) -> &StructuralMaterial {
        &self.materials[option.material]
    }

    /// Section of an option.
    pub fn section(&self, option: SectionOption) -> &CrossSection {
        &self.sections[option.section]
    }

    /// Id of a section by its number in a take-off; empty for a number that is none.
    pub fn section_id(&self, number: u16) -> String {
        self.sections.get(usize::from(number)).map_or_else(String::new, |s| s.id.clone())
    }

    /// Name of an option, e.g. `C24 T_60x200`.
    pub fn option_name(&self, option: SectionOption) -> String {
        format!("{} {}", self.material(option).id, self.section(option).id)
    }
}
