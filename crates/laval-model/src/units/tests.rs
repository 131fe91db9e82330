use super::*;
use std::f64::consts::PI;

#[test]
fn conversions() {
    let table: &[(&str, &str, f64)] = &[
        ("3000 rpm", "rad/s", 100.0 * PI),
        ("60 Hz", "rad/s", 120.0 * PI),
        ("1 kHz", "rad/s", 2000.0 * PI),
        ("50 rev/s", "rad/s", 100.0 * PI),
        ("360 deg/s", "rad/s", 2.0 * PI),
        ("2 krpm", "rad/s", 4000.0 * PI / 60.0),
        ("60 Hz", "1/s", 60.0),
        ("60 1/s", "1/s", 60.0),
        ("60 /s", "1/s", 60.0),
        ("60/s", "1/s", 60.0),
        ("60 s^-1", "1/s", 60.0),
        ("60 s⁻¹", "1/s", 60.0),
        ("60 s-1", "1/s", 60.0),
        ("120 1/min", "1/s", 2.0),
        ("70 mm", "m", 0.07),
        ("46.7 mm", "m", 0.0467),
        ("46.7mm", "m", 0.0467),
        ("12 µm", "m", 12e-6),
        ("12 μm", "m", 12e-6),
        ("12 um", "m", 12e-6),
        ("1.1e7 N/m", "N/m", 1.1e7),
        ("11 MN/m", "N/m", 1.1e7),
        ("11 kN/mm", "N/m", 1.1e7),
        ("11000 N/mm", "N/m", 1.1e7),
        ("30 g mm", "kg m", 30e-6),
        ("30 g·mm", "kg m", 30e-6),
        ("30 g*mm", "kg m", 30e-6),
        ("8.7e10 N/m^3", "N/m^3", 8.7e10),
        ("8.7e10 N/m³", "N/m^3", 8.7e10),
        ("87 N/mm3", "N/m^3", 8.7e10),
        ("87 N/mm**3", "N/m^3", 8.7e10),
        ("6.59 N s/m", "N s/m", 6.59),
        ("6.59 Ns/m", "N s/m", 6.59),
        ("1e5 N/m^1.5", "N/m^1.5", 1e5),
        ("1 N/mm^1.5", "N/m^1.5", 10f64.powf(4.5)),
        ("1 N/m^(10/9)", "N/m^(10/9)", 1.0),
        ("0.3 l", "m^3", 3e-4),
        ("300 ml", "m^3", 3e-4),
        ("300 cm^3", "m^3", 3e-4),
        ("25 cSt", "m^2/s", 25e-6),
        ("12 bar", "Pa", 1.2e6),
        ("12 bar", "N/m^2", 1.2e6),
        ("5 deg", "rad", 5.0 * PI / 180.0),
        ("5°", "rad", 5.0 * PI / 180.0),
        ("20 kW", "W", 2e4),
        ("10 mPa s", "Pa s", 0.01),
        ("10 cP", "Pa s", 0.01),
        ("50 %", "", 0.5),
        ("50%", "", 0.5),
        ("0.5", "", 0.5),
        ("20 degC", "K", 293.15),
        ("20 °C", "K", 293.15),
        ("300 K", "K", 300.0),
        ("-40 degC", "K", 233.15),
        ("1 g/cm^3", "kg/m^3", 1000.0),
        ("5 N m/rad", "N m/rad", 5.0),
        ("5 N m", "N m/rad", 5.0),
        ("1 N m/deg", "N m/rad", 180.0 / PI),
        ("5 N m s", "N m s/rad", 5.0),
        ("5 N m s/rad", "N m s/rad", 5.0),
        ("5 Nm", "N m", 5.0),
        ("5 kNm", "N m", 5000.0),
        ("5 N*m", "N m", 5.0),
        ("2 kJ", "J", 2000.0),
        ("1 kWh", "J", 3.6e6),
        ("0.001 in", "m", 2.54e-5),
        ("1 mil", "m", 2.54e-5),
        ("2 lb", "kg", 0.90718474),
        ("1 slug", "kg", 14.593902937206365),
        ("1000 lbf/in", "N/m", 175126.83524647637),
        ("1 gn", "m/s^2", 9.80665),
        ("5 W/(m^2 K)", "W/(m^2 K)", 5.0),
        ("1 N/m/s", "N/(m s)", 1.0),
        ("3 rpm/s", "rad/s^2", 0.1 * PI),
        ("1_000 kg", "kg", 1000.0),
        ("−3 mm", "m", -0.003),
        ("+3 mm", "m", 0.003),
        ("1e-3 m", "m", 1e-3),
        (".5 m", "m", 0.5),
        ("5. m", "m", 5.0),
        ("1 kg m²", "kg m^2", 1.0),
        ("5 mΩ", "Ohm", 5e-3),
        ("2 V s/rad", "V s/rad", 2.0),
        ("1 t", "kg", 1000.0),
        ("60 l/min", "m^3/s", 1e-3),
        ("1 mm/s", "m/s", 1e-3),
    ];
    for &(text, unit, value) in table {
        let got = read_quantity(text, unit).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert!((got - value).abs() <= 4e-16 * value.abs(), "{text} -> {got}, expected {value}");
    }
}

