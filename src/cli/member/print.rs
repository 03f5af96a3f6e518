//! A checked member on paper.

use houscaper::structure::member::{ClauseLine, MemberReport, Quantity};

use super::expected::Expected;
use crate::cli::output::say;

/// Everything, or with `brief` the verdict only.
pub fn report(r: &MemberReport, expected: &Expected, brief: bool) {
    let name = if r.name.is_empty() { String::new() } else { format!("{}: ", r.name) };
    say!("{name}{} {}", r.material, r.section);
    if !brief {
        list("section and material", &r.properties);
        list("on the way", &r.values);
        clauses(&r.clauses);
        say!("\nassumptions");
        r.notes.iter().for_each(|n| say!("  {n}"));
        say!("not checked");
        r.not_covered.iter().for_each(|n| say!("  {n}"));
        say!("");
    }
    match (&r.reason, &r.governing) {
        (Some(reason), _) => say!("{}: {reason}", r.verdict),
        (None, Some(clause)) => say!("{}: {:.3}, governed by {clause}", r.verdict, r.utilisation),
        (None, None) => say!("{}: no clause applies", r.verdict),
    }
    if !expected.is_empty() {
        let agreement = expected.compare(r);
        say!("published values: {} of {} agree", agreement.compared - agreement.off.len(), agreement.compared);
        agreement.off.iter().for_each(|o| say!("  {o}"));
    }
}

fn list(title: &str, quantities: &[Quantity]) {
    if quantities.is_empty() {
        return;
    }
    say!("\n{title}");
    for q in quantities {
        say!("  {:<14} {:>12} {:<5} {}", plain(&q.key), number(q.value), q.unit, q.meaning);
    }
}

/// A key without the unit at its end, which stands beside its value.
fn plain(key: &str) -> &str {
    ["_mm2", "_mm3", "_mm4", "_mm6", "_mm", "_MPa", "_kNm", "_kN", "_kg_m"]
        .iter()
        .find_map(|unit| key.strip_suffix(unit))
        .unwrap_or(key)
}

/// Four digits that count; large numbers whole.
fn number(v: f64) -> String {
    let a = v.abs();
    if a == 0.0 {
        return "0".into();
    }
    if v.fract() == 0.0 && a < 1e7 {
        return format!("{v:.0}");
    }
    if a >= 1e7 {
        return format!("{v:.4e}");
    }
    let digits = (3 - a.log10().floor() as i32).clamp(0, 6) as usize;
    format!("{v:.digits$}")
}

fn clauses(lines: &[ClauseLine]) {
    if lines.is_empty() {
        return;
    }
    say!("\n{:<28} {:<44} {:>40} {:>8}", "clause", "check", "demand / resistance", "ratio");
    for l in lines {
        let sides = if l.unit.is_empty() {
            format!("{} <= 1", number(l.demand))
        } else {
            let (d, r) = (number(l.demand), number(l.resistance));
            format!("{} {d} / {} {r} {}", l.demand_symbol, l.resistance_symbol, l.unit)
        };
        let place = l.at.map_or(String::new(), |x| format!(" at {x:.2} l"));
        say!("{:<28} {:<44} {sides:>40} {:>8.3}  {}{place}", l.clause, l.name, l.ratio, l.combination);
        if l.unit.is_empty() {
            say!("  {}", l.demand_symbol);
        }
    }
}
