//! Members: the governing check with its numbers, the range of axial force, the worst deflection.

use super::super::actions::{BaseActions, add, unit_piece};
use super::super::cases::UNITS;
use super::super::check::{Piece, Resistance, design_forces, section_forces, stations};
use super::super::checks::{Checked, Forces, Peaks, Terms};
use super::super::serviceability::span_ratio;
use super::super::strength::restraint;
use super::super::verdict::Check;
use super::Solved;
use crate::frame::Span;

/// A member's results.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MemberReview {
    /// Its worst check of strength or stability; `None` for what nothing loads, as a sole.
    pub governing: Option<GoverningCheck>,
    /// Least and largest axial force over the ultimate combinations, tension positive, N.
    pub axial_n: [f64; 2],
    /// Numbers of the combinations of the two, from 0.
    pub axial_in: [usize; 2],
    /// Its span that comes nearest to a limit.
    pub deflection: Option<SpanDeflection>,
}

impl MemberReview {
    /// The axial force of largest magnitude, tension positive, N.
    pub fn axial_extreme_n(&self) -> f64 {
        let [least, most] = self.axial_n;
        if -least > most { least } else { most }
    }
}

/// A check with its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GoverningCheck {
    /// Clause, demand and resistance.
    pub checked: Checked,
    /// What the demand is made of where the clause is a sum of ratios.
    pub terms: Terms,
    /// Number of the combination, from 0, in the order of the load report.
    pub combination: usize,
    /// Forces at the place; of a clause on stability the largest along the clear length.
    pub forces: Forces,
    /// Distance from the member's start, m; `None` where a clause is about the whole clear length.
    pub at_m: Option<f64>,
    /// Clear length between the points that hold the member, m: buckling length about its strong axis.
    pub clear_m: f64,
    /// Factor for duration of load and moisture; 1 for steel.
    pub k_mod: f64,
}

/// A span's deflection against its limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpanDeflection {
    /// Total or variable.
    pub check: Check,
    /// Length, m.
    pub span_m: f64,
    /// Held at one end only: the limit is of twice the length.
    pub is_cantilever: bool,
    /// Deflection from the chord, m.
    pub deflection_m: f64,
    /// Its limit, m.
    pub limit_m: f64,
}

impl SpanDeflection {
    /// Deflection over limit.
    pub fn ratio(&self) -> f64 {
        self.deflection_m / self.limit_m
    }
}

pub(super) fn members(s: &Solved) -> Vec<MemberReview> {
    let mut out = vec![MemberReview::default(); s.frame.members.len()];
    let factors: Vec<Vec<f64>> = s.combinations.iter().map(|c| s.of(c)).collect();
    let mut actions = BaseActions::default();
    actions.fill(s.frame, s.loads, &s.cases, &s.solution);
    for span in &s.frame.spans {
        let kept = &mut out[span.member as usize];
        checks(s, span, &factors, kept);
        let clear = length(s, span);
        let (ratio, check) = span_ratio(s.frame, s.catalogue, [s.sections; 2], s.loads, &s.solution, &actions, span);
        if kept.deflection.is_none_or(|d| ratio > d.ratio()) {
            let is_cantilever = span.held != [true; 2];
            let share = s.loads.limits[usize::from(check == Check::VariableDeflection)];
            let limit_m = if is_cantilever { 2.0 } else { 1.0 } * clear / share;
            let deflection_m = ratio * limit_m;
            kept.deflection = Some(SpanDeflection { check, span_m: clear, is_cantilever, deflection_m, limit_m });
        }
    }
    out
}

fn length(s: &Solved, span: &Span) -> f64 {
    (span.elements[0] as usize..=span.elements[1] as usize).map(|e| s.solution.length(e)).sum()
}

/// Walks the places of the assessment and keeps the worst check of the span and the extremes of its axial force.
fn checks(s: &Solved, span: &Span, factors: &[Vec<f64>], kept: &mut MemberReview) {
    let member = &s.frame.members[span.member as usize];
    let option = s.sections[member.group as usize];
    let clear_m = length(s, span);
    let (material, section) = (s.catalogue.material(option), s.catalogue.section(option));
    let r = Resistance::new(material, section, member.plies, clear_m, restraint(member.role));
    let first = member.elements().start;
    for (combination, c) in s.combinations.iter().enumerate() {
        let timber = s.catalogue.k_mod.timber[c.duration as usize];
        let k_mod = if material.steel.is_some() { 1.0 } else { timber };
        let keep = |checked: Checked, forces: Forces, at_m: Option<f64>, peaks: &Peaks, kept: &mut MemberReview| {
            let worst = kept.governing.map_or(0.0, |g| g.checked.ratio());
            if checked.ratio() > worst {
                let terms = match at_m {
                    Some(_) => r.terms(checked.clause, &forces, timber),
                    None => r.stability_terms(checked.clause, peaks, timber),
                };
                kept.governing = Some(GoverningCheck { checked, terms, combination, forces, at_m, clear_m, k_mod });
            }
        };
        let mut peaks = Peaks::default();
        for e in span.elements[0] as usize..=span.elements[1] as usize {
            let before: f64 = (first..e).map(|b| s.solution.length(b)).sum();
            let p = piece(s, e, &factors[combination]);
            let (xs, n) = stations(&p, s.solution.length(e));
            for &x in &xs[..n] {
                let forces = design_forces(&p, x);
                r.each(&forces, timber, |checked| keep(checked, forces, Some(before + x), &peaks, kept));
                peaks.add(&forces);
                let axial = section_forces(&p, x)[0];
                if axial < kept.axial_n[0] {
                    (kept.axial_n[0], kept.axial_in[0]) = (axial, combination);
                }
                if axial > kept.axial_n[1] {
                    (kept.axial_n[1], kept.axial_in[1]) = (axial, combination);
                }
            }
        }
        if r.has_peaks() {
            let [top, bottom] = peaks.my;
            let my = if bottom > top { -bottom } else { top };
            let forces = Forces { n: -peaks.compression, my, mz: peaks.mz, ..Forces::default() };
            r.each_stability(&peaks, timber, |checked| keep(checked, forces, None, &peaks, kept));
        }
    }
}

/// Forces and loads of an element under factored cases.
fn piece(s: &Solved, element: usize, factors: &[f64]) -> Piece {
    let mut sum = [0.0; 8];
    for case in 0..UNITS {
        let f = s.cases.slot(case).map_or(0.0, |slot| factors[slot]);
        if f != 0.0 {
            add(&mut sum, f, &unit_piece(&s.solution, &s.cases, element, case));
        }
    }
    sum
}
