//! Commands of `tileset`.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

#[derive(Subcommand)]
pub enum Tileset {
    /// List everything that is wrong with a tileset: coverage, seams, open or turned solids, units and axes, files.
    Check(TilesetCheck),
    /// The thesis's catalogue, what houses need, and the tiles of a set.
    List(TilesetList),
    /// Contact sheet of all tiles and of a few neighbourhoods as PNG.
    Sheet(TilesetSheet),
    /// Scaffold a tileset: manifest, cage, an example for each of the 26 tiles.
    New(TilesetNew),
    /// Write all expanded tiles as OBJ, or with --canonical a shipped set's own files anew.
    Bake(TilesetBake),
}

#[derive(Args)]
pub struct TilesetList {
    /// A folder with tileset.json, or the name of a shipped tileset.
    pub dir: Option<String>,
    /// Folder of the OBJ files of a set of solids when it is not where the manifest says.
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,
}

#[derive(Args)]
pub struct TilesetSheet {
    /// A folder with tileset.json, or the name of a shipped tileset.
    pub dir: String,
    /// Folder of the OBJ files of a set of solids when it is not where the manifest says.
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,
    /// Picture to write.
    #[arg(long, value_name = "PNG")]
    pub out: PathBuf,
    /// Sample houses built with the set instead of its tiles.
    #[arg(long)]
    pub houses: bool,
}

#[derive(Args)]
pub struct TilesetNew {
    /// Folder to make; its name becomes the set's.
    pub dir: PathBuf,
    /// What the tiles are made of.
    #[arg(long, value_enum, default_value_t = NewKind::Surface)]
    pub kind: NewKind,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum NewKind {
    /// Polygons between filled and empty.
    Surface,
    /// Closed bodies of building components.
    Solids,
}

#[derive(Args)]
pub struct TilesetDir {
    /// A folder with tileset.json, or the name of a shipped tileset.
    pub dir: String,
}

#[derive(Args)]
pub struct TilesetCheck {
    /// A folder with tileset.json, or the name of a shipped tileset.
    pub dir: String,
    /// Folder of the OBJ files when it is not where the manifest says.
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,
}

#[derive(Args)]
pub struct TilesetBake {
    /// A folder with tileset.json (a style with its overrides, meshes of solids, surfaces, lines) or the name of a shipped tileset.
    pub name: String,
    /// Folder of the OBJ files of a set of solids when it is not where the manifest says.
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,
    /// Folder to write.
    #[arg(long)]
    pub out: PathBuf,
    /// The canonical tiles of surface-1, surface-2 or linear from their construction rule, as they are shipped.
    #[arg(long, conflicts_with = "families")]
    pub canonical: bool,
    /// Of the architectural set only the 493 configurations of the thesis's catalogue.
    #[arg(long)]
    pub families: bool,
}
