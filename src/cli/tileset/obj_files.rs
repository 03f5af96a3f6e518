//! Tiles of solids as files: OBJ with a group for each component and octant, the material library, the manifest.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use houscaper::envelope::FabricLayer;
use houscaper::export::{Palette, layer_material, to_mtl};
use houscaper::tiles::solids::boundary;
use houscaper::tiles::{BakedFile, Block, Body, CUBE_MM, Component, SCHEMA};
use houscaper::voxels::Label;
use serde_json::{Value, json};

/// Name of the material library beside the tiles.
pub const MTL: &str = "components.mtl";

/// Millimetres with as many decimals as a whole number of micrometres needs.
fn mm(um: i32) -> String {
    let text = format!("{}.{:03}", um.abs() / 1000, um.abs() % 1000);
    let text = text.trim_end_matches('0').trim_end_matches('.').to_owned();
    if um < 0 { format!("-{text}") } else { text }
}

/// The OBJ of one tile in mm: a closed solid for each component and octant, in a group of its own.
pub fn solid_obj(comment: &str, blocks: &[Block]) -> String {
    let mut text = format!("# {comment}\nmtllib {MTL}\n");
    let mut order: Vec<Block> = blocks.to_vec();
    order.sort_by_key(|b| (b.component, b.octant));
    let mut used = 0;
    for solid in order.chunk_by(|a, b| (a.component, a.octant) == (b.component, b.octant)) {
        group(&mut text, solid[0].component.name(), solid[0].octant, &boundary(solid), &mut used);
    }
    text
}

/// The OBJ of one mesh tile in mm: its bodies in groups by what `name` calls them and octant.
pub fn body_obj<'a>(comment: &str, bodies: &'a [Body], name: impl Fn(&'a Body) -> &'a str) -> String {
    let mut text = format!("# {comment}\nmtllib {MTL}\n");
    let mut order: Vec<(&str, u8, &Body)> = bodies.iter().map(|b| (name(b), b.octant, b)).collect();
    order.sort_by_key(|(name, octant, _)| (*name, *octant));
    let mut used = 0;
    for solid in order.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        let faces: Vec<_> = solid.iter().flat_map(|(.., b)| b.polygons.iter().cloned()).collect();
        group(&mut text, solid[0].0, solid[0].1, &faces, &mut used);
    }
    text
}

/// Adds a group of faces; `used` counts the vertices before it.
fn group(text: &mut String, name: &str, octant: u8, faces: &[Vec<[i32; 3]>], used: &mut usize) {
    // Libraries name materials without white space.
    let material = name.split_whitespace().collect::<Vec<_>>().join("_");
    let _ = writeln!(text, "g {name}_o{octant}\nusemtl {material}");
    let mut vertices: Vec<[i32; 3]> = faces.iter().flatten().copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    for v in &vertices {
        let [x, y, z] = v.map(mm);
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for face in faces {
        text.push('f');
        for p in face {
            let _ = write!(text, " {}", *used + vertices.partition_point(|v| v < p) + 1);
        }
        text.push('\n');
    }
    *used += vertices.len();
}

/// The material library of all components.
pub fn library(palette: &Palette) -> BakedFile {
    materials(&FabricLayer::of_components(), palette)
}

/// The material library of some layers.
pub fn materials(layers: &[FabricLayer], palette: &Palette) -> BakedFile {
    let materials: Vec<_> = layers.iter().map(|layer| layer_material(layer, palette)).collect();
    BakedFile { name: MTL.into(), text: to_mtl(&materials) }
}

/// How far blocks reach out of the cube, whole mm rounded up.
pub fn overhang_mm(blocks: &[Block]) -> i32 {
    beyond_mm(blocks.iter().flat_map(Block::faces).flatten())
}

/// How far points lie out of the cube, whole mm rounded up.
pub fn beyond_mm(points: impl Iterator<Item = [i32; 3]>) -> i32 {
    beyond_cube_mm(points, CUBE_MM.map(|mm| mm * 1000))
}

/// How far points lie out of a cube of `size` µm, whole mm rounded up.
pub fn beyond_cube_mm(points: impl Iterator<Item = [i32; 3]>, size: [i32; 3]) -> i32 {
    let beyond = |p: [i32; 3]| (0..3).map(|a| (-p[a]).max(p[a] - size[a])).max().unwrap_or(0);
    (points.map(beyond).max().unwrap_or(0).max(0) + 999) / 1000
}

/// One tile of a manifest.
pub fn entry(name: &str, pattern: &str, symmetric: bool) -> Value {
    json!({
        "name": name,
        "pattern": pattern,
        "symmetry": {"mirror": symmetric, "quarter_turns": symmetric},
        "file": format!("{name}.obj"),
    })
}

/// The parts of a manifest that every set made here shares.
pub fn manifest(name: &str, description: &str, kind: &str, layers: Value, tiles: Vec<Value>) -> BakedFile {
    let labels: BTreeMap<String, &str> = Label::ALL.iter().map(|l| (l.code().to_string(), l.name())).collect();
    let manifest = json!({
        "schema": SCHEMA, "name": name, "description": description, "kind": kind, "unit": "mm", "up_axis": "z",
        "module_size": CUBE_MM.map(f64::from), "corner_order": "f_order", "labels": labels, "layers": layers,
        "tiles": tiles,
    });
    BakedFile { name: houscaper::tiles::MANIFEST_FILE.into(), text: format!("{manifest:#}\n") }
}

/// A layer for each component in use, with the reach of its farthest block.
pub fn solid_layers(used: &BTreeSet<Component>, overhang: i32) -> Value {
    let layer = |c: &Component| json!({"name": c.name(), "kind": "solid", "overhang": f64::from(overhang), "component": c.name()});
    used.iter().map(layer).collect()
}
