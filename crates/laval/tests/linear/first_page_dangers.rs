//! What the first page must not pass over: a machine that buckles, a jump beside the operating speed, a small critical speed; against closed forms.

use super::overview::{check, jeffcott, number, page};
use crate::common::files::load;
use laval::outcome::{Arg, Message, Outcome, Overview, Verdict};
use laval::report::{Report, Style, Terminal, summary};
use laval::study::{Context, overview};
use std::f64::consts::PI;

fn keys(list: &[Message]) -> Vec<&str> {
    list.iter().map(|m| m.key.as_str()).collect()
}

/// A disc on a spring of negative stiffness in x: m s^2 + c s - k = 0 has a positive root.
#[test]
fn a_machine_on_a_negative_spring_buckles() {
    let (m, c, k) = (4.0, 2.0, 1e4f64);
    let text = format!(
        "[machine]\nname = \"rotor\"\nspeed = 300.0\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = {m:?}\neccentricity = 2e-5\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"magnet\"\nbetween = [\"disc\", \"ground\"]\nkxx = {:?}\nkyy = 4e4\ncxx = {c:?}\ncyy = {c:?}\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"spring\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1e3\n",
        -k
    );
    let p = page(&text);
    let growth = (-c + (c * c + 4.0 * m * (k - 1e3)).sqrt()) / (2.0 * m);
    assert_eq!((p.verdict, keys(&p.headline)), (Verdict::Failed, vec!["headline-buckled", "headline-unstable"]));
    assert!((number(&p.headline[0], "time") * growth - 1.0).abs() < 1e-6, "{:?}", p.headline);
    let stability = check(&p, "check-stability");
    assert_eq!((stability.verdict, stability.result.arg_named("motion")), (Verdict::Failed, Some(&Arg::word("divergence"))));
    assert_eq!((check(&p, "check-run-up").verdict, check(&p, "check-resonance").verdict), (Verdict::Failed, Verdict::NotComputed));
    // what to change is the part that pushes away, not the one that holds
    let next = p.next.iter().find(|m| m.key == "next-buckled").expect("advice");
    assert_eq!(next.arg_named("parts"), Some(&Arg::names(["magnet"])));
    assert_eq!(keys(&p.next).iter().filter(|k| k.starts_with("next-stab") || **k == "next-unstable").count(), 0);
    // the mode that grows has a card
    assert!(p.modes.iter().any(|m| m.frequency == 0.0 && m.grows));
    // without an operating speed as well
    let still = page(&text.replace("speed = 300.0\n", ""));
    assert_eq!((still.verdict, keys(&still.headline)), (Verdict::Failed, vec!["headline-buckled", "headline-no-speed"]));
}

/// A whirl that grows is no static instability.
#[test]
fn a_whirl_is_no_buckling() {
    let inner = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 2.0\naxes = \"rotating\"\n";
    let p = page(&jeffcott("speed = 230.0", 2.0, inner));
    assert_eq!(keys(&p.headline), ["headline-unstable"]);
    assert_eq!(check(&p, "check-stability").result.arg_named("motion"), Some(&Arg::word("whirl")));
}

/// A pinned shaft buckles beyond the load of Euler, pi^2 E I/L^2.
#[test]
fn a_shaft_buckles_beyond_the_load_of_euler() {
    let (length, diameter) = (1.0, 0.02f64);
    let euler = PI * PI * 2.1e11 * (PI * diameter.powi(4) / 64.0) / (length * length);
    let of = |load: f64, elements: usize| {
        page(&format!(
            "[machine]\nname = \"rotor\"\nspeed = 100.0\n\
             [[part]]\nkind = \"shaft\"\nname = \"shaft\"\nmaterial = \"steel\"\naxial_force = {:?}\nelements = {elements}\nsection = [{{ length = {length:?}, outer_diameter = {diameter:?} }}]\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"left\"\nbetween = [\"shaft\", \"ground\"]\nstiffness = 1e9\ndamping = 1e3\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"right\"\nbetween = [{{ body = \"shaft\", at = {length:?} }}, \"ground\"]\nstiffness = 1e9\ndamping = 1e3\n",
            -load * euler
        ))
    };
    assert_ne!(of(0.97, 6).headline[0].key, "headline-buckled");
    let p = of(1.03, 6);
    assert_eq!((p.verdict, p.headline[0].key.as_str()), (Verdict::Failed, "headline-buckled"));
    let next = p.next.iter().find(|m| m.key == "next-buckled").expect("advice");
    assert_eq!(next.arg_named("parts"), Some(&Arg::names(["shaft"])));
    // with more elements than all modes are computed of
    let large = of(1.03, 40);
    assert_eq!((large.verdict, large.headline[0].key.as_str()), (Verdict::Failed, "headline-buckled"));
    let (a, b) = (number(&p.headline[0], "time"), number(&large.headline[0], "time"));
    assert!((a / b - 1.0).abs() < 1e-2, "{a} {b}");
    assert_ne!(of(0.97, 40).headline[0].key, "headline-buckled");
}

