//! How each objective answers to single changes around the named houses.

use std::collections::BTreeMap;

use houscaper::brief::Sense;
use houscaper::export::plots::{self, Axis, Effect};
use houscaper::export::tables::{Cell, csv};
use houscaper::run::RunFolder;
use houscaper::score::Evaluation;
use houscaper::search::massing::encode;
use houscaper::search::neighbours::{Change, Neighbour, Reach, neighbours};
use houscaper::search::select::plain;
use houscaper::voxels::{Choice, Choices};
use rayon::prelude::*;
use serde_json::json;

use super::Job;
use super::results::{FrontHouse, axis};
use crate::cli::failure::{Blame, Failure};
use crate::cli::progress::WorkBar;

/// Neighbours that are evaluated of each house: a bound on the time, and enough to see the range.
const REACH: Reach = Reach { values: 16, draws: 3 };

/// Kinds of change that a plot shows at most.
const SHOWN: usize = 20;

/// The least and the greatest difference that a kind of change makes, and what makes it.
#[derive(Clone, Debug)]
pub struct Range {
    /// Least and greatest, % of the house's own value.
    pub percent: [f64; 2],
    /// What the change leads to at either end; empty for moves of the shape.
    pub by: [String; 2],
}

/// One kind of change.
pub struct Kind {
    /// In words.
    pub name: String,
    /// Whether it is a choice (section, joists, boards) and not a move of the shape.
    pub is_choice: bool,
    /// Neighbours, and feasible ones among them.
    pub count: [usize; 2],
    /// Per objective over the feasible neighbours.
    pub kept: Vec<Option<Range>>,
    /// Per objective over all neighbours that were assessed.
    pub all: Vec<Option<Range>>,
}

impl Kind {
    /// The widest range of the feasible neighbours, %.
    fn span(&self, objective: usize) -> f64 {
        self.kept[objective].as_ref().map_or(0.0, |r| r.percent[1].max(0.0) - r.percent[0].min(0.0))
    }
}

/// What happens around one house.
pub struct Around {
    /// The house, by its place in the front.
    pub index: usize,
    /// Kinds of change, the largest effect over all objectives first.
    pub kinds: Vec<Kind>,
}

impl Around {
    /// Neighbours, and feasible ones among them.
    pub fn count(&self) -> [usize; 2] {
        self.kinds.iter().fold([0, 0], |[a, b], k| [a + k.count[0], b + k.count[1]])
    }
}

/// Evaluates the neighbours of some houses of the front. Nothing here depends on threads: neighbours are drawn by the brief's seed.
pub fn around(job: &Job, front: &[FrontHouse], houses: &[usize]) -> Vec<Around> {
    let seed = job.evaluator.brief.search.seed;
    let sets: Vec<Vec<Neighbour>> =
        houses.par_iter().map(|&h| neighbours(&front[h].design, &job.space, REACH, seed)).collect();
    let total = sets.iter().map(Vec::len).sum();
    eprintln!("sensitivity: {total} single changes around {} houses", houses.len());
    let bar = WorkBar::new(total, "changes");
    let one = |n: &Neighbour| {
        let house = encode(&n.design.massing, &job.space.plot);
        let evaluation = job.evaluator.evaluate(&house, &n.design.choices);
        bar.step();
        evaluation
    };
    let sets = sets.into_iter().zip(houses);
    sets.map(|(set, &index)| {
        let evaluations: Vec<Evaluation> = set.par_iter().map(one).collect();
        Around { index, kinds: kinds(job, &front[index], &set, &evaluations) }
    })
    .collect()
}

/// What a change is called: its kind, whether it is a choice, and what it leads to.
fn describe(job: &Job, from: &Choices, change: Change) -> (String, bool, String) {
    let Change::Choice(choice, value) = change else {
        let Change::Move(one) = change else { return Default::default() };
        return (one.name().replace('_', " "), false, String::new());
    };
    let to = Choices(std::array::from_fn(|c| if c == choice as usize { value } else { from.0[c] }));
    let section = |part: &str| {
        let [old, new] = [from, &to].map(|c| job.evaluator.sections(c)[choice as usize]);
        let what = if old.material == new.material { "section" } else { "material" };
        (format!("{part} {what}"), true, job.evaluator.catalogue.option_name(new))
    };
    match choice {
        Choice::Wall => section("wall"),
        Choice::Floor => section("joist"),
        Choice::Beam => section("beam"),
        Choice::Roof => section("rafter"),
        Choice::Joists => {
            let plate = (value ^ from.0[choice as usize]).trailing_zeros();
            let axis = if to.joists_along_y(plate as usize) { 'y' } else { 'x' };
            ("joist direction".into(), true, format!("plate {} along {axis}", plate + 1))
        }
        Choice::Boards => ("wall boards".into(), true, job.evaluator.boards(&to).name().to_owned()),
    }
}

