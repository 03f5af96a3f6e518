//! Every house that comes along can be built with all its files, and stands.

#[path = "common/cli.rs"]
mod cli;

use cli::{Scratch, has, ok, refused, run};
use houscaper::voxels::samples;

/// Houses that even boards on both sides of their walls do not brace against the wind of the starter brief's site: wide openings at the
/// end of a long wing, or a row of three without party walls. Their members hold; the verdict says what to do.
const ASK_FOR_BRACING: [&str; 3] = ["row", "split", "l_gable"];

#[test]
fn every_sample_is_built_and_stands() {
    let folder = Scratch::new();
    let names: Vec<&str> = samples::gallery().iter().map(|(name, _)| *name).collect();
    assert!(names.len() >= 12 && ASK_FOR_BRACING.iter().all(|v| names.contains(v)));
    for name in names {
        let sample = format!("sample:{name}");
        has(&ok(&["check", &sample]).out, &["keeps all"]);
        let out = folder.at(name);
        let ran = run(&["build", &sample, "--out", &out]);
        assert_eq!(ran.code, 0, "{name}: {}{}", ran.out, ran.err);
        assert_eq!(ran.err, "", "{name}: no rule is broken");
        let stands = ran.out.contains("structure ok: every check holds");
        let known = ASK_FOR_BRACING.contains(&name);
        let boards =
            ["structure not ok: racking of ", "structure not ok: storey sway: "].iter().any(|w| ran.out.contains(w))
                && ran.out.contains("members hold");
        assert!(stands != known && stands != boards, "{name}: {}", ran.out);
        let drawn = ["plan-0.svg", "elevation-north.svg", "elevation-west.svg", "section-a.svg"];
        for file in ["house.glb", "house.obj", "quote.html", "thumb.png", "voxels.json"].into_iter().chain(drawn) {
            let size = std::fs::metadata(folder.path().join(name).join(file)).map(|m| m.len()).unwrap_or(0);
            assert!(size > 100, "{name}/{file}");
        }
    }
}

#[test]
fn a_picture_and_a_turntable_are_written_and_nonsense_is_refused() {
    let folder = Scratch::new();
    let out = folder.at("turn");
    let ran = ok(&["picture", "sample:box", "--out", &out, "--size", "120x90", "--turntable", "4", "--frame"]);
    has(&ran.out, &["picture.png", "turntable.png", "turntable/ (4)"]);
    for file in ["picture.png", "turntable.png", "turntable-sheet.png", "turntable/000.png", "turntable/003.png"] {
        let bytes = std::fs::read(folder.path().join("turn").join(file)).expect(file);
        assert_eq!(&bytes[1..4], b"PNG", "{file}");
    }
    let wrong = refused(&["picture", "sample:box", "--out", &folder.at("steep"), "--elevation", "70"]);
    has(&wrong, &["--elevation 70", "0 to 50 degrees"]);
    assert_eq!(run(&["picture", "sample:box", "--out", &folder.at("size"), "--size", "12"]).code, 2);
    ok(&["picture", "sample:box", "--out", &folder.at("size"), "--size", "60x40", "--elevation", "70", "--parallel"]);
}
