//! `tileset sheet --houses`: the sample houses built with a set, priced and analysed, on one picture.

use std::path::Path;

use houscaper::export::dossier::house_scene;
use houscaper::export::picture::{Picture, render};
use houscaper::export::plots::{Card, contact_sheet};
use houscaper::score::{SizingGoal, Tiling, floor_area_m2};
use houscaper::structure::Verdict;
use houscaper::voxels::{Choices, samples};
use rayon::prelude::*;

use crate::cli::failure::{Blame, Failure, Outcome};
use crate::cli::progress::WorkBar;
use crate::cli::{input, output};

/// Pictures in a row.
const COLUMNS: usize = 3;

pub fn run(dir: &Path, root: Option<&Path>, out: &Path) -> Outcome {
    output::check_picture(out, dir)?;
    let mut evaluator = input::evaluator_for(None, None)?;
    evaluator.tiling = Tiling::load_from(dir, root, &evaluator.books).input()?;
    let houses = samples::gallery();
    let bar = WorkBar::new(houses.len(), "houses");
    let cards = houses
        .par_iter()
        .map(|(name, house)| {
            let choices =
                evaluator.size(house, SizingGoal::Price).map_or_else(Choices::default, |sized| sized.choices());
            let details = evaluator.details(house, &choices);
            let fabric = evaluator.tiling.fabric(house, &details.reading);
            let scene = house_scene(name, house, &details, &evaluator, fabric.as_ref()).run()?;
            let image = render(&scene, &Picture::of_house([640, 480])).run()?;
            let storeys = details.reading.storeys.len();
            let verdict = match details.evaluation.assessment.as_ref().map(|a| &a.verdict) {
                Some(Verdict::Ok) => "structure ok",
                Some(Verdict::NotOk { .. }) => "structure not ok",
                Some(Verdict::Unstable { .. }) => "unstable",
                Some(Verdict::NotAssessed { .. }) | None => "structure not assessed",
            };
            let caption = format!(
                "{:.0} m² on {storeys} storey{} · {verdict}",
                floor_area_m2(&details.reading),
                if storeys == 1 { "" } else { "s" }
            );
            bar.step();
            Ok(Card { title: (*name).into(), caption, image })
        })
        .collect::<Result<Vec<Card>, Failure>>()?;
    let set = dir.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    output::write(out, &contact_sheet(&format!("{set}: sample houses"), COLUMNS, &cards).run()?)?;
    eprintln!("{}: {} houses", out.display(), cards.len());
    Ok(())
}
