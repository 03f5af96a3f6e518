//! A solved frame in a few lines.

use houscaper::analysis::file::FrameFile;
use houscaper::analysis::{BucklingAnswer, Solution, Status};

use super::Cost;
use super::along;
use super::expected;
use super::numbers::Numbers;
use crate::cli::check::plural;
use crate::cli::output::say;

/// Most idle directions and disagreements listed.
const MOST_LISTED: usize = 8;

/// Status, extremes, balance and agreement, in the file's own units.
pub fn print(
    name: &str,
    file: &FrameFile,
    taken: &Cost,
    solution: &Solution,
    results: &[Numbers],
    buckling: &[BucklingAnswer],
) {
    let model = &file.model;
    let title = if file.name.is_empty() { String::new() } else { format!(" ({})", file.name) };
    say!("{name}{title}");
    say!(
        "{} nodes, {} members, {} supports, {} load case{}, {} combination{}{}",
        model.nodes.len(),
        model.members.len(),
        model.supports.len(),
        file.cases.len(),
        plural(file.cases.len()),
        file.combinations.len(),
        plural(file.combinations.len()),
        if file.units.is_empty() { String::new() } else { format!("; units {}", file.units) },
    );
    status(&solution.status);
    cost(taken);
    idle(solution);
    for (k, r) in results.iter().enumerate() {
        case(solution, r);
        match buckling.get(k) {
            Some(BucklingAnswer::Buckles(b)) => say!(
                "  buckles at {:.4} times the load, most at {:.5} along member {} in direction {:.2} {:.2} {:.2}",
                b.factor,
                b.x,
                b.member,
                b.direction[0],
                b.direction[1],
                b.direction[2]
            ),
            Some(BucklingAnswer::Never) => say!("  never buckles: nothing is compressed"),
            Some(BucklingAnswer::Unknown) => say!("  buckling load not found"),
            None => {}
        }
    }
    if !file.expected.is_empty() && !results.is_empty() {
        agreement(&expected::compare(file, results));
    }
}

fn status(status: &Status) {
    match status {
        Status::Solved { residual, .. } => say!("solved: largest residual {residual:.1e}"),
        Status::NearlySingular { condition, weakest, .. } => say!(
            "nearly singular: condition {condition:.1e}; the numbers below cannot be relied on. Weakest motion: {weakest}"
        ),
        Status::Unstable(mechanism) => {
            say!("unstable: {mechanism}");
            say!("no displacements exist; add supports, braces or rigid joints that hold these nodes");
        }
        Status::Empty => say!("empty: nothing to solve"),
    }
}

fn cost(cost: &Cost) {
    let size = cost.size;
    let ms = 1e3 * cost.phases.total().as_secs_f64();
    let estimate = cost.condition.map_or(String::new(), |c| {
        format!(
            "; condition about {c:.0e}: displacements keep {:.0} digits or more",
            (15.95 - c.log10()).max(0.0).floor()
        )
    });
    say!("{} unknowns, {} bytes each, {ms:.2} ms{estimate}", size.unknowns, size.bytes / size.unknowns.max(1));
}

fn idle(solution: &Solution) {
    if solution.idle.is_empty() {
        return;
    }
    let names: Vec<String> = solution.idle.iter().take(MOST_LISTED).map(|i| i.node.to_string()).collect();
    say!(
        "taken out, because nothing resists and nothing loads them: {} direction{} at nodes {}{}",
        solution.idle.len(),
        plural(solution.idle.len()),
        names.join(", "),
        if solution.idle.len() > MOST_LISTED { ", ..." } else { "" }
    );
}

fn case(solution: &Solution, numbers: &Numbers) {
    say!("\n{}", numbers.name);
    for (from, what) in [(0, "displacement"), (3, "rotation")] {
        if let Some(p) = along::largest(&numbers.disp, from) {
            say!("  largest {what:<12} {:>13.5e} {} at node {}", p.value, ["x", "y", "z"][p.at as usize], p.index);
        }
    }
    let members = along::extremes(solution, numbers);
    for (k, name) in ["axial force", "shear y", "shear z", "torsion", "bending y", "bending z"].into_iter().enumerate()
    {
        let Some([least, most]) = along::range(&members, k) else { continue };
        let p = if -least.value > most.value { least } else { most };
        if p.value != 0.0 {
            say!("  largest {name:<12} {:>13.5e} in member {} at {:.5} from its start", p.value, p.index, p.at);
        }
    }
    say!("  loads        {}", vector(&numbers.load.total));
    say!("  reactions    {}", vector(&numbers.reaction.total));
    say!("  out of balance {:.1e} of all forces and moments", numbers.out_of_balance());
}

fn vector(v: &[f64; 6]) -> String {
    v.iter().take(3).map(|x| format!("{x:>13.5e}")).collect::<Vec<_>>().join(" ")
}

fn agreement(found: &expected::Agreement) {
    let good = found.compared - found.off.len();
    say!("\npublished values: {good} of {} agree", found.compared);
    for sentence in found.off.iter().take(MOST_LISTED) {
        say!("  {sentence}");
    }
    if found.off.len() > MOST_LISTED {
        say!("  and {} more", found.off.len() - MOST_LISTED);
    }
}
