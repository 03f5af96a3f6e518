//! The tree of `src/` is the way of a house through the program: imports go one way along it.

use std::path::{Path, PathBuf};

/// The stages in order; a stage may use those before it. Stages that share a number are siblings, blind to each other.
const LAYERS: &[(&str, usize)] = &[
    ("voxels", 0),
    ("brief", 1),
    ("cubes", 2),
    ("tiles", 3),
    ("envelope", 4),
    ("frame", 4),
    ("analysis", 5),
    ("structure", 6),
    ("quantities", 7),
    ("price", 8),
    ("parts", 9),
    ("score", 10),
    ("search", 11),
    ("run", 12),
    ("export", 13),
];

/// Imports that would go along the order and are still not wanted: the stage knows nothing of what it names.
const BLIND: &[(&str, &[&str])] = &[
    ("analysis", &["voxels", "brief", "cubes", "tiles", "envelope", "frame"]),
    ("price", &["cubes", "tiles", "frame", "analysis", "structure"]),
    ("search", &["cubes", "tiles", "envelope", "frame", "analysis", "structure", "quantities", "price", "score"]),
];

fn layer(name: &str) -> Option<usize> {
    LAYERS.iter().find(|(n, _)| *n == name).map(|(_, l)| *l)
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("src is readable").flatten() {
        let path = entry.path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// The first segment of every `crate::` path in the code, comments left out.
fn crate_paths(text: &str) -> Vec<String> {
    let code: Vec<&str> = text.lines().map(|l| l.split("//").next().unwrap_or("")).collect();
    code.join("\n")
        .split("crate::")
        .skip(1)
        .flat_map(|rest| match rest.strip_prefix('{') {
            Some(group) => group.split('}').next().unwrap_or("").split(',').map(str::to_owned).collect::<Vec<_>>(),
            None => vec![rest.to_owned()],
        })
        .map(|path| path.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect())
        .collect()
}

fn wrong_imports(stage: &str, text: &str) -> Vec<String> {
    let Some(own) = layer(stage) else { return vec![format!("`{stage}` has no place in the order")] };
    let blind = BLIND.iter().find(|(s, _)| *s == stage).map_or(&[][..], |(_, names)| names);
    crate_paths(text)
        .into_iter()
        .filter(|used| used != stage)
        .filter(|used| layer(used).is_some_and(|l| l >= own) || blind.contains(&used.as_str()))
        .map(|used| format!("{stage} uses {used}"))
        .collect()
}

#[test]
fn imports_go_one_way() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    assert!(files.len() > 20);
    let mut wrong = Vec::new();
    for file in &files {
        let relative = file.strip_prefix(&root).expect("below src");
        let stage = relative.components().next().expect("a component").as_os_str().to_string_lossy().into_owned();
        if stage.ends_with(".rs") || stage == "cli" {
            continue;
        }
        let text = std::fs::read_to_string(file).expect("source is UTF-8");
        wrong.extend(wrong_imports(&stage, &text).into_iter().map(|w| format!("{}: {w}", relative.display())));
    }
    assert!(wrong.is_empty(), "imports against the order:\n{}", wrong.join("\n"));
}

#[test]
fn a_wrong_import_is_seen_and_a_right_one_is_not() {
    assert_eq!(wrong_imports("voxels", "use crate::tiles::Line;").len(), 1);
    assert_eq!(wrong_imports("tiles", "use crate::voxels::Label;").len(), 0);
    assert_eq!(wrong_imports("frame", "use crate::{envelope::Mesh, voxels::Label};").len(), 1);
    assert_eq!(wrong_imports("analysis", "let x = crate::voxels::Label::Base;").len(), 1);
}