#[test]
fn decimal_prefixes_round_once() {
    for (text, unit, value) in [
        ("46.7 mm", "m", 0.0467),
        ("0.1 µm", "m", 0.1e-6),
        ("3.3 g mm", "kg m", 3.3e-6),
        ("7.7 MN/m", "N/m", 7.7e6),
        ("1.3 N/mm^3", "N/m^3", 1.3e9),
    ] {
        assert_eq!(read_quantity(text, unit).unwrap(), value, "{text}");
    }
}

#[test]
fn mistakes_are_said_well() {
    let say = |text: &str, unit: &str| read_quantity(text, unit).map_or_else(|e| e.to_string(), |v| panic!("{text} read as {v}"));
    let table: &[(&str, &str, &str)] = &[
        ("70 mm", "rad/s", "a speed is needed (rad/s, rpm, Hz); \"70 mm\" is a length"),
        (
            "50 1/s",
            "rad/s",
            "a speed is needed (rad/s, rpm, Hz); \"50 1/s\" leaves open whether turns or radians are meant (for turns write rpm, Hz or rev; for radians write rad)",
        ),
        ("50 rad/s", "1/s", "a rate is needed (1/s, 1/min); \"50 rad/s\" is a speed"),
        ("5 J", "N m", "a torque is needed (N m, kN m); \"5 J\" is an energy"),
        ("5 N m", "J", "an energy is needed (J, kJ); \"5 N m\" is a torque"),
        ("5 N m/rad", "N m", "a torque is needed (N m, kN m); \"5 N m/rad\" is a rotational stiffness"),
        (
            "3000",
            "rad/s",
            "a speed is needed, and \"3000\" has no unit (write the unit behind the number (rad/s, rpm, Hz); without quotes a number is in rad/s)",
        ),
        ("3000 rmp", "rad/s", "\"rmp\" is not a known unit (did you mean \"rpm\"?)"),
        ("3000 RPM", "rad/s", "\"RPM\" is not a known unit (did you mean \"rpm\"?)"),
        ("5 kn", "N", "\"kn\" is not a known unit (did you mean \"kN\"?)"),
        ("5 mPas", "Pa s", "\"mPas\" is not a known unit (did you mean \"mPa s\"?)"),
        (
            "1000 lb/in",
            "N/m",
            "a stiffness is needed (N/m, N/mm, MN/m); \"1000 lb/in\" is a mass per length (lb is a mass; the force is lbf: write \"1000 lbf/in\")",
        ),
        ("5 gmm", "kg m", "\"gmm\" is not a known unit (did you mean \"g mm\"?)"),
        ("fast", "rad/s", "a quantity is a number and a unit; \"fast\" begins with no number (write it as in \"70 mm\")"),
        ("", "m", "a quantity is a number and a unit; this text is empty (write it as in \"70 mm\")"),
        ("1,5 mm", "m", "\"1,5 mm\" has a comma in its number (write the decimal point, as in \"1.5 mm\", and no separators)"),
        ("3 000 rpm", "rad/s", "\"3 000 rpm\" has a space inside its number (write the digits together, as in \"3000 rpm\")"),
        ("1.1 x 10^7 N/m", "N/m", "\"1.1 x 10^7 N/m\" writes a power of ten in words (write it as in \"1.1e7 N/m\")"),
        (
            "5 N/m s",
            "N s/m",
            "\"N/m s\" has two readings: is what follows the / and a space above or below it? (put products below a / in parentheses, as in N/(m s), or write them first, as in N s/m)",
        ),
        ("nan mm", "m", "a finite number is needed, not nan"),
        ("-inf mm", "m", "a finite number is needed, not inf"),
        ("1e400 m", "m", "the number is too large"),
        ("1e306 km", "mm", "the number is too large"),
        ("1e-400 m", "m", "the number is too small to be distinguished from 0"),
        ("20 degC/s", "K/s", "a temperature in degC stands alone (for differences and in products write K)"),
        ("5 m^", "m", "a power is a number, as in m^2, m^1.5 or m^(10/9)"),
        ("5 N/(m s", "N/(m s)", "a closing parenthesis is missing"),
    ];
    for (text, unit, message) in table {
        assert_eq!(&say(text, unit), message, "{text}");
    }
}

