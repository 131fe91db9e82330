//! Recommended parameters: the tuned absorber against its own transfer function, limits and bounds against closed forms, what is said and refused.

use crate::common;

use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::outcome::{Finding, Outcome};
use laval::parts::{bearing_cubic::*, bearing_linear::*, damper::*, disc::*};
use laval::solve::harmonic::branches::response::Request;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::optimum::{Aim, Limit, Optimum, Vary};
use laval::study::{Context, ErasedStudy};

fn run(study: &Optimum, system: &System) -> Outcome {
    study.run(system, &Context::quiet("optimum")).unwrap_or_else(|d| panic!("{d:?}"))
}

fn said<'a>(o: &'a Outcome, id: &str, of: &str) -> &'a Finding {
    o.findings.iter().find(|f| f.id == id && f.subject == of).unwrap_or_else(|| panic!("no {id} of {of} in {:?}", o.findings))
}

fn evidence(f: &Finding, what: &str) -> f64 {
    f.evidence.iter().find(|e| e.what == what).unwrap_or_else(|| panic!("no {what} in {f:?}")).value
}

fn vary(system: &System, path: &str, from: f64, to: f64) -> Vary {
    let i = system.param(path).unwrap()[0];
    Vary { path: path.into(), unit: system.param_slots()[i].unit, from, to, now: system.params()[i] }
}

fn least(name: &str) -> Aim {
    Aim { name: name.into(), large: false, span: None }
}

#[track_caller]
fn near(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a:.12e} {b:.12e}");
}

const M: f64 = 10.0;
const K: f64 = 4e6;
const E: f64 = 1e-5;

