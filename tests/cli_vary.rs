//! `houscaper vary`: children that keep the rules, answers that depend on their line alone, and an answer to every line.

#[path = "common/cli.rs"]
mod cli;

use cli::{Ran, Scratch, has, run_with};
use houscaper::search::decode::decode;
use houscaper::search::massing::encode;
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::repair::repair;
use houscaper::search::start::start;
use houscaper::voxels::rules::{self, RuleSettings};
use houscaper::voxels::{House, Label, VoxelArray, samples};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

const STARTER: &str = "configs/starter.json";

fn vary(brief: &str, input: &str) -> Vec<Value> {
    let ran: Ran = run_with(&["vary", "--brief", brief], input);
    assert_eq!(ran.code, 0, "{}", ran.err);
    ran.out.lines().map(|l| serde_json::from_str(l).expect("a JSON line")).collect()
}

fn lines(requests: &[Value]) -> String {
    requests.iter().map(|r| format!("{r}\n")).collect()
}

/// What an answer or a request knows of a house.
fn genome(answer: &Value) -> Value {
    assert!(answer["error"].is_null(), "{answer}");
    json!({"shape": answer["shape"], "labels": answer["labels"], "stairs": answer["stairs"], "choices": answer["choices"]})
}

fn house(genome: &Value) -> House {
    let shape: [usize; 3] = serde_json::from_value(genome["shape"].clone()).expect("a shape");
    let codes: Vec<u8> = serde_json::from_value(genome["labels"].clone()).expect("labels");
    let labels = codes.into_iter().map(|c| Label::from_code(c).expect("a label")).collect();
    let stairs = serde_json::from_value(genome["stairs"].clone()).expect("stairs");
    House { stairs, ..House::new(VoxelArray::from_labels(shape, labels).expect("as many as the shape says")) }
}

fn keeps_rules(answer: &Value) {
    let settings = RuleSettings { glazing_ratio_min: 0.18, ..RuleSettings::default() };
    let broken = rules::check(&house(&genome(answer)), &settings);
    assert!(broken.is_empty(), "{} {}: {}", answer["id"], answer["operator"], broken[0].message);
}

fn starts(seed: u64, count: usize) -> Vec<Value> {
    let requests: Vec<Value> = (0..count).map(|n| json!({"id": n, "op": "start", "seed": seed, "stream": n})).collect();
    vary(STARTER, &lines(&requests))
}

#[test]
fn starts_and_children_keep_every_rule() {
    let starts = starts(3, 24);
    starts.iter().for_each(keeps_rules);
    let distinct: std::collections::BTreeSet<String> = starts.iter().map(|s| s["labels"].to_string()).collect();
    assert!(distinct.len() > 18, "{} different starts of 24", distinct.len());
    let mut requests = Vec::new();
    for (n, s) in starts.iter().enumerate() {
        let other = &starts[(n + 7) % starts.len()];
        let two = json!([genome(s), genome(other)]);
        requests.push(json!({"id": ["move", n], "op": "move", "seed": n, "parents": [genome(s)]}));
        requests.push(json!({"id": ["steps", n], "op": "move", "seed": n, "steps": 5, "parents": [genome(s)]}));
        requests.push(json!({"id": ["cross", n], "op": "crossover", "seed": n, "parents": two}));
        requests.push(json!({"id": ["size", n], "op": "size", "goal": "carbon", "parents": [genome(s)]}));
    }
    let answers = vary(STARTER, &lines(&requests));
    assert_eq!(answers.len(), requests.len());
    let mut children = 0;
    for (answer, request) in answers.iter().zip(&requests) {
        assert_eq!(answer["id"], request["id"]);
        if answer["error"].is_null() {
            keeps_rules(answer);
            request["parents"].as_array().expect("parents").iter().for_each(|p| assert_ne!(&genome(answer), p));
            children += 1;
        } else {
            // Two houses may have nothing to exchange, and sections may be the best already; a move is always found.
            assert!(request["op"] != "move", "{answer}");
        }
    }
    assert!(children * 100 >= 80 * requests.len(), "{children} children of {} requests", requests.len());
}