#[test]
fn display() {
    for (x, unit, text) in [
        (0.07, "m", "70 mm"),
        (1.1e7, "N/m", "11 MN/m"),
        (25.0, "rad/s", "25 rad/s (238.7 rpm)"),
        (30e-6, "kg m", "30 g mm"),
        (3e-4, "m^3", "300 ml"),
        (0.0, "m", "0 m"),
        (1e15, "N/m", "1e15 N/m"),
        (-2.5e-6, "m", "-2.5 µm"),
        (1e-30, "m", "1e-30 m"),
        (0.5, "", "0.5"),
        (2.4, "kg", "2.4 kg"),
        (0.9999999, "m", "1 m"),
        (1234.5678, "kg", "1235 kg"),
        (1e6, "kg", "1e6 kg"),
        (8.7e10, "N/m^3", "87 GN/m^3"),
        (293.15, "K", "293.1 K (20 degC)"),
        (f64::NAN, "m", "not a number"),
        (0.01, "Pa s", "10 mPa s"),
        (25e-6, "m^2/s", "25 mm^2/s"),
        (1200.0, "m", "1200 m"),
    ] {
        assert_eq!(format_si(x, unit, DIGITS), text);
    }
}

#[test]
fn values_are_read_in_the_units_of_the_file() {
    let imperial = ["lbf/in", "in", "slug", "rpm", "degC", "N m/deg", "%"];
    for (x, unit, number, name) in [
        (-0.0508, "m", "-2", "in"),
        (2.54e-7, "m", "1e-5", "in"),
        (175_126.835, "N/m", "1000", "lbf/in"),
        (29.1878, "kg", "2", "slug"),
        (314.159265, "rad/s", "3000", "rpm"),
        (293.15, "K", "20", "degC"),
        (180.0 / PI, "N m/rad", "1", "N m/deg"),
        (1.1e7, "N s/m", "11", "MN s/m"),
        (0.25, "", "25", "%"),
        (f64::NAN, "m", "not a number", ""),
    ] {
        assert_eq!(read_in(&imperial, x, unit, DIGITS), (number.into(), name.into()), "{x} {unit}");
    }
    // the first that measures it readably; a torque is no energy, a rate no speed
    assert_eq!(read_in(&["m", "µm"], 2e-5, "m", DIGITS), ("20".into(), "µm".into()));
    assert_eq!(read_in(&["J", "Hz"], 5.0, "N m", DIGITS), ("5".into(), "N m".into()));
    assert_eq!(read_in(&["Hz"], 5.0, "1/s", DIGITS), ("5".into(), "1/s".into()));
    for (text, unit) in [("46.7mm", Some("mm")), ("3 N m/rad", Some("N m/rad")), ("5", None), ("fast", None), ("3 furlongs", None)] {
        assert_eq!(unit_of(text), unit);
    }
}

#[test]
fn every_word_of_the_table_reads() {
    for unit in ["m", "kg", "N/m", "rad/s", "Pa s", "W/K", "N m/A", "V s/rad", "", "J"] {
        for e in examples(unit).split(", ") {
            let text = if unit.is_empty() { e.to_string() } else { format!("1 {e}") };
            assert!(read_quantity(&text, unit).is_ok(), "{text} for {unit}");
        }
    }
}

proptest::proptest! {
    #[test]
    fn written_quantities_read_back_exactly(bits: u64, i in 0usize..16) {
        let unit = ["m", "kg", "rad/s", "rad", "N/m", "N/m^3", "N s/m", "", "kg m", "m^3", "K", "1/s", "N/m^1.5", "m^2/s", "J", "N m/rad"][i];
        let x = f64::from_bits(bits);
        if x.is_finite() {
            let text = write_si(x, unit);
            proptest::prop_assert_eq!(read_quantity(&text, unit), Ok(x), "{}", text);
        }
    }

    #[test]
    fn any_text_is_answered(text in "\\PC{0,24}", i in 0usize..4) {
        if let Ok(x) = read_quantity(&text, ["m", "rad/s", "", "N m/rad"][i]) {
            proptest::prop_assert!(x.is_finite());
        }
        let _ = read_any(&text);
    }

    #[test]
    fn unit_like_text_is_answered(text in "-?[0-9]{1,3}(\\.[0-9]|e[0-9]{1,3}|,)? ?[kmµ]?(N|m|rad|s|Hz|degC|°|%|mm)[/ ^()*0-9²⁻.-]{0,6}(m|s|rad)?[)]?") {
        if let Ok((x, u)) = read_any(&text) {
            proptest::prop_assert!(x.is_finite() && u.factor().is_finite());
        }
    }
}
