//! Polynomials with complex coefficients, their roots, and the double roots of families of polynomials.

use crate::complex::{C64, c};
use crate::dense::{Field, Lu, Mat};
use std::f64::consts::PI;

/// Value at x of the polynomial with the given coefficients, lowest first (Horner).
pub fn eval<T: Field>(coefficients: &[T], x: T) -> T {
    coefficients.iter().rev().fold(T::ZERO, |p, &a| p * x + a)
}

/// Value, first derivative and half the second derivative at x (Horner).
pub fn eval2<T: Field>(coefficients: &[T], x: T) -> (T, T, T) {
    let zero = (T::ZERO, T::ZERO, T::ZERO);
    coefficients.iter().rev().fold(zero, |(p, d, h), &a| (p * x + a, d * x + p, h * x + d))
}

/// Sum of two polynomials.
pub fn add<T: Field>(a: &[T], b: &[T]) -> Vec<T> {
    let at = |p: &[T], i: usize| p.get(i).copied().unwrap_or(T::ZERO);
    (0..a.len().max(b.len())).map(|i| at(a, i) + at(b, i)).collect()
}

/// Product of two polynomials.
pub fn mul<T: Field>(a: &[T], b: &[T]) -> Vec<T> {
    if a.is_empty() || b.is_empty() {
        return vec![];
    }
    let mut p = vec![T::ZERO; a.len() + b.len() - 1];
    for (i, &x) in a.iter().enumerate() {
        for (j, &y) in b.iter().enumerate() {
            p[i + j] += x * y;
        }
    }
    p
}

/// The monic polynomial with the given roots.
pub fn from_roots<T: Field>(roots: &[T]) -> Vec<T> {
    roots.iter().fold(vec![T::ONE], |p, &r| mul(&p, &[-r, T::ONE]))
}

/// A root and a bound for its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// The root.
    pub value: C64,
    /// Radius of a disc about it. The union of all discs holds all roots, and as many as discs are in each connected part (B. T. Smith, J. ACM
    /// 17 (1970) 661), the rounding errors of the evaluation included. It is infinite where two computed roots coincide.
    pub radius: f64,
}

/// Why roots could not be found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RootError {
    /// All coefficients are zero: every number is a root.
    Zero,
    /// A coefficient is NaN or infinite.
    NotFinite,
    /// The iteration did not converge.
    NoConvergence,
}

impl std::fmt::Display for RootError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            RootError::Zero => "every number is a root of the zero polynomial",
            RootError::NotFinite => "a coefficient is not finite",
            RootError::NoConvergence => "the root iteration did not converge",
        })
    }
}
impl std::error::Error for RootError {}

/// All finite roots of a polynomial (lowest coefficient first), by the Ehrlich-Aberth iteration from the Newton polygon
/// (D. A. Bini, Numer. Algorithms 13 (1996) 179). Leading zeros lower the degree, trailing zeros are exact roots at 0.
/// Sorted by |Im|, then Re, then positive Im first.
pub fn roots(coefficients: &[C64]) -> Result<Vec<Root>, RootError> {
    let (p, zeros) = trimmed(coefficients)?;
    let z = aberth(&p)?;
    Ok(finish(&p, z, zeros))
}

/// Roots of a polynomial with real coefficients; complex ones come as exactly conjugate pairs and real ones are real.
pub fn real_roots(coefficients: &[f64]) -> Result<Vec<Root>, RootError> {
    let complex: Vec<C64> = coefficients.iter().map(|&a| c(a, 0.0)).collect();
    let (p, zeros) = trimmed(&complex)?;
    let z = conjugate_symmetric(&p, aberth(&p)?);
    Ok(finish(&p, z, zeros))
}

/// Without leading and trailing zeros, scaled to a largest coefficient near one; and the number of trailing zeros.
fn trimmed(p: &[C64]) -> Result<(Vec<C64>, usize), RootError> {
    if p.iter().any(|a| !a.is_finite()) {
        return Err(RootError::NotFinite);
    }
    let first = p.iter().position(|a| a.size() != 0.0).ok_or(RootError::Zero)?;
    let last = p.iter().rposition(|a| a.size() != 0.0).ok_or(RootError::Zero)?;
    let largest = p.iter().map(|a| a.size()).fold(0.0, f64::max);
    let k = largest.log2().floor().clamp(-1000.0, 1000.0);
    // In two halves, because 2^-k itself may overflow.
    let (h, g) = ((-0.5 * k).floor(), -k - (-0.5 * k).floor());
    Ok((p[first..=last].iter().map(|a| a.scale(h.exp2()).scale(g.exp2())).collect(), first))
}

