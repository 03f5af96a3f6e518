//! What a worker needs of a run, as one block of bytes: brief, books, tilesets, and houses whose scores are known.
//!
//! A worker has none of the coordinator's files. It unpacks a parcel in a folder of its own, loads its evaluator, deletes the folder, and
//! compares the scores it finds for the proofs bit by bit: another processor may round differently, and then the run would not be the same.

use std::fs;
use std::path::{Component, Path, PathBuf};

use sha2::{Digest, Sha256};

use super::wire::{Reader, write_houses, write_score};
use crate::brief::{BriefError, Search, read_brief};
use crate::score::{Evaluator, LoadFailure, Paths};
use crate::search::Score;
use crate::voxels::{Choices, House};

/// Bytes of a parcel at most.
pub const MOST_BYTES: usize = 64 << 20;
/// Files of a parcel at most.
const MOST_FILES: usize = 8192;
/// Folders below a tileset at most.
const DEEPEST: usize = 4;

/// Why a parcel could not be made or used.
#[derive(Debug, thiserror::Error)]
pub enum ParcelError {
    /// A file could not be read or written.
    #[error("{path}: {source}", path = .path.display())]
    Io {
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Too much to be sent.
    #[error(
        "brief, books and tilesets are {files} files of {bytes} bytes together: at most {MOST_FILES} files and {MOST_BYTES} bytes go through the queue"
    )]
    TooLarge {
        /// Files.
        files: usize,
        /// Their bytes.
        bytes: usize,
    },
    /// Not a parcel, or a damaged one.
    #[error("the run's parcel is damaged or of another program: {0}")]
    Damaged(&'static str),
    /// The brief in it.
    #[error("the run's parcel: {0}")]
    Brief(#[from] BriefError),
    /// What it names.
    #[error(
        "the run's parcel: {0} (a tileset whose files lie outside its folder cannot be sent; `houscaper tileset bake` puts them in one)"
    )]
    Load(#[from] LoadFailure),
    /// A book that is no JSON object.
    #[error("{path}: cannot be sent: {what}", path = .path.display())]
    Book {
        /// The book.
        path: PathBuf,
        /// What is wrong.
        what: String,
    },
    /// The scores differ.
    #[error(
        "this machine finds {found:?} for a house where the coordinator finds {known:?}: the run would not be the same. Use workers of the coordinator's build and kind of processor"
    )]
    Differs {
        /// Own score.
        found: Score,
        /// The coordinator's.
        known: Score,
    },
}

/// A parcel.
#[derive(Clone, Debug, PartialEq)]
pub struct Parcel {
    files: Vec<(String, Vec<u8>)>,
    proofs: Vec<(House, Choices, Score)>,
}

impl Parcel {
    /// Packs what `evaluator` was loaded from (`paths`), with the scores of some houses.
    ///
    /// # Errors
    /// [`ParcelError`] when a file cannot be read or all of them are too much.
    pub fn pack(evaluator: &Evaluator, paths: &Paths, houses: &[(House, Choices)]) -> Result<Parcel, ParcelError> {
        let books = &evaluator.books;
        let mut brief = evaluator.brief.clone();
        // What only a search reads is left out: runs that differ in it alone share their parcel.
        (brief.search, brief.reference) = (Search::default(), None);
        (brief.prices, brief.carbon, brief.buildups) =
            ("books/0/prices.json".into(), "books/carbon.json".into(), "books/buildups.json".into());
        let mut files = vec![("brief.json".to_owned(), serde_json::to_vec(&brief).unwrap_or_default())];
        let chain: Vec<&String> = std::iter::once(&books.prices.file).chain(&books.prices.extended).collect();
        for (n, file) in chain.iter().enumerate() {
            let next = (n + 1 < chain.len()).then(|| format!("../{}/prices.json", n + 1));
            files.push((format!("books/{n}/prices.json"), book(Path::new(file), next)?));
        }
        files.push(("books/carbon.json".into(), read(Path::new(&books.carbon.file))?));
        files.push(("books/buildups.json".into(), read(Path::new(&books.buildups.file))?));
        for name in ["materials.json", "sections.json", "loads.json"] {
            files.push((format!("configs/{name}"), read(&paths.configs.join(name))?));
        }
        for (name, folder) in [("tileset", &paths.tileset), ("linear", &paths.linear)] {
            collect(folder, name, DEEPEST, &mut files)?;
        }
        files.sort();
        let bytes = files.iter().map(|f| f.1.len()).sum();
        if files.len() > MOST_FILES || bytes > MOST_BYTES {
            return Err(ParcelError::TooLarge { files: files.len(), bytes });
        }
        let proof =
            |(house, choices): &(House, Choices)| (house.clone(), *choices, super::score(evaluator, house, choices));
        Ok(Parcel { files, proofs: houses.iter().map(proof).collect() })
    }

