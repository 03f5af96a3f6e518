//! Rule B: face numbers, surfaces from keys, and the scan that finds them.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

use houscaper::cubes::*;
use houscaper::tiles::*;
use houscaper::voxels::{Direction, Label, VoxelArray};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The architectural surface with other depths below the slab top than the surface tilesets have.
fn architectural() -> Style {
    Style { name: "architectural", decks: true, underside_mm: 235, ground_underside_mm: 90, ..Style::SURFACE_2 }
}

/// A mask with one label, `other` where `slabs` has a bit.
fn labels(mask: Mask) -> [Label; 8] {
    std::array::from_fn(|n| if mask.0 >> n & 1 == 1 { Label::Base } else { Label::Empty })
}

/// The two columns on each face, in the order of `Direction::ALL`.
const SIDES: [[usize; 2]; 4] = [[1, 3], [2, 3], [0, 2], [0, 1]];

fn is_roof(mask: Mask, q: usize) -> bool {
    mask.0 >> q & 1 == 1 && mask.0 >> (q + 4) & 1 == 0
}

/// Faces with a roof beside another column.
fn numbered(mask: Mask) -> [bool; 4] {
    SIDES.map(|[a, b]| is_roof(mask, a) != is_roof(mask, b))
}

/// Every base key of a mask with all numbers 0, 1, 2 on the faces that take one.
fn rule_b_keys(mask: Mask) -> Vec<CubeKey> {
    let mut all = vec![[FaceNumber::None; 4]];
    for (n, _) in numbered(mask).into_iter().enumerate().filter(|(_, yes)| *yes) {
        all = all
            .into_iter()
            .flat_map(|faces| {
                [0, 1, 2].map(|h| {
                    let mut with = faces;
                    with[n] = FaceNumber::end(h);
                    with
                })
            })
            .collect();
    }
    all.into_iter().map(|faces| CubeKey::new(labels(mask), faces, 0)).collect()
}

type Edges = BTreeSet<[[i32; 3]; 2]>;

fn sides(f: &Facet) -> impl Iterator<Item = [[i32; 3]; 2]> + '_ {
    (0..f.polygon.len()).map(|i| [f.polygon[i], f.polygon[(i + 1) % f.polygon.len()]])
}

fn edges(facets: &[KeyFacet]) -> Edges {
    let mut edges = Edges::new();
    for KeyFacet { facet, .. } in facets {
        for side in sides(facet) {
            assert!(edges.insert(side), "an edge twice");
        }
    }
    edges
}

/// The free edges on a face, seen from the cube below it along the axis.
fn curve(edges: &Edges, axis: Axis, high: bool) -> Edges {
    let a = axis as usize;
    let at = if high { CUBE_MM[a] } else { 0 };
    let flat = |mut p: [i32; 3]| {
        p[a] = 0;
        p
    };
    edges
        .iter()
        .filter(|[p, q]| !edges.contains(&[*q, *p]) && p[a] == at && q[a] == at)
        .map(|[p, q]| if high { [flat(*p), flat(*q)] } else { [flat(*q), flat(*p)] })
        .collect()
}

