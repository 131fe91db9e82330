//! The first page where it rests on the studies of the file, over a range of operating speeds, after a run-up, and what it advises; against the closed forms of
//! a disc on springs (docs/theory/linear-vibration.md).

use super::overview::{ECCENTRICITY, MASS, STIFFNESS, check, jeffcott, number, page};
use crate::common::files::load;
use laval::outcome::{Arg, Level, Message, Outcome, Overview, Verdict};
use laval::study::{Context, overview};
use std::f64::consts::TAU;

const CRITICAL: f64 = 100.0;

/// The page that computes nothing itself.
pub fn of_studies(text: &str) -> Overview {
    let loaded = load(text);
    let run = |s: &laval::file::NamedStudy| s.study.run(&loaded.system, &Context::quiet("own")).unwrap_or_else(|d| panic!("{d:?}"));
    let outcomes: Vec<Outcome> = loaded.studies.iter().map(run).collect();
    let speeds: Vec<_> = loaded.studies.iter().flat_map(|s| s.study.speeds(&loaded.system)).collect();
    overview(&loaded.system, &speeds, &outcomes, &Context { work_limit: 0, ..Context::quiet("summary") })
}

/// Amplitude of the disc.
fn amplitude(speed: f64, damping: f64) -> f64 {
    let (r, zeta) = (speed / CRITICAL, damping / (2.0 * (STIFFNESS * MASS).sqrt()));
    ECCENTRICITY * r * r / ((1.0 - r * r).powi(2) + (2.0 * zeta * r).powi(2)).sqrt()
}

fn keys(list: &[Message]) -> Vec<&str> {
    list.iter().map(|m| m.key.as_str()).collect()
}

/// The argument of the first item of a list of sizes.
fn of_item(m: &Message, name: &str) -> Option<f64> {
    let Some(Arg::List(all)) = m.arg_named("sizes") else { panic!("{m:?}") };
    let Arg::Phrase(item) = &all[0] else { panic!("{all:?}") };
    match item.arg_named(name) {
        Some(Arg::Quantity(q)) => Some(q.value),
        _ => None,
    }
}

#[test]
fn without_time_and_without_studies_nothing_is_claimed() {
    let p = of_studies(&jeffcott("speed = 80.0", 0.4, ""));
    for name in ["check-stability", "check-instability", "check-resonance", "check-vibration", "check-run-up"] {
        assert_eq!(check(&p, name).verdict, Verdict::NotComputed, "{name}");
    }
    assert_eq!((p.verdict, check(&p, "check-stability").result.key.as_str()), (Verdict::NotComputed, "why-too-long"));
}

#[test]
fn stability_is_that_of_the_modes_of_the_file() {
    let p = of_studies(&jeffcott("speed = 80.0", 0.4, "[[study]]\nkind = \"modes\"\n"));
    let found = check(&p, "check-stability");
    assert_eq!(found.verdict, Verdict::Passed, "{found:?}");
    assert!((number(&found.result, "decay") - 0.4 / (2.0 * MASS)).abs() < 1e-9);
    assert_eq!(found.detail.as_ref().and_then(|d| d.arg_named("study")), Some(&Arg::name("own")));
    assert_eq!(p.modes.len(), 2);
    // modes at another speed, about another state or above a threshold say nothing of this one
    for other in ["speed = 70.0", "about = \"turning\"", "growth_threshold = 1.0"] {
        let p = of_studies(&jeffcott("speed = 80.0", 0.4, &format!("[[study]]\nkind = \"modes\"\n{other}\n")));
        assert_eq!(check(&p, "check-stability").verdict, Verdict::NotComputed, "{other}");
    }
}

