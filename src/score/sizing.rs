//! Sections for a given house: the cheapest, lightest or least carbon of the brief's options that pass every check.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::Evaluator;
use super::evaluator::Workspace;
use crate::brief::{Brief, Objective};
use crate::envelope::Surface;
use crate::quantities::{FrameGroup, FrameMaterial, FrameQuantity, Item};
use crate::structure::{Bid, SectionOption, Sizing, size};
use crate::voxels::{Boards, Choice, Choices, House, Reading, read_storeys};

/// What the sections of a house are chosen by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SizingGoal {
    /// Least price of the frame, net, at default rates, in the price book's currency.
    #[default]
    Price,
    /// Least mass of the frame, kg.
    Mass,
    /// Least fossil carbon of the frame, A1-A3, kgCO2e at default factors.
    Carbon,
}

impl SizingGoal {
    /// The goals that a brief's objectives ask for, in their order; price where they ask for none.
    pub fn of_brief(brief: &Brief) -> Vec<SizingGoal> {
        let of = |objective: Objective| match objective {
            Objective::PriceEur | Objective::PricePerM2Eur => Some(SizingGoal::Price),
            Objective::FrameMassKg | Objective::MassKg => Some(SizingGoal::Mass),
            Objective::GwpKgco2e | Objective::EnergyMj => Some(SizingGoal::Carbon),
            _ => None,
        };
        let mut goals: Vec<SizingGoal> = brief.objectives.iter().filter_map(|g| of(g.objective)).collect();
        goals.dedup();
        if goals.is_empty() { vec![SizingGoal::Price] } else { goals }
    }

    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            SizingGoal::Price => "price",
            SizingGoal::Mass => "mass",
            SizingGoal::Carbon => "carbon",
        }
    }
}

/// One walk of a sizing: joists one way, boards on one or both sides of the walls.
#[derive(Clone, Debug, PartialEq)]
pub struct SizingWalk {
    /// Sections, joist directions and boards it ended with.
    pub choices: Choices,
    /// Which sides of the walls carry boards.
    pub boards: Boards,
    /// What the second side adds, in the unit of the goal; 0 for boards on one side.
    pub boards_cost: f64,
    /// Its analyses; indices are those of the brief's options.
    pub sizing: Sizing,
}

/// How far a walk came, better first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Reached {
    /// All checks pass.
    Ok,
    /// Members hold; boards or drift do not.
    MembersHold,
    /// A member fails.
    Fails,
    /// It could not be assessed.
    Nothing,
}

impl SizingWalk {
    /// Frame and second side of boards, in the unit of the goal.
    pub fn cost(&self) -> f64 {
        self.sizing.result().map_or(f64::INFINITY, |step| step.cost) + self.boards_cost
    }

    fn reached(&self) -> Reached {
        match self.sizing.result() {
            Some(step) if step.is_ok => Reached::Ok,
            Some(step) if step.worst() <= 1.0 => Reached::MembersHold,
            Some(_) => Reached::Fails,
            None => Reached::Nothing,
        }
    }

    /// What comes further wins; of two that are ok, or that have the same boards, the cheaper; else what is nearer to standing.
    fn is_better_than(&self, other: &SizingWalk) -> bool {
        let (mine, theirs) = (self.reached(), other.reached());
        let key = |w: &SizingWalk| match w.sizing.result() {
            Some(step) if w.reached() == Reached::Fails => step.worst(),
            Some(step) if mine != Reached::Ok && self.boards != other.boards => step.sheathing_ratio,
            _ => w.cost(),
        };
        mine.cmp(&theirs).then(key(self).total_cmp(&key(other))).is_lt()
    }
}

/// A sized house.
#[derive(Clone, Debug, PartialEq)]
pub struct Sized {
    /// The walks: joists along x and along y, for each kind of boards on offer.
    pub walks: Vec<SizingWalk>,
    /// The walk that is taken.
    pub taken: usize,
}

impl Sized {
    /// Sections, joist directions and boards.
    pub fn choices(&self) -> Choices {
        self.walk().choices
    }

