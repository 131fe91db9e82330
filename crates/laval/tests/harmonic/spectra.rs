//! Waterfalls and order spectra of motions in time: a superharmonic in a run-up, a self-excited whirl, refusals.

use crate::common;

use common::planar_file::{oil, planar_file};
use laval::file::{Form, load, render};
use laval::outcome::{End, Evidence, Finding, Outcome};
use laval::report::draw;
use laval::study::Context;

fn text(law: &str, eccentricity: &str, liquid: &str, study: &str) -> String {
    format!("{}{liquid}\n[[study]]\n{study}\n", planar_file(law, eccentricity, ["42", "6.59"]))
}

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{}", render(&d, text, "m.toml", Form::Lines)));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("study")).unwrap();
    assert_eq!(o.end, End::Reached);
    for f in &o.figures {
        assert!(!f.alt.key.is_empty() && draw(f, &o.tables).unwrap().contains("<path"));
    }
    o
}

fn finding<'a>(o: &'a Outcome, id: &str) -> &'a Finding {
    o.findings
        .iter()
        .find(|f| f.id == id)
        .unwrap_or_else(|| panic!("no {id} in {:?}", o.findings.iter().map(Finding::sentence).collect::<Vec<_>>()))
}

fn evidence(f: &Finding, what: &str) -> f64 {
    let named = |e: &&Evidence| e.what == what;
    f.evidence.iter().find(named).unwrap_or_else(|| panic!("no {what} in {f:?}")).value
}

/// Lines of the order spectrum nearest to a speed.
fn line(o: &Outcome, speed: f64, order: f64) -> f64 {
    let t = o.find_table("order_spectra").unwrap();
    let number = |c: &str, r: usize| t.column(c).unwrap().number(r).unwrap();
    let own = (0..t.rows()).filter(|&r| number("order", r) == order);
    let nearest = own.min_by(|&a, &b| (number("speed", a) - speed).abs().total_cmp(&(number("speed", b) - speed).abs())).unwrap();
    number("amplitude", nearest)
}

/// A slow run-up meets the backward third order where the table of steady states has it, as high as that but for the slowness of the run-up; the
/// synchronous line is the steady first order away from resonances.
#[test]
fn a_run_up_shows_the_third_superharmonic() {
    let o = run(&text(
        "per_axis",
        "10 mm",
        "",
        "kind = \"run_up\"\nfrom = 690\nto = 830\nduration = 14\nwaterfall = \"drum\"\nspectra = 120\npoints = 50",
    ));
    let f = finding(&o, "superharmonic");
    assert!(f.subject.contains("order 3, backward"), "{}", f.subject);
    assert!((evidence(f, "speed there") - 754.7).abs() < 6.0, "{f:?}");
    assert!((evidence(f, "order there") + 3.0).abs() < 0.01);
    let largest = evidence(f, "largest amplitude");
    assert!(largest > 2.5e-4 && largest < 5.1e-4, "{largest}");
    // the window is an average over 14 rad/s; away from resonance the lines are those of the steady states
    let steady = include_str!("../reference/planar/superharmonic_third.csv").lines().filter(|l| l.starts_with("10,"));
    let rows: Vec<Vec<f64>> = steady.map(|l| l.split(',').map(|c| c.parse().unwrap()).collect()).collect();
    for speed in [791.468211, 808.6279538] {
        let row = rows.iter().find(|r| r[1] == speed).unwrap();
        let found = line(&o, speed, 1.0);
        assert!((found / row[3] - 1.0).abs() < 0.02, "{speed}: {found} {}", row[3]);
        let third = line(&o, speed, -3.0);
        assert!((third / row[4] - 1.0).abs() < 0.05, "{speed}: {third} {}", row[4]);
        assert!(line(&o, speed, 3.0) < 0.02 * third);
    }
    assert!(o.find_table("waterfall").is_some());
    assert!(["waterfall", "order_spectra"].iter().all(|n| o.figures.iter().any(|f| f.name == *n)));
    // outputs requested are still those
    assert_eq!(o.find_table("motion").unwrap().rows(), 50);
}

