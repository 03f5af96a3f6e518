//! `houscaper compare`: the same houses in several material systems.

use std::path::{Path, PathBuf};

use anyhow::Context;
use houscaper::brief::{Brief, read_brief};
use houscaper::export::compare::Compared;
use houscaper::export::compare_front::ComparedFront;
use houscaper::export::plots::svg_to_png;
use houscaper::price::{Draws, Stage};
use houscaper::run::RunFolder;
use houscaper::score::{Comparison, Evaluator, SizingGoal};
use houscaper::voxels::House;
use rayon::prelude::*;
use serde_json::{Value, json};

use super::args::{Compare, Import};
use super::failure::{Blame, Failure, Outcome, bad_input};
use super::input;
use super::output::{check_folder, say};
use super::progress::WorkBar;

/// Systems compared at most: more do not fit a page.
const MOST_SYSTEMS: usize = 6;

/// A house with its name.
struct Named {
    name: String,
    house: House,
}

pub fn run(args: Compare, json: bool) -> Outcome {
    check_folder(&args.out)?;
    let (houses, mut brief, folder) = match args.input.is_dir() {
        true => front(&args)?,
        false => single(&args)?,
    };
    input::own_prices(&mut brief, args.prices.as_deref())?;
    let systems = systems(&args.materials, &brief, &folder)?;
    let goal = SizingGoal::from(args.size);
    let draws = Draws::new(&systems[0].1.books, args.draws, args.seed).input()?;
    let bar = (houses.len() > 1).then(|| WorkBar::new(houses.len(), "houses"));
    let found: Vec<(Comparison, Vec<String>)> = houses
        .par_iter()
        .map(|h| {
            let found = Comparison::new(&h.house, &systems, goal, &draws).input();
            bar.iter().for_each(WorkBar::step);
            found
        })
        .collect::<Result<_, _>>()?;
    drop(bar);
    if found.iter().all(|(c, _)| c.variants.is_empty()) {
        return Err(bad_input("no house stands on its foundation in any of the systems: `houscaper check` says why"));
    }
    let mark = json!({"schema": "houscaper.compare-run/1", "houses": houses.len(), "materials": args.materials});
    let out = RunFolder::create(&args.out, mark.to_string().as_bytes()).input()?;
    let (mut all, mut told) = (Vec::new(), Vec::new());
    for (named, (comparison, left_out)) in houses.iter().zip(&found) {
        let of = |system: &str| systems.iter().find(|s| s.0 == system).map(|s| &s.1);
        let evaluators: Vec<&Evaluator> = comparison.variants.iter().filter_map(|v| of(&v.system)).collect();
        let compared = Compared { name: &named.name, comparison, evaluators, left_out, draws: (args.draws, args.seed) };
        let place = if houses.len() > 1 { format!("{}/", named.name) } else { String::new() };
        write(&compared, &out, &place)?;
        told.push((0..comparison.variants.len()).map(|n| compared.verdict(n)).collect::<Vec<_>>());
        all.push(compared.json());
    }
    let names: Vec<String> = systems.iter().map(|s| s.0.clone()).collect();
    let run = input::name_of(&args.input);
    let all_houses = houses.iter().zip(&found).map(|(h, (c, _))| (h.name.as_str(), c)).collect();
    let whole = ComparedFront { name: &run, systems: &names, houses: all_houses };
    if houses.len() > 1 {
        out.write("summary.csv", summary(&houses, &found).as_bytes()).run()?;
        let chart = whole.chart().run()?;
        out.write("front.svg", chart.as_bytes()).run()?;
        out.write("front.png", &svg_to_png(&chart, 1.5).run()?).run()?;
        out.write("front.html", whole.html().run()?.as_bytes()).run()?;
    }
    if json {
        say!(
            "{}",
            serde_json::to_string_pretty(&if all.len() == 1 { all.remove(0) } else { Value::Array(all) }).run()?
        );
        return Ok(());
    }
    match houses.len() {
        1 => tell(&found[0], &told[0], &systems[0].1),
        _ => {
            tell_all(&systems, &found);
            whole.order_sentences().iter().for_each(|sentence| say!("{sentence}"));
        }
    }
    say!("tables, charts and page in {}", args.out.display());
    Ok(())
}

