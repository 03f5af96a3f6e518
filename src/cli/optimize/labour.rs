//! Who evaluates the houses of a search: this machine, or workers behind a queue.

use houscaper::run::queue::score;
use houscaper::search::Score;
use houscaper::voxels::{Choices, House};
use rayon::prelude::*;

use super::Job;
use crate::cli::failure::Failure;

/// Evaluates batches of houses.
pub trait Labour {
    /// The scores of a batch in its order; `None` when the run is to be stopped before it is through.
    fn score(&self, batch: &[(&House, &Choices)]) -> anyhow::Result<Option<Vec<Score>>>;

    /// What to tell at the end.
    fn report(&self) {}
}

/// This machine, all its threads.
pub struct Here<'a>(pub &'a Job);

impl Labour for Here<'_> {
    fn score(&self, batch: &[(&House, &Choices)]) -> anyhow::Result<Option<Vec<Score>>> {
        Ok(Some(batch.par_iter().map(|(house, choices)| score(&self.0.evaluator, house, choices)).collect()))
    }
}

/// Whoever a job asks for.
pub fn of(job: &Job) -> Result<Box<dyn Labour + '_>, Failure> {
    match &job.args.queue {
        None => Ok(Box::new(Here(job))),
        Some(url) => queue::open(job, url),
    }
}

#[cfg(not(feature = "queue"))]
mod queue {
    use super::{Failure, Job, Labour};

    pub fn open<'a>(_: &'a Job, _: &str) -> Result<Box<dyn Labour + 'a>, Failure> {
        Err(crate::cli::worker::not_built("--queue"))
    }
}

#[cfg(feature = "queue")]
mod queue {
    use std::time::{Duration, Instant};

    use houscaper::run::queue::Courier;
    use houscaper::run::queue::parcel::Parcel;
    use houscaper::search::massing::encode;
    use houscaper::search::start::start;

    use super::super::stop;
    use super::{Choices, Failure, House, Job, Labour, Score};
    use crate::cli::failure::Blame;

    /// Houses by which a worker shows that it finds what this machine finds.
    const PROOFS: u64 = 3;

    struct Queue {
        courier: Courier,
        until: Option<Instant>,
    }

    pub fn open<'a>(job: &'a Job, url: &str) -> Result<Box<dyn Labour + 'a>, Failure> {
        let proof = |seed| {
            let mut rng: rand_chacha::ChaCha8Rng = rand::SeedableRng::seed_from_u64(seed);
            let design = start(&job.space, &mut rng).ok()?;
            Some((encode(&design.massing, &job.space.plot), design.choices))
        };
        let proofs: Vec<(House, Choices)> = (0..PROOFS).filter_map(proof).collect();
        let parcel = Parcel::pack(&job.evaluator, &job.paths, &proofs).input()?;
        // What a worker will do, done here first: a parcel that lacks a file is our error, not theirs.
        parcel.load().input()?;
        let notice = Box::new(|text: &str| eprintln!("{text}"));
        let courier = Courier::open(url, &parcel, job.args.per_question, notice).run()?;
        let until = job.args.time_limit.map(|s| Instant::now() + Duration::from_secs_f64(s));
        Ok(Box::new(Queue { courier, until }))
    }

    impl Labour for Queue {
        fn score(&self, batch: &[(&House, &Choices)]) -> anyhow::Result<Option<Vec<Score>>> {
            let houses = batch.iter().map(|(house, choices)| ((*house).clone(), **choices)).collect();
            let go_on = || !stop::asked() && self.until.is_none_or(|until| Instant::now() < until);
            Ok(self.courier.score(houses, &go_on)?)
        }

        fn report(&self) {
            let t = self.courier.traffic();
            let per = |bytes: u64| bytes as f64 / t.houses.max(1) as f64;
            eprintln!(
                "queue: {} houses in {} questions ({:.0} bytes a house out, {:.0} back), {:.3} ms of work a house, {} answers dropped",
                t.houses,
                t.questions,
                per(t.question_bytes),
                per(t.answer_bytes),
                1e-3 * t.work_micros as f64 / t.houses.max(1) as f64,
                t.dropped
            );
        }
    }
}
