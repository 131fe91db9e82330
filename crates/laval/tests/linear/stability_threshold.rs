//! Stability over a cross-coupled stiffness: closed forms of a mass on springs, the same machine with a bearing in place of the stiffness, counts, criteria, mistakes.

use crate::common::files::{finding, findings, load, run_all};
use laval::model::field::Attach;
use laval::outcome::{Data, Finding, Level, Outcome};
use laval::solve::pencil::{Linearised, modes_about};
use laval::solve::rest::rest;
use laval::solve::roots::in_region;
use laval::study::stability_threshold::region::{Region, speed_ratio_limit};
use laval::study::stability_threshold::{StabilityThreshold, ThresholdResult, decrement};
use laval::study::{Context, Study};
use laval_num::complex::{C64, c};
use std::f64::consts::TAU;

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance * b.abs(), "{what}: {a} {b}, {:e}", (a - b).abs() / b.abs());
}

fn mass(kx: f64, ky: f64, damping: f64, study: &str) -> String {
    format!(
        "[machine]\nname = \"t\"\nspeed = 300\n[[part]]\nkind = \"disc\"\nname = \"disc\"\nmass = 8.0\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"disc\", \"ground\"]\nkxx = {kx:?}\nkyy = {ky:?}\ndamping = {damping:?}\n\
         [[study]]\nkind = \"stability_threshold\"\nplace = \"disc\"\n{study}\n"
    )
}

fn run(text: &str) -> Outcome {
    run_all(text).remove(0)
}

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Float(values) => values.clone(),
        other => panic!("{other:?}"),
    }
}

/// `m s^2 + c s + k - i q = 0` of a mass on equal springs: unstable from `q = c w` on, w^2 = k/m.
#[test]
fn equal_springs() {
    let (m, k, damping) = (8.0, 2e6, 300.0);
    for spacing in ["linear", "logarithmic"] {
        let o = run(&mass(k, k, damping, &format!("up_to = 4e5\npoints = 9\nspacing = \"{spacing}\"")));
        let w = (k / m).sqrt();
        let f = finding(&o, "threshold");
        near(f.value.unwrap(), damping * w, 1e-13, "threshold");
        assert_eq!(f.evidence.iter().skip(2).map(|e| e.value).collect::<Vec<_>>(), [0.0, 1.0]);
        assert_eq!(findings(&o, "threshold").len(), 1);
        near(column(&o, "thresholds", "frequency")[0], w, 1e-13, "frequency");
        let zeta = damping / (2.0 * (k * m).sqrt());
        near(finding(&o, "base_decrement").value.unwrap(), TAU * zeta / (1.0 - zeta * zeta).sqrt(), 1e-12, "decrement");
        // both modes, at every value
        let (q, growth, frequency) = (column(&o, "modes", "stiffness"), column(&o, "modes", "growth"), column(&o, "modes", "frequency"));
        let slope = column(&o, "modes", "growth_by_stiffness");
        assert_eq!(q.len(), 18);
        for i in 0..q.len() {
            let side = if i < 9 { 1.0 } else { -1.0 };
            let root = (c(damping * damping - 4.0 * m * k, side * 4.0 * m * q[i]).sqrt() - c(damping, 0.0)).scale(0.5 / m);
            let root = if root.im < 0.0 {
                ((c(damping * damping - 4.0 * m * k, side * 4.0 * m * q[i])).sqrt().scale(-1.0) - c(damping, 0.0)).scale(0.5 / m)
            } else {
                root
            };
            assert!((c(growth[i], frequency[i]) - root).abs() <= 1e-12 * root.abs(), "{i} {root:?} {} {}", growth[i], frequency[i]);
            let by_q = c(0.0, side) / (root.scale(2.0 * m) + c(damping, 0.0));
            near(slope[i], by_q.re, 1e-10, "slope");
        }
        let last = q[8];
        assert_eq!((q[0], last), (0.0, 4e5));
        match spacing {
            "linear" => near(q[1], 5e4, 1e-14, "step"),
            _ => near(q[1], 4e2, 1e-12, "ratio"),
        }
    }
}

