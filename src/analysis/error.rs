//! What can be wrong with a frame before any solving, and the check for it.

use super::fixed_end::SpanLoad;
use super::model::{Distribution, LoadCase, Model};
use thiserror::Error;

/// Input that describes no frame. A frame that cannot carry its loads is no error but a [`super::Status`].
#[derive(Clone, Debug, PartialEq, Error)]
pub enum InputError {
    /// An index points past its list.
    #[error("{what} {at}: {kind} {index} does not exist, there are {count}; use 0..{count}")]
    Index {
        /// Kind of the item that holds the index.
        what: &'static str,
        /// Its place in the list.
        at: usize,
        /// What is pointed at.
        kind: &'static str,
        /// The index found.
        index: usize,
        /// Items there are.
        count: usize,
    },
    /// A number out of its range.
    #[error("{what} {at}: {key} is {value}, expected {expected}")]
    Value {
        /// Kind of the item.
        what: &'static str,
        /// Its place in the list.
        at: usize,
        /// The quantity.
        key: &'static str,
        /// The value found.
        value: f64,
        /// The range it must keep.
        expected: &'static str,
    },
    /// Both ends in one place, or a reference vector along the member.
    #[error(
        "member {member}: nodes {i} and {j} give it no local axes; move a node apart or turn the reference vector off the member"
    )]
    Axes {
        /// The member.
        member: usize,
        /// Its start node.
        i: usize,
        /// Its end node.
        j: usize,
    },
    /// Two supports on one node.
    #[error("support {at}: node {node} already has a support; merge the two")]
    SecondSupport {
        /// The later support.
        at: usize,
        /// The node.
        node: usize,
    },
    /// A settlement where nothing is held.
    #[error(
        "case {case} ({name}): settlement of node {node} dof {dof}, which no support holds; fix it or drop the settlement"
    )]
    FreeSettlement {
        /// The case.
        case: usize,
        /// Its name.
        name: String,
        /// The node.
        node: usize,
        /// 0 to 5.
        dof: usize,
    },
    /// Shear wanted, no shear area given.
    #[error(
        "section {section}: the model asks for shear (Timoshenko) but {key} is missing; give it or set shear to false"
    )]
    ShearArea {
        /// The section.
        section: usize,
        /// `Asy` or `Asz`.
        key: &'static str,
    },
    /// Too many unknowns for the 32-bit index of the factor.
    #[error("the frame has {unknowns} unknowns; the solver takes at most {limit}")]
    TooLarge {
        /// Unknowns wanted.
        unknowns: usize,
        /// The limit.
        limit: usize,
    },
}

fn index(what: &'static str, at: usize, kind: &'static str, index: usize, count: usize) -> Result<(), InputError> {
    if index < count { Ok(()) } else { Err(InputError::Index { what, at, kind, index, count }) }
}

fn value(
    what: &'static str,
    at: usize,
    key: &'static str,
    value: f64,
    expected: &'static str,
    ok: bool,
) -> Result<(), InputError> {
    if ok && value.is_finite() { Ok(()) } else { Err(InputError::Value { what, at, key, value, expected }) }
}

fn finite(what: &'static str, at: usize, key: &'static str, values: &[f64]) -> Result<(), InputError> {
    values.iter().try_for_each(|&v| value(what, at, key, v, "a finite number", true))
}

/// Checks every index and number of `model`.
pub(super) fn check_model(model: &Model) -> Result<(), InputError> {
    for (n, p) in model.nodes.iter().enumerate() {
        finite("node", n, "coordinate", p)?;
    }
    for (m, mat) in model.materials.iter().enumerate() {
        value("material", m, "E", mat.e, "a positive number", mat.e > 0.0)?;
        value("material", m, "G", mat.g, "a positive number", mat.g > 0.0)?;
        value("material", m, "rho", mat.rho, "zero or more", mat.rho >= 0.0)?;
    }
    for s in 0..model.sections.len() {
        check_section(model, s)?;
    }
    for (m, member) in model.members.iter().enumerate() {
        for n in member.nodes {
            index("member", m, "node", n, model.nodes.len())?;
        }
        index("member", m, "material", member.material, model.materials.len())?;
        index("member", m, "section", member.section, model.sections.len())?;
        value("member", m, "roll", member.roll, "a finite angle", true)?;
        finite("member", m, "reference", member.reference.as_ref().map_or(&[][..], |r| &r[..]))?;
    }
    Ok(())
}

