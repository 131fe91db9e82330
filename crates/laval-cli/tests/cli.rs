//! The program from outside: what it prints, writes and returns.

use crate::launcher::{Dir, Said};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const TEMPLATES: [&str; 9] = [
    "rigid-rotor",
    "oil-separator",
    "overhung-disc",
    "ball-balancer",
    "cup-separator",
    "spatial-liquid",
    "viscoelastic-shaft",
    "three-disc-rotor",
    "cream-separator",
];

/// A machine with one mode pair, and a quick study.
const SMALL: &str = r#"
[machine]
name = "small"
speed = "1000 rpm"
[[part]]
kind = "disc"
name = "drum"
mass = "2 kg"
eccentricity = "10 um"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "ground"]
law = "isotropic"
stiffness = "2e6 N/m"
cubic_stiffness = "1e12 N/m^3"
[[part]]
kind = "damper"
between = ["drum", "ground"]
damping = "40 N s/m"
[[study]]
kind = "nonlinear_response"
name = "response"
speed = { from = "500 rad/s", to = "1500 rad/s" }
"#;

fn json(path: &Path) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// Every file below `dir` with its content, in order of path.
fn tree(dir: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut out = Vec::new();
    let mut open = vec![dir.to_path_buf()];
    while let Some(d) = open.pop() {
        for entry in fs::read_dir(d).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                out.push((path.strip_prefix(dir).unwrap().to_path_buf(), fs::read(&path).unwrap()));
            }
        }
    }
    out.sort();
    out
}

#[test]
fn a_good_file_is_run_and_the_report_named() {
    let dir = Dir::new("good");
    dir.file("pump.toml", SMALL);
    assert_eq!(dir.laval(["check", "pump.toml"]).done(), "ok: 3 parts, 2 coordinates, study response\n");
    let said = dir.laval(["run", "pump.toml"]);
    let out = said.done();
    assert!(out.starts_with("small\n✓ Stable at 1000 rpm.\n") && out.ends_with("\n\nout/pump/report.html\n"), "{out}");
    // all findings stand before the summary
    let all = dir.laval(["run", "pump.toml", "--all"]);
    assert!(all.done().starts_with("response\n  ") && all.out.ends_with(out), "{}", all.out);
    let files: Vec<String> = tree(&dir.0.join("out/pump")).iter().map(|f| f.0.display().to_string()).collect();
    for wanted in ["figures/response-response.svg", "report.html", "response/response.csv", "response/response.parquet", "results.json"] {
        assert!(files.iter().any(|f| f == wanted), "{wanted} in {files:?}");
    }
    let results = json(&dir.0.join("out/pump/results.json"));
    assert_eq!(results["studies"][0]["kind"], "nonlinear_response");
    assert_eq!(results["studies"][0]["end"]["kind"], "reached");
    assert_eq!(results["provenance"]["input_hash"].as_str().map(str::len), Some("sha256:".len() + 64));
}

#[test]
fn results_of_a_machine_toml_are_named_after_its_folder() {
    let dir = Dir::new("folder");
    dir.file("fan/machine.toml", SMALL);
    assert!(dir.laval(["run", "fan/machine.toml"]).done().ends_with("\nout/fan/report.html\n"));
}

#[test]
fn two_runs_give_the_same_bytes() {
    let dir = Dir::new("same");
    dir.file("pump.toml", SMALL);
    let first = dir.laval(["run", "pump.toml", "--out", "a"]);
    let second = dir.laval(["run", "pump.toml", "--out", "b"]);
    assert_eq!(first.done().replace("a/report", "b/report"), second.done());
    let (a, b) = (tree(&dir.0.join("a")), tree(&dir.0.join("b")));
    assert!(a.len() > 5 && a == b);
}

