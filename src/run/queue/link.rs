//! The connection to the server and the streams on it, the same for coordinators and workers.

use std::time::{Duration, Instant};

use async_nats::jetstream::consumer::{AckPolicy, Consumer, pull};
use async_nats::jetstream::object_store::{self, ObjectStore};
use async_nats::jetstream::stream::{self, RetentionPolicy, StorageType, Stream};
use async_nats::{Client, ConnectErrorKind, ConnectOptions, jetstream};
use tokio::io::AsyncReadExt;

use super::parcel::MOST_BYTES;
use super::wire::RunId;
use super::{PATIENCE, QueueError, build};

/// Stream of the questions.
const JOBS: &str = "HOUSCAPER_JOBS";
/// Stream of the answers.
const RESULTS: &str = "HOUSCAPER_RESULTS";
/// Bucket of the parcels.
const PARCELS: &str = "houscaper-parcels";
/// Bytes that wait in a stream at most: a batch takes far less, and the server may be a small one.
const MOST_WAITING: i64 = 64 << 20;
/// What nobody has taken after so long belongs to a dead run; a living one asks again.
const OLDEST: Duration = Duration::from_secs(600);
/// Parcels are kept so long after they were put down; a living run puts its own down again.
const OLDEST_PARCEL: Duration = Duration::from_secs(7 * 24 * 3600);

/// How long a server may take to start: in a job array it begins together with its workers.
const STARTING: Duration = Duration::from_secs(4);

/// A connection.
#[derive(Clone)]
pub struct Link {
    url: String,
    /// To publish and count with.
    pub client: Client,
    context: jetstream::Context,
}

/// A server address without user, password or token.
fn without_secrets(url: &str) -> String {
    match (url.find("://"), url.rfind('@')) {
        (Some(scheme), Some(at)) if at > scheme => format!("{}{}", &url[..scheme + 3], &url[at + 1..]),
        (None, Some(at)) => url[at + 1..].to_owned(),
        _ => url.to_owned(),
    }
}

impl Link {
    /// Connects; a server that is still starting is asked again for [`STARTING`], and later losses of the connection are mended by the
    /// client itself.
    pub async fn open(url: &str) -> Result<Link, QueueError> {
        let shown = without_secrets(url);
        let failed = |e: async_nats::ConnectError| QueueError::Server { url: shown.clone(), what: e.to_string() };
        let until = Instant::now() + STARTING;
        let client = loop {
            let options = ConnectOptions::new().name("houscaper").connection_timeout(Duration::from_secs(5));
            match options.connect(url).await {
                Ok(client) => break client,
                Err(e) if e.kind() != ConnectErrorKind::Io || Instant::now() >= until => return Err(failed(e)),
                Err(_) => tokio::time::sleep(STARTING / 20).await,
            }
        };
        let context = jetstream::new(client.clone());
        let link = Link { url: shown, client, context };
        link.streams().await?;
        Ok(link)
    }

    /// The server, for people.
    pub fn url(&self) -> &str {
        &self.url
    }

    /// An error of the server.
    pub fn error(&self, what: impl std::fmt::Display) -> QueueError {
        QueueError::Server { url: self.url.clone(), what: what.to_string() }
    }

    /// The streams of questions and answers, made where they are missing.
    pub async fn streams(&self) -> Result<(Stream, Stream), QueueError> {
        let config = |name: &str, subject: &str| stream::Config {
            name: name.into(),
            subjects: vec![subject.into()],
            retention: RetentionPolicy::WorkQueue,
            max_age: OLDEST,
            max_bytes: MOST_WAITING,
            storage: StorageType::File,
            duplicate_window: Duration::from_secs(60),
            ..Default::default()
        };
        let get = async |name, subject| {
            self.context.get_or_create_stream(config(name, subject)).await.map_err(|e| self.error(e))
        };
        Ok((get(JOBS, "houscaper.jobs.>").await?, get(RESULTS, "houscaper.results.>").await?))
    }

    /// The consumer that all workers of this build share.
    pub async fn jobs(&self) -> Result<Consumer<pull::Config>, QueueError> {
        let name = format!("workers-{}", build());
        let config = pull::Config {
            durable_name: Some(name.clone()),
            filter_subject: format!("houscaper.jobs.{}.>", build()),
            ack_policy: AckPolicy::Explicit,
            ack_wait: PATIENCE,
            max_ack_pending: 100_000,
            inactive_threshold: OLDEST_PARCEL,
            ..Default::default()
        };
        self.streams().await?.0.get_or_create_consumer(&name, config).await.map_err(|e| self.error(e))
    }

