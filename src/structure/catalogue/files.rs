//! `materials.json` and `sections.json` as they are on disk.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, de::DeserializeOwned};

use super::{CatalogueError, CrossSection, DurationFactors, MaterialKind, ServiceClasses, StructuralMaterial};
use crate::structure::checks::Grade;
use crate::structure::checks::{Forming, Section, Shape, Steel};

/// A number with its origin.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub(in crate::structure) struct Sourced<T> {
    pub value: T,
    #[allow(dead_code, reason = "read so that a missing unit is an error")]
    unit: String,
    #[allow(dead_code, reason = "read so that a missing source is an error")]
    source: String,
    #[allow(dead_code, reason = "read so that a missing date is an error")]
    date: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "keys that must be known to be allowed")]
struct MaterialFile {
    schema: String,
    note: String,
    kmod: BTreeMap<String, Sourced<[f64; 3]>>,
    service_classes: ServiceEntry,
    materials: Vec<MaterialEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ServiceEntry {
    kmod: Sourced<[[f64; 5]; 3]>,
    kdef: Sourced<[f64; 3]>,
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

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Family {
    Shs,
    Rhs,
    Chs,
    I,
    Sawn,
    Glulam,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum FormingEntry {
    Hot,
    Cold,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "keys that must be known to be allowed")]
struct SectionEntry {
    id: String,
    family: Family,
    #[serde(default)]
    forming: Option<FormingEntry>,
    b_mm: f64,
    h_mm: f64,
    #[serde(default)]
    t_mm: Option<f64>,
    #[serde(default)]
    tf_mm: Option<f64>,
    #[serde(default)]
    r_mm: Option<f64>,
    a_mm2: f64,
    iy_mm4: f64,
    iz_mm4: f64,
    it_mm4: f64,
    #[serde(default)]
    iw_mm6: Option<f64>,
    offered: bool,
    source: String,
    date: String,
}

/// A JSON file.
pub(in crate::structure) fn read<T: DeserializeOwned>(path: &Path) -> Result<T, CatalogueError> {
    let bytes = std::fs::read(path).map_err(|source| CatalogueError::Read { path: path.into(), source })?;
    serde_json::from_slice(&bytes).map_err(|source| CatalogueError::Parse { path: path.into(), source })
}

/// Duration factors, factors by service class, and materials in file order.
pub(super) fn materials(
    path: &Path,
) -> Result<(DurationFactors, ServiceClasses, Vec<StructuralMaterial>), CatalogueError> {
    let file: MaterialFile = read(path)?;
    let missing = |key: &'static str| CatalogueError::Property { path: path.into(), id: "kmod".into(), key };
    let factor = |id: &'static str| {
        let value = file.kmod.get(id).map(|s| s.value).filter(|k| k.iter().all(|k| *k > 0.0 && *k <= 1.1));
        value.ok_or_else(|| missing(id))
    };
    let k_mod = DurationFactors { timber: factor("timber")?, board: factor("osb3")? };
    let service = ServiceClasses { k_mod: file.service_classes.kmod.value, k_def: file.service_classes.kdef.value };
    if !service.k_mod.iter().flatten().all(|k| *k > 0.0 && *k <= 1.1) || !service.k_def.iter().all(|k| *k > 0.0) {
        return Err(missing("service_classes"));
    }
    let materials = file.materials.into_iter().map(|m| material(m, path)).collect::<Result<_, _>>()?;
    Ok((k_mod, service, materials))
}

/// Sections in file order.
pub(super) fn sections(path: &Path) -> Result<Vec<CrossSection>, CatalogueError> {
    let file: SectionFile = read(path)?;
    file.sections.into_iter().map(|s| section(s, path)).collect()
}

fn material(entry: MaterialEntry, path: &Path) -> Result<StructuralMaterial, CatalogueError> {
    let get = |key: &'static str| {
        let value = entry.properties.get(key).map(|s| s.value).filter(|v| v.is_finite() && *v > 0.0);
        value.ok_or_else(|| CatalogueError::Property { path: path.into(), id: entry.id.clone(), key })
    };
    let mpa = |key: &'static str| get(key).map(|v| v * 1e6);
    let timber = match entry.kind {
        MaterialKind::Steel => None,
        MaterialKind::Sawn | MaterialKind::Glulam => Some(Grade {
            fm: mpa("fm_n_mm2")?,
            ft: mpa("ft0_n_mm2")?,
            fc: mpa("fc0_n_mm2")?,
            fv: mpa("fv_n_mm2")?,
            e05: mpa("e05_n_mm2")?,
            gamma: get("gamma_m")?,
            beta_c: get("beta_c")?,
            k_m: get("k_m")?,
            k_cr: get("k_cr")?,
            glued: entry.kind == MaterialKind::Glulam,
        }),
    };
    let k_def = if timber.is_some() { get("k_def")? } else { 0.0 };
    let (e, g) = (mpa("e_n_mm2")?, mpa("g_n_mm2")?);
    let (steel, thesis_limit) = match timber {
        Some(t) => (None, [0.5 * t.ft, 0.5 * t.fc]),
        None => {
            let (fy, gamma_m0, gamma_m1) = (mpa("fy_n_mm2")?, get("gamma_m0")?, get("gamma_m1")?);
            (Some(Steel { e, g, fy, gamma_m0, gamma_m1 }), [mpa("thesis_n_mm2")?; 2])
        }
    };
    let rho = get("rho_kg_m3")?;
    Ok(StructuralMaterial { e, g, rho, id: entry.id, kind: entry.kind, steel, timber, k_def, thesis_limit })
}

