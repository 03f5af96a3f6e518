//! Published frames of the shared reference folder, and the frame file's way out and back.

#![allow(clippy::unwrap_used)]

use houscaper::analysis::file::{self, Quantity};
use houscaper::analysis::solve;
use std::path::PathBuf;

fn frames() -> Option<PathBuf> {
    let shared = std::env::var_os("HOUSCAPER_SHARED").map(PathBuf::from);
    let shared = shared.unwrap_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared"));
    let folder = shared.join("reference/frames");
    folder.is_dir().then_some(folder)
}

#[test]
fn published_values_are_reproduced() {
    let Some(folder) = frames() else {
        eprintln!("skipped: no reference/frames under HOUSCAPER_SHARED or ../shared");
        return;
    };
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    paths.retain(|p| p.extension().is_some_and(|e| e == "json"));
    assert_eq!(paths.len(), 12);
    let mut wrong = Vec::new();
    for path in paths {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let frame = file::read(&std::fs::read(&path).unwrap(), &name).unwrap();
        assert_eq!(file::read(&file::write(&frame), &name).unwrap(), frame, "{name} does not come back");
        let s = solve(&frame.model, &frame.cases).unwrap();
        if !s.status.is_solved() {
            wrong.push(format!("{name}: {:?}", s.status));
        }
        for e in &frame.expected {
            let found = match e.quantity {
                Quantity::Displacement { node } => s.displacements(e.case)[node][e.component],
                Quantity::EndForce { member } => s.end_forces(e.case)[member][e.component],
                Quantity::Reaction { node } => {
                    let at = frame.model.supports.iter().position(|s| s.node == node).unwrap();
                    s.reactions(e.case)[at][e.component]
                }
            };
            if (found - e.value).abs() > e.tolerance {
                wrong.push(format!(
                    "{name}: {:?} {}: {found} not {} +- {}",
                    e.quantity, e.component, e.value, e.tolerance
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn mistakes_are_named_by_their_key() {
    let says = |text: &str, expected: &str| {
        let e = file::read(text.as_bytes(), "f.json").unwrap_err().to_string();
        assert!(e.contains(expected), "{e}");
    };
    let with = |member: &str| {
        format!(
            r#"{{"nodes":[[0,0,0],[1,0,0]],"materials":[{{"E":1,"G":1}}],"sections":[{{"A":1,"Iy":1,"Iz":1,"J":1}}],
            "members":[{member}],"supports":[],"cases":[{{"name":"a"}}],"combinations":[{{"name":"c","factors":{{"a":1.5}}}}]}}"#
        )
    };
    let good = file::read(with(r#"{"n":[0,1],"mat":0,"sec":0,"roll":90}"#).as_bytes(), "f.json").unwrap();
    assert_eq!(good.combinations[0].factors, [1.5]);
    assert!((good.model.members[0].roll - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    says(&with(r#"{"n":[0,1],"mat":0,"sec":0,"rol":90}"#), "members[0].rol: unknown key");
    says(&with(r#"{"n":[0,1],"sec":0}"#), "members[0].mat: missing key");
    says(&with(r#"{"n":[0,1],"mat":-1,"sec":0}"#), "members[0].mat: found -1, expected an index");
    says(&with(r#"{"n":[0],"mat":0,"sec":0}"#), "members[0].n: found [0], expected 2 values");
    says("{", "line 1 column");
}