    /// As bytes: `HSP1`, the number of files, each name and content with its length, the proofs.
    pub fn bytes(&self) -> Vec<u8> {
        let mut out = b"HSP1".to_vec();
        out.extend((self.files.len() as u32).to_le_bytes());
        for (name, bytes) in &self.files {
            out.extend((name.len() as u16).to_le_bytes());
            out.extend(name.as_bytes());
            out.extend((bytes.len() as u32).to_le_bytes());
            out.extend(bytes);
        }
        let houses: Vec<(House, Choices)> = self.proofs.iter().map(|p| (p.0.clone(), p.1)).collect();
        write_houses(&houses, &mut out);
        self.proofs.iter().for_each(|p| write_score(&p.2, &mut out));
        out
    }

    /// From bytes.
    ///
    /// # Errors
    /// [`ParcelError::Damaged`].
    pub fn read(bytes: &[u8]) -> Result<Parcel, ParcelError> {
        parse(bytes).ok_or(ParcelError::Damaged("its bytes are no parcel"))
    }

    /// Loads the evaluator, through a folder of its own that is deleted again, and checks the proofs.
    ///
    /// # Errors
    /// [`ParcelError`]: a file name that would leave the folder, a full disk, what a brief may have wrong, other scores.
    pub fn load(&self) -> Result<Evaluator, ParcelError> {
        let folder = Scratch::new()?;
        for (name, bytes) in &self.files {
            let name = Path::new(name);
            if !name.components().all(|c| matches!(c, Component::Normal(_))) {
                return Err(ParcelError::Damaged("a file name leads out of its folder"));
            }
            let path = folder.0.join(name);
            let error = |source| ParcelError::Io { path: path.clone(), source };
            path.parent().map_or(Ok(()), fs::create_dir_all).map_err(error)?;
            fs::write(&path, bytes).map_err(error)?;
        }
        let text = self.files.iter().find(|f| f.0 == "brief.json").ok_or(ParcelError::Damaged("it has no brief"))?;
        let brief = read_brief(&text.1, "brief.json")?;
        let paths = Paths {
            brief: folder.0.clone(),
            configs: folder.0.join("configs"),
            tileset: folder.0.join("tileset"),
            linear: folder.0.join("linear"),
        };
        let evaluator = Evaluator::load(brief, &paths)?;
        for (house, choices, known) in &self.proofs {
            let found = super::score(&evaluator, house, choices);
            if !same_bits(&found, known) {
                return Err(ParcelError::Differs { found, known: known.clone() });
            }
        }
        Ok(evaluator)
    }
}

/// SHA-256 of a parcel's bytes: what questions name it by.
pub fn digest(bytes: &[u8]) -> [u8; 32] {
    let digest = Sha256::digest(bytes);
    std::array::from_fn(|i| digest[i])
}

fn same_bits(a: &Score, b: &Score) -> bool {
    let bits = |s: &Score| -> Vec<u64> { s.objectives.iter().chain([&s.violation]).map(|v| v.to_bits()).collect() };
    bits(a) == bits(b)
}

fn parse(bytes: &[u8]) -> Option<Parcel> {
    let mut at = Reader(bytes);
    if at.take::<4>()? != *b"HSP1" {
        return None;
    }
    let part = |at: &mut Reader, length: usize| {
        let (part, rest) = at.0.split_at_checked(length)?;
        at.0 = rest;
        Some(part.to_vec())
    };
    let count = at.u32()? as usize;
    let mut files = Vec::new();
    for _ in 0..count.min(MOST_FILES + 1) {
        let length = usize::from(at.u16()?);
        let name = String::from_utf8(part(&mut at, length)?).ok()?;
        let length = at.u32()? as usize;
        files.push((name, part(&mut at, length)?));
    }
    let houses = at.houses()?;
    let proofs = houses.into_iter().map(|(h, c)| Some((h, c, at.score()?))).collect::<Option<_>>()?;
    (files.len() == count && at.0.is_empty()).then_some(Parcel { files, proofs })
}

fn read(path: &Path) -> Result<Vec<u8>, ParcelError> {
    fs::read(path).map_err(|source| ParcelError::Io { path: path.into(), source })
}

/// A price book, with the place in the parcel of the one that it extends.
fn book(path: &Path, next: Option<String>) -> Result<Vec<u8>, ParcelError> {
    let bytes = read(path)?;
    let Some(next) = next else { return Ok(bytes) };
    let error = |e: serde_json::Error| ParcelError::Book { path: path.into(), what: e.to_string() };
    let mut book: serde_json::Map<String, serde_json::Value> = serde_json::from_slice(&bytes).map_err(error)?;
    book.insert("extends".into(), next.into());
    serde_json::to_vec(&book).map_err(error)
}

