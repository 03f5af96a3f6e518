//! Lattice CSV, our JSON and the text form: round trips byte for byte, and one clear error for each fault.

use std::path::PathBuf;

use houscaper::voxels::lattice::{Lattice, Occupancy, RowOrder, Values, read_lattice, write_lattice};
use houscaper::voxels::{House, Label, VoxelArray, json, samples, text};
use proptest::prelude::*;

/// The folder of reference lattices: under HOUSCAPER_SHARED, else beside the checkout; `None` with a note when absent.
fn reference() -> Option<PathBuf> {
    let root = std::env::var_os("HOUSCAPER_SHARED")
        .map(PathBuf::from)
        .unwrap_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared"));
    let folder = root.join("reference/lattices");
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("skipped: no reference lattices at {} (set HOUSCAPER_SHARED)", folder.display());
    None
}

fn text_of(lattice: &Lattice) -> String {
    String::from_utf8(write_lattice(lattice)).expect("UTF-8")
}

fn round_trips(bytes: &[u8], name: &str) -> Lattice {
    let lattice = read_lattice(bytes, name).unwrap_or_else(|e| panic!("{e}"));
    assert!(write_lattice(&lattice) == bytes, "{name} is not written as it was read");
    lattice
}

const NEW: &str =
    "minbound,shape,unit\n-40,1,10\n0.25,2,0.9\n0,2,10\n\nIX,IY,IZ,value\n0,0,0,-1\n0,0,1,0\n0,1,0,0.708333\n0,1,1,2\n";
const OLD_F: &str = "IX,IY,IZ,value\n0,0,0,1\n1,0,0,2\n0,1,0,3\n1,1,0,4\n0,0,1,5\n1,0,1,6\n0,1,1,7\n1,1,1,8\n";

#[test]
fn reference_lattices_round_trip_byte_for_byte() {
    let Some(folder) = reference() else { return };
    let mut read = 0;
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.extension().is_none_or(|e| e != "csv") {
            continue;
        }
        let bytes = std::fs::read(&path).expect("a file");
        if name == "program.csv" {
            assert!(read_lattice(&bytes, &name).is_err(), "a programme is no lattice");
            continue;
        }
        let lattice = round_trips(&bytes, &name);
        read += 1;
        let occupied = |rule: &str| {
            let rule: Occupancy = rule.parse().expect("a rule");
            lattice.mask(&rule).expect("a mask").iter().filter(|o| **o).count()
        };
        if name == "abm_mcda_f_030.csv" {
            assert_eq!((lattice.shape, lattice.unit), ([16, 9, 5], [10.0; 3]));
            assert_eq!(occupied(">= 0"), 93);
            assert_eq!(occupied("!= -1"), 93);
        }
        // Every kind of ending.
        let lf = String::from_utf8(bytes).expect("UTF-8");
        round_trips(lf.replace('\n', "\r\n").as_bytes(), "crlf");
        round_trips(lf.replace('\n', "\r\r\n").as_bytes(), "doubled");
        round_trips(format!("{lf}\n").as_bytes(), "one more newline");
        round_trips(lf.trim_end().as_bytes(), "no newline at the end");
    }
    assert!(read >= 6, "only {read} lattices found");
}

#[test]
fn own_files_round_trip() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/lattices");
    for (name, content) in samples_of_files() {
        let path = folder.join(name);
        if std::env::var_os("HOUSCAPER_BLESS").is_some() {
            std::fs::create_dir_all(&folder).expect("a folder");
            std::fs::write(&path, &content).expect("a file");
        }
        let bytes = std::fs::read(&path).unwrap_or_else(|e| panic!("{name}: {e}; HOUSCAPER_BLESS=1 writes it"));
        assert_eq!(bytes, content.as_bytes(), "{name}");
        round_trips(&bytes, name);
    }
}

/// The files in tests/data/lattices, as this test generates them (HOUSCAPER_BLESS=1 writes them).
fn samples_of_files() -> Vec<(&'static str, String)> {
    let bools = "minbound,shape,unit\n0,1,1\n0,1,1\n0,3,1\n\nIX,IY,IZ,value\n0,0,0,True\n0,0,1,False\n0,0,2,True\n";
    vec![
        ("mixed_numbers.csv", NEW.to_string()),
        ("bool_extra_newline.csv", format!("{bools}\n")),
        ("bool_crlf.csv", bools.replace('\n', "\r\n")),
        ("bool_doubled_cr.csv", bools.replace('\n', "\r\r\n").replacen("\r\r\n\r\r\n", "\r\r\n\r\n", 1)),
        ("old_x_fastest.csv", OLD_F.to_string()),
        ("old_no_newline.csv", "IX,IY,IZ,value\n0,0,0,0\n0,0,1,0.5".to_string()),
        ("box_labels.csv", text_of(&Lattice::from_voxels(&samples::box_house().voxels))),
    ]
}

