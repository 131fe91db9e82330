//! Critical speeds over the stiffness of the supports: closed forms, limits, intersections with bearings, mistakes.

use super::definition::{file, rotor};
use crate::common::files::{finding, findings, load, run_all};
use laval::model::system::System;
use laval::outcome::Outcome;
use laval::solve::criticals::criticals;
use laval::solve::rest::rest;
use laval::solve::sweep::sweep;
use laval::study::support_stiffness_map::{MapResult, SupportStiffnessMap};
use laval::study::{Context, Study};
use std::f64::consts::PI;

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a / b - 1.0).abs() <= tolerance, "{what}: {a} {b}, {:e}", a / b - 1.0);
}

fn map(system: &System, stiffness: Option<(f64, f64)>, modes: usize) -> MapResult {
    let stiffness = stiffness.map(|(from, to)| laval::model::field::RangeValue { from, to, points: Some(20) });
    SupportStiffnessMap { stiffness, modes, supports: vec![], rest: true, spin: None }.compute(system, &Context::quiet("map")).unwrap()
}

fn bearing(name: &str, body: &str, at: f64, to: &str, more: &str) -> String {
    format!("[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"{body}\", at = {at:?} }}, \"{to}\"]\n{more}\n")
}

/// A mass on a massless elastic beam on springs, `W^2 = 1/(m (1/k_beam + 1/(2 k)))`; on pedestals the springs are in series.
#[test]
fn jeffcott_on_springs() {
    let shaft = "[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nmodulus = 2e11\nshear_modulus = 8e10\ndensity = 1e-3\nshear = \"none\"\nelements = 2\nsection = { length = [0.5, 0.5], outer_diameter = [0.03, 0.03] }\n\
                 [[part]]\nkind = \"disc\"\nname = \"disc\"\non = { body = \"shaft\", at = 0.5 }\nmass = 8.0\n";
    let k = "kxx = 3e6\nkyy = 5e6\nkxy = 1e6\ncxx = 100.0";
    let system = load(&format!(
        "[machine]\nname = \"t\"\n{shaft}{}{}",
        bearing("a", "shaft", 0.0, "ground", k),
        bearing("b", "shaft", 1.0, "ground", k)
    ))
    .system;
    let beam = 48.0 * 2e11 * PI * 0.03f64.powi(4) / 64.0;
    let found = map(&system, Some((1e4, 1e9)), 1);
    assert!(found.forward_alone && found.supports.len() == 2);
    for row in &found.curves {
        let series = 1.0 / (1.0 / beam + 0.5 / row.stiffness);
        let r = &row.roots[0];
        near(r.speed, (series / 8.0).sqrt(), 1e-7, "critical speed");
        near(r.share, series * 0.5 / row.stiffness, 1e-5, "share");
        assert!(r.counted);
    }
    near(found.rigid[0].speed, (beam / 8.0).sqrt(), 1e-7, "rigid");
    // kxx and kyy are two lines, of both bearings
    assert_eq!(found.bearings.len(), 2);
    assert_eq!(found.intersections.len(), 2);
    for (i, k) in found.intersections.iter().zip([3e6, 5e6]) {
        near(i.root.speed, (1.0 / (1.0 / beam + 0.5 / k) / 8.0).sqrt(), 1e-7, "intersection");
    }
    // without a mass of its own a pedestal is a spring in series
    let base = "[[part]]\nkind = \"foundation\"\nname = \"base\"\nmass = 1e-6\nstiffness = 4e6\n";
    let system = load(&format!(
        "[machine]\nname = \"t\"\n{shaft}{base}{}{}",
        bearing("a", "shaft", 0.0, "base", k),
        bearing("b", "shaft", 1.0, "base", k)
    ))
    .system;
    for row in &map(&system, Some((1e4, 1e9)), 1).curves {
        let series = 1.0 / (1.0 / beam + 0.5 / row.stiffness + 1.0 / 4e6);
        near(row.roots[0].speed, (series / 8.0).sqrt(), 1e-6, "on a pedestal");
    }
}