/// A bearing that hardens jumps at the folds of (k + k3 A^2) A - m w^2 A = m e w^2: within the required margin of one the page is no longer green, on either side of it.
#[test]
fn a_jump_within_the_margin_of_the_operating_speed_is_not_green() {
    let of = |speed: f64, more: &str| {
        page(&format!(
            "[machine]\nname = \"rotor\"\nspeed = {speed:?}\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4\neccentricity = 2e-5\n\
             [[part]]\nkind = \"bearing_cubic\"\nname = \"spring\"\nbetween = [\"disc\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 4e4\ncubic_stiffness = 4e10\n\
             [[part]]\nkind = \"damper\"\nbetween = [\"disc\", \"ground\"]\ndamping = 4\n{more}\
             [[study]]\nkind = \"nonlinear_response\"\nspeed = {{ from = 40.0, to = 300.0 }}\n"
        ))
    };
    let jumps = of(150.0, "").over_speed.expect("a range").jumps;
    // folds: d/dA of the balance vanishes, with damping c w A beside it
    let (m, k, k3, e, c) = (4.0f64, 4e4, 4e10, 2e-5, 4.0);
    let force = |a: f64, w: f64| (((k + k3 * a * a - m * w * w) * a).powi(2) + (c * w * a).powi(2)).sqrt() - m * e * w * w;
    for w in &jumps {
        let roots = |w: f64| (1..400_000).filter(|n| force(1e-8 * *n as f64, w) * force(1e-8 * (n + 1) as f64, w) < 0.0).count();
        assert_eq!(roots(0.999 * w).abs_diff(roots(1.001 * w)), 2, "{w}");
    }
    let highest = jumps.iter().copied().fold(0.0, f64::max);
    let lowest = jumps.iter().copied().fold(f64::INFINITY, f64::min);
    for (place, speed, side) in [(lowest, lowest / 1.024, "above"), (highest, highest * 1.024, "below")] {
        let p = of(speed, "");
        let jump = check(&p, "check-jump");
        let distance = (place - speed).abs() / speed;
        assert!((jump.margin.unwrap() - distance).abs() < 1e-9 && jump.verdict == Verdict::Attention, "{side}: {jump:?}");
        let said = p.headline.iter().find(|m| m.key == "headline-jump").unwrap_or_else(|| panic!("{side}: {:?}", p.headline));
        assert_eq!((p.verdict, said.arg_named("side")), (Verdict::Attention, Some(&Arg::word(side))));
        assert!(p.next.iter().any(|m| m.key == "next-jump"));
        // a distance that the file requires is not met
        let required = of(speed, "[operation]\nresonance_margin = \"5 %\"\n");
        assert_eq!((check(&required, "check-jump").verdict, required.verdict), (Verdict::Failed, Verdict::Failed));
    }
    let far = of(lowest / 1.3, "");
    assert_eq!(check(&far, "check-jump").verdict, Verdict::Passed);
}

/// Two discs apart: beside the sharp resonance of one at sqrt(k/m) = 100 rad/s that of the other at 300 rad/s is small, and is not left out.
#[test]
fn a_small_resonance_above_the_operating_speed_is_named() {
    let disc = |name: &str, k: f64, c: f64, e: f64| {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"{name}\"\nmass = 4\neccentricity = {e:?}\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"{name} spring\"\nbetween = [\"{name}\", \"ground\"]\nstiffness = {k:?}\ndamping = {c:?}\n"
        )
    };
    let p =
        page(&format!("[machine]\nname = \"rotor\"\nspeed = 250.0\n{}{}", disc("large", 4e4, 0.1, 2e-5), disc("small", 36e4, 20.0, 1e-7)));
    let over = p.over_speed.as_ref().expect("a range");
    let at: Vec<f64> = over.resonances.iter().map(|r| r.speed).collect();
    assert!(at.len() == 2 && (at[0] - 100.0).abs() < 0.01 && (at[1] - 300.0).abs() < 0.1, "{at:?}");
    let above = p.remarks.iter().find(|r| r.0.key == "remark-above").expect("a remark");
    assert!(above.1.iter().any(|m| m.key == "remark-resonance" && (number(m, "speed") - 300.0).abs() < 0.1), "{above:?}");
}

