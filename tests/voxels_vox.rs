//! MagicaVoxel files: our own come back exactly, foreign ones are read for what they are, bad ones are refused in one sentence.

use dot_vox::{Color, Dict, DotVoxData, Frame, Layer, Model, SceneNode, ShapeModel, Size, Voxel};
use houscaper::voxels::vox::{ColourMap, LABEL_COLOURS, VoxError, VoxScene, read, rescale, write};
use houscaper::voxels::{Label, Module, VoxelArray, samples};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn plain(bytes: &[u8]) -> Result<VoxScene, VoxError> {
    read(bytes, "test.vox", &ColourMap::default())
}

fn reference(name: &str) -> Option<Vec<u8>> {
    let beside = std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let root = std::env::var_os("HOUSCAPER_SHARED").map_or(beside, std::path::PathBuf::from);
    let bytes = std::fs::read(root.join("reference/vox").join(name)).ok();
    if bytes.is_none() {
        eprintln!("skipped: no reference file {name} (set HOUSCAPER_SHARED)");
    }
    bytes
}

#[test]
fn our_own_files_come_back_exactly() {
    let mut arrays: Vec<VoxelArray> = samples::gallery().into_iter().map(|(_, h)| h.voxels).collect();
    arrays.extend(samples::all().into_iter().map(|(_, h)| h.voxels));
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    for _ in 0..40 {
        let shape = [rng.random_range(1..9), rng.random_range(1..9), rng.random_range(1..9)];
        let labels = (0..shape.iter().product()).map(|_| Label::ALL[rng.random_range(0..6)]).collect();
        arrays.push(VoxelArray::from_labels(shape, labels).expect("as many labels as voxels"));
    }
    arrays.push(VoxelArray::new([256, 1, 2])); // the widest, and nothing in it
    for voxels in arrays {
        let bytes = write(&voxels).expect("within 256 voxels");
        let scene = plain(&bytes).expect("our own file");
        assert_eq!((scene.foreign, scene.models, scene.palette), (0, 1, true));
        assert!(scene.voxels == voxels, "{:?}", voxels.shape());
        assert_eq!(write(&scene.voxels).expect("within 256 voxels"), bytes);
    }
}

#[test]
fn arrays_that_do_not_fit_the_format_are_refused() {
    for shape in [[257, 1, 1], [1, 1, 300], [0, 4, 4]] {
        assert_eq!(write(&VoxelArray::new(shape)), Err(VoxError::TooLarge { found: shape }));
    }
}

#[test]
fn foreign_colours_count_as_base_until_they_are_named() {
    let Some(bytes) = reference("obj_house7.vox") else { return };
    let scene = plain(&bytes).expect("a real file");
    assert_eq!((scene.voxels.shape(), scene.voxels.filled_count()), ([32, 32, 32], 16026));
    assert_eq!((scene.foreign, scene.palette, scene.models), (16026, false, 1));
    assert_eq!(&scene.foreign_colours[..2], [(199, 13661), (157, 1043)]);
    assert!(scene.voxels.labels().iter().all(|l| matches!(l, Label::Empty | Label::Base)));
    // Palette index 199 of the default palette is #993333.
    for map in ["199=window,251=empty,250=door", "199=window,251=opening,x=base", "199", "#99999=base", "0=base"] {
        assert!(map.parse::<ColourMap>().is_err(), "{map}");
    }
    let count = |map: &str, label: Label| {
        let scene = read(&bytes, "house7", &map.parse().expect("a map")).expect("a real file");
        (scene.voxels.labels().iter().filter(|l| **l == label).count(), scene.foreign)
    };
    assert_eq!(count("157=window", Label::Window), (1043, 16026 - 1043));
    assert_eq!(count("157=empty,199=floor", Label::Floor), (13661, 16026 - 1043 - 13661));
    assert_eq!(count("157=empty", Label::Base), (16026 - 1043, 16026 - 1043));
    assert_eq!(count("157=window,157=opening", Label::Opening).0, 0, "the first entry holds");
}

