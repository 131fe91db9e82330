//! The machine once more, as plain matrices: `E x' = A x + steady + Re(turning exp(i W t))` over coordinates, rates and states of liquids.
//!
//! Written from the equations of each part, and from nothing of the program: a shaft on supports is made of beam elements on springs, a table is interpolated by
//! its own cubic.

use super::machine::{Body, End, Law, Machine};
use super::matrix::{C, Complex, Lu, Real, c, complex, zeros};

const GRAVITY: f64 = 9.80665;

pub struct Assembly {
    pub e: Real,
    pub a: Real,
    pub steady: Vec<f64>,
    pub turning: Vec<C>,
    /// First coordinate of each body.
    pub first: Vec<usize>,
}

/// x, y, tilt_x, tilt_y of a place on a body over the coordinates.
fn place(m: &Machine, first: &[usize], n: usize, end: &End) -> Real {
    let mut rows = zeros(4, n);
    let Some(body) = end.body else { return rows };
    let k = first[body];
    (rows[0][k], rows[1][k + 1]) = (1.0, 1.0);
    if m.tilts(body) {
        (rows[0][k + 3], rows[1][k + 2]) = (end.at, -end.at);
        (rows[2][k + 2], rows[3][k + 3]) = (1.0, 1.0);
    }
    rows
}

/// Adds `b^T local b`.
fn add(to: &mut Real, b: &Real, local: &[[f64; 4]; 4]) {
    for (i, row) in local.iter().enumerate() {
        for (j, &x) in row.iter().enumerate().filter(|x| *x.1 != 0.0) {
            for (p, &bi) in b[i].iter().enumerate().filter(|x| *x.1 != 0.0) {
                for (q, &bj) in b[j].iter().enumerate() {
                    to[p][q] += bi * x * bj;
                }
            }
        }
    }
}

/// An end of a beam.
#[derive(Clone, Copy)]
enum Held {
    Spring(f64),
    Pinned,
    Clamped,
}

/// Stiffness of deflection and slope at the joint of two beam elements, one of which may have no length; where the slope is free, of the deflection alone.
fn beam(lengths: [f64; 2], bending: f64, held: [Held; 2], slope_free: bool) -> [[f64; 2]; 2] {
    let mut k = zeros(6, 6);
    for (first, length) in [(0, lengths[0]), (2, lengths[1])] {
        if length == 0.0 {
            continue;
        }
        let (l, f) = (length, bending / length.powi(3));
        let element = [
            [12.0, 6.0 * l, -12.0, 6.0 * l],
            [6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l],
            [-12.0, -6.0 * l, 12.0, -6.0 * l],
            [6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l],
        ];
        for (i, row) in element.iter().enumerate() {
            row.iter().enumerate().for_each(|(j, x)| k[first + i][first + j] += f * x);
        }
    }
    // what moves without load is eliminated, what is held stays where it is
    let mut follows = Vec::new();
    for (end, (held, length)) in [0, 4].into_iter().zip(held.into_iter().zip(lengths)) {
        match held {
            _ if length == 0.0 => {}
            Held::Spring(x) => {
                k[end][end] += x;
                follows.extend([end, end + 1]);
            }
            Held::Pinned => follows.push(end + 1),
            Held::Clamped => {}
        }
    }
    let kept = if slope_free { vec![2] } else { vec![2, 3] };
    if slope_free {
        follows.push(3);
    }
    let inner: Complex = follows.iter().map(|&i| follows.iter().map(|&j| c(k[i][j], 0.0)).collect()).collect();
    let lu = Lu::new(inner);
    let mut out = [[0.0; 2]; 2];
    for (q, &j) in kept.iter().enumerate() {
        let along = lu.solve(&follows.iter().map(|&i| c(k[i][j], 0.0)).collect::<Vec<_>>());
        for (p, &i) in kept.iter().enumerate() {
            out[p][q] = k[i][j] - follows.iter().zip(&along).map(|(&e, x)| k[i][e] * x.re).sum::<f64>();
        }
    }
    out
}

