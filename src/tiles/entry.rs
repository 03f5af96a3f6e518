//! One tile of a manifest: its files, the configurations they are drawn for, and sets whose files are numbered instead.

use super::Pivot;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which symmetries may carry a tile to other configurations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TileSymmetry {
    /// Mirrored in x.
    pub mirror: bool,
    /// Turned about z.
    pub quarter_turns: bool,
}

/// One tile: its files and the configurations it is drawn for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TileEntry {
    /// Name, unique in the set.
    pub name: String,
    /// Eight entries in the manifest's corner order, first corner first: a digit, a set of digits in brackets, `*` for any filled
    /// label or `.` for any label. In surface and linear sets 1 means filled, in the others digits are codes of `labels`.
    pub pattern: String,
    /// What may be made of it; nothing when left out.
    #[serde(default)]
    pub symmetry: TileSymmetry,
    /// OBJ file beside the manifest.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub file: String,
    /// Further OBJ files for the same configurations; the position of a cube decides which one stands there.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub variants: Vec<String>,
    /// Of two tiles for one configuration the one with the higher priority is taken; equal priorities are an error.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub priority: i32,
    /// Origin of this tile's files when it differs from the manifest's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pivot: Option<Pivot>,
}

fn is_zero(priority: &i32) -> bool {
    *priority == 0
}

impl TileEntry {
    /// All its files, the first one first.
    pub fn files(&self) -> impl Iterator<Item = &String> {
        Some(&self.file).filter(|f| !f.is_empty()).into_iter().chain(&self.variants)
    }
}

/// Files named by the number of their configuration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Numbered {
    /// `topogenesis`: the number is the sum of 2^j over the filled corners j, in the manifest's corner order.
    #[schemars(extend("enum" = ["topogenesis"]))]
    pub scheme: String,
    /// File name with `#` for each digit of the number, for example `Tile_###.obj`.
    pub files: String,
}

/// One tile for each filled configuration of topoGenesis's numbering.
pub(super) fn numbered_tiles(numbered: &Numbered) -> Vec<TileEntry> {
    let width = numbered.files.matches('#').count();
    let hashes = "#".repeat(width);
    (1..=255u32)
        .map(|id| {
            let file = numbered.files.replacen(&hashes, &format!("{id:0width$}"), 1);
            TileEntry {
                name: file.rsplit_once('.').map_or(file.as_str(), |(stem, _)| stem).to_owned(),
                pattern: (0..8).map(|n| if id >> n & 1 == 1 { '*' } else { '0' }).collect(),
                symmetry: TileSymmetry::default(),
                file,
                variants: Vec::new(),
                priority: 0,
                pivot: None,
            }
        })
        .collect()
}
