//! Sections for a given house: the cheapest, lightest or least carbon of the brief's options that pass every check.

use serde::{Deserialize, Serialize};

use super::Evaluator;
use super::evaluator::Workspace;
use crate::frame::HouseFrame;
use crate::quantities::{FrameGroup, FrameMaterial, FrameQuantity};
use crate::structure::{Bid, SectionOption, Sizing, size};
use crate::voxels::{Choice, Choices, House, Reading, read_storeys};

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
    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            SizingGoal::Price => "price",
            SizingGoal::Mass => "mass",
            SizingGoal::Carbon => "carbon",
        }
    }
}

/// A sized house.
#[derive(Clone, Debug, PartialEq)]
pub struct Sized {
    /// Sections and joist directions.
    pub choices: Choices,
    /// The walk that led there; its indices are those of the brief's options.
    pub sizing: Sizing,
    /// Analyses of the walk that was not taken: joists the other way.
    pub other: Sizing,
}

impl Sized {
    /// What was chosen and why, in a sentence.
    pub fn sentence(&self, goal: SizingGoal, evaluator: &Evaluator) -> String {
        let names = evaluator.sections(&self.choices).map(|option| evaluator.catalogue.option_name(option));
        let found = match self.sizing.result() {
            Some(step) if step.is_ok => "all checks pass",
            Some(step) if step.worst() <= 1.0 => "members hold, sheathing or drift does not",
            Some(_) | None => "no option of the brief holds",
        };
        let [wall, floor, beam, roof] = names;
        format!(
            "sized for least {} in {} analyses: wall {wall}, floor {floor}, beam {beam}, roof {roof}; {found}",
            goal.name(),
            self.sizing.steps.len() + self.other.steps.len()
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

    /// Sizes the sections of a house, joists along x or along y, whichever passes at less cost. `None` when nothing stands on its
    /// foundation or the brief offers a group no section that can be assessed. The verdict may still fail, where boards and not sections decide.
    pub fn size(&self, house: &House, goal: SizingGoal) -> Option<Sized> {
        let reading = read_storeys(house);
        let mut workspace = self.take();
        let found = self.size_both(house, &reading, goal, &mut workspace);
        self.give(workspace);
        found
    }

    fn size_both(
        &self,
        house: &House,
        reading: &Reading,
        goal: SizingGoal,
        workspace: &mut Workspace,
    ) -> Option<Sized> {
        let (bids, indices) = self.bids(reading, goal);
        if bids.iter().any(Vec::is_empty) {
            return None;
        }
        let mut along = |joists: u16| {
            let mut choices = Choices::default();
            choices.0[Choice::Joists as usize] = joists;
            let frame: HouseFrame = self.frame(house, reading, &choices, workspace)?;
            let mut sizing = size(&frame, &self.catalogue, &bids, &self.loads, &mut workspace.structure);
            let named = |at: [usize; 4]| std::array::from_fn(|g| indices[g][at[g]]);
            sizing.steps.iter_mut().for_each(|s| s.bids = named(s.bids));
            sizing.bids = named(sizing.bids);
            (0..4).for_each(|g| choices.0[g] = sizing.bids[g] as u16);
            Some((choices, sizing))
        };
        let (x, y) = (along(0)?, along(u16::MAX)?);
        let takes_y = match (x.1.result(), y.1.result()) {
            (Some(x), Some(y)) => y.is_better_than(x),
            (None, y) => y.is_some(),
            (Some(_), None) => false,
        };
        let (taken, other) = if takes_y { (y, x) } else { (x, y) };
        Some(Sized { choices: taken.0, sizing: taken.1, other: other.1 })
    }
}
