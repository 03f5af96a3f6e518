//! What a solve leaves: status, displacements, reactions, end forces.

use super::axes::Axes3;
use super::fixed_end::SpanLoad;
use super::mechanism::Mechanism;

/// Outcome of a solve. Only [`Status::Solved`] numbers may be used for a verdict.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Status {
    /// Nothing solved yet.
    #[default]
    Empty,
    /// In equilibrium.
    Solved {
        /// Largest unbalanced force (moment) at a free dof over the largest end force (moment) of its case; at most
        /// [`super::RESIDUAL_LIMIT`].
        residual: f64,
        /// Smallest pivot over its diagonal: an optimistic hint at the conditioning.
        least_pivot: f64,
    },
    /// Numbers exist, but too many digits are lost to call them a result.
    NearlySingular {
        /// Estimated condition of the stiffness matrix scaled to unit diagonal.
        condition: f64,
        /// As in [`Status::Solved`].
        residual: f64,
        /// The motion that is almost free.
        weakest: Mechanism,
    },
    /// A mechanism: no displacements exist (all numbers are zero).
    Unstable(Mechanism),
}

impl Status {
    /// True for [`Status::Solved`].
    pub fn is_solved(&self) -> bool {
        matches!(self, Status::Solved { .. })
    }
}

/// A rotation (or a whole node) that nothing resists and nothing loads, taken out of the system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Idle {
    /// The node.
    pub node: usize,
    /// ux uy uz rx ry rz, global, unit vector.
    pub direction: [f64; 6],
}

/// A load inside a member, beside its uniform share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placed {
    pub member: u32,
    pub case: u32,
    pub load: SpanLoad,
}

/// Displacements, reactions and end forces of all cases of one frame. Buffers are kept when the value is used again.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solution {
    /// Outcome.
    pub status: Status,
    /// Directions without stiffness and load that were taken out.
    pub idle: Vec<Idle>,
    pub(super) cases: usize,
    pub(super) nodes: usize,
    pub(super) members: usize,
    pub(super) supports: usize,
    /// `[case][node]`.
    pub(super) displacements: Vec<[f64; 6]>,
    /// `[case][support]`.
    pub(super) reactions: Vec<[f64; 6]>,
    /// `[case][member]`.
    pub(super) end_forces: Vec<[f64; 12]>,
    /// `[case][member]`, uniform load in local axes, gravity included.
    pub(super) uniform: Vec<[f64; 3]>,
    /// Other member loads, by member, then case.
    pub(super) placed: Vec<Placed>,
    /// `[member]`.
    pub(super) spans: Vec<Span>,
}

/// What the forces along a member need to know of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    pub axes: Axes3,
    pub length: f64,
    /// E Iy, E Iz.
    pub bending: [f64; 2],
    /// 1 / (G Asy), 1 / (G Asz); 0 without shear.
    pub shear: [f64; 2],
}

impl Solution {
    /// Number of load cases.
    pub fn case_count(&self) -> usize {
        self.cases
    }

    /// Number of nodes.
    pub fn node_count(&self) -> usize {
        self.nodes
    }

    /// Number of members.
    pub fn member_count(&self) -> usize {
        self.members
    }

    /// Displacements of all nodes in `case`: ux uy uz rx ry rz, global.
    pub fn displacements(&self, case: usize) -> &[[f64; 6]] {
        &self.displacements[case * self.nodes..(case + 1) * self.nodes]
    }

    /// Reactions in `case` in the order of [`super::Model::supports`]: support on structure, global, nodal loads at the support
    /// subtracted; zero in free dofs.
    pub fn reactions(&self, case: usize) -> &[[f64; 6]] {
        &self.reactions[case * self.supports..(case + 1) * self.supports]
    }

    /// End forces of all members in `case`: on the member at i, then j, local axes; Fx at i > 0 is compression.
    pub fn end_forces(&self, case: usize) -> &[[f64; 12]] {
        &self.end_forces[case * self.members..(case + 1) * self.members]
    }

    /// Uniform loads on all members in `case`, local axes, force per length, gravity included; other loads are not in it.
    pub fn uniform_loads(&self, case: usize) -> &[[f64; 3]] {
        &self.uniform[case * self.members..(case + 1) * self.members]
    }

    /// Local axes (rows x, y, z) of a member.
    pub fn axes(&self, member: usize) -> &Axes3 {
        &self.spans[member].axes
    }

    /// Length of a member.
    pub fn length(&self, member: usize) -> f64 {
        self.spans[member].length
    }

    pub(super) fn placed_on(&self, member: usize) -> &[Placed] {
        let begin = self.placed.partition_point(|p| (p.member as usize) < member);
        let count = self.placed[begin..].partition_point(|p| p.member as usize == member);
        &self.placed[begin..begin + count]
    }
}

impl Solution {
    /// Shapes all tables for `model` and `cases` with zeros.
    pub(super) fn reset(&mut self, model: &super::model::Model, cases: usize) {
        (self.cases, self.nodes) = (cases, model.nodes.len());
        (self.members, self.supports) = (model.members.len(), model.supports.len());
        self.idle.clear();
        self.placed.clear();
        self.spans.clear();
        self.uniform.clear();
        self.uniform.resize(cases * self.members, [0.0; 3]);
        self.clear_numbers();
    }

    /// Zeros in place of results.
    pub(super) fn clear_numbers(&mut self) {
        let (cases, nodes, members, supports) = (self.cases, self.nodes, self.members, self.supports);
        self.displacements.clear();
        self.displacements.resize(cases * nodes, [0.0; 6]);
        self.reactions.clear();
        self.reactions.resize(cases * supports, [0.0; 6]);
        self.end_forces.clear();
        self.end_forces.resize(cases * members, [0.0; 12]);
    }
}