/// `(m s^2 + c s + kx)(m s^2 + c s + ky) + q^2 = 0`: unstable from `q^2 = c^2 w^2 + ((kx - ky)/2)^2` on, w^2 = (kx + ky)/(2 m). The frequencies meet on the way.
#[test]
fn unequal_springs() {
    for (kx, ky, damping) in [(2e6f64, 2.6e6, 300.0), (1e6, 3e6, 40.0), (2e6, 2.001e6, 10.0)] {
        let w2 = (kx + ky) / 16.0;
        let expected = (damping * damping * w2 + 0.25 * (kx - ky) * (kx - ky)).sqrt();
        let o = run(&mass(kx, ky, damping, &format!("up_to = {:?}\npoints = 24", 1.7 * expected)));
        let f = finding(&o, "threshold");
        near(f.value.unwrap(), expected, 1e-11, "threshold");
        assert_eq!(f.evidence.iter().skip(2).map(|e| e.value).collect::<Vec<_>>(), [0.0, 1.0]);
        near(column(&o, "thresholds", "frequency")[0], w2.sqrt(), 1e-9, "frequency");
        assert!(findings(&o, "missed").is_empty() && findings(&o, "lost").is_empty() && findings(&o, "counted").len() == 1);
        // with equal damping p = m s^2 + c s is a double root where q is half the difference
        near(finding(&o, "meeting").value.unwrap(), 0.5 * (ky - kx), 1e-6, "double root");
        let q = column(&o, "modes", "stiffness");
        let (growth, frequency) = (column(&o, "modes", "growth"), column(&o, "modes", "frequency"));
        for i in 0..q.len() {
            let s = c(growth[i], frequency[i]);
            let p = s * s.scale(8.0) + s.scale(damping);
            let t = (p + c(kx, 0.0)) * (p + c(ky, 0.0)) + c(q[i] * q[i], 0.0);
            assert!(t.abs() <= 1e-10 * kx * ky, "{} {t:?}", q[i]);
        }
    }
}

/// Without damping any stiffness is too much; a rotor that whirls by itself is unstable without it; below the threshold nothing is claimed beyond the largest value.
#[test]
fn limits() {
    let o = run(&mass(2e6, 2e6, 0.0, "up_to = 1e5"));
    let f = finding(&o, "threshold");
    assert_eq!(f.value, Some(0.0));
    assert!(f.sentence().contains("Any cross-coupled stiffness"), "{}", f.sentence());
    let o = run(&mass(2e6, 2e6, 300.0, "up_to = 1e5"));
    assert_eq!(finding(&o, "no_threshold").value, Some(1e5));
    assert!(findings(&o, "threshold").is_empty());
    let inner =
        "[[part]]\nkind = \"damper\"\nname = \"inner\"\nbetween = [\"disc\", \"ground\"]\naxes = \"rotating\"\ndamping = 500.0\n[[study]]";
    let text = mass(2e6, 2e6, 3.0, "up_to = 1e5").replace("[[study]]", inner).replace("speed = 300", "speed = 700");
    let o = run(&text);
    assert!(findings(&o, "threshold").is_empty() && findings(&o, "no_threshold").is_empty());
    let f = finding(&o, "unstable_without");
    assert!(f.level == Level::Warning && f.value.unwrap() < 0.0);
    // the range is proposed from the derivatives, which are those of a line here
    let o = run(&mass(2e6, 2e6, 300.0, ""));
    near(*column(&o, "modes", "stiffness").iter().max_by(|a, b| a.total_cmp(b)).unwrap(), 1.5 * 300.0 * 500.0, 1e-2, "proposed");
}

