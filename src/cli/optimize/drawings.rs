//! The plots of a run.

use houscaper::brief::Sense;
use houscaper::export::plots::{self, Axis, Cloud, Series};
use houscaper::run::RunFolder;
use houscaper::search::select::Named;
use rayon::prelude::*;

use super::moves::{FATES, fates, rejected};
use super::record::natural;
use super::results::{FrontHouse, Search, axis};
use super::{Job, breakdowns};
use crate::cli::failure::{Blame, Failure};

/// Scatter plots, parallel coordinates, hypervolume over evaluations, what became of the moves, what the named houses are made up of,
/// and carbon against price by material, as SVG and PNG.
pub fn write(
    job: &Job,
    search: &Search,
    front: &[FrontHouse],
    named: &[Named],
    folder: &RunFolder,
) -> Result<(), Failure> {
    let Search { found, tally, baseline, record } = search;
    let goals = &job.evaluator.brief.objectives;
    let axes: Vec<Axis> = goals.iter().map(|g| axis(g.objective, g.sense == Sense::Max)).collect();
    let feasible = record.cloud().to_vec();
    let front_points: Vec<Vec<f64>> = front.iter().map(|h| natural(job, &h.objectives)).collect();
    let labels: Vec<plots::Named> =
        named.iter().map(|n| plots::Named { name: n.name.clone(), values: front_points[n.index].clone() }).collect();
    let cloud = Cloud { feasible, infeasible: Vec::new(), front: front_points };
    let name = &job.evaluator.brief.name;
    let mut sheets: Vec<(String, String)> = Vec::new();
    for (x, y) in (0..goals.len()).flat_map(|y| (0..y).map(move |x| (x, y))) {
        let colour = (0..goals.len()).find(|c| *c != x && *c != y);
        let title = format!("{name}: {} evaluated houses and the front", record.count());
        let file = format!("pareto_{}_{}", goals[x].objective.name(), goals[y].objective.name());
        sheets.push((file, plots::pareto(&title, &axes, [x, y], colour, &cloud, &labels).run()?));
    }
    if goals.len() > 2 {
        let title = format!("{name}: {} evaluated houses, all pairs", record.count());
        sheets.push(("scatter_matrix".into(), plots::scatter_matrix(&title, &axes, &cloud).run()?));
    }
    if goals.len() > 1 {
        let title = format!("{name}: the front");
        sheets.push(("parallel".into(), plots::parallel_coordinates(&title, &axes, &cloud, &labels).run()?));
    }
    let unit = found.progress.box_volume.unwrap_or(1.0);
    let points = |history: &[(u64, f64)]| history.iter().map(|(e, h)| [*e as f64, h / unit]).collect();
    let mut series = vec![Series { name: "search".into(), points: points(&found.history) }];
    if let Some(history) = baseline {
        series.push(Series { name: "random moves".into(), points: points(history) });
    }
    let title = format!("{name}: hypervolume of the archive");
    sheets.push(("hypervolume".into(), plots::hypervolume(&title, &ahead(&series), &series).run()?));
    let title = format!("{name}: draws that gave no new house");
    sheets.push(("rejected".into(), plots::bars(&title, "draws", &rejected(tally)).run()?));
    let title = format!("{name}: what became of the draws of each move");
    sheets.push(("moves".into(), plots::stacked(&title, "share of the draws [%]", &FATES, &fates(search)).run()?));
    sheets.extend(breakdowns::sheets(job, front, named)?);
    sheets.par_iter().try_for_each(|(file, svg)| {
        folder.write(&format!("plots/{file}.svg"), svg.as_bytes()).run()?;
        let png = plots::svg_to_png(svg, 1.5).run()?;
        folder.write(&format!("plots/{file}.png"), &png).run()
    })
}

/// After how many evaluations the search had what the random one ended with.
fn ahead(series: &[Series]) -> String {
    let [search, random] = series else {
        return "--baseline adds a random search of as many evaluations".into();
    };
    let last = random.points.last().map_or([0.0; 2], |p| *p);
    match plots::reached(search, last[1]) {
        Some(after) => format!(
            "after {after:.0} evaluations at the latest the search had what {} random ones end with ({:.0} %)",
            last[0],
            100.0 * after / last[0].max(1.0)
        ),
        None => format!("the {} random evaluations end above the search", last[0]),
    }
}
