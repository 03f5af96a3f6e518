//! Materials and sections from `configs/materials.json` and `configs/sections.json`.

use std::path::{Path, PathBuf};

use serde::{Deserialize, de::DeserializeOwned};
use std::collections::BTreeMap;
use thiserror::Error;

use crate::voxels::Choice;

/// Why a catalogue cannot be used.
#[derive(Debug, Error)]
pub enum CatalogueError {
    /// The file cannot be read.
    #[error("{path}: cannot be read ({source}); the configs folder must hold it")]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The file is not what it should be.
    #[error("{path}: {source}")]
    Parse {
        /// The file.
        path: PathBuf,
        /// Line, column and key.
        source: serde_json::Error,
    },
    /// A property is missing or out of range.
    #[error("{path}: {id}: `{key}` must be given and positive")]
    Property {
        /// The file.
        path: PathBuf,
        /// Material or section.
        id: String,
        /// The property.
        key: &'static str,
    },
    /// A material that the brief names is not in the catalogue.
    #[error("material `{id}` is not in the catalogue; known: {known}")]
    Unknown {
        /// As asked.
        id: String,
        /// Ids in the catalogue.
        known: String,
    },
}

/// A number with its origin.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub(super) struct Sourced<T> {
    pub value: T,
    #[allow(dead_code, reason = "read so that a missing unit is an error")]
    unit: String,
    #[allow(dead_code, reason = "read so that a missing source is an error")]
    source: String,
    #[allow(dead_code, reason = "read so that a missing date is an error")]
    date: String,
}

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

/// Strengths of timber along the grain, Pa, and the factors of EN 1995-1-1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timber {
    /// Bending.
    pub fm: f64,
    /// Tension.
    pub ft: f64,
    /// Compression.
    pub fc: f64,
    /// Shear.
    pub fv: f64,
    /// Fifth percentile of E.
    pub e05: f64,
    /// Partial factor.
    pub gamma: f64,
    /// Straightness factor of 6.3.2.
    pub beta_c: f64,
    /// Redistribution factor of 6.1.6.
    pub k_m: f64,
    /// Crack factor of 6.1.7.
    pub k_cr: f64,
    /// Creep factor.
    pub k_def: f64,
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
    /// Yield strength over gamma M0, Pa; 0 for timber.
    pub fy: f64,
    /// Timber strengths; `None` for steel.
    pub timber: Option<Timber>,
    /// Thesis limits in tension and compression, Pa.
    pub thesis_limit: [f64; 2],
}

/// A section, SI; local y is the strong axis.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossSection {
    /// Name in tables.
    pub id: String,
    /// `shs`, `i`, `sawn` or `glulam`.
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
    /// Shear area, m2: 2/3 of a rectangle's, half of a hollow section's, the web of an I.
    pub av: f64,
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

/// Materials and sections.
#[derive(Clone, Debug, PartialEq)]
pub struct Catalogue {
    /// Factors for the duration of load.
    pub k_mod: DurationFactors,
    /// Materials in file order.
    pub materials: Vec<StructuralMaterial>,
    /// Sections in file order.
    pub sections: Vec<CrossSection>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "keys that must be known to be allowed")]
struct MaterialFile {
    schema: String,
    note: String,
    kmod: BTreeMap<String, Sourced<[f64; 3]>>,
    materials: Vec<MaterialEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "keys that must be known to be allowed")]
struct MaterialEntry {
    id: String,
    name: String,
    kind: MaterialKind,
    properties: BTreeMap<String, Sourced<f64>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "keys that must be known to be allowed")]
struct SectionFile {
    schema: String,
    note: String,
    sections: Vec<SectionEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "keys that must be known to be allowed")]
struct SectionEntry {
    id: String,
    family: String,
    b_mm: f64,
    h_mm: f64,
    #[serde(default)]
    t_mm: Option<f64>,
    a_mm2: f64,
    iy_mm4: f64,
    iz_mm4: f64,
    it_mm4: f64,
    source: String,
    date: String,
}

pub(super) fn read<T: DeserializeOwned>(path: &Path) -> Result<T, CatalogueError> {
    let bytes = std::fs::read(path).map_err(|source| CatalogueError::Read { path: path.into(), source })?;
    serde_json::from_slice(&bytes).map_err(|source| CatalogueError::Parse { path: path.into(), source })
}