/// A rotor on an undamped spring with an absorber of the mass ratio mu.
fn absorber(mu: f64) -> System {
    let linear = |k: f64| BearingLinearParams { kxx: k, kyy: k, ..BearingLinearParams::new() };
    Builder::new("absorber")
        .part("rotor", Disc::planar(), DiscParams { eccentricity: E, ..DiscParams::new(M) })
        .part("tuner", Disc::planar(), DiscParams::new(mu * M))
        .part("frame", BearingLinear::constant(Link::Between(Attach::on("rotor"), Attach::ground())), linear(K))
        .part(
            "spring",
            BearingCubic::isotropic(Link::Between(Attach::on("tuner"), Attach::on("rotor"))),
            BearingCubicParams { stiffness: [0.7 * mu * K; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 },
        )
        .part(
            "dashpot",
            Damper::fixed(Link::Between(Attach::on("tuner"), Attach::on("rotor"))),
            DamperParams { damping: [50.0; 2], tilt_damping: 0.0 },
        )
        .build()
        .unwrap()
}

/// |x|/e of the rotor at the speed g (over sqrt(K/M)), with the tuning f and the damping ratio z of the absorber: the closed form of two masses.
fn gain(mu: f64, f: f64, z: f64, g: f64) -> f64 {
    let (g2, f2) = (g * g, f * f);
    let top = (f2 - g2).hypot(2.0 * z * g * f);
    let re = (1.0 - g2) * (f2 - g2) - mu * f2 * g2;
    let im = 2.0 * z * g * f * (1.0 - g2 - mu * g2);
    g2 * top / re.hypot(im)
}

/// Minimum of a function with one minimum, by golden section.
fn golden(mut a: f64, mut b: f64, steps: usize, f: &dyn Fn(f64) -> f64) -> (f64, f64) {
    let r = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..steps {
        let (c, d) = (b - r * (b - a), a + r * (b - a));
        if f(c) < f(d) { b = d } else { a = c }
    }
    let x = 0.5 * (a + b);
    (x, f(x))
}

/// The highest peak over the speed.
fn peak(mu: f64, f: f64, z: f64) -> f64 {
    let n = 400;
    let at = |i: usize| 0.6 + 0.9 * i as f64 / n as f64;
    let high = |i: &usize| gain(mu, f, z, at(*i));
    let tops = (1..n).filter(|i| high(i) >= high(&(i - 1)) && high(i) >= high(&(i + 1)));
    tops.map(|i| -golden(at(i - 1), at(i + 1), 50, &|g| -gain(mu, f, z, g)).1).fold(0.0, f64::max)
}

/// The absorber of Den Hartog under unbalance. The fixed points, which all curves pass whatever the damping, are a lower bound that their height at the best tuning
/// gives: `|x|/e >= sqrt(2/(mu (1 + mu)))` (G. Warburton, 1982); the least highest peak lies just above, and both peaks are then as high.
#[test]
fn the_tuned_absorber_is_found() {
    {
        let mu = 0.2;
        let system = absorber(mu);
        let w0 = (K / M).sqrt();
        let study = Optimum {
            study: Box::new(NonlinearResponse::new(Request { stability: false, ..Request::over(0.6 * w0, 1.5 * w0) })),
            vary: vec![vary(&system, "spring.stiffness", 0.3 * mu * K, 2.0 * mu * K), vary(&system, "dashpot.damping", 5.0, 2000.0)],
            aim: least("largest_displacement_of rotor"),
            limits: vec![],
            starts: 2,
            runs: 400,
            tolerance: 0.05,
        };
        let o = run(&study, &system);
        let f = said(&o, "optimum", "largest_displacement_of rotor");
        let found = f.value.unwrap() / E;
        // by nested golden sections of the closed form
        let best_damping = |f: f64| golden(0.02, 0.6, 60, &|z| peak(mu, f, z));
        let (tuning, least) = golden(0.7, 1.1, 60, &|f| best_damping(f).1);
        let damping = best_damping(tuning).0;
        near(found, least, 1e-6);
        let bound = (2.0 / (mu * (1.0 + mu))).sqrt();
        assert!(found > bound && found < 1.03 * bound, "{found} {bound}");
        let k = said(&o, "recommended", "spring.stiffness");
        let c = said(&o, "recommended", "dashpot.damping");
        near(k.value.unwrap(), mu * M * (tuning * w0).powi(2), 2e-4);
        near(c.value.unwrap(), 2.0 * damping * mu * M * tuning * w0, 2e-3);
        near(tuning, (1.0 / (1.0 + mu)).sqrt(), 0.01);
        near(damping, (3.0 * mu / (8.0 * (1.0 + 0.5 * mu))).sqrt(), 0.05);
        // both searches arrived, and around it nothing is better
        assert_eq!(evidence(f, "searches that ended there"), 2.0, "{f:?}");
        let test = said(&o, "optimality", "");
        assert!(test.value.unwrap() > -1e-3 && test.evidence.len() == 1, "{test:?}");
        // within the recommended range the peak is 5 % higher at most, and reaches that at its ends
        for (finding, place) in [(k, 0), (c, 1)] {
            for side in ["recommended from", "to"] {
                let x = evidence(finding, side);
                let (f, z) = match place {
                    0 => ((x / (mu * M)).sqrt() / w0, c.value.unwrap() / (2.0 * (x * mu * M).sqrt())),
                    _ => (tuning, x / (2.0 * mu * M * tuning * w0)),
                };
                near(peak(mu, f, z), 1.05 * least, 2e-3);
            }
        }
    }
}

fn rotor(c: f64, k: f64) -> System {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    Builder::new("one disc")
        .part("disc", Disc::planar(), DiscParams { eccentricity: 1e-4, ..DiscParams::new(2.0) })
        .part("spring", BearingCubic::isotropic(link()), BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 })
        .part("air", Damper::fixed(link()), DamperParams { damping: [c; 2], tilt_damping: 0.0 })
        .build()
        .unwrap()
}

