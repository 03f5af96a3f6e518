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

/// W. Weaver Jr., Computer Programs for Structural Analysis, 1967, page 146, structure 8: largest axial force 1.47 kip and moments
/// 84.04 and 95.319 in kip, all in member 3; as quoted with the joint displacements in Bentley's STAAD.Pro verification "V. 3D
/// Frame Max Forces". Inches and kips; half a unit of the last printed digit.
#[test]
fn weavers_space_frame() {
    use houscaper::analysis::*;
    let nodes = vec![[0.0, 120.0, 0.0], [240.0, 120.0, 0.0], [0.0; 3], [360.0, 0.0, 120.0]];
    let member = |i: usize, j: usize, reference| Member {
        nodes: [i, j],
        material: 0,
        section: 0,
        reference,
        roll: 0.0,
        releases: [[false; 6]; 2],
    };
    let model = Model {
        nodes,
        materials: vec![Material { e: 30e3, g: 30e3 / 2.5, rho: 0.0 }],
        sections: vec![Section { a: 11.0, iy: 56.0, iz: 56.0, j: 83.0, asy: None, asz: None }],
        // Its local z is level, Y is up: x cross Y for the sloping member (120, -120, 120).
        members: vec![member(0, 1, None), member(2, 0, None), member(1, 3, Some([-120.0, 0.0, 120.0]))],
        supports: vec![Support { node: 2, fix: [true; 6] }, Support { node: 3, fix: [true; 6] }],
        shear: false,
    };
    let load = |node, force| NodalLoad { node, force };
    let pull = [2.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let twist = [0.0, -1.0, 0.0, 0.0, 0.0, -120.0];
    let case = LoadCase { nodal: vec![load(0, pull), load(1, twist)], ..Default::default() };
    let s = solve(&model, &[case]).unwrap();
    let near =
        |found: f64, printed: f64, unit: f64| assert!((found - printed).abs() <= 0.5 * unit, "{found}, {printed}");
    let f = s.end_forces(0)[2];
    near(f[0], 1.47, 0.01);
    near(f[10], 84.04, 0.01);
    near(f[11].abs(), 95.319, 0.001);
    let printed = [
        [0.22267, 0.00016, -0.17182, -0.00255, 0.00217, -0.00213],
        [0.22202, -0.48119, -0.70161, -0.00802, 0.00101, -0.00435],
    ];
    for (row, found) in printed.iter().zip(s.displacements(0)) {
        (0..6).for_each(|d| near(found[d], row[d], 1e-5));
    }
}

/// OpenSees on every sample house, and again on half of them in steel: displacements, reactions and end forces to 1e-8 of the
/// largest of their kind. The interpreter that has openseespy is named by HOUSCAPER_PYTHON; without it the test says that it
/// skips.
#[test]
fn opensees_agrees_on_the_sample_houses() {
    let python = std::env::var_os("HOUSCAPER_PYTHON").unwrap_or_else(|| "python3".into());
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tools/opensees_compare.py");
    let run = std::process::Command::new(&python)
        .args([script, "--samples", "--houscaper", env!("CARGO_BIN_EXE_houscaper")])
        .output();
    let Ok(run) = run else {
        eprintln!(
            "skipped: {} does not start; name an interpreter with openseespy in HOUSCAPER_PYTHON",
            python.display()
        );
        return;
    };
    let said = String::from_utf8_lossy(&run.stdout).into_owned() + &String::from_utf8_lossy(&run.stderr);
    if run.status.code() == Some(3) {
        eprintln!("{said}skipped: name an interpreter with openseespy in HOUSCAPER_PYTHON");
        return;
    }
    eprintln!("{said}");
    assert!(run.status.success(), "{said}");
    let line = said.lines().find(|l| l.contains("frames agree with OpenSees")).unwrap();
    let agree: usize = line.split_whitespace().next().unwrap().parse().unwrap();
    assert!(agree >= 20, "{line}");
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
