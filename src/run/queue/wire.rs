//! The messages of the queue as bytes, little endian. Every number is checked when read: a message that is not ours is none.
//!
//! ```text
//! question: "HSQ1" · run 16 · parcel 32 · ticket u64 · first u32 · houses u16, each: house · choices 6 x u16
//! answer:   "HSA1" · run 16 · ticket u64 · first u32 · question u64 · worker u64 · microseconds u64 · 0: scores u16, each: score
//!                                                                                                    · 1: text u16
//! house:    shape 3 x u16 · module 3 x f64 · origin 3 x f64 · runs u32, each: label << 5 | length - 1
//!           · stairs u16, each: storey u16 · start 2 x u16 · run u8 · kind u8 · zones u32, each: length u16 · zone i32
//! score:    violation f64 · objectives u8, each: f64
//! ```

use sha2::{Digest, Sha256};

use crate::search::Score;
use crate::voxels::{Choices, Direction, House, Label, Module, Stair, StairKind, VoxelArray};

/// Houses in one question at most.
pub const MOST_HOUSES: usize = 4096;
/// Voxels of one house at most.
const MOST_VOXELS: usize = 1 << 22;
/// Bytes of what a worker says at most.
const MOST_TEXT: usize = 2000;

/// A run of a coordinator: other for each start, also of a resumed one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RunId(pub [u8; 16]);

impl RunId {
    /// A new one: from the process, the clock and where a value lies in memory.
    pub fn new() -> Self {
        let clock = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH).map_or(0, |d| d.as_nanos());
        let place = Box::new(0_u8);
        let text = format!("{} {clock} {:p}", std::process::id(), place);
        let digest = Sha256::digest(text.as_bytes());
        RunId(std::array::from_fn(|i| digest[i]))
    }
}

impl Default for RunId {
    fn default() -> Self {
        RunId::new()
    }
}

impl std::fmt::Display for RunId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

/// Houses to be scored.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The run.
    pub run: RunId,
    /// SHA-256 of its parcel.
    pub parcel: [u8; 32],
    /// Number of the batch within the run.
    pub ticket: u64,
    /// Place of the first house in the batch.
    pub first: u32,
    /// The houses.
    pub houses: Vec<(House, Choices)>,
}

/// What a worker says to a question.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The run.
    pub run: RunId,
    /// Number of the batch.
    pub ticket: u64,
    /// Place of the first house.
    pub first: u32,
    /// [`digest`] of the question.
    pub question: u64,
    /// Who answers, a number of its own.
    pub worker: u64,
    /// Time of the evaluations, microseconds.
    pub micros: u64,
    /// The scores in the order of the houses, or why there are none.
    pub scores: Result<Vec<Score>, String>,
}

/// What an answer knows its question by: the first eight bytes of its SHA-256.
pub fn digest(question: &[u8]) -> u64 {
    let digest = Sha256::digest(question);
    u64::from_le_bytes(std::array::from_fn(|i| digest[i]))
}

impl Question {
    /// As bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let mut out = b"HSQ1".to_vec();
        out.extend(self.run.0);
        out.extend(self.parcel);
        out.extend(self.ticket.to_le_bytes());
        out.extend(self.first.to_le_bytes());
        write_houses(&self.houses, &mut out);
        out
    }

    /// From bytes; `None` when they are no question.
    pub fn read(bytes: &[u8]) -> Option<Question> {
        let mut at = Reader(bytes);
        let (magic, run, parcel) = (at.take::<4>()?, RunId(at.take()?), at.take()?);
        let (ticket, first, houses) = (at.u64()?, at.u32()?, at.houses()?);
        (magic == *b"HSQ1" && at.0.is_empty()).then_some(Question { run, parcel, ticket, first, houses })
    }
}

impl Answer {
    /// As bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let mut out = b"HSA1".to_vec();
        out.extend(self.run.0);
        out.extend(self.ticket.to_le_bytes());
        out.extend(self.first.to_le_bytes());
        [self.question, self.worker, self.micros].iter().for_each(|n| out.extend(n.to_le_bytes()));
        match &self.scores {
            Ok(scores) => {
                out.push(0);
                out.extend((scores.len() as u16).to_le_bytes());
                scores.iter().for_each(|score| write_score(score, &mut out));
            }
            Err(text) => {
                out.push(1);
                let text: String = text.chars().take(MOST_TEXT / 4).collect();
                out.extend((text.len() as u16).to_le_bytes());
                out.extend(text.as_bytes());
            }
        }
        out
    }

    /// From bytes; `None` when they are no answer.
    pub fn read(bytes: &[u8]) -> Option<Answer> {
        let mut at = Reader(bytes);
        let (magic, run) = (at.take::<4>()?, RunId(at.take()?));
        let (ticket, first, question, worker, micros) = (at.u64()?, at.u32()?, at.u64()?, at.u64()?, at.u64()?);
        let scores = match at.u8()? {
            0 => {
                let count = usize::from(at.u16()?);
                Ok((0..count.min(MOST_HOUSES + 1)).map(|_| at.score()).collect::<Option<Vec<_>>>()?)
            }
            1 => {
                let length = usize::from(at.u16()?);
                let (text, rest) = at.0.split_at_checked(length.min(MOST_TEXT))?;
                at.0 = rest;
                Err(String::from_utf8_lossy(text).into_owned())
            }
            _ => return None,
        };
        let whole = magic == *b"HSA1" && at.0.is_empty();
        whole.then_some(Answer { run, ticket, first, question, worker, micros, scores })
    }
}