/// Without coupling to the spin both directions have the same speeds and frequencies; which of two is larger in the last digit says nothing.
#[test]
fn equal_modes_and_critical_speeds_stand_forward_first() {
    let dir = Dir::new("ties");
    for k in 1..=12 {
        let k = f64::from(k);
        let (mass, stiffness, damping) = (1.0 + k / 7.0, 1e5 * (1.0 + k / 3.0), 10.0 + k / 9.0);
        let shaft = |at: &str, factor: f64| {
            let between = format!("[{{ body = \"a\", at = \"{at}\" }}, \"ground\"]");
            format!("[[part]]\nkind = \"shaft_lumped\"\nbetween = {between}\nstiffness = {}\n", factor * stiffness)
        };
        let text = format!(
            "[machine]\nname = \"t\"\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"a\"\nmass = {mass}\ndiametral_inertia = 0.01\n\
             polar_inertia = 0.0\n{}{}[[part]]\nkind = \"damper\"\nbetween = [\"a\", \"ground\"]\ndamping = {damping}\n\
             [[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = 10, to = 3000 }}\n[[study]]\nkind = \"modes\"\nspeed = 300\n",
            shaft("-100 mm", 1.0),
            shaft("130 mm", 1.1)
        );
        dir.file("t.toml", text);
        dir.laval(["run", "t.toml", "--out", "o", "--format", "csv"]).done();
        for table in ["critical_speeds/critical_speeds", "modes/modes"] {
            let text = dir.read(&format!("o/{table}.csv"));
            let mut rows = text.lines().filter(|l| !l.starts_with('#')).map(|l| l.split(',').collect::<Vec<_>>());
            let whirl = rows.next().unwrap().iter().position(|c| *c == "whirl").unwrap();
            let found: Vec<&str> = rows.map(|r| r[whirl]).collect();
            assert_eq!(found, ["forward", "backward", "forward", "backward"], "{k}: {table}");
        }
    }
}

#[test]
fn formats_and_quiet() {
    let dir = Dir::new("formats");
    dir.file("pump.toml", SMALL);
    assert_eq!(dir.laval(["run", "pump.toml", "--out", "o", "--format", "csv,json", "--quiet"]).done(), "");
    let mut kinds: Vec<String> = tree(&dir.0.join("o")).iter().filter_map(|f| Some(f.0.extension()?.to_string_lossy().into())).collect();
    kinds.sort();
    kinds.dedup();
    assert_eq!(kinds, ["csv", "json"]);
    dir.laval(["run", "pump.toml", "--format", "pdf"]).refused(&["unknown format `pdf`", "parquet"]);
}

#[test]
fn all_mistakes_of_a_file_are_reported_at_their_places() {
    let dir = Dir::new("bad");
    let text = SMALL.replace("mass = \"2 kg\"", "mass = \"2 m\"").replace("damping = \"40 N s/m\"", "dampin = \"40 N s/m\"");
    dir.file("pump.toml", &text);
    for command in ["check", "run"] {
        let said = dir.laval([command, "pump.toml"]);
        let line = |start: &str| text.lines().position(|l| l.starts_with(start)).unwrap() + 1;
        let places = [format!("pump.toml:{}:", line("mass")), format!("pump.toml:{}:", line("dampin "))];
        said.refused(&[&places[0], &places[1], "did you mean \"damping\""]);
    }
    assert!(!dir.0.join("out").exists());
    dir.file("joint.toml", SMALL.replace("[\"drum\", \"ground\"]", "[\"dram\", \"ground\"]"));
    dir.laval(["check", "joint.toml"]).refused(&["\"dram\"", "did you mean \"drum\"?"]);
}

#[test]
fn diagnostics_for_editors() {
    let dir = Dir::new("json");
    dir.file("good.toml", SMALL);
    dir.file("bad.toml", SMALL.replace("mass = \"2 kg\"", "mass = \"2 m\""));
    let good: serde_json::Value = serde_json::from_str(dir.laval(["check", "good.toml", "--json"]).done()).unwrap();
    assert_eq!((&good["ok"], &good["coordinates"]), (&true.into(), &serde_json::json!(["drum.x", "drum.y"])));
    assert_eq!(good["studies"], serde_json::json!([{ "name": "response", "kind": "nonlinear_response" }]));
    let said = dir.laval(["check", "bad.toml", "--json"]);
    assert_eq!((said.code, said.err.as_str()), (1, ""));
    let bad: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(bad["ok"], false);
    let line = SMALL.lines().position(|l| l.starts_with("mass")).unwrap() + 1;
    assert_eq!(bad["diagnostics"][0]["place"]["line"], line);
    let missing = dir.laval(["check", "nothing.toml", "--json"]);
    assert_eq!(missing.code, 1);
    assert!(missing.out.contains("there is no file nothing.toml"));
}

