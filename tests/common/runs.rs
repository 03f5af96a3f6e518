//! Runs of the program in a temporary folder, and their files read back.
#![allow(dead_code)]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use houscaper::brief::read_brief;
use houscaper::score::{Evaluator, Paths};
use houscaper::voxels::{Choice, Choices, House, json};
use serde_json::{Value, json};

/// The repository.
pub fn repository() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The program, started in the repository.
pub fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_houscaper"));
    command.current_dir(repository()).env("NO_COLOR", "1");
    command
}

/// `optimize BRIEF --out OUT ...`.
pub fn optimize(brief: &Path, out: &Path, more: &[&str]) -> Output {
    program().arg("optimize").arg(brief).arg("--out").arg(out).args(more).output().expect("the program starts")
}

/// The same, expected to end well.
pub fn optimize_ok(brief: &Path, out: &Path, more: &[&str]) -> Output {
    let output = optimize(brief, out, more);
    assert!(output.status.success(), "{}", said(&output));
    output
}

/// What a program wrote for people.
pub fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A shipped brief, changed by `change`, in `folder`; its books stay where they are.
pub fn changed_brief(name: &str, folder: &Path, change: impl FnOnce(&mut Value)) -> PathBuf {
    let configs = repository().join("configs");
    let text = std::fs::read(configs.join(name)).expect("a shipped brief");
    let mut brief: Value = serde_json::from_slice(&text).expect("JSON");
    for (key, file) in [("prices", "prices.json"), ("carbon", "carbon.json"), ("buildups", "buildups.json")] {
        brief[key] = json!(configs.join(file));
    }
    change(&mut brief);
    let path = folder.join(name);
    std::fs::write(&path, brief.to_string()).expect("a temporary file");
    path
}

/// The evaluator of a brief file.
pub fn evaluator(path: &Path) -> Evaluator {
    let brief = read_brief(&std::fs::read(path).expect("the brief"), "brief").expect("a brief");
    let home = repository();
    let paths = Paths {
        configs: home.join("configs"),
        tileset: home.join("tilesets").join(&brief.tileset),
        linear: home.join("tilesets").join(&brief.linear),
        brief: path.parent().expect("a folder").to_owned(),
    };
    Evaluator::load(brief, &paths).expect("everything the brief names")
}

/// A table of a run: its header and its rows.
pub struct Table {
    /// Column names.
    pub header: Vec<String>,
    /// Cells of each row.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// Reads a table; every row must have as many cells as the header.
    pub fn read(path: &Path) -> Table {
        let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let mut lines = text.lines().map(cells);
        let header = lines.next().expect("a header");
        let rows: Vec<Vec<String>> = lines.collect();
        for (n, row) in rows.iter().enumerate() {
            assert_eq!(row.len(), header.len(), "{}: line {}", path.display(), n + 2);
        }
        Table { header, rows }
    }

    /// A row as a map from column to cell.
    pub fn row(&self, n: usize) -> BTreeMap<&str, &str> {
        self.header.iter().map(String::as_str).zip(self.rows[n].iter().map(String::as_str)).collect()
    }

    /// The numbers of a column.
    pub fn numbers(&self, column: &str) -> Vec<f64> {
        let at = self.header.iter().position(|h| h == column).unwrap_or_else(|| panic!("no column {column}"));
        self.rows.iter().map(|r| r[at].parse().unwrap_or_else(|_| panic!("{column}: {}", r[at]))).collect()
    }
}

/// Cells of a CSV line with double quotes around cells that hold commas.
fn cells(line: &str) -> Vec<String> {
    let mut out = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => out.push(String::new()),
            c => out.last_mut().expect("a cell").push(c),
        }
    }
    out
}

/// The choices that a row of `front.csv` names.
pub fn choices(evaluator: &Evaluator, row: &BTreeMap<&str, &str>) -> Choices {
    let mut choices = Choices::default();
    for choice in [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof] {
        let options = &evaluator.options[choice as usize];
        let name = row[choice.name()];
        let index = options.iter().position(|o| evaluator.catalogue.option_name(*o) == name);
        choices.0[choice as usize] = index.unwrap_or_else(|| panic!("no option {name}")) as u16;
    }
    let along_y = row[Choice::Joists.name()].chars().enumerate().filter(|(_, c)| *c == 'y');
    choices.0[Choice::Joists as usize] = along_y.fold(0, |bits, (p, _)| bits | 1 << p);
    let boards = evaluator.brief.wall_boards.iter().position(|b| b.name() == row[Choice::Boards.name()]);
    choices.0[Choice::Boards as usize] = boards.expect("boards of the brief") as u16;
    choices
}

/// A JSON file.
pub fn read_json(path: &Path) -> Value {
    let bytes = std::fs::read(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_slice(&bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The house of a folder of the front.
pub fn read_house(folder: &Path) -> House {
    let path = folder.join("voxels.json");
    json::read(&std::fs::read(&path).expect("voxels.json"), "voxels.json").expect("a house")
}

/// All files under a folder with their bytes, by path within it.
pub fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut out = BTreeMap::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in std::fs::read_dir(&next).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(folder).expect("inside").to_string_lossy().replace('\\', "/");
                out.insert(name, std::fs::read(&path).expect("a file"));
            }
        }
    }
    out
}