/// Second moment of area of a tube.
fn tube(outer: f64, inner: f64) -> f64 {
    std::f64::consts::PI * (outer.powi(4) - inner.powi(4)) / 64.0
}

/// Fritsch and Butland's monotone cubic; outside constant or straight.
fn interpolated(x: &[f64], y: &[f64], at: f64, straight: bool) -> f64 {
    let n = x.len();
    let h: Vec<f64> = (1..n).map(|i| x[i] - x[i - 1]).collect();
    let d: Vec<f64> = (1..n).map(|i| (y[i] - y[i - 1]) / h[i - 1]).collect();
    let end = |h0: f64, h1: f64, d0: f64, d1: f64| {
        let s = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
        match (s * d0 <= 0.0, d0 * d1 < 0.0 && s.abs() > 3.0 * d0.abs()) {
            (true, _) => 0.0,
            (_, true) => 3.0 * d0,
            _ => s,
        }
    };
    let slope: Vec<f64> = (0..n)
        .map(|i| match i {
            _ if n == 2 => d[0],
            0 => end(h[0], h[1], d[0], d[1]),
            _ if i == n - 1 => end(h[n - 2], h[n - 3], d[n - 2], d[n - 3]),
            _ if d[i - 1] * d[i] <= 0.0 => 0.0,
            _ => {
                let (p, q) = (2.0 * h[i] + h[i - 1], h[i] + 2.0 * h[i - 1]);
                (p + q) / (p / d[i - 1] + q / d[i])
            }
        })
        .collect();
    let (first, last) = (x[0], x[n - 1]);
    if at <= first || at >= last {
        let k = if at <= first { 0 } else { n - 1 };
        return y[k] + if straight { slope[k] * (at - x[k]) } else { 0.0 };
    }
    let i = (0..n - 1).rfind(|&i| x[i] <= at).unwrap();
    let t = (at - x[i]) / h[i];
    let (u, v) = (t * t, t * t * t);
    (2.0 * v - 3.0 * u + 1.0) * y[i] + (v - 2.0 * u + t) * h[i] * slope[i] + (3.0 * u - 2.0 * v) * y[i + 1] + (v - u) * h[i] * slope[i + 1]
}

/// A quarter turn of displacement and of tilt.
const QUARTER: [[f64; 4]; 4] = [[0.0, -1.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, -1.0], [0.0, 0.0, 1.0, 0.0]];