/// `p/p'`, |p| and a bound of its rounding error (both over |x|^n where |x| > 1), by Horner's rule in x or 1/x, whichever is small.
fn newton(p: &[C64], x: C64) -> (C64, f64, f64) {
    let n = p.len() - 1;
    let a = x.abs();
    let horner = |coefficients: &mut dyn Iterator<Item = C64>, x: C64, a: f64| {
        coefficients.fold((C64::ZERO, C64::ZERO, 0.0), |(v, d, e), b| (v * x + b, d * x + v, e * a + b.abs()))
    };
    // Complex Horner: each step adds one product (2 sqrt 2 roundings) and one sum.
    let unit = 4.0 * (n as f64 + 1.0) * f64::EPSILON;
    if a <= 1.0 {
        let (v, d, e) = horner(&mut p.iter().rev().copied(), x, a);
        (v / d, v.abs(), unit * e)
    } else {
        // p(x) = x^n q(1/x): p'/p = (n - y q'/q) y with y = 1/x.
        let y = x.recip();
        let (v, d, e) = horner(&mut p.iter().copied(), y, 1.0 / a);
        (v / ((v.scale(n as f64) - y * d) * y), v.abs(), unit * e)
    }
}

/// Starting points: on circles whose radii are the slopes of the upper convex hull of the points (k, ln |p_k|).
fn start(p: &[C64]) -> Vec<C64> {
    let points: Vec<(usize, f64)> =
        p.iter().enumerate().filter(|(_, a)| a.size() != 0.0).map(|(k, a)| (k, a.abs().ln())).filter(|q| q.1.is_finite()).collect();
    let mut hull: Vec<(usize, f64)> = vec![];
    for &q in &points {
        while hull.len() >= 2 {
            let (a, b) = (hull[hull.len() - 2], hull[hull.len() - 1]);
            if (b.1 - a.1) * (q.0 - a.0) as f64 <= (q.1 - a.1) * (b.0 - a.0) as f64 {
                hull.pop();
            } else {
                break;
            }
        }
        hull.push(q);
    }
    let n = (p.len() - 1) as f64;
    let mut z = Vec::with_capacity(p.len() - 1);
    for (i, w) in hull.windows(2).enumerate() {
        let m = w[1].0 - w[0].0;
        let radius = ((w[0].1 - w[1].1) / m as f64).exp();
        for k in 0..m {
            // Angles that share no symmetry with the real axis.
            let angle = 2.0 * PI * (k as f64 / m as f64 + i as f64 / n) + 0.7;
            z.push(C64::cis(angle).scale(radius));
        }
    }
    z
}

fn aberth(p: &[C64]) -> Result<Vec<C64>, RootError> {
    let n = p.len() - 1;
    if n == 0 {
        return Ok(vec![]);
    }
    let mut z = start(p);
    if z.len() != n || z.iter().any(|z| !z.is_finite()) {
        return Err(RootError::NotFinite);
    }
    let mut done = vec![false; n];
    for _ in 0..500 {
        for i in 0..n {
            if done[i] {
                continue;
            }
            let (q, size, noise) = newton(p, z[i]);
            if size <= noise {
                done[i] = true;
                continue;
            }
            let others = (0..n).filter(|&j| j != i && z[j] != z[i]).fold(C64::ZERO, |s, j| s + (z[i] - z[j]).recip());
            let step = if q.is_finite() { q / (C64::ONE - q * others) } else { -others.recip() };
            if !step.is_finite() {
                // A stationary point of p or of the correction: leave it sideways.
                z[i] = z[i] * C64::cis(0.1) + c(f64::EPSILON, 0.0);
                continue;
            }
            z[i] -= step;
            done[i] = step.abs() <= 0.5 * f64::EPSILON * z[i].abs();
        }
        if done.iter().all(|&d| d) {
            polish(p, &mut z);
            return Ok(z);
        }
    }
    Err(RootError::NoConvergence)
}

