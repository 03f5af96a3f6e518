//! The map of elites of a quality-diversity run: a table, and a picture in each cell.

use std::collections::BTreeMap;

use houscaper::export::dossier::house_scene;
use houscaper::export::picture::{Picture, render};
use houscaper::export::plots::{DiversityMap, Heading, MapCell, diversity_map};
use houscaper::export::tables::{Cell, csv};
use houscaper::run::RunFolder;
use houscaper::search::elites::Elite;
use houscaper::search::massing::{Design, encode};
use houscaper::search::niche::{Descriptor, Niche};
use rayon::prelude::*;

use super::Job;
use super::record::{VARIABLES, natural, variables};
use super::results::caption;
use crate::cli::failure::{Blame, Failure};

type Map = BTreeMap<Niche, Elite<Design>>;

/// Writes `map.csv` and, unless the run wants tables only, `plots/map.svg` and `plots/map.png`. Cells in which nothing feasible was found
/// stay empty.
pub fn write(job: &Job, elites: &Map, folder: &RunFolder) -> Result<(), Failure> {
    let feasible: Vec<(&Niche, &Elite<Design>)> = elites.iter().filter(|(_, e)| e.score.is_feasible()).collect();
    folder.write("map.csv", table(job, &feasible).as_bytes()).run()?;
    if feasible.is_empty() || job.args.tables_only {
        return Ok(());
    }
    eprintln!("drawing the map: {} kinds of houses", feasible.len());
    let (svg, png) = diversity_map(&drawn(job, &feasible)?).run()?;
    folder.write("plots/map.svg", svg.as_bytes()).run()?;
    folder.write("plots/map.png", &png).run()
}

fn table(job: &Job, elites: &[(&Niche, &Elite<Design>)]) -> String {
    let goals = job.evaluator.brief.objectives.iter().map(|g| g.objective.name());
    let header: Vec<&str> = Descriptor::ALL
        .iter()
        .map(|d| d.name())
        .chain(["id"])
        .chain(goals)
        .chain(VARIABLES[1..].iter().copied())
        .collect();
    let rows = elites.iter().map(|(niche, elite)| {
        let mut row: Vec<Cell> = Descriptor::ALL.iter().map(|d| Cell::Text(niche.class(*d).to_owned())).collect();
        row.push(Cell::Count(elite.id as i64));
        row.extend(natural(job, &elite.score.objectives).into_iter().map(Cell::Number));
        row.extend(variables(job, &elite.genome).into_iter().skip(1));
        row
    });
    csv(&header, rows)
}

/// Storeys and footprints down, roofs and glazing across; classes in which nothing was found are left out.
fn drawn(job: &Job, elites: &[(&Niche, &Elite<Design>)]) -> Result<DiversityMap, Failure> {
    use Descriptor::{Footprint, Glazing, Roof, Storeys};
    let goal = job.evaluator.brief.objectives[0];
    let pair = |niche: &Niche, [a, b]: [Descriptor; 2]| [niche.0[a as usize], niche.0[b as usize]];
    let places = |axes: [Descriptor; 2]| -> Vec<[u8; 2]> {
        let mut all: Vec<[u8; 2]> = elites.iter().map(|(niche, _)| pair(niche, axes)).collect();
        all.sort_unstable();
        all.dedup();
        all
    };
    let (down, across) = ([Storeys, Footprint], [Roof, Glazing]);
    let (rows, columns) = (places(down), places(across));
    let name = |d: Descriptor, class: u8| d.classes()[usize::from(class)].to_owned();
    let heading = |axes: [Descriptor; 2]| {
        move |place: &[u8; 2]| Heading { group: name(axes[0], place[0]), name: name(axes[1], place[1]) }
    };
    let first = |e: &Elite<Design>| e.score.objectives.first().copied().unwrap_or(f64::NAN);
    let values = || elites.iter().map(|(_, e)| first(e));
    let (best, worst) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    let cells = elites.par_iter().map(|(niche, elite)| {
        let house = encode(&elite.genome.massing, &job.space.plot);
        let details = job.evaluator.details(&house, &elite.genome.choices);
        let fabric = job.evaluator.tiling.fabric(&house, &details.reading);
        let scene = house_scene(&elite.id.to_string(), &house, &details, &job.evaluator, fabric.as_ref()).run()?;
        let image = render(&scene, &Picture::of_house(DiversityMap::PICTURE)).run()?;
        let at = |places: &[[u8; 2]], axes| places.iter().position(|p| *p == pair(niche, axes)).unwrap_or(0);
        let share = if worst > best { (worst - first(elite)) / (worst - best) } else { 1.0 };
        let words = caption(&details.evaluation);
        let (price, rest) = words.split_once(" · ").unwrap_or((&words, ""));
        Ok(MapCell {
            at: [at(&rows, down), at(&columns, across)],
            caption: [format!("{} · {price}", elite.id), rest.to_owned()],
            worth: share,
            image,
        })
    });
    let cells = cells.collect::<Result<Vec<MapCell>, Failure>>()?;
    Ok(DiversityMap {
        title: format!("{}: the best house of each of {} kinds", job.evaluator.brief.name, cells.len()),
        note: format!(
            "best: {} of {}; bars below the pictures from violet (worst of the map) to yellow (best); glazing is glass over net floor area",
            match goal.sense {
                houscaper::brief::Sense::Min => "least",
                houscaper::brief::Sense::Max => "most",
            },
            goal.objective.title()
        ),
        rows: rows.iter().map(heading(down)).collect(),
        columns: columns.iter().map(heading(across)).collect(),
        cells,
    })
}
