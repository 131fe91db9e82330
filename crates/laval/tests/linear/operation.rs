//! The block `[operation]` against closed forms of a disc on springs (docs/theory/linear-vibration.md): its range, its margins, its run-up.

use super::overview::{ECCENTRICITY, MASS, STIFFNESS, check, jeffcott, number, page};
use crate::common::files::load;
use laval::file::load as read;
use laval::outcome::{Arg, Finding, Level, Outcome, Overview, Verdict};
use laval::study::{Cancel, Context, overview, presentation};
use std::f64::consts::TAU;

fn of(operation: &str, damping: f64) -> Overview {
    page(&jeffcott("", damping, &format!("[operation]\n{operation}\n")))
}

/// Amplitude at a speed.
fn amplitude(speed: f64, damping: f64) -> f64 {
    let r = speed / (STIFFNESS / MASS).sqrt();
    let zeta = damping / (2.0 * (STIFFNESS * MASS).sqrt());
    ECCENTRICITY * r * r / ((1.0 - r * r).powi(2) + (2.0 * zeta * r).powi(2)).sqrt()
}

/// Peak of the response: speed and amplitude.
fn peak(damping: f64) -> (f64, f64) {
    let zeta = damping / (2.0 * (STIFFNESS * MASS).sqrt());
    let speed = (STIFFNESS / MASS).sqrt() / (1.0 - 2.0 * zeta * zeta).sqrt();
    (speed, ECCENTRICITY / (2.0 * zeta * (1.0 - zeta * zeta).sqrt()))
}

#[test]
fn a_range_counts_from_its_nearer_end_and_by_its_worst_speed() {
    let p = of("speed = { from = 150.0, to = 200.0 }", 4.0);
    assert_eq!((p.operating, p.operating_range), (Some(200.0), Some((150.0, 200.0))));
    assert_eq!(p.verdict, Verdict::Passed, "{:?}", p.headline);
    let near = check(&p, "check-resonance").margin.unwrap();
    assert!((near - (150.0 - peak(4.0).0) / 150.0).abs() < 1e-4, "{near}");
    // largest at the lower end, above the critical speed
    let found = number(&check(&p, "check-vibration").result, "sizes");
    assert!((found / amplitude(150.0, 4.0) - 1.0).abs() < 1e-9, "{found}");
    assert_eq!(check(&p, "check-run-up").result.key, "run-up-resonances");
}

/// As the speed of `[machine]`: what turns the other way is a spin of negative ratio.
#[test]
fn negative_operating_speeds_are_refused_at_their_place() {
    for speed in ["-200.0", "{ from = -200.0, to = -150.0 }", "{ from = -200.0, to = 150.0 }"] {
        let text = jeffcott("", 4.0, &format!("[operation]\nspeed = {speed}\n"));
        let wrong = read(&text).err().unwrap_or_else(|| panic!("{speed} is read"));
        let places: Vec<&str> = wrong.0.iter().map(|d| &text[d.span.clone().unwrap()]).collect();
        assert!(places[0].contains("-200.0") && places.iter().all(|p| p.contains('-')), "{wrong:?}");
    }
}

#[test]
fn a_resonance_among_the_operating_speeds_has_no_margin() {
    let p = of("speed = { from = 80.0, to = 120.0 }", 4.0);
    let near = check(&p, "check-resonance");
    assert_eq!((near.margin, near.verdict, near.result.key.as_str()), (Some(0.0), Verdict::Attention, "distance-inside"));
    let found = number(&check(&p, "check-vibration").result, "sizes");
    assert!((found / peak(4.0).1 - 1.0).abs() < 1e-6, "{found} is not the peak {}", peak(4.0).1);
    // the velocity there is the amplitude times the speed
    let velocity = number(check(&p, "check-vibration").detail.as_ref().unwrap(), "peak");
    assert!(velocity >= peak(4.0).0 * peak(4.0).1 && velocity < 1.01 * peak(4.0).0 * peak(4.0).1, "{velocity}");
    for margin in ["0.1", "0.0"] {
        let p = of(&format!("speed = {{ from = 80.0, to = 120.0 }}\nresonance_margin = {margin}"), 4.0);
        assert_eq!(p.verdict, Verdict::Failed, "{margin}");
    }
}

