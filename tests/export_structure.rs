//! The review of a frame and what is written of it: the same ratios as the assessment, reactions that balance, a shape that hangs
//! together, buckling loads that Euler knows, and a page that says what structure.json says.

#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;
use std::f64::consts::PI;

use houscaper::analysis::{LoadCase, Model, displacement_along, solve};
use houscaper::export::dossier::{Dossier, Extent, dossier};
use houscaper::frame::{HouseFrame, Role};
use houscaper::score::Evaluator;
use houscaper::structure::{
    Check, SectionOption, Workspace, analysis_model, assess, critical_loads, load_cases, review,
};
use houscaper::voxels::{Choices, House, samples};
use serde_json::Value;

const TIMBER: [&str; 4] = ["C24 T_45x170", "C24 T_60x240", "GL24h GL_90x270", "C24 T_45x195"];
const MIXED: [&str; 4] = ["C24 T_60x200", "S235 IPE180", "S235 HEA160", "C24 T_60x200"];

fn evaluator() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

fn house(name: &str) -> House {
    samples::gallery().into_iter().find(|(n, _)| *n == name).unwrap().1
}

fn frame(evaluator: &Evaluator, name: &str) -> HouseFrame {
    evaluator.details(&house(name), &Choices::default()).frame.unwrap()
}

fn sections(evaluator: &Evaluator, names: [&str; 4]) -> [SectionOption; 4] {
    names.map(|n| {
        let (m, s) = n.split_once(' ').unwrap();
        evaluator.catalogue.find(m, s).unwrap_or_else(|| panic!("{n}"))
    })
}

fn near(a: f64, b: f64, share: f64) -> bool {
    (a - b).abs() <= share * a.abs().max(b.abs()).max(1e-9)
}

/// Twin: the review walks all clauses at all places, the assessment leaves out what a bound rules out, and sums base actions.
#[test]
fn the_review_names_the_ratios_of_the_assessment() {
    let e = evaluator();
    let mut split = 0;
    for (name, names) in [("villa", TIMBER), ("l_gable", TIMBER), ("flat", MIXED), ("lean_to", MIXED)] {
        let (frame, sections) = (frame(&e, name), sections(&e, names));
        let found = assess(&frame, &e.catalogue, &sections, &e.loads, &mut Workspace::detailed());
        let review = review(&frame, &e.catalogue, &sections, &e.loads).unwrap();
        assert_eq!(review.members.len(), found.members.len());
        for (id, (own, result)) in review.members.iter().zip(&found.members).enumerate() {
            let ratio = own.governing.map_or(0.0, |g| g.checked.ratio());
            assert!(near(ratio, result.utilisation, 1e-9), "{name}, member {id}: {ratio} and {}", result.utilisation);
            if let Some(g) = own.governing {
                // A sum of ratios comes with its terms, others with none.
                let is_sum = g.checked.clause.unit() == houscaper::structure::checks::Unit::Sum;
                assert_eq!(g.terms.iter().next().is_some(), is_sum, "{name}, member {id}: {:?}", g.checked.clause);
                assert!(!is_sum || near(g.terms.sum(), ratio, 1e-12), "{name}, member {id}: {:?} and {ratio}", g.terms);
                split += usize::from(is_sum);
                assert!(g.terms.iter().all(|t| t.value >= 0.0));
            }
            if let (Some(g), Check::Member(clause)) = (own.governing, result.check) {
                // Clauses whose ratios are equal may stand for each other.
                assert!(g.checked.clause == clause || ratio < 1e-6 || tied(&own.governing, result.utilisation));
                assert!(own.axial_n[0] <= g.forces.n + 1e-6 && g.forces.n <= own.axial_n[1] + 1e-6 || g.at_m.is_none());
            }
            let deflection = own.deflection.map_or(0.0, |d| d.ratio());
            assert!(near(deflection, result.deflection_ratio, 1e-12), "{name}, member {id}");
        }
        let racking = review.racking.iter().map(|r| r.ratio()).fold(0.0, f64::max);
        assert!(near(racking, found.racking_ratio, 1e-9), "{name}: {racking} and {}", found.racking_ratio);
        let pull = review.foundation.iter().map(|l| l.pull.force_n).fold(0.0, f64::max);
        assert!(near(pull, found.stability.anchor_n.max(0.0), 1e-9), "{name}: {pull}, {}", found.stability.anchor_n);
        let clauses: std::collections::BTreeSet<_> =
            review.members.iter().filter_map(|m| m.governing.map(|g| g.checked.clause.number())).collect();
        assert_eq!(clauses.iter().any(|c| c.contains("1993")), names == MIXED, "{name}: {clauses:?}");
        assert!(review.residual < 1e-8 && review.unknowns > 500);
    }
    assert!(split > 300, "{split} members are governed by a sum");
}

