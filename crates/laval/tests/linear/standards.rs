//! Balance quality grades and limits on the vibration of shafts, against lever rules and closed forms.

use super::overview::{ECCENTRICITY, MASS, STIFFNESS, check, jeffcott, number, page};
use crate::common::files::{finding, findings, load, run_all};
use laval::outcome::{Arg, Check, Level, Outcome, Overview, Verdict};
use laval::solve::statics::own;
use laval::solve::statics::supports::supports;
use laval::solve::statics::unbalance::{Rotor, rotors};
use laval_num::complex::{C64, c};
use std::f64::consts::PI;

fn rpm(n: f64) -> f64 {
    n * PI / 30.0
}

fn near(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() <= 1e-9 * b.abs().max(1e-12), "{what}: {a} {b}");
}

/// Amplitude of the disc at a speed.
fn amplitude(speed: f64, damping: f64) -> f64 {
    let r = speed / (STIFFNESS / MASS).sqrt();
    let zeta = damping / (2.0 * (STIFFNESS * MASS).sqrt());
    ECCENTRICITY * r * r / ((1.0 - r * r).powi(2) + (2.0 * zeta * r).powi(2)).sqrt()
}

/// Values of the sentences in a list, by the name of the argument.
fn items(c: &Check, what: &str) -> Vec<f64> {
    let list = c.result.args.iter().find(|a| a.0 == "sizes").map(|a| &a.1);
    let Some(Arg::List(all)) = list else { panic!("{c:?}") };
    let of = |a: &Arg| match a {
        Arg::Phrase(m) => number(m, what),
        other => panic!("{other:?}"),
    };
    all.iter().map(of).collect()
}

/// `m e <= G m/W`, whatever the mass.
#[test]
fn grade_of_a_planar_disc() {
    for (speed, grade, verdict) in [(200.0, "G16", Verdict::Passed), (200.0, "G6.3", Verdict::Failed)] {
        let e = 0.05e-3;
        let text = jeffcott("", 4.0, &format!("[operation]\nspeed = {speed:?}\nbalance_grade = \"{grade}\"\n"));
        let p = page(&text.replace(&format!("eccentricity = {ECCENTRICITY}"), &format!("eccentricity = {e:?}")));
        let c = check(&p, "check-balance");
        assert_eq!(c.verdict, verdict, "{c:?}");
        near(items(c, "value")[0], MASS * e, "unbalance");
        near(items(c, "share")[0], 1e-3 * grade[1..].parse::<f64>().unwrap() * MASS / speed, "permissible");
    }
    assert!(page(&jeffcott("speed = 200.0", 4.0, "")).checks.iter().all(|c| c.what.key != "check-balance"));
}

fn rotor(text: &str, speed: f64) -> Rotor {
    let system = load(text).system;
    let found = supports(&system, &own(&system, speed).unwrap());
    let mut all = rotors(&system, speed, &found);
    assert_eq!(all.len(), 1);
    all.remove(0)
}

fn bearing(name: &str, at: f64) -> String {
    format!(
        "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"rotor\", at = {at:?} }}, \"ground\"]\nstiffness = 1e7\ndamping = 100.0\n"
    )
}

fn drum(more: &str) -> String {
    format!(
        "[machine]\nname = \"t\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 20.0\npolar_inertia = 0.4\ndiametral_inertia = 0.7\ncentre_of_mass = 0.1\n{more}\n{}{}",
        bearing("a", -0.2),
        bearing("b", 0.3)
    )
}

fn angle(size: f64, phase: f64) -> C64 {
    c(size * phase.cos(), size * phase.sin())
}

