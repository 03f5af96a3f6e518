//! Where a mesh lies on a plot.

use rayon::prelude::*;

use super::lattice::Lattice;
use super::{Given, Hull, Module};

/// How a file's coordinates become those of a plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Metres of the house for a unit of the file.
    pub scale: [f64; 3],
    /// Point of the file at the plot's low corner, at ground level (the centre of the foundation layer).
    pub origin: [f64; 3],
}

impl Placement {
    /// What is asked, else where `given` puts its lattice, else the low corner of the mesh's box at scale 1. Ground level is the mesh's
    /// lowest level: lattices whose lowest cells are centred there reach half a cell below it.
    pub fn new(
        hull: &Hull,
        scale: Option<[f64; 3]>,
        origin: Option<[f64; 3]>,
        given: Option<(&Lattice, &Given)>,
    ) -> Placement {
        let corner = |(lattice, given): (&Lattice, &Given), a: usize| {
            let map = &given.map;
            let cells = map.first[a] as f64 - 0.5 - map.offset[a] as f64 / map.size[a] as f64;
            lattice.minbound[a] + cells * lattice.unit[a]
        };
        let usual = |a: usize| match given {
            Some(given) if a < 2 => corner(given, a),
            _ => hull.bounds[0][a],
        };
        Placement {
            scale: scale.unwrap_or_else(|| given.map_or([1.0; 3], |(_, given)| given.report.scale)),
            origin: origin.unwrap_or_else(|| [0, 1, 2].map(usual)),
        }
    }

    /// The point of the file at the centre of a module; layer 0, the foundation, is centred on ground level.
    pub fn centre(&self, [x, y, z]: [usize; 3], module: &Module) -> [f64; 3] {
        let at = [x as f64 + 0.5, y as f64 + 0.5, z as f64];
        [0, 1, 2].map(|a| self.origin[a] + at[a] * module.size_m[a] / self.scale[a])
    }

    /// Which voxels of a plot above its foundation have their centre outside a hull, x fastest.
    pub fn outside(&self, hull: &Hull, [nx, ny, nz]: [usize; 3], module: &Module) -> Vec<bool> {
        let outside = |at: usize| {
            let voxel = [at % nx, at / nx % ny, at / (nx * ny)];
            voxel[2] > 0 && !hull.contains(self.centre(voxel, module))
        };
        (0..nx * ny * nz).into_par_iter().map(outside).collect()
    }
}
