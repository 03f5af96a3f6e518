//! `houscaper improve`: better neighbours of a house that somebody has drawn.

mod explore;
mod lock;
mod report;

use std::path::{Path, PathBuf};

use anyhow::anyhow;
use clap::{Args, ValueEnum};
use houscaper::brief::Objective;
use houscaper::export::dossier::{Extent, dossier};
use houscaper::run::RunFolder;
use houscaper::score::{Evaluation, Evaluator, Sized, SizingGoal};
use houscaper::search::massing::Design;
use houscaper::search::repair::repair;
use houscaper::voxels::{Choices, House, Label, json as voxel_json};
use serde::Serialize;

use super::args::Import;
use super::check::{Asked, violations};
use super::failure::{Blame, Failure, Outcome, bad_input};
use super::output::{check_folder, say};
use super::{choices, genome, input, space};
use explore::Explored;

/// Broken rules that are told of a house that is to be made valid.
const SAID: usize = 5;

#[derive(Args)]
pub struct Improve {
    /// The house: Houscaper JSON, text, MagicaVoxel .vox, a lattice CSV of labels, or sample:NAME.
    pub voxels: PathBuf,
    /// Brief: plot, programme, site, books and section options.
    #[arg(long)]
    pub brief: PathBuf,
    /// Voxels that stay as they are, filled or empty: a box of modules as x0:x1,y0:y1,z0:z1, counted from 0, the last not included
    /// (":" is all, a number one layer), or a lattice CSV of the house's shape whose cells above 0 are locked. May be given several times.
    #[arg(long, value_name = "BOX|CSV")]
    pub lock: Vec<String>,
    /// What should get better [default: price, carbon and stiffness of a house that passes, valid for one that does not].
    #[arg(long, value_enum)]
    pub aim: Option<Aim>,
    /// Least floor area of a neighbour as a share of the house's: a smaller house is cheaper, and no improvement.
    #[arg(long, value_name = "SHARE", default_value_t = 0.97)]
    pub keep_area: f64,
    /// Sections, joists and boards of the house as JSON or a file of it [default: sized at least price, as `build` does].
    #[arg(long)]
    pub choices: Option<String>,
    /// Neighbours evaluated, shared by the aims.
    #[arg(long, value_name = "N", default_value_t = 1500, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub evaluations: u64,
    /// Seed.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Price book instead of the brief's; one that "extends" another replaces or adds single rates.
    #[arg(long, value_name = "FILE")]
    pub prices: Option<PathBuf>,
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    #[command(flatten)]
    pub import: Import,
}

/// What should get better.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Aim {
    /// Cheaper: less `price_eur`.
    Price,
    /// Less fossil carbon: less `gwp_kgco2e`.
    Carbon,
    /// Stiffer: the larger of sway and deflection, each over its limit, gets less.
    Stiffness,
    /// Valid again: the fewest changes after which rules, programme, limits and structure are kept.
    Valid,
}

impl Aim {
    /// All, in the order of tables.
    pub const ALL: [Aim; 4] = [Aim::Price, Aim::Carbon, Aim::Stiffness, Aim::Valid];

    fn better(self) -> &'static str {
        match self {
            Aim::Price => "cheaper",
            Aim::Carbon => "lower carbon",
            Aim::Stiffness => "stiffer",
            Aim::Valid => "valid",
        }
    }

    /// What is minimised.
    fn value(self, figures: &Figures) -> f64 {
        match self {
            Aim::Price | Aim::Valid => figures.value(Objective::PriceEur),
            Aim::Carbon => figures.value(Objective::GwpKgco2e),
            Aim::Stiffness => figures.value(Objective::SwayRatio).max(figures.value(Objective::DeflectionRatio)),
        }
    }
}

/// The figures of a house.
pub struct Figures {
    values: houscaper::score::Values,
    /// How far it is from passing; 0 or less passes.
    pub violation: f64,
}

