//! Several unbalances in one disc, from files: against the two complex equations of a rigid rotor on isotropic bearings, and against one unbalance that is
//! their sum.

use laval::diagnostic::Severity;
use laval::file::load;
use laval::model::field::{Field, FieldKind};
use laval::model::system::System;
use laval::study::forced_response::at_speed;
use laval::study::registry;
use laval_num::complex::{C64, c};

/// A rotor on two bearings, 120 mm below and 260 mm above its centre of mass.
fn rotor(unbalances: &str) -> System {
    let text = format!(
        "[machine]\nspeed = 300\n\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 40\ndiametral_inertia = 0.9\npolar_inertia = 1.4\n{unbalances}\n\n\
         [[part]]\nkind = \"bearing_linear\"\nbetween = [{{ body = \"rotor\", at = \"-120 mm\" }}, \"ground\"]\nkxx = 1.2e7\nkyy = 1.2e7\n\n\
         [[part]]\nkind = \"bearing_linear\"\nbetween = [{{ body = \"rotor\", at = \"260 mm\" }}, \"ground\"]\nkxx = 0.8e7\nkyy = 0.8e7\n"
    );
    load(&text).unwrap_or_else(|d| panic!("{d:?}\n{text}")).system
}

/// Displacement and slope that turn with the rotor.
fn motion(system: &System, w: f64) -> [f64; 2] {
    let x = at_speed(system, w).unwrap().unwrap();
    [x.circles(0).0.abs(), x.circles(2).0.abs()]
}

/// Of unbalances (kg m) in directions (rad) at heights (m): `(K - m W^2) z + K1 s = W^2 sum u`, `K1 z + (K2 - (A - C) W^2) s = W^2 sum u z`.
fn expected(all: &[(f64, f64, f64)], w: f64) -> [f64; 2] {
    let springs = [(1.2e7, -0.12), (0.8e7, 0.26)];
    let k = |n: i32| springs.iter().map(|(k, l): &(f64, f64)| k * l.powi(n)).sum::<f64>();
    let sum = |n: i32| all.iter().map(|(u, p, z)| C64::cis(*p).scale(u * z.powi(n))).fold(C64::zero(), |a, b| a + b).scale(w * w);
    let (a, b, d) = (k(0) - 40.0 * w * w, k(1), k(2) - (0.9 - 1.4) * w * w);
    let det = a * d - b * b;
    [(sum(0).scale(d) - sum(1).scale(b)).scale(1.0 / det).abs(), (sum(1).scale(a) - sum(0).scale(b)).scale(1.0 / det).abs()]
}

#[test]
fn unbalances_in_two_planes_are_those_of_a_rigid_rotor() {
    let deg = std::f64::consts::PI / 180.0;
    let list = "unbalances = { unbalance = [\"30 g mm\", \"20 g mm\"], phase = [\"40 deg\", \"-160 deg\"], at = [\"10 mm\", \"-80 mm\"] }";
    let system = rotor(list);
    for w in [100.0, 300.0, 900.0] {
        let (found, want) = (motion(&system, w), expected(&[(30e-6, 40.0 * deg, 0.01), (20e-6, -160.0 * deg, -0.08)], w));
        for (f, w) in found.iter().zip(&want) {
            assert!((f - w).abs() < 1e-9 * w, "{found:?} {want:?}");
        }
    }
}

/// In the plane of the centre of mass they are one; beside an eccentricity they add to it.
#[test]
fn unbalances_in_one_plane_are_their_sum() {
    let (u, v) = (C64::cis(0.3).scale(30e-6), C64::cis(2.0).scale(25e-6));
    let own = c(40.0 * 1e-6, 0.0);
    let sum = u + v + own;
    let several = rotor("eccentricity = 1e-6\nunbalances = { unbalance = [30e-6, 25e-6], phase = [0.3, 2.0] }");
    let one = rotor(&format!("unbalance = {:e}\neccentricity_phase = {}", sum.abs(), sum.arg()));
    for w in [100.0, 300.0, 900.0] {
        let (a, b) = (motion(&several, w), motion(&one, w));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-11 * b && *b > 0.0), "{a:?} {b:?}");
    }
}

#[test]
fn unbalances_without_sense_are_refused() {
    for (list, what) in [
        ("{ phase = [0.1] }", "no column \"unbalance\""),
        ("{ unbalance = [1e-5, 2e-5], phase = [0.1] }", "differ in length"),
        ("{ unbalance = [\"-30 g mm\"] }", "an unbalance of"),
        ("{ unbalance = [\"30 g\"] }", "30 g"),
    ] {
        let text = format!("[machine]\nspeed = 300\n\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 40\nunbalances = {list}\n");
        let reported = load(&text).err().unwrap_or_else(|| panic!("{text}")).0.iter().map(|d| format!("{d}")).collect::<String>();
        assert!(reported.contains(what), "{list}: {reported}");
    }
    let flat = "[machine]\nspeed = 300\n\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 40\nunbalances = { unbalance = [1e-5], at = [0.1] }\n";
    assert!(load(flat).err().is_some_and(|d| d.0.iter().any(|d| d.message.contains("does not tilt"))));
}

