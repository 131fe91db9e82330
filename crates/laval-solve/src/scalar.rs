//! Roots and maxima of functions of one variable that cannot be differentiated.

/// Root of `f` in a bracket with a change of sign, by Brent's method; `None` where `f` cannot be evaluated or does not change sign.
pub fn root<F: FnMut(f64) -> Option<f64>>(mut f: F, a: (f64, f64), b: (f64, f64), tolerance: f64) -> Option<f64> {
    let ((mut a, mut fa), (mut b, mut fb)) = (a, b);
    if fa == 0.0 {
        return Some(a);
    }
    if fa * fb > 0.0 || (fa * fb).is_nan() {
        return None;
    }
    let (mut c, mut fc) = (a, fa);
    let (mut d, mut e) = (b - a, b - a);
    for _ in 0..200 {
        if fb * fc > 0.0 {
            (c, fc) = (a, fa);
            d = b - a;
            e = d;
        }
        if fc.abs() < fb.abs() {
            (a, b, c) = (b, c, b);
            (fa, fb, fc) = (fb, fc, fb);
        }
        let tol = 2.0 * f64::EPSILON * b.abs() + 0.5 * tolerance;
        let m = 0.5 * (c - b);
        if m.abs() <= tol || fb == 0.0 {
            return Some(b);
        }
        if e.abs() >= tol && fa.abs() > fb.abs() {
            let s = fb / fa;
            let (mut p, mut q) = if a == c {
                (2.0 * m * s, 1.0 - s)
            } else {
                let (q, r) = (fa / fc, fb / fc);
                (s * (2.0 * m * q * (q - r) - (b - a) * (r - 1.0)), (q - 1.0) * (r - 1.0) * (s - 1.0))
            };
            if p > 0.0 {
                q = -q
            } else {
                p = -p
            }
            if 2.0 * p < (3.0 * m * q - (tol * q).abs()).min((e * q).abs()) {
                (e, d) = (d, p / q);
            } else {
                (d, e) = (m, m);
            }
        } else {
            (d, e) = (m, m);
        }
        (a, fa) = (b, fb);
        b += if d.abs() > tol { d } else { tol.copysign(m) };
        fb = f(b)?;
        if fb.is_nan() {
            return None;
        }
    }
    None
}

/// Maximum of `f` between `a` and `b` (one maximum inside), by golden section and parabolas (Brent); the place and the value.
pub fn maximum<F: FnMut(f64) -> Option<f64>>(mut f: F, a: f64, b: f64, tolerance: f64) -> Option<(f64, f64)> {
    const GOLD: f64 = 0.381966011250105;
    let (mut a, mut b) = (a, b);
    let mut x = a + GOLD * (b - a);
    let (mut w, mut v) = (x, x);
    let mut fx = -f(x)?;
    let (mut fw, mut fv) = (fx, fx);
    let (mut d, mut e) = (0.0f64, 0.0f64);
    for _ in 0..200 {
        let m = 0.5 * (a + b);
        let tol = f64::EPSILON.sqrt() * x.abs() * 1e-2 + tolerance;
        if (x - m).abs() <= 2.0 * tol - 0.5 * (b - a) {
            return Some((x, -fx));
        }
        let mut golden = true;
        if e.abs() > tol {
            let r = (x - w) * (fx - fv);
            let q0 = (x - v) * (fx - fw);
            let mut p = (x - v) * q0 - (x - w) * r;
            let mut q = 2.0 * (q0 - r);
            if q > 0.0 {
                p = -p
            } else {
                q = -q
            }
            if p.abs() < (0.5 * q * e).abs() && p > q * (a - x) && p < q * (b - x) {
                (e, d) = (d, p / q);
                let u = x + d;
                if u - a < 2.0 * tol || b - u < 2.0 * tol {
                    d = tol.copysign(m - x);
                }
                golden = false;
            }
        }
        if golden {
            e = if x < m { b - x } else { a - x };
            d = GOLD * e;
        }
        let u = if d.abs() >= tol { x + d } else { x + tol.copysign(d) };
        let fu = -f(u)?;
        if fu <= fx {
            if u < x {
                b = x
            } else {
                a = x
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                a = u
            } else {
                b = u
            }
            if fu <= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu <= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    Some((x, -fx))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_root_and_maximum() {
        let r = root(|x| Some(x.cos() - x), (0.0, 1.0), (1.0, 1.0f64.cos() - 1.0), 1e-15).unwrap();
        assert!((r - 0.739_085_133_215_160_6).abs() < 1e-15);
        assert!(root(|x| Some(1.0 + x * x), (-1.0, 2.0), (1.0, 2.0), 1e-12).is_none());
        let (x, y) = maximum(|x| Some(3.0 - (x - 0.7).powi(2)), 0.0, 2.0, 1e-12).unwrap();
        assert!((x - 0.7).abs() < 1e-7 && (y - 3.0).abs() < 1e-14);
    }
}
