//! `houscaper build`: one house with all its files.

use anyhow::Context;
use houscaper::export::dossier::sizing_json;
use houscaper::export::dossier::{Extent, MeshesReport, StructureReport, dossier, tiles_glb};
use houscaper::run::RunFolder;
use houscaper::score::{Sized, SizingGoal};
use houscaper::voxels::Choices;
use serde::Serialize;
use serde_json::json;

use super::args::{Build, GlbParts};
use super::failure::{Blame, Outcome};
use super::input;
use super::output::{check_folder, say};

/// What `--json` prints: the structure, and what a set of meshes draws and lacks.
#[derive(Serialize)]
struct Report<'a> {
    #[serde(flatten)]
    structure: &'a StructureReport,
    #[serde(skip_serializing_if = "Option::is_none")]
    tileset: Option<&'a MeshesReport>,
}

pub fn run(args: Build, json: bool) -> Outcome {
    check_folder(&args.out)?;
    let mut evaluator = input::evaluator_for(args.brief.as_deref(), args.prices.as_deref())?;
    if let Some(name) = &args.tileset {
        let home = super::home::find(args.brief.as_deref().and_then(|p| p.parent()));
        let dir = super::home::tileset(name, home.as_deref());
        let root = args.tileset_root.as_deref();
        evaluator.tiling = houscaper::score::Tiling::load_from(&dir, root, &evaluator.books).input()?;
    }
    let house = input::house(&args.voxels, &args.import)?;
    let goal = SizingGoal::from(args.size);
    let (choices, sized) = match &args.choices {
        Some(flag) => (super::choices::from_flag(flag, &evaluator)?, None),
        None => {
            let sized = evaluator.size(&house, goal);
            (sized.as_ref().map_or_else(Choices::default, Sized::choices), sized)
        }
    };
    let details = evaluator.details(&house, &choices);
    let name = input::name_of(&args.voxels);
    let extent = Extent::Full { sizing: sized.as_ref().map(|s| s.sentence(goal, &evaluator)) };
    let dossier = dossier(&name, &house, &choices, &details, &evaluator, extent)
        .with_context(|| {
            format!("{}: run `houscaper check` for the cells, or `convert --repair`", args.voxels.display())
        })
        .input()?;
    let report = &dossier.structure;
    let mark = json!({"schema": "houscaper.build/1", "name": name, "violations": details.violations.len()});
    let folder = RunFolder::create(&args.out, mark.to_string().as_bytes()).input()?;
    for (file, bytes) in &dossier.files {
        folder.write(file, bytes).run()?;
    }
    let tiles = match args.glb_parts {
        GlbParts::Tiles => tiles_glb(&name, &house, &choices, &details, &evaluator).run()?,
        GlbParts::Layers => None,
    };
    if let Some(bytes) = &tiles {
        folder.write("tiles.glb", bytes).run()?;
    } else if args.glb_parts == GlbParts::Tiles {
        eprintln!("note: a set of surfaces has no solids, so that there is no tiles.glb");
    }
    if let Some(sized) = &sized {
        folder.write("sizing.json", &serde_json::to_vec_pretty(&sizing_json(sized, goal, &evaluator)).run()?).run()?;
    }
    for violation in &details.violations {
        eprintln!("{}: {}", violation.rule, violation.message);
    }
    let meshes = MeshesReport::new(&house, &details.reading, &evaluator.tiling);
    meshes.iter().flat_map(MeshesReport::lines).for_each(|line| eprintln!("{line}"));
    if json {
        say!("{}", serde_json::to_string_pretty(&Report { structure: report, tileset: meshes.as_ref() }).run()?);
    } else {
        say!("structure {}: {}", report.verdict, report.reason);
        if let Some(sized) = &sized {
            say!("{}", sized.sentence(goal, &evaluator));
        }
        let more = usize::from(sized.is_some()) + usize::from(tiles.is_some());
        say!("{} files in {}", dossier.files.len() + more, args.out.display());
    }
    Ok(())
}
