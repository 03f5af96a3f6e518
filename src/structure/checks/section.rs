//! Shapes of sections and the properties computed from them.

use std::f64::consts::PI;

/// How a hollow section was made; it decides corner radii and the buckling curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forming {
    /// Hot finished, EN 10210-2.
    Hot,
    /// Cold formed, EN 10219-2.
    Cold,
}

/// Outline of a section, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Solid rectangle.
    Rectangle {
        /// Width, along y.
        b: f64,
        /// Depth, along z.
        h: f64,
    },
    /// Square or rectangular hollow section.
    Box {
        /// Width, along y.
        b: f64,
        /// Depth, along z.
        h: f64,
        /// Wall.
        t: f64,
        /// How it was made.
        forming: Forming,
    },
    /// Circular hollow section.
    Tube {
        /// Outer diameter.
        d: f64,
        /// Wall.
        t: f64,
        /// How it was made.
        forming: Forming,
    },
    /// Rolled I or H section, doubly symmetric.
    I {
        /// Width of the flanges, along y.
        b: f64,
        /// Depth, along z.
        h: f64,
        /// Web.
        tw: f64,
        /// Flanges.
        tf: f64,
        /// Root radius.
        r: f64,
    },
}

/// Properties of a section, SI; index 0 is about or along y, 1 about or along z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// What they belong to.
    pub shape: Shape,
    /// Area, m2.
    pub a: f64,
    /// Second moments, m4.
    pub i: [f64; 2],
    /// Torsion constant, m4.
    pub it: f64,
    /// Warping constant, m6; 0 for closed sections.
    pub iw: f64,
    /// Elastic moduli, m3.
    pub wel: [f64; 2],
    /// Plastic moduli, m3.
    pub wpl: [f64; 2],
    /// Shear areas for forces along y and z, m2: EN 1993-1-1 6.2.6(3) with eta = 1; 2/3 of a rectangle.
    pub av: [f64; 2],
    /// Torsion modulus, m3: largest shear stress of St Venant torsion is T over it.
    pub wt: f64,
}

/// Area, distance of its centroid from the corner and own second moment of the spandrel between two sides and a fillet of radius `r`
/// (EN 10210-2 Annex A: A_g, h_g, I_gg).
fn spandrel(r: f64) -> (f64, f64, f64) {
    let k = 12.0 - 3.0 * PI;
    ((1.0 - PI / 4.0) * r * r, (10.0 - 3.0 * PI) / k * r, (1.0 / 3.0 - PI / 16.0 - 1.0 / (3.0 * k)) * r.powi(4))
}

impl Shape {
    /// Width along y and depth along z, m.
    pub fn size(&self) -> [f64; 2] {
        match *self {
            Shape::Rectangle { b, h } | Shape::Box { b, h, .. } | Shape::I { b, h, .. } => [b, h],
            Shape::Tube { d, .. } => [d, d],
        }
    }

    /// Properties from the outline. Sources: EN 10210-2:2006 Annex A and EN 10219-2:2006 Annex B (hollow; corner radii 1.5 t and t
    /// hot finished, 2, 2.5 or 3 t outside cold formed up to 6, 10 and over 10 mm), the formulas of ArcelorMittal's table of
    /// sections (I), Roark (torsion of a rectangle, within 0.5 %).
    pub fn properties(self) -> Section {
        match self {
            Shape::Rectangle { b, h } => rectangle(self, b, h),
            Shape::Box { b, h, t, forming } => hollow(self, b, h, t, forming),
            Shape::Tube { d, t, .. } => tube(self, d, t),
            Shape::I { b, h, tw, tf, r } => i_section(self, [b, h, tw, tf, r]),
        }
    }
}

impl Section {
    /// Properties with the tabulated A, I and It in the place of the computed ones, so that a catalogue's numbers hold.
    pub fn tabulated(shape: Shape, a: f64, i: [f64; 2], it: f64) -> Section {
        let computed = shape.properties();
        let [b, h] = shape.size();
        Section { a, i, it, wel: [i[0] / (0.5 * h), i[1] / (0.5 * b)], ..computed }
    }

    /// Radii of gyration, m.
    pub fn radii(&self) -> [f64; 2] {
        self.i.map(|i| (i / self.a).sqrt())
    }
}