impl Assembly {
    pub fn new(m: &Machine, w: f64) -> Assembly {
        let mut first = Vec::new();
        let mut n = 0;
        for i in 0..m.bodies.len() {
            first.push(n);
            n += if m.tilts(i) { 4 } else { 2 };
        }
        let size = 2 * n + m.states();
        let (mut mass, mut damping, mut stiffness) = (zeros(n, n), zeros(n, n), zeros(n, n));
        let mut steady = vec![0.0; n];
        let mut turning = vec![c(0.0, 0.0); n];
        let g = if m.horizontal { GRAVITY } else { 0.0 };
        for (i, b) in m.bodies.iter().enumerate() {
            let k = first[i];
            match *b {
                Body::Base { mass: m, stiffness: s, damping: d } => {
                    for j in 0..2 {
                        mass[k + j][k + j] += m;
                        stiffness[k + j][k + j] += s[j];
                        damping[k + j][k + j] += d[j];
                    }
                    steady[k + 1] -= m * g;
                }
                Body::Disc { mass: m, eccentricity, phase, unbalance, polar, tilt } => {
                    let h = tilt.map_or(0.0, |t| t.height);
                    // the centre of mass: x + h beta, y - h alpha
                    let places: [&[(usize, f64)]; 2] = [&[(k, 1.0), (k + 3, h)], &[(k + 1, 1.0), (k + 2, -h)]];
                    let load = C::cis(phase).scale((m * eccentricity + unbalance) * w * w);
                    for (axis, terms) in places.iter().enumerate() {
                        for &(p, x) in terms.iter().filter(|t| t.1 != 0.0) {
                            for &(q, y) in terms.iter().filter(|t| t.1 != 0.0) {
                                mass[p][q] += m * x * y;
                            }
                            turning[p] = turning[p] + [load, load * c(0.0, -1.0)][axis].scale(x);
                            if axis == 1 {
                                steady[p] -= m * g * x;
                            }
                        }
                    }
                    if let Some(t) = tilt {
                        mass[k + 2][k + 2] += t.diametral;
                        mass[k + 3][k + 3] += t.diametral;
                        damping[k + 2][k + 3] += polar * w;
                        damping[k + 3][k + 2] -= polar * w;
                        let load = C::cis(t.skew_phase).scale((t.diametral - polar) * w * w * t.skew);
                        turning[k + 2] = turning[k + 2] + load;
                        turning[k + 3] = turning[k + 3] + load * c(0.0, -1.0);
                    }
                }
            }
        }
        let (mut e, mut a) = (zeros(size, size), zeros(size, size));
        let mut all_steady = vec![0.0; size];
        let mut state = 2 * n;
        for j in &m.joints {
            let (one, other) = (place(m, &first, n, &j.ends[0]), place(m, &first, n, &j.ends[1]));
            let between: Real = one.iter().zip(&other).map(|(p, q)| p.iter().zip(q).map(|(p, q)| p - q).collect()).collect();
            let (mut k, mut d) = ([[0.0; 4]; 4], [[0.0; 4]; 4]);
            let mut coefficients = |x: &[f64; 8]| {
                for i in 0..4 {
                    k[i / 2][i % 2] = x[i];
                    d[i / 2][i % 2] = x[4 + i];
                }
            };
            match &j.law {
                Law::Bearing { coefficients: x, .. } => coefficients(x),
                Law::Table { speed, columns, straight } => {
                    coefficients(&std::array::from_fn(|i| interpolated(speed, &columns[i], w, *straight)));
                }
                Law::Damper { rotating, damping, tilt } => {
                    for (i, x) in [damping[0], damping[1], *tilt, *tilt].into_iter().enumerate() {
                        d[i][i] = x;
                    }
                    if *rotating {
                        k = times(&d, &QUARTER, -w);
                    }
                }
                Law::Lumped { stiffness: [x, y], cross, coupling, tilt, material } => {
                    let kc = *coupling;
                    k = [[*x, *cross, 0.0, kc], [*cross, *y, -kc, 0.0], [0.0, -kc, *tilt, 0.0], [kc, 0.0, 0.0, *tilt]];
                    d = k.map(|row| row.map(|x| x * material));
                    let inside = times(&d, &QUARTER, -w);
                    k.iter_mut().flatten().zip(inside.iter().flatten()).for_each(|(k, x)| *k += x);
                }
                Law::Span { below, above, diameter, inner, modulus, lower, upper } => {
                    let bending = modulus * tube(*diameter, *inner);
                    let plane = |i: usize| beam([*below, *above], bending, [Held::Spring(lower[i]), Held::Spring(upper[i])], false);
                    k = planes(plane(0), plane(1));
                }
                Law::Round { below, above, clamped, diameter, inner, modulus, moment, material } => {
                    let held = clamped.map(|c| if c { Held::Clamped } else { Held::Pinned });
                    let plane = beam([*below, *above], modulus * tube(*diameter, *inner), held, !moment);
                    k = planes(plane, plane);
                    d = k.map(|row| row.map(|x| x * material));
                    let inside = times(&d, &QUARTER, -w);
                    k.iter_mut().flatten().zip(inside.iter().flatten()).for_each(|(k, x)| *k += x);
                }
                Law::Memory { stiffness, shares, rates, rotor } => {
                    (k[0][0], k[1][1]) = (*stiffness, *stiffness);
                    for (share, rate) in shares.iter().zip(rates) {
                        for axis in 0..2 {
                            e[state + axis][state + axis] = 1.0;
                            a[state + axis][state + axis] = -rate;
                            for (q, &x) in between[axis].iter().enumerate() {
                                a[state + axis][q] += share * rate * x;
                                a[n + q][state + axis] += stiffness * x;
                            }
                        }
                        if *rotor {
                            (a[state][state + 1], a[state + 1][state]) = (-w, w);
                        }
                        state += 2;
                    }
                }
                Law::Liquid { radius, height, density, surface, wave_damping } => {
                    let full = std::f64::consts::PI * radius * radius * height * density;
                    let fill = (radius * radius - surface * surface) / (radius * radius + surface * surface);
                    let mut moved = [[0.0; 4]; 4];
                    (moved[0][0], moved[1][1]) = (full * fill, full * fill);
                    add(&mut mass, &one, &moved);
                    // complex states flow and surface: rows and columns of their real and imaginary parts
                    let put = |to: &mut Real, row: usize, column: usize, x: C| {
                        for (i, j, x) in [(0, 0, x.re), (0, 1, -x.im), (1, 0, x.im), (1, 1, x.re)] {
                            to[row + i][column + j] += x;
                        }
                    };
                    let (flow, top) = (state, state + 2);
                    put(&mut a, flow, flow, c(-2.0 * wave_damping, w * (1.0 + 2.0 * fill)));
                    put(&mut a, flow, top, c(fill * w * w, 0.0));
                    put(&mut a, top, top, c(0.0, w));
                    put(&mut a, top, flow, c(-1.0, 0.0));
                    (0..4).for_each(|i| e[state + i][state + i] = 1.0);
                    for (axis, row) in one.iter().enumerate().take(2) {
                        for (q, &x) in row.iter().enumerate().filter(|x| *x.1 != 0.0) {
                            e[flow + axis][n + q] += fill * x;
                            // on the wall: -full (1 - fill)(2 i w flow + w^2 surface)
                            let outer = full * (1.0 - fill) * x;
                            a[n + q][flow + 1 - axis] += if axis == 0 { 2.0 * w * outer } else { -2.0 * w * outer };
                            a[n + q][top + axis] -= w * w * outer;
                            if axis == 1 {
                                steady[q] -= full * fill * x * g;
                            }
                        }
                    }
                    all_steady[flow + 1] -= fill * g;
                    state += 4;
                }
            }
            add(&mut stiffness, &between, &k);
            add(&mut damping, &between, &d);
        }
        for i in 0..n {
            (e[i][i], a[i][n + i]) = (1.0, 1.0);
            for j in 0..n {
                e[n + i][n + j] = mass[i][j];
                a[n + i][j] = -stiffness[i][j];
                a[n + i][n + j] = -damping[i][j];
            }
            all_steady[n + i] = steady[i];
        }
        let mut load = vec![c(0.0, 0.0); size];
        load[n..2 * n].copy_from_slice(&turning);
        Assembly { e, a, steady: all_steady, turning: load, first }
    }