/// The houses of a run's front, and the brief it was made for.
fn front(args: &Compare) -> Result<(Vec<Named>, Brief, PathBuf), Failure> {
    let dir = &args.input;
    let folder = RunFolder::open(dir).input()?;
    let (brief, home) = match &args.brief {
        Some(path) => input::brief(path)?,
        None => {
            let name = dir.join("run.json").display().to_string();
            let run: Value = serde_json::from_slice(&folder.read("run.json").input()?.unwrap_or_default())
                .with_context(|| name.clone())
                .input()?;
            let brief =
                run.get("brief").ok_or_else(|| bad_input(format!("{name}: holds no brief; name one by --brief")))?;
            (read_brief(brief.to_string().as_bytes(), &name).input()?, PathBuf::new())
        }
    };
    let front = dir.join("front");
    let entries = std::fs::read_dir(&front)
        .with_context(|| format!("{}: expected a run folder with its front", front.display()))
        .input()?;
    let mut paths: Vec<PathBuf> =
        entries.filter_map(|e| Some(e.ok()?.path().join("voxels.json"))).filter(|p| p.is_file()).collect();
    // Numbers in their order, as in front.csv by id.
    paths.sort_by_key(|p| (id(p).parse::<u64>().unwrap_or(u64::MAX), p.clone()));
    let houses = paths
        .iter()
        .map(|path| Ok(Named { name: id(path), house: input::house(path, &Import::default())? }))
        .collect::<Result<Vec<Named>, Failure>>()?;
    if houses.is_empty() {
        return Err(bad_input(format!("{}: no front/<id>/voxels.json in it", dir.display())));
    }
    Ok((houses, brief, home))
}

/// The name of the folder that a file lies in.
fn id(path: &Path) -> String {
    path.parent().and_then(Path::file_name).unwrap_or_default().to_string_lossy().into_owned()
}

fn single(args: &Compare) -> Result<(Vec<Named>, Brief, PathBuf), Failure> {
    let path = args.brief.clone().map_or_else(input::shipped_brief, Ok)?;
    let (brief, folder) = input::brief(&path)?;
    let house = input::house(&args.input, &args.import)?;
    Ok((vec![Named { name: input::name_of(&args.input), house }], brief, folder))
}

/// An evaluator for each system; materials of one are joined by `+`.
fn systems(materials: &[String], brief: &Brief, folder: &Path) -> Result<Vec<(String, Evaluator)>, Failure> {
    if !(2..=MOST_SYSTEMS).contains(&materials.len()) {
        return Err(bad_input(format!(
            "--materials names {} systems: expected 2 to {MOST_SYSTEMS}, e.g. --materials C24,GL24h,S355 or C24,C24+S355",
            materials.len()
        )));
    }
    let mut all: Vec<(String, Evaluator)> = Vec::new();
    for name in materials {
        if all.iter().any(|s| s.0 == *name) {
            return Err(bad_input(format!("--materials names {name} twice; name each system once")));
        }
        let own = Brief { materials: name.split('+').map(str::to_owned).collect(), ..brief.clone() };
        all.push((name.clone(), input::evaluator(own, folder.to_path_buf())?));
    }
    Ok(all)
}

fn write(compared: &Compared, out: &RunFolder, place: &str) -> Outcome {
    let file = |name: &str| format!("{place}{name}");
    out.write(&file("compare.csv"), compared.table_csv().as_bytes()).run()?;
    out.write(&file("lines.csv"), compared.lines_csv().as_bytes()).run()?;
    out.write(&file("compare.json"), &serde_json::to_vec_pretty(&compared.json()).run()?).run()?;
    out.write(&file("compare.html"), compared.html().run()?.as_bytes()).run()?;
    for (name, svg) in compared.charts().run()? {
        out.write(&file(&format!("{name}.svg")), svg.as_bytes()).run()?;
        out.write(&file(&format!("{name}.png")), &svg_to_png(&svg, 1.5).run()?).run()?;
    }
    Ok(())
}

