//! Maps of responses over two parameters: every cell against a response of its own, reference folds, threads, resumption, refusals.

use crate::common;

use common::planar_file::{oil, planar_file};
use laval::file::{Form, Loaded, canonical, load, render};
use laval::outcome::{Data, End, Outcome};
use laval::report::draw;
use laval::store::{Keep, Work};
use laval::study::{Cancel, Context, Progress};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

fn rotor() -> String {
    planar_file("per_axis", "1 mm", ["42", "6.59"])
}

fn loaded(liquid: &str, study: &str) -> Loaded {
    let text = format!("{}{liquid}\n[[study]]\nkind = \"response_map\"\n{study}", rotor());
    load(&text).unwrap_or_else(|d| panic!("{}", render(&d, &text, "m.toml", Form::Lines)))
}

fn run(loaded: &Loaded) -> Outcome {
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("map")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn number(o: &Outcome, column: &str, row: usize) -> f64 {
    o.find_table("map").unwrap().column(column).unwrap_or_else(|| panic!("no {column}")).number(row).unwrap()
}

fn word<'a>(o: &'a Outcome, column: &str, row: usize) -> &'a str {
    match &o.find_table("map").unwrap().column(column).unwrap().data {
        Data::Text(v) => &v[row],
        _ => panic!("{column} is no text"),
    }
}

fn finding(o: &Outcome, id: &str) -> f64 {
    o.findings.iter().find(|f| f.id == id).and_then(|f| f.value).unwrap_or(f64::NAN)
}

/// All numbers and words of all tables, bit for bit.
fn bits(o: &Outcome) -> Vec<String> {
    let cells = |d: &Data| match d {
        Data::Float(v) => format!("{:?}", v.iter().map(|x| x.to_bits()).collect::<Vec<_>>()),
        Data::Int(v) => format!("{v:?}"),
        Data::Text(v) => format!("{v:?}"),
        Data::Flag(v) => format!("{v:?}"),
    };
    let tables = o.tables.iter().flat_map(|t| t.columns()).map(|c| format!("{} {}", c.name, cells(&c.data)));
    tables.chain(o.findings.iter().map(|f| f.sentence())).collect()
}

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

/// Every cell has the numbers that `nonlinear_response` finds for a machine that is written with these parameters.
fn agrees_with_single(liquid: &str, axes: &str, paths: [&str; 2], requested: &str) {
    let map = loaded(liquid, &format!("{axes}\n{requested}"));
    let o = run(&map);
    let text = format!("{}{liquid}\n[[study]]\nkind = \"nonlinear_response\"\n{requested}", rotor());
    let single = load(&text).unwrap();
    let cells = o.find_table("map").unwrap().rows();
    for row in 0..cells {
        let at = paths.map(|p| number(&o, p, row));
        let machine = single.system.with(&[(paths[0], at[0]), (paths[1], at[1])]).unwrap();
        let own = single.studies[0].study.run(&machine, &Context::quiet("single")).unwrap();
        let folds = own.find_table("folds").map_or(0, |t| t.rows());
        assert_eq!(number(&o, "folds", row), folds as f64, "{at:?}");
        for (column, id) in [("jump_up", "jump_up"), ("jump_down", "jump_down"), ("peak", "largest_displacement")] {
            assert!(same(number(&o, column, row), finding(&own, id)), "{at:?} {column} {} {}", number(&o, column, row), finding(&own, id));
        }
        let peak = own.findings.iter().find(|f| f.id == "largest_displacement").unwrap();
        let speed = peak.evidence.iter().find(|e| e.what == "speed").unwrap().value;
        assert!(same(number(&o, "peak_speed", row), speed));
        let reported = own.findings.iter().filter(|f| f.id == "unstable_states").filter_map(|f| f.value).fold(0.0, f64::max);
        // the middle of a curve that folds beyond the range is unstable, but no instability of the machine
        let (growth, folded) = (number(&o, "growth", row), word(&o, "sweeps", row) == "jumps down only");
        assert!(if folded { growth <= reported } else { growth == reported }, "{at:?} {growth} {reported}");
        let kinds = own.find_table("bifurcations").map_or(0, |t| match &t.column("kind").unwrap().data {
            Data::Text(v) => v.iter().filter(|k| *k == "Neimark-Sacker").count(),
            _ => 0,
        });
        assert_eq!(number(&o, "neimark_sacker", row), kinds as f64, "{at:?}");
        assert_eq!(word(&o, "failure", row), "");
    }
}

