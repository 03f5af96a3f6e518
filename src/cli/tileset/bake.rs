//! `tileset bake`: all expanded tiles of a set as OBJ files, or a shipped set written anew from its construction rule.

use std::collections::BTreeSet;
use std::path::Path;

use anyhow::Context;
use houscaper::cubes::{CubeKey, Mask, catalogue, needs_tile, reachable_labels};
use houscaper::envelope::FabricLayer;
use houscaper::export::Palette;
use houscaper::tiles::check::{Folder, check};
use houscaper::tiles::{BakedFile, LabelSet, LinearTileset, Style, Tileset, bake_linear, bake_surface};
use houscaper::voxels::Label;
use serde_json::{Value, json};

use super::architectural::{self, Architectural};
use super::catalogue::needing_tiles;
use super::{Loaded, obj_files};
use crate::cli::args::TilesetBake;
use crate::cli::failure::{Blame, Failure, Outcome, bad_input};
use crate::cli::output;
use crate::cli::progress::WorkBar;

pub fn run(args: &TilesetBake) -> Outcome {
    let dir = super::named(&args.name);
    let (name, files) = if args.canonical {
        (args.name.clone(), canonical(&args.name)?)
    } else if architectural::is_style(&dir) {
        let set = Architectural::load(&dir)?;
        (format!("{}-baked", set.name()), solids(&set, args.families))
    } else if super::is_solids(&dir) {
        let set = LabelSet::load_from(&dir, args.root.as_deref()).input()?;
        (format!("{}-baked", set.name()), meshes(&set))
    } else {
        match super::load(&dir)? {
            Loaded::Surface(set) => (format!("{}-baked", set.name()), surfaces(&set)),
            Loaded::Linear(set) => (format!("{}-baked", set.name()), lines(&set)),
        }
    };
    check_target(&args.out, &name, &files)?;
    std::fs::create_dir_all(&args.out).with_context(|| format!("cannot make {}", args.out.display())).input()?;
    let bar = WorkBar::new(files.len(), "files");
    // The manifest comes first in the list and is written last: a folder cut short is no tileset yet.
    for file in files.iter().rev() {
        output::write(&args.out.join(&file.name), file.text.as_bytes())?;
        bar.step();
    }
    eprintln!("{}: {} files of {name}", args.out.display(), files.len());
    Ok(())
}

/// A shipped set's own files.
fn canonical(name: &str) -> Result<Vec<BakedFile>, Failure> {
    match name {
        "surface-1" => Ok(bake_surface(&Style::SURFACE_1)),
        "surface-1-offset" => Ok(bake_surface(&Style::SURFACE_1_OFFSET)),
        "surface-2" => Ok(bake_surface(&Style::SURFACE_2)),
        "linear" => Ok(bake_linear()),
        other => Err(bad_input(format!(
            "no tileset is called `{other}`; expected surface-1, surface-1-offset, surface-2 or linear"
        ))),
    }
}

/// A file for each of the 126 configurations of a surface set, with its solid layers.
fn surfaces(set: &Tileset) -> Vec<BakedFile> {
    let mut layers = BTreeSet::new();
    let tiles = Mask::all().filter(|&m| !set.tile_name(m).is_empty()).map(|mask| {
        let patches = set.patches(mask).iter();
        let mut groups: Vec<(String, &[[i32; 3]])> =
            patches.map(|p| (format!("{}_o{}", p.kind.name(), p.octant), p.polygon.as_slice())).collect();
        for solid in set.solids(mask) {
            layers.insert(solid.layer.clone());
            let name = format!("{}_o{}", solid.layer, solid.octant);
            groups.extend(solid.polygons.iter().map(|p| (name.clone(), p.as_slice())));
        }
        (mask, set.tile_name(mask).to_owned(), obj_text('f', &groups))
    });
    let tiles: Vec<_> = tiles.collect();
    // Solid layers may reach out of the cube as far as they did in the set.
    let solid = layers.iter().map(|l| json!({"name": l, "kind": "solid", "overhang": 1000.0}));
    let surface = json!({"name": "envelope", "kind": "surface", "overhang": 0.0});
    expanded(set.name(), "surface", [surface].into_iter().chain(solid).collect(), tiles)
}

