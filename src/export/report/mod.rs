//! `report.html`: a run in one file that opens without a network.
//!
//! The page holds every evaluated design as columns of numbers, the figures and pictures of the front, and the files of its houses
//! behind zlib, which it opens one by one when a house is chosen. Size, stated and tested: at most 1 MB before the first plot is drawn for
//! 5 000 designs and 100 houses, and at most 0.5 MB for each house; fronts of more than [`MOST_WHOLE`] houses carry figures and pictures
//! of all and the files of that many.

mod columns;
mod error;
mod findings;
mod house;
mod names;
mod page;
mod rows;
mod texts;

use std::collections::BTreeMap;

use rayon::prelude::*;
use serde::Serialize;
use serde_json::{Value, json};

pub use columns::{Cloud, Column, Dimension, MOST_DESIGNS};
pub use error::ReportError;
pub use findings::{Findings, Table};
pub use house::{BillGroup, HouseReport, Packed, PartsCount};
pub use names::NamedHouse;
pub use page::report_html;
pub use rows::Rows;
pub use texts::{TextGroup, TextItem};

use crate::brief::Objective;
use crate::run::FolderError;

/// Houses whose files are in the page at most.
pub const MOST_WHOLE: usize = 120;

/// The marks of folders that can be reported.
const RUN: &str = "houscaper.run/1";
const BUILD: &str = "houscaper.build/1";

/// What reads a file of a folder: its bytes, or `None` where it is not.
pub type ReadFile<'a> = dyn Fn(&str) -> Result<Option<Vec<u8>>, FolderError> + Sync + 'a;

/// What lists a folder: the names of its files.
pub type ListFiles<'a> = dyn Fn(&str) -> Result<Vec<String>, FolderError> + Sync + 'a;

/// A folder to report, by what reads it.
#[derive(Clone, Copy)]
pub struct Folder<'a> {
    /// Reads a file by its path with `/`.
    pub read: &'a ReadFile<'a>,
    /// The files of a folder below, sorted; of the folder itself for `""`.
    pub files: &'a ListFiles<'a>,
}

/// Everything the page shows, but for the files of its houses.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// `houscaper.report/1`.
    pub schema: &'static str,
    /// Name of the brief, or of the house.
    pub name: String,
    /// Version, commit, seed, status, counts, hashes, brief: what `run.json` says, without clock and machine.
    pub run: Value,
    /// The objectives of the brief.
    pub objectives: Vec<Dimension>,
    /// The design variables of the tables.
    pub variables: Vec<Dimension>,
    /// Every figure there is, in the order of its objective, for tables.
    pub figures: Vec<Dimension>,
    /// The evaluated designs; `None` without `evaluations.csv`.
    pub cloud: Option<Cloud>,
    /// The front, best in the first objective first; or the built house.
    pub houses: Vec<HouseReport>,
    /// The houses with a name.
    pub named: Vec<NamedHouse>,
    /// Groups by look, why not, what a change does.
    pub findings: Findings,
    /// What is assumed.
    pub texts: Vec<TextGroup>,
    /// What the folder lacks, a sentence each.
    pub missing: Vec<String>,
}

/// Collects a run folder (`optimize`, `resume`, `merge`) or the folder of one house (`build`); the files of houses come apart.
///
/// # Errors
/// [`ReportError`]: no such folder, or a file in it that cannot be read.
pub fn collect(folder: &Folder) -> Result<(Report, Vec<Packed>), ReportError> {
    let mark = json_file(folder, "run.json")?;
    match mark["schema"].as_str() {
        Some(RUN) => of_run(folder, &mark),
        Some(BUILD) => of_build(folder, &mark),
        other => Err(ReportError::Schema { found: other.map_or("not there".to_owned(), |s| format!("\"{s}\"")) }),
    }
}

fn json_file(folder: &Folder, file: &str) -> Result<Value, ReportError> {
    let source = |source| ReportError::Json { file: file.to_owned(), source };
    (folder.read)(file)?.map_or(Ok(Value::Null), |bytes| serde_json::from_slice(&bytes).map_err(source))
}

fn table(folder: &Folder, file: &str) -> Result<Option<Rows>, ReportError> {
    (folder.read)(file)?.map(|bytes| Rows::read(file, &bytes)).transpose()
}

