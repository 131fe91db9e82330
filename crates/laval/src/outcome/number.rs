//! Numbers for people: significant digits, SI prefixes, typeset units.

const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

pub(crate) fn superscript(n: i32) -> String {
    n.to_string().chars().map(|c| c.to_digit(10).map_or('⁻', |d| SUPERSCRIPTS[d as usize])).collect()
}

/// A unit with its powers raised: `m/s^2` becomes `m/s²`.
pub fn unit_text(unit: &str) -> String {
    let mut out = String::new();
    let mut chars = unit.chars().peekable();
    while let Some(c) = chars.next() {
        if c != '^' {
            out.push(c);
            continue;
        }
        let mut power = String::new();
        if chars.peek() == Some(&'-') {
            power.push('-');
            chars.next();
        }
        while let Some(d) = chars.peek().filter(|c| c.is_ascii_digit()) {
            power.push(*d);
            chars.next();
        }
        match power.parse::<i32>() {
            Ok(n) => out.push_str(&superscript(n)),
            Err(_) => {
                out.push('^');
                out.push_str(&power);
            }
        }
    }
    out
}

/// `x` with `digits` significant digits, without trailing zeros; powers of ten outside 1e-4 .. 1e6.
///
/// ```
/// use laval::outcome::significant;
/// assert_eq!(significant(1234.567, 5), "1234.6");
/// assert_eq!(significant(2.5e-9, 3), "2.5·10⁻⁹");
/// assert_eq!(significant(f64::NAN, 3), "not a number");
/// ```
pub fn significant(x: f64, digits: usize) -> String {
    if x.is_nan() {
        return "not a number".into();
    }
    if x.is_infinite() {
        return if x > 0.0 { "infinite".into() } else { "minus infinite".into() };
    }
    if x == 0.0 {
        return "0".into();
    }
    let digits = digits.clamp(1, 17);
    let exact = format!("{:.*e}", digits - 1, x.abs());
    let (mantissa, exponent) = exact.split_once('e').unwrap_or((&exact, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let sign = if x < 0.0 { "−" } else { "" };
    if (-4..6).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        // rounding to `digits` first keeps 123456 with 3 digits at 123000, not 123456
        let rounded: f64 = exact.parse().unwrap_or(x.abs());
        return format!("{sign}{}", trim_zeros(&format!("{rounded:.decimals$}")));
    }
    match trim_zeros(mantissa) {
        "1" => format!("{sign}10{}", superscript(exponent)),
        m => format!("{sign}{m}·10{}", superscript(exponent)),
    }
}

pub(crate) fn trim_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A value with its unit for reading: four significant digits, an SI prefix where the unit takes one.
///
/// ```
/// use laval::outcome::quantity;
/// assert_eq!(quantity(1.234e-4, "m"), "123.4 µm");
/// assert_eq!(quantity(1.1e7, "N/m"), "11 MN/m");
/// assert_eq!(quantity(314.159265, "rad/s"), "314.2 rad/s");
/// assert_eq!(quantity(0.25, ""), "0.25");
/// ```
pub fn quantity(value: f64, unit: &str) -> String {
    quantity_to(value, unit, 4)
}

/// The same with another number of significant digits.
pub(crate) fn quantity_to(value: f64, unit: &str, digits: usize) -> String {
    if unit.is_empty() || !value.is_finite() {
        return significant(value, digits);
    }
    // range of prefixes that readers of the field use for each unit
    let powers: &[(i32, &str)] = match unit {
        "m" => &[(0, ""), (-3, "m"), (-6, "µ"), (-9, "n")],
        "s" => &[(0, ""), (-3, "m"), (-6, "µ")],
        "N" | "N m" | "N/m" | "N s/m" | "N m/rad" | "Pa" | "W" | "J" => &[(9, "G"), (6, "M"), (3, "k"), (0, ""), (-3, "m"), (-6, "µ")],
        _ => &[],
    };
    let size = value.abs();
    // a value that rounds up to the next prefix takes it: 0.99999e-3 m is 1 mm
    if size > 0.0
        && let Some((p, prefix)) = powers.iter().find(|(p, _)| size >= 0.99995 * 10f64.powi(*p))
        && (size < 1e6 * 10f64.powi(*p))
    {
        return format!("{} {prefix}{}", significant(value / 10f64.powi(*p), digits), unit_text(unit));
    }
    format!("{} {}", significant(value, digits), unit_text(unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn significant_digits() {
        for (x, d, want) in [
            (0.0, 4, "0"),
            (3000.0, 4, "3000"),
            (123456.0, 3, "123000"),
            (-0.00123456, 3, "−0.00123"),
            (9.9996, 4, "10"),
            (1e-12, 3, "10⁻¹²"),
            (-2.5e8, 3, "−2.5·10⁸"),
            (999999.9, 4, "10⁶"),
            (f64::INFINITY, 4, "infinite"),
        ] {
            assert_eq!(significant(x, d), want);
        }
    }

    #[test]
    fn prefixes() {
        for (x, u, want) in [
            (9.99999e-4, "m", "1 mm"),
            (0.0, "m", "0 m"),
            (2.0, "m", "2 m"),
            (3e-13, "N", "3·10⁻¹³ N"),
            (8.7e10, "N/m^3", "8.7·10¹⁰ N/m³"),
            (-2500.0, "N", "−2.5 kN"),
            (f64::NAN, "m", "not a number"),
        ] {
            assert_eq!(quantity(x, u), want);
        }
    }

    #[test]
    fn units() {
        assert_eq!(unit_text("m/s^2"), "m/s²");
        assert_eq!(unit_text("kg m^-3"), "kg m⁻³");
        assert_eq!(unit_text("x^y"), "x^y");
    }
}
