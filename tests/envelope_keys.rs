//! Surfaces from keys: closed manifolds, areas and volumes that match, and a cache that changes nothing.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

use houscaper::cubes::{Rule, scan_masks};
use houscaper::envelope::*;
use houscaper::tiles::{CUBE_MM, Style, Tileset, construct};
use houscaper::voxels::{Label, VoxelArray, samples};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const ARCHITECTURAL: Style = Style {
    name: "architectural",
    description: "Walls, slopes, decks and undersides of the architectural tiles.",
    eaves: 0,
    wall_foot: 2,
    underside_mm: 235,
    ground_underside_mm: 90,
    decks: true,
    wall_offset_mm: 0,
    roof_offset_mm: 0,
};

fn keyed(style: Style, rule: Rule) -> KeyedSurface {
    KeyedSurface { style, rule, edges: None }
}

fn in_memory(style: &Style) -> Tileset {
    Tileset::from_facets(style.name, CUBE_MM, |mask| construct(mask, 0, style))
}

fn inadmissible(voxels: &VoxelArray) -> usize {
    let mut count = 0;
    scan_masks(voxels, |_, mask| count += usize::from(!mask.is_admissible()));
    count
}

#[derive(Clone, Copy, PartialEq)]
enum Colours {
    /// Base only.
    Base,
    /// Whole layers of slab.
    Plates,
    /// Any label anywhere.
    Any,
}

/// Random boxes filled and emptied, then voxels flipped until every cube is admissible.
fn random_array(rng: &mut ChaCha8Rng, colours: Colours) -> Option<VoxelArray> {
    let shape = [0; 3].map(|_| rng.random_range(1..=7));
    let plates: Vec<Label> =
        (0..shape[2])
            .map(|_| {
                if rng.random_bool(0.3) {
                    [Label::Floor, Label::Foundation][rng.random_range(0..2)]
                } else {
                    Label::Base
                }
            })
            .collect();
    let mut voxels = VoxelArray::new(shape);
    for _ in 0..rng.random_range(1..=7) {
        let fill = rng.random_bool(0.7);
        let low = shape.map(|n| rng.random_range(0..n));
        let high = [0, 1, 2].map(|a| rng.random_range(low[a]..shape[a]));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    voxels.set([x, y, z], if fill { Label::Base } else { Label::Empty });
                }
            }
        }
    }
    for _ in 0..200 {
        let bad = inadmissible(&voxels);
        if bad == 0 {
            break;
        }
        let at = shape.map(|n| rng.random_range(0..n));
        let before = voxels.get(at);
        voxels.set(at, if before.is_filled() { Label::Empty } else { Label::Base });
        if inadmissible(&voxels) > bad {
            voxels.set(at, before);
        }
    }
    if inadmissible(&voxels) > 0 || voxels.filled_count() == 0 {
        return None;
    }
    let filled: Vec<[usize; 3]> = voxels.iter().filter(|(_, l)| l.is_filled()).map(|(at, _)| at).collect();
    for at in filled {
        let label = match colours {
            Colours::Base => Label::Base,
            Colours::Plates => plates[at[2]],
            Colours::Any => Label::from_code(rng.random_range(1..=5)).unwrap(),
        };
        voxels.set(at, label);
    }
    Some(voxels)
}

fn agree(mesh: &Mesh, survey: &EnvelopeSurvey, case: &str) {
    assert!((volume(mesh) - survey.areas.volume_m3).abs() < 1e-9 * survey.areas.volume_m3.max(1.0), "{case}");
    let mut by_surface = [0.0; 10];
    for (t, surface) in mesh.triangles.iter().zip(&mesh.surfaces) {
        let [a, b, c] = t.map(|i| mesh.vertices[i as usize]);
        let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
        let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        by_surface[*surface as usize] += 0.5 * n.iter().map(|c| c * c).sum::<f64>().sqrt();
    }
    for (mine, theirs) in survey.areas.area_m2.iter().zip(by_surface) {
        assert!((mine - theirs).abs() < 1e-9, "{case}");
    }
    assert!((survey.windows_m2.iter().sum::<f64>() - survey.areas.area_m2[Surface::Window as usize]).abs() < 1e-9);
    assert!((survey.doors_m2.iter().sum::<f64>() - survey.areas.area_m2[Surface::Door as usize]).abs() < 1e-9);
}

