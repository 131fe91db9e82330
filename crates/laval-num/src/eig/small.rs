//! Eigenvalues of small real matrices: Householder reduction to Hessenberg form and the Francis double-shift QR iteration.
//! No allocation and no set-up, so that thousands of small spectra cost little.
//!
//! Source of the iteration: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., section 7.5; deflation test of
//! M. Ahues and F. Tisseur (LAPACK Working Note 122), which keeps the small eigenvalues of graded matrices.

use super::EigError;
use crate::complex::{C64, c};
use crate::work::spend;

/// Eigenvalues of the row-major n x n matrix `h`, which is destroyed. Pairs are adjacent and exactly conjugate, Im > 0 first.
pub(super) fn eigenvalues(h: &mut [f64], n: usize, out: &mut Vec<C64>) -> Result<(), EigError> {
    spend((15 * n * n * n) as u64);
    hessenberg(h, n);
    francis(h, n, out)
}

fn hessenberg(h: &mut [f64], n: usize) {
    for k in 0..n.saturating_sub(2) {
        let scale = (k + 1..n).fold(0.0f64, |m, i| m.max(h[i * n + k].abs()));
        let below = (k + 2..n).fold(0.0f64, |m, i| m.max(h[i * n + k].abs()));
        if below == 0.0 {
            continue;
        }
        // The vector of the reflection replaces the column below the subdiagonal; its first component is one.
        let mut s = 0.0;
        for i in k + 1..n {
            let x = h[i * n + k] / scale;
            s += x * x;
        }
        let alpha = h[(k + 1) * n + k];
        let beta = -(s.sqrt() * scale).copysign(alpha);
        let tau = (beta - alpha) / beta;
        let inv = 1.0 / (alpha - beta);
        for i in k + 2..n {
            // the inverse of a subnormal number is not finite
            h[i * n + k] = if inv.is_finite() { h[i * n + k] * inv } else { h[i * n + k] / (alpha - beta) };
        }
        h[(k + 1) * n + k] = 1.0;
        for i in 0..n {
            let mut s = 0.0;
            for j in k + 1..n {
                s += h[i * n + j] * h[j * n + k];
            }
            s *= tau;
            for j in k + 1..n {
                h[i * n + j] -= s * h[j * n + k];
            }
        }
        for j in k + 1..n {
            let mut s = 0.0;
            for i in k + 1..n {
                s += h[i * n + k] * h[i * n + j];
            }
            s *= tau;
            for i in k + 1..n {
                h[i * n + j] -= s * h[i * n + k];
            }
        }
        h[(k + 1) * n + k] = beta;
        for i in k + 2..n {
            h[i * n + k] = 0.0;
        }
    }
}

const ULP: f64 = f64::EPSILON;

/// The subdiagonal entry left of diagonal k is negligible.
fn negligible(h: &[f64], n: usize, k: usize) -> bool {
    let at = |i: usize, j: usize| h[i * n + j].abs();
    let sub = at(k, k - 1);
    let tiny = f64::MIN_POSITIVE / ULP;
    if sub <= tiny {
        return true;
    }
    let mut near = at(k - 1, k - 1) + at(k, k);
    if near == 0.0 {
        if k >= 2 {
            near += at(k - 1, k - 2);
        }
        if k + 1 < n {
            near += at(k + 1, k);
        }
    }
    if sub > ULP * near {
        return false;
    }
    let (sup, d, gap) = (at(k - 1, k), at(k, k), (h[(k - 1) * n + k - 1] - h[k * n + k]).abs());
    let (ab, ba) = (sub.max(sup), sub.min(sup));
    let (aa, bb) = (d.max(gap), d.min(gap));
    let s = aa + ab;
    ba * (ab / s) <= tiny.max(ULP * (bb * (aa / s)))
}

fn francis(h: &mut [f64], n: usize, out: &mut Vec<C64>) -> Result<(), EigError> {
    out.clear();
    let mut end = n;
    let mut its = 0;
    while end > 0 {
        let i = end - 1;
        let mut l = i;
        while l > 0 && !negligible(h, n, l) {
            l -= 1;
        }
        if l > 0 {
            h[l * n + l - 1] = 0.0;
        }
        if l == i {
            out.push(c(h[i * n + i], 0.0));
            (end, its) = (i, 0);
        } else if l + 1 == i {
            let (p, q) = pair(h[l * n + l], h[l * n + i], h[i * n + l], h[i * n + i]);
            out.extend([p, q]);
            (end, its) = (l, 0);
        } else {
            its += 1;
            if its > 60 {
                return Err(EigError::NoConvergence);
            }
            step(h, n, l, i, its);
        }
    }
    Ok(())
}

/// Eigenvalues of [[a, b], [c, d]].
fn pair(a: f64, b: f64, cc: f64, d: f64) -> (C64, C64) {
    let p = 0.5 * a - 0.5 * d;
    let s = p.abs().max(b.abs().sqrt() * cc.abs().sqrt());
    if s == 0.0 {
        return (c(a, 0.0), c(d, 0.0));
    }
    let bc = (b / s) * (cc / s);
    let disc = (p / s) * (p / s) + bc;
    if disc >= 0.0 {
        let z = p / s + disc.sqrt().copysign(p);
        (c(d + s * z, 0.0), c(if z == 0.0 { d } else { d - s * (bc / z) }, 0.0))
    } else {
        let (re, im) = (d + p, s * (-disc).sqrt());
        (c(re, im), c(re, -im))
    }
}