/// A rigid rotor: `W^2 = 2 k/m` and, for Id > Ip alone, `2 k a^2/(Id - Ip)`; at rest `2 k a^2/Id`.
#[test]
fn conical_mode() {
    let of = |polar: f64| {
        let disc = format!("[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 10.0\npolar_inertia = {polar:?}\ndiametral_inertia = 0.3\n");
        load(&format!(
            "[machine]\nname = \"t\"\n{disc}{}{}",
            bearing("a", "drum", -0.2, "ground", "stiffness = 1e6"),
            bearing("b", "drum", 0.2, "ground", "stiffness = 1e6")
        ))
        .system
    };
    for polar in [0.1, 0.2999, 0.31, 0.5] {
        let found = map(&of(polar), Some((1e4, 1e8)), 3);
        for row in &found.curves {
            let tilt = if row.spin == laval::solve::support_map::Spin::Rest { 0.3 } else { 0.3 - polar };
            let mut expected = vec![(0.2 * row.stiffness).sqrt()];
            if tilt > 0.0 {
                expected.push((2.0 * row.stiffness * 0.04 / tilt).sqrt());
            }
            expected.sort_by(f64::total_cmp);
            assert_eq!(row.roots.len(), expected.len(), "{polar} {:?}", row.roots);
            row.roots.iter().zip(expected).for_each(|(r, e)| near(r.speed, e, 1e-12, "rigid rotor"));
        }
        // nothing bends: no limits
        assert!(found.free.is_empty() && found.rigid.is_empty());
    }
}

/// Limits of a slender beam: `W_j = (j pi/L)^2 sqrt(E I/(rho A))` on rigid supports at its ends, `beta_j^2 ..` of the free beam without; critical speeds of a thin beam differ from the frequencies by
/// its rotary and gyroscopic inertia, which is small.
#[test]
fn limits_are_the_pinned_and_the_free_beam() {
    let ends = bearing("a", "shaft", 0.0, "ground", "stiffness = 1e6") + &bearing("b", "shaft", 1.0, "ground", "stiffness = 1e6");
    let text = format!(
        "[machine]\nname = \"t\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nmodulus = 2e11\nshear_modulus = 8e10\ndensity = 8000.0\nshear = \"none\"\nelements = 40\nsection = {{ length = [1.0], outer_diameter = [0.004] }}\n{ends}"
    );
    let found = map(&load(&text).system, None, 3);
    let wave = (2e11 / 8000.0f64).sqrt() * 0.001;
    for (j, r) in found.rigid.iter().enumerate() {
        near(r.speed, (PI * (j + 1) as f64).powi(2) * wave, 5e-5, "pinned");
    }
    assert_eq!(found.still, 2);
    for (r, beta) in found.free.iter().zip([4.730_040_744_862_704, 7.853_204_624_095_838, 10.995_607_838_001_67]) {
        near(r.speed, beta * beta * wave, 1e-4, "free");
    }
    // the curves run from one limit to the other
    let (soft, stiff) = (&found.curves[0].roots, &found.curves[found.curves.len() / 2 - 1].roots);
    assert!(soft[2].speed < 1.05 * found.free[0].speed && stiff[2].speed > 0.9 * found.rigid[2].speed);
    for pair in found.curves.windows(2).filter(|p| p[0].spin == p[1].spin) {
        assert!(pair[0].roots.iter().zip(&pair[1].roots).all(|(a, b)| a.speed <= b.speed * (1.0 + 1e-12)));
    }
}

/// Where a bearing meets the curves is a critical speed of the machine with that bearing in all places: constant coefficients and a table.
#[test]
fn intersections_are_critical_speeds() {
    let definition = &file("two_disc_isotropic_6el")["definition"];
    let system = rotor(definition, "", "");
    let found = map(&system, None, 3);
    let speeds: Vec<f64> = (0..=60).map(|k| 10.0 + 600.0 * f64::from(k) / 60.0).collect();
    let of = |system: &System| -> Vec<f64> {
        let state = |w: f64| rest(system, w);
        let branches = sweep(system, &state, &speeds, 1500.0, |_, _| true).unwrap();
        let all = criticals(system, &state, &branches, &[1.0]);
        all.iter().filter(|c| c.located() && c.forward_share > 0.5).map(|c| c.speed).collect()
    };
    let own = of(&system);
    let below: Vec<f64> = found.intersections.iter().map(|i| i.root.speed).filter(|w| *w < 600.0).collect();
    assert!(own.len() >= 2 && below.len() >= 2, "{own:?} {below:?}");
    for w in &below {
        assert!(own.iter().any(|o| (o / w - 1.0).abs() < 1e-8), "{w} {own:?}");
    }
    let table = "table = { speed = [0.0, 200.0, 400.0, 700.0], kxx = [2e5, 5e5, 2e6, 1e7], kyy = [2e5, 5e5, 2e6, 1e7] }\n";
    let text = format!(
        "[machine]\nname = \"t\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nsection = {{ length = [0.6, 0.6], outer_diameter = [0.04, 0.05] }}\nelements = 4\n\
         [[part]]\nkind = \"disc\"\nname = \"disc\"\non = {{ body = \"shaft\", at = 0.7 }}\nmass = 20.0\npolar_inertia = 0.3\ndiametral_inertia = 0.2\n{}{}",
        bearing("a", "shaft", 0.0, "ground", table),
        bearing("b", "shaft", 1.2, "ground", table)
    );
    let system = load(&text).system;
    let found = map(&system, None, 4);
    let own = of(&system);
    assert!(!found.intersections.is_empty() && found.bearings.len() == 1 && found.bearings[0].of.len() == 4);
    for i in &found.intersections {
        assert!(i.defect < 1e-11 && own.iter().any(|o| (o / i.root.speed - 1.0).abs() < 1e-8), "{i:?} {own:?}");
    }
}

