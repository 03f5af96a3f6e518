//! Thermal transmittance of layered elements, ISO 6946 combined method.

/// One layer as heat sees it: thickness in m, and its parts beside each other as (fraction of the area, conductivity in W/mK).
#[derive(Clone, Debug, PartialEq)]
pub struct ThermalLayer {
    /// Thickness in m.
    pub thickness_m: f64,
    /// Fractions (sum 1) and conductivities in W/mK.
    pub parts: Vec<(f64, f64)>,
}

impl ThermalLayer {
    /// Resistance with the parts in parallel and the temperature even across the layer, m2K/W.
    fn parallel(&self) -> f64 {
        self.thickness_m / self.parts.iter().map(|(fraction, lambda)| fraction * lambda).sum::<f64>()
    }
}

/// U in W/m2K of layers between surface resistances in m2K/W (ISO 6946, 6.7.2: combined method).
///
/// Upper limit: heat flows straight through, so every combination of parts is a path of its own (bridges of different layers cross at
/// random): `1/R' = sum f_path / R_path`. Lower limit: every layer is one temperature: `R'' = Rsi + sum R_layer + Rse`. U is 1 over their mean.
/// Metal bridges are outside the method.
///
/// ```
/// use houscaper::price::{ThermalLayer, u_value};
/// let wool = ThermalLayer { thickness_m: 0.14, parts: vec![(1.0, 0.035)] };
/// assert!((u_value(0.13, 0.04, &[wool]) - 1.0 / 4.17).abs() < 1e-12);
/// ```
pub fn u_value(rsi: f64, rse: f64, layers: &[ThermalLayer]) -> f64 {
    let lower = rsi + layers.iter().map(ThermalLayer::parallel).sum::<f64>() + rse;
    let upper = 1.0 / conductance_of_paths(1.0, rsi + rse, layers);
    2.0 / (upper + lower)
}

/// Sum of fraction over resistance of all paths through the layers.
fn conductance_of_paths(fraction: f64, resistance: f64, layers: &[ThermalLayer]) -> f64 {
    let Some((layer, rest)) = layers.split_first() else { return fraction / resistance };
    let through = |&(part, lambda): &(f64, f64)| {
        conductance_of_paths(fraction * part, resistance + layer.thickness_m / lambda, rest)
    };
    layer.parts.iter().map(through).sum()
}