fn tied(governing: &Option<houscaper::structure::GoverningCheck>, utilisation: f64) -> bool {
    governing.is_some_and(|g| near(g.checked.ratio(), utilisation, 1e-12))
}

/// Lines of the foundation share all reactions: their sums are those of the cases, and drawn loads are the loads.
#[test]
fn lines_of_the_foundation_add_up_to_the_loads() {
    let e = evaluator();
    for name in ["villa", "court", "stepped"] {
        let (frame, sections) = (frame(&e, name), sections(&e, TIMBER));
        let found = assess(&frame, &e.catalogue, &sections, &e.loads, &mut Workspace::detailed());
        let review = review(&frame, &e.catalogue, &sections, &e.loads).unwrap();
        let loads = found.loads.unwrap();
        for (n, case) in ["permanent", "imposed", "snow"].iter().enumerate() {
            let lines: f64 = review.foundation.iter().map(|l| l.vertical_n[n]).sum();
            // A house of one storey may have no imposed load on its frame.
            let Some(sum) = loads.sums.iter().find(|s| s.case == *case) else {
                assert!(lines == 0.0 && review.drawn.iter().all(|d| d.case != *case), "{name}, {case}");
                continue;
            };
            assert!(near(lines, -sum.loads_n[2], 1e-9), "{name}, {case}: {lines} and {}", sum.loads_n[2]);
            let drawn = review.drawn.iter().find(|d| d.case == *case).unwrap();
            assert!((0..3).all(|a| near(drawn.sum_n[a], sum.loads_n[a], 1e-9) || sum.loads_n[a].abs() < 1e-6));
        }
        assert!(review.foundation.iter().all(|l| l.supports > 0 && l.design_n.0 > 0.0));
        assert_eq!(review.drawn.iter().filter(|d| d.case.starts_with("wind")).count(), 8, "{name}");
    }
}

/// Nodes go where all members that meet there go; what moves most is found.
#[test]
fn the_deformed_shape_hangs_together() {
    let e = evaluator();
    let (frame, sections) = (frame(&e, "villa"), sections(&e, TIMBER));
    let deformed = review(&frame, &e.catalogue, &sections, &e.loads).unwrap().deformed;
    let mut at: BTreeMap<[u64; 3], [f64; 3]> = BTreeMap::new();
    let (mut shared, mut largest) = (0, 0.0f64);
    for (m, places) in deformed.members.iter().enumerate() {
        assert_eq!(places.is_empty(), frame.members[m].element_count() == 0);
        for p in places {
            largest = largest.max(p.moves_m.iter().map(|c| c * c).sum::<f64>().sqrt());
            if !frame.nodes.contains(&p.at_m) {
                continue;
            }
            if let Some(other) = at.insert(p.at_m.map(f64::to_bits), p.moves_m) {
                shared += 1;
                assert!((0..3).all(|a| (other[a] - p.moves_m[a]).abs() < 1e-9), "{:?}", p.at_m);
            }
        }
    }
    assert!(shared > 100 && near(largest, deformed.largest_m, 1e-8), "{shared}, {largest}, {}", deformed.largest_m);
    for &n in &frame.supports {
        assert_eq!(at.get(&frame.nodes[n as usize].map(f64::to_bits)).copied().unwrap_or_default(), [0.0; 3]);
    }
}

