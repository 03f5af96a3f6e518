//! The coordinator's side: asks, waits, puts answers in their places.
//!
//! One thread with one runtime talks to the server, so that the search itself knows nothing of either.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, mpsc};
use std::time::{Duration, Instant};

use async_nats::jetstream::consumer::pull;
use futures_util::StreamExt;
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};

use super::link::{Link, job_subject};
use super::parcel::{Parcel, digest as parcel_digest};
use super::wire::{Answer, MOST_HOUSES, Question, RunId, digest};
use super::{PATIENCE, QueueError};
use crate::search::Score;
use crate::voxels::{Choices, House};

/// How often a silent queue is looked at.
const LOOK: Duration = Duration::from_secs(2);
/// Silence after which a person is told that nobody works.
const SILENCE: Duration = Duration::from_secs(10);

/// What went through the queue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Houses scored.
    pub houses: u64,
    /// Questions sent, those asked again included.
    pub questions: u64,
    /// Their bytes.
    pub question_bytes: u64,
    /// Answers that were wanted.
    pub answers: u64,
    /// Their bytes.
    pub answer_bytes: u64,
    /// Answers dropped: repeated, of another run, or no answer at all.
    pub dropped: u64,
    /// Time that workers spent on evaluations, microseconds.
    pub work_micros: u64,
}

#[derive(Default)]
struct Counts([AtomicU64; 7]);

impl Counts {
    fn add(&self, at: usize, n: u64) {
        self.0[at].fetch_add(n, Ordering::Relaxed);
    }

    fn read(&self) -> Traffic {
        let [houses, questions, question_bytes, answers, answer_bytes, dropped, work_micros] =
            std::array::from_fn(|i| self.0[i].load(Ordering::Relaxed));
        Traffic { houses, questions, question_bytes, answers, answer_bytes, dropped, work_micros }
    }
}

/// Scores in their places, filled as they come.
type Reply = Result<Vec<Score>, QueueError>;

struct Batch {
    houses: Vec<(House, Choices)>,
    reply: mpsc::Sender<Reply>,
}

/// Asks workers through a server.
pub struct Courier {
    batches: Option<UnboundedSender<Batch>>,
    thread: Option<std::thread::JoinHandle<()>>,
    counts: Arc<Counts>,
}

/// What the coordinator's thread works with.
struct Desk {
    link: Link,
    run: RunId,
    parcel: Vec<u8>,
    parcel_digest: [u8; 32],
    per_question: usize,
    counts: Arc<Counts>,
    notice: Box<dyn Fn(&str) + Send>,
    ticket: u64,
    /// Questions without answer, by the place of their first house.
    open: BTreeMap<u32, (Vec<u8>, usize)>,
    /// The batch that is asked for, and its scores so far.
    asked: Option<(mpsc::Sender<Reply>, Vec<Score>)>,
    /// Last sign of life.
    heard: Instant,
    /// Whether a person was told of the silence.
    told: bool,
}

