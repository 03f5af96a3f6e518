//! External pressure coefficients cpe,10 by zone (EN 1991-1-4 7.2.2 to 7.2.6).

/// Zones of all tables, numbered through.
pub const ZONES: usize = 47;

/// A zone: index into [`ZONE_NAMES`].
pub type Zone = usize;

/// First zone of the walls: A, B, C, D, E.
pub const WALL: Zone = 0;
/// Of flat roofs: F, G, H, I.
pub const FLAT: Zone = 5;
/// Of monopitch roofs, wind on the low eave: F, G, H.
pub const MONO_0: Zone = 9;
/// Of monopitch roofs, wind on the high edge: F, G, H.
pub const MONO_180: Zone = 12;
/// Of monopitch roofs, wind along the eaves: Fup, Flow, G, H, I.
pub const MONO_90: Zone = 15;
/// Of duopitch roofs, wind across the ridge: F, G, H, I, J.
pub const DUO_0: Zone = 20;
/// Of duopitch roofs, wind along the ridge: F, G, H, I.
pub const DUO_90: Zone = 25;
/// Of trough roofs, wind across the valley: F, G, H, I, J.
pub const TROUGH_0: Zone = 29;
/// Of trough roofs, wind along the valley: F, G, H, I.
pub const TROUGH_90: Zone = 34;
/// Of hip roofs: F, G, H, I, J, K, L, M, N.
pub const HIP: Zone = 38;

/// Clause and letter of every zone.
#[rustfmt::skip]
pub const ZONE_NAMES: [(&str, &str); ZONES] = {
    const W: &str = "EN 1991-1-4 7.2.2, Table 7.1";
    const F: &str = "EN 1991-1-4 7.2.3, Table 7.2";
    const M0: &str = "EN 1991-1-4 7.2.4, Table 7.3a, 0 degrees";
    const M180: &str = "EN 1991-1-4 7.2.4, Table 7.3a, 180 degrees";
    const M90: &str = "EN 1991-1-4 7.2.4, Table 7.3b";
    const D0: &str = "EN 1991-1-4 7.2.5, Table 7.4a";
    const D90: &str = "EN 1991-1-4 7.2.5, Table 7.4b";
    const T0: &str = "EN 1991-1-4 7.2.5, Table 7.4a, negative pitch";
    const T90: &str = "EN 1991-1-4 7.2.5, Table 7.4b, negative pitch";
    const H: &str = "EN 1991-1-4 7.2.6, Table 7.5";
    [
        (W, "A"), (W, "B"), (W, "C"), (W, "D"), (W, "E"),
        (F, "F"), (F, "G"), (F, "H"), (F, "I"),
        (M0, "F"), (M0, "G"), (M0, "H"),
        (M180, "F"), (M180, "G"), (M180, "H"),
        (M90, "Fup"), (M90, "Flow"), (M90, "G"), (M90, "H"), (M90, "I"),
        (D0, "F"), (D0, "G"), (D0, "H"), (D0, "I"), (D0, "J"),
        (D90, "F"), (D90, "G"), (D90, "H"), (D90, "I"),
        (T0, "F"), (T0, "G"), (T0, "H"), (T0, "I"), (T0, "J"),
        (T90, "F"), (T90, "G"), (T90, "H"), (T90, "I"),
        (H, "F"), (H, "G"), (H, "H"), (H, "I"), (H, "J"), (H, "K"), (H, "L"), (H, "M"), (H, "N"),
    ]
};

/// Smallest and largest coefficient of a zone.
pub type Pair = [f64; 2];

