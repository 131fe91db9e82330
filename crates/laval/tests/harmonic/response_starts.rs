//! Where the branches of a response begin, which jumps a slow sweep meets, and from where displacements of a machine that sags count.

use crate::common;

use common::base::{request, run};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::outcome::{Arg, Data, Outcome};
use laval::parts::{bearing_cubic::*, bearing_hertz::*, damper::*, disc::*};
use laval::solve::harmonic::branches::branch::Origin;
use laval::solve::harmonic::branches::response::Request;
use laval::study::nonlinear_response::NonlinearResponse;
use laval::study::sensitivity::Sensitivity;
use laval::study::{Context, ErasedStudy};

const M: f64 = 5.0;
const E: f64 = 15e-6;
const HERTZ: f64 = 3e9;
const GAP: f64 = 10e-6;

fn link() -> Link {
    Link::Between(Attach::on("rotor"), Attach::ground())
}

/// A rotor held by nothing but a bearing with clearance: at rest its place is open.
fn clearance(damping: f64) -> Builder {
    Builder::new("clearance")
        .part("rotor", Disc::planar(), DiscParams { eccentricity: E, ..DiscParams::new(M) })
        .part("bearing", BearingHertz::radial(link()), BearingHertzParams { coefficient: HERTZ, clearance: GAP })
        .part("loss", Damper::fixed(link()), DamperParams { damping: [damping; 2], tilt_damping: 0.0 })
}

/// `|F(a) - m W^2 a + i c W a| - m e W^2` of circular motion, N.
fn unbalanced(damping: f64, w: f64, a: f64) -> f64 {
    let force = HERTZ * (a - GAP).max(0.0).powf(1.5);
    (force - M * w * w * a).hypot(damping * w * a) - M * E * w * w
}

/// Least amplitude of circular motion in contact at a speed.
fn least_in_contact(damping: f64, w: f64) -> f64 {
    let (mut a, step) = (GAP, 1e-3 * GAP);
    while (unbalanced(damping, w, a) > 0.0) == (unbalanced(damping, w, a + step) > 0.0) {
        a += step;
    }
    let (mut lo, mut hi) = (a, a + step);
    for _ in 0..100 {
        let mid = 0.5 * (lo + hi);
        if (unbalanced(damping, w, mid) > 0.0) == (unbalanced(damping, w, lo) > 0.0) { lo = mid } else { hi = mid }
    }
    lo
}

#[test]
fn the_motion_at_the_slow_end_is_found_in_contact() {
    for damping in [300.0, 3000.0] {
        for from in [100.0, 150.0, 300.0, 1800.0] {
            let r = run(clearance(damping), request(from, 2500.0));
            assert!(r.unstarted.is_empty(), "{damping} {from}: {:?}", r.unstarted);
            let low = r.branches.iter().find(|b| b.origin == Origin::Low).unwrap_or_else(|| panic!("{damping} {from}"));
            let first = low.points[0].x[0].hypot(low.points[0].x[1]);
            assert!(unbalanced(damping, from, first).abs() < 1e-6 * M * E * from * from, "{damping} {from} {first}");
            // with little damping the free rotor would whirl beyond the clearance
            if from == 100.0 && unbalanced(damping, from, GAP) < 0.0 {
                let want = least_in_contact(damping, from);
                assert!((first - want).abs() < 1e-9 * want, "{damping} {first} {want}");
            }
        }
    }
}

fn speeds(o: &Outcome, id: &str) -> Vec<f64> {
    o.findings.iter().filter(|f| f.id == id).map(|f| f.value.unwrap()).collect()
}

/// Two loops, one above the other: a sweep jumps twice each way.
#[test]
fn a_sweep_tells_every_jump_it_meets() {
    let system = clearance(3000.0).build().unwrap();
    let o = NonlinearResponse::new(Request::over(100.0, 2500.0)).run(&system, &Context::quiet("response")).unwrap();
    let (up, down) = (speeds(&o, "jump_up"), speeds(&o, "jump_down"));
    assert!(up.len() == 2 && down.len() == 2, "{up:?} {down:?}");
    assert!(up[0] < up[1] && down[0] > down[1] && down[0] < up[1] && down[1] < up[0] && down[0] > up[0], "{up:?} {down:?}");
    // where circular motions merge: the amplitudes on both sides of a fold have no motion between them
    for w in [up.clone(), down.clone()].concat() {
        let count = |w: f64| {
            let at = |k: i32| unbalanced(3000.0, w, 1e-8 * f64::from(k)) > 0.0;
            (1..20_000).filter(|&k| at(k) != at(k - 1)).count()
        };
        assert_eq!(count(w * (1.0 - 1e-4)).abs_diff(count(w * (1.0 + 1e-4))), 2, "{w}");
    }
    // a range that ends within the upper loop: the states from high speed end at its lower fold, and the sweep goes on with those from low speed
    let o = NonlinearResponse::new(Request::over(100.0, 0.5 * (down[0] + up[1]))).run(&system, &Context::quiet("response")).unwrap();
    let cut = speeds(&o, "jump_down");
    assert!(cut.len() == 2 && cut.iter().zip(&down).all(|(a, b)| (a - b).abs() < 1e-7 * b), "{cut:?} {down:?}");
    let reported: Vec<bool> =
        o.findings.iter().filter(|f| f.id == "jump_down").map(|f| f.sentence().contains("onto the branch from low speed")).collect();
    assert_eq!(reported, [true, false]);
    let several = |a: &(&str, Arg)| matches!(a, ("stable", Arg::Count(2..)));
    assert!(!o.findings.iter().flat_map(|f| &f.notes).any(|n| n.args.iter().any(several)), "{:?}", o.findings);
    assert_eq!(speeds(&o, "jump_up").len(), 1);
}

