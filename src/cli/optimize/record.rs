//! What a run keeps of every evaluation, and the record of the run itself.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Duration;

use houscaper::brief::Sense;
use houscaper::export::tables::{Cell, DesignRow, designs_csv};
use houscaper::search::massing::{Design, Infill};
use houscaper::search::proposal::Evaluated;
use houscaper::search::run::Outcome as Found;
use serde_json::json;
use sha2::{Digest, Sha256};

use super::Job;

/// Design variables in the order of their columns.
pub const VARIABLES: [&str; 13] = [
    "storeys",
    "footprint_cells",
    "upper_cells",
    "roof_rise",
    "windows",
    "doors",
    "stairs",
    "wall_section",
    "floor_section",
    "beam_section",
    "roof_section",
    "joist_axes",
    "wall_boards",
];

/// Rows and times of a run.
pub struct Record {
    rows: Vec<DesignRow>,
    batches: Vec<(usize, Duration)>,
    /// The least infeasible design, while none is feasible.
    pub nearest: Option<(f64, Design)>,
    /// Seconds of the search.
    pub search_seconds: f64,
    /// Seconds of everything.
    pub total_seconds: f64,
}

impl Record {
    /// An empty record.
    pub fn new(job: &Job) -> Self {
        Record {
            rows: Vec::with_capacity(job.evaluator.brief.search.evaluations.min(1 << 20)),
            batches: Vec::new(),
            nearest: None,
            search_seconds: 0.0,
            total_seconds: 0.0,
        }
    }

    /// Adds an evaluation, in index order.
    pub fn add(&mut self, job: &Job, one: &Evaluated) {
        let feasible = one.score.is_feasible();
        if !feasible && self.nearest.as_ref().is_none_or(|(v, _)| one.score.violation < *v) {
            self.nearest = Some((one.score.violation, one.candidate.design.clone()));
        }
        self.rows.push(DesignRow {
            id: one.candidate.id,
            generation: u64::from(one.candidate.generation),
            feasible,
            violation: one.score.violation,
            objectives: natural(job, &one.score.objectives),
            variables: variables(job, &one.candidate.design),
        });
    }

    /// Closes a batch for the log.
    pub fn close_batch(&mut self, elapsed: Duration) {
        self.batches.push((self.rows.len(), elapsed));
    }

    /// All rows.
    pub fn rows(&self) -> &[DesignRow] {
        &self.rows
    }

    /// `evaluations.csv`.
    pub fn evaluations_csv(&self, job: &Job) -> String {
        let names: Vec<&str> = job.evaluator.brief.objectives.iter().map(|g| g.objective.name()).collect();
        designs_csv(&names, &VARIABLES, &self.rows)
    }

    /// `log.json`: a block for each batch with its time and the feasible objective vectors found in it, minimised.
    pub fn log_json(&self, job: &Job) -> String {
        let goals = &job.evaluator.brief.objectives;
        let mut first = 0;
        let blocks: Vec<_> = self
            .batches
            .iter()
            .map(|&(end, elapsed)| {
                let rows = &self.rows[first..end];
                first = end;
                let minimised = |row: &DesignRow| -> Vec<f64> {
                    goals.iter().zip(&row.objectives).map(|(g, v)| g.minimised(*v)).collect()
                };
                let feasible: Vec<Vec<f64>> = rows.iter().filter(|r| r.feasible).map(minimised).collect();
                let infeasible = rows.len() - feasible.len();
                json!({"evals": end, "t": elapsed.as_secs_f64(), "f": feasible, "infeasible": infeasible})
            })
            .collect();
        json!({"program": "houscaper", "version": env!("CARGO_PKG_VERSION"), "log": blocks}).to_string()
    }

