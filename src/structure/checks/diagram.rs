//! Moment diagrams of a member and the factors that come from their form.

/// Moments along a member: two end moments and a parabola from a uniform load, `M(x) = (1 - x) start + x end + 4 x (1 - x) sag`
/// with x from 0 to 1. N m; one sign for one edge in compression.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Diagram {
    /// Moment at the start.
    pub start: f64,
    /// Moment at the end.
    pub end: f64,
    /// Moment of the uniform load on a simple span, q l^2 / 8.
    pub sag: f64,
}

impl Diagram {
    /// The moment at `x`, a share of the length.
    pub fn at(&self, x: f64) -> f64 {
        (1.0 - x) * self.start + x * self.end + 4.0 * x * (1.0 - x) * self.sag
    }

    /// Where the slope vanishes inside the span.
    pub fn turning(&self) -> Option<f64> {
        let x = 0.5 + (self.end - self.start) / (8.0 * self.sag);
        (self.sag != 0.0 && x > 0.0 && x < 1.0).then_some(x)
    }

    /// Largest and smallest moment.
    pub fn range(&self) -> [f64; 2] {
        let turn = self.turning().map_or(self.start, |x| self.at(x));
        [self.start.max(self.end).max(turn), self.start.min(self.end).min(turn)]
    }

    /// Largest magnitude.
    pub fn peak(&self) -> f64 {
        let [high, low] = self.range();
        high.max(-low)
    }

    /// Slope times the length at the start and the end: shear forces times the length.
    pub fn slopes(&self) -> [f64; 2] {
        let d = self.end - self.start;
        [d + 4.0 * self.sag, d - 4.0 * self.sag]
    }

    /// C1 of the critical moment for any form, ends free to turn and to warp: sqrt(35 M^2 / (M^2 + 9 M1/4^2 + 16 M1/2^2 + 9 M3/4^2)),
    /// Lopez, Yong and Serna, "Lateral-torsional buckling of steel beams: a general expression for the moment gradient factor",
    /// Stability and Ductility of Steel Structures, Lisbon 2006. 1 for constant moment, 1.14 under uniform load (tables: 1.13).
    pub fn c1(&self) -> f64 {
        let most = self.peak().powi(2);
        if most == 0.0 {
            return 1.0;
        }
        let [a, b, c] = [0.25, 0.5, 0.75].map(|x| self.at(x).powi(2));
        (35.0 * most / (most + 9.0 * a + 16.0 * b + 9.0 * c)).sqrt()
    }

    /// Equivalent uniform moment factor of EN 1993-1-1 Table B.3 for members whose ends do not sway, at least 0.4.
    pub fn cm(&self) -> f64 {
        let (large, small) =
            if self.start.abs() >= self.end.abs() { (self.start, self.end) } else { (self.end, self.start) };
        let psi = if large == 0.0 { 1.0 } else { small / large };
        if self.sag == 0.0 {
            return (0.6 + 0.4 * psi).max(0.4);
        }
        let middle = self.at(0.5);
        if middle.abs() <= large.abs() {
            let s = middle / large;
            let cm = match (s >= 0.0, psi >= 0.0) {
                (true, _) => 0.2 + 0.8 * s,
                (false, true) => 0.1 - 0.8 * s,
                (false, false) => 0.1 * (1.0 - psi) - 0.8 * s,
            };
            return cm.max(0.4);
        }
        let h = large / middle;
        let cm = if h < 0.0 && psi < 0.0 { 0.95 + 0.05 * h * (1.0 + 2.0 * psi) } else { 0.95 + 0.05 * h };
        cm.max(0.4)
    }
}
