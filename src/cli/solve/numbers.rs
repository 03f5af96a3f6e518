//! Results by node and member, for cases and for their combinations.

use houscaper::analysis::file::FrameFile;
use houscaper::analysis::{Axes, Distribution, LoadCase, MemberLoad, Model, Solution};

/// One case or combination.
pub struct Numbers {
    /// Its name.
    pub name: String,
    /// Displacements by node: ux uy uz rx ry rz.
    pub disp: Vec<[f64; 6]>,
    /// Reactions by node; zero where nothing is supported.
    pub reac: Vec<[f64; 6]>,
    /// End forces by member: at i, then at j, local axes.
    pub endf: Vec<[f64; 12]>,
    /// Sum of the loads along x, y, z.
    pub load: [f64; 3],
}

impl Numbers {
    /// Sum of the reactions along x, y, z.
    pub fn reaction(&self) -> [f64; 3] {
        self.reac.iter().fold([0.0; 3], |sum, r| [0, 1, 2].map(|d| sum[d] + r[d]))
    }
}

/// Every case, then every combination.
pub fn all(file: &FrameFile, solution: &Solution) -> Vec<Numbers> {
    let mut all: Vec<Numbers> =
        file.cases.iter().enumerate().map(|(c, case)| of_case(file, solution, c, case)).collect();
    let combined: Vec<Numbers> = file.combinations.iter().map(|c| combine(&c.name, &c.factors, &all)).collect();
    all.extend(combined);
    all
}

fn of_case(file: &FrameFile, solution: &Solution, c: usize, case: &LoadCase) -> Numbers {
    let mut reac = vec![[0.0; 6]; file.model.nodes.len()];
    for (support, reaction) in file.model.supports.iter().zip(solution.reactions(c)) {
        reac[support.node] = *reaction;
    }
    Numbers {
        name: case.name.clone(),
        disp: solution.displacements(c).to_vec(),
        reac,
        endf: solution.end_forces(c).to_vec(),
        load: total_load(&file.model, solution, case),
    }
}

fn combine(name: &str, factors: &[f64], cases: &[Numbers]) -> Numbers {
    let parts = || factors.iter().copied().zip(cases);
    Numbers {
        name: name.to_owned(),
        disp: sum(parts().map(|(f, n)| (f, n.disp.as_slice()))),
        reac: sum(parts().map(|(f, n)| (f, n.reac.as_slice()))),
        endf: sum(parts().map(|(f, n)| (f, n.endf.as_slice()))),
        load: parts().fold([0.0; 3], |sum, (f, n)| [0, 1, 2].map(|d| sum[d] + f * n.load[d])),
    }
}

/// Rows of all parts, each times its factor, added up.
fn sum<'a, const N: usize>(parts: impl Iterator<Item = (f64, &'a [[f64; N]])>) -> Vec<[f64; N]> {
    let mut total: Vec<[f64; N]> = Vec::new();
    for (factor, rows) in parts {
        total.resize(rows.len(), [0.0; N]);
        for (to, from) in total.iter_mut().zip(rows) {
            (0..N).for_each(|k| to[k] += factor * from[k]);
        }
    }
    total
}

/// All forces of a case along the global axes: weight, loads on nodes, loads on members.
fn total_load(model: &Model, solution: &Solution, case: &LoadCase) -> [f64; 3] {
    let mut total = [0.0; 3];
    let mut add = |force: [f64; 3]| (0..3).for_each(|d| total[d] += force[d]);
    for (m, member) in model.members.iter().enumerate() {
        let mass = model.materials[member.material].rho * model.sections[member.section].a * solution.length(m);
        add(case.gravity.map(|g| g * mass));
    }
    for load in &case.nodal {
        add([load.force[0], load.force[1], load.force[2]]);
    }
    for load in &case.members {
        add(member_load(solution, load));
    }
    total
}

fn member_load(solution: &Solution, load: &MemberLoad) -> [f64; 3] {
    let force = match load.distribution {
        Distribution::Uniform { q } => q.map(|q| q * solution.length(load.member)),
        Distribution::Linear { q1, q2, x1, x2 } => [0, 1, 2].map(|d| 0.5 * (q1[d] + q2[d]) * (x2 - x1)),
        Distribution::Point { p, .. } => p,
    };
    match load.axes {
        Axes::Global => force,
        Axes::Local => {
            let axes = solution.axes(load.member);
            [0, 1, 2].map(|d| (0..3).map(|a| axes[a][d] * force[a]).sum())
        }
    }
}
