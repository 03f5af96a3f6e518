//! Which tile stands in which configuration: every tile claims those of its pattern and their symmetric images.

use super::TilesetError;
use super::manifest::{Manifest, TilesetKind};
use super::pattern::Pattern;
use crate::cubes::{Axis, Mask, Symmetry};
use std::path::Path;

/// A tile's claim on the configurations of one pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Claim {
    /// Index of the tile.
    pub tile: usize,
    /// How it is placed.
    pub symmetry: Symmetry,
    /// The configurations.
    pub pattern: Pattern,
}

/// Where the content of a configuration comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Placement {
    /// Index of the tile.
    pub tile: usize,
    /// How it is placed.
    pub symmetry: Symmetry,
}

/// Every claim of every tile, and what is wrong with the tiles' entries. A tile whose pattern has symmetries of its own claims each
/// configuration once, by the first symmetry that leads there.
pub(super) fn claims(
    manifest: &Manifest,
    path: &Path,
    needed: impl Fn(Mask) -> bool,
) -> (Vec<Claim>, Vec<TilesetError>) {
    let (mut claims, mut mistakes) = (Vec::new(), Vec::new());
    for (tile, entry) in manifest.tiles.iter().enumerate() {
        let drawn = match manifest.pattern(entry, path) {
            Ok(drawn) => drawn,
            Err(mistake) => {
                mistakes.push(mistake);
                continue;
            }
        };
        let mut wrong = |key: &str, found: String, expected: &str| {
            let key = format!("{key} of tile {}", entry.name);
            mistakes.push(TilesetError::Value { path: path.into(), key, found, expected: expected.into() });
        };
        if !drawn.masks().any(&needed) && manifest.numbered.is_none() {
            let expected = "an admissible configuration (filled and empty corners each connected along edges)";
            wrong("pattern", format!("\"{}\"", entry.pattern), expected);
        }
        if manifest.tiles[..tile].iter().any(|t| t.name == entry.name) {
            wrong("name", format!("\"{}\"", entry.name), "a name that no other tile has");
        }
        let size = manifest.module_size;
        let turns = entry.symmetry.quarter_turns && size[Axis::X as usize] == size[Axis::Y as usize];
        if entry.symmetry.quarter_turns && !turns {
            let expected = "false, because a module that is not square in plan cannot be turned";
            wrong("symmetry.quarter_turns", "true".into(), expected);
        }
        let first = claims.len();
        for symmetry in Symmetry::all().filter(|s| (entry.symmetry.mirror || !s.mirror) && (turns || s.turns == 0)) {
            let pattern = drawn.placed(symmetry);
            if !claims[first..].iter().any(|c: &Claim| c.pattern == pattern) {
                claims.push(Claim { tile, symmetry, pattern });
            }
        }
    }
    (claims, mistakes)
}

/// Claims of different tiles with equal priority that meet in a configuration a house can have, each pair of tiles once.
pub(super) fn duplicates(manifest: &Manifest, path: &Path, claims: &[Claim]) -> Vec<TilesetError> {
    let mut found: Vec<([usize; 2], TilesetError)> = Vec::new();
    for (n, a) in claims.iter().enumerate() {
        for b in &claims[..n] {
            let [first, second] = [b.tile, a.tile].map(|t| &manifest.tiles[t]);
            if a.tile == b.tile || first.priority != second.priority || found.iter().any(|f| f.0 == [b.tile, a.tile]) {
                continue;
            }
            let Some(configuration) = shared(manifest.kind, &a.pattern, &b.pattern) else { continue };
            let [first, second] = [&first.name, &second.name].map(Clone::clone);
            let duplicate = TilesetError::Duplicate { path: path.into(), configuration, first, second };
            found.push(([b.tile, a.tile], duplicate));
        }
    }
    found.into_iter().map(|(_, e)| e).collect()
}

/// A configuration of both patterns that a house can have.
fn shared(kind: TilesetKind, a: &Pattern, b: &Pattern) -> Option<String> {
    let key = a.common(b)?;
    match kind {
        TilesetKind::Surface | TilesetKind::Linear => {
            let mask = a.masks().find(|m| m.is_allowed() && b.masks().any(|other| other == *m))?;
            Some(mask.to_string())
        }
        TilesetKind::Solids | TilesetKind::Style => {
            let allowed = |p: &Pattern| p.masks().any(Mask::is_allowed);
            (allowed(a) && allowed(b)).then(|| key.to_string())
        }
    }
}

/// For sets that do not look at labels: the placement of each mask, the one of highest priority.
pub(super) fn table(manifest: &Manifest, claims: &[Claim]) -> [Option<Placement>; 256] {
    let mut table: [Option<Placement>; 256] = [None; 256];
    let priority = |tile: usize| manifest.tiles[tile].priority;
    for claim in claims {
        for mask in claim.pattern.masks() {
            let slot = &mut table[mask.0 as usize];
            if slot.is_none_or(|other| priority(claim.tile) > priority(other.tile)) {
                *slot = Some(Placement { tile: claim.tile, symmetry: claim.symmetry });
            }
        }
    }
    table
}

/// The configurations without a tile.
pub(super) fn missing(
    table: &[Option<Placement>; 256],
    path: &Path,
    needed: impl Fn(Mask) -> bool,
) -> Vec<TilesetError> {
    Mask::all()
        .filter(|&m| needed(m) && table[m.0 as usize].is_none())
        .map(|m| TilesetError::MissingTile { path: path.into(), mask: m.0, pattern: m.pattern() })
        .collect()
}

/// Which tile covers which configuration; every configuration for which `needed` holds must be covered, once.
pub(super) fn placements(
    manifest: &Manifest,
    path: &Path,
    needed: impl Fn(Mask) -> bool,
) -> Result<[Option<Placement>; 256], TilesetError> {
    let (claims, mistakes) = claims(manifest, path, &needed);
    let table = table(manifest, &claims);
    let all = mistakes.into_iter().chain(duplicates(manifest, path, &claims)).chain(missing(&table, path, needed));
    all.into_iter().next().map_or(Ok(table), Err)
}