/// The bound of the rounding error that stops the iteration is generous; a few steps more are taken as long as they halve |p|.
fn polish(p: &[C64], z: &mut [C64]) {
    for r in z {
        let (mut q, mut size, _) = newton(p, *r);
        for _ in 0..4 {
            let next = *r - q;
            let (q2, size2, _) = newton(p, next);
            if !next.is_finite() || size2.is_nan() || size2 > 0.5 * size {
                break;
            }
            (*r, q, size) = (next, q2, size2);
        }
    }
}

/// Makes the roots of a real polynomial symmetric: a root is real if its conjugate is nearer to itself than to any other root, and
/// one of a pair with that other if not.
fn conjugate_symmetric(p: &[C64], mut z: Vec<C64>) -> Vec<C64> {
    let mut out = Vec::with_capacity(z.len());
    z.sort_by(|a, b| a.im.abs().total_cmp(&b.im.abs()));
    while let Some(r) = z.pop() {
        let distance = |k: usize| (z[k] - r.conj()).abs();
        let nearest = (0..z.len()).min_by(|&i, &j| distance(i).total_cmp(&distance(j)));
        let size = |x: C64| newton(p, x).1;
        // Symmetry costs nothing if the best of the candidates is taken.
        let best = |candidates: &[C64]| candidates.iter().copied().min_by(|&a, &b| size(a).total_cmp(&size(b)));
        match nearest.filter(|&k| distance(k) < 2.0 * r.im.abs()) {
            Some(k) => {
                let s = z.remove(k);
                let upper = |x: C64| c(x.re, x.im.abs());
                let r = best(&[upper(r), upper(s), upper((r + s.conj()).scale(0.5))]).unwrap_or(r);
                out.extend([r, r.conj()]);
            }
            None => {
                let flat = c(r.re, 0.0);
                let (q, ..) = newton(p, flat);
                let polished = c(flat.re - q.re, 0.0);
                out.push(if polished.is_finite() { best(&[flat, polished]).unwrap_or(flat) } else { flat });
            }
        }
    }
    out
}

/// Adds the roots at zero, error radii and order.
fn finish(p: &[C64], z: Vec<C64>, zeros: usize) -> Vec<Root> {
    let n = z.len();
    let lead = p[n].abs();
    let radius = |i: usize| {
        let (_, size, noise) = newton(p, z[i]);
        // n |p(z_i)| / (|p_n| prod |z_i - z_j|), factor by factor so that nothing overflows.
        let mut r = n as f64 * (size + noise) / lead;
        let big = z[i].abs().max(1.0);
        for j in (0..n).filter(|&j| j != i) {
            r *= big / (z[i] - z[j]).abs();
        }
        r * big
    };
    let mut roots: Vec<Root> = (0..n).map(|i| Root { value: z[i], radius: radius(i) }).collect();
    roots.extend((0..zeros).map(|_| Root { value: C64::ZERO, radius: 0.0 }));
    roots.sort_by(|a, b| {
        let (a, b) = (a.value, b.value);
        a.im.abs().total_cmp(&b.im.abs()).then(a.re.total_cmp(&b.re)).then(b.im.total_cmp(&a.im))
    });
    roots
}

/// Value and derivatives of a family p(x; l) at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Family<T> {
    /// p.
    pub p: T,
    /// dp/dx.
    pub x: T,
    /// d2p/dx2.
    pub xx: T,
    /// dp/dl.
    pub l: T,
    /// d2p/(dx dl).
    pub xl: T,
}

/// A point with `p = 0` and `dp/dx = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoubleRoot<T> {
    /// The double root.
    pub x: T,
    /// The parameter.
    pub l: T,
    /// Size of the last Newton steps in x and l: estimates of the errors that remain, of the order of rounding.
    pub step: (f64, f64),
}

/// No double root was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DoubleRootError {
    /// The equations are degenerate where the iteration arrived: a triple root, or no dependence on the parameter.
    Degenerate,
    /// Newton's method did not converge.
    NoConvergence,
}

impl std::fmt::Display for DoubleRootError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            DoubleRootError::Degenerate => "the equations of the double root are degenerate",
            DoubleRootError::NoConvergence => "Newton's method for the double root did not converge",
        })
    }
}
impl std::error::Error for DoubleRootError {}

