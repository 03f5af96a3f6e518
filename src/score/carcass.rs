//! A house but for its sections: what its voxels, the way its joists run and its boards decide.
//!
//! Most of what an evaluation costs beside the solve is here, and children that differ from a parent by a section share all of it: an
//! evaluator keeps the latest.

use std::collections::VecDeque;
use std::hash::Hasher;
use std::sync::{Arc, Mutex, PoisonError};

use rustc_hash::FxHasher;

use super::Evaluator;
use super::evaluator::Workspace;
use super::layer_weights::layer_weights;
use super::measure::{add_building, decks_and_railing};
use super::programme::glazing_ratio;
use crate::cubes;
use crate::envelope::{EnvelopeAreas, EnvelopeSurvey, Skin, Surface};
use crate::frame::{self, HouseFrame, distinct_joints};
use crate::parts;
use crate::quantities::{RoofEdges, Takeoff, TakeoffError, Works};
use crate::tiles::solids::edges::EdgeTerms;
use crate::voxels::rules;
use crate::voxels::{Choice, Choices, House, Reading, read_storeys};

/// A house but for its sections.
#[derive(Clone)]
pub(super) struct Carcass {
    /// Storeys, plates, openings.
    pub reading: Reading,
    /// Sum of the rule violations' amounts.
    pub rules: f64,
    /// Glass over floor of the smallest storey.
    pub glazing: f64,
    /// Areas of the envelope; `None` when a cube is inadmissible.
    pub areas: Option<EnvelopeAreas>,
    /// The take-off but for the frame; `None` when the skin cannot be measured.
    pub layers: Option<Takeoff>,
    /// The frame with the weight of the layers; `None` when nothing stands on the foundation. Without what an analysis asks for until
    /// [`Evaluator::complete`] has seen it.
    pub frame: Option<HouseFrame>,
    /// Parts and joints; `None` for a house too high to be cut into parts.
    pub works: Option<Works>,
    /// Number of distinct cube ids.
    pub tiles: f64,
}

impl Evaluator {
    /// The carcass of a house, as far as prices ask for it. One that breaks rules goes no further than that unless `always`.
    pub(super) fn bare_carcass(
        &self,
        house: &House,
        choices: &Choices,
        workspace: &mut Workspace,
        always: bool,
    ) -> Carcass {
        let reading = read_storeys(house);
        let rules = rules::violation(house, &reading, &self.rules, &mut workspace.rules);
        let glazing = glazing_ratio(house, &reading, self.rules.view_m);
        let mut out =
            Carcass { reading, rules, glazing, areas: None, layers: None, frame: None, works: None, tiles: f64::NAN };
        if rules > 0.0 && !always {
            return out;
        }
        let survey = self.tiling.survey(house, &out.reading, &mut workspace.keys).ok();
        out.areas = survey.map(|s| s.areas);
        out.layers = survey.and_then(|survey| self.take_off(house, &out.reading, &survey, choices).ok());
        let lines = |mask: u8| self.linear.lines(cubes::Mask(mask));
        workspace.frame.options.boards = self.boards(choices);
        out.frame = frame::build_members(house, &out.reading, choices, lines, &mut workspace.frame).ok();
        if out.layers.is_some() {
            out.works = self.works(house, &out.reading, choices, out.frame.as_ref(), workspace);
            out.tiles = distinct_tiles(house, &mut workspace.ids) as f64;
        }
        out
    }

    /// Makes the bare carcass that the workspace has made last ready for its analysis.
    pub(super) fn complete(&self, house: &House, carcass: &mut Carcass, workspace: &mut Workspace) {
        let Some(frame) = &mut carcass.frame else { return };
        frame::complete(house, &mut workspace.frame, frame);
        frame.layers_n_m2 = carcass.layers.as_ref().map(|takeoff| layer_weights(house, takeoff, &self.rates, frame));
    }

    /// The carcass of a house. One that breaks rules goes no further than that unless `always`.
    pub(super) fn carcass(&self, house: &House, choices: &Choices, workspace: &mut Workspace, always: bool) -> Carcass {
        let mut out = self.bare_carcass(house, choices, workspace, always);
        self.complete(house, &mut out, workspace);
        out
    }

    /// The same from those kept, where it is among them; kept from now on.
    pub(super) fn known_carcass(&self, house: &House, choices: &Choices, workspace: &mut Workspace) -> Arc<Carcass> {
        self.carcasses.get(house, choices).unwrap_or_else(|| {
            let made = Arc::new(self.carcass(house, choices, workspace, false));
            self.carcasses.put(house, choices, &made);
            made
        })
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
}

/// Carcasses kept at most: those of a pool of parents and of some batches around it. Each is some 100 kB.
const MOST_KEPT: usize = 256;
/// Hashes remembered of carcasses that were not kept.
const MOST_GLIMPSED: usize = 256;

/// The latest carcasses.
#[derive(Default)]
pub(super) struct Carcasses(Mutex<Known>);

#[derive(Default)]
struct Known {
    kept: Vec<Kept>,
    glimpsed: VecDeque<u64>,
    clock: u64,
}

struct Kept {
    hash: u64,
    used: u64,
    house: House,
    choices: Choices,
    carcass: Arc<Carcass>,
}

impl Carcasses {
    /// The carcass of a house with these joists and boards.
    pub(super) fn get(&self, house: &House, choices: &Choices) -> Option<Arc<Carcass>> {
        let choices = without_sections(choices);
        let hash = hash(house, &choices);
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.clock += 1;
        let now = known.clock;
        let found = known.kept.iter_mut().find(|k| k.hash == hash && k.choices == choices && k.house == *house)?;
        found.used = now;
        Some(found.carcass.clone())
    }

    /// Keeps one, for the one longest unused where there are too many.
    pub(super) fn put(&self, house: &House, choices: &Choices, carcass: &Arc<Carcass>) {
        let choices = without_sections(choices);
        let hash = hash(house, &choices);
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if known.kept.iter().any(|k| k.hash == hash && k.choices == choices && k.house == *house) {
            return;
        }
        known.clock += 1;
        if known.kept.len() >= MOST_KEPT {
            let oldest = (0..known.kept.len()).min_by_key(|&i| known.kept[i].used);
            oldest.map(|at| known.kept.swap_remove(at));
        }
        let used = known.clock;
        known.kept.push(Kept { hash, used, house: house.clone(), choices, carcass: carcass.clone() });
    }

    /// Drops all of them.
    pub(super) fn clear(&self) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Known::default();
    }

    /// Whether it was asked for lately, and is worth keeping: a parent that is gone from here but still has children.
    pub(super) fn glimpse(&self, house: &House, choices: &Choices) -> bool {
        let hash = hash(house, &without_sections(choices));
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let again = known.glimpsed.contains(&hash);
        if !again {
            known.glimpsed.push_back(hash);
            if known.glimpsed.len() > MOST_GLIMPSED {
                known.glimpsed.pop_front();
            }
        }
        again
    }
}

/// Choices with the sections forgotten.
fn without_sections(choices: &Choices) -> Choices {
    let mut out = *choices;
    for group in [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof] {
        out.0[group as usize] = 0;
    }
    out
}

/// A hash of what tells carcasses apart in nearly all cases; equality decides.
fn hash(house: &House, choices: &Choices) -> u64 {
    let mut hasher = FxHasher::default();
    for chunk in house.voxels.labels().chunks(16) {
        hasher.write_u64(chunk.iter().fold(0, |word, label| word << 4 | u64::from(label.code())));
    }
    choices.0.iter().for_each(|&c| hasher.write_u16(c));
    hasher.finish()
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
