//! The answer of the first page is never better than what was examined, nor than its checks; requirements that nothing assesses are open. Against a disc on springs with its
//! critical speed at 100 rad/s.

use super::first_page::of_studies;
use super::overview::{check, jeffcott, number, page};
use crate::common::files::load;
use laval::outcome::{Arg, Finding, Message, Outcome, Overview, Verdict};
use laval::study::{Context, overview};

const RPM: f64 = std::f64::consts::PI / 30.0;

fn keys(list: &[Message]) -> Vec<&str> {
    list.iter().map(|m| m.key.as_str()).collect()
}

fn study(kind: &str, from: f64, to: f64, more: &str) -> String {
    format!("[[study]]\nkind = \"{kind}\"\nspeed = {{ from = {from:?}, to = {to:?} }}\n{more}")
}

fn detail(p: &Overview, name: &str) -> Option<String> {
    check(p, name).detail.as_ref().map(|m| m.key.clone())
}

/// At 200 rad/s with a distance of 20 %: what was searched from 190 to 210 rad/s says nothing of 160 to 240.
#[test]
fn a_margin_needs_all_speeds_up_to_it() {
    let operation = "[operation]\nresonance_margin = 0.2\ninstability_margin = 0.2\n";
    let modes = "[[study]]\nkind = \"modes\"\nspeed = 200.0\n";
    let of = |from: f64, to: f64| {
        let studies =
            study("critical_speeds", from, to, "") + &study("stability_map", from, to, "") + &study("forced_response", from, to, "");
        of_studies(&jeffcott("speed = 200.0", 4.0, &format!("{operation}{modes}{studies}")))
    };
    let p = of(190.0, 210.0);
    for name in ["check-resonance", "check-instability"] {
        assert_eq!((check(&p, name).verdict, detail(&p, name).as_deref()), (Verdict::Attention, Some("distance-not-examined")), "{name}");
    }
    assert_eq!((p.verdict, keys(&p.headline)), (Verdict::Attention, vec!["headline-stable", "headline-attention"]));
    // one side alone
    assert_eq!(detail(&of(150.0, 230.0), "check-resonance").as_deref(), Some("distance-not-examined"));
    let p = of(159.0, 241.0);
    for name in ["check-resonance", "check-instability"] {
        assert_eq!(check(&p, name).verdict, Verdict::Passed, "{name}: {:?}", check(&p, name));
    }
    assert_eq!(p.verdict, Verdict::Passed, "{:?}", p.headline);
}

/// The page looks about the operating speeds itself, beside a study of the file that reaches less far.
#[test]
fn a_short_study_does_not_hide_a_resonance() {
    let p = page(&jeffcott(
        "speed = 104.0",
        0.5,
        &format!("[operation]\nresonance_margin = 0.2\n{}", study("critical_speeds", 103.0, 105.0, "")),
    ));
    let near = check(&p, "check-resonance");
    assert_eq!((p.verdict, near.verdict), (Verdict::Failed, Verdict::Failed), "{near:?}");
    assert!((near.margin.unwrap() - 4.0 / 104.0).abs() < 1e-3, "{near:?}");
}

#[test]
fn a_campbell_diagram_below_the_spin_frequency_searches_nothing() {
    let cut = |limit: f64| study("campbell", 20.0, 300.0, &format!("frequency_limit = {limit:?}\n"));
    let of = |limit: f64| {
        let more = format!("[operation]\nresonance_margin = 0.2\n[[study]]\nkind = \"modes\"\nspeed = 110.0\n{}", cut(limit));
        of_studies(&jeffcott("speed = 110.0", 0.5, &more))
    };
    assert_eq!(check(&of(90.0), "check-resonance").verdict, Verdict::NotComputed);
    assert_eq!(check(&of(301.0), "check-resonance").verdict, Verdict::Failed);
}

/// A distance of 1 % and one of 30 %: the resonance at 100 rad/s is 16.7 % away.
#[test]
fn of_two_distances_the_larger_one_is_required() {
    let of = |first: f64, second: f64| {
        let more = format!("[operation]\nresonance_margin = {first:?}\n[limits]\nclearance = {second:?}\n");
        check(&page(&jeffcott("speed = 120.0", 0.5, &more)), "check-resonance").verdict
    };
    assert_eq!([of(0.01, 0.3), of(0.3, 0.01), of(0.01, 0.02)], [Verdict::Failed, Verdict::Failed, Verdict::Passed]);
}