#[test]
fn values_land_in_their_cells() {
    let lattice = round_trips(NEW.as_bytes(), "new");
    assert_eq!((lattice.minbound, lattice.unit), ([-40.0, 0.25, 0.0], [10.0, 0.9, 10.0]));
    assert_eq!(lattice.values, Values::Number(vec![-1.0, 0.708333, 0.0, 2.0]), "x fastest, then y, then z");
    let old = round_trips(OLD_F.as_bytes(), "old");
    assert_eq!(old.style.order, RowOrder::F);
    assert_eq!(old.values, Values::Number((1..=8).map(f64::from).collect()));
    let c = "IX,IY,IZ,value\n0,0,0,1\n0,0,1,2\n1,0,0,3\n1,0,1,4\n";
    assert_eq!(round_trips(c.as_bytes(), "c").values, Values::Number(vec![1.0, 3.0, 2.0, 4.0]));
}

#[test]
fn other_spellings_survive_until_the_value_changes() {
    let spelled = NEW.replace("0.708333", "0.70833300001").replace("-40,", "-40.0,").replace(",2\n", ",2.0\n");
    let mut lattice = round_trips(spelled.as_bytes(), "spelled");
    if let Values::Number(values) = &mut lattice.values {
        values[3] = 5.0;
    }
    assert!(text_of(&lattice).ends_with("0,1,0,0.70833300001\n0,1,1,5\n"), "{}", text_of(&lattice));
}

#[test]
fn faults_are_named_with_their_line() {
    let error = |from: &str, to: &str| {
        assert!(NEW.contains(from));
        read_lattice(NEW.replace(from, to).as_bytes(), "zones.csv").expect_err(to).to_string()
    };
    for (from, to, says) in [
        (
            "0,0,1,0\n0,1,0,0.708333\n",
            "0,1,0,0.708333\n0,0,1,0\n",
            "zones.csv:8: row of cell [0, 1, 0] where [0, 0, 1] should stand: the rows are shuffled",
        ),
        ("0,0,1,0\n", "", "a row is missing"),
        (
            "0,0,1,0\n",
            "0,0,0,0\n",
            "zones.csv:8: row of cell [0, 0, 0] where [0, 0, 1] should stand: the cell is repeated",
        ),
        ("0,1,1,2\n", "", "3 rows for a shape of [1, 2, 2], expected 4"),
        ("0,1,1,2\n", "0,1,1,2\n0,1,2,2\n", "5 rows"),
        ("0,0,1,0\n", "0,0,1\n", "zones.csv:8"),
        ("0,0,1,0\n", "0,0,1,0,0\n", "zones.csv:8"),
        ("0,0,1,0\n", "\n", "zones.csv:8"),
        ("0,0,1,0\n", "0,0,1,full\n", "zones.csv:8: found `full`"),
        ("0,0,1,0\n", "0,0,1,True\n", "zones.csv:8: found `True`"),
        ("0,0,1,0\n", "0,0,1,nan\n", "zones.csv:8"),
        ("0,2,10\n", "0,two,10\n", "zones.csv:4"),
        ("0,2,10\n", "0,2,0\n", "zones.csv:4"),
        ("\n\n", "\n", "an empty line after the metadata"),
        ("IX,IY,IZ,value", "X,Y,Z,value", "zones.csv:6"),
        ("0,0,1,0\n", "0,0,\r1,0\n", "carriage return"),
    ] {
        let message = error(from, to);
        assert!(message.contains(says), "{to:?}: {message}");
    }
    // The twin of all of them reads.
    round_trips(NEW.as_bytes(), "zones.csv");
    assert!(read_lattice(b"", "empty.csv").is_err());
    assert!(read_lattice(&[0xff, 0xfe], "binary.csv").is_err());
    let shuffled = OLD_F.replace("1,0,0,2\n0,1,0,3\n", "0,1,0,3\n1,0,0,2\n");
    assert!(read_lattice(shuffled.as_bytes(), "old").is_err());
}

#[test]
fn occupancy_is_never_guessed() {
    let missing = Occupancy::require(None).expect_err("no rule").to_string();
    assert!(["== True", ">= 0", "!= -1", "> 0.5"].iter().all(|choice| missing.contains(choice)), "{missing}");
    let numbers = Values::Number(vec![-1.0, 0.0, 0.6]);
    let mask = |rule: &str| rule.parse::<Occupancy>().and_then(|r| r.mask(&numbers)).map_err(|e| e.to_string());
    assert_eq!(mask(">= 0"), Ok(vec![false, true, true]));
    assert_eq!(mask("!= -1"), Ok(vec![false, true, true]));
    assert_eq!(mask("> 0.5"), Ok(vec![false, false, true]));
    assert_eq!(mask("<=-1"), Ok(vec![true, false, false]));
    assert!(mask("== True").is_err_and(|e| e.contains("numbers")));
    for bad in ["", "0", "=> 0", "> True", "== maybe", ">= nan"] {
        assert!(bad.parse::<Occupancy>().is_err(), "{bad}");
    }
    let bools = Values::Bool(vec![true, false]);
    assert_eq!("!= False".parse::<Occupancy>().expect("a rule").mask(&bools), Ok(vec![true, false]));
    assert!(">= 0".parse::<Occupancy>().expect("a rule").mask(&bools).is_err());
}