/// The peak `e/(2 D sqrt(1 - D^2))` falls with the damping: without a limit the upper bound is recommended and said to bind. With a limit on the largest force of the damper at
/// the top of the range, that decides.
#[test]
fn bounds_and_limits_bind() {
    let system = rotor(100.0, 1e6);
    let inner = || Box::new(NonlinearResponse::new(Request { stability: false, ..Request::over(100.0, 3000.0) }));
    let study = |limits| Optimum {
        study: inner(),
        vary: vec![vary(&system, "air.damping", 20.0, 500.0)],
        aim: least("largest_displacement"),
        limits,
        starts: 1,
        runs: 300,
        tolerance: 0.1,
    };
    let o = run(&study(vec![]), &system);
    let d = 500.0 / (2.0 * 2e6f64.sqrt());
    near(said(&o, "optimum", "largest_displacement").value.unwrap(), 1e-4 / (2.0 * d * (1.0 - d * d).sqrt()), 1e-8);
    let r = said(&o, "recommended", "air.damping");
    let text = r.sentence();
    assert!(r.value == Some(500.0) && text.contains("air.damping = 500 N s/m") && text.contains("the upper bound"), "{text}");
    // what changes per what, with units: the slope of the closed form at the bound
    let change = text.split("\"largest_displacement\" falls by ").nth(1).and_then(|t| t.split(" per 1 N s/m").next());
    let reported = laval::units::read_quantity(change.unwrap_or_else(|| panic!("{text}")), "m").unwrap();
    let slope = r.number("rate").unwrap();
    near(reported, slope, 5e-3);
    let peak = |c: f64| {
        let d = c / (2.0 * 2e6f64.sqrt());
        1e-4 / (2.0 * d * (1.0 - d * d).sqrt())
    };
    near(slope, (peak(499.9) - peak(500.1)) / 0.2, 2e-3);
    // slope from inside: nothing better within the bounds
    let test = said(&o, "optimality", "");
    assert!(test.value.unwrap() > 0.0 && test.message.key == "optimum-neighbours-worse", "{test:?}");
    // of the number over the present one, per whole range of the logarithm
    let reported =
        evidence(said(&o, "optimum", "largest_displacement"), "least slope in any direction tested, relative number per whole range");
    assert_eq!(test.value, Some(reported));
    near(reported, slope * 500.0 * 25f64.ln() / peak(100.0), 2e-3);
    // the largest force of the damper grows with it at the top of the range; where it is 120 N
    let force = |c: f64| {
        let o = inner().run(&rotor(c, 1e6), &Context::quiet("r")).unwrap();
        o.findings.iter().find(|f| f.id == "largest_force" && f.subject == "air").unwrap().value.unwrap()
    };
    assert!(force(20.0) < 120.0 && force(500.0) > 120.0, "{} {}", force(20.0), force(500.0));
    let (mut a, mut b) = (20.0, 500.0);
    for _ in 0..50 {
        let m = 0.5 * (a + b);
        if force(m) < 120.0 { a = m } else { b = m }
    }
    let o = run(
        &study(vec![Limit { name: "largest_force air".into(), value: 120.0, unit: Some("N".into()), upper: true, span: None }]),
        &system,
    );
    let r = said(&o, "recommended", "air.damping");
    near(r.value.unwrap(), a, 1e-5);
    assert!(r.number("rate").is_none() && !r.sentence().contains("falls by") && !r.sentence().contains("rises by"), "{r:?}");
    let l = said(&o, "limit_reached", "largest_force air");
    assert!(l.value.unwrap() <= 120.0 * (1.0 + 1e-9), "{l:?}");
    // a limit that no machine keeps
    let o = run(&study(vec![Limit { name: "largest_force air".into(), value: 1e-3, unit: None, upper: true, span: None }]), &system);
    assert!(o.findings.iter().any(|f| f.id == "no_optimum") && o.findings.iter().all(|f| f.id != "recommended"), "{:?}", o.findings);
}

/// A foundation in tune: the stiffness at which the bearing carries least force at one speed is mass times speed squared.
#[test]
fn a_foundation_is_tuned_to_a_speed() {
    let base = common::base::Base { isotropic: true, ..Default::default() };
    let system = base.builder().build().unwrap();
    let w = 1500.0;
    let study = Optimum {
        study: Box::new(NonlinearResponse::new(Request { stability: false, ..Request::over(w * (1.0 - 1e-6), w) })),
        vary: vec![vary(&system, "base.stiffness", 1e6, 2e8)],
        aim: least("largest_force bearing"),
        limits: vec![],
        starts: 2,
        runs: 200,
        tolerance: 0.5,
    };
    let o = run(&study, &system);
    near(said(&o, "recommended", "base.stiffness").value.unwrap(), 25.0 * w * w, 1e-4);
    // the table of tuned foundations has the law per axis; at this force it is linear
    near(said(&o, "optimum", "largest_force bearing").value.unwrap(), 9.88411, 1e-4);
}

/// A number the study does not find is refused with what there is; a unit that does not fit as well.
#[test]
fn refusals_say_what_to_do() {
    let system = rotor(100.0, 1e6);
    let study = |aim: &str, limits| Optimum {
        study: Box::new(NonlinearResponse::new(Request { stability: false, ..Request::over(100.0, 3000.0) })),
        vary: vec![vary(&system, "air.damping", 20.0, 500.0)],
        aim: least(aim),
        limits,
        starts: 1,
        runs: 50,
        tolerance: 0.1,
    };
    let d = study("largest_displacment", vec![]).run(&system, &Context::quiet("o")).err().unwrap();
    assert!(d.code == "optimum.number" && d.help.as_deref().is_some_and(|h| h.contains("did you mean \"largest_displacement\"?")), "{d:?}");
    let limit = Limit { name: "largest_force air".into(), value: 1.0, unit: Some("m".into()), upper: true, span: None };
    let d = study("largest_displacement", vec![limit]).run(&system, &Context::quiet("o")).err().unwrap();
    assert!(d.code == "optimum.unit", "{d:?}");
}
