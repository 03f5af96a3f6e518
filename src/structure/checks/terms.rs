//! Clauses that are sums, term by term: for reports, outside the hot path.

use super::Clause;

/// Most terms of a clause.
pub const MOST_TERMS: usize = 3;

/// A term of a sum of ratios.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// Its formula.
    pub symbol: &'static str,
    /// Its value, at least 0.
    pub value: f64,
}

/// The terms of a clause in the order of its formula; none for a clause that is one demand against one resistance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Terms([Option<Term>; MOST_TERMS]);

impl Terms {
    /// Of up to three terms.
    pub(super) fn of<const N: usize>(terms: [(&'static str, f64); N]) -> Terms {
        let mut list = [None; MOST_TERMS];
        for (place, (symbol, value)) in list.iter_mut().zip(terms) {
            *place = Some(Term { symbol, value });
        }
        Terms(list)
    }

    /// The terms.
    pub fn iter(&self) -> impl Iterator<Item = Term> + '_ {
        self.0.iter().flatten().copied()
    }

    /// Their sum: the ratio of the clause.
    pub fn sum(&self) -> f64 {
        self.iter().map(|t| t.value).sum()
    }
}

/// Symbols of bending about y and z in the clauses of timber that add both, by which of the two leads.
const TIMBER_BENDING: [[&str; 2]; 2] =
    [["s_m,y,d / f_m,y,d", "k_m s_m,z,d / f_m,z,d"], ["k_m s_m,y,d / f_m,y,d", "s_m,z,d / f_m,z,d"]];

/// Symbols of a clause of timber at a point: of the axial force, if it has one, and of both moments.
pub(super) fn timber(clause: Clause) -> Option<(Option<&'static str>, [&'static str; 2])> {
    let (axial, leads) = match clause {
        Clause::TimberBendingY => (None, 0),
        Clause::TimberBendingZ => (None, 1),
        Clause::TimberTensionBendingY => (Some("s_t,0,d / f_t,0,d"), 0),
        Clause::TimberTensionBendingZ => (Some("s_t,0,d / f_t,0,d"), 1),
        Clause::TimberCompressionBendingY => (Some("(s_c,0,d / f_c,0,d)^2"), 0),
        Clause::TimberCompressionBendingZ => (Some("(s_c,0,d / f_c,0,d)^2"), 1),
        Clause::TimberColumnY => (Some("s_c,0,d / (k_c,y f_c,0,d)"), 0),
        Clause::TimberColumnZ => (Some("s_c,0,d / (k_c,z f_c,0,d)"), 1),
        _ => return None,
    };
    Some((axial, TIMBER_BENDING[leads]))
}
