//! Self-excited whirls: closed form of the isotropic law, hard and soft onset, stability against time, the reference table.

use crate::common;

use common::base::{Base, defect};
use common::{number, rows};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::model::system::System;
use laval::parts::{bearing_cubic::*, damper::*, disc::*};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::pace::Pace;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::free::cycles::{Cycles, Request, at_speed, limit_cycles};
use laval::solve::symmetry::Symmetry;
use laval_num::complex::{C64, c};
use laval_num::continuation::End;
use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

static NEVER: AtomicBool = AtomicBool::new(false);

fn request(lo: f64, hi: f64) -> Request {
    Request { speeds: (lo, hi), points: 120, harmonics: None, truncation: 1e-9, max_points: 3_000, work: u64::MAX }
}

fn filled(fill: f64, delta: f64) -> Base {
    Base { isotropic: true, e: 0.0, fill: Some(fill), wave_damping: delta, ..Base::default() }
}

fn found(base: Base, request: Request) -> (System, Cycles) {
    let system = base.builder().build().unwrap();
    let found = limit_cycles(&system, &request, &NEVER, &|_| {}).unwrap();
    (system, found)
}

/// Condensed stiffness of the base set at whirl frequency w and spin speed.
fn condensed(b: &Base, w: f64, speed: f64) -> C64 {
    let q = b.fill.map_or(1.0, |f| 1.0 / (f * f));
    let g = (q - 1.0) / (q + 1.0);
    let s = w - speed;
    let damping = c(0.0, -2.0 * b.wave_damping * s);
    let top = c(s * s - 2.0 * s * speed - speed * speed, 0.0) + damping;
    let bottom = c(s * s - g * (2.0 * s * speed + speed * speed), 0.0) + damping;
    let full = std::f64::consts::PI * 0.07 * 0.07 * 0.06 * 1000.0;
    let liquid = (top / bottom).scale(g * full * w * w);
    let k1 = c(-2.4 * w * w, b.chi * w) - liquid;
    let k2 = c(b.c2 - b.foundation * w * w, b.chi0 * w);
    k1 * k2 / (k1 + k2)
}

/// `Im K = 0` and `a^2 = -(Re K + c0)/c1` on every cycle; the motion balances all forces of the assembled machine; the shift in time is neutral.
#[test]
fn isotropic_cycles_are_the_closed_form() {
    let base = filled(0.93, 20.0);
    let (system, f) = found(base, request(1800.0, 6000.0));
    assert_eq!(f.discretisation.symmetry, Symmetry::Circular);
    assert!(f.onsets.len() >= 2 && f.families.len() >= 2, "{:?}", f.onsets);
    let mut seen = 0;
    for family in &f.families {
        assert!(matches!(family.end, End::Reached), "{:?}", family.end);
        for cycle in &family.cycles {
            let k = condensed(&base, cycle.frequency, cycle.speed);
            let a2 = cycle.amplitude * cycle.amplitude;
            let size = base.c0 + base.c1 * a2;
            assert!(k.im.abs() < 1e-7 * size && (k.re + size).abs() < 1e-7 * size, "{k:?} at {} {}", cycle.speed, cycle.frequency);
            assert!(cycle.trivial < 1e-5, "{} at {}", cycle.trivial, cycle.speed);
            seen += 1;
        }
        for cycle in family.cycles.iter().step_by(9) {
            let mut balance = Balance::new(&system, f.discretisation, (900.0, 1000.0), None).unwrap();
            balance.set_free(Pace { speed: cycle.speed, frequency: cycle.frequency, drive: 0.0, rate: [0.0; 3], parameter: None });
            let orbit = Orbit::of(&mut balance, &cycle.x, cycle.speed).unwrap();
            assert!(defect(&system, &orbit, 1) < 1e-7);
        }
    }
    assert!(seen > 40, "{seen}");
}

