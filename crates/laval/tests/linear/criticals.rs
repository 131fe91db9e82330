//! Critical speeds: the same whatever the range, beside a closed form of a shaft whose memory turns with it; what the unbalance excites, and what it does not.

use crate::common::files::{finding, findings, load, run_all};
use laval::outcome::{Data, Level, Outcome};
use laval::solve::locate::value_and_slope;
use laval::solve::pencil::modes_about;
use laval::solve::rest::rest;
use laval::solve::sectors::Sector;
use laval_num::complex::{C64, c};

/// A disc on a shaft that relaxes by an exponential in its own axes, with damping from outside.
fn relaxing(ranges: &[(f64, f64)]) -> String {
    let study = |(k, (from, to)): (usize, &(f64, f64))| {
        format!("[[study]]\nkind = \"critical_speeds\"\nname = \"c{k}\"\nspeed = {{ from = {from}, to = {to} }}\n")
    };
    let studies: String = ranges.iter().enumerate().map(study).collect();
    format!(
        "[machine]\nspeed = 1000\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 10\neccentricity = 1e-5\n\
         [[part]]\nkind = \"shaft_viscoelastic\"\nbetween = [\"d\", \"ground\"]\nstiffness = 1e6\nmemory = \"rotor\"\n\
         exponentials = {{ share = [0.3], rate = [5] }}\n\
         [[part]]\nkind = \"damper\"\nbetween = [\"d\", \"ground\"]\ndamping = 40\n{studies}"
    )
}

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    let t = o.find_table(table).unwrap();
    (0..t.rows()).map(|k| t.column(name).unwrap().number(k).unwrap()).collect()
}

fn words(o: &Outcome, table: &str, name: &str) -> Vec<String> {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Text(v) => v.clone(),
        _ => panic!("{name} is no text"),
    }
}

/// `m s^2 + c s + k (1 - g l/(l + s - i W)) = 0` at `s = a + i W`: `a = -c/2m` and `W^2 = a^2 + c a/m + k/m (1 - g l/(l + a))`.
#[test]
fn a_relaxing_shaft_has_one_forward_critical_speed_in_every_range() {
    let (m, k, c, g, l) = (10.0, 1e6, 40.0, 0.3, 5.0);
    let a: f64 = -c / (2.0 * m);
    let expected = (a * a + c * a / m + k / m * (1.0 - g * l / (l + a))).sqrt();
    let ranges = [(10.0, 2000.0), (100.0, 400.0), (200.0, 260.0), (220.0, 225.0), (223.0, 224.3), (50.0, 223.7), (223.5, 900.0)];
    for (o, range) in run_all(&relaxing(&ranges)).iter().zip(ranges) {
        let (speed, whirl) = (column(o, "critical_speeds", "speed"), words(o, "critical_speeds", "whirl"));
        let forward: Vec<f64> = speed.iter().zip(&whirl).filter(|w| w.1 == "forward").map(|w| *w.0).collect();
        assert!(forward.len() == 1 && (forward[0] / expected - 1.0).abs() < 1e-10, "{range:?}: {forward:?} for {expected}");
        assert!(column(o, "critical_speeds", "uncertainty").iter().all(|s| *s < 1e-6), "{range:?}");
        assert!(!findings(o, "critical_speed").is_empty() && findings(o, "critical_speed_not_located").is_empty());
    }
}

/// A root of the memory stays beside its pole at `s = i W - l`, which turns with the rotor: its derivative in the speed is that of the polynomial
/// `(m s^2 + c s + k)(s - i W + l) = k g l`.
#[test]
fn a_root_beside_a_pole_that_turns_moves_as_its_polynomial_says() {
    let (mass, k, damping, share, rate) = (10.0, 1e6, 40.0, 0.3, 5.0);
    let system = load(&relaxing(&[(10.0, 2000.0)])).system;
    for w in [50.0, 210.0, 300.0, 1000.0, 1900.0] {
        let stiff = |s: C64| (s * s).scale(mass) + s.scale(damping) + C64::real(k);
        let mut s = c(-rate, w);
        for _ in 0..60 {
            s = c(-rate, w) + C64::real(k * share * rate) / stiff(s);
        }
        let slope = stiff(s).mul_i() / ((s.scale(2.0 * mass) + C64::real(damping)) * (s - c(-rate, w)) + stiff(s));
        let (value, found) = value_and_slope(&system, &|w| rest(&system, w), w, s, Some(Sector::Forward)).unwrap();
        assert!((value - s).abs() < 1e-12 * w && (found - slope).abs() < 1e-10, "{w}: {value:?} {s:?} {found:?} {slope:?}");
    }
}

const COUPLED: &str = include_str!("machines/two_discs_with_memory.toml");

/// Two discs, one on a shaft with memory: each critical speed is the frequency of a mode there, and ranges do not matter.
#[test]
fn critical_speeds_beside_a_slow_memory_are_located() {
    let studies = |ranges: &[(f64, f64)]| {
        let one = |(k, r): (usize, &(f64, f64))| {
            format!("\n[[study]]\nkind = \"critical_speeds\"\nname = \"c{k}\"\nspeed = {{ from = {}, to = {} }}\n", r.0, r.1)
        };
        format!("{COUPLED}{}", ranges.iter().enumerate().map(one).collect::<String>())
    };
    let text = studies(&[(10.0, 2000.0), (10.0, 150.0), (150.0, 260.0), (260.0, 2000.0)]);
    let found = run_all(&text);
    let whole = column(&found[0], "critical_speeds", "speed");
    let mut parts: Vec<f64> = found[1..].iter().flat_map(|o| column(o, "critical_speeds", "speed")).collect();
    parts.sort_by(f64::total_cmp);
    assert!(whole.len() == parts.len() && whole.iter().zip(&parts).all(|(a, b)| (a / b - 1.0).abs() < 1e-9), "{whole:?}\n{parts:?}");
    let system = load(&text).system;
    for w in whole {
        let modes = modes_about(&system, &rest(&system, w).unwrap(), true).unwrap().modes;
        let nearest = modes.iter().map(|m| (m.frequency() - w).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-8 * w, "{w}: {nearest}");
    }
    assert!(findings(&found[0], "critical_speed_not_located").is_empty());
}