#[test]
fn the_894_tiles_are_disks_and_the_58_face_keys_have_one_curve_each() {
    for style in [Style::SURFACE_1, Style::SURFACE_2, architectural()] {
        let (mut tiles, mut split) = (0, Vec::new());
        let mut keys: BTreeMap<(Axis, u8, Option<i32>), Edges> = BTreeMap::new();
        for key in admissible_masks().flat_map(rule_b_keys) {
            tiles += 1;
            let facets = construct_key(key, &style);
            let edges = edges(&facets);
            let boundary: BTreeMap<_, _> =
                edges.iter().filter(|[a, b]| !edges.contains(&[*b, *a])).map(|[a, b]| (*a, *b)).collect();
            let vertices: BTreeSet<_> = edges.iter().map(|e| e[0]).collect();
            let undirected = (edges.len() + boundary.len()) / 2;
            let (&start, mut at) = boundary.iter().next().map(|(a, b)| (a, *b)).unwrap();
            let mut steps = 1;
            while at != start {
                at = boundary[&at];
                steps += 1;
            }
            if vertices.len() + facets.len() != undirected + 1 || steps != boundary.len() {
                split.push(key);
            }
            for (a, b) in &boundary {
                assert!((0..3).any(|i| a[i] == b[i] && (a[i] == 0 || a[i] == CUBE_MM[i])), "{key}: {a:?} {b:?}");
            }
            for KeyFacet { facet, .. } in &facets {
                assert_eq!(out_of_plane(&facet.polygon), 0.0);
                assert!(Patch::new(facet.clone()).is_some(), "{key}: {facet:?}");
            }
            for axis in Axis::ALL {
                for high in [false, true] {
                    let number = match (axis, high) {
                        (Axis::X, true) => key.face(Direction::East),
                        (Axis::X, false) => key.face(Direction::West),
                        (Axis::Y, true) => key.face(Direction::North),
                        (Axis::Y, false) => key.face(Direction::South),
                        (Axis::Z, _) => FaceNumber::None,
                    };
                    let seen = curve(&edges, axis, high);
                    let pattern = key.mask().face(axis, high);
                    let first = keys.entry((axis, pattern, number.height())).or_insert_with(|| seen.clone());
                    assert_eq!(*first, seen, "{} {key} {axis:?} {high}", style.name);
                    assert_eq!(seen.is_empty(), [0, 15].contains(&pattern), "{key}");
                }
            }
        }
        assert_eq!(tiles, 894);
        assert_eq!(keys.len(), 58);
        assert_eq!(split, [], "{}", style.name);
    }
}

#[test]
fn a_key_without_numbers_and_decks_is_the_tile_of_its_mask() {
    for style in [Style::SURFACE_1, Style::SURFACE_2, Style::LINEAR] {
        for mask in admissible_masks() {
            let facets: Vec<Facet> =
                construct_key(CubeKey::of_labels(labels(mask)), &style).into_iter().map(|f| f.facet).collect();
            assert_eq!(facets, construct(mask, 0, &style));
        }
    }
    // Decks are those of `flat`.
    let style = Style { decks: true, ..Style::SURFACE_2 };
    for mask in admissible_masks() {
        for flat in 0..16u8 {
            let mut with = labels(mask);
            (0..4).filter(|q| flat & mask.bottom() & !mask.top() & 1 << q != 0).for_each(|q| with[q] = Label::Floor);
            let facets: Vec<Facet> =
                construct_key(CubeKey::of_labels(with), &style).into_iter().map(|f| f.facet).collect();
            assert_eq!(facets, construct(mask, flat, &style), "{mask} {flat}");
        }
    }
}

#[test]
fn keys_turn_and_mirror_with_their_tiles() {
    let style = architectural();
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    for mask in admissible_masks() {
        for key in rule_b_keys(mask) {
            let coloured = key
                .labels()
                .map(|l| if l.is_filled() { Label::from_code(rng.random_range(1..=5)).unwrap() } else { l });
            let key = CubeKey::new(coloured, key.faces(), 0);
            let facets = construct_key(key, &style);
            for s in Symmetry::all() {
                let place = |f: &KeyFacet| KeyFacet { facet: f.facet.placed(s, CUBE_MM).normalised(), label: f.label };
                let placed: BTreeSet<_> = facets.iter().map(place).collect();
                let made: BTreeSet<_> = construct_key(key.placed(s), &style)
                    .into_iter()
                    .map(|f| KeyFacet { facet: f.facet.normalised(), label: f.label })
                    .collect();
                assert_eq!(placed, made, "{key} {s:?}");
            }
        }
    }
}

/// How often a directed edge is used more than its reverse.
type NetEdges = BTreeMap<[[i32; 3]; 2], i32>;

/// Edges of a mixture of labels, where two bodies may touch along an edge.
fn net_edges(facets: &[KeyFacet]) -> NetEdges {
    let mut net = NetEdges::new();
    for KeyFacet { facet, .. } in facets {
        for [a, b] in sides(facet) {
            *net.entry([a, b]).or_default() += 1;
            *net.entry([b, a]).or_default() -= 1;
        }
    }
    net.retain(|_, n| *n > 0);
    net
}

