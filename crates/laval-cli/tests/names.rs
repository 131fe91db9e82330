//! Names of parts and studies in the letters of any script, through the whole program.

use crate::launcher::{Dir, tree};
use std::collections::BTreeSet;

/// A machine with Kazakh names: letters that no other alphabet has, spaces, hyphens.
const MACHINE: &str = r#"
[machine]
name = "желдеткіш <1>"
speed = "1000 rpm"
[[part]]
kind = "disc"
name = "дөңгелек"
mass = "2 kg"
diametral_inertia = "0.01 kg m^2"
polar_inertia = "0.02 kg m^2"
eccentricity = "10 um"
[[part]]
kind = "bearing_linear"
name = "жоғарғы тірек"
between = [{ body = "дөңгелек", at = "50 mm" }, "ground"]
stiffness = "2e6 N/m"
damping = "40 N s/m"
[[part]]
kind = "bearing_linear"
name = "төменгі-тірек_2"
between = [{ body = "дөңгелек", at = "-50 mm" }, "ground"]
stiffness = "2e6 N/m"
damping = "40 N s/m"
[limits]
displacement = { "дөңгелек" = "1 mm" }
force = { "жоғарғы тірек" = "100 N" }
[[study]]
kind = "modes"
name = "Меншікті тербелістер"
[[study]]
kind = "forced_response"
name = "ұйытқу"
speed = { from = "100 rpm", to = "20000 rpm" }
[[study]]
kind = "stability_map"
name = "үш"
speed = { from = "100 rpm", to = "9000 rpm", points = 20 }
parameter = { parameter = "дөңгелек.mass", from = "1 kg", to = "3 kg", points = 3 }
[[study]]
kind = "transient"
name = "іске қосу"
duration = "0.1 s"
initial = { "дөңгелек.x" = "0.1 mm" }
[[study]]
kind = "uncertainty"
name = "рұқсат"
samples = 8
seed = 1
study = "Меншікті тербелістер"
parameters = [{ parameter = "жоғарғы тірек.kxx", distribution = "normal", deviation = "5 %" }]
"#;

#[test]
fn names_in_kazakh_letters_go_through_the_whole_program() {
    let dir = Dir::new("names");
    dir.file("m.toml", MACHINE);
    let said = dir.laval(["check", "m.toml"]);
    assert!(said.done().contains("Меншікті тербелістер"), "{}", said.out);
    let said = dir.laval(["run", "m.toml", "--out", "o", "--lang", "kk", "--all"]);
    assert!(said.done().contains("дөңгелек"), "{}", said.out);
    let files: BTreeSet<String> = tree(&dir.0.join("o")).keys().map(|p| p.to_string_lossy().replace('\\', "/")).collect();
    for part in [
        "Меншікті-тербелістер/modes.csv",
        "ұйытқу/response.csv",
        "үш/",
        "іске-қосу/",
        "рұқсат/manifest.json",
        "figures/ұйытқу-response.svg",
        "figures/Меншікті-тербелістер-shapes.svg",
    ] {
        assert!(files.iter().any(|f| f.starts_with(part)), "{part} in {files:#?}");
    }
    let csv = dir.read("o/ұйытқу/response.csv");
    let header = csv.lines().find(|l| !l.starts_with('#'));
    assert!(header.is_some_and(|l| l.contains("amplitude.дөңгелек")), "{}", &csv[..csv.len().min(300)]);
    let results: serde_json::Value = serde_json::from_str(&dir.read("o/results.json")).unwrap();
    let names: Vec<&str> = results["studies"].as_array().unwrap().iter().filter_map(|s| s["name"].as_str()).collect();
    assert!(names.contains(&"ұйытқу") && names.contains(&"іске қосу"), "{names:?}");
    let page = dir.read("o/report.html");
    assert!(page.contains("жоғарғы тірек") && page.contains("желдеткіш &lt;1&gt;") && !page.contains("желдеткіш <1>"));
    // the same once more, in parts
    dir.laval(["run", "m.toml", "--part", "1/1", "--out", "p", "--quiet"]).done();
    dir.laval(["collect", "m.toml", "--out", "p", "--quiet"]).done();
    assert_eq!(dir.read("p/results.json"), dir.read("o/results.json"));
    // one study by its name
    assert!(dir.laval(["run", "m.toml", "--out", "q", "--only", "ұйытқу", "--quiet"]).done().is_empty());
    assert!(dir.0.join("q/ұйытқу/response.csv").exists() && !dir.0.join("q/үш").exists());
}

/// Names that one file system or another takes for the same have folders of their own.
#[test]
fn folders_of_studies_do_not_collide() {
    let names = ["іске қосу", "Іске қосу 2", "іске-қосу", "ж".repeat(60).as_str(), "кa", "ка"].map(String::from);
    let long = format!("{}б", "ж".repeat(60));
    let all: Vec<&str> = names.iter().map(String::as_str).chain([long.as_str(), "か\u{3099}", "が"]).collect();
    let folders = laval::report::folders(all.iter().copied());
    let distinct: BTreeSet<String> = folders.iter().map(|f| f.to_uppercase().to_lowercase()).collect();
    assert_eq!(distinct.len(), all.len(), "{folders:?}");
    for f in &folders {
        assert!(f.len() <= 150 && !f.starts_with('.') && f.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | '.')), "{f}");
    }
    // letters with signs of their own, which file systems may compose, carry a mark of the exact name
    let marked = &laval::report::folders(["नमस्ते"])[0];
    assert!(marked.rsplit('-').next().is_some_and(|m| m.len() == 8 && m.bytes().all(|b| b.is_ascii_hexdigit())), "{marked}");
    assert_eq!(laval::report::folders(["қозғалтқыш"]), ["қозғалтқыш"]);
}

#[test]
fn what_cannot_be_a_name_is_refused_with_one_that_can() {
    let dir = Dir::new("refused");
    dir.file("m.toml", MACHINE.replace("\"ұйытқу\"", "\"ұйытқу/2\""));
    dir.laval(["check", "m.toml"]).refused(&["name.invalid", "\"ұйытқу_2\"", "letters of any script"]);
    dir.file("n.toml", MACHINE.replace("name = \"үш\"", "name = \"ҰЙЫТҚУ\""));
    dir.laval(["check", "n.toml"]).refused(&["name.twice", "apart from capitals"]);
    dir.file("k.toml", MACHINE.replace("parameter = \"дөңгелек.mass\"", "parameter = \"дөнгелек.mass\""));
    dir.laval(["check", "k.toml"]).refused(&["no part is named \"дөнгелек\"", "did you mean \"дөңгелек\""]);
}