#[test]
fn cells_are_single_responses_bit_for_bit() {
    let axes = "x = { parameter = \"drum.eccentricity\", from = \"10 um\", to = \"1 mm\", points = 3 }\nx_spacing = \"logarithmic\"\n\
        y = { parameter = \"air.damping\", from = 42, to = 420, points = 2 }";
    let requested = "speed = { from = 25, to = 8000 }";
    agrees_with_single("", axes, ["drum.eccentricity", "air.damping"], requested);
}

#[test]
fn cells_of_a_machine_with_liquid_tell_where_it_whirls_by_itself() {
    let axes = "x = { parameter = \"oil.free_surface_radius\", from = \"46.69 mm\", to = \"65 mm\", points = 2 }\n\
        y = { parameter = \"air.damping\", from = 42, to = 420, points = 2 }";
    let requested = "speed = { from = 1500, to = 3500 }\nharmonics = 3";
    agrees_with_single(&oil("46.69 mm", "20"), axes, ["oil.free_surface_radius", "air.damping"], requested);
    let o = run(&loaded(&oil("46.69 mm", "20"), &format!("{axes}\n{requested}")));
    assert!(finding(&o, "neimark_sacker_machines") >= 1.0, "{:?}", o.findings);
}

/// Machines without a fold in the range have no hysteresis, and those that close it inside the range none
/// that goes on.
#[test]
fn hysteresis_is_reported_where_there_is_one() {
    let map = |damping: &str| {
        run(&loaded(
            "",
            &format!(
                "x = {{ parameter = \"drum.eccentricity\", from = \"15 um\", to = \"16 um\", points = 2 }}\n\
                 y = {{ parameter = \"air.damping\", from = {damping}, points = 2 }}\nspeed = {{ from = 2200, to = 2400 }}\nharmonics = 3"
            ),
        ))
    };
    let text = |o: &Outcome, id: &str| o.findings.iter().find(|f| f.id == id).map(|f| f.sentence());
    let closed = map("42, to = 43");
    assert!(text(&closed, "widest_hysteresis").is_some_and(|t| !t.contains("beyond")), "{:?}", closed.findings);
    assert_eq!(finding(&closed, "jumping_machines"), 4.0);
    let none = map("420, to = 430");
    assert_eq!(text(&none, "widest_hysteresis"), None);
    assert_eq!(finding(&none, "jumping_machines"), 0.0);
}

