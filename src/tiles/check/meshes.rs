//! Reading every file of a set, and the checks of sets that do not look at labels.

use super::super::bodies::{Body, bodies};
use super::super::claims::{Placement, claims, duplicates, missing, table};
use super::super::entry::TileEntry;
use super::super::label_set::drawn_mask;
use super::super::linear_set::{lines_of, needs_lines};
use super::super::manifest::{Manifest, TilesetKind};
use super::super::obj::{Grid, read_obj};
use super::super::validate::{Content, surface_content};
use super::super::{
    Finding as OpenSeam, Line, LinearTileset, Tileset, TilesetError, check_linear_tileset, check_tileset, doubled_area,
    meetings,
};
use super::finding::{Coverage, Finding, FindingKind, Report};
use super::folder::Folder;
use crate::cubes::{Corner, Mask};
use std::path::PathBuf;

/// A place on the boundary of what a tile draws.
pub(super) struct Sample {
    /// Just inside, in fractions of the cube.
    pub point: [f64; 3],
    /// The octant that the drawing names for it.
    pub octant: Option<u8>,
    /// The area it stands for.
    pub weight: f64,
}

/// What the files of a set hold, tile by tile.
#[derive(Default)]
pub(super) struct Sheets {
    /// The manifest.
    pub path: PathBuf,
    /// The folder of the OBJ files.
    pub folder: PathBuf,
    /// First file of each tile in a surface set.
    pub surfaces: Vec<Content>,
    /// First file of each tile in a linear set.
    pub lines: Vec<Vec<Line>>,
    /// Tile, variant, bodies in a set of solids.
    pub bodies: Vec<Vec<Vec<Body>>>,
    /// Bounds of each tile over all its files, mm in the cube.
    pub bounds_mm: Vec<Option<[[f64; 3]; 2]>>,
    /// Samples of each tile.
    pub samples: Vec<Vec<Sample>>,
    /// The corners each pattern fills.
    pub drawn: Vec<Mask>,
}

impl Sheets {
    /// Reads all files; whatever is wrong with one is added to the report.
    pub fn read(folder: &Folder, manifest: &Manifest, report: &mut Report) -> Sheets {
        let path = folder.manifest_path();
        let root = folder.root().map_or_else(|| manifest.folder(folder.dir()), std::path::Path::to_path_buf);
        let mut sheets = Sheets { path, folder: root, ..Sheets::default() };
        for entry in &manifest.tiles {
            sheets.drawn.push(drawn_mask(manifest, entry, &sheets.path));
            sheets.tile(folder, manifest, entry, report);
        }
        sheets
    }

    fn tile(&mut self, folder: &Folder, manifest: &Manifest, entry: &TileEntry, report: &mut Report) {
        let size = manifest.module_mm();
        let drawn = self.drawn.last().copied().unwrap_or(Mask::FULL);
        let (mut surface, mut lines, mut solids) = (Content::default(), Vec::new(), Vec::new());
        let (mut bounds, mut samples) = (None, Vec::new());
        for (variant, file) in entry.files().enumerate() {
            let path = self.folder.join(file);
            let text = match folder.read(&path) {
                Ok(text) => text,
                Err(source) => {
                    report.add(TilesetError::Read { path, source }, Some(&entry.name));
                    continue;
                }
            };
            let grid = if manifest.kind == TilesetKind::Solids { Grid::Micrometre } else { Grid::Millimetre };
            let drawing = read_obj(&text, &path, &manifest.axes(entry), grid);
            bounds = joined(bounds, drawing.bounds_mm);
            let more = match manifest.kind {
                TilesetKind::Linear => {
                    let (found, more) = lines_of(&drawing.elements, size, &path);
                    lines = found;
                    more
                }
                TilesetKind::Surface => {
                    let (found, more) = surface_content(&drawing.elements, manifest, &path);
                    for facet in &found.facets {
                        let sample = sample(&facet.polygon, size, 1.0);
                        samples.extend(sample.map(|s| Sample { octant: Some(facet.octant), ..s }));
                    }
                    if variant == 0 {
                        surface = found;
                    }
                    more
                }
                TilesetKind::Solids | TilesetKind::Style => {
                    let (found, more) = bodies(&drawing.elements, manifest, drawn, &path);
                    let polygons = found.iter().flat_map(|b| &b.polygons);
                    samples.extend(polygons.filter_map(|p| sample(p, size.map(|mm| mm * 1000), 1e-6)));
                    solids.push(found);
                    more
                }
            };
            drawing.mistakes.into_iter().chain(more).for_each(|m| report.add(m, Some(&entry.name)));
        }
        self.surfaces.push(surface);
        self.lines.push(lines);
        self.bodies.push(solids);
        self.bounds_mm.push(bounds);
        self.samples.push(samples);
    }

    /// OBJ files beside those that tiles name.
    pub fn unused(&self, folder: &Folder, manifest: &Manifest, report: &mut Report) {
        for name in folder.obj_files(&self.folder) {
            let used = manifest.tiles.iter().any(|t| t.files().any(|f| *f == name));
            // Numbered sets may keep a file for the empty configuration; scaffolds keep their cage to draw in.
            if !used && manifest.numbered.is_none() && name != super::CAGE_FILE {
                let path = self.folder.join(&name).display().to_string();
                let message = format!("{path}: no tile names this file; add it to the manifest or remove it");
                let finding = Finding::new(FindingKind::UnusedFile, message);
                report.findings.push(Finding { file: Some(path), ..finding });
            }
        }
    }
}

