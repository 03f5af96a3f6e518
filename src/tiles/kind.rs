//! Which kind of set a folder holds, read before the rest of its manifest.

use std::path::Path;

use serde::Deserialize;

use super::surface::MANIFEST_FILE;
use super::{FOREIGN_SCHEMA, TilesetError, TilesetKind};

/// The kind that the manifest in `dir` declares; manifests of [`FOREIGN_SCHEMA`] declare none and are solids.
///
/// # Errors
/// A manifest that cannot be read, is no JSON, or names no known kind.
pub fn kind_of(dir: &Path) -> Result<TilesetKind, TilesetError> {
    #[derive(Deserialize)]
    struct Head {
        kind: TilesetKind,
    }
    #[derive(Deserialize)]
    struct Foreign {
        schema: String,
    }
    let path = dir.join(MANIFEST_FILE);
    let text = std::fs::read_to_string(&path).map_err(|source| TilesetError::Read { path: path.clone(), source })?;
    if serde_json::from_str::<Foreign>(&text).is_ok_and(|head| head.schema == FOREIGN_SCHEMA) {
        return Ok(TilesetKind::Solids);
    }
    let head: Head = serde_json::from_str(&text).map_err(|source| TilesetError::Manifest { path, source })?;
    Ok(head.kind)
}