/// Closed and oriented, with the Euler number of the voxels' own boundary.
#[test]
fn random_arrays_are_closed_manifolds_under_both_rules() {
    let plain = in_memory(&Style::SURFACE_1);
    let mut rng = ChaCha8Rng::seed_from_u64(21);
    let mut cache = KeyCache::default();
    let mut crowded = [0; 2];
    for colours in [Colours::Base, Colours::Plates, Colours::Any] {
        let mut made = 0;
        while made < 1000 {
            let Some(voxels) = random_array(&mut rng, colours) else { continue };
            made += 1;
            let euler = manifold_report(&mesh(&voxels, &plain).unwrap()).euler;
            for (n, rule) in [Rule::A, Rule::B].into_iter().enumerate() {
                let surface = keyed(ARCHITECTURAL, rule);
                let mesh = mesh_keys(&voxels, &surface).unwrap();
                let report = manifold_report(&mesh);
                let case = format!("{rule:?} {report:?} of {voxels:?}");
                if colours == Colours::Any {
                    crowded[n] += usize::from(report.crowded_edges > 0);
                } else {
                    assert!(report.is_closed_manifold() && report.euler == euler, "{euler}: {case}");
                }
                assert_eq!((report.open_edges, report.degenerate_triangles), (0, 0), "{case}");
                let survey = survey_keys(&voxels, &surface, |_| false, &mut cache).unwrap();
                assert_eq!(
                    survey,
                    survey_keys(&voxels, &surface, |_| false, &mut KeyCache::default()).unwrap(),
                    "known keys change nothing"
                );
                agree(&mesh, &survey, &case);
            }
        }
    }
    eprintln!("of 1000 arrays of any labels, {crowded:?} have an edge in which bodies touch under rules A and B");
}

/// A style that knows no decks, under rule A, is the tileset of masks.
#[test]
fn a_keyed_surface_without_decks_and_numbers_is_the_tileset() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let mut cache = KeyCache::default();
    for style in [Style::SURFACE_1, Style::SURFACE_2] {
        let (tiles, keys) = (Skin::Tiles(in_memory(&style)), Skin::Keys(keyed(style, Rule::A)));
        let mut made = 0;
        while made < 300 {
            let Some(voxels) = random_array(&mut rng, Colours::Any) else { continue };
            made += 1;
            let [a, b] = [&tiles, &keys].map(|skin| skin.mesh(&voxels).unwrap());
            assert_eq!((a.vertices, a.triangles), (b.vertices, b.triangles));
            let [a, b] = [&tiles, &keys].map(|skin| skin.survey(&voxels, |_| false, &mut cache).unwrap());
            assert!((a.areas.volume_m3 - b.areas.volume_m3).abs() < 1e-12 * a.areas.volume_m3);
            // Labels differ in the lower half of walls on slabs only.
            let total = |s: &EnvelopeSurvey| s.areas.area_m2.iter().sum::<f64>();
            assert!((total(&a) - total(&b)).abs() < 1e-9);
            assert!(
                (a.areas.area_m2[Surface::Ground as usize] - b.areas.area_m2[Surface::Ground as usize]).abs() < 1e-9
            );
        }
    }
}

#[test]
fn sample_houses_have_the_surfaces_an_architect_expects() {
    let mut cache = KeyCache::default();
    for (name, house) in samples::all() {
        let surface = keyed(ARCHITECTURAL, Rule::B);
        let mesh = mesh_keys(&house.voxels, &surface).unwrap();
        let report = manifold_report(&mesh);
        assert!(report.is_closed_manifold() && report.euler == 2, "{name}: {report:?}");
        let survey = survey_keys(&house.voxels, &surface, |_| false, &mut cache).unwrap();
        agree(&mesh, &survey, name);
        let area = |s: Surface| survey.areas.area_m2[s as usize];
        assert!(area(Surface::Window) > 1.0 && area(Surface::Door) > 1.0 && area(Surface::Wall) > 30.0, "{name}");
        assert!(area(Surface::Plinth) > 0.0 && area(Surface::Ground) > 0.0 && area(Surface::Band) > 0.0, "{name}");
        match name {
            "box" => {
                // A flat roof is a deck of slabs: the plan to its edge.
                assert!((area(Surface::Deck) - 7.0 * 6.0 * 0.81).abs() < 1e-9);
                assert_eq!(area(Surface::PitchedRoof), 0.0);
                // Outside: 26 modules around; the band is the plate's half voxel below its top.
                assert!((area(Surface::Band) - 26.0 * 0.9 * 0.27).abs() < 1e-9, "{}", area(Surface::Band));
                // A window of 3 x 3 and one of 2 x 3 modules, a door of 1 x 4 from the slab's top: half a module more.
                assert!((area(Surface::Window) - 15.0 * 0.9 * 0.54).abs() < 1e-9);
                assert!((area(Surface::Door) - 4.5 * 0.9 * 0.54).abs() < 1e-9);
                assert!((survey.windows_m2[3] - 9.0 * 0.9 * 0.54).abs() < 1e-9, "south");
                assert!((survey.windows_m2[0] - 6.0 * 0.9 * 0.54).abs() < 1e-9, "east");
            }
            "hip" | "l" => assert!(area(Surface::PitchedRoof) > 20.0, "{name}"),
            _ => assert!(area(Surface::Deck) > 50.0, "{name}"),
        }
    }
}

