use crate::client::{SEPARATOR, Studio, TOKEN};
use serde_json::{Value as Json, json};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

fn applied(text: &str, edits: &Json) -> String {
    let units: Vec<u16> = text.encode_utf16().collect();
    let (mut out, mut at) = (Vec::new(), 0);
    for e in edits.as_array().unwrap() {
        let [from, to] = ["from", "to"].map(|k| e[k].as_u64().unwrap() as usize);
        out.extend_from_slice(&units[at..from]);
        out.extend(e["insert"].as_str().unwrap().encode_utf16());
        at = to;
    }
    out.extend_from_slice(&units[at..]);
    String::from_utf16(&out).unwrap()
}

#[test]
fn the_page_begins_with_the_file_its_words_and_what_can_be_written() {
    let s = Studio::new("start");
    let a = s.get("api/start?lang=ru").json();
    assert_eq!((&a["file"], &a["text"], &a["language"]), (&json!("separator.toml"), &json!(SEPARATOR), &json!("ru")));
    assert_eq!(a["languages"].as_array().unwrap().len(), 4);
    assert_eq!(a["decimal"], ",");
    assert!(a["words"].as_object().unwrap().len() > 1 && a["words"]["page-reset"].is_string());
    let disc = a["completion"]["parts"].as_array().unwrap().iter().find(|k| k["kind"] == "disc").unwrap();
    let mass = disc["keys"].as_array().unwrap().iter().find(|k| k["name"] == "mass").unwrap();
    assert_eq!((&mass["unit"], &mass["required"]), (&json!("kg"), &json!(true)));
    assert_eq!(s.get("api/open?example=oil-separator").json()["text"], SEPARATOR);
    assert_eq!(s.get("api/open?example=none").status, 422);
    assert!(s.get("").text().contains("<html") && s.get("assets/studio.js").status == 200);
}

#[test]
fn a_mistake_is_reported_at_its_place_in_code_units() {
    let s = Studio::new("check");
    let text = format!("# ж😀\n{}", SEPARATOR.replace("mass = \"2.4 kg\"", "mass = \"2.4 mm\""));
    let a = s.post("api/check", &json!({ "serial": 7, "text": text })).json();
    assert_eq!(a["serial"], 7);
    assert!(a["machine"].is_null());
    let d = &a["diagnostics"][0];
    let units: Vec<u16> = text.encode_utf16().collect();
    let [from, to] = ["from", "to"].map(|k| d[k].as_u64().unwrap() as usize);
    assert_eq!(String::from_utf16(&units[from - 5..to + 1]).unwrap(), "\"2.4 mm\"");
    assert_eq!((&d["severity"], &d["code"]), (&json!("error"), &json!("unit.dimension")));
    let russian = s.post("api/check?lang=ru", &json!({ "text": text })).json();
    assert_ne!(russian["diagnostics"][0]["message"], d["message"]);
}

#[test]
fn a_machine_has_parameters_a_section_and_studies() {
    let s = Studio::new("machine");
    let m = s.post("api/check", &json!({ "text": SEPARATOR })).json()["machine"].take();
    let all = m["parameters"].as_array().unwrap();
    let of = |path: &str| all.iter().find(|p| p["path"] == path).unwrap_or_else(|| panic!("{path}"));
    let surface = of("oil.free_surface_radius");
    assert_eq!((&surface["value"], &surface["shown"], &surface["unit"]), (&json!(0.0467), &json!("46.7 mm"), &json!("m")));
    let [from, to] = ["from", "to"].map(|k| surface[k].as_u64().unwrap() as usize);
    assert_eq!(String::from_utf16(&SEPARATOR.encode_utf16().collect::<Vec<_>>()[from..to]).unwrap(), "\"46.7 mm\"");
    assert_eq!(of("machine.speed")["shown"], "3000 rpm");
    assert!(of("drum.unbalance")["from"].is_null());
    for p in all {
        let [low, x, high] = ["low", "value", "high"].map(|k| p[k].as_f64().unwrap());
        assert!(low <= x && x <= high && low < high, "{p}");
    }
    let solids = m["scene"]["solids"].as_array().unwrap();
    let kinds: Vec<&str> = solids.iter().map(|s| s["kind"].as_str().unwrap()).collect();
    assert!(kinds.contains(&"disc") && kinds.contains(&"liquid") && kinds.contains(&"housing") && kinds.contains(&"bearing"), "{kinds:?}");
    // the free surface is drawn where its handle is, and the handle follows it
    let at = |text: &str| {
        let m = s.post("api/check", &json!({ "text": text })).json()["machine"].take();
        let h = m["drawing"]["handles"].as_array().unwrap().iter().find(|h| h["path"] == "oil.free_surface_radius").unwrap().clone();
        (h["x"].as_f64().unwrap(), h["scale"].as_f64().unwrap(), h["value"].as_f64().unwrap())
    };
    let (x, scale, value) = at(SEPARATOR);
    let (x2, _, value2) = at(&SEPARATOR.replace("46.7 mm", "50 mm"));
    assert!(((value2 - value) - scale * (x2 - x)).abs() < 0.02 * (value2 - value), "{x} {x2} {scale}");
    let kinds: Vec<(&str, bool)> =
        m["studies"].as_array().unwrap().iter().map(|s| (s["kind"].as_str().unwrap(), s["quick"].as_bool().unwrap())).collect();
    assert!(kinds.contains(&("modes", true)), "{kinds:?}");
}