#[test]
fn a_palette_decides_by_colour_and_a_map_by_either() {
    let mut data = file(vec![model([2, 1, 1], &[([0, 0, 0], 1), ([1, 0, 0], 2)])]);
    let [r, g, b] = LABEL_COLOURS[4].1;
    data.palette[0] = Color { r: 1, g: 2, b: 3, a: 255 };
    data.palette[1] = Color { r, g, b, a: 0 };
    let bytes = bytes(&data);
    let scene = plain(&bytes).expect("a file");
    assert_eq!(scene.voxels.labels(), [Label::Base, Label::Window]);
    assert_eq!((scene.foreign, scene.foreign_colours), (1, vec![(1, 1)]));
    let scene = read(&bytes, "f", &"#010203=floor,2=opening".parse().expect("a map")).expect("a file");
    assert_eq!((scene.voxels.labels(), scene.foreign), (&[Label::Floor, Label::Opening][..], 0));
}

#[test]
fn scenes_of_the_reference_are_read() {
    for (name, shape, count) in [("castle_wall_top.vox", [5, 5, 5], 13), ("columns.vox", [8, 8, 8], 89)] {
        let Some(bytes) = reference(name) else { return };
        let scene = plain(&bytes).expect("a real file");
        assert_eq!((scene.voxels.shape(), scene.voxels.filled_count()), (shape, count), "{name}");
        assert!(scene.palette && scene.models == 1);
    }
}

fn model(size: [u32; 3], voxels: &[([u8; 3], u8)]) -> Model {
    let [x, y, z] = size;
    let voxels = voxels.iter().map(|&([x, y, z], colour)| Voxel { x, y, z, i: colour - 1 }).collect();
    Model { size: Size { x, y, z }, voxels }
}

/// A file of models without a scene, whose palette begins with our five colours.
fn file(models: Vec<Model>) -> DotVoxData {
    let mut palette = dot_vox::DEFAULT_PALETTE.to_vec();
    for (n, (_, [r, g, b])) in LABEL_COLOURS.into_iter().enumerate() {
        palette[n] = Color { r, g, b, a: 255 };
    }
    DotVoxData { version: 150, index_map: vec![], models, palette, materials: vec![], scenes: vec![], layers: vec![] }
}

fn bytes(data: &DotVoxData) -> Vec<u8> {
    let mut bytes = Vec::new();
    data.write_vox(&mut bytes).expect("a Vec takes everything");
    bytes
}

fn dict(entries: &[(&str, &str)]) -> Dict {
    entries.iter().map(|(k, v)| (k.to_string(), v.to_string())).collect()
}

fn transform(child: u32, frame: &[(&str, &str)], attributes: &[(&str, &str)], layer_id: u32) -> SceneNode {
    SceneNode::Transform { attributes: dict(attributes), frames: vec![Frame::new(dict(frame))], child, layer_id }
}

fn shape(model_id: u32) -> SceneNode {
    SceneNode::Shape { attributes: Dict::new(), models: vec![ShapeModel { model_id, attributes: Dict::new() }] }
}

fn group(children: &[u32]) -> SceneNode {
    SceneNode::Group { attributes: Dict::new(), children: children.to_vec() }
}

/// A model with the attributes of its frame and of its transform.
type Part<'a> = (u32, &'a [(&'a str, &'a str)], &'a [(&'a str, &'a str)]);

/// A root with one transform per part.
fn scene(mut data: DotVoxData, parts: &[Part]) -> DotVoxData {
    let first = |n: usize| 2 + 2 * n as u32;
    data.scenes = vec![transform(1, &[], &[], u32::MAX), group(&(0..parts.len()).map(first).collect::<Vec<_>>())];
    for (n, (model, frame, attributes)) in parts.iter().enumerate() {
        data.scenes.push(transform(first(n) + 1, frame, attributes, 0));
        data.scenes.push(shape(*model));
    }
    data.layers = vec![Layer { attributes: Dict::new() }];
    data
}