/// The lever rule for unbalances in planes, and `(A - C) tau` of a skew.
#[test]
fn unbalances_in_the_planes_of_bearings() {
    let own = (20.0 * 1e-5, 0.7);
    let list = [(3e-4, 1.1, 0.25), (2e-4, -2.0, -0.15)];
    let text = drum(
        "eccentricity = 1e-5\neccentricity_phase = 0.7\nunbalances = { unbalance = [3e-4, 2e-4], phase = [1.1, -2.0], at = [0.25, -0.15] }",
    );
    let all = list.iter().copied().chain([(own.0, own.1, 0.1)]);
    let (u, s) = all.fold((c(0.0, 0.0), c(0.0, 0.0)), |(u, s), (x, phi, z)| (u + angle(x, phi), s + angle(x * z, phi)));
    let upper = (s - u.scale(-0.2)).scale(1.0 / 0.5);
    let r = rotor(&text, 300.0);
    let planes = r.planes.as_ref().unwrap();
    for (found, expected, what) in
        [(r.resultant, u, "resultant"), (planes[1].unbalance, upper, "upper"), (planes[0].unbalance, u - upper, "lower")]
    {
        assert!((found - expected).abs() < 1e-12 * u.abs(), "{what}: {found:?} {expected:?}");
    }
    assert!((r.couple - (s - u.scale(0.1))).abs() < 1e-12 * u.abs());
    // a skew: a couple alone, the same against both bearings
    let r = rotor(&drum("skew = 1e-4\nskew_phase = 0.4"), 300.0);
    near(r.couple.abs(), (0.7 - 0.4) * 1e-4, "couple of a skew");
    let planes = r.planes.unwrap();
    assert!(r.resultant.abs() < 1e-15);
    near(planes[0].unbalance.abs(), 0.3 * 1e-4 / 0.5, "lower");
    assert!((planes[0].unbalance + planes[1].unbalance).abs() < 1e-12 * planes[0].unbalance.abs());
}

/// A shaft with discs is the same rigid rotor, wherever its nodes are.
#[test]
fn unbalances_along_a_shaft() {
    let disc = |name: &str, at: f64, more: &str| {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"{name}\"\non = {{ body = \"rotor\", at = {at:?} }}\nmass = 5.0\npolar_inertia = 0.02\ndiametral_inertia = 0.01\n{more}\n"
        )
    };
    let text = format!(
        "[machine]\nname = \"t\"\n[[part]]\nkind = \"shaft\"\nname = \"rotor\"\nsection = {{ length = [0.9], outer_diameter = [0.04] }}\n{}{}{}{}",
        disc("p", 0.3, "unbalance = 2e-4\neccentricity_phase = 0.5"),
        disc("q", 0.85, "unbalance = 1e-4\neccentricity_phase = -1.0"),
        bearing("a", 0.1),
        bearing("b", 0.7)
    );
    let r = rotor(&text, 400.0);
    let (u, s) = (angle(2e-4, 0.5) + angle(1e-4, -1.0), angle(2e-4 * 0.3, 0.5) + angle(1e-4 * 0.85, -1.0));
    let upper = (s - u.scale(0.1)).scale(1.0 / 0.6);
    let planes = r.planes.as_ref().unwrap();
    assert!((r.resultant - u).abs() < 1e-10 * u.abs() && (planes[1].unbalance - upper).abs() < 1e-10 * u.abs());
    near(r.mass.mass, 7850.0f64.mul_add(PI * 0.02 * 0.02 * 0.9, 10.0), "mass");
    // three bearings have no two planes
    assert!(rotor(&format!("{text}{}", bearing("c", 0.8)), 400.0).planes.is_none());
}

/// Shares of both planes on the page.
#[test]
fn grade_of_a_rotor_on_two_bearings() {
    let unbalance = "unbalances = { unbalance = [4e-5], phase = [0.0], at = [0.3] }";
    let of = |grade: &str| {
        let text = format!("{}[operation]\nspeed = 300.0\nbalance_grade = \"{grade}\"\n", drum(unbalance));
        page(&text.replace("name = \"t\"\n", "name = \"t\"\nspeed = 300.0\n"))
    };
    // all of it at the bearing b: U_per = G m/W, of which (0.1 + 0.2)/0.5 there
    let p = of("G1");
    let c = check(&p, "check-balance");
    let total = 1e-3 * 20.0 / 300.0;
    let (values, shares) = (items(c, "value"), items(c, "share"));
    near(values[1], 4e-5, "at b");
    assert!(values[0] < 1e-15);
    near(shares[0], 0.4 * total, "share of a");
    near(shares[1], 0.6 * total, "share of b");
    // 40 g mm of 40 g mm
    assert!((shares[1] - 4e-5).abs() < 1e-12);
    assert_eq!(of("G2.5").checks.iter().find(|c| c.what.key == "check-balance").unwrap().verdict, Verdict::Passed);
    assert_eq!(of("G0.4").checks.iter().find(|c| c.what.key == "check-balance").unwrap().verdict, Verdict::Failed);
}