#[test]
fn what_is_no_machine_file() {
    let dir = Dir::new("nofile");
    dir.file("fan/machine.toml", SMALL);
    dir.file("latin.toml", [SMALL.as_bytes(), b"# 5 \xb5m\n"].concat());
    dir.file("binary.toml", (0..=255u8).cycle().take(5000).collect::<Vec<_>>());
    dir.file("empty.toml", "");
    dir.file("idle.toml", SMALL.split("[[study]]").next().unwrap());
    for command in ["check", "run"] {
        dir.laval([command, "nothing.toml"]).refused(&["there is no file nothing.toml", "laval new"]);
        dir.laval([command, "fan"]).refused(&["fan is a folder", "fan/machine.toml"]);
        dir.laval([command, "latin.toml"]).refused(&["not UTF-8", "0xb5"]);
        dir.laval([command, "binary.toml"]).refused(&["not UTF-8"]);
        dir.laval([command, "empty.toml"]).refused(&["no parts", "[machine]"]);
    }
    assert_eq!(dir.laval(["check", "idle.toml"]).done(), "ok: 3 parts, 2 coordinates, no studies\n");
    // the first page needs no study; parts of studies do
    let said = dir.laval(["run", "idle.toml"]);
    assert!(said.done().contains("Stability") && said.done().contains("[[study]]"), "{}", said.out);
    let written = fs::read_to_string(dir.0.join("out/idle/report.html")).unwrap();
    assert!(written.contains("class=\"chk\""), "no first page");
    dir.laval(["run", "idle.toml", "--part", "1/2"]).refused(&["contains no study", "laval studies"]);
    dir.laval(["plan", "idle.toml"]).refused(&["contains no study", "laval studies"]);
}

#[test]
fn an_unwritable_folder_is_reported_before_computing() {
    let dir = Dir::new("unwritable");
    dir.file("pump.toml", SMALL);
    dir.file("taken", "a file");
    for out in ["taken", "taken/below"] {
        dir.laval(["run", "pump.toml", "--out", out]).refused(&["cannot make the folder", out, "--out"]);
    }
    assert_eq!(fs::read_to_string(dir.0.join("taken")).unwrap(), "a file");
}

#[test]
fn only_some_studies() {
    let dir = Dir::new("only");
    let again = "[[study]]\nkind = \"nonlinear_response\"\nname = \"narrow\"\nspeed = { from = \"500 rad/s\", to = \"800 rad/s\" }\n";
    dir.file("pump.toml", format!("{SMALL}{again}"));
    dir.laval(["run", "pump.toml", "--only", "respons"]).refused(&[
        "no study \"respons\"",
        "did you mean \"response\"?",
        "response, narrow",
    ]);
    let names = |out: &str| -> Vec<String> {
        let results = json(&dir.0.join(out).join("results.json"));
        results["studies"].as_array().unwrap().iter().map(|s| s["name"].as_str().unwrap().to_string()).collect()
    };
    dir.laval(["run", "pump.toml", "--only", "narrow", "--out", "a"]).done();
    assert_eq!(names("a"), ["narrow"]);
    dir.laval(["run", "pump.toml", "--only", "nonlinear_response", "--out", "b"]).done();
    assert_eq!(names("b"), ["response", "narrow"]);
}

