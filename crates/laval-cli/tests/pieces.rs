//! Long studies in parts: any engine, kill or repetition leaves the files of one undisturbed run.

use crate::launcher::{Dir, ROTOR, tree};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::Duration;

/// Studies with chunks that follow from nothing (`tolerances`), from the chunk before (`slow`), and without chunks (`modes`).
const STUDIES: &str = r#"
[[study]]
kind = "modes"
[[study]]
kind = "uncertainty"
name = "tolerances"
study = "modes"
samples = 200
parameters = [{ parameter = "d.mass", distribution = "normal", deviation = "2 %" }]
[[study]]
kind = "sweep"
name = "slow"
speed = { from = "100 rad/s", to = "300 rad/s", points = 9 }
start = "up"
"#;

fn machine() -> String {
    [ROTOR, STUDIES].concat()
}

fn assert_same(a: &Path, b: &Path) {
    let (a, b) = (tree(a), tree(b));
    assert!(a.keys().eq(b.keys()), "{:?}\n{:?}", a.keys(), b.keys());
    for (path, content) in &a {
        assert!(b[path] == *content, "{} differs", path.display());
    }
}

fn part(dir: &Dir, part: &str, out: &str) -> Child {
    let mut command = dir.command(["run", "m.toml", "--part", part, "--out", out, "--quiet"]);
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

#[test]
fn parts_in_any_order_give_the_files_of_one_run() {
    let dir = Dir::new("pieces");
    dir.file("m.toml", machine());
    dir.laval(["run", "m.toml", "--out", "whole"]).done();
    let text = dir.laval(["run", "m.toml", "--part", "2/3", "--out", "o"]);
    assert!(text.done().contains("tolerances: part 2 of 3: 64 of 64 rows are there"), "{}", text.out);
    dir.laval(["run", "m.toml", "--part", "3/3", "--out", "o"]).done();
    // two at once compute the same part, and a part that is there already is left as it is
    let mut twins = [part(&dir, "1/3", "o"), part(&dir, "1/3", "o"), part(&dir, "2/3", "o")];
    assert!(twins.iter_mut().all(|c| c.wait().unwrap().success()));
    dir.laval(["collect", "m.toml", "--out", "o"]).done();
    assert_same(&dir.0.join("whole"), &dir.0.join("o"));
}

#[test]
fn what_a_killed_part_leaves_is_completed_by_another() {
    let dir = Dir::new("killed-pieces");
    dir.file("m.toml", machine().replace("samples = 200", "samples = 2000"));
    dir.laval(["run", "m.toml", "--out", "whole", "--quiet"]).done();
    for wait in [5, 20, 60, 150] {
        let mut one = part(&dir, "1/2", "o");
        std::thread::sleep(Duration::from_millis(wait));
        let _ = one.kill();
        let _ = one.wait();
    }
    // another division of the same work
    for k in 1..=5 {
        dir.laval(["run", "m.toml", "--part", &format!("{k}/5"), "--out", "o", "--quiet"]).done();
    }
    dir.laval(["collect", "m.toml", "--out", "o", "--quiet"]).done();
    assert_same(&dir.0.join("whole"), &dir.0.join("o"));
}

#[test]
fn a_collection_misses_no_row() {
    let dir = Dir::new("missing-pieces");
    dir.file("m.toml", machine());
    dir.laval(["run", "m.toml", "--part", "1/2", "--out", "o"]).done();
    let before = tree(&dir.0.join("o"));
    let said = dir.laval(["collect", "m.toml", "--out", "o", "--quiet"]);
    said.refused(&["study \"tolerances\"", "96 of 200 rows are missing, those of the chunks 2, 4, 6, 8, 10, 12 of 13", "laval run"]);
    let after = tree(&dir.0.join("o"));
    let chunks = |t: &BTreeMap<PathBuf, Vec<u8>>| t.keys().filter(|p| p.extension().is_some_and(|e| e == "parquet")).count();
    assert_eq!(chunks(&before), chunks(&after));
    assert!(!after.contains_key(Path::new("results.json")) && !after.contains_key(Path::new("report.html")));
    // a damaged chunk is a missing one
    dir.laval(["run", "m.toml", "--part", "2/2", "--out", "o"]).done();
    let chunk = dir.0.join("o/tolerances/chunk-000004.parquet");
    let mut bytes = fs::read(&chunk).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&chunk, &bytes).unwrap();
    dir.laval(["collect", "m.toml", "--out", "o", "--quiet"]).refused(&["is damaged", "those of the chunks 5 of 13"]);
    assert_eq!(dir.laval(["run", "m.toml", "--part", "1/2", "--out", "o"]).code, 0);
    dir.laval(["collect", "m.toml", "--out", "o"]).done();
}

#[test]
fn parts_of_another_machine_are_not_mixed() {
    let dir = Dir::new("foreign-pieces");
    dir.file("m.toml", machine());
    dir.laval(["run", "m.toml", "--out", "o"]).done();
    dir.file("m.toml", machine().replace("1e5 N/m", "2e5 N/m"));
    dir.laval(["run", "m.toml", "--part", "1/2", "--out", "o"]).refused(&["another input", "stiffness", "--out"]);
    // without a manifest the marks in the chunks show whose they are
    fs::remove_file(dir.0.join("o/tolerances/manifest.json")).unwrap();
    dir.laval(["collect", "m.toml", "--out", "o", "--only", "tolerances"]).refused(&["not of this study", "200 of 200 rows are missing"]);
}

#[test]
fn the_plan_names_what_divides() {
    let dir = Dir::new("plan");
    dir.file("m.toml", machine());
    let text = dir.laval(["plan", "m.toml"]);
    for words in ["tolerances", "200", "13", "slow", "part 1 computes it", "laval run m.toml --part I/N", "joins them and computes modes"] {
        assert!(text.done().contains(words), "{words} in\n{}", text.out);
    }
    let json: serde_json::Value = serde_json::from_str(dir.laval(["plan", "m.toml", "--json"]).done()).unwrap();
    let studies = json["studies"].as_array().unwrap();
    let of = |k: usize, key: &str| studies[k][key].as_u64().unwrap();
    assert_eq!((of(0, "rows"), of(0, "rows_of_a_chunk"), of(0, "chunks"), of(0, "parts_at_most")), (200, 16, 13, 13));
    assert_eq!((studies[1]["kind"].as_str(), of(1, "parts_at_most")), (Some("sweep"), 1));
    assert_eq!(studies[0]["input"]["part"][0]["mass"].as_f64(), Some(1.0));
    assert!(!dir.0.join("out").exists());
    dir.file("small.toml", machine().split("[[study]]\nkind = \"uncertainty\"").next().unwrap());
    assert!(dir.laval(["plan", "small.toml"]).done().contains("No study of small.toml divides"));
    dir.laval(["run", "small.toml", "--part", "1/3", "--out", "s"]).refused(&[
        "part.none",
        "no study of small.toml divides into parts",
        "leave out --part",
    ]);
    // more parts than there are chunks: some would have nothing to do
    dir.laval(["run", "m.toml", "--part", "1/30", "--out", "p"]).refused(&["part.many", "30 parts", "more than 13", "laval plan"]);
    dir.laval(["run", "m.toml", "--part", "30/30", "--out", "p"]).refused(&["part.many"]);
    for wrong in ["0/3", "4/3", "3", "a/b"] {
        dir.laval(["run", "m.toml", "--part", wrong]).refused(&["--part", wrong]);
    }
}