/// Unstable between two rows of a table that three speeds pass over.
#[test]
fn speeds_far_apart_are_no_examination_and_rows_of_tables_are_computed() {
    let film = "[[part]]\nkind = \"bearing_linear\"\nname = \"seal\"\nbetween = [\"disc\", \"ground\"]\ntable = { speed = [100.0, 205.0, 210.0, 215.0, 400.0], \
        kxx = [0.0, 0.0, 0.0, 0.0, 0.0], kyy = [0.0, 0.0, 0.0, 0.0, 0.0], kxy = [0.0, 0.0, 4e4, 0.0, 0.0], kyx = [0.0, 0.0, -4e4, 0.0, 0.0] }\n";
    let modes = "[[study]]\nkind = \"modes\"\nspeed = 180.0\n[operation]\nspeed = { from = 160.0, to = 260.0 }\n";
    let map = |points: usize| format!("[[study]]\nkind = \"stability_map\"\nspeed = {{ from = 130.0, to = 330.0, points = {points} }}\n");
    let p = of_studies(&jeffcott("speed = 180.0", 40.0, &format!("{film}{modes}{}", map(3))));
    assert_eq!((p.verdict, check(&p, "check-instability").verdict), (Verdict::Failed, Verdict::Failed), "{:?}", p.headline);
    // nothing to find, and few speeds
    let p = of_studies(&jeffcott("speed = 180.0", 40.0, &format!("{modes}{}", map(3))));
    assert_eq!(
        (check(&p, "check-instability").verdict, detail(&p, "check-instability").as_deref()),
        (Verdict::Attention, Some("distance-coarse"))
    );
    let p = of_studies(&jeffcott("speed = 180.0", 40.0, &format!("{modes}{}", map(30))));
    assert_eq!(check(&p, "check-instability").verdict, Verdict::Passed);
}

/// Excitation at twice the speed meets the mode at 50 rad/s.
#[test]
fn orders_that_were_not_searched_are_open() {
    let more = format!(
        "[limits]\norders = [1, 2]\nclearance = 0.2\n[[study]]\nkind = \"modes\"\nspeed = 52.0\n{}{}",
        study("stability_map", 20.0, 300.0, ""),
        study("forced_response", 20.0, 75.0, "")
    );
    let p = of_studies(&jeffcott("speed = 52.0", 0.5, &more));
    assert_eq!(
        (check(&p, "check-resonance").verdict, detail(&p, "check-resonance").as_deref()),
        (Verdict::Attention, Some("distance-orders-open"))
    );
    let p = page(&jeffcott("speed = 52.0", 0.5, "[limits]\norders = [1, 2]\nclearance = 0.2\n"));
    assert_eq!(check(&p, "check-resonance").verdict, Verdict::Failed);
}

/// A rotor whose spin is -2 times that of the machine: peaks of the response to its own unbalance are resonances at half their speed.
#[test]
fn responses_of_other_spins_show_their_resonances() {
    let turning = |studies: &str| {
        format!(
            "[machine]\nname = \"pair\"\nspeed = 48.0\n[[part]]\nkind = \"speed_ratio\"\nname = \"fast\"\nratio = -2.0\n\
             [[part]]\nkind = \"disc\"\nname = \"slow\"\nmass = 4.0\neccentricity = 1e-5\n[[part]]\nkind = \"disc\"\nname = \"quick\"\nmass = 4.0\neccentricity = 1e-5\nspin = \"fast\"\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"a\"\nbetween = [\"slow\", \"ground\"]\nstiffness = 1e6\ndamping = 40.0\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"quick\", \"ground\"]\nstiffness = 4e4\ndamping = 8.0\n\
             [limits]\nspeed = 90.0\n[operation]\nshaft_vibration = \"iso_7919_3\"\n[[study]]\nkind = \"modes\"\nspeed = 48.0\n{}{studies}",
            study("forced_response", 20.0, 90.0, "")
        )
    };
    let p = of_studies(&turning(""));
    assert_eq!(detail(&p, "check-resonance").as_deref(), Some("distance-orders-open"), "{:?}", check(&p, "check-resonance"));
    let p = of_studies(&turning(&study("forced_response", 60.0, 200.0, "name = \"fast\"\nspin = \"fast\"\n")));
    let near = check(&p, "check-resonance");
    assert_eq!(near.verdict, Verdict::Attention, "{near:?}");
    assert!((near.margin.unwrap() - 2.0 / 48.0).abs() < 1e-2, "{near:?}");
    // the faster shaft turns with 96 rad/s
    assert_eq!(check(&p, "check-speed").verdict, Verdict::Failed);
    assert_ne!(check(&of_studies(&turning("")), "check-shaft-vibration").verdict, Verdict::Passed);
    // what the page finds itself, whatever orders the file names for other excitation
    let own = turning("").replace("speed = 90.0\n", "orders = [1]\n");
    assert_eq!(check(&page(&own), "check-resonance").verdict, Verdict::Attention);
    // at 96 rad/s on its own spring
    let (r, zeta) = (0.96f64, 8.0 / (2.0 * (4e4f64 * 4.0).sqrt()));
    let amplitude = 1e-5 * r * r / ((1.0 - r * r).powi(2) + (2.0 * zeta * r).powi(2)).sqrt();
    for (factor, verdict) in [(1.01, Verdict::Passed), (0.99, Verdict::Failed)] {
        let limit = format!("displacement = {{ quick = {:?} }}\n", factor * amplitude);
        let text = turning(&study("forced_response", 60.0, 200.0, "name = \"fast\"\nspin = \"fast\"\n"))
            .replace("[limits]\n", &format!("[limits]\n{limit}"));
        let p = of_studies(&text);
        assert_eq!(check(&p, "check-vibration").verdict, verdict, "{:?}", check(&p, "check-vibration"));
        assert_eq!(detail(&p, "check-vibration").as_deref(), Some("response-with-spins"));
    }
}