fn vibration(standard: &str, speed: f64, eccentricity: f64) -> Overview {
    let text = jeffcott("", 4.0, &format!("[operation]\nspeed = {speed:?}\nshaft_vibration = \"{standard}\"\n"));
    page(&text.replace(&format!("eccentricity = {ECCENTRICITY}"), &format!("eccentricity = {eccentricity:?}")))
}

/// Twice the closed form of the amplitude against 4800, 9000, 13 200 over the root of the speed, and against API 617.
#[test]
fn zones_of_a_disc_on_springs() {
    let speed = rpm(2500.0);
    let unit = 2.0 * amplitude(speed, 4.0) / ECCENTRICITY;
    // 2500 rpm: 96, 180, 264 um
    for (peak, verdict) in [(95e-6, Verdict::Passed), (179e-6, Verdict::Passed), (181e-6, Verdict::Attention), (265e-6, Verdict::Failed)] {
        let p = vibration("iso_7919_3", speed, peak / unit);
        let c = check(&p, "check-shaft-vibration");
        near(items(c, "value")[0], peak, "peak to peak");
        assert_eq!(c.verdict, verdict, "{peak}");
    }
    for (peak, verdict) in [(25.3e-6, Verdict::Passed), (25.5e-6, Verdict::Failed)] {
        assert_eq!(check(&vibration("api_617", speed, peak / unit), "check-shaft-vibration").verdict, verdict);
    }
    // below 1000 rpm the zones are not defined
    assert_eq!(check(&vibration("iso_7919_3", rpm(900.0), 1e-6), "check-shaft-vibration").verdict, Verdict::NotComputed);
}

const PEDESTAL: &str = "[machine]\nname = \"t\"\nspeed = \"3000 rpm\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 10.0\neccentricity = 2e-5\n\
    [[part]]\nkind = \"foundation\"\nname = \"base\"\nmass = 15.0\nstiffness = { x = 2e6, y = 3e6 }\ndamping = 300.0\n\
    [[part]]\nkind = \"bearing_linear\"\nname = \"film\"\nbetween = [\"rotor\", \"base\"]\nstiffness = 4e6\ndamping = 900.0\n\
    [operation]\nspeed = { from = \"2800 rpm\", to = \"3200 rpm\" }\n";

fn forced(more: &str) -> Outcome {
    let study = "[[study]]\nkind = \"forced_response\"\nspeed = { from = \"1000 rpm\", to = \"5000 rpm\", points = 81 }\n";
    run_all(&format!("{PEDESTAL}{more}{study}")).remove(0)
}

