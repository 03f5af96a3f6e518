//! Improving a house: the neighbourhood of one design, with voxels that stay as they are.
//!
//! [`Around`] is a [`Domain`] whose starts are a few moves from one design, and whose hard rules include the locked voxels; any
//! searcher explores it. What is near counts by [`changes`], which a caller adds to the objectives, so that the front goes from small
//! changes to large ones.

use super::domain::{Arm, Domain};
use super::houses::Houses;
use super::massing::Design;
use crate::voxels::{House, Label, VoxelArray};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// What the tally of a search says of a child that changes a locked voxel.
pub const LOCK: &str = "lock";

/// Most moves between the design and a start of its neighbourhood.
const WALK: usize = 4;

/// Voxels that keep their label.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Locked {
    voxels: Vec<([usize; 3], Label)>,
}

impl Locked {
    /// Locks the voxels of a house that `locks` names, empty ones too.
    pub fn new(house: &House, locks: impl Fn([usize; 3]) -> bool) -> Locked {
        Locked { voxels: house.voxels.iter().filter(|(v, _)| locks(*v)).collect() }
    }

    /// Number of locked voxels.
    pub fn len(&self) -> usize {
        self.voxels.len()
    }

    /// Whether nothing is locked.
    pub fn is_empty(&self) -> bool {
        self.voxels.is_empty()
    }

    /// The first locked voxel that another house has changed.
    pub fn broken(&self, house: &House) -> Option<[usize; 3]> {
        let differs = |(v, label): &&([usize; 3], Label)| house.voxels.at(v.map(|c| c as isize)) != *label;
        self.voxels.iter().find(differs).map(|(v, _)| *v)
    }
}

/// Voxels whose labels differ between two arrays with the same first voxel, beyond their shapes too: position, before, after.
pub fn changes(before: &VoxelArray, after: &VoxelArray) -> Vec<([usize; 3], Label, Label)> {
    let (a, b) = (before.shape(), after.shape());
    let [nx, ny, nz] = [0, 1, 2].map(|i| a[i].max(b[i]));
    let mut out = Vec::new();
    for (z, y, x) in (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| (z, y, x)))) {
        let [old, new] = [before, after].map(|array| array.at([x as isize, y as isize, z as isize]));
        if old != new {
            out.push(([x, y, z], old, new));
        }
    }
    out
}

/// The houses around one design.
#[derive(Clone)]
pub struct Around<'a> {
    /// The operators and rules.
    pub houses: Houses<'a>,
    /// Where the search begins.
    pub design: &'a Design,
    /// What stays.
    pub locked: &'a Locked,
}

impl Domain for Around<'_> {
    type Genome = Design;
    type Form = House;

    fn arms(&self) -> &[Arm] {
        self.houses.arms()
    }

    /// The design itself, or what a few moves make of it.
    fn start(&self, rng: &mut ChaCha8Rng) -> Option<Design> {
        let moves: Vec<usize> = (0..self.arms().len()).filter(|&i| self.arms()[i].parents == 1).collect();
        let mut out = self.design.clone();
        for _ in 0..rng.random_range(0..=WALK) {
            let arm = super::evolution::draw_arm(self.arms(), 1, rng).unwrap_or(*moves.first()?);
            out = self.houses.vary(arm, [&out, &out], rng).unwrap_or(out);
        }
        Some(out)
    }

    fn vary(&self, arm: usize, parents: [&Design; 2], rng: &mut ChaCha8Rng) -> Option<Design> {
        self.houses.vary(arm, parents, rng)
    }

    fn express(&self, genome: &Design) -> House {
        self.houses.express(genome)
    }

    /// The place on the plot counts: a house that was only moved is another one to somebody who keeps a neighbour's wall.
    fn key(&self, genome: &Design, form: &House) -> u128 {
        let corner = form.voxels.labels().iter().position(|l| l.is_filled()).unwrap_or(0);
        self.houses.key(genome, form) ^ ((corner as u128) << 64).wrapping_mul(0x9e37_79b9_7f4a_7c15)
    }

    fn broken_rule(&self, form: &House) -> Option<&'static str> {
        if self.locked.broken(form).is_some() { Some(LOCK) } else { self.houses.broken_rule(form) }
    }

    fn goals(&self) -> usize {
        self.houses.goals()
    }

    fn polish(&self, genome: &Design, form: &House, goal: usize) -> Option<Design> {
        self.houses.polish(genome, form, goal)
    }
}