/// Every field of a study by which a parameter is varied, with a block that is right but for the PATH.
const VARYING: &[(&str, &str, &str)] = &[
    ("stability_map", "parameter", "speed = { from = 100, to = 900 }\nparameter = { parameter = \"PATH\", from = 1, to = 2 }"),
    ("bifurcation_loci", "parameter", "speed = { from = 100, to = 900 }\nparameter = { parameter = \"PATH\", from = 1, to = 2 }"),
    (
        "response_map",
        "x",
        "speed = { from = 100, to = 900 }\nx = { parameter = \"PATH\", from = 1, to = 2 }\ny = { parameter = \"rotor.mass\", from = 30, to = 40 }",
    ),
    (
        "response_map",
        "y",
        "speed = { from = 100, to = 900 }\ny = { parameter = \"PATH\", from = 1, to = 2 }\nx = { parameter = \"rotor.mass\", from = 30, to = 40 }",
    ),
    ("stationary", "stabilise", "speed = { from = 100, to = 900 }\nstabilise = { parameter = \"PATH\", from = 1, to = 2 }"),
    ("stationary", "chart", "speed = { from = 100, to = 900 }\nchart = { parameter = \"PATH\", from = 1, to = 2 }"),
    ("stationary", "errors", "speed = { from = 100, to = 900 }\nerrors = [{ parameter = \"PATH\", from = 0, to = 2 }]"),
    ("operating_window", "map", "speed = { from = 100, to = 900 }\nmap = { parameter = \"PATH\", from = 1, to = 2 }"),
    ("motion_map", "y", "y = { parameter = \"PATH\", from = 1, to = 2 }"),
    ("motion_map", "x", "x = { parameter = \"PATH\", from = 1, to = 2 }\ny = { parameter = \"rotor.mass\", from = 30, to = 40 }"),
    (
        "uncertainty",
        "parameters",
        "study = { kind = \"modes\" }\nparameters = [{ parameter = \"PATH\", distribution = \"uniform\", from = 1, to = 2 }]",
    ),
    ("optimum", "vary", "study = { kind = \"modes\" }\nmaximise = \"x\"\nvary = [{ parameter = \"PATH\", from = 1, to = 2 }]"),
];

/// Unbalances are varied by the number of their row: a study that names one otherwise is refused at its place in words that say how, and what it can vary.
#[test]
fn rows_of_a_list_are_named_by_number_in_every_study_that_varies_parameters() {
    let varies = |f: &&Field| {
        matches!(f.kind, FieldKind::ParameterPath | FieldKind::ParameterRange | FieldKind::ParameterRanges | FieldKind::Tolerances)
    };
    let all = registry().into_iter().flat_map(|k| k.info.fields.iter().filter(varies).map(|f| (k.info.kind, f.name)).collect::<Vec<_>>());
    let known: Vec<(&str, &str)> = VARYING.iter().map(|v| (v.0, v.1)).collect();
    assert_eq!(all.filter(|a| !known.contains(a)).collect::<Vec<_>>(), []);
    let machine = "[machine]\nspeed = 300\n\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 40\n\
                   unbalances = { unbalance = [\"30 g mm\", \"20 g mm\"], phase = [0, 2] }\n\n\
                   [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"rotor\", \"ground\"]\nkxx = 1.2e7\nkyy = 1.2e7\n\n[[study]]\n";
    let refused = |kind: &str, study: String, path: &str| {
        let text = format!("{machine}kind = \"{kind}\"\n{study}\n");
        let reported = load(&text).err().unwrap_or_else(|| panic!("{kind} varies {path}")).0;
        let errors: Vec<_> = reported.iter().filter(|d| d.severity == Severity::Error).collect();
        let [d] = errors[..] else { panic!("{kind} {path}: {reported:?}") };
        assert_eq!(d.code, "parameter.unknown", "{kind}: {d:?}");
        assert!(d.message.contains(path) && d.message.contains("\"unbalances\" is a list"), "{kind}: {}", d.message);
        let says = |what: &str| d.help.as_deref().is_some_and(|h| h.contains(what));
        assert!(says("unbalances[1].phase") && says("eccentricity_phase"), "{kind}: {:?}", d.help);
        let place = d.span.clone().map(|s| text[s.start..s.end].to_string()).unwrap_or_default();
        assert!(place.contains(path), "{kind}: {place}");
    };
    for (kind, _, study) in VARYING {
        refused(kind, study.replace("PATH", "rotor.unbalances.1.unbalance"), "rotor.unbalances.1.unbalance");
    }
    for path in ["rotor.unbalances", "rotor.unbalances.unbalance", "rotor.unbalances[0].phase"] {
        refused("stability_map", VARYING[0].2.replace("PATH", path), path);
    }
    refused(
        "operating_window",
        "speed = { from = 100, to = 900 }\nuncertain = { \"rotor.unbalances.1.phase\" = 0.1 }".into(),
        "rotor.unbalances.1.phase",
    );
    for path in ["rotor.unbalance", "rotor.unbalances[2].unbalance"] {
        let one = VARYING[0].2.replace("PATH", path);
        assert!(load(&format!("{machine}kind = \"stability_map\"\n{one}\n")).is_ok(), "{path}");
    }
}
