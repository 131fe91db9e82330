//! Forced response: reference resonances, the Jeffcott rotor, critical speeds.

use crate::common;

use common::{Planar, number, rows};
use laval::model::builder::Builder;
use laval::model::field::{Attach, RangeValue};
use laval::model::part::Link;
use laval::model::system::System;
use laval::outcome::{Data, Finding, Outcome};
use laval::parts::{bearing_cubic::*, damper::*, disc::*};
use laval::solve::extrema::{curve, seeds};
use laval::solve::rest::rest;
use laval::study::forced_response::{ForcedResponse, at_speed};
use laval::study::{Context, ErasedStudy};
use std::sync::atomic::{AtomicU64, Ordering};

fn run(system: &System, from: f64, to: f64) -> Outcome {
    ForcedResponse::over(RangeValue { from, to, points: None }).run(system, &Context::quiet("response")).unwrap()
}

/// Speed and amplitude of the first extremum of a kind of a body.
fn first(out: &Outcome, body: &str, kind: &str) -> (f64, f64) {
    let t = out.find_table("extrema").unwrap();
    let text = |name: &str| match &t.column(name).unwrap().data {
        Data::Text(v) => v.clone(),
        _ => unreachable!(),
    };
    let row = text("body").iter().zip(&text("kind")).position(|(b, k)| b == body && k == kind).unwrap();
    (t.column("speed").unwrap().number(row).unwrap(), t.column("amplitude").unwrap().number(row).unwrap())
}

/// The table is that of one harmonic of the nonlinear bearing, stiffer by 3/4 c1 d^2 at the deflection d it has there: the linear machine with
/// that stiffness has the same state. Speed of the extremum, amplitudes of drum and base.
fn with_one_harmonic(system: &System, speed: f64, kind: &str) -> (f64, f64, f64) {
    let x = at_speed(system, speed).unwrap().unwrap();
    let d = (x.circles(0).0 - x.circles(2).0).abs();
    let stiffer = system.with(&[("bearing.stiffness", 1.1e7 + 0.75 * 8.7e10 * d * d)]).unwrap();
    let (speed, z1) = first(&run(&stiffer, 0.8 * speed, 1.2 * speed), "drum", kind);
    (speed, z1, at_speed(&stiffer, speed).unwrap().unwrap().major(2))
}

#[test]
fn first_resonance_and_antiresonance() {
    for r in rows(include_str!("../reference/planar/first_resonance.csv")) {
        let system = Planar { fill: number(r[0]), chi: number(r[1]), base: number(r[2]), ..Planar::default() }.build();
        let out = run(&system, 25.0, 8000.0);
        let (peak, dip) = (first(&out, "drum", "resonance").0, first(&out, "drum", "antiresonance").0);
        // by itself the linear machine is 1e-6 off at the resonance and 3e-5 at the antiresonance
        assert!((peak / number(r[3]) - 1.0).abs() < 1e-6 && (dip / number(r[7]) - 1.0).abs() < 5e-5, "{r:?}: {peak} {dip}");
        let (speed, z1, z2) = with_one_harmonic(&system, peak, "resonance");
        // a maximum is known to about the root of the rounding times its width (about 1 rad/s, or 20 with much damping)
        assert!((speed - number(r[3])).abs() < 2e-6, "{r:?}: {speed}");
        assert!((z1 / number(r[4]) - 1.0).abs() < 1e-9, "{r:?}: {z1}");
        assert!((z2 / number(r[5]) - 1.0).abs() < 1e-6, "{r:?}: {z2}");
        let (speed, z1, _) = with_one_harmonic(&system, dip, "antiresonance");
        assert!((speed / number(r[7]) - 1.0).abs() < 1e-8, "{r:?}: {speed}");
        // six digits are printed
        assert!((z1 / number(r[8]) - 1.0).abs() < 2e-6, "{r:?}: {z1}");
    }
}