/// The criteria of level 1: logarithmic decrement and ratio of the threshold.
#[test]
fn level_1() {
    let (damping, w) = (300.0, 500.0);
    let at = |anticipated: f64, up_to: f64| {
        let o = run(&mass(2e6, 2e6, damping, &format!("anticipated = {anticipated:?}\nup_to = {up_to:?}")));
        let f = finding(&o, "level_1").clone();
        let root = (c(damping * damping - 32.0 * 2e6, 32.0 * anticipated).sqrt() - c(damping, 0.0)).scale(1.0 / 16.0);
        near(f.value.unwrap(), -TAU * root.re / root.im, 1e-10, "decrement");
        (f.level, f.sentence(), f.evidence[1].value)
    };
    let (level, words, ratio) = at(2e4, 2e5);
    assert!(level == Level::Info && words.contains("passed") && words.contains("gas density"), "{words}");
    near(ratio, damping * w / 2e4, 1e-12, "ratio");
    let (level, words, _) = at(1e4, 2e5);
    assert!(level == Level::Info && !words.contains("gas density"), "{words}");
    // a ratio below 2, and a decrement below 0.1
    let (level, words, ratio) = at(8e4, 2e5);
    assert!(level == Level::Warning && words.contains("Level 2") && ratio < 2.0, "{words}");
    // without a threshold the ratio is not known
    let (level, words, ratio) = at(5e4, 6e4);
    assert!(level == Level::Warning && words.contains("not decided") && (ratio - 1.2).abs() < 1e-12, "{words}");
    let (level, words, _) = at(2e4, 6e4);
    assert!(level == Level::Info && words.contains("more than 3"), "{words}");
}

/// Two masses on springs, joined by a soft link, the stiffness on the second: the one mode that is followed because it becomes unstable first is that of the second mass, and the criteria
/// of level 1 are those of the lower one.
#[test]
fn level_1_is_of_the_first_forward_mode() {
    let mass = |name: &str, k: f64, c: f64| {
        format!(
            "[[part]]\nkind = \"disc\"\nname = \"{name}\"\nmass = 8.0\n\
             [[part]]\nkind = \"bearing_linear\"\nname = \"{name} spring\"\nbetween = [\"{name}\", \"ground\"]\nstiffness = {k:?}\ndamping = {c:?}\n"
        )
    };
    let (m, damping, k) = (8.0, 2000.0, 2e6);
    let o = run(&format!(
        "[machine]\nname = \"t\"\nspeed = 300\n{}{}\
         [[part]]\nkind = \"bearing_linear\"\nname = \"link\"\nbetween = [\"a\", \"b\"]\nstiffness = 1e5\n\
         [[study]]\nkind = \"stability_threshold\"\nplace = \"b\"\nmodes = 1\nanticipated = 1e3\nup_to = 1e5\n",
        mass("a", k, damping),
        mass("b", 2e7, 2.0)
    ));
    let f = finding(&o, "level_1");
    // m s^2 + c s + k of the first mass on its spring and the link, at whose other end the second one hardly moves
    let root = (c(damping * damping - 4.0 * m * (k + 1e5), 0.0).sqrt() - c(damping, 0.0)).scale(0.5 / m);
    near(f.value.unwrap(), TAU * root.re.abs() / root.im.abs(), 1e-2, "decrement");
    assert!(finding(&o, "base_decrement").value.unwrap() < 1e-2 * f.value.unwrap(), "{}", f.sentence());
}

/// The boundary of the regions of gas density and critical speed ratio; a number that is none is in no region.
#[test]
fn regions_of_gas_density() {
    for (density, limit) in [(0.0, 2.5), (16.53, 2.5), (38.0, 2.253), (60.0, 2.0)] {
        near(speed_ratio_limit(density), limit, 1e-14, "boundary");
        assert_eq!(Region::of(limit * (1.0 - 1e-12), density), Region::A);
        assert_eq!(Region::of(limit * (1.0 + 1e-12), density), Region::B);
        assert_eq!(Region::of(f64::NAN, density), Region::Unknown);
    }
    assert_eq!(speed_ratio_limit(60.1), 0.0);
    for ratio in [0.0, 0.1, 5.0, f64::NAN] {
        assert_eq!(Region::of(ratio, 60.1), Region::B);
        assert_eq!(Region::of(ratio, f64::NAN), Region::Unknown);
    }
    assert!(speed_ratio_limit(f64::NAN).is_nan() && speed_ratio_limit(-1.0).is_nan());
}

const SHAFT: f64 = 2e6;