    /// The consumer of the answers to a run.
    pub async fn results(&self, run: RunId) -> Result<Consumer<pull::Config>, QueueError> {
        let name = format!("run-{run}");
        let config = pull::Config {
            durable_name: Some(name.clone()),
            filter_subject: result_subject(run),
            ack_policy: AckPolicy::Explicit,
            ack_wait: PATIENCE,
            max_ack_pending: 100_000,
            inactive_threshold: OLDEST,
            ..Default::default()
        };
        self.streams().await?.1.get_or_create_consumer(&name, config).await.map_err(|e| self.error(e))
    }

    /// Publishes and waits until the server has it.
    pub async fn put(&self, subject: String, bytes: Vec<u8>) -> Result<(), QueueError> {
        let sent = self.context.publish(subject, bytes.into()).await.map_err(|e| self.error(e))?;
        sent.await.map_err(|e| self.error(e)).map(drop)
    }

    /// Publishes several at once and waits until the server has all.
    pub async fn put_all(&self, subject: &str, all: Vec<Vec<u8>>) -> Result<(), QueueError> {
        let mut sent = Vec::with_capacity(all.len());
        for bytes in all {
            sent.push(self.context.publish(subject.to_owned(), bytes.into()).await.map_err(|e| self.error(e))?);
        }
        for one in sent {
            one.await.map_err(|e| self.error(e))?;
        }
        Ok(())
    }

    /// Questions that wait or are being worked at, by build and run.
    pub async fn waiting(&self, filter: &str) -> Result<Vec<(String, usize)>, QueueError> {
        use futures_util::TryStreamExt;
        let jobs = self.streams().await?.0;
        let subjects = jobs.info_with_subjects(filter).await.map_err(|e| self.error(e))?;
        subjects.try_collect().await.map_err(|e| self.error(e))
    }

    /// Drops what waits of a run, and its parcel.
    pub async fn clear(&self, run: RunId) -> Result<(), QueueError> {
        let (jobs, results) = self.streams().await?;
        jobs.purge().filter(job_subject(run)).await.map_err(|e| self.error(e))?;
        results.purge().filter(result_subject(run)).await.map_err(|e| self.error(e))?;
        results.delete_consumer(&format!("run-{run}")).await.map_err(|e| self.error(e))?;
        self.parcels().await?.delete(run.to_string()).await.map_err(|e| self.error(e))
    }

    async fn parcels(&self) -> Result<ObjectStore, QueueError> {
        if let Ok(store) = self.context.get_object_store(PARCELS).await {
            return Ok(store);
        }
        let config = object_store::Config { bucket: PARCELS.into(), max_age: OLDEST_PARCEL, ..Default::default() };
        self.context.create_object_store(config).await.map_err(|e| self.error(e))
    }

    /// Puts the parcel of a run down, unless it is there.
    pub async fn put_parcel(&self, run: RunId, bytes: &[u8]) -> Result<(), QueueError> {
        let store = self.parcels().await?;
        if store.info(run.to_string()).await.is_ok() {
            return Ok(());
        }
        store.put(run.to_string().as_str(), &mut &bytes[..]).await.map_err(|e| self.error(e)).map(drop)
    }

    /// The parcel of a run.
    pub async fn parcel(&self, run: RunId) -> Result<Vec<u8>, QueueError> {
        let object = self.parcels().await?.get(run.to_string()).await.map_err(|e| self.error(e))?;
        let mut bytes = Vec::new();
        object.take(MOST_BYTES as u64 + 1).read_to_end(&mut bytes).await.map_err(|e| self.error(e))?;
        Ok(bytes)
    }
}

/// Subject of a run's questions.
pub fn job_subject(run: RunId) -> String {
    format!("houscaper.jobs.{}.{run}", build())
}

/// Subject of a run's answers.
pub fn result_subject(run: RunId) -> String {
    format!("houscaper.results.{run}")
}

#[cfg(test)]
mod tests {
    #[test]
    fn an_address_is_shown_without_what_lets_one_in() {
        for (url, shown) in [
            ("nats://host:4222", "nats://host:4222"),
            ("nats://me:secret@host", "nats://host"),
            ("token@host:4222", "host:4222"),
            ("tls://a:b@c@host", "tls://host"),
        ] {
            assert_eq!(super::without_secrets(url), shown);
        }
    }
}