/// A rotor on a spring with a cubic part.
fn sprung(cubic: f64, horizontal: bool) -> System {
    let b = Builder::new("sprung")
        .part("rotor", Disc::planar(), DiscParams { eccentricity: 2e-5, ..DiscParams::new(10.0) })
        .part(
            "spring",
            BearingCubic::per_axis(link()),
            BearingCubicParams { stiffness: [1e6; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 },
        )
        .part("air", Damper::fixed(link()), DamperParams { damping: [300.0; 2], tilt_damping: 0.0 });
    if horizontal { b.horizontal() } else { b }.build().unwrap()
}

fn column(o: &Outcome, table: &str, name: &str) -> Vec<f64> {
    match &o.find_table(table).unwrap().column(name).unwrap().data {
        Data::Float(v) => v.clone(),
        other => panic!("{other:?}"),
    }
}

/// The motion of a linear machine about its rest does not know where that is.
#[test]
fn displacements_count_from_rest() {
    let of = |horizontal| {
        let system = sprung(0.0, horizontal);
        NonlinearResponse::new(Request::over(100.0, 900.0)).run(&system, &Context::quiet("response")).unwrap()
    };
    let [upright, lying] = [false, true].map(of);
    let [a, b] = [&upright, &lying].map(|o| speeds(o, "largest_displacement")[0]);
    assert!((a - b).abs() < 1e-9 * a, "{a} {b}");
    for name in ["rotor largest displacement", "rotor largest x"] {
        let (speed, seen) = (column(&lying, "response", "speed"), column(&lying, "response", name));
        for (w, a) in speed.iter().zip(seen) {
            let want = 10.0 * 2e-5 * w * w / (1e6 - 10.0 * w * w).hypot(300.0 * w);
            assert!((a - want).abs() < 1e-7 * want, "{name} {w} {a} {want}");
        }
    }
}

/// The derivative of the peak of a machine that sags more as its parameters change, against differences of the whole study.
#[test]
fn peaks_of_a_sagging_machine_have_derivatives() {
    let system = sprung(2e13, true);
    let peak = |system: &System| {
        let o = Sensitivity::new(Request { harmonics: Some(9), ..Request::over(250.0, 420.0) }).run(system, &Context::quiet("s")).unwrap();
        let (places, slopes) = (column(&o, "places", "displacement"), column(&o, "sensitivities", "displacement slope"));
        let k = (0..places.len()).max_by(|&a, &b| places[a].total_cmp(&places[b])).unwrap();
        let Data::Int(place) = &o.find_table("sensitivities").unwrap().column("place").unwrap().data else { panic!() };
        let Data::Text(paths) = &o.find_table("sensitivities").unwrap().column("parameter").unwrap().data else { panic!() };
        let own = (0..paths.len()).filter(|&r| place[r] == k as i64 + 1).map(|r| (paths[r].clone(), slopes[r])).collect::<Vec<_>>();
        (places[k], own)
    };
    let (_, slopes) = peak(&system);
    for path in ["rotor.mass", "rotor.eccentricity", "air.damping.x", "spring.stiffness.y"] {
        let i = system.param(path).unwrap()[0];
        let value = system.params()[i];
        let at = |share: f64| peak(&system.with(&[(path, value * (1.0 + share))]).unwrap()).0;
        let difference = |h: f64| (at(h) - at(-h)) / (2.0 * h * value);
        // of order 2: extrapolated
        let want = (4.0 * difference(1e-3) - difference(2e-3)) / 3.0;
        let found = slopes.iter().find(|s| s.0 == path).unwrap_or_else(|| panic!("{path} {slopes:?}")).1;
        assert!((found - want).abs() < 1e-5 * want.abs(), "{path} {found:e} {want:e}");
    }
}