/// Rotating damping c_i destabilises above w (1 + c_a/c_i) = 200 rad/s, with the growth rate (W - 200) c_i/(2 m w).
#[test]
fn stability_follows_from_every_study_along_the_speed() {
    let inner = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 2.0\naxes = \"rotating\"\n";
    let of = |speed: f64, kind: &str, range: &str| {
        let study = format!("[[study]]\nkind = \"{kind}\"\nspeed = {{ {range} }}\n");
        of_studies(&jeffcott(&format!("speed = {speed:?}"), 2.0, &format!("{inner}{study}")))
    };
    for kind in ["stability_map", "campbell", "critical_speeds", "forced_response"] {
        let calm = of(190.0, kind, "from = 5, to = 300, points = 58");
        let found = check(&calm, "check-stability");
        assert_eq!((found.verdict, found.result.key.as_str()), (Verdict::Passed, "stability-decays"), "{kind}");
        let decay = 10.0 * 2.0 / (2.0 * MASS * CRITICAL);
        assert!((number(&found.result, "decay") / decay - 1.0).abs() < 0.02, "{kind}: {found:?}");
        let near = check(&calm, "check-instability");
        assert!((near.margin.unwrap() - 10.0 / 190.0).abs() < 1e-3, "{kind}: {near:?}");
        let wild = of(230.0, kind, "from = 5, to = 300, points = 58");
        assert_eq!((check(&wild, "check-stability").verdict, wild.verdict), (Verdict::Failed, Verdict::Failed), "{kind}");
        // a study that ends below the operating speed tells nothing of it
        let short = of(190.0, kind, "from = 5, to = 180, points = 58");
        assert_eq!(check(&short, "check-stability").verdict, Verdict::NotComputed, "{kind}");
    }
}

#[test]
fn resonances_and_amplitudes_are_those_of_the_file() {
    let damping = 4.0;
    let study = |kind: &str, range: &str| format!("[[study]]\nkind = \"{kind}\"\nspeed = {{ {range} }}\n");
    let wide = "from = 2, to = 300";
    let p = of_studies(&jeffcott("speed = 80.0", damping, &study("forced_response", wide)));
    let zeta = damping / (2.0 * (STIFFNESS * MASS).sqrt());
    let peak = CRITICAL / (1.0 - 2.0 * zeta * zeta).sqrt();
    let near = check(&p, "check-resonance");
    assert!((near.margin.unwrap() - (peak - 80.0) / 80.0).abs() < 1e-4, "{near:?}");
    let found = number(&check(&p, "check-vibration").result, "sizes");
    assert!((found / amplitude(80.0, damping) - 1.0).abs() < 2e-3, "{found}");
    assert!(check(&p, "check-vibration").detail.as_ref().is_some_and(|d| d.key == "from-study"));
    // force of spring and damper
    let force = amplitude(80.0, damping) * STIFFNESS.hypot(damping * 80.0);
    assert!((of_item(&check(&p, "check-forces").result, "value").unwrap() / force - 1.0).abs() < 2e-3);
    // over a range the largest counts, and what lies outside the range does not
    let range = "[operation]\nspeed = { from = 60, to = 85 }\n";
    let p = of_studies(&jeffcott("", damping, &format!("{range}{}", study("forced_response", wide))));
    let found = number(&check(&p, "check-vibration").result, "sizes");
    assert!((found / amplitude(85.0, damping) - 1.0).abs() < 2e-3, "{found}");
    for kind in ["campbell", "critical_speeds"] {
        let p = of_studies(&jeffcott("speed = 80.0", damping, &study(kind, wide)));
        let near = check(&p, "check-resonance");
        assert!((near.margin.unwrap() - (CRITICAL - 80.0) / 80.0).abs() < 1e-3, "{kind}: {near:?}");
    }
}

/// A study that begins above the lower speeds does not say that a run-up from standstill crosses nothing.
#[test]
fn a_run_up_is_not_free_of_what_no_study_covers() {
    let of = |from: f64| {
        let study = format!("[[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = {from:?}, to = 400 }}\n");
        check(&of_studies(&jeffcott("speed = 80.0", 4.0, &study)), "check-run-up").clone()
    };
    assert_eq!((of(2.0).result.key.as_str(), of(2.0).verdict), ("run-up-free", Verdict::Passed));
    let open = of(60.0);
    assert_eq!((open.result.key.as_str(), open.verdict), ("run-up-unknown", Verdict::NotComputed));
    assert!((number(&open.result, "speed") - 60.0).abs() < 1e-9);
}

/// A fast run-up to a speed just below the critical one ends before the vibration has grown to that of the steady response.
#[test]
fn after_a_run_up_the_steady_response_counts() {
    let (speed, damping) = (95.0, 4.0);
    let of = |time: f64, limit: f64| {
        let more = format!("[operation]\nspeed = {speed:?}\nrun_up_time = {time:?}\n[limits]\npassage_displacement = {limit:?}\n");
        check(&page(&jeffcott("", damping, &more)), "check-run-up").clone()
    };
    let steady = amplitude(speed, damping);
    let short = of(0.5, 0.99 * steady);
    assert_eq!((short.result.key.as_str(), short.verdict), ("run-up-steady", Verdict::Failed), "{short:?}");
    assert!((number(&short.result, "value") / steady - 1.0).abs() < 1e-9, "{short:?}");
    assert_eq!(of(0.5, 1.01 * steady).verdict, Verdict::Passed);
    // above the critical speed the passage is larger
    let passing = page(&jeffcott("", damping, "[operation]\nspeed = 200.0\nrun_up_time = 20.0\n"));
    let passing = check(&passing, "check-run-up");
    assert!(passing.result.key == "run-up-computed" && number(&passing.result, "value") > 2.0 * amplitude(200.0, damping));
}

