//! A table that grows as results arrive.

use std::fs::{self, File};
use std::io::Write;
use std::path::PathBuf;

use super::folder::{FolderError, RunFolder, at, temporary};

/// A text file of a run that rows are appended to, many at a time. It takes its name, and the place of an older one, when it is
/// published: so an older table stands until the new one holds at least as much.
#[derive(Debug)]
pub struct Table {
    file: File,
    path: PathBuf,
    published: bool,
}

impl Table {
    /// Begins a table with its header.
    ///
    /// # Errors
    /// When the path would leave the folder, or the disk refuses.
    pub fn begin(folder: &RunFolder, name: &str, header: &str) -> Result<Table, FolderError> {
        let path = folder.path(name)?;
        let mut file = File::create(temporary(&path)).map_err(at(&path))?;
        file.write_all(header.as_bytes()).map_err(at(&path))?;
        Ok(Table { file, path, published: false })
    }

    /// Appends whole rows in one write.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn append(&mut self, rows: &str) -> Result<(), FolderError> {
        self.file.write_all(rows.as_bytes()).map_err(at(&self.path))
    }

    /// Gives the table its name, if it has not got it yet.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn publish(&mut self) -> Result<(), FolderError> {
        if !self.published {
            fs::rename(temporary(&self.path), &self.path).map_err(at(&self.path))?;
            self.published = true;
        }
        Ok(())
    }

    /// Publishes and flushes to the disk.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn finish(&mut self) -> Result<(), FolderError> {
        self.publish()?;
        self.file.sync_all().map_err(at(&self.path))
    }
}
