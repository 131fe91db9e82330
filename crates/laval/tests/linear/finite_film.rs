//! The closed form of the short bearing against Reynolds' equation of a bearing of finite length, solved here by differences with the film ruptured where its pressure would be negative:
//!
//! ```text
//! d/dt(H^3 dP/dt) + (R/L)^2 d/dz(H^3 dP/dz) = dH/dt + (2/W) dH/dtime,   P >= 0,   P = 0 at both ends
//! ```
//!
//! t around the circumference, z along the axis over the length. Forces are in units of mu W R L^3/(4 c^2). The solver knows no table: it is held against Sommerfeld's long bearing and against its own refinement.

use crate::common::files::load;
use laval::model::part::At;
use laval::model::system::System;
use laval::model::tangent::{SparseTangent, TangentScratch};
use laval::solve::rest::rest;
use std::f64::consts::PI;

/// A part of the wall: its ends (rad), where the pressure is that of the surroundings, and the height of its centre of curvature over the clearance it is machined to. A whole turn has no ends.
#[derive(Clone, Copy)]
pub struct Lobe {
    pub from: f64,
    pub to: f64,
    pub centre: f64,
}

const ROUND: Lobe = Lobe { from: 0.0, to: 2.0 * PI, centre: 0.0 };

/// Of a film: length over diameter, points around the circumference and over half the length, and whether the pressure may be negative.
#[derive(Clone, Copy)]
pub struct Grid {
    pub ratio: f64,
    pub around: usize,
    pub along: usize,
    pub full: bool,
}

/// Force on the journal at a displacement and a rate over the clearance, for W = 1; by successive over-relaxation, projected on P >= 0.
fn film(g: Grid, at: [f64; 2], rate: [f64; 2]) -> [f64; 2] {
    film_of(ROUND, g, at, rate)
}

/// The same of a part of the wall.
pub fn film_of(lobe: Lobe, g: Grid, [x, y]: [f64; 2], [vx, vy]: [f64; 2]) -> [f64; 2] {
    let (whole, y) = (lobe.to - lobe.from >= 2.0 * PI, y - lobe.centre);
    let (dt, dz) = ((lobe.to - lobe.from) / g.around as f64, 0.5 / g.along as f64);
    let cube = |t: f64| (1.0 - x * t.cos() - y * t.sin()).powi(3);
    let axial = (0.5 / g.ratio / dz).powi(2);
    let rows: Vec<[f64; 4]> = (0..g.around)
        .map(|i| {
            let t = lobe.from + i as f64 * dt;
            let source = x * t.sin() - y * t.cos() - 2.0 * (vx * t.cos() + vy * t.sin());
            [cube(t + 0.5 * dt) / (dt * dt), cube(t - 0.5 * dt) / (dt * dt), axial * cube(t), source]
        })
        .collect();
    let mean = |k: usize| rows.iter().map(|r| r[k]).sum::<f64>() / g.around as f64;
    // the slowest error is constant around the circumference
    let slow = (mean(0) + mean(2) * (0.5 * PI / g.along as f64).cos()) / (mean(0) + mean(2));
    let relax = 2.0 / (1.0 + (1.0 - slow * slow).sqrt());
    let mut p = vec![vec![0.0f64; g.along + 1]; g.around];
    for sweep in 0.. {
        assert!(sweep < 50_000, "the film does not converge");
        let (mut change, mut largest) = (0.0f64, 0.0f64);
        for i in if whole { 0 } else { 1 }..g.around {
            let (next, last) = ((i + 1) % g.around, (i + g.around - 1) % g.around);
            let [up, down, side, source] = rows[i];
            for j in 0..g.along {
                // symmetric about the middle of the length
                let inner = p[i][if j == 0 { 1 } else { j - 1 }];
                let exact = (up * p[next][j] + down * p[last][j] + side * (p[i][j + 1] + inner) - source) / (up + down + 2.0 * side);
                let new = p[i][j] + relax * (exact - p[i][j]);
                let new = if g.full { new } else { new.max(0.0) };
                (change, largest) = (change.max((new - p[i][j]).abs()), largest.max(new.abs()));
                p[i][j] = new;
            }
        }
        if change <= 1e-13 * largest {
            break;
        }
    }
    let unit = 24.0 / (2.0 * g.ratio).powi(2);
    let mut out = [0.0; 2];
    for (i, row) in p.iter().enumerate() {
        let (s, c) = (lobe.from + i as f64 * dt).sin_cos();
        let sum: f64 = (0..g.along).map(|j| row[j] * if j == 0 { 1.0 } else { 2.0 }).sum::<f64>() * dz * dt * unit;
        out = [out[0] - sum * c, out[1] - sum * s];
    }
    out
}

