//! `houscaper tileset`: proves, lists and writes tilesets.

mod architectural;
mod bake;
mod catalogue;
mod check;
mod houses;
mod list;
mod obj_files;
mod places;
mod scaffold;
mod sheet;

use std::path::{Path, PathBuf};

use houscaper::tiles::{FOREIGN_SCHEMA, LinearTileset, MANIFEST_FILE, Tileset as SurfaceTileset};

use super::args::Tileset;
use super::failure::{Blame, Failure, Outcome};
use super::home;

pub fn run(args: Tileset, as_json: bool) -> Outcome {
    match args {
        Tileset::Check(args) => check::run(&named(&args.dir), args.root.as_deref(), as_json),
        Tileset::List(args) => list::run(args.dir.map(|dir| named(&dir)).as_deref(), args.root.as_deref(), as_json),
        Tileset::Sheet(args) if args.houses => houses::run(&named(&args.dir), args.root.as_deref(), &args.out),
        Tileset::Sheet(args) => sheet::run(&named(&args.dir), args.root.as_deref(), &args.out),
        Tileset::New(args) => scaffold::run(&args),
        Tileset::Bake(args) => bake::run(&args),
    }
}

/// The folder of a set given by path or name.
fn named(dir: &str) -> PathBuf {
    home::tileset(dir, home::find(None).as_deref())
}

/// A loaded tileset of either kind.
enum Loaded {
    Surface(SurfaceTileset),
    Linear(LinearTileset),
}

/// Loads a set; its manifest says which kind it is. Whatever is wrong with it is the loader's error.
fn load(dir: &Path) -> Result<Loaded, Failure> {
    if is_linear(dir) {
        LinearTileset::load(dir).map(Loaded::Linear).input()
    } else {
        SurfaceTileset::load(dir).map(Loaded::Surface).input()
    }
}

fn is_solids(dir: &Path) -> bool {
    manifest(dir).is_some_and(|m| m["kind"] == "solids" || m["schema"] == FOREIGN_SCHEMA)
}

fn is_linear(dir: &Path) -> bool {
    manifest(dir).is_some_and(|m| m["kind"] == "linear")
}

/// The manifest as it stands, `None` when there is none or it is no JSON.
fn manifest(dir: &Path) -> Option<serde_json::Value> {
    serde_json::from_slice(&std::fs::read(dir.join(MANIFEST_FILE)).ok()?).ok()
}
