//! Linear tilesets: loaded once, expanded to every configuration and the full cube, looked up by mask.

use super::manifest::{Manifest, TilesetKind};
use super::obj::{Element, read_obj};
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
        // Inside a house the full cube carries the slab grid, so it needs a tile too.
        let placements = manifest.placements(&path, |m| m.is_admissible() || m == Mask::FULL)?;
        let size = manifest.module_mm();
        let mut contents = Vec::with_capacity(manifest.tiles.len());
        for entry in &manifest.tiles {
            let path = dir.join(&entry.file);
            let elements = read_obj(&read(&path)?, &path, manifest.to_mm())?;
            contents.push(lines_of(&elements, size, &path)?);
        }
        let mut set = LinearTileset::empty(&manifest.name, size);
        for (mask, placement) in placements.iter().enumerate() {
            if let Some(p) = placement {
                set.names[mask] = manifest.tiles[p.tile].name.clone();
                set.lines[mask] = contents[p.tile].iter().map(|l| l.placed(p.symmetry, size)).collect();
                set.lines[mask].sort_unstable();
            }
        }
        Ok(set)
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

fn lines_of(elements: &[Element], size: [i32; 3], path: &Path) -> Result<Vec<Line>, TilesetError> {
    let mut lines = Vec::new();
    for element in elements {
        let Some((role, octants)) = group(&element.group).filter(|_| !element.is_polygon) else {
            return Err(TilesetError::Obj {
                path: path.into(),
                line: element.line,
                found: if element.is_polygon { "a polygon".into() } else { format!("the group '{}'", element.group) },
                expected: format!(
                    "a line element in a group named by one of {} followed by _o and one or two octants 0 to 7, for example \
                     edge_o0_1",
                    LineRole::ALL.map(LineRole::name).join(", ")
                ),
            });
        };
        for (point, &line) in element.points.iter().zip(&element.point_lines) {
            let beyond = (0..3).map(|a| (-point[a]).max(point[a] - size[a])).max().unwrap_or(0);
            if beyond > 0 {
                let layer = "lines".into();
                let path = path.into();
                return Err(TilesetError::LeavesCube { path, line, vertex: *point, beyond, layer, overhang: 0 });
            }
        }
        for ends in element.points.windows(2) {
            if ends[0] == ends[1] {
                return Err(TilesetError::Obj {
                    path: path.into(),
                    line: element.line,
                    found: format!("a line without length at {:?}", ends[0]),
                    expected: "two different points".into(),
                });
            }
            lines.push(Line::new(role, [ends[0], ends[1]], octants));
        }
    }
    lines.sort_unstable();
    if let Some(pair) = lines.windows(2).find(|p| p[0] == p[1]) {
        let double = elements
            .iter()
            .rev()
            .find(|e| e.points.windows(2).any(|w| Line::new(pair[0].role, [w[0], w[1]], pair[0].octants) == pair[0]));
        return Err(TilesetError::Obj {
            path: path.into(),
            line: double.map_or(1, |e| e.line),
            found: format!("a second {} from {:?} to {:?}", pair[0].role.name(), pair[0].from, pair[0].to),
            expected: "every line once; remove the double".into(),
        });
    }
    Ok(lines)
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
