use crate::client::{SEPARATOR, Studio};
use serde_json::{Value as Json, json};

/// Mass 3 kg, stiffness 3e5 N/m, damping 60 N s/m, eccentricity 20 um, at 250 rad/s.
const LAVAL: &str = r#"
    machine = { speed = "250 rad/s" }
    part = [
        { kind = "disc", name = "disc", mass = "3 kg", eccentricity = "20 um" },
        { kind = "shaft_lumped", name = "shaft", between = ["disc", "ground"], stiffness = "3e5 N/m" },
        { kind = "damper", name = "air", between = ["disc", "ground"], damping = "60 N s/m" },
    ]
    study = [{ kind = "transient", name = "knock", duration = "0.05 s", kick = { "disc.x'" = "0.1 m/s" } }]"#;
const SPEED: f64 = 250.0;
const DECAY: f64 = 10.0;

fn motions(s: &Studio, motion: Json, speed: Option<f64>) -> Json {
    let mut request = json!({ "text": LAVAL, "want": ["motion"], "motion": motion });
    if let Some(speed) = speed {
        request["speed"] = json!(speed);
    }
    s.post("api/answer", &request).lines()[0].clone()
}

/// Amplitude of x: `e W^2 / (k/m - W^2 + i W c/m)`.
fn amplitude(w: f64) -> [f64; 2] {
    let (a, b) = (1e5 - w * w, 20.0 * w);
    let f = 20e-6 * w * w / (a * a + b * b);
    [f * a, -f * b]
}

fn near(found: &Json, expected: [f64; 2], tolerance: f64) {
    let found = [0, 1].map(|k| found[k].as_f64().unwrap());
    let size = expected[0].hypot(expected[1]);
    assert!((found[0] - expected[0]).hypot(found[1] - expected[1]) < tolerance * size, "{found:?} {expected:?}");
}

#[test]
fn the_response_is_played_with_its_amplitudes() {
    let s = Studio::new("forced-motion");
    for kind in ["forced", "nonlinear"] {
        for speed in [None, Some(330.0)] {
            let a = motions(&s, json!({ "kind": kind }), speed);
            let w = speed.unwrap_or(SPEED);
            assert_eq!(a["speed"], w, "{a}");
            let all = a["motions"].as_array().unwrap_or_else(|| panic!("{kind}: {a}"));
            assert_eq!(all.len(), 1);
            let (station, x) = (&all[0]["stations"][0], amplitude(w));
            assert_eq!((&station["body"], &all[0]["frequency"]), (&json!("disc"), &json!(w)));
            near(&station["x"], x, 1e-6);
            // a circle: y follows x a quarter of a turn later
            near(&station["y"], [x[1], -x[0]], 1e-6);
            let size = all[0]["size"].as_f64().unwrap();
            assert!((size / x[0].hypot(x[1]) - 1.0).abs() < 1e-6);
        }
    }
}

#[test]
fn a_transient_is_that_of_the_equation() {
    let s = Studio::new("transient");
    let [re, im] = amplitude(SPEED);
    let damped = (1e5 - DECAY * DECAY).sqrt();
    for (motion, kick) in [(json!({ "kind": "transient" }), 0.0), (json!({ "kind": "transient", "study": "knock" }), 0.1)] {
        let a = motions(&s, motion, None);
        let m = &a["motions"][0];
        let number = |x: &Json| x.as_f64().unwrap_or_else(|| panic!("{a}"));
        let (times, path) = (m["frames"]["times"].as_array().unwrap(), &m["frames"]["paths"][0]);
        assert!(times.len() >= 240 && number(&times[0]) == 0.0);
        let end = number(times.last().unwrap());
        assert!(if kick > 0.0 { (end - 0.05).abs() < 1e-6 } else { end > 4.0 * std::f64::consts::TAU / damped });
        let mut most = 0.0f64;
        for (i, t) in times.iter().enumerate() {
            let t = number(t);
            let (c1, c2) = (-re, (kick + SPEED * im - DECAY * re) / damped);
            let free = (-DECAY * t).exp() * (c1 * (damped * t).cos() + c2 * (damped * t).sin());
            let x = re * (SPEED * t).cos() - im * (SPEED * t).sin() + free;
            most = most.max(x.abs());
            let error = (number(&path["x"][i]) - x).abs();
            assert!(error < 2e-3 * 60e-6, "{error} at {t} of {x}");
        }
        assert!(number(&m["size"]) >= 0.99 * most);
    }
}

#[test]
fn motions_that_cannot_be_are_refused_in_words() {
    let s = Studio::new("no-motion");
    let error = |text: &str, motion: Json| {
        let lines = s.post("api/answer", &json!({ "text": text, "want": ["motion"], "motion": motion })).lines();
        lines[0]["error"].as_str().unwrap_or_else(|| panic!("{lines:?}")).to_string()
    };
    assert!(error(LAVAL, json!({ "kind": "transient", "study": "none" })).contains("none"));
    assert!(error(&LAVAL.replace(", eccentricity = \"20 um\"", ""), json!({ "kind": "forced" })).contains("nothing forces"));
    assert!(error(&LAVAL.replace("speed = \"250 rad/s\"", "").replace("study = [", "#"), json!({ "kind": "forced" })).contains("speed"));
    assert!(!error(LAVAL, Json::Null).is_empty());
    assert_eq!(s.post("api/answer", &json!({ "text": LAVAL, "want": ["motion"], "motion": { "kind": "other" } })).status, 400);
}

#[test]
fn sliders_end_where_the_file_describes_no_machine() {
    let s = Studio::new("ranges");
    let a = s.post("api/ranges", &json!({ "serial": 5, "text": SEPARATOR })).json();
    let range = |path: &str| {
        let r = a["ranges"].as_array().unwrap().iter().find(|r| r["path"] == path).unwrap_or_else(|| panic!("{path} in {a}"));
        ["low", "high"].map(|k| r[k].as_f64().unwrap())
    };
    assert_eq!(a["serial"], 5);
    // the cavity has 70 mm, its free surface 46.7 mm
    let [_, high] = range("oil.free_surface_radius");
    assert!((0.069..0.07).contains(&high), "{high}");
    let [low, _] = range("oil.cavity_radius");
    assert!((0.0467..0.0475).contains(&low), "{low}");
    for r in a["ranges"].as_array().unwrap() {
        for end in ["low", "high"] {
            let set = json!([{ "path": r["path"], "value": r[end] }]);
            let checked = s.post("api/check", &json!({ "text": SEPARATOR, "set": set })).json();
            assert!(checked["machine"].is_object(), "{r} {end}");
        }
    }
    assert_eq!(s.post("api/ranges", &json!({ "text": "[[part]]" })).status, 422);
}

#[test]
fn axes_have_sliders_where_the_file_writes_them() {
    let s = Studio::new("axes");
    let paths = |damping: &str| -> Vec<String> {
        let text = LAVAL.replace("damping = \"60 N s/m\"", damping);
        let a = s.post("api/check", &json!({ "text": text })).json();
        let all = a["machine"]["parameters"].as_array().unwrap_or_else(|| panic!("{a}"));
        all.iter().filter_map(|p| p["path"].as_str()).filter(|p| p.starts_with("air.damping")).map(str::to_string).collect()
    };
    assert_eq!(paths("damping = \"60 N s/m\""), ["air.damping"]);
    assert_eq!(paths("damping = { x = \"60 N s/m\", y = \"50 N s/m\" }"), ["air.damping.x", "air.damping.y"]);
}
