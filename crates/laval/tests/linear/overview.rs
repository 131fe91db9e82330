//! The first page against closed forms: a disc on springs has its critical speed at sqrt(k/m) and moves by e r^2/|1 - r^2| (docs/theory/linear-vibration.md).

use crate::common::files::load;
use laval::outcome::{Arg, Check, Message, Overview, Verdict};
use laval::report::{Report, Style, Terminal, Units, summary};
use laval::study::{Context, overview};

pub const MASS: f64 = 4.0;
pub const STIFFNESS: f64 = 4e4;
pub const ECCENTRICITY: f64 = 2e-5;

/// A disc with critical speed 100 rad/s, at this speed, with this damping, and more blocks.
pub fn jeffcott(speed: &str, damping: f64, more: &str) -> String {
    format!(
        "[machine]\nname = \"rotor\"\n{speed}\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = {MASS}\neccentricity = {ECCENTRICITY}\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"spring\"\nbetween = [\"disc\", \"ground\"]\nstiffness = {STIFFNESS}\ndamping = {damping}\n{more}"
    )
}

pub fn page(text: &str) -> Overview {
    let loaded = load(text);
    let outcomes: Vec<_> =
        loaded.studies.iter().map(|s| s.study.run(&loaded.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{d:?}"))).collect();
    let speeds: Vec<_> = loaded.studies.iter().flat_map(|s| s.study.speeds(&loaded.system)).collect();
    overview(&loaded.system, &speeds, &outcomes, &Context::quiet("summary"))
}

pub fn check<'p>(page: &'p Overview, name: &str) -> &'p Check {
    page.checks.iter().find(|c| c.what.key == name).unwrap_or_else(|| panic!("no {name} in {:?}", page.checks))
}