/// A mass of 8 kg on a shaft without mass, `(m s^2 + k - i q)(M s^2 + c s + k + kb) = k^2` with the mass M of its journal: `W0^2 = k/m` on a rigid bearing, threshold 175 704 N/m.
fn jeffcott(speed: f64, more: &str, study: &str) -> Finding {
    let text = format!(
        "[machine]\nname = \"t\"\nspeed = {speed:?}\n[[part]]\nkind = \"disc\"\nname = \"wheel\"\nmass = 8.0\n\
         [[part]]\nkind = \"disc\"\nname = \"journal\"\nmass = 0.5\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"shaft\"\nbetween = [\"wheel\", \"journal\"]\nstiffness = {SHAFT:?}\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"bearing\"\nbetween = [\"journal\", \"ground\"]\nstiffness = 4e6\ndamping = 4e3\n{more}\
         [[study]]\nkind = \"stability_threshold\"\nplace = \"wheel\"\n{study}\n"
    );
    finding(&run(&text), "level_1").clone()
}

fn evidence(f: &Finding, what: &'static str) -> Option<f64> {
    f.evidence.iter().find(|e| e.what == what).map(|e| e.value)
}

/// Level 2 is required in region B for a threshold below ten times the anticipated stiffness: closed form of the critical speed on rigid supports.
#[test]
fn gas_density() {
    let anticipated = "up_to = 3e5\nanticipated = 4.4e4\n";
    let rigid = (SHAFT / 8.0).sqrt();
    for (speed, level, region) in [(1000.0, Level::Info, "Region A"), (1200.0, Level::Warning, "Region B")] {
        let f = jeffcott(speed, "", &format!("{anticipated}gas_density = \"38 kg/m^3\""));
        let words = f.sentence();
        assert!(f.level == level && words.contains(region), "{words}");
        assert_eq!(words.contains("All three criteria are met"), level == Level::Info, "{words}");
        assert_eq!(words.contains("Level 2 analysis required"), level == Level::Warning, "{words}");
        assert!(words.contains("2.25") && words.contains("38 kg") && words.contains("Rigid supports: bearing."), "{words}");
        near(evidence(&f, "threshold over the anticipated stiffness").unwrap(), 175_703.790_73 / 4.4e4, 1e-8, "ratio");
        near(evidence(&f, "critical speed ratio").unwrap(), speed / rigid, 1e-6, "critical speed ratio");
        near(evidence(&f, "largest critical speed ratio at this gas density").unwrap(), 2.253, 1e-14, "limit");
        near(evidence(&f, "first critical speed on rigid supports").unwrap(), rigid, 1e-6, "on a rigid support");
        assert!(evidence(&f, "difference with ten times the support stiffness, over it").unwrap() < 1e-6);
    }
    // every ratio is in region B at a large density
    let f = jeffcott(100.0, "", &format!("{anticipated}gas_density = \"61 kg/m^3\""));
    assert!(f.level == Level::Warning && f.sentence().contains("at any critical speed ratio"), "{}", f.sentence());
    // a threshold of ten times the anticipated stiffness needs no density
    let plain = jeffcott(1200.0, "", "up_to = 3e5\nanticipated = 1.4e4");
    let f = jeffcott(1200.0, "", "up_to = 3e5\nanticipated = 1.4e4\ngas_density = \"70 kg/m^3\"");
    assert!(f == plain && f.level == Level::Info && f.evidence.len() == 2, "{}", f.sentence());
    // nor is it assessed where it is not given
    let f = jeffcott(1200.0, "", anticipated);
    assert!(f.level == Level::Info && f.evidence.len() == 2, "{}", f.sentence());
    assert!(f.sentence().ends_with("the criterion of gas density and speed ratio counts as well; it is not assessed."), "{}", f.sentence());
    // a larger threshold than up_to may lie above ten times the anticipated stiffness
    let f = jeffcott(1200.0, "", "up_to = 1.5e5\nanticipated = 4.4e4\ngas_density = \"38 kg/m^3\"");
    let words = f.sentence();
    assert!(f.level == Level::Warning && words.contains("not decided") && words.contains("Region B"), "{words}");
    // in region A it passes all the same
    let f = jeffcott(1000.0, "", "up_to = 1.5e5\nanticipated = 4.4e4\ngas_density = \"38 kg/m^3\"");
    assert!(f.level == Level::Info && f.sentence().contains("more than 3"), "{}", f.sentence());
}