fn grid(ratio: f64, n: usize) -> Grid {
    Grid { ratio, around: 6 * n, along: n, full: false }
}

/// At an eccentricity, from two grids of second order.
fn extrapolated(ratio: f64, e: f64) -> [f64; 2] {
    let [a, b] = [20, 40].map(|n| film(grid(ratio, n), [e, 0.0], [0.0; 2]));
    [0, 1].map(|k| b[k] + (b[k] - a[k]) / 3.0)
}

pub fn size(f: [f64; 2]) -> f64 {
    f[0].hypot(f[1])
}

/// Attitude angle, degrees: from the load to the line of centres.
fn attitude(f: [f64; 2]) -> f64 {
    (f[1] / -f[0]).atan().to_degrees()
}

/// Of the short bearing.
fn short(e: f64) -> [f64; 2] {
    let m = 1.0 - e * e;
    [-4.0 * e * e / (m * m), PI * e / m.powf(1.5)]
}

#[test]
fn the_solver_is_of_second_order_and_has_both_limits() {
    for (ratio, e) in [(0.25, 0.2), (0.5, 0.4), (1.0, 0.6)] {
        let [a, b, c] = [10, 20, 40].map(|n| size(film(grid(ratio, n), [e, 0.0], [0.0; 2])));
        let order = (b - a) / (c - b);
        assert!(order > 2.5 && (c - b).abs() < 2e-3 * c, "{ratio} {e}: {a} {b} {c}");
    }
    // Sommerfeld's long bearing with a full film, 12 pi e/((2 + e^2) sqrt(1 - e^2)) a length; the ends of a finite one take a share of D/L
    for e in [0.3f64, 0.6] {
        let per_length = |ratio: f64| film(Grid { ratio, around: 240, along: 40, full: true }, [e, 0.0], [0.0; 2])[1] * ratio * ratio;
        let [a, b] = [4.0, 8.0].map(per_length);
        let long = 12.0 * PI * e / ((2.0 + e * e) * (1.0 - e * e).sqrt());
        assert!(((2.0 * b - a) / long - 1.0).abs() < 2e-3, "{e}: {a} {b} {long}");
    }
    // Ocvirk's short bearing
    for e in [0.2, 0.6] {
        let f = extrapolated(0.02, e);
        assert!((size(short(e)) / size(f) - 1.0).abs() < 1e-3 && (attitude(short(e)) - attitude(f)).abs() < 0.05, "{e}: {f:?}");
    }
}

/// Rows of the table of docs/theory/oil-films.md that begin with this head.
pub fn rows(head: &str) -> Vec<Vec<f64>> {
    let page = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/theory/oil-films.md")).unwrap();
    let from = page.find(head).unwrap_or_else(|| panic!("no table {head}"));
    let lines = page[from..].lines().skip(2).take_while(|l| l.starts_with('|'));
    lines.map(|l| l.trim_matches('|').split('|').map(|c| c.trim().parse().unwrap()).collect()).collect()
}

/// How far the short bearing is off at one eccentricity, as the page of its theory says.
#[test]
fn load_of_the_short_bearing() {
    let table = rows("| L/D | e | finite length | short | attitude | short |");
    assert_eq!(table.len(), 12);
    for row in table {
        let [ratio, e, load, closed, angle, closed_angle] = row[..] else { panic!("{row:?}") };
        let f = extrapolated(ratio, e);
        for (found, said, tolerance) in [
            (size(f), load, 6e-4 * load),
            (size(short(e)), closed, 6e-4 * closed),
            (attitude(f), angle, 0.06),
            (attitude(short(e)), closed_angle, 0.06),
        ] {
            assert!((found - said).abs() < tolerance, "L/D {ratio}, e {e}: {found} is not {said}");
        }
    }
}

