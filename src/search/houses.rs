//! Houses as a [`Domain`]: moves, crossover, starts, and sections sized by an evaluator.

use super::crossover::crossover;
use super::domain::{Arm, Domain, Operator};
use super::identity::identity;
use super::massing::{Design, encode};
use super::moves::Move;
use super::niche::{Niche, niche};
use super::plot::Space;
use super::settle::settle;
use super::start::start;
use super::symmetry::Symmetry;
use crate::voxels::{Choices, House};
use rand_chacha::ChaCha8Rng;

/// A rule check on encoded houses: the id of the first rule that is broken.
pub type RuleCheck<'a> = dyn Fn(&House) -> Option<&'static str> + Sync + 'a;

/// Sizes the sections of a house whose joists and boards stay, for the goal of that number. `None` where it cannot.
pub type Size<'a> = dyn Fn(&House, &Choices, usize) -> Option<Choices> + Sync + 'a;

/// Whether a test of bounds holds for those of a house: what an evaluator knows without a solve.
pub type Screen<'a> = dyn Fn(&House, &Choices, &dyn Fn(&[f64]) -> bool) -> bool + Sync + 'a;

/// The houses of a space.
#[derive(Clone)]
pub struct Houses<'a> {
    /// What may be drawn.
    pub space: &'a Space,
    rules: Option<&'a RuleCheck<'a>>,
    size: Option<(&'a Size<'a>, usize)>,
    screen: Option<&'a Screen<'a>>,
    arms: Vec<Arm>,
    /// Symmetries of the plot besides the identity, up to which houses are told apart.
    symmetries: Vec<Symmetry>,
}

impl<'a> Houses<'a> {
    /// Houses of `space`; every one passes `rules` before it is proposed (hard rules), where given.
    pub fn new(space: &'a Space, rules: Option<&'a RuleCheck<'a>>) -> Self {
        let of_move = |m: &Move| Arm { operator: Operator(m.name()), parents: 1, weight: f64::from(m.weight()) };
        let mut arms: Vec<Arm> = Move::ALL.iter().map(of_move).collect();
        arms.push(Arm { operator: Operator("crossover"), parents: 2, weight: 1.0 });
        Houses { space, rules, size: None, screen: None, arms, symmetries: Vec::new() }
    }

    /// Lets houses be sized for `goals` goals.
    pub fn sized_by(mut self, size: &'a Size<'a>, goals: usize) -> Self {
        self.size = Some((size, goals));
        self
    }

    /// Lets the search ask for bounds before an evaluation.
    pub fn screened_by(mut self, screen: &'a Screen<'a>) -> Self {
        self.screen = Some(screen);
        self
    }

    /// Takes houses that are images of each other by a symmetry of the plot for the same house.
    pub fn up_to_symmetry(mut self) -> Self {
        self.symmetries = Symmetry::of(&self.space.plot);
        self.symmetries.retain(|s| *s != Symmetry::IDENTITY);
        self
    }
}

impl Domain for Houses<'_> {
    type Genome = Design;
    type Form = House;

    fn arms(&self) -> &[Arm] {
        &self.arms
    }

    fn start(&self, rng: &mut ChaCha8Rng) -> Option<Design> {
        start(self.space, rng).ok()
    }

    fn vary(&self, arm: usize, parents: [&Design; 2], rng: &mut ChaCha8Rng) -> Option<Design> {
        match Move::ALL.get(arm) {
            Some(one) => one.apply(parents[0], self.space, rng),
            None => crossover(parents[0], parents[1], self.space, rng),
        }
    }

    fn express(&self, genome: &Design) -> House {
        encode(&genome.massing, &self.space.plot)
    }

    fn key(&self, genome: &Design, form: &House) -> u128 {
        let images = self.symmetries.iter().filter_map(|s| s.design(genome, self.space));
        let key = |image: Design| identity(&encode(&image.massing, &self.space.plot), &image.choices);
        images.map(key).fold(identity(form, &genome.choices), u128::min)
    }

    fn niche(&self, genome: &Design) -> Niche {
        niche(genome)
    }

    fn broken_rule(&self, form: &House) -> Option<&'static str> {
        self.rules.and_then(|check| check(form))
    }

    fn is_beaten(&self, genome: &Design, form: &House, beaten: &dyn Fn(&[f64]) -> bool) -> bool {
        self.screen.is_some_and(|screen| screen(form, &genome.choices, beaten))
    }

    fn goals(&self) -> usize {
        self.size.map_or(0, |(_, goals)| goals)
    }

    fn polish(&self, genome: &Design, form: &House, goal: usize) -> Option<Design> {
        let choices = self.size?.0(form, &genome.choices, goal)?;
        (choices != genome.choices).then(|| Design { choices, ..genome.clone() })
    }

    /// The donor's sections, joists and boards.
    fn graft(&self, start: &Design, donor: &Design) -> Option<Design> {
        let mut out = Design { choices: donor.choices, ..start.clone() };
        settle(&mut out, self.space).ok()?;
        Some(out)
    }
}