/// Of an unstable machine no steady response is reached.
#[test]
fn an_unstable_machine_has_no_steady_response_after_its_run_up() {
    let inner = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 200.0\naxes = \"rotating\"\n";
    // unstable above 75 rad/s
    let text = jeffcott("", 0.0, &format!("{inner}[operation]\nspeed = 105.0\nrun_up_time = 0.2\n"));
    assert_ne!(check(&page(&text), "check-run-up").result.key, "run-up-steady");
}

/// Each body has its own limit.
#[test]
fn the_limit_of_the_passage_is_that_of_each_body() {
    let text = |disc: f64, base: f64| {
        format!(
            "[machine]\nname = \"m\"\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4\neccentricity = 2e-5\n\
             [[part]]\nkind = \"foundation\"\nname = \"base\"\nmass = 400\nstiffness = 4e7\ndamping = 4e4\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"spring\"\nbetween = [\"disc\", \"base\"]\nstiffness = 4e4\ndamping = 16\n\
             [operation]\nspeed = 200.0\nrun_up_time = 5.0\n[limits]\npassage_displacement = {{ disc = {disc:?}, base = {base:?} }}\n"
        )
    };
    let of = |disc, base| check(&page(&text(disc, base)), "check-run-up").verdict;
    // the foundation moves about a thousandth of the disc
    assert_eq!((of(1e-2, 1e-5), of(1e-5, 1e-2), of(1e-2, 1e-9)), (Verdict::Passed, Verdict::Failed, Verdict::Failed));
}

/// A bearing whose cross-coupled stiffness has a tip of height `cross` at 150.35 rad/s: the growth there is (cross/w - c)/(2 m).
fn tip(cross: f64, operation: &str) -> String {
    let film = format!(
        "table = {{ speed = [0.0, 140.35, 150.35, 160.35, 1000.0], kxx = [4e4, 4e4, 4e4, 4e4, 4e4], kyy = [4e4, 4e4, 4e4, 4e4, 4e4], \
         kxy = [0.0, 0.0, {cross:?}, 0.0, 0.0], kyx = [0.0, 0.0, -{cross:?}, 0.0, 0.0], cxx = [8.0, 8.0, 8.0, 8.0, 8.0], cyy = [8.0, 8.0, 8.0, 8.0, 8.0] }}"
    );
    format!(
        "[machine]\nname = \"film\"\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4.0\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"film\"\nbetween = [\"disc\", \"ground\"]\n{film}\n[operation]\n{operation}\n"
    )
}

/// Between the speeds computed: the machine is unstable within 0.15 rad/s of the tip alone.
#[test]
fn a_machine_unstable_only_inside_its_operating_range_is_found() {
    let cross = 800.5;
    let p = page(&tip(cross, "speed = { from = 120.0, to = 180.0 }"));
    let found = check(&p, "check-stability");
    assert_eq!((found.verdict, found.result.key.as_str(), p.verdict), (Verdict::Failed, "stability-unstable-range", Verdict::Failed));
    let Some(Arg::Phrase(range)) = found.result.arg_named("range") else { panic!("{found:?}") };
    // the table is joined smoothly: the share s of the way to the next row lowers the tip by 3 s^2 - 2 s^3
    let lower = 1.0 - 800.0 / cross;
    let s = (0..60).fold(0.0f64, |s, _| ((lower + 2.0 * s.powi(3)) / 3.0).sqrt());
    for (name, want) in [("from", 150.35 - 10.0 * s), ("to", 150.35 + 10.0 * s)] {
        assert!((number(range, name) - want).abs() < 1e-4, "{name}: {range:?}, not {want}");
    }
    // at the ends and at single speeds beside the tip nothing grows
    for calm in ["speed = { from = 120.0, to = 149.0 }", "speed = 151.0"] {
        assert_eq!(check(&page(&tip(cross, calm)), "check-stability").verdict, Verdict::Passed, "{calm}");
    }
}