fn joined(a: Option<[[f64; 3]; 2]>, b: Option<[[f64; 3]; 2]>) -> Option<[[f64; 3]; 2]> {
    let (Some([al, ah]), Some([bl, bh])) = (a, b) else { return a.or(b) };
    Some([[0, 1, 2].map(|i| al[i].min(bl[i])), [0, 1, 2].map(|i| ah[i].max(bh[i]))])
}

/// A point a hundredth of the cube below the middle of a polygon.
fn sample(polygon: &[[i32; 3]], size: [i32; 3], weight: f64) -> Option<Sample> {
    let n = polygon.len() as f64;
    let middle = [0, 1, 2].map(|a| polygon.iter().map(|p| f64::from(p[a])).sum::<f64>() / n / f64::from(size[a]));
    if polygon.iter().flatten().any(|c| c.abs() > 100_000_000) {
        return None;
    }
    let normal = super::super::mesh::doubled_area(polygon).map(|c| c as f64);
    let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
    let point = [0, 1, 2].map(|a| middle[a] - 0.01 * normal[a] / length);
    (length > 0.0).then_some(Sample { point, octant: None, weight: length * weight })
}

/// The table of a set that does not look at labels, with everything wrong about them reported.
fn claimed(
    manifest: &Manifest,
    path: &std::path::Path,
    needed: impl Fn(Mask) -> bool + Copy,
    report: &mut Report,
) -> [Option<Placement>; 256] {
    let (claims, mistakes) = claims(manifest, path, needed);
    let table = table(manifest, &claims);
    let all = mistakes.into_iter().chain(duplicates(manifest, path, &claims)).chain(missing(&table, path, needed));
    all.for_each(|m| report.add(m, None));
    let reachable: Vec<Mask> = Mask::all().filter(|&m| needed(m)).collect();
    let covered = reachable.iter().filter(|m| table[m.0 as usize].is_some()).count();
    report.coverage = Some(Coverage { reachable: reachable.len(), covered });
    table
}

pub(super) fn check_surface(manifest: &Manifest, sheets: &Sheets, report: &mut Report) {
    let table = claimed(manifest, &sheets.path, Mask::is_admissible, report);
    let size = manifest.module_mm();
    for (content, entry) in sheets.surfaces.iter().zip(&manifest.tiles) {
        // Every facet should look away from the corner it hangs on.
        let outward = |f: &super::super::Facet| -> f64 {
            let area = doubled_area(&f.polygon).map(|c| c as f64);
            let corner = Corner::new(f.octant).map_or([0; 3], Corner::xyz);
            let n = f.polygon.len() as f64;
            (0..3)
                .map(|a| {
                    let middle = f.polygon.iter().map(|p| f64::from(p[a])).sum::<f64>() / n;
                    area[a] * (middle - f64::from(corner[a]) * f64::from(size[a]))
                })
                .sum()
        };
        if content.facets.iter().map(outward).sum::<f64>() < 0.0 {
            let file = sheets.folder.join(&entry.file).display().to_string();
            let message = format!(
                "{file}: the surface of tile {} is inside out: it faces its filled corners; turn all its faces over",
                entry.name
            );
            let finding = Finding::new(FindingKind::InsideOut, message).of_tiles([entry.name.as_str()]);
            report.findings.push(Finding { line: content.lines.first().copied(), file: Some(file), ..finding });
        }
    }
    let (set, mistakes) = Tileset::assemble(manifest, &sheets.folder, &sheets.surfaces, &table);
    mistakes.into_iter().for_each(|m| report.add(m, None));
    seams(check_tileset(&set), |m| m.is_admissible() && table[m.0 as usize].is_none(), report);
}

pub(super) fn check_lines(manifest: &Manifest, sheets: &Sheets, report: &mut Report) {
    let table = claimed(manifest, &sheets.path, needs_lines, report);
    let set = LinearTileset::assemble(manifest, &sheets.lines, &table);
    seams(check_linear_tileset(&set), |m| needs_lines(m) && table[m.0 as usize].is_none(), report);
}

/// Open seams as findings; those beside a configuration without a tile say nothing new.
fn seams(open: Vec<OpenSeam>, has_no_tile: impl Fn(Mask) -> bool, report: &mut Report) {
    let before = report.findings.len();
    for seam in open {
        let masks = [seam.meeting.low, seam.meeting.high];
        if masks.into_iter().any(&has_no_tile) {
            continue;
        }
        let message = seam.to_string();
        let finding = Finding::new(FindingKind::Seam, message).of_tiles(seam.tiles.iter().map(String::as_str));
        report.findings.push(Finding {
            face: Some(seam.meeting.axis.name().into()),
            neighbour: Some(seam.tiles[1].clone()),
            configurations: masks.map(|m| m.to_string()).into(),
            only_first: seam.only_low,
            only_second: seam.only_high,
            ..finding
        });
    }
    let found = report.findings.len() - before;
    let plural = if found == 1 { "" } else { "s" };
    report.compared =
        format!("{} pairs that may meet compared along x, y and z: {found} seam{plural} open", meetings().count());
}