#[test]
fn an_edit_keeps_comments_units_and_everything_else() {
    let s = Studio::new("edit");
    let text = format!("# ж😀\n{SEPARATOR}");
    let a = s.post("api/edit", &json!({ "text": text, "set": [{ "path": "machine.speed", "value": 200.0 }, { "path": "oil.free_surface_radius", "written": "5 cm" }] }));
    let after = applied(&text, &a.json()["edits"]);
    let changed: Vec<(&str, &str)> = text.lines().zip(after.lines()).filter(|l| l.0 != l.1).collect();
    assert_eq!(text.lines().count(), after.lines().count());
    assert_eq!(changed.len(), 2);
    assert_eq!(changed[0].1, changed[0].0.replace("3000 rpm", "1909.86 rpm"));
    assert_eq!(changed[1].1, changed[1].0.replace("46.7 mm", "5 cm"));
    let wrong =
        [json!([{ "path": "oil.none", "value": 1 }]), json!([{ "path": "drum.mass", "value": -1 }]), json!([{ "path": "drum.mass" }])];
    for set in wrong {
        let a = s.post("api/edit", &json!({ "text": SEPARATOR, "set": set }));
        assert_eq!(a.status, 422, "{}", a.text());
    }
}

#[test]
fn answers_come_line_by_line_with_figures_shapes_and_targets() {
    let s = Studio::new("answer");
    let want = ["modes", "campbell", "stability", "forced", "nonlinear", "page"];
    let lines = s
        .post("api/answer", &json!({ "serial": 3, "text": SEPARATOR, "want": want, "set": [{ "path": "drum.mass", "value": 2.5 }] }))
        .lines();
    let words: Vec<&str> = lines.iter().map(|l| l["want"].as_str().unwrap()).collect();
    assert_eq!(words, [&["edit"], &want[..]].concat());
    assert!(applied(SEPARATOR, &lines[0]["edits"]).contains("mass = \"2.5 kg\""));
    for l in &lines {
        assert!(l["error"].is_null() && l["serial"] == 3, "{l}");
    }
    let shapes = lines[1]["shapes"].as_array().unwrap();
    assert!(shapes.len() > 3);
    for shape in shapes {
        let sizes = shape["stations"]
            .as_array()
            .unwrap()
            .iter()
            .flat_map(|s| ["x", "y"].map(|k| s[k][0].as_f64().unwrap().hypot(s[k][1].as_f64().unwrap())));
        let largest = sizes.fold(0.0, f64::max);
        assert!((largest - 1.0).abs() < 1e-9, "{shape}");
    }
    for l in &lines[2..6] {
        assert!(l["html"].as_str().unwrap().contains("<figure class=\"fig\""), "{}", l["want"]);
    }
    assert!(lines[6]["html"].as_str().unwrap().contains("class=\"verdict"));
    // targets lie on the axes of their figures
    let campbell = lines[2]["targets"].as_array().unwrap();
    let speed = campbell[0]["x"].as_f64().unwrap() / campbell[0]["factor"].as_f64().unwrap();
    assert!((campbell[0]["which"]["at"].as_f64().unwrap() - speed).abs() < 1e-9 * speed);
    let kinds =
        |k: usize| lines[k]["targets"].as_array().unwrap().iter().map(|t| t["what"].as_str().unwrap().to_string()).collect::<Vec<_>>();
    assert!(kinds(3).contains(&"stability_limit".to_string()), "{:?}", kinds(3));
    assert!(kinds(4).contains(&"resonance".to_string()), "{:?}", kinds(4));
    assert!(kinds(5).contains(&"peak".to_string()), "{:?}", kinds(5));
    // a text with a mistake has none
    let lines = s.post("api/answer", &json!({ "text": "[[part]]", "want": ["modes", "page"] })).lines();
    assert!(lines.len() == 2 && lines.iter().all(|l| l["error"].is_string()));
}

#[test]
fn a_critical_speed_is_pulled_to_where_it_should_be() {
    let s = Studio::new("reach");
    let text = r#"
        machine = { speed = "3000 rpm" }
        part = [
            { kind = "disc", name = "drum", mass = "3 kg" }, # the rotor
            { kind = "shaft_lumped", name = "shaft", between = ["drum", "ground"], stiffness = "3e5 N/m" },
        ]"#;
    let target = json!({ "what": "critical_speed", "which": { "at": 316.0, "order": 1 }, "to": 400.0 });
    let pull = |free: Json| s.post("api/reach", &json!({ "text": text, "target": target, "free": free }));
    let a = pull(json!([{ "path": "shaft.stiffness", "low": 1e5, "high": 9e5 }])).json();
    assert_eq!(a["reached"], true);
    let after = applied(text, &a["edits"]);
    assert!(after.contains("stiffness = \"4.8e5 N/m\"") && after.contains("# the rotor"), "{after}");
    let a = pull(json!([{ "path": "shaft.stiffness", "low": 1e5, "high": 4e5 }])).json();
    assert_eq!((&a["reached"], &a["impossible"]["bounds"]), (&json!(false), &json!(["shaft.stiffness"])));
    let sentence = a["impossible"]["sentence"].as_str().unwrap();
    assert!(sentence.contains("rpm") && sentence.contains("shaft.stiffness"), "{sentence}");
    assert_eq!(pull(json!([])).status, 422);
    assert_eq!(pull(json!([{ "path": "shaft.stiffness", "low": 4e5, "high": 9e5 }])).status, 422);
}