/// Folds of `docs/theory/harmonic-balance.md#reference-folds`: two independent programs agree on them to 10 digits.
#[test]
fn reference_folds_and_what_sweeps_do() {
    let o = run(&loaded(
        "",
        "x = { parameter = \"drum.eccentricity\", from = \"10 um\", to = \"1 mm\", points = 2 }\n\
         y = { parameter = \"air.damping\", from = 42, to = 420, points = 2 }\nspeed = { from = 25, to = 8000 }",
    ));
    let [up, down] = ["jump_up", "jump_down"].map(|c| (0..4).map(|r| number(&o, c, r)).collect::<Vec<_>>());
    assert!((up[0] - 2256.1175426669).abs() < 1e-6 && (down[0] - 2255.9879801360).abs() < 1e-6, "{up:?} {down:?}");
    assert!((number(&o, "hysteresis", 0) - (2256.1175426669 - 2255.9879801360)).abs() < 1e-6);
    // without closing in the range: several states from the only fold to the end
    assert!(up[1].is_nan() && (down[1] - 2685.9163967127).abs() < 1e-6);
    assert!((number(&o, "hysteresis", 1) - (8000.0 - 2685.9163967127)).abs() < 1e-6 && number(&o, "open", 1) == 1.0);
    assert!(up[2].is_nan() && down[2].is_nan() && number(&o, "hysteresis", 2) == 0.0 && number(&o, "open", 2) == 0.0);
    assert!(up[3].is_nan() && (down[3] - 2670.3717680785).abs() < 1e-6);
    let sweeps: Vec<&str> = (0..4).map(|r| word(&o, "sweeps", r)).collect();
    assert_eq!(sweeps, ["jumps up and down", "jumps down only", "no jump", "jumps down only"]);
    assert_eq!(finding(&o, "jumping_machines"), 3.0);
    // what lies at the end of the range is a lower bound, and is marked so
    let text = |o: &Outcome, id: &str| o.findings.iter().find(|f| f.id == id).map(|f| f.sentence());
    assert!(text(&o, "widest_hysteresis").is_some_and(|t| t.contains("continues beyond the speed range")), "{:?}", o.findings);
    for row in 0..4 {
        assert_eq!(number(&o, "peak_at_end", row) == 1.0, number(&o, "peak_speed", row) == 8000.0, "{row}");
    }
    assert_eq!([0, 1, 2].map(|row| number(&o, "peak_at_end", row)), [0.0, 1.0, 0.0]);
    assert!(text(&o, "largest_peak").is_some_and(|t| t.contains("at an end of the speed range")), "{:?}", o.findings);
    assert!(text(&o, "smallest_peak").is_some_and(|t| !t.contains("end of the speed range")), "{:?}", o.findings);
    // the border passes between the one machine that does not jump and its two neighbours
    let border = o.find_table("border").unwrap();
    assert_eq!(border.rows(), 2);
    let across = border.column("across").unwrap();
    assert!(matches!(&across.data, Data::Text(v) if v.iter().any(|w| w == "air.damping") && v.iter().any(|w| w == "drum.eccentricity")));
    for f in &o.figures {
        assert!(!f.alt.key.is_empty() && draw(f, &o.tables).unwrap().contains("<path"));
    }
    assert_eq!(o.figures.iter().map(|f| f.name.as_str()).collect::<Vec<_>>(), ["peak", "hysteresis", "sweeps"]);
}

const SMALL: &str = "x = { parameter = \"drum.eccentricity\", from = \"10 um\", to = \"1 mm\", points = 6 }\nx_spacing = \"logarithmic\"\n\
    y = { parameter = \"air.damping\", from = 42, to = 420, points = 4 }\nspeed = { from = 2200, to = 2800 }\nharmonics = 3";

#[test]
fn bits_do_not_depend_on_threads() {
    let map = loaded("", SMALL);
    let with = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| bits(&run(&map)));
    let one = with(1);
    assert!(one == with(2) && one == with(5));
}

struct StopAfter<'a>(AtomicU64, &'a AtomicBool);
impl Progress for StopAfter<'_> {
    fn report(&self, _: u64, _: u64) {
        if self.0.fetch_add(1, Ordering::Relaxed) == 20 {
            self.1.store(true, Ordering::Relaxed);
        }
    }
}