/// The study of critical speeds measures its margin as the page does: from the nearest operating speed, also from the lower end of a range.
#[test]
fn a_study_measures_from_the_nearest_operating_speed() {
    let margin = |range: &str| {
        let more = format!(
            "[operation]\nspeed = {range}\nresonance_margin = 0.15\n[[study]]\nkind = \"critical_speeds\"\nspeed = {{ from = 20.0, to = 300.0 }}\n"
        );
        let text = jeffcott("", 4.0, &more);
        let loaded = load(&text);
        let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{d:?}"));
        let f = o.findings.iter().find(|f| f.id == "margin").expect("a margin").clone();
        (f.value.unwrap(), f.level, f.evidence.iter().find(|e| e.what == "its speed").unwrap().value)
    };
    for (range, end) in [("{ from = 103.0, to = 200.0 }", 103.0), ("{ from = 40.0, to = 97.0 }", 97.0), ("97.0", 97.0)] {
        let (value, level, place) = margin(range);
        assert!((value - (place - end).abs() / end).abs() < 1e-12 && value < 0.04 && level == Level::Warning, "{range}: {value} {place}");
    }
    let (inside, level, _) = margin("{ from = 80.0, to = 200.0 }");
    assert_eq!((inside, level), (0.0, Level::Warning));
    assert_eq!(margin("{ from = 150.0, to = 200.0 }").1, Level::Info);
}

/// Coefficients that begin above the lowest speed of the page: margins come from the studies of the file, and what no study computed is open and not green.
#[test]
fn a_margin_that_is_required_and_not_computed_is_not_green() {
    let text = |margins: &str, studies: &str| {
        format!(
            "[machine]\nname = \"rotor\"\nspeed = 104.0\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = {MASS}\neccentricity = {ECCENTRICITY}\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"spring\"\nbetween = [\"disc\", \"ground\"]\n[part.table]\nspeed = [50.0, 200.0]\n\
             kxx = [{STIFFNESS}, {STIFFNESS}]\nkyy = [{STIFFNESS}, {STIFFNESS}]\ncxx = [4.0, 4.0]\ncyy = [4.0, 4.0]\n\
             [operation]\nspeed = 104.0\n{margins}{studies}"
        )
    };
    let study = |kind: &str| format!("[[study]]\nkind = \"{kind}\"\nspeed = {{ from = 50.0, to = 200.0 }}\n");
    // the table does not reach as far as the distance either
    let short = |margins: &str| page(&text(margins, "").replace("[50.0, 200.0]", "[103.0, 200.0]"));
    let open = short("resonance_margin = 0.15\ninstability_margin = 0.1\n");
    for name in ["check-resonance", "check-instability"] {
        let found = check(&open, name);
        assert_eq!((found.verdict, found.detail.as_ref().unwrap().key.as_str()), (Verdict::Attention, "distance-not-examined"), "{name}");
    }
    let said = open.headline.iter().find(|m| m.key == "headline-attention").unwrap_or_else(|| panic!("{:?}", open.headline));
    assert!(open.verdict == Verdict::Attention && matches!(said.arg_named("checks"), Some(Arg::List(l)) if l.len() == 2), "{said:?}");
    // as far as the table reaches is enough for a smaller distance
    assert_eq!(short("resonance_margin = 0.005\ninstability_margin = 0.005\n").verdict, Verdict::Passed);
    // where the table reaches, the page finds the resonance at 100 rad/s itself
    assert_eq!(check(&page(&text("", "")), "check-resonance").verdict, Verdict::Attention);
    for kind in ["critical_speeds", "campbell"] {
        let p = page(&text("resonance_margin = 0.15\n", &(study(kind) + &study("forced_response"))));
        let near = check(&p, "check-resonance");
        assert_eq!((p.verdict, near.verdict), (Verdict::Failed, Verdict::Failed), "{kind}: {:?}", p.headline);
        let expected = (104.0 - peak(4.0).0) / 104.0;
        assert!((near.margin.unwrap() - expected).abs() < 1e-3, "{kind}: {near:?} {expected}");
        assert_eq!(check(&p, "check-instability").verdict, Verdict::Passed, "{kind}");
    }
}