    /// The walk that is taken.
    pub fn walk(&self) -> &SizingWalk {
        &self.walks[self.taken]
    }

    /// Analyses of all walks.
    pub fn analyses(&self) -> usize {
        self.walks.iter().map(|w| w.sizing.steps.len()).sum()
    }

    /// What was chosen and why, in a sentence.
    pub fn sentence(&self, goal: SizingGoal, evaluator: &Evaluator) -> String {
        let walk = self.walk();
        let [wall, floor, beam, roof] =
            evaluator.sections(&walk.choices).map(|option| evaluator.catalogue.option_name(option));
        let boards = match walk.boards {
            Boards::OneSide => "one side",
            Boards::BothSides => "both sides",
        };
        let found = match walk.reached() {
            Reached::Ok => "all checks pass",
            Reached::MembersHold => "members hold, sheathing or drift does not",
            Reached::Fails | Reached::Nothing => "no option of the brief holds",
        };
        format!(
            "sized for least {} in {} analyses: wall {wall} boarded on {boards}, floor {floor}, beam {beam}, roof {roof}; {found}",
            goal.name(),
            self.analyses()
        )
    }
}

impl Evaluator {
    /// Cost of a metre of one ply by a goal; 0 for a material without rates, which briefs refuse.
    fn per_m(&self, option: SectionOption, goal: SizingGoal) -> f64 {
        let (material, section) = (self.catalogue.material(option), self.catalogue.section(option));
        let mass_kg = material.rho * section.a;
        let Some(material) = FrameMaterial::from_id(&material.id) else { return 0.0 };
        let (group, number) = (FrameGroup::Wall, option.section as u16);
        let metre = FrameQuantity { group, material, section: number, length_m: 1.0, volume_m3: section.a, mass_kg };
        let rate = &self.rates.rows[material.item() as usize];
        match goal {
            SizingGoal::Price => rate.price[1] * metre.billed(),
            SizingGoal::Mass => mass_kg,
            SizingGoal::Carbon => rate.gwp[1] * mass_kg,
        }
    }

    /// The brief's options as bids, with their indices. Joists so deep that rooms become lower than the programme asks are left out,
    /// unless all are, and so are sections that cannot be assessed (class 4).
    fn bids(&self, reading: &Reading, goal: SizingGoal) -> ([Vec<Bid>; 4], [Vec<usize>; 4]) {
        let low = |option: SectionOption| {
            let sections =
                std::array::from_fn(|g| if g == Choice::Floor as usize { option } else { self.options[g][0] });
            self.clear_height_m(reading, &sections) < self.brief.programme.clear_height_m - 1e-9
        };
        let floors = &self.options[Choice::Floor as usize];
        let all_low = floors.iter().all(|&o| low(o));
        let indices: [Vec<usize>; 4] = std::array::from_fn(|g| {
            let fits = |n: &usize| g != Choice::Floor as usize || all_low || !low(self.options[g][*n]);
            let assessed = |n: &usize| !self.catalogue.is_class_4(self.options[g][*n]);
            (0..self.options[g].len()).filter(fits).filter(assessed).collect()
        });
        let bids = std::array::from_fn(|g| {
            let bid = |&n: &usize| Bid { option: self.options[g][n], per_m: self.per_m(self.options[g][n], goal) };
            indices[g].iter().map(bid).collect()
        });
        (bids, indices)
    }

    /// What boards on the second side of a house's walls add by a goal; 0 where its skin cannot be measured.
    fn second_side(&self, house: &House, reading: &Reading, goal: SizingGoal, workspace: &mut Workspace) -> f64 {
        let survey = self.tiling.survey(house, reading, &mut workspace.keys).ok();
        let wall_m2 = survey.map_or(0.0, |s| s.areas.area_m2[Surface::Wall as usize]);
        let per_m2 = |item: Item| {
            let rate = &self.rates.rows[item as usize];
            match goal {
                SizingGoal::Price => rate.price[1],
                SizingGoal::Mass => rate.mass_kg,
                SizingGoal::Carbon => rate.gwp[1],
            }
        };
        wall_m2 * (per_m2(Item::WallBothSides) - per_m2(Item::Wall))
    }

