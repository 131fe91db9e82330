//! An elliptical bearing (two lobes, preload 1/2, L/D = 0.5) as printed, against Reynolds' equation on each of its lobes and against the law of the short bearing on them: what that law, which
//! `bearing_journal` has for a round bearing, is worth where the wall is preloaded.

use super::finite_film::{Grid, Lobe, film_of, rows, size};
use std::f64::consts::PI;

/// T. Someya (ed.), Journal-Bearing Databook, Springer 1989, page 41: S = mu N L D/W (R/c)^2 with the clearance c that the lobes are machined to, eccentricity over the smallest clearance, attitude
/// angle in degrees, Kxx, Kxy, Kyx, Kyy in W/c, Bxx, Bxy, Byx, Byy in W/(c w); x along the load, y a quarter turn on in the direction of rotation.
const ELLIPTICAL: [[f64; 11]; 8] = [
    [4.79, 0.0556, 87.2, 61.5, 33.1, -43.3, 2.06, 123.0, -43.3, -42.5, 36.6],
    [0.993, 0.262, 85.9, 13.5, 7.50, -9.20, 0.897, 26.5, -8.47, -8.34, 8.28],
    [0.496, 0.438, 84.4, 7.88, 4.52, -4.60, 0.831, 14.0, -3.42, -3.36, 4.71],
    [0.306, 0.608, 80.8, 6.06, 3.73, -2.82, 0.940, 10.5, -1.13, -1.11, 3.45],
    [0.105, 0.888, 68.3, 6.51, 4.19, -0.115, 1.57, 7.86, 1.44, 1.45, 1.89],
    [0.0507, 0.970, 56.8, 9.47, 5.46, 0.945, 1.94, 9.03, 2.29, 2.31, 1.38],
    [0.0303, 0.995, 48.6, 13.2, 6.45, 1.72, 2.12, 10.4, 2.58, 2.62, 1.16],
    [0.0100, 1.01, 34.1, 29.6, 9.68, 3.28, 2.39, 15.3, 2.88, 2.93, 0.875],
];

const RATIO: f64 = 0.5;
const PRELOAD: f64 = 0.5;

/// The lobes below and above, with grooves of 10 degrees beside the load.
fn lobes() -> [Lobe; 2] {
    let groove = 5f64.to_radians();
    [Lobe { from: PI + groove, to: 2.0 * PI - groove, centre: PRELOAD }, Lobe { from: groove, to: PI - groove, centre: -PRELOAD }]
}

pub type Force = dyn Fn([f64; 2], [f64; 2]) -> [f64; 2];

/// Of the films of finite length.
fn finite(at: [f64; 2], rate: [f64; 2]) -> [f64; 2] {
    let g = Grid { ratio: RATIO, around: 96, along: 20, full: false };
    lobes().into_iter().map(|l| film_of(l, g, at, rate)).fold([0.0; 2], |s, f| [s[0] + f[0], s[1] + f[1]])
}

/// Of the short bearing: the pressure is a parabola along the axis, and none where it would be negative.
pub fn short_of(all: &[Lobe], at: [f64; 2], rate: [f64; 2]) -> [f64; 2] {
    const POINTS: usize = 4000;
    let mut out = [0.0; 2];
    for lobe in all {
        let (x, y, step) = (at[0], at[1] - lobe.centre, (lobe.to - lobe.from) / POINTS as f64);
        for i in 0..POINTS {
            let (s, c) = (lobe.from + (i as f64 + 0.5) * step).sin_cos();
            let source = x * s - y * c - 2.0 * (rate[0] * c + rate[1] * s);
            let p = 2.0 * (-source).max(0.0) / (1.0 - x * c - y * s).powi(3) * step;
            out = [out[0] - p * c, out[1] - p * s];
        }
    }
    out
}

