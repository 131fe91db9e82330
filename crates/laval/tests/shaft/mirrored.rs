//! Rotors that turn against the spin of their machine are the mirror images of those that turn with it: margins, thresholds and responses are the same. What the first page
//! does not know of the unbalance of another spin it does not pass.

use crate::common::files::load;
use laval::outcome::{Check, Outcome, Overview, Verdict};
use laval::study::stability_threshold::region::{RigidLimit, rigid_limit};
use laval::study::{Context, overview};

const RPM: f64 = std::f64::consts::PI / 30.0;

/// An overhung disc on equal bearings, the only rotor of its machine, whose spin has this ratio to the speed (rpm).
fn overhung(ratio: f64, speed: f64, studies: &str) -> String {
    let bearing = |name: &str, at: f64| {
        format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at} }}, \"ground\"]\nstiffness = 1e8\ndamping = 5e4\n"
        )
    };
    format!(
        "[machine]\nname = \"overhung\"\nspeed = \"{speed} rpm\"\naxis = \"horizontal\"\n\
         [[part]]\nkind = \"speed_ratio\"\nname = \"own\"\nratio = {ratio:?}\n\
         [[part]]\nkind = \"shaft\"\nname = \"shaft\"\nspin = \"own\"\nelements = 6\nsection = [{{ length = 0.5, outer_diameter = 0.05 }}]\n\
         [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.5 }}\nmass = 8.0\npolar_inertia = 0.12\ndiametral_inertia = 0.07\nunbalance = \"40 g mm\"\n{}{}{studies}",
        bearing("a", 0.05),
        bearing("b", 0.35)
    )
}

fn outcomes(text: &str) -> Vec<Outcome> {
    let loaded = load(text);
    loaded.studies.iter().map(|s| s.study.run(&loaded.system, &Context::quiet("study")).unwrap_or_else(|d| panic!("{d:?}"))).collect()
}

fn page(text: &str) -> Overview {
    let loaded = load(text);
    let speeds: Vec<_> = loaded.studies.iter().flat_map(|s| s.study.speeds(&loaded.system)).collect();
    overview(&loaded.system, &speeds, &outcomes(text), &Context::quiet("summary"))
}

fn check<'p>(page: &'p Overview, name: &str) -> &'p Check {
    page.checks.iter().find(|c| c.what.key == name).unwrap_or_else(|| panic!("no {name} in {:?}", page.checks))
}

fn near(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() <= 1e-7 * b.abs(), "{what}: {a} {b}");
}

#[test]
fn resonances_are_those_of_the_own_direction() {
    let resonances = |ratio: f64| -> Vec<f64> {
        let p = page(&overhung(ratio, 13_000.0, ""));
        p.over_speed.unwrap().resonances.iter().map(|r| r.speed).collect()
    };
    let (along, against) = (resonances(1.0), resonances(-1.0));
    assert!(along.iter().any(|w| (w / RPM - 13_281.0).abs() < 50.0) && along.iter().all(|w| (w / RPM - 8264.0).abs() > 100.0), "{along:?}");
    assert_eq!(along.len(), against.len(), "{along:?} {against:?}");
    along.iter().zip(&against).for_each(|(a, b)| near(*a, *b, "resonance"));
    // at another ratio the same resonance belongs to another speed of the machine
    let faster = resonances(-2.0);
    let expected = along.iter().find(|w| (*w / RPM - 13_281.0).abs() < 50.0).unwrap() / 2.0;
    assert!(faster.iter().any(|w| (w - expected).abs() <= 1e-6 * expected), "{faster:?} {expected}");
}

#[test]
fn cross_coupling_and_turning_forces_follow_the_place() {
    let studies = "[[study]]\nkind = \"stability_threshold\"\nplace = \"wheel\"\n\
                   [[study]]\nkind = \"harmonic_force\"\nplace = \"wheel\"\ndirection = \"forward\"\nspeed = { from = \"4000 rpm\", to = \"16000 rpm\" }\n";
    let found = |ratio: f64| {
        let all = outcomes(&overhung(ratio, 9000.0, studies));
        let threshold =
            all[0].findings.iter().find(|f| f.id == "threshold").and_then(|f| f.value).unwrap_or_else(|| panic!("{:?}", all[0].findings));
        let peaks: Vec<f64> = all[1].special_points.iter().filter(|p| p.kind == "resonance").map(|p| p.at).collect();
        assert!(!peaks.is_empty());
        (threshold, peaks)
    };
    let ((threshold, peaks), (mirrored, others)) = (found(1.0), found(-1.0));
    near(mirrored, threshold, "threshold");
    assert_eq!(peaks.len(), others.len(), "{peaks:?} {others:?}");
    peaks.iter().zip(&others).for_each(|(a, b)| near(*a, *b, "peak"));
    // a force that turns with the rotor excites forward whirl
    assert!(peaks.iter().all(|w| (12_500.0..13_500.0).contains(&(w / RPM))), "{peaks:?}");
}

