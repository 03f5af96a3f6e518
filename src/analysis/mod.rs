//! Linear static analysis of space frames: 3D beams, six degrees of freedom a node, one sparse Cholesky factor for all cases.
//!
//! `K u = f` with Euler-Bernoulli or Timoshenko members, end releases condensed, held dofs dropped. A frame that moves without
//! resistance is no error but a status that names the nodes and directions; displacements of a mechanism are never reported.
//! First order, linear elastic; no voxels, tiles or roles.

mod axes;
mod condition;
mod diagnose;
mod element;
mod error;
mod factor;
pub mod file;
mod fixed_end;
mod idle;
mod judge;
mod layout;
mod line;
mod loads;
mod mechanism;
mod model;
mod phases;
mod recover;
mod sides;
mod solution;
mod solver;

pub use axes::{Axes3, local_axes};
pub use element::member_stiffness;
pub use error::InputError;
pub use line::{Extremes, Line, member_forces};
pub use mechanism::{Cause, Mechanism, Motion};
pub use model::{
    Axes, Distribution, LoadCase, Material, Member, MemberLoad, Model, NodalLoad, Section, Settlement, Support,
};
pub use phases::{Phases, Size};
pub use solution::{Idle, Solution, Status};
pub use solver::{MECHANISM_LIMIT, RESIDUAL_LIMIT, SINGULAR_LIMIT, Solver, solve};
