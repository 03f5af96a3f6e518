//! The run folder: tables, the houses of the front, plots and the contact sheet.

use houscaper::brief::{Objective, Sense};
use houscaper::export::dossier::{Dossier, Extent, dossier, tiles_glb};
use houscaper::export::plots::{self, Axis, Card};
use houscaper::export::tables::{Cell, ExplorerRow, designs_csv, explorer_csv, explorer_settings};
use houscaper::run::RunFolder;
use houscaper::score::Evaluation;
use houscaper::search::Score;
use houscaper::search::contribution::spread_subset;
use houscaper::search::hypervolume::reference_point;
use houscaper::search::massing::{Design, encode};
use houscaper::search::proposal::Tally;
use houscaper::search::select::{Named, named_houses};
use houscaper::voxels::House;
use rayon::prelude::*;

use super::chances::{Chances, Neighbours, draw_prices, price_order, uncertainty, write_chances};
use super::looks::{self, Looks};
use super::record::{Record, VARIABLES, natural, row, variables};
use super::sensitivity::{self, Around};
use super::whynot::{self, WhyNot, why_not};
use super::{Found, Job, drawings, moves};
use crate::cli::args::GlbParts;
use crate::cli::failure::{Blame, Failure};

/// A house of the front.
pub struct FrontHouse {
    /// Index of its evaluation.
    pub id: u64,
    /// The genome.
    pub design: Design,
    /// The genome as voxels.
    pub house: House,
    /// Its evaluation.
    pub evaluation: Evaluation,
    /// Objectives, minimised.
    pub objectives: Vec<f64>,
}

/// What was written.
pub struct Written {
    /// The front, best in the first objective first.
    pub front: Vec<FrontHouse>,
    /// The named houses.
    pub named: Vec<Named>,
    /// Their prices in shared draws; none where one of them has no take-off.
    pub chances: Option<Chances>,
    /// The front by price, each with the next.
    pub order: Vec<Neighbours>,
    /// The front by look.
    pub looks: Looks,
    /// Which constraints bind.
    pub why: WhyNot,
    /// Single changes around the named houses, in their order; none where only tables are written.
    pub around: Vec<Around>,
}

/// Pictures on the contact sheet at most.
const SHEET: usize = 30;

/// What a search found, as far as the folder shows it.
pub struct Search<'a> {
    /// Archive, reference point, history.
    pub found: &'a Found,
    /// Draws by operator.
    pub tally: &'a Tally,
    /// Hypervolume of a random search over evaluations.
    pub baseline: Option<&'a Vec<(u64, f64)>>,
    /// Every evaluation.
    pub record: &'a Record,
}

/// Writes everything but `run.json`.
pub fn write(job: &Job, search: &Search, folder: &RunFolder) -> Result<Written, Failure> {
    let Search { found, record, .. } = search;
    folder.write("moves.csv", moves::table(search).as_bytes()).run()?;
    let front = front(job, found);
    let names: Vec<&str> = job.evaluator.brief.objectives.iter().map(|g| g.objective.name()).collect();
    let points: Vec<&[f64]> = front.iter().map(|h| h.objectives.as_slice()).collect();
    let shapes: Vec<_> = front.iter().map(|h| &h.house.voxels).collect();
    let named = named_houses(&points, &shapes, &names, job.reference.as_ref().map(|r| &r.voxels));
    drop((points, shapes));
    folder.write("front.csv", front_csv(job, &front, record).as_bytes()).run()?;
    let prices = draw_prices(job, &front)?;
    folder.write("uncertainty.csv", uncertainty(&front, &prices).as_bytes()).run()?;
    let chances = Chances::new(&named.iter().map(|n| n.index).collect::<Vec<_>>(), &prices);
    write_explorer(job, &front, folder)?;
    for old in folder.folders("front").run()? {
        if job.args.tables_only || !front.iter().any(|h| h.id.to_string() == old) {
            folder.remove_folder(&format!("front/{old}")).run()?;
        }
    }
    let looks = Looks::of(job, &front);
    looks::write(&looks, &front, folder)?;
    let why = why_not(job, found, record, &front);
    whynot::write(job, &why, &front, folder)?;
    let mut around = Vec::new();
    if !front.is_empty() && !job.args.tables_only {
        let name = |index: usize| named.iter().find(|n| n.index == index).map_or(String::new(), |n| n.name.clone());
        around = sensitivity::around(job, &front, &named.iter().map(|n| n.index).collect::<Vec<_>>());
        sensitivity::write(job, &around, &front, &name, folder)?;
        eprintln!("writing {} houses", front.len());
        let dossiers = houses(job, &front, folder)?;
        write_sheet(job, &front, &named, &dossiers, folder)?;
        looks::write_sheet(job, &looks, &front, &named, &dossiers, folder)?;
    }
    drawings::write(job, search, &front, &named, folder)?;
    let written = Written { order: price_order(&front, &prices), front, named, chances, looks, why, around };
    write_chances(job, &written, &prices, folder)?;
    Ok(written)
}

fn front(job: &Job, found: &Found) -> Vec<FrontHouse> {
    let mut front: Vec<FrontHouse> = found
        .archive
        .entries()
        .into_par_iter()
        .map(|entry| {
            let house = encode(&entry.item.massing, &job.space.plot);
            let evaluation = job.evaluator.details(&house, &entry.item.choices).evaluation;
            let objectives = entry.objectives.clone();
            FrontHouse { id: entry.id, design: entry.item.clone(), house, evaluation, objectives }
        })
        .collect();
    let first = |h: &FrontHouse| h.objectives.first().copied().unwrap_or(0.0);
    front.sort_by(|a, b| first(a).total_cmp(&first(b)).then(a.id.cmp(&b.id)));
    front
}

