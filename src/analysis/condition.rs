//! How many digits a solve can lose: a condition number of the stiffness on demand, off the hot path.

use super::solver::Solver;

/// Steps of the estimator; Higham reports that it settles within four or five.
const STEPS: usize = 5;

impl Solver {
    /// Estimate of the condition number `|S|_1 |S^-1|_1` of the stiffness of the last solve, scaled to unit diagonal:
    /// `S = D^-1/2 K D^-1/2`. About `log10` of it are the decimal digits that displacements may lose of sixteen.
    ///
    /// `|S|_1` is exact; `|S^-1|_1` is the estimate of Hager as refined by Higham (FORTRAN codes for estimating the one-norm of a
    /// real or complex matrix, ACM Trans. Math. Softw. 14 (1988) 381-396, algorithm 4.1), a lower bound that is
    /// rarely off by more than a factor of three. Scaling to unit diagonal takes away what only the choice of units does (the
    /// mix of forces per length and moments per radian); it is within a factor `n` of the best diagonal scaling (van der Sluis,
    /// Numer. Math. 14 (1969) 14-23).
    ///
    /// `None` when the last solve left no factor (mechanism, nothing to solve).
    pub fn condition(&mut self) -> Option<f64> {
        let n = self.layout.n;
        if n == 0 || !self.factor.is_usable() {
            return None;
        }
        let root: Vec<f64> = (0..n).map(|k| self.values[self.layout.diagonal(k)].sqrt()).collect();
        if root.iter().any(|r| !(*r > 0.0 && r.is_finite())) {
            return None;
        }
        let estimate = self.norm(&root) * self.inverse_norm(&root);
        (estimate.is_finite() && estimate > 0.0).then_some(estimate)
    }

    /// Largest column sum of `|S|`.
    fn norm(&self, root: &[f64]) -> f64 {
        let absolute: Vec<f64> = self.values.iter().map(|v| v.abs()).collect();
        let inverse: Vec<f64> = root.iter().map(|r| 1.0 / r).collect();
        let mut sums = vec![0.0; root.len()];
        self.layout.multiply(&absolute, &inverse, &mut sums);
        sums.iter().zip(&inverse).map(|(s, i)| s * i).fold(0.0, f64::max)
    }

    /// `S^-1 v = D^1/2 K^-1 D^1/2 v`.
    fn apply_inverse(&mut self, root: &[f64], v: &mut [f64]) {
        v.iter_mut().zip(root).for_each(|(x, r)| *x *= r);
        self.factor.solve(v, 1);
        v.iter_mut().zip(root).for_each(|(x, r)| *x *= r);
    }

    fn inverse_norm(&mut self, root: &[f64]) -> f64 {
        let n = root.len();
        let mut v = vec![1.0 / n as f64; n];
        self.apply_inverse(root, &mut v);
        let mut estimate = sum(&v);
        let mut signs: Vec<f64> = v.iter().map(|x| x.signum()).collect();
        let mut last = usize::MAX;
        for _ in 0..STEPS {
            // S is symmetric: its inverse serves as its own transpose.
            v.copy_from_slice(&signs);
            self.apply_inverse(root, &mut v);
            let (at, _) = v.iter().enumerate().fold((0, 0.0), |b, (k, x)| if x.abs() > b.1 { (k, x.abs()) } else { b });
            if at == last {
                break;
            }
            last = at;
            v.fill(0.0);
            v[at] = 1.0;
            self.apply_inverse(root, &mut v);
            let found = sum(&v);
            let same = v.iter().zip(&signs).all(|(x, s)| x.signum() == *s);
            if same || found <= estimate {
                estimate = estimate.max(found);
                break;
            }
            estimate = found;
            signs.iter_mut().zip(&v).for_each(|(s, x)| *s = x.signum());
        }
        // A vector of alternating growth catches what the steps above miss.
        for (k, x) in v.iter_mut().enumerate() {
            let size = 1.0 + k as f64 / (n.max(2) - 1) as f64;
            *x = if k % 2 == 0 { size } else { -size };
        }
        self.apply_inverse(root, &mut v);
        estimate.max(2.0 * sum(&v) / (3.0 * n as f64))
    }
}

fn sum(v: &[f64]) -> f64 {
    v.iter().map(|x| x.abs()).sum()
}