pub fn number(m: &Message, name: &str) -> f64 {
    match m.args.iter().find(|a| a.0 == name).map(|a| &a.1) {
        Some(Arg::Quantity(q)) => q.value,
        Some(Arg::List(all)) => match &all[0] {
            Arg::Phrase(item) => number(item, "value"),
            Arg::Quantity(q) => q.value,
            other => panic!("{other:?}"),
        },
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn below_the_critical_speed_the_margin_and_the_amplitude_are_those_of_the_closed_form() {
    let (speed, damping) = (95.0, 0.4);
    let p = page(&jeffcott("speed = 95.0", damping, ""));
    assert_eq!(check(&p, "check-stability").verdict, Verdict::Passed);
    // both modes decay at c/2m
    assert!((number(&check(&p, "check-stability").result, "decay") - damping / (2.0 * MASS)).abs() < 1e-9);
    let r = speed / (STIFFNESS / MASS).sqrt();
    let zeta = damping / (2.0 * (STIFFNESS * MASS).sqrt());
    let amplitude = ECCENTRICITY * r * r / ((1.0 - r * r).powi(2) + (2.0 * zeta * r).powi(2)).sqrt();
    assert!((number(&check(&p, "check-vibration").result, "sizes") / amplitude - 1.0).abs() < 1e-9);
    let near = check(&p, "check-resonance");
    // the peak lies at 1/sqrt(1 - 2 zeta^2) of the critical speed
    let peak = (STIFFNESS / MASS).sqrt() / (1.0 - 2.0 * zeta * zeta).sqrt();
    assert_eq!(near.verdict, Verdict::Attention);
    assert!((near.margin.unwrap() - (peak - speed) / speed).abs() < 1e-6, "{near:?}");
    assert_eq!((p.verdict, p.headline[1].key.as_str()), (Verdict::Attention, "headline-resonance"));
    assert_eq!(check(&p, "check-run-up").verdict, Verdict::Passed);
}

#[test]
fn above_the_critical_speed_a_run_up_crosses_it() {
    let p = page(&jeffcott("speed = 200.0", 4.0, ""));
    assert_eq!(p.verdict, Verdict::Passed);
    let run = check(&p, "check-run-up");
    assert!(run.verdict == Verdict::NotComputed && run.result.key == "run-up-resonances");
    assert!((number(&run.result, "resonances") - 100.0).abs() < 0.1);
    assert!(p.next.iter().any(|m| m.key == "next-run-up"));
}

#[test]
fn limits_are_kept_or_broken() {
    let of = |limits: &str| page(&jeffcott("speed = 200.0", 4.0, &format!("[limits]\n{limits}\n")));
    // e r^2/(r^2 - 1) at r = 2 is 26.7 um, and moves at 5.3 mm/s
    for (limits, verdict) in [
        ("displacement = 2.6e-5", Verdict::Failed),
        ("displacement = 2.7e-5", Verdict::Passed),
        ("velocity = 5.2e-3", Verdict::Failed),
        ("velocity = 5.4e-3", Verdict::Passed),
        ("displacement = 2.7e-5\nvelocity = 5.2e-3", Verdict::Failed),
    ] {
        let p = of(limits);
        let row = if limits.contains("velocity") { "check-velocity" } else { "check-vibration" };
        assert_eq!(check(&p, row).verdict, verdict, "{limits}");
        assert_eq!(p.verdict, verdict, "{limits}");
    }
    // decay is c/2m = 0.5 1/s
    assert_eq!(check(&of("growth_margin = 0.49"), "check-stability").verdict, Verdict::Passed);
    let slow = of("growth_margin = 0.51");
    assert_eq!((check(&slow, "check-stability").verdict, slow.headline[0].key.as_str()), (Verdict::Failed, "headline-stable"));
    assert_eq!((of("speed = 150.0").verdict, of("speed = 250.0").verdict), (Verdict::Failed, Verdict::Passed));
    // what is not assessed is named
    assert_eq!(check(&of("self_centring = 0.5"), "check-others").verdict, Verdict::NotComputed);
    // the resonance is 50 % away
    assert_eq!(check(&of("clearance = 0.49"), "check-resonance").verdict, Verdict::Passed);
    assert_eq!(check(&of("clearance = 0.51"), "check-resonance").verdict, Verdict::Failed);
    // at twice the speed the order 2 meets the mode where the speed is half the frequency
    assert!(check(&of("clearance = 0.1\norders = [1, 4]"), "check-resonance").margin.unwrap() < 0.51);
    // force of the spring and damper: |k + i c w| times the amplitude, 1.07 N
    assert_eq!(check(&of("force = 1.06"), "check-forces").verdict, Verdict::Failed);
    assert_eq!(check(&of("force = 1.08"), "check-forces").verdict, Verdict::Passed);
}

#[test]
fn an_undamped_machine_is_neither_stable_nor_unstable() {
    let p = page(&jeffcott("speed = 200.0", 0.0, ""));
    assert_eq!(check(&p, "check-stability").verdict, Verdict::Attention);
    assert_ne!(p.verdict, Verdict::Passed);
    let on = page(&jeffcott("speed = 100.0", 0.0, ""));
    assert_ne!(on.verdict, Verdict::Passed, "{:?}", on.headline);
    assert_eq!(check(&on, "check-resonance").margin.map(|m| m < 1e-6), Some(true), "{:?}", on.checks);
}

/// The peak of 0.4 of critical damping, at 121.3 rad/s, is 7 % from the operating speed. Its amplification factor is below 2.5: with the standard no margin is required, without
/// it one is.
#[test]
fn a_critically_damped_peak_needs_no_margin() {
    let damping = 0.4 * 2.0 * (STIFFNESS * MASS).sqrt();
    let of = |more: &str| {
        let study = "[[study]]\nkind = \"forced_response\"\nspeed = { from = 1, to = 300 }\n";
        page(&jeffcott("speed = 130.0", damping, &format!("{study}{more}")))
    };
    let plain = of("");
    assert_eq!(check(&plain, "check-resonance").verdict, Verdict::Attention);
    let assessed = of("standard = \"api_684\"\n");
    let found = check(&assessed, "check-resonance");
    assert_eq!((found.verdict, found.result.key.as_str()), (Verdict::Passed, "distance-no-other-resonance"), "{found:?}");
    assert_eq!(found.detail.as_ref().map(|d| d.key.as_str()), Some("distance-critically-damped"));
    assert!(assessed.headline.iter().all(|m| m.key != "headline-resonance"), "{:?}", assessed.headline);
    // a lightly damped one keeps its margin
    let light =
        jeffcott("speed = 105.0", 40.0, "[[study]]\nkind = \"forced_response\"\nspeed = { from = 1, to = 300 }\nstandard = \"api_684\"\n");
    assert_eq!(check(&page(&light), "check-resonance").verdict, Verdict::Attention);
}

/// Rotating damping c_i above the critical speed: unstable above w (1 + c_a/c_i).
#[test]
fn the_limit_of_rotating_damping_is_crossed_below_the_operating_speed() {
    let more = "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\ndamping = 2.0\naxes = \"rotating\"\n";
    let text = |speed: f64| jeffcott(&format!("speed = {speed:?}"), 2.0, more);
    let p = page(&text(190.0));
    assert_eq!(check(&p, "check-stability").verdict, Verdict::Passed, "{:?}", p.checks);
    let near = check(&p, "check-instability");
    assert!((near.margin.unwrap() - 10.0 / 190.0).abs() < 1e-3, "{near:?}");
    let p = page(&text(210.0));
    assert_eq!((p.verdict, p.headline[0].key.as_str()), (Verdict::Failed, "headline-unstable"));
    assert_eq!(check(&p, "check-instability").verdict, Verdict::Failed);
    assert_eq!(check(&p, "check-vibration").result.key, "vibration-unstable");
}

#[test]
fn without_an_operating_speed_nothing_is_assessed() {
    let p = page(&jeffcott("", 4.0, ""));
    assert_eq!((p.verdict, p.checks.len(), p.headline[0].key.as_str()), (Verdict::NotComputed, 0, "headline-no-speed"));
}

/// The way up begins at rest: a critical speed far below the operating speed is crossed.
#[test]
fn nothing_below_the_operating_speed_is_overlooked() {
    let p = page(&jeffcott("speed = 4000.0", 4.0, "[[study]]\nkind = \"modes\"\n"));
    let run = check(&p, "check-run-up");
    assert_eq!((run.verdict, run.result.key.as_str()), (Verdict::NotComputed, "run-up-resonances"), "{run:?}");
    assert!((number(&run.result, "resonances") - 100.0).abs() < 0.1);
}

/// Only a run-up that passes what lies on the way and reaches the operating speed answers the check.
#[test]
fn a_run_up_counts_that_reaches_the_operating_speed() {
    let of = |from: f64, to: f64| {
        let study = format!("[[study]]\nkind = \"run_up\"\nfrom = {from:?}\nto = {to:?}\nduration = 4.0\n");
        page(&jeffcott("speed = 200.0", 40.0, &format!("[limits]\npassage_displacement = 1e-3\n{study}")))
    };
    assert_eq!(check(&of(0.0, 200.0), "check-run-up").verdict, Verdict::Passed);
    assert_eq!(check(&of(0.0, 50.0), "check-run-up").verdict, Verdict::NotComputed);
    assert_eq!(check(&of(150.0, 200.0), "check-run-up").verdict, Verdict::NotComputed);
}

/// A bearing that hardens: between the folds two responses are stable, and the larger one counts.
#[test]
fn between_the_folds_the_larger_response_counts() {
    let text = |speed: f64| {
        format!(
            "[machine]\nname = \"rotor\"\nspeed = {speed:?}\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4\neccentricity = 2e-5\n\
             [[part]]\nkind = \"bearing_cubic\"\nname = \"spring\"\nbetween = [\"disc\", \"ground\"]\nlaw = \"isotropic\"\nstiffness = 4e4\ncubic_stiffness = 4e10\n\
             [[part]]\nkind = \"damper\"\nbetween = [\"disc\", \"ground\"]\ndamping = 4\n[limits]\nforce = {{ spring = 1e6 }}\n\
             [[study]]\nkind = \"nonlinear_response\"\nspeed = {{ from = 40.0, to = 300.0 }}\n"
        )
    };
    let p = page(&text(150.0));
    assert_eq!((check(&p, "check-stability").result.key.as_str(), p.verdict), ("stability-several", Verdict::Attention), "{:?}", p.checks);
    // w^2 m (A + e) = (k + k3 A^2) A on the branch that runs into the fold
    let (m, k, k3, e, w) = (4.0, 4e4, 4e10, 2e-5, 150.0f64);
    let a = number(&check(&p, "check-vibration").result, "sizes");
    let balance = |a: f64| (k + k3 * a * a - m * w * w) * a - m * e * w * w;
    assert!(a > 1e-3 && balance(a * 0.98) < 0.0 && balance(a * 1.02) > 0.0, "{a}");
    assert!((number(&check(&p, "check-forces").result, "sizes") / ((k + k3 * a * a) * a) - 1.0).abs() < 0.05);
    // without the study the force of the bearing is that by its tangent, which decides while its law is not far away
    for (eccentricity, verdict) in [("2e-5", Verdict::Passed), ("8e-4", Verdict::Attention)] {
        let linear = page(&text(60.0).split("[[study]]").next().unwrap().replace("2e-5", eccentricity));
        assert_eq!(check(&linear, "check-forces").verdict, verdict);
    }
}

/// Coefficients beyond a table that refuses them answer nothing.
#[test]
fn beyond_a_table_nothing_is_stable() {
    let text = |speed: f64| {
        format!(
            "[machine]\nname = \"rotor\"\nspeed = {speed:?}\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 4\neccentricity = 2e-5\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"seal\"\nbetween = [\"disc\", \"ground\"]\n\
             table = {{ speed = [10, 150], kxx = [4e4, 4e4], kyy = [4e4, 4e4], cxx = [4, 4], cyy = [4, 4] }}\n"
        )
    };
    let p = page(&text(200.0));
    assert!(p.checks.iter().all(|c| c.verdict != Verdict::Passed), "{:?}", p.checks);
    assert_eq!(check(&page(&text(140.0)), "check-stability").verdict, Verdict::Passed);
}

/// The summary has the units of the file, and no sentence lacks an argument.
#[test]
fn the_summary_is_in_the_units_of_the_file() {
    let text = jeffcott("speed = \"1910 rpm\"", 4.0, "[limits]\ndisplacement = \"1 mm\"\n");
    let units = Units::new(laval::file::written_units(&text));
    let report =
        Report { machine: "rotor".into(), overview: Some(page(&text)), style: Style { units, ..Style::default() }, ..Report::default() };
    let out = summary(&report, Terminal::default());
    assert!(out.contains("1910 rpm") && out.contains("955") && !out.contains("rad/s") && !out.contains("{$"), "{out}");
    assert!(out.lines().all(|l| l.chars().count() <= 80), "{out}");
}

/// Results of several lines are whole in the terminal where its lines suffice.
#[test]
fn results_are_not_cut_where_there_is_room() {
    let free = "[machine]\nname = \"free rotor\"\nspeed = 314.0\naxis = \"horizontal\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\n\
                section = [{ length = 1.0, outer_diameter = 0.04 }]\n";
    let report = Report { overview: Some(page(free)), style: Style { units: Units::everyday(), ..Style::default() }, ..Report::default() };
    let out = summary(&report, Terminal::default());
    assert!(out.contains("by any stiffness") && !out.contains('…'), "{out}");
    assert!(out.lines().count() <= 23, "{out}");
}

/// Resonances, jumps and ranges without a stable response stand in the strip of the terminal and in the figure of the page.
#[test]
fn what_happens_over_the_speed_is_marked() {
    let mut p = page(&jeffcott("speed = 200.0", 4.0, ""));
    let over = p.over_speed.as_mut().expect("a figure");
    assert!(over.unstable_response.is_empty() && over.resonances.len() == 1);
    over.jumps = vec![130.0];
    over.unstable_response = vec![(60.0, 80.0)];
    let report = Report { overview: Some(p), style: Style { units: Units::everyday(), ..Style::default() }, ..Report::default() };
    let out = summary(&report, Terminal::default());
    for sign in ["∧ resonance", "↕ jump", "▒ unstable response", "┃ operating speed"] {
        assert!(out.contains(sign), "{sign}: {out}");
    }
    let html = laval::report::html(&report).unwrap();
    let figure = html.split("id=\"over\"").nth(1).unwrap().split("</figure>").next().unwrap();
    for words in [">resonance<", ">jump<", ">unstable response<", ">operating speed<"] {
        assert!(figure.matches(words).count() >= 2, "{words} in both widths");
    }
}

/// At a bearing of stiffness and damping both signs stand side by side; the machine of a horizontal axis lies.
#[test]
fn the_machine_is_drawn_as_it_stands() {
    use laval::outcome::{Block, Joint};
    let upright = page(&jeffcott("speed = 200.0", 4.0, ""));
    let joint = upright.machine.iter().find_map(|b| match b {
        Block::Link { joint, .. } => Some(*joint),
        _ => None,
    });
    assert_eq!(joint, Some(Joint { elastic: true, damped: true, gap: false }));
    assert!(!upright.horizontal && page(&jeffcott("speed = 200.0\naxis = \"horizontal\"", 4.0, "")).horizontal);
    let more = "[[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 3.0\naxes = \"rotating\"\n\
                [[part]]\nkind = \"stop\"\nname = \"ring\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1e8\ngap = 1e-3\n";
    let of = |name: &str, page: &Overview| {
        page.machine.iter().find_map(|b| match b {
            Block::Link { name: n, joint, .. } if n == name => Some(*joint),
            _ => None,
        })
    };
    let p = page(&jeffcott("speed = 90.0", 4.0, more));
    assert_eq!(of("air", &p), Some(Joint { elastic: false, damped: true, gap: false }));
    assert_eq!(of("ring", &p).map(|j| (j.elastic, j.gap)), Some((true, true)));
}

/// What stands between a shaft and the ground is no part of the rotor, whatever kind makes it: a disc with coordinates of its own is a pedestal there, one on the shaft
/// is a disc. The shaft has the diameters of its sections.
#[test]
fn a_pedestal_stands_below_the_bearing() {
    use laval::outcome::Block;
    let p = page(
        "[machine]\nname = \"fan\"\nspeed = 100.0\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 2\n\
         section = [{ length = 0.4, outer_diameter = 0.02 }, { length = 0.6, outer_diameter = 0.04 }]\n\
         [[part]]\nkind = \"disc\"\nname = \"impeller\"\non = { body = \"shaft\", at = 0.5 }\nmass = 5\n\
         [[part]]\nkind = \"disc\"\nname = \"pedestal\"\nmass = 20\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"left\"\nbetween = [\"shaft\", \"pedestal\"]\nstiffness = 1e7\ndamping = 1e3\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"foot\"\nbetween = [\"pedestal\", \"ground\"]\nstiffness = 1e8\ndamping = 1e3\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"right\"\nbetween = [{ body = \"shaft\", at = 1.0 }, \"ground\"]\nstiffness = 1e7\ndamping = 1e3\n",
    );
    let bodies: Vec<(&str, bool, &[[f64; 4]])> = p
        .machine
        .iter()
        .filter_map(|b| match b {
            Block::Body { name, rotor, profile, .. } => Some((name.as_str(), *rotor, profile.as_slice())),
            _ => None,
        })
        .collect();
    let of = |name: &str| bodies.iter().find(|b| b.0 == name).unwrap();
    assert_eq!((of("shaft").1, of("impeller").1, of("pedestal").1), (true, true, false));
    let profile = of("shaft").2;
    assert!(profile.iter().all(|[a, b, d, e]| d == e && *d == if *a < 0.4 - 1e-9 { 0.02 } else { 0.04 } && b > a), "{profile:?}");
    assert!(profile[0][0] == 0.0 && (profile.last().unwrap()[1] - 1.0).abs() < 1e-12);
}

/// Waves of an ideal liquid that grow below the threshold are neither called growing on a card nor passed over in the check; above the onset the first page says
/// that a mode grows, and a card shows which.
#[test]
fn slow_waves_are_unresolved_in_the_check_and_on_the_cards() {
    let file = include_str!("../../../../examples/06-spatial-liquid/machine.toml");
    let machine = file.split("[[study]]").next().unwrap();
    let calm = page(machine);
    let stability = check(&calm, "check-stability");
    assert_eq!((stability.verdict, stability.result.key.as_str()), (Verdict::Attention, "stability-slow"));
    assert!(calm.next.iter().any(|m| m.key == "next-viscosity"));
    let limit = number(&stability.result, "limit");
    assert!(calm.modes.iter().any(|m| m.growth > 0.0) && calm.modes.iter().all(|m| m.growth < limit && !m.grows));
    let fast = page(&machine.replacen("speed = \"900 rpm\"", "speed = \"1337 rpm\"", 1));
    assert_eq!((fast.verdict, check(&fast, "check-stability").result.key.as_str()), (Verdict::Failed, "stability-unstable"));
    assert!(fast.modes.iter().all(|m| m.grows == (m.growth > limit)) && fast.modes.iter().any(|m| m.grows));
}

/// A soft mount resonates far below the operating speed while a study goes far above it: neither hides from the page. At 30 rpm of a machine studied to 60 000 rpm the
/// resonance beside the operating speed is found.
#[test]
fn a_study_that_reaches_far_up_hides_no_resonance() {
    let study = |from: f64, to: f64| format!("[[study]]\nkind = \"forced_response\"\nspeed = {{ from = {from}, to = {to} }}\n");
    // the critical speed is 100 rad/s
    let near = page(&jeffcott("speed = 99.0", 0.4, &study(10.0, 4e5)));
    assert_eq!(check(&near, "check-resonance").verdict, Verdict::Attention, "{:?}", near.checks);
    let high = page(&jeffcott("speed = 9000.0", 0.4, &study(1.0, 3e5)));
    let run = check(&high, "check-run-up");
    assert!(run.verdict == Verdict::NotComputed && (number(&run.result, "resonances") - 100.0).abs() < 0.1, "{run:?}");
    let over = high.over_speed.as_ref().unwrap();
    assert!(over.range.0 <= 1.0 && over.range.1 >= 1.5 * 9000.0, "{:?}", over.range);
}

/// The response of a free disc is its eccentricity at every speed: rounding on it is no resonance.
#[test]
fn a_free_disc_has_no_resonance() {
    let free = "[machine]\nname = \"m\"\nspeed = \"3000 rpm\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = \"25 kg\"\neccentricity = \"30 um\"\n\
                [[study]]\nkind = \"forced_response\"\nspeed = { from = \"100 rpm\", to = \"6000 rpm\" }\n";
    let p = page(free);
    assert!(p.over_speed.as_ref().unwrap().resonances.is_empty(), "{:?}", p.over_speed.unwrap().resonances);
}

/// The headline names a resonance among the operating speeds, beside limits that are not kept, and a run-up to the highest of them crosses it.
#[test]
fn a_resonance_among_the_operating_speeds_is_in_the_headline() {
    let range = "[operation]\nspeed = { from = 70, to = 140 }\n";
    for (more, keys) in [(String::new(), 2), ("[limits]\ndisplacement = \"1 um\"\n".to_string(), 3)] {
        let p = page(&jeffcott("speed = 120.0", 0.4, &format!("{range}{more}")));
        let headline: Vec<&str> = p.headline.iter().map(|m| m.key.as_str()).collect();
        assert!(headline.len() == keys && headline.contains(&"headline-resonance-inside"), "{headline:?}");
        let run = check(&p, "check-run-up");
        assert!(run.verdict == Verdict::NotComputed && (number(&run.result, "resonances") - 100.0).abs() < 0.1, "{run:?}");
    }
    // at one speed beside it, with a limit that is not kept
    let p = page(&jeffcott("speed = 99.0", 0.4, "[limits]\ndisplacement = \"1 um\"\n"));
    let headline: Vec<&str> = p.headline.iter().map(|m| m.key.as_str()).collect();
    assert_eq!((p.verdict, headline.as_slice()), (Verdict::Failed, ["headline-stable", "headline-limit", "headline-resonance"].as_slice()));
}

/// A mode along y is drawn along y.
#[test]
fn orbits_on_the_cards_lie_as_the_bodies_move() {
    let parts = "[[part]]\nkind = \"shaft_lumped\"\nname = \"spring\"\nbetween = [\"disc\", \"ground\"]\nstiffness = { x = 4e4, y = 9e4 }\n\
                 [[part]]\nkind = \"damper\"\nname = \"air\"\nbetween = [\"disc\", \"ground\"]\ndamping = 0.4\n";
    let text = jeffcott("speed = 95.0", 0.4, "").split("[[part]]\nkind = \"bearing_linear\"").next().unwrap().to_string() + parts;
    let p = page(&text);
    assert_eq!(p.modes.len(), 2);
    for (mode, along) in p.modes.iter().zip([0.0, std::f64::consts::FRAC_PI_2]) {
        assert!((mode.angles[0].abs() - along).abs() < 1e-6 && mode.orbits[0].2 < 1e-6, "{mode:?}");
    }
}
