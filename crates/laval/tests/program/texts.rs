//! What people read: numbers with units, shares in per cent, advice that can be followed, and whose a number is.

use laval::file::{Form, load, load_bytes, render};
use laval::outcome::{Data, Outcome, SpecialPoint, Status};
use laval::report::{Report, html};
use laval::study::Context;

const MACHINE: &str = r#"[machine]
name = "rotor"
speed = "3000 rpm"

[[part]]
kind = "disc"
name = "drum"
mass = "2.4 kg"
polar_inertia = "0.02 kg m^2"
diametral_inertia = "0.012 kg m^2"
eccentricity = "20 um"

[[part]]
kind = "shaft_lumped"
name = "spindle"
between = ["drum", "ground"]
stiffness = "1.6e6 N/m"
tilt_stiffness = "1e4 N m/rad"

[[part]]
kind = "damper"
name = "losses"
between = ["drum", "ground"]
damping = "42 N s/m"

"#;

/// Everything said of a file that cannot be used, and of one whose studies are refused.
fn said(text: &str) -> String {
    let found = match load(text) {
        Err(found) => found,
        Ok(l) => laval::diagnostic::Diagnostics(l.refusals().into_iter().map(|r| r.diagnostic).collect()),
    };
    render(&found, text, "m.toml", Form::Lines)
}

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{}", render(&d, text, "m.toml", Form::Lines)));
    let last = loaded.studies.last().expect("a study");
    last.study.run(&loaded.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{d:?}"))
}

#[test]
fn the_value_at_which_a_machine_does_not_exist_has_its_unit() {
    let study = r#"[[study]]
kind = "stability_map"
speed = { from = "10 rpm", to = "5000 rpm" }
parameter = { parameter = "drum.polar_inertia", from = "0.01 kg m^2", to = "0.03 kg m^2" }
"#;
    let said = said(&format!("{MACHINE}{study}"));
    assert!(said.contains("drum.polar_inertia = 0.03 kg m²"), "{said}");
}

#[test]
fn a_limit_that_is_printed_can_be_written_into_the_file() {
    let with = |coupling: &str| MACHINE.replace("tilt_stiffness", &format!("coupling = \"{coupling}\"\ntilt_stiffness"));
    // sqrt(1.6e6 * 1e4) = 126491.106..
    let reported = said(&with("2e5 N/rad"));
    let limit = reported.split("= ").nth(1).and_then(|t| t.split(':').next()).expect("a limit").to_string();
    assert!(limit.len() < 16 && limit.ends_with("N/rad"), "{reported}");
    assert!(load(&with(&limit)).is_ok(), "{limit}: {}", said(&with(&limit)));
    let (number, prefix) = limit.trim_end_matches("N/rad").split_once(' ').expect("a unit");
    let value = number.parse::<f64>().expect("a number") * if prefix == "k" { 1e3 } else { 1.0 };
    assert!((value / (1.6e6f64 * 1e4).sqrt() - 1.0).abs() < 1e-3, "{limit}");
}

#[test]
fn bytes_that_no_text_holds_are_reported_once() {
    let utf16: Vec<u8> = MACHINE.bytes().flat_map(|b| [b, 0]).collect();
    for bytes in [utf16, MACHINE.replace("drum", "dr\0um").into_bytes()] {
        let found = load_bytes(&bytes).err().expect("no text");
        assert_eq!(found.0.iter().map(|d| d.code).collect::<Vec<_>>(), ["file.binary"]);
        assert!(found.0[0].message.contains("NUL"), "{found:?}");
    }
    let bell = said(&MACHINE.replace("\"drum\"\nmass", "\"dr\u{7}um\"\nmass"));
    assert!(bell.contains("control character 0x07") && bell.contains("remove it"), "{bell}");
}

#[test]
fn a_mistake_of_syntax_says_what_was_not_looked_at() {
    let hidden = MACHINE.replace("between = [\"drum\"", "between = [\"drom\"");
    let one = said(&hidden.replace("\"2.4 kg\"", "\"2.4 kg"));
    assert_eq!(one.matches("only the syntax and single values were checked").count(), 1, "{one}");
    let two = said(&hidden.replace("\"2.4 kg\"", "\"2.4 kg").replace("\"20 um\"", "20 um"));
    assert_eq!(two.matches("only the syntax and single values were checked").count(), 1, "{two}");
    assert!(!said(&hidden).contains("only the syntax"), "{}", said(&hidden));
}

