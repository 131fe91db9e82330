//! Diagnostics in the units and the language of the file: values in the unit that stands at the place or elsewhere in the file, numbers as the language writes
//! them, and help that says what may stand there.

use laval::diagnostic::Diagnostics;
use laval::file::{Form, diagnostics_json_in, load, render_in};
use laval::report::Language;

const MACHINE: &str = r#"[machine]
name = "m"
speed = "3000 rpm"
[[part]]
kind = "disc"
name = "wheel"
mass = "20 lb"
eccentricity = "1 mil"
[[part]]
kind = "bearing_linear"
name = "front"
between = ["wheel", "ground"]
stiffness = "20000 lbf/in"
[[study]]
kind = "modes"
"#;

fn found(file: &str) -> Diagnostics {
    match load(file) {
        Err(found) => found,
        Ok(l) => l.warnings,
    }
}

fn said(language: Language, file: &str) -> String {
    render_in(language, &found(file), file, "m.toml", Form::Lines)
}

fn with(from: &str, to: &str) -> String {
    assert!(MACHINE.contains(from), "{from}");
    MACHINE.replacen(from, to, 1)
}

#[test]
fn values_have_the_unit_that_stands_there() {
    for (file, words) in [
        (with("\"20 lb\"", "\"-2 slug\""), &["mass is -2 slug", "slug"][..]),
        (with("\"1 mil\"", "\"-3 thou\""), &["eccentricity is -3 thou", "thou"]),
        (with("speed = \"3000 rpm\"", "speed = \"-50 Hz\""), &["speed is -50 Hz", "Hz"]),
        // a bare number: in the unit of the file
        (
            with("mass = \"20 lb\"", "mass = -0.45359237") + "[[part]]\nkind = \"disc\"\nname = \"hub\"\nmass = \"3 lb\"\n",
            &["mass is -1 lb", "a bare number is in kg"],
        ),
        (with("mass", "eccentricity_phase = \"1e6 deg\"\nmass"), &["eccentricity_phase is 1e6 deg", "57300 deg"]),
    ] {
        let text = said(Language::English, &file);
        for w in words {
            assert!(text.contains(w), "{w:?} in\n{text}");
        }
        assert!(!text.contains("rad/s") && !text.contains("N/m") && !text.contains(" mm"), "{text}");
        let json = diagnostics_json_in(Language::English, &found(&file), &file).to_string();
        assert!(json.contains(words[0]), "{json}");
    }
}

/// The speed of another block is quoted in the unit in which the file writes speeds, not in rad/s.
#[test]
fn values_from_elsewhere_have_the_units_of_the_file() {
    let operation = format!("{MACHINE}[operation]\nspeed = {{ from = \"1000 rpm\", to = \"2000.5 rpm\" }}\n");
    let text = said(Language::English, &operation);
    assert!(text.contains("the speed of [machine], 3000 rpm, is not among the operating speeds, 1000 rpm to 2000 rpm"), "{text}");
    let hertz = operation.replace("\"3000 rpm\"", "\"50 Hz\"").replace("\"1000 rpm\"", "\"10 Hz\"").replace("\"2000.5 rpm\"", "\"20 Hz\"");
    assert!(said(Language::English, &hertz).contains("50 Hz, is not among the operating speeds, 10 Hz to 20 Hz"));
}

#[test]
fn numbers_are_written_as_the_language_writes_them() {
    let file = with("\"20 lb\"", "\"-2.5 lb\"");
    for (language, number) in
        [(Language::English, "-2.5 "), (Language::Russian, "-2,5 "), (Language::Kazakh, "-2,5 "), (Language::Uzbek, "-2,5 ")]
    {
        let text = said(language, &file);
        let line = text.lines().next().unwrap();
        assert!(line.contains(number), "{line}");
        assert!(language == Language::English || !line.contains("2.5"), "{line}");
    }
    // what is to be written into the file keeps the point
    let percent = format!("{MACHINE}[operation]\nresonance_margin = 2.5\n");
    assert!(said(Language::Russian, &percent).contains("\"2.5 %\""), "{}", said(Language::Russian, &percent));
}

#[test]
fn help_says_what_may_stand_there() {
    let margin = format!("{MACHINE}[operation]\nresonance_margin = \"200 %\"\n");
    let text = said(Language::English, &margin);
    assert!(text.contains("resonance_margin is 200 %; it must be between 0 and 100 %"), "{text}");
    assert!(text.contains("help: give a value between 0 and 100 %"), "{text}");
    let standing = format!("{MACHINE}[operation]\nspeed = \"0 rpm\"\n");
    let text = said(Language::English, &standing);
    assert_eq!(text.matches("error[").count(), 1, "{text}");
    assert!(text.contains("help: write the speed at which the machine runs"), "{text}");
    let from_rest = format!("{MACHINE}[operation]\nspeed = {{ from = \"0 rpm\", to = \"3000 rpm\" }}\n");
    assert!(said(Language::English, &from_rest).contains("lowest speed at which the machine runs in place of 0"));
    let both_ways = format!("{MACHINE}[operation]\nspeed = {{ from = \"-100 rpm\", to = \"3000 rpm\" }}\n");
    let text = said(Language::English, &both_ways);
    assert!(text.contains("-100 rpm") && text.matches("error[").count() == 1, "{text}");
    let pounds = said(Language::English, &with("lbf/in", "lb/in"));
    assert!(pounds.contains("\"20000 lbf/in\""), "{pounds}");
}