/// The tables as read: first column pitch (or hp/h), the others coefficients.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PressureTables {
    /// A, B, C.
    pub sides: [f64; 3],
    /// Rows h/d, D, E.
    pub wall_d_e: [[f64; 3]; 3],
    /// Rows hp/h, F, G, H, I min, I max.
    pub flat: Vec<[f64; 6]>,
    /// Rows pitch, F min, F max, G min, G max, H min, H max.
    pub mono_0: Vec<[f64; 7]>,
    /// Rows pitch, F, G, H.
    pub mono_180: Vec<[f64; 4]>,
    /// Rows pitch, Fup, Flow, G, H, I.
    pub mono_90: Vec<[f64; 6]>,
    /// Rows pitch, min and max of F, G, H, I, J.
    pub duo_0: Vec<[f64; 11]>,
    /// Rows pitch, F, G, H, I.
    pub duo_90: Vec<[f64; 5]>,
    /// Rows pitch, F, G, H, I, J.
    pub trough_0: Vec<[f64; 6]>,
    /// Rows pitch, F, G, H, I.
    pub trough_90: Vec<[f64; 5]>,
    /// Rows pitch, min and max of F, G, H; I, J, K, L, M, N.
    pub hip: Vec<[f64; 13]>,
}

impl PressureTables {
    /// cpe,10 of windward and leeward walls for h/d, linear between the rows (Table 7.1).
    pub fn walls(&self, h_over_d: f64) -> [f64; 2] {
        let row = rows(&self.wall_d_e, h_over_d);
        [row[1], row[2]]
    }

    /// cpe,10 of every zone for a pitch in degrees and a parapet of `parapet_m` on roofs `height_m` high. D and E are those of
    /// h/d = 1; [`PressureTables::walls`] has them for others. Linear between pitches, among values of one sign only: the
    /// tables' smallest and largest values are columns of their own.
    pub fn zones(&self, pitch_deg: f64, parapet_m: f64, height_m: f64) -> [Pair; ZONES] {
        let mut out = [[0.0; 2]; ZONES];
        let one = |out: &mut [Pair; ZONES], first: Zone, values: &[f64]| {
            for (n, v) in values.iter().enumerate() {
                out[first + n] = [*v; 2];
            }
        };
        let two = |out: &mut [Pair; ZONES], first: Zone, values: &[f64]| {
            for (n, v) in values.chunks_exact(2).enumerate() {
                out[first + n] = [v[0], v[1]];
            }
        };
        one(&mut out, WALL, &self.sides);
        one(&mut out, WALL + 3, &self.walls(1.0));
        let flat = rows(&self.flat, if height_m > 0.0 { parapet_m / height_m } else { 0.0 });
        one(&mut out, FLAT, &flat[1..4]);
        two(&mut out, FLAT + 3, &flat[4..]);
        two(&mut out, MONO_0, &rows(&self.mono_0, pitch_deg)[1..]);
        one(&mut out, MONO_180, &rows(&self.mono_180, pitch_deg)[1..]);
        one(&mut out, MONO_90, &rows(&self.mono_90, pitch_deg)[1..]);
        two(&mut out, DUO_0, &rows(&self.duo_0, pitch_deg)[1..]);
        one(&mut out, DUO_90, &rows(&self.duo_90, pitch_deg)[1..]);
        one(&mut out, TROUGH_0, &rows(&self.trough_0, pitch_deg)[1..]);
        one(&mut out, TROUGH_90, &rows(&self.trough_90, pitch_deg)[1..]);
        let hip = rows(&self.hip, pitch_deg);
        two(&mut out, HIP, &hip[1..7]);
        one(&mut out, HIP + 3, &hip[7..]);
        out
    }
}

/// Whether a zone lies on the lee of a duopitch roof: its largest value acts apart from those of slopes that face the wind and of
/// level roofs.
pub fn lee(zone: Zone) -> bool {
    (DUO_0 + 3..DUO_0 + 5).contains(&zone)
}

/// A row between the rows of a table whose first column rises; beyond its ends the end's.
pub(super) fn rows<const N: usize>(table: &[[f64; N]], at: f64) -> [f64; N] {
    let above = table.partition_point(|r| r[0] <= at);
    match (above.checked_sub(1).and_then(|n| table.get(n)), table.get(above)) {
        (Some(a), Some(b)) => {
            let f = (at - a[0]) / (b[0] - a[0]);
            std::array::from_fn(|c| a[c] + f * (b[c] - a[c]))
        }
        (Some(end), None) | (None, Some(end)) => *end,
        (None, None) => [0.0; N],
    }
}