fn rectangle(shape: Shape, b: f64, h: f64) -> Section {
    let a = b * h;
    let (long, short) = (b.max(h), b.min(h));
    let s = short / long;
    // Roark, Formulas for Stress and Strain, table of torsion, solid rectangle.
    let it = long * short.powi(3) * (1.0 / 3.0 - 0.21 * s * (1.0 - s.powi(4) / 12.0));
    let peak = 1.0 + 0.6095 * s + 0.8865 * s * s - 1.8023 * s.powi(3) + 0.91 * s.powi(4);
    Section {
        shape,
        a,
        i: [b * h.powi(3) / 12.0, h * b.powi(3) / 12.0],
        it,
        iw: 0.0,
        wel: [b * h * h / 6.0, h * b * b / 6.0],
        wpl: [b * h * h / 4.0, h * b * b / 4.0],
        av: [a / 1.5; 2],
        wt: long * short * short / (3.0 * peak),
    }
}

fn hollow(shape: Shape, b: f64, h: f64, t: f64, forming: Forming) -> Section {
    let (outer, inner) = match forming {
        Forming::Hot => (1.5 * t, t),
        // Limits of the wall thickness with a margin for 6 and 10 mm written as metres.
        Forming::Cold if t < 6.001e-3 => (2.0 * t, t),
        Forming::Cold if t < 10.001e-3 => (2.5 * t, 1.5 * t),
        Forming::Cold => (3.0 * t, 2.0 * t),
    };
    let a = 2.0 * t * (b + h - 2.0 * t) - (4.0 - PI) * (outer * outer - inner * inner);
    let (ao, co, io) = spandrel(outer);
    let (ai, ci, ii) = spandrel(inner);
    let about = |b: f64, h: f64| {
        let (bi, hi) = (b - 2.0 * t, h - 2.0 * t);
        let (zo, zi) = (0.5 * h - co, 0.5 * hi - ci);
        let i = (b * h.powi(3) - bi * hi.powi(3)) / 12.0 - 4.0 * (io + ao * zo * zo) + 4.0 * (ii + ai * zi * zi);
        (i, (b * h * h - bi * hi * hi) / 4.0 - 4.0 * ao * zo + 4.0 * ai * zi)
    };
    let ((iy, wy), (iz, wz)) = (about(b, h), about(h, b));
    let middle = 0.5 * (outer + inner);
    let line = 2.0 * (b + h - 2.0 * t) - 2.0 * middle * (4.0 - PI);
    let within = (b - t) * (h - t) - middle * middle * (4.0 - PI);
    let k = 2.0 * within * t / line;
    let it = t.powi(3) * line / 3.0 + 2.0 * k * within;
    Section {
        shape,
        a,
        i: [iy, iz],
        it,
        iw: 0.0,
        wel: [2.0 * iy / h, 2.0 * iz / b],
        wpl: [wy, wz],
        av: [a * b / (b + h), a * h / (b + h)],
        wt: it / (t + k / t),
    }
}

fn tube(shape: Shape, d: f64, t: f64) -> Section {
    let di = d - 2.0 * t;
    let a = PI / 4.0 * (d * d - di * di);
    let i = PI / 64.0 * (d.powi(4) - di.powi(4));
    Section {
        shape,
        a,
        i: [i; 2],
        it: 2.0 * i,
        iw: 0.0,
        wel: [2.0 * i / d; 2],
        wpl: [(d.powi(3) - di.powi(3)) / 6.0; 2],
        av: [2.0 * a / PI; 2],
        wt: 4.0 * i / d,
    }
}

fn i_section(shape: Shape, [b, h, tw, tf, r]: [f64; 5]) -> Section {
    let web = h - 2.0 * tf;
    let (af, cf, own) = spandrel(r);
    let (zf, yf) = (0.5 * web - cf, 0.5 * tw + cf);
    let a = 2.0 * b * tf + web * tw + 4.0 * af;
    let iy = (b * h.powi(3) - (b - tw) * web.powi(3)) / 12.0 + 4.0 * (own + af * zf * zf);
    let iz = (2.0 * tf * b.powi(3) + web * tw.powi(3)) / 12.0 + 4.0 * (own + af * yf * yf);
    let corner = ((r + 0.5 * tw).powi(2) + (r + tf).powi(2) - r * r) / (2.0 * r + tf);
    let it = 2.0 / 3.0 * (b - 0.63 * tf) * tf.powi(3)
        + web * tw.powi(3) / 3.0
        + 2.0 * tw / tf * (0.145 + 0.1 * r / tf) * corner.powi(4);
    Section {
        shape,
        a,
        i: [iy, iz],
        it,
        iw: tf * b.powi(3) / 24.0 * (h - tf).powi(2),
        wel: [2.0 * iy / h, 2.0 * iz / b],
        wpl: [
            (b * h * h - (b - tw) * web * web) / 4.0 + 4.0 * af * zf,
            0.5 * b * b * tf + 0.25 * web * tw * tw + 4.0 * af * yf,
        ],
        av: [2.0 * b * tf, (a - 2.0 * b * tf + (tw + 2.0 * r) * tf).max(web * tw)],
        wt: it / tf.max(tw),
    }
}
