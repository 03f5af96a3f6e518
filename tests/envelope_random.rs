//! Envelopes of random rule-respecting arrays: closed, oriented manifolds with the right volume and Euler number.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

use houscaper::cubes::{Axis, Mask, scan_masks};
use houscaper::envelope::*;
use houscaper::tiles::{CUBE_MM, Style, Tileset, construct};
use houscaper::voxels::{Label, VoxelArray};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::path::PathBuf;

fn tileset(name: &str) -> Tileset {
    Tileset::load(&PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name)).unwrap()
}

fn inadmissible(voxels: &VoxelArray) -> usize {
    let mut count = 0;
    scan_masks(voxels, |_, mask| count += usize::from(!mask.is_admissible()));
    count
}

/// Random boxes are filled and emptied, then single voxels flipped as long as cubes are inadmissible and flipping one helps.
fn random_array(rng: &mut ChaCha8Rng) -> Option<VoxelArray> {
    let shape = [0; 3].map(|_| rng.random_range(1..=6));
    let mut voxels = VoxelArray::new(shape);
    for _ in 0..rng.random_range(1..=7) {
        let fill = rng.random_bool(0.7);
        let low = shape.map(|n| rng.random_range(0..n));
        let high = [0, 1, 2].map(|a| rng.random_range(low[a]..shape[a]));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    let label = Label::from_code(rng.random_range(1..=5)).unwrap();
                    voxels.set([x, y, z], if fill { label } else { Label::Empty });
                }
            }
        }
    }
    for _ in 0..200 {
        let bad = inadmissible(&voxels);
        if bad == 0 {
            return (voxels.filled_count() > 0).then_some(voxels);
        }
        let at = shape.map(|n| rng.random_range(0..n));
        let before = voxels.get(at);
        voxels.set(at, if before.is_filled() { Label::Empty } else { Label::Base });
        if inadmissible(&voxels) > bad {
            voxels.set(at, before);
        }
    }
    None
}

#[test]
fn ten_thousand_random_arrays_are_closed_manifolds() {
    let (plain, sloped) = (tileset("surface-1"), tileset("surface-2"));
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let mut met = [false; 256];
    let mut made = 0;
    let module_m3 = 0.9 * 0.9 * 0.54;
    while made < 10_000 {
        let Some(voxels) = random_array(&mut rng) else { continue };
        made += 1;
        scan_masks(&voxels, |_, mask| met[mask.0 as usize] = true);
        let meshes = [&plain, &sloped].map(|set| mesh(&voxels, set).unwrap());
        let reports = meshes.each_ref().map(manifold_report);
        for report in reports {
            assert!(report.is_closed_manifold(), "{report:?} of {voxels:?}");
        }
        assert_eq!(reports[0].euler, reports[1].euler, "same topology: {voxels:?}");
        let surveys = [&plain, &sloped].map(|set| survey(&voxels, set).unwrap());
        let exact = voxels.filled_count() as f64 * module_m3;
        assert!((surveys[0].areas.volume_m3 - exact).abs() < 1e-12 * exact, "surface 1 encloses the voxels exactly");
        for (mesh, survey) in meshes.iter().zip(&surveys) {
            assert!((volume(mesh) - survey.areas.volume_m3).abs() < 1e-9 * exact, "tiles and mesh agree");
            let mut by_surface = [0.0; 10];
            for (triangle, surface) in mesh.triangles.iter().zip(&mesh.surfaces) {
                by_surface[*surface as usize] += triangle_area(mesh, *triangle);
            }
            for (mine, theirs) in survey.areas.area_m2.iter().zip(by_surface) {
                assert!((mine - theirs).abs() < 1e-9);
            }
        }
        assert!(surveys[1].areas.volume_m3 < exact && surveys[1].areas.volume_m3 > 0.0);
    }
    assert_eq!(met.iter().filter(|m| **m).count(), 126, "every configuration has been met");
}

