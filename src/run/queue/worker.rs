//! The worker's side: takes questions one by one, evaluates, answers, then acknowledges.

use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use async_nats::jetstream::{AckKind, Message};
use futures_util::StreamExt;
use tokio::sync::{Mutex, Semaphore};

use super::link::{Link, result_subject};
use super::parcel::{Parcel, ParcelError, digest as parcel_digest};
use super::wire::{Answer, Question, RunId, digest};
use super::{MOST_DELIVERIES, PATIENCE, QueueError, build, score};
use crate::score::Evaluator;

/// How long the server keeps a request for a question open.
const EXPIRES: Duration = Duration::from_secs(2);
/// Runs whose evaluators are kept.
const MOST_RUNS: usize = 4;

/// How a worker serves.
pub struct Service<'a> {
    /// The server.
    pub url: &'a str,
    /// Evaluations at a time.
    pub threads: usize,
    /// Time without a question after which it ends; never when `None`.
    pub idle_exit: Option<Duration>,
    /// Set to end after the questions at hand.
    pub stop: &'a AtomicBool,
    /// Hears what a person should know.
    pub notice: &'a (dyn Fn(&str) + Sync),
}

/// What a worker has done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Served {
    /// Questions answered.
    pub questions: u64,
    /// Houses in them.
    pub houses: u64,
}

struct State<'a> {
    service: &'a Service<'a>,
    link: Link,
    own: u64,
    /// Evaluators by the digest of their parcel, the latest last.
    known: Mutex<VecDeque<([u8; 32], Arc<Evaluator>)>>,
    /// One more question is held than evaluated, so that the way to the server costs no time.
    seats: Semaphore,
    questions: AtomicU64,
    houses: AtomicU64,
    /// Milliseconds since `began` at the last question.
    last: AtomicU64,
    began: Instant,
}

/// Serves until told to stop.
///
/// # Errors
/// [`QueueError`]: no server, jobs of other builds only, a parcel that cannot be loaded or whose scores are others here.
pub fn serve(service: &Service) -> Result<Served, QueueError> {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
    let runtime = runtime.map_err(|e| QueueError::Server { url: service.url.into(), what: e.to_string() })?;
    runtime.block_on(async {
        let link = Link::open(service.url).await?;
        (service.notice)(&format!("worker of build {}: waiting at {}", build(), link.url()));
        let own = u64::from_le_bytes(std::array::from_fn(|i| RunId::new().0[i]));
        let (known, seats, began) = (Mutex::default(), Semaphore::new(service.threads), Instant::now());
        let (questions, houses, last) = Default::default();
        let state = State { service, link, own, known, seats, questions, houses, last, began };
        let seats = (0..=service.threads).map(|_| state.take_questions());
        futures_util::future::try_join_all(seats).await?;
        let count = |n: &AtomicU64| n.load(Ordering::Relaxed);
        Ok(Served { questions: count(&state.questions), houses: count(&state.houses) })
    })
}

