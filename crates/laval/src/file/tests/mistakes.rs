//! What a person reads after a typical mistake.

use super::*;

/// The example with one text replaced by another.
fn changed(from: &str, to: &str) -> String {
    assert!(EXAMPLE.contains(from), "{from}");
    EXAMPLE.replacen(from, to, 1)
}

fn shown(text: &str) -> String {
    let (spec, d) = read(text, &catalog());
    assert!(spec.is_none() && d.has_errors());
    render(&d, text, "machine.toml", Form::Excerpts { width: 110, colour: false })
}

#[test]
fn typical_mistakes() {
    let mistakes = [
        ("a unit that does not exist", changed("3000 rpm", "3000 rmp")),
        ("a length for a speed", changed("3000 rpm", "70 mm")),
        ("a rate for a speed", changed("3000 rpm", "50 1/s")),
        ("no unit", changed("3000 rpm", "3000")),
        ("no quotes around a quantity", changed("\"2.4 kg\"", "2.4 kg")),
        ("a decimal comma", changed("2.4 kg", "2,4 kg")),
        ("a space in the number", changed("3000 rpm", "3 000 rpm")),
        ("a negative mass", changed("2.4 kg", "-2.4 kg")),
        ("grams as kilograms without unit", changed("\"2.4 kg\"", "2400000")),
        ("a mistyped key", changed("eccentricity =", "excentricity =")),
        ("a key of another part", changed("law =", "rotating =")),
        ("a missing key", changed("density = \"1000 kg/m^3\"\n", "")),
        ("a key twice", changed("name = \"base\"", "name = \"base\"\nname = \"base 2\"")),
        ("a name twice", changed("name = \"base\"", "name = \"Drum\"")),
        ("a name with a dot", changed("name = \"base\"", "name = \"base.lower\"")),
        ("an unknown kind", changed("\"bearing_cubic\"", "\"bearing_cubik\"")),
        ("a kind that is far from all", changed("\"bearing_cubic\"", "\"gearbox\"")),
        ("a missing kind", changed("kind = \"damper\"\n", "")),
        ("a mistyped block", changed("[[study]]", "[[studys]]")),
        ("a kind as block", changed("[[part]]\nkind = \"damper\"", "[[damper]]")),
        ("single brackets", "[machine]\n[part]\nkind = \"disc\"\nmass = \"1 kg\"\n".to_string()),
        ("a wrong word", changed("\"per_axis\"", "\"peraxis\"")),
        ("per cent without their sign", changed("{ free_surface_radius = \"46.7 mm\" }", "{ volume_fraction = 55 }")),
        ("two fills", changed("{ free_surface_radius = \"46.7 mm\" }", "{ volume = \"0.3 l\", mass = \"1 kg\" }")),
        ("a fill without a name", changed("{ free_surface_radius = \"46.7 mm\" }", "\"0.3 l\"")),
        ("a fill as a key of its own", changed("fill = { free_surface_radius = \"46.7 mm\" }", "volume_fraction = 0.5")),
        ("a torque per angle for a stiffness", changed("1.1e7 N/m\"", "1.1e7 N m/rad\"")),
        ("only one direction", changed("\"1.1e7 N/m\"", "{ x = \"1e7 N/m\" }")),
        ("one end only", changed("[\"drum\", \"base\"]", "[\"drum\"]")),
        ("a range without end", changed(", to = \"8000 rad/s\"", "")),
        ("an infinite end", changed("\"8000 rad/s\"", "inf")),
        ("too many points", changed("to = \"8000 rad/s\"", "to = \"8000 rad/s\", points = 10_000_000")),
        ("a whole number in quotes", changed("\"auto\"", "\"7\"")),
        ("a missing quotation mark", changed("\"2.4 kg\"", "\"2.4 kg")),
        ("a missing brace", changed("\"46.7 mm\" }", "\"46.7 mm\"")),
        ("a missing bracket", changed("[\"drum\", \"base\"]", "[\"drum\", \"base\"")),
        ("a header that is not closed", changed("[[study]]", "[[study]")),
        ("a line that is nothing", changed("density = \"1000 kg/m^3\"", "the density is 1000 kg/m^3")),
        ("an ambiguous unit", changed("6.59 N s/m", "6.59 N/m s")),
        ("units written together", changed("42 N s/m", "42 Nsm")),
        ("nothing but a machine", "[machine]\n".to_string()),
        ("no machine", "[[part]]\nkind = \"disc\"\nmass = \"1 kg\"\n".to_string()),
        ("keys outside of blocks", "name = \"pump\"\n[machine]\n[[part]]\nkind = \"disc\"\nmass = \"1 kg\"\n".to_string()),
        (
            "single brackets each time",
            format!("{EXAMPLE}\n[study]\nkind = \"modes\"\n\n[study]\nkind = \"modes\"\nspeed = \"1 rpm\"\n")
                .replace("[[study]]", "[study]"),
        ),
        ("type for kind", changed("kind = \"damper\"", "type = \"damper\"")),
        ("a unit like no other", changed("42 N s/m", "42 bananas")),
        ("a machine twice", format!("{EXAMPLE}\n[machine]\n")),
        (
            "an unknown part in a sweep",
            format!("{EXAMPLE}\n[[study]]\nkind = \"sweep\"\nover = {{ parameter = \"drun.mass\", from = \"1 kg\", to = \"2 kg\" }}\n"),
        ),
        (
            "an unknown parameter in a sweep",
            format!("{EXAMPLE}\n[[study]]\nkind = \"sweep\"\nover = {{ parameter = \"drum.masss\", from = \"1 kg\", to = \"2 kg\" }}\n"),
        ),
        (
            "a wrong unit in a sweep",
            format!("{EXAMPLE}\n[[study]]\nkind = \"sweep\"\nover = {{ parameter = \"drum.mass\", from = \"1 mm\", to = \"2 kg\" }}\n"),
        ),
        (
            "columns of unequal length",
            format!("{EXAMPLE}\n[[part]]\nkind = \"bearing_table\"\non = \"ground\"\ntable = {{ speed = [1, 2], kxx = [1.0] }}\n"),
        ),
    ];
    let mut all = String::new();
    for (what, text) in &mistakes {
        all += &format!("==== {what} ====\n{}\n", shown(text).trim_end());
    }
    insta::assert_snapshot!(all);
}

