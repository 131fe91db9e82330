//! The first page of machines with shafts: what moves between the places where something is attached, and small peaks of backward whirl.

use super::overview::{check, number, page};
use crate::common::files::load;
use laval::outcome::Verdict;
use laval::solve::linear_response::response;
use laval::solve::machine_mode::Whirl;
use laval::solve::rest::rest;
use laval::solve::sectors::circular;
use std::f64::consts::PI;

/// A long shaft moves most between the places where something is attached: there its limit decides, and there the page shows it.
#[test]
fn a_shaft_is_held_against_its_limit_at_all_nodes() {
    let bearing = |name: &str, at: &str| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at} }}, \"ground\"]\nstiffness = 1e8\ndamping = 1e4\n"
        )
    };
    let text = format!(
        "[machine]\nname = \"long\"\nspeed = \"1400 rpm\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 12\nsection = {{ length = [2.0], outer_diameter = [0.06] }}\n\
         [[part]]\nkind = \"disc\"\nname = \"hub\"\non = {{ body = \"shaft\", at = 0.3 }}\nmass = 2.0\nunbalance = \"2000 g mm\"\n{}{}[limits]\ndisplacement = \"0.04 mm\"\n",
        bearing("a", "0.0"),
        bearing("b", "2.0")
    );
    let system = load(&text).system;
    let found = response(&system, &|w| rest(&system, w), 1400.0 * PI / 30.0).unwrap().unwrap();
    let slot = system.slots().iter().position(|s| s.name == "shaft").unwrap();
    let size = |z: f64| {
        let [x, y] = system.point(slot, z).unwrap().amplitudes(&found.x);
        let (f, b) = circular(x, y);
        f.abs() + b.abs()
    };
    let nodes = system.slots()[slot].part.body().unwrap().nodes().unwrap();
    let most = nodes.iter().map(|z| size(*z)).fold(0.0, f64::max);
    assert!(size(0.3) < 40e-6 && most > 50e-6, "{} {most}", size(0.3));
    let p = page(&text);
    let vibration = check(&p, "check-vibration");
    assert_eq!(vibration.verdict, Verdict::Failed, "{vibration:?}");
    assert!((number(&vibration.result, "sizes") / most - 1.0).abs() < 1e-9, "{vibration:?}");
}

/// In a machine that is not the same in all directions unbalance drives backward whirl, too: a small peak of it is a resonance of the page as it is one of `critical_speeds`.
#[test]
fn a_small_peak_of_backward_whirl_is_a_resonance() {
    let bearing = |name: &str, at: &str| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at} }}, \"ground\"]\nkxx = 1e8\nkyy = 1.005e8\ncxx = 200.0\ncyy = 200.0\n"
        )
    };
    let text = format!(
        "[machine]\nname = \"overhung\"\nspeed = \"7000 rpm\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 6\nsection = [{{ length = 0.5, outer_diameter = 0.05 }}]\n\
         [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.5 }}\nmass = 8.0\npolar_inertia = 0.12\ndiametral_inertia = 0.07\nunbalance = \"40 g mm\"\n{}{}\
         [[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = \"1000 rpm\", to = \"14000 rpm\" }}\n",
        bearing("a", "0.05"),
        bearing("b", "0.35")
    );
    let loaded = load(&text);
    let state = |w: f64| rest(&loaded.system, w);
    let speeds: Vec<f64> = (0..60).map(|k| 150.0 + 20.0 * f64::from(k)).collect();
    let sweep = laval::solve::sweep::sweep(&loaded.system, &state, &speeds, f64::INFINITY, |_, _| true).unwrap();
    let all = laval::solve::criticals::criticals(&loaded.system, &state, &sweep, &[1.0]);
    let backward = all.iter().find(|c| c.whirl == Whirl::Backward).unwrap_or_else(|| panic!("{all:?}"));
    let p = page(&text);
    let resonances: Vec<f64> = p.over_speed.unwrap().resonances.iter().map(|r| r.speed).collect();
    assert!(resonances.iter().any(|w| (w / backward.speed - 1.0).abs() < 0.01), "{} {resonances:?}", backward.speed);
}