fn front_csv(job: &Job, front: &[FrontHouse], record: &Record) -> String {
    let names: Vec<&str> = job.evaluator.brief.objectives.iter().map(|g| g.objective.name()).collect();
    let score = |h: &FrontHouse| Score { objectives: h.objectives.clone(), violation: 0.0 };
    let rows: Vec<_> = front.iter().map(|h| row(job, h.id, record.generation(h.id), &score(h), &h.design)).collect();
    designs_csv(&names, &VARIABLES, &rows)
}

fn write_explorer(job: &Job, front: &[FrontHouse], folder: &RunFolder) -> Result<(), Failure> {
    let goals = &job.evaluator.brief.objectives;
    let outputs: Vec<&str> = goals.iter().map(|g| g.objective.name()).collect();
    let rows: Vec<ExplorerRow> = front
        .iter()
        .map(|h| ExplorerRow {
            id: h.id,
            inputs: variables(job, &h.design),
            outputs: natural(job, &h.objectives),
            image: format!("front/{}/thumb.png", h.id),
        })
        .collect();
    folder.write("data.csv", explorer_csv(&VARIABLES, &outputs, &rows).as_bytes()).run()?;
    let senses: Vec<(&str, bool)> = goals.iter().map(|g| (g.objective.name(), g.sense == Sense::Min)).collect();
    folder.write("settings.json", explorer_settings(&job.evaluator.brief.name, &senses).as_bytes()).run()
}

/// Writes each house of the front, in parallel; the pictures come back in the front's order.
fn houses(job: &Job, front: &[FrontHouse], folder: &RunFolder) -> Result<Vec<Dossier>, Failure> {
    let extent = if job.args.ifc { Extent::FrontIfc } else { Extent::Front };
    front
        .par_iter()
        .map(|h| {
            let details = job.evaluator.details(&h.house, &h.design.choices);
            let name = format!("{} {}", job.evaluator.brief.name, h.id);
            let dossier =
                dossier(&name, &h.house, &h.design.choices, &details, &job.evaluator, extent.clone()).run()?;
            for (file, bytes) in &dossier.files {
                folder.write(&format!("front/{}/{file}", h.id), bytes).run()?;
            }
            if job.args.glb_parts == GlbParts::Tiles {
                let glb = tiles_glb(&name, &h.house, &h.design.choices, &details, &job.evaluator).run()?;
                glb.map_or(Ok(()), |glb| folder.write(&format!("front/{}/tiles.glb", h.id), &glb)).run()?;
            }
            Ok(Dossier { files: Vec::new(), ..dossier })
        })
        .collect()
}

fn write_sheet(
    job: &Job,
    front: &[FrontHouse],
    named: &[Named],
    dossiers: &[Dossier],
    folder: &RunFolder,
) -> Result<(), Failure> {
    let name_of = |index: usize| named.iter().find(|n| n.index == index).map(|n| n.name.as_str());
    let mut shown: Vec<usize> = named.iter().map(|n| n.index).collect();
    // Beside the named ones, those that together dominate most: a large front is full of near neighbours.
    let points: Vec<&[f64]> = front.iter().map(|h| h.objectives.as_slice()).collect();
    let reference = reference_point(points.iter().copied()).unwrap_or_default();
    shown.extend(spread_subset(&points, &reference, SHEET));
    shown.sort_unstable();
    shown.dedup();
    let cards: Vec<Card> = shown
        .iter()
        .map(|&index| {
            let id = front[index].id;
            Card {
                title: name_of(index).map_or(format!("{id}"), |name| format!("{id} · {name}")),
                caption: caption(&front[index].evaluation),
                image: dossiers[index].picture.clone(),
            }
        })
        .collect();
    let title = format!("{}: {} of {} houses of the front", job.evaluator.brief.name, cards.len(), front.len());
    let png = plots::contact_sheet(&title, 5, &cards).run()?;
    folder.write("plots/contact_sheet.png", &png).run()
}

/// Price, carbon and area in a line.
pub fn caption(evaluation: &Evaluation) -> String {
    let value = |o: Objective| evaluation.values.get(o);
    format!(
        "EUR {:.0}k · {:.1} t CO2e · {:.0} m²",
        value(Objective::PriceEur) / 1e3,
        value(Objective::GwpKgco2e) / 1e3,
        value(Objective::FloorAreaM2)
    )
}

/// Cells for the summary.
pub fn choice_words(job: &Job, design: &Design) -> String {
    let row = variables(job, design);
    let text = |i: usize| match row.get(i) {
        Some(Cell::Text(text)) => text.clone(),
        _ => String::new(),
    };
    format!("walls {}, joists {}, rafters {}", text(7), text(8), text(10))
}

/// An objective as an axis of a plot.
pub fn axis(objective: Objective, maximise: bool) -> Axis {
    let full = objective.title();
    let (title, unit) = match full.rsplit_once(" (") {
        Some((title, unit)) => (title, unit.trim_end_matches(')')),
        None => (full, ""),
    };
    Axis { title: title.into(), unit: if unit == "-" { String::new() } else { unit.into() }, maximise }
}
