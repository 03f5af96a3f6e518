//! The searches on problems that others have solved: discrete ones with exactly known fronts (LOTZ, knapsacks, rho-MNK, mUBQP), and
//! real-coded ones against the distributions of hypervolumes that pymoo reaches. Files of the reference folder; without it, skipped.

#[path = "search_reference/bits.rs"]
mod bits;
#[path = "search_reference/reals.rs"]
mod reals;

use std::path::PathBuf;

use houscaper::search::Score;
use houscaper::search::archive::Archive;
use houscaper::search::domain::Domain;
use houscaper::search::proposal::{Evaluated, EvaluatedOf};
use houscaper::search::run::Searcher;
use serde_json::Value;

/// The reference folder, `None` (and said so) where it is not there.
fn folder(test: &str) -> Option<PathBuf> {
    let found = std::env::var_os("HOUSCAPER_SHARED").map(|s| PathBuf::from(s).join("reference/search"));
    let found = found.filter(|f| f.is_dir());
    if found.is_none() {
        println!("{test}: skipped, no reference/search below HOUSCAPER_SHARED");
    }
    found
}

fn read(path: &std::path::Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).expect("a reference file")).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|v| v.as_f64().expect("a number")).collect()
}

fn rows(value: &Value) -> Vec<Vec<f64>> {
    value.as_array().expect("a list").iter().map(numbers).collect()
}

/// Lets a searcher evaluate so many designs; returns the archive of all of them.
fn explore<D: Domain>(
    searcher: &mut dyn Searcher<D>,
    score: &(dyn Fn(&D::Genome) -> Score + Sync),
    evaluations: usize,
) -> (Archive<()>, usize) {
    let mut archive = Archive::new();
    let mut done = 0;
    while done < evaluations {
        let batch = searcher.ask(evaluations - done);
        if batch.is_empty() {
            break;
        }
        let told: Vec<EvaluatedOf<D>> =
            batch.into_iter().map(|candidate| Evaluated { score: score(&candidate.genome), candidate }).collect();
        told.iter().for_each(|e| {
            archive.offer(e.candidate.id, &e.score, || ());
        });
        done += told.len();
        searcher.tell(&told);
    }
    (archive, done)
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    (sorted[(sorted.len() - 1) / 2] + sorted[sorted.len() / 2]) / 2.0
}
