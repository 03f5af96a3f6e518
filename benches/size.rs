//! What an evaluation costs as houses grow: from some 200 filled voxels to 20,000, with the exponent of a power law through the times.
//!
//! `cargo bench --bench size [-- --most 20000]`. Houses are starts of the starter brief on larger and larger plots with more floor area; each
//! time is the least of some runs of a house that the evaluator has not seen, on one core.

use std::path::PathBuf;
use std::time::Instant;

use houscaper::brief::read_brief;
use houscaper::score::{Evaluator, Paths};
use houscaper::search::massing::encode;
use houscaper::search::plot::Space;
use houscaper::search::{from_brief, start::start};
use houscaper::voxels::{Choices, House};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Plots and storeys, smallest first, with the net floor area asked for, m2.
const SIZES: [([usize; 3], [usize; 2], [f64; 2]); 7] = [
    ([6, 6, 11], [1, 1], [10.0, 30.0]),
    ([8, 8, 17], [1, 2], [30.0, 70.0]),
    ([12, 10, 17], [2, 2], [90.0, 160.0]),
    ([18, 14, 23], [2, 3], [250.0, 500.0]),
    ([26, 22, 23], [2, 3], [600.0, 1100.0]),
    ([36, 32, 29], [3, 4], [1500.0, 3000.0]),
    ([48, 40, 29], [3, 4], [3000.0, 6000.0]),
];
/// Houses of each size.
const HOUSES: u64 = 5;

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let most = args.iter().position(|a| a == "--most").and_then(|i| args.get(i + 1)).and_then(|n| n.parse().ok());
    let most: usize = most.unwrap_or(usize::MAX);
    println!("filled voxels  nodes  screen ms  evaluation ms");
    let mut points: Vec<[f64; 3]> = Vec::new();
    for (modules, storeys, floor_area_m2) in SIZES {
        for (house, choices, evaluator) in houses(modules, storeys, floor_area_m2) {
            let filled = house.voxels.iter().filter(|(_, label)| label.is_filled()).count();
            if filled > most {
                continue;
            }
            let least = |stage: &dyn Fn()| {
                let time = |_| {
                    evaluator.forget();
                    let started = Instant::now();
                    stage();
                    started.elapsed().as_secs_f64() * 1e3
                };
                (0..if filled > 5000 { 3 } else { 10 }).map(time).fold(f64::INFINITY, f64::min)
            };
            let screen = least(&|| _ = evaluator.is_beaten(&house, &choices, &|_| true));
            let whole = least(&|| _ = evaluator.evaluate(&house, &choices));
            let nodes = evaluator.details(&house, &choices).frame.map_or(0, |f| f.nodes.len());
            println!("{filled:13}  {nodes:5}  {screen:9.2}  {whole:13.2}");
            points.push([filled as f64, screen, whole]);
        }
    }
    for (name, column) in [("screen", 1), ("evaluation", 2)] {
        println!("{name}: milliseconds ~ voxels^{:.2}", exponent(&points, column));
    }
}

/// Starts on a plot that keep every rule, each with the evaluator of its brief.
fn houses(
    modules: [usize; 3],
    storeys: [usize; 2],
    floor_area_m2: [f64; 2],
) -> impl Iterator<Item = (House, Choices, std::rc::Rc<Evaluator>)> {
    let home = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let configs = home.join("configs");
    let text = std::fs::read(configs.join("starter.json")).expect("the starter brief is shipped");
    let mut brief = read_brief(&text, "starter.json").expect("the starter brief is valid");
    brief.plot.modules = modules;
    (brief.programme.storeys, brief.programme.floor_area_m2) = (storeys, floor_area_m2);
    let tileset = home.join("tilesets").join(&brief.tileset);
    let linear = home.join("tilesets").join(&brief.linear);
    let paths = Paths { brief: configs.clone(), configs, tileset, linear };
    let evaluator = std::rc::Rc::new(Evaluator::load(brief, &paths).expect("its books and tilesets are shipped"));
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space: Space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("a space");
    (0..HOUSES).filter_map(move |seed| {
        let design = start(&space, &mut ChaCha8Rng::seed_from_u64(seed)).ok()?;
        let house = encode(&design.massing, &space.plot);
        evaluator.broken_rule(&house).is_none().then(|| (house, design.choices, evaluator.clone()))
    })
}

/// Slope of the least-squares line through the logarithms of voxels and time.
fn exponent(points: &[[f64; 3]], column: usize) -> f64 {
    let logs: Vec<[f64; 2]> = points.iter().map(|p| [p[0].ln(), p[column].ln()]).collect();
    let mean = |k: usize| logs.iter().map(|l| l[k]).sum::<f64>() / logs.len() as f64;
    let (x, y) = (mean(0), mean(1));
    let product = |a: usize, am: f64, b: usize, bm: f64| logs.iter().map(|l| (l[a] - am) * (l[b] - bm)).sum::<f64>();
    product(0, x, 1, y) / product(0, x, 0, x)
}
