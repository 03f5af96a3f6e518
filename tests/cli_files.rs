//! `houscaper cubes` and `convert`: files in, files out, and bad files refused without a trace.

#[path = "common/cli.rs"]
mod cli;

use cli::{Scratch, contents, has, ok, reference, refused};
use houscaper::cubes::{CornerOrder, IdScheme, cube_ids};
use houscaper::voxels::lattice::{Values, read_lattice};
use houscaper::voxels::{Label, json, samples, text};

fn read(path: &str) -> Vec<u8> {
    std::fs::read(path).expect("a file")
}

#[test]
fn ids_are_a_lattice_a_module_before_the_voxels() {
    let folder = Scratch::new();
    let mut house = samples::l_house();
    house.voxels.origin_m = [3.0, -2.0, 0.27];
    let input = folder.house("l.json", &house);
    for (flags, scheme, order) in [
        (&[][..], IdScheme::Thesis, CornerOrder::FOrder),
        (&["--corner-order", "box-corners"], IdScheme::Thesis, CornerOrder::BoxCorners),
        (&["--scheme", "topogenesis"], IdScheme::TopoGenesis, CornerOrder::FOrder),
    ] {
        let out = folder.at("ids.csv");
        let ran = ok(&[&["cubes", &input, "--out", &out], flags].concat());
        has(&ran.err, &["12 x 12 x 11 cube ids"]);
        assert!(!ran.err.contains("inadmissible"));
        let lattice = read_lattice(&read(&out), "ids.csv").expect("a lattice");
        let expected = cube_ids(&house.voxels, scheme, order);
        assert_eq!(lattice.shape, expected.shape);
        assert_eq!(lattice.unit, [0.9, 0.9, 0.54]);
        let close = |a: [f64; 3], b: [f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-9);
        // The first voxel of the padded array, as topoGenesis has it: a module before ours.
        assert!(close(lattice.minbound, [2.1, -2.9, -0.27]), "{:?}", lattice.minbound);
        assert_eq!(lattice.values, Values::Number(expected.ids.iter().map(|&i| f64::from(i)).collect()));
    }
}

#[test]
fn inadmissible_cubes_are_reported_and_repaired() {
    let folder = Scratch::new();
    let input = folder.file("diagonal.txt", "3.\n.3\n");
    let ran = ok(&["cubes", &input, "--out", &folder.at("ids.csv")]);
    has(&ran.err, &["2 inadmissible cubes", "cube [1, 1, 0]", "--repair"]);
    let mended = folder.at("mended.txt");
    let ran = ok(&["convert", &input, &mended, "--repair"]);
    has(&ran.err, &["repair: 1 voxel changed (1 filled, 0 emptied)", "[0, 0, 0]: empty -> foundation"]);
    assert_eq!(read(&mended), b"3.\n33\n");
    has(&ok(&["convert", &mended, &folder.at("again.txt"), "--repair"]).err, &["repair: 0 voxels changed"]);
}

#[test]
fn conversions_keep_what_their_format_can_hold() {
    let folder = Scratch::new();
    let house = samples::deck_house();
    let input = folder.house("deck.json", &house);
    let [csv, txt, back] = ["deck.csv", "deck.txt", "back.json"].map(|n| folder.at(n));
    ok(&["convert", &input, &csv]);
    ok(&["convert", &csv, &txt]);
    assert_eq!(read(&txt), text::write(&house.voxels).as_bytes());
    ok(&["convert", &csv, &back]);
    assert_eq!(read(&back), read(&input), "stairs are found again in the voids");
    let mut zoned = house.clone();
    zoned.zones = vec![-1; zoned.voxels.labels().len()];
    has(&ok(&["convert", &folder.house("zoned.json", &zoned), &csv]).err, &["zones are stored in .json only"]);
}

#[test]
fn a_label_lattice_keeps_its_bytes() {
    let folder = Scratch::new();
    let input = "tests/data/lattices/box_labels.csv";
    ok(&["convert", input, &folder.at("copy.csv")]);
    assert_eq!(read(&folder.at("copy.csv")), read(input));
    let crlf = String::from_utf8(read(input)).expect("UTF-8").replace('\n', "\r\n");
    let input = folder.file("crlf.csv", &crlf);
    ok(&["convert", &input, &folder.at("copy.csv")]);
    assert_eq!(read(&folder.at("copy.csv")), crlf.as_bytes());
}

const ZONES: &str = "minbound,shape,unit\n0,2,1.8\n0,2,1.8\n0,3,3.24\n\nIX,IY,IZ,value\n\
    0,0,0,-1\n0,0,1,0\n0,0,2,2\n0,1,0,-1\n0,1,1,0\n0,1,2,-1\n1,0,0,-1\n1,0,1,1\n1,0,2,2\n1,1,0,-1\n1,1,1,1\n1,1,2,-1\n";