/// A machine without a critical speed on rigid supports is not assessed; a seal with direct stiffness is no support where `supports` names others.
#[test]
fn no_critical_speed_on_rigid_supports() {
    let o = run(&mass(2e6, 2e6, 300.0, "anticipated = 2e4\nup_to = 2e5\ngas_density = \"20 kg/m^3\""));
    let f = finding(&o, "level_1");
    let words = f.sentence();
    assert!(f.level == Level::Warning && words.contains("not decided") && words.contains("no critical speed on rigid supports"), "{words}");
    assert!(evidence(f, "critical speed ratio").is_none());
    let seal =
        "[[part]]\nkind = \"bearing_linear\"\nname = \"seal\"\nbetween = [\"wheel\", \"ground\"]\nstiffness = 1e5\ndamping = 100.0\n";
    let study = "up_to = 4e5\nanticipated = 4e4\ngas_density = \"38 kg/m^3\"\n";
    let f = jeffcott(1000.0, seal, study);
    assert!(f.level == Level::Warning && f.sentence().contains("no critical speed on rigid supports"), "{}", f.sentence());
    let f = jeffcott(1000.0, seal, &format!("{study}supports = \"bearing\""));
    near(evidence(&f, "first critical speed on rigid supports").unwrap(), ((SHAFT + 1e5) / 8.0).sqrt(), 1e-6, "with a seal");
    assert!(f.level == Level::Info && f.sentence().contains("Region A"), "{}", f.sentence());
}

/// A compressor shaft on bearings on pedestals, with a mass beside the shaft: the threshold is that of the machine with a bearing kxy = -kyx at the place, also of a machine too large for all its modes.
#[test]
fn pedestals_and_large_shafts() {
    for elements in [3, 30] {
        let shaft = format!(
            "[machine]\nname = \"t\"\nspeed = 900\naxis = \"horizontal\"\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = {elements}\nsection = {{ length = [0.4, 0.6, 0.4], outer_diameter = [0.06, 0.09, 0.06] }}\n\
             [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.7 }}\nmass = 12.0\npolar_inertia = 0.2\ndiametral_inertia = 0.12\n"
        );
        let end = |name: &str, at: f64| {
            format!(
                "[[part]]\nkind = \"foundation\"\nname = \"{name} base\"\nmass = 15.0\nstiffness = {{ x = 8e7, y = 1.2e8 }}\ndamping = 2e3\n\
                 [[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"{name} base\"]\nkxx = 3e7\nkyy = 5e7\nkxy = 4e6\nkyx = -2e6\ncxx = 2e4\ncyy = 3e4\n"
            )
        };
        let machine = format!("{shaft}{}{}", end("a", 0.0), end("b", 1.4));
        let o = run(&format!(
            "{machine}[[study]]\nkind = \"stability_threshold\"\nplace = {{ body = \"shaft\", at = 0.85 }}\nup_to = 2e6\npoints = 15\n"
        ));
        let f = finding(&o, "threshold");
        let q = f.value.unwrap();
        assert!(q > 0.0 && q < 2e6 && f.evidence[0].value < 1e-6, "{q:e} {:?}", f.evidence);
        let growth = |q: f64| {
            let seal = format!(
                "[[part]]\nkind = \"bearing_linear\"\nname = \"seal\"\nbetween = [{{ body = \"shaft\", at = 0.85 }}, \"ground\"]\nkxy = {q:?}\nkyx = {:?}\n",
                -q
            );
            let system = load(&format!("{machine}{seal}")).system;
            assert_eq!(in_region(&system), elements == 30);
            let modes = modes_about(&system, &rest(&system, 900.0).unwrap(), true).unwrap();
            modes.least_stable().unwrap().value
        };
        let at = growth(q);
        assert!(at.re.abs() <= 1e-9 * at.im, "{at:?}");
        near(at.im, column(&o, "thresholds", "frequency")[0], 1e-9, "frequency");
        let slope = f.evidence[1].value;
        for side in [-1.0, 1.0] {
            let beside = growth(q * (1.0 + side * 1e-4)).re;
            near(beside, side * 1e-4 * q * slope, 1e-3, "growth beside");
        }
        assert_eq!(f.evidence.iter().skip(2).map(|e| e.value).collect::<Vec<_>>(), [0.0, 1.0]);
    }
}

