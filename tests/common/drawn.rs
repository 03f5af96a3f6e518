//! Houses to test with: those that ship, and some as the search draws them.

use houscaper::search::massing::{Design, encode};
use houscaper::search::moves::Move;
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::start::start;
use houscaper::voxels::{Choices, House, samples};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// One or two storeys of 40 to 240 m2 on 18 x 13 modules.
pub fn space() -> Space {
    let plot = Plot::new([18, 13, 20], None).expect("a plot");
    let programme = Programme { floor_area_m2: [40.0, 240.0], storeys: [1, 2], ..Programme::default() };
    Space::new(plot, programme, ChoiceSpace::default()).expect("a space")
}

/// A start and a few moves from it.
pub fn draw(space: &Space, seed: u64) -> (House, Choices) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut design: Design = start(space, &mut rng).expect("a start");
    for _ in 0..seed % 6 {
        if let Some(next) = Move::draw(&mut rng).apply(&design, space, &mut rng) {
            design = next;
        }
    }
    (encode(&design.massing, &space.plot), design.choices)
}

/// All samples, with the first of every choice.
#[allow(dead_code, reason = "each test file takes what it needs")]
pub fn shipped() -> Vec<(String, House, Choices)> {
    let houses = samples::all().into_iter().chain(samples::gallery());
    houses.map(|(name, house)| (name.to_owned(), house, Choices::default())).collect()
}

/// The first `count` houses drawn.
#[allow(dead_code, reason = "each test file takes what it needs")]
pub fn random(count: u64) -> Vec<(String, House, Choices)> {
    let space = space();
    let named = |seed: u64| {
        let (house, choices) = draw(&space, seed);
        (format!("random {seed}"), house, choices)
    };
    (0..count).map(named).collect()
}
