use crate::client::Studio;
use serde_json::{Value as Json, json};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

const MACHINE: &str = r#"
[machine]
name = "rotor"
speed = "3000 rpm"
[[part]]
kind = "disc"
name = "drum"
mass = "2.4 kg"
eccentricity = "50 um"
[[part]]
kind = "foundation"
name = "base"
mass = "25 kg"
stiffness = "3.26e5 N/m"
damping = "6.59 N s/m"
[[part]]
kind = "bearing_cubic"
name = "bearing"
between = ["drum", "base"]
law = "per_axis"
stiffness = "1.1e7 N/m"
cubic_stiffness = "8.7e10 N/m^3"
[[part]]
kind = "damper"
between = ["drum", "ground"]
damping = "42 N s/m"
[[study]]
kind = "sweep"
name = "sweep"
speed = { from = "2000 rad/s", to = "3000 rad/s", points = 600 }
start = "rest"
[[study]]
kind = "optimum"
name = "best"
study = { kind = "modes", speed = "3000 rpm" }
vary = [{ parameter = "drum.mass", from = "1 kg", to = "6 kg" }, { parameter = "base.mass", from = "10 kg", to = "60 kg" }]
maximise = "least_damped_mode damping ratio"
starts = 3
runs = 2000
"#;

/// All files below a folder.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut out = BTreeMap::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(dir) = open.pop() {
        for entry in fs::read_dir(dir).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else {
                out.insert(path.strip_prefix(folder).unwrap().to_string_lossy().into_owned(), fs::read(&path).unwrap());
            }
        }
    }
    out
}

impl Studio {
    fn run(&self, study: &str) -> String {
        fs::write(self.folder.join("separator.toml"), MACHINE).unwrap();
        self.post("api/runs", &json!({ "text": MACHINE, "study": study })).json()["id"].as_str().unwrap().to_string()
    }

    /// Waits until it stands so.
    fn until(&self, id: &str, fits: impl Fn(&Json) -> bool) -> Json {
        let begun = Instant::now();
        loop {
            assert!(begun.elapsed() < Duration::from_secs(120), "run {id} goes on");
            let event = self.event(id);
            if fits(&event) {
                return event;
            }
            assert!(!matches!(event["state"].as_str(), Some("failed")), "{event}");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// How far a run is.
    fn event(&self, id: &str) -> Json {
        let all = self.get("api/runs").json();
        all["runs"].as_array().unwrap().iter().find(|r| r["id"] == id).unwrap_or_else(|| panic!("{id}: {all}")).clone()
    }

    fn steer(&self, id: &str, what: &str) {
        self.post(&format!("api/runs/{id}/{what}"), &json!({})).json();
    }
}

#[test]
fn a_run_that_is_paused_and_resumed_gives_the_same_bits() {
    let (undisturbed, paused) = (Studio::new("whole"), Studio::new("paused"));
    let id = undisturbed.run("sweep");
    undisturbed.until(&id, |e| e["state"] == "done");
    let id = paused.run("sweep");
    let mut pauses = 0;
    loop {
        let before = paused.until(&id, |e| e["state"] == "done" || e["done"].as_u64() > Some(0));
        if before["state"] == "done" || pauses == 4 {
            break;
        }
        paused.steer(&id, "pause");
        let rest = paused.until(&id, |e| e["state"] == "paused" || e["state"] == "done");
        if rest["state"] == "paused" {
            pauses += 1;
            // nothing goes on meanwhile, and the folder is free
            let now = files(&paused.folder.join("out"));
            std::thread::sleep(Duration::from_millis(300));
            assert_eq!(now, files(&paused.folder.join("out")));
            assert_eq!(paused.event(&id)["state"], "paused");
        }
        paused.steer(&id, "resume");
        std::thread::sleep(Duration::from_millis(30));
    }
    paused.until(&id, |e| e["state"] == "done");
    assert!(pauses > 0, "it was over before it was paused");
    let (a, b) = (files(&undisturbed.folder.join("out")), files(&paused.folder.join("out")));
    assert!(a.keys().any(|k| k.ends_with("report.html")) && a.keys().any(|k| k.ends_with(".parquet")), "{:?}", a.keys());
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    for (name, content) in &a {
        assert!(content == &b[name], "{name} differs");
    }
    let page = paused.get(&format!("api/runs/{id}/report"));
    assert!(page.status == 200 && page.head.to_lowercase().contains("sandbox"));
    assert_eq!(page.body, b["separator/report.html"]);
}

/// A study without chunks is held where it is, and goes on.
#[test]
fn a_study_without_chunks_is_held() {
    let s = Studio::new("held");
    let id = s.run("best");
    s.until(&id, |e| e["done"].as_u64() > Some(0));
    s.steer(&id, "pause");
    let rest = s.until(&id, |e| e["state"] != "running");
    if rest["state"] == "paused" {
        std::thread::sleep(Duration::from_millis(400));
        let later = s.event(&id);
        assert_eq!((&later["state"], &later["done"]), (&rest["state"], &rest["done"]));
        s.steer(&id, "resume");
    }
    s.until(&id, |e| e["state"] == "done");
}

#[test]
fn a_run_is_cancelled_and_a_wrong_one_refused() {
    let s = Studio::new("ended");
    let id = s.run("sweep");
    s.until(&id, |e| e["done"].as_u64() > Some(0));
    s.steer(&id, "pause");
    s.until(&id, |e| e["state"] != "running");
    s.steer(&id, "cancel");
    let end = s.until(&id, |e| e["state"] != "running" && e["state"] != "paused");
    assert!(end["state"] == "cancelled" || end["state"] == "done", "{end}");
    // what it has computed can be read
    assert_eq!((&end["report"], s.get(&format!("api/runs/{id}/report")).status), (&json!(true), 200));
    // a page that is opened later finds all runs
    let all = s.get("api/runs").json();
    assert_eq!((&all["runs"][0]["id"], &all["runs"][0]["study"], &all["runs"][0]["state"]), (&json!(id), &json!("sweep"), &end["state"]));
    assert_eq!(s.post("api/runs", &json!({ "text": MACHINE, "study": "none" })).status, 422);
    assert_eq!(s.post("api/runs", &json!({ "text": "[[part]]", "study": "sweep" })).status, 422);
    assert_eq!(s.post("api/runs", &json!({ "text": MACHINE, "study": "sweep", "file": "../x.toml" })).status, 422);
}
