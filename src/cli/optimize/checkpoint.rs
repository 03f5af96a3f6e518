//! The checkpoint of a run: a journal of its scores.
//!
//! A search is a pure function of its seed and the scores it is told. So the scores, and the sizings that were paid for on the way, are
//! all that has to be kept: a run is resumed by asking its searcher again and telling it what is known. Each batch is a frame:
//!
//! ```text
//! most u64 · elapsed_us u64
//! sizings u32, each: house u128 · goal u8 · found u8 · choices 6 x u16
//! evaluations u32, each: identity u64 · violation f64 · objectives u8 · each f64        (little endian)
//! ```

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError, RwLock};
use std::time::{Duration, Instant};

use houscaper::run::{FolderError, Frames, Journal, RunFolder};
use houscaper::search::Score;
use houscaper::search::houses::Houses;
use houscaper::search::identity::identity;
use houscaper::search::proposal::CandidateOf;
use houscaper::search::run::Scorer;
use houscaper::voxels::{Choices, House};
use rustc_hash::FxHashSet;

use super::labour::Labour;

/// Its file in the run folder.
pub const FILE: &str = "checkpoint";

/// A sizing: of which house, for which goal.
type Sizing = (u128, usize);

/// A batch as it was scored.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Batch {
    /// What the searcher was asked for at most.
    pub most: u64,
    /// Time since the start of the run, all its parts together.
    pub elapsed: Duration,
    sizings: Vec<(Sizing, Option<Choices>)>,
    /// Identity and score of each evaluation.
    pub scores: Vec<(u64, Score)>,
}

impl Batch {
    fn bytes(&self) -> Vec<u8> {
        let mut out = Vec::new();
        out.extend(self.most.to_le_bytes());
        out.extend((self.elapsed.as_micros() as u64).to_le_bytes());
        out.extend((self.sizings.len() as u32).to_le_bytes());
        for ((house, goal), choices) in &self.sizings {
            out.extend(house.to_le_bytes());
            out.extend([*goal as u8, u8::from(choices.is_some())]);
            choices.unwrap_or_default().0.iter().for_each(|c| out.extend(c.to_le_bytes()));
        }
        out.extend((self.scores.len() as u32).to_le_bytes());
        for (key, score) in &self.scores {
            out.extend(key.to_le_bytes());
            out.extend(score.violation.to_le_bytes());
            out.push(score.objectives.len() as u8);
            score.objectives.iter().for_each(|v| out.extend(v.to_le_bytes()));
        }
        out
    }

    /// Reads a frame; `None` when it is not one of ours.
    pub fn read(bytes: &[u8]) -> Option<Batch> {
        let mut at = Cursor(bytes);
        let (most, elapsed) = (at.u64()?, Duration::from_micros(at.u64()?));
        let mut sizings = Vec::new();
        for _ in 0..at.u32()? {
            let (house, goal, found) = (u128::from_le_bytes(at.take()?), usize::from(at.u8()?), at.u8()? == 1);
            let mut choices = Choices::default();
            for choice in &mut choices.0 {
                *choice = u16::from_le_bytes(at.take()?);
            }
            sizings.push(((house, goal), found.then_some(choices)));
        }
        let mut scores = Vec::new();
        for _ in 0..at.u32()? {
            let (key, violation, count) = (at.u64()?, f64::from_le_bytes(at.take()?), at.u8()?);
            let objectives = (0..count).map(|_| Some(f64::from_le_bytes(at.take()?))).collect::<Option<_>>()?;
            scores.push((key, Score { objectives, violation }));
        }
        at.0.is_empty().then_some(Batch { most, elapsed, sizings, scores })
    }
}

struct Cursor<'a>(&'a [u8]);

impl Cursor<'_> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    fn u8(&mut self) -> Option<u8> {
        self.take().map(|[byte]| byte)
    }

    fn u32(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Option<u64> {
        self.take().map(u64::from_le_bytes)
    }
}

/// Sizings that were paid for: those of the checkpoint, and those since the last batch.
#[derive(Default)]
pub struct Sizings {
    known: BTreeMap<Sizing, Option<Choices>>,
    new: Mutex<BTreeMap<Sizing, Option<Choices>>>,
    /// Identities of the batch that is about to be told again; `None` past the end of the checkpoint.
    proposed: RwLock<Option<FxHashSet<u64>>>,
}

impl Sizings {
    /// The known result, else that of `size`, which is kept for the checkpoint.
    pub fn get(
        &self,
        house: &House,
        choices: &Choices,
        goal: usize,
        size: impl Fn() -> Option<Choices>,
    ) -> Option<Choices> {
        let key = (identity(house, choices), goal);
        if let Some(found) = self.known.get(&key) {
            return *found;
        }
        let found = size();
        self.new.lock().unwrap_or_else(PoisonError::into_inner).insert(key, found);
        found
    }

    /// Whether a child of the batch that comes next was screened out: what `screen` says past the end of the checkpoint; before, a house
    /// that keeps the rules was exactly if it is not in the batch, and nothing has to be measured again.
    pub fn is_beaten(
        &self,
        house: &House,
        choices: &Choices,
        keeps_rules: impl FnOnce() -> bool,
        screen: impl FnOnce() -> bool,
    ) -> bool {
        let proposed = self.proposed.read().unwrap_or_else(PoisonError::into_inner);
        match &*proposed {
            Some(batch) => !batch.contains(&short(identity(house, choices))) && keeps_rules(),
            None => screen(),
        }
    }

