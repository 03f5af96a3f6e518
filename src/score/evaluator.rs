//! The heart: voxels and brief in, evaluation out.

use std::sync::{Mutex, PoisonError};

use super::evaluation::{limit_violation, structural_violation};
use super::layer_weights::layer_weights;
use super::measure::{add_building, decks_and_railing};
use super::programme::{floor_area_m2, glazing_ratio, shortfall};
use super::{Evaluation, LayerRow, Tiling, Values, layers};
use crate::brief::{Brief, Constraint, Objective};
use crate::cubes;
use crate::envelope::{EnvelopeAreas, EnvelopeSurvey, HouseVolumes, KeyCache, Skin, Surface, stretch};
use crate::frame::{self, FrameWorkspace, HouseFrame, JointScratch, distinct_joints};
use crate::parts;
use crate::price::{Books, Cost, PriceError, RateTable, cost};
use crate::quantities::{FrameGroup, FrameMaterial, FrameQuantity, RoofEdges, Takeoff, TakeoffError, Works};
use crate::structure::{self, Assessment, Catalogue, LoadSettings, SectionOption, Verdict};
use crate::tiles::solids::edges::EdgeTerms;
use crate::tiles::{LinearTileset, depth_um};
use crate::voxels::rules::{self, RuleSettings, Scratch, Violation};
use crate::voxels::{Boards, Choice, Choices, House, Reading, read_storeys};

/// Everything an evaluation rests on, loaded once and shared by all threads.
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
}