/// Pedestals of different stiffness in x and y give whirls of both directions, which a machine of that stiffness has.
#[test]
fn anisotropic_pedestals() {
    let of = |k: f64| {
        let base =
            |name: &str| format!("[[part]]\nkind = \"foundation\"\nname = \"{name}\"\nmass = 15.0\nstiffness = {{ x = 4e6, y = 9e6 }}\n");
        let more = format!("stiffness = {k:?}");
        let text = format!(
            "[machine]\nname = \"t\"\n{}{}[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nsection = {{ length = [1.0], outer_diameter = [0.05] }}\nelements = 6\n\
             [[part]]\nkind = \"disc\"\nname = \"disc\"\non = {{ body = \"shaft\", at = 0.4 }}\nmass = 20.0\npolar_inertia = 0.3\ndiametral_inertia = 0.2\n{}{}",
            base("left"),
            base("right"),
            bearing("a", "shaft", 0.0, "left", &more),
            bearing("b", "shaft", 1.0, "right", &more)
        );
        load(&text).system
    };
    let system = of(3e6);
    let found = map(&system, Some((3e6, 3e7)), 4);
    assert!(!found.forward_alone);
    let state = |w: f64| rest(&system, w);
    let speeds: Vec<f64> = (0..=60).map(|k| 10.0 + 800.0 * f64::from(k) / 60.0).collect();
    let branches = sweep(&system, &state, &speeds, 2000.0, |_, _| true).unwrap();
    let own = criticals(&system, &state, &branches, &[1.0]);
    let roots: Vec<_> = found.curves[0].roots.iter().filter(|r| r.speed < 800.0).collect();
    assert!(roots.len() >= 3);
    for r in roots {
        assert!(own.iter().any(|c| (c.speed / r.speed - 1.0).abs() < 1e-8 && (c.forward_share > 0.5) == (r.forward > 0.5)), "{r:?}");
    }
}

/// An overhung rotor whose spin has a ratio to the speed of the machine, with its pedestals and bearings.
fn overhung(ratio: Option<f64>, pedestal: &str, table: &str, more: &str) -> String {
    let spin = ratio.map_or(String::new(), |r| format!("[[part]]\nkind = \"speed_ratio\"\nname = \"own\"\nratio = {r:?}\n"));
    let own = if ratio.is_some() { "spin = \"own\"\n" } else { "" };
    let base = |name: &str| format!("[[part]]\nkind = \"foundation\"\nname = \"{name}\"\nmass = 15.0\nstiffness = {pedestal}\n");
    format!(
        "[machine]\nname = \"t\"\nspeed = {:?}\n{spin}{}{}[[part]]\nkind = \"shaft\"\nname = \"shaft\"\n{own}section = {{ length = [0.8], outer_diameter = [0.06] }}\nelements = 6\n\
         [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.8 }}\nmass = 30.0\npolar_inertia = 1.0\ndiametral_inertia = 0.52\n{}{}{more}",
        300.0 / ratio.unwrap_or(1.0).abs(),
        base("left"),
        base("right"),
        bearing("a", "shaft", 0.0, "left", table),
        bearing("b", "shaft", 0.5, "right", "stiffness = 4e7")
    )
}

fn bodies(text: &str) -> MapResult {
    map(&load(text).system, Some((1e6, 1e9)), 4)
}

fn same(a: &MapResult, b: &MapResult, what: &str) {
    let roots = |m: &MapResult| -> Vec<(f64, f64)> {
        let curves = m.curves.iter().flat_map(|r| &r.roots);
        let all = curves.chain(&m.rigid).chain(&m.free).chain(m.intersections.iter().map(|i| &i.root));
        all.map(|r| (r.speed, r.forward)).collect()
    };
    let (a, b) = (roots(a), roots(b));
    assert_eq!(a.len(), b.len(), "{what}");
    for (x, y) in a.iter().zip(&b) {
        near(x.0, y.0, 1e-8, what);
        assert!((x.1 - y.1).abs() < 1e-6, "{what}: {x:?} {y:?}");
    }
}