/// Writes houses with their choices.
pub(super) fn write_houses(houses: &[(House, Choices)], out: &mut Vec<u8>) {
    out.extend((houses.len() as u16).to_le_bytes());
    for (house, choices) in houses {
        write_house(house, out);
        choices.0.iter().for_each(|c| out.extend(c.to_le_bytes()));
    }
}

/// Writes a score.
pub(super) fn write_score(score: &Score, out: &mut Vec<u8>) {
    out.extend(score.violation.to_le_bytes());
    out.push(score.objectives.len() as u8);
    score.objectives.iter().for_each(|v| out.extend(v.to_le_bytes()));
}

fn write_house(house: &House, out: &mut Vec<u8>) {
    let voxels = &house.voxels;
    voxels.shape().iter().for_each(|n| out.extend((*n as u16).to_le_bytes()));
    voxels.module.size_m.iter().chain(&voxels.origin_m).for_each(|v| out.extend(v.to_le_bytes()));
    let at = out.len();
    out.extend([0; 4]);
    let mut runs = 0_u32;
    for run in voxels.labels().chunk_by(|a, b| a == b) {
        for part in run.chunks(32) {
            out.push(part[0].code() << 5 | (part.len() - 1) as u8);
            runs += 1;
        }
    }
    out[at..at + 4].copy_from_slice(&runs.to_le_bytes());
    out.extend((house.stairs.len() as u16).to_le_bytes());
    for stair in &house.stairs {
        [stair.storey, stair.start[0], stair.start[1]].iter().for_each(|n| out.extend((*n as u16).to_le_bytes()));
        out.extend([stair.run as u8, stair.kind as u8]);
    }
    let zones: Vec<&[i32]> =
        house.zones.chunk_by(|a, b| a == b).flat_map(|r| r.chunks(usize::from(u16::MAX))).collect();
    out.extend((zones.len() as u32).to_le_bytes());
    for run in zones {
        out.extend((run.len() as u16).to_le_bytes());
        out.extend(run[0].to_le_bytes());
    }
}

/// Bytes still to be read.
pub(super) struct Reader<'a>(pub &'a [u8]);