/// The decay and the decrement over a range are the least ones, at the tip.
#[test]
fn the_least_decay_over_the_range_counts() {
    let of = |more: &str| page(&tip(500.0, &format!("speed = {{ from = 120.0, to = 180.0 }}\n{more}")));
    let (decay, p) = ((8.0 - 500.0 / CRITICAL) / (2.0 * MASS), of("decrement = 0.01"));
    let found = check(&p, "check-stability");
    assert!((number(&found.result, "decay") / decay - 1.0).abs() < 1e-4 && found.verdict == Verdict::Passed, "{found:?}");
    let place = number(found.detail.as_ref().unwrap(), "place");
    assert!((place - 150.35).abs() < 1e-3, "{place}");
    assert!((number(&check(&p, "check-damping").result, "decrement") / (TAU * decay / CRITICAL) - 1.0).abs() < 1e-3);
    for (margin, verdict) in [(0.99 * decay, Verdict::Passed), (1.01 * decay, Verdict::Failed)] {
        assert_eq!(check(&of(&format!("[limits]\ngrowth_margin = {margin:?}")), "check-stability").verdict, verdict, "{margin}");
    }
    for (least, verdict) in [(0.99, Verdict::Passed), (1.01, Verdict::Failed)] {
        let p = of(&format!("decrement = {:?}", least * TAU * decay / CRITICAL));
        assert_eq!(check(&p, "check-damping").verdict, verdict);
    }
}

/// The study of critical speeds requires the margin of the machine, unless it has its own.
#[test]
fn critical_speeds_keep_the_margin_of_the_operation() {
    // 23 % above the critical speed
    let level = |operation: &str, own: &str| {
        let study = format!("{operation}[[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = 10, to = 300 }}\n{own}\n");
        let loaded = load(&jeffcott("speed = 130.0", 4.0, &study));
        let outcome = loaded.studies[0].study.run(&loaded.system, &Context::quiet("own")).unwrap();
        outcome.findings.iter().find(|f| f.id == "margin").expect("a margin").level
    };
    assert_eq!(level("", ""), Level::Info);
    assert_eq!(level("[operation]\nresonance_margin = \"30 %\"\n", ""), Level::Warning);
    assert_eq!(level("[limits]\nclearance = \"30 %\"\n", ""), Level::Warning);
    assert_eq!(level("[operation]\nresonance_margin = \"30 %\"\n", "margin = \"10 %\""), Level::Info);
    assert_eq!(level("[operation]\nresonance_margin = \"10 %\"\n", "margin = \"30 %\""), Level::Warning);
}

/// Of two parts that state limits the one that uses most of its own is named.
#[test]
fn validity_names_the_part_and_its_statement() {
    let cubic = |name: &str, valid: f64| {
        format!(
            "[[part]]\nkind = \"bearing_cubic\"\nname = \"{name}\"\nbetween = [\"disc\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 1e3\n\
             cubic_stiffness = 1e3\nvalid_to = {valid:?}\n"
        )
    };
    let (speed, critical) = (200.0, (4.2e4f64 / MASS).sqrt());
    let of = |a: f64, b: f64| page(&jeffcott("speed = 200.0", 4.0, &format!("{}{}", cubic("left", a), cubic("right", b))));
    let r: f64 = speed / critical;
    let amplitude = ECCENTRICITY * r * r / (r * r - 1.0);
    let p = of(2.0 * amplitude, 4.0 * amplitude);
    let found = check(&p, "check-validity");
    assert_eq!((found.verdict, found.result.key.as_str()), (Verdict::Passed, "validity-inside"));
    let Some(Arg::Phrase(statement)) = found.result.arg_named("statement") else { panic!("{found:?}") };
    assert_eq!(statement.arg_named("part"), Some(&Arg::name("left")));
    assert_eq!(statement.arg_named("what"), Some(&Arg::term("bearing deflection over the range of its law")));
    assert!((number(&found.result, "share") - 0.5).abs() < 1e-3, "{found:?}");
    let p = of(2.0 * amplitude, 0.5 * amplitude);
    let found = check(&p, "check-validity");
    assert_eq!((found.verdict, found.result.key.as_str()), (Verdict::Failed, "validity-outside-here"));
    let Some(Arg::Phrase(statement)) = found.result.arg_named("statement") else { panic!("{found:?}") };
    assert_eq!(statement.arg_named("part"), Some(&Arg::name("right")));
}

