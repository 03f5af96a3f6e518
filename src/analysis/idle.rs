//! Rotations that nothing resists: nodes where only hinged member ends meet.

use super::element::Beam;
use super::model::Model;
use super::solution::Idle;
use nalgebra::{Matrix3, SymmetricEigen};

/// A rotation whose stiffness is below this share of the node's largest counts as none. A real one is at least the torsion of
/// a thin rod over the bending of a stout beam (1e-8); rounding leaves 1e-16.
const NO_STIFFNESS: f64 = 1e-12;

/// Finds dofs to leave out and directions to ground.
#[derive(Default)]
pub(super) struct IdleFinder {
    held: Vec<bool>,
    touched: Vec<bool>,
    turning: Vec<[[f64; 3]; 3]>,
}

/// A rotation direction to be grounded with a spring that never feels a force.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ground {
    pub node: usize,
    pub axis: [f64; 3],
    pub stiffness: f64,
}

impl IdleFinder {
    /// Clears idle dofs in `active` (which enters as "not held by a support"), lists them in `idle`, and lists oblique
    /// directions without stiffness in `grounds`.
    pub fn find(
        &mut self,
        model: &Model,
        beams: &[Beam],
        active: &mut [[bool; 6]],
        idle: &mut Vec<Idle>,
        grounds: &mut Vec<Ground>,
    ) {
        self.survey(model, beams);
        for (node, dofs) in active.iter_mut().enumerate() {
            if !self.touched[node] {
                drop_dofs(node, 0..6, dofs, idle);
            } else if !self.held[node] {
                self.hinged_node(node, dofs, idle, grounds);
            }
        }
    }

    fn survey(&mut self, model: &Model, beams: &[Beam]) {
        let n = model.nodes.len();
        self.held.clear();
        self.held.resize(n, false);
        self.touched.clear();
        self.touched.resize(n, false);
        self.turning.clear();
        self.turning.resize(n, [[0.0; 3]; 3]);
        for (member, beam) in model.members.iter().zip(beams) {
            for (e, &node) in member.nodes.iter().enumerate() {
                self.touched[node] = true;
                self.held[node] |= beam.holds_rotations(e);
            }
        }
        for (member, beam) in model.members.iter().zip(beams) {
            for (e, &node) in member.nodes.iter().enumerate() {
                if !self.held[node] {
                    let block = beam.block(e, e);
                    (0..9).for_each(|k| self.turning[node][k / 3][k % 3] += block[3 + k / 3][3 + k % 3]);
                }
            }
        }
    }

    fn hinged_node(&self, node: usize, active: &mut [bool; 6], idle: &mut Vec<Idle>, grounds: &mut Vec<Ground>) {
        let k = &self.turning[node];
        let largest = k.iter().flatten().fold(0.0f64, |m, v| m.max(v.abs()));
        if largest == 0.0 {
            drop_dofs(node, 3..6, active, idle);
            return;
        }
        // Held rotations get a stiffness of their own, so that only free directions can come out as null vectors.
        let free = |d: usize| active[3 + d];
        let m = Matrix3::from_fn(|r, c| match (free(r), free(c)) {
            (true, true) => k[r][c],
            _ if r == c => largest,
            _ => 0.0,
        });
        let eigen = SymmetricEigen::new(m);
        for e in (0..3).filter(|&e| eigen.eigenvalues[e] <= NO_STIFFNESS * largest) {
            let v = eigen.eigenvectors.column(e);
            let axis = [v[0], v[1], v[2]];
            idle.push(Idle { node, direction: [0.0, 0.0, 0.0, axis[0], axis[1], axis[2]] });
            grounds.push(Ground { node, axis, stiffness: largest });
        }
    }
}

fn drop_dofs(node: usize, dofs: std::ops::Range<usize>, active: &mut [bool; 6], idle: &mut Vec<Idle>) {
    for d in dofs {
        if !std::mem::replace(&mut active[d], false) {
            continue;
        }
        let mut direction = [0.0; 6];
        direction[d] = 1.0;
        idle.push(Idle { node, direction });
    }
}