impl Courier {
    /// Connects to the server at `url`, puts the parcel down and is ready to ask; `per_question` houses go in one message, and `notice`
    /// hears what a person should know.
    ///
    /// # Errors
    /// [`QueueError`] when the server cannot be reached or has no JetStream.
    pub fn open(
        url: &str,
        parcel: &Parcel,
        per_question: usize,
        notice: Box<dyn Fn(&str) + Send>,
    ) -> Result<Courier, QueueError> {
        let (batches, inbox) = unbounded_channel();
        let (ready, opened) = mpsc::channel();
        let counts = Arc::new(Counts::default());
        let (url, parcel, kept) = (url.to_owned(), parcel.bytes(), counts.clone());
        let thread = std::thread::spawn(move || {
            let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
            let runtime = match runtime {
                Ok(runtime) => runtime,
                Err(e) => return drop(ready.send(Err(QueueError::Server { url, what: e.to_string() }))),
            };
            runtime.block_on(async {
                let run = RunId::new();
                let started = async {
                    let link = Link::open(&url).await?;
                    link.put_parcel(run, &parcel).await?;
                    link.results(run).await?;
                    Ok(link)
                };
                let link = match started.await {
                    Ok(link) => link,
                    Err(e) => return drop(ready.send(Err(e))),
                };
                let _ = ready.send(Ok(()));
                let parcel_digest = parcel_digest(&parcel);
                let (ticket, open, asked) = (0, BTreeMap::new(), None);
                let per_question = per_question.clamp(1, MOST_HOUSES);
                let (heard, told, counts) = (Instant::now(), false, kept);
                let mut desk = Desk {
                    link,
                    run,
                    parcel,
                    parcel_digest,
                    per_question,
                    counts,
                    notice,
                    ticket,
                    open,
                    asked,
                    heard,
                    told,
                };
                desk.work(inbox).await;
                // Best effort: what stays is dropped by its age.
                let _ = tokio::time::timeout(Duration::from_secs(5), desk.link.clear(run)).await;
            });
        });
        match opened.recv() {
            Ok(Ok(())) => Ok(Courier { batches: Some(batches), thread: Some(thread), counts }),
            Ok(Err(e)) => Err(e),
            Err(_) => Err(QueueError::Ended),
        }
    }

    /// The scores of houses in their order, from any worker; `None` when `go_on` (asked now and then) said to stop before all were there.
    ///
    /// # Errors
    /// [`QueueError`]: a worker that cannot evaluate, a house too large for a message, a thread that ended.
    pub fn score(
        &self,
        houses: Vec<(House, Choices)>,
        go_on: &dyn Fn() -> bool,
    ) -> Result<Option<Vec<Score>>, QueueError> {
        if houses.is_empty() {
            return Ok(Some(Vec::new()));
        }
        let (reply, answer) = mpsc::channel();
        let batches = self.batches.as_ref().ok_or(QueueError::Ended)?;
        batches.send(Batch { houses, reply }).map_err(|_| QueueError::Ended)?;
        loop {
            match answer.recv_timeout(Duration::from_millis(100)) {
                Ok(reply) => return reply.map(Some),
                Err(mpsc::RecvTimeoutError::Timeout) if go_on() => {}
                Err(mpsc::RecvTimeoutError::Timeout) => return Ok(None),
                Err(mpsc::RecvTimeoutError::Disconnected) => return Err(QueueError::Ended),
            }
        }
    }

    /// What went through the queue so far.
    pub fn traffic(&self) -> Traffic {
        self.counts.read()
    }
}

