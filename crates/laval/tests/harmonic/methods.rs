//! Approximate methods beside the converged motion: the reference table, orders of convergence, exact cases, slow-time stability.

use crate::common;

use common::base::{Base, request, run, states_at};
use common::{number, rows};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, damper::*, disc::*};
use laval::solve::harmonic::balance::elliptic::{law, parameter};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::methods::{Comparison, Method, Value, compare, orders};
use laval::solve::harmonic::branches::response::{Request, Response};
use laval::solve::symmetry::Symmetry;
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

fn compared(builder: Builder, range: (f64, f64), speeds: &[f64], most: usize) -> (System, Response, Comparison) {
    let system = builder.clone().build().unwrap();
    let request = Request { stability: false, ..request(range.0, range.1) };
    let r = run(builder.clone(), request);
    let lower: Vec<(usize, Response)> =
        orders(&r, most).into_iter().map(|h| (h, run(builder.clone(), Request { harmonics: Some(h), ..request }))).collect();
    let c = compare(&system, &r, range, speeds, &lower, &NEVER, &|_| {}).unwrap();
    (system, r, c)
}

fn of(c: &Comparison, method: Method, speed: f64) -> Vec<&Value> {
    c.values.iter().filter(|v| v.method == method && v.speed == speed).collect()
}

