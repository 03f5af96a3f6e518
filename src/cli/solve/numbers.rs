//! Results by node and member, for cases and for their combinations.

use super::balance::{self, Sums};
use houscaper::analysis::file::FrameFile;
use houscaper::analysis::{LoadCase, Solution};

/// One case or combination.
pub struct Numbers {
    /// Its name.
    pub name: String,
    /// Factor of each case; a case itself has 1 at its own place.
    pub factors: Vec<f64>,
    /// Whether it is a combination.
    pub combined: bool,
    /// Displacements by node: ux uy uz rx ry rz.
    pub disp: Vec<[f64; 6]>,
    /// Reactions by node; zero where nothing is supported.
    pub reac: Vec<[f64; 6]>,
    /// End forces by member: at i, then at j, local axes.
    pub endf: Vec<[f64; 12]>,
    /// Sums of the loads.
    pub load: Sums,
    /// Sums of the reactions.
    pub reaction: Sums,
}

impl Numbers {
    /// Largest open component of loads and reactions, relative.
    pub fn out_of_balance(&self) -> f64 {
        balance::open(&self.load, &self.reaction)
    }
}

/// Every case, then every combination.
pub fn all(file: &FrameFile, solution: &Solution) -> Vec<Numbers> {
    let mut all: Vec<Numbers> =
        file.cases.iter().enumerate().map(|(c, case)| of_case(file, solution, c, case)).collect();
    let combined: Vec<Numbers> =
        file.combinations.iter().map(|c| combine(file, &c.name, &c.factors, &all[..file.cases.len()])).collect();
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
        factors: (0..file.cases.len()).map(|k| if k == c { 1.0 } else { 0.0 }).collect(),
        combined: false,
        disp: solution.displacements(c).to_vec(),
        reaction: balance::reactions(&file.model, &reac),
        reac,
        endf: solution.end_forces(c).to_vec(),
        load: balance::loads(&file.model, solution, case),
    }
}

fn combine(file: &FrameFile, name: &str, factors: &[f64], cases: &[Numbers]) -> Numbers {
    let parts = || factors.iter().copied().zip(cases);
    let mut load = Sums::default();
    parts().for_each(|(f, n)| load.add_scaled(f, &n.load));
    let reac = sum(parts().map(|(f, n)| (f, n.reac.as_slice())));
    Numbers {
        name: name.to_owned(),
        factors: factors.to_vec(),
        combined: true,
        disp: sum(parts().map(|(f, n)| (f, n.disp.as_slice()))),
        reaction: balance::reactions(&file.model, &reac),
        reac,
        endf: sum(parts().map(|(f, n)| (f, n.endf.as_slice()))),
        load,
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