/// The advice names the keys of limits that are missing, and no others.
#[test]
fn missing_limits_are_named_by_their_keys() {
    let keys = |more: &str| {
        let p = page(&jeffcott("", 16.0, &format!("[operation]\nspeed = 200.0\nrun_up_time = 1.0\n{more}")));
        let next = p.next.iter().find(|m| m.key == "next-limits");
        next.map(|m| m.arg_named("keys").cloned().unwrap())
    };
    assert_eq!(keys(""), Some(Arg::names(["displacement", "force", "passage_displacement"])));
    assert_eq!(keys("[limits]\ndisplacement = 1e-3\n"), Some(Arg::names(["force", "passage_displacement"])));
    assert_eq!(keys("[limits]\nvelocity = 1.0\nforce = 1e3\n"), Some(Arg::names(["passage_displacement"])));
    assert_eq!(keys("[limits]\ndisplacement = 1e-3\nforce = 1e3\npassage_displacement = 1e-2\n"), None);
}

/// A file without study has its page, with studies to add.
#[test]
fn a_file_without_study_is_assessed_and_studies_are_proposed() {
    let p = page(&jeffcott("speed = 200.0", 4.0, ""));
    assert_eq!(p.verdict, Verdict::Passed);
    let kinds = |p: &Overview| p.next.iter().find(|m| m.key == "next-studies").map(|m| m.arg_named("kinds").cloned().unwrap());
    assert_eq!(kinds(&p), Some(Arg::names(["campbell", "forced_response"])));
    assert_eq!(keys(&page(&jeffcott("", 4.0, "")).next), ["next-speed", "next-studies"]);
    assert_eq!(kinds(&page(&jeffcott("speed = 200.0", 4.0, "[[study]]\nkind = \"modes\"\n"))), None);
}

/// Force over a turn of a lying rotor: its weight, and the force of the vibration beside it; upright there is no static part.
#[test]
fn forces_hold_the_static_load_and_say_so() {
    let force = amplitude(200.0, 4.0) * STIFFNESS.hypot(4.0 * 200.0);
    let lying = page(&jeffcott("speed = 200.0\naxis = \"horizontal\"", 4.0, ""));
    let found = check(&lying, "check-forces");
    let weight = MASS * 9.80665;
    assert!((of_item(&found.result, "rest").unwrap() / weight - 1.0).abs() < 1e-6, "{found:?}");
    assert!((of_item(&found.result, "value").unwrap() / (weight + force) - 1.0).abs() < 1e-2, "{found:?}");
    assert_eq!(found.detail.as_ref().map(|d| d.key.as_str()), Some("forces-with-rest"));
    // the displacement does not hold the deflection under the weight
    assert!((number(&check(&lying, "check-vibration").result, "sizes") / amplitude(200.0, 4.0) - 1.0).abs() < 1e-9);
    let upright = page(&jeffcott("speed = 200.0", 4.0, ""));
    let found = check(&upright, "check-forces");
    assert_eq!((of_item(&found.result, "rest"), found.detail.is_none()), (None, true));
}

/// Two springs side by side share the force as their stiffnesses, 1 to 3: each force stands beside its own limit, the one that is used most first.
#[test]
fn differing_limits_stand_beside_their_values() {
    let second = format!(
        "[[part]]\nkind = \"bearing_linear\"\nname = \"second\"\nbetween = [\"disc\", \"ground\"]\nstiffness = {:?}\n",
        3.0 * STIFFNESS
    );
    let of = |limits: &str| page(&jeffcott("speed = 250.0", 0.0, &format!("{second}[limits]\n{limits}\n")));
    let force = STIFFNESS * 1e-4;
    let p = of(&format!("force = {{ spring = {:?}, second = {:?} }}", 0.5 * force, 100.0 * force));
    let found = check(&p, "check-forces");
    assert_eq!(found.required, Some(Message::new("required-each").into()));
    let Some(Arg::List(all)) = found.result.arg_named("sizes") else { panic!("{found:?}") };
    let shown = all.iter().map(|a| match a {
        Arg::Phrase(item) => (item.arg_named("name").cloned().unwrap(), number(item, "value"), number(item, "limit") / force),
        other => panic!("{other:?}"),
    });
    let shown: Vec<(Arg, f64, f64)> = shown.collect();
    let names = ["spring", "second"].map(Arg::name);
    assert!(shown.len() == 2 && shown[0].0 == names[0] && shown[1].0 == names[1], "{shown:?}");
    assert!((shown[1].1 / shown[0].1 - 3.0).abs() < 1e-9, "{shown:?}");
    assert!((shown[0].2 - 0.5).abs() < 1e-12 && (shown[1].2 - 100.0).abs() < 1e-9, "{shown:?}");
    // one limit for all stands once
    assert_ne!(check(&of("force = 1.0"), "check-forces").required, found.required);
}

