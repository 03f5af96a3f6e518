//! `houscaper picture`: a house from any side, or from all around.

use std::path::PathBuf;

use anyhow::anyhow;
use clap::Args;
use houscaper::export::dossier::{frame_scene, house_scene};
use houscaper::export::picture::{MOST_FRAMES, Picture, View, animated, render, sprites, turntable};
use houscaper::run::RunFolder;
use houscaper::score::SizingGoal;
use houscaper::structure::review;
use serde_json::json;

use super::args::Import;
use super::failure::{Blame, Failure, Outcome};
use super::input;
use super::output::{check_folder, say};

#[derive(Args)]
pub struct PictureArgs {
    /// Voxels.
    pub voxels: PathBuf,
    /// Brief whose tileset draws the house [default: the shipped starter brief].
    #[arg(long)]
    pub brief: Option<PathBuf>,
    /// Tileset instead of the brief's.
    #[arg(long)]
    pub tileset: Option<String>,
    /// Output folder: picture.png, and with --turntable turntable.png (animated), turntable-sheet.png and turntable/.
    #[arg(long)]
    pub out: PathBuf,
    /// Pixels across and down, each 1 to 4096.
    #[arg(long, value_name = "WxH", default_value = "1200x900", value_parser = size)]
    pub size: [usize; 2],
    /// Direction from the house to the camera in plan, degrees counter-clockwise from east.
    #[arg(long, value_name = "DEG", default_value_t = View::default().azimuth_deg, allow_negative_numbers = true)]
    pub azimuth: f32,
    /// Height of the camera over the horizon, degrees, 0 to 50; to 80 with --parallel.
    #[arg(long, value_name = "DEG", default_value_t = View::default().elevation_deg, allow_negative_numbers = true)]
    pub elevation: f32,
    /// A parallel projection instead of a perspective.
    #[arg(long)]
    pub parallel: bool,
    /// Pictures from all around, in equal steps, beside the one from --azimuth.
    #[arg(long, value_name = "N", value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(2..=MOST_FRAMES as u64))]
    pub turntable: Option<usize>,
    /// The frame, sized for least price, coloured by utilisation, instead of the house.
    #[arg(long)]
    pub frame: bool,
    /// No person beside the house.
    #[arg(long)]
    pub no_person: bool,
    #[command(flatten)]
    pub import: Import,
}

/// Most pixels of a sheet of sprites across.
const SHEET: usize = 8192;

pub fn run(args: PictureArgs, json: bool) -> Outcome {
    check_folder(&args.out)?;
    let steepest = if args.parallel { 80.0 } else { 50.0 };
    if !(args.azimuth.is_finite() && (0.0..=steepest).contains(&args.elevation)) {
        return Err(Failure::Input(anyhow!(
            "--azimuth {} --elevation {}: expected a finite direction and a height of 0 to {steepest} degrees",
            args.azimuth,
            args.elevation
        )));
    }
    let mut evaluator = input::evaluator_for(args.brief.as_deref(), None)?;
    if let Some(name) = &args.tileset {
        let home = super::home::find(args.brief.as_deref().and_then(|p| p.parent()));
        let dir = super::home::tileset(name, home.as_deref());
        evaluator.tiling = houscaper::score::Tiling::load_from(&dir, None, &evaluator.books).input()?;
    }
    let house = input::house(&args.voxels, &args.import)?;
    let name = input::name_of(&args.voxels);
    let choices = match args.frame {
        true => evaluator.size(&house, SizingGoal::Price).map(|s| s.choices()).unwrap_or_default(),
        false => Default::default(),
    };
    let details = evaluator.details(&house, &choices);
    let scene = match (&details.frame, args.frame) {
        (Some(frame), true) => {
            let sections = evaluator.sections(&choices);
            let reviewed = review(frame, &evaluator.catalogue, &sections, &evaluator.loads);
            frame_scene(frame, &details, &evaluator, &sections, reviewed.as_ref())
        }
        (None, true) => {
            return Err(Failure::Input(anyhow!(
                "{}: no frame can be made of this house; `houscaper check` names the cells",
                args.voxels.display()
            )));
        }
        (_, false) => {
            let fabric = evaluator.tiling.fabric(&house, &details.reading);
            house_scene(&name, &house, &details, &evaluator, fabric.as_ref()).input()?
        }
    };
    let view = View {
        azimuth_deg: args.azimuth,
        elevation_deg: args.elevation,
        field_deg: View::default().field_deg.filter(|_| !args.parallel),
    };
    let picture = Picture { view, person: !args.no_person, ..Picture::of_house(args.size) };
    let folder =
        RunFolder::create(&args.out, json!({"schema": "houscaper.picture/1", "name": name}).to_string().as_bytes());
    let folder = folder.input()?;
    let mut files = vec!["picture.png".to_owned()];
    folder.write("picture.png", &render(&scene, &picture).input()?.to_png().run()?).run()?;
    if let Some(count) = args.turntable {
        let frames = turntable(&scene, &picture, count).input()?;
        for (n, frame) in frames.iter().enumerate() {
            let file = format!("turntable/{n:03}.png");
            folder.write(&file, &frame.to_png().run()?).run()?;
        }
        folder.write("turntable.png", &animated(&frames).run()?).run()?;
        // As near to a square as fits.
        let columns = (count as f64).sqrt().ceil().min((SHEET / args.size[0]).max(1) as f64) as usize;
        folder.write("turntable-sheet.png", &sprites(&frames, columns).to_png().run()?).run()?;
        files.extend(["turntable.png".to_owned(), "turntable-sheet.png".to_owned(), format!("turntable/ ({count})")]);
    }
    if json {
        say!("{}", json!({"name": name, "files": files, "size": args.size}));
    } else {
        say!("{} in {}", files.join(", "), args.out.display());
    }
    Ok(())
}

/// Two numbers of pixels with an x between.
fn size(text: &str) -> Result<[usize; 2], String> {
    let wrong = || "expected pixels across and down, such as 1200x900, each 1 to 4096".to_owned();
    let (w, h) = text.split_once('x').ok_or_else(wrong)?;
    let [w, h] = [w, h].map(|n| n.trim().parse::<usize>().ok().filter(|n| (1..=4096).contains(n)));
    Ok([w.ok_or_else(wrong)?, h.ok_or_else(wrong)?])
}
