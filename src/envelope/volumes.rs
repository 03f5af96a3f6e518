//! Volumes of components without placing a block: the keys of a house are counted, and what each key holds is summed once.

use std::ops::AddAssign;

use rustc_hash::FxHashMap;

use super::{CUBE_UM, Fabric, KeyCache};
use crate::cubes::CubeKey;
use crate::tiles::{Block, Component};
use crate::voxels::VoxelArray;

/// Volume of a house's module over that of the cubes for which blocks are made; exactly 1 where they agree.
pub fn stretch(voxels: &VoxelArray) -> f64 {
    let along = |a: usize| match voxels.module.size_m[a] / (CUBE_UM[a] as f64 * 1e-6) {
        s if (s - 1.0).abs() < 1e-9 => 1.0,
        s => s,
    };
    (0..3).map(along).product()
}

/// Volume of every component, exact: six times the volume in µm3, before any stretch to another module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Volumes([i128; Component::COUNT]);

impl Default for Volumes {
    fn default() -> Self {
        Volumes([0; Component::COUNT])
    }
}

impl Volumes {
    /// What some blocks hold.
    pub fn of_blocks<'a>(blocks: impl IntoIterator<Item = &'a Block>) -> Volumes {
        let mut sums = Volumes::default();
        blocks.into_iter().for_each(|b| sums.0[b.component as usize] += b.six_volumes());
        sums
    }

    /// What a fabric holds, stairs included: the slower way, for houses whose tiles do not follow from keys alone.
    pub fn of_fabric(fabric: &Fabric) -> Volumes {
        let mut sums = Volumes::default();
        sums.0.iter_mut().zip(fabric.six_volumes()).for_each(|(sum, six)| *sum = six);
        sums
    }

    /// Six times the volume of a component, µm3.
    pub fn six(&self, component: Component) -> i128 {
        self.0[component as usize]
    }

    /// Six times the volumes in the order of [`Component::ALL`], µm3.
    pub fn all_six(&self) -> &[i128] {
        &self.0
    }

    /// Volume of a component in m3; `stretch` is the house's module over the blocks' own, as a product of the three axes.
    pub fn m3(&self, component: Component, stretch: f64) -> f64 {
        self.six(component) as f64 / 6e18 * stretch
    }
}

impl AddAssign for Volumes {
    fn add_assign(&mut self, other: Volumes) {
        self.0.iter_mut().zip(other.0).for_each(|(sum, v)| *sum += v);
    }
}

/// Volumes of a house: what follows from its cubes, and its stairs, which belong to none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HouseVolumes {
    /// Everything in the cubes.
    pub cubes: Volumes,
    /// Flights, landings and the railings of stairs.
    pub stairs: Volumes,
}

impl HouseVolumes {
    /// Cubes and stairs.
    pub fn total(&self) -> Volumes {
        let mut sum = self.cubes;
        sum += self.stairs;
        sum
    }
}

/// What each key holds of each component. Belongs to one style and one set of shells, and fills as keys are met.
#[derive(Clone, Debug, Default)]
pub struct VolumeTable {
    /// First and last term of each key.
    index: FxHashMap<CubeKey, [u32; 2]>,
    /// Six times the volumes in µm3, components that a key does not hold left out.
    terms: Vec<(Component, i128)>,
}

impl VolumeTable {
    /// Number of keys known.
    pub fn len(&self) -> usize {
        self.index.len()
    }

    /// Whether no key is known.
    pub fn is_empty(&self) -> bool {
        self.index.is_empty()
    }

    /// Volumes of the house that `survey` has surveyed last: for each key its number of cubes times what the key holds, in integers.
    /// `volumes` makes a key's own volumes and is asked once for each key; with all keys known nothing is allocated.
    pub fn sum(&mut self, survey: &KeyCache, mut volumes: impl FnMut(CubeKey) -> Volumes) -> Volumes {
        let mut sums = Volumes::default();
        for (key, count) in survey.counts() {
            let [first, last] = match self.index.get(&key) {
                Some(&terms) => terms,
                None => self.learn(key, volumes(key)),
            };
            for &(component, six) in &self.terms[first as usize..last as usize] {
                sums.0[component as usize] += six * i128::from(count);
            }
        }
        sums
    }

    #[cold]
    fn learn(&mut self, key: CubeKey, volumes: Volumes) -> [u32; 2] {
        let first = self.terms.len() as u32;
        let held = Component::ALL.iter().zip(volumes.0).filter(|(_, six)| *six != 0);
        self.terms.extend(held.map(|(component, six)| (*component, six)));
        let terms = [first, self.terms.len() as u32];
        self.index.insert(key, terms);
        terms
    }
}