#[test]
fn limits_that_nothing_assesses_are_open() {
    let of = |limits: &str| page(&jeffcott("speed = 200.0", 4.0, limits));
    assert_eq!(of("").verdict, Verdict::Passed);
    for limits in ["[limits]\npassage_displacement = 1e-3\n", "[limits]\nself_centring = 0.5\n", "[limits]\ndrive_torque = 1.0\n"] {
        let p = of(limits);
        assert_eq!((p.verdict, p.headline.last().unwrap().key.as_str()), (Verdict::Attention, "headline-not-checked"), "{limits}");
    }
}

/// What studies of the file warn of: a whirl beside the state at rest, a requirement of a standard.
#[test]
fn warnings_of_studies_reach_the_answer() {
    let of = |finding: Finding| {
        let loaded = load(&jeffcott("speed = 200.0", 4.0, ""));
        let outcome = Outcome::new("limit_cycles", "whirls").finding(finding);
        overview(&loaded.system, &[], &[outcome], &Context::quiet("summary"))
    };
    let beside = |from: f64, to: f64| {
        let f = Finding::warning("whirl_beside_rest", "limit-cycles-bistable").value(7e-3, "m");
        of(f.arg("from", Arg::speed(from)).arg("to", Arg::speed(to)))
    };
    let p = beside(150.0, 300.0);
    let stability = check(&p, "check-stability");
    assert_eq!((p.verdict, stability.verdict, stability.result.key.as_str()), (Verdict::Attention, Verdict::Attention, "stability-beside"));
    assert!((number(&stability.result, "value") - 7e-3).abs() < 1e-15);
    assert_eq!(beside(210.0, 300.0).verdict, Verdict::Passed);
    let p = of(Finding::warning("separation_margin", "forced-response-margin-broken"));
    assert_eq!((p.verdict, check(&p, "check-studies").verdict), (Verdict::Attention, Verdict::Attention));
    assert_eq!(of(Finding::info("separation_margin", "forced-response-margin")).verdict, Verdict::Passed);
}

const SHAFT: &str = "[machine]\nname = \"rotor\"\nspeed = \"3000 rpm\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = 8\nsection = [{ length = 0.8, outer_diameter = 0.05 }]\n\
    [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = { body = \"shaft\", at = 0.4 }\nmass = 20.0\npolar_inertia = 0.3\ndiametral_inertia = 0.2\nunbalance = \"100 g mm\"\n\
    [[part]]\nkind = \"bearing_linear\"\nname = \"a\"\nbetween = [\"shaft\", \"ground\"]\nstiffness = 5e7\ndamping = 4e4\n\
    [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [{ body = \"shaft\", at = 0.8 }, \"ground\"]\nstiffness = 5e7\ndamping = 4e4\n";

#[test]
fn a_limit_on_a_point_off_the_shaft_is_refused() {
    for (place, wrong) in [("900 mm", true), ("-5 mm", true), ("800 mm", false), ("0 mm", false)] {
        let text = format!("{SHAFT}[limits]\ndisplacement = {{ \"shaft at {place}\" = \"1 mm\" }}\n");
        let codes: Vec<String> = laval::file::load(&text).err().iter().flat_map(|d| &d.0).map(|d| d.code.to_string()).collect();
        assert_eq!(codes, if wrong { vec!["limits.place"] } else { Vec::new() }, "{place}");
    }
}

/// The value beside a limit is that of the point it is on, not the largest of all.
#[test]
fn a_limit_stands_beside_the_value_it_is_on() {
    let p = page(&format!("{SHAFT}[limits]\ndisplacement = {{ \"shaft at 0 mm\" = \"1 mm\" }}\n"));
    let found = check(&p, "check-vibration");
    let Some(Arg::List(all)) = found.result.arg_named("sizes") else { panic!("{found:?}") };
    let Arg::Phrase(item) = &all[0] else { panic!("{all:?}") };
    assert_eq!((item.key.as_str(), item.arg_named("name")), ("item-of", Some(&Arg::name("shaft at 0 mm"))));
}