#[test]
fn jeffcott_rotor() {
    let (m, e, k, d): (f64, f64, f64, f64) = (3.0, 2e-5, 4e6, 150.0);
    let system = Builder::new("Jeffcott")
        .part("disc", Disc::planar(), DiscParams { eccentricity: e, ..DiscParams::new(m) })
        .part(
            "shaft",
            BearingCubic::isotropic(Link::Between(Attach::on("disc"), Attach::ground())),
            BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 },
        )
        .part(
            "air",
            Damper::fixed(Link::Between(Attach::on("disc"), Attach::ground())),
            DamperParams { damping: [d; 2], tilt_damping: 0.0 },
        )
        .build()
        .unwrap();
    for w in [100.0, 1000.0, 1154.7, 3000.0] {
        let r = at_speed(&system, w).unwrap().unwrap();
        let (f, b) = r.circles(0);
        let amplitude = m * e * w * w / (k - m * w * w).hypot(d * w);
        assert!((f.abs() / amplitude - 1.0).abs() < 1e-12 && b.abs() < 1e-12 * amplitude);
        assert!((f.arg() + (d * w).atan2(k - m * w * w)).abs() < 1e-12);
    }
    // peak of the unbalance response: w0 / sqrt(1 - 2 D^2)
    let w0 = (k / m).sqrt();
    let ratio = d / (2.0 * (k * m).sqrt());
    let (peak, top) = first(&run(&system, 50.0, 4000.0), "disc", "resonance");
    assert!((peak / (w0 / (1.0 - 2.0 * ratio * ratio).sqrt()) - 1.0).abs() < 1e-8);
    assert!((top / (e / (2.0 * ratio * (1.0 - ratio * ratio).sqrt())) - 1.0).abs() < 1e-12);
}

