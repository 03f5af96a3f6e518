//! Sets of solids: meshes of building components, looked up by the labels of a cube.

use super::axes::Axes;
use super::bodies::{Body, bodies};
use super::claims::{Claim, claims, duplicates};
use super::entry::TileEntry;
use super::foreign;
use super::manifest::{Manifest, TilesetKind};
use super::materials::Materials;
use super::obj::{Grid, read_obj};
use super::pattern::Pattern;
use super::surface::MANIFEST_FILE;
use super::{Layer, Look, TilesetError};
use crate::cubes::{CornerOrder, CubeKey, Mask, Symmetry, ThesisId, cube_labels, cube_shape, needs_tile};
use crate::voxels::{Label, VoxelArray};
use std::path::Path;

/// A tile as it stands in a cube.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedTile {
    /// Name in the manifest.
    pub name: String,
    /// Which of its files, from 0.
    pub variant: usize,
    /// How it was carried there.
    pub symmetry: Symmetry,
    /// Its bodies.
    pub bodies: Vec<Body>,
}

/// A cube of a house for which a set has no tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MissingCube {
    /// Its place in the padded array.
    pub cube: [usize; 3],
    /// Its labels in corner order.
    pub labels: [Label; 8],
    /// The same as one number, first corner most significant, in `f_order`.
    pub thesis_id: ThesisId,
}

/// A claim with its placed variants.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Candidate {
    pub tile: usize,
    pub priority: i32,
    pub pattern: Pattern,
    /// First of its variants in `placed`, and how many there are.
    pub placed: [usize; 2],
}

/// A set of solids in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelSet {
    name: String,
    module_um: [i32; 3],
    layers: Vec<Layer>,
    looks: Vec<Option<Look>>,
    placed: Vec<PlacedTile>,
    /// For each mask the candidates that can have it, highest priority first.
    by_mask: Vec<Vec<Candidate>>,
}

/// The solids of one file, and what is wrong with it.
pub(super) fn read_solids(
    text: &str,
    manifest: &Manifest,
    axes: &Axes,
    drawn: Mask,
    path: &Path,
) -> (Vec<Body>, Vec<TilesetError>) {
    let drawing = read_obj(text, path, axes, Grid::Micrometre);
    let (bodies, more) = bodies(&drawing.elements, manifest, drawn, path);
    (bodies, drawing.mistakes.into_iter().chain(more).collect())
}

/// The corners that a tile's pattern fills (the first possibility).
pub(super) fn drawn_mask(manifest: &Manifest, entry: &TileEntry, path: &Path) -> Mask {
    let pattern = manifest.pattern(entry, path).ok();
    pattern.and_then(|p| p.masks().last()).unwrap_or(Mask::FULL)
}

impl LabelSet {
    /// Loads the folder `dir`: its `tileset.json` and the OBJ files named there.
    pub fn load(dir: &Path) -> Result<LabelSet, TilesetError> {
        LabelSet::load_from(dir, None)
    }

    /// The same with the OBJ files in `root` instead of the manifest's own folder.
    pub fn load_from(dir: &Path, root: Option<&Path>) -> Result<LabelSet, TilesetError> {
        LabelSet::read(dir, root, |path| std::fs::read_to_string(path))
    }

    /// The same with the files' texts given by `read`, so that tests need no disk.
    pub fn read(
        dir: &Path,
        root: Option<&Path>,
        read: impl Fn(&Path) -> std::io::Result<String>,
    ) -> Result<LabelSet, TilesetError> {
        let read = |path: &Path| read(path).map_err(|source| TilesetError::Read { path: path.into(), source });
        let path = dir.join(MANIFEST_FILE);
        let text = read(&path)?;
        let manifest = match foreign::convert(&text, &path) {
            Some((manifest, mistakes)) => mistakes.into_iter().next().map_or(Ok(manifest), Err)?,
            None => Manifest::parse(&text, &path, TilesetKind::Solids)?,
        };
        let folder = root.map_or_else(|| manifest.folder(dir), Path::to_path_buf);
        LabelSet::of_manifest(&manifest, &path, |file| {
            let path = folder.join(file);
            read(&path).map(|text| (text, path))
        })
    }

    /// The set of a manifest whose files `read` gives with their paths.
    pub(super) fn of_manifest(
        manifest: &Manifest,
        path: &Path,
        read: impl Fn(&str) -> Result<(String, std::path::PathBuf), TilesetError>,
    ) -> Result<LabelSet, TilesetError> {
        let (claims, mistakes) = claims(manifest, path, |m| m.is_allowed() && m != Mask::EMPTY);
        let wrong = mistakes.into_iter().chain(duplicates(manifest, path, &claims)).next();
        wrong.map_or(Ok(()), Err)?;
        let mut contents = Vec::with_capacity(manifest.tiles.len());
        let mut materials = Materials::default();
        for entry in &manifest.tiles {
            let mut variants = Vec::new();
            for file in entry.files() {
                let (text, file) = read(file)?;
                let drawn = drawn_mask(manifest, entry, path);
                let (bodies, mistakes) = read_solids(&text, manifest, &manifest.axes(entry), drawn, &file);
                mistakes.into_iter().next().map_or(Ok(()), Err)?;
                // A library that is not there leaves layers in their usual colours.
                materials.tally(&text, &manifest.layers, |library| Some(read(library).ok()?.0));
                variants.push(bodies);
            }
            contents.push(variants);
        }
        let looks = materials.looks(manifest.layers.len());
        Ok(LabelSet { looks, ..LabelSet::assemble(manifest, &claims, &contents) })
    }

