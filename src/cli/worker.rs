//! `houscaper worker`: evaluates the houses of runs on other machines.

use super::args::Worker;
use super::failure::Outcome;

/// What a build without the feature says.
#[cfg(not(feature = "queue"))]
pub fn not_built(what: &str) -> super::failure::Failure {
    super::failure::bad_input(format!(
        "{what}: this program was built without the queue; build it with `cargo build --release --features queue` (NATS client, about 3 minutes more)"
    ))
}

#[cfg(not(feature = "queue"))]
pub fn run(_: &Worker) -> Outcome {
    Err(not_built("worker"))
}

#[cfg(feature = "queue")]
pub fn run(args: &Worker) -> Outcome {
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::time::Duration;

    use houscaper::run::queue::{QueueError, Service, serve};

    use super::failure::{Failure, bad_input};

    static STOP: AtomicBool = AtomicBool::new(false);
    // Where signals cannot be watched the first one ends the program: its questions go to another worker.
    let _ = ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::SeqCst) {
            std::process::exit(130);
        }
        eprintln!("ending after the houses at hand");
    });
    let threads = args.threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, |n| n.get()));
    if threads == 0 {
        return Err(bad_input("--threads 0: expected at least 1"));
    }
    if args.idle_exit.is_some_and(|s| s.is_nan() || s <= 0.0) {
        return Err(bad_input("--idle-exit: expected a number of seconds above 0"));
    }
    let idle_exit = args.idle_exit.map(|s| Duration::from_secs_f64(s.min(1e9)));
    let service = Service { url: &args.url, threads, idle_exit, stop: &STOP, notice: &|text| eprintln!("{text}") };
    let served = serve(&service).map_err(|error| match error {
        QueueError::OtherBuild { .. } | QueueError::Parcel(_) => Failure::Input(error.into()),
        other => Failure::Run(other.into()),
    })?;
    eprintln!("{} houses in {} questions", served.houses, served.questions);
    Ok(())
}