fn of_run(folder: &Folder, mark: &Value) -> Result<(Report, Vec<Packed>), ReportError> {
    let front = table(folder, "front.csv")?.ok_or(ReportError::NoFront)?;
    let ids = front.ids()?;
    let evaluations = table(folder, "evaluations.csv")?;
    let summary = json_file(folder, "summary.json")?;
    let all = evaluations.as_ref().unwrap_or(&front);
    let objectives = objectives(&mark["brief"]["objectives"], all);
    let variables = variables(all, &objectives);
    let dimensions = [objectives.as_slice(), &variables].concat();
    let cloud = match &evaluations {
        Some(rows) => Some(columns::cloud(rows, &dimensions, &rows.ids()?, &ids)),
        None => None,
    };
    let told = names::told(&summary);
    let named = if told.is_empty() { names::found(&front, &ids, &objectives) } else { told };
    let whole = whole(&ids, &named);
    let read = |row: usize| -> Result<house::Read, ReportError> {
        let id = ids[row];
        let mut read = house::read(folder, &format!("front/{id}/"), id, whole.contains(&id))?;
        read.house.cells = front.header.iter().map(|h| (h.clone(), house::cell(front.text(row, h)))).collect();
        Ok(read)
    };
    let read: Vec<house::Read> = (0..ids.len()).into_par_iter().map(read).collect::<Result<_, _>>()?;
    let mut report = Report {
        schema: "houscaper.report/1",
        name: mark["brief"]["name"].as_str().unwrap_or("run").to_owned(),
        run: without(mark, &["resume", "machine", "seconds"]),
        objectives,
        variables,
        figures: Vec::new(),
        cloud,
        houses: Vec::new(),
        named,
        findings: findings::read(folder, &summary)?,
        texts: Vec::new(),
        missing: Vec::new(),
    };
    let packed = report.take(read);
    report.missing = report.missing_of_run(&summary);
    Ok((report, packed))
}

fn of_build(folder: &Folder, mark: &Value) -> Result<(Report, Vec<Packed>), ReportError> {
    let read = house::read(folder, "", 0, true)?;
    if !read.house.files.iter().any(|f| f == "house.glb") {
        return Err(ReportError::NoHouse);
    }
    let shown = [Objective::PriceEur, Objective::GwpKgco2e, Objective::FloorAreaM2];
    let mut report = Report {
        schema: "houscaper.report/1",
        name: mark["name"].as_str().unwrap_or("house").to_owned(),
        run: mark.clone(),
        objectives: shown.map(|o| dimension(o, Some(o == Objective::FloorAreaM2))).to_vec(),
        variables: Vec::new(),
        figures: Vec::new(),
        cloud: None,
        houses: Vec::new(),
        named: Vec::new(),
        findings: Findings::default(),
        texts: Vec::new(),
        missing: Vec::new(),
    };
    let mut read = read;
    read.house.cells = shown.iter().map(|o| (o.name().to_owned(), read.house.figures[o.name()].clone())).collect();
    let packed = report.take(vec![read]);
    Ok((report, packed))
}

impl Report {
    /// Takes the houses in; their files come back.
    fn take(&mut self, read: Vec<house::Read>) -> Vec<Packed> {
        let mut packed = Vec::new();
        let mut all = Vec::new();
        for one in read {
            self.houses.push(one.house);
            packed.extend(one.packed);
            all.push(one.texts);
        }
        self.texts = texts::merged(&all);
        let has = |o: &Objective| self.houses.iter().any(|h| h.figures[o.name()].is_number());
        self.figures = Objective::ALL.into_iter().filter(has).map(|o| dimension(o, None)).collect();
        packed
    }

