//! Linear static analysis of space frames: 3D beams, six degrees of freedom a node, one sparse Cholesky factor for all cases.
//!
//! `K u = f` with Euler-Bernoulli or Timoshenko members, end releases condensed, held dofs dropped. A frame that moves without
//! resistance is no error but a status that names the nodes and directions; displacements of a mechanism are never reported.
//! First order, linear elastic; no voxels, tiles or roles.
//!
//! # Speed and memory
//! Build to end forces under six cases, one core, process CPU time (least of many, on a busy machine): a box house of 512 nodes
//! 3.4 ms, of 1,725 nodes 26 ms, of 7,489 nodes 215 ms; platform framing of 184 nodes 0.6 ms, of 396 nodes 1.9 ms. OpenSees in
//! the same run on the first: 64 to 69 ms with results, PyNite 2,650 to 3,310 ms. `cargo bench --bench analysis` and
//! tests/tools/opensees_speed.py measure it again. Stiffness, pattern, factor and right-hand sides take 740 to 1,000 bytes an
//! unknown in platform framing, 1,300 to 2,500 in the box houses (`Solver::size`).
//!
//! What was tried and lost, or does not pay:
//! - No merging of supernodes: 10 % more time in houses of 190 to 400 nodes and in the box of 512. Merging only to 12 or 18
//!   columns with small shares: 3 to 8 % more. Merging far more (24 columns at 0.6, then 0.1) is as quick on houses and 5 % slower
//!   on the box of 512.
//! - Looking for mechanisms by the smallest pivot alone costs nothing and misses some: one more right-hand side, a random
//!   load, costs 0.7 % of the instructions and finds them.
//! - Eliminating released ends in the member's stiffness loses up to ten digits when shear makes a short member soft; the closed
//!   form takes as long.

mod axes;
mod buckling;
mod condition;
mod diagnose;
mod element;
mod error;
mod factor;
pub mod file;
mod fixed_end;
mod idle;
mod judge;
mod lanczos;
mod layout;
mod line;
mod loads;
mod mechanism;
mod model;
mod moved;
mod phases;
mod recover;
mod sides;
mod solution;
mod solver;
mod tree;

pub use axes::{Axes3, local_axes};
pub use buckling::{BUCKLING_PIECES, Buckler, Buckling, BucklingAnswer, buckling_factor};
pub use element::member_stiffness;
pub use error::InputError;
pub use line::{Extremes, Line, member_forces};
pub use mechanism::{Cause, Mechanism, Motion};
pub use model::{
    Axes, Distribution, LoadCase, Material, Member, MemberLoad, Model, NodalLoad, Section, Settlement, Support,
};
pub use moved::displacement_along;
pub use phases::{Phases, Size};
pub use solution::{Idle, Solution, Status};
pub use solver::{MECHANISM_LIMIT, RESIDUAL_LIMIT, SINGULAR_LIMIT, Solver, solve};