#[test]
fn an_answer_depends_on_its_line_alone() {
    let parents = starts(5, 6);
    let mut requests: Vec<Value> = Vec::new();
    for (n, p) in parents.iter().enumerate() {
        requests.push(json!({"id": n, "op": "move", "seed": 40 + n, "steps": 2, "parents": [genome(p)]}));
        requests.push(json!({"id": n, "op": "start", "seed": 40 + n}));
    }
    let together = vary(STARTER, &lines(&requests));
    let apart: String = requests.iter().rev().map(|r| format!("{r}\n\n")).collect();
    let mut reversed = vary(STARTER, &apart);
    reversed.reverse();
    assert_eq!(together, reversed);
    // Another seed gives another child.
    let mut other = requests[0].clone();
    other["seed"] = json!(999);
    assert_ne!(vary(STARTER, &lines(&[other]))[0]["labels"], Value::Null);
    let seeds: Vec<Value> =
        (0..8).map(|s| json!({"op": "move", "seed": s, "parents": [genome(&parents[0])]})).collect();
    let children: std::collections::BTreeSet<String> =
        vary(STARTER, &lines(&seeds)).iter().map(|a| genome(a).to_string()).collect();
    assert!(children.len() > 4, "{} children of eight seeds", children.len());
}

#[test]
fn answers_are_candidates_of_evaluate_as_they_are() {
    let starts = starts(9, 8);
    let input: String = starts.iter().map(|s| format!("{s}\n")).collect();
    let ran = run_with(&["evaluate", "--batch", "--genome", "--brief", STARTER], &input);
    let scores: Vec<Value> = ran.out.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect();
    assert_eq!(scores.len(), 8);
    let known = |s: &&Value| s["f"].as_array().is_some_and(|f| f.iter().all(|v| v.as_f64() < Some(1e8)));
    assert_eq!(scores.iter().filter(known).count(), 8, "{scores:?}");
    // Choices weigh: another wall section has another price.
    let space = &vary(STARTER, &lines(&[json!({"id": 0, "op": "space"})]))[0];
    let walls = space["choices"]["wall_section"].as_array().expect("options");
    let mut other = genome(&starts[0]);
    other["id"] = json!(1);
    let price = |wall: &Value| {
        let mut candidate = other.clone();
        candidate["choices"]["wall_section"] = wall.clone();
        let ran = run_with(&["evaluate", "--batch", "--genome", "--brief", STARTER], &format!("{candidate}\n"));
        serde_json::from_str::<Value>(&ran.out).expect("JSON")["f"][0].as_f64().expect("a price")
    };
    assert_ne!(price(&walls[0]), price(&walls[walls.len() - 1]));
    let unasked = run_with(&["evaluate", "--batch", "--brief", STARTER], &input);
    has(&unasked.out, &["--genome"]);
}

/// The streams of a seed are the search's own: scored by `evaluate`, they are the first batch of `optimize`'s log.
#[test]
fn starts_are_those_of_the_search() {
    let folder = Scratch::new();
    let out = folder.at("run");
    cli::ok(&["optimize", STARTER, "--seed", "5", "--evaluations", "32", "--tables-only", "--out", &out]);
    let log = std::fs::read(std::path::Path::new(&out).join("log.json")).expect("a log");
    let log: Value = serde_json::from_slice(&log).expect("JSON");
    let input: String = starts(5, 32).iter().map(|s| format!("{s}\n")).collect();
    let ran = run_with(&["evaluate", "--batch", "--genome", "--brief", STARTER], &input);
    let scores = ran.out.lines().map(|l| serde_json::from_str::<Value>(l).expect("JSON"));
    let feasible: Vec<Value> = scores.filter(|s| s["cv"].as_f64() <= Some(0.0)).map(|s| s["f"].clone()).collect();
    assert!(!feasible.is_empty());
    assert_eq!(log["log"][0]["f"], json!(feasible));
}

