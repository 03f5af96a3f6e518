//! Linear static analysis of space frames: 3D beams, six degrees of freedom a node, one sparse Cholesky factor for all cases.

mod model;

pub use model::{
    Axes, Distribution, LoadCase, Material, Member, MemberLoad, Model, NodalLoad, Section, Settlement, Support,
};