/// Five resonances above the operating speed: three lines name all of them.
#[test]
fn no_resonance_is_left_out_of_the_remarks() {
    let disc = |n: usize| {
        let k = 4.0 * (100.0 * n as f64).powi(2);
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"disc {n}\"\nmass = 4\neccentricity = 2e-5\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"spring {n}\"\nbetween = [\"disc {n}\", \"ground\"]\nstiffness = {k:?}\ndamping = 10.0\n"
        )
    };
    let all: String = (1..=5).map(disc).collect();
    let p = page(&format!(
        "[machine]\nname = \"rotor\"\nspeed = 60.0\n{all}[[study]]\nkind = \"campbell\"\nspeed = {{ from = 1.0, to = 700.0 }}\n"
    ));
    let above = p.remarks.iter().find(|r| r.0.key == "remark-above").expect("a remark");
    assert_eq!(keys(&above.1), ["remark-resonance", "remark-resonance", "remark-resonances"]);
    let Some(Arg::List(rest)) = above.1[2].arg_named("speeds") else { panic!("{above:?}") };
    assert_eq!(rest.len(), 3);
}

/// A resonance at the edge of an unstable range stands in the strip.
#[test]
fn the_strip_shows_a_resonance_in_an_unstable_range() {
    let inner = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 2.0\naxes = \"rotating\"\n";
    let p = page(&jeffcott("speed = 230.0", 0.001, inner));
    let report = Report { overview: Some(p), style: Style::default(), ..Report::default() };
    let out = summary(&report, Terminal::default());
    let strip = out.lines().find(|l| l.contains('█')).expect("a strip");
    assert!(strip.contains('∧'), "{out}");
}

/// A peak is that of the study of the response, whichever study found the modes.
#[test]
fn a_resonance_is_attributed_to_the_study_of_the_response() {
    let of = |studies: &[(&str, &str)]| -> Overview {
        let block = |(kind, name): &(&str, &str)| {
            format!("[[study]]\nkind = \"{kind}\"\nname = \"{name}\"\nspeed = {{ from = 20.0, to = 250.0 }}\n")
        };
        let loaded = load(&jeffcott("speed = 150.0", 2.0, &studies.iter().map(block).collect::<String>()));
        let run = |s: &laval::file::NamedStudy| {
            s.study.run(&loaded.system, &Context { name: &s.name, ..Context::quiet("") }).unwrap_or_else(|d| panic!("{d:?}"))
        };
        let outcomes: Vec<Outcome> = loaded.studies.iter().map(run).collect();
        let speeds: Vec<_> = loaded.studies.iter().flat_map(|s| s.study.speeds(&loaded.system)).collect();
        overview(&loaded.system, &speeds, &outcomes, &Context { work_limit: 0, ..Context::quiet("summary") })
    };
    let from = |p: &Overview| check(p, "check-resonance").detail.as_ref().and_then(|d| d.arg_named("study")).cloned();
    assert_eq!(from(&of(&[("campbell", "modes over the speed"), ("forced_response", "vibration")])), Some(Arg::name("vibration")));
    assert_eq!(from(&of(&[("campbell", "modes over the speed")])), Some(Arg::name("modes over the speed")));
    assert_eq!(from(&of(&[("forced_response", "vibration")])), Some(Arg::name("vibration")));
    assert_eq!(from(&of(&[("critical_speeds", "speeds")])), Some(Arg::name("speeds")));
}

/// A shaft of so many elements that the page does not search a range of speeds, with rotating damping: unstable from about 8850 rpm on.
fn long_shaft(operation: &str, studies: &str) -> String {
    let bearing = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\nkxx = 5e7\nkyy = 7e7\ncxx = 5e3\ncyy = 5e3\n"
        )
    };
    format!(
        "[machine]\nname = \"pump\"\nspeed = \"3000 rpm\"\naxis = \"horizontal\"\n\
         [[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 120\nrotating_damping = 1e-4\nsection = [{{ length = 0.6, outer_diameter = 0.05 }}]\n\
         [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.3 }}\nmass = 15.0\npolar_inertia = 0.12\ndiametral_inertia = 0.08\nunbalance = \"100 g mm\"\n\
         {}{}{operation}{studies}",
        bearing("left", 0.0),
        bearing("right", 0.6)
    )
}