fn check_section(model: &Model, s: usize) -> Result<(), InputError> {
    let section = &model.sections[s];
    value("section", s, "A", section.a, "a positive number", section.a > 0.0)?;
    for (key, v) in [("Iy", section.iy), ("Iz", section.iz), ("J", section.j)] {
        value("section", s, key, v, "zero or more", v >= 0.0)?;
    }
    for (key, v) in [("Asy", section.asy), ("Asz", section.asz)] {
        match v {
            Some(v) => value("section", s, key, v, "a positive number", v > 0.0)?,
            None if model.shear => return Err(InputError::ShearArea { section: s, key }),
            None => {}
        }
    }
    Ok(())
}

/// Checks one case against its model; `fixed` holds per node which dofs a support keeps.
pub(super) fn check_case(model: &Model, at: usize, case: &LoadCase, fixed: &[[bool; 6]]) -> Result<(), InputError> {
    finite("case", at, "gravity", &case.gravity)?;
    for (n, load) in case.nodal.iter().enumerate() {
        index("nodal load", n, "node", load.node, model.nodes.len())?;
        finite("nodal load", n, "F", &load.force)?;
    }
    for (n, load) in case.members.iter().enumerate() {
        index("member load", n, "member", load.member, model.members.len())?;
        let finite = |v: &[f64]| finite("member load", n, "component", v);
        match load.distribution {
            Distribution::Uniform { q } => finite(&q)?,
            Distribution::Linear { q1, q2, .. } => finite(&q1).and_then(|()| finite(&q2))?,
            Distribution::Point { p, .. } => finite(&p)?,
        }
    }
    for (n, s) in case.settlements.iter().enumerate() {
        index("settlement", n, "node", s.node, model.nodes.len())?;
        index("settlement", n, "dof", s.dof, 6)?;
        finite("settlement", n, "value", &[s.value])?;
        if !fixed[s.node][s.dof] {
            let name = case.name.clone();
            return Err(InputError::FreeSettlement { case: at, name, node: s.node, dof: s.dof });
        }
    }
    Ok(())
}

/// Checks that a load lies on its member; places may overshoot the ends by 1e-9 of the length.
pub(super) fn check_span(n: usize, load: &SpanLoad, length: f64) -> Result<(), InputError> {
    let slack = 1e-9 * length;
    let on = |key, x: f64| {
        value("member load", n, key, x, "a place on the member, 0 to its length", x >= -slack && x <= length + slack)
    };
    match *load {
        SpanLoad::Point { x, .. } => on("x", x),
        SpanLoad::Linear { x1, x2, .. } => {
            on("x1", x1)?;
            on("x2", x2)?;
            value("member load", n, "x2", x2, "at least x1", x2 >= x1)
        }
    }
}

/// Which dofs each node's support keeps.
pub(super) fn supported(model: &Model, fixed: &mut Vec<[bool; 6]>) -> Result<(), InputError> {
    fixed.clear();
    fixed.resize(model.nodes.len(), [false; 6]);
    for (at, s) in model.supports.iter().enumerate() {
        index("support", at, "node", s.node, model.nodes.len())?;
        if model.supports[..at].iter().any(|earlier| earlier.node == s.node) {
            return Err(InputError::SecondSupport { at, node: s.node });
        }
        fixed[s.node] = s.fix;
    }
    Ok(())
}
