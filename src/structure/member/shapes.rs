//! Sections by their names: from the catalogue, or sizes such as `RHS200x100x16 hot finished` and `60x200`.

use super::error::MemberError;
use super::input::{FormingWord, Input};
use crate::structure::Catalogue;
use crate::structure::checks::{Forming, Section, Shape};

/// A section with the name to print.
pub(super) struct Named {
    pub id: String,
    pub section: Section,
}

/// The section of an input, with the properties it gives in the place of computed ones.
pub(super) fn section(input: &Input, catalogue: &Catalogue) -> Result<Named, MemberError> {
    let mut named = match &input.section {
        Some(text) => agreeing(by_name(text, input, catalogue)?, input)?,
        None => by_size(input)?,
    };
    let s = &mut named.section;
    let scaled = |key, v: Option<f64>, unit: f64| positive(key, v).map(|v| v.map(|v| v * unit));
    if let Some(i) = scaled("I_mm4", input.i_mm4, 1e-12)? {
        s.i = [i; 2];
    }
    let set = |into: &mut f64, key, v: Option<f64>, unit: f64| -> Result<(), MemberError> {
        if let Some(v) = scaled(key, v, unit)? {
            *into = v;
        }
        Ok(())
    };
    set(&mut s.a, "A_mm2", input.a_mm2, 1e-6)?;
    set(&mut s.i[0], "Iy_mm4", input.iy_mm4, 1e-12)?;
    set(&mut s.i[1], "Iz_mm4", input.iz_mm4, 1e-12)?;
    set(&mut s.it, "It_mm4", input.it_mm4, 1e-12)?;
    set(&mut s.iw, "Iw_mm6", input.iw_mm6, 1e-18)?;
    let [b, h] = s.shape.size();
    s.wel = [2.0 * s.i[0] / h, 2.0 * s.i[1] / b];
    set(&mut s.wpl[0], "Wpl_y_mm3", input.wpl_y_mm3, 1e-9)?;
    set(&mut s.wpl[1], "Wpl_z_mm3", input.wpl_z_mm3, 1e-9)?;
    Ok(named)
}

/// A number that must be over zero when it is given.
pub(super) fn positive(key: &'static str, v: Option<f64>) -> Result<Option<f64>, MemberError> {
    match v {
        Some(v) if !(v.is_finite() && v > 0.0) => {
            Err(MemberError::Range { key, found: v, expected: "a number over 0" })
        }
        v => Ok(v),
    }
}

/// Hot or cold from the key, else from words such as `hot finished` in the section's or the steel's name.
fn forming(text: &str, input: &Input) -> Option<Forming> {
    let steel = input.material.as_deref().unwrap_or_default();
    let says = |word: &str| text.contains(word) || steel.to_lowercase().contains(word);
    match input.forming {
        Some(FormingWord::Hot) => Some(Forming::Hot),
        Some(FormingWord::Cold) => Some(Forming::Cold),
        None if says("hot") || text.starts_with("hf-") => Some(Forming::Hot),
        None if says("cold") => Some(Forming::Cold),
        None => None,
    }
}

fn by_name(text: &str, input: &Input, catalogue: &Catalogue) -> Result<Named, MemberError> {
    let wanted = text.trim().to_lowercase();
    let known = catalogue.sections.iter().find(|s| s.id.to_lowercase() == wanted);
    if let Some(s) = known.filter(|s| input.forming.is_none_or(|f| made(&s.properties.shape) == Some(f))) {
        return Ok(Named { id: s.id.clone(), section: s.properties });
    }
    let unknown = || MemberError::UnknownSection { id: text.trim().to_owned() };
    let size = wanted.trim_start_matches("hf-");
    let size = size.split_whitespace().next().unwrap_or_default();
    let (kind, size) = size.split_at(size.find(|c: char| c.is_ascii_digit()).ok_or_else(unknown)?);
    let numbers: Result<Vec<f64>, _> = size.split('x').map(|n| n.parse::<f64>().map(|mm| mm * 1e-3)).collect();
    let numbers = numbers.map_err(|_| unknown())?;
    if numbers.iter().any(|n| !(n.is_finite() && *n > 0.0)) {
        return Err(unknown());
    }
    let forming = || forming(&wanted, input).ok_or_else(|| MemberError::Forming { id: text.trim().to_owned() });
    let shape = match (kind, numbers.as_slice()) {
        ("" | "t_" | "gl_", &[b, h]) => Shape::Rectangle { b, h },
        ("shs", &[b, t]) => Shape::Box { b, h: b, t, forming: forming()? },
        ("shs" | "rhs", &[h, b, t]) => Shape::Box { b, h, t, forming: forming()? },
        ("chs", &[d, t]) => Shape::Tube { d, t, forming: forming()? },
        _ => return Err(unknown()),
    };
    Ok(Named { id: text.trim().to_owned(), section: checked(shape, text)? })
}

/// A named section with sizes beside it: they must be its own.
fn agreeing(named: Named, input: &Input) -> Result<Named, MemberError> {
    let [b, h] = named.section.shape.size();
    for (key, given, own) in [("b_mm", input.b_mm, b), ("h_mm", input.h_mm, h)] {
        if given.is_some_and(|mm| (mm * 1e-3 - own).abs() > 1e-4) {
            return Err(MemberError::Twice { first: "section", second: key });
        }
    }
    Ok(named)
}

fn made(shape: &Shape) -> Option<FormingWord> {
    match shape {
        Shape::Box { forming: Forming::Hot, .. } | Shape::Tube { forming: Forming::Hot, .. } => Some(FormingWord::Hot),
        Shape::Box { .. } | Shape::Tube { .. } => Some(FormingWord::Cold),
        Shape::Rectangle { .. } | Shape::I { .. } => None,
    }
}

/// A wall must leave a hollow, corner radii included.
fn checked(shape: Shape, text: &str) -> Result<Section, MemberError> {
    let closed = match shape {
        Shape::Box { b, h, t, .. } => b.min(h) <= 6.0 * t,
        Shape::Tube { d, t, .. } => d <= 2.0 * t,
        Shape::Rectangle { .. } | Shape::I { .. } => false,
    };
    if closed {
        return Err(MemberError::UnknownSection { id: format!("{} (the wall is too thick)", text.trim()) });
    }
    Ok(shape.properties())
}

fn by_size(input: &Input) -> Result<Named, MemberError> {
    let missing = MemberError::Missing { key: "section", hint: "give a name, or b_mm and h_mm of a timber rectangle" };
    let [b, h] = [("b_mm", input.b_mm), ("h_mm", input.h_mm)].map(|(k, v)| positive(k, v));
    let (Some(b), Some(h)) = (b?, h?) else { return Err(missing) };
    let t = positive("t_mm", input.t_mm)?;
    let [b, h] = [b, h].map(|mm| mm * 1e-3);
    match t {
        None => {
            Ok(Named { id: format!("{:.0}x{:.0}", b * 1e3, h * 1e3), section: Shape::Rectangle { b, h }.properties() })
        }
        Some(t) => {
            let id = format!("RHS{:.0}x{:.0}x{t}", h * 1e3, b * 1e3);
            let forming = forming("", input).ok_or_else(|| MemberError::Forming { id: id.clone() })?;
            let section = checked(Shape::Box { b, h, t: t * 1e-3, forming }, &id)?;
            Ok(Named { id, section })
        }
    }
}