/// Relative to the pedestal: the difference of the motions of both bodies, direction by direction.
#[test]
fn relative_to_the_bearing() {
    let outcome = forced("shaft_vibration = \"iso_7919_3\"\n");
    let journals = outcome.tables.iter().find(|t| t.name() == "journals").unwrap();
    let row = |name: &str| journals.column(name).unwrap().number(0).unwrap();
    let response = outcome.tables.iter().find(|t| t.name() == "response").unwrap();
    let column = |name: &str, k: usize| response.column(name).unwrap().number(k).unwrap();
    let (low, high) = (rpm(2800.0), rpm(3200.0));
    let mut worst = (0.0, 0.0, 0.0);
    for k in 0..response.rows() {
        let w = column("speed", k);
        let circle =
            |kind: &str, phase: &str, body: &str| angle(column(&format!("{kind}.{body}"), k), column(&format!("{phase}.{body}"), k));
        let f = circle("forward", "phase", "rotor") - circle("forward", "phase", "base");
        let b = circle("backward", "backward_phase", "rotor") - circle("backward", "backward_phase", "base");
        let peak = 2.0 * (f.abs() + b.abs());
        let used = peak / (9000e-6 / (w * 30.0 / PI).sqrt());
        if w > low - 1e-9 && w < high + 1e-9 && used > worst.0 {
            worst = (used, peak, w);
        }
    }
    near(row("peak_to_peak"), worst.1, "relative");
    near(row("speed"), worst.2, "speed");
    near(row("limit"), worst.1 / worst.0, "limit");
    let said = finding(&outcome, "shaft_vibration");
    near(said.value.unwrap(), worst.1, "finding");
    // boundaries over the speed are amplitudes
    let k = (0..response.rows()).find(|&k| (column("speed", k) - rpm(2500.0)).abs() < 1e-6).unwrap();
    for (name, boundary) in [("zone_ab", 48e-6), ("zone_bc", 90e-6), ("zone_cd", 132e-6)] {
        near(column(name, k), boundary, name);
    }
    let api = forced("shaft_vibration = \"api_617\"\n");
    let level = finding(&api, "shaft_vibration").level;
    assert_eq!(level == Level::Warning, worst.1 > 25.4e-6);
    assert!(findings(&forced(""), "shaft_vibration").is_empty());
}

/// The velocity of the pedestal, root mean square: the same motion as its amplitude in the response, direction by direction; nothing of a bearing on the ground.
#[test]
fn housings_on_a_pedestal() {
    let of = |class: &str| page(&PEDESTAL.replace("[operation]\n", &format!("[operation]\nhousing_vibration = \"{class}\"\n")));
    let outcome = forced("");
    let response = outcome.tables.iter().find(|t| t.name() == "response").unwrap();
    let column = |name: &str, k: usize| response.column(name).unwrap().number(k).unwrap();
    let rows = (0..response.rows()).filter(|&k| (rpm(2800.0) - 1e-9..rpm(3200.0) + 1e-9).contains(&column("speed", k)));
    let velocity =
        rows.map(|k| column("speed", k) * (column("forward.base", k) + column("backward.base", k)) / 2f64.sqrt()).fold(0.0, f64::max);
    let first = of("group_1_flexible");
    let c = check(&first, "check-housing-vibration");
    // the page has other speeds between the same ends
    assert!((items(c, "value")[0] / velocity - 1.0).abs() < 1e-3, "{} {velocity}", items(c, "value")[0]);
    let verdicts: Vec<Verdict> =
        ["group_2_rigid", "group_1_rigid", "group_1_flexible"].map(|g| check(&of(g), "check-housing-vibration").verdict).to_vec();
    let expected = |b: [f64; 3]| match b.iter().filter(|b| velocity > 1e-3 * **b).count() {
        0 | 1 => Verdict::Passed,
        2 => Verdict::Attention,
        _ => Verdict::Failed,
    };
    assert_eq!(verdicts, [[1.4, 2.8, 4.5], [2.3, 4.5, 7.1], [3.5, 7.1, 11.0]].map(expected).to_vec());
    let grounded = jeffcott("", 4.0, "[operation]\nspeed = 250.0\nhousing_vibration = \"group_1_rigid\"\n");
    let c = check(&page(&grounded), "check-housing-vibration").clone();
    assert_eq!((c.verdict, c.result.key.as_str()), (Verdict::NotComputed, "housing-vibration-none"));
}

#[test]
fn without_an_operating_speed() {
    for line in ["housing_vibration = \"group_1_rigid\"", "balance_grade = \"G2.5\"", "shaft_vibration = \"api_617\""] {
        let text = format!(
            "[machine]\nname = \"t\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 1.0\n{}[operation]\n{line}\n",
            bearing("a", 0.0).replace("rotor", "d").replace(", at = 0.0", "")
        );
        let found = laval::file::load(&text).err().unwrap().0;
        assert!(found.iter().any(|d| d.code == "operation.speed" && d.span.is_some() && d.help.is_some()), "{found:?}");
    }
}