/// Every row: one harmonic, elliptic balance, converged. The table's converged columns are the largest of 256 samples of a period, the peak itself lies
/// up to 8.8e-5 above; its elliptic columns are sampled too and up to 1.6e-5 below the peak.
#[test]
fn methods_of_the_table() {
    let (w0, e, range) = (2140.872096444188, 1e-3, (40.0, 7600.0));
    let table = rows(include_str!("../reference/planar/methods_compared.csv"));
    let mut speeds: Vec<f64> = table.iter().map(|r| number(r[0]) * w0).collect();
    speeds.dedup();
    let (system, response, c) = compared(Base::default().builder(), range, &speeds, 1);
    let mut balance = Balance::new(&system, response.discretisation, range, None).unwrap();
    let mut wrong = Vec::new();
    for r in &table {
        let speed = number(r[0]) * w0;
        let state = match r[1] {
            "1" | "l" => 0,
            "m" => 1,
            _ => 2,
        };
        let value = |method: Method| of(&c, method, speed).into_iter().find(|v| v.state == state).cloned();
        // the table's digits: eight for the balance, six for elliptic balance; blank where the table has none
        let mut check = |what: &str, got: f64, want: f64, tolerance: f64| {
            if want.is_finite() && !((got - want).abs() <= tolerance) {
                wrong.push(format!("{} {} {what}: {got} wanted {want}", r[0], r[1]));
            }
        };
        let (one, elliptic, exact) = (value(Method::Harmonic(1)), value(Method::Elliptic), value(Method::Converged));
        for body in 0..2 {
            let peak = |v: &Option<Value>| v.as_ref().map_or(f64::NAN, |v| v.peaks[body] / e);
            check("one harmonic", peak(&one), number(r[2 + body]), 0.6e-8 + 1e-9 * number(r[2 + body]));
            let want = number(r[4 + body]);
            check("elliptic balance", peak(&elliptic), want * (1.0 + 8e-6), 0.6e-6 + 9e-6 * want);
            let want = number(r[7 + body]);
            check("converged", peak(&exact), want, 9e-5 * want);
        }
        check("k2", elliptic.map_or(f64::NAN, |v| v.parameter), number(r[6]), 0.6e-6);
        let mut states = states_at(&system, &response, range, speed, false);
        states.sort_by(|a, b| a.z[0].total_cmp(&b.z[0]));
        let orbit = Orbit::of(&mut balance, &states[state].x, speed).unwrap();
        for body in 0..2 {
            let at = |j: usize| orbit.probe_at(&system.probes()[body], std::f64::consts::TAU * j as f64 / 256.0)[0][0].abs();
            let sampled = (0..256).map(at).fold(0.0, f64::max) / e;
            check("256 samples", sampled, number(r[7 + body]), 1e-6 * number(r[7 + body]));
        }
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}

/// Deviations fall with every order; integration in time agrees with the converged motion; averaging has the states of one harmonic.
#[test]
fn deviations_fall_with_the_orders() {
    let speeds = [1500.0, 2400.0, 2900.0];
    let (_, r, c) = compared(Base { chi: 600.0, ..Base::default() }.builder(), (800.0, 3600.0), &speeds, 7);
    assert_eq!(orders(&r, 7), [1, 3, 5, 7]);
    let mut seen = 0;
    for speed in speeds {
        for v in of(&c, Method::Converged, speed) {
            let by = |m: Method| of(&c, m, speed).into_iter().find(|o| o.state == v.state).unwrap().clone();
            let d: Vec<f64> = orders(&r, 7).into_iter().map(|h| by(Method::Harmonic(h)).deviation).collect();
            assert!(d.windows(2).all(|w| w[1] < 0.5 * w[0] || w[1] < 1e-9), "{speed} {d:?}");
            assert_eq!(by(Method::Averaging).peaks, by(Method::Harmonic(1)).peaks);
            assert!(by(Method::Time).deviation < 1e-6, "{speed}: {}", by(Method::Time).deviation);
            seen += 1;
        }
    }
    assert!(seen >= 3, "{seen}");
}

/// One lightly damped body: the slow motion is the only one near the speed, and its growth is that of the exact exponents up to their ratio to the frequency.
#[test]
fn averaging_assesses_one_mode() {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let builder = |cubic: f64| {
        Builder::new("one body")
            .part("disc", Disc::planar(), DiscParams { eccentricity: 2e-5, ..DiscParams::new(3.0) })
            .part(
                "spring",
                BearingCubic::per_axis(link()),
                BearingCubicParams { stiffness: [2e6; 2], cubic_stiffness: [cubic; 2], valid_to: 0.0 },
            )
            .part("air", Damper::fixed(link()), DamperParams { damping: [20.0; 2], tilt_damping: 0.0 })
    };
    let w0 = f64::sqrt(2e6 / 3.0);
    let speeds = [0.9 * w0, 1.05 * w0, 1.1 * w0];
    let (_, _, c) = compared(builder(3e12), (0.5 * w0, 1.6 * w0), &speeds, 3);
    let (mut unstable, mut seen) = (0, 0);
    for v in c.values.iter().filter(|v| v.method == Method::Averaging) {
        let exact = of(&c, Method::Converged, v.speed).into_iter().find(|o| o.state == v.state).unwrap().growth;
        assert_eq!(v.growth > 0.0, exact > 0.0, "{} {exact}", v.growth);
        // damping over twice the mass, and detuning over the speed
        assert!((v.growth - exact).abs() < 0.2 * exact.abs() + 0.5, "{}: {} {exact}", v.speed, v.growth);
        unstable += usize::from(exact > 0.0);
        seen += 1;
    }
    assert!(unstable >= 1 && seen > unstable);
}

/// One body, no damping: elliptic balance misses by the third order of the forcing only, and k^2 is that of the free oscillation.
#[test]
fn elliptic_law_is_found_by_probing() {
    let system = Base::default().builder().build().unwrap();
    let found = law(&system, Symmetry::Quarter, 2000.0).unwrap();
    assert!((found.linear - 1.1e7).abs() < 1e-6 * 1.1e7 && (found.cubic - 8.7e10).abs() < 1e-6 * 8.7e10, "{found:?}");
    assert!((found.mass - 2.4 * 25.0 / 27.4).abs() < 1e-12);
    // m K(m)^2 = c1 a^2 pi^2 / (8 mu W^2)
    let m = parameter(&found, 5e-3, 2000.0);
    let k = laval_num::elliptic::complete_first(m);
    let wanted = 8.7e10 * 25e-6 * std::f64::consts::PI.powi(2) / (8.0 * found.mass * 4e6);
    assert!((m * k * k - wanted).abs() < 1e-6 * wanted);
    for (base, symmetry, word) in [
        (Base { isotropic: true, ..Base::default() }, Symmetry::Circular, "quarter turn"),
        (Base { c1: -1e9, ..Base::default() }, Symmetry::Quarter, "harden"),
    ] {
        let system = base.builder().build().unwrap();
        assert!(law(&system, symmetry, 2000.0).err().unwrap().contains(word));
    }
}

/// Circular motion: one harmonic is exact, and nothing else is compared.
#[test]
fn one_harmonic_is_exact_for_circles() {
    let base = Base { isotropic: true, ..Base::default() };
    let (_, r, c) = compared(base.builder(), (800.0, 3600.0), &[1500.0, 2900.0], 7);
    assert_eq!(orders(&r, 7), [1]);
    assert!(c.no_elliptic.is_some());
    for v in &c.values {
        assert!(v.deviation < 1e-6, "{v:?}");
    }
}
