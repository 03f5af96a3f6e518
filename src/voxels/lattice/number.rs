//! Numbers as topoGenesis writes them.

/// An integer in full, anything else with six significant digits, as C's `%g` does.
pub(super) fn spell(value: f64) -> String {
    if value == value.trunc() && value.abs() < 1e15 {
        return format!("{}", value as i64);
    }
    let scientific = format!("{value:.5e}");
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        return trim(&format!("{value:.*}", (5 - exponent).max(0) as usize)).to_string();
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    format!("{}e{sign}{:02}", trim(mantissa), exponent.abs())
}

fn trim(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

#[cfg(test)]
mod tests {
    use super::spell;

    #[test]
    fn six_significant_digits_as_printf_g() {
        // Expected texts from C's printf("%g").
        let cases = [(0.7083333333, "0.708333"), (-40.0, "-40"), (1e-5, "1e-05"), (0.0001, "0.0001"), (12.5, "12.5")];
        for (value, text) in cases {
            assert_eq!(spell(value), text);
        }
        assert_eq!(spell(1.234567e20), "1.23457e+20");
        assert_eq!(spell(1679615.0), "1679615"); // ids stay whole
        assert_eq!(spell(123456.7), "123457");
    }
}
