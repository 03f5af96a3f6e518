//! The search around a house, and which of what it finds is better.

use std::ops::ControlFlow;

use houscaper::brief::Objective;
use houscaper::score::SizingGoal;
use houscaper::search::Score;
use houscaper::search::contribution::spread_subset;
use houscaper::search::houses::Houses;
use houscaper::search::hypervolume::reference_point;
use houscaper::search::improve::{Around, LOCK, Locked, changes};
use houscaper::search::massing::{Design, encode};
use houscaper::search::plot::Space;
use houscaper::search::run::{Limits, Searcher, run as search};
use houscaper::search::settle::settle;
use houscaper::search::steady::{Settings, Steady};
use houscaper::voxels::{Choices, House};

use super::{Aim, Figures, Found, Improve, Neighbour};
use crate::cli::check::Asked;

/// Neighbours at most.
const MOST: usize = 6;
/// A gain below this share of the value before is none.
const GAIN: f64 = 0.001;

/// What a search around a house needs.
pub struct Explored<'a> {
    /// Rules, books, site.
    pub asked: &'a Asked,
    /// The brief's space.
    pub space: &'a Space,
    /// The house as it is.
    pub house: &'a House,
    /// Its choices.
    pub own: Choices,
    /// The design nearest to it.
    pub start: &'a Design,
    /// What stays.
    pub locked: &'a Locked,
}

impl Explored<'_> {
    /// Searches and fills in the neighbours; returns how many children were thrown away because they changed locked voxels.
    pub fn explore(&self, args: &Improve, found: &mut Found) -> u64 {
        let evaluator = &self.asked.evaluator;
        let rules = |house: &House| evaluator.broken_rule(house);
        let goals = SizingGoal::of_brief(&evaluator.brief);
        let size = |house: &House, choices: &Choices, goal: usize| evaluator.resize(house, choices, goals[goal]);
        let houses = Houses::new(self.space, Some(&rules)).sized_by(&size, goals.len());
        let around = Around { houses, design: self.start, locked: self.locked };
        let settings = Settings { starts: 32, pool: 40, ..Settings::default() };
        let mut searcher = Steady::new(&around, args.seed, settings);
        let limits = Limits { evaluations: args.evaluations, reference: None, stagnation: None };
        let score = |design: &Design, house: &House| self.score(design, house, found);
        let outcome = search(&mut searcher, &score, &limits, &mut |_| (), &mut |_| ControlFlow::Continue(()));
        let evaluations = outcome.progress.evaluations;
        let mut better: Vec<(Vec<f64>, Neighbour)> = outcome
            .archive
            .iter()
            .filter_map(|entry| Some((entry.objectives.clone(), self.neighbour(&entry.item, found)?)))
            .collect();
        let points: Vec<&[f64]> = better.iter().map(|(point, _)| point.as_slice()).collect();
        let reference = reference_point(points.iter().copied()).unwrap_or_default();
        let mut chosen = match found.aim.as_slice() {
            // The nearest first: the front goes from few changes to a low price.
            [Aim::Valid] => (0..points.len()).collect(),
            _ => spread_subset(&points, &reference, MOST),
        };
        chosen.sort_by(|&a, &b| points[a][0].total_cmp(&points[b][0]).then(a.cmp(&b)));
        chosen.truncate(MOST);
        let mut picked: Vec<Option<Neighbour>> = better.drain(..).map(|(_, n)| Some(n)).collect();
        found.neighbours = chosen.into_iter().filter_map(|i| picked[i].take()).collect();
        found.evaluations = evaluations;
        let lock = searcher.tally().rejected.iter().filter(|((_, rule), _)| *rule == LOCK);
        lock.map(|(_, n)| n).sum()
    }

    fn change(&self, design: &Design, house: &House) -> f64 {
        (changes(&self.house.voxels, &house.voxels).len() + self.other_choices(design)) as f64
    }

    fn other_choices(&self, design: &Design) -> usize {
        let mut own = Design { choices: self.own, ..design.clone() };
        // Joists of plates that the house does not have are no choice.
        if settle(&mut own, self.space).is_err() {
            own.choices = self.own;
        }
        own.choices.0.iter().zip(design.choices.0).filter(|(a, b)| **a != *b).count()
    }

    /// Objectives: the aims and what is changed; for a house that is to be valid, what is changed and its price.
    fn score(&self, design: &Design, house: &House, found: &Found) -> Score {
        let evaluation = self.asked.evaluator.evaluate(house, &design.choices);
        let area = evaluation.values.get(Objective::FloorAreaM2);
        let missing = if found.least_m2 > 0.0 { ((found.least_m2 - area) / found.least_m2).max(0.0) } else { 0.0 };
        let figures = Figures::new(&evaluation, 0.0);
        let mut objectives: Vec<f64> = found.aim.iter().map(|aim| aim.value(&figures)).collect();
        let at = if found.aim == [Aim::Valid] { 0 } else { objectives.len() };
        objectives.insert(at, self.change(design, house));
        Score { objectives, violation: figures.violation + missing }
    }

    /// The neighbour of a design; `None` where nothing got better.
    fn neighbour(&self, design: &Design, found: &Found) -> Option<Neighbour> {
        let house = encode(&design.massing, &self.space.plot);
        let evaluation = self.asked.evaluator.evaluate(&house, &design.choices);
        let figures = Figures::new(&evaluation, self.asked.site.violation(&house));
        let gains = |aim: &&Aim| match aim {
            Aim::Valid => figures.violation <= 0.0,
            aim => aim.value(&figures) < aim.value(&found.before) * (1.0 - GAIN),
        };
        let mut better: Vec<&'static str> = found.aim.iter().filter(gains).map(|aim| aim.better()).collect();
        if better.is_empty() || figures.violation > 0.0 {
            return None;
        }
        if found.before.violation > 0.0 && better != ["valid"] {
            better.push("valid");
        }
        let changes = changes(&self.house.voxels, &house.voxels);
        let choices = self.other_choices(design);
        let operator = match (changes.is_empty(), choices) {
            (true, 0) => "stairs",
            (true, _) => "sections",
            (false, 0) => "shape",
            (false, _) => "shape and sections",
        };
        Some(Neighbour { design: design.clone(), house, figures, better, changes, choices, operator })
    }
}
