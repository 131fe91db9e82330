//! Names in a machine file may hold anything; nothing of it steers a terminal, neither from the screen nor from a file of text.

use crate::launcher::{Dir, Said};
use std::fs;
use std::path::Path;

/// Colours, a title for the window, a bell, a cleared screen by one byte, letters turned round, a line of its own.
const EVIL: &str = "n\u{1b}[31mRED\u{1b}]0;title\u{7}\u{9b}2J\u{202e}\u{7f}\nerror: forged";

const MACHINE: &str = r#"
[machine]
name = "rotor"
speed = "300 rad/s"
[[part]]
kind = "disc"
name = "d"
mass = "1 kg"
eccentricity = "10 um"
[[part]]
kind = "shaft_lumped"
name = "s"
between = ["d", "ground"]
stiffness = "1e5 N/m"
[[part]]
kind = "damper"
name = "c"
between = ["d", "ground"]
damping = "10 N s/m"
[[study]]
kind = "modes"
name = "small"
[[study]]
kind = "transient"
name = "later"
duration = "0.1 s"
waterfall = "d.x"
spectra = "d.y"
[[study]]
kind = "uncertainty"
show = "frequency"
samples = 4
parameters = [{ parameter = "d.mass", distribution = "normal", deviation = "2 %" }]
study = "small"
[[study]]
kind = "optimum"
vary = [{ parameter = "d.mass", from = 1, to = 2 }]
minimise = "frequency"
study = "small"
at_most = { frequency = 1 }
"#;

/// All words in quotes, by their places.
fn words() -> Vec<(usize, usize)> {
    let quotes: Vec<usize> = MACHINE.match_indices('"').map(|(i, _)| i).collect();
    quotes.chunks_exact(2).map(|q| (q[0], q[1] + 1)).collect()
}

fn steers(text: &str) -> bool {
    text.chars().any(|c| (c.is_control() && c != '\n' && c != '\t') || c == '\u{202e}')
}

fn calm(what: &str, said: &Said, dir: &Path) {
    assert!(said.code == 0 || said.code == 1, "{what}: {}", said.err);
    for text in [&said.out, &said.err] {
        assert!(!steers(text) && !text.lines().any(|l| l.trim().starts_with("error: forged")), "{what}: {text:?}");
    }
    let mut open = vec![dir.to_path_buf()];
    while let Some(d) = open.pop() {
        for path in fs::read_dir(d).into_iter().flatten().map(|e| e.unwrap().path()) {
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_none_or(|e| e != "parquet") {
                assert!(!steers(&fs::read_to_string(&path).unwrap()), "{what}: {}", path.display());
            }
        }
    }
}

#[test]
fn no_word_of_a_file_steers_the_terminal() {
    let dir = Dir::new("shown");
    // as a machine file must write it
    let written = |c: char| if c.is_ascii_graphic() { c.to_string() } else { format!("\\u{:04x}", u32::from(c)) };
    let evil = format!("\"{}\"", EVIL.chars().map(written).collect::<String>());
    let mut shown = 0;
    for (i, (start, end)) in words().into_iter().enumerate() {
        let text = format!("{}{evil}{}", &MACHINE[..start], &MACHINE[end..]);
        let name = format!("{i}.toml");
        dir.file(&name, &text);
        for args in [&["check", &name][..], &["check", &name, "--json"], &["run", &name, "--out", "o", "--format", "csv,json,svg,html"]] {
            let said = dir.laval(args);
            calm(&format!("{args:?} with {}", &MACHINE[start..end]), &said, &dir.0.join("o"));
            shown += usize::from(said.out.contains("\\u001b[31m") || said.err.contains("\\u001b[31m"));
        }
        let _ = fs::remove_dir_all(dir.0.join("o"));
    }
    // said, not swallowed
    assert!(shown > 20, "{shown}");
}

#[test]
fn no_name_on_the_command_line_does_either() {
    let dir = Dir::new("shown-args");
    dir.file("x.toml", MACHINE);
    let name = EVIL.replace('\n', "");
    for args in [
        vec!["run", "x.toml", "--only", &name],
        vec!["run", &name],
        vec![&name],
        vec!["check", &format!("--{name}")],
        vec!["parts", &name],
        vec!["new", &name],
        vec!["new", "rigid-rotor", "--out", &name],
        vec!["validate", "--only", &name, "."],
        vec!["validate", &name],
        vec!["run", "x.toml", "--only", "small", "--out", &format!("o{name}")],
    ] {
        let said = dir.laval(&args);
        assert!(!steers(&said.out) && !steers(&said.err), "{args:?}: {:?}{:?}", said.out, said.err);
    }
}

/// Raw characters that TOML does not allow, so that the line is shown with the mistake.
#[test]
fn a_line_that_is_no_toml_is_shown_as_escapes() {
    let dir = Dir::new("shown-raw");
    dir.file("x.toml", MACHINE.replace("\"rotor\"", "\"ro\u{1b}[31mtor\""));
    for args in [&["check", "x.toml"][..], &["check", "x.toml", "--json"]] {
        let said = dir.laval(args);
        calm("raw", &said, &dir.0.join("o"));
        assert_eq!(said.code, 1);
    }
}

/// Names with markup, a byte that clears the screen, letters turned round, titles and a formula, where a body, a
/// field and a study are named.
#[test]
fn files_with_control_characters_are_shown_as_escapes() {
    let dir = Dir::new("shown-files");
    let machines = Path::new(env!("CARGO_MANIFEST_DIR")).join("../laval/tests/faults/machines");
    for (name, code) in [("name_of_a_body", 1), ("references", 1), ("fields", 0)] {
        let file = format!("{name}.toml");
        dir.file(&file, fs::read(machines.join(format!("{name}_with_control_characters.toml"))).unwrap());
        for args in [&["check", &file][..], &["check", &file, "--json"], &["run", &file, "--out", "o", "--format", "csv,json,svg,html"]] {
            let said = dir.laval(args);
            calm(&format!("{args:?}"), &said, &dir.0.join("o"));
            assert!(said.code == code || args[0] == "run", "{args:?}: {}", said.err);
            // C1 controls are two bytes of UTF-8, and steer as well
            for text in [&said.out, &said.err] {
                assert!(!text.contains(['\u{85}', '\u{9b}', '\u{202e}']), "{args:?}: {text:?}");
            }
            let shown = said.out.contains("\\u001b[31m") || said.err.contains("\\u001b[31m") || code == 0;
            assert!(shown, "{args:?}: {}{}", said.out, said.err);
        }
        let _ = fs::remove_dir_all(dir.0.join("o"));
    }
}