    /// What a run folder lacks.
    fn missing_of_run(&self, summary: &Value) -> Vec<String> {
        let mut out = Vec::new();
        let all = self.houses.len();
        let without = |what: &dyn Fn(&HouseReport) -> bool| self.houses.iter().filter(|h| what(h)).count();
        if let Some(cloud) = self.cloud.as_ref().filter(|c| c.shown < c.total) {
            out.push(format!(
                "the plots show {} of {} evaluated designs, taken evenly, and every house of the front",
                cloud.shown, cloud.total
            ));
        }
        if self.cloud.is_none() {
            out.push("evaluations.csv is not in the folder: the plots show the front only".into());
        }
        if summary.is_null() {
            out.push("summary.json is not in the folder: houses are named by their objectives only".into());
        }
        let bare = without(&|h| h.files.is_empty() && !h.has_picture);
        if bare > 0 {
            out.push(format!("{bare} of {all} houses have figures only: their folders are not there"));
        }
        let unpacked = without(&|h| h.files.is_empty() && h.has_picture);
        if unpacked > 0 {
            out.push(format!(
                "{unpacked} of {all} houses have a picture and figures; models, quotes and drawings of the other {} are in the page",
                all - bare - unpacked
            ));
        }
        for (file, has) in [("quote.json", "quote"), ("structure.json", "structure")] {
            let lacking = without(&|h| {
                !h.files.is_empty() && if has == "quote" { h.quote.is_null() } else { h.structure.is_null() }
            });
            if lacking > 0 {
                out.push(format!(
                    "{file} is not there for {lacking} houses, so that their {has}'s texts cannot be searched"
                ));
            }
        }
        let findings = &self.findings;
        let tables = [
            ("clusters.csv", findings.looks.is_none()),
            ("whynot.csv", findings.why_not.is_none()),
            ("sensitivity.csv", findings.changes.is_none()),
        ];
        out.extend(tables.iter().filter(|(_, gone)| *gone).map(|(file, _)| format!("{file} is not in the folder")));
        out
    }
}

/// The houses that come with their files: the named ones, then evenly many.
fn whole(ids: &[u64], named: &[NamedHouse]) -> std::collections::BTreeSet<u64> {
    let mut out: std::collections::BTreeSet<u64> = named.iter().map(|n| n.id).collect();
    let room = MOST_WHOLE.saturating_sub(out.len()).min(ids.len());
    out.extend((0..room).map(|n| ids[n * ids.len() / room]));
    out
}

/// An object without some of its keys.
fn without(value: &Value, keys: &[&str]) -> Value {
    let map = value.as_object().into_iter().flatten().filter(|(key, _)| !keys.contains(&key.as_str()));
    json!(map.map(|(key, value)| (key.clone(), value.clone())).collect::<BTreeMap<_, _>>())
}

/// An objective as a dimension of plots and tables.
fn dimension(objective: Objective, maximise: Option<bool>) -> Dimension {
    let title = objective.title();
    let (title, unit) = title.rsplit_once(" (").map_or((title, ""), |(t, u)| (t, u.trim_end_matches(')')));
    let unit = if unit == "-" { "" } else { unit };
    Dimension { key: objective.name().into(), title: title.into(), unit: unit.into(), maximise, words: Vec::new() }
}

/// The objectives of a brief that have a column.
fn objectives(asked: &Value, rows: &Rows) -> Vec<Dimension> {
    let one = |goal: &Value| {
        let name = goal["name"].as_str().or(goal.as_str())?;
        rows.column(name)?;
        Some(dimension(Objective::from_name(name)?, Some(goal["sense"] == "max")))
    };
    asked.as_array().into_iter().flatten().filter_map(one).collect()
}

/// The design variables: the columns behind the objectives.
fn variables(rows: &Rows, objectives: &[Dimension]) -> Vec<Dimension> {
    let known = |name: &str| {
        ["id", "generation", "feasible", "violation"].contains(&name) || objectives.iter().any(|o| o.key == name)
    };
    let one = |(column, name): (usize, &String)| {
        let (title, unit) = match name.as_str() {
            "footprint_cells" => ("Ground floor".to_owned(), "modules"),
            "upper_cells" => ("Upper floor".to_owned(), "modules"),
            "roof_rise" => ("Roof rise".to_owned(), "modules"),
            "wall_section" => ("Wall studs".to_owned(), ""),
            "floor_section" => ("Joists".to_owned(), ""),
            "beam_section" => ("Beams".to_owned(), ""),
            "roof_section" => ("Rafters".to_owned(), ""),
            "joist_axes" => ("Joist direction".to_owned(), ""),
            other => (sentence(other), ""),
        };
        let words = columns::words(rows, column).unwrap_or_default();
        Dimension { key: name.clone(), title, unit: unit.into(), maximise: None, words }
    };
    rows.header.iter().enumerate().filter(|(_, name)| !known(name)).map(one).collect()
}

/// A column's name as words.
fn sentence(name: &str) -> String {
    let words = name.replace('_', " ");
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
