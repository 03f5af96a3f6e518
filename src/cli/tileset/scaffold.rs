//! `tileset new`: a folder from which a designer can start.

use std::collections::BTreeSet;

use anyhow::Context;
use houscaper::cubes::{Category, Corner, CubeKey, canonical_masks};
use houscaper::tiles::check::CAGE_FILE;
use houscaper::tiles::{BakedFile, CUBE_MM, Style, bake_surface};
use houscaper::voxels::Label;
use serde_json::json;

use super::architectural::Architectural;
use super::obj_files;
use crate::cli::args::{NewKind, TilesetNew};
use crate::cli::failure::{Blame, Failure, Outcome, bad_input};
use crate::cli::output;

/// What a designer must know, in the manifest itself because that is what is opened first.
const SURFACE: &str = "Replace the OBJ files by your own; one is enough for all configurations that turning and mirroring make of it. A tile is the surface between the filled corners (1 in the pattern) and the empty ones (0), seen from outside, open only on the cube's faces. Millimetres, z up, origin at corner 0 of cage.obj (x = y = z = 0), corner n at x + 2y + 4z. Name groups <kind>_o<corner> with kind roof, wall, soffit or deck and the filled corner whose label says what it is made of. Then run: houscaper tileset check <this folder>";
const SOLIDS: &str = "Replace the OBJ files by your own; one is enough for all configurations that turning and mirroring make of it. A tile holds closed bodies, each in a group named <layer>_o<corner>; a pattern holds a label for each corner, corner 0 first: 0 is empty, 1 base, and * any that is filled; write digits where windows, doors or slabs should look different. Millimetres, z up, origin at corner 0 of cage.obj (x = y = z = 0), corner n at x + 2y + 4z. Bodies of neighbouring cubes must meet on the cube's faces. Then run: houscaper tileset check <this folder>";

pub fn run(args: &TilesetNew) -> Outcome {
    if args.dir.exists() {
        return Err(bad_input(format!("{}: is there already; name a folder to make", args.dir.display())));
    }
    let name = args.dir.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    if name.is_empty() {
        return Err(bad_input(format!("{}: has no name to call the set by", args.dir.display())));
    }
    let mut files = match args.kind {
        NewKind::Surface => surface(&name),
        NewKind::Solids => solids(&name)?,
    };
    files.push(cage());
    std::fs::create_dir_all(&args.dir).with_context(|| format!("cannot make {}", args.dir.display())).input()?;
    files.iter().rev().try_for_each(|file| output::write(&args.dir.join(&file.name), file.text.as_bytes()))?;
    eprintln!("{}: tileset.json, cage.obj and 26 tiles to replace", args.dir.display());
    Ok(())
}

/// The tiles of the sloped style as examples.
fn surface(name: &str) -> Vec<BakedFile> {
    let mut files = bake_surface(&Style::SURFACE_2);
    let names: Vec<(String, String)> = canonical_masks()
        .into_iter()
        .map(|m| (format!("{}-{:03}", Category::of(m).name(), m.0), m.pattern()))
        .collect();
    let tiles = names.iter().map(|(tile, pattern)| obj_files::entry(tile, pattern, true)).collect();
    let layers = json!([{"name": "envelope", "kind": "surface", "overhang": 0.0}]);
    files.retain(|f| f.name != houscaper::tiles::MANIFEST_FILE);
    files.insert(0, obj_files::manifest(name, SURFACE, "surface", layers, tiles));
    files
}

/// Solids of the architectural style, made as for base, as examples that serve every filled label.
fn solids(name: &str) -> Result<Vec<BakedFile>, Failure> {
    let set = Architectural::shipped()?;
    let (mut files, mut tiles, mut used, mut overhang) = (Vec::new(), Vec::new(), BTreeSet::new(), 0);
    for mask in canonical_masks() {
        let mut labels = [Label::Empty; 8];
        Corner::all().filter(|&c| mask.has(c)).for_each(|c| labels[c.number() as usize] = Label::Base);
        let blocks = set.blocks(CubeKey::of_labels(labels));
        used.extend(blocks.iter().map(|b| b.component));
        overhang = overhang.max(obj_files::overhang_mm(&blocks));
        let tile = format!("{}-{:03}", Category::of(mask).name(), mask.0);
        tiles.push(obj_files::entry(&tile, &mask.pattern().replace('1', "*"), true));
        let comment = format!("{tile}: corners {}, millimetres, z up", mask.pattern());
        files.push(BakedFile { name: format!("{tile}.obj"), text: obj_files::solid_obj(&comment, &blocks) });
    }
    files.insert(0, obj_files::manifest(name, SOLIDS, "solids", obj_files::solid_layers(&used, overhang), tiles));
    files.push(obj_files::library(&set.palette()));
    // A level roof's membrane ends beside a slope.
    super::bake::accept_open_seams(&mut files);
    Ok(files)
}

/// The edges of the cube as lines, and at each corner a mark of three faces in a group named by its number.
fn cage() -> BakedFile {
    let at = |c: Corner| [0, 1, 2].map(|a| i32::from(c.xyz()[a]) * CUBE_MM[a]);
    let mut text = String::from(
        "# cage of a tile: 900 x 900 x 540 millimetres, z up; group corner_n marks corner n = x + 2y + 4z\n",
    );
    for corner in Corner::all() {
        let [x, y, z] = at(corner);
        text += &format!("v {x} {y} {z}\n");
    }
    text += "g cage\nl 1 2\nl 1 3\nl 2 4\nl 3 4\nl 5 6\nl 5 7\nl 6 8\nl 7 8\nl 1 5\nl 2 6\nl 3 7\nl 4 8\n";
    for corner in Corner::all() {
        let here = at(corner);
        let n = corner.number();
        text += &format!("g corner_{n}\n");
        for a in 0..3 {
            let mut p = here;
            // Marks point into the cube.
            p[a] += if corner.xyz()[a] == 0 { 60 } else { -60 };
            text += &format!("v {} {} {}\n", p[0], p[1], p[2]);
        }
        let (own, first) = (n + 1, 9 + 3 * n);
        text += &format!(
            "f {own} {first} {}\nf {own} {} {}\nf {own} {} {first}\n",
            first + 1,
            first + 1,
            first + 2,
            first + 2
        );
    }
    BakedFile { name: CAGE_FILE.into(), text }
}