#[test]
fn a_zoning_lattice_becomes_a_labelled_body_with_zones() {
    let folder = Scratch::new();
    let input = folder.file("zones.csv", ZONES);
    let out = folder.at("zones.json");
    let ran = ok(&["convert", &input, &out, "--occupied", ">= 0", "--ground"]);
    has(&ran.err, &["6 occupied cells of 1.8 x 1.8 x 3.24 m", "2 x 2 x 6 modules", "true to scale"]);
    let house = json::read(&read(&out), "zones.json").expect("a house");
    assert_eq!(house.voxels.shape(), [4, 4, 12]);
    assert_eq!(
        [0, 1, 6, 7].map(|k| house.voxels.get([0, 0, k])),
        [Label::Foundation, Label::Base, Label::Floor, Label::Base]
    );
    let zone = |v| house.zones[house.voxels.index(v)];
    assert_eq!([zone([0, 0, 0]), zone([2, 3, 5]), zone([3, 1, 6]), zone([0, 3, 6])], [0, 1, 2, -1]);
    // The low corner of the first cell stays where it was: -0.9 m; the body stands on the ground.
    assert_eq!(house.voxels.origin_m, [-0.45, -0.45, 0.0]);
    let ran = ok(&["convert", &input, &out, "--occupied", ">= 0", "--cell-modules", "4,4,6", "--crop", "1,0,1,1,1,2"]);
    has(&ran.err, &["3 occupied cells", "scale changed by 2.000, 2.000, 1.000", "2 x 2 x 6 modules a cell"]);
    assert_eq!(json::read(&read(&out), "zones.json").expect("a house").voxels.shape(), [4, 8, 12]);
}

#[test]
fn repair_keeps_zones_with_their_voxels() {
    let folder = Scratch::new();
    // Two cells that touch along an edge only.
    let touching = ZONES.replace("1,0,1,1", "1,0,1,-1").replace("0,1,1,0", "0,1,1,-1");
    let out = folder.at("zones.json");
    let input = folder.file("touching.csv", touching);
    let plain = ok(&["convert", &input, &out, "--occupied", ">= 0", "--ground"]);
    has(&plain.err, &["inadmissible cubes; --repair mends them"]);
    let ran = ok(&["convert", &input, &out, "--occupied", ">= 0", "--ground", "--repair"]);
    assert!(!ran.err.contains("inadmissible"), "{}", ran.err);
    let house = json::read(&read(&out), "zones.json").expect("a house");
    assert!(house.zones.iter().zip(house.voxels.labels()).all(|(z, l)| *z < 0 || l.is_filled()));
}

#[test]
fn the_reference_zoning_lattice_becomes_a_house_in_modules() {
    let Some(input) = reference("lattices/abm_mcda_f_030.csv") else { return };
    let folder = Scratch::new();
    let out = folder.at("abm.json");
    let flags = ["--occupied", ">= 0", "--cell-modules", "4,4,6", "--ground", "--crop", "12,1,1,15,3,2", "--repair"];
    let ran = ok(&[&["convert", &input, &out][..], &flags].concat());
    has(
        &ran.err,
        &["19 occupied cells of 10 x 10 x 10 m", "scale changed by 0.360, 0.360, 0.324", "16 x 12 x 12 modules"],
    );
    let house = json::read(&read(&out), "abm.json").expect("a house");
    let mut zones: Vec<i32> = house.zones.clone();
    zones.sort_unstable();
    zones.dedup();
    assert_eq!(zones, [-1, 1, 2]);
    assert_eq!(house.voxels.filled_count(), 19 * 96);
}

/// Runs both commands on a bad file; each must name `parts` and leave the folder as it was.
fn refuses(name: &str, text: &str, parts: &[&str]) {
    let folder = Scratch::new();
    let input = folder.file(name, text);
    let earlier = folder.file("earlier.csv", "precious");
    let before = contents(folder.path());
    for args in [["cubes", &input, "--out", &earlier].as_slice(), &["convert", &input, &earlier], &["check", &input]] {
        has(&refused(args), parts);
        assert_eq!(contents(folder.path()), before, "{args:?}");
    }
}

fn lattice(rows: &str) -> String {
    format!("minbound,shape,unit\n0,2,0.9\n0,1,0.9\n0,2,0.54\n\nIX,IY,IZ,value\n{rows}")
}

