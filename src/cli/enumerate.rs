//! `houscaper enumerate`: every design of a small brief, and its true front.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use houscaper::brief::Sense;
use houscaper::score::Evaluator;
use houscaper::search::Score;
use houscaper::search::archive::Entry;
use houscaper::search::cells::Cells;
use houscaper::search::enumerate::front::{Truth, count, front};
use houscaper::search::enumerate::{Shapes, shapes};
use houscaper::search::massing::{Design, Infill, Opening};
use houscaper::search::plot::Space;
use houscaper::search::symmetry::Symmetry;
use serde_json::{Value, json};

use super::failure::{Blame, Outcome};
use super::output::{self, say};
use super::progress::SearchBar;
use super::{input, optimize, space};

/// Arguments of `houscaper enumerate`.
#[derive(Args)]
pub struct Enumerate {
    /// The brief: a small plot, few sections.
    pub brief: PathBuf,
    /// File for counts, hash and front (JSON); without it they are printed.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Count and hash the designs only, without evaluating them.
    #[arg(long)]
    pub count: bool,
    /// Shapes after which a brief counts as too large.
    #[arg(long, value_name = "N", default_value_t = 2_000_000)]
    pub most: usize,
    /// Worker threads; the result does not depend on it [default: all cores].
    #[arg(long)]
    pub threads: Option<usize>,
}

pub fn run(args: Enumerate) -> Outcome {
    optimize::use_threads(args.threads)?;
    if let Some(out) = &args.out {
        output::check_target(out, &args.brief)?;
    }
    let (brief, folder) = input::brief(&args.brief)?;
    let evaluator = input::evaluator(brief, folder.clone())?;
    let space = space::of(&evaluator, &folder)?;
    let started = Instant::now();
    let found = shapes(&space, &|house| evaluator.broken_rule(house), args.most).input()?;
    let (designs, hash) = count(&found.designs, &space);
    eprintln!(
        "{}: {} footprints, {} shapes, {designs} designs, listed in {:.1} s",
        evaluator.brief.name,
        found.footprints,
        found.designs.len(),
        started.elapsed().as_secs_f64()
    );
    if evaluator.brief.objectives.iter().any(|g| g.objective.is_structural()) {
        eprintln!(
            "note: one image of a house stands for all, and the analysis gives some mirror images sways (seen: 0.7 %) and deflections (0.3 %, under hips) that differ: the front is exact to that"
        );
    }
    let mut report = head(&evaluator, &space, &found, designs, hash);
    if !args.count {
        let truth = evaluated(&evaluator, &space, &found, designs);
        let seconds = started.elapsed().as_secs_f64();
        eprintln!("{} feasible, front of {} in {seconds:.1} s", truth.feasible, truth.front.len());
        add_front(&mut report, &truth);
    }
    let mut text = serde_json::to_string_pretty(&report).run()?;
    text.push('\n');
    match &args.out {
        Some(out) => output::write(out, text.as_bytes()),
        None => {
            say!("{}", text.trim_end());
            Ok(())
        }
    }
}

fn evaluated(evaluator: &Evaluator, space: &Space, found: &Shapes, designs: u64) -> Truth {
    let bar = SearchBar::new(designs);
    let goals = &evaluator.brief.objectives;
    let truth = front(
        found,
        space,
        &|design, house| {
            let evaluation = evaluator.evaluate(house, &design.choices);
            Score { objectives: evaluation.minimised(goals), violation: evaluation.violation }
        },
        &mut |done| bar.update(done, 0, None),
    );
    bar.finish();
    truth
}

fn head(evaluator: &Evaluator, space: &Space, found: &Shapes, designs: u64, hash: u128) -> Value {
    let brief = &evaluator.brief;
    let objectives: Vec<Value> = brief
        .objectives
        .iter()
        .map(|g| json!({"name": g.objective.name(), "sense": if g.sense == Sense::Max { "max" } else { "min" }}))
        .collect();
    let rejected: BTreeMap<&str, u64> = found.rejected.clone();
    json!({
        "schema": "houscaper.exact/1",
        "brief": brief.name,
        "symmetries": Symmetry::of(&space.plot).len(),
        "options": space.choices.options,
        "footprints": found.footprints,
        "shapes": found.designs.len(),
        "rejected_shapes": rejected,
        "designs": designs,
        "hash": format!("{hash:032x}"),
        "objectives": objectives,
    })
}

fn add_front(report: &mut Value, truth: &Truth) {
    let member = |e: &Entry<(u128, Design)>| {
        let (key, design) = &e.item;
        json!({"key": format!("{key:032x}"), "minimised": e.objectives, "design": drawn(design)})
    };
    let mut entries = truth.front.entries();
    entries.sort_by(|a, b| {
        a.objectives
            .iter()
            .zip(&b.objectives)
            .map(|(x, y)| x.total_cmp(y))
            .find(|o| o.is_ne())
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    report["feasible"] = json!(truth.feasible);
    report["reference"] = json!(truth.reference);
    report["hypervolume"] = json!(truth.hypervolume);
    report["front"] = entries.into_iter().map(member).collect();
}

/// A design for readers: plans from north to south, openings in words.
fn drawn(design: &Design) -> Value {
    let storeys: Vec<Value> = design
        .massing
        .storeys
        .iter()
        .map(|s| {
            let openings: Vec<String> = s.openings.iter().map(opening).collect();
            json!({"plan": rows(&s.footprint), "openings": openings, "stair": s.stair})
        })
        .collect();
    json!({"storeys": storeys, "roof_rise": design.massing.roof.rise(), "choices": design.choices.0})
}

fn rows(plan: &Cells) -> Vec<String> {
    let [nx, ny] = plan.size();
    let mark = |x: usize, y: usize| if plan.has([x as isize, y as isize]) { '#' } else { '.' };
    (0..ny).rev().map(|y| (0..nx).map(|x| mark(x, y)).collect()).collect()
}

fn opening(o: &Opening) -> String {
    let what = match o.infill {
        Infill::Door => "door".into(),
        Infill::Window => format!("window {} x {}", o.width, o.height()),
    };
    format!("{what}, {:?}, from ({}, {})", o.facing, o.cell[0], o.cell[1]).to_lowercase()
}