/// The free edges on a face, seen from the cube below it along the axis; every free edge lies on some face. Those on an edge of the
/// cube (a deck's outline) belong to the vertical face.
fn net_curve(edges: &NetEdges, axis: Axis, high: bool) -> NetEdges {
    let a = axis as usize;
    let at = if high { CUBE_MM[a] } else { 0 };
    let flat = |mut p: [i32; 3]| {
        p[a] = 0;
        p
    };
    for [p, q] in edges.keys() {
        assert!((0..3).any(|i| p[i] == q[i] && (p[i] == 0 || p[i] == CUBE_MM[i])), "a hole inside: {p:?} {q:?}");
    }
    edges
        .iter()
        .filter(|([p, q], _)| p[a] == at && q[a] == at)
        .filter(|([p, q], _)| axis != Axis::Z || (0..2).all(|i| p[i] != q[i] || p[i] == CUBE_MM[i] / 2))
        .map(|([p, q], n)| (if high { [flat(*p), flat(*q)] } else { [flat(*q), flat(*p)] }, *n))
        .collect()
}

/// What decides the surface on a face: its four labels, as kinds of label, and its number.
#[test]
fn labels_of_any_mixture_meet_on_every_face() {
    let style = architectural();
    let mut curves: HashMap<(Axis, [Label; 4], Option<i32>), NetEdges> = HashMap::new();
    let kinds = [Label::Base, Label::Floor, Label::Foundation];
    let (mut tiles, mut crowded) = (0, 0);
    for (mask, shift) in admissible_masks().flat_map(|mask| [0, 1, 2].map(|shift| (mask, shift))) {
        let filled: Vec<usize> = (0..8).filter(|n| mask.0 >> n & 1 == 1).collect();
        for mut code in 0..3usize.pow(filled.len() as u32) {
            let mut labels = [Label::Empty; 8];
            for &n in &filled {
                labels[n] = kinds[code % 3];
                code /= 3;
            }
            // Numbers of the faces that take one, from the labels of the face so that both sides choose alike.
            let faces = SIDES.map(|[a, b]| {
                let roof = |q: usize| labels[q] == Label::Base && labels[q + 4] == Label::Empty;
                if roof(a) == roof(b) {
                    FaceNumber::None
                } else {
                    FaceNumber::end((labels[a] as i32 + labels[b + 4] as i32 + shift) % 3)
                }
            });
            let key = CubeKey::new(labels, faces, 0);
            tiles += 1;
            let facets = construct_key(key, &style);
            let edges = net_edges(&facets);
            let used: Vec<_> = facets.iter().flat_map(|f| sides(&f.facet)).collect();
            crowded += usize::from(used.len() > used.iter().collect::<BTreeSet<_>>().len());
            for axis in Axis::ALL {
                for high in [false, true] {
                    let a = axis as usize;
                    let on: Vec<Label> =
                        (0..8).filter(|n| n >> a & 1 == usize::from(high)).map(|n| labels[n]).collect();
                    let face = on.try_into().unwrap();
                    let number = match axis {
                        Axis::X => key.face(if high { Direction::East } else { Direction::West }),
                        Axis::Y => key.face(if high { Direction::North } else { Direction::South }),
                        Axis::Z => FaceNumber::None,
                    };
                    let seen = net_curve(&edges, axis, high);
                    let first = curves.entry((axis, face, number.height())).or_insert_with(|| seen.clone());
                    assert_eq!(*first, seen, "{key} {axis:?} {high}");
                }
            }
        }
    }
    eprintln!(
        "{tiles} coloured tiles, {} face keys, {crowded} tiles with an edge in which two bodies touch",
        curves.len()
    );
}

fn random_labels(rng: &mut ChaCha8Rng, shape: [usize; 3]) -> VoxelArray {
    let mut voxels = VoxelArray::new(shape);
    let roofs = rng.random_bool(0.5);
    for n in 0..shape.iter().product::<usize>() {
        let at = [n % shape[0], n / shape[0] % shape[1], n / (shape[0] * shape[1])];
        // Half of the arrays are mostly hills of base: many roofs and slopes.
        let hill = at[2] <= (at[0] * 3 + at[1] * 5) % 4;
        let label = if roofs && rng.random_bool(0.8) {
            if hill { Label::Base } else { Label::Empty }
        } else {
            Label::from_code(rng.random_range(0..=5)).unwrap()
        };
        voxels.set(at, label);
    }
    voxels
}

