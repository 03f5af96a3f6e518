//! The heart: voxels and brief in, evaluation out.

use std::sync::{Mutex, PoisonError};

use super::carcass::{Carcass, Carcasses};
use super::{Evaluation, LayerRow, Tiling, layers};
use crate::brief::{Brief, Constraint};
use crate::envelope::{EnvelopeAreas, HouseVolumes, KeyCache, Skin, stretch};
use crate::frame::{FrameWorkspace, HouseFrame, JointScratch};
use crate::parts;
use crate::price::{Books, PriceError, RateTable};
use crate::structure::{self, Catalogue, LoadSettings, SectionOption};
use crate::tiles::{LinearTileset, depth_um};
use crate::voxels::rules::{self, RuleSettings, Scratch, Violation};
use crate::voxels::{Boards, Choice, Choices, House, Reading, read_storeys};

/// Everything an evaluation rests on, loaded once and shared by all threads.
///
/// It keeps what the sections do not change of the latest houses. Whoever exchanges rules, tiling, linear tileset, rates or what boards the brief
/// offers after an evaluation calls [`Evaluator::forget`].
pub struct Evaluator {
    /// The brief.
    pub brief: Brief,
    /// Limits beyond the verdict's own.
    pub limits: Vec<Constraint>,
    /// Materials and sections.
    pub catalogue: Catalogue,
    /// Options of wall, floor, beam and roof sections.
    pub options: [Vec<SectionOption>; 4],
    /// What houses are built of.
    pub tiling: Tiling,
    /// Skeleton tiles.
    pub linear: LinearTileset,
    /// Books.
    pub books: Books,
    /// The books as numbers.
    pub rates: RateTable,
    /// Loads.
    pub loads: LoadSettings,
    /// Rule settings.
    pub rules: RuleSettings,
    pub(super) idle: Mutex<Vec<Workspace>>,
    pub(super) carcasses: Carcasses,
}

/// Buffers of one evaluation; a thread takes one and gives it back.
#[derive(Default)]
pub(super) struct Workspace {
    pub(super) rules: Scratch,
    pub(super) frame: FrameWorkspace,
    pub(super) joints: JointScratch,
    pub(super) structure: structure::Workspace,
    pub(super) ids: Vec<u32>,
    pub(super) keys: KeyCache,
}

/// An evaluation with what it was made from, for reports.
pub struct Details {
    /// The evaluation.
    pub evaluation: Evaluation,
    /// Storeys, plates, openings.
    pub reading: Reading,
    /// Areas of the envelope; `None` when a cube is inadmissible.
    pub areas: Option<EnvelopeAreas>,
    /// Volumes of the drawn solids; `None` for a set of surfaces alone and when a cube is inadmissible.
    pub volumes: Option<HouseVolumes>,
    /// The frame; `None` when none can be made.
    pub frame: Option<HouseFrame>,
    /// Every rule violation.
    pub violations: Vec<Violation>,
}

impl Evaluator {
    /// The section options a house has chosen, wall, floor, beam, roof. Values beyond the lists wrap around.
    pub fn sections(&self, choices: &Choices) -> [SectionOption; 4] {
        [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof].map(|group| {
            let options = &self.options[group as usize];
            options[choices.get(group) % options.len()]
        })
    }

    /// Which sides of the outer walls of a house carry boards. Values beyond the brief's list wrap around.
    pub fn boards(&self, choices: &Choices) -> Boards {
        let offered = &self.brief.wall_boards;
        offered.get(choices.get(Choice::Boards) % offered.len().max(1)).copied().unwrap_or_default()
    }

    /// The first rule a house breaks, `None` when it keeps them all.
    pub fn broken_rule(&self, house: &House) -> Option<&'static str> {
        let mut workspace = self.take();
        let reading = read_storeys(house);
        let amount = rules::violation(house, &reading, &self.rules, &mut workspace.rules);
        self.give(workspace);
        if amount <= 0.0 {
            return None;
        }
        rules::check(house, &self.rules).first().map(|v| v.rule)
    }

    /// Evaluates a house.
    pub fn evaluate(&self, house: &House, choices: &Choices) -> Evaluation {
        let mut workspace = self.take();
        let asked = &mut workspace.structure;
        (asked.detail, asked.report, asked.thesis) = (false, false, false);
        let carcass = self.known_carcass(house, choices, &mut workspace);
        let evaluation = self.judged(self.priced(&carcass, house, choices), &carcass, choices, &mut workspace);
        self.give(workspace);
        evaluation
    }

    /// Evaluates a house and keeps everything for reports; a house that breaks rules is analysed all the same, as far as it can be.
    pub fn details(&self, house: &House, choices: &Choices) -> Details {
        let mut workspace = self.take();
        let asked = &mut workspace.structure;
        (asked.detail, asked.report, asked.thesis) = (true, true, true);
        let carcass = self.carcass(house, choices, &mut workspace, true);
        let evaluation = self.judged(self.priced(&carcass, house, choices), &carcass, choices, &mut workspace);
        let volumes = carcass.areas.and_then(|_| self.tiling.volumes(house, &carcass.reading, &workspace.keys));
        self.give(workspace);
        let Carcass { reading, areas, frame, .. } = carcass;
        Details { evaluation, reading, areas, volumes, frame, violations: rules::check(house, &self.rules) }
    }

    /// How houses are cut into parts: walls as thick as their build-up and openings as built where solids are drawn.
    pub fn part_settings(&self) -> parts::Settings {
        let base = parts::Settings::default();
        match self.tiling.skin {
            Skin::Keys(_) => parts::Settings { wall_mm: f64::from(depth_um(&self.tiling.shells.wall)) / 1e3, ..base },
            _ => parts::Settings { from_slab: false, ..base },
        }
    }

    /// The take-off by component of a house with its details; `None` where no solids are drawn or nothing was taken off.
    pub fn layers(&self, house: &House, details: &Details) -> Option<Result<Vec<LayerRow>, PriceError>> {
        let (volumes, takeoff) = (details.volumes.as_ref()?, details.evaluation.takeoff.as_ref()?);
        Some(layers(volumes, stretch(&house.voxels), takeoff, &self.books, &self.tiling.shells))
    }

    /// Forgets what it keeps of earlier houses. It changes no result; measurements ask for it.
    pub fn forget(&self) {
        self.carcasses.clear();
    }

    pub(super) fn take(&self) -> Workspace {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default()
    }

    pub(super) fn give(&self, workspace: Workspace) {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner).push(workspace);
    }
}