/// The summary and the report are in the language requested; the results name no language.
#[test]
fn reports_speak_the_language_requested() {
    let dir = Dir::new("language");
    dir.file("pump.toml", SMALL);
    let english = dir.laval(["run", "pump.toml", "--out", "en"]).done().to_string();
    let russian = dir.laval(["run", "pump.toml", "--out", "ru", "--lang", "ru"]).done().to_string();
    assert!(russian.contains("об/мин") && !russian.contains("rpm") && english.contains("rpm"), "{russian}");
    let page = dir.read("ru/report.html");
    assert!(page.contains("<html lang=\"ru\">") && page.contains("об/мин"));
    assert_eq!(dir.read("ru/results.json"), dir.read("en/results.json"));
    // the file comes after the request
    dir.file("own.toml", format!("{SMALL}[report]\nlanguage = \"ru\"\nunits = \"Hz\"\n"));
    let own = dir.laval(["run", "own.toml", "--out", "own"]).done().to_string();
    assert!(own.contains("Гц") && !own.contains("об/мин"), "{own}");
    let requested = dir.laval(["run", "own.toml", "--out", "own", "--lang", "en"]).done().to_string();
    assert!(requested.contains("Hz") && !requested.contains("Гц"), "{requested}");
    dir.laval(["run", "pump.toml", "--lang", "xx"]).refused(&["xx", "en, ru, kk, uz"]);
}

/// Where a Chromium is found the report is printed; else the run says so, and its results are there.
#[test]
fn a_report_is_printed_or_the_reason_named() {
    let dir = Dir::new("pdf");
    dir.file("pump.toml", SMALL);
    let said = dir.laval(["run", "pump.toml", "--pdf"]);
    let pdf = dir.0.join("out/pump/report.pdf");
    match said.code {
        0 => assert!(fs::read(&pdf).unwrap().starts_with(b"%PDF")),
        code => assert!(code == 1 && said.err.contains("pdf.") && !pdf.exists(), "{}", said.err),
    }
    assert!(dir.0.join("out/pump/report.html").is_file());
    let said = dir.laval(["run", "pump.toml", "--pdf", "--format", "json"]);
    assert!(said.code == 1 && said.err.contains("pdf.page"), "{}", said.err);
    let mut without = dir.command(["run", "pump.toml", "--pdf"]);
    let said = Said::of(&without.env("PATH", &dir.0).output().unwrap());
    assert!(said.code == 1 && said.err.contains("no Chromium was found"), "{}", said.err);
}

#[test]
fn a_refused_study_leaves_the_others() {
    let dir = Dir::new("refused");
    // without a load a Hertz contact has no stiffness to linearise
    let text = SMALL.replace(
        "[[study]]",
        "[[part]]\nkind = \"bearing_hertz\"\nbetween = [\"drum\", \"ground\"]\nlaw = \"radial\"\ncoefficient = \"1e9 N/m^1.5\"\n\
         [[study]]\nkind = \"modes\"\nname = \"small motions\"\n[[study]]",
    );
    dir.file("pump.toml", text);
    let said = dir.laval(["run", "pump.toml", "--all"]);
    assert_eq!(said.code, 1, "{}{}", said.out, said.err);
    assert!(said.err.contains("study \"small motions\": "), "{}", said.err);
    assert!(said.out.starts_with("response\n") && said.out.ends_with("report.html\n"), "{}", said.out);
    let results = json(&dir.0.join("out/pump/results.json"));
    assert!(results["studies"][0]["end"]["kind"] == "refused");
    assert_eq!(results["studies"][1]["name"], "response");
}