/// Newton's method in (x, l) for a double root, such as the edge of an instability band. Converges to rounding errors, not to their
/// square root, because the double root is a simple zero of (p, p_x).
pub fn double_root<T: Field>(family: impl Fn(T, T) -> Family<T>, x: T, l: T) -> Result<DoubleRoot<T>, DoubleRootError> {
    let (mut x, mut l) = (x, l);
    let mut last = (f64::INFINITY, f64::INFINITY);
    let mut jacobian = Mat::zeros(2, 2);
    for _ in 0..60 {
        let f = family(x, l);
        // Columns are scaled alike to keep pivots meaningful; rows: p and its derivative.
        for (i, row) in [[f.x, f.l], [f.xx, f.xl]].iter().enumerate() {
            jacobian.row_mut(i).copy_from_slice(row);
        }
        let mut step = [-f.p, -f.x];
        Lu::new(&jacobian).map_err(|_| DoubleRootError::Degenerate)?.solve(&mut step);
        let size = (step[0].size(), step[1].size());
        if !(size.0.is_finite() && size.1.is_finite()) {
            return Err(DoubleRootError::Degenerate);
        }
        x += step[0];
        l += step[1];
        let small = |s: f64, v: f64| s <= 1e-9 * v;
        // From 1e-9 on quadratic convergence has reached rounding when steps no longer shrink.
        let converging = small(size.0, x.size()) || size.0 == 0.0 || x.size() < f64::MIN_POSITIVE;
        let converging = converging && (small(size.1, l.size()) || size.1 == 0.0 || size.1 <= 1e-9 * last.1);
        if (converging && (size.0 >= 0.5 * last.0 || size.1 >= 0.5 * last.1)) || (size.0 == 0.0 && size.1 == 0.0) {
            return Ok(DoubleRoot { x, l, step: size });
        }
        last = size;
    }
    Err(DoubleRootError::NoConvergence)
}

/// Like [`double_root`] for a function that gives only `(p, dp/dx)`; other derivatives by central differences over steps `h = (h_x, h_l)`,
/// which slow the convergence but do not move the result.
pub fn double_root_by_differences(
    p: impl Fn(f64, f64) -> (f64, f64),
    x: f64,
    l: f64,
    h: (f64, f64),
) -> Result<DoubleRoot<f64>, DoubleRootError> {
    let family = |x: f64, l: f64| {
        let ((p0, x0), (right, left), (up, down)) = (p(x, l), (p(x + h.0, l), p(x - h.0, l)), (p(x, l + h.1), p(x, l - h.1)));
        Family { p: p0, x: x0, xx: (right.1 - left.1) / (2.0 * h.0), l: (up.0 - down.0) / (2.0 * h.1), xl: (up.1 - down.1) / (2.0 * h.1) }
    };
    double_root(family, x, l)
}