    fn drain(&self) -> Vec<(Sizing, Option<Choices>)> {
        std::mem::take(&mut *self.new.lock().unwrap_or_else(PoisonError::into_inner)).into_iter().collect()
    }
}

/// What a checkpoint holds, read for its length and sizings.
pub struct Known {
    /// The journal, at its end.
    pub journal: Journal,
    /// Sizings.
    pub sizings: Sizings,
    /// Evaluations.
    pub evaluations: u64,
    /// Time since the start of the run.
    pub elapsed: Duration,
}

/// Opens the checkpoint of a run, or begins it.
///
/// # Errors
/// When another process has it open, or the disk refuses.
pub fn open(folder: &RunFolder) -> Result<Known, FolderError> {
    let (mut sizings, mut evaluations, mut elapsed) = (Sizings::default(), 0, Duration::ZERO);
    let journal = Journal::open(folder, FILE, &mut |frame| {
        if let Some(batch) = Batch::read(frame) {
            sizings.known.extend(batch.sizings);
            evaluations += batch.scores.len() as u64;
            elapsed = batch.elapsed;
        }
    })?;
    Ok(Known { journal, sizings, evaluations, elapsed })
}

/// Scores from the checkpoint while it lasts, then by evaluation, appended to it.
pub struct Resumed<'a> {
    /// Frames still to be told; `None` once they are through.
    pub told: Option<Frames>,
    /// Where new batches are kept; `None` to stop at the end of the checkpoint.
    pub journal: Option<Journal>,
    /// Sizings to be kept with them.
    pub sizings: &'a Sizings,
    /// Scores houses that are in no checkpoint.
    pub labour: &'a dyn Labour,
    /// Time of the parts of the run before this one.
    pub before: Duration,
    /// Start of this part.
    pub started: Instant,
    /// Time of the last batch since the start of the run.
    pub elapsed: Duration,
    /// What went wrong.
    pub trouble: Option<anyhow::Error>,
    next: Option<Batch>,
    /// What the searcher was asked for last.
    asked: u64,
}

impl<'a> Resumed<'a> {
    /// Scores for a run with the checkpoint `known`, whose frames `told` reads.
    pub fn new(
        told: Option<Frames>,
        journal: Option<Journal>,
        sizings: &'a Sizings,
        labour: &'a dyn Labour,
        before: Duration,
    ) -> Self {
        let (started, elapsed) = (Instant::now(), Duration::ZERO);
        Resumed { told, journal, sizings, labour, before, started, elapsed, trouble: None, next: None, asked: 0 }
    }

    fn read_next(&mut self) -> anyhow::Result<()> {
        let Some(frames) = &mut self.told else { return Ok(()) };
        self.next = match frames.next_frame()? {
            Some(frame) => Some(Batch::read(&frame).ok_or_else(|| anyhow::anyhow!("{FILE}: a batch cannot be read"))?),
            None => None,
        };
        if self.next.is_none() {
            self.told = None;
        }
        let keys = self.next.as_ref().map(|batch| batch.scores.iter().map(|s| s.0).collect());
        *self.sizings.proposed.write().unwrap_or_else(PoisonError::into_inner) = keys;
        Ok(())
    }

    fn append(&mut self, batch: &[CandidateOf<Houses<'_>>], scores: &[Score]) -> anyhow::Result<()> {
        self.elapsed = self.before + self.started.elapsed();
        let keyed = batch.iter().zip(scores).map(|(c, s)| (key(c), s.clone())).collect();
        let frame = Batch { most: self.asked, elapsed: self.elapsed, sizings: self.sizings.drain(), scores: keyed };
        if let Some(journal) = &mut self.journal {
            journal.append(&frame.bytes())?;
        }
        Ok(())
    }
}

/// The identity by which a checkpoint knows a house.
fn key(candidate: &CandidateOf<Houses<'_>>) -> u64 {
    short(identity(&candidate.form, &candidate.genome.choices))
}

/// The half of an identity that checkpoints hold.
fn short(identity: u128) -> u64 {
    (identity >> 64) as u64
}

impl<'h> Scorer<Houses<'h>> for Resumed<'_> {
    fn most(&mut self, left: u64) -> u64 {
        if let Err(error) = self.read_next() {
            self.trouble = Some(error);
        }
        self.asked = self.next.as_ref().map_or(left, |batch| batch.most);
        self.asked
    }

    fn score(&mut self, batch: &[CandidateOf<Houses<'h>>]) -> Option<Vec<Score>> {
        if self.trouble.is_some() {
            return None;
        }
        if let Some(known) = self.next.take() {
            if known.scores.len() != batch.len() || known.scores.iter().zip(batch).any(|(k, c)| k.0 != key(c)) {
                let at = batch.first().map_or(0, |c| c.id);
                self.trouble = Some(anyhow::anyhow!(
                    "{FILE}: from evaluation {at} on it holds other houses than this search proposes: the run was made by another version; begin a new one with another --out"
                ));
                return None;
            }
            self.elapsed = known.elapsed;
            return Some(known.scores.into_iter().map(|s| s.1).collect());
        }
        self.journal.as_ref()?;
        let houses: Vec<(&House, &Choices)> = batch.iter().map(|c| (&c.form, &c.genome.choices)).collect();
        let scored = self.labour.score(&houses).and_then(|scores| {
            scores.as_ref().map_or(Ok(()), |scores| self.append(batch, scores))?;
            Ok(scores)
        });
        scored.unwrap_or_else(|error| {
            self.trouble = Some(error);
            None
        })
    }
}
