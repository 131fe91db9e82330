//! The folder of results: what two runs, a kill, links, odd names and a failing disk may not do to it.

use crate::launcher::{Dir, ROTOR, tree};
use std::fs;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::Duration;

fn response(name: &str, points: usize) -> String {
    let name = serde_json::Value::from(name);
    format!("[[study]]\nkind = \"forced_response\"\nname = {name}\nspeed = {{ from = 10, to = 1000, points = {points} }}\n")
}

fn uncertain(name: &str, study: &str) -> String {
    format!(
        "[[study]]\nkind = \"uncertainty\"\nname = \"{name}\"\nstudy = \"{study}\"\nsamples = 4\n\
         parameters = [{{ parameter = \"d.mass\", distribution = \"normal\", deviation = \"2 %\" }}]\n"
    )
}

const LONG: &str = "[[study]]\nkind = \"transient\"\nname = \"long\"\nduration = \"1e7 s\"\n";

#[test]
fn the_folder_of_a_study_does_not_depend_on_what_else_is_run() {
    let dir = Dir::new("collision");
    let studies = [response("a b", 5), response("a-b", 50), uncertain("u p", "a b"), uncertain("u-p", "a-b"), response("a", 7)].concat();
    dir.file("x.toml", format!("{ROTOR}{studies}"));
    dir.laval(["run", "x.toml", "--out", "o"]).done();
    let whole = tree(&dir.0.join("o"));
    for study in ["a b", "a-b", "u p", "u-p", "a", "forced_response", "uncertainty"] {
        dir.laval(["run", "x.toml", "--out", "o", "--only", study]).done();
        dir.laval(["run", "x.toml", "--out", "alone", "--only", study]).done();
        let now = tree(&dir.0.join("o"));
        assert!(whole.keys().eq(now.keys()), "{study}: {:?}", now.keys());
        // what speaks of the run as a whole
        let common = ["results.json", "report.html", "manifest.json"];
        let apart = |p: &PathBuf| !common.contains(&p.to_str().unwrap());
        assert!(whole.iter().all(|(p, content)| !apart(p) || now[p] == *content), "{study}");
        let alone = tree(&dir.0.join("alone"));
        assert!(alone.iter().all(|(p, content)| !apart(p) || p.ends_with("manifest.json") || whole[p] == *content), "{study}");
        fs::remove_dir_all(dir.0.join("alone")).unwrap();
    }
}

#[test]
fn results_of_another_machine_file_beside_those_of_this_run_are_named() {
    let dir = Dir::new("outdated");
    let studies = [response("a", 5), response("b", 6)].concat();
    dir.file("x.toml", format!("{ROTOR}{studies}"));
    dir.laval(["run", "x.toml", "--out", "o"]).done();
    dir.laval(["run", "x.toml", "--out", "o", "--only", "b"]).done();
    dir.file("x.toml", format!("{}{studies}", ROTOR.replace("1 kg", "2 kg")));
    let said = dir.laval(["run", "x.toml", "--out", "o", "--only", "b"]);
    assert_eq!((said.code, said.err.as_str()), (0, "warning: o also holds results of study \"a\", which is of an earlier machine file\n"));
    dir.laval(["run", "x.toml", "--out", "o", "--only", "a"]).done();
}

#[test]
fn names_that_are_no_folder_or_are_one_twice() {
    let dir = Dir::new("names");
    let names = [
        "con",
        "nul",
        "lpt1",
        "figures",
        "a b",
        "a-b",
        "A  B",
        "a_b",
        "a-",
        "a name that is as long as a name may be and ends in a number - 1",
        "a name that is as long as a name may be and ends in a number   1",
    ];
    let studies: String = names.iter().enumerate().map(|(i, n)| response(n, 5 + i)).collect();
    dir.file("x.toml", format!("{ROTOR}{studies}"));
    dir.laval(["run", "x.toml", "--out", "o", "--format", "csv,json"]).done();
    let results: serde_json::Value = serde_json::from_str(&dir.read("o/results.json")).unwrap();
    for (i, study) in results["studies"].as_array().unwrap().iter().enumerate() {
        assert_eq!(study["name"], names[i]);
        let file = study["tables"][0]["file"].as_str().unwrap();
        let rows = dir.read(&format!("o/{file}.csv")).lines().filter(|l| !l.starts_with('#')).count() - 1;
        assert_eq!(rows as u64, study["tables"][0]["rows"].as_u64().unwrap(), "{file}");
        assert!(file.len() < 200 && !file.contains("..") && file.split('/').all(|p| !p.ends_with(['.', ' '])), "{file}");
    }
    assert_eq!(fs::read_dir(dir.0.join("o")).unwrap().count(), names.len() + ["results.json", "manifest.json", ".lock"].len());
    // the folder named after a file
    for (file, folder) in [("...toml", "unnamed"), ("a. .toml", "a"), ("con.toml", "con_"), ("my pump.toml", "my pump")] {
        dir.file(file, format!("{ROTOR}{}", response("r", 5)));
        assert_eq!(dir.laval(["run", file]).done().lines().last(), Some(&*format!("out/{folder}/report.html")));
    }
}