/// Reading back is exact: what the generator and the moves make is found again from its voxels, on three plots.
#[test]
fn a_genome_is_read_back_from_its_voxels() {
    for (modules, storeys, seed) in [([10, 8, 17], [1, 2], 1), ([14, 11, 20], [2, 2], 2), ([20, 16, 26], [1, 3], 3)] {
        let programme = Programme { storeys, ..Programme::default() };
        let plot = Plot::new(modules, None).expect("a plot");
        let choices = ChoiceSpace { options: [4, 4, 4, 4, 8, 2] };
        let space = Space::new(plot, programme, choices).expect("a space");
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        for _ in 0..200 {
            let mut design = start(&space, &mut rng).expect("a start");
            for _ in 0..rng.random_range(0..6) {
                let step = houscaper::search::moves::Move::draw(&mut rng).apply(&design, &space, &mut rng);
                design = step.unwrap_or(design);
            }
            let house = encode(&design.massing, &space.plot);
            assert_eq!(decode(&house, &space.plot).as_ref(), Some(&design.massing));
            assert_eq!(repair(&house, design.choices, &space), Ok(design.clone()));
            // One voxel off, and it is no genome any more, or another one.
            let mut off = house.clone();
            off.voxels.set([0, 0, modules[2] - 1], Label::Base);
            assert_eq!(decode(&off, &space.plot), None);
        }
    }
}

/// Uniform crossover of two houses, then random labels: what a program without any knowledge of houses makes.
fn scrambled(a: &Value, b: &Value, noise: f64, rng: &mut ChaCha8Rng) -> Value {
    let mut out = genome(a);
    let labels: Vec<Value> = (0..a["labels"].as_array().expect("labels").len())
        .map(|n| match (rng.random_bool(noise), rng.random_bool(0.5)) {
            (true, _) => json!(rng.random_range(0..6)),
            (false, true) => a["labels"][n].clone(),
            (false, false) => b["labels"][n].clone(),
        })
        .collect();
    out["labels"] = json!(labels);
    out.as_object_mut().expect("an object").remove("stairs");
    out
}

#[test]
fn repair_makes_houses_of_nearly_anything() {
    let starts = starts(11, 16);
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let mut requests = Vec::new();
    for n in 0..starts.len() {
        for noise in [0.0, 0.002, 0.02] {
            let parent = scrambled(&starts[n], &starts[(n + 5) % starts.len()], noise, &mut rng);
            requests.push(json!({"id": [n, noise], "op": "repair", "parents": [parent]}));
        }
    }
    let answers = vary(STARTER, &lines(&requests));
    answers.iter().filter(|a| a["error"].is_null()).for_each(keeps_rules);
    let repaired = answers.iter().filter(|a| a["error"].is_null()).count();
    assert!(repaired * 10 >= 9 * answers.len(), "{repaired} of {}: {:?}", answers.len(), errors(&answers));
    // A house that keeps all rules comes back as it is.
    let again = vary(STARTER, &lines(&[json!({"op": "repair", "parents": [genome(&starts[0])]})]));
    assert_eq!(genome(&again[0]), genome(&starts[0]));
    // Nothing at all is no house, and is said so.
    let empty = json!({"shape": [10, 8, 17], "labels": vec![0; 1360]});
    let answer = &vary(STARTER, &lines(&[json!({"op": "repair", "parents": [empty]})]))[0];
    has(answer["error"].as_str().expect("an error"), &["no storey"]);
}

fn errors(answers: &[Value]) -> Vec<&str> {
    answers.iter().filter_map(|a| a["error"].as_str()).collect()
}

#[test]
fn given_cells_are_kept() {
    let brief = "configs/go-design.json";
    let requests: Vec<Value> = (0..6).map(|n| json!({"id": n, "op": "start", "seed": n})).collect();
    let starts = vary(brief, &lines(&requests));
    let labels = vec![1; 14 * 12 * 17];
    let full = json!({"shape": [14, 12, 17], "labels": labels});
    let mut more = vec![json!({"op": "repair", "parents": [full]})];
    more.extend(starts.iter().map(|s| json!({"op": "move", "seed": 1, "parents": [genome(s)]})));
    let mut all = vary(brief, &lines(&more));
    all.extend(starts);
    let folder = Scratch::new();
    for answer in &all {
        let file = folder.house("house.json", &house(&genome(answer)));
        let told: Value =
            serde_json::from_str(&cli::run(&["check", &file, "--brief", brief, "--json"]).out).expect("JSON");
        let broken = told["violations"].as_array().expect("a list");
        // Plot, mask and given cells are kept like every rule; what the programme misses is a constraint of the score.
        let hard: Vec<&Value> =
            broken.iter().filter(|v| v["rule"].as_str().is_none_or(|r| !r.starts_with("programme."))).collect();
        assert!(hard.is_empty(), "{}: {hard:?}", answer["operator"]);
    }
}