/// Where the film carries a load along -y, from a place near it.
pub fn rest(force: &Force, load: f64, start: [f64; 2]) -> [f64; 2] {
    const STEP: f64 = 1e-4;
    let mut q = start;
    for _ in 0..20 {
        let f = force(q, [0.0; 2]);
        let [fx, fy] = [[STEP, 0.0], [0.0, STEP]].map(|d| force([q[0] + d[0], q[1] + d[1]], [0.0; 2]));
        let (a, b, c, d) = ((fx[0] - f[0]) / STEP, (fy[0] - f[0]) / STEP, (fx[1] - f[1]) / STEP, (fy[1] - f[1]) / STEP);
        let (r, s) = (-f[0], load - f[1]);
        let step = [(r * d - b * s) / (a * d - b * c), (a * s - c * r) / (a * d - b * c)];
        let part = (0.1 / (step[0].abs() + step[1].abs())).min(1.0);
        q = [q[0] + part * step[0], q[1] + part * step[1]];
        if size(step) < 1e-8 {
            return q;
        }
    }
    panic!("no rest under {load}");
}

/// Stiffness and damping as the rows have them.
pub fn coefficients(force: &Force, load: f64, q: [f64; 2]) -> [[f64; 4]; 2] {
    const STEP: f64 = 2e-3;
    let mut own = [[0.0; 4]; 2];
    for k in 0..4 {
        let moved = |d: f64| {
            let mut z = [q[0], q[1], 0.0, 0.0];
            z[k] += d;
            force([z[0], z[1]], [z[2], z[3]])
        };
        let (a, b) = (moved(STEP), moved(-STEP));
        for i in 0..2 {
            own[k / 2][2 * i + k % 2] = -(a[i] - b[i]) / (2.0 * STEP * load);
        }
    }
    // here the load acts along -y
    own.map(|[xx, xy, yx, yy]| [yy, -yx, -xy, xx])
}

/// On a round wall the quadrature is the closed form of Ocvirk's bearing.
#[test]
fn round_the_short_law_is_the_closed_form() {
    let whole = [Lobe { from: 0.0, to: 2.0 * PI, centre: 0.0 }];
    for e in [0.2f64, 0.6] {
        let (f, m) = (short_of(&whole, [e, 0.0], [0.0; 2]), 1.0 - e * e);
        assert!((f[0] / (-4.0 * e * e / (m * m)) - 1.0).abs() < 1e-5 && (f[1] / (PI * e / m.powf(1.5)) - 1.0).abs() < 1e-5, "{e}: {f:?}");
    }
}

/// Each law against the printed rows, as the page of its theory says: place of rest, and coefficients in percent of the largest one of their kind.
#[test]
fn printed_rows_of_an_elliptical_bearing() {
    let short = |at: [f64; 2], rate: [f64; 2]| short_of(&lobes(), at, rate);
    let laws: [(&str, &Force, f64); 2] = [
        ("| printed S, elliptical | printed e | printed attitude |", &finite, 12.0),
        ("| printed S, short lobes | printed e | printed attitude |", &short, 48.0),
    ];
    for (head, force, most) in laws {
        let table = rows(head);
        assert_eq!(table.len(), ELLIPTICAL.len());
        for (row, stated) in ELLIPTICAL.iter().zip(table) {
            assert_eq!(stated[..3], row[..3]);
            let load = 1.0 / (PI * row[0] * RATIO * RATIO);
            let (e, (s, c)) = (row[1] * (1.0 - PRELOAD), row[2].to_radians().sin_cos());
            let q = rest(force, load, [e * s, -e * c]);
            let (own, angle) = (size(q) / (1.0 - PRELOAD), q[0].atan2(-q[1]).to_degrees());
            assert!((own - stated[3]).abs() < 1e-3 && (angle - stated[4]).abs() < 0.1, "{stated:?}: {own} {angle}");
            for (kind, found) in coefficients(force, load, q).iter().enumerate() {
                let printed = &row[3 + 4 * kind..7 + 4 * kind];
                let largest = printed.iter().fold(0.0f64, |m, x| m.max(x.abs()));
                for k in 0..4 {
                    let off = 100.0 * (found[k] - printed[k]) / largest;
                    assert!(off.abs() < most && (off - stated[5 + 4 * kind + k]).abs() < 0.2, "{head} {stated:?}, {kind} {k}: {off}");
                }
            }
        }
    }
}