#[test]
fn margins_of_the_block_come_before_those_of_the_standard() {
    let at = |more: &str| of(&format!("speed = 200.0\n{more}"), 4.0);
    assert_eq!(check(&at("resonance_margin = 0.49"), "check-resonance").verdict, Verdict::Passed);
    assert_eq!(check(&at("resonance_margin = 0.51"), "check-resonance").verdict, Verdict::Failed);
    // decrement 2 pi zeta / sqrt(1 - zeta^2)
    let zeta = 4.0 / (2.0 * (STIFFNESS * MASS).sqrt());
    let decrement = TAU * zeta / (1.0 - zeta * zeta).sqrt();
    for (factor, verdict) in [(0.99, Verdict::Passed), (1.01, Verdict::Failed)] {
        let p = at(&format!("decrement = {:?}", factor * decrement));
        let damping = check(&p, "check-damping");
        assert_eq!((damping.verdict, p.verdict == Verdict::Failed), (verdict, verdict == Verdict::Failed));
        assert!((number(&damping.result, "decrement") / decrement - 1.0).abs() < 1e-9);
    }
    assert!(at("").checks.iter().all(|c| c.what.key != "check-damping"));
}

/// Rotating damping c_i destabilises above w (1 + c_a/c_i) = 200 rad/s.
#[test]
fn an_unstable_part_of_the_range_is_not_met() {
    let inner = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 2.0\naxes = \"rotating\"\n";
    let of = |operation: &str| page(&jeffcott("speed = 150.0", 2.0, &format!("{inner}[operation]\n{operation}\n")));
    let p = of("speed = { from = 140.0, to = 210.0 }");
    let stability = check(&p, "check-stability");
    assert_eq!((stability.verdict, stability.result.key.as_str()), (Verdict::Failed, "stability-unstable-range"));
    assert_eq!((p.verdict, check(&p, "check-vibration").result.key.as_str()), (Verdict::Failed, "vibration-unstable"));
    let p = of("speed = { from = 140.0, to = 190.0 }\ninstability_margin = 0.05");
    let near = check(&p, "check-instability");
    assert!((near.margin.unwrap() - 10.0 / 190.0).abs() < 1e-3 && near.verdict == Verdict::Passed, "{near:?}");
    assert_eq!(check(&of("speed = { from = 140.0, to = 190.0 }\ninstability_margin = 0.06"), "check-instability").verdict, Verdict::Failed);
}

/// A slow passage reaches the steady peak, a fast one stays below it; the time is that of the block.
#[test]
fn the_run_up_is_simulated_in_its_time() {
    let largest = |time: f64| {
        let p = of(&format!("speed = 200.0\nrun_up_time = {time:?}"), 16.0);
        let run = check(&p, "check-run-up").clone();
        assert_eq!(run.result.key, "run-up-computed", "{run:?}");
        number(&run.result, "value") / peak(16.0).1
    };
    let (slow, fast) = (largest(200.0), largest(1.0));
    assert!((slow - 1.0).abs() < 0.02, "{slow}");
    assert!(fast > 0.1 && fast < 0.9, "{fast}");
    let p = page(&jeffcott("", 16.0, "[operation]\nspeed = 200.0\nrun_up_time = 1.0\n[limits]\npassage_displacement = 1e-6\n"));
    assert_eq!((check(&p, "check-run-up").verdict, p.verdict), (Verdict::Failed, Verdict::Failed));
    // too long for a page
    let long = of("speed = 200.0\nrun_up_time = 1e6", 16.0);
    assert_eq!(check(&long, "check-run-up").result.key, "run-up-resonances");
}

/// All operating speeds lie in one window.
#[test]
fn a_window_holds_the_whole_range() {
    let loaded = load(&jeffcott("", 4.0, "[operation]\nspeed = { from = 150.0, to = 200.0 }\n"));
    let of = |windows: &[(f64, f64)]| {
        let window = |(from, to): &(f64, f64)| Finding::info("window", "window").value(*to, "rad/s").arg("from", Arg::speed(*from));
        let outcome = windows.iter().fold(Outcome::new("operating_window", "window"), |o, w| o.finding(window(w)));
        check(&overview(&loaded.system, &[], &[outcome], &Context::quiet("page")), "check-window").verdict
    };
    assert_eq!(of(&[(20.0, 50.0), (140.0, 210.0)]), Verdict::Passed);
    for windows in [&[(140.0, 190.0)][..], &[(160.0, 210.0)], &[(140.0, 170.0), (172.0, 210.0)], &[]] {
        assert_eq!(of(windows), Verdict::Failed, "{windows:?}");
    }
}

