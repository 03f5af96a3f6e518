//! What a run keeps of every evaluation, and the record of the run itself.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use houscaper::brief::Sense;
use houscaper::export::tables::{Cell, DesignRow, design_line, designs_csv};
use houscaper::run::{FolderError, RunFolder, Table};
use houscaper::search::Score;
use houscaper::search::domain::Operator;
use houscaper::search::houses::Houses;
use houscaper::search::massing::{Design, Infill};
use houscaper::search::proposal::EvaluatedOf;
use houscaper::search::run::Stop;
use serde_json::json;
use sha2::{Digest, Sha256};

use super::even::EvenSample;
use super::faults::Faults;
use super::{Found, Job};

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

/// Feasible points that the plots show at most.
const MOST_SHOWN: usize = 20_000;

/// What a run keeps of its evaluations: the table on the disk, and here only what does not grow with it.
pub struct Record {
    table: Table,
    rows: String,
    /// Number of evaluations at the end of each batch.
    batches: Vec<u64>,
    count: u64,
    /// Objectives of feasible evaluations.
    cloud: EvenSample<Vec<f64>>,
    /// The least infeasible design, while none is feasible.
    pub nearest: Option<(f64, Design)>,
    /// Infeasible houses that are looked at again at the end.
    pub faults: Faults,
    /// By operator: evaluations, and feasible ones among them.
    pub children: BTreeMap<Operator, [u64; 2]>,
    /// Houses ruled out by what is known without a solve.
    pub screened: u64,
    /// Seconds of the search.
    pub search_seconds: f64,
    /// Seconds of everything.
    pub total_seconds: f64,
}

impl Record {
    /// An empty record, whose table begins in the run folder.
    pub fn begin(job: &Job, folder: &RunFolder) -> Result<Self, FolderError> {
        let names: Vec<&str> = job.evaluator.brief.objectives.iter().map(|g| g.objective.name()).collect();
        Ok(Record {
            table: Table::begin(folder, "evaluations.csv", &designs_csv(&names, &VARIABLES, &[]))?,
            rows: String::new(),
            batches: Vec::new(),
            count: 0,
            cloud: EvenSample::new(MOST_SHOWN),
            nearest: None,
            faults: Faults::default(),
            children: BTreeMap::new(),
            screened: 0,
            search_seconds: 0.0,
            total_seconds: 0.0,
        })
    }

    /// Adds an evaluation, in index order.
    pub fn add(&mut self, job: &Job, one: &EvaluatedOf<Houses<'_>>) {
        let feasible = one.score.is_feasible();
        if !feasible && self.nearest.as_ref().is_none_or(|(v, _)| one.score.violation < *v) {
            self.nearest = Some((one.score.violation, one.candidate.genome.clone()));
        }
        if !feasible {
            self.faults.add(self.count, &one.score, &one.candidate.genome);
        }
        let counts = self.children.entry(one.candidate.operator).or_default();
        counts[0] += 1;
        counts[1] += u64::from(feasible);
        let row = row(job, self.count, self.batches.len() as u64, &one.score, &one.candidate.genome);
        self.rows += &design_line(&row, job.evaluator.brief.objectives.len());
        self.count += 1;
        if feasible {
            self.cloud.offer(|| row.objectives);
        }
    }

    /// Closes a batch: its rows go to the table.
    pub fn close_batch(&mut self) -> Result<(), FolderError> {
        self.batches.push(self.count);
        self.table.append(&self.rows)?;
        self.rows.clear();
        Ok(())
    }

    /// Shows the table under its name, from now on as it grows.
    pub fn publish(&mut self) -> Result<(), FolderError> {
        self.table.publish()
    }

    /// Flushes the table to the disk.
    pub fn finish(&mut self) -> Result<(), FolderError> {
        self.table.finish()
    }

    /// Evaluations so far.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The batch of an evaluation.
    pub fn generation(&self, id: u64) -> u64 {
        self.batches.partition_point(|end| *end <= id) as u64
    }

    /// Objectives of feasible evaluations, in their own sense: all of them, or evenly many where there are very many.
    pub fn cloud(&self) -> &[Vec<f64>] {
        self.cloud.items()
    }

    /// `run.json`.
    pub fn run_json(job: &Job, done: Option<(&Record, &Found)>) -> Vec<u8> {
        let found = done.map(|d| d.1);
        let evaluator = &job.evaluator;
        let books = &evaluator.books;
        let counts = done.map(|(r, f)| {
            let p = &f.progress;
            json!({"evaluations": p.evaluations, "feasible": p.feasible, "front": p.front, "screened": r.screened})
        });
        let value = json!({
            "schema": "houscaper.run/1",
            "status": match found.map(|f| f.stop) {
                None => "running",
                Some(Stop::Interrupted) => "stopped",
                Some(Stop::Done | Stop::Exhausted | Stop::Stagnated) => "complete",
            },
            "resume": job.origin,
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
            "hashes": hashes(job),
            "price_book": {"version": books.prices.version, "date": books.prices.date},
            "counts": counts,
            "hypervolume": found.map(|f| json!({
                "reference": f.reference,
                "box": f.progress.box_volume,
                "value": f.progress.hypervolume,
                "relative": f.progress.relative_hypervolume(),
            })),
            "seconds": done.map(|(r, _)| json!({"search": r.search_seconds, "total": r.total_seconds})),
        });
        let mut text = serde_json::to_string_pretty(&value).unwrap_or_default();
        text.push('\n');
        text.into_bytes()
    }
}

/// Hashes of everything besides the brief that decides what a run finds.
pub fn hashes(job: &Job) -> serde_json::Value {
    let (evaluator, books) = (&job.evaluator, &job.evaluator.books);
    let configs = |name: &str| job.paths.configs.join(name).to_string_lossy().into_owned();
    let beside = |file: Option<&String>| file.map(|f| file_hash(&job.paths.brief.join(f).to_string_lossy()));
    json!({
        "prices": file_hash(&books.prices.file),
        "prices_extended": books.prices.extended.iter().map(|f| file_hash(f)).collect::<Vec<_>>(),
        "carbon": file_hash(&books.carbon.file),
        "buildups": file_hash(&books.buildups.file),
        "materials": file_hash(&configs("materials.json")),
        "sections": file_hash(&configs("sections.json")),
        "loads": file_hash(&configs("loads.json")),
        "given": beside(evaluator.brief.given.as_ref().map(|g| &g.lattice)),
        "sun": beside(evaluator.brief.given.as_ref().and_then(|g| g.sun.as_ref())),
        "entrances": beside(evaluator.brief.given.as_ref().and_then(|g| g.entrances.as_ref())),
        "envelope": beside(evaluator.brief.plot.envelope.as_ref().map(|e| &e.file)),
        "tileset": folder_hash(&job.paths.tileset),
        "linear": folder_hash(&job.paths.linear),
    })
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

/// An evaluated design as the tables show it.
pub fn row(job: &Job, id: u64, generation: u64, score: &Score, design: &Design) -> DesignRow {
    DesignRow {
        id,
        generation,
        feasible: score.is_feasible(),
        violation: score.violation,
        objectives: natural(job, &score.objectives),
        variables: variables(job, design),
    }
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