    /// `run.json`.
    pub fn run_json(&self, job: &Job, found: Option<&Found>) -> Vec<u8> {
        let evaluator = &job.evaluator;
        let books = &evaluator.books;
        let configs = |name: &str| job.paths.configs.join(name).to_string_lossy().into_owned();
        let counts = found.map(|f| {
            json!({"evaluations": f.progress.evaluations, "feasible": f.progress.feasible, "front": f.progress.front})
        });
        let value = json!({
            "schema": "houscaper.run/1",
            "status": if found.is_some() { "complete" } else { "running" },
            "version": env!("CARGO_PKG_VERSION"),
            "commit": env!("HOUSCAPER_COMMIT"),
            "seed": evaluator.brief.search.seed,
            "brief": evaluator.brief,
            "machine": {
                "os": std::env::consts::OS,
                "arch": std::env::consts::ARCH,
                "cores": std::thread::available_parallelism().map_or(1, |n| n.get()),
                "threads": rayon::current_num_threads(),
            },
            "hashes": {
                "prices": file_hash(&books.prices.file),
                "prices_extended": books.prices.extended.iter().map(|f| file_hash(f)).collect::<Vec<_>>(),
                "carbon": file_hash(&books.carbon.file),
                "buildups": file_hash(&books.buildups.file),
                "materials": file_hash(&configs("materials.json")),
                "sections": file_hash(&configs("sections.json")),
                "loads": file_hash(&configs("loads.json")),
                "given": evaluator.brief.given.as_ref().map(|g| file_hash(&job.paths.brief.join(&g.lattice).to_string_lossy())),
                "tileset": folder_hash(&job.paths.tileset),
                "linear": folder_hash(&job.paths.linear),
            },
            "price_book": {"version": books.prices.version, "date": books.prices.date},
            "counts": counts,
            "hypervolume": found.map(|f| json!({
                "reference": f.reference,
                "box": f.progress.box_volume,
                "value": f.progress.hypervolume,
                "relative": f.progress.relative_hypervolume(),
            })),
            "seconds": {"search": self.search_seconds, "total": self.total_seconds},
        });
        let mut text = serde_json::to_string_pretty(&value).unwrap_or_default();
        text.push('\n');
        text.into_bytes()
    }
}

fn file_hash(path: &str) -> Option<String> {
    Some(digest_text(Sha256::digest(std::fs::read(path).ok()?).as_slice()))
}

/// Hash of the files of a folder, by name and content, in the order of their names.
fn folder_hash(folder: &Path) -> Option<String> {
    let mut names: Vec<_> =
        std::fs::read_dir(folder).ok()?.flatten().map(|e| e.path()).filter(|p| p.is_file()).collect();
    names.sort();
    let mut hash = Sha256::new();
    for path in names {
        hash.update(path.file_name()?.as_encoded_bytes());
        hash.update([0]);
        hash.update(std::fs::read(&path).ok()?);
        hash.update([0]);
    }
    Some(digest_text(hash.finalize().as_slice()))
}

fn digest_text(digest: &[u8]) -> String {
    digest.iter().fold(String::from("sha256:"), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// Objectives in their own sense, as the tables have them.
pub fn natural(job: &Job, minimised: &[f64]) -> Vec<f64> {
    let goals = &job.evaluator.brief.objectives;
    goals.iter().zip(minimised).map(|(g, v)| if g.sense == Sense::Max { -v } else { *v }).collect()
}

/// The design variables of a design, in the order of [`VARIABLES`].
pub fn variables(job: &Job, design: &Design) -> Vec<Cell> {
    let massing = &design.massing;
    let count = |infill: Infill| {
        let all = massing.storeys.iter().flat_map(|s| &s.openings);
        Cell::Count(all.filter(|o| o.infill == infill).count() as i64)
    };
    let cells = |storey: usize| massing.storeys.get(storey).map_or(0, |s| s.footprint.count()) as i64;
    let sections = job.evaluator.sections(&design.choices);
    let plates = massing.storeys.len();
    let axes: String = (0..plates).map(|p| if design.choices.joists_along_y(p) { 'y' } else { 'x' }).collect();
    let mut row = vec![
        Cell::Count(plates as i64),
        Cell::Count(cells(0)),
        Cell::Count(cells(1)),
        Cell::Count(massing.roof.rise() as i64),
        count(Infill::Window),
        count(Infill::Door),
        Cell::Count(massing.storeys.iter().filter(|s| s.stair.is_some()).count() as i64),
    ];
    row.extend(sections.iter().map(|s| Cell::Text(job.evaluator.catalogue.option_name(*s))));
    row.push(Cell::Text(axes));
    row.push(Cell::Text(job.evaluator.boards(&design.choices).name().to_owned()));
    row
}