/// The critical speed of a shaft with a weakly singular memory is no crossing of a mode: on the line its root lies on the branch cut. The response peaks all the same.
#[test]
fn a_peak_without_a_crossing_is_reported() {
    let text = include_str!("../../../../examples/07-viscoelastic-shaft/machine.toml");
    let machine = &text[..text.find("[[study]]").unwrap()];
    let range = "speed = { from = 245, to = 260 }\n";
    let found = run_all(&format!("{machine}[[study]]\nkind = \"critical_speeds\"\n{range}[[study]]\nkind = \"forced_response\"\n{range}"));
    let peak = finding(&found[1], "largest_resonance").value.unwrap();
    assert!((finding(&found[0], "response_peak").value.unwrap() / peak - 1.0).abs() < 1e-8);
    let none = finding(&found[0], "no_critical_speed");
    assert!(none.number("peaks") >= Some(1.0) && none.sentence().contains("no natural frequency equals the speed"), "{}", none.sentence());
    let distance = (peak / (3000.0 * std::f64::consts::PI / 30.0) - 1.0).abs();
    assert!((finding(&found[0], "margin").value.unwrap() / distance - 1.0).abs() < 1e-8);
}

/// A disc that tilts in isotropic bearings: unbalance and skew excite no backward whirl, so that it has no peak and requires no margin.
#[test]
fn a_backward_critical_speed_has_no_peak_and_asks_for_no_margin() {
    let machine = |speed: f64| {
        format!(
            "[machine]\nspeed = {speed}\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 4\neccentricity = 1e-5\ndiametral_inertia = 0.02\npolar_inertia = 0.004\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"u\"\nbetween = [{{ body = \"d\", at = 0.1 }}, \"ground\"]\nkxx = 4e4\nkyy = 4e4\ncxx = 4\ncyy = 4\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"l\"\nbetween = [{{ body = \"d\", at = -0.16 }}, \"ground\"]\nkxx = 4e4\nkyy = 4e4\ncxx = 4\ncyy = 4\n\
             [[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = 10, to = 400 }}\n"
        )
    };
    let o = &run_all(&machine(190.0))[0];
    let (speed, whirl) = (column(o, "critical_speeds", "speed"), words(o, "critical_speeds", "whirl"));
    let backward = speed.iter().zip(&whirl).filter(|w| w.1 == "backward").map(|w| *w.0).fold(0.0, f64::max);
    for f in findings(o, "critical_speed") {
        let peaks = f.evidence.iter().any(|e| e.what == "peak of the response");
        assert_eq!(peaks, f.subject.ends_with("forward"), "{}", f.sentence());
    }
    // at its very speed
    let o = &run_all(&machine(backward))[0];
    let margin = finding(o, "margin");
    let forward = speed.iter().zip(&whirl).filter(|w| w.1 == "forward").map(|w| (w.0 / backward - 1.0).abs()).fold(f64::INFINITY, f64::min);
    assert!((margin.value.unwrap() - forward).abs() < 1e-9 && forward > 1e-3, "{}", margin.sentence());
}

/// The margin to the critical speed of a disc in isotropic bearings, `sqrt(k/m)` for small damping: a warning
/// below the margin required, else not. A resonance damped by more than a tenth of critical damping is none.
#[test]
fn a_margin_is_a_warning_only_where_it_is_too_small() {
    let margin = |speed: f64, damping: f64, study: &str| {
        let text = format!(
            "[machine]\nspeed = {speed}\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = 4\neccentricity = 1e-5\n\
             [[part]]\nkind = \"bearing_linear\"\nbetween = [\"d\", \"ground\"]\nkxx = 4e4\nkyy = 4e4\ncxx = {damping}\ncyy = {damping}\n\
             [[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = 10, to = 400 }}\n{study}"
        );
        let o = run_all(&text).remove(0);
        findings(&o, "margin").first().map(|f| (f.level, f.value.unwrap()))
    };
    for (speed, study, level) in [
        (109.0, "margin = 0.1\n", Level::Warning),
        (112.0, "margin = 0.1\n", Level::Info),
        (92.0, "margin = 0.1\n", Level::Warning),
        (90.0, "margin = 0.1\n", Level::Info),
        (112.0, "margin = 0.2\n", Level::Warning),
        (200.0, "", Level::Info),
    ] {
        let (found, distance) = margin(speed, 0.4, study).unwrap();
        assert_eq!(found, level, "{speed} {study}");
        assert!((distance - (1.0 - 100.0 / speed).abs()).abs() < 1e-4, "{speed}: {distance}");
    }
    // twice critical damping: neither a resonance nor a peak
    assert_eq!(margin(109.0, 1600.0, ""), None);
}

#[test]
fn critical_speeds_stand_in_their_table_alone() {
    let text = relaxing(&[(500.0, 900.0), (100.0, 400.0)]);
    let found = run_all(&text);
    assert!(found.iter().all(|o| o.figures.is_empty()));
    assert!(column(&found[0], "critical_speeds", "speed").is_empty() && !column(&found[1], "critical_speeds", "speed").is_empty());
    assert!(finding(&found[0], "no_critical_speed").level == Level::Info);
}