/// The only rotor of a machine has the map of the rotor by itself, whatever the ratio of its spin: that of another speed, or of the mirror image.
#[test]
fn the_ratio_of_the_only_spin_changes_nothing() {
    let rows = |sign: f64| {
        let speeds: Vec<f64> = (0..5).map(|i| sign * 300.0 * f64::from(i)).collect();
        let (speeds, k) = if sign < 0.0 {
            (speeds.into_iter().rev().collect::<Vec<_>>(), "[8e7, 5e7, 2e7, 8e6, 4e6]")
        } else {
            (speeds, "[4e6, 8e6, 2e7, 5e7, 8e7]")
        };
        format!("table = {{ speed = {speeds:?}, kxx = {k}, kyy = {k} }}")
    };
    for (pedestal, forward) in [("2e8", true), ("{ x = 4e7, y = 9e7 }", false)] {
        let alone = bodies(&overhung(None, pedestal, &rows(1.0), ""));
        assert_eq!(alone.forward_alone, forward);
        assert!(!alone.intersections.is_empty() && !alone.rigid.is_empty());
        for ratio in [1.0, -1.0, -6.0, 0.4] {
            same(&bodies(&overhung(Some(ratio), pedestal, &rows(ratio.signum()), "")), &alone, &format!("ratio {ratio}"));
        }
    }
    let said = |text: &str| {
        run_all(&format!("{text}[[study]]\nkind = \"support_stiffness_map\"\nstiffness = {{ from = 1e6, to = 1e8, points = 3 }}\n"))
    };
    let outcome = &said(&overhung(Some(-6.0), "2e8", "stiffness = 4e7", ""))[0];
    let sentence = finding(outcome, "spin").sentence();
    assert!(sentence.contains("\"own\"") && !sentence.contains("otherwise"), "{sentence}");
    assert!(findings(&said(&overhung(None, "2e8", "stiffness = 4e7", ""))[0], "spin").is_empty());
}

/// Two rotors that touch nothing in common: the curves at the spin of one are its own, and those of the other with the gyroscopic effect of its speed at that whirl.
#[test]
fn several_spins_are_told_apart() {
    let drum = |polar: f64| {
        let all = format!("[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 10.0\npolar_inertia = {polar:?}\ndiametral_inertia = 3.0\n");
        all + &bearing("c", "drum", -0.2, "ground", "stiffness = 1e6") + &bearing("d", "drum", 0.2, "ground", "stiffness = 1e6")
    };
    let both = |named: Option<&str>| {
        let system = load(&overhung(Some(-2.0), "2e8", "stiffness = 4e7", &drum(0.5))).system;
        let stiffness = Some(laval::model::field::RangeValue { from: 1e6, to: 1e7, points: Some(3) });
        SupportStiffnessMap { stiffness, modes: 4, supports: vec![], rest: false, spin: named.map(str::to_string) }
            .compute(&system, &Context::quiet("map"))
            .unwrap()
    };
    let polar_over = |found: &MapResult, ratio: f64| {
        for row in &found.curves {
            // the drum by itself: W^2 = 2 k a^2/(Id - Ip ratio)
            let own = (2.0 * row.stiffness * 0.04 / (3.0 - 0.5 * ratio)).sqrt();
            assert!(row.roots.iter().any(|r| (r.speed / own - 1.0).abs() < 1e-9), "{ratio}: {own} {:?}", row.roots);
        }
    };
    polar_over(&both(None), 1.0);
    polar_over(&both(Some("own")), -0.5);
    let study = |spin: &str| {
        format!(
            "{}[[study]]\nkind = \"support_stiffness_map\"\nstiffness = {{ from = 1e6, to = 1e7, points = 3 }}\n{spin}",
            overhung(Some(-2.0), "2e8", "stiffness = 4e7", &drum(0.5))
        )
    };
    for (spin, words) in [("", "Speeds are those of the machine."), ("spin = \"own\"\n", "What turns otherwise")] {
        let sentence = finding(&run_all(&study(spin))[0], "spin").sentence();
        assert!(sentence.contains("\"own\"") && sentence.contains(words), "{sentence}");
    }
    let wrong = laval::file::load(&study("spin = \"a\"\n")).err().unwrap();
    assert!(wrong.0.iter().any(|d| d.code == "spin.missing" && d.span.is_some()), "{wrong:?}");
}

