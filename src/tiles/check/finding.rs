//! What a check found.

use super::super::{TilesetError, TilesetKind};
use serde::Serialize;
use std::path::Path;

/// What sort of mistake a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum FindingKind {
    /// The manifest cannot be understood or has a wrong value.
    Manifest,
    /// A manifest of another schema lacks something.
    Foreign,
    /// A file cannot be read.
    File,
    /// A file that no tile names.
    UnusedFile,
    /// Sizes say that the unit is another one.
    Unit,
    /// Shapes say that another axis is up.
    UpAxis,
    /// Places say that the origin is elsewhere.
    Pivot,
    /// Shapes say that the corners are counted in another order.
    CornerOrder,
    /// A line of an OBJ file cannot be understood.
    Obj,
    /// A polygon is no good.
    Polygon,
    /// A surface or solid has an open edge, or a face turned over.
    Open,
    /// A surface or solid faces the wrong way.
    InsideOut,
    /// Solids cut themselves or each other.
    Crossing,
    /// Something lies outside the cube beyond the declared overhang.
    OutOfCube,
    /// A configuration has no tile.
    Missing,
    /// Two tiles claim one configuration.
    Duplicate,
    /// Two tiles, or a tile and the style, differ on the face between them.
    Seam,
}

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// What sort.
    pub kind: FindingKind,
    /// Tiles it is about, the one to mend first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub tiles: Vec<String>,
    /// Key of the manifest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub key: Option<String>,
    /// File.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Line in it, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// Axis across the face between the tiles: the first of `configurations` lies on its low side.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face: Option<String>,
    /// The entry of `open_seams` that would accept the difference.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub open_seam: Option<String>,
    /// The tile on the other side, or empty.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub neighbour: Option<String>,
    /// Configurations concerned.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub configurations: Vec<String>,
    /// Edges that only the first one has on the face.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub only_first: Vec<String>,
    /// Edges that only the second one has.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub only_second: Vec<String>,
    /// All of it as a sentence.
    pub message: String,
}

impl Finding {
    /// A finding with nothing but a sentence.
    pub fn new(kind: FindingKind, message: String) -> Finding {
        Finding {
            kind,
            tiles: Vec::new(),
            key: None,
            file: None,
            line: None,
            face: None,
            open_seam: None,
            neighbour: None,
            configurations: Vec::new(),
            only_first: Vec::new(),
            only_second: Vec::new(),
            message,
        }
    }

    /// The same about a key of the manifest.
    pub fn of_key(self, key: &str) -> Finding {
        Finding { key: Some(key.into()), ..self }
    }

    /// The same about tiles.
    pub fn of_tiles<'a>(self, tiles: impl IntoIterator<Item = &'a str>) -> Finding {
        Finding { tiles: tiles.into_iter().filter(|t| !t.is_empty()).map(str::to_owned).collect(), ..self }
    }
}

/// How much of what can occur has a tile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Coverage {
    /// Configurations that can occur: occupancies in surface and linear sets, labellings in the others.
    pub reachable: usize,
    /// Those with a tile.
    pub covered: usize,
}

/// What a check says.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Name of the set, empty when its manifest cannot be read.
    #[serde(skip)]
    pub name: String,
    /// What it holds.
    #[serde(skip)]
    pub kind: TilesetKind,
    /// How much is there; `None` for a style whose manifest has to be mended before it builds anything.
    pub coverage: Option<Coverage>,
    /// Everything that is wrong.
    pub findings: Vec<Finding>,
    /// What was compared, as a sentence for people.
    #[serde(skip)]
    pub compared: String,
}

impl Report {
    pub(super) fn new(name: &str, kind: TilesetKind) -> Report {
        let findings = Vec::new();
        Report { name: name.into(), kind, coverage: None, findings, compared: String::new() }
    }

    pub(super) fn unreadable(mistake: TilesetError) -> Report {
        let mut report = Report::new("", TilesetKind::Surface);
        report.add(mistake, None);
        report
    }

    /// Whether nothing is wrong.
    pub fn is_clean(&self) -> bool {
        self.findings.is_empty()
    }

    /// Adds a mistake of a tile, or of the manifest.
    pub(super) fn add(&mut self, mistake: TilesetError, tile: Option<&str>) {
        let kind = kind_of(&mistake);
        let mut finding = Finding::new(kind, mistake.to_string()).of_tiles(tile);
        finding.file = Some(mistake.path().display().to_string());
        finding.line = mistake.line();
        match mistake {
            TilesetError::Value { key, .. } | TilesetError::Foreign { key, .. } => {
                if let Some((_, tile)) = key.rsplit_once(" of tile ") {
                    finding.tiles = vec![tile.into()];
                }
                finding.key = Some(key);
            }
            TilesetError::Duplicate { first, second, configuration, .. } => {
                finding.tiles = vec![second, first];
                finding.configurations = vec![configuration];
                finding.key = Some("pattern".into());
            }
            TilesetError::MissingTile { mask, pattern, .. } => {
                finding.configurations = vec![format!("{mask} ({pattern})")];
            }
            _ => {}
        }
        self.findings.push(finding);
    }

    /// Gives findings about the manifest the line where their tile or key stands, and puts causes before consequences.
    pub(super) fn locate(&mut self, manifest: &Path, text: &str) {
        let manifest = manifest.display().to_string();
        let line_of = |needle: &str| {
            let quoted = serde_json::to_string(needle).unwrap_or_default();
            text.lines().position(|l| l.contains(&quoted)).map(|n| n + 1)
        };
        for finding in &mut self.findings {
            let about_it = finding.file.as_ref().is_none_or(|f| *f == manifest);
            let names = finding.tiles.first().map(String::as_str).into_iter().chain(finding.key.as_deref());
            let line = names.filter_map(line_of).next();
            if finding.line.is_none() && about_it && finding.kind != FindingKind::Seam && line.is_some() {
                finding.file = Some(manifest.clone());
                finding.line = line;
            }
        }
        let cause = |f: &Finding| match f.kind {
            // Patterns read in another order are mistakes of the manifest too.
            FindingKind::CornerOrder => 0,
            FindingKind::Manifest | FindingKind::Foreign => 1,
            FindingKind::Unit | FindingKind::UpAxis | FindingKind::Pivot => 2,
            _ => 3,
        };
        self.findings.sort_by_key(cause);
    }
}

fn kind_of(mistake: &TilesetError) -> FindingKind {
    match mistake {
        TilesetError::Read { .. } => FindingKind::File,
        TilesetError::Manifest { .. } | TilesetError::Value { .. } => FindingKind::Manifest,
        TilesetError::MissingTile { .. } => FindingKind::Missing,
        TilesetError::Duplicate { .. } => FindingKind::Duplicate,
        TilesetError::Obj { .. } => FindingKind::Obj,
        TilesetError::Polygon { .. } => FindingKind::Polygon,
        TilesetError::EndsInside { .. } | TilesetError::EdgeTwice { .. } | TilesetError::OpenSolid { .. } => {
            FindingKind::Open
        }
        TilesetError::LeavesCube { .. } => FindingKind::OutOfCube,
        TilesetError::InsideOut { .. } => FindingKind::InsideOut,
        TilesetError::Crossing { .. } => FindingKind::Crossing,
        TilesetError::Foreign { .. } => FindingKind::Foreign,
    }
}