fn walked_by_place(voxel: [usize; 3]) -> bool {
    (voxel[0] + voxel[1]).is_multiple_of(2)
}

fn all_keys(voxels: &VoxelArray, rule: Rule) -> Vec<([usize; 3], CubeKey)> {
    let [nx, ny, nz] = cube_shape(voxels);
    let cubes = (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])));
    cubes.map(|cube| (cube, cube_key(voxels, cube, rule, walked_by_place))).collect()
}

#[test]
fn the_scan_visits_every_cube_in_which_something_stands() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let shapes =
        [[1, 1, 1], [3, 1, 2], [4, 5, 3], [2, 6, 6], [62, 2, 2], [63, 3, 2], [64, 2, 1], [70, 3, 3], [130, 3, 4]];
    for shape in shapes.into_iter().cycle().take(90) {
        let voxels = random_labels(&mut rng, shape);
        for rule in [Rule::A, Rule::B] {
            let mut fast = Vec::new();
            scan_keys(&voxels, rule, walked_by_place, |cube, key| fast.push((cube, key)));
            let stands = |key: CubeKey| match key.mask() {
                Mask::EMPTY => false,
                Mask::FULL => key.labels().iter().any(|l| l.is_slab()),
                _ => true,
            };
            let slow: Vec<_> = all_keys(&voxels, rule).into_iter().filter(|(_, key)| stands(*key)).collect();
            assert_eq!(fast, slow, "{shape:?}");
        }
    }
    scan_keys(&VoxelArray::new([0, 3, 2]), Rule::B, |_| true, |cube, _| panic!("nothing to visit, but {cube:?}"));
}

#[test]
fn one_voxel_changes_at_most_8_keys_under_rule_a_and_64_under_rule_b() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut most = [0; 2];
    for round in 0..4000 {
        let shape = [7, 7, 7];
        let mut voxels = random_labels(&mut rng, shape);
        if round % 4 > 0 {
            // A landscape of roofs: heights in columns.
            for x in 0..7 {
                for y in 0..7 {
                    let height = rng.random_range(2..=5);
                    (0..7).for_each(|z| voxels.set([x, y, z], if z < height { Label::Base } else { Label::Empty }));
                }
            }
        }
        let at = [rng.random_range(2..5), rng.random_range(2..5), rng.random_range(2..6)];
        let before = [Rule::A, Rule::B].map(|rule| all_keys(&voxels, rule));
        let label = Label::from_code(rng.random_range(0..=5)).unwrap();
        voxels.set(at, label);
        for (n, rule) in [Rule::A, Rule::B].into_iter().enumerate() {
            let changed: Vec<[usize; 3]> =
                all_keys(&voxels, rule).iter().zip(&before[n]).filter(|(a, b)| a != b).map(|(a, _)| a.0).collect();
            most[n] = most[n].max(changed.len());
            // Cubes around the voxel's own eight: one more on every side, and one more above and below.
            let reach = n;
            for cube in changed {
                for a in 0..3 {
                    assert!(cube[a] + reach >= at[a] && cube[a] <= at[a] + 1 + reach, "{rule:?} {cube:?} of {at:?}");
                }
            }
        }
    }
    eprintln!("most keys changed by one voxel: {} under rule A, {} under rule B", most[0], most[1]);
    assert!(most[0] == 8 && most[1] > 8 && most[1] <= 64, "{most:?}");
}

/// A landscape from digits: heights of base columns, first line north.
fn heights(rows: &[&str]) -> VoxelArray {
    let top = 7;
    let mut voxels = VoxelArray::new([rows[0].len(), rows.len(), top]);
    for (n, row) in rows.iter().rev().enumerate() {
        for (x, c) in row.bytes().enumerate() {
            (0..usize::from(c - b'0')).for_each(|z| voxels.set([x, n, z], Label::Base));
        }
    }
    voxels
}

