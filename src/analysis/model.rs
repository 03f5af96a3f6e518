//! The frame as the solver sees it: nodes, members, sections, supports, loads. It knows no voxels, tiles or roles.

/// Linear elastic material. Any consistent units; our own frames use N, m, kg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Young's modulus.
    pub e: f64,
    /// Shear modulus.
    pub g: f64,
    /// Density; matters for gravity only.
    pub rho: f64,
}

/// Cross-section constants about the member's local axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// Area.
    pub a: f64,
    /// Second moment about local y: bending in the local x-z plane.
    pub iy: f64,
    /// Second moment about local z: bending in the local x-y plane.
    pub iz: f64,
    /// Torsion constant.
    pub j: f64,
    /// Shear area for forces along local y (Timoshenko only).
    pub asy: Option<f64>,
    /// Shear area for forces along local z (Timoshenko only).
    pub asz: Option<f64>,
}

/// A straight prismatic member from node i to node j.
///
/// Local axes, right-handed: x from i to j; v = `reference`, else global Z, else for a member within 1e-9 of vertical global -X
/// when it points up and +X when down; y = v x x, z = x x y; `roll` turns y and z about +x.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// Start and end node.
    pub nodes: [usize; 2],
    /// Index into [`Model::materials`].
    pub material: usize,
    /// Index into [`Model::sections`].
    pub section: usize,
    /// Vector that, with x, spans the local x-z plane; local z lies on its side.
    pub reference: Option<[f64; 3]>,
    /// Rotation of y and z about +x in radians.
    pub roll: f64,
    /// Released end forces at i and j, order ux uy uz rx ry rz, local axes.
    pub releases: [[bool; 6]; 2],
}

/// A supported node; `fix` in the order ux uy uz rx ry rz, global axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Support {
    /// The node.
    pub node: usize,
    /// Which of its six displacements are held.
    pub fix: [bool; 6],
}

/// A space frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Node coordinates.
    pub nodes: Vec<[f64; 3]>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Sections.
    pub sections: Vec<Section>,
    /// Members.
    pub members: Vec<Member>,
    /// Supports; nodes without one are free.
    pub supports: Vec<Support>,
    /// True: Timoshenko with `asy`, `asz`; false: Euler-Bernoulli.
    pub shear: bool,
}

/// Axes in which the components of a member load are given. Global only rotates components: loads are per unit of true length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// The member's local axes.
    Local,
    /// The global axes.
    Global,
}

/// Distribution of a member load; x are distances from end i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Constant force per length over the whole member.
    Uniform {
        /// Force per length.
        q: [f64; 3],
    },
    /// Force per length from `q1` at `x1` to `q2` at `x2`, nothing outside.
    Linear {
        /// Force per length at x1.
        q1: [f64; 3],
        /// Force per length at x2.
        q2: [f64; 3],
        /// Start.
        x1: f64,
        /// End.
        x2: f64,
    },
    /// One force.
    Point {
        /// The force.
        p: [f64; 3],
        /// Its place.
        x: f64,
    },
}

/// A load on a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberLoad {
    /// The member.
    pub member: usize,
    /// Axes of the components.
    pub axes: Axes,
    /// How it is spread.
    pub distribution: Distribution,
}

/// Force and moment on a node, global axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalLoad {
    /// The node.
    pub node: usize,
    /// Fx Fy Fz Mx My Mz.
    pub force: [f64; 6],
}

/// A prescribed displacement of a supported degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settlement {
    /// The node.
    pub node: usize,
    /// 0 to 5.
    pub dof: usize,
    /// Displacement or rotation, global.
    pub value: f64,
}

/// One load case. All cases of a frame share one factorisation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadCase {
    /// Name for reports.
    pub name: String,
    /// Acceleration on every member's mass, e.g. (0, 0, -9.81).
    pub gravity: [f64; 3],
    /// Loads on nodes.
    pub nodal: Vec<NodalLoad>,
    /// Loads on members.
    pub members: Vec<MemberLoad>,
    /// Prescribed displacements.
    pub settlements: Vec<Settlement>,
}
