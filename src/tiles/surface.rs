//! Surface tilesets: loaded once, expanded to every configuration, looked up by mask.

use super::claims::{Placement, placements};
use super::entry::TileEntry;
use super::manifest::{Manifest, TilesetKind};
use super::obj::{Grid, read_obj};
use super::validate::{Content, surface_content};
use super::{Facet, Patch, PatchClass, TilesetError};
use crate::cubes::{Mask, Symmetry};
use std::path::Path;

/// Name of the manifest in a tileset's folder.
pub const MANIFEST_FILE: &str = "tileset.json";

/// A closed body of a solid layer, cube-local mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// Layer of the manifest.
    pub layer: String,
    /// The octant (0..8) whose label it takes.
    pub octant: u8,
    /// Its polygons, counter-clockwise from outside.
    pub polygons: Vec<Vec<[i32; 3]>>,
}

impl Solid {
    fn placed(&self, symmetry: Symmetry, size: [i32; 3]) -> Solid {
        let (octant, polygons) = super::bodies::turned(self.octant, &self.polygons, symmetry, size);
        Solid { layer: self.layer.clone(), octant, polygons }
    }
}

/// The area that one octant contributes in one class: all that areas of a house are summed from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaTerm {
    /// The octant (0..8) whose label decides the surface.
    pub octant: u8,
    /// Kind and direction.
    pub class: PatchClass,
    /// m2.
    pub area_m2: f64,
}

/// What stands in a cube of one configuration.
#[derive(Clone, Debug, Default, PartialEq)]
struct Tile {
    name: String,
    patches: Vec<Patch>,
    solids: Vec<Solid>,
    terms: Vec<AreaTerm>,
    volume: VolumeTerm,
}

/// A tile's part in the enclosed volume, as exact integers: by the divergence theorem the volume is the integral of z n_z over the
/// surface, so a tile at height z0 adds z0 times its projected area and the integral over its own z.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VolumeTerm {
    /// Twice the area projected on the plan, upwards positive, mm2.
    pub doubled_plan_mm2: i64,
    /// Six times the integral of z n_z with z from the cube's bottom, mm3.
    pub moment_mm3: i64,
}

/// Reads the OBJ text of a surface tile, and lists what is wrong with it.
pub(super) fn read_surface(
    text: &str,
    manifest: &Manifest,
    entry: &TileEntry,
    path: &Path,
) -> (Content, Vec<TilesetError>) {
    let drawing = read_obj(text, path, &manifest.axes(entry), Grid::Millimetre);
    let (content, more) = surface_content(&drawing.elements, manifest, path);
    (content, drawing.mistakes.into_iter().chain(more).collect())
}

/// A surface tileset in memory: one table entry per mask.
#[derive(Clone, Debug, PartialEq)]
pub struct Tileset {
    name: String,
    module_mm: [i32; 3],
    tiles: Vec<Tile>,
}

impl Tileset {
    /// Loads the folder `dir`: its `tileset.json` and the OBJ files named there.
    pub fn load(dir: &Path) -> Result<Tileset, TilesetError> {
        Tileset::read(dir, |path| std::fs::read_to_string(path))
    }

    /// The same with the files' texts given by `read`, so that tests need no disk.
    pub fn read(dir: &Path, read: impl Fn(&Path) -> std::io::Result<String>) -> Result<Tileset, TilesetError> {
        let read = |path: &Path| read(path).map_err(|source| TilesetError::Read { path: path.into(), source });
        let path = dir.join(MANIFEST_FILE);
        let manifest = Manifest::parse(&read(&path)?, &path, TilesetKind::Surface)?;
        let placements = placements(&manifest, &path, Mask::is_admissible)?;
        let folder = manifest.folder(dir);
        let mut contents = Vec::with_capacity(manifest.tiles.len());
        for entry in &manifest.tiles {
            let path = folder.join(entry.files().next().map_or("", String::as_str));
            let (content, mistakes) = read_surface(&read(&path)?, &manifest, entry, &path);
            if let Some(mistake) = mistakes.into_iter().next() {
                return Err(mistake);
            }
            contents.push(content);
        }
        let (set, mistakes) = Tileset::assemble(&manifest, &folder, &contents, &placements);
        mistakes.into_iter().next().map_or(Ok(set), Err)
    }

