//! Surfaces that follow from keys: the style that makes them, and what each key adds to areas and volume.

use super::Surface;
use crate::cubes::{CubeKey, Rule};
use crate::tiles::solids::edges::{EdgeTerms, edge_terms};
use crate::tiles::solids::{Columns, Half, SolidStyle};
use crate::tiles::{Patch, PatchClass, Shells, Style, VolumeTerm, construct_key};
use crate::voxels::Label;
use rustc_hash::FxHashMap;

/// A surface tileset without files: every key's tile is constructed from a style, with the face numbers of a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KeyedSurface {
    /// Where surfaces cross the cubes.
    pub style: Style,
    /// What tells roofs how they end.
    pub rule: Rule,
    /// What stands along roofs and decks; `None` for a bare surface without edges.
    pub edges: Option<SolidStyle>,
}

impl KeyedSurface {
    /// The pieces of surface of a key, each with what it is in a house. None for a full, empty or inadmissible key. Where solids are
    /// drawn, a window or door is one only where they are: in front of a deck, at a corner or below a roof it is wall.
    pub fn patches(&self, key: CubeKey) -> Vec<(Patch, Surface)> {
        if !key.mask().is_admissible() {
            return Vec::new();
        }
        let shells = Shells::default();
        let columns = Columns::new(key, &shells);
        construct_key(key, &self.style)
            .into_iter()
            .filter_map(|built| {
                let patch = Patch::new(built.facet)?;
                let label = match built.label {
                    label if self.edges.is_some() && label.is_infill() => drawn_label(&columns, &patch, label),
                    label => label,
                };
                let surface = Surface::of(patch.class, label);
                Some((patch, surface))
            })
            .collect()
    }
}

/// The label of a window's or door's patch, or base where the solids have a wall.
fn drawn_label(columns: &Columns, patch: &Patch, label: Label) -> Label {
    let axis = match patch.class {
        PatchClass::WallEast | PatchClass::WallWest => 0,
        PatchClass::WallNorth | PatchClass::WallSouth => 1,
        PatchClass::RoofLevel | PatchClass::RoofInclined | PatchClass::Deck | PatchClass::Soffit => return label,
    };
    let half = if patch.octant >= 4 { Half::Upper } else { Half::Lower };
    columns.infill(usize::from(patch.octant & 3), axis, half).unwrap_or(Label::Base)
}

/// What areas are summed in: the ten surfaces, then windows and doors by the direction they face.
pub(super) const WINDOWS: usize = Surface::ALL.len();
pub(super) const DOORS: usize = WINDOWS + 4;
/// Then overhang, gutter, parapet, coping and railing.
pub(super) const EDGES: usize = DOORS + 4;
pub(super) const SLOTS: usize = EDGES + 5;

/// The slot of an opening's area in its direction.
fn facing_slot(class: PatchClass, surface: Surface) -> Option<usize> {
    let facing = class.facing()? as usize;
    match surface {
        Surface::Window => Some(WINDOWS + facing),
        Surface::Door => Some(DOORS + facing),
        Surface::Wall
        | Surface::Band
        | Surface::Plinth
        | Surface::PitchedRoof
        | Surface::FlatRoof
        | Surface::Deck
        | Surface::Soffit
        | Surface::Ground => None,
    }
}

/// A key's part in a survey, and how often the survey under way has met it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// The key.
    pub key: CubeKey,
    /// First and last of its terms.
    pub terms: [u32; 2],
    /// Its part in the volume.
    pub volume: VolumeTerm,
    /// Whether a tile exists for it, or none is needed because it is full.
    pub allowed: bool,
    /// Cubes met.
    pub count: u32,
    /// Sum of their levels in the padded array.
    pub levels: u64,
}

/// What a caller keeps between surveys: the terms of every key met so far. Belongs to one surface at one module size and is emptied
/// when asked for another.
#[derive(Clone, Debug, Default)]
pub struct KeyCache {
    made_for: Option<(KeyedSurface, [f64; 3])>,
    index: FxHashMap<CubeKey, u32>,
    pub(super) entries: Vec<Entry>,
    pub(super) terms: Vec<(u8, f64)>,
    /// Entries met by the survey under way, in the order of first meeting.
    pub(super) met: Vec<u32>,
}

impl KeyCache {
    /// Number of keys known.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether no key is known.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The keys of the house surveyed last and how many cubes have each, in the order of first meeting.
    pub fn counts(&self) -> impl Iterator<Item = (CubeKey, u32)> + '_ {
        self.met.iter().map(|&n| &self.entries[n as usize]).map(|entry| (entry.key, entry.count))
    }

    /// Makes ready for a surface drawn at a scale.
    pub(super) fn prepare(&mut self, surface: &KeyedSurface, scale: [f64; 3]) {
        if self.made_for != Some((*surface, scale)) {
            *self = KeyCache { made_for: Some((*surface, scale)), ..KeyCache::default() };
        }
        for n in self.met.drain(..) {
            let entry = &mut self.entries[n as usize];
            (entry.count, entry.levels) = (0, 0);
        }
    }

    /// The entry of a key, made on first sight.
    #[inline]
    pub(super) fn entry(&mut self, key: CubeKey) -> u32 {
        match self.index.get(&key) {
            Some(&n) => n,
            None => self.learn(key),
        }
    }

    #[cold]
    fn learn(&mut self, key: CubeKey) -> u32 {
        let first = self.terms.len() as u32;
        let mut volume = VolumeTerm::default();
        if let Some((surface, scale)) = self.made_for {
            let mut areas = [0.0; SLOTS];
            for (patch, what) in surface.patches(key) {
                let area = patch.area_m2(scale);
                areas[what as usize] += area;
                if let Some(slot) = facing_slot(patch.class, what) {
                    areas[slot] += area;
                }
                volume.doubled_plan_mm2 += patch.doubled_area_mm2[2];
                volume.moment_mm3 += patch.moment_mm3;
            }
            if let Some(style) = &surface.edges {
                let bare = Shells::default();
                let edges = edge_terms(&Columns::new(key, &bare), style, scale);
                let EdgeTerms { overhang_m2, gutter_m, parapet_m2, coping_m, railing_m } = edges;
                areas[EDGES..].copy_from_slice(&[overhang_m2, gutter_m, parapet_m2, coping_m, railing_m]);
            }
            let terms = areas.into_iter().enumerate().filter(|(_, area)| *area > 0.0);
            self.terms.extend(terms.map(|(slot, area)| (slot as u8, area)));
        }
        let n = self.entries.len() as u32;
        let terms = [first, self.terms.len() as u32];
        let allowed = key.mask().is_allowed();
        self.entries.push(Entry { key, terms, volume, allowed, count: 0, levels: 0 });
        self.index.insert(key, n);
        n
    }
}