/// The work does not depend on the size of the unbalance, down to amplitudes that have no digits left.
#[test]
fn small_unbalance_is_no_more_work() {
    use laval::solve::{extrema::curve, rest::rest};
    let rotor = |eccentricity: f64, stiffness: f64| {
        Builder::new("rotor")
            .part("disc", Disc::planar(), DiscParams { eccentricity, ..DiscParams::new(1.0) })
            .part(
                "shaft",
                BearingCubic::isotropic(Link::Between(Attach::on("disc"), Attach::ground())),
                BearingCubicParams { stiffness: [stiffness; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 },
            )
            .build()
            .unwrap()
    };
    let solved = |eccentricity: f64, stiffness: f64| {
        let system = rotor(eccentricity, stiffness);
        let speeds = (1..10).map(|k| 100.0 * f64::from(k)).collect();
        let mut work = 0;
        let found = curve(&system, &|w| rest(&system, w), speeds, &system.probes()[..1], &mut |n| {
            work = n;
            n < 100_000
        });
        assert!(found.unwrap().complete, "{eccentricity} {stiffness}: {work} systems solved");
        work
    };
    for stiffness in [2e5, 0.0] {
        let usual = solved(1e-5, stiffness);
        assert_eq!(solved(1e-5 * 2f64.powi(-960), stiffness), usual);
        assert!(solved(5e-324, stiffness) <= usual);
    }
}

#[test]
fn critical_speeds_of_an_undamped_empty_machine_are_its_frequencies() {
    use laval::study::critical_speeds::CriticalSpeeds;
    let system = Planar { chi: 0.0, chi0: 0.0, ..Planar::default() }.build();
    let study = CriticalSpeeds { speed: RangeValue { from: 20.0, to: 4000.0, points: None }, orders: vec![1.0, 2.0], margin: 0.1 };
    let out = study.run(&system, &Context::quiet("critical")).unwrap();
    let t = out.find_table("critical_speeds").unwrap();
    // forward and backward each
    let expected = [109.06465573, 2241.53479433].map(|w| [w, w, w / 2.0, w / 2.0]).concat();
    assert_eq!(t.rows(), expected.len());
    let mut found: Vec<f64> = (0..t.rows()).map(|k| t.column("speed").unwrap().number(k).unwrap()).collect();
    let mut expected = expected;
    found.sort_by(f64::total_cmp);
    expected.sort_by(f64::total_cmp);
    for (f, e) in found.iter().zip(&expected) {
        assert!((f / e - 1.0).abs() < 1e-10, "{f} {e}");
    }
}

#[test]
fn a_machine_at_rest_is_at_no_distance_from_its_critical_speeds() {
    use laval::study::critical_speeds::CriticalSpeeds;
    let study = CriticalSpeeds { speed: RangeValue { from: 20.0, to: 4000.0, points: None }, orders: vec![1.0], margin: 0.1 };
    let reported = |speed: f64| {
        let system = Planar { chi: 0.0, chi0: 0.0, ..Planar::default() }.builder().speed(speed).build().expect("a machine");
        let out = study.run(&system, &Context::quiet("critical")).expect("critical speeds");
        assert_eq!(out.find_table("critical_speeds").map(|t| t.rows()), Some(4), "{speed}");
        out.findings.iter().any(|f| f.id == "margin")
    };
    assert!(reported(100.0) && !reported(0.0));
}

#[test]
fn critical_speed_of_a_gyroscopic_tilt() {
    use laval::study::campbell::Campbell;
    // forward: A w^2 - C W w = k at w = W gives W^2 = k/(A - C); backward: W^2 = k/(A + C)
    let (a, cp, k, h): (f64, f64, f64, f64) = (0.02, 0.008, 800.0, 0.1);
    let spring = |z: f64| BearingCubic::isotropic(Link::Between(Attach::at("disc", z), Attach::ground()));
    let p = BearingCubicParams { stiffness: [k / (2.0 * h * h); 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 };
    let system = Builder::new("gyro")
        .part("disc", Disc::tilting(), DiscParams { diametral_inertia: a, polar_inertia: cp, ..DiscParams::new(4.0) })
        .part("upper", spring(h), p)
        .part("lower", spring(-h), p)
        .build()
        .unwrap();
    let study = Campbell {
        speed: RangeValue { from: 0.0, to: 400.0, points: Some(30) },
        orders: vec![1.0],
        threshold: 0.0,
        frequency: None,
        compare: false,
    };
    let out = study.run(&system, &Context::quiet("campbell")).unwrap();
    let t = out.find_table("critical_speeds").unwrap();
    let speeds: Vec<f64> = (0..t.rows()).map(|k| t.column("speed").unwrap().number(k).unwrap()).collect();
    for e in [(k / (a - cp)).sqrt(), (k / (a + cp)).sqrt(), (k / (h * h) / 4.0).sqrt()] {
        let d = speeds.iter().map(|s| (s / e - 1.0).abs()).fold(f64::INFINITY, f64::min);
        assert!(d < 1e-12, "{e} in {speeds:?}");
    }
    assert_eq!(speeds.len(), 4);
}

/// The response, found in x and y, satisfies the characteristic equations, written apart in forward and backward coordinates.
#[test]
fn the_response_satisfies_the_characteristic_equations() {
    use laval::solve::characteristic::Characteristic;
    use laval::solve::rest::rest;
    use laval_num::complex::c;
    let system = Planar { fill: 0.6, delta: 3.0, ..Planar::default() }.build();
    for speed in [60.0, 700.0, 2100.0] {
        let found = at_speed(&system, speed).unwrap().unwrap();
        let mut t = Characteristic::new(&system, &rest(&system, speed).unwrap());
        let (mut m, mut d) = Default::default();
        t.at(c(0.0, speed), &mut m, &mut d);
        let (_, mut load) = t.loads();
        t.sectors().polarise(&mut load);
        let mut x = found.x.clone();
        t.sectors().polarise(&mut x);
        let size = load.iter().map(|f| f.abs()).fold(0.0, f64::max);
        for (a, b) in m.mul_vec(&x).iter().zip(&load) {
            assert!((*a - *b).abs() < 1e-9 * size, "{speed}: {a:?} {b:?}");
        }
    }
}

/// A pole is said to be one, and no number stands for it; a damping ratio of 1e-7 is a resonance like any other.
#[test]
fn an_undamped_resonance_has_no_amplitude() {
    let rotor = |damping: f64| {
        Builder::new("rotor")
            .part("disc", Disc::planar(), DiscParams { eccentricity: 1e-5, ..DiscParams::new(2.0) })
            .part(
                "spring",
                BearingCubic::per_axis(Link::Between(Attach::on("disc"), Attach::ground())),
                BearingCubicParams { stiffness: [2e5; 2], cubic_stiffness: [0.0; 2], valid_to: 0.0 },
            )
            .part(
                "air",
                Damper::fixed(Link::Between(Attach::on("disc"), Attach::ground())),
                DamperParams { damping: [damping; 2], tilt_damping: 0.0 },
            )
            .build()
            .unwrap()
    };
    let (w, undamped) = (1e5f64.sqrt(), run(&rotor(0.0), 10.0, 600.0));
    let f = undamped.findings.iter().find(|f| f.id == "undamped_resonance").unwrap();
    assert!((f.value.unwrap() - w).abs() < 1e-7 * w, "{f:?}");
    assert!(f.evidence.iter().all(|e| e.what != "amplitude"));
    assert!(!undamped.findings.iter().any(|f| f.id == "largest_resonance"));
    let (at, amplitude) = first(&undamped, "disc", "resonance");
    assert!((at - w).abs() < 1e-7 * w && amplitude.is_nan());
    let t = undamped.find_table("response").unwrap();
    let largest = (0..t.rows()).filter_map(|k| t.column("amplitude.disc").unwrap().number(k)).fold(0.0, f64::max);
    assert!(largest < 100.0, "{largest}");
    // amplitude e/(2 D) at the resonance
    let damped = run(&rotor(2.0 * 1e-7 * (2e5f64 * 2.0).sqrt()), 10.0, 600.0);
    let (_, amplitude) = first(&damped, "disc", "resonance");
    assert!((amplitude / (1e-5 / 2e-7) - 1.0).abs() < 1e-5, "{amplitude}");
    assert!(!damped.findings.iter().any(|f| f.id == "undamped_resonance"));
}

/// Two springs of stiffness k at heights of 0.1 m hold a disc of 4 kg: displacement resonates at `sqrt(2 k/m)`, tilt at `sqrt(2 k h^2/(A - C))`. At either,
/// inside the range, at its end, or alone, no amplitude and no use of a validity has a number.
#[test]
fn without_bound_no_validity_has_a_number() {
    let (m, a, polar, k, h) = (4.0, 0.02, 0.008, 4e5f64, 0.1);
    let (sways, cones) = ((2.0 * k / m).sqrt(), (2.0 * k * h * h / (a - polar)).sqrt());
    let disc = DiscParams { eccentricity: 1e-5, diametral_inertia: a, polar_inertia: polar, skew: 1e-3, ..DiscParams::new(m) };
    let spring = |z: f64| BearingCubic::isotropic(Link::Between(Attach::at("disc", z), Attach::ground()));
    let machine = |damping: f64| {
        let law = BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [0.0; 2], valid_to: 1e-4 };
        let air = |z: f64| Damper::fixed(Link::Between(Attach::at("disc", z), Attach::ground()));
        let loss = DamperParams { damping: [damping; 2], tilt_damping: 0.0 };
        let sprung =
            Builder::new("conical").part("disc", Disc::tilting(), disc).part("upper", spring(h), law).part("lower", spring(-h), law);
        sprung.part("air above", air(h), loss).part("air below", air(-h), loss).build().unwrap()
    };
    let of = |o: &Outcome, id: &str| o.findings.iter().filter(|f| f.id == id).cloned().collect::<Vec<_>>();
    let undamped = machine(0.0);
    for (from, to) in [(100.0, 1000.0), (600.0, 1000.0), (600.0, cones), (cones, cones)] {
        let o = run(&undamped, from, to);
        let poles = of(&o, "undamped_resonance");
        assert!(poles.iter().any(|f| (f.value.unwrap() / cones - 1.0).abs() < 1e-6), "{from} {to}: {:?}", o.findings);
        let outside = of(&o, "validity");
        for part in ["disc", "upper", "lower"] {
            let named = |f: &&Finding| f.sentence().contains(&format!("\"{part}\""));
            let f = outside.iter().find(named).unwrap_or_else(|| panic!("{from} {to} {part}: {:?}", o.findings));
            assert!(f.value.is_none() && f.sentence().contains("is unbounded"), "{from} {to}: {}", f.sentence());
        }
        assert!(of(&o, "tilt").is_empty() && of(&o, "largest_tilt_resonance").is_empty(), "{from} {to}: {:?}", o.findings);
        let numbers = o.findings.iter().flat_map(|f| f.value.into_iter().chain(f.evidence.iter().map(|e| e.value)));
        assert!(numbers.into_iter().all(|x| x.abs() < 2e3), "{from} {to}: {:?}", o.findings);
        let t = o.find_table("response").unwrap();
        let last = t.column("validity").unwrap();
        assert!(to != cones || last.number(t.rows() - 1).is_none_or(f64::is_nan), "{from} {to}");
    }
    // beside the resonances, and with damping, all have numbers
    for (system, from, to) in [(&undamped, 500.0, 700.0), (&machine(40.0), 100.0, 1000.0), (&machine(40.0), cones, cones)] {
        let o = run(system, from, to);
        assert!(of(&o, "undamped_resonance").is_empty(), "{from} {to}: {:?}", o.findings);
        assert!(o.findings.iter().all(|f| !f.sentence().contains("unbounded")), "{from} {to}: {:?}", o.findings);
        assert!(of(&o, "validity").iter().all(|f| f.value.is_some_and(|x| x > 1.0)), "{from} {to}: {:?}", o.findings);
    }
    // nothing excites the backward whirl of the tilt: its critical speed is no pole
    let backward = (2.0 * k * h * h / (a + polar)).sqrt();
    let o = run(&undamped, backward, backward);
    assert!(of(&o, "undamped_resonance").is_empty() && of(&o, "tilt").len() == 1, "{:?}", o.findings);
    // a displacement alone, beside a tilt that stays bounded
    let o = run(&undamped, 300.0, sways);
    assert!((of(&o, "undamped_resonance")[0].value.unwrap() / sways - 1.0).abs() < 1e-6, "{:?}", o.findings);
    assert!(of(&o, "validity").iter().all(|f| !f.sentence().contains("\"disc\"")), "{:?}", o.findings);
}

/// Stopped early, a study claims only what it computed, and names the limit.
#[test]
fn stopped_early_nothing_is_claimed_of_the_rest() {
    let system = Planar::default().build();
    let context = Context { work_limit: 3, ..Context::quiet("response") };
    let study = ForcedResponse::over(RangeValue { from: 50.0, to: 4000.0, points: None });
    let out = study.run(&system, &context).unwrap();
    assert_eq!(out.end, laval::outcome::End::WorkLimit);
    assert!(out.end_in_words().contains("--work-limit"));
    let f = out.findings.iter().find(|f| f.id == "no_resonance").unwrap();
    assert!(f.sentence().contains("before the study stopped"), "{f:?}");
}

/// Twelve discs in a row: bodies share what the search for their extrema computes, and it ends where the amplitude is stationary.
#[test]
fn extrema_of_many_bodies_are_found_in_few_solutions() {
    let mut text = String::from("[machine]\nname = \"row\"\n");
    for i in 0..12 {
        text += &format!(
            "[[part]]\nkind = \"disc\"\nname = \"d{i}\"\nmass = {}\neccentricity = \"{} um\"\n",
            2.0 + 0.1 * f64::from(i % 5),
            10 + 3 * (i % 4)
        );
        text += &format!("[[part]]\nkind = \"damper\"\nname = \"c{i}\"\nbetween = [\"d{i}\", \"ground\"]\ndamping = 20\n");
    }
    for i in 0..=12 {
        let (a, b) =
            (if i == 0 { "ground".into() } else { format!("d{}", i - 1) }, if i == 12 { "ground".into() } else { format!("d{i}") });
        text += &format!("[[part]]\nkind = \"shaft_lumped\"\nname = \"s{i}\"\nbetween = [\"{a}\", \"{b}\"]\nstiffness = 1e6\n");
    }
    let system = laval::file::load(&text).unwrap_or_else(|d| panic!("{d:?}")).system;
    let states = AtomicU64::new(0);
    let state = |w: f64| {
        states.fetch_add(1, Ordering::Relaxed);
        rest(&system, w)
    };
    let mut speeds = RangeValue { from: 10.0, to: 1600.0, points: Some(5) }.linspace(5);
    speeds.extend(seeds(&system, &state, 10.0, 1600.0, &mut |_| true).unwrap().speeds);
    states.store(0, Ordering::Relaxed);
    let probes = system.probes();
    let found = curve(&system, &state, speeds, probes, &mut |_| true).unwrap();
    let searched = states.load(Ordering::Relaxed) - found.solved;
    assert!(found.extrema.len() > 100, "{}", found.extrema.len());
    // golden section takes more than forty for each
    assert!(searched < 10 * found.extrema.len() as u64, "{searched} solutions for {} extrema", found.extrema.len());
    for e in &found.extrema {
        let h = 1e-5 * e.speed;
        let value = |w: f64| at_speed(&system, w).unwrap().unwrap().size(&probes[e.probe]).ln();
        let (before, here, after) = (value(e.speed - h), value(e.speed), value(e.speed + h));
        assert!((here - e.value.ln()).abs() < 1e-10, "{e:?}");
        let bend = 2.0 * here - before - after;
        assert!(if e.maximum { bend > 0.0 } else { bend < 0.0 }, "{e:?}");
        // distance of the vertex of the parabola through the three
        let off = 0.5 * h * (after - before) / bend;
        assert!(off.abs() < 1e-7 * e.speed, "{e:?}: {off}");
    }
}

/// The major axis of an orbit against the orbit itself: its farthest point, and the principal axis of its points.
#[test]
fn the_major_axis_of_an_orbit_points_to_its_farthest_point() {
    let text = include_str!("../reference/spatial/s1.toml");
    let read = |text: &str| laval::file::load(text).unwrap().system;
    let (system, other) =
        (read(text), read(&text.replace("x = \"3e6", "u = \"3e6").replace("y = \"4e6", "x = \"4e6").replace("u = ", "y = ")));
    let turn = |a: f64| (a - std::f64::consts::PI * (a / std::f64::consts::PI).round()).abs();
    for speed in [90.0, 110.0, 250.0, 300.0, 420.0, 800.0] {
        let r = at_speed(&system, speed).unwrap().unwrap();
        for b in system.stations() {
            let (x, y) = {
                let [x, y] = b.lateral.amplitudes(&r.x);
                (x, y)
            };
            let count = 7200;
            let orbit = (0..count).map(|k| {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(count)).sin_cos();
                [x.re * cos - x.im * sin, y.re * cos - y.im * sin]
            });
            let far = orbit.clone().max_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1]))).unwrap();
            let of = |f: &dyn Fn([f64; 2]) -> f64| orbit.clone().map(f).sum::<f64>();
            let (xx, yy, xy) = (of(&|p| p[0] * p[0]), of(&|p| p[1] * p[1]), of(&|p| p[0] * p[1]));
            let principal = 0.5 * (2.0 * xy).atan2(xx - yy);
            let reported = r.direction(b.lateral.first().unwrap());
            assert!(reported > -std::f64::consts::FRAC_PI_2 && reported <= std::f64::consts::FRAC_PI_2, "{reported}");
            assert!(turn(reported - principal) < 1e-9, "{speed} {}: {reported} {principal}", b.name);
            assert!(turn(reported - far[1].atan2(far[0])) < 0.02, "{speed} {}: {reported} {far:?}", b.name);
            assert!(turn(reported) > 1e-4, "{speed} {}: {reported}", b.name);
        }
        // the study hands on the same
        let out = run(&system, speed, speed + 2.0);
        let column = out.find_table("response").unwrap().column("direction.base").unwrap().number(0).unwrap();
        assert_eq!(column, r.direction(system.stations()[1].lateral.first().unwrap()));
        // another machine has another axis
        let o = at_speed(&other, speed).unwrap().unwrap();
        assert!(turn(o.direction(other.stations()[1].lateral.first().unwrap()) - column) > 1e-4);
    }
    // a circle has none, a line along y has one
    let system = Planar::default().build();
    let mut r = at_speed(&system, 300.0).unwrap().unwrap();
    assert!(r.direction(0).is_nan() && r.major(0) > 0.0);
    (r.x[0], r.x[1]) = (laval_num::complex::C64::zero(), laval_num::complex::c(0.3, -0.4));
    assert_eq!(r.direction(0), std::f64::consts::FRAC_PI_2);
}

