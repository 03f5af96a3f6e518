//! Colours: sRGB to linear and back, and a perceptually even ramp that colour-blind readers can follow.

/// One sRGB channel, 0 to 1, as linear light (IEC 61966-2-1).
pub fn srgb_to_linear(c: f64) -> f64 {
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

/// Linear light, 0 to 1, as an sRGB channel (IEC 61966-2-1).
pub fn linear_to_srgb(c: f64) -> f64 {
    if c <= 0.0031308 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }
}

/// A colour written as 0xRRGGBB in sRGB, as linear light.
pub fn linear(hex: u32) -> [f64; 3] {
    [hex >> 16 & 255, hex >> 8 & 255, hex & 255].map(|c| srgb_to_linear(f64::from(c) / 255.0))
}

/// Red, green, blue as 0xRRGGBB.
pub fn hex(srgb: [u8; 3]) -> u32 {
    srgb.iter().fold(0, |hex, &c| hex << 8 | u32::from(c))
}

/// Nine samples of viridis (Smith and van der Walt, matplotlib 2015), dark to light, sRGB.
const VIRIDIS: [u32; 9] = [0x440154, 0x472D7B, 0x3B528B, 0x2C728E, 0x21918C, 0x28AE80, 0x5EC962, 0xADDC30, 0xFDE725];

/// The viridis ramp at `t` (held to 0..1; NaN reads as 0) as sRGB bytes.
pub fn viridis(t: f64) -> [u8; 3] {
    let t = if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) } * 8.0;
    let i = (t.floor() as usize).min(7);
    let f = t - i as f64;
    let channel = |shift: u32| {
        let (a, b) = (VIRIDIS[i] >> shift & 255, VIRIDIS[i + 1] >> shift & 255);
        (f64::from(a) + (f64::from(b) - f64::from(a)) * f).round() as u8
    };
    [channel(16), channel(8), channel(0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_round_trips() {
        for i in 0..=255 {
            let c = f64::from(i) / 255.0;
            assert!((linear_to_srgb(srgb_to_linear(c)) - c).abs() < 1e-6, "{i}");
        }
    }

    #[test]
    fn viridis_ends_and_brightens() {
        assert_eq!(viridis(-1.0), [0x44, 0x01, 0x54]);
        assert_eq!(viridis(f64::NAN), [0x44, 0x01, 0x54]);
        assert_eq!(viridis(2.0), [0xFD, 0xE7, 0x25]);
        let luma = |t: f64| {
            let [r, g, b] = viridis(t).map(|c| srgb_to_linear(f64::from(c) / 255.0));
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        for i in 0..50 {
            assert!(luma(f64::from(i + 1) / 50.0) > luma(f64::from(i) / 50.0), "not monotone at {i}");
        }
    }
}
