//! Sums of loads and reactions: a check that does not know how the frame was solved.

use houscaper::analysis::{Axes, Distribution, LoadCase, MemberLoad, Model, Solution};

/// Sums of forces and of moments about the origin.
#[derive(Clone, Copy, Default)]
pub struct Sums {
    /// Fx Fy Fz Mx My Mz.
    pub total: [f64; 6],
    /// The same of the magnitudes, forces and moments: the scale of what cancels.
    pub size: [f64; 2],
}

impl Sums {
    /// Adds a force and a moment that act at `place`.
    fn add(&mut self, place: [f64; 3], force: [f64; 3], moment: [f64; 3]) {
        let [x, y, z] = place;
        let arm = [y * force[2] - z * force[1], z * force[0] - x * force[2], x * force[1] - y * force[0]];
        for d in 0..3 {
            self.total[d] += force[d];
            self.total[3 + d] += arm[d] + moment[d];
            self.size[0] += force[d].abs();
            self.size[1] += arm[d].abs() + moment[d].abs();
        }
    }

    /// `self + factor * other`.
    pub fn add_scaled(&mut self, factor: f64, other: &Sums) {
        (0..6).for_each(|d| self.total[d] += factor * other.total[d]);
        (0..2).for_each(|k| self.size[k] += factor.abs() * other.size[k]);
    }
}

/// Largest open component of loads and reactions, as a share of all that enters its sum.
pub fn open(load: &Sums, reaction: &Sums) -> f64 {
    let share = |d: usize| {
        let size = load.size[d / 3] + reaction.size[d / 3];
        if size > 0.0 { (load.total[d] + reaction.total[d]).abs() / size } else { 0.0 }
    };
    (0..6).map(share).fold(0.0, f64::max)
}

/// All loads of a case: weight, loads on nodes, loads on members.
pub fn loads(model: &Model, solution: &Solution, case: &LoadCase) -> Sums {
    let mut sums = Sums::default();
    for (m, member) in model.members.iter().enumerate() {
        let mass = model.materials[member.material].rho * model.sections[member.section].a * solution.length(m);
        if mass > 0.0 && case.gravity != [0.0; 3] {
            let middle = along(model, solution, m, 0.5 * solution.length(m));
            sums.add(middle, case.gravity.map(|g| g * mass), [0.0; 3]);
        }
    }
    for load in &case.nodal {
        let f = load.force;
        sums.add(model.nodes[load.node], [f[0], f[1], f[2]], [f[3], f[4], f[5]]);
    }
    case.members.iter().for_each(|load| member_load(model, solution, load, &mut sums));
    sums
}

/// All reactions of a case.
pub fn reactions(model: &Model, rows: &[[f64; 6]]) -> Sums {
    let mut sums = Sums::default();
    for (place, r) in model.nodes.iter().zip(rows) {
        sums.add(*place, [r[0], r[1], r[2]], [r[3], r[4], r[5]]);
    }
    sums
}

fn along(model: &Model, solution: &Solution, member: usize, x: f64) -> [f64; 3] {
    let (start, axis) = (model.nodes[model.members[member].nodes[0]], solution.axes(member)[0]);
    [0, 1, 2].map(|d| start[d] + x * axis[d])
}

/// A linear load is its two triangles, each with its resultant at a third.
fn member_load(model: &Model, solution: &Solution, load: &MemberLoad, sums: &mut Sums) {
    let length = solution.length(load.member);
    let mut push = |x: f64, force: [f64; 3]| {
        let axes = solution.axes(load.member);
        let global = match load.axes {
            Axes::Global => force,
            Axes::Local => [0, 1, 2].map(|d| (0..3).map(|a| axes[a][d] * force[a]).sum()),
        };
        sums.add(along(model, solution, load.member, x), global, [0.0; 3]);
    };
    match load.distribution {
        Distribution::Uniform { q } => push(0.5 * length, q.map(|q| q * length)),
        Distribution::Point { p, x } => push(x, p),
        Distribution::Linear { q1, q2, x1, x2 } => {
            let half = 0.5 * (x2 - x1);
            push(x1 + (x2 - x1) / 3.0, q1.map(|q| q * half));
            push(x2 - (x2 - x1) / 3.0, q2.map(|q| q * half));
        }
    }
}