#[test]
fn check_says_what_a_run_would_refuse() {
    let dir = Dir::new("admit");
    let hertz = "[[part]]\nkind = \"bearing_hertz\"\nbetween = [\"drum\", \"ground\"]\nlaw = \"radial\"\ncoefficient = \"1e9 N/m^1.5\"\n";
    let more = "[[study]]\nkind = \"campbell\"\nspeed = { from = 1, to = 100 }\n[[study]]\nkind = \"critical_speeds\"\nspeed = { from = 1, to = 100 }\n";
    dir.file("pump.toml", format!("{SMALL}{more}{hertz}"));
    let said = dir.laval(["check", "pump.toml"]);
    said.refused(&["studies \"campbell\", \"critical_speeds\"", "no stiffness at rest"]);
    assert_eq!(said.err.matches("no stiffness at rest").count(), 1, "{}", said.err);
    let reported: serde_json::Value = serde_json::from_str(&dir.laval(["check", "pump.toml", "--json"]).out).unwrap();
    assert_eq!((&reported["ok"], reported["diagnostics"].as_array().unwrap().len()), (&false.into(), 1));
    // a run says it once as well, and does the rest
    let run = dir.laval(["run", "pump.toml", "--all"]);
    assert_eq!((run.code, run.err.matches("no stiffness at rest").count()), (1, 1), "{}", run.err);
    assert!(run.out.starts_with("response\n"), "{}", run.out);
    // and the report once, among the findings and with the first of the studies
    let results = json(&dir.0.join("out/pump/results.json"));
    let reasons: Vec<&str> = results["studies"].as_array().unwrap().iter().filter_map(|s| s["findings"][0]["id"].as_str()).collect();
    assert_eq!(reasons.iter().filter(|c| **c == "refused").count(), 1, "{reasons:?}");
    assert!(results["studies"][1]["end"]["kind"] == "refused" && results["studies"][2]["end"]["kind"] == "refused");
    let page = fs::read_to_string(dir.0.join("out/pump/report.html")).unwrap();
    let body = page.split("id=\"input\"").next().unwrap();
    // on the first page once, too
    assert_eq!(body.matches("no stiffness at rest").count(), 3, "{body}");
    assert!(body.contains("studies &quot;campbell&quot;, &quot;critical_speeds&quot;: ") && !body.contains("about ="), "{body}");
}

#[test]
fn results_of_a_study_that_is_gone_are_removed() {
    let dir = Dir::new("stale");
    let modes = "[[study]]\nkind = \"modes\"\nname = \"small motions\"\n";
    dir.file("pump.toml", format!("{SMALL}{modes}"));
    dir.laval(["run", "pump.toml"]).done();
    assert!(dir.0.join("out/pump/small-motions/modes.csv").is_file());
    dir.file("out/pump/small-motions/notes.txt", "mine");
    // not requested, but still in the file
    dir.laval(["run", "pump.toml", "--only", "response"]).done();
    assert!(dir.0.join("out/pump/small-motions/modes.csv").is_file());
    dir.file("pump.toml", SMALL);
    dir.laval(["run", "pump.toml"]).done();
    let left: Vec<String> =
        tree(&dir.0.join("out/pump")).iter().map(|f| f.0.display().to_string()).filter(|f| f.contains("small")).collect();
    assert_eq!(left, ["small-motions/notes.txt"]);
}

#[test]
#[cfg(target_os = "linux")]
fn output_that_is_lost_is_a_failure() {
    let dir = Dir::new("full");
    for args in [&["schema"][..], &["parts"], &["--help"], &["new", "rigid-rotor", "--out", "-"]] {
        let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let said = Said::of(&dir.command(args).stdout(full).output().unwrap());
        assert_eq!(said.code, 1, "{args:?}: {}", said.err);
    }
}

/// A computer that allows fewer threads than are wanted computes with one.
#[test]
#[cfg(target_os = "linux")]
fn threads_that_cannot_be_started_are_not_needed() {
    let dir = Dir::new("threads");
    dir.file("pump.toml", SMALL);
    let program = dir.command(["run", "pump.toml"]);
    let mut limited = Command::new("sh");
    limited.args(["-c", "ulimit -v 3000000 && exec \"$0\" \"$@\""]).arg(program.get_program()).args(program.get_args());
    // a thread that starts with less than 12 kB of memory free ends the program; with large stacks that is improbable
    limited.current_dir(&dir.0).env("RAYON_NUM_THREADS", "3000").env("RUST_MIN_STACK", "67108864");
    let said = Said::of(&limited.output().unwrap());
    assert!(said.code == 0 && said.err.contains("3000 threads cannot be started"), "{} {}", said.code, said.err);
    assert!(dir.0.join("out/pump/report.html").exists());
}

