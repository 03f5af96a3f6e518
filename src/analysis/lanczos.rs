//! The largest eigenvalue of `G v = value K v` by Lanczos steps on the factor of `K`.

use super::factor::Factor;
use super::layout::Layout;
use nalgebra::{DMatrix, SymmetricEigen};

/// Most steps; frames settle in 15 to 60.
const STEPS: usize = 200;
/// The eigenvalue is settled when the rest of its pair is below this share of the largest; the value is then right to about
/// the square of it.
const SETTLED: f64 = 1e-6;

/// An eigenpair.
pub(super) struct Found {
    /// The eigenvalue of largest sign-respecting value; zero when none is positive.
    pub value: f64,
    /// Its vector.
    pub vector: Vec<f64>,
    /// Steps taken.
    pub steps: usize,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Largest eigenvalue of `K^-1 G`, with full reorthogonalisation in the energy product of `K`; `None` when it did not settle.
/// `stiffness`, `geometric`: values in the pattern of `layout`; `factor`: that of `stiffness`.
pub(super) fn largest(layout: &Layout, factor: &mut Factor, stiffness: &[f64], geometric: &[f64]) -> Option<Found> {
    let n = layout.n;
    let (mut basis, mut energy): (Vec<Vec<f64>>, Vec<Vec<f64>>) = (Vec::new(), Vec::new());
    let (mut alpha, mut beta): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    // The answer to a load without symmetry: every motion that a load can set off has a part in it.
    let mut v: Vec<f64> = (0..n).map(|k| ((k as f64 + 1.0) * 0.618_033_988_749_894_9).fract() - 0.5).collect();
    (0..n).for_each(|k| v[k] *= stiffness[layout.diagonal(k)].max(0.0).sqrt());
    factor.solve(&mut v, 1);
    for step in 0..STEPS.min(n) {
        let mut kv = vec![0.0; n];
        layout.multiply(stiffness, &v, &mut kv);
        let size = dot(&v, &kv).sqrt();
        if !(size.is_finite() && size > 0.0) {
            return None;
        }
        v.iter_mut().for_each(|x| *x /= size);
        kv.iter_mut().for_each(|x| *x /= size);
        let mut w = vec![0.0; n];
        layout.multiply(geometric, &v, &mut w);
        alpha.push(dot(&v, &w));
        factor.solve(&mut w, 1);
        basis.push(v);
        energy.push(kv);
        // Twice is enough (Parlett, The Symmetric Eigenvalue Problem, section 6.9).
        for _ in 0..2 {
            for (b, kb) in basis.iter().zip(&energy) {
                let part = dot(&w, kb);
                w.iter_mut().zip(b).for_each(|(x, y)| *x -= part * y);
            }
        }
        let mut kw = vec![0.0; n];
        layout.multiply(stiffness, &w, &mut kw);
        let rest = dot(&w, &kw).max(0.0).sqrt();
        let done = step + 1 == STEPS.min(n) || rest == 0.0;
        if step % 5 == 4 || done {
            let (value, weights, scale) = ritz(&alpha, &beta);
            let open = rest * weights.last().map_or(0.0, |w| w.abs());
            // A space that is used up holds the answer exactly.
            if open <= SETTLED * value.abs() || rest <= 1e-13 * scale || (value <= 1e-12 * scale && step > 60) {
                let mut vector = vec![0.0; n];
                for (weight, b) in weights.iter().zip(&basis) {
                    vector.iter_mut().zip(b).for_each(|(x, y)| *x += weight * y);
                }
                let value = if value > 1e-12 * scale { value } else { 0.0 };
                return Some(Found { value, vector, steps: step + 1 });
            }
        }
        beta.push(rest);
        v = w;
    }
    None
}

/// Largest eigenvalue of the tridiagonal matrix, its vector, and the largest magnitude of all.
fn ritz(alpha: &[f64], beta: &[f64]) -> (f64, Vec<f64>, f64) {
    let m = alpha.len();
    let t = DMatrix::from_fn(m, m, |r, c| match r.abs_diff(c) {
        0 => alpha[r],
        1 => beta[r.min(c)],
        _ => 0.0,
    });
    let eigen = SymmetricEigen::new(t);
    let at = (0..m).max_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b])).unwrap_or(0);
    let scale = eigen.eigenvalues.iter().fold(0.0f64, |s, v| s.max(v.abs()));
    (eigen.eigenvalues[at], eigen.eigenvectors.column(at).iter().copied().collect(), scale)
}