/// A row for each house and system.
fn summary(houses: &[Named], found: &[(Comparison, Vec<String>)]) -> String {
    let mut text =
        "house,system,ok,price_eur,price_low,price_high,gwp_kgco2e,frame_mass_kg,chance_cheapest,a4_kgco2e,a5_kgco2e,c3_c4_kgco2e,d_kgco2e,biogenic_storage_kgco2,carbon_order_kept\n".to_owned();
    for (named, (comparison, _)) in houses.iter().zip(found) {
        for (v, chance) in comparison.variants.iter().zip(comparison.chance_cheapest()) {
            let ([low, price, high], carbon) = (v.price(), v.carbon()[1]);
            let mass = v.value(houscaper::brief::Objective::FrameMassKg);
            let [a4, a5, end, beyond] = Stage::ALL.map(|stage| v.stages.stage(stage).known[1]);
            let kept = comparison.order_is_kept().map_or(String::new(), |kept| kept.to_string());
            let row = format!(
                "{},{},{},{price:.2},{low:.2},{high:.2},{carbon:.1},{mass:.1},{chance:.4},{a4:.1},{a5:.1},{end:.1},{beyond:.1},{:.1},{kept}\n",
                named.name,
                v.system,
                v.is_ok(),
                v.stages.storage
            );
            text += &row;
        }
    }
    text
}

fn tell((comparison, left_out): &(Comparison, Vec<String>), verdicts: &[String], evaluator: &Evaluator) {
    let cheapest = comparison.chance_cheapest();
    say!(
        "{:<14} {:>7} {:>26} {:>9} {:>10} {:>9} {:>9}",
        "system",
        "verdict",
        "price low-default-high",
        "carbon",
        "frame kg",
        "util.",
        "cheapest"
    );
    for (v, chance) in comparison.variants.iter().zip(cheapest) {
        let [low, price, high] = v.price().map(|p| p / 1e3);
        say!(
            "{:<14} {:>7} {:>26} {:>7.1} t {:>10.0} {:>9.2} {:>7.0} %",
            v.system,
            if v.is_ok() { "ok" } else { "not ok" },
            format!("{low:.0}k - {price:.1}k - {high:.0}k"),
            v.carbon()[1] / 1e3,
            v.value(houscaper::brief::Objective::FrameMassKg),
            v.value(houscaper::brief::Objective::Utilisation),
            100.0 * chance
        );
    }
    comparison.neighbours().into_iter().for_each(|(a, b)| say!("{}", comparison.sentence(a, b)));
    comparison.survivals(&evaluator.books.carbon).iter().for_each(|survival| say!("{}", survival.sentence()));
    for (v, verdict) in comparison.variants.iter().zip(verdicts).filter(|(v, _)| !v.is_ok()) {
        say!("{}: {verdict}; what it costs is no price of a house that stands", v.system);
    }
    if !left_out.is_empty() {
        say!("not assessed: {}", left_out.join(", "));
    }
}

/// How often each system stands, and how often it is the cheapest and the lowest in carbon of those that stand.
fn tell_all(systems: &[(String, Evaluator)], found: &[(Comparison, Vec<String>)]) {
    let best = |value: fn(&houscaper::score::Variant) -> f64, system: &str| {
        let of = |c: &Comparison| {
            let ok = c.variants.iter().filter(|v| v.is_ok());
            ok.min_by(|a, b| value(a).total_cmp(&value(b))).is_some_and(|v| v.system == system)
        };
        found.iter().filter(|(c, _)| of(c)).count()
    };
    for (system, _) in systems {
        let stands = found.iter().filter(|(c, _)| c.variants.iter().any(|v| v.system == *system && v.is_ok())).count();
        say!(
            "{system}: stands in {stands} of {} houses, cheapest in {}, least carbon in {}",
            found.len(),
            best(|v| v.price()[1], system),
            best(|v| v.carbon()[1], system)
        );
    }
}