    /// The set of the contents of a manifest's tiles, and facets that hang on an empty octant.
    pub(super) fn assemble(
        manifest: &Manifest,
        folder: &Path,
        contents: &[Content],
        placements: &[Option<Placement>; 256],
    ) -> (Tileset, Vec<TilesetError>) {
        let size = manifest.module_mm();
        let mut set = Tileset::empty(&manifest.name, size);
        let mut mistakes = Vec::new();
        for (mask, placement) in placements.iter().enumerate() {
            if let Some(p) = placement {
                let (content, entry) = (&contents[p.tile], &manifest.tiles[p.tile]);
                let facets = content.facets.iter().map(|f| f.placed(p.symmetry, size));
                set.fill(mask, &entry.name, facets);
                if let Some(patch) = set.tiles[mask].patches.iter().find(|patch| mask >> patch.octant & 1 == 0) {
                    mistakes.push(TilesetError::Value {
                        path: folder.join(&entry.file),
                        key: format!("group of a {} of tile {}", patch.kind.name(), entry.name),
                        found: format!("octant {} of configuration {mask}, which is empty", patch.octant),
                        expected: "a filled octant, because its label says what the surface is made of".into(),
                    });
                }
                set.tiles[mask].solids = content.solids.iter().map(|s| s.placed(p.symmetry, size)).collect();
            }
        }
        (set, mistakes)
    }

    /// A tileset from a function that gives the facets of each admissible mask: styles in memory. Facets that cannot be cut into
    /// triangles are dropped, which `check_tileset` then reports as an open seam.
    pub fn from_facets(name: &str, module_mm: [i32; 3], facets: impl Fn(Mask) -> Vec<Facet>) -> Tileset {
        let mut set = Tileset::empty(name, module_mm);
        for mask in crate::cubes::admissible_masks() {
            set.fill(mask.0 as usize, &format!("{name} {}", mask.0), facets(mask).into_iter());
        }
        set
    }

    fn empty(name: &str, module_mm: [i32; 3]) -> Tileset {
        Tileset { name: name.into(), module_mm, tiles: vec![Tile::default(); 256] }
    }

    fn fill(&mut self, mask: usize, name: &str, facets: impl Iterator<Item = Facet>) {
        let patches: Vec<Patch> = facets.filter_map(Patch::new).collect();
        let mut terms: Vec<AreaTerm> = Vec::new();
        let mut volume = VolumeTerm::default();
        for patch in &patches {
            let area_m2 = patch.area_m2([1.0; 3]);
            match terms.iter_mut().find(|t| t.octant == patch.octant && t.class == patch.class) {
                Some(term) => term.area_m2 += area_m2,
                None => terms.push(AreaTerm { octant: patch.octant, class: patch.class, area_m2 }),
            }
            volume.doubled_plan_mm2 += patch.doubled_area_mm2[2];
            volume.moment_mm3 += patch.moment_mm3;
        }
        self.tiles[mask] = Tile { name: name.into(), patches, solids: Vec::new(), terms, volume };
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
        &self.tiles[mask.0 as usize].name
    }

    /// The pieces of surface in a cube; none in an empty, full or inadmissible one.
    #[inline]
    pub fn patches(&self, mask: Mask) -> &[Patch] {
        &self.tiles[mask.0 as usize].patches
    }

    /// The bodies of the solid layers in a cube.
    #[inline]
    pub fn solids(&self, mask: Mask) -> &[Solid] {
        &self.tiles[mask.0 as usize].solids
    }

    /// The areas of a cube by octant and class, each pair once.
    #[inline]
    pub fn area_terms(&self, mask: Mask) -> &[AreaTerm] {
        &self.tiles[mask.0 as usize].terms
    }

    /// The part of a cube in the enclosed volume.
    #[inline]
    pub fn volume_term(&self, mask: Mask) -> VolumeTerm {
        self.tiles[mask.0 as usize].volume
    }
}
