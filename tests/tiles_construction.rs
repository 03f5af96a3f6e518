//! The construction rule: golden tiles, symmetry, disks, seams.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

use houscaper::cubes::*;
use houscaper::tiles::*;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

const GOLDEN: [Style; 2] = [Style::SURFACE_1, Style::SURFACE_2];
const STYLES: [Style; 3] = [Style::SURFACE_1, Style::SURFACE_1_OFFSET, Style::SURFACE_2];

fn facets(mask: Mask, style: &Style) -> BTreeSet<Facet> {
    construct(mask, 0, style).into_iter().map(Facet::normalised).collect()
}

fn in_memory(style: &Style) -> Tileset {
    Tileset::from_facets(style.name, CUBE_MM, |mask| construct(mask, 0, style))
}

fn shared(path: &str) -> Option<PathBuf> {
    let beside = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let root = std::env::var_os("HOUSCAPER_SHARED").map_or(beside, PathBuf::from);
    Some(root.join(path)).filter(|p| p.exists())
}

#[test]
fn both_styles_reproduce_the_golden_tiles() {
    for style in GOLDEN {
        let Some(path) = shared(&format!("reference/tilesets/{}.json", style.name)) else {
            eprintln!("skipped: no golden {} (set HOUSCAPER_SHARED)", style.name);
            continue;
        };
        let golden: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        let tiles = golden.as_array().unwrap();
        assert_eq!(tiles.len(), 26);
        for tile in tiles {
            let mask = Mask(tile["mask"].as_u64().unwrap() as u8);
            let expected: BTreeSet<Facet> = tile["patches"]
                .as_array()
                .unwrap()
                .iter()
                .map(|p| Facet {
                    kind: PatchKind::ALL.into_iter().find(|k| k.name() == p["kind"]).unwrap(),
                    octant: p["octant"].as_u64().unwrap() as u8,
                    polygon: serde_json::from_value(p["poly"].clone()).unwrap(),
                })
                .map(Facet::normalised)
                .collect();
            assert_eq!(facets(mask, &style), expected, "{} {mask}", style.name);
            let members: BTreeSet<u8> = Symmetry::all().map(|s| s.mask(mask).0).collect();
            assert_eq!(serde_json::to_value(members).unwrap(), tile["members"]);
        }
    }
}

#[test]
fn every_tile_is_its_canonical_tile_mirrored_and_turned() {
    for style in STYLES {
        for mask in admissible_masks() {
            for s in Symmetry::all() {
                let placed: BTreeSet<Facet> =
                    facets(mask, &style).iter().map(|f| f.placed(s, CUBE_MM).normalised()).collect();
                assert_eq!(placed, facets(s.mask(mask), &style), "{} {mask} {s:?}", style.name);
            }
        }
    }
    for mask in admissible_masks().chain([Mask::FULL]) {
        for s in Symmetry::all() {
            let mut placed: Vec<Line> = skeleton(mask).iter().map(|l| l.placed(s, CUBE_MM)).collect();
            placed.sort_unstable();
            assert_eq!(placed, skeleton(s.mask(mask)), "{mask} {s:?}");
        }
    }
}

/// Triangles of all 126 tiles: 1,200 in surface 1, 1,184 in surface 2 (prototype of the rule).
#[test]
fn the_number_of_triangles_is_the_known_one() {
    for (style, count) in GOLDEN.iter().zip([1200, 1184]) {
        let set = in_memory(style);
        let triangles: usize = admissible_masks().flat_map(|m| set.patches(m)).map(|p| p.triangles.len()).sum();
        assert_eq!(triangles, count, "{}", style.name);
        for patch in admissible_masks().flat_map(|m| set.patches(m)) {
            let cut: f64 = patch
                .triangles
                .iter()
                .map(|t| doubled_area(&t.map(|i| patch.polygon[i as usize])))
                .map(|n| 0.5e-6 * n.iter().map(|&c| (c as f64).powi(2)).sum::<f64>().sqrt())
                .sum();
            assert!((cut - patch.area_m2([1.0; 3])).abs() < 1e-12, "the triangles cover the polygon");
            assert_eq!(out_of_plane(&patch.polygon), 0.0);
        }
    }
}

#[test]
fn every_tile_is_a_disk_with_one_boundary_loop_on_the_cube_faces() {
    for style in STYLES {
        for mask in admissible_masks() {
            let facets = construct(mask, 0, &style);
            let mut edges = BTreeSet::new();
            for f in &facets {
                for i in 0..f.polygon.len() {
                    assert!(edges.insert([f.polygon[i], f.polygon[(i + 1) % f.polygon.len()]]), "{mask}: edge twice");
                }
            }
            let vertices: BTreeSet<_> = edges.iter().map(|e| e[0]).collect();
            let boundary: BTreeMap<_, _> =
                edges.iter().filter(|[a, b]| !edges.contains(&[*b, *a])).map(|[a, b]| (*a, *b)).collect();
            let undirected = (edges.len() + boundary.len()) / 2;
            assert_eq!(vertices.len() + facets.len(), undirected + 1, "{mask}: Euler number of a disk");
            let (&start, mut at) = boundary.iter().next().map(|(a, b)| (a, *b)).unwrap();
            let mut steps = 1;
            while at != start {
                at = boundary[&at];
                steps += 1;
            }
            assert_eq!(steps, boundary.len(), "{mask}: one loop");
            for (a, b) in &boundary {
                assert!((0..3).any(|i| a[i] == b[i] && (a[i] == 0 || a[i] == CUBE_MM[i])), "{mask}: {a:?} {b:?}");
            }
        }
    }
}

