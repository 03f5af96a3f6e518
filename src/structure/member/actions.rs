//! Design forces and characteristic loads of one member.

use super::error::MemberError;
use super::input::{Duration, Input};
use super::shapes::positive;
use crate::structure::checks::{Diagram, Forces};

/// Design forces of one combination.
#[derive(Clone, Debug)]
pub(super) struct Loading {
    /// `permanent` for 1.35 g alone.
    pub duration: Duration,
    /// Axial force, tension positive, N.
    pub n: f64,
    /// Moments about y (sagging positive) and z, N m.
    pub my: Diagram,
    pub mz: Diagram,
    /// Shear given beside that of the moments, N.
    pub v: [f64; 2],
    /// Torsion, N m.
    pub t: f64,
    /// Span for the shear that goes with the moments, m.
    length: Option<f64>,
}

impl Loading {
    /// Forces at a share of the length.
    pub fn at(&self, x: f64) -> Forces {
        let shear = |d: &Diagram, given: f64| {
            let [a, b] = d.slopes();
            let of_moments = self.length.map_or(0.0, |l| ((1.0 - x) * a + x * b) / l);
            if given.abs() > of_moments.abs() { given } else { of_moments }
        };
        Forces {
            n: self.n,
            vy: shear(&self.mz, self.v[0]),
            vz: shear(&self.my, self.v[1]),
            my: self.my.at(x),
            mz: self.mz.at(x),
        }
    }
}

/// Combinations to check and characteristic line loads.
#[derive(Clone, Debug)]
pub(super) struct Actions {
    /// Permanent alone (when characteristic loads are given), then all.
    pub loadings: Vec<Loading>,
    /// Permanent and variable characteristic load, N/m.
    pub service: Option<[f64; 2]>,
    /// The factors on them.
    pub gamma: [f64; 2],
}

/// One of two units, in SI.
fn either(
    a: (&'static str, Option<f64>, f64),
    b: (&'static str, Option<f64>, f64),
) -> Result<Option<f64>, MemberError> {
    match (a.1, b.1) {
        (Some(_), Some(_)) => Err(MemberError::Twice { first: a.0, second: b.0 }),
        (Some(v), None) => finite(a.0, v).map(|v| Some(v * a.2)),
        (None, Some(v)) => finite(b.0, v).map(|v| Some(v * b.2)),
        (None, None) => Ok(None),
    }
}

fn finite(key: &'static str, found: f64) -> Result<f64, MemberError> {
    if found.is_finite() { Ok(found) } else { Err(MemberError::Range { key, found, expected: "a finite number" }) }
}

impl Actions {
    pub fn new(input: &Input, length: Option<f64>, weight: f64) -> Result<Actions, MemberError> {
        let kilo = |key, v: Option<f64>| v.map_or(Ok(0.0), |v| finite(key, v).map(|v| v * 1e3));
        let n = -either(("NEd_kN", input.n_kn, 1e3), ("NEd_N", input.n_n, 1.0))?.unwrap_or(0.0);
        let my = either(("My_Ed_kNm", input.my_knm, 1e3), ("My_Ed_Nmm", input.my_nmm, 1e-3))?.unwrap_or(0.0);
        let mz = either(("Mz_Ed_kNm", input.mz_knm, 1e3), ("Mz_Ed_Nmm", input.mz_nmm, 1e-3))?.unwrap_or(0.0);
        let my_end = input.my_end_knm.map_or(Ok(my), |v| finite("My_end_Ed_kNm", v).map(|v| v * 1e3))?;
        let mz_end = input.mz_end_knm.map_or(Ok(mz), |v| finite("Mz_end_Ed_kNm", v).map(|v| v * 1e3))?;
        let [qz, qy] = [kilo("qz_Ed_kN_m", input.qz_kn_m)?, kilo("qy_Ed_kN_m", input.qy_kn_m)?];
        let service = service(input, weight)?;
        if (qz != 0.0 || qy != 0.0 || service.is_some()) && length.is_none() {
            return Err(MemberError::Missing { key: "L_mm", hint: "a line load needs the span it acts on" });
        }
        let gamma =
            [positive("gamma_G", input.gamma_g)?.unwrap_or(1.35), positive("gamma_Q", input.gamma_q)?.unwrap_or(1.5)];
        let span = length.unwrap_or(0.0);
        let sag = |q: f64| q * span * span / 8.0;
        let [g, q] = service.unwrap_or_default();
        let all = Loading {
            duration: input.duration.unwrap_or_default(),
            n,
            my: Diagram { start: my, end: my_end, sag: sag(qz + gamma[0] * g + gamma[1] * q) },
            mz: Diagram { start: mz, end: mz_end, sag: sag(qy) },
            v: [kilo("Vy_Ed_kN", input.vy_kn)?, kilo("Vz_Ed_kN", input.vz_kn)?],
            t: kilo("T_Ed_kNm", input.t_knm)?,
            length,
        };
        let mut loadings = Vec::new();
        if g > 0.0 {
            loadings.push(Loading {
                duration: Duration::Permanent,
                n: 0.0,
                my: Diagram { sag: sag(1.35 * g), ..Diagram::default() },
                mz: Diagram::default(),
                v: [0.0; 2],
                t: 0.0,
                length,
            });
        }
        loadings.push(all);
        Ok(Actions { loadings, service, gamma })
    }

    /// Whether nothing acts at all.
    pub fn is_nothing(&self) -> bool {
        let l = self.full();
        let m = [l.my.start, l.my.end, l.my.sag, l.mz.start, l.mz.end, l.mz.sag];
        m.iter().chain(&l.v).chain(&[l.n, l.t]).all(|f| *f == 0.0)
    }

    /// Design loads with everything on.
    pub fn full(&self) -> &Loading {
        &self.loadings[self.loadings.len() - 1]
    }
}

/// Characteristic line loads: per metre, or per m2 times the spacing; self weight on top when asked for.
fn service(input: &Input, weight: f64) -> Result<Option<[f64; 2]>, MemberError> {
    let spacing = positive("spacing_m", input.spacing_m)?;
    let line = |per_m: (&'static str, Option<f64>), per_m2: (&'static str, Option<f64>)| match (per_m.1, per_m2.1) {
        (Some(_), Some(_)) => Err(MemberError::Twice { first: per_m.0, second: per_m2.0 }),
        (Some(v), None) => load(per_m.0, v).map(Some),
        (None, Some(v)) => {
            let width = spacing.ok_or(MemberError::Missing {
                key: "spacing_m",
                hint: "loads per m2 need the width the member carries",
            })?;
            load(per_m2.0, v).map(|v| Some(v * width))
        }
        (None, None) => Ok(None),
    };
    let g = line(("gk_kN_m", input.gk_kn_m), ("gk_kN_m2", input.gk_kn_m2))?;
    let q = line(("qk_kN_m", input.qk_kn_m), ("qk_kN_m2", input.qk_kn_m2))?;
    let own = if input.self_weight { weight } else { 0.0 };
    match (g, q, input.self_weight) {
        (None, None, false) => Ok(None),
        (g, q, _) => Ok(Some([g.unwrap_or(0.0) + own, q.unwrap_or(0.0)])),
    }
}

fn load(key: &'static str, found: f64) -> Result<f64, MemberError> {
    if found.is_finite() && found >= 0.0 {
        return Ok(found * 1e3);
    }
    Err(MemberError::Range { key, found, expected: "a load of at least 0, downwards" })
}
