//! Turning a style into files: the manifest and one OBJ per canonical tile, as a designer would deliver them.

use super::axes::Pivot;
use super::construct::construct;
use super::entry::{TileEntry, TileSymmetry};
use super::layer::{Layer, LayerKind};
use super::manifest::{Manifest, SCHEMA, TilesetKind, label_table};
use super::obj::write_obj;
use super::skeleton::skeleton;
use super::style::{CUBE_MM, Style};
use super::surface::MANIFEST_FILE;
use crate::cubes::{Category, CornerOrder, Mask, canonical_masks};
use std::path::Path;

/// A file of a tileset: name and text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BakedFile {
    /// Name in the tileset's folder.
    pub name: String,
    /// Content.
    pub text: String,
}

/// Name of a canonical tile: what it is in a house, and its mask.
fn tile_name(mask: Mask) -> String {
    if mask == Mask::FULL { "full-255".into() } else { format!("{}-{:03}", Category::of(mask).name(), mask.0) }
}

/// The files of a surface tileset: 26 canonical tiles, polygons grouped by kind and octant.
pub fn bake_surface(style: &Style) -> Vec<BakedFile> {
    let layers = vec![Layer {
        name: "envelope".into(),
        kind: LayerKind::Surface,
        overhang: 0.0,
        component: None,
        groups: Vec::new(),
    }];
    bake(style, TilesetKind::Surface, layers, &canonical_masks(), |mask, comment| {
        let elements: Vec<_> = construct(mask, 0, style)
            .into_iter()
            .map(|f| (format!("{}_o{}", f.kind.name(), f.octant), f.polygon))
            .collect();
        write_obj(comment, &elements, true)
    })
}

/// The files of the linear tileset: 26 canonical tiles and the full cube, lines grouped by role and octants.
pub fn bake_linear() -> Vec<BakedFile> {
    let masks: Vec<Mask> = canonical_masks().into_iter().chain([Mask::FULL]).collect();
    bake(&Style::LINEAR, TilesetKind::Linear, Vec::new(), &masks, |mask, comment| {
        let elements: Vec<_> = skeleton(mask)
            .into_iter()
            .map(|l| {
                let [a, b] = l.octants;
                let octants = if a == b { a.to_string() } else { format!("{a}_{b}") };
                (format!("{}_o{octants}", l.role.name()), vec![l.from, l.to])
            })
            .collect();
        write_obj(comment, &elements, false)
    })
}

fn bake(
    style: &Style,
    kind: TilesetKind,
    layers: Vec<Layer>,
    masks: &[Mask],
    obj: impl Fn(Mask, &str) -> String,
) -> Vec<BakedFile> {
    let tiles: Vec<TileEntry> = masks
        .iter()
        .map(|&mask| TileEntry {
            name: tile_name(mask),
            pattern: mask.pattern(),
            symmetry: TileSymmetry { mirror: true, quarter_turns: true },
            file: format!("{}.obj", tile_name(mask)),
            variants: Vec::new(),
            priority: 0,
            pivot: None,
        })
        .collect();
    let mut files: Vec<BakedFile> = masks
        .iter()
        .zip(&tiles)
        .map(|(&mask, tile)| {
            let comment = format!("{} {}: corners {}, millimetres, z up", style.name, tile.name, tile.pattern);
            BakedFile { name: tile.file.clone(), text: obj(mask, &comment) }
        })
        .collect();
    let manifest = Manifest {
        schema: SCHEMA.into(),
        name: style.name.into(),
        description: style.description.into(),
        kind,
        unit: "mm".into(),
        up_axis: "z".into(),
        pivot: Pivot::default(),
        module_size: CUBE_MM.map(f64::from),
        corner_order: CornerOrder::FOrder.name().into(),
        labels: label_table(),
        root: None,
        layers,
        tiles,
        numbered: None,
        open_seams: Vec::new(),
    };
    // Plain strings and numbers: serialising them cannot fail.
    let text = serde_json::to_string_pretty(&manifest).expect("a manifest is always valid JSON");
    files.insert(0, BakedFile { name: MANIFEST_FILE.into(), text: text + "\n" });
    files
}

/// Writes baked files into `dir`, which is made if it is missing.
pub fn write_files(dir: &Path, files: &[BakedFile]) -> std::io::Result<()> {
    std::fs::create_dir_all(dir)?;
    files.iter().try_for_each(|file| std::fs::write(dir.join(&file.name), &file.text))
}
