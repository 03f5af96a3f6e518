//! A run folder: every file appears whole or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Component, Path, PathBuf};

/// The file that marks a folder as a run of ours. It exists from the first moment.
const MARK: &str = "run.json";

/// Why a run folder could not be used.
#[derive(Debug, thiserror::Error)]
pub enum FolderError {
    /// Something else lives there.
    #[error("{folder}: holds files but no {MARK}, so it is not a houscaper run; nothing was written. Choose another --out or empty it", folder = .folder.display())]
    NotARun {
        /// The folder.
        folder: PathBuf,
    },
    /// A run is there already.
    #[error("{folder}: holds a run already; nothing was written. Choose another --out, or remove that run first", folder = .folder.display())]
    RunExists {
        /// The folder.
        folder: PathBuf,
    },
    /// No run is there.
    #[error("{folder}: is not a run folder (no {MARK}); expected the --out of `houscaper optimize`", folder = .folder.display())]
    NoRun {
        /// The folder.
        folder: PathBuf,
    },
    /// Another process has its journal open.
    #[error("{folder}: another process is writing to this run; wait for it or stop it", folder = .folder.display())]
    InUse {
        /// The folder.
        folder: PathBuf,
    },
    /// The file is no journal.
    #[error("{path}: is not a journal of a run (or of a version that this one cannot read)", path = .path.display())]
    NoJournal {
        /// The file.
        path: PathBuf,
    },
    /// A file name that would leave the folder.
    #[error("'{path}' is not a path inside a run folder: expected names joined by '/', without '..', '.' or a root")]
    Outside {
        /// The path as given.
        path: String,
    },
    /// The disk refused.
    #[error("{path}: {source}", path = .path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

/// A folder that one run writes to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunFolder {
    root: PathBuf,
}

impl RunFolder {
    /// Makes a new run folder with `mark` as its `run.json`. The folder may exist if it is empty.
    ///
    /// # Errors
    /// When the folder holds a run or anything else (nothing is written then), or the disk refuses.
    pub fn create(root: &Path, mark: &[u8]) -> Result<RunFolder, FolderError> {
        if root.join(MARK).is_file() {
            return Err(FolderError::RunExists { folder: root.to_owned() });
        }
        if root.is_file() || is_used(root)? {
            return Err(FolderError::NotARun { folder: root.to_owned() });
        }
        fs::create_dir_all(root).map_err(at(root))?;
        let folder = RunFolder { root: root.to_owned() };
        folder.write(MARK, mark)?;
        Ok(folder)
    }

    /// Opens the folder of an earlier run, to resume or report it. Temporary files of a killed run are removed.
    ///
    /// # Errors
    /// When there is no run, or the disk refuses.
    pub fn open(root: &Path) -> Result<RunFolder, FolderError> {
        if !root.join(MARK).is_file() {
            return Err(FolderError::NoRun { folder: root.to_owned() });
        }
        sweep(root)?;
        Ok(RunFolder { root: root.to_owned() })
    }

    /// Opens the folder of a run that may still be going on: its temporary files stay.
    ///
    /// # Errors
    /// When there is no run.
    pub fn look(root: &Path) -> Result<RunFolder, FolderError> {
        match root.join(MARK).is_file() {
            true => Ok(RunFolder { root: root.to_owned() }),
            false => Err(FolderError::NoRun { folder: root.to_owned() }),
        }
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The place of a file of the run, e.g. `front/12/house.glb`.
    ///
    /// # Errors
    /// When the path would leave the folder.
    pub fn path(&self, name: &str) -> Result<PathBuf, FolderError> {
        let inside = Path::new(name).components().all(|c| matches!(c, Component::Normal(_)));
        let plain = !name.is_empty()
            && !name.contains(['\\', ':', '\0'])
            && !name.split('/').any(|p| matches!(p, "" | "." | ".."));
        if inside && plain { Ok(self.root.join(name)) } else { Err(FolderError::Outside { path: name.to_owned() }) }
    }

    /// Writes a file whole: into a temporary file beside it, flushed to the disk, then renamed over the old one.
    ///
    /// # Errors
    /// When the path would leave the folder, or the disk refuses; the old file stands then.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        let path = self.path(name)?;
        let folder = path.parent().unwrap_or(&self.root);
        fs::create_dir_all(folder).map_err(at(folder))?;
        let temporary = temporary(&path);
        let written = File::create(&temporary).and_then(|mut f| f.write_all(bytes).and_then(|()| f.sync_all()));
        if let Err(source) = written.and_then(|()| fs::rename(&temporary, &path)) {
            // The error that counts is the first one; a leftover is swept when the run is opened again.
            let _ = fs::remove_file(&temporary);
            return Err(FolderError::Io { path, source });
        }
        // The rename itself is on the disk once its folder is; not every file system lets a folder be flushed.
        let _ = File::open(folder).and_then(|f| f.sync_all());
        Ok(())
    }

