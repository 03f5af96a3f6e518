//! Where the shipped tilesets and configs are.

use std::path::{Path, PathBuf};

use super::failure::{Failure, bad_input};

/// The folder that holds `tilesets/` and `configs/`: `$HOUSCAPER_HOME`, else the first folder upwards of `near`, of the working
/// folder, of the program or of the checkout it was built from that has both.
pub fn find(near: Option<&Path>) -> Option<PathBuf> {
    if let Some(home) = std::env::var_os("HOUSCAPER_HOME") {
        return Some(PathBuf::from(home));
    }
    let near = near.and_then(|p| p.canonicalize().ok());
    let built = Some(PathBuf::from(env!("CARGO_MANIFEST_DIR")));
    [near, std::env::current_dir().ok(), std::env::current_exe().ok(), built].into_iter().flatten().find_map(|start| {
        start.ancestors().find(|f| f.join("tilesets").is_dir() && f.join("configs").is_dir()).map(Path::to_path_buf)
    })
}

/// Refuses a `$HOUSCAPER_HOME` that is not such a folder, before anything is looked for in it.
pub fn check() -> Result<(), Failure> {
    let Some(home) = std::env::var_os("HOUSCAPER_HOME").map(PathBuf::from) else { return Ok(()) };
    if home.join("tilesets").is_dir() && home.join("configs").is_dir() {
        return Ok(());
    }
    Err(bad_input(format!(
        "HOUSCAPER_HOME is {}, which does not hold the folders tilesets and configs; correct the variable or unset it",
        home.display()
    )))
}

/// The folder of a tileset: a path if it is one, else a name under `tilesets/`.
pub fn tileset(name: &str, home: Option<&Path>) -> PathBuf {
    let path = PathBuf::from(name);
    if path.join("tileset.json").is_file() {
        return path;
    }
    home.map_or(path, |h| h.join("tilesets").join(name))
}