    /// `s E - A`.
    pub fn at(&self, s: C) -> Complex {
        let rows = self.e.iter().zip(&self.a);
        rows.map(|(e, a)| e.iter().zip(a).map(|(&e, &a)| s.scale(e) - c(a, 0.0)).collect()).collect()
    }
    pub fn complex_e(&self) -> Complex {
        complex(&self.e)
    }
    /// The complex amplitudes of the motion at the speed of the rotor.
    pub fn response(&self, w: f64) -> Vec<C> {
        Lu::new(self.at(c(0.0, w))).solve(&self.turning)
    }
}

/// Over x, y, alpha and beta, from the planes of (x, beta) and (y, -alpha).
fn planes(x: [[f64; 2]; 2], y: [[f64; 2]; 2]) -> [[f64; 4]; 4] {
    let mut k = [[0.0; 4]; 4];
    (k[0][0], k[0][3], k[3][0], k[3][3]) = (x[0][0], x[0][1], x[1][0], x[1][1]);
    (k[1][1], k[1][2], k[2][1], k[2][2]) = (y[0][0], -y[0][1], -y[1][0], y[1][1]);
    k
}

/// `f a b`.
fn times(a: &[[f64; 4]; 4], b: &[[f64; 4]; 4], f: f64) -> [[f64; 4]; 4] {
    std::array::from_fn(|i| std::array::from_fn(|j| f * (0..4).map(|k| a[i][k] * b[k][j]).sum::<f64>()))
}