/// A range of operating speeds is stable where it was examined, and nowhere else; a study of modes at one of its speeds that finds an instability counts.
#[test]
fn a_range_is_stable_only_where_it_was_examined() {
    let range = |to: u32| format!("[operation]\nspeed = {{ from = \"3000 rpm\", to = \"{to} rpm\" }}\n");
    let modes = |speed: u32| format!("[[study]]\nkind = \"modes\"\nname = \"at {speed}\"\nspeed = \"{speed} rpm\"\n");
    let map = "[[study]]\nkind = \"stability_map\"\nspeed = { from = \"1000 rpm\", to = \"12000 rpm\", points = 8 }\n";
    let of = |to: u32, studies: &str| {
        let p = page(&long_shaft(&range(to), studies));
        (check(&p, "check-stability").verdict, p.verdict)
    };
    // one speed of the range says nothing of the others
    let (stability, whole) = of(11_000, &modes(3000));
    assert_eq!(stability, Verdict::NotComputed);
    assert_ne!(whole, Verdict::Passed);
    for studies in [modes(11_000), modes(3000) + &modes(11_000), map.to_string()] {
        assert_eq!(of(11_000, &studies), (Verdict::Failed, Verdict::Failed), "{studies}");
    }
    // beyond the range an instability is none of it
    assert_eq!(of(7000, &(modes(11_000) + map)).0, Verdict::Passed);
    assert_eq!(of(7000, &modes(11_000)).0, Verdict::NotComputed);
}

/// A search for critical speeds that ended before the operating speeds is no search: the response of a study that covers them has its resonance among them.
#[test]
fn a_search_that_ended_early_finds_nothing_out() {
    let response = "[[study]]\nkind = \"forced_response\"\nspeed = { from = \"1000 rpm\", to = \"15000 rpm\", points = 20 }\n";
    let map = "[[study]]\nkind = \"stability_map\"\nspeed = { from = \"1000 rpm\", to = \"15000 rpm\", points = 8 }\n";
    for (to, studies) in [(11_000, map.to_string() + response), (8500, response.to_string())] {
        let p = page(&long_shaft(&format!("[operation]\nspeed = {{ from = \"3000 rpm\", to = \"{to} rpm\" }}\n"), &studies));
        let resonance = check(&p, "check-resonance");
        assert_eq!((resonance.margin, resonance.verdict), (Some(0.0), Verdict::Attention), "{to}: {resonance:?}");
        assert_ne!(p.verdict, Verdict::Passed);
    }
}

/// Torsion without damping leaves the whirl stable: its rate is that of the machine without torsion. A whirl without damping is neither stable nor unstable.
#[test]
fn undamped_torsion_is_no_doubt_about_the_whirl() {
    let text = |torsional: bool, damping: f64| {
        let bearing = |name: &str, at: f64| {
            format!(
                "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\nkxx = 5e7\nkyy = 7e7\ncxx = {damping:?}\ncyy = {damping:?}\n"
            )
        };
        format!(
            "[machine]\nname = \"pump\"\nspeed = \"3000 rpm\"\n\
             [[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 8\ntorsional = {torsional}\nsection = [{{ length = 0.6, outer_diameter = 0.05 }}]\n\
             [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.3 }}\nmass = 15.0\npolar_inertia = 0.12\ndiametral_inertia = 0.08\n{}{}",
            bearing("left", 0.0),
            bearing("right", 0.6)
        )
    };
    let [plain, twisting] = [false, true].map(|t| page(&text(t, 5e3)));
    let decay = |p: &Overview| number(&check(p, "check-stability").result, "decay");
    assert_eq!(check(&twisting, "check-stability").result.key, "stability-across");
    assert_eq!((twisting.verdict, check(&twisting, "check-stability").verdict), (plain.verdict, Verdict::Passed));
    assert!((decay(&twisting) / decay(&plain) - 1.0).abs() < 1e-6, "{} {}", decay(&twisting), decay(&plain));
    let still = page(&text(true, 0.0));
    assert_eq!((check(&still, "check-stability").verdict, still.verdict), (Verdict::Attention, Verdict::Attention));
}