/// Modes of the division of a shaft, far above the speed, have hardly any damping.
#[test]
fn a_decrement_is_required_of_modes_that_the_speed_can_drive() {
    let p = page(&format!("{SHAFT}[operation]\ndecrement = 1e-6\n"));
    let damping = check(&p, "check-damping");
    let Some(Arg::Quantity(frequency)) = damping.result.arg_named("frequency") else { panic!("{damping:?}") };
    assert!(damping.verdict == Verdict::Passed && frequency.value <= 10.0 * 3000.0 * RPM, "{damping:?}");
}

/// A rotor that sags by its weight, m g/k = 0.98 mm, onto a stop with a gap of 0.5 mm; with one of 2 mm it does not touch.
#[test]
fn a_rotor_that_lies_on_a_stop_needs_attention() {
    let of = |gap: f64| {
        let stop =
            format!("[[part]]\nkind = \"stop\"\nname = \"seal\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1e7\ngap = {gap:?}\n");
        let p = page(&jeffcott("speed = 250.0\naxis = \"horizontal\"", 4.0, &stop));
        let vibration = check(&p, "check-vibration");
        (vibration.verdict, vibration.detail.as_ref().map(|m| m.key.clone()).unwrap_or_default(), p.verdict)
    };
    assert_eq!(of(5e-4), (Verdict::Attention, "vibration-touching".to_string(), Verdict::Attention));
    assert_ne!(of(2e-3).1, "vibration-touching");
}

/// On the way to 250 rad/s the resonance at 100 rad/s would move the disc by e/(2 zeta) = 1 mm, twice the gap.
#[test]
fn a_gap_that_closes_on_the_way_needs_attention() {
    let of = |gap: f64| {
        let stop =
            format!("[[part]]\nkind = \"stop\"\nname = \"seal\"\nbetween = [\"disc\", \"ground\"]\nstiffness = 1e7\ngap = {gap:?}\n");
        let p = page(&jeffcott("speed = 250.0", 8.0, &stop));
        (check(&p, "check-run-up").verdict, detail(&p, "check-run-up").unwrap_or_default())
    };
    assert_eq!(of(5e-4), (Verdict::Attention, "run-up-contact".to_string()));
    assert_ne!(of(2e-3).1, "run-up-contact");
}

/// A disc in the node of the second mode does not excite it; another unbalance would.
#[test]
fn a_forward_critical_speed_without_a_peak_is_named() {
    let text = |speed: f64| {
        SHAFT
            .replace("\"3000 rpm\"", &format!("{speed:?}"))
            .replace("polar_inertia = 0.3\ndiametral_inertia = 0.2", "polar_inertia = 0.05\ndiametral_inertia = 0.2")
            .replace("damping = 4e4", "damping = 2e3")
    };
    let studies = study("critical_speeds", 10.0, 4000.0, "");
    let found = &crate::common::files::run_all(&format!("{}{studies}", text(300.0)))[0];
    let table = found.find_table("critical_speeds").unwrap();
    let (speeds, whirl) = (table.column("speed").unwrap(), table.column("whirl").unwrap());
    let laval::outcome::Data::Text(whirl) = &whirl.data else { panic!() };
    let forward: Vec<f64> = (0..table.rows()).filter(|&i| whirl[i] == "forward").map(|i| speeds.number(i).unwrap()).collect();
    let p = page(&format!("{}{studies}", text(forward[1])));
    assert_eq!(
        (check(&p, "check-resonance").verdict, detail(&p, "check-resonance").as_deref()),
        (Verdict::Attention, Some("distance-silent")),
        "{forward:?}"
    );
}

/// A light ring on a damper of negative coefficient grows at some 5 kHz: above the frequencies of a shaft of many elements, and of few as well.
#[test]
fn what_grows_above_the_frequencies_computed_is_found() {
    let ring = |damping: f64| {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"ring\"\nmass = 0.2\n[[part]]\nkind = \"bearing_linear\"\nname = \"fit\"\nbetween = [\"ring\", {{ body = \"shaft\", at = 0.2 }}]\nstiffness = 2e8\ndamping = {damping:?}\n"
        )
    };
    let of = |elements: usize, damping: f64| {
        let shaft = SHAFT.replace("elements = 8", &format!("elements = {elements}")).replace("damping = 4e4", "damping = 50.0");
        let p = page(&format!("{shaft}{}", ring(damping)));
        (check(&p, "check-stability").verdict, p.headline[0].key.clone())
    };
    for elements in [4, 48] {
        assert_eq!(of(elements, -20.0), (Verdict::Failed, "headline-unstable".to_string()), "{elements}");
        assert_eq!(of(elements, 20.0), (Verdict::Passed, "headline-stable".to_string()), "{elements}");
    }
}