#[test]
fn houses_round_trip_as_json_and_labels_as_lattice() {
    for (name, mut house) in samples::all() {
        house.voxels.origin_m = [-1.5, 0.1, 0.0];
        house.zones = house.voxels.labels().iter().map(|l| if l.is_filled() { 12 } else { -1 }).collect();
        let written = json::write(&house);
        assert_eq!(json::read(written.as_bytes(), name).expect("our own file"), house);
        let lattice = Lattice::from_voxels(&house.voxels);
        let back = read_lattice(&write_lattice(&lattice), name).expect("our own lattice").to_voxels().expect("labels");
        assert_eq!(back, house.voxels);
        let mut plain = back;
        plain.origin_m = [0.0; 3];
        assert_eq!(text::parse(&text::write(&plain)).expect("our own text"), plain);
    }
}

#[test]
fn json_faults_are_named() {
    let good = json::write(&samples::box_house());
    let error = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        json::read(good.replacen(from, to, 1).as_bytes(), "box.json").expect_err(to).to_string()
    };
    for (from, to, says) in [
        ("voxels/1", "voxels/2", "schema is \"houscaper.voxels/2\", expected \"houscaper.voxels/1\""),
        ("\"m\"", "\"mm\"", "unit"),
        ("\"up_axis\": \"z\"", "\"up_axis\": \"y\"", "up_axis"),
        ("\"unit\"", "\"color\": 1,\n  \"unit\"", "unknown field `color`"),
        ("\"window\": 5", "\"window\": 4", "labels.window is 4"),
        ("\"window\": 5", "\"glass\": 5", "labels.window is missing"),
        ("033333330", "03333333", "layers[0][1] is 8 digits long, expected 9"),
        ("033333330", "0333333x0", "layers[0][1]"),
        ("[9, 8, 8]", "[9, 8, 9]", "layers is 8 layers long"),
        ("[0.9, 0.9, 0.54]", "[0.9, 0, 0.54]", "module_size"),
        ("{", "[", "box.json:2:"),
    ] {
        let message = error(from, to);
        assert!(message.contains(says), "{to}: {message}");
    }
    let stairs = json::write(&samples::hip_house())
        .replace("\"start\": [3, 3]", "\"start\": [3, 33]")
        .replace("[3,3]", "[3,33]");
    assert!(json::read(stairs.as_bytes(), "hip.json").expect_err("outside").to_string().contains("stairs[0]"));
    // The thesis author's later file swaps 4 and 5: its map says so, and the labels come out right.
    let mut swapped = good.replace("\"opening\": 4, \"window\": 5", "\"opening\": 5, \"window\": 4");
    let start = swapped.find("layers").expect("layers");
    let layers = swapped.split_off(start).replace('4', "x").replace('5', "4").replace('x', "5");
    let house = json::read((swapped + &layers).as_bytes(), "swapped").expect("a valid file");
    assert_eq!(house, samples::box_house());
}

#[test]
fn text_faults_are_named() {
    assert_eq!(text::parse("12\n1").expect_err("ragged").to_string().split(':').next(), Some("line 2"));
    assert!(text::parse("16").expect_err("6").to_string().contains("`6`"));
    assert!(text::parse("11\n\n1\n1").is_err() && text::parse("\n").is_err());
    assert_eq!(text::parse("3").expect("one voxel").get([0, 0, 0]), Label::Foundation);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn any_labels_and_numbers_survive_files(
        shape in (1usize..4, 1usize..4, 1usize..4),
        codes in prop::collection::vec(0u8..6, 64),
        numbers in prop::collection::vec(-1e9f64..1e9, 64),
        ending in prop::sample::select(vec!["\n", "\r\n", "\r\r\n"]),
    ) {
        let shape = [shape.0, shape.1, shape.2];
        let count = shape.iter().product::<usize>();
        let labels = codes[..count].iter().map(|&c| Label::from_code(c).unwrap_or_default()).collect();
        let house = House::new(VoxelArray::from_labels(shape, labels).expect("as many as the shape"));
        prop_assert_eq!(json::read(json::write(&house).as_bytes(), "any").expect("our own file"), house.clone());
        let written = text_of(&Lattice::from_voxels(&house.voxels)).replace('\n', ending);
        prop_assert_eq!(round_trips(written.as_bytes(), "any").to_voxels().expect("labels"), house.voxels);
        let values = Values::Number(numbers[..count].to_vec());
        let lattice = Lattice::new(shape, [0.0; 3], [1.0; 3], values).expect("as many as the shape");
        let once = write_lattice(&lattice);
        round_trips(&once, "six digits");
    }
}