/// The files of a folder and of those below it.
fn collect(folder: &Path, name: &str, deep: usize, files: &mut Vec<(String, Vec<u8>)>) -> Result<(), ParcelError> {
    let error = |source| ParcelError::Io { path: folder.into(), source };
    for entry in fs::read_dir(folder).map_err(error)? {
        let path = entry.map_err(error)?.path();
        let Some(own) = path.file_name().and_then(|n| n.to_str()) else { continue };
        let name = format!("{name}/{own}");
        if path.is_dir() && deep > 0 {
            collect(&path, &name, deep - 1, files)?;
        } else if path.is_file() && files.len() <= MOST_FILES {
            files.push((name, read(&path)?));
        }
    }
    Ok(())
}

/// A folder of our own under the system's temporary one, deleted when dropped.
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Result<Scratch, ParcelError> {
        let path = std::env::temp_dir().join(format!("houscaper-{}", super::wire::RunId::new()));
        let mut builder = fs::DirBuilder::new();
        #[cfg(unix)]
        std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
        // Not recursive: a folder that is there already is somebody else's.
        builder.create(&path).map_err(|source| ParcelError::Io { path: path.clone(), source })?;
        Ok(Scratch(path))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxels::samples;

    fn home() -> PathBuf {
        PathBuf::from(env!("CARGO_MANIFEST_DIR"))
    }

    fn evaluator(prices: &Path, tileset: &str) -> (Evaluator, Paths) {
        let text = fs::read(home().join("configs/starter.json")).expect("a shipped brief");
        let mut brief = read_brief(&text, "starter").expect("a brief");
        brief.prices = prices.display().to_string();
        let paths = Paths {
            brief: home().join("configs"),
            configs: home().join("configs"),
            tileset: home().join("tilesets").join(tileset),
            linear: home().join("tilesets/linear"),
        };
        (Evaluator::load(brief, &paths).expect("its books"), paths)
    }

    fn houses() -> Vec<(House, Choices)> {
        samples::all().into_iter().take(2).map(|(_, house)| (house, Choices::default())).collect()
    }

    /// A worker that has nothing but the bytes finds the same scores, for styles, surfaces and a book that extends another.
    #[test]
    fn what_is_packed_is_all_that_a_worker_needs() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let text = fs::read(home().join("configs/prices.json")).expect("a book");
        let mut book: serde_json::Map<String, serde_json::Value> = serde_json::from_slice(&text).expect("JSON");
        let first = book["items"][0].clone();
        for key in ["works", "window_min_m2", "labour_basis_eur_h", "completion", "rates"] {
            book.remove(key);
        }
        let rate = first["default"].as_f64();
        book.insert("items".into(), serde_json::Value::Array(vec![first]));
        book.insert("extends".into(), "prices.json".into());
        let own = folder.path().join("own.json");
        fs::write(&own, serde_json::to_vec(&book).expect("JSON")).expect("a file");
        assert!(rate.is_none_or(|r| r > 0.0));
        let shipped = home().join("configs/prices.json");
        for (prices, tileset) in [(&shipped, "architectural"), (&shipped, "surface-1"), (&own, "larch")] {
            let (evaluator, paths) = evaluator(prices, tileset);
            let parcel = Parcel::pack(&evaluator, &paths, &houses()).expect("a parcel");
            let bytes = parcel.bytes();
            let back = Parcel::read(&bytes).expect("a parcel");
            assert_eq!(back, parcel);
            let loaded = back.load().unwrap_or_else(|e| panic!("{tileset}: {e}"));
            assert_eq!(loaded.books.prices.extended.len(), evaluator.books.prices.extended.len());
            for (house, choices) in houses() {
                let scores = [&evaluator, &loaded].map(|e| super::super::score(e, &house, &choices));
                assert!(same_bits(&scores[0], &scores[1]) && !scores[0].objectives.is_empty(), "{tileset}: {scores:?}");
            }
        }
    }

    #[test]
    fn a_parcel_of_other_scores_or_that_leaves_its_folder_is_refused() {
        let (evaluator, paths) = evaluator(&home().join("configs/prices.json"), "architectural");
        let parcel = Parcel::pack(&evaluator, &paths, &houses()).expect("a parcel");
        // The least change of the last digit is another score.
        let mut other = parcel.clone();
        let first = &mut other.proofs[1].2.objectives[0];
        *first = f64::from_bits(first.to_bits() + 1);
        let error = other.load().err().expect("a refusal").to_string();
        assert!(error.contains("kind of processor"), "{error}");
        for name in ["../out.json", "/tmp/out.json", "a/../../out.json"] {
            let mut other = parcel.clone();
            other.files.push((name.into(), b"{}".to_vec()));
            assert!(matches!(other.load(), Err(ParcelError::Damaged(_))), "{name}");
        }
        let bytes = parcel.bytes();
        for cut in (0..bytes.len()).step_by(997).chain([bytes.len() - 1]) {
            assert!(matches!(Parcel::read(&bytes[..cut]), Err(ParcelError::Damaged(_))), "{cut}");
        }
        assert_ne!(digest(&bytes), digest(&other.bytes()));
    }
}