/// The largest force of a bearing over a turn is found between the instants that are looked at: closed form of a disc under its weight on unequal springs, by brute force over the turn.
#[test]
fn largest_forces_over_a_turn_are_exact() {
    let (m, e, k, c, w, g) = (12.0, 4e-5, [3e6, 5e6], [700.0, 900.0], 420.0, 9.80665);
    let text = format!(
        "[machine]\nname = \"disc\"\nspeed = {w:?}\naxis = \"horizontal\"\n[[part]]\nkind = \"disc\"\nname = \"d\"\nmass = {m:?}\neccentricity = {e:?}\neccentricity_phase = 0.37\n\
         [[part]]\nkind = \"bearing_linear\"\nname = \"b\"\nbetween = [\"d\", \"ground\"]\nkxx = {:?}\nkyy = {:?}\ncxx = {:?}\ncyy = {:?}\n\
         [[study]]\nkind = \"forced_response\"\nspeed = {w:?}\n",
        k[0], k[1], c[0], c[1]
    );
    let loaded = laval::file::load(&text).unwrap_or_else(|d| panic!("{d:?}"));
    let o = loaded.studies[0].study.run(&loaded.system, &Context::quiet("response")).unwrap_or_else(|d| panic!("{d:?}"));
    let t = o.tables.iter().find(|t| t.column("force.b").is_some()).expect("a force");
    let found = t.column("force.b").unwrap().number(0).unwrap();
    let spring = |i: usize| laval_num::complex::c(k[i], w * c[i]);
    let amplitude = |i: usize, f: laval_num::complex::C64| f * spring(i) / (spring(i) - laval_num::complex::c(m * w * w, 0.0));
    let unbalance = laval_num::complex::C64::cis(0.37).scale(m * e * w * w);
    let [x, y] = [amplitude(0, unbalance), amplitude(1, -unbalance.mul_i())];
    let size = |phase: f64| {
        let turn = laval_num::complex::C64::cis(phase);
        (x * turn).re.hypot((y * turn).re - m * g)
    };
    let exact = (0..400_000).map(|j| size(std::f64::consts::TAU * f64::from(j) / 400_000.0)).fold(0.0, f64::max);
    assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact}");
    let sampled = (0..24).map(|j| size(std::f64::consts::TAU * f64::from(j) / 24.0)).fold(0.0, f64::max);
    assert!(sampled < exact * (1.0 - 1e-4), "{sampled} {exact}");
}