/// Refinement: a member cut in two has a node where the uncut one has a point between.
#[test]
fn points_of_a_member_are_where_a_node_would_be() {
    let e = evaluator();
    let (frame, sections) = (frame(&e, "gable"), sections(&e, TIMBER));
    let model = analysis_model(&frame, &e.catalogue, &sections);
    let mut cases = Vec::new();
    load_cases(&frame, &e.loads, &mut cases);
    cases.truncate(8);
    let whole = solve(&model, &cases).unwrap();
    let factors: Vec<f64> = (0..cases.len()).map(|n| 1.0 - 0.2 * n as f64).collect();
    let move_of = |s: &houscaper::analysis::Solution, node: usize| -> [f64; 3] {
        std::array::from_fn(|a| factors.iter().enumerate().map(|(c, f)| f * s.displacements(c)[node][a]).sum())
    };
    let mut moved = 0.0f64;
    for element in (0..frame.elements.len()).step_by(17) {
        let (cut, cut_cases, middle) = halved(&model, &cases, element, 0.4);
        let fine = solve(&cut, &cut_cases).unwrap();
        let ends = model.members[element].nodes.map(|n| move_of(&whole, n));
        let point = displacement_along(&whole, &factors, element, ends, 0.4);
        let node = move_of(&fine, middle);
        let size = node.iter().map(|c| c * c).sum::<f64>().sqrt();
        moved = moved.max(size);
        // Exact across the member; along it what loads stretch is left out: micrometres.
        let axes = whole.axes(element);
        let off = |a: usize| (0..3).map(|n| axes[a][n] * (point[n] - node[n])).sum::<f64>();
        assert!(off(1).abs() < 1e-10 && off(2).abs() < 1e-10 && off(0).abs() < 1e-5, "{element}: {point:?}, {node:?}");
    }
    assert!(moved > 1e-3, "{moved}");
}

/// The model and cases with one member cut at share `t`; the answer's third part is the new node.
fn halved(model: &Model, cases: &[LoadCase], element: usize, t: f64) -> (Model, Vec<LoadCase>, usize) {
    let (mut model, mut cases) = (model.clone(), cases.to_vec());
    let [a, b] = model.members[element].nodes;
    let (middle, second) = (model.nodes.len(), model.members.len());
    let (p, q) = (model.nodes[a], model.nodes[b]);
    model.nodes.push([0, 1, 2].map(|x| p[x] + t * (q[x] - p[x])));
    let mut rest = model.members[element].clone();
    (rest.nodes, rest.releases[0]) = ([middle, b], [false; 6]);
    model.members[element].nodes = [a, middle];
    model.members[element].releases[1] = [false; 6];
    model.members.push(rest);
    for case in &mut cases {
        let copies: Vec<_> = case.members.iter().filter(|l| l.member == element).copied().collect();
        case.members.extend(copies.into_iter().map(|l| houscaper::analysis::MemberLoad { member: second, ..l }));
    }
    (model, cases, middle)
}

/// A free post on pins buckles at Euler's load about its weak axis; a frame of twice the load at half the factor.
#[test]
fn buckling_loads_are_eulers_and_go_with_the_load() {
    let e = evaluator();
    let (frame, sections) = (frame(&e, "villa"), sections(&e, TIMBER));
    let found = critical_loads(&frame, &e.catalogue, &sections, &e.loads).unwrap();
    let member = found.member.unwrap();
    let post = &frame.members[member.member.unwrap()];
    assert_eq!(post.role, Role::BeamPost);
    let (material, section) = (e.catalogue.material(sections[2]), e.catalogue.section(sections[2]));
    let reviewed = review(&frame, &e.catalogue, &sections, &e.loads).unwrap();
    let own = &reviewed.members[member.member.unwrap()];
    let euler = PI * PI * material.e * section.iz / own.governing.unwrap().clear_m.powi(2);
    assert_eq!(own.axial_in[0], member.combination);
    // The post runs on through the floor, lighter loaded above; four pieces leave half a per cent.
    let ratio = member.factor * -own.axial_n[0] / euler;
    assert!((0.99..1.02).contains(&ratio), "{ratio}");
    let whole = found.frame.unwrap();
    assert!(found.is_known);
    assert!(whole.factor > member.factor, "{whole:?}");
    let mut heavier = e.loads.clone();
    heavier.gamma = heavier.gamma.map(|g| 2.0 * g);
    heavier.gamma_a *= 2.0;
    let half = critical_loads(&frame, &e.catalogue, &sections, &heavier).unwrap();
    assert!(near(2.0 * half.member.unwrap().factor, member.factor, 1e-6));
    // Storey by storey the frame is as stiff as its eigenvalue says, within what sticks that run through share.
    let storeys = reviewed.storeys.iter().map(|s| s.factor).fold(f64::INFINITY, f64::min);
    println!("villa: frame {whole:?}, storeys {:?}", reviewed.storeys);
    assert!(storeys > 0.3 * whole.factor && storeys < 6.0 * whole.factor, "{storeys} and {}", whole.factor);
}