fn number(voxels: &VoxelArray, [x, y]: [isize; 2], towards: Direction) -> FaceNumber {
    let top = (0..7).rev().find(|&z| voxels.at([x, y, z]).is_filled()).unwrap();
    face_number(voxels, [x, y, top], towards)
}

#[test]
fn roofs_end_as_builders_end_them() {
    use Direction::{East, North, South, West};
    use FaceNumber::{End0, End1, End2, None, StepDown, StepUp};
    // A gable: the slopes run to straight verges at both ends, eaves at the sides, level along the ridge.
    let gable = heights(&["1111", "2222", "3333", "2222", "1111"]);
    for (y, height) in [(0, End0), (4, End0)] {
        let out = if y == 0 { South } else { North };
        assert_eq!(number(&gable, [1, y], out), height, "eaves");
        assert_eq!(number(&gable, [1, y], out.back()), StepUp);
    }
    for y in 0..5 {
        assert_eq!(
            number(&gable, [0, y], West),
            if y == 0 || y == 4 { End1.min(number(&gable, [0, y], West)) } else { End1 }
        );
        assert_eq!(number(&gable, [0, y], East), None);
    }
    assert_eq!((number(&gable, [2, 2], North), number(&gable, [2, 2], South)), (StepDown, StepDown));
    // A hip: its corners stay down.
    let hip = heights(&["11111", "12221", "12321", "12221", "11111"]);
    for (at, d) in [([0, 0], South), ([0, 0], West), ([4, 4], North), ([4, 4], East), ([2, 0], South)] {
        assert_eq!(number(&hip, at, d), End0, "{at:?} {d:?}");
    }
    // A level roof to its edge, level against a tall wall when it is two deep.
    let plateau = heights(&["6666", "1111", "1111"]);
    assert_eq!(number(&plateau, [1, 0], South), End1);
    assert_eq!(number(&plateau, [1, 1], North), End1);
    // A lean-to: one deep.
    let lean = heights(&["6666", "1111"]);
    assert_eq!((number(&lean, [1, 0], North), number(&lean, [1, 0], South)), (End2, End0));
    // A single-sided roof rises to its edge when the top row is one wide, and ends level when it is two wide.
    let mono = heights(&["111", "222", "333"]);
    assert_eq!(number(&mono, [1, 0], South), End2);
    let blunt = heights(&["111", "222", "222"]);
    assert_eq!(number(&blunt, [1, 0], South), End1);
    // A tower with a roof around its foot: lean-tos with hips at the corners.
    let ring = heights(&["111111", "166661", "166661", "166661", "166661", "111111"]);
    for x in 0..6 {
        assert_eq!(number(&ring, [x, 0], South), End0, "{x}");
    }
    assert_eq!(number(&ring, [2, 0], North), End2);
    // A chimney one voxel from the edge of a level roof: nothing rises or dips beside it.
    let chimney = heights(&["11111", "11111", "11311", "11111"]);
    for x in 0..5 {
        assert_eq!(number(&chimney, [x, 0], South), End1, "{x}");
    }
    assert_eq!(number(&chimney, [2, 0], North), End1);
    assert_eq!(number(&chimney, [1, 1], East), End1);
    // The same in the slope of a gable, two rows up and one: the slope goes on to it and from it.
    let slope = heights(&["11111", "22222", "33633", "22222", "11111"]);
    assert_eq!((number(&slope, [2, 1], North), number(&slope, [1, 2], East)), (End2, End1));
    let eaves = heights(&["11111", "22222", "33333", "22622", "11111"]);
    assert_eq!((number(&eaves, [2, 0], South), number(&eaves, [2, 0], North)), (End0, End2));
    assert_eq!(number(&eaves, [2, 2], South), End0, "above the chimney the slope falls to it");
    // Nothing to say of slabs and of what carries something.
    let mut deck = heights(&["11", "11"]);
    deck.set([0, 0, 0], Label::Floor);
    assert_eq!(number(&deck, [0, 0], North), None);
    assert_eq!(number(&deck, [1, 0], West), End1, "a deck is a free edge");
    assert_eq!(face_number(&gable, [2, 2, 0], North), None);
}