/// The ball balancer of example 04: stable above 558 rad/s, harmful below; the vibration is that of its stable state, 2 um, which the eccentricity of the ring leaves.
#[test]
fn a_machine_with_balls_has_its_distance_and_its_vibration() {
    let file = include_str!("../../../../examples/04-ball-balancer/machine.toml");
    let machine = file.split("# Above the critical").next().unwrap();
    let study = "[[study]]\nkind = \"stationary\"\nspeed = { from = 300, to = 1200, points = 31 }\n";
    let p = page(&format!("{machine}{study}[limits]\ndisplacement = 2.1e-6\n"));
    let near = check(&p, "check-instability");
    let margin = near.margin.unwrap();
    assert!((margin - (900.0 - 558.158) / 900.0).abs() < 1e-4 && near.verdict == Verdict::Passed, "{near:?}");
    assert_eq!(near.result.key, "distance-below");
    let found = check(&p, "check-vibration");
    assert!((number(&found.result, "sizes") / 2e-6 - 1.0).abs() < 0.01 && found.verdict == Verdict::Passed, "{found:?}");
    assert_eq!((p.verdict, keys(&p.headline)), (Verdict::Attention, vec!["headline-stable", "headline-slip"]));
    assert!(p.remarks.iter().flat_map(|r| &r.1).any(|m| m.key == "remark-harm" && (number(m, "times") / 2.599 - 1.0).abs() < 1e-3));
    assert!(keys(&p.next).contains(&"next-harm"));
    for (more, name, verdict) in [
        ("[limits]\ndisplacement = 1.9e-6\n", "check-vibration", Verdict::Failed),
        ("[operation]\ninstability_margin = \"40 %\"\n", "check-instability", Verdict::Failed),
        ("[operation]\ninstability_margin = \"37 %\"\n", "check-instability", Verdict::Passed),
    ] {
        assert_eq!(check(&page(&format!("{machine}{study}{more}")), name).verdict, verdict, "{more}");
    }
}

/// The page of an unstable machine states the speed up to which it is stable.
#[test]
fn the_unstable_range_about_the_operating_speed_is_named() {
    let inner = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 2.0\naxes = \"rotating\"\n";
    let p = page(&jeffcott("speed = 230.0", 2.0, inner));
    let found = check(&p, "check-instability");
    assert_eq!((found.verdict, found.result.arg_named("open")), (Verdict::Failed, Some(&Arg::word("yes"))));
    assert!((number(&found.result, "from") - 200.0).abs() < 1e-3, "{found:?}");
}

/// Rotating damping makes the machine unstable above w (1 + c_a/c_i) without an upper end: where the examination ends, no end is claimed and no speed above it advised.
#[test]
fn the_end_of_the_examination_is_no_end_of_the_unstable_range() {
    let inner = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 2.0\naxes = \"rotating\"\n";
    let studied = |speed: f64, kind: &str| {
        let study = format!("{inner}[[study]]\nkind = \"{kind}\"\nspeed = {{ from = 20.0, to = 250.0 }}\n[[study]]\nkind = \"modes\"\n");
        of_studies(&jeffcott(&format!("speed = {speed:?}"), 2.0, &study))
    };
    for kind in ["campbell", "stability_map"] {
        let p = studied(230.0, kind);
        let found = check(&p, "check-instability");
        assert_eq!((found.verdict, found.result.arg_named("open")), (Verdict::Failed, Some(&Arg::word("yes"))), "{kind}");
        assert!((number(&found.result, "from") - 200.0).abs() < 1.0 && number(&found.result, "to") == 250.0, "{kind}: {found:?}");
        let below = studied(150.0, kind);
        let remark = below.remarks.iter().flat_map(|r| &r.1).find(|m| m.key == "remark-unstable").expect("a range above");
        assert_eq!((remark.arg_named("open"), number(remark, "to")), (Some(&Arg::word("yes")), 250.0), "{kind}");
        assert_eq!(below.over_speed.as_ref().unwrap().examined, Some((20.0, 250.0)));
    }
    let advice = studied(230.0, "stability_map").next.into_iter().find(|m| m.key == "next-unstable").expect("advice");
    assert_eq!(advice.arg_named("sides"), Some(&Arg::word("below")), "{advice:?}");
}