fn written(name: &str, extent: Extent) -> (Dossier, BTreeMap<String, Vec<u8>>) {
    let (e, house) = (evaluator(), house(name));
    let choices = Choices::default();
    let details = e.details(&house, &choices);
    let mut made = dossier(name, &house, &choices, &details, &e, extent).unwrap();
    let files = std::mem::take(&mut made.files).into_iter().collect();
    (made, files)
}

fn json(files: &BTreeMap<String, Vec<u8>>, name: &str) -> Value {
    serde_json::from_slice(&files[name]).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Cells of the tables of a page, markup and entities undone.
fn cells(page: &str) -> Vec<String> {
    let cell = |part: &str| {
        let text = part.split_once('>').unwrap().1.split("</td>").next().unwrap();
        text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
    };
    page.split("<td").skip(1).map(cell).collect()
}

/// Every table of the page against the record, rounded as it is printed.
#[test]
fn the_page_says_what_the_record_says() {
    let (_, files) = written("villa", Extent::Full { sizing: Some("sized by <hand>".into()) });
    let record = json(&files, "structure.json");
    let page = String::from_utf8(files["structure.html"].clone()).unwrap();
    let cells = cells(&page);
    let after = |first: &str, n: usize| -> &str {
        // A word may stand elsewhere too: its row is where a number follows next or next but one.
        let is_row = |n: &usize| cells[*n] == first && cells[n + 1..].iter().take(3).any(|c| c.parse::<f64>().is_ok());
        let at = (0..cells.len() - 3).find(is_row).unwrap_or_else(|| panic!("no row `{first}`"));
        &cells[at + n]
    };
    let two = |v: &Value| format!("{:.2}", number(v));
    let members = record["members"].as_array().unwrap();
    assert!(members.len() > 100);
    for m in members.iter().filter(|m| !m["governing"].is_null()).take(40) {
        let name = format!("{} {}", m["role"].as_str().unwrap(), m["member"]);
        let g = &m["governing"];
        assert_eq!(after(&name, 2), two(&m["utilisation"]), "{name}");
        let clause = g["clause"].as_str().unwrap();
        assert_eq!(after(&name, 3), clause.replace("EN 1995-1-1", "EC5").replace("EN 1993-1-1", "EC3"), "{name}");
        assert_eq!(after(&name, 5), format!("C{}", g["combination"]), "{name}");
        assert!((after(&name, 9).parse::<f64>().unwrap() - number(&g["n_kn"])).abs() <= 0.005 + 1e-9, "{name}");
        assert!((after(&name, 11).parse::<f64>().unwrap() - number(&g["m_knm"][0])).abs() <= 0.005 + 1e-9, "{name}");
    }
    for (row, key) in [
        ("Racking of boards", "racking_ratio"),
        ("Deflection", "deflection_ratio"),
        ("Storey sway under wind", "sway_ratio"),
    ] {
        assert_eq!(after(row, 1), two(&record[key]), "{row}");
    }
    for s in record["loads"]["sums"].as_array().unwrap() {
        let case = s["case"].as_str().unwrap();
        for (n, key) in [(1, "loads_n"), (4, "reactions_n")] {
            let found: Vec<f64> = (0..3).map(|a| after(case, n + a).parse().unwrap()).collect();
            assert!((0..3).all(|a| (found[a] - number(&s[key][a]) / 1e3).abs() <= 0.005 + 1e-9), "{case}: {found:?}");
        }
    }
    for l in record["foundation"].as_array().unwrap() {
        let line = l["line"].as_str().unwrap();
        assert_eq!(after(line, 5), format!("{:.1}", number(&l["design_kn"])), "{line}");
    }
    for w in record["racking"].as_array().unwrap() {
        assert_eq!(after(w["what"].as_str().unwrap(), 3), two(&w["ratio"]));
    }
    let count = record["loads"]["combinations"].as_array().unwrap().len();
    assert!(cells.contains(&format!("C{count}")) && !cells.contains(&format!("C{}", count + 1)));
    for s in record["not_assessed"].as_array().unwrap().iter().chain(record["assumptions"].as_array().unwrap()) {
        let text = s.as_str().unwrap().replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        assert!(page.contains(&text), "{text}");
    }
    let critical = &record["critical_load"];
    assert_eq!(
        after("the frame: sticks straight, joints move", 1),
        format!("{:.1}", number(&critical["frame"]["factor"]))
    );
    assert!(page.contains(critical["conclusion"].as_str().unwrap()));
    assert!(page.contains("sized by &lt;hand&gt;") && page.matches("<svg").count() == 4);
    // Nothing is fetched.
    assert!(!page.contains("src=") && !page.contains("href=") && !page.contains("url("), "self-contained");
    assert_eq!(page.matches("<table>").count(), page.matches("</table>").count());
}

/// Views, deformed shape, supports and loads of frame.glb.
#[test]
fn the_frame_shows_views_shape_supports_and_loads() {
    let (made, files) = written("villa", Extent::Full { sizing: None });
    let gltf = gltf::Gltf::from_slice(&files["frame.glb"]).unwrap();
    let blob = gltf.blob.as_deref().unwrap();
    let document = serde_json::to_value(gltf.document.clone().into_json()).unwrap();
    let views: Vec<&str> = document["extensions"]["KHR_materials_variants"]["variants"]
        .as_array()
        .unwrap()
        .iter()
        .map(|v| v["name"].as_str().unwrap())
        .collect();
    assert_eq!(views, ["utilisation", "axial force", "role", "material"]);
    let drawn = made.structure.members.len();
    let scene = gltf.default_scene().unwrap();
    assert_eq!(scene.nodes().count(), drawn + 1, "members and supports");
    assert_eq!(gltf.scenes().count(), 1 + 11, "a scene for each case of loads");
    for (n, own) in gltf.scenes().enumerate().skip(1) {
        // All that is seen as one node, and the loads; no node stands in two scenes, which three.js would show in the last one only.
        let nodes: Vec<gltf::Node> = own.nodes().collect();
        assert_eq!(nodes.len(), 2, "{:?}", own.name());
        assert_eq!(nodes[0].mesh().unwrap().primitives().count(), drawn + 1, "{:?}", own.name());
        assert!(scene.nodes().all(|seen| nodes.iter().all(|n| n.index() != seen.index())), "{:?}", own.name());
        assert!(own.name().unwrap().starts_with("loads: "), "{n}");
    }
    let about: Value = serde_json::from_str(scene.extras().as_ref().unwrap().get()).unwrap();
    let shape = made.structure.deformed.unwrap();
    assert_eq!(number(&about["deformed"]["scale"]), shape.scale);
    let mut largest = 0.0f32;
    let mut bent = 0;
    for node in scene.nodes() {
        let mesh = node.mesh().unwrap();
        let primitive = mesh.primitives().next().unwrap();
        let names: Option<Value> = mesh.extras().as_ref().map(|e| serde_json::from_str(e.get()).unwrap());
        for (moves, _, _) in primitive.reader(|_| Some(blob)).read_morph_targets() {
            bent += 1;
            let name = names.as_ref().unwrap()["targetNames"][0].as_str().unwrap();
            assert!(name.contains(&format!("x {}", shape.scale)) && name.contains(&shape.combination), "{name}");
            let size = |m: [f32; 3]| m.iter().map(|c| c * c).sum::<f32>().sqrt();
            largest = moves.unwrap().map(size).fold(largest, f32::max);
        }
    }
    assert!(bent > drawn * 3 / 4, "{bent} of {drawn}");
    let expected = shape.scale * shape.largest_mm / 1e3;
    // What bends least is drawn straight, to half a hundredth of the largest.
    assert!((f64::from(largest) / expected - 1.0).abs() < 6e-3, "{largest} and {expected}");
    assert!((0.03..0.08).contains(&(expected / 9.9)), "{expected} m");
    // Below each picture its colours: classes of utilisation from blue to red, of axial force from blue over white to red.
    let colours: [(&str, &[u32]); 2] = [
        ("frame.png", &[0x2C5F9E, 0x6C9BC9, 0xB9C2C7, 0xE3B583, 0xCF7A45, 0x9E2A1F]),
        (
            "frame-forces.png",
            &[0x1F4E8C, 0x4F88BF, 0x94BBDD, 0xCFE0EE, 0xF4F2EC, 0xF5D6C6, 0xE5A082, 0xC85C47, 0x8F1D22],
        ),
    ];
    for (file, classes) in colours {
        let mut reader = png::Decoder::new(std::io::Cursor::new(&files[file])).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), (1200, 1040), "{file}");
        for (n, colour) in classes.iter().enumerate() {
            let x = (40.0 + (n as f64 + 0.5) * 1120.0 / classes.len() as f64) as usize;
            let at = 3 * (971 * 1200 + x);
            let [r, g, b] = [16, 8, 0].map(|shift| (colour >> shift & 255) as u8);
            assert_eq!(&pixels[at..at + 3], &[r, g, b], "{file}, class {n}");
            // Something is written under the swatch.
            let dark = |row: usize| (x - 50..x + 50).any(|x| pixels[3 * (row * 1200 + x)] < 90);
            assert!((1000..1030).any(dark), "{file}, class {n} has no words");
        }
    }
    assert_ne!(files["frame.png"], files["frame-forces.png"]);
}

