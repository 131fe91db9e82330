use super::*;
use crate::hash::sha256;
use crate::store::{Piece, Reader};
use serde_json::{Value as Json, json};
use std::fs;
use std::path::PathBuf;

const MACHINE: &str = r#"
[machine]
name = "rotor"
speed = "2000 rpm"
[[part]]
kind = "disc"
name = "disc"
mass = "3 kg"
[[part]]
kind = "shaft_lumped"
name = "shaft"
between = ["disc", "ground"]
stiffness = "3e5 N/m"
[[part]]
kind = "damper"
name = "air"
between = ["disc", "ground"]
damping = "20 N s/m"
[[study]]
kind = "modes"
"#;

fn loaded() -> Loaded {
    file::load_bytes(MACHINE.as_bytes()).unwrap()
}

fn request(design: Json, chunk: usize) -> Request {
    let mut out: Request = serde_json::from_value(json!({ "study": "modes", "design": design, "chunk": chunk })).unwrap();
    let loaded = loaded();
    // numbers of a list need its folder; those of this machine are always the same
    let probe = serde_json::from_value(json!({ "kind": "grid", "axes": [["disc.mass", [3.0]]] })).unwrap();
    let probe = Request { design: probe, ..out.clone() };
    out.numbers = Cases::new(&loaded, probe, None).unwrap().numbers(&Context::quiet("cases")).unwrap();
    out
}

fn grid() -> Json {
    json!({ "kind": "grid", "axes": [["disc.mass", [2.0, 3.0, -1.0]], ["shaft.stiffness", [1e5, 2e5, 3e5, 4e5]]] })
}

struct Dir(PathBuf);

