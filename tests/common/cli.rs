//! The program as a person runs it: arguments in, exit code, stdout and stderr out.
#![allow(dead_code)]

use std::path::{Path, PathBuf};

use assert_cmd::Command;
use houscaper::voxels::{House, json};

/// What a run left.
pub struct Ran {
    /// Exit code.
    pub code: i32,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

/// Runs the program in the repository with `args`, and `input` on stdin.
pub fn run_with(args: &[&str], input: &str) -> Ran {
    let mut command = Command::new(env!("CARGO_BIN_EXE_houscaper"));
    command.current_dir(env!("CARGO_MANIFEST_DIR")).args(args).write_stdin(input);
    let output = command.output().expect("the program starts");
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("UTF-8");
    Ran { code: output.status.code().expect("an exit code"), out: text(&output.stdout), err: text(&output.stderr) }
}

/// Runs the program in the repository with `args`.
pub fn run(args: &[&str]) -> Ran {
    run_with(args, "")
}

/// Runs the program, which must succeed.
pub fn ok(args: &[&str]) -> Ran {
    let ran = run(args);
    assert_eq!(ran.code, 0, "{args:?}: {}{}", ran.out, ran.err);
    ran
}

/// Runs the program, which must refuse its input: exit code 2, nothing on stdout, one line on stderr. Returns the line.
pub fn refused(args: &[&str]) -> String {
    let ran = run(args);
    assert_eq!(ran.code, 2, "{args:?}: {}{}", ran.out, ran.err);
    assert_eq!(ran.out, "", "{args:?}");
    assert!(ran.err.starts_with("error: ") && ran.err.trim_end().lines().count() == 1, "{args:?}: {}", ran.err);
    ran.err
}

/// Asserts that a text has all parts.
pub fn has(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "no `{part}` in: {text}");
    }
}

/// Every file below a folder with its content, to show that nothing was touched.
pub fn contents(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut all: Vec<(PathBuf, Vec<u8>)> = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            all.extend(contents(&path));
        } else {
            all.push((path.clone(), std::fs::read(&path).expect("a file")));
        }
    }
    all.sort();
    all
}

/// A scratch folder.
pub struct Scratch(tempfile::TempDir);

impl Scratch {
    /// An empty one.
    pub fn new() -> Self {
        Scratch(tempfile::tempdir().expect("a folder"))
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        self.0.path()
    }

    /// The path of a name in it, as an argument.
    pub fn at(&self, name: &str) -> String {
        self.0.path().join(name).to_str().expect("UTF-8").to_owned()
    }

    /// Writes a file and returns its path as an argument.
    pub fn file(&self, name: &str, text: impl AsRef<[u8]>) -> String {
        std::fs::write(self.0.path().join(name), text).expect("a file");
        self.at(name)
    }

    /// Writes a house as JSON.
    pub fn house(&self, name: &str, house: &House) -> String {
        self.file(name, json::write(house))
    }

    /// A copy of the starter brief with a change, whose books are found.
    pub fn brief(&self, name: &str, change: impl Fn(&mut serde_json::Value)) -> String {
        let configs = Path::new(env!("CARGO_MANIFEST_DIR")).join("configs");
        let text = std::fs::read(configs.join("starter.json")).expect("the starter brief");
        let mut brief: serde_json::Value = serde_json::from_slice(&text).expect("JSON");
        for book in ["prices", "carbon"] {
            let file = brief[book].as_str().expect("a file name").to_owned();
            brief[book] = configs.join(file).to_str().expect("UTF-8").into();
        }
        brief["buildups"] = configs.join("buildups.json").to_str().expect("UTF-8").into();
        change(&mut brief);
        self.file(name, serde_json::to_vec_pretty(&brief).expect("JSON"))
    }
}

/// The folder of shared reference inputs: HOUSCAPER_SHARED, else beside the checkout; `None` with a note when absent.
pub fn reference(name: &str) -> Option<String> {
    let beside = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let root = std::env::var_os("HOUSCAPER_SHARED").map_or(beside, PathBuf::from);
    let path = root.join("reference").join(name);
    if path.exists() {
        return path.to_str().map(str::to_owned);
    }
    eprintln!("skipped: no {} (set HOUSCAPER_SHARED)", path.display());
    None
}