impl State<'_> {
    fn idle(&self) -> Duration {
        self.began.elapsed().saturating_sub(Duration::from_millis(self.last.load(Ordering::Relaxed)))
    }

    fn is_done(&self) -> bool {
        let idle = self.service.idle_exit.is_some_and(|most| self.idle() >= most);
        idle || self.service.stop.load(Ordering::Relaxed)
    }

    async fn take_questions(&self) -> Result<(), QueueError> {
        let mut consumer = None;
        while !self.is_done() {
            if consumer.is_none() {
                consumer = self.link.jobs().await.ok();
            }
            let Some(jobs) = &consumer else {
                // The server is away: the client mends the connection, we ask again.
                tokio::time::sleep(EXPIRES / 4).await;
                continue;
            };
            let expires = self.service.idle_exit.map_or(EXPIRES, |most| most.clamp(EXPIRES / 10, EXPIRES));
            let batch = jobs.batch().max_messages(1).expires(expires).messages().await;
            match batch {
                Ok(mut batch) => match batch.next().await {
                    Some(Ok(message)) => self.answer(&message).await?,
                    Some(Err(_)) => consumer = None,
                    None => self.look_around().await?,
                },
                Err(_) => {
                    consumer = None;
                    tokio::time::sleep(EXPIRES / 4).await;
                }
            }
        }
        Ok(())
    }

    /// With nothing to do: refuses where only jobs of other builds wait.
    async fn look_around(&self) -> Result<(), QueueError> {
        if self.questions.load(Ordering::Relaxed) > 0 {
            return Ok(());
        }
        let Ok(waiting) = self.link.waiting("houscaper.jobs.>").await else { return Ok(()) };
        let token = |subject: &str| subject.split('.').nth(2).unwrap_or("?").to_owned();
        let mut theirs: Vec<String> = waiting.iter().filter(|w| w.1 > 0).map(|w| token(&w.0)).collect();
        theirs.sort();
        theirs.dedup();
        if theirs.is_empty() || theirs.contains(&build()) {
            return Ok(());
        }
        Err(QueueError::OtherBuild { url: self.link.url().into(), theirs: theirs.join(", "), ours: build() })
    }

    async fn answer(&self, message: &Message) -> Result<(), QueueError> {
        self.last.store(self.began.elapsed().as_millis() as u64, Ordering::Relaxed);
        let Some(question) = Question::read(&message.payload) else {
            // No question of ours: it is taken out of the queue.
            let _ = message.ack_with(AckKind::Term).await;
            return Ok(());
        };
        let (run, ticket, first) = (question.run, question.ticket, question.first);
        let deliveries = message.info().map_or(0, |info| info.delivered);
        let found = if deliveries > MOST_DELIVERIES {
            Ok((0, Err(format!("{MOST_DELIVERIES} workers began it and none ended it"))))
        } else {
            let mut work = std::pin::pin!(self.work(question));
            let mut alive = tokio::time::interval(PATIENCE / 5);
            alive.tick().await;
            loop {
                tokio::select! {
                    found = &mut work => break found,
                    _ = alive.tick() => drop(message.ack_with(AckKind::Progress).await),
                }
            }
        };
        let (micros, scores) = match found {
            Ok(found) => found,
            Err(Trouble::Gone) => {
                // The parcel is not there: the run is dead, or puts it down again and then this comes back.
                let _ = message.ack_with(AckKind::Nak(Some(PATIENCE))).await;
                return Ok(());
            }
            Err(Trouble::Own(error)) => {
                // Our own trouble: somebody else may do it. Asked anew, so that it does not count as begun and not ended.
                let again = self.link.put(message.subject.to_string(), message.payload.to_vec()).await;
                let kind = again.map_or(AckKind::Nak(None), |()| AckKind::Ack);
                let _ = message.ack_with(kind).await;
                let _ = self.link.client.flush().await;
                return Err(error.into());
            }
        };
        let houses = scores.as_ref().map_or(0, Vec::len);
        let question = digest(&message.payload);
        let answer = Answer { run, ticket, first, question, worker: self.own, micros, scores };
        if self.link.put(result_subject(run), answer.bytes()).await.is_ok() {
            let _ = message.ack().await;
            self.questions.fetch_add(1, Ordering::Relaxed);
            self.houses.fetch_add(houses as u64, Ordering::Relaxed);
        }
        self.last.store(self.began.elapsed().as_millis() as u64, Ordering::Relaxed);
        Ok(())
    }

    /// Evaluates; microseconds and scores, or why there are none.
    async fn work(&self, question: Question) -> Result<Work, Trouble> {
        let evaluator = self.evaluator(question.run, question.parcel).await?;
        let Ok(_seat) = self.seats.acquire().await else { return Err(Trouble::Gone) };
        let evaluate = move || {
            let started = Instant::now();
            let scores = question.houses.iter().map(|(house, choices)| score(&evaluator, house, choices)).collect();
            (started.elapsed().as_micros() as u64, scores)
        };
        match tokio::task::spawn_blocking(evaluate).await {
            Ok((micros, scores)) => Ok((micros, Ok(scores))),
            Err(panic) => Ok((0, Err(format!("the evaluation broke off: {panic}")))),
        }
    }

    async fn evaluator(&self, run: RunId, parcel: [u8; 32]) -> Result<Arc<Evaluator>, Trouble> {
        let mut known = self.known.lock().await;
        if let Some((_, evaluator)) = known.iter().find(|k| k.0 == parcel) {
            return Ok(evaluator.clone());
        }
        let Ok(bytes) = self.link.parcel(run).await else { return Err(Trouble::Gone) };
        let load = move || {
            if parcel_digest(&bytes) != parcel {
                return Err(ParcelError::Damaged("its SHA-256 is not the one that the run names"));
            }
            Parcel::read(&bytes)?.load()
        };
        let loaded = tokio::task::spawn_blocking(load).await;
        let evaluator = loaded.unwrap_or(Err(ParcelError::Damaged("reading it broke off"))).map_err(Trouble::Own)?;
        (self.service.notice)(&format!("serving run {run}: {}", evaluator.brief.name));
        let evaluator = Arc::new(evaluator);
        if known.len() >= MOST_RUNS {
            known.pop_front();
        }
        known.push_back((parcel, evaluator.clone()));
        Ok(evaluator)
    }
}

/// Microseconds of the evaluations, and scores or why there are none.
type Work = (u64, Result<Vec<crate::search::Score>, String>);

/// Why a question was not worked at.
enum Trouble {
    /// Its run cannot be found.
    Gone,
    /// This worker cannot serve it.
    Own(ParcelError),
}