/// Answers that nobody waits for end: as many as there are threads would hold up all others.
#[test]
fn what_is_no_longer_wanted_is_cancelled() {
    let s = Studio::new("cancel");
    let heavy = |k: usize| {
        // each is another text, so that none is remembered
        let text = SEPARATOR.replace("points = 20", &format!("points = {}", 20 + k));
        json!({ "text": format!("{text}\n# {k}"), "want": ["nonlinear", "stability", "campbell", "forced", "page"], "points": 2000 })
            .to_string()
    };
    let path = format!("/{TOKEN}/api/answer");
    let alone = Instant::now();
    assert_eq!(s.request("POST", &path, &[], heavy(100).as_bytes()).status, 200);
    let alone = alone.elapsed();
    for k in 0..32 {
        let mut stream = TcpStream::connect(("127.0.0.1", s.port)).unwrap();
        stream.write_all(&s.bytes("POST", &path, &[], heavy(k).as_bytes())).unwrap();
        // the head of the answer: the computation has begun, or waits for a thread
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        assert!(stream.read(&mut [0; 16]).unwrap() > 0);
    }
    let then = Instant::now();
    assert_eq!(s.post("api/answer", &json!({ "text": SEPARATOR, "want": ["modes"] })).lines().len(), 1);
    let waited = then.elapsed();
    assert!(waited < 8 * alone, "{waited:?}, with {alone:?} for each of 32 if they went on");
}

#[test]
fn designs_are_shared_as_one_page_without_references() {
    let s = Studio::new("share");
    let other = SEPARATOR.replace("46.7 mm", "60 mm");
    let a = s.post("api/share", &json!({ "text": SEPARATOR, "pins": [{ "name": "less <oil>", "text": other }] }));
    let page = a.text();
    assert_eq!(a.status, 200);
    assert!(page.starts_with("<!doctype html>") && page.contains("less &lt;oil&gt;") && !page.contains("less <oil>"));
    assert_eq!(page.matches("class=\"verdict").count(), 2);
    assert!(!page.contains("src=") && !page.contains("http-equiv=\"refresh\"") && !page.contains("href=\"http"));
    let alone = s.post("api/share", &json!({ "text": SEPARATOR }));
    assert_eq!(alone.text().matches("class=\"verdict").count(), 1);
    let pins = vec![json!({ "name": "x", "text": SEPARATOR }); 12];
    assert_eq!(s.post("api/share", &json!({ "text": SEPARATOR, "pins": pins })).status, 422);
    assert_eq!(s.post("api/share", &json!({ "text": "[[part]]" })).status, 422);
}

/// A response with the orders remembered is that of the automatic choice.
#[test]
fn a_second_response_is_that_of_the_first() {
    let (s, fresh) = (Studio::new("again"), Studio::new("fresh"));
    let at = |s: &Studio, mass: f64| {
        let set = json!([{ "path": "drum.mass", "value": mass }]);
        let lines = s.post("api/answer", &json!({ "text": SEPARATOR, "want": ["nonlinear"], "set": set })).lines();
        (lines[1]["targets"].clone(), lines[1]["html"].as_str().unwrap().len())
    };
    at(&s, 2.4);
    assert_eq!(at(&s, 2.6), at(&fresh, 2.6));
}

/// The first page recommends no study that the file has.
#[test]
fn the_first_page_names_the_studies_of_the_file() {
    let s = Studio::new("named");
    let page = |text: &str| {
        let lines = s.post("api/answer", &json!({ "text": text, "want": ["page"] })).lines();
        lines[0]["html"].as_str().unwrap_or_else(|| panic!("{lines:?}")).to_string()
    };
    let balls = include_str!("../../../examples/04-ball-balancer/machine.toml");
    assert!(!page(balls).contains("needs a study") && page(balls).contains("run the study"));
    let without = balls.split("[[study]]").next().unwrap();
    assert!(page(without).contains("needs a study"));
    let cream = include_str!("../../../examples/09-cream-separator/machine.toml");
    assert!(!page(cream).contains("add a study") && page(cream.split("[[study]]").next().unwrap()).contains("add a study"));
    let bearing = SEPARATOR.split("[[study]]").next().unwrap();
    let response = "[[study]]\nkind = \"nonlinear_response\"\nname = \"jumps\"\nspeed = { from = \"500 rpm\", to = \"6000 rpm\" }\n";
    let sentence = "need a study";
    assert!(page(bearing).contains(sentence) && !page(&format!("{bearing}\n{response}")).contains(sentence));
}