impl Catalogue {
    /// Loads `materials.json` and `sections.json` of a folder.
    ///
    /// # Errors
    /// A file that is missing, has unknown keys, or a property that is missing or not positive.
    pub fn load(configs: &Path) -> Result<Catalogue, CatalogueError> {
        let path = configs.join("materials.json");
        let file: MaterialFile = read(&path)?;
        let factor = |id: &'static str| {
            let value = file.kmod.get(id).map(|s| s.value).filter(|k| k.iter().all(|k| *k > 0.0 && *k <= 1.1));
            value.ok_or_else(|| CatalogueError::Property { path: path.clone(), id: "kmod".into(), key: id })
        };
        let k_mod = DurationFactors { timber: factor("timber")?, board: factor("osb3")? };
        let materials = file.materials.into_iter().map(|m| material(m, &path)).collect::<Result<_, _>>()?;
        let path = configs.join("sections.json");
        let file: SectionFile = read(&path)?;
        let sections = file.sections.into_iter().map(|s| section(s, &path)).collect::<Result<_, _>>()?;
        Ok(Catalogue { k_mod, materials, sections })
    }

    /// The options of a role group for the allowed materials, cheapest-first by mass per metre.
    ///
    /// Sections must fit their layer: walls and roofs up to 200 and 245 mm, floors and beams up to 360 mm deep; nothing under 45 mm wide.
    ///
    /// # Errors
    /// A material that is not in the catalogue.
    pub fn options(&self, group: Choice, allowed: &[String]) -> Result<Vec<SectionOption>, CatalogueError> {
        let deepest = match group {
            Choice::Wall => 0.2,
            Choice::Roof => 0.245,
            Choice::Floor | Choice::Beam | Choice::Joists => 0.36,
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
                (family && s.h <= deepest + 1e-9).then_some(SectionOption { material, section })
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

    /// Name of an option, e.g. `C24 T_60x200`.
    pub fn option_name(&self, option: SectionOption) -> String {
        format!("{} {}", self.material(option).id, self.section(option).id)
    }
}

fn material(entry: MaterialEntry, path: &Path) -> Result<StructuralMaterial, CatalogueError> {
    let get = |key: &'static str| {
        let value = entry.properties.get(key).map(|s| s.value).filter(|v| v.is_finite() && *v > 0.0);
        value.ok_or_else(|| CatalogueError::Property { path: path.into(), id: entry.id.clone(), key })
    };
    let mpa = |key: &'static str| get(key).map(|v| v * 1e6);
    let timber = match entry.kind {
        MaterialKind::Steel => None,
        MaterialKind::Sawn | MaterialKind::Glulam => Some(Timber {
            fm: mpa("fm_n_mm2")?,
            ft: mpa("ft0_n_mm2")?,
            fc: mpa("fc0_n_mm2")?,
            fv: mpa("fv_n_mm2")?,
            e05: mpa("e05_n_mm2")?,
            gamma: get("gamma_m")?,
            beta_c: get("beta_c")?,
            k_m: get("k_m")?,
            k_cr: get("k_cr")?,
            k_def: get("k_def")?,
        }),
    };
    let (fy, thesis_limit) = match timber {
        Some(t) => (0.0, [0.5 * t.ft, 0.5 * t.fc]),
        None => (mpa("fy_n_mm2")? / get("gamma_m0")?, [mpa("thesis_n_mm2")?; 2]),
    };
    Ok(StructuralMaterial {
        e: mpa("e_n_mm2")?,
        g: mpa("g_n_mm2")?,
        rho: get("rho_kg_m3")?,
        id: entry.id,
        kind: entry.kind,
        fy,
        timber,
        thesis_limit,
    })
}

fn section(s: SectionEntry, path: &Path) -> Result<CrossSection, CatalogueError> {
    for (key, v) in [
        ("a_mm2", s.a_mm2),
        ("iy_mm4", s.iy_mm4),
        ("iz_mm4", s.iz_mm4),
        ("it_mm4", s.it_mm4),
        ("b_mm", s.b_mm),
        ("h_mm", s.h_mm),
    ] {
        if !(v.is_finite() && v > 0.0) {
            return Err(CatalogueError::Property { path: path.into(), id: s.id, key });
        }
    }
    let a = s.a_mm2 * 1e-6;
    let av = match s.family.as_str() {
        "shs" => a / 2.0,
        "i" => s.h_mm * s.t_mm.unwrap_or(0.0) * 1e-6,
        _ => a / 1.5,
    };
    if av <= 0.0 {
        return Err(CatalogueError::Property { path: path.into(), id: s.id, key: "t_mm" });
    }
    Ok(CrossSection {
        id: s.id,
        family: s.family,
        b: s.b_mm * 1e-3,
        h: s.h_mm * 1e-3,
        a,
        iy: s.iy_mm4 * 1e-12,
        iz: s.iz_mm4 * 1e-12,
        j: s.it_mm4 * 1e-12,
        av,
    })
}