#[test]
fn models_stand_where_the_scene_puts_them() {
    // A bar of three along x, base at its low end and window at its high end; pivot at voxel 1.
    let bar = || model([3, 1, 1], &[([0, 0, 0], 1), ([1, 0, 0], 2), ([2, 0, 0], 5)]);
    let labels = |parts: &[Part]| {
        let data = scene(file(vec![bar()]), parts);
        let scene = plain(&bytes(&data)).expect("a scene");
        (scene.voxels.shape(), scene.voxels.labels().to_vec(), scene.models, scene.hidden)
    };
    let (b, f, w, e) = (Label::Base, Label::Floor, Label::Window, Label::Empty);
    assert_eq!(labels(&[(0, &[], &[])]), ([3, 1, 1], vec![b, f, w], 1, 0));
    // A quarter turn about z: x' = -y, y' = x (rows 1 and 0, the first negative).
    let quarter = (1u8 | 1 << 4).to_string();
    assert_eq!(labels(&[(0, &[("_r", &quarter)], &[])]), ([1, 3, 1], vec![b, f, w], 1, 0));
    // Mirrored along x.
    let mirror = (4u8 | 1 << 4).to_string();
    assert_eq!(labels(&[(0, &[("_r", &mirror)], &[])]), ([3, 1, 1], vec![w, f, b], 1, 0));
    // Two: the second one stands two higher and one further, and shows where they overlap not at all.
    let two = labels(&[(0, &[], &[]), (0, &[("_t", "1 0 2")], &[])]);
    assert_eq!(two, ([4, 1, 3], vec![b, f, w, e, e, e, e, e, e, b, f, w], 2, 0));
    // The later one shows where they overlap.
    let over = labels(&[(0, &[], &[]), (0, &[("_r", &mirror), ("_t", "2 0 0")], &[])]);
    assert_eq!((over.0, over.1), ([4, 1, 1], vec![b, w, f, b]));
    // Hidden ones do not count.
    assert_eq!(
        labels(&[(0, &[], &[]), (0, &[("_t", "9 9 9")], &[("_hidden", "1")])]),
        ([3, 1, 1], vec![b, f, w], 1, 1)
    );
}

/// All 48 turns and mirrors of a model of three sizes: the box turns with it and no voxel is lost.
#[test]
fn every_turn_keeps_every_voxel() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut cells: Vec<([u8; 3], u8)> = Vec::new();
    for z in 0..4u8 {
        for y in 0..3u8 {
            for x in 0..2u8 {
                if rng.random_bool(0.6) {
                    cells.push(([x, y, z], 1 + rng.random_range(0..5)));
                }
            }
        }
    }
    let mut good = 0;
    for byte in 0..=255u8 {
        let text = byte.to_string();
        let data = scene(file(vec![model([2, 3, 4], &cells)]), &[(0, &[("_r", &text)], &[])]);
        let (first, second) = (byte & 3, byte >> 2 & 3);
        let valid = first < 3 && second < 3 && first != second && byte < 128;
        match plain(&bytes(&data)) {
            Ok(scene) => {
                assert!(valid, "{byte}");
                good += 1;
                let axes = [first, second, 3 - first - second].map(usize::from);
                assert_eq!(scene.voxels.shape(), axes.map(|a| [2, 3, 4][a]));
                assert_eq!(scene.voxels.filled_count(), cells.len());
                for &(cell, colour) in &cells {
                    let sign = |row: usize| byte >> (4 + row) & 1 == 1;
                    let at = [0, 1, 2].map(|row| {
                        let (c, size) = (usize::from(cell[axes[row]]), [2, 3, 4][axes[row]]);
                        if sign(row) { size - 1 - c } else { c }
                    });
                    assert_eq!(scene.voxels.get(at).code(), colour, "{byte} {cell:?}");
                }
            }
            Err(error) => assert!(!valid && error.to_string().contains("rotation"), "{byte}: {error}"),
        }
    }
    assert_eq!(good, 48);
}