/// Keys within keys need the stack of the program, also when the mistake is printed.
#[test]
fn tables_within_many_others_are_refused() {
    let dir = Dir::new("deep");
    for key in [vec!["\"\""; 75].join("."), vec!["a"; 79].join(".")] {
        let nested = format!("[machine]\n{}1{}\n", format!("{key} = {{ ").repeat(75), " }".repeat(75));
        dir.file("deep.toml", &nested);
        for command in ["check", "run", "plan"] {
            dir.laval([command, "deep.toml"]).refused(&["tables within more than 64 others"]);
        }
    }
}

#[test]
fn a_work_limit_ends_a_study_early_and_says_so() {
    let dir = Dir::new("limit");
    dir.file("pump.toml", SMALL);
    let said = dir.laval(["run", "pump.toml", "--work-limit", "5"]);
    assert!(said.done().contains("! response: The study stopped early"), "{}", said.out);
    let all = dir.laval(["run", "pump.toml", "--work-limit", "5", "--all"]);
    assert!(all.done().contains("! The study stopped early"), "{}", all.out);
    for n in ["0", "-1"] {
        dir.laval(["run", "pump.toml", "--work-limit", n]).refused(&["--work-limit", n, "whole number from 1 on"]);
    }
    dir.laval(["run", "pump.toml", "--work-limit", "1e3"]).refused(&["1e3", "in digits alone"]);
    for n in ["18446744073709551616", "1e20", "99999999999999999999999", "inf"] {
        dir.laval(["run", "pump.toml", "--work-limit", n]).refused(&["--work-limit", n, "the largest value is 18446744073709551615"]);
    }
    assert!(dir.laval(["run", "pump.toml", "--work-limit", "18446744073709551615"]).done().contains("report.html"));
}

#[test]
#[cfg(unix)]
fn ctrl_c_keeps_what_was_done() {
    use std::io::{BufRead, BufReader, Read};
    let dir = Dir::new("stop");
    let long = "[[study]]\nkind = \"transient\"\nname = \"long\"\nduration = \"1e7 s\"\n[[study]]\nkind = \"modes\"\nname = \"after\"\n";
    dir.file("pump.toml", format!("{SMALL}{long}"));
    let mut child = dir.command(["run", "pump.toml", "--all"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut out = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    // the first study is printed when it is done: the long one follows
    out.read_line(&mut line).unwrap();
    assert_eq!(line, "response\n");
    // between two studies there is nothing to interrupt
    std::thread::sleep(std::time::Duration::from_secs(1));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let mut err = String::new();
    child.stderr.take().unwrap().read_to_string(&mut err).unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130), "{err}");
    assert!(err.contains("stopping") && err.contains("not run: after"), "{err}");
    // 1e7 s at 1000 rpm: said before it begins, also where standard error is no terminal
    assert!(err.starts_with("long: 1.67·10⁸ turns of the rotor to integrate, 10⁷ s\n"), "{err}");
    let results = json(&dir.0.join("out/pump/results.json"));
    assert_eq!(results["studies"][0]["name"], "response");
    assert!(results["studies"][1]["end"]["kind"] == "cancelled");
    assert!(dir.0.join("out/pump/response/response.csv").is_file() && dir.0.join("out/pump/report.html").is_file());
}

