//! Input with defaults filled in, SI.

use super::actions::{Actions, Loading};
use super::error::MemberError;
use super::input::Input;
use super::shapes::{self, positive};
use crate::structure::checks::Section;
use crate::structure::{Catalogue, MaterialKind, StructuralMaterial};

/// One member, ready.
pub(super) struct Case<'a> {
    pub input: &'a Input,
    pub material: StructuralMaterial,
    pub section_id: String,
    pub section: Section,
    /// Span, m; `None` when no length is given: then nothing about stability is said.
    pub length: Option<f64>,
    /// Buckling lengths about y, about z, for torsion, and distance of lateral supports, m; 0 where held.
    pub lengths: [f64; 4],
    pub actions: Actions,
}

/// What each material is made into.
const STEEL_SHAPES: &str = "steel takes I and hollow sections";
const TIMBER_SHAPES: &str = "timber takes rectangles, e.g. 60x200";

impl<'a> Case<'a> {
    pub fn new(input: &'a Input, catalogue: &Catalogue) -> Result<Self, MemberError> {
        let material = material(input, catalogue)?;
        let named = shapes::section(input, catalogue)?;
        let solid = matches!(named.section.shape, crate::structure::checks::Shape::Rectangle { .. });
        if solid == (material.kind == MaterialKind::Steel) {
            let expected = if solid { STEEL_SHAPES } else { TIMBER_SHAPES };
            return Err(MemberError::Mismatch { section: named.id, material: material.id, expected });
        }
        let (length, lengths) = lengths(input)?;
        let weight = material.rho * crate::structure::FREE_FALL_M_S2 * named.section.a;
        let actions = Actions::new(input, length, weight)?;
        if actions.is_nothing() {
            return Err(MemberError::Missing {
                key: "NEd_kN",
                hint: "no force, moment or load is given; give at least one",
            });
        }
        Ok(Case { input, material, section_id: named.id, section: named.section, length, lengths, actions })
    }

    /// Points to look at: ends, middle, and where a moment turns; as shares of the length.
    pub fn points(&self, loading: &Loading) -> Vec<f64> {
        let turns = [loading.my.turning(), loading.mz.turning()];
        [Some(0.0), Some(0.5), Some(1.0)].into_iter().chain(turns).flatten().collect()
    }
}

fn lengths(input: &Input) -> Result<(Option<f64>, [f64; 4]), MemberError> {
    let metres = |key, v: Option<f64>| positive(key, v).map(|v| v.map(|mm| mm * 1e-3));
    let held = |key, v: Option<f64>| match v {
        Some(0.0) => Ok(Some(0.0)),
        v => metres(key, v),
    };
    let given = metres("L_mm", input.length_mm)?;
    let both = metres("Lcr_mm", input.lcr_mm)?;
    if both.is_some() && (input.lcr_y_mm.is_some() || input.lcr_z_mm.is_some()) {
        return Err(MemberError::Twice { first: "Lcr_mm", second: "Lcr_y_mm or Lcr_z_mm" });
    }
    let y = held("Lcr_y_mm", input.lcr_y_mm)?.or(both).or(given);
    let z = held("Lcr_z_mm", input.lcr_z_mm)?.or(both).or(given);
    let length = given.or(y).filter(|l| *l > 0.0);
    if length.is_none() && (input.lcr_z_mm.is_some() || input.l_lt_mm.is_some()) {
        return Err(MemberError::Missing {
            key: "L_mm",
            hint: "give the length of the member beside its buckling lengths",
        });
    }
    let t = held("Lcr_T_mm", input.lcr_t_mm)?.or(z);
    let lt = held("L_LT_mm", input.l_lt_mm)?.or(length);
    let lt = match input.chi_lt {
        None => lt,
        Some(1.0) => Some(0.0),
        Some(found) => {
            return Err(MemberError::Range {
                key: "chi_LT",
                found,
                expected: "1 (the compressed flange is held) or nothing",
            });
        }
    };
    Ok((length, [y, z, t, lt].map(|l| l.unwrap_or(0.0))))
}

fn material(input: &Input, catalogue: &Catalogue) -> Result<StructuralMaterial, MemberError> {
    let text = input.material.as_deref().map(str::trim).filter(|t| !t.is_empty());
    let text = text.ok_or(MemberError::Missing {
        key: "material",
        hint: "give a steel (S235, S355) or a grade (C24, GL24h, GL28h)",
    })?;
    let word = text.split_whitespace().next().unwrap_or_default();
    let upper = word.to_uppercase();
    if upper.starts_with("CL") {
        return Err(MemberError::Panel { id: word.to_owned() });
    }
    if upper.starts_with('S') && upper.contains("GD") {
        return Err(MemberError::LightGauge { id: word.to_owned() });
    }
    let find = |id: &str| catalogue.materials.iter().find(|m| m.id.eq_ignore_ascii_case(id));
    // S355H is S355 in a hollow section, S355JR the same steel with a toughness.
    let steel: String = upper.chars().take(1 + upper[1..].chars().take_while(char::is_ascii_digit).count()).collect();
    let is_steel = upper.starts_with('S') && steel.len() > 1;
    let found = find(word).or_else(|| is_steel.then(|| find(&steel)).flatten());
    let other = || (is_steel && input.fy_mpa.is_some()).then(|| find("S235")).flatten();
    let mut m = found.or_else(other).cloned().ok_or_else(|| MemberError::UnknownMaterial {
        id: word.to_owned(),
        known: catalogue.materials.iter().map(|m| m.id.as_str()).collect::<Vec<_>>().join(", "),
    })?;
    if found.is_none() {
        m.id = word.to_owned();
    }
    overridden(input, &mut m)?;
    Ok(m)
}

/// Strengths and factors of a book in the place of the catalogue's.
fn overridden(input: &Input, m: &mut StructuralMaterial) -> Result<(), MemberError> {
    let set = |into: &mut f64, key, v: Option<f64>, unit: f64| -> Result<(), MemberError> {
        if let Some(v) = positive(key, v)? {
            *into = v * unit;
        }
        Ok(())
    };
    set(&mut m.e, "E_MPa", input.e_mpa, 1e6)?;
    set(&mut m.g, "G_MPa", input.g_mpa, 1e6)?;
    if let Some(s) = &mut m.steel {
        set(&mut s.fy, "fy_MPa", input.fy_mpa, 1e6)?;
        set(&mut s.gamma_m0, "gamma_M0", input.gamma_m0, 1.0)?;
        set(&mut s.gamma_m1, "gamma_M1", input.gamma_m1, 1.0)?;
        (s.e, s.g) = (m.e, m.g);
    }
    if let Some(t) = &mut m.timber {
        set(&mut t.fm, "fmk_MPa", input.fmk_mpa, 1e6)?;
        set(&mut t.ft, "ft0k_MPa", input.ft0k_mpa, 1e6)?;
        set(&mut t.fc, "fc0k_MPa", input.fc0k_mpa, 1e6)?;
        set(&mut t.fv, "fvk_MPa", input.fvk_mpa, 1e6)?;
        set(&mut t.e05, "E05_MPa", input.e05_mpa, 1e6)?;
        set(&mut t.gamma, "gamma_M", input.gamma_m, 1.0)?;
        set(&mut t.beta_c, "beta_c", input.beta_c, 1.0)?;
        set(&mut t.k_cr, "kcr", input.k_cr, 1.0)?;
    }
    Ok(())
}