#[test]
fn what_cannot_be_followed_is_refused_by_name() {
    let bar = || model([3, 1, 1], &[([0, 0, 0], 1)]);
    let good = scene(file(vec![bar()]), &[(0, &[], &[])]);
    assert!(plain(&bytes(&good)).is_ok());
    let refuse = |data: &DotVoxData, part: &str| {
        let error = plain(&bytes(data)).expect_err(part).to_string();
        assert!(error.contains(part) && error.starts_with("test.vox: ") && error.lines().count() == 1, "{error}");
    };
    refuse(&file(vec![bar(), bar()]), "2 models, but nothing says where they stand");
    refuse(&file(vec![]), "no model is visible");
    refuse(&file(vec![model([0, 1, 1], &[])]), "model 0: size [0, 1, 1]");
    refuse(&file(vec![model([257, 1, 1], &[])]), "model 0: size [257, 1, 1]");
    refuse(&file(vec![model([1, 1, 1], &[([1, 0, 0], 1)])]), "voxel [1, 0, 0] lies outside");
    refuse(&scene(file(vec![bar()]), &[(1, &[], &[])]), "shows model 1, but the file has 1");
    refuse(&scene(file(vec![bar()]), &[(0, &[("_t", "1 2")], &[])]), "translation `1 2`");
    refuse(&scene(file(vec![bar()]), &[(0, &[("_t", "1 2 999999999999")], &[])]), "translation");
    refuse(&scene(file(vec![bar()]), &[(0, &[], &[]), (0, &[("_t", "50000 50000 9")], &[])]), "span");
    let mut cycle = scene(file(vec![bar()]), &[(0, &[], &[])]);
    cycle.scenes[1] = group(&[0]);
    refuse(&cycle, "node 0 is met twice");
    cycle.scenes[1] = group(&[77]);
    refuse(&cycle, "node 77 is missing");
    for (bytes, part) in [
        (&b""[..], "the file ends"),
        (b"IX,IY,IZ,value and more text than a head", "this is no MagicaVoxel file"),
        (b"VOX \x96\0\0\0MAIN\0\0\0\0\x08\0\0\0SIZE", "MAIN of 8 bytes in a file with 4"),
    ] {
        assert!(plain(bytes).expect_err(part).to_string().contains(part));
    }
    // Chunks inside a chunk inside MAIN: the parser would follow them as deep as they go.
    let mut nested = Vec::new();
    for _ in 0..100_000 {
        let mut outer = b"nest\0\0\0\0".to_vec();
        outer.extend((nested.len() as u32).to_le_bytes());
        if nested.len() > 400_000 {
            break;
        }
        outer.append(&mut nested);
        nested = outer;
    }
    let mut deep = b"VOX \x96\0\0\0MAIN\0\0\0\0".to_vec();
    deep.extend((nested.len() as u32).to_le_bytes());
    deep.extend(nested);
    assert!(plain(&deep).expect_err("nested").to_string().contains("chunks inside chunk `nest`"));
}

/// Cut at every length and with bytes changed at random: an answer or one sentence, never a panic.
#[test]
fn garbage_gives_one_sentence() {
    let bar = model([3, 2, 2], &[([0, 0, 0], 1), ([2, 1, 1], 5)]);
    let parts: [Part; 2] = [(0, &[("_t", "1 2 3")], &[]), (0, &[("_r", "20")], &[])];
    let sources = [bytes(&scene(file(vec![bar]), &parts)), write(&samples::box_house().voxels).expect("small")];
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut refused = 0;
    for source in &sources {
        for length in 0..source.len() {
            let error = plain(&source[..length]).expect_err("cut short").to_string();
            assert_eq!(error.lines().count(), 1, "{error}");
        }
        for _ in 0..4000 {
            let mut bytes = source.clone();
            for _ in 0..rng.random_range(1..6) {
                let at = rng.random_range(0..bytes.len());
                bytes[at] =
                    if rng.random_bool(0.5) { rng.random() } else { [0, 1, 0x7f, 0xff][rng.random_range(0..4)] };
            }
            if let Err(error) = plain(&bytes) {
                assert_eq!(error.to_string().lines().count(), 1, "{error}");
                refused += 1;
            }
        }
    }
    assert!(refused > 1000, "{refused}");
}

#[test]
fn rescaling_keeps_volume_and_majority() {
    let house = samples::box_house().voxels;
    let module = Module { size_m: [1.0, 1.0, 1.0] };
    // One to one, and every voxel of a doubled array back to one.
    assert_eq!(rescale(&house, 1.0, module).expect("a size").labels(), house.labels());
    let [nx, ny, nz] = house.shape();
    let mut double = VoxelArray::new([2 * nx, 2 * ny, 2 * nz]);
    for v in double.clone().iter().map(|(v, _)| v) {
        double.set(v, house.get(v.map(|c| c / 2)));
    }
    let back = rescale(&double, 0.5, module).expect("a size");
    assert_eq!((back.shape(), back.labels()), (house.shape(), house.labels()));
    // Three voxels of 0.6 on two modules of 0.9: the middle one is shared, and half is enough.
    let row = |labels: [Label; 3]| VoxelArray::from_labels([3, 1, 1], labels.to_vec()).expect("three");
    let wide = Module { size_m: [0.9, 0.6, 0.6] };
    let (b, w, e) = (Label::Base, Label::Window, Label::Empty);
    for (labels, expected) in [([b, e, e], [b, e]), ([e, b, e], [e, e]), ([e, b, w], [e, w]), ([w, b, b], [w, b])] {
        let out = rescale(&row(labels), 0.6, wide).expect("a size");
        assert_eq!(out.labels(), expected, "{labels:?}");
        assert_eq!(out.module, wide);
    }
    for bad in [0.0, -1.0, f64::NAN, 1e9] {
        assert!(rescale(&house, bad, module).is_err(), "{bad}");
    }
}