/// A nearly balanced rotor with liquid whirls by itself at the frequency of its limit cycle (table of limit cycles: 2325.125757 rad/s at 2500 rad/s, z1 = 6.778 mm).
#[test]
fn a_self_excited_whirl_is_no_multiple_of_the_spin() {
    let o = run(&text(
        "isotropic",
        "0.1 um",
        &oil("65.1 mm", "20"),
        "kind = \"transient\"\nspeed = 2500\nduration = 3\ninitial = { \"drum.x\" = \"0.1 mm\" }\nwaterfall = \"drum\"\nspectra = 60\npoints = 50",
    ));
    let f = finding(&o, "asynchronous");
    assert!(f.subject.contains("forward"));
    let whirl = 2325.125757;
    // it is highest while it grows, when its frequency is not yet that of the cycle
    assert!((evidence(f, "order there") - whirl / 2500.0).abs() < evidence(f, "orders distinguished there"), "{f:?}");
    assert!((evidence(f, "largest amplitude") / 0.006778466542 - 1.0).abs() < 0.1, "{f:?}");
    // the last window holds the settled whirl
    let t = o.find_table("waterfall").unwrap();
    let number = |c: &str, r: usize| t.column(c).unwrap().number(r).unwrap();
    let last = number("t", t.rows() - 1);
    let own = (0..t.rows()).filter(|&r| number("t", r) == last);
    let top = own.max_by(|&a, &b| number("amplitude", a).total_cmp(&number("amplitude", b))).unwrap();
    let step = number("frequency", 1) - number("frequency", 0);
    assert!((number("frequency", top) - whirl).abs() <= 0.5 * step, "{} {step}", number("frequency", top));
    // between two lines a height falls by at most 15 %
    let height = number("amplitude", top) / 0.006778466542;
    assert!(height > 0.84 && height < 1.01, "{height}");
    assert_eq!(o.find_table("motion").unwrap().rows(), 50);
}

/// The motion does not depend on whether spectra are wanted.
#[test]
fn spectra_leave_the_motion_as_it_is() {
    let study = "kind = \"transient\"\nspeed = 2500\nduration = 0.2\ninitial = { \"drum.x\" = \"0.1 mm\" }\npoints = 40";
    let (plain, with) =
        (run(&text("per_axis", "1 mm", "", study)), run(&text("per_axis", "1 mm", "", &format!("{study}\nwaterfall = \"drum\""))));
    assert_eq!(plain.find_table("motion"), with.find_table("motion"));
    assert_eq!(plain.find_table("energy"), with.find_table("energy"));
}

/// Outputs too far apart to be joined: the envelope and the last turns are drawn, with the values that outputs close together give.
#[test]
fn a_motion_that_outputs_do_not_resolve() {
    let (speed, turns) = (2500.0, 120);
    let duration = f64::from(turns) * std::f64::consts::TAU / speed;
    let study = |points: i32| {
        run(&text("per_axis", "1 mm", "", &format!("kind = \"transient\"\nspeed = {speed}\nduration = {duration:?}\npoints = {points}")))
    };
    let (coarse, fine) = (study(200), study(48 * turns + 1));
    let column = |o: &Outcome, table: &str, name: &str| -> Vec<f64> {
        let t = o.find_table(table).unwrap_or_else(|| panic!("no {table}"));
        (0..t.rows()).map(|r| t.column(name).unwrap().number(r).unwrap()).collect()
    };
    assert_eq!(coarse.find_table("motion").unwrap().rows(), 200);
    assert!(fine.find_table("last turns").is_none() && fine.find_table("envelope").is_none());
    let size = |xs: &[f64]| xs.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    for name in ["drum.x", "drum.y", "base.x", "base.y"] {
        let (own, all) = (column(&coarse, "last turns", name), column(&fine, "motion", name));
        assert_eq!(own.len(), 12 * 48 + 1);
        let off: Vec<f64> = own.iter().zip(&all[all.len() - own.len()..]).map(|(a, b)| a - b).collect();
        assert!(size(&off) < 1e-6 * size(&all), "{name} {:e}", size(&off) / size(&all));
    }
    let (x, y) = (column(&fine, "motion", "drum.x"), column(&fine, "motion", "drum.y"));
    let radius: Vec<f64> = x.iter().zip(&y).map(|(x, y)| x.hypot(*y)).collect();
    let envelope = column(&coarse, "envelope", "drum amplitude");
    assert!((size(&envelope) / size(&radius) - 1.0).abs() < 1e-3);
    let until = column(&coarse, "envelope", "t");
    assert!((until[until.len() - 1] - duration).abs() < 0.01 * duration && until.len() == envelope.len());
    let last = size(&radius[radius.len() - 24..]);
    let reported = envelope[envelope.len() - 1];
    assert!(reported >= last * (1.0 - 1e-3), "{reported} {last}");
}

#[test]
fn refusals() {
    let refused = |study: &str| {
        let t = text("per_axis", "1 mm", "", study);
        let d = load(&t).err().unwrap_or_default();
        assert!(d.has_errors(), "{study} is accepted");
        render(&d, &t, "m.toml", Form::Lines)
    };
    let transient = "kind = \"transient\"\nspeed = 2500\nduration";
    assert!(refused(&format!("{transient} = 1\nwaterfall = \"rotor\"")).contains("there is no body \"rotor\""));
    assert!(refused(&format!("{transient} = 1e6\nwaterfall = \"drum\"")).contains("too many"));
    assert!(refused(&format!("{transient} = 1\nwaterfall = \"drum\"\nspectra = 1")).contains("spectra"));
    assert!(refused(&format!("{transient} = 1\nwaterfall = \"drum\"\ncomponent_threshold = 0")).contains("component_threshold"));
}
