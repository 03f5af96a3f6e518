//! Linear tilesets: loaded once, expanded to every configuration and the full cube, looked up by mask.

use super::claims::{Placement, placements};
use super::entry::TileEntry;
use super::manifest::{Manifest, TilesetKind};
use super::obj::{Element, Grid, read_obj};
use super::surface::MANIFEST_FILE;
use super::{Line, LineRole, TilesetError};
use crate::cubes::Mask;
use std::path::Path;

/// A linear tileset in memory: one table entry per mask.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearTileset {
    name: String,
    module_mm: [i32; 3],
    names: Vec<String>,
    lines: Vec<Vec<Line>>,
}

impl LinearTileset {
    /// Loads the folder `dir`: its `tileset.json` and the OBJ files named there.
    pub fn load(dir: &Path) -> Result<LinearTileset, TilesetError> {
        LinearTileset::read(dir, |path| std::fs::read_to_string(path))
    }

    /// The same with the files' texts given by `read`, so that tests need no disk.
    pub fn read(dir: &Path, read: impl Fn(&Path) -> std::io::Result<String>) -> Result<LinearTileset, TilesetError> {
        let read = |path: &Path| read(path).map_err(|source| TilesetError::Read { path: path.into(), source });
        let path = dir.join(MANIFEST_FILE);
        let manifest = Manifest::parse(&read(&path)?, &path, TilesetKind::Linear)?;
        let placements = placements(&manifest, &path, needs_lines)?;
        let folder = manifest.folder(dir);
        let mut contents = Vec::with_capacity(manifest.tiles.len());
        for entry in &manifest.tiles {
            let path = folder.join(entry.files().next().map_or("", String::as_str));
            let (lines, mistakes) = read_lines(&read(&path)?, &manifest, entry, &path);
            if let Some(mistake) = mistakes.into_iter().next() {
                return Err(mistake);
            }
            contents.push(lines);
        }
        Ok(LinearTileset::assemble(&manifest, &contents, &placements))
    }

    /// The set of the contents of a manifest's tiles.
    pub(super) fn assemble(
        manifest: &Manifest,
        contents: &[Vec<Line>],
        placements: &[Option<Placement>; 256],
    ) -> LinearTileset {
        let size = manifest.module_mm();
        let mut set = LinearTileset::empty(&manifest.name, size);
        for (mask, placement) in placements.iter().enumerate() {
            if let Some(p) = placement {
                set.names[mask] = manifest.tiles[p.tile].name.clone();
                set.lines[mask] = contents[p.tile].iter().map(|l| l.placed(p.symmetry, size)).collect();
                set.lines[mask].sort_unstable();
            }
        }
        set
    }

    /// A linear tileset from a function that gives the lines of each admissible mask and of the full one.
    pub fn from_lines(name: &str, module_mm: [i32; 3], lines: impl Fn(Mask) -> Vec<Line>) -> LinearTileset {
        let mut set = LinearTileset::empty(name, module_mm);
        for mask in crate::cubes::admissible_masks().chain([Mask::FULL]) {
            set.names[mask.0 as usize] = format!("{name} {}", mask.0);
            set.lines[mask.0 as usize] = lines(mask);
            set.lines[mask.0 as usize].sort_unstable();
        }
        set
    }

    fn empty(name: &str, module_mm: [i32; 3]) -> LinearTileset {
        LinearTileset { name: name.into(), module_mm, names: vec![String::new(); 256], lines: vec![Vec::new(); 256] }
    }

    /// Name in the manifest.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Edges of a cube, mm.
    pub fn module_mm(&self) -> [i32; 3] {
        self.module_mm
    }

    /// Name of the tile that covers a mask, empty where none does.
    pub fn tile_name(&self, mask: Mask) -> &str {
        &self.names[mask.0 as usize]
    }

    /// The lines in a cube, sorted; none in an empty or inadmissible one.
    #[inline]
    pub fn lines(&self, mask: Mask) -> &[Line] {
        &self.lines[mask.0 as usize]
    }
}

/// Whether a configuration needs a tile: inside a house the full cube carries the slab grid, so it needs one too.
pub(super) fn needs_lines(mask: Mask) -> bool {
    mask.is_admissible() || mask == Mask::FULL
}

/// Reads the OBJ text of a linear tile, and lists what is wrong with it.
pub(super) fn read_lines(
    text: &str,
    manifest: &Manifest,
    entry: &TileEntry,
    path: &Path,
) -> (Vec<Line>, Vec<TilesetError>) {
    let drawing = read_obj(text, path, &manifest.axes(entry), Grid::Millimetre);
    let (lines, more) = lines_of(&drawing.elements, manifest.module_mm(), path);
    (lines, drawing.mistakes.into_iter().chain(more).collect())
}

pub(super) fn lines_of(elements: &[Element], size: [i32; 3], path: &Path) -> (Vec<Line>, Vec<TilesetError>) {
    let (mut lines, mut mistakes) = (Vec::new(), Vec::new());
    for element in elements {
        let Some((role, octants)) = group(&element.group).filter(|_| !element.is_polygon) else {
            mistakes.push(TilesetError::Obj {
                path: path.into(),
                line: element.line,
                found: if element.is_polygon { "a polygon".into() } else { format!("the group '{}'", element.group) },
                expected: format!(
                    "a line element in a group named by one of {} followed by _o and one or two octants 0 to 7, for example \
                     edge_o0_1",
                    LineRole::ALL.map(LineRole::name).join(", ")
                ),
            });
            continue;
        };
        for (point, &line) in element.points.iter().zip(&element.point_lines) {
            let beyond = (0..3).map(|a| (-point[a]).max(point[a] - size[a])).max().unwrap_or(0);
            if beyond > 0 {
                let layer = "lines".into();
                let path = path.into();
                mistakes.push(TilesetError::LeavesCube { path, line, vertex: *point, beyond, layer, overhang: 0 });
            }
        }
        for ends in element.points.windows(2) {
            if ends[0] == ends[1] {
                mistakes.push(TilesetError::Obj {
                    path: path.into(),
                    line: element.line,
                    found: format!("a line without length at {:?}", ends[0]),
                    expected: "two different points".into(),
                });
                continue;
            }
            let line = Line::new(role, [ends[0], ends[1]], octants);
            if lines.contains(&line) {
                mistakes.push(TilesetError::Obj {
                    path: path.into(),
                    line: element.line,
                    found: format!("a second {} from {:?} to {:?}", line.role.name(), line.from, line.to),
                    expected: "every line once; remove the double".into(),
                });
                continue;
            }
            lines.push(line);
        }
    }
    lines.sort_unstable();
    (lines, mistakes)
}

/// Role and octants of a group name `<role>_o<octant>[_<octant>]`.
fn group(name: &str) -> Option<(LineRole, [u8; 2])> {
    let (role, octants) = name.split_once("_o")?;
    let octant = |text: &str| text.parse::<u8>().ok().filter(|o| *o < 8);
    let octants = match octants.split_once('_') {
        Some((a, b)) => [octant(a)?, octant(b)?],
        None => [octant(octants)?; 2],
    };
    Some((LineRole::from_name(role)?, octants))
}