#[test]
fn bad_lattices_are_refused_by_line_and_nothing_is_written() {
    let good = lattice("0,0,0,3\n0,0,1,1\n1,0,0,3\n1,0,1,1\n");
    let folder = Scratch::new();
    ok(&["convert", &folder.file("good.csv", good), &folder.at("good.json")]);
    refuses(
        "label.csv",
        &lattice("0,0,0,3\n0,0,1,7\n1,0,0,3\n1,0,1,1\n"),
        &["label.csv:8: cell [0, 0, 1] has value 7", "no label (0 to 5)"],
    );
    let old = "IX,IY,IZ,value\n0,0,0,3\n1,0,0,3\n0,0,1,1\n1,0,1,-1\n";
    refuses("old.csv", old, &["old.csv:5: cell [1, 0, 1] has value -1"]);
    refuses("ragged.csv", &lattice("0,0,0,3\n0,0,1\n1,0,0,3\n1,0,1,1\n"), &["ragged.csv:8:", "four columns"]);
    refuses("shuffled.csv", &lattice("0,0,0,3\n1,0,0,3\n0,0,1,1\n1,0,1,1\n"), &["shuffled.csv:8:", "shuffled"]);
    refuses("missing.csv", &lattice("0,0,0,3\n0,0,1,1\n1,0,0,3\n"), &["missing.csv:9:", "3 rows", "expected 4"]);
    refuses("repeated.csv", &lattice("0,0,0,3\n0,0,0,3\n1,0,0,3\n1,0,1,1\n"), &["repeated.csv:8:", "repeated"]);
}

#[test]
fn bad_json_and_text_are_refused_by_key_or_line() {
    let good = json::write(&samples::box_house());
    refuses("label.json", &good.replacen("\"0333", "\"0933", 1), &["label.json: layers[0][1]", "one digit per voxel"]);
    refuses("ragged.json", &good.replacen("\"0333", "\"333", 1), &["ragged.json: layers[0][1]", "digits"]);
    refuses("key.json", &good.replacen("\"unit\"", "\"units\"", 1), &["key.json:3:", "units"]);
    refuses(
        "unit.json",
        &good.replacen("\"unit\": \"m\"", "\"unit\": \"ft\"", 1),
        &["unit.json: unit is \"ft\"", "\"m\""],
    );
    refuses("label.txt", "3x\n", &["label.txt", "line 1, column 2", "`x` is no label"]);
    refuses("ragged.txt", "33\n3\n", &["ragged.txt", "line 2"]);
    refuses("house.vox", "", &["house.vox", "byte 0", "expected a MagicaVoxel file"]);
    refuses("house.stl", "", &["house.stl", ".json"]);
}

#[test]
fn outputs_are_checked_before_anything_is_done() {
    let folder = Scratch::new();
    let input = folder.house("box.json", &samples::box_house());
    let before = contents(folder.path());
    let same = folder.path().join(".").join("box.json").to_str().expect("UTF-8").to_owned();
    has(&refused(&["convert", &input, &same, "--repair"]), &["is the input itself"]);
    has(&refused(&["cubes", &input, "--out", &input]), &["is the input itself"]);
    has(&refused(&["convert", &input, &folder.at("box.stl")]), &["box.stl", ".csv, .npy, .json, .txt or .vox"]);
    has(&refused(&["convert", &input, &folder.at("no/box.csv")]), &["does not exist"]);
    has(&refused(&["convert", &folder.at("none.json"), &folder.at("box.csv")]), &["cannot read", "none.json"]);
    assert_eq!(contents(folder.path()), before);
}

#[test]
fn zoning_flags_are_checked() {
    let folder = Scratch::new();
    let (zones, out) = (folder.file("zones.csv", ZONES), folder.at("out.json"));
    let voxels = folder.house("box.json", &samples::box_house());
    has(&refused(&["convert", &zones, &out]), &["zones.csv", "--occupied", ">= 0"]);
    has(&refused(&["convert", &zones, &out, "--ground"]), &["--occupied", "no occupancy rule"]);
    has(&refused(&["convert", &zones, &out, "--occupied", "== True"]), &["zones.csv", "lattice of numbers"]);
    has(&refused(&["convert", &zones, &out, "--occupied", "> 7"]), &["zones.csv", "no cell", "> 7"]);
    has(
        &refused(&["convert", &zones, &out, "--occupied", ">= 0", "--crop", "0,0,0,2,1,1"]),
        &["crop", "[2, 2, 3] cells"],
    );
    has(&refused(&["convert", &voxels, &out, "--occupied", ">= 0"]), &["lattices only, .csv or .npy"]);
    assert!(!folder.path().join("out.json").exists());
}