fn lines(set: &LinearTileset) -> Vec<BakedFile> {
    let tiles = Mask::all().filter(|&m| !set.tile_name(m).is_empty()).map(|mask| {
        let ends: Vec<(String, [[i32; 3]; 2])> = set
            .lines(mask)
            .iter()
            .map(|l| {
                let [a, b] = l.octants;
                let octants = if a == b { a.to_string() } else { format!("{a}_{b}") };
                (format!("{}_o{octants}", l.role.name()), [l.from, l.to])
            })
            .collect();
        let groups: Vec<(String, &[[i32; 3]])> = ends.iter().map(|(n, p)| (n.clone(), p.as_slice())).collect();
        (mask, set.tile_name(mask).to_owned(), obj_text('l', &groups))
    });
    expanded(set.name(), "linear", json!([]), tiles.collect())
}

/// The files of a set in which every configuration has a tile of its own.
fn expanded(set: &str, kind: &str, layers: serde_json::Value, tiles: Vec<(Mask, String, String)>) -> Vec<BakedFile> {
    let name = |mask: Mask| format!("configuration-{:03}", mask.0);
    let entries = tiles.iter().map(|(mask, ..)| obj_files::entry(&name(*mask), &mask.pattern(), false)).collect();
    let description = format!("Every configuration of {set} as a tile of its own.");
    let mut files = vec![obj_files::manifest(&format!("{set}-baked"), &description, kind, layers, entries)];
    files.extend(tiles.into_iter().map(|(mask, tile, text)| {
        let comment = format!("# {set} {tile} as configuration {mask}, millimetres, z up\n");
        BakedFile { name: format!("{}.obj", name(mask)), text: comment + &text }
    }));
    files
}

/// Elements as OBJ: vertices sorted, then groups in the order given.
fn obj_text(keyword: char, groups: &[(String, &[[i32; 3]])]) -> String {
    let mut vertices: Vec<[i32; 3]> = groups.iter().flat_map(|(_, points)| points.iter().copied()).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let mut text: String = vertices.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
    let mut group = "";
    for (name, points) in groups {
        if name != group {
            text += &format!("g {name}\n");
            group = name;
        }
        text.push(keyword);
        points.iter().for_each(|p| text += &format!(" {}", vertices.partition_point(|v| v < p) + 1));
        text.push('\n');
    }
    text
}

/// A file for each labelling that houses can show, or for the thesis's 493, as rule A builds it: from its labels alone. Where the style
/// is overridden the overriding meshes are written, each variant as a file.
fn solids(set: &Architectural, families: bool) -> Vec<BakedFile> {
    let mut configurations =
        if families { catalogue().into_iter().flat_map(|f| f.members).collect() } else { needing_tiles() };
    if !families {
        // A mesh may stand where the construction needs nothing.
        let more = |l: &[Label; 8]| !needs_tile(l) && !set.overrides(CubeKey::of_labels(*l)).is_empty();
        configurations.extend(reachable_labels().into_iter().filter(more));
    }
    let bar = WorkBar::new(configurations.len(), "tiles");
    let (mut files, mut entries, mut used, mut overhang) = (Vec::new(), Vec::new(), BTreeSet::new(), 0);
    for labels in configurations {
        let key = CubeKey::of_labels(labels);
        let name = format!("labels-{key}");
        let comment = format!("{} {key}: labels of the corners, millimetres, z up", set.name());
        bar.step();
        let variants = set.overrides(key);
        if !variants.is_empty() {
            let mut further: Vec<Value> = Vec::new();
            for (n, tile) in variants.iter().enumerate() {
                let points = tile.bodies.iter().flat_map(|b| b.polygons.iter().flatten().copied());
                overhang = overhang.max(obj_files::beyond_mm(points));
                used.extend(tile.bodies.iter().map(|b| b.component));
                let file = if n == 0 { format!("{name}.obj") } else { format!("{name}-{n}.obj") };
                further.extend((n > 0).then(|| json!(file)));
                let comment = format!("{comment}, override {}", tile.name);
                files.push(BakedFile {
                    name: file,
                    text: obj_files::body_obj(&comment, &tile.bodies, |b| b.component.name()),
                });
            }
            let mut entry = obj_files::entry(&name, &key.to_string(), false);
            if !further.is_empty() {
                entry["variants"] = json!(further);
            }
            entries.push(entry);
            continue;
        }
        let blocks = set.blocks(key);
        if blocks.is_empty() {
            continue;
        }
        used.extend(blocks.iter().map(|b| b.component));
        overhang = overhang.max(obj_files::overhang_mm(&blocks));
        entries.push(obj_files::entry(&name, &key.to_string(), false));
        files.push(BakedFile { name: format!("{name}.obj"), text: obj_files::solid_obj(&comment, &blocks) });
    }
    let name = format!("{}-baked", set.name());
    let description = format!("The set {} by labels alone, a tile for each configuration.", set.name());
    files.push(obj_files::library(&set.palette()));
    files.insert(
        0,
        obj_files::manifest(&name, &description, "solids", obj_files::solid_layers(&used, overhang), entries),
    );
    accept_open_seams(&mut files);
    files
}