impl Reader<'_> {
    pub fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    pub fn u8(&mut self) -> Option<u8> {
        self.take().map(|[byte]| byte)
    }

    pub fn u16(&mut self) -> Option<u16> {
        self.take().map(u16::from_le_bytes)
    }

    pub fn u32(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    pub fn u64(&mut self) -> Option<u64> {
        self.take().map(u64::from_le_bytes)
    }

    fn f64(&mut self) -> Option<f64> {
        self.take().map(f64::from_le_bytes)
    }

    /// Houses with their choices.
    pub fn houses(&mut self) -> Option<Vec<(House, Choices)>> {
        let count = usize::from(self.u16()?);
        if count > MOST_HOUSES {
            return None;
        }
        let one = |at: &mut Self| {
            let house = at.house()?;
            let mut choices = Choices::default();
            for choice in &mut choices.0 {
                *choice = at.u16()?;
            }
            Some((house, choices))
        };
        (0..count).map(|_| one(self)).collect()
    }

    /// A score.
    pub fn score(&mut self) -> Option<Score> {
        let (violation, count) = (self.f64()?, self.u8()?);
        let objectives = (0..count).map(|_| self.f64()).collect::<Option<_>>()?;
        Some(Score { objectives, violation })
    }

    fn house(&mut self) -> Option<House> {
        let shape: [usize; 3] = [self.u16()?, self.u16()?, self.u16()?].map(usize::from);
        let count = shape.iter().try_fold(1_usize, |n, side| n.checked_mul(*side)).filter(|n| *n <= MOST_VOXELS)?;
        let size_m = [self.f64()?, self.f64()?, self.f64()?];
        let origin_m = [self.f64()?, self.f64()?, self.f64()?];
        let runs = self.u32()? as usize;
        let (runs, rest) = self.0.split_at_checked(runs)?;
        self.0 = rest;
        // The length is known before anything is kept: thirty-two voxels a byte at most.
        if runs.iter().map(|run| usize::from(run & 31) + 1).sum::<usize>() != count {
            return None;
        }
        let mut labels = Vec::with_capacity(count);
        for run in runs {
            labels.resize(labels.len() + usize::from(run & 31) + 1, Label::from_code(run >> 5)?);
        }
        let mut voxels = VoxelArray::from_labels(shape, labels)?;
        (voxels.module, voxels.origin_m) = (Module { size_m }, origin_m);
        let sane = size_m.iter().all(|v| v.is_finite() && *v > 0.0) && origin_m.iter().all(|v| v.is_finite());
        let stairs = usize::from(self.u16()?);
        let stairs = (0..stairs).map(|_| self.stair(shape)).collect::<Option<_>>()?;
        let mut zones = Vec::new();
        for _ in 0..self.u32()? {
            let (length, zone) = (usize::from(self.u16()?), i32::from_le_bytes(self.take()?));
            if length > count - zones.len() {
                return None;
            }
            zones.resize(zones.len() + length, zone);
        }
        let fits = zones.is_empty() || zones.len() == count;
        (sane && fits).then_some(House { voxels, stairs, zones })
    }

    fn stair(&mut self, shape: [usize; 3]) -> Option<Stair> {
        let [storey, x, y] = [self.u16()?, self.u16()?, self.u16()?].map(usize::from);
        let run = *Direction::ALL.get(usize::from(self.u8()?))?;
        let kind = match self.u8()? {
            0 => StairKind::Straight,
            1 => StairKind::UTurn,
            _ => return None,
        };
        (x < shape[0] && y < shape[1] && storey < shape[2]).then_some(Stair { storey, start: [x, y], run, kind })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxels::samples;

    fn question() -> Question {
        let mut houses: Vec<(House, Choices)> =
            samples::all().into_iter().map(|(_, house)| (house, Choices([1, 2, 3, 4, 5, 6]))).collect();
        let count = houses[0].0.voxels.labels().len();
        houses[0].0.zones = (0..count).map(|i| (i / 700) as i32 - 1).collect();
        houses[1].0.voxels.origin_m = [0.1, -2.5, 1e9];
        Question { run: RunId([7; 16]), parcel: [9; 32], ticket: u64::MAX, first: 12, houses }
    }

    fn answer() -> Answer {
        let score = |n: usize| Score { objectives: (0..n).map(|i| i as f64 / 3.0).collect(), violation: -0.0 };
        let scores = Ok((0..5).map(score).collect());
        Answer { run: RunId([1; 16]), ticket: 3, first: 4, question: 5, worker: 6, micros: 7, scores }
    }

    #[test]
    fn what_is_written_is_read() {
        let question = question();
        assert!(question.houses.iter().any(|(h, _)| !h.stairs.is_empty()));
        assert_eq!(Question::read(&question.bytes()), Some(question));
        let answer = answer();
        let back = Answer::read(&answer.bytes()).expect("an answer");
        assert_eq!(back, answer);
        // -0.0 == 0.0: the bits are what has to come through.
        assert!(back.scores.expect("scores")[0].violation.is_sign_negative());
        let failed = Answer { scores: Err("ß".repeat(5000)), ..answer };
        let back = Answer::read(&failed.bytes()).expect("an answer");
        assert_eq!(back.scores, Err("ß".repeat(500)));
    }

    #[test]
    fn what_is_cut_off_longer_or_changed_is_no_message_or_another_one() {
        let (question, answer) = (question().bytes(), answer().bytes());
        for cut in 0..answer.len() {
            assert_eq!(Answer::read(&answer[..cut]), None, "{cut}");
        }
        for cut in (0..question.len()).step_by(7) {
            assert_eq!(Question::read(&question[..cut]), None, "{cut}");
        }
        assert_eq!(Question::read(&[question.clone(), vec![0]].concat()), None);
        // Any byte may be anything: nothing panics, and nothing that differs is taken for the same.
        for at in (0..question.len()).step_by(3) {
            for value in [0, 31, 255] {
                let mut other = question.clone();
                other[at] = value;
                if other != question {
                    assert_ne!(digest(&other), digest(&question), "{at}");
                }
                let _ = (Question::read(&other), Answer::read(&other));
            }
        }
        let mut huge = question.clone();
        huge[66..72].copy_from_slice(&[255; 6]);
        assert_eq!(Question::read(&huge), None, "a house of 65535 voxels a side");
    }

    #[test]
    fn runs_do_not_share_their_name() {
        let names: std::collections::BTreeSet<String> = (0..1000).map(|_| RunId::new().to_string()).collect();
        assert!(names.len() > 990 && names.iter().all(|n| n.len() == 32), "{}", names.len());
    }
}