#[test]
fn all_mistakes_come_together_in_order() {
    let text = changed("2.4 kg", "2.4 m").replace("\"per_axis\"", "7").replace("42 N s/m", "42 N").replace("3000 rpm", "fast");
    let (_, d) = read(&text, &catalog());
    let lines = render(&d, &text, "machine.toml", Form::Lines);
    insta::assert_snapshot!(lines);
    let starts: Vec<usize> = d.0.iter().map(|d| d.span.clone().unwrap().start).collect();
    assert!(starts.is_sorted());
}

#[test]
fn a_file_that_is_not_text() {
    let mut bytes = EXAMPLE.as_bytes().to_vec();
    bytes[40] = 0xb5;
    let (spec, d) = read_bytes(&bytes, &catalog());
    assert!(spec.is_none());
    assert_eq!((d.0.len(), d.0[0].code, d.0[0].span.clone()), (1, "file.encoding", Some(40..41)));
    let utf16: Vec<u8> = [0xff, 0xfe].into_iter().chain(EXAMPLE.encode_utf16().flat_map(u16::to_le_bytes)).collect();
    assert!(read_bytes(&utf16, &catalog()).1.0[0].help.as_ref().unwrap().contains("UTF-16"));
    let with_mark: Vec<u8> = [0xef, 0xbb, 0xbf].into_iter().chain(EXAMPLE.bytes()).collect();
    let (spec, d) = read_bytes(&with_mark, &catalog());
    assert!(spec.is_some(), "{d:?}");
}

#[test]
fn one_mistake_is_said_once() {
    for (from, to) in [
        ("\"2.4 kg\"", "2.4 kg"),
        ("\"2.4 kg\"", "\"2.4 kg"),
        ("[[study]]", "[[study]"),
        ("3000 rpm", "3000 rmp"),
        ("\"disc\"", "\"disk\""),
        ("\"46.7 mm\" }", "\"46.7 mm\""),
        ("[\"drum\", \"base\"]", "[\"drum\", \"base\""),
        ("{ from = \"25 rad/s\", to = \"8000 rad/s\" }", "{ from = \"25 rad/s\", to = \"8000 rad/s\""),
        ("[\"drum\", \"base\"]", "[{ body = \"drum\", at = \"1 mm\", \"base\"]"),
    ] {
        let text = changed(from, to);
        let (_, d) = read(&text, &catalog());
        assert_eq!(d.0.len(), 1, "{from} -> {to}: {}", render(&d, &text, "machine.toml", Form::Lines));
    }
}

#[test]
fn tables_over_several_lines_are_no_mistake() {
    let lines = "{\n  free_surface_radius = \"46.7 mm\", # the inner face\n}";
    good(&changed("{ free_surface_radius = \"46.7 mm\" }", lines));
    // nor are they blamed for a later one
    let text =
        changed("speed = { from = \"25 rad/s\", to = \"8000 rad/s\" }", "speed = {\n  from = \"25 rad/s\",\n\n  to = \"8000 rad/s\",\n}")
            .replace("\"auto\"", "auto");
    let (_, d) = read(&text, &catalog());
    assert_eq!(d.0.len(), 1, "{d:?}");
    assert!(d.0[0].help.as_deref().is_some_and(|h| h.starts_with("write harmonics = \"auto\" (so far only the syntax")), "{d:?}");
}