const DISC: &str = "[[part]]\nkind = \"disc\"\nname = \"drum\"\nmass = 10.0\npolar_inertia = 0.1\ndiametral_inertia = 0.3\n";

fn study(parts: &str, fields: &str) -> String {
    format!("[machine]\nname = \"t\"\n{DISC}{parts}[[study]]\nkind = \"support_stiffness_map\"\n{fields}\n")
}

/// Sentences of the findings, and the same from a stored result.
#[test]
fn findings_and_storage() {
    let two = bearing("a", "drum", -0.2, "ground", "stiffness = 1e6") + &bearing("b", "drum", 0.2, "ground", "stiffness = 1e6");
    let outcome: &Outcome = &run_all(&study(&two, "modes = 3"))[0];
    near(finding(outcome, "intersection").value.unwrap(), (2e6f64 / 10.0).sqrt(), 1e-12, "first");
    assert!(finding(outcome, "intersection").sentence().contains("a and b"), "{}", finding(outcome, "intersection").sentence());
    assert_eq!(finding(outcome, "fewer").number("modes"), Some(2.0));
    assert!(findings(outcome, "together").is_empty() && outcome.figures.len() == 1);
    let system = load(&study(&two, "")).system;
    let study = SupportStiffnessMap { stiffness: None, modes: 2, supports: vec![], rest: false, spin: None };
    let result = study.compute(&system, &Context::quiet("map")).unwrap();
    let again: MapResult = serde_json::from_str(&serde_json::to_string(&result).unwrap()).unwrap();
    assert_eq!(study.report(&system, &result, "map").unwrap(), study.report(&system, &again, "map").unwrap());
}

/// A bearing by its geometry has no curve, and the sentence says so; one by its coefficients has.
#[test]
fn bearings_without_a_curve_are_named() {
    let film = "[[part]]\nkind = \"bearing_journal\"\nname = \"film\"\nbetween = [{ body = \"drum\", at = 0.2 }, \"ground\"]\n\
                diameter = \"60 mm\"\nlength = \"25 mm\"\nclearance = \"60 um\"\nviscosity = \"20 mPa s\"\n";
    let text = study(&(bearing("a", "drum", -0.2, "ground", "stiffness = 1e6") + film), "");
    let text = text.replace("name = \"t\"\n", "name = \"t\"\naxis = \"horizontal\"\nspeed = 300.0\n");
    let outcome: &Outcome = &run_all(&text)[0];
    let said = finding(outcome, "replaced").sentence();
    assert!(said.contains("depends on its load and deflection") && said.ends_with("here: film."), "{said}");
    assert_eq!(finding(outcome, "replaced").number("nonlinears"), Some(1.0));
    assert!(findings(outcome, "intersection").iter().all(|f| !f.subject.contains("film")));
    let two = bearing("a", "drum", -0.2, "ground", "stiffness = 1e6") + &bearing("b", "drum", 0.2, "ground", "stiffness = 1e6");
    let said = finding(&run_all(&study(&two, ""))[0], "replaced").sentence();
    assert!(said.ends_with("masses stay."), "{said}");
}

/// Machines that it refuses, and mistakes of the request at their place.
#[test]
fn refusals() {
    let code = |text: &str| -> String {
        let l = load(text);
        l.studies[0].study.admit(&l.system).unwrap_err().code.to_string()
    };
    assert_eq!(
        code(&study("[[part]]\nkind = \"damper\"\nname = \"c\"\nbetween = [\"drum\", \"ground\"]\ndamping = 10.0\n", "")),
        "support_map.none"
    );
    let liquid = bearing("a", "drum", 0.1, "ground", "stiffness = 1e6")
        + "[[part]]\nkind = \"liquid\"\nname = \"oil\"\nin = \"drum\"\nmodel = \"planar\"\ncavity_radius = 0.1\ncavity_height = 0.1\ndensity = 900.0\nfill = { volume_fraction = 0.3 }\n";
    assert_eq!(code(&study(&liquid, "")), "support_map.part");
    let two = bearing("a", "drum", -0.2, "ground", "stiffness = 1e6") + &bearing("b", "drum", 0.2, "ground", "stiffness = 1e6");
    let wrong = laval::file::load(&study(&two, "stiffness = { from = \"1e9 N/m\", to = \"1e5 N/m\" }"));
    let said: Vec<_> = wrong.err().unwrap().0.iter().map(|d| (d.code.to_string(), d.span.is_some())).collect();
    assert_eq!(said, [("study.range".to_string(), true)]);
}