/// Buffers of one evaluation; a thread takes one and gives it back.
#[derive(Default)]
pub(super) struct Workspace {
    rules: Scratch,
    frame: FrameWorkspace,
    joints: JointScratch,
    pub(super) structure: structure::Workspace,
    ids: Vec<u32>,
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
        let reading = read_storeys(house);
        let (evaluation, _, _) = self.run(house, &reading, choices, &mut workspace, false);
        self.give(workspace);
        evaluation
    }

    /// Evaluates a house and keeps everything for reports; a house that breaks rules is analysed all the same, as far as it can be.
    pub fn details(&self, house: &House, choices: &Choices) -> Details {
        let mut workspace = self.take();
        let asked = &mut workspace.structure;
        (asked.detail, asked.report, asked.thesis) = (true, true, true);
        let reading = read_storeys(house);
        let (evaluation, areas, frame) = self.run(house, &reading, choices, &mut workspace, true);
        let volumes = areas.and_then(|_| self.tiling.volumes(house, &reading, &workspace.keys));
        self.give(workspace);
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

    /// The frame of a house, with the weight of the layers taken off; `None` when nothing stands on its foundation.
    pub(super) fn frame(
        &self,
        house: &House,
        reading: &Reading,
        choices: &Choices,
        layers: Option<&Takeoff>,
        workspace: &mut Workspace,
    ) -> Option<HouseFrame> {
        let lines = |mask: u8| self.linear.lines(cubes::Mask(mask));
        workspace.frame.options.boards = self.boards(choices);
        let mut frame = frame::build(house, reading, choices, lines, &mut workspace.frame).ok()?;
        frame.layers_n_m2 = layers.map(|takeoff| layer_weights(house, takeoff, &self.rates, &frame));
        Some(frame)
    }

    /// The take-off of a house but for its frame and works; `None` when its skin cannot be measured.
    pub(super) fn layers_of(
        &self,
        house: &House,
        reading: &Reading,
        choices: &Choices,
        survey: Option<&EnvelopeSurvey>,
    ) -> Option<Takeoff> {
        self.take_off(house, reading, survey?, choices).ok()
    }

    pub(super) fn take(&self) -> Workspace {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default()
    }

    pub(super) fn give(&self, workspace: Workspace) {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner).push(workspace);
    }

    fn run(
        &self,
        house: &House,
        reading: &Reading,
        choices: &Choices,
        workspace: &mut Workspace,
        always: bool,
    ) -> (Evaluation, Option<EnvelopeAreas>, Option<HouseFrame>) {
        let rules = rules::violation(house, reading, &self.rules, &mut workspace.rules);
        let sections = self.sections(choices);
        let clear = self.clear_height_m(reading, &sections);
        let glazing = glazing_ratio(house, reading, self.rules.view_m);
        let shortfall = shortfall(&self.brief.programme, house, reading, clear, glazing);
        if rules > 0.0 && !always {
            return (Evaluation::broken(rules, shortfall), None, None);
        }
        let survey = self.tiling.survey(house, reading, &mut workspace.keys).ok();
        let areas = survey.map(|s| s.areas);
        let layers = self.layers_of(house, reading, choices, survey.as_ref());
        let frame = self.frame(house, reading, choices, layers.as_ref(), workspace);
        let assessment = match &frame {
            Some(frame) => structure::assess(frame, &self.catalogue, &sections, &self.loads, &mut workspace.structure),
            None => Assessment {
                verdict: Verdict::NotAssessed { reason: "no wall stands on the foundation" },
                ..Assessment::default()
            },
        };
        let mut evaluation = Evaluation::broken(rules, shortfall);
        let takeoff =
            layers.and_then(|takeoff| self.with_frame(takeoff, choices, &assessment).ok()).zip(areas.as_ref());
        if let Some((mut takeoff, areas)) = takeoff {
            let works = self.works(house, reading, choices, frame.as_ref(), workspace);
            takeoff.set_works(works.unwrap_or_default());
            let cost = cost(&takeoff, &self.rates);
            evaluation.values = self.values(house, reading, areas, &assessment, &cost, &mut workspace.ids);
            let distinct_parts = works.map_or(f64::NAN, |works| f64::from(works.part_types));
            evaluation.values.set(Objective::DistinctParts, distinct_parts);
            evaluation.cost = Some(cost);
            evaluation.takeoff = Some(takeoff);
        }
        if rules <= 0.0 {
            evaluation.violation = structural_violation(&assessment, self.loads.preset_only)
                + shortfall.total()
                + limit_violation(&self.limits, &evaluation.values);
        }
        evaluation.assessment = Some(assessment);
        (evaluation, areas, frame)
    }

    /// What making and putting up the house depends on; `None` for a house too high to be cut into parts.
    fn works(
        &self,
        house: &House,
        reading: &Reading,
        choices: &Choices,
        frame: Option<&HouseFrame>,
        workspace: &mut Workspace,
    ) -> Option<Works> {
        let parts = parts::cut(house, reading, choices, self.part_settings()).ok()?;
        let node_types = frame.map_or(0, |frame| distinct_joints(frame, &mut workspace.joints) as u32);
        Some(Works { node_types, ..parts.works() })
    }

    /// Smallest clear height of a storey when joists deeper than the standard slab zone take from it, m.
    pub(super) fn clear_height_m(&self, reading: &Reading, sections: &[SectionOption; 4]) -> f64 {
        let deeper =
            (self.catalogue.slab_zone_m(sections[Choice::Floor as usize]) - crate::voxels::SLAB_ZONE_M).max(0.0);
        let least = reading.storeys.iter().map(|s| s.clear_height_m).fold(f64::INFINITY, f64::min);
        if least.is_finite() { least - deeper } else { 0.0 }
    }

    fn take_off(
        &self,
        house: &House,
        reading: &Reading,
        survey: &EnvelopeSurvey,
        choices: &Choices,
    ) -> Result<Takeoff, TakeoffError> {
        let decks = decks_and_railing(house, reading);
        let deck_m2 = survey.areas.area_m2[Surface::Deck as usize];
        let mut takeoff = Takeoff::new(&survey.areas, decks.walked_m2.min(deck_m2))?;
        let EdgeTerms { overhang_m2, gutter_m, parapet_m2, coping_m, railing_m } = survey.edges;
        let shells = matches!(self.tiling.skin, Skin::Keys(_)).then_some(&self.tiling.shells);
        // Railing along decks as it is drawn, where solids are.
        let along_decks_m = if shells.is_some() { railing_m } else { decks.railing_m };
        add_building(&mut takeoff, house, reading, along_decks_m + decks.void_railing_m, shells)?;
        takeoff.set_boards(self.boards(choices));
        takeoff.add_roof_edges(&RoofEdges { overhang_m2, gutter_m, parapet_m2, coping_m })?;
        Ok(takeoff)
    }

    /// A take-off with the members of the frame.
    fn with_frame(
        &self,
        mut takeoff: Takeoff,
        choices: &Choices,
        assessment: &Assessment,
    ) -> Result<Takeoff, TakeoffError> {
        for (g, &option) in self.sections(choices).iter().enumerate() {
            let length_m = assessment.group_length_m[g];
            let (Some(group), Some(material)) =
                (FrameGroup::from_index(g), FrameMaterial::from_id(&self.catalogue.material(option).id))
            else {
                continue;
            };
            let row = FrameQuantity {
                group,
                material,
                section: option.section as u16,
                length_m,
                volume_m3: length_m * self.catalogue.section(option).a,
                mass_kg: assessment.group_mass_kg[g],
            };
            if length_m > 0.0 {
                takeoff.add_frame(&[row])?;
            }
        }
        Ok(takeoff)
    }

    fn values(
        &self,
        house: &House,
        reading: &Reading,
        areas: &EnvelopeAreas,
        assessment: &Assessment,
        cost: &Cost,
        ids: &mut Vec<u32>,
    ) -> Values {
        let floor = floor_area_m2(reading);
        let per_floor = |value: f64| if floor > 0.0 { value / floor } else { f64::NAN };
        let checked = |ratio: f64| if self.loads.preset_only { f64::NAN } else { ratio };
        let mut values = Values::default();
        for (objective, value) in [
            (Objective::PriceEur, cost.price_eur[1]),
            (Objective::PricePerM2Eur, per_floor(cost.price_eur[1])),
            (Objective::FrameMassKg, assessment.frame_mass_kg),
            (Objective::MassKg, cost.mass_kg),
            (Objective::GwpKgco2e, cost.gwp_fossil[1]),
            (Objective::EnergyMj, cost.energy_mj.unwrap_or(f64::NAN)),
            (Objective::Utilisation, checked(assessment.utilisation)),
            (Objective::SwayRatio, checked(assessment.sway_ratio)),
            (Objective::DeflectionRatio, checked(assessment.deflection_ratio)),
            (Objective::FloorAreaM2, floor),
            (Objective::GlazingRatio, glazing_ratio(house, reading, self.rules.view_m)),
            (Objective::EnvelopeRatio, per_floor(areas.area_m2.iter().sum())),
            (Objective::HeatLossWPerK, cost.heat_loss_w_per_k),
            (Objective::DistinctTiles, distinct_tiles(house, ids) as f64),
        ] {
            values.set(objective, value);
        }
        values
    }
}

/// Number of distinct cube ids among the cubes that are neither empty nor full.
fn distinct_tiles(house: &House, ids: &mut Vec<u32>) -> usize {
    ids.clear();
    cubes::scan_masks(&house.voxels, |cube, mask| {
        if mask.0 != 0 && mask.0 != 255 {
            let labels = cubes::cube_labels(&house.voxels, cube);
            ids.push(cubes::ThesisId::new(&labels, cubes::CornerOrder::FOrder).0);
        }
    });
    ids.sort_unstable();
    ids.dedup();
    ids.len()
}
