//! A rotor that touches a stop: through the onset of contact, against the closed form and against integration in time.

use crate::common;

use common::base::{request, run};
use laval::model::builder::Builder;
use laval::model::field::Attach;
use laval::model::part::Link;
use laval::parts::{bearing_cubic::*, damper::*, disc::*, stop::*};
use laval::solve::harmonic::balance::orbit::Orbit;
use laval::solve::harmonic::balance::problem::Balance;
use laval::solve::harmonic::branches::response::Request;
use laval::solve::symmetry::Symmetry;
use laval_num::continuation::{End, Zero};
use laval_num::dense::Mat;
use std::f64::consts::TAU;

const M: f64 = 2.0;
const E: f64 = 1e-4;
const C: f64 = 100.0;
const GAP: f64 = 3e-4;
const STOP: f64 = 1e7;
const RANGE: (f64, f64) = (200.0, 3000.0);

fn machine(k: [f64; 2]) -> Builder {
    let link = || Link::Between(Attach::on("disc"), Attach::ground());
    Builder::new("rotor with a stop")
        .part("disc", Disc::planar(), DiscParams { eccentricity: E, ..DiscParams::new(M) })
        .part("spring", BearingCubic::per_axis(link()), BearingCubicParams { stiffness: k, cubic_stiffness: [0.0; 2], valid_to: 0.0 })
        .part("air", Damper::fixed(link()), DamperParams { damping: [C; 2], tilt_damping: 0.0 })
        .part("stop", Stop::new(link()), StopParams { stiffness: STOP, gap: GAP, damping: 0.0 })
}

/// Circular motion has a closed form, `|k + ks (1 - g/r)+ - m W^2 + i c W| r = m e W^2`; the speeds at which it touches have one too.
#[test]
fn circular_motion_through_the_onset_of_contact() {
    let k = 1e6;
    let r = run(machine([k; 2]), request(RANGE.0, RANGE.1));
    assert_eq!(r.discretisation.symmetry, Symmetry::Circular);
    assert_eq!(r.branches.len(), 1);
    let branch = &r.branches[0];
    assert_eq!(branch.end, End::Reached);
    for p in &branch.points {
        let (w, a) = (p.speed, p.x[0].hypot(p.x[1]));
        let stiffness = k + STOP * (1.0 - GAP / a).max(0.0) - M * w * w;
        let (left, right) = (stiffness.hypot(C * w) * a, M * E * w * w);
        assert!((left - right).abs() < 1e-9 * STOP * a, "{w}: {left} {right}");
    }
    // up to the contact, a hardening peak with a fold, and back to where the contact opens: there the branch turns at a corner
    let folds: Vec<_> = branch.folds.iter().map(|f| (f.upper, f.corner)).collect();
    assert_eq!(folds, [(true, false), (false, true)]);
    // r = g: (1 - e^2/g^2) W^4 - (2 k/m - c^2/m^2) W^2 + k^2/m^2 = 0
    let (a, b, c) = (1.0 - (E / GAP).powi(2), 2.0 * k / M - (C / M).powi(2), (k / M).powi(2));
    let onset = ((b + (b * b - 4.0 * a * c).sqrt()) / (2.0 * a)).sqrt();
    assert!((branch.folds[1].speed - onset).abs() < 1e-8 * onset, "{} {onset}", branch.folds[1].speed);
    assert!(branch.folds[0].confirmed && branch.changes.is_empty(), "{:?}", branch.changes);
    // stable but between the folds
    for (i, p) in branch.points.iter().enumerate() {
        let between = i > branch.folds[0].after && i <= branch.folds[1].after;
        assert!(p.stable() != between || i == branch.folds[1].after + 1, "point {i} at {}", p.speed);
    }
}

