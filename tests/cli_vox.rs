//! `.vox` files, samples and `--house` on the command line.

#[path = "common/cli.rs"]
mod cli;

use cli::{Scratch, contents, has, ok, reference, refused, run};
use houscaper::voxels::{Label, json, rules, samples, vox};

#[test]
fn houses_go_to_vox_and_back() {
    let folder = Scratch::new();
    let house = samples::deck_house();
    let input = folder.house("deck.json", &house);
    let [there, back] = ["deck.vox", "back.json"].map(|n| folder.at(n));
    ok(&["convert", &input, &there]);
    ok(&["convert", &there, &back]);
    let read = std::fs::read(&back).expect("a file");
    assert_eq!(json::read(&read, "back.json").expect("a house"), house, "stairs are found again in the voids");
    has(&ok(&["check", &there]).out, &["keeps all", "2 storeys"]);
    has(&ok(&["cubes", &there, "--out", &folder.at("ids.csv")]).err, &["15 x 10 x 15 cube ids"]);
    let brief = folder.brief("brief.json", |_| {});
    let [from_vox, from_json] =
        [&there, &input].map(|f| ok(&["evaluate", f, "--brief", &brief]).out.replace("deck.vox", "deck.json"));
    assert_eq!(from_vox, from_json);
}

#[test]
fn samples_are_named() {
    has(&ok(&["check", "sample:villa"]).out, &["sample:villa: keeps all", "2 storeys"]);
    has(&refused(&["check", "sample:castle"]), &["sample:castle: unknown", "villa", "l_gable", "deck"]);
}

#[test]
fn a_foreign_model_is_base_or_becomes_a_house() {
    let Some(input) = reference("vox/obj_house7.vox") else { return };
    let folder = Scratch::new();
    let out = folder.at("house7.json");
    let ran = ok(&["convert", &input, &out]);
    has(&ran.err, &["note: 16026 voxels of 9 colours", "199 (13661)", "default palette", "inadmissible"]);
    has(&ok(&["convert", &input, &out, "--colours", "157=window"]).err, &["14983 voxels of 8 colours"]);
    let ran = ok(&["convert", &input, &out, "--voxel-m", "0.28", "--house"]);
    has(&ran.err, &["house: 2 storeys", "every rule is kept"]);
    assert!(!ran.err.contains("count as base"), "{}", ran.err);
    let house = json::read(&std::fs::read(&out).expect("a file"), "house7").expect("a house");
    assert!(rules::check(&house, &Default::default()).is_empty());
    // Every command dresses alike.
    has(&ok(&["check", &input, "--voxel-m", "0.28", "--house"]).out, &["keeps all"]);
    assert_eq!(run(&["check", &input]).code, 2, "a massing is no house");
}

#[test]
fn an_envelope_lattice_becomes_a_house() {
    let Some(input) = reference("lattices/voxelized_envelope_lowres.csv") else { return };
    let folder = Scratch::new();
    let out = folder.at("envelope.json");
    let flags = ["--occupied", "== True", "--cell-modules", "1,1,6", "--ground", "--house"];
    let ran = ok(&[&["convert", &input, &out][..], &flags].concat());
    has(&ran.err, &["house: 2 storeys; below the roof 0 voxels filled and 0 emptied", "every rule is kept"]);
    has(&ok(&["check", &out]).out, &["keeps all", "1 stair"]);
    has(&refused(&["check", &input, "--occupied", "== True", "--house"]), &["modules of [12", "--cell-modules"]);
}

#[test]
fn bad_files_and_flags_leave_no_trace() {
    let folder = Scratch::new();
    let bytes = vox::write(&samples::box_house().voxels).expect("small");
    let good = folder.file("good.vox", &bytes);
    let cut = folder.file("cut.vox", &bytes[..bytes.len() / 2]);
    let text = folder.file("text.vox", "33\n33\n");
    let house = folder.house("box.json", &samples::box_house());
    let before = contents(folder.path());
    let out = folder.at("out.json");
    has(&refused(&["check", &cut]), &["cut.vox: byte 16", "save it again from MagicaVoxel"]);
    has(&refused(&["convert", &text, &out]), &["text.vox", "the file ends"]);
    has(&refused(&["convert", &good, &out, "--voxel-m", "0"]), &["a voxel of 0 m"]);
    has(&refused(&["convert", &house, &out, "--voxel-m", "1"]), &["--voxel-m and --colours read .vox files only"]);
    assert_eq!(run(&["convert", &good, &out, "--colours", "blue=window"]).code, 2);
    let wide = houscaper::voxels::VoxelArray::from_labels([300, 1, 1], vec![Label::Base; 300]).expect("300");
    let wide = folder.file("wide.json", json::write(&houscaper::voxels::House::new(wide)));
    has(&refused(&["convert", &wide, &folder.at("wide.vox")]), &["300", "256 along each axis"]);
    std::fs::remove_file(&wide).expect("a file");
    assert_eq!(contents(folder.path()), before);
}