/// A file for each labelling that houses can show and the set has a tile for, as it is placed there, each variant as a file: a set of
/// ours in millimetres whatever the unit, axes, pivot and numbering it was drawn in.
fn meshes(set: &LabelSet) -> Vec<BakedFile> {
    let size = set.module_um();
    let mut overhang = vec![0; set.layers().len()];
    let (mut files, mut entries) = (Vec::new(), Vec::new());
    let wanted = |labels: &[Label; 8]| needs_tile(labels) || set.draws_full();
    for key in reachable_labels().into_iter().filter(wanted).map(CubeKey::of_labels) {
        let name = format!("labels-{key}");
        let mut variants: Vec<Value> = Vec::new();
        for (n, tile) in set.tiles(key).iter().enumerate() {
            for body in &tile.bodies {
                let beyond = obj_files::beyond_cube_mm(body.polygons.iter().flatten().copied(), size);
                overhang[body.layer] = beyond.max(overhang[body.layer]);
            }
            let file = if n == 0 { format!("{name}.obj") } else { format!("{name}-{n}.obj") };
            let comment = format!("{} {} as {key}: labels of the corners, millimetres, z up", set.name(), tile.name);
            let text = obj_files::body_obj(&comment, &tile.bodies, |b| set.layers()[b.layer].name.as_str());
            variants.push(json!(file));
            files.push(BakedFile { name: file, text });
        }
        if !variants.is_empty() {
            let mut entry = obj_files::entry(&name, &key.to_string(), false);
            if variants.len() > 1 {
                entry["variants"] = json!(variants[1..]);
            }
            entries.push(entry);
        }
    }
    let layers = FabricLayer::of_set(set);
    let stated = layers.iter().zip(overhang).map(|(layer, overhang)| {
        json!({"name": layer.name, "kind": "solid", "overhang": f64::from(overhang), "component": layer.component.name()})
    });
    let description = format!("The set {}, a tile for each configuration that it covers.", set.name());
    let name = format!("{}-baked", set.name());
    let mut manifest = obj_files::manifest(&name, &description, "solids", stated.collect(), entries);
    if let Ok(mut json) = serde_json::from_str::<Value>(&manifest.text) {
        json["module_size"] = json!(size.map(|um| f64::from(um) / 1000.0));
        manifest.text = format!("{json:#}\n");
    }
    files.push(obj_files::materials(&layers, &Palette::default()));
    files.insert(0, manifest);
    accept_open_seams(&mut files);
    files
}

/// States in the manifest where tiles that look at labels alone show different things on a face: slabs that end on level faces, level
/// roofs beside sloped ones, and openings that stay wall at a corner of the house. The neighbourhood tells those apart, not the labels.
pub(super) fn accept_open_seams(files: &mut [BakedFile]) {
    let mut open: BTreeSet<String> = BTreeSet::new();
    loop {
        let texts = files.iter().map(|f| (f.name.clone(), f.text.clone())).collect();
        let report = check(&Folder::in_memory(texts), None);
        let before = open.len();
        open.extend(report.findings.into_iter().filter_map(|f| f.open_seam));
        let manifest = files.first().and_then(|f| Some((f.name.clone(), serde_json::from_str::<Value>(&f.text).ok()?)));
        let Some((name, mut manifest)) = manifest.filter(|_| open.len() > before) else { return };
        manifest["open_seams"] = json!(open);
        files[0] = BakedFile { name, text: format!("{manifest:#}\n") };
    }
}

/// Only a folder that is missing, empty, or holds this very set may be written to.
fn check_target(out: &Path, name: &str, files: &[BakedFile]) -> Outcome {
    if out.exists() && !out.is_dir() {
        return Err(bad_input(format!("{}: is a file; name a folder", out.display())));
    }
    let Ok(mut entries) = std::fs::read_dir(out) else { return Ok(()) };
    let same_set = super::manifest(out).is_some_and(|m| m["name"] == name);
    let names: BTreeSet<&str> = files.iter().map(|f| f.name.as_str()).collect();
    let stranger = entries.find_map(|e| {
        let file = e.ok()?.file_name();
        let ours = same_set && file.to_str().is_some_and(|f| names.contains(f));
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