impl Figures {
    fn new(evaluation: &Evaluation, site: f64) -> Figures {
        Figures { values: evaluation.values, violation: evaluation.violation + site }
    }

    /// A figure; not a number where it could not be found.
    pub fn value(&self, objective: Objective) -> f64 {
        self.values.get(objective)
    }
}

/// A better house.
pub struct Neighbour {
    design: Design,
    house: House,
    /// Its figures.
    pub figures: Figures,
    /// In what it is better.
    pub better: Vec<&'static str>,
    /// Voxels with another label: position, before, after.
    pub changes: Vec<([usize; 3], Label, Label)>,
    /// Sections, joists and boards that differ.
    pub choices: usize,
    /// Whether its shape or its sections changed.
    pub operator: &'static str,
}

/// What was found, and for what.
pub struct Found {
    /// The house's name.
    pub name: String,
    /// The brief's name.
    pub brief: String,
    /// What should get better.
    pub aim: Vec<Aim>,
    /// Seed.
    pub seed: u64,
    /// Houses evaluated.
    pub evaluations: u64,
    /// Voxels that were to stay.
    pub locked: usize,
    /// Least floor area of a neighbour, m2.
    pub least_m2: f64,
    /// The house as it is.
    pub before: Figures,
    /// Better ones.
    pub neighbours: Vec<Neighbour>,
}

pub fn run(args: Improve, json: bool) -> Outcome {
    check_folder(&args.out)?;
    if !(0.0..=10.0).contains(&args.keep_area) {
        return Err(bad_input(format!(
            "--keep-area {}: expected a share such as 0.97, or 0 for any area",
            args.keep_area
        )));
    }
    let asked = Asked::load(&args.brief, args.prices.as_deref())?;
    let evaluator = &asked.evaluator;
    let space = space::of(evaluator, args.brief.parent().unwrap_or(Path::new("")))?;
    let house = input::house(&args.voxels, &args.import)?;
    if house.voxels.module.size_m != evaluator.brief.plot.module_m {
        let (found, expected) = (house.voxels.module.size_m, evaluator.brief.plot.module_m);
        let name = args.voxels.display();
        return Err(bad_input(format!("{name}: modules of {found:?} m, expected {expected:?} m as in plot.module_m")));
    }
    let plot = evaluator.brief.plot.modules;
    let reach = house
        .voxels
        .iter()
        .filter(|(_, label)| label.is_filled())
        .fold([0; 3], |most, (at, _)| std::array::from_fn(|a| usize::max(most[a], at[a] + 1)));
    if (0..3).any(|a| reach[a] > plot[a]) {
        return Err(bad_input(format!(
            "{}: the house reaches {reach:?} modules from its first voxel, the plot of {} only {plot:?}: name a brief with a larger plot.modules",
            args.voxels.display(),
            args.brief.display()
        )));
    }
    let locked = lock::locked(&args.lock, &house)?;
    let own = match &args.choices {
        Some(flag) => choices::from_flag(flag, evaluator)?,
        None => evaluator.size(&house, SizingGoal::Price).as_ref().map_or_else(Choices::default, Sized::choices),
    };
    let before = Figures::new(&evaluator.details(&house, &own).evaluation, asked.site.violation(&house));
    let aims = aims(args.aim, &before)?;
    let start = repair(&house, own, &space).map_err(|error| anyhow!("{}: {error}", args.voxels.display())).input()?;
    if aims == [Aim::Valid] {
        let broken = violations(&house, &evaluator.rules, Some(&asked));
        let name = input::name_of(&args.voxels);
        broken.iter().take(SAID).for_each(|v| eprintln!("{name}: {}: {}", v.rule, v.message));
        if broken.len() > SAID {
            eprintln!("{name}: {} more; `houscaper check` lists them", broken.len() - SAID);
        }
    }
    let least_m2 = match aims.contains(&Aim::Valid) {
        true => 0.0,
        false => args.keep_area * before.value(Objective::FloorAreaM2),
    };
    let mut found = Found {
        name: input::name_of(&args.voxels),
        brief: evaluator.brief.name.clone(),
        aim: aims,
        seed: args.seed,
        evaluations: 0,
        locked: locked.len(),
        least_m2,
        before,
        neighbours: Vec::new(),
    };
    let around = Explored { asked: &asked, space: &space, house: &house, own, start: &start, locked: &locked };
    let rejected = around.explore(&args, &mut found);
    write(&found, &house, &own, evaluator, &args.out)?;
    tell(&found, rejected, &args.out, json)
}