fn kinds(job: &Job, centre: &FrontHouse, set: &[Neighbour], evaluations: &[Evaluation]) -> Vec<Kind> {
    let goals = &job.evaluator.brief.objectives;
    let own: Vec<f64> = goals.iter().map(|g| centre.evaluation.values.get(g.objective)).collect();
    let mut found: BTreeMap<(bool, String), Kind> = BTreeMap::new();
    for (neighbour, evaluation) in set.iter().zip(evaluations) {
        let (name, is_choice, by) = describe(job, &centre.design.choices, neighbour.change);
        let none = || vec![None; goals.len()];
        let kind = found.entry((is_choice, name.clone())).or_insert_with(|| Kind {
            name,
            is_choice,
            count: [0, 0],
            kept: none(),
            all: none(),
        });
        let assessed = !evaluation.minimised(goals).is_empty();
        let feasible = assessed && evaluation.is_feasible();
        kind.count[0] += 1;
        kind.count[1] += usize::from(feasible);
        for (m, goal) in goals.iter().enumerate() {
            let percent =
                100.0 * (evaluation.values.get(goal.objective) - own[m]) / own[m].abs().max(f64::MIN_POSITIVE);
            if assessed && percent.is_finite() {
                widen(&mut kind.all[m], percent, &by);
                if feasible {
                    widen(&mut kind.kept[m], percent, &by);
                }
            }
        }
    }
    let mut kinds: Vec<Kind> = found.into_values().collect();
    let spans: Vec<f64> = (0..goals.len()).map(|m| kinds.iter().map(|k| k.span(m)).fold(1e-9, f64::max)).collect();
    let effect = |k: &Kind| (0..goals.len()).map(|m| k.span(m) / spans[m]).fold(0.0, f64::max);
    kinds.sort_by(|a, b| effect(b).total_cmp(&effect(a)).then_with(|| a.name.cmp(&b.name)));
    kinds
}

fn widen(range: &mut Option<Range>, percent: f64, by: &str) {
    let range = range.get_or_insert_with(|| Range { percent: [percent; 2], by: [by.to_owned(), by.to_owned()] });
    if percent < range.percent[0] {
        (range.percent[0], range.by[0]) = (percent, by.to_owned());
    }
    if percent > range.percent[1] {
        (range.percent[1], range.by[1]) = (percent, by.to_owned());
    }
}

/// Writes `sensitivity.csv` and a plot for each house.
pub fn write(
    job: &Job,
    arounds: &[Around],
    front: &[FrontHouse],
    names: &(dyn Fn(usize) -> String + Sync),
    folder: &RunFolder,
) -> Result<(), Failure> {
    folder.write("sensitivity.csv", table(job, arounds, front).as_bytes()).run()?;
    // A run that is resumed may name other houses than before.
    folder.remove_folder("plots/sensitivity").run()?;
    let goals = &job.evaluator.brief.objectives;
    let axes: Vec<Axis> = goals.iter().map(|g| axis(g.objective, g.sense == Sense::Max)).collect();
    arounds.par_iter().try_for_each(|around| {
        let house = &front[around.index];
        let value = |g: &houscaper::brief::Goal| {
            let (value, axis) = (house.evaluation.values.get(g.objective), axis(g.objective, false));
            let digits = if value.abs() >= 1000.0 { 0 } else { 2 };
            format!("from {value:.digits$} {}", axis.unit)
        };
        let values: Vec<String> = goals.iter().map(value).collect();
        let percent = |ranges: &[Option<Range>]| ranges.iter().map(|r| r.as_ref().map(|r| r.percent)).collect();
        let shown = around.kinds.iter().filter(|k| k.count[0] > 0).take(SHOWN);
        let effects: Vec<Effect> = shown
            .map(|k| Effect {
                name: format!("{} ({} of {})", k.name, k.count[1], k.count[0]),
                kept: percent(&k.kept),
                all: percent(&k.all),
            })
            .collect();
        let [all, kept] = around.count();
        let title =
            format!("{}: single changes of house {}, {}", job.evaluator.brief.name, house.id, names(around.index));
        let note = format!(
            "{kept} of {all} changed houses keep every constraint; bars show those, in brackets how many of each kind"
        );
        let svg = plots::tornado(&title, &note, &axes, &values, &effects).run()?;
        folder.write(&format!("plots/sensitivity/{}.svg", house.id), svg.as_bytes()).run()?;
        folder.write(&format!("plots/sensitivity/{}.png", house.id), &plots::svg_to_png(&svg, 1.5).run()?).run()
    })
}

