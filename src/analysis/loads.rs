//! Member loads of all cases: local components, fixed-end forces, and what stays for the forces along the member.
//!
//! A frame of a house has many members and most cases load few of them: what is not loaded is passed over.

use super::axes::{Axes3, to_local};
use super::element::Beam;
use super::error::{self, InputError};
use super::fixed_end::{self, FixedEnds, SpanLoad};
use super::model::{Axes, Distribution, LoadCase, MemberLoad, Model};
use super::solution::{Placed, Solution};

/// Fills `fixed_end` and the load tables of `solution`. Returns the first (case, member)
/// whose load reaches an end without stiffness.
pub(super) fn member_loads(
    model: &Model,
    cases: &[LoadCase],
    beams: &[Beam],
    solution: &mut Solution,
    fixed_end: &mut FixedEnds,
) -> Result<Option<(usize, usize)>, InputError> {
    sort_loads(model, cases, beams, solution)?;
    let (columns, members) = (cases.len(), beams.len());
    fixed_end.reset(members, columns);
    for case in 0..columns {
        for (m, (beam, q)) in beams.iter().zip(&solution.uniform[case * members..]).enumerate() {
            if *q != [0.0; 3] {
                *fixed_end.entry(m, case) = fixed_end::uniform(*q, beam.length);
            }
        }
    }
    for p in &solution.placed {
        let beam = &beams[p.member as usize];
        let f = fixed_end.entry(p.member as usize, p.case as usize);
        fixed_end::add_span(f, &p.load, beam.length, beam.phi);
    }
    let mut stray = None;
    for (m, beam) in beams.iter().enumerate().filter(|(_, b)| b.released) {
        for case in 0..columns {
            let Some(f) = fixed_end.get_mut(m, case) else { continue };
            if *f != [0.0; 12] && beam.condense(f) && stray.is_none() {
                stray = Some((case, m));
            }
        }
    }
    Ok(stray)
}

fn sort_loads(model: &Model, cases: &[LoadCase], beams: &[Beam], solution: &mut Solution) -> Result<(), InputError> {
    for (case, loads) in cases.iter().enumerate() {
        let uniform = &mut solution.uniform[case * beams.len()..(case + 1) * beams.len()];
        if loads.gravity != [0.0; 3] {
            for ((member, beam), q) in model.members.iter().zip(beams).zip(uniform.iter_mut()) {
                let mass = model.materials[member.material].rho * model.sections[member.section].a;
                *q = to_local(&beam.axes, loads.gravity.map(|g| mass * g));
            }
        }
        for (n, load) in loads.members.iter().enumerate() {
            let beam = &beams[load.member];
            match local(load, &beam.axes) {
                Local::Uniform(q) => (0..3).for_each(|c| uniform[load.member][c] += q[c]),
                Local::Span(span) => {
                    error::check_span(n, &span, beam.length)?;
                    solution.placed.push(Placed { member: load.member as u32, case: case as u32, load: span });
                }
            }
        }
    }
    solution.placed.sort_by_key(|p| (p.member, p.case));
    Ok(())
}

enum Local {
    Uniform([f64; 3]),
    Span(SpanLoad),
}

fn local(load: &MemberLoad, axes: &Axes3) -> Local {
    let turn = |v: [f64; 3]| match load.axes {
        Axes::Local => v,
        Axes::Global => to_local(axes, v),
    };
    match load.distribution {
        Distribution::Uniform { q } => Local::Uniform(turn(q)),
        Distribution::Linear { q1, q2, x1, x2 } => Local::Span(SpanLoad::Linear { q1: turn(q1), q2: turn(q2), x1, x2 }),
        Distribution::Point { p, x } => Local::Span(SpanLoad::Point { p: turn(p), x }),
    }
}