/// What a study of particles doubts is not passed over.
#[test]
fn doubts_of_the_studies_are_in_the_check_of_validity() {
    let loaded = load(&jeffcott("speed = 200.0", 4.0, ""));
    let doubt = laval::outcome::Finding::warning("validity_reynolds", "separation-validity").arg("name", Arg::term("reynolds"));
    let of = |outcome: Outcome| {
        let p = overview(&loaded.system, &[], &[outcome], &Context::quiet("page"));
        check(&p, "check-validity").verdict
    };
    let empty = || Outcome::new("separation", "cream");
    assert_eq!((of(empty()), of(empty().finding(doubt.clone()))), (Verdict::NoLimit, Verdict::Attention));
    let p = overview(&loaded.system, &[], &[empty().finding(doubt)], &Context::quiet("page"));
    assert_eq!((p.verdict, keys(&p.headline)), (Verdict::Attention, vec!["headline-stable", "headline-validity"]));
    assert!(keys(&p.next).contains(&"next-validity"));
}

/// A rotor that tilts about its lower bearing, which is stiff, moves there hardly at all: vibration is that of its farthest point. Against the bearings of equal
/// stiffness the whole rotor moves alike, and the body is named.
#[test]
fn vibration_is_that_of_the_point_that_moves_most() {
    let bearing = |name: &str, at: f64, stiffness: f64| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"disc\", at = {at:?} }}, \"ground\"]\nstiffness = {stiffness}\ndamping = 5.0\n"
        )
    };
    let machine = |inner: f64, low: f64| {
        format!(
            "[machine]\nspeed = 60.0\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4.0\neccentricity = 1e-4\ndiametral_inertia = {inner}\npolar_inertia = 0.01\n{}{}",
            bearing("low", -0.2, low),
            bearing("high", 0.2, 2e4)
        )
    };
    let item = |p: &Overview| {
        let size = check(p, "check-vibration").result.clone();
        let Some(Arg::List(all)) = size.arg_named("sizes").cloned() else { panic!("{size:?}") };
        assert_eq!(all.len(), 1);
        let Arg::Phrase(item) = &all[0] else { panic!("{all:?}") };
        (item.arg_named("name").cloned(), of_item(&size, "value").unwrap())
    };
    // with the centre of mass between bearings of one stiffness nothing tilts
    let alike = page(&machine(0.1, 2e4));
    let level = 4.0 * 1e-4 * 3600.0 / (4e4f64 - 4.0 * 3600.0).hypot(10.0 * 60.0);
    let (name, value) = item(&alike);
    assert_eq!(name, Some(Arg::name("disc")));
    assert!((value / level - 1.0).abs() < 1e-6, "{value} {level}");
    // about a fixed point 0.2 m below: the centre of mass moves as without tilt of a mass m + I/h^2 against four times the stiffness, the upper bearing twice as far
    let inner = 0.1 - 0.01;
    let pivoted = page(&machine(0.1, 2e9));
    let centre = 4.0 * 1e-4 * 3600.0 / (8e4 - (4.0 + inner / 0.04) * 3600.0);
    let (name, value) = item(&pivoted);
    assert!(name.as_ref().is_some_and(|n| *n != Arg::name("disc")), "{name:?}");
    assert!((value / (2.0 * centre) - 1.0).abs() < 1e-3, "{value} {centre}");
    let over = pivoted.over_speed.unwrap();
    // a limit of the body holds at each of its points, one of a point there alone
    let limit = |who: &str, value: f64| {
        let p = page(&format!("{}[limits]\ndisplacement = {{ {who} = {value:e} }}\n", machine(0.1, 2e9)));
        check(&p, "check-vibration").verdict
    };
    assert_eq!([limit("disc", 1.5 * centre), limit("disc", 2.1 * centre)], [Verdict::Failed, Verdict::Passed]);
    assert_eq!([limit("\"disc at 200 mm\"", 1.9 * centre), limit("\"disc at -200 mm\"", 0.1 * centre)], [Verdict::Failed, Verdict::Passed]);
    // on the way up as well
    let passage =
        |limits: &str| check(&page(&format!("{}[operation]\nrun_up_time = 2.0\n{limits}", machine(0.1, 2e9))), "check-run-up").clone();
    let most = number(&passage("").result, "value");
    let verdict = |share: f64| passage(&format!("[limits]\npassage_displacement = {{ disc = {:e} }}\n", share * most)).verdict;
    assert_eq!([verdict(0.9), verdict(1.1)], [Verdict::Failed, Verdict::Passed]);
    // the curve is that of this point
    let height = |a: &Arg| match a {
        Arg::Phrase(m) => number(m, "height"),
        _ => f64::NAN,
    };
    assert!(over.amplitudes.len() == 1 && height(&over.amplitudes[0].0) == 0.2 && name.is_some_and(|n| height(&n) == 0.2));
}