/// Every row of the table: frequency, amplitudes, stability, growth of rest.
#[test]
fn cycles_of_the_table() {
    let mut groups: BTreeMap<[&str; 2], Vec<Vec<&str>>> = BTreeMap::new();
    let text = rows(include_str!("../reference/planar/limit_cycle.csv"));
    let all = text.len();
    for r in text {
        groups.entry([r[0], r[1]]).or_default().push(r);
    }
    let mut wrong = Vec::new();
    for ([fill, delta], rows) in groups {
        let base = filled(number(fill), number(delta));
        let speeds = rows.iter().map(|r| number(r[2]));
        let (_, most) = speeds.fold((f64::INFINITY, 0.0f64), |(l, h), s| (l.min(s), h.max(s)));
        let (system, f) = found(base, Request { points: 200, ..request(1000.0, 1.02 * most) });
        for r in rows {
            let (speed, w) = (number(r[2]), number(r[3]));
            let cycles: Vec<_> = f.families.iter().flat_map(|family| at_speed(&system, &f, family, speed).unwrap()).collect();
            let Some(cycle) = cycles.iter().find(|c| (c.frequency - w).abs() < 1e-6 * w) else {
                wrong.push(format!("{r:?}: none of {:?}", cycles.iter().map(|c| c.frequency).collect::<Vec<_>>()));
                continue;
            };
            let transverse = number(r[7]);
            let close = (cycle.amplitude - number(r[4])).abs() < 2e-6 * number(r[4])
                && (cycle.growth() - transverse).abs() < 1e-4 * transverse.abs().max(1.0)
                && cycle.stable() == (r[8] == "1")
                && (cycle.rest - number(r[9])).abs() < 1e-4 * number(r[9]).abs().max(1.0);
            if !close {
                wrong.push(format!("{r:?}: {} {} {} {}", cycle.amplitude, cycle.growth(), cycle.stable(), cycle.rest));
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {all} rows:\n{}", wrong.len(), wrong.join("\n"));
}

/// Near an edge: amplitude by the square root, soft exactly where small cycles are stable, the frequency that of the edge.
#[test]
fn onsets_are_hopf_points() {
    let (system, f) = found(filled(0.93, 20.0), request(1800.0, 6000.0));
    for family in &f.families {
        let onset = &f.onsets[family.onset];
        let small = &family.cycles[0];
        assert!(onset.curvature_change.abs() < 1e-3, "{}", onset.curvature_change);
        let predicted = onset.edge.speed + onset.curvature * small.amplitude * small.amplitude;
        assert!((predicted - small.speed).abs() < 1e-6 * small.speed);
        assert!((small.frequency / onset.frequency - 1.0).abs() < 1e-3);
        assert_eq!(small.stable(), !onset.hard, "{onset:?} {}", small.growth());
        // rest on the side of hard cycles is stable
        assert_eq!(small.rest < 0.0, onset.hard, "{onset:?} {}", small.rest);
        // the exponent that belongs to the amplitude: twice the growth of rest with the other sign, close to the edge
        if small.rest.abs() < 1.0 && small.rest.abs() > 1e-6 {
            let e = small.exponents.as_ref().unwrap();
            let nearest = e.values.iter().map(|z| (z.re + 2.0 * small.rest).abs()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.05 * small.rest.abs(), "{nearest} {}", small.rest);
        }
    }
    let _ = system;
}

/// A per-axis law: the cycle is no circle, its one exponent of time is zero to the accuracy of the map, more orders change nothing.
#[test]
fn per_axis_cycles_converge_with_the_orders() {
    let base = Base { isotropic: false, ..filled(0.93, 20.0) };
    let at = |harmonics: usize| {
        let (system, f) = found(base, Request { harmonics: Some(harmonics), points: 60, ..request(2050.0, 2400.0) });
        assert_eq!(f.discretisation.symmetry, Symmetry::Quarter);
        let cycles = at_speed(&system, &f, &f.families[0], 2300.0).unwrap();
        assert_eq!(cycles.len(), 1);
        cycles[0].clone()
    };
    let [a, b, d] = [5, 9, 13].map(at);
    assert!((a.frequency - d.frequency).abs() > 10.0 * (b.frequency - d.frequency).abs());
    assert!((b.frequency - d.frequency).abs() < 1e-8 * d.frequency, "{} {}", b.frequency, d.frequency);
    assert!(d.trivial < 1e-4 && d.stable(), "{} {}", d.trivial, d.growth());
}

/// Internal damping of a shaft on a hardening bearing: rest loses stability where the spin exceeds the frequency by 1 + ce/ci, softly, and the cycle
/// whirls where its own frequency meets the same condition.
#[test]
fn internal_damping_whirls_softly() {
    let (m, k, c1, external, internal) = (3.0, 2e6, 3e12, 40.0, 60.0);
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    let system = Builder::new("internal damping")
        .part("disc", Disc::planar(), DiscParams::new(m))
        .part("spring", BearingCubic::isotropic(link()), BearingCubicParams { stiffness: [k; 2], cubic_stiffness: [c1; 2], valid_to: 0.0 })
        .part("air", Damper::fixed(link()), DamperParams { damping: [external; 2], tilt_damping: 0.0 })
        .part("shaft", Damper::rotating(link()), DamperParams { damping: [internal; 2], tilt_damping: 0.0 })
        .build()
        .unwrap();
    let f = limit_cycles(&system, &request(500.0, 3000.0), &NEVER, &|_| {}).unwrap();
    let w0 = f64::sqrt(k / m);
    let onset = w0 * (1.0 + external / internal);
    assert_eq!((f.onsets.len(), f.families.len()), (1, 1));
    assert!((f.onsets[0].edge.speed - onset).abs() < 1e-8 * onset && !f.onsets[0].hard);
    for cycle in &f.families[0].cycles {
        // (external + internal) w = internal W, and m w^2 = k + c1 a^2
        let w = cycle.speed * internal / (internal + external);
        assert!((cycle.frequency - w).abs() < 1e-9 * w, "{} {w}", cycle.frequency);
        let a2 = (m * w * w - k) / c1;
        assert!((cycle.amplitude.powi(2) - a2).abs() < 1e-8 * a2 + 1e-16, "{} {a2}", cycle.amplitude.powi(2));
        assert!(cycle.stable() && cycle.rest > 0.0, "{} {}", cycle.growth(), cycle.rest);
    }
}

/// Without damping there is no limit cycle, and it is said; so for linear machines.
#[test]
fn unfit_machines_are_refused() {
    let refused = |base: Base| {
        let system = base.builder().build().unwrap();
        laval::solve::harmonic::free::cycles::admit(&system, (1000.0, 4000.0)).err().map(|d| d.message.to_string()).unwrap_or_default()
    };
    let undamped = Base { chi: 0.0, chi0: 0.0, ..filled(0.8, 0.0) };
    assert!(refused(undamped).contains("nothing damps this machine"), "{}", refused(undamped));
    assert_eq!(refused(filled(0.8, 5.0)), "");
}