    /// Sizes the sections of a house: joists along x or along y, boards on one or both sides of the walls as the brief offers them,
    /// whichever passes at least cost. `None` when nothing stands on its foundation or the brief offers a group no section that can be
    /// assessed. The verdict may still fail, where neither sections nor boards are enough.
    pub fn size(&self, house: &House, goal: SizingGoal) -> Option<Sized> {
        let reading = read_storeys(house);
        let mut workspace = self.take();
        let found = self.size_all(house, &reading, goal, &mut workspace);
        self.give(workspace);
        found
    }

    /// Sections for a house whose joists and boards stay as they are: what a search makes of a child. `None` where nothing can be assessed.
    pub fn resize(&self, house: &House, choices: &Choices, goal: SizingGoal) -> Option<Choices> {
        let reading = read_storeys(house);
        let bids = self.bids(&reading, goal);
        let mut workspace = self.take();
        workspace.structure.thesis = false;
        let found = self.walk(house, *choices, &bids, true, &mut workspace);
        self.give(workspace);
        let (choices, sizing) = found?;
        sizing.result().map(|_| choices)
    }

    fn size_all(&self, house: &House, reading: &Reading, goal: SizingGoal, workspace: &mut Workspace) -> Option<Sized> {
        workspace.structure.thesis = false;
        let bids = self.bids(reading, goal);
        let mut walks: Vec<SizingWalk> = Vec::new();
        let mut taken = 0;
        for boards in Boards::ALL {
            let Some(index) = self.brief.wall_boards.iter().position(|b| *b == boards) else { continue };
            let boards_cost = match boards {
                Boards::OneSide => 0.0,
                Boards::BothSides => self.second_side(house, reading, goal, workspace),
            };
            for joists in [0, u16::MAX] {
                let mut choices = Choices::default();
                (choices.0[Choice::Joists as usize], choices.0[Choice::Boards as usize]) = (joists, index as u16);
                let (choices, sizing) = self.walk(house, choices, &bids, false, workspace)?;
                let walk = SizingWalk { choices, boards, boards_cost, sizing };
                if walks.get(taken).is_some_and(|best| walk.is_better_than(best)) {
                    taken = walks.len();
                }
                walks.push(walk);
            }
        }
        (!walks.is_empty()).then_some(Sized { walks, taken })
    }

    /// One walk with joists and boards given, from the sections given where that is asked for: the choices with their sections, and the analyses in the brief's indices.
    fn walk(
        &self,
        house: &House,
        mut choices: Choices,
        (bids, indices): &([Vec<Bid>; 4], [Vec<usize>; 4]),
        from_choices: bool,
        workspace: &mut Workspace,
    ) -> Option<(Choices, Sizing)> {
        if bids.iter().any(Vec::is_empty) {
            return None;
        }
        // A house that breaks rules is sized all the same.
        let mut carcass = self.known_carcass(house, &choices, workspace);
        if carcass.rules > 0.0 {
            carcass = Arc::new(self.carcass(house, &choices, workspace, true));
        }
        let frame = carcass.frame.as_ref()?;
        // Options left out as bids begin with the first of the list.
        let place = |g: usize| indices[g].iter().position(|&n| n == usize::from(choices.0[g])).unwrap_or(0);
        let start = from_choices.then(|| std::array::from_fn(place));
        let mut sizing = size(frame, &self.catalogue, bids, start, &self.loads, &mut workspace.structure);
        let named = |at: [usize; 4]| std::array::from_fn(|g| indices[g][at[g]]);
        sizing.steps.iter_mut().for_each(|s| s.bids = named(s.bids));
        sizing.bids = named(sizing.bids);
        (0..4).for_each(|g| choices.0[g] = sizing.bids[g] as u16);
        Some((choices, sizing))
    }
}
