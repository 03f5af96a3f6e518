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
    /// Searches for each aim by itself and fills in the neighbours; returns how many children were thrown away because they changed
    /// locked voxels.
    pub fn explore(&self, args: &Improve, found: &mut Found) -> u64 {
        let evaluator = &self.asked.evaluator;
        let rules = |house: &House| evaluator.broken_rule(house);
        let goals = SizingGoal::of_brief(&evaluator.brief);
        let size = |house: &House, choices: &Choices, goal: usize| evaluator.resize(house, choices, goals[goal]);
        let houses = Houses::new(self.space, Some(&rules)).sized_by(&size, goals.len());
        let around = Around { houses, design: self.start, locked: self.locked };
        let settings = Settings { starts: 32, pool: 40, ..Settings::default() };
        let count = found.aim.len() as u64;
        let mut locked_out = 0;
        let mut taken: Vec<Design> = Vec::new();
        for (n, aim) in found.aim.clone().into_iter().enumerate() {
            let mut searcher = Steady::new(&around, args.seed, settings.clone());
            let evaluations = (args.evaluations / count + u64::from((n as u64) < args.evaluations % count)).max(1);
            let limits = Limits { evaluations, reference: None, stagnation: None };
            let score = |design: &Design, house: &House| self.score(design, house, aim, found.least_m2);
            let outcome = search(&mut searcher, &score, &limits, &mut |_| (), &mut |_| ControlFlow::Continue(()));
            found.evaluations += outcome.progress.evaluations;
            let lock = searcher.tally().rejected.iter().filter(|((_, rule), _)| *rule == LOCK);
            locked_out += lock.map(|(_, n)| n).sum::<u64>();
            let open = |design: &Design| !taken.contains(design);
            let better: Vec<(&[f64], Neighbour)> = outcome
                .archive
                .iter()
                .filter(|entry| open(&entry.item))
                .filter_map(|entry| Some((entry.objectives.as_slice(), self.neighbour(&entry.item, aim, found)?)))
                .collect();
            let room = (MOST - found.neighbours.len()) / (count as usize - n);
            let chosen = choose(better, aim, room);
            taken.extend(chosen.iter().map(|neighbour| neighbour.design.clone()));
            found.neighbours.extend(chosen);
        }
        locked_out
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

    /// Objectives: the aim and what is changed; of a stiffer house its price too, as steel throughout is always stiffer; of one that is to
    /// be valid what is changed and its price.
    fn score(&self, design: &Design, house: &House, aim: Aim, least_m2: f64) -> Score {
        let evaluation = self.asked.evaluator.evaluate(house, &design.choices);
        let area = evaluation.values.get(Objective::FloorAreaM2);
        let missing = if least_m2 > 0.0 { ((least_m2 - area) / least_m2).max(0.0) } else { 0.0 };
        let figures = Figures::new(&evaluation, 0.0);
        let (value, change) = (aim.value(&figures), self.change(design, house));
        let objectives = match aim {
            Aim::Price | Aim::Carbon => vec![value, change],
            Aim::Stiffness => vec![figures.value(Objective::PriceEur), change, value],
            Aim::Valid => vec![change, value],
        };
        Score { objectives, violation: figures.violation + missing }
    }

    /// The neighbour of a design; `None` where it is not better in what was searched for.
    fn neighbour(&self, design: &Design, aim: Aim, found: &Found) -> Option<Neighbour> {
        let mut house = encode(&design.massing, &self.space.plot);
        house.voxels.origin_m = self.house.voxels.origin_m;
        let evaluation = self.asked.evaluator.evaluate(&house, &design.choices);
        let figures = Figures::new(&evaluation, self.asked.site.violation(&house));
        let was_valid = found.before.violation <= 0.0;
        let gains = |aim: &Aim| match aim {
            Aim::Valid => !was_valid,
            aim => aim.value(&figures) < aim.value(&found.before) * (1.0 - GAIN),
        };
        if !gains(&aim) || figures.violation > 0.0 {
            return None;
        }
        let better: Vec<&'static str> = Aim::ALL.iter().filter(|aim| gains(aim)).map(|aim| aim.better()).collect();
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

/// At most `room` neighbours: of a front from few changes to large ones those that together dominate most; for a house that is to be
/// valid the nearest.
fn choose(better: Vec<(&[f64], Neighbour)>, aim: Aim, room: usize) -> Vec<Neighbour> {
    let points: Vec<&[f64]> = better.iter().map(|(point, _)| *point).collect();
    let reference = reference_point(points.iter().copied()).unwrap_or_default();
    let mut chosen = match aim {
        Aim::Valid => (0..points.len()).collect(),
        Aim::Price | Aim::Carbon | Aim::Stiffness => spread_subset(&points, &reference, room),
    };
    chosen.sort_by(|&a, &b| points[a][0].total_cmp(&points[b][0]).then(a.cmp(&b)));
    chosen.truncate(room);
    let mut all: Vec<Option<Neighbour>> = better.into_iter().map(|(_, neighbour)| Some(neighbour)).collect();
    chosen.into_iter().filter_map(|i| all[i].take()).collect()
}
