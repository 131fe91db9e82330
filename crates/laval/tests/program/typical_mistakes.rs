//! What an engineer reads after a typical mistake: the text that `laval check` or `laval run` prints where no terminal is attached, and once as
//! it looks on a terminal.

use laval::diagnostic::{Diagnostic, Diagnostics};
use laval::file::{Form, load, render};
use laval::study::Context;
use laval::text;

const MACHINE: &str = r#"[machine]
name = "oil separator"
speed = "3000 rpm"

[[part]]
kind = "disc"
name = "drum"
mass = "2.4 kg"
eccentricity = "20 um"

[[part]]
kind = "foundation"
name = "housing"
mass = "25 kg"
stiffness = "3.26e5 N/m"
damping = "6.59 N s/m"

[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "housing"]
law = "per_axis"
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"

[[part]]
kind = "liquid"
name = "oil"
in = "drum"
cavity_radius = "70 mm"
cavity_height = "60 mm"
density = "880 kg/m^3"
fill = { free_surface_radius = "46.7 mm" }

[[study]]
kind = "nonlinear_response"
speed = { from = "25 rad/s", to = "5000 rad/s" }
"#;

/// The machine with some texts replaced.
fn changed(edits: &[(&str, &str)]) -> String {
    edits.iter().fold(MACHINE.to_string(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    })
}

/// What is wrong with a file, or else the first refusal of its studies.
fn found(text: &str) -> Diagnostics {
    match load(text) {
        Err(found) => found,
        Ok(l) => {
            let refused = l.studies.iter().find_map(|s| {
                let d = s.study.run(&l.system, &Context::quiet("study")).err()?;
                let span = d.span.clone().or_else(|| l.spec.study(&s.name)?.span.clone());
                Some(Diagnostic { message: text!("study \"{name}\": {message}", name = s.name, message = d.message), ..d }.at(span))
            });
            Diagnostics(vec![refused.expect("neither the file nor a study is wrong")])
        }
    }
}

const HERTZ: &str = "kind = \"bearing_hertz\"\nname = \"bearing\"\nbetween = [\"drum\", \"housing\"]\nlaw = \"radial\"\ncoefficient = \"1e9 N/m^1.5\"\nclearance = \"10 um\"\n";

fn mistakes() -> Vec<(&'static str, String)> {
    let one = |from: &str, to: &str| changed(&[(from, to)]);
    let study = |text: &str| format!("{}{text}", MACHINE.split("[[study]]").next().unwrap_or_default());
    let bearing = MACHINE.split("[[part]]\n").nth(3).unwrap_or_default().trim_end().to_string() + "\n";
    vec![
        ("negative mass", one("\"2.4 kg\"", "\"-2.4 kg\"")),
        ("fill above 1", one("{ free_surface_radius = \"46.7 mm\" }", "{ volume_fraction = 1.2 }")),
        ("fill in percent", one("{ free_surface_radius = \"46.7 mm\" }", "{ volume_fraction = \"55\" }")),
        ("free surface outside the cavity", one("46.7 mm", "76.7 mm")),
        ("more liquid than the cavity holds", one("{ free_surface_radius = \"46.7 mm\" }", "{ volume = \"2 l\" }")),
        ("eccentricity of 10 m", one("20 um", "10 m")),
        ("rpm given for a length", one("\"20 um\"", "\"20 rpm\"")),
        ("missing unit", one("\"3000 rpm\"", "\"3000\"")),
        ("no quotes", one("\"2.4 kg\"", "2.4 kg")),
        ("unknown unit", one("3000 rpm", "3000 rmp")),
        ("unit of another quantity", one("1.1e7 N/m\"", "1.1e7 N\"")),
        ("misspelt key", one("eccentricity =", "excentricity =")),
        ("unknown kind", one("bearing_cubic", "bearing_qubic")),
        ("missing required key", one("density = \"880 kg/m^3\"\n", "")),
        ("missing body", one("[\"drum\", \"housing\"]", "[\"drum\", \"casing\"]")),
        ("a body that is none", one("in = \"drum\"", "in = \"bearing\"")),
        ("duplicate names", one("name = \"housing\"", "name = \"drum\"")),
        ("a response through standstill", one("from = \"25 rad/s\"", "from = \"-25 rad/s\"")),
        ("a range the wrong way round", study("[[study]]\nkind = \"campbell\"\nspeed = { from = \"6000 rpm\", to = \"0 rpm\" }\n")),
        (
            "a table that goes backwards",
            one(
                &bearing,
                "kind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"drum\", \"housing\"]\ntable = { speed = [\"300 rpm\", \"200 rpm\"], kxx = [1e7, 2e7], kyy = [1e7, 2e7] }\n\n",
            ),
        ),
        ("harmonics below the subharmonic", format!("{MACHINE}subharmonic = 3\nharmonics = 2\n")),
        (
            "polar inertia above twice the diametral",
            one("eccentricity = \"20 um\"", "polar_inertia = \"0.05 kg m^2\"\ndiametral_inertia = \"0.02 kg m^2\""),
        ),
        ("law missing", one("law = \"per_axis\"\n", "")),
        (
            "modes of a bearing without tangent at rest",
            study("[[study]]\nkind = \"modes\"\n").replace(bearing.trim_end(), HERTZ.trim_end()),
        ),
        ("speed missing for modes", study("[[study]]\nkind = \"modes\"\n").replace("speed = \"3000 rpm\"\n", "")),
        ("a bracket forgotten", one("[\"drum\", \"housing\"]", "[\"drum\", \"housing\"")),
        ("a quotation mark forgotten", one("\"25 kg\"", "\"25 kg")),
        ("two mistakes at once", changed(&[("2.4 kg", "2.4 m"), ("law = \"per_axis\"", "law = \"peraxis\"")])),
    ]
}

#[test]
fn texts_of_typical_mistakes() {
    let mut all = String::new();
    for (what, text) in mistakes() {
        let d = found(&text);
        assert!(d.has_errors() && d.0.iter().all(|d| d.span.is_some()), "{what}: {d:?}");
        all += &format!("==== {what}\n{}\n", render(&d, &text, "machine.toml", Form::Lines));
    }
    insta::assert_snapshot!(all);
}

#[test]
fn two_mistakes_on_a_terminal() {
    let (_, text) = mistakes().pop().expect("the last one");
    insta::assert_snapshot!(render(&found(&text), &text, "machine.toml", Form::Excerpts { width: 100, colour: false }));
}