fn table(job: &Job, arounds: &[Around], front: &[FrontHouse]) -> String {
    let header = [
        "house",
        "change",
        "kind",
        "neighbours",
        "feasible",
        "objective",
        "value",
        "least_percent",
        "greatest_percent",
        "least_by",
        "greatest_by",
        "infeasible_too_least_percent",
        "infeasible_too_greatest_percent",
    ];
    let goals = &job.evaluator.brief.objectives;
    let rows = arounds.iter().flat_map(|a| a.kinds.iter().map(move |k| (a, k)));
    let cells = rows.flat_map(|(a, k)| {
        goals.iter().enumerate().map(move |(m, goal)| {
            let house = &front[a.index];
            let end = |ranges: &[Option<Range>], n: usize| {
                ranges[m].as_ref().map_or(Cell::Empty, |r| Cell::Number(r.percent[n]))
            };
            let by = |n: usize| k.kept[m].as_ref().map_or(Cell::Empty, |r| Cell::Text(r.by[n].clone()));
            vec![
                Cell::Count(house.id as i64),
                Cell::Text(k.name.clone()),
                Cell::from(if k.is_choice { "choice" } else { "shape" }),
                Cell::Count(k.count[0] as i64),
                Cell::Count(k.count[1] as i64),
                Cell::from(goal.objective.name()),
                Cell::Number(house.evaluation.values.get(goal.objective)),
                end(&k.kept, 0),
                end(&k.kept, 1),
                by(0),
                by(1),
                end(&k.all, 0),
                end(&k.all, 1),
            ]
        })
    });
    csv(&header, cells)
}

/// A line for people: how far each objective goes with one change that keeps every constraint, and which change that is.
pub fn words(job: &Job, around: &Around) -> String {
    let [all, kept] = around.count();
    let mut out = vec![format!("one change away: {kept} of {all} houses keep every constraint")];
    for (m, goal) in job.evaluator.brief.objectives.iter().enumerate() {
        let ends = |n: usize| around.kinds.iter().filter_map(move |k| Some((k.kept[m].as_ref()?.percent[n], k, n)));
        let low = ends(0).filter(|e| e.0 < -0.05).min_by(|a, b| a.0.total_cmp(&b.0));
        let high = ends(1).filter(|e| e.0 > 0.05).max_by(|a, b| a.0.total_cmp(&b.0));
        let told = |end: Option<(f64, &Kind, usize)>, none: &str| match end {
            None => none.to_owned(),
            Some((percent, kind, n)) => {
                let to = kind.kept[m].as_ref().map_or("", |r| &r.by[n]);
                let by = [kind.name.as_str(), to].join(" ");
                format!("{percent:+.1} % by {}", by.trim())
            }
        };
        let name = plain(goal.objective.name());
        out.push(format!("{name}: {}, {}", told(low, "none lowers it"), told(high, "none raises it")));
    }
    out.join("; ")
}

/// For `--json`.
pub fn report(job: &Job, around: &Around) -> serde_json::Value {
    let goals = &job.evaluator.brief.objectives;
    let [all, kept] = around.count();
    let kinds = around.kinds.iter().map(|k| {
        let ends = |m: usize| k.kept[m].as_ref().map(|r| r.percent);
        let objectives: serde_json::Map<String, serde_json::Value> =
            goals.iter().enumerate().map(|(m, g)| (g.objective.name().into(), json!(ends(m)))).collect();
        json!({"change": k.name, "neighbours": k.count[0], "feasible": k.count[1], "percent": objectives})
    });
    json!({"neighbours": all, "feasible": kept, "changes": kinds.collect::<Vec<_>>()})
}
