//! Where the files of a set come from: a folder on disk, or texts in memory.

use super::super::MANIFEST_FILE;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The files of a tileset.
#[derive(Clone, Debug)]
pub struct Folder {
    dir: PathBuf,
    root: Option<PathBuf>,
    memory: Option<BTreeMap<String, String>>,
}

impl Folder {
    /// A folder on disk; `root` holds the OBJ files when they are not where the manifest says.
    pub fn open(dir: &Path, root: Option<&Path>) -> Folder {
        Folder { dir: dir.into(), root: root.map(Path::to_path_buf), memory: None }
    }

    /// Texts by file name, as if they lay in one folder.
    pub fn in_memory(files: BTreeMap<String, String>) -> Folder {
        Folder { dir: "set".into(), root: None, memory: Some(files) }
    }

    /// The manifest's path.
    pub(super) fn manifest_path(&self) -> PathBuf {
        self.dir.join(MANIFEST_FILE)
    }

    /// The folder of the manifest.
    pub(super) fn dir(&self) -> &Path {
        &self.dir
    }

    /// The folder given instead of the manifest's.
    pub(super) fn root(&self) -> Option<&Path> {
        self.root.as_deref()
    }

    /// The text of a file.
    pub(super) fn read(&self, path: &Path) -> std::io::Result<String> {
        let Some(files) = &self.memory else { return std::fs::read_to_string(path) };
        let name = path.strip_prefix(&self.dir).unwrap_or(path).to_string_lossy();
        files.get(name.as_ref()).cloned().ok_or_else(|| std::io::ErrorKind::NotFound.into())
    }

    /// Names of the OBJ files in a folder, sorted.
    pub(super) fn obj_files(&self, folder: &Path) -> Vec<String> {
        let is_obj = |name: &String| name.to_lowercase().ends_with(".obj");
        let mut names: Vec<String> = match &self.memory {
            Some(files) => files.keys().filter(|n| is_obj(n)).cloned().collect(),
            None => {
                let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
                entries.map(|e| e.file_name().to_string_lossy().into_owned()).filter(is_obj).collect()
            }
        };
        names.sort();
        names
    }
}