/// However far a resonance is below the operating speed, a run-up crosses it: sqrt(k/m), and where another order excites a part of that.
#[test]
fn a_resonance_far_below_the_operating_speed_is_crossed() {
    let machine = |speed: f64, more: &str| {
        format!(
            "[machine]\nspeed = {speed:?}\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 1\neccentricity = 5e-6\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"mount\"\nbetween = [\"rotor\", \"ground\"]\nstiffness = 158\ndamping = 0.05\n\
             {more}"
        )
    };
    let critical = 158.0f64.sqrt();
    for speed in [1e3, 2e4, 1e6] {
        let p = page(&machine(speed, ""));
        let found = &p.over_speed.as_ref().unwrap().resonances;
        assert!(found.len() == 1 && (found[0].speed - critical).abs() < 1e-3 * critical, "{speed}: {found:?}");
        let run_up = check(&p, "check-run-up");
        assert_eq!((run_up.result.key.as_str(), run_up.verdict), ("run-up-resonances", Verdict::NotComputed), "{speed}");
    }
    // a page that begins below its resonances anyway begins where it did
    let usual = page(&machine(1e3, "")).over_speed.unwrap().range;
    assert!((usual.0 - 1.5).abs() < 1e-9, "{usual:?}");
    // the second order meets the mode at half of its speed, which alone lies below 9 rad/s
    let p = page(&machine(6e3, "[limits]\norders = [1, 2]\nclearance = 0.2\n"));
    let found: Vec<f64> = p.over_speed.as_ref().unwrap().resonances.iter().map(|r| r.speed).collect();
    assert!(found.iter().any(|w| (w - 0.5 * critical).abs() < 1e-3 * critical), "{found:?}");
}

/// A table of a bearing that pushes sideways at low speeds alone, k_c > c sqrt(k/m): the run-up crosses what is unstable there.
#[test]
fn an_unstable_range_far_below_the_operating_speed_is_crossed() {
    let text = |speed: f64| {
        format!(
            "[machine]\n[[part]]\nkind = \"disc\"\nname = \"a\"\nmass = 1\neccentricity = 1e-5\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"s\"\nbetween = [\"a\", \"ground\"]\n\
             table = {{ speed = [0, 35, 55, 75, 1e6], kxx = [1e4, 1e4, 1e4, 1e4, 1e4], kyy = [1e4, 1e4, 1e4, 1e4, 1e4],\
             kxy = [0, 0, 3000, 0, 0], kyx = [0, 0, -3000, 0, 0], cxx = [1, 1, 1, 1, 1], cyy = [1, 1, 1, 1, 1] }}\n\
             [operation]\nspeed = {speed:?}\n"
        )
    };
    let range = |speed: f64| {
        let p = page(&text(speed));
        let all = &p.over_speed.as_ref().unwrap().unstable;
        assert!(all.len() == 1, "{speed}: {all:?}");
        (all[0].from, all[0].to)
    };
    let near = range(300.0);
    assert!(near.0 > 35.0 && near.1 < 75.0);
    for speed in [3e4, 1e5] {
        let far = range(speed);
        assert!((far.0 - near.0).abs() < 1e-3 * near.0 && (far.1 - near.1).abs() < 1e-3 * near.1, "{speed}: {far:?} {near:?}");
    }
}

/// A rotor on another spin, whose unbalance no study took, is not shown as one that does not move; a speed at which its modes meet its load counts once.
#[test]
fn a_body_of_another_spin_is_not_at_rest() {
    let p = page(
        "[machine]\n[[part]]\nkind = \"speed_ratio\"\nname = \"in\"\nratio = 0.5\n\
         [[part]]\nkind = \"disc\"\nname = \"a\"\nmass = 1\neccentricity = 1e-6\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"sa\"\nbetween = [\"a\", \"ground\"]\nstiffness = 1e6\ndamping = 20\n\
         [[part]]\nkind = \"disc\"\nname = \"b\"\nspin = \"in\"\nmass = 1\neccentricity = 1e-5\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"sb\"\nbetween = [\"b\", \"ground\"]\nstiffness = 1e4\ndamping = 2\n\
         [operation]\nspeed = 200\n",
    );
    let vibration = check(&p, "check-vibration");
    assert_eq!(vibration.verdict, Verdict::NotComputed);
    let Some(Arg::List(shown)) = vibration.result.arg_named("sizes") else { panic!("{vibration:?}") };
    assert_eq!(shown.len(), 1, "{shown:?}");
    let found: Vec<f64> = p.over_speed.as_ref().unwrap().resonances.iter().map(|r| r.speed).collect();
    assert_eq!(found.iter().filter(|w| (*w - 200.0).abs() < 0.1).count(), 1, "{found:?}");
}