#[test]
fn the_42_face_keys_have_one_curve_each() {
    for style in STYLES {
        let set = in_memory(&style);
        let mut keys = BTreeMap::new();
        for mask in admissible_masks() {
            for axis in Axis::ALL {
                for high in [false, true] {
                    let curve: BTreeSet<_> = face_curve(&set, mask, axis, high)
                        .into_iter()
                        .map(|[a, b]| if high { [a, b] } else { [b, a] })
                        .collect();
                    let pattern = mask.face(axis, high);
                    let first = keys.entry((axis, pattern)).or_insert_with(|| curve.clone());
                    assert_eq!(*first, curve, "{} {mask} {axis:?}", style.name);
                    assert_eq!(curve.is_empty(), [0, 15].contains(&pattern), "{mask}: outlines part filled from empty");
                }
            }
        }
        // 16 patterns less the two diagonal ones, on each of three axes.
        assert_eq!(keys.len(), 42);
    }
}

#[test]
fn all_meetings_have_closed_seams_in_every_style_and_in_the_skeleton() {
    assert_eq!(meetings().count(), 3684);
    for style in STYLES {
        assert_eq!(check_tileset(&in_memory(&style)), [], "{}", style.name);
    }
    let linear = LinearTileset::from_lines("linear", CUBE_MM, skeleton);
    assert_eq!(check_linear_tileset(&linear), []);
}

#[test]
fn a_style_that_differs_in_one_tile_is_found_by_name_and_face() {
    let even = Tileset::from_facets("even", CUBE_MM, |mask| construct(mask, 0, &Style::SURFACE_2));
    assert_eq!(check_tileset(&even), []);
    let odd = Mask(3);
    let mixed = Tileset::from_facets("mixed", CUBE_MM, |mask| {
        construct(mask, 0, if mask == odd { &Style::SURFACE_1 } else { &Style::SURFACE_2 })
    });
    let findings = check_tileset(&mixed);
    assert!(!findings.is_empty());
    assert!(findings.iter().all(|f| f.meeting.low == odd || f.meeting.high == odd));
    let text = findings[0].to_string();
    assert!(text.contains("mixed 3") && text.contains("face") && text.contains("270"), "{text}");

    let linear = LinearTileset::from_lines("linear", CUBE_MM, |mask| {
        skeleton(mask).into_iter().filter(|l| mask != odd || l.role != LineRole::Purlin).collect()
    });
    assert!(check_linear_tileset(&linear).iter().any(|f| f.to_string().contains("purlin")));
}

#[test]
fn a_deck_lies_in_the_bottom_plane_and_lets_the_wall_stand_on_it() {
    // One full column beside three slab columns.
    let facets = construct(Mask(0b0001_1111), 0b1110, &Style::SURFACE_2);
    let decks: Vec<_> = facets.iter().filter(|f| f.kind == PatchKind::Deck).collect();
    assert_eq!(decks.len(), 3);
    assert!(decks.iter().all(|f| f.polygon.iter().all(|p| p[2] == 0)));
    assert!(facets.iter().any(|f| f.kind == PatchKind::Wall && f.octant == 4));
    assert!(facets.iter().all(|f| f.kind != PatchKind::Roof));
}

fn roles(mask: u8) -> BTreeMap<&'static str, usize> {
    let mut count = BTreeMap::new();
    for line in skeleton(Mask(mask)) {
        *count.entry(line.role.name()).or_default() += 1;
    }
    count
}

/// Counts worked out by hand from the roles' definitions.
#[test]
fn the_skeleton_of_simple_configurations_is_the_expected_one() {
    // The full cube: a grid of four corners, nothing else.
    assert_eq!(roles(255), BTreeMap::from([("joist_x", 4), ("joist_y", 4), ("edge", 4)]));
    // One full column: a convex corner post, two studs, all in halves; two rails.
    assert_eq!(roles(17), BTreeMap::from([("stud", 4), ("post", 2), ("rail", 2), ("joist_x", 1), ("joist_y", 1)]));
    // Three full columns: a concave corner.
    assert_eq!(
        roles(119),
        BTreeMap::from([("stud", 4), ("post", 2), ("rail", 2), ("joist_x", 3), ("joist_y", 3), ("edge", 2)])
    );
    // A roof corner: two rafters and the hip between them.
    assert_eq!(roles(1), BTreeMap::from([("rafter", 2), ("hip", 1), ("rail", 2), ("joist_x", 1), ("joist_y", 1)]));
    // A roof's inner corner: two valleys' worth of one crease, two purlins in halves.
    let inner = roles(7);
    assert_eq!((inner["valley"], inner["rafter"], inner["purlin"]), (1, 2, 4));
    assert!(!inner.contains_key("hip"));
    // An underside: everything hangs on the cube above.
    assert!(skeleton(Mask(240)).is_empty());
}

#[test]
fn every_line_hangs_on_a_filled_octant_and_has_length() {
    for mask in admissible_masks() {
        for line in skeleton(mask) {
            assert!(line.octants.iter().any(|&o| mask.0 >> o & 1 == 1), "{mask} {line:?}");
            assert!(line.length_mm() > 0.0 && line.from < line.to && line.octants[0] <= line.octants[1]);
        }
    }
}