/// Offset walls and roofs: the same topology as the voxels, at the offset that is shipped and at the largest.
#[test]
fn random_arrays_with_an_offset_are_closed_manifolds() {
    let styles = [(150, 90), (449, 269), (449, -269), (1, 0), (0, 90)].map(|(wall_offset_mm, roof_offset_mm)| Style {
        wall_offset_mm,
        roof_offset_mm,
        ..Style::SURFACE_1
    });
    let sets = styles.map(|style| Tileset::from_facets(style.name, CUBE_MM, |mask| construct(mask, 0, &style)));
    let plain = tileset("surface-1");
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut made = 0;
    while made < 500 {
        let Some(voxels) = random_array(&mut rng) else { continue };
        made += 1;
        let expected = manifold_report(&mesh(&voxels, &plain).unwrap());
        for (set, style) in sets.iter().zip(&styles) {
            let mesh = mesh(&voxels, set).unwrap();
            let report = manifold_report(&mesh);
            assert!(report.is_closed_manifold(), "{style:?}: {report:?} of {voxels:?}");
            assert_eq!(report.euler, expected.euler, "{style:?}: same topology: {voxels:?}");
            let measured = survey(&voxels, set).unwrap().areas.volume_m3;
            assert!((volume(&mesh) - measured).abs() < 1e-9 * measured, "tiles and mesh agree");
        }
    }
}

/// A box grows by the wall offset on four sides; its roof and its underside move up together.
#[test]
fn the_volume_of_an_offset_box_is_the_closed_form() {
    let house = box_house([4, 3, 5]);
    let set = tileset("surface-1-offset");
    let survey = survey(&house, &set).unwrap();
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} is not {b}");
    let [length, depth, height] = [4.0 * 0.9 + 0.3, 3.0 * 0.9 + 0.3, 5.0 * 0.54];
    close(survey.areas.volume_m3, length * depth * height);
    close(survey.areas.area_m2[Surface::FlatRoof as usize], length * depth);
    let walls = [Surface::Wall, Surface::Plinth].map(|s| survey.areas.area_m2[s as usize]).iter().sum::<f64>();
    close(walls, 2.0 * (length + depth) * height);
    let mesh = mesh(&house, &set).unwrap();
    let bounds = |a: usize| {
        let all = || mesh.vertices.iter().map(|v| v[a]);
        [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)]
    };
    close(bounds(0)[0], house.origin_m[0] - 0.45 - 0.15);
    close(bounds(2)[0], house.origin_m[2] - 0.27 + 0.09);
    close(bounds(2)[1], house.origin_m[2] + 4.5 * 0.54 + 0.09);
}

fn triangle_area(mesh: &Mesh, triangle: [u32; 3]) -> f64 {
    let [a, b, c] = triangle.map(|i| mesh.vertices[i as usize]);
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    0.5 * n.iter().map(|c| c * c).sum::<f64>().sqrt()
}

fn box_house(shape: [usize; 3]) -> VoxelArray {
    let mut voxels = VoxelArray::new(shape);
    for n in 0..shape.iter().product::<usize>() {
        let at = [n % shape[0], n / shape[0] % shape[1], n / (shape[0] * shape[1])];
        voxels.set(at, if at[2] == 0 { Label::Foundation } else { Label::Base });
    }
    voxels
}

/// A box of 4 x 3 x 5 modules in surface 1: areas by hand.
#[test]
fn areas_of_a_box_are_the_closed_forms() {
    let mut house = box_house([4, 3, 5]);
    house.set([1, 0, 2], Label::Window);
    house.set([3, 1, 2], Label::Opening);
    let survey = survey(&house, &tileset("surface-1")).unwrap();
    let area = |s: Surface| survey.areas.area_m2[s as usize];
    let (plan, side) = (0.81, 0.9 * 0.54);
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} is not {b}");
    close(area(Surface::FlatRoof), 12.0 * plan);
    close(area(Surface::Ground), 12.0 * plan);
    close(area(Surface::Plinth), 14.0 * side);
    close(area(Surface::Window), side);
    close(area(Surface::Door), side);
    close(area(Surface::Wall), (14.0 * 4.0 - 2.0) * side);
    close(survey.windows_m2[3], side); // y = 0 faces south
    close(survey.doors_m2[0], side); // x = 3 of 4 faces east
    close(survey.areas.volume_m3, 60.0 * 0.9 * 0.9 * 0.54);
    close(survey.windows_m2.iter().sum(), side);
}

/// Surface 2 on a box: a hip roof of slope 0.54 : 0.9 starting half a module inside; the roof's projection is the plan.
#[test]
fn the_roof_of_surface_2_projects_on_the_plan() {
    let house = box_house([3, 3, 4]);
    let mesh = mesh(&house, &tileset("surface-2")).unwrap();
    let up: f64 = mesh
        .triangles
        .iter()
        .zip(&mesh.surfaces)
        .filter(|(_, s)| matches!(s, Surface::PitchedRoof | Surface::FlatRoof))
        .map(|(t, _)| {
            let [a, b, c] = t.map(|i| mesh.vertices[i as usize]);
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        })
        .sum();
    assert!((up - 9.0 * 0.81).abs() < 1e-12);
}