fn section(s: SectionEntry, path: &Path) -> Result<CrossSection, CatalogueError> {
    let positive = |key: &'static str, v: Option<f64>| {
        let v = v.filter(|v| v.is_finite() && *v > 0.0);
        v.ok_or_else(|| CatalogueError::Property { path: path.into(), id: s.id.clone(), key })
    };
    let mm = |key, v| positive(key, v).map(|v| v * 1e-3);
    let (b, h) = (mm("b_mm", Some(s.b_mm))?, mm("h_mm", Some(s.h_mm))?);
    let forming = || match s.forming {
        Some(FormingEntry::Hot) => Ok(Forming::Hot),
        Some(FormingEntry::Cold) => Ok(Forming::Cold),
        None => Err(CatalogueError::Property { path: path.into(), id: s.id.clone(), key: "forming" }),
    };
    let (family, shape) = match s.family {
        Family::Shs => ("shs", Shape::Box { b, h, t: mm("t_mm", s.t_mm)?, forming: forming()? }),
        Family::Rhs => ("rhs", Shape::Box { b, h, t: mm("t_mm", s.t_mm)?, forming: forming()? }),
        Family::Chs => ("chs", Shape::Tube { d: h, t: mm("t_mm", s.t_mm)?, forming: forming()? }),
        Family::I => {
            let [tw, tf, r] = [("t_mm", s.t_mm), ("tf_mm", s.tf_mm), ("r_mm", s.r_mm)].map(|(k, v)| mm(k, v));
            ("i", Shape::I { b, h, tw: tw?, tf: tf?, r: r? })
        }
        Family::Sawn => ("sawn", Shape::Rectangle { b, h }),
        Family::Glulam => ("glulam", Shape::Rectangle { b, h }),
    };
    let a = positive("a_mm2", Some(s.a_mm2))? * 1e-6;
    let iy = positive("iy_mm4", Some(s.iy_mm4))? * 1e-12;
    let iz = positive("iz_mm4", Some(s.iz_mm4))? * 1e-12;
    let j = positive("it_mm4", Some(s.it_mm4))? * 1e-12;
    let mut properties = Section::tabulated(shape, a, [iy, iz], j);
    if s.iw_mm6.is_some() {
        properties.iw = positive("iw_mm6", s.iw_mm6)? * 1e-18;
    }
    Ok(CrossSection { family: family.into(), b, h, a, iy, iz, j, properties, offered: s.offered, id: s.id })
}