const SPEED: f64 = 300.0;
const CLEARANCE: f64 = 1e-4;

/// A mass on a bearing that carries this load, in units of mu W R L^3/(4 c^2).
fn machine(ratio: f64, load_of: f64) -> (System, f64) {
    let (diameter, viscosity) = (0.1f64, 0.02);
    let length = ratio * diameter;
    let unit = viscosity * SPEED * 0.5 * diameter * length.powi(3) / (4.0 * CLEARANCE * CLEARANCE);
    let mass = load_of * unit / 9.80665;
    let text = format!(
        "[machine]\nname = \"t\"\naxis = \"horizontal\"\n[[part]]\nkind = \"disc\"\nname = \"rotor\"\nmass = {mass:?}\n\
         [[part]]\nkind = \"bearing_journal\"\nname = \"bearing\"\nbetween = [\"rotor\", \"ground\"]\ndiameter = {diameter:?}\nlength = {length:?}\nclearance = {CLEARANCE:?}\nviscosity = {viscosity:?}\n"
    );
    (load(&text).system, load_of * unit)
}

/// The eight coefficients of the part under the load that the finite bearing carries at an eccentricity, in W/c and W/(c W): kxx, kxy, kyx, kyy, cxx, cxy, cyx, cyy; and its eccentricity.
fn of_the_part(ratio: f64, load_of: f64) -> ([f64; 8], f64) {
    let (system, force) = machine(ratio, load_of);
    let state = rest(&system, SPEED).unwrap();
    let zero = vec![0.0; system.n()];
    let at = At { q: &state.q, v: &zero, a: &zero, z: &[], phase: 0.0, speed: SPEED, spin_accel: 0.0, t: 0.0 };
    let (mut t, mut scratch) = (SparseTangent::default(), TangentScratch::default());
    system.tangent(&at, false, &mut t, &mut scratch, |s| s.name == "bearing");
    let of =
        |entries: &[(usize, usize, f64)], i: usize, j: usize| entries.iter().filter(|e| (e.0, e.1) == (i, j)).map(|e| e.2).sum::<f64>();
    let mut out = [0.0; 8];
    for k in 0..4 {
        out[k] = of(&t.q.0, k / 2, k % 2) * CLEARANCE / force;
        out[4 + k] = of(&t.v.0, k / 2, k % 2) * CLEARANCE * SPEED / force;
    }
    (out, size([state.q[0], state.q[1]]) / CLEARANCE)
}

/// The same of the finite bearing, by differences.
fn of_the_film(g: Grid, e: f64) -> ([f64; 8], f64) {
    const STEP: f64 = 0.01;
    let f = film(g, [e, 0.0], [0.0; 2]);
    let load = size(f);
    // turned so that the film lifts along y
    let (s, c) = (0.5 * PI - f[1].atan2(f[0])).sin_cos();
    let q = [e * c, e * s];
    let mut out = [0.0; 8];
    for k in 0..4 {
        let moved = |d: f64| {
            let mut z = [q[0], q[1], 0.0, 0.0];
            z[k] += d;
            film(g, [z[0], z[1]], [z[2], z[3]])
        };
        let (a, b) = (moved(STEP), moved(-STEP));
        for i in 0..2 {
            out[4 * (k / 2) + 2 * i + k % 2] = -(a[i] - b[i]) / (2.0 * STEP * load);
        }
    }
    (out, load)
}