#[test]
fn templates_are_sound_and_never_overwrite() {
    let dir = Dir::new("templates");
    let list = dir.laval(["new"]);
    let schema = serde_json::from_str(dir.laval(["schema", "--results"]).done()).unwrap();
    for name in TEMPLATES {
        assert!(list.done().contains(name));
        assert_eq!(dir.laval(["new", name]).done(), format!("{name}.toml\n"));
        let file = format!("{name}.toml");
        assert!(dir.laval(["check", &file]).done().starts_with("ok: "));
        // the answer fits 25 lines of 80 columns, in the units of the file
        let said = dir.laval(["run", &file]);
        assert_eq!(said.code, 0, "{}", said.err);
        let out = &said.out;
        let lines: Vec<&str> = out.lines().collect();
        assert!(lines.len() <= 25 && lines.iter().all(|l| l.chars().count() <= 80), "{out}");
        assert!(!dir.read(&file).contains("rpm\"") || out.contains("rpm") && !out.contains("rad/s"), "{out}");
        // nor has the report others in the words of its tables
        let report = dir.read(&format!("out/{name}/report.html"));
        let cells = report.split("<td class=\"w\">").skip(1).filter_map(|cell| cell.split("</td>").next());
        let others: Vec<&str> = cells.filter(|c| c.contains("rad/")).collect();
        assert!(!dir.read(&file).contains("rpm\"") || others.is_empty(), "{name}: {others:?}");
        let results = json(&dir.0.join("out").join(name).join("results.json"));
        assert_eq!(crate::results_schema::mistakes(&schema, &results), [""; 0], "{name}");
        for study in results["studies"].as_array().unwrap() {
            assert_eq!(study["end"]["kind"], "reached");
        }
        dir.laval(["new", name]).refused(&["exists and is not overwritten", "--out"]);
    }
    // every example is a template, and runs here
    let examples = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples")).unwrap();
    assert_eq!(examples.filter(|e| e.as_ref().unwrap().path().join("machine.toml").exists()).count(), TEMPLATES.len());
    assert_eq!(list.out.lines().take_while(|l| !l.is_empty()).count(), TEMPLATES.len());
    dir.laval(["new", "rigid-rotr"]).refused(&["did you mean \"rigid-rotor\"?"]);
    assert_eq!(dir.laval(["new", "rigid-rotor", "--out", "-"]).done(), fs::read_to_string(dir.0.join("rigid-rotor.toml")).unwrap());
}

#[test]
fn the_catalogue_is_documented() {
    let dir = Dir::new("catalogue");
    for (command, word) in [("parts", "liquid"), ("studies", "nonlinear_response")] {
        let list = dir.laval([command]);
        let kinds: Vec<&str> = list.done().lines().take_while(|l| !l.is_empty()).filter_map(|l| l.split_whitespace().next()).collect();
        assert!(kinds.contains(&word));
        for kind in kinds {
            let said = dir.laval([command, kind]);
            assert!(said.done().starts_with(&format!("{kind}\n")) && said.out.contains("\nExample\n"), "{kind}");
        }
        dir.laval([command, "liqud_response"]).refused(&["there is no kind of", word]);
    }
    let schema: serde_json::Value = serde_json::from_str(dir.laval(["schema"]).done()).unwrap();
    assert!(schema["$defs"]["part.liquid"].is_object());
}

#[test]
fn help_names_every_command_and_the_exit_codes() {
    let dir = Dir::new("help");
    let help = dir.laval(["--help"]);
    for word in ["run", "check", "new", "parts", "studies", "schema", "Exit codes: 0 done", "laval new rigid-rotor"] {
        assert!(help.done().contains(word), "{word}");
    }
    for command in ["run", "check", "new", "parts", "studies", "schema"] {
        assert!(dir.laval([command, "--help"]).done().contains("Usage: laval"));
    }
    assert_eq!(dir.laval(["--version"]).done(), format!("laval {}\n", env!("CARGO_PKG_VERSION")));
    dir.laval::<&str>([]).refused(&["Usage: laval"]);
    dir.laval(["chek"]).refused(&["chek", "check"]);
    dir.laval(["run"]).refused(&["FILE"]);
}

#[test]
#[cfg(unix)]
fn a_closed_pipe_is_no_failure() {
    let dir = Dir::new("pipe");
    let program = env!("CARGO_BIN_EXE_laval");
    let o = Command::new("sh").args(["-c", &format!("{program} schema | head -c 1; {program} parts | true")]).current_dir(&dir.0).output();
    assert_eq!(Said::of(&o.unwrap()).err, "");
}
