//! `laval validate` from outside: verdicts, exit codes, the gallery on disk.

use crate::launcher::{Dir, Said};
use std::fs;
use std::path::Path;

/// A mass on a spring; its frequency is 10 rad/s.
const PAGE: &str = r#"# Mass on a spring

|  |  |
| --- | --- |
| Requirement | The frequency is the root of k/m. |
| Source | Newton |
| Evidence | closed form |
| Verdict | agrees |

## Symbols

k is `stiffness`.

## Machine

```toml machine
[machine]
name = "mass"
[[part]]
kind = "disc"
name = "body"
mass = "4 kg"
[[part]]
kind = "shaft_lumped"
between = ["body", "ground"]
stiffness = "400 N/m"
[[study]]
kind = "modes"
speed = "0 rad/s"
```

## Expected

| study | value | at | expected | unit | tolerance |
| --- | --- | --- | --- | --- | --- |
| modes | modes / frequency | first | 10 | rad/s | 1e-12 relative |

## Tolerance

Rounding.
"#;

fn validate(dir: &Dir, args: &[&str]) -> (i32, String, String) {
    let Said { code, out, err } = dir.laval(["validate"].iter().chain(args));
    (code, out, err)
}

#[test]
fn a_case_that_holds() {
    let dir = Dir::new("validate-holds");
    dir.file("validation/linear/mass.md", PAGE);
    dir.file("validation/README.md", "no case");
    let (code, out, err) = validate(&dir, &[]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("linear/mass  agrees") && out.contains("index.html"));
    assert!(dir.read("out/validation/index.html").contains("Mass on a spring"));
    assert!(dir.read("out/validation/linear-mass.html").contains("<table"));
    // from a folder below, and elsewhere on request
    fs::create_dir_all(dir.0.join("a/b")).unwrap();
    let below = Dir(dir.0.join("a/b"));
    assert_eq!(validate(&below, &["--quiet", "--out", "gallery"]), (0, String::new(), String::new()));
    assert_eq!(validate(&below, &["-q", "../../validation/linear"]).0, 0);
}

#[test]
fn a_wrong_value_fails() {
    let dir = Dir::new("validate-wrong");
    dir.file("validation/linear/mass.md", PAGE);
    dir.file("validation/linear/wrong.md", PAGE.replace("| 10 |", "| 10.001 |"));
    let (code, out, err) = validate(&dir, &[]);
    assert_eq!(code, 1);
    assert!(out.contains("open  CHANGED"), "{out}");
    assert!(err.contains("linear/wrong: open") && err.contains("expected 10.001") && err.contains("1 of 2 cases"), "{err}");
    assert!(dir.read("out/validation/index.html").contains("changed"));
    // the other case alone is well
    assert_eq!(validate(&dir, &["--only", "mass"]).0, 0);
}

#[test]
fn a_stated_difference_that_is_gone_fails() {
    let dir = Dir::new("validate-gone");
    let page = PAGE
        .replace("| Verdict | agrees |", "| Verdict | differs (explained) |")
        .replace("tolerance |\n| --- |", "tolerance | verdict |\n| --- | --- |")
        .replace("1e-12 relative |", "1e-12 relative | differs |");
    dir.file("validation/linear/mass.md", format!("{page}\n## Why it differs\n\nIt does not.\n"));
    let (code, _, err) = validate(&dir, &[]);
    assert_eq!(code, 1);
    assert!(err.contains("agrees instead of differs") && err.contains("states \"differs (explained)\""), "{err}");
}

#[test]
fn a_case_that_cannot_run_or_be_read_fails_at_its_line() {
    let dir = Dir::new("validate-broken");
    dir.file("validation/linear/machine.md", PAGE.replace("stiffness = \"400 N/m\"", "stiffness = \"400 kg\""));
    dir.file("validation/linear/page.md", PAGE.replace("closed form", "hearsay"));
    let (code, out, err) = validate(&dir, &[]);
    assert_eq!(code, 1);
    assert!(out.contains("cannot run") && out.contains("cannot be read"), "{out}");
    let line = |text: &str| 1 + PAGE.lines().position(|l| l.contains(text)).unwrap();
    assert!(err.contains(&format!("linear/machine.md:{}:", line("400 N/m"))), "{err}");
    assert!(err.contains(&format!("linear/page.md:{}:", line("closed form"))), "{err}");
    assert!(dir.read("out/validation/linear-page.html").contains("hearsay"));
}

#[test]
fn a_request_that_is_wrong_is_reported() {
    let dir = Dir::new("validate-request");
    let (code, _, err) = validate(&dir, &[]);
    assert!(code == 1 && err.contains("no folder \"validation\""), "{err}");
    let (code, _, err) = validate(&dir, &["nowhere"]);
    assert!(code == 1 && err.contains("nowhere"), "{err}");
    fs::create_dir_all(dir.0.join("validation")).unwrap();
    let (code, _, err) = validate(&dir, &[]);
    assert!(code == 1 && err.contains("no case"), "{err}");
    dir.file("validation/linear/mass.md", PAGE);
    let (code, _, err) = validate(&dir, &["--only", "nothing"]);
    assert!(code == 1 && err.contains("nothing"), "{err}");
    assert!(!dir.0.join("out").exists());
}

#[test]
fn a_gallery_that_another_process_writes_is_left_alone() {
    let dir = Dir::new("validate-locked");
    dir.file("validation/linear/mass.md", PAGE);
    let lock = dir.file("out/validation/.lock", "12");
    let held = fs::OpenOptions::new().write(true).open(lock).unwrap();
    held.lock().unwrap();
    let (code, out, err) = validate(&dir, &[]);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("another process (number 12) is writing into out/validation"), "{err}");
    assert!(!dir.0.join("out/validation/index.html").exists());
    drop(held);
    dir.file("out/validation/.laval-1-0.part", "half");
    assert_eq!(validate(&dir, &[]).0, 0);
    assert!(!dir.0.join("out/validation/.laval-1-0.part").exists());
}

#[test]
#[cfg(unix)]
fn a_page_that_is_a_link_is_replaced_and_not_followed() {
    let dir = Dir::new("validate-link");
    dir.file("validation/linear/mass.md", PAGE);
    let precious = dir.file("precious", "mine");
    fs::create_dir_all(dir.0.join("out/validation")).unwrap();
    std::os::unix::fs::symlink(&precious, dir.0.join("out/validation/index.html")).unwrap();
    assert_eq!(validate(&dir, &[]).0, 0);
    assert!(dir.read("precious") == "mine" && dir.read("out/validation/index.html").contains("Mass on a spring"));
}

#[test]
fn a_case_of_the_repository() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation");
    let dir = Dir::new("validate-repository");
    let (code, out, err) = validate(&dir, &["--only", "linear/", folder.to_str().unwrap()]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("linear/jeffcott-unbalance"));
}