/// Under one load: eccentricity and coefficients of the part against those of a film of finite length, as the page says.
#[test]
fn coefficients_of_the_short_bearing() {
    let table = rows("| L/D | e | short e | kxx | kxy | kyx | kyy | cxx | cxy | cyx | cyy |");
    assert_eq!(table.len(), 6);
    for row in table {
        let (ratio, e) = (row[0], row[1]);
        let (finite, load) = of_the_film(grid(ratio, 40), e);
        let (part, eccentricity) = of_the_part(ratio, load);
        assert!((eccentricity - row[2]).abs() < 1.5e-3, "L/D {ratio}, e {e}: {eccentricity}");
        for k in 0..8 {
            let found = 100.0 * (part[k] / finite[k] - 1.0);
            // cross coefficients near a zero are the least certain
            let tolerance = if finite[k].abs() < 0.5 { 4.0 } else { 0.6 };
            assert!((found - row[3 + k]).abs() < tolerance, "L/D {ratio}, e {e}, coefficient {k}: {found} % is not {} %", row[3 + k]);
        }
    }
}

/// A bearing with two axial grooves beside the load, L/D = 0.5, as printed in table 1a of I. F. Santos, Tribology of Machine Elements (course 41524, Technical University of Denmark, 2023):
/// S = mu N L D/W (R/c)^2, eccentricity, attitude angle in degrees, Kxx, Kxy, Kyx, Kyy in W/c, Bxx, Bxy, Byx, Byy in W/(c w); x along the load, y a quarter turn on in the direction of rotation.
#[expect(clippy::approx_constant, reason = "a printed 6.28 is none")]
const GROOVED: [[f64; 11]; 8] = [
    [2.634, 0.165, 72.36, 1.61, 6.74, -3.01, 1.91, 13.36, 2.00, 2.00, 6.28],
    [1.656, 0.244, 65.85, 1.69, 5.06, -2.20, 1.95, 9.93, 2.15, 2.15, 4.80],
    [0.917, 0.372, 57.45, 2.12, 4.01, -1.30, 1.85, 7.70, 2.06, 2.06, 3.23],
    [0.580, 0.477, 51.01, 2.67, 3.70, -0.78, 1.75, 6.96, 1.94, 1.94, 2.40],
    [0.378, 0.570, 45.43, 3.33, 3.64, -0.43, 1.68, 6.76, 1.87, 1.87, 1.89],
    [0.244, 0.655, 40.25, 4.21, 3.74, -0.13, 1.64, 6.87, 1.82, 1.82, 1.54],
    [0.151, 0.734, 35.20, 5.48, 3.98, 0.15, 1.61, 7.26, 1.79, 1.79, 1.27],
    [0.086, 0.809, 30.04, 7.51, 4.42, 0.47, 1.59, 8.03, 1.79, 1.79, 1.03],
];

/// The load that belongs to S, over mu W R L^3/(4 c^2), and the coefficients with the load along -y.
fn printed(row: &[f64; 11], ratio: f64) -> (f64, [f64; 8]) {
    let turned = |xx: f64, xy: f64, yx: f64, yy: f64| [yy, -yx, -xy, xx];
    let [k, b] = [3, 7].map(|i| turned(row[i], row[i + 1], row[i + 2], row[i + 3]));
    let mut all = [0.0; 8];
    all[..4].copy_from_slice(&k);
    all[4..].copy_from_slice(&b);
    (1.0 / (PI * row[0] * ratio * ratio), all)
}

/// The printed rows against a plain film of the same length and against the part, as the page says.
#[test]
fn printed_rows_of_a_bearing_with_two_grooves() {
    let table = rows("| printed e | printed attitude |");
    assert_eq!(table.len(), GROOVED.len());
    for (row, said) in GROOVED.iter().zip(table) {
        let (load, coefficients) = printed(row, 0.5);
        let film = extrapolated(0.5, row[1]);
        let (part, e) = of_the_part(0.5, load);
        assert_eq!(said[..2], row[1..3]);
        let more = 100.0 * (size(film) / load - 1.0);
        let (turned, short) = (attitude(film) - row[2], e);
        assert!(
            (more - said[2]).abs() < 0.7 && (turned - said[3]).abs() < 0.1 && (short - said[4]).abs() < 1e-3,
            "{said:?}: {more} {turned} {short}"
        );
        for k in 0..8 {
            let off = 100.0 * (part[k] / coefficients[k] - 1.0);
            assert!((off - said[5 + k]).abs() < 0.7, "{said:?}, coefficient {k}: {off}");
        }
    }
}
