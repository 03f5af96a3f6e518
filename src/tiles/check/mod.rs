//! `tileset check`: everything that is wrong with a tileset folder, not the first thing only.
//!
//! A set is read leniently: what can be understood is checked on, what cannot becomes a finding, so that one look shows all that a
//! designer has to mend. [`check`] never fails.

mod conventions;
mod finding;
mod folder;
mod labels;
mod meshes;
mod overrides;

pub use finding::{Coverage, Finding, FindingKind, Report};
pub use folder::Folder;
pub use overrides::{compare_sections, sections};

use super::foreign;
use super::manifest::{Manifest, TilesetKind};
use super::style_manifest::StyleManifest;
use super::{Block, TilesetError};
use crate::cubes::CubeKey;
use meshes::Sheets;

/// The file of a scaffold that shows the cube to draw in; it is no tile.
pub const CAGE_FILE: &str = "cage.obj";

/// The blocks that a style makes for a cube, to compare overrides with.
pub type Construction<'a> = &'a dyn Fn(CubeKey) -> Vec<Block>;

/// Checks the tileset of a folder. `construction` is the style's own construction, for the seams of overrides; without it those are
/// compared with each other only.
pub fn check(folder: &Folder, construction: Option<Construction>) -> Report {
    let path = folder.manifest_path();
    let text = match folder.read(&path) {
        Ok(text) => text,
        Err(source) => return Report::unreadable(TilesetError::Read { path, source }),
    };
    let is_style = serde_json::from_str::<serde_json::Value>(&text).is_ok_and(|json| json["kind"] == "style");
    let examined = if is_style {
        StyleManifest::examine(&text, &path).map(|(style, mistakes)| (style.meshes(), mistakes))
    } else if let Some(converted) = foreign::convert(&text, &path) {
        Ok(converted)
    } else {
        Manifest::examine(&text, &path)
    };
    let (manifest, mistakes) = match examined {
        Ok(examined) => examined,
        Err(mistake) => return Report::unreadable(mistake),
    };
    let mut report = Report::new(&manifest.name, if is_style { TilesetKind::Style } else { manifest.kind });
    mistakes.into_iter().for_each(|m| report.add(m, None));
    let sheets = Sheets::read(folder, &manifest, &mut report);
    conventions::check(&manifest, &sheets, &mut report);
    match report.kind {
        TilesetKind::Surface => meshes::check_surface(&manifest, &sheets, &mut report),
        TilesetKind::Linear => meshes::check_lines(&manifest, &sheets, &mut report),
        TilesetKind::Solids => labels::check(&manifest, &sheets, &mut report),
        TilesetKind::Style => overrides::check(&manifest, &sheets, construction, &mut report),
    }
    sheets.unused(folder, &manifest, &mut report);
    report.locate(&path, &text);
    report
}