/// A peak far narrower than the steps of the curve stands in it with its height: m e W^2/(c W) at W^2 = k/m, which damping this small moves by nothing visible.
#[test]
fn narrow_peaks_stand_in_the_curve() {
    let damping = 1e-3;
    let over = page(&jeffcott("speed = 80.0", damping, "")).over_speed.unwrap();
    let height = MASS * ECCENTRICITY * CRITICAL / damping;
    let largest = over.amplitudes[0].1.iter().copied().fold(0.0, f64::max);
    assert!((largest / height - 1.0).abs() < 1e-3, "{largest} {height}");
    assert_eq!(over.resonances[0].amplitude.as_ref().map(|a| a.1), Some(largest));
    assert!(over.response_speed.is_sorted() && over.amplitudes[0].1.len() == over.response_speed.len());
}

/// Unbalance does not excite a whirl against the rotation: of a rigid rotor that tilts against two bearings the forward critical speed is at W^2 = kt/(Id - Ip), the
/// backward one at kt/(Id + Ip).
#[test]
fn backward_critical_speeds_are_no_resonances() {
    let bearing = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"disc\", at = {at:?} }}, \"ground\"]\nstiffness = 2e4\ndamping = 0.2\n"
        )
    };
    let text = format!(
        "[machine]\nname = \"m\"\nspeed = 60.0\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4.0\ndiametral_inertia = 0.1\npolar_inertia = 0.04\n{}{}",
        bearing("low", -0.1),
        bearing("high", 0.1)
    );
    let p = page(&text);
    let near = check(&p, "check-resonance");
    let forward = (2.0f64 * 2e4 * 0.01 / (0.1 - 0.04)).sqrt();
    assert!((near.margin.unwrap() - (forward - 60.0) / 60.0).abs() < 1e-3, "{near:?}");
    assert_eq!(near.result.arg_named("below"), Some(&Arg::word("none")));
    // cards: the cylindrical modes lie between the conical ones, of which the gyroscopic moment makes the forward one faster: Id w^2 -+ Ip W w - kt = 0
    let conical = |side: f64| (0.04 * 60.0 * side + (0.04f64 * 60.0).hypot(2.0 * (0.1f64 * 2.0 * 2e4 * 0.01).sqrt())) / 0.2;
    let cylindrical = (2.0f64 * 2e4 / 4.0).sqrt();
    for (frequency, whirl) in [(conical(1.0), "forward"), (conical(-1.0), "backward"), (cylindrical, "forward"), (cylindrical, "backward")]
    {
        let found = p.modes.iter().filter(|m| m.whirl == whirl && (m.frequency.abs() / frequency - 1.0).abs() < 1e-4).count();
        assert_eq!(found, 1, "{whirl} at {frequency}: {:?}", p.modes);
    }
}

/// The headline names an unstable range that the run-up crosses, and none above the operating speed.
#[test]
fn the_headline_names_unstable_ranges_on_the_way_up() {
    let p = page(&tip(2000.0, "speed = 200.0"));
    assert_eq!((p.verdict, keys(&p.headline)), (Verdict::Attention, vec!["headline-stable", "headline-crosses"]));
    assert!(number(&p.headline[1], "from") > 140.0 && number(&p.headline[1], "to") < 161.0);
    // inside it, the speeds nearest below and above of which the ends are 15 % away
    let map = "speed = 150.0\n[[study]]\nkind = \"stability_map\"\nspeed = { from = 5, to = 400, points = 400 }";
    let inside = page(&tip(2000.0, map));
    let next = inside.next.iter().find(|m| m.key == "next-unstable").expect("advice");
    assert_eq!(next.arg_named("sides"), Some(&Arg::word("both")));
    let ends = &inside.over_speed.as_ref().unwrap().unstable[0];
    assert!((140.35..150.35).contains(&ends.from) && (150.35..160.35).contains(&ends.to));
    for (side, end) in [("below", ends.from), ("above", ends.to)] {
        let speed = number(next, side);
        assert!(((speed - end).abs() / speed - 0.15).abs() < 1e-12, "{side}: {speed}");
    }
    let below = page(&tip(2000.0, "speed = 120.0"));
    assert_eq!(keys(&below.headline), ["headline-stable"]);
}