/// In an anisotropic support the rotor touches during part of each turn. Every state is integrated in time over half a turn.
#[test]
fn contact_over_part_of_a_turn_agrees_with_integration() {
    let k = [1e6, 1.2e6];
    let r = run(machine(k), Request { stability: false, harmonics: Some(47), ..request(RANGE.0, RANGE.1) });
    assert_eq!((r.discretisation.symmetry, r.branches.len()), (Symmetry::Half, 1));
    let branch = &r.branches[0];
    assert_eq!(branch.end, End::Reached);
    assert!(branch.folds.len() == 4 && branch.folds.iter().all(|f| f.confirmed && f.harmonics_change.abs() < 1e-4), "{:?}", branch.folds);
    let system = machine(k).build().unwrap();
    let mut balance = Balance::new(&system, r.discretisation, RANGE, None).unwrap();
    let (mut touched, mut partly) = (0, 0);
    for p in branch.points.iter().step_by(3) {
        let orbit = Orbit::of(&mut balance, &p.x, p.speed).unwrap();
        let w = p.speed;
        let force = |q: [f64; 2], t: f64| {
            let a = q[0].hypot(q[1]);
            let stop = if a > GAP { STOP * (1.0 - GAP / a) } else { 0.0 };
            let unbalance = M * E * w * w;
            [unbalance * (w * t).cos() - (k[0] + stop) * q[0], unbalance * (w * t).sin() - (k[1] + stop) * q[1]]
        };
        let rates = |t: f64, y: [f64; 4]| {
            let f = force([y[0], y[1]], t);
            [y[2], y[3], (f[0] - C * y[2]) / M, (f[1] - C * y[3]) / M]
        };
        let (mut q, mut v, mut a) = ([0.0; 2], [0.0; 2], [0.0; 2]);
        orbit.at(0.0, &mut q, &mut v, &mut a, &mut []);
        let mut y = [q[0], q[1], v[0], v[1]];
        let steps = 4000;
        // half a turn is the whole motion, by symmetry; over longer a disturbance of an unstable state grows
        let h = 0.5 * TAU / w / f64::from(steps);
        let (mut size, mut worst, mut inside, mut outside) = (0.0f64, 0.0f64, false, false);
        for i in 0..steps {
            let t = h * f64::from(i);
            let add = |y: [f64; 4], k: [f64; 4], s: f64| std::array::from_fn(|i| y[i] + s * k[i]);
            let k1 = rates(t, y);
            let k2 = rates(t + 0.5 * h, add(y, k1, 0.5 * h));
            let k3 = rates(t + 0.5 * h, add(y, k2, 0.5 * h));
            let k4 = rates(t + h, add(y, k3, h));
            y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
            orbit.at(w * (t + h), &mut q, &mut v, &mut a, &mut []);
            let radius = q[0].hypot(q[1]);
            size = size.max(radius);
            worst = worst.max((y[0] - q[0]).hypot(y[1] - q[1]));
            if radius > GAP { outside = true } else { inside = true }
        }
        touched += usize::from(outside);
        partly += usize::from(outside && inside);
        assert!(worst < 1e-4 * size, "at {w}: {worst:e} of {size:e}");
    }
    assert!(touched > 30 && partly > 10, "{touched} {partly}");
}

/// Tangents of the balance through contact, with and without a force that jumps, against central differences (Richardson, order 4).
#[test]
fn tangents_through_contact_are_those_of_differences() {
    for (damping, horizontal) in [(0.0, false), (0.0, true), (800.0, false), (800.0, true)] {
        let stop = StopParams { stiffness: STOP, gap: GAP, damping };
        let link = Link::Between(Attach::on("disc"), Attach::ground());
        let plain = Builder::new("disc")
            .part("disc", Disc::planar(), DiscParams { eccentricity: E, ..DiscParams::new(M) })
            .part(
                "spring",
                BearingCubic::per_axis(link.clone()),
                BearingCubicParams { stiffness: [1e6, 1.2e6], cubic_stiffness: [1e12; 2], valid_to: 0.0 },
            )
            .part("stop", Stop::new(link), stop);
        let system = if horizontal { plain.horizontal() } else { plain }.build().unwrap();
        let symmetry = if horizontal { Symmetry::None } else { Symmetry::Half };
        let d = laval::solve::harmonic::balance::problem::Discretisation { harmonics: 5, divisor: 1, samples: 64, symmetry };
        let mut balance = Balance::new(&system, d, RANGE, None).unwrap();
        let (n, w) = (balance.dim(), 700.0);
        // an ellipse that reaches out of the gap, with a little of every order
        let mut x: Vec<f64> = (0..n).map(|i| 6e-6 * (1.0 + i as f64).sin()).collect();
        for &(term, at) in &balance.terms.list {
            match term.order() {
                1 => x[at] = 2.9e-4,
                -1 => x[at] = 0.8e-4,
                _ => {}
            }
        }
        let (switches, jumps) = balance.switches(&x, w, (0.0, TAU));
        assert!(switches.len() >= 4 && jumps.is_some() == (damping > 0.0), "{switches:?} {jumps:?}");
        let (mut r, mut jac, mut by_speed) = (vec![0.0; n], Mat::zeros(n, n), vec![0.0; n]);
        balance.eval(&x, w, &mut r, Some(&mut jac), Some(&mut by_speed)).unwrap();
        let size = (0..n).flat_map(|i| jac.row(i).to_vec()).fold(0.0f64, |m, x| m.max(x.abs()));
        let mut at = |x: &[f64], w: f64| {
            let mut r = vec![0.0; n];
            balance.eval(x, w, &mut r, None, None).unwrap();
            r
        };
        let difference = |f: &mut dyn FnMut(f64) -> Vec<f64>, h: f64| -> Vec<f64> {
            let [a, b, c, d] = [h, -h, 0.5 * h, -0.5 * h].map(&mut *f);
            (0..n).map(|i| (8.0 * (c[i] - d[i]) - (a[i] - b[i])) / (6.0 * h)).collect()
        };
        for j in 0..n {
            let wanted = difference(
                &mut |h| {
                    let mut moved = x.clone();
                    moved[j] += h;
                    at(&moved, w)
                },
                1e-7,
            );
            for i in 0..n {
                assert!((jac[(i, j)] - wanted[i]).abs() < 1e-6 * size, "{damping} {horizontal} {i} {j}: {} {}", jac[(i, j)], wanted[i]);
            }
        }
        let wanted = difference(&mut |h| at(&x, w + h), 1e-2);
        let size = wanted.iter().fold(0.0f64, |m, x| m.max(x.abs()));
        for (a, b) in by_speed.iter().zip(&wanted) {
            assert!((a - b).abs() < 1e-6 * size, "{damping} {horizontal}: {a} {b}");
        }
    }
}