/// The two shifts (real parts, imaginary part of the first) for rows l..=i.
fn shifts(h: &[f64], n: usize, l: usize, i: usize, its: usize) -> (f64, f64, f64) {
    let at = |r: usize, k: usize| h[r * n + k];
    let (h11, h12, h21, h22) = if its.is_multiple_of(20) {
        let s = at(i, i - 1).abs() + at(i - 1, i - 2).abs();
        (0.75 * s + at(i, i), -0.4375 * s, s, 0.75 * s + at(i, i))
    } else if its.is_multiple_of(10) {
        let s = at(l + 1, l).abs() + at(l + 2, l + 1).abs();
        (0.75 * s + at(l, l), -0.4375 * s, s, 0.75 * s + at(l, l))
    } else {
        (at(i - 1, i - 1), at(i - 1, i), at(i, i - 1), at(i, i))
    };
    let s = h11.abs() + h12.abs() + h21.abs() + h22.abs();
    if s == 0.0 {
        return (0.0, 0.0, 0.0);
    }
    let (h11, h12, h21, h22) = (h11 / s, h12 / s, h21 / s, h22 / s);
    let mean = 0.5 * (h11 + h22);
    let det = (h11 - mean) * (h22 - mean) - h12 * h21;
    let root = det.abs().sqrt();
    if det >= 0.0 {
        (mean * s, mean * s, root * s)
    } else {
        let (p, q) = (mean + root, mean - root);
        let r = if (p - h22).abs() <= (q - h22).abs() { p } else { q } * s;
        (r, r, 0.0)
    }
}

/// One implicit double-shift sweep on rows and columns l..=i.
fn step(h: &mut [f64], n: usize, l: usize, i: usize, its: usize) {
    let (r1, r2, im) = shifts(h, n, l, i, its);
    let mut m = i - 2;
    let mut v = loop {
        let (d, d1, sub) = (h[m * n + m], h[(m + 1) * n + m + 1], h[(m + 1) * n + m]);
        let s = (d - r2).abs() + im.abs() + sub.abs();
        let q = sub / s;
        let v = [q * h[m * n + m + 1] + (d - r1) * ((d - r2) / s) + im * (im / s), q * (d + d1 - r1 - r2), q * h[(m + 2) * n + m + 1]];
        let s = v[0].abs() + v[1].abs() + v[2].abs();
        let v = [v[0] / s, v[1] / s, v[2] / s];
        if m == l {
            break v;
        }
        let (before, left) = (h[(m - 1) * n + m - 1].abs(), h[m * n + m - 1].abs());
        if left * (v[1].abs() + v[2].abs()) <= ULP * v[0].abs() * (before + d.abs() + d1.abs()) {
            break v;
        }
        m -= 1;
    };
    for k in m..i {
        let three = k + 2 <= i;
        if k > m {
            v = [h[k * n + k - 1], h[(k + 1) * n + k - 1], if three { h[(k + 2) * n + k - 1] } else { 0.0 }];
        } else if !three {
            v[2] = 0.0;
        }
        let (beta, tau, v2, v3) = reflector(v);
        if k > m {
            h[k * n + k - 1] = beta;
            h[(k + 1) * n + k - 1] = 0.0;
            if three {
                h[(k + 2) * n + k - 1] = 0.0;
            }
        } else if m > l {
            // Equal to a change of sign, but right also when v2 and v3 underflow.
            h[k * n + k - 1] *= 1.0 - tau;
        }
        let (t2, t3) = (tau * v2, tau * v3);
        if three {
            let (top, rest) = h[k * n..].split_at_mut(n);
            let (mid, low) = rest.split_at_mut(n);
            for ((x, y), z) in top[k..=i].iter_mut().zip(&mut mid[k..=i]).zip(&mut low[k..=i]) {
                let s = *x + v2 * *y + v3 * *z;
                *x -= s * tau;
                *y -= s * t2;
                *z -= s * t3;
            }
            for row in h[l * n..(i.min(k + 3) + 1) * n].chunks_exact_mut(n) {
                let Some([x, y, z]) = row[k..].first_chunk_mut() else { continue };
                let s = *x + v2 * *y + v3 * *z;
                *x -= s * tau;
                *y -= s * t2;
                *z -= s * t3;
            }
        } else {
            let (top, rest) = h[k * n..].split_at_mut(n);
            for (x, y) in top[k..=i].iter_mut().zip(&mut rest[k..=i]) {
                let s = *x + v2 * *y;
                *x -= s * tau;
                *y -= s * t2;
            }
            for row in h[l * n..(i + 1) * n].chunks_exact_mut(n) {
                let s = row[k] + v2 * row[k + 1];
                row[k] -= s * tau;
                row[k + 1] -= s * t2;
            }
        }
    }
}

/// Reflection I - tau w w^T, w = (1, v2, v3), that turns v into (beta, 0, 0).
fn reflector(v: [f64; 3]) -> (f64, f64, f64, f64) {
    let m = v[0].abs().max(v[1].abs()).max(v[2].abs());
    if v[1] == 0.0 && v[2] == 0.0 {
        return (v[0], 0.0, 0.0, 0.0);
    }
    let (x, y, z) = (v[0] / m, v[1] / m, v[2] / m);
    let beta = -(x * x + y * y + z * z).sqrt().copysign(x);
    let inv = 1.0 / (x - beta);
    (beta * m, (beta - x) / beta, y * inv, z * inv)
}
