//! `tileset bake`: a shipped set written anew from its construction rule.

use std::path::Path;

use anyhow::Context;
use houscaper::tiles::{BakedFile, Style, bake_linear, bake_surface};

use crate::cli::args::TilesetBake;
use crate::cli::failure::{Blame, Outcome, bad_input};
use crate::cli::output;

pub fn run(args: &TilesetBake) -> Outcome {
    let files = match args.name.as_str() {
        "surface-1" => bake_surface(&Style::SURFACE_1),
        "surface-2" => bake_surface(&Style::SURFACE_2),
        "linear" => bake_linear(),
        other => {
            return Err(bad_input(format!("no tileset is called `{other}`; expected surface-1, surface-2 or linear")));
        }
    };
    check_target(&args.out, &args.name, &files)?;
    std::fs::create_dir_all(&args.out).with_context(|| format!("cannot make {}", args.out.display())).run()?;
    // The manifest comes first in the list and is written last: a folder cut short is no tileset yet.
    files.iter().rev().try_for_each(|file| output::write(&args.out.join(&file.name), file.text.as_bytes()))?;
    eprintln!("{}: {} files of {}", args.out.display(), files.len(), args.name);
    Ok(())
}

/// Only a folder that is missing, empty, or holds this very set may be written to.
fn check_target(out: &Path, name: &str, files: &[BakedFile]) -> Outcome {
    if out.exists() && !out.is_dir() {
        return Err(bad_input(format!("{}: is a file; name a folder", out.display())));
    }
    let Ok(mut entries) = std::fs::read_dir(out) else { return Ok(()) };
    let same_set = super::manifest(out).is_some_and(|m| m["name"] == name);
    let stranger = entries.find_map(|e| {
        let file = e.ok()?.file_name();
        let ours = same_set && files.iter().any(|f| file == f.name.as_str());
        (!ours).then_some(file)
    });
    match stranger {
        None => Ok(()),
        Some(file) => Err(bad_input(format!(
            "{}: holds {}, which is not a file of the tileset {name}; nothing was written. Choose another --out or empty it",
            out.display(),
            file.display()
        ))),
    }
}