#[test]
fn a_stopped_map_goes_on_where_it_stood() {
    let map = loaded("", SMALL);
    let whole = run(&map);
    let folder = std::env::temp_dir().join(format!("laval-response-map-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    let keep = Keep { folder: folder.clone(), input: canonical(&map.spec, &map.studies[0].name), fresh: false, work: Work::Missing };
    let cancel = Cancel::default();
    let progress = StopAfter(AtomicU64::new(0), &cancel);
    let context = Context { cancel: &cancel, progress: &progress, keep: Some(&keep), ..Context::quiet("map") };
    let part = map.studies[0].study.run(&map.system, &context).unwrap();
    assert_eq!(part.end, End::Cancelled);
    assert!(part.find_table("map").unwrap().rows() < 24 && part.findings.iter().any(|f| f.id == "incomplete"));
    let rest = map.studies[0].study.run(&map.system, &Context { keep: Some(&keep), ..Context::quiet("map") }).unwrap();
    let _ = std::fs::remove_dir_all(&folder);
    assert!(rest.end == End::Reached && bits(&rest) == bits(&whole));
}

/// The limit counts points, and ends the map after whole responses: what a limited run keeps is what a run without limit computes.
#[test]
fn a_limited_map_keeps_nothing_that_is_cut_short() {
    let map = loaded("", SMALL);
    let whole = run(&map);
    let total = whole.work["points"];
    let folder = std::env::temp_dir().join(format!("laval-limited-map-{}", std::process::id()));
    let keep = Keep { folder: folder.clone(), input: canonical(&map.spec, &map.studies[0].name), fresh: false, work: Work::Missing };
    for (limit, some) in [(2, false), (30, false), (total / 2, true)] {
        let _ = std::fs::remove_dir_all(&folder);
        let limited = Context { work_limit: limit, keep: Some(&keep), ..Context::quiet("map") };
        let part = map.studies[0].study.run(&map.system, &limited).unwrap();
        assert_eq!((part.end, part.work["responses"] > 0), (End::WorkLimit, some), "{limit}");
        assert!(part.work["points"] <= limit && part.work["responses"] < 24 && part.findings.iter().any(|f| f.id == "incomplete"));
        let rest = map.studies[0].study.run(&map.system, &Context { keep: Some(&keep), ..Context::quiet("map") }).unwrap();
        assert!(rest.end == End::Reached && bits(&rest) == bits(&whole), "{limit}");
    }
    let _ = std::fs::remove_dir_all(&folder);
}

/// A machine whose free surface lies outside its cavity does not exist; its neighbours do.
#[test]
fn machines_that_do_not_exist_are_cells_without_numbers() {
    let o = run(&loaded(
        &oil("46.69 mm", "20"),
        "x = { parameter = \"oil.free_surface_radius\", from = \"60 mm\", to = \"80 mm\", points = 2 }\n\
         y = { parameter = \"air.damping\", from = 42, to = 420, points = 2 }\nspeed = { from = 500, to = 900 }\nharmonics = 3",
    ));
    assert_eq!(o.end, End::Reached);
    assert!(number(&o, "peak", 0) > 0.0 && number(&o, "peak", 2) > 0.0);
    for row in [1, 3] {
        assert!(number(&o, "peak", row).is_nan() && number(&o, "folds", row).is_nan());
        assert_eq!(word(&o, "sweeps", row), "failed");
        assert!(word(&o, "failure", row).contains("cavity"), "{}", word(&o, "failure", row));
    }
    assert_eq!(finding(&o, "failed_machines"), 2.0);
}

#[test]
fn refusals() {
    let refused = |study: &str| {
        let text = format!("{}\n[[study]]\nkind = \"response_map\"\nspeed = {{ from = 25, to = 8000 }}\n{study}", rotor());
        let d = load(&text).err().unwrap_or_default();
        assert!(d.has_errors(), "{study} is accepted");
        render(&d, &text, "m.toml", Form::Lines)
    };
    let e = "parameter = \"drum.eccentricity\"";
    let chi = "y = { parameter = \"air.damping\", from = 42, to = 420 }";
    assert!(refused(&format!("x = {{ {e}, from = 1e-5, to = 1e-3 }}\ny = {{ {e}, from = 1e-5, to = 1e-3 }}")).contains("same parameter"));
    assert!(
        refused("x = { parameter = \"air.damping.x\", from = 1, to = 3 }\ny = { parameter = \"air.damping\", from = 1, to = 3 }")
            .contains("same parameter")
    );
    assert!(refused(&format!("x = {{ parameter = \"drum.colour\", from = 1, to = 2 }}\n{chi}")).contains("drum.colour"));
    assert!(refused(&format!("x = {{ {e}, from = 0, to = 1e-3 }}\nx_spacing = \"logarithmic\"\n{chi}")).contains("begin above 0"));
    assert!(refused(&format!("x = {{ {e}, from = 1e-3, to = 1e-5 }}\n{chi}")).contains("from a lower to a higher"));
    assert!(refused(&format!("x = {{ {e}, from = 1e-5, to = 1e-3, points = 9999 }}\n{chi}")).contains("too large"));
    assert!(refused(chi).contains("x"));
}