#[test]
fn a_folder_that_another_run_writes_is_refused() {
    let dir = Dir::new("locked");
    dir.file("long.toml", format!("{ROTOR}{LONG}"));
    dir.file("x.toml", format!("{ROTOR}{}", response("r", 5)));
    let mut first = dir.command(["run", "long.toml", "--out", "o", "--quiet"]).stderr(Stdio::null()).spawn().unwrap();
    let number = first.id().to_string();
    // a file by which it finds out whether it can write there comes and goes
    let trying = || tree(&dir.0.join("o")).keys().any(|name| name.extension().is_some_and(|e| e == "part"));
    while fs::read_to_string(dir.0.join("o/.lock")).unwrap_or_default() != number || trying() {
        std::thread::sleep(Duration::from_millis(5));
    }
    let before = tree(&dir.0.join("o"));
    // nothing on standard output: there is no report
    dir.laval(["run", "x.toml", "--out", "o"]).refused(&[&format!("another process (number {number}) is writing into o"), "--out"]);
    assert_eq!(tree(&dir.0.join("o")), before);
    first.kill().unwrap();
    first.wait().unwrap();
    // what it has left, its number and no lock, is in nobody's way
    dir.laval(["run", "x.toml", "--out", "o"]).done();
}

#[test]
fn two_runs_at_once_do_not_mix() {
    let dir = Dir::new("race");
    let machine = |e: &str| format!("{}{}{}", ROTOR.replace("10 um", e), response("r", 50), response("s", 60));
    let inputs = ["a.toml", "b.toml"];
    let run =
        |input: &str, out: &str| dir.command(["run", input, "--out", out]).stderr(Stdio::null()).stdout(Stdio::null()).spawn().unwrap();
    let wholes = inputs.map(|input| {
        dir.file(input, machine(if input == "a.toml" { "10 um" } else { "11 um" }));
        assert!(run(input, input.trim_end_matches(".toml")).wait().unwrap().success());
        tree(&dir.0.join(input.trim_end_matches(".toml")))
    });
    for _ in 0..10 {
        let codes = inputs.map(|input| run(input, "o")).map(|mut child| child.wait().unwrap().code());
        assert!(codes.contains(&Some(0)), "{codes:?}");
        let found = tree(&dir.0.join("o"));
        assert!(wholes.contains(&found));
    }
}

#[test]
#[cfg(unix)]
fn a_lock_that_leads_elsewhere_is_left_alone() {
    let dir = Dir::new("links");
    dir.file("x.toml", format!("{ROTOR}{}{}", response("r", 5), uncertain("u", "r")));
    let precious = dir.file("precious", "7");
    for folder in ["o", "o/u"] {
        let lock = dir.0.join(folder).join(".lock");
        let _ = fs::remove_dir_all(dir.0.join("o"));
        fs::create_dir_all(lock.parent().unwrap()).unwrap();
        let ways: [(&str, &dyn Fn()); 4] = [
            ("a link", &|| std::os::unix::fs::symlink(&precious, &lock).unwrap()),
            ("a link to nothing", &|| std::os::unix::fs::symlink(dir.0.join("nothing"), &lock).unwrap()),
            ("a second name", &|| fs::hard_link(&precious, &lock).unwrap()),
            ("a file of somebody else", &|| fs::write(&lock, "mine").unwrap()),
        ];
        for (what, make) in ways {
            make();
            let said = dir.laval(["run", "x.toml", "--out", "o"]);
            assert!(said.code == 1 && said.err.contains(".lock was not made by this program"), "{what}: {}", said.err);
            assert_eq!(dir.read("precious"), "7", "{what}");
            assert!(!dir.0.join("nothing").exists(), "{what}");
            assert!(what != "a file of somebody else" || fs::read_to_string(&lock).unwrap() == "mine");
            fs::remove_file(&lock).unwrap();
        }
        dir.laval(["run", "x.toml", "--out", "o"]).done();
    }
    // a file of results may be a link: the link is replaced, not what it leads to
    let page = dir.0.join("o/report.html");
    fs::remove_file(&page).unwrap();
    std::os::unix::fs::symlink(&precious, &page).unwrap();
    dir.laval(["run", "x.toml", "--out", "o"]).done();
    assert!(dir.read("precious") == "7" && page.symlink_metadata().unwrap().is_file());
}