/// Double root of a polynomial in x whose real coefficients (lowest first) depend on l; derivatives in l by central differences over `h`.
pub fn double_root_of(coefficients: impl Fn(f64) -> Vec<f64>, x: f64, l: f64, h: f64) -> Result<DoubleRoot<f64>, DoubleRootError> {
    let family = |x: f64, l: f64| {
        let ((p, px, half), up, down) = (eval2(&coefficients(l), x), eval2(&coefficients(l + h), x), eval2(&coefficients(l - h), x));
        Family { p, x: px, xx: 2.0 * half, l: (up.0 - down.0) / (2.0 * h), xl: (up.1 - down.1) / (2.0 * h) }
    };
    double_root(family, x, l)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn real(p: &[f64]) -> Vec<C64> {
        p.iter().map(|&x| c(x, 0.0)).collect()
    }

    #[test]
    fn arithmetic() {
        assert_eq!(mul(&[1.0, 2.0], &[3.0, 0.0, 1.0]), vec![3.0, 6.0, 1.0, 2.0]);
        assert_eq!(add(&[1.0], &[1.0, 5.0]), vec![2.0, 5.0]);
        assert_eq!(mul::<f64>(&[], &[1.0]), Vec::<f64>::new());
        assert_eq!(eval2(&[1.0, -3.0, 0.0, 2.0], 2.0), (11.0, 21.0, 12.0));
        assert_eq!(eval(&[1.0, -3.0, 0.0, 2.0], 2.0), 11.0);
    }

    #[test]
    fn scattered_roots_are_found_to_their_radius() {
        let exact = [c(1e-6, 0.0), c(0.5, 2.0), c(-3.0, 1.0), c(1e5, -1e5), c(0.0, -0.01), c(40.0, 0.0)];
        let found = roots(&from_roots(&exact)).unwrap();
        for e in exact {
            let r = found.iter().min_by(|a, b| (a.value - e).abs().total_cmp(&(b.value - e).abs())).unwrap();
            assert!((r.value - e).abs() <= 1e-13 * e.abs() && r.radius < 1e-11 * e.abs(), "{e:?} {r:?}");
        }
    }

    #[test]
    fn closed_forms_and_degenerate_input() {
        let r = real_roots(&[2.0, -3.0, 1.0]).unwrap();
        assert_eq!((r[0].value, r[1].value), (c(1.0, 0.0), c(2.0, 0.0)));
        let r = real_roots(&[0.0, 0.0, 4.0, 0.0, 1.0, 0.0, 0.0]).unwrap();
        assert_eq!(r.iter().map(|r| r.value).collect::<Vec<_>>(), vec![C64::ZERO, C64::ZERO, c(0.0, 2.0), c(0.0, -2.0)]);
        assert_eq!(real_roots(&[5.0]).unwrap(), vec![]);
        assert_eq!(real_roots(&[0.0, 3.0, 0.0]).unwrap().len(), 1);
        assert_eq!(real_roots(&[0.0, 0.0]), Err(RootError::Zero));
        assert_eq!(real_roots(&[]), Err(RootError::Zero));
        assert_eq!(real_roots(&[1.0, f64::NAN]), Err(RootError::NotFinite));
        // A vanishing leading coefficient sends a root far away and leaves the others.
        let r = real_roots(&[2.0, -3.0, 1.0, 1e-30]).unwrap();
        assert!((r[1].value - C64::ONE).abs() < 1e-15 && (r[0].value.re / -1e30 - 1.0).abs() < 1e-14);
        // Extreme scales.
        let r = real_roots(&[-4e300, 0.0, 1e300]).unwrap();
        assert!((r[1].value - c(2.0, 0.0)).abs() < 1e-15);
        let r = real_roots(&[-4e-300, 0.0, 1e-300]).unwrap();
        assert!((r[1].value - c(2.0, 0.0)).abs() < 1e-15);
        // x^40 - 1.
        let mut p = vec![0.0; 41];
        (p[0], p[40]) = (-1.0, 1.0);
        for r in real_roots(&p).unwrap() {
            let turns = r.value.arg() / (2.0 * PI) * 40.0;
            assert!((r.value.abs() - 1.0).abs() < 1e-14 && (turns - turns.round()).abs() < 1e-13);
        }
    }

    #[test]
    fn wilkinson_polynomial() {
        // At degree 20 rounding of the coefficients alone moves the middle roots by some tenths: a small backward error is all there is,
        // and the discs must hold the exact roots.
        let exact: Vec<f64> = (1..=20).map(f64::from).collect();
        let p = from_roots(&exact);
        let r = real_roots(&p).unwrap();
        assert_eq!(r.len(), 20);
        for root in &r {
            let weight = eval(&p.iter().map(|a| a.abs()).collect::<Vec<_>>(), root.value.abs());
            assert!(eval(&real(&p), root.value).abs() <= 20.0 * f64::EPSILON * weight);
        }
        for &e in &exact {
            assert!(r.iter().any(|r| (r.value - c(e, 0.0)).abs() <= r.radius), "{e}");
        }
        // To degree 15 the coefficients are exact.
        let exact: Vec<f64> = (1..=15).map(f64::from).collect();
        for (r, e) in real_roots(&from_roots(&exact)).unwrap().iter().zip(exact) {
            assert!(r.value.im == 0.0 && (r.value.re - e).abs() < 1e-4 && (r.value.re - e).abs() <= r.radius, "{r:?}");
        }
    }

    #[test]
    fn multiple_roots_err_by_the_root_of_rounding_and_say_so() {
        for m in [2usize, 3, 5] {
            let mut exact = vec![c(1.0, 0.0); m];
            exact.push(c(-2.0, 0.5));
            let r = roots(&from_roots(&exact)).unwrap();
            let limit = 20.0 * f64::EPSILON.powf(1.0 / m as f64);
            let near: Vec<&Root> = r.iter().filter(|r| (r.value - C64::ONE).abs() < 0.5).collect();
            assert_eq!(near.len(), m);
            for r in near {
                let error = (r.value - C64::ONE).abs();
                assert!(error < limit, "{m} {error}");
                assert!(r.radius >= 0.5 * error);
            }
        }
    }

    #[test]
    fn real_polynomials_have_conjugate_pairs() {
        let mut s = 3u64;
        let mut next = || {
            s = s.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (s >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for n in 1..=30usize {
            let p: Vec<f64> = (0..=n).map(|_| next()).collect();
            let r = real_roots(&p).unwrap();
            assert_eq!(r.len(), n);
            let mut i = 0;
            while i < n {
                if r[i].value.im != 0.0 {
                    assert_eq!(r[i].value.conj(), r[i + 1].value);
                    i += 1;
                }
                i += 1;
            }
            let sum = r.iter().fold(C64::ZERO, |s, r| s + r.value);
            assert!((sum.re + p[n - 1] / p[n]).abs() < 1e-12 * (1.0 + (p[n - 1] / p[n]).abs()));
            for r in &r {
                let (_, size, noise) = newton(&real(&p), r.value);
                assert!(size <= 4.0 * noise);
            }
        }
    }

    #[test]
    fn band_edges() {
        // x^2 - 2 x + l: double root 1 at l = 1.
        let r = double_root_of(|l| vec![l, -2.0, 1.0], 1.3, 0.4, 1e-4).unwrap();
        assert!((r.x - 1.0).abs() < 1e-15 && (r.l - 1.0).abs() < 1e-15);
        // x^3 - 3 x + l: x = 1, l = 2 and x = -1, l = -2.
        for s in [1.0, -1.0] {
            let r =
                double_root(|x, l| Family { p: x * x * x - 3.0 * x + l, x: 3.0 * x * x - 3.0, xx: 6.0 * x, l: 1.0, xl: 0.0 }, 0.6 * s, s);
            let r = r.unwrap();
            assert!((r.x - s).abs() < 1e-15 && (r.l - 2.0 * s).abs() < 4e-15);
        }
        // (x^2 - 1)(x^2 - l^2) - e: bands of the coupled pair. Double at x^2 = (1 + l^2)/2 with (1 - l^2)^2 = -4 e.
        let e: f64 = -0.01;
        let exact = (1.0 + 2.0 * (-e).sqrt()).sqrt();
        let r = double_root_of(|l| vec![l * l - e, 0.0, -1.0 - l * l, 0.0, 1.0], 1.06, 1.12, 1e-5).unwrap();
        assert!((r.l - exact).abs() < 1e-13 && (r.x - (0.5 * (1.0 + exact * exact)).sqrt()).abs() < 1e-13, "{r:?}");
        // A transcendental family by differences: cosh-like edge cos x = l has double root x = 0, l = 1.
        let r = double_root_by_differences(|x, l| ((x - 2.0).cos() - l, -(x - 2.0).sin()), 2.2, 0.9, (1e-4, 1e-4)).unwrap();
        assert!((r.x - 2.0).abs() < 1e-12 && (r.l - 1.0).abs() < 1e-14, "{r:?}");
        // Complex coefficients: (x - i)^2 - (l - 2).
        let family = |x: C64, l: C64| {
            let d = x - C64::i();
            Family { p: d * d - l + c(2.0, 0.0), x: d.scale(2.0), xx: c(2.0, 0.0), l: -C64::ONE, xl: C64::ZERO }
        };
        let r = double_root(family, c(0.2, 0.7), c(1.0, 0.3)).unwrap();
        assert!((r.x - C64::i()).abs() < 1e-14 && (r.l - c(2.0, 0.0)).abs() < 1e-14);
        // No dependence on l, and a family without double roots.
        let nothing = double_root(|x, _| Family { p: x * x - 1.0, x: 2.0 * x, xx: 2.0, l: 0.0, xl: 0.0 }, 0.5, 0.0);
        assert_eq!(nothing, Err(DoubleRootError::Degenerate));
        assert!(
            double_root(|x: f64, l: f64| Family { p: x.exp() + l * l + 1.0, x: x.exp(), xx: x.exp(), l: 2.0 * l, xl: 0.0 }, 0.5, 0.3)
                .is_err()
        );
    }
}