    /// Writes several files, each whole, in the given order.
    ///
    /// # Errors
    /// As [`RunFolder::write`]; files before the failing one are in place.
    pub fn write_all<'a>(&self, files: impl IntoIterator<Item = (&'a str, &'a [u8])>) -> Result<(), FolderError> {
        files.into_iter().try_for_each(|(name, bytes)| self.write(name, bytes))
    }

    /// Names of the folders below a folder of the run, sorted; none when it is not there.
    ///
    /// # Errors
    /// When the path would leave the folder, or the disk refuses.
    pub fn folders(&self, name: &str) -> Result<Vec<String>, FolderError> {
        self.names(name, fs::FileType::is_dir)
    }

    /// Names of the files of a folder of the run, sorted, of the run itself for `""`; none when it is not there.
    ///
    /// # Errors
    /// When the path would leave the folder, or the disk refuses.
    pub fn files(&self, name: &str) -> Result<Vec<String>, FolderError> {
        self.names(name, fs::FileType::is_file)
    }

    fn names(&self, name: &str, wanted: fn(&fs::FileType) -> bool) -> Result<Vec<String>, FolderError> {
        let path = if name.is_empty() { self.root.clone() } else { self.path(name)? };
        let entries = match fs::read_dir(&path) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
            entries => entries.map_err(at(&path))?,
        };
        let mut out = Vec::new();
        for entry in entries {
            let entry = entry.map_err(at(&path))?;
            if wanted(&entry.file_type().map_err(at(&path))?) {
                out.push(entry.file_name().to_string_lossy().into_owned());
            }
        }
        out.sort();
        Ok(out)
    }

    /// The bytes of a file, `None` when it is not there.
    ///
    /// # Errors
    /// When the path would leave the folder, or the disk refuses.
    pub fn read(&self, name: &str) -> Result<Option<Vec<u8>>, FolderError> {
        let path = self.path(name)?;
        match fs::read(&path) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(source) => Err(FolderError::Io { path, source }),
        }
    }

    /// Removes a folder of the run that no longer belongs to it, e.g. `front/12` when design 12 was dominated.
    ///
    /// # Errors
    /// When the path would leave the folder, or the disk refuses. A folder that is not there is fine.
    pub fn remove_folder(&self, name: &str) -> Result<(), FolderError> {
        let path = self.path(name)?;
        match fs::remove_dir_all(&path) {
            Err(e) if e.kind() != io::ErrorKind::NotFound => Err(FolderError::Io { path, source: e }),
            _ => Ok(()),
        }
    }
}

pub(super) fn at(path: &Path) -> impl FnOnce(io::Error) -> FolderError + '_ {
    move |source| FolderError::Io { path: path.to_owned(), source }
}

/// Whether a folder exists and holds anything but the beginning of a mark that a killed run left.
fn is_used(root: &Path) -> Result<bool, FolderError> {
    let begun = temporary(&root.join(MARK));
    match fs::read_dir(root) {
        Ok(mut entries) => Ok(entries.any(|e| e.map_or(true, |e| e.path() != begun))),
        Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(source) => Err(FolderError::Io { path: root.to_owned(), source }),
    }
}

/// `.name.part` in the same folder, so that the rename stays on one file system.
pub(super) fn temporary(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.part"))
}

/// Removes temporary files left by a killed run; links are not followed.
fn sweep(folder: &Path) -> Result<(), FolderError> {
    for entry in fs::read_dir(folder).map_err(at(folder))? {
        let entry = entry.map_err(at(folder))?;
        let (path, name) = (entry.path(), entry.file_name());
        let name = name.to_string_lossy();
        let kind = entry.file_type().map_err(at(&path))?;
        if kind.is_dir() {
            sweep(&path)?;
        } else if kind.is_file() && name.starts_with('.') && name.ends_with(".part") {
            fs::remove_file(&path).map_err(at(&path))?;
        }
    }
    Ok(())
}