impl Drop for Courier {
    fn drop(&mut self) {
        self.batches = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl Desk {
    async fn work(&mut self, mut inbox: UnboundedReceiver<Batch>) {
        let mut answers: Option<pull::Stream> = None;
        let mut look = tokio::time::interval(LOOK);
        look.set_missed_tick_behavior(tokio::time::MissedTickBehavior::Delay);
        loop {
            if answers.is_none() {
                answers = self.answers().await;
            }
            let next = async {
                match &mut answers {
                    Some(stream) => stream.next().await,
                    // The look that follows opens the stream again.
                    None => std::future::pending().await,
                }
            };
            tokio::select! {
                batch = inbox.recv() => match batch {
                    Some(batch) => self.ask(batch).await,
                    None => return,
                },
                message = next => match message {
                    Some(Ok(message)) => {
                        self.take(&message.payload);
                        let _ = message.ack().await;
                    }
                    Some(Err(_)) | None => answers = None,
                },
                _ = look.tick() => self.look().await,
            }
        }
    }

    async fn answers(&self) -> Option<pull::Stream> {
        let consumer = self.link.results(self.run).await.ok()?;
        consumer.stream().max_messages_per_batch(256).expires(Duration::from_secs(30)).messages().await.ok()
    }

    /// Asks for a batch. One that was asked for before is given up: its coordinator waits no more.
    async fn ask(&mut self, batch: Batch) {
        self.ticket += 1;
        self.open.clear();
        self.heard = Instant::now();
        let most = self.link.client.max_payload();
        let mut parts: Vec<(usize, &[(House, Choices)])> = Vec::new();
        batch.houses.chunks(self.per_question).enumerate().for_each(|(n, p)| parts.push((n * self.per_question, p)));
        // Shared out so that a smaller last question does not keep one worker waiting for another.
        parts.reverse();
        while let Some((first, houses)) = parts.pop() {
            let question = Question {
                run: self.run,
                parcel: self.parcel_digest,
                ticket: self.ticket,
                first: first as u32,
                houses: houses.to_vec(),
            };
            let bytes = question.bytes();
            match houses.len() {
                1 if bytes.len() > most => {
                    self.open.clear();
                    let _ = batch.reply.send(Err(QueueError::TooLarge { bytes: bytes.len(), most }));
                    return;
                }
                n if bytes.len() > most => {
                    let (left, right) = houses.split_at(n / 2);
                    parts.push((first + n / 2, right));
                    parts.push((first, left));
                }
                n => drop(self.open.insert(first as u32, (bytes, n))),
            }
        }
        self.asked = Some((batch.reply, vec![Score::default(); batch.houses.len()]));
        self.send().await;
    }

    /// Sends every open question.
    async fn send(&mut self) {
        let all: Vec<Vec<u8>> = self.open.values().map(|q| q.0.clone()).collect();
        self.counts.add(1, all.len() as u64);
        self.counts.add(2, all.iter().map(|q| q.len() as u64).sum());
        // A refusal mends itself: what the server does not have is asked again after a while.
        let _ = self.link.put_all(&job_subject(self.run), all).await;
    }

    /// Puts an answer in its place; what is not wanted is dropped.
    fn take(&mut self, bytes: &[u8]) {
        let answer = Answer::read(bytes).filter(|a| a.run == self.run && a.ticket == self.ticket);
        let open = answer.as_ref().and_then(|a| self.open.get(&a.first));
        let (Some(answer), Some((question, count)), Some((reply, scores))) = (answer, open, &mut self.asked) else {
            return self.counts.add(5, 1);
        };
        if answer.question != digest(question) || answer.scores.as_ref().is_ok_and(|s| s.len() != *count) {
            return self.counts.add(5, 1);
        }
        let (first, count) = (answer.first as usize, *count);
        self.heard = Instant::now();
        self.told = false;
        for (at, n) in [(0, count as u64), (3, 1), (4, bytes.len() as u64), (6, answer.micros)] {
            self.counts.add(at, n);
        }
        match answer.scores {
            Ok(found) => {
                scores[first..first + count].clone_from_slice(&found);
                self.open.remove(&answer.first);
            }
            Err(what) => {
                let failed = QueueError::Worker { from: first, to: first + count - 1, what };
                let _ = reply.send(Err(failed));
                (self.asked, self.open) = (None, BTreeMap::new());
            }
        }
        if self.open.is_empty()
            && let Some((reply, scores)) = self.asked.take()
        {
            let _ = reply.send(Ok(scores));
        }
    }

    /// After a silence: makes sure that the server has streams, parcel and questions.
    async fn look(&mut self) {
        let silent = self.heard.elapsed();
        if self.open.is_empty() || silent < LOOK + PATIENCE {
            return;
        }
        let waiting = async {
            self.link.put_parcel(self.run, &self.parcel).await?;
            self.link.waiting(&job_subject(self.run)).await
        };
        let waiting = tokio::time::timeout(PATIENCE, waiting).await;
        let text = match &waiting {
            Ok(Ok(_)) => "no worker answers: start some with `houscaper worker`".to_owned(),
            Ok(Err(e)) => e.to_string(),
            Err(_) => "the server does not answer".to_owned(),
        };
        if silent > SILENCE && !self.told {
            self.told = true;
            (self.notice)(&format!(
                "queue {}: {text}; waiting (Ctrl-C ends the run, `resume --queue` carries on)",
                self.link.url()
            ));
        }
        // A question stays in the stream until a worker has answered it; if none is there, they were lost.
        if matches!(&waiting, Ok(Ok(subjects)) if subjects.iter().all(|s| s.1 == 0)) {
            self.send().await;
        }
    }
}