const SHAFT: &str = r#"[machine]
name = "m"
speed = "3000 rpm"
[[part]]
kind = "shaft"
name = "shaft"
section = [ { length = "600 mm", outer_diameter = "50 mm" } ]
[[part]]
kind = "bearing_linear"
name = "left"
between = ["shaft", "ground"]
stiffness = "5e7 N/m"
[[part]]
kind = "bearing_linear"
name = "right"
between = [{ body = "shaft", at = "600 mm" }, "ground"]
stiffness = "5e7 N/m"
"#;

/// A place just beside the end of a body is written with the digits that tell the two apart, in any unit.
#[test]
fn a_place_beside_the_end_differs_from_it_in_words() {
    for (at, written) in [("600.0001 mm", "position 600.0001 mm"), ("601 mm", "position 601 mm"), ("-0.0001 mm", "position -0.0001 mm")] {
        let text = said(Language::English, &SHAFT.replacen("at = \"600 mm\"", &format!("at = \"{at}\""), 1));
        assert!(text.contains(written) && text.contains("from 0 mm to 600 mm"), "{text}");
    }
    let inches = SHAFT.replacen("600 mm", "25 in", 1).replacen("600 mm", "25.00001 in", 1);
    let text = said(Language::English, &inches);
    assert!(text.contains("position 25.00001 in") && text.contains("to 25 in"), "{text}");
    let text = said(Language::Russian, &SHAFT.replacen("at = \"600 mm\"", "at = \"600.0001 mm\"", 1));
    assert!(text.contains("600,0001"), "{text}");
}

/// A modulus out of bounds is one mistake; what stands in for it makes no Poisson's ratio.
#[test]
fn nothing_follows_from_a_modulus_out_of_bounds() {
    for key in ["modulus", "shear_modulus"] {
        let text = said(Language::English, &SHAFT.replacen("name = \"shaft\"\n", &format!("name = \"shaft\"\n{key} = \"-210 GPa\"\n"), 1));
        assert!(text.matches("error[").count() == 1 && text.contains(key) && !text.contains("Poisson"), "{text}");
    }
    // two that were read and contradict each other give the message
    let apart = SHAFT.replacen("name = \"shaft\"\n", "name = \"shaft\"\nmodulus = \"10 GPa\"\n", 1);
    assert!(said(Language::English, &apart).contains("Poisson"));
}

/// A block in single brackets of which there may be several is one mistake, wherever it stands.
#[test]
fn single_brackets_are_one_mistake() {
    let first = MACHINE.replacen("[[part]]", "[part]", 1);
    let second = {
        let at = MACHINE.rfind("[[part]]").unwrap();
        format!("{}[part]{}", &MACHINE[..at], &MACHINE[at + 8..])
    };
    let both = MACHINE.replace("[[part]]", "[part]");
    let studies = format!("{}[[study]]\nkind = \"modes\"\nname = \"b\"\n", MACHINE.replace("[[study]]", "[study]"));
    for (file, word) in [(&first, "part"), (&second, "part"), (&both, "part"), (&studies, "study")] {
        let text = said(Language::English, file);
        assert_eq!(text.matches("error[").count(), 1, "{text}");
        assert!(text.contains(&format!("[{word}] needs double brackets")) && text.contains(&format!("write [[{word}]]")), "{text}");
        let line = file.lines().position(|l| l == format!("[{word}]")).unwrap() + 1;
        assert!(text.starts_with(&format!("m.toml:{line}:")), "{line}: {text}");
    }
    // a block that exists once and stands twice is another mistake
    let twice = format!("{MACHINE}[machine]\nname = \"n\"\n");
    assert!(said(Language::English, &twice).contains("[machine] stands twice"));
}

/// Springs that act on displacement alone hold no tilt: the warning says so, and what to do.
#[test]
fn a_chain_of_springs_without_tilt_is_told_what_holds_a_tilt() {
    let chain: String = (1..=3)
        .map(|k| {
            let next = if k < 3 { format!("d{}", k + 1) } else { "ground".into() };
            format!(
                "[[part]]\nkind = \"disc\"\nname = \"d{k}\"\nmass = \"2 kg\"\ndiametral_inertia = \"0.01 kg m^2\"\n\
                 [[part]]\nkind = \"shaft_lumped\"\nname = \"s{k}\"\nbetween = [\"d{k}\", \"{next}\"]\nstiffness = \"5e6 N/m\"\n"
            )
        })
        .collect();
    let file = format!("[machine]\nname = \"chain\"\nspeed = \"3000 rpm\"\n{chain}[[study]]\nkind = \"modes\"\n");
    let text = said(Language::English, &file);
    assert_eq!(text.matches("nothing holds the tilt of").count(), 3, "{text}");
    assert!(text.contains("leave out its diametral_inertia") && !text.contains("join it to"), "{text}");
    let planar = file.replace("diametral_inertia = \"0.01 kg m^2\"\n", "");
    assert_eq!(said(Language::English, &planar), "");
}

/// Words that a message explains are explained in its language.
#[test]
fn meanings_of_words_are_translated() {
    let file = format!("{MACHINE}[report]\nlanguage = \"de\"\n");
    for (language, word) in [(Language::Russian, "русский"), (Language::Kazakh, "қазақ тілі"), (Language::Uzbek, "ingliz tili")]
    {
        let text = said(language, &file);
        assert!(text.contains(word) && !text.contains("Russian") && !text.contains("English"), "{text}");
    }
}
