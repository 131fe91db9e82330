//! One particle released: by the model of the study, in its run-up, with a velocity.

use laval::diagnostic::Severity;
use laval::file::load;
use laval::outcome::{Data, Outcome};
use laval::study::Context;

fn file(cup: &str, study: &str) -> String {
    format!(
        "[machine]\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = 10\n\
         [[cup]]\nname = \"cups\"\n{cup}\
         [suspension]\nliquid_density = 870\nviscosity = 0.01\nparticle_density = 2650\ndiameter = \"60 um\"\n\
         [[study]]\nkind = \"separation\"\nparticles = 16\npaths = 0\nrecovery = 1\nstart = \"slowest\"\n{study}"
    )
}

const SWINGING: &str =
    "kind = \"swinging\"\nhinge_radius = 0.2\ncup_radius = 0.045\nbottom = 0.3\nsurface = 0.02\ncentre_of_mass = 0.17\nhinge_damping = 3\n";
const TUBE: &str =
    "kind = \"fixed_angle\"\nmouth_radius = 0.1\nangle = \"40 deg\"\ntube_radius = 0.02\nlength = 0.12\ncentre_of_mass = 0.06\n";

fn run(text: &str) -> Outcome {
    let loaded = load(text).unwrap_or_else(|d| panic!("{d:?}"));
    loaded.studies[0].study.run(&loaded.system, &Context::quiet("s")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn value(o: &Outcome, id: &str) -> f64 {
    o.findings.iter().find(|f| f.id == id).and_then(|f| f.value).unwrap_or_else(|| panic!("no {id} in {:?}", o.findings))
}

fn column(o: &Outcome, name: &str) -> Vec<f64> {
    match &o.find_table("released").unwrap().column(name).unwrap_or_else(|| panic!("no {name}")).data {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

/// All particles are the one released, from the place where it takes longest: the time needed is the time of the release, whatever the model, with and without a run-up.
#[test]
fn a_release_is_one_of_the_batch() {
    let ramps = ["", "ramp = 20\n", "ramp = 20\nramp_shape = \"linear\"\n"];
    for (cup, from) in [(SWINGING, "[0, 0.02, 0]"), (TUBE, "[0, 0.03, 0]")] {
        for ramp in ramps {
            let at = |model: &str, from: &str| {
                let text = file(cup, &format!("speed = \"1000 rpm\"\n{ramp}model = \"{model}\"\nrelease = {from}\n"));
                // the slowest of a cup is on its axis; that of a tube is found with a recovery of all
                run(&if cup == TUBE { text.replace("start = \"slowest\"\n", "") } else { text.replace("recovery = 1", "recovery = 0.95") })
            };
            let mut times = Vec::new();
            for model in ["drifting", "exact"] {
                let o = at(model, from);
                let from = if cup == TUBE { slowest(&o) } else { from.to_string() };
                let o = at(model, &from);
                let (needed, released) = (value(&o, "time_needed"), value(&o, "released"));
                assert!((released / needed - 1.0).abs() < 1e-6, "{cup} {ramp} {model}: {released} {needed}");
                times.push(released);
            }
            // the two models are not the same one
            assert!((times[0] / times[1] - 1.0).abs() > 1e-5, "{times:?}");
        }
    }
}

/// The start of the last particle of a batch.
fn slowest(o: &Outcome) -> String {
    let f = o.findings.iter().find(|f| f.id == "time_needed").unwrap();
    let e = |what: &str| f.evidence.iter().find(|e| e.what == what).map_or(f64::NAN, |e| e.value);
    format!("[{}, {}, {}]", e("start of the last one, x"), e("y"), e("z"))
}

/// Velocities in the table are the slopes of the places, and the first one is the one given.
#[test]
fn velocities_are_the_rates_of_the_places() {
    for (cup, from) in [(SWINGING, "[0, 0.1, 0]"), (TUBE, "[0, 0.06, 0]")] {
        for ramp in ["", "ramp = 20\nramp_shape = \"linear\"\n"] {
            for model in ["drifting", "exact"] {
                let o = run(&file(cup, &format!("speed = \"1000 rpm\"\n{ramp}model = \"{model}\"\nrelease = {from}\n")));
                let t = column(&o, "time");
                for axis in ["x", "y", "z"] {
                    let (x, v) = (column(&o, axis), column(&o, &format!("{axis}'")));
                    let top = v.iter().fold(0.0f64, |m, v| m.max(v.abs())).max(1e-9);
                    for k in 2..t.len() - 2 {
                        let h = t[k + 1] - t[k];
                        if ((t[k] - t[k - 1]) / h - 1.0).abs() > 1e-6 || (ramp.len() > 1 && (t[k] - 20.0).abs() < 2.0 * h) {
                            continue;
                        }
                        let slope = (x[k + 1] - x[k - 1]) / (2.0 * h);
                        assert!((slope - v[k]).abs() < 0.02 * top, "{cup} {ramp} {model} {axis} {}: {slope} {}", t[k], v[k]);
                    }
                }
            }
        }
    }
}

/// Thrown into a cup held flat: the equations of motion in fixed-step integration of their own, W = R + i z of the plane and the height V.
#[test]
fn a_velocity_carries_the_particle() {
    let held = SWINGING.replace("centre_of_mass = 0.17\nhinge_damping = 3\n", "tilt = \"90 deg\"\n");
    let (w, thrown) = (30.0, [0.02, 0.9, 0.3]);
    let study = format!(
        "speed = {w}\nmodel = \"exact\"\nrelease = [0, 0.1, 0]\nrelease_velocity = [{}, {}, {}]\n",
        thrown[0], thrown[1], thrown[2]
    );
    let text = file(&held, &study).replace("\"60 um\"", "\"2 mm\"");
    let o = run(&text);
    let (rho, rho_f, mu, r0, g) = (2650.0, 870.0, 0.01, 1e-3, 9.80665);
    let (two_n, kappa) = (9.0 * mu / (2.0 * r0 * r0 * rho), (rho - rho_f) / rho);
    // in a flat cup y is the radius from the hinge on, x is up
    let rates = |s: [f64; 6]| {
        let [_, y, z, vx, vy, vz] = s;
        let radius = 0.2 + y;
        [
            vx,
            vy,
            vz,
            -kappa * g - two_n * vx,
            kappa * w * w * radius + 2.0 * w * vz - two_n * vy,
            kappa * w * w * z - 2.0 * w * vy - two_n * vz,
        ]
    };
    let end = value(&o, "released");
    let steps = 20_000;
    let h = end / f64::from(steps);
    let mut s = [0.0, 0.1, 0.0, thrown[0], thrown[1], thrown[2]];
    let shifted = |s: [f64; 6], k: [f64; 6], h: f64| std::array::from_fn(|i| s[i] + h * k[i]);
    for _ in 0..steps {
        let k1 = rates(s);
        let k2 = rates(shifted(s, k1, 0.5 * h));
        let k3 = rates(shifted(s, k2, 0.5 * h));
        let k4 = rates(shifted(s, k3, h));
        s = std::array::from_fn(|i| s[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    let last = |name: &str| *column(&o, name).last().unwrap();
    for (k, name) in ["x", "y", "z", "x'", "y'", "z'"].into_iter().enumerate() {
        assert!((last(name) - s[k]).abs() < 1e-6, "{name}: {} {}", last(name), s[k]);
        let first = column(&o, name)[0];
        assert!((first - [0.0, 0.1, 0.0, thrown[0], thrown[1], thrown[2]][k]).abs() < 1e-12, "{name}: {first}");
    }
}

#[test]
fn mistakes_of_a_velocity_are_reported() {
    let reported = |study: &str| load(&file(SWINGING, study)).err().map(|d| format!("{d:?}")).unwrap_or_default();
    assert!(reported("speed = 100\nrelease_velocity = [0, 1, 0]\n").contains("belongs to a particle"));
    assert!(reported("speed = 100\nrelease = [0, 0.1, 0]\nrelease_velocity = [0, 1]\n").contains("three components"));
    assert!(
        reported("speed = 100\nmodel = \"drifting\"\nrelease = [0, 0.1, 0]\nrelease_velocity = [0, 1, 0]\n")
            .contains("no velocity of its own")
    );
}

/// A run-up from standstill to standstill is refused at the field; without it gravity alone separates.
#[test]
fn a_run_up_to_standstill_is_refused() {
    let text = file(SWINGING, "speed = 0\nramp = \"20 s\"\n");
    let mut found = load(&text).err().unwrap().0;
    found.retain(|d| d.severity == Severity::Error);
    let [d] = found.as_slice() else { panic!("{found:?}") };
    assert!(d.code == "separation.ramp" && d.message.contains("two different speeds"), "{d:?}");
    assert!(text[d.span.clone().unwrap()].contains("20 s"), "{d:?}");
    assert!(load(&file(SWINGING, "speed = 0\n")).is_ok() && load(&file(SWINGING, "speed = 10\nramp = 20\n")).is_ok());
}