#[test]
fn garbage_is_answered_and_the_rest_goes_on() {
    let good = genome(&starts(2, 1)[0]);
    let mut short = good.clone();
    short["labels"] = json!([1, 2]);
    let mut stair = good.clone();
    stair["stairs"] = json!([{"storey": 0, "start": [900, 0], "run": "+x", "kind": "straight"}]);
    let mut section = good.clone();
    section["choices"]["wall_section"] = json!("oak");
    let cases = [
        ("nonsense".to_owned(), "no JSON"),
        ("[1]".to_owned(), "line 2"),
        (json!({"id": 3}).to_string(), "missing field `op`"),
        (json!({"id": 4, "op": "marry"}).to_string(), "expected start, move, crossover, size, repair or space"),
        (json!({"id": 5, "op": "start"}).to_string(), "needs `seed`"),
        (json!({"id": 6, "op": "start", "seed": 1, "parents": []}).to_string(), "`parents` is given"),
        (json!({"id": 7, "op": "move", "seed": 1}).to_string(), "0 parents, expected 1"),
        (json!({"id": 8, "op": "move", "seed": 1, "move": "fly", "parents": [good]}).to_string(), "grow_bay"),
        (json!({"id": 9, "op": "move", "seed": 1, "steps": 0, "parents": [good]}).to_string(), "expected 1 to 16"),
        (json!({"id": 10, "op": "crossover", "seed": 1, "parents": [good]}).to_string(), "1 parents, expected 2"),
        (json!({"id": 11, "op": "repair", "parents": [short]}).to_string(), "2 labels, expected 1360"),
        (json!({"id": 12, "op": "repair", "parents": [stair]}).to_string(), "stairs[0]"),
        (json!({"id": 13, "op": "repair", "parents": [section]}).to_string(), "choices.wall_section is \"oak\""),
        (json!({"id": 14, "op": "size", "goal": "beauty", "parents": [good]}).to_string(), "goal is \"beauty\""),
        (json!({"id": 15, "op": "start", "seed": -1}).to_string(), "-1"),
        (json!({"id": 16, "op": "space", "colour": 1}).to_string(), "unknown field `colour`"),
    ];
    let mut input: String = cases.iter().map(|(line, _)| format!("{line}\n")).collect();
    input += &json!({"id": "last", "op": "start", "seed": 2}).to_string();
    let answers = vary(STARTER, &input);
    assert_eq!(answers.len(), cases.len() + 1);
    for (n, (answer, (_, part))) in answers.iter().zip(&cases).enumerate() {
        let error = answer["error"].as_str().expect("an error");
        has(error, &[part, &format!("line {}", n + 1)]);
        assert_eq!(answer["id"].as_u64(), if n < 2 { None } else { Some(n as u64 + 1) });
    }
    keeps_rules(&answers[cases.len()]);
}

/// Houses of another make, such as one with a saddle roof, are parents too: they are repaired first.
#[test]
fn any_house_can_be_a_parent() {
    let folder = Scratch::new();
    let brief = folder.brief("wide.json", |b| {
        b["plot"]["modules"] = json!([26, 20, 26]);
        b["programme"] = json!({"floor_area_m2": [20, 400], "storeys": [1, 3], "clear_height_m": 2.4});
    });
    for (name, sample) in samples::gallery().into_iter().chain(samples::all()) {
        let mut voxels = VoxelArray::new([26, 20, 26]);
        sample.voxels.iter().filter(|(_, l)| l.is_filled()).for_each(|(v, l)| voxels.set(v, l));
        let labels: Vec<u8> = voxels.labels().iter().map(|l| l.code()).collect();
        let parent = json!({"shape": [26, 20, 26], "labels": labels, "stairs": sample.stairs});
        let answer = &vary(&brief, &lines(&[json!({"op": "move", "seed": 1, "parents": [parent]})]))[0];
        assert!(answer["error"].is_null(), "{name}: {answer}");
        let broken = rules::check(&house(&genome(answer)), &RuleSettings::default());
        assert!(broken.is_empty(), "{name}: {}", broken[0].message);
    }
}