    /// The set of the contents (tile, variant, bodies) of a manifest.
    pub(super) fn assemble(manifest: &Manifest, claims: &[Claim], contents: &[Vec<Vec<Body>>]) -> LabelSet {
        let module_um = manifest.module_mm().map(|mm| mm * 1000);
        let mut placed = Vec::new();
        let mut by_mask = vec![Vec::new(); 256];
        for claim in claims {
            let entry = &manifest.tiles[claim.tile];
            let first = placed.len();
            for (variant, bodies) in contents[claim.tile].iter().enumerate() {
                let bodies = bodies.iter().map(|b| b.placed(claim.symmetry, module_um)).collect();
                placed.push(PlacedTile { name: entry.name.clone(), variant, symmetry: claim.symmetry, bodies });
            }
            let candidate = Candidate {
                tile: claim.tile,
                priority: entry.priority,
                pattern: claim.pattern,
                placed: [first, placed.len() - first],
            };
            // A tile whose files cannot be read leaves its configurations to be reported as missing.
            if candidate.placed[1] > 0 {
                claim.pattern.masks().for_each(|m| by_mask[m.0 as usize].push(candidate.clone()));
            }
        }
        by_mask.iter_mut().for_each(|c| c.sort_by_key(|c| (std::cmp::Reverse(c.priority), c.tile)));
        let (layers, looks) = (manifest.layers.clone(), vec![None; manifest.layers.len()]);
        LabelSet { name: manifest.name.clone(), module_um, layers, looks, placed, by_mask }
    }

    /// Name in the manifest.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Edges of a cube, µm.
    pub fn module_um(&self) -> [i32; 3] {
        self.module_um
    }

    /// The layers as declared.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// The look of each layer that its files' material libraries give.
    pub fn looks(&self) -> &[Option<Look>] {
        &self.looks
    }

    /// Whether a full cube is wanted by this set even where nothing of a style would stand: it draws one.
    pub fn draws_full(&self) -> bool {
        !self.by_mask[255].is_empty()
    }

    /// All tiles in all their placements and variants.
    pub fn placed_tiles(&self) -> &[PlacedTile] {
        &self.placed
    }

    /// The patterns of all claims.
    pub(super) fn patterns(&self) -> impl Iterator<Item = Pattern> + '_ {
        self.by_mask.iter().flatten().map(|c| c.pattern)
    }

    /// First and number of the placed variants for a cube; face numbers and walked decks of the key are not looked at.
    pub(super) fn variants(&self, key: CubeKey) -> Option<[usize; 2]> {
        let candidates = &self.by_mask[key.mask().0 as usize];
        candidates.iter().find(|c| c.pattern.matches(key)).map(|c| c.placed)
    }

    /// The tiles for a cube's labels, one for each variant; none where the set has none.
    pub fn tiles(&self, key: CubeKey) -> &[PlacedTile] {
        self.variants(key).map_or(&[], |[first, count]| &self.placed[first..first + count])
    }

    /// The tile for a cube's labels, in its first variant; `None` where the set has none.
    pub fn tile(&self, key: CubeKey) -> Option<&PlacedTile> {
        self.variants(key).map(|[first, _]| &self.placed[first])
    }

    /// The tile for a cube at a place of the padded array: its variant is chosen by the place alone.
    pub fn tile_at(&self, key: CubeKey, cube: [usize; 3]) -> Option<&PlacedTile> {
        self.number_at(key, cube).map(|n| &self.placed[n])
    }

    /// The same as a place in [`LabelSet::placed_tiles`].
    pub fn number_at(&self, key: CubeKey, cube: [usize; 3]) -> Option<usize> {
        self.variants(key).map(|[first, count]| first + place_hash(cube) as usize % count)
    }

    /// Whether a configuration must have a tile: admissible ones, and full cubes as soon as the set draws one of them.
    pub fn needs(&self, mask: Mask) -> bool {
        mask.is_allowed() && mask != Mask::EMPTY && (mask != Mask::FULL || !self.by_mask[255].is_empty())
    }

    /// The cubes of a house that would stay empty for want of a tile, x fastest.
    pub fn missing_in(&self, voxels: &VoxelArray) -> Vec<MissingCube> {
        let [nx, ny, nz] = cube_shape(voxels);
        let mut missing = Vec::new();
        for cube in (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k]))) {
            let labels = cube_labels(voxels, cube);
            let key = CubeKey::of_labels(labels);
            let mask = key.mask();
            // Cubes that break the rule of connected corners are listed too: nothing of a house goes missing silently.
            let wanted = mask != Mask::EMPTY && (mask != Mask::FULL || (self.needs(mask) && needs_tile(&labels)));
            if wanted && self.tile(key).is_none() {
                missing.push(MissingCube { cube, labels, thesis_id: ThesisId::new(&labels, CornerOrder::FOrder) });
            }
        }
        missing
    }
}

/// A number from a place that looks random along every axis and is the same on every machine (splitmix64's finaliser).
fn place_hash([i, j, k]: [usize; 3]) -> u64 {
    let mut h = (i as u64) | (j as u64) << 21 | (k as u64) << 42;
    h = (h ^ (h >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    h = (h ^ (h >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    h ^ (h >> 31)
}