/// The aims, given or by the state of the house.
fn aims(asked: Option<Aim>, before: &Figures) -> Result<Vec<Aim>, Failure> {
    let aims = match asked {
        Some(Aim::Valid) if before.violation <= 0.0 => {
            return Err(bad_input("--aim valid: the house passes as it is; ask for price, carbon or stiffness"));
        }
        Some(aim) => vec![aim],
        None if before.violation > 0.0 => vec![Aim::Valid],
        None => vec![Aim::Price, Aim::Carbon, Aim::Stiffness],
    };
    let unknown = |aim: &&Aim| **aim != Aim::Valid && !aim.value(before).is_finite();
    match (asked, aims.iter().find(unknown)) {
        (Some(aim), Some(_)) => Err(bad_input(format!(
            "--aim {}: the house as it is has no such figure (its frame or its skin cannot be assessed under this brief); --aim valid finds one that has",
            aim.to_possible_value().map_or_else(String::new, |v| v.get_name().to_owned())
        ))),
        _ => Ok(aims.into_iter().filter(|aim| !unknown(&aim)).collect()),
    }
}

fn write(found: &Found, house: &House, own: &Choices, evaluator: &Evaluator, out: &Path) -> Outcome {
    let text = serde_json::to_vec_pretty(&report::json(found)).run()?;
    let folder = RunFolder::create(out, &text).input()?;
    folder.write("improve.json", &text).run()?;
    folder.write("improve.csv", report::table(found).as_bytes()).run()?;
    let chosen = genome::choices_json(own, house.stairs.len() + 1, evaluator);
    folder.write("before/voxels.json", voxel_json::write(house).as_bytes()).run()?;
    folder.write("before/choices.json", &serde_json::to_vec_pretty(&chosen).run()?).run()?;
    for (n, neighbour) in found.neighbours.iter().enumerate() {
        let Neighbour { design, house, .. } = neighbour;
        let details = evaluator.details(house, &design.choices);
        let name = format!("{} {}", found.name, n + 1);
        let dossier = dossier(&name, house, &design.choices, &details, evaluator, Extent::Front).run()?;
        for (file, bytes) in &dossier.files {
            folder.write(&format!("{}/{file}", n + 1), bytes).run()?;
        }
        folder.write(&format!("{}/changes.csv", n + 1), report::changes(neighbour).as_bytes()).run()?;
    }
    Ok(())
}

fn tell(found: &Found, locked_out: u64, out: &Path, as_json: bool) -> Outcome {
    if as_json {
        say!("{}", serde_json::to_string_pretty(&report::json(found)).run()?);
    } else {
        report::lines(found).iter().for_each(|line| say!("{line}"));
    }
    let what: Vec<&str> = found.aim.iter().map(|aim| aim.better()).collect();
    let lock = match locked_out {
        0 => String::new(),
        n => format!("; {n} more changed locked voxels and were thrown away"),
    };
    eprintln!(
        "{}: {} neighbours, {}, of {} houses evaluated{lock}; files in {}",
        found.name,
        found.neighbours.len(),
        what.join(" or "),
        found.evaluations,
        out.display()
    );
    match found.neighbours.is_empty() && found.aim == [Aim::Valid] {
        true => Err(Failure::Run(anyhow!(
            "{}: none of {} neighbours passes; `houscaper check` and `build` say what the house breaks, more --evaluations or fewer locks may help",
            found.name,
            found.evaluations
        ))),
        false => Ok(()),
    }
}