/// A shaft on damped bearings beside nine bodies of their own, so slow that the modes usually sought of a large machine are theirs.
fn beside_slow_bodies(elements: usize, more: &str) -> String {
    let mut text = format!(
        "[machine]\nname = \"t\"\nspeed = 20\n[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nelements = {elements}\nsection = [{{ length = 0.6, outer_diameter = 0.05 }}]\n\
         [[part]]\nkind = \"disc\"\nname = \"wheel\"\non = {{ body = \"shaft\", at = 0.4 }}\nmass = 8.0\npolar_inertia = 0.03\ndiametral_inertia = 0.02\n"
    );
    for (name, at) in [("a", 0.0), ("b", 0.6)] {
        text += &format!(
            "[[part]]\nkind = \"bearing_linear\"\nname = \"{name}\"\nbetween = [{{ body = \"shaft\", at = {at:?} }}, \"ground\"]\nstiffness = 5e7\ndamping = 3e3\n"
        );
    }
    for k in 0..9 {
        let stiffness = 1e5 + 1.3e4 * f64::from(k);
        text += &format!(
            "[[part]]\nkind = \"disc\"\nname = \"d{k}\"\nmass = 10.0\n[[part]]\nkind = \"bearing_linear\"\nname = \"s{k}\"\nbetween = [\"d{k}\", \"ground\"]\nkxx = {stiffness:?}\nkyy = {:?}\ndamping = 100.0\n",
            1.3 * stiffness
        );
    }
    text + more
}

/// All roots of a machine with a bearing kxy = -kyx = q at 0.3 m of its shaft, by its full matrices.
fn with_seal(elements: usize, q: f64) -> Vec<C64> {
    let seal = format!(
        "[[part]]\nkind = \"bearing_linear\"\nname = \"seal\"\nbetween = [{{ body = \"shaft\", at = 0.3 }}, \"ground\"]\nkxy = {q:?}\nkyx = {:?}\n",
        -q
    );
    let system = load(&beside_slow_bodies(elements, &seal)).system;
    let all = Linearised::new(&system, &rest(&system, 20.0).unwrap()).unwrap().spectrum().unwrap().modes;
    all.iter().map(|m| m.value).collect()
}

const AT_MIDSPAN: &str =
    "[[study]]\nkind = \"stability_threshold\"\nplace = { body = \"shaft\", at = 0.3 }\nanticipated = 1e5\nup_to = 1e6\npoints = 8\n";

/// A mode that grows beyond the frequency up to which modes of a large machine are sought: the threshold is that of the full matrices.
#[test]
fn growth_beyond_the_usual_frequency() {
    let o = run(&beside_slow_bodies(24, AT_MIDSPAN));
    assert!(findings(&o, "no_threshold").is_empty());
    let f = finding(&o, "threshold");
    let q = f.value.unwrap();
    assert_eq!(f.evidence.iter().skip(2).map(|e| e.value).collect::<Vec<_>>(), [0.0, 1.0]);
    let growth = |q: f64| with_seal(24, q).iter().map(|s| s.re).fold(f64::NEG_INFINITY, f64::max);
    assert!(growth(0.99 * q) < 0.0 && growth(1.01 * q) > 0.0, "{q}");
    let frequency = column(&o, "thresholds", "frequency")[0];
    assert!(with_seal(24, q).iter().any(|s| s.re.abs() <= 1e-6 * frequency && (s.im - frequency).abs() <= 1e-6 * frequency), "{frequency}");
    let level = finding(&o, "level_1");
    assert!(level.level == Level::Warning && level.sentence().contains("Level 2"), "{}", level.sentence());
    // the division into elements moves it little
    near(q, finding(&run(&beside_slow_bodies(4, AT_MIDSPAN)), "threshold").value.unwrap(), 1e-2, "threshold");
}