/// Above the limit of rotating damping the growth rate is (W - W0) c_i/(2 m w): over the time of the passage a disturbance grows by exp of its integral.
#[test]
fn growth_on_the_way_through_an_unstable_range_is_its_integral() {
    let inner = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 2.0\naxes = \"rotating\"\n";
    let p = page(&jeffcott("", 2.0, &format!("{inner}[operation]\nspeed = 250.0\nrun_up_time = 20.0\n")));
    let factor = number(check(&p, "check-run-up").detail.as_ref().unwrap(), "factor");
    let slope = 2.0 / (2.0 * MASS * (STIFFNESS / MASS).sqrt());
    let want = (0.5 * slope * 50.0f64.powi(2) * 20.0 / 250.0).exp();
    assert!((factor.ln() / want.ln() - 1.0).abs() < 0.01, "{factor} and not {want}");
}

/// A run-up of millions of turns is given up after a part of the bound on its work, and named as what to do next; one that ends is shown.
#[test]
fn a_run_up_that_takes_too_long_is_given_up_early() {
    let of = |speed: f64, time: f64| {
        let loaded = load(&jeffcott("", 4.0, &format!("[operation]\nspeed = {speed:?}\nrun_up_time = {time:?}\n")));
        let stop = Cancel::default();
        let p = overview(&loaded.system, &[], &[], &Context { cancel: &stop, ..Context::quiet("summary") });
        (p.next.iter().any(|m| m.key == "next-run-up"), check(&p, "check-run-up").verdict, stop.spent())
    };
    let (next, verdict, short) = of(200.0, 5.0);
    assert!(!next && verdict == Verdict::NoLimit, "{verdict:?}");
    let (next, verdict, long) = of(2e4, 1000.0);
    assert!(next && verdict == Verdict::NotComputed, "{verdict:?}");
    // the bound is more than a billion units
    assert!(long < short + 300_000_000, "{short} {long}");
}

/// A range narrower than the steps over all speeds, within 20 % of the operating speed.
#[test]
fn a_narrow_unstable_range_beside_the_operating_speed_is_found() {
    let text = |centre: f64| {
        format!(
            "[machine]\nspeed = 160.0\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4.0\n[[part]]\nkind = \"bearing_linear\"\nname = \"film\"\n\
             between = [\"disc\", \"ground\"]\ntable = {{ speed = [0.0, {:?}, {:?}, {:?}, 1000.0], kxx = [4e4, 4e4, 4e4, 4e4, 4e4], kyy = [4e4, 4e4, 4e4, 4e4, 4e4], \
             kxy = [0.0, 0.0, 4e3, 0.0, 0.0], kyx = [0.0, 0.0, -4e3, 0.0, 0.0], cxx = [8.0, 8.0, 8.0, 8.0, 8.0], cyy = [8.0, 8.0, 8.0, 8.0, 8.0] }}\n",
            centre - 0.85,
            centre,
            centre + 0.85
        )
    };
    let p = page(&text(150.35));
    let over = p.over_speed.as_ref().unwrap();
    // narrower than the steps: the row of the table in it is computed as well
    let step = over.growth_speed[1] - over.growth_speed[0];
    assert!(step > 1.7, "{step}");
    let near = check(&p, "check-instability");
    assert!((near.margin.unwrap() - (160.0 - 150.35) / 160.0).abs() < 0.006, "{near:?}");
    assert_eq!(near.verdict, Verdict::Attention);
}

#[test]
fn mistakes_are_named_at_their_place() {
    for (speed, operation, code) in [
        ("speed = 300.0", "speed = { from = 100.0, to = 200.0 }", "operation.speed"),
        ("", "speed = { from = -100.0, to = 200.0 }", "value.bounds"),
        ("", "speed = { from = 200.0, to = 100.0 }", "operation.speed"),
        ("", "run_up_time = 3.0", "operation.speed"),
        ("", "speed = 100.0\nresonance_margin = \"150 %\"", "value.bounds"),
        ("", "speed = 100.0\n[report]\nunits = \"rpm, furlong\"", "report.units"),
        ("", "speed = 100.0\n[report]\nlanguage = \"de\"", "value.choice"),
    ] {
        let text = jeffcott(speed, 4.0, &format!("[operation]\n{operation}\n"));
        let Err(wrong) = read(&text) else { panic!("{operation} was read") };
        let codes: Vec<&str> = wrong.0.iter().map(|d| d.code).collect();
        assert_eq!(codes, [code], "{operation}: {wrong}");
        assert!(wrong.0[0].span.is_some(), "{operation}");
    }
    let loaded = load(&jeffcott("", 4.0, "[report]\nlanguage = \"kk\"\nunits = \"rpm, mm\"\n"));
    let own = presentation::among(&loaded.system.machine.extras);
    assert_eq!((own.language.as_deref(), own.units.as_deref()), (Some("kk"), Some("rpm, mm")));
}