#[test]
fn killed_at_any_moment_the_next_run_leaves_the_same_folder() {
    let dir = Dir::new("kill");
    let studies: String = (0..6).map(|i| response(&format!("r{i}"), 100 + i)).collect();
    dir.file("x.toml", format!("{ROTOR}{studies}{}", uncertain("u", "r0")));
    dir.laval(["run", "x.toml", "--out", "whole"]).done();
    let whole = tree(&dir.0.join("whole"));
    let mut seed = 0x2545_f491_4f6c_dd1d_u64;
    for _ in 0..20 {
        let mut child = dir.command(["run", "x.toml", "--out", "o"]).stderr(Stdio::null()).stdout(Stdio::null()).spawn().unwrap();
        // xorshift64
        seed ^= seed << 13;
        seed ^= seed >> 7;
        seed ^= seed << 17;
        std::thread::sleep(Duration::from_micros(1000 + seed % 150_000));
        child.kill().unwrap();
        child.wait().unwrap();
    }
    for unfinished in ["o/.laval-1-0.part", "o/r0/.laval-4194304-12.part", "o/figures/.laval-1-1.part", "o/u/.laval-1-1.part"] {
        dir.file(unfinished, "half");
    }
    dir.laval(["run", "x.toml", "--out", "o"]).done();
    assert!(tree(&dir.0.join("o")) == whole, "{:?}", tree(&dir.0.join("o")).keys());
}

/// No folder of the kernel takes files, not even those of root.
#[test]
#[cfg(target_os = "linux")]
fn a_folder_that_cannot_be_written_is_noticed_before_computing() {
    let dir = Dir::new("readonly");
    dir.file("long.toml", format!("{ROTOR}{LONG}"));
    dir.laval(["run", "long.toml", "--out", "/proc/self"]).refused(&["cannot write /proc/self", "--out"]);
    // the folder can be written, that of a study cannot
    for (name, what) in [("long", "/proc/self/fdinfo"), ("figures", "/proc/self/fdinfo")] {
        let out = dir.0.join(format!("o-{name}"));
        fs::create_dir_all(&out).unwrap();
        std::os::unix::fs::symlink(what, out.join(name)).unwrap();
        dir.laval(["run", "long.toml", "--out", out.to_str().unwrap()]).refused(&["cannot write", name, "--out"]);
    }
    dir.file("o/figures", "a file");
    dir.laval(["run", "long.toml", "--out", "o"]).refused(&["o/figures is no folder"]);
    dir.file("p/manifest.json", "{ \"name\": \"a web page\" }");
    dir.laval(["run", "long.toml", "--out", "p"]).refused(&["p/manifest.json is a file of another program"]);
    assert_eq!(dir.read("p/manifest.json"), "{ \"name\": \"a web page\" }");
}

/// A limit on the size of files stands for a disk that fills up on the way.
#[test]
#[cfg(target_os = "linux")]
fn a_disk_that_fails_on_the_way_leaves_whole_files_and_the_next_run_mends() {
    let dir = Dir::new("disk");
    dir.file("x.toml", format!("{ROTOR}{}{}", response("r", 200), uncertain("u", "r")));
    dir.laval(["run", "x.toml", "--out", "whole"]).done();
    let whole = tree(&dir.0.join("whole"));
    let mut failed = 0;
    for blocks in [0, 1, 2, 4, 8, 16, 32, 64, 128, 256] {
        let limited = format!("trap '' XFSZ; ulimit -f {blocks}; exec {} run x.toml --out o 2>err", env!("CARGO_BIN_EXE_laval"));
        let done = std::process::Command::new("sh").args(["-c", &limited]).current_dir(&dir.0).stdout(Stdio::null()).status().unwrap();
        if !done.success() {
            failed += 1;
            assert_eq!(done.code(), Some(1));
        }
        if dir.0.join("o").exists() {
            for (path, content) in tree(&dir.0.join("o")) {
                let name = path.to_str().unwrap();
                let settled = [".lock", "manifest.json", "results.json", "report.html"].iter().all(|f| !name.ends_with(f));
                assert!(!settled || whole.get(&path) == Some(&content), "{blocks}: {name}");
            }
        }
    }
    assert!(failed > 3, "{failed}");
    let limited = format!("trap '' XFSZ; ulimit -f 1; exec {} new oil-separator 2>err", env!("CARGO_BIN_EXE_laval"));
    assert!(!std::process::Command::new("sh").args(["-c", &limited]).current_dir(&dir.0).status().unwrap().success());
    assert!(!dir.0.join("oil-separator.toml").exists());
    dir.laval(["run", "x.toml", "--out", "o"]).done();
    assert!(tree(&dir.0.join("o")) == whole);
}
