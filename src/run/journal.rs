//! The journal of a run: what cannot be computed again cheaply, batch by batch, in a file that only grows.
//!
//! ```text
//! "HSCPJRN1"  then frames: length u32 · check u64 · payload      (little endian; check = first 8 bytes of the payload's SHA-256)
//! ```
//!
//! A run that is killed leaves at most its last frame torn: opening cuts it off. Frames reach the operating system at once, so a killed
//! process loses nothing that was appended; the disk at most every [`FLUSH`], so that a power cut costs no more.

use std::fs::{File, OpenOptions};
use std::io::{self, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use sha2::{Digest, Sha256};

use super::folder::{FolderError, RunFolder, at};

const MAGIC: &[u8; 8] = b"HSCPJRN1";
/// Longest time between flushes to the disk while frames arrive.
const FLUSH: Duration = Duration::from_secs(2);

/// A journal open for appending, by one process at a time.
#[derive(Debug)]
pub struct Journal {
    file: File,
    path: PathBuf,
    flushed: Instant,
}

impl Journal {
    /// Opens the journal of a run, or begins it; a torn end is cut off. `each` sees every whole frame in order.
    ///
    /// # Errors
    /// When another process has it open, the file is no journal, or the disk refuses.
    pub fn open(folder: &RunFolder, name: &str, each: &mut dyn FnMut(&[u8])) -> Result<Journal, FolderError> {
        let path = folder.path(name)?;
        let mut file =
            OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path).map_err(at(&path))?;
        if file.try_lock().is_err() {
            return Err(FolderError::InUse { folder: folder.root().to_owned() });
        }
        let mut frames = Frames::of(file.try_clone().map_err(at(&path))?, &path)?;
        while let Some(frame) = frames.next_frame()? {
            each(&frame);
        }
        let end = frames.whole;
        if end == 0 {
            file.set_len(0).map_err(at(&path))?;
            file.seek(SeekFrom::Start(0)).and_then(|_| file.write_all(MAGIC)).map_err(at(&path))?;
        } else {
            file.set_len(end).and_then(|()| file.seek(SeekFrom::Start(end)).map(|_| ())).map_err(at(&path))?;
        }
        file.sync_all().map_err(at(&path))?;
        Ok(Journal { file, path, flushed: Instant::now() })
    }

    /// Appends a frame in one write.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn append(&mut self, payload: &[u8]) -> Result<(), FolderError> {
        let mut frame = Vec::with_capacity(payload.len() + 12);
        frame.extend_from_slice(&(payload.len() as u32).to_le_bytes());
        frame.extend_from_slice(&check(payload));
        frame.extend_from_slice(payload);
        self.file.write_all(&frame).map_err(at(&self.path))?;
        if self.flushed.elapsed() >= FLUSH {
            self.file.sync_data().map_err(at(&self.path))?;
            self.flushed = Instant::now();
        }
        Ok(())
    }
}

/// The frames of a journal, read one by one.
#[derive(Debug)]
pub struct Frames {
    reader: BufReader<File>,
    path: PathBuf,
    /// Bytes up to the end of the last whole frame; 0 before the magic number was read.
    whole: u64,
}

impl Frames {
    /// Reads the journal of a run from its beginning; `None` when there is none.
    ///
    /// # Errors
    /// When the file is no journal, or the disk refuses.
    pub fn read(folder: &RunFolder, name: &str) -> Result<Option<Frames>, FolderError> {
        let path = folder.path(name)?;
        match File::open(&path) {
            Ok(file) => Frames::of(file, &path).map(Some),
            Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(source) => Err(FolderError::Io { path, source }),
        }
    }

    fn of(file: File, path: &Path) -> Result<Frames, FolderError> {
        let mut out = Frames { reader: BufReader::new(file), path: path.to_owned(), whole: 0 };
        let mut magic = [0; 8];
        match out.fill(&mut magic)? {
            8 if &magic == MAGIC => out.whole = 8,
            8 => return Err(FolderError::NoJournal { path: path.to_owned() }),
            // Killed before its first bytes were written.
            _ => {}
        }
        Ok(out)
    }

    /// The next whole frame; `None` at the end, or where the file is torn.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn next_frame(&mut self) -> Result<Option<Vec<u8>>, FolderError> {
        let (mut length, mut expected) = ([0; 4], [0; 8]);
        if self.whole == 0 || self.fill(&mut length)? < 4 || self.fill(&mut expected)? < 8 {
            return Ok(None);
        }
        let mut payload = Vec::new();
        let length = u64::from(u32::from_le_bytes(length));
        (&mut self.reader).take(length).read_to_end(&mut payload).map_err(at(&self.path))?;
        if payload.len() as u64 != length || check(&payload) != expected {
            return Ok(None);
        }
        self.whole += 12 + length;
        Ok(Some(payload))
    }

    /// Bytes read, fewer than asked for at the end of the file.
    fn fill(&mut self, bytes: &mut [u8]) -> Result<usize, FolderError> {
        let mut done = 0;
        while done < bytes.len() {
            match self.reader.read(&mut bytes[done..]).map_err(at(&self.path))? {
                0 => break,
                n => done += n,
            }
        }
        Ok(done)
    }
}

fn check(payload: &[u8]) -> [u8; 8] {
    let mut out = [0; 8];
    out.copy_from_slice(&Sha256::digest(payload)[..8]);
    out
}