/// A house of a front has the page and the views, and not what costs time.
#[test]
fn a_house_of_a_front_has_the_page_without_buckling() {
    let (made, files) = written("flat", Extent::Front);
    assert!(made.structure.critical_load.is_none() && !files.contains_key("frame.png"));
    let page = String::from_utf8(files["structure.html"].clone()).unwrap();
    assert!(page.contains("The first buckling load was not computed"));
    assert!(json(&files, "structure.json")["storeys"].as_array().is_some_and(|s| !s.is_empty()));
    let gltf = gltf::Gltf::from_slice(&files["frame.glb"]).unwrap();
    assert_eq!(gltf.scenes().count(), 1);
    let again = written("flat", Extent::Front).1;
    assert!(files == again, "equal houses, equal bytes");
}

/// Without the site model there is a page all the same, which says so.
#[test]
fn the_thesis_preset_has_a_page_without_checks() {
    let mut e = evaluator();
    e.loads = houscaper::structure::LoadTable::load(&runs::repository().join("configs"))
        .unwrap()
        .thesis(houscaper::structure::SurfaceWeights::default());
    let (house, choices) = (house("gable"), Choices::default());
    let details = e.details(&house, &choices);
    let made = dossier("gable", &house, &choices, &details, &e, Extent::Full { sizing: None }).unwrap();
    assert_eq!(made.structure.verdict, "not assessed");
    assert!(made.structure.foundation.is_empty() && made.structure.deformed.is_none());
    let files: BTreeMap<String, Vec<u8>> = made.files.into_iter().collect();
    let page = String::from_utf8(files["structure.html"].clone()).unwrap();
    assert!(page.contains("Structure not assessed.") && page.contains("What is not assessed"));
    assert!(files.contains_key("frame.png") && !files.contains_key("frame-forces.png"));
}