/// A gable of slope 540 : 900 over the whole plan: the slopes' area is the plan's times the secant.
#[test]
fn a_gable_is_two_planes_and_two_triangles() {
    let mut voxels = VoxelArray::new([8, 5, 4]);
    for x in 0..8 {
        for y in 0..5usize {
            (0..2 + y.min(4 - y)).for_each(|z| voxels.set([x, y, z], Label::Base));
        }
    }
    let mut cache = KeyCache::default();
    let mut areas = |rule| survey_keys(&voxels, &keyed(ARCHITECTURAL, rule), |_| false, &mut cache).unwrap().areas;
    let (a, b) = (areas(Rule::A), areas(Rule::B));
    let plan = 8.0 * 5.0 * 0.81;
    let roof = |s: &EnvelopeAreas| s.area_m2[Surface::PitchedRoof as usize] + s.area_m2[Surface::FlatRoof as usize];
    assert!((roof(&b) - plan * (1.0f64 + 0.36).sqrt()).abs() < 1e-9, "{}", roof(&b));
    assert_eq!(b.area_m2[Surface::FlatRoof as usize], 0.0);
    // Eaves at the height of the lowest roof voxels' centres, the ridge 2.5 modules of plan inside: 3 steps of 180 in 300 a module.
    let (eaves_m, bottom_m, rise_m) = (0.54, -0.54 + 0.235, 2.5 * 0.54);
    let expected = plan * (eaves_m - bottom_m) + 0.5 * (4.5 * rise_m) * 7.2;
    assert!((b.volume_m3 - expected).abs() < 1e-9, "{} is not {expected}", b.volume_m3);
    assert!(a.volume_m3 < b.volume_m3, "rule A cuts the verges into teeth");
}

#[test]
fn modules_of_another_size_stretch_the_surface_and_bad_cubes_are_named() {
    let surface = keyed(ARCHITECTURAL, Rule::B);
    let mut house = samples::hip_house().voxels;
    let mut cache = KeyCache::default();
    let before = survey_keys(&house, &surface, |_| false, &mut cache).unwrap();
    let known = cache.len();
    house.origin_m = [5.0, -3.0, 8.0];
    assert_eq!(survey_keys(&house, &surface, |_| false, &mut cache).unwrap(), before);
    assert_eq!(cache.len(), known, "nothing new");
    house.module.size_m = [1.8, 1.8, 1.08];
    let large = survey_keys(&house, &surface, |_| false, &mut cache).unwrap();
    assert!((large.areas.volume_m3 - 8.0 * before.areas.volume_m3).abs() < 1e-9);
    agree(&mesh_keys(&house, &surface).unwrap(), &large, "large");
    house.module.size_m = [0.9, 0.9, 0.54];
    assert_eq!(survey_keys(&house, &surface, |_| false, &mut cache).unwrap(), before);

    let mut voxels = VoxelArray::new([2, 2, 1]);
    voxels.set([0, 0, 0], Label::Base);
    voxels.set([1, 1, 0], Label::Base);
    let errors =
        [survey_keys(&voxels, &surface, |_| false, &mut cache).unwrap_err(), mesh_keys(&voxels, &surface).unwrap_err()];
    for error in errors {
        let EnvelopeError::Inadmissible { cube, .. } = error;
        assert_eq!(cube, [1, 1, 0]);
    }
    voxels.set([1, 0, 0], Label::Base);
    assert!(survey_keys(&voxels, &surface, |_| false, &mut cache).is_ok() && mesh_keys(&voxels, &surface).is_ok());
}
