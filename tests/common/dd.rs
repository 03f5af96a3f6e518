//! Numbers of about 32 digits: the unevaluated sum of two f64 (Dekker, Numer. Math. 18 (1971) 224-242; Knuth's two-sum).
#![allow(dead_code)]

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// `hi + lo`, `lo` at most half a unit in the last place of `hi`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dd(pub f64, pub f64);

fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

fn quick_two_sum(a: f64, b: f64) -> Dd {
    let s = a + b;
    Dd(s, b - (s - a))
}

fn split(a: f64) -> (f64, f64) {
    let t = 134_217_729.0 * a;
    let hi = t - (t - a);
    (hi, a - hi)
}

fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl From<f64> for Dd {
    fn from(v: f64) -> Self {
        Dd(v, 0.0)
    }
}

impl Dd {
    /// Zero.
    pub const ZERO: Dd = Dd(0.0, 0.0);

    /// The nearest f64.
    pub fn value(self) -> f64 {
        self.0 + self.1
    }

    /// Square root: one Newton step from that of `hi`.
    pub fn sqrt(self) -> Dd {
        if self.0 <= 0.0 {
            return Dd::ZERO;
        }
        let r = Dd::from(self.0.sqrt());
        r + (self - r * r) / (r + r)
    }
}

impl Add for Dd {
    type Output = Dd;
    fn add(self, o: Dd) -> Dd {
        let (s, e) = two_sum(self.0, o.0);
        let (t, f) = two_sum(self.1, o.1);
        let v = quick_two_sum(s, e + t);
        quick_two_sum(v.0, v.1 + f)
    }
}

impl Neg for Dd {
    type Output = Dd;
    fn neg(self) -> Dd {
        Dd(-self.0, -self.1)
    }
}

impl Sub for Dd {
    type Output = Dd;
    fn sub(self, o: Dd) -> Dd {
        self + -o
    }
}

impl Mul for Dd {
    type Output = Dd;
    fn mul(self, o: Dd) -> Dd {
        let (p, e) = two_prod(self.0, o.0);
        quick_two_sum(p, e + self.0 * o.1 + self.1 * o.0)
    }
}

impl Div for Dd {
    type Output = Dd;
    fn div(self, o: Dd) -> Dd {
        let q = self.0 / o.0;
        let r = self - o * Dd::from(q);
        let q2 = r.0 / o.0;
        let r = r - o * Dd::from(q2);
        quick_two_sum(q, q2) + Dd::from(r.0 / o.0)
    }
}

impl AddAssign for Dd {
    fn add_assign(&mut self, o: Dd) {
        *self = *self + o;
    }
}

impl SubAssign for Dd {
    fn sub_assign(&mut self, o: Dd) {
        *self = *self - o;
    }
}