#[test]
fn a_study_that_runs_another_does_not_offer_itself() {
    let uncertain = |study: &str| {
        format!(
            "[[study]]\nkind = \"uncertainty\"\nname = \"tolerances\"\nstudy = \"{study}\"\n\
             parameters = [{{ parameter = \"drum.mass\", distribution = \"normal\", deviation = \"2 %\" }}]\n"
        )
    };
    let modes = "[[study]]\nkind = \"modes\"\n";
    for name in ["mode", "tolerance", "tolerances"] {
        let reported = said(&format!("{MACHINE}{modes}{}", uncertain(name)));
        assert!(reported.contains("tudies of this file that can be run: modes\n"), "{reported}");
        assert!(!reported.contains("did you mean \"tolerances\""), "{reported}");
    }
    let alone = said(&format!("{MACHINE}{}", uncertain("modes")));
    assert!(alone.contains("{ kind = \"modes\", .. }"), "{alone}");
}

#[test]
fn numbers_of_samples_say_what_and_whose_they_are() {
    let text = |study: &str, parameter: &str| {
        format!(
            "{MACHINE}{study}[[study]]\nkind = \"uncertainty\"\nstudy = \"inner\"\nparameters = [{{ parameter = {parameter} }}]\nsamples = 16\n"
        )
    };
    let normal = "\"drum.mass\", distribution = \"normal\", deviation = \"2 %\"";
    let names = |o: &Outcome| match &o.find_table("quantities").and_then(|t| t.column("quantity")).expect("all numbers").data {
        Data::Text(v) => v.clone(),
        other => panic!("{other:?}"),
    };
    let modes = names(&run(&text("[[study]]\nkind = \"modes\"\nname = \"inner\"\n", normal)));
    assert!(modes.iter().any(|n| n == "least_damped_mode damping ratio"), "{modes:?}");
    let critical = "[[study]]\nkind = \"critical_speeds\"\nname = \"inner\"\nspeed = { from = \"10 rpm\", to = \"20000 rpm\" }\n";
    let found = names(&run(&text(critical, normal)));
    assert!(found.iter().any(|n| n == "margin to the nearest critical speed, over the operating speed"), "{found:?}");
    assert!(found.iter().any(|n| n.starts_with("response_peak drum")), "{found:?}");
    // samples that fail are reported with a number, not with a gap in its place
    let wide = "\"drum.polar_inertia\", distribution = \"uniform\", from = \"0.02 kg m^2\", to = \"0.03 kg m^2\"";
    let o = run(&text("[[study]]\nkind = \"modes\"\nname = \"inner\"\n", wide));
    let failed = o.findings.iter().find(|f| f.id == "failed_samples").expect("some samples have no machine").sentence();
    assert!(failed.contains("for instance sample") && !failed.contains(".."), "{failed}");
}

#[test]
fn the_bracket_of_a_point_that_was_solved_for_is_no_width_of_doubt() {
    let point = |kind: &str| SpecialPoint::new(kind, 100.0, (90.0, 97.0 + 10.0)).of("drum");
    let o = Outcome::new("critical_speeds", "study")
        .over("speed", "rad/s")
        .special_point(point("peak"))
        .special_point(point("jump").status(Status::Bracketed))
        .special_point(SpecialPoint::new("fold", 100.0, (100.0, 100.0 + 1e-8)));
    let page = html(&Report { outcomes: vec![o], ..Report::default() }).expect("a page");
    let row = |kind: &str| page.split("<tr>").find(|r| r.contains(&format!(">{kind}"))).unwrap_or_else(|| panic!("{kind}")).to_string();
    assert!(row("peak").contains(">peak, drum<") && row("peak").contains("<td>–</td>"), "{}", row("peak"));
    assert!(row("jump").contains("<td>17</td>"), "{}", row("jump"));
    assert!(row("fold").contains("10⁻⁸"), "{}", row("fold"));
}

#[test]
fn a_share_of_the_force_is_reported_in_per_cent() {
    let rub = r#"[machine]
[[part]]
kind = "disc"
name = "drum"
mass = "2 kg"
eccentricity = "50 um"
[[part]]
kind = "shaft_lumped"
between = ["drum", "ground"]
stiffness = { x = "1e6 N/m", y = "1.4e6 N/m" }
[[part]]
kind = "damper"
between = ["drum", "ground"]
damping = "30 N s/m"
[[part]]
kind = "stop"
between = ["drum", "ground"]
stiffness = "1e9 N/m"
gap = "60 um"
[[study]]
kind = "nonlinear_response"
speed = { from = "300 rad/s", to = "800 rad/s" }
"#;
    let o = run(rub);
    let short = o.findings.iter().find(|f| f.id == "harmonics_short").expect("a hard stop needs many orders").sentence();
    assert!(short.contains("leave out 100 % of the nonlinear force"), "{short}");
}