#[test]
fn origin_and_module_of_the_array_are_kept() {
    let set = tileset("surface-2");
    let mut house = box_house([3, 4, 3]);
    let before = survey(&house, &set).unwrap();
    house.origin_m = [10.0, 20.0, -3.0];
    let moved = mesh(&house, &set).unwrap();
    for axis in Axis::ALL {
        let a = axis as usize;
        let low = moved.vertices.iter().map(|v| v[a]).fold(f64::INFINITY, f64::min);
        let half = if axis == Axis::Z { 0.18 } else { 0.45 };
        assert!((low - (house.origin_m[a] - half)).abs() < 1e-12, "{axis:?}: {low}");
    }
    assert_eq!(survey(&house, &set).unwrap(), before);
    house.module.size_m = [1.8, 1.8, 1.08];
    let large = survey(&house, &set).unwrap();
    assert!((large.areas.volume_m3 - 8.0 * before.areas.volume_m3).abs() < 1e-9);
    for (l, b) in large.areas.area_m2.iter().zip(before.areas.area_m2) {
        assert!((l - 4.0 * b).abs() < 1e-9);
    }
    assert!((volume(&mesh(&house, &set).unwrap()) - large.areas.volume_m3).abs() < 1e-9);
}

#[test]
fn an_inadmissible_cube_is_reported_with_place_and_id() {
    let mut voxels = VoxelArray::new([2, 2, 1]);
    voxels.set([0, 0, 0], Label::Base);
    voxels.set([1, 1, 0], Label::Floor);
    let set = tileset("surface-1");
    let error = mesh(&voxels, &set).unwrap_err();
    let EnvelopeError::Inadmissible { cube, mask, id } = error;
    assert_eq!((cube, mask), ([1, 1, 0], Mask(0b1001_0000)));
    assert_eq!(id, 6u32.pow(3) + 2);
    assert_eq!(areas(&voxels, &set), Err(error));
    voxels.set([1, 0, 0], Label::Base);
    assert!(mesh(&voxels, &set).is_ok() && areas(&voxels, &set).is_ok());
}

#[test]
fn the_manifold_report_sees_holes_turned_faces_and_pinches() {
    let whole = mesh(&box_house([2, 2, 2]), &tileset("surface-1")).unwrap();
    let report = manifold_report(&whole);
    assert!(report.is_closed_manifold() && report.euler == 2);
    let mut holed = whole.clone();
    holed.triangles.pop();
    assert_eq!(manifold_report(&holed).open_edges, 3);
    let mut turned = whole.clone();
    turned.triangles[0].reverse();
    assert!(manifold_report(&turned).crowded_edges > 0);
    // Two tetrahedra sharing one vertex.
    let pinched = Mesh {
        vertices: vec![[0.0; 3]; 7],
        triangles: [[1, 2, 3], [4, 5, 6]]
            .iter()
            .flat_map(|&[a, b, c]| [[0, a, b], [0, b, c], [0, c, a], [a, c, b]])
            .collect(),
        surfaces: vec![Surface::Wall; 8],
    };
    let report = manifold_report(&pinched);
    assert_eq!((report.open_edges, report.crowded_edges, report.pinched_vertices), (0, 0, 1));
}

/// Prints the time of one survey and one mesh of a full-size house (run with --nocapture).
#[test]
fn a_survey_is_fast() {
    let set = tileset("surface-2");
    let house = box_house([10, 8, 16]);
    let start = std::time::Instant::now();
    let mut sum = 0.0;
    for _ in 0..1000 {
        sum += survey(std::hint::black_box(&house), &set).unwrap().areas.volume_m3;
    }
    let survey_us = start.elapsed().as_secs_f64() * 1e3;
    let start = std::time::Instant::now();
    for _ in 0..50 {
        sum += mesh(std::hint::black_box(&house), &set).unwrap().vertices.len() as f64;
    }
    eprintln!("survey {survey_us:.1} us, mesh {:.0} us ({sum})", start.elapsed().as_secs_f64() * 1e6 / 50.0);
    assert!(survey_us < 2000.0, "an evaluation must not wait for its areas: {survey_us} us");
}