/// The critical speed on rigid supports is that of the rotor at the place, at the speed of the machine at which its spin reaches it.
#[test]
fn the_critical_speed_on_rigid_supports_is_that_of_the_own_spin() {
    let limit = |ratio: f64| {
        let system = load(&overhung(ratio, 9000.0 / ratio.abs(), "")).system;
        match rigid_limit(&system, &[], Some("wheel"), 9000.0 * RPM / ratio.abs()) {
            RigidLimit::Found { speed, .. } => speed,
            other => panic!("{ratio}: {other:?}"),
        }
    };
    let along = limit(1.0);
    near(limit(-1.0), along, "mirror image");
    near(limit(-3.0), along / 3.0, "a faster spin");
}

/// The limits of a geared machine cannot be passed by the response to the unbalance of one of its shafts.
#[test]
fn limits_are_not_passed_without_the_unbalance_of_every_spin() {
    let limits = "[limits]\ndisplacement = \"1 m\"\nforce = { a = \"1e9 N\" }\n";
    for (unbalance, passed) in [("40 g mm", false), ("0 g mm", true)] {
        let text = overhung(-1.5, 9000.0, limits).replace("40 g mm", unbalance);
        let main = "[[part]]\nkind = \"disc\"\nname = \"main\"\nmass = 5.0\nunbalance = \"10 g mm\"\n\
                    [[part]]\nkind = \"bearing_linear\"\nname = \"c\"\nbetween = [\"main\", \"ground\"]\nstiffness = 3e7\ndamping = 2e4\n";
        let p = page(&text.replace("[limits]", &format!("{main}[limits]")));
        for name in ["check-vibration", "check-forces"] {
            let found = check(&p, name);
            assert_eq!(found.verdict == Verdict::Passed, passed, "{found:?}");
            assert_eq!(found.verdict == Verdict::NotComputed, !passed, "{found:?}");
            assert_eq!(found.detail.as_ref().is_some_and(|d| d.key == "response-without-spins"), !passed, "{found:?}");
        }
    }
}

/// The whirl of a rotor is named by its own spin: forward modes of the mirror image are forward too, and gyroscopic moments raise them.
#[test]
fn modes_are_named_by_the_spin_of_what_moves() {
    let lines = |ratio: f64| -> Vec<(f64, String)> {
        let o = &outcomes(&overhung(ratio, 8000.0, "[[study]]\nkind = \"modes\"\n"))[0];
        let table = o.find_table("modes").unwrap();
        let (frequency, whirl) = (table.column("frequency").unwrap(), table.column("whirl").unwrap());
        (0..4)
            .map(|i| {
                (
                    frequency.number(i).unwrap(),
                    match &whirl.data {
                        laval::outcome::Data::Text(v) => v[i].clone(),
                        other => panic!("{other:?}"),
                    },
                )
            })
            .collect()
    };
    let (along, against) = (lines(1.0), lines(-1.0));
    assert!(along[0].1 == "backward" && along[1].1 == "forward", "{along:?}");
    for (a, b) in along.iter().zip(&against) {
        near(a.0, b.0, "frequency");
        assert_eq!(a.1, b.1, "{along:?} {against:?}");
    }
}

/// Rotors that turn against each other and move together: the direction is that of the machine, and none is mixed.
#[test]
fn modes_of_counter_rotating_shafts_have_a_direction() {
    let disc = |name: &str, more: &str| {
        format!("[[part]]\nkind = \"disc\"\nname = \"{name}\"\nmass = 5.0\npolar_inertia = 0.2\ndiametral_inertia = 0.12\n{more}")
    };
    let spring = |name: &str, between: &str| {
        format!("[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = {between}\nstiffness = 2e6\ndamping = 100.0\n")
    };
    let text = format!(
        "[machine]\nspeed = 600.0\n[[part]]\nkind = \"speed_ratio\"\nname = \"own\"\nratio = -1.5\n{}{}{}{}{}{}[[study]]\nkind = \"modes\"\n",
        disc("inner", ""),
        disc("outer", "spin = \"own\"\n"),
        spring("a", "[{ body = \"inner\", at = -0.2 }, \"ground\"]"),
        spring("b", "[{ body = \"inner\", at = 0.15 }, { body = \"outer\", at = 0.1 }]"),
        spring("c", "[{ body = \"outer\", at = -0.1 }, \"ground\"]"),
        spring("d", "[{ body = \"outer\", at = 0.2 }, \"ground\"]")
    );
    let o = &outcomes(&text)[0];
    let laval::outcome::Data::Text(words) = &o.find_table("modes").unwrap().column("whirl").unwrap().data else { panic!() };
    assert!(words.len() >= 6 && words.iter().all(|w| w == "forward" || w == "backward"), "{words:?}");
}