/// The first forward mode is one of the shaft, not one of the bodies beside it, in which the place does not move: its decrement is that of the full matrices.
#[test]
fn first_forward_mode_moves_the_place() {
    for elements in [4, 24] {
        let f = finding(&run(&beside_slow_bodies(elements, AT_MIDSPAN)), "level_1").clone();
        // those of the bodies alone lie below 500 rad/s
        let shaft: Vec<C64> = with_seal(elements, 1e5).into_iter().filter(|s| s.im > 500.0).collect();
        let lowest = shaft.iter().map(|s| s.im).fold(f64::INFINITY, f64::min);
        let least = shaft.iter().filter(|s| s.im < 1.5 * lowest).map(|s| -TAU * s.re / s.im).fold(f64::INFINITY, f64::min);
        near(f.value.unwrap(), least, 1e-3, "decrement");
        assert!(least < 0.1 && f.sentence().contains("Level 2"), "{} {}", least, f.sentence());
    }
}

/// Modes that were not followed from the beginning are found by the count at the end, and followed back.
#[test]
fn missing_modes_are_followed_back() {
    let second = "[[part]]\nkind = \"disc\"\nname = \"other\"\nmass = 2.0\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"between\"\nbetween = [\"disc\", \"other\"]\nstiffness = 1e6\ndamping = 20.0\n[[study]]";
    let text = |modes: usize| {
        let text = mass(2e6, 2e6, 60.0, &format!("up_to = 6e5\nmodes = {modes}")).replace("[[study]]", second);
        let l = load(&text);
        let (place, speed, up_to) = (Attach::on("disc"), 300.0, Some(6e5));
        let study = StabilityThreshold {
            speed,
            place,
            up_to,
            points: 40,
            logarithmic: false,
            anticipated: None,
            gas_density: None,
            supports: vec![],
            modes,
        };
        let found: ThresholdResult = study.compute(&l.system, &Context::quiet("t")).unwrap();
        let mut q: Vec<f64> = found.lines.lines.iter().flat_map(|l| &l.crossings).map(|c| c.at.stiffness).collect();
        q.sort_by(f64::total_cmp);
        assert!(found.lines.lines.iter().flat_map(|l| &l.points).all(|p| decrement(p).is_finite()));
        (q, found.lines.growing.unwrap(), found.lines.lines.len())
    };
    let (all, counted, lines) = text(4);
    assert!(all.len() == 2 && counted == [2, 2] && lines == 4, "{all:?} {counted:?}");
    let (found, counted, lines) = text(1);
    assert!(counted == [2, 2] && lines == 2, "{counted:?} {lines}");
    assert!(found.iter().zip(&all).all(|(a, b)| (a - b).abs() <= 1e-10 * b), "{found:?} {all:?}");
}

#[test]
fn mistakes_have_their_place() {
    for (study, code, at) in [
        ("up_to = 1e5\nanticipated = 2e5", "stability_threshold.up_to", "1e5"),
        ("up_to = -1e5", "", "-1e5"),
        ("points = 1", "", "1"),
        ("gas_density = -3.0", "", "-3.0"),
        ("supports = \"disk\"", "study.supports", "disk"),
        ("gas_density = 3.0", "stability_threshold.gas_density", "3.0"),
    ] {
        let text = mass(2e6, 2e6, 300.0, study);
        let found = laval::file::load(&text).err().unwrap();
        let d = &found.0[0];
        assert!(code.is_empty() || d.code == code, "{d}");
        let span = d.span.clone().unwrap();
        assert!(text[span.start..span.end].contains(at), "{d}");
    }
    let text = mass(2e6, 2e6, 300.0, "").replace("place = \"disc\"", "place = \"wheel\"");
    let found = laval::file::load(&text).err().unwrap();
    assert!(found.0[0].code == "body.missing" && found.0[0].span.is_some(), "{:?}", found.0);
    let shaft = "[[part]]\nkind = \"shaft\"\nname = \"shaft\"\nsection = { length = [1.0], outer_diameter = [0.05] }\n[[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"shaft\", \"disc\"]\nstiffness = 1e7\n[[study]]";
    let text = mass(2e6, 2e6, 300.0, "").replace("[[study]]", shaft).replace("place = \"disc\"", "place = { body = \"shaft\", at = 1.2 }");
    let found = laval::file::load(&text).err().unwrap();
    assert!(found.0.iter().any(|d| d.code == "body.position" && d.span.is_some()), "{:?}", found.0);
}