impl Dir {
    fn new(name: &str) -> Dir {
        let dir = std::env::temp_dir().join(format!("laval-cases-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&dir);
        fs::create_dir_all(&dir).unwrap();
        Dir(dir)
    }
    fn files(&self) -> Vec<(String, Vec<u8>)> {
        let all = fs::read_dir(&self.0).unwrap().map(|e| e.unwrap().path());
        let mut all: Vec<_> = all.map(|p| (p.file_name().unwrap().to_string_lossy().into_owned(), fs::read(p).unwrap())).collect();
        all.sort();
        all
    }
}

impl Drop for Dir {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn kept(cases: &Cases, dir: &Dir, work: Work) -> Result<(), Diagnostic> {
    let keep = cases.keep(&dir.0, work);
    cases.run(&Context { keep: Some(&keep), ..Context::quiet("cases") }).map(drop)
}

#[test]
fn the_last_axis_of_a_grid_varies_first() {
    let loaded = loaded();
    let cases = Cases::new(&loaded, request(grid(), 5), None).unwrap();
    assert_eq!((cases.cases(), cases.plan().chunks()), (12, 3));
    let results = cases.run(&Context::quiet("cases")).unwrap();
    let (mass, stiffness) = (results.numbers("disc.mass").unwrap(), results.numbers("shaft.stiffness").unwrap());
    assert_eq!(mass, [2.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0, -1.0, -1.0, -1.0, -1.0]);
    assert_eq!(stiffness, [1e5, 2e5, 3e5, 4e5].repeat(3));
    // a mode of the Laval rotor: s = -c/2m + i sqrt(k/m - (c/2m)^2), c = 20 N s/m
    for (row, found) in results.numbers("stable").unwrap().into_iter().enumerate() {
        let exact = -10.0 / mass[row];
        if mass[row] > 0.0 {
            assert!((found / exact - 1.0).abs() < 1e-12, "{found} {exact}");
        } else {
            assert!(found.is_nan());
        }
    }
    for (row, found) in results.numbers("least_damped_mode damping ratio").unwrap().into_iter().enumerate() {
        let exact = 10.0 / (stiffness[row] * mass[row]).sqrt();
        assert!(mass[row] < 0.0 || (found / exact - 1.0).abs() < 1e-10, "{found} {exact}");
    }
    let failed = results.position(FAILURE).unwrap();
    let words: Vec<String> = results
        .chunks()
        .flat_map(|c| {
            (0..c.as_ref().unwrap().rows.len()).map(|i| c.as_ref().unwrap().cells[failed].word(i).unwrap().to_string()).collect::<Vec<_>>()
        })
        .collect();
    assert!(words[..8].iter().all(String::is_empty) && words[8..].iter().all(|w| w.contains("mass")), "{words:?}");
}

#[test]
fn parts_in_any_order_give_the_files_of_one_run() {
    let loaded = loaded();
    let spread = json!([{ "parameter": "disc.mass", "distribution": "normal", "deviation": "5 %" }, { "parameter": "air.damping", "distribution": "uniform", "from": 10.0, "to": 30.0 }]);
    for kind in ["sobol", "latin_hypercube", "random"] {
        let design = json!({ "kind": kind, "cases": 50, "seed": 4, "parameters": spread });
        let cases = Cases::new(&loaded, request(design, 7), None).unwrap();
        let (whole, parts) = (Dir::new(&format!("whole-{kind}")), Dir::new(&format!("parts-{kind}")));
        kept(&cases, &whole, Work::Missing).unwrap();
        for number in [3, 1, 3] {
            assert_eq!(kept(&cases, &parts, Work::Piece(Piece::new(number, 3).unwrap())).unwrap_err().code, store::NO_RESULT);
        }
        assert_eq!(kept(&cases, &parts, Work::Collect).unwrap_err().code, store::MISSING);
        // divided anew
        for number in [2, 1] {
            assert_eq!(kept(&cases, &parts, Work::Piece(Piece::new(number, 2).unwrap())).unwrap_err().code, store::NO_RESULT);
        }
        kept(&cases, &parts, Work::Collect).unwrap();
        assert!(whole.files() == parts.files(), "{kind}");
        let reader = Reader::new(cases.plan(), &cases.keep(&parts.0, Work::Collect));
        let mass: Vec<f64> = (0..8)
            .flat_map(|k| {
                let chunk = reader.chunk(k).unwrap().unwrap();
                (0..chunk.rows.len()).map(|i| chunk.cells[1].number(i)).collect::<Vec<_>>()
            })
            .collect();
        assert_eq!(mass.len(), 50);
        assert!(mass.iter().all(|m| (2.0..4.0).contains(m)) && mass.windows(2).any(|w| w[0] != w[1]));
        // a file that is not of these cases, and one that is damaged
        let other = Cases::new(&loaded, request(json!({ "kind": kind, "cases": 50, "seed": 5, "parameters": spread }), 7), None).unwrap();
        let wrong = Reader::new(other.plan(), &other.keep(&parts.0, Work::Collect)).chunk(0).unwrap_err();
        assert!(wrong.message.to_string().contains("another study"), "{wrong}");
        fs::write(reader.file(1), &fs::read(reader.file(1)).unwrap()[10..]).unwrap();
        assert!(reader.chunk(1).unwrap_err().message.to_string().contains("damaged"));
        fs::remove_file(reader.file(1)).unwrap();
        assert_eq!(reader.chunk(1).unwrap(), None);
    }
}

#[test]
fn a_list_is_read_from_its_file_and_checked() {
    let loaded = loaded();
    let rows = [[3.0, 20.0], [2.0, f64::NAN], [2.5, 25.0]];
    let bytes: Vec<u8> = rows.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let dir = Dir::new("list");
    fs::write(dir.0.join(LIST), &bytes).unwrap();
    let sums = [sha256(&bytes[..32]), sha256(&bytes[32..])];
    let design = json!({ "kind": "list", "parameters": ["disc.mass", "air.damping"], "cases": 3, "sums": sums });
    let cases = Cases::new(&loaded, request(design, 2), Some(&dir.0)).unwrap();
    let results = cases.run(&Context::quiet("cases")).unwrap();
    assert_eq!(results.numbers("disc.mass").unwrap(), [3.0, 2.0, 2.5]);
    let number = cases.request.numbers[0].name.clone();
    // no number is no value of a damper: a row without results
    assert_eq!(results.numbers(&number).unwrap().iter().map(|x| x.is_nan()).collect::<Vec<_>>(), [false, true, false]);
    assert_eq!(cases.design.of(2, 2).unwrap(), rows[2]);
    let mut changed = bytes;
    changed[40] ^= 1;
    fs::write(dir.0.join(LIST), changed).unwrap();
    let damaged = cases.run(&Context::quiet("cases")).map(drop).unwrap_err();
    assert!(damaged.message.to_string().contains("damaged"), "{damaged}");
}

#[test]
fn what_is_wrong_with_a_request() {
    let loaded = loaded();
    let refused = |design: Json, chunk: usize| {
        let request = serde_json::from_value(json!({ "study": "modes", "design": design, "chunk": chunk })).unwrap();
        let found = Cases::new(&loaded, request, None).map(|_| ()).unwrap_err();
        found.0.iter().map(|d| d.message.to_string()).collect::<Vec<_>>().join("; ")
    };
    let axes = |axes: Json| json!({ "kind": "grid", "axes": axes });
    for (design, chunk, said) in [
        (axes(json!([["disc.mas", [1.0]]])), 1, "no parameter"),
        (axes(json!([["shaft.stiffness", [1.0]], ["shaft.stiffness.x", [2.0]]])), 1, "same parameter"),
        (axes(json!([["disc.mass", []]])), 1, "no case"),
        (axes(json!([])), 1, "no case"),
        (axes(json!([["disc.mass", [1.0]]])), 0, "at least one row"),
        (
            json!({ "kind": "sobol", "cases": 4, "seed": 1, "parameters": [{ "parameter": "disc.mass", "distribution": "normal" }] }),
            1,
            "deviation",
        ),
        (
            json!({ "kind": "sobol", "cases": 4_000_000_000u32, "seed": 1, "parameters": [{ "parameter": "disc.mass", "distribution": "normal", "deviation": 0.1 }] }),
            4_000_000_000,
            "too large",
        ),
        (json!({ "kind": "list", "parameters": ["disc.mass"], "cases": 1, "sums": [""] }), 1, "folder"),
    ] {
        let found = refused(design, chunk);
        assert!(found.contains(said), "{found}");
    }
    let none = serde_json::from_value(json!({ "study": "mods", "design": grid() })).unwrap();
    assert!(Cases::new(&loaded, none, None).map(|_| ()).unwrap_err().0[0].message.to_string().contains("no study"));
}

/// As many files as a cluster can share, none so large that a kill costs much, and never more than the store has.
#[test]
fn files_follow_from_the_number_of_cases() {
    assert_eq!([1, 100, 256, 257, 10_000, 1_000_000].map(chunk_of), [1, 1, 1, 2, 40, 1024]);
    assert!(30_000_000usize.div_ceil(chunk_of(30_000_000)) <= MOST_CHUNKS);
}
