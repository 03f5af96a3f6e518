//! Evaluation on other machines through a NATS server with JetStream.
//!
//! ```text
//! coordinator                        server                                   any number of workers
//!   question --> houscaper.jobs.<build>.<run>     work queue, pull --> evaluates (progress every second), answers, then acknowledges
//!   answer  <--- houscaper.results.<run>          work queue, pull <--
//!   parcel  ---> bucket houscaper-parcels, object <run>            --> brief, books, tilesets: once per run, known by its SHA-256
//! ```
//!
//! A question holds a few houses ([`wire`]); its answer repeats run, ticket, place and a digest of the question, so that answers of a dead
//! run, repeated ones and garbage are told apart and dropped. A question that is not acknowledged within [`PATIENCE`] goes to another
//! worker; one that the server has lost is asked again. The searcher sees scores in the order of its batch and nothing else, so a run has
//! the same bytes as on one machine. Whether a worker computes the same last digits is not assumed: the [`parcel`] carries houses with
//! their scores, and a worker that finds others refuses.

pub mod parcel;
pub mod wire;

#[cfg(feature = "queue")]
mod courier;
#[cfg(feature = "queue")]
mod link;
#[cfg(feature = "queue")]
mod worker;

#[cfg(feature = "queue")]
pub use courier::{Courier, Traffic};
#[cfg(feature = "queue")]
pub use worker::{Served, Service, serve};

use std::time::Duration;

use crate::score::Evaluator;
use crate::search::Score;
use crate::voxels::{Choices, House};

/// Version of the messages; part of [`build`].
pub const WIRE: u32 = 1;

/// How long a worker may keep a question without a sign of life before it goes to another.
pub const PATIENCE: Duration = Duration::from_secs(5);

/// Workers that may begin a question without answering it before it is given up: what it asks ends them.
pub const MOST_DELIVERIES: i64 = 20;

/// Houses in one question unless asked otherwise.
pub const PER_QUESTION: usize = 4;

/// Why the queue could not do its work.
#[derive(Debug, thiserror::Error)]
pub enum QueueError {
    /// The server could not be reached, or refuses.
    #[error("queue {url}: {what}; expected a NATS server with JetStream (`nats-server -js`)")]
    Server {
        /// The server, without what would let one in.
        url: String,
        /// What it or the network said.
        what: String,
    },
    /// A house is larger than the server lets a message be.
    #[error(
        "a house takes {bytes} bytes in a message, the server allows {most}: raise max_payload in its configuration"
    )]
    TooLarge {
        /// Bytes of the message.
        bytes: usize,
        /// Bytes allowed.
        most: usize,
    },
    /// A worker could not evaluate.
    #[error("a worker could not evaluate houses {from} to {to} of a batch: {what}")]
    Worker {
        /// First house of the question in its batch.
        from: usize,
        /// Last house.
        to: usize,
        /// What the worker said.
        what: String,
    },
    /// Only jobs of other builds wait.
    #[error(
        "queue {url}: the jobs that wait there are of build {theirs}, this worker is of build {ours}: a run needs workers of its own version and commit"
    )]
    OtherBuild {
        /// The server.
        url: String,
        /// Builds of the jobs.
        theirs: String,
        /// Our own.
        ours: String,
    },
    /// The parcel of a run cannot be used.
    #[error(transparent)]
    Parcel(#[from] parcel::ParcelError),
    /// The thread that talks to the server ended.
    #[error("queue: the connection ended")]
    Ended,
}

/// The build of this program as a token of a subject: version, commit and version of the messages.
pub fn build() -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() || c == '-' { c } else { '_' };
    let text = format!("{}-{}-{WIRE}", env!("CARGO_PKG_VERSION"), env!("HOUSCAPER_COMMIT"));
    text.chars().map(plain).collect()
}

/// The score of a house: what a search is told of it.
pub fn score(evaluator: &Evaluator, house: &House, choices: &Choices) -> Score {
    let evaluation = evaluator.evaluate(house, choices);
    Score { objectives: evaluation.minimised(&evaluator.brief.objectives), violation: evaluation.violation }
}
